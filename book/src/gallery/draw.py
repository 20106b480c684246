"""Draw the pictures of the gallery, one a case, from result folders with their plots: ``draw.py FOLDER..``.

What is drawn stands in ``seen.toml``: ``picture`` names one of the pictures of ``archard plot``, which is
only scaled, or a function of this file; the other keys of the case go to the function.
"""

from __future__ import annotations

import sys
from io import BytesIO
from pathlib import Path

import archard
import matplotlib
import numpy as np
from archard import _archard, _toml
from matplotlib import pyplot
from PIL import Image

HERE = Path(__file__).parent
WIDTH, HIGHEST = 900, 650
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


def surface(
    result,
    body=None,
    quantity="height",
    outputs=(-1,),
    within=None,
    cut=False,
    turn=-62,
    tilt=38,
    mirror="",
    share=0.34,
):
    """Draw a worn surface in 3D, or pressures over it, at one output or several.

    `within` is half the width shown (mm); `cut` takes the half in front away; heights are drawn to a `share`
    of the width.
    """
    name, unit, _ = QUANTITIES[quantity]
    shown, panels = [], len(outputs)
    for output in outputs:
        snapshot = opened(result, output)
        x, y, z = finer(*grid(snapshot, field(snapshot, quantity, body), mirror))
        if within:
            x_in, y_in = abs(x) <= within, abs(y) <= within
            x, y, z = x[x_in], y[y_in], z[np.ix_(y_in, x_in)]
        if cut:
            y, z = y[y >= 0.0], z[y >= 0.0]
        shown.append((snapshot, x, y, z))
    new = None
    if cut and quantity == "height":
        # The section as it was before, above the first row.
        middle = abs(snapshot.y).argmin()
        new = shown[-1][3][0] + np.interp(x, snapshot.x * 1e3, field(snapshot, "wear", body)[middle])
    low, high = min(z.min() for *_, z in shown), max(z.max() for *_, z in shown)
    options = {"projection": "3d", "computed_zorder": False}
    drawn, axes = figure(5.4 if panels == 1 else 4.8, panels, subplot_kw=options)
    for one, (snapshot, x, y, z) in zip(axes.flat, shown, strict=True):
        options = {"cmap": "cividis", "vmin": low, "vmax": high, "rcount": 150, "ccount": 150}
        faces = one.plot_surface(*np.meshgrid(x, y), z, linewidth=0, antialiased=False, **options)
        if cut:
            one.plot(x, 0.0 * x + y[0], z[0], color="black", linewidth=1.5)
        if new is not None:
            one.plot(x, 0.0 * x + y[0], new, "--", color=ORANGE, linewidth=2, label="new")
            one.legend(loc="upper left")
            high = max(high, new.max())
        wide, deep = np.ptp(x), np.ptp(y)
        high_drawn = share * max(wide, deep)
        one.set_box_aspect((wide, deep, high_drawn), zoom=1.1 if max(wide, deep) < 2.5 * min(wide, deep) else 1.0)
        one.set(xlim=(x[0], x[-1]), ylim=(y[0], y[-1]), zlim=(low, high), xlabel="x (mm)", ylabel="y (mm)")
        one.view_init(tilt, turn)
        one.xaxis.labelpad = one.yaxis.labelpad = 8
        one.locator_params(nbins=4)
        one.tick_params(labelsize=10)
        when = progress(result, snapshot)
        if panels > 1:
            title = when
        else:
            title = ", ".join(word for word in (f"{name} of the {body}" if body else name, when) if word)
        if quantity == "height" and panels == 1:
            times = high_drawn / ((high - low) * 1e-3)
            title += f"; heights {float(f'{times:.2g}'):g} times as large"
        one.set_title(title, fontsize=13)
    place = {"shrink": 0.7, "pad": 0.07, "aspect": 18}
    if panels > 1:
        place = {"location": "bottom", "shrink": 0.5, "pad": 0.02, "aspect": 30}
    bar = drawn.colorbar(faces, ax=list(axes.flat), **place)
    bar.set_label(f"{name} ({unit})")
    return drawn


