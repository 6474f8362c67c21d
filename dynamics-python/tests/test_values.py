"""Values of Rust, which its own test holds to be so: bit for bit."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import DATA, moving_body

VALUES = json.loads((Path(__file__).parent / "values.json").read_text())

FILES = sorted({file for file, *_ in VALUES})


def flat(value: object) -> list[float]:
    """The entries of a value by rows."""
    if isinstance(value, tuple):
        return [entry for part in value for entry in flat(part)]
    return np.asarray(value).ravel().tolist()


@pytest.mark.parametrize("file", FILES)
def test_one_state(file: str) -> None:
    arm = rd.Robot.from_file(DATA / "files" / file, fields={"load": 0.3})
    names = [name for of, name, *_ in VALUES if of == file]
    assert set(names) == set(arm.functions)
    for of, name, arguments, value in VALUES:
        if of == file:
            found = getattr(arm, name)(*(np.array(argument) for argument in arguments))
            assert flat(found) == value, name


@pytest.mark.parametrize("file", FILES)
def test_many_states_are_fused_at_most(file: str) -> None:
    """The values of a batch differ by the rounding of sums of products."""
    arm = rd.Robot.from_file(DATA / "files" / file, fields={"load": 0.3})
    for name in arm.functions:
        lines = [line for line in VALUES if line[:2] == [file, name]]
        arguments = [np.array(rows) for rows in zip(*(line[2] for line in lines), strict=True)]
        found = getattr(arm, name)(*arguments)
        parts = found if isinstance(found, tuple) else (found,)
        rows = np.concatenate([part.reshape(len(lines), -1) for part in parts], axis=1)
        np.testing.assert_allclose(rows, [line[3] for line in lines], rtol=0, atol=1e-12)


def test_bounds_of_rounding(arm: rd.Robot) -> None:
    """Proven bounds of each function over the limits, in double and in single precision."""
    bounds = arm.bounds
    assert list(bounds) == list(arm.functions)
    double, single = bounds["gravity_vector"]
    assert 1e-14 < double < 1e-12 and 2**28 < single / double < 2**30
    lower, upper = np.asarray(arm.joint_limits).T
    q = np.random.default_rng(7).uniform(lower, upper, (1000, arm.dof)).astype(np.float32)
    exact = arm.gravity_vector(q.astype(np.float64))
    assert np.abs(arm.gravity_vector(q) - exact).max() < single
    # Nothing has limits.
    assert set(moving_body().bounds.values()) == {(math.inf, math.inf)}
