"""The stubs are those of the compiled part; the package and examples keep to its types and style."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parents[1]
ROOT = HERE.parent
BLOCK = re.compile(r"^```python\n(.*?)^```", re.DOTALL | re.MULTILINE)


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


def examples():
    """The Python of the book page by page, of the notebooks, and of the examples, by a name for each."""
    for page in (ROOT / "book" / "src").rglob("*.md"):
        if blocks := BLOCK.findall(page.read_text("utf-8")):
            yield f"book_{page.stem}", "import archard\n" + "".join(blocks)
    for notebook in (HERE / "notebooks").glob("*.ipynb"):
        cells = json.loads(notebook.read_text("utf-8"))["cells"]
        yield (
            f"notebook_{notebook.stem}",
            "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"),
        )
    for example in (ROOT / "examples").rglob("*.py"):
        yield f"example_{example.stem}", example.read_text("utf-8")


def test_examples_keep_to_the_types(tmp_path):
    """Names are given anew from block to block."""
    for name, text in examples():
        (tmp_path / f"{name.replace('-', '_')}.py").write_text(text, "utf-8")
    files = sorted(path.name for path in tmp_path.glob("*.py"))
    assert len(files) > 15
    (tmp_path / "wrong.py").write_text("import archard\narchard.Case('hertz').run(thread=2)\n", "utf-8")
    options = ["--ignore-missing-imports", "--allow-redefinition", "--check-untyped-defs", "--no-error-summary"]
    done = subprocess.run(
        [sys.executable, "-m", "mypy", *options, "--cache-dir", str(tmp_path / "cache"), *files, "wrong.py"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    found = done.stdout.splitlines()
    assert [line for line in found if "wrong.py" in line and 'argument "thread"' in line]
    assert [line for line in found if ": error:" in line and "wrong.py" not in line] == []
