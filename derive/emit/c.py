"""C99: kernels as one shared header of types and one header and source for each formulation.

Takes shared blocks and hands back text. The code around the blocks (loop over legs, assembly, pivoted
elimination, batches, status) is text in this file; all dynamics come from the blocks. Knows nothing of files.
"""

from .. import notation as n
from ..block import Block, Output, Quantity, Step
from ..formulation import UNIVERSAL
from ..kernel.interface import STRUCTS
from ..kernels import Kernel
from ..operations import KernelOperations
from . import singular
from .infix import infix, wrap
from .lane_scale import ABOUT_REFERENCE, per_length_function


def size(quantity: Quantity) -> int:
    """How many numbers a leg or motion quantity stores."""
    return len(quantity.keys)


def _comment(declaration: str, quantity: Quantity) -> str:
    return f"{declaration} /* {quantity.unit}: {quantity.meaning} */"


def header(
    kernel: Kernel, with_friction: KernelOperations, frictionless: KernelOperations, version: str
) -> str:
    """``stewart_<kernel>.h``: what the kernel computes, its cost, its functions."""
    name = kernel.formulation.kernel_name
    return _HEADER.format(
        name=name,
        guard=f"STEWART_{name.upper()}_H",
        version=version,
        about=_about(kernel),
        interface=_interface(kernel),
        operations=operations_table(with_friction, frictionless, " * "),
    )


def _about(kernel: Kernel) -> str:
    form = kernel.formulation
    first = {
        "exact": "Formulation `exact`: the elimination with joint and inertias treated correctly.",
        "paper": "Formulation `paper`: the equations as printed, faults included.",
    }[form.name]
    joint = {
        True: "Base joint: universal, fixed axis k.",
        False: "Base joint: spherical; legs must be axisymmetric; M_u is zero.",
    }[form.base_joint == UNIVERSAL]
    return f"{first}\n * {joint}"


def _interface(kernel: Kernel) -> str:
    """Inputs that the kernel reads and outputs that it writes, with shapes and units."""
    used = {quantity for block in kernel.blocks for quantity in block.inputs}
    rows = [
        ("Reads of each leg", [_typed(q) for q in n.LEG if q in used]),
        ("Reads of the machine", [_typed(q) for q in n.PLATFORM if q in used]),
        ("Reads of the motion", [_typed(q) for q in n.MOTION if q in used]),
        *(
            (f"Writes {name}", [f"{each.name}{each.dims} {each.unit}" for each in STRUCTS[name]])
            for name in ("forces", "reactions")
        ),
    ]
    return "\n".join(wrap_list(f" * {title}: {', '.join(names)}.", " *     ") for title, names in rows)


def _typed(quantity: Quantity) -> str:
    return f"{quantity.name}{f'[{size(quantity)}]' if quantity.shape else ''} {quantity.unit}"


def operations_table(counts: KernelOperations, frictionless: KernelOperations | None, prefix: str) -> str:
    """Operation counts part by part; with ``frictionless``, beside those without the friction terms."""
    rows = ["Operations of one pose of inverse dynamics, six legs, solve included"]
    if frictionless is None:
        rows += [f"{part:8s} {count}" for part, count in counts.parts().items()]
    else:
        rows.append(f"{'':8s} {'with friction':41s} without friction")
        plain = frictionless.parts()
        rows += [f"{part:8s} {count!s:41s} {plain[part]}" for part, count in counts.parts().items()]
    return "\n".join((prefix + row).rstrip() for row in rows)


def source(kernel: Kernel, version: str) -> str:
    """``stewart_<kernel>.c``: the blocks and the code that runs them."""
    name = kernel.formulation.kernel_name
    has_pole = any(out.quantity == n.k3 for out in kernel.leg.outputs)
    parts = [
        _SOURCE_TOP.format(name=name, version=version) + ARITHMETIC + _APART + singular.MACROS,
        _output_struct(kernel.leg, "leg_terms"),
        _output_struct(kernel.platform, "platform_terms"),
        _output_struct(kernel.reactions, "reaction_terms"),
        block_function(kernel.leg, "leg_terms"),
        block_function(kernel.platform, "platform_terms"),
        block_function(kernel.reactions, "reaction_terms"),
        _STATUS_CHECK.replace("@FINITE@", IS_FINITE).replace("@POLE@", _POLE_CHECK if has_pole else ""),
        per_length_function(*ABOUT_REFERENCE),
        _SOLVE,
        singular.FUNCTION,
        _POSE,
        _PUBLIC.replace("@NAME@", name),
    ]
    return "\n".join(parts)


