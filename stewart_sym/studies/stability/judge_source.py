"""C texts of the judge: random cases near failure, the shipped kernels' answers, the truth in wider types.

Texts alone; ``judge`` puts them beside the generated kernels and calls them.
"""

WIDER = """\
/* The forces, and how sensitive they are to their inputs, in a type wider than the kernels'. */
@TYPE@
@RENAMED@
#include <float.h>
#include "stewart_exact_text.h"
#include "judge.h"

#define EACH(array) (int)(sizeof (array) / sizeof (array)[0])

/* Numbers in a leg's own frame change one by one: what is symmetric stays so, and what is zero. */
static const int of_leg[] = {3, 3, 3, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int of_platform[] = {1, 3, 6, 3};
static const int of_motion[] = {9, 3, 3, 3, 3, 3, 3, 3};

/* Copies quantities, each component moved by at most `amount` of its quantity's largest; or, where `only` is
 * not null, by just that the one component to which it counts down. */
static void move(
    stewart_real **to, const double **from, const int *widths, int count, double amount, uint64_t *seed,
    int *only)
{
    int group, i;
    for (group = 0; group < count; ++group) {
        double largest = 0;
        for (i = 0; i < widths[group]; ++i) {
            const double size = (*from)[i] < 0 ? -(*from)[i] : (*from)[i];
            largest = size > largest ? size : largest;
        }
        for (i = 0; i < widths[group]; ++i) {
            const double share = only ? (*only)-- == 0 : amount > 0 ? between(seed) : 0;
            *(*to)++ = (stewart_real)*(*from)++ + (stewart_real)(amount * share) * (stewart_real)largest;
        }
    }
}

static int solved(
    const double *numbers, const double *motion, double amount, uint64_t *seed, int *only,
    stewart_forces *out)
{
    stewart_robot robot;
    stewart_motion at;
    stewart_real *to = (stewart_real *)&robot;
    int leg;
    for (leg = 0; leg < 6; ++leg) {
        move(&to, &numbers, of_leg, EACH(of_leg), amount, seed, only);
    }
    move(&to, &numbers, of_platform, EACH(of_platform), amount, seed, only);
    to = (stewart_real *)&at;
    move(&to, &motion, of_motion, EACH(of_motion), amount, seed, only);
    return stewart_exact_inverse_dynamics(&robot, &at, out);
}

/* Ratio of the largest to the smallest singular value of H, moments over a length; one-sided Jacobi. */
static double condition(const stewart_real H[6][6], double length)
{
    stewart_real A[6][6], size[6], largest = 0, smallest;
    int sweep, i, j, k;
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            A[j][i] = i < 3 ? H[i][j] : H[i][j] / (stewart_real)length;
        }
    }
    for (sweep = 0; sweep < 12; ++sweep) {
        int turned = 0;
        for (i = 0; i < 5; ++i) {
            for (j = i + 1; j < 6; ++j) {
                stewart_real ii = 0, jj = 0, ij = 0, t, c, s, tau;
                for (k = 0; k < 6; ++k) {
                    ii += A[i][k] * A[i][k];
                    jj += A[j][k] * A[j][k];
                    ij += A[i][k] * A[j][k];
                }
                if (!(ij * ij > (stewart_real)1e-24 * ii * jj)) {
                    continue;
                }
                turned = 1;
                tau = (jj - ii) / (2 * ij);
                t = (tau < 0 ? -1 : 1) / (STEWART_FABS(tau) + STEWART_SQRT(1 + tau * tau));
                c = 1 / STEWART_SQRT(1 + t * t);
                s = c * t;
                for (k = 0; k < 6; ++k) {
                    const stewart_real one = A[i][k];
                    A[i][k] = c * one - s * A[j][k];
                    A[j][k] = s * one + c * A[j][k];
                }
            }
        }
        if (!turned) {
            break;
        }
    }
    for (i = 0; i < 6; ++i) {
        size[i] = 0;
        for (k = 0; k < 6; ++k) {
            size[i] += A[i][k] * A[i][k];
        }
        size[i] = STEWART_SQRT(size[i]);
    }
    smallest = size[0];
    for (i = 0; i < 6; ++i) {
        largest = size[i] > largest ? size[i] : largest;
        smallest = size[i] < smallest ? size[i] : smallest;
    }
    return smallest > 0 ? (double)(largest / smallest) : DBL_MAX;
}

/* How far a rounding unit turns a leg's frame: the largest of 1 over |k x s| and of the terms of S over L. */
static double frames(const double *numbers, const double *motion)
{
    double worst = 1;
    int leg, i;
    for (leg = 0; leg < 6; ++leg) {
        const double *b = numbers + 32 * leg, *p = b + 3, *k = b + 6;
        stewart_real S[3], L = 0, sine, reach = 0, ratio;
        for (i = 0; i < 3; ++i) {
            const stewart_real q = (stewart_real)motion[3 * i] * p[0]
                + (stewart_real)motion[3 * i + 1] * p[1] + (stewart_real)motion[3 * i + 2] * p[2];
            const stewart_real terms[3] = {q, (stewart_real)motion[9 + i], (stewart_real)b[i]};
            int j;
            S[i] = terms[0] + terms[1] - terms[2];
            L += S[i] * S[i];
            for (j = 0; j < 3; ++j) {
                reach = STEWART_FABS(terms[j]) > reach ? STEWART_FABS(terms[j]) : reach;
            }
        }
        L = STEWART_SQRT(L);
        sine = 0;
        for (i = 0; i < 3; ++i) {
            const stewart_real part = k[(i + 1) % 3] * S[(i + 2) % 3] - k[(i + 2) % 3] * S[(i + 1) % 3];
            sine += part * part;
        }
        sine = STEWART_SQRT(sine);
        ratio = sine > 0 ? L / sine : STEWART_MAX;
        ratio = reach > ratio * L ? reach / L : ratio;
        worst = ratio > (stewart_real)worst ? (double)ratio : worst;
    }
    return worst;
}

void @NAME@_judge(
    const double *numbers, const double *motion, double length, double amount, int samples, uint64_t seed,
    verdict *out)
{
    stewart_forces truth, moved;
    stewart_real size = 0;
    double sum[6] = {0, 0, 0, 0, 0, 0};
    int sample, i;
    out->status = solved(numbers, motion, 0, &seed, 0, &truth);
    if (out->status != STEWART_OK) {
        return;
    }
    for (i = 0; i < 6; ++i) {
        const stewart_real parts[3] = {truth.F[i], truth.D[i], truth.x[i]};
        int part;
        for (part = 0; part < 3; ++part) {
            size = STEWART_FABS(parts[part]) > size ? STEWART_FABS(parts[part]) : size;
        }
        out->high[i] = (double)truth.F[i];
        out->low[i] = (double)(truth.F[i] - (stewart_real)out->high[i]);
    }
    out->size = (double)size;
    out->own = 0;
    /* Negative: every number by itself, changes added up, instead of random changes of all. */
    for (sample = 0; sample < (samples < 0 ? ROBOT_NUMBERS + MOTION_NUMBERS : samples); ++sample) {
        int only = sample;
        if (solved(numbers, motion, amount, &seed, samples < 0 ? &only : 0, &moved) != STEWART_OK) {
            out->own = 1 / amount;
            break;
        }
        for (i = 0; i < 6; ++i) {
            const double change
                = (double)(STEWART_FABS(moved.F[i] - truth.F[i]) / ((stewart_real)amount * size));
            sum[i] = samples < 0 ? sum[i] + change : change;
            out->own = sum[i] > out->own ? sum[i] : out->own;
        }
    }
    out->frames = frames(numbers, motion);
    out->scaled = condition((const stewart_real(*)[6])truth.H, length);
}
"""

