"""Writes the matrices of the superelements anew: `superelement.py NAME`, with the input NAME.inp beside (needs CalculiX and numpy).

CalculiX stores the stiffness of all nodes that its input leaves free (`SOLVER=MATRIXSTORAGE`), with their numbers. Of `superelement_free`
it is written as it is, node and direction by node and direction; of `superelement_held` it is reduced to the nodes of `zone`, as a linear
user element. (`*SUBSTRUCTURE GENERATE` of CalculiX 2.20 holds the other nodes instead of leaving them free.)
"""

import re
import subprocess
import sys

import numpy as np

name = sys.argv[1]
subprocess.run(["ccx", name], check=True, stdout=subprocess.DEVNULL)
labels = [tuple(map(int, line.split("."))) for line in open(name + ".dof").read().split()]
rows = [line.split() for line in open(name + ".sti")]
out = open(name + ".mtx", "w")
if "free" in name:
    for row, column, value in rows:
        one, other = labels[int(row) - 1], labels[int(column) - 1]
        out.write("%d,%d,%d,%d,%s\n" % (*one, *other, value))
    sys.exit()
stiffness = np.zeros((len(labels), len(labels)))
for row, column, value in rows:
    stiffness[int(row) - 1, int(column) - 1] = stiffness[int(column) - 1, int(row) - 1] = float(value)
text = re.search(r"NSET=zone\n([\d, \n]+)", open(name + ".inp").read())[1]
zone = [int(word) for word in re.findall(r"\d+", text)]
kept = [labels.index((node, axis)) for node in zone for axis in (1, 2, 3)]
rest = [row for row in range(len(labels)) if row not in set(kept)]
own, across, other = (stiffness[np.ix_(*pair)] for pair in ((kept, kept), (kept, rest), (rest, rest)))
reduced = own - across @ np.linalg.solve(other, across.T)
out.write("**\n*USER ELEMENT,NODES= %10d,LINEAR\n** ELEMENT NODES\n" % len(zone))
for start in range(0, len(zone), 10):
    out.write("**" + "".join("%10d," % node for node in zone[start : start + 10]) + "\n")
out.write("         1,         2,         3\n*MATRIX,TYPE=STIFFNESS\n")
for row in range(len(kept)):
    for start in range(0, row + 1, 4):
        out.write("".join("%20.13E," % value for value in reduced[row, start : min(start + 4, row + 1)]) + "\n")