def _output_struct(block: Block, struct: str) -> str:
    members = "\n".join(
        _comment(
            f"    stewart_real {out.quantity.name}{f'[{size(out.quantity)}]' if out.quantity.shape else ''};",
            out.quantity,
        )
        for out in block.outputs
    )
    return f"typedef struct {{\n{members}\n}} {struct};\n"


def block_function(block: Block, struct: str) -> str:
    """A block as a static function; each named step keeps its equation number and meaning."""
    used = set().union(*(expr.free_symbols for expr in block.expressions()))
    names = {symbol.name for symbol in used}
    loads = [line for quantity in block.inputs for line in _load(quantity, names)]
    arguments = _arguments(block)
    lines = [
        f"/* {block.meaning[0].upper()}{block.meaning[1:]}. Operations: {block.operations()}. */",
        wrap_list(f"static void {block.name}({arguments}, {struct} *out)", "    "),
        "{",
        *loads,
        *step_lines(block.steps, "    "),
        *(line for out in block.outputs for line in _store(out)),
        "}",
        "",
    ]
    return "\n".join(lines)


def _arguments(block: Block) -> str:
    owners = []
    if any(quantity in n.PLATFORM for quantity in block.inputs):
        owners.append("const stewart_robot *robot")
    if any(quantity in n.LEG for quantity in block.inputs):
        owners.append("const stewart_leg *leg")
    owners.append("const stewart_motions *at")
    owners += [f"stewart_real {quantity.name}" for quantity in block.inputs if quantity in (n.x, n.bearing)]
    return ", ".join(owners)


def _load(quantity: Quantity, used: set[str]) -> list[str]:
    owner = next(
        (
            owner
            for owner, group in (("robot", n.PLATFORM), ("leg", n.LEG), ("at", n.MOTION))
            if quantity in group
        ),
        None,
    )
    if owner is None:
        return []
    if not quantity.shape:
        return [f"    const stewart_real {quantity.name} = {owner}->{quantity.name};"]
    loads = [
        f"{name} = {owner}->{quantity.name}[{i}]" for i, name in enumerate(quantity.names) if name in used
    ]
    return [wrap_list(f"    const stewart_real {', '.join(loads)};")]


def wrap_list(text: str, indent: str = " " * 8) -> str:
    """Break a long list after a comma; continuation lines get ``indent``."""
    lines, line = [], ""
    for word in text.split(", "):
        if line and len(line) + len(word) > 100:
            lines.append(line + ",")
            line = indent + word
        else:
            line = f"{line}, {word}" if line else word
    return "\n".join([*lines, line])


def step_lines(steps: tuple[Step, ...], indent: str) -> list[str]:
    """Each step as a constant, with its equation and meaning before the first of a run that shares them."""
    lines = []
    before = None
    for step in steps:
        said = (step.equation, step.meaning)
        if any(said) and said != before:
            lines.append(f"{indent}/* {' '.join(part for part in said if part)} */")
        before = said
        text = f"{indent}const stewart_real {step.name} = {infix(step.expr, 'STEWART_SQRT')};"
        lines.append(wrap(text, indent + " " * 4))
    return lines


def _store(out: Output) -> list[str]:
    name = out.quantity.name
    if not out.quantity.shape:
        return [wrap(f"    out->{name} = {infix(out.exprs[0], 'STEWART_SQRT')};", " " * 8)]
    return [
        wrap(f"    out->{name}[{i}] = {infix(expr, 'STEWART_SQRT')};", " " * 8)
        for i, expr in enumerate(out.exprs)
    ]


_HEADER = """\
/* stewart_{name}.h: inverse dynamics and joint reactions of the Stewart platform.
 *
 * Written by stewart-sym {version}; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * {about}
 *
{interface}
 * Meanings, frames and storage order: stewart.h.
 *
{operations}
 */
#ifndef {guard}
#define {guard}

#include "stewart.h"

#ifdef __cplusplus
extern "C" {{
#endif

/* Actuator forces of one pose. Returns a status. */
STEWART_NODISCARD int stewart_{name}_inverse_dynamics(
    const stewart_robot *robot, const stewart_motion *motion, stewart_forces *forces);

/* Actuator forces and joint reactions of one pose. `bearing`: distance along each leg from the base point to
 * where M_p is taken, m; null: at the base point. Returns a status. */
STEWART_NODISCARD int stewart_{name}_joint_reactions(
    const stewart_robot *robot, const stewart_motion *motion, const stewart_real bearing[6],
    stewart_forces *forces, stewart_reactions *reactions);

/* The same for `count` poses. `status` takes one code for each pose; null: not wanted. Returns the first code
 * other than STEWART_OK, or STEWART_OK. */
STEWART_NODISCARD int stewart_{name}_inverse_dynamics_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions,
    const stewart_forces_arrays *forces, int *status);
STEWART_NODISCARD int stewart_{name}_joint_reactions_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const stewart_real bearing[6],
    const stewart_reactions_arrays *reactions, int *status);

#ifdef __cplusplus
}}
#endif

#endif
"""

