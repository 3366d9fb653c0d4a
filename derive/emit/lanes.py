"""C99 for speed: the regrouped force kernel with legs, or poses, side by side in lanes.

One pose puts its six legs into lanes of eight; a batch puts eight poses into them. Either way a block is the
body of a loop over lanes, which compilers turn into vector instructions by themselves, and which is plain
portable C where they don't. Knows layout and solving, no dynamics.
"""

from collections.abc import Iterable

from .. import notation as n
from ..block import Block, Output, Quantity
from ..operations import force_operations
from ..reduce import share
from ..regroup import ADDED, PLATFORM, Bm, ForceKernel
from .c import ARITHMETIC, operations_table, size, step_lines, wrap_list
from .infix import infix, wrap

LANES = 8


def header(kernel: ForceKernel, frictionless: ForceKernel, version: str) -> str:
    """``stewart_<kernel>_forces.h``: the prepared model and the functions."""
    name = kernel.formulation.kernel_name
    counts = operations_table(force_operations(kernel), force_operations(frictionless), " * ")
    return _HEADER.format(
        name=name,
        guard=f"STEWART_{name.upper()}_FORCES_H",
        version=version,
        operations=counts,
        legs="\n".join(_member(q, f"[{LANES}]") for q in _leg_constants(kernel)),
        platform="\n".join(_member(q, "") for q in PLATFORM),
    )


def source(kernel: ForceKernel, version: str) -> str:
    """``stewart_<kernel>_forces.c``: preparation, one pose, batch."""
    name = kernel.formulation.kernel_name
    leg, shared = share(kernel.leg), share(kernel.shared)
    pole = any(out.quantity == n.k3 for out in leg.outputs)
    constants = _leg_constants(kernel)
    parts = [
        _TOP.format(name=name, version=version) + ARITHMETIC + _MACROS,
        _structs(leg),
        _prepare_function(share(kernel.prepare_leg), "prepared_leg"),
        _prepare_function(share(kernel.prepare_platform), "prepared_platform"),
        _prepare(constants).replace("@NAME@", name),
        _scalar_shared(shared).replace("@NAME@", name),
        _block_shared(shared).replace("@NAME@", name),
        _lane_function(leg, "legs_of_pose", over_legs=True, pole=pole).replace("@NAME@", name),
        _lane_function(leg, "leg_of_block", over_legs=False, pole=pole).replace("@NAME@", name),
        _POSE.replace("@NAME@", name),
        _BATCH.replace("@NAME@", name).replace("@LOADS@", _transposed()).replace("@SOLVE@", _solve_block()),
    ]
    return "\n".join(parts)


def model_numbers(kernel: ForceKernel) -> int:
    """How many numbers ``stewart_<kernel>_model`` holds."""
    return LANES * sum(size(q) for q in _leg_constants(kernel)) + sum(size(q) for q in PLATFORM)


def _leg_constants(kernel: ForceKernel) -> list[Quantity]:
    return [out.quantity for out in kernel.prepare_leg.outputs if out.quantity not in ADDED]


def _dims(quantity: Quantity) -> str:
    return f"[{size(quantity)}]" if quantity.shape else ""


def _member(quantity: Quantity, lanes: str) -> str:
    return (
        f"    stewart_real {quantity.name}{_dims(quantity)}{lanes}; /* {quantity.unit}: {quantity.meaning} */"
    )


def _structs(leg: Block) -> str:
    motion = "\n".join(f"    stewart_real {q.name}[{size(q)}][{LANES}];" for q in n.MOTION)
    outs = [out.quantity for out in leg.outputs if out.quantity not in (n.q, n.L, n.k3)]
    terms = "\n".join(f"    stewart_real {q.name}{_dims(q)}[{LANES}];" for q in outs)
    return _STRUCTS.replace("@MOTION@", motion).replace("@TERMS@", terms)


# ---------------------------------------------------------------- preparation


