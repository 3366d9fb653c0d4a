"""Leg of ``exact`` by Lagrange's equations from the energies of its two bodies.

The fixed axis k is the third axis of a base frame. T = [s y z] is an explicit function of theta and phi.
Positions follow from T, velocities by differentiation, and W from T^T dT/dt. This derivation is independent:
it uses no angular velocity, acceleration, or inertia of ``leg``, ``joint_coordinates``, ``lumped_constants``,
or ``tip``. The mass of the upper part belongs to the leg and is not lumped with the platform.
"""

from dataclasses import dataclass

import sympy as sp

from .. import quantities as n
from .normal_form import cos_phi, normal_form, sin_phi

time = sp.Symbol("time", real=True)
coordinates = tuple(sp.Function(name, real=True)(time) for name in ("L", "theta", "phi"))

_L, _theta, _phi = coordinates
_HALF = sp.Rational(1, 2)


def _symbols(suffix: str) -> tuple[sp.Symbol, ...]:
    return tuple(sp.Symbol(f"{name}{suffix}", real=True) for name in ("L", "theta", "phi"))


@dataclass(frozen=True)
class Energies:
    """Energies of one leg as functions of time.

    Attributes
    ----------
    kinetic, potential : Expr
        Kinetic and potential energy (J).
    dissipation : Expr
        Half of the power lost to friction (W).
    """

    kinetic: sp.Expr
    potential: sp.Expr
    dissipation: sp.Expr


def leg_frame() -> sp.Matrix:
    """Return T = [s y z] of (10) in a base frame whose third axis is k, with k.s = cos theta."""
    about_k = sp.rot_ccw_axis3(_phi)
    return about_k * sp.Matrix(
        [[sp.sin(_theta), 0, -sp.cos(_theta)], [0, 1, 0], [sp.cos(_theta), 0, sp.sin(_theta)]]
    )


def energies() -> Energies:
    """Compute the energies of the lower and the upper part."""
    T = leg_frame()
    spin = T.T * T.diff(time)
    W = sp.Matrix([spin[2, 1], spin[0, 2], spin[1, 0]])
    lower = T * n.r_d0.value
    upper = T * (sp.Matrix([_L, 0, 0]) + n.r_u0.value)
    v_d, v_u = lower.diff(time), upper.diff(time)
    m_d, m_u = n.m_d.value, n.m_u.value
    slip = W - T.T * n.omega.value
    return Energies(
        kinetic=_HALF * (m_d * v_d.dot(v_d) + m_u * v_u.dot(v_u) + W.dot((n.I_d0.value + n.I_u0.value) * W)),
        potential=-n.g.value.dot(m_d * lower + m_u * upper),
        dissipation=_HALF
        * (n.C_u.value * W.dot(W) + n.C_p.value * _L.diff(time) ** 2 + n.C_s.value * slip.dot(slip)),
    )


def torques(gamma: sp.Matrix, omega: sp.Matrix) -> sp.Matrix:
    """Compute the generalized forces along L, theta, phi, 3x1, in the symbols of ``tip`` and in normal form.

    ``gamma`` and ``omega`` are gravity and the angular velocity of the platform in the leg frame, 3x1.
    """
    of = energies()
    return sp.Matrix(
        [
            of.kinetic.diff(q.diff(time)).diff(time)
            - of.kinetic.diff(q)
            + of.potential.diff(q)
            + of.dissipation.diff(q.diff(time))
            for q in coordinates
        ]
    ).applyfunc(lambda torque: _in_symbols(torque, gamma, omega))


def inertia() -> sp.Matrix:
    """Compute the Hessian of the kinetic energy by the rates of L, theta, phi, 3x3, in normal form."""
    rates = [q.diff(time) for q in coordinates]
    kinetic, nothing = energies().kinetic, sp.zeros(3, 1)
    return sp.Matrix(3, 3, lambda i, j: _in_symbols(kinetic.diff(rates[i], rates[j]), nothing, nothing))


def _in_symbols(expr: sp.Expr, gamma: sp.Matrix, omega: sp.Matrix) -> sp.Expr:
    """Replace functions of time by symbols, and base-frame vectors by their leg-frame components."""
    derivatives = [
        (q.diff(time, order), symbol)
        for order, suffix in ((2, "_ddot"), (1, "_dot"))
        for q, symbol in zip(coordinates, _symbols(suffix), strict=True)
    ]
    k1, k3 = sp.symbols("k1 k3", real=True)
    places = {
        sp.cos(_theta): k1,
        sp.sin(_theta): k3,
        sp.cos(_phi): cos_phi,
        sp.sin(_phi): sin_phi,
        _L: _symbols("")[0],
    }
    T = leg_frame().xreplace(places)
    turned = dict(zip((*n.g.value, *n.omega.value), (*(T * gamma), *(T * omega)), strict=True))
    return normal_form(expr.subs(derivatives).xreplace(places).xreplace(turned))
