"""C99 of the closed form: equations of motion, bias, forward dynamics, derivatives, linearisation.

Uses the prepared model of the force kernel (``lanes``). The six legs stand in lanes of eight; each block's
part of the sums is one array, added up leg by leg. Knows layout and solving, no dynamics.
"""

import re
from collections.abc import Collection

from .. import notation as n
from ..block import Block, Operations, Quantity
from ..motion import AXIAL, F_LEG, NAMES, NET, TURNED, SumKernel
from ..regroup import ForceKernel
from . import singular
from .c import ARITHMETIC, IS_FINITE, size, step_lines
from .infix import infix, wrap
from .joint_rows import FORWARD_APART, SLOPES_APART
from .lane_text import (
    EMPTY,
    JUDGED,
    LANES,
    MACROS,
    assigned,
    fault_lines,
    filled,
    judged,
    loads,
    names_used,
    reach_lines,
    stores,
)

LEGS = 6
FUNCTIONS = ("equations", "bias", "forward_dynamics", "joint_inertia", "derivatives", "linearisation")
"""What the emitted file can hold, in the order of its declarations."""


def header(
    kernels: tuple[SumKernel, ...],
    frictionless: tuple[SumKernel, ...],
    name: str,
    version: str,
    functions: Collection[str] = FUNCTIONS,
) -> str:
    """``stewart_<kernel>_motion.h``: what is computed, its cost, its functions.

    kernels, frictionless: at least those of ``kernels_of``. functions: those that are declared, out of
    FUNCTIONS. Raises ValueError for others and for none.
    """
    asked = _asked(functions)
    used = [text for what, text in _PUBLIC.items() if what in _called(asked)]
    rows = [
        f" * {kernel.name:17s} {sum_operations(kernel)!s:44s} {sum_operations(plain).total}"
        for kernel, plain in zip(kernels, frictionless, strict=True)
        if any(f"{kernel.name}_sums(" in text for text in used)
    ]
    arrays = [what for what in asked if what in _ARRAYS]
    forced = [what for what in asked if what in _FORCED]
    text = _HEADER if "derivatives" in asked else _HEADER.replace(_READ, "are not read.\n")
    parts = {
        "@OPERATIONS@": rows,
        "@STRUCTS@": [_struct(what) for what in arrays] + _array_structs(arrays),
        "@ONE_POSE@": [_DECLARATIONS[what] for what in asked],
        "@F@": ["F is [count][6]. "] if forced else [""],
        "@BATCHES@": _batch_declarations(asked),
    }
    return (
        filled(text, parts)
        .replace("@GUARD@", f"STEWART_{name.upper()}_MOTION_H")
        .replace("@VERSION@", version)
        .replace("@NAME@", name)
    )


def source(
    kernels: tuple[SumKernel, ...],
    model: ForceKernel,
    version: str,
    functions: Collection[str] = FUNCTIONS,
) -> str:
    """``stewart_<kernel>_motion.c``: the functions and what they need, nothing else.

    kernels: at least those of ``kernels_of``. functions: out of FUNCTIONS. Raises ValueError for others and
    for none.
    """
    asked = _asked(functions)
    sums = [(f"{kernel.name}_sums", _kernel(kernel, model)) for kernel in kernels]
    top = _TOP.replace("@VERSION@", version) + ARITHMETIC + MACROS + singular.MACROS
    text = "\n".join([top, _COMMON, *_needed(_pieces(sums), _wanted(asked))])
    return text.replace("@NAME@", model.formulation.kernel_name)


def kernels_of(functions: Collection[str]) -> tuple[str, ...]:
    """Names of the kernels whose sums the functions need, in the order of ``motion.NAMES``.

    functions: out of FUNCTIONS. Raises ValueError for others and for none.
    """
    text = "\n".join(_needed(_pieces([]), _wanted(_asked(functions))))
    return tuple(name for name in NAMES if re.search(rf"\b{name}_sums\(", text))


def _wanted(asked: Collection[str]) -> set[str]:
    return {f"stewart_@NAME@_{what}{batch}" for what in asked for batch in ("", "_batch")}


def _pieces(sums: list[tuple[str, str]]) -> list[tuple[str, str]]:
    """Name and text of each function of the file, those that are called before those that call."""
    return [
        *_SHARED.items(),
        ("singular_status", singular.FUNCTION),
        ("columns_status", _COLUMNS_STATUS),
        *sums,
        *((f"solve_definite_{width}", _solve(_DEFINITE, width)) for width in (8, 24)),
        *((f"solve_pivoted_{width}", _solve(_PIVOTED, width)) for width in (12, 24)),
        ("forward_apart", FORWARD_APART),
        ("slopes_apart", SLOPES_APART),
        *((f"stewart_@NAME@_{what}", text) for what, text in _PUBLIC.items()),
        *_LOAD_POSE.items(),
        *((f"stewart_@NAME@_{what}_batch", _batch(what)) for what in MEMBERS),
    ]


def _asked(functions: Collection[str]) -> list[str]:
    """The functions in the order of their declarations."""
    if not functions or not set(functions) <= set(FUNCTIONS):
        raise ValueError(f"functions: expected some of {', '.join(FUNCTIONS)}, got {list(functions)}")
    return [what for what in FUNCTIONS if what in functions]


