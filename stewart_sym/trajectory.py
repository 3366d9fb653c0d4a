"""Motions as functions of time: the paper's straight-line paths, (39), (40), and trajectories read from CSV.

Stands above ``Motion``, which it makes, and below the studies and the command line.  Knows nothing of robots,
forces or backends; SciPy is needed only to differentiate a trajectory that comes without derivatives.
"""

from __future__ import annotations

import array
import csv
import io
import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .checks import real_array, shown
from .extras import needed_for
from .motion import Motion
from .rotation import rpy_from_rotation
from .tables import file_name, number, read_text

Array = NDArray[np.float64]
Vector = tuple[float, float, float]

# Times that differ by rounding only are the same time: share of tau_f.
_ROUNDING = 1e-12
# Ten million instants take up a gigabyte as motions do.
_MOST_STEPS = 10_000_000
# Of a CSV file; more than two million rows with everything in them.
_MOST_BYTES = 1 << 30


# Straight lines with parabolic blends


@dataclass(frozen=True)
class StraightLinePath:
    """A straight line in position and in roll-pitch-yaw angles, linear in time with parabolic blends.

    Position and angles each speed up with constant acceleration, go at constant speed and slow down; both
    start at 0 and end at tau_f, (39), (40).

    t0, t1: first and last position of the reference point, m, base frame.
    theta0, theta1: first and last angles (theta_x, theta_y, theta_z), rad.
    tau_f: duration, s.
    V, Omega: top speed of position, m/s, and of the vector of angles, rad/s.  Each must lie in
        (d/tau_f, 2 d/tau_f] for its distance d; where d = 0 that part rests and its speed is not used.

    Raises ``ValueError`` naming the argument; for V and Omega it says which range works.
    """

    t0: Vector
    theta0: Vector
    t1: Vector
    theta1: Vector
    tau_f: float
    V: float
    Omega: float

    def __post_init__(self) -> None:
        """Check every argument."""
        for field in fields(self):
            value = getattr(self, field.name)
            vector = field.name in ("t0", "theta0", "t1", "theta1")
            object.__setattr__(
                self, field.name, _triple(value, field.name) if vector else number(value, field.name)
            )
        if self.tau_f <= 0.0:
            raise ValueError(f"tau_f: expected a duration > 0 s, got {self.tau_f:g}")
        _check_speed("V", self.V, self.distance, self.tau_f, "m/s")
        _check_speed("Omega", self.Omega, self.angle, self.tau_f, "rad/s")

    @property
    def distance(self) -> float:
        """Length of the line of positions, m."""
        return math.dist(self.t0, self.t1)

    @property
    def angle(self) -> float:
        """Length of the line of angles, rad."""
        return math.dist(self.theta0, self.theta1)

    @property
    def tau_t(self) -> float:
        """Duration of each blend of the position, s, (39); 0 when the position rests."""
        return _blend(self.distance, self.V, self.tau_f)

    @property
    def tau_theta(self) -> float:
        """Duration of each blend of the angles, s, as (39); 0 when the angles rest."""
        return _blend(self.angle, self.Omega, self.tau_f)

    def breaks(self) -> Array:
        """Return the sorted times, s, at which an acceleration jumps, with 0 and tau_f."""
        times = {0.0, self.tau_f}
        for distance, blend in ((self.distance, self.tau_t), (self.angle, self.tau_theta)):
            if distance > 0.0:
                times |= {blend, self.tau_f - blend}
        distinct: list[float] = []
        for time in sorted(times):
            if not distinct or time - distinct[-1] > _ROUNDING * self.tau_f:
                distinct.append(time)
        return np.array([*distinct[:-1], self.tau_f])

    def times(self, dtau: float) -> Array:
        """Return the times 0, dtau, 2 dtau, ... s, and tau_f as the last; at most ten million steps."""
        dtau = number(dtau, "dtau")
        if not 0.0 < dtau <= self.tau_f * (1.0 + _ROUNDING):
            raise ValueError(f"dtau: expected a step > 0 and <= tau_f = {self.tau_f:g} s, got {dtau:g}")
        if self.tau_f > _MOST_STEPS * dtau:
            raise ValueError(
                f"dtau: expected at most {_MOST_STEPS:,} steps, so {self.tau_f / _MOST_STEPS:g} s or more, "
                f"got {dtau:g}"
            )
        steps = round(self.tau_f / dtau)
        if math.isclose(steps * dtau, self.tau_f, rel_tol=1e-9):
            return np.arange(steps + 1) * self.tau_f / steps
        return np.append(np.arange(math.floor(self.tau_f / dtau) + 1) * dtau, self.tau_f)

    def sample(self, tau: ArrayLike) -> Motion:
        """Return the motion at times tau, s, of any shape; no external load.

        Where an acceleration jumps, the value is the one that follows, at tau_f the one before.  Raises
        ``ValueError`` when a time lies outside [0, tau_f].
        """
        time = self._checked(tau)
        t, v, a = _line(self.t0, self.t1, self.distance, self.V, self.tau_t, self.tau_f, time)
        theta, theta_dot, theta_ddot = _line(
            self.theta0, self.theta1, self.angle, self.Omega, self.tau_theta, self.tau_f, time
        )
        return Motion.from_rpy(t, theta, v, theta_dot, a, theta_ddot)

    def _checked(self, tau: ArrayLike) -> Array:
        time = real_array(tau, "tau", "times")
        slack = _ROUNDING * self.tau_f
        outside = ~((time >= -slack) & (time <= self.tau_f + slack))
        if np.any(outside):
            raise ValueError(f"tau: expected times in [0, {self.tau_f:g}] s, got {time[outside][0]:g}")
        return np.clip(time, 0.0, self.tau_f)


