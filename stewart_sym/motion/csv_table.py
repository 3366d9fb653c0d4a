"""CSV logs as columns of numbers: encoding, delimiter, decimal mark, header, and rows without numbers."""

import contextlib
import csv
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array
from ..io.toml_reader import opened

DELIMITERS = {"comma": ",", "semicolon": ";", "tab": "\t"}
DECIMALS = {"point": ".", "comma": ","}

# Number of rows that are converted together, and that determine the decimal mark.
_BLOCK, _SOME = 1 << 12, 1000
# Number of digits of nanoseconds since 1970, which a double cannot represent.
_LONG = 16
_BETWEEN_NUMBERS = re.compile(r"[\s;]+|,(?=\s|[-+\d])")
_NUMBER = re.compile(r"[-+]?(\d+([.,]\d*)?|[.,]\d+)([eE][-+]?\d+)?")
_INSTANT = re.compile(r"(?:(\d{4}-\d\d-\d\d)[T ])?(\d\d:\d\d:\d\d(?:\.\d{1,9})?)(?:Z|[-+]\d\d:?\d\d)?")
_UNIT = re.compile(r"(.*?)\s*[\[(]\s*([^\[\]()]*?)\s*[\])]")

# Nanoseconds of a day.
_DAY = 86_400_000_000_000

Lines = NDArray[np.int64]
"""Line numbers, from 1."""


@dataclass(frozen=True, eq=False)
class CsvTable:
    """Rows of a file as written, with their lines; rows with another number of cells are empty.

    Units come from brackets in the header, or from a row of units.
    """

    source: str
    header: tuple[str, ...]
    units: dict[str, str]
    lines: Lines
    _rows: Sequence[str]
    _delimiter: str
    _decimal: str

    def numbers(self, names: Sequence[str]) -> Array:
        """Return the numbers of columns of ``header``, shape (n, len(names)), NaN for other cells."""
        parse: Callable[..., Array] = partial(
            np.loadtxt, delimiter=self._delimiter, comments=None, ndmin=2, quotechar='"', encoding="utf-8"
        )
        places, found = [self.header.index(name) for name in names], []
        for start in range(0, len(self._rows), _BLOCK):
            rows = [row.replace(self._decimal, ".") for row in self._rows[start : start + _BLOCK]]
            try:
                found.append(parse(rows, usecols=places))
            except ValueError:
                found.append(parse(rows, usecols=places, converters=_number_or_nan))
        return np.concatenate(found)

    def cells(self, name: str) -> Iterator[str]:
        """Yield the texts of a column of ``header``."""
        place = self.header.index(name)
        return (_cells(row, self._delimiter)[place] for row in self._rows)

    def has_instants(self, name: str) -> bool:
        """Return True if a column begins with a date, a time of day, or nanoseconds since 1970."""
        cell = next(filter(None, self.cells(name)), "")
        return not np.isnat(_instant(cell)) and (not cell.isdigit() or len(cell) > _LONG)

    def times(self, name: str) -> tuple[Array, float | None]:
        """Return times in their unit and None, or seconds after the first date, and this date (s).

        Dates are ISO 8601, nanoseconds since 1970, or times of day, which continue after midnight. Other
        cells are NaN.
        """
        if not self.has_instants(name):
            return self.numbers([name])[:, 0], None
        found = np.array([_instant(cell) for cell in self.cells(name)], "datetime64[ns]")
        known, second = ~np.isnat(found), np.timedelta64(1, "s")
        first, epoch = found[known][0], np.datetime64(0, "ns")
        if first < epoch + np.timedelta64(1, "D"):
            found[known] = np.unwrap(found[known].astype(np.int64), period=_DAY).astype("datetime64[ns]")
        return (found - first) / second, float((first - epoch) / second)


