"""Motions as functions of time: the paper's straight-line paths, (39), (40), and trajectories from CSV."""

from __future__ import annotations

import dataclasses
import itertools
import math
import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import partial
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import finite_array, instance, real_array, shown
from ..io.extras import need, needed_for
from ..io.tables import file_name, number, opened
from .log_faults import Fault, faults, offsets
from .log_sampling import slower_sampling, spread
from .logs import ANGLE_UNITS, LENGTH_UNITS, LogFormat, read_columns
from .motion import Motion
from .rotation import rotation_about_axes, rotation_from_quaternion, rpy_from_rotation
from .smoothing import PAIRS, Level, LogWarning, noise_level, rounding_step, smoothed, stated

Array = NDArray[np.float64]
Vector = tuple[float, float, float]
Rows = tuple[Vector, Vector, Vector]

# Times that differ by rounding only are the same time: share of tau_f.
_ROUNDING = 1e-12
# Ten million instants take up a gigabyte as motions do.
MOST_STEPS = 10_000_000
# Of a CSV file; more than two million rows with everything in them.
_MOST_BYTES = 1 << 30


# Straight lines with parabolic blends


@dataclass(frozen=True)
class StraightLinePath:
    """A straight line in position and in roll-pitch-yaw angles, linear in time with parabolic blends.

    Position and angles each speed up with constant acceleration, go at constant speed and slow down; both
    start at 0 and end at tau_f, (39), (40).

    Attributes
    ----------
    t0, t1 : tuple of float
        First and last position of the reference point, m, base frame.
    theta0, theta1 : tuple of float
        First and last angles (theta_x, theta_y, theta_z), rad.
    tau_f : float
        Duration, s.
    V, Omega : float
        Top speed of position, m/s, and of the vector of angles, rad/s. Each must lie in (d/tau_f, 2 d/tau_f]
        for its distance d; where d = 0 that part rests and its speed is not used.
    axes : Rows, optional
        Rotation, by rows, from the axes of position and angles to those of base and platform.

    Raises
    ------
    ValueError
        Naming the argument; for V and Omega it says which range works.
    """

    t0: Vector
    theta0: Vector
    t1: Vector
    theta1: Vector
    tau_f: float
    V: float
    Omega: float
    axes: Rows = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

    def __post_init__(self) -> None:
        """Check every argument."""
        for field in fields(self)[:-1]:
            value = getattr(self, field.name)
            vector = field.name in ("t0", "theta0", "t1", "theta1")
            object.__setattr__(
                self, field.name, _triple(value, field.name) if vector else number(value, field.name)
            )
        axes = finite_array(self.axes, (3, 3), "axes")
        if (
            axes.shape != (3, 3)
            or np.abs(axes @ axes.T - np.eye(3)).max() > 1e-9
            or np.linalg.det(axes) < 0.0
        ):
            raise ValueError(f"axes: expected a rotation (3, 3), got {shown(self.axes)}")
        object.__setattr__(self, "axes", tuple(tuple(row) for row in axes.tolist()))
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
        if self.tau_f > MOST_STEPS * dtau:
            raise ValueError(
                f"dtau: expected at most {MOST_STEPS:,} steps, so {self.tau_f / MOST_STEPS:g} s or more, "
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
        motion = Motion.from_rpy(t, theta, v, theta_dot, a, theta_ddot)
        Q = np.array(self.axes)
        return motion if np.array_equal(Q, np.eye(3)) else motion.in_axes(Q)

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
_QUATERNION = ("t", "q")
_DERIVATIVES = ("v", "theta_dot", "a", "theta_ddot")
_LENGTHS = ("L",)
_LENGTH_DERIVATIVES = ("L_dot", "L_ddot")
_LOADS = ("F_ext", "M_ext")
FORCES = ("F1", "F2", "F3", "F4", "F5", "F6")
"""Columns of actuator forces."""
# Columns in words.
_KNOWN = (
    "time and either t_x t_y t_z with theta_x theta_y theta_z or q_w q_x q_y q_z, v_*, theta_dot_*, a_*, "
    "theta_ddot_*, or L_1 to L_6, L_dot_*, L_ddot_*; F_ext_*, M_ext_*; for other names give "
    "--columns NAME=HEADER,..."
)
_MIN_SPLINE_POINTS = 4
# What needs SciPy, and what helps without.
_SPLINE = ("a trajectory without derivatives", ", or add columns of all velocities and accelerations")
_PART = 1 << 14
_ANGLES = ("theta", "theta_dot", "theta_ddot")
_PLAIN = LogFormat()


@dataclass(frozen=True)
class Smoothing:
    """What is known of a log's noise, and what is done about it.

    Attributes
    ----------
    position, angle : float, optional
        Standard deviation of each coordinate, m and rad; leg lengths count as positions. None: as the
        decimals and the scatter of the numbers show.
    cutoff : float, optional
        Frequency, Hz, at which the amplitude is halved; None: the likeliest.
    on : bool, optional
        False interpolates whatever the noise.

    Raises
    ------
    ValueError
        Naming the argument.
    """

    position: float | None = None
    angle: float | None = None
    cutoff: float | None = None
    on: bool = True

    def __post_init__(self) -> None:
        """Check the numbers."""
        for name in ("position", "angle", "cutoff"):
            if getattr(self, name) is not None and number(getattr(self, name), name) <= 0.0:
                raise ValueError(f"{name}: expected a number > 0, got {getattr(self, name):g}")

    def stated(self, name: str) -> float | None:
        """What is stated of ``t``, ``theta`` or ``L``."""
        return self.angle if name == "theta" else self.position


_AS_SHOWN = Smoothing()


class Replaced(NamedTuple):
    """A span of time, s, in which deviations hold what replaced rows change, and how a line names these."""

    start: float
    end: float
    rows: tuple[str, ...]


class Uncertainty(NamedTuple):
    """What the noise of a log leaves open about six coordinates: t and theta, or leg lengths.

    coordinates: values, rates and second rates, (3, n, 6). grid: times, s, (g,), at which covariance,
    (g, 6, 6), is given: of value, rate and second rate, the lower triangle row by row. sigma: standard
    deviation of the log's numbers, (6,). in_joints: whether these are leg lengths. replaced: rows that are
    not as the log has them; covariance holds by how much.
    """

    coordinates: Array
    grid: Array
    covariance: Array
    sigma: Array
    in_joints: bool = False
    replaced: tuple[Replaced, ...] = ()

    def variances(self, time: Array) -> Array:
        """Of each coordinate's value at times, (n, 6)."""
        return np.stack(
            [np.interp(time, self.grid, column) for column in self.covariance[:, :, 0].T], axis=-1
        )


class Trajectory(NamedTuple):
    """A trajectory of n instants: time, s, (n,), and the motion, of shape (n,).

    source: the file it comes from. rows: where in it the instants stand; the header is row 1. noise: None for
    a log without.
    """

    time: Array
    motion: Motion
    source: str
    rows: Sequence[int]
    noise: Uncertainty | None = None

    def at(self, index: slice | NDArray[np.int64]) -> Motion:
        """The motion at some of the instants."""
        m = self.motion
        arrays = (m.R, m.t, m.omega, m.v, m.alpha, m.a, m.F_ext, m.M_ext)
        return Motion.unchecked(*(None if x is None else x[index] for x in arrays))  # type: ignore[arg-type]


class PoseLog(NamedTuple):
    """A trajectory as coordinates, whose motion is made where it is needed: a third of the room.

    coordinates: t and theta, (38), with rates and second rates, (3, n, 6). F_ext, M_ext: external load, N and
    N m, platform frame, (n, 3), or None. in_radians: whether theta are the log's own numbers. The rest as in
    ``Trajectory``.
    """

    time: Array
    coordinates: Array
    F_ext: Array | None
    M_ext: Array | None
    source: str
    rows: Sequence[int]
    noise: Uncertainty | None = None
    in_radians: bool = False

    def at(self, index: slice | NDArray[np.int64]) -> Motion:
        """The motion at some of the instants; ValueError of one line that names file and row."""
        numbers = _numbers(self.coordinates[:, index]) | {
            name: load[index]
            for name, load in (("F_ext", self.F_ext), ("M_ext", self.M_ext))
            if load is not None
        }
        try:
            return Motion.from_rpy(**numbers)
        except ValueError as error:
            row = _first_bad_row(numbers, np.asarray(self.rows)[index])
            raise ValueError(f"{self.source}: {row}{error}") from None

    @property
    def motion(self) -> Motion:
        """The motion at all instants."""
        return self.at(slice(None))


def need_trajectory(value: object) -> None:
    """Reject, by ValueError, what is neither a Trajectory nor a PoseLog."""
    if not isinstance(value, PoseLog):
        instance(value, Trajectory, "trajectory")


class JointTrajectory(NamedTuple):
    """A trajectory in joint space of n instants: time, s, (n,), and the legs' motion, (n, 6) each.

    L, L_dot, L_ddot: lengths, m, rates, m/s, and accelerations, m/s^2. F_ext, M_ext: external load, N and
    N m, platform frame, (n, 3), or None. source, rows, noise: as in ``Trajectory``.
    """

    time: Array
    L: Array
    L_dot: Array
    L_ddot: Array
    F_ext: Array | None
    M_ext: Array | None
    source: str
    rows: Sequence[int]
    noise: Uncertainty | None = None


def read_csv(
    path: str | os.PathLike[str], form: LogFormat = _PLAIN, smoothing: Smoothing = _AS_SHOWN
) -> Trajectory:
    """Read a trajectory of poses: a header line that names the columns, then one row per instant.

    Columns, in any order: ``time`` (s), increasing; ``t_x t_y t_z`` (m) and ``theta_x theta_y theta_z`` (rad,
    (38)) or a quaternion ``q_w q_x q_y q_z``; optionally all of ``v_*``, ``theta_dot_*``, ``a_*`` and
    ``theta_ddot_*``; optionally ``F_ext_*`` (N) and ``M_ext_*`` (N m), platform frame.  Without derivatives,
    columns that show rounding or noise are smoothed, which a ``LogWarning`` tells, and all others
    interpolated by a spline of degree 5 (of degree 3 with 4 or 5 rows); the angles are unwrapped first.
    Rows that no motion makes are named and replaced, what this changes counts in ``noise``; rows that repeat
    or interpolate those of a slower sensor don't count; gaps in time are named.

    form: names, units and marks of the file. smoothing: what is known of the noise.

    Raises ``ValueError`` of one line that names the file and the row (the header is row 1) or column, and
    ``ImportError`` when an interpolating spline is needed and SciPy is missing.
    """
    found = read_any_csv(path, form, smoothing)
    if isinstance(found, JointTrajectory):
        raise ValueError(f"{found.source}: expected poses, t_* and theta_*, got leg lengths L_1 to L_6")
    return found


def read_any_csv(
    path: str | os.PathLike[str], form: LogFormat = _PLAIN, smoothing: Smoothing = _AS_SHOWN
) -> Trajectory | JointTrajectory:
    """Read a trajectory of poses, as ``read_csv``, or of leg lengths: the header tells which it is.

    Columns of the latter: ``time``; ``L_1`` to ``L_6`` (m); optionally all of ``L_dot_*`` and ``L_ddot_*``,
    else those of a spline as for poses; optionally loads.  Raises as ``read_csv``.
    """
    found = read_log(path, form, smoothing)
    return found if isinstance(found, JointTrajectory) else _trajectory(found)


def read_log(
    path: str | os.PathLike[str], form: LogFormat = _PLAIN, smoothing: Smoothing = _AS_SHOWN
) -> PoseLog | JointTrajectory:
    """Read a trajectory as ``read_any_csv``, of poses as coordinates: for long logs."""
    source = file_name(path)
    with opened(source, "trajectory", _MOST_BYTES) as stream:
        columns, rows = read_columns(stream, source, partial(_check_log, smoothing=smoothing), form)
    names = {name.rpartition("_")[0] for name in columns} - {""}
    written = {name: [columns[c] for c in _components(name)] for name in names}
    log = _Log(source, rows, columns["time"], written, form, smoothing)
    return _joint_trajectory(log) if "L" in names else _pose_log(log)


def from_poses(
    time: ArrayLike,
    t: ArrayLike,
    theta: ArrayLike,
    smoothing: Smoothing = _AS_SHOWN,
    source: str = "poses",
) -> Trajectory:
    """Return the trajectory of poses over time, differentiated as those of ``read_csv``.

    time: increasing, s, (n,). t: m, theta: angles of (38), rad, (n, 3). source: name in warnings and errors.
    """
    when = real_array(time, "time")
    if when.ndim != 1 or not len(when) or not (np.diff(when) > 0.0).all():
        raise ValueError(f"time: expected increasing times (n,), got shape {when.shape}")
    poses = {"t": finite_array(t, (3,), "t"), "theta": finite_array(theta, (3,), "theta")}
    for name, values in poses.items():
        if values.shape != (len(when), 3):
            raise ValueError(f"{name}: expected shape ({len(when)}, 3), got {values.shape}")
    written = {name: [*values.T] for name, values in poses.items()}
    return _trajectory(_pose_log(_Log(source, range(len(when)), when, written, smoothing=smoothing)))


def _trajectory(log: PoseLog) -> Trajectory:
    return Trajectory(log.time, log.motion, log.source, log.rows, log.noise)


def read_forces_csv(path: str | os.PathLike[str], form: LogFormat = _PLAIN) -> tuple[Array, Array]:
    """Read actuator forces over time: columns ``time`` (s), increasing, and ``F1`` to ``F6`` (N).

    Other columns, such as those that the command ``forces`` writes, are read over. form: unit of time, marks
    and names of the columns. Returns times (n,) and forces (n, 6). Raises ``ValueError`` of one line that
    names the file and the row or column.
    """
    source = file_name(path)
    wanted = ["time", *FORCES]

    def check(header: list[str], source: str) -> None:
        _check_names(header, [*wanted, *header], source)
        for column in wanted:
            if column not in header:
                raise ValueError(f"{source}: missing column {column}")

    with opened(source, "forces", _MOST_BYTES) as stream:
        columns, _ = read_columns(stream, source, check, form)
    return columns["time"], np.stack([columns[name] for name in FORCES], axis=-1)


@dataclass(frozen=True, eq=False)
class _Log:
    """A trajectory as read: the components of vectors by name, (n,) each, as written."""

    source: str
    rows: Sequence[int]
    time: Array
    written: Mapping[str, Sequence[Array]]
    form: LogFormat = dataclasses.field(default_factory=LogFormat)
    smoothing: Smoothing = dataclasses.field(default_factory=Smoothing)

    def scale(self, name: str) -> float:
        """SI units in the unit in which vectors of that name are written."""
        if name in ("q", *_LOADS):
            return 1.0
        return ANGLE_UNITS[self.form.angle_unit] if name in _ANGLES else LENGTH_UNITS[self.form.length_unit]

    def vector(self, name: str) -> Array:
        """A vector in SI units, (n, 3), (n, 4) or (n, 6)."""
        return np.stack(self.written[name], axis=-1) * self.scale(name)

    def load(self, name: str) -> Array | None:
        """An external force or moment, (n, 3)."""
        return self.vector(name) if name in self.written else None

    def steps(self, name: str) -> Array:
        """Steps to which the components are rounded, SI units; those that stay the same have the finest."""
        moving = [values for values in self.written[name] if np.ptp(values) > 0.0]
        finest = min(map(rounding_step, moving), default=0.0)
        return np.full(len(self.written[name]), finest) * self.scale(name)

    def angles(self) -> tuple[Array, Array]:
        """Angles of (38), unwrapped, rad, (n, 3), and the steps to which they are rounded, (3,)."""
        if "q" in self.written:
            q = self.vector("q")
            norms = np.linalg.norm(q, axis=-1)
            if (norms == 0.0).any():
                row = self.rows[int(np.argmin(norms))]
                raise ValueError(f"{self.source}: row {row}: q: expected a quaternion, got length 0")
            theta = rpy_from_rotation(rotation_from_quaternion(q))
            # The vector of a small rotation is twice that of its quaternion.
            step = np.full(3, 2.0 * self.steps("q").max() / float(np.median(norms)))
        else:
            theta, step = self.vector("theta"), self.steps("theta")
            if self.form.euler_order != "zyx":
                theta, step = (
                    rpy_from_rotation(rotation_about_axes(theta, self.form.euler_order)),
                    step.max() + 0 * step,
                )
        return np.unwrap(theta, axis=0), step


MOST_TURNS = (math.pi, math.pi, 2.0 * math.pi)
"""Tilts and turn beyond which no platform goes, rad."""
# Accelerations that no platform has, m/s^2, or m/s^2 per metre of a log's lengths where these are larger; and
# the steps, s, of a log of so slow a motion that time must be in milli- or microseconds.
_MOST_ACCELERATION, _LEAST_ACCELERATION = 1e5, 1e-4
_LONG_STEPS = {"ms": 0.5, "us": 500.0}


def _warn_of_angles(log: _Log) -> None:
    """Warn of angles that no machine makes, and of quaternions whose scalar seems to come last."""
    if "theta" in log.written:
        spans = np.ptp(log.vector("theta"), axis=0) / MOST_TURNS
        axis = int(np.argmax(spans))
        if spans[axis] > 1.0 + 1e-9:
            span = np.ptp(log.vector("theta")[:, axis])
            text = f"theta_{'xyz'[axis]} over {span:.4g} rad: are angles in degrees (--angle-unit deg)?"
            warnings.warn(f"{log.source}: {text}", LogWarning, stacklevel=6)
    if "q" in log.written:
        q = np.abs(log.vector("q"))
        if (np.median(q, axis=0) @ (-1.0, 0.0, 0.0, 1.0)) > 0.5 * float(
            np.median(np.linalg.norm(q, axis=-1))
        ):
            text = (
                "q_z is the largest component: half a turn about z, or quaternions whose scalar comes last?"
            )
            warnings.warn(
                f"{log.source}: {text} (--columns with q_w=q_z,q_x=q_w,q_y=q_x,q_z=q_y)",
                LogWarning,
                stacklevel=6,
            )


def _warn_of_units(log: _Log, coordinates: Array) -> None:
    """Warn of times and lengths, (3, n, 6), that no machine makes."""
    lengths = coordinates[..., : 6 if "L" in log.written else 3]
    largest = float(np.abs(lengths[2]).max())
    # In millimetres lengths and accelerations are a thousand times as large: both tell of time alone.
    unit = max(1.0, float(np.median(np.linalg.norm(lengths[0], axis=-1))))
    step = float(np.median(np.diff(log.time))) if len(log.time) > 1 else 0.0
    moves = float(np.ptp(coordinates[0], axis=0).max()) > 0.0
    slow = [name for name, least in _LONG_STEPS.items() if step >= least]
    if largest > _MOST_ACCELERATION * unit:
        hint = (
            "are time or lengths in another unit (--time-unit, --length-unit mm)"
            if log.form.time_unit == "s"
            else f"is time in seconds, expected {log.form.time_unit} (--time-unit)"
        )
    elif moves and slow and largest < _LEAST_ACCELERATION * unit:
        hint = f"is time in another unit (--time-unit {slow[-1]})"
    else:
        return
    text = f"steps of {step:.4g} s and accelerations up to {largest:.2g} m/s^2: {hint}?"
    warnings.warn(f"{log.source}: {text}", LogWarning, stacklevel=6)


# How far from a power of 1000 the ratio of changes to rates is where a unit is wrong: decades.
_NEAR_UNIT = 0.2


def _warn_of_rates(log: _Log, coordinates: Array) -> None:
    """Warn of given rates, (3, n, 6), that differ by a power of 1000 from what coordinates and times say."""
    steps = np.diff(log.time)
    # One column after the other: of a long log, differences of all at once would take half its room again.
    changed = sum(float(np.abs(np.diff(column)).sum()) for column in coordinates[0].T)
    rates = sum(np.abs(column) for column in coordinates[1].T)
    expected = float(0.5 * (rates[1:] + rates[:-1]) @ steps)
    if changed == 0.0 or expected == 0.0:
        return
    decades = math.log10(changed / expected)
    nearest = 3 * round(decades / 3)
    if nearest and abs(decades - nearest) < _NEAR_UNIT:
        unit = {-3: "ms", -6: "us"}.get(nearest)
        hint = f"is time in another unit (--time-unit {unit})" if unit else "are rates in another unit"
        text = f"coordinates change by {changed / expected:.2g} of what their rates say: {hint}?"
        warnings.warn(f"{log.source}: {text}", LogWarning, stacklevel=6)


def _joint_trajectory(log: _Log) -> JointTrajectory:
    L = log.vector("L")
    if np.any(L <= 0.0):
        i, leg = (int(index) for index in np.argwhere(L <= 0.0)[0])
        raise ValueError(
            f"{log.source}: row {log.rows[i]}: L_{leg + 1}: expected a length > 0 m, got {L[i, leg]:g}"
        )
    if "L_dot" in log.written:
        found = np.empty((3, *L.shape))
        found[0] = L
        for i, name in enumerate(_LENGTH_DERIVATIVES):
            found[i + 1] = log.vector(name)
        noise = _as_given(log, found, [log.steps(name) for name in ("L", "L_dot", "L_ddot")])
        _warn_of_rates(log, found)
    else:
        found, noise = _differentiate(log, L, log.steps("L"))
    noise = None if noise is None else noise._replace(in_joints=True)
    _warn_of_units(log, found)
    F_ext, M_ext = (log.load(name) for name in _LOADS)
    L, L_dot, L_ddot = found
    return JointTrajectory(log.time, L, L_dot, L_ddot, F_ext, M_ext, log.source, log.rows, noise)


def _pose_log(log: _Log) -> PoseLog:
    _warn_of_angles(log)
    theta, step = log.angles()
    steps = np.concatenate([log.steps("t"), step])
    if "v" in log.written:
        found = np.empty((3, len(log.time), 6))
        found[0, :, 3:] = theta
        del theta
        for i, name in ((0, "t"), *((2 + k, name) for k, name in enumerate(_DERIVATIVES))):
            found[i // 2, :, 3 * (i % 2) : 3 * (i % 2) + 3] = log.vector(name)
        rates = [
            np.concatenate([log.steps(one), log.steps(other)])
            for one, other in (_DERIVATIVES[:2], _DERIVATIVES[2:])
        ]
        noise = _as_given(log, found, [steps, *rates])
        _warn_of_rates(log, found)
    else:
        found, noise = _differentiate(log, np.hstack([log.vector("t"), theta]), steps)
    _warn_of_units(log, found)
    F_ext, M_ext = (log.load(name) for name in _LOADS)
    in_radians = "theta" in log.written and log.form.angle_unit == "rad"
    return PoseLog(log.time, found, F_ext, M_ext, log.source, log.rows, noise, in_radians)


def _numbers(coordinates: Array) -> dict[str, Array]:
    """Arguments of ``Motion.from_rpy`` from coordinates and rates, (3, ..., 6)."""
    names = ("t", "theta", *_DERIVATIVES)
    return {name: coordinates[i // 2, ..., 3 * (i % 2) : 3 * (i % 2) + 3] for i, name in enumerate(names)}


def _first_bad_row(numbers: Mapping[str, Array], rows: NDArray[np.int64]) -> str:
    """Name the first row that makes no motion by itself, as a prefix."""
    for i, row in enumerate(rows):
        try:
            Motion.from_rpy(**{name: values[i] for name, values in numbers.items()})
        except ValueError:
            return f"row {row}: "
    return ""


def _components(*names: str) -> list[str]:
    return [
        f"{name}_{part}"
        for name in names
        for part in (
            "123456" if name in (*_LENGTHS, *_LENGTH_DERIVATIVES) else "wxyz" if name == "q" else "xyz"
        )
    ]


def _check_log(header: list[str], source: str, smoothing: Smoothing) -> None:
    """Reject a header, and rows that nothing will differentiate, before they are read."""
    _check_header(header, source)
    if not smoothing.on and not {"v_x", "L_dot_1"} & set(header):
        need("scipy", *_SPLINE)


def _check_header(header: list[str], source: str) -> None:
    in_joints = _components(*_LENGTHS, *_LENGTH_DERIVATIVES)
    of_pose = _components(*_POSE, *_DERIVATIVES)
    lengths, poses = ([c for c in header if c in known] for known in (in_joints, of_pose))
    if lengths and poses:
        raise ValueError(
            f"{source}: columns {poses[0]} and {lengths[0]}: expected poses or leg lengths, got both"
        )
    # Poses are what a header without any of the two is taken to lack.
    joints = bool(lengths)
    position: tuple[str, ...] = _QUATERNION if "q_w" in header else _POSE
    derivatives: tuple[str, ...] = () if "q_w" in header else _DERIVATIVES
    if joints:
        position, derivatives = _LENGTHS, _LENGTH_DERIVATIVES
    _check_names(header, ["time", *_components(*position, *derivatives, *_LOADS)], source, _KNOWN)
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


def _check_names(header: list[str], known: list[str], source: str, expected: str = "") -> None:
    """Reject columns that are not known, with what is expected in words, or that are given twice."""
    for column in header:
        if column not in known:
            raise ValueError(f"{source}: unknown column {column[:40]!r}, expected {expected}")
        if header.count(column) > 1:
            name = column if column.isprintable() and len(column) <= 40 else repr(column[:40])
            raise ValueError(f"{source}: column {name} is given twice")


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


# Share of the largest change of a second rate beyond which one counts.
_CHANGED = 0.02


def _differentiate(log: _Log, values: Array, steps: Array) -> tuple[Array, Uncertainty | None]:
    """Coordinates, (n, 6), with rates and second rates, (3, n, 6), smoothed where there is noise.

    Poses that a log repeats or interpolates from those of a slower sensor don't count. Rows of poses that no
    motion makes are replaced, with a warning; what that changes counts as a deviation.
    """
    _warn_of_gap(log)
    slower = slower_sampling(values, steps) if log.smoothing.on and "L" not in log.written else None
    if slower is None:
        return _replaced(log, values, steps)
    rows, kind = slower
    text = f"{len(log.time)} rows are {kind} between {len(rows)} measured ones, each taken for its first row"
    warnings.warn(f"{log.source}: {text}", LogWarning, stacklevel=6)
    measured = dataclasses.replace(log, time=log.time[rows], rows=[log.rows[i] for i in rows])
    few, noise = _replaced(measured, values[rows], steps)
    found = spread(log.time, rows, few)
    return found, None if noise is None else noise._replace(coordinates=found)


def _replaced(log: _Log, values: Array, steps: Array) -> tuple[Array, Uncertainty | None]:
    """``_differentiate`` of rows that were measured."""
    level = _level(log, values, steps)
    bad = [] if "L" in log.written else faults(log.time, values, level.sigma)
    if bad:
        _tell_faults(log, bad)
    if not bad or not log.smoothing.on:
        return _derivatives(log, values, level)
    good = values - offsets(bad, values.shape)
    found, noise = _derivatives(log, good, _level(log, good, steps))
    changed = found - _derivatives(log, values, level, tell=False)[0]
    near = _changed(changed)
    return found, _with_changes(log.time, found, noise, changed, near)._replace(
        replaced=_replaced_rows(log, bad, near)
    )


def _changed(changed: Array) -> NDArray[np.bool_]:
    """Instants, (n,), at which changes of coordinates and rates, (3, n, 6), count."""
    size = np.abs(changed[2])
    return np.asarray((size > _CHANGED * size.max(axis=0)).any(axis=1))


def _replaced_rows(log: _Log, bad: Sequence[Fault], near: NDArray[np.bool_]) -> tuple[Replaced, ...]:
    """Spans of instants at which replaced rows count, with the faults that are nearest to each."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], near, [False]]).astype(np.int8)))
    rows = list(dict.fromkeys((fault.first, fault.end) for fault in bad))
    first = np.array([start for start, _ in rows])
    names = [
        f"the step at row {log.rows[start]}" if end is None else _rows_text(log, start, end)
        for start, end in rows
    ]
    found, last = [], len(log.time) - 1
    for a, b in edges.reshape(-1, 2):
        apart = np.maximum(np.maximum(a - first, first - b + 1), 0)
        nearest = tuple(name for name, away in zip(names, apart, strict=True) if away == apart.min())
        ends = float(log.time[max(a - 1, 0)]), float(log.time[min(b, last)])
        found.append(Replaced(*ends, nearest))
    return tuple(found)


def _with_changes(
    time: Array, found: Array, noise: Uncertainty | None, changed: Array, near: NDArray[np.bool_]
) -> Uncertainty:
    """Uncertainty in which changes of coordinates and rates, (3, n, 6), count as a deviation, ``near``."""
    if noise is None:
        noise = Uncertainty(found, time[[0, -1]], np.zeros((2, 6, len(PAIRS))), np.zeros(6))
    rows = np.flatnonzero(np.convolve(near, np.ones(3), "same"))
    squares = np.stack([changed[i, rows] * changed[j, rows] for i, j in PAIRS], axis=-1)
    squares *= near[rows, None, None]
    grid = np.union1d(noise.grid, time[rows])

    def on_grid(times: Array, covariance: Array) -> Array:
        flat = covariance.reshape(len(times), -1)
        return np.stack([np.interp(grid, times, x) for x in flat.T], axis=-1).reshape(-1, 6, len(PAIRS))

    covariance = on_grid(noise.grid, noise.covariance) + on_grid(time[rows], squares)
    return noise._replace(grid=grid, covariance=covariance)


def _derivatives(
    log: _Log, values: Array, level: Level, tell: bool = True
) -> tuple[Array, Uncertainty | None]:
    """``_differentiate`` of numbers with a level of noise."""
    noisy = level.sigma > 0.0
    if log.smoothing.cutoff is not None:
        noisy[:] = True
    if len(log.time) < _MIN_SPLINE_POINTS or not log.smoothing.on:
        noisy[:] = False
    found = np.empty((3, *values.shape))
    if not noisy.all():
        found[0][:, ~noisy] = values[:, ~noisy]
        since = log.time - log.time[0]
        spline = _spline(since, values[:, ~noisy], log.source)
        # In parts, since a spline's values come in arrays of their own.
        for part in (slice(i, i + _PART) for i in range(0, len(since), _PART)):
            for order in (1, 2):
                found[order, part][:, ~noisy] = spline(since[part], order)
    if not noisy.any():
        return found, None
    own = Level(level.sigma[noisy], level.least[noisy])
    smooth = smoothed(log.time, values[:, noisy], own if own.sigma.all() else None, log.smoothing.cutoff)
    found[..., noisy] = [smooth.values, smooth.rates, smooth.second_rates]
    covariance, sigma = np.zeros((len(smooth.grid), 6, 6)), np.zeros(6)
    covariance[:, noisy], sigma[noisy] = smooth.covariance, smooth.sigma
    noise = Uncertainty(found, smooth.grid, covariance, sigma, "L" in log.written)
    if tell and _matters(noise):
        more = _CORRELATED.format(level.correlation) if level.correlation > 1.0 else ""
        warnings.warn(f"{log.source}: {noise_text(noise)}: smoothed{more}", LogWarning, stacklevel=8)
    return found, noise


# Noise that is not told: shares of the largest acceleration, gravity's at least, and of the path.
_LITTLE, _PATH = 1e-3, 1e-6
_GRAVITY = 9.81
_CORRELATED = (
    "; it is correlated, {:.2g} times as large in slow changes as white noise is, which the deviations hold "
    "as far as it shows beside the motion"
)


def _matters(noise: Uncertainty) -> bool:
    """Whether noise in the log is beyond a small share of the path or of the accelerations."""
    second = np.sqrt(np.max(noise.covariance[:, :, 5], axis=0))
    for part in (slice(6),) if noise.in_joints else (slice(3), slice(3, 6)):
        values, _, seconds = noise.coordinates[..., part]
        largest = max(float(np.abs(seconds).max()), _GRAVITY)
        path = float(np.ptp(values, axis=0).max())
        if second[part].max() > _LITTLE * largest or noise.sigma[part].max() > _PATH * path:
            return True
    return False


def noise_text(noise: Uncertainty) -> str:
    """The noise found in a log, in words."""
    parts = [(slice(6), "m")] if noise.in_joints else [(slice(3), "m"), (slice(3, 6), "rad")]
    text = " and ".join(
        f"{noise.sigma[part].max():.2g} {unit}" for part, unit in parts if noise.sigma[part].any()
    )
    return f"noise of {text} in the log"


def _level(log: _Log, values: Array, steps: Array) -> Level:
    """Noise of six coordinates as stated or as the numbers show it."""
    names = ("L", "L") if "L" in log.written else _POSE
    shown_noise = noise_level(log.time, values, steps)
    known = np.repeat([log.smoothing.stated(name) or 0.0 for name in names], 3)
    if log.smoothing.cutoff is not None:
        return stated(known)
    return Level(
        np.where(known > 0.0, known, shown_noise.sigma),
        np.where(known > 0.0, known, shown_noise.least),
        1.0 if known.all() else shown_noise.correlation,
    )


def _as_given(log: _Log, found: Array, steps: Sequence[Array]) -> Uncertainty | None:
    """Uncertainty of coordinates and rates, (3, n, 6), all of them measured and rounded to steps, (3, 6)."""
    names = ("L", "L") if "L" in log.written else _POSE
    known = np.repeat([log.smoothing.stated(name) or 0.0 for name in names], 3)
    sigma = np.array(steps) / math.sqrt(12.0)
    sigma[0] = np.where(known > 0.0, known, sigma[0])
    if not sigma.any() or not log.smoothing.on:
        return None
    covariance = np.zeros((2, 6, 6))
    covariance[:, :, [0, 2, 5]] = sigma.T**2
    return Uncertainty(found, log.time[[0, -1]], covariance, sigma[0])


# A step in time that is this many times the usual one, and of nine in ten steps, is a gap.
_GAP = 5.0


def _warn_of_gap(log: _Log) -> None:
    """Warn of the longest gap in time, which a curve bridges."""
    step = np.diff(log.time)
    if len(step) < _MIN_SPLINE_POINTS:
        return
    usual, most = (float(x) for x in np.quantile(step, (0.5, 0.9)))
    gaps = np.flatnonzero(step > _GAP * max(usual, most))
    if not gaps.size:
        return
    i = int(gaps[np.argmax(step[gaps])])
    text = (
        f"rows {log.rows[i]} and {log.rows[i + 1]}: nothing from {log.time[i]:.6g} s "
        f"to {log.time[i + 1]:.6g} s, {step[i] / usual:.3g} times the usual step of {usual:.3g} s"
    )
    more = f"; {gaps.size - 1} more gaps" if gaps.size > 1 else ""
    warnings.warn(f"{log.source}: {text}{more}: bridged by a smooth curve", LogWarning, stacklevel=7)


# Rows that one line names at most; coordinates of a row that point to the row itself.
_MOST_NAMED, _MANY = 4, 3


def _tell_faults(log: _Log, found: Sequence[Fault]) -> None:
    """Warn of rows that no motion makes: when, which columns and by how much."""
    by_rows: dict[tuple[int, int | None], list[str]] = {}
    for fault in found:
        names = ("t", "t", "t", "theta", "theta", "theta")
        unit = "m" if fault.column < 3 else "rad"
        text = f"{names[fault.column]}_{'xyz'[fault.column % 3]} by {fault.size:.3g} {unit}"
        by_rows.setdefault((fault.first, fault.end), []).append(text)
    lines = []
    for (first, end), texts in itertools.islice(by_rows.items(), _MOST_NAMED):
        lines.append(f"{_rows_text(log, first, end)} ({log.time[first]:.6g} s): {', '.join(texts)}")
    more = len(by_rows) - len(lines)
    ending = f"; and {more} more" if more > 0 else ""
    done = "replaced, and deviations there hold what this changes" if log.smoothing.on else "left as they are"
    cause = " (rows repeated or missing?)" if any(len(texts) >= _MANY for texts in by_rows.values()) else ""
    warnings.warn(
        f"{log.source}: numbers are off as no motion makes them{cause}: {'; '.join(lines)}{ending}: {done}",
        LogWarning,
        stacklevel=7,
    )


def _rows_text(log: _Log, first: int, end: int | None) -> str:
    """Rows of a fault, ``end`` None: to the log's end."""
    last = len(log.rows) if end is None else min(end, len(log.rows))
    rows = f"row {log.rows[first]}"
    if last - first > 1:
        rows += " on" if last == len(log.rows) else f" to {log.rows[last - 1]}"
    return rows


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
    with needed_for(*_SPLINE):
        from scipy.interpolate import make_interp_spline
    return make_interp_spline  # type: ignore[no-any-return]
