"""Tables of results as CSV text."""

import csv
import io
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from numpy.typing import NDArray

_ROWS = 4096


Columns = dict[str, NDArray[Any]]
"""Columns (n,) by name."""


def of_legs(name: str, values: NDArray[Any], ending: str = "") -> Columns:
    """Columns of each leg, ``name1`` to ``name6``, from (n, 6)."""
    return {f"{name}{leg + 1}{ending}": column for leg, column in enumerate(values.T)}


def of_axes(name: str, values: NDArray[Any]) -> Columns:
    """Columns of each axis, ``name_x`` to ``name_z``, from (n, 3)."""
    return {f"{name}_{axis}": column for axis, column in zip("xyz", values.T, strict=True)}


def csv_lines(columns: Mapping[str, NDArray[Any]], header: bool = True) -> Iterator[str]:
    """Lines of a CSV file, header first; columns (n,) by name, floats with all their digits."""
    if header:
        yield ",".join(columns) + "\n"
    # A part of the rows as Python's numbers at a time: they take four times the room of the arrays.
    for start in range(0, max(map(len, columns.values()), default=0), _ROWS):
        part = (column[start : start + _ROWS].tolist() for column in columns.values())
        for row in zip(*part, strict=True):
            yield ",".join(map(repr, row)) + "\n"


def csv_text(rows: Iterable[Sequence[object]]) -> str:
    """Rows as CSV, floats with all their digits."""
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows(rows)
    return stream.getvalue()