def read_table(
    source: str,
    delimiter: str | None = None,
    decimal: str | None = None,
    what: str = "trajectory",
) -> CsvTable:
    """Read the text of a CSV file, and find its header.

    Blank lines, comments (``#`` or ``%``), and a line such as ``sep=;`` may be above the header; without a
    header, the last comment above the numbers is used. A row of units may follow. By default, the delimiter
    is the mark that divides the header into most names, and the decimal mark is a comma if numbers contain
    commas, no points, and other delimiters. ``what`` is the kind of the file in messages. Raises ValueError
    if the file cannot be read, has no header or no rows, or if most rows have another number of cells.
    """
    with opened(source, what) as stream:
        text = _decoded(stream.read())
    lines = text.split("\n")
    place, header, mark = _header(lines, source, None if delimiter is None else DELIMITERS[delimiter])
    names, stated = zip(*map(split_unit, header), strict=True)
    numbers = [i for i in range(place + 1, len(lines)) if lines[i].strip() and lines[i][0] not in "#%"]
    first = _cells(lines[numbers[0]], mark) if numbers else []
    if len(first) == len(names) and _is_unit_row(first):
        del numbers[0]
        stated = tuple(unit or cell.strip("[]() ") for unit, cell in zip(stated, first, strict=True))
    if not numbers:
        raise ValueError(f"{source}: no rows of numbers below the header; add rows")
    rows = [lines[i] for i in numbers]
    marks = [len(_cells(row, mark)) - 1 if '"' in row else row.count(mark) for row in rows]
    wrong = np.flatnonzero(np.array(marks) != len(names) - 1)
    if 2 * len(wrong) > len(rows):
        finding = f"line {numbers[wrong[0]] + 1}: expected {len(names)} cells as in the header"
        raise ValueError(f"{source}: {finding}; check delimiter and decimal")
    for i in wrong:
        rows[i] = mark * (len(names) - 1)
    comma = mark != "," and (_has_decimal_comma(rows, mark) if decimal is None else decimal == "comma")
    units = {name: unit for name, unit in zip(names, stated, strict=True) if unit}
    return CsvTable(source, names, units, np.array(numbers) + 1, rows, mark, "," if comma else ".")


def split_unit(cell: str) -> tuple[str, str]:
    """Split a header cell such as ``Roll [deg]`` into name and unit, which may be empty."""
    found = _UNIT.fullmatch(cell)
    return (found[1], found[2]) if found and found[1] else (cell, "")


def is_number(cell: str) -> bool:
    """Return True for a decimal number with either decimal mark."""
    return _NUMBER.fullmatch(cell) is not None


def _decoded(data: bytes) -> str:
    """Decode UTF-8, UTF-16 with a byte order mark, or the Windows code page 1252, with ends of lines \\n."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        data = data.decode("utf-16", errors="replace").encode()
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("cp1252", errors="replace")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _header(lines: Sequence[str], source: str, given: str | None) -> tuple[int, list[str], str]:
    """Return the index of the last line above the rows, the cells of the header, and the delimiter."""
    comment, stated = "", given
    for i, line in enumerate(lines):
        text = line.strip(' "')
        if text.lower().startswith("sep=") and len(text) == 5:
            stated = stated or text[4]
        elif text.startswith(("#", "%")):
            comment = text.lstrip("#% ")
        elif text.strip(" \t,;"):
            is_row = all(not cell or is_number(cell) for cell in _BETWEEN_NUMBERS.split(line.strip()))
            mark = stated or max(DELIMITERS.values(), key=(comment if is_row else line).count)
            cells = _cells(line, mark)
            if comment and all(map(is_number, cells)) and len(_cells(comment, mark)) == len(cells):
                return i - 1, _cells(comment, mark), mark
            if all(map(is_number, cells)):
                place = f"{source}: line {i + 1}"
                raise ValueError(f"{place}: no header line; name the columns in a line above the numbers")
            if not all(cell.isprintable() for cell in cells):
                raise ValueError(f"{source}: line {i + 1}: the header is not text; save the file as CSV")
            return i, [cell or f"column {place + 1}" for place, cell in enumerate(cells)], mark
    raise ValueError(f"{source}: the file is empty; write a header line and rows of numbers")


def _cells(line: str, delimiter: str) -> list[str]:
    """Split a line into cells without blanks and quotation marks."""
    cells = next(csv.reader([line], delimiter=delimiter)) if '"' in line else line.split(delimiter)
    return [cell.strip() for cell in cells]


def _is_unit_row(cells: Sequence[str]) -> bool:
    """Return True for a row without numbers and dates whose cells are short."""
    return any(cells) and all(len(cell) < 12 and not re.search(r"\d{2}|^\d", cell) for cell in cells)


def _has_decimal_comma(rows: Sequence[str], delimiter: str) -> bool:
    """Return True if numbers contain commas and no points."""
    some = [_cells(row, delimiter) for row in rows[:: max(1, len(rows) // _SOME)]]
    numbers = [cell for cells in some for cell in cells if is_number(cell)]
    return any("," in cell for cell in numbers) and not any("." in cell for cell in numbers)


def _number_or_nan(cell: str) -> float:
    return float(cell) if is_number(cell.strip()) and "," not in cell else np.nan


def _instant(text: str) -> np.datetime64:
    """Return the instant of a cell; NaT if it is none."""
    found = _INSTANT.fullmatch(text.replace(",", "."))
    with contextlib.suppress(ValueError, OverflowError):
        if text.isdigit():
            return np.datetime64(int(text), "ns")
        if found is not None:
            return np.datetime64(f"{found[1] or '1970-01-01'}T{found[2]}", "ns")
    return np.datetime64("NaT")
