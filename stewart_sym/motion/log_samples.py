"""Samples of a log in SI units: columns by name, units, times, and steps of rounding."""

import dataclasses
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..io.arguments import safe_text
from ..io.array_types import Array, Flags
from ..io.error_policy import warn
from . import rotation
from .csv_table import CsvTable, Lines, is_number, read_table, split_unit
from .sample_times import time_text
from .trajectory_format import PLAIN, UNITS, TrajectoryFormat, TrajectoryWarning

POSE = ("t", "theta")
RATES = ("v", "theta_dot", "a", "theta_ddot")
LENGTH_RATES = ("L_dot", "L_ddot")
LOADS = ("F_ext", "M_ext")
_SUFFIXES = {"q": "wxyz", "L": "123456", "L_dot": "123456", "L_ddot": "123456"}
_VECTORS = (*POSE, "q", "L", *RATES, *LENGTH_RATES, *LOADS)
# Other names of columns, in lower case and without separators.
_ALIASES = {
    **dict.fromkeys(("time", "timestamp", "stamp", "t", "elapsed"), "time"),
    **{"surge": "t_x", "sway": "t_y", "heave": "t_z", "x": "t_x", "y": "t_y", "z": "t_z"},
    **{"roll": "theta_x", "pitch": "theta_y", "yaw": "theta_z"},
    **{f"{name}{leg}": f"L_{leg}" for name in ("leg", "length") for leg in range(1, 7)},
}
# Kind of unit and power of the time in its denominator, by vector.
_QUANTITIES = {
    **{
        "time": ("time_unit", 0),
        "t": ("length_unit", 0),
        "L": ("length_unit", 0),
        "theta": ("angle_unit", 0),
    },
    **{"v": ("length_unit", 1), "L_dot": ("length_unit", 1), "theta_dot": ("angle_unit", 1)},
    **{"a": ("length_unit", 2), "L_ddot": ("length_unit", 2), "theta_ddot": ("angle_unit", 2)},
    **{"F_ext": ("unit of force", 0), "M_ext": ("unit of moment", 0)},
}
_KNOWN_UNITS = {**UNITS, "unit of force": {"N": 1.0}, "unit of moment": {"Nm": 1.0}}
_PER_SECOND = ("", "/s", "/s2")
_SPELLED = {"°": "deg", "degree": "deg", "degrees": "deg", "radians": "rad", "inch": "in", "sec": "s"}
_SPELLED |= {"µs": "us", "μs": "us", "meters": "m", "seconds": "s", "n": "N", "nm": "Nm"}
_DEFAULTS = {"length_unit": "m", "angle_unit": "rad", "time_unit": "s"}
# Numbers of a year after 1970; a time since then in another unit is 1000 times as large.
_YEAR = 3.0e7
# Number of digits of nanoseconds since 1970, which a double cannot represent.
_LONG = 16
_MOST_DECIMALS = 12
# Number of different values that show the rounding of a column.
_FEWEST_VALUES = 8
# Relative rounding of a decimal number that is multiplied by a power of ten.
_ROUNDING = 1e-15
# Largest fraction of rows without numbers.
_MOST_DROPPED = 0.5


@dataclass(frozen=True, eq=False)
class LogSamples:
    """Samples of a log.

    Attributes
    ----------
    source : str
        Name of the file.
    lines : ndarray, shape (n,)
        Line of each sample.
    time : ndarray, shape (n,), or None
        Increasing times (s); None for a list of static poses.
    vectors : dict of str to ndarray, shape (n, 3), (n, 4), or (n, 6)
        Positions ``t`` with ``theta`` or ``q``, or lengths ``L``, their rates, and loads (SI).
    steps : dict of str to ndarray
        Step to which the components are rounded (SI), by vector.
    file_format : TrajectoryFormat
        Format with all units.
    unit_places : dict of str to str
        Origin of each unit, such as "line 3"; empty if the unit is the default.
    """

    source: str
    lines: Lines
    time: Array | None
    vectors: dict[str, Array]
    steps: dict[str, Array]
    file_format: TrajectoryFormat
    unit_places: dict[str, str]

    def angles(self) -> tuple[Array, Array, str]:
        """Return unwrapped angles (rad), (n, 3), their steps, (3,), and the order of the rotations.

        The order is changed if two rotations nearly have one axis.
        """
        order = self.file_format.euler_order or "zyx"
        if "q" in self.vectors:
            q = self.vectors["q"]
            theta, order = rotation.far_from_lock(rotation.rotation_from_quaternion(q))
            step = np.full(3, 2.0 * self.steps["q"].max() / np.median(np.linalg.norm(q, axis=-1)))
        else:
            theta, step = self.vectors["theta"], self.steps["theta"]
            if rotation.distance_from_lock(theta, order).min() < rotation.FAR_FROM_LOCK:
                theta, order = rotation.far_from_lock(rotation.rotation_about_axes(theta, order))
                step = np.full(3, step.max())
        return np.unwrap(theta, axis=0), step, order


