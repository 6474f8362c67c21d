"""Robots on a base that moves in the layouts of other libraries: positions, velocities, accelerations, forces, matrices.

Here the six velocities of the base are linear, then angular, both in its axes, and the base stands at a pose `(..., 4, 4)`.
The libraries differ in the order of the quaternion, in the order of the six numbers, and in the axes of each three:

`Pinocchio`: x y z, quaternion x y z w, joints; linear, then angular, both in the axes of the base.
`MuJoCo`: x y z, quaternion w x y z, joints; linear in the axes of the world, angular in those of the base.
`Drake`: quaternion w x y z, x y z, joints; angular, then linear, both in the axes of the world.
`Rbdl`: x y z, quaternion x y z, joints, quaternion w; linear in the axes of the world, angular in those of the base.

    layout = rd.layouts.MuJoCo(robot.joint_names, names)
    qpos, qvel = layout.position(base, q), layout.velocity(base, v)

All take arrays of any leading axes, which are broadcast. Let v' = S v. Then a force is S f, a mass matrix S M S^T, and a
Jacobian J S^T. Where the linear velocity is in the axes of the world, accelerations have one more term, R (w x v).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Drake", "Layout", "MuJoCo", "Pinocchio", "Rbdl"]

Floats = NDArray[np.float64]


class Layout:
    """The layout of a library, for joints of these names: `ours` in the order of q, `theirs` in that of the library.

    `theirs` may be left out if the order is the same. `ValueError` of a joint without a place of its own among `theirs`.
    """

    _angular_first: ClassVar[bool] = False
    _linear_in_world: ClassVar[bool] = True
    _angular_in_world: ClassVar[bool] = False
    _origin: ClassVar[int] = 0
    _first_joint: ClassVar[int] = 7
    _quaternion: ClassVar[tuple[int, ...]] = (3, 4, 5, 6)
    """The places of w, x, y, z, from the end of q where they are negative."""

    def __init__(self, ours: Sequence[str], theirs: Sequence[str] | None = None) -> None:
        names = list(ours if theirs is None else theirs)
        for joint in ours:
            if list(ours).count(joint) > 1:
                raise ValueError(f"joint `{joint}` stands twice among the names of the robot")
            if joint not in names:
                raise ValueError(f"joint `{joint}` is not among the names of the library")
        if len(names) != len(ours):
            raise ValueError(f"the library has {len(names)} joints, and the robot {len(ours)}")
        self._joints = np.array([names.index(joint) for joint in ours], dtype=np.intp)
        linear, angular = (3, 0) if self._angular_first else (0, 3)
        self._places = np.concatenate([linear + np.arange(3), angular + np.arange(3), 6 + self._joints])

    def position(self, base: ArrayLike, q: ArrayLike) -> Floats:
        """The library's q, `(..., 7 + n)`: its quaternion has a length of 1, and its w is not negative."""
        base, q = self._pose(base), self._vector("q", q, 0)
        lead = np.broadcast_shapes(base.shape[:-2], q.shape[:-1])
        theirs = np.empty((*lead, 7 + len(self._joints)))
        theirs[..., self._origin : self._origin + 3] = base[..., :3, 3]
        theirs[..., self._quaternion] = _quaternion(base[..., :3, :3])
        theirs[..., self._first_joint + self._joints] = q
        return theirs

    def from_position(self, theirs: ArrayLike) -> tuple[Floats, Floats]:
        """The pose of the base and the positions of the joints. A quaternion of another length counts as its direction."""
        theirs = self._vector("theirs", theirs, 7)
        base = np.zeros((*theirs.shape[:-1], 4, 4))
        base[..., :3, :3] = _rotation(theirs[..., self._quaternion])
        base[..., :3, 3] = theirs[..., self._origin : self._origin + 3]
        base[..., 3, 3] = 1
        return base, theirs[..., self._first_joint + self._joints]

    def velocity(self, base: ArrayLike, v: ArrayLike) -> Floats:
        """The library's velocity, `(..., 6 + n)`."""
        return self._there(base, self._vector("v", v, 6))

    def from_velocity(self, base: ArrayLike, theirs: ArrayLike) -> Floats:
        """The velocity v of the library's."""
        return self._back(base, self._vector("theirs", theirs, 6))

    def acceleration(self, base: ArrayLike, v: ArrayLike, a: ArrayLike) -> Floats:
        """The library's acceleration, the rate of its velocity, of `a` at our velocity `v`."""
        return self._there(base, self._vector("a", a, 6) + self._turning(v))

    def from_acceleration(self, base: ArrayLike, v: ArrayLike, theirs: ArrayLike) -> Floats:
        """The acceleration of the library's, at our velocity `v`."""
        return self._back(base, self._vector("theirs", theirs, 6)) - self._turning(v)

    def force(self, base: ArrayLike, force: ArrayLike) -> Floats:
        """The library's generalized force, with the same power."""
        return self._there(base, self._vector("force", force, 6))

    def from_force(self, base: ArrayLike, theirs: ArrayLike) -> Floats:
        """The force and the moment on the base and the forces of the joints, of the library's."""
        return self._back(base, self._vector("theirs", theirs, 6))

    def jacobian(self, base: ArrayLike, jacobian: ArrayLike) -> Floats:
        """A Jacobian `(..., r, 6 + n)` with the columns of the library's velocities: its rows stay."""
        return self._there(self._pose(base)[..., None, :, :], self._vector("jacobian", jacobian, 6))

    def from_jacobian(self, base: ArrayLike, theirs: ArrayLike) -> Floats:
        """The Jacobian of the library's."""
        return self._back(self._pose(base)[..., None, :, :], self._vector("theirs", theirs, 6))

    def mass_matrix(self, base: ArrayLike, mass_matrix: ArrayLike) -> Floats:
        """The library's mass matrix, S M S^T."""
        return self.jacobian(base, self.jacobian(base, mass_matrix).swapaxes(-1, -2))

    def from_mass_matrix(self, base: ArrayLike, theirs: ArrayLike) -> Floats:
        """The mass matrix M of the library's."""
        return self.from_jacobian(base, self.from_jacobian(base, theirs).swapaxes(-1, -2))

    def _there(self, base: ArrayLike, ours: Floats) -> Floats:
        """S x."""
        turned = self._turned(self._pose(base)[..., :3, :3], ours)
        theirs = np.empty_like(turned)
        theirs[..., self._places] = turned
        return theirs

    def _back(self, base: ArrayLike, theirs: Floats) -> Floats:
        """S^T x, which is the inverse."""
        rotation = self._pose(base)[..., :3, :3].swapaxes(-1, -2)
        return self._turned(rotation, theirs[..., self._places])

    def _turned(self, rotation: Floats, x: Floats) -> Floats:
        """The parts turned that the library has in the axes of the world."""
        lead = np.broadcast_shapes(rotation.shape[:-2], x.shape[:-1])
        turned = np.broadcast_to(x, (*lead, x.shape[-1])).copy()
        for first, in_world in ((0, self._linear_in_world), (3, self._angular_in_world)):
            if in_world:
                part = slice(first, first + 3)
                turned[..., part] = np.einsum("...ij,...j->...i", rotation, x[..., part])
        return turned

    def _turning(self, v: ArrayLike) -> Floats:
        """`w x v`, which the rate of a linear velocity in the axes of the world has besides."""
        v = self._vector("v", v, 6)
        turning = np.zeros_like(v)
        if self._linear_in_world:
            turning[..., :3] = np.cross(v[..., 3:6], v[..., :3])
        return turning

    def _vector(self, name: str, given: ArrayLike, more: int) -> Floats:
        """Vectors with an entry for each joint, and some more."""
        return _shaped(name, given, (more + len(self._joints),))

    def _pose(self, base: ArrayLike) -> Floats:
        return _shaped("base", base, (4, 4))


