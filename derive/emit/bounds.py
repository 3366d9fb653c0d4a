"""C99: the actuator forces with a bound of their rounding error and the reciprocal condition of H.

Prints the blocks of the force kernel three times: plain, in the order of operations of ``lanes``, so that the
forces agree to the last bit; with the error of every step (``rounding``); and backward, with the slope of a
force along every step (``adjoint``), which tells what that error does. Around them stand the elimination and
what bounds its error. Knows layout and solving, no dynamics.
"""

from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from .. import notation as n
from ..adjoint import Adjoint, adjoint
from ..block import AXES, Output, Quantity
from ..prepared import ADDED, B, arm_c, c_tip, q_1
from ..regroup import ForceKernel
from ..rounding import RECIPROCAL, ROOT, RoundedBlock, RoundedStep, component_errors, error_symbol, rounded
from . import singular
from .c import ARITHMETIC, IS_FINITE, size, step_lines, wrap_list
from .infix import infix, wrap
from .lane_scale import MEMBER, PREPARED, SIZE_BY_LEGS
from .lane_text import (
    JUDGED,
    MACROS,
    SCALED_AXIS,
    dims,
    entries,
    filled,
    judged,
    loads,
    names_used,
    raw_member,
    stores,
    with_scaled_axis,
)
from .lanes import reach_terms, solve_pose

_SQRT = "STEWART_SQRT"
_ERRING = (n.H_force, n.H_moment, n.c_force, n.c_moment, arm_c)


def header(kernel: ForceKernel, version: str) -> str:
    """``stewart_<kernel>_bounds.h``: the prepared model with its errors, and the functions."""
    name = kernel.formulation.kernel_name
    blocks = _Blocks(kernel)
    parts = {
        "@LEG@": _members(blocks.prepare_leg, kernel.leg_constants(), comment=True),
        "@PLATFORM@": _members(blocks.prepare_platform, blocks.kernel.platform_constants(), comment=True),
        "@SCALE@": [MEMBER],
    }
    text = _HEADER.replace("@GUARD@", f"STEWART_{name.upper()}_BOUNDS_H").replace("@VERSION@", version)
    return filled(text, parts).replace("@NAME@", name)


def source(kernel: ForceKernel, version: str) -> str:
    """``stewart_<kernel>_bounds.c``: preparation, blocks with their errors, the solution and its bound."""
    blocks = _Blocks(kernel)
    prepared = blocks.prepare_leg, blocks.prepare_platform
    parts = [
        _TOP.replace("@VERSION@", version)
        + ARITHMETIC
        + MACROS
        + singular.MACROS
        + _MACROS
        + "\n"
        + IS_FINITE,
        _ERRORS,
        filled(_STRUCTS, blocks.structs()),
        SCALED_AXIS,
        *(
            _function(
                text,
                [
                    *with_scaled_axis(_inputs(block, _raw_owner)),
                    *_steps(block),
                    *_stores(block, block.block.outputs),
                ],
            )
            for text, block in zip((_PREPARE_LEG, _PREPARE_PLATFORM), prepared, strict=True)
        ),
        SIZE_BY_LEGS.replace("@MODEL@", "stewart_@NAME@_bounds_model"),
        filled(
            _PREPARE,
            {
                "@ZERO@": _zero(),
                "@ADD@": _add(),
                "@SCALE@": [PREPARED.format(model="made.", address="&made")],
            },
        ),
        _function(_SHARED, _values(blocks.shared, blocks.pose_owner)),
        _LEG_STATUS,
        *(
            _function(_LEG, [*_values(leg, blocks.pose_owner), *_status(kernel, leg)]).replace("@NEAR@", near)
            for near, leg in blocks.legs.items()
        ),
        solve_pose(kernel.about_tip),
        singular.FUNCTION,
        _BOUND,
        _CONDITION,
        _function(_SHARED_ERRORS, *blocks.shared_errors()),
        *(
            _function(_LEG_ERRORS, *blocks.leg_errors(leg)).replace("@NEAR@", near)
            for near, leg in blocks.legs.items()
        ),
        _POSE,
        _PUBLIC,
    ]
    return "\n".join(parts).replace("@NAME@", kernel.formulation.kernel_name)


def model_numbers(kernel: ForceKernel) -> int:
    """How many numbers ``stewart_<kernel>_bounds_model`` holds."""
    blocks = _Blocks(kernel)
    leg = _numbers(blocks.prepare_leg, kernel.leg_constants())
    return 6 * leg + _numbers(blocks.prepare_platform, blocks.kernel.platform_constants()) + 2


# ---------------------------------------------------------------- the blocks


