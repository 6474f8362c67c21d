"""Robots that several tests are about."""

from pathlib import Path

import pytest

import robot_dynamics as rd

DATA = Path(__file__).parents[2] / "tests" / "data"
"""Files of robots, and values of Pinocchio beside them."""

GRAVITY = (0, 0, -9.81)

PANDA_FINGERS = {"panda_finger_joint1": 0.02, "panda_finger_joint2": 0.035}


def panda(**entries: object) -> rd.Robot:
    """The Panda of a URDF file, to the frame of its hand."""
    return rd.Robot.from_file(
        DATA / "urdf" / "panda.urdf",
        chain=("panda_link0", "panda_hand_tcp"),
        gravity=GRAVITY,
        lock=PANDA_FINGERS,
        **entries,
    )


@pytest.fixture(scope="session")
def arm() -> rd.Robot:
    return panda()


def moving_body() -> rd.Robot:
    """A ball that moves, with a rod on it."""
    rod = {"name": "hip", "type": "revolute", "mass": 1, "com": [0.1, 0, 0], "inertia": "rod(0.2)"}
    ball = {"floating": True, "mass": 3, "inertia": "sphere(0.1)"}
    return rd.Robot.from_table(convention="modified", gravity=[0, 0, -9.81], base=ball, joint=[rod])
