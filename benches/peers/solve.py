"""One contact by one package: python3 solve.py PACKAGE PROBLEM TOLERANCE PRESSURES.

PROBLEM is a folder that `peers.py` has written: `gap.npy` (n x n, over the side of the frame) and `problem.json` (mean pressure over
E*, whether the frame repeats itself, the radius of the paraboloid if it is one). The packages get these pure numbers, so that
units make no difference to them; Archard, which has units, gets them as metres and times 1 GPa. PRESSURES receives the pressures
over E*. Printed is the CPU time (s) of preparing and of solving, imports left out. Archard prepares by reading its case, and the
heights of rough surfaces as an array; it solves by a step that also writes the fields. The other packages have all in memory.
ASPHER does both in one call.
"""

import importlib
import json
import sys
import time
from pathlib import Path

import numpy as np

#: E* (Pa) for Archard, whose other body is rigid: the modulus of plane strain at Poisson's ratio 0.
MODULUS = "1 GPa"
#: More iterations than any of the packages needs.
ITERATIONS = 100000


def archard(_folder, problem, gap, tolerance):
    """The package of this repository: the first state of an indentation in one increment."""
    import archard as package

    n = len(gap)
    rough = problem["radius"] is None
    # Rows of a map run along x.
    shape = {"surface": {"file": -gap.T, "pixel": f"{1 / n!r} m", "unit": "m"}}
    ball = {"paraboloid": dict.fromkeys(("radius_x", "radius_y"), f"{problem['radius']!r} m")}
    frame = {"periodic": problem["periodic"]}
    if not rough:
        frame |= {"size": ["1 m", "1 m"], "elements": [n, n]}
    case = {
        "body.top": {"rigid": True, "profile": shape if rough else ball},
        "body.flat": {"material": {"young": MODULUS, "poisson": 0.0}, "profile.flat": {}},
        "frame": frame,
        "solver.conjugate_gradient.tolerance": tolerance,
        # The force on the frame, whose side is 1 m.
        "motion.indentation": {"load": f"{problem['mean']!r} GN", "increments": 1},
    }

    steps = package.Case(case).steps()
    next(steps)  # without a load

    def solve():
        return np.asarray(next(steps).pressure) / 1e9

    return solve


def aspher(_folder, problem, gap, tolerance):
    """ASPHER: nested grids, convolution by Fourier transforms, double precision."""
    import aspher as package

    def solve():
        done = package.solve_nested(
            grid_size=len(gap),
            gap=gap.ravel(),
            p_nominal=problem["mean"],
            tol=tolerance,
            backend="periodic" if problem["periodic"] else "fft",
        )
        return np.asarray(done.pressure)

    return solve


def tamaas(_folder, problem, gap, tolerance):
    """Tamaas: the solver of Polonsky and Keer."""
    import tamaas as package

    model = package.ModelFactory.createModel(package.model_type.basic_2d, [1.0, 1.0], list(gap.shape))
    # Before an operator is registered, which keeps the modulus it finds.
    model.E, model.nu = 1.0, 0.0
    if not problem["periodic"]:
        package.ModelFactory.registerNonPeriodic(model, "dcfft")
    solver = package.PolonskyKeerRey(model, -gap, tolerance)
    if not problem["periodic"]:
        solver.setIntegralOperator("dcfft")
    solver.max_iter = ITERATIONS

    def solve():
        solver.solve(problem["mean"])
        return np.asarray(model.traction)

    return solve


def contact_mechanics(_folder, problem, gap, tolerance):
    """ContactMechanics: constrained conjugate gradients, the tolerance that of penetration over the rms height."""
    import ContactMechanics as package
    from SurfaceTopography import Topography

    topography = Topography(-gap, (1.0, 1.0), periodic=problem["periodic"])
    kind = package.PeriodicFFTElasticHalfSpace if problem["periodic"] else package.FreeFFTElasticHalfSpace
    system = package.Systems.NonSmoothContactSystem(kind(gap.shape, 1.0, (1.0, 1.0)), topography)

    def solve():
        done = system.minimize_proxy(
            external_force=problem["mean"], pentol=tolerance * np.std(gap), maxiter=ITERATIONS
        )
        if not done.success:
            raise SystemExit(done.message)
        n = len(gap)
        return np.asarray(done.jac)[:n, :n] * n * n

    return solve


PACKAGES = {"Archard": archard, "ASPHER": aspher, "Tamaas": tamaas, "ContactMechanics": contact_mechanics}


def main():
    """Solve, print the seconds and keep the pressures."""
    package, folder, tolerance, kept = sys.argv[1:]
    folder = Path(folder)
    problem = json.loads((folder / "problem.json").read_text("utf-8"))
    gap = np.load(folder / "gap.npy")
    importlib.import_module(package if package == "ContactMechanics" else package.lower())
    times = [time.process_time()]
    solve = PACKAGES[package](folder, problem, gap, float(tolerance))
    times.append(time.process_time())
    pressures = solve()
    times.append(time.process_time())
    np.save(kept, pressures)
    print(json.dumps(np.diff(times).tolist()))


if __name__ == "__main__":
    main()
