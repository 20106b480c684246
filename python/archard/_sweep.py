"""Studies: a case over many values, on any executor."""

from __future__ import annotations

import csv
import itertools
import json
import os
import pickle
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np

from archard import _archard, _html, _law, _picture, _sampled, _study, _toml
from archard._errors import RunError
from archard._law import FrictionFunction, Law, WearFunction
from archard._log import log
from archard._table import Table
from archard._units import bare, shown
from archard.case import Case
from archard.result import Result
from archard.result import open as open_result
from archard.run import bar


class _Laws(NamedTuple):
    """The laws of a study that are functions."""

    wear: Mapping[str, WearFunction | Law] | None
    friction: FrictionFunction | None

    def refuse(self, key: str) -> None:
        """See that a key is none that a function takes the place of."""
        path = _toml.path(key)
        wear = any(path[:2] == ["body", body] and path[2:3] in ([], ["wear"]) for body in self.wear or {})
        if wear or (self.friction is not None and path[:1] == ["friction"]):
            raise ValueError(f"`{key}`: the law is a function, which takes no value from the case")

    def check(self, case: Case) -> Any:
        """Check a case with these laws."""
        return case._with_laws(*self).check()

    def is_kept(self, case: Case, toml: str) -> bool:
        """Whether a case in a folder is that one, with laws of these names."""
        remark = _law.remark(*self)
        return toml.startswith(remark) and bool(self.check(case).is_kept(toml[len(remark) :]))

    def travel(self) -> None:
        """See that another process can be sent them."""
        functions: list[Callable[..., Any]] = [] if self.friction is None else [self.friction]
        functions += [law.function if isinstance(law, Law) else law for law in (self.wear or {}).values()]
        for function in functions:
            try:
                pickle.dumps(function)
            except (pickle.PicklingError, AttributeError, TypeError):
                raise ValueError(
                    f"the law `{_law.name(function)}` cannot be sent to another process: define it with `def` at "
                    "the top level of a module, or give executor=ThreadPoolExecutor()"
                ) from None


class Row(NamedTuple):
    """One run of a study."""

    settings: dict[str, Any]
    """What was put at which keys."""
    result: Result | None
    """What the run came to, in part where it stopped before its end; ``None`` where it has nothing to show."""
    error: str | None
    """Why the run stopped, or why its result is wrong; ``None`` of a run that ended well."""