ARITHMETIC = """\
#if !defined(STEWART_REAL)
#include <float.h>
#include <math.h>
#if defined(STEWART_FLOAT)
#define STEWART_SQRT(value) sqrtf(value)
#define STEWART_FABS(value) fabsf(value)
#define STEWART_EPSILON FLT_EPSILON
#define STEWART_MAX FLT_MAX
#else
#define STEWART_SQRT(value) sqrt(value)
#define STEWART_FABS(value) fabs(value)
#define STEWART_EPSILON DBL_EPSILON
#define STEWART_MAX DBL_MAX
#endif
#endif

/* A length or sine below this many rounding units of its terms is rounding error and nothing else. */
#define STEWART_ROUNDING (REAL(16) * STEWART_EPSILON)

/* Below this sine of the angle between a leg and the fixed axis of its universal joint, what is measured
 * along that axis has lost six bits; the leg's third axis is taken instead. */
#define STEWART_NEAR_POLE ((stewart_real)0.015625)

/* A leg shorter than this has a square that the arithmetic does not hold to all its digits. */
#if !defined(STEWART_SHORTEST)
#define STEWART_SHORTEST STEWART_SQRT(REAL(1) / STEWART_MAX / STEWART_EPSILON)
#endif

#define REAL(value) ((stewart_real)(value))
#define STEWART_HALF ((stewart_real)0.5)
#define STEWART_LARGER(one, other) ((one) > (other) ? (one) : (other))

/* Sine of the angle between a leg and the fixed axis below which rounding decides where the leg's second axis
 * points: the pole of the universal joint. */
#define STEWART_POLE_SINE (REAL(4096) * STEWART_EPSILON)
"""
"""Macros that every source needs: square root, size, rounding unit and range of the arithmetic."""

_APART = """
#if defined(__GNUC__)
#define STEWART_APART __attribute__((noinline))
#else
#define STEWART_APART
#endif
"""

_SOURCE_TOP = """\
/* stewart_{name}.c: see stewart_{name}.h.
 *
 * Written by stewart-sym {version}; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_{name}.h"

"""

_POLE_CHECK = """\
    if (!(terms->k3 > STEWART_POLE_SINE)) {
        return STEWART_POLE;
    }
"""

IS_FINITE = """\
static int is_finite(const stewart_real *values, int count)
{
    int i;
    for (i = 0; i < count; ++i) {
        if (!(STEWART_FABS(values[i]) <= STEWART_MAX)) {
            return 0;
        }
    }
    return 1;
}
"""
"""Whether all of some numbers are finite."""

_STATUS_CHECK = """\
/* The largest of `least` and the sizes of the values. */
static stewart_real largest(const stewart_real *values, int count, stewart_real least)
{
    stewart_real result = least;
    int i;
    for (i = 0; i < count; ++i) {
        if (STEWART_FABS(values[i]) > result) {
            result = STEWART_FABS(values[i]);
        }
    }
    return result;
}

@FINITE@
/* S = q + t - b is known to within rounding of its largest term, `reach`. */
static int leg_status(const leg_terms *terms, stewart_real reach)
{
    if (is_finite(&terms->L, 1) == 0) {
        return STEWART_NOT_FINITE;
    }
    if (!(terms->L > STEWART_ROUNDING * reach && terms->L > STEWART_SHORTEST)) {
        return STEWART_SHORT_LEG;
    }
@POLE@    return STEWART_OK;
}
"""

