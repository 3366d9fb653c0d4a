"""Actuator forces with a bound of their rounding error, as a tree.

The function contains the blocks of the force kernel three times. The first copy computes the forces in the
order of operations of the force kernel, so that both agree to the last bit. The second adds the error of
every step (``rounding``). The third computes, backward, the derivative of a force with respect to every step
(``adjoint``), which propagates the error of the step to the force.
"""

import operator
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import reduce
from math import prod

import sympy as sp

from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.lumped_constants import ADDED, B, arm_c, c_tip, q_1
from ..program.adjoint import Adjoint, adjoint
from ..program.block import Output, Quantity
from ..program.order import ready_in
from ..program.rounding import (
    RECIPROCAL,
    ROOT,
    RoundedBlock,
    RoundedStep,
    component_errors,
    error_symbol,
    rounded,
)
from ..trace import nodes as t
from ..trace.constants import SMALLEST
from ..trace.fused import with_products_in_sums
from ..trace.lower import expression, remark
from ..trace.read import LANES, Given
from . import batches
from . import prepare as p
from .batches import LOADS, MOTIONS, missing, parts_at, parts_of_one
from .layouts import (
    CHECKED,
    Place,
    Written,
    described,
    largest,
    lines,
    member,
    names_used,
    stored,
    stores,
)
from .shared import common_parts, legs_with_errors, shared
from .written import batch
from .written import bounds as written

_ERRING = (n.H_force, n.H_moment, n.c_force, n.c_moment, arm_c)
_ARM = ("arm_x", "arm_y", "arm_z")
"""Steps of a leg: the arm of its moment."""
_FLAGS: dict[str, Given] = {name: t.Constant(name) for name in ("UNIT", "SLACK", "INFINITY", "BAD_ARGUMENT")}


