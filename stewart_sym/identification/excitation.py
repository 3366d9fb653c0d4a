"""Excitation trajectories: periodic motions within the limits, with a well-conditioned regressor."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..drives.limits import LimitTracker, limited_angles
from ..drives.motor_states import motor_states
from ..dynamics.home_pose import home_pose
from ..dynamics.inverse_dynamics import inverse_dynamics, need_universal
from ..io.arguments import finite_array, number_in, real_array, whole_number
from ..io.array_types import Array, Frozen
from ..io.progress import Progress, silent, tracked
from ..kinematics.conditioning import characteristic_length, scaled_condition_number
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..kinematics.mounting_side import radius, upright
from ..motion.motion import Motion
from ..robot.robot import Robot
from .base_parameters import BaseParametersResult, base_parameters
from .parameters import regressor

# Standard deviations of the coefficients of the first harmonic: relative to the radius of the base, and rad.
_WIDTH = np.array([0.1, 0.1, 0.1, 0.2, 0.2, 0.2])
# Largest number of samples, harmonics, and candidates.
_MOST = 10_000_000
# Factor by which a candidate is reduced until it is within the limits, and the largest number of reductions.
_SMALLER, _TIMES = 0.8, 16
# Largest scaled condition number of H along the motion, relative to the home pose.
_REGULAR = 3.0


@dataclass(frozen=True, eq=False)
class FourierPath(Frozen):
    """Periodic motion: Fourier series of the position and of the roll, pitch, and yaw angles.

    Attributes
    ----------
    t0, theta0 : ndarray, shape (3,)
        Center of the motion: position (m), and roll, pitch, and yaw (rad).
    sine, cosine : ndarray, shape (n, 6)
        Coefficients of the harmonics 1 to n: position (m) in columns 0 to 2, angles (rad) in columns 3 to 5.
    period : float
        Period (s).

    Raises
    ------
    ValueError
        If an argument is invalid.
    """

    t0: Array
    theta0: Array
    sine: Array
    cosine: Array
    period: float

    def __post_init__(self) -> None:
        """Check the arguments."""
        for name, core in (("t0", (3,)), ("theta0", (3,)), ("sine", (6,)), ("cosine", (6,))):
            value = finite_array(getattr(self, name), core, name)
            if value.ndim != (1 if core == (3,) else 2):
                raise ValueError(
                    f"{name}: expected {'(3,)' if core == (3,) else '(n, 6)'}, got {value.shape}"
                )
            self._set({name: value})
        if self.sine.shape != self.cosine.shape:
            raise ValueError(f"cosine: expected the shape {self.sine.shape} of sine, got {self.cosine.shape}")
        number_in(self.period, "period", "a duration > 0 s")

    def time_grid(self, samples: int) -> Array:
        """Return equally spaced times of one period.

        Parameters
        ----------
        samples : int
            Number of samples, from 1 to ten million.

        Returns
        -------
        ndarray, shape (samples,)
            Times (s) from 0, without the end of the period.

        Raises
        ------
        ValueError
            If ``samples`` is outside its range.
        """
        _count(samples, "samples")
        return np.arange(samples) * self.period / samples

    def sample(self, tau: ArrayLike) -> Motion:
        """Return the motion at given times, without external load.

        Parameters
        ----------
        tau : array_like, shape (...)
            Times (s).

        Returns
        -------
        Motion
            Motion with accelerations, shape (...).

        Raises
        ------
        ValueError
            If a time is not finite, or if a harmonic overflows.
        """
        x = self.coordinates(tau)
        return Motion.from_rpy(*(part for y in x for part in (y[..., :3], y[..., 3:])))

    def coordinates(self, tau: ArrayLike) -> tuple[Array, Array, Array]:
        """Compute the coordinates at given times, with their time derivatives.

        Parameters
        ----------
        tau : array_like, shape (...)
            Times (s).

        Returns
        -------
        y, y_dot, y_ddot : ndarray, shape (..., 6)
            Position (m), and roll, pitch, and yaw (rad), with their first and second time derivatives.

        Raises
        ------
        ValueError
            If a time is not finite.
        """
        time = real_array(tau, "tau", "finite times")
        if not np.isfinite(time).all():
            raise ValueError(f"tau: expected finite times, got {time[~np.isfinite(time)][0]}")
        center = np.concatenate([self.t0, self.theta0])
        coefficients = np.vstack([center, self.sine, self.cosine])
        y, y_dot, y_ddot = harmonics_at(time, self.period, len(self.sine)) @ coefficients
        return y, y_dot, y_ddot


def harmonics_at(time: Array, period: float, count: int) -> Array:
    """Return 1, sines, cosines of the harmonics, and two derivatives of each, shape (3, ..., 2 count + 1)."""
    rate = 2.0 * math.pi / period * np.arange(1, count + 1)
    sin, cos = np.sin(rate * time[..., None]), np.cos(rate * time[..., None])
    one = np.ones((*time.shape, 1))
    rows = (
        [one, sin, cos],
        [0.0 * one, rate * cos, -rate * sin],
        [0.0 * one, -(rate**2) * sin, -(rate**2) * cos],
    )
    return np.array([np.concatenate(row, axis=-1) for row in rows])


@dataclass(frozen=True, eq=False)
class Excitation:
    """Excitation trajectory with the smallest condition number among the candidates.

    Attributes
    ----------
    path : FourierPath
        Periodic motion.
    time : ndarray, shape (n,)
        Times of one period (s).
    motion : Motion
        Motion at ``time``, shape (n,).
    base : BaseParametersResult
        Base parameters of the robot.
    condition : float
        Condition number of the force regressor H^-1 Y over these times, with columns of length 1.
    """

    path: FourierPath
    time: Array
    motion: Motion
    base: BaseParametersResult
    condition: float


def choose_excitation(
    robot: Robot,
    period: float | None = None,
    harmonics: int = 5,
    samples: int = 200,
    candidates: int = 50,
    seed: int = 0,
    progress: Progress = silent,
    identical_legs: bool = False,
) -> Excitation:
    """Choose a periodic motion near the home pose with a well-conditioned regressor.

    The function compares random Fourier series. The amplitude of each candidate is reduced until the motion
    is within all limits of the legs and motors. These are the length, joint angle, speed, and force of a leg,
    and the peak and RMS torque, speed, current, and power of a motor. The limits that depend on forces are
    evaluated with the parameters of the robot. The scaled condition number of H is at most three times its
    value in the home pose.

    Parameters
    ----------
    robot : Robot
        Robot with limits.
    period : float, optional
        Period (s); by default 8 sqrt(r / g) with the radius r of the base points, so that the accelerations
        are of the order of gravity.
    harmonics : int, optional
        Number of harmonics.
    samples : int, optional
        Number of samples in one period.
    candidates : int, optional
        Number of random candidates.
    seed : int, optional
        Random seed.
    progress : callable, optional
        Function that is called with a text and the completed fraction, 0 to 1.
    identical_legs : bool, optional
        Use the base parameters of identical legs, as in ``base_parameters``.

    Returns
    -------
    Excitation
        Path, motion, and condition number of the regressor.

    Raises
    ------
    ValueError
        If an argument is invalid, or if no candidate is within the limits.

    See Also
    --------
    base_parameters : Identifiable combinations of the inertial parameters.
    simulate_experiment : Identification from simulated measurements.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> excitation = ss.choose_excitation(robot, samples=50, candidates=1)
    >>> excitation.motion.shape
    (50,)
    >>> round(excitation.path.period, 3)
    1.782
    """
    need_universal(robot)
    for name, value in (("harmonics", harmonics), ("samples", samples), ("candidates", candidates)):
        _count(value, name)
    need_seed(seed)
    period = _own_period(robot) if period is None else number_in(period, "period", "a duration > 0 s")
    base, home = base_parameters(robot, identical_legs=identical_legs), home_pose(robot)
    size = radius(robot.b)
    width = _WIDTH * np.array([size, size, size, 1.0, 1.0, 1.0]) / np.arange(1, harmonics + 1)[:, None]
    rng, turn = np.random.default_rng(seed), upright(robot)
    best: Excitation | None = None
    for _ in tracked(progress, range(candidates), lambda _: f"choosing among {candidates} motions"):
        # Draws along the axes of the robot make the motion independent of the frame of the robot file.
        draws = (width * rng.normal(size=(2, harmonics, 6))).reshape(2, harmonics, 2, 3) @ turn.T
        sine, cosine = draws.reshape(2, harmonics, 6)
        path = _within_limits(robot, home.t, sine, cosine, period, samples, _REGULAR * home.scaled_condition)
        if path is None:
            continue
        motion = path.sample(path.time_grid(samples))
        condition = _condition(force_regressor(robot, motion, base))
        if best is None or condition < best.condition:
            best = Excitation(path, path.time_grid(samples), motion, base, condition)
    if best is None:
        raise ValueError(
            "robot: no motion near the home pose is within the limits of the legs and motors; "
            "increase the period to reduce speeds and forces"
        )
    return best


def force_regressor(robot: Robot, motion: Motion, base: BaseParametersResult) -> Array:
    """Compute the force regressor H^-1 Y of the base parameters, shape (..., 6, rank), without load.

    Raises
    ------
    ValueError
        If H is singular in a pose.
    """
    H = inverse_dynamics(robot, motion).H
    Y = base.reduce(regressor(robot, motion, columns=base.required_columns()))
    return np.asarray(np.linalg.solve(H, Y))


def _within_limits(
    robot: Robot, t: Array, sine: Array, cosine: Array, period: float, samples: int, condition: float
) -> FourierPath | None:
    """Return the candidate, reduced if necessary, or None if it remains outside the limits."""
    for scale in _SMALLER ** np.arange(_TIMES):
        path = FourierPath(t, np.zeros(3), scale * sine, scale * cosine, period)
        if _allowed(robot, path.sample(path.time_grid(samples)), condition):
            return path
    return None


def _allowed(robot: Robot, motion: Motion, condition: float) -> bool:
    """Return True if a motion is within the limits and its condition number is small enough."""
    found = inverse_dynamics(robot, motion, on_singular="nan")
    if np.any(found.status):
        return False
    scaled = scaled_condition_number(found.H, characteristic_length(robot) or 1.0)
    one_side = abs(np.sum(np.sign(np.linalg.det(found.H)))) == len(scaled)
    return bool(np.all(scaled <= condition) and one_side and _limits_kept(robot, motion, found.F))


def _limits_kept(robot: Robot, motion: Motion, F: Array) -> bool:
    """Return True if legs with forces F (N), shape (n, 6), and their motors are within their limits."""
    legs = inverse_kinematics(robot, motion)
    values = {"F": F, "L": legs.L, "L_dot": legs.L_dot} | limited_angles(robot, motion)
    if robot.drive is not None:
        values |= motor_states(robot, robot.drive, motion, F, legs.L_dot)._asdict()
    used = LimitTracker(robot, None, weights=np.ones(len(F)))
    used.add(slice(None), values)
    return not used.exceeded(0.0)


def _condition(A: Array) -> float:
    """Return the condition number of columns scaled to length 1; inf if they are nearly dependent."""
    stack = A.reshape(-1, A.shape[-1])
    lengths = np.linalg.norm(stack, axis=0)
    if not np.all(lengths > 0.0):
        return math.inf
    # Eigenvalues of the Gram matrix are accurate enough for a comparison, and much faster than an SVD.
    squares = np.linalg.eigvalsh(np.asarray((stack / lengths).T @ (stack / lengths)))
    rounding = len(squares) * np.finfo(np.float64).eps * squares[-1]
    return math.sqrt(squares[-1] / squares[0]) if squares[0] > rounding else math.inf


def _own_period(robot: Robot) -> float:
    """Return the default period (s)."""
    gravity = float(np.linalg.norm(robot.g))
    if gravity == 0.0:
        raise ValueError("period: expected a duration > 0 s for a robot without gravity, got None")
    return 8.0 * math.sqrt(radius(robot.b) / gravity)


def need_seed(value: object) -> None:
    """Raise ValueError unless a seed is a whole number >= 0."""
    whole_number(value, "seed", 0, "a whole number >= 0")


def _count(value: object, name: str) -> None:
    """Check a number of samples, harmonics, or candidates."""
    whole_number(value, name, 1, f"a whole number > 0 and at most {_MOST:,}", _MOST)