class _Blocks:
    """The kernel's blocks with their errors: exact are the robot's and the motion's numbers but R."""

    def __init__(self, kernel: ForceKernel) -> None:
        if not kernel.about_tip or kernel.leg_near_pole is None:
            raise ValueError("kernel: expected one with moments about platform point 1 and universal joints")
        kernel = kernel.whole()
        self.kernel = kernel
        # R stands for the rotation nearest to it; one bound for all its entries.
        R = dict.fromkeys(n.R.names, error_symbol(n.R.name))
        self.prepare_leg = rounded(kernel.prepare_leg, {})
        self.prepare_platform = rounded(kernel.prepare_platform, component_errors(ADDED))
        constants = component_errors(
            out.quantity
            for block in (self.prepare_leg, self.prepare_platform)
            for out in block.block.outputs
            if block.inexact(out.quantity)
        )
        self.shared = rounded(kernel.shared, R | constants)
        inexact = R | constants | component_errors((B, q_1))
        # By the ending of the functions' names: away from the joint singularity and near it.
        self.legs = {
            end: rounded(leg, inexact)
            for end, leg in (("", kernel.leg), ("_near_singularity", kernel.leg_near_pole))
            if leg is not None
        }

    def structs(self) -> dict[str, list[str]]:
        """Members of the structs."""
        return {
            "@ADDED@": [f"    stewart_real {q.name}{dims(q)}, {q.name}_err{dims(q)};" for q in ADDED],
            "@SHARED@": _members(self.shared, [out.quantity for out in self.kernel.shared.outputs]),
            "@TERMS@": _members(self.legs[""], _ERRING),
            "@SLOPES@": [
                f"    stewart_real {q.name}{dims(q)}, {q.name}_err{dims(q)};" for q in _LEGS_SLOPES.values()
            ],
        }

    def pose_owner(self, quantity: Quantity) -> str:
        """Pointer through which the functions of a pose read an input."""
        if quantity in n.MOTION:
            return "at"
        if quantity in (out.quantity for out in self.kernel.shared.outputs):
            return "shared"
        return "platform" if quantity in self.kernel.platform_constants() else "leg"

    def leg_errors(self, leg: RoundedBlock) -> tuple[list[str], list[str]]:
        """A leg with its errors, and what they do to a force: to D - Y (c - H x), x and Y as found."""
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
        given = (_Y_FORCE, _Y_MOMENT, _Y_ARM, _D_WEIGHT, n.x)
        found = adjoint(leg.block, weights, given, _inexact_inputs(leg))
        outside = {name: found.slopes[name] for q in _LEGS_SLOPES for name in q.names}
        handed = [
            f"        add(&slopes[i].{to.name}[{j}], &slopes[i].{to.name}_err[{j}], "
            f"{infix(outside[name], _SQRT)}, {_only_name(outside[name])}_err);"
            for q, to in _LEGS_SLOPES.items()
            for j, name in enumerate(q.names)
        ]
        return self._with_errors(leg, found, {}, outside, handed)

    def shared_errors(self) -> tuple[list[str], list[str]]:
        """The same of what a pose has for all legs; slopes of the legs are taken up."""
        given = (_Y_FORCE, _Y_MOMENT, *_LEGS_SLOPES.values())
        weights = {n.c_force: -_Y_FORCE.value, c_tip: -_Y_MOMENT.value}
        weights |= {q: _LEGS_SLOPES[q].value for q in (B, q_1)}
        more = dict(zip(n.R.names, _LEGS_SLOPES[n.R].symbols, strict=True))
        found = adjoint(self.shared.block, weights, given, _inexact_inputs(self.shared), more)
        slopes = {name: found.slopes[name] for name in n.R.names}
        handed = [
            f"        slopes[i].R_legs{part}[{j}] = {text};"
            for j, slope in enumerate(slopes.values())
            for part, text in (("", infix(slope, _SQRT)), ("_err", f"{_only_name(slope)}_err"))
        ]
        errors = component_errors(_LEGS_SLOPES.values())
        return self._with_errors(self.shared, found, errors, slopes, handed)

    def _with_errors(
        self,
        block: RoundedBlock,
        found: Adjoint,
        errors: Mapping[str, sp.Expr],
        outside: Container[str],
        more: list[str],
    ) -> tuple[list[str], list[str]]:
        """Lines that run a block with its errors, and lines that weigh these by their slopes.

        errors: of what the slopes are weighed with. outside: inputs whose errors are weighed elsewhere, which
        ``more`` sees to.
        """
        slopes = rounded(found.block, {**block.errors, **errors})
        sources = {name: own for name, own in _sources(block) if name not in outside and name in found.slopes}
        weighed = {name: found.slopes[name] for name in sources}
        inner = replace(slopes, limits=slopes.limits | {_only_name(slope) for slope in weighed.values()})
        whole = replace(block, limits=block.limits | inner.limits)
        once = [
            *_inputs(whole, self.pose_owner),
            *_steps(whole, weighed, _unread(whole, inner)),
            *_stores(block, _erring(block)),
        ]
        terms = [f"{_only_name(weighed[name])}_max*{own}" for name, own in sources.items()]
        ready = {q.name for q in block.block.inputs} | {step.name for step in block.block.steps}
        each = [
            *_inputs(inner, _seed_owner, ready),
            *("    " + line.replace("\n", "\n    ") for line in _steps(inner)),
            wrap(f"        error[i] = error[i] + {' + '.join(terms)};", " " * 12),
            *more,
        ]
        return once, each


_Y_FORCE = Quantity("Y_force", (3,), "1", "row of Y, force columns")
_Y_MOMENT = Quantity("Y_moment", (3,), "1/m", "row of Y, moment columns")
_Y_ARM = Quantity("Y_arm", (3,), "1/m", "the same; 0 for leg 1, whose arm is exactly zero")
_D_WEIGHT = Quantity("D_weight", (), "1", "1 for the leg's own force, 0 for the others")
_LEGS_SLOPES = {q: Quantity(f"{q.name}_legs", q.shape, "", "slope by the legs") for q in (n.R, B, q_1)}
"""What the legs add to the slope of a force along what the pose has for all of them."""


def _raw_owner(quantity: Quantity) -> str:
    if quantity in n.LEG:
        return "leg"
    return "sum" if quantity in ADDED else "robot"


def _seed_owner(quantity: Quantity) -> str:
    """What the loads of a row of Y, of the legs' slopes and of a leg's own numbers read."""
    return "of_legs" if quantity in _LEGS_SLOPES.values() else "row"


def _inexact_inputs(block: RoundedBlock) -> list[str]:
    return [name for q in block.block.inputs for name in q.names if block.errors[name] != 0]


def _sources(block: RoundedBlock) -> list[tuple[str, str]]:
    """Everything that brings an error of its own: its name, and the text of that error."""
    inputs = [(name, str(block.errors[name])) for name in _inexact_inputs(block)]
    return inputs + [(each.step.name, f"{each.step.name}_own") for each in block.steps if each.rounds]


def _unread(block: RoundedBlock, slopes: RoundedBlock) -> set[str]:
    """Steps whose error neither another step, nor a slope, nor a limit, nor anything outside asks for."""
    read = {symbol for each in (*block.steps, *slopes.steps) for symbol in each.carried.free_symbols}
    read |= {block.output_error(expr) for out in _erring(block) for expr in out.exprs}
    names = {each.step.name for each in block.steps if error_symbol(each.step.name) not in read}
    return names - block.limits