class BoundedForces:
    """Functions of a force kernel with error bounds; the numbers of robot and motion except R are exact.

    ``structures`` are the structures by their names in the texts, and ``parts`` structures and functions in
    order.
    """

    def __init__(self, kernel: ForceKernel) -> None:
        """Derive the errors of every block; raise ValueError for another kind of kernel."""
        if not kernel.about_tip or kernel.leg_near_singular is None:
            raise ValueError("kernel: expected one with moments about platform point 1 and universal joints")
        of_pose, moments, near = (
            ready_in(each.steps) for each in (kernel.shared, kernel.moments, kernel.leg_near_singular)
        )
        of_pose |= ready_in(kernel.shift.steps)
        of_leg = ready_in(kernel.leg.steps) | moments
        kernel = kernel.whole()
        self.kernel = kernel
        # R stands for the rotation nearest to it; one bound for all its entries.
        R = dict.fromkeys(n.R.names, error_symbol(n.R.name))
        self.prepare_leg = rounded(kernel.prepare_leg, {})
        self.prepare_platform = rounded(kernel.prepare_platform, component_errors(ADDED))
        prepared = self.prepare_leg, self.prepare_platform
        made = ((block, out.quantity) for block in prepared for out in block.block.outputs)
        constants = component_errors(q for block, q in made if block.inexact(q))
        self.shared = rounded(kernel.shared, R | constants, of_pose)
        inexact = R | constants | component_errors((B, q_1))
        # By the ending of the functions' names: away from the joint singularity and near it.
        assert kernel.leg_near_singular is not None
        self.legs = {
            "": rounded(kernel.leg, inexact, of_leg),
            "_near_singularity": rounded(kernel.leg_near_singular, inexact, near | moments),
        }
        self.structures = {
            "Robot": p.ROBOT,
            "RawLeg": p.LEG,
            "Motion": p.MOTION,
            "Motions": MOTIONS,
        } | self._structures()
        flags = _FLAGS | {"COUNT": self.model_numbers(), "SMALLEST": t.Number(SMALLEST)}
        common = {each.name: each for each in common_parts() if isinstance(each, t.Structure)}
        solved = {
            "Columns": common["columns_pose"],
            "RightSide": common["right_side_pose"],
            "Solution": common["solution_pose"],
            "TwoBlocks": common["two_blocks_pose"],
        }
        self.texts = Written(self.structures | solved, flags, shared().by_name)

    def _structures(self) -> dict[str, t.Structure]:
        kernel, name = self.kernel, f"stewart_{self.kernel.formulation.kernel_name}_bounds"
        leg = _with_errors(self.prepare_leg, kernel.leg_constants(), described)
        platform = _with_errors(self.prepare_platform, kernel.platform_constants(), described)
        length = "m: root mean square distance of the platform points from the reference point"
        model = (
            t.Field("leg", t.Array(t.Record(f"{name}_leg"), (6,))),
            t.Field("platform", t.Record(f"{name}_platform")),
            t.Field("length", t.Real(), length),
            p.PER_LENGTH,
            p.ARM_CUBE,
        )
        added = [stored(part) for q in ADDED for part in (q, _error_of(q))]
        slopes = [stored(part, LANES) for q in _LEGS_SLOPES.values() for part in (q, _error_of(q))]
        shared = _with_errors(self.shared, kernel.shared.made)
        decides = [t.numbers("D"), *map(stored, CHECKED[1:])]
        decides += [t.numbers("reach"), t.numbers("arm", 3)]
        matrices = [t.numbers(each, 6, 6) for each in ("H", "H_err")] + [t.numbers("arm", 6, 3)]
        vectors = [t.numbers(each, 6) for each in ("c", "c_err", "c_own", "L", "reach")]
        flags = [t.Field("near", t.Integer()), t.Field("close", t.Integer())]
        rows = [stored(q, LANES) for q in _ROW]
        says = "Constants of one leg; `_err`: bound of the error of the constant with this name."
        made = {
            "Leg": (f"{name}_leg", says, leg),
            "Platform": (f"{name}_platform", "Constants of the platform.", platform),
            "Model": (f"{name}_model", p.model_says((*leg, *platform, *model)), model),
            "Added": (
                "added_terms",
                "Contributions of a leg to the constants of the platform, and their sums.",
                added,
            ),
            "Shared": ("shared_terms", "Terms of a pose that are common to all legs.", shared),
            "LegTerms": (
                "leg_terms",
                "Terms of a leg in the platform's equations. k3: sine between leg and fixed axis.",
                [*decides, *_with_errors(self.legs[""], _ERRING)],
            ),
            "Equations": (
                "platform_equations",
                "The platform's equations H x = c with moments about platform point 1. c_own: rounding "
                "errors of the sums in c; near, close: 1 if a leg is near its joint singularity, or short.",
                [*matrices, *vectors, *flags],
            ),
            "Rows": (
                "force_rows",
                "Weights of D, c, and the column of H of one leg in each force, with the forces in lanes: "
                "D_weight D - Y (c - H x). Y_arm: Y_moment, but 0 for leg 1, whose force has no moment about "
                "platform point 1.",
                rows,
            ),
            "Slopes": (
                "force_slopes",
                "Derivatives of the forces, in lanes, by the terms common to all legs, through the legs.",
                slopes,
            ),
        }
        return {key: t.Structure(own, meaning, tuple(parts)) for key, (own, meaning, parts) in made.items()}

    def model_numbers(self) -> int:
        """Count the numbers of the prepared model."""
        types = {name: [each.type for each in self.structures[name].members] for name in ("Leg", "Platform")}
        leg, platform = (
            sum(prod(kind.dims) if isinstance(kind, t.Array) else 1 for kind in kinds)
            for kinds in types.values()
        )
        return 6 * leg + platform + 3

    def parts(self) -> Iterable[t.Structure | t.Function]:
        """Return structures and functions in order."""
        read = self.texts.function
        private = list(self.structures).index("Added")
        yield from list(self.structures.values())[private:]
        for text in (written.least, written.root_error, written.reciprocal_error, written.add):
            yield read(text)
        yield read(written.rotation_error)
        yield read(written.prepare_leg, given={"BODY": self._prepared(self.prepare_leg)})
        yield read(written.prepare_platform, given={"BODY": self._prepared(self.prepare_platform)})
        yield p.size_of(self.texts, by_legs=True)
        public = self.structures["Model"].name.removesuffix("model") + "prepare"
        yield read(written.prepare, public, public=True, given=_texts_of_sums() | p.HANDED_OVER)
        body = with_products_in_sums(self._values(self.shared))
        yield read(written.shared_of_pose, given={"BODY": body})
        for end, leg in self.legs.items():
            yield read(written.leg_of_pose, f"leg_of_pose{end}", given=self._leg(leg))
        yield read(written.stretch_error)
        yield read(written.solution_error)
        yield read(written.norm)
        yield read(written.reciprocal_condition)
        yield read(written.shared_errors, given=self._shared_errors())
        for end, leg in self.legs.items():
            yield read(written.leg_errors, f"leg_errors{end}", given=self._leg_errors(leg))
        yield read(written.equations_of_pose, given=legs_with_errors("out", "leg"))
        yield read(written.pose_status)
        yield read(written.solution)
        held = [*_ROW, *(part for q in _LEGS_SLOPES.values() for part in (q, _error_of(q)))]
        zeros = (t.Assign(_of_force(q).part(q, i), t.Number(0.0)) for q in held for i in range(len(q.keys)))
        yield read(written.bound_of_pose, given={"CLEARED": tuple(zeros)})
        yield read(written.forces_of_pose)
        name = self.structures["Model"].name.removesuffix("_bounds_model")
        needed = [q for q in n.MOTION if q not in LOADS]
        yield read(batch.pose_at, given=parts_at(LOADS))
        yield read(batch.motion_as_arrays, given=parts_of_one())
        given = missing(("model", "motion", "F"))
        yield read(batch.forces_bounded, f"{name}_forces_bounded", public=True, given=given)
        given = missing(("model", "motions", "F"), needed) | batches.batch(batch.one_bounded)
        yield read(batch.forces_bounded_batch, f"{name}_forces_bounded_batch", public=True, given=given)

    # ------------------------------------------------------------ blocks

    def _layout(self, quantity: Quantity) -> Place:
        """Return the locations of the inputs of the functions of a pose."""
        if quantity in n.MOTION:
            return member("at", quantity)
        if quantity in self.kernel.shared.made:
            return member("shared", quantity)
        return member("platform" if quantity in self.kernel.platform_constants() else "leg", quantity)

    def _prepared(self, block: RoundedBlock) -> tuple[t.Statement, ...]:
        """Return a block of the preparation with its errors."""
        return (
            *p.axis(block.block),
            *_loaded(block, lambda q: member("added", q) if q in ADDED else p.raw(q)),
            *_step_statements(block),
            *_stored_outputs(block, block.block.outputs),
        )

    def _values(self, block: RoundedBlock) -> tuple[t.Statement, ...]:
        """Return a block without its errors."""
        return (
            *lines(block.block, self._layout, ready=block.ready),
            *stores(_kept_outputs(block), lambda q: member("out", q)),
        )

    def _leg(self, leg: RoundedBlock) -> dict[str, Given]:
        """Return a leg without its errors, and the quantities that determine its status."""
        exprs = leg.block.exprs
        terms = [*exprs[n.q], *(symbol for q in (n.t, n.b) for symbol in q.symbols)]
        arms = [t.Assign(t.at(t.of("out", "arm"), i), t.Name(each)) for i, each in enumerate(_ARM)]
        checked = [Output(q, exprs[q]) for q in CHECKED[1:]]
        return {
            "BODY": (*self._values(leg), *stores(checked, lambda q: member("out", q)), *arms),
            **largest(terms),
        }

    def _leg_errors(self, leg: RoundedBlock) -> dict[str, Given]:
        """Return the function of a leg with errors and their effects on D - Y (c - H x)."""
        force, moment, x, D = _Y_FORCE.value, _Y_MOMENT.value, n.x.value, _D_WEIGHT.value
        by_arm = _Y_ARM.value
        weights = {
            n.D: D,
            n.c_force: -force,
            n.c_moment: -moment,
            arm_c: -by_arm,
            n.H_force: x * force,
            n.H_moment: x * by_arm,
        }
        found = adjoint(leg.block, weights, _ROW, _inexact_inputs(leg))
        outside = {name: found.slopes[name] for q in _LEGS_SLOPES for name in q.names}
        handed = []
        for q, to in _LEGS_SLOPES.items():
            for j, name in enumerate(q.names):
                sums, slope = _value_and_error("slopes", to, j, _FORCE), outside[name]
                handed.append(t.Do(t.Call("add", (*sums, expression(slope), _error_name(slope)))))
        return self._weighed(leg, found, {}, outside, handed)

    def _shared_errors(self) -> dict[str, Given]:
        """Return the arguments of ``written.shared_errors``, which adds derivatives by R."""
        given = (_Y_FORCE, _Y_MOMENT, *_LEGS_SLOPES.values())
        weights = {n.c_force: -_Y_FORCE.value, c_tip: -_Y_MOMENT.value}
        weights |= {q: _LEGS_SLOPES[q].value for q in (B, q_1)}
        more = dict(zip(n.R.names, _LEGS_SLOPES[n.R].symbols, strict=True))
        found = adjoint(self.shared.block, weights, given, _inexact_inputs(self.shared), more)
        slopes = {name: found.slopes[name] for name in n.R.names}
        handed = []
        for j, slope in enumerate(slopes.values()):
            value, error = _value_and_error("slopes", _LEGS_SLOPES[n.R], j, _FORCE)
            handed += [t.Assign(value, expression(slope)), t.Assign(error, _error_name(slope))]
        errors = component_errors(_LEGS_SLOPES.values())
        return self._weighed(self.shared, found, errors, slopes, handed)

    def _weighed(
        self,
        block: RoundedBlock,
        found: Adjoint,
        errors: Mapping[str, sp.Expr],
        outside: Container[str],
        more: Sequence[t.Statement],
    ) -> dict[str, Given]:
        """Return ``BODY``, a block with errors, and ``EACH``, errors times derivatives of each force.

        ``errors`` are the errors that are multiplied. The errors of the inputs ``outside`` are multiplied
        elsewhere, by ``more``.
        """
        slopes = rounded(found.block, {**block.errors, **errors})
        sources = {name: own for name, own in _sources(block) if name not in outside and name in found.slopes}
        weighed = {name: found.slopes[name] for name in sources}
        inner = replace(slopes, limits=slopes.limits | {_only_name(slope) for slope in weighed.values()})
        whole = replace(block, limits=block.limits | inner.limits)
        terms = (t.Name(f"{_only_name(weighed[name])}_max") * own for name, own in sources.items())
        error: t.Expression = t.Element(t.Name("error"), (_FORCE,))
        ready = {q.name for q in block.block.inputs} | {step.name for step in block.block.steps}
        return {
            "BODY": (
                *_loaded(whole, self._layout),
                *_step_statements(whole, weighed, _unread_errors(whole, inner)),
                *_stored_outputs(block, _erring_outputs(block)),
            ),
            "EACH": (
                *_loaded(inner, _of_force, ready),
                *_step_statements(inner),
                t.Assign(error, reduce(operator.add, terms, error)),
                *more,
            ),
        }


