"""Inverse kinematics in closed form."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._motion import numbers, vector

Floats = NDArray[np.float64]


class BranchEnds(ValueError):
    """A path leaves the branch it was on: no solution is near enough to the position before."""

    def __init__(self, joint: int | None, way: float, most: float) -> None:
        super().__init__(joint, way, most)
        self.joint = joint
        """The number of the joint, from 0, that moves farthest to the nearest solution; `None` if there is no solution."""
        self.way = way
        """How far this joint moves, rad or m."""
        self.most = most

    def __str__(self) -> str:
        if self.joint is None:
            return "the branch ends: there is no solution"
        return (
            f"the branch ends: to the nearest solution joint {self.joint + 1} moves by {self.way:.3f}, "
            f"more than {self.most:.3f}"
        )


class Solutions(np.ndarray[Any, np.dtype[np.float64]]):
    """All joint positions that lead to a pose: an array `(k, n)`, a row for each branch."""

    branches: list[str]
    """The name of each branch, as "shoulder left, elbow up, wrist flipped"."""
    is_singular: NDArray[np.bool_]
    """Whether each solution is singular: other positions do as well, or two cannot be told apart within 1e-7 rad."""
    reason: str | None
    """Why there is no solution: "out of reach" or "not a pose"."""
    _turns: list[bool]
    _limits: list[tuple[float, float] | None]

    def __new__(
        cls,
        q: Floats,
        is_singular: NDArray[np.bool_],
        branches: list[str],
        reason: str | None,
        turns: list[bool],
        limits: list[tuple[float, float] | None] | None = None,
    ) -> Solutions:
        solutions = np.asarray(q, dtype=np.float64).view(cls)
        solutions.branches, solutions.is_singular, solutions.reason = branches, is_singular, reason
        solutions._turns = turns
        solutions._limits = limits or [None] * len(turns)
        return solutions

    def __array_finalize__(self, _: object) -> None:
        """Arrays that are computed of it have no branches."""
        self.branches, self.is_singular, self.reason = [], np.zeros(0, bool), None
        self._turns, self._limits = [], []

    def __getitem__(self, key: Any) -> Any:
        return np.asarray(self)[key]

    def within(self, limits: ArrayLike) -> Solutions:
        """The solutions within limits `(n, 2)`, `arm.joint_limits` as it is, where whole turns that bring an angle into its range are added.

        A joint whose limit is not finite may be anywhere.
        """
        ranges = numbers("limits", limits)
        if ranges.shape != (len(self._turns), 2):
            raise ValueError(f"limits have the shape {ranges.shape}: expected {(len(self._turns), 2)}")
        pairs = [(lower, upper) if lower > -math.inf and upper < math.inf else None for lower, upper in ranges.tolist()]
        rows, kept = [], []
        for k, q in enumerate(np.asarray(self).tolist()):
            turned = [_turned(*joint) for joint in zip(self._turns, q, q, pairs)]
            if all(pair is None or pair[0] <= x <= pair[1] for x, pair in zip(turned, pairs)):
                rows.append(turned)
                kept.append(k)
        return Solutions(
            np.array(rows).reshape(len(rows), len(self._turns)),
            self.is_singular[kept],
            [self.branches[k] for k in kept],
            self.reason,
            self._turns,
            pairs,
        )

    def nearest(self, start: ArrayLike) -> Floats | None:
        """The solution whose joints have the least sum of squares of their ways from `start`, whole turns left out.

        Behind `within` whole turns are added that bring it nearest within the limits.
        """
        near = vector("start", start, len(self._turns))
        order = self._by_distance(near)
        if not order:
            return None
        joints = zip(self._turns, np.asarray(self)[order[0]].tolist(), near, self._limits)
        return np.array([_turned(turns, q, x, pair) if pair else q for turns, q, x, pair in joints])

    def follow(self, last: ArrayLike, most: float) -> Floats:
        """The solution that continues a path: the nearest, if no joint moves by more than `most`, else `BranchEnds`.

        Its angles stand as they are in the array, which may be whole turns away from `last`.
        """
        near = vector("last", last, len(self._turns))
        order = self._by_distance(near)
        if not order:
            raise BranchEnds(None, math.inf, most)
        ways = [abs(way) for way in self._ways(order[0], near)]
        farthest = max(range(len(ways)), key=ways.__getitem__)
        if not ways[farthest] <= most:
            raise BranchEnds(farthest, ways[farthest], most)
        return cast(Floats, np.asarray(self)[order[0]])

    def ordered(self, start: ArrayLike) -> Solutions:
        """The same solutions, the nearest to `start` first."""
        order = self._by_distance(vector("start", start, len(self._turns)))
        return Solutions(
            np.asarray(self)[order],
            self.is_singular[order],
            [self.branches[k] for k in order],
            self.reason,
            self._turns,
            self._limits,
        )

    def _ways(self, k: int, near: Sequence[float]) -> list[float]:
        """The way of each joint from a position to the nearest turn of solution k."""
        joints = zip(self._turns, np.asarray(self)[k].tolist(), near, self._limits)
        return [_turned(turns, q, x, pair) - x for turns, q, x, pair in joints]

    def _by_distance(self, near: Sequence[float]) -> list[int]:
        """The numbers of the solutions, the nearest first; none if the position is not finite."""
        distances = []
        for k in range(len(self)):
            distance = 0.0
            for way in self._ways(k, near):
                distance += way * way
            distances.append(distance)
        return sorted((k for k in range(len(self)) if math.isfinite(distances[k])), key=distances.__getitem__)


def _turned(turns: bool, q: float, near: float, pair: tuple[float, float] | None) -> float:
    """The position that is whole turns away from q and nearest to another one, in the range if one of them is."""
    return _native.nearest_turn(q, near, pair) if turns else q


class ClosedForms:
    """The closed forms of a robot, each found when it is first asked for."""

    def __init__(self, arm: _native.Arm) -> None:
        self._arm = arm
        self._forms: dict[str | None, _native.ClosedForm] = {}

    def of(self, frame: str | None) -> _native.ClosedForm:
        """The closed form for a frame, or for the tip."""
        if frame not in self._forms:
            self._forms[frame] = self._arm.closed_form(frame)
        return self._forms[frame]

    def solutions(
        self,
        poses: ArrayLike,
        elbow: ArrayLike | None,
        start: ArrayLike | None,
        frame: str | None,
    ) -> Any:
        """The solutions of one pose, or a list of these for each."""
        form = self.of(frame)
        given = numbers("poses", poses)
        if given.shape[-2:] != (4, 4):
            raise ValueError(f"poses have the shape {given.shape}: expected (..., 4, 4)")
        lead = given.shape[:-2]
        joints = len(form.turns)
        near = None if start is None else vector("start", start, joints)
        if form.has_elbow and elbow is None:
            if near is None:
                raise ValueError("seven joints leave one angle free: give `elbow`, its angle in rad, or `start`, whose angle is taken")
            elbow = form.elbow_angle(near)
        if not form.has_elbow and elbow is not None:
            raise ValueError(f"`elbow` is of seven joints: this robot has {joints}")
        elbows = np.broadcast_to(numbers("elbow", 0.0 if elbow is None else elbow), lead)
        rows = np.ascontiguousarray(given.reshape(-1, 16))
        found = form.solutions(rows, np.ascontiguousarray(elbows.reshape(-1)))
        solutions = [Solutions(*one, turns=form.turns) for one in found]
        if near is not None:
            solutions = [one.ordered(near) for one in solutions]
        return _nested(solutions, lead)


def _nested(all_of_them: list[Solutions], lead: tuple[int, ...]) -> Any:
    """A list in lists, as many deep as there are leading axes."""
    if not lead:
        return all_of_them[0]
    if len(lead) == 1:
        return all_of_them
    size = math.prod(lead[1:])
    return [_nested(all_of_them[k * size : (k + 1) * size], lead[1:]) for k in range(lead[0])]
