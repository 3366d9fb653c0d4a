"""Trajectories (motions, coordinates, or leg lengths over time), their uncertainty, and logs as read."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.arguments import instance
from ..io.array_types import Array
from ..io.error_policy import warn
from ..io.toml_reader import number
from . import rotation
from .logs import TrajectoryFormat
from .motion import Motion
from .noise_level import TrajectoryWarning, grid_steps, rounding_step

# Trajectories from CSV

POSE = ("t", "theta")
DERIVATIVES = ("v", "theta_dot", "a", "theta_ddot")
LOADS = ("F_ext", "M_ext")
ANGLES = ("theta", "theta_dot", "theta_ddot")
# Largest number of distinct values in the rates of a piecewise constant profile.
_LIMITS = 8


@dataclass(frozen=True)
class SmoothingOptions:
    """Noise and smoothing of a log.

    Attributes
    ----------
    position_std, angle_std : float, optional
        Standard deviation of each position or leg length (m), and of each angle (rad). None: estimated from
        the decimals and the scatter of the numbers.
    cutoff_frequency : float, optional
        Frequency (Hz) at which the amplitude is halved. None: most likely value.
    enabled : bool, optional
        If False, the log is interpolated at any noise level.
    repair : bool, optional
        If True, rows that cannot belong to a motion are replaced, even without smoothing.

    Raises
    ------
    ValueError
        If a number is not > 0. The message names the argument.
    """

    position_std: float | None = None
    angle_std: float | None = None
    cutoff_frequency: float | None = None
    enabled: bool = True
    repair: bool = False

    def __post_init__(self) -> None:
        for name in ("position_std", "angle_std", "cutoff_frequency"):
            if getattr(self, name) is not None and number(getattr(self, name), name) <= 0.0:
                raise ValueError(f"{name}: expected a number > 0, got {getattr(self, name):g}")

    def stated(self, name: str) -> float | None:
        """Return the given standard deviation of one kind of coordinates.

        Parameters
        ----------
        name : {"t", "theta", "L"}
            Positions, angles, or leg lengths.

        Returns
        -------
        float or None
            ``angle_std`` (rad) for "theta", otherwise ``position_std`` (m); None if not given.
        """
        return self.angle_std if name == "theta" else self.position_std


class Replaced(NamedTuple):
    """Time interval (s) whose standard deviations include the change by replaced rows, and these rows."""

    start: float
    end: float
    rows: tuple[str, ...]


class Uncertainty(NamedTuple):
    """Uncertainty of six coordinates of a log: position and angles, or leg lengths.

    Attributes
    ----------
    coordinates : ndarray, shape (3, n, 6)
        Values, rates, and second rates.
    grid : ndarray, shape (g,)
        Times (s) of ``covariance``.
    covariance : ndarray, shape (g, 6, 6)
        Covariance of value, rate, and second rate of each coordinate: lower triangle, row by row.
    sigma : ndarray, shape (6,)
        Standard deviations of the numbers in the log.
    in_joints : bool
        True for leg lengths.
    replaced : tuple of Replaced
        Intervals with replaced rows. ``covariance`` includes the change of these rows.
    tool : ndarray, shape (3,), or None
        Point of the platform whose pose the coordinates are (m), platform frame. None: reference point.
    order : str
        Order of rotations, as in ``PoseLog``.
    """

    coordinates: Array
    grid: Array
    covariance: Array
    sigma: Array
    in_joints: bool = False
    replaced: tuple[Replaced, ...] = ()
    tool: Array | None = None
    order: str = "zyx"

    def covariances(self, time: Array) -> Array:
        """Interpolate the covariance to times (n,) (s), shape (n, 6, 6)."""
        flat = self.covariance.reshape(len(self.grid), -1)
        found = np.stack([np.interp(time, self.grid, x) for x in flat.T], axis=-1)
        return found.reshape(-1, *self.covariance.shape[1:])

    def variances(self, time: Array) -> Array:
        """Return the variances of the coordinates at times (n,) (s), shape (n, 6)."""
        return self.covariances(time)[..., 0]


class Trajectory(NamedTuple):
    """Trajectory of n samples as a motion.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Times (s).
    motion : Motion
        Motion of shape (n,).
    source : str
        Name of the file.
    rows : sequence of int
        Line of each sample in the file.
    noise : Uncertainty or None
        Uncertainty of the coordinates. None for a log without noise.
    """

    time: Array
    motion: Motion
    source: str
    rows: Sequence[int]
    noise: Uncertainty | None = None

    def at(self, index: slice | NDArray[np.int64]) -> Motion:
        """Return the motion at selected samples."""
        return self.motion[index]


class PoseLog(NamedTuple):
    """Trajectory of n samples as coordinates, which require a third of the memory of a motion.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Times (s).
    coordinates : ndarray, shape (3, n, 6)
        Position and angles, their rates, and their second rates.
    F_ext, M_ext : ndarray, shape (n, 3), or None
        External force (N) and moment (N m) in the platform frame.
    source : str
        Name of the file.
    rows : sequence of int
        Line of each sample in the file.
    noise : Uncertainty or None
        Uncertainty of the coordinates. None for a log without noise.
    in_radians : bool
        True if the log contains the angles in radians.
    tool : ndarray, shape (3,), or None
        Point of the platform whose position and load the log contains (m), platform frame. None: reference
        point. Motions always belong to the reference point.
    order : str
        Order of rotations, as ``euler_order`` of ``TrajectoryFormat``; "zyx" is (38).
    """

    time: Array
    coordinates: Array
    F_ext: Array | None
    M_ext: Array | None
    source: str
    rows: Sequence[int]
    noise: Uncertainty | None = None
    in_radians: bool = False
    tool: Array | None = None
    order: str = "zyx"

    def at(self, index: slice | NDArray[np.int64]) -> Motion:
        """Compute the motion at selected samples; the ValueError for invalid samples names file and line."""
        names, chosen = ("t", "theta", *DERIVATIVES), self.coordinates[:, index]
        # Arguments of ``Motion.from_rpy``.
        numbers = {name: chosen[i // 2, ..., 3 * (i % 2) :][..., :3] for i, name in enumerate(names)}
        for name, load in (("F_ext", self.F_ext), ("M_ext", self.M_ext)):
            if load is not None:
                numbers[name] = load[index]
        try:
            motion = _motion_of(numbers, self.order)
        except ValueError as error:
            row = _first_bad_row(numbers, np.asarray(self.rows)[index], self.order)
            raise ValueError(f"{self.source}: {row}{error}") from None
        return motion if self.tool is None else motion.at_point(-self.tool)

    def of_tool(self, tool: Array) -> PoseLog:
        """Return the log with rows that are poses of a point (3,) (m) in the platform frame."""
        if not tool.any():
            return self
        noise = None if self.noise is None else self.noise._replace(tool=tool)
        return self._replace(tool=tool, noise=noise)

    @property
    def motion(self) -> Motion:
        """Motion at all samples."""
        return self.at(slice(None))


def need_trajectory(value: object) -> None:
    """Raise ValueError unless the value is a Trajectory or a PoseLog."""
    if not isinstance(value, PoseLog):
        instance(value, Trajectory, "trajectory")


class JointTrajectory(NamedTuple):
    """Trajectory of n samples in joint space.

    ``L``, ``L_dot``, and ``L_ddot``, shape (n, 6), are lengths (m), rates (m/s), and accelerations (m/s^2).
    ``F_ext`` and ``M_ext``, shape (n, 3) or None, are the external force (N) and moment (N m) in the platform
    frame. ``relative`` is True if the lengths at the home pose are subtracted from L. Other fields are
    described in ``Trajectory``.
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
    relative: bool = False


