"""Writes `pressed.msh`: a block of 20 x 20 x 14 mm that a contact of 1 mm radius presses in the middle of its top, in linear tetrahedra.

Needs the package gmsh. Elements are a fifth of the radius long down to 1.1 radii around the middle, and grow by .7 a length from there.
"""

import pathlib

import gmsh

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
geometry, mesh = gmsh.model.occ, gmsh.model.mesh
block = geometry.addBox(-10, -10, -14, 20, 20, 14)
disc = geometry.addDisk(0, 0, 0, 1.35, 1.35)
geometry.fragment([(3, block)], [(2, disc)])
geometry.synchronize()
sides = {"zone": [], "base": [], "rest": []}
for _, face in gmsh.model.getEntities(2):
    _, _, low, right, _, high = gmsh.model.getBoundingBox(2, face)
    name = "zone" if low > -1 and right < 2 else "base" if high < -13 else "rest"
    sides[name].append(face)
for name, faces in sides.items():
    gmsh.model.setPhysicalName(2, gmsh.model.addPhysicalGroup(2, faces), name)
gmsh.model.addPhysicalGroup(3, [1])
mesh.field.add("MathEval", 1)
beyond = "(Sqrt(x^2+y^2+z^2)-1.1)"
mesh.field.setString(1, "F", f"0.2+0.7*0.5*({beyond}+Fabs({beyond}))")
mesh.field.setAsBackgroundMesh(1)
for option in ("MeshSizeExtendFromBoundary", "MeshSizeFromPoints"):
    gmsh.option.setNumber(f"Mesh.{option}", 0)
gmsh.option.setNumber("Mesh.MshFileVersion", 2.2)
mesh.generate(3)
gmsh.write(str(pathlib.Path(__file__).with_name("pressed.msh")))
