"""C99: lengths and rates of the legs from the platform's motion, its pose and velocity from theirs.

Stands beside ``scalar``, for processors without vector registers: one pose, small plain loops. What is known
of the legs comes from the blocks of ``kinematics``; the search of a pose is text in this file.
"""

from ..block import Block
from ..kinematics import (
    Kinematics,
    search_operations,
    step_operations,
    velocity_operations,
)
from .c import ARITHMETIC, size, step_lines, wrap_list
from .infix import infix, wrap
from .lane_text import dims, filled, loads, names_used, stores

MAX_STEPS = 30
"""Steps after which the search of a pose gives up, unless the compiler is told another number."""

STEPS = {"double": (3, 4, 6), "float": (2, 3, 5)}
"""Steps from near, middling and far guesses, as the header says; the tests hold the kernel to them."""


def header(blocks: Kinematics, version: str) -> str:
    """``stewart_kinematics.h``: what can be asked, what it costs."""
    one_leg = blocks.vectors.operations()
    costs = {
        "lengths": 6 * one_leg,
        "lengths, rates": 6 * (one_leg + blocks.rate.operations()),
        "search": search_operations(blocks),
        "step": step_operations(blocks),
        "velocity": velocity_operations(blocks),
    }
    parts = {
        "@OPERATIONS@": [f" * {name:15s} {count}" for name, count in costs.items()],
        "@MAX_STEPS@": [str(MAX_STEPS)],
        "@STEPS@": [_listed(STEPS["double"])],
        "@FLOAT_STEPS@": [_listed(STEPS["float"])],
    }
    return filled(_HEADER, parts).replace("@VERSION@", version)


def _listed(numbers: tuple[int, int, int]) -> str:
    return f"{numbers[0]}, {numbers[1]} and {numbers[2]}"


def source(blocks: Kinematics, version: str) -> str:
    """``stewart_kinematics.c``: the blocks and the code that runs them."""
    parts = [
        _TOP.replace("@VERSION@", version) + ARITHMETIC + _MACROS,
        _struct(blocks.vectors, "leg_vectors"),
        _function(
            blocks.vectors,
            "const stewart_leg *leg, const stewart_pose *at, leg_vectors *out",
            {"b": "leg", "p": "leg", "R": "at", "t": "at"},
            stores(blocks.vectors.outputs, "", "    "),
        ),
        _function(
            blocks.row,
            "const leg_vectors *leg, stewart_real row[6]",
            dict.fromkeys(("q", "S", "L"), "leg"),
            _entries("row", [expr for out in blocks.row.outputs for expr in out.exprs]),
        ),
        _function(
            blocks.rate,
            "const leg_vectors *leg, const stewart_motion *at, stewart_real *rate_of_leg",
            {**dict.fromkeys(("q", "S", "L"), "leg"), "omega": "at", "v": "at"},
            [f"    *rate_of_leg = {infix(blocks.rate.outputs[0].exprs[0], 'STEWART_SQRT')};"],
        ),
        _function(
            blocks.turned,
            "const stewart_real turn[3], stewart_real Q[9]",
            {"turn": ""},
            _entries("Q", list(blocks.turned.outputs[0].exprs)),
        ),
        _FINITE,
        _LEGS,
        _SOLVE,
        _SEARCH,
        _PUBLIC,
    ]
    return "\n".join(parts)


def legs_header(blocks: Kinematics, version: str) -> str:
    """``stewart_legs.h``: the kinematics of the legs of many poses."""
    operations = [f" * Operations, six legs: {6 * blocks.second.operations()}."]
    return filled(_LEGS_HEADER, {"@OPERATIONS@": operations}).replace("@VERSION@", version)


def legs_source(blocks: Kinematics, version: str) -> str:
    """``stewart_legs.c``: one leg's block and the batch that runs it."""
    names = (quantity.name for quantity in blocks.second.inputs)
    owners = {name: "leg" if name in ("b", "p") else "at" for name in names}
    return "\n".join(
        [
            _LEGS_TOP.replace("@VERSION@", version) + ARITHMETIC,
            _struct(blocks.second, "leg_motion"),
            _function(
                blocks.second,
                "const stewart_leg *leg, const stewart_motions *at, leg_motion *out",
                owners,
                stores(blocks.second.outputs, "", "    "),
            ),
            _LEGS_BATCH,
        ]
    )


