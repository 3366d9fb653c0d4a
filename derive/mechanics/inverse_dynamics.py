"""Blocks of the complete inverse dynamics: the legs, the platform, and the joint reactions.

This module combines the solved equations of one leg with the equations of the platform. It converts results
from the leg frame to the base frame. Each formulation has three blocks: the leg's part, the platform's part,
and the joint reactions of one leg.
"""

from dataclasses import dataclass
from functools import cache

import sympy as sp

from ..program.block import Block, Builder
from . import quantities as n
from .formulation import SPHERICAL, UNIVERSAL, Formulation
from .legs.base_frame import Transverse, scalar_form, vector_form
from .legs.leg import (
    LegDynamics,
    LegFrameMotion,
    constants,
    leg_dynamics,
    leg_frame,
    leg_vector,
    platform_point_motion,
)
from .legs.rotor import rotor_of
from .platform import platform


@dataclass(frozen=True)
class Kernel:
    """Blocks of one formulation.

    Attributes
    ----------
    formulation : Formulation
        Formulation of the equations.
    friction : bool
        True if the joints have friction.
    leg : Block
        q, L, k3, D, K, column of H, and part of c of one leg.
    platform : Block
        Platform's part of c.
    reactions : Block
        Joint reactions of one leg from its axial force x.
    """

    formulation: Formulation
    friction: bool
    leg: Block
    platform: Block
    reactions: Block

    @property
    def blocks(self) -> tuple[Block, Block, Block]:
        """The three blocks."""
        return self.leg, self.platform, self.reactions


@dataclass(frozen=True)
class BaseFrameLeg:
    """Solution of one leg in the base frame, as expressions of the inputs.

    Attributes
    ----------
    q : Matrix, shape (3, 1)
        Platform point from the reference point (m).
    s : Matrix, shape (3, 1)
        Unit vector along the leg.
    L : Expr
        Leg length (m).
    k3 : Expr or None
        Sine of the angle between the leg and the fixed axis; None without a universal joint.
    D : Expr
        Known part of the actuator force (N).
    K : Matrix, shape (3, 1)
        Transverse force at the spherical joint (N).
    f : Matrix, shape (3, 1)
        Friction moment at the spherical joint (N m).
    reactions : dict
        Joint reactions by name.
    """

    q: sp.Matrix
    s: sp.Matrix
    L: sp.Expr
    k3: sp.Expr | None
    D: sp.Expr
    K: sp.Matrix
    f: sp.Matrix
    reactions: dict[str, sp.Expr | sp.Matrix]


@cache
def kernel(form: Formulation, friction: bool = True) -> Kernel:
    """Derive the blocks of a formulation; without friction, all friction constants are zero."""
    return Kernel(
        form,
        friction,
        leg=leg_block(form, friction),
        platform=platform()[0],
        reactions=reactions_block(form, friction),
    )


@cache
def leg_block(form: Formulation, friction: bool) -> Block:
    """Derive one leg's part of the inverse dynamics, (1)-(24), and its terms in (35)."""
    build = Builder()
    leg = base_frame_leg(build, form, friction, with_reactions=False)
    share = platform()[1]
    values: dict[sp.Symbol, sp.Expr] = {}
    for quantity, value in ((n.s, leg.s), (n.q, leg.q), (n.K, leg.K), (n.f, leg.f)):
        values.update(zip(quantity.symbols, value, strict=True))
    column, wrench = share.column.xreplace(values), share.wrench.xreplace(values)
    outputs = [
        (n.q, leg.q),
        (n.L, leg.L),
        *([] if leg.k3 is None else [(n.k3, leg.k3)]),
        (n.D, leg.D),
        (n.K, leg.K),
        (n.H_force, column[:3, :]),
        (n.H_moment, column[3:, :]),
        (n.c_force, wrench[:3, :]),
        (n.c_moment, wrench[3:, :]),
    ]
    return build.block(
        "leg_dynamics",
        "one leg: D, K, its column of H and its part of c, (1)-(24), (35)",
        (*n.OF_LEG, n.g, *n.MOTION),
        outputs,
    )


def reactions_block(form: Formulation, friction: bool) -> Block:
    """Derive the joint reactions of one leg from its axial force x: (21), (26)-(29), and M_p of (17)."""
    build = Builder()
    reactions = base_frame_leg(build, form, friction, with_reactions=True).reactions
    quantities = (n.F_s, n.F_u, n.F_p, n.F_c, n.M_p, n.M_u)
    return build.block(
        "leg_reactions",
        "one leg: joint reactions, (21), (26)-(29), (17)",
        (*n.OF_LEG, n.g, *n.MOTION, n.x, n.bearing),
        [(quantity, reactions[quantity.name]) for quantity in quantities],
    )


