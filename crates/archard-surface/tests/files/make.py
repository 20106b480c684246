"""Writes the surfaces of this folder by the packages that they are named after.

Made with SurfaceTopography 1.27.1, surfalize 0.19.2, x3pio 2.0.0 and gwyfile 0.3.0 of PyPI.
"""

import numpy as np
import x3pio
from gwyfile.objects import GwyContainer, GwyDataField
from surfalize import Surface
from SurfaceTopography import Topography
from SurfaceTopography.IO.GWY import write_gwy
from SurfaceTopography.IO.X3P import write_x3p

# Heights (nm) of 5 points along x and 4 along y, one of which was not measured; pixels of 2 and 3 um.
y, x = np.mgrid[:4, :5]
heights = 1e-9 * (3 * x - 50 * y + 7 * x * y)
hole = (y == 2) & (x == 1)
marked = np.where(hole, np.nan, heights)
size = (5 * 2e-6, 4 * 3e-6)

# SurfaceTopography has x first.
topography = Topography(np.ma.masked_array(heights.T, mask=hole.T), size, unit="m")
for kind in "DFLI":
    write_x3p(topography, f"surface_topography_{kind}.x3p", dtype=kind)
write_gwy(topography, "surface_topography.gwy")
topography.to_netcdf("surface_topography.nc")

micro = Surface(1e6 * marked, 2.0, 3.0)
for ending in ("x3p", "sur", "sdf"):
    micro.save(f"surfalize.{ending}")

x3pio.write("x3pio.x3p", marked, x_scale=2e-6, y_scale=3e-6)

field = {"xreal": size[0], "yreal": size[1], "si_unit_xy": "m"}
tree = GwyContainer()
tree["/0/data/title"] = "Phase"
tree["/0/data"] = GwyDataField(heights, si_unit_z="deg", **field)
tree["/3/base/palette"] = "Gray"
tree["/3/data/title"] = "Height"
tree["/3/data"] = GwyDataField(1e6 * heights, si_unit_z="um", **field)
tree["/3/mask"] = GwyDataField(hole.astype(float), si_unit_z="", **field)
tree["/11/data"] = GwyDataField(2 * heights, si_unit_z="m", **field)
tree.tofile("gwyfile.gwy")
