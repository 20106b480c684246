"""Measured surfaces: arrays as files of a case, and what is in one."""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from archard import _archard, _toml

#: Lengths (m) by the names that packages give them.
_UNITS = {
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), 1.0),
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), 1e-3),
    **dict.fromkeys(("um", "\u00b5m", "\u03bcm", "micron", "microns", "micrometer", "micrometre"), 1e-6),
    **dict.fromkeys(("micrometers", "micrometres"), 1e-6),
    **dict.fromkeys(("nm", "nanometer", "nanometers", "nanometre", "nanometres"), 1e-9),
    **dict.fromkeys(("\u00c5", "\u212b", "A", "angstrom", "angstroms"), 1e-10),
    **dict.fromkeys(("pm", "picometer", "picometers", "picometre", "picometres"), 1e-12),
}
#: How far (steps) coordinates may be from equal ones: those of few digits are rounded.
_OFF = 0.01
#: What the names of files of arrays begin with.
PREFIX = "heights-"

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Surface:
    """A measured surface as a case has it, and its texture after ISO 25178-2; all in SI."""

    heights: Array
    """Heights (m) in rows along x, the first of the lowest y; NaN where nothing was measured."""
    pixel: tuple[float, float]
    """Distance (m) of points along x and y."""
    texture: dict[str, float]
    """``Sa``, ``Sq``, ``Sp``, ``Sv``, ``Sz`` (m), ``Ssk``, ``Sku``, ``Sdq`` and ``Sdr`` (1)."""

    @property
    def size(self) -> tuple[float, float]:
        """Size (m) along x and y, of whole pixels."""
        ny, nx = self.heights.shape
        return (nx * self.pixel[0], ny * self.pixel[1])

    @property
    def missing(self) -> int:
        """How many points were not measured."""
        return int(np.isnan(self.heights).sum())

    def __repr__(self) -> str:
        ny, nx = self.heights.shape
        return f"Surface({nx} x {ny} points, Sa={self.texture['Sa']:.4g} m, missing={self.missing})"


def surface(source: Any, **keys: Any) -> Surface:
    """Read a measured surface and its texture, as ``archard surface`` prints it.

    Args:
        source: a file, or what a case takes in its place: an array, an xarray ``DataArray``, or a surface of
            SurfaceTopography or surfalize.
        keys: keys of ``profile.surface``, as ``pixel="2 um"``, ``unit="um"``, ``level="plane"``.

    Raises:
        CaseError: what is wrong with the file or a key.
        TypeError: a source that is no surface.
        ValueError: coordinates that are not equally spaced.

    """
    held: dict[str, Any] = {}
    tree = laid({"profile": {"surface": {"file": source, **keys}}}, held)
    file = _archard.CaseFile("surface", _toml.document(tree), Path.cwd(), [])
    heights, pixel, texture = _archard.read_surface(file)
    return Surface(heights, pixel, dict(texture))


def laid(tree: Mapping[str, Any], held: dict[str, Any], within: str = "") -> dict[str, Any]:
    """Return a tree in which files stand where surfaces stood; their arrays are held by file."""
    done: dict[str, Any] = {}
    for name, entry in tree.items():
        whole = f"{within}.{name}"
        if isinstance(entry, Mapping):
            done[name] = laid(entry, held, whole)
            continue
        done[name] = entry
        taken = _taken(entry) if whole.endswith(".surface.file") else None
        if taken is not None:
            heights, keys = taken
            done[name] = stage(heights)
            held[done[name]] = heights
            # What is said in words counts.
            table = str(name).removesuffix("file")
            if f"{table}pixel" in tree:
                keys.pop("pixel_y", None)
            own = {f"{table}{key}": value for key, value in keys.items()}
            done.update({key: value for key, value in own.items() if key not in tree})
    return done


def stage(array: NDArray[Any]) -> str:
    """Return a file of an array that stays as long as this process; equal arrays have the same."""
    return str(write(array, Path(_stage().name)))


def write(array: NDArray[Any], folder: Path) -> Path:
    """Write an array into a folder, under a name that follows from what is in it."""
    data = np.ascontiguousarray(array)
    digest = hashlib.blake2b(f"{data.shape}{data.dtype.str}".encode(), digest_size=8)
    digest.update(data.tobytes())
    path = folder / f"{PREFIX}{digest.hexdigest()}.npy"
    if not path.exists():
        folder.mkdir(parents=True, exist_ok=True)
        part = path.with_suffix(f".{os.getpid()}.part")
        with part.open("wb") as file:
            np.save(file, data, allow_pickle=False)
        part.replace(path)
    return path


