"""What is worn between two scans of a surface."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from archard import _archard, _surface, _toml

#: Keys of ``profile.surface`` that would take off a part of what is worn, each in its own way before and after.
_WITH_WEAR = ("level", "form", "rough")


class Uncertain(NamedTuple):
    """A value in SI with its uncertainty."""

    value: float
    standard_uncertainty: float
    interval: tuple[float, float]
    """The 95 % interval."""


@dataclass(frozen=True, repr=False)
class Difference:
    """What is worn between two scans; prints what ``archard compare --before A --after B`` prints."""

    change: NDArray[np.float64]
    """The later surface above the earlier one (m) in rows along x, negative where worn; NaN where one has none."""
    regions: NDArray[np.int8]
    """-1 in a worn region, 1 in one that is piled up, 0 elsewhere."""
    pixel: tuple[float, float]
    """Distance (m) of points along x and y."""
    summary: dict[str, Any] = field()
    """All numbers, as the command writes them to ``difference.json``."""
    text: str = field()
    """What was found, in words."""

    @property
    def worn_volume(self) -> Uncertain:
        """The volume (m3) worn off."""
        return _uncertain(self.summary["worn_volume_m3"])

    @property
    def piled_volume(self) -> Uncertain | None:
        """The volume (m3) piled up; None where nothing stands out."""
        own = self.summary["piled_volume_m3"]
        return None if own is None else _uncertain(own)

    @property
    def net_volume(self) -> Uncertain:
        """The volume (m3) worn off less that piled up."""
        return _uncertain(self.summary["net_volume_m3"])

    @property
    def depth(self) -> Uncertain:
        """The greatest depth (m)."""
        return _uncertain(self.summary["depth_m"])

    def __repr__(self) -> str:
        return self.text


def difference(
    before: Any,
    after: Any,
    *,
    worn: str | None = None,
    turn: float = 5.0,
    placed: bool = False,
    set_before: Mapping[str, Any] | None = None,
    set_after: Mapping[str, Any] | None = None,
    **keys: Any,
) -> Difference:
    """Return what is worn between two scans of a surface, as ``archard compare --before A --after B`` does.

    Args:
        before: the scan before the test: a file, or what a case takes in its place, as in :func:`surface`.
        after: the scan of the same place after it.
        worn: the part of the later scan in which wear is to be found, from its middle, as
            ``"-0.2 mm,0.2 mm,-1 mm,1 mm"``; all else did not wear.
        turn: the largest turn between the scans that is sought, in degrees.
        placed: whether both scans have the same middle and neither is turned.
        set_before: keys of ``profile.surface`` of the scan before the test alone.
        set_after: those of the scan after it alone.
        keys: keys of both, as ``pixel="2 um"``.

    Raises:
        CaseError: what is wrong with a file or a key.
        TypeError: a source that is no surface.
        ValueError: scans between which no difference can be told, and why.

    """
    files, names, held = [], [], []
    for source, own, name in [(before, set_before, "before"), (after, set_after, "after")]:
        given = {**keys, **(own or {})}
        for key in _WITH_WEAR:
            if key in given:
                raise ValueError(
                    f"`{key}` takes off a part of what is worn, too; leave it out: "
                    "the scans are levelled by what did not wear"
                )
        arrays: dict[str, Any] = {}
        tree = _surface.laid({"profile": {"surface": {"file": source, **given}}}, arrays)
        files.append(_archard.CaseFile(name, _toml.document(tree), Path.cwd(), []))
        names.append(str(source) if isinstance(source, (str, Path)) else name)
        held.append(arrays)
    lines, numbers, change, regions, pixel = _archard.scan_difference(files, names, (worn, turn, placed))
    return Difference(change, regions, pixel, json.loads(numbers), "\n".join(lines))


def _uncertain(own: dict[str, Any]) -> Uncertain:
    low, high = own["interval_95"]
    return Uncertain(own["value"], own["standard_uncertainty"], (low, high))
