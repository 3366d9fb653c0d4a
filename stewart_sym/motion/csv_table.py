"""CSV logs as columns of numbers: encoding, delimiter, decimal mark, header, and rows without numbers."""

import contextlib
import csv
import itertools
import re
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array
from ..io.toml_reader import opened

DELIMITERS = {"comma": ",", "semicolon": ";", "tab": "\t"}
DECIMALS = {"point": ".", "comma": ","}

# Numbers of characters that are searched for the header, and that are converted together.
_HEAD, _BLOCK = 1 << 20, 1 << 18
# Largest integer, and largest power of ten, that a double represents without rounding error.
_MOST_EXACT, _POWERS = 2**53, 10.0 ** np.arange(23)
_DIGITS = b"0123456789+-"
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
Instants = NDArray[np.datetime64]
"""Dates, or times of day on 1970-01-01."""


@dataclass(frozen=True, eq=False)
class CsvTable:
    """Columns of a file as written, with the line of each row and of each line below the header that is none.

    Units come from brackets in the header, or from a row of units.
    """

    source: str
    header: tuple[str, ...]
    units: dict[str, str]
    lines: Lines
    dropped: Lines
    _blocks: Sequence[Array | list[str]]
    _delimiter: str
    _decimal: str

    def numbers(self, names: Sequence[str]) -> Array:
        """Return the numbers of columns of ``header``, shape (n, len(names)), NaN for other cells."""
        places = [self.header.index(name) for name in names]
        parts = [_numbers(block, places, self._delimiter, self._decimal) for block in self._blocks]
        return np.concatenate([np.zeros((0, len(places))), *parts])

    def cells(self, name: str) -> list[str]:
        """Return the texts of a column of ``header``, length n; blocks of plain numbers have no texts."""
        place = self.header.index(name)
        rows = itertools.chain(*([""] * len(x) if isinstance(x, np.ndarray) else x for x in self._blocks))
        return [_cells(row, self._delimiter)[place] if row else "" for row in rows]

    def has_instants(self, name: str) -> bool:
        """Return True if a column begins with a date, a time of day, or nanoseconds since 1970."""
        first = next((block for block in self._blocks if len(block)), "")
        cell = _cells(first[0], self._delimiter)[self.header.index(name)] if isinstance(first, list) else ""
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
    above = text[:_HEAD].split("\n")
    place, header, mark = _header(above, source, None if delimiter is None else DELIMITERS[delimiter])
    names, stated_units = zip(*map(split_unit, header), strict=True)
    below = next((i for i in range(place + 1, len(above)) if _is_row(above[i])), None)
    stated = dict(zip(names, stated_units, strict=True))
    if below is not None and (row := _cells(above[below], mark)) and _is_unit_row(row, len(names)):
        stated = {
            name: unit or cell.strip("[]() ") for (name, unit), cell in zip(stated.items(), row, strict=True)
        }
        place = below
    blocks = list(_blocks(text, place + 1))
    comma = _has_decimal_comma(blocks, mark) if decimal is None else decimal == "comma"
    point = "," if comma else "."
    numbers = np.cumsum([place + 2, *(block.count("\n") + 1 for block in blocks)])
    rows = [_rows(block, int(i), mark, point, len(names)) for i, block in zip(numbers, blocks, strict=False)]
    lines = np.concatenate([np.zeros(0, int), *(row.lines for row in rows)])
    dropped = np.concatenate([np.zeros(0, int), *(row.dropped for row in rows)])
    if not len(lines) + len(dropped):
        raise ValueError(f"{source}: no rows of numbers below the header; add rows")
    units = {name: unit for name, unit in stated.items() if unit}
    return CsvTable(source, names, units, lines, dropped, [row.cells for row in rows], mark, point)


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
            if not all(cell.isprintable() for cell in cells):
                raise ValueError(f"{source}: line {i + 1}: the header is not text; save the file as CSV")
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


def _is_row(line: str) -> bool:
    """Return True for a line that is not blank and no comment."""
    return bool(line.strip(' \t;,"')) and line[0] not in "#%"


