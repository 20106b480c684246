"""A punch on a cube by Archard and CalculiX, for `book/src/peers.md`: python3 benches/peers/bodies.py.

The punch is a paraboloid, z = 0.005 r^2 / m, pressed 0.07 mm into a steel cube of 1 m, without friction.
CalculiX (`calculix-ccx` of Debian) takes a quarter in quadratic hexahedra that grow from the contact on, and
its contact of surfaces with a penalty; its punch is a layer of elements whose nodes are moved.
"""

import csv
import itertools
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import page

#: Half a side of the cube, its height, and half a side of the zone of even elements (mm).
HALF, HEIGHT, ZONE = 500.0, 1000.0, 100.0
#: The punch goes down (mm); z over r^2 (1/mm).
APPROACH, CURVED = 0.07, 0.005e-3
YOUNG, POISSON = 2.1e5, 0.3
#: By how much an element is longer than its neighbour towards the zone, at most.
GROWTH = 1.3
#: Pressure over penetration (MPa/mm): 123 MPa penetrate by 2e-4 of the approach.
PENALTY = 1e7
#: The load (N), extrapolated from boundary elements of 10 to 28 elements over the zone; uncertain by 3e-4.
LIMIT = 1.8309e6
TURNS = 3

CASE = """title = "A rigid punch on a cube"

[body.punch]
rigid = true
profile.power = {{ coefficient = "0.005 1/m", exponent = 2 }}

[body.cube]
material = {{ young = "210 GPa", poisson = 0.3 }}
mesh.box.size = ["1 m", "1 m", "1 m"]
mesh.box.contact = {{ face = "top", size = ["0.2 m", "0.2 m"], elements = [{count}, {count}] }}
supports = {{ bottom = "clamped" }}
symmetry = ["x", "y"]

[motion.indentation]
approach = "0.07 mm"
increments = 1
"""


def growing(first, reach):
    """Ends of elements from zero to a distance, the first about so long."""
    sizes = []
    while sum(sizes) < reach:
        sizes.append(first * GROWTH ** len(sizes))
    return [reach * end / sum(sizes) for end in itertools.accumulate(sizes)]


class Hexahedra:
    """Elements of 20 nodes between places along x, y and z; numbers follow those of others."""

    ENDS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))

    def __init__(self, places, before=None, lift=0.0):
        self.after = (1 + before.last[0], 1 + before.last[1]) if before else (1, 1)
        self.nodes, self.elements, self.at = {}, [], {}
        for cell in itertools.product(*(range(len(along) - 1) for along in places)):
            corners = [[along[i + a] for along, i, a in zip(places, cell, end, strict=True)] for end in self.ENDS]
            middles = [[0.5 * (p + q) for p, q in zip(corners[a], corners[b], strict=True)] for a, b in self.EDGES]
            self.at[cell] = self.after[1] + len(self.elements)
            self.elements.append([self.node(x, y, z + lift * (x * x + y * y)) for x, y, z in corners + middles])
        self.last = (self.after[0] + len(self.nodes) - 1, self.after[1] + len(self.elements) - 1)

    def node(self, *place):
        """The number of the node at a place."""
        key = tuple(round(value, 6) for value in place)
        return self.nodes.setdefault(key, self.after[0] + len(self.nodes))

    def where(self, axis, value):
        """The nodes whose place along an axis has a value."""
        return [number for place, number in self.nodes.items() if abs(place[axis] - value) < 1e-5]

    def lines(self, name):
        """The elements as lines of an input."""
        yield f"*ELEMENT, TYPE=C3D20R, ELSET={name}"
        for number, nodes in enumerate(self.elements, self.after[1]):
            first, rest = [number, *nodes[:10]], nodes[10:]
            yield ", ".join(map(str, first)) + ","
            yield ", ".join(map(str, rest))