def _struct(block: Block, name: str) -> str:
    members = [
        f"    stewart_real {out.quantity.name}{dims(out.quantity)};"
        f" /* {out.quantity.unit}: {out.quantity.meaning} */"
        for out in block.outputs
    ]
    return "\n".join(["typedef struct {", *members, f"}} {name};", ""])


def _entries(array: str, exprs: list) -> list[str]:
    return [
        wrap(f"    {array}[{i}] = {infix(expr, 'STEWART_SQRT')};", " " * 8) for i, expr in enumerate(exprs)
    ]


def _function(block: Block, arguments: str, owners: dict[str, str], ends: list[str]) -> str:
    """A block as a static function; owners: of each input, "" for an array that is an argument."""
    used = names_used(block)
    lines = []
    for quantity in block.inputs:
        owner = owners[quantity.name]
        if owner:
            lines += loads(quantity, owner, "", used, "    ")
        else:
            parts = [
                f"{name} = {quantity.name}[{i}]" for i, name in enumerate(quantity.names[: size(quantity)])
            ]
            lines.append(wrap_list(f"    const stewart_real {', '.join(parts)};"))
    return "\n".join(
        [
            f"/* {block.meaning}.\n * Operations: {block.operations()}. */",
            wrap_list(f"static void {block.name}({arguments})", "    "),
            "{",
            *lines,
            *step_lines(block.steps, "    "),
            *ends,
            "}",
            "",
        ]
    )


_LEGS_HEADER = """\
/* stewart_legs.h: lengths of the legs, their rates and second rates, and their vectors, of many poses.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * Of the robot, the points b and p are read and nothing else. The spin of a leg about its own axis has no
 * part in this: it serves both formulations and either base joint.
 *
@OPERATIONS@
 */
#ifndef STEWART_LEGS_H
#define STEWART_LEGS_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Kinematics of the legs of `count` poses. Any pointer may be null: not wanted. */
typedef struct {
    stewart_real *L; /* [count][6] m: lengths, (2) */
    stewart_real *L_dot; /* [count][6] m/s: rates, (5) */
    stewart_real *L_ddot; /* [count][6] m/s^2: second rates, (8) */
    stewart_real *s; /* [count][6][3] 1: unit vectors along the legs, base frame, (3) */
    stewart_real *S; /* [count][6][3] m: leg vectors, base frame, (1) */
} stewart_legs_arrays;

/* Kinematics of the legs at R, t, omega, v, alpha and a of motions; alpha and a may be null where L_ddot is.
 * Writes each pose's status unless `status` is null, and returns the first that is not STEWART_OK:
 * STEWART_SHORT_LEG if a leg is no longer than the rounding of the terms of S = q + t - b,
 * STEWART_NOT_FINITE. Outputs of such a pose are left as they were. */
STEWART_NODISCARD int stewart_legs_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const stewart_legs_arrays *legs,
    int *status);

#ifdef __cplusplus
}
#endif

#endif
"""

_LEGS_TOP = """\
/* stewart_legs.c: see stewart_legs.h.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_legs.h"

"""

