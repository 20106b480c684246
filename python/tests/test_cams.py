"""A cam and its follower: the same as the command's."""

import csv
from pathlib import Path

import numpy as np
import pytest

import archard


def test_surfaces_are_those_of_the_command(command, tmp_path: Path) -> None:
    """Every column of every angle, place and step."""
    command("run", archard.case._CASES / "cam_follower", "-o", str(tmp_path / "out"), "--quiet")
    worn = archard.cams.wear("cam_follower")
    for name, columns in (("cam.csv", worn.cam), ("follower.csv", worn.follower), ("course.csv", worn.course)):
        with (tmp_path / "out" / name).open() as file:
            rows = list(csv.DictReader(file))
        assert set(columns) == set(rows[0])
        for column, values in columns.items():
            assert [float(row[column]) for row in rows] == values.tolist()
    assert worn.life is None


def test_a_life_is_told() -> None:
    """That of an eccentric circle, in proportion to the turns: 12 pm a turn at its nose."""
    case = archard.Case("cam_follower")
    del case["body.cam.profile"]
    case["body.cam.profile.eccentric"] = {"radius": "20 mm", "eccentricity": "4 mm"}
    case["motion.cam"] = {"width": "10 mm", "preload": "1000 N", "turns": 1e7}
    case["until.wear_depth_cam"] = "12 um"
    del case["body.tappet.wear"]
    worn = archard.cams.wear(case)
    body, turns, error = worn.life
    assert body == "cam"
    assert abs(turns - 1e6) < error < 1e4
    depth = np.interp(90, worn.cam["angle_deg"], worn.cam["wear_depth_cam_m"])
    assert abs(depth - 10e-6) < 1e-3 * 10e-6


def test_other_cases_are_refused() -> None:
    """A case of other bodies is none of a cam."""
    with pytest.raises(ValueError, match="not a case of a cam"):
        archard.cams.wear("hertz")
