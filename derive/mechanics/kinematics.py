"""Kinematics of the legs (1)-(5) and rotation steps of the platform, for direct kinematics.

The blocks compute leg lengths, length rates, rows of the inverse Jacobian H^T, and the rotation of the
platform in a Newton step.
"""

from dataclasses import dataclass

import sympy as sp

from ..program.block import Block, Builder, Quantity
from . import quantities as n
from .legs.leg import cross, leg_vector, platform_point_motion, skew, sliding

S = Quantity("S", (3,), "m", "vector from base point to platform point, base frame")
L_dot = Quantity("L_dot", (), "m/s", "rate of the leg's length, positive when it extends")
L_ddot = Quantity("L_ddot", (), "m/s^2", "second derivative of the leg's length")
turn = Quantity("turn", (3,), "rad", "small rotation of the platform, base frame")
Q = Quantity("Q", (3, 3), "1", "rotation matrix of this rotation, base frame")


@dataclass(frozen=True)
class Kinematics:
    """Blocks of inverse kinematics and of the Newton steps of direct kinematics.

    Attributes
    ----------
    vectors : Block
        q, S, and L of one leg, (1), (2).
    row : Block
        Row [s, q x s] of the inverse Jacobian H^T.
    rate : Block
        Length rate L_dot of one leg, (4), (5).
    turned : Block
        Rotation matrix Q of a small rotation.
    second : Block
        L, L_dot, L_ddot, s, S, and q of one leg, (1)-(5), (7), (8).
    """

    vectors: Block
    row: Block
    rate: Block
    turned: Block
    second: Block


def kinematics() -> Kinematics:
    """Derive the five blocks."""
    return Kinematics(_vectors(), _row(), _rate(), _turned(), _second())


def _vectors() -> Block:
    build = Builder()
    q, vector, L, _, _ = leg_vector(build)
    return build.block(
        "vectors_of",
        "Vectors q and S of one leg, and its length L, (1), (2)",
        (*n.MOTION, n.b, n.p),
        [(n.q, q), (S, vector), (n.L, L)],
    )


def _row() -> Block:
    build = Builder()
    inv_L = build.scalar("inv_L", 1 / n.L.value)
    s = build.vector("s", S.value * inv_L, "(3)", "unit vector along the leg")
    return build.block(
        "row_of",
        "Row [s, q x s] of the inverse Jacobian H^T, which maps [v; omega] to the length rate, (5)",
        (n.q, S, n.L),
        [(n.H_force, s), (n.H_moment, cross(n.q.value, s))],
    )


def _rate() -> Block:
    build = Builder()
    S_dot, _ = platform_point_motion(build, n.q.value)
    along = build.scalar("S_S_dot", S.value.dot(S_dot), "(5)", "L L_dot")
    return build.block(
        "rate_of",
        "Rate L_dot of one leg, (4), (5)",
        (n.q, S, n.L, n.omega, n.v),
        [(L_dot, build.scalar("rate", along / n.L.value, "(5)", "sliding velocity"))],
    )


def _second() -> Block:
    build = Builder()
    q, vector, L, inv_L, s = leg_vector(build)
    S_dot, S_ddot = platform_point_motion(build, q)
    rate, second = sliding(build, s, inv_L, S_dot, S_ddot)
    return build.block(
        "motion_of",
        "Length of one leg with its first and second derivative, unit vector s, S, and q, (1)-(5), (7), (8)",
        (*n.MOTION, n.b, n.p),
        [(n.L, L), (L_dot, rate), (L_ddot, second), (n.s, s), (S, vector), (n.q, q)],
    )


def _turned() -> Block:
    """Derive Cayley's rotation (E - X)^-1 (E + X) with X = [turn / 2]x: exp([turn]x) to third order."""
    build = Builder()
    w = build.vector("w", turn.value / 2, "", "half of the rotation vector")
    share = build.scalar("share", 2 / (1 + w.dot(w)))
    products = build.tensor("W", w * w.T, "", "products of the components of w")
    square = products - products.trace() * sp.eye(3)
    rotation = sp.eye(3) + (skew(w) + square) * share
    return build.block(
        "turned_by",
        "Cayley's rotation, without sines: exp([turn]x) to third order",
        (turn,),
        [(Q, rotation)],
    )
