"""Actuator forces without other outputs, regrouped to reduce the number of operations.

None of these changes affects the result:

- Terms that are common to all legs are computed once per pose: B with S_ddot = B q + a, and the platform's
  part of c.
- Constants that occur together are prepared once per robot (``lumped_constants``). The mass of an upper part
  is lumped with the platform as a point mass at the spherical joint.
- Legs of ``exact`` use joint coordinates (``joint_coordinates``), legs of ``paper`` use the leg frame
  (``printed``). Legs with spherical base joints use the equations of ``inverse_dynamics``.
- The force K on a leg may have any component along s, because x compensates for it. D changes with it, so
  that F = D - x is unchanged.
- The inertia of the platform is about the common center of mass of the platform and the lumped masses. A
  distant reference point does not reduce the accuracy.
- Moments are about platform point 1. Leg 1 then has no moment, the elimination begins with three rows, and no
  moment arm is longer than the platform, however long the legs are.

``passes`` measures the effect of each change.
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
    """Blocks that compute the actuator forces.

    Attributes
    ----------
    formulation : Formulation
        Formulation of the equations.
    friction : bool
        True if the joints have friction.
    prepare_leg, prepare_platform : Block
        Preparation of the constants, once per robot.
    shared : Block
        Terms of a pose that are common to all legs, with the platform's part of c.
    leg : Block
        D, column of H, and part of c of one leg.
    leg_near_singular : Block, optional
        The block of a leg for poses in which a leg is near its joint singularity.
    about_tip : bool
        True if moments are about platform point 1. ``moments`` and ``shift`` then compute the moments, and
        the block of a leg computes only the moment of friction. If False, moments are about the reference
        point and the block of a leg computes them.
    fidelity, meaning : str
        Name and description of the fidelity level.
    constants : mapping, optional
        Values of each constant of a baked kernel: one value for all legs, or six.
    baked_name : str
        Name of a baked kernel.
    size : float
        Largest coordinate of the moment arms of a baked kernel (m).
    extent : float
        Largest sum of the absolute coordinates of a base or platform point of a baked kernel (m).
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
        """Name of the emitted kernel, such as ``exact``, ``paper``, or ``exact_slender``."""
        if self.baked_name:
            return self.baked_name
        own = self.formulation.kernel_name
        return own if self.fidelity == "general" else f"{own}_{self.fidelity}"

    @property
    def moments(self) -> Block:
        """Moments of one leg about platform point 1, for legs 2 to 6."""
        return leg_moments(n.c_force in self.leg.made)

    @property
    def shift(self) -> Block:
        """Platform's part of c with moments about platform point 1."""
        return platform_moments()

    def whole(self) -> "ForceKernel":
        """Return the kernel with ``moments`` and ``shift`` merged into the blocks of legs and pose.

        The operations are the same. Leg 1 then also computes moments, all of them zero, and the block of the
        pose computes q_1 from the constant p_1.
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
        """Return the constants of a baked kernel that have the same value for all legs."""
        return {q: values[0] for q, values in (self.constants or {}).items() if len(values) == 1}

    def used_motion(self) -> tuple[Quantity, ...]:
        """Return the components of the motion on which the forces depend, always including R and t."""
        used = {*self.shared.inputs, *self.leg.inputs, n.R, n.t}
        return tuple(q for q in n.MOTION if q in used)

    def changed(self, change: Callable[[Block], Block]) -> "ForceKernel":
        """Return the kernel with ``change`` applied to the blocks of a pose, ``shared`` and legs."""
        near = None if self.leg_near_singular is None else change(self.leg_near_singular)
        return replace(self, shared=change(self.shared), leg=change(self.leg), leg_near_singular=near)

    def blocks(self) -> tuple[Block, ...]:
        """Return the blocks that are evaluated for each pose: ``shared`` and the legs."""
        return self.shared, self.leg, *(() if self.leg_near_singular is None else (self.leg_near_singular,))

    def leg_constants(self) -> tuple[Quantity, ...]:
        """Return the constants of each leg in the prepared model."""
        if self.constants is not None:
            return tuple(q for q, values in self.constants.items() if len(values) > 1)
        return tuple(q for q in self.prepare_leg.made if q not in p.ADDED)

    def more_of_legs(self) -> tuple[Quantity, ...]:
        """Return the inputs of ``prepare_leg`` in addition to ``OF_LEG``, ``PLATFORM``, and p_1."""
        known = (*n.OF_LEG, *n.PLATFORM, n.p_1)
        return tuple(q for q in self.prepare_leg.inputs if q not in known)

    def platform_constants(self) -> tuple[Quantity, ...]:
        """Return the constants of the platform in the prepared model."""
        if self.constants is not None:
            return ()
        return self.prepare_platform.made


@cache
def force_kernel(form: Formulation, friction: bool = True) -> ForceKernel:
    """Derive the regrouped blocks of a formulation with moments about platform point 1."""
    return about_tip(regrouped(form, friction))


def elimination_kernel(form: Formulation, friction: bool = True) -> ForceKernel:
    """Return the blocks of ``inverse_dynamics`` without the outputs that the forces do not need."""
    return with_constants(form, friction, platform()[0], _plain_leg(form, friction), p.NOTHING_LUMPED)


def with_shared_pose(form: Formulation, friction: bool = True) -> ForceKernel:
    """Derive the legs of ``inverse_dynamics`` with S_ddot = B q + a and a regrouped platform's part of c."""
    leg = _plain_leg(form, friction)
    ready = dict(zip(("S_ddot_x", "S_ddot_y", "S_ddot_z"), p.B.value * n.q.value + n.a.value, strict=True))
    steps = [replace(step, expr=ready.get(step.name, step.expr)) for step in leg.steps]
    leg = rebuilt(leg, steps, list(leg.outputs), (*leg.inputs, p.B))
    return with_constants(form, friction, shared(friction=False), leg, p.NOTHING_LUMPED)


