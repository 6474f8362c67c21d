"""Answers of a robot about its functions."""

from __future__ import annotations

from typing import NamedTuple


class Operations(NamedTuple):
    """Operations of a program at one state."""

    multiplications: int
    additions: int
    divisions: int
    sin_cos: int
    """Pairs of a sine and a cosine."""
    exponentials: int

    @property
    def total(self) -> int:
        """Multiplications, additions and divisions together."""
        return self.multiplications + self.additions + self.divisions


class Formulas(str):
    """Formulas as text, one line for each equation."""

    equations: list[str]
    legend: list[str]
    """The meanings of the letters that the formulas have besides q, qd, qdd and tau."""

    def __new__(cls, equations: list[str], legend: list[str]) -> Formulas:
        letters = [f"with {', '.join(legend)}"] if legend else []
        formulas = super().__new__(cls, "\n".join(equations + letters))
        formulas.equations, formulas.legend = equations, legend
        return formulas

    def __reduce__(self) -> tuple[type[Formulas], tuple[list[str], list[str]]]:
        return Formulas, (self.equations, self.legend)


class Compared(NamedTuple):
    """A function beside Newton-Euler."""

    function: str
    error: float
    """The largest error, relative to the natural scale of the values."""
    tolerance: float
    """The largest error that passes."""


class Report:
    """The comparison of a robot's functions with Newton-Euler. It is true if all of them pass."""

    def __init__(
        self, text: str, ok: bool, functions: list[tuple[str, float, float]]
    ) -> None:
        self.text = text
        self.ok = ok
        self.functions = [Compared(*function) for function in functions]

    def __bool__(self) -> bool:
        return self.ok

    def __str__(self) -> str:
        return self.text

    __repr__ = __str__