def _prepare_function(block: Block, struct: str) -> str:
    members = "\n".join(f"    stewart_real {o.quantity.name}{_dims(o.quantity)};" for o in block.outputs)
    used = {symbol.name for expr in block.expressions() for symbol in expr.free_symbols}
    loads = [line for q in block.inputs for line in _loads(q, _owner_of_raw(q), "", used, "    ")]
    has_leg = any(q in n.LEG for q in block.inputs)
    arguments = ["const stewart_robot *robot"]
    arguments += ["const stewart_leg *leg"] if has_leg else ["const prepared_leg *sum"]
    unused = [] if any(q in n.PLATFORM for q in block.inputs) else ["    (void)robot;"]
    body = [
        *unused,
        *loads,
        *step_lines(block.steps, "    "),
        *_stores(block.outputs, "", "    "),
    ]
    return "\n".join(
        [
            f"typedef struct {{\n{members}\n}} {struct};\n",
            f"/* {block.meaning[0].upper()}{block.meaning[1:]}. */",
            f"static void {block.name}({', '.join(arguments)}, {struct} *out)",
            "{",
            *body,
            "}",
            "",
        ]
    )


def _owner_of_raw(quantity: Quantity) -> str:
    if quantity in n.LEG:
        return "leg"
    return "sum" if quantity in ADDED else "robot"


def _prepare(constants: list[Quantity]) -> str:
    parts = {
        "@COPIES@": [f"        model->{name}[i] = found.{name};" for name in _entries(constants)],
        "@ZERO@": [f"    sum.{name} = 0;" for name in _entries(ADDED)],
        "@ADD@": [f"        sum.{name} = sum.{name} + found.{name};" for name in _entries(ADDED)],
        "@PLATFORM@": [f"    model->{name} = platform.{name};" for name in _entries(PLATFORM)],
    }
    text = _PREPARE
    for mark, lines in parts.items():
        text = text.replace(mark, "\n".join(lines))
    return text


def _entries(quantities: Iterable[Quantity]) -> list[str]:
    """``h[0]``, ``h[1]``, ``h[2]``, ``g_k``: the stored numbers of the quantities, in order."""
    return [q.name + (f"[{i}]" if q.shape else "") for q in quantities for i in range(size(q))]


# ---------------------------------------------------------------- loads and stores


def _loads(quantity: Quantity, owner: str, lane: str, used: set[str], indent: str) -> list[str]:
    """``const stewart_real p_x = leg->p[0]<lane>, ...;`` for the components that are used."""
    if not quantity.shape:
        return [f"{indent}const stewart_real {quantity.name} = {owner}->{quantity.name}{lane};"]
    parts = [
        f"{name} = {owner}->{quantity.name}[{i}]{lane}"
        for i, name in enumerate(quantity.names)
        if name in used
    ]
    return [wrap_list(f"{indent}const stewart_real {', '.join(parts)};", indent + " " * 4)]


def _stores(outputs: tuple[Output, ...], lane: str, indent: str) -> list[str]:
    lines = []
    for out in outputs:
        for i, expr in enumerate(out.exprs):
            index = f"[{i}]" if out.quantity.shape else ""
            text = f"{indent}out->{out.quantity.name}{index}{lane} = {infix(expr, 'STEWART_SQRT')};"
            lines.append(wrap(text, indent + " " * 4))
    return lines


def _scalar_shared(block: Block) -> str:
    used = {symbol.name for expr in block.expressions() for symbol in expr.free_symbols}
    loads = [
        line for q in block.inputs for line in _loads(q, "at" if q in n.MOTION else "model", "", used, "    ")
    ]
    lines = [*loads, *step_lines(block.steps, "    "), *_stores(block.outputs, "", "    ")]
    return _SHARED_POSE.replace("@BODY@", "\n".join(lines)).replace("@COUNT@", str(block.operations()))


def _block_shared(block: Block) -> str:
    used = {symbol.name for expr in block.expressions() for symbol in expr.free_symbols}
    outside = [
        line for q in block.inputs if q not in n.MOTION for line in _loads(q, "model", "", used, "    ")
    ]
    inside = [line for q in block.inputs if q in n.MOTION for line in _loads(q, "in", "[l]", used, " " * 8)]
    body = [*inside, *step_lines(block.steps, " " * 8), *_stores(block.outputs, "[l]", " " * 8)]
    return _SHARED_BLOCK.replace("@OUTSIDE@", "\n".join(outside)).replace("@BODY@", "\n".join(body))