def read_samples(
    source: str, form: TrajectoryFormat = PLAIN, defaults: TrajectoryFormat = PLAIN
) -> LogSamples:
    """Read a CSV file of poses or leg lengths.

    Parameters
    ----------
    source : str
        Name of the file.
    form : TrajectoryFormat
        Format of the file.
    defaults : TrajectoryFormat
        Format for properties that neither ``form`` nor the header states. A file with standard columns uses
        only its order of rotations.

    Returns
    -------
    LogSamples
        Samples in SI units.

    Raises
    ------
    ValueError
        If columns are missing, times do not increase, or more than half of the rows are not numbers.

    Warns
    -----
    TrajectoryWarning
        If rows are dropped, or units contradict each other.
    """
    table = read_table(source, form.delimiter, form.decimal)
    if _is_standard(table, defaults):
        defaults = TrajectoryFormat(euler_order=defaults.euler_order)
    given, own_rate, form = _given(form), form.row_rate, form.with_defaults(defaults)
    found = _columns(table, form)
    if own_rate is not None and "time" in found:
        raise ValueError(f"{source}: row_rate: the file has times; omit row_rate")
    vectors = _needed(found, table.header, source)
    stated, places = _units(table, found, given)
    places |= {kind: "the robot file" for kind in _given(defaults) if kind not in places}
    stated = _given(defaults) | stated | given
    clock = _clock(table, found.get("time"), stated.get("time_unit"))
    components = [each for name in vectors for each in components_of(name)]
    wanted = [found[each] for each in components] + [found[each] for each in ("time",) if each in found]
    numbers, good = table.columns(wanted, clock)
    _warn_of_dropped(table, good, wanted)
    place = np.flatnonzero(good)
    used = ~np.isin(table.lines[place], form.drop_lines)
    numbers, place = {name: column[used] for name, column in numbers.items()}, place[used]
    raw = numbers.get(found.get("time", ""))
    if clock is None and raw is not None and "time_unit" not in stated:
        stated["time_unit"] = _unit_since_1970(raw) or "s"
    units: dict[str, Any] = _DEFAULTS | stated
    form = dataclasses.replace(form, **units)
    time = raw if raw is None or clock else raw / round(1.0 / UNITS["time_unit"][form.time_unit or "s"])
    if raw is None and form.row_rate is not None:
        time = place / form.row_rate
    elif raw is None:
        finding = f"{source}: no column of times; the rows are poses at rest"
        warn(f"{finding}; state row_rate if they are samples over time", TrajectoryWarning)
    columns = {each: _scaled(each, numbers[found[each]], form) for each in components}
    rows = _increasing(time, columns, table.lines[place], source)
    time = None if time is None else time[rows]
    return LogSamples(
        source,
        table.lines[place[rows]],
        time,
        {name: np.stack([columns[each][rows] for each in components_of(name)], axis=-1) for name in vectors},
        {
            name: np.array([_step(each, numbers[found[each]], form) for each in components_of(name)])
            for name in vectors
        },
        form,
        places,
    )


def components_of(name: str) -> tuple[str, ...]:
    """Return the names of the columns of a vector."""
    return tuple(f"{name}_{each}" for each in _SUFFIXES.get(name, "xyz"))


_COMPONENTS = {each.replace("_", "").lower(): each for name in _VECTORS for each in components_of(name)}


def _is_standard(table: CsvTable, form: TrajectoryFormat) -> bool:
    """Return True for a file with standard columns: poses with all rates, or none of the format's columns."""
    if form.columns and not any(split_unit(each)[0] in table.header for each in form.columns.values()):
        return True
    names = [each for name in (*POSE, *RATES) for each in components_of(name)]
    return not form.columns and not table.units and set(names) <= set(table.header)


def _columns(table: CsvTable, form: TrajectoryFormat) -> dict[str, str]:
    """Return the name in the header of each column that is known or given by the format."""
    found = {}
    for name, given in form.columns.items():
        if name != "time" and name not in _COMPONENTS.values():
            raise ValueError(
                f"columns: {name}: unknown name; use one of time, {', '.join(_COMPONENTS.values())}"
            )
        plain = split_unit(given)[0]
        if plain not in table.header:
            raise ValueError(
                f"{table.source}: no column {given!r}, given for {name}; columns: {_few(table.header)}"
            )
        found[name] = plain
    taken = set(found.values())
    for cell in table.header:
        known = _name_and_unit(cell)[0]
        if known is None or cell in taken or known in form.columns:
            continue
        if known in found:
            raise ValueError(
                f"{table.source}: columns {found[known]!r} and {cell!r} are both {known}; rename one of them"
            )
        found[known] = cell
    return found