_SOLVE = """\
/* Solves the augmented system [H | c] for x by elimination with partial pivoting, (36). Returns 1 where
 * a pivot is small, else 0. */
static int solve(stewart_real A[6][7], stewart_real x[6])
{
    stewart_real inverse[6];
    int i, j, k, suspect = 0;
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        for (i = k + 1; i < 6; ++i) {
            if (STEWART_FABS(A[i][k]) > STEWART_FABS(A[pivot][k])) {
                pivot = i;
            }
        }
        for (j = k; j < 7; ++j) {
            const stewart_real moved = A[k][j];
            A[k][j] = A[pivot][j];
            A[pivot][j] = moved;
        }
        suspect = STEWART_FABS(A[k][k]) > STEWART_SUSPECT ? suspect : 1;
        inverse[k] = REAL(1) / A[k][k];
        for (i = k + 1; i < 6; ++i) {
            const stewart_real factor = A[i][k] * inverse[k];
            for (j = k + 1; j < 7; ++j) {
                A[i][j] = A[i][j] - factor * A[k][j];
            }
        }
    }
    for (i = 5; i >= 0; --i) {
        stewart_real sum = A[i][6];
        for (j = i + 1; j < 6; ++j) {
            sum = sum - A[i][j] * x[j];
        }
        x[i] = sum * inverse[i];
    }
    return suspect;
}
"""

_POSE = """\
static stewart_motions pose_at(const stewart_motions *motions, size_t pose)
{
    static const stewart_real no_load[3] = {REAL(0), REAL(0), REAL(0)};
    stewart_motions at;
    at.R = &motions->R[9U * pose];
    at.t = &motions->t[3U * pose];
    at.omega = &motions->omega[3U * pose];
    at.v = &motions->v[3U * pose];
    at.alpha = &motions->alpha[3U * pose];
    at.a = &motions->a[3U * pose];
    at.F_ext = motions->F_ext != NULL ? &motions->F_ext[3U * pose] : no_load;
    at.M_ext = motions->M_ext != NULL ? &motions->M_ext[3U * pose] : no_load;
    return at;
}

static stewart_motions motion_as_arrays(const stewart_motion *motion)
{
    stewart_motions at;
    at.R = motion->R;
    at.t = motion->t;
    at.omega = motion->omega;
    at.v = motion->v;
    at.alpha = motion->alpha;
    at.a = motion->a;
    at.F_ext = motion->F_ext;
    at.M_ext = motion->M_ext;
    return at;
}

static int motions_given(const stewart_motions *motions)
{
    return motions != NULL && motions->R != NULL && motions->t != NULL && motions->omega != NULL
        && motions->v != NULL && motions->alpha != NULL && motions->a != NULL ? 1 : 0;
}

/* Inverse dynamics of one pose, (1)-(37). */
static int pose_forces(const stewart_robot *robot, const stewart_motions *at, stewart_forces *out)
{
    leg_terms terms;
    platform_terms own;
    stewart_real A[6][7], arm[6][3], reach[6], L[6];
    stewart_real per_length, size = REAL(0);
    int i, j, status, suspect;
    int close = 0;
    platform_wrench(robot, at, &own);
    for (j = 0; j < 3; ++j) {
        out->c[j] = own.c_force[j];
        out->c[j + 3] = own.c_moment[j];
    }
    for (i = 0; i < 6; ++i) {
        leg_dynamics(robot, &robot->leg[i], at, &terms);
        reach[i] = largest(terms.q, 3, REAL(0));
        size = STEWART_LARGER(reach[i], size);
        reach[i] = largest(robot->leg[i].b, 3, largest(at->t, 3, reach[i]));
        L[i] = terms.L;
        status = leg_status(&terms, reach[i]);
        if (status != STEWART_OK) {
            return status;
        }
        close = L[i] > STEWART_SHORT_SHARE * reach[i] ? close : 1;
        out->D[i] = terms.D;
        for (j = 0; j < 3; ++j) {
            arm[i][j] = terms.q[j];
            out->K[i][j] = terms.K[j];
            out->H[j][i] = terms.H_force[j];
            out->H[j + 3][i] = terms.H_moment[j];
            out->c[j] = out->c[j] + terms.c_force[j];
            out->c[j + 3] = out->c[j + 3] + terms.c_moment[j];
        }
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            A[i][j] = out->H[i][j];
        }
        A[i][6] = out->c[i];
    }
    per_length = per_length_of(size);
    if (per_length != REAL(1)) {
        for (i = 0; i < 7; ++i) {
            A[3][i] = A[3][i] * per_length;
            A[4][i] = A[4][i] * per_length;
            A[5][i] = A[5][i] * per_length;
        }
    }
    suspect = solve(A, out->x);
    if (close != 0 || suspect != 0) {
        stewart_real H[6][6];
        for (i = 0; i < 6; ++i) {
            for (j = 0; j < 6; ++j) {
                H[i][j] = out->H[i][j];
            }
        }
        status = singular_status(H, arm, L, reach);
        if (status != STEWART_OK) {
            return status;
        }
    }
    for (i = 0; i < 6; ++i) {
        out->F[i] = out->D[i] - out->x[i];
    }
    return is_finite(out->F, 6) != 0 ? STEWART_OK : STEWART_NOT_FINITE;
}

/* Joint reactions of one pose from its axial forces, (21), (26)-(29), (17). Returns a status. */
static int pose_reactions(
    const stewart_robot *robot, const stewart_motions *at, const stewart_real *bearing,
    const stewart_real x[6], stewart_reactions *out)
{
    const size_t numbers = sizeof *out / sizeof(stewart_real);
    reaction_terms terms;
    int i, j;
    for (i = 0; i < 6; ++i) {
        leg_reactions(robot, &robot->leg[i], at, x[i], bearing != NULL ? bearing[i] : REAL(0), &terms);
        for (j = 0; j < 3; ++j) {
            out->F_s[i][j] = terms.F_s[j];
            out->F_u[i][j] = terms.F_u[j];
            out->F_p[i][j] = terms.F_p[j];
            out->F_c[i][j] = terms.F_c[j];
            out->M_p[i][j] = terms.M_p[j];
        }
        out->M_u[i] = terms.M_u;
    }
    return is_finite((const stewart_real *)out, (int)numbers) != 0 ? STEWART_OK : STEWART_NOT_FINITE;
}

static void copy(stewart_real *to, size_t pose, const stewart_real *from, size_t count)
{
    size_t i;
    if (to != NULL) {
        for (i = 0; i < count; ++i) {
            to[pose * count + i] = from[i];
        }
    }
}
"""

