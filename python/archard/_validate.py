"""Measured tests next to what is predicted of them."""

from __future__ import annotations

import json
import os
import tempfile
from typing import Any, NamedTuple

from archard import _archard


class Prediction(NamedTuple):
    """A measured value next to its prediction, in SI."""

    test: str
    """The test."""
    quantity: str
    """What was measured."""
    measured: float
    """The measured value."""
    predicted: float
    """What the others predict of it."""
    interval: tuple[float, float]
    """The 95 % interval in which the measured value lies where the model is right."""
    error: float
    """The prediction less the measured value, relative to that."""
    inside: bool
    """Whether the measured value lies in the interval."""


class Validation:
    """What came of a set of measured tests."""

    def __init__(self, text: str, words: str) -> None:
        self.json: dict[str, Any] = json.loads(text)
        """All of it, in SI."""
        self.title: str = self.json["title"]
        """What was tested."""
        self.rejected: str | None = self.json["rejected"]
        """Why the law is rejected, if it is."""
        self.values: list[Prediction] = [
            Prediction(
                own["test"],
                own["quantity"],
                own["measured"],
                own["predicted"],
                (own["interval_95"][0], own["interval_95"][1]),
                own["error"],
                own["inside"],
            )
            for own in self.json["values"]
        ]
        """Measured values and predictions; none where the law is rejected."""
        self._words = words

    def __repr__(self) -> str:
        return self._words.rstrip()


def validate(folder: str | os.PathLike[str]) -> list[Validation]:
    """Predict the measured tests of sets by each other.

    Args:
        folder: a folder with ``set.toml``, a case and a table of tests, or a folder of such folders.

    Raises:
        ValueError: a set that cannot be used.
        NotConverged: a run failed.

    """
    with tempfile.TemporaryDirectory() as runs:
        return [Validation(*own) for own in _archard.validate(folder, runs)]
