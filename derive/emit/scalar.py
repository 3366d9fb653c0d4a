"""C99 for controllers: one pose, one leg after the other, small in code and stack.

Stands beside ``lanes``, which is for processors with vector registers; prints the same blocks for those
without. The model is prepared once, or its numbers are folded in. Knows layout and solving, no dynamics.
"""

import re
from collections.abc import Iterable

import sympy as sp

from .. import notation as n
from ..block import Block, Quantity, Step, rebuilt
from ..operations import force_operations
from ..prepared import ADDED, arm_c, q_1
from ..regroup import ForceKernel, joined
from . import singular
from .c import ARITHMETIC, operations_table, step_lines, wrap_list
from .infix import infix, wrap
from .lane_scale import IS_SCALED, LEAST_PIVOTS, MEMBER_OF_POSE, PREPARED_OF_POSE, SIZE_BY_LEGS, per_length
from .lane_text import dims, entries, filled, literal_macro, literal_macros, loads, names_used, stores
from .lanes import is_scaled, prepare_function

SQRT = "STEWART_SQRT"
_RIGHT_SIDE = (n.c_force, n.c_moment)


def header(kernel: ForceKernel, before: ForceKernel | None, version: str) -> str:
    """``stewart_<kernel>_pose.h``; before: of a baked kernel, the one without its numbers."""
    folded = ""
    if before is not None:
        count = force_operations(before, product=True).total.total
        folded = f" The machine's numbers are folded in; without, a pose took {count} operations."
    model = "" if before is not None else _MODEL
    parts = {
        "@SCALE@": [MEMBER_OF_POSE],
        "@FIDELITY@": [f" * Fidelity: {kernel.meaning or 'everything'}.{folded}"],
        "@OPERATIONS@": [operations_table(force_operations(kernel, product=True), None, " * ")],
        "@MODEL@": [model] if model else [],
        "@LEG@": [_member(q) for q in kernel.leg_constants()],
        "@PLATFORM@": [_member(q) for q in kernel.platform_constants()],
    }
    text = filled(_only(_HEADER, kernel), parts)
    return _named(filled(text, parts), kernel, version)


def source(kernel: ForceKernel, version: str) -> str:
    """``stewart_<kernel>_pose.c``: preparation, unless baked, and one pose."""
    parts = [
        _TOP + ARITHMETIC + _MACROS + singular.MACROS + singular.PRODUCT_MACROS + _least(kernel),
        *_preparation(kernel),
        _shared(kernel),
        _closely(kernel),
        _shift(kernel),
        *_legs(kernel),
        *([_SCALE] if is_scaled(kernel) else []),
        _solve(),
        singular.FUNCTION,
        _only(_STATUS, kernel),
        _pose(kernel),
    ]
    return _named("\n".join(parts), kernel, version)


def _named(text: str, kernel: ForceKernel, version: str) -> str:
    size = "model->size" if kernel.constants is None else f"REAL({kernel.extent!r})"
    marks = {
        "@SIZE@": size,
        "@NAME@": kernel.name,
        "@GUARD@": f"STEWART_{kernel.name.upper()}_POSE_H",
        "@VERSION@": version,
    }
    for mark, value in marks.items():
        text = text.replace(mark, value)
    return text


def _only(text: str, kernel: ForceKernel) -> str:
    """Lines that end in ``//M`` are of kernels with a prepared model, ``//B`` of baked ones, ``//D`` of legs
    with a D, ``//C`` of legs with a part of c."""
    given = {out.quantity for out in kernel.leg.outputs}
    bare = kernel.constants is not None
    kept = {"M": not bare, "B": bare, "D": n.D in given, "C": n.c_force in given}
    kept |= {"S": not bare, "Z": bare and is_scaled(kernel)}
    length = f"REAL({per_length(kernel.size)!r})" if bare else "model->per_length"
    text = text.replace("@IS_SCALED@", IS_SCALED).replace("@PER_LENGTH@", length)
    lines = []
    for line in text.split("\n"):
        body, mark, flag = line.partition(" //")
        if not mark or kept[flag]:
            lines.append(body)
    return "\n".join(lines)


def _member(quantity: Quantity) -> str:
    return f"    stewart_real {quantity.name}{dims(quantity)}; /* {quantity.unit}: {quantity.meaning} */"


# ---------------------------------------------------------------- constants


