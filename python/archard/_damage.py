"""Files of results that are damaged, named in the errors of those who read them."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from xml.etree import ElementTree

#: What readers raise of files that are damaged.
_RAISED = (ValueError, KeyError, IndexError, ElementTree.ParseError, csv.Error)


def place(folder: Path | None, name: str) -> str:
    """Return a file of a result as messages name it."""
    return f"`{name if folder is None else folder / name}`"


@contextmanager
def naming(folder: Path | None, name: str) -> Iterator[None]:
    """Name the file in errors of one that is damaged."""
    try:
        yield
    except _RAISED as error:
        raise ValueError(f"{place(folder, name)} is damaged: {error}") from error