def plan(
    result, quantities, body=None, outputs=(-1,), arrows=0, within=None, mirror="", to_scale=True, stick=True
):
    """Draw maps of a field: of several quantities at one output, or of one at several.

    `arrows` is how many tractions are drawn along a row, as arrows; a line surrounds the part that sticks.
    """
    each = [(quantity, output) for quantity in quantities for output in outputs]
    first = opened(result, outputs[0])
    wide = np.ptp(first.x) > 3 * np.ptp(first.y)
    if wide:
        drawn, axes = pyplot.subplots(len(each), 1, figsize=(9, 2 * len(each)), squeeze=False, sharex=True)
    else:
        drawn, axes = figure(6.2 if len(each) == 1 else 4.4, len(each), sharey=True)
    for one, (quantity, output) in zip(axes.flat, each, strict=True):
        snapshot = opened(result, output)
        x, y, z = grid(snapshot, field(snapshot, quantity, body), mirror)
        # Whole worn surfaces have no pressures.
        pressure = grid(snapshot, snapshot.pressure, mirror)[2] if "pressure_Pa" in snapshot.names else z
        name, unit, _ = QUANTITIES[quantity]
        if quantity != "height":
            z = np.ma.masked_where(z <= 0.0 if quantity == "wear" else pressure <= 0.0, z)
        # One scale for all outputs, without the last thousandth of their values.
        alike = np.concatenate([np.ravel(field(opened(result, at), quantity, body)) for at in outputs])
        limits = (
            dict(zip(("vmin", "vmax"), np.quantile(alike, (0.001, 0.999)), strict=True))
            if len(outputs) > 1
            else {}
        )
        faces = one.pcolormesh(
            x, y, z, cmap="cividis" if quantity == "height" else "viridis", rasterized=True, **limits
        )
        if stick and "stick" in snapshot.names:
            _, _, sticks = grid(snapshot, np.where(snapshot.pressure > 0.0, snapshot.stick, 0.0), mirror)
            if sticks.any():
                one.contour(x, y, sticks, [0.5], colors="white", linewidths=4)
                one.contour(x, y, sticks, [0.5], colors=ORANGE, linewidths=2)
                one.plot([], [], color=ORANGE, label="edge of stick")
        if arrows:
            signs = [(-1 if "x" in mirror else 1), (-1 if "y" in mirror else 1)]
            _, _, across = grid(snapshot, snapshot.traction_x, mirror)
            # On wheels and rails s is along the profile.
            _, _, along = grid(
                snapshot,
                snapshot["traction_y_Pa" if "traction_y_Pa" in snapshot.names else "traction_s_Pa"],
                mirror,
            )
            across = np.where(x[None, :] < 0, signs[0] * across, across)
            along = np.where(y[:, None] < 0, signs[1] * along, along)
            step = max(1, x.size // arrows)
            stride = max(1, round(step * (x[1] - x[0]) / (y[1] - y[0]))) if to_scale else max(1, y.size // arrows)
            every, down = slice(step // 2, None, step), slice(stride // 2, None, stride)
            across, along = (np.where(pressure > 0, part, np.nan)[down, every] for part in (across, along))
            one.quiver(x[every], y[down], across, along, color="black", pivot="mid", width=0.004)
        one.set(ylabel="y (mm)" if wide else "", xlabel="x (mm)", aspect="equal" if to_scale else "auto")
        one.grid(visible=quantity != "height" and not arrows)
        if within:
            one.set(xlim=(-within, within), ylim=(-within, within))
        if len(outputs) == 1 or one is axes.flat[-1]:
            bar = drawn.colorbar(faces, ax=one if len(outputs) == 1 else list(axes.flat), shrink=0.9)
            bar.set_label(f"{name} ({unit})")
        words = [f"{name} of the {body}" if body else name, progress(result, snapshot)]
        one.set_title(
            ", ".join(word for word in words if word) if len(outputs) == 1 else words[1] or words[0], fontsize=13
        )
        if one.get_legend_handles_labels()[1]:
            one.legend(loc="upper right", frameon=True, framealpha=0.9)
    axes.flat[0].set_ylabel("y (mm)")
    return drawn


def spots(result, body):
    """Draw the heights of a rough surface in grey and where it touches in orange."""
    snapshot = result.fields[-1]
    drawn, axes = figure(6.3)
    one = axes.flat[0]
    x, y, z = grid(snapshot, field(snapshot, "height", body))
    faces = one.pcolormesh(x, y, z - z.mean(), cmap="Greys_r", rasterized=True)
    touches = np.ma.masked_less_equal(snapshot.pressure, 0.0)
    one.pcolormesh(x, y, touches * 1e-6, cmap=matplotlib.colors.ListedColormap([ORANGE]), rasterized=True)
    share = result.history["contact_area_m2"][-1] / (np.ptp(x) * x.size / (x.size - 1) * 1e-3) ** 2
    one.set(
        xlabel="x (mm)",
        ylabel="y (mm)",
        aspect="equal",
        title=f"Heights, and in orange what touches: {share:.1%} of the surface",
    )
    one.grid(visible=False)
    drawn.colorbar(faces, ax=one, shrink=0.9).set_label("Height from the mean (µm)")
    return drawn


def section(result, bodies, axis="x", within=None, lines=None, apart=0.0, outputs=None):
    """Draw sections of bodies through the contact, from the first output, dashed, to the last.

    `lines` are heights (µm) with a name, `apart` moves the first body up (µm).
    """
    drawn, axes = figure(5.6)
    one = axes.flat[0]
    outputs = outputs or range(len(result.fields))
    shades = np.linspace(0.25, 1.0, len(outputs))
    for body, colour in zip(bodies, BODIES, strict=False):
        moved, upwards = (apart, 1.0) if body == bodies[0] else (0.0, -1.0)
        for place, output in enumerate(outputs):
            cut = result.profile(body, axis, output)
            x, z = cut.coordinate * 1e3, -cut.height * 1e6 + moved
            inside = abs(x) <= (within or np.inf)
            x, z, worn = x[inside], z[inside], cut.worn[inside] * 1e6
            if place == len(outputs) - 1:
                one.plot(x, z - upwards * worn, "--", color=colour, linewidth=1.5, label=f"{body}, new")
                one.plot(
                    x, z, color=colour, linewidth=3, label=f"{body}, {progress(result, result.fields[output])}"
                )
            elif place > 0:
                one.plot(x, z, color=colour, linewidth=1, alpha=shades[place])
    for height, name in (lines or {}).items():
        one.axhline(float(height), color="black", linestyle=":", linewidth=1.5, label=name)
    one.set(xlabel=f"{axis} (mm)", ylabel="Height (µm)", title=f"Sections along {axis}, worn from line to line")
    one.margins(x=0)
    drawn.legend(*one.get_legend_handles_labels(), loc="outside lower center", ncols=3 if lines else 2)
    return drawn


def formula(text, **names):
    """Return what a formula of `seen.toml` gives, an expression of Python over arrays."""
    return eval(text, {"exp": np.exp, "sqrt": np.sqrt, "cos": np.cos, "where": np.where, "pi": np.pi, **names})


def against(result, column, label, curves, scale=1.0, over=1.0, over_label="Distance (m)", points=None):
    """Draw a column of the history as dots, on curves that formulas of the progress s give in SI.

    `scale` and `over` are how many units of the axes one in SI is; `points` are those of another solution,
    in these units.
    """
    drawn, axes = figure(5.6)
    one = axes.flat[0]
    at, values = result.history[next(iter(result.history))], result.history[column]
    s = np.linspace(0.0, at[-1], 400)
    styles = [("-", 6, GREY), ("--", 2, ORANGE), (":", 2.5, "black"), ("-.", 2, GREEN)]
    for (legend, text), (style, width, colour) in zip(curves.items(), styles, strict=False):
        one.plot(
            s * over, (formula(text, s=s) + 0.0 * s) * scale, style, color=colour, linewidth=width, label=legend
        )
    one.plot(at * over, values * scale, "o", color=BLUE, markersize=7, label="computed")
    for legend, places in (points or {}).items():
        one.plot(*np.transpose(places), "D", color=ORANGE, markersize=9, label=legend)
    one.set(xlabel=over_label, ylabel=label)
    one.set_xlim(left=0)
    one.set_ylim(bottom=0)
    one.legend()
    return drawn


def loop(
    result,
    cycles,
    over="shift_x_m",
    columns=("force_x_N", "force_y_N"),
    labels=("Force along x (N)", "Force along y (N)"),
):
    """Draw forces over the shift in some cycles."""
    table = result.fretting_loop
    drawn, axes = figure(4.6, len(columns), sharey=True)
    for one, column, label in zip(axes.flat, columns, labels, strict=True):
        shades = matplotlib.colormaps["viridis"](np.linspace(0.0, 0.8, len(cycles)))
        for cycle, shade in zip(cycles, shades, strict=True):
            inside = (table["cycle"] >= cycle - 1 - 1e-9) & (table["cycle"] <= cycle + 1e-9)
            at, force = table[over][inside] * 1e6, table[column][inside]
            if at[0] != 0.0:
                at, force = np.append(at[-1], at), np.append(force[-1], force)
            one.plot(at, force, color=shade, label=f"cycle {cycle:,}")
        one.set(xlabel="Shift along x (µm)", ylabel=label)
    axes.flat[0].legend()
    return drawn


def along(
    result,
    quantity,
    axis="x",
    outputs=(-1,),
    curves=None,
    levels=None,
    label=None,
    title=None,
    within=None,
    top=None,
):
    """Draw a field through the middle along an axis, with closed forms of the place x (mm) and levels."""
    drawn, axes = figure(5.6)
    one = axes.flat[0]
    shades = matplotlib.colormaps["viridis"](np.linspace(0.0, 0.85, len(outputs)))
    for output, shade in zip(outputs, shades, strict=True):
        snapshot = result.fields[output]
        if quantity == "flash_temperature":
            values = snapshot["flash_temperature_K"]
        elif quantity == "work":
            # Slip is that of the passage of an element.
            values = snapshot.traction_x * snapshot.slip_x / (snapshot.x[1] - snapshot.x[0]) * 1e-6
        else:
            values = field(snapshot, quantity, None)
        x, y, values = grid(snapshot, values)
        if axis == "y":
            x, y, values = y, x, values.T
        middle = abs(y) <= abs(y).min() * 1.001
        if abs(y).min() > 0 and (y > 0).all():
            middle = np.arange(y.size) == 0
        values = values[middle].mean(axis=0)
        if (x > 0).all():
            x, values = np.concatenate([-x[::-1], x]), np.concatenate([values[::-1], values])
        words = progress(result, snapshot) if len(outputs) > 1 else "computed"
        one.plot(x, values, color=shade if len(outputs) > 1 else BLUE, linewidth=2.5, label=words)
    at = np.linspace(-within, within, 801) if within else np.linspace(x[0], x[-1], 801)
    styles = [(GREY, "-", 6), (ORANGE, "--", 2), (GREEN, "-.", 2), ("black", ":", 2)]
    for (legend, text), (colour, style, width) in zip((curves or {}).items(), styles, strict=False):
        with np.errstate(invalid="ignore", divide="ignore"):
            drawn_values = formula(text, x=at) + 0.0 * at
        one.plot(at, drawn_values, style, color=colour, linewidth=width, label=legend, zorder=1)
    for legend, level in (levels or {}).items():
        one.axhline(level, color=ORANGE, linestyle="--", linewidth=1.5, label=legend)
    one.set(xlabel=f"{axis} (mm)", ylabel=label or "{} ({})".format(*QUANTITIES[quantity]), title=title or "")
    one.set_xlim(*((-within, within) if within else (x[0], x[-1])))
    one.set_ylim(bottom=0, top=top)
    one.legend()
    return drawn


def mesh(result, quantity, label, scale=1.0, turn=35, tilt=25):
    """Draw the mesh of a body, its elements coloured by a quantity."""
    import meshio
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    read = meshio.read(result.folder / "surface.vtu")
    drawn, axes = figure(6.2, subplot_kw={"projection": "3d"})
    one = axes.flat[0]
    parts, values = [], []
    for block, cells in enumerate(read.cells):
        parts.extend(read.points[cells.data])
        values.extend(read.cell_data[quantity][block] * scale)
    colours = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(min(values), max(values)), "cividis")
    shown = colours.to_rgba(values)
    # A little darker where they are turned away from the light.
    normals = np.array([np.cross(part[2] - part[0], part[-1] - part[1]) for part in parts])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    shown[:, :3] *= (0.8 + 0.2 * abs(normals @ (0.55, 0.25, 0.8)))[:, None]
    one.add_collection3d(Poly3DCollection(parts, facecolors=shown, edgecolors="white", linewidths=0.4))
    low, high = read.points.min(axis=0), read.points.max(axis=0)
    one.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    one.set(xlabel="x (m)", ylabel="y (m)", zlabel="z (m)")
    one.set_box_aspect(high - low)
    one.view_init(tilt, turn)
    drawn.colorbar(colours, ax=one, shrink=0.7, pad=0.1).set_label(label)
    return drawn


def wall(result, inner, outer, pressure, young, poisson):
    """Draw displacement and stresses at points in the wall of a sphere on Lame's curves."""
    points = {name: np.asarray(column) for name, column in result.points.items() if name != "point"}
    place = np.array([points[f"{axis}_m"] for axis in "xyz"]).T
    r = np.linalg.norm(place, axis=1)
    outwards = place / r[:, None]
    moved = (np.array([points[f"displacement_{axis}_m"] for axis in "xyz"]).T * outwards).sum(axis=1)
    stress = np.array(
        [
            [points[f"stress_{''.join(sorted(a + b)) if {a, b} != {'x', 'z'} else 'zx'}_Pa"] for a in "xyz"]
            for b in "xyz"
        ]
    )
    radial = np.einsum("ijn,ni,nj->n", stress, outwards, outwards)
    hoop = (np.einsum("iin->n", stress) - radial) / 2
    at = np.linspace(inner, outer, 200)
    share = pressure * inner**3 / (outer**3 - inner**3)
    curves = {
        "hoop stress": (share * (1 + outer**3 / (2 * at**3)), hoop, BLUE),
        "radial stress": (share * (1 - outer**3 / at**3), radial, ORANGE),
    }
    drawn, axes = figure(4.6, 2)
    one, other = axes.flat
    lame = share / young * ((1 - 2 * poisson) * at + (1 + poisson) * outer**3 / (2 * at**2))
    one.plot(at, lame * 1e3, color=GREY, linewidth=6, label="Lamé")
    one.plot(r, moved * 1e3, "o", color=BLUE, label="computed")
    one.set(xlabel="Radius (m)", ylabel="Displacement outwards (mm)")
    one.set_ylim(bottom=0)
    one.legend()
    for name, (curve, values, colour) in curves.items():
        other.plot(at, curve * 1e-6, color=GREY, linewidth=6)
        other.plot(r, values * 1e-6, "o", color=colour, label=name)
    other.set(xlabel="Radius (m)", ylabel="Stress (MPa)")
    other.legend()
    return drawn


def scaled(picture):
    """Return a picture of `archard plot` in the width of the gallery."""
    with Image.open(picture) as read:
        wide, high = read.size
        share = min(WIDTH / wide, HIGHEST / high)
        return read.convert("RGB").resize((round(wide * share), round(high * share)), Image.Resampling.LANCZOS)


def rendered(drawn):
    """Return a figure of matplotlib in the width of the gallery."""
    stream = BytesIO()
    drawn.savefig(stream, format="png", dpi=WIDTH / drawn.get_size_inches()[0])
    pyplot.close(drawn)
    return Image.open(stream).convert("RGB")


def main():
    """Draw the picture of each case whose results are given."""
    cases = _toml.read((HERE / "seen.toml").read_text(encoding="utf-8"))
    for folder in map(Path, sys.argv[1:]):
        options = dict(cases[folder.name])
        name, _ = options.pop("picture"), options.pop("seen")
        if name in KINDS:
            picture = rendered(KINDS[name](archard.open(folder), **options))
        else:
            picture = scaled(folder / "plots" / f"{name}.png")
        # A palette, with which no picture of lines and one map takes more than it has to.
        picture.quantize(255, dither=Image.Dither.NONE).save(HERE / f"{folder.name}.png", optimize=True)


KINDS = {kind.__name__: kind for kind in (surface, plan, spots, section, against, loop, along, mesh, wall)}

if __name__ == "__main__":
    main()
