"""The rotor of a leg's drive: what it adds to the leg's equations, by two constants.

The rotor turns about the leg by N L relative to the lower part, whose inertia includes the rotor's. Its
kinetic energy beyond that is m_r L_dot^2 / 2 + j_r L_dot (W.s), with m_r = J_r N^2 and j_r = J_r N: a mass
that moves with the length, and an angular momentum j_r L_dot s that the leg carries round.
"""

from dataclasses import dataclass

import sympy as sp

from .. import quantities as n
from ..formulation import SPHERICAL, Formulation


@dataclass(frozen=True)
class Rotor:
    """mass: m_r; momentum: j_r; zero where there is no such term."""

    mass: sp.Expr
    momentum: sp.Expr


NONE = Rotor(sp.S.Zero, sp.S.Zero)
REFLECTED = Rotor(n.m_r.value, sp.S.Zero)
"""The mass alone."""
FULL = Rotor(n.m_r.value, n.j_r.value)


def rotor_of(form: Formulation) -> Rotor:
    """The rotors of a formulation's legs.

    Nothing determines the spin of a leg between two spherical joints, and so its rotor's angular momentum is
    not defined either: such a leg has the reflected mass alone.
    """
    if not form.drive:
        return NONE
    return REFLECTED if form.base_joint == SPHERICAL else FULL
