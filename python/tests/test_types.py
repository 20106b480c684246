"""The stubs are those of the compiled part, and the package keeps to its types and style."""

import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parents[1]


@pytest.mark.parametrize(
    "check",
    [
        ["mypy.stubtest", "archard._archard"],
        ["mypy", "-p", "archard"],
        ["ruff", "check", "."],
        ["ruff", "format", "--check", "."],
    ],
    ids=lambda check: " ".join(check[:2]),
)
def test_checks(check, tmp_path):
    mypy = check[0].startswith("mypy")
    options = ["--config-file", str(HERE / "pyproject.toml"), "--cache-dir", str(tmp_path)]
    options = options if check[0] == "mypy" else ["--no-cache"] if check[0] == "ruff" else []
    done = subprocess.run(
        [sys.executable, "-m", *check, *options], cwd=tmp_path if mypy else HERE, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr
