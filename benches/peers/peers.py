"""The same contacts by Archard and its peers, for `book/src/peers.md`: python3 benches/peers/peers.py.

The packages of `requirements.txt` and the Python package of this repository are installed into `target/peers`,
then each solves each problem in processes of its own on one thread, by turns. The page has times as ratios of a
turn, and what all pressures are worth by one measure.
"""

import json
import os
import subprocess
import sys
import tempfile
import venv
from importlib import metadata
from pathlib import Path

from page import HERE, ONE_THREAD, ROOT, put, table

ENVIRONMENT = ROOT / "target" / "peers"

PEERS = ("Archard", "ASPHER", "Tamaas", "ContactMechanics")
TURNS = 5
#: What is left of the gap under pressure, by `residual`: each package gets the first power of ten as its tolerance that reaches it.
RESIDUAL = 1e-8


def environment(package):
    """Make the environment and run this file in it; `package` is what pip installs as Archard."""
    python = ENVIRONMENT / "bin" / "python"
    venv.create(ENVIRONMENT, with_pip=True)
    install = [python, "-m", "pip", "install", "-q"]
    subprocess.run([*install, "-r", HERE / "requirements.txt"], check=True)
    subprocess.run([*install, "--force-reinstall", "--no-deps", package], check=True)
    os.execv(python, [python, __file__, "--here"])


def hertz(n):
    """A paraboloid whose contact has three tenths of the frame's side as its radius; lengths over the side."""
    import numpy as np

    radius, contact = 10.0, 0.3
    x = (np.arange(n) + 0.5) / n - 0.5
    gap = (x[:, None] ** 2 + x[None, :] ** 2) / (2 * radius)
    # Hertz: a^3 = 3 F R / (4 E*).
    force = 4 * contact**3 / (3 * radius)
    return {"gap": gap, "mean": force, "periodic": False, "radius": radius}


def hertz_pressure(problem):
    """Hertz's pressures at the pairs, and the largest."""
    import numpy as np

    n, radius = len(problem["gap"]), problem["radius"]
    contact = (3 * problem["mean"] * radius / 4) ** (1 / 3)
    peak = 3 * problem["mean"] / (2 * np.pi * contact**2)
    x = (np.arange(n) + 0.5) / n - 0.5
    inside = 1 - (x[:, None] ** 2 + x[None, :] ** 2) / contact**2
    return peak * np.sqrt(np.maximum(inside, 0.0)), peak


def rough(n, slope=0.1, hurst=0.8, shortest=8, seed=1):
    """Waves of random phase from the side of the frame down to eight pairs, amplitudes as k^-(1 + H), under p/E* = 0.005."""
    import numpy as np

    k = np.hypot(*np.meshgrid(*2 * [np.fft.fftfreq(n, 1 / n)]))
    inside = (k > 0) & (k <= n / shortest)
    amplitude = np.where(inside, np.where(inside, k, 1.0) ** -(1 + hurst), 0.0)
    phases = np.random.default_rng(seed).random((n, n))
    z = np.fft.ifft2(amplitude * np.exp(2j * np.pi * phases)).real
    gradient = sum(np.mean(((np.roll(z, 1, axis) - z) * n) ** 2) for axis in (0, 1))
    z *= slope / np.sqrt(gradient)
    return {"gap": z.max() - z, "mean": 0.005, "periodic": True, "radius": None}


def displacement(pressure, periodic):
    """Displacements (over the side) of a half-space under pressures over E*, by the kernel that all packages use.

    Waves: 2 p / (E* k). Otherwise rectangles under even pressure (Love 1929, at the surface; Johnson, Contact Mechanics, 3.25).
    """
    import numpy as np

    n = len(pressure)
    if periodic:
        k = 2 * np.pi * np.hypot(*np.meshgrid(*2 * [np.fft.fftfreq(n, 1 / n)], indexing="ij"))
        k[0, 0] = np.inf
        return np.fft.ifft2(np.fft.fft2(pressure) * 2 / k).real
    offsets = np.fft.fftfreq(2 * n, 1 / (2 * n)) / n
    x, y = np.meshgrid(offsets, offsets, indexing="ij")
    half = 0.5 / n

    def corner(a, b):
        return a * np.arcsinh(b / np.abs(a)) + b * np.arcsinh(a / np.abs(b))

    kernel = sum(
        sign * corner(x + along * half, y + across * half)
        for along, across, sign in ((1, 1, 1), (-1, -1, 1), (1, -1, -1), (-1, 1, -1))
    )
    padded = np.zeros((2 * n, 2 * n))
    padded[:n, :n] = pressure
    return np.fft.ifft2(np.fft.fft2(padded) * np.fft.fft2(kernel)).real[:n, :n] / np.pi


