import logging
import os
import subprocess
from pathlib import Path

import pytest

import archard

ROOT = Path(__file__).parents[2]

logging.getLogger("matplotlib").setLevel(logging.WARNING)


@pytest.fixture(scope="session")
def command():
    """The command `archard`, run in a folder of its own."""
    built = [ROOT / "target" / profile / "archard" for profile in ("debug", "release")]
    found = (
        [Path(os.environ["ARCHARD"]).absolute()]
        if "ARCHARD" in os.environ
        else [one for one in built if one.exists()]
    )
    if not found:
        pytest.skip("no command `archard`: build it, or say where it is by ARCHARD")
    program = max(found, key=lambda path: path.stat().st_mtime)

    def run(*arguments, code=0):
        done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=300)
        assert done.returncode == code, done.stderr
        return done.stdout

    return run


@pytest.fixture
def case():
    """A ball on a disc, coarse but resolved from the first contact on, in twelve steps."""
    case = archard.Case("pin_on_disc")
    del case["accuracy"]
    case["frame"] = {"size": ["0.6 mm", "0.6 mm"], "elements": [24, 24]}
    case["motion.sliding"] = {"load": "10.2 N", "distance": "24 mm", "step": "2 mm"}
    case["output.every"] = "6 mm"
    return case
