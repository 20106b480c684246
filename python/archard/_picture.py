"""Pictures: the panels of ``archard plot``, drawn by matplotlib."""

from __future__ import annotations

import math
from typing import Any, Literal

import numpy as np

Size = Literal["column", "page"]

#: The width in print (mm) of a column and a page of a journal, and panels side by side in it.
_PRINT: dict[str, tuple[float, int]] = {"column": (85.0, 1), "page": (175.0, 2)}
_INCH = 25.4
#: Points of a pixel of the command's layout, on a screen and in print: there letters of 16 px have eight points.
_SCREEN, _IN_PRINT = 0.5625, 85.0 / _INCH * 72.0 / 480.0
#: Sizes (px) of letters: titles, labels, numbers and legends.
_TITLE, _LABEL, _TICK = 18.0, 16.0, 14.0


def chosen(told: dict[str, Any], name: str | None) -> dict[str, Any]:
    """Return the picture of that name; the overview, or else the last one, if none is named."""
    pictures = {one["name"]: one for one in told["pictures"]}
    if not pictures:
        raise ValueError("the result has nothing to draw")
    if name is None:
        name = "overview" if "overview" in pictures else list(pictures)[-1]
    if name not in pictures:
        raise ValueError(f"no picture `{name}`; there are {', '.join(pictures)}")
    return dict(pictures[name])


def draw(picture: dict[str, Any], mark: str | None, size: Size | None) -> Any:
    """Draw a picture below a mark, if there is one; return the matplotlib figure."""
    if size is not None and size not in _PRINT:
        raise ValueError(f'the size is "column" or "page", not {size!r}')
    from matplotlib import pyplot, rc_context

    panels, (across, up) = picture["panels"], picture["size"]
    if size is None:
        points, columns = _SCREEN, min(picture["columns"], len(panels))
        wide = across * points / 72.0
    else:
        width, most = _PRINT[size]
        points, columns = _IN_PRINT, min(most, len(panels))
        wide = width / most / _INCH
    rows = math.ceil(len(panels) / columns)
    letters: dict[Any, Any] = {
        "axes.titlesize": _TITLE * points,
        "axes.labelsize": _LABEL * points,
        "xtick.labelsize": _TICK * points,
        "ytick.labelsize": _TICK * points,
        "legend.fontsize": _TICK * points,
        "legend.title_fontsize": _TICK * points,
        "legend.frameon": False,
        "font.size": _TICK * points,
    }
    with rc_context(letters):
        figure, axes = pyplot.subplots(
            rows, columns, figsize=(columns * wide, rows * wide * up / across), squeeze=False, layout="constrained"
        )
        for place, one in enumerate(axes.flat):
            if place < len(panels):
                letter = f"{chr(ord('a') + place)}) " if len(panels) > 1 else ""
                _panel(one, panels[place], points, letter)
            else:
                one.set_axis_off()
        if mark:
            figure.suptitle(_plain(mark), color="tab:red", fontsize=_LABEL * points, wrap=True)
    return figure


def _panel(axes: Any, panel: dict[str, Any], points: float, letter: str) -> None:
    axes.margins(x=0.02)
    for mark in panel["marks"]:
        _mark(axes, mark, points)
    x, y = map(_plain, panel["labels"])
    axes.set_title(letter + _plain(panel["title"]), loc="left" if letter else "center")
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    if panel["log"]:
        axes.set(xscale="log", yscale="log")
    (left, right), (bottom, top) = panel["ends"]
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    if panel["to_scale"]:
        axes.set_aspect("equal")
    if not panel["named"]:
        axes.set_yticklabels([])
    for axis, names in zip((axes.xaxis, axes.yaxis), panel["steps"], strict=True):
        if names:
            axis.set_ticks(range(1, len(names) + 1), labels=names)
    for words, (at, height), colour in panel["notes"]:
        axes.text(at, height, _plain(words), color=colour, ha="center")
    # Contours have a bar of colours in its place.
    if any(mark["legend"] and "contours" not in mark for mark in panel["marks"]):
        inside = panel["legend"] != "outside"
        place = {"loc": panel["legend"]} if inside else {"loc": "upper left", "bbox_to_anchor": (1.0, 1.0)}
        axes.legend(title=_plain(panel["legend_title"] or ""), **place)


def _mark(axes: Any, mark: dict[str, Any], points: float) -> None:
    # Names that begin with a line do not appear in legends.
    name = _plain(mark["legend"] or "_")
    if "line" in mark:
        x, y = _numbers(mark["line"])
        axes.plot(x, y, color=mark["colour"], linewidth=mark["width"] * points, label=name)
    elif "dots" in mark:
        x, y = _numbers(mark["dots"])
        axes.plot(x, y, "o", color=mark["colour"], markersize=10.0 * points, label=name)
    elif "band" in mark:
        x, low, high = _numbers(mark["band"])
        axes.fill_between(x, low, high, color=mark["colour"], alpha=mark["opacity"], linewidth=0.0, label=name)
    elif "map" in mark:
        _map(axes, mark)
    elif "contours" in mark:
        _contours(axes, mark)
    else:
        _parts(axes, mark)


def _map(axes: Any, mark: dict[str, Any]) -> None:
    """White where there is nothing: at zero, or where values have a sign at what is no number."""
    rows = np.array(mark["map"], dtype=float)
    signed = bool((rows < 0.0).any())
    shown = np.ma.masked_invalid(rows) if signed else np.ma.masked_less_equal(np.nan_to_num(rows), 0.0)
    (left, right), (low, high) = mark["edges"]
    x, y = np.linspace(left, right, rows.shape[1] + 1), np.linspace(low, high, rows.shape[0] + 1)
    drawn = axes.pcolormesh(x, y, shown, vmin=None if signed else 0.0, rasterized=True)
    _bar(axes, drawn)


def _contours(axes: Any, mark: dict[str, Any]) -> None:
    """Values at places, filled between levels."""
    values = np.ma.masked_invalid(np.array(mark["contours"], dtype=float))
    x, y = _numbers(mark["places"])
    levels = np.array(mark["levels"], dtype=float)
    drawn = axes.contourf(x, y, values, levels=levels, extend="both")
    axes.contour(x, y, values, levels=levels, colors="white", linewidths=0.6)
    _bar(axes, drawn)


def _parts(axes: Any, mark: dict[str, Any]) -> None:
    """Elements by their outlines."""
    from matplotlib.collections import PolyCollection

    parts = [(corners, value) for corners, value in mark["parts"] if value and len(corners) > 2]
    values = np.array([value for _, value in parts], dtype=float)
    drawn = PolyCollection(
        [corners for corners, _ in parts], array=values, edgecolors="face", linewidths=0.3, rasterized=True
    )
    drawn.set_clim(0.0, values.max() if values.size else 1.0)
    axes.add_collection(drawn)
    (left, right), (low, high) = mark["edges"]
    axes.set(xlim=(left, right), ylim=(low, high))
    _bar(axes, drawn)


def _bar(axes: Any, drawn: Any) -> None:
    """Colours right beside the map, however wide that is to scale."""
    axes.figure.colorbar(drawn, cax=axes.inset_axes((1.03, 0.0, 0.05, 1.0), label="<colorbar>"))


def _plain(text: str) -> str:
    """A text without formulas: names of bodies are anything."""
    return text.replace("$", r"\$")


def _numbers(columns: list[list[float | None]]) -> list[Any]:
    return [np.array(column, dtype=float) for column in columns]
