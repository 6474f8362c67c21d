"""Simulated motions."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._keywords import require_kinds, require_known

Law = Callable[..., ArrayLike]
"""Torques as a function `law(t, q, qd)`, or `law(t, base, q, v)` where the base moves."""

Floats = NDArray[np.float64]

ARGUMENTS = ("q", "qd", "torque", "duration", "samples", "method", "base", "tool_wrench", "wrench_at")
"""The arguments that `Robot.simulate` names."""

SETTINGS: dict[str, Any] = {
    "held_tool_wrench": None,
    "step": None,
    "tolerance": None,
    "max_step": None,
    "max_steps": None,
    "friction": "sign",
    "speed": 1e-3,
    "saturate": False,
    "stops": None,
    "limits_are_errors": False,
    "control_period": None,
}
"""Further settings of a simulation, as they are where nothing is said."""


class Work(NamedTuple):
    """The work of a run."""

    evaluations: int
    """How often the equations of motion were evaluated."""
    steps: int
    rejected: int
    """Steps thrown away because their error was too large."""


@dataclass(repr=False)
class Trajectory:
    """A sampled motion: one row for each of the times `t`. SI units, radians."""

    t: Floats
    """Times, `(k,)`."""
    q: Floats
    """Joint positions, `(k, n)`."""
    qd: Floats
    """Velocities, `(k, n)`; of a robot whose base moves the six of the base first, in its axes."""
    qdd: Floats
    """Accelerations, as the velocities; NaN where they could not be computed."""
    tau: Floats
    """Torques of the law, as the velocities."""
    kinetic_energy: Floats
    """T, `(k,)`, J."""
    potential_energy: Floats
    """U, `(k,)`, J."""
    work: Work
    base: Floats | None = None
    """Poses of a base that moves, `(k, 4, 4)`."""
    joint_names: list[str] = field(default_factory=list)
    joint_units: list[str] = field(default_factory=list)
    """The unit of each joint's position, `"rad"` or `"m"`."""
    creeping: list[str] = field(default_factory=list)
    """Joints that dry friction should have held, and that crept by steps of fixed length."""

    @property
    def energy(self) -> Floats:
        """T + U, `(k,)`, J."""
        return self.kinetic_energy + self.potential_energy

    def __len__(self) -> int:
        return len(self.t)

    def __repr__(self) -> str:
        joints = ", ".join(self.joint_names)
        return f"<Trajectory: {len(self)} samples from {self.t[0]:g} s to {self.t[-1]:g} s, {joints}>"

    def plot(self) -> Any:
        """Positions, velocities and torques over time, as a figure of matplotlib, which must be installed."""
        import matplotlib.pyplot as plt

        figure, axes = plt.subplots(3, 1, sharex=True, layout="constrained")
        moving = len(self.joint_names)
        units = list(dict.fromkeys(self.joint_units)) or ["rad", "m"]
        quantities = (
            ("Positions", "q", self.q, units),
            ("Velocities", "qd", self.qd, [f"{unit}/s" for unit in units]),
            ("Torques and forces", "tau", self.tau, [{"rad": "N m", "m": "N"}[unit] for unit in units]),
        )
        for axis, (title, name, values, units) in zip(axes, quantities, strict=True):
            axis.plot(self.t, values[:, values.shape[1] - moving :], label=self.joint_names)
            axis.set_title(title)
            axis.set_ylabel(f"{name} in {' or '.join(units)}")
        axes[0].legend()
        axes[-1].set_xlabel("t in s")
        return figure


class SimulationError(RuntimeError):
    """A motion that could not be followed to its end."""

    def __init__(self, time: float, reason: str, trajectory: Trajectory) -> None:
        super().__init__(time, reason, trajectory)
        self.time = time
        """The time reached, s."""
        self.reason = reason
        self.trajectory = trajectory
        """All samples before."""

    def __str__(self) -> str:
        return self.reason


