"""Fidelity levels of the force kernels as reductions of one derivation.

Constants that a simpler leg does not have become zero, and their terms vanish. A leg without axial inertia
and friction does not need a leg frame. A quasi-static level has neither velocities nor accelerations.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache

import sympy as sp

from ..program.block import Block, Builder, Quantity, Step, rebuilt
from ..program.cse import specialized
from . import actuator_forces
from . import lumped_constants as p
from . import quantities as n
from .actuator_forces import ForceKernel
from .formulation import EXACT, EXACT_DRIVE, Formulation
from .legs.leg import cross, leg_vector
from .legs.rotor import FULL, NONE, REFLECTED, Rotor

GENERAL = "general"
AXISYMMETRIC = "axisymmetric"
SLENDER = "slender"
POINT_MASSES = "point_masses"
MASSLESS = "massless"


@dataclass(frozen=True)
class Fidelity:
    """One fidelity level.

    Attributes
    ----------
    name, meaning : str
        Name, and description.
    legs : str
        Model of the legs. ``general``: all inertia. ``axisymmetric``: centers of mass on the axis and equal
        transverse inertias. ``slender``: additionally no inertia about the axis. ``point_masses``: only the
        inertia of the masses as points. ``massless``: no mass.
    friction : bool
        True for friction of all joints.
    moving : bool
        False for zero velocities and accelerations.
    rotor : Rotor
        Rotors of the legs' drives.
    """

    name: str
    legs: str
    friction: bool
    moving: bool
    meaning: str
    rotor: Rotor = NONE


FIDELITIES = {
    level.name: level
    for level in (
        Fidelity("general", GENERAL, True, True, "everything"),
        Fidelity("frictionless", GENERAL, False, True, "no friction"),
        Fidelity("axisymmetric_friction", AXISYMMETRIC, True, True, "axisymmetric legs, with friction"),
        Fidelity("axisymmetric", AXISYMMETRIC, False, True, "axisymmetric legs"),
        Fidelity("slender_friction", SLENDER, True, True, "no inertia about the leg's axis, with friction"),
        Fidelity("slender", SLENDER, False, True, "no inertia about the leg's axis"),
        Fidelity(
            "point_masses_friction", POINT_MASSES, True, True, "parts of the legs as points, with friction"
        ),
        Fidelity("point_masses", POINT_MASSES, False, True, "parts of the legs as points"),
        Fidelity("massless_friction", MASSLESS, True, True, "legs without mass, with friction"),
        Fidelity("massless", MASSLESS, False, True, "legs without mass, equation (41) of the paper"),
        Fidelity("general_static", GENERAL, False, False, "at rest"),
        Fidelity("slender_static", SLENDER, False, False, "at rest, centers of mass on the legs' axes"),
        Fidelity("massless_static", MASSLESS, False, False, "at rest, legs without mass"),
    )
}
"""Levels by name. At rest, axisymmetric legs and point masses have the same forces as slender legs."""

_SLENDER_LEGS = "reflected masses, no inertia about the leg's axis"
_MASSLESS_LEGS = "reflected masses, legs without mass of their own"

DRIVE_FIDELITIES = {
    name: Fidelity(name, legs, friction, True, meaning, rotor)
    for name, legs, friction, meaning, rotor in (
        ("general", GENERAL, True, "everything, rotors included", FULL),
        ("reflected", GENERAL, True, "rotors as masses that move with the lengths", REFLECTED),
        ("reflected_slender_friction", SLENDER, True, f"{_SLENDER_LEGS}, with friction", REFLECTED),
        ("reflected_slender", SLENDER, False, _SLENDER_LEGS, REFLECTED),
        ("reflected_massless_friction", MASSLESS, True, f"{_MASSLESS_LEGS}, with friction", REFLECTED),
        ("reflected_massless", MASSLESS, False, _MASSLESS_LEGS, REFLECTED),
    )
}
"""Additional levels of legs with rotors. The levels of ``FIDELITIES`` omit the rotors."""

NO_ROTOR = "no_rotor"
"""Name of the level ``general`` of ``FIDELITIES`` for legs with rotors: everything except the rotors."""


def level_of(name: str, rotors: bool) -> Fidelity:
    """Return the level of a name, for a robot with or without rotors.

    Raises
    ------
    KeyError
        If there is no such level.
    """
    if not rotors:
        return FIDELITIES[name]
    return DRIVE_FIDELITIES.get(name) or FIDELITIES[GENERAL if name == NO_ROTOR else name]


_ZERO = sp.S.Zero


@cache
def fidelity_kernel(form: Formulation, level: Fidelity) -> ForceKernel:
    """Derive the blocks of one level, before common subexpressions are eliminated.

    Raises
    ------
    ValueError
        If a level below ``frictionless`` is requested for a formulation other than EXACT.
    """
    if level.legs == GENERAL and level.moving and level.rotor == (FULL if form.drive else NONE):
        return replace(
            actuator_forces.force_kernel(form, level.friction), fidelity=level.name, meaning=level.meaning
        )
    if form != (EXACT if level.rotor == NONE else EXACT_DRIVE):
        raise ValueError(f"fidelity: {level.name} is a reduction of exact, not of {form.kernel_name}")
    lumped = p.Lumped(mass=level.legs != MASSLESS, friction=level.friction)
    kernel = actuator_forces.with_constants(form, level.friction, _platform(level), _leg(level), lumped)
    near = _leg(level, near_singular=True) if n.k in kernel.leg.inputs else None
    kernel = actuator_forces.about_tip(replace(kernel, leg_near_singular=near))
    if not level.moving:
        kernel = kernel.changed(lambda block: _without_signs(_weighed(specialized(block, _AT_REST))))
    kernel = actuator_forces.without_zeros(kernel)
    final = actuator_forces.with_constants(form, level.friction, kernel.shared, kernel.leg, lumped)
    return replace(
        final,
        leg_near_singular=kernel.leg_near_singular,
        about_tip=True,
        fidelity=level.name,
        meaning=level.meaning,
    )


_AT_REST: Mapping[sp.Symbol, sp.Expr] = {
    symbol: _ZERO for quantity in (n.omega, n.v, n.alpha, n.a, p.B) for symbol in quantity.symbols
}


def _weighed(block: Block) -> Block:
    """Replace M_P g by the prepared weight of the platform."""
    weight = dict(zip(p.M_P.value * n.g.value, p.W_P.symbols, strict=True))
    steps = [replace(step, expr=step.expr.xreplace(weight)) for step in block.steps]
    outputs = [replace(out, exprs=tuple(e.xreplace(weight) for e in out.exprs)) for out in block.outputs]
    return rebuilt(block, steps, outputs, (*block.inputs, p.W_P))


def _without_signs(block: Block) -> Block:
    """Store the negative of each negative product whose readers all need the negative."""
    results = [expr for out in block.outputs for expr in out.exprs]
    negatives: dict[sp.Symbol, sp.Expr] = {}
    steps: list[Step] = []
    for step in block.steps:
        expr = step.expr.xreplace(negatives)
        readers = [*results, *(other.expr for other in block.steps)]
        terms = [term for each in readers for term in sp.Add.make_args(each) if term.has(step.symbol)]
        if expr.is_Mul and all(each.could_extract_minus_sign() for each in (expr, *terms)):
            named = replace(step, name=f"minus_{step.name}", meaning=f"the negative of the {step.meaning}")
            negatives[step.symbol] = -named.symbol
            step, expr = named, -expr
        steps.append(replace(step, expr=expr))
    outputs = [replace(out, exprs=tuple(e.xreplace(negatives) for e in out.exprs)) for out in block.outputs]
    return rebuilt(block, steps, outputs, block.inputs)


def _platform(level: Fidelity) -> Block:
    if level.legs == MASSLESS and level.moving and level.rotor == NONE:
        return _platform_alone(level.friction)
    return actuator_forces.shared(level.friction)


def _leg(level: Fidelity, near_singular: bool = False) -> Block:
    if level.legs == GENERAL:
        return actuator_forces.joint_leg(level.friction, near_singular, level.rotor)
    if level.legs == AXISYMMETRIC or level.friction:
        leg = actuator_forces.joint_leg(level.friction, near_singular, level.rotor)
        return specialized(leg, _constants(level.legs), p.LEG)
    return _leg_on_axis(level)


def _across(legs: str) -> sp.Expr:
    """Return the transverse inertia of a leg's parts about base and platform point."""
    return {MASSLESS: _ZERO, POINT_MASSES: p.J_m.value}.get(legs, p.J_t.value)


