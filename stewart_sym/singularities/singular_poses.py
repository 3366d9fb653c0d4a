"""Singularity measures of poses, and the unconstrained twist as a screw."""

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

# Rotation of a twist, relative to its translation, below which it is rounding error and the twist translates.
_TRANSLATION = 1e-9


@dataclass(frozen=True, eq=False)
class SingularityResult:
    """Singularity measures of poses with the unconstrained twist and wrench.

    The moment rows of H are divided by ``characteristic_length``; then H = sum s_i u_i v_i^T with s_1 >= ...
    >= s_6. Twists and wrenches refer to the reference point and the base frame. Their sign makes the largest
    entry of u_6 positive. The leading shape ``(...)`` is the shape of the poses.

    Attributes
    ----------
    characteristic_length : float
        Characteristic length of the robot (m).
    condition_number : ndarray, shape (...)
        Scaled condition number s_1 / s_6 (dimensionless); infinite if H is singular to rounding.
    smallest_singular_value : ndarray, shape (...)
        Smallest singular value s_6 (dimensionless).
    determinant : ndarray, shape (...)
        Determinant of the scaled H (dimensionless). It has the sign of det H, which changes at a singular
        pose.
    lost_dof : ndarray of int, shape (...)
        Number of degrees of freedom lost to rounding. If it exceeds 1, ``twist`` is one of several lost
        twists.
    twist : ndarray, shape (..., 6)
        Twist [v; omega] (m/s, rad/s) with norm(v)^2 + norm(length omega)^2 = 1 that changes the leg lengths
        least, with rates H^T twist of norm s_6. At a singular pose no leg length changes.
    wrench : ndarray, shape (..., 6)
        Wrench [force; moment] (N, N m) with norm(force)^2 + norm(moment / length)^2 = 1 that requires the
        largest leg forces, of norm 1 / s_6 (N). At a singular pose no leg forces balance it.
    leg_forces : ndarray, shape (..., 6)
        Leg forces v_6 (N) of norm 1 with the smallest wrench. At a singular pose the wrench is zero.
    screw_pitch : ndarray, shape (...)
        Pitch of the twist as a screw (m/rad); 0 for a pure rotation, infinite for a pure translation.
    screw_axis : ndarray, shape (..., 3)
        Direction of the screw axis: parallel to omega, or to v for a pure translation.
    screw_point : ndarray, shape (..., 3)
        Point of the screw axis closest to the reference point (m); the reference point itself for a pure
        translation.
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
    """Compute singularity measures of poses: singular values, unconstrained twist, and unbalanced wrench.

    Parameters
    ----------
    robot : Robot
        Robot geometry.
    pose : Motion or tuple of array_like
        Motion, whose rates and loads are ignored, or pose (R, t) with shapes (..., 3, 3) and (..., 3); t in
        m.

    Returns
    -------
    SingularityResult
        Condition number, twist, and wrench of each pose.

    Raises
    ------
    ValueError
        If an argument is invalid, or if a leg has length zero or no solution.

    See Also
    --------
    path_singularities : Find singular poses along a path.
    condition_number : Condition number of H.

    Notes
    -----
    Twist and wrench are the left singular vector of the scaled H of its smallest singular value.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> result = ss.singularity(robot, (np.eye(3), [0.2, 0.1, 1.0]))
    >>> round(float(result.condition_number), 1)
    30.0
    >>> result.twist.round(2).tolist()
    [0.78, 0.06, 0.1, -0.54, 0.03, 2.07]
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
    """Return u_6, all singular values, and v_6, shape (..., 6) each, of scaled matrices (..., 6, 6).

    The entry of u_6 of largest magnitude is positive; H v_6 = s_6 u_6.
    """
    U, s, V_T = np.linalg.svd(H)
    u, v = U[..., -1], V_T[..., -1, :]
    largest = np.take_along_axis(u, np.argmax(np.abs(u), axis=-1)[..., None], axis=-1)
    side = np.where(largest < 0.0, -1.0, 1.0)
    return side * u, s, side * v


def screw(twist: Array, length: float) -> tuple[Array, Array, Array]:
    """Return the pitch (m/rad), the axis, and the arm from the reference point (m) of a twist (..., 6).

    ``twist`` is [v; omega] (m/s, rad/s), and ``length`` (m) scales rotations, as in ``SingularityResult``.
    The shapes of the results are (...), (..., 3), and (..., 3).
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