def _lane_function(block: Block, name: str, over_legs: bool, pole: bool) -> str:
    """The leg's block as the body of a loop over lanes: the legs of a pose, or the poses of a block."""
    used = {symbol.name for expr in block.expressions() for symbol in expr.free_symbols}
    used |= {*n.t.names, *n.b.names}
    inputs = [*block.inputs, *(q for q in (n.t, n.b) if q not in block.inputs)]
    outside, inside = [], []
    for q in inputs:
        if q in (*n.MOTION, Bm):
            owner = ("at" if over_legs else "in") if q in n.MOTION else "shared"
            varies = not over_legs
        elif q in PLATFORM:
            owner, varies = "model", False
        else:
            owner, varies = "model", over_legs
        if varies:
            inside += _loads(q, owner, "[l]", used, " " * 8)
        else:
            lane = "[leg]" if owner == "model" and q not in PLATFORM else ""
            outside += _loads(q, owner, lane, used, "    ")
    kept = tuple(out for out in block.outputs if out.quantity not in (n.q, n.L, n.k3))
    by_name = {out.quantity.name: out.exprs for out in block.outputs}
    terms = [f"STEWART_FABS({text})" for q in ("q", "t", "b") for text in _texts(by_name.get(q), q)]
    length = infix(by_name["L"][0], "STEWART_SQRT")
    sine = infix(by_name["k3"][0], "STEWART_SQRT") if pole else "1"
    body = [
        *inside,
        *step_lines(block.steps, " " * 8),
        *_stores(kept, "[l]", " " * 8),
        *_reach_lines(terms),
        "        out->reach[l] = reach;",
        f"        out->L[l] = {length};",
        f"        out->k3[l] = {sine};",
        f"        bad = {length} <= STEWART_MAX ? (stewart_real)0 : (stewart_real)1;",
        f"        bad = {length} > STEWART_ROUNDING * reach ? bad : (stewart_real)1;",
        f"        out->bad[l] = {sine} > STEWART_ROUNDING ? bad : (stewart_real)1;",
    ]
    head = (_LEGS_OF_POSE if over_legs else _LEG_OF_BLOCK).replace("@COUNT@", str(block.operations()))
    text = head.replace("@OUTSIDE@", "\n".join(outside)).replace("@BODY@", "\n".join(body))
    return text.replace("@FUNCTION@", name)


def _texts(exprs: tuple | None, name: str) -> list[str]:
    if exprs is None:
        return [f"{name}_{axis}" for axis in "xyz"]
    return [infix(expr, "STEWART_SQRT") for expr in exprs]


def _reach_lines(terms: list[str]) -> list[str]:
    lines = ["        stewart_real bad;", f"        stewart_real reach = {terms[0]};"]
    lines += [f"        reach = STEWART_LARGER({term}, reach);" for term in terms[1:]]
    return lines


def _solve_block() -> str:
    """Elimination with partial pivoting, unrolled: one loop over lanes that never branches.

    The row with the largest entry sinks to place k by exchanges that a lane makes or leaves.
    """
    rows, columns = range(6), range(7)
    body = ["stewart_real " + ", ".join(f"a{i}{j} = A[{i}][{j}][l]" for j in columns) + ";" for i in rows]
    body.append("stewart_real " + ", ".join(f"s{i} = {'moment[l]' if i > 2 else '1'}" for i in rows) + ";")
    for k in rows:
        for i in rows[k + 1 :]:
            body += _sink(k, i)
        body.append(f"const stewart_real inverse{k} = 1 / a{k}{k};")
        for i in rows[k + 1 :]:
            body.append(f"const stewart_real factor{i}{k} = a{i}{k} * inverse{k};")
            body += [f"a{i}{j} = a{i}{j} - factor{i}{k} * a{k}{j};" for j in columns[k + 1 :]]
        body.append(f"size[{k}][l] = STEWART_FABS(a{k}{k});")
        body.append(f"least[{k}][l] = STEWART_ROUNDING * s{k};")
    for i in reversed(rows):
        body += [f"a{i}6 = a{i}6 - a{i}{j} * a{j}6;" for j in rows[i + 1 :]]
        body += [f"a{i}6 = a{i}6 * inverse{i};", f"x[{i}][l] = a{i}6;"]
    return _SOLVE_BLOCK.replace("@BODY@", "\n".join(wrap_list(" " * 8 + line, " " * 12) for line in body))


