/* stewart_exact_slender_static_forces.c: see stewart_exact_slender_static_forces.h.
 *
 * Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_exact_slender_static_forces.h"

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
 * along that axis has lost five bits; the leg's third axis is taken instead. */
#define STEWART_NEAR_POLE ((stewart_real)0.03125)

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

#if defined(__cplusplus)
#define STEWART_RESTRICT __restrict
#else
#define STEWART_RESTRICT restrict
#endif


/* Compilers make vector instructions of a long loop more readily when it stands in a function of its own. */
#if defined(__GNUC__)
#define STEWART_APART __attribute__((noinline))
#else
#define STEWART_APART
#endif

#define LANES 8

/* Below this share of the vectors that it is the sum of, a leg has lost so many digits that its column of H
 * may be singular to rounding with others while the pivots are large. */
#if !defined(STEWART_SHORT_SHARE)
#if defined(STEWART_FLOAT)
#define STEWART_SHORT_SHARE REAL(0.0625)
#else
#define STEWART_SHORT_SHARE (REAL(64) * STEWART_SQRT(STEWART_EPSILON))
#endif
#endif

/* Pivot below which H may be singular to rounding, 2^-13 or 2^-7. The product of all pivots of a singular H
 * is a few epsilon: where n of them are small, the least is of the order of the n-th root of epsilon at most.
 * Of singular machines that are nearly singular in other ways as well, it was seen to reach 5e-7, in float
 * 2.5e-3. */
#if !defined(STEWART_SUSPECT)
#if defined(STEWART_FLOAT)
#define STEWART_SUSPECT REAL(0.0078125)
#else
#define STEWART_SUSPECT REAL(0.0001220703125)
#endif
#endif

/* Motions of eight poses, component by component. */
typedef struct {
    stewart_real R[9][LANES];
    stewart_real t[3][LANES];
    stewart_real F_ext[3][LANES];
    stewart_real M_ext[3][LANES];
} motion_lanes;

/* What a pose has for all legs. */
typedef struct {
    stewart_real c_force[3];
    stewart_real c_moment[3];
    stewart_real c_tip[3];
} shared_terms;

typedef struct {
    int none; /* C has no structure without members */
} shared_lanes;

/* The legs of one pose. */
typedef struct {
    stewart_real q[3][LANES];
    stewart_real D[LANES];
    stewart_real H_force[3][LANES];
    stewart_real c_force[3][LANES];
    stewart_real H_moment[3][LANES];
    stewart_real arm_c[3][LANES];
    stewart_real L[LANES];
    stewart_real reach[LANES];
    stewart_real bad[LANES]; /* 1 where the leg needs a closer look, else 0 */
} leg_lanes;

/* Status of the leg in one lane. */
static int leg_status(const leg_lanes *leg, int l)
{
    if (!(leg->L[l] <= STEWART_MAX)) {
        return STEWART_NOT_FINITE;
    }
    if (!(leg->L[l] > STEWART_ROUNDING*leg->reach[l])) {
        return STEWART_SHORT_LEG;
    }
    return STEWART_OK;
}

typedef struct {
    stewart_real b[3];
    stewart_real p[3];
    stewart_real w_s;
    stewart_real M_add;
    stewart_real h_add[3];
    stewart_real J_add[6];
    stewart_real C_add;
} prepared_leg;

/* Constants of one leg, and what it adds to the platform. */
static void prepare_leg(const stewart_robot *robot, const stewart_leg *leg, prepared_leg *out)
{
    (void)robot;
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real m_d = leg->m_d;
    const stewart_real r_d0_x = leg->r_d0[0];
    const stewart_real m_u = leg->m_u;
    const stewart_real r_u0_x = leg->r_u0[0];
    const stewart_real h_x = m_u*r_u0_x;
    const stewart_real w_x = h_x + m_d*r_d0_x;
    const stewart_real c1 = m_u*p_x;
    const stewart_real c2 = m_u*p_y;
    const stewart_real c3 = p_y*p_y;
    const stewart_real c4 = p_z*p_z;
    const stewart_real c5 = p_x*p_x;
    out->b[0] = b_x;
    out->b[1] = b_y;
    out->b[2] = b_z;
    out->p[0] = p_x;
    out->p[1] = p_y;
    out->p[2] = p_z;
    out->w_s = w_x;
    out->M_add = m_u;
    out->h_add[0] = c1;
    out->h_add[1] = c2;
    out->h_add[2] = m_u*p_z;
    out->J_add[0] = m_u*(c3 + c4);
    out->J_add[1] = -c1*p_y;
    out->J_add[2] = -c1*p_z;
    out->J_add[3] = m_u*(c4 + c5);
    out->J_add[4] = -c2*p_z;
    out->J_add[5] = m_u*(c3 + c5);
    out->C_add = REAL(0);
}

typedef struct {
    stewart_real h_P[3];
    stewart_real g[3];
    stewart_real W_P[3];
} prepared_platform;

/* Constants of the platform. */
static void prepare_platform(const stewart_robot *robot, const prepared_leg *sum, prepared_platform *out)
{
    const stewart_real M = robot->M;
    const stewart_real R_0_x = robot->R_0[0], R_0_y = robot->R_0[1], R_0_z = robot->R_0[2];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real M_add = sum->M_add;
    const stewart_real h_add_x = sum->h_add[0], h_add_y = sum->h_add[1], h_add_z = sum->h_add[2];
    const stewart_real c1 = M + M_add;
    out->h_P[0] = M*R_0_x + h_add_x;
    out->h_P[1] = M*R_0_y + h_add_y;
    out->h_P[2] = M*R_0_z + h_add_z;
    out->g[0] = g_x;
    out->g[1] = g_y;
    out->g[2] = g_z;
    out->W_P[0] = c1*g_x;
    out->W_P[1] = c1*g_y;
    out->W_P[2] = c1*g_z;
}

/* What moments are multiplied by in the solve where no coordinate of their arms exceeds `size`, 1/m: 1
 * for sizes of about a metre, else one over the least power of two, from 2^-100 to 2^100, that is as
 * large. */
static stewart_real per_length_of(stewart_real size)
{
    int i;
    stewart_real unit = REAL(1);
    if (size >= REAL(0.125) && size <= REAL(16)) {
        return unit;
    }
    for (i = 0; i < 100; ++i) {
        if (!(unit < size)) {
            break;
        }
        unit = REAL(2)*unit;
    }
    for (i = 0; i < 100; ++i) {
        if (!(size > REAL(0) && STEWART_HALF*unit >= size)) {
            break;
        }
        unit = STEWART_HALF*unit;
    }
    return REAL(1)/unit;
}

/* Largest coordinate of the arms of moments about platform point 1, m. */
static stewart_real size_of(const stewart_exact_slender_static_model *model)
{
    int i, j;
    stewart_real largest = REAL(0);
    for (j = 0; j < 3; ++j) {
        for (i = 1; i < 6; ++i) {
            largest = STEWART_LARGER(STEWART_FABS(model->p[j][i] - model->p[j][0]), largest);
        }
    }
    return largest;
}

