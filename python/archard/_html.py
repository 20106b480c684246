"""Tables in notebooks: compact, escaped, in the colours of the page around them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

#: Colours beside words of a verdict, seen on light and dark pages and by any eye: of M. Okabe and K. Ito.
_SIGNS = {"good": "#009e73", "doubtful": "#e69f00", "wrong": "#d55e00", "incomplete": "#d55e00"}
#: Rows that are shown before the rest is folded away, letters of a cell, and of one that is not wrapped.
_ROWS, _LETTERS, _WHOLE = 16, 80, 40

_CELL = "padding: 0.15em 0.8em 0.15em 0; vertical-align: top; text-align: left"
_TABLE = "border-collapse: collapse; color: inherit; font-size: inherit"


class Html(str):
    """Markup; any other text is escaped before it becomes a part of it."""

    __slots__ = ()


def block(*parts: str) -> str:
    """Return parts below each other."""
    return f"<div>{''.join(map(_markup, parts))}</div>"


def title(text: str, *signs: Html) -> Html:
    """Return a heading, with signs behind it."""
    return Html(f"<div><b>{escape(text)}</b> {' '.join(signs)}</div>")


def sign(word: str) -> Html:
    """Return the word of a verdict, with its colour beside it."""
    bar = f"border-left: 0.4em solid {_SIGNS.get(word, '#999999')}; padding-left: 0.3em"
    return Html(f'<span style="{bar}">{escape(word)}</span>')


def lines(texts: Iterable[str]) -> Html:
    """Return a list of sentences."""
    items = "".join(f"<li>{escape(text)}</li>" for text in texts)
    return Html(f'<ul style="margin: 0.2em 0">{items}</ul>' if items else "")


def table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> Html:
    """Return a table; what is long is folded away."""
    rows = [[_short(cell) for cell in row] for row in rows]
    some, rest = rows[:_ROWS], rows[_ROWS:]
    head = "".join(f'<th style="{_CELL}">{escape(one)}</th>' for one in heads)
    whole = _table(f"<thead><tr>{head}</tr></thead>" if heads else "", some)
    if rest:
        whole += f"<details><summary>{len(rest)} more</summary>{_table('', rest)}</details>"
    return Html(whole)


def folded(summary: str, *parts: str) -> Html:
    """Return parts that are shown where they are asked for."""
    return Html(f"<details><summary>{escape(summary)}</summary>{''.join(map(_markup, parts))}</details>")


def words(text: str) -> Html:
    """Return a text as it is printed."""
    return Html(f'<pre style="margin: 0.2em 0">{escape(text)}</pre>')


def _table(head: str, rows: Sequence[Sequence[str]]) -> str:
    body = "".join(f"<tr>{''.join(map(_cell, row))}</tr>" for row in rows)
    return f'<table style="{_TABLE}">{head}<tbody>{body}</tbody></table>'


def _cell(text: str) -> str:
    wraps = "normal" if len(text) > _WHOLE and not isinstance(text, Html) else "nowrap"
    return f'<td style="{_CELL}; white-space: {wraps}">{_markup(text)}</td>'


def _markup(part: str) -> str:
    return part if isinstance(part, Html) else escape(part)


def _short(cell: str) -> str:
    return cell if isinstance(cell, Html) or len(cell) <= _LETTERS else f"{cell[: _LETTERS - 1]}…"