def _check_speed(name: str, speed: float, distance: float, tau_f: float, unit: str) -> None:
    if distance == 0.0:
        return
    low, high = distance / tau_f, 2.0 * distance / tau_f
    if not low * (1.0 + _ROUNDING) < speed <= high * (1.0 + _ROUNDING):
        kind = "small" if speed <= high else "large"
        raise ValueError(
            f"{name}: {speed:g} {unit} is too {kind} for tau_f = {tau_f:g} s, "
            f"expected more than {low:.6g} and at most {high:.6g} {unit}"
        )


def _blend(distance: float, speed: float, tau_f: float) -> float:
    return min(tau_f - distance / speed, 0.5 * tau_f) if distance > 0.0 else 0.0


def _line(
    start: Vector, end: Vector, distance: float, speed: float, blend: float, tau_f: float, time: Array
) -> tuple[Array, Array, Array]:
    """Return the coordinates and their first and second derivatives, each (..., 3)."""
    origin = np.array(start)
    if distance == 0.0:
        zero = np.zeros((*time.shape, 3))
        return origin + zero, zero, zero
    direction = (np.array(end) - origin) / distance
    acceleration = speed / blend
    left = tau_f - time
    rounding = _ROUNDING * tau_f
    ending = left <= blend + rounding
    starting = ~ending & (time < blend - rounding)
    phases = [starting, ending]
    x = np.select(
        phases,
        [0.5 * acceleration * time**2, -0.5 * acceleration * left**2],
        speed * (time - 0.5 * blend),
    )
    x_dot = np.select(phases, [acceleration * time, acceleration * left], speed)
    x_ddot = np.select(phases, [acceleration, -acceleration], 0.0)
    # Measured from the end that is near, both end values come out exact.
    from_end = x[..., None] * direction
    coordinates = np.where(ending[..., None], np.array(end), origin) + from_end
    return coordinates, x_dot[..., None] * direction, x_ddot[..., None] * direction


def _triple(value: object, name: str) -> Vector:
    items = value.tolist() if isinstance(value, np.ndarray) else value
    if not isinstance(items, list | tuple) or len(items) != 3:
        raise ValueError(f"{name}: expected three numbers, got {shown(value)}")
    x, y, z = (number(item, name) for item in items)
    return x, y, z


class PaperPath(NamedTuple):
    """A path of the paper's section 5 and its time step dtau, s."""

    path: StraightLinePath
    dtau: float