def _called(functions: Collection[str]) -> set[str]:
    """The functions and those that they call."""
    return {
        what
        for what in FUNCTIONS
        if what in functions or any(f"_{what}(model," in _PUBLIC[caller] for caller in functions)
    }


def _needed(pieces: list[tuple[str, str]], wanted: Collection[str]) -> list[str]:
    """Texts of the functions that are wanted and of those they call; what isn't wanted itself is static.

    pieces: as ``_pieces`` lists them.
    """
    kept: list[str] = []
    for name, text in reversed(pieces):
        if name in wanted:
            kept.append(text)
        elif any(re.search(rf"\b{name}\(", caller) for caller in kept):
            kept.append(f"static {text}" if text.startswith("int stewart_") else text)
    return kept[::-1]


def sum_operations(kernel: SumKernel) -> Operations:
    """Operations of a pose before any solve: six legs, the platform, the sums."""
    sums = LEGS * sum(size(q) for q in kernel.summed)
    return LEGS * kernel.leg.operations() + kernel.pose.operations() + Operations(add=sums)


# ---------------------------------------------------------------- one kernel


def _kernel(kernel: SumKernel, model: ForceKernel) -> str:
    """Structs and functions of one kernel: the pose's part, the legs' parts, both added up."""
    given = [out.quantity for out in kernel.pose.outputs if out.quantity not in kernel.summed]
    stored = [out.quantity for out in kernel.leg.outputs if out.quantity not in (*kernel.summed, *JUDGED)]
    forced = F_LEG in kernel.leg.inputs
    by_pose, argument, by_legs = _LANE_INPUTS[next((q for q in _LANE_INPUTS if q in kernel.leg.inputs), None)]
    text = _SUM_KERNEL.replace("@FORCE@", by_pose)
    text = text.replace("@FORCE_ARGUMENT@", argument)
    legs = {"": kernel.leg} | ({} if kernel.near is None else {"_near": kernel.near})
    text = text.replace(
        "@LEGS@", "\n".join(_of_legs(suffix, leg, kernel, model) for suffix, leg in legs.items())
    )
    text = text.replace("@FORCE_LANES@", by_legs)
    parts = {
        "@GIVEN@": [f"    stewart_real {q.name}[{size(q)}];" for q in given] or [EMPTY],
        "@STORED@": [f"    stewart_real {q.name}[{size(q)}][{LANES}];" for q in stored],
        "@POSE_BODY@": [*([] if given else ["    (void)out;"]), *_pose_body(kernel)],
        "@DECLARED@": ["    stewart_real force[LANES];", "    int i;"] if forced else [],
        "@SPREAD@": _SPREAD_FORCE if forced else [],
        "@NEAR@": []
        if kernel.near is None
        else [_NEAR.replace("@WHAT@", kernel.name).replace("@FORCE_ARGUMENT@", argument)],
    }
    marks = {"@WHAT@": kernel.name, "@COUNT@": str(sum(size(q) for q in kernel.summed))}
    marks["@POSE_COUNT@"] = str(kernel.pose.operations())
    for mark, value in marks.items():
        text = text.replace(mark, value)
    return filled(_without_empty(text, parts), parts)


def _of_legs(suffix: str, leg: Block, kernel: SumKernel, model: ForceKernel) -> str:
    outside, body = _leg_loads(leg, model)[0], _leg_body(leg, kernel, model)
    unused = [] if any("pose->" in line for line in (*outside, *body)) else ["    (void)pose;"]
    parts = {"@OUTSIDE@": [*unused, *outside], "@LEG_BODY@": body}
    text = _OF_LEGS.replace("@NEAR@", suffix).replace("@LEG_COUNT@", str(leg.operations()))
    return filled(_without_empty(text, parts), parts)


def _without_empty(text: str, parts: dict[str, list[str]]) -> str:
    """The text without the lines of marks that stand for nothing."""
    for mark, lines in parts.items():
        if not lines:
            text = text.replace(f"{mark}\n", "")
    return text


_LANE_INPUTS: dict[Quantity | None, tuple[str, str, str]] = {
    F_LEG: (", const stewart_real F[6]", ", force", ", const stewart_real *STEWART_RESTRICT force"),
    NET: (", stewart_real (*apart)[LANES]", ", apart", ", stewart_real (*STEWART_RESTRICT apart)[LANES]"),
    None: ("", "", ""),
}
"""What legs are given besides pose and model: a kernel's parameter, the legs' argument and parameter."""

_APART = (NET, TURNED, AXIAL)
"""What ``forward_apart`` hands to the derivatives, three numbers each but for the last."""

_SPREAD_FORCE = [
    "    for (i = 0; i < LANES; ++i) {",
    "        force[i] = F[i < 6 ? i : 5];",
    "    }",
]


def _sums(kernel: SumKernel, block: Block) -> list[str]:
    """Text of each number that the block adds, in the order of the sums."""
    exprs = {out.quantity: out.exprs for out in block.outputs}
    return [infix(expr, "STEWART_SQRT") for q in kernel.summed for expr in exprs[q]]


