/* stewart_kinematics.c: see stewart_kinematics.h.
 *
 * Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_kinematics.h"

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

typedef struct {
    stewart_real q[3]; /* m: platform point from the reference point, base frame */
    stewart_real S[3]; /* m: vector from base point to platform point, base frame */
    stewart_real L; /* m: length of the leg */
} leg_vectors;

/* Vectors q and S of one leg, and its length L, (1), (2).
 * Operations: 27 (12 mul, 14 add, 0 div, 1 sqrt). */
static void vectors_of(const stewart_leg *leg, const stewart_pose *at, leg_vectors *out)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    /* (1) platform point from the reference point */
    const stewart_real q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z;
    const stewart_real q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z;
    const stewart_real q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z;
    /* (1) leg vector */
    const stewart_real S_x = q_x + t_x - b_x;
    const stewart_real S_y = q_y + t_y - b_y;
    const stewart_real S_z = q_z + t_z - b_z;
    /* (2) leg length */
    const stewart_real L = STEWART_SQRT(S_x*S_x + S_y*S_y + S_z*S_z);
    out->q[0] = q_x;
    out->q[1] = q_y;
    out->q[2] = q_z;
    out->S[0] = S_x;
    out->S[1] = S_y;
    out->S[2] = S_z;
    out->L = L;
}

/* The row [s, q x s] of J, by which [v; omega] moves the leg, (5).
 * Operations: 13 (9 mul, 3 add, 1 div, 0 sqrt). */
static void row_of(const leg_vectors *leg, stewart_real row[6])
{
    const stewart_real q_x = leg->q[0], q_y = leg->q[1], q_z = leg->q[2];
    const stewart_real S_x = leg->S[0], S_y = leg->S[1], S_z = leg->S[2];
    const stewart_real L = leg->L;
    const stewart_real inv_L = REAL(1)/L;
    /* (3) unit vector along the leg */
    const stewart_real s_x = S_x*inv_L;
    const stewart_real s_y = S_y*inv_L;
    const stewart_real s_z = S_z*inv_L;
    row[0] = s_x;
    row[1] = s_y;
    row[2] = s_z;
    row[3] = q_y*s_z - q_z*s_y;
    row[4] = q_z*s_x - q_x*s_z;
    row[5] = q_x*s_y - q_y*s_x;
}

/* Rate L_dot of one leg, (4), (5).
 * Operations: 18 (9 mul, 8 add, 1 div, 0 sqrt). */
static void rate_of(const leg_vectors *leg, const stewart_motion *at, stewart_real *rate_of_leg)
{
    const stewart_real q_x = leg->q[0], q_y = leg->q[1], q_z = leg->q[2];
    const stewart_real S_x = leg->S[0], S_y = leg->S[1], S_z = leg->S[2];
    const stewart_real L = leg->L;
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    /* (4) omega x q */
    const stewart_real w_q_x = omega_y*q_z - omega_z*q_y;
    const stewart_real w_q_y = omega_z*q_x - omega_x*q_z;
    const stewart_real w_q_z = omega_x*q_y - omega_y*q_x;
    /* (4) velocity of the platform point */
    const stewart_real S_dot_x = v_x + w_q_x;
    const stewart_real S_dot_y = v_y + w_q_y;
    const stewart_real S_dot_z = v_z + w_q_z;
    /* (5) L L_dot */
    const stewart_real S_S_dot = S_dot_x*S_x + S_dot_y*S_y + S_dot_z*S_z;
    /* (5) sliding velocity */
    const stewart_real rate = S_S_dot/L;
    *rate_of_leg = rate;
}

/* Cayley's rotation, which needs no sine: exp([turn]x) to third order.
 * Operations: 34 (18 mul, 15 add, 1 div, 0 sqrt). */
static void turned_by(const stewart_real turn[3], stewart_real Q[9])
{
    const stewart_real turn_x = turn[0], turn_y = turn[1], turn_z = turn[2];
    /* half the turn */
    const stewart_real w_x = STEWART_HALF*turn_x;
    const stewart_real w_y = STEWART_HALF*turn_y;
    const stewart_real w_z = STEWART_HALF*turn_z;
    const stewart_real c1 = w_x*w_x;
    const stewart_real c2 = w_y*w_y;
    const stewart_real c3 = w_z*w_z;
    const stewart_real share = REAL(2)/(c1 + c2 + c3 + REAL(1));
    /* products of the half turn */
    const stewart_real W_xx = c1;
    const stewart_real W_xy = w_x*w_y;
    const stewart_real W_xz = w_x*w_z;
    const stewart_real W_yy = c2;
    const stewart_real W_yz = w_y*w_z;
    const stewart_real W_zz = c3;
    Q[0] = share*(-W_yy - W_zz) + REAL(1);
    Q[1] = share*(W_xy - w_z);
    Q[2] = share*(W_xz + w_y);
    Q[3] = share*(W_xy + w_z);
    Q[4] = share*(-W_xx - W_zz) + REAL(1);
    Q[5] = share*(W_yz - w_x);
    Q[6] = share*(W_xz - w_y);
    Q[7] = share*(W_yz + w_x);
    Q[8] = share*(-W_xx - W_yy) + REAL(1);
}

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
