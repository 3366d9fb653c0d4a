"""Singular poses as objects: how near a pose is to one, the motion that is lost there, and as a screw."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import instance
from ..io.array_types import Array
from ..kinematics.conditioning import characteristic_length, condition_number, moments_over
from ..kinematics.inverse_kinematics import ROUNDING, wrench_matrix
from ..motion.motion import Motion, pose_of
from ..robot.robot import Robot

Pose = Motion | tuple[ArrayLike, ArrayLike]

# A twist that turns by less than this share of what it moves does not turn: rounding leaves no more digits.
_TRANSLATION = 1e-9


@dataclass(frozen=True, eq=False)
class SingularityResult:
    """How near poses are to a singular one, and what is lost; a leading shape ``(...)`` is that of the poses.

    With the moment rows of H divided by ``characteristic_length``, H = sum s_i u_i v_i^T, s_1 >= ... >= s_6.
    Base frame, wrenches and twists about the platform's reference point. Twist and wrench have the sign that
    makes the entry of u_6 of largest magnitude positive.

    Attributes
    ----------
    characteristic_length : float
        Characteristic length, m, a float.
    condition_number : ndarray
        Scaled condition number s_1 / s_6, (...); inf where H is singular to rounding.
    smallest_singular_value : ndarray
        s_6, no unit, (...).
    determinant : ndarray
        Of the scaled H, no unit, (...); its sign is that of det H, one on each side
        of a singular pose.
    lost_dof : ndarray of int
        Number of degrees of freedom lost to rounding, int, (...); with several, the twist is one of them.
    twist : ndarray
        [v; omega], m/s and rad/s, (..., 6), with norm(v)^2 + norm(length omega)^2 = 1: of all such twists
        the one that moves the legs least, by rates H^T twist of magnitude s_6; at a singular pose no leg
        length changes.
    wrench : ndarray
        [force; moment], N and N m, (..., 6), with norm(force)^2 + norm(moment / length)^2 = 1: the one that
        costs the largest leg forces, 1 / s_6 N; at a singular pose no leg forces hold it.
    leg_forces : ndarray
        v_6, leg forces, N, (..., 6), of magnitude 1 whose wrench is least; at a singular pose it is none.
    screw_pitch : ndarray
        Of the twist as a screw, m/rad, (...); 0 for a turn, inf where it does not turn.
    screw_axis : ndarray
        Direction of the screw, (..., 3), along omega, along v where it does not turn.
    screw_point : ndarray
        Of its axis the one nearest to the reference point, m, (..., 3); that point itself where the twist
        does not turn.
    """

    characteristic_length: float
    condition_number: Array
    smallest_singular_value: Array
    determinant: Array
    lost_dof: NDArray[np.int64]
    twist: Array
    wrench: Array
    leg_forces: Array
    screw_pitch: Array
    screw_axis: Array
    screw_point: Array


def singularity(robot: Robot, pose: Pose) -> SingularityResult:
    """Return how near poses are to a singular one and the motion that is lost there.

    Parameters
    ----------
    robot : Robot
        The machine.
    pose : Pose
        A Motion, whose rates, accelerations and loads don't count, or (R, t), (..., 3, 3) and m, (..., 3).

    Returns
    -------
    SingularityResult
        Condition, twist and wrench of each pose.

    Raises
    ------
    ValueError
        Naming the argument, as ``inverse_kinematics`` for a leg of length zero.
    """
    instance(robot, Robot, "robot")
    motion = pose if isinstance(pose, Motion) else pose_of(pose, "pose", "a Motion or a pose (R, t)")
    length = characteristic_length(robot) or 1.0
    H = moments_over(wrench_matrix(robot, motion), length)
    unit = np.repeat([1.0, length], 3)
    u, s, v = last_directions(H)
    twist = u / unit
    pitch, axis, arm = screw(twist, length)
    return SingularityResult(
        characteristic_length=length,
        condition_number=condition_number(H),
        smallest_singular_value=s[..., -1],
        determinant=np.asarray(np.linalg.det(H)),
        lost_dof=np.count_nonzero(s <= ROUNDING * s[..., :1], axis=-1),
        twist=twist,
        wrench=u * unit,
        leg_forces=v,
        screw_pitch=pitch,
        screw_axis=axis,
        screw_point=motion.t + arm,
    )


def last_directions(H: Array) -> tuple[Array, Array, Array]:
    """Return u_6, (..., 6), all singular values, (..., 6), and v_6, (..., 6), of scaled matrices (..., 6, 6).

    The entry of u_6 of largest magnitude is positive; H v_6 = s_6 u_6.
    """
    U, s, V_T = np.linalg.svd(H)
    u, v = U[..., -1], V_T[..., -1, :]
    largest = np.take_along_axis(u, np.argmax(np.abs(u), axis=-1)[..., None], axis=-1)
    side = np.where(largest < 0.0, -1.0, 1.0)
    return side * u, s, side * v


def screw(twist: Array, length: float) -> tuple[Array, Array, Array]:
    """Return pitch, m/rad, (...), axis, (..., 3), and the arm to it from the reference point, m, (..., 3).

    twist: [v; omega], m/s and rad/s, (..., 6). length: what a turn is measured by, m. As in
    ``SingularityResult``.
    """
    v, omega = twist[..., :3], twist[..., 3:]
    turns = length * _size(omega) > _TRANSLATION * _size(v)
    square = np.where(turns, _size(omega) ** 2, 1.0)
    pitch = np.where(turns, np.sum(v * omega, axis=-1, keepdims=True) / square, np.inf)
    along = np.where(turns, omega, v)
    arm = np.where(turns, np.cross(omega, v) / square, 0.0)
    return pitch[..., 0], along / _size(along), arm


def _size(vector: Array) -> Array:
    return np.asarray(np.linalg.norm(vector, axis=-1, keepdims=True))
