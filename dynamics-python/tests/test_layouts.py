"""Layouts of other libraries, for robots on a base that moves."""

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import DATA, GRAVITY

RANDOM = np.random.default_rng(5)

JOINTS = ["hip", "knee", "ankle"]

THEIRS = ["ankle", "hip", "knee"]

LAYOUTS = [rd.layouts.Pinocchio, rd.layouts.MuJoCo, rd.layouts.Drake, rd.layouts.Rbdl]


def poses(*lead: int) -> np.ndarray:
    turns = np.linalg.qr(RANDOM.normal(size=(*lead, 3, 3)))[0]
    turns[np.linalg.det(turns) < 0] *= -1
    poses = np.zeros((*lead, 4, 4))
    poses[..., :3, :3], poses[..., :3, 3], poses[..., 3, 3] = turns, RANDOM.normal(size=(*lead, 3)), 1
    return poses


@pytest.mark.parametrize("library", LAYOUTS)
def test_there_and_back(library: type[rd.layouts.Layout]) -> None:
    layout = library(JOINTS, THEIRS)
    base, q = poses(50), RANDOM.normal(size=(50, 3))
    v, a, f = RANDOM.normal(size=(3, 50, 9))
    M, J = RANDOM.normal(size=(50, 9, 9)), RANDOM.normal(size=(50, 6, 9))
    for found, expected in zip(layout.from_position(layout.position(base, q)), (base, q)):
        np.testing.assert_allclose(found, expected, atol=1e-14)
    for there, back, values in [
        (layout.velocity(base, v), layout.from_velocity, v),
        (layout.force(base, f), layout.from_force, f),
        (layout.mass_matrix(base, M), layout.from_mass_matrix, M),
        (layout.jacobian(base, J), layout.from_jacobian, J),
    ]:
        np.testing.assert_allclose(back(base, there), values, atol=1e-14)
    there = layout.acceleration(base, v, a)
    np.testing.assert_allclose(layout.from_acceleration(base, v, there), a, atol=1e-14)
    # Power and energy are the same.
    power = np.einsum("ki,ki->k", layout.velocity(base, v), layout.force(base, f))
    np.testing.assert_allclose(power, np.einsum("ki,ki->k", v, f), atol=1e-13)
    speed = layout.velocity(base, v)
    energy = np.einsum("ki,kij,kj->k", speed, layout.mass_matrix(base, M), speed)
    np.testing.assert_allclose(energy, np.einsum("ki,kij,kj->k", v, M, v), atol=1e-12)


def test_leading_axes_are_broadcast() -> None:
    layout = rd.layouts.Drake(JOINTS)
    base, v = poses(4, 1), RANDOM.normal(size=(3, 9))
    there = layout.velocity(base, v)
    assert there.shape == (4, 3, 9)
    np.testing.assert_allclose(there[2, 1], layout.velocity(base[2, 0], v[1]), atol=1e-15)
    np.testing.assert_allclose(there[2, 1, 3:6], base[2, 0, :3, :3] @ v[1, :3], atol=1e-15)
    assert layout.position(base, np.zeros(3)).shape == (4, 1, 10)


def test_places_of_quaternions() -> None:
    base = np.eye(4)
    base[:3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    base[:3, 3] = 1, 2, 3
    h, q = 0.5**0.5, [7, 8, 9]
    for library, expected in zip(
        LAYOUTS,
        (
            [1, 2, 3, 0, 0, h, h, 9, 7, 8],
            [1, 2, 3, h, 0, 0, h, 9, 7, 8],
            [h, 0, 0, h, 1, 2, 3, 9, 7, 8],
            [1, 2, 3, 0, 0, h, 9, 7, 8, h],
        ),
    ):
        found = library(JOINTS, THEIRS).position(base, q)
        np.testing.assert_allclose(found, expected, atol=1e-15)
    half = np.diag([-1.0, 1.0, -1.0, 1.0])  # Half a turn about y: w is zero.
    np.testing.assert_allclose(rd.layouts.MuJoCo([]).position(half, [])[3:], [0, 0, 1, 0], atol=1e-15)


@pytest.mark.parametrize("library", LAYOUTS)
def test_accelerations_are_rates_of_velocities(library: type[rd.layouts.Layout]) -> None:
    layout = library(JOINTS)
    base, v, a = poses(), *RANDOM.normal(size=(2, 9))
    w, h = v[3:6], 1e-6

    def moved(t: float) -> np.ndarray:
        x, y, z = w * t
        after = base.copy()
        after[:3, :3] = base[:3, :3] @ (np.eye(3) + [[0, -z, y], [z, 0, -x], [-y, x, 0]])
        return layout.velocity(after, v + t * a)

    rate = (moved(h) - moved(-h)) / (2 * h)
    # Angular velocities keep their own axis: their rate turns with the base where they are in the axes of the world.
    np.testing.assert_allclose(layout.acceleration(base, v, a), rate, atol=1e-8)


def test_beside_pinocchio() -> None:
    pinocchio = pytest.importorskip("pinocchio")
    path = DATA / "urdf" / "laikago.urdf"
    dog = rd.Robot.from_file(path, base="floating", gravity=GRAVITY, allow=["no_inertia"])
    model = pinocchio.buildModelFromUrdf(str(path), pinocchio.JointModelFreeFlyer())
    data = model.createData()
    layout = rd.layouts.Pinocchio(dog.joint_names, list(model.names)[2:])
    base, q = poses(), RANDOM.normal(size=12)
    v, a = RANDOM.normal(size=(2, 18))
    theirs = [layout.position(base, q), layout.velocity(base, v), layout.acceleration(base, v, a)]
    tau = pinocchio.rnea(model, data, *theirs)
    np.testing.assert_allclose(layout.force(base, dog.inverse_dynamics(base, q, v, a)), tau, atol=1e-10)


def test_names_and_shapes_are_told() -> None:
    with pytest.raises(ValueError, match="joint `knee` is not among the names of the library"):
        rd.layouts.Rbdl(["hip", "knee"], ["hip", "Knee"])
    with pytest.raises(ValueError, match="joint `hip` stands twice"):
        rd.layouts.Rbdl(["hip", "hip"])
    with pytest.raises(ValueError, match="the library has 3 joints, and the robot 2"):
        rd.layouts.Rbdl(["hip", "knee"], JOINTS)
    layout = rd.layouts.Rbdl(JOINTS)
    with pytest.raises(ValueError, match=r"`v` has the shape \(8,\): expected \(\.\.\., 9\)"):
        layout.velocity(np.eye(4), np.zeros(8))
    with pytest.raises(ValueError, match=r"`base` has the shape \(3, 3\): expected \(\.\.\., 4, 4\)"):
        layout.velocity(np.eye(3), np.zeros(9))