def _preparation(kernel: ForceKernel) -> list[str]:
    if kernel.constants is not None:
        return [literal_macros(kernel.literals()), _table(kernel)]
    of_leg, of_platform = entries(kernel.leg_constants()), entries(kernel.platform_constants())
    parts = {
        "@COPIES@": [f"        model->leg[i].{name} = found.{name};" for name in of_leg],
        "@HELD@": [f"        lost = lost + (REAL(0) * found.{name});" for name in of_leg],
        "@HELD_PLATFORM@": [f"    lost = lost + (REAL(0) * platform.{name});" for name in of_platform],
        "@ZERO@": [f"    sum->{name} = REAL(0);" for name in entries(ADDED)],
        "@ADD@": [f"        sum.{name} = sum.{name} + found.{name};" for name in entries(ADDED)],
        "@PLATFORM@": [f"    model->{name} = platform.{name};" for name in of_platform],
        "@LENGTH@": [PREPARED_OF_POSE.format(model="model->", address="model")],
    }
    return [
        prepare_function(kernel.prepare_leg, "prepared_leg"),
        prepare_function(kernel.prepare_platform, "prepared_platform"),
        (SIZE_BY_LEGS + LEAST_PIVOTS).replace("@MODEL@", "stewart_@NAME@_pose_model"),
        filled(_PREPARE, parts),
    ]


def _table(kernel: ForceKernel) -> str:
    """What differs from leg to leg in a baked kernel."""
    assert kernel.constants is not None
    tables = {q: kernel.constants[q] for q in kernel.leg_constants()}
    rows = [
        wrap_list(f"    {{{', '.join(f'REAL({values[i]!r})' for values in tables.values())}}},", " " * 5)
        for i in range(6)
    ]
    return filled(_NUMBERS, {"@MEMBERS@": [_member(q) for q in tables], "@ROWS@": rows})


# ---------------------------------------------------------------- blocks


def _shared(kernel: ForceKernel) -> str:
    block = kernel.shared
    used = names_used(block)
    lines = [
        line for q in block.inputs for line in _load(kernel, q, "at" if q in n.MOTION else "model", used)
    ]
    right = {out.quantity: out.exprs for out in block.outputs if out.quantity in _RIGHT_SIDE}
    kept = tuple(out for out in block.outputs if out.quantity not in _RIGHT_SIDE)
    right_side = [expr for q in _RIGHT_SIDE for expr in right.get(q, (sp.Integer(0),) * 3)]
    model = "const stewart_@NAME@_pose_model *model, " if kernel.constants is None else ""
    body = [
        *lines,
        *step_lines(block.steps, "    "),
        *stores(kept, "", "    "),
        *(wrap(f"    A[{i}][6] = {infix(expr, SQRT)};", " " * 8) for i, expr in enumerate(right_side)),
    ]
    parts = {
        "@MEMBERS@": [f"    stewart_real {out.quantity.name}{dims(out.quantity)};" for out in kept],
        "@BODY@": [*_unused(kernel, body, "model", "out"), *body],
    }
    text = _SHARED.replace("@COUNT@", str(block.operations())).replace("@MODEL@", model)
    return filled(text, parts)


def _unused(kernel: ForceKernel, body: list[str], *arguments: str) -> list[str]:
    """Marks for the arguments that the body does not read."""
    given = [name for name in arguments if name != "model" or kernel.constants is None]
    return [f"    (void){name};" for name in given if not any(re.search(rf"\b{name}\b", t) for t in body)]


def _load(kernel: ForceKernel, q: Quantity, owner: str, used: set[str]) -> list[str]:
    if q in kernel.literals():
        return [f"    const stewart_real {q.name} = {literal_macro(q)};"]
    return loads(q, owner, "", used, "    ")