def _name_and_unit(cell: str) -> tuple[str | None, str]:
    """Return the known name that a header cell stands for, or None, and a unit at its end such as ``_ms``."""
    for text, unit in ((cell, ""), cell.rpartition("_")[::2]):
        plain = re.sub(r"[\s_.\-]", "", text).lower()
        name = text if text == "time" else _COMPONENTS.get(plain) or _ALIASES.get(plain)
        known = name is not None and (not unit or _plain_unit(unit, name) is not None)
        if known:
            return name, unit
    return None, ""


def _needed(found: Mapping[str, str], header: Sequence[str], source: str) -> list[str]:
    """Return the vectors that are read."""
    lengths = any(each in found for each in components_of("L"))
    position = ("L",) if lengths else ("t", "q") if "q_w" in found else POSE
    if lengths and any(each in found for name in (*POSE, "q") for each in components_of(name)):
        raise ValueError(f"{source}: columns of poses and of leg lengths; select one kind with columns")
    rates = LENGTH_RATES if lengths else () if "q_w" in found else RATES
    if not all(components_of(name)[0] in found for name in rates):
        rates = ()
    if {"omega_x", "kinetic_energy"} <= set(header):
        raise ValueError(
            f"{source}: a run of simulate (reference point; roll, pitch, yaw); display it with view, or "
            "convert it to the tool and the rotation order of the robot"
        )
    if not set(found) - {"time"}:
        raise ValueError(
            f"{source}: no columns of a trajectory in the header ({_few(header)}); expected time, t_x, t_y, "
            "t_z, theta_x, theta_y, theta_z, or time and L_1 to L_6; name others with columns t_x=HEADER"
        )
    loads = [name for name in LOADS if any(each in found for each in components_of(name))]
    for name in (*position, *rates, *loads):
        for each in components_of(name):
            if each not in found:
                raise ValueError(f"{source}: no column {each}; name it with columns {each}=HEADER")
    return [*position, *rates, *loads]


def _units(
    table: CsvTable, found: Mapping[str, str], given: Mapping[str, str]
) -> tuple[dict[str, str], dict[str, str]]:
    """Return the units that the file states by kind, and the origin of these and of given units."""
    stated: dict[str, str] = {}
    places = dict.fromkeys(given, "the options")
    for name, cell in found.items():
        text = table.units.get(cell) or _name_and_unit(cell)[1]
        kind = _QUANTITIES.get(name.rpartition("_")[0] or name, ("", 0))[0]
        if not text or not kind:
            continue
        unit = _plain_unit(text, name)
        if unit is None:
            known = ", ".join(_KNOWN_UNITS[kind])
            raise ValueError(
                f"{table.source}: column {cell}: unknown unit {text!r}; convert it to one of {known}"
            )
        if stated.setdefault(kind, unit) != unit:
            raise ValueError(
                f"{table.source}: column {cell}: {unit} and {stated[kind]} in one file; use one {kind}"
            )
        places.setdefault(kind, "the header")
        if given.get(kind, unit) != unit:
            text = f"{table.source}: column {cell}: unit {unit} contradicts {kind}={given[kind]}"
            warn(f"{text}, which is used; correct one of them", TrajectoryWarning)
    return {kind: unit for kind, unit in stated.items() if kind in _DEFAULTS}, places


def _given(form: TrajectoryFormat) -> dict[str, str]:
    return {kind: getattr(form, kind) for kind in _DEFAULTS if getattr(form, kind) is not None}


def _plain_unit(text: str, name: str) -> str | None:
    """Return a key of the known units for a text, without the denominator of rates; None for another unit."""
    kind, times = _QUANTITIES.get(name.rpartition("_")[0] or name, ("", 0))
    plain = re.sub(r"[\s·*^()\[\]]", "", text.replace("²", "2")).removesuffix(_PER_SECOND[times])
    unit = _SPELLED.get(plain.lower(), plain if plain in ("N", "Nm") else plain.lower())
    return unit if unit in _KNOWN_UNITS.get(kind, {}) else None


def _clock(table: CsvTable, cell: str | None, unit: str | None) -> str | None:
    """Return the column of times if its cells are dates, times of day, or nanoseconds since 1970."""
    if cell is None:
        return None
    first = table.first(cell)
    return (
        cell
        if not is_number(first) or (first.isdigit() and len(first) > _LONG and unit in (None, "ns"))
        else None
    )


