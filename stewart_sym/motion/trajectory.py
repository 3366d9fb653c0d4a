"""Trajectories: motions, coordinates or leg lengths over time; what noise leaves open; a log as read."""

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
# Numbers of which the rates of a profile are made, at most.
_LIMITS = 8


@dataclass(frozen=True)
class SmoothingOptions:
    """What is known of a log's noise, and what is done about it.

    Attributes
    ----------
    position_std, angle_std : float, optional
        Standard deviation of each coordinate, m and rad; leg lengths count as positions. None: as the
        decimals and the scatter of the numbers show.
    cutoff_frequency : float, optional
        Frequency, Hz, at which the amplitude is halved; None: the likeliest.
    enabled : bool, optional
        False interpolates whatever the noise.
    repair : bool, optional
        True replaces rows that no motion makes even without smoothing.

    Raises
    ------
    ValueError
        Naming the argument.
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
        """What is stated of the noise of one kind of coordinates.

        Parameters
        ----------
        name : {"t", "theta", "L"}
            Positions, angles or leg lengths.

        Returns
        -------
        float or None
            Standard deviation, ``angle_std``, rad, of ``theta``, else ``position_std``, m; None where none is
            stated.
        """
        return self.angle_std if name == "theta" else self.position_std


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
    not as the log has them; covariance holds by how much. tool: point whose pose t and theta are, m, platform
    frame; None for the reference point. order: as in ``PoseLog``.
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
        """At times, (n, 6, 6)."""
        flat = self.covariance.reshape(len(self.grid), -1)
        found = np.stack([np.interp(time, self.grid, x) for x in flat.T], axis=-1)
        return found.reshape(-1, *self.covariance.shape[1:])

    def variances(self, time: Array) -> Array:
        """Of each coordinate's value at times, (n, 6)."""
        return self.covariances(time)[..., 0]


class Trajectory(NamedTuple):
    """A trajectory of n samples: time, s, (n,), and the motion, of shape (n,).

    source: the file it comes from. rows: line of each sample in the file. noise: None for
    a log without.
    """

    time: Array
    motion: Motion
    source: str
    rows: Sequence[int]
    noise: Uncertainty | None = None

    def at(self, index: slice | NDArray[np.int64]) -> Motion:
        """The motion at some of the samples."""
        return self.motion[index]


class PoseLog(NamedTuple):
    """A trajectory as coordinates, whose motion is made where it is needed: a third of the room.

    coordinates: t and theta with rates and second rates, (3, n, 6). F_ext, M_ext: external load, N and
    N m, platform frame, (n, 3), or None. in_radians: whether theta are the log's own numbers. tool: point of
    t and of the load, m, platform frame, (3,); None for the reference point, whose motion ``at`` returns in
    any case. order: in which the turns by theta are multiplied, "zyx" for (38). The rest as in
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
    tool: Array | None = None
    order: str = "zyx"

    def at(self, index: slice | NDArray[np.int64]) -> Motion:
        """The motion at some of the samples; ValueError of one line that names file and line."""
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
        """The same log, its rows being poses of a point, m, platform frame, (3,)."""
        if not tool.any():
            return self
        noise = None if self.noise is None else self.noise._replace(tool=tool)
        return self._replace(tool=tool, noise=noise)

    @property
    def motion(self) -> Motion:
        """The motion at all samples."""
        return self.at(slice(None))


def need_trajectory(value: object) -> None:
    """Reject, by ValueError, what is neither a Trajectory nor a PoseLog."""
    if not isinstance(value, PoseLog):
        instance(value, Trajectory, "trajectory")


class JointTrajectory(NamedTuple):
    """A trajectory in joint space of n samples: time, s, (n,), and the legs' motion, (n, 6) each.

    L, L_dot, L_ddot: lengths, m, rates, m/s, and accelerations, m/s^2. F_ext, M_ext: external load, N and
    N m, platform frame, (n, 3), or None. source, rows, noise: as in ``Trajectory``. relative: whether L are
    less those of the robot's home pose.
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
"""How a log in SI units is written."""


