"""Archard and CONTACT on rolling discs, for `book/src/peers.md`: python3 benches/peers/rolling.py.

`rolling.csv` has fifteen contacts of discs and what CONTACT (github.com/eve70a/CONTACT, d431cdb) computes of
them, extrapolated over grids of 20 to `finest` elements across, with a standard error, and its CPU seconds on
60 elements. Signs are Archard's.
"""

import csv
import tempfile
from pathlib import Path

import page

CASE = """title = "{name}"
accuracy = 0.01

[body.one]
material = {{ young = "{young_1} MPa", poisson = {nu1} }}
profile.disc = {{ radius = "{disc_radius_mm} mm", crown = "{crown_mm} mm" }}

[body.two]
material = {{ young = "{young_2} MPa", poisson = {nu2} }}
profile.flat = {{}}

[friction.coulomb]
coefficient = {mu}

[motion.rolling]
load = "{load_N} N"
creepage = {creepage}
lateral_creepage = {lateral_creepage}
spin = "{spin_per_mm} 1/mm"
revolutions = 0
"""
TURNS = 3


def young(row, body):
    """Young's modulus (MPa) of a body."""
    return 2 * float(row[f"G{body}_MPa"]) * (1 + float(row[f"nu{body}"]))


#: Columns of the history and of the bank that are compared, with the standard error.
VALUES = (
    ("force_x_N", "Fx_N", "se_Fx"),
    ("force_y_N", "Fy_N", "se_Fy"),
    ("frictional_power_per_speed_N", "power_per_speed_N", "se_P"),
)


def compared(archard, row):
    """How far Archard is off, its stated error and twice the standard error of each value, over mu F or the power; and its seconds."""
    with tempfile.TemporaryDirectory() as folder:
        text = CASE.format(**row, young_1=young(row, 1), young_2=young(row, 2))
        Path(folder, "case.toml").write_text(text, "utf-8")
        command = [archard, "run", "case.toml", "--output", "run", "--force", "--quiet"]
        seconds = page.lasting(command, folder, TURNS)[0]
        with Path(folder, "run", "history.csv").open(encoding="utf-8", newline="") as file:
            *_, last = csv.DictReader(file)
    force = float(row["mu"]) * float(row["load_N"])
    found = []
    for (ours, theirs, error), scale in zip(VALUES, (force, force, float(row["power_per_speed_N"])), strict=True):
        off = abs(float(last[ours]) - float(row[theirs]))
        found.append(
            [100 * value / scale for value in (off, float(last[f"error_of_{ours}"]), 2 * float(row[error]))]
        )
    print(row["name"], *(f"{value:.3f}" for value in sum(found, [])), f"{seconds:.2f} s", flush=True)
    return found, seconds


def summary(name, contacts):
    """A row: how many, the largest differences, in how many both errors cover all, and the seconds of both."""
    covered = sum(all(off <= own + other for off, own, other in found) for found, _, _ in contacts)
    largest = [max(found[at][0] for found, _, _ in contacts) for at in range(len(VALUES))]
    ours, theirs = (sum(contact[at] for contact in contacts) for at in (1, 2))
    cells = (f"{off:.2f}" for off in largest)
    return [name, len(contacts), *cells, covered, f"{ours:.1f}", f"{theirs:.1f}"]


def main():
    """Compare all contacts and write the section."""
    archard = page.archard()
    groups = {"like": [], "unlike": []}
    with (page.HERE / "rolling.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            group = "like" if row["G1_MPa"] == row["G2_MPa"] else "unlike"
            groups[group].append((*compared(archard, row), float(row["seconds_on_60"])))
    heads = ["bodies", "contacts", "along", "across", "power", "covered", "Archard s", "CONTACT s"]
    said = [
        "Discs that creep and spin, by `accuracy = 0.01` and by [CONTACT](https://github.com/eve70a/CONTACT), extrapolated over its grids:"
        " largest differences, % of mu F and of the power, and how many both errors cover. CPU seconds, CONTACT's on 60 elements, another day.",
        "",
    ]
    page.put("Rolling", [*said, *page.table(heads, [summary(*group) for group in groups.items()])])


if __name__ == "__main__":
    main()