_Y_FORCE = Quantity("Y_force", (3,), "1", "row of Y, force columns")
_Y_MOMENT = Quantity("Y_moment", (3,), "1/m", "row of Y, moment columns")
_Y_ARM = Quantity("Y_arm", (3,), "1/m", "the same; 0 for leg 1, whose arm is exactly zero")
_D_WEIGHT = Quantity("D_weight", (), "1", "1 for the leg's own force, 0 for the others")
_LEGS_SLOPES = {q: Quantity(f"{q.name}_legs", q.shape, "", "slope by the legs") for q in (n.R, B, q_1)}
"""Contributions of the legs to the derivatives of a force with respect to the common terms of the pose."""
_ROW = (_Y_FORCE, _Y_MOMENT, _Y_ARM, _D_WEIGHT, n.x)
_FORCE = t.Name("i")
"""The lane of a force."""


def _of_force(quantity: Quantity) -> Place:
    """Return the locations of a row of Y and of the derivatives of the legs."""
    return member("rows" if quantity in _ROW else "slopes", quantity, _FORCE)


def _inexact_inputs(block: RoundedBlock) -> list[str]:
    return [name for q in block.block.inputs for name in q.names if block.errors[name] != 0]


def _sources(block: RoundedBlock) -> list[tuple[str, t.Expression]]:
    """Return the name and error of every quantity that has an error of its own."""
    inputs = [(name, expression(block.errors[name])) for name in _inexact_inputs(block)]
    return inputs + [(each.step.name, t.Name(f"{each.step.name}_own")) for each in block.steps if each.rounds]


