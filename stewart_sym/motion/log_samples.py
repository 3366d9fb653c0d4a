"""Samples of a log in SI units: columns by name, units, times, and steps of rounding."""

import dataclasses
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..io.arguments import safe_text
from ..io.array_types import Array
from ..io.error_policy import warn
from . import rotation
from .csv_table import CsvTable, Lines, read_table, split_unit
from .sample_times import elapsed, time_text
from .trajectory_format import PLAIN, UNITS, TrajectoryFormat, TrajectoryWarning, combined

POSE = ("t", "theta")
RATES = ("v", "theta_dot", "a", "theta_ddot")
LENGTH_RATES = ("L_dot", "L_ddot")
LOADS = ("F_ext", "M_ext")
FORCES = ("F", "current")
"""Forces of the legs, or currents of their motors."""
_VECTORS = (*POSE, "q", "L", *RATES, *LENGTH_RATES, *LOADS)
_SUFFIXES = {"q": "wxyz", **dict.fromkeys(("L", *LENGTH_RATES, *FORCES), "123456")}
# Other names of columns, in lower case and without separators.
_ALIASES = {
    **dict.fromkeys(("time", "timestamp", "stamp", "t", "elapsed"), "time"),
    **{"surge": "t_x", "sway": "t_y", "heave": "t_z", "x": "t_x", "y": "t_y", "z": "t_z"},
    **{"roll": "theta_x", "pitch": "theta_y", "yaw": "theta_z"},
    **{f"{name}{leg}": f"L_{leg}" for name in ("leg", "length") for leg in range(1, 7)},
    **{f"force{leg}": f"F_{leg}" for leg in range(1, 7)},
}
# Units in SI units by kind, the SI unit first.
_KNOWN_UNITS: dict[str, Mapping[str, float]] = {
    **UNITS,
    "unit of force": {"N": 1.0, "kN": 1e3},
    "unit of moment": {"Nm": 1.0, "kNm": 1e3},
    "unit of current": {"A": 1.0, "mA": 1e-3},
}
# Kind of unit and power of the time in its denominator, by vector.
_QUANTITIES = {
    **{"time": ("time_unit", 0), "F_ext": ("unit of force", 0), "M_ext": ("unit of moment", 0)},
    **{"F": ("unit of force", 0), "current": ("unit of current", 0)},
    **{name: ("length_unit", power) for power, name in enumerate("tva")},
    **{f"L{rate}": ("length_unit", power) for power, rate in enumerate(("", "_dot", "_ddot"))},
    **{f"theta{rate}": ("angle_unit", power) for power, rate in enumerate(("", "_dot", "_ddot"))},
}
_DEFAULTS = {kind: next(iter(units)) for kind, units in _KNOWN_UNITS.items()}
_MODES = ("pose_mode", "length_mode", "columns")
_PER_SECOND = ("", "/s", "/s2")
_SPELLED = {"°": "deg", "degree": "deg", "degrees": "deg", "radians": "rad", "inch": "in", "sec": "s"}
_SPELLED |= {"µs": "us", "μs": "us", "meters": "m", "seconds": "s"}
# Seconds of a year. Larger numbers are times since 1970; in another unit they are 1000 times as large.
_YEAR = 3.0e7
_MOST_DECIMALS = 12
# Number of different values that show the rounding of a column.
_FEWEST_VALUES = 8
# Relative rounding of a decimal number that is multiplied by a power of ten.
_ROUNDING = 1e-15
# Smallest fraction of rows of numbers.
_FEWEST_GOOD = 0.5


