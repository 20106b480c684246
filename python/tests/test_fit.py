"""Coefficients from measured tests: the same as the command finds."""

import json
from pathlib import Path

import numpy as np
import pytest

import archard

KEY = "body.pin.wear.archard.coefficient"


def data(case, coefficients, off=(1.02, 0.97, 1.01)):
    """Depths as runs with these coefficients have them, each off by a little."""
    columns = {"test": [], "distance_m": [], "depth_um": []}
    for test, coefficient in enumerate(coefficients):
        one = case.copy()
        one[KEY] = f"{coefficient} 1/Pa"
        history = one.run().history
        for row, factor in zip((4, 8, 12), off, strict=True):
            columns["test"].append(f"T{test}")
            columns["distance_m"].append(float(history["distance_m"][row]))
            columns["depth_um"].append(1e6 * factor * float(history["wear_depth_pin_m"][row]))
    return columns


def test_a_coefficient_with_its_intervals(case, tmp_path, command):
    columns = data(case, [1.0e-13, 1.33e-13, 1.6e-13])
    fit = archard.fit(case, columns, uncertain={"motion.sliding.load": 0.01}, out=tmp_path / "fit")
    [found] = fit.coefficients
    assert found == fit[KEY]
    assert found.unit == "1/Pa"
    assert found.rejected is None
    low, high = found.interval
    assert low < 1.33e-13 < high
    assert found.next_test[0] < low
    assert high < found.next_test[1]
    assert set(found.tests) == {"T0", "T1", "T2"}
    assert "motion.sliding.load" in found.budget
    assert "next test" in repr(fit)
    written = json.loads((tmp_path / "fit" / "fit.json").read_text())
    assert written == fit.json
    file = tmp_path / "tests.csv"
    lines = [",".join(columns), *(",".join(map(str, row)) for row in zip(*columns.values(), strict=True))]
    file.write_text("\n".join(lines))
    (tmp_path / "case.toml").write_text(case.check().toml)
    common = ["--uncertain", "motion.sliding.load=1%"]
    command("fit", tmp_path / "case.toml", "--data", file, *common, "-o", tmp_path / "two")
    other = json.loads((tmp_path / "two" / "fit.json").read_text())["coefficients"][0]
    assert other["median"] == pytest.approx(found.median, rel=1e-6)


def test_data_frames_and_files_are_read_alike(case, tmp_path):
    pandas = pytest.importorskip("pandas")
    columns = data(case, [1.0e-13, 1.5e-13])
    frame = pandas.DataFrame(columns).rename(columns={"depth_um": "Tiefe [um]"})
    frame.loc[0, "Tiefe [um]"] = None
    file = tmp_path / "tests.csv"
    frame.to_csv(file, index=False, sep=";", decimal=",")
    one, other = (archard.fit(case, given, columns={"depth": "Tiefe [um]"}) for given in (frame, str(file)))
    assert one[KEY].median == pytest.approx(other[KEY].median, rel=1e-9)


def test_names_of_tests_are_taken_as_they_are(case):
    columns = data(case, [1.0e-13, 1.33e-13, 1.6e-13])
    named = {"T0": "#1", "T1": "a;b, c", "T2": '"'}
    other = {**columns, "test": [named[test] for test in columns["test"]]}
    one, other = (archard.fit(case, given)[KEY] for given in (columns, other))
    assert list(other.tests) == list(named.values())
    assert other.median == one.median


def test_what_is_wrong_is_told(case):
    columns = {"test": ["A", "A"], "distance_m": [0.02, 0.01], "depth_um": [1.0, 0.5]}
    with pytest.raises(ValueError, match="line 3: `distance` goes back"):
        archard.fit(case, columns)
    with pytest.raises(ValueError, match="a CSV file, a dict of columns or a data frame"):
        archard.fit(case, [1, 2])
    with pytest.raises(ValueError, match="'depth_um': 1"):
        archard.fit(case, {**columns, "depth_um": [1.0]})
    with pytest.raises(KeyError):
        archard.fit(case, data(case, [1.33e-13]))["body.disc.wear.archard.coefficient"]


