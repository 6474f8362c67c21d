"""Keywords that nobody knows, those that were probably meant, and values of other kinds than expected."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping, Sequence
from typing import Any


def require_known(given: Iterable[str], known: Sequence[str]) -> None:
    """`TypeError` of the first keyword that is not known."""
    for name in given:
        if name not in known:
            meant = difflib.get_close_matches(name, known, 1, 0.7)
            hint = f"did you mean `{meant[0]}`?" if meant else f"expected one of {', '.join(known)}"
            raise TypeError(f"unknown keyword `{name}`: {hint}")


def require_kinds(error: TypeError, given: Mapping[str, Any]) -> None:
    """Raises the error of an entry that the native module does not take, in the caller's words; passes over others."""
    before, _, name = str(error).rpartition(".")
    if before.startswith("failed to extract field") and name in given:
        raise TypeError(f"`{name}` is {given[name]!r}: {error.__cause__}") from None
