"""Numeric inverse kinematics."""

import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import DATA, panda

KINEMATICS = ["forward_kinematics", "jacobian"]


@pytest.fixture(scope="module")
def reaching() -> rd.Robot:
    return panda(functions=KINEMATICS)


def test_poses_within_limits_are_reached(reaching: rd.Robot) -> None:
    low, high = reaching.joint_limits.T
    for q in np.random.default_rng(3).uniform(low, high, (20, 7)):
        pose = reaching.forward_kinematics(q)
        found = reaching.reach(pose, start=(low + high) / 2)
        np.testing.assert_allclose(reaching.forward_kinematics(found), pose, atol=3e-9)
        assert np.all((low <= found) & (found <= high))
        np.testing.assert_array_equal(found, reaching.reach(pose, start=(low + high) / 2))


def test_parts_of_a_pose(reaching: rd.Robot) -> None:
    q = reaching.joint_limits.mean(axis=1) + 0.2
    pose = reaching.forward_kinematics(q)
    place = reaching.forward_kinematics(reaching.reach(pose[:3, 3], q - 0.1))
    np.testing.assert_allclose(place[:3, 3], pose[:3, 3], atol=2e-9)
    turned = reaching.forward_kinematics(reaching.reach(pose[:3, :3], q - 0.1))
    np.testing.assert_allclose(turned[:3, :3], pose[:3, :3], atol=2e-9)
    pointing = reaching.forward_kinematics(reaching.reach([[0, 0, 1], [1, 2, 0]], q))
    np.testing.assert_allclose(pointing[:3, 2], np.array([1, 2, 0]) / 5**0.5, atol=2e-9)
    near = reaching.reach(pose, q, posture=q + 0.1)
    assert np.linalg.norm(near - q - 0.1) < np.linalg.norm(np.full(7, 0.1))


def test_all_solutions_of_a_puma() -> None:
    puma = rd.Robot.from_file(DATA / "robots" / "puma560.json", functions=KINEMATICS)
    q = np.array([0.3, -1.0, 0.7, 0.2, 0.5, -0.4])
    found = puma.reach_all(puma.forward_kinematics(q), q)
    assert len(found) == 8
    np.testing.assert_allclose(found[0], q, atol=1e-9)


def test_frames_of_a_tree() -> None:
    functions = [f"{name}({hand})" for name in KINEMATICS for hand in ("left_hand", "camera")]
    torso = rd.Robot.from_file(DATA / "files" / "torso.toml", functions=functions, fields={"load": 1})
    q = np.linspace(0.1, 0.4, torso.dof)
    hands = ["left_hand", "camera"]
    poses = [getattr(torso, f"forward_kinematics_{hand}")(q) for hand in hands]
    found = torso.reach(poses, frame=hands)
    for hand, pose in zip(hands, poses):
        reached = getattr(torso, f"forward_kinematics_{hand}")(found)
        np.testing.assert_allclose(reached, pose, atol=3e-9)


