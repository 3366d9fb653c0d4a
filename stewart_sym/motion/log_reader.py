"""Trajectories and forces read from CSV files, with a warning for each doubt about units and rates."""

import dataclasses
import math
import os
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from ..io.array_types import Array
from ..io.extras import need
from ..io.progress import Progress, silent
from ..io.toml_reader import opened
from .even_clock import Clock, even_clock
from .log_rates import SPLINE, as_given, rates_of
from .logs import TrajectoryFormat, need_columns, read_columns, stated_units
from .noise_level import scatter
from .rate_doubts import angular_velocity_doubt, rate_doubts
from .rotation import rotation_about_axes
from .text.unit_row import TIME_UNITS
from .trajectory import (
    DERIVATIVES,
    LOADS,
    LONG_STEPS,
    POSE,
    JointTrajectory,
    Log,
    PoseLog,
    SmoothingOptions,
    Trajectory,
    turn_doubt,
)

QUATERNION = ("t", "q")
_LENGTHS = ("L",)
_LENGTH_DERIVATIVES = ("L_dot", "L_ddot")
FORCES = ("F_1", "F_2", "F_3", "F_4", "F_5", "F_6")
"""Columns of actuator forces."""
CURRENTS = ("current_1", "current_2", "current_3", "current_4", "current_5", "current_6")
"""Columns of the motors' currents."""
# Columns in words.
_KNOWN = (
    "time and either t_x t_y t_z with theta_x theta_y theta_z or q_w q_x q_y q_z, v_*, theta_dot_*, a_*, "
    "theta_ddot_*, or L_1 to L_6, L_dot_*, L_ddot_*; F_ext_*, M_ext_*"
)
_OTHER_NAMES = "; for other names give columns NAME=HEADER,..."
PLAIN = TrajectoryFormat()
AS_SHOWN = SmoothingOptions()


def read_csv(
    path: str | os.PathLike[str], form: TrajectoryFormat = PLAIN, smoothing: SmoothingOptions = AS_SHOWN
) -> Trajectory:
    """Read a trajectory of poses, as ``read_trajectory`` does without regard to a robot.

    Raises ``ValueError`` of one line that names the file and the line or column, and
    ``ImportError`` when an interpolating spline is needed and SciPy is missing.
    """
    found = read_log(path, form, smoothing)
    if isinstance(found, JointTrajectory):
        raise ValueError(f"{found.source}: expected poses, t_* and theta_*, got leg lengths L_1 to L_6")
    return trajectory_from(found)


def read_log(
    path: str | os.PathLike[str],
    form: TrajectoryFormat = PLAIN,
    smoothing: SmoothingOptions = AS_SHOWN,
    progress: Progress = silent,
    check: Callable[[Log], None] = lambda log: None,
) -> PoseLog | JointTrajectory:
    """Read poses as coordinates, or leg lengths, with progress: the header tells which.

    Without derivatives, columns that show rounding or noise are smoothed, with a ``TrajectoryWarning``, and
    all others interpolated by a spline of degree 5 (of degree 3 with 4 or 5 rows); angles are unwrapped
    first. Rows that no motion makes are named and replaced, what this changes counts in ``noise``; rows that
    repeat or interpolate those of a slower sensor don't count; gaps in time are named. Times of an even clock
    that are rounded, such as to milliseconds, are taken from it, with a ``TrajectoryWarning``. ``check`` may
    reject the log before its rates are computed. Raises as ``read_csv``.
    """
    log = _read(path, form, smoothing, progress)
    check(log)
    log = _on_even_clock(log)
    progress(f"differentiating {len(log.rows)} rows")
    return _joint_trajectory(log) if "L" in log.written else _pose_log(log)