def _pose_body(kernel: SumKernel) -> list[str]:
    block, used = kernel.pose, names_used(kernel.pose)
    given = tuple(out for out in block.outputs if out.quantity not in kernel.summed)
    found = [
        line for q in block.inputs for line in loads(q, "at" if q in n.MOTION else "model", "", used, "    ")
    ]
    return [
        *found,
        *step_lines(block.steps, "    "),
        *stores(given, "", "    "),
        *(f"    sum[{i}] = {text};" for i, text in enumerate(_sums(kernel, block))),
    ]


def _leg_loads(block: Block, model: ForceKernel) -> tuple[list[str], list[str]]:
    """Loads of what all legs share, and of what differs from leg to leg."""
    used = names_used(block) | {*n.t.names, *n.b.names}
    outside: list[str] = []
    inside: list[str] = []
    for q in block.inputs:
        if q == F_LEG:
            inside.append("        const stewart_real F = force[l];")
        elif q in _APART:
            inside += [
                f"        const stewart_real {name} = apart[{3 * _APART.index(q) + i}][l];"
                for i, name in enumerate(q.names)
                if name in used
            ]
        elif q in model.leg_constants():
            inside += loads(q, "model", "[l]", used, " " * 8)
        else:
            owner = "at" if q in n.MOTION else "model" if q in model.platform_constants() else "pose"
            outside += loads(q, owner, "", used, "    ")
    return outside, inside


def _leg_body(block: Block, kernel: SumKernel, model: ForceKernel) -> list[str]:
    kept = tuple(o for o in block.outputs if o.quantity not in (*kernel.summed, *JUDGED))
    length, sine = judged(block)
    terms = [f"STEWART_FABS({name})" for q in (n.q, n.t, n.b) for name in q.names]
    return [
        *_leg_loads(block, model)[1],
        *step_lines(block.steps, " " * 8),
        *(assigned(f"out->sum[{i}][l]", text) for i, text in enumerate(_sums(kernel, block))),
        *stores(kept, "[l]", " " * 8),
        *reach_lines(terms),
        "        out->judged.reach[l] = reach;",
        f"        out->judged.L[l] = {length};",
        f"        out->judged.k3[l] = {sine};",
        *fault_lines(length, sine, "0", "out->judged.bad[l]"),
    ]


def _solve(marks: dict[str, str], width: int) -> str:
    text = _SOLVE
    for mark, value in marks.items():
        text = text.replace(mark, value)
    return text.replace("@WIDTH@", str(width))


# ---------------------------------------------------------------- batches

_ARRAYS: dict[str, tuple[tuple[str, int], ...]] = {
    "equations": (
        ("M", 36),
        ("C", 36),
        ("g", 6),
        ("friction", 6),
        ("bias", 6),
        ("H", 36),
        ("H_dot", 36),
    ),
    "derivatives": (("F", 6), ("by_pose", 36), ("by_twist", 36), ("by_acceleration", 36)),
    "linearisation": (("acceleration", 6), ("A", 144), ("B", 72)),
}
"""Members of the structs that functions fill, and how many numbers each has."""

_PLAIN: dict[str, tuple[str, int]] = {
    "bias": ("bias", 6),
    "forward_dynamics": ("acceleration", 6),
    "joint_inertia": ("inertia", 36),
}
"""Functions that fill one array."""

_FORCED = ("forward_dynamics", "linearisation")
"""Functions that take actuator forces."""

_NEEDED = {
    **dict.fromkeys(_FORCED, ("F",)),
    "derivatives": ("motions->alpha", "motions->a"),
}
"""What else a batch must be given."""

MEMBERS: dict[str, tuple[tuple[str, int], ...]] = _ARRAYS | {name: (one,) for name, one in _PLAIN.items()}
"""What each function hands out, with the count of its numbers."""


def _batch(what: str) -> str:
    members, forced = MEMBERS[what], what in _FORCED
    marks = {
        "@WHAT@": what,
        "@ARGUMENT@": "const stewart_real *F, " if forced else "",
        "@MISSING@": _missing(what),
        "@FORCE@": "&F[pose * 6U], " if forced else "",
        "@OUT@": _out(what),
    }
    if what in _ARRAYS:
        marks |= {"@DECLARE@": f"stewart_{what} found;", "@TARGET@": "&found"}
        copies = [f"copy_to(found.{name}, {count}, pose, out->{name});" for name, count in members]
    else:
        count = members[0][1]
        marks |= {"@DECLARE@": f"stewart_real found[{count}];", "@TARGET@": "found"}
        copies = [f"copy_to(found, {count}, pose, out);"]
    text = _BATCH
    for mark, value in marks.items():
        text = text.replace(mark, value)
    return filled(text, {"@COPIES@": [f"            {line}" for line in copies]})


def _missing(what: str) -> str:
    """The question whether a pointer is null that must not be."""
    given = ("model", "motions", "out", *(f"motions->{name}" for name in ("R", "t", "omega", "v")))
    text = " || ".join(f"{name} == NULL" for name in (*given, *_NEEDED.get(what, ())))
    return wrap(f"    if ({text}) {{", " " * 8, before=r"\|\|")


def _out(what: str) -> str:
    return f"const stewart_{what}_arrays *out" if what in _ARRAYS else "stewart_real *out"


