"""Wear coefficients of a case from measured tests."""

from __future__ import annotations

import json
import os
import re
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from archard import _archard, _html, _measured
from archard._log import log
from archard.case import Case
from archard.result import Verdict


class Exponent(NamedTuple):
    """An exponent that the law says, as the tests show it."""

    exponent: float
    """What the tests show."""
    interval: tuple[float, float]
    """Its 95 % interval."""
    p: float
    """How probable something so far off is if the law holds."""
    rejected: bool
    """Whether the law is rejected: ``p < 0.05``, and the exponent off by more than 0.05."""


class Coefficient(NamedTuple):
    """A coefficient that was fitted, in SI (wear coefficients in 1/Pa)."""

    key: str
    """Its key in the case."""
    unit: str
    """Its unit."""
    median: float
    """The median of the coefficients of tests."""
    interval: tuple[float, float] | None
    """The 95 % interval of the median; ``None`` where nothing tells the errors."""
    next_test: tuple[float, float] | None
    """Where another test, read as these, lies with 95 % probability; ``None`` of one test."""
    scatter: float | None
    """Scatter between tests without that of readings: standard deviation of the natural logarithm."""
    readings: dict[str, float] | None
    """Relative standard uncertainty of a reading of each column."""
    tests: dict[str, float]
    """The coefficient of each test."""
    distance: Exponent | None
    """The exponent of the distance, 1 by the law; ``None`` where readings cannot tell."""
    load: Exponent | None
    """The exponent of the load that the coefficient depends on, 0 by the law; ``None`` without several loads."""
    budget: dict[str, float]
    """Relative standard uncertainties of the median by their sources."""
    rejected: str | None
    """Why the tests have no one coefficient, if so."""


class Fit:
    """What measured tests say of a case; prints what ``archard fit`` prints."""

    def __init__(self, json_text: str, words: str, table: str) -> None:
        self.json: dict[str, Any] = json.loads(json_text)
        """All of it, as ``fit.json`` has it."""
        self._words, self._csv = words, table
        self.coefficients = [_coefficient(one) for one in self.json["coefficients"]]
        """The coefficients, in the order of the bodies."""
        self.surfaces: list[dict[str, Any]] = self.json["surfaces"]
        """What was taken from profiles and height maps, with their tilt and offset (SI)."""
        self.remarks: list[str] = self.json["remarks"]
        """What has to be said of the data and the runs."""
        self.verdict = Verdict(self.json["verdict"]["word"], self.json["verdict"]["lines"])
        """Whether the fit can be believed, as ``archard fit`` says it."""

    def __getitem__(self, key: str) -> Coefficient:
        """Return the coefficient of that key."""
        for coefficient in self.coefficients:
            if coefficient.key == key:
                return coefficient
        raise KeyError(key)

    def __repr__(self) -> str:
        return self._words.rstrip()

    def _repr_html_(self) -> str:
        def shown(unit: str, values: Sequence[float] | None) -> str:
            *low, high = [_archard.quantity(value, unit) for value in values or ()] or ["not known"]
            # Once is enough for a unit that both have.
            own = high.partition(" ")[2]
            return " to ".join([*(one.removesuffix(f" {own}") for one in low), high])

        heads = ["Coefficient", "Median", "95 % of the median", "95 % of the next test", "Tests"]
        rows = [
            [
                one.key,
                shown(one.unit, [one.median]),
                shown(one.unit, one.interval),
                shown(one.unit, one.next_test),
                str(len(one.tests)),
            ]
            for one in self.coefficients
        ]
        judged = [f"{word}: {said}" for word in ("wrong", "doubtful") if (said := getattr(self.verdict, word))]
        said = _html.lines([*judged, *self.remarks])
        whole = _html.folded("in words", _html.words(repr(self)))
        return _html.block(_html.table(heads, rows), said, whole)

    def samples(self, count: int, seed: int = 0) -> list[dict[str, str]]:
        """Draw coefficients as the next tests will have them: the rows of :func:`archard.sweep`, a dict each.

        Student's t on the logarithms; two coefficients of the same tests are drawn with their correlation, as by
        ``archard sweep --from``.

        Raises:
            ValueError: a coefficient that the tests reject, fewer than three tests of it, or three that were
                fitted together.

        """
        if len(self.json.get("correlations") or []) > 2:
            raise ValueError("three coefficients that were fitted together are not drawn")
        together = self.json["correlation_of_coefficients"]
        correlation = together["value"] if together else 0.0
        given = []
        for own, known in zip(self.coefficients, self.json["coefficients"], strict=True):
            scale, degrees = known["next_test_log_deviation"], known["next_test_degrees_of_freedom"]
            if own.rejected is not None:
                raise ValueError(f"the tests give no `{own.key}` to predict with: {own.rejected}")
            if scale is None or degrees < 2:
                raise ValueError(f"fewer than three tests do not tell how `{own.key}` scatters")
            given.append((own.median, scale, degrees))
        points = np.random.default_rng(seed).random((count, len(given)))
        return [
            {own.key: f"{k!r} {own.unit}".rstrip() for own, k in zip(self.coefficients, row, strict=True)}
            for row in _archard.next_tests(given, correlation, points.tolist())
        ]

    def write(self, out: str | os.PathLike[str]) -> None:
        """Write ``fit.json``, which ``archard sweep --from`` reads, and ``fit.csv`` into a folder."""
        folder = Path(out)
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "fit.json").write_text(json.dumps(self.json, indent=2) + "\n", "utf-8")
        (folder / "fit.csv").write_text(self._csv, "utf-8")


