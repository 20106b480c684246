"""Units that columns and fields end in, and values as they are usually written."""

from __future__ import annotations

from archard import _archard

_WRITTEN = {"m2": "m^2", "m3": "m^3", "Nm": "N m", "m3_per_Nm": "m^3/(N m)"}


def unit(name: str) -> str:
    """Return the unit that a column or field ends in; empty for pure numbers."""
    known = _ending(name)
    return _WRITTEN.get(known, known)


def bare(name: str) -> str:
    """Return a name without its unit."""
    known = _ending(name)
    return name.removesuffix(f"_{known}") if known else name


def shown(name: str, value: float) -> str:
    """Return a value of a column in the unit it is usually written in: 2.05 µm, 15.7 MPa."""
    return _archard.quantity(value, _ending(name))


def _ending(name: str) -> str:
    return next((known for known in _archard.UNITS if name.endswith(f"_{known}")), "")