def _members(quantities: tuple[tuple[str, int], ...], pointer: bool) -> str:
    rows = (("*{}; /* [count][{}] */" if pointer else "{}[{}];").format(*pair) for pair in quantities)
    return "\n".join(f"    stewart_real {row}" for row in rows)


_READ = """\
are read by
 * `derivatives` alone.
"""
"""What the header says of the accelerations, if there are derivatives."""

_HEADER = """\
/* stewart_@NAME@_motion.h: the closed form of the equations of motion and what follows from it.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 *     M [a; alpha] + C [v; omega] + g + friction = H F + [R F_ext; R M_ext]
 *
 * Wrenches [force; moment] and twists [v; omega] in base axes about the platform's reference point. M is
 * symmetric and, with physical inertias, positive definite; its rate less 2 C is skew. bias is
 * C [v; omega] + g + friction. Matrices are row-major. Poses move by [dt; dphi], R becoming exp([dphi]x) R.
 * Link with stewart_@NAME@_forces.c, whose prepared model is used; accelerations in the motion are read by
 * `derivatives` alone.
 *
 * Operations of a pose before any solve      with friction                                without
@OPERATIONS@
 */
#ifndef @GUARD@
#define @GUARD@

#include "stewart_@NAME@_forces.h"

#ifdef __cplusplus
extern "C" {
#endif

@STRUCTS@
/* One pose. All return a status; outputs are written only if it is STEWART_OK. */
@ONE_POSE@

/* `count` poses; @F@Of the motions, F_ext and M_ext may be null, alpha and a where they are not
 * read. `status` takes one code for each pose; null: not wanted. Return the first
 * code other than STEWART_OK, or STEWART_OK. */
@BATCHES@

#ifdef __cplusplus
}
#endif

#endif
"""

_MEANINGS = {
    "equations": "H_dot: rate of H; the others as above.",
    "derivatives": "Actuator forces of inverse dynamics and their derivatives by [dt; dphi], [v; omega], "
    "[a; alpha].",
    "linearisation": "Forward dynamics, and d/dt [dt; dphi; dv; domega] = A [dt; dphi; dv; domega] + B dF "
    "about the motion.",
}
"""Of the structs."""

_DECLARATIONS = {
    "equations": """\
STEWART_NODISCARD int stewart_@NAME@_equations(
    const stewart_@NAME@_model *model, const stewart_motion *motion, stewart_equations *out);""",
    "bias": """\
STEWART_NODISCARD int stewart_@NAME@_bias(
    const stewart_@NAME@_model *model, const stewart_motion *motion, stewart_real bias[6]);""",
    "forward_dynamics": """\
STEWART_NODISCARD int stewart_@NAME@_forward_dynamics(
    const stewart_@NAME@_model *model, const stewart_motion *motion, const stewart_real F[6],
    stewart_real acceleration[6]);
""",
    "joint_inertia": """\
/* Inertia that the actuators feel, H^-1 M H^-T: H^T [v; omega] are the rates of the leg lengths. */
STEWART_NODISCARD int stewart_@NAME@_joint_inertia(
    const stewart_@NAME@_model *model, const stewart_motion *motion, stewart_real inertia[36]);""",
    "derivatives": """\
STEWART_NODISCARD int stewart_@NAME@_derivatives(
    const stewart_@NAME@_model *model, const stewart_motion *motion, stewart_derivatives *out);""",
    "linearisation": """\
STEWART_NODISCARD int stewart_@NAME@_linearisation(
    const stewart_@NAME@_model *model, const stewart_motion *motion, const stewart_real F[6],
    stewart_linearisation *out);""",
}


def _struct(what: str) -> str:
    members = _members(_ARRAYS[what], pointer=False)
    return f"/* {_MEANINGS[what]} */\ntypedef struct {{\n{members}\n}} stewart_{what};\n"


def _array_structs(arrays: list[str]) -> list[str]:
    texts = [
        f"typedef struct {{\n{_members(_ARRAYS[what], pointer=True)}\n}} stewart_{what}_arrays;\n"
        for what in arrays
    ]
    said = "/* The same of `count` poses. Any pointer may be null: not wanted. */\n"
    return [said + texts[0], *texts[1:]] if texts else []


def _batch_declarations(functions: Collection[str]) -> list[str]:
    lines = []
    for what in MEMBERS:
        if what not in functions:
            continue
        argument = "const stewart_real *F, " if what in _FORCED else ""
        lines.append(
            f"STEWART_NODISCARD int stewart_@NAME@_{what}_batch(\n"
            "    const stewart_@NAME@_model *model, size_t count, const stewart_motions *motions,\n"
            f"    {argument}{_out(what)}, int *status);"
        )
    return lines


_TOP = """\
/* stewart_@NAME@_motion.c: see stewart_@NAME@_motion.h.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_@NAME@_motion.h"

"""