_LEGS_BATCH = """\
/* Six legs of a pose. */
typedef struct {
    stewart_real L[6];
    stewart_real L_dot[6];
    stewart_real L_ddot[6];
    stewart_real s[18];
    stewart_real S[18];
} six_legs;

/* Copies the numbers of a pose into a batch's array, or nothing if it is null. */
static void copy(stewart_real *array, size_t pose, const stewart_real *values, size_t count)
{
    size_t i;
    if (array != NULL) {
        for (i = 0; i < count; ++i) {
            array[(pose * count) + i] = values[i];
        }
    }
}

/* One pose of a batch; `zeros` (3) for accelerations that are not given. */
static stewart_motions pose_at(const stewart_motions *motions, size_t pose, const stewart_real *zeros)
{
    stewart_motions at = *motions;
    at.R = &motions->R[pose * 9U];
    at.t = &motions->t[pose * 3U];
    at.omega = &motions->omega[pose * 3U];
    at.v = &motions->v[pose * 3U];
    at.alpha = (motions->alpha != NULL) ? &motions->alpha[pose * 3U] : zeros;
    at.a = (motions->a != NULL) ? &motions->a[pose * 3U] : zeros;
    return at;
}

/* Largest component of the terms of S = q + t - b of a leg. */
static stewart_real reach_of(const stewart_leg *leg, const stewart_motions *at, const leg_motion *own)
{
    stewart_real reach = REAL(0);
    int i;
    for (i = 0; i < 3; ++i) {
        reach = STEWART_LARGER(STEWART_FABS(own->q[i]), reach);
        reach = STEWART_LARGER(STEWART_FABS(at->t[i]), reach);
        reach = STEWART_LARGER(STEWART_FABS(leg->b[i]), reach);
    }
    return reach;
}

/* Six legs of a pose. Returns a status. */
static int legs_of(const stewart_robot *robot, const stewart_motions *at, six_legs *out)
{
    int status = STEWART_OK;
    int i;
    int j;
    for (i = 0; (i < 6) && (status == STEWART_OK); ++i) {
        leg_motion own;
        stewart_real shortest;
        motion_of(&robot->leg[i], at, &own);
        shortest = STEWART_LARGER(STEWART_ROUNDING * reach_of(&robot->leg[i], at, &own), STEWART_SHORTEST);
        if ((own.L <= STEWART_MAX) && (own.L <= shortest)) {
            status = STEWART_SHORT_LEG;
        } else if ((own.L <= STEWART_MAX) && (STEWART_FABS(own.L_dot) <= STEWART_MAX)
            && (STEWART_FABS(own.L_ddot) <= STEWART_MAX)) {
            status = STEWART_OK;
        } else {
            status = STEWART_NOT_FINITE;
        }
        out->L[i] = own.L;
        out->L_dot[i] = own.L_dot;
        out->L_ddot[i] = own.L_ddot;
        for (j = 0; j < 3; ++j) {
            out->s[(3 * i) + j] = own.s[j];
            out->S[(3 * i) + j] = own.S[j];
        }
    }
    return status;
}

int stewart_legs_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const stewart_legs_arrays *legs,
    int *status)
{
    const stewart_real zeros[3] = {REAL(0), REAL(0), REAL(0)};
    int first = STEWART_OK;
    size_t pose;
    if ((robot == NULL) || (motions == NULL) || (legs == NULL) || (motions->R == NULL) || (motions->t == NULL)
        || (motions->omega == NULL) || (motions->v == NULL)
        || ((legs->L_ddot != NULL) && ((motions->alpha == NULL) || (motions->a == NULL)))) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        const stewart_motions at = pose_at(motions, pose, zeros);
        six_legs result;
        const int code = legs_of(robot, &at, &result);
        if (code == STEWART_OK) {
            copy(legs->L, pose, result.L, 6);
            copy(legs->L_dot, pose, result.L_dot, 6);
            copy(legs->L_ddot, pose, result.L_ddot, 6);
            copy(legs->s, pose, result.s, 18);
            copy(legs->S, pose, result.S, 18);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        first = (first == STEWART_OK) ? code : first;
    }
    return first;
}
"""

