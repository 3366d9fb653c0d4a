"""CSV logs as named columns of numbers: delimiter, decimal comma, names and units as given or detected.

Every error is one line that names the file and the row; the header is row 1 where the file begins with it.
"""

from __future__ import annotations

import array
import codecs
import csv
import io
import itertools
import math
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, BinaryIO

import numpy as np

from ..io.arguments import option, shown
from ..io.array_types import Array
from ..io.instants import time_text
from ..io.progress import Progress, silent
from ..io.tables import table_as_utf8
from .noise_level import LogWarning

if TYPE_CHECKING:
    import _csv

LENGTH_UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
ANGLE_UNITS = {"rad": 1.0, "deg": math.pi / 180.0}
TIME_UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6}
DELIMITERS = {"comma": ",", "semicolon": ";", "tab": "\t"}
DECIMALS = {"point": ".", "comma": ","}
LENGTHS = ("absolute", "relative")
"""Leg lengths by themselves, and less those at the home pose."""
EULER_ORDERS = tuple("".join(order) for order in itertools.permutations("xyz"))

# Rows and bytes that are read at a time.
_ROWS, _CHUNK = 4096, 1 << 20
# Bytes at a file's end that show how its numbers are written.
_TAIL = 1 << 16


class HeaderError(ValueError):
    """A header that is not the expected one; ``header``: its names as written."""

    def __init__(self, message: str, header: Sequence[str]) -> None:
        """Keep both."""
        super().__init__(message)
        self.header = tuple(header)


@dataclass(frozen=True)
class LogFormat:
    """How a log is written.

    Attributes
    ----------
    columns : dict, optional
        Name that is expected -> name in the header; with any given, other columns are skipped.
    length_unit, angle_unit, time_unit : str, optional
        Of ``LENGTH_UNITS``, ``ANGLE_UNITS``, ``TIME_UNITS``; rates are per second.
    delimiter, decimal : str, optional
        Of ``DELIMITERS``, ``DECIMALS``; None: detected.
    euler_order : str, optional
        Of the rotations multiplied, "zyx" for R = Rz Ry Rx, (38); rates are those of its angles.
    lengths : str, optional
        Leg lengths: of ``LENGTHS``; relative ones are less those of the robot's home pose.

    Raises
    ------
    ValueError
        Naming the argument.
    """

    columns: Mapping[str, str] = field(default_factory=dict)
    length_unit: str = "m"
    angle_unit: str = "rad"
    time_unit: str = "s"
    delimiter: str | None = None
    decimal: str | None = None
    euler_order: str = "zyx"
    lengths: str = "absolute"

    def __post_init__(self) -> None:
        """Check every option."""
        texts = [*self.columns, *self.columns.values()] if isinstance(self.columns, Mapping) else [None]
        if not all(isinstance(each, str) for each in texts):
            raise ValueError(f"columns: expected a mapping of names, got {shown(self.columns)}")
        option(self.length_unit, tuple(LENGTH_UNITS), "length_unit")
        option(self.angle_unit, tuple(ANGLE_UNITS), "angle_unit")
        option(self.time_unit, tuple(TIME_UNITS), "time_unit")
        option(self.euler_order, EULER_ORDERS, "euler_order")
        option(self.lengths, LENGTHS, "lengths")
        if self.delimiter is not None:
            option(self.delimiter, tuple(DELIMITERS), "delimiter")
        if self.decimal is not None:
            option(self.decimal, tuple(DECIMALS), "decimal")


