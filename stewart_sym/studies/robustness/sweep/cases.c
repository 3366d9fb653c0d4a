/* Random cases that come near a failure, and the errors of the kernels in each. */
#include <float.h>
#include <math.h>
#include <string.h>
#include "sweep.h"

enum { SINGULAR, JOINT_SINGULAR, SHORT, SCALE, BOTH_SINGULAR, HEAVY, PROPORTIONS, FAR, MACHINE };
/* Where numbers stand in a leg and in a motion. */
#define PLACE(type, member) ((int)(offsetof(type, member) / sizeof(stewart_real)))
#define LEG NUMBERS(stewart_leg)
#define B PLACE(stewart_leg, b)
#define P PLACE(stewart_leg, p)
#define K PLACE(stewart_leg, k)
#define POSITION PLACE(stewart_motion, t)
#define OMEGA PLACE(stewart_motion, omega)
#define VELOCITY PLACE(stewart_motion, v)
#define ALPHA PLACE(stewart_motion, alpha)
#define ACCELERATION PLACE(stewart_motion, a)
#define FORCE PLACE(stewart_motion, F_ext)
#define MOMENT PLACE(stewart_motion, M_ext)
#define BODY (6 * LEG + 1)
/* Random changes of all inputs find less than all of what each can do, by no more than this factor. */
#define MAY_BE_WITHIN(error, limit) ((error) > (limit) && (error) < 30 * (limit))

WIDER(wide)
WIDER(quad)
OF_KERNELS(double)
OF_KERNELS(float)

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
        S[i] = q[i] + motion[POSITION + i] - leg[B + i];
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
    normals(motion + POSITION, 0.15 * size, seed);
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            motion[POSITION + j] += numbers[LEG * i + B + j] / 6;
        }
    }
    motion[POSITION + 2] += 1.1 * size;
    normals(motion + OMEGA, 0.5 * sqrt(rate2), seed);
    normals(motion + VELOCITY, 0.5 * sqrt(rate2) * size, seed);
    normals(motion + ALPHA, 0.5 * rate2, seed);
    normals(motion + ACCELERATION, 0.5 * rate2 * size, seed);
    normals(motion + FORCE, weight, seed);
    normals(motion + MOMENT, weight * size, seed);
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
            at[POSITION + i] = motion[POSITION + i] + way[i];
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
            at[POSITION + i] = motion[POSITION + i] + middle * way[i];
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
        at[POSITION + i] = motion[POSITION + i] + low * way[i];
    }
    memcpy(motion, at, sizeof at);
    return 1;
}

/* Turns a leg's fixed axis to an angle from the leg. */
static void near_joint_singular(double *leg, double distance, const double *motion, uint64_t *seed)
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
        reach = fmax(reach, fmax(fabs(q[i]), fabs(motion[POSITION + i])));
    }
    for (i = 0; i < 3; ++i) {
        leg[B + i] = q[i] + motion[POSITION + i] - distance * reach * way[i] / size_of(way);
    }
}

