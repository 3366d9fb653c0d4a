"""The platform: kinematics (30)-(32), its two equations of motion, and H x = c read off them, (33)-(36).

Takes what the legs give as symbols (s, q, K, f of each leg) and hands back, for one leg, its column of H
and its part of c, and the part of c that belongs to no leg. The sign of sum K in (33) is a slip in print;
here it follows from the equation itself.
"""

from dataclasses import dataclass
from functools import cache

import sympy as sp

from ..program.block import Block, Builder, Quantity
from . import quantities as n
from .legs.leg import cross

LEGS = range(1, 7)
_LEG_VECTORS = (n.s, n.q, n.K, n.f)


@dataclass(frozen=True)
class LegShare:
    """What one leg gives to H x = c, as expressions of s, q, K, f without index.

    column: 6x1, its column of H; wrench: 6x1, its part of c.
    """

    column: sp.Matrix
    wrench: sp.Matrix


@dataclass(frozen=True)
class PlatformEquations:
    """H (6x6), x and c (6x1) of (36), with the symbols of all six legs."""

    H: sp.Matrix
    x: tuple[sp.Symbol, ...]
    c: sp.Matrix


def _indexed(quantity: Quantity, leg: int) -> sp.Matrix:
    return sp.Matrix([sp.Symbol(f"{name}_{leg}", real=True) for name in quantity.names])


def equations_of_motion(
    N: sp.Matrix, R_G: sp.Matrix, F_load: sp.Matrix, E: sp.Matrix, M_load: sp.Matrix
) -> PlatformEquations:
    """Newton's and Euler's equations with F_s = x s + K of every leg, solved for H and c.

    N: M (g - a_G); R_G: center of mass from the reference point; F_load, M_load: external force and moment;
    E: I alpha + omega x I omega. All 3x1, base frame.
    """
    force = N + F_load
    moment = cross(R_G, N) - E + M_load
    x = sp.symbols("x_1:7", real=True)
    for leg, x_leg in zip(LEGS, x, strict=True):
        s, q, K, f = (_indexed(quantity, leg) for quantity in _LEG_VECTORS)
        F_s = x_leg * s + K
        force -= F_s
        moment += -cross(q, F_s) + f
    H, c = sp.linear_eq_to_matrix([*force, *moment], x)
    return PlatformEquations(-H, x, -c)


def leg_share(equations: PlatformEquations) -> LegShare:
    """Column of H and part of c of one leg. Raises ValueError if the six legs do not enter alike."""
    shares = [_share_of(equations, leg) for leg in LEGS]
    if any(share != shares[0] for share in shares):
        raise ValueError("the legs do not enter the platform's equations alike")
    return shares[0]


def _share_of(equations: PlatformEquations, leg: int) -> LegShare:
    own = [symbol for quantity in _LEG_VECTORS for symbol in _indexed(quantity, leg)]
    plain = [symbol for quantity in _LEG_VECTORS for symbol in quantity.symbols]
    rename = dict(zip(own, plain, strict=True))
    wrench = equations.c - equations.c.xreplace(dict.fromkeys(own, sp.S.Zero))
    return LegShare(
        equations.H[:, leg - 1].applyfunc(sp.expand).xreplace(rename),
        wrench.applyfunc(sp.expand).xreplace(rename),
    )


@cache
def platform() -> tuple[Block, LegShare]:
    """The block of the platform's part of c, and the share of one leg."""
    build = Builder()
    R, omega, alpha = n.R.value, n.omega.value, n.alpha.value
    R_G = build.vector("R_G", R * n.R_0.value, "(30)", "center of mass from the reference point, base frame")
    a_G = build.vector(
        "a_G",
        cross(alpha, R_G) + cross(omega, cross(omega, R_G)) + n.a.value,
        "(31)",
        "acceleration of the center of mass",
    )
    inertia = build.tensor("I", R * n.I_p.value * R.T, "(32)", "inertia of the platform, base frame")
    N = build.vector("N", n.M.value * (n.g.value - a_G), "(33)", "M (g - a_G)")
    E = build.vector(
        "E", inertia * alpha + cross(omega, inertia * omega), "(34)", "I alpha + omega x I omega"
    )
    F_load = build.vector("F_load", R * n.F_ext.value, "(33)", "external force, base frame")
    M_load = build.vector("M_load", R * n.M_ext.value, "(34)", "external moment, base frame")
    equations = equations_of_motion(N, R_G, F_load, E, M_load)
    of_legs = [symbol for leg in LEGS for quantity in _LEG_VECTORS for symbol in _indexed(quantity, leg)]
    own = equations.c.xreplace(dict.fromkeys(of_legs, sp.S.Zero))
    block = build.block(
        "platform_wrench",
        "the platform's own part of c, (33)-(35)",
        (*n.MOTION, *n.PLATFORM),
        [(n.c_force, own[:3, :]), (n.c_moment, own[3:, :])],
    )
    return block, leg_share(equations)
