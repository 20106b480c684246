"""Runs: steps, interruptions, failures, threads and processes."""

import concurrent.futures
import logging
import multiprocessing
import pickle
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import archard


def same(one, other):
    assert list(one.history) == list(other.history)
    for column in one.history:
        np.testing.assert_array_equal(one.history[column], other.history[column], strict=True)
    for a, b in zip(one.fields, other.fields, strict=True):
        for field in a.names:
            np.testing.assert_array_equal(a[field], b[field], strict=True)


def test_runs_end_at_their_limits(case):
    # A volume is k F s.
    case["until"] = {"worn_volume_pin": f"{1.33e-13 * 10.2 * 0.013 * 1e9} mm^3"}
    run = case.steps()
    places = [state.progress for state in run]
    result = run.result()
    assert result.complete
    assert result.life is not None
    assert result.life["distance_m"] == pytest.approx(0.013, rel=1e-5)
    assert places[-1] == pytest.approx(0.014)
    assert len(result.fields) == 4
    same(result, case.run())
    case["until"] = {"worn_volume_pin": "1 mm^3"}
    assert case.run().life is None


def test_steps_are_the_rows_of_the_history(case):
    run = case.steps()
    states = list(run)
    result = run.result()
    assert result.complete
    assert len(states) == len(result.history["distance_m"]) == 13
    for row, state in enumerate(states):
        assert state.progress == result.history["distance_m"][row]
        assert state.row["wear_depth_m"] == result.history["wear_depth_m"][row]
        assert state.worn["pin"].max() == state.row["wear_depth_pin_m"]
    np.testing.assert_array_equal(states[-1].pressure, result.fields[-1].pressure)
    with pytest.raises(RuntimeError, match="over"):
        next(run)
    same(result, case.run())


def test_a_run_that_is_left_is_incomplete_and_goes_on(case, tmp_path):
    whole = case.run()
    run = case.steps()
    for state in run:
        if state.progress > 10e-3:
            break
    with pytest.warns(archard.ResultWarning, match="incomplete: stopped"):
        part = run.result()
    assert not part.complete
    assert len(part.history["load_N"]) == 7
    for result in (case.run(resume=part), case.run(resume=pickle.loads(pickle.dumps(part)), out=tmp_path / "on")):
        assert result.complete
        same(result, whole)
    with pytest.raises(OSError, match="holds no run to go on with"):
        case.run(resume=tmp_path / "on")
    with pytest.raises(FileNotFoundError, match="no folder to go on in"):
        case.run(resume=tmp_path / "none")
    case["motion.sliding.load"] = "10.3 N"
    with pytest.raises(ValueError, match="another case"):
        case.run(resume=part)


OF_STEPS = """
import archard, gc, itertools, os, sys, tempfile, warnings
warnings.simplefilter("ignore")
tempfile.tempdir = sys.argv[1]
case = archard.Case("pin_on_disc")
del case["accuracy"]
case["frame"] = {"size": ["0.6 mm", "0.6 mm"], "elements": [24, 24]}
case["motion.sliding"] = {"load": "10.2 N", "distance": "24 mm", "step": "2 mm"}
case["output.every"] = "2 mm"
for steps in [1, 2, 5, 100] * 3:
    for state in itertools.islice(case.steps(), steps):
        pass
    gc.collect()
    assert not os.listdir(sys.argv[1]), os.listdir(sys.argv[1])
kept = case.steps()
next(kept)
"""


def test_a_run_that_is_left_takes_its_folder_with_it(tmp_path):
    """After its last step, before, and at the end of the program; without a word."""
    words = [sys.executable, "-c", OF_STEPS, tmp_path]
    done = subprocess.run(words, capture_output=True, text=True, timeout=300)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert not list(tmp_path.iterdir())


def test_what_on_step_raises_comes_through_with_the_part(case, tmp_path):
    def stop(state):
        if state.progress >= 8e-3:
            raise LookupError("enough")

    with pytest.raises(LookupError, match="enough") as caught:
        case.run(on_step=stop, out=tmp_path)
    part = caught.value.result
    assert not part.complete
    assert part.failure == "LookupError: enough"
    assert part.history["distance_m"][-1] == 8e-3
    with pytest.warns(archard.ResultWarning, match="LookupError"):
        archard.open(tmp_path)
    same(case.run(resume=tmp_path), case.run())


def test_what_does_not_converge_has_its_part(case):
    case["solver.conjugate_gradient"] = {"max_iterations": 2}
    with pytest.raises(archard.NotConverged, match="did not converge") as caught:
        case.run()
    assert "max_iterations" in case.check().toml
    assert not caught.value.result.complete
    assert "did not converge" in caught.value.result.failure


def test_a_wrong_result_is_an_error(case):
    """Elements much larger than the contact."""
    case["frame"] = {"size": ["8 mm", "8 mm"], "elements": [8, 8]}
    with pytest.warns(archard.CaseWarning), pytest.raises(archard.WrongResult, match="element") as caught:
        case.run()
    assert caught.value.result.complete
    assert caught.value.result.verdict.word == "wrong"


def test_thread_counts_are_held(case):
    for threads in (0, 10_000):
        with pytest.raises(ValueError, match="threads = "):
            case.run(threads=threads)
    with pytest.raises(OverflowError):
        case.run(threads=-1)
    same(case.run(threads=1), case.run(threads=3))