_HEADER = """\
/* stewart_kinematics.h: lengths and rates of the legs, and the platform's pose and velocity from them.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * One pose at a time, for a controller. Of the robot, the points b and p are read and nothing else. The spin
 * of a leg about its own axis has no part in this: it serves both formulations and either base joint.
 *
 * Operations, six legs
@OPERATIONS@
 * A search takes the operations of `search` once and those of a step for each that it goes. Steps from
 * guesses within 0.001, 0.05 and 0.3 rad of the pose, and as many lengths of the longest leg: in 99 of 100
 * poses of random machines no more than @STEPS@ (double) and @FLOAT_STEPS@ (float).
 */
#ifndef STEWART_KINEMATICS_H
#define STEWART_KINEMATICS_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Steps after which the search of a pose gives up: the bound of its time. */
#if !defined(STEWART_MAX_STEPS)
#define STEWART_MAX_STEPS @MAX_STEPS@
#endif

/* Pose of the platform. */
typedef struct {
    stewart_real R[9]; /* 1: orientation of the platform, platform frame to base frame, row-major */
    stewart_real t[3]; /* m: position of the platform's reference point, base frame */
} stewart_pose;

/* Lengths L of the legs, m, (2), and their rates L_dot, m/s, (5), at R, t, v and omega of a motion;
 * nothing else of it is read. L_dot may be null: then neither v nor omega is read. Returns a status:
 * STEWART_SHORT_LEG if a leg is no longer than the rounding of the terms of S = q + t - b,
 * STEWART_NOT_FINITE. */
STEWART_NODISCARD int stewart_inverse_kinematics(
    const stewart_robot *robot, const stewart_motion *motion, stewart_real L[6], stewart_real L_dot[6]);

/* Pose in which the legs have the lengths L, m, > 0, from a guess: `pose` in. Newton's steps on (2), none
 * longer than a quarter of a radian and of the longest leg.
 * Returns a status, and writes the pose only if it is STEWART_OK:
 * STEWART_OK: the lengths are those asked for to within 16 rounding units of the largest component of the
 *     terms of S = q + t - b, and R is a rotation to rounding. Six lengths belong to up to forty poses: it is
 *     the one next to the guess if the guess is near; from afar it may be any.
 * STEWART_NOT_CONVERGED: no such pose was found in STEWART_MAX_STEPS steps; or the guess's R is no rotation:
 *     det R < 0, or an entry of R^T R farther than 1/16 from that of E.
 * STEWART_SINGULAR: the lengths are met where H is so near to singular that lengths known to rounding leave
 *     the pose open: its condition number, by Frobenius norms and with moments over the root mean square
 *     distance of the platform points from the reference point, exceeds 1 / (16 sqrt(eps)). That number is no
 *     less than the one by largest and smallest singular value, and no more than six times it.
 * STEWART_SHORT_LEG: a length is not > 0, or a leg has length zero at the guess.
 * STEWART_NOT_FINITE: an input is not finite, or the lengths at the guess overflow. */
STEWART_NODISCARD int stewart_forward_kinematics(
    const stewart_robot *robot, const stewart_real L[6], stewart_pose *pose);

/* Velocity v, m/s, of the reference point and angular velocity omega, rad/s, of the platform, base frame,
 * from the rates of the legs, m/s, at a pose: L_dot = H^T [v; omega], (5). Returns a status:
 * STEWART_SINGULAR as above, STEWART_SHORT_LEG and STEWART_NOT_FINITE. */
STEWART_NODISCARD int stewart_forward_velocity(
    const stewart_robot *robot, const stewart_pose *pose, const stewart_real L_dot[6], stewart_real v[3],
    stewart_real omega[3]);

#ifdef __cplusplus
}
#endif

#endif
"""

_TOP = """\
/* stewart_kinematics.c: see stewart_kinematics.h.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_kinematics.h"

"""

_MACROS = """
#define REAL(value) ((stewart_real)(value))

/* The search ends below this share of the terms of S; what counts as found is STEWART_ROUNDING. */
#define GOAL (4 * STEWART_EPSILON)

/* Longest step, in rad and in lengths of the longest leg: beyond it (2) is far from the straight line that
 * it is taken for. With it, steps need no damping: taking back those that lead away loses more poses. */
#define LONGEST_STEP REAL(0.25)

/* Square of 16 sqrt(eps), one over the condition number at which lengths known to rounding leave a pose
 * open. */
#define OPEN_SHARE (256 * STEWART_EPSILON)

/* A guess whose R^T R is farther than this from E is no rotation. */
#define MOST_SKEW REAL(0.0625)
"""

_FINITE = """\
/* STEWART_OK if all of some numbers are finite, else STEWART_NOT_FINITE. */
static int finite_or_not(const stewart_real *values, int count)
{
    int status = STEWART_OK;
    int i;
    for (i = 0; i < count; ++i) {
        if (!(STEWART_FABS(values[i]) <= STEWART_MAX)) {
            status = STEWART_NOT_FINITE;
        }
    }
    return status;
}
"""

