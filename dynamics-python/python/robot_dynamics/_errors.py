"""Exceptions of the package."""

from __future__ import annotations

from typing import NamedTuple


class Mistake(NamedTuple):
    """A mistake in a file or in the entries beside it."""

    file: str | None
    """The file, `TOML` of a text; none if the mistake is in the entries beside it."""
    line: int
    """The line, counted from 1; of entries beside a file, the line among these."""
    column: int
    """The column of the first letter, counted from 1."""
    text: str
    """The mistake, and what was expected."""

    def __str__(self) -> str:
        return self.text if self.file is None else f"{self.file}:{self.line}:{self.column}: {self.text}"


class TableError(ValueError):
    """A file or a table says something else than a robot: all mistakes in it, from the top to the end.

    `file`, `line`, `column` and `text` are those of the first one.
    """

    def __init__(self, mistakes: list[Mistake]) -> None:
        super().__init__(mistakes)
        self.mistakes = mistakes

    @property
    def file(self) -> str | None:
        return self.mistakes[0].file

    @property
    def line(self) -> int:
        return self.mistakes[0].line

    @property
    def column(self) -> int:
        return self.mistakes[0].column

    @property
    def text(self) -> str:
        return self.mistakes[0].text

    def __str__(self) -> str:
        return "\n".join(map(str, self.mistakes))


def table_error(mistakes: list[tuple[str | None, int, int, str]]) -> TableError:
    """The error of mistakes that the native part has found."""
    return TableError([Mistake(*mistake) for mistake in mistakes])


class SingularMassMatrix(ArithmeticError):
    """M(q) is not positive definite to working precision, or not finite: the pivot of a joint failed."""

    def __init__(self, index: tuple[int, ...], joint: str, reason: str) -> None:
        super().__init__(index, joint, reason)
        self.index = index
        """The first such state, by its index along each of the leading axes: `()` of a single one."""
        self.joint = joint
        """The name of the joint."""
        self.reason = reason

    def __str__(self) -> str:
        state = f"state {list(self.index)}: " if self.index else ""
        return f"{state}joint {self.joint!r}: {self.reason}"
