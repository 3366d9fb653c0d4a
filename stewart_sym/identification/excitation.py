"""Excitation: a periodic motion within the machine's limits in whose forces its base parameters show."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..drives.effort import Summary
from ..drives.leg_limits import LEG_LIMITS, limited_angles
from ..drives.motor_states import motor_states
from ..dynamics.home_pose import home_pose, radius, upright
from ..dynamics.inverse_dynamics import inverse_dynamics, need_universal
from ..io.arguments import finite_array, number_in, real_array, whole_number
from ..io.array_types import Array
from ..io.frozen import Frozen
from ..io.progress import Progress, silent, tracked
from ..kinematics.conditioning import characteristic_length, scaled_condition_number
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..motion.motion import Motion
from ..robot.robot import Robot
from .base_parameters import BaseParametersResult, base_parameters
from .parameters import regressor

# Widths of the first harmonic's coefficients: share of the base's radius, and rad.
_WIDTH = np.array([0.1, 0.1, 0.1, 0.2, 0.2, 0.2])
# Largest number of samples, of harmonics and of candidates.
_MOST = 10_000_000
# A candidate is made smaller by this factor, so often at most, until it keeps within the limits.
_SMALLER, _TIMES = 0.8, 16
# Scaled condition number of H along the way, beside that at the home pose.
_REGULAR = 3.0


@dataclass(frozen=True, eq=False)
class FourierPath(Frozen):
    """A periodic motion: position and roll-pitch-yaw angles as sums of sines and cosines about a middle.

    Attributes
    ----------
    t0, theta0 : ndarray
        Position, m, and angles, rad, (3,), about which it swings.
    sine, cosine : ndarray
        Coefficients, (n, 6), of the harmonics 1 to n: columns 0-2 position, m, 3-5 angles, rad.
    period : float
        Duration of one period, s.

    Raises
    ------
    ValueError
        Naming the argument.
    """

    t0: Array
    theta0: Array
    sine: Array
    cosine: Array
    period: float

    def __post_init__(self) -> None:
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
        """Instants of one period, equally spaced.

        Parameters
        ----------
        samples : int
            How many, from 1 to ten million.

        Returns
        -------
        ndarray
            From 0 on, without the end of the period, s, (samples,).

        Raises
        ------
        ValueError
            For any other number.
        """
        _count(samples, "samples")
        return np.arange(samples) * self.period / samples

    def sample(self, tau: ArrayLike) -> Motion:
        """Return the motion at some times, without external load.

        Parameters
        ----------
        tau : array_like
            Times, s, of any shape.

        Returns
        -------
        Motion
            Of the shape of tau.

        Raises
        ------
        ValueError
            For times that are not finite, and where a harmonic overflows.
        """
        x = self.coordinates(tau)
        return Motion.from_rpy(*(part for y in x for part in (y[..., :3], y[..., 3:])))

    def coordinates(self, tau: ArrayLike) -> tuple[Array, Array, Array]:
        """Coordinates at some times, and their derivatives by time.

        Parameters
        ----------
        tau : array_like
            Times, s, of any shape (...).

        Returns
        -------
        y, y_dot, y_ddot : ndarray
            Position, m, and roll-pitch-yaw angles, rad, side by side, and their first and second derivatives,
            each (..., 6).

        Raises
        ------
        ValueError
            For times that are not finite.
        """
        time = real_array(tau, "tau", "finite times")[..., None]
        if not np.isfinite(time).all():
            raise ValueError(f"tau: expected finite times, got {time[~np.isfinite(time)][0]}")
        rate = 2.0 * math.pi / self.period * np.arange(1, len(self.sine) + 1)
        sin, cos = np.sin(rate * time), np.cos(rate * time)
        return (
            np.concatenate([self.t0, self.theta0]) + sin @ self.sine + cos @ self.cosine,
            (rate * cos) @ self.sine - (rate * sin) @ self.cosine,
            -(rate**2 * sin) @ self.sine - (rate**2 * cos) @ self.cosine,
        )


@dataclass(frozen=True, eq=False)
class Excitation:
    """The best of the candidates.

    Attributes
    ----------
    path : FourierPath
        The motion over time.
    time : ndarray
        Instants of one period, s, (n,).
    motion : Motion
        At these, (n,).
    base : BaseParametersResult
        The machine's base parameters.
    condition : float
        Condition number of the forces' regressor H^-1 Y over these instants, its columns of length 1.
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
    """Draw Fourier series about the home pose and keep the one whose regressor is best conditioned.

    Every candidate is made small enough for the limits of the robot's legs, of length, joint angle, speed and
    force, and of its motors, of torque, its root mean square, speed, current and power (those that depend on
    forces with the robot's own parameters), and stays where the scaled condition number of H is at most three
    times that of the home pose.

    Parameters
    ----------
    robot : Robot
        The machine.
    period : float, optional
        s; None: 8 sqrt(size / g), with the radius of the base points as size, in which accelerations are of
        the order of gravity.
    harmonics : int, optional
        Of the Fourier series.
    samples : int, optional
        Instants of one period.
    candidates : int, optional
        Random series to try.
    seed : int, optional
        Of the draws.
    progress : Progress, optional
        Called with what is being done and the share of the candidates that is done, 0 to 1.
    identical_legs : bool, optional
        As for ``base_parameters``.

    Returns
    -------
    Excitation
        Path, motion and condition number of the regressor.

    Raises
    ------
    ValueError
        Naming the argument, and if no candidate keeps within the limits.
    """
    need_universal(robot)
    for name, value in (("harmonics", harmonics), ("samples", samples), ("candidates", candidates)):
        _count(value, name)
    need_seed(seed)
    period = _own_period(robot) if period is None else number_in(period, "period", "a duration > 0 s")
    base, home, size = (
        base_parameters(robot, identical_legs=identical_legs),
        home_pose(robot),
        radius(robot.b),
    )
    width = _WIDTH * np.array([size, size, size, 1.0, 1.0, 1.0]) / np.arange(1, harmonics + 1)[:, None]
    rng, turn = np.random.default_rng(seed), upright(robot)
    best: Excitation | None = None
    for _ in tracked(progress, range(candidates), lambda _: f"choosing among {candidates} motions"):
        # The same draw means the same motion of the machine in whatever axes its file is written.
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
            "robot: found no motion about its home pose within the limits of its legs and motors: "
            "a longer period takes less of their speed and force"
        )
    return best