def simulate(
    arm: _native.Arm,
    q: ArrayLike,
    qd: ArrayLike | None,
    base: ArrayLike | None,
    settings: dict[str, Any],
) -> Trajectory:
    """The motion of a robot from rest, or from velocities."""
    require_known(settings, [*ARGUMENTS, *SETTINGS])
    settings = {**SETTINGS, **settings}
    torque, wrench = settings.pop("torque"), settings.pop("tool_wrench")
    held = settings.pop("held_tool_wrench")
    if held is not None and (wrench is not None or settings["control_period"] is None):
        raise ValueError("`held_tool_wrench` takes the place of `tool_wrench`, and needs a `control_period`")
    at_frames = settings.pop("wrench_at") or {}
    if not isinstance(at_frames, Mapping):
        raise TypeError("`wrench_at` is a mapping of frames to laws: `{\"hand\": law}`")
    wrenches = [_wrench(frame, law, f'wrench_at["{frame}"]') for frame, law in at_frames.items()]
    if wrench is not None:
        wrenches.insert(0, _wrench(None, wrench, "tool_wrench"))
    moves = arm.dof - len(arm.joint_names)
    if base is not None and not moves:
        raise ValueError("`base` is of a robot whose base moves: this one stands")
    law = torque if callable(torque) else None
    constant = None if callable(torque) else torque
    plan = {
        **settings,
        "base": None if base is None else _rows_of_pose(base),
        "q": vector("q", q, len(arm.joint_names)),
        "v": vector("qd", qd, arm.dof),
        "wrenches": wrenches,
        "held_wrench": None if held is None else _wrench(None, held, "held_tool_wrench"),
    }
    if held is not None and moves:
        raise ValueError("`held_tool_wrench` is of a robot whose base stands: this one moves")
    try:
        arrays, stopped = arm.simulate(plan, law, vector("torque", constant, arm.dof))
    except TypeError as error:
        require_kinds(error, plan)
        raise
    motion = _trajectory(arrays, arm)
    if motion.creeping:
        warnings.warn(
            f"{', '.join(motion.creeping)}: dry friction by its sign cannot hold a joint by steps of fixed length, which "
            'let it creep: take `friction="sticking"`',
            RuntimeWarning,
            stacklevel=3,
        )
    if stopped is None:
        return motion
    time, reason, is_setting = stopped
    if is_setting:
        raise ValueError(reason)
    raise SimulationError(time, reason, motion)


def _wrench(frame: str | None, law: Law, name: str) -> dict[str, Any]:
    """A force of the surroundings at a frame, or at the tip."""
    if not callable(law):
        raise TypeError(f"`{name}` is {law!r}: expected a function `law(t, pose, twist)`")
    return {"frame": frame, "law": law, "name": name}


def numbers(name: str, given: ArrayLike) -> Floats:
    """Numbers as an array; `TypeError` of a mask."""
    array = np.asarray(given, dtype=np.float64)
    _native.require_unmasked(name, given, array.ndim)
    return array


def vector(name: str, given: ArrayLike | None, entries: int) -> list[float]:
    """A vector as numbers, zeros where it is not given."""
    if given is None:
        return [0.0] * entries
    vector = numbers(name, given)
    if vector.shape != (entries,):
        raise ValueError(f"`{name}` has the shape {vector.shape}: expected ({entries},)")
    found: list[float] = vector.tolist()
    return found


def _rows_of_pose(given: ArrayLike) -> list[float]:
    """The entries of a homogeneous matrix by rows."""
    pose = numbers("base", given)
    if pose.shape != (4, 4):
        raise ValueError(f"`base` has the shape {pose.shape}: expected (4, 4)")
    entries: list[float] = pose.ravel().tolist()
    return entries


def _trajectory(arrays: dict[str, Any], arm: _native.Arm) -> Trajectory:
    energies = arrays["energies"]
    return Trajectory(
        t=arrays["t"],
        q=arrays["q"],
        qd=arrays["v"],
        qdd=arrays["a"],
        tau=arrays["tau"],
        kinetic_energy=energies[:, 0],
        potential_energy=energies[:, 1],
        work=Work(*arrays["work"]),
        base=arrays.get("base"),
        joint_names=arm.joint_names,
        joint_units=arm.joint_units,
        creeping=[arm.joint_names[i] for i in arrays["creeping"]],
    )
