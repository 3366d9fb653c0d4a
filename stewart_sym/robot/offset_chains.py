"""Joint chains of legs with offsets: rates and accelerations of the joints, in plain vectors.

The joints from the base point are a rotation about the fixed axis k, a rotation about the moving axis y, and
a translation along s. Universal platform joints add rotations about s, about the axis on the upper part, and
about the axis on the platform. ``(...)`` is a leading shape of poses; vectors of the legs have the shape
(..., 6, 3), scalars (..., 6, 1).
"""

import math
from dataclasses import dataclass

import numpy as np

from ..io.array_types import Array, Codes
from ..motion.motion import Motion
from ..motion.rotation import cross as vector_product
from ..motion.rotation import cross_matrix
from ..results import JOINT_SINGULAR, NOT_FINITE, OK, UNREACHABLE, ZERO_LENGTH
from .offset_positions import Chains, chains_to, dot
from .offsets import JointOffsets
from .robot import Robot

ROUNDING = 16 * np.finfo(np.float64).eps
"""Fraction of the summed terms below which a length is rounding error and counts as zero."""
SLIDING, SPIN = 2, 3
"""Joints of a chain, counted from 0: along s, and about it."""


@dataclass(frozen=True, eq=False)
class JointMotion:
    """Motion of the joints.

    rates, accelerations: of the joints, (..., 6, n), n = 3 or 6; None without accelerations of the platform.
    J: derivative of the end velocity with respect to the joint rates, (..., 6, n, n). G: derivative of the
    rates with respect to the twist [v; omega], (..., 6, n, 6).
    """

    at: Chains
    rates: Array
    accelerations: Array | None
    J: Array
    G: Array


def joint_motion(robot: Robot, motion: Motion) -> JointMotion:
    """Compute rates and accelerations of the joints; NaN if the offsets allow no solution."""
    offsets, at = offsets_of(robot), chains(robot, motion)
    omega = motion.omega[..., None, :]
    J = jacobian(robot, at)
    bad = ~np.isfinite(J).all(axis=(-2, -1)) | (np.linalg.slogdet(np.nan_to_num(J))[0] == 0.0)
    inverse = np.linalg.inv(np.where(bad[..., None, None], np.eye(J.shape[-1]), J))
    inverse[bad] = np.nan
    X = np.zeros((*at.P.shape[:-1], J.shape[-1], 6))
    X[..., :3, :3], X[..., :3, 3:] = np.eye(3), -cross_matrix(at.q)
    if offsets.has_spinning_parts:
        X[..., 3:, 3:] = np.eye(3)
    rates = applied(inverse, _with_turn(offsets, motion.v[..., None, :] + vector_product(omega, at.q), omega))
    if motion.a is None or motion.alpha is None:
        return JointMotion(at, rates, None, J, inverse @ X)
    alpha = motion.alpha[..., None, :]
    quick = motion.a[..., None, :] + swung(omega, alpha, at.q)
    drift = motion_of_end(robot, at, rates, np.zeros_like(rates))
    return JointMotion(at, rates, applied(inverse, _with_turn(offsets, quick, alpha) - drift), J, inverse @ X)


def _with_turn(offsets: JointOffsets, vector: Array, turn: Array) -> Array:
    """Return the motion of the leg end: the platform point, and the platform's rotation for U-C-U legs."""
    if not offsets.has_spinning_parts:
        return vector
    return np.concatenate([vector, np.broadcast_to(turn, vector.shape)], axis=-1)


def lead_share(robot: Robot) -> Array:
    """Return the decrease of L (m) if the upper part rotates by 1 rad while the motor is at rest, (6,).

    Zero if no part rotates or if there is no drive, because the actuator then acts only on the lengths.
    """
    if robot.drive is None or not offsets_of(robot).has_spinning_parts:
        return np.zeros(6)
    return np.asarray(robot.drive.lead / (2.0 * math.pi))


def motor_motion(robot: Robot, joints: Array) -> Array:
    """Convert joint values (..., 6, n) to motor angles (rad) or their rates, (..., 6): N L + gear_ratio spin.

    The robot must have a drive.
    """
    assert robot.drive is not None
    turned = robot.drive.transmission_ratio * joints[..., SLIDING]
    return np.asarray(
        turned + robot.drive.gear_ratio * joints[..., SPIN] if joints.shape[-1] > SPIN else turned
    )


def actuated(robot: Robot, joints: int) -> Array:
    """Return the power of a unit actuator force per joint rate, (6, n): along s, and about s."""
    column = np.zeros((6, joints))
    column[:, SLIDING] = 1.0
    if joints > SPIN:
        column[:, SPIN] = lead_share(robot)
    return column


def columns_of_H(robot: Robot, G: Array) -> Array:
    """Return H, (..., 6, 6), whose transpose maps the twist of the platform to the actuator rates."""
    column = np.broadcast_to(actuated(robot, G.shape[-2]), G.shape[:-1])
    return np.swapaxes(np.einsum("...ij,...ijk->...ik", column, G), -1, -2)


def codes(robot: Robot, motion: Motion) -> Codes:
    """Return the status of each leg at each pose, (..., 6), regardless of H."""
    with np.errstate(all="ignore"):
        return codes_of(robot, motion, chains(robot, motion))


def chains(robot: Robot, motion: Motion) -> Chains:
    """Return the positions of the joints at every pose; NaN if the offsets allow no solution."""
    offsets = offsets_of(robot)
    q = applied(motion.R[..., None, :, :], robot.p)
    k_w = applied(motion.R[..., None, :, :], offsets.platform_axis)
    return chains_to(offsets, robot.k, k_w, q, motion.t[..., None, :] + q - robot.b)