def _sink(k: int, i: int) -> list[str]:
    """Rows k and i exchanged where row i has the larger entry in column k."""
    mask = f"below{i}{k}"
    lines = [
        f"const stewart_real {mask} = STEWART_FABS(a{i}{k}) > STEWART_FABS(a{k}{k})",
        "    ? (stewart_real)1 : (stewart_real)0;",
    ]
    for upper, lower in [(f"s{k}", f"s{i}"), *((f"a{k}{j}", f"a{i}{j}") for j in range(k, 7))]:
        lines += [
            f"const stewart_real {upper}_{i} = {mask} > 0 ? {lower} : {upper};",
            f"{lower} = {mask} > 0 ? {upper} : {lower};",
            f"{upper} = {upper}_{i};",
        ]
    return lines


def _transposed() -> str:
    lines = []
    for q in n.MOTION:
        optional = q in (n.F_ext, n.M_ext)
        width = size(q)
        value = f"motions->{q.name}[pose * {width} + i]"
        if optional:
            value = f"motions->{q.name} ? {value} : 0"
        lines += [
            f"        for (i = 0; i < {width}; ++i) {{",
            f"            in->{q.name}[i][l] = {value};",
            "        }",
        ]
    return "\n".join(lines)


_HEADER = """\
/* stewart_{name}_forces.h: the actuator forces alone, from prepared constants, as fast as we can.
 *
 * Written by stewart-sym {version}; do not edit.
 *
 * One pose puts its six legs into lanes of eight, a batch eight poses; compilers make vector instructions of
 * the loops over lanes (gcc and clang: -O3 -fno-math-errno, and -march for the machine).
 *
{operations}
 */
#ifndef {guard}
#define {guard}

#include "stewart.h"

#ifdef __cplusplus
extern "C" {{
#endif

/* A robot's constants, prepared once; legs in lanes, the last two lanes repeat leg 6. */
typedef struct {{
{legs}
{platform}
}} stewart_{name}_model;

/* Prepares the constants. Returns a status. */
int stewart_{name}_prepare(const stewart_robot *robot, stewart_{name}_model *model);

/* Actuator forces F, N, of one pose, (37). Returns a status; F is written only if it is STEWART_OK. */
int stewart_{name}_forces(const stewart_{name}_model *model, const stewart_motion *motion, stewart_real F[6]);

/* Actuator forces F[count][6] of `count` poses. `status` takes one code for each pose; null: not wanted.
 * Returns the first code other than STEWART_OK, or STEWART_OK. No pose's result depends on the others. */
int stewart_{name}_forces_batch(
    const stewart_{name}_model *model, size_t count, const stewart_motions *motions, stewart_real *F,
    int *status);

#ifdef __cplusplus
}}
#endif

#endif
"""

_TOP = """\
/* stewart_{name}_forces.c: see stewart_{name}_forces.h.
 *
 * Written by stewart-sym {version}; do not edit.
 */
#include "stewart_{name}_forces.h"

"""

_MACROS = """
#if defined(__cplusplus)
#define STEWART_RESTRICT __restrict
#else
#define STEWART_RESTRICT restrict
#endif

#define STEWART_HALF ((stewart_real)0.5)
#define STEWART_LARGER(one, other) ((one) > (other) ? (one) : (other))

/* Compilers make vector instructions of a long loop more readily when it stands in a function of its own. */
#if defined(__GNUC__)
#define STEWART_APART __attribute__((noinline))
#else
#define STEWART_APART
#endif

#define LANES 8
"""

_STRUCTS = """\
/* Motions of eight poses, component by component. */
typedef struct {
@MOTION@
} motion_lanes;

/* What a pose has for all legs. */
typedef struct {
    stewart_real B[9], c_force[3], c_moment[3];
} shared_terms;

typedef struct {
    stewart_real B[9][LANES], c_force[3][LANES], c_moment[3][LANES];
} shared_lanes;

/* Six legs of one pose, or one leg of eight poses. */
typedef struct {
@TERMS@
    stewart_real L[LANES], reach[LANES], k3[LANES];
    stewart_real bad[LANES]; /* 1 where `leg_status` has something to say, else 0 */
} leg_lanes;

/* Status of the leg in one lane. */
static int leg_status(const leg_lanes *leg, int l)
{
    if (!(leg->L[l] <= STEWART_MAX)) {
        return STEWART_NOT_FINITE;
    }
    if (!(leg->L[l] > STEWART_ROUNDING * leg->reach[l])) {
        return STEWART_SHORT_LEG;
    }
    return leg->k3[l] > STEWART_ROUNDING ? STEWART_OK : STEWART_POLE;
}
"""

