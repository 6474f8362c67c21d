"""Entries of Python as text in TOML, in which tables of robots are written."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from numbers import Integral, Real
from typing import Any


def document(entries: Mapping[str, Any]) -> str:
    """The entries as lines, one each, so that a mistake in one has its line."""
    return "".join(f"{key(name)} = {value(entry)}\n" for name, entry in entries.items())


def key(name: str) -> str:
    """A key, in quotes unless it is a plain word."""
    is_plain = name.isascii() and name.replace("_", "").replace("-", "").isalnum()
    return name if is_plain else string(name)


def string(text: str) -> str:
    """A string. JSON's escapes are those of TOML."""
    return json.dumps(text).replace("\x7f", "\\u007f")


def value(entry: Any) -> str:
    """A value. A float is its shortest decimal; a string may be an expression, `"PI/2"`."""
    if isinstance(entry, str):
        return string(entry)
    if isinstance(entry, bool):
        return "true" if entry else "false"
    if isinstance(entry, Integral):
        return str(int(entry))
    if isinstance(entry, Real):
        return number(float(entry))
    if isinstance(entry, Mapping):
        cells = (f"{key(name)} = {value(cell)}" for name, cell in entry.items())
        return "{ " + ", ".join(cells) + " }"
    if hasattr(entry, "tolist"):
        return value(entry.tolist())
    if isinstance(entry, Iterable):
        return "[" + ", ".join(map(value, entry)) + "]"
    raise TypeError(f"expected a number, a string, a list or a dict, found {entry!r}")


def number(x: float) -> str:
    """A float as its shortest decimal."""
    if not math.isfinite(x):
        raise ValueError(f"expected a finite number, found {x}")
    return repr(x)
