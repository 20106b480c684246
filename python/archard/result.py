"""Results: what a run, of Python or of the command, leaves behind in its folder."""

from __future__ import annotations

import csv
import io
import json
import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from archard import _archard
from archard._errors import ResultWarning
from archard._surface import PREFIX

Array = NDArray[np.float64]


def unit(name: str) -> str:
    """Return the unit that a column or field ends in; empty for pure numbers."""
    for known in _archard.UNITS:
        if name.endswith(f"_{known}"):
            return _WRITTEN.get(known, known)
    return ""


_WRITTEN = {"m2": "m^2", "m3": "m^3", "Nm": "N m", "m3_per_Nm": "m^3/(N m)"}


class Table(dict[str, Array]):
    """Columns by name, in SI; text columns are left as text."""

    @property
    def units(self) -> dict[str, str]:
        """The unit of each column; empty for pure numbers."""
        return {name: unit(name) for name in self}

    def to_pandas(self) -> Any:
        """Return a pandas ``DataFrame``, with the units in its ``attrs``."""
        import pandas

        frame = pandas.DataFrame(dict(self))
        frame.attrs["units"] = self.units
        return frame


class Verdict(NamedTuple):
    """Whether a result can be believed."""

    word: str
    """``"good"``, ``"doubtful"`` or ``"wrong"``: the worst of all lines."""
    lines: list[dict[str, Any]]
    """What was judged: ``subject``, ``value``, ``word``, its bounds, and ``text``."""

    @property
    def wrong(self) -> str:
        """The lines that are wrong, in words."""
        return self._said("wrong")

    @property
    def doubtful(self) -> str:
        """The lines that are doubtful, in words."""
        return self._said("doubtful")

    def _said(self, word: str) -> str:
        lines = (line for line in self.lines if line["word"] == word)
        return "; ".join(f"{line['subject']}: {line['value']:.3g} {line['text']}" for line in lines)


class Profile(NamedTuple):
    """A section of a body through the contact, in the frame's coordinates."""

    coordinate: Array
    """Place along the axis (m)."""
    height: Array
    """Height of the worn surface, without elastic deformation (m)."""
    worn: Array
    """Depth worn off (m)."""


class Snapshot:
    """Fields of one state: ``[ny, nx]`` arrays over ``x`` and ``y`` (m) on a grid, else one value a pair.

    Fields are attributes without their unit (``pressure``, ``gap``, ``traction_x``, ``slip_x``, ``stick``) and
    items with it (``"pressure_Pa"``); of bodies, ``worn["pin"]`` and ``height["pin"]``.
    """

    progress: float
    """How far the motion has gone, in its own unit."""

    def __init__(self, progress: float, places: dict[str, Array], fields: dict[str, Array]) -> None:
        self.progress = progress
        self.x, self.y = places["x"], places["y"]
        self.z = places.get("z")
        self._fields = fields

    @property
    def names(self) -> list[str]:
        """The names of all fields, each with its unit."""
        return list(self._fields)

    @property
    def worn(self) -> dict[str, Array]:
        """Depth worn off each body (m)."""
        return self._of_bodies("wear_")

    @property
    def height(self) -> dict[str, Array]:
        """Height of each worn body, without elastic deformation (m)."""
        return self._of_bodies("height_")

    def __getitem__(self, name: str) -> Array:
        return self._fields[name]

    def __getattr__(self, name: str) -> Array:
        if not name.startswith("_"):
            for field, values in self._fields.items():
                if field.removesuffix("_Pa").removesuffix("_m") == name:
                    return values
        raise AttributeError(f"no field `{name}`; there are {', '.join(self.__dict__.get('_fields', {}))}")

    def __repr__(self) -> str:
        return f"{type(self).__name__}(progress={self.progress:g}, {', '.join(self._fields)})"

    def _of_bodies(self, kind: str) -> dict[str, Array]:
        found = self._fields.items()
        return {
            name[len(kind) : -len("_m")]: values
            for name, values in found
            if name.startswith(kind) and name != f"{kind}m"
        }