def _only_name(slope: sp.Expr) -> str:
    """Return the name of a derivative, which is a symbol or a negated symbol."""
    (symbol,) = slope.free_symbols
    return str(symbol.name)


def _error_name(slope: sp.Expr) -> t.Name:
    return t.Name(f"{_only_name(slope)}_err")


# ---------------------------------------------------------------- steps with their errors


def _unread_errors(block: RoundedBlock, slopes: RoundedBlock) -> set[str]:
    """Return the steps whose error is not read by steps, derivatives, limits, or other code."""
    read = {symbol for each in (*block.steps, *slopes.steps) for symbol in each.carried.free_symbols}
    read |= {block.output_error(expr) for out in _erring_outputs(block) for expr in out.exprs}
    names = {each.step.name for each in block.steps if error_symbol(each.step.name) not in read}
    return names - block.limits


def _kept_outputs(block: RoundedBlock) -> tuple[Output, ...]:
    """Return the outputs except the outputs for the check of a leg."""
    return tuple(out for out in block.block.outputs if out.quantity not in CHECKED)


def _erring_outputs(block: RoundedBlock) -> tuple[Output, ...]:
    """Outputs whose errors are returned; the effect of the error of D is added directly."""
    return tuple(out for out in _kept_outputs(block) if out.quantity != n.D)


