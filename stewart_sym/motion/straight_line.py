"""Straight-line paths of the paper, (39), (40), with parabolic blends; Paths I, II, and III."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import finite_array, real_array
from ..io.array_types import Array
from ..io.toml_reader import number
from .motion import Motion, rotations

Vector = tuple[float, float, float]
Rows = tuple[Vector, Vector, Vector]
# Fraction of tau_f below which two times are equal, because they differ only by rounding.
_ROUNDING = 1e-12
# Limit of memory: a motion with ten million samples requires about a gigabyte.
MOST_STEPS = 10_000_000


@dataclass(frozen=True)
class StraightLinePath:
    """Straight line of position and of roll, pitch, and yaw with trapezoidal velocity profiles.

    Position and angles each accelerate at a constant rate, move at constant speed, and decelerate, (39),
    (40). Both start at time 0 and end at tau_f.

    Attributes
    ----------
    t0, t1 : tuple of float
        First and last position of the reference point in the base frame (m).
    theta0, theta1 : tuple of float
        First and last angles (theta_x, theta_y, theta_z) (rad).
    tau_f : float
        Duration (s).
    V, Omega : float
        Largest speed of the position (m/s) and of the vector of angles (rad/s). For the distance d, the
        speed must be in (d/tau_f, 2 d/tau_f]. If d = 0, the speed is not used.
    axes : tuple of tuple of float, optional
        Rotation matrix, by rows, from the frames of the path to the base and platform frames.

    Raises
    ------
    ValueError
        If an argument is invalid. The message names it, and the permitted range of V and Omega.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> path, step = ss.PAPER_PATHS["I"]
    >>> motion = path.sample(path.time_grid(step))
    >>> motion.shape, motion.t[-1].tolist()
    ((61,), [0.3, 0.0, 0.6])
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
        for field in fields(self)[:-1]:
            value = getattr(self, field.name)
            vector = field.name in ("t0", "theta0", "t1", "theta1")
            object.__setattr__(
                self, field.name, _triple(value, field.name) if vector else number(value, field.name)
            )
        axes = rotations(self.axes, "axes", batch=False)
        object.__setattr__(self, "axes", tuple(tuple(row) for row in axes.tolist()))
        if self.tau_f <= 0.0:
            raise ValueError(f"tau_f: expected a duration > 0 s, got {self.tau_f:g}")
        _check_speed("V", self.V, self.distance, self.tau_f, "m/s")
        _check_speed("Omega", self.Omega, self.angle, self.tau_f, "rad/s")

    @property
    def distance(self) -> float:
        """Length of the line of positions (m)."""
        return math.dist(self.t0, self.t1)

    @property
    def angle(self) -> float:
        """Length of the line of angles (rad)."""
        return math.dist(self.theta0, self.theta1)

    @property
    def tau_t(self) -> float:
        """Duration of each blend of the position (s), (39); 0 if the position is constant."""
        return _blend(self.distance, self.V, self.tau_f)

    @property
    def tau_theta(self) -> float:
        """Duration of each blend of the angles (s), (39); 0 if the angles are constant."""
        return _blend(self.angle, self.Omega, self.tau_f)

    def breakpoints(self) -> Array:
        """Return the times at which an acceleration jumps, including 0 and tau_f.

        Returns
        -------
        ndarray, shape (n,)
            Increasing times (s).
        """
        times = {0.0, self.tau_f}
        for distance, blend in ((self.distance, self.tau_t), (self.angle, self.tau_theta)):
            if distance > 0.0:
                times |= {blend, self.tau_f - blend}
        every = np.array(sorted(times))
        distinct = every[np.diff(every, prepend=-np.inf) > _ROUNDING * self.tau_f]
        return np.append(distinct[:-1], self.tau_f)

    def time_grid(self, dtau: float) -> Array:
        """Return the times 0, dtau, 2 dtau, ..., and tau_f.

        Parameters
        ----------
        dtau : float
            Time step (s), > 0 and at most tau_f.

        Returns
        -------
        ndarray, shape (n,)
            Times (s); the last one is tau_f.

        Raises
        ------
        ValueError
            If dtau is outside its range, or if there are more than ten million steps.
        """
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
        """Compute the motion at given times, without external load.

        Parameters
        ----------
        tau : array_like, shape (...)
            Times (s).

        Returns
        -------
        Motion
            Motion with the shape of tau. At a jump it has the acceleration after the jump, at tau_f the
            acceleration before.

        Raises
        ------
        ValueError
            If a time is outside [0, tau_f].
        """
        time = real_array(tau, "tau", "times")
        slack = _ROUNDING * self.tau_f
        outside = ~((time >= -slack) & (time <= self.tau_f + slack))
        if np.any(outside):
            raise ValueError(f"tau: expected times in [0, {self.tau_f:g}] s, got {time[outside][0]:g}")
        time = np.clip(time, 0.0, self.tau_f)
        t, v, a = _line(self.t0, self.t1, self.V, self.tau_t, self.tau_f, time)
        theta, theta_dot, theta_ddot = _line(
            self.theta0, self.theta1, self.Omega, self.tau_theta, self.tau_f, time
        )
        motion = Motion.from_rpy(t, theta, v, theta_dot, a, theta_ddot)
        Q = np.array(self.axes)
        if np.array_equal(Q, np.eye(3)):
            return motion
        vectors = {name: getattr(motion, name) @ Q.T for name in ("t", "omega", "v", "alpha", "a")}
        return Motion(R=Q @ motion.R @ Q.T, **vectors)


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
    start: Vector, end: Vector, speed: float, blend: float, tau_f: float, time: Array
) -> tuple[Array, Array, Array]:
    """Return the coordinates and their first and second derivatives, each (..., 3)."""
    origin, change = np.array(start), np.subtract(end, start)
    if not change.any():
        zero = np.zeros((*time.shape, 3))
        return origin + zero, zero, zero
    acceleration = speed / blend * change / math.dist(start, end)
    time = time[..., None]
    left = tau_f - time
    rounding = _ROUNDING * tau_f
    ending, starting = left <= blend + rounding, time < blend - rounding
    # Both end values are exact, because coordinates are computed from the nearer end.
    near = np.minimum(time, left)
    moved = np.where(near < blend, 0.5 * near**2, blend * (near - 0.5 * blend)) * acceleration
    coordinates = np.where(time <= left, origin + moved, np.array(end) - moved)
    sign = np.where(ending, -1.0, np.where(starting, 1.0, 0.0))
    return coordinates, np.minimum(near, blend) * acceleration, sign * acceleration


def _triple(value: object, name: str) -> Vector:
    x, y, z = finite_array(value, (3,), name, batch=False).tolist()
    return x, y, z


class PaperPath(NamedTuple):
    """Path of section 5 of the paper, and its time step dtau (s)."""

    path: StraightLinePath
    dtau: float


_FIRST = StraightLinePath(
    (0.1, 0.0, 0.4), (0.0, 0.0, -0.2), (0.3, 0.0, 0.6), (0.0, 0.0, 0.2), tau_f=6.0, V=0.08, Omega=0.08
)
_THIRD = StraightLinePath(
    (0.4, 1.4, 1.2), (0.1, 0.2, 0.0), (0.8, 1.8, 1.8), (0.3, 0.4, 0.0), tau_f=6.0, V=0.2, Omega=0.08
)
PAPER_PATHS: Mapping[str, PaperPath] = MappingProxyType(
    {
        "I": PaperPath(_FIRST, dtau=0.1),
        "II": PaperPath(replace(_FIRST, tau_f=0.6, V=0.8, Omega=0.8), dtau=0.01),
        "III": PaperPath(_THIRD, dtau=0.1),
    }
)
"""Paths I, II, and III of section 5 of the paper, as tuples (path, dtau) with the time step dtau (s)."""
