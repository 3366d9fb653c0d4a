"""Kinematics of legs with offset joints: lengths, motors' angles, and the poses that have them."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import finite_array, instance, leading_shape
from ..io.array_types import Array, Flags
from ..motion.motion import Motion, pose_of
from ..motion.rotation import orthonormal, rotation_from_vector
from ..results import OK, STATUS_TEXT
from ..robot import offset_chains as chain
from ..robot.offset_chains import ROUNDING, SLIDING, JointMotion, joint_motion
from ..robot.robot import Robot

_MOST_STEPS, _MOST_HALVINGS = 60, 12
_GOAL = 4 * np.finfo(np.float64).eps


@dataclass(frozen=True, eq=False)
class MotorAnglesResult:
    """Turns of the motors; a leading shape ``(...)`` is that of the motion.

    Attributes
    ----------
    angle : ndarray
        From where the legs have their lengths of reference, rad, (..., 6): N (L - L_0) + gear spin.
    rate : ndarray
        rad/s, (..., 6).
    acceleration : ndarray or None
        rad/s^2, (..., 6); None for a motion without accelerations.
    """

    angle: Array
    rate: Array
    acceleration: Array | None


def motor_angles(
    robot: Robot, motion: Motion, reference_length: ArrayLike | None = None
) -> MotorAnglesResult:
    """Turns of the motors that move the legs, with what the turning of upper parts in their nuts adds.

    Parameters
    ----------
    robot : Robot
        The machine, with a drive; a left-handed screw has a negative lead. Where the platform joints are
        universal, the upper part turns by its spin against the nut; elsewhere it does not.
    motion : Motion
        Motion of the platform, any leading shape.
    reference_length : array_like, optional
        Lengths at which the angles are of the spins alone, m, (6,); None: 0.

    Returns
    -------
    MotorAnglesResult
        Angles, rates and accelerations.

    Raises
    ------
    ValueError
        For a robot without a drive, and where a leg has no solution.
    """
    instance(motion, Motion, "motion")
    zero = _reference_lengths(robot, reference_length)
    moving = checked_motion(robot, motion)
    joints = np.zeros_like(moving.rates)
    joints[..., SLIDING] = moving.at.L[..., 0] - zero
    if joints.shape[-1] > SLIDING + 1:
        joints[..., SLIDING + 1] = moving.at.spin[..., 0]
    seconds = moving.accelerations
    return MotorAnglesResult(
        chain.motor_motion(robot, joints),
        chain.motor_motion(robot, moving.rates),
        None if seconds is None else chain.motor_motion(robot, seconds),
    )


def pose_from_motor_angles(
    robot: Robot,
    angle: ArrayLike,
    guess: tuple[ArrayLike, ArrayLike],
    reference_length: ArrayLike | None = None,
) -> tuple[Array, Array]:
    """Pose (R, t) at which the motors have turned by given angles, (..., 3, 3) and m, (..., 3).

    Parameters
    ----------
    robot : Robot
        The machine, with a drive.
    angle : array_like
        Turns of the motors as ``motor_angles`` gives them, rad, (..., 6).
    guess : tuple
        Pose (R, t) to start from, (..., 3, 3) and m, (..., 3).
    reference_length : array_like, optional
        As for ``motor_angles``.

    Returns
    -------
    tuple
        R and t of the pose that is found from the guess.

    Raises
    ------
    ValueError
        For a robot without a drive, and where Newton's steps find no pose.
    """
    zero = _reference_lengths(robot, reference_length)
    assert robot.drive is not None
    turned = finite_array(angle, (6,), "angle")
    shape = turned.shape[:-1]
    start = pose_of(guess, "guess", "a pose (R, t)")
    shape = leading_shape({"angle": shape, "guess": start.shape})
    R, t = np.broadcast_to(start.R, (*shape, 3, 3)), np.broadcast_to(start.t, (*shape, 3))
    turned = np.broadcast_to(turned, (*shape, 6))
    wanted = (zero + turned / robot.drive.transmission_ratio).reshape(-1, 6)
    R, t, found, _, _ = search(robot, wanted, R.reshape(-1, 3, 3), t.reshape(-1, 3), screws=True)
    if not found.all():
        raise ValueError(f"angle: no pose found from the guess for {np.count_nonzero(~found)} of {len(t)}")
    return R.reshape(*shape, 3, 3), t.reshape(*shape, 3)


def _reference_lengths(robot: Robot, reference_length: ArrayLike | None) -> Array:
    instance(robot, Robot, "robot")
    if robot.drive is None:
        raise ValueError("robot: drive: expected one, whose lead turns lengths into angles, got none")
    return (
        np.zeros(6) if reference_length is None else finite_array(reference_length, (6,), "reference_length")
    )


def checked_motion(robot: Robot, motion: Motion) -> JointMotion:
    """How the joints move. Raises ValueError naming the first leg without a solution."""
    with np.errstate(all="ignore"):
        moving = joint_motion(robot, motion)
        codes = chain.codes_of(robot, motion, moving.at)
    if (codes != OK).any():
        *pose, leg = (int(i) for i in np.argwhere(codes != OK)[0])
        where = f"motion[{', '.join(map(str, pose))}]" if pose else "motion"
        raise ValueError(f"{where}: leg {leg + 1}: {STATUS_TEXT[int(codes[(*pose, leg)])]}")
    return moving


def rate_of_H(robot: Robot, motion: Motion) -> Array:
    """Time derivative of H along a motion, (..., 6, 6). Raises as ``checked_motion``."""
    G = checked_motion(robot, motion).G
    V = np.concatenate([motion.v, motion.omega], axis=-1)[..., None, :]
    size = np.abs(V).max(axis=-1, keepdims=True)
    size = np.where(size > 0.0, size, 1.0)
    W = size * np.eye(6)
    # Second rates of the joints at a constant twist V are a form c(V) = B(V, V), and that of G W is B(V, W).
    # B(V, W) + B(W, V) comes from two values of c, B(V, W) - B(W, V) is that of two turns in either order.
    both = 0.5 * (_at_twist(robot, motion, V + W) - _at_twist(robot, motion, V - W))
    turn = np.concatenate([np.zeros_like(W[..., 3:]), np.cross(W[..., 3:], V[..., 3:])], axis=-1)
    both += np.einsum("...ijk,...mk->...mij", G, turn)
    return chain.columns_of_H(robot, np.moveaxis(0.5 * both / size[..., None], -3, -1))


def _at_twist(robot: Robot, motion: Motion, twist: Array) -> Array:
    """Second rates of the joints at each of the poses' constant twists, (..., m, 6)."""
    v, omega = twist[..., :3], twist[..., 3:]
    R, none = np.broadcast_to(motion.R[..., None, :, :], (*v.shape, 3)), np.zeros_like(v)
    t = np.broadcast_to(motion.t[..., None, :], v.shape)
    with np.errstate(all="ignore"):
        found = joint_motion(robot, Motion._unchecked(R, t, omega, v, none, none)).accelerations
    assert found is not None
    return found