_LEGS = """\
/* Six legs at a pose. */
typedef struct {
    stewart_real J[6][6]; /* 1: rows [s, q x s / size] of the legs */
    stewart_real L[6]; /* m: lengths */
    stewart_real reach; /* m: largest component of the terms of S = q + t - b */
} six_legs;

/* The largest of `result` and the sizes of a vector's components. */
static stewart_real largest(const stewart_real vector[3], stewart_real result)
{
    stewart_real size = result;
    int i;
    for (i = 0; i < 3; ++i) {
        size = STEWART_LARGER(STEWART_FABS(vector[i]), size);
    }
    return size;
}

/* q, S and L of a leg, and the largest component of what S is the sum of. Returns a status. */
static int leg_at(
    const stewart_leg *leg, const stewart_pose *pose, leg_vectors *out, stewart_real *reach)
{
    stewart_real own = REAL(0);
    int status;
    vectors_of(leg, pose, out);
    own = largest(out->q, own);
    own = largest(pose->t, own);
    own = largest(leg->b, own);
    *reach = own;
    if (!(out->L <= STEWART_MAX)) {
        status = STEWART_NOT_FINITE;
    } else if (!((out->L > (STEWART_ROUNDING * own)) && (out->L > STEWART_SHORTEST))) {
        status = STEWART_SHORT_LEG;
    } else {
        status = STEWART_OK;
    }
    return status;
}

/* Lengths and J at a pose. Returns a status. */
static int legs_at(
    const stewart_robot *robot, const stewart_pose *pose, stewart_real per_size, six_legs *out)
{
    int status = STEWART_OK;
    int i;
    int j;
    out->reach = REAL(0);
    for (i = 0; (i < 6) && (status == STEWART_OK); ++i) {
        leg_vectors leg;
        stewart_real reach = REAL(0);
        status = leg_at(&robot->leg[i], pose, &leg, &reach);
        if (status == STEWART_OK) {
            row_of(&leg, out->J[i]);
            for (j = 3; j < 6; ++j) {
                out->J[i][j] = out->J[i][j] * per_size;
            }
            out->L[i] = leg.L;
            out->reach = STEWART_LARGER(reach, out->reach);
        }
    }
    return status;
}

/* Root mean square distance of the platform points from the reference point, by which moments are measured,
 * m; 1 if they lie in it. */
static stewart_real size_of(const stewart_robot *robot)
{
    stewart_real sum = REAL(0);
    stewart_real size;
    int i;
    int j;
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            sum = sum + (robot->leg[i].p[j] * robot->leg[i].p[j]);
        }
    }
    size = STEWART_SQRT(sum / REAL(6));
    return (size > STEWART_SHORTEST) ? size : REAL(1);
}
"""