class Result:
    """What a run came to; all numbers are in SI."""

    def __init__(self, files: Mapping[str, bytes], folder: Path | None) -> None:
        self._files = files
        self.folder = folder
        """The folder of the results; ``None`` of a result in memory, which :meth:`save` writes."""
        summary = files.get("summary.json")
        self.summary: dict[str, Any] = json.loads(summary) if summary is not None else {}
        """What ``summary.json`` holds: the last row, wear compared with closed forms, effort, warnings."""

    @property
    def complete(self) -> bool:
        """Whether the run came to its end."""
        return bool(self.summary.get("complete", False))

    @property
    def failure(self) -> str | None:
        """Why the run stopped before its end."""
        if not self.summary:
            return "it is still under way, or was killed"
        found = self.summary["failure"]
        return None if found is None else str(found)

    @property
    def verdict(self) -> Verdict:
        """Whether what was computed can be believed; without a summary it cannot."""
        found = self.summary.get("verdict")
        if not found:
            return Verdict("doubtful", [])
        return Verdict(found["word"], found["lines"])

    @property
    def doubt(self) -> str:
        """Why it is not to be relied on; empty if it is."""
        said = [] if self.complete else [f"the run is incomplete: {self.failure}"]
        word = self.verdict.word
        if word != "good":
            said.append(f"the result is {word}: {self.verdict.wrong or self.verdict.doubtful}")
        return "; ".join(said).rstrip(": ")

    @property
    def toml(self) -> str:
        """The case in SI, as a case file."""
        return self._files["case.toml"].decode()

    @property
    def history(self) -> Table:
        """A row a step."""
        return self._table("history.csv") or Table()

    @property
    def profiles(self) -> Table:
        """The sections through the contact, a row a place, for all outputs."""
        return self._table("profiles.csv") or Table()

    @property
    def worn_profiles(self) -> Table | None:
        """Transverse profiles of bodies that roll, before and after, for all outputs."""
        return self._table("worn_profiles.csv")

    @property
    def length_profiles(self) -> Table | None:
        """Worn sections of a surface that swings, from end to end, for all outputs."""
        return self._table("length_profiles.csv")

    @property
    def fretting_loop(self) -> Table | None:
        """Force over shift in the cycles that were put out, a row an increment."""
        return self._table("fretting_loop.csv")

    @property
    def points(self) -> Table | None:
        """Displacements and stresses at points inside of bodies."""
        return self._table("points.csv")

    @property
    def fields(self) -> Sequence[Snapshot]:
        """The fields of all outputs; each is read when it is asked for."""
        return _Outputs(self._files)

    @property
    def surfaces(self) -> dict[str, Snapshot]:
        """Displacements, tractions and stresses on surfaces of meshed bodies, where they were asked for."""
        names = [name for name in self._files if name.startswith("surface")]
        return {name.removesuffix(".vtu"): _snapshot(float("nan"), name, self._files) for name in names}

    def profile(self, body: str, axis: str = "x", output: int = -1) -> Profile:
        """Return the section of a body along an axis, at the last output if no other is asked for."""
        if axis not in ("x", "y"):
            raise ValueError(f'the axis is "x" or "y", not {axis!r}')
        table = self.profiles
        if f"wear_{body}_m" not in table:
            raise KeyError(f"no profile of a body `{body}`")
        places = table[next(iter(table))]
        here = (places == np.unique(places)[output]) & (table["axis"] == axis)
        names = ("coordinate_m", f"height_{body}_m", f"wear_{body}_m")
        return Profile(*(table[name][here] for name in names))

    def to_pandas(self) -> Any:
        """Return the history as a pandas ``DataFrame``."""
        return self.history.to_pandas()

    def to_xarray(self) -> Any:
        """Return the fields of all outputs as an xarray ``Dataset`` over progress, y and x (or pair).

        Units are attributes, so that plots label themselves. Variables are named without their unit. Outputs in
        a smaller frame than the last (``frame.doubles``) are means over its elements, and NaN beside their own.
        """
        import xarray

        outputs = list(self.fields)
        if not outputs:
            raise ValueError("the result has no fields")
        first = outputs[-1]
        grid = first.z is None
        dims = ("progress", "y", "x") if grid else ("progress", "pair")
        variables = {
            _bare(name): (
                dims[: first[name].ndim + 1],
                np.stack([_on_grid(one, name, first) if grid else one[name] for one in outputs]),
                {"units": unit(name)},
            )
            for name in first.names
            if first[name].ndim == len(dims) - 1
        }
        progress = next(iter(self.history))
        at = np.array([one.progress for one in outputs])
        coordinates: dict[str, Any] = {
            "progress": ("progress", at, {"units": unit(progress), "long_name": _bare(progress)})
        }
        for axis, values in (("x", first.x), ("y", first.y), ("z", first.z)):
            if values is not None:
                coordinates[axis] = (axis if grid else "pair", values, {"units": "m"})
        attributes = {"verdict": self.verdict.word, "complete": int(self.complete)}
        return xarray.Dataset(variables, coordinates, attributes)

    def plot(self) -> Any:
        """Draw history, pressure and worn depth; return the matplotlib figure."""
        from matplotlib import pyplot

        if not self.fields:
            raise ValueError("the result has no fields")
        figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(13, 4), layout="constrained")
        history, last = self.history, self.fields[-1]
        progress = next(iter(history))
        shown = "wear_depth_m" if history["wear_depth_m"].any() else "peak_pressure_Pa"
        left.plot(history[progress], history[shown])
        left.set(xlabel=_label(progress), ylabel=_label(shown))
        if last.z is None:
            drawn = middle.pcolormesh(last.x, last.y, last.pressure, shading="nearest")
        else:
            drawn = middle.scatter(last.x, last.y, c=last.pressure, s=8)
        middle.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
        figure.colorbar(drawn, ax=middle, label="pressure (Pa)")
        for body in last.worn:
            along = self.profile(body)
            right.plot(along.coordinate, along.worn, label=body)
        right.set(xlabel="x (m)", ylabel="worn depth (m)")
        right.invert_yaxis()
        right.legend()
        if self.doubt:
            figure.suptitle(self.doubt, color="tab:red", fontsize="small", wrap=True)
        return figure

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write the files of the result into a folder that has none."""
        folder = Path(folder)
        if (folder / "history.csv").exists():
            raise FileExistsError(f"`{folder}` holds results")
        for name, content in self._files.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)

    def __repr__(self) -> str:
        lines = [f"Result: {self.verdict.word}" + ("" if self.complete else f", incomplete: {self.failure}")]
        last = self.summary.get("last") or {}
        lines += [f"  {name:<28}{value:.6g}" for name, value in last.items() if value is not None]
        return "\n".join(lines)

    def __reduce__(self) -> tuple[Any, ...]:
        return Result, (dict(self._files.items()), self.folder)

    def _table(self, name: str) -> Table | None:
        content = self._files.get(name)
        return None if content is None else _read_table(content)


def open(folder: str | os.PathLike[str]) -> Result:
    """Return the result in a folder that a run, of Python or of the command, wrote.

    It warns of a result that is incomplete, doubtful or wrong.
    """
    folder = Path(folder)
    if not folder.is_dir():
        raise FileNotFoundError(f"no folder: `{folder}`")
    if not ((folder / "summary.json").is_file() or (folder / "history.csv").is_file()):
        raise FileNotFoundError(f"`{folder}` holds no results of a run")
    result = read(folder, keep=False)
    if result.doubt:
        warnings.warn(f"{folder}: {result.doubt}", ResultWarning, stacklevel=2)
    return result


def read(folder: Path, *, keep: bool) -> Result:
    """Return the result in a folder, which has to stay unless all of it is kept."""
    files = _Folder(folder)
    return Result(dict(files.items()), None) if keep else Result(files, folder)


class _Folder(Mapping[str, bytes]):
    """The files of a folder by their names."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def __getitem__(self, name: str) -> bytes:
        try:
            return (self._folder / name).read_bytes()
        except FileNotFoundError:
            raise KeyError(name) from None

    def __iter__(self) -> Iterator[str]:
        # The list of what was written comes first: it makes the rest replaceable.
        tops = ["manifest.txt", "*.json", "*.toml", "*.csv", "*.pvd", "*.vtu", "checkpoint", "fields/*.vt?"]
        for top in [*tops, f"{PREFIX}*.npy"]:
            for path in sorted(self._folder.glob(top)):
                yield path.relative_to(self._folder).as_posix()

    def __len__(self) -> int:
        return sum(1 for _ in self)


