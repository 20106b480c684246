"""A run beside measurements and other runs."""

from __future__ import annotations

import json
import os
import re
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from archard import _archard, _measured, _picture

if TYPE_CHECKING:
    from archard.result import Result


_Options = tuple[list[str], str | None, bool, Path]


class Comparison:
    """A run beside measurements and other runs; prints what ``archard compare`` prints."""

    def __init__(self, text: str, told: dict[str, Any]) -> None:
        self.text = text
        """What was compared and what came out, in words."""
        self._told = told

    def plot(self, *, size: _picture.Size | None = None) -> Any:
        """Draw the picture of the comparison; return the matplotlib figure.

        Args:
            size: ``"column"`` or ``"page"``, the width of a journal's; that of a screen if not given.

        """
        return _picture.draw(_picture.chosen(self._told, None), self._told["mark"], size)

    def __repr__(self) -> str:
        return self.text


def compare(
    result: Result, others: Iterable[Any], columns: Mapping[str, str] | None, body: str | None, levelled: bool
) -> Comparison:
    """Hold a result against others; see :meth:`Result.compare`."""
    with _Place() as place:
        folder, paths = place.of(result, others)
        if not paths:
            raise ValueError("give a measured table or another result to compare with")
        lines, picture = _archard.comparison(folder, paths, place.options(columns, body, levelled))
    return Comparison("\n".join(map(place.plain, lines)), json.loads(picture))


def report(
    result: Result,
    path: Path,
    beside: Iterable[Any],
    columns: Mapping[str, str] | None,
    body: str | None,
    levelled: bool,
) -> None:
    """Write the page of a result; see :meth:`Result.report`."""
    with _Place() as place:
        folder, paths = place.of(result, beside)
        _archard.page(folder, paths, path, place.options(columns, body, levelled))


class _Place:
    """Where what is in memory is written for a time; what is wrong with it is told in words of Python."""

    def __enter__(self) -> _Place:
        self._temporary = tempfile.TemporaryDirectory(prefix="archard-")
        self.root = Path(self._temporary.name)
        return self

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        self._temporary.cleanup()
        if isinstance(error, ValueError):
            said = re.sub(r"--(body|levelled)\b ?", r"\1=", self.plain(str(error)))
            raise ValueError(re.sub(r"--column\b", "`columns`", said)) from None

    def of(self, result: Result, others: Iterable[Any]) -> tuple[Path, list[Path]]:
        """Return the folder of a result, and the files and folders of others."""
        paths: list[Path] = []
        for number, one in enumerate(others, 2):
            if hasattr(one, "_written"):
                paths.append(one._written(self.root / f"run {number}"))
            elif isinstance(one, (str, os.PathLike)):
                paths.append(Path(one))
            else:
                name, content, _ = _measured.table(one)
                paths.append(self.root / f"{name} {number}.csv")
                paths[-1].write_bytes(content)
        return result._written(self.root / "run"), paths

    def options(self, columns: Mapping[str, str] | None, body: str | None, levelled: bool) -> _Options:
        """Return how a run is compared."""
        return [f"{name}={header}" for name, header in (columns or {}).items()], body, levelled, self.root

    def plain(self, text: str) -> str:
        """Return a text without the place, which nobody knows."""
        return text.replace(f"{self.root}{os.sep}", "")
