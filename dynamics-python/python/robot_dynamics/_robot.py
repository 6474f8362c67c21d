"""Robots: files and tables read, their functions as methods."""

from __future__ import annotations

import difflib
import html
import os
import types
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native, _toml
from ._closed_form import ClosedForms
from ._keywords import require_known
from ._motion import Law, Trajectory, numbers, simulate
from ._native import Function
from ._questions import Formulas, Operations, Report
from ._reach import Target, reach, reach_each

_OPTIONS = ("functions", "chain", "ignore", "round_angles", "fields")
"""Keywords that are no entries of a table."""

KEYWORDS = (
    *("convention", "gravity", "base", "joint", "joints", "links", "couple", "tool", "frames", "lock", "neglect", "bounds", "allow", "let"),
    *_OPTIONS,
)
"""All keywords: entries of tables as files have them, where each frame is a `frame` of its own, and the options."""

_TEXT = "TOML"
"""The name of a text in messages."""


class Robot:
    """A robot, read from a file or a table. Its functions are methods, each derived at its first call and kept.

    Every entry of a table may be a keyword: `gravity`, `base`, `tool`, `lock`, `allow`, `frames`, `couple`, `joints`,
    `links`, `neglect`, and so on. Beside a file they add to its entries, or take their place. A float is read as its shortest
    decimal, and a string is an expression such as `"PI/2"` or `"deg(90)"`. Further keywords:

    `functions`: the names of the functions, `default` for those that a table without names has.
    `fields`: the names that cells may use without a value, or a mapping that gives values, too. Where it is left out, all
    names that nothing binds are fields.
    `chain`, `ignore`, `round_angles`: of URDF files; the first and the last link of the arm, joints that are left out,
    and the distance from a quarter turn, rad, within which an angle is taken for it.

    All mistakes of a file are in one `TableError`.
    """

    coriolis_matrix: Function
    """`coriolis_matrix(q, qd)`: Coriolis matrix C(q, qd), N x N, from the Christoffel symbols of the first kind: C qd = V,
    and dM/dt - 2 C is skew-symmetric.
    """
    coriolis_vector: Function
    """`coriolis_vector(q, qd)`: Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity,
    springs, friction and acceleration.
    """
    forward_dynamics: Function
    """`forward_dynamics(q, qd, tau)`: Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) +
    F(qd) = tau, rad/s^2 or m/s^2; K is of springs, F of friction.
    """
    forward_kinematics: Function
    """`forward_kinematics(q)`: Forward kinematics: the homogeneous transform of the tip in the base frame, m."""
    friction_vector: Function
    """`friction_vector(qd)`: Friction vector F(qd) = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), N m or N, with
    sign(0) = 0: C is the Coulomb friction of the direction, S static friction that falls to it over the velocity v,
    where the table has one, else C.
    """
    gravity_vector: Function
    """`gravity_vector(q)`: Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics
    at rest without springs.
    """
    inverse_dynamics: Function
    """`inverse_dynamics(q, qd, qdd)`: Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one
    program; K is of springs, F of friction.
    """
    jacobian: Function
    """`jacobian(q)`: Geometric Jacobian of the tip's origin, 6 x N, rows vx vy vz wx wy wz, in the base frame."""
    kinetic_energy: Function
    """`kinetic_energy(q, qd)`: Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J."""
    mass_matrix: Function
    """`mass_matrix(q)`: Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg).
    Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    """
    potential_energy: Function
    """`potential_energy(q)`: Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, and that of springs,
    1/2 stiffness (q - rest)^2, J.
    """

    def __init__(self, source: _Origin, fields: Mapping[str, float]) -> None:
        self._source = source
        arm = source.read()
        self._set(arm.with_fields(list(fields.items())) if fields else arm)

    def _set(self, arm: _native.Arm) -> None:
        self._arm = arm
        self._closed_forms = ClosedForms(arm)
        self._functions = dict(arm.functions)
        # Attributes of the instance: a call finds its function without a search by name.
        self.__dict__.update(self._functions)

    @classmethod
    def from_file(cls, path: str | os.PathLike[str], **entries: Any) -> Robot:
        """The robot of a file: a table in TOML or in JSON, or a URDF file.

        `FileNotFoundError`, or another `OSError`, of a file that cannot be read.
        """
        path = os.fspath(path)
        return cls._read(path, _native.text_of(path), entries)

    @classmethod
    def from_toml(cls, text: str, **entries: Any) -> Robot:
        """The robot of a table in TOML."""
        return cls._read(_TEXT, text, entries)

    @classmethod
    def from_table(
        cls, *, convention: str, joint: Sequence[Mapping[str, Any]], **entries: Any
    ) -> Robot:
        """The robot of a table of keywords: `joint` has a mapping for each row.

        The convention is `"standard"` or `"modified"` (Denavit and Hartenberg's, or Craig's).
        """
        require_known(entries, KEYWORDS)
        options = {name: entries.pop(name) for name in _OPTIONS if name in entries}
        table = {"convention": convention, "joint": joint, **entries}
        return cls._read(_TEXT, _toml.document(_in_files(table)), options)

    @classmethod
    def _read(cls, path: str, text: str, entries: dict[str, Any]) -> Robot:
        require_known(entries, KEYWORDS)
        source = _Source(path, text, entries)
        return cls(source, source.values)

    @property
    def dof(self) -> int:
        """Degrees of freedom: the joints that move, and six more of a base that moves."""
        return self._arm.dof

    @property
    def joint_names(self) -> list[str]:
        """Names of the joints that move, from the base outwards."""
        return self._arm.joint_names

    @property
    def joint_limits(self) -> NDArray[np.float64]:
        """Least and greatest position of each joint, rad or m, `(n, 2)`; infinite where there is no limit."""
        return np.array(self._arm.joint_limits, dtype=np.float64).reshape(-1, 2)

    @property
    def torque_limits(self) -> NDArray[np.float64]:
        """Greatest torque or force of each joint in either direction, N m or N, `(n,)`; infinite where there is no limit."""
        return np.array(self._arm.torque_limits, dtype=np.float64)

    @property
    def velocity_limits(self) -> NDArray[np.float64]:
        """Greatest velocity of each joint in either direction, rad/s or m/s, `(n,)`; infinite where there is no limit."""
        return np.array(self._arm.velocity_limits, dtype=np.float64)

    @property
    def bounds(self) -> dict[str, tuple[float, float]]:
        """The largest rounding error of each function's values, SI units, in double and in single precision.

        It is proven for all positions within the limits, all other arguments up to 1, and any rotation of a moving base. Infinite if
        there is no bound: without limits, with fields, or if a divisor may vanish. All functions are derived for it.
        """
        return {name: (double, single) for name, (double, single) in self._arm.bounds()}

    @property
    def base_parameter_names(self) -> list[str]:
        """The first term of each base parameter, in the order of the regressor's columns: `J2xx`, `h2x`, `m2`, `I2`."""
        return self._arm.base_parameter_names

    @property
    def base_parameter_formulas(self) -> Formulas:
        """The base parameters as combinations of the links' own parameters, a line for each; the legend has their names."""
        return Formulas(*self._arm.base_parameter_formulas)

    @property
    def fields(self) -> dict[str, float]:
        """Fields and their values, NaN of those without."""
        return dict(zip(self._arm.field_names, self._arm.field_values))

    @property
    def functions(self) -> list[str]:
        """Names of the functions."""
        return list(self._functions)

    def with_fields(self, **values: float) -> Robot:
        """The same robot whose fields have these values: nothing is derived again."""
        robot = Robot.__new__(Robot)
        robot._source = self._source
        robot._set(self._arm.with_fields([(name, float(x)) for name, x in values.items()]))
        return robot

    def operations(self, function: str) -> Operations:
        """How many operations the program of a function takes at a state."""
        return Operations(*self._arm.operations(function))

    def formulas(self, function: str, format: str = "text", *, terms: int = 1000) -> Formulas:
        """The formulas of a function as `"text"`, `"latex"` or `"mathml"`: a string with a line for each equation.

        `ValueError` of a formula of more than so many terms, and of functions that solve equations step by step.
        """
        return Formulas(*self._arm.formulas(function, format, terms))

    def bound(self, function: str, *arguments: ArrayLike) -> Any:
        """Proven bounds of the rounding of a function's values, in arrays as the function returns them.

        Arguments and fields are exactly the doubles that they are. A bound is infinite where nothing is proven.
        """
        return self._function(function).bound(*arguments)

    def source(
        self,
        lang: str,
        functions: str | Iterable[str] | None = None,
        *,
        scalar: str | None = None,
        sines: str | None = None,
        project: bool = False,
    ) -> dict[str, str]:
        """Functions as source code: the texts of files by their names.

        `lang` is `"rust"`, `"c"`, `"js"`, `"matlab"`, `"python"` or `"casadi"`: a C file for `casadi.external`, with
        derivatives besides. Fields keep their names. C alone takes
        `scalar="float"`, `sines="libm"` (those of its library, not of the source) and `project=True`, which adds a header
        for C++, `CMakeLists.txt` and a test program.
        """
        names = _words(functions) or list(self.functions)
        return dict(self._arm.source(lang, names, scalar, sines, project))

    def function(self, name: str) -> Callable[..., Any]:
        """A function as straight lines of Python, compiled: its last argument `xp` is the namespace of arrays.

        `xp` is numpy, or `jax.numpy`, `torch`, `casadi`, `sympy`. Where the robot has fields, the first argument `arm` has
        them as attributes.
        """
        (text,) = self.source("python", [name]).values()
        module = types.ModuleType(name)
        exec(compile(text, f"<{name} of {self._arm.name}>", "exec"), module.__dict__)
        function: Callable[..., Any] = getattr(module, name)
        return function

    def check(self, samples: int = 1000) -> Report:
        """Compares the functions with Newton-Euler at random states."""
        return Report(*self._arm.check(samples))

    def simulate(
        self,
        q: ArrayLike,
        qd: ArrayLike | None = None,
        *,
        torque: Law | ArrayLike | None = None,
        duration: float = 1.0,
        samples: int = 101,
        method: str = "dormand_prince",
        base: ArrayLike | None = None,
        tool_wrench: Law | None = None,
        wrench_at: Mapping[str, Law] | None = None,
        **settings: Any,
    ) -> Trajectory:
        """Follows the motion from positions `q` and velocities `qd` under the torques of a law.

        `torque` is a vector, or a function `law(t, q, qd)`; of a robot whose base moves `law(t, base, q, v)`, and `base` is
        its pose at first, `(4, 4)`. With `control_period` the law is called once a period, in order, and held: it may have
        a memory then. Methods with error control, which take `tolerance`, `max_step` and `max_steps`: `dormand_prince`,
        `dop853`, `radau5`. Methods of a fixed `step`: `explicit_euler`, `craig_euler`, `semi_implicit_euler`,
        `runge_kutta4`, `implicit_midpoint`, `gauss_legendre4`, `gauss_legendre6`. Further settings:

        `tool_wrench`: the force at the tool, `law(t, pose, twist)` to `(fx, fy, fz, nx, ny, nz)` in the axes of `jacobian`;
        `forward_kinematics` and `jacobian` must be among the functions.
        `wrench_at`: forces at frames besides, `{"hand": law}` with as many frames as there are; a law is one of `tool_wrench`, at
        the frame's origin, and needs `forward_kinematics(hand)` and `jacobian(hand)`.
        `held_tool_wrench`: such a law that is called once a `control_period` and held, for random pushes; it may have a memory.
        `friction`: `"sign"`, `"sticking"` (joints stop and stick, as events), or `"regularised"` by a `speed`. By its sign, a
        joint that friction should hold ends a motion under error control that a million evaluations and steps do not lead
        on. By a fixed `step` it creeps, which is a `RuntimeWarning`, and `creeping` of the motion names it.
        `stops`: the restitution with which joints rebound at the limits of the table, from 0 to 1. Bounces without end come to
        rest below the tolerance, or end the motion.
        A fixed `step`, or a `control_period`, makes at most 100,000 steps between two samples, or 10 million in fewer than 101.
        `limits_are_errors`: whether the motion ends where a joint passes a limit.
        `saturate`: whether torques are cut to the limits of the table.

        `SimulationError` where the motion ends early, with all samples before.
        """
        given = {
            "torque": torque,
            "duration": duration,
            "samples": samples,
            "method": method,
            "tool_wrench": tool_wrench,
            "wrench_at": wrench_at,
        }
        return simulate(self._arm, q, qd, base, {**given, **settings})

    def inverse_kinematics(
        self,
        poses: ArrayLike,
        elbow: ArrayLike | None = None,
        start: ArrayLike | None = None,
        *,
        frame: str | None = None,
    ) -> Any:
        """All joint positions that lead the tip, or a frame, to a pose, in closed form: `Solutions`, an array `(k, n)`.

        Of `poses` `(..., 4, 4)` a list of these for each pose. Of seven joints `elbow` is the angle of the elbow about the line from
        shoulder to wrist, rad, one or one for each pose. With `start` the nearest solution comes first, and the elbow has the angle
        that it has there if `elbow` is not given. `ValueError` says why an arm has no closed form; `reach` serves every arm.
        """
        return self._closed_forms.solutions(poses, elbow, start, frame)

    def elbow_angle(self, q: ArrayLike, *, frame: str | None = None) -> float:
        """The angle of seven joints' elbow, rad, by which `inverse_kinematics` finds these joint positions."""
        angle = self._closed_forms.of(frame).elbow_angle(numbers("q", q).ravel().tolist())
        if angle is None:
            raise ValueError("an angle of the elbow is of seven joints")
        return angle

    def reach(
        self,
        target: ArrayLike | Target | Sequence[ArrayLike | Target],
        start: ArrayLike | None = None,
        *,
        frame: str | Sequence[str] | None = None,
        posture: ArrayLike | None = None,
        tolerance: tuple[float, float] = (1e-9, 1e-9),
        attempts: int = 100,
        seed: int = 1,
        on_missed: str = "raise",
    ) -> NDArray[np.float64]:
        """Joint positions at which the tip, or a frame, reaches a target, within the limits: numeric inverse kinematics.

        A target is a pose `(4, 4)`, a position `(3,)`, a rotation `(3, 3)`, or `(2, 3)`: an axis of the frame and the direction
        in the world along which it is to point. `Target` has a position with a direction, and weights. Several frames,
        `frame=["left", "right"]`, have a target each. The functions `forward_kinematics` and `jacobian` of these frames are
        needed. Many poses `(..., 4, 4)` and starts `(..., n)` are broadcast, and the positions are an array `(..., n)`. With
        `on_missed="nan"` those of poses that are missed are NaN.

        The search begins at `start`, zeros where it is left out, and at random positions after it, the same for one `seed`. Where
        the targets leave a freedom, the joints go towards `posture`. `tolerance` is in m and rad. `NotReached`, a
        `ValueError`, says why nothing was found, and what came nearest.
        """
        asked = {"start": start, "posture": posture, "tolerance": tolerance, "attempts": attempts, "seed": seed}
        return reach_each(self._arm, target, frame, {**asked, "most": 1}, on_missed)

    def reach_all(
        self,
        target: ArrayLike | Target | Sequence[ArrayLike | Target],
        start: ArrayLike | None = None,
        *,
        frame: str | Sequence[str] | None = None,
        tolerance: tuple[float, float] = (1e-9, 1e-9),
        attempts: int = 200,
        seed: int = 1,
        most: int = 64,
    ) -> list[NDArray[np.float64]]:
        """Distinct joint positions at which a target is reached, the nearest to `start` first, as `reach` finds them.

        All attempts are made, or as many as it takes to find `most`. Positions that few starts lead to may be missing.
        """
        asked = {"start": start, "posture": None, "tolerance": tolerance, "attempts": attempts, "seed": seed}
        return reach(self._arm, target, frame, {**asked, "most": max(most, 2)})

    def identified(
        self, base_parameters: ArrayLike, friction: ArrayLike | None = None
    ) -> Robot:
        """The robot with identified base parameters, in the order of `base_parameters`; `regressor` must be a function.

        `friction` has a row `(viscous, coulomb, coulomb of negative velocities)` for each joint that moves. `ValueError` of
        base parameters that no bodies have: `nearest_possible` finds some that bodies have.
        """
        rows = None if friction is None else numbers("friction", friction).tolist()
        source = _Identified(self, numbers("base_parameters", base_parameters).tolist(), rows)
        return Robot(source, {})

    def nearest_possible(self, base_parameters: ArrayLike) -> tuple[NDArray[np.float64], float]:
        """The base parameters nearest to these that bodies can have, and their distance in torque, N m or N."""
        given = numbers("base_parameters", base_parameters).tolist()
        nearest, distance = self._arm.nearest_possible(given)
        return np.array(nearest), distance

    def __getattr__(self, name: str) -> Function:
        """Functions of frames and of several have names of their own. The others were not requested."""
        if name.startswith("_"):
            raise AttributeError(name)
        if name == "taylor_series":
            raise AttributeError("`taylor_series` is a function of compiled robots: the macro of Rust has it")
        # Only a slip of one letter or two: names of functions resemble each other.
        public = [word for word in (*self._functions, *dir(self)) if not word.startswith("_")]
        meant = difflib.get_close_matches(name.lower(), public, 1, 0.9)
        if meant:
            raise AttributeError(f"no function `{name}`: did you mean `{meant[0]}`?")
        known = _native.Arm.known_functions()
        if name in known:
            raise AttributeError(
                f"no function `{name}`: add it to `functions`, for example functions=[\"default\", \"{name}\"]"
            )
        of_frame = [function for function in known if name.startswith(f"{function}_")]
        if of_frame:
            function = max(of_frame, key=len)
            frame = name[len(function) + 1 :]
            raise AttributeError(
                f"no function `{name}`: if `{frame}` is a frame, add it to `functions`, for example "
                f"functions=[\"default\", \"{function}({frame})\"]; in a method's name its letters are small ones"
            )
        raise AttributeError(f"a robot has no `{name}`: there are {', '.join(public)}")

    def _function(self, name: str) -> Function:
        if name not in self._functions:
            expected = ", ".join(self._functions)
            raise ValueError(f"`{name}` is not in `functions`: expected one of {expected}")
        return self._functions[name]

    def page(self) -> str:
        """The page of the robot: one HTML file that shows it in motion, with its table and its functions.

        Fields have sliders, which begin at the values of the robot.
        `ValueError` where a field has no value.
        """
        return self._arm.page()

    def _repr_html_(self) -> str:
        """The page, in a notebook; or which fields need a value for it."""
        try:
            page = html.escape(self.page())
        except ValueError as error:
            return f"<pre>{html.escape(repr(self))}<br>{html.escape(str(error))}</pre>"
        return f'<iframe srcdoc="{page}" width="100%" height="640" style="border:0"></iframe>'

    def __reduce__(self) -> tuple[Any, ...]:
        values = {name: x for name, x in self.fields.items() if x == x}
        return Robot, (self._source, values)

    def __repr__(self) -> str:
        return f"<Robot {self._arm.name}: {', '.join(self.joint_names)}>"


