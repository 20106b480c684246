"""Surfaces from Python: arrays and objects of other packages in the place of a file."""

import warnings

import numpy as np
import pytest

import archard

# Heights (um) of 7 points along x and 5 along y, in pixels of 2 and 3 um: no symmetry hides a wrong axis.
Y, X = np.mgrid[:5, :7]
HEIGHTS = 0.01 * (3.0 * X - 5.0 * Y + X * Y + 0.3 * X**2)
SCALE = {"pixel": "2 um", "pixel_y": "3 um", "unit": "um"}


def imported(name):
    """Return a package, or skip the test; that it misses others, as mpi4py, is its own affair."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pytest.importorskip(name)


def same(surface, heights=HEIGHTS):
    """Whether that surface was read, in rows along x."""
    assert surface.heights.shape == heights.shape
    np.testing.assert_allclose(surface.heights, 1e-6 * heights, rtol=1e-12, atol=0)
    np.testing.assert_allclose(surface.pixel, (2e-6, 3e-6), rtol=1e-12)
    return True


def test_arrays_are_read_in_rows_along_x():
    surface = archard.surface(HEIGHTS, **SCALE)
    assert same(surface)
    np.testing.assert_allclose(surface.size, (14e-6, 15e-6))
    deviations = 1e-6 * (HEIGHTS - HEIGHTS.mean())
    assert surface.texture["Sa"] == pytest.approx(np.abs(deviations).mean())
    assert surface.texture["Sq"] == pytest.approx(deviations.std())
    assert surface.texture["Sz"] == pytest.approx(np.ptp(deviations))
    assert "7 x 5 points" in repr(surface)
    for other in (HEIGHTS.astype(np.float32), np.asfortranarray(HEIGHTS), np.flipud(np.flipud(HEIGHTS))):
        np.testing.assert_allclose(archard.surface(other, **SCALE).heights, 1e-6 * HEIGHTS, rtol=1e-6, atol=1e-15)
    turned = archard.surface(HEIGHTS, **SCALE, flipped=True, inverted=True)
    np.testing.assert_allclose(turned.heights, -1e-6 * HEIGHTS[::-1], rtol=1e-12)


def test_points_that_were_not_measured_are_masked_or_nan():
    holes = HEIGHTS.copy()
    holes[3, 1] = np.nan
    masked = np.ma.masked_array(HEIGHTS, np.isnan(holes))
    for given in (holes, masked):
        surface = archard.surface(given, **SCALE)
        assert surface.missing == 1
        assert same(surface, holes)
    assert archard.surface(holes, **SCALE, holes="fill").missing == 0


def test_data_arrays_bring_their_scale():
    xarray = imported("xarray")
    places = {
        "x": ("x", 2e-3 * X[0], {"units": "mm"}),
        "y": ("y", 3.0 * Y[:, 0], {"units": "\u00b5m"}),
    }
    array = xarray.DataArray(1e3 * HEIGHTS, places, ("y", "x"), attrs={"units": "nm"})
    assert same(archard.surface(array))
    # Axes are known by their names, and places by their coordinates.
    assert same(archard.surface(array.transpose("x", "y")))
    assert same(archard.surface(array.isel(y=slice(None, None, -1), x=slice(None, None, -1))))
    other = array.rename(x="across", y="along")
    assert same(archard.surface(other))
    in_angstroms = (10.0 * array).assign_attrs(units="angstrom")
    assert same(archard.surface(in_angstroms))
    # What is said in words counts.
    assert archard.surface(array, pixel="4 um").pixel == pytest.approx((4e-6, 4e-6))

    uneven = array.assign_coords(x=("x", [0, 2, 4, 6.1, 8, 10, 12], {"units": "um"}))
    with pytest.raises(ValueError, match="`x` is not equally spaced"):
        archard.surface(uneven)
    with pytest.raises(ValueError, match="`x` has no unit"):
        archard.surface(array.assign_coords(x=array.x.values))
    with pytest.raises(ValueError, match="`furlong` is no unit"):
        archard.surface(array.assign_attrs(units="furlong"))
    with pytest.raises(archard.CaseError, match="`unit`: give it"):
        archard.surface(xarray.DataArray(HEIGHTS, places, ("y", "x")))
    with pytest.raises(ValueError, match="two axes, not 3"):
        archard.surface(array.expand_dims("time"))


def test_what_is_no_surface_is_refused():
    with pytest.raises(archard.CaseError, match="`pixel`: give it"):
        archard.surface(HEIGHTS, unit="um")
    with pytest.raises(archard.CaseError, match=r'`unit = "nm"`\?'):
        archard.surface(1e3 * HEIGHTS, **SCALE)
    with pytest.raises(ValueError, match="two axes, not 1"):
        archard.surface(HEIGHTS[0], **SCALE)
    with pytest.raises(TypeError, match="numbers, not complex128"):
        archard.surface(1j * HEIGHTS, **SCALE)
    with pytest.raises(archard.CaseError, match="expected the name of a file"):
        archard.surface(5)
    with pytest.raises(TypeError, match="not object"):
        archard.surface(object())


def test_surfaces_of_surface_topography():
    topography = imported("SurfaceTopography")
    hole = (Y == 3) & (X == 1)
    size = (7 * 2.0, 5 * 3.0)
    whole = topography.Topography(HEIGHTS.T, size, unit="um")
    assert same(archard.surface(whole))
    marked = topography.Topography(np.ma.masked_array(HEIGHTS.T, hole.T), size, unit="um")
    assert same(archard.surface(marked), np.where(hole, np.nan, HEIGHTS))
    with pytest.raises(archard.CaseError, match="give it"):
        archard.surface(topography.Topography(HEIGHTS.T, size))


def test_surfaces_and_files_of_surfalize(tmp_path):
    surfalize = imported("surfalize")
    with pytest.warns(UserWarning, match="different pixel size"):
        given = surfalize.Surface(HEIGHTS, 2.0, 3.0)
    surface = archard.surface(given)
    assert same(surface)
    assert surface.texture["Sa"] == pytest.approx(1e-6 * given.Sa())
    assert surface.texture["Ssk"] == pytest.approx(given.Ssk())
    assert surface.texture["Sku"] == pytest.approx(given.Sku())
    given.save(tmp_path / "scan.x3p")
    assert same(archard.surface(tmp_path / "scan.x3p"))


def wavy():
    """A case of a wavy surface under a plane."""
    n, pixel = 16, 2e-6
    x = np.arange(n) * 2 * np.pi / n
    # Long along y: an axis for another would be another contact.
    heights = 2e-8 * (np.cos(x)[None, :] + 0.5 * np.cos(2 * x)[:, None])
    steel = {"young": "210 GPa", "poisson": 0.3}
    return heights, {
        "body": {
            "ground": {
                "material": steel,
                "profile": {"surface": {"file": heights, "pixel": f"{pixel} m", "unit": "m"}},
                "wear": {"archard": {"coefficient": "1e-7 mm^3/(N m)"}},
            },
            "flat": {"material": steel, "profile": {"flat": {}}},
        },
        "frame": {"periodic": True},
        "motion": {"sliding": {"load": "100 MPa", "distance": "1 m", "step": "0.5 m"}},
    }


# The surface is too coarse to be good; what it comes to is compared with itself.
@pytest.mark.filterwarnings("ignore")
def test_a_run_keeps_its_surface_and_goes_on(tmp_path, command):
    heights, keys = wavy()
    np.savetxt(tmp_path / "heights.txt", heights)
    written = archard.Case(keys)
    written["body.ground.profile.surface"] = {
        "file": tmp_path / "heights.txt",
        "pixel": "2 um",
        "unit": "m",
    }
    expected = written.run().history["peak_pressure_Pa"]

    case = archard.Case(keys)
    folder = tmp_path / "results"
    run = case.steps(out=folder)
    next(run)
    assert not run.result().complete
    [kept] = folder.glob("heights-*.npy")
    np.testing.assert_array_equal(np.load(kept), heights)
    assert str(kept) in (folder / "case.toml").read_text()

    done = archard.Case(keys).run(resume=folder)
    assert done.complete
    np.testing.assert_allclose(done.history["peak_pressure_Pa"], expected, rtol=1e-9)
    # The case in the folder is read without the array.
    assert "# What to expect" in command("check", folder / "case.toml")
    # A result in memory brings its surface along.
    memory = case.run()
    memory.save(tmp_path / "saved")
    assert (tmp_path / "saved" / kept.name).read_bytes() == kept.read_bytes()


def test_a_case_is_set_and_copied():
    heights, keys = wavy()
    case = archard.Case(keys)
    file = case["body.ground.profile.surface.file"]
    # Equal arrays have one file, which later changes of the array do not reach.
    other = archard.Case(keys).copy()
    assert other["body.ground.profile.surface.file"] == file
    given = heights.copy()
    other["body.ground.profile.surface.file"] = given
    given[:] = 0
    np.testing.assert_array_equal(np.load(other["body.ground.profile.surface.file"]), heights)
    dotted = archard.Case(
        {
            **keys,
            "body": keys["body"]
            | {
                "ground": {
                    "material": keys["body"]["ground"]["material"],
                    "profile.surface.file": heights,
                    "profile.surface.pixel": "2 um",
                    "profile.surface.unit": "m",
                }
            },
        }
    )
    assert dotted["body.ground.profile.surface.file"] == file


def test_a_sweep_finds_its_surfaces_again(tmp_path):
    _, keys = wavy()
    over = {"motion.sliding.load": ["50 MPa", "100 MPa"]}
    first = archard.sweep(keys, over, out=tmp_path / "study")
    assert [row.error for row in first.rows] == [None, None]
    times = {path: path.stat().st_mtime_ns for path in tmp_path.glob("study/rows/*/history.csv")}
    assert len(times) == 2
    archard.sweep(keys, over, out=tmp_path / "study")
    assert {path: path.stat().st_mtime_ns for path in times} == times
