"""The L-shape with a hole: Gmsh's tetrahedra of ten nodes, CalculiX, and the displacement of the loaded end."""

import math
import os
import subprocess
import tempfile

from reference import SHEAR, solve

HERE = os.path.dirname(os.path.abspath(__file__))


def read(path):
    """Nodes, tetrahedra and triangles of second order with the number of their physical surface."""
    nodes, tetrahedra, triangles, section = {}, [], [], ""
    for line in open(path):
        if line.startswith("$"):
            section = line.strip()
            continue
        cells = line.split()
        if section == "$Nodes" and len(cells) == 4:
            nodes[int(cells[0])] = tuple(map(float, cells[1:]))
        elif section == "$Elements" and len(cells) > 3:
            cells = list(map(int, cells))
            at = cells[3 + cells[2]:]
            if cells[1] == 11:
                tetrahedra.append(at[:8] + [at[9], at[8]])
            elif cells[1] == 9:
                triangles.append((cells[3], at))
    return nodes, tetrahedra, triangles


def tip(size):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "l.msh")
        subprocess.run(["gmsh", os.path.join(HERE, "l_shape.geo"), "-3", "-order", "2", "-format", "msh22",
                        "-setnumber", "size", str(size), "-o", path], check=True, stdout=subprocess.DEVNULL)
        nodes, tetrahedra, triangles = read(path)
    clamped = sorted({n for n, (_, _, z) in nodes.items() if abs(z - 4) < 1e-9})
    loads = {}
    for _, at in triangles:
        if all(abs(nodes[n][0] - 4) < 1e-9 for n in at):
            a, b, c = (nodes[n] for n in at[:3])
            one, two = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
            area = 0.5 * abs(one[1] * two[2] - one[2] * two[1])
            for n in at[3:]:
                loads[n, 3] = loads.get((n, 3), 0.0) + SHEAR * area / 3
    used = {n for at in tetrahedra for n in at}
    nodes = {n: place for n, place in nodes.items() if n in used}
    clamped = [n for n in clamped if n in used]
    found = solve(nodes, tetrahedra, "C3D10", clamped, loads, "l")
    number = min(nodes, key=lambda n: math.dist(nodes[n], (4, 0.5, 0.5)))
    return 1e3 * found[number][2], nodes[number], sum(loads.values())


def main():
    for size in (0.3, 0.15, 0.1):
        print(f"L-shape  size {size}  %.4f mm at %s, load %.3f N" % tip(size), flush=True)


if __name__ == "__main__":
    main()
