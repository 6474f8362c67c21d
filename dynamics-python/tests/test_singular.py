"""States at which nothing resists a joint."""

import numpy as np
import pytest

import robot_dynamics as rd

TABLE = """
convention = "modified"
gravity = [0, 0, -9.81]
[[joint]]
name = "turn"
type = "revolute"
[[joint]]
name = "slide"
type = "prismatic"
alpha = "PI/2"
mass = 2
"""
"""A point mass that slides through the axis about which it turns."""


@pytest.fixture(scope="module")
def arm() -> rd.Robot:
    return rd.Robot.from_toml(TABLE)


def test_one_state(arm: rd.Robot) -> None:
    with pytest.raises(rd.SingularMassMatrix, match="joint 'turn'") as raised:
        arm.forward_dynamics(np.zeros(2), np.zeros(2), np.zeros(2))
    assert raised.value.index == () and raised.value.joint == "turn"
    qdd = arm.forward_dynamics(np.zeros(2), np.zeros(2), np.zeros(2), on_singular="nan")
    assert np.isnan(qdd).all()


@pytest.mark.parametrize("threads", [1, 3])
def test_the_first_of_many_states(arm: rd.Robot, threads: int) -> None:
    q = np.ones((3, 100, 2))
    q[1, 42] = q[2, 7] = 0
    with pytest.raises(rd.SingularMassMatrix, match=r"state \[1, 42\]") as raised:
        arm.forward_dynamics(q, q, q, threads=threads)
    assert raised.value.index == (1, 42) and raised.value.joint == "turn"
    qdd = arm.forward_dynamics(q, q, q, threads=threads, on_singular="nan")
    is_nan = np.isnan(qdd).all(-1)
    assert is_nan[1, 42] and is_nan[2, 7] and is_nan.sum() == 2
    regular = arm.forward_dynamics(q[0], q[0], q[0])
    np.testing.assert_array_equal(qdd[0], regular)


def test_the_error_is_pickled(arm: rd.Robot) -> None:
    import pickle

    error = rd.SingularMassMatrix((1, 2), "turn", "singular")
    copy = pickle.loads(pickle.dumps(error))
    assert (copy.index, copy.joint, str(copy)) == (error.index, error.joint, str(error))


@pytest.mark.parametrize("threads", [1, 2, 9])
def test_the_first_of_all_is_told_on_many_threads(arm: rd.Robot, threads: int) -> None:
    q, rest = np.ones((1000, 2)), np.zeros((1000, 2))
    q[[300, 301, 700, 990]] = 0
    for _ in range(20):
        with pytest.raises(rd.SingularMassMatrix) as raised:
            arm.forward_dynamics(q, rest, rest, threads=threads)
        assert raised.value.index == (300,)
    qdd = arm.forward_dynamics(q, rest, rest, threads=threads, on_singular="nan")
    np.testing.assert_array_equal(np.isnan(qdd).any(axis=1).nonzero()[0], [300, 301, 700, 990])
