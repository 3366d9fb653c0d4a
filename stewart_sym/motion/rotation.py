"""Rotations by angles, (38) and other orders, and by rotation vectors: matrices, rates, second rates.

Plain vectorized functions; angles are ``theta = (theta_x, theta_y, theta_z)``, a rotation vector is the
axis times the angle, base axes.
"""

import itertools
import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import shaped_array
from ..io.array_types import Array

_Trig = tuple[Array, Array, Array, Array, Array, Array]

BLOCK = 2048
"""Poses computed at a time."""

_ONE = np.eye(3)
_NEXT = np.array([1, 2, 0])
_FEW = 300
"""Numbers below which the vector product of whole arrays costs less than that of their components."""

# Series by |phi|^2 of (1 - cos |phi|) / |phi|^2 and of (|phi| - sin |phi|) / |phi|^3.
_A = np.array([(-1.0) ** k / math.factorial(2 * k + 2) for k in range(11)])
_B = np.array([(-1.0) ** k / math.factorial(2 * k + 3) for k in range(11)])
_SERIES = _A, _B, polynomial.polyder(_A), polynomial.polyder(_B)


def rotation_from_rpy(theta: ArrayLike) -> Array:
    """Return R = Rz(theta_z) Ry(theta_y) Rx(theta_x), platform to base, (38).

    theta: rad, (..., 3).  Result: (..., 3, 3).
    """
    theta = shaped_array(theta, (3,), "theta")
    R = np.empty((*theta.shape, 3))
    _set_rotation(_trig(theta), R)
    return R


def rpy_motion(theta: Array, theta_dot: Array, theta_ddot: Array | None) -> tuple[Array, Array, Array | None]:
    """Return R (..., 3, 3), omega (..., 3) and alpha (..., 3), or None, of angles and rates of one shape.

    The three turns of (38) happen about e_x = Rz Ry x, e_y = Rz y and e_z = z, seen from the base, and
    angular velocities about moving axes add up:  omega = e_x theta_x' + e_y theta_y' + e_z theta_z'.  Each
    axis is carried by the turns outside of its own:  e_z' = 0,  e_y' = (e_z theta_z') x e_y,
    e_x' = (e_z theta_z' + e_y theta_y') x e_x.  Hence alpha = sum e_j theta_j'' + e_x' theta_x' +
    e_y' theta_y'.  In blocks whose numbers stay in the processor's second cache.
    """
    R, omega = np.empty((*theta.shape, 3)), np.empty(theta.shape)
    alpha = None if theta_ddot is None else np.empty(theta.shape)
    angles, rates, rotations = theta.reshape(-1, 3), theta_dot.reshape(-1, 3), R.reshape(-1, 3, 3)
    for start in range(0, len(angles), BLOCK):
        part = slice(start, start + BLOCK)
        trig, rate = _trig(angles[part]), _split(rates[part])
        _set_rotation(trig, rotations[part])
        _set_rows(_on_axes(trig, *rate), omega.reshape(-1, 3)[part])
        if alpha is not None and theta_ddot is not None:
            second = _split(theta_ddot.reshape(-1, 3)[part])
            _set_rows(_acceleration(trig, rate, second), alpha.reshape(-1, 3)[part])
    return R, omega, alpha


def rotation_about_axes(theta: ArrayLike, order: str) -> Array:
    """Return the product of the turns about the axes of ``order``: "zyx" for Rz Ry Rx, (38).

    theta: (theta_x, theta_y, theta_z), rad, (..., 3), whatever the order.  Result: (..., 3, 3).
    """
    theta = shaped_array(theta, (3,), "theta")
    R = np.eye(3)
    for axis in order:
        i = "xyz".index(axis)
        R = R @ rotation_from_rpy(theta * np.eye(3)[i])
    return np.asarray(R)


