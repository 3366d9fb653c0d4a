"""Inverse kinematics of the legs, (1)-(5) and (8), and the matrix H of (36) with its time derivative."""

import math
from dataclasses import dataclass

import numpy as np

from ..backend.kernel import robot_numbers
from ..backend.native import CompilerError
from ..calls.c_kernel import function, results_of
from ..generated.interface import STRUCTS
from ..io.arguments import instance
from ..io.array_types import Array, Flags
from ..motion.motion import Motion, at_rest
from ..motion.rotation import cross
from ..robot.offset_chains import SLIDING, chains, columns_of_H
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot
from .offset_legs import checked_motion, rate_of_H

MIN_JOINT_SINE = 0.3
"""Smallest sine of the angle between a leg and its universal joint axis k that is clear of a singularity."""

ROUNDING = 16 * np.finfo(np.float64).eps
"""Leg length, relative to the largest of its terms, below which the length is only rounding error."""


MANY = 256
"""Number of poses above which the C code computes the legs if a compiler is available."""


@dataclass(frozen=True, eq=False)
class InverseKinematicsResult:
    """Kinematics of the six legs.

    The leading shape ``(...)`` is the shape of the motion.

    Attributes
    ----------
    L : ndarray, shape (..., 6)
        Leg lengths (m), (2).
    L_dot : ndarray, shape (..., 6)
        Leg rates (m/s), positive when the leg extends, (5).
    L_ddot : ndarray, shape (..., 6), or None
        Leg accelerations (m/s^2), (8). None if the motion has no accelerations.
    s : ndarray, shape (..., 6, 3)
        Unit vectors from base point to platform point in the base frame, (3).
    S : ndarray, shape (..., 6, 3)
        Leg vectors from base point to platform point in the base frame (m), (1).
    """

    L: Array
    L_dot: Array
    L_ddot: Array | None
    s: Array
    S: Array


def inverse_kinematics(robot: Robot, motion: Motion) -> InverseKinematicsResult:
    """Compute lengths, rates, accelerations, and directions of the legs.

    The spin of a leg about its own axis does not enter, so the result is the same for both formulations and
    both base joints.

    Parameters
    ----------
    robot : Robot
        Robot geometry.
    motion : Motion
        Motion of the platform with any leading shape.

    Returns
    -------
    InverseKinematicsResult
        Leg lengths (m), rates (m/s), accelerations (m/s^2), and directions.

    Raises
    ------
    ValueError
        If a leg has length zero, a leg with offset joints has no solution, or a result overflows. Lengths of
        at most 16 rounding units of the largest component of q, t, and b in S = q + t - b, (1), are zero.

    See Also
    --------
    forward_kinematics : Compute poses from leg lengths.
    inverse_jacobian : Matrix that maps the twist of the platform to leg rates.
    motor_angles : Motor angles of the legs, including the screw coupling.

    Notes
    -----
    For offset joints, L is the length along the axis of the prismatic joint and s is the direction of this
    axis. S still points from the base point to the platform point.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> rest = [0.0, 0.0, 0.0]
    >>> motion = ss.Motion.from_rpy(t=[0.2, 0.1, 1.0], theta=rest, v=[0.1, 0.0, 0.0], theta_dot=rest)
    >>> legs = ss.inverse_kinematics(robot, motion)
    >>> legs.L.round(3).tolist()
    [1.109, 1.005, 1.034, 1.122, 1.031, 0.973]
    >>> legs.L_dot.round(3).tolist()
    [-0.009, 0.04, 0.048, 0.027, -0.015, -0.015]
    """
    legs = legs_or_overflow(robot, motion)
    _reject_overflow(legs.L, legs.L_dot, legs.L_ddot)
    return legs


def legs_or_overflow(robot: Robot, motion: Motion) -> InverseKinematicsResult:
    """Compute the result of ``inverse_kinematics`` with infinities and NaN if a value overflows."""
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    if robot.offsets is not None:
        moving = checked_motion(robot, motion)
        seconds = moving.accelerations
        return InverseKinematicsResult(
            L=moving.at.L[..., 0],
            L_dot=moving.rates[..., SLIDING],
            L_ddot=None if seconds is None else seconds[..., SLIDING],
            s=moving.at.s,
            S=moving.at.P,
        )
    found = _compiled_legs(robot, motion) if math.prod(motion.shape) >= MANY else None
    return found or _legs(robot, motion)


