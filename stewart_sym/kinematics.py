"""Inverse kinematics of the legs, (1)-(5) and (8), and H of (36) with its rate, from the platform's motion.

Stands beside ``reference`` and above ``Robot`` and ``Motion``; knows nothing of forces.
"""

import dataclasses
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .checks import instance
from .motion import Motion
from .robot import Robot
from .rotation import cross

Array = NDArray[np.float64]

MIN_SIN_POLE = 0.3
"""Sine of the angle between a leg and its universal axis from which on the leg is clear of it."""

ROUNDING = 16 * np.finfo(np.float64).eps
"""A leg no longer than this share of the terms it is the sum of is rounding error and nothing else."""


@dataclass(frozen=True, eq=False)
class LegKinematics:
    """Kinematics of the six legs; a leading shape ``(...)`` is that of the motion.

    L: lengths, m, (..., 6), (2).
    L_dot: rates, m/s, (..., 6), positive when the leg extends, (5).
    L_ddot: accelerations, m/s^2, (..., 6), (8); None when the motion has no accelerations.
    s: unit vectors from base point to platform point, base frame, (..., 6, 3), (3).
    S: leg vectors, m, base frame, (..., 6, 3), (1).
    """

    L: Array
    L_dot: Array
    L_ddot: Array | None
    s: Array
    S: Array


def inverse_kinematics(robot: Robot, motion: Motion) -> LegKinematics:
    """Return lengths, rates and directions of the legs.

    The spin of a leg about its own axis has no part in these, so they are the same in both formulations and
    for either base joint.  Raises ``ValueError`` naming the leg when one has length zero: no more than 16
    rounding units of the largest component of the terms of S = q + t - b, (1); and when a result overflows.
    """
    legs = legs_or_overflow(robot, motion)
    _refuse_overflow(legs.L, legs.L_dot, legs.L_ddot)
    return legs


def legs_or_overflow(robot: Robot, motion: Motion) -> LegKinematics:
    """As ``inverse_kinematics``, but with infinities and NaN where a result overflows."""
    legs, q, S_dot = _legs(robot, motion)
    with np.errstate(all="ignore"):
        return dataclasses.replace(legs, L_ddot=_second_rate(motion, q, legs, S_dot))


def wrench_matrix(robot: Robot, motion: Motion) -> Array:
    """Return H of (36), (..., 6, 6): column i is [s_i; q_i x s_i], the wrench of a unit force of leg i.

    Rows 0-2 have no unit, rows 3-5 are m. Leg rates are L_dot = H^T [v; omega], actuator forces push with the
    wrench H F.  Raises ``ValueError`` as ``inverse_kinematics``.
    """
    legs, q, _ = _legs(robot, motion)
    _refuse_overflow(legs.L)
    return _columns(legs.s, np.cross(q, legs.s))


def wrench_matrix_rate(robot: Robot, motion: Motion) -> Array:
    """Return the time derivative of H along the motion, (..., 6, 6), 1/s and m/s.

    With it L_ddot = H^T [a; alpha] + H_dot^T [v; omega].  Raises ``ValueError`` as ``inverse_kinematics``.
    """
    legs, q, S_dot = _legs(robot, motion)
    with np.errstate(all="ignore"):
        s_dot = (S_dot - legs.L_dot[..., None] * legs.s) / legs.L[..., None]
        q_dot = np.cross(motion.omega[..., None, :], q)
        H_dot = _columns(s_dot, np.cross(q_dot, legs.s) + np.cross(q, s_dot))
    _refuse_overflow(legs.L, H_dot)
    return H_dot


def leg_vectors(robot: Robot, R: Array, t: Array) -> tuple[Array, Array, Array]:
    """Return q and S of (1), m, base frame, (..., 6, 3), and the lengths of S, m, (..., 6), zero or not."""
    q = np.einsum("...jk,ik->...ij", R, robot.p)
    S = q + t[..., None, :] - robot.b
    return q, S, np.linalg.norm(S, axis=-1)


def tip_velocities(motion: Motion, q: Array) -> Array:
    """Return S_dot of (4), m/s, base frame, (..., 6, 3), of platform points at q (..., 6, 3)."""
    return cross(motion.omega[..., None, :], q) + motion.v[..., None, :]


def clear_of_poles(robot: Robot, legs: LegKinematics) -> NDArray[np.bool_]:
    """Whether all six legs are clear of their universal axes k, (...,); always with spherical base joints.

    Clear: the sine of the angle between k and s is ``MIN_SIN_POLE`` or more.
    """
    sines = np.linalg.norm(np.cross(robot.k, legs.s), axis=-1)
    return np.asarray((sines >= MIN_SIN_POLE).all(axis=-1) | (robot.base_joint == "spherical"))


def _legs(robot: Robot, motion: Motion) -> tuple[LegKinematics, Array, Array]:
    """Lengths, rates and directions, with q of (1) and S_dot of (4), both (..., 6, 3)."""
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    with np.errstate(all="ignore"):
        q, S, L = leg_vectors(robot, motion.R, motion.t)
        S_dot = tip_velocities(motion, q)
    reach = np.max(np.abs(np.broadcast_arrays(q, motion.t[..., None, :], robot.b)), axis=(0, -1))
    _refuse_short(L, ROUNDING * reach)
    with np.errstate(all="ignore"):
        s = S / L[..., None]
        L_dot = _dot(s, S_dot)
    return LegKinematics(L=L, L_dot=L_dot, L_ddot=None, s=s, S=S), q, S_dot


def _columns(force: Array, moment: Array) -> Array:
    return np.swapaxes(np.concatenate([force, moment], axis=-1), -1, -2)


def _refuse_short(L: Array, rounding: Array) -> None:
    short = np.argwhere(rounding >= L)
    if short.size:
        *pose, leg = (int(i) for i in short[0])
        at = f" at motion[{', '.join(map(str, pose))}]" if pose else ""
        raise ValueError(f"motion: leg {leg + 1} has length zero{at}")


def _refuse_overflow(*results: Array | None) -> None:
    if not all(values is None or np.isfinite(values).all() for values in results):
        raise ValueError("motion: the kinematics of its legs overflow")


def _second_rate(motion: Motion, q: Array, legs: LegKinematics, S_dot: Array) -> Array | None:
    if motion.alpha is None or motion.a is None:
        return None
    omega = motion.omega[..., None, :]
    S_ddot = np.cross(motion.alpha[..., None, :], q) + np.cross(omega, np.cross(omega, q))
    S_ddot = S_ddot + motion.a[..., None, :]
    # L W.W of (8) from the part of S_dot across the leg: |W x S| = L |W|.
    across = S_dot - legs.L_dot[..., None] * legs.s
    return _dot(legs.s, S_ddot) + _dot(across, across) / legs.L


def _dot(x: Array, y: Array) -> Array:
    return np.asarray(np.einsum("...i,...i->...", x, y))