HEADER = """\
#ifndef JUDGE_H
#define JUDGE_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define ROBOT_NUMBERS 205
#define MOTION_NUMBERS 30
#define KERNELS 3
#define CLOSED_KERNELS 6
#define CLOSED_NUMBERS 546

/* What a wider type finds: F as high + low, the largest of |F|, |D| and |x|, the problem's own condition
 * number, the scaled one of H, that of the legs' frames, the status. */
typedef struct {
    double high[6], low[6], size, own, scaled, frames;
    int status;
} verdict;

static inline uint64_t next(uint64_t *seed)
{
    uint64_t z = (*seed += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/* Between -1 and 1. */
static inline double between(uint64_t *seed)
{
    return (double)(next(seed) >> 11) / 4503599627370496.0 - 1;
}

#endif
"""

EVERY = """\
/* The kernel of every output in the kernels' own type. */
@TYPE@
@RENAMED@
#include "stewart_exact_text.h"
#include "judge.h"

int @NAME@_every(const double *numbers, const double *motion, double F[6])
{
    stewart_robot robot;
    stewart_motion at;
    stewart_forces found;
    int i, status;
    for (i = 0; i < ROBOT_NUMBERS; ++i) {
        ((stewart_real *)&robot)[i] = (stewart_real)numbers[i];
    }
    for (i = 0; i < MOTION_NUMBERS; ++i) {
        ((stewart_real *)&at)[i] = (stewart_real)motion[i];
    }
    status = stewart_exact_inverse_dynamics(&robot, &at, &found);
    for (i = 0; i < 6 && status == STEWART_OK; ++i) {
        F[i] = (double)found.F[i];
    }
    return status;
}
"""

