"""Tables of results as plain text and CSV."""

import csv
import io
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...drives.limit_status import amount_text
from ...robot.robot import LEGS

_ROWS = 2048
# Largest integer that a double represents exactly, and largest number of decimals.
_MOST_EXACT, _MOST_DECIMALS = 2.0**53, 18
# Four characters of each integer below 10,000.
_FOUR_DIGITS = np.frombuffer("".join(f"{k:04d}" for k in range(10_000)).encode(), np.uint32)

Columns = dict[str, NDArray[Any]]
"""Columns of shape (n,) by name."""

Figures = dict[str, Any]
"""JSON data of a study."""


def of_legs(name: str, values: NDArray[Any], ending: str = "") -> Columns:
    """Return the columns ``name_1`` to ``name_6`` of the legs from an array of shape (n, 6)."""
    return {f"{name}_{leg + 1}{ending}": column for leg, column in enumerate(values.T)}


def records(columns: Mapping[str, Any]) -> list[Figures]:
    """Return a row for each entry of columns, shape (n, ...), by name."""
    return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]


def by_leg(columns: Mapping[str, Any]) -> list[Figures]:
    """Return a row for each leg, numbered from 1, from columns of shape (6, ...)."""
    return records({"leg": range(1, LEGS + 1), **columns})


def of_axes(name: str, values: NDArray[Any]) -> Columns:
    """Return the columns ``name_x`` to ``name_z`` of the axes from an array of shape (n, 3)."""
    return {f"{name}_{axis}": column for axis, column in zip("xyz", values.T, strict=True)}


def csv_lines(
    columns: Mapping[str, NDArray[Any]], header: bool = True, digits: int | None = None
) -> Iterator[str]:
    """Yield the text of a CSV file in blocks of lines, with ``digits`` of the largest number of a column."""
    if header:
        yield csv_text([[*columns]])
    decimals = None if digits is None else _decimals(columns, digits)
    # Rows are converted to Python numbers in blocks, because these require four times the memory of arrays.
    for start in range(0, max(map(len, columns.values()), default=0), _ROWS):
        part = [column[start : start + _ROWS] for column in columns.values()]
        if decimals is None:
            yield csv_text(zip(*(values.tolist() for values in part), strict=True))
        else:
            yield _decimal_lines(part, decimals)


def _decimals(columns: Mapping[str, NDArray[Any]], digits: int) -> list[int] | None:
    """Return the number of decimals of each column; None for infinite or too large numbers."""
    decimals: list[int | None] = []
    for name, values in columns.items():
        largest = float(np.abs(values).max(initial=0.0))
        if not largest < _MOST_EXACT:
            return None
        if name == "time":
            places = [n for n in range(_MOST_DECIMALS) if largest * 10.0**n < _MOST_EXACT]
            decimals.append(next((n for n in places if np.array_equal(np.round(values, n), values)), None))
        else:
            whole = math.floor(math.log10(largest)) + 1 if largest > 0.0 else digits
            decimals.append(min(max(digits - whole, 0), 0 if values.dtype.kind in "iu" else _MOST_DECIMALS))
    known = [each for each in decimals if each is not None]
    return known if len(known) == len(decimals) else None


def _decimal_lines(columns: Sequence[NDArray[Any]], decimals: Sequence[int]) -> str:
    """Format rows with fixed numbers of decimals, in a fifth of the time of Python's formatting."""
    cells = []
    for values, places in zip(columns, decimals, strict=True):
        scaled = np.rint(np.abs(values) * 10.0**places).astype(np.int64)
        width = max(len(str(scaled.max(initial=0))), places + 1)
        text = _digits(scaled, width)
        # Null characters are removed below.
        for k in range(width - places - 1):
            text[:, k] *= scaled >= 10 ** (width - 1 - k)
        sign = np.where(values < 0, ord("-"), 0).astype(np.uint8)[:, None]
        point, comma = (np.full((len(values), 1), ord(mark), np.uint8) for mark in ".,")
        whole, fraction = text[:, : width - places], text[:, width - places :]
        cells += [sign, whole, *([point, fraction] if places else []), comma]
    table = np.hstack(cells)
    table[:, -1] = ord("\n")
    return table.tobytes().translate(None, b"\0").decode()


def _digits(values: NDArray[np.int64], width: int) -> NDArray[np.uint8]:
    """Return the last ``width`` decimal digits of integers >= 0, shape (n,), as characters, (n, width)."""
    found = np.empty((len(values), -(-width // 4)), np.uint32)
    for k in reversed(range(found.shape[1])):
        quotient = values // 10_000
        found[:, k] = _FOUR_DIGITS[values - 10_000 * quotient]
        values = quotient
    return found.view(np.uint8)[:, -width:]


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


def amounts(values: NDArray[Any], sd: NDArray[Any] | None, digits: int) -> list[str]:
    """Format the value of each leg with its standard deviation, if any."""
    deviations = [None] * LEGS if sd is None else sd
    return [amount_text(value, off, digits) for value, off in zip(values, deviations, strict=True)]
