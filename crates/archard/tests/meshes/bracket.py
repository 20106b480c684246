"""How far CalculiX bends the bracket of `bracket.step`, clamped at its end, under 1 N on a square of 1 mm of its boss.

Needs the packages gmsh and numpy, and `ccx` in the path: `python bracket.py 0.07 2` prints the mean displacement (um) of the square, from
quadratic tetrahedra of these lengths (mm) below it and elsewhere.
"""

import pathlib
import subprocess
import sys
import tempfile

import gmsh
import numpy as np

near, far = float(sys.argv[1]), float(sys.argv[2])
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.open(str(pathlib.Path(__file__).with_name("bracket.step")))
geometry, mesh = gmsh.model.occ, gmsh.model.mesh
square = geometry.addRectangle(-0.5, -0.5, 8, 1, 1)
geometry.fragment([(3, 1)], [(2, square)])
geometry.synchronize()
mesh.field.add("MathEval", 1)
outside = [f"(0.5*(Fabs(Fabs({axis})-0.5)+Fabs({axis})-0.5))^2" for axis in "xy"]
mesh.field.setString(1, "F", f"{near}+0.35*Sqrt({'+'.join(outside)}+(z-8)^2)")
mesh.field.setAsBackgroundMesh(1)
gmsh.option.setNumber("Mesh.MeshSizeMax", far)
for option in ("MeshSizeExtendFromBoundary", "MeshSizeFromPoints"):
    gmsh.option.setNumber(f"Mesh.{option}", 0)
mesh.generate(3)
mesh.setOrder(2)

tags, places, _ = mesh.getNodes()
places = dict(zip(tags, places.reshape(-1, 3)))
kinds, _, nodes = mesh.getElements(3)
tetrahedra = nodes[list(kinds).index(11)].reshape(-1, 10)
# A pressure of 1 MPa, even on the square: a third of each triangle on the nodes in the middles of its edges.
force: dict[int, float] = {}
for _, face in gmsh.model.getEntities(2):
    if abs(geometry.getCenterOfMass(2, face)[2] - 8) < 1e-6 and abs(geometry.getMass(2, face) - 1) < 1e-6:
        for triangle in mesh.getElements(2, face)[2][0].reshape(-1, 6):
            a, b, c = (places[node] for node in triangle[:3])
            area = 0.5 * np.linalg.norm(np.cross(b - a, c - a))
            for node in triangle[3:]:
                force[node] = force.get(node, 0.0) + area / 3

lines = ["*NODE, NSET=ALL"]
lines += [f"{tag}, {x:.12g}, {y:.12g}, {z:.12g}" for tag, (x, y, z) in places.items()]
lines += ["*ELEMENT, TYPE=C3D10, ELSET=BODY"]
for number, own in enumerate(tetrahedra, 1):
    own = [*own[:8], own[9], own[8]]
    lines += [", ".join(map(str, [number, *own[:9]])) + ",", str(own[9])]
lines += ["*NSET, NSET=HELD", *(str(tag) for tag, place in places.items() if abs(place[0] - 50) < 1e-6)]
lines += ["*NSET, NSET=LOADED", *map(str, force)]
lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", "210000, 0.3", "*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL"]
lines += ["*BOUNDARY", "HELD, 1, 3", "*STEP", "*STATIC", "*CLOAD"]
lines += [f"{tag}, 3, {-own:.12g}" for tag, own in force.items()]
lines += ["*NODE PRINT, NSET=LOADED", "U", "*END STEP", ""]
with tempfile.TemporaryDirectory() as folder:
    pathlib.Path(folder, "bracket.inp").write_text("\n".join(lines))
    subprocess.run(["ccx", "bracket"], cwd=folder, stdout=subprocess.DEVNULL, check=True)
    rows = [line.split() for line in pathlib.Path(folder, "bracket.dat").read_text().splitlines()]
moved = {int(row[0]): float(row[3]) for row in rows if len(row) == 4 and row[0].isdigit()}
print(f"{-1e3 * sum(own * moved[tag] for tag, own in force.items()) / sum(force.values()):.6g} um")