def _only_name(slope: sp.Expr) -> str:
    """Name of a slope, which is a symbol or a negated one."""
    (symbol,) = slope.free_symbols
    return str(symbol.name)


def _kept(block: RoundedBlock) -> tuple[Output, ...]:
    return tuple(out for out in block.block.outputs if out.quantity not in JUDGED)


def _erring(block: RoundedBlock) -> tuple[Output, ...]:
    """Outputs whose errors are handed out; that of D is weighed at once."""
    return tuple(out for out in _kept(block) if out.quantity != n.D)


# ---------------------------------------------------------------- layout


def _members(block: RoundedBlock, quantities: Sequence[Quantity], comment: bool = False) -> list[str]:
    """Declarations of values, and of errors where there are any."""
    lines = []
    for q in quantities:
        error = f", {q.name}_err{dims(q)}" if block.inexact(q) else ""
        said = f" /* {q.unit}: {q.meaning} */" if comment else ""
        lines.append(f"    stewart_real {q.name}{dims(q)}{error};{said}")
    return lines


def _numbers(block: RoundedBlock, quantities: tuple[Quantity, ...]) -> int:
    return sum(size(q) * (2 if block.inexact(q) else 1) for q in quantities)


def _zero() -> list[str]:
    return [f"    sum.{name} = 0;" for q in ADDED for part in (q, _error_of(q)) for name in entries([part])]


def _add() -> list[str]:
    pairs = zip(entries(ADDED), entries(map(_error_of, ADDED)), strict=True)
    return [
        f"        add(&sum.{value}, &sum.{error}, found.{value}, found.{error});" for value, error in pairs
    ]


def _error_of(quantity: Quantity) -> Quantity:
    return Quantity(f"{quantity.name}_err", quantity.shape, quantity.unit, "", quantity.symmetric)


# ---------------------------------------------------------------- text of blocks


def _function(text: str, body: list[str], each: Sequence[str] = ()) -> str:
    """The text with its body, arguments that go unused said to be so."""
    unused = [
        f"    (void){name};"
        for name in ("robot", "leg", "sum", "platform", "at", "shared")
        if f" *{name}," in text and not any(f" {name}->" in line for line in body)
    ]
    return filled(text, {"@BODY@": [*unused, *body], "@EACH@": list(each)})


def _values(block: RoundedBlock, owner: Callable[[Quantity], str]) -> list[str]:
    """The block without its errors."""
    used = names_used(block.block)
    inputs = [line for q in block.block.inputs for line in loads(q, owner(q), "", used, "    ")]
    return [*inputs, *step_lines(block.block.steps, "    "), *stores(_kept(block), "", "    ")]


def _status(kernel: ForceKernel, leg: RoundedBlock) -> list[str]:
    """What tells the status of a leg and of the pose."""
    terms = [f"STEWART_FABS({infix(expr, 'STEWART_SQRT')})" for expr in reach_terms(kernel)[0]]
    length, sine = judged(leg.block)
    return [
        wrap_list(f"    const stewart_real terms[{len(terms)}] = {{{', '.join(terms)}}};"),
        f"    out->L = {length};",
        f"    out->sine = {sine};",
        f"    out->reach = largest(terms, {len(terms)}, STEWART_SHORTEST / STEWART_ROUNDING);",
        *(f"    out->arm[{i}] = arm_{axis};" for i, axis in enumerate(AXES)),
    ]


def _inputs(block: RoundedBlock, owner: Callable[[Quantity], str], ready: Container[str] = ()) -> list[str]:
    """Values, errors and largest sizes of the inputs that are read, without those that are ``ready``."""
    used = names_used(block.block) | block.limits
    fresh = [q for q in block.block.inputs if q.name not in ready]
    lines = [line for q in fresh for line in _loads(block, q, owner(q), used)]
    for quantity in fresh:
        parts = [f"{name}_max = {_limit(block, name)}" for name in quantity.names if name in block.limits]
        lines += [wrap_list(f"    const stewart_real {', '.join(parts)};")] if parts else []
    return lines if not ready else ["    " + line.replace("\n", "\n    ") for line in lines]


def _loads(block: RoundedBlock, quantity: Quantity, owner: str, used: Container[str]) -> list[str]:
    member = raw_member(quantity, owner)
    values, errors = [], []
    for i, name in enumerate(quantity.names):
        index = f"[{i}]" if quantity.shape else ""
        if name in used:
            values.append(f"{name} = {owner}->{member}{index}")
            if block.errors[name] == error_symbol(name):
                errors.append(f"{name}_err = {owner}->{member}_err{index}")
    return [wrap_list(f"    const stewart_real {', '.join(parts)};") for parts in (values, errors) if parts]


def _limit(block: RoundedBlock, name: str) -> str:
    error = block.errors[name]
    return f"STEWART_FABS({name})" + (f" + {error}" if error != 0 else "")


def _steps(block: RoundedBlock, apart: Container[str] = (), unread: Container[str] = ()) -> list[str]:
    """Each step: its value, the bound of its error, and its largest size where that is needed.

    apart: steps whose own rounding gets a name. unread: steps whose whole error nobody asks for.
    """
    lines, before = [], None
    for each in block.steps:
        step = each.step
        said = (step.equation, step.meaning)
        if any(said) and said != before:
            lines.append(f"    /* {' '.join(part for part in said if part)} */")
        before = said
        lines.append(_constant(step.name, infix(step.expr, _SQRT)))
        own = _own_error(each)
        if each.rounds and step.name in apart:
            lines.append(_constant(f"{step.name}_own", own))
            own = f"{step.name}_own"
        if not each.exact and step.name not in unread:
            lines.append(_constant(f"{step.name}_err", _error(each, own)))
        if step.name in block.limits:
            lines.append(_constant(f"{step.name}_max", _limit(block, step.name)))
    return lines


