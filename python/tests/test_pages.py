"""Pages and comparisons of results: those of the command."""

import logging
import re
import shutil
import subprocess
import sys

import matplotlib
import numpy as np
import pytest

import archard

matplotlib.use("agg")


@pytest.fixture
def result(case):
    return case.run()


def body(page):
    """The words of a page, without pictures and what tells when and by what it was computed."""
    text = page.read_text("utf-8")
    return re.sub(r'(?s)<h2[^>]*>How it was computed.*|<script.*?</script>|base64,[^"]*"', "", text)


def test_a_page_is_that_of_the_command(result, command, tmp_path):
    folder = tmp_path / "run"
    result.save(folder)
    command("report", folder)
    theirs = body(folder / "report.html")
    (folder / "report.html").unlink()
    opened = archard.open(folder)
    assert opened.report() == folder / "report.html"
    assert body(opened.report()) == theirs
    page = result.report(tmp_path / "page.html")
    assert body(page) == theirs
    assert "Numbers at distance 24 mm" in theirs


def test_pages_replace_nothing_else(result, tmp_path):
    with pytest.raises(ValueError, match="say where it goes"):
        result.report()
    notes = tmp_path / "notes.html"
    notes.write_text("<!DOCTYPE html>\nmine")
    with pytest.raises(ValueError, match="is no page of this program"):
        result.report(notes)
    assert notes.read_text() == "<!DOCTYPE html>\nmine"
    with pytest.raises(ValueError, match="is no page of this program"):
        result.report(tmp_path)
    page = result.report(tmp_path / "page.html")
    assert result.report(page) == page


def readings(result, factor=1.1):
    history = result.history
    some = history["distance_m"] > 0
    return {
        "distance_mm": 1e3 * history["distance_m"][some],
        "depth_um": factor * 1e6 * history["wear_depth_m"][some],
    }


def test_a_comparison_is_that_of_the_command(result, command, tmp_path):
    folder, table = tmp_path / "run", tmp_path / "wear.csv"
    result.save(folder)
    columns = readings(result)
    np.savetxt(table, np.transpose(list(columns.values())), "%.17g", ",", header=",".join(columns), comments="")
    said = command("compare", folder, table, "--body", "pin")
    shutil.rmtree(folder / "plots")
    opened = archard.open(folder)
    comparison = opened.compare(table, body="pin")
    assert said.startswith(f"{comparison.text}\n")
    assert "computed -9.1 % against measured" in comparison.text
    assert not (folder / "plots").exists()
    figure = comparison.plot(size="column")
    assert figure.get_figwidth() == pytest.approx(85 / 25.4)
    # Columns and results in memory are the same as files.
    memory = result.compare(columns, body="pin")
    assert memory.text.splitlines()[1:] == comparison.text.splitlines()[1:]
    page = result.report(tmp_path / "page.html", beside=[columns], body="pin")
    assert "-9.1 % against measured" in page.read_text("utf-8")
    assert "compared with `data 2.csv`" in page.read_text("utf-8")
    matplotlib.pyplot.close(figure)


def test_results_are_compared(result, case):
    case["motion.sliding.load"] = "8 N"
    comparison = result.compare(case.run())
    assert re.search(r"wear depth +[0-9.]+ µm here, [0-9.]+ µm in `run 2`: -", comparison.text)
    figure = comparison.plot()
    assert not [words for words in figure.findobj(matplotlib.text.Text) if "archard-" in words.get_text()]
    matplotlib.pyplot.close(figure)


def test_comparisons_that_are_none_are_refused(result):
    with pytest.raises(ValueError, match="give a measured table"):
        result.compare()
    with pytest.raises(ValueError, match=r"^body=ring: the bodies are pin and disc"):
        result.compare(readings(result), body="ring")
    with pytest.raises(ValueError, match="data are a CSV file"):
        result.compare(3)
    with pytest.raises(ValueError, match=r"^`data 2\.csv` has no reading .* Name one by `columns`"):
        result.compare({"distance_mm": [12], "dept_um": [0.2]}, body="pin")
    with pytest.raises(ValueError, match=r"cannot read `nowhere\.csv`"):
        result.compare("nowhere.csv", body="pin")


def test_nothing_is_printed_and_the_log_tells(case, capfd, caplog):
    with caplog.at_level(logging.DEBUG, "archard"):
        case.run()
    told = [record for record in caplog.records if record.name == "archard"]
    assert any("begins with" in record.getMessage() for record in told if record.levelno == logging.INFO)
    assert any("the result is good" in record.getMessage() for record in told if record.levelno == logging.INFO)
    steps = [record for record in told if re.search(r"at .* of 0\.024", record.getMessage())]
    assert len(steps) == 13
    assert {record.levelno for record in steps} == {logging.DEBUG}
    assert capfd.readouterr() == ("", "")


DOUBTFUL = """
import logging, sys
import archard

case = archard.Case("pin_on_disc")
del case["accuracy"]
case["frame"] = {"size": ["0.6 mm", "0.6 mm"], "elements": [10, 10]}
case["motion.sliding"] = {"load": "10.2 N", "distance": "6 mm", "step": "2 mm"}
logging.basicConfig(level=logging.INFO, format="%(name)s: %(message)s", stream=sys.stdout)
logging.captureWarnings(sys.argv[1] == "captured")
case.run()
"""


def test_what_is_doubtful_is_told_once():
    """By warnings, which become log messages where that is asked for."""
    told = {}
    for how in ("captured", "not"):
        done = subprocess.run([sys.executable, "-c", DOUBTFUL, how], capture_output=True, text=True, check=True)
        told[how] = (done.stdout, done.stderr)
    for kind in ("CaseWarning: ", "ResultWarning: the result is doubtful"):
        assert [text.count(kind) for text in told["captured"]] == [1, 0]
        assert [text.count(kind) for text in told["not"]] == [0, 1]
    assert "archard: Case(" in told["not"][0]
    assert "elements" not in told["not"][0]