_COMMON = """\
/* Where elimination leaves less than this of a diagonal number of M, digits are lost that the machine has. */
#define STEWART_KEPT ((stewart_real)0.03125)

/* Below this sine of the angle between a leg and its fixed axis the shorter formulas of C and derivatives
 * lose digits. */
#define STEWART_LEANING ((stewart_real)0.125)

/* What tells whether a leg is fit to be computed. */
typedef struct {
    stewart_real L[LANES], reach[LANES], k3[LANES];
    stewart_real bad[LANES]; /* 1 where the leg is not fit, else 0 */
} leg_judgement;

static int legs_status(const leg_judgement *judged)
{
    int i;
    for (i = 0; i < 6; ++i) {
        if (judged->bad[i] > REAL(0)) {
            if (!(judged->L[i] <= STEWART_MAX)) {
                return STEWART_NOT_FINITE;
            }
            return judged->L[i] > STEWART_ROUNDING * judged->reach[i] ? STEWART_POLE : STEWART_SHORT_LEG;
        }
    }
    return STEWART_OK;
}
"""

_SHARED = {
    "is_near": """\
/* Whether a leg is so near its joint singularity that the shorter formulas lose digits. */
static int is_near(const leg_judgement *judged)
{
    int i, found = 0;
    for (i = 0; i < 6; ++i) {
        found = judged->k3[i] > STEWART_LEANING ? found : 1;
    }
    return found;
}
""",
    "add_legs": """\
/* Adds the six legs to the platform's part. Apart, because GCC 12 makes wrong vectors of the sums
 * where it can see the solve as well. */
STEWART_APART static void add_legs(
    stewart_real (*STEWART_RESTRICT lanes)[LANES], int count, stewart_real *STEWART_RESTRICT sum)
{
    int i;
    for (i = 0; i < count; ++i) {
        sum[i] = sum[i] + (lanes[i][0] + lanes[i][1] + lanes[i][2] + lanes[i][3] + lanes[i][4] + lanes[i][5]);
    }
}
""",
    "is_finite": IS_FINITE,
    "copy": """\
static void copy(const stewart_real *from, int count, stewart_real *to)
{
    int i;
    for (i = 0; i < count; ++i) {
        to[i] = from[i];
    }
}
""",
    "inertia_rows": """\
/* M from the first 21 sums, as rows of `width` numbers. */
static void inertia_rows(const stewart_real *sum, int width, stewart_real *rows)
{
    static const int place[36] = {0, 1, 2, 6, 7, 8, 1, 3, 4, 9, 10, 11, 2, 4, 5, 12, 13, 14,
                                  6, 9, 12, 15, 16, 17, 7, 10, 13, 16, 18, 19, 8, 11, 14, 17, 19, 20};
    int i, j;
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            rows[i * width + j] = sum[place[6 * i + j]];
        }
    }
}
""",
    "block_rows": """\
/* Four 3x3 blocks as a 6x6 matrix in rows of `width` numbers. */
static void block_rows(const stewart_real *blocks, int width, stewart_real *rows)
{
    int i, j;
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            rows[i * width + j] = blocks[(i / 3 * 2 + j / 3) * 9 + i % 3 * 3 + j % 3];
        }
    }
}
""",
    "column_rows": """\
/* H from the legs' columns, in rows of `width` numbers. */
static void column_rows(
    stewart_real (*force)[LANES], stewart_real (*moment)[LANES], int width, stewart_real *rows)
{
    int i, j;
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 6; ++j) {
            rows[i * width + j] = force[i][j];
            rows[(i + 3) * width + j] = moment[i][j];
        }
    }
}
""",
    "scale_rows": """\
/* Takes moments over a length in rows of `width` numbers, three of forces and three of moments. */
static void scale_rows(stewart_real per_length, int width, stewart_real *rows)
{
    int i;
    if (per_length != REAL(1)) {
        for (i = 3 * width; i < 6 * width; ++i) {
            rows[i] = rows[i] * per_length;
        }
    }
}
""",
}
"""What kernels and functions share: name -> text."""

_COLUMNS_STATUS = """\
/* Status of a pose by its H; suspect: whether a pivot of it is small. */
static int columns_status(
    const stewart_@NAME@_model *model, const stewart_motion *motion, stewart_real (*force)[LANES],
    stewart_real (*moment)[LANES], const leg_judgement *judged, int suspect)
{
    stewart_real H[36], rows[6][6], arm[6][3];
    int i, j, close = 0;
    for (i = 0; i < 6; ++i) {
        close = judged->L[i] > STEWART_SHORT_SHARE * judged->reach[i] ? close : 1;
    }
    if (close == 0 && suspect == 0) {
        return STEWART_OK;
    }
    column_rows(force, moment, 6, H);
    for (i = 0; i < 36; ++i) {
        rows[i / 6][i % 6] = H[i];
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            arm[i][j] = motion->R[3 * j] * model->p[0][i] + motion->R[3 * j + 1] * model->p[1][i]
                + motion->R[3 * j + 2] * model->p[2][i];
        }
    }
    return singular_status(rows, arm, judged->L, judged->reach);
}
"""

