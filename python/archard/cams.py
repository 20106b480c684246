"""A cam and its follower: how they slide on each other and wear.

>>> import archard
>>> worn = archard.cams.wear("cam_follower")
>>> sorted(worn.follower)
['error_of_wear_depth_tappet_m', 'place_m', 'wear_depth_tappet_m']
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from archard import _archard
from archard.case import Case
from archard.gears import _columns

if TYPE_CHECKING:
    from collections.abc import Mapping
    from os import PathLike

    import numpy as np
    from numpy.typing import NDArray

__all__ = ["Wear", "wear"]


@dataclass(frozen=True)
class Wear:
    """What a cam and its follower lose."""

    cam: dict[str, NDArray[np.float64]]
    """The columns of ``cam.csv``: a value an angle of the cam."""
    follower: dict[str, NDArray[np.float64]]
    """The columns of ``follower.csv``: a value a place on the face of the follower."""
    course: dict[str, NDArray[np.float64]]
    """The columns of ``course.csv``: a value a step, turns and the deepest wear."""
    life: tuple[str, float, float] | None
    """The body whose limit is reached first, after how many turns, and the error of that; ``None`` without."""


def wear(case: str | PathLike[str] | Mapping[str, object] | Case) -> Wear:
    """Wear the cam and the follower of a case with ``motion.cam``.

    Args:
        case: a built-in name, a file, a TOML text, a dict or a :class:`Case`.

    Raises:
        CaseError: all that is wrong with the case.
        ValueError: a case that is not one of a cam.

    """
    (cam, follower, course), met = _archard.wear_cam(Case(case)._compiled())
    columns = _columns(course)
    life = None if met is None else (met[0], float(columns["turns"][-1]), met[1])
    return Wear(_columns(cam), _columns(follower), columns, life)