def _compiled_legs(robot: Robot, motion: Motion) -> InverseKinematicsResult | None:
    """Compute all leg quantities with the C code; None without a compiler or if a pose has an error."""
    try:
        code = function("legs", "batch")
    except CompilerError:
        return None
    # Without accelerations, any values serve: L_ddot is discarded.
    rates = {"a": motion.v, "alpha": motion.omega} if motion.a is None else {}
    moving = Motion._unchecked(**vars(motion) | rates)
    found = results_of(code, robot_numbers(robot), moving, STRUCTS["legs"])
    if found.pop("status").any():
        return None
    return InverseKinematicsResult(**found | ({} if motion.a is not None else {"L_ddot": None}))


def wrench_matrix(robot: Robot, motion: Motion) -> Array:
    """Compute the matrix H of (36), which maps leg forces to the wrench on the platform.

    Column i is [s_i; q_i x s_i], the wrench of a unit force of leg i about the reference point.

    Parameters
    ----------
    robot : Robot
        Robot geometry.
    motion : Motion
        Poses of the platform with any leading shape; rates are ignored.

    Returns
    -------
    ndarray, shape (..., 6, 6)
        Matrix H in the base frame. Rows 0-2 are dimensionless, rows 3-5 are in m.

    Raises
    ------
    ValueError
        If a leg has length zero or no solution, or if a result overflows.

    See Also
    --------
    wrench_matrix_rate : Time derivative of H.
    inverse_jacobian : H^T, which maps the twist to leg rates.
    condition_number : Distance of H from singularity.

    Notes
    -----
    Leg rates are L_dot = H^T [v; omega]. Actuator forces F exert the wrench H F on the platform. If the upper
    parts of the legs turn on screws, H^T [v; omega] are the motor speeds divided by the transmission ratio N.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> rest = [0.0, 0.0, 0.0]
    >>> motion = ss.Motion.from_rpy(t=[0.2, 0.1, 1.0], theta=rest, v=rest, theta_dot=rest)
    >>> wrench = ss.wrench_matrix(robot, motion) @ np.ones(6)
    >>> wrench.round(3).tolist()
    [0.759, 0.69, 5.505, 0.26, -0.427, -0.503]
    """
    if getattr(robot, "offsets", None) is not None:
        return columns_of_H(robot, checked_motion(robot, motion).G)
    with np.errstate(all="ignore"):
        q, S, L = _vectors(robot, motion)
    _reject_overflow(L)
    return np.swapaxes(length_rows(q, S, L), -1, -2)


def wrench_matrix_rate(robot: Robot, motion: Motion) -> Array:
    """Compute the time derivative of H along a motion.

    Parameters
    ----------
    robot : Robot
        Robot geometry.
    motion : Motion
        Motion of the platform with any leading shape; accelerations are ignored.

    Returns
    -------
    ndarray, shape (..., 6, 6)
        Time derivative of H in the base frame. Rows 0-2 are in 1/s, rows 3-5 in m/s.

    Raises
    ------
    ValueError
        If a leg has length zero or no solution, or if a result overflows.

    See Also
    --------
    wrench_matrix : Matrix H.
    forward_acceleration : Compute platform accelerations from leg accelerations.

    Notes
    -----
    Leg accelerations are L_ddot = H^T [a; alpha] + H_dot^T [v; omega].

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> v, omega, zero = [0.1, 0.0, 0.0], [0.0, 0.0, 0.5], np.zeros(3)
    >>> motion = ss.Motion(R=np.eye(3), t=[0.2, 0.1, 1.0], omega=omega, v=v, alpha=zero, a=zero)
    >>> L_ddot = ss.wrench_matrix_rate(robot, motion).T @ np.concatenate([v, omega])
    >>> np.allclose(L_ddot, ss.inverse_kinematics(robot, motion).L_ddot)
    True
    """
    if getattr(robot, "offsets", None) is not None:
        return rate_of_H(robot, motion)
    with np.errstate(all="ignore"):
        q, S, L = _vectors(robot, motion)
        s, q_dot = S / L[..., None], cross(motion.omega[..., None, :], q)
        S_dot = q_dot + motion.v[..., None, :]
        s_dot = (S_dot - _dot(s, S_dot)[..., None] * s) / L[..., None]
        rows = np.concatenate([s_dot, cross(q_dot, s) + cross(q, s_dot)], axis=-1)
    _reject_overflow(L, rows)
    return np.swapaxes(rows, -1, -2)


