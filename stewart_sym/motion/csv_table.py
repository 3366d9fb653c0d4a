"""CSV logs as columns of numbers: encoding, delimiter, decimal mark, header, and rows without numbers."""

import contextlib
import csv
import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array
from ..io.toml_reader import opened

DELIMITERS = {"comma": ",", "semicolon": ";", "tab": "\t"}
DECIMALS = {"point": ".", "comma": ","}

# Number of lines that are converted together.
_PART = 4096
# Number of digits that a double represents; nanoseconds since 1970 have more.
_LONG = 16
_BETWEEN_NUMBERS = re.compile(r"[\s;]+|,(?=\s|[-+\d])")
_NUMBER = re.compile(r"[-+]?(\d+([.,]\d*)?|[.,]\d+)([eE][-+]?\d+)?")
_INSTANT = re.compile(r"(?:(\d{4}-\d\d-\d\d)[T ])?(\d\d:\d\d:\d\d(?:\.\d{1,9})?)(?:Z|[-+]\d\d:?\d\d)?")
_UNIT = re.compile(r"(.*?)\s*[\[(]\s*([^\[\]()]*?)\s*[\])]")

# Nanoseconds of a day.
_DAY = 86_400_000_000_000

Lines = NDArray[np.int64]
"""Line numbers, from 1."""
Instants = NDArray[np.datetime64]
"""Dates, or times of day on 1970-01-01."""


@dataclass(frozen=True, eq=False)
class CsvTable:
    """Columns of a file as written.

    Attributes
    ----------
    source : str
        Name of the file.
    header : tuple of str
        Names of all columns without their units.
    units : dict of str to str
        Units by name, from brackets in the header or from a row of units.
    lines : ndarray, shape (n,)
        Line of each row of numbers.
    dropped : ndarray, shape (k,)
        Lines below the header that are no rows of numbers.
    """

    source: str
    header: tuple[str, ...]
    units: dict[str, str]
    lines: Lines
    dropped: Lines
    _texts: Sequence[str]
    _delimiter: str
    _decimal: str

    def numbers(self, names: Sequence[str]) -> Array:
        """Return the numbers of columns of ``header``, shape (n, len(names)), NaN for other cells."""
        places = [self.header.index(name) for name in names]
        return _numbers(self._texts, places, self._delimiter, self._decimal)

    def cells(self, name: str) -> list[str]:
        """Return the texts of a column of ``header``, length n."""
        place = self.header.index(name)
        return [_cells(text, self._delimiter)[place] for text in self._texts]

    def has_instants(self, name: str) -> bool:
        """Return True if a column begins with a date, a time of day, or nanoseconds since 1970."""
        cell = _cells(self._texts[0], self._delimiter)[self.header.index(name)] if self._texts else ""
        return not np.isnat(_instant(cell)) and (not cell.isdigit() or len(cell) > _LONG)

    def instants(self, name: str) -> Instants:
        """Return dates (ISO 8601), times of day, or nanoseconds since 1970; NaT for other cells.

        Times of day after midnight follow the ones before.
        """
        cells = self.cells(name)
        found = np.array([_instant(cell) for cell in cells], "datetime64[ns]")
        if cells[0][2:3] == ":":
            known = ~np.isnat(found)
            found[known] = np.unwrap(found[known].astype(np.int64), period=_DAY).astype("datetime64[ns]")
        return found


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
    if the file cannot be read, or has no header or no rows.
    """
    with opened(source, what) as stream:
        text = _decoded(stream.read())
    if text.lstrip().startswith(("{", "[{", "[[")):
        raise ValueError(f"{source}: expected a CSV table, got JSON; write a header line and rows of numbers")
    lines = text.splitlines()
    place, header, mark = _header(lines, source, None if delimiter is None else DELIMITERS[delimiter])
    names, units = zip(*map(split_unit, header), strict=True)
    below = [i for i in range(place + 1, len(lines)) if lines[i].strip(' \t;,"') and lines[i][0] not in "#%"]
    if below and _is_unit_row(row := _cells(lines[below[0]], mark), len(names)):
        units = tuple(unit or cell.strip("[]() ") for unit, cell in zip(units, row, strict=True))
        below = below[1:]
    if not below:
        raise ValueError(f"{source}: no rows of numbers below the header; add rows")
    numbers = np.array(below) + 1
    texts = [lines[i] for i in below]
    comma = _has_decimal_comma(texts, mark) if decimal is None else decimal == "comma"
    widths = (len(_cells(text, mark)) if '"' in text else text.count(mark) + 1 for text in texts)
    right = np.array([width == len(names) for width in widths])
    texts = list(itertools.compress(texts, right))
    stated = {name: unit for name, unit in zip(names, units, strict=True) if unit}
    return CsvTable(
        source, names, stated, numbers[right], numbers[~right], texts, mark, "," if comma else "."
    )


def split_unit(cell: str) -> tuple[str, str]:
    """Split a header cell such as ``Roll [deg]`` into name and unit, which may be empty."""
    found = _UNIT.fullmatch(cell)
    return (found[1], found[2]) if found and found[1] else (cell, "")


def is_number(cell: str) -> bool:
    """Return True for a decimal number with either decimal mark."""
    return _NUMBER.fullmatch(cell) is not None


def _decoded(data: bytes) -> str:
    """Decode UTF-8, UTF-16 with a byte order mark, or the Windows code page 1252."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16", errors="replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("cp1252", errors="replace")


