"""Actuator forces of legs with offset joints: the kernel ``exact_offset``."""

from collections.abc import Iterable
from dataclasses import replace
from functools import cache

import sympy as sp

from ..program.block import Block, Builder, Output, Quantity, rebuilt
from . import actuator_forces
from . import lumped_constants as p
from . import quantities as n
from .actuator_forces import ForceKernel
from .formulation import EXACT
from .legs import offset_joints as o
from .legs.joint_coordinates import friction_moment

LEVEL = "offset"
MEANING = "offset joints; also STEWART_NOT_FINITE if a leg with its offsets cannot reach its platform point"


@cache
def offset_kernel() -> ForceKernel:
    """Derive the blocks of the forces for offset universal joints and spherical platform joints."""
    lumped = p.Lumped(mass=True, friction=True)
    shared = actuator_forces.shared(friction=True)
    kernel = actuator_forces.with_constants(EXACT, True, shared, offset_leg(), lumped)
    kernel = actuator_forces.about_tip(kernel)
    prepared = prepare_leg(kernel.leg.inputs, lumped)
    return replace(kernel, prepare_leg=prepared, fidelity=LEVEL, meaning=MEANING)


def offset_leg() -> Block:
    """Derive the block of a leg with offsets."""
    build = Builder()
    leg = o.offset_frame(build)
    at = leg.at
    S_dot, S_ddot = p.tip_motion(build, at.q)
    rates, r_dot = o.offset_rates(build, leg, S_dot)
    accelerations = o.offset_accelerations(build, leg, rates, r_dot, S_ddot)
    forces = o.offset_forces(build, at, rates, accelerations)
    D, K = o.offset_tip_force(build, at, forces)
    moment = friction_moment(at, rates)
    meaning = "one leg with offset joints: D, its column of H and its part of c"
    return actuator_forces.closed_leg(
        build, meaning, at.q, leg.column, at.L, leg.sine, D, K, moment, o.PREPARED
    )


def prepare_leg(needed: Iterable[Quantity], lumped: p.Lumped) -> Block:
    """Prepare the constants in ``needed``, including the offsets and the body between the axes."""
    needed = tuple(needed)
    plain = p.prepare_leg(dict.fromkeys((*needed, p.h, p.w, p.J)), lumped)
    h, r_c, m_c = p.h.value, o.r_c.value, o.m_c.value
    d, a, e = o.d.value, o.a.value, o.e.value
    z = sp.Matrix([0, 0, 1])
    about_k = sp.Symbol("I_k", real=True)
    # Terms of the arm d z of the upper part's center of mass, and of the bodies that rotate about k only.
    added_J = d * (2 * h[2] * sp.eye(3) - z * h.T - h * z.T) + about_k * sp.diag(1, 0, 1)
    added_w = sp.Matrix([0, m_c * r_c[1], 0])
    more_of = dict(zip(p.J.names, (added_J[key] for key in p.J.keys), strict=True))
    more_of |= dict(zip(p.w.names, added_w, strict=True))
    more_of = {name: sp.expand(expr) for name, expr in more_of.items() if sp.expand(expr) != 0}
    own = {name: sp.Symbol(f"own_{name}", real=True) for name in more_of}
    renamed = {sp.Symbol(name, real=True): symbol for name, symbol in own.items()}
    steps = [
        replace(
            step,
            name=own[step.name].name if step.name in own else step.name,
            expr=step.expr.xreplace(renamed),
        )
        for step in plain.steps
    ]
    build = Builder(steps)
    build.scalar(
        "I_k",
        n.m_d.value * a**2 + o.I_c.value + m_c * (r_c[0] ** 2 + r_c[1] ** 2) + 2 * e * h[1],
        "",
        "inertia about k of the bodies that rotate about k only",
    )
    for name, expr in more_of.items():
        build.scalar(
            name, own[name] + expr, "", "with the terms of the offsets and of the body between the axes"
        )
    values: dict[Quantity, sp.Expr] = {
        o.a: a,
        o.e: e,
        o.d: d,
        o.d2: d**2,
        o.e2: e**2,
        o.a2: 2 * a,
        o.w_o: n.m_d.value * a + m_c * r_c[0],
    }
    outputs = [out for out in plain.outputs if out.quantity in needed or out.quantity in p.ADDED]
    more = [Output(q, (value,)) for q, value in values.items() if q in needed]
    of_leg = [out for out in outputs if out.quantity not in p.ADDED]
    added = [out for out in outputs if out.quantity in p.ADDED]
    return rebuilt(
        plain, build.steps, [*of_leg, *more, *added], (*plain.inputs, *o.RAW, *n.OF_LEG, n.p_1, n.g)
    )