class Pinocchio(Layout):
    """The layout of Pinocchio, for a free-flyer as the root joint. Its joints are `model.names[2:]`, by the alphabet."""

    _linear_in_world = False
    _quaternion = (6, 3, 4, 5)


class MuJoCo(Layout):
    """The layout of MuJoCo, for a body with a free joint."""


class Drake(Layout):
    """The layout of Drake, for a floating body with a quaternion."""

    _angular_first = True
    _angular_in_world = True
    _origin = 4
    _quaternion = (0, 1, 2, 3)


class Rbdl(Layout):
    """The layout of RBDL, for `JointTypeFloatingBase`."""

    _first_joint = 6
    _quaternion = (-1, 3, 4, 5)


def _shaped(name: str, given: ArrayLike, axes: tuple[int, ...]) -> Floats:
    array = np.asarray(given, dtype=np.float64)
    if array.shape[-len(axes) :] != axes:
        expected = ", ".join(map(str, axes))
        raise ValueError(f"`{name}` has the shape {array.shape}: expected (..., {expected})")
    return array


def _quaternion(rotation: Floats) -> Floats:
    """Unit quaternions w, x, y, z of rotations, w not negative: from the largest of the four, so that no digits are lost."""
    r, trace = rotation, np.trace(rotation, axis1=-2, axis2=-1)
    squares = np.stack([1 + trace, *(1 + 2 * r[..., i, i] - trace for i in range(3))], axis=-1)
    x, y, z = (r[..., j, i] - r[..., i, j] for i, j in ((1, 2), (2, 0), (0, 1)))
    xy, xz, yz = (r[..., i, j] + r[..., j, i] for i, j in ((0, 1), (0, 2), (1, 2)))
    w2, x2, y2, z2 = np.moveaxis(squares, -1, 0)
    rows = np.stack([w2, x, y, z, x, x2, xy, xz, y, xy, y2, yz, z, xz, yz, z2], axis=-1)
    rows = rows.reshape(*rows.shape[:-1], 4, 4)
    largest = squares.argmax(axis=-1)[..., None, None]
    row = np.take_along_axis(rows, largest, axis=-2)[..., 0, :]
    row /= np.linalg.norm(row, axis=-1, keepdims=True)
    return np.where(row[..., :1] < 0, -row, row)


def _rotation(quaternion: Floats) -> Floats:
    """The rotations of quaternions w, x, y, z."""
    with np.errstate(invalid="ignore"):
        w, x, y, z = np.moveaxis(quaternion / np.linalg.norm(quaternion, axis=-1, keepdims=True), -1, 0)
    rows = [
        *(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        *(2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        *(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    ]
    return np.stack(rows, axis=-1).reshape(*quaternion.shape[:-1], 3, 3)
