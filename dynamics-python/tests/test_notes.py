"""Warnings about angles of a file, and the guide's comparison with Pinocchio for files that cause them."""

import re
import warnings
from pathlib import Path

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import DATA, GRAVITY

ARM = DATA / "files/nearly_right_angles.urdf"

GUIDE = Path(__file__).parents[2] / "docs/guide/src/own_urdf.md"


def messages(**entries: object) -> list[str]:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        path = entries.pop("path", ARM)
        rd.Robot.from_file(path, gravity=GRAVITY, **entries)
    # They point at the call of the package, in this file.
    assert all(one.category is UserWarning and one.filename == __file__ for one in caught)
    return [str(one.message) for one in caught]


def test_quarter_turns_of_some_digits_are_told() -> None:
    ur5 = DATA / "urdf/ur5_robot.urdf"
    (told,) = messages(path=ur5)
    assert told.startswith("5 angles, such as 1.57079632679, are taken as the multiples of a quarter turn")
    assert "`round_angles=1e-9` says that this is meant" in told
    assert messages(path=ur5, round_angles=1e-9) == []
    assert messages(path=DATA / "urdf/panda.urdf") == []


def test_a_table_is_told_as_well() -> None:
    joint = {"name": "one", "type": "revolute", "alpha": 1.570796327, "mass": 1, "com": [0.1, 0, 0]}
    with pytest.warns(UserWarning, match="One angle, 1.570796327, is taken"):
        rd.Robot.from_table(convention="modified", gravity=GRAVITY, joint=[joint])


def test_a_warning_may_be_an_error() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(UserWarning, match="quarter turn"):
            rd.Robot.from_file(DATA / "urdf/ur5_robot.urdf", gravity=GRAVITY)


@pytest.mark.parametrize("function", ["regressor", "base_parameters"])
def test_angles_that_split_base_parameters_are_told(function: str) -> None:
    (told,) = messages(functions=[function])
    assert "hardly tell 2 of the 24 base parameters apart" in told
    assert "3.1416 at `a`. " in told and "`round_angles=1e-5` leaves 22 base parameters" in told
    assert messages(functions=["inverse_dynamics"]) == []
    assert messages(functions=[function], round_angles=1e-5) == []


def test_what_is_told_is_so() -> None:
    """The condition of the regressor, with the angles that are named and without them."""
    q, qd, qdd = np.random.default_rng(0).uniform(-2, 2, (3, 200, 4))

    def condition(round_angles: float | None) -> float:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            arm = rd.Robot.from_file(ARM, gravity=GRAVITY, functions=["regressor"], round_angles=round_angles)
        regressor = arm.regressor(q, qd, qdd)
        return np.linalg.cond(regressor.reshape(-1, regressor.shape[-1]))

    assert condition(None) > 1e4 and condition(1e-5) < 1e3


@pytest.mark.parametrize("file", ["ur3", "ur5", "ur10", "anymal", "kinova", "finger_edu", "tiago_no_hand"])
def test_the_comparison_of_the_guide_runs(file: str, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pinocchio")
    found = re.findall(r"^```python\n(.*?)^```", GUIDE.read_text(), flags=re.DOTALL | re.MULTILINE)
    (program,) = [program for program in found if "import pinocchio" in program]
    monkeypatch.chdir(DATA / "urdf")
    (path,) = [path for path in Path().glob("*.urdf") if path.stem.removesuffix("_robot") == file]
    program = program.replace("picker.urdf", path.name)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        exec(compile(program, f"{GUIDE.name} of {path}", "exec"), {})