def _blocks(text: str, first: int) -> Iterator[str]:
    """Yield lines from the line with index ``first``, in blocks without the last line feed."""
    start = 0
    for _ in range(first):
        start = text.find("\n", start) + 1 or len(text)
    while start < len(text):
        end = text.find("\n", start + _BLOCK)
        end = len(text) if end < 0 else end
        yield text[start:end].rstrip("\n") if end == len(text) else text[start:end]
        start = end + 1


def _has_decimal_comma(blocks: Sequence[str], delimiter: str) -> bool:
    """Return True if numbers contain commas and no points."""
    if delimiter == ",":
        return False
    some = [line for block in blocks[:: max(1, len(blocks) // 16)] for line in block.split("\n")]
    cells = [cell for line in some[:: max(1, len(some) // 1000)] for cell in _cells(line, delimiter)]
    numbers = [cell for cell in cells if is_number(cell)]
    return any("," in cell for cell in numbers) and not any("." in cell for cell in numbers)


class _Rows(NamedTuple):
    """Rows of a block: numbers of their lines and of other lines, and numbers or texts of the rows."""

    lines: Lines
    dropped: Lines
    cells: Array | list[str]


def _rows(block: str, first: int, delimiter: str, decimal: str, width: int) -> _Rows:
    """Return the rows of a block, whose first line has the number ``first``."""
    numbers = _plain_numbers(block, delimiter, decimal, width)
    if numbers is not None:
        return _Rows(first + np.arange(len(numbers)), np.zeros(0, int), numbers)
    texts = [(first + i, line) for i, line in enumerate(block.split("\n")) if _is_row(line)]
    right = np.array([len(_cells(line, delimiter)) == width for _, line in texts], dtype=bool)
    lines = np.array([number for number, _ in texts], dtype=int)
    return _Rows(lines[right], lines[~right], [line for _, line in itertools.compress(texts, right)])


def _plain_numbers(block: str, delimiter: str, decimal: str, width: int) -> Array | None:
    """Convert decimal numbers in rows with the same marks, shape (n, width); None for other rows.

    A number is an integer divided by a power of ten. Both are exact, so that the quotient is the nearest
    double.
    """
    text, count = block.encode() + b"\n", block.count("\n") + 1
    marks = text[: text.index(b"\n") + 1].translate(None, _DIGITS)
    cells = marks.decode().rstrip("\n").split(delimiter)
    known = len(cells) == width and set(cells) <= {"", decimal}
    if not known or text.translate(None, _DIGITS) != marks * count:
        return None
    digits = text.translate(bytes.maketrans(f"{delimiter}\n".encode(), b",,"), decimal.encode())
    if any(empty in b"," + digits for empty in (b",,", b"-,", b"+,")):
        return None
    with warnings.catch_warnings(action="error", category=DeprecationWarning):
        try:
            integers = np.fromstring(digits, np.int64, sep=",")
        except (DeprecationWarning, ValueError):
            return None
    if integers.size != count * width or np.abs(integers).max() >= _MOST_EXACT:
        return None
    is_mark = np.frombuffer(text.translate(bytes(i in marks for i in range(256))), bool)
    length = np.diff(np.flatnonzero(is_mark).reshape(count, -1), prepend=0)
    ends = np.cumsum([len(cell) + 1 for cell in cells]) - 1
    decimals = np.where([bool(cell) for cell in cells], length[:, ends] - 1, 0)
    if decimals.max() >= len(_POWERS):
        return None
    return np.asarray(integers.reshape(count, width) / _POWERS[decimals])


def _numbers(block: Array | list[str], places: list[int], delimiter: str, decimal: str) -> Array:
    """Return columns of numbers of a block, NaN for other cells, shape (n, places)."""
    if isinstance(block, np.ndarray):
        return block[:, places]
    if not block:
        return np.zeros((0, len(places)))
    lines = block if decimal == "." else [text.replace(decimal, ".") for text in block]
    try:
        return np.loadtxt(lines, delimiter=delimiter, comments=None, usecols=places, ndmin=2, quotechar='"')
    except ValueError:
        found = np.full((len(block), len(places)), np.nan)
        for i, text in enumerate(block):
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
