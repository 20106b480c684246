"""What a case can name: materials, and laws of wear and friction."""

from __future__ import annotations

from typing import NamedTuple

from archard import _archard


class Material(NamedTuple):
    """A material that a case can name, with what handbooks say of it at room temperature; SI."""

    name: str
    state: str
    """What it is, in the state that its hardness belongs to."""
    young: float
    """Young's modulus (Pa)."""
    poisson: float
    """Poisson's ratio."""
    density: float
    """Density (kg/m^3)."""
    hardness: float | None
    """Indentation hardness (Pa); ``None`` where it is not known."""
    conductivity: float | None
    """Thermal conductivity (W/(m K))."""
    heat: float | None
    """Specific heat (J/(kg K))."""
    source: str
    """Where the values are from."""


class Key(NamedTuple):
    """A key that a law takes."""

    name: str
    unit: str
    """Its unit in SI; empty of numbers and words."""
    meaning: str
    required: bool


class KnownLaw(NamedTuple):
    """A law that a case can name."""

    key: str
    """Where it stands: ``wear.NAME`` in the table of a body, or ``friction.NAME`` in the case."""
    meaning: str
    """Its formula, in words, and the motions it suits."""
    keys: list[Key]
    """What it takes."""
    source: str
    """Who has published it, or what it follows from."""
    example: str
    """What it takes, as TOML."""


def materials() -> list[Material]:
    """Return the materials that a case can name.

    >>> import archard
    >>> {one.name: one.young for one in archard.materials()}["100Cr6"]
    210000000000.0

    """
    return [
        Material(name, state, *known, *perhaps, source)
        for name, state, source, known, perhaps in _archard.materials()
    ]


def laws() -> list[KnownLaw]:
    """Return the laws of wear, then those of friction, that a case can name.

    >>> import archard
    >>> [key.name for key in archard.laws()[0].keys]
    ['coefficient', 'k_ad', 'hardness']

    """
    return [
        KnownLaw(key, meaning, [Key(*one) for one in keys], *about)
        for key, meaning, keys, *about in _archard.laws()
    ]
