"""Two spur gears in mesh: shares of the load, sliding, and flanks that wear.

>>> import archard
>>> worn = archard.gears.wear("gear_flanks")
>>> f"{1e6 * worn.flanks['wear_depth_pinion_m'].max():.1f} um"
'58.8 um'
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from archard import _archard
from archard.case import Case

if TYPE_CHECKING:
    from collections.abc import Mapping
    from os import PathLike

    from numpy.typing import NDArray

__all__ = ["Wear", "wear"]


@dataclass(frozen=True)
class Wear:
    """What two gears lose."""

    flanks: dict[str, NDArray[np.float64]]
    """The columns of ``flanks.csv``: a value a station of the path of contact."""
    course: dict[str, NDArray[np.float64]]
    """The columns of ``course.csv``: a value a step, meshes of a flank and the deepest wear."""
    life: tuple[str, float, float] | None
    """The gear whose limit is reached first, after how many meshes, and the error of that; ``None`` without."""


def wear(case: str | PathLike[str] | Mapping[str, object] | Case) -> Wear:
    """Wear the flanks of a case with ``motion.mesh``.

    Args:
        case: a built-in name, a file, a TOML text, a dict or a :class:`Case`.

    Raises:
        CaseError: all that is wrong with the case.
        ValueError: a case that is not one of gears.

    """
    (flanks, course), met = _archard.wear_gears(Case(case)._compiled())
    columns = _columns(course)
    life = None if met is None else (met[0], float(columns["meshes"][-1]), met[1])
    return Wear(_columns(flanks), columns, life)


def _columns(rows: list[list[tuple[str, float]]]) -> dict[str, NDArray[np.float64]]:
    """Turn rows into columns."""
    return {name: np.array([row[at][1] for row in rows]) for at, (name, _) in enumerate(rows[0])}
