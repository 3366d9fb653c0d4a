"""Report as one HTML file with text, sortable tables, plots, and motions as in ``view``."""

import base64
import contextlib
import csv
import html
import io
import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

from ...io.arguments import safe_text
from ...io.json_text import plain
from ...io.progress import Progress, silent
from ...viewer.page import document, filled, generator
from ...viewer.view import frame
from .report import Picture, Report, svg

MOST_ROWS = 500
"""Largest number of rows of a table over time; longer tables are sampled evenly."""

# A cell shows the numbers of a list up to this length, and the range of a longer list.
_MOST_NUMBERS = 6


def html_page(title: str, report: Report, progress: Progress = silent) -> str:
    """Format a report as HTML.

    Lists of records in the data of the report and text tables become tables. Columns over time become tables
    that are collapsed initially. Raises ImportError for plots without Matplotlib.
    """
    parts = (
        [_section("Result", f'<pre class="wide" tabindex="0">{_text(report.text)}</pre>')]
        if report.text
        else []
    )
    for number, (name, view) in enumerate(report.views.items()):
        progress(f"writing {name}", number / len(report.views))
        parts.append(_section(name, frame(view())))
    parts += [
        _section(_words(name), _figure(name, picture, progress)) for name, picture in report.figures.items()
    ]
    parts += [
        _section(_words(name), _table(_words(name), rows)) for name, rows in _lists("", plain(report.data))
    ]
    for name, table in report.tables.items():
        parts.append(
            _closed(f"{name}.csv", table)
            if isinstance(table, Mapping)
            else _section(_words(name), _rows_of(_words(name), table))
        )
    values = {"title": _text(title), "parts": "\n".join(parts), "generator": _text(generator())}
    inner = ["main"] if report.views else []
    return document(title, filled("report.html", values), "sort", ("style.css", "report.css"), inner)


def _section(title: str, body: str) -> str:
    # File names are not capitalized.
    head = title if "." in title else title[:1].upper() + title[1:]
    return filled("section.html", {"title": _text(head), "body": body})


def _figure(name: str, picture: Picture, progress: Progress) -> str:
    progress(f"drawing {name}")
    stream = io.BytesIO()
    svg(picture, stream)
    data = base64.b64encode(stream.getvalue()).decode()
    return filled("figure.html", {"name": _text(_words(name)), "data": data})


def _lists(where: str, data: object) -> Iterator[tuple[str, Sequence[Mapping[str, Any]]]]:
    """Yield lists of records in data with the path to each list; lists within rows follow."""
    if isinstance(data, Mapping):
        for key, value in data.items():
            yield from _lists(f"{where} {key}".strip(), value)
    elif _is_list_of_tables(data):
        yield (
            where,
            [{key: value for key, value in row.items() if not _is_list_of_tables(value)} for row in data],
        )
        for number, row in enumerate(data, 1):
            inner = {key: value for key, value in row.items() if _is_list_of_tables(value)}
            yield from _lists(f"{where} {row.get('name', number)}", inner)


def _is_list_of_tables(data: Any) -> TypeGuard[list[Mapping[str, Any]]]:
    return isinstance(data, list) and bool(data) and all(isinstance(row, Mapping) for row in data)


def _table(caption: str, rows: Sequence[Mapping[str, Any]]) -> str:
    """Format records as a table; nested or long values are text in one cell."""
    names = list(dict.fromkeys(name for row in rows for name in row))
    cells = ["".join(map(_cell, map(row.get, names))) for row in rows]
    return _filled_table(caption, map(_words, names), cells)


def _rows_of(caption: str, text: str) -> str:
    """Format CSV text as a table; a long table is sampled."""
    names, *rows = csv.reader(io.StringIO(text))
    shown = rows if len(rows) <= MOST_ROWS else [rows[i] for i in _some(len(rows))]
    cells = ["".join(_cell(_number(text)) for text in row) for row in shown]
    return _filled_table(_thinned(caption, len(shown), len(rows)), map(_words, names), cells)


def _number(text: str) -> float | str:
    with contextlib.suppress(ValueError):
        number = float(text)
        return text if math.isnan(number) else number
    return text


def _closed(caption: str, columns: Mapping[str, Any]) -> str:
    """Format columns over time as a collapsed table; the file of the subcommand contains all rows."""
    count = max(map(len, columns.values()), default=0)
    some = _some(count)
    lists = [plain(np.asarray(column)[some]) for column in columns.values()]
    rows = ["".join(map(_cell, row)) for row in zip(*lists, strict=True)]
    shown = _thinned(caption, len(some), count)
    return filled("closed.html", {"title": _text(shown), "body": _filled_table(shown, columns, rows)})


def _some(count: int) -> NDArray[np.int64]:
    """Return the indices of the displayed rows of a table with ``count`` rows."""
    return np.unique(np.linspace(0, max(count - 1, 0), min(count, MOST_ROWS)).astype(np.int64))


def _thinned(caption: str, shown: int, count: int) -> str:
    return f"{caption}: {count} rows" if shown == count else f"{caption}: {shown} of {count} rows"


def _filled_table(caption: str, names: Iterable[str], rows: Sequence[str]) -> str:
    heads = "".join(f'<th scope="col"><button type="button">{_text(name)}</button></th>' for name in names)
    values = {"caption": _text(caption), "heads": heads, "rows": "".join(f"<tr>{row}</tr>" for row in rows)}
    return filled("table.html", values)


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