class Sweep:
    """What a study came to."""

    def __init__(
        self, rows: list[Row], values: list[list[_Value]], folder: Path | None = None, table: Table | None = None
    ) -> None:
        self.rows = rows
        """The rows, in the order of the design."""
        self._values = values
        self.folder = folder
        """The folder of the study; ``None`` of one in memory."""
        known = [{one.name: one.number for one in row} for row in values]
        self.table = _table(rows, known) if table is None else table
        """A row a run: keys (SI), ``status``, ``verdict``, ``reason``, last row of the history, ``error``."""

    @classmethod
    def open(cls, folder: str | os.PathLike[str]) -> Sweep:
        """Return the study in a folder that the command, or :func:`sweep` over values by key, wrote.

        Raises:
            FileNotFoundError: no such study, or one without rows.

        """
        return _sampled.read(Path(folder))

    def __len__(self) -> int:
        """Return the number of rows."""
        return len(self.rows)

    @property
    def pictures(self) -> list[str]:
        """Names of the pictures of ``archard plot`` of the study."""
        return [one["name"] for one in self._pictures()["pictures"]]

    def plot(self, picture: str | None = None, *, size: _picture.Size | None = None) -> Any:
        """Draw a picture of ``archard plot`` of the study; return the matplotlib figure.

        Args:
            picture: one of :attr:`pictures`; the last if not given.
            size: as of :meth:`Result.plot`.

        Raises:
            ValueError: a study in memory or of a design of one's own, one without results, or no such picture.

        """
        told = self._pictures()
        return _picture.draw(_picture.chosen(told, picture), told["mark"], size)

    def report(self, path: str | os.PathLike[str] | None = None) -> Path:
        """Write the page of ``archard report`` of the study; return its file.

        Args:
            path: the page; ``report.html`` in the folder of the study if not given.

        Raises:
            ValueError: as of :meth:`plot`, or a file there that is no such page.

        """
        folder = self._drawn()
        page = folder / "report.html" if path is None else Path(path)
        return Path(_archard.page(folder, [], page, ([], None, False, folder)))

    def _pictures(self) -> dict[str, Any]:
        return dict(json.loads(_archard.pictures(self._drawn())))

    def _drawn(self) -> Path:
        if self.folder is None or not (self.folder / "study.json").is_file():
            raise ValueError("pictures are of a study with a folder, over values by key: give `out`")
        return self.folder

    def to_pandas(self) -> Any:
        """Return the table as a data frame."""
        return self.table.to_pandas()

    def to_xarray(self, *, fields: Iterable[str] | None = None, grid: Any = None) -> Any:
        """Return the results of all rows as an xarray ``Dataset``.

        Fields are over the keys of the study, progress, y and x (or pair), the columns of the table over the keys.
        A key is called by its last name where no other ends in it. Rows of a design of one's own, where not each
        value meets each of the others, are over ``row``. Where grids differ, fields are means over the elements of
        a common one: all that any row covers, in the smallest elements of all. They are NaN where a row has no
        output or no field, or failed.

        Args:
            fields: the fields that are taken, as ``["pressure", "wear"]``; all if not given.
            grid: the grid that the fields are laid on, as of :meth:`Result.to_xarray`; the common one if not.

        Raises:
            ValueError: no row has fields, no such field, or fields that lie on no such grid.
            MemoryError: the dataset would take more memory than is free.

        """
        return _study.dataset(self, fields, grid)

    def _repr_html_(self) -> str:
        keys = list(dict.fromkeys(one.name for row in self._values for one in row))
        last = [name for name in self.table if name.startswith(_SHOWN) and name != "wear_depth_m"]
        last = [name for name in last if np.nansum(np.abs(self.table[name])) > 0.0]
        rows = []
        for index in range(len(self.rows)):
            own = {one.name: one for one in self._values[index]}
            row = [str(index + 1), *(own[name].shown() if name in own else "" for name in keys)]
            verdict = str(self.table["verdict"][index]) or str(self.table["status"][index])
            row += [_html.sign(verdict), *(_shown(name, self.table[name][index]) for name in last)]
            rows.append([*row, str(self.table["error"][index])])
        heads = [_study.label(name, keys, self._values) for name in keys]
        heads = ["row", *heads, "verdict", *(bare(name).replace("_", " ") for name in last), "error"]
        if not any(row[-1] for row in rows):
            heads, rows = heads[:-1], [row[:-1] for row in rows]
        return _html.block(_html.title(repr(self)), _html.table(heads, rows))

    def __repr__(self) -> str:
        failed = sum(row.error is not None for row in self.rows)
        return f"Sweep({len(self.rows)} rows{f', {failed} failed' if failed else ''})"


#: Columns of the last row that are seen first.
_SHOWN = ("wear_depth_", "worn_volume_", "peak_pressure_")


class _Value(NamedTuple):
    """The value of a key in a row."""

    key: str
    name: str
    """The key with the unit, as columns of files have it."""
    number: Any
    """The value in SI; text where it is none."""
    unit: str

    def shown(self) -> str:
        """Return the value in its usual unit."""
        return _archard.quantity(self.number, self.unit) if isinstance(self.number, float) else str(self.number)


def _shown(name: str, number: float) -> str:
    return shown(name, float(number)) if np.isfinite(number) else ""