_SOLVE = """\
/* Equations A = [J | y], or the triangle that they become. */
typedef struct {
    stewart_real A[6][7];
} equations;

static void stack(const six_legs *legs, const stewart_real y[6], equations *of)
{
    int i;
    int j;
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            of->A[i][j] = legs->J[i][j];
        }
        of->A[i][6] = y[i];
    }
}

/* Makes a triangle of A by Householder's reflections, which leave the singular values of J as they are. */
static void reflect(equations *of)
{
    int i;
    int j;
    int k;
    for (k = 0; k < 6; ++k) {
        stewart_real square = REAL(0);
        for (i = k; i < 6; ++i) {
            square = square + (of->A[i][k] * of->A[i][k]);
        }
        if (square > REAL(0)) {
            const stewart_real norm = STEWART_SQRT(square);
            const stewart_real diagonal = (of->A[k][k] > REAL(0)) ? -norm : norm;
            const stewart_real first = of->A[k][k] - diagonal;
            const stewart_real factor = REAL(1) / (diagonal * first);
            of->A[k][k] = first;
            for (j = k + 1; j < 7; ++j) {
                stewart_real sum = REAL(0);
                for (i = k; i < 6; ++i) {
                    sum = sum + (of->A[i][k] * of->A[i][j]);
                }
                sum = sum * factor;
                for (i = k; i < 6; ++i) {
                    of->A[i][j] = of->A[i][j] + (sum * of->A[i][k]);
                }
            }
            of->A[k][k] = diagonal;
        }
    }
}

/* x of the triangle's equations, the last first; 0 where the diagonal entry is. */
static void substitute(const equations *of, stewart_real x[6])
{
    int i;
    int j;
    for (i = 5; i >= 0; --i) {
        stewart_real sum = of->A[i][6];
        for (j = i + 1; j < 6; ++j) {
            sum = sum - (of->A[i][j] * x[j]);
        }
        x[i] = (STEWART_FABS(of->A[i][i]) > REAL(0)) ? (sum / of->A[i][i]) : REAL(0);
    }
}

/* Whether the triangle's condition number, by Frobenius norms, is so large that lengths known to rounding
 * leave the pose open: two poses with the same lengths meet where H is singular, and sqrt(eps) from there
 * they differ by rounding. */
static int is_open(const equations *of)
{
    stewart_real pivot[6] = {0, 0, 0, 0, 0, 0};
    stewart_real inverse[6] = {0, 0, 0, 0, 0, 0};
    stewart_real sum = REAL(0);
    stewart_real sum_of_inverse = REAL(0);
    int open = 0;
    int i;
    int j;
    int k;
    for (k = 0; k < 6; ++k) {
        if (STEWART_FABS(of->A[k][k]) > REAL(0)) {
            pivot[k] = REAL(1) / of->A[k][k];
        } else {
            open = 1;
        }
        for (i = k; i >= 0; --i) {
            stewart_real entry = (i == k) ? REAL(1) : REAL(0);
            for (j = i + 1; j <= k; ++j) {
                entry = entry - (of->A[i][j] * inverse[j]);
            }
            inverse[i] = entry * pivot[i];
            sum = sum + (of->A[i][k] * of->A[i][k]);
            sum_of_inverse = sum_of_inverse + (inverse[i] * inverse[i]);
        }
    }
    if (!((OPEN_SHARE * sum * sum_of_inverse) <= REAL(1))) {
        open = 1;
    }
    return open;
}
"""

