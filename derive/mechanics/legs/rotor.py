"""Rotor of a leg's drive and its terms in the equations of the leg.

The rotor turns about the leg axis by N L relative to the lower part. The inertia of the lower part includes
the rotor. The additional kinetic energy is m_r L_dot^2 / 2 + j_r L_dot (W.s) with m_r = J_r N^2 and j_r = J_r
N: a mass that moves with the leg length, and an angular momentum j_r L_dot s that rotates with the leg.
"""

from dataclasses import dataclass

import sympy as sp

from .. import quantities as n
from ..formulation import SPHERICAL, Formulation


@dataclass(frozen=True)
class Rotor:
    """Constants of a rotor; zero for an omitted term.

    Attributes
    ----------
    mass : Expr
        Reflected mass m_r (kg).
    momentum : Expr
        Angular momentum per length rate j_r (kg m).
    """

    mass: sp.Expr
    momentum: sp.Expr


NONE = Rotor(sp.S.Zero, sp.S.Zero)
REFLECTED = Rotor(n.m_r.value, sp.S.Zero)
"""Rotor with reflected mass and without angular momentum."""
FULL = Rotor(n.m_r.value, n.j_r.value)


def rotor_of(form: Formulation) -> Rotor:
    """Return the rotor of the legs of a formulation.

    The spin of a leg with two spherical joints is undetermined, so the angular momentum of its rotor is
    undefined too. Such a leg has only the reflected mass.
    """
    if not form.drive:
        return NONE
    return REFLECTED if form.base_joint == SPHERICAL else FULL