_PUBLIC = """\
int stewart_@NAME@_inverse_dynamics(
    const stewart_robot *robot, const stewart_motion *motion, stewart_forces *forces)
{
    stewart_forces result;
    stewart_motions at;
    int status;
    if (robot == NULL || motion == NULL || forces == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    at = motion_as_arrays(motion);
    status = pose_forces(robot, &at, &result);
    if (status == STEWART_OK) {
        *forces = result;
    }
    return status;
}

int stewart_@NAME@_joint_reactions(
    const stewart_robot *robot, const stewart_motion *motion, const stewart_real bearing[6],
    stewart_forces *forces, stewart_reactions *reactions)
{
    stewart_forces result;
    stewart_reactions found;
    stewart_motions at;
    int status;
    if (robot == NULL || motion == NULL || forces == NULL || reactions == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    at = motion_as_arrays(motion);
    status = pose_forces(robot, &at, &result);
    if (status == STEWART_OK) {
        status = pose_reactions(robot, &at, bearing, result.x, &found);
    }
    if (status == STEWART_OK) {
        *forces = result;
        *reactions = found;
    }
    return status;
}

int stewart_@NAME@_inverse_dynamics_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions,
    const stewart_forces_arrays *forces, int *status)
{
    stewart_forces result;
    size_t pose;
    int first = STEWART_OK;
    if (robot == NULL || motions_given(motions) == 0 || forces == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        const stewart_motions at = pose_at(motions, pose);
        const int code = pose_forces(robot, &at, &result);
        if (code == STEWART_OK) {
            copy(forces->F, pose, result.F, 6);
            copy(forces->D, pose, result.D, 6);
            copy(forces->x, pose, result.x, 6);
            copy(forces->K, pose, (const stewart_real *)result.K, 18);
            copy(forces->H, pose, (const stewart_real *)result.H, 36);
            copy(forces->c, pose, result.c, 6);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        first = first == STEWART_OK ? code : first;
    }
    return first;
}

int stewart_@NAME@_joint_reactions_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const stewart_real bearing[6],
    const stewart_reactions_arrays *reactions, int *status)
{
    stewart_forces forces;
    stewart_reactions result;
    size_t pose;
    int first = STEWART_OK;
    if (robot == NULL || motions_given(motions) == 0 || reactions == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        const stewart_motions at = pose_at(motions, pose);
        int code = pose_forces(robot, &at, &forces);
        if (code == STEWART_OK) {
            code = pose_reactions(robot, &at, bearing, forces.x, &result);
        }
        if (code == STEWART_OK) {
            copy(reactions->F_s, pose, (const stewart_real *)result.F_s, 18);
            copy(reactions->F_u, pose, (const stewart_real *)result.F_u, 18);
            copy(reactions->F_p, pose, (const stewart_real *)result.F_p, 18);
            copy(reactions->F_c, pose, (const stewart_real *)result.F_c, 18);
            copy(reactions->M_p, pose, (const stewart_real *)result.M_p, 18);
            copy(reactions->M_u, pose, result.M_u, 6);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        first = first == STEWART_OK ? code : first;
    }
    return first;
}
"""