def rpy_from_rotation(R: ArrayLike) -> Array:
    """Return angles with R = Rz(theta_z) Ry(theta_y) Rx(theta_x) and |theta_y| <= pi/2; the inverse of (38).

    R: rotations, (..., 3, 3).  Result: rad, (..., 3).  theta_x is read off Rz^T R, so the angles give R back
    to rounding through theta_y = +-pi/2 too, where only theta_x -+ theta_z is determined.
    """
    R = shaped_array(R, (3, 3), "R")
    theta = np.empty(R.shape[:-1])
    theta[..., 2] = np.arctan2(R[..., 1, 0], R[..., 0, 0])
    s, c = np.sin(theta[..., 2]), np.cos(theta[..., 2])
    theta[..., 1] = np.arctan2(-R[..., 2, 0], np.hypot(R[..., 0, 0], R[..., 1, 0]))
    theta[..., 0] = np.arctan2(s * R[..., 0, 2] - c * R[..., 1, 2], c * R[..., 1, 1] - s * R[..., 0, 1])
    return theta


def rotation_from_vector(phi: ArrayLike) -> Array:
    """Return exp([phi]x): the turn by the angle |phi| about the direction of phi, base axes.

    phi: rad, (..., 3).  Result: (..., 3, 3).
    """
    phi = shaped_array(phi, (3,), "phi")
    half = 0.5 * np.sqrt(np.sum(phi * phi, axis=-1))[..., None, None]
    N = cross_matrix(phi)
    # sin(x)/x in both terms of Rodrigues' formula, as nothing cancels in it.
    return np.asarray(_ONE + np.sinc(2.0 * half / np.pi) * N + 0.5 * np.sinc(half / np.pi) ** 2 * N @ N)


def vector_from_rotation(R: ArrayLike) -> Array:
    """Return the rotation vector, rad, (..., 3), of rotations R (..., 3, 3), its length at most pi.

    By the quaternion, which is the largest eigenvector of a symmetric matrix linear in R: good to rounding at
    angles of 0 and of pi too, where only the sign of the vector is open.
    """
    quaternion = quaternion_from_rotation(R)
    sine = np.sqrt(np.sum(quaternion[..., 1:] ** 2, axis=-1, keepdims=True))
    angle = 2.0 * np.arctan2(sine, quaternion[..., :1])
    ratio = np.where(sine > 0.0, angle / np.where(sine > 0.0, sine, 1.0), 2.0)
    return np.asarray(ratio * quaternion[..., 1:])


def rotation_from_quaternion(e: ArrayLike) -> Array:
    """Return the rotation, (..., 3, 3), of a quaternion (..., 4), scalar first, of any length but zero.

    R x = e x e^-1. Raises ``ValueError`` for a quaternion of length zero.
    """
    (share,) = _shares(_quaternions(e, "e"))
    unit = share / np.linalg.norm(share, axis=-1, keepdims=True)
    N = cross_matrix(unit[..., 1:])
    return np.asarray(_ONE + 2.0 * unit[..., :1, None] * N + 2.0 * N @ N)


def angular_velocity_from_quaternion(e: ArrayLike, e_dot: ArrayLike) -> Array:
    """Return omega, rad/s, base frame, (..., 3), from a quaternion and its rate, (..., 4), scalar first.

    omega is the vector of 2 e' e^-1; what only changes the length of e has no part in it.
    """
    e, e_dot = _shares(_quaternions(e, "e"), _quaternions(e_dot, "e_dot"))
    return np.asarray(2.0 * quaternion_product(e_dot, _inverse(e))[..., 1:])


def angular_acceleration_from_quaternion(e: ArrayLike, e_dot: ArrayLike, e_ddot: ArrayLike) -> Array:
    """Return alpha, rad/s^2, base frame, (..., 3): the vector of 2 (e'' e^-1 - (e' e^-1)^2)."""
    given = _quaternions(e, "e"), _quaternions(e_dot, "e_dot"), _quaternions(e_ddot, "e_ddot")
    e, e_dot, e_ddot = _shares(*given)
    inverse = _inverse(e)
    rate = quaternion_product(e_dot, inverse)
    second = quaternion_product(e_ddot, inverse)
    return np.asarray(2.0 * (second - quaternion_product(rate, rate))[..., 1:])


def quaternion_product(one: Array, other: Array) -> Array:
    """Return the product of quaternions (..., 4), scalar first."""
    scalar = one[..., :1] * other[..., :1] - np.sum(one[..., 1:] * other[..., 1:], axis=-1, keepdims=True)
    vector = (
        one[..., :1] * other[..., 1:] + other[..., :1] * one[..., 1:] + cross(one[..., 1:], other[..., 1:])
    )
    return np.concatenate([scalar, vector], axis=-1)


