"""A railway wheel on its rail: patches of contact, creepages and forces.

>>> import archard
>>> contact = archard.rail.Contact("manchester")
>>> patches = contact(shift=3e-3, yaw=7.2e-3)  # doctest: +SKIP
>>> patches[0]["normal_force_N"]  # doctest: +SKIP
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

    from numpy.typing import ArrayLike, NDArray

__all__ = ["Contact", "Wear", "contact", "wear"]

Patch = dict[str, float | str]


class Contact:
    """A wheel over its rail. Profiles are read once, so that a vehicle model may ask for thousands of contacts."""

    def __init__(self, case: str | PathLike[str] | Mapping[str, object] | Case) -> None:
        """Read a case with ``motion.wheel_rail``: a built-in name, a file, a TOML text, a dict or a :class:`Case`.

        Raises:
            CaseError: all that is wrong with it.

        """
        self._wheel_rail = _archard.WheelRail(Case(case)._compiled())

    def __call__(self, **values: float) -> list[Patch]:
        """Return the patches, from the field side to the flange, each a dict of columns as in ``contacts.csv``.

        Args:
            values: values of the motion in SI in place of those of the case: ``shift`` (m), ``yaw``, ``roll``
                (rad), ``wheel_load`` (N), ``speed``, ``lateral_speed``, ``vertical_speed`` (m/s),
                ``pitch_rate``, ``yaw_rate``, ``roll_rate`` (rad/s).

        Raises:
            ValueError: a value that is unknown, or cannot be used.
            RunError: there is no such contact.

        """
        patches: list[Patch] = []
        for side, columns in self._wheel_rail.contact(list(values.items())):
            patch: Patch = {"side": side}
            patch.update(columns)
            patches.append(patch)
        return patches


def contact(case: str | PathLike[str] | Mapping[str, object] | Case, **values: float) -> list[Patch]:
    """Return the patches of one contact; :class:`Contact` reads the case once for many."""
    return Contact(case)(**values)


@dataclass(frozen=True)
class Wear:
    """What a route wears off wheel and rail. Lists of rows are what ``pandas.DataFrame`` takes."""

    contacts: list[dict[str, float | str]]
    """A row a patch, as in ``contacts.csv``: of new profiles, then of worn ones."""
    dimensions: list[dict[str, float | str]]
    """A row a step, as in ``dimensions.csv``: worn area, depths and flange, each with its error."""
    profiles: dict[tuple[str, str], dict[str, NDArray[np.float64]]]
    """The columns of ``wear.csv`` by body (``"wheel"``, ``"rail"``) and side."""


def wear(
    case: str | PathLike[str] | Mapping[str, object] | Case,
    route: Mapping[str, ArrayLike] | None = None,
    *,
    threads: int | None = None,
) -> Wear:
    """Send a wheelset over its route.

    Args:
        case: a case with ``motion.wheel_rail``: a built-in name, a file, a TOML text, a dict or a :class:`Case`.
        route: columns of operating points in SI (a dict or a ``pandas.DataFrame``) in place of the route of the
            case: ``share`` and any of ``shift``, ``yaw``, ``roll``, ``curvature``, ``wheel_load``, ``friction``,
            ``speed`` and the rates.
        threads: how many to use; as many as there are processors if not given.

    Raises:
        CaseError: all that is wrong with the case.
        ValueError: a column or a value that cannot be used.
        RunError: a contact is not found, or the wear goes deeper than a profile reaches.

    """
    columns = None
    if route is not None:
        columns = [(str(name), np.asarray(route[name], dtype=float).ravel().tolist()) for name in route]
    wheel_rail = _archard.WheelRail(Case(case)._compiled())
    contacts, dimensions, profiles = wheel_rail.travel(columns, threads)
    patches: list[dict[str, float | str]] = []
    for at, (side, row) in contacts:
        patch: dict[str, float | str] = {}
        if at is not None:
            point, worn = at
            patch.update({"profiles": "worn" if worn else "new", "point": point})
        patch["side"] = side
        patch.update(row)
        patches.append(patch)
    steps: list[dict[str, float | str]] = []
    for side, row in dimensions:
        step: dict[str, float | str] = {"side": side}
        step.update(row)
        steps.append(step)
    shapes = {(body, side): {name: np.array(values) for name, values in own} for body, side, own in profiles}
    return Wear(patches, steps, shapes)