def leg_vectors(robot: Robot, R: Array, t: Array) -> tuple[Array, Array, Array]:
    """Return q and S of (1) in the base frame (m), shape (..., 6, 3), and the lengths of S (m), (..., 6).

    Lengths of zero are not rejected.
    """
    need_no_offsets(robot)
    q = robot.p @ np.swapaxes(R, -1, -2)
    S = q + t[..., None, :] - robot.b
    return q, S, np.sqrt(np.einsum("...i,...i->...", S, S))


def leg_axes(robot: Robot, R: Array, t: Array) -> tuple[Array, Array, Array]:
    """Return q and vectors along the prismatic joints (m), (..., 6, 3), and lengths (m), (..., 6).

    Legs may have offsets. NaN if a leg has no solution.
    """
    if robot.offsets is None:
        return leg_vectors(robot, R, t)
    with np.errstate(all="ignore"):
        at = chains(robot, at_rest(R, t))
    return at.q, at.s * at.L, at.L[..., 0]


def leg_lengths(robot: Robot, R: Array, t: Array) -> Array:
    """Return the leg lengths (m), shape (..., 6), of legs with or without offsets; NaN without a solution."""
    return leg_axes(robot, R, t)[2]


def length_rows(q: Array, S: Array, L: Array) -> Array:
    """Return H^T of (5), shape (..., 6, 6), from q, S, and L.

    A leg of length zero has no direction: its row is 0, so the matrix is singular.
    """
    s = S / np.where(L > 0.0, L, 1.0)[..., None]
    return np.concatenate([s, cross(q, s)], axis=-1)


def joint_sines(robot: Robot, s: Array) -> Array:
    """Return the sines of the angles between legs along s and their universal joint axes, shape (..., 6).

    Spherical base joints have the value 1.
    """
    need_no_offsets(robot)
    if robot.base_joint == "spherical":
        return np.ones(s.shape[:-1])
    return np.asarray(np.linalg.norm(cross(robot.k, s), axis=-1))


def tip_velocities(motion: Motion, q: Array) -> Array:
    """Return S_dot of (4) in the base frame (m/s) for platform points q, both of shape (..., 6, 3)."""
    return cross(motion.omega[..., None, :], q) + motion.v[..., None, :]


def clear_of_joint_singularities(robot: Robot, legs: InverseKinematicsResult) -> Flags:
    """Return True for poses whose legs are all clear of their universal joint axes k, shape (...).

    A leg is clear if the sine of its angle to k is at least ``MIN_JOINT_SINE``. Spherical base joints are
    always clear.
    """
    return np.asarray((joint_sines(robot, legs.s) >= MIN_JOINT_SINE).all(axis=-1))


def _vectors(robot: Robot, motion: Motion) -> tuple[Array, Array, Array]:
    """Return ``leg_vectors``; raise ValueError for the first leg of length zero."""
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    q, S, L = leg_vectors(robot, motion.R, motion.t)
    reach = np.maximum(np.abs(q).max(axis=-1), np.abs(robot.b).max(axis=-1))
    reach = np.maximum(reach, np.abs(motion.t).max(axis=-1)[..., None])
    short = np.argwhere(ROUNDING * reach >= L)
    if short.size:
        *pose, leg = (int(i) for i in short[0])
        where = f" at motion[{', '.join(map(str, pose))}]" if pose else ""
        raise ValueError(f"motion: leg {leg + 1} has length zero{where}")
    return q, S, L


def _legs(robot: Robot, motion: Motion) -> InverseKinematicsResult:
    """Compute all leg quantities with NumPy."""
    with np.errstate(all="ignore"):
        q, S, L = _vectors(robot, motion)
        s = S / L[..., None]
        S_dot = tip_velocities(motion, q)
        L_dot, L_ddot = _dot(s, S_dot), None
        if motion.a is not None and motion.alpha is not None:
            omega, alpha = motion.omega[..., None, :], motion.alpha[..., None, :]
            S_ddot = cross(alpha, q) + cross(omega, cross(omega, q)) + motion.a[..., None, :]
            # The term L W.W of (8), from the component of S_dot normal to the leg: |W x S| = L |W|.
            across = S_dot - L_dot[..., None] * s
            L_ddot = _dot(s, S_ddot) + _dot(across, across) / L
    return InverseKinematicsResult(L, L_dot, L_ddot, s, S)


def _dot(x: Array, y: Array) -> Array:
    return np.asarray(np.einsum("...i,...i->...", x, y))


def _reject_overflow(*results: Array | None) -> None:
    if not all(values is None or np.isfinite(values).all() for values in results):
        raise ValueError("motion: the kinematics of its legs overflow")
