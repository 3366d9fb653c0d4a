"""Forward kinematics: platform pose, velocity, and acceleration from leg lengths, (2), (5), (8).

Six leg lengths have up to forty poses. Each of them is called an assembly mode. The start of the search
determines which assembly mode is found.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import finite_array, instance, leading_shape, option, truth
from ..io.array_types import Array, Codes, Flags
from ..motion.motion import Motion, pose_of
from ..results import (
    NOT_CONVERGED,
    NOT_FINITE,
    OK,
    ON_FAULT,
    OUT_OF_LIMITS,
    SINGULAR,
    STATUS_TEXT,
    Accelerations,
    OnFault,
    Velocities,
    report_faults,
)
from ..robot.robot import Robot
from .conditioning import condition_number, moments_over
from .inverse_kinematics import legs_or_overflow
from .pose_search import (
    EPS,
    MOST_STARTS,
    impossible_pairs,
    nearest_poses,
    newton,
    platform_size,
    rates_per_twist,
    search_poses,
    solve,
)

Status = Codes
Guess = tuple[ArrayLike, ArrayLike]
REASONS = STATUS_TEXT | {SINGULAR: "H is singular: leg lengths and rates determine neither pose nor twist"}
"""One-line text for each status code of forward kinematics."""
# Largest condition number of a pose that its lengths determine. Near a singular pose, up to a distance of
# about sqrt(eps), a second pose can have the same lengths to rounding.
_MOST_CONDITION = 1.0 / (16.0 * math.sqrt(EPS))


@dataclass(frozen=True, eq=False)
class ForwardKinematicsResult:
    """Platform poses computed from leg lengths.

    The leading shape ``(...)`` is the common shape of the lengths and the guess.

    Attributes
    ----------
    R : ndarray, shape (..., 3, 3)
        Rotation matrix from the platform frame to the base frame. NaN if the status is not 0.
    t : ndarray, shape (..., 3)
        Position of the reference point in the base frame (m). NaN if the status is not 0.
    residual : ndarray, shape (...)
        Largest difference between the given lengths and the lengths of the returned pose (m). If no pose was
        found, the difference at the end of the last search.
    iterations : ndarray of int, shape (...)
        Number of Newton steps. Without a guess, it is the sum over all starts. With a guess, it is the sum
        over the first search and all further searches whose pose replaced an earlier one.
    status : ndarray of int, shape (...)
        ``results.OK``, ``NOT_CONVERGED``, ``SINGULAR`` (a pose with these lengths was found, but so close to
        a singular pose that the lengths do not determine it), or ``OUT_OF_LIMITS``.
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
    """Compute the platform poses from leg lengths by damped Newton steps on (2).

    If several assembly modes are found from a guess, the result is the pose nearest to the guess. The
    distance is the root of the sum of squares of the translation (m) and the rotation angle (rad). There is
    no guarantee that every nearer pose is found. With offset joints, the result is the pose to which Newton
    steps from the guess converge.

    Parameters
    ----------
    robot : Robot
        Robot geometry and length limits.
    L : array_like, shape (..., 6)
        Leg lengths (m).
    guess : tuple of array_like, optional
        Start pose (R, t) with shapes (..., 3, 3) and (..., 3). By default the search starts nearly parallel
        to the base, on the side of the home pose; without a home pose, on the side opposite to gravity, see
        ``up_direction``. If no pose is found, the search continues from rotated poses on this side, then from
        poses on the other side, and at last from random poses, up to 100 starts in total.
    on_failure : {"raise", "nan", "warn"}, optional
        Reaction to a status other than 0 (no pose found, a pose too close to a singular pose, or lengths
        outside the limits): raise ValueError, return NaN, or warn and return NaN. ``status`` contains the
        result code of each pose.
    check_limits : bool, optional
        If True, lengths outside the robot's ``length_limits`` are failures.

    Returns
    -------
    ForwardKinematicsResult
        Poses, residuals, numbers of steps, and status codes.

    Raises
    ------
    ValueError
        If lengths are not finite and positive, if the guess is not a pose, or, with ``on_failure="raise"``,
        if a status is not 0. If no pose was found, the error names two legs with incompatible lengths, or
        states the extent of the search.

    See Also
    --------
    inverse_kinematics : Compute leg lengths from poses.
    certify_pose : Prove that a pose has the given leg lengths.
    up_direction : Side of the base on which the search starts.

    Notes
    -----
    A pose is found if its lengths agree with ``L`` to 16 eps times the largest component of R p, t, and b in
    S = R p + t - b, (1), where eps = 2.2e-16. Six leg lengths have up to forty poses (M. Raghavan, J. Mech.
    Des. 115, 1993).

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> pose = ss.forward_kinematics(robot, [1.109, 1.005, 1.034, 1.122, 1.031, 0.973])
    >>> pose.t.round(2).tolist()
    [0.2, 0.1, 1.0]
    >>> int(pose.status)
    0
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
        # Without a guess, the search begins at the solutions for legs without offsets.
        ends = newton(robot, flat, *(poses or search_poses(replace(robot, offsets=None), flat)[:2]))
    else:
        ends = search_poses(robot, flat) if poses is None else nearest_poses(robot, flat, *poses)
    R, t, residual, iterations, found = ends
    status = np.full(len(flat), NOT_CONVERGED)
    status[found] = np.where(_unsettled(robot, rates_per_twist(robot, R[found], t[found])), SINGULAR, OK)
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

    report_faults(result.status, "L", reason, on_failure)
    return result


def fault(robot: Robot, L: Array, status: int, guessed: bool) -> str:
    """Return the error text for six lengths with a nonzero status."""
    if status == OUT_OF_LIMITS:
        low, high = robot.length_limits.T
        leg = int(np.argmax((L < low) | (L > high)))
        return f"leg {leg + 1}: expected a length from {low[leg]:.6g} to {high[leg]:.6g} m, got {L[leg]:.6g}"
    if status != NOT_CONVERGED:
        return REASONS[status]
    if robot.offsets is not None:
        return f"{REASONS[status]} {'from the guess' if guessed else 'from the pose of legs without offsets'}"
    pairs = np.argwhere(impossible_pairs(robot, L))
    if len(pairs):
        one, other = (int(leg) + 1 for leg in pairs[0])
        return f"{REASONS[status]}: none exists, legs {one} and {other} cannot have these lengths together"
    tried = "from the guess and about it" if guessed else f"from {MOST_STARTS} starts"
    return f"{REASONS[status]} {tried}, which does not prove that no pose exists"


def forward_velocity(
    robot: Robot, R: ArrayLike, t: ArrayLike, L_dot: ArrayLike, on_failure: OnFault = "raise"
) -> Velocities:
    """Compute the twist of the platform from leg rates by solving L_dot = H^T [v; omega], (5).

    Parameters
    ----------
    robot : Robot
        Robot geometry.
    R : array_like, shape (..., 3, 3)
        Rotation matrix from the platform frame to the base frame.
    t : array_like, shape (..., 3)
        Position of the reference point in the base frame (m).
    L_dot : array_like, shape (..., 6)
        Leg rates (m/s).
    on_failure : {"raise", "nan", "warn"}, optional
        Reaction to a pose at which H is singular, or to an overflow: raise ValueError, return NaN, or warn
        and return NaN.

    Returns
    -------
    Velocities
        Named tuple (v, omega) in the base frame: velocity of the reference point (m/s) and angular velocity
        (rad/s), each of shape (..., 3).

    Raises
    ------
    ValueError
        If an argument is invalid, a leg has length zero, or ``on_failure="raise"`` and H is singular or the
        result overflows.

    See Also
    --------
    jacobian : Jacobian H^-T, which maps leg rates to the twist.
    forward_acceleration : Compute platform accelerations from leg accelerations.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> L_dot = [0.0, 0.0, 0.0, 0.1, 0.1, 0.1]
    >>> v, omega = ss.forward_velocity(robot, R=np.eye(3), t=[0.2, 0.1, 1.0], L_dot=L_dot)
    >>> v.round(3).tolist()
    [0.25, 0.226, 0.001]
    >>> omega.round(3).tolist()
    [-0.596, -0.148, -0.085]
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
    """Compute the acceleration of the platform from leg accelerations, (8).

    The equation is L_ddot = H^T [a; alpha] plus the velocity terms of (8).

    Parameters
    ----------
    robot : Robot
        Robot geometry.
    R : array_like, shape (..., 3, 3)
        Rotation matrix from the platform frame to the base frame.
    t : array_like, shape (..., 3)
        Position of the reference point in the base frame (m).
    v : array_like, shape (..., 3)
        Velocity of the reference point in the base frame (m/s).
    omega : array_like, shape (..., 3)
        Angular velocity of the platform in the base frame (rad/s).
    L_ddot : array_like, shape (..., 6)
        Leg accelerations (m/s^2).
    on_failure : {"raise", "nan", "warn"}, optional
        Reaction to a pose at which H is singular, or to an overflow: raise ValueError, return NaN, or warn
        and return NaN.

    Returns
    -------
    Accelerations
        Named tuple (a, alpha) in the base frame: acceleration of the reference point (m/s^2) and angular
        acceleration (rad/s^2), each of shape (..., 3).

    Raises
    ------
    ValueError
        If an argument is invalid, a leg has length zero, or ``on_failure="raise"`` and H is singular or the
        result overflows.

    See Also
    --------
    forward_velocity : Compute the twist from leg rates.
    wrench_matrix_rate : Time derivative of H.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = dict(R=np.eye(3), t=[0.2, 0.1, 1.0], v=[0.1, 0.0, 0.0], omega=[0.0, 0.0, 0.5])
    >>> a, alpha = ss.forward_acceleration(robot, **motion, L_ddot=np.ones(6))
    >>> a.round(3).tolist()
    [0.136, 0.244, 0.921]
    >>> alpha.round(3).tolist()
    [-0.057, -0.2, -0.892]
    """
    return Accelerations(*_rates(robot, R, t, (v, omega), L_ddot, "L_ddot", on_failure))