class _Outputs(Sequence[Snapshot]):
    """The outputs of a run, read one by one."""

    def __init__(self, files: Mapping[str, bytes]) -> None:
        self._files = files
        collection = files.get("fields.pvd")
        listed = [] if collection is None else ElementTree.fromstring(collection).iter("DataSet")
        self._outputs = [(float(one.attrib["timestep"]), one.attrib["file"]) for one in listed]

    def __len__(self) -> int:
        return len(self._outputs)

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[place] for place in range(*index.indices(len(self)))]
        progress, name = self._outputs[index]
        return _snapshot(progress, name, self._files)


def _snapshot(progress: float, name: str, files: Mapping[str, bytes]) -> Snapshot:
    return Snapshot(progress, *_archard.read_fields(name, files[name]))


def _on_grid(one: Snapshot, name: str, grid: Snapshot) -> Array:
    """Return a field as means over the elements of another output, NaN where it has none."""
    if np.array_equal(one.x, grid.x) and np.array_equal(one.y, grid.y):
        return one[name]
    along_x, along_y = _shares(one.x, grid.x), _shares(one.y, grid.y)
    covered = np.outer(along_y.sum(axis=1), along_x.sum(axis=1))
    sums = along_y @ one[name] @ along_x.T
    means: Array = np.full(sums.shape, np.nan)
    np.divide(sums, covered, out=means, where=covered > 0.0)
    return means


def _shares(own: Array, grid: Array) -> Array:
    """Return how long (m) each element of one axis (columns) lies in each of another (rows)."""
    half, wide = 0.5 * (own[1] - own[0]), 0.5 * (grid[1] - grid[0])
    rows = grid[:, None]
    within: Array = np.minimum(own + half, rows + wide) - np.maximum(own - half, rows - wide)
    return np.where(within > 1e-6 * half, within, 0.0)


def _read_table(content: bytes) -> Table:
    rows = csv.reader(io.StringIO(content.decode(), newline=""))
    header = next(rows, [])
    columns = zip(*rows, strict=True)
    table = Table({name: np.empty(0) for name in header})
    for name, column in zip(header, columns, strict=False):
        try:
            table[name] = np.array([float(cell) if cell else np.nan for cell in column])
        except ValueError:
            table[name] = np.array(column)
    return table


def _bare(name: str) -> str:
    """Return a name without its unit."""
    suffixes = (f"_{known}" for known in _archard.UNITS)
    return next((name.removesuffix(one) for one in suffixes if name.endswith(one)), name)


def _label(name: str) -> str:
    written = unit(name)
    return _bare(name).replace("_", " ") + (f" ({written})" if written else "")
