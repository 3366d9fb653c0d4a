"""Axisymmetric legs: no leg frame, no universal axis. Used by ``reduced_models``.

Of a slender leg only the first moments along its axis and the transverse inertia are left; its force K at
the spherical joint, up to a part along s, is a sum of S_ddot, S_dot and g with three coefficients. A
massless leg passes its axial force and nothing else.
"""

from dataclasses import dataclass

import sympy as sp

from ...program.block import Builder
from .. import lumped_constants as p
from .. import quantities as n
from .leg import leg_vector


@dataclass(frozen=True)
class Axis:
    """Where the leg is: tip q, unit vector s, L and 1/L."""

    q: sp.Matrix
    s: sp.Matrix
    L: sp.Expr
    inv_L: sp.Expr


def axis(build: Builder) -> Axis:
    """(1)-(3)."""
    q, _, L, inv_L, s = leg_vector(build)
    return Axis(q, s, L, inv_L)


def tip_force(
    build: Builder, at: Axis, S_dot: sp.Matrix, S_ddot: sp.Matrix, inertia: sp.Expr, reflected: sp.Expr
) -> tuple[sp.Expr, sp.Matrix]:
    """D and K of a slender leg, (21), (24); K carries a part along s, and D is to match.

    inertia: of both parts about base and platform point, across the leg. With the upper part's mass on the
    platform, the leg's kinetic energy is that of the turning s alone: (inertia + 2 L h) |s_dot|^2 / 2.
    reflected: mass of a rotor, which moves with L; zero without one.
    """
    h = p.h_s.value
    inv_L2 = build.scalar("inv_L2", at.inv_L**2)
    L_dot = build.scalar("L_dot", at.s.dot(S_dot), "(5)", "rate of the length")
    meaning = "K = K_a S_ddot + K_v S_dot - K_g g, up to a part along s"
    K_a = build.scalar("K_a", (inertia + 2 * at.L * h) * inv_L2, "(21)", meaning)
    L_share = build.scalar("L_share", 2 * at.inv_L * L_dot, "", "2 L_dot / L")
    K_v = build.scalar("K_v", L_share * (h * at.inv_L - K_a), "(21)", meaning)
    K_g = build.scalar("K_g", p.w_s.value * at.inv_L, "(21)", meaning)
    K = build.vector(
        "K",
        K_a * S_ddot + K_v * S_dot - K_g * n.g.value,
        "(21)",
        "force at the spherical joint, base frame",
    )
    turning = build.scalar("turning", (S_dot.dot(S_dot) - L_dot**2) * inv_L2, "(6)", "|s_dot|^2")
    D = -h * turning - at.s.dot(K)
    if reflected != 0:
        D += reflected * (at.s.dot(S_ddot) + at.L * turning)
    D = build.scalar("D", D, "(24)", "known part of the actuator force, to match")
    return D, K
