"""Inverse kinematics in closed form."""

from __future__ import annotations

import math
import struct
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import robot_dynamics as rd

PUMA = """
convention = "standard"
gravity = [0, 0, -9.81]
joint = [
    { name = "q1", type = "revolute", d = 0.67183, alpha = "PI/2" },
    { name = "q2", type = "revolute", a = 0.4318 },
    { name = "q3", type = "revolute", a = 0.0203, d = 0.15005, alpha = "-PI/2" },
    { name = "q4", type = "revolute", d = 0.4318, alpha = "PI/2" },
    { name = "q5", type = "revolute", alpha = "-PI/2" },
    { name = "q6", type = "revolute" },
]
"""
IIWA = """
convention = "standard"
gravity = [0, 0, -9.81]
joint = [
    { name = "q1", type = "revolute", d = 0.36, alpha = "-PI/2" },
    { name = "q2", type = "revolute", alpha = "PI/2" },
    { name = "q3", type = "revolute", d = 0.42, alpha = "PI/2" },
    { name = "q4", type = "revolute", alpha = "-PI/2" },
    { name = "q5", type = "revolute", d = 0.4, alpha = "-PI/2" },
    { name = "q6", type = "revolute", alpha = "PI/2" },
    { name = "q7", type = "revolute", d = 0.126 },
]
"""
Q = np.array([0.4, -0.9, 0.7, 0.5, 1.1, -0.3])


@pytest.fixture(scope="module")
def puma() -> rd.Robot:
    return rd.Robot.from_toml(PUMA, functions=["forward_kinematics", "inverse_kinematics"])


@pytest.fixture(scope="module")
def iiwa() -> rd.Robot:
    return rd.Robot.from_toml(IIWA, functions=["forward_kinematics"])


def test_every_branch_is_found(puma: rd.Robot) -> None:
    pose = puma.forward_kinematics(Q)
    solutions = puma.inverse_kinematics(pose)
    assert solutions.shape == (8, 6) and solutions.reason is None
    assert len(set(solutions.branches)) == 8
    assert all(branch.split(", ")[2].startswith("wrist ") for branch in solutions.branches)
    assert not solutions.is_singular.any()
    for q in solutions:
        np.testing.assert_allclose(puma.forward_kinematics(q), pose, atol=1e-14)
    assert np.abs(solutions - Q).max(axis=1).min() < 1e-12
    ordered = puma.inverse_kinematics(pose, start=Q)
    np.testing.assert_allclose(ordered[0], Q, atol=1e-12)
    assert sorted(ordered.branches) == sorted(solutions.branches)
    # What is computed of it is an array.
    assert (2 * solutions).branches == []


def test_many_poses_are_solved_one_by_one(puma: rd.Robot) -> None:
    random = np.random.default_rng(1)
    q = random.uniform(-3, 3, (3, 5, 6))
    poses = puma.forward_kinematics(q)
    found = puma.inverse_kinematics(poses)
    assert [len(row) for row in found] == [5, 5, 5]
    for row, poses_of_row in zip(found, poses):
        for one, pose in zip(row, poses_of_row):
            np.testing.assert_array_equal(one, puma.inverse_kinematics(pose))
    flat = puma.inverse_kinematics(poses[0])
    assert isinstance(flat, list) and len(flat) == 5


def test_solutions_are_chosen(puma: rd.Robot) -> None:
    pose = puma.forward_kinematics([3.3, -0.9, 0.7, 0.5, 1.1, -0.3])
    solutions = puma.inverse_kinematics(pose)
    limits = np.array([[0, 2 * math.pi], [-2, 2], [-np.inf, np.inf], [-np.inf, np.inf], [0, 2], [-np.inf, np.inf]])
    within = solutions.within(limits)
    assert 0 < len(within) < 8 and len(within.branches) == len(within)
    seed = np.array([3.35, -0.85, 0.75, 0.55, 1.15, -0.25])
    nearest = within.nearest(seed)
    assert nearest is not None
    np.testing.assert_allclose(nearest, seed - 0.05, atol=1e-12)
    np.testing.assert_allclose(solutions.follow(seed, 0.1)[1:], nearest[1:], atol=1e-12)
    with pytest.raises(rd.BranchEnds, match="joint 1 moves by 0.050, more than 0.010") as ends:
        within.follow(seed, 0.01)
    assert ends.value.joint == 0
    assert solutions.within(puma.joint_limits).shape == (8, 6)
    with pytest.raises(ValueError, match="expected \\(6, 2\\)"):
        solutions.within(np.zeros((5, 2)))


def test_poses_without_solutions_say_why(puma: rd.Robot) -> None:
    pose = puma.forward_kinematics(Q)
    far = pose.copy()
    far[0, 3] += 3
    assert puma.inverse_kinematics(far).reason == "out of reach"
    assert puma.inverse_kinematics(far).shape == (0, 6)
    assert puma.inverse_kinematics(2 * pose).reason == "not a pose"
    assert puma.inverse_kinematics(far).nearest(Q) is None
    with pytest.raises(rd.BranchEnds, match="there is no solution"):
        puma.inverse_kinematics(far).follow(Q, 1)
    with pytest.raises(ValueError, match="expected \\(..., 4, 4\\)"):
        puma.inverse_kinematics(pose[:3])