_SUM_KERNEL = """\
/* ---- @WHAT@ ---- */

typedef struct {
@GIVEN@
} @WHAT@_pose;

typedef struct {
    stewart_real sum[@COUNT@][LANES];
@STORED@
    leg_judgement judged;
} @WHAT@_legs;

/* The platform's part: @POSE_COUNT@ operations. */
static void @WHAT@_of_pose(
    const stewart_@NAME@_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    @WHAT@_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT sum)
{
@POSE_BODY@
}

@LEGS@
/* Platform and legs together; returns a status. */
static int @WHAT@_sums(
    const stewart_@NAME@_model *model, const stewart_motion *motion@FORCE@, @WHAT@_legs *legs,
    stewart_real *sum)
{
    @WHAT@_pose pose;
    int status;
@DECLARED@
    @WHAT@_of_pose(model, motion, &pose, sum);
@SPREAD@
    @WHAT@_of_legs(model, motion, &pose@FORCE_ARGUMENT@, legs);
@NEAR@
    status = legs_status(&legs->judged);
    if (status == STEWART_OK) {
        add_legs(legs->sum, @COUNT@, sum);
    }
    return status;
}
"""

_OF_LEGS = """\
/* The legs side by side: @LEG_COUNT@ operations each. */
STEWART_APART static void @WHAT@_of_legs@NEAR@(
    const stewart_@NAME@_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const @WHAT@_pose *STEWART_RESTRICT pose@FORCE_LANES@, @WHAT@_legs *STEWART_RESTRICT out)
{
    int l;
@OUTSIDE@
    for (l = 0; l < LANES; ++l) {
@LEG_BODY@
    }
}
"""

_NEAR = """\
    if (is_near(&legs->judged) != 0) {
        @WHAT@_of_legs_near(model, motion, &pose@FORCE_ARGUMENT@, legs);
    }"""
"""Where a kernel has a code path near the joint singularity."""

_SOLVE = """\
/* Solves for X the rows [@MATRIX@ | Y] of @WIDTH@ numbers @METHOD@, leaving X in place of Y.
 * Returns @RETURNS@. */
static @TYPE@ solve_@KIND@_@WIDTH@(stewart_real A[6 * @WIDTH@]@LEAST@)
{
    stewart_real @SCALE@inverse[6];
    int i, j, k@SUSPECT@;
@SCALES@
    for (k = 0; k < 6; ++k) {
@PIVOT@
        inverse[k] = REAL(1) / A[k * @WIDTH@ + k];
        for (i = k + 1; i < 6; ++i) {
            const stewart_real factor = A[i * @WIDTH@ + k] * inverse[k];
            for (j = 0; j < @WIDTH@; ++j) {
                A[i * @WIDTH@ + j] = A[i * @WIDTH@ + j] - factor * A[k * @WIDTH@ + j];
            }
        }
    }
    for (k = 5; k >= 0; --k) {
        for (j = 6; j < @WIDTH@; ++j) {
            A[k * @WIDTH@ + j] = A[k * @WIDTH@ + j] * inverse[k];
        }
        for (i = 0; i < k; ++i) {
            const stewart_real factor = A[i * @WIDTH@ + k];
            for (j = 6; j < @WIDTH@; ++j) {
                A[i * @WIDTH@ + j] = A[i * @WIDTH@ + j] - factor * A[k * @WIDTH@ + j];
            }
        }
    }
    return @RESULT@;
}
"""

_DEFINITE = {
    "@RETURNS@": "a status",
    "@TYPE@": "int",
    "@SCALE@": "scale[6], ",
    "@SUSPECT@": "",
    "@RESULT@": "STEWART_OK",
    "@KIND@": "definite",
    "@MATRIX@": "M",
    "@METHOD@": "by L D L^T, M positive definite, a pivot more than `least` of its diagonal number",
    "@LEAST@": ", stewart_real least",
    "@SCALES@": """\
    for (k = 0; k < 6; ++k) {
        scale[k] = A[k * @WIDTH@ + k];
    }""",
    "@PIVOT@": """\
        if (!(A[k * @WIDTH@ + k] > least * scale[k])) {
            return STEWART_FABS(A[k * @WIDTH@ + k]) <= STEWART_MAX ? STEWART_INDEFINITE : STEWART_NOT_FINITE;
        }""",
}

_PIVOTED = {
    "@RETURNS@": "1 where a pivot is small, else 0",
    "@TYPE@": "int",
    "@SCALE@": "",
    "@SUSPECT@": ", suspect = 0",
    "@RESULT@": "suspect",
    "@KIND@": "pivoted",
    "@MATRIX@": "H",
    "@METHOD@": "by elimination with partial pivoting",
    "@LEAST@": "",
    "@SCALES@": "",
    "@PIVOT@": """\
        int pivot = k;
        for (i = k + 1; i < 6; ++i) {
            if (STEWART_FABS(A[i * @WIDTH@ + k]) > STEWART_FABS(A[pivot * @WIDTH@ + k])) {
                pivot = i;
            }
        }
        for (j = 0; pivot != k && j < @WIDTH@; ++j) {
            const stewart_real moved = A[k * @WIDTH@ + j];
            A[k * @WIDTH@ + j] = A[pivot * @WIDTH@ + j];
            A[pivot * @WIDTH@ + j] = moved;
        }
        suspect = STEWART_FABS(A[k * @WIDTH@ + k]) > STEWART_SUSPECT ? suspect : 1;""",
}

