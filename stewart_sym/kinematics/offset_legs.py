"""Kinematics of legs with offset joints: lengths, motor angles, and the corresponding poses."""

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
    """Motor angles and their derivatives.

    The leading shape ``(...)`` is the shape of the motion.

    Attributes
    ----------
    angle : ndarray, shape (..., 6)
        Motor angles (rad) from the reference lengths: N (L - L_0) + gear spin.
    rate : ndarray, shape (..., 6)
        Motor speeds (rad/s).
    acceleration : ndarray, shape (..., 6), or None
        Motor accelerations (rad/s^2). None if the motion has no accelerations.
    """

    angle: Array
    rate: Array
    acceleration: Array | None


def motor_angles(
    robot: Robot, motion: Motion, reference_length: ArrayLike | None = None
) -> MotorAnglesResult:
    """Compute the motor angles of a motion, including the rotation of the upper leg parts in their nuts.

    Parameters
    ----------
    robot : Robot
        Robot with a drive. A left-handed screw has a negative lead.
    motion : Motion
        Motion of the platform with any leading shape.
    reference_length : array_like, shape (6,), optional
        Leg lengths (m) at which the angles consist only of the spin terms; by default 0.

    Returns
    -------
    MotorAnglesResult
        Motor angles (rad), speeds (rad/s), and accelerations (rad/s^2).

    Raises
    ------
    ValueError
        If the robot has no drive, an argument is invalid, or a leg has no solution.

    See Also
    --------
    pose_from_motor_angles : Compute the pose from motor angles.
    inverse_kinematics : Compute leg lengths.

    Notes
    -----
    If the platform joints are universal joints, the upper leg part turns against the nut by its spin. With
    other platform joints it does not turn.

    Examples
    --------
    >>> import dataclasses
    >>> import stewart_sym as ss
    >>> robot = dataclasses.replace(ss.robots.load("unal"), drive=ss.Drive(lead=0.005))
    >>> rest = [0.0, 0.0, 0.0]
    >>> motion = ss.Motion.from_rpy(t=[0.0, 0.0, 0.71], theta=rest, v=rest, theta_dot=rest)
    >>> home = ss.Motion.from_rpy(t=[0.0, 0.0, 0.7], theta=rest, v=rest, theta_dot=rest)
    >>> L_0 = ss.inverse_kinematics(robot, home).L
    >>> ss.motor_angles(robot, motion, reference_length=L_0).angle.round(2).tolist()
    [12.43, 12.43, 12.43, 12.43, 12.43, 12.43]
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
    """Compute the pose at which the motors have the given angles.

    Parameters
    ----------
    robot : Robot
        Robot with a drive.
    angle : array_like, shape (..., 6)
        Motor angles (rad), as in ``MotorAnglesResult.angle``.
    guess : tuple of array_like
        Start pose (R, t) with shapes (..., 3, 3) and (..., 3); t in m.
    reference_length : array_like, shape (6,), optional
        Leg lengths (m) at which the angles consist only of the spin terms; by default 0.

    Returns
    -------
    R : ndarray, shape (..., 3, 3)
        Rotation matrix from the platform frame to the base frame.
    t : ndarray, shape (..., 3)
        Position of the reference point in the base frame (m).

    Raises
    ------
    ValueError
        If the robot has no drive, an argument is invalid, or no pose is found from the guess.

    See Also
    --------
    motor_angles : Compute motor angles from a motion.
    forward_kinematics : Compute poses from leg lengths.

    Examples
    --------
    >>> import dataclasses
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = dataclasses.replace(ss.robots.load("unal"), drive=ss.Drive(lead=0.005))
    >>> rest = [0.0, 0.0, 0.0]
    >>> motion = ss.Motion.from_rpy(t=[0.0, 0.0, 0.71], theta=rest, v=rest, theta_dot=rest)
    >>> angle = ss.motor_angles(robot, motion).angle
    >>> R, t = ss.pose_from_motor_angles(robot, angle, guess=(np.eye(3), [0.0, 0.0, 0.7]))
    >>> np.allclose(t, motion.t)
    True
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
        raise ValueError("robot: drive: expected a drive with a lead, got none")
    return (
        np.zeros(6) if reference_length is None else finite_array(reference_length, (6,), "reference_length")
    )