def _with_errors(
    block: RoundedBlock, quantities: Iterable[Quantity], made: Callable[[Quantity], t.Field] = stored
) -> list[t.Field]:
    """Return members for values and, if there are any, for errors."""
    found = []
    for q in quantities:
        found += [made(q), *([stored(_error_of(q))] if block.inexact(q) else [])]
    return found


def _error_of(quantity: Quantity) -> Quantity:
    return Quantity(f"{quantity.name}_err", quantity.shape, quantity.unit, "", quantity.symmetric)


def _value_and_error(
    owner: str | t.Expression, quantity: Quantity, index: int, *lane: t.Expression
) -> tuple[t.Expression, t.Expression]:
    """Return one component and its error."""
    value, error = (member(owner, q, *lane).part(q, index) for q in (quantity, _error_of(quantity)))
    return value, error


def _texts_of_sums() -> dict[str, Given]:
    """Return the functions that add contributions of the legs to the platform, with errors."""
    total, more = (
        [_value_and_error(each, q, i) for q in ADDED for i in range(len(q.keys))] for each in ("sum", "found")
    )
    return {
        "CLEARED": tuple(t.Assign(each, t.Number(0.0)) for pair in total for each in pair),
        "SUMMED": tuple(t.Do(t.Call("add", (*to, *term))) for to, term in zip(total, more, strict=True)),
    }