FORCES = """\
/* The kernel of the forces alone in the kernels' own type: one pose, and a batch around it. */
@TYPE@
@RENAMED@
#include "stewart_exact_forces_text.h"
#include "judge.h"

#define BATCH 11

void @NAME@_forces(
    const double *numbers, const double *motion, const double *calm, int place, double F[2][6], int status[2])
{
    static const int widths[8] = {9, 3, 3, 3, 3, 3, 3, 3};
    stewart_robot robot;
    stewart_exact_model model;
    stewart_motion at;
    stewart_real arrays[MOTION_NUMBERS * BATCH], one[6], many[6 * BATCH];
    const stewart_real *parts[8];
    stewart_motions motions;
    int codes[BATCH], i, j, group, start = 0;
    for (i = 0; i < ROBOT_NUMBERS; ++i) {
        ((stewart_real *)&robot)[i] = (stewart_real)numbers[i];
    }
    for (i = 0; i < MOTION_NUMBERS; ++i) {
        ((stewart_real *)&at)[i] = (stewart_real)motion[i];
    }
    status[0] = status[1] = stewart_exact_prepare(&robot, &model);
    if (status[0] != STEWART_OK) {
        return;
    }
    for (group = 0; group < 8; ++group) {
        parts[group] = arrays + start * BATCH;
        for (j = 0; j < BATCH; ++j) {
            const double *from = j == place ? motion : calm;
            for (i = 0; i < widths[group]; ++i) {
                arrays[start * BATCH + j * widths[group] + i] = (stewart_real)from[start + i];
            }
        }
        start += widths[group];
    }
    motions.R = parts[0];
    motions.t = parts[1];
    motions.omega = parts[2];
    motions.v = parts[3];
    motions.alpha = parts[4];
    motions.a = parts[5];
    motions.F_ext = parts[6];
    motions.M_ext = parts[7];
    status[0] = stewart_exact_forces(&model, &at, one);
    stewart_exact_forces_batch(&model, BATCH, &motions, many, codes);
    status[1] = codes[place];
    for (i = 0; i < 6; ++i) {
        F[0][i] = (double)one[i];
        F[1][i] = (double)many[6 * place + i];
    }
}
"""

PREPARE = """\
/* The closed form's constants in a wider type. */
@TYPE@
@RENAMED@
#include "stewart_exact_forces_text.h"
"""

CLOSED_FORM = """\
/* The closed form's kernels in one type: their outputs one after the other, a status for each kernel, and how
 * far each output moves with its inputs. */
@TYPE@
@RENAMED@
#include <float.h>
#include "stewart_exact_motion_text.h"
#include "judge.h"

typedef struct {
    stewart_equations equations;
    stewart_real bias[6], acceleration[6], inertia[36];
    stewart_derivatives derivatives;
    stewart_linearisation linearisation;
} outputs;

/* Numbers with each changed by `amount` of itself, up or down; or, where `only` is not null, the one alone to
 * which it counts down. */
static void changed(
    stewart_real *to, const double *from, int count, double amount, uint64_t *seed, int *only)
{
    double by;
    int i;
    for (i = 0; i < count; ++i) {
        to[i] = (stewart_real)from[i];
        by = only ? amount * ((*only)-- == 0) : between(seed) < 0 ? -amount : amount;
        to[i] += to[i] * (stewart_real)by;
    }
}

static void solved(
    const double *numbers, const double *motion, const double *forces, double amount, uint64_t *seed,
    int wanted, int *only, outputs *out, int *status)
{
    stewart_robot robot;
    stewart_motion at;
    stewart_exact_model model;
    stewart_real F[6];
    int prepared, k;
    changed((stewart_real *)&robot, numbers, ROBOT_NUMBERS, amount, seed, only);
    changed((stewart_real *)&at, motion, MOTION_NUMBERS, amount, seed, only);
    changed(F, forces, 6, amount, seed, only);
    prepared = stewart_exact_prepare(&robot, &model);
    for (k = 0; k < CLOSED_KERNELS; ++k) {
        status[k] = prepared;
        if (prepared != STEWART_OK || !(wanted >> k & 1)) {
            continue;
        }
        status[k] = k == 0 ? stewart_exact_equations(&model, &at, &out->equations)
            : k == 1       ? stewart_exact_bias(&model, &at, out->bias)
            : k == 2       ? stewart_exact_forward_dynamics(&model, &at, F, out->acceleration)
            : k == 3       ? stewart_exact_joint_inertia(&model, &at, out->inertia)
            : k == 4       ? stewart_exact_derivatives(&model, &at, &out->derivatives)
                           : stewart_exact_linearisation(&model, &at, F, &out->linearisation);
    }
}

/* high + low: the outputs; change: the largest of any sample over `amount`, infinite with a status;
 * with a negative number of samples the sum of what every input does by itself. */
void @NAME@_closed_form(
    const double *numbers, const double *motion, const double *forces, int wanted, double amount, int samples,
    uint64_t seed, double *high, double *low, double *change, int *status)
{
    static const int of_kernel[CLOSED_KERNELS] = {162, 6, 6, 36, 114, 222};
    outputs truth, moved;
    const stewart_real *at = (const stewart_real *)&truth, *beside = (const stewart_real *)&moved;
    int moved_status[CLOSED_KERNELS], sample, i, k;
    typedef char packed[sizeof(outputs) == CLOSED_NUMBERS * sizeof(stewart_real) ? 1 : -1];
    (void)sizeof(packed);
    memset(&truth, 0, sizeof truth);
    solved(numbers, motion, forces, 0, &seed, wanted, 0, &truth, status);
    for (i = 0; i < CLOSED_NUMBERS; ++i) {
        high[i] = (double)at[i];
        low[i] = (double)(at[i] - (stewart_real)high[i]);
        change[i] = 0;
    }
    for (sample = 0; sample < (samples < 0 ? ROBOT_NUMBERS + MOTION_NUMBERS + 6 : samples); ++sample) {
        int only = sample;
        solved(
            numbers, motion, forces, amount, &seed, wanted, samples < 0 ? &only : 0, &moved, moved_status);
        for (k = i = 0; k < CLOSED_KERNELS; ++k) {
            const int end = i + of_kernel[k];
            for (; i < end && wanted >> k & 1 && !status[k]; ++i) {
                const double moved_by = moved_status[k]
                    ? INFINITY
                    : fabs((double)((beside[i] - at[i]) / (stewart_real)amount));
                change[i] = samples < 0 ? change[i] + moved_by : fmax(change[i], moved_by);
            }
            i = end;
        }
    }
}
"""

