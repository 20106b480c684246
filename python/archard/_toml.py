"""Python values as TOML text. What they mean, and in which units, the reader of cases says."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any

from archard import _archard

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

_DOTTED = re.compile(r"[A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)*")


def key(name: object) -> str:
    """A key, dotted or not."""
    if not isinstance(name, str):
        raise TypeError(f"keys of a case are text, not {name!r}")
    return name if _DOTTED.fullmatch(name) else _text(name)


def value(given: object) -> str:
    """A value: text, number, truth, list or table, or a quantity with ``magnitude`` and ``units``."""
    if hasattr(given, "magnitude") and hasattr(given, "units"):
        return _quantity(given)
    if isinstance(given, os.PathLike):
        given = os.fspath(given)
    if hasattr(given, "tolist"):  # NumPy's scalars and arrays
        given = given.tolist()
    if isinstance(given, bool):
        return "true" if given else "false"
    if isinstance(given, str):
        return _text(given)
    if isinstance(given, int | float):
        return repr(given)
    if isinstance(given, Mapping):
        entries = (f"{key(name)} = {value(entry)}" for name, entry in given.items())
        return "{ " + ", ".join(entries) + " }"
    if isinstance(given, list | tuple):
        return "[" + ", ".join(map(value, given)) + "]"
    raise TypeError(f"a case takes text, numbers, lists and dicts, not {type(given).__name__}")


def document(table: Mapping[str, Any]) -> str:
    """A case file of a dict, a line a value."""
    return "".join(f"{line}\n" for line in _lines(table, ""))


def read(text: str) -> dict[str, Any]:
    """The dict of a TOML text."""
    return tomllib.loads(text)


def path(dotted: str) -> list[str]:
    """The names of a dotted key."""
    table: Any
    try:
        table = read(f"{dotted} = 0")
    except tomllib.TOMLDecodeError:
        table = {}
    names = []
    while isinstance(table, dict) and len(table) == 1:
        [(name, table)] = table.items()
        names.append(name)
    if not names or table != 0:
        raise KeyError(dotted)
    return names


def leaves(table: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """All values by their dotted keys."""
    for name, entry in table.items():
        own = f"{prefix}{key(name)}"
        if isinstance(entry, Mapping):
            yield from leaves(entry, f"{own}.")
        else:
            yield own, entry


def frozen(given: Any) -> Any:
    """The same, unchangeable: a change of a copy would be lost without a word."""
    if isinstance(given, dict):
        return MappingProxyType({name: frozen(entry) for name, entry in given.items()})
    return tuple(map(frozen, given)) if isinstance(given, list) else given


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007F")


def _lines(table: Mapping[str, Any], prefix: str) -> Iterator[str]:
    for name, entry in table.items():
        if isinstance(entry, Mapping) and entry:
            yield from _lines(entry, f"{prefix}{key(name)}.")
        else:
            yield f"{prefix}{key(name)} = {value(entry)}"


def _quantity(given: Any) -> str:
    """Numbers with the symbol of their unit, as case files write it: ``2 MPa*mm**2`` is ``2 MPa mm^2``.

    Units that case files do not know, as pound-force, are taken by base units.
    """
    symbol = _symbol(given)
    if not _archard.knows_unit(symbol) and hasattr(given, "to_base_units"):
        given = given.to_base_units()
        symbol = _symbol(given)
    magnitude = given.magnitude
    magnitude = magnitude.tolist() if hasattr(magnitude, "tolist") else magnitude
    if isinstance(magnitude, list | tuple):
        return value([f"{one!r} {symbol}".strip() for one in magnitude])
    return value(f"{magnitude!r} {symbol}" if symbol else magnitude)


def _symbol(given: Any) -> str:
    try:
        symbol = format(given.units, "~C")
    except (TypeError, ValueError):  # not pint's
        symbol = str(given.units)
    return symbol.replace("**", "^").replace("*", " ")