def _loaded(
    block: RoundedBlock, layout: Callable[[Quantity], Place], ready: Container[str] = ()
) -> tuple[t.Statement, ...]:
    """Return values, errors, and largest magnitudes of the inputs that are read and not ``ready``."""
    used = names_used(block.block) | block.limits
    found: list[t.Statement] = []
    limits: list[t.Statement] = []
    for q in (q for q in block.block.inputs if q.name not in ready):
        place = layout(q)
        read = [(i, name) for i, name in enumerate(q.names) if name in used]
        found += [t.Let(name, place.part(q, i)) for i, name in read]
        wrong = [(i, name) for i, name in read if block.errors[name] == error_symbol(name)]
        owner = place.array.owner if isinstance(place.array, t.Member) else place.array
        found += [t.Let(f"{name}_err", _value_and_error(owner, q, i, *place.lane)[1]) for i, name in wrong]
        limits += [_limit(block, name) for name in q.names if name in block.limits]
    return (*found, *limits)


def _limit(block: RoundedBlock, name: str) -> t.Let:
    size, error = t.Call("size", (t.Name(name),)), block.errors[name]
    return t.Let(f"{name}_max", size + expression(error) if error != 0 else size)


def _step_statements(
    block: RoundedBlock, apart: Container[str] = (), unread: Container[str] = ()
) -> Iterable[t.Statement]:
    """Return the value, the error bound, and, if needed, the largest magnitude of each step.

    The rounding error of steps in ``apart`` gets a name. Nothing reads the error of steps in ``unread``.
    """
    before = None
    for each in block.steps:
        step = each.step
        yield from remark(step, before)
        before = step
        yield t.Let(step.name, expression(step.expr, block.order_of(step)))
        own = _own_error(each)
        if each.rounds and step.name in apart:
            yield t.Let(f"{step.name}_own", own)
            own = t.Name(f"{step.name}_own")
        if not each.exact and step.name not in unread:
            yield t.Let(f"{step.name}_err", _error(each, own))
        if step.name in block.limits:
            yield _limit(block, step.name)


def _own_error(each: RoundedStep) -> t.Expression:
    """Return the rounding error of the operations of a step itself."""
    value = t.Name(each.step.name)
    sizes = [expression(each.rounded)] if each.rounded != 0 else []
    if each.kind == ROOT:
        return t.Call("root_error", (value, _units(sizes)))
    return _units([*sizes, t.Call("size", (value,))] if each.own else sizes)


def _error(each: RoundedStep, own: t.Expression) -> t.Expression:
    """Return the error bound of a step: errors of its inputs, and its own rounding error."""
    value = t.Name(each.step.name)
    carried = [expression(each.carried)] if each.carried != 0 else []
    if each.kind == RECIPROCAL:
        return t.Call("reciprocal_error", (value, expression(each.step.expr.base), _total(carried)))
    if each.kind == ROOT:
        inner = [_units([expression(each.rounded)])] if each.rounded != 0 else []
        return t.Call("root_error", (value, _total([*carried, *inner])))
    return _total([*carried, own] if each.rounds else carried)


def _total(terms: list[t.Expression]) -> t.Expression:
    return reduce(operator.add, terms) if terms else t.Number(0.0)


def _units(sizes: list[t.Expression]) -> t.Expression:
    """Return magnitudes times the rounding unit."""
    return _times(t.Constant("UNIT"), _total(sizes)) if sizes else t.Number(0.0)


def _times(factor: t.Expression, value: t.Expression) -> t.Expression:
    """Return a product from left to right."""
    if isinstance(value, t.Binary) and value.operator == "*":
        return _times(factor, value.left) * value.right
    return factor * value


def _stored_outputs(block: RoundedBlock, outputs: Iterable[Output]) -> Iterable[t.Statement]:
    """Return the statements that store values and errors."""
    for out in outputs:
        q = out.quantity
        owner = "added" if q in ADDED else "out"
        for i, expr in enumerate(out.exprs):
            value, error = _value_and_error(owner, q, i)
            yield t.Assign(value, expression(expr))
            if block.inexact(q) or q in ADDED:
                yield t.Assign(error, expression(block.output_error(expr)))
