"""What pictures of the gallery are drawn of: fields of an output on a grid in the units shown, and their style."""

from __future__ import annotations

from pathlib import Path

import archard
import matplotlib
import numpy as np
from archard import _archard
from matplotlib import pyplot

#: Colours that differ for everybody (M. Okabe and K. Ito); bodies 1 and 2 are blue and orange, closed forms grey.
BLUE, ORANGE, GREEN, GREY = "#0072B2", "#D55E00", "#009E73", "#BBBBBB"
BODIES = (BLUE, ORANGE)
#: What fields are called, their unit, and how many of it are one in SI.
QUANTITIES = {
    "pressure": ("Pressure", "MPa", 1e-6),
    "traction": ("Traction", "MPa", 1e-6),
    "height": ("Height", "µm", 1e6),
    "wear": ("Wear depth", "µm", 1e6),
}
matplotlib.use("agg")
pyplot.rcParams.update(
    {
        "font.size": 12,
        "axes.grid": True,
        "grid.color": "#DDDDDD",
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.axisbelow": True,
        "legend.frameon": False,
        "lines.linewidth": 2,
        "figure.constrained_layout.use": True,
    }
)


def figure(high, panels=1, **options):
    """Return a figure of 9 inches by so many, with its panels in a row."""
    return pyplot.subplots(1, panels, figsize=(9, high), squeeze=False, **options)


def grid(snapshot, values, mirror=""):
    """Return places along x and y (mm) and a field over them, also of pairs on a mesh that lie on a grid.

    Planes of symmetry, "x", "y" or both, add the mirror images.
    """
    x, y, values = snapshot.x * 1e3, snapshot.y * 1e3, np.asarray(values)
    if values.ndim == 1:
        x, y, places = np.unique(x.round(9)), np.unique(y.round(9)), (y.round(9), x.round(9))
        laid = np.full((y.size, x.size), np.nan)
        laid[np.searchsorted(y, places[0]), np.searchsorted(x, places[1])] = values
        values = laid
    if "x" in mirror:
        x, values = np.concatenate([-x[::-1], x]), np.hstack([values[:, ::-1], values])
    if "y" in mirror:
        y, values = np.concatenate([-y[::-1], y]), np.vstack([values[::-1], values])
    return x, y, values


def field(snapshot, quantity, body):
    """Return a field of an output in the unit of its pictures."""
    if quantity == "pressure":
        values = snapshot.pressure
    elif quantity == "traction":
        values = np.hypot(snapshot.traction_x, snapshot.traction_y)
    elif quantity == "wear":
        values = snapshot.worn[body]
    else:
        # Heights are those of both bodies along one axis, which points into body 2.
        values = snapshot.height[body] * (1.0 if body == next(iter(snapshot.height)) else -1.0)
    return values * QUANTITIES[quantity][2]


def progress(result, snapshot):
    """Return how far the motion of an output has gone, in words."""
    unit, value = next(iter(result.history), ""), snapshot.progress
    if np.isnan(value):
        return ""
    if value == 0.0:
        return "at first" if len(result.fields) > 1 else ""
    if unit == "distance_m":
        return f"after {value:.4g} m" if value >= 1 else f"after {1e3 * value:.4g} mm"
    if unit in ("cycle", "revolutions"):
        return f"after {value:,.0f} {'cycles' if unit == 'cycle' else unit}"
    return ""


def finer(x, y, z, least=150):
    """Return a field between its places too, so that colours and steep sides are drawn smoothly."""
    more_x = np.linspace(x[0], x[-1], max(least, x.size))
    more_y = np.linspace(y[0], y[-1], max(least, y.size))
    z = np.array([np.interp(more_x, x, row) for row in z])
    return more_x, more_y, np.array([np.interp(more_y, y, column) for column in z.T]).T


def opened(result, output):
    """Return an output by its place, or by its file if it is none of a motion."""
    if isinstance(output, str):
        content = (result.folder / output).read_bytes()
        return archard.Snapshot(np.nan, *_archard.read_fields(Path(output).name, content))
    return result.fields[output]


def formula(text, **names):
    """Return what a formula of `seen.toml` gives, an expression of Python over arrays."""
    return eval(text, {"exp": np.exp, "sqrt": np.sqrt, "cos": np.cos, "where": np.where, "pi": np.pi, **names})