def test_several_keys_are_fitted_together():
    data = {"test": ["A", "A", "B"], "distance_m": [50, 100, 100], "depth_um": [0.2, 0.4, 0.4]}
    keys = [f"body.disc.{part}wear.archard.coefficient" for part in ("layers.0.", "")]
    case = archard.Case("coated_disc")
    del case["accuracy"]
    case["frame"] = {"size": ["0.3 mm", "0.3 mm"], "elements": [16, 16]}
    case["motion.sliding.tolerance"] = 0.1
    case["motion.sliding.distance"] = case["output.every"] = "100 m"
    with pytest.raises(ValueError, match="is given twice"):
        archard.fit(case, data, parameter=[keys[0], keys[0]])
    with pytest.raises(ValueError, match=f"do not determine `{keys[1]}`"):
        archard.fit(case, data, parameter=keys)


def test_wear_that_no_test_tells_is_assumed_by_its_key():
    case = archard.Case("pin_on_disc_both")
    del case["accuracy"]
    case["frame.size"], case["frame.elements"] = ["0.8 mm", "0.8 mm"], [16, 16]
    case["motion.sliding.step"] = "50 mm"
    columns = {"test": ["A", "A"], "distance_m": [0.2, 0.4], "volume_pin_mm3": [1.4e-4, 2.7e-4]}
    disc = "body.disc.wear.archard.coefficient"
    with pytest.raises(ValueError, match=f'no reading that tells `{disc}`.*add assume="{disc}" to'):
        archard.fit(case, columns)
    found = archard.fit(case, columns, assume=disc)
    assert any(disc in remark for remark in found.remarks)
    assert found.verdict.word in repr(found)
    assert found.verdict.word == found.json["verdict"]["word"] == "doubtful"


def two_bodies(**changes):
    """A fit of two bodies as the library hands it over."""
    own = {
        "unit": "1/Pa",
        "interval_95": [1e-14, 1e-12],
        "next_test_95": [1e-14, 1e-12],
        "next_test_log_deviation": 0.3,
        "next_test_degrees_of_freedom": 8,
        "scatter_between_tests": 0.3,
        "readings": None,
        "tests": [],
        "distance": None,
        "load": None,
        "budget": [],
        "rejected": None,
        **changes,
    }
    coefficients = [{**own, "key": "one", "median": 1e-13}, {**own, "key": "other", "median": 4e-14}]
    together = {"value": 0.9, "tests": 9}
    return archard.Fit(
        json.dumps(
            {
                "coefficients": coefficients,
                "remarks": [],
                "verdict": {"word": "good", "lines": []},
                "surfaces": [],
                "correlation_of_coefficients": together,
            }
        ),
        "",
        "",
    )


def test_samples_are_those_of_the_next_tests():
    fit = two_bodies()
    rows = fit.samples(4000, seed=3)
    assert rows == fit.samples(4000, seed=3)
    assert rows != fit.samples(4000, seed=4)
    logs = {key: np.log([float(row[key].removesuffix(" 1/Pa")) for row in rows]) for key in ("one", "other")}
    for own in fit.coefficients:
        assert np.median(logs[own.key]) == pytest.approx(np.log(own.median), abs=0.02)
        # The 97.5 % quantile of Student's t of eight degrees of freedom is 2.306.
        assert np.quantile(logs[own.key], 0.975) - np.log(own.median) == pytest.approx(0.3 * 2.306, rel=0.08)
    ranks = [np.argsort(np.argsort(logs[key])) for key in logs]
    # Normal deviates of correlation r have ranks of 6/pi asin(r/2): 0.891 of 0.9, here of 4000.
    assert np.corrcoef(ranks)[0, 1] == pytest.approx(0.891, abs=0.015)


def test_samples_that_cannot_be_drawn():
    with pytest.raises(ValueError, match="to predict with: why"):
        two_bodies(rejected="why").samples(2)
    with pytest.raises(ValueError, match="fewer than three tests"):
        two_bodies(next_test_log_deviation=None).samples(2)
    with pytest.raises(ValueError, match="fewer than three tests"):
        two_bodies(next_test_degrees_of_freedom=1).samples(2)