def twist_per_rates(robot: Robot, R: Array, t: Array) -> Array:
    """Return (H^T)^-1, which maps leg rates to the twist, shape (..., 6, 6); NaN if H is nearly singular."""
    J = rates_per_twist(robot, R, t)
    unsettled = _unsettled(robot, J)[..., None, None]
    return np.where(unsettled, np.nan, np.linalg.inv(np.where(unsettled, np.eye(6), J)))


def checked_lengths(L: ArrayLike) -> Array:
    """Return L as float64, shape (..., 6); raise ValueError unless all lengths are finite and positive."""
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
    """Solve (5) or (8) for the highest derivatives; ``twist`` is (v, omega), and zero for (5)."""
    instance(robot, Robot, "robot")
    option(on_failure, ON_FAULT, "on_failure")
    v, omega = twist
    motion = Motion(R=R, t=t, omega=omega, v=v, alpha=np.zeros(3), a=np.zeros(3))  # type: ignore[arg-type]
    wanted = finite_array(rates, (6,), name)
    shape = leading_shape({"R": motion.shape, name: wanted.shape[:-1]})
    with np.errstate(over="ignore", invalid="ignore"):
        # The platform has no acceleration here, so L_ddot contains only the velocity terms of (8).
        wanted = wanted - np.asarray(legs_or_overflow(robot, motion).L_ddot)
        J = rates_per_twist(robot, motion.R, motion.t)
        unsettled = np.broadcast_to(_unsettled(robot, J), shape)
        solution, _ = solve(np.broadcast_to(J, (*shape, 6, 6)), np.broadcast_to(wanted, (*shape, 6)))
    finite = np.all(np.isfinite(solution), axis=-1)
    status = np.where(unsettled, SINGULAR, np.where(finite, OK, NOT_FINITE))
    solution[status != OK] = np.nan

    report_faults(status, name, lambda at: REASONS[int(status[at])], on_failure)
    return solution[..., :3], solution[..., 3:]


def _unsettled(robot: Robot, J: Array) -> Flags:
    """Return True for poses with H so close to singular that rounded lengths do not determine the pose."""
    H = moments_over(np.swapaxes(J, -1, -2), platform_size(robot))
    size = np.linalg.norm(H, axis=(-2, -1))
    # The condition number is s_1 (s_1 ... s_5) / |det H|. The product of five singular values is at most
    # (sum of squares / 5)^2.5, by the inequality of the means.
    with np.errstate(all="ignore"):
        most = np.asarray(size * (size**2 / 5.0) ** 2.5 / np.abs(np.linalg.det(H)))
    doubtful = np.asarray(~(most <= 0.5 * _MOST_CONDITION))
    doubtful[doubtful] = ~(condition_number(H[doubtful]) <= _MOST_CONDITION)
    return doubtful
