"""Studies on executors: rows like single runs, nothing lost and nothing twice."""

import csv
import os
import runpy
import shutil
import signal
import subprocess
import sys
from concurrent.futures import Future, ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path

import numpy as np
import pytest

import archard
from archard import _sweep

EXAMPLES = Path(__file__).parents[2] / "examples" / "cluster"

LOADS = ["8 N", "10.2 N"]
FRICTIONLESS = {"motion.sliding.load": LOADS, "body.pin.profile.sphere.radius": ["40 mm", "50 mm"]}
pytestmark = pytest.mark.filterwarnings("ignore::archard.ArchardWarning")


def assert_like_single_runs(study, case):
    assert list(study.table["motion.sliding.load_N"]) == [8.0, 8.0, 10.2, 10.2]
    assert list(study.table["body.pin.profile.sphere.radius_m"]) == [0.04, 0.05, 0.04, 0.05]
    assert set(study.table["status"]) == {"done"}
    for index, row in enumerate(study.rows):
        one = case.copy()
        for key, value in row.settings.items():
            one[key] = value
        alone = one.run(threads=1)
        for column in ("wear_depth_m", "peak_pressure_Pa", "worn_volume_pin_m3"):
            assert study.table[column][index] == alone.history[column][-1]


@pytest.mark.parametrize("pool", [None, ProcessPoolExecutor, ThreadPoolExecutor])
def test_rows_are_like_single_runs(case, pool):
    if pool is None:
        assert_like_single_runs(archard.sweep(case, FRICTIONLESS), case)
    else:
        with pool(2) as executor:
            assert_like_single_runs(archard.sweep(case, FRICTIONLESS, executor=executor), case)


