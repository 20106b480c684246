"""Results: tables, fields, plots, folders and pickles."""

import pickle
import sys
import warnings

import matplotlib
import numpy as np
import pytest

import archard

matplotlib.use("agg")


@pytest.fixture
def result(case):
    return case.run()


def test_fields_are_arrays_over_y_and_x(case):
    case["frame"] = {"size": ["0.6 mm", "0.5 mm"], "elements": [24, 20]}
    case["motion.sliding.distance"] = "6 mm"
    last = case.run().fields[-1]
    assert last.pressure.shape == (20, 24)
    assert (last.x.shape, last.y.shape) == ((24,), (20,))
    assert last.x[0] == pytest.approx(-0.3e-3 + 0.6e-3 / 48)
    area = 0.6e-3 / 24 * 0.5e-3 / 20
    assert last.pressure.sum() * area == pytest.approx(10.2, rel=1e-6)
    assert set(last.worn) == {"pin", "disc"}
    assert set(last.height) == {"pin", "disc"}
    np.testing.assert_array_equal(last.wear, last["wear_m"])
    with pytest.raises(AttributeError, match="no field `traction_x`; there are pressure_Pa"):
        _ = last.traction_x


def test_profiles_are_sections(result):
    along = result.profile("pin", axis="y")
    assert along.worn.max() == pytest.approx(result.fields[-1].worn["pin"].max(), rel=0.01)
    np.testing.assert_array_equal(along.coordinate, result.fields[-1].y)
    assert (np.diff(along.height[:12]) > 0).all()
    np.testing.assert_array_equal(result.profile("pin", output=0).worn, 0)
    with pytest.raises(KeyError, match="ring"):
        result.profile("ring")
    with pytest.raises(ValueError, match="axis"):
        result.profile("pin", axis="z")


def test_units_are_told(result):
    units = result.history.units
    assert units["distance_m"] == "m"
    assert units["contact_area_m2"] == "m^2"
    assert units["worn_volume_pin_m3"] == "m^3"
    assert units["iterations"] == units["solves"] == ""


def test_frames_of_other_libraries(result):
    frame = result.to_pandas()
    assert frame["load_N"].iloc[-1] == result.history["load_N"][-1]
    assert frame.attrs["units"]["load_N"] == "N"
    dataset = result.to_xarray()
    assert dataset.pressure.dims == ("progress", "y", "x")
    assert dataset.pressure.attrs["units"] == "Pa"
    assert dataset.progress.attrs["units"] == "m"
    np.testing.assert_array_equal(dataset.pressure[-1], result.fields[-1].pressure)


def test_outputs_of_smaller_frames_are_resampled():
    case = archard.Case("pin_on_disc")
    del case["accuracy"]
    case["frame"] = {"size": ["0.6 mm", "0.6 mm"], "elements": [24, 24], "doubles": ["40 mm"]}
    case["motion.sliding.step"] = "25 mm"
    case["output.every"] = "250 mm"
    result = case.run()
    first, last = result.fields[0], result.fields[-1]
    assert last.x[-1] - last.x[0] == pytest.approx(2 * (first.x[-1] - first.x[0]))
    dataset = result.to_xarray()
    np.testing.assert_array_equal(dataset.x, last.x)
    pressure = dataset.pressure[0].to_numpy()
    assert np.isnan(pressure[0, 0])
    assert np.isnan(pressure).sum() == 24 * 24 - 12 * 12
    assert 4 * np.nansum(pressure) == pytest.approx(first.pressure.sum())
    np.testing.assert_array_equal(dataset.pressure[-1], last.pressure)
    # A law in Python is that of all frames.
    own = case.run(laws={"pin": lambda p, s: 1.33e-13 * p * s}).history
    np.testing.assert_allclose(own["wear_depth_m"], result.history["wear_depth_m"], rtol=1e-6)


def test_other_libraries_may_be_missing(result, monkeypatch):
    for name, use in [("pandas", result.to_pandas), ("xarray", result.to_xarray), ("matplotlib", result.plot)]:
        monkeypatch.setitem(sys.modules, name, None)
        with pytest.raises(ImportError, match=name):
            use()


def test_a_result_pickles_and_is_saved(result, tmp_path):
    again = pickle.loads(pickle.dumps(result))
    assert repr(again) == repr(result)
    again.save(tmp_path)
    opened = archard.open(tmp_path)
    assert opened.folder == tmp_path
    np.testing.assert_array_equal(opened.fields[-1].pressure, result.fields[-1].pressure)
    assert pickle.loads(pickle.dumps(opened)).toml == result.toml
    with pytest.raises(FileExistsError, match="holds results"):
        result.save(tmp_path)


def test_folders_without_results_are_refused(tmp_path):
    with pytest.raises(FileNotFoundError, match="no folder"):
        archard.open(tmp_path / "none")
    with pytest.raises(FileNotFoundError, match="holds no results"):
        archard.open(tmp_path)


def test_damaged_fields_are_refused(result, tmp_path):
    result.save(tmp_path)
    file = tmp_path / "fields" / "0000.vti"
    file.write_bytes(file.read_bytes()[:200])
    with pytest.raises(ValueError, match=r"0000.vti.*its sum is not the one"):
        archard.open(tmp_path)
    (tmp_path / "manifest.txt").unlink()
    with pytest.raises(ValueError, match=r"0000.vti.*not a file of this program"):
        archard.open(tmp_path).fields[0]
    (tmp_path / "summary.json").unlink()
    with pytest.warns(archard.ResultWarning, match="under way, or was killed"):
        archard.open(tmp_path)


@pytest.mark.parametrize("name", ["history.csv", "profiles.csv", "summary.json", "case.toml"])
def test_a_changed_digit_is_found(result, tmp_path, name):
    result.save(tmp_path)
    file = tmp_path / name
    text = file.read_bytes()
    place = max(place for place, byte in enumerate(text) if byte in b"0123456789")
    file.write_bytes(text[:place] + bytes([text[place] ^ 1]) + text[place + 1 :])
    with pytest.raises(ValueError, match=f"{tmp_path.name}.*{name}.*damaged or was changed"):
        archard.open(tmp_path)


def refusal(folder):
    """Why a folder cannot be read, if it cannot."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", archard.ResultWarning)
            opened = archard.open(folder)
        opened.history, opened.profiles, opened.fields[0], opened.profile("pin")
    except (ValueError, KeyError, IndexError) as error:
        return error
    return None


@pytest.mark.parametrize("name", ["history.csv", "profiles.csv", "summary.json", "fields.pvd", "fields/0000.vti"])
def test_damage_names_its_file(result, tmp_path, name):
    """Of a folder without sums, cut anywhere: nothing, or an error with the file."""
    result.save(tmp_path)
    (tmp_path / "manifest.txt").unlink()
    file = tmp_path / name
    whole = file.read_bytes()
    for length in (0, 1, len(whole) // 3, len(whole) - 3):
        file.write_bytes(whole[:length])
        said = refusal(tmp_path)
        assert said is None or (type(said) is ValueError and str(tmp_path) in str(said)), (length, said)
