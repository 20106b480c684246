"""Two gears in mesh: the same flanks as the command's."""

import csv
from pathlib import Path

import pytest

import archard


def test_flanks_are_those_of_the_command(command, tmp_path: Path) -> None:
    """Every column of every station and step."""
    command("run", archard.case._CASES / "gear_flanks", "-o", str(tmp_path / "out"), "--quiet")
    worn = archard.gears.wear("gear_flanks")
    for name, columns in (("flanks.csv", worn.flanks), ("course.csv", worn.course)):
        with (tmp_path / "out" / name).open() as file:
            rows = list(csv.DictReader(file))
        assert set(columns) == set(rows[0])
        for column, values in columns.items():
            assert [float(row[column]) for row in rows] == values.tolist()
    assert worn.life is None


def test_a_life_is_told() -> None:
    """That of the case with a limit, by an independent program."""
    case = archard.Case("gear_flanks")
    case["until.wear_depth_pinion"] = "50 um"
    gear, meshes, error = archard.gears.wear(case).life
    assert gear == "pinion"
    assert abs(meshes - 790858) < 3 + error


def test_other_cases_are_refused() -> None:
    """A case of other bodies is none of gears."""
    with pytest.raises(ValueError, match="not a case of two gears"):
        archard.gears.wear("hertz")