def read_poses(
    path: str | os.PathLike[str],
    form: TrajectoryFormat = PLAIN,
    check: Callable[[Log], None] = lambda log: None,
) -> tuple[Array, Array]:
    """Read the poses of a trajectory without its rates: R (n, 3, 3) and t (m), (n, 3).

    ``check`` may reject the log. Raises ValueError of one line as ``read_csv``, and for leg lengths.
    """
    log = _read(path, form, AS_SHOWN, silent)
    check(log)
    _warn_of_angles(log)
    if "L" in log.written:
        raise ValueError(f"{log.source}: expected poses, t_* and theta_*, got leg lengths L_1 to L_6")
    theta, _, order = log.angles()
    return rotation_about_axes(theta, order), log.vector("t")


def _read(
    path: str | os.PathLike[str], form: TrajectoryFormat, smoothing: SmoothingOptions, progress: Progress
) -> Log:
    source = os.fsdecode(path)
    if form.columns:
        _check_header([*form.columns], "columns", "")
    with opened(source, "trajectory") as stream:
        check = partial(_check_log, smoothing=smoothing)
        table = read_columns(stream, source, check, form, progress)
    names = {name.rpartition("_")[0] for name in table.columns} - {""}
    written = {name: [table.columns[c] for c in _components(name)] for name in names}
    units = (table.given_units, table.unit_line)
    return Log(source, table.rows, table.columns["time"], written, table.form, smoothing, *units)


def with_units_of(path: str | os.PathLike[str], form: TrajectoryFormat) -> TrajectoryFormat:
    """The form with all units: given ones, else those of the file's row of units, else SI; a pipe is SI."""
    source = os.fsdecode(path)
    if not os.path.isfile(source):
        return form.with_units({})
    with opened(source, "trajectory") as stream:
        return form.with_units(stated_units(stream, source, form))


# Times the scatter of numbers under other times from which on these are wrong.
_CLEARLY = 1.5


def _on_even_clock(log: Log) -> Log:
    """The log with the times of an even clock where these are rounded, with a warning."""
    clock, doubt = _clock(
        log.time, np.stack([column for each in log.written.values() for column in each], -1)
    )
    if doubt is not None:
        log.warn(f"time: {doubt}")
    return log if clock is None else dataclasses.replace(log, time=clock.times)


def _clock(time: Array, columns: Array) -> tuple[Clock | None, str | None]:
    """The even clock from which times, (n,), of columns, (n, c), are rounded, and a warning in words.

    Where rows of a faster clock may be missing instead, the times count under which the numbers scatter less.
    """
    clock = even_clock(time)
    if clock is None:
        return None, None
    rounded, step = (f"{1e3 * number:.6g} ms" for number in (clock.rounded, clock.step))
    text = f"rounded to {rounded}: rows are taken every {step}"
    if clock.chance:
        moving = columns[:, np.ptp(columns, axis=0) > 0.0]
        even, written = (scatter(each, moving) for each in (clock.times, time))
        more = float(np.median(even / np.maximum(written, np.finfo(float).tiny))) if moving.size else 1.0
        if more > _CLEARLY:
            return None, None
        if not clock.sure and more > 1.0 / _CLEARLY:
            return None, f"steps of {rounded} and twice that: rows missing, or rounded from every {step}?"
    return clock, text


def trajectory_from(log: PoseLog) -> Trajectory:
    """A log of poses as a motion."""
    return Trajectory(log.time, log.motion, log.source, log.rows, log.noise)