def force_regressor(robot: Robot, motion: Motion, base: BaseParametersResult) -> Array:
    """H^-1 Y of the base parameters, (..., 6, rank): the actuator forces of each, without load.

    Raises ValueError for poses in which H is singular.
    """
    H = inverse_dynamics(robot, motion).H
    Y = base.reduce(regressor(robot, motion, columns=base.required_columns()))
    return np.asarray(np.linalg.solve(H, Y))


def _within_limits(
    robot: Robot, t: Array, sine: Array, cosine: Array, period: float, samples: int, condition: float
) -> FourierPath | None:
    """The candidate, smaller if need be; None if it still is not within the limits."""
    for scale in _SMALLER ** np.arange(_TIMES):
        path = FourierPath(t, np.zeros(3), scale * sine, scale * cosine, period)
        if _allowed(robot, path.sample(path.time_grid(samples)), condition):
            return path
    return None


def _allowed(robot: Robot, motion: Motion, condition: float) -> bool:
    found = inverse_dynamics(robot, motion, on_singular="nan")
    if np.any(found.status):
        return False
    scaled = scaled_condition_number(found.H, characteristic_length(robot) or 1.0)
    one_side = abs(np.sum(np.sign(np.linalg.det(found.H)))) == len(scaled)
    return bool(np.all(scaled <= condition) and one_side and _limits_kept(robot, motion, found.F))


def _limits_kept(robot: Robot, motion: Motion, F: Array) -> bool:
    """Whether legs, by forces F, N, (n, 6), and their motors keep within their limits."""
    legs = inverse_kinematics(robot, motion)
    values = {"F": F, "L": legs.L, "L_dot": legs.L_dot} | limited_angles(robot, motion)
    stated = [limit for limit in LEG_LIMITS if limit.values in values]
    if not all(np.all(limit.sizes(values[limit.values]) <= limit.bound(robot)) for limit in stated):
        return False
    if robot.drive is None:
        return True
    used = Summary(robot.drive, 0.0)
    used.add(motor_states(robot, robot.drive, motion, F, legs.L_dot), np.ones(len(F)), None)
    return not used.exceeded(0.0)


def _condition(A: Array) -> float:
    """Condition number of the columns, scaled to length 1; inf if they are dependent to half the digits."""
    stack = A.reshape(-1, A.shape[-1])
    lengths = np.linalg.norm(stack, axis=0)
    if not np.all(lengths > 0.0):
        return math.inf
    # Squares are enough to compare by, and a small matrix is much sooner taken apart than a tall one.
    squares = np.linalg.eigvalsh(np.asarray((stack / lengths).T @ (stack / lengths)))
    rounding = len(squares) * np.finfo(np.float64).eps * squares[-1]
    return math.sqrt(squares[-1] / squares[0]) if squares[0] > rounding else math.inf


def _own_period(robot: Robot) -> float:
    gravity = float(np.linalg.norm(robot.g))
    if gravity == 0.0:
        raise ValueError("period: expected a duration > 0 s for a machine without gravity, got None")
    return 8.0 * math.sqrt(radius(robot.b) / gravity)


def need_seed(value: object) -> None:
    """Reject, by ValueError, what is no whole number >= 0."""
    whole_number(value, "seed", 0, "a whole number >= 0")


def _count(value: object, name: str) -> None:
    whole_number(value, name, 1, f"a whole number > 0 and at most {_MOST:,}", _MOST)
