"""All results of a study as one xarray dataset."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from archard import _dataset, _toml
from archard._units import bare, unit

if TYPE_CHECKING:
    from archard._sweep import Sweep, _Value


def dataset(study: Sweep, fields: Iterable[str] | None, grid: Any) -> Any:
    """Return the results of a study over its keys; see :meth:`Sweep.to_xarray`."""
    names = list(dict.fromkeys(one.name for row in study._values for one in row))
    columns = {name: study.table[name] for name in names}
    labels = {name: label(name, names, study._values) for name in names}
    axes = {name: list(dict.fromkeys(column.tolist())) for name, column in columns.items()}
    met = list(zip(*(column.tolist() for column in columns.values()), strict=True))
    order = list(itertools.product(*axes.values())) if _is_full(met, axes) else None
    places = [met.index(point) for point in order] if order is not None else range(len(met))
    results = [study.rows[place].result for place in places]
    done = [one if one is not None and one.complete else None for one in results]
    design = {labels[name]: len(axes[name]) for name in names} if order is not None else {"row": len(met)}
    found = _dataset.dataset(done, design, fields, grid)
    about = {name: {"units": _unit(name, study._values), "long_name": _key(name, study._values)} for name in names}
    if order is not None:
        found = found.assign_coords(
            {labels[name]: (labels[name], np.array(axes[name]), about[name]) for name in names}
        )
    else:
        own = {labels[name]: ("row", column, about[name]) for name, column in columns.items()}
        found = found.assign_coords(row=np.arange(1, len(met) + 1), **own)
    lengths = tuple(design.values())
    table = {
        bare(name): (tuple(design), column[list(places)].reshape(lengths), {"units": unit(name)})
        for name, column in study.table.items()
        if name not in columns and bare(name) not in found.variables
    }
    return found.assign(table)


def label(name: str, names: Sequence[str], values: Sequence[Sequence[_Value]]) -> str:
    """Return the shortest end of a key that tells it from the others."""
    paths = {one: _toml.path(_key(one, values)) for one in names}
    own = paths.pop(name)
    for length in range(1, len(own)):
        if all(other[-length:] != own[-length:] for other in paths.values()):
            return ".".join(own[-length:])
    return ".".join(own)


def _is_full(met: Sequence[tuple[Any, ...]], axes: dict[str, list[Any]]) -> bool:
    """Tell whether each value meets each of the others, once."""
    return len(set(met)) == len(met) == math.prod(map(len, axes.values()))


def _key(name: str, values: Sequence[Sequence[_Value]]) -> str:
    return _of(name, values).key


def _unit(name: str, values: Sequence[Sequence[_Value]]) -> str:
    return _of(name, values).unit


def _of(name: str, values: Sequence[Sequence[_Value]]) -> _Value:
    return next(one for row in values for one in row if one.name == name)