IN_SI = TrajectoryFormat().with_units({})
"""Format of a log in SI units."""


@dataclass(frozen=True, eq=False)
class Log:
    """Trajectory as read from a file: components of vectors, shape (n,) each, in the units of the file.

    ``given_units`` names the units given by options. ``unit_line`` is the line of the row of units, or None.
    """

    source: str
    rows: Sequence[int]
    time: Array
    written: Mapping[str, Sequence[Array]]
    form: TrajectoryFormat = IN_SI
    smoothing: SmoothingOptions = dataclasses.field(default_factory=SmoothingOptions)
    given_units: frozenset[str] = frozenset()
    unit_line: int | None = None

    def scale(self, name: str) -> float:
        """Return the factor that converts vectors of this name to SI units."""
        if name in ("q", *LOADS):
            return 1.0
        return self.form.radians_per_unit if name in ANGLES else self.form.meters_per_unit

    def vector(self, name: str) -> Array:
        """Return a vector in SI units, shape (n, 3), (n, 4), or (n, 6)."""
        return np.stack(self.written[name], axis=-1) * self.scale(name)

    def kinds(self) -> tuple[tuple[str, slice], ...]:
        """Return the names of the vectors of the six coordinates, with their columns."""
        return (("L", slice(0, 6)),) if "L" in self.written else (("t", slice(0, 3)), ("theta", slice(3, 6)))

    def unit(self, name: str) -> str | None:
        """Return the unit of coordinates of this name in the file."""
        return self.form.angle_unit if name == "theta" else self.form.length_unit

    def kind(self, name: str) -> tuple[str, Callable[[float], str]]:
        """Return the plural noun for coordinates of this name, and a function that formats their numbers."""
        scale, unit = self.scale(name), self.unit(name)
        what = {"L": "lengths", "t": "positions", "theta": "angles"}[name]
        return what, lambda number: f"{number / scale:.2g} {unit}"

    def other_unit(self, name: str, finding: str, units: Sequence[str]) -> ValueError:
        """Return the error for numbers that fit other units; ``name`` is, for example, ``length_unit``."""
        unit = self.form.units[name]
        remedies = [f"{name}={each}" for each in units]
        place = f"{self.source}: {finding} if read in {unit}"
        if self.unit_line is not None:
            place = f"{self.source}: line {self.unit_line}: the row of units ({unit}) contradicts {finding}"
        remedy = f"give {' or '.join(remedies)}, or {name}={unit} if {unit} is right"
        return ValueError(f"{place}; {remedy}")

    def warn(self, text: str) -> None:
        """Issue a warning that begins with the name of the file."""
        warn(f"{self.source}: {text}", TrajectoryWarning)

    def load(self, name: str) -> Array | None:
        """Return an external force (N) or moment (N m), shape (n, 3), or None."""
        return self.vector(name) if name in self.written else None

    def steps(self, name: str) -> Array:
        """Return the rounding steps of the components (SI); constant components have the smallest step."""
        columns = self.written[name]
        # Piecewise constant accelerations have few distinct values, which do not show the rounding.
        moving = np.array([np.ptp(values) > 0.0 for values in columns])
        if name not in (*POSE, "q", "L"):
            moving &= [len(np.unique(values)) > _LIMITS for values in columns]
        if not moving.any():
            return np.zeros(len(columns))
        some = [values for values, moves in zip(columns, moving, strict=True) if moves]
        grids, finest = grid_steps(some), min(map(rounding_step, some))
        found = np.where(grids > 0.0, grids, finest)
        steps = np.full(len(columns), found.min())
        steps[moving] = found
        return steps * self.scale(name)

    def angles(self) -> tuple[Array, Array, str]:
        """Return unwrapped angles (n, 3) (rad), their rounding steps (3,) (rad), and their order.

        The order is the order of the log, and (38) for quaternions. Another order is used near gimbal lock.
        """
        order = self.form.rotation_order
        if "q" in self.written:
            q = self.vector("q")
            norms = np.linalg.norm(q, axis=-1)
            if (norms == 0.0).any():
                row = self.rows[int(np.argmin(norms))]
                raise ValueError(f"{self.source}: line {row}: q: expected a quaternion, got length 0")
            theta, order = rotation.far_from_lock(rotation.rotation_from_quaternion(q))
            # The vector of a small rotation is twice the vector part of its quaternion.
            step = np.full(3, 2.0 * self.steps("q").max() / float(np.median(norms)))
        else:
            theta, step = self.vector("theta"), self.steps("theta")
            if rotation.distance_from_lock(theta, order).min() < rotation.FAR_FROM_LOCK:
                theta, order = rotation.far_from_lock(rotation.rotation_about_axes(theta, order))
                step = np.full(3, step.max())
        return np.unwrap(theta, axis=0), step, order


