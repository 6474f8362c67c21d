"""Numeric inverse kinematics."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._keywords import require_kinds
from ._motion import numbers, vector

_SHAPES = ((3,), (2, 3), (3, 3), (4, 4))

_Parts = tuple[list[float], list[float] | None, tuple[float, float]]
"""The numbers of a target, a position besides, and weights."""

_Places = tuple[list[_Parts], NDArray[np.intp]]
"""Some targets, and which of them counts along the leading axes."""


@dataclass(frozen=True)
class Target:
    """Where a frame is to be: at a position, with a rotation, or with an axis along a direction; a position may be added."""

    position: ArrayLike | None = None
    """m, `(3,)`."""
    rotation: ArrayLike | None = None
    """The frame's axes in the world, as columns, `(3, 3)`."""
    axis: ArrayLike | None = None
    """A vector of the frame, `(3,)`, which is to point along `direction`. The frame may turn about it."""
    direction: ArrayLike | None = None
    """A vector in the world, `(3,)`."""
    weights: tuple[float, float] = (1.0, 1.0)
    """How errors count where not all can be reached: of the position as shares of the arm's length, of the rotation in rad."""

    def _parts(self) -> _Parts:
        position = None if self.position is None else vector("position", self.position, 3)
        if (self.axis is None) != (self.direction is None) or (self.axis is not None and self.rotation is not None):
            raise ValueError("a target has a rotation, or an axis with a direction")
        if self.rotation is not None:
            turn = _entries(numbers("rotation", self.rotation), ((3, 3),))
        elif self.axis is not None:
            turn = vector("axis", self.axis, 3) + vector("direction", self.direction, 3)
        elif position is not None:
            return position, None, self.weights
        else:
            raise ValueError("a target has a position, a rotation, or an axis with a direction")
        return turn, position, self.weights


class NotReached(ValueError):
    """No joint positions were found at which the targets are reached."""

    def __init__(
        self, reason: str, q: NDArray[np.float64], position: float, rotation: float, index: tuple[int, ...] = ()
    ) -> None:
        super().__init__(reason, q, position, rotation, index)
        self.reason = reason
        self.q = q
        """The joint positions that came nearest, within the limits."""
        self.position = position
        """The distance that is missing there, m."""
        self.rotation = rotation
        """The angle that is missing there, rad."""
        self.index = index
        """The pose, by its index along each of the leading axes: `()` of a single one."""

    def __str__(self) -> str:
        return f"pose {list(self.index)}: {self.reason}" if self.index else self.reason


def reach(
    arm: _native.Arm,
    target: Any,
    frame: str | Sequence[str] | None,
    asked: dict[str, Any],
) -> list[NDArray[np.float64]]:
    """Joint positions that are found at one place."""
    targets, lead = _targets(target, frame)
    if lead:
        raise ValueError(f"the target has the leading axes {lead}: expected one pose")
    return _search(arm, [(name, *parts[0]) for name, (parts, _) in targets], asked, ())


def reach_each(
    arm: _native.Arm,
    target: Any,
    frame: str | Sequence[str] | None,
    asked: dict[str, Any],
    on_missed: str,
) -> NDArray[np.float64]:
    """Joint positions at each of some poses."""
    if on_missed not in ("raise", "nan"):
        raise ValueError(f'`on_missed` is {on_missed!r}: expected "raise" or "nan"')
    joints = len(arm.joint_names)
    targets, lead = _targets(target, frame)
    start = np.zeros(joints) if asked["start"] is None else numbers("start", asked["start"])
    if start.shape[-1:] != (joints,):
        raise ValueError(f"`start` has the shape {start.shape}: expected (..., {joints})")
    lead = np.broadcast_shapes(lead, start.shape[:-1])
    starts = np.broadcast_to(start, (*lead, joints))
    places = [(name, parts, np.broadcast_to(which, lead)) for name, (parts, which) in targets]
    found = np.full((*lead, joints), np.nan)
    for index in np.ndindex(lead):
        here = [(name, *parts[which[index]]) for name, parts, which in places]
        try:
            (found[index],) = _search(arm, here, {**asked, "start": starts[index]}, index)
        except NotReached:
            if on_missed == "raise":
                raise
    return found


def _search(
    arm: _native.Arm, targets: list[Any], asked: dict[str, Any], index: tuple[int, ...]
) -> list[NDArray[np.float64]]:
    """Joint positions at which the frames reach their targets."""
    joints = len(arm.joint_names)
    posture = asked["posture"]
    plan = {
        **asked,
        "targets": targets,
        "joint_names": arm.joint_names,
        "start": vector("start", asked["start"], joints),
        "posture": None if posture is None else vector("posture", posture, joints),
    }
    try:
        found, failed = arm.reach(plan)
    except TypeError as error:
        require_kinds(error, plan)
        raise
    if failed is None:
        return [np.array(q) for q, _, _ in found]
    reason, is_setting = failed
    if is_setting:
        raise ValueError(reason)
    ((q, position, rotation),) = found
    raise NotReached(reason, np.array(q), position, rotation, index)


def _targets(
    target: Any, frame: str | Sequence[str] | None
) -> tuple[list[tuple[str | None, _Places]], tuple[int, ...]]:
    """Each frame with its targets, and the leading axes that all are broadcast to."""
    if frame is None or isinstance(frame, str):
        given = [(frame, target)]
    else:
        names, places = list(frame), list(target)
        if len(names) != len(places):
            raise ValueError(f"frames and targets are as many: found {len(names)} and {len(places)}")
        given = list(zip(names, places))
    targets = [(name, _each(one)) for name, one in given]
    return targets, np.broadcast_shapes(*(which.shape for _, (_, which) in targets))


def _each(target: Any) -> _Places:
    """The targets of a frame: one, or one for each of many poses."""
    if isinstance(target, Target):
        return [target._parts()], np.array(0)
    array = numbers("target", target)
    lead = array.shape[:-2] if array.shape[-2:] == (4, 4) else ()
    each = array.reshape(math.prod(lead), *array.shape[len(lead) :])
    parts: list[_Parts] = [(_entries(one, _SHAPES), None, (1.0, 1.0)) for one in each]
    return parts, np.arange(len(each)).reshape(lead)


def _entries(array: NDArray[np.float64], shapes: tuple[tuple[int, ...], ...]) -> list[float]:
    if array.shape not in shapes:
        raise ValueError(f"the target has the shape {array.shape}: expected one of {shapes}")
    entries: list[float] = array.ravel().tolist()
    return entries
