"""C99 for controllers: one pose, one leg after the other, small in code and stack.

Stands beside ``lanes``, which is for processors with vector registers; prints the same blocks for those
without. The model is prepared once, or its numbers are folded in. Knows layout and solving, no dynamics.
"""

import re

import sympy as sp

from .. import notation as n
from ..block import Block, Quantity
from ..operations import force_operations
from ..prepared import ADDED, r
from ..regroup import ForceKernel
from .c import ARITHMETIC, operations_table, step_lines, wrap_list
from .infix import infix, wrap
from .lane_text import dims, entries, filled, loads, names_used, stores
from .lanes import prepare_function

SQRT = "STEWART_SQRT"
_ARGUMENTS = {
    False: "model, leg, at, pose, column, A, known, least, c",
    True: "leg, at, pose, column, A, known, least, c",
}


def header(kernel: ForceKernel, before: ForceKernel | None, version: str) -> str:
    """``stewart_<kernel>_pose.h``; before: of a baked kernel, the one without its numbers."""
    folded = ""
    if before is not None:
        count = force_operations(before).total.total
        folded = f" The machine's numbers are folded in; without, a pose took {count} operations."
    model = "" if before is not None else _MODEL
    parts = {
        "@FIDELITY@": [f" * Fidelity: {kernel.meaning or 'everything'}.{folded}"],
        "@OPERATIONS@": [operations_table(force_operations(kernel), None, " * ")],
        "@MODEL@": [model] if model else [],
        "@LEG@": [_member(q) for q in kernel.leg_constants()],
        "@PLATFORM@": [_member(q) for q in kernel.platform_constants()],
    }
    text = filled(_only(_HEADER, kernel), parts)
    return _named(filled(text, parts), kernel, version)


def source(kernel: ForceKernel, version: str) -> str:
    """``stewart_<kernel>_pose.c``: preparation, unless baked, and one pose."""
    parts = [
        _TOP + ARITHMETIC + _MACROS,
        *_preparation(kernel),
        _shared(kernel),
        *_legs(kernel),
        _solve(),
        _only(_POSE, kernel),
    ]
    return _named("\n".join(parts), kernel, version)


def _named(text: str, kernel: ForceKernel, version: str) -> str:
    size = "model->size" if kernel.constants is None else f"REAL({_size(kernel)!r})"
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
    """Lines that end in ``//M`` are of kernels with a prepared model, ``//B`` of baked ones, ``//D`` and
    ``//C`` of legs with a D and with a part of c."""
    given = {out.quantity for out in kernel.leg.outputs}
    bare = kernel.constants is not None
    kept = {"M": not bare, "B": bare, "D": n.D in given, "E": n.D not in given, "C": n.c_force in given}
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
        return [_table(kernel)]
    parts = {
        "@COPIES@": [
            f"        made.leg[i].{name} = found.{name};" for name in entries(kernel.leg_constants())
        ],
        "@ZERO@": [f"    sum.{name} = 0;" for name in entries(ADDED)],
        "@ADD@": [f"        sum.{name} = sum.{name} + found.{name};" for name in entries(ADDED)],
        "@PLATFORM@": [
            f"    made.{name} = platform.{name};" for name in entries(kernel.platform_constants())
        ],
    }
    return [
        prepare_function(kernel.prepare_leg, "prepared_leg"),
        prepare_function(kernel.prepare_platform, "prepared_platform"),
        filled(_PREPARE, parts),
    ]


def _size(kernel: ForceKernel) -> float:
    """The model's ``size`` of a baked kernel."""
    constants = {q.name: values for q, values in (kernel.constants or {}).items()}
    extents = [
        sum(abs((values * 6)[leg]) for name in quantity.names if (values := constants.get(name)))
        for quantity in (n.p, r)
        for leg in range(6)
    ]
    return max(extents)


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
    model = "const stewart_@NAME@_pose_model *model, " if any("= model->" in line for line in lines) else ""
    parts = {
        "@MEMBERS@": [f"    stewart_real {out.quantity.name}{dims(out.quantity)};" for out in block.outputs],
        "@BODY@": [*lines, *step_lines(block.steps, "    "), *stores(block.outputs, "", "    ")],
    }
    text = _SHARED.replace("@COUNT@", str(block.operations())).replace("@MODEL@", model)
    return filled(text, parts)


def _load(kernel: ForceKernel, q: Quantity, owner: str, used: set[str]) -> list[str]:
    literals = kernel.literals()
    if q in literals:
        return [f"    const stewart_real {q.name} = REAL({literals[q]!r});"]
    return loads(q, owner, "", used, "    ")


def _legs(kernel: ForceKernel) -> list[str]:
    """One leg, and the road that it takes near its pole where the kernel has one."""
    if kernel.leg_near_pole is None:
        return [_leg(kernel, kernel.leg, "leg_of", "return STEWART_POLE;")]
    near = f"return leg_near_pole({_ARGUMENTS[kernel.constants is not None]});"
    return [
        _leg(kernel, kernel.leg_near_pole, "leg_near_pole", "return STEWART_POLE;"),
        _leg(kernel, kernel.leg, "leg_of", near),
    ]


