"""The Python of the book runs as it stands there, page by page."""

import os
import re
from pathlib import Path

import matplotlib as mpl
import pytest

import archard

ROOT = Path(__file__).parents[2]
BOOK = ROOT / "book" / "src"
BLOCK = re.compile(r"^```python\n(.*?)^```", re.DOTALL | re.MULTILINE)
TABLE = re.compile(r"^```(?:csv|toml) (\S+)\n(.*?)^```", re.DOTALL | re.MULTILINE)

#: Pages that show a command, each with its form in Python.
PAGES = sorted(path for path in BOOK.rglob("*.md") if BLOCK.search(path.read_text("utf-8")))


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with what pages take for granted: the cases, the examples and a run."""
    for name in ("cases", "examples"):
        os.symlink(ROOT / name, tmp_path / name)
    monkeypatch.chdir(tmp_path)
    mpl.use("agg")
    return tmp_path


# A page ends in the middle of what it shows: its last run goes with its names.
@pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.filterwarnings("ignore::archard.ArchardWarning")
@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.stem)
def test_pages_run(page, folder):
    text = page.read_text("utf-8")
    for name, table in TABLE.findall(text):
        (folder / name).write_text(table, "utf-8")
    if "results/pin_on_disc" in text and page.stem == "python":
        archard.Case("pin_on_disc").run(out="results/pin_on_disc")
    names = {"archard": archard}
    for block in BLOCK.findall(text):
        exec(compile(block, page.name, "exec"), names)


def test_pages_with_commands_have_python():
    without = [
        page.stem
        for page in BOOK.rglob("*.md")
        if re.search(
            r"^(    )?archard (run|check|sweep|fit|plot|compare|paraview)", page.read_text("utf-8"), re.MULTILINE
        )
        and page not in PAGES
    ]
    assert without == []


def test_symbols_name_what_results_have(folder):
    archard.Case("pin_on_disc").run(out="results")
    profiles = (folder / "results" / "profiles.csv").read_text("utf-8").splitlines()[0].replace("_pin_", "_BODY_")
    known = {*profiles.split(","), *re.findall(r"`([^`]+)`", (BOOK / "results.md").read_text("utf-8"))}
    rows = [row.split("|") for row in (BOOK / "symbols.md").read_text("utf-8").splitlines() if row.startswith("|")]
    # Keys of a case, which stand in the same column, have dots.
    names = [name for row in rows for name in re.findall(r"`([^`]+)`", row[-2]) if "." not in name]
    assert len(names) > 25
    assert [name for name in names if name not in known] == []
