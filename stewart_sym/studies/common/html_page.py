"""Report as one HTML file with text, sortable tables, plots, and motions as in ``view``."""

import base64
import html
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, TypeGuard

import numpy as np

from ...io.arguments import safe_text
from ...io.output import plain
from ...io.progress import Progress, silent
from ...viewer.page import document, filled, generator
from ...viewer.view import frame
from .report import Report, drawn

MOST_ROWS = 500
"""Largest number of rows of a table over time; longer tables are sampled evenly."""

# A cell shows the numbers of a list up to this length, and the range of a longer list.
_MOST_NUMBERS = 6


def html_page(title: str, report: Report, progress: Progress = silent) -> str:
    """Format a report as HTML: lists of records become tables, and columns collapsed tables."""
    result = f'<pre class="wide" tabindex="0">{_text(report.text)}</pre>'
    parts = [_section("Result", result)] if report.text else []
    for number, (name, view) in enumerate(report.views.items()):
        progress(f"writing {name}", number / len(report.views))
        parts.append(_section(name, frame(view())))
    for name, picture in report.figures.items():
        progress(f"drawing {name}")
        # Text as outlines has the same appearance in all programs.
        outlines = replace(picture, kinds=("svg",), style={**picture.style, "svg.fonttype": "path"})
        source = f"data:image/svg+xml;base64,{base64.b64encode(drawn(outlines)['svg']).decode()}"
        body = f'<figure><img alt="{_text(_words(name))}" src="{source}"></figure>\n'
        parts.append(_section(_words(name), body))
    for name, records in _lists("", plain(report.data)):
        keys = list(dict.fromkeys(key for record in records for key in record))
        found = [list(map(record.get, keys)) for record in records]
        parts.append(_section(_words(name), _table(_words(name), map(_words, keys), found)))
    for name, table in report.tables.items():
        if isinstance(table, str):
            continue
        caption, rows = _sampled(f"{name}.csv", table)
        body = f"<summary>{_text(caption)}</summary>\n{_table(caption, table, rows)}"
        parts.append(f"<details>\n{body}\n</details>\n")
    values = {"title": _text(title), "parts": "\n".join(parts), "generator": _text(generator())}
    inner = ["main"] if report.views else []
    return document(title, filled("report.html", values), "sort", ("style.css", "report.css"), inner)


def _section(title: str, body: str) -> str:
    # File names are not capitalized.
    head = title if "." in title else title[:1].upper() + title[1:]
    return f"<section>\n<h2>{_text(head)}</h2>\n{body}\n</section>\n"


def _lists(where: str, data: object) -> Iterator[tuple[str, Sequence[Mapping[str, Any]]]]:
    """Yield lists of records in data with the path to each list; lists within rows follow."""
    if isinstance(data, Mapping):
        for key, value in data.items():
            yield from _lists(f"{where} {key}".strip(), value)
    elif _is_list_of_tables(data):
        flat = [{key: each for key, each in row.items() if not _is_list_of_tables(each)} for row in data]
        yield where, flat
        for number, row in enumerate(data, 1):
            inner = {key: value for key, value in row.items() if _is_list_of_tables(value)}
            yield from _lists(f"{where} {row.get('name', number)}", inner)


def _is_list_of_tables(data: Any) -> TypeGuard[list[Mapping[str, Any]]]:
    return isinstance(data, list) and bool(data) and all(isinstance(row, Mapping) for row in data)


def _sampled(name: str, columns: Mapping[str, Any]) -> tuple[str, list[Sequence[Any]]]:
    """Return a caption with the number of rows, and the displayed rows of columns."""
    count = max(map(len, columns.values()), default=0)
    some = np.unique(np.linspace(0, max(count - 1, 0), min(count, MOST_ROWS)).astype(np.int64))
    rows: list[Sequence[Any]] = [*zip(*(plain(column[some]) for column in columns.values()), strict=True)]
    shown = f"{count}" if len(some) == count else f"{len(some)} of {count}"
    return f"{name}: {shown} rows", rows


def _table(caption: str, names: Iterable[str], rows: Iterable[Sequence[Any]]) -> str:
    """Format rows as a sortable table; nested or long values are text in one cell."""
    heads = "".join(f'<th scope="col"><button type="button">{_text(name)}</button></th>' for name in names)
    body = "".join(f"<tr>{''.join(map(_cell, row))}</tr>" for row in rows)
    label = f'class="wide" tabindex="0" role="region" aria-label="{_text(caption)}"'
    head = f"<caption>{_text(caption)}</caption><thead><tr>{heads}</tr></thead>"
    return f'<div {label}><table class="sorts">{head}<tbody>{body}</tbody></table></div>\n'


def _cell(value: object) -> str:
    if isinstance(value, bool) or value is None:
        return f"<td>{'' if value is None else 'yes' if value else 'no'}</td>"
    if isinstance(value, int | float):
        return f'<td data-value="{str(value).replace("inf", "Infinity")}">{value:.6g}</td>'
    if isinstance(value, list) and all(isinstance(each, int | float) for each in value):
        if len(value) > _MOST_NUMBERS:
            return f"<td>{len(value)} numbers, {min(value):.4g} to {max(value):.4g}</td>"
        return f"<td>{', '.join(f'{each + 0.0:.4g}' for each in value)}</td>"
    if isinstance(value, list):
        value = "; ".join(map(str, value))
    if isinstance(value, Mapping):
        value = ", ".join(f"{_words(str(key))} {each}" for key, each in value.items())
    return f'<td class="words">{_text(str(value))}</td>'


def _words(name: str) -> str:
    return re.sub(r"_+", " ", name)


def _text(text: str) -> str:
    """Convert text to HTML; nonprintable characters are replaced by code points, line by line."""
    return "\n".join(html.escape(safe_text(line)) for line in text.split("\n"))
