"""Time of whole runs with a wear law in Python beside the native one, in processes of their own."""

import os
import subprocess
import sys
import warnings

LAWS = {
    "native": None,
    "depth": {"pin": lambda p, s: 1.33e-13 * p * s},
    "depth and slope": {"pin": lambda p, s: (1.33e-13 * p * s, 1.33e-13 * s)},
}
TIMES = 4


def run(name: str) -> None:
    """Run a pin on a disc of 128 x 128 elements over a hundred steps."""
    import archard

    warnings.simplefilter("ignore")
    case = archard.Case("pin_on_disc")
    case["frame.elements"] = [128, 128]
    case.run(laws=LAWS[name], threads=1)


def seconds(name: str) -> float:
    """Return the processor time that a process of that law takes (s)."""
    before = os.times()
    subprocess.run([sys.executable, __file__, name], check=True)
    after = os.times()
    return after.children_user - before.children_user + after.children_system - before.children_system


if len(sys.argv) > 1:
    run(sys.argv[1])
else:
    native = 0.0
    for law in LAWS:
        best = min(seconds(law) for _ in range(TIMES))
        native = native or best
        print(f"{law:<16}{best:6.2f} s  {best / native:.2f}")
