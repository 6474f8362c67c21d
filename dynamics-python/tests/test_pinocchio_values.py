"""Values of Pinocchio that stand beside the files of robots."""

import json

import numpy as np

import robot_dynamics as rd
from conftest import DATA


def test_torques_of_the_panda_are_those_of_pinocchio(arm: rd.Robot) -> None:
    states = json.loads((DATA / "urdf" / "panda.json").read_text())["states"]
    for state in states:
        q, qd, qdd = (np.array(state[name]) for name in ("q", "qd", "qdd"))
        # Pinocchio's torques have no friction.
        tau = arm.inverse_dynamics(q, qd, qdd) - arm.friction_vector(qd)
        np.testing.assert_allclose(tau, state["tau"], rtol=0, atol=1e-12)
