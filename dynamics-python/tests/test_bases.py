"""Poses of a base that moves: each has a rotation."""

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import moving_body


@pytest.fixture(scope="module")
def body() -> rd.Robot:
    return moving_body()


def rotation(x: float, y: float, z: float, w: float) -> np.ndarray:
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def posed(turn: np.ndarray) -> np.ndarray:
    pose = np.eye(4)
    pose[:3, :3] = turn
    return pose


QUATERNION = np.array([0.01, 0.13, -0.11, 0.99])

UNIT = QUATERNION / np.linalg.norm(QUATERNION)

NO_ROTATIONS = {
    "not of length 1": rotation(*QUATERNION),
    "a reflection": np.diag([1.0, 1.0, -1.0]),
    "twice one": 2 * np.eye(3),
    "zero": np.zeros((3, 3)),
    "a shear": np.array([[1, 1e-5, 0], [0, 1, 0], [0, 0, 1]]),
    "infinite": np.diag([np.inf, 1.0, 1.0]),
}


@pytest.mark.parametrize("turn", NO_ROTATIONS.values(), ids=NO_ROTATIONS.keys())
def test_a_base_has_a_rotation(body: rd.Robot, turn: np.ndarray) -> None:
    """In every function that takes its pose, at one state and at many, as in a simulation."""
    said = "the rotation of the base .*is none: .* orthogonal unit vectors to 1e-6, right-handed"
    with pytest.raises(ValueError, match=said):
        body.simulate([0.3], base=posed(turn))
    given = {"base": posed(turn), "q": [0.3], "v": np.zeros(7), "a": np.zeros(7), "tau": np.zeros(7)}
    functions = [getattr(body, name) for name in body.functions]
    functions = [of for of in functions if "base" in of.arguments]
    assert len(functions) > 3
    for function in functions:
        arguments = [given[name] for name in function.arguments]
        for call in (function, function.bound):
            with pytest.raises(ValueError, match=said):
                call(*arguments)
            with pytest.raises(ValueError, match=said):
                call(np.stack([np.eye(4), posed(turn)]), *arguments[1:])


def test_poses_are_those_of_single_calls(body: rd.Robot) -> None:
    """However they lie in memory, and whatever numbers they are; one pose may be that of many states."""
    random = np.random.default_rng(2)
    poses = np.stack([posed(np.linalg.qr(random.normal(size=(3, 3)))[0]) for _ in range(6)])
    poses[np.linalg.det(poses[:, :3, :3]) < 0, :3, :3] *= -1
    poses[:, :3, 3] = random.normal(size=(6, 3))
    q, v, a = random.normal(size=(3, 6, 7))
    expected = np.stack([body.inverse_dynamics(*state) for state in zip(poses, q[:, :1], v, a)])
    for given in (poses, np.asfortranarray(poses), poses.tolist(), np.repeat(poses, 2, axis=0)[::2]):
        np.testing.assert_allclose(body.inverse_dynamics(given, q[:, :1], v, a), expected, atol=1e-13)
    for given in (poses[3], poses[3].tolist(), np.asfortranarray(poses[3]), poses[3, None]):
        found = body.inverse_dynamics(given, q[:, None, :1], v, a)
        assert found.shape == (6, 6, 7)
        np.testing.assert_allclose(found[3, 3], expected[3], atol=1e-13)
        np.testing.assert_allclose(found[1, 2], body.inverse_dynamics(poses[3], q[1, :1], v[2], a[2]), atol=1e-13)
    for flat in (np.eye(4).ravel(), np.eye(4).ravel().tolist()):
        with pytest.raises(ValueError, match=r"`base` has the shape \(16,\): expected \(\.\.\., 4, 4\)"):
            body.gravity_vector(flat, [0.3])
    whole = np.eye(4, dtype=int)
    np.testing.assert_array_equal(body.gravity_vector(whole, [0.3]), body.gravity_vector(np.eye(4), [0.3]))
    single = [x.astype(np.float32) for x in (poses[0], q[0, :1], v[0], a[0])]
    found = body.inverse_dynamics(*single)
    assert found.dtype == np.float32
    # The rotation is rounded, too.
    np.testing.assert_allclose(found, expected[0], atol=1e-4)


def test_a_rotation_may_be_rounded(body: rd.Robot) -> None:
    pose = posed(rotation(*UNIT))
    exact = body.gravity_vector(pose, [0.3])
    found = body.gravity_vector(pose.astype(np.float32), np.float32([0.3]))
    np.testing.assert_allclose(found, exact, atol=1e-5)
    pose[:3, :3] *= 1 + 4e-7
    np.testing.assert_allclose(body.gravity_vector(pose, [0.3]), exact, atol=1e-4)
    # A pose that is unknown makes values that are.
    assert np.isnan(body.gravity_vector(np.full((4, 4), np.nan), [0.3])).any()