def read_columns(
    stream: BinaryIO,
    source: str,
    check_header: Callable[[list[str], str], None],
    form: LogFormat,
    progress: Progress = silent,
) -> tuple[dict[str, Array], Sequence[int]]:
    """Return the columns of a CSV file by name, as written but for time in s, and the rows where they stand.

    stream: the file, which is read in parts, so that the numbers alone take room. check_header: rejects a
    header of expected names, given the name of the file. progress: given the share of the file that is read.
    """
    with table_as_utf8(stream, source) as stream:
        size = max(1, stream.seek(0, io.SEEK_END))
        stream.seek(0)

        def read() -> None:
            progress(f"reading {source}", min(1.0, stream.tell() / size))

        delimiter, decimal = _marks(stream, form)
        stream.seek(0)
        lines = io.TextIOWrapper(stream, encoding="utf-8-sig", newline="")
        try:
            columns, rows = _columns(lines, source, check_header, form, delimiter, decimal, read)
        finally:
            lines.detach()
        if _cut_off(stream, delimiter, decimal):
            warnings.warn(
                f"{source}: row {rows[-1]}: expected as many decimals as above or a line ending: "
                "the file may be cut off",
                LogWarning,
                stacklevel=4,
            )
    if not rows:
        raise ValueError(f"{source}: expected rows of numbers below the header, got none")
    # Divided, times are the nearest doubles of what is written.
    columns["time"] /= round(1.0 / TIME_UNITS[form.time_unit])
    late = np.flatnonzero(np.diff(columns["time"]) <= 0.0)
    if late.size:
        i = int(late[0])
        before, after = map(time_text, columns["time"][i : i + 2])
        raise ValueError(
            f"{source}: row {rows[i + 1]}: time: expected increasing times, got {after} after {before}"
        )
    return columns, rows


def need_columns(header: Sequence[str], columns: Sequence[str], source: str) -> None:
    """Reject a header that lacks one of the columns."""
    for column in columns:
        if column not in header:
            raise ValueError(f"{source}: missing column {column}")


def _columns(
    lines: Iterator[str],
    source: str,
    check_header: Callable[[list[str], str], None],
    form: LogFormat,
    delimiter: str,
    decimal: str,
    read: Callable[[], None],
) -> tuple[dict[str, Array], Sequence[int]]:
    """Columns of the lines by name, and their rows; ``read`` is called now and then."""
    reader = csv.reader(lines, delimiter=delimiter, skipinitialspace=True)
    above = 0
    try:
        cells = next((cells for cells in reader if any(cell.strip() for cell in cells)), None)
        if cells is None:
            raise ValueError(f"{source}: the file is empty, expected a header line that names the columns")
        written = [cell.strip() for cell in cells]
        if written[0].startswith(("{", "[", "<")):
            raise ValueError(f"{source}: expected a CSV file with a header line, got {shown(written[0])}")
        try:
            header = _expected_names(written, source, form)
            check_header([name for name in header if name is not None], source)
        except ValueError as error:
            raise HeaderError(str(error), written) from None
        used = [i for i, name in enumerate(header) if name is not None]
        # As numbers at once: the cells of a long file would take ten times its size.
        numbers = [array.array("d") for _ in used]
        first = reader.line_num + 1
        while part := list(itertools.islice(lines, _ROWS)):
            table = _plain_table(part, len(header), used, delimiter, decimal)
            if table is None:
                break
            read()
            for column, more in zip(numbers, table.T, strict=True):
                column.frombytes(more.tobytes())
        rows: Sequence[int] = range(first, first + len(numbers[0]))
        if part:
            above = first + len(rows) - 1
            reader = csv.reader(itertools.chain(part, lines), delimiter=delimiter, skipinitialspace=True)
            rows = array.array("q", rows)
            _add_rows(reader, above, header, source, decimal, numbers, rows, read)
    except csv.Error as error:
        raise ValueError(f"{source}: row {above + reader.line_num}: not valid CSV: {error}") from None
    names = (name for name in header if name is not None)
    return {name: np.frombuffer(column) for name, column in zip(names, numbers, strict=True)}, rows


def _cut_off(stream: BinaryIO, delimiter: str, decimal: str) -> bool:
    """Whether the file ends within its last number: only where a fixed number of decimals proves it.

    A program that writes two or more decimals, as many in each row and zeros at their end too, always does:
    fewer of them, and no line ending, are not what it wrote.
    """
    stream.seek(-min(_TAIL, stream.seek(0, io.SEEK_END)), io.SEEK_END)
    *above, last = stream.read().decode(errors="replace").splitlines(keepends=True)
    decimals = [line.rpartition(delimiter)[2].strip().partition(decimal)[2] for line in (*above[1:], last)]
    *fixed, left = decimals
    widths = {len(digits) for digits in fixed}
    return (
        not last.endswith(("\n", "\r"))
        and len(widths) == 1
        and max(widths) >= 2
        and len(left) < max(widths)
        and any(digits.isdecimal() and digits.endswith("0") for digits in fixed)
    )