def _constant(name: str, text: str) -> str:
    return wrap(f"    const stewart_real {name} = {text};", " " * 8)


def _own_error(each: RoundedStep) -> str:
    """What the step's own operations round away."""
    name = each.step.name
    sizes = [infix(each.rounded, _SQRT)] if each.rounded != 0 else []
    if each.kind == ROOT:
        return f"root_error({name}, {_units(sizes)})"
    return _units([*sizes, f"STEWART_FABS({name})"] if each.own else sizes)


def _units(sizes: list[str]) -> str:
    total = " + ".join(sizes)
    return f"STEWART_UNIT*({total})" if "+" in total else f"STEWART_UNIT*{total}" if total else "0"


def _error(each: RoundedStep, own: str) -> str:
    """The bound as text: errors of what goes in, and the step's own."""
    name = each.step.name
    carried = [infix(each.carried, _SQRT)] if each.carried != 0 else []
    if each.kind == RECIPROCAL:
        return f"reciprocal_error({name}, {each.step.expr.base}, {carried[0] if carried else 0})"
    if each.kind == ROOT:
        argument = [*carried, _units([infix(each.rounded, _SQRT)])] if each.rounded != 0 else carried
        return f"root_error({name}, {' + '.join(argument) or 0})"
    return " + ".join([*carried, own] if each.rounds else carried)


def _stores(block: RoundedBlock, outputs: Sequence[Output]) -> list[str]:
    """Values and errors handed out."""
    lines = []
    for out in outputs:
        target = "sum" if out.quantity in ADDED else "out"
        for i, expr in enumerate(out.exprs):
            index = f"[{i}]" if out.quantity.shape else ""
            lines.append(f"    {target}->{out.quantity.name}{index} = {infix(expr, _SQRT)};")
            if block.inexact(out.quantity) or out.quantity in ADDED:
                error = infix(block.output_error(expr), _SQRT)
                lines.append(f"    {target}->{out.quantity.name}_err{index} = {error};")
    return lines


_HEADER = """\
/* stewart_@NAME@_bounds.h: the actuator forces with a bound of their rounding error.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * The forces are those of stewart_@NAME@_forces.h, operation for operation: the same to the last bit with
 * -ffp-contract=off. The bound is rigorous: the rounding of every operation is counted, in all orders, and so
 * are the bound's own. It holds for arithmetic that rounds to nearest, or fuses products into sums, short of
 * overflow and underflow; not with -ffast-math. It takes far longer than the forces.
 *
 * What is bounded is the distance of F from the exact forces of the given numbers, where R stands for the
 * rotation nearest to it: how far R is from being one counts, no other doubt about the inputs does.
 */
#ifndef @GUARD@
#define @GUARD@

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Constants of one leg; `_err`: bound of the error of what stands before it. */
typedef struct {
@LEG@
} stewart_@NAME@_bounds_leg;

/* Constants of the platform. */
typedef struct {
@PLATFORM@
} stewart_@NAME@_bounds_platform;

/* A robot's constants, prepared once. */
typedef struct {
    stewart_@NAME@_bounds_leg leg[6];
    stewart_@NAME@_bounds_platform platform;
    stewart_real length; /* m: root mean square distance of the platform points from the reference point */
@SCALE@
} stewart_@NAME@_bounds_model;

/* Prepares the constants; k may have any length but zero. Returns a status: STEWART_NOT_FINITE
 * if a number of the robot is not finite or too large, or k is zero; the model is written only if it is
 * STEWART_OK. */
STEWART_NODISCARD int stewart_@NAME@_bounds_prepare(
    const stewart_robot *robot, stewart_@NAME@_bounds_model *model);

/* Actuator forces F, N, of one pose, (37), with `bound`, N: no force is farther from the exact one. A bound
 * is infinite where H is so near to singular that none can be had in this arithmetic. `rcond`: reciprocal
 * condition of H, 1/(|H| |1/H|) in the norm of largest column sums, moments about the reference point over
 * the model's length; 1 is best, near STEWART_EPSILON nothing is left of the digits. `bound` and `rcond` may
 * be null: not wanted. Returns a status; the outputs are written only if it is STEWART_OK. */
STEWART_NODISCARD int stewart_@NAME@_forces_bounded(
    const stewart_@NAME@_bounds_model *model, const stewart_motion *motion, stewart_real F[6],
    stewart_real bound[6], stewart_real *rcond);

/* The same for `count` poses: F[count][6], bound[count][6], rcond[count]. `status` takes one code for each
 * pose; null: not wanted. Returns the first code other than STEWART_OK, or STEWART_OK. */
STEWART_NODISCARD int stewart_@NAME@_forces_bounded_batch(
    const stewart_@NAME@_bounds_model *model, size_t count, const stewart_motions *motions, stewart_real *F,
    stewart_real *bound, stewart_real *rcond, int *status);

#ifdef __cplusplus
}
#endif

#endif
"""

_TOP = """\
/* stewart_@NAME@_bounds.c: see stewart_@NAME@_bounds.h.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * Of each quantity x the code below may keep
 *     x_err, which bounds its error;
 *     x_own, which bounds what of it comes from computing x, the errors of what x is made of apart;
 *     x_max = |x| + x_err, which bounds the size of x and of its true value;
 *     x_bar, the slope of an actuator force along x, with all that is made of x.
 * Forward goes x_err, which has to be taken for the worst at every step; it is coarse, and it serves to bound
 * the slopes. Backward go these, and the force errs by no more than all x_own, each times its slope at its
 * largest: the mean value theorem, over the segment from the computed to the exact values.
 */
#include "stewart_@NAME@_bounds.h"

#include <math.h>

"""

_MACROS = """
#define STEWART_INFINITY ((stewart_real)INFINITY)

/* Half an epsilon is the largest relative error of an operation. A 64th more makes up for what the bounds
 * lose by their own roundings and by sizes that are rounded themselves, a few thousand operations deep. */
#define STEWART_UNIT (STEWART_EPSILON * (stewart_real)0.5078125)
#define STEWART_SLACK ((stewart_real)1.015625)
"""

