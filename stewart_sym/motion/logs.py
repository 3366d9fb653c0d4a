"""CSV logs as named columns of numbers: delimiter, decimal comma, names and units as given or detected.

Every error is one line that names the file and the line.
"""

from __future__ import annotations

import array
import contextlib
import csv
import dataclasses
import io
import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, BinaryIO, NamedTuple, Self

import numpy as np

from ..io.arguments import option, shown
from ..io.array_types import Array
from ..io.error_policy import warn
from ..io.progress import Progress, silent
from .noise_level import TrajectoryWarning
from .sample_times import time_text
from .text.clock import READ, Clock, instant
from .text.encoding import table_as_utf8
from .text.head import MARKS, Head, is_value, read_head, without_row
from .text.unit_row import ANGLE_UNITS, LENGTH_UNITS, TIME_UNITS, UNITS, units_of

DELIMITERS = dict(zip(("comma", "semicolon", "tab"), MARKS, strict=True))
DECIMALS = {"point": ".", "comma": ","}
LENGTHS = ("absolute", "relative")
"""Leg lengths: absolute, or relative to the lengths at the home pose."""
_SI = {"length_unit": "m", "angle_unit": "rad", "time_unit": "s"}
EULER_ORDERS = tuple("".join(order) for order in itertools.permutations("xyz"))

# Rows and bytes that are read at a time.
_ROWS, _CHUNK = 4096, 1 << 20
# Bytes at a file's end that show how its numbers are written.
_TAIL = 1 << 16


class HeaderError(ValueError):
    """A header that is not the expected one; ``header``: its names as written."""

    def __init__(self, message: str, header: Sequence[str]) -> None:
        super().__init__(message)
        self.header = tuple(header)


@dataclass(frozen=True)
class TrajectoryFormat:
    """Format of a log: columns, units, delimiter, and Euler angles.

    Attributes
    ----------
    columns : dict, optional
        Names in the header by the expected names. If any are given, other columns are ignored.
    length_unit, angle_unit, time_unit : str, optional
        Units: "m", "cm", "mm", or "in"; "rad" or "deg"; "s", "ms", or "us". Rates are per second. None: the
        units in the row below the header, otherwise m, rad, and s.
    delimiter : {"comma", "semicolon", "tab"}, optional
        Delimiter of columns. None: detected.
    decimal : {"point", "comma"}, optional
        Decimal separator. None: detected.
    euler_order : str, optional
        Order of rotations, for example "zyx" for R = Rz Ry Rx, (38). Rates are time derivatives of these
        angles. None: the order of the robot, or "zyx" if no robot is given.
    length_mode : {"absolute", "relative"}, optional
        Leg lengths, absolute or relative to the home pose of the robot. None: the mode of the robot, or
        "absolute" if no robot is given.

    Raises
    ------
    ValueError
        If an argument is invalid. The message names it.
    """

    columns: Mapping[str, str] = field(default_factory=dict)
    length_unit: str | None = None
    angle_unit: str | None = None
    time_unit: str | None = None
    delimiter: str | None = None
    decimal: str | None = None
    euler_order: str | None = None
    length_mode: str | None = None

    def __post_init__(self) -> None:
        texts = [*self.columns, *self.columns.values()] if isinstance(self.columns, Mapping) else [None]
        if not all(isinstance(each, str) for each in texts):
            raise ValueError(f"columns: expected a mapping of names, got {shown(self.columns)}")
        choices: dict[str, Iterable[str]] = {name: UNITS[name] for name in _SI}
        choices |= {"delimiter": DELIMITERS, "decimal": DECIMALS}
        choices |= {"euler_order": EULER_ORDERS, "length_mode": LENGTHS}
        for name, known in choices.items():
            if getattr(self, name) is not None:
                option(getattr(self, name), tuple(known), name)

    @property
    def units(self) -> dict[str, str | None]:
        """Given units by argument name."""
        return {name: getattr(self, name) for name in _SI}

    @property
    def rotation_order(self) -> str:
        """Order of the rotations."""
        return self.euler_order or "zyx"

    @property
    def meters_per_unit(self) -> float:
        """Length unit in meters."""
        return LENGTH_UNITS[self.length_unit or "m"]

    @property
    def radians_per_unit(self) -> float:
        """Angle unit in radians."""
        return ANGLE_UNITS[self.angle_unit or "rad"]

    def with_units(self, units: Mapping[str, str]) -> Self:
        """Return the format with all units: given units, otherwise units of the file, otherwise SI.

        Parameters
        ----------
        units : Mapping
            Units of the file by argument name, for example ``length_unit``.

        Returns
        -------
        TrajectoryFormat
            Format with three units.
        """
        chosen: dict[str, Any]
        chosen = {name: given or units.get(name, _SI[name]) for name, given in self.units.items()}
        return dataclasses.replace(self, **chosen)