def read_leg_columns(
    path: str | os.PathLike[str], form: TrajectoryFormat, groups: Sequence[tuple[str, ...]]
) -> tuple[Array, Array, tuple[str, ...], Sequence[int]]:
    """Read six columns over ``time`` (s), increasing: those of the first group that the file has.

    Other columns, such as the columns of the command ``forces``, are skipped. form: marks, names of the
    columns and, without a row of units, the unit of time. Returns times (n,), the columns (n, 6),
    their names, and the lines of the file. Raises ``ValueError`` that names the file and the line or column.
    """
    source = os.fsdecode(path)
    group = groups[0]

    def check(header: list[str], source: str) -> None:
        nonlocal group
        group = next((each for each in groups if each[0] in header), group)
        wanted = ["time", *group]
        former = next((old for names in groups for old in map(_former, names) if old in header), None)
        if former is not None and group[0] not in header:
            raise ValueError(f"{source}: column {former}: renamed; write {former[:-1]}_{former[-1]}")
        _check_names(header, [*wanted, *header], source)
        need_columns(header, wanted, source)

    with opened(source, "forces") as stream:
        unit = stated_units(stream, source, form).get("time_unit", form.time_unit)
        stream.seek(0)
        form = dataclasses.replace(form, time_unit=unit)
        columns, rows, _, dated, *_ = read_columns(stream, source, check, form)
    if dated:
        raise ValueError(
            f"{source}: line {rows[0]}: time: expected seconds as in the trajectory, of which dates and "
            "times of day are those since its first row"
        )
    # As those of a trajectory with the same times are.
    values = np.stack([columns[name] for name in group], axis=-1)
    clock, _ = _clock(columns["time"], values)
    return columns["time"] if clock is None else clock.times, values, group, rows


def _former(name: str) -> str:
    """Return the former name of a column, without its last underscore."""
    return "".join(name.rsplit("_", 1))


# Accelerations that no platform has, m/s^2, or m/s^2 per meter of a log's lengths where these are larger; and
# the steps, s, of a log of so slow a motion that time must be in milli- or microseconds.
_MOST_ACCELERATION, _LEAST_ACCELERATION = 1e5, 1e-4
_ORDINARY = (0.1, 30.0)
"""Range of the largest acceleration of a moving machine (m/s^2), by which a log's unit of time is certain."""


def _warn_of_angles(log: Log) -> None:
    """Warn of angles that no machine makes, and of quaternions whose scalar seems to come last."""
    if "theta" in log.written:
        doubt = turn_doubt(np.unwrap(log.vector("theta"), axis=0))
        if doubt is not None:
            hint = ": are angles in degrees (angle_unit=deg)?" if log.form.radians_per_unit == 1.0 else ""
            log.warn(f"{doubt}{hint}")
    if "q" in log.written:
        q = np.abs(log.vector("q"))
        if (np.median(q, axis=0) @ (-1.0, 0.0, 0.0, 1.0)) > 0.5 * float(
            np.median(np.linalg.norm(q, axis=-1))
        ):
            log.warn(
                "q_z is the largest component: half a turn about z, or quaternions with the scalar last? "
                "(columns q_w=q_z,q_x=q_w,q_y=q_x,q_z=q_y,...)",
            )


def _warn_of_units(log: Log, coordinates: Array) -> None:
    """Warn of times and lengths, (3, n, 6), that no machine makes."""
    lengths = coordinates[..., : 6 if "L" in log.written else 3]
    largest = float(np.abs(lengths[2]).max())
    # In millimeters lengths and accelerations are a thousand times as large: both tell of time alone.
    unit = max(1.0, float(np.median(np.linalg.norm(lengths[0], axis=-1))))
    step = float(np.median(np.diff(log.time))) if len(log.time) > 1 else 0.0
    moves = float(np.ptp(coordinates[0], axis=0).max()) > 0.0
    slow = [name for name, least in LONG_STEPS.items() if step >= least]
    if largest > _MOST_ACCELERATION * unit:
        hint = (
            "are time or lengths in another unit (time_unit=ms, length_unit=mm)"
            if log.form.time_unit in (None, "s")
            else f"is time in seconds, expected {log.form.time_unit} (time_unit=s)"
        )
    elif moves and slow and largest < _LEAST_ACCELERATION * unit:
        low, high = _ORDINARY
        sure = [name for name in slow if low * unit <= largest / TIME_UNITS[name] ** 2 <= high * unit]
        _need_time_unit(log, sure, f"steps of {step:.4g} s and accelerations of at most {largest:.2g} m/s^2")
        hint = f"is time in another unit (time_unit={slow[-1]})"
    else:
        return
    log.warn(f"steps of {step:.4g} s and accelerations up to {largest:.2g} m/s^2: {hint}?")


