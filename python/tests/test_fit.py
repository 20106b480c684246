"""Coefficients from measured tests: the same as the command finds."""

import json

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


def test_what_is_wrong_is_told(case):
    columns = {"test": ["A", "A"], "distance_m": [0.02, 0.01], "depth_um": [1.0, 0.5]}
    with pytest.raises(ValueError, match="line 3: `distance` goes back"):
        archard.fit(case, columns)
    with pytest.raises(ValueError, match="a CSV file, a dict of columns or a data frame"):
        archard.fit(case, [1, 2])
    with pytest.raises(KeyError):
        archard.fit(case, data(case, [1.33e-13]))["body.disc.wear.archard.coefficient"]
