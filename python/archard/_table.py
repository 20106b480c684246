"""Tables of results: columns by name."""

from __future__ import annotations

import csv
import io
from typing import Any

import numpy as np
from numpy.typing import NDArray

from archard import _html
from archard._units import shown, unit

Array = NDArray[np.float64]


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

    def __repr__(self) -> str:
        rows = next((len(column) for column in self.values()), 0)
        return f"{type(self).__name__}({rows} rows: {', '.join(self)})"

    def _repr_html_(self) -> str:
        def end(name: str, place: int) -> str:
            column = self[name]
            if not len(column):
                return ""
            return shown(name, float(column[place])) if column.dtype.kind == "f" else str(column[place])

        rows = [[name, end(name, 0), end(name, -1)] for name in self]
        count = next((len(column) for column in self.values()), 0)
        return _html.block(_html.title(f"{count} rows"), _html.table(["Column", "First", "Last"], rows))


def read(content: bytes) -> Table:
    """Return the table that a CSV file of results holds."""
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
