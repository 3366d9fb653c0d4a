"""CSV logs as named columns of numbers: delimiter, decimal comma, names and units as given or detected.

Every error is one line that names the file and the row; the header is row 1 where the file begins with it.
"""

from __future__ import annotations

import array
import csv
import io
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import permutations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .checks import option, shown

if TYPE_CHECKING:
    import _csv

Array = NDArray[np.float64]

LENGTH_UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
ANGLE_UNITS = {"rad": 1.0, "deg": math.pi / 180.0}
TIME_UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6}
DELIMITERS = {"comma": ",", "semicolon": ";", "tab": "\t"}
DECIMALS = {"point": ".", "comma": ","}
EULER_ORDERS = tuple("".join(order) for order in permutations("xyz"))


@dataclass(frozen=True)
class LogFormat:
    """How a log is written.

    columns: name that is expected -> name in the header; with any given, other columns are skipped.
    length_unit, angle_unit, time_unit: of ``LENGTH_UNITS``, ``ANGLE_UNITS``, ``TIME_UNITS``; rates are per
    second. delimiter, decimal: of ``DELIMITERS``, ``DECIMALS``; None: detected. euler_order: of the rotations
    multiplied, "zyx" for R = Rz Ry Rx, (38).

    Raises ValueError naming the argument.
    """

    columns: Mapping[str, str] = field(default_factory=dict)
    length_unit: str = "m"
    angle_unit: str = "rad"
    time_unit: str = "s"
    delimiter: str | None = None
    decimal: str | None = None
    euler_order: str = "zyx"

    def __post_init__(self) -> None:
        """Check every option."""
        if not isinstance(self.columns, Mapping):
            raise ValueError(f"columns: expected a mapping of names, got {shown(self.columns)}")
        option(self.length_unit, tuple(LENGTH_UNITS), "length_unit")
        option(self.angle_unit, tuple(ANGLE_UNITS), "angle_unit")
        option(self.time_unit, tuple(TIME_UNITS), "time_unit")
        option(self.euler_order, EULER_ORDERS, "euler_order")
        if self.delimiter is not None:
            option(self.delimiter, tuple(DELIMITERS), "delimiter")
        if self.decimal is not None:
            option(self.decimal, tuple(DECIMALS), "decimal")


def read_columns(
    text: str, source: str, check_header: Callable[[list[str], str], None], form: LogFormat
) -> tuple[dict[str, Array], Sequence[int]]:
    """Return the columns of a CSV text by name, as written but for time in s, and the rows where they stand.

    check_header: rejects a header of expected names, given the name of the file.
    """
    delimiter, decimal = _marks(text, form)
    stream = _stream(text)
    reader = csv.reader(stream, delimiter=delimiter, skipinitialspace=True)
    try:
        cells = next((cells for cells in reader if any(cell.strip() for cell in cells)), None)
        if cells is None:
            raise ValueError(f"{source}: the file is empty, expected a header line that names the columns")
        header = _expected_names([cell.strip() for cell in cells], source, form)
        check_header([name for name in header if name is not None], source)
        table = _plain_table(stream, text, reader.line_num, header, delimiter, decimal)
        rows: Sequence[int] = range(reader.line_num + 1, reader.line_num + 1 + len(table))
        if not len(table):
            stream.seek(0)
            above = reader.line_num
            reader = csv.reader(stream, delimiter=delimiter, skipinitialspace=True)
            while reader.line_num < above:
                next(reader)
            table, rows = _table(reader, header, source, decimal)
    except csv.Error as error:
        raise ValueError(f"{source}: row {reader.line_num}: not valid CSV: {error}") from None
    if not rows:
        raise ValueError(f"{source}: expected rows of numbers below the header, got none")
    columns = {name: column for name, column in zip(header, table.T, strict=True) if name is not None}
    columns["time"] = columns["time"] * TIME_UNITS[form.time_unit]
    late = np.flatnonzero(np.diff(columns["time"]) <= 0.0)
    if late.size:
        i = int(late[0])
        before, after = columns["time"][i], columns["time"][i + 1]
        raise ValueError(
            f"{source}: row {rows[i + 1]}: time: expected increasing times, got {after:g} after {before:g}"
        )
    return columns, rows


