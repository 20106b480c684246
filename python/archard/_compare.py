"""A run beside measurements and other runs."""

from __future__ import annotations

import json
import os
import re
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from archard import _archard, _measured, _picture

if TYPE_CHECKING:
    from archard.result import Result


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
    with result._on_disk() as folder, _on_disk(others) as paths, _by_arguments():
        if not paths:
            raise ValueError("give a measured table or another result to compare with")
        lines, picture = _archard.comparison(folder, paths, _options(columns, body, levelled))
    # A folder for the time of the comparison is called nothing.
    said = "\n".join(lines) if result.folder is not None else "\n".join(lines).replace(f"`{folder}`", "the run")
    return Comparison(said, json.loads(picture))


def report(
    result: Result,
    path: Path,
    beside: Iterable[Any],
    columns: Mapping[str, str] | None,
    body: str | None,
    levelled: bool,
) -> None:
    """Write the page of a result; see :meth:`Result.report`."""
    with result._on_disk() as folder, _on_disk(beside) as paths, _by_arguments():
        _archard.page(folder, paths, path, _options(columns, body, levelled))


@contextmanager
def _on_disk(others: Iterable[Any]) -> Iterator[list[Path]]:
    """Give the files and folders of others, those in memory for a time."""
    with ExitStack() as stack:
        paths: list[Path] = []
        for number, one in enumerate(others, 2):
            if hasattr(one, "_on_disk"):
                paths.append(stack.enter_context(one._on_disk(f"run {number}")))
            elif isinstance(one, (str, os.PathLike)):
                paths.append(Path(one))
            else:
                name, content, _ = _measured.table(one)
                folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="archard-"))
                paths.append(Path(folder) / f"{name}.csv")
                paths[-1].write_bytes(content)
        yield paths


def _options(
    columns: Mapping[str, str] | None, body: str | None, levelled: bool
) -> tuple[list[str], str | None, bool]:
    return [f"{name}={header}" for name, header in (columns or {}).items()], body, levelled


@contextmanager
def _by_arguments() -> Iterator[None]:
    """What is wrong is told by the names of arguments here, not by the options of the command."""
    try:
        yield
    except ValueError as error:
        said = re.sub(r"--(body|levelled)\b ?", r"\1=", str(error))
        raise ValueError(re.sub(r"--column\b", "columns:", said)) from None