_PREPARE = """\
int stewart_@NAME@_prepare(const stewart_robot *robot, stewart_@NAME@_model *model)
{
    prepared_leg found, sum;
    prepared_platform platform;
    int i;
    if (!robot || !model) {
        return STEWART_BAD_ARGUMENT;
    }
    prepare_leg(robot, &robot->leg[0], &sum);
@ZERO@
    for (i = 0; i < LANES; ++i) {
        prepare_leg(robot, &robot->leg[i < 6 ? i : 5], &found);
@COPIES@
        if (i >= 6) {
            continue;
        }
@ADD@
    }
    prepare_platform(robot, &sum, &platform);
@PLATFORM@
    return STEWART_OK;
}
"""

_SHARED_POSE = """\
/* What one pose has for all legs: @COUNT@ operations. */
static void shared_of_pose(const stewart_@NAME@_model *model, const stewart_motion *at, shared_terms *out)
{
@BODY@
}
"""

_SHARED_BLOCK = """\
/* The same for eight poses. */
static void shared_of_block(
    const stewart_@NAME@_model *STEWART_RESTRICT model, const motion_lanes *STEWART_RESTRICT in,
    shared_lanes *STEWART_RESTRICT out)
{
    int l;
@OUTSIDE@
    for (l = 0; l < LANES; ++l) {
@BODY@
    }
}
"""

_LEGS_OF_POSE = """\
/* The legs of one pose side by side: @COUNT@ operations each. */
static void @FUNCTION@(
    const stewart_@NAME@_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const shared_terms *STEWART_RESTRICT shared, leg_lanes *STEWART_RESTRICT out)
{
    int l;
@OUTSIDE@
    (void)shared;
    for (l = 0; l < LANES; ++l) {
@BODY@
    }
}
"""

_LEG_OF_BLOCK = """\
/* One leg of eight poses side by side: @COUNT@ operations each. */
static void @FUNCTION@(
    const stewart_@NAME@_model *STEWART_RESTRICT model, int leg, const motion_lanes *STEWART_RESTRICT in,
    const shared_lanes *STEWART_RESTRICT shared, leg_lanes *STEWART_RESTRICT out)
{
    int l;
@OUTSIDE@
    (void)shared;
    for (l = 0; l < LANES; ++l) {
@BODY@
    }
}
"""