def _closely(kernel: ForceKernel) -> str:
    """What is seldom read: a leg's length, the sizes of the terms that it is the sum of, its column of H."""
    exprs = {out.quantity: out.exprs for out in kernel.leg.outputs}
    # In a baked kernel a coordinate of b that is zero for all legs is none of its inputs.
    around = [q for q in kernel.leg.inputs if q in (n.t, n.b) or q.name in n.b.names]
    block = _columns(kernel)
    used = names_used(block) | {name for quantity in around for name in quantity.names}
    terms = [*exprs[n.q], *(symbol for quantity in around for symbol in quantity.symbols)]
    sizes = [f"STEWART_FABS({infix(term, SQRT)})" for term in terms if term != 0]
    given = {out.quantity: out.exprs for out in block.outputs}
    arms = [f"{infix(e, SQRT)} - q_1_{axis}" for e, axis in zip(given[n.q], "xyz", strict=True)]
    column = [*given[n.H_force], *given[n.H_moment]]
    body = [
        *_leg_loads(kernel, dict.fromkeys((*block.inputs, *around)), used),
        *step_lines(block.steps, "    "),
        "    out->reach = STEWART_SHORTEST / STEWART_ROUNDING;",
        *(wrap(f"    out->reach = STEWART_LARGER({size}, out->reach);", " " * 8) for size in sizes),
        *(f"    out->arm[{i}] = {arm};" for i, arm in enumerate(arms)),
        f"    out->L = {infix(exprs[n.L][0], SQRT)};",
        *(f"    out->column[{i}] = {infix(e, SQRT)};" for i, e in enumerate(column)),
    ]
    body = [line.replace("pose->q_1", "q_1") for line in body]
    body = [*_unused(kernel, body, "model", "leg", "at"), *body]
    return filled(_only(_CLOSELY, kernel), {"@BODY@": body})


def _columns(kernel: ForceKernel) -> Block:
    """A leg's q, length and column of H, moments about platform point 1, and nothing else."""
    leg = joined(kernel.leg, kernel.moments)
    kept = [out for out in leg.outputs if out.quantity in (n.q, n.L, n.H_force, n.H_moment)]
    return rebuilt(leg, leg.steps, kept, leg.inputs)


def _shift(kernel: ForceKernel) -> str:
    """What leg 1 does instead of adding moments."""
    given = {q_1: ("q[{}]", 0), n.c_force: ("A[{}][6]", 0), n.c_moment: ("A[{}][6]", 3)}
    parts = [
        ", ".join(f"{name} = {place.format(i)}" for i, name in enumerate(q.names, first))
        for q, (place, first) in given.items()
    ]
    (moved,) = kernel.shift.outputs
    body = [
        *(wrap_list(f"    const stewart_real {part};", " " * 8) for part in parts),
        *(wrap(f"    A[{i + 3}][6] = {infix(e, SQRT)};", " " * 8) for i, e in enumerate(moved.exprs)),
    ]
    return filled(_SHIFT, {"@BODY@": body})


def _legs(kernel: ForceKernel) -> list[str]:
    """One leg, and the road that it takes near its pole where the kernel has one."""
    if kernel.leg_near_pole is None:
        return [_leg(kernel, kernel.leg, "leg_of", _AT_POLE)]
    given = "leg, at, pose, column, A, known"
    near = f"return leg_near_pole({given if kernel.constants is not None else f'model, {given}'});"
    return [
        _leg(kernel, kernel.leg_near_pole, "leg_near_pole", _AT_POLE),
        _leg(kernel, kernel.leg, "leg_of", near),
    ]


def _leg_loads(kernel: ForceKernel, inputs: Iterable[Quantity], used: set[str]) -> list[str]:
    """Loads of what a leg's block reads."""
    of_pose = [*(out.quantity for out in kernel.shared.outputs), q_1]
    of_legs = kernel.leg_constants()
    lines = []
    for q in inputs:
        owner = "at" if q in n.MOTION else "pose" if q in of_pose else "leg" if q in of_legs else "model"
        lines += _load(kernel, q, owner, used)
    return lines