_PUBLIC = {
    "equations": """\
int stewart_@NAME@_equations(
    const stewart_@NAME@_model *model, const stewart_motion *motion, stewart_equations *out)
{
    equations_legs legs;
    stewart_equations found;
    stewart_real sum[69];
    int i, j, status;
    if (model == NULL || motion == NULL || out == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    status = equations_sums(model, motion, &legs, sum);
    if (status != STEWART_OK) {
        return status;
    }
    inertia_rows(sum, 6, found.M);
    block_rows(&sum[21], 6, found.C);
    copy(&sum[57], 6, found.g);
    copy(&sum[63], 6, found.friction);
    column_rows(legs.H_force, legs.H_moment, 6, found.H);
    column_rows(legs.H_dot_force, legs.H_dot_moment, 6, found.H_dot);
    for (i = 0; i < 6; ++i) {
        stewart_real bias = found.g[i] + found.friction[i];
        for (j = 0; j < 3; ++j) {
            bias = bias + found.C[6 * i + j] * motion->v[j] + found.C[6 * i + j + 3] * motion->omega[j];
        }
        found.bias[i] = bias;
    }
    if (is_finite(sum, 69) == 0 || is_finite(found.bias, 6) == 0 || is_finite(found.H_dot, 36) == 0) {
        return STEWART_NOT_FINITE;
    }
    *out = found;
    return STEWART_OK;
}
""",
    "bias": """\
int stewart_@NAME@_bias(
    const stewart_@NAME@_model *model, const stewart_motion *motion, stewart_real bias[6])
{
    bias_legs legs;
    stewart_real sum[6];
    int status;
    if (model == NULL || motion == NULL || bias == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    status = bias_sums(model, motion, &legs, sum);
    if (status != STEWART_OK) {
        return status;
    }
    if (is_finite(sum, 6) == 0) {
        return STEWART_NOT_FINITE;
    }
    copy(sum, 6, bias);
    return STEWART_OK;
}
""",
    "forward_dynamics": """\
int stewart_@NAME@_forward_dynamics(
    const stewart_@NAME@_model *model, const stewart_motion *motion, const stewart_real F[6],
    stewart_real acceleration[6])
{
    forward_dynamics_legs legs;
    row_factors by;
    stewart_real A[48], sum[27], apart[7][LANES];
    int i, status;
    if (model == NULL || motion == NULL || F == NULL || acceleration == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    status = forward_dynamics_sums(model, motion, F, &legs, sum);
    if (status != STEWART_OK) {
        return status;
    }
    inertia_rows(sum, 8, A);
    for (i = 0; i < 6; ++i) {
        A[8 * i + 6] = sum[21 + i];
        A[8 * i + 7] = REAL(0);
    }
    status = solve_definite_8(A, STEWART_KEPT);
    if (status == STEWART_INDEFINITE) {
        return forward_apart(model, motion, F, &by, apart, acceleration);
    }
    if (status != STEWART_OK) {
        return status;
    }
    for (i = 0; i < 6; ++i) {
        if (is_finite(&A[8 * i + 6], 1) == 0) {
            return STEWART_NOT_FINITE;
        }
    }
    for (i = 0; i < 6; ++i) {
        acceleration[i] = A[8 * i + 6];
    }
    return STEWART_OK;
}
""",
    "joint_inertia": """\
int stewart_@NAME@_joint_inertia(
    const stewart_@NAME@_model *model, const stewart_motion *motion, stewart_real inertia[36])
{
    equations_legs legs;
    stewart_real A[72], X[36], sum[69];
    int i, j, status;
    if (model == NULL || motion == NULL || inertia == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    status = equations_sums(model, motion, &legs, sum);
    if (status != STEWART_OK) {
        return status;
    }
    column_rows(legs.H_force, legs.H_moment, 12, A);
    inertia_rows(sum, 12, &A[6]);
    scale_rows(model->per_length, 12, A);
    status = columns_status(model, motion, legs.H_force, legs.H_moment, &legs.judged, solve_pivoted_12(A));
    if (status != STEWART_OK) {
        return status;
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            X[6 * j + i] = A[12 * i + 6 + j];
        }
    }
    column_rows(legs.H_force, legs.H_moment, 12, A);
    for (i = 0; i < 6; ++i) {
        copy(&X[6 * i], 6, &A[12 * i + 6]);
    }
    scale_rows(model->per_length, 12, A);
    (void)solve_pivoted_12(A);
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            X[6 * i + j] = (A[12 * i + 6 + j] + A[12 * j + 6 + i]) * STEWART_HALF;
        }
    }
    if (is_finite(X, 36) == 0) {
        return STEWART_NOT_FINITE;
    }
    copy(X, 36, inertia);
    return STEWART_OK;
}
""",
    "derivatives": """\
int stewart_@NAME@_derivatives(
    const stewart_@NAME@_model *model, const stewart_motion *motion, stewart_derivatives *out)
{
    derivatives_legs legs;
    stewart_derivatives found;
    stewart_real A[144], sum[93];
    int i, j, status;
    if (model == NULL || motion == NULL || out == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    status = stewart_@NAME@_forces(model, motion, found.F);
    if (status == STEWART_OK) {
        status = derivatives_sums(model, motion, found.F, &legs, sum);
    }
    if (status != STEWART_OK) {
        return status;
    }
    column_rows(legs.H_force, legs.H_moment, 24, A);
    block_rows(&sum[21], 24, &A[6]);
    block_rows(&sum[57], 24, &A[12]);
    inertia_rows(sum, 24, &A[18]);
    scale_rows(model->per_length, 24, A);
    (void)solve_pivoted_24(A);
    for (i = 0; i < 6; ++i) {
        if (is_finite(&A[24 * i + 6], 18) == 0) {
            return STEWART_NOT_FINITE;
        }
        for (j = 0; j < 6; ++j) {
            found.by_pose[6 * i + j] = A[24 * i + 6 + j];
            found.by_twist[6 * i + j] = A[24 * i + 12 + j];
            found.by_acceleration[6 * i + j] = A[24 * i + 18 + j];
        }
    }
    *out = found;
    return STEWART_OK;
}
""",
    "linearisation": """\
/* A of the linearisation from M^-1 times the derivatives of the wrench, columns 6 to 17 of the rows. */
static void system_matrix(const stewart_real *omega, stewart_real A[144], stewart_real *system)
{
    int i, j;
    for (i = 0; i < 144; ++i) {
        system[i] = REAL(0);
    }
    for (i = 0; i < 6; ++i) {
        system[12 * i + 6 + i] = REAL(1);
        for (j = 0; j < 12; ++j) {
            system[12 * (i + 6) + j] = -A[24 * i + 6 + j];
        }
    }
    system[12 * 3 + 4] = -omega[2];
    system[12 * 3 + 5] = omega[1];
    system[12 * 4 + 3] = omega[2];
    system[12 * 4 + 5] = -omega[0];
    system[12 * 5 + 3] = -omega[1];
    system[12 * 5 + 4] = omega[0];
}

int stewart_@NAME@_linearisation(
    const stewart_@NAME@_model *model, const stewart_motion *motion, const stewart_real F[6],
    stewart_linearisation *out)
{
    derivatives_legs legs;
    row_factors by;
    stewart_linearisation found;
    stewart_motion moving;
    stewart_real A[144], sum[93], apart[7][LANES];
    int i, j, status;
    if (model == NULL || motion == NULL || F == NULL || out == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    status = stewart_@NAME@_forward_dynamics(model, motion, F, found.acceleration);
    if (status != STEWART_OK) {
        return status;
    }
    moving = *motion;
    copy(found.acceleration, 3, moving.a);
    copy(&found.acceleration[3], 3, moving.alpha);
    status = derivatives_sums(model, &moving, F, &legs, sum);
    if (status != STEWART_OK) {
        return status;
    }
    inertia_rows(sum, 24, A);
    block_rows(&sum[21], 24, &A[6]);
    block_rows(&sum[57], 24, &A[12]);
    column_rows(legs.H_force, legs.H_moment, 24, &A[18]);
    status = solve_definite_24(A, STEWART_KEPT);
    if (status == STEWART_INDEFINITE) {
        status = forward_apart(model, motion, F, &by, apart, found.acceleration);
        if (status == STEWART_OK) {
            status = slopes_apart(model, &moving, &by, apart, A);
        }
    }
    if (status != STEWART_OK) {
        return status;
    }
    system_matrix(motion->omega, A, found.A);
    for (i = 0; i < 36; ++i) {
        found.B[i] = REAL(0);
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            found.B[6 * (i + 6) + j] = A[24 * i + 18 + j];
        }
    }
    if (is_finite(found.A, 144) == 0 || is_finite(found.B, 72) == 0) {
        return STEWART_NOT_FINITE;
    }
    *out = found;
    return STEWART_OK;
}
""",
}
"""The functions of one pose: name -> text."""

