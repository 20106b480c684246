"""Logs of tribometers."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any

from archard import _archard


def read_log(
    file: str | os.PathLike[str],
    columns: Mapping[str, str] | None = None,
    values: Mapping[str, str] | None = None,
) -> dict[str, Any]:
    """Read the log of a tribometer: rate, friction and their 95 % intervals, in SI.

    Args:
        file: text as the instrument wrote it, or that text in gzip.
        columns: columns by what they hold, as ``{"wear": "Displacement [um]"}``.
        values: what the log does not hold, as ``{"load": "5 N"}``.

    Raises:
        ValueError: a log that cannot be read. A step without a coefficient has the reason in ``refused``.

    """
    pairs = [list((given or {}).items()) for given in (columns, values)]
    told: dict[str, Any] = json.loads(_archard.read_log(file, *pairs))
    return told
