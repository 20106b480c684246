"""Measured tables: files, or columns in memory."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any


def table(data: Any) -> tuple[str, bytes, Path]:
    """Return the name and the bytes of a table, and the folder of the files it names."""
    if isinstance(data, (str, os.PathLike)):
        return os.fspath(data), Path(data).read_bytes(), Path(data).parent
    if hasattr(data, "to_dict") and hasattr(data, "columns"):
        data = {str(name): list(data[name]) for name in data.columns}
    if not isinstance(data, Mapping) or not data:
        raise ValueError("data are a CSV file, a dict of columns or a data frame")
    text = io.StringIO()
    # Without quotes a row that begins with `#` would be a comment.
    writer = csv.writer(text, quoting=csv.QUOTE_ALL)
    lengths = {name: len(column) for name, column in data.items()}
    if len(set(lengths.values())) > 1:
        raise ValueError(f"columns are of one length, a row a reading; these are not: {lengths}")
    writer.writerow(data)
    writer.writerows([_cell(value) for value in row] for row in zip(*data.values(), strict=True))
    return "data", text.getvalue().encode(), Path()


def _cell(value: Any) -> str:
    """Return the text of a value; what is not a number was not measured."""
    if value is None or type(value).__name__ in ("NAType", "NaTType") or value != value:
        return ""
    if isinstance(value, os.PathLike):
        return str(os.fspath(value))
    return str(value) if isinstance(value, (str, int)) else repr(float(value))