def _constants(legs: str) -> dict[sp.Symbol, sp.Expr]:
    """Return the constants of the general leg for a simpler leg."""
    heavy = legs != MASSLESS
    axial = p.J_s.value if legs == AXISYMMETRIC else _ZERO
    across = _across(legs)
    slope = p.J_ts.value if legs == AXISYMMETRIC else across
    vectors = {p.h: p.h_s.value, p.w: p.w_s.value}
    zeros = (*p.h.symbols, *p.w.symbols, *p.J.symbols, *p.h2_y.symbols, *p.h2_z.symbols, *p.J2_xz.symbols)
    values: dict[sp.Symbol, sp.Expr] = dict.fromkeys(zeros, _ZERO)
    values |= {vector.symbols[0]: along if heavy else _ZERO for vector, along in vectors.items()}
    values[p.h2_x.value] = 2 * p.h_s.value if heavy else _ZERO
    values[p.dJ_zx.value] = slope
    return values | {p.J.value[0, 0]: axial, p.J.value[1, 1]: across, p.J.value[2, 2]: across}


def _leg_on_axis(level: Fidelity) -> Block:
    """Derive a leg without friction and axial inertia, which has no leg frame and no universal axis."""
    build = Builder()
    q, _, L, inv_L, s = leg_vector(build)
    S_dot, S_ddot = p.tip_motion(build, q)
    D, K = _ZERO, sp.zeros(3, 1)
    mass = level.rotor.mass
    if level.legs != MASSLESS:
        meaning = "one slender leg: D, its column of H and its part of c"
        D, K = slender_force(build, s, L, inv_L, S_dot, S_ddot, _across(level.legs), mass)
    elif level.rotor == NONE:
        meaning = "one massless leg: its column of H"
    else:
        meaning = "one massless leg with a reflected mass: D and its column of H"
        L_dot = build.scalar("L_dot", s.dot(S_dot), "(5)", "rate of the length")
        turned = build.scalar("turned", (S_dot.dot(S_dot) - L_dot**2) * inv_L, "(8)", "L |s_dot|^2")
        D = build.scalar("D", mass * (s.dot(S_ddot) + turned), "(24)", "force that accelerates the rotor")
    return actuator_forces.closed_leg(build, meaning, q, s, L, None, D, K, sp.zeros(3, 1))