def quaternion_from_rotation(R: ArrayLike) -> Array:
    """Return the unit quaternion, (..., 4), scalar first and not negative, of rotations R (..., 3, 3).

    The largest eigenvector of a symmetric matrix linear in R: good to rounding at every rotation.
    """
    R = shaped_array(R, (3, 3), "R")
    turned = np.swapaxes(R, -1, -2)
    K = np.empty((*R.shape[:-2], 4, 4))
    K[..., 0, 0] = trace = R[..., 0, 0] + R[..., 1, 1] + R[..., 2, 2]
    K[..., 0, 1:] = K[..., 1:, 0] = (turned - R)[..., (1, 2, 0), (2, 0, 1)]
    K[..., 1:, 1:] = R + turned - trace[..., None, None] * _ONE
    quaternion = np.linalg.eigh(K)[1][..., -1]
    return np.where(quaternion[..., :1] < 0.0, -quaternion, quaternion)


def vector_rate(phi: ArrayLike, omega: ArrayLike) -> Array:
    """Return the rate of phi, rad/s, (..., 3), where exp([phi]x) turns with omega, rad/s, base axes.

    phi' = omega - phi x omega / 2 + c phi x (phi x omega),  c = (1 - (|phi|/2) cot(|phi|/2)) / |phi|^2;
    needs |phi| < 2 pi.
    """
    phi, omega = shaped_array(phi, (3,), "phi"), shaped_array(omega, (3,), "omega")
    square = np.sum(phi * phi, axis=-1, keepdims=True)
    half = 0.5 * np.sqrt(square)
    # Below 0.05 rad the two terms of c cancel; its series is then good to 1e-17.
    small = half < 0.025
    safe = np.where(small, 1.0, half)
    series = (1.0 + square / 60.0 * (1.0 + square / 42.0 * (1.0 + square / 40.0))) / 12.0
    c = np.where(small, series, (1.0 - safe / np.tan(safe)) / (4.0 * safe * safe))
    across = cross(phi, omega)
    return np.asarray(omega - 0.5 * across + c * cross(phi, across))


def angular_motion_from_vector(
    phi: ArrayLike, phi_dot: ArrayLike, phi_ddot: ArrayLike
) -> tuple[Array, Array]:
    """Return omega, rad/s, and alpha, rad/s^2, (..., 3), base axes, of exp([phi]x) and its rates, (..., 3).

    omega = phi' + a phi x phi' + b phi x (phi x phi'),  a = (1 - cos |phi|) / |phi|^2,
    b = (|phi| - sin |phi|) / |phi|^3; alpha is its time derivative.
    """
    phi, phi_dot = shaped_array(phi, (3,), "phi"), shaped_array(phi_dot, (3,), "phi_dot")
    phi_ddot = shaped_array(phi_ddot, (3,), "phi_ddot")
    a, b, _, _ = _vector_factors(phi)
    once = cross(phi, phi_dot)
    omega = phi_dot + a * once + b * cross(phi, once)
    second = cross(phi, phi_ddot)
    alpha = phi_ddot + a * second + b * cross(phi, second) + _turning(phi, phi_dot)
    return omega, alpha


def vector_second_rate(phi: ArrayLike, omega: ArrayLike, alpha: ArrayLike) -> Array:
    """Return phi'', rad/s^2, (..., 3), where exp([phi]x) turns with omega, rad/s, and alpha, rad/s^2.

    Needs |phi| < 2 pi.
    """
    phi, alpha = shaped_array(phi, (3,), "phi"), shaped_array(alpha, (3,), "alpha")
    return vector_rate(phi, alpha - _turning(phi, vector_rate(phi, omega)))


def orthonormal(R: Array) -> Array:
    """Return R, (..., 3, 3), without the rounding of one product: Newton's step to the nearest rotation."""
    return np.asarray(R @ (3.0 * _ONE - np.swapaxes(R, -1, -2) @ R) / 2.0)


def cross(x: Array, y: Array) -> Array:
    """Return x x y, (..., 3): the vector product at a fraction of np.cross's cost for a few vectors."""
    if x.size + y.size < _FEW:
        return np.asarray((x * y.take(_NEXT, -1) - x.take(_NEXT, -1) * y).take(_NEXT, -1))
    z = np.empty(np.broadcast_shapes(x.shape, y.shape))
    (x0, x1, x2), (y0, y1, y2) = _split(x), _split(y)
    z[..., 0], z[..., 1], z[..., 2] = x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0
    return z


