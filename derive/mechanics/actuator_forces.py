"""The actuator forces alone, regrouped to fewer operations.

Each change leaves the forces as they are:

- what the pose has for all legs is computed once: B with S_ddot = B q + a, and the platform's part of c;
- constants that enter together are prepared once per robot (``lumped_constants``), and the mass of an upper
  part is lumped with the platform as a point at the spherical joint;
- ``exact`` legs are written in the coordinates of their joints (``joint_coordinates``), `paper` legs in their
  frame (``printed``); legs with spherical base joints stay as ``inverse_dynamics`` has them;
- the force K on the leg may carry any part along s, since x takes up the rest: F = D - x with D to match;
- the platform's inertia is about the center of mass of all that it moves, so that a reference point far away
  costs no digits;
- moments are taken about platform point 1, so that leg 1 has none, elimination begins with three rows, and
  no moment is larger than the platform, however long the legs are.

``passes`` shows what each is worth.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cache

import sympy as sp

from ..program.block import Block, Builder, Output, Quantity, Step, component_name, rebuilt
from . import lumped_constants as p
from . import quantities as n
from .formulation import SPHERICAL, Formulation
from .inverse_dynamics import leg_block
from .legs.joint_coordinates import (
    friction_moment,
    joint_accelerations,
    joint_forces,
    joint_frame,
    joint_rates,
    tip_force,
)
from .legs.leg import cross, skew
from .legs.printed import printed_leg
from .legs.rotor import NONE, Rotor, rotor_of
from .platform import platform


@dataclass(frozen=True)
class ForceKernel:
    """The blocks from which the actuator forces are computed.

    prepare_leg, prepare_platform: constants, once per robot. shared: what is computed once per pose for all
    legs, with the platform's part of c. leg: D, a column of H and a part of c of one leg; leg_near_singular:
    the same, for poses in which a leg is near its joint singularity. about_tip: whether moments are about
    platform point 1: then ``moments`` and ``shift`` compute them, and a leg's block computes no moment but
    that of friction; otherwise moments are about the reference point, and a leg's block computes them.
    Of a baked kernel alone: constants, the values of each, one for all legs or six; size, m, the largest
    coordinate of the arms of its moments; extent, m, the largest sum of the absolute coordinates of a base or
    platform point.
    """

    formulation: Formulation
    friction: bool
    prepare_leg: Block
    prepare_platform: Block
    shared: Block
    leg: Block
    leg_near_singular: Block | None = None
    about_tip: bool = False
    fidelity: str = "general"
    meaning: str = ""
    constants: Mapping[Quantity, tuple[float, ...]] | None = None
    baked_name: str = ""
    size: float = 0.0
    extent: float = 0.0

    @property
    def name(self) -> str:
        """Name of the emitted kernel: ``exact``, ``paper``, ``exact_slender``."""
        if self.baked_name:
            return self.baked_name
        own = self.formulation.kernel_name
        return own if self.fidelity == "general" else f"{own}_{self.fidelity}"

    @property
    def moments(self) -> Block:
        """Moments about platform point 1 of one leg, of all but leg 1."""
        return leg_moments(n.c_force in self.leg.made)

    @property
    def shift(self) -> Block:
        """The platform's part of c with moments about platform point 1."""
        return platform_moments()

    def whole(self) -> "ForceKernel":
        """The kernel with ``moments`` and ``shift`` in the blocks of legs and pose: the same operations.

        Leg 1 then has moments like any other, all of them zero, and the pose has q_1 from p_1, a constant.
        """
        turned = zip(p.q_1.names, n.R.value * n.p_1.value, strict=True)
        tip = [Step(name, expr, "(1)", p.q_1.meaning) for name, expr in turned]
        pose = joined(self.shared, self.shift, tip, (n.R, n.p_1))
        pose = replace(pose, outputs=(*pose.outputs, Output(p.q_1, p.q_1.symbols)))
        near = None if self.leg_near_singular is None else joined(self.leg_near_singular, self.moments)
        before = self.prepare_platform
        inputs = tuple(dict.fromkeys((*before.inputs, n.p_1)))
        given = replace(before, inputs=inputs, outputs=(*before.outputs, Output(n.p_1, n.p_1.symbols)))
        leg = joined(self.leg, self.moments)
        return replace(
            self, shared=pose, leg=leg, leg_near_singular=near, prepare_platform=given, about_tip=False
        )

    def literals(self) -> dict[Quantity, float]:
        """Constants of a baked kernel that all legs share."""
        return {q: values[0] for q, values in (self.constants or {}).items() if len(values) == 1}

    def used_motion(self) -> tuple[Quantity, ...]:
        """What of the motion the forces depend on; R and t always, since they place the legs."""
        used = {*self.shared.inputs, *self.leg.inputs, n.R, n.t}
        return tuple(q for q in n.MOTION if q in used)

    def changed(self, change: Callable[[Block], Block]) -> "ForceKernel":
        """The kernel with the blocks of a pose changed, its own and those of the legs."""
        near = None if self.leg_near_singular is None else change(self.leg_near_singular)
        return replace(self, shared=change(self.shared), leg=change(self.leg), leg_near_singular=near)

    def blocks(self) -> tuple[Block, ...]:
        """The blocks of a pose: its own and those of the legs."""
        return self.shared, self.leg, *(() if self.leg_near_singular is None else (self.leg_near_singular,))

    def leg_constants(self) -> tuple[Quantity, ...]:
        """Constants of each leg in the prepared model."""
        if self.constants is not None:
            return tuple(q for q, values in self.constants.items() if len(values) > 1)
        return tuple(q for q in self.prepare_leg.made if q not in p.ADDED)

    def more_of_legs(self) -> tuple[Quantity, ...]:
        """What is prepared of each leg beside ``quantities.OF_LEG``."""
        known = (*n.OF_LEG, *n.PLATFORM, n.p_1)
        return tuple(q for q in self.prepare_leg.inputs if q not in known)

    def platform_constants(self) -> tuple[Quantity, ...]:
        """Constants of the platform in the prepared model."""
        if self.constants is not None:
            return ()
        return self.prepare_platform.made


