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
    """A shift in SI is that of the case, and five times the load presses about five times as hard."""
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
    with pytest.raises(ValueError, match="not a finite number"):
        contact(wheel_load=float("nan"))
    with pytest.raises(ValueError, match="load"):
        contact(wheel_load=-1.0)
    with pytest.raises(archard.RunError, match="over the rail"):
        contact(shift=0.2)
    with pytest.raises(ValueError, match="not a case of a wheel"):
        archard.rail.contact("hertz")
    with pytest.raises(ValueError, match="has no steps"):
        archard.Case("manchester").run()


ROUTE = {"share": [0.5, 0.5], "shift": [0.0, 3e-3]}


def wearing() -> archard.Case:
    """The case with a wheel that wears over ten kilometres."""
    case = archard.Case("manchester")
    for key, value in {
        "body.wheel.wear.archard.coefficient": "1e-13 1/Pa",
        "motion.wheel_rail.distance": "10 km",
        "motion.wheel_rail.roll": None,
        "frame.elements": 16,
    }.items():
        if value is None:
            del case[key]
        else:
            case[key] = value
    return case


def test_a_route_wears_the_wheel() -> None:
    """As many contacts before as after, volume from step to step, and a depth over the profile with its error."""
    wear = archard.rail.wear(wearing(), ROUTE)
    assert [patch["profiles"] for patch in wear.contacts] == ["new"] * 2 + ["worn"] * 2
    volumes = [step["wheel_worn_volume_m3"] for step in wear.dimensions]
    assert volumes[0] == 0.0
    assert volumes == sorted(volumes)
    profile = wear.profiles["wheel", "right"]
    assert profile["depth_m"].max() == pytest.approx(wear.dimensions[-1]["wheel_depth_m"])
    assert (profile["error_of_depth_m"] >= 0.0).all()
    assert wear.profiles.keys() == {("wheel", "right")}


def test_routes_that_cannot_be_used_are_refused() -> None:
    """Shares, names and lengths of columns."""
    for route, said in [
        ({"share": [0.5, 0.4]}, "add up to 0.9"),
        ({"shift": [0.0]}, "`share`"),
        ({"share": [1.0], "height": [1.0]}, "`height`"),
        ({"share": [0.5, 0.5], "shift": [0.0]}, "not as many"),
    ]:
        with pytest.raises(ValueError, match=said):
            archard.rail.wear(wearing(), route)
