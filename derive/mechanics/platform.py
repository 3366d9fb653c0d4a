"""Equations of motion of the platform: (30)-(34), written as H x = c (36).

Equations (30)-(32) are the kinematics and (33)-(34) the force and moment balance. The terms of the legs are
the symbols s, q, K, f of each leg. The results are the column of H and the part of c of one leg, and the part
of c that belongs to the platform. In the printed (33) the sign of sum K is a misprint. Here the sign follows
from the force balance.
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
    """Terms of one leg in H x = c, base frame, as expressions of s, q, K, f without the number of the leg.

    Attributes
    ----------
    column : Matrix, shape (6, 1)
        Column of H.
    wrench : Matrix, shape (6, 1)
        Part of c.
    """

    column: sp.Matrix
    wrench: sp.Matrix


@dataclass(frozen=True)
class PlatformEquations:
    """H x = c (36) with the symbols of all six legs, base frame.

    Attributes
    ----------
    H : Matrix, shape (6, 6)
        Wrench matrix.
    x : tuple of Symbol, length 6
        Axial forces of the legs at their spherical joints (N).
    c : Matrix, shape (6, 1)
        Right-hand side.
    """

    H: sp.Matrix
    x: tuple[sp.Symbol, ...]
    c: sp.Matrix


def _indexed(quantity: Quantity, leg: int) -> sp.Matrix:
    return sp.Matrix([sp.Symbol(f"{name}_{leg}", real=True) for name in quantity.names])


def equations_of_motion(
    N: sp.Matrix, R_G: sp.Matrix, F_load: sp.Matrix, E: sp.Matrix, M_load: sp.Matrix
) -> PlatformEquations:
    """Solve the force and moment balance (33), (34) of the platform for H and c.

    The force on each leg is F_s = x s + K. All arguments are in the base frame and have shape (3, 1).

    Parameters
    ----------
    N : Matrix
        Gravity and inertia force M (g - a_G) (N).
    R_G : Matrix
        Center of mass from the reference point (m).
    F_load, M_load : Matrix
        External force (N) and moment (N m).
    E : Matrix
        Rate of the angular momentum, I alpha + omega x I omega (N m).
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
    """Return the column of H and the part of c of one leg.

    Raises
    ------
    ValueError
        If the six legs do not enter the equations in the same way.
    """
    shares = [_share_of(equations, leg) for leg in LEGS]
    if any(share != shares[0] for share in shares):
        raise ValueError("the six legs do not enter the equations of the platform in the same way")
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
    """Derive the block of the platform's part of c, and the terms of one leg."""
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
        "part of c that belongs to the platform, (33)-(35)",
        (*n.MOTION, *n.PLATFORM),
        [(n.c_force, own[:3, :]), (n.c_moment, own[3:, :])],
    )
    return block, leg_share(equations)