class Table(NamedTuple):
    """Columns of a file by name, as written but for time in s, the rows where they stand, and its format.

    dated: whether dates or times of day are written, whose seconds are those since the first row.
    given_units: names of the units, such as ``length_unit``, in the given format. unit_line: line of the row
    of units; None if the file has none.
    """

    columns: dict[str, Array]
    rows: Sequence[int]
    form: TrajectoryFormat
    dated: bool
    given_units: frozenset[str]
    unit_line: int | None


def read_columns(
    stream: BinaryIO,
    source: str,
    check_header: Callable[[list[str], str], None],
    form: TrajectoryFormat,
    progress: Progress = silent,
) -> Table:
    """Return the columns of a CSV file, and its format with the units that a row of it states.

    stream: the file, which is read in parts, so that the numbers alone take room. check_header: rejects a
    header of expected names, given the name of the file. progress: given the share of the file that is read.
    """
    with table_as_utf8(stream, source) as stream:
        size = max(1, stream.seek(0, io.SEEK_END))

        def read() -> None:
            progress(f"reading {source}", min(1.0, stream.tell() / size))

        head = _head(stream, source, form)
        try:
            header = _expected_names(head.names, source, form)
            check_header([name for name in header if name is not None], source)
        except ValueError as error:
            raise HeaderError(str(error), head.names) from None
        units = units_of(head, header, source)
        given_units = frozenset(name for name, unit in form.units.items() if unit)
        unit_line = None if units is None else head.above + 1
        for name, unit in (units or {}).items():
            if name in given_units and form.units[name] != unit:
                option = f"TrajectoryFormat({name}={form.units[name]!r})"
                contradiction = f"the row of units ({unit}) contradicts {option}, which is used"
                warn(f"{source}: line {unit_line}: {contradiction}; correct one of them", TrajectoryWarning)
        form = form.with_units(units or {})
        if units is not None:
            head = without_row(stream, head)
        clock = _clock(head, header, source, form)
        decimal = _decimal(stream, head, form, clock is not None)
        stream.seek(head.begin)
        lines = io.TextIOWrapper(stream, encoding="utf-8", newline="")
        try:
            columns, rows = _columns(lines, source, header, head, decimal, clock, read)
        finally:
            lines.detach()
        if not rows:
            raise ValueError(f"{source}: expected rows of numbers below the header, got none")
        if _cut_off(stream, head, decimal):
            warn(
                f"{source}: line {rows[-1]}: expected as many decimals as above or a line ending: "
                "the file may be cut off",
                TrajectoryWarning,
            )
    # Divided, times are the nearest doubles of what is written.
    columns["time"] /= round(1.0 / TIME_UNITS[form.time_unit or "s"])
    columns, rows = _without_repeated(columns, rows, source)
    late = np.flatnonzero(np.diff(columns["time"]) <= 0.0)
    if late.size:
        i = int(late[0])
        before, after = map(time_text, columns["time"][i : i + 2])
        raise ValueError(
            f"{source}: line {rows[i + 1]}: time: expected increasing times, got {after} after {before}"
        )
    dated = frozenset() if clock is None else frozenset({"time_unit"})
    return Table(columns, rows, form, clock is not None, given_units | dated, unit_line)


