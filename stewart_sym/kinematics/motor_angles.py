"""Motor angles of a motion, and the pose at given motor angles, including the rotation of screws."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import finite_array, instance, leading_shape
from ..io.array_types import Array
from ..motion.motion import Motion, pose_of
from ..robot.offset_chains import SLIDING, motor_motion
from ..robot.robot import Robot
from .offset_legs import checked_motion
from .pose_search import newton


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
        motor_motion(robot, joints),
        motor_motion(robot, moving.rates),
        None if seconds is None else motor_motion(robot, seconds),
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
    found = newton(robot, wanted, R.reshape(-1, 3, 3), t.reshape(-1, 3), screws=True)
    lost = np.count_nonzero(~found.converged)
    if lost:
        raise ValueError(f"angle: no pose found from the guess for {lost} of {len(wanted)}")
    return found.R.reshape(*shape, 3, 3), found.t.reshape(*shape, 3)


def _reference_lengths(robot: Robot, reference_length: ArrayLike | None) -> Array:
    instance(robot, Robot, "robot")
    if robot.drive is None:
        raise ValueError("robot: drive: expected a drive with a lead, got none")
    return (
        np.zeros(6) if reference_length is None else finite_array(reference_length, (6,), "reference_length")
    )