_SEARCH = """\
/* A pose, its legs, and by how much they miss the lengths asked for. */
typedef struct {
    stewart_pose pose;
    six_legs legs;
    stewart_real miss[6]; /* m: lengths asked for less lengths */
    stewart_real worst; /* m: the largest */
} attempt;

/* Legs and misses at the attempt's pose. Returns a status. */
static int compare(
    const stewart_robot *robot, const stewart_real L[6], stewart_real per_size, attempt *at)
{
    const int status = legs_at(robot, &at->pose, per_size, &at->legs);
    int i;
    at->worst = REAL(0);
    if (status == STEWART_OK) {
        for (i = 0; i < 6; ++i) {
            at->miss[i] = L[i] - at->legs.L[i];
            at->worst = STEWART_LARGER(STEWART_FABS(at->miss[i]), at->worst);
        }
    }
    return status;
}

/* One of Newton's steps towards the rotation nearest to R: R <- R (3 E - R^T R) / 2. Returns how far an
 * entry of R^T R was from E. */
static stewart_real polish(stewart_real R[9])
{
    stewart_real half[9];
    stewart_real skew = REAL(0);
    int i;
    int j;
    int k;
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 3; ++j) {
            const stewart_real product = (R[i] * R[j]) + (R[3 + i] * R[3 + j]) + (R[6 + i] * R[6 + j]);
            const stewart_real lack = ((i == j) ? REAL(1) : REAL(0)) - product;
            skew = STEWART_LARGER(STEWART_FABS(lack), skew);
            half[(3 * i) + j] = STEWART_HALF * lack;
        }
    }
    for (k = 0; k < 3; ++k) {
        const stewart_real x = R[3 * k];
        const stewart_real y = R[(3 * k) + 1];
        const stewart_real z = R[(3 * k) + 2];
        for (j = 0; j < 3; ++j) {
            R[(3 * k) + j] = R[(3 * k) + j] + ((x * half[j]) + (y * half[3 + j]) + (z * half[6 + j]));
        }
    }
    return skew;
}

/* Makes R a rotation to rounding. Returns whether it was near to one. */
static int make_rotation(stewart_real R[9])
{
    const stewart_real volume = (R[0] * ((R[4] * R[8]) - (R[5] * R[7])))
        + (R[1] * ((R[5] * R[6]) - (R[3] * R[8]))) + (R[2] * ((R[3] * R[7]) - (R[4] * R[6])));
    stewart_real skew = polish(R);
    int near = 0;
    int i;
    if ((volume > REAL(0)) && (skew <= MOST_SKEW)) {
        near = 1;
    }
    /* The distance is squared each time: 2^-4, 2^-8, down to 2^-64. */
    for (i = 0; (i < 4) && ((skew * skew) > STEWART_EPSILON); ++i) {
        skew = polish(R);
    }
    return near;
}

static stewart_real length_of(const stewart_real vector[3])
{
    return STEWART_SQRT((vector[0] * vector[0]) + (vector[1] * vector[1]) + (vector[2] * vector[2]));
}

/* Moves the pose by Newton's step d = [dt; turn], J d = miss, or by as much of it as is to be trusted. */
static void move(attempt *at, stewart_real per_size, stewart_real longest)
{
    stewart_pose from;
    equations of;
    stewart_real d[6] = {0, 0, 0, 0, 0, 0};
    stewart_real Q[9];
    stewart_real shorter = REAL(1);
    int i;
    int j;
    from = at->pose;
    stack(&at->legs, at->miss, &of);
    reflect(&of);
    substitute(&of, d);
    for (i = 3; i < 6; ++i) {
        d[i] = d[i] * per_size;
    }
    shorter = STEWART_LARGER(length_of(d) / (LONGEST_STEP * longest), shorter);
    shorter = STEWART_LARGER(length_of(&d[3]) / LONGEST_STEP, shorter);
    shorter = REAL(1) / shorter;
    for (i = 0; i < 6; ++i) {
        d[i] = d[i] * shorter;
    }
    turned_by(&d[3], Q);
    for (i = 0; i < 3; ++i) {
        at->pose.t[i] = from.t[i] + d[i];
        for (j = 0; j < 3; ++j) {
            at->pose.R[(3 * i) + j] = (Q[3 * i] * from.R[j]) + (Q[(3 * i) + 1] * from.R[3 + j])
                + (Q[(3 * i) + 2] * from.R[6 + j]);
        }
    }
    (void)polish(at->pose.R);
}

/* Goes from a pose to lengths L. Returns whether they were found. */
static int search(const stewart_robot *robot, const stewart_real L[6], stewart_real per_size, attempt *at)
{
    stewart_real longest = L[0];
    int searching = 1;
    int lost = 0;
    int found = 0;
    int i;
    for (i = 1; i < 6; ++i) {
        longest = STEWART_LARGER(L[i], longest);
    }
    for (i = 0; (i < STEWART_MAX_STEPS) && (searching != 0); ++i) {
        if (at->worst <= (GOAL * at->legs.reach)) {
            searching = 0;
        } else {
            move(at, per_size, longest);
            if (compare(robot, L, per_size, at) != STEWART_OK) {
                searching = 0;
                lost = 1;
            }
        }
    }
    if ((lost == 0) && (at->worst <= (STEWART_ROUNDING * at->legs.reach))) {
        found = 1;
    }
    return found;
}

/* Whether the legs' lengths leave the pose open. */
static int leave_open(const six_legs *legs)
{
    static const stewart_real none[6] = {0, 0, 0, 0, 0, 0};
    equations of;
    stack(legs, none, &of);
    reflect(&of);
    return is_open(&of);
}
"""