MOST_TURNS = (math.pi, math.pi, 2.0 * math.pi)
"""Largest plausible ranges of theta_x, theta_y, and theta_z (rad)."""


def turn_doubt(theta: Array) -> str | None:
    """Describe a range of angles (n, 3) (rad) that exceeds ``MOST_TURNS``; None if there is none."""
    spans = np.ptp(theta, axis=0)
    axis = int(np.argmax(spans / MOST_TURNS))
    return angle_range(theta, axis) if spans[axis] > MOST_TURNS[axis] * (1.0 + 1e-9) else None


def angle_range(theta: Array, axis: int) -> str:
    """Describe the range of one of the angles (n, 3) (rad), for example ``theta_x from -4 to 5 rad``."""
    low, high = theta[:, axis].min(), theta[:, axis].max()
    return f"theta_{'xyz'[axis]} from {low:.4g} to {high:.4g} rad"


LONG_STEPS = {"ms": 0.5, "us": 500.0}


def _motion_of(numbers: Mapping[str, Array], order: str) -> Motion:
    """Create a motion from the arguments of ``Motion.from_rpy`` with angles of any order."""
    if order == "zyx":
        return Motion.from_rpy(**numbers)
    theta, theta_dot, theta_ddot = (numbers[name] for name in ANGLES)
    R, omega, alpha = rotation.motion_about_axes(theta, theta_dot, theta_ddot, order)
    others = {name: values for name, values in numbers.items() if name not in ANGLES}
    return Motion(R=R, omega=omega, alpha=alpha, **others)


def _first_bad_row(numbers: Mapping[str, Array], rows: NDArray[np.int64], order: str) -> str:
    """Return the prefix of a message that names the first invalid row."""
    for i, row in enumerate(rows):
        try:
            _motion_of({name: values[i] for name, values in numbers.items()}, order)
        except ValueError:
            return f"line {row}: "
    return ""