def stated_units(stream: BinaryIO, source: str, form: TrajectoryFormat) -> dict[str, str]:
    """Units by kind, as in ``TrajectoryFormat``, that the file's row of units states; errors are its
    reader's.
    """
    with contextlib.suppress(ValueError), table_as_utf8(stream, source) as text:
        head = _head(text, source, form)
        return units_of(head, _expected_names(head.names, source, form), source) or {}
    return {}


def _without_repeated(
    columns: dict[str, Array], rows: Sequence[int], source: str
) -> tuple[dict[str, Array], Sequence[int]]:
    """Columns and rows without those that have the time and all other numbers of the row above."""
    again = 1 + np.flatnonzero(columns["time"][1:] == columns["time"][:-1])
    for column in columns.values():
        again = again[column[again] == column[again - 1]]
    if not again.size:
        return columns, rows
    many = f"{again.size} rows have" if again.size > 1 else "1 row has"
    warn(
        f"{source}: {many} the time and all numbers of the row above, the first is line {rows[again[0]]}: "
        "taken once",
        TrajectoryWarning,
    )
    kept = np.delete(np.array(rows), again)
    return {name: np.delete(column, again) for name, column in columns.items()}, kept.tolist()


def need_columns(header: Sequence[str], columns: Sequence[str], source: str) -> None:
    """Reject a header that lacks one of the columns."""
    for column in columns:
        if column not in header:
            raise ValueError(f"{source}: missing column {column}")


def _head(stream: BinaryIO, source: str, form: TrajectoryFormat) -> Head:
    delimiter = None if form.delimiter is None else DELIMITERS[form.delimiter]
    head = read_head(stream, source, form.columns.values(), delimiter)
    if len(head.names) == 1 and form.columns.get("time", "time") in head.names[0].split()[:-1]:
        raise ValueError(f"{source}: expected commas, semicolons or tabs between columns, got blanks")
    return head


def _clock(head: Head, header: list[str | None], source: str, form: TrajectoryFormat) -> Clock | None:
    """What reads the times where the first row has a date or a time of day."""
    text = dict(zip(header, head.first, strict=False)).get("time", "")
    if instant(text) is None:
        return None
    if form.time_unit not in (None, "s"):
        raise ValueError(
            f"{source}: line {head.above + 1}: time: expected {form.time_unit} "
            f"(time_unit={form.time_unit}), got {text!r}: "
            "dates and times of day have no unit"
        )
    return Clock()


def _columns(
    lines: Iterator[str],
    source: str,
    header: list[str | None],
    head: Head,
    decimal: str,
    clock: Clock | None,
    read: Callable[[], None],
) -> tuple[dict[str, Array], Sequence[int]]:
    """Columns of the lines by name, and their rows; ``read`` is called now and then."""
    used = [i for i, name in enumerate(header) if name is not None]
    # As numbers at once: the cells of a long file would take ten times its size.
    numbers = [array.array("d") for _ in used]
    while part := list(itertools.islice(lines, _ROWS)):
        table = _plain_table(part, len(header), used, head.delimiter, decimal)
        if table is None:
            break
        read()
        for column, more in zip(numbers, table.T, strict=True):
            column.frombytes(more.tobytes())
    above = head.above + len(numbers[0])
    rows: Sequence[int] = range(head.above + 1, above + 1)
    if part:
        reader = csv.reader(itertools.chain(part, lines), delimiter=head.delimiter, skipinitialspace=True)
        rows = array.array("q", rows)
        try:
            for cells in reader:
                if not any(cell.strip() for cell in cells):
                    continue
                row = above + reader.line_num
                rows.append(row)
                if len(rows) % _ROWS == 0:
                    read()
                values = _row(cells, header, f"{source}: line {row}: ", decimal, clock)
                for column, value in zip(numbers, values, strict=True):
                    column.append(value)
        except csv.Error as error:
            raise ValueError(f"{source}: line {above + reader.line_num}: not valid CSV: {error}") from None
    names = (name for name in header if name is not None)
    return {name: np.frombuffer(column) for name, column in zip(names, numbers, strict=True)}, rows


