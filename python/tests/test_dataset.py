"""Datasets of xarray: studies, and results on other grids, within the memory there is."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import archard
from archard import _archard, _dataset

pytestmark = pytest.mark.filterwarnings("ignore::archard.ArchardWarning")


def study(case, over):
    with ThreadPoolExecutor(1) as executor:
        return archard.sweep(case, over, executor=executor)


def test_a_study_is_over_its_keys(case):
    over = {"motion.sliding.load": ["8 N", "10.2 N"], "body.pin.profile.sphere.radius": ["40 mm", "50 mm"]}
    found = study(case, over)
    data = found.to_xarray()
    assert dict(data.sizes) == {"load": 2, "radius": 2, "progress": 5, "y": 24, "x": 24}
    assert data.pressure.dims == ("load", "radius", "progress", "y", "x")
    assert data["load"].attrs == {"units": "N", "long_name": "motion.sliding.load"}
    for row in found.rows:
        load, radius = (float(text.split()[0]) for text in row.settings.values())
        own = data.sel(load=load, radius=1e-3 * radius)
        np.testing.assert_array_equal(own.pressure, row.result.to_xarray().pressure)
        assert own.wear_depth == row.result.history["wear_depth_m"][-1]
        assert own.verdict == row.result.verdict.word
    assert data.wear_depth.attrs["units"] == "m"
    np.testing.assert_array_equal(found.to_xarray(fields=["pressure"]).pressure, data.pressure)
    assert "gap" not in found.to_xarray(fields=["pressure"])
    with pytest.raises(ValueError, match="no field `presure`; there are pressure, "):
        found.to_xarray(fields=["presure"])


def test_rows_of_different_grids_lie_on_a_common_one(case):
    case["motion.sliding.distance"] = "6 mm"
    rows = [
        {"frame.size": ["0.6 mm", "0.6 mm"], "frame.elements": [24, 24]},
        {"frame.size": ["0.8 mm", "0.6 mm"], "frame.elements": [16, 12]},
    ]
    found = study(case, rows)
    data = found.to_xarray(fields=["pressure", "gap"])
    # The finer elements over the wider frame: 0.8 mm over 0.025 mm.
    assert dict(data.sizes) == {"row": 2, "progress": 2, "y": 24, "x": 32}
    fine, coarse = (row.result.to_xarray() for row in found.rows)
    np.testing.assert_allclose(data.pressure[0, :, :, 4:-4], fine.pressure, rtol=1e-12)
    assert np.isnan(data.gap[0, :, :, :4]).all()
    # Means over halves of elements are those of the elements: forces stay.
    np.testing.assert_allclose(data.pressure[1, -1].sum() / 4, coarse.pressure[-1].sum(), rtol=1e-9)
    own = found.rows[1].result.to_xarray(grid=found.rows[0].result)
    np.testing.assert_array_equal(own.x, fine.x)
    again = found.rows[1].result.to_xarray(grid=fine)
    np.testing.assert_array_equal(again.pressure, own.pressure)
    places = found.rows[0].result.to_xarray(grid=(coarse.x, coarse.y))
    assert places.pressure[-1].sum() * 4 == pytest.approx(float(fine.pressure[-1].sum()), rel=1e-9)


def test_progresses_that_differ_are_all_there(case):
    data = study(case, {"motion.sliding.distance": ["12 mm", "18 mm"]}).to_xarray(fields=["wear"])
    np.testing.assert_allclose(data.progress, [0, 6e-3, 12e-3, 18e-3], atol=1e-12)
    assert np.isnan(data.wear.sel(distance=12e-3)[-1]).all()
    assert not np.isnan(data.wear.sel(distance=18e-3)).any()


def test_rows_that_failed_are_missing(case):
    case["solver.conjugate_gradient"] = {"max_iterations": 30}
    data = study(case, {"solver.conjugate_gradient.max_iterations": [1, 1000]}).to_xarray()
    assert np.isnan(data.pressure.sel(max_iterations=1)).all()
    assert data.status.values.tolist() == ["failed", "done"]
    assert data.wear_depth.sel(max_iterations=1000) > 0


def test_lines_of_contact_are_one_row():
    case = archard.Case("carter")
    data = study(
        case,
        {"motion.rolling.load": ["500 kN/m", "600 kN/m"]}
        if "motion.rolling.load" not in case
        else {"friction.coulomb.coefficient": [0.3, 0.4]},
    ).to_xarray(fields=["pressure"])
    assert data.sizes["y"] == 1
    assert not np.isnan(data.pressure).all()


def test_grids_that_are_none_are_refused(case):
    case["motion.sliding.distance"] = "2 mm"
    result = case.run()
    for grid, said in [
        (3, "a grid is a result"),
        ((np.array([0.0, 1e-3, 3e-3]), np.array([0.0])), "equally spaced"),
        ((np.array([1e-3, 0.0]), np.array([0.0])), "rising"),
        ((np.array([0.0, 1e-3]), np.array([0.0])), "one element along an axis"),
    ]:
        with pytest.raises(ValueError, match=said):
            result.to_xarray(grid=grid)
    with pytest.raises(ValueError, match="a list of names"):
        result.to_xarray(fields="pressure")


def test_memory_is_looked_at_before_it_is_taken(case, monkeypatch):
    case["motion.sliding.distance"] = "2 mm"
    result = case.run()
    assert _archard.free_memory() > 1e6
    wide = np.linspace(-1.0, 1.0, 10_000_000)
    with pytest.raises(MemoryError, match=r"on 10000000 x 10000000 elements take .* GB of memory, .* are free"):
        result.to_xarray(grid=(wide, wide))
    taken = 8 * 24 * 24 * len(result.fields)
    monkeypatch.setattr(_dataset._archard, "free_memory", lambda: 1.5 * taken)
    with pytest.warns(archard.ArchardWarning, match="coarser `grid`"):
        assert "pressure" in result.to_xarray(fields=["pressure"])
    with pytest.raises(MemoryError, match="some of them by `fields`"):
        result.to_xarray(fields=["pressure", "gap"])
