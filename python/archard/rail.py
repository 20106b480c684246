"""A railway wheel on its rail: patches of contact, creepages and forces.

>>> import archard
>>> contact = archard.rail.Contact("manchester")
>>> patches = contact(shift=3e-3, yaw=7.2e-3)  # doctest: +SKIP
>>> patches[0]["normal_force_N"]  # doctest: +SKIP
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archard import _archard
from archard.case import Case

if TYPE_CHECKING:
    from collections.abc import Mapping
    from os import PathLike

__all__ = ["Contact", "contact"]

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