@dataclass(frozen=True, eq=False)
class Log:
    """A trajectory as read: the components of vectors by name, (n,) each, as written.

    given_units: names of the units in an option. unit_line: line of the row of units; None if there is none.
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
        """SI units in the unit in which vectors of that name are written."""
        if name in ("q", *LOADS):
            return 1.0
        return self.form.radians_per_unit if name in ANGLES else self.form.meters_per_unit

    def vector(self, name: str) -> Array:
        """A vector in SI units, (n, 3), (n, 4) or (n, 6)."""
        return np.stack(self.written[name], axis=-1) * self.scale(name)

    def kinds(self) -> tuple[tuple[str, slice], ...]:
        """Names of the vectors that are six coordinates, with their columns."""
        return (("L", slice(0, 6)),) if "L" in self.written else (("t", slice(0, 3)), ("theta", slice(3, 6)))

    def unit(self, name: str) -> str | None:
        """The unit in which coordinates of that name are written."""
        return self.form.angle_unit if name == "theta" else self.form.length_unit

    def kind(self, name: str) -> tuple[str, Callable[[float], str]]:
        """What vectors of that name are called, and how a number of them is written in the log's units."""
        scale, unit = self.scale(name), self.unit(name)
        what = {"L": "lengths", "t": "positions", "theta": "angles"}[name]
        return what, lambda number: f"{number / scale:.2g} {unit}"

    def other_unit(self, name: str, finding: str, units: Sequence[str]) -> ValueError:
        """Return the error for numbers that fit other units; ``name`` is such as ``length_unit``."""
        unit = self.form.units[name]
        remedies = [f"{name}={each}" for each in units]
        place = f"{self.source}: {finding} if read in {unit}"
        if self.unit_line is not None:
            place = f"{self.source}: line {self.unit_line}: the row of units ({unit}) contradicts {finding}"
        remedy = f"give {' or '.join(remedies)}, or {name}={unit} if {unit} is right"
        return ValueError(f"{place}; {remedy}")

    def warn(self, text: str) -> None:
        """Warn of the log."""
        warn(f"{self.source}: {text}", TrajectoryWarning)

    def load(self, name: str) -> Array | None:
        """An external force or moment, (n, 3)."""
        return self.vector(name) if name in self.written else None

    def steps(self, name: str) -> Array:
        """Steps to which the components are rounded, SI units; those that stay the same have the finest."""
        columns = self.written[name]
        # A few limits, of which accelerations of a profile are made, are no rounding.
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
        """Unwrapped angles, rad, (n, 3), the steps to which they are rounded, (3,), and their order.

        The order is the log's own, of quaternions (38), unless two turns of it come near to one axis.
        """
        order = self.form.rotation_order
        if "q" in self.written:
            q = self.vector("q")
            norms = np.linalg.norm(q, axis=-1)
            if (norms == 0.0).any():
                row = self.rows[int(np.argmin(norms))]
                raise ValueError(f"{self.source}: line {row}: q: expected a quaternion, got length 0")
            theta, order = rotation.far_from_lock(rotation.rotation_from_quaternion(q))
            # The vector of a small rotation is twice that of its quaternion.
            step = np.full(3, 2.0 * self.steps("q").max() / float(np.median(norms)))
        else:
            theta, step = self.vector("theta"), self.steps("theta")
            if rotation.distance_from_lock(theta, order).min() < rotation.FAR_FROM_LOCK:
                theta, order = rotation.far_from_lock(rotation.rotation_about_axes(theta, order))
                step = np.full(3, step.max())
        return np.unwrap(theta, axis=0), step, order


MOST_TURNS = (math.pi, math.pi, 2.0 * math.pi)
"""Tilts and turn beyond which no platform goes, rad."""


def turn_doubt(theta: Array) -> str | None:
    """Range of angles (n, 3), rad, that no platform has, as ``angle_range`` says it; None: there is none."""
    spans = np.ptp(theta, axis=0)
    axis = int(np.argmax(spans / MOST_TURNS))
    return angle_range(theta, axis) if spans[axis] > MOST_TURNS[axis] * (1.0 + 1e-9) else None


def angle_range(theta: Array, axis: int) -> str:
    """Least and largest of one of angles (n, 3), rad, in words: ``theta_x from -4 to 5 rad``."""
    low, high = theta[:, axis].min(), theta[:, axis].max()
    return f"theta_{'xyz'[axis]} from {low:.4g} to {high:.4g} rad"


LONG_STEPS = {"ms": 0.5, "us": 500.0}


def _motion_of(numbers: Mapping[str, Array], order: str) -> Motion:
    """The motion of arguments of ``Motion.from_rpy`` whose angles are of any order."""
    if order == "zyx":
        return Motion.from_rpy(**numbers)
    theta, theta_dot, theta_ddot = (numbers[name] for name in ANGLES)
    R, omega, alpha = rotation.motion_about_axes(theta, theta_dot, theta_ddot, order)
    others = {name: values for name, values in numbers.items() if name not in ANGLES}
    return Motion(R=R, omega=omega, alpha=alpha, **others)


def _first_bad_row(numbers: Mapping[str, Array], rows: NDArray[np.int64], order: str) -> str:
    """Name the first row that makes no motion by itself, as a prefix."""
    for i, row in enumerate(rows):
        try:
            _motion_of({name: values[i] for name, values in numbers.items()}, order)
        except ValueError:
            return f"line {row}: "
    return ""