_ERRORS = """\
/* A lower limit of the size of what `value` stands for; 0, and so no bound, where half of it may be wrong. */
static stewart_real least(stewart_real value, stewart_real error)
{
    const stewart_real positive = STEWART_FABS(value);
    return error <= STEWART_HALF * positive ? positive - error : 0;
}

/* Of a square root whose argument errs by `error`: |sqrt(a) - r| <= error / (2 r - error / r), r = root. */
static stewart_real root_error(stewart_real root, stewart_real error)
{
    return error / least(2 * root, error / root) + STEWART_UNIT * root;
}

/* Of inverse = 1 / of, where `of` errs by `error`. */
static stewart_real reciprocal_error(stewart_real inverse, stewart_real of, stewart_real error)
{
    const stewart_real positive = STEWART_FABS(inverse);
    return positive * (error / least(of, error)) + STEWART_UNIT * positive;
}

/* Adds a term that errs to a sum that errs. */
static void add(stewart_real *sum, stewart_real *sum_err, stewart_real term, stewart_real term_err)
{
    *sum = *sum + term;
    *sum_err = *sum_err + term_err + STEWART_UNIT * STEWART_FABS(*sum);
}

/* Bounds the sizes of R^T R - 1, in `stretch`, and the entries of R less the rotation nearest to it, by the
 * largest distance of a singular value from 1: half of the norm of row sums, with a 64th more for the terms
 * of higher order. Entries of R are multiples of `grid` and a rest: products of the multiples have no
 * rounding error, nor has their sum less 1. */
static stewart_real rotation_error(const stewart_real R[9], stewart_real stretch[9])
{
    stewart_real high[9], low[9], grid = 1, worst = 0;
    int i, j, k;
    while (STEWART_HALF * grid * STEWART_HALF * grid >= STEWART_EPSILON) {
        grid = STEWART_HALF * grid;
    }
    for (i = 0; i < 9; ++i) {
        const stewart_real shift = (stewart_real)1.5 * (grid / STEWART_EPSILON);
        high[i] = (R[i] + shift) - shift;
        low[i] = R[i] - high[i];
    }
    for (i = 0; i < 3; ++i) {
        stewart_real row = 0;
        for (j = 0; j < 3; ++j) {
            stewart_real sum = i == j ? -1 : 0, rest = 0, sizes = 0;
            for (k = 0; k < 9; k += 3) {
                const stewart_real small = high[k + i] * low[k + j] + low[k + i] * R[k + j];
                sum = sum + high[k + i] * high[k + j];
                rest = rest + small;
                sizes = sizes + STEWART_FABS(high[k + i] * low[k + j]) + STEWART_FABS(low[k + i] * R[k + j]);
            }
            sum = sum + rest;
            stretch[3 * i + j] = STEWART_FABS(sum) + STEWART_UNIT * (5 * sizes + STEWART_FABS(sum));
            row = row + stretch[3 * i + j];
        }
        worst = row > worst ? row : worst;
    }
    return worst <= (stewart_real)0.0078125 ? STEWART_HALF * STEWART_SLACK * worst : STEWART_INFINITY;
}
"""

_STRUCTS = """\
/* What a leg adds to the platform, and the sum of it. */
typedef struct {
@ADDED@
} added_terms;

/* What a pose has for all legs. */
typedef struct {
@SHARED@
} shared_terms;

/* What a leg gives to the platform's equations. */
typedef struct {
    stewart_real D, L;
    stewart_real sine; /* of the angle between the leg and the fixed axis */
    stewart_real reach, arm[3]; /* size of what the leg vector is the sum of; arm of its moment */
@TERMS@
} leg_terms;

/* The platform's equations H x = c, moments about platform point 1; c_own: what the sums in c round
 * away. */
typedef struct {
    stewart_real H[6][6], H_err[6][6];
    stewart_real c[6], c_err[6], c_own[6];
    stewart_real L[6], reach[6], arm[6][3]; /* of the legs */
    int near, close; /* whether a leg is near its joint singularity, or short beside what it is the sum of */
} platform_equations;

/* How a force hangs on D, on c and on the column of H of one leg: D_weight D - Y (c - H x). */
typedef struct {
    stewart_real Y_force[3], Y_moment[3]; /* its row of the inverse of H */
    stewart_real Y_arm[3]; /* Y_moment, but 0 for leg 1: its force has no moment about platform point 1 */
    stewart_real D_weight, x;
} force_row;

/* Slope of a force along what the pose has for all legs, as far as it goes through the legs. */
typedef struct {
@SLOPES@
} slopes_of_legs;
"""

_PREPARE_LEG = """\
/* Constants of one leg, and what it adds to the platform. */
static void prepare_leg(
    const stewart_robot *robot, const stewart_leg *leg, stewart_@NAME@_bounds_leg *out, added_terms *sum)
{
@BODY@
}
"""

_PREPARE_PLATFORM = """\
/* Constants of the platform. */
static void prepare_platform(
    const stewart_robot *robot, const added_terms *sum, stewart_@NAME@_bounds_platform *out)
{
@BODY@
}
"""

_PREPARE = """\
int stewart_@NAME@_bounds_prepare(const stewart_robot *robot, stewart_@NAME@_bounds_model *model)
{
    stewart_@NAME@_bounds_model made;
    added_terms found, sum;
    stewart_real squares = 0;
    int i, j;
    if (!robot || !model) {
        return STEWART_BAD_ARGUMENT;
    }
@ZERO@
    for (i = 0; i < 6; ++i) {
        prepare_leg(robot, &robot->leg[i], &made.leg[i], &found);
@ADD@
        for (j = 0; j < 3; ++j) {
            squares = squares + robot->leg[i].p[j] * robot->leg[i].p[j];
        }
    }
    prepare_platform(robot, &sum, &made.platform);
    made.length = STEWART_SQRT(squares / 6);
@SCALE@
    if (!is_finite((const stewart_real *)&made, (int)(sizeof made / sizeof made.length))) {
        return STEWART_NOT_FINITE;
    }
    *model = made;
    return STEWART_OK;
}
"""