def _header(lines: Sequence[str], source: str, given: str | None) -> tuple[int, list[str], str]:
    """Return the index of the last line above the rows, the cells of the header, and the delimiter."""
    comment, stated = "", given
    for i, line in enumerate(lines):
        text = line.strip().strip('"')
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
            return i, [cell or f"column {place + 1}" for place, cell in enumerate(cells)], mark
    raise ValueError(f"{source}: the file is empty; write a header line and rows of numbers")


def _cells(line: str, delimiter: str) -> list[str]:
    """Split a line into cells without blanks and quotation marks."""
    cells = next(csv.reader([line], delimiter=delimiter)) if '"' in line else line.split(delimiter)
    return [cell.strip() for cell in cells]


def _is_unit_row(cells: Sequence[str], width: int) -> bool:
    """Return True for a row without numbers and dates whose cells are short."""
    short = all(len(cell) < 12 and not re.search(r"\d{2}|^\d", cell) for cell in cells)
    return len(cells) == width and any(cells) and short


def _has_decimal_comma(texts: Sequence[str], delimiter: str) -> bool:
    """Return True if numbers contain commas and no points."""
    if delimiter == ",":
        return False
    cells = [cell for text in texts[:: max(1, len(texts) // 1000)] for cell in _cells(text, delimiter)]
    numbers = [cell for cell in cells if is_number(cell)]
    return any("," in cell for cell in numbers) and not any("." in cell for cell in numbers)


def _numbers(texts: Sequence[str], places: list[int], delimiter: str, decimal: str) -> Array:
    """Convert columns of lines to numbers, NaN for other cells, shape (n, places)."""
    found = np.full((len(texts), len(places)), np.nan)
    for start in range(0, len(texts), _PART):
        part = texts[start : start + _PART]
        lines = part if decimal == "." else [text.replace(decimal, ".") for text in part]
        try:
            found[start : start + _PART] = np.loadtxt(
                lines, delimiter=delimiter, comments=None, usecols=places, ndmin=2, quotechar='"'
            )
        except ValueError:
            for i, text in enumerate(part, start):
                cells = _cells(text, delimiter)
                numbers = [cells[place].replace(decimal, ".") for place in places]
                plain = [is_number(each) and "," not in each for each in numbers]
                found[i] = [float(x) if good else np.nan for x, good in zip(numbers, plain, strict=True)]
    return found


def _instant(text: str) -> np.datetime64:
    """Return the instant of a cell; NaT if it is none."""
    found = _INSTANT.fullmatch(text.replace(",", "."))
    with contextlib.suppress(ValueError, OverflowError):
        if text.isdigit():
            return np.datetime64(int(text), "ns")
        if found is not None:
            return np.datetime64(f"{found[1] or '1970-01-01'}T{found[2]}", "ns")
    return np.datetime64("NaT")
