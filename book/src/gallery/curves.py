"""Pictures of curves: sections of bodies, columns of the history, loops of fretting, fields along an axis."""

from __future__ import annotations

import matplotlib
import numpy as np
from fields import BLUE, BODIES, GREEN, GREY, ORANGE, QUANTITIES, field, figure, formula, grid, progress


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
    body=None,
    axis="x",
    outputs=(-1,),
    curves=None,
    levels=None,
    bands=None,
    label=None,
    title=None,
    within=None,
    top=None,
):
    """Draw a field through the middle along an axis, with closed forms of x (mm), levels, and bands of values."""
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
            values = field(snapshot, quantity, body)
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
    for (name, (low, high)), colour in zip((bands or {}).items(), (GREEN, ORANGE), strict=False):
        one.axhspan(low, high, color=colour, alpha=0.12, zorder=0)
        one.text(0.985, (low + high) / 2, name, transform=one.get_yaxis_transform(), ha="right", va="center")
    one.set(xlabel=f"{axis} (mm)", ylabel=label or "{} ({})".format(*QUANTITIES[quantity]), title=title or "")
    one.set_xlim(*((-within, within) if within else (x[0], x[-1])))
    one.set_ylim(bottom=0, top=top)
    one.legend(loc="upper left" if bands else "best")
    return drawn


def beneath(result, body):
    """Draw the largest stresses below a contact over the depth, with those on the surface."""
    table = result.stress(body)
    found = result.stresses[body]
    drawn, axes = figure(5.6)
    one = axes.flat[0]
    kinds = {"von_mises": ("von Mises", BLUE), "shear": ("shear", GREEN), "tension": ("tension", ORANGE)}
    for name, (label, colour) in kinds.items():
        one.plot(table[f"{name}_Pa"] * 1e-6, table["depth_m"] * 1e6, color=colour, linewidth=3, label=f"largest {label}")
        place = found["surface"][name]
        if place:
            one.plot(place["value_Pa"] * 1e-6, 0.0, "o", color=colour, markersize=10, clip_on=False)
    one.plot([], [], "o", color=GREY, label="on the surface")
    strength = (found["yield"] or {}).get("strength_Pa")
    if strength:
        one.axvline(strength * 1e-6, color="black", linestyle=":", linewidth=1.5, label="yield stress")
    one.set(xlabel="Stress (MPa)", ylabel="Depth (µm)")
    one.set_xlim(left=0)
    one.set_ylim(table["depth_m"].max() * 1e6, 0)
    one.legend()
    return drawn