def test_seven_joints_have_an_elbow(iiwa: rd.Robot, puma: rd.Robot) -> None:
    q = np.array([0.4, -0.9, 0.7, 0.8, 1.1, -0.6, 0.2])
    pose = iiwa.forward_kinematics(q)
    elbow = iiwa.elbow_angle(q)
    solutions = iiwa.inverse_kinematics(pose, elbow)
    assert np.abs(solutions - q).max(axis=1).min() < 1e-12
    np.testing.assert_allclose(iiwa.inverse_kinematics(pose, start=q)[0], q, atol=1e-12)
    for other in iiwa.inverse_kinematics(np.stack([pose, pose]), [elbow, elbow + 0.5])[1]:
        assert abs(iiwa.elbow_angle(other) - elbow - 0.5) < 1e-12
    with pytest.raises(ValueError, match="give `elbow`"):
        iiwa.inverse_kinematics(pose)
    with pytest.raises(ValueError, match="`elbow` is of seven joints"):
        puma.inverse_kinematics(np.eye(4), 0.1)
    with pytest.raises(ValueError, match="of seven joints"):
        puma.elbow_angle(Q)


def test_lines_are_followed(iiwa: rd.Robot) -> None:
    q = np.array([0.4, 0.9, 0.7, 0.8, 1.1, 0.6, 0.2])
    last = q
    pose = iiwa.forward_kinematics(q)
    for step in range(100):
        pose[2, 3] -= 0.001
        last = iiwa.inverse_kinematics(pose, iiwa.elbow_angle(last)).follow(last, 0.02)
    assert 0.01 < np.abs(last - q).max() < 1


def test_fields_need_values() -> None:
    table = PUMA.replace("a = 0.4318", 'a = "reach"')
    arm = rd.Robot.from_toml(table, functions=["forward_kinematics"])
    with pytest.raises(ValueError, match="field `reach` has no value"):
        arm.inverse_kinematics(np.eye(4))
    long = arm.with_fields(reach=0.5)
    found = long.inverse_kinematics(long.forward_kinematics(Q))
    assert np.abs(found - Q).max(axis=1).min() < 1e-12


def test_arms_without_a_closed_form_say_why(puma: rd.Robot) -> None:
    # A step between two axes of the wrist.
    table = PUMA.replace('alpha = "-PI/2" },\n    { name = "q6"', 'a = 0.01, alpha = "-PI/2" },\n    { name = "q6"')
    bent = rd.Robot.from_toml(table, functions=["forward_kinematics"])
    with pytest.raises(ValueError, match="no `inverse_kinematics` in closed form, because neither the first three"):
        bent.inverse_kinematics(np.eye(4))
    with pytest.raises(ValueError, match="there is no frame `nowhere`"):
        puma.inverse_kinematics(np.eye(4), frame="nowhere")


DIGITS = Path(__file__).parents[2] / "tests" / "data" / "closed_form_digits.txt"
WORDS = 2**64


@cache
def text_of(branch: str) -> int:
    word = 0
    for byte in branch.encode():
        word = (31 * word + byte) % WORDS
    return word


class Hash:
    """A hash of numbers, by their bits, and the numbers from -1 to 1 of the poses, as in `tests/inverse/languages.rs`."""

    def __init__(self) -> None:
        self.word, self.state = 14_695_981_039_346_656_037, 41

    def add(self, word: int) -> None:
        self.word = ((self.word ^ word) * 1_099_511_628_211) % WORDS

    def add_numbers(self, numbers: list[float]) -> None:
        for bits in struct.unpack(f"<{len(numbers)}Q", struct.pack(f"<{len(numbers)}d", *numbers)):
            self.add(bits)

    def add_all(self, solutions: rd.Solutions) -> None:
        self.add(len(solutions))
        for q, is_singular, branch in zip(solutions.tolist(), solutions.is_singular, solutions.branches):
            self.add_numbers(q)
            self.add(int(is_singular))
            self.add(text_of(branch))

    def joints(self, n: int) -> list[float]:
        return [3.1 * self.next() for _ in range(n)]

    def next(self) -> float:
        self.state = (self.state * 6_364_136_223_846_793_005 + 1_442_695_040_888_963_407) % WORDS
        return (self.state >> 11) / 2**52 - 1.0


@pytest.mark.parametrize("block", DIGITS.read_text().strip().split("\n\n"), ids=lambda block: str(block.split()[1]))
def test_solutions_have_the_digits_of_rust(block: str) -> None:
    digits, table = block.split("\n", 1)
    arm = rd.Robot.from_toml(table, functions=["forward_kinematics"])
    n, found = len(arm.joint_names), Hash()
    limits = [[(-math.inf, math.inf), (-7.0, 0.5), (-2.0, 2.5)][i % 3] for i in range(n)]
    for k in range(2_000):
        q = found.joints(n)
        if k % 8 == 4:
            q = [math.pi / 2 * round(x / (math.pi / 2)) for x in q]
        if k % 8 == 5:
            q[n - 2] = 0.0
        pose = arm.forward_kinematics(np.array(q))
        if k % 64 == 3:
            pose[0, 3] = math.nan
        if k % 64 == 11:
            pose = pose.T.copy()
        if k % 8 == 6:
            pose[:3, 3] *= 3.0
        if k % 8 == 7:
            pose = np.floor(pose * 1e4) / 1e4
        elbow, seed = 3.0 * found.next(), np.array(found.joints(n))
        solutions = arm.inverse_kinematics(pose, elbow=elbow if n == 7 else None)
        found.add_all(solutions)
        found.add({None: 0, "out of reach": 1, "not a pose": 2}[solutions.reason])
        within = solutions.within(limits)
        found.add_all(within)
        nearest = within.nearest(seed)
        if nearest is not None:
            found.add_numbers(nearest.tolist())
        try:
            found.add_numbers(solutions.follow(seed, 2.5).tolist()[:1])
        except rd.BranchEnds as ends:
            found.add(9 if ends.joint is None else ends.joint)
            if ends.joint is not None:
                found.add_numbers([ends.way])
        if n == 7:
            found.add_numbers([float(arm.elbow_angle(np.array(q)))])
    assert f"{found.word:016x}" == digits.split()[0]
