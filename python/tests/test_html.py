"""What notebooks show: compact, in units of display, escaped."""

import re
from concurrent.futures import ThreadPoolExecutor
from xml.etree import ElementTree

import pytest

import archard

pytestmark = pytest.mark.filterwarnings("ignore::archard.ArchardWarning")
HOSTILE = "<script>alert('x')</script> & co"


def html(shown):
    """The markup, which is well formed, runs nothing and takes its colours from the page."""
    text = shown._repr_html_()
    tree = ElementTree.fromstring(text)
    assert {one.tag for one in tree.iter()} <= {
        "div", "b", "span", "table", "thead", "tbody", "tr", "th", "td", "ul", "li", "details", "summary", "pre"
    }  # fmt: skip
    assert not re.search(r"[^-]color: (?!inherit)|background", text)
    return " ".join("".join(tree.itertext()).split()), tree


def test_cases_are_their_keys(case):
    case["title"] = HOSTILE
    words, _ = html(case)
    assert words.startswith(HOSTILE)
    assert "motion.sliding.load10.2 N" in words
    assert 'frame.size["0.6 mm", "0.6 mm"]' in words


def test_forecasts_are_tables():
    forecast = archard.Case("pin_on_disc").check()
    words, tree = html(forecast)
    assert "peak pressure219 MPa" in words
    assert "# " not in words.split("title = ")[0]
    assert len(tree.findall(".//table")) >= 2


def test_results_have_usual_units(case):
    result = case.run()
    words, _ = html(result)
    assert words.startswith("Pin on disc: the pin wears goodNumbers at distance 24 mm")
    depth = 1e6 * result.history["wear_depth_m"][-1]
    assert f"Wear depth of pin{depth:.3f}".rstrip("0") in words
    assert "µm" in words
    assert "MPa" in words
    with pytest.raises(archard.RunError) as caught:
        case.run(on_step=lambda state: (_ for _ in ()).throw(archard.RunError("stop")) if state.progress else None)
    assert "the run is incomplete: stop" in html(caught.value.result)[0]


def test_columns_are_named_in_short(case):
    history = case.run().history
    assert repr(history).startswith("Table(13 rows: distance_m, ")
    assert "\n" not in repr(history)
    words, tree = html(history)
    assert "distance_m0 mm24 mm" in words
    assert len(tree.findall(".//tbody/tr")) == len(history)
    assert "0 rows" in html(type(history)())[0]


def test_results_of_folders_and_elastic_bodies_are_shown(case, tmp_path):
    result = case.run()
    result.save(tmp_path)
    assert html(archard.open(tmp_path))[0] == html(result)[0]
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(
        {name.split("/")[0] for name in result._files}
    )
    assert "good" in html(archard.Case("patch_test").run())[0]


def test_studies_are_tables(case):
    case["motion.sliding.distance"] = "2 mm"
    loads = [f"{load} N" for load in range(2, 30)]
    with ThreadPoolExecutor(1) as executor:
        study = archard.sweep(case, {"motion.sliding.load": loads}, executor=executor)
    words, tree = html(study)
    assert words.startswith("Sweep(28 rows) rowloadverdictpeak pressure")
    assert "12 more" in words
    assert len(tree.findall(".//tbody/tr")) == 28
    assert "2 N" in words
    assert repr(study) == "Sweep(28 rows)"


def test_fits_are_tables(case):
    rows = [("a", 12, 1.6e-5), ("a", 24, 3.2e-5), (HOSTILE, 12, 1.9e-5), (HOSTILE, 24, 3.7e-5)]
    test, distance, volume = zip(*rows, strict=True)
    fit = archard.fit(
        case,
        {"test": test, "distance_mm": distance, "volume_mm3": volume},
        parameter="body.pin.wear.archard.coefficient",
    )
    words, _ = html(fit)
    assert "body.pin.wear.archard.coefficient" in words
    assert "mm³/(N m)" in words
    assert repr(fit) in "".join(ElementTree.fromstring(fit._repr_html_()).itertext())