@dataclass(frozen=True, eq=False)
class LogSamples:
    """Samples of a log in SI units, with their lines in the file.

    Times are counted from ``start`` (s) if they are dates, times of day, or times since 1970; None for static
    poses. ``vectors`` contains positions ``t`` with ``theta`` or ``q``, or lengths ``L``, their rates, and
    loads, or forces; ``steps`` contains the steps to which they are rounded. ``places`` is the origin of each
    unit, of the modes, and of the columns, such as "the options".
    """

    source: str
    lines: Lines
    time: Array | None
    vectors: dict[str, Array]
    steps: dict[str, Array]
    file_format: TrajectoryFormat
    places: dict[str, str]
    start: float = 0.0

    def angles(self) -> tuple[Array, Array, str]:
        """Return unwrapped angles (rad), (n, 3), their steps, (3,), and the order of the rotations.

        Without rates, the order is changed if two rotations nearly have one axis.
        """
        order = self.file_format.euler_order or "zyx"
        if "q" in self.vectors:
            q = self.vectors["q"]
            theta, order = rotation.far_from_lock(rotation.rotation_from_quaternion(q))
            step = np.full(3, 2.0 * self.steps["q"].max() / np.median(np.linalg.norm(q, axis=-1)))
        else:
            theta, step = self.vectors["theta"], self.steps["theta"]
            near_lock = rotation.distance_from_lock(theta, order).min() < rotation.FAR_FROM_LOCK
            if near_lock and "theta_dot" not in self.vectors:
                theta, order = rotation.far_from_lock(rotation.rotation_about_axes(theta, order))
                step = np.full(3, step.max())
        return np.unwrap(theta, axis=0), step, order


def read_samples(
    source: str, form: TrajectoryFormat = PLAIN, defaults: TrajectoryFormat = PLAIN, forces: bool = False
) -> LogSamples:
    """Read a CSV file of poses or leg lengths, or of forces or currents of the legs.

    ``defaults`` is the format for properties that neither ``form`` nor the header states. A file with
    standard columns uses only its order of rotations. Raises ValueError if columns are missing, times do
    not increase, or more than half of the rows are not numbers. Warns of dropped rows, and of units that
    contradict each other.
    """
    table = read_table(source, form.delimiter, form.decimal)
    if _is_standard(table, defaults):
        defaults = TrajectoryFormat(euler_order=defaults.euler_order)
    stated, form = form, combined(form, defaults)
    found = _columns(table, form, FORCES if forces else _VECTORS)
    if stated.row_rate is not None and "time" in found:
        raise ValueError(f"{source}: row_rate: the file has times; omit row_rate")
    vectors = _needed(table, found, forces)
    units, places = _units(table, found, stated, defaults)
    components = [each for name in vectors for each in components_of(name)]
    cells = [found[each] for each in (*components, "time") if each in found]
    numbers, origin, time = table.numbers(cells[: len(components)]), None, None
    if "time" in found:
        time, origin = table.times(found["time"])
        numbers = np.column_stack([numbers, time])
    rows = _good_rows(table, cells, numbers, form.drop_lines)
    numbers, lines = numbers[rows], table.lines[rows]
    if time is not None:
        time, start, units["time_unit"] = _times(time[rows], origin, units.get("time_unit"))
    else:
        time, start = _times_of_rows(table, found, lines, form.row_rate), 0.0
    units = _DEFAULTS | units
    columns, steps = {}, {}
    for each, column in zip(components, numbers.T, strict=False):
        kind, scale = _quantity(each)[0], form.scales.get(each, 1.0)
        factor = _KNOWN_UNITS[kind][units[kind]] if kind else 1.0
        columns[each] = (column * scale + form.offsets.get(each, 0.0)) * factor
        steps[each] = _step(column) * abs(scale) * factor
    rows = _increasing(time, columns, lines, source)
    return LogSamples(
        source,
        lines[rows],
        None if time is None else time[rows],
        {name: np.stack([columns[each][rows] for each in components_of(name)], axis=-1) for name in vectors},
        {name: np.array([steps[each] for each in components_of(name)]) for name in vectors},
        dataclasses.replace(form, **{kind: units[kind] for kind in UNITS}),
        places,
        start,
    )


