"""Fields of results as xarray datasets, on one grid where theirs differ."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from archard import _archard
from archard._errors import ArchardWarning
from archard._units import bare, unit

if TYPE_CHECKING:
    from archard._snapshot import Snapshot
    from archard.result import Result

Array = NDArray[np.float64]

#: Share of the free memory beyond which taking it is worth a warning.
_LARGE = 0.5
#: How far apart, relative to the largest, progresses may be that count as one.
_SAME = 1e-9


class Grid(NamedTuple):
    """Centres of equal elements along x and y (m)."""

    x: Array
    y: Array


def dataset(
    results: Sequence[Result | None],
    design: dict[str, int],
    fields: Iterable[str] | None,
    grid: Any,
) -> Any:
    """Return the fields of results that fill a design, given by its axes and their lengths, as a dataset.

    Raises:
        ImportError: xarray is missing.
        ValueError: no result has fields, no field has such a name, or the fields lie on no common grid.
        MemoryError: the dataset would take more memory than is free.

    """
    import xarray

    outputs = [[] if one is None else one.fields for one in results]
    last = [own[-1] for own in outputs if len(own)]
    if not last:
        raise ValueError("no result has fields" if design else "the result has no fields")
    names = _names(last[0], fields)
    places = _places(last, grid)
    progress, at = _progress([np.array([one.progress for one in own]) for own in outputs])
    space = tuple(len(values) for values in places.values())
    shape = (*design.values(), progress.size, *space)
    _hold(math.prod(shape) * len(names), space, len(last))
    arrays = {name: np.full((len(results), progress.size, *space), np.nan) for name in names}
    for row, own in enumerate(outputs):
        for index, one in zip(at[row], own, strict=True):
            for name in names:
                if name in one.names:
                    arrays[name][row, index] = _laid(one, name, places)
    dims = (*design, "progress", *places)
    variables = {
        bare(name): (dims, values.reshape(shape), {"units": unit(name)}) for name, values in arrays.items()
    }
    column = next(iter(next(one for one in results if one is not None and len(one.fields)).history))
    coordinates: dict[str, Any] = {
        "progress": ("progress", progress, {"units": unit(column), "long_name": bare(column)})
    }
    if "pair" in places:
        for axis, values in (("x", last[0].x), ("y", last[0].y), ("z", last[0].z)):
            coordinates[axis] = ("pair", values, {"units": "m"})
    else:
        coordinates.update({axis: (axis, values, {"units": "m"}) for axis, values in places.items()})
    return xarray.Dataset(variables, coordinates)


def _names(one: Snapshot, fields: Iterable[str] | None) -> list[str]:
    """Return the fields that are asked for; all with one value a place if none are."""
    numbers = [name for name in one.names if one[name].ndim == (2 if one.z is None else 1)]
    if fields is None:
        return numbers
    if isinstance(fields, str):
        raise ValueError(f"`fields` is a list of names, as [{fields!r}]")
    known = {bare(name): name for name in numbers} | {name: name for name in numbers}
    asked = list(fields)
    for name in asked:
        if name not in known:
            raise ValueError(f"no field `{name}`; there are {', '.join(map(bare, numbers))}")
    return list(dict.fromkeys(known[name] for name in asked))


def _places(last: Sequence[Snapshot], grid: Any) -> dict[str, Array]:
    """Return the places that all fields are laid on, by their axis."""
    meshed = [one for one in last if one.z is not None]
    if meshed:
        if grid is not None or len(meshed) < len(last):
            raise ValueError("pairs of meshed bodies lie on no grid")
        count = meshed[0].x.size
        if any(one.x.size != count for one in meshed):
            raise ValueError(f"the meshes differ: {sorted({one.x.size for one in meshed})} pairs")
        return {"pair": np.arange(count, dtype=float)}
    found = common(last) if grid is None else of(grid)
    return {"y": found.y, "x": found.x}


def of(given: Any) -> Grid:
    """Return the grid that is meant: of places along x and y, of a result, or of anything with ``x`` and ``y``."""
    if hasattr(given, "fields") and not hasattr(given, "x"):
        if not len(given.fields):
            raise ValueError("the result that gives the grid has no fields")
        given = given.fields[-1]
    if hasattr(given, "x") and hasattr(given, "y"):
        given = (given.x, given.y)
    try:
        x, y = (np.asarray(axis, float) for axis in given)
    except (TypeError, ValueError):
        raise ValueError("a grid is a result, a dataset, or places along x and y (m): (x, y)") from None
    for name, axis in (("x", x), ("y", y)):
        steps = np.diff(axis) if axis.ndim == 1 else np.empty(0)
        if axis.ndim != 1 or not axis.size or not np.all(steps > 0.0):
            raise ValueError(f"places along {name} are a list of rising numbers (m)")
        if steps.size and np.ptp(steps) > 1e-6 * steps.max():
            raise ValueError(f"places along {name} are equally spaced: the centres of equal elements")
    return Grid(x, y)


def common(last: Sequence[Snapshot]) -> Grid:
    """Return the grid that covers those of all; the one with the smallest elements is a part of it."""
    return Grid(_axis([one.x for one in last], "x"), _axis([one.y for one in last], "y"))


def _axis(axes: Sequence[Array], name: str) -> Array:
    if all(np.array_equal(axis, axes[0]) for axis in axes):
        return axes[0]
    if any(axis.size < 2 for axis in axes):
        raise ValueError(f"there is one element along {name} in some results: these lie on no grid of others")
    steps = [(axis[-1] - axis[0]) / (axis.size - 1) for axis in axes]
    finest = axes[int(np.argmin(steps))]
    step = min(steps)
    low = min(axis[0] - 0.5 * own for axis, own in zip(axes, steps, strict=True))
    high = max(axis[-1] + 0.5 * own for axis, own in zip(axes, steps, strict=True))
    before = math.ceil((finest[0] - 0.5 * step - low) / step - 1e-6)
    behind = math.ceil((high - finest[-1] - 0.5 * step) / step - 1e-6)
    around = step * np.arange(1, max(before, behind) + 1)
    return np.concatenate([finest[0] - around[:before][::-1], finest, finest[-1] + around[:behind]])


def _progress(each: Sequence[Array]) -> tuple[Array, list[NDArray[np.intp]]]:
    """Return all progresses at which there are outputs, and which of them are those of each result."""
    some = [own for own in each if own.size]
    if all(np.array_equal(own, some[0]) for own in some):
        return some[0], [np.arange(own.size) for own in each]
    together = np.unique(np.concatenate(some))
    near = _SAME * np.abs(together).max()
    together = together[np.append(True, np.diff(together) > near)]
    return together, [np.searchsorted(together, own + near, side="right") - 1 for own in each]


def _hold(values: int, space: tuple[int, ...], results: int) -> None:
    """See that the memory is there, before it is taken."""
    memory, free = 8.0 * values, _archard.free_memory()
    if memory <= _LARGE * free:
        return
    places = " x ".join(map(str, reversed(space))) + (" elements" if len(space) > 1 else " pairs")
    of_results = "a result" if results == 1 else f"{results} results"
    said = (
        f"the fields of {of_results} on {places} take {_size(memory)} of memory, {_size(free)} are free: "
        "take some of them by `fields`, or a coarser `grid`"
    )
    if memory > free:
        raise MemoryError(said)
    warnings.warn(said, ArchardWarning, stacklevel=5)


def _size(memory: float) -> str:
    return f"{memory / 1e9:.3g} GB" if memory >= 1e9 else f"{memory / 1e6:.3g} MB"


def _laid(one: Snapshot, name: str, places: dict[str, Array]) -> Array:
    """Return a field as means over elements, NaN where it has none."""
    if "pair" in places or (np.array_equal(one.x, places["x"]) and np.array_equal(one.y, places["y"])):
        return one[name]
    along_x, along_y = _shares(one.x, places["x"]), _shares(one.y, places["y"])
    covered = np.outer(along_y.sum(axis=1), along_x.sum(axis=1))
    sums = along_y @ one[name] @ along_x.T
    means: Array = np.full(sums.shape, np.nan)
    np.divide(sums, covered, out=means, where=covered > 0.0)
    return means


def _shares(own: Array, grid: Array) -> Array:
    """Return how long (m) each element of one axis (columns) lies in each of another (rows)."""
    if own.size == grid.size == 1:
        return np.ones((1, 1))
    if own.size == 1 or grid.size == 1:
        raise ValueError("there is one element along an axis: it lies on no other grid")
    half, wide = 0.5 * (own[1] - own[0]), 0.5 * (grid[1] - grid[0])
    rows = grid[:, None]
    within: Array = np.minimum(own + half, rows + wide) - np.maximum(own - half, rows - wide)
    return np.where(within > 1e-6 * half, within, 0.0)