def residual(problem, pressure):
    """How far pressures are from a solution: the gap under them, in the mean weighted by them, over the rms height.

    Gaps count from the smallest of all, so that penetration counts too.
    """
    import numpy as np

    gap = problem["gap"] + displacement(pressure, problem["periodic"])
    gap -= gap.min()
    return np.sum(pressure * gap) / np.sum(pressure) / np.std(problem["gap"])


def solve(package, folder, tolerance):
    """Seconds of preparing and of solving, and the pressures, of a process."""
    import numpy as np

    with tempfile.TemporaryDirectory() as kept:
        path = Path(kept, "pressures.npy")
        command = [sys.executable, HERE / "solve.py", package, folder, str(tolerance), path]
        ended = subprocess.run(
            command, env=os.environ | ONE_THREAD, cwd=kept, capture_output=True, text=True, check=False
        )
        if ended.returncode != 0:
            raise SystemExit(f"{package} failed:\n{ended.stdout}{ended.stderr}")
        return json.loads(ended.stdout.splitlines()[-1]), np.load(path)


def write(problem, folder):
    """A problem as files."""
    import numpy as np

    np.save(folder / "gap.npy", problem["gap"])
    told = {key: problem[key] for key in ("mean", "periodic", "radius")}
    (folder / "problem.json").write_text(json.dumps(told), "utf-8")


def accurate(package, problem, folder):
    """The tolerance with which a package reaches the residual, its pressures, and what is left."""
    for power in range(8, 14):
        tolerance = float(f"1e-{power}")
        pressures = solve(package, folder, tolerance)[1]
        left = residual(problem, pressures)
        if left <= RESIDUAL:
            return tolerance, pressures, left
    raise SystemExit(f"{package} does not reach a residual of {RESIDUAL:.0e}")


def measure(problem):
    """For each package: tolerance, pressures, residual, and the seconds of all turns."""
    with tempfile.TemporaryDirectory() as folder:
        write(problem, Path(folder))
        found = {peer: accurate(peer, problem, folder) for peer in PEERS}
        turns = [{peer: solve(peer, folder, found[peer][0])[0] for peer in PEERS} for _ in range(TURNS)]
    return {peer: (*found[peer], [turn[peer] for turn in turns]) for peer in PEERS}


def rows(problem, measured):
    """The rows of a problem."""
    import numpy as np

    reference = measured["Archard"][1]
    found = []
    for peer, (tolerance, pressures, left, times) in measured.items():
        pairs = zip(times, measured["Archard"][3], strict=True)
        ratios = [own[1] / archard[1] for own, archard in pairs]
        seconds = np.min(times, axis=0)
        if problem["radius"]:
            exact, peak = hertz_pressure(problem)
            off = [np.sqrt(np.mean((pressures - exact)[exact > 0] ** 2)) / peak, pressures.max() / peak - 1]
            told = [f"{100 * off[0]:.4f}", f"{100 * off[1]:+.4f}"]
        else:
            apart = np.abs(pressures - reference).max() / reference.max()
            told = [f"{np.mean(pressures > 0):.8f}", np.sum((pressures > 0) != (reference > 0)), f"{apart:.1e}"]
        ratio = f"{np.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})"
        found.append(
            [peer, f"{tolerance:.0e}", f"{left:.1e}", f"{seconds[0]:.3f}", f"{seconds[1]:.3f}", ratio, *told]
        )
    return found


def main():
    """Measure everything and write the section."""
    columns = ["package", "tolerance", "residual", "preparing s", "solving s", "solving / Archard"]
    hertzian = ["rms error of p, % of p0", "largest p off p0, %"]
    shared = ["area / frame", "other pairs", "largest difference of p"]
    versions = ", ".join(f"{peer} {metadata.version(peer)}" for peer in PEERS)
    head = (HERE / "contacts.md").read_text("utf-8")
    lines = [head.format(versions=versions, turns=TURNS, residual=f"{RESIDUAL:.0e}")]
    for title, make, sizes, more in (("Hertz", hertz, (256, 512), hertzian), ("Rough", rough, (256, 512), shared)):
        for n in sizes:
            problem = make(n)
            section = [f"**{title}, {n} x {n}**", "", *table(columns + more, rows(problem, measure(problem))), ""]
            print(*section, sep="\n", flush=True)
            lines += section
    put("Half-spaces", lines)


if __name__ == "__main__":
    if "--here" in sys.argv:
        main()
    else:
        # Another package of Archard, such as a wheel, may be named.
        environment(sys.argv[1] if len(sys.argv) > 1 else ROOT / "python")
