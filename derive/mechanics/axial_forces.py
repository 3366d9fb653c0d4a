"""Axial force between the parts of a leg: the motor force less the force that accelerates the rotor.

Efficiency and friction of a screw act on this axial force. The rotor requires m_r L_ddot + j_r A.s, (8), (9).
"""

import sympy as sp

from ..program.block import Block, Builder, Quantity
from . import quantities as n
from .formulation import Formulation
from .kinematics import L_dot
from .legs.leg import LegFrameMotion, leg_frame, leg_vector, platform_point_motion, rotation, sliding
from .legs.rotor import Rotor, rotor_of

F_rotor = Quantity("F_rotor", (), "N", "part of the actuator force that accelerates the leg's rotor")


def axial_block(form: Formulation, rotor: Rotor | None = None) -> Block:
    """Derive q, L, k3, L_dot, and F_rotor of one leg with a rotor.

    k3 is 1 if the block does not use the fixed axis.

    Parameters
    ----------
    form : Formulation
        Formulation with ``drive``.
    rotor : Rotor, optional
        Rotor terms that the forces contain. If None, all terms of the formulation.
    """
    build = Builder()
    rotor = rotor_of(form) if rotor is None else rotor
    q, _, L, inv_L, s = leg_vector(build)
    S_dot, S_ddot = platform_point_motion(build, q)
    if rotor.momentum == 0:
        k3 = sp.S.One
        rate, second = sliding(build, s, inv_L, S_dot, S_ddot)
        turned = rotor.mass * second
    else:
        T, k, inv_k3, kappa = leg_frame(build, s)
        k3 = k[2]
        none = sp.zeros(3, 1)
        u = build.vector("u", T.T * S_dot, "(4), (5)", "velocity of the platform point, leg frame")
        e = build.vector("e", T.T * S_ddot, "(7)", "acceleration of the platform point, leg frame")
        motion = LegFrameMotion(L, inv_L, k, inv_k3, kappa, u=u, e=e, gamma=none, w=none)
        rate, _, second, A = rotation(build, form, motion)
        turned = rotor.mass * second + rotor.momentum * A[0]
    return build.block(
        "axial_terms",
        "Length rate of one leg and the force that accelerates its rotor, (5), (8), (9)",
        (*n.OF_LEG, *n.MOTION),
        [(n.q, q), (n.L, L), (n.k3, k3), (L_dot, rate), (F_rotor, turned)],
    )