def test_done_rows_are_not_run_again(case, tmp_path):
    with ProcessPoolExecutor(2) as executor:
        first = archard.sweep(case, FRICTIONLESS, executor=executor, out=tmp_path)
        files = list(tmp_path.glob("rows/*/summary.json"))
        assert len(files) == 4
        times = [file.stat().st_mtime_ns for file in files]
        again = archard.sweep(case, FRICTIONLESS, executor=executor, out=tmp_path)
    assert times == [file.stat().st_mtime_ns for file in files]
    assert_like_single_runs(again, case)
    for name, column in first.table.items():
        np.testing.assert_array_equal(column, again.table[name])
    with (tmp_path / "sweep.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [float(row["wear_depth_m"]) for row in rows] == list(again.table["wear_depth_m"])
    with pytest.raises(ValueError, match="holds another case"):
        archard.sweep(case, {"motion.sliding.load": ["9 N"]}, out=tmp_path)


def _killed_once(case, folder, *others):
    """Run a row; of the second one the worker is killed the first time."""
    mark = folder.parent / "killed"
    if folder.name == "0002" and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return _sweep.__dict__["_run_really"](case, folder, *others)


class Once:
    """An executor that hands rows to a pool with one worker that gets killed."""

    def __init__(self, pool):
        self.pool = pool

    def submit(self, function, *arguments):
        assert function is _sweep._run
        return self.pool.submit(_killed_once, *arguments)


def test_a_killed_worker_costs_nothing_that_was_done(case, tmp_path, monkeypatch):
    monkeypatch.setattr(_sweep, "_run_really", _sweep._run, raising=False)
    (tmp_path / "rows").mkdir()
    with ProcessPoolExecutor(1) as pool, pytest.raises(BrokenProcessPool):
        archard.sweep(case, FRICTIONLESS, executor=Once(pool), out=tmp_path)
    done = {file: file.stat().st_mtime_ns for file in tmp_path.glob("rows/*/summary.json")}
    assert len(done) == 1
    with ProcessPoolExecutor(2) as pool:
        study = archard.sweep(case, FRICTIONLESS, executor=pool, out=tmp_path)
    assert all(file.stat().st_mtime_ns == time for file, time in done.items())
    assert_like_single_runs(study, case)


def test_frames_of_rows_grow_with_their_contact(case, tmp_path):
    """A row ends as one in a frame that is large enough."""
    over = {"motion.sliding.distance": ["24 mm", "300 mm"]}
    with ThreadPoolExecutor(1) as executor:
        study = archard.sweep(case, over, executor=executor, out=tmp_path)
    case["frame"] = {"size": ["0.9 mm", "0.9 mm"], "elements": [36, 36]}
    case["motion.sliding.distance"] = "300 mm"
    alone = case.run(threads=1).history["wear_depth_m"][-1]
    assert study.table["wear_depth_m"][1] == pytest.approx(alone, rel=1e-7)
    assert set(study.table["verdict"]) == {"good"}


def by_pressure(p, s):
    """Archard's law, as other processes import it."""
    return 1.33e-13 * p * s


def test_rows_have_laws_that_are_functions(case, tmp_path):
    over, laws = {"motion.sliding.load": LOADS}, {"pin": by_pressure}
    study = archard.sweep(case, over, laws=laws, out=tmp_path)
    assert set(study.table["status"]) == {"done"}
    for load, depth in zip(LOADS, study.table["wear_depth_m"], strict=True):
        case["motion.sliding.load"] = load
        assert depth == case.run(threads=1, laws=laws).history["wear_depth_m"][-1] > 0
    times = [file.stat().st_mtime_ns for file in sorted(tmp_path.glob("rows/*/summary.json"))]
    archard.sweep(case, over, laws=laws, out=tmp_path)
    assert times == [file.stat().st_mtime_ns for file in sorted(tmp_path.glob("rows/*/summary.json"))]
    with pytest.raises(ValueError, match="holds another case"):
        archard.sweep(case, over, out=tmp_path)


def test_laws_that_no_row_could_have_are_refused(case):
    over = {"motion.sliding.load": LOADS}
    with pytest.raises(ValueError, match="cannot be sent to another process"):
        archard.sweep(case, over, laws={"pin": lambda p, s: 1e-13 * p * s})
    wear = {"body.pin.wear.archard.coefficient": ["1e-13 1/Pa", "2e-13 1/Pa"]}
    with pytest.raises(ValueError, match=r"`body\.pin\.wear\.archard\.coefficient`: the law is a function"):
        archard.sweep(case, wear, laws={"pin": by_pressure}, executor=Never())


def test_lists_are_values(case):
    sizes = [["0.6 mm", "0.6 mm"], ["0.7 mm", "0.6 mm"]]
    with ThreadPoolExecutor(1) as executor:
        study = archard.sweep(case, {"frame.size": sizes}, executor=executor)
    assert list(study.table["status"]) == ["done", "done"]
    assert list(study.table["frame.size"]) == ['["0.0006 m", "0.0006 m"]', '["0.0007 m", "0.0006 m"]']


def test_failed_rows_are_recorded(case):
    case["solver.conjugate_gradient"] = {"max_iterations": 30}
    rows = [{"solver.conjugate_gradient.max_iterations": most} for most in (1, 1000)]
    with ThreadPoolExecutor(1) as executor:
        study = archard.sweep(case, rows, executor=executor)
    assert list(study.table["status"]) == ["failed", "done"]
    assert "did not converge" in study.rows[0].error
    assert np.isnan(study.table["wear_depth_m"][0])
    assert study.table["wear_depth_m"][1] > 0
    assert repr(study) == "Sweep(2 rows, 1 failed)"


class Never:
    def submit(self, *arguments):
        raise AssertionError("nothing runs before all rows are checked")


def test_wrong_rows_are_refused_before_anything_runs(case):
    for over, kind, said in [
        ({"motion.sliding.load": ["8 N", "8 mm"]}, archard.CaseError, "expected a force"),
        ({"motion.sliding.laod": ["8 N"]}, archard.CaseError, "did you mean `load`"),
        ({"motion.sliding.load": [8.0]}, archard.CaseError, "needs a unit"),
        ({"motion.sliding.load": []}, ValueError, "`motion.sliding.load`: give a list"),
        ({"motion.sliding.load": "8 N"}, ValueError, "give a list"),
        ({}, ValueError, "goes over something"),
        ([], ValueError, "goes over something"),
    ]:
        with pytest.raises(kind, match=said):
            archard.sweep(case, over, executor=Never())


def test_columns_are_those_of_the_command(case, command, tmp_path):
    study = archard.sweep(case, {"motion.sliding.load": LOADS})
    case.run(out=tmp_path / "base")
    over = "motion.sliding.load=" + ",".join(LOADS)
    command("sweep", tmp_path / "base", "--over", over, "-o", tmp_path / "study", "-q", "--separate")
    with (tmp_path / "study" / "sweep.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert ["row", *study.table] == list(rows[0])
    for row, depth in zip(rows, study.table["wear_depth_m"], strict=True):
        assert float(row["wear_depth_m"]) == depth


def test_on_dask(case, tmp_path):
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        study = archard.sweep(case, FRICTIONLESS, executor=client.get_executor(), out=tmp_path)
    assert_like_single_runs(study, case)


def test_the_example_of_mpi(tmp_path):
    pytest.importorskip("mpi4py")
    if not shutil.which("mpirun"):
        pytest.skip("no mpirun")
    ranks = ["mpirun", "-n", "2", "--oversubscribe", "--allow-run-as-root"]
    line = [*ranks, sys.executable, "-m", "mpi4py.futures", EXAMPLES / "mpi_study.py", tmp_path]
    done = subprocess.run(line, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    head, *depths = done.stdout.split("\n")[:-1]
    assert head == "Sweep(4 rows)"
    rows = [archard.open(tmp_path / "rows" / f"{number:04}") for number in (1, 2, 3, 4)]
    assert [float(depth) for depth in depths] == [row.history["wear_depth_m"][-1] for row in rows]


def test_the_example_of_um_bridge():
    pytest.importorskip("umbridge")
    model = runpy.run_path(str(EXAMPLES / "um_bridge_server.py"))["PinOnDisc"]()
    alone = archard.Case("pin_on_disc").run(threads=1)
    assert model([[10.2, 1.33e-13]], {}) == [[1e6 * alone.history["wear_depth_m"][-1]]]


def test_futures_may_be_anything_that_has_a_result(case):
    class Now:
        def submit(self, function, *arguments):
            future = Future()
            future.set_result(function(*arguments))
            return future

    study = archard.sweep(case, FRICTIONLESS, executor=Now())
    assert_like_single_runs(study, case)


def test_studies_of_the_command_are_opened(tmp_path):
    """Rows, keys with their units and columns are those of the study that Python runs itself."""
    over = {"motion.indentation.load": ["5 N", "10 N"], "body.ball.profile.sphere.radius": ["40 mm", "50 mm"]}
    own = archard.sweep("hertz", over, out=tmp_path / "own", accuracy=0.05)
    words = [f"--over={key}=" + ",".join(values) for key, values in over.items()]
    command = [sys.executable, "-m", "archard", "sweep", "hertz", *words, "--accuracy=0.05", "--quiet"]
    subprocess.run([*command, "-o", tmp_path / "command"], check=True)
    study = archard.Sweep.open(tmp_path / "command")
    assert len(study) == len(own) == 4
    assert [row.settings for row in study.rows] == [
        row.settings for row in archard.Sweep.open(tmp_path / "own").rows
    ]
    for name in ("motion.indentation.load_N", "body.ball.profile.sphere.radius_m", "peak_pressure_Pa", "status"):
        np.testing.assert_array_equal(study.table[name], own.table[name])
    # Hertz: the peak pressure goes with the cube root of the load over the square of the radius.
    peaks = study.table["peak_pressure_Pa"]
    assert peaks[2] / peaks[0] == pytest.approx(2 ** (1 / 3), rel=2e-3)
    assert peaks[1] / peaks[0] == pytest.approx((40 / 50) ** (2 / 3), rel=2e-3)
    assert study.rows[1].result.verdict.word == study.table["verdict"][1] == "good"
    assert study.to_xarray(fields=["pressure"]).sizes["load"] == 2
    assert own.pictures == study.pictures
    assert own.plot("map").axes
    assert study.report(tmp_path / "page.html").read_text("utf-8").startswith("<!DOCTYPE html>")
    with pytest.raises(ValueError, match=r"Sweep\.open"):
        archard.open(tmp_path / "own")
    with pytest.raises(FileNotFoundError, match="no study"):
        archard.Sweep.open(tmp_path)


def test_samples_are_drawn_by_the_command(tmp_path):
    sample = {"body.ball.profile.sphere.radius": "uniform(40 mm, 50 mm)"}
    case = archard.Case("hertz")
    case["motion.indentation.load"] = "7 N"
    study = archard.sweep(case, sample=sample, samples=5, seed=3, accuracy=0.05, out=tmp_path / "study")
    radii = study.table["body.ball.profile.sphere.radius_m"]
    # One in each fifth of the distribution, as a Latin hypercube has it.
    assert sorted(((radii - 0.04) / 0.002).astype(int)) == [0, 1, 2, 3, 4]
    np.testing.assert_allclose(study.table["load_N"], 7.0, rtol=1e-9)
    peaks = study.table["peak_pressure_Pa"] * radii ** (2 / 3)
    np.testing.assert_allclose(peaks, peaks[0], rtol=2e-3)
    assert "bands" in study.pictures
    for wrong, match in (({"samples": 5}, "give `sample`"), ({"sample": sample}, "need their number")):
        with pytest.raises(ValueError, match=match):
            archard.sweep("hertz", **wrong)
    sample = {"body.ball.profile.sphere.radius": "normol(50 mm, 1 mm)"}
    with pytest.raises(ValueError, match="write a distribution"):
        archard.sweep(case, sample=sample, samples=5, out=tmp_path / "other")
    assert not list(Path.cwd().glob(".archard-*"))


def test_pictures_need_a_design_by_keys(case, tmp_path):
    rows = [{"motion.sliding.load": "8 N"}, {"motion.sliding.load": "9 N"}]
    study = archard.sweep(case, rows, out=tmp_path, executor=ThreadPoolExecutor(1), progress=True)
    with pytest.raises(ValueError, match="values by key"):
        study.plot()
