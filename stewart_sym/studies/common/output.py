"""Tables of results as plain text, CSV, and, with paragraphs, Markdown for the documentation."""

import csv
import io
import math
import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...robot.robot import LEGS

_ROWS = 1024
# Largest integer that a double represents exactly, and largest number of decimals.
_MOST_EXACT, _MOST_DECIMALS = 2.0**53, 18

Columns = dict[str, NDArray[Any]]
"""Columns of shape (n,) by name."""

Figures = dict[str, Any]
"""JSON data of a study."""


def of_legs(name: str, values: NDArray[Any], ending: str = "") -> Columns:
    """Return the columns ``name_1`` to ``name_6`` of the legs from an array of shape (n, 6)."""
    return {f"{name}_{leg + 1}{ending}": column for leg, column in enumerate(values.T)}


def by_leg(columns: Mapping[str, Any]) -> list[Figures]:
    """Return a row for each leg, numbered from 1, from columns of shape (6, ...)."""
    return [{"leg": leg + 1} | {name: values[leg] for name, values in columns.items()} for leg in range(LEGS)]


def of_axes(name: str, values: NDArray[Any]) -> Columns:
    """Return the columns ``name_x`` to ``name_z`` of the axes from an array of shape (n, 3)."""
    return {f"{name}_{axis}": column for axis, column in zip("xyz", values.T, strict=True)}


def csv_lines(
    columns: Mapping[str, NDArray[Any]], header: bool = True, digits: int | None = None
) -> Iterator[str]:
    """Yield the text of a CSV file in blocks of lines, header first.

    Floats have all digits, or with ``digits`` as many digits as the largest one of their column.
    """
    if header:
        yield csv_text([[*columns]])
    text = None if digits is None else _decimal_lines(columns, digits)
    if text is not None:
        yield text
        return
    # Rows are converted to Python numbers in blocks, because these require four times the memory of arrays.
    for start in range(0, max(map(len, columns.values()), default=0), _ROWS):
        part = [column[start : start + _ROWS] for column in columns.values()]
        yield csv_text(zip(*(values.tolist() for values in part), strict=True))


def _decimal_lines(columns: Mapping[str, NDArray[Any]], digits: int) -> str | None:
    """Format columns with a fixed number of decimals; None for a number that is infinite or too large.

    Times have all their decimals.
    """
    marks: list[NDArray[np.uint8]] = []
    for name, values in columns.items():
        decimals = _decimals_of_times(values) if name == "time" else _decimals(values, digits)
        if decimals is None:
            return None
        marks += [*_marks(values, decimals), np.full(len(values), ord(","), np.uint8)]
    marks[-1][:] = ord("\n")
    return np.stack(marks, axis=1).tobytes().translate(None, b" ").decode("ascii")


def _decimals(values: NDArray[Any], digits: int) -> int | None:
    """Return the number of decimals at which the largest value has a number of digits."""
    largest = float(np.abs(values).max(initial=0.0))
    if not largest < _MOST_EXACT:
        return None
    whole = math.floor(math.log10(largest)) + 1 if largest > 0.0 else digits
    return 0 if values.dtype.kind in "iu" else min(max(digits - whole, 0), _MOST_DECIMALS)


def _decimals_of_times(time: NDArray[Any]) -> int | None:
    """Return the number of decimals that represents all times exactly; None if they have too many digits."""
    for decimals in range(_MOST_DECIMALS):
        count = np.rint(time * 10.0**decimals)
        if not np.abs(count).max(initial=0.0) < _MOST_EXACT:
            return None
        if np.array_equal(count / 10.0**decimals, time):
            return decimals
    return None


def _marks(values: NDArray[Any], decimals: int) -> list[NDArray[np.uint8]]:
    """Return sign, digits, and point of numbers, each of shape (n,), from left to right, or blanks."""
    rest = np.rint(np.abs(values) * 10.0**decimals).astype(np.int64)
    found: list[NDArray[np.uint8]] = []
    for place in range(max(decimals + 1, len(str(rest.max(initial=0))))):
        if place == decimals > 0:
            found.append(np.full(len(values), ord("."), np.uint8))
        shown = (rest > 0) | (place <= decimals)
        tens = rest // 10
        found.append(np.where(shown, ord("0") + rest - 10 * tens, ord(" ")).astype(np.uint8))
        rest = tens
    found.append(np.where(values < 0, ord("-"), ord(" ")).astype(np.uint8))
    return found[::-1]


def columns_of(rows: Sequence[Sequence[object]]) -> Columns:
    """Return the columns of rows of texts and numbers; the first row is the header."""
    header, *found = rows
    return dict(zip(map(str, header), map(np.array, zip(*found, strict=True)), strict=True))


def csv_text(rows: Iterable[Sequence[object]]) -> str:
    """Format rows as CSV with all digits of floats."""
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows(rows)
    return stream.getvalue()


def aligned(header: Sequence[str], rows: Sequence[Sequence[str]], left: int = 1) -> str:
    """Format a text table; the first ``left`` columns are left-aligned, others right-aligned."""
    columns = []
    for i, column in enumerate(zip(header, *rows, strict=True)):
        width = max(map(len, column))
        columns.append([cell.ljust(width) if i < left else cell.rjust(width) for cell in column])
    lines = ["  ".join(cells).rstrip() for cells in zip(*columns, strict=True)]
    return "\n".join([lines[0], "-" * max(map(len, lines)), *lines[1:]])


def leg_table(name: str, columns: Mapping[str, Sequence[str]]) -> str:
    """Format a text table with a row for each leg, numbered in the first column ``name``."""
    numbers = [str(leg + 1) for leg in range(LEGS)]
    return aligned([name, *columns], list(zip(numbers, *columns.values(), strict=True)))


def paragraph(line: str) -> str:
    """Format a Markdown paragraph with lines of at most 110 characters and an empty line."""
    return textwrap.fill(line, 110, break_on_hyphens=False, break_long_words=False) + "\n\n"


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Format a Markdown table with header, rows, and an empty line."""
    lines = [header, ["---"] * len(header), *rows]
    return (
        "".join(f"|{'|'.join(f' {cell} ' if cell else ' ' for cell in cells)}|\n" for cells in lines) + "\n"
    )