CASES = """\
/* Random cases that come near a failure, and the judgement of each. */
#include <float.h>
#include <math.h>
#include <string.h>
#include "judge.h"

enum { SINGULAR, POLE, SHORT, SCALE, POLE_AND_SINGULAR, HEAVY, PROPORTIONS, MACHINE };
#define LEG 32
#define B 0
#define P 3
#define K 6
#define BODY (6 * LEG + 1)
/* Random changes of all inputs find less than all of what each can do, by no more than this factor. */
#define MAY_BE_WITHIN(error, limit) ((error) > (limit) && (error) < 30 * (limit))

@DECLARED@

static double uniform(uint64_t *seed)
{
    return (between(seed) + 1) / 2;
}

static double normal(uint64_t *seed)
{
    double u = uniform(seed);
    while (!(u > 0)) {
        u = uniform(seed);
    }
    return sqrt(-2 * log(u)) * cos(6.283185307179586 * uniform(seed));
}

static void normals(double *to, double size, uint64_t *seed)
{
    int i;
    for (i = 0; i < 3; ++i) {
        to[i] = size * normal(seed);
    }
}

static void cross(const double *x, const double *y, double *z)
{
    z[0] = x[1] * y[2] - x[2] * y[1];
    z[1] = x[2] * y[0] - x[0] * y[2];
    z[2] = x[0] * y[1] - x[1] * y[0];
}

static double size_of(const double *x)
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

/* to = exp([share phi]x) from, Rodrigues. */
static void turned(const double *from, const double *phi, double share, double *to)
{
    const double angle = share * size_of(phi);
    double axis[3], column[3], first[3], second[3];
    int i, j;
    for (i = 0; i < 3; ++i) {
        axis[i] = phi[i] / size_of(phi);
    }
    for (j = 0; j < 3; ++j) {
        for (i = 0; i < 3; ++i) {
            column[i] = from[3 * i + j];
        }
        cross(axis, column, first);
        cross(axis, first, second);
        for (i = 0; i < 3; ++i) {
            to[3 * i + j] = column[i] + sin(angle) * first[i] + 2 * pow(sin(angle / 2), 2) * second[i];
        }
    }
}

static void point(const double *motion, const double *leg, double *q, double *S)
{
    int i;
    for (i = 0; i < 3; ++i) {
        q[i] = motion[3 * i] * leg[P] + motion[3 * i + 1] * leg[P + 1] + motion[3 * i + 2] * leg[P + 2];
        S[i] = q[i] + motion[9 + i] - leg[B + i];
    }
}

/* On which side of the singular poses: the sign of det H. */
static int side(const double *numbers, const double *motion, double size)
{
    double A[6][6], q[3], S[3], moment[3];
    int i, j, k, sign = 1;
    for (i = 0; i < 6; ++i) {
        point(motion, numbers + LEG * i, q, S);
        cross(q, S, moment);
        for (j = 0; j < 3; ++j) {
            A[i][j] = S[j] / size;
            A[i][j + 3] = moment[j] / (size * size);
        }
    }
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        for (i = k + 1; i < 6; ++i) {
            pivot = fabs(A[i][k]) > fabs(A[pivot][k]) ? i : pivot;
        }
        if (pivot != k) {
            double row[6];
            memcpy(row, A[k], sizeof row);
            memcpy(A[k], A[pivot], sizeof row);
            memcpy(A[pivot], row, sizeof row);
            sign = -sign;
        }
        sign = A[k][k] < 0 ? -sign : sign;
        for (i = k + 1; i < 6 && A[k][k] != 0; ++i) {
            const double factor = A[i][k] / A[k][k];
            for (j = k + 1; j < 6; ++j) {
                A[i][j] -= factor * A[k][j];
            }
        }
    }
    return sign;
}

static void random_motion(const double *numbers, double size, double *motion, uint64_t *seed)
{
    static const double E[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double rate2 = 9.81 / size, weight = numbers[6 * LEG] * 9.81;
    double phi[3];
    int i, j;
    normals(phi, 0.2, seed);
    turned(E, phi, 1, motion);
    normals(motion + 9, 0.15 * size, seed);
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            motion[9 + j] += numbers[LEG * i + B + j] / 6;
        }
    }
    motion[11] += 1.1 * size;
    normals(motion + 12, 0.5 * sqrt(rate2), seed);
    normals(motion + 15, 0.5 * sqrt(rate2) * size, seed);
    normals(motion + 18, 0.5 * rate2, seed);
    normals(motion + 21, 0.5 * rate2 * size, seed);
    normals(motion + 24, weight, seed);
    normals(motion + 27, weight * size, seed);
}

/* Moves the pose to a distance, a share of the way, from a singular one. */
static int near_singular(
    const double *numbers, double size, double distance, double *motion, uint64_t *seed)
{
    double at[MOTION_NUMBERS], phi[3], way[3], low = 0, high = 1;
    const int start = side(numbers, motion, size);
    int attempt, i, step;
    memcpy(at, motion, sizeof at);
    for (attempt = 0; attempt < 200; ++attempt) {
        normals(phi, 0.8, seed);
        normals(way, 0.4 * size, seed);
        turned(motion, phi, 1, at);
        for (i = 0; i < 3; ++i) {
            at[9 + i] = motion[9 + i] + way[i];
        }
        if (side(numbers, at, size) != start) {
            break;
        }
    }
    if (attempt == 200) {
        return 0;
    }
    for (step = 0; step < 60; ++step) {
        const double middle = (low + high) / 2;
        turned(motion, phi, middle, at);
        for (i = 0; i < 3; ++i) {
            at[9 + i] = motion[9 + i] + middle * way[i];
        }
        if (side(numbers, at, size) == start) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low += between(seed) < 0 ? -distance : distance;
    turned(motion, phi, low, at);
    for (i = 0; i < 3; ++i) {
        at[9 + i] = motion[9 + i] + low * way[i];
    }
    memcpy(motion, at, sizeof at);
    return 1;
}

/* Turns a leg's fixed axis to an angle from the leg. */
static void near_pole(double *leg, double distance, const double *motion, uint64_t *seed)
{
    double q[3], S[3], across[3], random[3];
    const double sign = between(seed) < 0 ? -1 : 1;
    int i;
    point(motion, leg, q, S);
    normals(random, 1, seed);
    cross(S, random, across);
    for (i = 0; i < 3; ++i) {
        leg[K + i] = sign * S[i] / size_of(S) + distance * across[i] / size_of(across);
    }
    across[0] = size_of(leg + K);
    for (i = 0; i < 3; ++i) {
        leg[K + i] /= across[0];
    }
}

/* Moves a leg's base point to a distance from its platform point, a share of how far off that is. */
static void near_short(double *leg, double distance, const double *motion, uint64_t *seed)
{
    double q[3], S[3], way[3], reach = 0;
    int i;
    point(motion, leg, q, S);
    normals(way, 1, seed);
    for (i = 0; i < 3; ++i) {
        reach = fmax(reach, fmax(fabs(q[i]), fabs(motion[9 + i])));
    }
    for (i = 0; i < 3; ++i) {
        leg[B + i] = q[i] + motion[9 + i] - distance * reach * way[i] / size_of(way);
    }
}

static void scaled(double *values, int count, double factor)
{
    int i;
    for (i = 0; i < count; ++i) {
        values[i] *= factor;
    }
}

/* A platform smaller by up to 1e5, with its body and the load's arm or without; legs longer by up to 1e4. */
static void out_of_proportion(double *numbers, double *motion, double *distance, uint64_t *seed)
{
    const int which = (int)(next(seed) % 3);
    const double smaller = which == 0 ? 1 : pow(10, -5 * uniform(seed));
    double q[3], S[3];
    int leg, i;
    for (leg = 0; leg < 6; ++leg) {
        scaled(numbers + LEG * leg + P, 3, smaller);
    }
    if (next(seed) % 2) {
        scaled(numbers + BODY, 3, smaller);
        scaled(numbers + BODY + 3, 6, smaller * smaller);
        scaled(motion + 27, 3, smaller);
    }
    *distance = smaller;
    for (leg = 0; leg < 6 && which != 1; ++leg) {
        const double longer = next(seed) % 2 ? 1 : pow(10, 4 * uniform(seed));
        point(motion, numbers + LEG * leg, q, S);
        for (i = 0; i < 3; ++i) {
            numbers[LEG * leg + B + i] -= (longer - 1) * S[i];
        }
        *distance = fmin(*distance, 1 / longer);
    }
}

/* One case: numbers and motion in, changed; distance out. Returns 0 if there is none. */
int make_case(
    int kind, double size, double nearest, int in_float, uint64_t seed, double *numbers, double *motion,
    double *calm, double *distance)
{
    /* Where a leg's masses and inertias lie, and how many numbers they are. */
    static const int masses[3][2] = {{9, 1}, {13, 7}, {23, 6}};
    const double way = pow(10, -nearest * uniform(&seed));
    double *leg = numbers + LEG * (int)(next(&seed) % 6);
    int i;
    random_motion(numbers, size, calm, &seed);
    random_motion(numbers, size, motion, &seed);
    if (next(&seed) % 4 == 0) {
        /* At rest: where the machine feels little of a failure, little may be lost. */
        memset(motion + 12, 0, 12 * sizeof *motion);
    }
    *distance = way;
    if ((kind == SINGULAR || kind == POLE_AND_SINGULAR)
        && !near_singular(numbers, size, way, motion, &seed)) {
        return 0;
    }
    if (kind == POLE || kind == POLE_AND_SINGULAR) {
        near_pole(leg, kind == POLE ? way : pow(10, -nearest * uniform(&seed)), motion, &seed);
    }
    if (kind == SHORT) {
        near_short(leg, way, motion, &seed);
    }
    if (kind == HEAVY) {
        *distance = pow(10, -6 * uniform(&seed));
        for (i = 0; i < 3; ++i) {
            scaled(leg + masses[i][0], masses[i][1], 1 / *distance);
        }
        near_pole(leg, pow(10, -3 * uniform(&seed)), motion, &seed);
    }
    if (kind == PROPORTIONS) {
        out_of_proportion(numbers, motion, distance, &seed);
    }
    if (kind == MACHINE) {
        /* Singular at every pose: one in three without a turn, the others turned up to any angle. */
        double phi[3] = {0, 0, 0}, unturned[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        *distance = 0;
        memcpy(motion, unturned, sizeof unturned);
        if (next(&seed) % 3) {
            normals(phi, 0.8, &seed);
            turned(unturned, phi, 1, motion);
        }
    }
    for (i = 0; i < ROBOT_NUMBERS && in_float; ++i) {
        numbers[i] = (double)(float)numbers[i];
    }
    for (i = 0; i < MOTION_NUMBERS && in_float; ++i) {
        motion[i] = (double)(float)motion[i];
        calm[i] = (double)(float)calm[i];
    }
    return 1;
}

static double length_of(const double *numbers)
{
    double square = 0, largest = 0;
    int i, j;
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            largest = fmax(largest, fabs(numbers[LEG * i + P + j]));
        }
    }
    /* Squares of lengths may leave the range. */
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            square += pow(numbers[LEG * i + P + j] / largest, 2);
        }
    }
    return largest * sqrt(square / 6);
}

static double units(const double *F, const verdict *truth, double epsilon)
{
    double worst = 0;
    int i;
    for (i = 0; i < 6; ++i) {
        const double error = fabs((F[i] - truth->high[i]) - truth->low[i]);
        worst = error <= worst ? worst : error;
    }
    return worst / (epsilon * truth->size);
}

/* Judges an answer with the wider type; with quadruple precision where a kernel looks wrong, or always. */
static void judged(
    const double *numbers, const double *motion, int in_float, int samples, int in_quad, uint64_t seed,
    verdict *truth)
{
    const double length = length_of(numbers);
    if (in_quad || LDBL_MANT_DIG < 64) {
        quad_judge(numbers, motion, length, in_float ? 1e-12 : 1e-20, samples, seed, truth);
    } else {
        wide_judge(numbers, motion, length, in_float ? 1e-12 : 0x1p-53, samples, seed, truth);
    }
}

typedef struct {
    double distance, size, own, scaled, frames, error[KERNELS];
    int32_t truth, in_quad, status[KERNELS], made;
} result;

/* A given case, or the random one of that index; a seed for what follows. Returns 0 if there is none. */
static int drawn(
    int kind, int in_float, double nearest, uint64_t *seed, const double *numbers, double size,
    const double *given, double *mine, double *motion, double *calm, double *distance)
{
    int made = given != 0, attempt;
    memcpy(mine, numbers, ROBOT_NUMBERS * sizeof *mine);
    for (attempt = 0; attempt < 10 && !made; ++attempt) {
        memcpy(mine, numbers, ROBOT_NUMBERS * sizeof *mine);
        made = make_case(kind, size, nearest, in_float, next(seed), mine, motion, calm, distance);
    }
    if (given) {
        memcpy(motion, given, MOTION_NUMBERS * sizeof *motion);
        memcpy(calm, given, MOTION_NUMBERS * sizeof *motion);
    }
    return made;
}

/* Judges given cases or, where `motions` is null, random ones of each robot in turn. */
void judge_cases(
    int kind, int in_float, int in_quad, int samples, double nearest, uint64_t seed, size_t robots,
    const double *numbers, const double *sizes, const double *motions, size_t each, double doubtful,
    result *results)
{
    const double epsilon = in_float ? FLT_EPSILON : DBL_EPSILON;
    size_t robot, i;
    for (robot = 0; robot < robots; ++robot) {
        for (i = 0; i < each; ++i) {
            result *out = results + robot * each + i;
            double mine[ROBOT_NUMBERS], motion[MOTION_NUMBERS], calm[MOTION_NUMBERS], F[KERNELS][6];
            uint64_t own_seed = seed + (robot * each + i) * 0x2545F4914F6CDD1Du;
            verdict truth;
            int k, level;
            memset(out, 0, sizeof *out);
            out->made = drawn(
                kind, in_float, nearest, &own_seed, numbers + ROBOT_NUMBERS * robot, sizes[robot],
                motions ? motions + MOTION_NUMBERS * (robot * each + i) : 0, mine, motion, calm,
                &out->distance);
            if (!out->made) {
                continue;
            }
            if (in_float) {
                float_forces(mine, motion, calm, (int)(next(&own_seed) % 11), F, out->status);
                out->status[2] = float_every(mine, motion, F[2]);
            } else {
                double_forces(mine, motion, calm, (int)(next(&own_seed) % 11), F, out->status);
                out->status[2] = double_every(mine, motion, F[2]);
            }
            out->in_quad = in_quad;
            for (k = 0; k < KERNELS && kind == MACHINE; ++k) {
                out->error[k] = NAN;
                out->truth = 4;
            }
            for (level = in_quad; kind != MACHINE && level < 3; ++level) {
                double worst = 0;
                int suspect = 0;
                out->in_quad = level > 0;
                judged(mine, motion, in_float, level < 2 ? samples : -1, level > 0, next(&own_seed), &truth);
                out->truth = truth.status;
                out->size = truth.size;
                out->own = truth.own;
                out->scaled = truth.scaled;
                out->frames = truth.frames;
                for (k = 0; k < KERNELS; ++k) {
                    const double condition = fmax(fmax(truth.own, truth.scaled), 1);
                    out->error[k] = out->status[k] || truth.status ? NAN : units(F[k], &truth, epsilon);
                    worst = out->status[k] ? worst : fmax(worst, out->error[k] / condition);
                    suspect |= truth.status != 0 || (out->status[k] && fmax(truth.own, truth.frames) < 1e7);
                }
                if (level == 0 ? !(suspect || worst > doubtful) : !MAY_BE_WITHIN(worst, doubtful)) {
                    break;
                }
            }
        }
    }
}

/* Of a case: for each kernel the largest error of its blocks over their condition number, in rounding units,
 * the condition number and the block where that is, statuses of the kernels and of the truth. */
typedef struct {
    double distance, scaled, frames, error[CLOSED_KERNELS], condition[CLOSED_KERNELS];
    int32_t block[CLOSED_KERNELS], status[CLOSED_KERNELS], truth[CLOSED_KERNELS], made, in_quad;
} closed_result;

/* A part of a kernel's outputs: its place, and powers of a length that make rows and columns comparable. */
typedef struct {
    int32_t kernel, offset, rows, columns, stride, row, column;
} block;

static void weigh(
    const block *part, int number, double length, double epsilon, int with_scaled, const double *found,
    const double *high, const double *low, const double *change, closed_result *out)
{
    double size = 0, error = 0, moved = 0, condition, ratio;
    int i, j;
    for (i = 0; i < part->rows; ++i) {
        for (j = 0; j < part->columns; ++j) {
            const int at = part->offset + i * part->stride + j;
            const double weight = pow(length, (i % 6 > 2) * part->row + (j % 6 > 2) * part->column);
            const double off = fabs((found[at] - high[at]) - low[at]) * weight;
            size = fmax(size, fabs(high[at]) * weight);
            moved = fmax(moved, change[at] * weight);
            error = off >= 0 ? fmax(error, off) : HUGE_VAL;
        }
    }
    condition = fmax(fmax(size > 0 ? moved / size : 1, 1), with_scaled ? out->scaled : 1);
    ratio = error > 0 ? error / (epsilon * size * condition) : 0;
    ratio = ratio >= 0 ? ratio : HUGE_VAL;
    if (ratio > out->error[part->kernel]) {
        out->error[part->kernel] = ratio;
        out->condition[part->kernel] = condition;
        out->block[part->kernel] = number;
    }
}

/* The closed form's kernels named by the bits of `wanted`, on the cases that judge_cases makes; of machines
 * that are singular at every pose the statuses alone. */
void closed_form_cases(
    int kind, int in_float, int in_quad, int samples, double nearest, uint64_t seed, size_t robots,
    const double *numbers, const double *sizes, const double *motions, size_t each, int wanted,
    const block *blocks, int parts, double doubtful, closed_result *results)
{
    const double epsilon = in_float ? FLT_EPSILON : DBL_EPSILON;
    size_t index;
    for (index = 0; index < robots * each; ++index) {
        closed_result *out = results + index;
        double mine[ROBOT_NUMBERS], motion[MOTION_NUMBERS], calm[MOTION_NUMBERS], F[6], length, worst;
        double found[CLOSED_NUMBERS], none[CLOSED_NUMBERS], high[CLOSED_NUMBERS], low[CLOSED_NUMBERS];
        double change[CLOSED_NUMBERS];
        uint64_t own_seed = seed + index * 0x2545F4914F6CDD1Du;
        verdict pose;
        int k, level, status[CLOSED_KERNELS], truth[CLOSED_KERNELS];
        memset(out, 0, sizeof *out);
        out->made = drawn(
            kind, in_float, nearest, &own_seed, numbers + ROBOT_NUMBERS * (index / each), sizes[index / each],
            motions ? motions + MOTION_NUMBERS * index : 0, mine, motion, calm, &out->distance);
        if (!out->made) {
            continue;
        }
        length = length_of(mine);
        for (k = 0; k < 6; ++k) {
            F[k] = mine[6 * LEG] * 9.81 * normal(&own_seed);
            F[k] = in_float ? (double)(float)F[k] : F[k];
        }
        (in_float ? float_closed_form : double_closed_form)(
            mine, motion, F, wanted, 0, 0, 0, found, none, none, status);
        for (k = 0; k < CLOSED_KERNELS; ++k) {
            out->status[k] = status[k];
            out->truth[k] = 4;
            out->error[k] = -1;
            out->condition[k] = 1;
        }
        if (kind == MACHINE) {
            continue;
        }
        judged(mine, motion, in_float, 0, in_quad, 0, &pose);
        out->scaled = pose.status ? DBL_MAX : pose.scaled;
        out->frames = pose.status ? DBL_MAX : pose.frames;
        for (level = in_quad; level < 3; ++level) {
            out->in_quad = level > 0;
            (level > 0 ? quad_closed_form : wide_closed_form)(
                mine, motion, F, wanted, level > 0 ? 1e-20 : in_float ? 1e-12 : 0x1p-53,
                level < 2 ? samples : -1, own_seed, high, low, change, truth);
            for (k = 0; k < CLOSED_KERNELS; ++k) {
                out->truth[k] = truth[k];
                out->error[k] = -1;
            }
            for (worst = k = 0; k < parts; ++k) {
                const int kernel = blocks[k].kernel;
                if (wanted >> kernel & 1 && !status[kernel] && !truth[kernel]) {
                    weigh(blocks + k, k, length, epsilon, kind == PROPORTIONS, found, high, low, change, out);
                    worst = fmax(worst, out->error[kernel]);
                }
            }
            if (!(level == 0 ? worst > doubtful : MAY_BE_WITHIN(worst, doubtful))) {
                break;
            }
        }
    }
}

/* The case that judge_cases makes of a robot's number i, as it makes it. */
void show_case(
    int kind, int in_float, double nearest, uint64_t seed, size_t index, const double *numbers, double size,
    double *mine, double *motion)
{
    double calm[MOTION_NUMBERS], distance;
    uint64_t own_seed = seed + index * 0x2545F4914F6CDD1Du;
    drawn(kind, in_float, nearest, &own_seed, numbers, size, 0, mine, motion, calm, &distance);
}
"""