def _leg(kernel: ForceKernel, own: Block, name: str, at_pole: str) -> str:
    """One leg: its column of H and its D are stored, its part of c is added.

    at_pole: what is done where the sine at the universal joint is too small for this block.
    """
    block = joined(own, kernel.moments)
    exprs = {out.quantity: out.exprs for out in block.outputs}
    near = name == "leg_near_pole"
    column = (*exprs[n.H_force], *exprs[n.H_moment])
    before, after = _parted(own, (*exprs[n.L], *exprs.get(n.k3, ())))
    added = [(i, e) for q, i in ((n.c_force, 0), (n.c_moment, 3), (arm_c, 3)) for e in exprs.get(q, ())]
    body = [
        *_leg_loads(kernel, (q for q in block.inputs if q != q_1), names_used(block)),
        *step_lines(before, "    "),
        *([] if near else _judged_length(kernel, exprs)),
        *_judged_sine(exprs, "STEWART_POLE_SINE" if at_pole == _AT_POLE else "STEWART_NEAR_POLE", at_pole),
        *step_lines(after, "    "),
        "    if (column == 0) {",
        *(wrap(f"        pose->q_1[{i}] = {infix(e, SQRT)};", " " * 12) for i, e in enumerate(exprs[n.q])),
        "        shift_of(pose->q_1, A);",
        "    }",
        *_load(kernel, q_1, "pose", names_used(block)),
        *step_lines(block.steps[len(own.steps) :], "    "),
        *(wrap(f"    A[{i}][column] = {infix(e, SQRT)};", " " * 8) for i, e in enumerate(column)),
        *(
            wrap(f"    A[{i + k % 3}][6] = A[{i + k % 3}][6]{_added(e)};", " " * 8)
            for k, (i, e) in enumerate(added)
        ),
        *(wrap(f"    *known = {infix(expr, SQRT)};", " " * 8) for expr in exprs.get(n.D, ())),
    ]
    body = [*_unused(kernel, body, "model", "leg", "at"), *body]
    count = own.operations() + kernel.moments.operations()
    text = _only(_LEG, kernel).replace("@COUNT@", str(count)).replace("@FUNCTION@", name)
    if near:
        text = re.sub(r",\n    stewart_real least\)", ")", text)
    return filled(text.replace("@APART@", "STEWART_APART " if near else ""), {"@BODY@": body})


def _parted(block: Block, wanted: Iterable[sp.Expr]) -> tuple[tuple[Step, ...], tuple[Step, ...]]:
    """The steps that some expressions need, and the others, each in their order."""
    names = {symbol.name for expr in wanted for symbol in expr.free_symbols}
    before: list[Step] = []
    for step in reversed(block.steps):
        if step.name in names:
            names |= {symbol.name for symbol in step.expr.free_symbols}
            before.insert(0, step)
    return tuple(before), tuple(step for step in block.steps if step not in before)


def _added(expr: sp.Expr) -> str:
    """`` + (expr)``, with the sign drawn out of a product."""
    if not expr.is_Add and expr.could_extract_minus_sign():
        return f" - {infix(-expr, SQRT)}"
    return f" + ({infix(expr, SQRT)})"


def _judged_length(kernel: ForceKernel, exprs: dict[Quantity, tuple[sp.Expr, ...]]) -> list[str]:
    """Out of the function where the leg is not finite or no longer than the rounding of its terms."""
    model = "" if kernel.constants is not None else "model, "
    return [
        f"    if (!({infix(exprs[n.L][0], SQRT)} > least)) {{",
        f"        const int status = short_status({model}leg, at, pose);",
        "        if (status != STEWART_OK) {",
        "            return status;",
        "        }",
        "    }",
    ]


def _judged_sine(exprs: dict[Quantity, tuple[sp.Expr, ...]], least: str, at_pole: str) -> list[str]:
    """What is done where the leg is too near to its pole for this block."""
    if n.k3 not in exprs:
        return []
    length, sine = infix(exprs[n.L][0], SQRT), infix(exprs[n.k3][0], SQRT)
    return [f"    if (!({sine} > {least})) {{", f"        {at_pole.replace('@LENGTH@', length)}", "    }"]


# ---------------------------------------------------------------- solving


def _least(kernel: ForceKernel) -> str:
    """What a product of pivots is compared with."""
    if kernel.constants is None:
        return "\n#define STEWART_LEAST (model->least)\n"
    size = kernel.size * per_length(kernel.size)
    return f"\n#define STEWART_LEAST STEWART_LEAST_PIVOTS(REAL({size!r}))\n"


