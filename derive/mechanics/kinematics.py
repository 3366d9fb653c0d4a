"""Kinematics of the legs, (1)-(5), and of a step of the platform, for the search of a pose from leg lengths.

From the vectors of ``leg``: lengths, rates, the rows of J = H^T, and the rotation by which a step of
Newton's method turns the platform.
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
Q = Quantity("Q", (3, 3), "1", "rotation by which the platform is turned, base frame")


@dataclass(frozen=True)
class Kinematics:
    """The blocks from which lengths, rates and the steps of the search are computed.

    vectors: q, S and L of one leg; row: its row of J; rate: its L_dot; turned: Q of a small rotation;
    second: L, L_dot, L_ddot, s, S and q of one leg.
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
        "The row [s, q x s] of J, by which [v; omega] moves the leg, (5)",
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
        "Length of one leg and its first and second rate, its unit vector, S and q, (1)-(5), (7), (8)",
        (*n.MOTION, n.b, n.p),
        [(n.L, L), (L_dot, rate), (L_ddot, second), (n.s, s), (S, vector), (n.q, q)],
    )


def _turned() -> Block:
    """Cayley's rotation (E - X)^-1 (E + X) with X = [turn / 2]x: exp([turn]x) to third order."""
    build = Builder()
    w = build.vector("w", turn.value / 2, "", "half the turn")
    share = build.scalar("share", 2 / (1 + w.dot(w)))
    products = build.tensor("W", w * w.T, "", "products of the half turn")
    square = products - products.trace() * sp.eye(3)
    rotation = sp.eye(3) + (skew(w) + square) * share
    return build.block(
        "turned_by",
        "Cayley's rotation, which needs no sine: exp([turn]x) to third order",
        (turn,),
        [(Q, rotation)],
    )
