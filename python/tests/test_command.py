"""Python and the command compute the same numbers, to the last bit."""

import json

import numpy as np
import pytest

import archard

#: A case of each motion, made small.
MOTIONS = {
    "pin_on_disc": {"motion.sliding.distance": "50 mm"},
    "pin_on_disc_track": {"accuracy": 0.1},
    "cattaneo_mindlin": {"frame.elements": [30, 30]},
    "twin_disc": {"accuracy": 0.1, "motion.rolling.revolutions": 300},
    "punch_indentation": {"frame.elements": [24, 24]},
    "custom_expression": {"motion.sliding.distance": "50 mm"},
}


def settings(options):
    for key, value in options.items():
        yield "--set"
        yield f"{key}={json.dumps(value)}"


@pytest.mark.filterwarnings("ignore::archard.ArchardWarning")
@pytest.mark.parametrize("name", MOTIONS)
def test_results_are_those_of_the_command(name, command, tmp_path):
    case = archard.Case(name)
    for key, value in MOTIONS[name].items():
        case[key] = value
    command("run", archard.case._CASES / name, *settings(MOTIONS[name]), "-o", tmp_path, "-q")
    theirs = archard.open(tmp_path)
    for threads in (1, 2):
        ours = case.run(threads=threads)
        assert ours.toml == theirs.toml
        for table in ("history", "profiles", "worn_profiles", "fretting_loop"):
            one, other = getattr(ours, table), getattr(theirs, table)
            assert (one is None) == (other is None)
            for column in one or ():
                np.testing.assert_array_equal(one[column], other[column], strict=True)
        assert len(ours.fields) == len(theirs.fields) > 1
        for one, other in zip(ours.fields, theirs.fields, strict=True):
            assert one.progress == other.progress
            assert one.names == other.names
            for field in one.names:
                np.testing.assert_array_equal(one[field], other[field], strict=True)
        assert ours.verdict == theirs.verdict
        assert ours.summary["last"] == theirs.summary["last"]


def test_a_folder_is_that_of_the_command(case, command, tmp_path):
    ours = tmp_path / "ours"
    case.run(out=ours)
    command("run", ours, "-o", tmp_path / "theirs", "-q")
    files = [path.relative_to(ours) for path in ours.rglob("*") if path.is_file()]
    assert len(files) > 8
    for file in files:
        # The summary has the time that a run took, the list its sum.
        if file.name not in ("summary.json", "manifest.txt") and "lock" not in file.name:
            assert (ours / file).read_bytes() == (tmp_path / "theirs" / file).read_bytes()


def test_a_forecast_reads_like_the_command(case, command):
    said = command("check", archard.case._CASES / "hertz")
    forecast = archard.Case("hertz").check()
    assert f"# The case in SI\n\n{forecast.toml}\n{forecast.text}\n" in said
    assert repr(forecast).startswith("# What to expect\n\nHertz contact")


def test_built_in_cases_are_those_of_the_command(command):
    listed = command("new")
    assert all(name in listed for name in archard.cases())


def test_an_elastic_body_is_that_of_the_command(command, tmp_path):
    command("run", archard.case._CASES / "patch_test", "-o", tmp_path, "-q")
    ours, theirs = archard.Case("patch_test").run(), archard.open(tmp_path)
    one, other = ours.surfaces["surface"], theirs.surfaces["surface"]
    assert one.names == other.names
    for field in one.names:
        np.testing.assert_array_equal(one[field], other[field], strict=True)
    assert one["displacement_m"].shape == (one.x.size, 3)
    assert ours.complete
    assert not ours.fields
    with pytest.raises(ValueError, match=r"^`run` holds an elastic body, of which no pictures are drawn"):
        ours.plot()
    with pytest.raises(ValueError, match="solved at once"):
        archard.Case("patch_test").run(laws={"block": abs})


@pytest.mark.filterwarnings("ignore::archard.ArchardWarning")
def test_a_meshed_contact_is_that_of_the_command(command, tmp_path):
    name = "punch_indentation_block"
    options = {"body.block.mesh.box.contact.elements": [8, 8], "motion.indentation.increments": 8}
    case = archard.Case(name)
    for key, value in options.items():
        case[key] = value
    cache = tmp_path / "cache"
    command("run", archard.case._CASES / name, *settings(options), "-o", tmp_path / "out", "-q", "--cache", cache)
    ours, theirs = case.run(cache=cache), archard.open(tmp_path / "out")
    np.testing.assert_array_equal(ours.fields[-1].pressure, theirs.fields[-1].pressure, strict=True)
    dataset = ours.to_xarray()
    assert dataset.pressure.dims == ("progress", "pair")
