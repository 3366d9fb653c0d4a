"""Forces along the legs that accelerate the drive rotors, as functions of platform accelerations."""

import math
from typing import NamedTuple

import numpy as np

from ..io.array_types import Array
from ..kinematics.inverse_kinematics import leg_vectors, length_rows
from ..motion.motion import Motion
from ..motion.rotation import cross
from ..robot.robot import Robot


class LegRates(NamedTuple):
    """Leg rates (m/s), (..., 6), and the rows [s, q x s], (..., 6, 6), that map a twist to them.

    own: L_ddot without platform accelerations. q, tip, turned: platform points, their velocities, and their
    accelerations due to the angular velocity, (..., 6, 3).
    """

    L_dot: Array
    J: Array
    own: Array
    L: Array
    q: Array
    tip: Array
    turned: Array


def leg_rates(robot: Robot, state: Motion) -> LegRates:
    """Compute the leg rates in states (...)."""
    q, S, L = leg_vectors(robot, state.R, state.t)
    J = length_rows(q, S, L)
    omega = state.omega[..., None, :]
    turning = cross(omega, q)
    tip, turned = turning + state.v[..., None, :], cross(omega, turning)
    L_dot = product(J, np.concatenate([state.v, state.omega], axis=-1))
    with np.errstate(all="ignore"):
        own = (_dot(S, turned) + _dot(tip, tip) - L_dot**2) / L
    own = own if math.isfinite(float(own.sum())) else np.zeros_like(own)
    return LegRates(L_dot, J, own, L, q, tip, turned)


def rotors_by_acceleration(robot: Robot, legs: LegRates) -> tuple[Array, Array]:
    """Return rotor forces (N) without accelerations, (..., 6), and per acceleration, (..., 6, 6)."""
    # They depend on L_ddot, (8), and on the rate of the leg spin (k.s) (y.sdot) / y^2 with y = k x s.
    k, m_r, j_r = robot.k, robot.reflected_mass, robot.rotor_momentum
    alone, per = m_r * legs.own, m_r[:, None] * legs.J
    if robot.base_joint == "spherical":
        return alone, per
    s, L = legs.J[..., :3], legs.L
    s_dot = (legs.tip - legs.L_dot[..., None] * s) / L[..., None]
    y = cross(k, s)
    square = _dot(y, y)
    along, along_dot, about = _dot(k, s), _dot(k, s_dot), _dot(y, s_dot)
    row = (along / (L * square))[..., None] * y
    quick = along_dot * (1.0 + 2.0 * along**2 / square) - 2.0 * legs.L_dot / L * along
    quick = _dot(row, legs.turned) + about / square * quick
    rows = np.concatenate([row, cross(legs.q, row)], axis=-1)
    return alone + j_r * quick, per + j_r[:, None] * rows


def product(A: Array, x: Array) -> Array:
    """Multiply matrices by vectors."""
    return np.asarray((A @ x[..., None])[..., 0])


def _dot(x: Array, y: Array) -> Array:
    return np.asarray(np.einsum("...i,...i->...", x, y))