def test_folders_keep_what_is_theirs(case, tmp_path):
    case.run(out=tmp_path)
    case.run(out=tmp_path)
    other = case.copy()
    other["motion.sliding.load"] = "9 N"
    with pytest.raises(FileExistsError, match="another case"):
        other.run(out=tmp_path)
    assert other.run(out=tmp_path, force=True).complete
    with pytest.raises(FileExistsError, match="overwrite the case"):
        archard.Case(tmp_path).run(out=tmp_path)


def test_two_runs_in_threads(case):
    whole = case.run()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for result in [one.result() for one in [pool.submit(case.copy().run) for _ in range(4)]]:
            same(result, whole)


def test_python_goes_on_while_a_run_solves(case):
    case["frame.elements"] = [96, 96]
    ticks = []
    running = threading.Event()
    running.set()

    def tick():
        while running.is_set():
            ticks.append(time.perf_counter())
            time.sleep(1e-3)

    ticker = threading.Thread(target=tick)
    ticker.start()
    begun = time.perf_counter()
    case.run(threads=1)
    ended = time.perf_counter()
    running.clear()
    ticker.join()
    assert sum(begun < at < ended for at in ticks) > 100 * (ended - begun)


def run_at(load):
    case = archard.Case("pin_on_disc")
    del case["accuracy"]
    case["motion.sliding"] = {"load": f"{load} N", "distance": "10 mm", "step": "5 mm"}
    case["frame"] = {"size": ["0.6 mm", "0.6 mm"], "elements": [24, 24]}
    return case.run()


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_processes(method):
    if method not in multiprocessing.get_all_start_methods():
        pytest.skip(f"no {method} here")
    here = run_at(10)  # Threads of this process must not stand in the way of a forked one.
    context = multiprocessing.get_context(method)
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=context) as pool:
        results = list(pool.map(run_at, [10, 12]))
        same(results[0], here)
        assert results[1].history["load_N"][-1] == pytest.approx(12)
        law = pool.submit(archard.Case("pin_on_disc").run, laws={"pin": lambda p, s: 1e-13 * p * s})
        with pytest.raises((pickle.PicklingError, AttributeError), match="lambda"):
            law.result()


INTERRUPTED = """
import archard, signal, threading, os, time, sys, warnings
# Where a shell that put the tests into the background has it ignored.
signal.signal(signal.SIGINT, signal.default_int_handler)
warnings.simplefilter("ignore")
case = archard.Case("pin_on_disc")
del case["accuracy"]
case["frame"] = {"size": ["1.2 mm", "1.2 mm"], "elements": [64, 64]}
case["motion.sliding"] = {"load": "10.2 N", "distance": "5 m", "step": "0.1 mm"}
def ask():
    time.sleep(1.0)
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=ask).start()
law = {"pin": lambda p, s: 1.33e-13 * p * s} if sys.argv[1] == "law" else None
try:
    case.run(laws=law)
except KeyboardInterrupt as error:
    result = error.result
    assert not result.complete and result.failure == "interrupted"
    rows = len(result.history["load_N"])
    assert rows > 3, rows
    run = case.steps(laws=law, resume=result)
    assert next(run).progress == result.history["distance_m"][-1]
    next(run)
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    print("kept", rows)
"""


@pytest.mark.parametrize("law", ["law", "native"])
def test_ctrl_c_keeps_what_is_done(law):
    done = subprocess.run([sys.executable, "-c", INTERRUPTED, law], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("kept")


LEFT = """
import archard, signal, threading, os, time, warnings
signal.signal(signal.SIGINT, signal.default_int_handler)
warnings.simplefilter("ignore")
case = archard.Case("pin_on_disc")
del case["accuracy"]
case["frame"] = {"size": ["1.2 mm", "1.2 mm"], "elements": [30, 30]}
case["motion.sliding.step"] = "5 mm"
calls = []
def law(p, s):
    calls.append(1)
    if len(p) > 40 and len(calls) > 400:
        threading.Thread(target=lambda: (time.sleep(0.1), os.kill(os.getpid(), signal.SIGINT))).start()
        time.sleep(20)
    return 1.33e-13 * p * s
begun = time.time()
try:
    case.run(laws={"pin": law})
except KeyboardInterrupt as error:
    assert len(error.result.history["load_N"]) > 1
    print("left after", time.time() - begun)
"""


def test_a_step_that_takes_too_long_is_left_alone():
    done = subprocess.run([sys.executable, "-c", LEFT], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    assert float(done.stdout.split()[-1]) < 15


def test_nothing_is_printed(case, capfd, caplog):
    with caplog.at_level(logging.DEBUG, "archard"):
        case.run()
    assert capfd.readouterr() == ("", "")
    assert "begins with 1 threads" in caplog.text
    assert "13 steps" in caplog.text or "12 steps" in caplog.text


def test_a_bar_is_shown_when_asked_for(case, capfd):
    case.run(progress=True)
    assert "100%" in capfd.readouterr().err


def test_progress_without_tqdm(case, monkeypatch, caplog, capfd):
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with caplog.at_level(logging.INFO, "archard"):
        case.run(progress=True)
    assert "at 0.024 of 0.024" in caplog.text
    assert capfd.readouterr().err == ""