def _solve() -> str:
    """Elimination on row pointers, unrolled; rows are exchanged by pointer, an upper one is read once."""
    body = []
    for k in range(6):
        below = range(k + 1, 3 if k == 0 else 6)
        body += [f"/* Column {k + 1}. */"]
        body += [f"size = STEWART_FABS(row[{k}][{k}]);"] if below else []
        for i in below:
            body += [f"other = STEWART_FABS(row[{i}][{k}]);", "if (other > size) {"]
            body += ["    size = other;"] if i != below[-1] else []
            body += [f"    lower = row[{i}];", f"    row[{i}] = row[{k}];", f"    row[{k}] = lower;", "}"]
        body += [f"pivots = {'' if k == 0 else 'pivots * '}row[{k}][{k}];"]
        body += [f"inverse = REAL(1) / row[{k}][{k}];", f"row[{k}][{k}] = inverse;"]
        upper = [f"u{j}" for j in range(k + 1, 7)]
        if below:
            body += [f"{name} = row[{k}][{name[1]}];" for name in upper]
        for i in below:
            body += [f"lower = row[{i}];", f"factor = lower[{k}] * inverse;"]
            body += [f"lower[{name[1]}] = lower[{name[1]}] - (factor * {name});" for name in upper]
    for k in reversed(range(6)):
        known = "".join(f" - (row[{k}][{j}] * x[{j}])" for j in range(k + 1, 6))
        body.append(f"x[{k}] = (row[{k}][6]{known}) * row[{k}][{k}];")
    lines = "\n".join(wrap(f"    {line}", " " * 8) for line in body)
    return _SOLVE.replace("@BODY@", lines)


def _pose(kernel: ForceKernel) -> str:
    known = n.D in {out.quantity for out in kernel.leg.outputs}
    forces = [f"    x[{i}] = {f'known[{i}] - x[{i}]' if known else f'-x[{i}]'};" for i in range(6)]
    return filled(_only(_POSE, kernel), {"@FORCES@": forces})


_AT_POLE = "return (@LENGTH@ <= STEWART_MAX) ? STEWART_POLE : STEWART_NOT_FINITE;"

_HEADER = """\
/* stewart_@NAME@_pose.h: the actuator forces of one pose, for processors without vector registers.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
@FIDELITY@
 *
@OPERATIONS@
 */
#ifndef @GUARD@
#define @GUARD@

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

@MODEL@
/* Actuator forces F, N, of one pose, (37). Returns a status; F is written only if it is STEWART_OK. */
STEWART_NODISCARD int stewart_@NAME@_pose_forces( //M
    const stewart_@NAME@_pose_model *model, const stewart_motion *motion, stewart_real F[6]); //M
STEWART_NODISCARD int stewart_@NAME@_pose_forces(const stewart_motion *motion, stewart_real F[6]); //B

#ifdef __cplusplus
}
#endif

#endif
"""

_MODEL = """\
/* Constants of one leg. */
typedef struct {
@LEG@
} stewart_@NAME@_pose_leg;

/* A robot's constants, prepared once. */
typedef struct {
    stewart_@NAME@_pose_leg leg[6];
    stewart_real size; /* m: no platform point and no base point is farther from its origin */
@PLATFORM@
@SCALE@
} stewart_@NAME@_pose_model;

/* Prepares the constants; k may have any length but zero. Returns a status: STEWART_NOT_FINITE
 * if a number of the robot is not finite or too large, or k is zero; the model is written only if it is
 * STEWART_OK. */
STEWART_NODISCARD int stewart_@NAME@_pose_prepare(
    const stewart_robot *robot, stewart_@NAME@_pose_model *model);
"""

_TOP = """\
/* stewart_@NAME@_pose.c: see stewart_@NAME@_pose.h.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_@NAME@_pose.h"

"""

_MACROS = """
/* What is seldom called stands apart from what is measured in instructions. */
#if defined(__GNUC__)
#define STEWART_APART __attribute__((noinline))
#else
#define STEWART_APART
#endif

#define SIZE @SIZE@
"""

_NUMBERS = """\
/* What differs from leg to leg. */
typedef struct {
@MEMBERS@
} leg_numbers;

static const leg_numbers legs[6] = {
@ROWS@
};
"""

