"""Studies of the command: samples that it draws, and folders that it wrote."""

from __future__ import annotations

import csv
import json
import os
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from archard import _toml
from archard._errors import ResultWarning
from archard._table import Table
from archard.case import Case
from archard.result import read as read_result

if TYPE_CHECKING:
    from archard._sweep import Sweep


def run(
    case: Case,
    over: Mapping[str, Sequence[Any]],
    sample: Mapping[str, str],
    drawn: tuple[int, int | None, str | None],
    place: tuple[Path, bool],
) -> Sweep:
    """Have the command draw samples and run all rows in a folder; see :func:`archard.sweep`."""
    (samples, seed, design), (out, progress) = drawn, place
    case.check()
    words = [f"--sample={key}={distribution}" for key, distribution in sample.items()]
    for key, values in over.items():
        words.append(f"--over={key}=" + ";".join(v if isinstance(v, str) else _toml.value(v) for v in values))
    words.append(f"--samples={samples}")
    words += [] if seed is None else [f"--seed={seed}"]
    words += [] if design is None else [f"--design={design}"]
    words += [] if progress else ["--quiet"]
    own = case._in(out.absolute() / "surfaces") if case._held else case
    with _file(own) as file:
        settings = [f"--set={option}" for option in own._options]
        command = [sys.executable, "-m", "archard", "sweep", file, *words, *settings, "-o", os.fspath(out)]
        ended = subprocess.run(command, stderr=None if progress else subprocess.PIPE, text=True, check=False)
    # A row that failed is a row of the table.
    if ended.returncode not in (0, 1) or not (out / "sweep.csv").is_file():
        raise ValueError((ended.stderr or "the study did not end").strip())
    return read(out)


@contextmanager
def _file(case: Case) -> Iterator[str]:
    """Return a file of the case as written: its own, or one where the files that it names are looked for."""
    own = Path(case._name)
    if own.is_file() and own.read_text("utf-8") == case._text:
        yield os.fspath(own)
        return
    with tempfile.NamedTemporaryFile(
        "w", suffix=".toml", prefix=".archard-", dir=case._folder, encoding="utf-8"
    ) as file:
        file.write(case._text)
        file.flush()
        yield file.name


def read(folder: Path) -> Sweep:
    """Return the study in a folder; see :meth:`Sweep.open`."""
    from archard._sweep import Row, Sweep

    if not (folder / "study.json").is_file():
        raise FileNotFoundError(f"`{folder}` holds no study over values by key")
    kind: dict[str, list[str]] = json.loads((folder / "study.json").read_text("utf-8"))
    if not (folder / "sweep.csv").is_file():
        raise FileNotFoundError(f"`{folder}` holds a study without rows: run it first")
    with (folder / "sweep.csv").open(newline="", encoding="utf-8") as file:
        heads, *cells = list(csv.reader(file))
    columns = {head: [row[place] for row in cells] for place, head in enumerate(heads) if head != "row"}
    table = Table({head: np.array(own) if head in _WORDS else _column(own) for head, own in columns.items()})
    names = [*kind["over"], *kind["sample"]]
    rows, values = [], []
    for index, error in enumerate(table["error"].tolist()):
        own = folder / "rows" / f"{index + 1:04}"
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ResultWarning)
            result = read_result(own, keep=False) if (own / "summary.json").is_file() else None
        case = (own / "case.toml").read_text("utf-8") if (own / "case.toml").is_file() else ""
        found = [_value(name, table[name][index], case) for name in names]
        rows.append(Row({one.key: one.shown() for one in found}, result, error or None))
        values.append(found)
    return Sweep(rows, values, folder, table)


#: The columns that are words, in no row of which there may be one.
_WORDS = ("status", "verdict", "reason", "regime", "error")


def _column(cells: Sequence[str]) -> Any:
    """Return numbers, or texts where one of them is none."""
    try:
        return np.array([float(cell) if cell else np.nan for cell in cells])
    except ValueError:
        return np.array(cells)


def _value(name: str, number: Any, toml: str) -> Any:
    """Return the value of a column, whose key is its name without the unit that the case gives it."""
    from archard._sweep import _number, _Value

    parts = name.split("_")
    for count in range(len(parts), 0, -1):
        known = _number("_".join(parts[:count]), toml) if toml else None
        if known is not None and known.name == name and known.number != "":
            own = number.item() if isinstance(number, np.generic) else number
            return known._replace(number=own)
    return _Value(name, name, number, "")