def sweep(
    case: Case | str | os.PathLike[str] | Mapping[str, Any],
    over: Mapping[str, Sequence[Any]] | Iterable[Mapping[str, Any]] | None = None,
    *,
    sample: Mapping[str, str] | None = None,
    samples: int | None = None,
    seed: int | None = None,
    design: Literal["latin", "sobol", "saltelli"] | None = None,
    accuracy: float | None = None,
    progress: bool = False,
    executor: Executor | None = None,
    out: str | os.PathLike[str] | None = None,
    laws: Mapping[str, WearFunction | Law] | None = None,
    friction: FrictionFunction | None = None,
) -> Sweep:
    """Run a case over values of its keys, each row on one thread of a worker.

    Rows that fail are recorded with their error; the others go on. With ``out`` rows that are done are not run
    again, and rows that were interrupted go on, so that the same call finishes what was killed. Workers have to
    see that folder.

    Args:
        case: the case, or what makes one.
        over: values by key, each with each of the others; or a dict a row, for designs of one's own.
        sample: distributions by key, as ``"lognormal(1e-13 1/Pa, 0.5)"``; all samples at each of the values of
            ``over``. The command draws them and runs the rows, in ``out``, on all processors.
        samples: number of samples.
        seed: which set of them; the command's own if not given.
        design: how they are drawn; ``"latin"`` if not given.
        accuracy: the relative error of all rows, in place of that of the case.
        progress: show a bar of rows, by tqdm where it is installed, otherwise by log messages.
        executor: any :class:`concurrent.futures.Executor`: Dask's ``client.get_executor()``,
            ``mpi4py.futures.MPIPoolExecutor``; a pool of processes if not given.
        out: folder for ``rows/0001`` and on, a result folder each, and ``sweep.csv``; results are in memory if
            not given.
        laws: wear laws of all rows by the name of their body, as of :meth:`Case.run`. Other processes import them
            by name: they stand at the top level of a module. Rows in ``out`` know them by name only: after a
            change of a law that keeps its name, choose another folder.
        friction: a friction law of all rows, likewise.

    Raises:
        CaseError: all that is wrong with the case of a row, before anything runs.
        ValueError: nothing to go over, a folder with another case, or a law that other processes cannot import.

    """
    base, functions = Case(case), _Laws(laws, friction)
    if accuracy is not None:
        base["accuracy"] = accuracy
    if sample is not None:
        if executor is not None or laws or friction is not None:
            raise ValueError("the command draws samples and runs them: it takes no executor and no functions")
        if out is None or samples is None:
            raise ValueError("samples need their number, `samples`, and a folder, `out`")
        if not (over is None or isinstance(over, Mapping)):
            raise ValueError("samples are drawn at values by key, not at rows")
        return _sampled.run(base, over or {}, sample, (samples, seed, design), (Path(out), progress))
    if samples is not None or seed is not None or design is not None:
        raise ValueError("`samples`, `seed` and `design` are of distributions: give `sample`")
    settings = _rows(over or {})
    if executor is None:
        functions.travel()
    for key in {key for row in settings for key in row}:
        functions.refuse(key)
    cases, values, folders = [], [], []
    for number, row in enumerate(settings, 1):
        one = base.copy()
        for key, value in row.items():
            one[key] = value
        folder = None if out is None else Path(out).absolute() / "rows" / f"{number:04}"
        one = one if folder is None else one._in(folder)
        checked = functions.check(one)
        kept = None if folder is None else _text(folder / "case.toml")
        if kept is not None and not functions.is_kept(one, kept):
            raise ValueError(f"{folder} holds another case: choose another folder, or remove this one")
        cases.append(one)
        values.append([_number(key, checked.toml) for key in row])
        folders.append(folder)
    if executor is None:
        with ProcessPoolExecutor() as pool:
            rows = _run_all(pool, settings, cases, folders, functions, progress)
    else:
        rows = _run_all(executor, settings, cases, folders, functions, progress)
    study = Sweep(rows, values, None if out is None else Path(out))
    if out is not None:
        _write(Path(out) / "sweep.csv", study.table)
        if isinstance(over, Mapping):
            _put_design(Path(out), values)
    return study


def _put_design(folder: Path, values: list[list[_Value]]) -> None:
    """Write the design as the command does, whose pictures are drawn by it."""
    names = [one.name for one in values[0]]
    columns = {name: np.array([row[place].number for row in values]) for place, name in enumerate(names)}
    _write(folder / "design.csv", Table(columns))
    part = folder / f"study.json.{os.getpid()}.part"
    part.write_text(json.dumps({"over": names, "sample": [], "design": "grid"}, indent=2) + "\n", "utf-8")
    part.replace(folder / "study.json")


def _rows(over: Mapping[str, Sequence[Any]] | Iterable[Mapping[str, Any]]) -> list[dict[str, Any]]:
    if isinstance(over, Mapping):
        for key, values in over.items():
            if isinstance(values, str) or not len(values):
                raise ValueError(f"`{key}`: give a list of values to go over")
        rows = [dict(zip(over, values, strict=True)) for values in itertools.product(*over.values())]
    else:
        rows = [dict(row) for row in over]
    if not rows or not all(rows):
        raise ValueError("a study goes over something: give lists of values by key, or a dict a row")
    return rows