@cache
def force_kernel(form: Formulation, friction: bool = True) -> ForceKernel:
    """Derive the regrouped blocks of a formulation."""
    return about_tip(regrouped(form, friction))


def elimination_kernel(form: Formulation, friction: bool = True) -> ForceKernel:
    """The blocks of ``inverse_dynamics`` as they are, without what the forces do not need."""
    return with_constants(form, friction, platform()[0], _plain_leg(form, friction), p.NOTHING_LUMPED)


def with_shared_pose(form: Formulation, friction: bool = True) -> ForceKernel:
    """The legs of ``inverse_dynamics`` with S_ddot = B q + a, and the platform's part of c regrouped."""
    leg = _plain_leg(form, friction)
    ready = dict(zip(("S_ddot_x", "S_ddot_y", "S_ddot_z"), p.B.value * n.q.value + n.a.value, strict=True))
    steps = [replace(step, expr=ready.get(step.name, step.expr)) for step in leg.steps]
    leg = rebuilt(leg, steps, list(leg.outputs), (*leg.inputs, p.B))
    return with_constants(form, friction, shared(friction=False), leg, p.NOTHING_LUMPED)


def regrouped(form: Formulation, friction: bool = True) -> ForceKernel:
    """All constants regrouped, moments about the reference point."""
    if form.base_joint == SPHERICAL:
        return with_shared_pose(form, friction)
    lumped = p.Lumped(mass=True, friction=friction)
    if form.no_spin:
        leg, near = (_printed_leg(form, friction, near_singular) for near_singular in (False, True))
    else:
        leg, near = (joint_leg(friction, near_singular, rotor_of(form)) for near_singular in (False, True))
    return replace(with_constants(form, friction, shared(friction), leg, lumped), leg_near_singular=near)


def with_constants(
    form: Formulation, friction: bool, pose: Block, leg: Block, lumped: p.Lumped
) -> ForceKernel:
    """The kernel with the constants that its blocks read; ``lumped`` as in ``prepare_leg``."""
    return ForceKernel(
        form,
        friction,
        p.prepare_leg(leg.inputs, lumped),
        p.prepare_platform(dict.fromkeys((*pose.inputs, *(q for q in leg.inputs if q == n.g)))),
        pose,
        leg,
    )


def with_numbers(kernel: ForceKernel, numbers: Iterable[Quantity]) -> ForceKernel:
    """The kernel with these numbers of the robot in its prepared model as well."""
    numbers = tuple(numbers)
    of_leg, of_platform = (
        dict.fromkeys((*block.made, *numbers)) for block in (kernel.prepare_leg, kernel.prepare_platform)
    )
    return replace(
        kernel,
        prepare_leg=p.prepare_leg(of_leg, p.lumped(kernel.prepare_leg)),
        prepare_platform=p.prepare_platform(of_platform),
    )


def without_zeros(kernel: ForceKernel) -> ForceKernel:
    """The kernel without outputs that are zero; a leg keeps what it has on either code path."""
    legs = [leg for leg in (kernel.leg, kernel.leg_near_singular) if leg is not None]
    of_legs = {
        n.H_force,
        n.H_moment,
        *(out.quantity for leg in legs for out in leg.outputs if _is_not_zero(out)),
    }

    def change(block: Block) -> Block:
        outputs = [
            out for out in block.outputs if (out.quantity in of_legs if block in legs else _is_not_zero(out))
        ]
        return rebuilt(block, block.steps, outputs, block.inputs)

    return kernel.changed(change)


