"""What is worn between two scans."""

import json

import numpy as np
import pytest

import archard

#: Points, their distance (m), and the radius (m) and depth (m) of a spherical cap that is worn off.
POINTS, PIXEL, RADIUS, DEPTH = 160, 4e-6, 0.12e-3, 3e-6


def scans():
    """Two scans of a textured plate, the later one with a cap worn off, tilted and lifted; in um."""
    random = np.random.default_rng(4)
    texture = 0.05 * random.standard_normal((POINTS, POINTS))
    for axis in (0, 1):
        texture = sum(np.roll(texture, shift, axis) for shift in range(-2, 3)) / 5**0.5
    places = PIXEL * (np.arange(POINTS) - 0.5 * (POINTS - 1))
    x, y = np.meshgrid(places, places)
    noise = lambda: 0.01 * random.standard_normal((POINTS, POINTS))  # noqa: E731
    cap = np.minimum(0.0, 1e6 * DEPTH * ((x**2 + y**2) / RADIUS**2 - 1.0))
    return texture + noise(), texture + cap + noise() + 2.0 + 1e3 * x


def test_a_cap_is_found_with_its_volume():
    """pi R^2 h/2 is worn off, and stands within the interval that is stated."""
    before, after = scans()
    found = archard.difference(before, after, pixel="4 um", unit="um")
    known = np.pi * RADIUS**2 * DEPTH / 2
    low, high = found.worn_volume.interval
    assert low <= known <= high
    assert high - low < 0.05 * known
    assert abs(found.depth.value / DEPTH - 1) < 0.02
    assert found.change.shape == found.regions.shape == (POINTS, POINTS)
    assert np.allclose(found.pixel, PIXEL)
    assert found.regions[POINTS // 2, POINTS // 2] == -1
    assert found.piled_volume is None
    assert "worn volume" in repr(found)


def test_it_is_what_the_command_finds(tmp_path, command):
    """The numbers are those of the command on the same files."""
    paths = [tmp_path / "before.npy", tmp_path / "after.npy"]
    for path, heights in zip(paths, scans(), strict=True):
        np.save(path, heights)
    out = tmp_path / "scar"
    keys = ["--set", "pixel=4 um", "--set", "unit=um"]
    command("compare", "--before", paths[0], "--after", paths[1], *keys, "-o", out)
    told = json.loads((out / "difference.json").read_text())
    found = archard.difference(*paths, pixel="4 um", unit="um")
    for name in ("worn_volume_m3", "net_volume_m3", "depth_m", "scar", "placement"):
        assert found.summary[name] == told[name]


def test_what_takes_off_wear_is_refused():
    """A level or a filter of each scan would take off what is worn; two places have no difference."""
    before, after = scans()
    with pytest.raises(ValueError, match="takes off a part of what is worn"):
        archard.difference(before, after, pixel="4 um", unit="um", level="plane")
    with pytest.raises(archard.CaseError, match="pixel"):
        archard.difference(before, after, unit="um")
    with pytest.raises(ValueError, match="after"):
        archard.difference(before, np.random.default_rng(9).permuted(before), pixel="4 um", unit="um")