_PREPARE = """\
/* Sum of the sizes of a vector's components, m. */
static stewart_real extent(const stewart_real *vector)
{
    return STEWART_FABS(vector[0]) + STEWART_FABS(vector[1]) + STEWART_FABS(vector[2]);
}

/* Sums over the legs with nothing in them yet. */
static void clear_sum(prepared_leg *sum)
{
@ZERO@
}

int stewart_@NAME@_pose_prepare(const stewart_robot *robot, stewart_@NAME@_pose_model *model)
{
    prepared_leg found;
    prepared_leg sum;
    prepared_platform platform;
    stewart_real size = REAL(0);
    stewart_real lost = REAL(0); /* zero as long as all numbers are finite */
    int i;
    if ((robot == NULL) || (model == NULL)) {
        return STEWART_BAD_ARGUMENT;
    }
    clear_sum(&sum);
    for (i = 0; i < 6; ++i) {
        prepare_leg(robot, &robot->leg[i], &found);
@ADD@
@HELD@
        size = STEWART_LARGER(extent(found.p), size);
        size = STEWART_LARGER(extent(found.b), size);
    }
    prepare_platform(robot, &sum, &platform);
@HELD_PLATFORM@
    lost = lost + (REAL(0) * size);
    if (!(lost >= REAL(0))) {
        return STEWART_NOT_FINITE;
    }
    /* Once more, as a second model would not fit on a small stack. */
    for (i = 0; i < 6; ++i) {
        prepare_leg(robot, &robot->leg[i], &found);
@COPIES@
    }
@PLATFORM@
    model->size = size;
@LENGTH@
    return STEWART_OK;
}
"""

_SHARED = """\
/* What the pose has for all legs. */
typedef struct {
@MEMBERS@
    stewart_real q_1[3]; /* platform point 1 from the reference point */
    int close; /* whether H may be singular to rounding for a short leg */
} pose_terms;

/* What the pose has for all legs, and the platform's part of c: @COUNT@ operations. */
static void pose_of(@MODEL@const stewart_motion *at, pose_terms *out, stewart_real A[6][7])
{
@BODY@
}
"""

_CLOSELY = """\
/* What decides on a leg that may be short: its length, the size of the vectors that it is the sum of, the arm
 * of its moment, and its column of H. */
typedef struct {
    stewart_real L;
    stewart_real reach;
    stewart_real arm[3];
    stewart_real column[6];
} leg_sizes;

STEWART_APART static void leg_closely(
    const stewart_@NAME@_pose_model *model, const stewart_@NAME@_pose_leg *leg, //M
    const leg_numbers *leg, //B
    const stewart_motion *at, const stewart_real q_1[3], leg_sizes *out)
{
@BODY@
}

/* Status of a leg: not finite, no longer than the rounding of its terms, or at most short beside them. */
STEWART_APART static int short_status(
    const stewart_@NAME@_pose_model *model, const stewart_@NAME@_pose_leg *leg, //M
    const leg_numbers *leg, //B
    const stewart_motion *at, pose_terms *pose)
{
    static const stewart_real origin[3] = {REAL(0), REAL(0), REAL(0)};
    leg_sizes sizes;
    leg_closely(model, leg, at, origin, &sizes); //M
    leg_closely(leg, at, origin, &sizes); //B
    if (!(sizes.L <= STEWART_MAX)) {
        return STEWART_NOT_FINITE;
    }
    if (!(sizes.L > (STEWART_SHORT_SHARE * sizes.reach))) {
        pose->close = 1;
    }
    return (sizes.L > (STEWART_ROUNDING * sizes.reach)) ? STEWART_OK : STEWART_SHORT_LEG;
}
"""

_SHIFT = """\
/* Leg 1: the platform's part of c moves to its platform point, about which moments are taken. */
static void shift_of(const stewart_real q[3], stewart_real A[6][7])
{
@BODY@
}
"""

_SCALE = """\
/* Takes the moments of the rows [H | c] over a length. */
static void scale_moments(stewart_real A[6][7], stewart_real per_length)
{
    int i;
    for (i = 0; i < 7; ++i) {
        A[3][i] = A[3][i] * per_length;
        A[4][i] = A[4][i] * per_length;
        A[5][i] = A[5][i] * per_length;
    }
}
"""

_LEG = """\
/* One leg, @COUNT@ operations: its column of H, its D and its part of c. Returns a status. */
@APART@static int @FUNCTION@(
    const stewart_@NAME@_pose_model *model, const stewart_@NAME@_pose_leg *leg, //M
    const leg_numbers *leg, //B
    const stewart_motion *at, pose_terms *pose, int column, stewart_real A[6][7],
    stewart_real *known, //D
    stewart_real least)
{
@BODY@
    return STEWART_OK;
}
"""

