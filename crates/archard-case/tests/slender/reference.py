#!/usr/bin/env python3
"""Reference displacements of cantilevers by three-dimensional finite elements.

    python3 reference.py            all of them, a line each
    python3 reference.py --l-shape  the L-shape with a hole (needs gmsh)

Writes input for CalculiX (`ccx`, Debian's calculix-ccx), runs it and prints the displacement along z of the
middle of the loaded end, in mm: E = 1 GPa, nu = 0.3, one end clamped, a uniform shear of 1 kPa along z on the
other. Elements are C3D20R, structured, shorter towards the clamp.
"""

import math
import os
import subprocess
import sys
import tempfile

YOUNG, POISSON, SHEAR = 1e9, 0.3, 1e3
POINT = 0.5773502691896258
# Corners and middles of a C3D20's edges on a lattice of half steps, in the order of CalculiX.
CORNERS = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
MIDDLES = [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
           (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]


def face_loads(places):
    """Consistent loads along z of a uniform shear on a face of eight nodes."""
    loads = [0.0] * 8
    corner = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    middle = [(0, -1), (1, 0), (0, 1), (-1, 0)]

    def shapes(s, t):
        values = [0.25 * (1 + s * a) * (1 + t * b) * (s * a + t * b - 1) for a, b in corner]
        values += [0.5 * (1 - s * s) * (1 + t * b) if a == 0 else 0.5 * (1 + s * a) * (1 - t * t)
                   for a, b in middle]
        return values

    line = [(-math.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (math.sqrt(0.6), 5 / 9)]
    for s, ws in line:
        for t, wt in line:
            e = 1e-6
            ds = [(a - b) / (2 * e) for a, b in zip(shapes(s + e, t), shapes(s - e, t))]
            dt = [(a - b) / (2 * e) for a, b in zip(shapes(s, t + e), shapes(s, t - e))]
            along = [[sum(d * p[i] for d, p in zip(der, places)) for i in range(3)] for der in (ds, dt)]
            (a, b, c), (d, f, g) = along
            area = math.sqrt((b * g - c * f) ** 2 + (c * d - a * g) ** 2 + (a * f - b * d) ** 2)
            for i, value in enumerate(shapes(s, t)):
                loads[i] += ws * wt * area * value * SHEAR
    return loads


def lattice(counts, place, closed=False):
    """Nodes and elements of a structured block; `place` maps three parameters from 0 to 1; the second axis
    may close on itself."""
    nodes, known = {}, {}

    def node(i, j, k):
        if closed:
            j %= 2 * counts[1]
        key = (i, j, k)
        if key not in known:
            known[key] = len(known) + 1
            nodes[known[key]] = place(i / (2 * counts[0]), j / (2 * counts[1]), k / (2 * counts[2]))
        return known[key]

    elements, ends = [], []
    for i in range(counts[0]):
        for j in range(counts[1]):
            for k in range(counts[2]):
                at = [node(2 * i + a, 2 * j + b, 2 * k + c) for a, b, c in CORNERS + MIDDLES]
                elements.append(at)
                if i == counts[0] - 1:
                    ends.append([at[n] for n in (1, 2, 6, 5, 9, 18, 13, 17)])
    clamped = [number for (i, _, _), number in known.items() if i == 0]
    return nodes, elements, ends, clamped


def solve(nodes, elements, kind, clamped, loads, name):
    """Displacements of all nodes."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, name + ".inp"), "w") as out:
            out.write("*NODE, NSET=ALL\n")
            out.writelines(f"{n},{x:.12g},{y:.12g},{z:.12g}\n" for n, (x, y, z) in nodes.items())
            out.write(f"*ELEMENT, TYPE={kind}, ELSET=E\n")
            for number, at in enumerate(elements, 1):
                first, rest = at[:10], at[10:]
                out.write(f"{number}," + ",".join(map(str, first)) + ("," if rest else "") + "\n")
                if rest:
                    out.write(",".join(map(str, rest)) + "\n")
            out.write(f"*MATERIAL, NAME=M\n*ELASTIC\n{YOUNG},{POISSON}\n*SOLID SECTION, ELSET=E, MATERIAL=M\n")
            out.write("*BOUNDARY\n" + "".join(f"{n},1,3\n" for n in clamped))
            out.write("*STEP\n*STATIC\n*CLOAD\n")
            out.writelines(f"{n},{d},{f:.12g}\n" for (n, d), f in loads.items())
            out.write("*NODE FILE\nU\n*END STEP\n")
        subprocess.run(["ccx", name], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        found, reading = {}, False
        for line in open(os.path.join(folder, name + ".frd")):
            if line.startswith(" -4  DISP"):
                reading = True
            elif reading and line.startswith(" -3"):
                break
            elif reading and line.startswith(" -1"):
                found[int(line[3:13])] = [float(line[13 + 12 * i:25 + 12 * i]) for i in range(3)]
        return found


def tip(counts, place, at, closed=False):
    """Displacement along z (mm) of the node nearest to a place."""
    nodes, elements, ends, clamped = lattice(counts, place, closed)
    loads = {}
    for face in ends:
        for number, load in zip(face, face_loads([nodes[n] for n in face])):
            loads[number, 3] = loads.get((number, 3), 0.0) + load
    found = solve(nodes, elements, "C3D20R", clamped, loads, "beam")
    number = min(nodes, key=lambda n: math.dist(nodes[n], at))
    return 1e3 * found[number][2], sum(loads.values())


def graded(u):
    """Shorter elements towards the clamp."""
    return u * (0.5 + 0.5 * u)


def bar(length, n):
    """1 m squared."""
    place = lambda u, v, w: (length * graded(u), v - 0.5, w - 0.5)
    return tip([round(1.5 * n * length ** 0.5) * 2, n, n], place, (length, 0, 0))


def tube(length, inner, n):
    """1 m outside, the middle of the wall beside the axis."""
    def place(u, v, w):
        radius, angle = inner + (0.5 - inner) * w, -2 * math.pi * v
        return (length * graded(u), radius * math.cos(angle), radius * math.sin(angle))
    return tip([round(3 * n * length ** 0.5), 8 * n, n], place, (length, 0.5 * (0.5 + inner), 0), True)


def main():
    for length in (10, 5, 3):
        for n in (4, 8):
            print(f"bar   {length:2d} m  n = {n}  %.4f mm, load %.3f N" % bar(length, n), flush=True)
    for inner in (0.25, 0.4):
        for length in (10, 5, 3):
            for n in (2, 3):
                line = f"tube  {length:2d} m  bore {inner}  n = {n}  %.4f mm, load %.3f N"
                print(line % tube(length, inner, n), flush=True)


if __name__ == "__main__":
    if "--l-shape" in sys.argv:
        import l_shape
        l_shape.main()
    else:
        main()
