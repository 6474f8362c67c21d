"""Keywords that nobody knows, and those that were probably meant."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence


def require_known(given: Iterable[str], known: Sequence[str]) -> None:
    """`TypeError` of the first keyword that is not known."""
    for name in given:
        if name not in known:
            meant = difflib.get_close_matches(name, known, 1, 0.7)
            hint = f"did you mean `{meant[0]}`?" if meant else f"expected one of {', '.join(known)}"
            raise TypeError(f"unknown keyword `{name}`: {hint}")