def _need_time_unit(log: Log, units: Sequence[str], finding: str) -> None:
    """Raise ValueError with the remedy if numbers fit other units of time and no option gives one."""
    units = [unit for unit in units if unit != log.form.time_unit]
    if units and "time_unit" not in log.given_units:
        raise log.other_unit("time_unit", finding, units)


# How far from a power of 1000 the ratio of changes to rates is where a unit is wrong: decades.
_NEAR_UNIT = 0.2


def _warn_of_rates(log: Log, coordinates: Array, names: Sequence[str]) -> None:
    """Warn of given rates, (3, n, 6), that differ from what coordinates and times say.

    names: of the coordinates, their rates and their accelerations, two vectors of a pose or one of six legs.
    """
    if not coordinates[1:].any():  # poses at rest
        return
    steps = np.diff(log.time)
    # One column after the other: of a long log, differences of all at once would take half its room again.
    changed = sum(float(np.abs(np.diff(column)).sum()) for column in coordinates[0].T)
    rates = sum(np.abs(column) for column in coordinates[1].T)
    expected = float(0.5 * (rates[1:] + rates[:-1]) @ steps)
    decades = math.log10(changed / expected) if changed and expected else 0.0
    nearest = 3 * round(decades / 3)
    if nearest and abs(decades - nearest) < _NEAR_UNIT:
        unit = {-3: "ms", -6: "us"}.get(nearest)
        finding = f"coordinates change by {changed / expected:.2g} times what their rates say"
        _need_time_unit(log, [unit] if unit else [], finding)
        hint = f"is time in another unit (time_unit={unit})" if unit else "are rates in another unit"
        log.warn(f"{finding}: {hint}?")
        return
    kinds = len(names) // 3
    columns = [_components(*names[kinds * i :][:kinds]) for i in range(3)]
    for _, doubt in rate_doubts(log.time, [*coordinates], columns, 6 // kinds):
        log.warn(doubt)


def _joint_trajectory(log: Log) -> JointTrajectory:
    L = log.vector("L")
    relative = log.form.length_mode == "relative"
    if np.any(L <= 0.0) and not relative:
        i, leg = (int(index) for index in np.argwhere(L <= 0.0)[0])
        raise ValueError(
            f"{log.source}: line {log.rows[i]}: L_{leg + 1}: expected a length > 0 m, got {L[i, leg]:g}"
        )
    if "L_dot" in log.written:
        found = np.stack([L, *map(log.vector, _LENGTH_DERIVATIVES)])
        noise = as_given(log, found, [log.steps(name) for name in ("L", "L_dot", "L_ddot")])
        _warn_of_rates(log, found, (*_LENGTHS, *_LENGTH_DERIVATIVES))
    else:
        found, noise = rates_of(log, L, log.steps("L"))
    noise = None if noise is None else noise._replace(in_joints=True)
    _warn_of_units(log, found)
    F_ext, M_ext = (log.load(name) for name in LOADS)
    L, L_dot, L_ddot = found
    return JointTrajectory(log.time, L, L_dot, L_ddot, F_ext, M_ext, log.source, log.rows, noise, relative)


def _pose_log(log: Log) -> PoseLog:
    _warn_of_angles(log)
    order = "zyx"
    if "v" in log.written:
        order, names = log.form.rotation_order, (*POSE, *DERIVATIVES)
        # Before there are the other numbers: of a long log it takes half their room.
        theta = np.unwrap(log.vector("theta"), axis=0)
        found = np.empty((3, len(log.time), 6))
        found[0, :, 3:] = theta
        del theta
        for i, name in enumerate(names):
            if name != "theta":
                found[i // 2, :, 3 * (i % 2) : 3 * (i % 2) + 3] = log.vector(name)
        steps = [np.concatenate([log.steps(name) for name in names[i : i + 2]]) for i in (0, 2, 4)]
        noise = as_given(log, found, steps)
        doubt = angular_velocity_doubt(log.time, found[0, :, 3:], found[1, :, 3:], order)
        if doubt:
            log.warn(doubt)
        else:
            _warn_of_rates(log, found, names)
    else:
        theta, step, order = log.angles()
        steps_of_pose = np.concatenate([log.steps("t"), step])
        found, noise = rates_of(log, np.hstack([log.vector("t"), theta]), steps_of_pose)
    noise = None if noise is None else noise._replace(order=order)
    _warn_of_units(log, found)
    F_ext, M_ext = (log.load(name) for name in LOADS)
    in_radians = (
        "theta" in log.written and log.form.radians_per_unit == 1.0 and order == log.form.rotation_order
    )
    return PoseLog(log.time, found, F_ext, M_ext, log.source, log.rows, noise, in_radians, order=order)


def _components(*names: str) -> list[str]:
    return [
        f"{name}_{part}"
        for name in names
        for part in (
            "123456" if name in (*_LENGTHS, *_LENGTH_DERIVATIVES) else "wxyz" if name == "q" else "xyz"
        )
    ]


def _check_log(header: list[str], source: str, smoothing: SmoothingOptions) -> None:
    """Reject a header, and rows that nothing will differentiate, before they are read."""
    _check_header(header, source)
    if not smoothing.enabled and not {"v_x", "L_dot_1"} & set(header):
        need("scipy", *SPLINE)


def _check_header(header: list[str], source: str, otherwise: str = _OTHER_NAMES) -> None:
    """Reject names that are no log's; ``source``: what gives them, ``otherwise``: what else can be done."""
    if {"omega_x", "kinetic_energy"} <= set(header):
        raise ValueError(
            f"{source}: expected a log, got a run of simulate (reference point; roll, pitch, yaw); display "
            "it with view, or convert it to the tool and euler_order of the robot"
        )
    in_joints = _components(*_LENGTHS, *_LENGTH_DERIVATIVES)
    of_pose = _components(*POSE, *DERIVATIVES)
    lengths, poses = ([c for c in header if c in known] for known in (in_joints, of_pose))
    if lengths and poses:
        raise ValueError(
            f"{source}: columns {poses[0]} and {lengths[0]}: expected poses or leg lengths, got both"
        )
    # Poses are what a header without any of the two is taken to lack.
    joints = bool(lengths)
    position: tuple[str, ...] = QUATERNION if "q_w" in header else POSE
    derivatives: tuple[str, ...] = () if "q_w" in header else DERIVATIVES
    if joints:
        position, derivatives = _LENGTHS, _LENGTH_DERIVATIVES
    _check_names(header, ["time", *_components(*position, *derivatives, *LOADS)], source, _KNOWN + otherwise)
    required = ["time", *_components(*position)]
    for name in LOADS:
        if any(c in header for c in _components(name)):
            required += _components(name)
    missing = [c for c in _components(*derivatives) if c not in header]
    if missing and len(missing) < len(_components(*derivatives)):
        kept = ",".join(f"{name}={name}" for name in required)
        remedy = f": columns {kept} reads none" if otherwise else ""
        raise ValueError(
            f"{source}: missing column {missing[0]}: expected velocities and accelerations "
            f"({', '.join(derivatives)}) all, or none of them{remedy}"
        )
    need_columns(header, required, source)


def _check_names(header: list[str], known: list[str], source: str, expected: str = "") -> None:
    """Reject columns that are not known, with what is expected in words, or that are given twice."""
    for column in header:
        if column not in known:
            raise ValueError(f"{source}: unknown column {column[:40]!r}, expected {expected}")
        if header.count(column) > 1:
            name = column if column.isprintable() and len(column) <= 40 else repr(column[:40])
            raise ValueError(f"{source}: column {name} is given twice")