def _good_rows(table: CsvTable, cells: Sequence[str], numbers: Array, drop_lines: Sequence[int]) -> Lines:
    """Return the indices of rows of numbers without dropped lines, with a warning about other rows."""
    finite = np.isfinite(numbers)
    good = np.asarray(finite.all(axis=1))
    if np.count_nonzero(good) < _FEWEST_GOOD * len(good):
        worst = int(np.argmin(np.count_nonzero(finite, axis=0)))
        row = int(np.argmin(finite[:, worst]))
        text = safe_text(list(table.cells(cells[worst]))[row][:40])
        place = f"{table.source}: line {table.lines[row]}: column {cells[worst]}"
        remedy = "check decimal, name another column, or write dates as 2025-12-31 23:59:59.5"
        raise ValueError(f"{place}: expected a number or a time, got {text!r}; {remedy}")
    if not good.all():
        finding = f"{table.source}: rows without numbers ({line_ranges(table.lines[~good])})"
        warn(f"{finding}; they are not used", TrajectoryWarning)
    beyond = [line for line in drop_lines if line > table.lines[-1]]
    if beyond:
        finding = f"line {beyond[0]} is beyond the last line {table.lines[-1]}"
        raise ValueError(f"{table.source}: drop_lines: {finding}")
    return np.flatnonzero(good & ~np.isin(table.lines, drop_lines))


def _times(numbers: Array, origin: float | None, unit: str | None) -> tuple[Array, float, str]:
    """Return times (s), the time (s) from which they are counted, and their unit.

    Times since 1970 are counted from the first row; without a unit, their size determines it.
    """
    if origin is not None:
        return numbers, origin, "s"
    first = abs(numbers[0]) if len(numbers) else 0.0
    sizes = {"us": 1e6 * _YEAR, "ms": 1e3 * _YEAR, "s": -1.0}
    unit = unit or next(unit for unit, least in sizes.items() if first > least)
    # A division has a smaller rounding error than a multiplication by a power of ten.
    time = numbers / round(1.0 / UNITS["time_unit"][unit])
    if first * UNITS["time_unit"][unit] > _YEAR:
        return elapsed(time), float(time[0]), unit
    return time, 0.0, unit


def _times_of_rows(
    table: CsvTable, found: Mapping[str, str], lines: Lines, row_rate: float | None
) -> Array | None:
    """Return the times (s) of rows at a rate (Hz); None for static poses, with a warning.

    Raises ValueError if an unnamed column contains times.
    """
    if row_rate is not None:
        return np.searchsorted(table.lines, lines) / row_rate
    for cell in [cell for cell in table.header if cell not in found.values()]:
        unit = plain_unit(table.units.get(cell) or cell.rpartition("_")[2], "time")
        if unit is not None or table.has_instants(cell):
            remedy = f"state columns time={cell}, or remove this column for poses at rest"
            raise ValueError(f"{table.source}: no column of times; {remedy}")
    finding = f"{table.source}: no column of times; the rows are poses at rest"
    remedy = "if they are samples over time, state row_rate or columns time=HEADER"
    warn(f"{finding}; {remedy}", TrajectoryWarning)
    return None


def warn_of(samples: LogSamples, text: str) -> None:
    """Warn of a finding about a log."""
    warn(f"{samples.source}: {text}", TrajectoryWarning)


def possible_units(log: LogSamples, vector: str) -> dict[str, float]:
    """Return the units of a vector, the SI unit first, with their factors; empty if the header states one."""
    kind = _QUANTITIES[vector][0]
    return {} if kind in log.places else dict(_KNOWN_UNITS[kind])


def components_of(name: str) -> tuple[str, ...]:
    """Return the names of the columns of a vector."""
    return tuple(f"{name}_{each}" for each in _SUFFIXES.get(name, "xyz"))


_COMPONENTS = {
    each.replace("_", "").lower(): each for name in (*_VECTORS, *FORCES) for each in components_of(name)
}


def _is_standard(table: CsvTable, form: TrajectoryFormat) -> bool:
    """Return True for a file with standard columns: poses with all rates, or none of the format's columns."""
    if form.columns and not any(split_unit(each)[0] in table.header for each in form.columns.values()):
        return True
    names = [each for name in (*POSE, *RATES) for each in components_of(name)]
    return not form.columns and not table.units and set(names) <= set(table.header)