class _Origin(Protocol):
    """The source that a robot is read from, also when it is unpickled."""

    def read(self) -> _native.Arm: ...


class _Identified:
    """A robot with identified base parameters."""

    def __init__(
        self, robot: Robot, parameters: list[float], friction: list[list[float]] | None
    ) -> None:
        self.robot, self.parameters, self.friction = robot, parameters, friction

    def read(self) -> _native.Arm:
        return self.robot._arm.identified(self.parameters, self.friction)


class _Source:
    """The text of a robot, and what is said beside it."""

    def __init__(self, path: str, text: str, entries: dict[str, Any]) -> None:
        fields = entries.pop("fields", None)
        self.values: dict[str, float] = dict(fields) if isinstance(fields, Mapping) else {}
        names: Iterable[Any] = entries.pop("functions", None) or ()
        functions = [names] if isinstance(names, str) else list(names)
        if any(not isinstance(name, str) for name in functions):
            # A method of several functions is an entry.
            entries["functions"], functions = functions, []
        self.options = {
            "path": path,
            "text": text,
            "functions": functions or None,
            "chain": _words(entries.pop("chain", None)),
            "ignore": _words(entries.pop("ignore", None)) or [],
            "round_angles": entries.pop("round_angles", None),
            "fields": None if fields is None else list(fields),
        }
        self.options["entries"] = _toml.document(_in_files(entries))

    def read(self) -> _native.Arm:
        return _native.Arm(**self.options)


def _in_files(entries: Mapping[str, Any]) -> dict[str, Any]:
    """Entries by their names in files, where each frame has a table `frame` of its own, and names come first.

    `None` and empty mappings, which a program may come to, say nothing.
    """

    def says(entry: Any) -> bool:
        return entry is not None and not (isinstance(entry, Mapping) and not entry)

    said = {name: entry for name, entry in entries.items() if says(entry)}
    named = {"frame" if name == "frames" else name: entry for name, entry in said.items()}
    names = {"let": named.pop("let")} if "let" in named else {}
    return {**names, **named}


def _words(given: str | Iterable[str] | None) -> list[str] | None:
    """Some names, of which a single one may stand alone."""
    if given is None:
        return None
    return [given] if isinstance(given, str) else list(given)