_SHARED = """\
/* What one pose has for all legs. */
static void shared_of_pose(
    const stewart_@NAME@_bounds_platform *platform, const stewart_motions *at, shared_terms *out)
{
@BODY@
}
"""

_LEG_STATUS = """\
/* The largest of some numbers and `least`. */
static stewart_real largest(const stewart_real *values, int count, stewart_real least)
{
    stewart_real found = least;
    int i;
    for (i = 0; i < count; ++i) {
        found = STEWART_LARGER(values[i], found);
    }
    return found;
}

/* The leg vector is known to within rounding of its largest term, `reach`. */
static int leg_status(const leg_terms *leg)
{
    if (!(leg->L <= STEWART_MAX)) {
        return STEWART_NOT_FINITE;
    }
    if (!(leg->L > STEWART_ROUNDING * leg->reach)) {
        return STEWART_SHORT_LEG;
    }
    return leg->sine > STEWART_POLE_SINE ? STEWART_OK : STEWART_POLE;
}
"""

_LEG = """\
/* One leg in joint coordinates: D, its column of H and its part of c. */
static void leg_of_pose@NEAR@(
    const stewart_@NAME@_bounds_platform *platform, const stewart_@NAME@_bounds_leg *leg,
    const stewart_motions *at, const shared_terms *shared, leg_terms *out)
{
@BODY@
}
"""

_SHARED_ERRORS = """\
/* What one pose has for all legs, with errors; R_err: how far R is from a rotation. Where there are slopes of
 * the legs, adds to the error of each force what these errors do to it, each by the slope of the force along
 * it, at its largest; and adds to the slopes along R. */
static void shared_errors(
    const stewart_@NAME@_bounds_platform *platform, const stewart_motions *at, stewart_real R_err,
    const force_row rows[6], slopes_of_legs *slopes, stewart_real error[6], shared_terms *out)
{
    int i;
@BODY@
    for (i = 0; slopes && i < 6; ++i) {
        const force_row *row = &rows[i];
        const slopes_of_legs *of_legs = &slopes[i];
@EACH@
    }
}
"""

_LEG_ERRORS = """\
/* One leg with its errors. Adds to the error of each force what they do to it, and to its slopes along what
 * the pose has for all legs. */
static void leg_errors@NEAR@(
    const stewart_@NAME@_bounds_platform *platform, const stewart_@NAME@_bounds_leg *leg,
    const stewart_motions *at, const shared_terms *shared, stewart_real R_err, const force_row rows[6],
    slopes_of_legs slopes[6], stewart_real error[6], leg_terms *out)
{
    int i;
@BODY@
    for (i = 0; i < 6; ++i) {
        const force_row *row = &rows[i];
@EACH@
    }
}
"""

_BOUND = """\
/* Bounds what R does to a force by not being a rotation. R less the nearest one is R (E / 2 - 3 E^2 / 8 +
 * ...) with E = R^T R - 1, which is symmetric, so that of the force's slopes along R only the symmetric part
 * of R^T times them counts; turning R as a whole is no error. */
static stewart_real stretch_error(
    const stewart_real R[9], const stewart_real stretch[9], stewart_real R_err, const slopes_of_legs *of)
{
    stewart_real total = 0, slopes = 0;
    int i, j, k;
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 3; ++j) {
            stewart_real sum = 0, doubt = 0;
            for (k = 0; k < 9; k += 3) {
                const stewart_real one = R[k + i] * of->R_legs[k + j], other = R[k + j] * of->R_legs[k + i];
                sum = sum + (one + other);
                doubt = doubt + 5 * STEWART_UNIT * (STEWART_FABS(one) + STEWART_FABS(other));
                doubt = doubt + STEWART_FABS(R[k + i]) * of->R_legs_err[k + j];
                doubt = doubt + STEWART_FABS(R[k + j]) * of->R_legs_err[k + i];
            }
            total = total + stretch[3 * i + j] * (STEWART_FABS(sum) + doubt) / 4;
            slopes = slopes + STEWART_FABS(of->R_legs[3 * i + j]) + of->R_legs_err[3 * i + j];
        }
    }
    return total + 2 * R_err * R_err * slopes;
}

/* Bounds what is left of the error of x = Y c when the errors of H and c have been weighed by Y: adds it to
 * `error`. With E_H and e_c bounding these errors, and d the error of x in sizes,
 *     d <= b + G d,    b = |Y| (|c - H x| + E_H |x| + e_c),    G = |1 - Y H| + |Y| E_H,
 * and where G b <= beta b with beta < 1, H is regular and d <= b / (1 - beta) (Rump, Verification methods,
 * Acta Numerica 19 (2010), 10); what is left is |Y| |c - H x| + G d. Where there is no such beta, it is
 * infinite. Sums of seven terms round seven times at most. */
static void solution_error(
    const platform_equations *of, const stewart_real x[6], stewart_real Y[6][6], stewart_real error[6])
{
    stewart_real rest[6], doubt[6], b[6], G[6][6], worst = 0;
    int i, j, k;
    for (i = 0; i < 6; ++i) {
        stewart_real sum = of->c[i], sizes = STEWART_FABS(of->c[i]);
        doubt[i] = of->c_err[i];
        for (j = 0; j < 6; ++j) {
            const stewart_real product = of->H[i][j] * x[j];
            sum = sum - product;
            sizes = sizes + STEWART_FABS(product);
            doubt[i] = doubt[i] + of->H_err[i][j] * STEWART_FABS(x[j]);
        }
        rest[i] = STEWART_FABS(sum) + 7 * STEWART_UNIT * sizes + of->c_own[i];
    }
    for (i = 0; i < 6; ++i) {
        b[i] = 4 / STEWART_MAX; /* so that no entry is zero */
        for (j = 0; j < 6; ++j) {
            b[i] = b[i] + STEWART_FABS(Y[i][j]) * (rest[j] + doubt[j]);
            error[i] = error[i] + STEWART_FABS(Y[i][j]) * rest[j];
        }
    }
    for (i = 0; i < 6; ++i) {
        stewart_real grown = 0;
        for (k = 0; k < 6; ++k) {
            stewart_real sum = i == k ? 1 : 0, sizes = sum, carried = 0;
            for (j = 0; j < 6; ++j) {
                const stewart_real product = Y[i][j] * of->H[j][k];
                sum = sum - product;
                sizes = sizes + STEWART_FABS(product);
                carried = carried + STEWART_FABS(Y[i][j]) * of->H_err[j][k];
            }
            G[i][k] = STEWART_FABS(sum) + carried + 7 * STEWART_UNIT * sizes;
            grown = grown + G[i][k] * b[k];
        }
        worst = grown / b[i] <= worst ? worst : grown / b[i];
    }
    for (i = 0; i < 6; ++i) {
        for (k = 0; k < 6; ++k) {
            error[i] = error[i] + G[i][k] * (b[k] / (1 - worst));
        }
        if (!(worst <= (stewart_real)0.875)) {
            error[i] = STEWART_INFINITY;
        }
    }
}
"""