def _columns(table: CsvTable, form: TrajectoryFormat, vectors: Sequence[str]) -> dict[str, str]:
    """Return the name in the header of each column of vectors that is known or given by the format."""
    found = {}
    names = ["time", *(each for name in vectors for each in components_of(name))]
    for name, given in form.columns.items():
        if name not in names:
            raise ValueError(f"columns: {name}: unknown name; use one of {', '.join(names)}")
        plain = split_unit(given)[0]
        if plain not in table.header:
            raise ValueError(
                f"{table.source}: no column {given!r}, given for {name}; columns: {_few(table.header)}"
            )
        found[name] = plain
    for cell in [cell for cell in table.header if cell not in found.values()]:
        known = _known_name(cell)
        if known not in names or known in form.columns:
            continue
        if known in found:
            finding = f"columns {found[known]!r} and {cell!r} are both {known}"
            raise ValueError(f"{table.source}: {finding}; rename one of them")
        found[known] = cell
    return found


def _known_name(cell: str) -> str | None:
    """Return the known name of a header cell, also with a unit at its end such as ``_ms``."""
    for text, unit in ((cell, ""), cell.rpartition("_")[::2]):
        plain = re.sub(r"[\s_.\-]", "", text).lower()
        name = text if text == "time" else _COMPONENTS.get(plain) or _ALIASES.get(plain)
        if name is not None and (not unit or plain_unit(unit, name) is not None):
            return name
    return None


def _needed(table: CsvTable, found: Mapping[str, str], forces: bool) -> list[str]:
    """Return the vectors that are read; raise ValueError unless the file has all their columns."""
    present = [name for name in (*FORCES, *_VECTORS) if not set(components_of(name)).isdisjoint(found)]
    if forces:
        vectors = present[:1] or [FORCES[0]]
    else:
        _reject_other_files(table, found, present)
        position = ("L",) if "L" in present else ("t", "q") if "q" in present else POSE
        rates = LENGTH_RATES if "L" in present else () if "q" in present else RATES
        rates = rates if set(rates) <= set(present) else ()
        vectors = [*position, *rates, *(name for name in LOADS if name in present)]
    for each in [each for name in vectors for each in components_of(name) if each not in found]:
        others = _few([cell for cell in table.header if cell not in found.values()]) or "none"
        remedy = f"name it with columns {each}=HEADER; other columns: {others}"
        raise ValueError(f"{table.source}: no column {each}; {remedy}")
    return vectors


def _reject_other_files(table: CsvTable, found: Mapping[str, str], present: list[str]) -> None:
    """Raise ValueError for a file that contains no trajectory, or two."""
    if "L" in present and {"q", *POSE} & set(present):
        raise ValueError(f"{table.source}: columns of poses and of leg lengths; select one kind with columns")
    if {"omega_x", "kinetic_energy"} <= set(table.header):
        raise ValueError(
            f"{table.source}: a run of simulate (reference point; roll, pitch, yaw); display it with view, "
            "or convert it to the tool and the rotation order of the robot"
        )
    if not set(found) - {"time"}:
        raise ValueError(
            f"{table.source}: no columns of a trajectory in the header ({_few(table.header)}); expected "
            "time, t_x, t_y, t_z, theta_x, theta_y, theta_z, or time and L_1 to L_6; name others with "
            "columns t_x=HEADER"
        )


