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
    """Read the log of a tribometer, as ``archard log --json`` does: rate, friction and their 95 % intervals, in SI.

    ``columns`` names columns by what they hold (``{"wear": "Displacement [um]"}``), ``values`` gives what the log does not
    hold (``{"load": "5 N"}``). A log that cannot be read raises ``ValueError``; a step without a coefficient says why in
    ``refused``.
    """
    pairs = [list((given or {}).items()) for given in (columns, values)]
    told: dict[str, Any] = json.loads(_archard.read_log(file, *pairs))
    return told