def cross_matrix(vector: Array) -> Array:
    """Return [vector]x, (..., 3, 3), the matrix of the vector product from the left."""
    x, y, z = _split(vector)
    N = np.zeros((*vector.shape, 3))
    N[..., 0, 1], N[..., 0, 2], N[..., 1, 2] = -z, y, -x
    N[..., 1, 0], N[..., 2, 0], N[..., 2, 1] = z, -y, x
    return N


def _turning(phi: Array, phi_dot: Array) -> Array:
    """What alpha has of phi' alone."""
    _, b, a_by_square, b_by_square = _vector_factors(phi)
    growth = 2.0 * np.sum(phi * phi_dot, axis=-1, keepdims=True)
    once = cross(phi, phi_dot)
    return np.asarray(
        growth * (a_by_square * once + b_by_square * cross(phi, once)) + b * cross(phi_dot, once)
    )


def _vector_factors(phi: Array) -> tuple[Array, Array, Array, Array]:
    """a and b of ``angular_motion_from_vector`` and their derivatives by |phi|^2, (..., 1)."""
    square = np.sum(phi * phi, axis=-1, keepdims=True)
    # Below 1 rad the closed forms cancel; eleven terms of the series are then good to rounding.
    small = np.minimum(square, 1.0)
    x = np.sqrt(np.maximum(square, 1.0))
    sine, cosine = np.sin(x), np.cos(x)
    closed = (
        (1.0 - cosine) / x**2,
        (x - sine) / x**3,
        (x * sine - 2.0 * (1.0 - cosine)) / (2.0 * x**4),
        (3.0 * sine - x * (2.0 + cosine)) / (2.0 * x**5),
    )
    near = square < 1.0
    series = (polynomial.polyval(small, terms) for terms in _SERIES)
    a, b, a_by_square, b_by_square = (np.where(near, *pair) for pair in zip(series, closed, strict=True))
    return a, b, a_by_square, b_by_square


def _inverse(e: Array) -> Array:
    return np.asarray(e * np.array([1.0, -1.0, -1.0, -1.0]) / np.sum(e * e, axis=-1, keepdims=True))


def _shares(e: Array, *rates: Array) -> list[Array]:
    """A quaternion and its rates over its largest component: squares then neither overflow nor vanish."""
    largest = np.max(np.abs(e), axis=-1, keepdims=True)
    return [each / largest for each in (e, *rates)]


def _quaternions(value: ArrayLike, name: str) -> Array:
    numbers = shaped_array(value, (4,), name)
    if name == "e" and not np.all(np.any(numbers != 0.0, axis=-1)):
        raise ValueError("e: expected a quaternion of a length other than zero")
    return numbers


def _trig(theta: Array) -> _Trig:
    """Sines and cosines of the angles: sx, sy, sz, cx, cy, cz."""
    x, y, z = _split(theta)
    return np.sin(x), np.sin(y), np.sin(z), np.cos(x), np.cos(y), np.cos(z)


def _set_rotation(trig: _Trig, R: Array) -> None:
    sx, sy, sz, cx, cy, cz = trig
    R[..., 0, 0], R[..., 0, 1], R[..., 0, 2] = cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx
    R[..., 1, 0], R[..., 1, 1], R[..., 1, 2] = sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx
    R[..., 2, 0], R[..., 2, 1], R[..., 2, 2] = -sy, cy * sx, cy * cx


def _acceleration(
    trig: _Trig, rates: Sequence[Array], seconds: Sequence[Array]
) -> tuple[Array, Array, Array]:
    x, y, z = rates
    about_x = _on_axes(trig, x, 0.0, 0.0)
    about_y = _on_axes(trig, 0.0, y, 0.0)
    alpha = _on_axes(trig, *seconds)
    # e_z z x (e_y y + e_x x) and e_y y x e_x x, component by component; e_y has no part along z.
    return (
        alpha[0] - z * (about_y[1] + about_x[1]) + about_y[1] * about_x[2],
        alpha[1] + z * (about_y[0] + about_x[0]) - about_y[0] * about_x[2],
        alpha[2] + about_y[0] * about_x[1] - about_y[1] * about_x[0],
    )