def _marks(stream: BinaryIO, form: LogFormat) -> tuple[str, str]:
    """Delimiter and decimal mark: that which cuts the header into most names, and a comma where it can be."""
    lines = (line.removeprefix(codecs.BOM_UTF8).strip() for line in stream)
    header = next(filter(None, lines), b"").decode()
    delimiter = max(DELIMITERS.values(), key=header.count)
    if form.delimiter is not None:
        delimiter = DELIMITERS[form.delimiter]
    if form.decimal is not None:
        return delimiter, DECIMALS[form.decimal]
    comma = False
    while delimiter != "," and (chunk := stream.read(_CHUNK)):
        if b"." in chunk:
            return delimiter, "."
        comma = comma or b"," in chunk
    return delimiter, "," if comma else "."


def _expected_names(header: list[str], source: str, form: LogFormat) -> list[str | None]:
    """Names of the columns as expected; None for one that is skipped."""
    if not form.columns:
        return [*header]
    for name, given in form.columns.items():
        of = [each for each, other in form.columns.items() if other == given]
        if len(of) > 1:
            raise ValueError(f"columns: header {shown(given)} is given for {' and '.join(of)}")
        if given not in header:
            near = ", ".join(cell[:40] for cell in header[:12])
            raise ValueError(f"{source}: expected a column {given!r} for {name}, got {near}")
    names = {given: name for name, given in form.columns.items()}
    return [names.get(cell) for cell in header]


def _plain_table(lines: list[str], width: int, used: list[int], delimiter: str, decimal: str) -> Array | None:
    """Numbers of the used columns, (n, used), where all ``width`` columns are in order; else None.

    A tenth of the time that ``_add_rows`` takes, which names what is not in order.
    """
    if not lines[0].strip():
        return None
    try:
        found = np.loadtxt(
            lines if decimal == "." else [line.replace(decimal, ".") for line in lines],
            delimiter=delimiter,
            comments=None,
            usecols=used if len(used) < width else None,
            ndmin=2,
        )
    except ValueError:
        return None
    return found if found.shape == (len(lines), len(used)) and np.isfinite(found).all() else None


def _add_rows(
    reader: _csv.Reader,
    above: int,
    header: list[str | None],
    source: str,
    decimal: str,
    numbers: list[array.array[float]],
    rows: array.array[int],
    read: Callable[[], None],
) -> None:
    """Add the numbers of the used columns, row after row, and the rows; ``above``: lines before them."""
    for cells in reader:
        if not any(cell.strip() for cell in cells):
            continue
        row = above + reader.line_num
        rows.append(row)
        if len(rows) % _ROWS == 0:
            read()
        for column, value in zip(
            numbers, _row(cells, header, f"{source}: row {row}: ", decimal), strict=True
        ):
            column.append(value)


def _row(cells: list[str], header: list[str | None], where: str, decimal: str) -> list[float]:
    if len(cells) != len(header):
        cause = ""
        if decimal == "." and len(header) < len(cells) <= 2 * len(header):
            cause = ": are commas its decimal marks too? then columns need another delimiter, or quotes"
        raise ValueError(f"{where}expected {len(header)} columns, got {len(cells)}{cause}")
    return [
        _cell(cell.strip(), where + name, decimal)
        for cell, name in zip(cells, header, strict=True)
        if name is not None
    ]


def _cell(text: str, where: str, decimal: str) -> float:
    try:
        found = float(text.replace(decimal, ".") if decimal != "." else text) if "_" not in text else math.nan
    except ValueError:
        found = math.nan
    if not math.isfinite(found):
        cause = (
            ": is its decimal mark a comma (LogFormat(decimal='comma'))?"
            if "," in text and decimal == "."
            else ""
        )
        raise ValueError(f"{where}: expected a finite number, got {text[:40]!r}{cause}")
    return found