_SOLVE = """\
/* Solves [H | c] for x by elimination with partial pivoting, (36). The first column has no moment rows.
 * Returns the product of the pivots. */
static stewart_real solve(stewart_real A[6][7], stewart_real x[6])
{
    stewart_real *row[6];
    stewart_real *lower;
    stewart_real u1;
    stewart_real u2;
    stewart_real u3;
    stewart_real u4;
    stewart_real u5;
    stewart_real u6;
    stewart_real size;
    stewart_real other;
    stewart_real factor;
    stewart_real inverse;
    stewart_real pivots;
    row[0] = A[0];
    row[1] = A[1];
    row[2] = A[2];
    row[3] = A[3];
    row[4] = A[4];
    row[5] = A[5];
@BODY@
    return pivots;
}
"""

_STATUS = """\
/* Status of a pose whose H may be singular to rounding. */
STEWART_APART static int pose_status(
    const stewart_@NAME@_pose_model *model, //M
    const stewart_motion *at, const pose_terms *pose)
{
    leg_sizes sizes;
    stewart_real H[6][6];
    stewart_real length[6];
    stewart_real reach[6];
    stewart_real arm[6][3];
    int i;
    int j;
    for (i = 0; i < 6; ++i) {
        leg_closely(
            model, &model->leg[i], //M
            &legs[i], //B
            at, pose->q_1, &sizes);
        if (!(sizes.L <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
        length[i] = sizes.L;
        reach[i] = sizes.reach;
        for (j = 0; j < 3; ++j) {
            arm[i][j] = sizes.arm[j];
        }
        for (j = 0; j < 6; ++j) {
            H[j][i] = sizes.column[j];
        }
    }
    return singular_status(H, arm, length, reach);
}

"""

_POSE = """\
int stewart_@NAME@_pose_forces( //M
    const stewart_@NAME@_pose_model *model, const stewart_motion *motion, stewart_real F[6]) //M
int stewart_@NAME@_pose_forces(const stewart_motion *motion, stewart_real F[6]) //B
{
    pose_terms pose;
    stewart_real A[6][7];
    stewart_real x[6];
    stewart_real known[6]; //D
    stewart_real least;
    stewart_real pivots;
    int i;
    int status;
    if ((model == NULL) || (motion == NULL) || (F == NULL)) { //M
    if ((motion == NULL) || (F == NULL)) { //B
        return STEWART_BAD_ARGUMENT;
    }
    pose_of(model, motion, &pose, A); //M
    pose_of(motion, &pose, A); //B
    pose.close = 0;
    /* A leg above this is long beside the vectors that it is the sum of. */
    least = STEWART_SHORTEST + (STEWART_SHORT_SHARE
        * (STEWART_FABS(motion->t[0]) + STEWART_FABS(motion->t[1]) + STEWART_FABS(motion->t[2]) + SIZE));
    for (i = 0; i < 6; ++i) {
        status = leg_of(
            model, &model->leg[i], //M
            &legs[i], //B
            motion, &pose, i, A,
            &known[i], //D
            least);
        if (status != STEWART_OK) {
            return status;
        }
    }
    if (@IS_SCALED@) { //S
        scale_moments(A, @PER_LENGTH@); //S
    } //S
    scale_moments(A, @PER_LENGTH@); //Z
    pivots = solve(A, x);
    if ((pose.close != 0) || (!(STEWART_FABS(pivots) > STEWART_LEAST))) {
        status = pose_status(model, motion, &pose); //M
        status = pose_status(motion, &pose); //B
        if (status != STEWART_OK) {
            return status;
        }
    }
@FORCES@
    if (!((STEWART_FABS(x[0]) + STEWART_FABS(x[1]) + STEWART_FABS(x[2]) + STEWART_FABS(x[3])
            + STEWART_FABS(x[4]) + STEWART_FABS(x[5])) <= STEWART_MAX)) {
        /* The sum may be infinite where no force is. */
        if (!((STEWART_FABS(x[0]) <= STEWART_MAX) && (STEWART_FABS(x[1]) <= STEWART_MAX)
                && (STEWART_FABS(x[2]) <= STEWART_MAX) && (STEWART_FABS(x[3]) <= STEWART_MAX)
                && (STEWART_FABS(x[4]) <= STEWART_MAX) && (STEWART_FABS(x[5]) <= STEWART_MAX))) {
            return STEWART_NOT_FINITE;
        }
    }
    F[0] = x[0];
    F[1] = x[1];
    F[2] = x[2];
    F[3] = x[3];
    F[4] = x[4];
    F[5] = x[5];
    return STEWART_OK;
}
"""
