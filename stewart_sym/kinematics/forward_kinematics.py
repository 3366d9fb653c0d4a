"""Forward kinematics: pose, velocity and acceleration of the platform from those of its legs, (2), (5), (8).

Six leg lengths belong to up to forty poses, the assembly modes: which one is found depends on where the
search starts.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io import error_policy
from ..io.arguments import finite_array, instance, leading_shape, option, truth
from ..io.array_types import Array, Codes, Flags
from ..io.error_policy import ON_FAULT, OnFault
from ..motion.motion import Motion, pose_of
from ..results import (
    NOT_CONVERGED,
    NOT_FINITE,
    OK,
    OUT_OF_LIMITS,
    SINGULAR,
    STATUS_TEXT,
    Accelerations,
    Velocities,
)
from ..robot.robot import Robot
from .conditioning import condition_number, moments_over
from .inverse_kinematics import legs_or_overflow
from .offset_legs import without_offsets
from .pose_search import (
    EPS,
    MOST_STARTS,
    impossible_pairs,
    jacobian,
    nearest_found,
    newton,
    platform_size,
    searched,
    solve,
)

Status = Codes
Guess = tuple[ArrayLike, ArrayLike]
REASONS = STATUS_TEXT | {SINGULAR: "H is singular there: leg lengths and rates do not settle the platform's"}
"""One line for each status code of forward kinematics."""
# Lengths known to rounding tell two assembly modes apart only if they lie sqrt(eps) from a singular pose.
_MOST_CONDITION = 1.0 / (16.0 * math.sqrt(EPS))


@dataclass(frozen=True, eq=False)
class ForwardKinematicsResult:
    """Poses found from leg lengths; a leading shape ``(...)`` is that of the lengths and the guess.

    Attributes
    ----------
    R : ndarray
        Orientation, platform to base, (..., 3, 3).
    t : ndarray
        Position of the reference point, m, (..., 3). Both are nan where the status is not 0.
    residual : ndarray
        Largest difference between the lengths requested and those of the last pose tried, m, (...).
    iterations : ndarray of int
        Steps taken, those from starts that led nowhere included; int, (...).
    status : Status
        ``results.OK``, NOT_CONVERGED, SINGULAR (lengths fit, but the pose is not settled by them) or
        OUT_OF_LIMITS; int, (...).
    """

    R: Array
    t: Array
    residual: Array
    iterations: NDArray[np.int64]
    status: Status


def forward_kinematics(
    robot: Robot,
    L: ArrayLike,
    guess: Guess | None = None,
    on_failure: OnFault = "raise",
    check_limits: bool = True,
) -> ForwardKinematicsResult:
    """Return the poses in which the legs have the lengths L, by damped Newton steps on (2).

    A pose with status 0 has lengths within 16 rounding units of the largest component of the terms of S = q +
    t - b. Of the assembly modes found from a guess it is the one nearest to it, by the root of the sum of
    squares in m and rad. Where none is found, the error says what was tried, or why there is none.

    Parameters
    ----------
    robot : Robot
        The machine.
    L : array_like
        m, (..., 6).
    guess : Guess, optional
        Pose (R, t) to start from, (..., 3, 3) and (..., 3); None: nearly parallel to the base and on the
        side that ``platform_side`` returns, against gravity; where no pose is found from there, other such
        poses, and in the end the other side.
    on_failure : {"raise", "nan", "warn"}, optional
        What to do about lengths without a pose: "raise" ValueError, "warn" and return nan there, or return
        "nan" without a warning; ``status`` is that of each pose.
    check_limits : bool, optional
        Whether lengths outside the robot's length_limits count as a failure.

    Returns
    -------
    ForwardKinematicsResult
        Poses, residuals, iterations and statuses.

    Raises
    ------
    ValueError
        Naming the argument for lengths that are not > 0 and finite, and for a guess that is no pose.
    """
    instance(robot, Robot, "robot")
    option(on_failure, ON_FAULT, "on_failure")
    truth(check_limits, "check_limits")
    lengths = checked_lengths(L)
    shape = lengths.shape[:-1]
    poses = None
    if guess is not None:
        start = pose_of(guess, "guess", "a pose (R, t) or None")
        shape = leading_shape({"L": shape, "guess": start.shape})
        R_0, t_0 = np.broadcast_to(start.R, (*shape, 3, 3)), np.broadcast_to(start.t, (*shape, 3))
        poses = R_0.reshape(-1, 3, 3), t_0.reshape(-1, 3)
    flat = np.broadcast_to(lengths, (*shape, 6)).reshape(-1, 6)
    if robot.offsets is not None:
        # Without a guess, from the poses of legs whose axes meet.
        ends = newton(robot, flat, *(poses or searched(without_offsets(robot), flat)[:2]))
    else:
        ends = searched(robot, flat) if poses is None else nearest_found(robot, flat, *poses)
    R, t, residual, iterations, found = ends
    status = np.full(len(flat), NOT_CONVERGED)
    status[found] = np.where(_unsettled(robot, jacobian(robot, R[found], t[found])), SINGULAR, OK)
    if check_limits:
        low, high = robot.length_limits.T
        status = np.where(np.any((flat < low) | (flat > high), axis=-1), OUT_OF_LIMITS, status)
    bad = status != OK
    R[bad], t[bad] = np.nan, np.nan
    result = ForwardKinematicsResult(
        R.reshape(*shape, 3, 3),
        t.reshape(*shape, 3),
        residual.reshape(shape),
        iterations.reshape(shape),
        status.astype(np.int32).reshape(shape),
    )

    def reason(at: tuple[int, ...]) -> str:
        leg_lengths = np.broadcast_to(lengths, (*shape, 6))[at]
        return fault(robot, leg_lengths, int(result.status[at]), guess is not None)

    error_policy.report(result.status, "L", reason, on_failure)
    return result


def fault(robot: Robot, L: Array, status: int, guessed: bool) -> str:
    """Return in words why lengths (6,) have no pose, by the status: proven, or how far was looked for one."""
    if status == OUT_OF_LIMITS:
        low, high = robot.length_limits.T
        leg = int(np.argmax((L < low) | (L > high)))
        return f"leg {leg + 1}: expected a length from {low[leg]:.6g} to {high[leg]:.6g} m, got {L[leg]:.6g}"
    if status != NOT_CONVERGED:
        return REASONS[status]
    if robot.offsets is not None:
        return f"{REASONS[status]} {'from the guess' if guessed else 'from that of legs without offsets'}"
    pairs = np.argwhere(impossible_pairs(robot, L))
    if len(pairs):
        one, other = (int(leg) + 1 for leg in pairs[0])
        return f"{REASONS[status]}: none exists, legs {one} and {other} cannot have theirs at once"
    tried = "from the guess and about it" if guessed else f"from {MOST_STARTS} starts"
    return f"{REASONS[status]} {tried}, which does not prove that there is none"


def forward_velocity(
    robot: Robot, R: ArrayLike, t: ArrayLike, L_dot: ArrayLike, on_failure: OnFault = "raise"
) -> Velocities:
    """Return (v, omega), a named tuple, m/s and rad/s, (..., 3), base frame: L_dot = H^T [v; omega], (5).

    Parameters
    ----------
    robot : Robot
        The machine.
    R, t : array_like
        Pose, (..., 3, 3) and (..., 3).
    L_dot : array_like
        Rates of the legs, m/s, (..., 6).
    on_failure : {"raise", "nan", "warn"}, optional
        As in ``forward_kinematics``, about poses where H is singular or the result overflows.

    Returns
    -------
    Velocities
        Named tuple (v, omega), m/s and rad/s, (..., 3).

    Raises
    ------
    ValueError
        Naming the argument; as ``inverse_kinematics`` for a leg of length zero.
    """
    still = np.zeros(3)
    return Velocities(*_rates(robot, R, t, (still, still), L_dot, "L_dot", on_failure))


def forward_acceleration(
    robot: Robot,
    R: ArrayLike,
    t: ArrayLike,
    v: ArrayLike,
    omega: ArrayLike,
    L_ddot: ArrayLike,
    on_failure: OnFault = "raise",
) -> Accelerations:
    """Return (a, alpha), a named tuple, m/s^2 and rad/s^2, (..., 3), base frame.

    L_ddot = H^T [a; alpha] + what the velocities alone make of it, (8).

    Parameters
    ----------
    robot : Robot
        The machine.
    R : array_like
        Orientation, platform to base, (..., 3, 3).
    t : array_like
        Position of the reference point, m, (..., 3).
    v, omega : array_like
        Of the platform, m/s and rad/s, (..., 3).
    L_ddot : array_like
        Accelerations of the legs, m/s^2, (..., 6). The rest as in ``forward_velocity``.
    on_failure : {"raise", "nan", "warn"}, optional
        What to do about lengths without a pose: raise, return NaN, or warn and return NaN.

    Returns
    -------
    Accelerations
        Named tuple (a, alpha), m/s^2 and rad/s^2, (..., 3).
    """
    return Accelerations(*_rates(robot, R, t, (v, omega), L_ddot, "L_ddot", on_failure))


def inverse_jacobian(robot: Robot, R: Array, t: Array) -> Array:
    """Return J^-1 at poses, (..., 6, 6), which takes rates of the legs to twists; NaN where H is singular."""
    J = jacobian(robot, R, t)
    unsettled = _unsettled(robot, J)[..., None, None]
    return np.where(unsettled, np.nan, np.linalg.inv(np.where(unsettled, np.eye(6), J)))


def checked_lengths(L: ArrayLike) -> Array:
    """Return L, (..., 6), as float64; ValueError unless they are finite and > 0."""
    lengths = finite_array(L, (6,), "L")
    if np.any(lengths <= 0.0):
        where = tuple(int(i) for i in np.argwhere(lengths <= 0.0)[0])
        raise ValueError(f"L: expected lengths > 0 m, entry {where} is {lengths[where]}")
    return lengths


# Rates


def _rates(
    robot: Robot,
    R: ArrayLike,
    t: ArrayLike,
    twist: tuple[ArrayLike, ArrayLike],
    rates: ArrayLike,
    name: str,
    on_failure: str,
) -> tuple[Array, Array]:
    """Solve (5) or (8) for the highest derivatives; ``twist``: what the velocities are, 0 for (5)."""
    instance(robot, Robot, "robot")
    option(on_failure, ON_FAULT, "on_failure")
    v, omega = twist
    motion = Motion(R=R, t=t, omega=omega, v=v, alpha=np.zeros(3), a=np.zeros(3))  # type: ignore[arg-type]
    wanted = finite_array(rates, (6,), name)
    shape = leading_shape({"R": motion.shape, name: wanted.shape[:-1]})
    with np.errstate(over="ignore", invalid="ignore"):
        # Without accelerations of the platform, what remains of L_ddot is what its velocities make of it.
        wanted = wanted - np.asarray(legs_or_overflow(robot, motion).L_ddot)
        J = jacobian(robot, motion.R, motion.t)
        unsettled = np.broadcast_to(_unsettled(robot, J), shape)
        solution, _ = solve(np.broadcast_to(J, (*shape, 6, 6)), np.broadcast_to(wanted, (*shape, 6)))
    finite = np.all(np.isfinite(solution), axis=-1)
    status = np.where(unsettled, SINGULAR, np.where(finite, OK, NOT_FINITE))
    solution[status != OK] = np.nan

    error_policy.report(status, name, lambda at: REASONS[int(status[at])], on_failure)
    return solution[..., :3], solution[..., 3:]


def _unsettled(robot: Robot, J: Array) -> Flags:
    """Where H = J^T is so near to singular that lengths known to rounding leave the pose open."""
    H = moments_over(np.swapaxes(J, -1, -2), platform_size(robot))
    size = np.linalg.norm(H, axis=(-2, -1))
    # The smallest singular value is at least |det H| over the fifth power of the mean of the others.
    with np.errstate(all="ignore"):
        most = np.asarray(size * (size**2 / 5.0) ** 2.5 / np.abs(np.linalg.det(H)))
    doubtful = np.asarray(~(most <= 0.5 * _MOST_CONDITION))
    doubtful[doubtful] = ~(condition_number(H[doubtful]) <= _MOST_CONDITION)
    return doubtful
