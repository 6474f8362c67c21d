"""Values of Pinocchio: those that stand beside the files of robots, and its own at many states."""

import json
import re

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import DATA, GRAVITY

URDF = DATA / "urdf"

STORED = sorted(path.stem for path in URDF.glob("*.json"))

LIVE = [
    "borinot",
    "double_pendulum",
    "finger_edu",
    "hextilt",
    "kinova",
    "panda",
    "so101",
    "two_dof",
    "ur3",
    "ur5",
    "ur10",
    "xarm7",
]
"""Files of which nothing is left out, and which Pinocchio reads as they are."""


def read(name: str) -> tuple[rd.Robot, dict]:
    beside = json.loads((URDF / f"{name}.json").read_text())
    arm = rd.Robot.from_file(
        URDF / beside["file"],
        chain=beside["chain"],
        ignore=beside["ignore"],
        lock=beside["lock"],
        gravity=GRAVITY,
        allow=["unphysical_inertia", "no_inertia"],
        functions=["default", "friction_vector", "jacobian", "forward_kinematics"],
    )
    assert arm.joint_names == beside["joints"]
    return arm, beside


def assert_close(value: np.ndarray, expected: np.ndarray) -> None:
    scale = max(1.0, np.abs(expected).max())
    np.testing.assert_allclose(value, expected, rtol=0, atol=1e-10 * scale)


@pytest.mark.parametrize("name", STORED)
def test_values_beside_files(name: str) -> None:
    arm, beside = read(name)
    states = {key: np.array([state[key] for state in beside["states"]]) for key in beside["states"][0]}
    q, qd, qdd = states["q"], states["qd"], states["qdd"]
    friction = arm.friction_vector(qd)
    assert_close(arm.mass_matrix(q), states["M"])
    assert_close(arm.inverse_dynamics(q, qd, qdd) - friction, states["tau"])
    assert_close(arm.forward_kinematics(q), states["pose"])
    assert_close(arm.jacobian(q), states["J"])


@pytest.mark.parametrize("name", LIVE)
def test_many_states_beside_pinocchio(name: str) -> None:
    pinocchio = pytest.importorskip("pinocchio")
    arm, beside = read(name)
    # Positions of joints without limits are numbers here, not points of a circle.
    text = (URDF / beside["file"]).read_text()
    text = re.sub(r'type="continuous"', 'type="revolute"', text)
    text = re.sub(r"<limit\b[^>]*/>", "", text)
    text = re.sub(
        r'(<joint\b[^>]*type="(?:revolute|prismatic)"[^>]*>)',
        r'\1<limit lower="-9" upper="9" effort="1" velocity="1"/>',
        text,
    )
    model = pinocchio.buildModelFromXML(text)
    still = [j for j in range(1, model.njoints) if model.names[j] not in beside["joints"]]
    positions = pinocchio.neutral(model)
    for j in still:
        positions[model.joints[j].idx_q] = beside["lock"][model.names[j]]
    model = pinocchio.buildReducedModel(model, still, positions)
    data = model.createData()
    order = [model.joints[model.getJointId(joint)].idx_v for joint in beside["joints"]]
    q, qd, qdd = np.random.default_rng(0).uniform(-2, 2, (3, 50, arm.dof))
    tau = arm.inverse_dynamics(q, qd, qdd) - arm.friction_vector(qd)
    for k in range(50):
        given = np.zeros((3, arm.dof))
        given[:, order] = q[k], qd[k], qdd[k]
        assert_close(tau[k], pinocchio.rnea(model, data, *given)[order])