def regrouped(form: Formulation, friction: bool = True) -> ForceKernel:
    """Derive the blocks with all constants regrouped and with moments about the reference point."""
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
    """Return a kernel with the preparation of the constants that its blocks of pose and leg read."""
    return ForceKernel(
        form,
        friction,
        p.prepare_leg(leg.inputs, lumped),
        p.prepare_platform(dict.fromkeys((*pose.inputs, *(q for q in leg.inputs if q == n.g)))),
        pose,
        leg,
    )


def with_numbers(kernel: ForceKernel, numbers: Iterable[Quantity]) -> ForceKernel:
    """Return the kernel with additional numbers of the robot in its prepared model."""
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
    """Return the kernel without zero outputs; a leg keeps outputs that are nonzero in one of its blocks."""
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
    """Move the moments of a kernel to platform point 1, and write S = q + (t - b)."""
    leg = _leg_without_moments(kernel.leg)
    lumped = p.lumped(kernel.prepare_leg)
    moved = with_constants(kernel.formulation, kernel.friction, kernel.shared, leg, lumped)
    near = None if kernel.leg_near_singular is None else _leg_without_moments(kernel.leg_near_singular)
    return replace(moved, leg_near_singular=near, about_tip=True, fidelity=kernel.fidelity)


def from_difference(leg: Block) -> Block:
    """Write S = q + (t - b) in a leg, because the rounding error of t - b is as small as t - b."""
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
    """Return the leg with output q and without moments other than friction."""
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
    """Derive the moments about platform point 1 of a leg other than leg 1, including c if ``with_force``."""
    build = Builder()
    arm = build.vector("arm", n.q.value - p.q_1.value, "", "platform point from platform point 1")
    outputs = [(n.H_moment, cross(arm, n.H_force.value))]
    if with_force:
        outputs.append((p.arm_c, cross(arm, n.c_force.value)))
    return build.block("moments_of", "moments of one leg", (n.q, p.q_1, n.H_force, n.c_force), outputs)


@cache
def platform_moments() -> Block:
    """Derive the platform's part of c with moments about platform point 1 instead of the reference point."""
    moved = n.c_moment.value - cross(p.q_1.value, n.c_force.value)
    inputs = (p.q_1, n.c_force, n.c_moment)
    return Builder().block("shift", "the platform's part of c", inputs, [(p.c_tip, moved)])


def joined(
    first: Block, second: Block, between: Iterable[Step] = (), inputs: Iterable[Quantity] = ()
) -> Block:
    """Concatenate two blocks.

    Outputs of the first block that the second block reads keep their names and thus the order of terms in
    sums.
    """
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
    """Name the entries of B = [alpha]x + [omega]x [omega]x, (7)."""
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
    """Compute I alpha + omega x I omega (34) with shared products of omega and prepared differences d.

    ``turn`` is the result of ``rotary`` for the same omega and alpha, if available.
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
    """Derive the terms common to all legs: B, and the platform's part of c, (30)-(35).

    ``friction`` adds the platform's part of the spherical-joint friction.
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
    """Return the block of a leg with moments about the reference point.

    Parameters
    ----------
    k3 : Expr or None
        Sine of the angle between the leg and the fixed axis; None without a universal joint.
    more : iterable of Quantity
        Constants of the leg in addition to ``quantities.OF_LEG`` and ``lumped_constants.LEG``.
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
    """Derive a leg with universal base joint in joint coordinates.

    ``near_singular`` projects on the third axis z of the leg frame, which is accurate near the joint
    singularity.
    """
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
    """Return the leg of ``inverse_dynamics`` without the output K, which the forces do not need."""
    leg = leg_block(form, friction)
    kept = [out for out in leg.outputs if out.quantity != n.K]
    return replace(rebuilt(leg, list(leg.steps), kept, leg.inputs), name="leg_terms_of")