int stewart_exact_slender_static_prepare(
    const stewart_robot *robot, stewart_exact_slender_static_model *model)
{
    int i;
    stewart_exact_slender_static_model made;
    prepared_leg found;
    prepared_leg sum;
    prepared_platform platform;
    if (robot == NULL || model == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    sum.M_add = REAL(0);
    sum.h_add[0] = REAL(0);
    sum.h_add[1] = REAL(0);
    sum.h_add[2] = REAL(0);
    sum.J_add[0] = REAL(0);
    sum.J_add[1] = REAL(0);
    sum.J_add[2] = REAL(0);
    sum.J_add[3] = REAL(0);
    sum.J_add[4] = REAL(0);
    sum.J_add[5] = REAL(0);
    sum.C_add = REAL(0);
    for (i = 0; i < LANES; ++i) {
        prepare_leg(robot, &robot->leg[i < 6 ? i : 5], &found);
        made.b[0][i] = found.b[0];
        made.b[1][i] = found.b[1];
        made.b[2][i] = found.b[2];
        made.p[0][i] = found.p[0];
        made.p[1][i] = found.p[1];
        made.p[2][i] = found.p[2];
        made.w_s[i] = found.w_s;
        if (i < 6) {
            sum.M_add = sum.M_add + found.M_add;
            sum.h_add[0] = sum.h_add[0] + found.h_add[0];
            sum.h_add[1] = sum.h_add[1] + found.h_add[1];
            sum.h_add[2] = sum.h_add[2] + found.h_add[2];
            sum.J_add[0] = sum.J_add[0] + found.J_add[0];
            sum.J_add[1] = sum.J_add[1] + found.J_add[1];
            sum.J_add[2] = sum.J_add[2] + found.J_add[2];
            sum.J_add[3] = sum.J_add[3] + found.J_add[3];
            sum.J_add[4] = sum.J_add[4] + found.J_add[4];
            sum.J_add[5] = sum.J_add[5] + found.J_add[5];
            sum.C_add = sum.C_add + found.C_add;
        }
    }
    prepare_platform(robot, &sum, &platform);
    made.h_P[0] = platform.h_P[0];
    made.h_P[1] = platform.h_P[1];
    made.h_P[2] = platform.h_P[2];
    made.g[0] = platform.g[0];
    made.g[1] = platform.g[1];
    made.g[2] = platform.g[2];
    made.W_P[0] = platform.W_P[0];
    made.W_P[1] = platform.W_P[1];
    made.W_P[2] = platform.W_P[2];
    made.per_length = per_length_of(size_of(&made));
    const stewart_real *const numbers = (const stewart_real *)&made;
    for (i = 0; i < 66; ++i) {
        if (!(STEWART_FABS(numbers[i]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    *model = made;
    return STEWART_OK;
}

/* What one pose has for all legs: 60 (33 mul, 27 add, 0 div, 0 sqrt) operations. */
static void shared_of_pose(
    const stewart_exact_slender_static_model *model, const stewart_motion *at, shared_terms *out)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real M_ext_x = at->M_ext[0], M_ext_y = at->M_ext[1], M_ext_z = at->M_ext[2];
    const stewart_real h_P_x = model->h_P[0], h_P_y = model->h_P[1], h_P_z = model->h_P[2];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    const stewart_real W_P_x = model->W_P[0], W_P_y = model->W_P[1], W_P_z = model->W_P[2];
    /* (30) first moment of the platform, base frame */
    const stewart_real h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z;
    const stewart_real h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z;
    const stewart_real h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z;
    out->c_force[0] = F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz + W_P_x;
    out->c_force[1] = F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz + W_P_y;
    out->c_force[2] = F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz + W_P_z;
    out->c_moment[0] = M_ext_x*R_xx + M_ext_y*R_xy + M_ext_z*R_xz + g_z*h_base_y - g_y*h_base_z;
    out->c_moment[1] = M_ext_x*R_yx + M_ext_y*R_yy + M_ext_z*R_yz + g_x*h_base_z - g_z*h_base_x;
    out->c_moment[2] = M_ext_x*R_zx + M_ext_y*R_zy + M_ext_z*R_zz + g_y*h_base_x - g_x*h_base_y;
}

/* The legs of one pose side by side: 40 (22 mul, 16 add, 1 div, 1 sqrt) operations each. */
static void legs_of_pose(
    const stewart_exact_slender_static_model *STEWART_RESTRICT model,
    const stewart_motion *STEWART_RESTRICT at, const shared_terms *STEWART_RESTRICT shared,
    leg_lanes *STEWART_RESTRICT out)
{
    int l;
    (void)shared;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real w_s = model->w_s[l];
        /* (1) platform point from the reference point */
        const stewart_real q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z;
        const stewart_real q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z;
        const stewart_real q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z;
        /* (1) reference point from base point, base frame */
        const stewart_real t_b_x = t_x - b_x;
        const stewart_real t_b_y = t_y - b_y;
        const stewart_real t_b_z = t_z - b_z;
        /* (1) leg vector */
        const stewart_real S_x = q_x + t_b_x;
        const stewart_real S_y = q_y + t_b_y;
        const stewart_real S_z = q_z + t_b_z;
        /* (2) leg length */
        const stewart_real L = STEWART_SQRT(S_x*S_x + S_y*S_y + S_z*S_z);
        const stewart_real inv_L = REAL(1)/L;
        /* (3) unit vector along the leg */
        const stewart_real s_x = S_x*inv_L;
        const stewart_real s_y = S_y*inv_L;
        const stewart_real s_z = S_z*inv_L;
        /* (21) K = K_a S_ddot + K_v S_dot - K_g g, up to a part along s */
        const stewart_real K_g = inv_L*w_s;
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x = -K_g*g_x;
        const stewart_real K_y = -K_g*g_y;
        const stewart_real K_z = -K_g*g_z;
        /* (24) known part of the actuator force, to match */
        const stewart_real D = -K_x*s_x - K_y*s_y - K_z*s_z;
        out->D[l] = D;
        out->H_force[0][l] = s_x;
        out->H_force[1][l] = s_y;
        out->H_force[2][l] = s_z;
        out->c_force[0][l] = -K_x;
        out->c_force[1][l] = -K_y;
        out->c_force[2][l] = -K_z;
        out->q[0][l] = q_x;
        out->q[1][l] = q_y;
        out->q[2][l] = q_z;
        stewart_real reach = STEWART_SHORTEST/STEWART_ROUNDING;
        reach = STEWART_LARGER(STEWART_FABS(q_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(q_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(q_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(b_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(b_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(b_z), reach);
        out->reach[l] = reach;
        out->L[l] = L;
        stewart_real fault = L <= STEWART_MAX ? REAL(0) : REAL(1);
        fault = L > STEWART_SHORT_SHARE*reach ? fault : REAL(1);
        out->bad[l] = fault;
    }
}

/* The platform's part of c with moments about platform point 1. */
static void shift_of_pose(const leg_lanes *STEWART_RESTRICT legs, shared_terms *STEWART_RESTRICT shared)
{
    const stewart_real q_1_x = legs->q[0][0], q_1_y = legs->q[1][0], q_1_z = legs->q[2][0];
    const stewart_real c_force_x = shared->c_force[0], c_force_y = shared->c_force[1], c_force_z = shared->c_force[2];
    const stewart_real c_moment_x = shared->c_moment[0], c_moment_y = shared->c_moment[1], c_moment_z = shared->c_moment[2];
    shared->c_tip[0] = c_force_y*q_1_z + c_moment_x - c_force_z*q_1_y;
    shared->c_tip[1] = c_force_z*q_1_x + c_moment_y - c_force_x*q_1_z;
    shared->c_tip[2] = c_force_x*q_1_y + c_moment_z - c_force_y*q_1_x;
}

/* Moments about platform point 1, 21 (12 mul, 9 add, 0 div, 0 sqrt) operations of each leg but the
 * first, which has none. */
static void moments_of_pose(leg_lanes *legs)
{
    int l;
    const stewart_real q_1_x = legs->q[0][0], q_1_y = legs->q[1][0], q_1_z = legs->q[2][0];
    for (l = 0; l < LANES; ++l) {
        const stewart_real q_x = legs->q[0][l], q_y = legs->q[1][l], q_z = legs->q[2][l];
        const stewart_real H_force_x = legs->H_force[0][l], H_force_y = legs->H_force[1][l], H_force_z = legs->H_force[2][l];
        const stewart_real c_force_x = legs->c_force[0][l], c_force_y = legs->c_force[1][l], c_force_z = legs->c_force[2][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - q_1_x;
        const stewart_real arm_y = q_y - q_1_y;
        const stewart_real arm_z = q_z - q_1_z;
        legs->H_moment[0][l] = H_force_z*arm_y - H_force_y*arm_z;
        legs->H_moment[1][l] = H_force_x*arm_z - H_force_z*arm_x;
        legs->H_moment[2][l] = H_force_y*arm_x - H_force_x*arm_y;
        legs->arm_c[0][l] = arm_y*c_force_z - arm_z*c_force_y;
        legs->arm_c[1][l] = arm_z*c_force_x - arm_x*c_force_z;
        legs->arm_c[2][l] = arm_x*c_force_y - arm_y*c_force_x;
    }
}

/* Takes the moments of the rows [H | c] over a length. */
static void scale_pose(stewart_real A[6][LANES], stewart_real per_length)
{
    int i, j;
    for (i = 3; i < 6; ++i) {
        for (j = 0; j < LANES; ++j) {
            A[i][j] = A[i][j]*per_length;
        }
    }
}

/* Exchanges two rows. */
static void exchange_rows(stewart_real *STEWART_RESTRICT upper, stewart_real *STEWART_RESTRICT lower)
{
    int j;
    for (j = 0; j < LANES; ++j) {
        const stewart_real moved = upper[j];
        upper[j] = lower[j];
        lower[j] = moved;
    }
}

/* Subtracts a multiple of a row from another. */
static void subtract_row(
    stewart_real *STEWART_RESTRICT to, stewart_real factor, const stewart_real *STEWART_RESTRICT row)
{
    int j;
    for (j = 0; j < LANES; ++j) {
        to[j] = to[j] - factor*row[j];
    }
}

/* Solves the augmented rows [H | c | 0] for x by elimination with partial pivoting, (36); whole rows are
 * updated, so that a row is one vector, and the next column is known before the rows that hold it are
 * stored. Returns 1 where a pivot is small, else 0. With moments about platform point 1 the first column
 * has no moment rows. */
static int solve_pose(stewart_real A[6][LANES], stewart_real x[6])
{
    stewart_real a_0 = A[0][0], a_1 = A[1][0], a_2 = A[2][0];
    /* Rows of equal entries are exchanged in the order of a block's lanes, and round alike. */
    if (STEWART_FABS(a_1) > STEWART_FABS(a_0)) {
        const stewart_real moved = a_0;
        exchange_rows(A[0], A[1]);
        a_0 = a_1;
        a_1 = moved;
    }
    if (STEWART_FABS(a_2) > STEWART_FABS(a_0)) {
        const stewart_real moved = a_0;
        exchange_rows(A[0], A[2]);
        a_0 = a_2;
        a_2 = moved;
    }
    const stewart_real inverse_0 = REAL(1)/a_0;
    const stewart_real factor_0_1 = a_1*inverse_0;
    const stewart_real factor_0_2 = a_2*inverse_0;
    a_1 = A[1][1] - factor_0_1*A[0][1];
    a_2 = A[2][1] - factor_0_2*A[0][1];
    stewart_real a_3 = A[3][1], a_4 = A[4][1], a_5 = A[5][1];
    subtract_row(A[1], factor_0_1, A[0]);
    subtract_row(A[2], factor_0_2, A[0]);
    /* Rows of equal entries are exchanged in the order of a block's lanes, and round alike. */
    if (STEWART_FABS(a_2) > STEWART_FABS(a_1)) {
        const stewart_real moved = a_1;
        exchange_rows(A[1], A[2]);
        a_1 = a_2;
        a_2 = moved;
    }
    if (STEWART_FABS(a_3) > STEWART_FABS(a_1)) {
        const stewart_real moved = a_1;
        exchange_rows(A[1], A[3]);
        a_1 = a_3;
        a_3 = moved;
    }
    if (STEWART_FABS(a_4) > STEWART_FABS(a_1)) {
        const stewart_real moved = a_1;
        exchange_rows(A[1], A[4]);
        a_1 = a_4;
        a_4 = moved;
    }
    if (STEWART_FABS(a_5) > STEWART_FABS(a_1)) {
        const stewart_real moved = a_1;
        exchange_rows(A[1], A[5]);
        a_1 = a_5;
        a_5 = moved;
    }
    const stewart_real inverse_1 = REAL(1)/a_1;
    const stewart_real factor_1_2 = a_2*inverse_1;
    const stewart_real factor_1_3 = a_3*inverse_1;
    const stewart_real factor_1_4 = a_4*inverse_1;
    const stewart_real factor_1_5 = a_5*inverse_1;
    a_2 = A[2][2] - factor_1_2*A[1][2];
    a_3 = A[3][2] - factor_1_3*A[1][2];
    a_4 = A[4][2] - factor_1_4*A[1][2];
    a_5 = A[5][2] - factor_1_5*A[1][2];
    subtract_row(A[2], factor_1_2, A[1]);
    subtract_row(A[3], factor_1_3, A[1]);
    subtract_row(A[4], factor_1_4, A[1]);
    subtract_row(A[5], factor_1_5, A[1]);
    /* Rows of equal entries are exchanged in the order of a block's lanes, and round alike. */
    if (STEWART_FABS(a_3) > STEWART_FABS(a_2)) {
        const stewart_real moved = a_2;
        exchange_rows(A[2], A[3]);
        a_2 = a_3;
        a_3 = moved;
    }
    if (STEWART_FABS(a_4) > STEWART_FABS(a_2)) {
        const stewart_real moved = a_2;
        exchange_rows(A[2], A[4]);
        a_2 = a_4;
        a_4 = moved;
    }
    if (STEWART_FABS(a_5) > STEWART_FABS(a_2)) {
        const stewart_real moved = a_2;
        exchange_rows(A[2], A[5]);
        a_2 = a_5;
        a_5 = moved;
    }
    const stewart_real inverse_2 = REAL(1)/a_2;
    const stewart_real factor_2_3 = a_3*inverse_2;
    const stewart_real factor_2_4 = a_4*inverse_2;
    const stewart_real factor_2_5 = a_5*inverse_2;
    a_3 = A[3][3] - factor_2_3*A[2][3];
    a_4 = A[4][3] - factor_2_4*A[2][3];
    a_5 = A[5][3] - factor_2_5*A[2][3];
    subtract_row(A[3], factor_2_3, A[2]);
    subtract_row(A[4], factor_2_4, A[2]);
    subtract_row(A[5], factor_2_5, A[2]);
    /* Rows of equal entries are exchanged in the order of a block's lanes, and round alike. */
    if (STEWART_FABS(a_4) > STEWART_FABS(a_3)) {
        const stewart_real moved = a_3;
        exchange_rows(A[3], A[4]);
        a_3 = a_4;
        a_4 = moved;
    }
    if (STEWART_FABS(a_5) > STEWART_FABS(a_3)) {
        const stewart_real moved = a_3;
        exchange_rows(A[3], A[5]);
        a_3 = a_5;
        a_5 = moved;
    }
    const stewart_real inverse_3 = REAL(1)/a_3;
    const stewart_real factor_3_4 = a_4*inverse_3;
    const stewart_real factor_3_5 = a_5*inverse_3;
    a_4 = A[4][4] - factor_3_4*A[3][4];
    a_5 = A[5][4] - factor_3_5*A[3][4];
    subtract_row(A[4], factor_3_4, A[3]);
    subtract_row(A[5], factor_3_5, A[3]);
    /* Rows of equal entries are exchanged in the order of a block's lanes, and round alike. */
    if (STEWART_FABS(a_5) > STEWART_FABS(a_4)) {
        const stewart_real moved = a_4;
        exchange_rows(A[4], A[5]);
        a_4 = a_5;
        a_5 = moved;
    }
    const stewart_real inverse_4 = REAL(1)/a_4;
    const stewart_real factor_4_5 = a_5*inverse_4;
    a_5 = A[5][5] - factor_4_5*A[4][5];
    subtract_row(A[5], factor_4_5, A[4]);
    /* Rows of equal entries are exchanged in the order of a block's lanes, and round alike. */
    x[5] = A[5][6]/a_5;
    stewart_real total_4 = A[4][6];
    total_4 = total_4 - A[4][5]*x[5];
    x[4] = total_4*inverse_4;
    stewart_real total_3 = A[3][6];
    total_3 = total_3 - A[3][4]*x[4];
    total_3 = total_3 - A[3][5]*x[5];
    x[3] = total_3*inverse_3;
    stewart_real total_2 = A[2][6];
    total_2 = total_2 - A[2][3]*x[3];
    total_2 = total_2 - A[2][4]*x[4];
    total_2 = total_2 - A[2][5]*x[5];
    x[2] = total_2*inverse_2;
    stewart_real total_1 = A[1][6];
    total_1 = total_1 - A[1][2]*x[2];
    total_1 = total_1 - A[1][3]*x[3];
    total_1 = total_1 - A[1][4]*x[4];
    total_1 = total_1 - A[1][5]*x[5];
    x[1] = total_1*inverse_1;
    stewart_real total_0 = A[0][6];
    total_0 = total_0 - A[0][1]*x[1];
    total_0 = total_0 - A[0][2]*x[2];
    total_0 = total_0 - A[0][3]*x[3];
    total_0 = total_0 - A[0][4]*x[4];
    total_0 = total_0 - A[0][5]*x[5];
    x[0] = total_0*inverse_0;
    return (STEWART_FABS(a_0) > STEWART_SUSPECT && STEWART_FABS(a_1) > STEWART_SUSPECT && STEWART_FABS(a_2) > STEWART_SUSPECT
        && STEWART_FABS(a_3) > STEWART_SUSPECT && STEWART_FABS(a_4) > STEWART_SUSPECT && STEWART_FABS(a_5) > STEWART_SUSPECT)
        ? 0 : 1;
}

#if !defined(STEWART_SINGULAR_STATUS)
#define STEWART_SINGULAR_STATUS
/* Whether H is singular to rounding: STEWART_OK, STEWART_SINGULAR or STEWART_NOT_FINITE. H is replaced by its
 * inverse Y. `arm`: of the moments; `L`: lengths of the legs; `reach`: size of the vectors that a leg is the
 * sum of.
 *
 * The direction s of a leg errs by 4 epsilon (reach / L + 2) at most: half a unit of each number that goes in
 * and of each operation, and what the elimination adds. Its column of H, (s, arm x s), errs by that through
 * Y_force + Y_moment x arm, wherever moments are taken about, and by the rounding of the moment. Where H less
 * its error is singular, no v > 0 has G v < v, G_ik what the error of column k does to row i of Y H: the
 * spectral radius of G is 1 or more. Powers of G make v; 1/2 leaves room for the errors of Y itself. */
STEWART_APART static int singular_status(
    stewart_real H[6][6], stewart_real arm[6][3], const stewart_real *L, const stewart_real *reach)
{
    stewart_real Y[6][6], G[6][6], v[6], grown[6];
    stewart_real size = REAL(0), worst = REAL(1);
    int i, j, k, turn;
    for (i = 0; i < 6; ++i) {
        v[i] = REAL(1);
        for (j = 0; j < 3; ++j) {
            size = STEWART_LARGER(STEWART_FABS(arm[i][j]), size);
        }
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            if (!(STEWART_FABS(H[i][j]) <= STEWART_MAX)) {
                return STEWART_NOT_FINITE;
            }
            H[i][j] = i < 3 ? H[i][j] : H[i][j] / size;
            Y[i][j] = i == j ? REAL(1) : REAL(0);
        }
    }
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        for (i = k + 1; i < 6; ++i) {
            pivot = STEWART_FABS(H[i][k]) > STEWART_FABS(H[pivot][k]) ? i : pivot;
        }
        if (!(STEWART_FABS(H[pivot][k]) > REAL(0))) {
            return STEWART_SINGULAR;
        }
        for (j = 0; j < 6; ++j) {
            const stewart_real h = H[k][j], y = Y[k][j];
            H[k][j] = H[pivot][j];
            H[pivot][j] = h;
            Y[k][j] = Y[pivot][j];
            Y[pivot][j] = y;
        }
        for (i = 0; i < 6; ++i) {
            const stewart_real factor = H[i][k] / H[k][k];
            for (j = 0; i != k && j < 6; ++j) {
                H[i][j] = H[i][j] - factor * H[k][j];
                Y[i][j] = Y[i][j] - factor * Y[k][j];
            }
        }
    }
    for (i = 0; i < 6; ++i) {
        const stewart_real by_moment = STEWART_FABS(Y[i][3]) + STEWART_FABS(Y[i][4]) + STEWART_FABS(Y[i][5]);
        for (k = 0; k < 6; ++k) {
            stewart_real turned = REAL(0);
            for (j = 0; j < 3; ++j) {
                const int next = (j + 1) % 3, last = (j + 2) % 3;
                turned = turned + STEWART_FABS(Y[i][j]
                    + (Y[i][3 + next] * arm[k][last] - Y[i][3 + last] * arm[k][next]) / size);
            }
            G[i][k] = (turned * (reach[k] / L[k] + REAL(2)) + REAL(2) * by_moment)
                * (REAL(4) * STEWART_EPSILON) / STEWART_FABS(H[i][i]);
        }
    }
    for (turn = 0; turn < 4 && worst > STEWART_HALF; ++turn) {
        stewart_real greatest = REAL(0);
        worst = REAL(0);
        for (i = 0; i < 6; ++i) {
            grown[i] = REAL(0);
            for (k = 0; k < 6; ++k) {
                grown[i] = grown[i] + G[i][k] * v[k];
            }
            worst = grown[i] / v[i] <= worst ? worst : grown[i] / v[i];
            greatest = STEWART_LARGER(grown[i], greatest);
        }
        for (i = 0; i < 6; ++i) {
            v[i] = STEWART_LARGER(grown[i] / greatest, STEWART_EPSILON);
        }
    }
    return worst <= STEWART_HALF ? STEWART_OK : STEWART_SINGULAR;
}
#endif

/* Status of a pose whose H may be singular to rounding. */
STEWART_APART static int pose_status(const leg_lanes *legs)
{
    int i, j;
    stewart_real H[6][6];
    stewart_real arm[6][3];
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            arm[i][j] = legs->q[j][i] - legs->q[j][0];
            H[j][i] = legs->H_force[j][i];
            H[j + 3][i] = legs->H_moment[j][i];
        }
    }
    return singular_status(H, arm, legs->L, legs->reach);
}

int stewart_exact_slender_static_forces(
    const stewart_exact_slender_static_model *model, const stewart_motion *motion, stewart_real F[6])
{
    int i, j;
    shared_terms shared;
    leg_lanes legs;
    stewart_real A[6][LANES];
    stewart_real x[6];
    stewart_real found[6];
    int close = 0;
    if (model == NULL || motion == NULL || F == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    shared_of_pose(model, motion, &shared);
    legs_of_pose(model, motion, &shared, &legs);
    for (i = 0; i < 6; ++i) {
        if (legs.bad[i] > REAL(0)) {
            const int status = leg_status(&legs, i);
            if (status != STEWART_OK) {
                return status;
            }
            close = legs.L[i] > STEWART_SHORT_SHARE*legs.reach[i] ? close : 1;
        }
    }
    shift_of_pose(&legs, &shared);
    moments_of_pose(&legs);
    for (j = 0; j < 3; ++j) {
        stewart_real force = shared.c_force[j];
        stewart_real turn = shared.c_tip[j];
        for (i = 0; i < 6; ++i) {
            force = force + legs.c_force[j][i];
            turn = turn + legs.arm_c[j][i];
        }
        for (i = 0; i < LANES; ++i) {
            A[j][i] = legs.H_force[j][i];
            A[j + 3][i] = legs.H_moment[j][i];
        }
        A[j][6] = force;
        A[j + 3][6] = turn;
        A[j][7] = REAL(0);
        A[j + 3][7] = REAL(0);
    }
    if (model->per_length != REAL(1)) {
        scale_pose(A, model->per_length);
    }
    const int suspect = solve_pose(A, x);
    if (close != 0 || suspect != 0) {
        const int status = pose_status(&legs);
        if (status != STEWART_OK) {
            return status;
        }
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

/* Eight poses on their way. */
typedef struct {
    stewart_real column[7][6][LANES]; /* [H | c], column by column */
    stewart_real D[6][LANES];
    stewart_real F[6][LANES];
    stewart_real bad[LANES]; /* 1 where a leg, a pivot or a force needs a closer look, else 0 */
} block;

/* What a leg of eight poses hands to the moments. */
typedef struct {
    stewart_real q[3][LANES];
    stewart_real c_force[3][LANES];
} leg_block;

/* What each of eight poses has for all legs, and the platform's part of c. */
static void shared_of_block(
    const stewart_exact_slender_static_model *STEWART_RESTRICT model,
    const motion_lanes *STEWART_RESTRICT at, const shared_lanes *STEWART_RESTRICT out,
    stewart_real (*STEWART_RESTRICT c)[LANES])
{
    int l;
    (void)out;
    const stewart_real h_P_x = model->h_P[0], h_P_y = model->h_P[1], h_P_z = model->h_P[2];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    const stewart_real W_P_x = model->W_P[0], W_P_y = model->W_P[1], W_P_z = model->W_P[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real F_ext_x = at->F_ext[0][l], F_ext_y = at->F_ext[1][l], F_ext_z = at->F_ext[2][l];
        const stewart_real M_ext_x = at->M_ext[0][l], M_ext_y = at->M_ext[1][l], M_ext_z = at->M_ext[2][l];
        /* (30) first moment of the platform, base frame */
        const stewart_real h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z;
        const stewart_real h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z;
        const stewart_real h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z;
        c[0][l] = F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz + W_P_x;
        c[1][l] = F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz + W_P_y;
        c[2][l] = F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz + W_P_z;
        c[3][l] = M_ext_x*R_xx + M_ext_y*R_xy + M_ext_z*R_xz + g_z*h_base_y - g_y*h_base_z;
        c[4][l] = M_ext_x*R_yx + M_ext_y*R_yy + M_ext_z*R_yz + g_x*h_base_z - g_z*h_base_x;
        c[5][l] = M_ext_x*R_zx + M_ext_y*R_zy + M_ext_z*R_zz + g_y*h_base_x - g_x*h_base_y;
    }
}

/* One leg of eight poses side by side, 40 (22 mul, 16 add, 1 div, 1 sqrt) operations each: its column of
 * H, its D and its part of c. */
static void leg_of_block(
    const stewart_exact_slender_static_model *STEWART_RESTRICT model, int leg,
    const motion_lanes *STEWART_RESTRICT at, const shared_lanes *STEWART_RESTRICT shared,
    stewart_real (*STEWART_RESTRICT column)[LANES], leg_block *STEWART_RESTRICT own,
    stewart_real *STEWART_RESTRICT known, stewart_real *STEWART_RESTRICT bad)
{
    int l;
    (void)shared;
    const stewart_real b_x = model->b[0][leg], b_y = model->b[1][leg], b_z = model->b[2][leg];
    const stewart_real p_x = model->p[0][leg], p_y = model->p[1][leg], p_z = model->p[2][leg];
    const stewart_real w_s = model->w_s[leg];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real t_x = at->t[0][l], t_y = at->t[1][l], t_z = at->t[2][l];
        /* (1) platform point from the reference point */
        const stewart_real q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z;
        const stewart_real q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z;
        const stewart_real q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z;
        /* (1) reference point from base point, base frame */
        const stewart_real t_b_x = t_x - b_x;
        const stewart_real t_b_y = t_y - b_y;
        const stewart_real t_b_z = t_z - b_z;
        /* (1) leg vector */
        const stewart_real S_x = q_x + t_b_x;
        const stewart_real S_y = q_y + t_b_y;
        const stewart_real S_z = q_z + t_b_z;
        /* (2) leg length */
        const stewart_real L = STEWART_SQRT(S_x*S_x + S_y*S_y + S_z*S_z);
        const stewart_real inv_L = REAL(1)/L;
        /* (3) unit vector along the leg */
        const stewart_real s_x = S_x*inv_L;
        const stewart_real s_y = S_y*inv_L;
        const stewart_real s_z = S_z*inv_L;
        /* (21) K = K_a S_ddot + K_v S_dot - K_g g, up to a part along s */
        const stewart_real K_g = inv_L*w_s;
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x = -K_g*g_x;
        const stewart_real K_y = -K_g*g_y;
        const stewart_real K_z = -K_g*g_z;
        /* (24) known part of the actuator force, to match */
        const stewart_real D = -K_x*s_x - K_y*s_y - K_z*s_z;
        column[0][l] = s_x;
        column[1][l] = s_y;
        column[2][l] = s_z;
        own->q[0][l] = q_x;
        own->q[1][l] = q_y;
        own->q[2][l] = q_z;
        own->c_force[0][l] = -K_x;
        own->c_force[1][l] = -K_y;
        own->c_force[2][l] = -K_z;
        known[l] = D;
        stewart_real reach = STEWART_SHORTEST/STEWART_ROUNDING;
        reach = STEWART_LARGER(STEWART_FABS(q_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(q_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(q_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(b_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(b_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(b_z), reach);
        stewart_real fault = L <= STEWART_MAX ? bad[l] : REAL(1);
        fault = L > STEWART_SHORT_SHARE*reach ? fault : REAL(1);
        bad[l] = fault;
    }
}

/* Leg 1 of eight poses: the platform's part of c moves to platform point 1, and the leg's is added. */
static void moments_of_first(
    const leg_block *STEWART_RESTRICT own, stewart_real (*STEWART_RESTRICT c)[LANES])
{
    int l;
    for (l = 0; l < LANES; ++l) {
        const stewart_real q_1_x = own->q[0][l], q_1_y = own->q[1][l], q_1_z = own->q[2][l];
        const stewart_real c_force_x = c[0][l], c_force_y = c[1][l], c_force_z = c[2][l], c_moment_x = c[3][l],
            c_moment_y = c[4][l], c_moment_z = c[5][l];
        c[3][l] = c_force_y*q_1_z + c_moment_x - c_force_z*q_1_y;
        c[4][l] = c_force_z*q_1_x + c_moment_y - c_force_x*q_1_z;
        c[5][l] = c_force_x*q_1_y + c_moment_z - c_force_y*q_1_x;
        c[0][l] = c[0][l] + own->c_force[0][l];
        c[1][l] = c[1][l] + own->c_force[1][l];
        c[2][l] = c[2][l] + own->c_force[2][l];
    }
}

/* Another leg: its moments about platform point 1, 21 (12 mul, 9 add, 0 div, 0 sqrt) operations each,
 * and its part of c. */
static void moments_of_block(
    const leg_block *STEWART_RESTRICT own, stewart_real (*STEWART_RESTRICT q_1)[LANES],
    stewart_real (*STEWART_RESTRICT column)[LANES], stewart_real (*STEWART_RESTRICT c)[LANES])
{
    int l;
    for (l = 0; l < LANES; ++l) {
        const stewart_real q_x = own->q[0][l], q_y = own->q[1][l], q_z = own->q[2][l];
        const stewart_real q_1_x = q_1[0][l], q_1_y = q_1[1][l], q_1_z = q_1[2][l];
        const stewart_real H_force_x = column[0][l], H_force_y = column[1][l], H_force_z = column[2][l];
        const stewart_real c_force_x = own->c_force[0][l], c_force_y = own->c_force[1][l], c_force_z = own->c_force[2][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - q_1_x;
        const stewart_real arm_y = q_y - q_1_y;
        const stewart_real arm_z = q_z - q_1_z;
        column[3][l] = H_force_z*arm_y - H_force_y*arm_z;
        column[4][l] = H_force_x*arm_z - H_force_z*arm_x;
        column[5][l] = H_force_y*arm_x - H_force_x*arm_y;
        c[0][l] = c[0][l] + own->c_force[0][l];
        c[1][l] = c[1][l] + own->c_force[1][l];
        c[2][l] = c[2][l] + own->c_force[2][l];
        c[3][l] = c[3][l] + (arm_y*c_force_z - arm_z*c_force_y);
        c[4][l] = c[4][l] + (arm_z*c_force_x - arm_x*c_force_z);
        c[5][l] = c[5][l] + (arm_x*c_force_y - arm_y*c_force_x);
    }
}

/* The same for eight poses. */
static void scale_block(block *out, stewart_real per_length)
{
    int i, j, l;
    for (i = 1; i < 7; ++i) {
        for (j = 3; j < 6; ++j) {
            for (l = 0; l < LANES; ++l) {
                out->column[i][j][l] = out->column[i][j][l]*per_length;
            }
        }
    }
}

/* Solves eight systems [H | c] side by side for x by elimination with partial pivoting, (36), and F = D
 * - x, (37): a loop over lanes that never branches. The row with the largest entry sinks to its place by
 * exchanges that a lane makes or leaves. Marks as bad where a pivot is small or a force not finite. */
STEWART_APART static void solve_block(
    stewart_real (*STEWART_RESTRICT column)[6][LANES], stewart_real (*STEWART_RESTRICT D)[LANES],
    stewart_real (*STEWART_RESTRICT F)[LANES], stewart_real *STEWART_RESTRICT bad)
{
    int l;
    for (l = 0; l < LANES; ++l) {
        stewart_real a_0_0 = column[0][0][l], a_0_1 = column[1][0][l], a_0_2 = column[2][0][l], a_0_3 = column[3][0][l],
            a_0_4 = column[4][0][l], a_0_5 = column[5][0][l], a_0_6 = column[6][0][l], a_1_0 = column[0][1][l],
            a_1_1 = column[1][1][l], a_1_2 = column[2][1][l], a_1_3 = column[3][1][l], a_1_4 = column[4][1][l],
            a_1_5 = column[5][1][l], a_1_6 = column[6][1][l], a_2_0 = column[0][2][l], a_2_1 = column[1][2][l],
            a_2_2 = column[2][2][l], a_2_3 = column[3][2][l], a_2_4 = column[4][2][l], a_2_5 = column[5][2][l],
            a_2_6 = column[6][2][l], a_3_1 = column[1][3][l], a_3_2 = column[2][3][l], a_3_3 = column[3][3][l],
            a_3_4 = column[4][3][l], a_3_5 = column[5][3][l], a_3_6 = column[6][3][l], a_4_1 = column[1][4][l],
            a_4_2 = column[2][4][l], a_4_3 = column[3][4][l], a_4_4 = column[4][4][l], a_4_5 = column[5][4][l],
            a_4_6 = column[6][4][l], a_5_1 = column[1][5][l], a_5_2 = column[2][5][l], a_5_3 = column[3][5][l],
            a_5_4 = column[4][5][l], a_5_5 = column[5][5][l], a_5_6 = column[6][5][l];
        stewart_real fault = bad[l];
        const stewart_real below_1_0 = STEWART_FABS(a_1_0) > STEWART_FABS(a_0_0) ? REAL(1) : REAL(0);
        const stewart_real upper_0_0_1 = below_1_0 > REAL(0) ? a_1_0 : a_0_0;
        a_1_0 = below_1_0 > REAL(0) ? a_0_0 : a_1_0;
        a_0_0 = upper_0_0_1;
        const stewart_real upper_0_1_1 = below_1_0 > REAL(0) ? a_1_1 : a_0_1;
        a_1_1 = below_1_0 > REAL(0) ? a_0_1 : a_1_1;
        a_0_1 = upper_0_1_1;
        const stewart_real upper_0_2_1 = below_1_0 > REAL(0) ? a_1_2 : a_0_2;
        a_1_2 = below_1_0 > REAL(0) ? a_0_2 : a_1_2;
        a_0_2 = upper_0_2_1;
        const stewart_real upper_0_3_1 = below_1_0 > REAL(0) ? a_1_3 : a_0_3;
        a_1_3 = below_1_0 > REAL(0) ? a_0_3 : a_1_3;
        a_0_3 = upper_0_3_1;
        const stewart_real upper_0_4_1 = below_1_0 > REAL(0) ? a_1_4 : a_0_4;
        a_1_4 = below_1_0 > REAL(0) ? a_0_4 : a_1_4;
        a_0_4 = upper_0_4_1;
        const stewart_real upper_0_5_1 = below_1_0 > REAL(0) ? a_1_5 : a_0_5;
        a_1_5 = below_1_0 > REAL(0) ? a_0_5 : a_1_5;
        a_0_5 = upper_0_5_1;
        const stewart_real upper_0_6_1 = below_1_0 > REAL(0) ? a_1_6 : a_0_6;
        a_1_6 = below_1_0 > REAL(0) ? a_0_6 : a_1_6;
        a_0_6 = upper_0_6_1;
        const stewart_real below_2_0 = STEWART_FABS(a_2_0) > STEWART_FABS(a_0_0) ? REAL(1) : REAL(0);
        const stewart_real upper_0_0_2 = below_2_0 > REAL(0) ? a_2_0 : a_0_0;
        a_2_0 = below_2_0 > REAL(0) ? a_0_0 : a_2_0;
        a_0_0 = upper_0_0_2;
        const stewart_real upper_0_1_2 = below_2_0 > REAL(0) ? a_2_1 : a_0_1;
        a_2_1 = below_2_0 > REAL(0) ? a_0_1 : a_2_1;
        a_0_1 = upper_0_1_2;
        const stewart_real upper_0_2_2 = below_2_0 > REAL(0) ? a_2_2 : a_0_2;
        a_2_2 = below_2_0 > REAL(0) ? a_0_2 : a_2_2;
        a_0_2 = upper_0_2_2;
        const stewart_real upper_0_3_2 = below_2_0 > REAL(0) ? a_2_3 : a_0_3;
        a_2_3 = below_2_0 > REAL(0) ? a_0_3 : a_2_3;
        a_0_3 = upper_0_3_2;
        const stewart_real upper_0_4_2 = below_2_0 > REAL(0) ? a_2_4 : a_0_4;
        a_2_4 = below_2_0 > REAL(0) ? a_0_4 : a_2_4;
        a_0_4 = upper_0_4_2;
        const stewart_real upper_0_5_2 = below_2_0 > REAL(0) ? a_2_5 : a_0_5;
        a_2_5 = below_2_0 > REAL(0) ? a_0_5 : a_2_5;
        a_0_5 = upper_0_5_2;
        const stewart_real upper_0_6_2 = below_2_0 > REAL(0) ? a_2_6 : a_0_6;
        a_2_6 = below_2_0 > REAL(0) ? a_0_6 : a_2_6;
        a_0_6 = upper_0_6_2;
        fault = STEWART_FABS(a_0_0) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real inverse_0 = REAL(1)/a_0_0;
        const stewart_real factor_1_0 = a_1_0*inverse_0;
        a_1_1 = a_1_1 - factor_1_0*a_0_1;
        a_1_2 = a_1_2 - factor_1_0*a_0_2;
        a_1_3 = a_1_3 - factor_1_0*a_0_3;
        a_1_4 = a_1_4 - factor_1_0*a_0_4;
        a_1_5 = a_1_5 - factor_1_0*a_0_5;
        a_1_6 = a_1_6 - factor_1_0*a_0_6;
        const stewart_real factor_2_0 = a_2_0*inverse_0;
        a_2_1 = a_2_1 - factor_2_0*a_0_1;
        a_2_2 = a_2_2 - factor_2_0*a_0_2;
        a_2_3 = a_2_3 - factor_2_0*a_0_3;
        a_2_4 = a_2_4 - factor_2_0*a_0_4;
        a_2_5 = a_2_5 - factor_2_0*a_0_5;
        a_2_6 = a_2_6 - factor_2_0*a_0_6;
        const stewart_real below_2_1 = STEWART_FABS(a_2_1) > STEWART_FABS(a_1_1) ? REAL(1) : REAL(0);
        const stewart_real upper_1_1_2 = below_2_1 > REAL(0) ? a_2_1 : a_1_1;
        a_2_1 = below_2_1 > REAL(0) ? a_1_1 : a_2_1;
        a_1_1 = upper_1_1_2;
        const stewart_real upper_1_2_2 = below_2_1 > REAL(0) ? a_2_2 : a_1_2;
        a_2_2 = below_2_1 > REAL(0) ? a_1_2 : a_2_2;
        a_1_2 = upper_1_2_2;
        const stewart_real upper_1_3_2 = below_2_1 > REAL(0) ? a_2_3 : a_1_3;
        a_2_3 = below_2_1 > REAL(0) ? a_1_3 : a_2_3;
        a_1_3 = upper_1_3_2;
        const stewart_real upper_1_4_2 = below_2_1 > REAL(0) ? a_2_4 : a_1_4;
        a_2_4 = below_2_1 > REAL(0) ? a_1_4 : a_2_4;
        a_1_4 = upper_1_4_2;
        const stewart_real upper_1_5_2 = below_2_1 > REAL(0) ? a_2_5 : a_1_5;
        a_2_5 = below_2_1 > REAL(0) ? a_1_5 : a_2_5;
        a_1_5 = upper_1_5_2;
        const stewart_real upper_1_6_2 = below_2_1 > REAL(0) ? a_2_6 : a_1_6;
        a_2_6 = below_2_1 > REAL(0) ? a_1_6 : a_2_6;
        a_1_6 = upper_1_6_2;
        const stewart_real below_3_1 = STEWART_FABS(a_3_1) > STEWART_FABS(a_1_1) ? REAL(1) : REAL(0);
        const stewart_real upper_1_1_3 = below_3_1 > REAL(0) ? a_3_1 : a_1_1;
        a_3_1 = below_3_1 > REAL(0) ? a_1_1 : a_3_1;
        a_1_1 = upper_1_1_3;
        const stewart_real upper_1_2_3 = below_3_1 > REAL(0) ? a_3_2 : a_1_2;
        a_3_2 = below_3_1 > REAL(0) ? a_1_2 : a_3_2;
        a_1_2 = upper_1_2_3;
        const stewart_real upper_1_3_3 = below_3_1 > REAL(0) ? a_3_3 : a_1_3;
        a_3_3 = below_3_1 > REAL(0) ? a_1_3 : a_3_3;
        a_1_3 = upper_1_3_3;
        const stewart_real upper_1_4_3 = below_3_1 > REAL(0) ? a_3_4 : a_1_4;
        a_3_4 = below_3_1 > REAL(0) ? a_1_4 : a_3_4;
        a_1_4 = upper_1_4_3;
        const stewart_real upper_1_5_3 = below_3_1 > REAL(0) ? a_3_5 : a_1_5;
        a_3_5 = below_3_1 > REAL(0) ? a_1_5 : a_3_5;
        a_1_5 = upper_1_5_3;
        const stewart_real upper_1_6_3 = below_3_1 > REAL(0) ? a_3_6 : a_1_6;
        a_3_6 = below_3_1 > REAL(0) ? a_1_6 : a_3_6;
        a_1_6 = upper_1_6_3;
        const stewart_real below_4_1 = STEWART_FABS(a_4_1) > STEWART_FABS(a_1_1) ? REAL(1) : REAL(0);
        const stewart_real upper_1_1_4 = below_4_1 > REAL(0) ? a_4_1 : a_1_1;
        a_4_1 = below_4_1 > REAL(0) ? a_1_1 : a_4_1;
        a_1_1 = upper_1_1_4;
        const stewart_real upper_1_2_4 = below_4_1 > REAL(0) ? a_4_2 : a_1_2;
        a_4_2 = below_4_1 > REAL(0) ? a_1_2 : a_4_2;
        a_1_2 = upper_1_2_4;
        const stewart_real upper_1_3_4 = below_4_1 > REAL(0) ? a_4_3 : a_1_3;
        a_4_3 = below_4_1 > REAL(0) ? a_1_3 : a_4_3;
        a_1_3 = upper_1_3_4;
        const stewart_real upper_1_4_4 = below_4_1 > REAL(0) ? a_4_4 : a_1_4;
        a_4_4 = below_4_1 > REAL(0) ? a_1_4 : a_4_4;
        a_1_4 = upper_1_4_4;
        const stewart_real upper_1_5_4 = below_4_1 > REAL(0) ? a_4_5 : a_1_5;
        a_4_5 = below_4_1 > REAL(0) ? a_1_5 : a_4_5;
        a_1_5 = upper_1_5_4;
        const stewart_real upper_1_6_4 = below_4_1 > REAL(0) ? a_4_6 : a_1_6;
        a_4_6 = below_4_1 > REAL(0) ? a_1_6 : a_4_6;
        a_1_6 = upper_1_6_4;
        const stewart_real below_5_1 = STEWART_FABS(a_5_1) > STEWART_FABS(a_1_1) ? REAL(1) : REAL(0);
        const stewart_real upper_1_1_5 = below_5_1 > REAL(0) ? a_5_1 : a_1_1;
        a_5_1 = below_5_1 > REAL(0) ? a_1_1 : a_5_1;
        a_1_1 = upper_1_1_5;
        const stewart_real upper_1_2_5 = below_5_1 > REAL(0) ? a_5_2 : a_1_2;
        a_5_2 = below_5_1 > REAL(0) ? a_1_2 : a_5_2;
        a_1_2 = upper_1_2_5;
        const stewart_real upper_1_3_5 = below_5_1 > REAL(0) ? a_5_3 : a_1_3;
        a_5_3 = below_5_1 > REAL(0) ? a_1_3 : a_5_3;
        a_1_3 = upper_1_3_5;
        const stewart_real upper_1_4_5 = below_5_1 > REAL(0) ? a_5_4 : a_1_4;
        a_5_4 = below_5_1 > REAL(0) ? a_1_4 : a_5_4;
        a_1_4 = upper_1_4_5;
        const stewart_real upper_1_5_5 = below_5_1 > REAL(0) ? a_5_5 : a_1_5;
        a_5_5 = below_5_1 > REAL(0) ? a_1_5 : a_5_5;
        a_1_5 = upper_1_5_5;
        const stewart_real upper_1_6_5 = below_5_1 > REAL(0) ? a_5_6 : a_1_6;
        a_5_6 = below_5_1 > REAL(0) ? a_1_6 : a_5_6;
        a_1_6 = upper_1_6_5;
        fault = STEWART_FABS(a_1_1) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real inverse_1 = REAL(1)/a_1_1;
        const stewart_real factor_2_1 = a_2_1*inverse_1;
        a_2_2 = a_2_2 - factor_2_1*a_1_2;
        a_2_3 = a_2_3 - factor_2_1*a_1_3;
        a_2_4 = a_2_4 - factor_2_1*a_1_4;
        a_2_5 = a_2_5 - factor_2_1*a_1_5;
        a_2_6 = a_2_6 - factor_2_1*a_1_6;
        const stewart_real factor_3_1 = a_3_1*inverse_1;
        a_3_2 = a_3_2 - factor_3_1*a_1_2;
        a_3_3 = a_3_3 - factor_3_1*a_1_3;
        a_3_4 = a_3_4 - factor_3_1*a_1_4;
        a_3_5 = a_3_5 - factor_3_1*a_1_5;
        a_3_6 = a_3_6 - factor_3_1*a_1_6;
        const stewart_real factor_4_1 = a_4_1*inverse_1;
        a_4_2 = a_4_2 - factor_4_1*a_1_2;
        a_4_3 = a_4_3 - factor_4_1*a_1_3;
        a_4_4 = a_4_4 - factor_4_1*a_1_4;
        a_4_5 = a_4_5 - factor_4_1*a_1_5;
        a_4_6 = a_4_6 - factor_4_1*a_1_6;
        const stewart_real factor_5_1 = a_5_1*inverse_1;
        a_5_2 = a_5_2 - factor_5_1*a_1_2;
        a_5_3 = a_5_3 - factor_5_1*a_1_3;
        a_5_4 = a_5_4 - factor_5_1*a_1_4;
        a_5_5 = a_5_5 - factor_5_1*a_1_5;
        a_5_6 = a_5_6 - factor_5_1*a_1_6;
        const stewart_real below_3_2 = STEWART_FABS(a_3_2) > STEWART_FABS(a_2_2) ? REAL(1) : REAL(0);
        const stewart_real upper_2_2_3 = below_3_2 > REAL(0) ? a_3_2 : a_2_2;
        a_3_2 = below_3_2 > REAL(0) ? a_2_2 : a_3_2;
        a_2_2 = upper_2_2_3;
        const stewart_real upper_2_3_3 = below_3_2 > REAL(0) ? a_3_3 : a_2_3;
        a_3_3 = below_3_2 > REAL(0) ? a_2_3 : a_3_3;
        a_2_3 = upper_2_3_3;
        const stewart_real upper_2_4_3 = below_3_2 > REAL(0) ? a_3_4 : a_2_4;
        a_3_4 = below_3_2 > REAL(0) ? a_2_4 : a_3_4;
        a_2_4 = upper_2_4_3;
        const stewart_real upper_2_5_3 = below_3_2 > REAL(0) ? a_3_5 : a_2_5;
        a_3_5 = below_3_2 > REAL(0) ? a_2_5 : a_3_5;
        a_2_5 = upper_2_5_3;
        const stewart_real upper_2_6_3 = below_3_2 > REAL(0) ? a_3_6 : a_2_6;
        a_3_6 = below_3_2 > REAL(0) ? a_2_6 : a_3_6;
        a_2_6 = upper_2_6_3;
        const stewart_real below_4_2 = STEWART_FABS(a_4_2) > STEWART_FABS(a_2_2) ? REAL(1) : REAL(0);
        const stewart_real upper_2_2_4 = below_4_2 > REAL(0) ? a_4_2 : a_2_2;
        a_4_2 = below_4_2 > REAL(0) ? a_2_2 : a_4_2;
        a_2_2 = upper_2_2_4;
        const stewart_real upper_2_3_4 = below_4_2 > REAL(0) ? a_4_3 : a_2_3;
        a_4_3 = below_4_2 > REAL(0) ? a_2_3 : a_4_3;
        a_2_3 = upper_2_3_4;
        const stewart_real upper_2_4_4 = below_4_2 > REAL(0) ? a_4_4 : a_2_4;
        a_4_4 = below_4_2 > REAL(0) ? a_2_4 : a_4_4;
        a_2_4 = upper_2_4_4;
        const stewart_real upper_2_5_4 = below_4_2 > REAL(0) ? a_4_5 : a_2_5;
        a_4_5 = below_4_2 > REAL(0) ? a_2_5 : a_4_5;
        a_2_5 = upper_2_5_4;
        const stewart_real upper_2_6_4 = below_4_2 > REAL(0) ? a_4_6 : a_2_6;
        a_4_6 = below_4_2 > REAL(0) ? a_2_6 : a_4_6;
        a_2_6 = upper_2_6_4;
        const stewart_real below_5_2 = STEWART_FABS(a_5_2) > STEWART_FABS(a_2_2) ? REAL(1) : REAL(0);
        const stewart_real upper_2_2_5 = below_5_2 > REAL(0) ? a_5_2 : a_2_2;
        a_5_2 = below_5_2 > REAL(0) ? a_2_2 : a_5_2;
        a_2_2 = upper_2_2_5;
        const stewart_real upper_2_3_5 = below_5_2 > REAL(0) ? a_5_3 : a_2_3;
        a_5_3 = below_5_2 > REAL(0) ? a_2_3 : a_5_3;
        a_2_3 = upper_2_3_5;
        const stewart_real upper_2_4_5 = below_5_2 > REAL(0) ? a_5_4 : a_2_4;
        a_5_4 = below_5_2 > REAL(0) ? a_2_4 : a_5_4;
        a_2_4 = upper_2_4_5;
        const stewart_real upper_2_5_5 = below_5_2 > REAL(0) ? a_5_5 : a_2_5;
        a_5_5 = below_5_2 > REAL(0) ? a_2_5 : a_5_5;
        a_2_5 = upper_2_5_5;
        const stewart_real upper_2_6_5 = below_5_2 > REAL(0) ? a_5_6 : a_2_6;
        a_5_6 = below_5_2 > REAL(0) ? a_2_6 : a_5_6;
        a_2_6 = upper_2_6_5;
        fault = STEWART_FABS(a_2_2) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real inverse_2 = REAL(1)/a_2_2;
        const stewart_real factor_3_2 = a_3_2*inverse_2;
        a_3_3 = a_3_3 - factor_3_2*a_2_3;
        a_3_4 = a_3_4 - factor_3_2*a_2_4;
        a_3_5 = a_3_5 - factor_3_2*a_2_5;
        a_3_6 = a_3_6 - factor_3_2*a_2_6;
        const stewart_real factor_4_2 = a_4_2*inverse_2;
        a_4_3 = a_4_3 - factor_4_2*a_2_3;
        a_4_4 = a_4_4 - factor_4_2*a_2_4;
        a_4_5 = a_4_5 - factor_4_2*a_2_5;
        a_4_6 = a_4_6 - factor_4_2*a_2_6;
        const stewart_real factor_5_2 = a_5_2*inverse_2;
        a_5_3 = a_5_3 - factor_5_2*a_2_3;
        a_5_4 = a_5_4 - factor_5_2*a_2_4;
        a_5_5 = a_5_5 - factor_5_2*a_2_5;
        a_5_6 = a_5_6 - factor_5_2*a_2_6;
        const stewart_real below_4_3 = STEWART_FABS(a_4_3) > STEWART_FABS(a_3_3) ? REAL(1) : REAL(0);
        const stewart_real upper_3_3_4 = below_4_3 > REAL(0) ? a_4_3 : a_3_3;
        a_4_3 = below_4_3 > REAL(0) ? a_3_3 : a_4_3;
        a_3_3 = upper_3_3_4;
        const stewart_real upper_3_4_4 = below_4_3 > REAL(0) ? a_4_4 : a_3_4;
        a_4_4 = below_4_3 > REAL(0) ? a_3_4 : a_4_4;
        a_3_4 = upper_3_4_4;
        const stewart_real upper_3_5_4 = below_4_3 > REAL(0) ? a_4_5 : a_3_5;
        a_4_5 = below_4_3 > REAL(0) ? a_3_5 : a_4_5;
        a_3_5 = upper_3_5_4;
        const stewart_real upper_3_6_4 = below_4_3 > REAL(0) ? a_4_6 : a_3_6;
        a_4_6 = below_4_3 > REAL(0) ? a_3_6 : a_4_6;
        a_3_6 = upper_3_6_4;
        const stewart_real below_5_3 = STEWART_FABS(a_5_3) > STEWART_FABS(a_3_3) ? REAL(1) : REAL(0);
        const stewart_real upper_3_3_5 = below_5_3 > REAL(0) ? a_5_3 : a_3_3;
        a_5_3 = below_5_3 > REAL(0) ? a_3_3 : a_5_3;
        a_3_3 = upper_3_3_5;
        const stewart_real upper_3_4_5 = below_5_3 > REAL(0) ? a_5_4 : a_3_4;
        a_5_4 = below_5_3 > REAL(0) ? a_3_4 : a_5_4;
        a_3_4 = upper_3_4_5;
        const stewart_real upper_3_5_5 = below_5_3 > REAL(0) ? a_5_5 : a_3_5;
        a_5_5 = below_5_3 > REAL(0) ? a_3_5 : a_5_5;
        a_3_5 = upper_3_5_5;
        const stewart_real upper_3_6_5 = below_5_3 > REAL(0) ? a_5_6 : a_3_6;
        a_5_6 = below_5_3 > REAL(0) ? a_3_6 : a_5_6;
        a_3_6 = upper_3_6_5;
        fault = STEWART_FABS(a_3_3) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real inverse_3 = REAL(1)/a_3_3;
        const stewart_real factor_4_3 = a_4_3*inverse_3;
        a_4_4 = a_4_4 - factor_4_3*a_3_4;
        a_4_5 = a_4_5 - factor_4_3*a_3_5;
        a_4_6 = a_4_6 - factor_4_3*a_3_6;
        const stewart_real factor_5_3 = a_5_3*inverse_3;
        a_5_4 = a_5_4 - factor_5_3*a_3_4;
        a_5_5 = a_5_5 - factor_5_3*a_3_5;
        a_5_6 = a_5_6 - factor_5_3*a_3_6;
        const stewart_real below_5_4 = STEWART_FABS(a_5_4) > STEWART_FABS(a_4_4) ? REAL(1) : REAL(0);
        const stewart_real upper_4_4_5 = below_5_4 > REAL(0) ? a_5_4 : a_4_4;
        a_5_4 = below_5_4 > REAL(0) ? a_4_4 : a_5_4;
        a_4_4 = upper_4_4_5;
        const stewart_real upper_4_5_5 = below_5_4 > REAL(0) ? a_5_5 : a_4_5;
        a_5_5 = below_5_4 > REAL(0) ? a_4_5 : a_5_5;
        a_4_5 = upper_4_5_5;
        const stewart_real upper_4_6_5 = below_5_4 > REAL(0) ? a_5_6 : a_4_6;
        a_5_6 = below_5_4 > REAL(0) ? a_4_6 : a_5_6;
        a_4_6 = upper_4_6_5;
        fault = STEWART_FABS(a_4_4) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real inverse_4 = REAL(1)/a_4_4;
        const stewart_real factor_5_4 = a_5_4*inverse_4;
        a_5_5 = a_5_5 - factor_5_4*a_4_5;
        a_5_6 = a_5_6 - factor_5_4*a_4_6;
        fault = STEWART_FABS(a_5_5) > STEWART_SUSPECT ? fault : REAL(1);
        a_5_6 = a_5_6/a_5_5;
        a_4_6 = a_4_6 - a_4_5*a_5_6;
        a_4_6 = a_4_6*inverse_4;
        a_3_6 = a_3_6 - a_3_4*a_4_6;
        a_3_6 = a_3_6 - a_3_5*a_5_6;
        a_3_6 = a_3_6*inverse_3;
        a_2_6 = a_2_6 - a_2_3*a_3_6;
        a_2_6 = a_2_6 - a_2_4*a_4_6;
        a_2_6 = a_2_6 - a_2_5*a_5_6;
        a_2_6 = a_2_6*inverse_2;
        a_1_6 = a_1_6 - a_1_2*a_2_6;
        a_1_6 = a_1_6 - a_1_3*a_3_6;
        a_1_6 = a_1_6 - a_1_4*a_4_6;
        a_1_6 = a_1_6 - a_1_5*a_5_6;
        a_1_6 = a_1_6*inverse_1;
        a_0_6 = a_0_6 - a_0_1*a_1_6;
        a_0_6 = a_0_6 - a_0_2*a_2_6;
        a_0_6 = a_0_6 - a_0_3*a_3_6;
        a_0_6 = a_0_6 - a_0_4*a_4_6;
        a_0_6 = a_0_6 - a_0_5*a_5_6;
        a_0_6 = a_0_6*inverse_0;
        const stewart_real force_0 = D[0][l] - a_0_6;
        fault = STEWART_FABS(force_0) <= STEWART_MAX ? fault : REAL(1);
        F[0][l] = force_0;
        const stewart_real force_1 = D[1][l] - a_1_6;
        fault = STEWART_FABS(force_1) <= STEWART_MAX ? fault : REAL(1);
        F[1][l] = force_1;
        const stewart_real force_2 = D[2][l] - a_2_6;
        fault = STEWART_FABS(force_2) <= STEWART_MAX ? fault : REAL(1);
        F[2][l] = force_2;
        const stewart_real force_3 = D[3][l] - a_3_6;
        fault = STEWART_FABS(force_3) <= STEWART_MAX ? fault : REAL(1);
        F[3][l] = force_3;
        const stewart_real force_4 = D[4][l] - a_4_6;
        fault = STEWART_FABS(force_4) <= STEWART_MAX ? fault : REAL(1);
        F[4][l] = force_4;
        const stewart_real force_5 = D[5][l] - a_5_6;
        fault = STEWART_FABS(force_5) <= STEWART_MAX ? fault : REAL(1);
        F[5][l] = force_5;
        bad[l] = fault;
    }
}

/* `width` numbers of each of eight poses; past the end, the last pose again. */
static const stewart_real *whole(
    const stewart_real *from, size_t width, size_t first, size_t count, stewart_real *padded)
{
    size_t l, i;
    if (first + (size_t)LANES <= count) {
        return &from[first * width];
    }
    for (l = 0; l < (size_t)LANES; ++l) {
        const size_t pose = first + l < count ? first + l : count - 1U;
        for (i = 0; i < width; ++i) {
            padded[l * width + i] = from[pose * width + i];
        }
    }
    return padded;
}

/* Eight vectors, eight matrices, eight zeros: component by component. */
static void spread_vector(
    const stewart_real *STEWART_RESTRICT from, stewart_real (*STEWART_RESTRICT to)[LANES])
{
    int l;
    for (l = 0; l < LANES; ++l) {
        to[0][l] = from[3 * l];
        to[1][l] = from[3 * l + 1];
        to[2][l] = from[3 * l + 2];
    }
}

static void spread_matrix(
    const stewart_real *STEWART_RESTRICT from, stewart_real (*STEWART_RESTRICT to)[LANES])
{
    int i, l;
    for (i = 0; i < 9; ++i) {
        for (l = 0; l < LANES; ++l) {
            to[i][l] = from[9 * l + i];
        }
    }
}

static void clear(stewart_real (*to)[LANES])
{
    int i, l;
    for (i = 0; i < 3; ++i) {
        for (l = 0; l < LANES; ++l) {
            to[i][l] = REAL(0);
        }
    }
}

/* Motions of eight poses, component by component. */
static void load_block(const stewart_motions *motions, size_t first, size_t count, motion_lanes *at)
{
    stewart_real padded[72];
    spread_matrix(whole(motions->R, 9U, first, count, padded), at->R);
    spread_vector(whole(motions->t, 3U, first, count, padded), at->t);
    if (motions->F_ext != NULL) {
        spread_vector(whole(motions->F_ext, 3U, first, count, padded), at->F_ext);
    } else {
        clear(at->F_ext);
    }
    if (motions->M_ext != NULL) {
        spread_vector(whole(motions->M_ext, 3U, first, count, padded), at->M_ext);
    } else {
        clear(at->M_ext);
    }
}

/* Forces of eight poses, and where a closer look is needed. */
static void forces_of_block(
    const stewart_exact_slender_static_model *model, const motion_lanes *at, block *out)
{
    int i, l;
    shared_lanes shared = {0};
    leg_block first;
    leg_block other;
    for (l = 0; l < LANES; ++l) {
        out->bad[l] = REAL(0);
    }
    shared_of_block(model, at, &shared, out->column[6]);
    for (i = 0; i < 6; ++i) {
        leg_of_block(model, i, at, &shared, out->column[i], i == 0 ? &first : &other, out->D[i], out->bad);
        if (i == 0) {
            moments_of_first(&first, out->column[6]);
        } else {
            moments_of_block(&other, first.q, out->column[i], out->column[6]);
        }
    }
    if (model->per_length != REAL(1)) {
        scale_block(out, model->per_length);
    }
    solve_block(out->column, out->D, out->F, out->bad);
}

/* Forces and status of one pose of a batch. */
static int forces_of(
    const stewart_exact_slender_static_model *model, const stewart_motions *motions, size_t pose,
    stewart_real *F)
{
    int i;
    stewart_motion one;
    for (i = 0; i < 9; ++i) {
        one.R[i] = motions->R[pose*9U + (size_t)i];
    }
    for (i = 0; i < 3; ++i) {
        const size_t at = pose*3U + (size_t)i;
        one.t[i] = motions->t[at];
        one.F_ext[i] = motions->F_ext != NULL ? motions->F_ext[at] : REAL(0);
        one.M_ext[i] = motions->M_ext != NULL ? motions->M_ext[at] : REAL(0);
    }
    return stewart_exact_slender_static_forces(model, &one, F);
}

int stewart_exact_slender_static_forces_batch(
    const stewart_exact_slender_static_model *model, size_t count, const stewart_motions *motions,
    stewart_real *F, int *status)
{
    size_t first;
    int i, l;
    motion_lanes at;
    block done;
    int result = STEWART_OK;
    if (model == NULL || motions == NULL || F == NULL || motions->R == NULL || motions->t == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    for (first = 0; first < count; first += (size_t)LANES) {
        load_block(motions, first, count, &at);
        forces_of_block(model, &at, &done);
        for (l = 0; l < LANES; ++l) {
            if (!(first + (size_t)l < count)) {
                break;
            }
            const size_t pose = first + (size_t)l;
            int code = STEWART_OK;
            if (done.bad[l] > REAL(0)) {
                code = forces_of(model, motions, pose, &F[pose*6U]);
            } else {
                for (i = 0; i < 6; ++i) {
                    F[pose*6U + (size_t)i] = done.F[i][l];
                }
            }
            if (status != NULL) {
                status[pose] = code;
            }
            result = result == STEWART_OK ? code : result;
        }
    }
    return result;
}