def _on_axes(trig: _Trig, x: Any, y: Any, z: Any) -> tuple[Array, Array, Array]:
    """Components of e_x x + e_y y + e_z z with the axes of ``rpy_motion``."""
    _, sy, sz, _, cy, cz = trig
    return cz * cy * x - sz * y, sz * cy * x + cz * y, z - sy * x


def _set_rows(components: tuple[Array, Array, Array], rows: Array) -> None:
    rows[..., 0], rows[..., 1], rows[..., 2] = components


def _split(vector: Array) -> tuple[Array, Array, Array]:
    return vector[..., 0], vector[..., 1], vector[..., 2]


# Turns about the three axes in any order.

# Angles are those about the axes of their names, whatever the order. With the axes renamed so that the order
# reads "zyx" every order is (38). Where the new axes are left-handed, angles and angular velocities change
# their signs.


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
    found = [(angles_from_rotation(R, order), order) for order in map("".join, itertools.permutations("zyx"))]
    return max(found, key=lambda each: float(distance_from_lock(*each).min()))


def angle_rates(theta: Array, omega: Array, alpha: Array, order: str) -> tuple[Array, Array]:
    """Return theta_dot, rad/s, and theta_ddot, rad/s^2, (..., 3): the inverse of ``motion_about_axes``.

    theta: rad, with a ``distance_from_lock`` > 0; omega, alpha: rad/s and rad/s^2, base frame, (..., 3).
    """
    axes, sign = _renamed(order)
    theta, omega, alpha = (sign * each[..., axes] for each in (theta, omega, alpha))
    turns = [rpy_motion(theta, np.broadcast_to(unit, theta.shape), None)[1] for unit in np.eye(3)]
    E = np.stack(turns, axis=-1)
    theta_dot = _solved(E, omega)
    carried = rpy_motion(theta, theta_dot, np.zeros_like(theta))[2]
    assert carried is not None
    theta_ddot = _solved(E, alpha - carried)
    back = np.argsort(axes)
    return sign * theta_dot[..., back], sign * theta_ddot[..., back]


def _solved(E: Array, vector: Array) -> Array:
    return np.asarray(np.linalg.solve(E, vector[..., None])[..., 0], dtype=np.float64)


def _renamed(order: str) -> tuple[NDArray[np.int64], float]:
    """Axes that become x, y and z where ``order`` reads "zyx"; -1 where these are left-handed, else 1."""
    axes = np.array(["xyz".index(axis) for axis in reversed(order)])
    return axes, float(np.linalg.det(np.eye(3)[axes]).round())


# Of one state in plain numbers, without NumPy's cost of a call: integrations need a dozen of them per step.


def turned_by(phi: Array, center: Array) -> Array:
    """Return exp([phi]x) R of one rotation vector, rad, (3,), and one rotation, (3, 3)."""
    x, y, z = phi.tolist()
    angle = math.hypot(x, y, z)
    half = 0.5 * angle
    first = math.sin(angle) / angle if angle > 0.0 else 1.0
    second = 0.5 * (math.sin(half) / half) ** 2 if half > 0.0 else 0.5
    a, b, c = second * x * y, second * x * z, second * y * z
    turn = np.array(
        (
            (1.0 - second * (y * y + z * z), a - first * z, b + first * y),
            (a + first * z, 1.0 - second * (x * x + z * z), c - first * x),
            (b - first * y, c + first * x, 1.0 - second * (x * x + y * y)),
        )
    )
    return np.asarray(turn @ center)


def one_vector_rate(phi: Array, omega: Array) -> tuple[float, float, float]:
    """Return ``vector_rate`` of one state; phi, rad, and omega, rad/s, base axes, (3,)."""
    x, y, z = phi.tolist()
    u, v, w = omega.tolist()
    square = x * x + y * y + z * z
    half = 0.5 * math.sqrt(square)
    if half < 0.025:
        c = (1.0 + square / 60.0 * (1.0 + square / 42.0 * (1.0 + square / 40.0))) / 12.0
    else:
        c = (1.0 - half / math.tan(half)) / square
    i, j, k = y * w - z * v, z * u - x * w, x * v - y * u
    return (
        u - 0.5 * i + c * (y * k - z * j),
        v - 0.5 * j + c * (z * i - x * k),
        w - 0.5 * k + c * (x * j - y * i),
    )
