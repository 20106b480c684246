"""Cases that say how accurate they have to be."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import archard

PIN = {
    "accuracy": 0.05,
    "body": {
        "pin": {
            "material": {"young": "210 GPa", "poisson": 0.3},
            "profile": {"sphere": {"radius": "50 mm"}},
            "wear": {"archard": {"coefficient": "1.33e-13 1/Pa"}},
        },
        "disc": {"material": {"young": "210 GPa", "poisson": 0.3}, "profile": {"flat": {}}},
    },
    "motion": {"sliding": {"load": "10.2 N", "distance": "100 mm"}},
}


def test_errors_stand_beside_the_results() -> None:
    """The history has them in the unit of each column; they are what was asked for."""
    history = archard.Case(PIN).run().history
    depth = history["wear_depth_m"][-1]
    error = history["error_of_wear_depth_m"][-1]
    assert 0 < error < 0.05 * depth
    assert 0 < history["relative_error"][-1] < 0.05


def test_laws_in_python_are_judged_too() -> None:
    """The runs on coarser grids have them: on given elements, the errors are those of the same law in the case."""
    given = {**PIN, "frame": {"size": ["0.8 mm", "0.8 mm"], "elements": [40, 40]}}
    native = archard.Case(given).run().history
    seen = set()

    def law(p: Any, s: Any) -> Any:
        seen.add(len(p))
        return 1.33e-13 * p * s

    own = archard.Case(given).run(laws={"pin": law}).history
    assert own["wear_depth_m"][-1] == pytest.approx(native["wear_depth_m"][-1], rel=1e-2)
    assert own["relative_error"][-1] == pytest.approx(native["relative_error"][-1], rel=0.1)
    assert own["relative_error"][-1] > 0
    assert len(seen) > 1
    with pytest.raises(ZeroDivisionError):
        archard.Case(PIN).run(laws={"pin": lambda p, s: 1 / 0})
    with pytest.raises(ValueError, match="finite and not negative"):
        archard.Case(PIN).run(laws={"pin": lambda p, s: -p * s})


def test_studies_have_a_grid_a_row(tmp_path: Path) -> None:
    """Every row has the accuracy, on elements of its own; what is done is not run again."""
    over = {"motion.sliding.load": ["5 N", "50 N"]}
    study = archard.sweep(PIN, over, out=tmp_path)
    assert all(row.error is None for row in study.rows)
    assert all(0 < error < 0.05 for error in study.table["relative_error"])
    cases = [(tmp_path / "rows" / row / "case.toml").read_text() for row in ("0001", "0002")]
    sizes = [line for case in cases for line in case.splitlines() if line.startswith("frame.size")]
    assert len(set(sizes)) == 2
    written = (tmp_path / "rows" / "0001" / "summary.json").stat().st_mtime_ns
    archard.sweep(PIN, over, out=tmp_path)
    assert (tmp_path / "rows" / "0001" / "summary.json").stat().st_mtime_ns == written


def test_a_folder_is_refused_before_the_runs_that_judge_elements(tmp_path: Path) -> None:
    """Those may take long, and are for nothing where results of another law are there."""
    archard.Case(PIN).run(out=tmp_path)
    asked = []

    def law(p: Any, s: Any) -> Any:
        asked.append(len(p))
        return 1e-13 * p * s

    with pytest.raises(FileExistsError, match="another case"):
        archard.Case(PIN).run(out=tmp_path, laws={"pin": law})
    assert not asked
    assert archard.Case(PIN).run(out=tmp_path, laws={"pin": law}, force=True).complete
    assert asked
