"""Rotations by angles, quaternions, and rotation vectors: matrices, angular velocities and accelerations.

Angles are ``theta = (theta_x, theta_y, theta_z)``; a rotation vector is the axis times the angle; vectors are
in the base frame.
"""

import itertools
import math

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import shaped_array
from ..io.array_types import Array

FAR_FROM_LOCK = 0.5
"""Value of ``distance_from_lock`` at which rates of angles are at most twice those of the rotation."""
_BLOCK = 2048
"""Number of poses whose numbers fit into the second cache of a processor."""
_ONE = np.eye(3)
_FEW = 300
"""Size below which the vector product of whole arrays takes less time than the product of components."""
_NEXT = np.array([1, 2, 0])


def rotation_from_rpy(theta: ArrayLike) -> Array:
    """Return R = Rz(theta_z) Ry(theta_y) Rx(theta_x), (38), shape (..., 3, 3), of angles (rad), (..., 3)."""
    return rotation_about_axes(theta, "zyx")


def rotation_about_axes(theta: ArrayLike, order: str) -> Array:
    """Return the product of rotations, (..., 3, 3), by angles (rad), (..., 3); "zyx" for Rz Ry Rx."""
    theta = shaped_array(theta, (3,), "theta")
    axes = np.repeat(_ONE[..., None], theta.size // 3, axis=-1)
    for i in map("xyz".index, order):
        _turn(axes, i, theta[..., i].ravel())
    return np.ascontiguousarray(axes.T).reshape(*theta.shape, 3)


def motion_about_axes(
    theta: Array, theta_dot: Array, theta_ddot: Array, order: str = "zyx"
) -> tuple[Array, Array, Array]:
    """Return R, (..., 3, 3), omega, and alpha, (..., 3), of angles and their derivatives of one shape.

    Each rotation is about an axis that the rotations to the left of it in the product carry along.
    """
    R, omega, alpha = np.empty((*theta.shape, 3)), np.empty(theta.shape), np.empty(theta.shape)
    given = [array.reshape(-1, 3) for array in (theta, theta_dot, theta_ddot)]
    for start in range(0, len(given[0]), _BLOCK):
        part = slice(start, start + _BLOCK)
        angle, rate, second = (array[part].T for array in given)
        axes = np.repeat(_ONE[..., None], angle.shape[1], axis=-1)
        turning, change = np.zeros(angle.shape), np.zeros(angle.shape)
        for i in map("xyz".index, order):
            own = axes[i] * rate[i]
            change += axes[i] * second[i] + cross(turning.T, own.T).T
            turning += own
            _turn(axes, i, angle[i])
        R.reshape(-1, 3, 3)[part], omega.reshape(-1, 3)[part] = axes.T, turning.T
        alpha.reshape(-1, 3)[part] = change.T
    return R, omega, alpha


def _turn(axes: Array, i: int, angle: Array) -> None:
    """Rotate the other axes, (3, 3, n): axis, component, pose, about axis i by angles (rad), (n,)."""
    j, k = (i + 1) % 3, (i + 2) % 3
    c, s = np.cos(angle), np.sin(angle)
    axes[j], axes[k] = c * axes[j] + s * axes[k], c * axes[k] - s * axes[j]


def rpy_from_rotation(R: ArrayLike) -> Array:
    """Return angles (rad), (..., 3), with R = Rz(theta_z) Ry(theta_y) Rx(theta_x) and |theta_y| <= pi/2."""
    return angles_from_rotation(R, "zyx")


def angles_from_rotation(R: ArrayLike, order: str) -> Array:
    """Return angles (rad), (..., 3), of rotations, (..., 3, 3): the inverse of ``rotation_about_axes``.

    The angle about the middle axis is at most pi/2. The last angle is computed from R and the first one, so
    that the angles reproduce R to rounding also in gimbal lock.
    """
    R = shaped_array(R, (3, 3), "R")
    i, j, k = map("xyz".index, order)
    first = np.arctan2(R[..., j, k], R[..., k, k])
    s, c = np.sin(first), np.cos(first)
    theta = np.empty(R.shape[:-1])
    theta[..., i] = first
    theta[..., j] = np.arctan2(-R[..., i, k], np.hypot(R[..., k, k], R[..., j, k]))
    theta[..., k] = np.arctan2(s * R[..., k, i] - c * R[..., j, i], c * R[..., j, j] - s * R[..., k, j])
    # If the order is x, y, z or a cyclic permutation, the axes in reverse order are left-handed.
    return -theta if (j - i) % 3 == 1 else theta


def distance_from_lock(theta: Array, order: str) -> Array:
    """Return the distance of angles, (..., 3), from gimbal lock, from 0 to 1.

    It is the cosine of the angle about the middle axis; rates of angles are proportional to its inverse.
    """
    return np.abs(np.cos(theta[..., "xyz".index(order[1])]))


def far_from_lock(R: Array) -> tuple[Array, str]:
    """Return angles (rad), (n, 3), of rotations, in the order "zyx" or, near lock, another."""
    found = [(angles_from_rotation(R, order), order) for order in map("".join, itertools.permutations("zyx"))]
    least = [float(distance_from_lock(*each).min(initial=1.0)) for each in found]
    return found[0 if least[0] >= FAR_FROM_LOCK else int(np.argmax(least))]


def angle_rates(theta: Array, omega: Array, alpha: Array, order: str) -> tuple[Array, Array]:
    """Return derivatives of angles (rad/s, rad/s^2), (..., 3): the inverse of ``motion_about_axes``."""
    zero = np.zeros(theta.shape)
    axes = [motion_about_axes(theta, zero + unit, zero, order)[1] for unit in _ONE]
    inverse = np.linalg.inv(np.stack(axes, axis=-1))
    theta_dot = (inverse @ omega[..., None])[..., 0]
    carried = motion_about_axes(theta, theta_dot, zero, order)[2]
    return theta_dot, (inverse @ (alpha - carried)[..., None])[..., 0]


def rotation_from_vector(phi: ArrayLike) -> Array:
    """Return exp([phi]x), (..., 3, 3), of rotation vectors (rad), (..., 3)."""
    phi = shaped_array(phi, (3,), "phi")
    half = 0.5 * np.sqrt(np.sum(phi * phi, axis=-1, keepdims=True))
    return _of_unit_quaternion(np.cos(half), 0.5 * np.sinc(half / np.pi) * phi)


def rotation_from_quaternion(e: ArrayLike) -> Array:
    """Return rotations, (..., 3, 3), of quaternions, (..., 4), scalar first, of any length except zero."""
    e = _scaled(e)[0]
    unit = e / np.linalg.norm(e, axis=-1, keepdims=True)
    return _of_unit_quaternion(unit[..., :1], unit[..., 1:])


def _of_unit_quaternion(scalar: Array, vector: Array) -> Array:
    N = cross_matrix(vector)
    return np.asarray(_ONE + 2.0 * scalar[..., None] * N + 2.0 * N @ N)


def motion_of_quaternion(e: Array, e_dot: Array, e_ddot: Array) -> tuple[Array, Array, Array]:
    """Return R, (..., 3, 3), omega, and alpha, (..., 3), of quaternions and their derivatives, (..., 4).

    omega and alpha are the vectors of 2 e' e^-1 and of 2 (e'' e^-1 - (e' e^-1)^2).
    """
    e, e_dot, e_ddot = _scaled(e, e_dot, e_ddot)
    inverse = e * [1.0, -1.0, -1.0, -1.0] / np.sum(e * e, axis=-1, keepdims=True)
    rate = quaternion_product(e_dot, inverse)
    second = quaternion_product(e_ddot, inverse) - quaternion_product(rate, rate)
    return rotation_from_quaternion(e), 2.0 * rate[..., 1:], 2.0 * second[..., 1:]


def _scaled(e: ArrayLike, *rates: Array) -> list[Array]:
    """Divide a quaternion and its rates by its largest component; squares then do not overflow."""
    e = shaped_array(e, (4,), "e")
    largest = np.max(np.abs(e), axis=-1, keepdims=True)
    if not np.all(largest):
        raise ValueError("e: expected a quaternion of a length other than zero")
    return [each / largest for each in (e, *rates)]


def quaternion_rates(e: Array, omega: Array, alpha: Array) -> tuple[Array, Array]:
    """Return the derivatives (1/s, 1/s^2), (..., 4), of unit quaternions that rotate with omega and alpha."""
    half, change = (np.concatenate([0.0 * e[..., :1], 0.5 * x], axis=-1) for x in (omega, alpha))
    e_dot = quaternion_product(half, e)
    return e_dot, quaternion_product(change, e) + quaternion_product(half, e_dot)


def quaternion_product(one: Array, other: Array) -> Array:
    """Return the product of quaternions, (..., 4), scalar first."""
    a, u, b, v = one[..., :1], one[..., 1:], other[..., :1], other[..., 1:]
    scalar = a * b - np.sum(u * v, axis=-1, keepdims=True)
    return np.concatenate([scalar, a * v + b * u + cross(u, v)], axis=-1)


def quaternion_from_rotation(R: ArrayLike) -> Array:
    """Return unit quaternions, (..., 4), scalar first and not negative, of rotations, (..., 3, 3)."""
    R = shaped_array(R, (3, 3), "R")
    turned = np.swapaxes(R, -1, -2)
    # 4 e e^T, whose column with the largest diagonal element determines e without cancellation.
    K = np.empty((*R.shape[:-2], 4, 4))
    trace = R[..., 0, 0] + R[..., 1, 1] + R[..., 2, 2]
    K[..., 0, 0] = 1.0 + trace
    K[..., 0, 1:] = K[..., 1:, 0] = (turned - R)[..., (1, 2, 0), (2, 0, 1)]
    K[..., 1:, 1:] = R + turned + (1.0 - trace)[..., None, None] * _ONE
    largest = np.argmax(np.diagonal(K, axis1=-2, axis2=-1), axis=-1)
    e = np.take_along_axis(K, largest[..., None, None], axis=-1)[..., 0]
    return np.asarray(e * np.where(e[..., :1] < 0.0, -1.0, 1.0) / np.linalg.norm(e, axis=-1, keepdims=True))


def vector_from_rotation(R: ArrayLike) -> Array:
    """Return rotation vectors (rad), (..., 3), at most pi long, of rotations, (..., 3, 3)."""
    e = quaternion_from_rotation(R)
    sine = np.linalg.norm(e[..., 1:], axis=-1, keepdims=True)
    # Without a rotation the vector is zero.
    return np.asarray(2.0 * np.arctan2(sine, e[..., :1]) / np.where(sine > 0.0, sine, 1.0) * e[..., 1:])


def orthonormal(R: Array) -> Array:
    """Return R, (..., 3, 3), after one Newton step to the nearest rotation, which removes rounding errors."""
    return np.asarray(R @ (3.0 * _ONE - np.swapaxes(R, -1, -2) @ R) / 2.0)


def cross(x: Array, y: Array) -> Array:
    """Return the vector product x x y, (..., 3), in a fraction of the time of np.cross."""
    if x.size + y.size < _FEW:
        return np.asarray((x * y.take(_NEXT, -1) - x.take(_NEXT, -1) * y).take(_NEXT, -1))
    z = np.empty(np.broadcast_shapes(x.shape, y.shape))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        z[..., i] = x[..., j] * y[..., k] - x[..., k] * y[..., j]
    return z


def cross_matrix(vector: Array) -> Array:
    """Return the matrix [vector]x, (..., 3, 3), of the vector product."""
    N = np.zeros((*vector.shape, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        N[..., k, j], N[..., j, k] = vector[..., i], -vector[..., i]
    return N


# Integrators call the following functions a dozen times per step: plain numbers take a tenth of the time of
# arrays.


def one_rotation(e: Array) -> Array:
    """Return ``rotation_from_quaternion`` of one quaternion, (4,)."""
    w, x, y, z = e.tolist()
    s = 2.0 / (w * w + x * x + y * y + z * z)
    rows = (
        (1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)),
        (s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)),
        (s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)),
    )
    return np.array(rows)


def one_quaternion_rate(e: Array, omega: Array) -> tuple[float, float, float, float]:
    """Return the rate (1/s) of one quaternion, (4,), at one angular velocity (rad/s), (3,), base frame."""
    (w, x, y, z), (a, b, c) = e.tolist(), (0.5 * omega).tolist()
    return (
        -a * x - b * y - c * z,
        a * w + b * z - c * y,
        b * w + c * x - a * z,
        c * w + a * y - b * x,
    )


def one_rotation_vector(R: Array) -> Array:
    """Return ``vector_from_rotation`` of one rotation, (3, 3)."""
    (a, b, c), (d, e, f), (g, h, i) = R.tolist()
    twice_sine = math.hypot(h - f, c - g, d - b)
    twice_cosine = a + e + i - 1.0
    if twice_cosine < -1.0 or not twice_sine > 0.0:
        # Near a half turn, the differences lose digits.
        return vector_from_rotation(R)
    factor = math.atan2(twice_sine, twice_cosine) / twice_sine
    return np.array([factor * (h - f), factor * (c - g), factor * (d - b)])
