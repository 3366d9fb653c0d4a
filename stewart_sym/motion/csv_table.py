"""CSV logs as columns of numbers: encoding, delimiter, decimal mark, header, and rows without numbers."""

import csv
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array, Flags
from ..io.toml_reader import opened

DELIMITERS = {"comma": ",", "semicolon": ";", "tab": "\t"}
DECIMALS = {"point": ".", "comma": ","}

# Number of lines that are converted together if some line of the file is no row of numbers.
_PART = 4096
_NUMBER = re.compile(r"[-+]?(\d+([.,]\d*)?|[.,]\d+)([eE][-+]?\d+)?")
_INSTANT = re.compile(r"(?:(\d{4}-\d\d-\d\d)[T ])?(\d\d:\d\d:\d\d(?:\.\d{1,9})?)(?:Z|[-+]\d\d:?\d\d)?")
_UNIT = re.compile(r"(.*?)\s*[\[(]\s*([^\[\]()]*?)\s*[\])]")


Lines = NDArray[np.int64]
"""Line numbers, from 1."""


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

    def columns(self, names: Sequence[str], clock: str | None = None) -> tuple[dict[str, Array], Flags]:
        """Convert some columns to numbers.

        Parameters
        ----------
        names : sequence of str
            Names of ``header``.
        clock : str, optional
            Column of dates, times of day, or nanoseconds, which becomes seconds since the first row.

        Returns
        -------
        dict of str to ndarray, shape (m,)
            Numbers of the good rows.
        good : ndarray of bool, shape (n,)
            True for rows whose cells are all finite numbers.
        """
        places = [self.header.index(name) for name in names if name != clock]
        values = _numbers(self._texts, len(self.header), places, self._delimiter, self._decimal)
        found = dict(zip([name for name in names if name != clock], values.T, strict=True))
        if clock is not None:
            place = self.header.index(clock)
            found[clock] = _seconds([_cells(text, self._delimiter)[place:][:1] for text in self._texts])
        good = np.logical_and.reduce([np.isfinite(column) for column in found.values()])
        return {name: column[good] for name, column in found.items()}, good

    def first(self, name: str) -> str:
        """Return the cell of a column in the first row."""
        cells = _cells(self._texts[0], self._delimiter) if len(self._texts) else []
        return cells[self.header.index(name)] if len(cells) == len(self.header) else ""