def _unit_since_1970(time: Array) -> str | None:
    """Return the unit of times since 1970, which their size determines; None for smaller times."""
    sizes = {"us": 1e6 * _YEAR, "ms": 1e3 * _YEAR, "s": _YEAR}
    return next((unit for unit, least in sizes.items() if len(time) and abs(time[0]) > least), None)


def _scaled(name: str, values: Array, form: TrajectoryFormat) -> Array:
    """Return a column in SI units, with its scale and offset."""
    return (values * form.scales.get(name, 1.0) + form.offsets.get(name, 0.0)) * _si(name, form)


def _si(name: str, form: TrajectoryFormat) -> float:
    kind = _QUANTITIES.get(name.rpartition("_")[0], ("", 0))[0]
    return UNITS[kind][getattr(form, kind)] if kind in UNITS else 1.0


def _step(name: str, values: Array, form: TrajectoryFormat) -> float:
    """Return the step (SI) to which a column is rounded to decimals; 0 if there is none.

    Few or nearly constant values do not show their rounding.
    """
    some = values[:: max(1, len(values) // 1000)]
    if len(np.unique(some)) < _FEWEST_VALUES:
        return 0.0
    for decimals in range(_MOST_DECIMALS):
        count = some * 10.0**decimals
        if np.all(np.abs(count - np.rint(count)) <= _ROUNDING * np.abs(count)):
            return 10.0**-decimals * abs(form.scales.get(name, 1.0)) * _si(name, form)
    return 0.0


def _warn_of_dropped(table: CsvTable, good: Flags, wanted: Sequence[str]) -> None:
    """Warn of rows that are not numbers; raise ValueError if they are too many."""
    dropped = np.sort(np.concatenate([table.dropped, table.lines[~good]]))
    if not len(dropped):
        return
    if len(dropped) > _MOST_DROPPED * (len(dropped) + np.count_nonzero(good)):
        raise ValueError(f"{table.source}: line {dropped[0]}: no row of numbers; check delimiter and decimal")
    warn(
        f"{table.source}: rows without numbers ({line_ranges(dropped)}); they are not used; complete them",
        TrajectoryWarning,
    )


def line_ranges(lines: Lines, most: int = 8) -> str:
    """Format line numbers such as ``lines 3, 7-9 and 5 more``."""
    breaks = np.flatnonzero(np.diff(lines) > 1)
    first, last = lines[np.r_[0, breaks + 1]], lines[np.r_[breaks, len(lines) - 1]]
    texts = [f"{a}" if a == b else f"{a}-{b}" for a, b in zip(first, last, strict=True)]
    more = f" and {len(texts) - most} more places" if len(texts) > most else ""
    return f"line{'s' if len(lines) > 1 else ''} {', '.join(texts[:most])}{more}"


def _increasing(time: Array | None, columns: Mapping[str, Array], lines: Lines, source: str) -> Lines:
    """Return the indices of rows without repeated ones; raise ValueError for times that do not increase."""
    count = len(lines)
    if not count:
        raise ValueError(f"{source}: no rows of numbers below the header; add rows")
    if time is None:
        return np.arange(count)
    again = np.zeros(count, dtype=bool)
    again[1:] = np.diff(time) == 0.0
    for column in columns.values():
        again[1:] &= np.diff(column) == 0.0
    rows = np.flatnonzero(~again)
    late = np.flatnonzero(np.diff(time[rows]) <= 0.0)
    if late.size:
        before, after = (time_text(each) for each in time[rows[late[0] : late[0] + 2]])
        line = lines[rows[late[0] + 1]]
        raise ValueError(
            f"{source}: line {line}: time: {after} follows {before}; sort the rows or drop the line"
        )
    return rows


def _few(names: Sequence[str]) -> str:
    return ", ".join(safe_text(name[:40]) for name in names[:12])


def number_columns(
    table: CsvTable, names: Sequence[str], form: TrajectoryFormat
) -> tuple[Array, Array, tuple[str, ...], list[int]]:
    """Return times (s), columns by name or as given by the format, (n, c), the names, and the lines."""
    cells = [split_unit(form.columns.get(name, name))[0] for name in ("time", *names)]
    for name, cell in zip(("time", *names), cells, strict=True):
        if cell not in table.header:
            raise ValueError(f"{table.source}: no column {name}; name it with columns {name}=HEADER")
    numbers, good = table.columns(cells)
    _warn_of_dropped(table, good, cells)
    unit = form.time_unit or _plain_unit(table.units.get(cells[0], ""), "time") or "s"
    time = numbers[cells[0]] / round(1.0 / UNITS["time_unit"][unit])
    values = np.stack([numbers[cell] for cell in cells[1:]], axis=-1)
    return time, values, tuple(names), table.lines[good].tolist()