def test_why_nothing_is_found(reaching: rd.Robot) -> None:
    with pytest.raises(rd.NotReached, match="target 1 is .* m from the base") as raised:
        reaching.reach([3, 0, 0])
    tip = reaching.forward_kinematics(raised.value.q)[:3, 3]
    assert raised.value.position == pytest.approx(np.linalg.norm(tip - [3, 0, 0]))
    with pytest.raises(ValueError, match="target 1 is none"):
        reaching.reach([np.nan, 0, 0])
    pose = reaching.forward_kinematics(raised.value.q)
    with pytest.raises(ValueError, match="its last row is .*transposed"):
        reaching.reach(pose.T)
    with pytest.raises(ValueError, match=r"its last row is \[0.0, 0.0, 0.0, 0.0\]$"):
        reaching.reach(np.vstack([pose[:3], np.zeros(4)]))
    with pytest.raises(rd.NotReached, match="target 1 is 1.000e300 m from the base, .* 1.000e300 m"):
        reaching.reach([1e300, 0, 0])
    with pytest.raises(ValueError, match="shape"):
        reaching.reach([1, 2])
    with pytest.raises(ValueError, match="frames and targets are as many: found 2 and 1"):
        reaching.reach([[0.5, 0, 0.5]], frame=["left", "right"])
    with pytest.raises(TypeError, match="`attempts` is -1: .*negative"):
        reaching.reach([0.5, 0, 0.5], attempts=-1)
    with pytest.raises(ValueError, match="no frame was given"):
        reaching.reach([], frame=[])
    with pytest.raises(ValueError, match="`start` has the shape"):
        reaching.reach([0.5, 0, 0.5], [0, 0])
    with pytest.raises(ValueError, match=r"no frame `panda_hand`: .*a link .* \"jacobian\(panda_hand\)\""):
        reaching.reach([0.5, 0, 0.5], frame="panda_hand")
    hand = panda(functions=["jacobian(panda_hand)"])
    with pytest.raises(ValueError, match="no frame `panda_hnad`: did you mean `panda_hand`"):
        hand.reach([0.5, 0, 0.5], frame="panda_hnad")
    with pytest.raises(ValueError, match=r"needs .*\"forward_kinematics\(panda_hand\)\""):
        hand.reach([0.5, 0, 0.5], frame="panda_hand")


def test_one_frame_may_have_two_targets() -> None:
    puma = rd.Robot.from_file(
        DATA / "robots" / "puma560.json",
        functions=[f"{name}(pen)" for name in KINEMATICS],
        frames={"pen": {"on": "joint6", "xyz": [0, 0, 0.1]}},
    )
    q = puma.reach([[0.4, 0.1, 0.2], [[0, 0, 1], [0, 0, -1]]], frame=["pen", "pen"])
    pose = puma.forward_kinematics_pen(q)
    np.testing.assert_allclose(pose[:3, 2:].T, [[0, 0, -1], [0.4, 0.1, 0.2]], atol=1e-8)


def test_what_is_derived_is_kept(reaching: rd.Robot) -> None:
    """Threads that begin at once find the same, as do the same robot unpickled and one with other values of its fields."""
    pose = reaching.forward_kinematics(reaching.joint_limits.mean(axis=1))
    fresh = pickle.loads(pickle.dumps(reaching))
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: fresh.reach(pose), range(8)))
    for q in found:
        np.testing.assert_array_equal(q, reaching.reach(pose))
    text = """
        convention = "modified"
        gravity = [0, -9.81, 0]
        tool = { xyz = ["length", 0, 0] }
        [[joint]]
        name = "shoulder"
        type = "revolute"
    """
    crank = rd.Robot.from_toml(text, functions=KINEMATICS, fields={"length": 2.0})
    for length in 2.0, 3.0, 2.0:
        q = crank.with_fields(length=length).reach([0, length, 0])
        assert q[0] == pytest.approx(np.pi / 2)
    with pytest.raises(rd.NotReached):
        crank.reach([0, 3, 0])


def test_what_has_no_inverse_kinematics_is_told() -> None:
    base = {"floating": True, "mass": 3, "inertia": {"xx": 0.1, "yy": 0.2, "zz": 0.25}}
    flying = rd.Robot.from_toml("gravity = [0, 0, -9.81]", base=base)
    with pytest.raises(ValueError, match="`reach` is of a robot whose base stands: this one moves"):
        flying.reach(np.eye(4))
    tree = rd.Robot.from_file(DATA / "files" / "kinds" / "tree.toml", functions="jacobian(hand)")
    with pytest.raises(ValueError, match="no tip, but several ends: name a frame instead, there are hand, Camera 2"):
        tree.reach(np.eye(4))


def test_one_function_may_stand_alone() -> None:
    tree = rd.Robot.from_file(DATA / "files" / "kinds" / "tree.toml", functions="mass_matrix")
    assert tree.functions == ["mass_matrix"]
    assert "tree.py" in tree.source("python", "mass_matrix")