_CONDITION = """\
/* Largest sum of a column in sizes. */
static stewart_real norm(stewart_real A[6][6])
{
    stewart_real worst = 0;
    int i, j;
    for (j = 0; j < 6; ++j) {
        stewart_real sum = 0;
        for (i = 0; i < 6; ++i) {
            sum = sum + STEWART_FABS(A[i][j]);
        }
        worst = sum > worst ? sum : worst;
    }
    return worst;
}

/* 1/(|H| |Y|), moments moved from platform point 1, q away, to the reference point, measured by `length`. */
static stewart_real reciprocal_condition(
    stewart_real H[6][6], stewart_real Y[6][6], const stewart_real q[3], stewart_real length)
{
    stewart_real A[6][6], B[6][6];
    int i, j;
    for (j = 0; j < 3; ++j) {
        const int next = (j + 1) % 3, last = (j + 2) % 3;
        for (i = 0; i < 6; ++i) {
            A[j][i] = H[j][i];
            A[j + 3][i] = (H[j + 3][i] + (q[next] * H[last][i] - q[last] * H[next][i])) / length;
            B[i][j] = Y[i][j] - (Y[i][3 + next] * q[last] - Y[i][3 + last] * q[next]);
            B[i][j + 3] = Y[i][j + 3] * length;
        }
    }
    return 1 / norm(A) / norm(B);
}
"""