def read_table(
    source: str,
    delimiter: str | None = None,
    decimal: str | None = None,
    what: str = "trajectory",
) -> CsvTable:
    """Read the text of a CSV file, and find its header.

    Parameters
    ----------
    source : str
        File with a header line. Blank lines, comments (``#`` or ``%``), and a line such as ``sep=;`` may be
        above it; without it, the last comment above the numbers is the header. A row of units may follow.
    delimiter : {"comma", "semicolon", "tab"}, optional
        Delimiter; by default the mark that divides the header into most names.
    decimal : {"point", "comma"}, optional
        Decimal mark; by default a comma if numbers contain commas, no points, and other delimiters.
    what : str
        Kind of the file in messages.

    Raises
    ------
    ValueError
        If the file cannot be read, or has no header or no rows.
    """
    with opened(source, what) as stream:
        text = _decoded(stream.read())
    lines = text.splitlines()
    place, header, mark = _header(lines, source, None if delimiter is None else DELIMITERS[delimiter])
    names, units = zip(*map(split_unit, header), strict=True)
    below = [i for i in range(place + 1, len(lines)) if lines[i].strip(' \t;,"') and lines[i][0] not in "#%"]
    stated = dict(zip(names, units, strict=True))
    if below and (row := _cells(lines[below[0]], mark)) and _is_unit_row(row, len(names)):
        stated = {
            name: unit or cell.strip("[]() ") for (name, unit), cell in zip(stated.items(), row, strict=True)
        }
        below = below[1:]
    if not below:
        raise ValueError(f"{source}: no rows of numbers below the header; add rows")
    numbers = np.array(below) + 1
    texts = [lines[i] for i in below]
    comma = _has_decimal_comma(texts, mark) if decimal is None else decimal == "comma"
    right = np.array([_count(text, mark) == len(names) for text in texts])
    return CsvTable(
        source,
        names,
        {name: unit for name, unit in stated.items() if unit},
        numbers[right],
        numbers[~right],
        texts if right.all() else [text for text, good in zip(texts, right, strict=True) if good],
        mark,
        "," if comma else ".",
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
            mark = stated or max(DELIMITERS.values(), key=(comment if is_number_row(line) else line).count)
            cells = _cells(line, mark)
            if comment and all(map(is_number, cells)) and len(_cells(comment, mark)) == len(cells):
                return i - 1, _cells(comment, mark), mark
            if all(map(is_number, cells)):
                raise ValueError(
                    f"{source}: line {i + 1}: no header line; name the columns in a line above the numbers"
                )
            return i, _named(cells), mark
    raise ValueError(f"{source}: the file is empty; write a header line and rows of numbers")


def is_number_row(line: str) -> bool:
    """Return True if a line consists of numbers and delimiters."""
    return all(not cell or is_number(cell) for cell in re.split(r"[\s;]+|,(?=\s|[-+\d])", line.strip()))


def _named(cells: list[str]) -> list[str]:
    """Return the cells of a header, with names for empty ones."""
    return [cell or f"column {i + 1}" for i, cell in enumerate(cells)]


def _cells(line: str, delimiter: str) -> list[str]:
    cells = next(csv.reader([line], delimiter=delimiter)) if '"' in line else line.split(delimiter)
    return [cell.strip() for cell in cells]


def _count(line: str, delimiter: str) -> int:
    return len(_cells(line, delimiter)) if '"' in line else line.count(delimiter) + 1


def _is_unit_row(cells: Sequence[str], width: int) -> bool:
    """Return True for a row without numbers and dates whose cells are short."""
    return (
        len(cells) == width
        and any(cells)
        and all(len(cell) < 12 and not re.search(r"\d{2}|^\d", cell) for cell in cells)
    )


def _has_decimal_comma(texts: Sequence[str], delimiter: str) -> bool:
    """Return True if numbers contain commas and no points."""
    if delimiter == ",":
        return False
    cells = [cell for text in texts[:: max(1, len(texts) // 1000)] for cell in _cells(text, delimiter)]
    numbers = [cell for cell in cells if is_number(cell)]
    return any("," in cell for cell in numbers) and not any("." in cell for cell in numbers)


def _numbers(texts: Sequence[str], width: int, places: list[int], delimiter: str, decimal: str) -> Array:
    """Convert columns of lines to numbers, NaN for other cells, shape (n, places)."""
    mended: Callable[[str], str] = str if decimal == "." else (lambda text: text.replace(",", "."))

    def converted(part: Sequence[str]) -> Array:
        lines = part if decimal == "." else [mended(text) for text in part]
        columns = None if places == list(range(width)) else places
        return np.loadtxt(lines, delimiter=delimiter, comments=None, usecols=columns, ndmin=2, quotechar='"')

    if not texts:
        return np.empty((0, len(places)))
    try:
        return converted(texts)
    except ValueError:
        found = np.full((len(texts), len(places)), np.nan)
    for start in range(0, len(texts), _PART):
        part = texts[start : start + _PART]
        try:
            found[start : start + len(part)] = converted(part)
        except ValueError:
            for i, text in enumerate(part, start):
                cells = _cells(text, delimiter)
                numbers = [mended(cells[place]) for place in places]
                found[i] = [float(each) if is_number(each) else np.nan for each in numbers]
    return found


def _seconds(cells: Sequence[Sequence[str]]) -> Array:
    """Convert dates (ISO 8601), times of day, or integers of nanoseconds to seconds since the first one."""
    instants = np.array(
        [_instant(cell[0]) if cell else np.datetime64("NaT") for cell in cells], "datetime64[ns]"
    )
    valid = instants[~np.isnat(instants)]
    since = (instants - valid[0]) / np.timedelta64(1, "ns") if valid.size else np.full(len(instants), np.nan)
    return np.where(np.isnat(instants), np.nan, since) / 1e9


def _instant(text: str) -> np.datetime64:
    """Return the instant of a cell; NaT if it is none."""
    if text.isdigit():
        return np.datetime64(int(text), "ns")
    found = _INSTANT.fullmatch(text.replace(",", "."))
    if found is None:
        return np.datetime64("NaT")
    day, clock = found[1] or "1970-01-01", found[2]
    try:
        return np.datetime64(f"{day}T{clock}", "ns")
    except ValueError:
        return np.datetime64("NaT")