_PUBLIC = """\
int stewart_inverse_kinematics(
    const stewart_robot *robot, const stewart_motion *motion, stewart_real L[6], stewart_real L_dot[6])
{
    stewart_pose pose;
    stewart_real length[6] = {0, 0, 0, 0, 0, 0};
    stewart_real rate[6] = {0, 0, 0, 0, 0, 0};
    int status = STEWART_OK;
    int i;
    if ((robot == NULL) || (motion == NULL) || (L == NULL)) {
        status = STEWART_BAD_ARGUMENT;
    } else {
        for (i = 0; i < 9; ++i) {
            pose.R[i] = motion->R[i];
        }
        for (i = 0; i < 3; ++i) {
            pose.t[i] = motion->t[i];
        }
        for (i = 0; (i < 6) && (status == STEWART_OK); ++i) {
            leg_vectors leg;
            stewart_real reach = REAL(0);
            status = leg_at(&robot->leg[i], &pose, &leg, &reach);
            length[i] = leg.L;
            if ((status == STEWART_OK) && (L_dot != NULL)) {
                rate_of(&leg, motion, &rate[i]);
                status = finite_or_not(&rate[i], 1);
            }
        }
    }
    if (status == STEWART_OK) {
        for (i = 0; i < 6; ++i) {
            L[i] = length[i];
            if (L_dot != NULL) {
                L_dot[i] = rate[i];
            }
        }
    }
    return status;
}

/* Whether a search can begin: numbers, lengths > 0, a guess that is a rotation, which is made one to
 * rounding. Returns a status. */
static int begin(const stewart_real L[6], stewart_pose *guess)
{
    int status = finite_or_not(L, 6);
    int i;
    if (status == STEWART_OK) {
        status = finite_or_not(guess->R, 9);
    }
    if (status == STEWART_OK) {
        status = finite_or_not(guess->t, 3);
    }
    for (i = 0; i < 6; ++i) {
        if ((status == STEWART_OK) && !(L[i] > REAL(0))) {
            status = STEWART_SHORT_LEG;
        }
    }
    if (status == STEWART_OK) {
        if (make_rotation(guess->R) == 0) {
            status = STEWART_NOT_CONVERGED;
        }
    }
    return status;
}

int stewart_forward_kinematics(const stewart_robot *robot, const stewart_real L[6], stewart_pose *pose)
{
    attempt at;
    int status;
    if ((robot == NULL) || (L == NULL) || (pose == NULL)) {
        status = STEWART_BAD_ARGUMENT;
    } else {
        const stewart_real per_size = REAL(1) / size_of(robot);
        at.pose = *pose;
        status = begin(L, &at.pose);
        if (status == STEWART_OK) {
            status = compare(robot, L, per_size, &at);
        }
        if (status == STEWART_OK) {
            if (search(robot, L, per_size, &at) == 0) {
                status = STEWART_NOT_CONVERGED;
            } else if (leave_open(&at.legs) != 0) {
                status = STEWART_SINGULAR;
            } else {
                status = STEWART_OK;
            }
        }
        if (status == STEWART_OK) {
            *pose = at.pose;
        }
    }
    return status;
}

int stewart_forward_velocity(
    const stewart_robot *robot, const stewart_pose *pose, const stewart_real L_dot[6], stewart_real v[3],
    stewart_real omega[3])
{
    six_legs legs;
    equations of;
    stewart_real twist[6] = {0, 0, 0, 0, 0, 0};
    int status;
    int i;
    if ((robot == NULL) || (pose == NULL) || (L_dot == NULL) || (v == NULL) || (omega == NULL)) {
        status = STEWART_BAD_ARGUMENT;
    } else {
        const stewart_real per_size = REAL(1) / size_of(robot);
        status = legs_at(robot, pose, per_size, &legs);
        if (status == STEWART_OK) {
            stack(&legs, L_dot, &of);
            reflect(&of);
            substitute(&of, twist);
            if (is_open(&of) != 0) {
                status = STEWART_SINGULAR;
            }
        }
        for (i = 3; i < 6; ++i) {
            twist[i] = twist[i] * per_size;
        }
        if (status == STEWART_OK) {
            status = finite_or_not(twist, 6);
        }
    }
    if (status == STEWART_OK) {
        for (i = 0; i < 3; ++i) {
            v[i] = twist[i];
            omega[i] = twist[i + 3];
        }
    }
    return status;
}
"""
