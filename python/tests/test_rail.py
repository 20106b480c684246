"""A wheel on its rail: the same contacts as the command's, many from one case."""

import csv
from pathlib import Path

import pytest

import archard


def test_contacts_are_those_of_the_command(command, tmp_path: Path) -> None:
    """Every column of every patch, and the side."""
    command("run", archard.case._CASES / "manchester", "-o", str(tmp_path / "out"), "--quiet")
    with (tmp_path / "out" / "contacts.csv").open() as file:
        rows = list(csv.DictReader(file))
    patches = archard.rail.contact("manchester")
    assert len(rows) == len(patches) == 1
    for column, value in patches[0].items():
        written = rows[0][column]
        assert written == value if isinstance(value, str) else float(written) == value


def test_values_take_the_place_of_those_of_the_case() -> None:
    """A shift in SI is that of the case; without friction's roll the wheel carries its load as before."""
    case = archard.Case("manchester")
    case["motion.wheel_rail.shift"] = "1 mm"
    of_case = archard.rail.contact(case)
    contact = archard.rail.Contact("manchester")
    assert contact(shift=1e-3) == of_case
    (heavy,) = contact(wheel_load=50e3)
    (light,) = contact()
    assert heavy["normal_force_N"] > 4.9 * light["normal_force_N"]


def test_what_is_wrong_is_said() -> None:
    """Unknown values, wheels beside their rails, other cases."""
    contact = archard.rail.Contact("manchester")
    with pytest.raises(ValueError, match="`gauge` is no value"):
        contact(gauge=1.4)
    with pytest.raises(archard.RunError, match="over the rail"):
        contact(shift=0.2)
    with pytest.raises(ValueError, match="not a case of a wheel"):
        archard.rail.contact("hertz")
    with pytest.raises(ValueError, match="has no steps"):
        archard.Case("manchester").run()
