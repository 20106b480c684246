"""Pictures: the panels of the command, in units of display and widths of print."""

import matplotlib
import matplotlib.pyplot
import numpy as np
import pytest

import archard

matplotlib.use("agg")
pytestmark = pytest.mark.filterwarnings("ignore::archard.ArchardWarning")


@pytest.fixture(autouse=True)
def closed():
    yield
    matplotlib.pyplot.close("all")


def drawn(axes):
    """Whether anything can be seen between these axes."""
    lines = [
        line for line in axes.lines if np.isfinite(line.get_ydata()).sum() > 1 and np.ptp(line.get_xdata()) > 0
    ]
    meshes = [one for one in axes.collections if one.get_array() is not None and one.get_array().count()]
    return bool(lines or meshes)


def panels(figure):
    return [axes for axes in figure.axes if axes.get_label() != "<colorbar>"]


def test_pictures_are_those_of_the_command(case, command, tmp_path):
    result = case.run()
    result.save(tmp_path)
    command("plot", tmp_path)
    theirs = {file.stem for file in (tmp_path / "plots").glob("*.svg")}
    assert theirs == set(result.pictures) == set(archard.open(tmp_path).pictures)
    figure = result.plot()
    assert panels(figure)[0].get_xlabel() == "Distance (mm)"
    assert {"x (mm)", "Pressure (MPa)"} <= {
        words for axes in panels(figure) for words in (axes.get_xlabel(), axes.get_ylabel())
    }
    depth = result.plot("wear").axes[0]
    own = max(line.get_ydata().max() for line in depth.lines if line.get_label() != "_")
    assert own == pytest.approx(1e6 * result.history["wear_depth_m"][-1], rel=0.2)
    with pytest.raises(ValueError, match="no picture `waer`; there are wear, profiles"):
        result.plot("waer")


def test_names_are_no_formulas(case, tmp_path):
    result, other = case.run(), tmp_path / "a$\\frac$"
    result.save(other)
    figure = result.compare(other).plot()
    figure.canvas.draw()
    assert any(r"a\$\frac\$" in line.get_label() for line in figure.axes[0].lines)


@pytest.mark.parametrize("name", ["carter", "hertz", "fretting_sphere", "punch_indentation_block"])
def test_every_panel_shows_something(name):
    case = archard.Case(name)
    if name == "punch_indentation_block":
        case["body.block.mesh.box.contact.elements"] = [8, 8]
        case["motion.indentation.increments"] = 2
    if name == "fretting_sphere":
        case["frame.elements"] = [16, 16]
        case["motion.fretting.cycles"] = 1
    result = case.run()
    for picture in result.pictures:
        shown = panels(result.plot(picture))
        assert all(drawn(axes) for axes in shown if axes.axison), (picture, [axes.get_title() for axes in shown])
    assert len([axes for axes in panels(result.plot()) if axes.axison]) >= 1


def test_sizes_are_those_of_a_journal(case, tmp_path):
    result = case.run()
    for size, width, columns in [("column", 85.0, 1), ("page", 175.0, 2)]:
        figure = result.plot(size=size)
        assert figure.get_figwidth() == pytest.approx(width / 25.4)
        assert figure.axes[0].get_gridspec().ncols == columns
        assert figure.axes[0].xaxis.label.get_size() == pytest.approx(8.0, abs=0.1)
    figure.savefig(tmp_path / "page.pdf")
    assert (tmp_path / "page.pdf").stat().st_size > 5000
    with pytest.raises(ValueError, match='"column" or "page"'):
        result.plot(size="poster")