@cache
def _stage() -> tempfile.TemporaryDirectory[str]:
    return tempfile.TemporaryDirectory(prefix="archard-surfaces-")


def _taken(given: Any) -> tuple[Array, dict[str, str]] | None:
    """Return heights in rows along x, and keys that say their scale; ``None`` of what is no surface."""
    take = next((take for fits, take in _KINDS if fits(given)), None)
    if take is None:
        return None
    heights, steps, unit = take(given)
    if np.ndim(heights) != 2:
        raise ValueError(f"heights of a surface have two axes, not {np.ndim(heights)}")
    if heights.dtype.kind not in "fiu":
        raise TypeError(f"heights of a surface are numbers, not {heights.dtype}")
    heights = np.ma.filled(heights.astype(float), np.nan)
    keys = {}
    if steps is not None:
        keys["pixel"], keys["pixel_y"] = (f"{float(step)!r} m" for step in steps)
    if unit in ("m", "mm", "um", "nm"):
        keys["unit"] = unit
    elif unit is not None:
        heights, keys["unit"] = heights * _length(unit), "m"
    return heights, keys


_Taken = tuple[Any, tuple[float, float] | None, str | None]


def _of_xarray(given: Any) -> _Taken:
    if len(given.dims) != 2:
        raise ValueError(f"heights of a surface have two axes, not {len(given.dims)}: {given.dims}")
    rows, columns = ("y", "x") if set(given.dims) == {"x", "y"} else given.dims
    given = given.transpose(rows, columns)
    heights, steps = given.values, []
    for axis, name in ((1, columns), (0, rows)):
        if name not in given.coords:
            continue
        places = np.asarray(given.coords[name].values, float)
        step = (places[-1] - places[0]) / max(len(places) - 1, 1)
        equal = places[0] + step * np.arange(len(places))
        if not step or not np.all(np.abs(places - equal) <= _OFF * abs(step)):
            raise ValueError(f"the coordinate `{name}` is not equally spaced: interpolate onto equal steps first")
        if step < 0:
            heights = np.flip(heights, axis)
        unit = _unit_of(given.coords[name])
        if unit is None:
            raise ValueError(f"the coordinate `{name}` has no unit: set its attribute `units`, as in `um`")
        steps.append(abs(step) * _length(unit))
    if len(steps) == 1:
        raise ValueError("one axis has a coordinate, and one has none: give both")
    return heights, (steps[0], steps[1]) if steps else None, _unit_of(given)


def _of_surface_topography(given: Any) -> _Taken:
    # Its heights have x first.
    heights = given.heights().T
    if np.ndim(heights) != 2:
        raise ValueError("a profile of SurfaceTopography is no surface")
    unit = given.unit
    sizes = given.physical_sizes
    scale = 1.0 if unit is None else _length(unit)
    steps = [scale * size / count for size, count in zip(sizes, given.nb_grid_pts, strict=True)]
    return heights, (steps[0], steps[1]) if unit is not None else None, unit


def _of_surfalize(given: Any) -> _Taken:
    return given.data, (1e-6 * given.step_x, 1e-6 * given.step_y), "um"


def _has(*names: str) -> Callable[[Any], bool]:
    return lambda given: all(hasattr(given, name) for name in names)


#: How a surface of a package is told, and what it tells: heights, distances (m) along x and y, unit.
_KINDS: list[tuple[Callable[[Any], bool], Callable[[Any], _Taken]]] = [
    (_has("dims", "coords", "attrs", "values"), _of_xarray),
    (_has("heights", "physical_sizes", "nb_grid_pts", "unit"), _of_surface_topography),
    (_has("data", "step_x", "step_y"), _of_surfalize),
    (lambda given: isinstance(given, np.ndarray), lambda given: (given, None, None)),
]


def _unit_of(given: Any) -> str | None:
    unit = given.attrs.get("units", given.attrs.get("unit"))
    return None if unit is None else str(unit).strip()


def _length(unit: str) -> float:
    """A unit in metres."""
    try:
        return _UNITS[unit.strip()]
    except KeyError:
        raise ValueError(f"`{unit}` is no unit of length: um, nm, mm or m") from None
