"""Archard against the reference program of rolling, as a section of `book/src/peers.md`: python3 benches/peers/rolling.py.

`rolling.csv` has fifteen contacts of discs and what CONTACT (github.com/eve70a/CONTACT, d431cdb) computes of them, extrapolated over grids of 20 to
`finest` elements across, with a standard error, and its CPU seconds on 60 elements. Signs are Archard's.
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


def compared(archard, row):
    """A contact by both: forces over mu F and power over itself, in per cent, and seconds."""
    with tempfile.TemporaryDirectory() as folder:
        text = CASE.format(**row, young_1=young(row, 1), young_2=young(row, 2))
        Path(folder, "case.toml").write_text(text, "utf-8")
        command = [archard, "run", "case.toml", "--output", "run", "--force", "--quiet"]
        seconds = page.lasting(command, folder, TURNS)[0]
        with Path(folder, "run", "history.csv").open(encoding="utf-8", newline="") as file:
            *_, last = csv.DictReader(file)
    force = float(row["mu"]) * float(row["load_N"])
    cells = [row["name"]]
    for ours, theirs, error, scale in (
        ("force_x_N", "Fx_N", "se_Fx", force),
        ("force_y_N", "Fy_N", "se_Fy", force),
        ("frictional_power_per_speed_N", "power_per_speed_N", "se_P", float(row["power_per_speed_N"])),
    ):
        off = float(last[ours]) - float(row[theirs])
        told = [float(last[f"error_of_{ours}"]), 2 * float(row[error])]
        cells.append(f"{100 * off / scale:+.2f} ({100 * told[0] / scale:.2f}, {100 * told[1] / scale:.2f})")
    return [*cells, f"{seconds:.2f}", f"{float(row['seconds_on_60']):.2f}"]


def main():
    """Compare all contacts and write the section."""
    archard = page.archard()
    with (page.HERE / "rolling.csv").open(encoding="utf-8", newline="") as file:
        rows = [compared(archard, row) for row in csv.DictReader(file)]
    heads = ["contact", "along, % of mu F", "across, % of mu F", "power, %", "Archard s", "CONTACT s"]
    said = [
        "Discs that creep and spin (`benches/peers/rolling.csv`), by `accuracy = 0.01` and by CONTACT, extrapolated over its grids: how far Archard is off;"
        " in brackets the error that it states and twice the standard error of the extrapolation."
        " Seconds are CPU time, Archard's of whole runs with its search for elements, CONTACT's on 60 elements, .2 to .7 % from its limit, on another day.",
        "",
    ]
    page.put("Rolling", [*said, *page.table(heads, rows)])


if __name__ == "__main__":
    main()