def fit(
    case: Case | str | os.PathLike[str] | Mapping[str, Any],
    data: str | os.PathLike[str] | Mapping[str, Sequence[Any]] | Any,
    *,
    parameter: Iterable[str] | str = (),
    columns: Mapping[str, str] | None = None,
    uncertain: Mapping[str, float] | None = None,
    assume: Iterable[str] | str = (),
    out: str | os.PathLike[str] | None = None,
) -> Fit:
    """Find the wear coefficients of a case from measured tests.

    Args:
        case: the case, or what makes one.
        data: a CSV file, a dict of columns or a data frame, a row a reading: ``test``, ``distance_m`` (or
            ``turns``, ``cycles``, ``time_s``), any of ``volume_mm3``, ``depth_um``, ``width_mm``,
            ``length_mm``, ``diameter_mm``, ``section_mm2`` and ``mass_mg``, followed by ``_BODY`` before the
            unit where both bodies wear, ``u_...`` for standard uncertainties, and ``load_N`` where tests have
            loads of their own. ``file`` names profiles (``x_mm`` or ``y_mm``, and ``z_um``) and height maps (all
            three), from which what is worn off is taken; their paths start from the folder of the CSV file, or
            from the working directory. Of a wheel on its rail: ``test``, ``distance_km``, ``file`` with the worn
            profile, and ``side`` where both are computed.
        parameter: the key to be fitted, or several that are fitted together from all readings, as of a coating and
            of what is below it; if not given the coefficient of each body of which there are readings.
        columns: headers of other names, as ``{"depth": "Tiefe [um]"}``; ``x``, ``y`` and ``z`` are those of
            profiles and height maps.
        uncertain: relative standard uncertainties that all tests have in common, as
            ``{"motion.sliding.load": 0.01, "distance": 0.005}``.
        assume: keys of wear coefficients that are taken from the case though there are no readings of that body,
            or that are fitted though the tests do not wear by their law.
        out: folder for ``fit.json``, ``fit.csv`` and the runs of the case; nothing is kept if not given.

    Raises:
        CaseError: all that is wrong with the case.
        ValueError: a reading or a column that cannot be used, with its line, data that do not tell the
            coefficient, or a body that wears without readings and is not in ``assume``.
        NotConverged: a run failed, or the coefficients did not settle.

    """
    one = case if isinstance(case, Case) else Case(case)
    one.check()
    table = _measured.table(data)
    named = list((columns or {}).items())
    common = [(key, float(value)) for key, value in (uncertain or {}).items()]
    assumed = [assume] if isinstance(assume, str) else list(assume)
    parameters = [parameter] if isinstance(parameter, str) else list(parameter or ())

    def run(folder: str | os.PathLike[str]) -> Fit:
        log.info("%r is fitted to %s", one, table[0])
        file = one._in(Path(folder))._compiled()
        try:
            found = Fit(*_archard.fit(file, table, named, parameters, (common, assumed), folder))
        except ValueError as error:
            # What is an option of the command is an argument here.
            said = re.sub(r"--(assume|parameter) (\S+)", r'\1="\2"', str(error))
            raise ValueError(said.replace("put another one there by --set, ", "")) from None
        for known in found.coefficients:
            log.info("%s: median %.4g %s of %d tests", known.key, known.median, known.unit, len(known.tests))
        return found

    if out is None:
        with tempfile.TemporaryDirectory() as folder:
            return run(folder)
    found = run(out)
    found.write(out)
    return found


def _coefficient(own: dict[str, Any]) -> Coefficient:
    return Coefficient(
        key=own["key"],
        unit=own["unit"],
        median=own["median"],
        interval=_pair(own["interval_95"]),
        next_test=_pair(own["next_test_95"]),
        scatter=own["scatter_between_tests"],
        readings=own["readings"],
        tests={test["test"]: test["k"] for test in own["tests"]},
        distance=_exponent(own["distance"]),
        load=_exponent(own["load"]),
        budget={part["source"]: part["relative"] for part in own["budget"]},
        rejected=own["rejected"],
    )


def _exponent(own: dict[str, Any] | None) -> Exponent | None:
    if own is None:
        return None
    low, high = own["interval_95"]
    return Exponent(own["exponent"], (low, high), own["p"], own["rejected"])


def _pair(own: list[float] | None) -> tuple[float, float] | None:
    return None if own is None else (own[0], own[1])