def model(count):
    """The input of CalculiX with so many elements over half of the zone."""
    step = ZONE / count
    even = [step * at for at in range(count + 1)]
    along = even + [ZONE + more for more in growing(GROWTH * step, HALF - ZONE)]
    up = [-depth for depth in reversed([0.0, *growing(step, HEIGHT)])]
    cube = Hexahedra([along, along, up])
    fine = [0.5 * step * at for at in range(2 * count + 1)]
    punch = Hexahedra([fine, fine, [0.0, step]], cube, CURVED)
    top = len(up) - 2
    sets = {
        "BOTTOM": cube.where(2, -HEIGHT),
        "ACROSS": cube.where(0, 0.0),
        "ALONG": cube.where(1, 0.0),
        "MOVED": sorted(punch.nodes.values()),
    }
    lines = ["*NODE"]
    lines += [
        f"{number}, {x!r}, {y!r}, {z!r}" for mesh in (cube, punch) for (x, y, z), number in mesh.nodes.items()
    ]
    lines += [*cube.lines("CUBE"), *punch.lines("PUNCH")]
    for name, nodes in sets.items():
        lines += [f"*NSET, NSET={name}", *(f"{number}," for number in nodes)]
    lines += ["*SURFACE, NAME=BELOW"]
    lines += [f"{cube.at[i, j, top]}, S2" for i, j in itertools.product(range(count), repeat=2)]
    lines += ["*SURFACE, NAME=ABOVE", *(f"{number}, S1" for number in punch.at.values())]
    lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{YOUNG}, {POISSON}"]
    lines += [f"*SOLID SECTION, ELSET={name}, MATERIAL=STEEL" for name in ("CUBE", "PUNCH")]
    lines += ["*SURFACE INTERACTION, NAME=TOUCH", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{PENALTY}"]
    lines += ["*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "BELOW, ABOVE"]
    lines += ["*BOUNDARY", "BOTTOM, 1, 3", "ACROSS, 1, 1", "ALONG, 2, 2", "MOVED, 1, 2"]
    lines += ["*STEP", "*STATIC", "1., 1.", "*BOUNDARY", f"MOVED, 3, 3, {-APPROACH}"]
    lines += ["*NODE PRINT, NSET=MOVED, TOTALS=ONLY", "RF", "*END STEP"]
    return "\n".join(lines) + "\n"


def calculix(count, folder):
    """The load (N) by CalculiX, its seconds and memory."""
    Path(folder, "cube.inp").write_text(model(count), "ascii")
    cost = page.lasting(["ccx", "cube"], folder, 1)
    return 4 * abs(float(Path(folder, "cube.dat").read_text("ascii").split()[-1])), *cost


def archard(command, count, folder):
    """The load (N) by Archard with so many elements over the zone, its seconds and memory."""
    Path(folder, "case.toml").write_text(CASE.format(count=count), "utf-8")
    cost = page.lasting([command, "run", "case.toml", "--output", "run", "--force", "--quiet"], folder, TURNS)
    with Path(folder, "run", "history.csv").open(encoding="utf-8", newline="") as file:
        *_, last = csv.DictReader(file)
    return float(last["load_N"]), *cost


def main():
    """Solve by both and write the section."""
    if shutil.which("ccx") is None:
        raise SystemExit("CalculiX is missing: apt-get install calculix-ccx")
    said = subprocess.run(["ccx", "-v"], capture_output=True, text=True, check=False).stdout
    version = re.search(r"[\d.]+\d", said).group()
    command = page.archard()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        solve = [(f"CalculiX {version}", 2 * count, calculix(count, folder)) for count in (2, 3, 4)]
        solve += [("Archard", count, archard(command, count, folder)) for count in (16, 128)]
    for name, count, (load, seconds, memory) in solve:
        rows.append(
            [name, count, f"{load:.0f}", f"{100 * (load / LIMIT - 1):+.2f}", f"{seconds:.1f}", f"{memory:.0f}"]
        )
    heads = ["program", "elements across", "load N", "off %", "CPU s", "MB"]
    text = [
        "A paraboloid pressed 0.07 mm into a clamped cube of 1 m: whole processes. The limit, 1.8309e6 N, is extrapolated from boundary"
        " elements, to 0.03 %. CalculiX takes a quarter in quadratic elements; it also does plasticity, large displacements, any contact.",
        "",
    ]
    page.put("Bodies", [*text, *page.table(heads, rows)])


if __name__ == "__main__":
    main()