PATHS: Mapping[str, PaperPath] = MappingProxyType(
    {
        "I": PaperPath(
            StraightLinePath(
                (0.1, 0.0, 0.4),
                (0.0, 0.0, -0.2),
                (0.3, 0.0, 0.6),
                (0.0, 0.0, 0.2),
                tau_f=6.0,
                V=0.08,
                Omega=0.08,
            ),
            dtau=0.1,
        ),
        "II": PaperPath(
            StraightLinePath(
                (0.1, 0.0, 0.4),
                (0.0, 0.0, -0.2),
                (0.3, 0.0, 0.6),
                (0.0, 0.0, 0.2),
                tau_f=0.6,
                V=0.8,
                Omega=0.8,
            ),
            dtau=0.01,
        ),
        "III": PaperPath(
            StraightLinePath(
                (0.4, 1.4, 1.2),
                (0.1, 0.2, 0.0),
                (0.8, 1.8, 1.8),
                (0.3, 0.4, 0.0),
                tau_f=6.0,
                V=0.2,
                Omega=0.08,
            ),
            dtau=0.1,
        ),
    }
)
"""Paths I, II and III of section 5."""


# Trajectories from CSV

_POSE = ("t", "theta")
_DERIVATIVES = ("v", "theta_dot", "a", "theta_ddot")
_LENGTHS = ("L",)
_LENGTH_DERIVATIVES = ("L_dot", "L_ddot")
_LOADS = ("F_ext", "M_ext")
_MIN_SPLINE_POINTS = 4


class Trajectory(NamedTuple):
    """A trajectory of n instants: time, s, (n,), and the motion, of shape (n,).

    source: the file it comes from. rows: where in it the instants stand; the header is row 1.
    """

    time: Array
    motion: Motion
    source: str
    rows: tuple[int, ...]


class JointTrajectory(NamedTuple):
    """A trajectory in joint space of n instants: time, s, (n,), and the legs' motion, (n, 6) each.

    L, L_dot, L_ddot: lengths, m, rates, m/s, and accelerations, m/s^2. F_ext, M_ext: external load, N and
    N m, platform frame, (n, 3), or None. source, rows: as in ``Trajectory``.
    """

    time: Array
    L: Array
    L_dot: Array
    L_ddot: Array
    F_ext: Array | None
    M_ext: Array | None
    source: str
    rows: tuple[int, ...]


def read_csv(path: str | os.PathLike[str]) -> Trajectory:
    """Read a trajectory of poses: a header line that names the columns, then one row per instant.

    Columns, in any order: ``time`` (s), increasing; ``t_x t_y t_z`` (m) and ``theta_x theta_y theta_z`` (rad,
    (38)); optionally all of ``v_*``, ``theta_dot_*``, ``a_*`` and ``theta_ddot_*``; optionally ``F_ext_*``
    (N) and ``M_ext_*`` (N m), platform frame.  Derivatives that are not given are those of an interpolating
    spline of degree 5 (of degree 3 with 4 or 5 rows); the angles are unwrapped first.

    Raises ``ValueError`` of one line that names the file and the row (the header is row 1) or column, and
    ``ImportError`` when a spline is needed and SciPy is missing.
    """
    found = read_any_csv(path)
    if isinstance(found, JointTrajectory):
        raise ValueError(f"{found.source}: expected poses, t_* and theta_*, got leg lengths L_1 to L_6")
    return found


def read_any_csv(path: str | os.PathLike[str]) -> Trajectory | JointTrajectory:
    """Read a trajectory of poses, as ``read_csv``, or of leg lengths: the header tells which it is.

    Columns of the latter: ``time``; ``L_1`` to ``L_6`` (m); optionally all of ``L_dot_*`` and ``L_ddot_*``,
    else those of a spline; optionally loads.  Raises as ``read_csv``.
    """
    source = file_name(path)
    columns, rows = _columns(read_text(source, "trajectory", _MOST_BYTES), source)
    loads = {name: _stack(columns, name) for name in _LOADS if f"{name}_x" in columns}
    if "L_1" in columns:
        return _joint_trajectory(columns, loads, source, rows)
    return _pose_trajectory(columns, loads, source, rows)


def read_forces_csv(path: str | os.PathLike[str]) -> tuple[Array, Array]:
    """Read actuator forces over time: columns ``time`` (s), increasing, and ``F1`` to ``F6`` (N).

    Other columns, such as those that the command ``forces`` writes, are read over. Returns times (n,) and
    forces (n, 6). Raises ``ValueError`` of one line that names the file and the row or column.
    """
    source = file_name(path)
    wanted = ["time", *(f"F{leg}" for leg in range(1, 7))]

    def check(header: list[str], source: str) -> None:
        _check_names(
            header, [*wanted, *(name for name in header if ";" not in name and "\t" not in name)], source
        )
        for column in wanted:
            if column not in header:
                raise ValueError(f"{source}: missing column {column}")

    columns, _ = _columns(read_text(source, "forces", _MOST_BYTES), source, check)
    return columns["time"], np.stack([columns[name] for name in wanted[1:]], axis=-1)