def _units(
    table: CsvTable, found: Mapping[str, str], stated: TrajectoryFormat, defaults: TrajectoryFormat
) -> tuple[dict[str, Any], dict[str, str]]:
    """Return units, modes, and columns from the options, the header, or the robot file, and their places."""
    header: dict[str, Any] = {}
    for name, cell in found.items():
        if name == "time" and table.has_instants(cell):
            continue
        unit, kind = _header_unit(table, cell, name), _quantity(name)[0]
        if unit is not None and header.setdefault(kind, unit) != unit:
            finding = f"{unit} and {header[kind]} in one file"
            raise ValueError(f"{table.source}: column {cell}: {finding}; use one {kind}")
    for kind, unit in header.items():
        if (getattr(stated, kind, None) or unit) != unit:
            finding = f"{table.source}: the header unit {unit} contradicts {kind}={getattr(stated, kind)}"
            warn(f"{finding}, which is used; correct one of them", TrajectoryWarning)
    units: dict[str, Any] = {}
    places: dict[str, str] = {}
    origins = {"the robot file": vars(defaults), "the header": header, "the options": vars(stated)}
    for place, given in origins.items():
        present = {name: given[name] for name in (*_KNOWN_UNITS, *_MODES) if given.get(name)}
        units |= present
        places |= dict.fromkeys(present, place)
    return units, places


def _header_unit(table: CsvTable, cell: str, name: str) -> str | None:
    """Return the unit of a column in brackets, in a row of units, or at the end of its header, or None."""
    kind, text = _quantity(name)[0], table.units.get(cell)
    if not text or not kind:
        return plain_unit(cell.rpartition("_")[2], name)
    unit = plain_unit(text, name)
    if unit is None:
        known = ", ".join(_KNOWN_UNITS[kind])
        raise ValueError(
            f"{table.source}: column {cell}: unknown unit {text!r}; convert it to one of {known}"
        )
    return unit


def _quantity(name: str) -> tuple[str, int]:
    """Return the kind of unit of a column, and the power of the time in its denominator."""
    return _QUANTITIES.get(name.rpartition("_")[0] or name, ("", 0))


def plain_unit(text: str, name: str) -> str | None:
    """Return a key of the known units for a text, without the denominator of rates; None for another unit."""
    kind, times = _quantity(name)
    plain = re.sub(r"[\s·*^()\[\]]", "", text.replace("²", "2")).removesuffix(_PER_SECOND[times]).lower()
    spelled = _SPELLED.get(plain, plain)
    return next((unit for unit in _KNOWN_UNITS.get(kind, {}) if unit.lower() == spelled), None)


def _step(values: Array) -> float:
    """Return the step to which a column is rounded to decimals; 0 if there is none.

    Few or nearly constant values do not show their rounding.
    """
    some = values[:: max(1, len(values) // 1000)]
    if len(np.unique(some)) < _FEWEST_VALUES:
        return 0.0
    for decimals in range(_MOST_DECIMALS):
        count = some * 10.0**decimals
        if np.all(np.abs(count - np.rint(count)) <= _ROUNDING * np.abs(count)):
            return 10.0**-decimals
    return 0.0


def line_ranges(lines: Lines, most: int = 8) -> str:
    """Format line numbers such as ``lines 3, 7-9 and 5 more``."""
    runs = np.split(lines, np.flatnonzero(np.diff(lines) > 1) + 1)
    texts = [f"{run[0]}" if len(run) == 1 else f"{run[0]}-{run[-1]}" for run in runs]
    more = f" and {len(texts) - most} more places" if len(texts) > most else ""
    return f"line{'s' if len(lines) > 1 else ''} {', '.join(texts[:most])}{more}"


def _increasing(time: Array | None, columns: Mapping[str, Array], lines: Lines, source: str) -> Lines:
    """Return the indices of rows without repeated ones; raise ValueError for times that do not increase."""
    if not len(lines):
        raise ValueError(f"{source}: no rows of numbers below the header; add rows")
    if time is None:
        return np.arange(len(lines))
    again = [np.diff(column, prepend=np.nan) == 0.0 for column in (time, *columns.values())]
    rows = np.flatnonzero(~np.logical_and.reduce(again))
    late = np.flatnonzero(np.diff(time[rows]) <= 0.0)
    if late.size:
        before, after = (time_text(each) for each in time[rows[late[0] : late[0] + 2]])
        place = f"{source}: line {lines[rows[late[0] + 1]]}: time"
        raise ValueError(f"{place}: {after} follows {before}; sort the rows or drop the line")
    return rows


def _few(names: Sequence[str]) -> str:
    return ", ".join(safe_text(name[:40]) for name in names[:12])