def test_many_poses(reaching: rd.Robot) -> None:
    low, high = reaching.joint_limits.T
    middle = (low + high) / 2
    q = np.random.default_rng(4).uniform(0.8 * low + 0.2 * middle, 0.8 * high + 0.2 * middle, (3, 2, 7))
    poses = reaching.forward_kinematics(q)
    found = reaching.reach(poses, middle)
    assert found.shape == (3, 2, 7)
    np.testing.assert_allclose(reaching.forward_kinematics(found), poses, atol=3e-9)
    np.testing.assert_array_equal(found[2, 1], reaching.reach(poses[2, 1], middle))
    # Starts are broadcast with poses.
    near = reaching.reach(poses, q)
    np.testing.assert_allclose(near, q, atol=1e-6)
    assert reaching.reach(poses[0, 0], q[:, 0]).shape == (3, 7)
    assert reaching.reach(np.zeros((0, 4, 4)), middle).shape == (0, 7)
    poses[1, 0, :3, 3] = 5, 0, 0
    with pytest.raises(rd.NotReached, match=r"^pose \[1, 0\]: ") as raised:
        reaching.reach(poses, middle)
    assert raised.value.index == (1, 0)
    found = reaching.reach(poses, middle, on_missed="nan")
    missed = np.isnan(found).all(axis=-1)
    assert missed[1, 0] and missed.sum() == 1
    with pytest.raises(ValueError, match="`on_missed` is 'zero'"):
        reaching.reach(poses, middle, on_missed="zero")
    with pytest.raises(ValueError, match=r"has the leading axes \(3, 2\): expected one pose"):
        reaching.reach_all(poses)
    again = pickle.loads(pickle.dumps(raised.value))
    assert again.index == (1, 0) and again.reason == raised.value.reason


def test_a_position_with_a_direction(reaching: rd.Robot) -> None:
    q = reaching.joint_limits.mean(axis=1) + 0.2
    target = rd.Target(position=[0.4, 0.1, 0.3], axis=[0, 0, 2], direction=[0, 0.3, -1])
    pose = reaching.forward_kinematics(reaching.reach(target, q))
    np.testing.assert_allclose(pose[:3, 3], target.position, atol=2e-9)
    np.testing.assert_allclose(pose[:3, 2], np.array([0, 0.3, -1]) / 1.09**0.5, atol=2e-9)
    assert len(reaching.reach_all(target, q, most=3)) >= 2
    goal = reaching.forward_kinematics(q + 0.1)
    found = reaching.reach(rd.Target(position=goal[:3, 3], rotation=goal[:3, :3]), q)
    np.testing.assert_array_equal(found, reaching.reach(goal, q))
    np.testing.assert_array_equal(reaching.reach(rd.Target(position=goal[:3, 3]), q), reaching.reach(goal[:3, 3], q))
    for wrong in (
        rd.Target(),
        rd.Target(position=[0, 0, 1], axis=[0, 0, 1]),
        rd.Target(rotation=np.eye(3), axis=[0, 0, 1], direction=[0, 0, 1]),
    ):
        with pytest.raises(ValueError, match="a target has"):
            reaching.reach(wrong, q)


def test_weights_say_what_counts_where_not_all_is_reached(reaching: rd.Robot) -> None:
    far = np.diag([1.0, -1.0, -1.0, 1.0])
    far[:3, 3] = 0.8, 0, 0.5

    def missing(*weights: float) -> tuple[float, float]:
        target = rd.Target(position=far[:3, 3], rotation=far[:3, :3], weights=weights)
        with pytest.raises(rd.NotReached) as raised:
            reaching.reach(target, attempts=20)
        return raised.value.position, raised.value.rotation

    place, turn = missing(100.0, 1.0), missing(1.0, 100.0)
    assert place[0] < turn[0] and turn[1] < place[1]
    with pytest.raises(ValueError, match="target 1"):
        reaching.reach(rd.Target(position=[0.5, 0, 0.5], weights=(0.0, 1.0)))
