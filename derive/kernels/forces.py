"""Actuator forces, H x = c and F = D - x, (36), (37)."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ..mechanics import lumped_constants as p
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..program.block import Block, Quantity
from ..program.order import ready_in
from ..trace.recorder import Branch, Slot, Trace
from ..trace.values import LEGS, Value, as_value, constant, larger, where
from .solve import COLUMNS, RIGHT_SIDE, solution

PER_LENGTH = Quantity("per_length", (), "1/m", "factor of the moment rows of H and c")
BASE_REACH = Quantity("base_reach", (), "m", "largest magnitude of a coordinate of the base points")
FORCES = "forces"
"""Structure of F, and of the mark of a pose that the function of one pose must compute."""
ONE_LEG_AHEAD = 40
"""Least number of operations after a leg's roots for which computing the next leg's roots first is faster."""

Outputs = dict[Quantity, list[Value]]


def forces(k: Trace, kernel: ForceKernel, scaled: bool | None = None) -> None:
    """Trace the forces of a kernel.

    ``scaled`` is True if moments are always multiplied by ``PER_LENGTH``, and False if they never are. If it
    is None, the prepared model decides.
    """
    ready, (roots, rest) = ready_in(kernel.leg.steps), as_far_as_roots(kernel.leg)
    known: dict[str, Value] = {}
    ahead = rest.operations().total > ONE_LEG_AHEAD
    # Roots and quotients take long; meanwhile a processor computes the terms that are common to all legs.
    with k.part("leg_roots", _says("a leg up to its square roots", roots), per_leg=True, ahead=ahead):
        k.run(roots, {}, known, ready)
        points = [known[name].name for name in n.q.names if name in known]
        k.slots |= {name: Slot("leg_roots", n.q.name, i) for i, name in enumerate(points)}
    says = _says("terms of a pose that are common to all legs", kernel.shared)
    with k.part("shared_terms", says, fuses_named=True):
        pose = k.run(kernel.shared, {})
        reach = larger(k.input(BASE_REACH.name), constant("SHORTEST") / constant("ROUNDING"))
        for component in k.inputs_named(n.t):
            reach = larger(abs(component), reach)
        # A leg is q + t - b, so a leg that is short compared with q is also short compared with t or b.
        least_L = k.let("least_L", as_value(2.25) * constant("SHORT_SHARE") * reach)
    with k.part("legs_fit", "Marks a pose in which a leg must be examined."):
        any_unfit = k.accumulator("any_unfit", as_value(0.0), operator="mark")
        is_short = k.let("is_short", as_value(0.0))
    with k.part("leg_terms", _says("a leg: its D, its column of H, and its part of c", rest), per_leg=True):
        leg = k.run(rest, pose, known, ready)
        unfit = where(leg[n.L][0] > least_L, any_unfit, 1.0)
        near = kernel.leg_near_singular
        if n.k3 in leg:
            least = constant("JOINT_SINGULAR_SINE" if near is None else "NEAR_JOINT_SINGULAR")
            unfit = where(leg[n.k3][0] > least, unfit, 1.0)
        else:
            unfit = where(leg[n.L][0] <= constant("MAX"), unfit, 1.0)
        k.accumulate(any_unfit, k.let("unfit", unfit))
    with k.rarely(any_unfit > 0.0, alone=True) as branch:
        examine_legs(k, kernel, leg, pose, branch, is_short)
    H, c = equations(k, kernel, leg, pose, scaled)
    D = leg.get(n.D)

    def results(x: list[Value], suspect: Value) -> list[Value]:
        """Trace F = D - x, (37), and the marks of a doubtful and of an unfinished pose."""
        found = [D[0].at(i) - x[i] if D else -x[i] for i in range(LEGS)]
        F = [k.let(f"F_{i}", force, Slot(FORCES, "F", i)) for i, force in enumerate(found)]
        doubtful = k.let("doubtful", where(is_short > 0.0, 1.0, suspect))
        unfinished = where(suspect > 0.0, 1.0, any_unfit)
        for force in F:
            unfinished = where(abs(force) <= constant("MAX"), unfinished, 1.0)
        return [*F, doubtful, k.let("unfinished", unfinished, Slot(FORCES, "unfinished"))]

    *k.result, doubtful, unfinished = solution(k, H, c, results)
    k.unfinished = [unfinished]
    with k.rarely(doubtful > 0.0, alone=True):
        k.reject(
            "rows_status",
            H,
            leg[n.q],
            [leg[n.L][0]],
            [leg_reach(k, kernel, leg, "reach_of_rows")],
            k.input(PER_LENGTH.name),
        )


def equations(
    k: Trace, kernel: ForceKernel, leg: Outputs, pose: Outputs, scaled: bool | None
) -> tuple[list[Value], list[Value]]:
    """Trace H and c, with moments about platform point 1 or the reference point."""
    unit = k.input(PER_LENGTH.name)
    c = [*pose[n.c_force], *pose[n.c_moment]]
    if kernel.about_tip:
        says = _says("the platform's part of c about platform point 1", kernel.shift)
        with k.part("tip_terms", says):
            q_1 = [k.let(name, value.at(0)) for name, value in zip(p.q_1.names, leg[n.q], strict=True)]
            moved = k.run(kernel.shift, {p.q_1: q_1, **{q: pose[q] for q in (n.c_force, n.c_moment)}})
            c[3:] = moved[p.c_tip]
    with k.part("wrench", "Adds the parts of c of the platform and the legs."):
        slot = [None if scaled and i >= 3 else Slot(RIGHT_SIDE, "c", i) for i in range(LEGS)]
        c = [k.accumulator(f"c_{i}", own, slot[i]) for i, own in enumerate(c)]
    with k.part("leg_wrench", "Adds a leg's part of c.", per_leg=True):
        for first, q in ((0, n.c_force), (3, n.c_moment)):
            for i, term in enumerate(leg.get(q, ()), first):
                k.accumulate(c[i], term)
    H = [*leg[n.H_force], *leg.get(n.H_moment, ())]
    if kernel.about_tip:
        says = _says("the moments of a leg about platform point 1", kernel.moments)
        with k.part("moment_terms", says, per_leg=True, skips_first=True):
            about = k.run(kernel.moments, {p.q_1: q_1, **leg})
            H[3:] = about[n.H_moment]
            for i, term in enumerate(about.get(p.arm_c, ()), 3):
                k.accumulate(c[i], term)
    if scaled:
        with k.part("moment_terms", "", per_leg=True, skips_first=kernel.about_tip):
            H[3:] = [k.let(f"H_{i}", value * unit) for i, value in enumerate(H[3:], 3)]
        with k.part("scaled_wrench", "Multiplies the moments of c by `per_length`."):
            c[3:] = [
                k.let(f"c_{i}", value * unit, Slot(RIGHT_SIDE, "c", i)) for i, value in enumerate(c[3:], 3)
            ]
    for i, value in enumerate(H):
        k.slots[value.name] = Slot(COLUMNS, "H", i)
    if scaled is None:
        with k.rarely(unit.differs_from(1.0)) as branch:
            scale_moments(k, branch, H[3:], c[3:], kernel.about_tip)
    return H, c


def scale_moments(k: Trace, branch: Branch, H: list[Value], c: list[Value], about_tip: bool) -> None:
    """Multiply the moment rows of H and c by ``PER_LENGTH``."""
    unit = k.input(PER_LENGTH.name)
    meaning = "Multiplies the moments of a leg by `per_length`."
    with k.part("scaled_moments", meaning, per_leg=True, skips_first=about_tip):
        for value in H:
            branch.update(value, k.let("scaled", value * unit))
    with k.part("scaled_wrench", "Multiplies the moments of c by `per_length`."):
        for value in c:
            branch.update(value, k.let("scaled", value * unit))


def examine_legs(
    k: Trace, kernel: ForceKernel, leg: Outputs, pose: Outputs, branch: Branch, is_short: Value
) -> None:
    """Trace the examination of a pose in which a leg is short or near its joint singularity."""
    reach = leg_reach(k, kernel, leg, "reach_of_legs")
    L, k3 = leg[n.L][0], leg[n.k3][0] if n.k3 in leg else None
    for i in range(LEGS):
        k.reject("fault_of", L.at(i), k3.at(i) if k3 is not None else as_value(1.0), reach.at(i))
    with k.part("examination", "Marks a pose with a short leg or a leg near its joint singularity."):
        short, near = as_value(0.0), as_value(0.0)
        for i in range(LEGS):
            is_long = L.at(i) > constant("SHORT_SHARE") * reach.at(i)
            short = k.let("leg_is_short", where(is_long, short, 1.0))
            if k3 is not None:
                near = k.let("near", where(k3.at(i) > constant("NEAR_JOINT_SINGULAR"), near, 1.0))
        branch.update(is_short, short)
    if kernel.leg_near_singular is not None:
        with k.rarely(near > 0.0) as again:
            says = _says("a leg near its joint singularity", kernel.leg_near_singular)
            with k.part("leg_near_singular", says, per_leg=True):
                other = k.run(kernel.leg_near_singular, pose)
            for q, values in other.items():
                for old, new in zip(leg[q], values, strict=True):
                    again.update(old, new)


def leg_reach(k: Trace, kernel: ForceKernel, leg: Outputs, part: str) -> Value:
    """Trace the largest component of the vectors whose sum is a leg."""
    with k.part(part, "Computes the largest component (m) of the vectors whose sum is a leg.", per_leg=True):
        reach = constant("SHORTEST") / constant("ROUNDING")
        vectors = (n.t, *base_points(kernel))
        for component in (*leg[n.q], *(value for q in vectors for value in k.inputs_named(q))):
            reach = larger(abs(component), reach)
        return k.let("reach", reach)


def base_points(kernel: ForceKernel) -> tuple[Quantity, ...]:
    """Return the constants that are base points; in a baked kernel, components that differ between legs."""
    if kernel.constants is None:
        return (n.b,)
    return tuple(part for part in kernel.leg_constants() if part.name in n.b.names)


def as_far_as_roots(leg: Block) -> tuple[Block, Block]:
    """Split a leg into the steps up to the square roots and their reciprocals, and the other steps."""
    half = sp.Rational(1, 2)
    needed = {step.name for step in leg.steps if any(each.exp == half for each in step.expr.atoms(sp.Pow))}
    for step in reversed(leg.steps):
        if step.name in needed:
            needed |= {symbol.name for symbol in step.expr.free_symbols}
    reciprocals = [step for step in leg.steps if step.expr.is_Pow and step.expr.exp == -1]
    needed |= {step.name for step in reciprocals if {s.name for s in step.expr.free_symbols} <= needed}
    first = tuple(step for step in leg.steps if step.name in needed)
    others = tuple(step for step in leg.steps if step.name not in needed)
    parts = replace(leg, steps=first, outputs=()), replace(leg, steps=others)
    roots, rest = (replace(part, inputs=part.used_inputs()) for part in parts)
    return roots, rest


def _says(contents: str, block: Block) -> str:
    """Describe a block with its count of operations."""
    return f"Computes {contents}: {block.operations()}."
