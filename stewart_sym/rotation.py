"""Rotation matrices: from roll, pitch and yaw, (38), with angular velocity and acceleration, or a vector.

Plain vectorised functions of angles ``theta = (theta_x, theta_y, theta_z)``, used where a motion is made;
they know nothing of robots or motions.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .checks import real_array

Array = NDArray[np.float64]


def rotation_from_rpy(theta: ArrayLike) -> Array:
    """Return R = Rz(theta_z) Ry(theta_y) Rx(theta_x), platform to base, (38).

    theta: rad, (..., 3).  Result: (..., 3, 3).
    """
    theta = _angles(theta, "theta")
    (sx, sy, sz), (cx, cy, cz) = _split(np.sin(theta)), _split(np.cos(theta))
    R = np.empty((*theta.shape, 3))
    R[..., 0, 0], R[..., 0, 1], R[..., 0, 2] = cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx
    R[..., 1, 0], R[..., 1, 1], R[..., 1, 2] = sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx
    R[..., 2, 0], R[..., 2, 1], R[..., 2, 2] = -sy, cy * sx, cy * cx
    return R


def rpy_from_rotation(R: ArrayLike) -> Array:
    """Return angles with R = Rz(theta_z) Ry(theta_y) Rx(theta_x) and |theta_y| <= pi/2; the inverse of (38).

    R: rotations, (..., 3, 3).  Result: rad, (..., 3).  theta_x is read off Rz^T R, so the angles give R back
    to rounding through theta_y = +-pi/2 too, where only theta_x -+ theta_z is determined.
    """
    R = real_array(R, "R", "real numbers of shape (..., 3, 3)")
    if R.shape[-2:] != (3, 3):
        raise ValueError(f"R: expected shape (..., 3, 3), got {R.shape}")
    theta = np.empty(R.shape[:-1])
    theta[..., 2] = np.arctan2(R[..., 1, 0], R[..., 0, 0])
    s, c = np.sin(theta[..., 2]), np.cos(theta[..., 2])
    theta[..., 1] = np.arctan2(-R[..., 2, 0], np.hypot(R[..., 0, 0], R[..., 1, 0]))
    theta[..., 0] = np.arctan2(s * R[..., 0, 2] - c * R[..., 1, 2], c * R[..., 1, 1] - s * R[..., 0, 1])
    return theta


def rotation_from_vector(phi: ArrayLike) -> Array:
    """Return R = exp([phi]x), the turn by |phi| rad about phi; phi: (..., 3).  Result: (..., 3, 3)."""
    phi = _angles(phi, "phi")
    angle = np.linalg.norm(phi, axis=-1)[..., None, None]
    x, y, z = _split(phi)
    N = np.zeros((*phi.shape, 3))
    N[..., 0, 1], N[..., 0, 2], N[..., 1, 2] = -z, y, -x
    N -= np.swapaxes(N, -1, -2)
    # sin(angle)/angle and (1 - cos(angle))/angle^2, good at angle 0 too; np.sinc has pi in it.
    first, second = np.sinc(angle / np.pi), 0.5 * np.sinc(0.5 * angle / np.pi) ** 2
    return np.asarray(np.eye(3) + first * N + second * (N @ N))


def angular_velocity_from_rpy(theta: ArrayLike, theta_dot: ArrayLike) -> Array:
    """Return omega, rad/s, base frame, (..., 3), from angles (rad) and rates (rad/s), both (..., 3).

    The three turns of (38) happen about e_x = Rz Ry x, e_y = Rz y and e_z = z, seen from the base, and
    angular velocities about moving axes add up:  omega = e_x theta_x' + e_y theta_y' + e_z theta_z'.
    """
    theta, theta_dot = _angles(theta, "theta"), _angles(theta_dot, "theta_dot")
    return _on_axes(_axes(theta), theta_dot)


def angular_acceleration_from_rpy(theta: ArrayLike, theta_dot: ArrayLike, theta_ddot: ArrayLike) -> Array:
    """Return alpha, rad/s^2, base frame, (..., 3), from angles, rates and second rates (SI), all (..., 3).

    The time derivative of omega = sum e_j theta_j'.  Each axis is carried by the turns outside of its own:
    e_z' = 0,  e_y' = (e_z theta_z') x e_y,  e_x' = (e_z theta_z' + e_y theta_y') x e_x.  Hence
    alpha = sum e_j theta_j'' + e_x' theta_x' + e_y' theta_y'.
    """
    theta, theta_dot = _angles(theta, "theta"), _angles(theta_dot, "theta_dot")
    theta_ddot = _angles(theta_ddot, "theta_ddot")
    axes = _axes(theta)
    e_x, e_y, e_z = axes
    x, y, z = (rate[..., None] for rate in _split(theta_dot))
    e_y_dot = np.cross(e_z * z, e_y)
    e_x_dot = np.cross(e_z * z + e_y * y, e_x)
    return _on_axes(axes, theta_ddot) + e_x_dot * x + e_y_dot * y


def _axes(theta: Array) -> tuple[Array, Array, Array]:
    (_, sy, sz), (_, cy, cz) = _split(np.sin(theta)), _split(np.cos(theta))
    zero = np.zeros_like(sy)
    return (
        np.stack([cz * cy, sz * cy, -sy], axis=-1),
        np.stack([-sz, cz, zero], axis=-1),
        np.stack([zero, zero, zero + 1.0], axis=-1),
    )


def _on_axes(axes: tuple[Array, Array, Array], rates: Array) -> Array:
    e_x, e_y, e_z = axes
    x, y, z = (rate[..., None] for rate in _split(rates))
    return np.asarray(e_x * x + e_y * y + e_z * z, dtype=np.float64)


def _split(vector: Array) -> tuple[Array, Array, Array]:
    return vector[..., 0], vector[..., 1], vector[..., 2]


def _angles(value: ArrayLike, name: str) -> Array:
    angles = real_array(value, name, "real numbers of shape (..., 3)")
    if angles.shape[-1:] != (3,):
        raise ValueError(f"{name}: expected shape (..., 3), got {angles.shape}")
    return angles