def slender_force(
    build: Builder,
    s: sp.Matrix,
    L: sp.Expr,
    inv_L: sp.Expr,
    S_dot: sp.Matrix,
    S_ddot: sp.Matrix,
    inertia: sp.Expr,
    reflected: sp.Expr,
) -> tuple[sp.Expr, sp.Matrix]:
    """Name D and K of a slender leg, (21), (24), base frame; K has a component along s.

    With the upper part's mass on the platform, the kinetic energy of the leg is only (inertia + 2 L h)
    |s_dot|^2 / 2.

    Parameters
    ----------
    inertia : Expr
        Transverse inertia of both parts about base and platform point (kg m^2).
    reflected : Expr
        Reflected mass of a rotor, which moves with L (kg); zero without a rotor.
    """
    h = p.h_s.value
    inv_L2 = build.scalar("inv_L2", inv_L**2)
    L_dot = build.scalar("L_dot", s.dot(S_dot), "(5)", "rate of the length")
    meaning = "K = K_a S_ddot + K_v S_dot - K_g g, with a component along s"
    K_a = build.scalar("K_a", (inertia + 2 * L * h) * inv_L2, "(21)", meaning)
    L_share = build.scalar("L_share", 2 * inv_L * L_dot, "", "2 L_dot / L")
    K_v = build.scalar("K_v", L_share * (h * inv_L - K_a), "(21)", meaning)
    K_g = build.scalar("K_g", p.w_s.value * inv_L, "(21)", meaning)
    force = K_a * S_ddot + K_v * S_dot - K_g * n.g.value
    K = build.vector("K", force, "(21)", "force at the spherical joint, base frame")
    turning = build.scalar("turning", (S_dot.dot(S_dot) - L_dot**2) * inv_L2, "(6)", "|s_dot|^2")
    D = -h * turning - s.dot(K)
    if reflected != 0:
        D += reflected * (s.dot(S_ddot) + L * turning)
    return build.scalar("D", D, "(24)", "known part of the actuator force for this K"), K


def _platform_alone(friction: bool) -> Block:
    """Derive the platform's part of c in the platform frame for legs that do not need B, (30)-(35)."""
    build = Builder()
    R = n.R.value
    meaning = "in the platform frame"
    omega = build.vector("omega_P", R.T * n.omega.value, "", "angular velocity, platform frame")
    alpha = build.vector("alpha_P", R.T * n.alpha.value, "", "angular acceleration, platform frame")
    fall = build.vector("fall", n.g.value - n.a.value, "(33)", "g - a")
    fall_P = build.vector("fall_P", R.T * fall, "(33)", f"g - a {meaning}")
    turn = actuator_forces.rotary(build, omega, alpha)
    center = p.r_C.value
    N = build.vector("N_P", p.M_P.value * (fall_P - turn * center), "(33)", f"M_P (g - a_C) {meaning}")
    load = build.vector("F_P_load", n.F_ext.value + N, "(33)", f"external force less inertia, {meaning}")
    torque = build.vector(
        "M_P_load",
        n.M_ext.value
        - actuator_forces.euler(build, p.J_C.value, p.dJ_C.value, omega, alpha, turn)
        + cross(center, N),
        "(34)",
        f"external moment less I alpha + omega x I omega, {meaning}",
    )
    moment = R * torque
    if friction:
        moment -= p.C_P.value * n.omega.value
    outputs: list[tuple[Quantity, sp.Matrix]] = [(n.c_force, R * load), (n.c_moment, moment)]
    return build.block(
        "shared_terms",
        "the platform's part of c, (30)-(35)",
        (*n.MOTION, p.M_P, p.r_C, p.J_C, p.dJ_C, p.C_P, n.g),
        outputs,
    )
