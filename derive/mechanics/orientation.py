"""Orientation, angular velocity, and angular acceleration from angles (38) or from a quaternion.

The angles are roll, pitch, and yaw. Their sines and cosines are inputs, because blocks contain no function
except the square root.
"""

import sympy as sp

from ..program.block import Block, Builder, Quantity
from . import quantities as n
from .legs.leg import cross, skew

SINE = Quantity("sine", (3,), "1", "sines of theta_x, theta_y, theta_z")
COSINE = Quantity("cosine", (3,), "1", "cosines of theta_x, theta_y, theta_z")
RATE = Quantity("theta_dot", (3,), "rad/s", "rates of the angles")
SECOND = Quantity("theta_ddot", (3,), "rad/s^2", "second derivatives of the angles")


def _quaternion(name: str, unit: str, meaning: str) -> tuple[Quantity, Quantity]:
    return Quantity(f"{name}_w", (), unit, f"{meaning}, scalar part"), Quantity(name, (3,), unit, meaning)


E = _quaternion("e", "1", "quaternion")
E_DOT = _quaternion("e_dot", "1/s", "derivative of the quaternion")
E_DDOT = _quaternion("e_ddot", "1/s^2", "second derivative of the quaternion")


def rpy() -> Block:
    """Derive R = Rz Ry Rx (38), omega = e_x theta_x' + e_y theta_y' + e_z theta_z', and alpha = omega'."""
    (sx, sy, sz), (cx, cy, cz) = SINE.symbols, COSINE.symbols
    Rx = sp.Matrix([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    Ry = sp.Matrix([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    Rz = sp.Matrix([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    axes = sp.Matrix.hstack(Rz * Ry[:, 0], Rz[:, 1], sp.Matrix([0, 0, 1]))
    build = Builder()
    turns = [
        build.vector(f"about_{axis}", axes[:, i] * RATE.value[i], "", f"rate of theta_{axis} about its axis")
        for i, axis in enumerate("xyz")
    ]
    # The rotations that are applied after an axis also rotate this axis.
    carried = cross(turns[2], turns[1] + turns[0]) + cross(turns[1], turns[0])
    return build.block(
        "turned_by_angles",
        "Orientation, angular velocity, and angular acceleration from roll, pitch, and yaw, (38)",
        (SINE, COSINE, RATE, SECOND),
        [
            (n.R, Rz * Ry * Rx),
            (n.omega, turns[0] + turns[1] + turns[2]),
            (n.alpha, axes * SECOND.value + carried),
        ],
    )


def quaternion() -> Block:
    """Derive R x = e x e^-1, omega = 2 e' e^-1, and alpha = 2 (e'' e^-1 - (e' e^-1)^2).

    The quaternion e may have any norm.
    """
    (w, v), rate, second = ((part.value for part in parts) for parts in (E, E_DOT, E_DDOT))
    build = Builder()
    over = build.scalar("inv_square", 1 / (w * w + v.dot(v)), "", "1 / |e|^2")
    turn = skew(v)
    R = sp.eye(3) + 2 * over * (w * turn + turn * turn)

    def by_inverse(scalar: sp.Expr, vector: sp.Matrix) -> tuple[sp.Expr, sp.Matrix]:
        """Multiply a quaternion by e^-1 = (w, -v) / |e|^2 from the right."""
        return over * (scalar * w + vector.dot(v)), over * (w * vector - scalar * v - cross(vector, v))

    along, half = by_inverse(*rate)
    along, half = (
        build.scalar("growth", along),
        build.vector("half_omega", half, "", "half the angular velocity"),
    )
    _, second_half = by_inverse(*second)
    return build.block(
        "turned_by_quaternion",
        "Orientation, angular velocity, and angular acceleration from a quaternion and its derivatives",
        (*E, *E_DOT, *E_DDOT),
        [(n.R, R), (n.omega, 2 * half), (n.alpha, 2 * second_half - 4 * along * half)],
    )