def test_profiles_in_files_are_readings(case, tmp_path):
    radius, random = 50e-3, np.random.default_rng(5)
    x = np.linspace(-0.6e-3, 0.6e-3, 601)
    lines = ["test,distance_m,file"]
    for test, coefficient in enumerate([1.0e-13, 1.33e-13, 1.6e-13]):
        one = case.copy()
        one[KEY] = f"{coefficient} 1/Pa"
        worn = one.run().profile("pin", axis="x")
        depth = np.interp(x, worn.coordinate, worn.worn, left=0.0, right=0.0)
        z = (
            -(x**2) / (radius + np.sqrt(radius**2 - x**2))
            - depth
            + 2e-3 * x
            + 0.5e-8 * random.standard_normal(x.size)
        )
        rows = [f"{1e3 * place + 4:.6f},{1e6 * height:.6f}" for place, height in zip(x, z, strict=True)]
        (tmp_path / f"{test}.csv").write_text("\n".join(["x [mm],Tiefe [um]", *rows]))
        lines.append(f"T{test},0.024,{test}.csv")
    file = tmp_path / "tests.csv"
    file.write_text("\n".join(lines))
    fit = archard.fit(case, str(file), columns={"z": "Tiefe [um]"})
    paths = {"test": ["T0"], "distance_m": [0.024], "file": [tmp_path / "0.csv"]}
    [surface] = archard.fit(case, paths, columns={"z": "Tiefe [um]"}).surfaces
    assert surface["worn_m2"] == fit.surfaces[0]["worn_m2"]
    low, high = fit[KEY].interval
    assert low < 1.33e-13 < high
    assert [round(1e3 * surface["tilt"][0], 1) for surface in fit.surfaces] == [2.0] * 3
    assert "profile_x" in repr(fit)


def test_missing_values_of_pandas_are_gaps(case):
    pandas = pytest.importorskip("pandas")
    columns = data(case, [1.0e-13, 1.5e-13])
    frame = pandas.DataFrame(columns)
    gap = frame.astype({"depth_um": "Float64"})
    gap.loc[0, "depth_um"] = pandas.NA
    one, other = archard.fit(case, gap), archard.fit(case, frame.drop(index=0))
    assert one[KEY].median == other[KEY].median


def test_measured_tests_are_predicted():
    sets = Path(__file__).parents[2] / "validation"
    [found] = archard.validate(sets / "mccoll")
    assert found.rejected is None
    assert all(own.inside for own in found.values)
    depth = next(own for own in found.values if own.quantity == "depth")
    # The mean of the middle 0.1 mm of the published profile.
    assert depth.measured == pytest.approx(2.64e-6, rel=0.04)
    assert depth.interval[0] < depth.predicted < depth.interval[1]
    assert found.title in repr(found)
    [rejected] = archard.validate(sets / "te67")
    assert "distance" in rejected.rejected
    assert not rejected.values
    with pytest.raises(ValueError, match=r"set\.toml"):
        archard.validate(Path(__file__).parent)


def test_a_worn_wheel_gives_its_coefficient(tmp_path):
    """A wheel of one operating point, worn by a run with twice the coefficient."""
    case = archard.Case("wheel_wear")
    for key in ("until", "reprofiling", "motion.wheel_rail.route"):
        del case[key]
    case["frame"] = {"elements": 16}
    case["motion.wheel_rail"] = {
        "side": "right",
        "wheel_load": "55 kN",
        "speed": "25 m/s",
        "shift": "2 mm",
        "yaw": "1 mrad",
        "distance": "20000 km",
    }
    case["body.wheel.wear"] = {"archard": {"coefficient": "4e-15 1/Pa"}}
    worn = archard.rail.wear(case).profiles["wheel", "right"]
    np.savetxt(
        tmp_path / "worn.csv",
        1e3 * np.column_stack([worn["y_worn_m"], worn["z_worn_m"]]),
        delimiter=",",
        header="y,z",
        comments="",
    )
    case["body.wheel.wear.archard.coefficient"] = "2e-15 1/Pa"
    data = {"test": ["A"], "distance_km": [20000], "file": [str(tmp_path / "worn.csv")]}
    (found,) = archard.fit(case, data).coefficients
    assert found.key == "body.wheel.wear.archard.coefficient"
    low, high = found.interval
    assert low < 4e-15 < high
    assert found.median == pytest.approx(4e-15, rel=0.02)
    with pytest.raises(ValueError, match="two bodies in contact"):
        archard.fit("gear_flanks", data)
