"""Turns about the three axes in any order: motions of their angles and rates, and these of motions.

Angles are ``theta = (theta_x, theta_y, theta_z)``, each about the axis of its name, whatever the order.
With the axes renamed so that the order reads "zyx" every order is (38). Where the new axes are left-handed,
angles and angular velocities change their signs.
"""

from itertools import permutations

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array
from .rotation import (
    angular_acceleration_from_rpy,
    angular_velocity_from_rpy,
    rpy_from_rotation,
    rpy_motion,
)


def motion_about_axes(
    theta: Array, theta_dot: Array, theta_ddot: Array, order: str
) -> tuple[Array, Array, Array]:
    """Return R (..., 3, 3), omega and alpha, base frame, (..., 3), of angles, rates and second rates.

    theta, theta_dot, theta_ddot: rad, rad/s and rad/s^2, (..., 3).  R is that of ``rotation_about_axes``.
    """
    axes, sign = _renamed(order)
    theta, theta_dot, theta_ddot = (sign * each[..., axes] for each in (theta, theta_dot, theta_ddot))
    R, omega, alpha = rpy_motion(theta, theta_dot, theta_ddot)
    assert alpha is not None
    back = np.argsort(axes)
    return R[..., back[:, None], back], sign * omega[..., back], sign * alpha[..., back]


def angles_from_rotation(R: Array, order: str) -> Array:
    """Return angles, rad, (..., 3), of rotations (..., 3, 3): the inverse of ``rotation_about_axes``.

    That about the middle axis of the order is at most pi/2; there the other two are open but for their sum or
    difference.
    """
    axes, sign = _renamed(order)
    return sign * rpy_from_rotation(R[..., axes[:, None], axes])[..., np.argsort(axes)]


def distance_from_lock(theta: Array, order: str) -> Array:
    """Return by how much angles (..., 3) are away from those of which two turn about one axis: 0 there, to 1.

    It is the cosine of the angle about the order's middle axis; rates of the angles grow as its inverse.
    """
    return np.abs(np.cos(theta[..., "xyz".index(order[1])]))


FAR_FROM_LOCK = 0.5
"""A ``distance_from_lock`` at which rates of angles are at most twice those of the rotation."""


def far_from_lock(R: Array) -> tuple[Array, str]:
    """Return angles, rad, (n, 3), of rotations (n, 3, 3), and their order: "zyx" if that is far from lock.

    Else it is that of the six whose least ``distance_from_lock`` is largest.
    """
    theta = angles_from_rotation(R, "zyx")
    if distance_from_lock(theta, "zyx").min(initial=1.0) >= FAR_FROM_LOCK:
        return theta, "zyx"
    found = [(angles_from_rotation(R, order), order) for order in map("".join, permutations("zyx"))]
    return max(found, key=lambda each: float(distance_from_lock(*each).min()))


def angle_rates(theta: Array, omega: Array, alpha: Array, order: str) -> tuple[Array, Array]:
    """Return theta_dot, rad/s, and theta_ddot, rad/s^2, (..., 3): the inverse of ``motion_about_axes``.

    theta: rad, with a ``distance_from_lock`` > 0; omega, alpha: rad/s and rad/s^2, base frame, (..., 3).
    """
    axes, sign = _renamed(order)
    theta, omega, alpha = (sign * each[..., axes] for each in (theta, omega, alpha))
    turns = [angular_velocity_from_rpy(theta, np.broadcast_to(unit, theta.shape)) for unit in np.eye(3)]
    E = np.stack(turns, axis=-1)
    theta_dot = _solved(E, omega)
    carried = angular_acceleration_from_rpy(theta, theta_dot, np.zeros_like(theta))
    theta_ddot = _solved(E, alpha - carried)
    back = np.argsort(axes)
    return sign * theta_dot[..., back], sign * theta_ddot[..., back]


def _solved(E: Array, vector: Array) -> Array:
    return np.asarray(np.linalg.solve(E, vector[..., None])[..., 0], dtype=np.float64)


def _renamed(order: str) -> tuple[NDArray[np.int64], float]:
    """Axes that become x, y and z where ``order`` reads "zyx"; -1 where these are left-handed, else 1."""
    axes = np.array(["xyz".index(axis) for axis in reversed(order)])
    return axes, float(np.linalg.det(np.eye(3)[axes]).round())
