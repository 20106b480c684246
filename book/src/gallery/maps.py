"""Pictures of fields: surfaces in 3D and maps."""

from __future__ import annotations

import matplotlib
import numpy as np
from fields import ORANGE, QUANTITIES, field, figure, finer, grid, opened, progress
from matplotlib import pyplot


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
    result,
    quantities,
    body=None,
    outputs=(-1,),
    arrows=0,
    within=None,
    mirror="",
    to_scale=True,
    stick=True,
    top=None,
):
    """Draw maps of a field: of several quantities at one output, or of one at several.

    `arrows` is how many tractions are drawn along a row, as arrows; a line surrounds the part that sticks.
    `top` has the end of the scale of quantities on a few elements of which there is more.
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
        most = (top or {}).get(quantity)
        if most:
            limits = {"vmin": 0.0, "vmax": most}
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
            # Below the maps where there are several, so that each is as large as it can be.
            place = {"location": "bottom"} if len(quantities) > 1 and not wide else {"shrink": 0.9}
            place["extend"] = "max" if most else "neither"
            bar = drawn.colorbar(faces, ax=one if len(outputs) == 1 else list(axes.flat), **place)
            bar.set_label(f"{name} ({unit})")
        of_body = body and quantity in ("height", "wear")
        words = [f"{name} of the {body}" if of_body else name, progress(result, snapshot)]
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
