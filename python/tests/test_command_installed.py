"""The command that is installed with the package behaves as the program."""

import json
import os
import re
import signal
import subprocess
import sys
import sysconfig
import time
from pathlib import Path

import pytest

import archard

SCRIPT = Path(sysconfig.get_path("scripts")) / ("archard.exe" if os.name == "nt" else "archard")
#: Some steps that take minutes, but none of them long.
LONG = ["run", "pin_on_disc", "--set", "accuracy=", "--set", "frame.element=10 um", "--set"]
LONG += ["motion.sliding.distance=50 m", "--set", "motion.sliding.step=1 mm", "--set", "output.every=1 m"]

pytestmark = pytest.mark.skipif(not SCRIPT.exists(), reason="the package is not installed with its script")


def heed_hangups():
    signal.signal(signal.SIGHUP, signal.SIG_DFL)


def run(*words, cwd=None, start=(SCRIPT,)):
    return subprocess.run([*start, *words], cwd=cwd, capture_output=True, text=True, timeout=300)


def test_runs_a_case_and_draws_it(tmp_path):
    done = run("run", "pin_on_disc", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    results = tmp_path / "results" / "pin_on_disc"
    assert json.loads((results / "summary.json").read_text())["command"] == "archard run pin_on_disc"
    assert archard.open(results).verdict.word == "good"
    drawn = run("plot", "results/pin_on_disc", cwd=tmp_path)
    assert drawn.returncode == 0, drawn.stderr
    assert all((tmp_path / line).stat().st_size > 0 for line in drawn.stdout.splitlines())


def test_the_self_test_passes():
    done = run("doctor")
    assert done.returncode == 0, done.stdout + done.stderr


def test_help_and_version_are_those_of_the_program(command):
    assert run("--version").stdout == f"archard {archard.__version__}\n" == command("--version")
    for words in (["--help"], ["run", "--help"], ["laws"], ["completions", "bash"]):
        assert run(*words).stdout == command(*words)


def test_what_is_wrong_has_its_exit_code(tmp_path):
    unknown = run("rum", "pin_on_disc")
    assert (unknown.returncode, unknown.stdout) == (2, "")
    assert re.search(r"similar.*'run'", unknown.stderr)
    assert "Usage: archard" in unknown.stderr
    assert run("check", "no_such_case", cwd=tmp_path).returncode == 2


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize("stop", ["SIGINT", "SIGTERM"])
def test_a_signal_keeps_what_was_computed(stop, tmp_path):
    words = [SCRIPT, *LONG, "-o", tmp_path / "out"]
    # Where hangups are ignored (`nohup`) the command leaves signals as they are.
    child = subprocess.Popen(words, stderr=subprocess.PIPE, text=True, preexec_fn=heed_hangups)
    try:
        history, end = tmp_path / "out" / "history.csv", time.monotonic() + 120
        while not (history.exists() and len(history.read_text().splitlines()) > 3):
            assert child.poll() is None, child.stderr.read()
            assert time.monotonic() < end
            time.sleep(0.05)
        child.send_signal(getattr(signal, stop))
        told = child.communicate(timeout=60)[1]
    finally:
        child.kill()
    assert child.returncode == 3, told
    assert "archard run --resume" in told
    assert "Traceback" not in told
    assert (tmp_path / "out" / "checkpoint").is_file()


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize(("before", "during"), [("default_int_handler", "SIG_DFL"), ("SIG_IGN", "SIG_IGN")])
def test_ctrl_c_ends_a_command_that_has_nothing_to_save(before, during):
    # Python's own handler would only note the signal until the command returns; jobs in the background ignore it.
    code = (
        "import signal, archard._command as it\n"
        f"signal.signal(signal.SIGINT, signal.{before})\n"
        f"it.command = lambda words: print(signal.getsignal(signal.SIGINT) is signal.{during}, words)\n"
        "it.main()"
    )
    done = run("-c", code, "plot", "x", start=(sys.executable,))
    assert done.stdout == "True ['plot', 'x']\n", done.stderr


def test_the_module_is_the_command_too():
    assert run("laws", start=(sys.executable, "-m", "archard")).stdout == run("laws").stdout


@pytest.mark.skipif(os.name == "nt", reason="pipes of POSIX")
def test_a_reader_who_has_read_enough_is_no_error():
    done = run("-o", "pipefail", "-c", f"'{SCRIPT}' laws | head -n 1", start=("bash",))
    assert (done.returncode, done.stderr) == (0, "")


def test_the_command_loads_no_numpy():
    code = "import sys, archard._command; print('numpy' in sys.modules, 'typing' in sys.modules)"
    assert run("-c", code, start=(sys.executable, "-I")).stdout == "False False\n"


def test_names_are_there_where_they_are_asked_for():
    code = "import archard; print(set(archard.__all__) <= set(dir(archard)), archard.open, archard.case.Case)"
    done = run("-c", code, start=(sys.executable,))
    assert done.stdout.startswith("True <function open"), done.stderr
    with pytest.raises(AttributeError, match="nothing"):
        _ = archard.nothing