def _joint_trajectory(
    columns: Mapping[str, Array], loads: Mapping[str, Array], source: str, rows: tuple[int, ...]
) -> JointTrajectory:
    time, L = columns["time"], _stack(columns, "L")
    if np.any(L <= 0.0):
        i, leg = (int(index) for index in np.argwhere(L <= 0.0)[0])
        raise ValueError(f"{source}: row {rows[i]}: L_{leg + 1}: expected a length > 0 m, got {L[i, leg]:g}")
    if "L_dot_1" in columns:
        L_dot, L_ddot = (_stack(columns, name) for name in _LENGTH_DERIVATIVES)
    else:
        L_dot, L_ddot = _differentiate(time, L, source)
    return JointTrajectory(time, L, L_dot, L_ddot, loads.get("F_ext"), loads.get("M_ext"), source, rows)


def _pose_trajectory(
    columns: Mapping[str, Array], loads: Mapping[str, Array], source: str, rows: tuple[int, ...]
) -> Trajectory:
    time = columns["time"]
    pose = {name: _stack(columns, name) for name in _POSE}
    if "v_x" in columns:
        derivatives = {name: _stack(columns, name) for name in _DERIVATIVES}
    else:
        v, a = _differentiate(time, pose["t"], source)
        theta_dot, theta_ddot = _differentiate(time, np.unwrap(pose["theta"], axis=0), source)
        derivatives = {"v": v, "theta_dot": theta_dot, "a": a, "theta_ddot": theta_ddot}
    numbers = {**pose, **derivatives, **loads}
    try:
        motion = Motion.from_rpy(**numbers)
    except ValueError as error:
        raise ValueError(f"{source}: {_first_bad_row(numbers, rows)}{error}") from None
    return Trajectory(time, motion, source, rows)


def _first_bad_row(numbers: Mapping[str, Array], rows: Sequence[int]) -> str:
    """Name the first row that makes no motion by itself, as a prefix."""
    for i, row in enumerate(rows):
        try:
            Motion.from_rpy(**{name: values[i] for name, values in numbers.items()})
        except ValueError:
            return f"row {row}: "
    return ""


def _columns(
    text: str, source: str, check_header: Callable[[list[str], str], None] | None = None
) -> tuple[dict[str, Array], tuple[int, ...]]:
    """Return the checked columns of a CSV text by name, and the rows where their numbers stand.

    check_header: refuses a header, given the name of the file; None for that of a trajectory.
    """
    reader = csv.reader(io.StringIO(text, newline=""), skipinitialspace=True)
    header: list[str] | None = None
    # Row after row and as numbers at once: the cells of a long file would take ten times its size.
    numbers, rows = array.array("d"), array.array("q")
    try:
        for cells in reader:
            if not any(cell.strip() for cell in cells):
                continue
            if header is None:
                header = [cell.strip() for cell in cells]
                (check_header or _check_header)(header, source)
                continue
            rows.append(reader.line_num)
            numbers.extend(_row(cells, header, f"{source}: row {reader.line_num}: "))
    except csv.Error as error:
        raise ValueError(f"{source}: row {reader.line_num}: not valid CSV: {error}") from None
    if header is None:
        raise ValueError(f"{source}: the file is empty, expected a header line that names the columns")
    if not rows:
        raise ValueError(f"{source}: expected rows of numbers below the header, got none")
    table = np.array(numbers).reshape(len(rows), len(header))
    columns = dict(zip(header, table.T, strict=True))
    late = np.flatnonzero(np.diff(columns["time"]) <= 0.0)
    if late.size:
        i = int(late[0])
        before, after = columns["time"][i], columns["time"][i + 1]
        raise ValueError(
            f"{source}: row {rows[i + 1]}: time: expected increasing times, got {after:g} after {before:g}"
        )
    return columns, tuple(rows)


def _row(cells: list[str], header: list[str], where: str) -> list[float]:
    if len(cells) != len(header):
        raise ValueError(f"{where}expected {len(header)} columns, got {len(cells)}")
    return [_cell(cell.strip(), where + name) for cell, name in zip(cells, header, strict=True)]