_POSE = """\
/* The legs and the platform of one pose: D and the platform's equations. `near`: with the legs' code path
 * near the joint singularity, legs having been found to be neither at it nor too short. */
static int equations_of_pose(
    const stewart_@NAME@_bounds_model *model, const stewart_motions *at, const shared_terms *shared,
    int near, stewart_real D[6], platform_equations *out)
{
    leg_terms leg;
    int i, j;
    out->near = near;
    out->close = near != 0 ? out->close : 0;
    for (j = 0; j < 3; ++j) {
        out->c[j] = shared->c_force[j];
        out->c[j + 3] = shared->c_tip[j];
        out->c_own[j] = 0;
        out->c_own[j + 3] = 0;
    }
    for (i = 0; i < 6; ++i) {
        (near != 0 ? leg_of_pose_near_singularity : leg_of_pose)(
            &model->platform, &model->leg[i], at, shared, &leg);
        if (near == 0) {
            const int status = leg_status(&leg);
            if (status != STEWART_OK) {
                return status;
            }
            out->near = leg.sine > STEWART_NEAR_POLE ? out->near : 1;
            out->close = leg.L > STEWART_SHORT_SHARE * leg.reach ? out->close : 1;
        }
        D[i] = leg.D;
        out->L[i] = leg.L;
        out->reach[i] = leg.reach;
        for (j = 0; j < 3; ++j) {
            out->arm[i][j] = leg.arm[j];
            out->H[j][i] = leg.H_force[j];
            out->H[j + 3][i] = i > 0 ? leg.H_moment[j] : 0;
            add(&out->c[j], &out->c_own[j], leg.c_force[j], 0);
            add(&out->c[j + 3], &out->c_own[j + 3], leg.c_moment[j], 0);
            if (i > 0) {
                add(&out->c[j + 3], &out->c_own[j + 3], leg.arm_c[j], 0);
            }
        }
    }
    return STEWART_OK;
}

/* Status of the platform's equations; suspect: whether a pivot is small. */
static int pose_status(const platform_equations *of, int suspect)
{
    stewart_real H[6][6], arm[6][3];
    int i, j;
    if (of->close == 0 && suspect == 0) {
        return STEWART_OK;
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            H[i][j] = of->H[i][j];
        }
        for (j = 0; j < 3; ++j) {
            arm[i][j] = of->arm[i][j];
        }
    }
    return singular_status(H, arm, of->L, of->reach);
}

/* x, and the inverse Y of H, by the elimination of the force kernel. Returns 1 for a small pivot, else 0. */
static int solution(
    const platform_equations *of, stewart_real per_length, stewart_real x[6], stewart_real Y[6][6])
{
    int column, i, j, suspect = 0;
    for (column = 0; column < 7; ++column) {
        stewart_real A[6][LANES], found[6];
        for (i = 0; i < 6; ++i) {
            const stewart_real unit = i < 3 ? 1 : per_length;
            for (j = 0; j < 6; ++j) {
                A[i][j] = unit * of->H[i][j];
            }
            A[i][6] = column < 6 ? (i == column ? unit : 0) : unit * of->c[i];
            A[i][7] = 0;
        }
        suspect = solve_pose(A, found);
        for (i = 0; i < 6; ++i) {
            *(column < 6 ? &Y[i][column] : &x[i]) = found[i];
        }
    }
    return suspect;
}

/* Bounds the errors of the forces D - x: those of D, c and H as they reach the forces, that of the solution,
 * and that of the difference. Completes the errors of the platform's equations. */
static void bound_of_pose(
    const stewart_@NAME@_bounds_model *model, const stewart_motions *at, const stewart_real x[6],
    stewart_real Y[6][6], const stewart_real F[6], platform_equations *of, stewart_real bound[6])
{
    shared_terms shared;
    leg_terms leg;
    force_row rows[6];
    slopes_of_legs slopes[6];
    stewart_real *numbers = (stewart_real *)slopes;
    stewart_real stretch[9];
    const stewart_real R_err = rotation_error(at->R, stretch);
    size_t number;
    int i, j, k;
    for (number = 0; number < 6 * (sizeof(slopes_of_legs) / sizeof(stewart_real)); ++number) {
        numbers[number] = 0;
    }
    for (i = 0; i < 6; ++i) {
        bound[i] = 0;
        for (j = 0; j < 3; ++j) {
            rows[i].Y_force[j] = Y[i][j];
            rows[i].Y_moment[j] = Y[i][j + 3];
        }
    }
    shared_errors(&model->platform, at, R_err, rows, NULL, bound, &shared);
    for (j = 0; j < 3; ++j) {
        of->c_err[j] = shared.c_force_err[j];
        of->c_err[j + 3] = shared.c_tip_err[j];
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            rows[j].D_weight = i == j ? 1 : 0;
            rows[j].x = x[i];
            for (k = 0; k < 3; ++k) {
                rows[j].Y_arm[k] = i > 0 ? rows[j].Y_moment[k] : 0;
            }
        }
        (of->near != 0 ? leg_errors_near_singularity : leg_errors)(
            &model->platform, &model->leg[i], at, &shared, R_err, rows, slopes, bound, &leg);
        for (j = 0; j < 3; ++j) {
            of->H_err[j][i] = leg.H_force_err[j];
            of->H_err[j + 3][i] = i > 0 ? leg.H_moment_err[j] : 0;
            of->c_err[j] = of->c_err[j] + leg.c_force_err[j];
            of->c_err[j + 3] = of->c_err[j + 3] + leg.c_moment_err[j] + (i > 0 ? leg.arm_c_err[j] : 0);
        }
    }
    shared_errors(&model->platform, at, R_err, rows, slopes, bound, &shared);
    for (i = 0; i < 6; ++i) {
        bound[i] = bound[i] + stretch_error(at->R, stretch, R_err, &slopes[i]);
    }
    solution_error(of, x, Y, bound);
    for (i = 0; i < 6; ++i) {
        bound[i] = STEWART_SLACK * (bound[i] + STEWART_UNIT * STEWART_FABS(F[i]));
        if (!(bound[i] <= STEWART_MAX)) {
            bound[i] = STEWART_INFINITY;
        }
    }
}

/* Forces, bound and reciprocal condition of one pose; the last two may be null. */
static int forces_of_pose(
    const stewart_@NAME@_bounds_model *model, const stewart_motions *at, stewart_real F[6],
    stewart_real *bound, stewart_real *rcond)
{
    shared_terms shared;
    platform_equations equations;
    stewart_real Y[6][6], x[6], D[6], found[6];
    int i, status;
    shared_of_pose(&model->platform, at, &shared);
    status = equations_of_pose(model, at, &shared, 0, D, &equations);
    if (status == STEWART_OK && equations.near != 0) {
        status = equations_of_pose(model, at, &shared, 1, D, &equations);
    }
    if (status == STEWART_OK) {
        status = pose_status(&equations, solution(&equations, model->per_length, x, Y));
    }
    if (status != STEWART_OK) {
        return status;
    }
    for (i = 0; i < 6; ++i) {
        found[i] = D[i] - x[i];
    }
    if (!is_finite(found, 6)) {
        return STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        F[i] = found[i];
    }
    if (bound) {
        bound_of_pose(model, at, x, Y, F, &equations, bound);
    }
    if (rcond) {
        *rcond = reciprocal_condition(equations.H, Y, shared.q_1, model->length);
    }
    return STEWART_OK;
}
"""

_PUBLIC = """\
int stewart_@NAME@_forces_bounded(
    const stewart_@NAME@_bounds_model *model, const stewart_motion *motion, stewart_real F[6],
    stewart_real bound[6], stewart_real *rcond)
{
    stewart_motions at;
    if (!model || !motion || !F) {
        return STEWART_BAD_ARGUMENT;
    }
    at.R = motion->R;
    at.t = motion->t;
    at.omega = motion->omega;
    at.v = motion->v;
    at.alpha = motion->alpha;
    at.a = motion->a;
    at.F_ext = motion->F_ext;
    at.M_ext = motion->M_ext;
    return forces_of_pose(model, &at, F, bound, rcond);
}

static const stewart_real no_load[3] = {0, 0, 0};

int stewart_@NAME@_forces_bounded_batch(
    const stewart_@NAME@_bounds_model *model, size_t count, const stewart_motions *motions, stewart_real *F,
    stewart_real *bound, stewart_real *rcond, int *status)
{
    size_t pose;
    int result = STEWART_OK;
    if (!model || !motions || !F || !motions->R || !motions->t || !motions->omega || !motions->v
        || !motions->alpha || !motions->a) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        stewart_motions at;
        int code;
        at.R = motions->R + 9 * pose;
        at.t = motions->t + 3 * pose;
        at.omega = motions->omega + 3 * pose;
        at.v = motions->v + 3 * pose;
        at.alpha = motions->alpha + 3 * pose;
        at.a = motions->a + 3 * pose;
        at.F_ext = motions->F_ext ? motions->F_ext + 3 * pose : no_load;
        at.M_ext = motions->M_ext ? motions->M_ext + 3 * pose : no_load;
        code = forces_of_pose(
            model, &at, F + 6 * pose, bound ? bound + 6 * pose : NULL, rcond ? rcond + pose : NULL);
        if (status) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}
"""