def codes_of(robot: Robot, motion: Motion, at: Chains) -> Codes:
    """Return ``codes`` for known chains."""
    reach = np.max(
        np.abs(np.broadcast_arrays(at.q, motion.t[..., None, :], robot.b)), axis=(0, -1), keepdims=False
    )[..., None]
    known = np.isfinite(at.P).all(axis=-1, keepdims=True)
    code = np.where(ROUNDING * reach >= at.L, ZERO_LENGTH, OK)
    # Near the smallest distance from the fixed axis, only the square of of_tip is accurate to rounding.
    beside = offsets_of(robot).slide_offset_y[:, None] ** 2
    share = at.of_tip / at.L * (at.of_tip**2 / (at.of_tip**2 + beside))
    code = np.where((code == OK) & ~(share > ROUNDING), JOINT_SINGULAR, code)
    lost = ~(np.isfinite(at.L) & np.isfinite(at.U).all(axis=-1).all(axis=-1, keepdims=True))
    meets = np.sqrt(dot(vector_product(robot.k, at.P), vector_product(robot.k, at.P))) <= ROUNDING * reach
    # On the fixed axis the leg has no direction, as in legs without offsets.
    along_axis = meets & (offsets_of(robot).slide_offset_y[:, None] == 0.0)
    code = np.where(lost, np.where(along_axis, JOINT_SINGULAR, UNREACHABLE), code)
    return np.where(known, code, NOT_FINITE)[..., 0].astype(np.int32)


def jacobian(robot: Robot, at: Chains) -> Array:
    """Return the derivative of the velocity of the leg end with respect to the joint rates."""
    k = np.broadcast_to(robot.k, at.s.shape)
    v = [vector_product(k, at.P), vector_product(at.y, at.P - at.A), at.s]
    if at.y_w is None or at.k_w is None:
        return np.stack(v, axis=-1)
    none = np.zeros_like(at.s)
    v += [vector_product(at.s, at.P - at.T), vector_product(at.y_w, at.P - at.T), none]
    turns = [k, at.y, none, at.s, at.y_w, at.k_w]
    return np.concatenate([np.stack(v, axis=-1), np.stack(turns, axis=-1)], axis=-2)


def motion_of_end(robot: Robot, at: Chains, rates: Array, seconds: Array) -> Array:
    """Return the acceleration of the leg end from rates and second rates of the joints."""
    lower, upper = lower_motion(robot, at, rates, seconds), upper_motion(robot, at, rates, seconds)
    if at.y_w is None or at.k_w is None:
        return upper.a + 0.0 * lower.a
    turn = rates[..., 4, None] * at.y_w
    omega = upper.omega + turn
    alpha = upper.alpha + seconds[..., 4, None] * at.y_w + vector_product(upper.omega, turn)
    a = upper.a + swung(omega, alpha, at.P - at.T)
    last = rates[..., 5, None] * at.k_w
    return np.concatenate([a, alpha + seconds[..., 5, None] * at.k_w + vector_product(omega, last)], axis=-1)


@dataclass(frozen=True, eq=False)
class Moving:
    """Motion of a part: its angular velocity and acceleration, and the motion v, a of one of its points."""

    omega: Array
    alpha: Array
    v: Array
    a: Array


def cross_motion(robot: Robot, at: Chains, rates: Array, seconds: Array) -> Moving:
    """Return the motion of the cross, and of the intersection of o and the moving axis."""
    omega, alpha = rates[..., 0, None] * robot.k, seconds[..., 0, None] * robot.k
    return Moving(omega, alpha, vector_product(omega, at.A), swung(omega, alpha, at.A))


def lower_motion(robot: Robot, at: Chains, rates: Array, seconds: Array) -> Moving:
    """Return the motion of the lower part, and of the intersection of o and the moving axis."""
    cross = cross_motion(robot, at, rates, seconds)
    turn = rates[..., 1, None] * at.y
    alpha = cross.alpha + seconds[..., 1, None] * at.y + vector_product(cross.omega, turn)
    return Moving(cross.omega + turn, alpha, cross.v, cross.a)


def upper_motion(robot: Robot, at: Chains, rates: Array, seconds: Array) -> Moving:
    """Return the motion of the upper part, and of the end of the leg."""
    lower = lower_motion(robot, at, rates, seconds)
    r, slide = at.T - at.A, rates[..., 2, None] * at.s
    v = lower.v + vector_product(lower.omega, r) + slide
    a = lower.a + swung(lower.omega, lower.alpha, r) + 2 * vector_product(lower.omega, slide)
    a = a + seconds[..., 2, None] * at.s
    if at.y_w is None:
        return Moving(lower.omega, lower.alpha, v, a)
    turn = rates[..., SPIN, None] * at.s
    alpha = lower.alpha + seconds[..., SPIN, None] * at.s + vector_product(lower.omega, turn)
    return Moving(lower.omega + turn, alpha, v, a)


def offsets_of(robot: Robot) -> JointOffsets:
    """Return the offsets of the robot, or zeros if it has none."""
    return JointOffsets() if robot.offsets is None else robot.offsets


def swung(omega: Array, alpha: Array, r: Array) -> Array:
    """Return the acceleration of a point of a body relative to another of its points."""
    return vector_product(alpha, r) + vector_product(omega, vector_product(omega, r))


def applied(A: Array, v: Array) -> Array:
    """Multiply matrices (..., 3, 3) by vectors (..., 3)."""
    return np.asarray((A @ v[..., None])[..., 0])


def transposed(A: Array) -> Array:
    """Transpose matrices (..., 3, 3)."""
    return np.swapaxes(A, -1, -2)