static void scaled(double *values, int count, double factor)
{
    int i;
    for (i = 0; i < count; ++i) {
        values[i] *= factor;
    }
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

/* The same machine and motion seen from a reference point up to 1e4 platform radii away; in float up to 100, as
 * rounding R puts the inertia about it off by a share of its square. */
static void far_reference(double *numbers, double *motion, int in_float, double *distance, uint64_t *seed)
{
    const double times = pow(10, (in_float ? 2 : 4) * uniform(seed)), far = times * length_of(numbers);
    double d[3], r[3], turn[3], twice[3], moment[3], size;
    int leg, i;
    normals(d, 1, seed);
    size = size_of(d);
    for (i = 0; i < 3; ++i) {
        d[i] *= far / size;
    }
    for (i = 0; i < 3; ++i) {
        r[i] = motion[3 * i] * d[0] + motion[3 * i + 1] * d[1] + motion[3 * i + 2] * d[2];
        numbers[BODY + i] += d[i];
        for (leg = 0; leg < 6; ++leg) {
            numbers[LEG * leg + P + i] += d[i];
        }
    }
    cross(motion + OMEGA, r, turn);
    cross(motion + OMEGA, turn, twice);
    cross(d, motion + FORCE, moment);
    for (i = 0; i < 3; ++i) {
        motion[POSITION + i] -= r[i];
        motion[VELOCITY + i] -= turn[i];
        motion[ACCELERATION + i] -= twice[i];
        motion[MOMENT + i] += moment[i];
    }
    cross(motion + ALPHA, r, turn);
    for (i = 0; i < 3; ++i) {
        motion[ACCELERATION + i] -= turn[i];
    }
    *distance = fmin(*distance, 1 / times);
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
        scaled(motion + MOMENT, 3, smaller);
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
    static const int masses[3][2] = {
        {PLACE(stewart_leg, m_d), 1}, {PLACE(stewart_leg, I_d0), 7}, {PLACE(stewart_leg, I_u0), 6}
    };
    const double way = pow(10, -nearest * uniform(&seed));
    double *leg = numbers + LEG * (int)(next(&seed) % 6);
    int i;
    random_motion(numbers, size, calm, &seed);
    random_motion(numbers, size, motion, &seed);
    if (next(&seed) % 4 == 0) {
        /* At rest: where the machine feels little of a failure, little may be lost. */
        memset(motion + OMEGA, 0, 12 * sizeof *motion);
    }
    *distance = way;
    if ((kind == SINGULAR || kind == BOTH_SINGULAR)
        && !near_singular(numbers, size, way, motion, &seed)) {
        return 0;
    }
    if (kind == JOINT_SINGULAR || kind == BOTH_SINGULAR) {
        near_joint_singular(leg, kind == JOINT_SINGULAR ? way : pow(10, -nearest * uniform(&seed)), motion, &seed);
    }
    if (kind == SHORT) {
        near_short(leg, way, motion, &seed);
    }
    if (kind == HEAVY) {
        *distance = pow(10, -6 * uniform(&seed));
        for (i = 0; i < 3; ++i) {
            scaled(leg + masses[i][0], masses[i][1], 1 / *distance);
        }
        near_joint_singular(leg, pow(10, -3 * uniform(&seed)), motion, &seed);
    }
    if (kind == PROPORTIONS || kind == FAR) {
        out_of_proportion(numbers, motion, distance, &seed);
    }
    if (kind == FAR) {
        far_reference(numbers, motion, in_float, distance, &seed);
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

/* Solves a case in the wider type; in quadruple precision where a kernel looks wrong, or always. */
static void solved(
    const double *numbers, const double *motion, int in_float, int samples, int in_quad, uint64_t seed,
    verdict *truth)
{
    const double length = length_of(numbers);
    if (in_quad || LDBL_MANT_DIG < 64) {
        quad_solve(numbers, motion, length, in_float ? 1e-12 : 1e-20, samples, seed, truth);
    } else {
        wide_solve(numbers, motion, length, in_float ? 1e-12 : 0x1p-53, samples, seed, truth);
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

/* Errors of given cases or, where `motions` is null, of random ones of each robot in turn. */
void sweep_cases(
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
                solved(mine, motion, in_float, level < 2 ? samples : -1, level > 0, next(&own_seed), &truth);
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

/* The closed form's kernels named by the bits of `wanted`, on the cases that sweep_cases makes; of machines
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
        int k, level, status[CLOSED_KERNELS] = {0}, truth[CLOSED_KERNELS] = {0};
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
        solved(mine, motion, in_float, 0, in_quad, 0, &pose);
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
                    weigh(
                        blocks + k, k, length, epsilon, kind == PROPORTIONS || kind == FAR, found, high, low,
                        change, out);
                    worst = fmax(worst, out->error[kernel]);
                }
            }
            if (!(level == 0 ? worst > doubtful : MAY_BE_WITHIN(worst, doubtful))) {
                break;
            }
        }
    }
}

/* The case that sweep_cases makes of a robot's number i, as it makes it. */
void show_case(
    int kind, int in_float, double nearest, uint64_t seed, size_t index, const double *numbers, double size,
    double *mine, double *motion)
{
    double calm[MOTION_NUMBERS], distance;
    uint64_t own_seed = seed + index * 0x2545F4914F6CDD1Du;
    drawn(kind, in_float, nearest, &own_seed, numbers, size, 0, mine, motion, calm, &distance);
}