def _leg(kernel: ForceKernel, block: Block, name: str, at_pole: str) -> str:
    """One leg: its column of H and its D are stored, its part of c is added.

    at_pole: what is done where the sine at the universal joint is too small for this block.
    """
    exprs = {out.quantity: out.exprs for out in block.outputs}
    of_pose = [out.quantity for out in kernel.shared.outputs]
    of_legs = kernel.leg_constants()
    used = names_used(block)
    lines = []
    for q in block.inputs:
        owner = "at" if q in n.MOTION else "pose" if q in of_pose else "leg" if q in of_legs else "model"
        lines += _load(kernel, q, owner, used)
    column = (*exprs[n.H_force], *exprs[n.H_moment])
    added = (*exprs.get(n.c_force, ()), *exprs.get(n.c_moment, ()))
    body = [
        *lines,
        *step_lines(block.steps, "    "),
        *_judged(exprs, at_pole),
        *(f"    A[{i}][column] = {infix(expr, SQRT)};" for i, expr in enumerate(column)),
        *(f"    c[{i}] = c[{i}] + ({infix(expr, SQRT)});" for i, expr in enumerate(added)),
        *(f"    *known = {infix(expr, SQRT)};" for expr in exprs.get(n.D, ())),
    ]
    given = ["at", "pose", "c", *([] if kernel.constants is not None else ["model"])]
    unused = [f"    (void){arg};" for arg in given if not any(re.search(rf"\b{arg}\b", t) for t in body)]
    body = [*unused, *body]
    text = _only(_LEG, kernel).replace("@COUNT@", str(block.operations())).replace("@FUNCTION@", name)
    return filled(text.replace("@APART@", "STEWART_APART " if "near" in name else ""), {"@BODY@": body})


def _judged(exprs: dict[Quantity, tuple[sp.Expr, ...]], at_pole: str) -> list[str]:
    """Status of the leg: finite, longer than the rounding of its terms, clear of its pole."""
    least = "STEWART_NEAR_POLE" if "near" in at_pole else "STEWART_POLE_SINE"
    length = infix(exprs[n.L][0], SQRT)
    lines = [
        f"    if (!({length} > least)) {{",
        f"        return {length} <= least ? STEWART_SHORT_LEG : STEWART_NOT_FINITE;",
        "    }",
    ]
    if n.k3 in exprs:
        lines += [
            f"    if (!({infix(exprs[n.k3][0], SQRT)} > {least})) {{",
            f"        {at_pole}",
            "    }",
        ]
    return lines


# ---------------------------------------------------------------- solving


def _solve() -> str:
    """Elimination on row pointers, unrolled; rows are exchanged by pointer, an upper one is read once."""
    body = []
    for k in range(6):
        below = range(k + 1, 3 if k == 0 else 6)
        body += [f"/* Column {k + 1}. */", f"size = STEWART_FABS(row[{k}][{k}]);", f"pivot = {k};"]
        for i in below:
            body += [f"other = STEWART_FABS(row[{i}][{k}]);", "if (other > size) {"]
            body += ["    size = other;", f"    pivot = {i};", "}"]
        body += ["if (!(size > least[pivot])) {"]
        body += ["    return size <= STEWART_MAX ? STEWART_SINGULAR : STEWART_NOT_FINITE;", "}"]
        body += _exchanged(k) if below else []
        body += [f"inverse = 1 / row[{k}][{k}];", f"row[{k}][{k}] = inverse;"]
        upper = [f"u{j}" for j in range(k + 1, 7)]
        if below:
            body += [f"{name} = row[{k}][{name[1]}];" for name in upper]
        for i in below:
            body += [f"lower = row[{i}];", f"factor = lower[{k}] * inverse;"]
            body += [f"lower[{name[1]}] = lower[{name[1]}] - factor * {name};" for name in upper]
    for k in reversed(range(6)):
        known = "".join(f" - row[{k}][{j}] * x[{j}]" for j in range(k + 1, 6))
        body.append(f"x[{k}] = (row[{k}][6]{known}) * row[{k}][{k}];")
    lines = "\n".join(wrap(f"    {line}", " " * 8) for line in body)
    return _SOLVE.replace("@BODY@", lines)


def _exchanged(k: int) -> list[str]:
    return [
        f"if (pivot != {k}) {{",
        "    lower = row[pivot];",
        f"    row[pivot] = row[{k}];",
        f"    row[{k}] = lower;",
        f"    least[pivot] = least[{k}];",
        "}",
    ]


_HEADER = """\
/* stewart_@NAME@_pose.h: the actuator forces of one pose, for processors without vector registers.
 *
 * Written by stewart-sym @VERSION@; do not edit.
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
int stewart_@NAME@_pose_forces( //M
    const stewart_@NAME@_pose_model *model, const stewart_motion *motion, stewart_real F[6]); //M
int stewart_@NAME@_pose_forces(const stewart_motion *motion, stewart_real F[6]); //B

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
    stewart_real size; /* m: no platform point and no base point from base point 1 is farther */
@PLATFORM@
} stewart_@NAME@_pose_model;

/* Prepares the constants; k may have any length. Returns a status: STEWART_NOT_FINITE if a number of the
 * robot is not finite or too large, or k is zero; the model is written only if it is STEWART_OK. */
int stewart_@NAME@_pose_prepare(const stewart_robot *robot, stewart_@NAME@_pose_model *model);
"""

