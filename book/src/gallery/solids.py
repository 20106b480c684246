"""Pictures of bodies by themselves: a mesh with its displacements, stresses in a wall."""

from __future__ import annotations

import matplotlib
import meshio
import numpy as np
from fields import BLUE, GREEN, GREY, ORANGE, figure
from matplotlib import pyplot
from mpl_toolkits.mplot3d.art3d import Poly3DCollection


def mesh(result, strains, scale=1e3, turn=35, tilt=25):
    """Draw the mesh of a body with its oblique faces outlined, and displacements of its nodes on Hooke's lines.

    `strains` are those along x, y and z; displacements are drawn `scale` times as large, in mm.
    """
    read = meshio.read(result.folder / "surface.vtu")
    drawn = pyplot.figure(figsize=(9, 4.6))
    one, other = drawn.add_subplot(1, 2, 1, projection="3d"), drawn.add_subplot(1, 2, 2)
    parts = [part for cells in read.cells for part in read.points[cells.data]]
    normals = np.array([np.cross(part[2] - part[0], part[-1] - part[1]) for part in parts])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    oblique = abs(normals).max(axis=1) < 0.999
    # A little darker where they are turned away from the light.
    light = (0.75 + 0.25 * abs(normals @ (0.55, 0.25, 0.8)))[:, None]
    shown = light * np.where(oblique[:, None], matplotlib.colors.to_rgb(ORANGE), (0.86, 0.88, 0.9))
    one.add_collection3d(Poly3DCollection(parts, facecolors=shown, edgecolors="#444444", linewidths=0.5))
    low, high = read.points.min(axis=0), read.points.max(axis=0)
    ticks = {f"{axis}ticks": np.linspace(low[i], high[i], 3) for i, axis in enumerate("xyz")}
    one.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]), **ticks)
    one.set(xlabel="x (m)", ylabel="y (m)", zlabel="z (m)", title="Mesh, the cut in orange")
    one.set_box_aspect(high - low, zoom=0.85)
    one.view_init(tilt, turn)
    places = np.concatenate(read.cell_data["place_m"])
    for i, (axis, colour) in enumerate(zip("xyz", (BLUE, ORANGE, GREEN), strict=True)):
        ends = np.array([low[i], high[i]])
        other.plot(
            ends, strains[i] * ends * scale, color=GREY, linewidth=6, label="Hooke's law" if i == 0 else None
        )
        moved = np.concatenate(read.cell_data[f"displacement_{axis}_m"]) * scale
        other.plot(places[:, i], moved, "o", color=colour, markersize=4, label=f"along {axis}")
    other.set(xlabel="Place along the same axis (m)", ylabel="Displacement (mm)", title="All nodes")
    other.legend()
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