def leg_lengths(robot: Robot, R: Array, t: Array) -> Array:
    """Lengths of the legs, m, (..., 6), with offset joints or without; NaN where a leg has no solution."""
    if robot.offsets is None:
        S = np.einsum("...jk,ik->...ij", R, robot.p) + t[..., None, :] - robot.b
        return np.asarray(np.linalg.norm(S, axis=-1))
    with np.errstate(all="ignore"):
        return np.asarray(chain.chains(robot, _still(R, t)).L[..., 0])


def length_jacobian(robot: Robot, R: Array, t: Array) -> Array:
    """Rates of the lengths by the platform's twist, (..., 6, 6); NaN where a leg has no solution."""
    with np.errstate(all="ignore"):
        return joint_motion(robot, _still(R, t)).G[..., SLIDING, :]


def search(
    robot: Robot, wanted: Array, R: Array, t: Array, screws: bool = False
) -> tuple[Array, Array, Flags, Array, NDArray[np.int64]]:
    """Newton's steps from poses (n, ...) to lengths, (n, 6): R, t, where found, residual, m, and steps.

    screws: to lengths as the motors see them, with what the spin of the upper parts adds.
    """
    share = chain.lead_share(robot) if screws else np.zeros(6)
    R, t = orthonormal(R), t.copy()
    steps = np.zeros(len(t), dtype=np.int64)

    def at(R: Array, t: Array) -> tuple[Array, Array, Array]:
        moving = joint_motion(robot, _still(R, t))
        found = moving.at.L[..., 0] + share * moving.at.spin[..., 0]
        column = chain.actuated(robot, moving.rates.shape[-1]) * np.where(
            np.arange(moving.rates.shape[-1]) == SLIDING, 1.0, float(screws)
        )
        J = np.einsum("ij,nijk->nik", column, moving.G)
        reach = np.abs(moving.at.q).max(axis=(-2, -1)) + np.abs(t).max(axis=-1) + np.abs(robot.b).max()
        return found, J, reach

    with np.errstate(all="ignore"):
        for _ in range(_MOST_STEPS):
            now, J, reach = at(R, t)
            miss = wanted - now
            size = np.abs(miss).max(axis=-1)
            live = np.flatnonzero((size > _GOAL * reach) & np.isfinite(J).all(axis=(-2, -1)))
            live = live[np.linalg.slogdet(J[live])[0] != 0.0]
            if not live.size:
                break
            d = np.linalg.solve(J[live], miss[live][..., None])[..., 0]
            turn = np.linalg.norm(d[:, 3:], axis=-1)
            d /= np.maximum(1.0, 2.0 * turn)[:, None]
            moved = False
            for _ in range(_MOST_HALVINGS):
                R_1 = orthonormal(rotation_from_vector(d[:, 3:]) @ R[live])
                t_1 = t[live] + d[:, :3]
                nearer = np.abs(wanted[live] - at(R_1, t_1)[0]).max(axis=-1) < size[live]
                R[live[nearer]], t[live[nearer]] = R_1[nearer], t_1[nearer]
                steps[live[nearer]] += 1
                moved |= bool(nearer.any())
                live, d = live[~nearer], 0.5 * d[~nearer]
                if not live.size:
                    break
            if not moved:
                break
        now, _, reach = at(R, t)
    residual = np.asarray(np.abs(wanted - now).max(axis=-1))
    return R, t, np.asarray(residual <= ROUNDING * reach), residual, steps


def _still(R: Array, t: Array) -> Motion:
    none = np.zeros_like(t)
    return Motion._unchecked(R, t, none, none, None, None)


def without_offsets(robot: Robot) -> Robot:
    """The machine with legs whose axes meet: what a search begins with."""
    return dataclasses.replace(robot, offsets=None)
