"""Draw the pictures of the gallery, one a case, from result folders with their plots: ``draw.py FOLDER..``.

What is drawn stands in ``seen.toml``: ``picture`` names one of the pictures of ``archard plot``, which is
only scaled, or a function of ``maps.py``, ``curves.py`` or
``solids.py``; the other keys of the case go to the function.
"""

from __future__ import annotations

import sys
from io import BytesIO
from pathlib import Path

import archard
from archard import _toml
from curves import against, along, beneath, loop, section
from maps import plan, spots, surface
from matplotlib import pyplot
from PIL import Image
from solids import mesh, wall

HERE = Path(__file__).parent
WIDTH, HIGHEST = 900, 650
KINDS = {kind.__name__: kind for kind in (surface, plan, spots, section, against, loop, along, beneath, mesh, wall)}


def scaled(picture):
    """Return a picture of `archard plot` in the width of the gallery."""
    with Image.open(picture) as read:
        wide, high = read.size
        share = min(WIDTH / wide, HIGHEST / high)
        return read.convert("RGB").resize((round(wide * share), round(high * share)), Image.Resampling.LANCZOS)


def rendered(drawn):
    """Return a figure of matplotlib in the width of the gallery."""
    stream = BytesIO()
    drawn.savefig(stream, format="png", dpi=WIDTH / drawn.get_size_inches()[0])
    pyplot.close(drawn)
    return Image.open(stream).convert("RGB")


def main():
    """Draw the picture of each case whose results are given."""
    cases = _toml.read((HERE / "seen.toml").read_text(encoding="utf-8"))
    for folder in map(Path, sys.argv[1:]):
        options = dict(cases[folder.name])
        name, _ = options.pop("picture"), options.pop("seen")
        if name in KINDS:
            picture = rendered(KINDS[name](archard.open(folder), **options))
        else:
            picture = scaled(folder / "plots" / f"{name}.png")
        # A palette, with which no picture of lines and one map takes more than it has to.
        picture.quantize(255, dither=Image.Dither.NONE).save(HERE / f"{folder.name}.png", optimize=True)


if __name__ == "__main__":
    main()
