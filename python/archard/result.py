"""Results: what a run, of Python or of the command, leaves behind in its folder."""

from __future__ import annotations

import json
import os
import tempfile
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from archard import _archard, _compare, _damage, _dataset, _html, _picture, _table, _toml
from archard._errors import ResultWarning
from archard._snapshot import Outputs, Snapshot, snapshot
from archard._surface import PREFIX
from archard._table import Array, Table


class Verdict(NamedTuple):
    """Whether a result can be believed."""

    word: str
    """``"good"``, ``"doubtful"`` or ``"wrong"``: the worst of all lines."""
    lines: list[dict[str, Any]]
    """What was judged: ``subject``, ``value``, ``word``, its bounds, ``text``, and all of it in ``words``."""

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
        return "; ".join(f"{line['subject']}: {line.get('words', line['text'])}" for line in lines)


class Profile(NamedTuple):
    """A section of a body through the contact, in the frame's coordinates."""

    coordinate: Array
    """Place along the axis (m)."""
    height: Array
    """Height of the worn surface, without elastic deformation (m)."""
    worn: Array
    """Depth worn off (m)."""


class Result:
    """What a run came to; all numbers are in SI."""

    def __init__(self, files: Mapping[str, bytes], folder: Path | None) -> None:
        self._files = files
        self.folder = folder
        """The folder of the results; ``None`` of a result in memory, which :meth:`save` writes."""
        summary = files.get("summary.json")
        with _damage.naming(self.folder, "summary.json"):
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
    def life(self) -> dict[str, Any] | None:
        """Where the first limit of ``until`` was reached, with its error (SI); ``None`` if none was."""
        found = self.summary.get("life") or {}
        reached: dict[str, Any] | None = found.get("reached")
        return reached

    @property
    def lives(self) -> dict[str, Any] | None:
        """How lives scatter by a fitted coefficient: median, ``B10``, ``B1``, shares (SI); ``None`` if unknown."""
        found = self.summary.get("life") or {}
        scatter: dict[str, Any] | None = found.get("distribution")
        return scatter

    @property
    def toml(self) -> str:
        """The case in SI, as a case file."""
        return self._files["case.toml"].decode()

    @property
    def history(self) -> Table:
        """A row a step."""
        return self._table("history.csv")

    @property
    def profiles(self) -> Table:
        """The sections through the contact, a row a place, for all outputs."""
        return self._table("profiles.csv")

    @property
    def worn_profiles(self) -> Table:
        """Transverse profiles of bodies that roll, before and after, for all outputs."""
        return self._table("worn_profiles.csv")

    @property
    def length_profiles(self) -> Table:
        """Worn sections of a surface that swings, from end to end, for all outputs."""
        return self._table("length_profiles.csv")

    @property
    def fretting_loop(self) -> Table:
        """Force over shift in the cycles that were put out, a row an increment."""
        return self._table("fretting_loop.csv")

    @property
    def points(self) -> Table:
        """Displacements and stresses at points inside of bodies."""
        return self._table("points.csv")

    @property
    def stresses(self) -> dict[str, Any]:
        """The largest stresses of half-spaces, as in `summary.json`: of each its value, error and place."""
        return self.summary.get("stress") or {}

    def stress(self, body: str) -> Table:
        """Return the largest stresses in a half-space, a row a depth."""
        return self._table(f"stress_{body}.csv")

    @property
    def fields(self) -> Sequence[Snapshot]:
        """The fields of all outputs; each is read when it is asked for."""
        with _damage.naming(self.folder, "fields.pvd"):
            return Outputs(self._files, self.folder)

    @property
    def surfaces(self) -> dict[str, Snapshot]:
        """Displacements, tractions and stresses on surfaces of meshed bodies, where they were asked for."""
        names = [name for name in self._files if name.startswith("surface")]
        read = (snapshot(float("nan"), name, self._files, self.folder) for name in names)
        return {name.removesuffix(".vtu"): surface for name, surface in zip(names, read, strict=True)}

    def profile(self, body: str, axis: str = "x", output: int = -1) -> Profile:
        """Return the section of a body along an axis, at the last output if no other is asked for."""
        if axis not in ("x", "y"):
            raise ValueError(f'the axis is "x" or "y", not {axis!r}')
        table = self.profiles
        if f"wear_{body}_m" not in table:
            if f"body.{body}" in self.toml:
                place = _damage.place(self.folder, "profiles.csv")
                raise ValueError(f"{place} is damaged: it has no profile of `{body}`")
            raise KeyError(f"no profile of a body `{body}`")
        places = table[next(iter(table))]
        if not -len(np.unique(places)) <= output < len(np.unique(places)):
            raise ValueError(f"{_damage.place(self.folder, 'profiles.csv')} has no output {output}")
        here = (places == np.unique(places)[output]) & (table["axis"] == axis)
        names = ("coordinate_m", f"height_{body}_m", f"wear_{body}_m")
        return Profile(*(table[name][here] for name in names))

    def to_pandas(self) -> Any:
        """Return the history as a pandas ``DataFrame``."""
        return self.history.to_pandas()

    def to_xarray(self, *, fields: Iterable[str] | None = None, grid: Any = None) -> Any:
        """Return the fields of all outputs as an xarray ``Dataset`` over progress, y and x (or pair).

        Units are attributes, so that plots label themselves. Variables are named without their unit. Outputs on
        another grid are means over the elements of the one that is asked for, and NaN beside their own.

        Args:
            fields: the fields that are taken, as ``["pressure", "wear"]``; all if not given.
            grid: the grid that the fields are laid on: another result, a dataset, or places along x and y
                (m), ``(x, y)``, the centres of equal elements; that of the last output if not given.

        Raises:
            ValueError: no such field, or fields that lie on no such grid.
            MemoryError: the dataset would take more memory than is free.

        """
        dataset = _dataset.dataset([self], {}, fields, grid)
        return dataset.assign_attrs(verdict=self.verdict.word, complete=int(self.complete))

    @property
    def pictures(self) -> list[str]:
        """The names of the pictures that :meth:`plot` draws, as ``archard plot`` has them."""
        return [str(one["name"]) for one in self._pictures()["pictures"]]

    def plot(self, picture: str | None = None, *, size: _picture.Size | None = None) -> Any:
        """Draw a picture of ``archard plot``; return the matplotlib figure.

        Args:
            picture: one of :attr:`pictures`; the overview if not given.
            size: ``"column"`` or ``"page"``, the width of a journal's, with letters of about eight points; that of
                a screen if not given.

        Raises:
            ValueError: a result that has nothing to draw, or no such picture.

        """
        told = self._pictures()
        return _picture.draw(_picture.chosen(told, picture), told["mark"], size)

    def report(
        self,
        path: str | os.PathLike[str] | None = None,
        *,
        beside: Iterable[Any] = (),
        columns: Mapping[str, str] | None = None,
        body: str | None = None,
        levelled: bool = False,
    ) -> Path:
        """Write the page of ``archard report``, which opens in any browser; return its file.

        Args:
            path: the page; ``report.html`` in the folder of the result if not given.
            beside: measured tables and other results that it is compared with, as of :meth:`compare`.
            columns: as of :meth:`compare`.
            body: as of :meth:`compare`.
            levelled: as of :meth:`compare`.

        Raises:
            ValueError: a result in memory without a path, a file there that is no such page, or what cannot be
                compared.

        """
        if path is None and self.folder is None:
            raise ValueError('a result in memory has no folder for its page: say where it goes, "report.html"')
        page = Path(path) if path is not None else Path(self.folder or "") / "report.html"
        _compare.report(self, page, beside, columns, body, levelled)
        return page

    def compare(
        self,
        *others: Any,
        columns: Mapping[str, str] | None = None,
        body: str | None = None,
        levelled: bool = False,
    ) -> _compare.Comparison:
        """Hold the run against measurements and other runs, as ``archard compare`` does.

        Args:
            others: measured profiles, height maps and readings over the motion (CSV files, dicts of columns or
                data frames), and other runs (results or their folders).
            columns: headers of other names, as ``{"z": "Tiefe [um]"}``; a profile has ``x`` (or ``y``) and ``z``,
                readings have ``distance``, ``revolutions``, ``cycle`` or ``time``, and ``depth``, ``volume``,
                ``section`` or ``mass``.
            body: the body that was measured; the one that wears deepest if not given.
            levelled: whether measured profiles are level and placed as the run has them.

        Raises:
            ValueError: a table or a result that cannot be read, or says nothing that can be compared.

        """
        return _compare.compare(self, others, columns, body, levelled)

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write the files of the result into a folder that has none."""
        folder = Path(folder)
        if (folder / "history.csv").exists():
            raise FileExistsError(f"`{folder}` holds results")
        _write(self._files, folder)

    def __repr__(self) -> str:
        lines = [f"Result: {self.verdict.word}" + ("" if self.complete else f", incomplete: {self.failure}")]
        last = self.summary.get("last") or {}
        lines += [f"  {name:<28}{value:.6g}" for name, value in last.items() if value is not None]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        signs = [_html.sign(self.verdict.word)] if self.complete else [_html.sign("incomplete")]
        heading = _html.title(_read_title(self._files) or "Result", *signs)
        try:
            with self._on_disk(only=_NUMBERS) as folder:
                caption, heads, rows = _archard.numbers(folder)
        except ValueError:
            return _html.block(heading, _html.words(repr(self)))
        doubts = _html.lines([self.doubt] if self.doubt else [])
        return _html.block(heading, doubts, _html.table([caption, *heads[1:]], rows))

    def __reduce__(self) -> tuple[Any, ...]:
        return Result, (dict(self._files.items()), self.folder)

    @contextmanager
    def _on_disk(self, only: Sequence[str] | None = None) -> Iterator[Path]:
        """Give the folder of the result; of one in memory, one for a time, with some of its files or all."""
        with tempfile.TemporaryDirectory(prefix="archard-") as temporary:
            try:
                yield self._written(Path(temporary) / "run", only)
            except ValueError as error:
                raise ValueError(str(error).replace(f"{temporary}{os.sep}", "")) from None

    def _written(self, place: Path, only: Sequence[str] | None = None) -> Path:
        """Return the folder of the result; of one in memory the place, with its files, some or all."""
        if self.folder is not None:
            return self.folder
        _write({name: self._files[name] for name in self._files if only is None or name in only}, place)
        return place

    def _pictures(self) -> dict[str, Any]:
        with self._on_disk() as folder:
            found: dict[str, Any] = json.loads(_archard.pictures(folder))
        return found

    def _table(self, name: str) -> Table:
        """Return a table; one without columns where there is none."""
        content = self._files.get(name)
        if content is None:
            return Table()
        with _damage.naming(self.folder, name):
            return _table.read(content)


def open(folder: str | os.PathLike[str]) -> Result:
    """Return the result in a folder that a run, of Python or of the command, wrote.

    It warns of a result that is incomplete, doubtful or wrong.

    Raises:
        FileNotFoundError: no such folder, or one without results.
        ValueError: a file is damaged, or was changed since the run was done; it is named.

    """
    folder = Path(folder)
    if not folder.is_dir():
        raise FileNotFoundError(f"no folder: `{folder}`")
    if (folder / "study.json").is_file():
        raise ValueError(f"`{folder}` is the folder of a study: Sweep.open returns it")
    if not ((folder / "summary.json").is_file() or (folder / "history.csv").is_file()):
        raise FileNotFoundError(f"`{folder}` holds no results of a run")
    _archard.verify(folder)
    result = read(folder, keep=False)
    if result.doubt:
        warnings.warn(f"{folder}: {result.doubt}", ResultWarning, stacklevel=2)
    return result


#: The files that the numbers at the end of a run are read from.
_NUMBERS = ("case.toml", "history.csv", "summary.json")


def _write(files: Mapping[str, bytes], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def _read_title(files: Mapping[str, bytes]) -> str:
    try:
        return str(_toml.read(files["case.toml"].decode()).get("title", ""))
    except (KeyError, ValueError):
        return ""


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