_POSE = """\
static void exchange_rows(stewart_real *STEWART_RESTRICT upper, stewart_real *STEWART_RESTRICT lower)
{
    int j;
    for (j = 0; j < LANES; ++j) {
        const stewart_real moved = upper[j];
        upper[j] = lower[j];
        lower[j] = moved;
    }
}

static void subtract_row(
    stewart_real *STEWART_RESTRICT to, stewart_real factor, const stewart_real *STEWART_RESTRICT from)
{
    int j;
    for (j = 0; j < LANES; ++j) {
        to[j] = to[j] - factor * from[j];
    }
}

/* Solves the augmented rows [H | c | 0] for x by elimination with partial pivoting, (36); whole rows are
 * updated, so that a row is one vector. `moment` is the size of the moment rows. */
static int solve_pose(stewart_real A[6][LANES], stewart_real moment, stewart_real x[6])
{
    stewart_real scale[6] = {1, 1, 1, 1, 1, 1};
    stewart_real inverse[6];
    int i, j, k;
    for (i = 3; i < 6; ++i) {
        scale[i] = moment;
    }
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        stewart_real size = STEWART_FABS(A[k][k]);
        stewart_real row_scale;
        for (i = k + 1; i < 6; ++i) {
            if (STEWART_FABS(A[i][k]) > size) {
                size = STEWART_FABS(A[i][k]);
                pivot = i;
            }
        }
        row_scale = scale[pivot];
        scale[pivot] = scale[k];
        if (!(size > STEWART_ROUNDING * row_scale)) {
            return size <= STEWART_MAX ? STEWART_SINGULAR : STEWART_NOT_FINITE;
        }
        if (pivot != k) {
            exchange_rows(A[k], A[pivot]);
        }
        inverse[k] = 1 / A[k][k];
        for (i = k + 1; i < 6; ++i) {
            subtract_row(A[i], A[i][k] * inverse[k], A[k]);
        }
    }
    for (i = 5; i >= 0; --i) {
        stewart_real sum = A[i][6];
        for (j = i + 1; j < 6; ++j) {
            sum = sum - A[i][j] * x[j];
        }
        x[i] = sum * inverse[i];
    }
    return STEWART_OK;
}

int stewart_@NAME@_forces(const stewart_@NAME@_model *model, const stewart_motion *motion, stewart_real F[6])
{
    shared_terms shared;
    leg_lanes legs;
    stewart_real A[6][LANES];
    stewart_real x[6], found[6];
    stewart_real moment = 0;
    int i, j, status;
    if (!model || !motion || !F) {
        return STEWART_BAD_ARGUMENT;
    }
    shared_of_pose(model, motion, &shared);
    legs_of_pose(model, motion, &shared, &legs);
    for (i = 0; i < 6; ++i) {
        if (legs.bad[i] > 0) {
            return leg_status(&legs, i);
        }
    }
    for (j = 0; j < 3; ++j) {
        stewart_real force = shared.c_force[j], turn = shared.c_moment[j];
        for (i = 0; i < 6; ++i) {
            force = force + legs.c_force[j][i];
            turn = turn + legs.c_moment[j][i];
            moment = STEWART_LARGER(STEWART_FABS(legs.H_moment[j][i]), moment);
        }
        for (i = 0; i < LANES; ++i) {
            A[j][i] = legs.H_force[j][i];
            A[j + 3][i] = legs.H_moment[j][i];
        }
        A[j][6] = force;
        A[j + 3][6] = turn;
        A[j][7] = 0;
        A[j + 3][7] = 0;
    }
    status = solve_pose(A, moment, x);
    if (status != STEWART_OK) {
        return status;
    }
    for (i = 0; i < 6; ++i) {
        found[i] = legs.D[i] - x[i];
        if (!(STEWART_FABS(found[i]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    for (i = 0; i < 6; ++i) {
        F[i] = found[i];
    }
    return STEWART_OK;
}
"""

_SOLVE_BLOCK = """\
/* Solves eight systems [H | c] side by side for x by elimination with partial pivoting, (36). Hands back the
 * size of each pivot and the least that is not rounding error; `moment` is the size of the moment rows. */
STEWART_APART static void solve_block(
    stewart_real (*STEWART_RESTRICT A)[7][LANES], const stewart_real *STEWART_RESTRICT moment,
    stewart_real (*STEWART_RESTRICT x)[LANES], stewart_real (*STEWART_RESTRICT size)[LANES],
    stewart_real (*STEWART_RESTRICT least)[LANES])
{
    int l;
    for (l = 0; l < LANES; ++l) {
@BODY@
    }
}
"""