_LOAD_POSE = {
    "copy_to": """\
/* Numbers of one pose to their place in an array of all poses, if there is one. */
static void copy_to(const stewart_real *from, int count, size_t pose, stewart_real *to)
{
    if (to != NULL) {
        copy(from, count, &to[pose * (size_t)count]);
    }
}
""",
    "load_three": """\
static void load_three(const stewart_real *from, size_t pose, stewart_real *to)
{
    int i;
    for (i = 0; i < 3; ++i) {
        to[i] = from != NULL ? from[pose * 3U + (size_t)i] : REAL(0);
    }
}
""",
    "load_pose": """\
/* One pose of a batch; what is not given is zero. */
static void load_pose(const stewart_motions *motions, size_t pose, stewart_motion *one)
{
    copy(&motions->R[pose * 9U], 9, one->R);
    load_three(motions->t, pose, one->t);
    load_three(motions->omega, pose, one->omega);
    load_three(motions->v, pose, one->v);
    load_three(motions->alpha, pose, one->alpha);
    load_three(motions->a, pose, one->a);
    load_three(motions->F_ext, pose, one->F_ext);
    load_three(motions->M_ext, pose, one->M_ext);
}
""",
}
"""What batches share: name -> text."""

_BATCH = """\
int stewart_@NAME@_@WHAT@_batch(
    const stewart_@NAME@_model *model, size_t count, const stewart_motions *motions,
    @ARGUMENT@@OUT@, int *status)
{
    stewart_motion one;
    @DECLARE@
    size_t pose;
    int result = STEWART_OK;
@MISSING@
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        int code;
        load_pose(motions, pose, &one);
        code = stewart_@NAME@_@WHAT@(model, &one, @FORCE@@TARGET@);
        if (code == STEWART_OK) {
@COPIES@
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}
"""