def _is_not_zero(out: Output) -> bool:
    return any(expr != 0 for expr in out.exprs)


# ---------------------------------------------------------------- moments about platform point 1


def about_tip(kernel: ForceKernel) -> ForceKernel:
    """The same kernel with moments about platform point 1, and S = q + (t - b)."""
    leg = _leg_without_moments(kernel.leg)
    lumped = p.lumped(kernel.prepare_leg)
    moved = with_constants(kernel.formulation, kernel.friction, kernel.shared, leg, lumped)
    near = None if kernel.leg_near_singular is None else _leg_without_moments(kernel.leg_near_singular)
    return replace(moved, leg_near_singular=near, about_tip=True, fidelity=kernel.fidelity)


def from_difference(leg: Block) -> Block:
    """The leg with S = q + (t - b): the error of t - b is as small as t - b itself."""
    steps: list[Step] = []
    for step in leg.steps:
        if step.name == "S_x":
            steps += [
                Step(name, t - b, "(1)", p.t_b.meaning)
                for name, t, b in zip(p.t_b.names, n.t.symbols, n.b.symbols, strict=True)
            ]
        if step.name in ("S_x", "S_y", "S_z"):
            tip, base = (sp.Symbol(f"{name}_{step.name[-1]}", real=True) for name in ("q", "t_b"))
            step = replace(step, expr=tip + base)
        steps.append(step)
    return rebuilt(leg, steps, list(leg.outputs), leg.inputs)


def _leg_without_moments(leg: Block) -> Block:
    """The leg with q, and of the moments nothing but friction."""
    moved = from_difference(leg)
    given = moved.exprs
    force = sp.Matrix(given[n.c_force])
    friction = sp.Matrix(given[n.c_moment]) - cross(n.q.value, force)
    outputs: list[Output] = []
    for quantity, exprs in given.items():
        if quantity == n.c_moment:
            exprs = tuple(friction.applyfunc(sp.expand))
        if quantity != n.H_moment and (quantity != n.c_moment or any(e != 0 for e in exprs)):
            outputs.append(Output(quantity, exprs))
    return rebuilt(moved, list(moved.steps), outputs, moved.inputs)


@cache
def leg_moments(with_force: bool) -> Block:
    """Moments about platform point 1 of a leg but the first; with_force: of its part of c as well."""
    build = Builder()
    arm = build.vector("arm", n.q.value - p.q_1.value, "", "platform point from platform point 1")
    outputs = [(n.H_moment, cross(arm, n.H_force.value))]
    if with_force:
        outputs.append((p.arm_c, cross(arm, n.c_force.value)))
    return build.block("moments_of", "moments of one leg", (n.q, p.q_1, n.H_force, n.c_force), outputs)


@cache
def platform_moments() -> Block:
    """The platform's part of c moved from the reference point to platform point 1."""
    moved = n.c_moment.value - cross(p.q_1.value, n.c_force.value)
    inputs = (p.q_1, n.c_force, n.c_moment)
    return Builder().block("shift", "the platform's part of c", inputs, [(p.c_tip, moved)])


def joined(
    first: Block, second: Block, between: Iterable[Step] = (), inputs: Iterable[Quantity] = ()
) -> Block:
    """Two blocks as one; what the second reads of the first keeps its name, and so the order of its sums."""
    read = {out.quantity: out for out in first.outputs if out.quantity in second.inputs}
    renamed = [
        Step(name, expr)
        for out in read.values()
        for name, symbol, expr in zip(out.quantity.names, out.quantity.symbols, out.exprs, strict=True)
        if symbol != expr
    ]
    steps = (*first.steps, *renamed, *between, *second.steps)
    outputs = [
        Output(out.quantity, out.quantity.symbols) if out.quantity in read else out for out in first.outputs
    ]
    given = [q for q in second.inputs if q not in read]
    named = {step.name for step in steps}
    needed = [q for q in (*first.inputs, *given, *inputs) if not named.intersection(q.names)]
    return replace(
        first, inputs=tuple(dict.fromkeys(needed)), steps=steps, outputs=(*outputs, *second.outputs)
    )


# ---------------------------------------------------------------- pose and platform


def rotary(build: Builder, omega: sp.Matrix, alpha: sp.Matrix) -> sp.Matrix:
    """B = [alpha]x + [omega]x [omega]x, named entry by entry."""
    square = build.tensor("omega", omega * omega.T, "", "products of omega")
    turn = skew(alpha) + square - square.trace() * sp.eye(3)
    return build.matrix("B", turn, "(7)", "S_ddot = B q + a")