_TOP = """\
/* stewart_@NAME@_pose.c: see stewart_@NAME@_pose.h.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 */
#include "stewart_@NAME@_pose.h"

"""

_MACROS = """
#define REAL(value) ((stewart_real)(value))

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

int stewart_@NAME@_pose_prepare(const stewart_robot *robot, stewart_@NAME@_pose_model *model)
{
    stewart_@NAME@_pose_model made;
    prepared_leg found, sum;
    prepared_platform platform;
    const stewart_real *numbers = (const stewart_real *)&made;
    size_t number;
    int i;
    if (!robot || !model) {
        return STEWART_BAD_ARGUMENT;
    }
@ZERO@
    for (i = 0; i < 6; ++i) {
        prepare_leg(robot, &robot->leg[i], &found);
@COPIES@
@ADD@
    }
    prepare_platform(robot, &sum, &platform);
@PLATFORM@
    made.size = 0;
    for (i = 0; i < 6; ++i) {
        made.size = STEWART_LARGER(extent(made.leg[i].p), made.size);
        made.size = STEWART_LARGER(extent(made.leg[i].r), made.size);
    }
    for (number = 0; number < sizeof made / sizeof *numbers; ++number) {
        if (!(STEWART_FABS(numbers[number]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    *model = made;
    return STEWART_OK;
}
"""

_SHARED = """\
/* What the pose has for all legs. */
typedef struct {
@MEMBERS@
} pose_terms;

/* @COUNT@ operations. */
static void pose_of(@MODEL@const stewart_motion *at, pose_terms *out)
{
@BODY@
}
"""

_LEG = """\
/* One leg, @COUNT@ operations: its column of H, its D and its part of c. Returns a status. */
@APART@static int @FUNCTION@(
    const stewart_@NAME@_pose_model *model, const stewart_@NAME@_pose_leg *leg, //M
    const leg_numbers *leg, //B
    const stewart_motion *at, const pose_terms *pose, int column, stewart_real A[6][7],
    stewart_real *known, //D
    stewart_real least, stewart_real *c)
{
@BODY@
    return STEWART_OK;
}
"""

_SOLVE = """\
/* Solves [H | c] for x by elimination with partial pivoting, (36). The first column has no moment rows;
 * `moment` is the size of the moment rows. */
static int solve(stewart_real A[6][7], stewart_real moment, stewart_real x[6])
{
    stewart_real *row[6];
    stewart_real least[6];
    stewart_real *lower;
    stewart_real u1, u2, u3, u4, u5, u6, size, other, factor, inverse;
    int i, pivot;
    for (i = 0; i < 6; ++i) {
        row[i] = A[i];
        least[i] = i < 3 ? STEWART_ROUNDING : STEWART_ROUNDING * moment;
    }
@BODY@
    return STEWART_OK;
}
"""

_POSE = """\
int stewart_@NAME@_pose_forces( //M
    const stewart_@NAME@_pose_model *model, const stewart_motion *motion, stewart_real F[6]) //M
int stewart_@NAME@_pose_forces(const stewart_motion *motion, stewart_real F[6]) //B
{
    pose_terms pose;
    stewart_real A[6][7];
    stewart_real x[6], c[6];
    stewart_real known[6]; //D
    stewart_real least;
    int i, status;
    if (!model || !motion || !F) { //M
    if (!motion || !F) { //B
        return STEWART_BAD_ARGUMENT;
    }
    pose_of(model, motion, &pose); //M
    pose_of(motion, &pose); //B
    /* A leg below this is the rounding error of the vectors that it is the sum of. */
    least = STEWART_SHORTEST + STEWART_ROUNDING
        * (STEWART_FABS(pose.t_1[0]) + STEWART_FABS(pose.t_1[1]) + STEWART_FABS(pose.t_1[2]) + SIZE);
    for (i = 0; i < 3; ++i) {
        c[i] = pose.c_force[i];
        c[i + 3] = pose.c_moment[i];
    }
    for (i = 0; i < 6; ++i) {
        status = leg_of(
            model, &model->leg[i], //M
            &legs[i], //B
            motion, &pose, i, A,
            &known[i], //D
            least, c);
        if (status != STEWART_OK) {
            return status;
        }
    }
    for (i = 0; i < 6; ++i) {
        A[i][6] = c[i];
    }
    status = solve(A, SIZE, x);
    if (status != STEWART_OK) {
        return status;
    }
    for (i = 0; i < 6; ++i) {
        x[i] = known[i] - x[i]; //D
        x[i] = -x[i]; //E
        if (!(STEWART_FABS(x[i]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    for (i = 0; i < 6; ++i) {
        F[i] = x[i];
    }
    return STEWART_OK;
}
"""