def _stream(text: str) -> io.TextIOWrapper:
    """A text to be read by lines, line ends as they are; ``StringIO`` takes four times the room."""
    return io.TextIOWrapper(io.BytesIO(text.encode()), encoding="utf-8", newline="")


def _marks(text: str, form: LogFormat) -> tuple[str, str]:
    """Delimiter and decimal mark: that which cuts the header into most names, and a comma where it can be."""
    header, _, rest = text.lstrip().partition("\n")
    delimiter = max(DELIMITERS.values(), key=header.count)
    if form.delimiter is not None:
        delimiter = DELIMITERS[form.delimiter]
    if form.decimal is not None:
        return delimiter, DECIMALS[form.decimal]
    return delimiter, "," if delimiter != "," and "," in rest and "." not in rest else "."


def _expected_names(header: list[str], source: str, form: LogFormat) -> list[str | None]:
    """Names of the columns as expected; None for one that is skipped."""
    if not form.columns:
        return [*header]
    for name, given in form.columns.items():
        if given not in header:
            near = ", ".join(cell[:40] for cell in header[:12])
            raise ValueError(f"{source}: expected a column {given!r} for {name}, got {near}")
    names = {given: name for name, given in form.columns.items()}
    return [names.get(cell) for cell in header]


def _plain_table(
    stream: io.TextIOBase, text: str, lines: int, header: list[str | None], delimiter: str, decimal: str
) -> Array:
    """Numbers below the header's last line, (n, columns), where all is in order; else (0, columns).

    stream: of the text, read up to there. A tenth of the time that ``_table`` takes, which names what is not
    in order.
    """
    none = np.empty((0, len(header)))
    start = 0
    for _ in range(lines):
        start = text.find("\n", start) + 1 or len(text)
    if not text[start:].strip():
        return none
    used = [i for i, name in enumerate(header) if name is not None]
    try:
        found = np.loadtxt(
            stream if decimal == "." else _stream(text[start:].replace(decimal, ".")),
            delimiter=delimiter,
            comments=None,
            usecols=used if len(used) < len(header) else None,
            ndmin=2,
        )
    except ValueError:
        return none
    count = text.count("\n", start) + (not text.endswith("\n"))
    if found.shape != (count, len(used)) or not np.isfinite(found).all():
        return none
    if len(used) == len(header):
        return found
    table = np.full((count, len(header)), np.nan)
    table[:, used] = found
    return table


def _table(
    reader: _csv.Reader, header: list[str | None], source: str, decimal: str
) -> tuple[Array, tuple[int, ...]]:
    """Numbers below the header, (n, columns), and their rows; skipped columns are NaN."""
    # Row after row and as numbers at once: the cells of a long file would take ten times its size.
    numbers, rows = array.array("d"), array.array("q")
    for cells in reader:
        if not any(cell.strip() for cell in cells):
            continue
        rows.append(reader.line_num)
        numbers.extend(_row(cells, header, f"{source}: row {reader.line_num}: ", decimal))
    return np.array(numbers).reshape(len(rows), len(header)), tuple(rows)


def _row(cells: list[str], header: list[str | None], where: str, decimal: str) -> list[float]:
    if len(cells) != len(header):
        raise ValueError(f"{where}expected {len(header)} columns, got {len(cells)}")
    return [
        _cell(cell.strip(), where + name, decimal) if name is not None else math.nan
        for cell, name in zip(cells, header, strict=True)
    ]


def _cell(text: str, where: str, decimal: str) -> float:
    try:
        found = float(text.replace(decimal, ".") if decimal != "." else text) if "_" not in text else math.nan
    except ValueError:
        found = math.nan
    if not math.isfinite(found):
        raise ValueError(f"{where}: expected a finite number, got {text[:40]!r}")
    return found