def euler(
    build: Builder,
    inertia: sp.Matrix,
    d: sp.Matrix,
    omega: sp.Matrix,
    alpha: sp.Matrix,
    turn: sp.Matrix | None = None,
) -> sp.Matrix:
    """I alpha + omega x I omega, with the products of omega shared and the differences d prepared.

    turn: ``rotary`` of the same omega and alpha, where there is one to take sums from.
    """
    square = {
        (i, j): build.scalar(component_name("P", (i, j)), omega[i] * omega[j])
        for i, j in ((0, 1), (0, 2), (1, 2), (0, 0), (1, 1), (2, 2))
    }
    product = sp.Matrix(3, 3, lambda i, j: square[min(i, j), max(i, j)])
    turn = product + skew(alpha) if turn is None else turn
    return sp.Matrix(
        [
            inertia[i, i] * alpha[i]
            - inertia[i, j] * turn[k, i]
            + inertia[i, k] * turn[j, i]
            + d[i] * product[j, k]
            + inertia[j, k] * (product[j, j] - product[k, k])
            for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
        ]
    )


def shared(friction: bool) -> Block:
    """What a pose has for all legs: B, and the platform's part of c, (30)-(35).

    friction: whether the platform's part of the spherical joints' friction is in it.
    """
    build = Builder()
    R, omega, alpha = n.R.value, n.omega.value, n.alpha.value
    turn = rotary(build, omega, alpha)
    R_C = build.vector("R_C", R * p.r_C.value, "(30)", "center of mass from the reference point, base frame")
    N = build.vector("N", p.M_P.value * (n.g.value - n.a.value - turn * R_C), "(33)", "M_P (g - a_C)")
    force = R * n.F_ext.value + N
    omega_P = build.vector("omega_P", R.T * omega, "", "angular velocity, platform frame")
    alpha_P = build.vector("alpha_P", R.T * alpha, "", "angular acceleration, platform frame")
    load = build.vector(
        "M_P_load",
        n.M_ext.value - euler(build, p.J_C.value, p.dJ_C.value, omega_P, alpha_P),
        "(34)",
        "external moment less I alpha + omega x I omega, platform frame",
    )
    moment = cross(R_C, N) + R * load
    if friction:
        moment -= p.C_P.value * omega
    return build.block(
        "shared_terms",
        "B and the platform's part of c, (7), (30)-(35)",
        (*n.MOTION, p.M_P, p.r_C, p.J_C, p.dJ_C, p.C_P, n.g),
        [(p.B, turn), (n.c_force, force), (n.c_moment, moment)],
    )


# ---------------------------------------------------------------- legs


def closed_leg(
    build: Builder,
    meaning: str,
    q: sp.Matrix,
    s: sp.Matrix,
    L: sp.Expr,
    k3: sp.Expr | None,
    D: sp.Expr,
    K: sp.Matrix,
    f: sp.Matrix,
    more: Iterable[Quantity] = (),
) -> Block:
    """The leg's block, moments about the reference point; k3 None where there is no universal joint.

    more: constants of the leg beside ``quantities.LEG`` and ``lumped_constants.LEG``.
    """
    joint = [] if k3 is None else [(n.k3, k3)]
    return build.block(
        "leg_terms_of",
        meaning,
        (*n.OF_LEG, *p.LEG, *more, *n.MOTION, p.B, n.g),
        [
            (n.q, q),
            (n.L, L),
            *joint,
            (n.D, D),
            (n.H_force, s),
            (n.H_moment, cross(q, s)),
            (n.c_force, -K),
            (n.c_moment, f - cross(q, K)),
        ],
    )


def joint_leg(friction: bool, near_singular: bool = False, rotor: Rotor = NONE) -> Block:
    """The general leg in the coordinates of its joints; ``near_singular``: measured along its third axis."""
    build = Builder()
    at = joint_frame(build, near_singular, rotor=rotor)
    S_dot, S_ddot = p.tip_motion(build, at.q)
    rates = joint_rates(build, at, S_dot)
    accelerations = joint_accelerations(build, at, rates, S_ddot)
    D, K = tip_force(build, at, joint_forces(build, at, rates, accelerations, friction))
    meaning = "one leg in joint coordinates: D, its column of H and its part of c"
    return closed_leg(build, meaning, at.q, at.s, at.L, at.k3, D, K, friction_moment(at, rates, friction))


def _printed_leg(form: Formulation, friction: bool, near_singular: bool) -> Block:
    build = Builder()
    meaning = "one leg in its frame: D, its column of H and its part of c"
    return closed_leg(build, meaning, *printed_leg(build, form, friction, near_singular))


def _plain_leg(form: Formulation, friction: bool) -> Block:
    """The leg as ``inverse_dynamics`` has it, without the outputs that the forces do not need."""
    leg = leg_block(form, friction)
    kept = [out for out in leg.outputs if out.quantity != n.K]
    return replace(rebuilt(leg, list(leg.steps), kept, leg.inputs), name="leg_terms_of")