def _cut_off(stream: BinaryIO, head: Head, decimal: str) -> bool:
    """Whether the file ends within its last number: only where a fixed number of decimals proves it.

    A program that writes two or more decimals, as many in each row and zeros at their end too, always does:
    fewer of them, and no line ending, are not what it wrote.
    """
    stream.seek(max(head.begin, stream.seek(0, io.SEEK_END) - _TAIL))
    *above, last = stream.read().decode(errors="replace").splitlines(keepends=True)
    decimals = [
        line.rpartition(head.delimiter)[2].strip().partition(decimal)[2] for line in (*above[1:], last)
    ]
    *fixed, left = decimals
    widths = {len(digits) for digits in fixed}
    return (
        not last.endswith(("\n", "\r"))
        and len(widths) == 1
        and max(widths) >= 2
        and len(left) < max(widths)
        and any(digits.isdecimal() and digits.endswith("0") for digits in fixed)
    )


def _decimal(stream: BinaryIO, head: Head, form: TrajectoryFormat, dated: bool) -> str:
    """Decimal mark: a comma where there is one below the header that can't be the delimiter, and no point.

    dated: the first row tells by numbers alone, since dates and times of day have points anyway.
    """
    if form.decimal is not None:
        return DECIMALS[form.decimal]
    if dated:
        numbers = "".join(filter(is_value, head.first))
        return "," if "," in numbers and "." not in numbers else "."
    stream.seek(head.begin)
    comma = False
    while head.delimiter != "," and (chunk := stream.read(_CHUNK)):
        if b"." in chunk:
            return "."
        comma = comma or b"," in chunk
    return "," if comma else "."


def _expected_names(header: list[str], source: str, form: TrajectoryFormat) -> list[str | None]:
    """Names of the columns as expected; None for one that is skipped."""
    if not form.columns:
        # A controller that ends every line with a delimiter writes a last column without a name.
        return [*header[:-1], None] if "" in header[-1:] and "" not in header[:-1] else [*header]
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

    A tenth of the time that ``csv`` takes, whose rows name what is not in order.
    """
    # A point beside decimal commas is no decimal mark.
    if not lines[0].strip() or (decimal != "." and any("." in line for line in lines)):
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


def _row(
    cells: list[str], header: list[str | None], where: str, decimal: str, clock: Clock | None
) -> list[float]:
    if len(cells) != len(header):
        cause = ""
        if decimal == "." and len(header) < len(cells) <= 2 * len(header):
            cause = ": are commas its decimal marks too? then columns need another delimiter, or quotes"
        raise ValueError(f"{where}expected {len(header)} columns, got {len(cells)}{cause}")
    used = [(cell.strip(), name) for cell, name in zip(cells, header, strict=True) if name is not None]
    found = [
        clock.seconds(text, where + name) if clock and name == "time" else _number(text, decimal)
        for text, name in used
    ]
    if not all(map(math.isfinite, found)):
        wrong = [each for each, value in zip(used, found, strict=True) if not math.isfinite(value)]
        # A thousands separator is why the commas of other cells are not taken for decimal marks.
        both = (each for each in wrong if {",", "."} < set(each[0]) and ":" not in each[0])
        text, name = next(both, wrong[0])
        cause = _cause(text, decimal)
        raise ValueError(f"{where}{name}: expected a finite number, got {text[:40]!r}{cause}")
    return found


def _number(text: str, decimal: str) -> float:
    if "_" in text or (decimal != "." and "." in text):
        return math.nan
    try:
        return float(text.replace(decimal, "."))
    except ValueError:
        return math.nan


def _cause(text: str, decimal: str) -> str:
    """Why a cell is no number, where that shows."""
    if ":" in text:
        return f": {READ}"
    if "." in text and "," in text:
        return ": thousands separators are not read"
    if "." in text and decimal == ",":
        return ": decimals have a comma (decimal=comma), thousands separators are not read"
    if "," in text and decimal == ".":
        return ": is its decimal mark a comma (decimal=comma)?"
    return ""