_BATCH = """\
/* Eight poses, component by component; past the end, the last pose again. */
static void load_block(const stewart_motions *motions, size_t first, size_t count, motion_lanes *in)
{
    size_t l, i;
    for (l = 0; l < LANES; ++l) {
        const size_t pose = first + l < count ? first + l : count - 1;
@LOADS@
    }
}

@SOLVE@
/* A block of eight poses on its way: legs, pivots, forces. */
typedef struct {
    leg_lanes legs[6];
    stewart_real size[6][LANES], least[6][LANES], F[6][LANES];
    stewart_real bad[LANES]; /* 1 where `block_status` has something to say, else 0 */
} block;

/* Status of the pose in one lane. */
static int block_status(const block *done, int l)
{
    int i, status;
    for (i = 0; i < 6; ++i) {
        status = leg_status(&done->legs[i], l);
        if (status != STEWART_OK) {
            return status;
        }
    }
    for (i = 0; i < 6; ++i) {
        if (!(done->size[i][l] > done->least[i][l])) {
            return done->size[i][l] <= STEWART_MAX ? STEWART_SINGULAR : STEWART_NOT_FINITE;
        }
    }
    for (i = 0; i < 6; ++i) {
        if (!(STEWART_FABS(done->F[i][l]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    return STEWART_OK;
}

/* Lane by lane: a column entry into the matrix, a part of c onto the right side. */
static void place(
    stewart_real *STEWART_RESTRICT entry, stewart_real *STEWART_RESTRICT right,
    const stewart_real *STEWART_RESTRICT column, const stewart_real *STEWART_RESTRICT part)
{
    int l;
    for (l = 0; l < LANES; ++l) {
        entry[l] = column[l];
        right[l] = right[l] + part[l];
    }
}

/* Lane by lane: the largest size so far. */
static void grow(stewart_real *STEWART_RESTRICT largest, const stewart_real *STEWART_RESTRICT values)
{
    int l;
    for (l = 0; l < LANES; ++l) {
        largest[l] = STEWART_LARGER(STEWART_FABS(values[l]), largest[l]);
    }
}

/* Lane by lane: 1 where a leg, a pivot or a force is no good. */
static void judge(
    stewart_real *STEWART_RESTRICT bad, const stewart_real *STEWART_RESTRICT leg,
    const stewart_real *STEWART_RESTRICT size, const stewart_real *STEWART_RESTRICT least,
    const stewart_real *STEWART_RESTRICT force)
{
    int l;
    for (l = 0; l < LANES; ++l) {
        stewart_real found = leg[l] > 0 ? (stewart_real)1 : bad[l];
        found = size[l] > least[l] ? found : (stewart_real)1;
        bad[l] = STEWART_FABS(force[l]) <= STEWART_MAX ? found : (stewart_real)1;
    }
}

static void forces_of_block(const stewart_@NAME@_model *model, const motion_lanes *in, block *out)
{
    shared_lanes shared;
    stewart_real A[6][7][LANES];
    stewart_real x[6][LANES];
    stewart_real moment[LANES];
    int i, j, l;
    shared_of_block(model, in, &shared);
    for (l = 0; l < LANES; ++l) {
        moment[l] = 0;
        out->bad[l] = 0;
    }
    for (j = 0; j < 3; ++j) {
        for (l = 0; l < LANES; ++l) {
            A[j][6][l] = shared.c_force[j][l];
            A[j + 3][6][l] = shared.c_moment[j][l];
        }
    }
    for (i = 0; i < 6; ++i) {
        leg_of_block(model, i, in, &shared, &out->legs[i]);
        for (j = 0; j < 3; ++j) {
            place(A[j][i], A[j][6], out->legs[i].H_force[j], out->legs[i].c_force[j]);
            place(A[j + 3][i], A[j + 3][6], out->legs[i].H_moment[j], out->legs[i].c_moment[j]);
            grow(moment, out->legs[i].H_moment[j]);
        }
    }
    solve_block(A, moment, x, out->size, out->least);
    for (i = 0; i < 6; ++i) {
        for (l = 0; l < LANES; ++l) {
            out->F[i][l] = out->legs[i].D[l] - x[i][l];
        }
        judge(out->bad, out->legs[i].bad, out->size[i], out->least[i], out->F[i]);
    }
}

int stewart_@NAME@_forces_batch(
    const stewart_@NAME@_model *model, size_t count, const stewart_motions *motions, stewart_real *F,
    int *status)
{
    motion_lanes in;
    block done;
    size_t first;
    int result = STEWART_OK;
    int i, l;
    if (!model || !motions || !F || !motions->R || !motions->t || !motions->omega || !motions->v
        || !motions->alpha || !motions->a) {
        return STEWART_BAD_ARGUMENT;
    }
    for (first = 0; first < count; first += LANES) {
        load_block(motions, first, count, &in);
        forces_of_block(model, &in, &done);
        for (l = 0; l < LANES && first + (size_t)l < count; ++l) {
            const size_t pose = first + (size_t)l;
            const int code = done.bad[l] > 0 ? block_status(&done, l) : STEWART_OK;
            if (code == STEWART_OK) {
                for (i = 0; i < 6; ++i) {
                    F[pose * 6 + (size_t)i] = done.F[i][l];
                }
            } else if (result == STEWART_OK) {
                result = code;
            }
            if (status) {
                status[pose] = code;
            }
        }
    }
    return result;
}
"""