def _run_all(
    executor: Executor,
    settings: list[dict[str, Any]],
    cases: list[Case],
    folders: list[Path | None],
    laws: _Laws,
    progress: bool,
) -> list[Row]:
    pairs = zip(cases, folders, strict=True)
    futures = [executor.submit(_run, case, folder, laws) for case, folder in pairs]
    try:
        outcomes = []
        with bar(progress) as show:
            for number, future in enumerate(futures, 1):
                outcomes.append(future.result())
                log.info("row %d of %d: %s", number, len(futures), outcomes[-1][1] or "done")
                show(number, len(futures))
    except BaseException:
        for future in futures:
            future.cancel()
        raise
    rows = []
    for row, folder, (result, error) in zip(settings, folders, outcomes, strict=True):
        if folder is not None and (folder / "summary.json").exists():
            result = open_result(folder)
        rows.append(Row(row, result, error))
    return rows


def _run(case: Case, folder: Path | None, laws: _Laws) -> tuple[Result | None, str | None]:
    """Run a row; of one in a folder the result stays there."""
    try:
        if folder is None:
            return case.run(threads=1, laws=laws.wear, friction=laws.friction), None
        kept = _text(folder / "case.toml")
        own = kept is not None and laws.is_kept(case, kept)
        if own and (folder / "summary.json").exists():
            known = open_result(folder)
            if known.complete:
                return None, known.verdict.wrong or None
        if own and (folder / "checkpoint").exists():
            case.run(threads=1, resume=folder, laws=laws.wear, friction=laws.friction)
        else:
            case.run(threads=1, out=folder, laws=laws.wear, friction=laws.friction)
    except RunError as error:
        return (error.result if folder is None else None), str(error).splitlines()[0]
    return None, None


def _text(path: Path) -> str | None:
    try:
        return path.read_text("utf-8")
    except FileNotFoundError:
        return None


def _number(key: str, toml: str) -> _Value:
    """Return the value of a key in SI."""
    found: Any = _toml.read(toml)
    for name in _toml.path(key):
        found = found.get(name) if isinstance(found, dict) else None
    if isinstance(found, str):
        number, _, unit = found.partition(" ")
        try:
            return _Value(key, key + _suffix(unit), float(number), unit)
        except ValueError:
            return _Value(key, key, found, "")
    if found is None:
        return _Value(key, key, "", "")
    return _Value(key, key, found if isinstance(found, int | float) else _toml.value(found), "")


def _suffix(unit: str) -> str:
    if unit.startswith("1/"):
        return "_per" + _suffix(unit[2:])
    for letter in "^ ()":
        unit = unit.replace(letter, "")
    return "_" + unit.replace("/", "_per_") if unit else ""


def _table(rows: list[Row], keys: list[dict[str, Any]]) -> Table:
    """Numbers of a run that stopped before its end are not its results."""
    done = [row.result if row.result is not None and row.result.complete else None for row in rows]
    last = [{} if result is None else result.summary["last"] for result in done]
    status = ["failed" if result is None else "done" for result in done]
    verdict = ["" if result is None else result.verdict.word for result in done]
    names = list(dict.fromkeys(name for row in last for name in row))
    table = Table(
        {name: np.array([row.get(name, np.nan) for row in keys]) for name in dict.fromkeys(itertools.chain(*keys))}
    )
    table["status"], table["verdict"] = np.array(status), np.array(verdict)
    table["reason"] = np.array(["" if result is None else _reason(result) for result in done])
    for name in names:
        numbers = [row.get(name) for row in last]
        table[name] = np.array([np.nan if number is None else number for number in numbers], float)
    table["error"] = np.array([row.error or "" for row in rows])
    return table


def _reason(result: Result) -> str:
    """What the verdict says against a result."""
    lines = (line for line in result.verdict.lines if line["word"] != "good")
    return "; ".join(line["words"] for line in lines if "words" in line)


def _write(path: Path, table: Table) -> None:
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    with part.open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["row", *table])
        for number, row in enumerate(zip(*table.values(), strict=True), 1):
            rows.writerow([number, *("" if cell != cell else cell for cell in row)])
    part.replace(path)