def base_frame_leg(build: Builder, form: Formulation, friction: bool, with_reactions: bool) -> BaseFrameLeg:
    """Solve the equations of one leg with the base joint of the formulation."""
    solve = {UNIVERSAL: _universal_leg, SPHERICAL: _spherical_leg}[form.base_joint]
    return solve(build, form, friction, with_reactions)


def _universal_leg(build: Builder, form: Formulation, friction: bool, with_reactions: bool) -> BaseFrameLeg:
    q, _, L, inv_L, s = leg_vector(build)
    S_dot, S_ddot = platform_point_motion(build, q)
    T, k, inv_k3, kappa = leg_frame(build, s)
    motion = LegFrameMotion(
        L,
        inv_L,
        k,
        inv_k3,
        kappa,
        u=build.vector(
            "u", T.T * S_dot, "(4), (5)", "velocity of the platform point, leg frame; u_x is L_dot"
        ),
        e=build.vector("e", T.T * S_ddot, "(7)", "acceleration of the platform point, leg frame"),
        gamma=build.vector("gamma", T.T * n.g.value, "", "gravity, leg frame"),
        w=build.vector("w", T.T * n.omega.value, "", "angular velocity of the platform, leg frame"),
    )
    leg = leg_dynamics(build, form, constants(friction, rotor=rotor_of(form)), motion, with_reactions)
    return BaseFrameLeg(
        q,
        s,
        L,
        k[2],
        leg.D,
        K=build.vector("K", T * leg.K, "(21)", "transverse force at the spherical joint, base frame"),
        f=build.vector("f", T * leg.f, "(18)", "friction moment at the spherical joint, base frame"),
        reactions=_named_reactions(build, T, leg) if with_reactions else {},
    )


def _named_reactions(build: Builder, T: sp.Matrix, leg: LegDynamics) -> dict[str, sp.Expr | sp.Matrix]:
    placed = {}
    for name, value in leg.reactions.items():
        if isinstance(value, sp.MatrixBase):
            local = build.vector(f"{name}_leg", value, "", f"{name}, leg frame")
            placed[name] = T * local
        else:
            placed[name] = value
    return placed


_PAIRS = {name: sp.symbols(f"{name}_y {name}_z", real=True) for name in ("e", "u", "gamma", "w")}


def _spherical_leg(build: Builder, form: Formulation, friction: bool, with_reactions: bool) -> BaseFrameLeg:
    q, _, L, inv_L, s = leg_vector(build)
    S_dot, S_ddot = platform_point_motion(build, q)
    base = {"e": S_ddot, "u": S_dot, "gamma": n.g.value, "w": n.omega.value}
    axial = {
        name: build.scalar(f"{name}_x", s.dot(vector), "", f"part of {name} along the leg")
        for name, vector in base.items()
    }
    across = {name: _across(build, name, vector, axial[name], s) for name, vector in base.items()}
    u_across = across["u"]
    square = build.scalar("u_square", u_across.base.dot(u_across.base), "", "square of u across the leg")

    motion = LegFrameMotion(
        L,
        inv_L,
        k=sp.zeros(3, 1),
        inv_k3=sp.S.Zero,
        kappa=sp.S.Zero,
        **{name: sp.Matrix([axial[name], *_PAIRS[name]]) for name in base},
    )
    inner = Builder()
    of_leg = constants(friction, axisymmetric=True, rotor=rotor_of(form))
    leg = leg_dynamics(inner, form, of_leg, motion, with_reactions)
    back = inner.substitution()

    def base_vector(name: str, local: sp.Matrix) -> sp.Matrix:
        local = local.xreplace(back)
        along = scalar_form(local[0], u_across, square) * s
        turned = vector_form(build, name, sp.Matrix(local[1:]), tuple(across.values()), s)
        return build.vector(name, along + turned, "", f"{name}, base frame")

    D = scalar_form(leg.D.xreplace(back), u_across, square)
    return BaseFrameLeg(
        q,
        s,
        L,
        None,
        D=build.scalar("D", D, "(24)", "known part of the actuator force"),
        K=base_vector("K", leg.K),
        f=base_vector("f", leg.f),
        reactions={
            name: base_vector(name, value) if isinstance(value, sp.MatrixBase) else value
            for name, value in leg.reactions.items()
        }
        if with_reactions
        else {},
    )


def _across(build: Builder, name: str, vector: sp.Matrix, along: sp.Expr, s: sp.Matrix) -> Transverse:
    y, z = _PAIRS[name]
    base = build.vector(f"{name}_across", vector - along * s, "", f"part of {name} across the leg")
    return Transverse(name, y, z, base)
