"""Robots: files and tables read, their functions as methods."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _native, _toml
from ._native import Function

_TEXT = "TOML"
"""The name of a text in messages."""


class Robot:
    """A robot, read from a file or a table. Its functions are methods, each derived at its first call and kept.

    Every entry of a table may be a keyword: `gravity`, `base`, `tool`, `lock`, `allow`, `frames`, `couple`, `joints`,
    `neglect`, and so on. Beside a file they add to its entries, or take their place. A float is read as its shortest
    decimal, and a string is an expression such as `"PI/2"` or `"deg(90)"`. Further keywords:

    `functions`: the names of the functions, `default` for those that a table without names has.
    `fields`: names that cells may use without a value; a mapping gives values, too.
    `chain`, `ignore`, `round_angles`: of URDF files; the first and the last link of the arm, joints that are left out,
    and the distance from a quarter turn, rad, within which an angle is taken for it.

    All mistakes of a file are in one `TableError`.
    """

    christoffel: Function
    coriolis_matrix: Function
    coriolis_vector: Function
    forward_dynamics: Function
    forward_kinematics: Function
    friction_vector: Function
    gravity_vector: Function
    inverse_dynamics: Function
    jacobian: Function
    kinetic_energy: Function
    mass_matrix: Function
    potential_energy: Function

    def __init__(self, source: _Source, fields: Mapping[str, float]) -> None:
        self._source = source
        arm = source.read()
        self._set(arm.with_fields(list(fields.items())) if fields else arm)

    def _set(self, arm: _native.Arm) -> None:
        self._arm = arm
        self._functions = dict(arm.functions)
        # Attributes of the instance: a call finds its function without a search by name.
        self.__dict__.update(self._functions)

    @classmethod
    def from_file(cls, path: str | os.PathLike[str], **entries: Any) -> Robot:
        """The robot of a file: a table in TOML or in JSON, or a URDF file."""
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
        table = {"convention": convention, "joint": joint}
        return cls._read(_TEXT, _toml.document(table), entries)

    @classmethod
    def _read(cls, path: str, text: str, entries: dict[str, Any]) -> Robot:
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

    def __reduce__(self) -> tuple[Any, ...]:
        values = {name: x for name, x in self.fields.items() if x == x}
        return Robot, (self._source, values)

    def __repr__(self) -> str:
        return f"<Robot {self._arm.name}: {', '.join(self.joint_names)}>"


class _Source:
    """The text of a robot, and what is said beside it."""

    def __init__(self, path: str, text: str, entries: dict[str, Any]) -> None:
        fields = entries.pop("fields", ())
        self.values: dict[str, float] = dict(fields) if isinstance(fields, Mapping) else {}
        names: Iterable[Any] = entries.pop("functions", None) or ()
        functions = list(names)
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
            "fields": list(fields),
        }
        self.options["entries"] = _toml.document(entries)

    def read(self) -> _native.Arm:
        return _native.Arm(**self.options)


def _words(given: str | Iterable[str] | None) -> list[str] | None:
    """Some names, of which a single one may stand alone."""
    if given is None:
        return None
    return [given] if isinstance(given, str) else list(given)
