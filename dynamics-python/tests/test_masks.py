"""Masks of arrays, which functions of robots do not know."""

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import moving_body


@pytest.fixture(scope="module")
def swing() -> rd.Robot:
    rod = {"name": "pivot", "type": "revolute", "mass": 1, "com": [0.5, 0, 0]}
    functions = ["default", "forward_kinematics", "jacobian", "regressor"]
    return rd.Robot.from_table(convention="modified", gravity=[9.81, 0, 0], joint=[rod], functions=functions)


def masked(*shape: int) -> np.ma.MaskedArray:
    mask = np.zeros(shape, dtype=bool)
    mask.flat[-1] = True
    return np.ma.masked_array(np.zeros(shape), mask)


LOST = r"`q` has a mask, .* `q.filled\(np.nan\)`"


@pytest.mark.parametrize("q", [masked(7), masked(5, 7), masked(7).astype("f4"), [masked(7)] * 2, ([masked(7)],)])
def test_masks_are_refused(arm: rd.Robot, q: object) -> None:
    for function in (arm.gravity_vector, arm.gravity_vector.bound):
        with pytest.raises(TypeError, match=LOST):
            function(q)
    with pytest.raises(TypeError, match=LOST):
        arm.gravity_vector(q=q)


def test_masks_that_mask_nothing_are_none(arm: rd.Robot) -> None:
    q = np.ma.masked_array(np.zeros(7), np.zeros(7, dtype=bool))
    for array in (q, np.ma.masked_array(np.zeros(7)), masked(7).filled(0)):
        np.testing.assert_array_equal(arm.gravity_vector(array), arm.gravity_vector(np.zeros(7)))
    with pytest.raises(TypeError, match="`out` has a mask"):
        arm.gravity_vector(np.zeros(7), out=masked(7))
    assert np.isnan(arm.gravity_vector(masked(7).filled(np.nan))).any()
    with pytest.warns(UserWarning, match="masked element to nan"):
        assert np.isnan(arm.gravity_vector([np.ma.masked] * 7)).any()


def test_masks_are_refused_wherever_numbers_are_taken(swing: rd.Robot) -> None:
    q, pose = masked(1), masked(4, 4)
    for name, call in {
        "q": lambda: swing.simulate(q),
        "qd": lambda: swing.simulate([0.0], q),
        "torque": lambda: swing.simulate([0.0], torque=q),
        "base": lambda: moving_body().simulate([0.0], base=pose),
        "target": lambda: swing.reach(pose),
        "start": lambda: swing.reach([1, 0, 0], q),
        "posture": lambda: swing.reach([1, 0, 0], posture=q),
        "base_parameters": lambda: swing.identified(masked(3)),
        "friction": lambda: swing.identified([1, 1, 1], masked(1, 3)),
    }.items():
        with pytest.raises(TypeError, match=f"`{name}` has a mask"):
            call()
    with pytest.raises(TypeError, match="`torque` has a mask"):
        swing.simulate([0.0], torque=lambda t, q, qd: masked(1))
    with pytest.raises(TypeError, match="`base_parameters` has a mask"):
        swing.nearest_possible(masked(3))