def checked_motion(robot: Robot, motion: Motion) -> JointMotion:
    """Compute the joint motion; raise ValueError for the first leg without a solution."""
    with np.errstate(all="ignore"):
        moving = joint_motion(robot, motion)
        codes = chain.codes_of(robot, motion, moving.at)
    if (codes != OK).any():
        *pose, leg = (int(i) for i in np.argwhere(codes != OK)[0])
        where = f"motion[{', '.join(map(str, pose))}]" if pose else "motion"
        raise ValueError(f"{where}: leg {leg + 1}: {STATUS_TEXT[int(codes[(*pose, leg)])]}")
    return moving


def rate_of_H(robot: Robot, motion: Motion) -> Array:
    """Compute the time derivative of H along a motion, shape (..., 6, 6). Raises as ``checked_motion``."""
    G = checked_motion(robot, motion).G
    V = np.concatenate([motion.v, motion.omega], axis=-1)[..., None, :]
    size = np.abs(V).max(axis=-1, keepdims=True)
    size = np.where(size > 0.0, size, 1.0)
    W = size * np.eye(6)
    # The joint accelerations at a constant twist V are a quadratic form c(V) = B(V, V), and the rate of G W
    # is B(V, W). B(V, W) + B(W, V) follows from two values of c. B(V, W) - B(W, V) follows from the
    # commutator of the two rotations.
    both = 0.5 * (_at_twist(robot, motion, V + W) - _at_twist(robot, motion, V - W))
    turn = np.concatenate([np.zeros_like(W[..., 3:]), np.cross(W[..., 3:], V[..., 3:])], axis=-1)
    both += np.einsum("...ijk,...mk->...mij", G, turn)
    return chain.columns_of_H(robot, np.moveaxis(0.5 * both / size[..., None], -3, -1))


def _at_twist(robot: Robot, motion: Motion, twist: Array) -> Array:
    """Return the joint accelerations for each constant twist of the poses, twists of shape (..., m, 6)."""
    v, omega = twist[..., :3], twist[..., 3:]
    R, none = np.broadcast_to(motion.R[..., None, :, :], (*v.shape, 3)), np.zeros_like(v)
    t = np.broadcast_to(motion.t[..., None, :], v.shape)
    with np.errstate(all="ignore"):
        found = joint_motion(robot, Motion._unchecked(R, t, omega, v, none, none)).accelerations
    assert found is not None
    return found


def leg_lengths(robot: Robot, R: Array, t: Array) -> Array:
    """Return the leg lengths (m), shape (..., 6), of legs with or without offsets; NaN without a solution."""
    if robot.offsets is None:
        S = np.einsum("...jk,ik->...ij", R, robot.p) + t[..., None, :] - robot.b
        return np.asarray(np.linalg.norm(S, axis=-1))
    with np.errstate(all="ignore"):
        return np.asarray(chain.chains(robot, _still(R, t)).L[..., 0])


def leg_axes(robot: Robot, R: Array, t: Array) -> tuple[Array, Array, Array]:
    """Return q and vectors along the prismatic joints (m), (..., 6, 3), and lengths (m), (..., 6).

    NaN if a leg has no solution.
    """
    with np.errstate(all="ignore"):
        at = chain.chains(robot, _still(R, t))
    return at.q, at.s * at.L, at.L[..., 0]


def inverse_jacobians(robot: Robot, R: Array, t: Array) -> Array:
    """Return H^T of legs with offsets, shape (..., 6, 6); NaN if a leg has no solution."""
    with np.errstate(all="ignore"):
        return np.swapaxes(chain.columns_of_H(robot, joint_motion(robot, _still(R, t)).G), -1, -2)


def length_jacobian(robot: Robot, R: Array, t: Array) -> Array:
    """Return the derivative of the lengths by the twist, shape (..., 6, 6); NaN if a leg has no solution."""
    with np.errstate(all="ignore"):
        return joint_motion(robot, _still(R, t)).G[..., SLIDING, :]


def search(
    robot: Robot, wanted: Array, R: Array, t: Array, screws: bool = False
) -> tuple[Array, Array, Flags, Array, NDArray[np.int64]]:
    """Apply Newton steps from poses (n, ...) to lengths (n, 6) (m).

    Returns R, t, a flag of convergence, the residual (m), and the number of steps. With ``screws``, the
    lengths are motor angles divided by N, which include the spin of the upper leg parts.
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
    """Return the robot with legs without offsets, from which a search starts."""
    return dataclasses.replace(robot, offsets=None)