def _cell(text: str, where: str) -> float:
    try:
        found = float(text) if "_" not in text else math.nan
    except ValueError:
        found = math.nan
    if not math.isfinite(found):
        raise ValueError(f"{where}: expected a finite number, got {text[:40]!r}")
    return found


def _components(*names: str) -> list[str]:
    return [
        f"{name}_{part}"
        for name in names
        for part in ("123456" if name in (*_LENGTHS, *_LENGTH_DERIVATIVES) else "xyz")
    ]


def _check_header(header: list[str], source: str) -> None:
    in_joints = _components(*_LENGTHS, *_LENGTH_DERIVATIVES)
    of_pose = _components(*_POSE, *_DERIVATIVES)
    # Poses are what a header without any of the two is taken to lack.
    joints = any(c in in_joints for c in header) and not any(c in of_pose for c in header)
    position, derivatives = (_LENGTHS, _LENGTH_DERIVATIVES) if joints else (_POSE, _DERIVATIVES)
    _check_names(header, ["time", *_components(*position, *derivatives, *_LOADS)], source)
    missing = [c for c in _components(*derivatives) if c not in header]
    if missing and len(missing) < len(_components(*derivatives)):
        raise ValueError(
            f"{source}: missing column {missing[0]}: "
            f"expected velocities and accelerations ({', '.join(derivatives)}) all, or none of them"
        )
    required = ["time", *_components(*position)]
    for name in _LOADS:
        if any(c in header for c in _components(name)):
            required += _components(name)
    for column in required:
        if column not in header:
            raise ValueError(f"{source}: missing column {column}")


def _check_names(header: list[str], known: list[str], source: str) -> None:
    """Refuse columns that are not known or given twice."""
    for column in header:
        if column not in known:
            for other, name in ((";", "semicolons"), ("\t", "tabs")):
                if other in column:
                    raise ValueError(f"{source}: expected commas between the columns, got {name}")
            raise ValueError(f"{source}: unknown column {column[:40]!r}, expected some of {', '.join(known)}")
        if header.count(column) > 1:
            name = column if column.isprintable() and len(column) <= 40 else repr(column[:40])
            raise ValueError(f"{source}: column {name} is given twice")


def _stack(columns: Mapping[str, Array], name: str) -> Array:
    return np.stack([columns[c] for c in _components(name)], axis=-1)


def interpolated(trajectory: Trajectory) -> Callable[[float], Motion]:
    """A trajectory as a motion at any time since its first instant, s: at rest at its last pose afterwards.

    Positions and unwrapped angles (38) are interpolated by splines, of degree 5 (of degree 3 with 4 or 5
    rows); given derivatives and loads don't count.  Raises as ``read_csv`` where a spline is needed.
    """
    since = trajectory.time - trajectory.time[0]
    theta = np.unwrap(rpy_from_rotation(trajectory.motion.R), axis=0)
    spline = _spline(since, np.hstack([trajectory.motion.t, theta]), trajectory.source)
    end = float(since[-1])

    def motion(time: float) -> Motion:
        at = min(max(time, 0.0), end)
        pose, rate, second = (
            np.asarray(spline(at, order)) * (order == 0 or time < end) for order in range(3)
        )
        return Motion.from_rpy(*(half for x in (pose, rate, second) for half in (x[:3], x[3:])))

    return motion


def _differentiate(time: Array, values: Array, source: str) -> tuple[Array, Array]:
    """Return first and second derivatives of the interpolating spline at its own points."""
    since = time - time[0]
    spline = _spline(since, values, source)
    return np.asarray(spline(since, 1)), np.asarray(spline(since, 2))


def _spline(since: Array, values: Array, source: str) -> Callable[..., Array]:
    if len(since) < _MIN_SPLINE_POINTS:
        raise ValueError(
            f"{source}: expected at least {_MIN_SPLINE_POINTS} rows to fit a spline, got {len(since)}; "
            "add rows, or columns with velocities and accelerations"
        )
    degree = 5 if len(since) > 5 else 3
    try:
        return _spline_maker()(since, values, k=degree)
    except (ValueError, np.linalg.LinAlgError) as error:
        raise ValueError(f"{source}: no spline fits these times: {' '.join(str(error).split())}") from None


def _spline_maker() -> Callable[..., Callable[..., Array]]:
    with needed_for("a trajectory without derivatives"):
        from scipy.interpolate import make_interp_spline
    return make_interp_spline  # type: ignore[no-any-return]
