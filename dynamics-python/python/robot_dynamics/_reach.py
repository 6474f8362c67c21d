"""Numeric inverse kinematics."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._keywords import require_kinds
from ._motion import numbers, vector

_SHAPES = ((3,), (2, 3), (3, 3), (4, 4))


class NotReached(ValueError):
    """No joint positions were found at which the targets are reached."""

    def __init__(self, reason: str, q: NDArray[np.float64], position: float, rotation: float) -> None:
        super().__init__(reason, q, position, rotation)
        self.reason = reason
        self.q = q
        """The joint positions that came nearest, within the limits."""
        self.position = position
        """The distance that is missing there, m."""
        self.rotation = rotation
        """The angle that is missing there, rad."""

    def __str__(self) -> str:
        return self.reason


def reach(
    arm: _native.Arm,
    target: ArrayLike | Sequence[ArrayLike],
    frame: str | Sequence[str] | None,
    asked: dict[str, Any],
) -> list[NDArray[np.float64]]:
    """Joint positions that are found."""
    if frame is None or isinstance(frame, str):
        targets = [(frame, _numbers(target))]  # type: ignore[arg-type]
    else:
        names, places = list(frame), list(target)  # type: ignore[arg-type]
        if len(names) != len(places):
            raise ValueError(f"frames and targets are as many: found {len(names)} and {len(places)}")
        targets = [(name, _numbers(one)) for name, one in zip(names, places)]
    joints = len(arm.joint_names)
    start, posture = asked["start"], asked["posture"]
    plan = {
        **asked,
        "targets": targets,
        "joint_names": arm.joint_names,
        "start": vector("start", start, joints),
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
    raise NotReached(reason, np.array(q), position, rotation)


def _numbers(target: ArrayLike) -> list[float]:
    array = numbers("target", target)
    if array.shape not in _SHAPES:
        raise ValueError(f"the target has the shape {array.shape}: expected one of {_SHAPES}")
    entries: list[float] = array.ravel().tolist()
    return entries
