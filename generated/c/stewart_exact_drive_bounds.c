/* stewart_exact_drive_bounds.c: functions that are declared and described in stewart_exact_drive_bounds.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * For a quantity x the code may contain
 *     x_err: bound of the error of x;
 *     x_own: bound of the error of the operations that compute x, without the errors of their inputs;
 *     x_max = |x| + x_err: bound of the magnitude of x and of its true value;
 *     x_bar: derivative of an actuator force by x, including all quantities that depend on x.
 * The forward pass computes x_err from the worst case at every step. It is coarse and bounds the derivatives. The
 * backward pass computes the derivatives. By the mean value theorem on the segment between the computed and the exact
 * values, the error of a force is at most the sum of all x_own times the largest magnitude of their derivatives.
 */
#include "stewart_exact_drive_bounds.h"

#include <math.h>

#include "stewart_lanes.h"

#define STEWART_INFINITY ((stewart_real)INFINITY)

/* The largest relative error of an operation is half an epsilon. The additional 1/64 covers the rounding
 * errors of the bounds and of the magnitudes in them, for a depth of a few thousand operations. */
#define STEWART_UNIT (STEWART_EPSILON * (stewart_real)0.5078125)
#define STEWART_SLACK ((stewart_real)1.015625)

/* Contributions of a leg to the constants of the platform, and their sums. */
typedef struct {
    stewart_real M_add;
    stewart_real M_add_err;
    stewart_real h_add[3];
    stewart_real h_add_err[3];
    stewart_real J_add[6];
    stewart_real J_add_err[6];
    stewart_real C_add;
    stewart_real C_add_err;
} added_terms;

/* Terms of a pose that are common to all legs. */
typedef struct {
    stewart_real B[9];
    stewart_real B_err[9];
    stewart_real c_force[3];
    stewart_real c_force_err[3];
    stewart_real c_moment[3];
    stewart_real c_moment_err[3];
    stewart_real c_tip[3];
    stewart_real c_tip_err[3];
    stewart_real q_1[3];
    stewart_real q_1_err[3];
} shared_terms;

/* Terms of a leg in the platform's equations. k3: sine between leg and fixed axis. */
typedef struct {
    stewart_real D;
    stewart_real L;
    stewart_real k3;
    stewart_real reach;
    stewart_real arm[3];
    stewart_real H_force[3];
    stewart_real H_force_err[3];
    stewart_real H_moment[3];
    stewart_real H_moment_err[3];
    stewart_real c_force[3];
    stewart_real c_force_err[3];
    stewart_real c_moment[3];
    stewart_real c_moment_err[3];
    stewart_real arm_c[3];
    stewart_real arm_c_err[3];
} leg_terms;

/* The platform's equations H x = c with moments about platform point 1. c_own: rounding errors of the
 * sums in c; near, close: 1 if a leg is near its joint singularity, or short. */
typedef struct {
    stewart_real H[6][6];
    stewart_real H_err[6][6];
    stewart_real arm[6][3];
    stewart_real c[6];
    stewart_real c_err[6];
    stewart_real c_own[6];
    stewart_real L[6];
    stewart_real reach[6];
    int near;
    int close;
} platform_equations;

/* Weights of D, c, and the column of H of one leg in each force, with the forces in lanes: D_weight D -
 * Y (c - H x). Y_arm: Y_moment, but 0 for leg 1, whose force has no moment about platform point 1. */
typedef struct {
    stewart_real Y_force[3][LANES];
    stewart_real Y_moment[3][LANES];
    stewart_real Y_arm[3][LANES];
    stewart_real D_weight[LANES];
    stewart_real x[LANES];
} force_rows;

/* Derivatives of the forces, in lanes, by the terms common to all legs, through the legs. */
typedef struct {
    stewart_real R_legs[9][LANES];
    stewart_real R_legs_err[9][LANES];
    stewart_real B_legs[9][LANES];
    stewart_real B_legs_err[9][LANES];
    stewart_real q_1_legs[3][LANES];
    stewart_real q_1_legs_err[3][LANES];
} force_slopes;

/* A lower limit of the magnitude of the exact value; 0 if the error may exceed half of `value`. */
static stewart_real least(stewart_real value, stewart_real error)
{
    const stewart_real positive = STEWART_FABS(value);
    return error <= STEWART_HALF*positive ? positive - error : REAL(0);
}

/* Error of a square root r of an argument with `error`: |sqrt(a) - r| <= error / (2 r - error / r). */
static stewart_real root_error(stewart_real root, stewart_real error)
{
    return error/least(REAL(2)*root, error/root) + STEWART_UNIT*root;
}

/* Error of inverse = 1 / of, if `of` has the error `error`. */
static stewart_real reciprocal_error(stewart_real inverse, stewart_real of, stewart_real error)
{
    const stewart_real positive = STEWART_FABS(inverse);
    return positive*(error/least(of, error)) + STEWART_UNIT*positive;
}

/* Adds a term with an error to a sum with an error. */
static void add(stewart_real *total, stewart_real *total_err, stewart_real term, stewart_real term_err)
{
    *total = *total + term;
    *total_err = *total_err + term_err + STEWART_UNIT*STEWART_FABS(*total);
}

/* Bounds the sizes of R^T R - 1, in `stretch`, and the entries of R less the rotation nearest to it, by
 * the largest distance of a singular value from 1: half of the norm of row sums, with a 64th more for
 * the terms of higher order. Entries of R are multiples of `grid` and a rest: products of the multiples
 * have no rounding error, nor has their sum less 1. */
static stewart_real rotation_error(const stewart_real R[9], stewart_real stretch[9])
{
    int i, j, k;
    stewart_real high[9];
    stewart_real low[9];
    stewart_real grid = REAL(1);
    stewart_real worst = REAL(0);
    for (i = 0; i < 64; ++i) {
        if (!(STEWART_HALF*grid*STEWART_HALF*grid >= STEWART_EPSILON)) {
            break;
        }
        grid = STEWART_HALF*grid;
    }
    for (i = 0; i < 9; ++i) {
        const stewart_real shift = REAL(1.5)*(grid/STEWART_EPSILON);
        high[i] = R[i] + shift - shift;
        low[i] = R[i] - high[i];
    }
    for (i = 0; i < 3; ++i) {
        stewart_real row = REAL(0);
        for (j = 0; j < 3; ++j) {
            stewart_real total = i == j ? -REAL(1) : REAL(0);
            stewart_real rest = REAL(0);
            stewart_real sizes = REAL(0);
            for (k = 0; k < 9; k += 3) {
                const stewart_real small = high[k + i]*low[k + j] + low[k + i]*R[k + j];
                total = total + high[k + i]*high[k + j];
                rest = rest + small;
                sizes = sizes + STEWART_FABS(high[k + i]*low[k + j]) + STEWART_FABS(low[k + i]*R[k + j]);
            }
            total = total + rest;
            stretch[3*i + j] = STEWART_FABS(total) + STEWART_UNIT*(REAL(5)*sizes + STEWART_FABS(total));
            row = row + stretch[3*i + j];
        }
        worst = row > worst ? row : worst;
    }
    return worst <= REAL(0.0078125) ? STEWART_HALF*STEWART_SLACK*worst : STEWART_INFINITY;
}

/* Computes the constants of one leg, and its contributions to the constants of the platform. */
static void prepare_leg(
    const stewart_robot *robot, const stewart_leg *leg, stewart_exact_drive_bounds_leg *out,
    added_terms *added)
{
    stewart_real axis[3];
    scaled_axis(leg->k, axis);
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = axis[0], k_y = axis[1], k_z = axis[2];
    const stewart_real m_d = leg->m_d;
    const stewart_real r_d0_x = leg->r_d0[0], r_d0_y = leg->r_d0[1], r_d0_z = leg->r_d0[2];
    const stewart_real I_d0_xx = leg->I_d0[0], I_d0_xy = leg->I_d0[1], I_d0_xz = leg->I_d0[2], I_d0_yy = leg->I_d0[3],
        I_d0_yz = leg->I_d0[4], I_d0_zz = leg->I_d0[5];
    const stewart_real m_u = leg->m_u;
    const stewart_real r_u0_x = leg->r_u0[0], r_u0_y = leg->r_u0[1], r_u0_z = leg->r_u0[2];
    const stewart_real I_u0_xx = leg->I_u0[0], I_u0_xy = leg->I_u0[1], I_u0_xz = leg->I_u0[2], I_u0_yy = leg->I_u0[3],
        I_u0_yz = leg->I_u0[4], I_u0_zz = leg->I_u0[5];
    const stewart_real C_u = leg->C_u;
    const stewart_real C_p = leg->C_p;
    const stewart_real C_s = leg->C_s;
    const stewart_real m_r = leg->m_r;
    const stewart_real j_r = leg->j_r;
    const stewart_real p_1_x = robot->leg[0].p[0], p_1_y = robot->leg[0].p[1], p_1_z = robot->leg[0].p[2];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real k_x_max = STEWART_FABS(k_x);
    const stewart_real k_y_max = STEWART_FABS(k_y);
    const stewart_real k_z_max = STEWART_FABS(k_z);
    const stewart_real m_d_max = STEWART_FABS(m_d);
    const stewart_real r_d0_y_max = STEWART_FABS(r_d0_y);
    const stewart_real r_d0_z_max = STEWART_FABS(r_d0_z);
    const stewart_real I_d0_xx_max = STEWART_FABS(I_d0_xx);
    const stewart_real I_d0_xy_max = STEWART_FABS(I_d0_xy);
    const stewart_real I_d0_xz_max = STEWART_FABS(I_d0_xz);
    const stewart_real I_d0_yy_max = STEWART_FABS(I_d0_yy);
    const stewart_real I_d0_yz_max = STEWART_FABS(I_d0_yz);
    const stewart_real I_d0_zz_max = STEWART_FABS(I_d0_zz);
    const stewart_real m_u_max = STEWART_FABS(m_u);
    const stewart_real r_u0_y_max = STEWART_FABS(r_u0_y);
    const stewart_real r_u0_z_max = STEWART_FABS(r_u0_z);
    const stewart_real I_u0_xx_max = STEWART_FABS(I_u0_xx);
    const stewart_real I_u0_xy_max = STEWART_FABS(I_u0_xy);
    const stewart_real I_u0_xz_max = STEWART_FABS(I_u0_xz);
    const stewart_real I_u0_yy_max = STEWART_FABS(I_u0_yy);
    const stewart_real I_u0_yz_max = STEWART_FABS(I_u0_yz);
    const stewart_real I_u0_zz_max = STEWART_FABS(I_u0_zz);
    const stewart_real g_x_max = STEWART_FABS(g_x);
    const stewart_real g_y_max = STEWART_FABS(g_y);
    const stewart_real g_z_max = STEWART_FABS(g_z);
    const stewart_real k_size = STEWART_SQRT(k_x*k_x + k_y*k_y + k_z*k_z);
    const stewart_real k_size_err = root_error(k_size, STEWART_UNIT*(REAL(3)*k_x_max*k_x_max + REAL(3)*k_y_max*k_y_max
        + REAL(2)*k_z_max*k_z_max));
    const stewart_real inv_k_size = REAL(1)/k_size;
    const stewart_real inv_k_size_err = reciprocal_error(inv_k_size, k_size, k_size_err);
    /* fixed axis, of length one */
    const stewart_real k_unit_x = inv_k_size*k_x;
    const stewart_real k_unit_x_err = inv_k_size_err*k_x_max + STEWART_UNIT*STEWART_FABS(k_unit_x);
    const stewart_real k_unit_x_max = STEWART_FABS(k_unit_x) + k_unit_x_err;
    const stewart_real k_unit_y = inv_k_size*k_y;
    const stewart_real k_unit_y_err = inv_k_size_err*k_y_max + STEWART_UNIT*STEWART_FABS(k_unit_y);
    const stewart_real k_unit_y_max = STEWART_FABS(k_unit_y) + k_unit_y_err;
    const stewart_real k_unit_z = inv_k_size*k_z;
    const stewart_real k_unit_z_err = inv_k_size_err*k_z_max + STEWART_UNIT*STEWART_FABS(k_unit_z);
    const stewart_real k_unit_z_max = STEWART_FABS(k_unit_z) + k_unit_z_err;
    const stewart_real c1 = m_u*r_u0_x;
    const stewart_real c1_err = STEWART_UNIT*STEWART_FABS(c1);
    const stewart_real c1_max = STEWART_FABS(c1) + c1_err;
    const stewart_real h_x = c1;
    const stewart_real h_x_err = c1_err;
    const stewart_real c2 = m_u*r_u0_y;
    const stewart_real c2_err = STEWART_UNIT*STEWART_FABS(c2);
    const stewart_real c2_max = STEWART_FABS(c2) + c2_err;
    const stewart_real h_y = c2;
    const stewart_real h_y_err = c2_err;
    const stewart_real h_z = m_u*r_u0_z;
    const stewart_real h_z_err = STEWART_UNIT*STEWART_FABS(h_z);
    const stewart_real c3 = m_d*r_d0_x;
    const stewart_real c3_err = STEWART_UNIT*STEWART_FABS(c3);
    const stewart_real c3_max = STEWART_FABS(c3) + c3_err;
    const stewart_real w_x = c3 + h_x;
    const stewart_real w_x_err = c3_err + h_x_err + STEWART_UNIT*STEWART_FABS(w_x);
    const stewart_real c4 = m_d*r_d0_y;
    const stewart_real c4_err = STEWART_UNIT*STEWART_FABS(c4);
    const stewart_real c4_max = STEWART_FABS(c4) + c4_err;
    const stewart_real w_y = c4 + h_y;
    const stewart_real w_y_err = c4_err + h_y_err + STEWART_UNIT*STEWART_FABS(w_y);
    const stewart_real w_z = h_z + m_d*r_d0_z;
    const stewart_real w_z_err = h_z_err + STEWART_UNIT*(m_d_max*r_d0_z_max + STEWART_FABS(w_z));
    const stewart_real c5 = r_d0_y*r_d0_y;
    const stewart_real c5_err = STEWART_UNIT*STEWART_FABS(c5);
    const stewart_real c5_max = STEWART_FABS(c5) + c5_err;
    const stewart_real c6 = r_d0_z*r_d0_z;
    const stewart_real c6_err = STEWART_UNIT*STEWART_FABS(c6);
    const stewart_real c6_max = STEWART_FABS(c6) + c6_err;
    const stewart_real c7 = r_u0_y*r_u0_y;
    const stewart_real c7_err = STEWART_UNIT*STEWART_FABS(c7);
    const stewart_real c7_max = STEWART_FABS(c7) + c7_err;
    const stewart_real c8 = r_u0_z*r_u0_z;
    const stewart_real c8_err = STEWART_UNIT*STEWART_FABS(c8);
    const stewart_real c8_max = STEWART_FABS(c8) + c8_err;
    const stewart_real J_xx = I_d0_xx + I_u0_xx + m_d*(c5 + c6) + m_u*(c7 + c8);
    const stewart_real J_xx_err = c5_err*m_d_max + c6_err*m_d_max + c7_err*m_u_max + c8_err*m_u_max + STEWART_UNIT*(REAL(2)*I_d0_xx_max
        + REAL(2)*I_u0_xx_max + REAL(3)*m_d_max*(c5_max + c6_max) + REAL(2)*m_u_max*(c7_max + c8_max) + STEWART_FABS(J_xx));
    const stewart_real J_xy = I_d0_xy + I_u0_xy - c1*r_u0_y - c3*r_d0_y;
    const stewart_real J_xy_err = c1_err*r_u0_y_max + c3_err*r_d0_y_max + STEWART_UNIT*(REAL(2)*I_d0_xy_max
        + REAL(2)*I_u0_xy_max + c3_max*r_d0_y_max + REAL(2)*c1_max*r_u0_y_max + STEWART_FABS(J_xy));
    const stewart_real J_xz = I_d0_xz + I_u0_xz - c1*r_u0_z - c3*r_d0_z;
    const stewart_real J_xz_err = c1_err*r_u0_z_max + c3_err*r_d0_z_max + STEWART_UNIT*(REAL(2)*I_d0_xz_max
        + REAL(2)*I_u0_xz_max + c3_max*r_d0_z_max + REAL(2)*c1_max*r_u0_z_max + STEWART_FABS(J_xz));
    const stewart_real c9 = r_d0_x*r_d0_x;
    const stewart_real c9_err = STEWART_UNIT*STEWART_FABS(c9);
    const stewart_real c9_max = STEWART_FABS(c9) + c9_err;
    const stewart_real c10 = r_u0_x*r_u0_x;
    const stewart_real c10_err = STEWART_UNIT*STEWART_FABS(c10);
    const stewart_real c10_max = STEWART_FABS(c10) + c10_err;
    const stewart_real J_yy = I_d0_yy + I_u0_yy + m_d*(c6 + c9) + m_u*(c10 + c8);
    const stewart_real J_yy_err = c10_err*m_u_max + c6_err*m_d_max + c8_err*m_u_max + c9_err*m_d_max + STEWART_UNIT*(REAL(2)*I_d0_yy_max
        + REAL(2)*I_u0_yy_max + REAL(3)*m_d_max*(c6_max + c9_max) + REAL(2)*m_u_max*(c10_max + c8_max) + STEWART_FABS(J_yy));
    const stewart_real J_yz = I_d0_yz + I_u0_yz - c2*r_u0_z - c4*r_d0_z;
    const stewart_real J_yz_err = c2_err*r_u0_z_max + c4_err*r_d0_z_max + STEWART_UNIT*(REAL(2)*I_d0_yz_max
        + REAL(2)*I_u0_yz_max + c4_max*r_d0_z_max + REAL(2)*c2_max*r_u0_z_max + STEWART_FABS(J_yz));
    const stewart_real J_zz = I_d0_zz + I_u0_zz + m_d*(c5 + c9) + m_u*(c10 + c7);
    const stewart_real J_zz_err = c10_err*m_u_max + c5_err*m_d_max + c7_err*m_u_max + c9_err*m_d_max + STEWART_UNIT*(REAL(2)*I_d0_zz_max
        + REAL(2)*I_u0_zz_max + REAL(3)*m_d_max*(c5_max + c9_max) + REAL(2)*m_u_max*(c10_max + c7_max) + STEWART_FABS(J_zz));
    /* platform point from platform point 1 */
    const stewart_real arm_x = p_x - p_1_x;
    const stewart_real arm_x_err = STEWART_UNIT*STEWART_FABS(arm_x);
    const stewart_real arm_x_max = STEWART_FABS(arm_x) + arm_x_err;
    const stewart_real arm_y = p_y - p_1_y;
    const stewart_real arm_y_err = STEWART_UNIT*STEWART_FABS(arm_y);
    const stewart_real arm_y_max = STEWART_FABS(arm_y) + arm_y_err;
    const stewart_real arm_z = p_z - p_1_z;
    const stewart_real arm_z_err = STEWART_UNIT*STEWART_FABS(arm_z);
    const stewart_real arm_z_max = STEWART_FABS(arm_z) + arm_z_err;
    const stewart_real c11 = arm_x*m_u;
    const stewart_real c11_err = arm_x_err*m_u_max + STEWART_UNIT*STEWART_FABS(c11);
    const stewart_real c11_max = STEWART_FABS(c11) + c11_err;
    const stewart_real c12 = arm_y*m_u;
    const stewart_real c12_err = arm_y_err*m_u_max + STEWART_UNIT*STEWART_FABS(c12);
    const stewart_real c12_max = STEWART_FABS(c12) + c12_err;
    const stewart_real c13 = arm_y*arm_y;
    const stewart_real c13_err = REAL(2)*arm_y_err*arm_y_max + STEWART_UNIT*STEWART_FABS(c13);
    const stewart_real c13_max = STEWART_FABS(c13) + c13_err;
    const stewart_real c14 = arm_z*arm_z;
    const stewart_real c14_err = REAL(2)*arm_z_err*arm_z_max + STEWART_UNIT*STEWART_FABS(c14);
    const stewart_real c14_max = STEWART_FABS(c14) + c14_err;
    const stewart_real c15 = arm_x*arm_x;
    const stewart_real c15_err = REAL(2)*arm_x_err*arm_x_max + STEWART_UNIT*STEWART_FABS(c15);
    const stewart_real c15_max = STEWART_FABS(c15) + c15_err;
    /* 2 h_x */
    const stewart_real h2_x = REAL(2)*h_x;
    const stewart_real h2_x_err = REAL(2)*h_x_err;
    /* 2 h_y */
    const stewart_real h2_y = REAL(2)*h_y;
    const stewart_real h2_y_err = REAL(2)*h_y_err;
    /* 2 h_z */
    const stewart_real h2_z = REAL(2)*h_z;
    const stewart_real h2_z_err = REAL(2)*h_z_err;
    /* 2 J_xz */
    const stewart_real J2_xz = REAL(2)*J_xz;
    const stewart_real J2_xz_err = REAL(2)*J_xz_err;
    /* J_zz - J_xx */
    const stewart_real dJ_zx = J_zz - J_xx;
    const stewart_real dJ_zx_err = J_xx_err + J_zz_err + STEWART_UNIT*STEWART_FABS(dJ_zx);
    /* component of g along the fixed axis k */
    const stewart_real g_k = g_x*k_unit_x + g_y*k_unit_y + g_z*k_unit_z;
    const stewart_real g_k_err = g_x_max*k_unit_x_err + g_y_max*k_unit_y_err + g_z_max*k_unit_z_err + STEWART_UNIT*(g_z_max*k_unit_z_max
        + REAL(2)*g_x_max*k_unit_x_max + REAL(2)*g_y_max*k_unit_y_max + STEWART_FABS(g_k));
    /* g x k, base frame */
    const stewart_real g_x_k_x = g_y*k_unit_z - g_z*k_unit_y;
    const stewart_real g_x_k_x_err = g_y_max*k_unit_z_err + g_z_max*k_unit_y_err + STEWART_UNIT*(g_y_max*k_unit_z_max
        + g_z_max*k_unit_y_max + STEWART_FABS(g_x_k_x));
    const stewart_real g_x_k_y = g_z*k_unit_x - g_x*k_unit_z;
    const stewart_real g_x_k_y_err = g_x_max*k_unit_z_err + g_z_max*k_unit_x_err + STEWART_UNIT*(g_x_max*k_unit_z_max
        + g_z_max*k_unit_x_max + STEWART_FABS(g_x_k_y));
    const stewart_real g_x_k_z = g_x*k_unit_y - g_y*k_unit_x;
    const stewart_real g_x_k_z_err = g_x_max*k_unit_y_err + g_y_max*k_unit_x_err + STEWART_UNIT*(g_x_max*k_unit_y_max
        + g_y_max*k_unit_x_max + STEWART_FABS(g_x_k_z));
    /* C_u + C_s */
    const stewart_real C_us = C_s + C_u;
    const stewart_real C_us_err = STEWART_UNIT*STEWART_FABS(C_us);
    /* first moment of the mass M_add about platform point 1, platform frame */
    const stewart_real h_add_z = arm_z*m_u;
    const stewart_real h_add_z_err = arm_z_err*m_u_max + STEWART_UNIT*STEWART_FABS(h_add_z);
    /* inertia of the mass M_add about platform point 1, platform frame */
    const stewart_real J_add_xx = m_u*(c13 + c14);
    const stewart_real J_add_xx_err = c13_err*m_u_max + c14_err*m_u_max + STEWART_UNIT*(m_u_max*(c13_max + c14_max)
        + STEWART_FABS(J_add_xx));
    const stewart_real J_add_xy = -arm_y*c11;
    const stewart_real J_add_xy_err = arm_y_err*c11_max + arm_y_max*c11_err + STEWART_UNIT*STEWART_FABS(J_add_xy);
    const stewart_real J_add_xz = -arm_z*c11;
    const stewart_real J_add_xz_err = arm_z_err*c11_max + arm_z_max*c11_err + STEWART_UNIT*STEWART_FABS(J_add_xz);
    const stewart_real J_add_yy = m_u*(c14 + c15);
    const stewart_real J_add_yy_err = c14_err*m_u_max + c15_err*m_u_max + STEWART_UNIT*(m_u_max*(c14_max + c15_max)
        + STEWART_FABS(J_add_yy));
    const stewart_real J_add_yz = -arm_z*c12;
    const stewart_real J_add_yz_err = arm_z_err*c12_max + arm_z_max*c12_err + STEWART_UNIT*STEWART_FABS(J_add_yz);
    const stewart_real J_add_zz = m_u*(c13 + c15);
    const stewart_real J_add_zz_err = c13_err*m_u_max + c15_err*m_u_max + STEWART_UNIT*(m_u_max*(c13_max + c15_max)
        + STEWART_FABS(J_add_zz));
    out->b[0] = b_x;
    out->b[1] = b_y;
    out->b[2] = b_z;
    out->p[0] = p_x;
    out->p[1] = p_y;
    out->p[2] = p_z;
    out->k[0] = k_unit_x;
    out->k_err[0] = k_unit_x_err;
    out->k[1] = k_unit_y;
    out->k_err[1] = k_unit_y_err;
    out->k[2] = k_unit_z;
    out->k_err[2] = k_unit_z_err;
    out->C_p = C_p;
    out->C_s = C_s;
    out->m_r = m_r;
    out->j_r = j_r;
    out->h[0] = h_x;
    out->h_err[0] = h_x_err;
    out->h[1] = h_y;
    out->h_err[1] = h_y_err;
    out->h[2] = h_z;
    out->h_err[2] = h_z_err;
    out->h2_x = h2_x;
    out->h2_x_err = h2_x_err;
    out->h2_y = h2_y;
    out->h2_y_err = h2_y_err;
    out->h2_z = h2_z;
    out->h2_z_err = h2_z_err;
    out->w[0] = w_x;
    out->w_err[0] = w_x_err;
    out->w[1] = w_y;
    out->w_err[1] = w_y_err;
    out->w[2] = w_z;
    out->w_err[2] = w_z_err;
    out->J[0] = J_xx;
    out->J_err[0] = J_xx_err;
    out->J[1] = J_xy;
    out->J_err[1] = J_xy_err;
    out->J[2] = J_xz;
    out->J_err[2] = J_xz_err;
    out->J[3] = J_yy;
    out->J_err[3] = J_yy_err;
    out->J[4] = J_yz;
    out->J_err[4] = J_yz_err;
    out->J[5] = J_zz;
    out->J_err[5] = J_zz_err;
    out->J2_xz = J2_xz;
    out->J2_xz_err = J2_xz_err;
    out->dJ_zx = dJ_zx;
    out->dJ_zx_err = dJ_zx_err;
    out->g_k = g_k;
    out->g_k_err = g_k_err;
    out->g_x_k[0] = g_x_k_x;
    out->g_x_k_err[0] = g_x_k_x_err;
    out->g_x_k[1] = g_x_k_y;
    out->g_x_k_err[1] = g_x_k_y_err;
    out->g_x_k[2] = g_x_k_z;
    out->g_x_k_err[2] = g_x_k_z_err;
    out->C_us = C_us;
    out->C_us_err = C_us_err;
    added->M_add = m_u;
    added->M_add_err = REAL(0);
    added->h_add[0] = c11;
    added->h_add_err[0] = c11_err;
    added->h_add[1] = c12;
    added->h_add_err[1] = c12_err;
    added->h_add[2] = h_add_z;
    added->h_add_err[2] = h_add_z_err;
    added->J_add[0] = J_add_xx;
    added->J_add_err[0] = J_add_xx_err;
    added->J_add[1] = J_add_xy;
    added->J_add_err[1] = J_add_xy_err;
    added->J_add[2] = J_add_xz;
    added->J_add_err[2] = J_add_xz_err;
    added->J_add[3] = J_add_yy;
    added->J_add_err[3] = J_add_yy_err;
    added->J_add[4] = J_add_yz;
    added->J_add_err[4] = J_add_yz_err;
    added->J_add[5] = J_add_zz;
    added->J_add_err[5] = J_add_zz_err;
    added->C_add = C_s;
    added->C_add_err = REAL(0);
}

/* Computes the constants of the platform. */
static void prepare_platform(
    const stewart_robot *robot, const added_terms *added, stewart_exact_drive_bounds_platform *out)
{
    const stewart_real M = robot->M;
    const stewart_real R_0_x = robot->R_0[0], R_0_y = robot->R_0[1], R_0_z = robot->R_0[2];
    const stewart_real I_p_xx = robot->I_p[0], I_p_xy = robot->I_p[1], I_p_xz = robot->I_p[2], I_p_yy = robot->I_p[3],
        I_p_yz = robot->I_p[4], I_p_zz = robot->I_p[5];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real p_1_x = robot->leg[0].p[0], p_1_y = robot->leg[0].p[1], p_1_z = robot->leg[0].p[2];
    const stewart_real M_add = added->M_add;
    const stewart_real M_add_err = added->M_add_err;
    const stewart_real h_add_x = added->h_add[0], h_add_y = added->h_add[1], h_add_z = added->h_add[2];
    const stewart_real h_add_x_err = added->h_add_err[0], h_add_y_err = added->h_add_err[1], h_add_z_err = added->h_add_err[2];
    const stewart_real J_add_xx = added->J_add[0], J_add_xy = added->J_add[1], J_add_xz = added->J_add[2],
        J_add_yy = added->J_add[3], J_add_yz = added->J_add[4], J_add_zz = added->J_add[5];
    const stewart_real J_add_xx_err = added->J_add_err[0], J_add_xy_err = added->J_add_err[1], J_add_xz_err = added->J_add_err[2],
        J_add_yy_err = added->J_add_err[3], J_add_yz_err = added->J_add_err[4], J_add_zz_err = added->J_add_err[5];
    const stewart_real C_add = added->C_add;
    const stewart_real C_add_err = added->C_add_err;
    const stewart_real M_max = STEWART_FABS(M);
    const stewart_real R_0_x_max = STEWART_FABS(R_0_x);
    const stewart_real R_0_y_max = STEWART_FABS(R_0_y);
    const stewart_real R_0_z_max = STEWART_FABS(R_0_z);
    const stewart_real I_p_xx_max = STEWART_FABS(I_p_xx);
    const stewart_real I_p_xy_max = STEWART_FABS(I_p_xy);
    const stewart_real I_p_xz_max = STEWART_FABS(I_p_xz);
    const stewart_real I_p_yy_max = STEWART_FABS(I_p_yy);
    const stewart_real I_p_yz_max = STEWART_FABS(I_p_yz);
    const stewart_real I_p_zz_max = STEWART_FABS(I_p_zz);
    const stewart_real p_1_x_max = STEWART_FABS(p_1_x);
    const stewart_real p_1_y_max = STEWART_FABS(p_1_y);
    const stewart_real p_1_z_max = STEWART_FABS(p_1_z);
    const stewart_real M_add_max = STEWART_FABS(M_add) + M_add_err;
    const stewart_real h_add_x_max = STEWART_FABS(h_add_x) + h_add_x_err;
    const stewart_real h_add_y_max = STEWART_FABS(h_add_y) + h_add_y_err;
    const stewart_real h_add_z_max = STEWART_FABS(h_add_z) + h_add_z_err;
    const stewart_real J_add_xx_max = STEWART_FABS(J_add_xx) + J_add_xx_err;
    const stewart_real J_add_xy_max = STEWART_FABS(J_add_xy) + J_add_xy_err;
    const stewart_real J_add_xz_max = STEWART_FABS(J_add_xz) + J_add_xz_err;
    const stewart_real J_add_yy_max = STEWART_FABS(J_add_yy) + J_add_yy_err;
    const stewart_real J_add_yz_max = STEWART_FABS(J_add_yz) + J_add_yz_err;
    const stewart_real J_add_zz_max = STEWART_FABS(J_add_zz) + J_add_zz_err;
    const stewart_real M_P = M + M_add;
    const stewart_real M_P_err = M_add_err + STEWART_UNIT*STEWART_FABS(M_P);
    /* center of mass of the platform without the upper parts, from platform point 1 */
    const stewart_real arm_x = R_0_x - p_1_x;
    const stewart_real arm_x_err = STEWART_UNIT*STEWART_FABS(arm_x);
    const stewart_real arm_x_max = STEWART_FABS(arm_x) + arm_x_err;
    const stewart_real arm_y = R_0_y - p_1_y;
    const stewart_real arm_y_err = STEWART_UNIT*STEWART_FABS(arm_y);
    const stewart_real arm_y_max = STEWART_FABS(arm_y) + arm_y_err;
    const stewart_real arm_z = R_0_z - p_1_z;
    const stewart_real arm_z_err = STEWART_UNIT*STEWART_FABS(arm_z);
    const stewart_real arm_z_max = STEWART_FABS(arm_z) + arm_z_err;
    /* first moment of the lumped masses about this center */
    const stewart_real e_x = h_add_x - M_add*arm_x;
    const stewart_real e_x_err = h_add_x_err + M_add_err*arm_x_max + M_add_max*arm_x_err + STEWART_UNIT*(M_add_max*arm_x_max
        + STEWART_FABS(e_x));
    const stewart_real e_x_max = STEWART_FABS(e_x) + e_x_err;
    const stewart_real e_y = h_add_y - M_add*arm_y;
    const stewart_real e_y_err = h_add_y_err + M_add_err*arm_y_max + M_add_max*arm_y_err + STEWART_UNIT*(M_add_max*arm_y_max
        + STEWART_FABS(e_y));
    const stewart_real e_y_max = STEWART_FABS(e_y) + e_y_err;
    const stewart_real e_z = h_add_z - M_add*arm_z;
    const stewart_real e_z_err = h_add_z_err + M_add_err*arm_z_max + M_add_max*arm_z_err + STEWART_UNIT*(M_add_max*arm_z_max
        + STEWART_FABS(e_z));
    const stewart_real e_z_max = STEWART_FABS(e_z) + e_z_err;
    /* first moment about the reference point */
    const stewart_real h_P_x = h_add_x + M*R_0_x + M_add*p_1_x;
    const stewart_real h_P_x_err = h_add_x_err + M_add_err*p_1_x_max + STEWART_UNIT*(h_add_x_max + M_add_max*p_1_x_max
        + REAL(2)*M_max*R_0_x_max + STEWART_FABS(h_P_x));
    const stewart_real h_P_x_max = STEWART_FABS(h_P_x) + h_P_x_err;
    const stewart_real h_P_y = h_add_y + M*R_0_y + M_add*p_1_y;
    const stewart_real h_P_y_err = h_add_y_err + M_add_err*p_1_y_max + STEWART_UNIT*(h_add_y_max + M_add_max*p_1_y_max
        + REAL(2)*M_max*R_0_y_max + STEWART_FABS(h_P_y));
    const stewart_real h_P_y_max = STEWART_FABS(h_P_y) + h_P_y_err;
    const stewart_real h_P_z = h_add_z + M*R_0_z + M_add*p_1_z;
    const stewart_real h_P_z_err = h_add_z_err + M_add_err*p_1_z_max + STEWART_UNIT*(h_add_z_max + M_add_max*p_1_z_max
        + REAL(2)*M_max*R_0_z_max + STEWART_FABS(h_P_z));
    const stewart_real h_P_z_max = STEWART_FABS(h_P_z) + h_P_z_err;
    const stewart_real c1 = REAL(1)/M_P;
    const stewart_real c1_err = reciprocal_error(c1, M_P, M_P_err);
    const stewart_real c1_max = STEWART_FABS(c1) + c1_err;
    const stewart_real r_C_x = c1*h_P_x;
    const stewart_real r_C_x_err = c1_err*h_P_x_max + c1_max*h_P_x_err + STEWART_UNIT*STEWART_FABS(r_C_x);
    const stewart_real r_C_y = c1*h_P_y;
    const stewart_real r_C_y_err = c1_err*h_P_y_max + c1_max*h_P_y_err + STEWART_UNIT*STEWART_FABS(r_C_y);
    const stewart_real r_C_z = c1*h_P_z;
    const stewart_real r_C_z_err = c1_err*h_P_z_max + c1_max*h_P_z_err + STEWART_UNIT*STEWART_FABS(r_C_z);
    const stewart_real r_x = c1*h_add_x;
    const stewart_real r_x_err = c1_err*h_add_x_max + c1_max*h_add_x_err + STEWART_UNIT*STEWART_FABS(r_x);
    const stewart_real r_x_max = STEWART_FABS(r_x) + r_x_err;
    const stewart_real r_y = c1*h_add_y;
    const stewart_real r_y_err = c1_err*h_add_y_max + c1_max*h_add_y_err + STEWART_UNIT*STEWART_FABS(r_y);
    const stewart_real r_y_max = STEWART_FABS(r_y) + r_y_err;
    const stewart_real r_z = c1*h_add_z;
    const stewart_real r_z_err = c1_err*h_add_z_max + c1_max*h_add_z_err + STEWART_UNIT*STEWART_FABS(r_z);
    const stewart_real r_z_max = STEWART_FABS(r_z) + r_z_err;
    const stewart_real c2 = STEWART_HALF*M*c1;
    const stewart_real c2_err = STEWART_HALF*M_max*c1_err + STEWART_UNIT*STEWART_FABS(c2);
    const stewart_real c2_max = STEWART_FABS(c2) + c2_err;
    const stewart_real u_x = c2*(h_add_x + e_x);
    const stewart_real u_x_err = c2_max*e_x_err + c2_max*h_add_x_err + c2_err*(e_x_max + h_add_x_max) + STEWART_UNIT*(c2_max*(e_x_max
        + h_add_x_max) + STEWART_FABS(u_x));
    const stewart_real u_x_max = STEWART_FABS(u_x) + u_x_err;
    const stewart_real u_y = c2*(h_add_y + e_y);
    const stewart_real u_y_err = c2_max*e_y_err + c2_max*h_add_y_err + c2_err*(e_y_max + h_add_y_max) + STEWART_UNIT*(c2_max*(e_y_max
        + h_add_y_max) + STEWART_FABS(u_y));
    const stewart_real u_y_max = STEWART_FABS(u_y) + u_y_err;
    const stewart_real u_z = c2*(h_add_z + e_z);
    const stewart_real u_z_err = c2_max*e_z_err + c2_max*h_add_z_err + c2_err*(e_z_max + h_add_z_max) + STEWART_UNIT*(c2_max*(e_z_max
        + h_add_z_max) + STEWART_FABS(u_z));
    const stewart_real u_z_max = STEWART_FABS(u_z) + u_z_err;
    const stewart_real c3 = h_add_z*r_z + REAL(2)*arm_z*u_z;
    const stewart_real c3_err = h_add_z_err*r_z_max + h_add_z_max*r_z_err + REAL(2)*arm_z_err*u_z_max + REAL(2)*arm_z_max*u_z_err
        + STEWART_UNIT*(h_add_z_max*r_z_max + REAL(2)*arm_z_max*u_z_max + STEWART_FABS(c3));
    const stewart_real c3_max = STEWART_FABS(c3) + c3_err;
    const stewart_real c4 = h_add_y*r_y + REAL(2)*arm_y*u_y;
    const stewart_real c4_err = h_add_y_err*r_y_max + h_add_y_max*r_y_err + REAL(2)*arm_y_err*u_y_max + REAL(2)*arm_y_max*u_y_err
        + STEWART_UNIT*(h_add_y_max*r_y_max + REAL(2)*arm_y_max*u_y_max + STEWART_FABS(c4));
    const stewart_real c4_max = STEWART_FABS(c4) + c4_err;
    const stewart_real J_C_xx = I_p_xx + J_add_xx - c3 - c4;
    const stewart_real J_C_xx_err = J_add_xx_err + c3_err + c4_err + STEWART_UNIT*(c3_max + REAL(2)*I_p_xx_max
        + REAL(2)*J_add_xx_max + STEWART_FABS(J_C_xx));
    const stewart_real J_C_xy = I_p_xy + J_add_xy + h_add_x*r_y + arm_x*u_y + arm_y*u_x;
    const stewart_real J_C_xy_err = J_add_xy_err + arm_x_err*u_y_max + arm_x_max*u_y_err + arm_y_err*u_x_max
        + arm_y_max*u_x_err + h_add_x_err*r_y_max + h_add_x_max*r_y_err + STEWART_UNIT*(REAL(3)*I_p_xy_max + REAL(3)*J_add_xy_max
        + arm_y_max*u_x_max + REAL(2)*arm_x_max*u_y_max + REAL(3)*h_add_x_max*r_y_max + STEWART_FABS(J_C_xy));
    const stewart_real J_C_xz = I_p_xz + J_add_xz + h_add_x*r_z + arm_x*u_z + arm_z*u_x;
    const stewart_real J_C_xz_err = J_add_xz_err + arm_x_err*u_z_max + arm_x_max*u_z_err + arm_z_err*u_x_max
        + arm_z_max*u_x_err + h_add_x_err*r_z_max + h_add_x_max*r_z_err + STEWART_UNIT*(REAL(3)*I_p_xz_max + REAL(3)*J_add_xz_max
        + arm_z_max*u_x_max + REAL(2)*arm_x_max*u_z_max + REAL(3)*h_add_x_max*r_z_max + STEWART_FABS(J_C_xz));
    const stewart_real c5 = h_add_x*r_x + REAL(2)*arm_x*u_x;
    const stewart_real c5_err = h_add_x_err*r_x_max + h_add_x_max*r_x_err + REAL(2)*arm_x_err*u_x_max + REAL(2)*arm_x_max*u_x_err
        + STEWART_UNIT*(h_add_x_max*r_x_max + REAL(2)*arm_x_max*u_x_max + STEWART_FABS(c5));
    const stewart_real J_C_yy = I_p_yy + J_add_yy - c3 - c5;
    const stewart_real J_C_yy_err = J_add_yy_err + c3_err + c5_err + STEWART_UNIT*(c3_max + REAL(2)*I_p_yy_max
        + REAL(2)*J_add_yy_max + STEWART_FABS(J_C_yy));
    const stewart_real J_C_yz = I_p_yz + J_add_yz + h_add_y*r_z + arm_y*u_z + arm_z*u_y;
    const stewart_real J_C_yz_err = J_add_yz_err + arm_y_err*u_z_max + arm_y_max*u_z_err + arm_z_err*u_y_max
        + arm_z_max*u_y_err + h_add_y_err*r_z_max + h_add_y_max*r_z_err + STEWART_UNIT*(REAL(3)*I_p_yz_max + REAL(3)*J_add_yz_max
        + arm_z_max*u_y_max + REAL(2)*arm_y_max*u_z_max + REAL(3)*h_add_y_max*r_z_max + STEWART_FABS(J_C_yz));
    const stewart_real J_C_zz = I_p_zz + J_add_zz - c4 - c5;
    const stewart_real J_C_zz_err = J_add_zz_err + c4_err + c5_err + STEWART_UNIT*(c4_max + REAL(2)*I_p_zz_max
        + REAL(2)*J_add_zz_max + STEWART_FABS(J_C_zz));
    /* J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx */
    const stewart_real dJ_C_x = J_C_zz - J_C_yy;
    const stewart_real dJ_C_x_err = J_C_yy_err + J_C_zz_err + STEWART_UNIT*STEWART_FABS(dJ_C_x);
    const stewart_real dJ_C_y = J_C_xx - J_C_zz;
    const stewart_real dJ_C_y_err = J_C_xx_err + J_C_zz_err + STEWART_UNIT*STEWART_FABS(dJ_C_y);
    const stewart_real dJ_C_z = J_C_yy - J_C_xx;
    const stewart_real dJ_C_z_err = J_C_xx_err + J_C_yy_err + STEWART_UNIT*STEWART_FABS(dJ_C_z);
    out->M_P = M_P;
    out->M_P_err = M_P_err;
    out->r_C[0] = r_C_x;
    out->r_C_err[0] = r_C_x_err;
    out->r_C[1] = r_C_y;
    out->r_C_err[1] = r_C_y_err;
    out->r_C[2] = r_C_z;
    out->r_C_err[2] = r_C_z_err;
    out->J_C[0] = J_C_xx;
    out->J_C_err[0] = J_C_xx_err;
    out->J_C[1] = J_C_xy;
    out->J_C_err[1] = J_C_xy_err;
    out->J_C[2] = J_C_xz;
    out->J_C_err[2] = J_C_xz_err;
    out->J_C[3] = J_C_yy;
    out->J_C_err[3] = J_C_yy_err;
    out->J_C[4] = J_C_yz;
    out->J_C_err[4] = J_C_yz_err;
    out->J_C[5] = J_C_zz;
    out->J_C_err[5] = J_C_zz_err;
    out->dJ_C[0] = dJ_C_x;
    out->dJ_C_err[0] = dJ_C_x_err;
    out->dJ_C[1] = dJ_C_y;
    out->dJ_C_err[1] = dJ_C_y_err;
    out->dJ_C[2] = dJ_C_z;
    out->dJ_C_err[2] = dJ_C_z_err;
    out->C_P = C_add;
    out->C_P_err = C_add_err;
    out->g[0] = g_x;
    out->g[1] = g_y;
    out->g[2] = g_z;
    out->p_1[0] = p_1_x;
    out->p_1[1] = p_1_y;
    out->p_1[2] = p_1_z;
}

/* Returns the largest coordinate (m) of the arms of moments about platform point 1. */
static stewart_real size_of(const stewart_exact_drive_bounds_model *model)
{
    int i, j;
    stewart_real largest = REAL(0);
    for (j = 0; j < 3; ++j) {
        for (i = 1; i < 6; ++i) {
            largest = STEWART_LARGER(STEWART_FABS(model->leg[i].p[j] - model->leg[0].p[j]), largest);
        }
    }
    return largest;
}

int stewart_exact_drive_bounds_prepare(const stewart_robot *robot, stewart_exact_drive_bounds_model *model)
{
    int i, j;
    stewart_exact_drive_bounds_model made;
    added_terms found;
    added_terms sum;
    stewart_real squares = REAL(0);
    if (robot == NULL || model == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    sum.M_add = REAL(0);
    sum.M_add_err = REAL(0);
    sum.h_add[0] = REAL(0);
    sum.h_add_err[0] = REAL(0);
    sum.h_add[1] = REAL(0);
    sum.h_add_err[1] = REAL(0);
    sum.h_add[2] = REAL(0);
    sum.h_add_err[2] = REAL(0);
    sum.J_add[0] = REAL(0);
    sum.J_add_err[0] = REAL(0);
    sum.J_add[1] = REAL(0);
    sum.J_add_err[1] = REAL(0);
    sum.J_add[2] = REAL(0);
    sum.J_add_err[2] = REAL(0);
    sum.J_add[3] = REAL(0);
    sum.J_add_err[3] = REAL(0);
    sum.J_add[4] = REAL(0);
    sum.J_add_err[4] = REAL(0);
    sum.J_add[5] = REAL(0);
    sum.J_add_err[5] = REAL(0);
    sum.C_add = REAL(0);
    sum.C_add_err = REAL(0);
    for (i = 0; i < 6; ++i) {
        prepare_leg(robot, &robot->leg[i], &made.leg[i], &found);
        add(&sum.M_add, &sum.M_add_err, found.M_add, found.M_add_err);
        add(&sum.h_add[0], &sum.h_add_err[0], found.h_add[0], found.h_add_err[0]);
        add(&sum.h_add[1], &sum.h_add_err[1], found.h_add[1], found.h_add_err[1]);
        add(&sum.h_add[2], &sum.h_add_err[2], found.h_add[2], found.h_add_err[2]);
        add(&sum.J_add[0], &sum.J_add_err[0], found.J_add[0], found.J_add_err[0]);
        add(&sum.J_add[1], &sum.J_add_err[1], found.J_add[1], found.J_add_err[1]);
        add(&sum.J_add[2], &sum.J_add_err[2], found.J_add[2], found.J_add_err[2]);
        add(&sum.J_add[3], &sum.J_add_err[3], found.J_add[3], found.J_add_err[3]);
        add(&sum.J_add[4], &sum.J_add_err[4], found.J_add[4], found.J_add_err[4]);
        add(&sum.J_add[5], &sum.J_add_err[5], found.J_add[5], found.J_add_err[5]);
        add(&sum.C_add, &sum.C_add_err, found.C_add, found.C_add_err);
        for (j = 0; j < 3; ++j) {
            squares = squares + robot->leg[i].p[j]*robot->leg[i].p[j];
        }
    }
    prepare_platform(robot, &sum, &made.platform);
    made.length = STEWART_SQRT(squares/REAL(6));
    const stewart_real largest = size_of(&made);
    made.per_length = per_length_of(largest, REAL(0.125));
    made.arm_cube = cube_of(largest*made.per_length);
    const stewart_real *const numbers = (const stewart_real *)&made;
    for (i = 0; i < 397; ++i) {
        if (!(STEWART_FABS(numbers[i]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    *model = made;
    return STEWART_OK;
}

/* Terms of one pose that are common to all legs. */
static void shared_of_pose(
    const stewart_exact_drive_bounds_platform *platform, const stewart_motions *at, shared_terms *out)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real M_ext_x = at->M_ext[0], M_ext_y = at->M_ext[1], M_ext_z = at->M_ext[2];
    const stewart_real M_P = platform->M_P;
    const stewart_real r_C_x = platform->r_C[0], r_C_y = platform->r_C[1], r_C_z = platform->r_C[2];
    const stewart_real J_C_xx = platform->J_C[0], J_C_xy = platform->J_C[1], J_C_xz = platform->J_C[2],
        J_C_yy = platform->J_C[3], J_C_yz = platform->J_C[4], J_C_zz = platform->J_C[5];
    const stewart_real dJ_C_x = platform->dJ_C[0], dJ_C_y = platform->dJ_C[1], dJ_C_z = platform->dJ_C[2];
    const stewart_real C_P = platform->C_P;
    const stewart_real g_x = platform->g[0], g_y = platform->g[1], g_z = platform->g[2];
    const stewart_real p_1_x = platform->p_1[0], p_1_y = platform->p_1[1], p_1_z = platform->p_1[2];
    /* products of omega */
    const stewart_real omega_xx = omega_x*omega_x;
    const stewart_real omega_xy = omega_x*omega_y;
    (void)(omega_xy);
    const stewart_real omega_xz = omega_x*omega_z;
    (void)(omega_xz);
    const stewart_real omega_yy = omega_y*omega_y;
    const stewart_real omega_yz = omega_y*omega_z;
    (void)(omega_yz);
    const stewart_real omega_zz = omega_z*omega_z;
    (void)(omega_zz);
    /* (7) S_ddot = B q + a */
    const stewart_real B_xx = STEWART_FMA_OF(-omega_zz, -omega_z, omega_z, -omega_yy);
    const stewart_real B_xy = STEWART_FMA_OF(omega_xy, omega_x, omega_y, -alpha_z);
    const stewart_real B_xz = STEWART_FMA_OF(omega_xz, omega_x, omega_z, alpha_y);
    const stewart_real B_yx = STEWART_FMA_OF(omega_xy, omega_x, omega_y, alpha_z);
    const stewart_real B_yy = STEWART_FMA_OF(-omega_zz, -omega_z, omega_z, -omega_xx);
    const stewart_real B_yz = STEWART_FMA_OF(omega_yz, omega_y, omega_z, -alpha_x);
    const stewart_real B_zx = STEWART_FMA_OF(omega_xz, omega_x, omega_z, -alpha_y);
    const stewart_real B_zy = STEWART_FMA_OF(omega_yz, omega_y, omega_z, alpha_x);
    const stewart_real B_zz = STEWART_FMA_OF(-omega_yy, -omega_y, omega_y, -omega_xx);
    /* (30) center of mass from the reference point, base frame */
    const stewart_real R_C_x = STEWART_FMA(R_xz, r_C_z, STEWART_FMA(R_xy, r_C_y, R_xx*r_C_x));
    const stewart_real R_C_y = STEWART_FMA(R_yz, r_C_z, STEWART_FMA(R_yy, r_C_y, R_yx*r_C_x));
    const stewart_real R_C_z = STEWART_FMA(R_zz, r_C_z, STEWART_FMA(R_zy, r_C_y, R_zx*r_C_x));
    /* (33) M_P (g - a_C) */
    const stewart_real N_x = M_P*STEWART_FMA(-B_xz, R_C_z, STEWART_FMA(-B_xy, R_C_y, STEWART_FMA(-B_xx,
        R_C_x, g_x - a_x)));
    const stewart_real N_y = M_P*STEWART_FMA(-B_yz, R_C_z, STEWART_FMA(-B_yy, R_C_y, STEWART_FMA(-B_yx,
        R_C_x, g_y - a_y)));
    const stewart_real N_z = M_P*STEWART_FMA(-B_zz, R_C_z, STEWART_FMA(-B_zy, R_C_y, STEWART_FMA(-B_zx,
        R_C_x, g_z - a_z)));
    /* angular velocity, platform frame */
    const stewart_real omega_P_x = STEWART_FMA(R_zx, omega_z, STEWART_FMA(R_yx, omega_y, R_xx*omega_x));
    const stewart_real omega_P_y = STEWART_FMA(R_zy, omega_z, STEWART_FMA(R_yy, omega_y, R_xy*omega_x));
    const stewart_real omega_P_z = STEWART_FMA(R_zz, omega_z, STEWART_FMA(R_yz, omega_y, R_xz*omega_x));
    /* angular acceleration, platform frame */
    const stewart_real alpha_P_x = STEWART_FMA(R_zx, alpha_z, STEWART_FMA(R_yx, alpha_y, R_xx*alpha_x));
    const stewart_real alpha_P_y = STEWART_FMA(R_zy, alpha_z, STEWART_FMA(R_yy, alpha_y, R_xy*alpha_x));
    const stewart_real alpha_P_z = STEWART_FMA(R_zz, alpha_z, STEWART_FMA(R_yz, alpha_y, R_xz*alpha_x));
    const stewart_real P_xy = omega_P_x*omega_P_y;
    const stewart_real P_xz = omega_P_x*omega_P_z;
    const stewart_real P_yz = omega_P_y*omega_P_z;
    const stewart_real P_xx = omega_P_x*omega_P_x;
    const stewart_real P_yy = omega_P_y*omega_P_y;
    const stewart_real P_zz = omega_P_z*omega_P_z;
    /* (34) external moment less I alpha + omega x I omega, platform frame */
    const stewart_real M_P_load_x = STEWART_FMA(-J_C_xz, STEWART_FMA_OF(P_xy, omega_P_x, omega_P_y,
        alpha_P_z), STEWART_FMA(J_C_xy, STEWART_FMA_OF(P_xz, omega_P_x, omega_P_z, -alpha_P_y),
        STEWART_FMA(-P_yz, dJ_C_x, STEWART_FMA(-J_C_xx, alpha_P_x, STEWART_FMA(-J_C_yz,
        STEWART_FMA_OF(-P_zz, -omega_P_z, omega_P_z, P_yy), M_ext_x)))));
    const stewart_real M_P_load_y = STEWART_FMA(-J_C_xy, STEWART_FMA_OF(P_yz, omega_P_y, omega_P_z,
        alpha_P_x), STEWART_FMA(J_C_yz, STEWART_FMA_OF(P_xy, omega_P_x, omega_P_y, -alpha_P_z),
        STEWART_FMA(-P_xz, dJ_C_y, STEWART_FMA(-J_C_yy, alpha_P_y, STEWART_FMA(-J_C_xz,
        STEWART_FMA_OF(-P_xx, -omega_P_x, omega_P_x, P_zz), M_ext_y)))));
    const stewart_real M_P_load_z = STEWART_FMA(-J_C_yz, STEWART_FMA_OF(P_xz, omega_P_x, omega_P_z,
        alpha_P_y), STEWART_FMA(J_C_xz, STEWART_FMA_OF(P_yz, omega_P_y, omega_P_z, -alpha_P_x),
        STEWART_FMA(-P_xy, dJ_C_z, STEWART_FMA(-J_C_zz, alpha_P_z, STEWART_FMA(-J_C_xy,
        STEWART_FMA_OF(-P_yy, -omega_P_y, omega_P_y, P_xx), M_ext_z)))));
    const stewart_real c_force_x = STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy,
        STEWART_FMA(F_ext_x, R_xx, N_x)));
    const stewart_real c_force_y = STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy,
        STEWART_FMA(F_ext_x, R_yx, N_y)));
    const stewart_real c_force_z = STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy,
        STEWART_FMA(F_ext_x, R_zx, N_z)));
    const stewart_real c_moment_x = STEWART_FMA(-N_y, R_C_z, STEWART_FMA(-C_P, omega_x, STEWART_FMA(N_z,
        R_C_y, STEWART_FMA(M_P_load_z, R_xz, STEWART_FMA(M_P_load_y, R_xy, M_P_load_x*R_xx)))));
    const stewart_real c_moment_y = STEWART_FMA(-N_z, R_C_x, STEWART_FMA(-C_P, omega_y, STEWART_FMA(N_x,
        R_C_z, STEWART_FMA(M_P_load_z, R_yz, STEWART_FMA(M_P_load_y, R_yy, M_P_load_x*R_yx)))));
    const stewart_real c_moment_z = STEWART_FMA(-N_x, R_C_y, STEWART_FMA(-C_P, omega_z, STEWART_FMA(N_y,
        R_C_x, STEWART_FMA(M_P_load_z, R_zz, STEWART_FMA(M_P_load_y, R_zy, M_P_load_x*R_zx)))));
    /* (1) platform point 1 from the reference point, base frame */
    const stewart_real q_1_x = STEWART_FMA(R_xz, p_1_z, STEWART_FMA(R_xy, p_1_y, R_xx*p_1_x));
    const stewart_real q_1_y = STEWART_FMA(R_yz, p_1_z, STEWART_FMA(R_yy, p_1_y, R_yx*p_1_x));
    const stewart_real q_1_z = STEWART_FMA(R_zz, p_1_z, STEWART_FMA(R_zy, p_1_y, R_zx*p_1_x));
    /* the platform's part of c, moment rows, about platform point 1 */
    const stewart_real c_tip_x = STEWART_FMA(-c_force_z, q_1_y, STEWART_FMA(c_force_y, q_1_z, c_moment_x));
    const stewart_real c_tip_y = STEWART_FMA(-c_force_x, q_1_z, STEWART_FMA(c_force_z, q_1_x, c_moment_y));
    const stewart_real c_tip_z = STEWART_FMA(-c_force_y, q_1_x, STEWART_FMA(c_force_x, q_1_y, c_moment_z));
    out->B[0] = B_xx;
    out->B[1] = B_xy;
    out->B[2] = B_xz;
    out->B[3] = B_yx;
    out->B[4] = B_yy;
    out->B[5] = B_yz;
    out->B[6] = B_zx;
    out->B[7] = B_zy;
    out->B[8] = B_zz;
    out->c_force[0] = c_force_x;
    out->c_force[1] = c_force_y;
    out->c_force[2] = c_force_z;
    out->c_moment[0] = c_moment_x;
    out->c_moment[1] = c_moment_y;
    out->c_moment[2] = c_moment_z;
    out->c_tip[0] = c_tip_x;
    out->c_tip[1] = c_tip_y;
    out->c_tip[2] = c_tip_z;
    out->q_1[0] = q_1_x;
    out->q_1[1] = q_1_y;
    out->q_1[2] = q_1_z;
}

/* One leg in joint coordinates: D, its column of H and its part of c. */
static void leg_of_pose(
    const stewart_exact_drive_bounds_platform *platform, const stewart_exact_drive_bounds_leg *leg,
    const stewart_motions *at, const shared_terms *shared, leg_terms *out)
{
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = leg->k[0], k_y = leg->k[1], k_z = leg->k[2];
    const stewart_real C_p = leg->C_p;
    const stewart_real C_s = leg->C_s;
    const stewart_real m_r = leg->m_r;
    const stewart_real j_r = leg->j_r;
    const stewart_real h_x = leg->h[0], h_y = leg->h[1], h_z = leg->h[2];
    const stewart_real h2_x = leg->h2_x;
    const stewart_real h2_y = leg->h2_y;
    const stewart_real h2_z = leg->h2_z;
    const stewart_real w_x = leg->w[0], w_y = leg->w[1], w_z = leg->w[2];
    const stewart_real J_xx = leg->J[0], J_xy = leg->J[1], J_yy = leg->J[3], J_yz = leg->J[4];
    const stewart_real J2_xz = leg->J2_xz;
    const stewart_real dJ_zx = leg->dJ_zx;
    const stewart_real g_k = leg->g_k;
    const stewart_real g_x_k_x = leg->g_x_k[0], g_x_k_y = leg->g_x_k[1], g_x_k_z = leg->g_x_k[2];
    const stewart_real C_us = leg->C_us;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real B_xx = shared->B[0], B_xy = shared->B[1], B_xz = shared->B[2], B_yx = shared->B[3],
        B_yy = shared->B[4], B_yz = shared->B[5], B_zx = shared->B[6], B_zy = shared->B[7], B_zz = shared->B[8];
    const stewart_real g_x = platform->g[0], g_y = platform->g[1], g_z = platform->g[2];
    const stewart_real q_1_x = shared->q_1[0], q_1_y = shared->q_1[1], q_1_z = shared->q_1[2];
    /* (1) platform point from the reference point */
    const stewart_real q_x = STEWART_FMA(R_xz, p_z, STEWART_FMA(R_xy, p_y, R_xx*p_x));
    const stewart_real q_y = STEWART_FMA(R_yz, p_z, STEWART_FMA(R_yy, p_y, R_yx*p_x));
    const stewart_real q_z = STEWART_FMA(R_zz, p_z, STEWART_FMA(R_zy, p_y, R_zx*p_x));
    /* (1) reference point from base point, base frame */
    const stewart_real t_b_x = t_x - b_x;
    const stewart_real t_b_y = t_y - b_y;
    const stewart_real t_b_z = t_z - b_z;
    /* (1) leg vector */
    const stewart_real S_x = t_b_x + q_x;
    const stewart_real S_y = t_b_y + q_y;
    const stewart_real S_z = t_b_z + q_z;
    /* (10) component of the leg vector along the fixed axis, and normal to both */
    const stewart_real zeta = STEWART_FMA(S_z, k_z, STEWART_FMA(S_y, k_y, S_x*k_x));
    const stewart_real k_cross_S_x = STEWART_FMA(-S_y, k_z, S_z*k_y);
    const stewart_real k_cross_S_y = STEWART_FMA(-S_z, k_x, S_x*k_z);
    const stewart_real k_cross_S_z = STEWART_FMA(-S_x, k_y, S_y*k_x);
    const stewart_real rho2 = STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y, k_cross_S_y,
        k_cross_S_x*k_cross_S_x));
    /* (2) leg length, and distance of the tip from the fixed axis */
    const stewart_real L = STEWART_SQRT(STEWART_FMA(zeta, zeta, rho2));
    const stewart_real rho = STEWART_SQRT(rho2);
    const stewart_real inv_L = REAL(1)/L;
    /* (3) unit vector along the leg */
    const stewart_real s_x = S_x*inv_L;
    const stewart_real s_y = S_y*inv_L;
    const stewart_real s_z = S_z*inv_L;
    const stewart_real inv_rho = REAL(1)/rho;
    /* (10) second axis of the leg frame */
    const stewart_real y_x = inv_rho*k_cross_S_x;
    const stewart_real y_y = inv_rho*k_cross_S_y;
    const stewart_real y_z = inv_rho*k_cross_S_z;
    /* (10) k = (k1, 0, k3) in the leg frame */
    const stewart_real k1 = inv_L*zeta;
    const stewart_real k3 = inv_L*rho;
    /* (10) k1 / k3 */
    const stewart_real kappa = inv_rho*zeta;
    /* (4) velocity of the platform point */
    const stewart_real S_dot_x = STEWART_FMA(-omega_z, q_y, STEWART_FMA(omega_y, q_z, v_x));
    const stewart_real S_dot_y = STEWART_FMA(-omega_x, q_z, STEWART_FMA(omega_z, q_x, v_y));
    const stewart_real S_dot_z = STEWART_FMA(-omega_y, q_x, STEWART_FMA(omega_x, q_y, v_z));
    /* (7) acceleration of the platform point */
    const stewart_real S_ddot_x = STEWART_FMA(B_xz, q_z, STEWART_FMA(B_xy, q_y, STEWART_FMA(B_xx, q_x,
        a_x)));
    const stewart_real S_ddot_y = STEWART_FMA(B_yz, q_z, STEWART_FMA(B_yy, q_y, STEWART_FMA(B_yx, q_x,
        a_y)));
    const stewart_real S_ddot_z = STEWART_FMA(B_zz, q_z, STEWART_FMA(B_zy, q_y, STEWART_FMA(B_zx, q_x,
        a_z)));
    /* (5) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real L_dot = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
    /* (6) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real phi_dot = inv_rho*STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y, S_dot_x*y_x));
    const stewart_real theta_dot = inv_rho*STEWART_FMA(-S_dot_z, k_z, STEWART_FMA(-S_dot_y, k_y,
        STEWART_FMA(-S_dot_x, k_x, L_dot*k1)));
    /* L_dot / L */
    const stewart_real L_share = L_dot*inv_L;
    const stewart_real lean = kappa*theta_dot;
    const stewart_real theta_dot2 = theta_dot*theta_dot;
    const stewart_real phi_dot2 = phi_dot*phi_dot;
    const stewart_real two_phi_dot = REAL(2)*phi_dot;
    /* rho_dot / rho */
    const stewart_real rho_share = L_share + lean;
    const stewart_real k33 = k3*k3;
    /* (8) accelerations of the joint coordinates */
    const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y, STEWART_FMA(S_ddot_x,
        s_x, L*STEWART_FMA(k33, phi_dot2, theta_dot2))));
    /* (9) accelerations of the joint coordinates */
    const stewart_real theta_ddot = STEWART_FMA(-theta_dot, L_share + rho_share,
        inv_rho*STEWART_FMA(-S_ddot_z, k_z, STEWART_FMA(-S_ddot_y, k_y, STEWART_FMA(-S_ddot_x, k_x,
        L_ddot*k1))));
    const stewart_real phi_ddot = STEWART_FMA(-rho_share, two_phi_dot, inv_rho*STEWART_FMA(S_ddot_z, y_z,
        STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)));
    const stewart_real k13 = k1*k3;
    const stewart_real L_h2 = L*h2_x;
    const stewart_real a1 = dJ_zx + L_h2;
    const stewart_real a2 = STEWART_FMA(-L, h2_z, J2_xz);
    const stewart_real a3 = STEWART_FMA(-L, h_y, J_xy);
    /* (19) inertia of the joint coordinates */
    const stewart_real M_phi = STEWART_FMA(a2, k13, STEWART_FMA(a1, k33, J_xx));
    const stewart_real M_theta = J_yy + L_h2;
    const stewart_real M_mixed = STEWART_FMA(a3, k1, J_yz*k3);
    const stewart_real k3_h = h_y*k3;
    /* (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta */
    const stewart_real M_phi_theta = STEWART_FMA(a1, k13, a2*(STEWART_HALF - k33));
    const stewart_real M_phi_L = STEWART_FMA(-h_z, k13, h_x*k33);
    const stewart_real M_mixed_theta = STEWART_FMA(-a3, k3, J_yz*k1);
    const stewart_real c1 = L_dot*theta_dot;
    const stewart_real bend = c1;
    /* components of gravity along k x y and along y */
    const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
    const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
    /* components of the first moment along k and along -k x y */
    const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
    const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
    const stewart_real c2 = j_r*k3;
    const stewart_real c3 = c2*phi_dot;
    const stewart_real c4 = STEWART_FMA(j_r, k1, -k3_h);
    /* (20) generalized forces about y and about k */
    const stewart_real tau_y = STEWART_FMA(M_theta, theta_ddot, STEWART_FMA(M_mixed, phi_ddot,
        STEWART_FMA(bend, h2_x, STEWART_FMA(L_dot, c3, STEWART_FMA(-M_phi_theta, phi_dot2, STEWART_FMA(-C_s,
        STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x)), STEWART_FMA(C_us, theta_dot,
        STEWART_FMA(gamma_n, w_k, STEWART_FMA(g_k, w_n, L_ddot*h_z)))))))));
    const stewart_real tau_k = STEWART_FMA(M_mixed, theta_ddot, STEWART_FMA(M_phi, phi_ddot,
        STEWART_FMA((-bend)*h2_y, k1, STEWART_FMA(two_phi_dot, STEWART_FMA(M_phi_theta, theta_dot,
        L_dot*M_phi_L), STEWART_FMA(-c1, c2, STEWART_FMA(-gamma_y, w_n, STEWART_FMA(-gamma_n, w_y,
        STEWART_FMA(C_us, phi_dot, STEWART_FMA(M_mixed_theta, theta_dot2, STEWART_FMA(-C_s, STEWART_FMA(k_z,
        omega_z, STEWART_FMA(k_y, omega_y, k_x*omega_x)), L_ddot*c4))))))))));
    /* (21) K = Q_k k + Q_y y, with a component along s */
    const stewart_real Q_k = -inv_rho*tau_y;
    const stewart_real Q_y = inv_rho*tau_k;
    /* (21) force at the spherical joint, base frame */
    const stewart_real K_x = STEWART_FMA(Q_k, k_x, Q_y*y_x);
    const stewart_real K_y = STEWART_FMA(Q_k, k_y, Q_y*y_y);
    const stewart_real K_z = STEWART_FMA(Q_k, k_z, Q_y*y_z);
    /* (24) known part of the actuator force for this K */
    const stewart_real D = STEWART_FMA(-Q_k, k1, STEWART_FMA(h_z, theta_ddot, STEWART_FMA(c4, phi_ddot,
        STEWART_FMA(-c3, theta_dot, STEWART_FMA(-M_phi_L, phi_dot2, STEWART_FMA(L_ddot, m_r,
        STEWART_FMA(-h_x, theta_dot2, C_p*L_dot)))))));
    const stewart_real c5 = C_s*phi_dot;
    const stewart_real c6 = C_s*theta_dot;
    const stewart_real H_force_x = s_x;
    const stewart_real H_force_y = s_y;
    const stewart_real H_force_z = s_z;
    const stewart_real c_force_x = -K_x;
    const stewart_real c_force_y = -K_y;
    const stewart_real c_force_z = -K_z;
    /* platform point from platform point 1 */
    const stewart_real arm_x = q_x - q_1_x;
    const stewart_real arm_y = q_y - q_1_y;
    const stewart_real arm_z = q_z - q_1_z;
    /* part of c, moment rows, base frame */
    const stewart_real c_moment_x = STEWART_FMA(c6, y_x, c5*k_x);
    const stewart_real c_moment_y = STEWART_FMA(c6, y_y, c5*k_y);
    const stewart_real c_moment_z = STEWART_FMA(c6, y_z, c5*k_z);
    /* the leg's column of H, moment rows */
    const stewart_real H_moment_x = STEWART_FMA(-H_force_y, arm_z, H_force_z*arm_y);
    const stewart_real H_moment_y = STEWART_FMA(-H_force_z, arm_x, H_force_x*arm_z);
    const stewart_real H_moment_z = STEWART_FMA(-H_force_x, arm_y, H_force_y*arm_x);
    /* moment of the leg's part of c, force rows, about platform point 1 */
    const stewart_real arm_c_x = STEWART_FMA(-arm_z, c_force_y, arm_y*c_force_z);
    const stewart_real arm_c_y = STEWART_FMA(-arm_x, c_force_z, arm_z*c_force_x);
    const stewart_real arm_c_z = STEWART_FMA(-arm_y, c_force_x, arm_x*c_force_y);
    out->D = D;
    out->H_force[0] = H_force_x;
    out->H_force[1] = H_force_y;
    out->H_force[2] = H_force_z;
    out->c_force[0] = c_force_x;
    out->c_force[1] = c_force_y;
    out->c_force[2] = c_force_z;
    out->c_moment[0] = c_moment_x;
    out->c_moment[1] = c_moment_y;
    out->c_moment[2] = c_moment_z;
    out->H_moment[0] = H_moment_x;
    out->H_moment[1] = H_moment_y;
    out->H_moment[2] = H_moment_z;
    out->arm_c[0] = arm_c_x;
    out->arm_c[1] = arm_c_y;
    out->arm_c[2] = arm_c_z;
    out->L = L;
    out->k3 = k3;
    out->arm[0] = arm_x;
    out->arm[1] = arm_y;
    out->arm[2] = arm_z;
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
    out->reach = reach;
}

/* One leg in joint coordinates: D, its column of H and its part of c. */
static void leg_of_pose_near_singularity(
    const stewart_exact_drive_bounds_platform *platform, const stewart_exact_drive_bounds_leg *leg,
    const stewart_motions *at, const shared_terms *shared, leg_terms *out)
{
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = leg->k[0], k_y = leg->k[1], k_z = leg->k[2];
    const stewart_real C_p = leg->C_p;
    const stewart_real C_s = leg->C_s;
    const stewart_real m_r = leg->m_r;
    const stewart_real j_r = leg->j_r;
    const stewart_real h_x = leg->h[0], h_y = leg->h[1], h_z = leg->h[2];
    const stewart_real h2_x = leg->h2_x;
    const stewart_real h2_y = leg->h2_y;
    const stewart_real h2_z = leg->h2_z;
    const stewart_real w_x = leg->w[0], w_y = leg->w[1], w_z = leg->w[2];
    const stewart_real J_xx = leg->J[0], J_xy = leg->J[1], J_yy = leg->J[3], J_yz = leg->J[4];
    const stewart_real J2_xz = leg->J2_xz;
    const stewart_real dJ_zx = leg->dJ_zx;
    const stewart_real g_k = leg->g_k;
    const stewart_real g_x_k_x = leg->g_x_k[0], g_x_k_y = leg->g_x_k[1], g_x_k_z = leg->g_x_k[2];
    const stewart_real C_us = leg->C_us;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real B_xx = shared->B[0], B_xy = shared->B[1], B_xz = shared->B[2], B_yx = shared->B[3],
        B_yy = shared->B[4], B_yz = shared->B[5], B_zx = shared->B[6], B_zy = shared->B[7], B_zz = shared->B[8];
    const stewart_real g_x = platform->g[0], g_y = platform->g[1], g_z = platform->g[2];
    const stewart_real q_1_x = shared->q_1[0], q_1_y = shared->q_1[1], q_1_z = shared->q_1[2];
    /* (1) platform point from the reference point */
    const stewart_real q_x = STEWART_FMA(R_xz, p_z, STEWART_FMA(R_xy, p_y, R_xx*p_x));
    const stewart_real q_y = STEWART_FMA(R_yz, p_z, STEWART_FMA(R_yy, p_y, R_yx*p_x));
    const stewart_real q_z = STEWART_FMA(R_zz, p_z, STEWART_FMA(R_zy, p_y, R_zx*p_x));
    /* (1) reference point from base point, base frame */
    const stewart_real t_b_x = t_x - b_x;
    const stewart_real t_b_y = t_y - b_y;
    const stewart_real t_b_z = t_z - b_z;
    /* (1) leg vector */
    const stewart_real S_x = t_b_x + q_x;
    const stewart_real S_y = t_b_y + q_y;
    const stewart_real S_z = t_b_z + q_z;
    /* (10) component of the leg vector along the fixed axis, and normal to both */
    const stewart_real zeta = STEWART_FMA(S_z, k_z, STEWART_FMA(S_y, k_y, S_x*k_x));
    const stewart_real k_cross_S_x = STEWART_FMA(-S_y, k_z, S_z*k_y);
    const stewart_real k_cross_S_y = STEWART_FMA(-S_z, k_x, S_x*k_z);
    const stewart_real k_cross_S_z = STEWART_FMA(-S_x, k_y, S_y*k_x);
    /* (2) leg length, and distance of the tip from the fixed axis */
    const stewart_real L = STEWART_SQRT(STEWART_FMA(S_z, S_z, STEWART_FMA(S_y, S_y, S_x*S_x)));
    const stewart_real inv_L = REAL(1)/L;
    /* (3) unit vector along the leg */
    const stewart_real s_x = S_x*inv_L;
    const stewart_real s_y = S_y*inv_L;
    const stewart_real s_z = S_z*inv_L;
    /* (10) along the third axis of the leg */
    const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_S_y, s_z, k_cross_S_z*s_y);
    const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_S_z, s_x, k_cross_S_x*s_z);
    const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_S_x, s_y, k_cross_S_y*s_x);
    /* (10) leg length, and distance of the tip from the fixed axis */
    const stewart_real rho = STEWART_SQRT(STEWART_FMA(s_cross_normal_z, s_cross_normal_z,
        STEWART_FMA(s_cross_normal_y, s_cross_normal_y, s_cross_normal_x*s_cross_normal_x)));
    const stewart_real inv_rho = REAL(1)/rho;
    /* (10) third axis of the leg frame */
    const stewart_real z_x = inv_rho*s_cross_normal_x;
    const stewart_real z_y = inv_rho*s_cross_normal_y;
    const stewart_real z_z = inv_rho*s_cross_normal_z;
    /* (10) rotating axis of the universal joint */
    const stewart_real y_x = STEWART_FMA(-s_y, z_z, s_z*z_y);
    const stewart_real y_y = STEWART_FMA(-s_z, z_x, s_x*z_z);
    const stewart_real y_z = STEWART_FMA(-s_x, z_y, s_y*z_x);
    /* (10) k = (k1, 0, k3) in the leg frame */
    const stewart_real k1 = inv_L*zeta;
    const stewart_real k3 = inv_L*rho;
    /* (10) k1 / k3 */
    const stewart_real kappa = inv_rho*zeta;
    /* (4) velocity of the platform point */
    const stewart_real S_dot_x = STEWART_FMA(-omega_z, q_y, STEWART_FMA(omega_y, q_z, v_x));
    const stewart_real S_dot_y = STEWART_FMA(-omega_x, q_z, STEWART_FMA(omega_z, q_x, v_y));
    const stewart_real S_dot_z = STEWART_FMA(-omega_y, q_x, STEWART_FMA(omega_x, q_y, v_z));
    /* (7) acceleration of the platform point */
    const stewart_real S_ddot_x = STEWART_FMA(B_xz, q_z, STEWART_FMA(B_xy, q_y, STEWART_FMA(B_xx, q_x,
        a_x)));
    const stewart_real S_ddot_y = STEWART_FMA(B_yz, q_z, STEWART_FMA(B_yy, q_y, STEWART_FMA(B_yx, q_x,
        a_y)));
    const stewart_real S_ddot_z = STEWART_FMA(B_zz, q_z, STEWART_FMA(B_zy, q_y, STEWART_FMA(B_zx, q_x,
        a_z)));
    /* (5) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real L_dot = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
    /* (6) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real phi_dot = inv_rho*STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y, S_dot_x*y_x));
    const stewart_real theta_dot = -inv_L*STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y, S_dot_x*z_x));
    /* L_dot / L */
    const stewart_real L_share = L_dot*inv_L;
    const stewart_real lean = kappa*theta_dot;
    const stewart_real theta_dot2 = theta_dot*theta_dot;
    const stewart_real phi_dot2 = phi_dot*phi_dot;
    const stewart_real two_phi_dot = REAL(2)*phi_dot;
    const stewart_real k33 = k3*k3;
    /* (8) accelerations of the joint coordinates */
    const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y, STEWART_FMA(S_ddot_x,
        s_x, L*STEWART_FMA(k33, phi_dot2, theta_dot2))));
    /* (9) accelerations of the joint coordinates without the rotation of the leg frame about s */
    const stewart_real own_theta_ddot = STEWART_FMA((-REAL(2))*L_share, theta_dot,
        -inv_L*STEWART_FMA(S_ddot_z, z_z, STEWART_FMA(S_ddot_y, z_y, S_ddot_x*z_x)));
    const stewart_real own_phi_ddot = STEWART_FMA(-L_share, two_phi_dot, inv_rho*STEWART_FMA(S_ddot_z, y_z,
        STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)));
    const stewart_real c1 = k1*k3;
    /* (9) accelerations of the joint coordinates */
    const stewart_real theta_ddot = STEWART_FMA(c1, phi_dot2, own_theta_ddot);
    const stewart_real phi_ddot = STEWART_FMA(-lean, two_phi_dot, own_phi_ddot);
    const stewart_real k13 = c1;
    const stewart_real L_h2 = L*h2_x;
    const stewart_real a1 = dJ_zx + L_h2;
    const stewart_real c2 = L*h2_z;
    const stewart_real c3 = J2_xz - c2;
    const stewart_real a2 = c3;
    const stewart_real a3 = STEWART_FMA(-L, h_y, J_xy);
    /* (19) inertia of the joint coordinates */
    const stewart_real M_phi = STEWART_FMA(a2, k13, STEWART_FMA(a1, k33, J_xx));
    const stewart_real M_theta = J_yy + L_h2;
    const stewart_real M_mixed = STEWART_FMA(a3, k1, J_yz*k3);
    const stewart_real k3_h = h_y*k3;
    /* (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta */
    const stewart_real M_phi_L = STEWART_FMA(-h_z, k13, h_x*k33);
    const stewart_real M_mixed_theta = STEWART_FMA(-a3, k3, J_yz*k1);
    const stewart_real c4 = L_dot*theta_dot;
    const stewart_real bend = c4;
    /* components of gravity along k x y and along y */
    const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
    const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
    /* components of the first moment along k and along -k x y */
    const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
    const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
    const stewart_real c5 = j_r*k3;
    const stewart_real c6 = c5*phi_dot;
    const stewart_real c7 = STEWART_FMA(j_r, k1, -k3_h);
    /* (20) generalized forces about y and about k */
    const stewart_real tau_y = STEWART_FMA(M_mixed, phi_ddot, STEWART_FMA(M_theta, own_theta_ddot,
        STEWART_FMA(L_dot, c6, STEWART_FMA(-C_s, STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y,
        omega_x*y_x)), STEWART_FMA(gamma_n, w_k, STEWART_FMA(bend, h2_x, STEWART_FMA(C_us, theta_dot,
        STEWART_FMA(phi_dot2, STEWART_FMA(-c3, STEWART_HALF - k33, k13*(J_yy - dJ_zx)), STEWART_FMA(g_k,
        w_n, L_ddot*h_z)))))))));
    const stewart_real tau_k = STEWART_FMA(M_phi, own_phi_ddot, STEWART_FMA(M_mixed, theta_ddot,
        STEWART_FMA((-bend)*h2_y, k1, STEWART_FMA(two_phi_dot, STEWART_FMA(-theta_dot, STEWART_FMA(J_xx,
        kappa, STEWART_FMA(-STEWART_HALF, c2, STEWART_HALF*J2_xz)), L_dot*M_phi_L), STEWART_FMA(-gamma_y,
        w_n, STEWART_FMA(-gamma_n, w_y, STEWART_FMA(-c4, c5, STEWART_FMA(C_us, phi_dot,
        STEWART_FMA(M_mixed_theta, theta_dot2, STEWART_FMA(-C_s, STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y,
        omega_y, k_x*omega_x)), L_ddot*c7))))))))));
    /* (21) K = Q_y y + Q_z z */
    const stewart_real Q_y = inv_rho*tau_k;
    const stewart_real Q_z = -inv_L*tau_y;
    /* (21) force at the spherical joint, base frame */
    const stewart_real K_x = STEWART_FMA(Q_y, y_x, Q_z*z_x);
    const stewart_real K_y = STEWART_FMA(Q_y, y_y, Q_z*z_y);
    const stewart_real K_z = STEWART_FMA(Q_y, y_z, Q_z*z_z);
    /* (24) known part of the actuator force for this K */
    const stewart_real D = STEWART_FMA(c7, phi_ddot, STEWART_FMA(-c6, theta_dot, STEWART_FMA(h_z,
        theta_ddot, STEWART_FMA(-M_phi_L, phi_dot2, STEWART_FMA(L_ddot, m_r, STEWART_FMA(-h_x, theta_dot2,
        C_p*L_dot))))));
    const stewart_real c8 = C_s*phi_dot;
    const stewart_real c9 = C_s*theta_dot;
    const stewart_real H_force_x = s_x;
    const stewart_real H_force_y = s_y;
    const stewart_real H_force_z = s_z;
    const stewart_real c_force_x = -K_x;
    const stewart_real c_force_y = -K_y;
    const stewart_real c_force_z = -K_z;
    /* platform point from platform point 1 */
    const stewart_real arm_x = q_x - q_1_x;
    const stewart_real arm_y = q_y - q_1_y;
    const stewart_real arm_z = q_z - q_1_z;
    /* part of c, moment rows, base frame */
    const stewart_real c_moment_x = STEWART_FMA(c9, y_x, c8*k_x);
    const stewart_real c_moment_y = STEWART_FMA(c9, y_y, c8*k_y);
    const stewart_real c_moment_z = STEWART_FMA(c9, y_z, c8*k_z);
    /* the leg's column of H, moment rows */
    const stewart_real H_moment_x = STEWART_FMA(-H_force_y, arm_z, H_force_z*arm_y);
    const stewart_real H_moment_y = STEWART_FMA(-H_force_z, arm_x, H_force_x*arm_z);
    const stewart_real H_moment_z = STEWART_FMA(-H_force_x, arm_y, H_force_y*arm_x);
    /* moment of the leg's part of c, force rows, about platform point 1 */
    const stewart_real arm_c_x = STEWART_FMA(-arm_z, c_force_y, arm_y*c_force_z);
    const stewart_real arm_c_y = STEWART_FMA(-arm_x, c_force_z, arm_z*c_force_x);
    const stewart_real arm_c_z = STEWART_FMA(-arm_y, c_force_x, arm_x*c_force_y);
    out->D = D;
    out->H_force[0] = H_force_x;
    out->H_force[1] = H_force_y;
    out->H_force[2] = H_force_z;
    out->c_force[0] = c_force_x;
    out->c_force[1] = c_force_y;
    out->c_force[2] = c_force_z;
    out->c_moment[0] = c_moment_x;
    out->c_moment[1] = c_moment_y;
    out->c_moment[2] = c_moment_z;
    out->H_moment[0] = H_moment_x;
    out->H_moment[1] = H_moment_y;
    out->H_moment[2] = H_moment_z;
    out->arm_c[0] = arm_c_x;
    out->arm_c[1] = arm_c_y;
    out->arm_c[2] = arm_c_z;
    out->L = L;
    out->k3 = k3;
    out->arm[0] = arm_x;
    out->arm[1] = arm_y;
    out->arm[2] = arm_z;
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
    out->reach = reach;
}

/* Bounds the effect on a force if R is not exactly a rotation. The difference between R and the nearest
 * rotation is R (E / 2 - 3 E^2 / 8 + ...) with the symmetric matrix E = R^T R - 1. Therefore only the
 * symmetric part of R^T times the derivatives of the force has an effect. A rotation of R is no error. */
static stewart_real stretch_error(
    const stewart_real R[9], const stewart_real stretch[9], stewart_real R_err, const force_slopes *of,
    int force)
{
    int i, j, k;
    stewart_real total = REAL(0);
    stewart_real slopes = REAL(0);
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 3; ++j) {
            stewart_real sum = REAL(0);
            stewart_real doubt = REAL(0);
            for (k = 0; k < 9; k += 3) {
                const stewart_real one = R[k + i]*of->R_legs[k + j][force];
                const stewart_real other = R[k + j]*of->R_legs[k + i][force];
                sum = sum + (one + other);
                doubt = doubt + REAL(5)*STEWART_UNIT*(STEWART_FABS(one) + STEWART_FABS(other));
                doubt = doubt + STEWART_FABS(R[k + i])*of->R_legs_err[k + j][force];
                doubt = doubt + STEWART_FABS(R[k + j])*of->R_legs_err[k + i][force];
            }
            total = total + stretch[3*i + j]*(STEWART_FABS(sum) + doubt)/REAL(4);
            slopes = slopes + STEWART_FABS(of->R_legs[3*i + j][force]) + of->R_legs_err[3*i + j][force];
        }
    }
    return total + REAL(2)*R_err*R_err*slopes;
}

/* Bounds the rest of the error of x = Y c when the errors of H and c have been weighed by Y: adds it to
 * `error`. With E_H and e_c bounding these errors, and d the error of x in sizes, d <= b + G d, where b
 * = |Y| (|c - H x| + E_H |x| + e_c) and G = |1 - Y H| + |Y| E_H, and where G b <= beta b with beta < 1,
 * H is regular and d <= b / (1 - beta) (Rump, Verification methods, Acta Numerica 19 (2010), 10); the
 * rest is |Y| |c - H x| + G d. Where there is no such beta, it is infinite. Sums of seven terms round
 * seven times at most. */
static void solution_error(
    const platform_equations *of, const stewart_real x[6], stewart_real Y[6][6], stewart_real error[6])
{
    int i, j, k;
    stewart_real rest[6];
    stewart_real doubt[6];
    stewart_real b[6];
    stewart_real G[6][6];
    stewart_real worst = REAL(0);
    for (i = 0; i < 6; ++i) {
        stewart_real sum = of->c[i];
        stewart_real sizes = STEWART_FABS(of->c[i]);
        doubt[i] = of->c_err[i];
        for (j = 0; j < 6; ++j) {
            const stewart_real product = of->H[i][j]*x[j];
            sum = sum - product;
            sizes = sizes + STEWART_FABS(product);
            doubt[i] = doubt[i] + of->H_err[i][j]*STEWART_FABS(x[j]);
        }
        rest[i] = STEWART_FABS(sum) + REAL(7)*STEWART_UNIT*sizes + of->c_own[i];
    }
    for (i = 0; i < 6; ++i) {
        /* So that no entry is zero. */
        b[i] = REAL(4)/STEWART_MAX;
        for (j = 0; j < 6; ++j) {
            b[i] = b[i] + STEWART_FABS(Y[i][j])*(rest[j] + doubt[j]);
            error[i] = error[i] + STEWART_FABS(Y[i][j])*rest[j];
        }
    }
    for (i = 0; i < 6; ++i) {
        stewart_real grown = REAL(0);
        for (k = 0; k < 6; ++k) {
            stewart_real lack = i == k ? REAL(1) : REAL(0);
            stewart_real around = i == k ? REAL(1) : REAL(0);
            stewart_real carried = REAL(0);
            for (j = 0; j < 6; ++j) {
                const stewart_real term = Y[i][j]*of->H[j][k];
                lack = lack - term;
                around = around + STEWART_FABS(term);
                carried = carried + STEWART_FABS(Y[i][j])*of->H_err[j][k];
            }
            G[i][k] = STEWART_FABS(lack) + carried + REAL(7)*STEWART_UNIT*around;
            grown = grown + G[i][k]*b[k];
        }
        worst = grown/b[i] <= worst ? worst : grown/b[i];
    }
    for (i = 0; i < 6; ++i) {
        for (k = 0; k < 6; ++k) {
            error[i] = error[i] + G[i][k]*(b[k]/(REAL(1) - worst));
        }
        if (!(worst <= REAL(0.875))) {
            error[i] = STEWART_INFINITY;
        }
    }
}

/* Largest sum of a column in sizes. */
static stewart_real norm(stewart_real A[6][6])
{
    int i, j;
    stewart_real worst = REAL(0);
    for (j = 0; j < 6; ++j) {
        stewart_real sum = REAL(0);
        for (i = 0; i < 6; ++i) {
            sum = sum + STEWART_FABS(A[i][j]);
        }
        worst = sum > worst ? sum : worst;
    }
    return worst;
}

/* 1/(|H| |Y|), moments moved from platform point 1, q away, to the reference point, measured by
 * `length`. */
static stewart_real reciprocal_condition(
    stewart_real H[6][6], stewart_real Y[6][6], const stewart_real q[3], stewart_real length)
{
    int i;
    stewart_real A[6][6];
    stewart_real B[6][6];
    for (i = 0; i < 6; ++i) {
        A[0][i] = H[0][i];
        const stewart_real turned_0 = q[1]*H[2][i] - q[2]*H[1][i];
        A[3][i] = (H[3][i] + turned_0)/length;
        const stewart_real back_0 = Y[i][4]*q[2] - Y[i][5]*q[1];
        B[i][0] = Y[i][0] - back_0;
        B[i][3] = Y[i][3]*length;
    }
    for (i = 0; i < 6; ++i) {
        A[1][i] = H[1][i];
        const stewart_real turned_1 = q[2]*H[0][i] - q[0]*H[2][i];
        A[4][i] = (H[4][i] + turned_1)/length;
        const stewart_real back_1 = Y[i][5]*q[0] - Y[i][3]*q[2];
        B[i][1] = Y[i][1] - back_1;
        B[i][4] = Y[i][4]*length;
    }
    for (i = 0; i < 6; ++i) {
        A[2][i] = H[2][i];
        const stewart_real turned_2 = q[0]*H[1][i] - q[1]*H[0][i];
        A[5][i] = (H[5][i] + turned_2)/length;
        const stewart_real back_2 = Y[i][3]*q[1] - Y[i][4]*q[0];
        B[i][2] = Y[i][2] - back_2;
        B[i][5] = Y[i][5]*length;
    }
    return REAL(1)/norm(A)/norm(B);
}

/* Terms of one pose that are common to all legs, with their errors. R_err is the deviation of R from a
 * rotation. If `weighed` is not 0, adds the effects of the errors to the error of each force: largest
 * error times the derivative of the force. Also adds to the derivatives with respect to R. */
static void shared_errors(
    const stewart_exact_drive_bounds_platform *platform, const stewart_motions *at, stewart_real R_err,
    const force_rows *STEWART_RESTRICT rows, int weighed, force_slopes *STEWART_RESTRICT slopes,
    stewart_real *STEWART_RESTRICT error, shared_terms *out)
{
    int i;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real M_ext_x = at->M_ext[0], M_ext_y = at->M_ext[1], M_ext_z = at->M_ext[2];
    const stewart_real M_P = platform->M_P;
    const stewart_real M_P_err = platform->M_P_err;
    const stewart_real r_C_x = platform->r_C[0], r_C_y = platform->r_C[1], r_C_z = platform->r_C[2];
    const stewart_real r_C_x_err = platform->r_C_err[0], r_C_y_err = platform->r_C_err[1], r_C_z_err = platform->r_C_err[2];
    const stewart_real J_C_xx = platform->J_C[0], J_C_xy = platform->J_C[1], J_C_xz = platform->J_C[2],
        J_C_yy = platform->J_C[3], J_C_yz = platform->J_C[4], J_C_zz = platform->J_C[5];
    const stewart_real J_C_xx_err = platform->J_C_err[0], J_C_xy_err = platform->J_C_err[1], J_C_xz_err = platform->J_C_err[2],
        J_C_yy_err = platform->J_C_err[3], J_C_yz_err = platform->J_C_err[4], J_C_zz_err = platform->J_C_err[5];
    const stewart_real dJ_C_x = platform->dJ_C[0], dJ_C_y = platform->dJ_C[1], dJ_C_z = platform->dJ_C[2];
    const stewart_real dJ_C_x_err = platform->dJ_C_err[0], dJ_C_y_err = platform->dJ_C_err[1], dJ_C_z_err = platform->dJ_C_err[2];
    const stewart_real C_P = platform->C_P;
    const stewart_real C_P_err = platform->C_P_err;
    const stewart_real g_x = platform->g[0], g_y = platform->g[1], g_z = platform->g[2];
    const stewart_real p_1_x = platform->p_1[0], p_1_y = platform->p_1[1], p_1_z = platform->p_1[2];
    const stewart_real R_xx_max = STEWART_FABS(R_xx) + R_err;
    const stewart_real R_xy_max = STEWART_FABS(R_xy) + R_err;
    const stewart_real R_xz_max = STEWART_FABS(R_xz) + R_err;
    const stewart_real R_yx_max = STEWART_FABS(R_yx) + R_err;
    const stewart_real R_yy_max = STEWART_FABS(R_yy) + R_err;
    const stewart_real R_yz_max = STEWART_FABS(R_yz) + R_err;
    const stewart_real R_zx_max = STEWART_FABS(R_zx) + R_err;
    const stewart_real R_zy_max = STEWART_FABS(R_zy) + R_err;
    const stewart_real R_zz_max = STEWART_FABS(R_zz) + R_err;
    const stewart_real omega_x_max = STEWART_FABS(omega_x);
    const stewart_real omega_y_max = STEWART_FABS(omega_y);
    const stewart_real omega_z_max = STEWART_FABS(omega_z);
    const stewart_real alpha_x_max = STEWART_FABS(alpha_x);
    const stewart_real alpha_y_max = STEWART_FABS(alpha_y);
    const stewart_real alpha_z_max = STEWART_FABS(alpha_z);
    const stewart_real a_x_max = STEWART_FABS(a_x);
    const stewart_real a_y_max = STEWART_FABS(a_y);
    const stewart_real a_z_max = STEWART_FABS(a_z);
    const stewart_real F_ext_x_max = STEWART_FABS(F_ext_x);
    const stewart_real F_ext_y_max = STEWART_FABS(F_ext_y);
    const stewart_real F_ext_z_max = STEWART_FABS(F_ext_z);
    const stewart_real M_ext_x_max = STEWART_FABS(M_ext_x);
    const stewart_real M_ext_y_max = STEWART_FABS(M_ext_y);
    const stewart_real M_ext_z_max = STEWART_FABS(M_ext_z);
    const stewart_real M_P_max = STEWART_FABS(M_P) + M_P_err;
    const stewart_real r_C_x_max = STEWART_FABS(r_C_x) + r_C_x_err;
    const stewart_real r_C_y_max = STEWART_FABS(r_C_y) + r_C_y_err;
    const stewart_real r_C_z_max = STEWART_FABS(r_C_z) + r_C_z_err;
    const stewart_real J_C_xx_max = STEWART_FABS(J_C_xx) + J_C_xx_err;
    const stewart_real J_C_xy_max = STEWART_FABS(J_C_xy) + J_C_xy_err;
    const stewart_real J_C_xz_max = STEWART_FABS(J_C_xz) + J_C_xz_err;
    const stewart_real J_C_yy_max = STEWART_FABS(J_C_yy) + J_C_yy_err;
    const stewart_real J_C_yz_max = STEWART_FABS(J_C_yz) + J_C_yz_err;
    const stewart_real J_C_zz_max = STEWART_FABS(J_C_zz) + J_C_zz_err;
    const stewart_real dJ_C_x_max = STEWART_FABS(dJ_C_x) + dJ_C_x_err;
    const stewart_real dJ_C_y_max = STEWART_FABS(dJ_C_y) + dJ_C_y_err;
    const stewart_real dJ_C_z_max = STEWART_FABS(dJ_C_z) + dJ_C_z_err;
    const stewart_real C_P_max = STEWART_FABS(C_P) + C_P_err;
    const stewart_real g_x_max = STEWART_FABS(g_x);
    const stewart_real g_y_max = STEWART_FABS(g_y);
    const stewart_real g_z_max = STEWART_FABS(g_z);
    const stewart_real p_1_x_max = STEWART_FABS(p_1_x);
    const stewart_real p_1_y_max = STEWART_FABS(p_1_y);
    const stewart_real p_1_z_max = STEWART_FABS(p_1_z);
    /* products of omega */
    const stewart_real omega_xx = omega_x*omega_x;
    const stewart_real omega_xx_own = STEWART_UNIT*STEWART_FABS(omega_xx);
    const stewart_real omega_xx_err = omega_xx_own;
    const stewart_real omega_xy = omega_x*omega_y;
    const stewart_real omega_xy_own = STEWART_UNIT*STEWART_FABS(omega_xy);
    const stewart_real omega_xy_err = omega_xy_own;
    const stewart_real omega_xz = omega_x*omega_z;
    const stewart_real omega_xz_own = STEWART_UNIT*STEWART_FABS(omega_xz);
    const stewart_real omega_xz_err = omega_xz_own;
    const stewart_real omega_yy = omega_y*omega_y;
    const stewart_real omega_yy_own = STEWART_UNIT*STEWART_FABS(omega_yy);
    const stewart_real omega_yy_err = omega_yy_own;
    const stewart_real omega_yz = omega_y*omega_z;
    const stewart_real omega_yz_own = STEWART_UNIT*STEWART_FABS(omega_yz);
    const stewart_real omega_yz_err = omega_yz_own;
    const stewart_real omega_zz = omega_z*omega_z;
    const stewart_real omega_zz_own = STEWART_UNIT*STEWART_FABS(omega_zz);
    const stewart_real omega_zz_err = omega_zz_own;
    /* (7) S_ddot = B q + a */
    const stewart_real B_xx = -omega_yy - omega_zz;
    const stewart_real B_xx_own = STEWART_UNIT*STEWART_FABS(B_xx);
    const stewart_real B_xx_err = omega_yy_err + omega_zz_err + B_xx_own;
    const stewart_real B_xx_max = STEWART_FABS(B_xx) + B_xx_err;
    const stewart_real B_xy = omega_xy - alpha_z;
    const stewart_real B_xy_own = STEWART_UNIT*STEWART_FABS(B_xy);
    const stewart_real B_xy_err = omega_xy_err + B_xy_own;
    const stewart_real B_xy_max = STEWART_FABS(B_xy) + B_xy_err;
    const stewart_real B_xz = alpha_y + omega_xz;
    const stewart_real B_xz_own = STEWART_UNIT*STEWART_FABS(B_xz);
    const stewart_real B_xz_err = omega_xz_err + B_xz_own;
    const stewart_real B_xz_max = STEWART_FABS(B_xz) + B_xz_err;
    const stewart_real B_yx = alpha_z + omega_xy;
    const stewart_real B_yx_own = STEWART_UNIT*STEWART_FABS(B_yx);
    const stewart_real B_yx_err = omega_xy_err + B_yx_own;
    const stewart_real B_yx_max = STEWART_FABS(B_yx) + B_yx_err;
    const stewart_real B_yy = -omega_xx - omega_zz;
    const stewart_real B_yy_own = STEWART_UNIT*STEWART_FABS(B_yy);
    const stewart_real B_yy_err = omega_xx_err + omega_zz_err + B_yy_own;
    const stewart_real B_yy_max = STEWART_FABS(B_yy) + B_yy_err;
    const stewart_real B_yz = omega_yz - alpha_x;
    const stewart_real B_yz_own = STEWART_UNIT*STEWART_FABS(B_yz);
    const stewart_real B_yz_err = omega_yz_err + B_yz_own;
    const stewart_real B_yz_max = STEWART_FABS(B_yz) + B_yz_err;
    const stewart_real B_zx = omega_xz - alpha_y;
    const stewart_real B_zx_own = STEWART_UNIT*STEWART_FABS(B_zx);
    const stewart_real B_zx_err = omega_xz_err + B_zx_own;
    const stewart_real B_zx_max = STEWART_FABS(B_zx) + B_zx_err;
    const stewart_real B_zy = alpha_x + omega_yz;
    const stewart_real B_zy_own = STEWART_UNIT*STEWART_FABS(B_zy);
    const stewart_real B_zy_err = omega_yz_err + B_zy_own;
    const stewart_real B_zy_max = STEWART_FABS(B_zy) + B_zy_err;
    const stewart_real B_zz = -omega_xx - omega_yy;
    const stewart_real B_zz_own = STEWART_UNIT*STEWART_FABS(B_zz);
    const stewart_real B_zz_err = omega_xx_err + omega_yy_err + B_zz_own;
    const stewart_real B_zz_max = STEWART_FABS(B_zz) + B_zz_err;
    /* (30) center of mass from the reference point, base frame */
    const stewart_real R_C_x = R_xx*r_C_x + R_xy*r_C_y + R_xz*r_C_z;
    const stewart_real R_C_x_own = STEWART_UNIT*(R_xz_max*r_C_z_max + REAL(2)*R_xx_max*r_C_x_max + REAL(2)*R_xy_max*r_C_y_max
        + STEWART_FABS(R_C_x));
    const stewart_real R_C_x_err = R_xx_max*r_C_x_err + R_xy_max*r_C_y_err + R_xz_max*r_C_z_err + R_err*(r_C_x_max
        + r_C_y_max + r_C_z_max) + R_C_x_own;
    const stewart_real R_C_x_max = STEWART_FABS(R_C_x) + R_C_x_err;
    const stewart_real R_C_y = R_yx*r_C_x + R_yy*r_C_y + R_yz*r_C_z;
    const stewart_real R_C_y_own = STEWART_UNIT*(R_yz_max*r_C_z_max + REAL(2)*R_yx_max*r_C_x_max + REAL(2)*R_yy_max*r_C_y_max
        + STEWART_FABS(R_C_y));
    const stewart_real R_C_y_err = R_yx_max*r_C_x_err + R_yy_max*r_C_y_err + R_yz_max*r_C_z_err + R_err*(r_C_x_max
        + r_C_y_max + r_C_z_max) + R_C_y_own;
    const stewart_real R_C_y_max = STEWART_FABS(R_C_y) + R_C_y_err;
    const stewart_real R_C_z = R_zx*r_C_x + R_zy*r_C_y + R_zz*r_C_z;
    const stewart_real R_C_z_own = STEWART_UNIT*(R_zz_max*r_C_z_max + REAL(2)*R_zx_max*r_C_x_max + REAL(2)*R_zy_max*r_C_y_max
        + STEWART_FABS(R_C_z));
    const stewart_real R_C_z_err = R_zx_max*r_C_x_err + R_zy_max*r_C_y_err + R_zz_max*r_C_z_err + R_err*(r_C_x_max
        + r_C_y_max + r_C_z_max) + R_C_z_own;
    const stewart_real R_C_z_max = STEWART_FABS(R_C_z) + R_C_z_err;
    /* (33) M_P (g - a_C) */
    const stewart_real N_x = M_P*(g_x - a_x - B_xx*R_C_x - B_xy*R_C_y - B_xz*R_C_z);
    const stewart_real N_x_own = STEWART_UNIT*(M_P_max*(REAL(4)*a_x_max + REAL(4)*g_x_max + REAL(4)*B_xx_max*R_C_x_max
        + REAL(3)*B_xy_max*R_C_y_max + REAL(2)*B_xz_max*R_C_z_max) + STEWART_FABS(N_x));
    const stewart_real N_x_err = B_xx_err*M_P_max*R_C_x_max + B_xx_max*M_P_max*R_C_x_err + B_xy_err*M_P_max*R_C_y_max
        + B_xy_max*M_P_max*R_C_y_err + B_xz_err*M_P_max*R_C_z_max + B_xz_max*M_P_max*R_C_z_err + M_P_err*(a_x_max
        + g_x_max + B_xx_max*R_C_x_max + B_xy_max*R_C_y_max + B_xz_max*R_C_z_max) + N_x_own;
    const stewart_real N_x_max = STEWART_FABS(N_x) + N_x_err;
    const stewart_real N_y = M_P*(g_y - a_y - B_yx*R_C_x - B_yy*R_C_y - B_yz*R_C_z);
    const stewart_real N_y_own = STEWART_UNIT*(M_P_max*(REAL(4)*a_y_max + REAL(4)*g_y_max + REAL(4)*B_yx_max*R_C_x_max
        + REAL(3)*B_yy_max*R_C_y_max + REAL(2)*B_yz_max*R_C_z_max) + STEWART_FABS(N_y));
    const stewart_real N_y_err = B_yx_err*M_P_max*R_C_x_max + B_yx_max*M_P_max*R_C_x_err + B_yy_err*M_P_max*R_C_y_max
        + B_yy_max*M_P_max*R_C_y_err + B_yz_err*M_P_max*R_C_z_max + B_yz_max*M_P_max*R_C_z_err + M_P_err*(a_y_max
        + g_y_max + B_yx_max*R_C_x_max + B_yy_max*R_C_y_max + B_yz_max*R_C_z_max) + N_y_own;
    const stewart_real N_y_max = STEWART_FABS(N_y) + N_y_err;
    const stewart_real N_z = M_P*(g_z - a_z - B_zx*R_C_x - B_zy*R_C_y - B_zz*R_C_z);
    const stewart_real N_z_own = STEWART_UNIT*(M_P_max*(REAL(4)*a_z_max + REAL(4)*g_z_max + REAL(4)*B_zx_max*R_C_x_max
        + REAL(3)*B_zy_max*R_C_y_max + REAL(2)*B_zz_max*R_C_z_max) + STEWART_FABS(N_z));
    const stewart_real N_z_err = B_zx_err*M_P_max*R_C_x_max + B_zx_max*M_P_max*R_C_x_err + B_zy_err*M_P_max*R_C_y_max
        + B_zy_max*M_P_max*R_C_y_err + B_zz_err*M_P_max*R_C_z_max + B_zz_max*M_P_max*R_C_z_err + M_P_err*(a_z_max
        + g_z_max + B_zx_max*R_C_x_max + B_zy_max*R_C_y_max + B_zz_max*R_C_z_max) + N_z_own;
    const stewart_real N_z_max = STEWART_FABS(N_z) + N_z_err;
    /* angular velocity, platform frame */
    const stewart_real omega_P_x = R_xx*omega_x + R_yx*omega_y + R_zx*omega_z;
    const stewart_real omega_P_x_own = STEWART_UNIT*(R_zx_max*omega_z_max + REAL(2)*R_xx_max*omega_x_max + REAL(2)*R_yx_max*omega_y_max
        + STEWART_FABS(omega_P_x));
    const stewart_real omega_P_x_err = R_err*(omega_x_max + omega_y_max + omega_z_max) + omega_P_x_own;
    const stewart_real omega_P_x_max = STEWART_FABS(omega_P_x) + omega_P_x_err;
    const stewart_real omega_P_y = R_xy*omega_x + R_yy*omega_y + R_zy*omega_z;
    const stewart_real omega_P_y_own = STEWART_UNIT*(R_zy_max*omega_z_max + REAL(2)*R_xy_max*omega_x_max + REAL(2)*R_yy_max*omega_y_max
        + STEWART_FABS(omega_P_y));
    const stewart_real omega_P_y_err = R_err*(omega_x_max + omega_y_max + omega_z_max) + omega_P_y_own;
    const stewart_real omega_P_y_max = STEWART_FABS(omega_P_y) + omega_P_y_err;
    const stewart_real omega_P_z = R_xz*omega_x + R_yz*omega_y + R_zz*omega_z;
    const stewart_real omega_P_z_own = STEWART_UNIT*(R_zz_max*omega_z_max + REAL(2)*R_xz_max*omega_x_max + REAL(2)*R_yz_max*omega_y_max
        + STEWART_FABS(omega_P_z));
    const stewart_real omega_P_z_err = R_err*(omega_x_max + omega_y_max + omega_z_max) + omega_P_z_own;
    const stewart_real omega_P_z_max = STEWART_FABS(omega_P_z) + omega_P_z_err;
    /* angular acceleration, platform frame */
    const stewart_real alpha_P_x = R_xx*alpha_x + R_yx*alpha_y + R_zx*alpha_z;
    const stewart_real alpha_P_x_own = STEWART_UNIT*(R_zx_max*alpha_z_max + REAL(2)*R_xx_max*alpha_x_max + REAL(2)*R_yx_max*alpha_y_max
        + STEWART_FABS(alpha_P_x));
    const stewart_real alpha_P_x_err = R_err*(alpha_x_max + alpha_y_max + alpha_z_max) + alpha_P_x_own;
    const stewart_real alpha_P_x_max = STEWART_FABS(alpha_P_x) + alpha_P_x_err;
    const stewart_real alpha_P_y = R_xy*alpha_x + R_yy*alpha_y + R_zy*alpha_z;
    const stewart_real alpha_P_y_own = STEWART_UNIT*(R_zy_max*alpha_z_max + REAL(2)*R_xy_max*alpha_x_max + REAL(2)*R_yy_max*alpha_y_max
        + STEWART_FABS(alpha_P_y));
    const stewart_real alpha_P_y_err = R_err*(alpha_x_max + alpha_y_max + alpha_z_max) + alpha_P_y_own;
    const stewart_real alpha_P_y_max = STEWART_FABS(alpha_P_y) + alpha_P_y_err;
    const stewart_real alpha_P_z = R_xz*alpha_x + R_yz*alpha_y + R_zz*alpha_z;
    const stewart_real alpha_P_z_own = STEWART_UNIT*(R_zz_max*alpha_z_max + REAL(2)*R_xz_max*alpha_x_max + REAL(2)*R_yz_max*alpha_y_max
        + STEWART_FABS(alpha_P_z));
    const stewart_real alpha_P_z_err = R_err*(alpha_x_max + alpha_y_max + alpha_z_max) + alpha_P_z_own;
    const stewart_real alpha_P_z_max = STEWART_FABS(alpha_P_z) + alpha_P_z_err;
    const stewart_real P_xy = omega_P_x*omega_P_y;
    const stewart_real P_xy_own = STEWART_UNIT*STEWART_FABS(P_xy);
    const stewart_real P_xy_err = omega_P_x_err*omega_P_y_max + omega_P_x_max*omega_P_y_err + P_xy_own;
    const stewart_real P_xy_max = STEWART_FABS(P_xy) + P_xy_err;
    const stewart_real P_xz = omega_P_x*omega_P_z;
    const stewart_real P_xz_own = STEWART_UNIT*STEWART_FABS(P_xz);
    const stewart_real P_xz_err = omega_P_x_err*omega_P_z_max + omega_P_x_max*omega_P_z_err + P_xz_own;
    const stewart_real P_xz_max = STEWART_FABS(P_xz) + P_xz_err;
    const stewart_real P_yz = omega_P_y*omega_P_z;
    const stewart_real P_yz_own = STEWART_UNIT*STEWART_FABS(P_yz);
    const stewart_real P_yz_err = omega_P_y_err*omega_P_z_max + omega_P_y_max*omega_P_z_err + P_yz_own;
    const stewart_real P_yz_max = STEWART_FABS(P_yz) + P_yz_err;
    const stewart_real P_xx = omega_P_x*omega_P_x;
    const stewart_real P_xx_own = STEWART_UNIT*STEWART_FABS(P_xx);
    const stewart_real P_xx_err = REAL(2)*omega_P_x_err*omega_P_x_max + P_xx_own;
    const stewart_real P_xx_max = STEWART_FABS(P_xx) + P_xx_err;
    const stewart_real P_yy = omega_P_y*omega_P_y;
    const stewart_real P_yy_own = STEWART_UNIT*STEWART_FABS(P_yy);
    const stewart_real P_yy_err = REAL(2)*omega_P_y_err*omega_P_y_max + P_yy_own;
    const stewart_real P_yy_max = STEWART_FABS(P_yy) + P_yy_err;
    const stewart_real P_zz = omega_P_z*omega_P_z;
    const stewart_real P_zz_own = STEWART_UNIT*STEWART_FABS(P_zz);
    const stewart_real P_zz_err = REAL(2)*omega_P_z_err*omega_P_z_max + P_zz_own;
    const stewart_real P_zz_max = STEWART_FABS(P_zz) + P_zz_err;
    /* (34) external moment less I alpha + omega x I omega, platform frame */
    const stewart_real M_P_load_x = M_ext_x - J_C_yz*(P_yy - P_zz) - J_C_xx*alpha_P_x - P_yz*dJ_C_x + J_C_xy*(P_xz
        - alpha_P_y) - J_C_xz*(alpha_P_z + P_xy);
    const stewart_real M_P_load_x_own = STEWART_UNIT*(REAL(4)*M_ext_x_max + REAL(4)*J_C_xx_max*alpha_P_x_max
        + REAL(3)*P_yz_max*dJ_C_x_max + REAL(3)*J_C_xy_max*(P_xz_max + alpha_P_y_max) + REAL(2)*J_C_xz_max*(P_xy_max
        + alpha_P_z_max) + REAL(6)*J_C_yz_max*(P_yy_max + P_zz_max) + STEWART_FABS(M_P_load_x));
    const stewart_real M_P_load_x_err = J_C_xx_err*alpha_P_x_max + J_C_xx_max*alpha_P_x_err + J_C_xy_max*P_xz_err
        + J_C_xy_max*alpha_P_y_err + J_C_xz_max*P_xy_err + J_C_xz_max*alpha_P_z_err + J_C_yz_max*P_yy_err + J_C_yz_max*P_zz_err
        + P_yz_err*dJ_C_x_max + P_yz_max*dJ_C_x_err + J_C_xy_err*(P_xz_max + alpha_P_y_max) + J_C_xz_err*(P_xy_max
        + alpha_P_z_max) + J_C_yz_err*(P_yy_max + P_zz_max) + M_P_load_x_own;
    const stewart_real M_P_load_x_max = STEWART_FABS(M_P_load_x) + M_P_load_x_err;
    const stewart_real M_P_load_y = M_ext_y - J_C_xz*(P_zz - P_xx) - J_C_yy*alpha_P_y - P_xz*dJ_C_y + J_C_yz*(P_xy
        - alpha_P_z) - J_C_xy*(alpha_P_x + P_yz);
    const stewart_real M_P_load_y_own = STEWART_UNIT*(REAL(4)*M_ext_y_max + REAL(4)*J_C_yy_max*alpha_P_y_max
        + REAL(3)*P_xz_max*dJ_C_y_max + REAL(2)*J_C_xy_max*(P_yz_max + alpha_P_x_max) + REAL(6)*J_C_xz_max*(P_xx_max
        + P_zz_max) + REAL(3)*J_C_yz_max*(P_xy_max + alpha_P_z_max) + STEWART_FABS(M_P_load_y));
    const stewart_real M_P_load_y_err = J_C_xy_max*P_yz_err + J_C_xy_max*alpha_P_x_err + J_C_xz_max*P_xx_err
        + J_C_xz_max*P_zz_err + J_C_yy_err*alpha_P_y_max + J_C_yy_max*alpha_P_y_err + J_C_yz_max*P_xy_err + J_C_yz_max*alpha_P_z_err
        + P_xz_err*dJ_C_y_max + P_xz_max*dJ_C_y_err + J_C_xy_err*(P_yz_max + alpha_P_x_max) + J_C_xz_err*(P_xx_max
        + P_zz_max) + J_C_yz_err*(P_xy_max + alpha_P_z_max) + M_P_load_y_own;
    const stewart_real M_P_load_y_max = STEWART_FABS(M_P_load_y) + M_P_load_y_err;
    const stewart_real M_P_load_z = M_ext_z - J_C_xy*(P_xx - P_yy) - J_C_zz*alpha_P_z - P_xy*dJ_C_z + J_C_xz*(P_yz
        - alpha_P_x) - J_C_yz*(alpha_P_y + P_xz);
    const stewart_real M_P_load_z_own = STEWART_UNIT*(REAL(4)*M_ext_z_max + REAL(4)*J_C_zz_max*alpha_P_z_max
        + REAL(3)*P_xy_max*dJ_C_z_max + REAL(6)*J_C_xy_max*(P_xx_max + P_yy_max) + REAL(3)*J_C_xz_max*(P_yz_max
        + alpha_P_x_max) + REAL(2)*J_C_yz_max*(P_xz_max + alpha_P_y_max) + STEWART_FABS(M_P_load_z));
    const stewart_real M_P_load_z_err = J_C_xy_max*P_xx_err + J_C_xy_max*P_yy_err + J_C_xz_max*P_yz_err + J_C_xz_max*alpha_P_x_err
        + J_C_yz_max*P_xz_err + J_C_yz_max*alpha_P_y_err + J_C_zz_err*alpha_P_z_max + J_C_zz_max*alpha_P_z_err
        + P_xy_err*dJ_C_z_max + P_xy_max*dJ_C_z_err + J_C_xy_err*(P_xx_max + P_yy_max) + J_C_xz_err*(P_yz_max
        + alpha_P_x_max) + J_C_yz_err*(P_xz_max + alpha_P_y_max) + M_P_load_z_own;
    const stewart_real M_P_load_z_max = STEWART_FABS(M_P_load_z) + M_P_load_z_err;
    const stewart_real c_force_x = N_x + F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz;
    const stewart_real c_force_x_own = STEWART_UNIT*(F_ext_z_max*R_xz_max + REAL(2)*N_x_max + REAL(3)*F_ext_x_max*R_xx_max
        + REAL(2)*F_ext_y_max*R_xy_max + STEWART_FABS(c_force_x));
    const stewart_real c_force_x_err = N_x_err + R_err*(F_ext_x_max + F_ext_y_max + F_ext_z_max) + c_force_x_own;
    const stewart_real c_force_x_max = STEWART_FABS(c_force_x) + c_force_x_err;
    const stewart_real c_force_y = N_y + F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz;
    const stewart_real c_force_y_own = STEWART_UNIT*(F_ext_z_max*R_yz_max + REAL(2)*N_y_max + REAL(3)*F_ext_x_max*R_yx_max
        + REAL(2)*F_ext_y_max*R_yy_max + STEWART_FABS(c_force_y));
    const stewart_real c_force_y_err = N_y_err + R_err*(F_ext_x_max + F_ext_y_max + F_ext_z_max) + c_force_y_own;
    const stewart_real c_force_y_max = STEWART_FABS(c_force_y) + c_force_y_err;
    const stewart_real c_force_z = N_z + F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz;
    const stewart_real c_force_z_own = STEWART_UNIT*(F_ext_z_max*R_zz_max + REAL(2)*N_z_max + REAL(3)*F_ext_x_max*R_zx_max
        + REAL(2)*F_ext_y_max*R_zy_max + STEWART_FABS(c_force_z));
    const stewart_real c_force_z_err = N_z_err + R_err*(F_ext_x_max + F_ext_y_max + F_ext_z_max) + c_force_z_own;
    const stewart_real c_force_z_max = STEWART_FABS(c_force_z) + c_force_z_err;
    const stewart_real c_moment_x = M_P_load_x*R_xx + M_P_load_y*R_xy + M_P_load_z*R_xz + N_z*R_C_y - C_P*omega_x
        - N_y*R_C_z;
    const stewart_real c_moment_x_own = STEWART_UNIT*(N_y_max*R_C_z_max + REAL(2)*C_P_max*omega_x_max + REAL(5)*M_P_load_x_max*R_xx_max
        + REAL(5)*M_P_load_y_max*R_xy_max + REAL(4)*M_P_load_z_max*R_xz_max + REAL(3)*N_z_max*R_C_y_max + STEWART_FABS(c_moment_x));
    const stewart_real c_moment_x_err = C_P_err*omega_x_max + M_P_load_x_err*R_xx_max + M_P_load_y_err*R_xy_max
        + M_P_load_z_err*R_xz_max + N_y_err*R_C_z_max + N_y_max*R_C_z_err + N_z_err*R_C_y_max + N_z_max*R_C_y_err
        + R_err*(M_P_load_x_max + M_P_load_y_max + M_P_load_z_max) + c_moment_x_own;
    const stewart_real c_moment_x_max = STEWART_FABS(c_moment_x) + c_moment_x_err;
    const stewart_real c_moment_y = M_P_load_x*R_yx + M_P_load_y*R_yy + M_P_load_z*R_yz + N_x*R_C_z - C_P*omega_y
        - N_z*R_C_x;
    const stewart_real c_moment_y_own = STEWART_UNIT*(N_z_max*R_C_x_max + REAL(2)*C_P_max*omega_y_max + REAL(5)*M_P_load_x_max*R_yx_max
        + REAL(5)*M_P_load_y_max*R_yy_max + REAL(4)*M_P_load_z_max*R_yz_max + REAL(3)*N_x_max*R_C_z_max + STEWART_FABS(c_moment_y));
    const stewart_real c_moment_y_err = C_P_err*omega_y_max + M_P_load_x_err*R_yx_max + M_P_load_y_err*R_yy_max
        + M_P_load_z_err*R_yz_max + N_x_err*R_C_z_max + N_x_max*R_C_z_err + N_z_err*R_C_x_max + N_z_max*R_C_x_err
        + R_err*(M_P_load_x_max + M_P_load_y_max + M_P_load_z_max) + c_moment_y_own;
    const stewart_real c_moment_y_max = STEWART_FABS(c_moment_y) + c_moment_y_err;
    const stewart_real c_moment_z = M_P_load_x*R_zx + M_P_load_y*R_zy + M_P_load_z*R_zz + N_y*R_C_x - C_P*omega_z
        - N_x*R_C_y;
    const stewart_real c_moment_z_own = STEWART_UNIT*(N_x_max*R_C_y_max + REAL(2)*C_P_max*omega_z_max + REAL(5)*M_P_load_x_max*R_zx_max
        + REAL(5)*M_P_load_y_max*R_zy_max + REAL(4)*M_P_load_z_max*R_zz_max + REAL(3)*N_y_max*R_C_x_max + STEWART_FABS(c_moment_z));
    const stewart_real c_moment_z_err = C_P_err*omega_z_max + M_P_load_x_err*R_zx_max + M_P_load_y_err*R_zy_max
        + M_P_load_z_err*R_zz_max + N_x_err*R_C_y_max + N_x_max*R_C_y_err + N_y_err*R_C_x_max + N_y_max*R_C_x_err
        + R_err*(M_P_load_x_max + M_P_load_y_max + M_P_load_z_max) + c_moment_z_own;
    const stewart_real c_moment_z_max = STEWART_FABS(c_moment_z) + c_moment_z_err;
    /* (1) platform point 1 from the reference point, base frame */
    const stewart_real q_1_x = R_xx*p_1_x + R_xy*p_1_y + R_xz*p_1_z;
    const stewart_real q_1_x_own = STEWART_UNIT*(R_xz_max*p_1_z_max + REAL(2)*R_xx_max*p_1_x_max + REAL(2)*R_xy_max*p_1_y_max
        + STEWART_FABS(q_1_x));
    const stewart_real q_1_x_err = R_err*(p_1_x_max + p_1_y_max + p_1_z_max) + q_1_x_own;
    const stewart_real q_1_x_max = STEWART_FABS(q_1_x) + q_1_x_err;
    const stewart_real q_1_y = R_yx*p_1_x + R_yy*p_1_y + R_yz*p_1_z;
    const stewart_real q_1_y_own = STEWART_UNIT*(R_yz_max*p_1_z_max + REAL(2)*R_yx_max*p_1_x_max + REAL(2)*R_yy_max*p_1_y_max
        + STEWART_FABS(q_1_y));
    const stewart_real q_1_y_err = R_err*(p_1_x_max + p_1_y_max + p_1_z_max) + q_1_y_own;
    const stewart_real q_1_y_max = STEWART_FABS(q_1_y) + q_1_y_err;
    const stewart_real q_1_z = R_zx*p_1_x + R_zy*p_1_y + R_zz*p_1_z;
    const stewart_real q_1_z_own = STEWART_UNIT*(R_zz_max*p_1_z_max + REAL(2)*R_zx_max*p_1_x_max + REAL(2)*R_zy_max*p_1_y_max
        + STEWART_FABS(q_1_z));
    const stewart_real q_1_z_err = R_err*(p_1_x_max + p_1_y_max + p_1_z_max) + q_1_z_own;
    const stewart_real q_1_z_max = STEWART_FABS(q_1_z) + q_1_z_err;
    /* the platform's part of c, moment rows, about platform point 1 */
    const stewart_real c_tip_x = c_moment_x + c_force_y*q_1_z - c_force_z*q_1_y;
    const stewart_real c_tip_x_own = STEWART_UNIT*(c_moment_x_max + c_force_z_max*q_1_y_max + REAL(2)*c_force_y_max*q_1_z_max
        + STEWART_FABS(c_tip_x));
    const stewart_real c_tip_x_err = c_moment_x_err + c_force_y_err*q_1_z_max + c_force_y_max*q_1_z_err + c_force_z_err*q_1_y_max
        + c_force_z_max*q_1_y_err + c_tip_x_own;
    const stewart_real c_tip_y = c_moment_y + c_force_z*q_1_x - c_force_x*q_1_z;
    const stewart_real c_tip_y_own = STEWART_UNIT*(c_moment_y_max + c_force_x_max*q_1_z_max + REAL(2)*c_force_z_max*q_1_x_max
        + STEWART_FABS(c_tip_y));
    const stewart_real c_tip_y_err = c_moment_y_err + c_force_x_err*q_1_z_max + c_force_x_max*q_1_z_err + c_force_z_err*q_1_x_max
        + c_force_z_max*q_1_x_err + c_tip_y_own;
    const stewart_real c_tip_z = c_moment_z + c_force_x*q_1_y - c_force_y*q_1_x;
    const stewart_real c_tip_z_own = STEWART_UNIT*(c_moment_z_max + c_force_y_max*q_1_x_max + REAL(2)*c_force_x_max*q_1_y_max
        + STEWART_FABS(c_tip_z));
    const stewart_real c_tip_z_err = c_moment_z_err + c_force_x_err*q_1_y_max + c_force_x_max*q_1_y_err + c_force_y_err*q_1_x_max
        + c_force_y_max*q_1_x_err + c_tip_z_own;
    out->B[0] = B_xx;
    out->B_err[0] = B_xx_err;
    out->B[1] = B_xy;
    out->B_err[1] = B_xy_err;
    out->B[2] = B_xz;
    out->B_err[2] = B_xz_err;
    out->B[3] = B_yx;
    out->B_err[3] = B_yx_err;
    out->B[4] = B_yy;
    out->B_err[4] = B_yy_err;
    out->B[5] = B_yz;
    out->B_err[5] = B_yz_err;
    out->B[6] = B_zx;
    out->B_err[6] = B_zx_err;
    out->B[7] = B_zy;
    out->B_err[7] = B_zy_err;
    out->B[8] = B_zz;
    out->B_err[8] = B_zz_err;
    out->c_force[0] = c_force_x;
    out->c_force_err[0] = c_force_x_err;
    out->c_force[1] = c_force_y;
    out->c_force_err[1] = c_force_y_err;
    out->c_force[2] = c_force_z;
    out->c_force_err[2] = c_force_z_err;
    out->c_moment[0] = c_moment_x;
    out->c_moment_err[0] = c_moment_x_err;
    out->c_moment[1] = c_moment_y;
    out->c_moment_err[1] = c_moment_y_err;
    out->c_moment[2] = c_moment_z;
    out->c_moment_err[2] = c_moment_z_err;
    out->c_tip[0] = c_tip_x;
    out->c_tip_err[0] = c_tip_x_err;
    out->c_tip[1] = c_tip_y;
    out->c_tip_err[1] = c_tip_y_err;
    out->c_tip[2] = c_tip_z;
    out->c_tip_err[2] = c_tip_z_err;
    out->q_1[0] = q_1_x;
    out->q_1_err[0] = q_1_x_err;
    out->q_1[1] = q_1_y;
    out->q_1_err[1] = q_1_y_err;
    out->q_1[2] = q_1_z;
    out->q_1_err[2] = q_1_z_err;
    if (weighed != 0) {
        for (i = 0; i < LANES; ++i) {
            const stewart_real Y_force_x = rows->Y_force[0][i], Y_force_y = rows->Y_force[1][i], Y_force_z = rows->Y_force[2][i];
            const stewart_real Y_moment_x = rows->Y_moment[0][i], Y_moment_y = rows->Y_moment[1][i],
                Y_moment_z = rows->Y_moment[2][i];
            const stewart_real R_legs_xx = slopes->R_legs[0][i], R_legs_xy = slopes->R_legs[1][i], R_legs_xz = slopes->R_legs[2][i],
                R_legs_yx = slopes->R_legs[3][i], R_legs_yy = slopes->R_legs[4][i], R_legs_yz = slopes->R_legs[5][i],
                R_legs_zx = slopes->R_legs[6][i], R_legs_zy = slopes->R_legs[7][i], R_legs_zz = slopes->R_legs[8][i];
            const stewart_real R_legs_xx_err = slopes->R_legs_err[0][i], R_legs_xy_err = slopes->R_legs_err[1][i],
                R_legs_xz_err = slopes->R_legs_err[2][i], R_legs_yx_err = slopes->R_legs_err[3][i],
                R_legs_yy_err = slopes->R_legs_err[4][i], R_legs_yz_err = slopes->R_legs_err[5][i],
                R_legs_zx_err = slopes->R_legs_err[6][i], R_legs_zy_err = slopes->R_legs_err[7][i],
                R_legs_zz_err = slopes->R_legs_err[8][i];
            const stewart_real B_legs_xx = slopes->B_legs[0][i], B_legs_xy = slopes->B_legs[1][i], B_legs_xz = slopes->B_legs[2][i],
                B_legs_yx = slopes->B_legs[3][i], B_legs_yy = slopes->B_legs[4][i], B_legs_yz = slopes->B_legs[5][i],
                B_legs_zx = slopes->B_legs[6][i], B_legs_zy = slopes->B_legs[7][i], B_legs_zz = slopes->B_legs[8][i];
            const stewart_real B_legs_xx_err = slopes->B_legs_err[0][i], B_legs_xy_err = slopes->B_legs_err[1][i],
                B_legs_xz_err = slopes->B_legs_err[2][i], B_legs_yx_err = slopes->B_legs_err[3][i],
                B_legs_yy_err = slopes->B_legs_err[4][i], B_legs_yz_err = slopes->B_legs_err[5][i],
                B_legs_zx_err = slopes->B_legs_err[6][i], B_legs_zy_err = slopes->B_legs_err[7][i],
                B_legs_zz_err = slopes->B_legs_err[8][i];
            const stewart_real q_1_legs_x = slopes->q_1_legs[0][i], q_1_legs_y = slopes->q_1_legs[1][i],
                q_1_legs_z = slopes->q_1_legs[2][i];
            const stewart_real q_1_legs_x_err = slopes->q_1_legs_err[0][i], q_1_legs_y_err = slopes->q_1_legs_err[1][i],
                q_1_legs_z_err = slopes->q_1_legs_err[2][i];
            const stewart_real Y_force_x_max = STEWART_FABS(Y_force_x);
            const stewart_real Y_force_y_max = STEWART_FABS(Y_force_y);
            const stewart_real Y_force_z_max = STEWART_FABS(Y_force_z);
            const stewart_real Y_moment_x_max = STEWART_FABS(Y_moment_x);
            const stewart_real Y_moment_y_max = STEWART_FABS(Y_moment_y);
            const stewart_real Y_moment_z_max = STEWART_FABS(Y_moment_z);
            const stewart_real R_legs_xx_max = STEWART_FABS(R_legs_xx) + R_legs_xx_err;
            const stewart_real R_legs_xy_max = STEWART_FABS(R_legs_xy) + R_legs_xy_err;
            const stewart_real R_legs_xz_max = STEWART_FABS(R_legs_xz) + R_legs_xz_err;
            const stewart_real R_legs_yx_max = STEWART_FABS(R_legs_yx) + R_legs_yx_err;
            const stewart_real R_legs_yy_max = STEWART_FABS(R_legs_yy) + R_legs_yy_err;
            const stewart_real R_legs_yz_max = STEWART_FABS(R_legs_yz) + R_legs_yz_err;
            const stewart_real R_legs_zx_max = STEWART_FABS(R_legs_zx) + R_legs_zx_err;
            const stewart_real R_legs_zy_max = STEWART_FABS(R_legs_zy) + R_legs_zy_err;
            const stewart_real R_legs_zz_max = STEWART_FABS(R_legs_zz) + R_legs_zz_err;
            const stewart_real q_1_legs_x_max = STEWART_FABS(q_1_legs_x) + q_1_legs_x_err;
            const stewart_real q_1_legs_y_max = STEWART_FABS(q_1_legs_y) + q_1_legs_y_err;
            const stewart_real q_1_legs_z_max = STEWART_FABS(q_1_legs_z) + q_1_legs_z_err;
            const stewart_real q_1_z_bar = q_1_legs_z + Y_moment_y*c_force_x - Y_moment_x*c_force_y;
            const stewart_real q_1_z_bar_err = q_1_legs_z_err + Y_moment_x_max*c_force_y_err + Y_moment_y_max*c_force_x_err
                + STEWART_UNIT*(q_1_legs_z_max + Y_moment_x_max*c_force_y_max + REAL(2)*Y_moment_y_max*c_force_x_max
                + STEWART_FABS(q_1_z_bar));
            const stewart_real q_1_z_bar_max = STEWART_FABS(q_1_z_bar) + q_1_z_bar_err;
            const stewart_real q_1_y_bar = q_1_legs_y + Y_moment_x*c_force_z - Y_moment_z*c_force_x;
            const stewart_real q_1_y_bar_err = q_1_legs_y_err + Y_moment_x_max*c_force_z_err + Y_moment_z_max*c_force_x_err
                + STEWART_UNIT*(q_1_legs_y_max + Y_moment_z_max*c_force_x_max + REAL(2)*Y_moment_x_max*c_force_z_max
                + STEWART_FABS(q_1_y_bar));
            const stewart_real q_1_y_bar_max = STEWART_FABS(q_1_y_bar) + q_1_y_bar_err;
            const stewart_real q_1_x_bar = q_1_legs_x + Y_moment_z*c_force_y - Y_moment_y*c_force_z;
            const stewart_real q_1_x_bar_err = q_1_legs_x_err + Y_moment_y_max*c_force_z_err + Y_moment_z_max*c_force_y_err
                + STEWART_UNIT*(q_1_legs_x_max + Y_moment_y_max*c_force_z_max + REAL(2)*Y_moment_z_max*c_force_y_max
                + STEWART_FABS(q_1_x_bar));
            const stewart_real q_1_x_bar_max = STEWART_FABS(q_1_x_bar) + q_1_x_bar_err;
            const stewart_real c_force_z_bar = Y_moment_x*q_1_y - Y_force_z - Y_moment_y*q_1_x;
            const stewart_real c_force_z_bar_err = Y_moment_x_max*q_1_y_err + Y_moment_y_max*q_1_x_err + STEWART_UNIT*(Y_force_z_max
                + Y_moment_y_max*q_1_x_max + REAL(2)*Y_moment_x_max*q_1_y_max + STEWART_FABS(c_force_z_bar));
            const stewart_real c_force_z_bar_max = STEWART_FABS(c_force_z_bar) + c_force_z_bar_err;
            const stewart_real c_force_y_bar = Y_moment_z*q_1_x - Y_force_y - Y_moment_x*q_1_z;
            const stewart_real c_force_y_bar_err = Y_moment_x_max*q_1_z_err + Y_moment_z_max*q_1_x_err + STEWART_UNIT*(Y_force_y_max
                + Y_moment_x_max*q_1_z_max + REAL(2)*Y_moment_z_max*q_1_x_max + STEWART_FABS(c_force_y_bar));
            const stewart_real c_force_y_bar_max = STEWART_FABS(c_force_y_bar) + c_force_y_bar_err;
            const stewart_real c_force_x_bar = Y_moment_y*q_1_z - Y_force_x - Y_moment_z*q_1_y;
            const stewart_real c_force_x_bar_err = Y_moment_y_max*q_1_z_err + Y_moment_z_max*q_1_y_err + STEWART_UNIT*(Y_force_x_max
                + Y_moment_z_max*q_1_y_max + REAL(2)*Y_moment_y_max*q_1_z_max + STEWART_FABS(c_force_x_bar));
            const stewart_real c_force_x_bar_max = STEWART_FABS(c_force_x_bar) + c_force_x_bar_err;
            const stewart_real M_P_load_z_bar = -R_xz*Y_moment_x - R_yz*Y_moment_y - R_zz*Y_moment_z;
            const stewart_real M_P_load_z_bar_err = R_err*(Y_moment_x_max + Y_moment_y_max + Y_moment_z_max)
                + STEWART_UNIT*(R_zz_max*Y_moment_z_max + REAL(2)*R_xz_max*Y_moment_x_max + REAL(2)*R_yz_max*Y_moment_y_max
                + STEWART_FABS(M_P_load_z_bar));
            const stewart_real M_P_load_z_bar_max = STEWART_FABS(M_P_load_z_bar) + M_P_load_z_bar_err;
            const stewart_real M_P_load_y_bar = -R_xy*Y_moment_x - R_yy*Y_moment_y - R_zy*Y_moment_z;
            const stewart_real M_P_load_y_bar_err = R_err*(Y_moment_x_max + Y_moment_y_max + Y_moment_z_max)
                + STEWART_UNIT*(R_zy_max*Y_moment_z_max + REAL(2)*R_xy_max*Y_moment_x_max + REAL(2)*R_yy_max*Y_moment_y_max
                + STEWART_FABS(M_P_load_y_bar));
            const stewart_real M_P_load_y_bar_max = STEWART_FABS(M_P_load_y_bar) + M_P_load_y_bar_err;
            const stewart_real M_P_load_x_bar = -R_xx*Y_moment_x - R_yx*Y_moment_y - R_zx*Y_moment_z;
            const stewart_real M_P_load_x_bar_err = R_err*(Y_moment_x_max + Y_moment_y_max + Y_moment_z_max)
                + STEWART_UNIT*(R_zx_max*Y_moment_z_max + REAL(2)*R_xx_max*Y_moment_x_max + REAL(2)*R_yx_max*Y_moment_y_max
                + STEWART_FABS(M_P_load_x_bar));
            const stewart_real M_P_load_x_bar_max = STEWART_FABS(M_P_load_x_bar) + M_P_load_x_bar_err;
            const stewart_real c1 = J_C_xz*M_P_load_y_bar;
            const stewart_real c1_err = J_C_xz_err*M_P_load_y_bar_max + J_C_xz_max*M_P_load_y_bar_err + STEWART_UNIT*STEWART_FABS(c1);
            const stewart_real c2 = -J_C_yz*M_P_load_x_bar;
            const stewart_real c2_err = J_C_yz_err*M_P_load_x_bar_max + J_C_yz_max*M_P_load_x_bar_err + STEWART_UNIT*STEWART_FABS(c2);
            const stewart_real P_zz_bar = -c1 - c2;
            const stewart_real P_zz_bar_err = c1_err + c2_err + STEWART_UNIT*STEWART_FABS(P_zz_bar);
            const stewart_real P_zz_bar_max = STEWART_FABS(P_zz_bar) + P_zz_bar_err;
            const stewart_real c3 = J_C_xy*M_P_load_z_bar;
            const stewart_real c3_err = J_C_xy_err*M_P_load_z_bar_max + J_C_xy_max*M_P_load_z_bar_err + STEWART_UNIT*STEWART_FABS(c3);
            const stewart_real P_yy_bar = c3 + c2;
            const stewart_real P_yy_bar_err = c2_err + c3_err + STEWART_UNIT*STEWART_FABS(P_yy_bar);
            const stewart_real P_yy_bar_max = STEWART_FABS(P_yy_bar) + P_yy_bar_err;
            const stewart_real P_xx_bar = c1 - c3;
            const stewart_real P_xx_bar_err = c1_err + c3_err + STEWART_UNIT*STEWART_FABS(P_xx_bar);
            const stewart_real P_xx_bar_max = STEWART_FABS(P_xx_bar) + P_xx_bar_err;
            const stewart_real c4 = J_C_xy*M_P_load_y_bar;
            const stewart_real c4_err = J_C_xy_err*M_P_load_y_bar_max + J_C_xy_max*M_P_load_y_bar_err + STEWART_UNIT*STEWART_FABS(c4);
            const stewart_real c4_max = STEWART_FABS(c4) + c4_err;
            const stewart_real c5 = J_C_xz*M_P_load_z_bar;
            const stewart_real c5_err = J_C_xz_err*M_P_load_z_bar_max + J_C_xz_max*M_P_load_z_bar_err + STEWART_UNIT*STEWART_FABS(c5);
            const stewart_real c5_max = STEWART_FABS(c5) + c5_err;
            const stewart_real P_yz_bar = c5 - M_P_load_x_bar*dJ_C_x - c4;
            const stewart_real P_yz_bar_err = c4_err + c5_err + M_P_load_x_bar_err*dJ_C_x_max + M_P_load_x_bar_max*dJ_C_x_err
                + STEWART_UNIT*(c5_max + REAL(2)*M_P_load_x_bar_max*dJ_C_x_max + STEWART_FABS(P_yz_bar));
            const stewart_real P_yz_bar_max = STEWART_FABS(P_yz_bar) + P_yz_bar_err;
            const stewart_real c6 = J_C_yz*M_P_load_z_bar;
            const stewart_real c6_err = J_C_yz_err*M_P_load_z_bar_max + J_C_yz_max*M_P_load_z_bar_err + STEWART_UNIT*STEWART_FABS(c6);
            const stewart_real c6_max = STEWART_FABS(c6) + c6_err;
            const stewart_real c7 = J_C_xy*M_P_load_x_bar;
            const stewart_real c7_err = J_C_xy_err*M_P_load_x_bar_max + J_C_xy_max*M_P_load_x_bar_err + STEWART_UNIT*STEWART_FABS(c7);
            const stewart_real c7_max = STEWART_FABS(c7) + c7_err;
            const stewart_real P_xz_bar = c7 - M_P_load_y_bar*dJ_C_y - c6;
            const stewart_real P_xz_bar_err = c6_err + c7_err + M_P_load_y_bar_err*dJ_C_y_max + M_P_load_y_bar_max*dJ_C_y_err
                + STEWART_UNIT*(c7_max + REAL(2)*M_P_load_y_bar_max*dJ_C_y_max + STEWART_FABS(P_xz_bar));
            const stewart_real P_xz_bar_max = STEWART_FABS(P_xz_bar) + P_xz_bar_err;
            const stewart_real c8 = J_C_xz*M_P_load_x_bar;
            const stewart_real c8_err = J_C_xz_err*M_P_load_x_bar_max + J_C_xz_max*M_P_load_x_bar_err + STEWART_UNIT*STEWART_FABS(c8);
            const stewart_real c8_max = STEWART_FABS(c8) + c8_err;
            const stewart_real c9 = J_C_yz*M_P_load_y_bar;
            const stewart_real c9_err = J_C_yz_err*M_P_load_y_bar_max + J_C_yz_max*M_P_load_y_bar_err + STEWART_UNIT*STEWART_FABS(c9);
            const stewart_real c9_max = STEWART_FABS(c9) + c9_err;
            const stewart_real P_xy_bar = c9 - M_P_load_z_bar*dJ_C_z - c8;
            const stewart_real P_xy_bar_err = c8_err + c9_err + M_P_load_z_bar_err*dJ_C_z_max + M_P_load_z_bar_max*dJ_C_z_err
                + STEWART_UNIT*(c9_max + REAL(2)*M_P_load_z_bar_max*dJ_C_z_max + STEWART_FABS(P_xy_bar));
            const stewart_real P_xy_bar_max = STEWART_FABS(P_xy_bar) + P_xy_bar_err;
            const stewart_real alpha_P_z_bar = -J_C_zz*M_P_load_z_bar - c8 - c9;
            const stewart_real alpha_P_z_bar_err = c8_err + c9_err + J_C_zz_err*M_P_load_z_bar_max + J_C_zz_max*M_P_load_z_bar_err
                + STEWART_UNIT*(c8_max + REAL(2)*J_C_zz_max*M_P_load_z_bar_max + STEWART_FABS(alpha_P_z_bar));
            const stewart_real alpha_P_z_bar_max = STEWART_FABS(alpha_P_z_bar) + alpha_P_z_bar_err;
            const stewart_real alpha_P_y_bar = -J_C_yy*M_P_load_y_bar - c6 - c7;
            const stewart_real alpha_P_y_bar_err = c6_err + c7_err + J_C_yy_err*M_P_load_y_bar_max + J_C_yy_max*M_P_load_y_bar_err
                + STEWART_UNIT*(c6_max + REAL(2)*J_C_yy_max*M_P_load_y_bar_max + STEWART_FABS(alpha_P_y_bar));
            const stewart_real alpha_P_y_bar_max = STEWART_FABS(alpha_P_y_bar) + alpha_P_y_bar_err;
            const stewart_real alpha_P_x_bar = -J_C_xx*M_P_load_x_bar - c4 - c5;
            const stewart_real alpha_P_x_bar_err = c4_err + c5_err + J_C_xx_err*M_P_load_x_bar_max + J_C_xx_max*M_P_load_x_bar_err
                + STEWART_UNIT*(c4_max + REAL(2)*J_C_xx_max*M_P_load_x_bar_max + STEWART_FABS(alpha_P_x_bar));
            const stewart_real alpha_P_x_bar_max = STEWART_FABS(alpha_P_x_bar) + alpha_P_x_bar_err;
            const stewart_real omega_P_z_bar = P_xz_bar*omega_P_x + P_yz_bar*omega_P_y + REAL(2)*P_zz_bar*omega_P_z;
            const stewart_real omega_P_z_bar_err = P_xz_bar_err*omega_P_x_max + P_xz_bar_max*omega_P_x_err + P_yz_bar_err*omega_P_y_max
                + P_yz_bar_max*omega_P_y_err + REAL(2)*P_zz_bar_err*omega_P_z_max + REAL(2)*P_zz_bar_max*omega_P_z_err
                + STEWART_UNIT*(REAL(2)*(P_xz_bar_max*omega_P_x_max + P_yz_bar_max*omega_P_y_max + P_zz_bar_max*omega_P_z_max)
                + STEWART_FABS(omega_P_z_bar));
            const stewart_real omega_P_z_bar_max = STEWART_FABS(omega_P_z_bar) + omega_P_z_bar_err;
            const stewart_real omega_P_y_bar = P_xy_bar*omega_P_x + REAL(2)*P_yy_bar*omega_P_y + P_yz_bar*omega_P_z;
            const stewart_real omega_P_y_bar_err = P_xy_bar_err*omega_P_x_max + P_xy_bar_max*omega_P_x_err + P_yz_bar_err*omega_P_z_max
                + P_yz_bar_max*omega_P_z_err + REAL(2)*P_yy_bar_err*omega_P_y_max + REAL(2)*P_yy_bar_max*omega_P_y_err
                + STEWART_UNIT*(P_yz_bar_max*omega_P_z_max + REAL(2)*P_xy_bar_max*omega_P_x_max + REAL(4)*P_yy_bar_max*omega_P_y_max
                + STEWART_FABS(omega_P_y_bar));
            const stewart_real omega_P_y_bar_max = STEWART_FABS(omega_P_y_bar) + omega_P_y_bar_err;
            const stewart_real omega_P_x_bar = REAL(2)*P_xx_bar*omega_P_x + P_xy_bar*omega_P_y + P_xz_bar*omega_P_z;
            const stewart_real omega_P_x_bar_err = P_xy_bar_err*omega_P_y_max + P_xy_bar_max*omega_P_y_err + P_xz_bar_err*omega_P_z_max
                + P_xz_bar_max*omega_P_z_err + REAL(2)*P_xx_bar_err*omega_P_x_max + REAL(2)*P_xx_bar_max*omega_P_x_err
                + STEWART_UNIT*(P_xz_bar_max*omega_P_z_max + REAL(4)*P_xx_bar_max*omega_P_x_max + REAL(2)*P_xy_bar_max*omega_P_y_max
                + STEWART_FABS(omega_P_x_bar));
            const stewart_real omega_P_x_bar_max = STEWART_FABS(omega_P_x_bar) + omega_P_x_bar_err;
            const stewart_real N_z_bar = R_C_x*Y_moment_y - R_C_y*Y_moment_x + c_force_z_bar;
            const stewart_real N_z_bar_err = c_force_z_bar_err + R_C_x_err*Y_moment_y_max + R_C_y_err*Y_moment_x_max
                + STEWART_UNIT*(REAL(2)*(R_C_x_max*Y_moment_y_max + R_C_y_max*Y_moment_x_max) + STEWART_FABS(N_z_bar));
            const stewart_real N_z_bar_max = STEWART_FABS(N_z_bar) + N_z_bar_err;
            const stewart_real N_y_bar = R_C_z*Y_moment_x - R_C_x*Y_moment_z + c_force_y_bar;
            const stewart_real N_y_bar_err = c_force_y_bar_err + R_C_x_err*Y_moment_z_max + R_C_z_err*Y_moment_x_max
                + STEWART_UNIT*(REAL(2)*(R_C_x_max*Y_moment_z_max + R_C_z_max*Y_moment_x_max) + STEWART_FABS(N_y_bar));
            const stewart_real N_y_bar_max = STEWART_FABS(N_y_bar) + N_y_bar_err;
            const stewart_real N_x_bar = R_C_y*Y_moment_z - R_C_z*Y_moment_y + c_force_x_bar;
            const stewart_real N_x_bar_err = c_force_x_bar_err + R_C_y_err*Y_moment_z_max + R_C_z_err*Y_moment_y_max
                + STEWART_UNIT*(REAL(2)*(R_C_y_max*Y_moment_z_max + R_C_z_max*Y_moment_y_max) + STEWART_FABS(N_x_bar));
            const stewart_real N_x_bar_max = STEWART_FABS(N_x_bar) + N_x_bar_err;
            const stewart_real c10 = M_P*N_x_bar;
            const stewart_real c10_err = M_P_err*N_x_bar_max + M_P_max*N_x_bar_err + STEWART_UNIT*STEWART_FABS(c10);
            const stewart_real c10_max = STEWART_FABS(c10) + c10_err;
            const stewart_real c11 = M_P*N_y_bar;
            const stewart_real c11_err = M_P_err*N_y_bar_max + M_P_max*N_y_bar_err + STEWART_UNIT*STEWART_FABS(c11);
            const stewart_real c11_max = STEWART_FABS(c11) + c11_err;
            const stewart_real c12 = M_P*N_z_bar;
            const stewart_real c12_err = M_P_err*N_z_bar_max + M_P_max*N_z_bar_err + STEWART_UNIT*STEWART_FABS(c12);
            const stewart_real c12_max = STEWART_FABS(c12) + c12_err;
            const stewart_real R_C_z_bar = N_y*Y_moment_x - N_x*Y_moment_y - B_xz*c10 - B_yz*c11 - B_zz*c12;
            const stewart_real R_C_z_bar_err = B_xz_err*c10_max + B_xz_max*c10_err + B_yz_err*c11_max + B_yz_max*c11_err
                + B_zz_err*c12_max + B_zz_max*c12_err + N_x_err*Y_moment_y_max + N_y_err*Y_moment_x_max + STEWART_UNIT*(B_zz_max*c12_max
                + REAL(3)*B_xz_max*c10_max + REAL(2)*B_yz_max*c11_max + REAL(4)*N_x_max*Y_moment_y_max + REAL(4)*N_y_max*Y_moment_x_max
                + STEWART_FABS(R_C_z_bar));
            const stewart_real R_C_z_bar_max = STEWART_FABS(R_C_z_bar) + R_C_z_bar_err;
            const stewart_real R_C_y_bar = N_x*Y_moment_z - N_z*Y_moment_x - B_xy*c10 - B_yy*c11 - B_zy*c12;
            const stewart_real R_C_y_bar_err = B_xy_err*c10_max + B_xy_max*c10_err + B_yy_err*c11_max + B_yy_max*c11_err
                + B_zy_err*c12_max + B_zy_max*c12_err + N_x_err*Y_moment_z_max + N_z_err*Y_moment_x_max + STEWART_UNIT*(B_zy_max*c12_max
                + REAL(3)*B_xy_max*c10_max + REAL(2)*B_yy_max*c11_max + REAL(4)*N_x_max*Y_moment_z_max + REAL(4)*N_z_max*Y_moment_x_max
                + STEWART_FABS(R_C_y_bar));
            const stewart_real R_C_y_bar_max = STEWART_FABS(R_C_y_bar) + R_C_y_bar_err;
            const stewart_real R_C_x_bar = N_z*Y_moment_y - N_y*Y_moment_z - B_xx*c10 - B_yx*c11 - B_zx*c12;
            const stewart_real R_C_x_bar_err = B_xx_err*c10_max + B_xx_max*c10_err + B_yx_err*c11_max + B_yx_max*c11_err
                + B_zx_err*c12_max + B_zx_max*c12_err + N_y_err*Y_moment_z_max + N_z_err*Y_moment_y_max + STEWART_UNIT*(B_zx_max*c12_max
                + REAL(3)*B_xx_max*c10_max + REAL(2)*B_yx_max*c11_max + REAL(4)*N_y_max*Y_moment_z_max + REAL(4)*N_z_max*Y_moment_y_max
                + STEWART_FABS(R_C_x_bar));
            const stewart_real R_C_x_bar_max = STEWART_FABS(R_C_x_bar) + R_C_x_bar_err;
            const stewart_real B_zz_bar = B_legs_zz - R_C_z*c12;
            const stewart_real B_zz_bar_err = B_legs_zz_err + R_C_z_err*c12_max + R_C_z_max*c12_err + STEWART_UNIT*(R_C_z_max*c12_max
                + STEWART_FABS(B_zz_bar));
            const stewart_real B_zz_bar_max = STEWART_FABS(B_zz_bar) + B_zz_bar_err;
            const stewart_real B_zy_bar = B_legs_zy - R_C_y*c12;
            const stewart_real B_zy_bar_err = B_legs_zy_err + R_C_y_err*c12_max + R_C_y_max*c12_err + STEWART_UNIT*(R_C_y_max*c12_max
                + STEWART_FABS(B_zy_bar));
            const stewart_real B_zy_bar_max = STEWART_FABS(B_zy_bar) + B_zy_bar_err;
            const stewart_real B_zx_bar = B_legs_zx - R_C_x*c12;
            const stewart_real B_zx_bar_err = B_legs_zx_err + R_C_x_err*c12_max + R_C_x_max*c12_err + STEWART_UNIT*(R_C_x_max*c12_max
                + STEWART_FABS(B_zx_bar));
            const stewart_real B_zx_bar_max = STEWART_FABS(B_zx_bar) + B_zx_bar_err;
            const stewart_real B_yz_bar = B_legs_yz - R_C_z*c11;
            const stewart_real B_yz_bar_err = B_legs_yz_err + R_C_z_err*c11_max + R_C_z_max*c11_err + STEWART_UNIT*(R_C_z_max*c11_max
                + STEWART_FABS(B_yz_bar));
            const stewart_real B_yz_bar_max = STEWART_FABS(B_yz_bar) + B_yz_bar_err;
            const stewart_real B_yy_bar = B_legs_yy - R_C_y*c11;
            const stewart_real B_yy_bar_err = B_legs_yy_err + R_C_y_err*c11_max + R_C_y_max*c11_err + STEWART_UNIT*(R_C_y_max*c11_max
                + STEWART_FABS(B_yy_bar));
            const stewart_real B_yy_bar_max = STEWART_FABS(B_yy_bar) + B_yy_bar_err;
            const stewart_real B_yx_bar = B_legs_yx - R_C_x*c11;
            const stewart_real B_yx_bar_err = B_legs_yx_err + R_C_x_err*c11_max + R_C_x_max*c11_err + STEWART_UNIT*(R_C_x_max*c11_max
                + STEWART_FABS(B_yx_bar));
            const stewart_real B_yx_bar_max = STEWART_FABS(B_yx_bar) + B_yx_bar_err;
            const stewart_real B_xz_bar = B_legs_xz - R_C_z*c10;
            const stewart_real B_xz_bar_err = B_legs_xz_err + R_C_z_err*c10_max + R_C_z_max*c10_err + STEWART_UNIT*(R_C_z_max*c10_max
                + STEWART_FABS(B_xz_bar));
            const stewart_real B_xz_bar_max = STEWART_FABS(B_xz_bar) + B_xz_bar_err;
            const stewart_real B_xy_bar = B_legs_xy - R_C_y*c10;
            const stewart_real B_xy_bar_err = B_legs_xy_err + R_C_y_err*c10_max + R_C_y_max*c10_err + STEWART_UNIT*(R_C_y_max*c10_max
                + STEWART_FABS(B_xy_bar));
            const stewart_real B_xy_bar_max = STEWART_FABS(B_xy_bar) + B_xy_bar_err;
            const stewart_real B_xx_bar = B_legs_xx - R_C_x*c10;
            const stewart_real B_xx_bar_err = B_legs_xx_err + R_C_x_err*c10_max + R_C_x_max*c10_err + STEWART_UNIT*(R_C_x_max*c10_max
                + STEWART_FABS(B_xx_bar));
            const stewart_real B_xx_bar_max = STEWART_FABS(B_xx_bar) + B_xx_bar_err;
            const stewart_real omega_zz_bar = -B_xx_bar - B_yy_bar;
            const stewart_real omega_zz_bar_err = B_xx_bar_err + B_yy_bar_err + STEWART_UNIT*STEWART_FABS(omega_zz_bar);
            const stewart_real omega_zz_bar_max = STEWART_FABS(omega_zz_bar) + omega_zz_bar_err;
            const stewart_real omega_yz_bar = B_yz_bar + B_zy_bar;
            const stewart_real omega_yz_bar_err = B_yz_bar_err + B_zy_bar_err + STEWART_UNIT*STEWART_FABS(omega_yz_bar);
            const stewart_real omega_yz_bar_max = STEWART_FABS(omega_yz_bar) + omega_yz_bar_err;
            const stewart_real omega_yy_bar = -B_xx_bar - B_zz_bar;
            const stewart_real omega_yy_bar_err = B_xx_bar_err + B_zz_bar_err + STEWART_UNIT*STEWART_FABS(omega_yy_bar);
            const stewart_real omega_yy_bar_max = STEWART_FABS(omega_yy_bar) + omega_yy_bar_err;
            const stewart_real omega_xz_bar = B_xz_bar + B_zx_bar;
            const stewart_real omega_xz_bar_err = B_xz_bar_err + B_zx_bar_err + STEWART_UNIT*STEWART_FABS(omega_xz_bar);
            const stewart_real omega_xz_bar_max = STEWART_FABS(omega_xz_bar) + omega_xz_bar_err;
            const stewart_real omega_xy_bar = B_xy_bar + B_yx_bar;
            const stewart_real omega_xy_bar_err = B_xy_bar_err + B_yx_bar_err + STEWART_UNIT*STEWART_FABS(omega_xy_bar);
            const stewart_real omega_xy_bar_max = STEWART_FABS(omega_xy_bar) + omega_xy_bar_err;
            const stewart_real omega_xx_bar = -B_yy_bar - B_zz_bar;
            const stewart_real omega_xx_bar_err = B_yy_bar_err + B_zz_bar_err + STEWART_UNIT*STEWART_FABS(omega_xx_bar);
            const stewart_real omega_xx_bar_max = STEWART_FABS(omega_xx_bar) + omega_xx_bar_err;
            const stewart_real R_xx_bar = R_legs_xx - M_P_load_x*Y_moment_x + p_1_x*q_1_x_bar + F_ext_x*c_force_x_bar
                + alpha_P_x_bar*alpha_x + R_C_x_bar*r_C_x + omega_P_x_bar*omega_x;
            const stewart_real R_xx_bar_err = R_legs_xx_err + F_ext_x_max*c_force_x_bar_err + M_P_load_x_err*Y_moment_x_max
                + R_C_x_bar_err*r_C_x_max + R_C_x_bar_max*r_C_x_err + alpha_P_x_bar_err*alpha_x_max + omega_P_x_bar_err*omega_x_max
                + p_1_x_max*q_1_x_bar_err + STEWART_UNIT*(REAL(5)*R_legs_xx_max + omega_P_x_bar_max*omega_x_max
                + REAL(4)*F_ext_x_max*c_force_x_bar_max + REAL(6)*M_P_load_x_max*Y_moment_x_max + REAL(2)*R_C_x_bar_max*r_C_x_max
                + REAL(3)*alpha_P_x_bar_max*alpha_x_max + REAL(5)*p_1_x_max*q_1_x_bar_max + STEWART_FABS(R_xx_bar));
            const stewart_real R_xy_bar = R_legs_xy - M_P_load_y*Y_moment_x + p_1_y*q_1_x_bar + F_ext_y*c_force_x_bar
                + alpha_P_y_bar*alpha_x + R_C_x_bar*r_C_y + omega_P_y_bar*omega_x;
            const stewart_real R_xy_bar_err = R_legs_xy_err + F_ext_y_max*c_force_x_bar_err + M_P_load_y_err*Y_moment_x_max
                + R_C_x_bar_err*r_C_y_max + R_C_x_bar_max*r_C_y_err + alpha_P_y_bar_err*alpha_x_max + omega_P_y_bar_err*omega_x_max
                + p_1_y_max*q_1_x_bar_err + STEWART_UNIT*(REAL(5)*R_legs_xy_max + omega_P_y_bar_max*omega_x_max
                + REAL(4)*F_ext_y_max*c_force_x_bar_max + REAL(6)*M_P_load_y_max*Y_moment_x_max + REAL(2)*R_C_x_bar_max*r_C_y_max
                + REAL(3)*alpha_P_y_bar_max*alpha_x_max + REAL(5)*p_1_y_max*q_1_x_bar_max + STEWART_FABS(R_xy_bar));
            const stewart_real R_xz_bar = R_legs_xz - M_P_load_z*Y_moment_x + p_1_z*q_1_x_bar + F_ext_z*c_force_x_bar
                + alpha_P_z_bar*alpha_x + R_C_x_bar*r_C_z + omega_P_z_bar*omega_x;
            const stewart_real R_xz_bar_err = R_legs_xz_err + F_ext_z_max*c_force_x_bar_err + M_P_load_z_err*Y_moment_x_max
                + R_C_x_bar_err*r_C_z_max + R_C_x_bar_max*r_C_z_err + alpha_P_z_bar_err*alpha_x_max + omega_P_z_bar_err*omega_x_max
                + p_1_z_max*q_1_x_bar_err + STEWART_UNIT*(REAL(5)*R_legs_xz_max + omega_P_z_bar_max*omega_x_max
                + REAL(4)*F_ext_z_max*c_force_x_bar_max + REAL(6)*M_P_load_z_max*Y_moment_x_max + REAL(2)*R_C_x_bar_max*r_C_z_max
                + REAL(3)*alpha_P_z_bar_max*alpha_x_max + REAL(5)*p_1_z_max*q_1_x_bar_max + STEWART_FABS(R_xz_bar));
            const stewart_real R_yx_bar = R_legs_yx - M_P_load_x*Y_moment_y + p_1_x*q_1_y_bar + F_ext_x*c_force_y_bar
                + alpha_P_x_bar*alpha_y + R_C_y_bar*r_C_x + omega_P_x_bar*omega_y;
            const stewart_real R_yx_bar_err = R_legs_yx_err + F_ext_x_max*c_force_y_bar_err + M_P_load_x_err*Y_moment_y_max
                + R_C_y_bar_err*r_C_x_max + R_C_y_bar_max*r_C_x_err + alpha_P_x_bar_err*alpha_y_max + omega_P_x_bar_err*omega_y_max
                + p_1_x_max*q_1_y_bar_err + STEWART_UNIT*(REAL(5)*R_legs_yx_max + omega_P_x_bar_max*omega_y_max
                + REAL(4)*F_ext_x_max*c_force_y_bar_max + REAL(6)*M_P_load_x_max*Y_moment_y_max + REAL(2)*R_C_y_bar_max*r_C_x_max
                + REAL(3)*alpha_P_x_bar_max*alpha_y_max + REAL(5)*p_1_x_max*q_1_y_bar_max + STEWART_FABS(R_yx_bar));
            const stewart_real R_yy_bar = R_legs_yy - M_P_load_y*Y_moment_y + p_1_y*q_1_y_bar + F_ext_y*c_force_y_bar
                + alpha_P_y_bar*alpha_y + R_C_y_bar*r_C_y + omega_P_y_bar*omega_y;
            const stewart_real R_yy_bar_err = R_legs_yy_err + F_ext_y_max*c_force_y_bar_err + M_P_load_y_err*Y_moment_y_max
                + R_C_y_bar_err*r_C_y_max + R_C_y_bar_max*r_C_y_err + alpha_P_y_bar_err*alpha_y_max + omega_P_y_bar_err*omega_y_max
                + p_1_y_max*q_1_y_bar_err + STEWART_UNIT*(REAL(5)*R_legs_yy_max + omega_P_y_bar_max*omega_y_max
                + REAL(4)*F_ext_y_max*c_force_y_bar_max + REAL(6)*M_P_load_y_max*Y_moment_y_max + REAL(2)*R_C_y_bar_max*r_C_y_max
                + REAL(3)*alpha_P_y_bar_max*alpha_y_max + REAL(5)*p_1_y_max*q_1_y_bar_max + STEWART_FABS(R_yy_bar));
            const stewart_real R_yz_bar = R_legs_yz - M_P_load_z*Y_moment_y + p_1_z*q_1_y_bar + F_ext_z*c_force_y_bar
                + alpha_P_z_bar*alpha_y + R_C_y_bar*r_C_z + omega_P_z_bar*omega_y;
            const stewart_real R_yz_bar_err = R_legs_yz_err + F_ext_z_max*c_force_y_bar_err + M_P_load_z_err*Y_moment_y_max
                + R_C_y_bar_err*r_C_z_max + R_C_y_bar_max*r_C_z_err + alpha_P_z_bar_err*alpha_y_max + omega_P_z_bar_err*omega_y_max
                + p_1_z_max*q_1_y_bar_err + STEWART_UNIT*(REAL(5)*R_legs_yz_max + omega_P_z_bar_max*omega_y_max
                + REAL(4)*F_ext_z_max*c_force_y_bar_max + REAL(6)*M_P_load_z_max*Y_moment_y_max + REAL(2)*R_C_y_bar_max*r_C_z_max
                + REAL(3)*alpha_P_z_bar_max*alpha_y_max + REAL(5)*p_1_z_max*q_1_y_bar_max + STEWART_FABS(R_yz_bar));
            const stewart_real R_zx_bar = R_legs_zx - M_P_load_x*Y_moment_z + p_1_x*q_1_z_bar + F_ext_x*c_force_z_bar
                + alpha_P_x_bar*alpha_z + R_C_z_bar*r_C_x + omega_P_x_bar*omega_z;
            const stewart_real R_zx_bar_err = R_legs_zx_err + F_ext_x_max*c_force_z_bar_err + M_P_load_x_err*Y_moment_z_max
                + R_C_z_bar_err*r_C_x_max + R_C_z_bar_max*r_C_x_err + alpha_P_x_bar_err*alpha_z_max + omega_P_x_bar_err*omega_z_max
                + p_1_x_max*q_1_z_bar_err + STEWART_UNIT*(REAL(5)*R_legs_zx_max + omega_P_x_bar_max*omega_z_max
                + REAL(4)*F_ext_x_max*c_force_z_bar_max + REAL(6)*M_P_load_x_max*Y_moment_z_max + REAL(2)*R_C_z_bar_max*r_C_x_max
                + REAL(3)*alpha_P_x_bar_max*alpha_z_max + REAL(5)*p_1_x_max*q_1_z_bar_max + STEWART_FABS(R_zx_bar));
            const stewart_real R_zy_bar = R_legs_zy - M_P_load_y*Y_moment_z + p_1_y*q_1_z_bar + F_ext_y*c_force_z_bar
                + alpha_P_y_bar*alpha_z + R_C_z_bar*r_C_y + omega_P_y_bar*omega_z;
            const stewart_real R_zy_bar_err = R_legs_zy_err + F_ext_y_max*c_force_z_bar_err + M_P_load_y_err*Y_moment_z_max
                + R_C_z_bar_err*r_C_y_max + R_C_z_bar_max*r_C_y_err + alpha_P_y_bar_err*alpha_z_max + omega_P_y_bar_err*omega_z_max
                + p_1_y_max*q_1_z_bar_err + STEWART_UNIT*(REAL(5)*R_legs_zy_max + omega_P_y_bar_max*omega_z_max
                + REAL(4)*F_ext_y_max*c_force_z_bar_max + REAL(6)*M_P_load_y_max*Y_moment_z_max + REAL(2)*R_C_z_bar_max*r_C_y_max
                + REAL(3)*alpha_P_y_bar_max*alpha_z_max + REAL(5)*p_1_y_max*q_1_z_bar_max + STEWART_FABS(R_zy_bar));
            const stewart_real R_zz_bar = R_legs_zz - M_P_load_z*Y_moment_z + p_1_z*q_1_z_bar + F_ext_z*c_force_z_bar
                + alpha_P_z_bar*alpha_z + R_C_z_bar*r_C_z + omega_P_z_bar*omega_z;
            const stewart_real R_zz_bar_err = R_legs_zz_err + F_ext_z_max*c_force_z_bar_err + M_P_load_z_err*Y_moment_z_max
                + R_C_z_bar_err*r_C_z_max + R_C_z_bar_max*r_C_z_err + alpha_P_z_bar_err*alpha_z_max + omega_P_z_bar_err*omega_z_max
                + p_1_z_max*q_1_z_bar_err + STEWART_UNIT*(REAL(5)*R_legs_zz_max + omega_P_z_bar_max*omega_z_max
                + REAL(4)*F_ext_z_max*c_force_z_bar_max + REAL(6)*M_P_load_z_max*Y_moment_z_max + REAL(2)*R_C_z_bar_max*r_C_z_max
                + REAL(3)*alpha_P_z_bar_max*alpha_z_max + REAL(5)*p_1_z_max*q_1_z_bar_max + STEWART_FABS(R_zz_bar));
            const stewart_real M_P_bar = N_x_bar*(g_x - a_x - B_xx*R_C_x - B_xy*R_C_y - B_xz*R_C_z) + N_y_bar*(g_y
                - a_y - B_yx*R_C_x - B_yy*R_C_y - B_yz*R_C_z) + N_z_bar*(g_z - a_z - B_zx*R_C_x - B_zy*R_C_y
                - B_zz*R_C_z);
            const stewart_real M_P_bar_err = B_xx_err*N_x_bar_max*R_C_x_max + B_xy_err*N_x_bar_max*R_C_y_max
                + B_xz_err*N_x_bar_max*R_C_z_max + B_yx_err*N_y_bar_max*R_C_x_max + B_yy_err*N_y_bar_max*R_C_y_max
                + B_yz_err*N_y_bar_max*R_C_z_max + B_zx_err*N_z_bar_max*R_C_x_max + B_zy_err*N_z_bar_max*R_C_y_max
                + B_zz_err*N_z_bar_max*R_C_z_max + R_C_x_err*(B_xx_max*N_x_bar_max + B_yx_max*N_y_bar_max + B_zx_max*N_z_bar_max)
                + R_C_y_err*(B_xy_max*N_x_bar_max + B_yy_max*N_y_bar_max + B_zy_max*N_z_bar_max) + R_C_z_err*(B_xz_max*N_x_bar_max
                + B_yz_max*N_y_bar_max + B_zz_max*N_z_bar_max) + N_x_bar_err*(a_x_max + g_x_max + B_xx_max*R_C_x_max
                + B_xy_max*R_C_y_max + B_xz_max*R_C_z_max) + N_y_bar_err*(a_y_max + g_y_max + B_yx_max*R_C_x_max
                + B_yy_max*R_C_y_max + B_yz_max*R_C_z_max) + N_z_bar_err*(a_z_max + g_z_max + B_zx_max*R_C_x_max
                + B_zy_max*R_C_y_max + B_zz_max*R_C_z_max) + STEWART_UNIT*(N_z_bar_max*(a_z_max + g_z_max + B_zx_max*R_C_x_max
                + B_zy_max*R_C_y_max + B_zz_max*R_C_z_max) + REAL(2)*N_x_bar_max*(a_x_max + g_x_max + B_xx_max*R_C_x_max
                + B_xy_max*R_C_y_max + B_xz_max*R_C_z_max) + N_x_bar_max*(REAL(4)*a_x_max + REAL(4)*g_x_max
                + REAL(4)*B_xx_max*R_C_x_max + REAL(3)*B_xy_max*R_C_y_max + REAL(2)*B_xz_max*R_C_z_max) + REAL(2)*N_y_bar_max*(a_y_max
                + g_y_max + B_yx_max*R_C_x_max + B_yy_max*R_C_y_max + B_yz_max*R_C_z_max) + N_y_bar_max*(REAL(4)*a_y_max
                + REAL(4)*g_y_max + REAL(4)*B_yx_max*R_C_x_max + REAL(3)*B_yy_max*R_C_y_max + REAL(2)*B_yz_max*R_C_z_max)
                + N_z_bar_max*(REAL(4)*a_z_max + REAL(4)*g_z_max + REAL(4)*B_zx_max*R_C_x_max + REAL(3)*B_zy_max*R_C_y_max
                + REAL(2)*B_zz_max*R_C_z_max) + STEWART_FABS(M_P_bar));
            const stewart_real M_P_bar_max = STEWART_FABS(M_P_bar) + M_P_bar_err;
            const stewart_real r_C_x_bar = R_C_x_bar*R_xx + R_C_y_bar*R_yx + R_C_z_bar*R_zx;
            const stewart_real r_C_x_bar_err = R_C_x_bar_err*R_xx_max + R_C_y_bar_err*R_yx_max + R_C_z_bar_err*R_zx_max
                + R_err*(R_C_x_bar_max + R_C_y_bar_max + R_C_z_bar_max) + STEWART_UNIT*(R_C_z_bar_max*R_zx_max
                + REAL(2)*R_C_x_bar_max*R_xx_max + REAL(2)*R_C_y_bar_max*R_yx_max + STEWART_FABS(r_C_x_bar));
            const stewart_real r_C_x_bar_max = STEWART_FABS(r_C_x_bar) + r_C_x_bar_err;
            const stewart_real r_C_y_bar = R_C_x_bar*R_xy + R_C_y_bar*R_yy + R_C_z_bar*R_zy;
            const stewart_real r_C_y_bar_err = R_C_x_bar_err*R_xy_max + R_C_y_bar_err*R_yy_max + R_C_z_bar_err*R_zy_max
                + R_err*(R_C_x_bar_max + R_C_y_bar_max + R_C_z_bar_max) + STEWART_UNIT*(R_C_z_bar_max*R_zy_max
                + REAL(2)*R_C_x_bar_max*R_xy_max + REAL(2)*R_C_y_bar_max*R_yy_max + STEWART_FABS(r_C_y_bar));
            const stewart_real r_C_y_bar_max = STEWART_FABS(r_C_y_bar) + r_C_y_bar_err;
            const stewart_real r_C_z_bar = R_C_x_bar*R_xz + R_C_y_bar*R_yz + R_C_z_bar*R_zz;
            const stewart_real r_C_z_bar_err = R_C_x_bar_err*R_xz_max + R_C_y_bar_err*R_yz_max + R_C_z_bar_err*R_zz_max
                + R_err*(R_C_x_bar_max + R_C_y_bar_max + R_C_z_bar_max) + STEWART_UNIT*(R_C_z_bar_max*R_zz_max
                + REAL(2)*R_C_x_bar_max*R_xz_max + REAL(2)*R_C_y_bar_max*R_yz_max + STEWART_FABS(r_C_z_bar));
            const stewart_real r_C_z_bar_max = STEWART_FABS(r_C_z_bar) + r_C_z_bar_err;
            const stewart_real J_C_xx_bar = -M_P_load_x_bar*alpha_P_x;
            const stewart_real J_C_xx_bar_err = M_P_load_x_bar_err*alpha_P_x_max + M_P_load_x_bar_max*alpha_P_x_err
                + STEWART_UNIT*STEWART_FABS(J_C_xx_bar);
            const stewart_real J_C_xx_bar_max = STEWART_FABS(J_C_xx_bar) + J_C_xx_bar_err;
            const stewart_real J_C_xy_bar = M_P_load_x_bar*(P_xz - alpha_P_y) + M_P_load_y_bar*(-P_yz - alpha_P_x)
                + M_P_load_z_bar*(P_yy - P_xx);
            const stewart_real J_C_xy_bar_err = M_P_load_x_bar_max*P_xz_err + M_P_load_x_bar_max*alpha_P_y_err
                + M_P_load_y_bar_max*P_yz_err + M_P_load_y_bar_max*alpha_P_x_err + M_P_load_z_bar_max*P_xx_err
                + M_P_load_z_bar_max*P_yy_err + M_P_load_x_bar_err*(P_xz_max + alpha_P_y_max) + M_P_load_y_bar_err*(P_yz_max
                + alpha_P_x_max) + M_P_load_z_bar_err*(P_xx_max + P_yy_max) + STEWART_UNIT*(REAL(3)*M_P_load_x_bar_max*(P_xz_max
                + alpha_P_y_max) + REAL(3)*M_P_load_y_bar_max*(P_yz_max + alpha_P_x_max) + REAL(2)*M_P_load_z_bar_max*(P_xx_max
                + P_yy_max) + STEWART_FABS(J_C_xy_bar));
            const stewart_real J_C_xy_bar_max = STEWART_FABS(J_C_xy_bar) + J_C_xy_bar_err;
            const stewart_real J_C_xz_bar = M_P_load_x_bar*(-P_xy - alpha_P_z) + M_P_load_y_bar*(P_xx - P_zz)
                + M_P_load_z_bar*(P_yz - alpha_P_x);
            const stewart_real J_C_xz_bar_err = M_P_load_x_bar_max*P_xy_err + M_P_load_x_bar_max*alpha_P_z_err
                + M_P_load_y_bar_max*P_xx_err + M_P_load_y_bar_max*P_zz_err + M_P_load_z_bar_max*P_yz_err + M_P_load_z_bar_max*alpha_P_x_err
                + M_P_load_x_bar_err*(P_xy_max + alpha_P_z_max) + M_P_load_y_bar_err*(P_xx_max + P_zz_max) + M_P_load_z_bar_err*(P_yz_max
                + alpha_P_x_max) + STEWART_UNIT*(REAL(3)*M_P_load_x_bar_max*(P_xy_max + alpha_P_z_max) + REAL(3)*M_P_load_y_bar_max*(P_xx_max
                + P_zz_max) + REAL(2)*M_P_load_z_bar_max*(P_yz_max + alpha_P_x_max) + STEWART_FABS(J_C_xz_bar));
            const stewart_real J_C_xz_bar_max = STEWART_FABS(J_C_xz_bar) + J_C_xz_bar_err;
            const stewart_real J_C_yy_bar = -M_P_load_y_bar*alpha_P_y;
            const stewart_real J_C_yy_bar_err = M_P_load_y_bar_err*alpha_P_y_max + M_P_load_y_bar_max*alpha_P_y_err
                + STEWART_UNIT*STEWART_FABS(J_C_yy_bar);
            const stewart_real J_C_yy_bar_max = STEWART_FABS(J_C_yy_bar) + J_C_yy_bar_err;
            const stewart_real J_C_yz_bar = M_P_load_x_bar*(P_zz - P_yy) + M_P_load_y_bar*(P_xy - alpha_P_z)
                + M_P_load_z_bar*(-P_xz - alpha_P_y);
            const stewart_real J_C_yz_bar_err = M_P_load_x_bar_max*P_yy_err + M_P_load_x_bar_max*P_zz_err + M_P_load_y_bar_max*P_xy_err
                + M_P_load_y_bar_max*alpha_P_z_err + M_P_load_z_bar_max*P_xz_err + M_P_load_z_bar_max*alpha_P_y_err
                + M_P_load_x_bar_err*(P_yy_max + P_zz_max) + M_P_load_y_bar_err*(P_xy_max + alpha_P_z_max) + M_P_load_z_bar_err*(P_xz_max
                + alpha_P_y_max) + STEWART_UNIT*(REAL(3)*M_P_load_x_bar_max*(P_yy_max + P_zz_max) + REAL(3)*M_P_load_y_bar_max*(P_xy_max
                + alpha_P_z_max) + REAL(2)*M_P_load_z_bar_max*(P_xz_max + alpha_P_y_max) + STEWART_FABS(J_C_yz_bar));
            const stewart_real J_C_yz_bar_max = STEWART_FABS(J_C_yz_bar) + J_C_yz_bar_err;
            const stewart_real J_C_zz_bar = -M_P_load_z_bar*alpha_P_z;
            const stewart_real J_C_zz_bar_err = M_P_load_z_bar_err*alpha_P_z_max + M_P_load_z_bar_max*alpha_P_z_err
                + STEWART_UNIT*STEWART_FABS(J_C_zz_bar);
            const stewart_real J_C_zz_bar_max = STEWART_FABS(J_C_zz_bar) + J_C_zz_bar_err;
            const stewart_real dJ_C_x_bar = -M_P_load_x_bar*P_yz;
            const stewart_real dJ_C_x_bar_err = M_P_load_x_bar_err*P_yz_max + M_P_load_x_bar_max*P_yz_err + STEWART_UNIT*STEWART_FABS(dJ_C_x_bar);
            const stewart_real dJ_C_x_bar_max = STEWART_FABS(dJ_C_x_bar) + dJ_C_x_bar_err;
            const stewart_real dJ_C_y_bar = -M_P_load_y_bar*P_xz;
            const stewart_real dJ_C_y_bar_err = M_P_load_y_bar_err*P_xz_max + M_P_load_y_bar_max*P_xz_err + STEWART_UNIT*STEWART_FABS(dJ_C_y_bar);
            const stewart_real dJ_C_y_bar_max = STEWART_FABS(dJ_C_y_bar) + dJ_C_y_bar_err;
            const stewart_real dJ_C_z_bar = -M_P_load_z_bar*P_xy;
            const stewart_real dJ_C_z_bar_err = M_P_load_z_bar_err*P_xy_max + M_P_load_z_bar_max*P_xy_err + STEWART_UNIT*STEWART_FABS(dJ_C_z_bar);
            const stewart_real dJ_C_z_bar_max = STEWART_FABS(dJ_C_z_bar) + dJ_C_z_bar_err;
            const stewart_real C_P_bar = Y_moment_x*omega_x + Y_moment_y*omega_y + Y_moment_z*omega_z;
            const stewart_real C_P_bar_err = STEWART_UNIT*(Y_moment_z_max*omega_z_max + REAL(2)*Y_moment_x_max*omega_x_max
                + REAL(2)*Y_moment_y_max*omega_y_max + STEWART_FABS(C_P_bar));
            const stewart_real C_P_bar_max = STEWART_FABS(C_P_bar) + C_P_bar_err;
            error[i] = error[i] + M_P_bar_max*M_P_err + r_C_x_bar_max*r_C_x_err + r_C_y_bar_max*r_C_y_err + r_C_z_bar_max*r_C_z_err
                + J_C_xx_bar_max*J_C_xx_err + J_C_xy_bar_max*J_C_xy_err + J_C_xz_bar_max*J_C_xz_err + J_C_yy_bar_max*J_C_yy_err
                + J_C_yz_bar_max*J_C_yz_err + J_C_zz_bar_max*J_C_zz_err + dJ_C_x_bar_max*dJ_C_x_err + dJ_C_y_bar_max*dJ_C_y_err
                + dJ_C_z_bar_max*dJ_C_z_err + C_P_bar_max*C_P_err + omega_xx_bar_max*omega_xx_own + omega_xy_bar_max*omega_xy_own
                + omega_xz_bar_max*omega_xz_own + omega_yy_bar_max*omega_yy_own + omega_yz_bar_max*omega_yz_own
                + omega_zz_bar_max*omega_zz_own + B_xx_bar_max*B_xx_own + B_xy_bar_max*B_xy_own + B_xz_bar_max*B_xz_own
                + B_yx_bar_max*B_yx_own + B_yy_bar_max*B_yy_own + B_yz_bar_max*B_yz_own + B_zx_bar_max*B_zx_own
                + B_zy_bar_max*B_zy_own + B_zz_bar_max*B_zz_own + R_C_x_bar_max*R_C_x_own + R_C_y_bar_max*R_C_y_own
                + R_C_z_bar_max*R_C_z_own + N_x_bar_max*N_x_own + N_y_bar_max*N_y_own + N_z_bar_max*N_z_own
                + omega_P_x_bar_max*omega_P_x_own + omega_P_y_bar_max*omega_P_y_own + omega_P_z_bar_max*omega_P_z_own
                + alpha_P_x_bar_max*alpha_P_x_own + alpha_P_y_bar_max*alpha_P_y_own + alpha_P_z_bar_max*alpha_P_z_own
                + P_xy_bar_max*P_xy_own + P_xz_bar_max*P_xz_own + P_yz_bar_max*P_yz_own + P_xx_bar_max*P_xx_own
                + P_yy_bar_max*P_yy_own + P_zz_bar_max*P_zz_own + M_P_load_x_bar_max*M_P_load_x_own + M_P_load_y_bar_max*M_P_load_y_own
                + M_P_load_z_bar_max*M_P_load_z_own + c_force_x_bar_max*c_force_x_own + c_force_y_bar_max*c_force_y_own
                + c_force_z_bar_max*c_force_z_own + Y_moment_x_max*c_moment_x_own + Y_moment_y_max*c_moment_y_own
                + Y_moment_z_max*c_moment_z_own + q_1_x_bar_max*q_1_x_own + q_1_y_bar_max*q_1_y_own + q_1_z_bar_max*q_1_z_own
                + Y_moment_x_max*c_tip_x_own + Y_moment_y_max*c_tip_y_own + Y_moment_z_max*c_tip_z_own;
            slopes->R_legs[0][i] = R_xx_bar;
            slopes->R_legs_err[0][i] = R_xx_bar_err;
            slopes->R_legs[1][i] = R_xy_bar;
            slopes->R_legs_err[1][i] = R_xy_bar_err;
            slopes->R_legs[2][i] = R_xz_bar;
            slopes->R_legs_err[2][i] = R_xz_bar_err;
            slopes->R_legs[3][i] = R_yx_bar;
            slopes->R_legs_err[3][i] = R_yx_bar_err;
            slopes->R_legs[4][i] = R_yy_bar;
            slopes->R_legs_err[4][i] = R_yy_bar_err;
            slopes->R_legs[5][i] = R_yz_bar;
            slopes->R_legs_err[5][i] = R_yz_bar_err;
            slopes->R_legs[6][i] = R_zx_bar;
            slopes->R_legs_err[6][i] = R_zx_bar_err;
            slopes->R_legs[7][i] = R_zy_bar;
            slopes->R_legs_err[7][i] = R_zy_bar_err;
            slopes->R_legs[8][i] = R_zz_bar;
            slopes->R_legs_err[8][i] = R_zz_bar_err;
        }
    }
}

/* Terms of one leg with their errors. Adds the effects of the errors to the error of each force, and to
 * the derivatives of each force with respect to the common terms of the pose. */
static void leg_errors(
    const stewart_exact_drive_bounds_platform *platform, const stewart_exact_drive_bounds_leg *leg,
    const stewart_motions *at, const shared_terms *shared, stewart_real R_err,
    const force_rows *STEWART_RESTRICT rows, force_slopes *STEWART_RESTRICT slopes,
    stewart_real *STEWART_RESTRICT error, leg_terms *out)
{
    int i;
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = leg->k[0], k_y = leg->k[1], k_z = leg->k[2];
    const stewart_real k_x_err = leg->k_err[0], k_y_err = leg->k_err[1], k_z_err = leg->k_err[2];
    const stewart_real C_p = leg->C_p;
    const stewart_real C_s = leg->C_s;
    const stewart_real m_r = leg->m_r;
    const stewart_real j_r = leg->j_r;
    const stewart_real h_x = leg->h[0], h_y = leg->h[1], h_z = leg->h[2];
    const stewart_real h_x_err = leg->h_err[0], h_y_err = leg->h_err[1], h_z_err = leg->h_err[2];
    const stewart_real h2_x = leg->h2_x;
    const stewart_real h2_x_err = leg->h2_x_err;
    const stewart_real h2_y = leg->h2_y;
    const stewart_real h2_y_err = leg->h2_y_err;
    const stewart_real h2_z = leg->h2_z;
    const stewart_real h2_z_err = leg->h2_z_err;
    const stewart_real w_x = leg->w[0], w_y = leg->w[1], w_z = leg->w[2];
    const stewart_real w_x_err = leg->w_err[0], w_y_err = leg->w_err[1], w_z_err = leg->w_err[2];
    const stewart_real J_xx = leg->J[0], J_xy = leg->J[1], J_yy = leg->J[3], J_yz = leg->J[4];
    const stewart_real J_xx_err = leg->J_err[0], J_xy_err = leg->J_err[1], J_yy_err = leg->J_err[3],
        J_yz_err = leg->J_err[4];
    const stewart_real J2_xz = leg->J2_xz;
    const stewart_real J2_xz_err = leg->J2_xz_err;
    const stewart_real dJ_zx = leg->dJ_zx;
    const stewart_real dJ_zx_err = leg->dJ_zx_err;
    const stewart_real g_k = leg->g_k;
    const stewart_real g_k_err = leg->g_k_err;
    const stewart_real g_x_k_x = leg->g_x_k[0], g_x_k_y = leg->g_x_k[1], g_x_k_z = leg->g_x_k[2];
    const stewart_real g_x_k_x_err = leg->g_x_k_err[0], g_x_k_y_err = leg->g_x_k_err[1], g_x_k_z_err = leg->g_x_k_err[2];
    const stewart_real C_us = leg->C_us;
    const stewart_real C_us_err = leg->C_us_err;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real B_xx = shared->B[0], B_xy = shared->B[1], B_xz = shared->B[2], B_yx = shared->B[3],
        B_yy = shared->B[4], B_yz = shared->B[5], B_zx = shared->B[6], B_zy = shared->B[7], B_zz = shared->B[8];
    const stewart_real B_xx_err = shared->B_err[0], B_xy_err = shared->B_err[1], B_xz_err = shared->B_err[2],
        B_yx_err = shared->B_err[3], B_yy_err = shared->B_err[4], B_yz_err = shared->B_err[5], B_zx_err = shared->B_err[6],
        B_zy_err = shared->B_err[7], B_zz_err = shared->B_err[8];
    const stewart_real g_x = platform->g[0], g_y = platform->g[1], g_z = platform->g[2];
    const stewart_real q_1_x = shared->q_1[0], q_1_y = shared->q_1[1], q_1_z = shared->q_1[2];
    const stewart_real q_1_x_err = shared->q_1_err[0], q_1_y_err = shared->q_1_err[1], q_1_z_err = shared->q_1_err[2];
    const stewart_real p_x_max = STEWART_FABS(p_x);
    const stewart_real p_y_max = STEWART_FABS(p_y);
    const stewart_real p_z_max = STEWART_FABS(p_z);
    const stewart_real k_x_max = STEWART_FABS(k_x) + k_x_err;
    const stewart_real k_y_max = STEWART_FABS(k_y) + k_y_err;
    const stewart_real k_z_max = STEWART_FABS(k_z) + k_z_err;
    const stewart_real C_p_max = STEWART_FABS(C_p);
    const stewart_real C_s_max = STEWART_FABS(C_s);
    const stewart_real m_r_max = STEWART_FABS(m_r);
    const stewart_real j_r_max = STEWART_FABS(j_r);
    const stewart_real h_x_max = STEWART_FABS(h_x) + h_x_err;
    const stewart_real h_y_max = STEWART_FABS(h_y) + h_y_err;
    const stewart_real h_z_max = STEWART_FABS(h_z) + h_z_err;
    const stewart_real h2_x_max = STEWART_FABS(h2_x) + h2_x_err;
    const stewart_real h2_y_max = STEWART_FABS(h2_y) + h2_y_err;
    const stewart_real h2_z_max = STEWART_FABS(h2_z) + h2_z_err;
    const stewart_real w_x_max = STEWART_FABS(w_x) + w_x_err;
    const stewart_real w_y_max = STEWART_FABS(w_y) + w_y_err;
    const stewart_real w_z_max = STEWART_FABS(w_z) + w_z_err;
    const stewart_real J_xx_max = STEWART_FABS(J_xx) + J_xx_err;
    const stewart_real J_yz_max = STEWART_FABS(J_yz) + J_yz_err;
    const stewart_real g_k_max = STEWART_FABS(g_k) + g_k_err;
    const stewart_real g_x_k_x_max = STEWART_FABS(g_x_k_x) + g_x_k_x_err;
    const stewart_real g_x_k_y_max = STEWART_FABS(g_x_k_y) + g_x_k_y_err;
    const stewart_real g_x_k_z_max = STEWART_FABS(g_x_k_z) + g_x_k_z_err;
    const stewart_real C_us_max = STEWART_FABS(C_us) + C_us_err;
    const stewart_real R_xx_max = STEWART_FABS(R_xx) + R_err;
    const stewart_real R_xy_max = STEWART_FABS(R_xy) + R_err;
    const stewart_real R_xz_max = STEWART_FABS(R_xz) + R_err;
    const stewart_real R_yx_max = STEWART_FABS(R_yx) + R_err;
    const stewart_real R_yy_max = STEWART_FABS(R_yy) + R_err;
    const stewart_real R_yz_max = STEWART_FABS(R_yz) + R_err;
    const stewart_real R_zx_max = STEWART_FABS(R_zx) + R_err;
    const stewart_real R_zy_max = STEWART_FABS(R_zy) + R_err;
    const stewart_real R_zz_max = STEWART_FABS(R_zz) + R_err;
    const stewart_real omega_x_max = STEWART_FABS(omega_x);
    const stewart_real omega_y_max = STEWART_FABS(omega_y);
    const stewart_real omega_z_max = STEWART_FABS(omega_z);
    const stewart_real v_x_max = STEWART_FABS(v_x);
    const stewart_real v_y_max = STEWART_FABS(v_y);
    const stewart_real v_z_max = STEWART_FABS(v_z);
    const stewart_real a_x_max = STEWART_FABS(a_x);
    const stewart_real a_y_max = STEWART_FABS(a_y);
    const stewart_real a_z_max = STEWART_FABS(a_z);
    const stewart_real B_xx_max = STEWART_FABS(B_xx) + B_xx_err;
    const stewart_real B_xy_max = STEWART_FABS(B_xy) + B_xy_err;
    const stewart_real B_xz_max = STEWART_FABS(B_xz) + B_xz_err;
    const stewart_real B_yx_max = STEWART_FABS(B_yx) + B_yx_err;
    const stewart_real B_yy_max = STEWART_FABS(B_yy) + B_yy_err;
    const stewart_real B_yz_max = STEWART_FABS(B_yz) + B_yz_err;
    const stewart_real B_zx_max = STEWART_FABS(B_zx) + B_zx_err;
    const stewart_real B_zy_max = STEWART_FABS(B_zy) + B_zy_err;
    const stewart_real B_zz_max = STEWART_FABS(B_zz) + B_zz_err;
    const stewart_real g_x_max = STEWART_FABS(g_x);
    const stewart_real g_y_max = STEWART_FABS(g_y);
    const stewart_real g_z_max = STEWART_FABS(g_z);
    /* (1) platform point from the reference point */
    const stewart_real q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z;
    const stewart_real q_x_own = STEWART_UNIT*(R_xz_max*p_z_max + REAL(2)*R_xx_max*p_x_max + REAL(2)*R_xy_max*p_y_max
        + STEWART_FABS(q_x));
    const stewart_real q_x_err = R_err*(p_x_max + p_y_max + p_z_max) + q_x_own;
    const stewart_real q_x_max = STEWART_FABS(q_x) + q_x_err;
    const stewart_real q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z;
    const stewart_real q_y_own = STEWART_UNIT*(R_yz_max*p_z_max + REAL(2)*R_yx_max*p_x_max + REAL(2)*R_yy_max*p_y_max
        + STEWART_FABS(q_y));
    const stewart_real q_y_err = R_err*(p_x_max + p_y_max + p_z_max) + q_y_own;
    const stewart_real q_y_max = STEWART_FABS(q_y) + q_y_err;
    const stewart_real q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z;
    const stewart_real q_z_own = STEWART_UNIT*(R_zz_max*p_z_max + REAL(2)*R_zx_max*p_x_max + REAL(2)*R_zy_max*p_y_max
        + STEWART_FABS(q_z));
    const stewart_real q_z_err = R_err*(p_x_max + p_y_max + p_z_max) + q_z_own;
    const stewart_real q_z_max = STEWART_FABS(q_z) + q_z_err;
    /* (1) reference point from base point, base frame */
    const stewart_real t_b_x = t_x - b_x;
    const stewart_real t_b_x_own = STEWART_UNIT*STEWART_FABS(t_b_x);
    const stewart_real t_b_x_err = t_b_x_own;
    const stewart_real t_b_y = t_y - b_y;
    const stewart_real t_b_y_own = STEWART_UNIT*STEWART_FABS(t_b_y);
    const stewart_real t_b_y_err = t_b_y_own;
    const stewart_real t_b_z = t_z - b_z;
    const stewart_real t_b_z_own = STEWART_UNIT*STEWART_FABS(t_b_z);
    const stewart_real t_b_z_err = t_b_z_own;
    /* (1) leg vector */
    const stewart_real S_x = t_b_x + q_x;
    const stewart_real S_x_own = STEWART_UNIT*STEWART_FABS(S_x);
    const stewart_real S_x_err = q_x_err + t_b_x_err + S_x_own;
    const stewart_real S_x_max = STEWART_FABS(S_x) + S_x_err;
    const stewart_real S_y = t_b_y + q_y;
    const stewart_real S_y_own = STEWART_UNIT*STEWART_FABS(S_y);
    const stewart_real S_y_err = q_y_err + t_b_y_err + S_y_own;
    const stewart_real S_y_max = STEWART_FABS(S_y) + S_y_err;
    const stewart_real S_z = t_b_z + q_z;
    const stewart_real S_z_own = STEWART_UNIT*STEWART_FABS(S_z);
    const stewart_real S_z_err = q_z_err + t_b_z_err + S_z_own;
    const stewart_real S_z_max = STEWART_FABS(S_z) + S_z_err;
    /* (10) component of the leg vector along the fixed axis, and normal to both */
    const stewart_real zeta = S_x*k_x + S_y*k_y + S_z*k_z;
    const stewart_real zeta_own = STEWART_UNIT*(S_z_max*k_z_max + REAL(2)*S_x_max*k_x_max + REAL(2)*S_y_max*k_y_max
        + STEWART_FABS(zeta));
    const stewart_real zeta_err = S_x_err*k_x_max + S_x_max*k_x_err + S_y_err*k_y_max + S_y_max*k_y_err + S_z_err*k_z_max
        + S_z_max*k_z_err + zeta_own;
    const stewart_real zeta_max = STEWART_FABS(zeta) + zeta_err;
    const stewart_real k_cross_S_x = S_z*k_y - S_y*k_z;
    const stewart_real k_cross_S_x_own = STEWART_UNIT*(S_y_max*k_z_max + S_z_max*k_y_max + STEWART_FABS(k_cross_S_x));
    const stewart_real k_cross_S_x_err = S_y_err*k_z_max + S_y_max*k_z_err + S_z_err*k_y_max + S_z_max*k_y_err
        + k_cross_S_x_own;
    const stewart_real k_cross_S_x_max = STEWART_FABS(k_cross_S_x) + k_cross_S_x_err;
    const stewart_real k_cross_S_y = S_x*k_z - S_z*k_x;
    const stewart_real k_cross_S_y_own = STEWART_UNIT*(S_x_max*k_z_max + S_z_max*k_x_max + STEWART_FABS(k_cross_S_y));
    const stewart_real k_cross_S_y_err = S_x_err*k_z_max + S_x_max*k_z_err + S_z_err*k_x_max + S_z_max*k_x_err
        + k_cross_S_y_own;
    const stewart_real k_cross_S_y_max = STEWART_FABS(k_cross_S_y) + k_cross_S_y_err;
    const stewart_real k_cross_S_z = S_y*k_x - S_x*k_y;
    const stewart_real k_cross_S_z_own = STEWART_UNIT*(S_x_max*k_y_max + S_y_max*k_x_max + STEWART_FABS(k_cross_S_z));
    const stewart_real k_cross_S_z_err = S_x_err*k_y_max + S_x_max*k_y_err + S_y_err*k_x_max + S_y_max*k_x_err
        + k_cross_S_z_own;
    const stewart_real k_cross_S_z_max = STEWART_FABS(k_cross_S_z) + k_cross_S_z_err;
    const stewart_real rho2 = k_cross_S_x*k_cross_S_x + k_cross_S_y*k_cross_S_y + k_cross_S_z*k_cross_S_z;
    const stewart_real rho2_own = STEWART_UNIT*(k_cross_S_z_max*k_cross_S_z_max + REAL(2)*k_cross_S_x_max*k_cross_S_x_max
        + REAL(2)*k_cross_S_y_max*k_cross_S_y_max + STEWART_FABS(rho2));
    const stewart_real rho2_err = REAL(2)*(k_cross_S_x_err*k_cross_S_x_max + k_cross_S_y_err*k_cross_S_y_max
        + k_cross_S_z_err*k_cross_S_z_max) + rho2_own;
    const stewart_real rho2_max = STEWART_FABS(rho2) + rho2_err;
    /* (2) leg length, and distance of the tip from the fixed axis */
    const stewart_real L = STEWART_SQRT(zeta*zeta + rho2);
    const stewart_real L_own = root_error(L, STEWART_UNIT*(rho2_max + REAL(2)*zeta_max*zeta_max));
    const stewart_real L_err = root_error(L, rho2_err + REAL(2)*zeta_err*zeta_max + STEWART_UNIT*(rho2_max + REAL(2)*zeta_max*zeta_max));
    const stewart_real L_max = STEWART_FABS(L) + L_err;
    const stewart_real rho = STEWART_SQRT(rho2);
    const stewart_real rho_own = root_error(rho, REAL(0));
    const stewart_real rho_err = root_error(rho, rho2_err);
    const stewart_real rho_max = STEWART_FABS(rho) + rho_err;
    const stewart_real inv_L = REAL(1)/L;
    const stewart_real inv_L_own = STEWART_UNIT*STEWART_FABS(inv_L);
    const stewart_real inv_L_err = reciprocal_error(inv_L, L, L_err);
    const stewart_real inv_L_max = STEWART_FABS(inv_L) + inv_L_err;
    /* (3) unit vector along the leg */
    const stewart_real s_x = S_x*inv_L;
    const stewart_real s_x_own = STEWART_UNIT*STEWART_FABS(s_x);
    const stewart_real s_x_err = S_x_err*inv_L_max + S_x_max*inv_L_err + s_x_own;
    const stewart_real s_x_max = STEWART_FABS(s_x) + s_x_err;
    const stewart_real s_y = S_y*inv_L;
    const stewart_real s_y_own = STEWART_UNIT*STEWART_FABS(s_y);
    const stewart_real s_y_err = S_y_err*inv_L_max + S_y_max*inv_L_err + s_y_own;
    const stewart_real s_y_max = STEWART_FABS(s_y) + s_y_err;
    const stewart_real s_z = S_z*inv_L;
    const stewart_real s_z_own = STEWART_UNIT*STEWART_FABS(s_z);
    const stewart_real s_z_err = S_z_err*inv_L_max + S_z_max*inv_L_err + s_z_own;
    const stewart_real s_z_max = STEWART_FABS(s_z) + s_z_err;
    const stewart_real inv_rho = REAL(1)/rho;
    const stewart_real inv_rho_own = STEWART_UNIT*STEWART_FABS(inv_rho);
    const stewart_real inv_rho_err = reciprocal_error(inv_rho, rho, rho_err);
    const stewart_real inv_rho_max = STEWART_FABS(inv_rho) + inv_rho_err;
    /* (10) second axis of the leg frame */
    const stewart_real y_x = inv_rho*k_cross_S_x;
    const stewart_real y_x_own = STEWART_UNIT*STEWART_FABS(y_x);
    const stewart_real y_x_err = inv_rho_err*k_cross_S_x_max + inv_rho_max*k_cross_S_x_err + y_x_own;
    const stewart_real y_x_max = STEWART_FABS(y_x) + y_x_err;
    const stewart_real y_y = inv_rho*k_cross_S_y;
    const stewart_real y_y_own = STEWART_UNIT*STEWART_FABS(y_y);
    const stewart_real y_y_err = inv_rho_err*k_cross_S_y_max + inv_rho_max*k_cross_S_y_err + y_y_own;
    const stewart_real y_y_max = STEWART_FABS(y_y) + y_y_err;
    const stewart_real y_z = inv_rho*k_cross_S_z;
    const stewart_real y_z_own = STEWART_UNIT*STEWART_FABS(y_z);
    const stewart_real y_z_err = inv_rho_err*k_cross_S_z_max + inv_rho_max*k_cross_S_z_err + y_z_own;
    const stewart_real y_z_max = STEWART_FABS(y_z) + y_z_err;
    /* (10) k = (k1, 0, k3) in the leg frame */
    const stewart_real k1 = inv_L*zeta;
    const stewart_real k1_own = STEWART_UNIT*STEWART_FABS(k1);
    const stewart_real k1_err = inv_L_err*zeta_max + inv_L_max*zeta_err + k1_own;
    const stewart_real k1_max = STEWART_FABS(k1) + k1_err;
    const stewart_real k3 = inv_L*rho;
    const stewart_real k3_own = STEWART_UNIT*STEWART_FABS(k3);
    const stewart_real k3_err = inv_L_err*rho_max + inv_L_max*rho_err + k3_own;
    const stewart_real k3_max = STEWART_FABS(k3) + k3_err;
    /* (10) k1 / k3 */
    const stewart_real kappa = inv_rho*zeta;
    const stewart_real kappa_own = STEWART_UNIT*STEWART_FABS(kappa);
    const stewart_real kappa_err = inv_rho_err*zeta_max + inv_rho_max*zeta_err + kappa_own;
    const stewart_real kappa_max = STEWART_FABS(kappa) + kappa_err;
    /* (4) velocity of the platform point */
    const stewart_real S_dot_x = v_x + omega_y*q_z - omega_z*q_y;
    const stewart_real S_dot_x_own = STEWART_UNIT*(v_x_max + omega_z_max*q_y_max + REAL(2)*omega_y_max*q_z_max
        + STEWART_FABS(S_dot_x));
    const stewart_real S_dot_x_err = omega_y_max*q_z_err + omega_z_max*q_y_err + S_dot_x_own;
    const stewart_real S_dot_x_max = STEWART_FABS(S_dot_x) + S_dot_x_err;
    const stewart_real S_dot_y = v_y + omega_z*q_x - omega_x*q_z;
    const stewart_real S_dot_y_own = STEWART_UNIT*(v_y_max + omega_x_max*q_z_max + REAL(2)*omega_z_max*q_x_max
        + STEWART_FABS(S_dot_y));
    const stewart_real S_dot_y_err = omega_x_max*q_z_err + omega_z_max*q_x_err + S_dot_y_own;
    const stewart_real S_dot_y_max = STEWART_FABS(S_dot_y) + S_dot_y_err;
    const stewart_real S_dot_z = v_z + omega_x*q_y - omega_y*q_x;
    const stewart_real S_dot_z_own = STEWART_UNIT*(v_z_max + omega_y_max*q_x_max + REAL(2)*omega_x_max*q_y_max
        + STEWART_FABS(S_dot_z));
    const stewart_real S_dot_z_err = omega_x_max*q_y_err + omega_y_max*q_x_err + S_dot_z_own;
    const stewart_real S_dot_z_max = STEWART_FABS(S_dot_z) + S_dot_z_err;
    /* (7) acceleration of the platform point */
    const stewart_real S_ddot_x = a_x + B_xx*q_x + B_xy*q_y + B_xz*q_z;
    const stewart_real S_ddot_x_own = STEWART_UNIT*(B_xz_max*q_z_max + REAL(2)*a_x_max + REAL(3)*B_xx_max*q_x_max
        + REAL(2)*B_xy_max*q_y_max + STEWART_FABS(S_ddot_x));
    const stewart_real S_ddot_x_err = B_xx_err*q_x_max + B_xx_max*q_x_err + B_xy_err*q_y_max + B_xy_max*q_y_err
        + B_xz_err*q_z_max + B_xz_max*q_z_err + S_ddot_x_own;
    const stewart_real S_ddot_x_max = STEWART_FABS(S_ddot_x) + S_ddot_x_err;
    const stewart_real S_ddot_y = a_y + B_yx*q_x + B_yy*q_y + B_yz*q_z;
    const stewart_real S_ddot_y_own = STEWART_UNIT*(B_yz_max*q_z_max + REAL(2)*a_y_max + REAL(3)*B_yx_max*q_x_max
        + REAL(2)*B_yy_max*q_y_max + STEWART_FABS(S_ddot_y));
    const stewart_real S_ddot_y_err = B_yx_err*q_x_max + B_yx_max*q_x_err + B_yy_err*q_y_max + B_yy_max*q_y_err
        + B_yz_err*q_z_max + B_yz_max*q_z_err + S_ddot_y_own;
    const stewart_real S_ddot_y_max = STEWART_FABS(S_ddot_y) + S_ddot_y_err;
    const stewart_real S_ddot_z = a_z + B_zx*q_x + B_zy*q_y + B_zz*q_z;
    const stewart_real S_ddot_z_own = STEWART_UNIT*(B_zz_max*q_z_max + REAL(2)*a_z_max + REAL(3)*B_zx_max*q_x_max
        + REAL(2)*B_zy_max*q_y_max + STEWART_FABS(S_ddot_z));
    const stewart_real S_ddot_z_err = B_zx_err*q_x_max + B_zx_max*q_x_err + B_zy_err*q_y_max + B_zy_max*q_y_err
        + B_zz_err*q_z_max + B_zz_max*q_z_err + S_ddot_z_own;
    const stewart_real S_ddot_z_max = STEWART_FABS(S_ddot_z) + S_ddot_z_err;
    /* (5) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z;
    const stewart_real L_dot_own = STEWART_UNIT*(S_dot_z_max*s_z_max + REAL(2)*S_dot_x_max*s_x_max + REAL(2)*S_dot_y_max*s_y_max
        + STEWART_FABS(L_dot));
    const stewart_real L_dot_err = S_dot_x_err*s_x_max + S_dot_x_max*s_x_err + S_dot_y_err*s_y_max + S_dot_y_max*s_y_err
        + S_dot_z_err*s_z_max + S_dot_z_max*s_z_err + L_dot_own;
    const stewart_real L_dot_max = STEWART_FABS(L_dot) + L_dot_err;
    /* (6) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z);
    const stewart_real phi_dot_own = STEWART_UNIT*(inv_rho_max*(REAL(3)*S_dot_x_max*y_x_max + REAL(3)*S_dot_y_max*y_y_max
        + REAL(2)*S_dot_z_max*y_z_max) + STEWART_FABS(phi_dot));
    const stewart_real phi_dot_err = S_dot_x_err*inv_rho_max*y_x_max + S_dot_x_max*inv_rho_max*y_x_err + S_dot_y_err*inv_rho_max*y_y_max
        + S_dot_y_max*inv_rho_max*y_y_err + S_dot_z_err*inv_rho_max*y_z_max + S_dot_z_max*inv_rho_max*y_z_err
        + inv_rho_err*(S_dot_x_max*y_x_max + S_dot_y_max*y_y_max + S_dot_z_max*y_z_max) + phi_dot_own;
    const stewart_real phi_dot_max = STEWART_FABS(phi_dot) + phi_dot_err;
    const stewart_real theta_dot = inv_rho*(L_dot*k1 - S_dot_x*k_x - S_dot_y*k_y - S_dot_z*k_z);
    const stewart_real theta_dot_own = STEWART_UNIT*(inv_rho_max*(REAL(4)*L_dot_max*k1_max + REAL(4)*S_dot_x_max*k_x_max
        + REAL(3)*S_dot_y_max*k_y_max + REAL(2)*S_dot_z_max*k_z_max) + STEWART_FABS(theta_dot));
    const stewart_real theta_dot_err = L_dot_err*inv_rho_max*k1_max + L_dot_max*inv_rho_max*k1_err + S_dot_x_err*inv_rho_max*k_x_max
        + S_dot_x_max*inv_rho_max*k_x_err + S_dot_y_err*inv_rho_max*k_y_max + S_dot_y_max*inv_rho_max*k_y_err
        + S_dot_z_err*inv_rho_max*k_z_max + S_dot_z_max*inv_rho_max*k_z_err + inv_rho_err*(L_dot_max*k1_max
        + S_dot_x_max*k_x_max + S_dot_y_max*k_y_max + S_dot_z_max*k_z_max) + theta_dot_own;
    const stewart_real theta_dot_max = STEWART_FABS(theta_dot) + theta_dot_err;
    /* L_dot / L */
    const stewart_real L_share = L_dot*inv_L;
    const stewart_real L_share_own = STEWART_UNIT*STEWART_FABS(L_share);
    const stewart_real L_share_err = L_dot_err*inv_L_max + L_dot_max*inv_L_err + L_share_own;
    const stewart_real L_share_max = STEWART_FABS(L_share) + L_share_err;
    const stewart_real lean = kappa*theta_dot;
    const stewart_real lean_own = STEWART_UNIT*STEWART_FABS(lean);
    const stewart_real lean_err = kappa_err*theta_dot_max + kappa_max*theta_dot_err + lean_own;
    const stewart_real theta_dot2 = theta_dot*theta_dot;
    const stewart_real theta_dot2_own = STEWART_UNIT*STEWART_FABS(theta_dot2);
    const stewart_real theta_dot2_err = REAL(2)*theta_dot_err*theta_dot_max + theta_dot2_own;
    const stewart_real theta_dot2_max = STEWART_FABS(theta_dot2) + theta_dot2_err;
    const stewart_real phi_dot2 = phi_dot*phi_dot;
    const stewart_real phi_dot2_own = STEWART_UNIT*STEWART_FABS(phi_dot2);
    const stewart_real phi_dot2_err = REAL(2)*phi_dot_err*phi_dot_max + phi_dot2_own;
    const stewart_real phi_dot2_max = STEWART_FABS(phi_dot2) + phi_dot2_err;
    const stewart_real two_phi_dot = REAL(2)*phi_dot;
    const stewart_real two_phi_dot_err = REAL(2)*phi_dot_err;
    const stewart_real two_phi_dot_max = STEWART_FABS(two_phi_dot) + two_phi_dot_err;
    /* rho_dot / rho */
    const stewart_real rho_share = L_share + lean;
    const stewart_real rho_share_own = STEWART_UNIT*STEWART_FABS(rho_share);
    const stewart_real rho_share_err = L_share_err + lean_err + rho_share_own;
    const stewart_real rho_share_max = STEWART_FABS(rho_share) + rho_share_err;
    const stewart_real k33 = k3*k3;
    const stewart_real k33_own = STEWART_UNIT*STEWART_FABS(k33);
    const stewart_real k33_err = REAL(2)*k3_err*k3_max + k33_own;
    const stewart_real k33_max = STEWART_FABS(k33) + k33_err;
    /* (8) accelerations of the joint coordinates */
    const stewart_real L_ddot = L*(theta_dot2 + k33*phi_dot2) + S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z;
    const stewart_real L_ddot_own = STEWART_UNIT*(S_ddot_z_max*s_z_max + REAL(3)*S_ddot_x_max*s_x_max + REAL(2)*S_ddot_y_max*s_y_max
        + REAL(3)*L_max*(theta_dot2_max + k33_max*phi_dot2_max) + L_max*(theta_dot2_max + REAL(2)*k33_max*phi_dot2_max)
        + STEWART_FABS(L_ddot));
    const stewart_real L_ddot_err = L_max*theta_dot2_err + S_ddot_x_err*s_x_max + S_ddot_x_max*s_x_err + S_ddot_y_err*s_y_max
        + S_ddot_y_max*s_y_err + S_ddot_z_err*s_z_max + S_ddot_z_max*s_z_err + L_max*k33_err*phi_dot2_max + L_max*k33_max*phi_dot2_err
        + L_err*(theta_dot2_max + k33_max*phi_dot2_max) + L_ddot_own;
    const stewart_real L_ddot_max = STEWART_FABS(L_ddot) + L_ddot_err;
    /* (9) accelerations of the joint coordinates */
    const stewart_real theta_ddot = inv_rho*(L_ddot*k1 - S_ddot_x*k_x - S_ddot_y*k_y - S_ddot_z*k_z) - theta_dot*(L_share
        + rho_share);
    const stewart_real theta_ddot_own = STEWART_UNIT*(REAL(2)*theta_dot_max*(L_share_max + rho_share_max) + inv_rho_max*(L_ddot_max*k1_max
        + S_ddot_x_max*k_x_max + S_ddot_y_max*k_y_max + S_ddot_z_max*k_z_max) + inv_rho_max*(REAL(4)*L_ddot_max*k1_max
        + REAL(4)*S_ddot_x_max*k_x_max + REAL(3)*S_ddot_y_max*k_y_max + REAL(2)*S_ddot_z_max*k_z_max) + STEWART_FABS(theta_ddot));
    const stewart_real theta_ddot_err = L_share_err*theta_dot_max + rho_share_err*theta_dot_max + L_ddot_err*inv_rho_max*k1_max
        + L_ddot_max*inv_rho_max*k1_err + S_ddot_x_err*inv_rho_max*k_x_max + S_ddot_x_max*inv_rho_max*k_x_err
        + S_ddot_y_err*inv_rho_max*k_y_max + S_ddot_y_max*inv_rho_max*k_y_err + S_ddot_z_err*inv_rho_max*k_z_max
        + S_ddot_z_max*inv_rho_max*k_z_err + theta_dot_err*(L_share_max + rho_share_max) + inv_rho_err*(L_ddot_max*k1_max
        + S_ddot_x_max*k_x_max + S_ddot_y_max*k_y_max + S_ddot_z_max*k_z_max) + theta_ddot_own;
    const stewart_real theta_ddot_max = STEWART_FABS(theta_ddot) + theta_ddot_err;
    const stewart_real phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z) - rho_share*two_phi_dot;
    const stewart_real phi_ddot_own = STEWART_UNIT*(rho_share_max*two_phi_dot_max + inv_rho_max*(S_ddot_x_max*y_x_max
        + S_ddot_y_max*y_y_max + S_ddot_z_max*y_z_max) + inv_rho_max*(REAL(3)*S_ddot_x_max*y_x_max + REAL(3)*S_ddot_y_max*y_y_max
        + REAL(2)*S_ddot_z_max*y_z_max) + STEWART_FABS(phi_ddot));
    const stewart_real phi_ddot_err = rho_share_err*two_phi_dot_max + rho_share_max*two_phi_dot_err + S_ddot_x_err*inv_rho_max*y_x_max
        + S_ddot_x_max*inv_rho_max*y_x_err + S_ddot_y_err*inv_rho_max*y_y_max + S_ddot_y_max*inv_rho_max*y_y_err
        + S_ddot_z_err*inv_rho_max*y_z_max + S_ddot_z_max*inv_rho_max*y_z_err + inv_rho_err*(S_ddot_x_max*y_x_max
        + S_ddot_y_max*y_y_max + S_ddot_z_max*y_z_max) + phi_ddot_own;
    const stewart_real phi_ddot_max = STEWART_FABS(phi_ddot) + phi_ddot_err;
    const stewart_real k13 = k1*k3;
    const stewart_real k13_own = STEWART_UNIT*STEWART_FABS(k13);
    const stewart_real k13_err = k1_err*k3_max + k1_max*k3_err + k13_own;
    const stewart_real k13_max = STEWART_FABS(k13) + k13_err;
    const stewart_real L_h2 = L*h2_x;
    const stewart_real L_h2_own = STEWART_UNIT*STEWART_FABS(L_h2);
    const stewart_real L_h2_err = L_err*h2_x_max + L_max*h2_x_err + L_h2_own;
    const stewart_real a1 = dJ_zx + L_h2;
    const stewart_real a1_own = STEWART_UNIT*STEWART_FABS(a1);
    const stewart_real a1_err = L_h2_err + dJ_zx_err + a1_own;
    const stewart_real a1_max = STEWART_FABS(a1) + a1_err;
    const stewart_real a2 = J2_xz - L*h2_z;
    const stewart_real a2_own = STEWART_UNIT*(L_max*h2_z_max + STEWART_FABS(a2));
    const stewart_real a2_err = J2_xz_err + L_err*h2_z_max + L_max*h2_z_err + a2_own;
    const stewart_real a2_max = STEWART_FABS(a2) + a2_err;
    const stewart_real a3 = J_xy - L*h_y;
    const stewart_real a3_own = STEWART_UNIT*(L_max*h_y_max + STEWART_FABS(a3));
    const stewart_real a3_err = J_xy_err + L_err*h_y_max + L_max*h_y_err + a3_own;
    const stewart_real a3_max = STEWART_FABS(a3) + a3_err;
    /* (19) inertia of the joint coordinates */
    const stewart_real M_phi = J_xx + a1*k33 + a2*k13;
    const stewart_real M_phi_own = STEWART_UNIT*(J_xx_max + a2_max*k13_max + REAL(2)*a1_max*k33_max + STEWART_FABS(M_phi));
    const stewart_real M_phi_err = J_xx_err + a1_err*k33_max + a1_max*k33_err + a2_err*k13_max + a2_max*k13_err
        + M_phi_own;
    const stewart_real M_phi_max = STEWART_FABS(M_phi) + M_phi_err;
    const stewart_real M_theta = J_yy + L_h2;
    const stewart_real M_theta_own = STEWART_UNIT*STEWART_FABS(M_theta);
    const stewart_real M_theta_err = J_yy_err + L_h2_err + M_theta_own;
    const stewart_real M_theta_max = STEWART_FABS(M_theta) + M_theta_err;
    const stewart_real M_mixed = J_yz*k3 + a3*k1;
    const stewart_real M_mixed_own = STEWART_UNIT*(J_yz_max*k3_max + a3_max*k1_max + STEWART_FABS(M_mixed));
    const stewart_real M_mixed_err = J_yz_err*k3_max + J_yz_max*k3_err + a3_err*k1_max + a3_max*k1_err + M_mixed_own;
    const stewart_real M_mixed_max = STEWART_FABS(M_mixed) + M_mixed_err;
    const stewart_real k3_h = h_y*k3;
    const stewart_real k3_h_own = STEWART_UNIT*STEWART_FABS(k3_h);
    const stewart_real k3_h_err = h_y_err*k3_max + h_y_max*k3_err + k3_h_own;
    /* (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta */
    const stewart_real M_phi_theta = a2*(STEWART_HALF - k33) + a1*k13;
    const stewart_real M_phi_theta_own = STEWART_UNIT*(a1_max*k13_max + REAL(2)*a2_max*(k33_max + STEWART_HALF)
        + STEWART_FABS(M_phi_theta));
    const stewart_real M_phi_theta_err = a1_err*k13_max + a1_max*k13_err + a2_max*k33_err + a2_err*(k33_max
        + STEWART_HALF) + M_phi_theta_own;
    const stewart_real M_phi_theta_max = STEWART_FABS(M_phi_theta) + M_phi_theta_err;
    const stewart_real M_phi_L = h_x*k33 - h_z*k13;
    const stewart_real M_phi_L_own = STEWART_UNIT*(h_x_max*k33_max + h_z_max*k13_max + STEWART_FABS(M_phi_L));
    const stewart_real M_phi_L_err = h_x_err*k33_max + h_x_max*k33_err + h_z_err*k13_max + h_z_max*k13_err + M_phi_L_own;
    const stewart_real M_phi_L_max = STEWART_FABS(M_phi_L) + M_phi_L_err;
    const stewart_real M_mixed_theta = J_yz*k1 - a3*k3;
    const stewart_real M_mixed_theta_own = STEWART_UNIT*(J_yz_max*k1_max + a3_max*k3_max + STEWART_FABS(M_mixed_theta));
    const stewart_real M_mixed_theta_err = J_yz_err*k1_max + J_yz_max*k1_err + a3_err*k3_max + a3_max*k3_err
        + M_mixed_theta_own;
    const stewart_real M_mixed_theta_max = STEWART_FABS(M_mixed_theta) + M_mixed_theta_err;
    const stewart_real c1 = L_dot*theta_dot;
    const stewart_real c1_own = STEWART_UNIT*STEWART_FABS(c1);
    const stewart_real c1_err = L_dot_err*theta_dot_max + L_dot_max*theta_dot_err + c1_own;
    const stewart_real c1_max = STEWART_FABS(c1) + c1_err;
    const stewart_real bend = c1;
    const stewart_real bend_err = c1_err;
    const stewart_real bend_max = STEWART_FABS(bend) + bend_err;
    /* components of gravity along k x y and along y */
    const stewart_real gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z;
    const stewart_real gamma_n_own = STEWART_UNIT*(g_x_k_z_max*y_z_max + REAL(2)*g_x_k_x_max*y_x_max + REAL(2)*g_x_k_y_max*y_y_max
        + STEWART_FABS(gamma_n));
    const stewart_real gamma_n_err = g_x_k_x_err*y_x_max + g_x_k_x_max*y_x_err + g_x_k_y_err*y_y_max + g_x_k_y_max*y_y_err
        + g_x_k_z_err*y_z_max + g_x_k_z_max*y_z_err + gamma_n_own;
    const stewart_real gamma_n_max = STEWART_FABS(gamma_n) + gamma_n_err;
    const stewart_real gamma_y = g_x*y_x + g_y*y_y + g_z*y_z;
    const stewart_real gamma_y_own = STEWART_UNIT*(g_z_max*y_z_max + REAL(2)*g_x_max*y_x_max + REAL(2)*g_y_max*y_y_max
        + STEWART_FABS(gamma_y));
    const stewart_real gamma_y_err = g_x_max*y_x_err + g_y_max*y_y_err + g_z_max*y_z_err + gamma_y_own;
    const stewart_real gamma_y_max = STEWART_FABS(gamma_y) + gamma_y_err;
    /* components of the first moment along k and along -k x y */
    const stewart_real w_k = k3*w_z + k1*w_x;
    const stewart_real w_k_own = STEWART_UNIT*(k1_max*w_x_max + k3_max*w_z_max + STEWART_FABS(w_k));
    const stewart_real w_k_err = k1_err*w_x_max + k1_max*w_x_err + k3_err*w_z_max + k3_max*w_z_err + w_k_own;
    const stewart_real w_k_max = STEWART_FABS(w_k) + w_k_err;
    const stewart_real w_n = k3*w_x - k1*w_z;
    const stewart_real w_n_own = STEWART_UNIT*(k1_max*w_z_max + k3_max*w_x_max + STEWART_FABS(w_n));
    const stewart_real w_n_err = k1_err*w_z_max + k1_max*w_z_err + k3_err*w_x_max + k3_max*w_x_err + w_n_own;
    const stewart_real w_n_max = STEWART_FABS(w_n) + w_n_err;
    const stewart_real c2 = j_r*k3;
    const stewart_real c2_own = STEWART_UNIT*STEWART_FABS(c2);
    const stewart_real c2_err = j_r_max*k3_err + c2_own;
    const stewart_real c2_max = STEWART_FABS(c2) + c2_err;
    const stewart_real c3 = c2*phi_dot;
    const stewart_real c3_own = STEWART_UNIT*STEWART_FABS(c3);
    const stewart_real c3_err = c2_err*phi_dot_max + c2_max*phi_dot_err + c3_own;
    const stewart_real c3_max = STEWART_FABS(c3) + c3_err;
    const stewart_real c4 = j_r*k1 - k3_h;
    const stewart_real c4_own = STEWART_UNIT*(j_r_max*k1_max + STEWART_FABS(c4));
    const stewart_real c4_err = k3_h_err + j_r_max*k1_err + c4_own;
    const stewart_real c4_max = STEWART_FABS(c4) + c4_err;
    /* (20) generalized forces about y and about k */
    const stewart_real tau_y = L_ddot*h_z + g_k*w_n + gamma_n*w_k + C_us*theta_dot - C_s*(omega_x*y_x + omega_y*y_y
        + omega_z*y_z) - M_phi_theta*phi_dot2 + L_dot*c3 + bend*h2_x + M_mixed*phi_ddot + M_theta*theta_ddot;
    const stewart_real tau_y_own = STEWART_UNIT*(M_theta_max*theta_ddot_max + REAL(7)*C_us_max*theta_dot_max
        + REAL(9)*L_ddot_max*h_z_max + REAL(4)*L_dot_max*c3_max + REAL(2)*M_mixed_max*phi_ddot_max + REAL(5)*M_phi_theta_max*phi_dot2_max
        + REAL(3)*bend_max*h2_x_max + REAL(9)*g_k_max*w_n_max + REAL(8)*gamma_n_max*w_k_max + REAL(6)*C_s_max*(omega_x_max*y_x_max
        + omega_y_max*y_y_max + omega_z_max*y_z_max) + C_s_max*(REAL(3)*omega_x_max*y_x_max + REAL(3)*omega_y_max*y_y_max
        + REAL(2)*omega_z_max*y_z_max) + STEWART_FABS(tau_y));
    const stewart_real tau_y_err = C_us_err*theta_dot_max + C_us_max*theta_dot_err + L_ddot_err*h_z_max + L_ddot_max*h_z_err
        + L_dot_err*c3_max + L_dot_max*c3_err + M_mixed_err*phi_ddot_max + M_mixed_max*phi_ddot_err + M_phi_theta_err*phi_dot2_max
        + M_phi_theta_max*phi_dot2_err + M_theta_err*theta_ddot_max + M_theta_max*theta_ddot_err + bend_err*h2_x_max
        + bend_max*h2_x_err + g_k_err*w_n_max + g_k_max*w_n_err + gamma_n_err*w_k_max + gamma_n_max*w_k_err
        + C_s_max*omega_x_max*y_x_err + C_s_max*omega_y_max*y_y_err + C_s_max*omega_z_max*y_z_err + tau_y_own;
    const stewart_real tau_y_max = STEWART_FABS(tau_y) + tau_y_err;
    const stewart_real tau_k = L_ddot*c4 - C_s*(k_x*omega_x + k_y*omega_y + k_z*omega_z) + M_mixed_theta*theta_dot2
        + C_us*phi_dot - gamma_n*w_y - gamma_y*w_n - c1*c2 + two_phi_dot*(L_dot*M_phi_L + M_phi_theta*theta_dot)
        - bend*h2_y*k1 + M_phi*phi_ddot + M_mixed*theta_ddot;
    const stewart_real tau_k_own = STEWART_UNIT*(M_mixed_max*theta_ddot_max + REAL(8)*C_us_max*phi_dot_max + REAL(10)*L_ddot_max*c4_max
        + REAL(9)*M_mixed_theta_max*theta_dot2_max + REAL(2)*M_phi_max*phi_ddot_max + REAL(5)*c1_max*c2_max
        + REAL(7)*gamma_n_max*w_y_max + REAL(6)*gamma_y_max*w_n_max + REAL(4)*bend_max*h2_y_max*k1_max + REAL(4)*two_phi_dot_max*(L_dot_max*M_phi_L_max
        + M_phi_theta_max*theta_dot_max) + two_phi_dot_max*(REAL(2)*(L_dot_max*M_phi_L_max + M_phi_theta_max*theta_dot_max))
        + REAL(10)*C_s_max*(k_x_max*omega_x_max + k_y_max*omega_y_max + k_z_max*omega_z_max) + C_s_max*(REAL(3)*k_x_max*omega_x_max
        + REAL(3)*k_y_max*omega_y_max + REAL(2)*k_z_max*omega_z_max) + STEWART_FABS(tau_k));
    const stewart_real tau_k_err = C_us_err*phi_dot_max + C_us_max*phi_dot_err + L_ddot_err*c4_max + L_ddot_max*c4_err
        + M_mixed_err*theta_ddot_max + M_mixed_max*theta_ddot_err + M_mixed_theta_err*theta_dot2_max + M_mixed_theta_max*theta_dot2_err
        + M_phi_err*phi_ddot_max + M_phi_max*phi_ddot_err + c1_err*c2_max + c1_max*c2_err + gamma_n_err*w_y_max
        + gamma_n_max*w_y_err + gamma_y_err*w_n_max + gamma_y_max*w_n_err + C_s_max*k_x_err*omega_x_max + C_s_max*k_y_err*omega_y_max
        + C_s_max*k_z_err*omega_z_max + L_dot_err*M_phi_L_max*two_phi_dot_max + L_dot_max*M_phi_L_err*two_phi_dot_max
        + M_phi_theta_err*theta_dot_max*two_phi_dot_max + M_phi_theta_max*theta_dot_err*two_phi_dot_max + bend_err*h2_y_max*k1_max
        + bend_max*h2_y_err*k1_max + bend_max*h2_y_max*k1_err + two_phi_dot_err*(L_dot_max*M_phi_L_max + M_phi_theta_max*theta_dot_max)
        + tau_k_own;
    const stewart_real tau_k_max = STEWART_FABS(tau_k) + tau_k_err;
    /* (21) K = Q_k k + Q_y y, with a component along s */
    const stewart_real Q_k = -inv_rho*tau_y;
    const stewart_real Q_k_own = STEWART_UNIT*STEWART_FABS(Q_k);
    const stewart_real Q_k_err = inv_rho_err*tau_y_max + inv_rho_max*tau_y_err + Q_k_own;
    const stewart_real Q_k_max = STEWART_FABS(Q_k) + Q_k_err;
    const stewart_real Q_y = inv_rho*tau_k;
    const stewart_real Q_y_own = STEWART_UNIT*STEWART_FABS(Q_y);
    const stewart_real Q_y_err = inv_rho_err*tau_k_max + inv_rho_max*tau_k_err + Q_y_own;
    const stewart_real Q_y_max = STEWART_FABS(Q_y) + Q_y_err;
    /* (21) force at the spherical joint, base frame */
    const stewart_real K_x = Q_y*y_x + Q_k*k_x;
    const stewart_real K_x_own = STEWART_UNIT*(Q_k_max*k_x_max + Q_y_max*y_x_max + STEWART_FABS(K_x));
    const stewart_real K_x_err = Q_k_err*k_x_max + Q_k_max*k_x_err + Q_y_err*y_x_max + Q_y_max*y_x_err + K_x_own;
    const stewart_real K_y = Q_y*y_y + Q_k*k_y;
    const stewart_real K_y_own = STEWART_UNIT*(Q_k_max*k_y_max + Q_y_max*y_y_max + STEWART_FABS(K_y));
    const stewart_real K_y_err = Q_k_err*k_y_max + Q_k_max*k_y_err + Q_y_err*y_y_max + Q_y_max*y_y_err + K_y_own;
    const stewart_real K_z = Q_y*y_z + Q_k*k_z;
    const stewart_real K_z_own = STEWART_UNIT*(Q_k_max*k_z_max + Q_y_max*y_z_max + STEWART_FABS(K_z));
    const stewart_real K_z_err = Q_k_err*k_z_max + Q_k_max*k_z_err + Q_y_err*y_z_max + Q_y_max*y_z_err + K_z_own;
    /* (24) known part of the actuator force for this K */
    const stewart_real D = C_p*L_dot - h_x*theta_dot2 + L_ddot*m_r - M_phi_L*phi_dot2 - c3*theta_dot + c4*phi_ddot
        + h_z*theta_ddot - Q_k*k1;
    const stewart_real D_own = STEWART_UNIT*(Q_k_max*k1_max + REAL(7)*C_p_max*L_dot_max + REAL(6)*L_ddot_max*m_r_max
        + REAL(5)*M_phi_L_max*phi_dot2_max + REAL(4)*c3_max*theta_dot_max + REAL(3)*c4_max*phi_ddot_max + REAL(7)*h_x_max*theta_dot2_max
        + REAL(2)*h_z_max*theta_ddot_max + STEWART_FABS(D));
    const stewart_real c5 = C_s*phi_dot;
    const stewart_real c5_own = STEWART_UNIT*STEWART_FABS(c5);
    const stewart_real c5_err = C_s_max*phi_dot_err + c5_own;
    const stewart_real c5_max = STEWART_FABS(c5) + c5_err;
    const stewart_real c6 = C_s*theta_dot;
    const stewart_real c6_own = STEWART_UNIT*STEWART_FABS(c6);
    const stewart_real c6_err = C_s_max*theta_dot_err + c6_own;
    const stewart_real c6_max = STEWART_FABS(c6) + c6_err;
    const stewart_real H_force_x = s_x;
    const stewart_real H_force_x_err = s_x_err;
    const stewart_real H_force_x_max = STEWART_FABS(H_force_x) + H_force_x_err;
    const stewart_real H_force_y = s_y;
    const stewart_real H_force_y_err = s_y_err;
    const stewart_real H_force_y_max = STEWART_FABS(H_force_y) + H_force_y_err;
    const stewart_real H_force_z = s_z;
    const stewart_real H_force_z_err = s_z_err;
    const stewart_real H_force_z_max = STEWART_FABS(H_force_z) + H_force_z_err;
    const stewart_real c_force_x = -K_x;
    const stewart_real c_force_x_err = K_x_err;
    const stewart_real c_force_x_max = STEWART_FABS(c_force_x) + c_force_x_err;
    const stewart_real c_force_y = -K_y;
    const stewart_real c_force_y_err = K_y_err;
    const stewart_real c_force_y_max = STEWART_FABS(c_force_y) + c_force_y_err;
    const stewart_real c_force_z = -K_z;
    const stewart_real c_force_z_err = K_z_err;
    const stewart_real c_force_z_max = STEWART_FABS(c_force_z) + c_force_z_err;
    /* platform point from platform point 1 */
    const stewart_real arm_x = q_x - q_1_x;
    const stewart_real arm_x_own = STEWART_UNIT*STEWART_FABS(arm_x);
    const stewart_real arm_x_err = q_1_x_err + q_x_err + arm_x_own;
    const stewart_real arm_x_max = STEWART_FABS(arm_x) + arm_x_err;
    const stewart_real arm_y = q_y - q_1_y;
    const stewart_real arm_y_own = STEWART_UNIT*STEWART_FABS(arm_y);
    const stewart_real arm_y_err = q_1_y_err + q_y_err + arm_y_own;
    const stewart_real arm_y_max = STEWART_FABS(arm_y) + arm_y_err;
    const stewart_real arm_z = q_z - q_1_z;
    const stewart_real arm_z_own = STEWART_UNIT*STEWART_FABS(arm_z);
    const stewart_real arm_z_err = q_1_z_err + q_z_err + arm_z_own;
    const stewart_real arm_z_max = STEWART_FABS(arm_z) + arm_z_err;
    /* part of c, moment rows, base frame */
    const stewart_real c_moment_x = c5*k_x + c6*y_x;
    const stewart_real c_moment_x_own = STEWART_UNIT*(c5_max*k_x_max + c6_max*y_x_max + STEWART_FABS(c_moment_x));
    const stewart_real c_moment_x_err = c5_err*k_x_max + c5_max*k_x_err + c6_err*y_x_max + c6_max*y_x_err + c_moment_x_own;
    const stewart_real c_moment_y = c5*k_y + c6*y_y;
    const stewart_real c_moment_y_own = STEWART_UNIT*(c5_max*k_y_max + c6_max*y_y_max + STEWART_FABS(c_moment_y));
    const stewart_real c_moment_y_err = c5_err*k_y_max + c5_max*k_y_err + c6_err*y_y_max + c6_max*y_y_err + c_moment_y_own;
    const stewart_real c_moment_z = c5*k_z + c6*y_z;
    const stewart_real c_moment_z_own = STEWART_UNIT*(c5_max*k_z_max + c6_max*y_z_max + STEWART_FABS(c_moment_z));
    const stewart_real c_moment_z_err = c5_err*k_z_max + c5_max*k_z_err + c6_err*y_z_max + c6_max*y_z_err + c_moment_z_own;
    /* the leg's column of H, moment rows */
    const stewart_real H_moment_x = H_force_z*arm_y - H_force_y*arm_z;
    const stewart_real H_moment_x_own = STEWART_UNIT*(H_force_y_max*arm_z_max + H_force_z_max*arm_y_max + STEWART_FABS(H_moment_x));
    const stewart_real H_moment_x_err = H_force_y_err*arm_z_max + H_force_y_max*arm_z_err + H_force_z_err*arm_y_max
        + H_force_z_max*arm_y_err + H_moment_x_own;
    const stewart_real H_moment_y = H_force_x*arm_z - H_force_z*arm_x;
    const stewart_real H_moment_y_own = STEWART_UNIT*(H_force_x_max*arm_z_max + H_force_z_max*arm_x_max + STEWART_FABS(H_moment_y));
    const stewart_real H_moment_y_err = H_force_x_err*arm_z_max + H_force_x_max*arm_z_err + H_force_z_err*arm_x_max
        + H_force_z_max*arm_x_err + H_moment_y_own;
    const stewart_real H_moment_z = H_force_y*arm_x - H_force_x*arm_y;
    const stewart_real H_moment_z_own = STEWART_UNIT*(H_force_x_max*arm_y_max + H_force_y_max*arm_x_max + STEWART_FABS(H_moment_z));
    const stewart_real H_moment_z_err = H_force_x_err*arm_y_max + H_force_x_max*arm_y_err + H_force_y_err*arm_x_max
        + H_force_y_max*arm_x_err + H_moment_z_own;
    /* moment of the leg's part of c, force rows, about platform point 1 */
    const stewart_real arm_c_x = arm_y*c_force_z - arm_z*c_force_y;
    const stewart_real arm_c_x_own = STEWART_UNIT*(arm_y_max*c_force_z_max + arm_z_max*c_force_y_max + STEWART_FABS(arm_c_x));
    const stewart_real arm_c_x_err = arm_y_err*c_force_z_max + arm_y_max*c_force_z_err + arm_z_err*c_force_y_max
        + arm_z_max*c_force_y_err + arm_c_x_own;
    const stewart_real arm_c_y = arm_z*c_force_x - arm_x*c_force_z;
    const stewart_real arm_c_y_own = STEWART_UNIT*(arm_x_max*c_force_z_max + arm_z_max*c_force_x_max + STEWART_FABS(arm_c_y));
    const stewart_real arm_c_y_err = arm_x_err*c_force_z_max + arm_x_max*c_force_z_err + arm_z_err*c_force_x_max
        + arm_z_max*c_force_x_err + arm_c_y_own;
    const stewart_real arm_c_z = arm_x*c_force_y - arm_y*c_force_x;
    const stewart_real arm_c_z_own = STEWART_UNIT*(arm_x_max*c_force_y_max + arm_y_max*c_force_x_max + STEWART_FABS(arm_c_z));
    const stewart_real arm_c_z_err = arm_x_err*c_force_y_max + arm_x_max*c_force_y_err + arm_y_err*c_force_x_max
        + arm_y_max*c_force_x_err + arm_c_z_own;
    out->H_force[0] = H_force_x;
    out->H_force_err[0] = H_force_x_err;
    out->H_force[1] = H_force_y;
    out->H_force_err[1] = H_force_y_err;
    out->H_force[2] = H_force_z;
    out->H_force_err[2] = H_force_z_err;
    out->c_force[0] = c_force_x;
    out->c_force_err[0] = c_force_x_err;
    out->c_force[1] = c_force_y;
    out->c_force_err[1] = c_force_y_err;
    out->c_force[2] = c_force_z;
    out->c_force_err[2] = c_force_z_err;
    out->c_moment[0] = c_moment_x;
    out->c_moment_err[0] = c_moment_x_err;
    out->c_moment[1] = c_moment_y;
    out->c_moment_err[1] = c_moment_y_err;
    out->c_moment[2] = c_moment_z;
    out->c_moment_err[2] = c_moment_z_err;
    out->H_moment[0] = H_moment_x;
    out->H_moment_err[0] = H_moment_x_err;
    out->H_moment[1] = H_moment_y;
    out->H_moment_err[1] = H_moment_y_err;
    out->H_moment[2] = H_moment_z;
    out->H_moment_err[2] = H_moment_z_err;
    out->arm_c[0] = arm_c_x;
    out->arm_c_err[0] = arm_c_x_err;
    out->arm_c[1] = arm_c_y;
    out->arm_c_err[1] = arm_c_y_err;
    out->arm_c[2] = arm_c_z;
    out->arm_c_err[2] = arm_c_z_err;
    for (i = 0; i < LANES; ++i) {
        const stewart_real Y_force_x = rows->Y_force[0][i], Y_force_y = rows->Y_force[1][i], Y_force_z = rows->Y_force[2][i];
        const stewart_real Y_moment_x = rows->Y_moment[0][i], Y_moment_y = rows->Y_moment[1][i], Y_moment_z = rows->Y_moment[2][i];
        const stewart_real Y_arm_x = rows->Y_arm[0][i], Y_arm_y = rows->Y_arm[1][i], Y_arm_z = rows->Y_arm[2][i];
        const stewart_real D_weight = rows->D_weight[i];
        const stewart_real x = rows->x[i];
        const stewart_real Y_force_x_max = STEWART_FABS(Y_force_x);
        const stewart_real Y_force_y_max = STEWART_FABS(Y_force_y);
        const stewart_real Y_force_z_max = STEWART_FABS(Y_force_z);
        const stewart_real Y_moment_x_max = STEWART_FABS(Y_moment_x);
        const stewart_real Y_moment_y_max = STEWART_FABS(Y_moment_y);
        const stewart_real Y_moment_z_max = STEWART_FABS(Y_moment_z);
        const stewart_real Y_arm_x_max = STEWART_FABS(Y_arm_x);
        const stewart_real Y_arm_y_max = STEWART_FABS(Y_arm_y);
        const stewart_real Y_arm_z_max = STEWART_FABS(Y_arm_z);
        const stewart_real D_weight_max = STEWART_FABS(D_weight);
        const stewart_real H_force_x_weight = Y_force_x*x;
        const stewart_real H_force_x_weight_err = STEWART_UNIT*STEWART_FABS(H_force_x_weight);
        const stewart_real H_force_x_weight_max = STEWART_FABS(H_force_x_weight) + H_force_x_weight_err;
        const stewart_real H_force_y_weight = Y_force_y*x;
        const stewart_real H_force_y_weight_err = STEWART_UNIT*STEWART_FABS(H_force_y_weight);
        const stewart_real H_force_y_weight_max = STEWART_FABS(H_force_y_weight) + H_force_y_weight_err;
        const stewart_real H_force_z_weight = Y_force_z*x;
        const stewart_real H_force_z_weight_err = STEWART_UNIT*STEWART_FABS(H_force_z_weight);
        const stewart_real H_force_z_weight_max = STEWART_FABS(H_force_z_weight) + H_force_z_weight_err;
        const stewart_real H_moment_x_weight = Y_arm_x*x;
        const stewart_real H_moment_x_weight_err = STEWART_UNIT*STEWART_FABS(H_moment_x_weight);
        const stewart_real H_moment_x_weight_max = STEWART_FABS(H_moment_x_weight) + H_moment_x_weight_err;
        const stewart_real H_moment_y_weight = Y_arm_y*x;
        const stewart_real H_moment_y_weight_err = STEWART_UNIT*STEWART_FABS(H_moment_y_weight);
        const stewart_real H_moment_y_weight_max = STEWART_FABS(H_moment_y_weight) + H_moment_y_weight_err;
        const stewart_real H_moment_z_weight = Y_arm_z*x;
        const stewart_real H_moment_z_weight_err = STEWART_UNIT*STEWART_FABS(H_moment_z_weight);
        const stewart_real H_moment_z_weight_max = STEWART_FABS(H_moment_z_weight) + H_moment_z_weight_err;
        const stewart_real arm_z_bar = Y_arm_x*c_force_y + H_force_x*H_moment_y_weight - Y_arm_y*c_force_x - H_force_y*H_moment_x_weight;
        const stewart_real arm_z_bar_err = H_force_x_err*H_moment_y_weight_max + H_force_x_max*H_moment_y_weight_err
            + H_force_y_err*H_moment_x_weight_max + H_force_y_max*H_moment_x_weight_err + Y_arm_x_max*c_force_y_err
            + Y_arm_y_max*c_force_x_err + STEWART_UNIT*(H_force_y_max*H_moment_x_weight_max + REAL(3)*H_force_x_max*H_moment_y_weight_max
            + REAL(3)*Y_arm_x_max*c_force_y_max + REAL(2)*Y_arm_y_max*c_force_x_max + STEWART_FABS(arm_z_bar));
        const stewart_real arm_z_bar_max = STEWART_FABS(arm_z_bar) + arm_z_bar_err;
        const stewart_real arm_y_bar = Y_arm_z*c_force_x + H_force_z*H_moment_x_weight - Y_arm_x*c_force_z - H_force_x*H_moment_z_weight;
        const stewart_real arm_y_bar_err = H_force_x_err*H_moment_z_weight_max + H_force_x_max*H_moment_z_weight_err
            + H_force_z_err*H_moment_x_weight_max + H_force_z_max*H_moment_x_weight_err + Y_arm_x_max*c_force_z_err
            + Y_arm_z_max*c_force_x_err + STEWART_UNIT*(H_force_x_max*H_moment_z_weight_max + REAL(3)*H_force_z_max*H_moment_x_weight_max
            + REAL(2)*Y_arm_x_max*c_force_z_max + REAL(3)*Y_arm_z_max*c_force_x_max + STEWART_FABS(arm_y_bar));
        const stewart_real arm_y_bar_max = STEWART_FABS(arm_y_bar) + arm_y_bar_err;
        const stewart_real arm_x_bar = Y_arm_y*c_force_z + H_force_y*H_moment_z_weight - Y_arm_z*c_force_y - H_force_z*H_moment_y_weight;
        const stewart_real arm_x_bar_err = H_force_y_err*H_moment_z_weight_max + H_force_y_max*H_moment_z_weight_err
            + H_force_z_err*H_moment_y_weight_max + H_force_z_max*H_moment_y_weight_err + Y_arm_y_max*c_force_z_err
            + Y_arm_z_max*c_force_y_err + STEWART_UNIT*(H_force_z_max*H_moment_y_weight_max + REAL(3)*H_force_y_max*H_moment_z_weight_max
            + REAL(3)*Y_arm_y_max*c_force_z_max + REAL(2)*Y_arm_z_max*c_force_y_max + STEWART_FABS(arm_x_bar));
        const stewart_real arm_x_bar_max = STEWART_FABS(arm_x_bar) + arm_x_bar_err;
        const stewart_real c_force_z_bar = Y_arm_y*arm_x - Y_force_z - Y_arm_x*arm_y;
        const stewart_real c_force_z_bar_err = Y_arm_x_max*arm_y_err + Y_arm_y_max*arm_x_err + STEWART_UNIT*(Y_force_z_max
            + Y_arm_x_max*arm_y_max + REAL(2)*Y_arm_y_max*arm_x_max + STEWART_FABS(c_force_z_bar));
        const stewart_real c_force_z_bar_max = STEWART_FABS(c_force_z_bar) + c_force_z_bar_err;
        const stewart_real c_force_y_bar = Y_arm_x*arm_z - Y_force_y - Y_arm_z*arm_x;
        const stewart_real c_force_y_bar_err = Y_arm_x_max*arm_z_err + Y_arm_z_max*arm_x_err + STEWART_UNIT*(Y_force_y_max
            + Y_arm_z_max*arm_x_max + REAL(2)*Y_arm_x_max*arm_z_max + STEWART_FABS(c_force_y_bar));
        const stewart_real c_force_y_bar_max = STEWART_FABS(c_force_y_bar) + c_force_y_bar_err;
        const stewart_real c_force_x_bar = Y_arm_z*arm_y - Y_force_x - Y_arm_y*arm_z;
        const stewart_real c_force_x_bar_err = Y_arm_y_max*arm_z_err + Y_arm_z_max*arm_y_err + STEWART_UNIT*(Y_force_x_max
            + Y_arm_y_max*arm_z_max + REAL(2)*Y_arm_z_max*arm_y_max + STEWART_FABS(c_force_x_bar));
        const stewart_real c_force_x_bar_max = STEWART_FABS(c_force_x_bar) + c_force_x_bar_err;
        const stewart_real H_force_z_bar = H_force_z_weight + H_moment_x_weight*arm_y - H_moment_y_weight*arm_x;
        const stewart_real H_force_z_bar_err = H_force_z_weight_err + H_moment_x_weight_err*arm_y_max + H_moment_x_weight_max*arm_y_err
            + H_moment_y_weight_err*arm_x_max + H_moment_y_weight_max*arm_x_err + STEWART_UNIT*(H_force_z_weight_max
            + H_moment_y_weight_max*arm_x_max + REAL(2)*H_moment_x_weight_max*arm_y_max + STEWART_FABS(H_force_z_bar));
        const stewart_real H_force_z_bar_max = STEWART_FABS(H_force_z_bar) + H_force_z_bar_err;
        const stewart_real H_force_y_bar = H_force_y_weight + H_moment_z_weight*arm_x - H_moment_x_weight*arm_z;
        const stewart_real H_force_y_bar_err = H_force_y_weight_err + H_moment_x_weight_err*arm_z_max + H_moment_x_weight_max*arm_z_err
            + H_moment_z_weight_err*arm_x_max + H_moment_z_weight_max*arm_x_err + STEWART_UNIT*(H_force_y_weight_max
            + H_moment_x_weight_max*arm_z_max + REAL(2)*H_moment_z_weight_max*arm_x_max + STEWART_FABS(H_force_y_bar));
        const stewart_real H_force_y_bar_max = STEWART_FABS(H_force_y_bar) + H_force_y_bar_err;
        const stewart_real H_force_x_bar = H_force_x_weight + H_moment_y_weight*arm_z - H_moment_z_weight*arm_y;
        const stewart_real H_force_x_bar_err = H_force_x_weight_err + H_moment_y_weight_err*arm_z_max + H_moment_y_weight_max*arm_z_err
            + H_moment_z_weight_err*arm_y_max + H_moment_z_weight_max*arm_y_err + STEWART_UNIT*(H_force_x_weight_max
            + H_moment_z_weight_max*arm_y_max + REAL(2)*H_moment_y_weight_max*arm_z_max + STEWART_FABS(H_force_x_bar));
        const stewart_real H_force_x_bar_max = STEWART_FABS(H_force_x_bar) + H_force_x_bar_err;
        const stewart_real c6_bar = -Y_moment_x*y_x - Y_moment_y*y_y - Y_moment_z*y_z;
        const stewart_real c6_bar_err = Y_moment_x_max*y_x_err + Y_moment_y_max*y_y_err + Y_moment_z_max*y_z_err
            + STEWART_UNIT*(Y_moment_z_max*y_z_max + REAL(2)*Y_moment_x_max*y_x_max + REAL(2)*Y_moment_y_max*y_y_max
            + STEWART_FABS(c6_bar));
        const stewart_real c6_bar_max = STEWART_FABS(c6_bar) + c6_bar_err;
        const stewart_real c5_bar = -Y_moment_x*k_x - Y_moment_y*k_y - Y_moment_z*k_z;
        const stewart_real c5_bar_err = Y_moment_x_max*k_x_err + Y_moment_y_max*k_y_err + Y_moment_z_max*k_z_err
            + STEWART_UNIT*(Y_moment_z_max*k_z_max + REAL(2)*Y_moment_x_max*k_x_max + REAL(2)*Y_moment_y_max*k_y_max
            + STEWART_FABS(c5_bar));
        const stewart_real c5_bar_max = STEWART_FABS(c5_bar) + c5_bar_err;
        const stewart_real Q_y_bar = -c_force_x_bar*y_x - c_force_y_bar*y_y - c_force_z_bar*y_z;
        const stewart_real Q_y_bar_err = c_force_x_bar_err*y_x_max + c_force_x_bar_max*y_x_err + c_force_y_bar_err*y_y_max
            + c_force_y_bar_max*y_y_err + c_force_z_bar_err*y_z_max + c_force_z_bar_max*y_z_err + STEWART_UNIT*(c_force_z_bar_max*y_z_max
            + REAL(2)*c_force_x_bar_max*y_x_max + REAL(2)*c_force_y_bar_max*y_y_max + STEWART_FABS(Q_y_bar));
        const stewart_real Q_y_bar_max = STEWART_FABS(Q_y_bar) + Q_y_bar_err;
        const stewart_real Q_k_bar = -D_weight*k1 - c_force_x_bar*k_x - c_force_y_bar*k_y - c_force_z_bar*k_z;
        const stewart_real Q_k_bar_err = D_weight_max*k1_err + c_force_x_bar_err*k_x_max + c_force_x_bar_max*k_x_err
            + c_force_y_bar_err*k_y_max + c_force_y_bar_max*k_y_err + c_force_z_bar_err*k_z_max + c_force_z_bar_max*k_z_err
            + STEWART_UNIT*(c_force_z_bar_max*k_z_max + REAL(3)*D_weight_max*k1_max + REAL(3)*c_force_x_bar_max*k_x_max
            + REAL(2)*c_force_y_bar_max*k_y_max + STEWART_FABS(Q_k_bar));
        const stewart_real Q_k_bar_max = STEWART_FABS(Q_k_bar) + Q_k_bar_err;
        const stewart_real tau_k_bar = Q_y_bar*inv_rho;
        const stewart_real tau_k_bar_err = Q_y_bar_err*inv_rho_max + Q_y_bar_max*inv_rho_err + STEWART_UNIT*STEWART_FABS(tau_k_bar);
        const stewart_real tau_k_bar_max = STEWART_FABS(tau_k_bar) + tau_k_bar_err;
        const stewart_real tau_y_bar = -Q_k_bar*inv_rho;
        const stewart_real tau_y_bar_err = Q_k_bar_err*inv_rho_max + Q_k_bar_max*inv_rho_err + STEWART_UNIT*STEWART_FABS(tau_y_bar);
        const stewart_real tau_y_bar_max = STEWART_FABS(tau_y_bar) + tau_y_bar_err;
        const stewart_real c4_bar = D_weight*phi_ddot + L_ddot*tau_k_bar;
        const stewart_real c4_bar_err = D_weight_max*phi_ddot_err + L_ddot_err*tau_k_bar_max + L_ddot_max*tau_k_bar_err
            + STEWART_UNIT*(D_weight_max*phi_ddot_max + L_ddot_max*tau_k_bar_max + STEWART_FABS(c4_bar));
        const stewart_real c4_bar_max = STEWART_FABS(c4_bar) + c4_bar_err;
        const stewart_real c3_bar = L_dot*tau_y_bar - D_weight*theta_dot;
        const stewart_real c3_bar_err = D_weight_max*theta_dot_err + L_dot_err*tau_y_bar_max + L_dot_max*tau_y_bar_err
            + STEWART_UNIT*(D_weight_max*theta_dot_max + L_dot_max*tau_y_bar_max + STEWART_FABS(c3_bar));
        const stewart_real c3_bar_max = STEWART_FABS(c3_bar) + c3_bar_err;
        const stewart_real c2_bar = c3_bar*phi_dot - c1*tau_k_bar;
        const stewart_real c2_bar_err = c1_err*tau_k_bar_max + c1_max*tau_k_bar_err + c3_bar_err*phi_dot_max
            + c3_bar_max*phi_dot_err + STEWART_UNIT*(c1_max*tau_k_bar_max + c3_bar_max*phi_dot_max + STEWART_FABS(c2_bar));
        const stewart_real c2_bar_max = STEWART_FABS(c2_bar) + c2_bar_err;
        const stewart_real w_n_bar = g_k*tau_y_bar - gamma_y*tau_k_bar;
        const stewart_real w_n_bar_err = g_k_err*tau_y_bar_max + g_k_max*tau_y_bar_err + gamma_y_err*tau_k_bar_max
            + gamma_y_max*tau_k_bar_err + STEWART_UNIT*(g_k_max*tau_y_bar_max + gamma_y_max*tau_k_bar_max + STEWART_FABS(w_n_bar));
        const stewart_real w_n_bar_max = STEWART_FABS(w_n_bar) + w_n_bar_err;
        const stewart_real w_k_bar = gamma_n*tau_y_bar;
        const stewart_real w_k_bar_err = gamma_n_err*tau_y_bar_max + gamma_n_max*tau_y_bar_err + STEWART_UNIT*STEWART_FABS(w_k_bar);
        const stewart_real w_k_bar_max = STEWART_FABS(w_k_bar) + w_k_bar_err;
        const stewart_real gamma_y_bar = -tau_k_bar*w_n;
        const stewart_real gamma_y_bar_err = tau_k_bar_err*w_n_max + tau_k_bar_max*w_n_err + STEWART_UNIT*STEWART_FABS(gamma_y_bar);
        const stewart_real gamma_y_bar_max = STEWART_FABS(gamma_y_bar) + gamma_y_bar_err;
        const stewart_real gamma_n_bar = tau_y_bar*w_k - tau_k_bar*w_y;
        const stewart_real gamma_n_bar_err = tau_k_bar_err*w_y_max + tau_k_bar_max*w_y_err + tau_y_bar_err*w_k_max
            + tau_y_bar_max*w_k_err + STEWART_UNIT*(tau_k_bar_max*w_y_max + tau_y_bar_max*w_k_max + STEWART_FABS(gamma_n_bar));
        const stewart_real gamma_n_bar_max = STEWART_FABS(gamma_n_bar) + gamma_n_bar_err;
        const stewart_real c7 = h2_y*tau_k_bar;
        const stewart_real c7_err = h2_y_err*tau_k_bar_max + h2_y_max*tau_k_bar_err + STEWART_UNIT*STEWART_FABS(c7);
        const stewart_real c7_max = STEWART_FABS(c7) + c7_err;
        const stewart_real bend_bar = h2_x*tau_y_bar - c7*k1;
        const stewart_real bend_bar_err = c7_err*k1_max + c7_max*k1_err + h2_x_err*tau_y_bar_max + h2_x_max*tau_y_bar_err
            + STEWART_UNIT*(c7_max*k1_max + h2_x_max*tau_y_bar_max + STEWART_FABS(bend_bar));
        const stewart_real c1_bar = bend_bar - c2*tau_k_bar;
        const stewart_real c1_bar_err = bend_bar_err + c2_err*tau_k_bar_max + c2_max*tau_k_bar_err + STEWART_UNIT*(c2_max*tau_k_bar_max
            + STEWART_FABS(c1_bar));
        const stewart_real c1_bar_max = STEWART_FABS(c1_bar) + c1_bar_err;
        const stewart_real M_mixed_theta_bar = tau_k_bar*theta_dot2;
        const stewart_real M_mixed_theta_bar_err = tau_k_bar_err*theta_dot2_max + tau_k_bar_max*theta_dot2_err
            + STEWART_UNIT*STEWART_FABS(M_mixed_theta_bar);
        const stewart_real M_mixed_theta_bar_max = STEWART_FABS(M_mixed_theta_bar) + M_mixed_theta_bar_err;
        const stewart_real M_phi_L_bar = L_dot*tau_k_bar*two_phi_dot - D_weight*phi_dot2;
        const stewart_real M_phi_L_bar_err = D_weight_max*phi_dot2_err + L_dot_err*tau_k_bar_max*two_phi_dot_max
            + L_dot_max*tau_k_bar_err*two_phi_dot_max + L_dot_max*tau_k_bar_max*two_phi_dot_err + STEWART_UNIT*(D_weight_max*phi_dot2_max
            + REAL(2)*L_dot_max*tau_k_bar_max*two_phi_dot_max + STEWART_FABS(M_phi_L_bar));
        const stewart_real M_phi_L_bar_max = STEWART_FABS(M_phi_L_bar) + M_phi_L_bar_err;
        const stewart_real M_phi_theta_bar = tau_k_bar*theta_dot*two_phi_dot - phi_dot2*tau_y_bar;
        const stewart_real M_phi_theta_bar_err = phi_dot2_err*tau_y_bar_max + phi_dot2_max*tau_y_bar_err + tau_k_bar_err*theta_dot_max*two_phi_dot_max
            + tau_k_bar_max*theta_dot_err*two_phi_dot_max + tau_k_bar_max*theta_dot_max*two_phi_dot_err + STEWART_UNIT*(phi_dot2_max*tau_y_bar_max
            + REAL(2)*tau_k_bar_max*theta_dot_max*two_phi_dot_max + STEWART_FABS(M_phi_theta_bar));
        const stewart_real M_phi_theta_bar_max = STEWART_FABS(M_phi_theta_bar) + M_phi_theta_bar_err;
        const stewart_real M_mixed_bar = tau_k_bar*theta_ddot + phi_ddot*tau_y_bar;
        const stewart_real M_mixed_bar_err = phi_ddot_err*tau_y_bar_max + phi_ddot_max*tau_y_bar_err + tau_k_bar_err*theta_ddot_max
            + tau_k_bar_max*theta_ddot_err + STEWART_UNIT*(phi_ddot_max*tau_y_bar_max + tau_k_bar_max*theta_ddot_max
            + STEWART_FABS(M_mixed_bar));
        const stewart_real M_mixed_bar_max = STEWART_FABS(M_mixed_bar) + M_mixed_bar_err;
        const stewart_real M_theta_bar = tau_y_bar*theta_ddot;
        const stewart_real M_theta_bar_err = tau_y_bar_err*theta_ddot_max + tau_y_bar_max*theta_ddot_err + STEWART_UNIT*STEWART_FABS(M_theta_bar);
        const stewart_real M_theta_bar_max = STEWART_FABS(M_theta_bar) + M_theta_bar_err;
        const stewart_real M_phi_bar = phi_ddot*tau_k_bar;
        const stewart_real M_phi_bar_err = phi_ddot_err*tau_k_bar_max + phi_ddot_max*tau_k_bar_err + STEWART_UNIT*STEWART_FABS(M_phi_bar);
        const stewart_real M_phi_bar_max = STEWART_FABS(M_phi_bar) + M_phi_bar_err;
        const stewart_real a3_bar = M_mixed_bar*k1 - M_mixed_theta_bar*k3;
        const stewart_real a3_bar_err = M_mixed_bar_err*k1_max + M_mixed_bar_max*k1_err + M_mixed_theta_bar_err*k3_max
            + M_mixed_theta_bar_max*k3_err + STEWART_UNIT*(M_mixed_bar_max*k1_max + M_mixed_theta_bar_max*k3_max
            + STEWART_FABS(a3_bar));
        const stewart_real a3_bar_max = STEWART_FABS(a3_bar) + a3_bar_err;
        const stewart_real a2_bar = M_phi_bar*k13 + M_phi_theta_bar*(STEWART_HALF - k33);
        const stewart_real a2_bar_err = M_phi_bar_err*k13_max + M_phi_bar_max*k13_err + M_phi_theta_bar_max*k33_err
            + M_phi_theta_bar_err*(k33_max + STEWART_HALF) + STEWART_UNIT*(M_phi_bar_max*k13_max + REAL(2)*M_phi_theta_bar_max*(k33_max
            + STEWART_HALF) + STEWART_FABS(a2_bar));
        const stewart_real a2_bar_max = STEWART_FABS(a2_bar) + a2_bar_err;
        const stewart_real a1_bar = M_phi_bar*k33 + M_phi_theta_bar*k13;
        const stewart_real a1_bar_err = M_phi_bar_err*k33_max + M_phi_bar_max*k33_err + M_phi_theta_bar_err*k13_max
            + M_phi_theta_bar_max*k13_err + STEWART_UNIT*(M_phi_bar_max*k33_max + M_phi_theta_bar_max*k13_max
            + STEWART_FABS(a1_bar));
        const stewart_real a1_bar_max = STEWART_FABS(a1_bar) + a1_bar_err;
        const stewart_real L_h2_bar = M_theta_bar + a1_bar;
        const stewart_real L_h2_bar_err = M_theta_bar_err + a1_bar_err + STEWART_UNIT*STEWART_FABS(L_h2_bar);
        const stewart_real L_h2_bar_max = STEWART_FABS(L_h2_bar) + L_h2_bar_err;
        const stewart_real k13_bar = M_phi_bar*a2 + M_phi_theta_bar*a1 - M_phi_L_bar*h_z;
        const stewart_real k13_bar_err = M_phi_L_bar_err*h_z_max + M_phi_L_bar_max*h_z_err + M_phi_bar_err*a2_max
            + M_phi_bar_max*a2_err + M_phi_theta_bar_err*a1_max + M_phi_theta_bar_max*a1_err + STEWART_UNIT*(M_phi_L_bar_max*h_z_max
            + REAL(2)*M_phi_bar_max*a2_max + REAL(2)*M_phi_theta_bar_max*a1_max + STEWART_FABS(k13_bar));
        const stewart_real k13_bar_max = STEWART_FABS(k13_bar) + k13_bar_err;
        const stewart_real phi_ddot_bar = D_weight*c4 + M_phi*tau_k_bar + M_mixed*tau_y_bar;
        const stewart_real phi_ddot_bar_err = D_weight_max*c4_err + M_mixed_err*tau_y_bar_max + M_mixed_max*tau_y_bar_err
            + M_phi_err*tau_k_bar_max + M_phi_max*tau_k_bar_err + STEWART_UNIT*(M_mixed_max*tau_y_bar_max + REAL(2)*D_weight_max*c4_max
            + REAL(2)*M_phi_max*tau_k_bar_max + STEWART_FABS(phi_ddot_bar));
        const stewart_real phi_ddot_bar_max = STEWART_FABS(phi_ddot_bar) + phi_ddot_bar_err;
        const stewart_real theta_ddot_bar = D_weight*h_z + M_mixed*tau_k_bar + M_theta*tau_y_bar;
        const stewart_real theta_ddot_bar_err = D_weight_max*h_z_err + M_mixed_err*tau_k_bar_max + M_mixed_max*tau_k_bar_err
            + M_theta_err*tau_y_bar_max + M_theta_max*tau_y_bar_err + STEWART_UNIT*(M_theta_max*tau_y_bar_max
            + REAL(2)*D_weight_max*h_z_max + REAL(2)*M_mixed_max*tau_k_bar_max + STEWART_FABS(theta_ddot_bar));
        const stewart_real theta_ddot_bar_max = STEWART_FABS(theta_ddot_bar) + theta_ddot_bar_err;
        const stewart_real c8 = inv_rho*k1;
        const stewart_real c8_err = inv_rho_err*k1_max + inv_rho_max*k1_err + STEWART_UNIT*STEWART_FABS(c8);
        const stewart_real c8_max = STEWART_FABS(c8) + c8_err;
        const stewart_real L_ddot_bar = D_weight*m_r + c4*tau_k_bar + h_z*tau_y_bar + c8*theta_ddot_bar;
        const stewart_real L_ddot_bar_err = c4_err*tau_k_bar_max + c4_max*tau_k_bar_err + c8_err*theta_ddot_bar_max
            + c8_max*theta_ddot_bar_err + h_z_err*tau_y_bar_max + h_z_max*tau_y_bar_err + STEWART_UNIT*(c8_max*theta_ddot_bar_max
            + REAL(3)*D_weight_max*m_r_max + REAL(3)*c4_max*tau_k_bar_max + REAL(2)*h_z_max*tau_y_bar_max + STEWART_FABS(L_ddot_bar));
        const stewart_real L_ddot_bar_max = STEWART_FABS(L_ddot_bar) + L_ddot_bar_err;
        const stewart_real c9 = L*L_ddot_bar;
        const stewart_real c9_err = L_ddot_bar_err*L_max + L_ddot_bar_max*L_err + STEWART_UNIT*STEWART_FABS(c9);
        const stewart_real c9_max = STEWART_FABS(c9) + c9_err;
        const stewart_real k33_bar = M_phi_bar*a1 + M_phi_L_bar*h_x - M_phi_theta_bar*a2 + c9*phi_dot2;
        const stewart_real k33_bar_err = M_phi_L_bar_err*h_x_max + M_phi_L_bar_max*h_x_err + M_phi_bar_err*a1_max
            + M_phi_bar_max*a1_err + M_phi_theta_bar_err*a2_max + M_phi_theta_bar_max*a2_err + c9_err*phi_dot2_max
            + c9_max*phi_dot2_err + STEWART_UNIT*(c9_max*phi_dot2_max + REAL(3)*M_phi_L_bar_max*h_x_max + REAL(3)*M_phi_bar_max*a1_max
            + REAL(2)*M_phi_theta_bar_max*a2_max + STEWART_FABS(k33_bar));
        const stewart_real k33_bar_max = STEWART_FABS(k33_bar) + k33_bar_err;
        const stewart_real c10 = theta_ddot_bar*theta_dot;
        const stewart_real c10_err = theta_ddot_bar_err*theta_dot_max + theta_ddot_bar_max*theta_dot_err + STEWART_UNIT*STEWART_FABS(c10);
        const stewart_real rho_share_bar = -c10 - phi_ddot_bar*two_phi_dot;
        const stewart_real rho_share_bar_err = c10_err + phi_ddot_bar_err*two_phi_dot_max + phi_ddot_bar_max*two_phi_dot_err
            + STEWART_UNIT*(phi_ddot_bar_max*two_phi_dot_max + STEWART_FABS(rho_share_bar));
        const stewart_real rho_share_bar_max = STEWART_FABS(rho_share_bar) + rho_share_bar_err;
        const stewart_real two_phi_dot_bar = tau_k_bar*(L_dot*M_phi_L + M_phi_theta*theta_dot) - phi_ddot_bar*rho_share;
        const stewart_real two_phi_dot_bar_err = phi_ddot_bar_err*rho_share_max + phi_ddot_bar_max*rho_share_err
            + L_dot_err*M_phi_L_max*tau_k_bar_max + L_dot_max*M_phi_L_err*tau_k_bar_max + M_phi_theta_err*tau_k_bar_max*theta_dot_max
            + M_phi_theta_max*tau_k_bar_max*theta_dot_err + tau_k_bar_err*(L_dot_max*M_phi_L_max + M_phi_theta_max*theta_dot_max)
            + STEWART_UNIT*(phi_ddot_bar_max*rho_share_max + tau_k_bar_max*(L_dot_max*M_phi_L_max + M_phi_theta_max*theta_dot_max)
            + tau_k_bar_max*(REAL(2)*(L_dot_max*M_phi_L_max + M_phi_theta_max*theta_dot_max)) + STEWART_FABS(two_phi_dot_bar));
        const stewart_real two_phi_dot_bar_max = STEWART_FABS(two_phi_dot_bar) + two_phi_dot_bar_err;
        const stewart_real phi_dot2_bar = L*L_ddot_bar*k33 - D_weight*M_phi_L - M_phi_theta*tau_y_bar;
        const stewart_real phi_dot2_bar_err = D_weight_max*M_phi_L_err + M_phi_theta_err*tau_y_bar_max + M_phi_theta_max*tau_y_bar_err
            + L_ddot_bar_err*L_max*k33_max + L_ddot_bar_max*L_err*k33_max + L_ddot_bar_max*L_max*k33_err + STEWART_UNIT*(M_phi_theta_max*tau_y_bar_max
            + REAL(2)*D_weight_max*M_phi_L_max + REAL(3)*L_ddot_bar_max*L_max*k33_max + STEWART_FABS(phi_dot2_bar));
        const stewart_real phi_dot2_bar_max = STEWART_FABS(phi_dot2_bar) + phi_dot2_bar_err;
        const stewart_real theta_dot2_bar = M_mixed_theta*tau_k_bar - D_weight*h_x + c9;
        const stewart_real theta_dot2_bar_err = c9_err + D_weight_max*h_x_err + M_mixed_theta_err*tau_k_bar_max
            + M_mixed_theta_max*tau_k_bar_err + STEWART_UNIT*(REAL(2)*(D_weight_max*h_x_max + M_mixed_theta_max*tau_k_bar_max)
            + STEWART_FABS(theta_dot2_bar));
        const stewart_real theta_dot2_bar_max = STEWART_FABS(theta_dot2_bar) + theta_dot2_bar_err;
        const stewart_real L_share_bar = rho_share_bar - c10;
        const stewart_real L_share_bar_err = c10_err + rho_share_bar_err + STEWART_UNIT*STEWART_FABS(L_share_bar);
        const stewart_real L_share_bar_max = STEWART_FABS(L_share_bar) + L_share_bar_err;
        const stewart_real c11 = tau_k_bar*two_phi_dot;
        const stewart_real c11_err = tau_k_bar_err*two_phi_dot_max + tau_k_bar_max*two_phi_dot_err + STEWART_UNIT*STEWART_FABS(c11);
        const stewart_real c11_max = STEWART_FABS(c11) + c11_err;
        const stewart_real theta_dot_bar = C_s*c6_bar - D_weight*c3 + C_us*tau_y_bar + M_phi_theta*c11 + theta_ddot_bar*(-L_share
            - rho_share) + L_dot*c1_bar + kappa*rho_share_bar + REAL(2)*theta_dot*theta_dot2_bar;
        const stewart_real theta_dot_bar_err = C_s_max*c6_bar_err + C_us_err*tau_y_bar_max + C_us_max*tau_y_bar_err
            + D_weight_max*c3_err + L_dot_err*c1_bar_max + L_dot_max*c1_bar_err + L_share_err*theta_ddot_bar_max
            + M_phi_theta_err*c11_max + M_phi_theta_max*c11_err + kappa_err*rho_share_bar_max + kappa_max*rho_share_bar_err
            + rho_share_err*theta_ddot_bar_max + REAL(2)*theta_dot2_bar_err*theta_dot_max + REAL(2)*theta_dot2_bar_max*theta_dot_err
            + theta_ddot_bar_err*(L_share_max + rho_share_max) + STEWART_UNIT*(REAL(7)*C_s_max*c6_bar_max + REAL(6)*C_us_max*tau_y_bar_max
            + REAL(7)*D_weight_max*c3_max + REAL(3)*L_dot_max*c1_bar_max + REAL(5)*M_phi_theta_max*c11_max + REAL(2)*kappa_max*rho_share_bar_max
            + REAL(2)*theta_dot2_bar_max*theta_dot_max + REAL(5)*theta_ddot_bar_max*(L_share_max + rho_share_max)
            + STEWART_FABS(theta_dot_bar));
        const stewart_real theta_dot_bar_max = STEWART_FABS(theta_dot_bar) + theta_dot_bar_err;
        const stewart_real phi_dot_bar = C_s*c5_bar + C_us*tau_k_bar + c2*c3_bar + REAL(2)*two_phi_dot_bar + REAL(2)*phi_dot*phi_dot2_bar;
        const stewart_real phi_dot_bar_err = C_s_max*c5_bar_err + C_us_err*tau_k_bar_max + C_us_max*tau_k_bar_err
            + c2_err*c3_bar_max + c2_max*c3_bar_err + REAL(2)*two_phi_dot_bar_err + REAL(2)*phi_dot2_bar_err*phi_dot_max
            + REAL(2)*phi_dot2_bar_max*phi_dot_err + STEWART_UNIT*(REAL(2)*two_phi_dot_bar_max + REAL(4)*C_s_max*c5_bar_max
            + REAL(4)*C_us_max*tau_k_bar_max + REAL(3)*c2_max*c3_bar_max + REAL(2)*phi_dot2_bar_max*phi_dot_max
            + STEWART_FABS(phi_dot_bar));
        const stewart_real phi_dot_bar_max = STEWART_FABS(phi_dot_bar) + phi_dot_bar_err;
        const stewart_real L_dot_bar = C_p*D_weight + M_phi_L*c11 + c3*tau_y_bar + c1_bar*theta_dot + L_share_bar*inv_L
            + c8*theta_dot_bar;
        const stewart_real L_dot_bar_err = L_share_bar_err*inv_L_max + L_share_bar_max*inv_L_err + M_phi_L_err*c11_max
            + M_phi_L_max*c11_err + c1_bar_err*theta_dot_max + c1_bar_max*theta_dot_err + c3_err*tau_y_bar_max
            + c3_max*tau_y_bar_err + c8_err*theta_dot_bar_max + c8_max*theta_dot_bar_err + STEWART_UNIT*(c8_max*theta_dot_bar_max
            + REAL(5)*C_p_max*D_weight_max + REAL(2)*L_share_bar_max*inv_L_max + REAL(5)*M_phi_L_max*c11_max
            + REAL(3)*c1_bar_max*theta_dot_max + REAL(4)*c3_max*tau_y_bar_max + STEWART_FABS(L_dot_bar));
        const stewart_real L_dot_bar_max = STEWART_FABS(L_dot_bar) + L_dot_bar_err;
        const stewart_real c12 = inv_rho*phi_ddot_bar;
        const stewart_real c12_err = inv_rho_err*phi_ddot_bar_max + inv_rho_max*phi_ddot_bar_err + STEWART_UNIT*STEWART_FABS(c12);
        const stewart_real c12_max = STEWART_FABS(c12) + c12_err;
        const stewart_real c13 = inv_rho*theta_ddot_bar;
        const stewart_real c13_err = inv_rho_err*theta_ddot_bar_max + inv_rho_max*theta_ddot_bar_err + STEWART_UNIT*STEWART_FABS(c13);
        const stewart_real c13_max = STEWART_FABS(c13) + c13_err;
        const stewart_real S_ddot_z_bar = c12*y_z + L_ddot_bar*s_z - c13*k_z;
        const stewart_real S_ddot_z_bar_err = L_ddot_bar_err*s_z_max + L_ddot_bar_max*s_z_err + c12_err*y_z_max
            + c12_max*y_z_err + c13_err*k_z_max + c13_max*k_z_err + STEWART_UNIT*(c13_max*k_z_max + REAL(2)*L_ddot_bar_max*s_z_max
            + REAL(2)*c12_max*y_z_max + STEWART_FABS(S_ddot_z_bar));
        const stewart_real S_ddot_z_bar_max = STEWART_FABS(S_ddot_z_bar) + S_ddot_z_bar_err;
        const stewart_real S_ddot_y_bar = c12*y_y + L_ddot_bar*s_y - c13*k_y;
        const stewart_real S_ddot_y_bar_err = L_ddot_bar_err*s_y_max + L_ddot_bar_max*s_y_err + c12_err*y_y_max
            + c12_max*y_y_err + c13_err*k_y_max + c13_max*k_y_err + STEWART_UNIT*(c13_max*k_y_max + REAL(2)*L_ddot_bar_max*s_y_max
            + REAL(2)*c12_max*y_y_max + STEWART_FABS(S_ddot_y_bar));
        const stewart_real S_ddot_y_bar_max = STEWART_FABS(S_ddot_y_bar) + S_ddot_y_bar_err;
        const stewart_real S_ddot_x_bar = c12*y_x + L_ddot_bar*s_x - c13*k_x;
        const stewart_real S_ddot_x_bar_err = L_ddot_bar_err*s_x_max + L_ddot_bar_max*s_x_err + c12_err*y_x_max
            + c12_max*y_x_err + c13_err*k_x_max + c13_max*k_x_err + STEWART_UNIT*(c13_max*k_x_max + REAL(2)*L_ddot_bar_max*s_x_max
            + REAL(2)*c12_max*y_x_max + STEWART_FABS(S_ddot_x_bar));
        const stewart_real S_ddot_x_bar_max = STEWART_FABS(S_ddot_x_bar) + S_ddot_x_bar_err;
        const stewart_real c14 = inv_rho*phi_dot_bar;
        const stewart_real c14_err = inv_rho_err*phi_dot_bar_max + inv_rho_max*phi_dot_bar_err + STEWART_UNIT*STEWART_FABS(c14);
        const stewart_real c14_max = STEWART_FABS(c14) + c14_err;
        const stewart_real c15 = inv_rho*theta_dot_bar;
        const stewart_real c15_err = inv_rho_err*theta_dot_bar_max + inv_rho_max*theta_dot_bar_err + STEWART_UNIT*STEWART_FABS(c15);
        const stewart_real c15_max = STEWART_FABS(c15) + c15_err;
        const stewart_real S_dot_z_bar = L_dot_bar*s_z + c14*y_z - c15*k_z;
        const stewart_real S_dot_z_bar_err = L_dot_bar_err*s_z_max + L_dot_bar_max*s_z_err + c14_err*y_z_max
            + c14_max*y_z_err + c15_err*k_z_max + c15_max*k_z_err + STEWART_UNIT*(c15_max*k_z_max + REAL(2)*L_dot_bar_max*s_z_max
            + REAL(2)*c14_max*y_z_max + STEWART_FABS(S_dot_z_bar));
        const stewart_real S_dot_z_bar_max = STEWART_FABS(S_dot_z_bar) + S_dot_z_bar_err;
        const stewart_real S_dot_y_bar = L_dot_bar*s_y + c14*y_y - c15*k_y;
        const stewart_real S_dot_y_bar_err = L_dot_bar_err*s_y_max + L_dot_bar_max*s_y_err + c14_err*y_y_max
            + c14_max*y_y_err + c15_err*k_y_max + c15_max*k_y_err + STEWART_UNIT*(c15_max*k_y_max + REAL(2)*L_dot_bar_max*s_y_max
            + REAL(2)*c14_max*y_y_max + STEWART_FABS(S_dot_y_bar));
        const stewart_real S_dot_y_bar_max = STEWART_FABS(S_dot_y_bar) + S_dot_y_bar_err;
        const stewart_real S_dot_x_bar = L_dot_bar*s_x + c14*y_x - c15*k_x;
        const stewart_real S_dot_x_bar_err = L_dot_bar_err*s_x_max + L_dot_bar_max*s_x_err + c14_err*y_x_max
            + c14_max*y_x_err + c15_err*k_x_max + c15_max*k_x_err + STEWART_UNIT*(c15_max*k_x_max + REAL(2)*L_dot_bar_max*s_x_max
            + REAL(2)*c14_max*y_x_max + STEWART_FABS(S_dot_x_bar));
        const stewart_real S_dot_x_bar_max = STEWART_FABS(S_dot_x_bar) + S_dot_x_bar_err;
        const stewart_real kappa_bar = rho_share_bar*theta_dot;
        const stewart_real kappa_bar_err = rho_share_bar_err*theta_dot_max + rho_share_bar_max*theta_dot_err
            + STEWART_UNIT*STEWART_FABS(kappa_bar);
        const stewart_real kappa_bar_max = STEWART_FABS(kappa_bar) + kappa_bar_err;
        const stewart_real k3_bar = w_k_bar*w_z - M_mixed_theta_bar*a3 + J_yz*M_mixed_bar - c4_bar*h_y + w_n_bar*w_x
            + c2_bar*j_r + k1*k13_bar + REAL(2)*k3*k33_bar;
        const stewart_real k3_bar_err = J_yz_err*M_mixed_bar_max + J_yz_max*M_mixed_bar_err + M_mixed_theta_bar_err*a3_max
            + M_mixed_theta_bar_max*a3_err + c2_bar_err*j_r_max + c4_bar_err*h_y_max + c4_bar_max*h_y_err + k13_bar_err*k1_max
            + k13_bar_max*k1_err + w_k_bar_err*w_z_max + w_k_bar_max*w_z_err + w_n_bar_err*w_x_max + w_n_bar_max*w_x_err
            + REAL(2)*k33_bar_err*k3_max + REAL(2)*k33_bar_max*k3_err + STEWART_UNIT*(REAL(6)*J_yz_max*M_mixed_bar_max
            + REAL(7)*M_mixed_theta_bar_max*a3_max + REAL(3)*c2_bar_max*j_r_max + REAL(5)*c4_bar_max*h_y_max
            + REAL(2)*k13_bar_max*k1_max + REAL(2)*k33_bar_max*k3_max + REAL(7)*w_k_bar_max*w_z_max + REAL(4)*w_n_bar_max*w_x_max
            + STEWART_FABS(k3_bar));
        const stewart_real k3_bar_max = STEWART_FABS(k3_bar) + k3_bar_err;
        const stewart_real k1_bar = J_yz*M_mixed_theta_bar - D_weight*Q_k + c4_bar*j_r + w_k_bar*w_x - bend*c7
            + M_mixed_bar*a3 + L_ddot*c13 - w_n_bar*w_z + k13_bar*k3 + L_dot*c15;
        const stewart_real k1_bar_err = D_weight_max*Q_k_err + J_yz_err*M_mixed_theta_bar_max + J_yz_max*M_mixed_theta_bar_err
            + L_ddot_err*c13_max + L_ddot_max*c13_err + L_dot_err*c15_max + L_dot_max*c15_err + M_mixed_bar_err*a3_max
            + M_mixed_bar_max*a3_err + bend_err*c7_max + bend_max*c7_err + c4_bar_err*j_r_max + k13_bar_err*k3_max
            + k13_bar_max*k3_err + w_k_bar_err*w_x_max + w_k_bar_max*w_x_err + w_n_bar_err*w_z_max + w_n_bar_max*w_z_err
            + STEWART_UNIT*(L_dot_max*c15_max + REAL(9)*D_weight_max*Q_k_max + REAL(9)*J_yz_max*M_mixed_theta_bar_max
            + REAL(4)*L_ddot_max*c13_max + REAL(5)*M_mixed_bar_max*a3_max + REAL(6)*bend_max*c7_max + REAL(8)*c4_bar_max*j_r_max
            + REAL(2)*k13_bar_max*k3_max + REAL(7)*w_k_bar_max*w_x_max + REAL(3)*w_n_bar_max*w_z_max + STEWART_FABS(k1_bar));
        const stewart_real k1_bar_max = STEWART_FABS(k1_bar) + k1_bar_err;
        const stewart_real c16 = C_s*tau_y_bar;
        const stewart_real c16_err = C_s_max*tau_y_bar_err + STEWART_UNIT*STEWART_FABS(c16);
        const stewart_real c16_max = STEWART_FABS(c16) + c16_err;
        const stewart_real y_z_bar = g_z*gamma_y_bar - Y_moment_z*c6 - Q_y*c_force_z_bar - c16*omega_z + S_ddot_z*c12
            + g_x_k_z*gamma_n_bar + S_dot_z*c14;
        const stewart_real y_z_bar_err = Q_y_err*c_force_z_bar_max + Q_y_max*c_force_z_bar_err + S_ddot_z_err*c12_max
            + S_ddot_z_max*c12_err + S_dot_z_err*c14_max + S_dot_z_max*c14_err + Y_moment_z_max*c6_err + c16_err*omega_z_max
            + g_x_k_z_err*gamma_n_bar_max + g_x_k_z_max*gamma_n_bar_err + g_z_max*gamma_y_bar_err + STEWART_UNIT*(S_dot_z_max*c14_max
            + REAL(5)*Q_y_max*c_force_z_bar_max + REAL(3)*S_ddot_z_max*c12_max + REAL(6)*Y_moment_z_max*c6_max
            + REAL(4)*c16_max*omega_z_max + REAL(2)*g_x_k_z_max*gamma_n_bar_max + REAL(6)*g_z_max*gamma_y_bar_max
            + STEWART_FABS(y_z_bar));
        const stewart_real y_z_bar_max = STEWART_FABS(y_z_bar) + y_z_bar_err;
        const stewart_real y_y_bar = g_y*gamma_y_bar - Y_moment_y*c6 - Q_y*c_force_y_bar - c16*omega_y + S_ddot_y*c12
            + g_x_k_y*gamma_n_bar + S_dot_y*c14;
        const stewart_real y_y_bar_err = Q_y_err*c_force_y_bar_max + Q_y_max*c_force_y_bar_err + S_ddot_y_err*c12_max
            + S_ddot_y_max*c12_err + S_dot_y_err*c14_max + S_dot_y_max*c14_err + Y_moment_y_max*c6_err + c16_err*omega_y_max
            + g_x_k_y_err*gamma_n_bar_max + g_x_k_y_max*gamma_n_bar_err + g_y_max*gamma_y_bar_err + STEWART_UNIT*(S_dot_y_max*c14_max
            + REAL(5)*Q_y_max*c_force_y_bar_max + REAL(3)*S_ddot_y_max*c12_max + REAL(6)*Y_moment_y_max*c6_max
            + REAL(4)*c16_max*omega_y_max + REAL(2)*g_x_k_y_max*gamma_n_bar_max + REAL(6)*g_y_max*gamma_y_bar_max
            + STEWART_FABS(y_y_bar));
        const stewart_real y_y_bar_max = STEWART_FABS(y_y_bar) + y_y_bar_err;
        const stewart_real y_x_bar = g_x*gamma_y_bar - Y_moment_x*c6 - Q_y*c_force_x_bar - c16*omega_x + S_ddot_x*c12
            + g_x_k_x*gamma_n_bar + S_dot_x*c14;
        const stewart_real y_x_bar_err = Q_y_err*c_force_x_bar_max + Q_y_max*c_force_x_bar_err + S_ddot_x_err*c12_max
            + S_ddot_x_max*c12_err + S_dot_x_err*c14_max + S_dot_x_max*c14_err + Y_moment_x_max*c6_err + c16_err*omega_x_max
            + g_x_k_x_err*gamma_n_bar_max + g_x_k_x_max*gamma_n_bar_err + g_x_max*gamma_y_bar_err + STEWART_UNIT*(S_dot_x_max*c14_max
            + REAL(5)*Q_y_max*c_force_x_bar_max + REAL(3)*S_ddot_x_max*c12_max + REAL(6)*Y_moment_x_max*c6_max
            + REAL(4)*c16_max*omega_x_max + REAL(2)*g_x_k_x_max*gamma_n_bar_max + REAL(6)*g_x_max*gamma_y_bar_max
            + STEWART_FABS(y_x_bar));
        const stewart_real y_x_bar_max = STEWART_FABS(y_x_bar) + y_x_bar_err;
        const stewart_real inv_rho_bar = Q_y_bar*tau_k - Q_k_bar*tau_y + phi_ddot_bar*(S_ddot_x*y_x + S_ddot_y*y_y
            + S_ddot_z*y_z) + theta_ddot_bar*(L_ddot*k1 - S_ddot_x*k_x - S_ddot_y*k_y - S_ddot_z*k_z) + kappa_bar*zeta
            + theta_dot_bar*(L_dot*k1 - S_dot_x*k_x - S_dot_y*k_y - S_dot_z*k_z) + phi_dot_bar*(S_dot_x*y_x
            + S_dot_y*y_y + S_dot_z*y_z) + k_cross_S_x*y_x_bar + k_cross_S_y*y_y_bar + k_cross_S_z*y_z_bar;
        const stewart_real inv_rho_bar_err = Q_k_bar_err*tau_y_max + Q_k_bar_max*tau_y_err + Q_y_bar_err*tau_k_max
            + Q_y_bar_max*tau_k_err + k_cross_S_x_err*y_x_bar_max + k_cross_S_x_max*y_x_bar_err + k_cross_S_y_err*y_y_bar_max
            + k_cross_S_y_max*y_y_bar_err + k_cross_S_z_err*y_z_bar_max + k_cross_S_z_max*y_z_bar_err + kappa_bar_err*zeta_max
            + kappa_bar_max*zeta_err + L_ddot_err*k1_max*theta_ddot_bar_max + L_dot_err*k1_max*theta_dot_bar_max
            + S_ddot_x_err*(k_x_max*theta_ddot_bar_max + phi_ddot_bar_max*y_x_max) + S_ddot_y_err*(k_y_max*theta_ddot_bar_max
            + phi_ddot_bar_max*y_y_max) + S_ddot_z_err*(k_z_max*theta_ddot_bar_max + phi_ddot_bar_max*y_z_max)
            + S_dot_x_err*(k_x_max*theta_dot_bar_max + phi_dot_bar_max*y_x_max) + S_dot_y_err*(k_y_max*theta_dot_bar_max
            + phi_dot_bar_max*y_y_max) + S_dot_z_err*(k_z_max*theta_dot_bar_max + phi_dot_bar_max*y_z_max) + k1_err*(L_ddot_max*theta_ddot_bar_max
            + L_dot_max*theta_dot_bar_max) + k_x_err*(S_ddot_x_max*theta_ddot_bar_max + S_dot_x_max*theta_dot_bar_max)
            + k_y_err*(S_ddot_y_max*theta_ddot_bar_max + S_dot_y_max*theta_dot_bar_max) + k_z_err*(S_ddot_z_max*theta_ddot_bar_max
            + S_dot_z_max*theta_dot_bar_max) + y_x_err*(S_ddot_x_max*phi_ddot_bar_max + S_dot_x_max*phi_dot_bar_max)
            + y_y_err*(S_ddot_y_max*phi_ddot_bar_max + S_dot_y_max*phi_dot_bar_max) + y_z_err*(S_ddot_z_max*phi_ddot_bar_max
            + S_dot_z_max*phi_dot_bar_max) + phi_ddot_bar_err*(S_ddot_x_max*y_x_max + S_ddot_y_max*y_y_max + S_ddot_z_max*y_z_max)
            + phi_dot_bar_err*(S_dot_x_max*y_x_max + S_dot_y_max*y_y_max + S_dot_z_max*y_z_max) + theta_ddot_bar_err*(L_ddot_max*k1_max
            + S_ddot_x_max*k_x_max + S_ddot_y_max*k_y_max + S_ddot_z_max*k_z_max) + theta_dot_bar_err*(L_dot_max*k1_max
            + S_dot_x_max*k_x_max + S_dot_y_max*k_y_max + S_dot_z_max*k_z_max) + STEWART_UNIT*(k_cross_S_z_max*y_z_bar_max
            + REAL(9)*Q_k_bar_max*tau_y_max + REAL(9)*Q_y_bar_max*tau_k_max + REAL(3)*k_cross_S_x_max*y_x_bar_max
            + REAL(2)*k_cross_S_y_max*y_y_bar_max + REAL(6)*kappa_bar_max*zeta_max + REAL(8)*phi_ddot_bar_max*(S_ddot_x_max*y_x_max
            + S_ddot_y_max*y_y_max + S_ddot_z_max*y_z_max) + phi_ddot_bar_max*(REAL(3)*S_ddot_x_max*y_x_max
            + REAL(3)*S_ddot_y_max*y_y_max + REAL(2)*S_ddot_z_max*y_z_max) + REAL(4)*phi_dot_bar_max*(S_dot_x_max*y_x_max
            + S_dot_y_max*y_y_max + S_dot_z_max*y_z_max) + phi_dot_bar_max*(REAL(3)*S_dot_x_max*y_x_max + REAL(3)*S_dot_y_max*y_y_max
            + REAL(2)*S_dot_z_max*y_z_max) + REAL(7)*theta_ddot_bar_max*(L_ddot_max*k1_max + S_ddot_x_max*k_x_max
            + S_ddot_y_max*k_y_max + S_ddot_z_max*k_z_max) + theta_ddot_bar_max*(REAL(4)*L_ddot_max*k1_max + REAL(4)*S_ddot_x_max*k_x_max
            + REAL(3)*S_ddot_y_max*k_y_max + REAL(2)*S_ddot_z_max*k_z_max) + REAL(5)*theta_dot_bar_max*(L_dot_max*k1_max
            + S_dot_x_max*k_x_max + S_dot_y_max*k_y_max + S_dot_z_max*k_z_max) + theta_dot_bar_max*(REAL(4)*L_dot_max*k1_max
            + REAL(4)*S_dot_x_max*k_x_max + REAL(3)*S_dot_y_max*k_y_max + REAL(2)*S_dot_z_max*k_z_max) + STEWART_FABS(inv_rho_bar));
        const stewart_real inv_rho_bar_max = STEWART_FABS(inv_rho_bar) + inv_rho_bar_err;
        const stewart_real s_z_bar = H_force_z_bar + L_ddot_bar*S_ddot_z + L_dot_bar*S_dot_z;
        const stewart_real s_z_bar_err = H_force_z_bar_err + L_ddot_bar_err*S_ddot_z_max + L_ddot_bar_max*S_ddot_z_err
            + L_dot_bar_err*S_dot_z_max + L_dot_bar_max*S_dot_z_err + STEWART_UNIT*(H_force_z_bar_max + L_dot_bar_max*S_dot_z_max
            + REAL(2)*L_ddot_bar_max*S_ddot_z_max + STEWART_FABS(s_z_bar));
        const stewart_real s_z_bar_max = STEWART_FABS(s_z_bar) + s_z_bar_err;
        const stewart_real s_y_bar = H_force_y_bar + L_ddot_bar*S_ddot_y + L_dot_bar*S_dot_y;
        const stewart_real s_y_bar_err = H_force_y_bar_err + L_ddot_bar_err*S_ddot_y_max + L_ddot_bar_max*S_ddot_y_err
            + L_dot_bar_err*S_dot_y_max + L_dot_bar_max*S_dot_y_err + STEWART_UNIT*(H_force_y_bar_max + L_dot_bar_max*S_dot_y_max
            + REAL(2)*L_ddot_bar_max*S_ddot_y_max + STEWART_FABS(s_y_bar));
        const stewart_real s_y_bar_max = STEWART_FABS(s_y_bar) + s_y_bar_err;
        const stewart_real s_x_bar = H_force_x_bar + L_ddot_bar*S_ddot_x + L_dot_bar*S_dot_x;
        const stewart_real s_x_bar_err = H_force_x_bar_err + L_ddot_bar_err*S_ddot_x_max + L_ddot_bar_max*S_ddot_x_err
            + L_dot_bar_err*S_dot_x_max + L_dot_bar_max*S_dot_x_err + STEWART_UNIT*(H_force_x_bar_max + L_dot_bar_max*S_dot_x_max
            + REAL(2)*L_ddot_bar_max*S_ddot_x_max + STEWART_FABS(s_x_bar));
        const stewart_real s_x_bar_max = STEWART_FABS(s_x_bar) + s_x_bar_err;
        const stewart_real inv_L_bar = L_dot*L_share_bar + k3_bar*rho + k1_bar*zeta + S_x*s_x_bar + S_y*s_y_bar
            + S_z*s_z_bar;
        const stewart_real inv_L_bar_err = L_dot_err*L_share_bar_max + L_dot_max*L_share_bar_err + S_x_err*s_x_bar_max
            + S_x_max*s_x_bar_err + S_y_err*s_y_bar_max + S_y_max*s_y_bar_err + S_z_err*s_z_bar_max + S_z_max*s_z_bar_err
            + k1_bar_err*zeta_max + k1_bar_max*zeta_err + k3_bar_err*rho_max + k3_bar_max*rho_err + STEWART_UNIT*(S_z_max*s_z_bar_max
            + REAL(5)*L_dot_max*L_share_bar_max + REAL(3)*S_x_max*s_x_bar_max + REAL(2)*S_y_max*s_y_bar_max
            + REAL(4)*k1_bar_max*zeta_max + REAL(5)*k3_bar_max*rho_max + STEWART_FABS(inv_L_bar));
        const stewart_real inv_L_bar_max = STEWART_FABS(inv_L_bar) + inv_L_bar_err;
        const stewart_real rho_bar = inv_L*k3_bar - inv_rho_bar*inv_rho*inv_rho;
        const stewart_real rho_bar_err = inv_L_err*k3_bar_max + inv_L_max*k3_bar_err + inv_rho_bar_err*inv_rho_max*inv_rho_max
            + REAL(2)*inv_rho_bar_max*inv_rho_err*inv_rho_max + STEWART_UNIT*(inv_L_max*k3_bar_max + REAL(2)*inv_rho_bar_max*inv_rho_max*inv_rho_max
            + STEWART_FABS(rho_bar));
        const stewart_real rho_bar_max = STEWART_FABS(rho_bar) + rho_bar_err;
        const stewart_real L_bar = L_ddot_bar*(theta_dot2 + k33*phi_dot2) - a3_bar*h_y + L_h2_bar*h2_x - a2_bar*h2_z
            - inv_L_bar*inv_L*inv_L;
        const stewart_real L_bar_err = L_ddot_bar_max*theta_dot2_err + L_h2_bar_err*h2_x_max + L_h2_bar_max*h2_x_err
            + a2_bar_err*h2_z_max + a2_bar_max*h2_z_err + a3_bar_err*h_y_max + a3_bar_max*h_y_err + L_ddot_bar_max*k33_err*phi_dot2_max
            + L_ddot_bar_max*k33_max*phi_dot2_err + inv_L_bar_err*inv_L_max*inv_L_max + L_ddot_bar_err*(theta_dot2_max
            + k33_max*phi_dot2_max) + REAL(2)*inv_L_bar_max*inv_L_err*inv_L_max + STEWART_UNIT*(REAL(3)*L_h2_bar_max*h2_x_max
            + REAL(2)*a2_bar_max*h2_z_max + REAL(4)*a3_bar_max*h_y_max + REAL(2)*inv_L_bar_max*inv_L_max*inv_L_max
            + REAL(4)*L_ddot_bar_max*(theta_dot2_max + k33_max*phi_dot2_max) + L_ddot_bar_max*(theta_dot2_max
            + REAL(2)*k33_max*phi_dot2_max) + STEWART_FABS(L_bar));
        const stewart_real L_bar_max = STEWART_FABS(L_bar) + L_bar_err;
        const stewart_real c17 = L_bar*inv_L;
        const stewart_real c17_err = L_bar_err*inv_L_max + L_bar_max*inv_L_err + STEWART_UNIT*STEWART_FABS(c17);
        const stewart_real c17_max = STEWART_FABS(c17) + c17_err;
        const stewart_real rho2_bar = STEWART_HALF*c17 + STEWART_HALF*inv_rho*rho_bar;
        const stewart_real rho2_bar_err = STEWART_HALF*c17_err + STEWART_HALF*inv_rho_err*rho_bar_max + STEWART_HALF*inv_rho_max*rho_bar_err
            + STEWART_UNIT*(STEWART_HALF*inv_rho_max*rho_bar_max + STEWART_FABS(rho2_bar));
        const stewart_real rho2_bar_max = STEWART_FABS(rho2_bar) + rho2_bar_err;
        const stewart_real c18 = REAL(2)*rho2_bar;
        const stewart_real c18_err = REAL(2)*rho2_bar_err;
        const stewart_real c18_max = STEWART_FABS(c18) + c18_err;
        const stewart_real k_cross_S_z_bar = inv_rho*y_z_bar + c18*k_cross_S_z;
        const stewart_real k_cross_S_z_bar_err = c18_err*k_cross_S_z_max + c18_max*k_cross_S_z_err + inv_rho_err*y_z_bar_max
            + inv_rho_max*y_z_bar_err + STEWART_UNIT*(c18_max*k_cross_S_z_max + inv_rho_max*y_z_bar_max + STEWART_FABS(k_cross_S_z_bar));
        const stewart_real k_cross_S_z_bar_max = STEWART_FABS(k_cross_S_z_bar) + k_cross_S_z_bar_err;
        const stewart_real k_cross_S_y_bar = inv_rho*y_y_bar + c18*k_cross_S_y;
        const stewart_real k_cross_S_y_bar_err = c18_err*k_cross_S_y_max + c18_max*k_cross_S_y_err + inv_rho_err*y_y_bar_max
            + inv_rho_max*y_y_bar_err + STEWART_UNIT*(c18_max*k_cross_S_y_max + inv_rho_max*y_y_bar_max + STEWART_FABS(k_cross_S_y_bar));
        const stewart_real k_cross_S_y_bar_max = STEWART_FABS(k_cross_S_y_bar) + k_cross_S_y_bar_err;
        const stewart_real k_cross_S_x_bar = inv_rho*y_x_bar + c18*k_cross_S_x;
        const stewart_real k_cross_S_x_bar_err = c18_err*k_cross_S_x_max + c18_max*k_cross_S_x_err + inv_rho_err*y_x_bar_max
            + inv_rho_max*y_x_bar_err + STEWART_UNIT*(c18_max*k_cross_S_x_max + inv_rho_max*y_x_bar_max + STEWART_FABS(k_cross_S_x_bar));
        const stewart_real k_cross_S_x_bar_max = STEWART_FABS(k_cross_S_x_bar) + k_cross_S_x_bar_err;
        const stewart_real zeta_bar = inv_rho*kappa_bar + inv_L*k1_bar + c17*zeta;
        const stewart_real zeta_bar_err = c17_err*zeta_max + c17_max*zeta_err + inv_L_err*k1_bar_max + inv_L_max*k1_bar_err
            + inv_rho_err*kappa_bar_max + inv_rho_max*kappa_bar_err + STEWART_UNIT*(c17_max*zeta_max + REAL(2)*inv_L_max*k1_bar_max
            + REAL(2)*inv_rho_max*kappa_bar_max + STEWART_FABS(zeta_bar));
        const stewart_real zeta_bar_max = STEWART_FABS(zeta_bar) + zeta_bar_err;
        const stewart_real S_z_bar = inv_L*s_z_bar + k_z*zeta_bar + k_cross_S_x_bar*k_y - k_cross_S_y_bar*k_x;
        const stewart_real S_z_bar_err = inv_L_err*s_z_bar_max + inv_L_max*s_z_bar_err + k_cross_S_x_bar_err*k_y_max
            + k_cross_S_x_bar_max*k_y_err + k_cross_S_y_bar_err*k_x_max + k_cross_S_y_bar_max*k_x_err + k_z_err*zeta_bar_max
            + k_z_max*zeta_bar_err + STEWART_UNIT*(k_cross_S_y_bar_max*k_x_max + REAL(3)*inv_L_max*s_z_bar_max
            + REAL(2)*k_cross_S_x_bar_max*k_y_max + REAL(3)*k_z_max*zeta_bar_max + STEWART_FABS(S_z_bar));
        const stewart_real S_z_bar_max = STEWART_FABS(S_z_bar) + S_z_bar_err;
        const stewart_real S_y_bar = inv_L*s_y_bar + k_y*zeta_bar + k_cross_S_z_bar*k_x - k_cross_S_x_bar*k_z;
        const stewart_real S_y_bar_err = inv_L_err*s_y_bar_max + inv_L_max*s_y_bar_err + k_cross_S_x_bar_err*k_z_max
            + k_cross_S_x_bar_max*k_z_err + k_cross_S_z_bar_err*k_x_max + k_cross_S_z_bar_max*k_x_err + k_y_err*zeta_bar_max
            + k_y_max*zeta_bar_err + STEWART_UNIT*(k_cross_S_x_bar_max*k_z_max + REAL(3)*inv_L_max*s_y_bar_max
            + REAL(2)*k_cross_S_z_bar_max*k_x_max + REAL(3)*k_y_max*zeta_bar_max + STEWART_FABS(S_y_bar));
        const stewart_real S_y_bar_max = STEWART_FABS(S_y_bar) + S_y_bar_err;
        const stewart_real S_x_bar = inv_L*s_x_bar + k_x*zeta_bar + k_cross_S_y_bar*k_z - k_cross_S_z_bar*k_y;
        const stewart_real S_x_bar_err = inv_L_err*s_x_bar_max + inv_L_max*s_x_bar_err + k_cross_S_y_bar_err*k_z_max
            + k_cross_S_y_bar_max*k_z_err + k_cross_S_z_bar_err*k_y_max + k_cross_S_z_bar_max*k_y_err + k_x_err*zeta_bar_max
            + k_x_max*zeta_bar_err + STEWART_UNIT*(k_cross_S_z_bar_max*k_y_max + REAL(3)*inv_L_max*s_x_bar_max
            + REAL(2)*k_cross_S_y_bar_max*k_z_max + REAL(3)*k_x_max*zeta_bar_max + STEWART_FABS(S_x_bar));
        const stewart_real S_x_bar_max = STEWART_FABS(S_x_bar) + S_x_bar_err;
        const stewart_real q_z_bar = arm_z_bar + B_xz*S_ddot_x_bar + B_yz*S_ddot_y_bar + B_zz*S_ddot_z_bar + S_dot_x_bar*omega_y
            - S_dot_y_bar*omega_x + S_z_bar;
        const stewart_real q_z_bar_err = S_z_bar_err + arm_z_bar_err + B_xz_err*S_ddot_x_bar_max + B_xz_max*S_ddot_x_bar_err
            + B_yz_err*S_ddot_y_bar_max + B_yz_max*S_ddot_y_bar_err + B_zz_err*S_ddot_z_bar_max + B_zz_max*S_ddot_z_bar_err
            + S_dot_x_bar_err*omega_y_max + S_dot_y_bar_err*omega_x_max + STEWART_UNIT*(REAL(5)*arm_z_bar_max
            + REAL(6)*B_xz_max*S_ddot_x_bar_max + REAL(5)*B_yz_max*S_ddot_y_bar_max + REAL(4)*B_zz_max*S_ddot_z_bar_max
            + REAL(3)*S_dot_x_bar_max*omega_y_max + REAL(2)*S_dot_y_bar_max*omega_x_max + STEWART_FABS(q_z_bar));
        const stewart_real q_z_bar_max = STEWART_FABS(q_z_bar) + q_z_bar_err;
        const stewart_real q_y_bar = arm_y_bar + B_xy*S_ddot_x_bar + B_yy*S_ddot_y_bar + B_zy*S_ddot_z_bar + S_dot_z_bar*omega_x
            - S_dot_x_bar*omega_z + S_y_bar;
        const stewart_real q_y_bar_err = S_y_bar_err + arm_y_bar_err + B_xy_err*S_ddot_x_bar_max + B_xy_max*S_ddot_x_bar_err
            + B_yy_err*S_ddot_y_bar_max + B_yy_max*S_ddot_y_bar_err + B_zy_err*S_ddot_z_bar_max + B_zy_max*S_ddot_z_bar_err
            + S_dot_x_bar_err*omega_z_max + S_dot_z_bar_err*omega_x_max + STEWART_UNIT*(REAL(5)*arm_y_bar_max
            + REAL(6)*B_xy_max*S_ddot_x_bar_max + REAL(5)*B_yy_max*S_ddot_y_bar_max + REAL(4)*B_zy_max*S_ddot_z_bar_max
            + REAL(2)*S_dot_x_bar_max*omega_z_max + REAL(3)*S_dot_z_bar_max*omega_x_max + STEWART_FABS(q_y_bar));
        const stewart_real q_y_bar_max = STEWART_FABS(q_y_bar) + q_y_bar_err;
        const stewart_real q_x_bar = arm_x_bar + B_xx*S_ddot_x_bar + B_yx*S_ddot_y_bar + B_zx*S_ddot_z_bar + S_dot_y_bar*omega_z
            - S_dot_z_bar*omega_y + S_x_bar;
        const stewart_real q_x_bar_err = S_x_bar_err + arm_x_bar_err + B_xx_err*S_ddot_x_bar_max + B_xx_max*S_ddot_x_bar_err
            + B_yx_err*S_ddot_y_bar_max + B_yx_max*S_ddot_y_bar_err + B_zx_err*S_ddot_z_bar_max + B_zx_max*S_ddot_z_bar_err
            + S_dot_y_bar_err*omega_z_max + S_dot_z_bar_err*omega_y_max + STEWART_UNIT*(REAL(5)*arm_x_bar_max
            + REAL(6)*B_xx_max*S_ddot_x_bar_max + REAL(5)*B_yx_max*S_ddot_y_bar_max + REAL(4)*B_zx_max*S_ddot_z_bar_max
            + REAL(3)*S_dot_y_bar_max*omega_z_max + REAL(2)*S_dot_z_bar_max*omega_y_max + STEWART_FABS(q_x_bar));
        const stewart_real q_x_bar_max = STEWART_FABS(q_x_bar) + q_x_bar_err;
        const stewart_real c19 = C_s*tau_k_bar;
        const stewart_real c19_err = C_s_max*tau_k_bar_err + STEWART_UNIT*STEWART_FABS(c19);
        const stewart_real c19_max = STEWART_FABS(c19) + c19_err;
        const stewart_real k_x_bar = S_x*zeta_bar - Y_moment_x*c5 - Q_k*c_force_x_bar - c19*omega_x - S_ddot_x*c13
            - S_dot_x*c15 + S_y*k_cross_S_z_bar - S_z*k_cross_S_y_bar;
        const stewart_real k_x_bar_err = Q_k_err*c_force_x_bar_max + Q_k_max*c_force_x_bar_err + S_ddot_x_err*c13_max
            + S_ddot_x_max*c13_err + S_dot_x_err*c15_max + S_dot_x_max*c15_err + S_x_err*zeta_bar_max + S_x_max*zeta_bar_err
            + S_y_err*k_cross_S_z_bar_max + S_y_max*k_cross_S_z_bar_err + S_z_err*k_cross_S_y_bar_max + S_z_max*k_cross_S_y_bar_err
            + Y_moment_x_max*c5_err + c19_err*omega_x_max + STEWART_UNIT*(S_z_max*k_cross_S_y_bar_max + REAL(6)*Q_k_max*c_force_x_bar_max
            + REAL(4)*S_ddot_x_max*c13_max + REAL(3)*S_dot_x_max*c15_max + REAL(7)*S_x_max*zeta_bar_max + REAL(2)*S_y_max*k_cross_S_z_bar_max
            + REAL(7)*Y_moment_x_max*c5_max + REAL(5)*c19_max*omega_x_max + STEWART_FABS(k_x_bar));
        const stewart_real k_x_bar_max = STEWART_FABS(k_x_bar) + k_x_bar_err;
        const stewart_real k_y_bar = S_y*zeta_bar - Y_moment_y*c5 - Q_k*c_force_y_bar - c19*omega_y - S_ddot_y*c13
            - S_dot_y*c15 + S_z*k_cross_S_x_bar - S_x*k_cross_S_z_bar;
        const stewart_real k_y_bar_err = Q_k_err*c_force_y_bar_max + Q_k_max*c_force_y_bar_err + S_ddot_y_err*c13_max
            + S_ddot_y_max*c13_err + S_dot_y_err*c15_max + S_dot_y_max*c15_err + S_x_err*k_cross_S_z_bar_max
            + S_x_max*k_cross_S_z_bar_err + S_y_err*zeta_bar_max + S_y_max*zeta_bar_err + S_z_err*k_cross_S_x_bar_max
            + S_z_max*k_cross_S_x_bar_err + Y_moment_y_max*c5_err + c19_err*omega_y_max + STEWART_UNIT*(S_x_max*k_cross_S_z_bar_max
            + REAL(6)*Q_k_max*c_force_y_bar_max + REAL(4)*S_ddot_y_max*c13_max + REAL(3)*S_dot_y_max*c15_max
            + REAL(7)*S_y_max*zeta_bar_max + REAL(2)*S_z_max*k_cross_S_x_bar_max + REAL(7)*Y_moment_y_max*c5_max
            + REAL(5)*c19_max*omega_y_max + STEWART_FABS(k_y_bar));
        const stewart_real k_y_bar_max = STEWART_FABS(k_y_bar) + k_y_bar_err;
        const stewart_real k_z_bar = S_z*zeta_bar - Y_moment_z*c5 - Q_k*c_force_z_bar - c19*omega_z - S_ddot_z*c13
            - S_dot_z*c15 + S_x*k_cross_S_y_bar - S_y*k_cross_S_x_bar;
        const stewart_real k_z_bar_err = Q_k_err*c_force_z_bar_max + Q_k_max*c_force_z_bar_err + S_ddot_z_err*c13_max
            + S_ddot_z_max*c13_err + S_dot_z_err*c15_max + S_dot_z_max*c15_err + S_x_err*k_cross_S_y_bar_max
            + S_x_max*k_cross_S_y_bar_err + S_y_err*k_cross_S_x_bar_max + S_y_max*k_cross_S_x_bar_err + S_z_err*zeta_bar_max
            + S_z_max*zeta_bar_err + Y_moment_z_max*c5_err + c19_err*omega_z_max + STEWART_UNIT*(S_y_max*k_cross_S_x_bar_max
            + REAL(6)*Q_k_max*c_force_z_bar_max + REAL(4)*S_ddot_z_max*c13_max + REAL(3)*S_dot_z_max*c15_max
            + REAL(2)*S_x_max*k_cross_S_y_bar_max + REAL(7)*S_z_max*zeta_bar_max + REAL(7)*Y_moment_z_max*c5_max
            + REAL(5)*c19_max*omega_z_max + STEWART_FABS(k_z_bar));
        const stewart_real k_z_bar_max = STEWART_FABS(k_z_bar) + k_z_bar_err;
        const stewart_real h_x_bar = M_phi_L_bar*k33 - D_weight*theta_dot2;
        const stewart_real h_x_bar_err = D_weight_max*theta_dot2_err + M_phi_L_bar_err*k33_max + M_phi_L_bar_max*k33_err
            + STEWART_UNIT*(D_weight_max*theta_dot2_max + M_phi_L_bar_max*k33_max + STEWART_FABS(h_x_bar));
        const stewart_real h_x_bar_max = STEWART_FABS(h_x_bar) + h_x_bar_err;
        const stewart_real h_y_bar = -c4_bar*k3 - L*a3_bar;
        const stewart_real h_y_bar_err = L_err*a3_bar_max + L_max*a3_bar_err + c4_bar_err*k3_max + c4_bar_max*k3_err
            + STEWART_UNIT*(L_max*a3_bar_max + c4_bar_max*k3_max + STEWART_FABS(h_y_bar));
        const stewart_real h_y_bar_max = STEWART_FABS(h_y_bar) + h_y_bar_err;
        const stewart_real h_z_bar = D_weight*theta_ddot + L_ddot*tau_y_bar - M_phi_L_bar*k13;
        const stewart_real h_z_bar_err = D_weight_max*theta_ddot_err + L_ddot_err*tau_y_bar_max + L_ddot_max*tau_y_bar_err
            + M_phi_L_bar_err*k13_max + M_phi_L_bar_max*k13_err + STEWART_UNIT*(M_phi_L_bar_max*k13_max + REAL(2)*D_weight_max*theta_ddot_max
            + REAL(2)*L_ddot_max*tau_y_bar_max + STEWART_FABS(h_z_bar));
        const stewart_real h_z_bar_max = STEWART_FABS(h_z_bar) + h_z_bar_err;
        const stewart_real h2_x_bar = bend*tau_y_bar + L*L_h2_bar;
        const stewart_real h2_x_bar_err = L_err*L_h2_bar_max + L_h2_bar_err*L_max + bend_err*tau_y_bar_max + bend_max*tau_y_bar_err
            + STEWART_UNIT*(L_h2_bar_max*L_max + bend_max*tau_y_bar_max + STEWART_FABS(h2_x_bar));
        const stewart_real h2_x_bar_max = STEWART_FABS(h2_x_bar) + h2_x_bar_err;
        const stewart_real h2_y_bar = -bend*k1*tau_k_bar;
        const stewart_real h2_y_bar_err = bend_err*k1_max*tau_k_bar_max + bend_max*k1_err*tau_k_bar_max + bend_max*k1_max*tau_k_bar_err
            + STEWART_UNIT*(bend_max*k1_max*tau_k_bar_max + STEWART_FABS(h2_y_bar));
        const stewart_real h2_y_bar_max = STEWART_FABS(h2_y_bar) + h2_y_bar_err;
        const stewart_real h2_z_bar = -L*a2_bar;
        const stewart_real h2_z_bar_err = L_err*a2_bar_max + L_max*a2_bar_err + STEWART_UNIT*STEWART_FABS(h2_z_bar);
        const stewart_real h2_z_bar_max = STEWART_FABS(h2_z_bar) + h2_z_bar_err;
        const stewart_real w_x_bar = k1*w_k_bar + k3*w_n_bar;
        const stewart_real w_x_bar_err = k1_err*w_k_bar_max + k1_max*w_k_bar_err + k3_err*w_n_bar_max + k3_max*w_n_bar_err
            + STEWART_UNIT*(k1_max*w_k_bar_max + k3_max*w_n_bar_max + STEWART_FABS(w_x_bar));
        const stewart_real w_x_bar_max = STEWART_FABS(w_x_bar) + w_x_bar_err;
        const stewart_real w_y_bar = -gamma_n*tau_k_bar;
        const stewart_real w_y_bar_err = gamma_n_err*tau_k_bar_max + gamma_n_max*tau_k_bar_err + STEWART_UNIT*STEWART_FABS(w_y_bar);
        const stewart_real w_y_bar_max = STEWART_FABS(w_y_bar) + w_y_bar_err;
        const stewart_real w_z_bar = k3*w_k_bar - k1*w_n_bar;
        const stewart_real w_z_bar_err = k1_err*w_n_bar_max + k1_max*w_n_bar_err + k3_err*w_k_bar_max + k3_max*w_k_bar_err
            + STEWART_UNIT*(k1_max*w_n_bar_max + k3_max*w_k_bar_max + STEWART_FABS(w_z_bar));
        const stewart_real w_z_bar_max = STEWART_FABS(w_z_bar) + w_z_bar_err;
        const stewart_real J_yz_bar = M_mixed_theta_bar*k1 + M_mixed_bar*k3;
        const stewart_real J_yz_bar_err = M_mixed_bar_err*k3_max + M_mixed_bar_max*k3_err + M_mixed_theta_bar_err*k1_max
            + M_mixed_theta_bar_max*k1_err + STEWART_UNIT*(M_mixed_bar_max*k3_max + M_mixed_theta_bar_max*k1_max
            + STEWART_FABS(J_yz_bar));
        const stewart_real J_yz_bar_max = STEWART_FABS(J_yz_bar) + J_yz_bar_err;
        const stewart_real g_k_bar = tau_y_bar*w_n;
        const stewart_real g_k_bar_err = tau_y_bar_err*w_n_max + tau_y_bar_max*w_n_err + STEWART_UNIT*STEWART_FABS(g_k_bar);
        const stewart_real g_k_bar_max = STEWART_FABS(g_k_bar) + g_k_bar_err;
        const stewart_real g_x_k_x_bar = gamma_n_bar*y_x;
        const stewart_real g_x_k_x_bar_err = gamma_n_bar_err*y_x_max + gamma_n_bar_max*y_x_err + STEWART_UNIT*STEWART_FABS(g_x_k_x_bar);
        const stewart_real g_x_k_x_bar_max = STEWART_FABS(g_x_k_x_bar) + g_x_k_x_bar_err;
        const stewart_real g_x_k_y_bar = gamma_n_bar*y_y;
        const stewart_real g_x_k_y_bar_err = gamma_n_bar_err*y_y_max + gamma_n_bar_max*y_y_err + STEWART_UNIT*STEWART_FABS(g_x_k_y_bar);
        const stewart_real g_x_k_y_bar_max = STEWART_FABS(g_x_k_y_bar) + g_x_k_y_bar_err;
        const stewart_real g_x_k_z_bar = gamma_n_bar*y_z;
        const stewart_real g_x_k_z_bar_err = gamma_n_bar_err*y_z_max + gamma_n_bar_max*y_z_err + STEWART_UNIT*STEWART_FABS(g_x_k_z_bar);
        const stewart_real g_x_k_z_bar_max = STEWART_FABS(g_x_k_z_bar) + g_x_k_z_bar_err;
        const stewart_real C_us_bar = phi_dot*tau_k_bar + tau_y_bar*theta_dot;
        const stewart_real C_us_bar_err = phi_dot_err*tau_k_bar_max + phi_dot_max*tau_k_bar_err + tau_y_bar_err*theta_dot_max
            + tau_y_bar_max*theta_dot_err + STEWART_UNIT*(phi_dot_max*tau_k_bar_max + tau_y_bar_max*theta_dot_max
            + STEWART_FABS(C_us_bar));
        const stewart_real C_us_bar_max = STEWART_FABS(C_us_bar) + C_us_bar_err;
        const stewart_real R_xx_bar = p_x*q_x_bar;
        const stewart_real R_xx_bar_err = p_x_max*q_x_bar_err + STEWART_UNIT*STEWART_FABS(R_xx_bar);
        const stewart_real R_xy_bar = p_y*q_x_bar;
        const stewart_real R_xy_bar_err = p_y_max*q_x_bar_err + STEWART_UNIT*STEWART_FABS(R_xy_bar);
        const stewart_real R_xz_bar = p_z*q_x_bar;
        const stewart_real R_xz_bar_err = p_z_max*q_x_bar_err + STEWART_UNIT*STEWART_FABS(R_xz_bar);
        const stewart_real R_yx_bar = p_x*q_y_bar;
        const stewart_real R_yx_bar_err = p_x_max*q_y_bar_err + STEWART_UNIT*STEWART_FABS(R_yx_bar);
        const stewart_real R_yy_bar = p_y*q_y_bar;
        const stewart_real R_yy_bar_err = p_y_max*q_y_bar_err + STEWART_UNIT*STEWART_FABS(R_yy_bar);
        const stewart_real R_yz_bar = p_z*q_y_bar;
        const stewart_real R_yz_bar_err = p_z_max*q_y_bar_err + STEWART_UNIT*STEWART_FABS(R_yz_bar);
        const stewart_real R_zx_bar = p_x*q_z_bar;
        const stewart_real R_zx_bar_err = p_x_max*q_z_bar_err + STEWART_UNIT*STEWART_FABS(R_zx_bar);
        const stewart_real R_zy_bar = p_y*q_z_bar;
        const stewart_real R_zy_bar_err = p_y_max*q_z_bar_err + STEWART_UNIT*STEWART_FABS(R_zy_bar);
        const stewart_real R_zz_bar = p_z*q_z_bar;
        const stewart_real R_zz_bar_err = p_z_max*q_z_bar_err + STEWART_UNIT*STEWART_FABS(R_zz_bar);
        const stewart_real B_xx_bar = S_ddot_x_bar*q_x;
        const stewart_real B_xx_bar_err = S_ddot_x_bar_err*q_x_max + S_ddot_x_bar_max*q_x_err + STEWART_UNIT*STEWART_FABS(B_xx_bar);
        const stewart_real B_xy_bar = S_ddot_x_bar*q_y;
        const stewart_real B_xy_bar_err = S_ddot_x_bar_err*q_y_max + S_ddot_x_bar_max*q_y_err + STEWART_UNIT*STEWART_FABS(B_xy_bar);
        const stewart_real B_xz_bar = S_ddot_x_bar*q_z;
        const stewart_real B_xz_bar_err = S_ddot_x_bar_err*q_z_max + S_ddot_x_bar_max*q_z_err + STEWART_UNIT*STEWART_FABS(B_xz_bar);
        const stewart_real B_yx_bar = S_ddot_y_bar*q_x;
        const stewart_real B_yx_bar_err = S_ddot_y_bar_err*q_x_max + S_ddot_y_bar_max*q_x_err + STEWART_UNIT*STEWART_FABS(B_yx_bar);
        const stewart_real B_yy_bar = S_ddot_y_bar*q_y;
        const stewart_real B_yy_bar_err = S_ddot_y_bar_err*q_y_max + S_ddot_y_bar_max*q_y_err + STEWART_UNIT*STEWART_FABS(B_yy_bar);
        const stewart_real B_yz_bar = S_ddot_y_bar*q_z;
        const stewart_real B_yz_bar_err = S_ddot_y_bar_err*q_z_max + S_ddot_y_bar_max*q_z_err + STEWART_UNIT*STEWART_FABS(B_yz_bar);
        const stewart_real B_zx_bar = S_ddot_z_bar*q_x;
        const stewart_real B_zx_bar_err = S_ddot_z_bar_err*q_x_max + S_ddot_z_bar_max*q_x_err + STEWART_UNIT*STEWART_FABS(B_zx_bar);
        const stewart_real B_zy_bar = S_ddot_z_bar*q_y;
        const stewart_real B_zy_bar_err = S_ddot_z_bar_err*q_y_max + S_ddot_z_bar_max*q_y_err + STEWART_UNIT*STEWART_FABS(B_zy_bar);
        const stewart_real B_zz_bar = S_ddot_z_bar*q_z;
        const stewart_real B_zz_bar_err = S_ddot_z_bar_err*q_z_max + S_ddot_z_bar_max*q_z_err + STEWART_UNIT*STEWART_FABS(B_zz_bar);
        error[i] = error[i] + k_x_bar_max*k_x_err + k_y_bar_max*k_y_err + k_z_bar_max*k_z_err + h_x_bar_max*h_x_err
            + h_y_bar_max*h_y_err + h_z_bar_max*h_z_err + h2_x_bar_max*h2_x_err + h2_y_bar_max*h2_y_err + h2_z_bar_max*h2_z_err
            + w_x_bar_max*w_x_err + w_y_bar_max*w_y_err + w_z_bar_max*w_z_err + M_phi_bar_max*J_xx_err + a3_bar_max*J_xy_err
            + M_theta_bar_max*J_yy_err + J_yz_bar_max*J_yz_err + a2_bar_max*J2_xz_err + a1_bar_max*dJ_zx_err
            + g_k_bar_max*g_k_err + g_x_k_x_bar_max*g_x_k_x_err + g_x_k_y_bar_max*g_x_k_y_err + g_x_k_z_bar_max*g_x_k_z_err
            + C_us_bar_max*C_us_err + q_x_bar_max*q_x_own + q_y_bar_max*q_y_own + q_z_bar_max*q_z_own + S_x_bar_max*t_b_x_own
            + S_y_bar_max*t_b_y_own + S_z_bar_max*t_b_z_own + S_x_bar_max*S_x_own + S_y_bar_max*S_y_own + S_z_bar_max*S_z_own
            + zeta_bar_max*zeta_own + k_cross_S_x_bar_max*k_cross_S_x_own + k_cross_S_y_bar_max*k_cross_S_y_own
            + k_cross_S_z_bar_max*k_cross_S_z_own + rho2_bar_max*rho2_own + L_bar_max*L_own + rho_bar_max*rho_own
            + inv_L_bar_max*inv_L_own + s_x_bar_max*s_x_own + s_y_bar_max*s_y_own + s_z_bar_max*s_z_own + inv_rho_bar_max*inv_rho_own
            + y_x_bar_max*y_x_own + y_y_bar_max*y_y_own + y_z_bar_max*y_z_own + k1_bar_max*k1_own + k3_bar_max*k3_own
            + kappa_bar_max*kappa_own + S_dot_x_bar_max*S_dot_x_own + S_dot_y_bar_max*S_dot_y_own + S_dot_z_bar_max*S_dot_z_own
            + S_ddot_x_bar_max*S_ddot_x_own + S_ddot_y_bar_max*S_ddot_y_own + S_ddot_z_bar_max*S_ddot_z_own
            + L_dot_bar_max*L_dot_own + phi_dot_bar_max*phi_dot_own + theta_dot_bar_max*theta_dot_own + L_share_bar_max*L_share_own
            + rho_share_bar_max*lean_own + theta_dot2_bar_max*theta_dot2_own + phi_dot2_bar_max*phi_dot2_own
            + rho_share_bar_max*rho_share_own + k33_bar_max*k33_own + L_ddot_bar_max*L_ddot_own + theta_ddot_bar_max*theta_ddot_own
            + phi_ddot_bar_max*phi_ddot_own + k13_bar_max*k13_own + L_h2_bar_max*L_h2_own + a1_bar_max*a1_own
            + a2_bar_max*a2_own + a3_bar_max*a3_own + M_phi_bar_max*M_phi_own + M_theta_bar_max*M_theta_own
            + M_mixed_bar_max*M_mixed_own + c4_bar_max*k3_h_own + M_phi_theta_bar_max*M_phi_theta_own + M_phi_L_bar_max*M_phi_L_own
            + M_mixed_theta_bar_max*M_mixed_theta_own + c1_bar_max*c1_own + gamma_n_bar_max*gamma_n_own + gamma_y_bar_max*gamma_y_own
            + w_k_bar_max*w_k_own + w_n_bar_max*w_n_own + c2_bar_max*c2_own + c3_bar_max*c3_own + c4_bar_max*c4_own
            + tau_y_bar_max*tau_y_own + tau_k_bar_max*tau_k_own + Q_k_bar_max*Q_k_own + Q_y_bar_max*Q_y_own
            + c_force_x_bar_max*K_x_own + c_force_y_bar_max*K_y_own + c_force_z_bar_max*K_z_own + D_weight_max*D_own
            + c5_bar_max*c5_own + c6_bar_max*c6_own + arm_x_bar_max*arm_x_own + arm_y_bar_max*arm_y_own + arm_z_bar_max*arm_z_own
            + Y_moment_x_max*c_moment_x_own + Y_moment_y_max*c_moment_y_own + Y_moment_z_max*c_moment_z_own
            + H_moment_x_weight_max*H_moment_x_own + H_moment_y_weight_max*H_moment_y_own + H_moment_z_weight_max*H_moment_z_own
            + Y_arm_x_max*arm_c_x_own + Y_arm_y_max*arm_c_y_own + Y_arm_z_max*arm_c_z_own;
        add(&slopes->R_legs[0][i], &slopes->R_legs_err[0][i], R_xx_bar, R_xx_bar_err);
        add(&slopes->R_legs[1][i], &slopes->R_legs_err[1][i], R_xy_bar, R_xy_bar_err);
        add(&slopes->R_legs[2][i], &slopes->R_legs_err[2][i], R_xz_bar, R_xz_bar_err);
        add(&slopes->R_legs[3][i], &slopes->R_legs_err[3][i], R_yx_bar, R_yx_bar_err);
        add(&slopes->R_legs[4][i], &slopes->R_legs_err[4][i], R_yy_bar, R_yy_bar_err);
        add(&slopes->R_legs[5][i], &slopes->R_legs_err[5][i], R_yz_bar, R_yz_bar_err);
        add(&slopes->R_legs[6][i], &slopes->R_legs_err[6][i], R_zx_bar, R_zx_bar_err);
        add(&slopes->R_legs[7][i], &slopes->R_legs_err[7][i], R_zy_bar, R_zy_bar_err);
        add(&slopes->R_legs[8][i], &slopes->R_legs_err[8][i], R_zz_bar, R_zz_bar_err);
        add(&slopes->B_legs[0][i], &slopes->B_legs_err[0][i], B_xx_bar, B_xx_bar_err);
        add(&slopes->B_legs[1][i], &slopes->B_legs_err[1][i], B_xy_bar, B_xy_bar_err);
        add(&slopes->B_legs[2][i], &slopes->B_legs_err[2][i], B_xz_bar, B_xz_bar_err);
        add(&slopes->B_legs[3][i], &slopes->B_legs_err[3][i], B_yx_bar, B_yx_bar_err);
        add(&slopes->B_legs[4][i], &slopes->B_legs_err[4][i], B_yy_bar, B_yy_bar_err);
        add(&slopes->B_legs[5][i], &slopes->B_legs_err[5][i], B_yz_bar, B_yz_bar_err);
        add(&slopes->B_legs[6][i], &slopes->B_legs_err[6][i], B_zx_bar, B_zx_bar_err);
        add(&slopes->B_legs[7][i], &slopes->B_legs_err[7][i], B_zy_bar, B_zy_bar_err);
        add(&slopes->B_legs[8][i], &slopes->B_legs_err[8][i], B_zz_bar, B_zz_bar_err);
        add(&slopes->q_1_legs[0][i], &slopes->q_1_legs_err[0][i], -arm_x_bar, arm_x_bar_err);
        add(&slopes->q_1_legs[1][i], &slopes->q_1_legs_err[1][i], -arm_y_bar, arm_y_bar_err);
        add(&slopes->q_1_legs[2][i], &slopes->q_1_legs_err[2][i], -arm_z_bar, arm_z_bar_err);
    }
}

/* Terms of one leg with their errors. Adds the effects of the errors to the error of each force, and to
 * the derivatives of each force with respect to the common terms of the pose. */
static void leg_errors_near_singularity(
    const stewart_exact_drive_bounds_platform *platform, const stewart_exact_drive_bounds_leg *leg,
    const stewart_motions *at, const shared_terms *shared, stewart_real R_err,
    const force_rows *STEWART_RESTRICT rows, force_slopes *STEWART_RESTRICT slopes,
    stewart_real *STEWART_RESTRICT error, leg_terms *out)
{
    int i;
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = leg->k[0], k_y = leg->k[1], k_z = leg->k[2];
    const stewart_real k_x_err = leg->k_err[0], k_y_err = leg->k_err[1], k_z_err = leg->k_err[2];
    const stewart_real C_p = leg->C_p;
    const stewart_real C_s = leg->C_s;
    const stewart_real m_r = leg->m_r;
    const stewart_real j_r = leg->j_r;
    const stewart_real h_x = leg->h[0], h_y = leg->h[1], h_z = leg->h[2];
    const stewart_real h_x_err = leg->h_err[0], h_y_err = leg->h_err[1], h_z_err = leg->h_err[2];
    const stewart_real h2_x = leg->h2_x;
    const stewart_real h2_x_err = leg->h2_x_err;
    const stewart_real h2_y = leg->h2_y;
    const stewart_real h2_y_err = leg->h2_y_err;
    const stewart_real h2_z = leg->h2_z;
    const stewart_real h2_z_err = leg->h2_z_err;
    const stewart_real w_x = leg->w[0], w_y = leg->w[1], w_z = leg->w[2];
    const stewart_real w_x_err = leg->w_err[0], w_y_err = leg->w_err[1], w_z_err = leg->w_err[2];
    const stewart_real J_xx = leg->J[0], J_xy = leg->J[1], J_yy = leg->J[3], J_yz = leg->J[4];
    const stewart_real J_xx_err = leg->J_err[0], J_xy_err = leg->J_err[1], J_yy_err = leg->J_err[3],
        J_yz_err = leg->J_err[4];
    const stewart_real J2_xz = leg->J2_xz;
    const stewart_real J2_xz_err = leg->J2_xz_err;
    const stewart_real dJ_zx = leg->dJ_zx;
    const stewart_real dJ_zx_err = leg->dJ_zx_err;
    const stewart_real g_k = leg->g_k;
    const stewart_real g_k_err = leg->g_k_err;
    const stewart_real g_x_k_x = leg->g_x_k[0], g_x_k_y = leg->g_x_k[1], g_x_k_z = leg->g_x_k[2];
    const stewart_real g_x_k_x_err = leg->g_x_k_err[0], g_x_k_y_err = leg->g_x_k_err[1], g_x_k_z_err = leg->g_x_k_err[2];
    const stewart_real C_us = leg->C_us;
    const stewart_real C_us_err = leg->C_us_err;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real B_xx = shared->B[0], B_xy = shared->B[1], B_xz = shared->B[2], B_yx = shared->B[3],
        B_yy = shared->B[4], B_yz = shared->B[5], B_zx = shared->B[6], B_zy = shared->B[7], B_zz = shared->B[8];
    const stewart_real B_xx_err = shared->B_err[0], B_xy_err = shared->B_err[1], B_xz_err = shared->B_err[2],
        B_yx_err = shared->B_err[3], B_yy_err = shared->B_err[4], B_yz_err = shared->B_err[5], B_zx_err = shared->B_err[6],
        B_zy_err = shared->B_err[7], B_zz_err = shared->B_err[8];
    const stewart_real g_x = platform->g[0], g_y = platform->g[1], g_z = platform->g[2];
    const stewart_real q_1_x = shared->q_1[0], q_1_y = shared->q_1[1], q_1_z = shared->q_1[2];
    const stewart_real q_1_x_err = shared->q_1_err[0], q_1_y_err = shared->q_1_err[1], q_1_z_err = shared->q_1_err[2];
    const stewart_real p_x_max = STEWART_FABS(p_x);
    const stewart_real p_y_max = STEWART_FABS(p_y);
    const stewart_real p_z_max = STEWART_FABS(p_z);
    const stewart_real k_x_max = STEWART_FABS(k_x) + k_x_err;
    const stewart_real k_y_max = STEWART_FABS(k_y) + k_y_err;
    const stewart_real k_z_max = STEWART_FABS(k_z) + k_z_err;
    const stewart_real C_p_max = STEWART_FABS(C_p);
    const stewart_real C_s_max = STEWART_FABS(C_s);
    const stewart_real m_r_max = STEWART_FABS(m_r);
    const stewart_real j_r_max = STEWART_FABS(j_r);
    const stewart_real h_x_max = STEWART_FABS(h_x) + h_x_err;
    const stewart_real h_y_max = STEWART_FABS(h_y) + h_y_err;
    const stewart_real h_z_max = STEWART_FABS(h_z) + h_z_err;
    const stewart_real h2_x_max = STEWART_FABS(h2_x) + h2_x_err;
    const stewart_real h2_y_max = STEWART_FABS(h2_y) + h2_y_err;
    const stewart_real h2_z_max = STEWART_FABS(h2_z) + h2_z_err;
    const stewart_real w_x_max = STEWART_FABS(w_x) + w_x_err;
    const stewart_real w_y_max = STEWART_FABS(w_y) + w_y_err;
    const stewart_real w_z_max = STEWART_FABS(w_z) + w_z_err;
    const stewart_real J_xx_max = STEWART_FABS(J_xx) + J_xx_err;
    const stewart_real J_yy_max = STEWART_FABS(J_yy) + J_yy_err;
    const stewart_real J_yz_max = STEWART_FABS(J_yz) + J_yz_err;
    const stewart_real J2_xz_max = STEWART_FABS(J2_xz) + J2_xz_err;
    const stewart_real dJ_zx_max = STEWART_FABS(dJ_zx) + dJ_zx_err;
    const stewart_real g_k_max = STEWART_FABS(g_k) + g_k_err;
    const stewart_real g_x_k_x_max = STEWART_FABS(g_x_k_x) + g_x_k_x_err;
    const stewart_real g_x_k_y_max = STEWART_FABS(g_x_k_y) + g_x_k_y_err;
    const stewart_real g_x_k_z_max = STEWART_FABS(g_x_k_z) + g_x_k_z_err;
    const stewart_real C_us_max = STEWART_FABS(C_us) + C_us_err;
    const stewart_real R_xx_max = STEWART_FABS(R_xx) + R_err;
    const stewart_real R_xy_max = STEWART_FABS(R_xy) + R_err;
    const stewart_real R_xz_max = STEWART_FABS(R_xz) + R_err;
    const stewart_real R_yx_max = STEWART_FABS(R_yx) + R_err;
    const stewart_real R_yy_max = STEWART_FABS(R_yy) + R_err;
    const stewart_real R_yz_max = STEWART_FABS(R_yz) + R_err;
    const stewart_real R_zx_max = STEWART_FABS(R_zx) + R_err;
    const stewart_real R_zy_max = STEWART_FABS(R_zy) + R_err;
    const stewart_real R_zz_max = STEWART_FABS(R_zz) + R_err;
    const stewart_real omega_x_max = STEWART_FABS(omega_x);
    const stewart_real omega_y_max = STEWART_FABS(omega_y);
    const stewart_real omega_z_max = STEWART_FABS(omega_z);
    const stewart_real v_x_max = STEWART_FABS(v_x);
    const stewart_real v_y_max = STEWART_FABS(v_y);
    const stewart_real v_z_max = STEWART_FABS(v_z);
    const stewart_real a_x_max = STEWART_FABS(a_x);
    const stewart_real a_y_max = STEWART_FABS(a_y);
    const stewart_real a_z_max = STEWART_FABS(a_z);
    const stewart_real B_xx_max = STEWART_FABS(B_xx) + B_xx_err;
    const stewart_real B_xy_max = STEWART_FABS(B_xy) + B_xy_err;
    const stewart_real B_xz_max = STEWART_FABS(B_xz) + B_xz_err;
    const stewart_real B_yx_max = STEWART_FABS(B_yx) + B_yx_err;
    const stewart_real B_yy_max = STEWART_FABS(B_yy) + B_yy_err;
    const stewart_real B_yz_max = STEWART_FABS(B_yz) + B_yz_err;
    const stewart_real B_zx_max = STEWART_FABS(B_zx) + B_zx_err;
    const stewart_real B_zy_max = STEWART_FABS(B_zy) + B_zy_err;
    const stewart_real B_zz_max = STEWART_FABS(B_zz) + B_zz_err;
    const stewart_real g_x_max = STEWART_FABS(g_x);
    const stewart_real g_y_max = STEWART_FABS(g_y);
    const stewart_real g_z_max = STEWART_FABS(g_z);
    /* (1) platform point from the reference point */
    const stewart_real q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z;
    const stewart_real q_x_own = STEWART_UNIT*(R_xz_max*p_z_max + REAL(2)*R_xx_max*p_x_max + REAL(2)*R_xy_max*p_y_max
        + STEWART_FABS(q_x));
    const stewart_real q_x_err = R_err*(p_x_max + p_y_max + p_z_max) + q_x_own;
    const stewart_real q_x_max = STEWART_FABS(q_x) + q_x_err;
    const stewart_real q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z;
    const stewart_real q_y_own = STEWART_UNIT*(R_yz_max*p_z_max + REAL(2)*R_yx_max*p_x_max + REAL(2)*R_yy_max*p_y_max
        + STEWART_FABS(q_y));
    const stewart_real q_y_err = R_err*(p_x_max + p_y_max + p_z_max) + q_y_own;
    const stewart_real q_y_max = STEWART_FABS(q_y) + q_y_err;
    const stewart_real q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z;
    const stewart_real q_z_own = STEWART_UNIT*(R_zz_max*p_z_max + REAL(2)*R_zx_max*p_x_max + REAL(2)*R_zy_max*p_y_max
        + STEWART_FABS(q_z));
    const stewart_real q_z_err = R_err*(p_x_max + p_y_max + p_z_max) + q_z_own;
    const stewart_real q_z_max = STEWART_FABS(q_z) + q_z_err;
    /* (1) reference point from base point, base frame */
    const stewart_real t_b_x = t_x - b_x;
    const stewart_real t_b_x_own = STEWART_UNIT*STEWART_FABS(t_b_x);
    const stewart_real t_b_x_err = t_b_x_own;
    const stewart_real t_b_y = t_y - b_y;
    const stewart_real t_b_y_own = STEWART_UNIT*STEWART_FABS(t_b_y);
    const stewart_real t_b_y_err = t_b_y_own;
    const stewart_real t_b_z = t_z - b_z;
    const stewart_real t_b_z_own = STEWART_UNIT*STEWART_FABS(t_b_z);
    const stewart_real t_b_z_err = t_b_z_own;
    /* (1) leg vector */
    const stewart_real S_x = t_b_x + q_x;
    const stewart_real S_x_own = STEWART_UNIT*STEWART_FABS(S_x);
    const stewart_real S_x_err = q_x_err + t_b_x_err + S_x_own;
    const stewart_real S_x_max = STEWART_FABS(S_x) + S_x_err;
    const stewart_real S_y = t_b_y + q_y;
    const stewart_real S_y_own = STEWART_UNIT*STEWART_FABS(S_y);
    const stewart_real S_y_err = q_y_err + t_b_y_err + S_y_own;
    const stewart_real S_y_max = STEWART_FABS(S_y) + S_y_err;
    const stewart_real S_z = t_b_z + q_z;
    const stewart_real S_z_own = STEWART_UNIT*STEWART_FABS(S_z);
    const stewart_real S_z_err = q_z_err + t_b_z_err + S_z_own;
    const stewart_real S_z_max = STEWART_FABS(S_z) + S_z_err;
    /* (10) component of the leg vector along the fixed axis, and normal to both */
    const stewart_real zeta = S_x*k_x + S_y*k_y + S_z*k_z;
    const stewart_real zeta_own = STEWART_UNIT*(S_z_max*k_z_max + REAL(2)*S_x_max*k_x_max + REAL(2)*S_y_max*k_y_max
        + STEWART_FABS(zeta));
    const stewart_real zeta_err = S_x_err*k_x_max + S_x_max*k_x_err + S_y_err*k_y_max + S_y_max*k_y_err + S_z_err*k_z_max
        + S_z_max*k_z_err + zeta_own;
    const stewart_real zeta_max = STEWART_FABS(zeta) + zeta_err;
    const stewart_real k_cross_S_x = S_z*k_y - S_y*k_z;
    const stewart_real k_cross_S_x_own = STEWART_UNIT*(S_y_max*k_z_max + S_z_max*k_y_max + STEWART_FABS(k_cross_S_x));
    const stewart_real k_cross_S_x_err = S_y_err*k_z_max + S_y_max*k_z_err + S_z_err*k_y_max + S_z_max*k_y_err
        + k_cross_S_x_own;
    const stewart_real k_cross_S_x_max = STEWART_FABS(k_cross_S_x) + k_cross_S_x_err;
    const stewart_real k_cross_S_y = S_x*k_z - S_z*k_x;
    const stewart_real k_cross_S_y_own = STEWART_UNIT*(S_x_max*k_z_max + S_z_max*k_x_max + STEWART_FABS(k_cross_S_y));
    const stewart_real k_cross_S_y_err = S_x_err*k_z_max + S_x_max*k_z_err + S_z_err*k_x_max + S_z_max*k_x_err
        + k_cross_S_y_own;
    const stewart_real k_cross_S_y_max = STEWART_FABS(k_cross_S_y) + k_cross_S_y_err;
    const stewart_real k_cross_S_z = S_y*k_x - S_x*k_y;
    const stewart_real k_cross_S_z_own = STEWART_UNIT*(S_x_max*k_y_max + S_y_max*k_x_max + STEWART_FABS(k_cross_S_z));
    const stewart_real k_cross_S_z_err = S_x_err*k_y_max + S_x_max*k_y_err + S_y_err*k_x_max + S_y_max*k_x_err
        + k_cross_S_z_own;
    const stewart_real k_cross_S_z_max = STEWART_FABS(k_cross_S_z) + k_cross_S_z_err;
    /* (2) leg length, and distance of the tip from the fixed axis */
    const stewart_real L = STEWART_SQRT(S_x*S_x + S_y*S_y + S_z*S_z);
    const stewart_real L_own = root_error(L, STEWART_UNIT*(REAL(3)*S_x_max*S_x_max + REAL(3)*S_y_max*S_y_max
        + REAL(2)*S_z_max*S_z_max));
    const stewart_real L_err = root_error(L, REAL(2)*(S_x_err*S_x_max + S_y_err*S_y_max + S_z_err*S_z_max) + STEWART_UNIT*(REAL(3)*S_x_max*S_x_max
        + REAL(3)*S_y_max*S_y_max + REAL(2)*S_z_max*S_z_max));
    const stewart_real L_max = STEWART_FABS(L) + L_err;
    const stewart_real inv_L = REAL(1)/L;
    const stewart_real inv_L_own = STEWART_UNIT*STEWART_FABS(inv_L);
    const stewart_real inv_L_err = reciprocal_error(inv_L, L, L_err);
    const stewart_real inv_L_max = STEWART_FABS(inv_L) + inv_L_err;
    /* (3) unit vector along the leg */
    const stewart_real s_x = S_x*inv_L;
    const stewart_real s_x_own = STEWART_UNIT*STEWART_FABS(s_x);
    const stewart_real s_x_err = S_x_err*inv_L_max + S_x_max*inv_L_err + s_x_own;
    const stewart_real s_x_max = STEWART_FABS(s_x) + s_x_err;
    const stewart_real s_y = S_y*inv_L;
    const stewart_real s_y_own = STEWART_UNIT*STEWART_FABS(s_y);
    const stewart_real s_y_err = S_y_err*inv_L_max + S_y_max*inv_L_err + s_y_own;
    const stewart_real s_y_max = STEWART_FABS(s_y) + s_y_err;
    const stewart_real s_z = S_z*inv_L;
    const stewart_real s_z_own = STEWART_UNIT*STEWART_FABS(s_z);
    const stewart_real s_z_err = S_z_err*inv_L_max + S_z_max*inv_L_err + s_z_own;
    const stewart_real s_z_max = STEWART_FABS(s_z) + s_z_err;
    /* (10) along the third axis of the leg */
    const stewart_real s_cross_normal_x = k_cross_S_z*s_y - k_cross_S_y*s_z;
    const stewart_real s_cross_normal_x_own = STEWART_UNIT*(k_cross_S_y_max*s_z_max + k_cross_S_z_max*s_y_max
        + STEWART_FABS(s_cross_normal_x));
    const stewart_real s_cross_normal_x_err = k_cross_S_y_err*s_z_max + k_cross_S_y_max*s_z_err + k_cross_S_z_err*s_y_max
        + k_cross_S_z_max*s_y_err + s_cross_normal_x_own;
    const stewart_real s_cross_normal_x_max = STEWART_FABS(s_cross_normal_x) + s_cross_normal_x_err;
    const stewart_real s_cross_normal_y = k_cross_S_x*s_z - k_cross_S_z*s_x;
    const stewart_real s_cross_normal_y_own = STEWART_UNIT*(k_cross_S_x_max*s_z_max + k_cross_S_z_max*s_x_max
        + STEWART_FABS(s_cross_normal_y));
    const stewart_real s_cross_normal_y_err = k_cross_S_x_err*s_z_max + k_cross_S_x_max*s_z_err + k_cross_S_z_err*s_x_max
        + k_cross_S_z_max*s_x_err + s_cross_normal_y_own;
    const stewart_real s_cross_normal_y_max = STEWART_FABS(s_cross_normal_y) + s_cross_normal_y_err;
    const stewart_real s_cross_normal_z = k_cross_S_y*s_x - k_cross_S_x*s_y;
    const stewart_real s_cross_normal_z_own = STEWART_UNIT*(k_cross_S_x_max*s_y_max + k_cross_S_y_max*s_x_max
        + STEWART_FABS(s_cross_normal_z));
    const stewart_real s_cross_normal_z_err = k_cross_S_x_err*s_y_max + k_cross_S_x_max*s_y_err + k_cross_S_y_err*s_x_max
        + k_cross_S_y_max*s_x_err + s_cross_normal_z_own;
    const stewart_real s_cross_normal_z_max = STEWART_FABS(s_cross_normal_z) + s_cross_normal_z_err;
    /* (10) leg length, and distance of the tip from the fixed axis */
    const stewart_real rho = STEWART_SQRT(s_cross_normal_x*s_cross_normal_x + s_cross_normal_y*s_cross_normal_y
        + s_cross_normal_z*s_cross_normal_z);
    const stewart_real rho_own = root_error(rho,
        STEWART_UNIT*(REAL(3)*s_cross_normal_x_max*s_cross_normal_x_max + REAL(3)*s_cross_normal_y_max*s_cross_normal_y_max
        + REAL(2)*s_cross_normal_z_max*s_cross_normal_z_max));
    const stewart_real rho_err = root_error(rho, REAL(2)*(s_cross_normal_x_err*s_cross_normal_x_max + s_cross_normal_y_err*s_cross_normal_y_max
        + s_cross_normal_z_err*s_cross_normal_z_max) + STEWART_UNIT*(REAL(3)*s_cross_normal_x_max*s_cross_normal_x_max
        + REAL(3)*s_cross_normal_y_max*s_cross_normal_y_max + REAL(2)*s_cross_normal_z_max*s_cross_normal_z_max));
    const stewart_real rho_max = STEWART_FABS(rho) + rho_err;
    const stewart_real inv_rho = REAL(1)/rho;
    const stewart_real inv_rho_own = STEWART_UNIT*STEWART_FABS(inv_rho);
    const stewart_real inv_rho_err = reciprocal_error(inv_rho, rho, rho_err);
    const stewart_real inv_rho_max = STEWART_FABS(inv_rho) + inv_rho_err;
    /* (10) third axis of the leg frame */
    const stewart_real z_x = inv_rho*s_cross_normal_x;
    const stewart_real z_x_own = STEWART_UNIT*STEWART_FABS(z_x);
    const stewart_real z_x_err = inv_rho_err*s_cross_normal_x_max + inv_rho_max*s_cross_normal_x_err + z_x_own;
    const stewart_real z_x_max = STEWART_FABS(z_x) + z_x_err;
    const stewart_real z_y = inv_rho*s_cross_normal_y;
    const stewart_real z_y_own = STEWART_UNIT*STEWART_FABS(z_y);
    const stewart_real z_y_err = inv_rho_err*s_cross_normal_y_max + inv_rho_max*s_cross_normal_y_err + z_y_own;
    const stewart_real z_y_max = STEWART_FABS(z_y) + z_y_err;
    const stewart_real z_z = inv_rho*s_cross_normal_z;
    const stewart_real z_z_own = STEWART_UNIT*STEWART_FABS(z_z);
    const stewart_real z_z_err = inv_rho_err*s_cross_normal_z_max + inv_rho_max*s_cross_normal_z_err + z_z_own;
    const stewart_real z_z_max = STEWART_FABS(z_z) + z_z_err;
    /* (10) rotating axis of the universal joint */
    const stewart_real y_x = s_z*z_y - s_y*z_z;
    const stewart_real y_x_own = STEWART_UNIT*(s_y_max*z_z_max + s_z_max*z_y_max + STEWART_FABS(y_x));
    const stewart_real y_x_err = s_y_err*z_z_max + s_y_max*z_z_err + s_z_err*z_y_max + s_z_max*z_y_err + y_x_own;
    const stewart_real y_x_max = STEWART_FABS(y_x) + y_x_err;
    const stewart_real y_y = s_x*z_z - s_z*z_x;
    const stewart_real y_y_own = STEWART_UNIT*(s_x_max*z_z_max + s_z_max*z_x_max + STEWART_FABS(y_y));
    const stewart_real y_y_err = s_x_err*z_z_max + s_x_max*z_z_err + s_z_err*z_x_max + s_z_max*z_x_err + y_y_own;
    const stewart_real y_y_max = STEWART_FABS(y_y) + y_y_err;
    const stewart_real y_z = s_y*z_x - s_x*z_y;
    const stewart_real y_z_own = STEWART_UNIT*(s_x_max*z_y_max + s_y_max*z_x_max + STEWART_FABS(y_z));
    const stewart_real y_z_err = s_x_err*z_y_max + s_x_max*z_y_err + s_y_err*z_x_max + s_y_max*z_x_err + y_z_own;
    const stewart_real y_z_max = STEWART_FABS(y_z) + y_z_err;
    /* (10) k = (k1, 0, k3) in the leg frame */
    const stewart_real k1 = inv_L*zeta;
    const stewart_real k1_own = STEWART_UNIT*STEWART_FABS(k1);
    const stewart_real k1_err = inv_L_err*zeta_max + inv_L_max*zeta_err + k1_own;
    const stewart_real k1_max = STEWART_FABS(k1) + k1_err;
    const stewart_real k3 = inv_L*rho;
    const stewart_real k3_own = STEWART_UNIT*STEWART_FABS(k3);
    const stewart_real k3_err = inv_L_err*rho_max + inv_L_max*rho_err + k3_own;
    const stewart_real k3_max = STEWART_FABS(k3) + k3_err;
    /* (10) k1 / k3 */
    const stewart_real kappa = inv_rho*zeta;
    const stewart_real kappa_own = STEWART_UNIT*STEWART_FABS(kappa);
    const stewart_real kappa_err = inv_rho_err*zeta_max + inv_rho_max*zeta_err + kappa_own;
    const stewart_real kappa_max = STEWART_FABS(kappa) + kappa_err;
    /* (4) velocity of the platform point */
    const stewart_real S_dot_x = v_x + omega_y*q_z - omega_z*q_y;
    const stewart_real S_dot_x_own = STEWART_UNIT*(v_x_max + omega_z_max*q_y_max + REAL(2)*omega_y_max*q_z_max
        + STEWART_FABS(S_dot_x));
    const stewart_real S_dot_x_err = omega_y_max*q_z_err + omega_z_max*q_y_err + S_dot_x_own;
    const stewart_real S_dot_x_max = STEWART_FABS(S_dot_x) + S_dot_x_err;
    const stewart_real S_dot_y = v_y + omega_z*q_x - omega_x*q_z;
    const stewart_real S_dot_y_own = STEWART_UNIT*(v_y_max + omega_x_max*q_z_max + REAL(2)*omega_z_max*q_x_max
        + STEWART_FABS(S_dot_y));
    const stewart_real S_dot_y_err = omega_x_max*q_z_err + omega_z_max*q_x_err + S_dot_y_own;
    const stewart_real S_dot_y_max = STEWART_FABS(S_dot_y) + S_dot_y_err;
    const stewart_real S_dot_z = v_z + omega_x*q_y - omega_y*q_x;
    const stewart_real S_dot_z_own = STEWART_UNIT*(v_z_max + omega_y_max*q_x_max + REAL(2)*omega_x_max*q_y_max
        + STEWART_FABS(S_dot_z));
    const stewart_real S_dot_z_err = omega_x_max*q_y_err + omega_y_max*q_x_err + S_dot_z_own;
    const stewart_real S_dot_z_max = STEWART_FABS(S_dot_z) + S_dot_z_err;
    /* (7) acceleration of the platform point */
    const stewart_real S_ddot_x = a_x + B_xx*q_x + B_xy*q_y + B_xz*q_z;
    const stewart_real S_ddot_x_own = STEWART_UNIT*(B_xz_max*q_z_max + REAL(2)*a_x_max + REAL(3)*B_xx_max*q_x_max
        + REAL(2)*B_xy_max*q_y_max + STEWART_FABS(S_ddot_x));
    const stewart_real S_ddot_x_err = B_xx_err*q_x_max + B_xx_max*q_x_err + B_xy_err*q_y_max + B_xy_max*q_y_err
        + B_xz_err*q_z_max + B_xz_max*q_z_err + S_ddot_x_own;
    const stewart_real S_ddot_x_max = STEWART_FABS(S_ddot_x) + S_ddot_x_err;
    const stewart_real S_ddot_y = a_y + B_yx*q_x + B_yy*q_y + B_yz*q_z;
    const stewart_real S_ddot_y_own = STEWART_UNIT*(B_yz_max*q_z_max + REAL(2)*a_y_max + REAL(3)*B_yx_max*q_x_max
        + REAL(2)*B_yy_max*q_y_max + STEWART_FABS(S_ddot_y));
    const stewart_real S_ddot_y_err = B_yx_err*q_x_max + B_yx_max*q_x_err + B_yy_err*q_y_max + B_yy_max*q_y_err
        + B_yz_err*q_z_max + B_yz_max*q_z_err + S_ddot_y_own;
    const stewart_real S_ddot_y_max = STEWART_FABS(S_ddot_y) + S_ddot_y_err;
    const stewart_real S_ddot_z = a_z + B_zx*q_x + B_zy*q_y + B_zz*q_z;
    const stewart_real S_ddot_z_own = STEWART_UNIT*(B_zz_max*q_z_max + REAL(2)*a_z_max + REAL(3)*B_zx_max*q_x_max
        + REAL(2)*B_zy_max*q_y_max + STEWART_FABS(S_ddot_z));
    const stewart_real S_ddot_z_err = B_zx_err*q_x_max + B_zx_max*q_x_err + B_zy_err*q_y_max + B_zy_max*q_y_err
        + B_zz_err*q_z_max + B_zz_max*q_z_err + S_ddot_z_own;
    const stewart_real S_ddot_z_max = STEWART_FABS(S_ddot_z) + S_ddot_z_err;
    /* (5) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z;
    const stewart_real L_dot_own = STEWART_UNIT*(S_dot_z_max*s_z_max + REAL(2)*S_dot_x_max*s_x_max + REAL(2)*S_dot_y_max*s_y_max
        + STEWART_FABS(L_dot));
    const stewart_real L_dot_err = S_dot_x_err*s_x_max + S_dot_x_max*s_x_err + S_dot_y_err*s_y_max + S_dot_y_max*s_y_err
        + S_dot_z_err*s_z_max + S_dot_z_max*s_z_err + L_dot_own;
    const stewart_real L_dot_max = STEWART_FABS(L_dot) + L_dot_err;
    /* (6) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z);
    const stewart_real phi_dot_own = STEWART_UNIT*(inv_rho_max*(REAL(3)*S_dot_x_max*y_x_max + REAL(3)*S_dot_y_max*y_y_max
        + REAL(2)*S_dot_z_max*y_z_max) + STEWART_FABS(phi_dot));
    const stewart_real phi_dot_err = S_dot_x_err*inv_rho_max*y_x_max + S_dot_x_max*inv_rho_max*y_x_err + S_dot_y_err*inv_rho_max*y_y_max
        + S_dot_y_max*inv_rho_max*y_y_err + S_dot_z_err*inv_rho_max*y_z_max + S_dot_z_max*inv_rho_max*y_z_err
        + inv_rho_err*(S_dot_x_max*y_x_max + S_dot_y_max*y_y_max + S_dot_z_max*y_z_max) + phi_dot_own;
    const stewart_real phi_dot_max = STEWART_FABS(phi_dot) + phi_dot_err;
    const stewart_real theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z);
    const stewart_real theta_dot_own = STEWART_UNIT*(inv_L_max*(REAL(3)*S_dot_x_max*z_x_max + REAL(3)*S_dot_y_max*z_y_max
        + REAL(2)*S_dot_z_max*z_z_max) + STEWART_FABS(theta_dot));
    const stewart_real theta_dot_err = S_dot_x_err*inv_L_max*z_x_max + S_dot_x_max*inv_L_max*z_x_err + S_dot_y_err*inv_L_max*z_y_max
        + S_dot_y_max*inv_L_max*z_y_err + S_dot_z_err*inv_L_max*z_z_max + S_dot_z_max*inv_L_max*z_z_err + inv_L_err*(S_dot_x_max*z_x_max
        + S_dot_y_max*z_y_max + S_dot_z_max*z_z_max) + theta_dot_own;
    const stewart_real theta_dot_max = STEWART_FABS(theta_dot) + theta_dot_err;
    /* L_dot / L */
    const stewart_real L_share = L_dot*inv_L;
    const stewart_real L_share_own = STEWART_UNIT*STEWART_FABS(L_share);
    const stewart_real L_share_err = L_dot_err*inv_L_max + L_dot_max*inv_L_err + L_share_own;
    const stewart_real L_share_max = STEWART_FABS(L_share) + L_share_err;
    const stewart_real lean = kappa*theta_dot;
    const stewart_real lean_own = STEWART_UNIT*STEWART_FABS(lean);
    const stewart_real lean_err = kappa_err*theta_dot_max + kappa_max*theta_dot_err + lean_own;
    const stewart_real lean_max = STEWART_FABS(lean) + lean_err;
    const stewart_real theta_dot2 = theta_dot*theta_dot;
    const stewart_real theta_dot2_own = STEWART_UNIT*STEWART_FABS(theta_dot2);
    const stewart_real theta_dot2_err = REAL(2)*theta_dot_err*theta_dot_max + theta_dot2_own;
    const stewart_real theta_dot2_max = STEWART_FABS(theta_dot2) + theta_dot2_err;
    const stewart_real phi_dot2 = phi_dot*phi_dot;
    const stewart_real phi_dot2_own = STEWART_UNIT*STEWART_FABS(phi_dot2);
    const stewart_real phi_dot2_err = REAL(2)*phi_dot_err*phi_dot_max + phi_dot2_own;
    const stewart_real phi_dot2_max = STEWART_FABS(phi_dot2) + phi_dot2_err;
    const stewart_real two_phi_dot = REAL(2)*phi_dot;
    const stewart_real two_phi_dot_err = REAL(2)*phi_dot_err;
    const stewart_real two_phi_dot_max = STEWART_FABS(two_phi_dot) + two_phi_dot_err;
    const stewart_real k33 = k3*k3;
    const stewart_real k33_own = STEWART_UNIT*STEWART_FABS(k33);
    const stewart_real k33_err = REAL(2)*k3_err*k3_max + k33_own;
    const stewart_real k33_max = STEWART_FABS(k33) + k33_err;
    /* (8) accelerations of the joint coordinates */
    const stewart_real L_ddot = L*(theta_dot2 + k33*phi_dot2) + S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z;
    const stewart_real L_ddot_own = STEWART_UNIT*(S_ddot_z_max*s_z_max + REAL(3)*S_ddot_x_max*s_x_max + REAL(2)*S_ddot_y_max*s_y_max
        + REAL(3)*L_max*(theta_dot2_max + k33_max*phi_dot2_max) + L_max*(theta_dot2_max + REAL(2)*k33_max*phi_dot2_max)
        + STEWART_FABS(L_ddot));
    const stewart_real L_ddot_err = L_max*theta_dot2_err + S_ddot_x_err*s_x_max + S_ddot_x_max*s_x_err + S_ddot_y_err*s_y_max
        + S_ddot_y_max*s_y_err + S_ddot_z_err*s_z_max + S_ddot_z_max*s_z_err + L_max*k33_err*phi_dot2_max + L_max*k33_max*phi_dot2_err
        + L_err*(theta_dot2_max + k33_max*phi_dot2_max) + L_ddot_own;
    const stewart_real L_ddot_max = STEWART_FABS(L_ddot) + L_ddot_err;
    /* (9) accelerations of the joint coordinates without the rotation of the leg frame about s */
    const stewart_real own_theta_ddot = -inv_L*(S_ddot_x*z_x + S_ddot_y*z_y + S_ddot_z*z_z) - REAL(2)*L_share*theta_dot;
    const stewart_real own_theta_ddot_own = STEWART_UNIT*(REAL(2)*L_share_max*theta_dot_max + inv_L_max*(S_ddot_x_max*z_x_max
        + S_ddot_y_max*z_y_max + S_ddot_z_max*z_z_max) + inv_L_max*(REAL(3)*S_ddot_x_max*z_x_max + REAL(3)*S_ddot_y_max*z_y_max
        + REAL(2)*S_ddot_z_max*z_z_max) + STEWART_FABS(own_theta_ddot));
    const stewart_real own_theta_ddot_err = REAL(2)*L_share_err*theta_dot_max + REAL(2)*L_share_max*theta_dot_err
        + S_ddot_x_err*inv_L_max*z_x_max + S_ddot_x_max*inv_L_max*z_x_err + S_ddot_y_err*inv_L_max*z_y_max + S_ddot_y_max*inv_L_max*z_y_err
        + S_ddot_z_err*inv_L_max*z_z_max + S_ddot_z_max*inv_L_max*z_z_err + inv_L_err*(S_ddot_x_max*z_x_max
        + S_ddot_y_max*z_y_max + S_ddot_z_max*z_z_max) + own_theta_ddot_own;
    const stewart_real own_theta_ddot_max = STEWART_FABS(own_theta_ddot) + own_theta_ddot_err;
    const stewart_real own_phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z) - L_share*two_phi_dot;
    const stewart_real own_phi_ddot_own = STEWART_UNIT*(L_share_max*two_phi_dot_max + inv_rho_max*(S_ddot_x_max*y_x_max
        + S_ddot_y_max*y_y_max + S_ddot_z_max*y_z_max) + inv_rho_max*(REAL(3)*S_ddot_x_max*y_x_max + REAL(3)*S_ddot_y_max*y_y_max
        + REAL(2)*S_ddot_z_max*y_z_max) + STEWART_FABS(own_phi_ddot));
    const stewart_real own_phi_ddot_err = L_share_err*two_phi_dot_max + L_share_max*two_phi_dot_err + S_ddot_x_err*inv_rho_max*y_x_max
        + S_ddot_x_max*inv_rho_max*y_x_err + S_ddot_y_err*inv_rho_max*y_y_max + S_ddot_y_max*inv_rho_max*y_y_err
        + S_ddot_z_err*inv_rho_max*y_z_max + S_ddot_z_max*inv_rho_max*y_z_err + inv_rho_err*(S_ddot_x_max*y_x_max
        + S_ddot_y_max*y_y_max + S_ddot_z_max*y_z_max) + own_phi_ddot_own;
    const stewart_real own_phi_ddot_max = STEWART_FABS(own_phi_ddot) + own_phi_ddot_err;
    const stewart_real c1 = k1*k3;
    const stewart_real c1_own = STEWART_UNIT*STEWART_FABS(c1);
    const stewart_real c1_err = k1_err*k3_max + k1_max*k3_err + c1_own;
    const stewart_real c1_max = STEWART_FABS(c1) + c1_err;
    /* (9) accelerations of the joint coordinates */
    const stewart_real theta_ddot = c1*phi_dot2 + own_theta_ddot;
    const stewart_real theta_ddot_own = STEWART_UNIT*(c1_max*phi_dot2_max + STEWART_FABS(theta_ddot));
    const stewart_real theta_ddot_err = own_theta_ddot_err + c1_err*phi_dot2_max + c1_max*phi_dot2_err + theta_ddot_own;
    const stewart_real theta_ddot_max = STEWART_FABS(theta_ddot) + theta_ddot_err;
    const stewart_real phi_ddot = own_phi_ddot - lean*two_phi_dot;
    const stewart_real phi_ddot_own = STEWART_UNIT*(lean_max*two_phi_dot_max + STEWART_FABS(phi_ddot));
    const stewart_real phi_ddot_err = own_phi_ddot_err + lean_err*two_phi_dot_max + lean_max*two_phi_dot_err
        + phi_ddot_own;
    const stewart_real phi_ddot_max = STEWART_FABS(phi_ddot) + phi_ddot_err;
    const stewart_real k13 = c1;
    const stewart_real k13_err = c1_err;
    const stewart_real k13_max = STEWART_FABS(k13) + k13_err;
    const stewart_real L_h2 = L*h2_x;
    const stewart_real L_h2_own = STEWART_UNIT*STEWART_FABS(L_h2);
    const stewart_real L_h2_err = L_err*h2_x_max + L_max*h2_x_err + L_h2_own;
    const stewart_real a1 = dJ_zx + L_h2;
    const stewart_real a1_own = STEWART_UNIT*STEWART_FABS(a1);
    const stewart_real a1_err = L_h2_err + dJ_zx_err + a1_own;
    const stewart_real a1_max = STEWART_FABS(a1) + a1_err;
    const stewart_real c2 = L*h2_z;
    const stewart_real c2_own = STEWART_UNIT*STEWART_FABS(c2);
    const stewart_real c2_err = L_err*h2_z_max + L_max*h2_z_err + c2_own;
    const stewart_real c2_max = STEWART_FABS(c2) + c2_err;
    const stewart_real c3 = J2_xz - c2;
    const stewart_real c3_own = STEWART_UNIT*STEWART_FABS(c3);
    const stewart_real c3_err = J2_xz_err + c2_err + c3_own;
    const stewart_real c3_max = STEWART_FABS(c3) + c3_err;
    const stewart_real a2 = c3;
    const stewart_real a2_err = c3_err;
    const stewart_real a2_max = STEWART_FABS(a2) + a2_err;
    const stewart_real a3 = J_xy - L*h_y;
    const stewart_real a3_own = STEWART_UNIT*(L_max*h_y_max + STEWART_FABS(a3));
    const stewart_real a3_err = J_xy_err + L_err*h_y_max + L_max*h_y_err + a3_own;
    const stewart_real a3_max = STEWART_FABS(a3) + a3_err;
    /* (19) inertia of the joint coordinates */
    const stewart_real M_phi = J_xx + a1*k33 + a2*k13;
    const stewart_real M_phi_own = STEWART_UNIT*(J_xx_max + a2_max*k13_max + REAL(2)*a1_max*k33_max + STEWART_FABS(M_phi));
    const stewart_real M_phi_err = J_xx_err + a1_err*k33_max + a1_max*k33_err + a2_err*k13_max + a2_max*k13_err
        + M_phi_own;
    const stewart_real M_phi_max = STEWART_FABS(M_phi) + M_phi_err;
    const stewart_real M_theta = J_yy + L_h2;
    const stewart_real M_theta_own = STEWART_UNIT*STEWART_FABS(M_theta);
    const stewart_real M_theta_err = J_yy_err + L_h2_err + M_theta_own;
    const stewart_real M_theta_max = STEWART_FABS(M_theta) + M_theta_err;
    const stewart_real M_mixed = J_yz*k3 + a3*k1;
    const stewart_real M_mixed_own = STEWART_UNIT*(J_yz_max*k3_max + a3_max*k1_max + STEWART_FABS(M_mixed));
    const stewart_real M_mixed_err = J_yz_err*k3_max + J_yz_max*k3_err + a3_err*k1_max + a3_max*k1_err + M_mixed_own;
    const stewart_real M_mixed_max = STEWART_FABS(M_mixed) + M_mixed_err;
    const stewart_real k3_h = h_y*k3;
    const stewart_real k3_h_own = STEWART_UNIT*STEWART_FABS(k3_h);
    const stewart_real k3_h_err = h_y_err*k3_max + h_y_max*k3_err + k3_h_own;
    /* (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta */
    const stewart_real M_phi_L = h_x*k33 - h_z*k13;
    const stewart_real M_phi_L_own = STEWART_UNIT*(h_x_max*k33_max + h_z_max*k13_max + STEWART_FABS(M_phi_L));
    const stewart_real M_phi_L_err = h_x_err*k33_max + h_x_max*k33_err + h_z_err*k13_max + h_z_max*k13_err + M_phi_L_own;
    const stewart_real M_phi_L_max = STEWART_FABS(M_phi_L) + M_phi_L_err;
    const stewart_real M_mixed_theta = J_yz*k1 - a3*k3;
    const stewart_real M_mixed_theta_own = STEWART_UNIT*(J_yz_max*k1_max + a3_max*k3_max + STEWART_FABS(M_mixed_theta));
    const stewart_real M_mixed_theta_err = J_yz_err*k1_max + J_yz_max*k1_err + a3_err*k3_max + a3_max*k3_err
        + M_mixed_theta_own;
    const stewart_real M_mixed_theta_max = STEWART_FABS(M_mixed_theta) + M_mixed_theta_err;
    const stewart_real c4 = L_dot*theta_dot;
    const stewart_real c4_own = STEWART_UNIT*STEWART_FABS(c4);
    const stewart_real c4_err = L_dot_err*theta_dot_max + L_dot_max*theta_dot_err + c4_own;
    const stewart_real c4_max = STEWART_FABS(c4) + c4_err;
    const stewart_real bend = c4;
    const stewart_real bend_err = c4_err;
    const stewart_real bend_max = STEWART_FABS(bend) + bend_err;
    /* components of gravity along k x y and along y */
    const stewart_real gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z;
    const stewart_real gamma_n_own = STEWART_UNIT*(g_x_k_z_max*y_z_max + REAL(2)*g_x_k_x_max*y_x_max + REAL(2)*g_x_k_y_max*y_y_max
        + STEWART_FABS(gamma_n));
    const stewart_real gamma_n_err = g_x_k_x_err*y_x_max + g_x_k_x_max*y_x_err + g_x_k_y_err*y_y_max + g_x_k_y_max*y_y_err
        + g_x_k_z_err*y_z_max + g_x_k_z_max*y_z_err + gamma_n_own;
    const stewart_real gamma_n_max = STEWART_FABS(gamma_n) + gamma_n_err;
    const stewart_real gamma_y = g_x*y_x + g_y*y_y + g_z*y_z;
    const stewart_real gamma_y_own = STEWART_UNIT*(g_z_max*y_z_max + REAL(2)*g_x_max*y_x_max + REAL(2)*g_y_max*y_y_max
        + STEWART_FABS(gamma_y));
    const stewart_real gamma_y_err = g_x_max*y_x_err + g_y_max*y_y_err + g_z_max*y_z_err + gamma_y_own;
    const stewart_real gamma_y_max = STEWART_FABS(gamma_y) + gamma_y_err;
    /* components of the first moment along k and along -k x y */
    const stewart_real w_k = k3*w_z + k1*w_x;
    const stewart_real w_k_own = STEWART_UNIT*(k1_max*w_x_max + k3_max*w_z_max + STEWART_FABS(w_k));
    const stewart_real w_k_err = k1_err*w_x_max + k1_max*w_x_err + k3_err*w_z_max + k3_max*w_z_err + w_k_own;
    const stewart_real w_k_max = STEWART_FABS(w_k) + w_k_err;
    const stewart_real w_n = k3*w_x - k1*w_z;
    const stewart_real w_n_own = STEWART_UNIT*(k1_max*w_z_max + k3_max*w_x_max + STEWART_FABS(w_n));
    const stewart_real w_n_err = k1_err*w_z_max + k1_max*w_z_err + k3_err*w_x_max + k3_max*w_x_err + w_n_own;
    const stewart_real w_n_max = STEWART_FABS(w_n) + w_n_err;
    const stewart_real c5 = j_r*k3;
    const stewart_real c5_own = STEWART_UNIT*STEWART_FABS(c5);
    const stewart_real c5_err = j_r_max*k3_err + c5_own;
    const stewart_real c5_max = STEWART_FABS(c5) + c5_err;
    const stewart_real c6 = c5*phi_dot;
    const stewart_real c6_own = STEWART_UNIT*STEWART_FABS(c6);
    const stewart_real c6_err = c5_err*phi_dot_max + c5_max*phi_dot_err + c6_own;
    const stewart_real c6_max = STEWART_FABS(c6) + c6_err;
    const stewart_real c7 = j_r*k1 - k3_h;
    const stewart_real c7_own = STEWART_UNIT*(j_r_max*k1_max + STEWART_FABS(c7));
    const stewart_real c7_err = k3_h_err + j_r_max*k1_err + c7_own;
    const stewart_real c7_max = STEWART_FABS(c7) + c7_err;
    /* (20) generalized forces about y and about k */
    const stewart_real tau_y = L_ddot*h_z + g_k*w_n + phi_dot2*(k13*(J_yy - dJ_zx) - c3*(STEWART_HALF - k33))
        + C_us*theta_dot + bend*h2_x + gamma_n*w_k - C_s*(omega_x*y_x + omega_y*y_y + omega_z*y_z) + L_dot*c6
        + M_theta*own_theta_ddot + M_mixed*phi_ddot;
    const stewart_real tau_y_own = STEWART_UNIT*(M_mixed_max*phi_ddot_max + REAL(7)*C_us_max*theta_dot_max + REAL(9)*L_ddot_max*h_z_max
        + REAL(3)*L_dot_max*c6_max + REAL(2)*M_theta_max*own_theta_ddot_max + REAL(6)*bend_max*h2_x_max + REAL(9)*g_k_max*w_n_max
        + REAL(5)*gamma_n_max*w_k_max + REAL(4)*C_s_max*(omega_x_max*y_x_max + omega_y_max*y_y_max + omega_z_max*y_z_max)
        + C_s_max*(REAL(3)*omega_x_max*y_x_max + REAL(3)*omega_y_max*y_y_max + REAL(2)*omega_z_max*y_z_max)
        + REAL(8)*phi_dot2_max*(c3_max*(k33_max + STEWART_HALF) + k13_max*(J_yy_max + dJ_zx_max)) + phi_dot2_max*(REAL(3)*c3_max*(k33_max
        + STEWART_HALF) + REAL(3)*k13_max*(J_yy_max + dJ_zx_max)) + STEWART_FABS(tau_y));
    const stewart_real tau_y_err = C_us_err*theta_dot_max + C_us_max*theta_dot_err + L_ddot_err*h_z_max + L_ddot_max*h_z_err
        + L_dot_err*c6_max + L_dot_max*c6_err + M_mixed_err*phi_ddot_max + M_mixed_max*phi_ddot_err + M_theta_err*own_theta_ddot_max
        + M_theta_max*own_theta_ddot_err + bend_err*h2_x_max + bend_max*h2_x_err + g_k_err*w_n_max + g_k_max*w_n_err
        + gamma_n_err*w_k_max + gamma_n_max*w_k_err + C_s_max*omega_x_max*y_x_err + C_s_max*omega_y_max*y_y_err
        + C_s_max*omega_z_max*y_z_err + J_yy_err*k13_max*phi_dot2_max + c3_max*k33_err*phi_dot2_max + dJ_zx_err*k13_max*phi_dot2_max
        + c3_err*phi_dot2_max*(k33_max + STEWART_HALF) + k13_err*phi_dot2_max*(J_yy_max + dJ_zx_max) + phi_dot2_err*(c3_max*(k33_max
        + STEWART_HALF) + k13_max*(J_yy_max + dJ_zx_max)) + tau_y_own;
    const stewart_real tau_y_max = STEWART_FABS(tau_y) + tau_y_err;
    const stewart_real tau_k = L_ddot*c7 - C_s*(k_x*omega_x + k_y*omega_y + k_z*omega_z) + M_mixed_theta*theta_dot2
        + C_us*phi_dot - c4*c5 - gamma_n*w_y - gamma_y*w_n + two_phi_dot*(L_dot*M_phi_L - theta_dot*(STEWART_HALF*J2_xz
        - STEWART_HALF*c2 + J_xx*kappa)) - bend*h2_y*k1 + M_mixed*theta_ddot + M_phi*own_phi_ddot;
    const stewart_real tau_k_own = STEWART_UNIT*(M_phi_max*own_phi_ddot_max + REAL(8)*C_us_max*phi_dot_max + REAL(10)*L_ddot_max*c7_max
        + REAL(2)*M_mixed_max*theta_ddot_max + REAL(9)*M_mixed_theta_max*theta_dot2_max + REAL(7)*c4_max*c5_max
        + REAL(6)*gamma_n_max*w_y_max + REAL(5)*gamma_y_max*w_n_max + REAL(4)*bend_max*h2_y_max*k1_max + REAL(10)*C_s_max*(k_x_max*omega_x_max
        + k_y_max*omega_y_max + k_z_max*omega_z_max) + C_s_max*(REAL(3)*k_x_max*omega_x_max + REAL(3)*k_y_max*omega_y_max
        + REAL(2)*k_z_max*omega_z_max) + REAL(4)*two_phi_dot_max*(L_dot_max*M_phi_L_max + theta_dot_max*(STEWART_HALF*J2_xz_max
        + J_xx_max*kappa_max + STEWART_HALF*c2_max)) + two_phi_dot_max*(REAL(2)*(L_dot_max*M_phi_L_max + theta_dot_max*(STEWART_HALF*J2_xz_max
        + J_xx_max*kappa_max + STEWART_HALF*c2_max) + STEWART_HALF*theta_dot_max*(J2_xz_max + c2_max + REAL(2)*J_xx_max*kappa_max)))
        + STEWART_FABS(tau_k));
    const stewart_real tau_k_err = C_us_err*phi_dot_max + C_us_max*phi_dot_err + L_ddot_err*c7_max + L_ddot_max*c7_err
        + M_mixed_err*theta_ddot_max + M_mixed_max*theta_ddot_err + M_mixed_theta_err*theta_dot2_max + M_mixed_theta_max*theta_dot2_err
        + M_phi_err*own_phi_ddot_max + M_phi_max*own_phi_ddot_err + c4_err*c5_max + c4_max*c5_err + gamma_n_err*w_y_max
        + gamma_n_max*w_y_err + gamma_y_err*w_n_max + gamma_y_max*w_n_err + C_s_max*k_x_err*omega_x_max + C_s_max*k_y_err*omega_y_max
        + C_s_max*k_z_err*omega_z_max + L_dot_err*M_phi_L_max*two_phi_dot_max + L_dot_max*M_phi_L_err*two_phi_dot_max
        + bend_err*h2_y_max*k1_max + bend_max*h2_y_err*k1_max + bend_max*h2_y_max*k1_err + STEWART_HALF*J2_xz_err*theta_dot_max*two_phi_dot_max
        + J_xx_err*kappa_max*theta_dot_max*two_phi_dot_max + J_xx_max*kappa_err*theta_dot_max*two_phi_dot_max
        + STEWART_HALF*c2_err*theta_dot_max*two_phi_dot_max + theta_dot_err*two_phi_dot_max*(STEWART_HALF*J2_xz_max
        + J_xx_max*kappa_max + STEWART_HALF*c2_max) + two_phi_dot_err*(L_dot_max*M_phi_L_max + theta_dot_max*(STEWART_HALF*J2_xz_max
        + J_xx_max*kappa_max + STEWART_HALF*c2_max)) + tau_k_own;
    const stewart_real tau_k_max = STEWART_FABS(tau_k) + tau_k_err;
    /* (21) K = Q_y y + Q_z z */
    const stewart_real Q_y = inv_rho*tau_k;
    const stewart_real Q_y_own = STEWART_UNIT*STEWART_FABS(Q_y);
    const stewart_real Q_y_err = inv_rho_err*tau_k_max + inv_rho_max*tau_k_err + Q_y_own;
    const stewart_real Q_y_max = STEWART_FABS(Q_y) + Q_y_err;
    const stewart_real Q_z = -inv_L*tau_y;
    const stewart_real Q_z_own = STEWART_UNIT*STEWART_FABS(Q_z);
    const stewart_real Q_z_err = inv_L_err*tau_y_max + inv_L_max*tau_y_err + Q_z_own;
    const stewart_real Q_z_max = STEWART_FABS(Q_z) + Q_z_err;
    /* (21) force at the spherical joint, base frame */
    const stewart_real K_x = Q_z*z_x + Q_y*y_x;
    const stewart_real K_x_own = STEWART_UNIT*(Q_y_max*y_x_max + Q_z_max*z_x_max + STEWART_FABS(K_x));
    const stewart_real K_x_err = Q_y_err*y_x_max + Q_y_max*y_x_err + Q_z_err*z_x_max + Q_z_max*z_x_err + K_x_own;
    const stewart_real K_y = Q_z*z_y + Q_y*y_y;
    const stewart_real K_y_own = STEWART_UNIT*(Q_y_max*y_y_max + Q_z_max*z_y_max + STEWART_FABS(K_y));
    const stewart_real K_y_err = Q_y_err*y_y_max + Q_y_max*y_y_err + Q_z_err*z_y_max + Q_z_max*z_y_err + K_y_own;
    const stewart_real K_z = Q_z*z_z + Q_y*y_z;
    const stewart_real K_z_own = STEWART_UNIT*(Q_y_max*y_z_max + Q_z_max*z_z_max + STEWART_FABS(K_z));
    const stewart_real K_z_err = Q_y_err*y_z_max + Q_y_max*y_z_err + Q_z_err*z_z_max + Q_z_max*z_z_err + K_z_own;
    /* (24) known part of the actuator force for this K */
    const stewart_real D = C_p*L_dot - h_x*theta_dot2 + L_ddot*m_r - M_phi_L*phi_dot2 + h_z*theta_ddot - c6*theta_dot
        + c7*phi_ddot;
    const stewart_real D_own = STEWART_UNIT*(c7_max*phi_ddot_max + REAL(6)*C_p_max*L_dot_max + REAL(5)*L_ddot_max*m_r_max
        + REAL(4)*M_phi_L_max*phi_dot2_max + REAL(2)*c6_max*theta_dot_max + REAL(6)*h_x_max*theta_dot2_max + REAL(3)*h_z_max*theta_ddot_max
        + STEWART_FABS(D));
    const stewart_real c8 = C_s*phi_dot;
    const stewart_real c8_own = STEWART_UNIT*STEWART_FABS(c8);
    const stewart_real c8_err = C_s_max*phi_dot_err + c8_own;
    const stewart_real c8_max = STEWART_FABS(c8) + c8_err;
    const stewart_real c9 = C_s*theta_dot;
    const stewart_real c9_own = STEWART_UNIT*STEWART_FABS(c9);
    const stewart_real c9_err = C_s_max*theta_dot_err + c9_own;
    const stewart_real c9_max = STEWART_FABS(c9) + c9_err;
    const stewart_real H_force_x = s_x;
    const stewart_real H_force_x_err = s_x_err;
    const stewart_real H_force_x_max = STEWART_FABS(H_force_x) + H_force_x_err;
    const stewart_real H_force_y = s_y;
    const stewart_real H_force_y_err = s_y_err;
    const stewart_real H_force_y_max = STEWART_FABS(H_force_y) + H_force_y_err;
    const stewart_real H_force_z = s_z;
    const stewart_real H_force_z_err = s_z_err;
    const stewart_real H_force_z_max = STEWART_FABS(H_force_z) + H_force_z_err;
    const stewart_real c_force_x = -K_x;
    const stewart_real c_force_x_err = K_x_err;
    const stewart_real c_force_x_max = STEWART_FABS(c_force_x) + c_force_x_err;
    const stewart_real c_force_y = -K_y;
    const stewart_real c_force_y_err = K_y_err;
    const stewart_real c_force_y_max = STEWART_FABS(c_force_y) + c_force_y_err;
    const stewart_real c_force_z = -K_z;
    const stewart_real c_force_z_err = K_z_err;
    const stewart_real c_force_z_max = STEWART_FABS(c_force_z) + c_force_z_err;
    /* platform point from platform point 1 */
    const stewart_real arm_x = q_x - q_1_x;
    const stewart_real arm_x_own = STEWART_UNIT*STEWART_FABS(arm_x);
    const stewart_real arm_x_err = q_1_x_err + q_x_err + arm_x_own;
    const stewart_real arm_x_max = STEWART_FABS(arm_x) + arm_x_err;
    const stewart_real arm_y = q_y - q_1_y;
    const stewart_real arm_y_own = STEWART_UNIT*STEWART_FABS(arm_y);
    const stewart_real arm_y_err = q_1_y_err + q_y_err + arm_y_own;
    const stewart_real arm_y_max = STEWART_FABS(arm_y) + arm_y_err;
    const stewart_real arm_z = q_z - q_1_z;
    const stewart_real arm_z_own = STEWART_UNIT*STEWART_FABS(arm_z);
    const stewart_real arm_z_err = q_1_z_err + q_z_err + arm_z_own;
    const stewart_real arm_z_max = STEWART_FABS(arm_z) + arm_z_err;
    /* part of c, moment rows, base frame */
    const stewart_real c_moment_x = c8*k_x + c9*y_x;
    const stewart_real c_moment_x_own = STEWART_UNIT*(c8_max*k_x_max + c9_max*y_x_max + STEWART_FABS(c_moment_x));
    const stewart_real c_moment_x_err = c8_err*k_x_max + c8_max*k_x_err + c9_err*y_x_max + c9_max*y_x_err + c_moment_x_own;
    const stewart_real c_moment_y = c8*k_y + c9*y_y;
    const stewart_real c_moment_y_own = STEWART_UNIT*(c8_max*k_y_max + c9_max*y_y_max + STEWART_FABS(c_moment_y));
    const stewart_real c_moment_y_err = c8_err*k_y_max + c8_max*k_y_err + c9_err*y_y_max + c9_max*y_y_err + c_moment_y_own;
    const stewart_real c_moment_z = c8*k_z + c9*y_z;
    const stewart_real c_moment_z_own = STEWART_UNIT*(c8_max*k_z_max + c9_max*y_z_max + STEWART_FABS(c_moment_z));
    const stewart_real c_moment_z_err = c8_err*k_z_max + c8_max*k_z_err + c9_err*y_z_max + c9_max*y_z_err + c_moment_z_own;
    /* the leg's column of H, moment rows */
    const stewart_real H_moment_x = H_force_z*arm_y - H_force_y*arm_z;
    const stewart_real H_moment_x_own = STEWART_UNIT*(H_force_y_max*arm_z_max + H_force_z_max*arm_y_max + STEWART_FABS(H_moment_x));
    const stewart_real H_moment_x_err = H_force_y_err*arm_z_max + H_force_y_max*arm_z_err + H_force_z_err*arm_y_max
        + H_force_z_max*arm_y_err + H_moment_x_own;
    const stewart_real H_moment_y = H_force_x*arm_z - H_force_z*arm_x;
    const stewart_real H_moment_y_own = STEWART_UNIT*(H_force_x_max*arm_z_max + H_force_z_max*arm_x_max + STEWART_FABS(H_moment_y));
    const stewart_real H_moment_y_err = H_force_x_err*arm_z_max + H_force_x_max*arm_z_err + H_force_z_err*arm_x_max
        + H_force_z_max*arm_x_err + H_moment_y_own;
    const stewart_real H_moment_z = H_force_y*arm_x - H_force_x*arm_y;
    const stewart_real H_moment_z_own = STEWART_UNIT*(H_force_x_max*arm_y_max + H_force_y_max*arm_x_max + STEWART_FABS(H_moment_z));
    const stewart_real H_moment_z_err = H_force_x_err*arm_y_max + H_force_x_max*arm_y_err + H_force_y_err*arm_x_max
        + H_force_y_max*arm_x_err + H_moment_z_own;
    /* moment of the leg's part of c, force rows, about platform point 1 */
    const stewart_real arm_c_x = arm_y*c_force_z - arm_z*c_force_y;
    const stewart_real arm_c_x_own = STEWART_UNIT*(arm_y_max*c_force_z_max + arm_z_max*c_force_y_max + STEWART_FABS(arm_c_x));
    const stewart_real arm_c_x_err = arm_y_err*c_force_z_max + arm_y_max*c_force_z_err + arm_z_err*c_force_y_max
        + arm_z_max*c_force_y_err + arm_c_x_own;
    const stewart_real arm_c_y = arm_z*c_force_x - arm_x*c_force_z;
    const stewart_real arm_c_y_own = STEWART_UNIT*(arm_x_max*c_force_z_max + arm_z_max*c_force_x_max + STEWART_FABS(arm_c_y));
    const stewart_real arm_c_y_err = arm_x_err*c_force_z_max + arm_x_max*c_force_z_err + arm_z_err*c_force_x_max
        + arm_z_max*c_force_x_err + arm_c_y_own;
    const stewart_real arm_c_z = arm_x*c_force_y - arm_y*c_force_x;
    const stewart_real arm_c_z_own = STEWART_UNIT*(arm_x_max*c_force_y_max + arm_y_max*c_force_x_max + STEWART_FABS(arm_c_z));
    const stewart_real arm_c_z_err = arm_x_err*c_force_y_max + arm_x_max*c_force_y_err + arm_y_err*c_force_x_max
        + arm_y_max*c_force_x_err + arm_c_z_own;
    out->H_force[0] = H_force_x;
    out->H_force_err[0] = H_force_x_err;
    out->H_force[1] = H_force_y;
    out->H_force_err[1] = H_force_y_err;
    out->H_force[2] = H_force_z;
    out->H_force_err[2] = H_force_z_err;
    out->c_force[0] = c_force_x;
    out->c_force_err[0] = c_force_x_err;
    out->c_force[1] = c_force_y;
    out->c_force_err[1] = c_force_y_err;
    out->c_force[2] = c_force_z;
    out->c_force_err[2] = c_force_z_err;
    out->c_moment[0] = c_moment_x;
    out->c_moment_err[0] = c_moment_x_err;
    out->c_moment[1] = c_moment_y;
    out->c_moment_err[1] = c_moment_y_err;
    out->c_moment[2] = c_moment_z;
    out->c_moment_err[2] = c_moment_z_err;
    out->H_moment[0] = H_moment_x;
    out->H_moment_err[0] = H_moment_x_err;
    out->H_moment[1] = H_moment_y;
    out->H_moment_err[1] = H_moment_y_err;
    out->H_moment[2] = H_moment_z;
    out->H_moment_err[2] = H_moment_z_err;
    out->arm_c[0] = arm_c_x;
    out->arm_c_err[0] = arm_c_x_err;
    out->arm_c[1] = arm_c_y;
    out->arm_c_err[1] = arm_c_y_err;
    out->arm_c[2] = arm_c_z;
    out->arm_c_err[2] = arm_c_z_err;
    for (i = 0; i < LANES; ++i) {
        const stewart_real Y_force_x = rows->Y_force[0][i], Y_force_y = rows->Y_force[1][i], Y_force_z = rows->Y_force[2][i];
        const stewart_real Y_moment_x = rows->Y_moment[0][i], Y_moment_y = rows->Y_moment[1][i], Y_moment_z = rows->Y_moment[2][i];
        const stewart_real Y_arm_x = rows->Y_arm[0][i], Y_arm_y = rows->Y_arm[1][i], Y_arm_z = rows->Y_arm[2][i];
        const stewart_real D_weight = rows->D_weight[i];
        const stewart_real x = rows->x[i];
        const stewart_real Y_force_x_max = STEWART_FABS(Y_force_x);
        const stewart_real Y_force_y_max = STEWART_FABS(Y_force_y);
        const stewart_real Y_force_z_max = STEWART_FABS(Y_force_z);
        const stewart_real Y_moment_x_max = STEWART_FABS(Y_moment_x);
        const stewart_real Y_moment_y_max = STEWART_FABS(Y_moment_y);
        const stewart_real Y_moment_z_max = STEWART_FABS(Y_moment_z);
        const stewart_real Y_arm_x_max = STEWART_FABS(Y_arm_x);
        const stewart_real Y_arm_y_max = STEWART_FABS(Y_arm_y);
        const stewart_real Y_arm_z_max = STEWART_FABS(Y_arm_z);
        const stewart_real D_weight_max = STEWART_FABS(D_weight);
        const stewart_real H_force_x_weight = Y_force_x*x;
        const stewart_real H_force_x_weight_err = STEWART_UNIT*STEWART_FABS(H_force_x_weight);
        const stewart_real H_force_x_weight_max = STEWART_FABS(H_force_x_weight) + H_force_x_weight_err;
        const stewart_real H_force_y_weight = Y_force_y*x;
        const stewart_real H_force_y_weight_err = STEWART_UNIT*STEWART_FABS(H_force_y_weight);
        const stewart_real H_force_y_weight_max = STEWART_FABS(H_force_y_weight) + H_force_y_weight_err;
        const stewart_real H_force_z_weight = Y_force_z*x;
        const stewart_real H_force_z_weight_err = STEWART_UNIT*STEWART_FABS(H_force_z_weight);
        const stewart_real H_force_z_weight_max = STEWART_FABS(H_force_z_weight) + H_force_z_weight_err;
        const stewart_real H_moment_x_weight = Y_arm_x*x;
        const stewart_real H_moment_x_weight_err = STEWART_UNIT*STEWART_FABS(H_moment_x_weight);
        const stewart_real H_moment_x_weight_max = STEWART_FABS(H_moment_x_weight) + H_moment_x_weight_err;
        const stewart_real H_moment_y_weight = Y_arm_y*x;
        const stewart_real H_moment_y_weight_err = STEWART_UNIT*STEWART_FABS(H_moment_y_weight);
        const stewart_real H_moment_y_weight_max = STEWART_FABS(H_moment_y_weight) + H_moment_y_weight_err;
        const stewart_real H_moment_z_weight = Y_arm_z*x;
        const stewart_real H_moment_z_weight_err = STEWART_UNIT*STEWART_FABS(H_moment_z_weight);
        const stewart_real H_moment_z_weight_max = STEWART_FABS(H_moment_z_weight) + H_moment_z_weight_err;
        const stewart_real arm_z_bar = Y_arm_x*c_force_y + H_force_x*H_moment_y_weight - Y_arm_y*c_force_x - H_force_y*H_moment_x_weight;
        const stewart_real arm_z_bar_err = H_force_x_err*H_moment_y_weight_max + H_force_x_max*H_moment_y_weight_err
            + H_force_y_err*H_moment_x_weight_max + H_force_y_max*H_moment_x_weight_err + Y_arm_x_max*c_force_y_err
            + Y_arm_y_max*c_force_x_err + STEWART_UNIT*(H_force_y_max*H_moment_x_weight_max + REAL(3)*H_force_x_max*H_moment_y_weight_max
            + REAL(3)*Y_arm_x_max*c_force_y_max + REAL(2)*Y_arm_y_max*c_force_x_max + STEWART_FABS(arm_z_bar));
        const stewart_real arm_z_bar_max = STEWART_FABS(arm_z_bar) + arm_z_bar_err;
        const stewart_real arm_y_bar = Y_arm_z*c_force_x + H_force_z*H_moment_x_weight - Y_arm_x*c_force_z - H_force_x*H_moment_z_weight;
        const stewart_real arm_y_bar_err = H_force_x_err*H_moment_z_weight_max + H_force_x_max*H_moment_z_weight_err
            + H_force_z_err*H_moment_x_weight_max + H_force_z_max*H_moment_x_weight_err + Y_arm_x_max*c_force_z_err
            + Y_arm_z_max*c_force_x_err + STEWART_UNIT*(H_force_x_max*H_moment_z_weight_max + REAL(3)*H_force_z_max*H_moment_x_weight_max
            + REAL(2)*Y_arm_x_max*c_force_z_max + REAL(3)*Y_arm_z_max*c_force_x_max + STEWART_FABS(arm_y_bar));
        const stewart_real arm_y_bar_max = STEWART_FABS(arm_y_bar) + arm_y_bar_err;
        const stewart_real arm_x_bar = Y_arm_y*c_force_z + H_force_y*H_moment_z_weight - Y_arm_z*c_force_y - H_force_z*H_moment_y_weight;
        const stewart_real arm_x_bar_err = H_force_y_err*H_moment_z_weight_max + H_force_y_max*H_moment_z_weight_err
            + H_force_z_err*H_moment_y_weight_max + H_force_z_max*H_moment_y_weight_err + Y_arm_y_max*c_force_z_err
            + Y_arm_z_max*c_force_y_err + STEWART_UNIT*(H_force_z_max*H_moment_y_weight_max + REAL(3)*H_force_y_max*H_moment_z_weight_max
            + REAL(3)*Y_arm_y_max*c_force_z_max + REAL(2)*Y_arm_z_max*c_force_y_max + STEWART_FABS(arm_x_bar));
        const stewart_real arm_x_bar_max = STEWART_FABS(arm_x_bar) + arm_x_bar_err;
        const stewart_real c_force_z_bar = Y_arm_y*arm_x - Y_force_z - Y_arm_x*arm_y;
        const stewart_real c_force_z_bar_err = Y_arm_x_max*arm_y_err + Y_arm_y_max*arm_x_err + STEWART_UNIT*(Y_force_z_max
            + Y_arm_x_max*arm_y_max + REAL(2)*Y_arm_y_max*arm_x_max + STEWART_FABS(c_force_z_bar));
        const stewart_real c_force_z_bar_max = STEWART_FABS(c_force_z_bar) + c_force_z_bar_err;
        const stewart_real c_force_y_bar = Y_arm_x*arm_z - Y_force_y - Y_arm_z*arm_x;
        const stewart_real c_force_y_bar_err = Y_arm_x_max*arm_z_err + Y_arm_z_max*arm_x_err + STEWART_UNIT*(Y_force_y_max
            + Y_arm_z_max*arm_x_max + REAL(2)*Y_arm_x_max*arm_z_max + STEWART_FABS(c_force_y_bar));
        const stewart_real c_force_y_bar_max = STEWART_FABS(c_force_y_bar) + c_force_y_bar_err;
        const stewart_real c_force_x_bar = Y_arm_z*arm_y - Y_force_x - Y_arm_y*arm_z;
        const stewart_real c_force_x_bar_err = Y_arm_y_max*arm_z_err + Y_arm_z_max*arm_y_err + STEWART_UNIT*(Y_force_x_max
            + Y_arm_y_max*arm_z_max + REAL(2)*Y_arm_z_max*arm_y_max + STEWART_FABS(c_force_x_bar));
        const stewart_real c_force_x_bar_max = STEWART_FABS(c_force_x_bar) + c_force_x_bar_err;
        const stewart_real H_force_z_bar = H_force_z_weight + H_moment_x_weight*arm_y - H_moment_y_weight*arm_x;
        const stewart_real H_force_z_bar_err = H_force_z_weight_err + H_moment_x_weight_err*arm_y_max + H_moment_x_weight_max*arm_y_err
            + H_moment_y_weight_err*arm_x_max + H_moment_y_weight_max*arm_x_err + STEWART_UNIT*(H_force_z_weight_max
            + H_moment_y_weight_max*arm_x_max + REAL(2)*H_moment_x_weight_max*arm_y_max + STEWART_FABS(H_force_z_bar));
        const stewart_real H_force_z_bar_max = STEWART_FABS(H_force_z_bar) + H_force_z_bar_err;
        const stewart_real H_force_y_bar = H_force_y_weight + H_moment_z_weight*arm_x - H_moment_x_weight*arm_z;
        const stewart_real H_force_y_bar_err = H_force_y_weight_err + H_moment_x_weight_err*arm_z_max + H_moment_x_weight_max*arm_z_err
            + H_moment_z_weight_err*arm_x_max + H_moment_z_weight_max*arm_x_err + STEWART_UNIT*(H_force_y_weight_max
            + H_moment_x_weight_max*arm_z_max + REAL(2)*H_moment_z_weight_max*arm_x_max + STEWART_FABS(H_force_y_bar));
        const stewart_real H_force_y_bar_max = STEWART_FABS(H_force_y_bar) + H_force_y_bar_err;
        const stewart_real H_force_x_bar = H_force_x_weight + H_moment_y_weight*arm_z - H_moment_z_weight*arm_y;
        const stewart_real H_force_x_bar_err = H_force_x_weight_err + H_moment_y_weight_err*arm_z_max + H_moment_y_weight_max*arm_z_err
            + H_moment_z_weight_err*arm_y_max + H_moment_z_weight_max*arm_y_err + STEWART_UNIT*(H_force_x_weight_max
            + H_moment_z_weight_max*arm_y_max + REAL(2)*H_moment_y_weight_max*arm_z_max + STEWART_FABS(H_force_x_bar));
        const stewart_real H_force_x_bar_max = STEWART_FABS(H_force_x_bar) + H_force_x_bar_err;
        const stewart_real c9_bar = -Y_moment_x*y_x - Y_moment_y*y_y - Y_moment_z*y_z;
        const stewart_real c9_bar_err = Y_moment_x_max*y_x_err + Y_moment_y_max*y_y_err + Y_moment_z_max*y_z_err
            + STEWART_UNIT*(Y_moment_z_max*y_z_max + REAL(2)*Y_moment_x_max*y_x_max + REAL(2)*Y_moment_y_max*y_y_max
            + STEWART_FABS(c9_bar));
        const stewart_real c9_bar_max = STEWART_FABS(c9_bar) + c9_bar_err;
        const stewart_real c8_bar = -Y_moment_x*k_x - Y_moment_y*k_y - Y_moment_z*k_z;
        const stewart_real c8_bar_err = Y_moment_x_max*k_x_err + Y_moment_y_max*k_y_err + Y_moment_z_max*k_z_err
            + STEWART_UNIT*(Y_moment_z_max*k_z_max + REAL(2)*Y_moment_x_max*k_x_max + REAL(2)*Y_moment_y_max*k_y_max
            + STEWART_FABS(c8_bar));
        const stewart_real c8_bar_max = STEWART_FABS(c8_bar) + c8_bar_err;
        const stewart_real Q_z_bar = -c_force_x_bar*z_x - c_force_y_bar*z_y - c_force_z_bar*z_z;
        const stewart_real Q_z_bar_err = c_force_x_bar_err*z_x_max + c_force_x_bar_max*z_x_err + c_force_y_bar_err*z_y_max
            + c_force_y_bar_max*z_y_err + c_force_z_bar_err*z_z_max + c_force_z_bar_max*z_z_err + STEWART_UNIT*(c_force_z_bar_max*z_z_max
            + REAL(2)*c_force_x_bar_max*z_x_max + REAL(2)*c_force_y_bar_max*z_y_max + STEWART_FABS(Q_z_bar));
        const stewart_real Q_z_bar_max = STEWART_FABS(Q_z_bar) + Q_z_bar_err;
        const stewart_real Q_y_bar = -c_force_x_bar*y_x - c_force_y_bar*y_y - c_force_z_bar*y_z;
        const stewart_real Q_y_bar_err = c_force_x_bar_err*y_x_max + c_force_x_bar_max*y_x_err + c_force_y_bar_err*y_y_max
            + c_force_y_bar_max*y_y_err + c_force_z_bar_err*y_z_max + c_force_z_bar_max*y_z_err + STEWART_UNIT*(c_force_z_bar_max*y_z_max
            + REAL(2)*c_force_x_bar_max*y_x_max + REAL(2)*c_force_y_bar_max*y_y_max + STEWART_FABS(Q_y_bar));
        const stewart_real Q_y_bar_max = STEWART_FABS(Q_y_bar) + Q_y_bar_err;
        const stewart_real tau_k_bar = Q_y_bar*inv_rho;
        const stewart_real tau_k_bar_err = Q_y_bar_err*inv_rho_max + Q_y_bar_max*inv_rho_err + STEWART_UNIT*STEWART_FABS(tau_k_bar);
        const stewart_real tau_k_bar_max = STEWART_FABS(tau_k_bar) + tau_k_bar_err;
        const stewart_real tau_y_bar = -Q_z_bar*inv_L;
        const stewart_real tau_y_bar_err = Q_z_bar_err*inv_L_max + Q_z_bar_max*inv_L_err + STEWART_UNIT*STEWART_FABS(tau_y_bar);
        const stewart_real tau_y_bar_max = STEWART_FABS(tau_y_bar) + tau_y_bar_err;
        const stewart_real c7_bar = D_weight*phi_ddot + L_ddot*tau_k_bar;
        const stewart_real c7_bar_err = D_weight_max*phi_ddot_err + L_ddot_err*tau_k_bar_max + L_ddot_max*tau_k_bar_err
            + STEWART_UNIT*(D_weight_max*phi_ddot_max + L_ddot_max*tau_k_bar_max + STEWART_FABS(c7_bar));
        const stewart_real c7_bar_max = STEWART_FABS(c7_bar) + c7_bar_err;
        const stewart_real c6_bar = L_dot*tau_y_bar - D_weight*theta_dot;
        const stewart_real c6_bar_err = D_weight_max*theta_dot_err + L_dot_err*tau_y_bar_max + L_dot_max*tau_y_bar_err
            + STEWART_UNIT*(D_weight_max*theta_dot_max + L_dot_max*tau_y_bar_max + STEWART_FABS(c6_bar));
        const stewart_real c6_bar_max = STEWART_FABS(c6_bar) + c6_bar_err;
        const stewart_real c5_bar = c6_bar*phi_dot - c4*tau_k_bar;
        const stewart_real c5_bar_err = c4_err*tau_k_bar_max + c4_max*tau_k_bar_err + c6_bar_err*phi_dot_max
            + c6_bar_max*phi_dot_err + STEWART_UNIT*(c4_max*tau_k_bar_max + c6_bar_max*phi_dot_max + STEWART_FABS(c5_bar));
        const stewart_real c5_bar_max = STEWART_FABS(c5_bar) + c5_bar_err;
        const stewart_real w_n_bar = g_k*tau_y_bar - gamma_y*tau_k_bar;
        const stewart_real w_n_bar_err = g_k_err*tau_y_bar_max + g_k_max*tau_y_bar_err + gamma_y_err*tau_k_bar_max
            + gamma_y_max*tau_k_bar_err + STEWART_UNIT*(g_k_max*tau_y_bar_max + gamma_y_max*tau_k_bar_max + STEWART_FABS(w_n_bar));
        const stewart_real w_n_bar_max = STEWART_FABS(w_n_bar) + w_n_bar_err;
        const stewart_real w_k_bar = gamma_n*tau_y_bar;
        const stewart_real w_k_bar_err = gamma_n_err*tau_y_bar_max + gamma_n_max*tau_y_bar_err + STEWART_UNIT*STEWART_FABS(w_k_bar);
        const stewart_real w_k_bar_max = STEWART_FABS(w_k_bar) + w_k_bar_err;
        const stewart_real gamma_y_bar = -tau_k_bar*w_n;
        const stewart_real gamma_y_bar_err = tau_k_bar_err*w_n_max + tau_k_bar_max*w_n_err + STEWART_UNIT*STEWART_FABS(gamma_y_bar);
        const stewart_real gamma_y_bar_max = STEWART_FABS(gamma_y_bar) + gamma_y_bar_err;
        const stewart_real gamma_n_bar = tau_y_bar*w_k - tau_k_bar*w_y;
        const stewart_real gamma_n_bar_err = tau_k_bar_err*w_y_max + tau_k_bar_max*w_y_err + tau_y_bar_err*w_k_max
            + tau_y_bar_max*w_k_err + STEWART_UNIT*(tau_k_bar_max*w_y_max + tau_y_bar_max*w_k_max + STEWART_FABS(gamma_n_bar));
        const stewart_real gamma_n_bar_max = STEWART_FABS(gamma_n_bar) + gamma_n_bar_err;
        const stewart_real c10 = h2_y*tau_k_bar;
        const stewart_real c10_err = h2_y_err*tau_k_bar_max + h2_y_max*tau_k_bar_err + STEWART_UNIT*STEWART_FABS(c10);
        const stewart_real c10_max = STEWART_FABS(c10) + c10_err;
        const stewart_real bend_bar = h2_x*tau_y_bar - c10*k1;
        const stewart_real bend_bar_err = c10_err*k1_max + c10_max*k1_err + h2_x_err*tau_y_bar_max + h2_x_max*tau_y_bar_err
            + STEWART_UNIT*(c10_max*k1_max + h2_x_max*tau_y_bar_max + STEWART_FABS(bend_bar));
        const stewart_real c4_bar = bend_bar - c5*tau_k_bar;
        const stewart_real c4_bar_err = bend_bar_err + c5_err*tau_k_bar_max + c5_max*tau_k_bar_err + STEWART_UNIT*(c5_max*tau_k_bar_max
            + STEWART_FABS(c4_bar));
        const stewart_real c4_bar_max = STEWART_FABS(c4_bar) + c4_bar_err;
        const stewart_real M_mixed_theta_bar = tau_k_bar*theta_dot2;
        const stewart_real M_mixed_theta_bar_err = tau_k_bar_err*theta_dot2_max + tau_k_bar_max*theta_dot2_err
            + STEWART_UNIT*STEWART_FABS(M_mixed_theta_bar);
        const stewart_real M_mixed_theta_bar_max = STEWART_FABS(M_mixed_theta_bar) + M_mixed_theta_bar_err;
        const stewart_real M_phi_L_bar = L_dot*tau_k_bar*two_phi_dot - D_weight*phi_dot2;
        const stewart_real M_phi_L_bar_err = D_weight_max*phi_dot2_err + L_dot_err*tau_k_bar_max*two_phi_dot_max
            + L_dot_max*tau_k_bar_err*two_phi_dot_max + L_dot_max*tau_k_bar_max*two_phi_dot_err + STEWART_UNIT*(D_weight_max*phi_dot2_max
            + REAL(2)*L_dot_max*tau_k_bar_max*two_phi_dot_max + STEWART_FABS(M_phi_L_bar));
        const stewart_real M_phi_L_bar_max = STEWART_FABS(M_phi_L_bar) + M_phi_L_bar_err;
        const stewart_real M_mixed_bar = tau_k_bar*theta_ddot + phi_ddot*tau_y_bar;
        const stewart_real M_mixed_bar_err = phi_ddot_err*tau_y_bar_max + phi_ddot_max*tau_y_bar_err + tau_k_bar_err*theta_ddot_max
            + tau_k_bar_max*theta_ddot_err + STEWART_UNIT*(phi_ddot_max*tau_y_bar_max + tau_k_bar_max*theta_ddot_max
            + STEWART_FABS(M_mixed_bar));
        const stewart_real M_mixed_bar_max = STEWART_FABS(M_mixed_bar) + M_mixed_bar_err;
        const stewart_real M_theta_bar = own_theta_ddot*tau_y_bar;
        const stewart_real M_theta_bar_err = own_theta_ddot_err*tau_y_bar_max + own_theta_ddot_max*tau_y_bar_err
            + STEWART_UNIT*STEWART_FABS(M_theta_bar);
        const stewart_real M_theta_bar_max = STEWART_FABS(M_theta_bar) + M_theta_bar_err;
        const stewart_real M_phi_bar = own_phi_ddot*tau_k_bar;
        const stewart_real M_phi_bar_err = own_phi_ddot_err*tau_k_bar_max + own_phi_ddot_max*tau_k_bar_err + STEWART_UNIT*STEWART_FABS(M_phi_bar);
        const stewart_real M_phi_bar_max = STEWART_FABS(M_phi_bar) + M_phi_bar_err;
        const stewart_real a3_bar = M_mixed_bar*k1 - M_mixed_theta_bar*k3;
        const stewart_real a3_bar_err = M_mixed_bar_err*k1_max + M_mixed_bar_max*k1_err + M_mixed_theta_bar_err*k3_max
            + M_mixed_theta_bar_max*k3_err + STEWART_UNIT*(M_mixed_bar_max*k1_max + M_mixed_theta_bar_max*k3_max
            + STEWART_FABS(a3_bar));
        const stewart_real a3_bar_max = STEWART_FABS(a3_bar) + a3_bar_err;
        const stewart_real a2_bar = M_phi_bar*k13;
        const stewart_real a2_bar_err = M_phi_bar_err*k13_max + M_phi_bar_max*k13_err + STEWART_UNIT*STEWART_FABS(a2_bar);
        const stewart_real c11 = k33 - STEWART_HALF;
        const stewart_real c11_err = k33_err + STEWART_UNIT*STEWART_FABS(c11);
        const stewart_real c11_max = STEWART_FABS(c11) + c11_err;
        const stewart_real c12 = phi_dot2*tau_y_bar;
        const stewart_real c12_err = phi_dot2_err*tau_y_bar_max + phi_dot2_max*tau_y_bar_err + STEWART_UNIT*STEWART_FABS(c12);
        const stewart_real c12_max = STEWART_FABS(c12) + c12_err;
        const stewart_real c3_bar = a2_bar + c11*c12;
        const stewart_real c3_bar_err = a2_bar_err + c11_err*c12_max + c11_max*c12_err + STEWART_UNIT*(c11_max*c12_max
            + STEWART_FABS(c3_bar));
        const stewart_real c3_bar_max = STEWART_FABS(c3_bar) + c3_bar_err;
        const stewart_real c13 = c3_bar - STEWART_HALF*tau_k_bar*theta_dot*two_phi_dot;
        const stewart_real c13_err = c3_bar_err + STEWART_HALF*tau_k_bar_err*theta_dot_max*two_phi_dot_max + STEWART_HALF*tau_k_bar_max*theta_dot_err*two_phi_dot_max
            + STEWART_HALF*tau_k_bar_max*theta_dot_max*two_phi_dot_err + STEWART_UNIT*(tau_k_bar_max*theta_dot_max*two_phi_dot_max
            + STEWART_FABS(c13));
        const stewart_real c2_bar = -c13;
        const stewart_real c2_bar_err = c13_err;
        const stewart_real c2_bar_max = STEWART_FABS(c2_bar) + c2_bar_err;
        const stewart_real a1_bar = M_phi_bar*k33;
        const stewart_real a1_bar_err = M_phi_bar_err*k33_max + M_phi_bar_max*k33_err + STEWART_UNIT*STEWART_FABS(a1_bar);
        const stewart_real a1_bar_max = STEWART_FABS(a1_bar) + a1_bar_err;
        const stewart_real L_h2_bar = M_theta_bar + a1_bar;
        const stewart_real L_h2_bar_err = M_theta_bar_err + a1_bar_err + STEWART_UNIT*STEWART_FABS(L_h2_bar);
        const stewart_real L_h2_bar_max = STEWART_FABS(L_h2_bar) + L_h2_bar_err;
        const stewart_real c14 = J_yy - dJ_zx;
        const stewart_real c14_err = J_yy_err + dJ_zx_err + STEWART_UNIT*STEWART_FABS(c14);
        const stewart_real c14_max = STEWART_FABS(c14) + c14_err;
        const stewart_real k13_bar = M_phi_bar*a2 + c12*c14 - M_phi_L_bar*h_z;
        const stewart_real k13_bar_err = M_phi_L_bar_err*h_z_max + M_phi_L_bar_max*h_z_err + M_phi_bar_err*a2_max
            + M_phi_bar_max*a2_err + c12_err*c14_max + c12_max*c14_err + STEWART_UNIT*(M_phi_L_bar_max*h_z_max
            + REAL(2)*M_phi_bar_max*a2_max + REAL(2)*c12_max*c14_max + STEWART_FABS(k13_bar));
        const stewart_real phi_ddot_bar = D_weight*c7 + M_mixed*tau_y_bar;
        const stewart_real phi_ddot_bar_err = D_weight_max*c7_err + M_mixed_err*tau_y_bar_max + M_mixed_max*tau_y_bar_err
            + STEWART_UNIT*(D_weight_max*c7_max + M_mixed_max*tau_y_bar_max + STEWART_FABS(phi_ddot_bar));
        const stewart_real phi_ddot_bar_max = STEWART_FABS(phi_ddot_bar) + phi_ddot_bar_err;
        const stewart_real theta_ddot_bar = D_weight*h_z + M_mixed*tau_k_bar;
        const stewart_real theta_ddot_bar_err = D_weight_max*h_z_err + M_mixed_err*tau_k_bar_max + M_mixed_max*tau_k_bar_err
            + STEWART_UNIT*(D_weight_max*h_z_max + M_mixed_max*tau_k_bar_max + STEWART_FABS(theta_ddot_bar));
        const stewart_real theta_ddot_bar_max = STEWART_FABS(theta_ddot_bar) + theta_ddot_bar_err;
        const stewart_real c1_bar = phi_dot2*theta_ddot_bar + k13_bar;
        const stewart_real c1_bar_err = k13_bar_err + phi_dot2_err*theta_ddot_bar_max + phi_dot2_max*theta_ddot_bar_err
            + STEWART_UNIT*(phi_dot2_max*theta_ddot_bar_max + STEWART_FABS(c1_bar));
        const stewart_real c1_bar_max = STEWART_FABS(c1_bar) + c1_bar_err;
        const stewart_real own_phi_ddot_bar = M_phi*tau_k_bar + phi_ddot_bar;
        const stewart_real own_phi_ddot_bar_err = phi_ddot_bar_err + M_phi_err*tau_k_bar_max + M_phi_max*tau_k_bar_err
            + STEWART_UNIT*(M_phi_max*tau_k_bar_max + STEWART_FABS(own_phi_ddot_bar));
        const stewart_real own_phi_ddot_bar_max = STEWART_FABS(own_phi_ddot_bar) + own_phi_ddot_bar_err;
        const stewart_real own_theta_ddot_bar = M_theta*tau_y_bar + theta_ddot_bar;
        const stewart_real own_theta_ddot_bar_err = theta_ddot_bar_err + M_theta_err*tau_y_bar_max + M_theta_max*tau_y_bar_err
            + STEWART_UNIT*(M_theta_max*tau_y_bar_max + STEWART_FABS(own_theta_ddot_bar));
        const stewart_real own_theta_ddot_bar_max = STEWART_FABS(own_theta_ddot_bar) + own_theta_ddot_bar_err;
        const stewart_real L_ddot_bar = D_weight*m_r + c7*tau_k_bar + h_z*tau_y_bar;
        const stewart_real L_ddot_bar_err = c7_err*tau_k_bar_max + c7_max*tau_k_bar_err + h_z_err*tau_y_bar_max
            + h_z_max*tau_y_bar_err + STEWART_UNIT*(h_z_max*tau_y_bar_max + REAL(2)*D_weight_max*m_r_max + REAL(2)*c7_max*tau_k_bar_max
            + STEWART_FABS(L_ddot_bar));
        const stewart_real L_ddot_bar_max = STEWART_FABS(L_ddot_bar) + L_ddot_bar_err;
        const stewart_real c15 = L*L_ddot_bar;
        const stewart_real c15_err = L_ddot_bar_err*L_max + L_ddot_bar_max*L_err + STEWART_UNIT*STEWART_FABS(c15);
        const stewart_real c15_max = STEWART_FABS(c15) + c15_err;
        const stewart_real k33_bar = M_phi_bar*a1 + c12*c3 + M_phi_L_bar*h_x + c15*phi_dot2;
        const stewart_real k33_bar_err = M_phi_L_bar_err*h_x_max + M_phi_L_bar_max*h_x_err + M_phi_bar_err*a1_max
            + M_phi_bar_max*a1_err + c12_err*c3_max + c12_max*c3_err + c15_err*phi_dot2_max + c15_max*phi_dot2_err
            + STEWART_UNIT*(c15_max*phi_dot2_max + REAL(2)*M_phi_L_bar_max*h_x_max + REAL(3)*M_phi_bar_max*a1_max
            + REAL(3)*c12_max*c3_max + STEWART_FABS(k33_bar));
        const stewart_real k33_bar_max = STEWART_FABS(k33_bar) + k33_bar_err;
        const stewart_real c16 = STEWART_HALF*J2_xz + J_xx*kappa - STEWART_HALF*c2;
        const stewart_real c16_err = STEWART_HALF*J2_xz_err + J_xx_err*kappa_max + J_xx_max*kappa_err + STEWART_HALF*c2_err
            + STEWART_UNIT*(STEWART_HALF*J2_xz_max + REAL(2)*J_xx_max*kappa_max + STEWART_FABS(c16));
        const stewart_real c16_max = STEWART_FABS(c16) + c16_err;
        const stewart_real two_phi_dot_bar = tau_k_bar*(L_dot*M_phi_L - c16*theta_dot) - lean*phi_ddot_bar - L_share*own_phi_ddot_bar;
        const stewart_real two_phi_dot_bar_err = L_share_err*own_phi_ddot_bar_max + L_share_max*own_phi_ddot_bar_err
            + lean_err*phi_ddot_bar_max + lean_max*phi_ddot_bar_err + L_dot_err*M_phi_L_max*tau_k_bar_max + L_dot_max*M_phi_L_err*tau_k_bar_max
            + c16_err*tau_k_bar_max*theta_dot_max + c16_max*tau_k_bar_max*theta_dot_err + tau_k_bar_err*(L_dot_max*M_phi_L_max
            + c16_max*theta_dot_max) + STEWART_UNIT*(L_share_max*own_phi_ddot_bar_max + REAL(2)*lean_max*phi_ddot_bar_max
            + REAL(2)*tau_k_bar_max*(L_dot_max*M_phi_L_max + c16_max*theta_dot_max) + tau_k_bar_max*(REAL(2)*(L_dot_max*M_phi_L_max
            + c16_max*theta_dot_max)) + STEWART_FABS(two_phi_dot_bar));
        const stewart_real phi_dot2_bar = tau_y_bar*(c11*c3 + c14*k13) - D_weight*M_phi_L + c1*theta_ddot_bar
            + c15*k33;
        const stewart_real phi_dot2_bar_err = D_weight_max*M_phi_L_err + c15_err*k33_max + c15_max*k33_err + c1_err*theta_ddot_bar_max
            + c1_max*theta_ddot_bar_err + c11_err*c3_max*tau_y_bar_max + c11_max*c3_err*tau_y_bar_max + c14_err*k13_max*tau_y_bar_max
            + c14_max*k13_err*tau_y_bar_max + tau_y_bar_err*(c11_max*c3_max + c14_max*k13_max) + STEWART_UNIT*(c15_max*k33_max
            + REAL(3)*D_weight_max*M_phi_L_max + REAL(2)*c1_max*theta_ddot_bar_max + REAL(3)*tau_y_bar_max*(c11_max*c3_max
            + c14_max*k13_max) + tau_y_bar_max*(REAL(2)*(c11_max*c3_max + c14_max*k13_max)) + STEWART_FABS(phi_dot2_bar));
        const stewart_real phi_dot2_bar_max = STEWART_FABS(phi_dot2_bar) + phi_dot2_bar_err;
        const stewart_real theta_dot2_bar = M_mixed_theta*tau_k_bar - D_weight*h_x + c15;
        const stewart_real theta_dot2_bar_err = c15_err + D_weight_max*h_x_err + M_mixed_theta_err*tau_k_bar_max
            + M_mixed_theta_max*tau_k_bar_err + STEWART_UNIT*(REAL(2)*(D_weight_max*h_x_max + M_mixed_theta_max*tau_k_bar_max)
            + STEWART_FABS(theta_dot2_bar));
        const stewart_real theta_dot2_bar_max = STEWART_FABS(theta_dot2_bar) + theta_dot2_bar_err;
        const stewart_real lean_bar = -phi_ddot_bar*two_phi_dot;
        const stewart_real lean_bar_err = phi_ddot_bar_err*two_phi_dot_max + phi_ddot_bar_max*two_phi_dot_err
            + STEWART_UNIT*STEWART_FABS(lean_bar);
        const stewart_real lean_bar_max = STEWART_FABS(lean_bar) + lean_bar_err;
        const stewart_real c17 = REAL(2)*own_theta_ddot_bar;
        const stewart_real c17_err = REAL(2)*own_theta_ddot_bar_err;
        const stewart_real c17_max = STEWART_FABS(c17) + c17_err;
        const stewart_real L_share_bar = -own_phi_ddot_bar*two_phi_dot - c17*theta_dot;
        const stewart_real L_share_bar_err = c17_err*theta_dot_max + c17_max*theta_dot_err + own_phi_ddot_bar_err*two_phi_dot_max
            + own_phi_ddot_bar_max*two_phi_dot_err + STEWART_UNIT*(c17_max*theta_dot_max + own_phi_ddot_bar_max*two_phi_dot_max
            + STEWART_FABS(L_share_bar));
        const stewart_real L_share_bar_max = STEWART_FABS(L_share_bar) + L_share_bar_err;
        const stewart_real c18 = tau_k_bar*two_phi_dot;
        const stewart_real c18_err = tau_k_bar_err*two_phi_dot_max + tau_k_bar_max*two_phi_dot_err + STEWART_UNIT*STEWART_FABS(c18);
        const stewart_real c18_max = STEWART_FABS(c18) + c18_err;
        const stewart_real theta_dot_bar = C_s*c9_bar - D_weight*c6 + C_us*tau_y_bar - c16*c18 + L_dot*c4_bar
            + kappa*lean_bar + REAL(2)*theta_dot*theta_dot2_bar - L_share*c17;
        const stewart_real theta_dot_bar_err = C_s_max*c9_bar_err + C_us_err*tau_y_bar_max + C_us_max*tau_y_bar_err
            + D_weight_max*c6_err + L_dot_err*c4_bar_max + L_dot_max*c4_bar_err + L_share_err*c17_max + L_share_max*c17_err
            + c16_err*c18_max + c16_max*c18_err + kappa_err*lean_bar_max + kappa_max*lean_bar_err + REAL(2)*theta_dot2_bar_err*theta_dot_max
            + REAL(2)*theta_dot2_bar_max*theta_dot_err + STEWART_UNIT*(L_share_max*c17_max + REAL(7)*C_s_max*c9_bar_max
            + REAL(6)*C_us_max*tau_y_bar_max + REAL(7)*D_weight_max*c6_max + REAL(4)*L_dot_max*c4_bar_max + REAL(5)*c16_max*c18_max
            + REAL(3)*kappa_max*lean_bar_max + REAL(4)*theta_dot2_bar_max*theta_dot_max + STEWART_FABS(theta_dot_bar));
        const stewart_real theta_dot_bar_max = STEWART_FABS(theta_dot_bar) + theta_dot_bar_err;
        const stewart_real phi_dot_bar = C_s*c8_bar + C_us*tau_k_bar + c5*c6_bar + REAL(2)*phi_dot*phi_dot2_bar
            + REAL(2)*two_phi_dot_bar;
        const stewart_real phi_dot_bar_err = C_s_max*c8_bar_err + C_us_err*tau_k_bar_max + C_us_max*tau_k_bar_err
            + c5_err*c6_bar_max + c5_max*c6_bar_err + REAL(2)*two_phi_dot_bar_err + REAL(2)*phi_dot2_bar_err*phi_dot_max
            + REAL(2)*phi_dot2_bar_max*phi_dot_err + STEWART_UNIT*(REAL(4)*C_s_max*c8_bar_max + REAL(4)*C_us_max*tau_k_bar_max
            + REAL(3)*c5_max*c6_bar_max + REAL(4)*phi_dot2_bar_max*phi_dot_max + STEWART_FABS(phi_dot_bar));
        const stewart_real phi_dot_bar_max = STEWART_FABS(phi_dot_bar) + phi_dot_bar_err;
        const stewart_real L_dot_bar = C_p*D_weight + M_phi_L*c18 + c6*tau_y_bar + c4_bar*theta_dot + L_share_bar*inv_L;
        const stewart_real L_dot_bar_err = L_share_bar_err*inv_L_max + L_share_bar_max*inv_L_err + M_phi_L_err*c18_max
            + M_phi_L_max*c18_err + c4_bar_err*theta_dot_max + c4_bar_max*theta_dot_err + c6_err*tau_y_bar_max
            + c6_max*tau_y_bar_err + STEWART_UNIT*(L_share_bar_max*inv_L_max + REAL(4)*C_p_max*D_weight_max
            + REAL(4)*M_phi_L_max*c18_max + REAL(2)*c4_bar_max*theta_dot_max + REAL(3)*c6_max*tau_y_bar_max
            + STEWART_FABS(L_dot_bar));
        const stewart_real L_dot_bar_max = STEWART_FABS(L_dot_bar) + L_dot_bar_err;
        const stewart_real c19 = inv_rho*own_phi_ddot_bar;
        const stewart_real c19_err = inv_rho_err*own_phi_ddot_bar_max + inv_rho_max*own_phi_ddot_bar_err + STEWART_UNIT*STEWART_FABS(c19);
        const stewart_real c19_max = STEWART_FABS(c19) + c19_err;
        const stewart_real c20 = inv_L*own_theta_ddot_bar;
        const stewart_real c20_err = inv_L_err*own_theta_ddot_bar_max + inv_L_max*own_theta_ddot_bar_err + STEWART_UNIT*STEWART_FABS(c20);
        const stewart_real c20_max = STEWART_FABS(c20) + c20_err;
        const stewart_real S_ddot_z_bar = L_ddot_bar*s_z + c19*y_z - c20*z_z;
        const stewart_real S_ddot_z_bar_err = L_ddot_bar_err*s_z_max + L_ddot_bar_max*s_z_err + c19_err*y_z_max
            + c19_max*y_z_err + c20_err*z_z_max + c20_max*z_z_err + STEWART_UNIT*(c20_max*z_z_max + REAL(2)*L_ddot_bar_max*s_z_max
            + REAL(2)*c19_max*y_z_max + STEWART_FABS(S_ddot_z_bar));
        const stewart_real S_ddot_z_bar_max = STEWART_FABS(S_ddot_z_bar) + S_ddot_z_bar_err;
        const stewart_real S_ddot_y_bar = L_ddot_bar*s_y + c19*y_y - c20*z_y;
        const stewart_real S_ddot_y_bar_err = L_ddot_bar_err*s_y_max + L_ddot_bar_max*s_y_err + c19_err*y_y_max
            + c19_max*y_y_err + c20_err*z_y_max + c20_max*z_y_err + STEWART_UNIT*(c20_max*z_y_max + REAL(2)*L_ddot_bar_max*s_y_max
            + REAL(2)*c19_max*y_y_max + STEWART_FABS(S_ddot_y_bar));
        const stewart_real S_ddot_y_bar_max = STEWART_FABS(S_ddot_y_bar) + S_ddot_y_bar_err;
        const stewart_real S_ddot_x_bar = L_ddot_bar*s_x + c19*y_x - c20*z_x;
        const stewart_real S_ddot_x_bar_err = L_ddot_bar_err*s_x_max + L_ddot_bar_max*s_x_err + c19_err*y_x_max
            + c19_max*y_x_err + c20_err*z_x_max + c20_max*z_x_err + STEWART_UNIT*(c20_max*z_x_max + REAL(2)*L_ddot_bar_max*s_x_max
            + REAL(2)*c19_max*y_x_max + STEWART_FABS(S_ddot_x_bar));
        const stewart_real S_ddot_x_bar_max = STEWART_FABS(S_ddot_x_bar) + S_ddot_x_bar_err;
        const stewart_real c21 = inv_rho*phi_dot_bar;
        const stewart_real c21_err = inv_rho_err*phi_dot_bar_max + inv_rho_max*phi_dot_bar_err + STEWART_UNIT*STEWART_FABS(c21);
        const stewart_real c21_max = STEWART_FABS(c21) + c21_err;
        const stewart_real c22 = inv_L*theta_dot_bar;
        const stewart_real c22_err = inv_L_err*theta_dot_bar_max + inv_L_max*theta_dot_bar_err + STEWART_UNIT*STEWART_FABS(c22);
        const stewart_real c22_max = STEWART_FABS(c22) + c22_err;
        const stewart_real S_dot_z_bar = L_dot_bar*s_z + c21*y_z - c22*z_z;
        const stewart_real S_dot_z_bar_err = L_dot_bar_err*s_z_max + L_dot_bar_max*s_z_err + c21_err*y_z_max
            + c21_max*y_z_err + c22_err*z_z_max + c22_max*z_z_err + STEWART_UNIT*(c22_max*z_z_max + REAL(2)*L_dot_bar_max*s_z_max
            + REAL(2)*c21_max*y_z_max + STEWART_FABS(S_dot_z_bar));
        const stewart_real S_dot_z_bar_max = STEWART_FABS(S_dot_z_bar) + S_dot_z_bar_err;
        const stewart_real S_dot_y_bar = L_dot_bar*s_y + c21*y_y - c22*z_y;
        const stewart_real S_dot_y_bar_err = L_dot_bar_err*s_y_max + L_dot_bar_max*s_y_err + c21_err*y_y_max
            + c21_max*y_y_err + c22_err*z_y_max + c22_max*z_y_err + STEWART_UNIT*(c22_max*z_y_max + REAL(2)*L_dot_bar_max*s_y_max
            + REAL(2)*c21_max*y_y_max + STEWART_FABS(S_dot_y_bar));
        const stewart_real S_dot_y_bar_max = STEWART_FABS(S_dot_y_bar) + S_dot_y_bar_err;
        const stewart_real S_dot_x_bar = L_dot_bar*s_x + c21*y_x - c22*z_x;
        const stewart_real S_dot_x_bar_err = L_dot_bar_err*s_x_max + L_dot_bar_max*s_x_err + c21_err*y_x_max
            + c21_max*y_x_err + c22_err*z_x_max + c22_max*z_x_err + STEWART_UNIT*(c22_max*z_x_max + REAL(2)*L_dot_bar_max*s_x_max
            + REAL(2)*c21_max*y_x_max + STEWART_FABS(S_dot_x_bar));
        const stewart_real S_dot_x_bar_max = STEWART_FABS(S_dot_x_bar) + S_dot_x_bar_err;
        const stewart_real c23 = c18*theta_dot;
        const stewart_real c23_err = c18_err*theta_dot_max + c18_max*theta_dot_err + STEWART_UNIT*STEWART_FABS(c23);
        const stewart_real c23_max = STEWART_FABS(c23) + c23_err;
        const stewart_real kappa_bar = lean_bar*theta_dot - J_xx*c23;
        const stewart_real kappa_bar_err = J_xx_err*c23_max + J_xx_max*c23_err + lean_bar_err*theta_dot_max
            + lean_bar_max*theta_dot_err + STEWART_UNIT*(J_xx_max*c23_max + lean_bar_max*theta_dot_max + STEWART_FABS(kappa_bar));
        const stewart_real kappa_bar_max = STEWART_FABS(kappa_bar) + kappa_bar_err;
        const stewart_real k3_bar = w_k_bar*w_z - M_mixed_theta_bar*a3 + J_yz*M_mixed_bar - c7_bar*h_y + w_n_bar*w_x
            + c5_bar*j_r + c1_bar*k1 + REAL(2)*k3*k33_bar;
        const stewart_real k3_bar_err = J_yz_err*M_mixed_bar_max + J_yz_max*M_mixed_bar_err + M_mixed_theta_bar_err*a3_max
            + M_mixed_theta_bar_max*a3_err + c1_bar_err*k1_max + c1_bar_max*k1_err + c5_bar_err*j_r_max + c7_bar_err*h_y_max
            + c7_bar_max*h_y_err + w_k_bar_err*w_z_max + w_k_bar_max*w_z_err + w_n_bar_err*w_x_max + w_n_bar_max*w_x_err
            + REAL(2)*k33_bar_err*k3_max + REAL(2)*k33_bar_max*k3_err + STEWART_UNIT*(REAL(6)*J_yz_max*M_mixed_bar_max
            + REAL(7)*M_mixed_theta_bar_max*a3_max + REAL(2)*c1_bar_max*k1_max + REAL(3)*c5_bar_max*j_r_max
            + REAL(5)*c7_bar_max*h_y_max + REAL(2)*k33_bar_max*k3_max + REAL(7)*w_k_bar_max*w_z_max + REAL(4)*w_n_bar_max*w_x_max
            + STEWART_FABS(k3_bar));
        const stewart_real k3_bar_max = STEWART_FABS(k3_bar) + k3_bar_err;
        const stewart_real k1_bar = J_yz*M_mixed_theta_bar + c7_bar*j_r + w_k_bar*w_x - bend*c10 + M_mixed_bar*a3
            - w_n_bar*w_z + c1_bar*k3;
        const stewart_real k1_bar_err = J_yz_err*M_mixed_theta_bar_max + J_yz_max*M_mixed_theta_bar_err + M_mixed_bar_err*a3_max
            + M_mixed_bar_max*a3_err + bend_err*c10_max + bend_max*c10_err + c1_bar_err*k3_max + c1_bar_max*k3_err
            + c7_bar_err*j_r_max + w_k_bar_err*w_x_max + w_k_bar_max*w_x_err + w_n_bar_err*w_z_max + w_n_bar_max*w_z_err
            + STEWART_UNIT*(c1_bar_max*k3_max + REAL(6)*J_yz_max*M_mixed_theta_bar_max + REAL(3)*M_mixed_bar_max*a3_max
            + REAL(4)*bend_max*c10_max + REAL(6)*c7_bar_max*j_r_max + REAL(5)*w_k_bar_max*w_x_max + REAL(2)*w_n_bar_max*w_z_max
            + STEWART_FABS(k1_bar));
        const stewart_real k1_bar_max = STEWART_FABS(k1_bar) + k1_bar_err;
        const stewart_real c24 = C_s*tau_y_bar;
        const stewart_real c24_err = C_s_max*tau_y_bar_err + STEWART_UNIT*STEWART_FABS(c24);
        const stewart_real c24_max = STEWART_FABS(c24) + c24_err;
        const stewart_real y_z_bar = g_z*gamma_y_bar - Y_moment_z*c9 - Q_y*c_force_z_bar - c24*omega_z + g_x_k_z*gamma_n_bar
            + S_ddot_z*c19 + S_dot_z*c21;
        const stewart_real y_z_bar_err = Q_y_err*c_force_z_bar_max + Q_y_max*c_force_z_bar_err + S_ddot_z_err*c19_max
            + S_ddot_z_max*c19_err + S_dot_z_err*c21_max + S_dot_z_max*c21_err + Y_moment_z_max*c9_err + c24_err*omega_z_max
            + g_x_k_z_err*gamma_n_bar_max + g_x_k_z_max*gamma_n_bar_err + g_z_max*gamma_y_bar_err + STEWART_UNIT*(S_dot_z_max*c21_max
            + REAL(5)*Q_y_max*c_force_z_bar_max + REAL(2)*S_ddot_z_max*c19_max + REAL(6)*Y_moment_z_max*c9_max
            + REAL(4)*c24_max*omega_z_max + REAL(3)*g_x_k_z_max*gamma_n_bar_max + REAL(6)*g_z_max*gamma_y_bar_max
            + STEWART_FABS(y_z_bar));
        const stewart_real y_z_bar_max = STEWART_FABS(y_z_bar) + y_z_bar_err;
        const stewart_real y_y_bar = g_y*gamma_y_bar - Y_moment_y*c9 - Q_y*c_force_y_bar - c24*omega_y + g_x_k_y*gamma_n_bar
            + S_ddot_y*c19 + S_dot_y*c21;
        const stewart_real y_y_bar_err = Q_y_err*c_force_y_bar_max + Q_y_max*c_force_y_bar_err + S_ddot_y_err*c19_max
            + S_ddot_y_max*c19_err + S_dot_y_err*c21_max + S_dot_y_max*c21_err + Y_moment_y_max*c9_err + c24_err*omega_y_max
            + g_x_k_y_err*gamma_n_bar_max + g_x_k_y_max*gamma_n_bar_err + g_y_max*gamma_y_bar_err + STEWART_UNIT*(S_dot_y_max*c21_max
            + REAL(5)*Q_y_max*c_force_y_bar_max + REAL(2)*S_ddot_y_max*c19_max + REAL(6)*Y_moment_y_max*c9_max
            + REAL(4)*c24_max*omega_y_max + REAL(3)*g_x_k_y_max*gamma_n_bar_max + REAL(6)*g_y_max*gamma_y_bar_max
            + STEWART_FABS(y_y_bar));
        const stewart_real y_y_bar_max = STEWART_FABS(y_y_bar) + y_y_bar_err;
        const stewart_real y_x_bar = g_x*gamma_y_bar - Y_moment_x*c9 - Q_y*c_force_x_bar - c24*omega_x + g_x_k_x*gamma_n_bar
            + S_ddot_x*c19 + S_dot_x*c21;
        const stewart_real y_x_bar_err = Q_y_err*c_force_x_bar_max + Q_y_max*c_force_x_bar_err + S_ddot_x_err*c19_max
            + S_ddot_x_max*c19_err + S_dot_x_err*c21_max + S_dot_x_max*c21_err + Y_moment_x_max*c9_err + c24_err*omega_x_max
            + g_x_k_x_err*gamma_n_bar_max + g_x_k_x_max*gamma_n_bar_err + g_x_max*gamma_y_bar_err + STEWART_UNIT*(S_dot_x_max*c21_max
            + REAL(5)*Q_y_max*c_force_x_bar_max + REAL(2)*S_ddot_x_max*c19_max + REAL(6)*Y_moment_x_max*c9_max
            + REAL(4)*c24_max*omega_x_max + REAL(3)*g_x_k_x_max*gamma_n_bar_max + REAL(6)*g_x_max*gamma_y_bar_max
            + STEWART_FABS(y_x_bar));
        const stewart_real y_x_bar_max = STEWART_FABS(y_x_bar) + y_x_bar_err;
        const stewart_real z_z_bar = s_x*y_y_bar - Q_z*c_force_z_bar - S_ddot_z*c20 - S_dot_z*c22 - s_y*y_x_bar;
        const stewart_real z_z_bar_err = Q_z_err*c_force_z_bar_max + Q_z_max*c_force_z_bar_err + S_ddot_z_err*c20_max
            + S_ddot_z_max*c20_err + S_dot_z_err*c22_max + S_dot_z_max*c22_err + s_x_err*y_y_bar_max + s_x_max*y_y_bar_err
            + s_y_err*y_x_bar_max + s_y_max*y_x_bar_err + STEWART_UNIT*(s_y_max*y_x_bar_max + REAL(4)*Q_z_max*c_force_z_bar_max
            + REAL(3)*S_ddot_z_max*c20_max + REAL(2)*S_dot_z_max*c22_max + REAL(4)*s_x_max*y_y_bar_max + STEWART_FABS(z_z_bar));
        const stewart_real z_z_bar_max = STEWART_FABS(z_z_bar) + z_z_bar_err;
        const stewart_real z_y_bar = s_z*y_x_bar - Q_z*c_force_y_bar - S_ddot_y*c20 - S_dot_y*c22 - s_x*y_z_bar;
        const stewart_real z_y_bar_err = Q_z_err*c_force_y_bar_max + Q_z_max*c_force_y_bar_err + S_ddot_y_err*c20_max
            + S_ddot_y_max*c20_err + S_dot_y_err*c22_max + S_dot_y_max*c22_err + s_x_err*y_z_bar_max + s_x_max*y_z_bar_err
            + s_z_err*y_x_bar_max + s_z_max*y_x_bar_err + STEWART_UNIT*(s_x_max*y_z_bar_max + REAL(4)*Q_z_max*c_force_y_bar_max
            + REAL(3)*S_ddot_y_max*c20_max + REAL(2)*S_dot_y_max*c22_max + REAL(4)*s_z_max*y_x_bar_max + STEWART_FABS(z_y_bar));
        const stewart_real z_y_bar_max = STEWART_FABS(z_y_bar) + z_y_bar_err;
        const stewart_real z_x_bar = s_y*y_z_bar - Q_z*c_force_x_bar - S_ddot_x*c20 - S_dot_x*c22 - s_z*y_y_bar;
        const stewart_real z_x_bar_err = Q_z_err*c_force_x_bar_max + Q_z_max*c_force_x_bar_err + S_ddot_x_err*c20_max
            + S_ddot_x_max*c20_err + S_dot_x_err*c22_max + S_dot_x_max*c22_err + s_y_err*y_z_bar_max + s_y_max*y_z_bar_err
            + s_z_err*y_y_bar_max + s_z_max*y_y_bar_err + STEWART_UNIT*(s_z_max*y_y_bar_max + REAL(4)*Q_z_max*c_force_x_bar_max
            + REAL(3)*S_ddot_x_max*c20_max + REAL(2)*S_dot_x_max*c22_max + REAL(4)*s_y_max*y_z_bar_max + STEWART_FABS(z_x_bar));
        const stewart_real z_x_bar_max = STEWART_FABS(z_x_bar) + z_x_bar_err;
        const stewart_real inv_rho_bar = Q_y_bar*tau_k + own_phi_ddot_bar*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z)
            + kappa_bar*zeta + phi_dot_bar*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z) + s_cross_normal_x*z_x_bar
            + s_cross_normal_y*z_y_bar + s_cross_normal_z*z_z_bar;
        const stewart_real inv_rho_bar_err = Q_y_bar_err*tau_k_max + Q_y_bar_max*tau_k_err + kappa_bar_err*zeta_max
            + kappa_bar_max*zeta_err + s_cross_normal_x_err*z_x_bar_max + s_cross_normal_x_max*z_x_bar_err + s_cross_normal_y_err*z_y_bar_max
            + s_cross_normal_y_max*z_y_bar_err + s_cross_normal_z_err*z_z_bar_max + s_cross_normal_z_max*z_z_bar_err
            + S_ddot_x_err*own_phi_ddot_bar_max*y_x_max + S_ddot_y_err*own_phi_ddot_bar_max*y_y_max + S_ddot_z_err*own_phi_ddot_bar_max*y_z_max
            + S_dot_x_err*phi_dot_bar_max*y_x_max + S_dot_y_err*phi_dot_bar_max*y_y_max + S_dot_z_err*phi_dot_bar_max*y_z_max
            + y_x_err*(S_ddot_x_max*own_phi_ddot_bar_max + S_dot_x_max*phi_dot_bar_max) + y_y_err*(S_ddot_y_max*own_phi_ddot_bar_max
            + S_dot_y_max*phi_dot_bar_max) + y_z_err*(S_ddot_z_max*own_phi_ddot_bar_max + S_dot_z_max*phi_dot_bar_max)
            + own_phi_ddot_bar_err*(S_ddot_x_max*y_x_max + S_ddot_y_max*y_y_max + S_ddot_z_max*y_z_max) + phi_dot_bar_err*(S_dot_x_max*y_x_max
            + S_dot_y_max*y_y_max + S_dot_z_max*y_z_max) + STEWART_UNIT*(s_cross_normal_z_max*z_z_bar_max + REAL(6)*Q_y_bar_max*tau_k_max
            + REAL(5)*kappa_bar_max*zeta_max + REAL(3)*s_cross_normal_x_max*z_x_bar_max + REAL(2)*s_cross_normal_y_max*z_y_bar_max
            + REAL(6)*own_phi_ddot_bar_max*(S_ddot_x_max*y_x_max + S_ddot_y_max*y_y_max + S_ddot_z_max*y_z_max)
            + own_phi_ddot_bar_max*(REAL(3)*S_ddot_x_max*y_x_max + REAL(3)*S_ddot_y_max*y_y_max + REAL(2)*S_ddot_z_max*y_z_max)
            + REAL(4)*phi_dot_bar_max*(S_dot_x_max*y_x_max + S_dot_y_max*y_y_max + S_dot_z_max*y_z_max) + phi_dot_bar_max*(REAL(3)*S_dot_x_max*y_x_max
            + REAL(3)*S_dot_y_max*y_y_max + REAL(2)*S_dot_z_max*y_z_max) + STEWART_FABS(inv_rho_bar));
        const stewart_real inv_rho_bar_max = STEWART_FABS(inv_rho_bar) + inv_rho_bar_err;
        const stewart_real rho_bar = inv_L*k3_bar - inv_rho_bar*inv_rho*inv_rho;
        const stewart_real rho_bar_err = inv_L_err*k3_bar_max + inv_L_max*k3_bar_err + inv_rho_bar_err*inv_rho_max*inv_rho_max
            + REAL(2)*inv_rho_bar_max*inv_rho_err*inv_rho_max + STEWART_UNIT*(inv_L_max*k3_bar_max + REAL(2)*inv_rho_bar_max*inv_rho_max*inv_rho_max
            + STEWART_FABS(rho_bar));
        const stewart_real rho_bar_max = STEWART_FABS(rho_bar) + rho_bar_err;
        const stewart_real c25 = inv_rho*rho_bar;
        const stewart_real c25_err = inv_rho_err*rho_bar_max + inv_rho_max*rho_bar_err + STEWART_UNIT*STEWART_FABS(c25);
        const stewart_real c25_max = STEWART_FABS(c25) + c25_err;
        const stewart_real s_cross_normal_z_bar = inv_rho*z_z_bar + c25*s_cross_normal_z;
        const stewart_real s_cross_normal_z_bar_err = c25_err*s_cross_normal_z_max + c25_max*s_cross_normal_z_err
            + inv_rho_err*z_z_bar_max + inv_rho_max*z_z_bar_err + STEWART_UNIT*(c25_max*s_cross_normal_z_max
            + inv_rho_max*z_z_bar_max + STEWART_FABS(s_cross_normal_z_bar));
        const stewart_real s_cross_normal_z_bar_max = STEWART_FABS(s_cross_normal_z_bar) + s_cross_normal_z_bar_err;
        const stewart_real s_cross_normal_y_bar = inv_rho*z_y_bar + c25*s_cross_normal_y;
        const stewart_real s_cross_normal_y_bar_err = c25_err*s_cross_normal_y_max + c25_max*s_cross_normal_y_err
            + inv_rho_err*z_y_bar_max + inv_rho_max*z_y_bar_err + STEWART_UNIT*(c25_max*s_cross_normal_y_max
            + inv_rho_max*z_y_bar_max + STEWART_FABS(s_cross_normal_y_bar));
        const stewart_real s_cross_normal_y_bar_max = STEWART_FABS(s_cross_normal_y_bar) + s_cross_normal_y_bar_err;
        const stewart_real s_cross_normal_x_bar = inv_rho*z_x_bar + c25*s_cross_normal_x;
        const stewart_real s_cross_normal_x_bar_err = c25_err*s_cross_normal_x_max + c25_max*s_cross_normal_x_err
            + inv_rho_err*z_x_bar_max + inv_rho_max*z_x_bar_err + STEWART_UNIT*(c25_max*s_cross_normal_x_max
            + inv_rho_max*z_x_bar_max + STEWART_FABS(s_cross_normal_x_bar));
        const stewart_real s_cross_normal_x_bar_max = STEWART_FABS(s_cross_normal_x_bar) + s_cross_normal_x_bar_err;
        const stewart_real s_z_bar = H_force_z_bar + L_ddot_bar*S_ddot_z + L_dot_bar*S_dot_z + y_x_bar*z_y - y_y_bar*z_x
            + k_cross_S_x*s_cross_normal_y_bar - k_cross_S_y*s_cross_normal_x_bar;
        const stewart_real s_z_bar_err = H_force_z_bar_err + L_ddot_bar_err*S_ddot_z_max + L_ddot_bar_max*S_ddot_z_err
            + L_dot_bar_err*S_dot_z_max + L_dot_bar_max*S_dot_z_err + k_cross_S_x_err*s_cross_normal_y_bar_max
            + k_cross_S_x_max*s_cross_normal_y_bar_err + k_cross_S_y_err*s_cross_normal_x_bar_max + k_cross_S_y_max*s_cross_normal_x_bar_err
            + y_x_bar_err*z_y_max + y_x_bar_max*z_y_err + y_y_bar_err*z_x_max + y_y_bar_max*z_x_err + STEWART_UNIT*(REAL(5)*H_force_z_bar_max
            + k_cross_S_y_max*s_cross_normal_x_bar_max + REAL(6)*L_ddot_bar_max*S_ddot_z_max + REAL(5)*L_dot_bar_max*S_dot_z_max
            + REAL(2)*k_cross_S_x_max*s_cross_normal_y_bar_max + REAL(4)*y_x_bar_max*z_y_max + REAL(3)*y_y_bar_max*z_x_max
            + STEWART_FABS(s_z_bar));
        const stewart_real s_z_bar_max = STEWART_FABS(s_z_bar) + s_z_bar_err;
        const stewart_real s_y_bar = H_force_y_bar + L_ddot_bar*S_ddot_y + L_dot_bar*S_dot_y + y_z_bar*z_x - y_x_bar*z_z
            + k_cross_S_z*s_cross_normal_x_bar - k_cross_S_x*s_cross_normal_z_bar;
        const stewart_real s_y_bar_err = H_force_y_bar_err + L_ddot_bar_err*S_ddot_y_max + L_ddot_bar_max*S_ddot_y_err
            + L_dot_bar_err*S_dot_y_max + L_dot_bar_max*S_dot_y_err + k_cross_S_x_err*s_cross_normal_z_bar_max
            + k_cross_S_x_max*s_cross_normal_z_bar_err + k_cross_S_z_err*s_cross_normal_x_bar_max + k_cross_S_z_max*s_cross_normal_x_bar_err
            + y_x_bar_err*z_z_max + y_x_bar_max*z_z_err + y_z_bar_err*z_x_max + y_z_bar_max*z_x_err + STEWART_UNIT*(REAL(5)*H_force_y_bar_max
            + k_cross_S_x_max*s_cross_normal_z_bar_max + REAL(6)*L_ddot_bar_max*S_ddot_y_max + REAL(5)*L_dot_bar_max*S_dot_y_max
            + REAL(2)*k_cross_S_z_max*s_cross_normal_x_bar_max + REAL(3)*y_x_bar_max*z_z_max + REAL(4)*y_z_bar_max*z_x_max
            + STEWART_FABS(s_y_bar));
        const stewart_real s_y_bar_max = STEWART_FABS(s_y_bar) + s_y_bar_err;
        const stewart_real s_x_bar = H_force_x_bar + L_ddot_bar*S_ddot_x + L_dot_bar*S_dot_x + y_y_bar*z_z - y_z_bar*z_y
            + k_cross_S_y*s_cross_normal_z_bar - k_cross_S_z*s_cross_normal_y_bar;
        const stewart_real s_x_bar_err = H_force_x_bar_err + L_ddot_bar_err*S_ddot_x_max + L_ddot_bar_max*S_ddot_x_err
            + L_dot_bar_err*S_dot_x_max + L_dot_bar_max*S_dot_x_err + k_cross_S_y_err*s_cross_normal_z_bar_max
            + k_cross_S_y_max*s_cross_normal_z_bar_err + k_cross_S_z_err*s_cross_normal_y_bar_max + k_cross_S_z_max*s_cross_normal_y_bar_err
            + y_y_bar_err*z_z_max + y_y_bar_max*z_z_err + y_z_bar_err*z_y_max + y_z_bar_max*z_y_err + STEWART_UNIT*(REAL(5)*H_force_x_bar_max
            + k_cross_S_z_max*s_cross_normal_y_bar_max + REAL(6)*L_ddot_bar_max*S_ddot_x_max + REAL(5)*L_dot_bar_max*S_dot_x_max
            + REAL(2)*k_cross_S_y_max*s_cross_normal_z_bar_max + REAL(4)*y_y_bar_max*z_z_max + REAL(3)*y_z_bar_max*z_y_max
            + STEWART_FABS(s_x_bar));
        const stewart_real s_x_bar_max = STEWART_FABS(s_x_bar) + s_x_bar_err;
        const stewart_real inv_L_bar = own_theta_ddot_bar*(-S_ddot_x*z_x - S_ddot_y*z_y - S_ddot_z*z_z) - Q_z_bar*tau_y
            + L_dot*L_share_bar + k1_bar*zeta + theta_dot_bar*(-S_dot_x*z_x - S_dot_y*z_y - S_dot_z*z_z) + k3_bar*rho
            + S_x*s_x_bar + S_y*s_y_bar + S_z*s_z_bar;
        const stewart_real inv_L_bar_err = L_dot_err*L_share_bar_max + L_dot_max*L_share_bar_err + Q_z_bar_err*tau_y_max
            + Q_z_bar_max*tau_y_err + S_x_err*s_x_bar_max + S_x_max*s_x_bar_err + S_y_err*s_y_bar_max + S_y_max*s_y_bar_err
            + S_z_err*s_z_bar_max + S_z_max*s_z_bar_err + k1_bar_err*zeta_max + k1_bar_max*zeta_err + k3_bar_err*rho_max
            + k3_bar_max*rho_err + S_ddot_x_err*own_theta_ddot_bar_max*z_x_max + S_ddot_y_err*own_theta_ddot_bar_max*z_y_max
            + S_ddot_z_err*own_theta_ddot_bar_max*z_z_max + S_dot_x_err*theta_dot_bar_max*z_x_max + S_dot_y_err*theta_dot_bar_max*z_y_max
            + S_dot_z_err*theta_dot_bar_max*z_z_max + z_x_err*(S_ddot_x_max*own_theta_ddot_bar_max + S_dot_x_max*theta_dot_bar_max)
            + z_y_err*(S_ddot_y_max*own_theta_ddot_bar_max + S_dot_y_max*theta_dot_bar_max) + z_z_err*(S_ddot_z_max*own_theta_ddot_bar_max
            + S_dot_z_max*theta_dot_bar_max) + own_theta_ddot_bar_err*(S_ddot_x_max*z_x_max + S_ddot_y_max*z_y_max
            + S_ddot_z_max*z_z_max) + theta_dot_bar_err*(S_dot_x_max*z_x_max + S_dot_y_max*z_y_max + S_dot_z_max*z_z_max)
            + STEWART_UNIT*(S_z_max*s_z_bar_max + REAL(7)*L_dot_max*L_share_bar_max + REAL(8)*Q_z_bar_max*tau_y_max
            + REAL(3)*S_x_max*s_x_bar_max + REAL(2)*S_y_max*s_y_bar_max + REAL(6)*k1_bar_max*zeta_max + REAL(4)*k3_bar_max*rho_max
            + REAL(8)*own_theta_ddot_bar_max*(S_ddot_x_max*z_x_max + S_ddot_y_max*z_y_max + S_ddot_z_max*z_z_max)
            + own_theta_ddot_bar_max*(REAL(3)*S_ddot_x_max*z_x_max + REAL(3)*S_ddot_y_max*z_y_max + REAL(2)*S_ddot_z_max*z_z_max)
            + REAL(5)*theta_dot_bar_max*(S_dot_x_max*z_x_max + S_dot_y_max*z_y_max + S_dot_z_max*z_z_max) + theta_dot_bar_max*(REAL(3)*S_dot_x_max*z_x_max
            + REAL(3)*S_dot_y_max*z_y_max + REAL(2)*S_dot_z_max*z_z_max) + STEWART_FABS(inv_L_bar));
        const stewart_real inv_L_bar_max = STEWART_FABS(inv_L_bar) + inv_L_bar_err;
        const stewart_real L_bar = L_ddot_bar*(theta_dot2 + k33*phi_dot2) + L_h2_bar*h2_x + c2_bar*h2_z - a3_bar*h_y
            - inv_L_bar*inv_L*inv_L;
        const stewart_real L_bar_err = L_ddot_bar_max*theta_dot2_err + L_h2_bar_err*h2_x_max + L_h2_bar_max*h2_x_err
            + a3_bar_err*h_y_max + a3_bar_max*h_y_err + c2_bar_err*h2_z_max + c2_bar_max*h2_z_err + L_ddot_bar_max*k33_err*phi_dot2_max
            + L_ddot_bar_max*k33_max*phi_dot2_err + inv_L_bar_err*inv_L_max*inv_L_max + L_ddot_bar_err*(theta_dot2_max
            + k33_max*phi_dot2_max) + REAL(2)*inv_L_bar_max*inv_L_err*inv_L_max + STEWART_UNIT*(REAL(4)*L_h2_bar_max*h2_x_max
            + REAL(2)*a3_bar_max*h_y_max + REAL(3)*c2_bar_max*h2_z_max + REAL(2)*inv_L_bar_max*inv_L_max*inv_L_max
            + REAL(4)*L_ddot_bar_max*(theta_dot2_max + k33_max*phi_dot2_max) + L_ddot_bar_max*(theta_dot2_max
            + REAL(2)*k33_max*phi_dot2_max) + STEWART_FABS(L_bar));
        const stewart_real L_bar_max = STEWART_FABS(L_bar) + L_bar_err;
        const stewart_real k_cross_S_z_bar = s_cross_normal_x_bar*s_y - s_cross_normal_y_bar*s_x;
        const stewart_real k_cross_S_z_bar_err = s_cross_normal_x_bar_err*s_y_max + s_cross_normal_x_bar_max*s_y_err
            + s_cross_normal_y_bar_err*s_x_max + s_cross_normal_y_bar_max*s_x_err + STEWART_UNIT*(s_cross_normal_x_bar_max*s_y_max
            + s_cross_normal_y_bar_max*s_x_max + STEWART_FABS(k_cross_S_z_bar));
        const stewart_real k_cross_S_z_bar_max = STEWART_FABS(k_cross_S_z_bar) + k_cross_S_z_bar_err;
        const stewart_real k_cross_S_y_bar = s_cross_normal_z_bar*s_x - s_cross_normal_x_bar*s_z;
        const stewart_real k_cross_S_y_bar_err = s_cross_normal_x_bar_err*s_z_max + s_cross_normal_x_bar_max*s_z_err
            + s_cross_normal_z_bar_err*s_x_max + s_cross_normal_z_bar_max*s_x_err + STEWART_UNIT*(s_cross_normal_x_bar_max*s_z_max
            + s_cross_normal_z_bar_max*s_x_max + STEWART_FABS(k_cross_S_y_bar));
        const stewart_real k_cross_S_y_bar_max = STEWART_FABS(k_cross_S_y_bar) + k_cross_S_y_bar_err;
        const stewart_real k_cross_S_x_bar = s_cross_normal_y_bar*s_z - s_cross_normal_z_bar*s_y;
        const stewart_real k_cross_S_x_bar_err = s_cross_normal_y_bar_err*s_z_max + s_cross_normal_y_bar_max*s_z_err
            + s_cross_normal_z_bar_err*s_y_max + s_cross_normal_z_bar_max*s_y_err + STEWART_UNIT*(s_cross_normal_y_bar_max*s_z_max
            + s_cross_normal_z_bar_max*s_y_max + STEWART_FABS(k_cross_S_x_bar));
        const stewart_real k_cross_S_x_bar_max = STEWART_FABS(k_cross_S_x_bar) + k_cross_S_x_bar_err;
        const stewart_real zeta_bar = inv_rho*kappa_bar + inv_L*k1_bar;
        const stewart_real zeta_bar_err = inv_L_err*k1_bar_max + inv_L_max*k1_bar_err + inv_rho_err*kappa_bar_max
            + inv_rho_max*kappa_bar_err + STEWART_UNIT*(inv_L_max*k1_bar_max + inv_rho_max*kappa_bar_max + STEWART_FABS(zeta_bar));
        const stewart_real zeta_bar_max = STEWART_FABS(zeta_bar) + zeta_bar_err;
        const stewart_real c26 = L_bar*inv_L;
        const stewart_real c26_err = L_bar_err*inv_L_max + L_bar_max*inv_L_err + STEWART_UNIT*STEWART_FABS(c26);
        const stewart_real c26_max = STEWART_FABS(c26) + c26_err;
        const stewart_real S_z_bar = k_z*zeta_bar + inv_L*s_z_bar + k_cross_S_x_bar*k_y - k_cross_S_y_bar*k_x
            + S_z*c26;
        const stewart_real S_z_bar_err = S_z_err*c26_max + S_z_max*c26_err + inv_L_err*s_z_bar_max + inv_L_max*s_z_bar_err
            + k_cross_S_x_bar_err*k_y_max + k_cross_S_x_bar_max*k_y_err + k_cross_S_y_bar_err*k_x_max + k_cross_S_y_bar_max*k_x_err
            + k_z_err*zeta_bar_max + k_z_max*zeta_bar_err + STEWART_UNIT*(S_z_max*c26_max + REAL(4)*inv_L_max*s_z_bar_max
            + REAL(3)*k_cross_S_x_bar_max*k_y_max + REAL(2)*k_cross_S_y_bar_max*k_x_max + REAL(4)*k_z_max*zeta_bar_max
            + STEWART_FABS(S_z_bar));
        const stewart_real S_z_bar_max = STEWART_FABS(S_z_bar) + S_z_bar_err;
        const stewart_real S_y_bar = k_y*zeta_bar + inv_L*s_y_bar + k_cross_S_z_bar*k_x - k_cross_S_x_bar*k_z
            + S_y*c26;
        const stewart_real S_y_bar_err = S_y_err*c26_max + S_y_max*c26_err + inv_L_err*s_y_bar_max + inv_L_max*s_y_bar_err
            + k_cross_S_x_bar_err*k_z_max + k_cross_S_x_bar_max*k_z_err + k_cross_S_z_bar_err*k_x_max + k_cross_S_z_bar_max*k_x_err
            + k_y_err*zeta_bar_max + k_y_max*zeta_bar_err + STEWART_UNIT*(S_y_max*c26_max + REAL(4)*inv_L_max*s_y_bar_max
            + REAL(2)*k_cross_S_x_bar_max*k_z_max + REAL(3)*k_cross_S_z_bar_max*k_x_max + REAL(4)*k_y_max*zeta_bar_max
            + STEWART_FABS(S_y_bar));
        const stewart_real S_y_bar_max = STEWART_FABS(S_y_bar) + S_y_bar_err;
        const stewart_real S_x_bar = k_x*zeta_bar + inv_L*s_x_bar + k_cross_S_y_bar*k_z - k_cross_S_z_bar*k_y
            + S_x*c26;
        const stewart_real S_x_bar_err = S_x_err*c26_max + S_x_max*c26_err + inv_L_err*s_x_bar_max + inv_L_max*s_x_bar_err
            + k_cross_S_y_bar_err*k_z_max + k_cross_S_y_bar_max*k_z_err + k_cross_S_z_bar_err*k_y_max + k_cross_S_z_bar_max*k_y_err
            + k_x_err*zeta_bar_max + k_x_max*zeta_bar_err + STEWART_UNIT*(S_x_max*c26_max + REAL(4)*inv_L_max*s_x_bar_max
            + REAL(3)*k_cross_S_y_bar_max*k_z_max + REAL(2)*k_cross_S_z_bar_max*k_y_max + REAL(4)*k_x_max*zeta_bar_max
            + STEWART_FABS(S_x_bar));
        const stewart_real S_x_bar_max = STEWART_FABS(S_x_bar) + S_x_bar_err;
        const stewart_real q_z_bar = arm_z_bar + B_xz*S_ddot_x_bar + B_yz*S_ddot_y_bar + B_zz*S_ddot_z_bar + S_dot_x_bar*omega_y
            - S_dot_y_bar*omega_x + S_z_bar;
        const stewart_real q_z_bar_err = S_z_bar_err + arm_z_bar_err + B_xz_err*S_ddot_x_bar_max + B_xz_max*S_ddot_x_bar_err
            + B_yz_err*S_ddot_y_bar_max + B_yz_max*S_ddot_y_bar_err + B_zz_err*S_ddot_z_bar_max + B_zz_max*S_ddot_z_bar_err
            + S_dot_x_bar_err*omega_y_max + S_dot_y_bar_err*omega_x_max + STEWART_UNIT*(REAL(5)*arm_z_bar_max
            + REAL(6)*B_xz_max*S_ddot_x_bar_max + REAL(5)*B_yz_max*S_ddot_y_bar_max + REAL(4)*B_zz_max*S_ddot_z_bar_max
            + REAL(3)*S_dot_x_bar_max*omega_y_max + REAL(2)*S_dot_y_bar_max*omega_x_max + STEWART_FABS(q_z_bar));
        const stewart_real q_z_bar_max = STEWART_FABS(q_z_bar) + q_z_bar_err;
        const stewart_real q_y_bar = arm_y_bar + B_xy*S_ddot_x_bar + B_yy*S_ddot_y_bar + B_zy*S_ddot_z_bar + S_dot_z_bar*omega_x
            - S_dot_x_bar*omega_z + S_y_bar;
        const stewart_real q_y_bar_err = S_y_bar_err + arm_y_bar_err + B_xy_err*S_ddot_x_bar_max + B_xy_max*S_ddot_x_bar_err
            + B_yy_err*S_ddot_y_bar_max + B_yy_max*S_ddot_y_bar_err + B_zy_err*S_ddot_z_bar_max + B_zy_max*S_ddot_z_bar_err
            + S_dot_x_bar_err*omega_z_max + S_dot_z_bar_err*omega_x_max + STEWART_UNIT*(REAL(5)*arm_y_bar_max
            + REAL(6)*B_xy_max*S_ddot_x_bar_max + REAL(5)*B_yy_max*S_ddot_y_bar_max + REAL(4)*B_zy_max*S_ddot_z_bar_max
            + REAL(2)*S_dot_x_bar_max*omega_z_max + REAL(3)*S_dot_z_bar_max*omega_x_max + STEWART_FABS(q_y_bar));
        const stewart_real q_y_bar_max = STEWART_FABS(q_y_bar) + q_y_bar_err;
        const stewart_real q_x_bar = arm_x_bar + B_xx*S_ddot_x_bar + B_yx*S_ddot_y_bar + B_zx*S_ddot_z_bar + S_dot_y_bar*omega_z
            - S_dot_z_bar*omega_y + S_x_bar;
        const stewart_real q_x_bar_err = S_x_bar_err + arm_x_bar_err + B_xx_err*S_ddot_x_bar_max + B_xx_max*S_ddot_x_bar_err
            + B_yx_err*S_ddot_y_bar_max + B_yx_max*S_ddot_y_bar_err + B_zx_err*S_ddot_z_bar_max + B_zx_max*S_ddot_z_bar_err
            + S_dot_y_bar_err*omega_z_max + S_dot_z_bar_err*omega_y_max + STEWART_UNIT*(REAL(5)*arm_x_bar_max
            + REAL(6)*B_xx_max*S_ddot_x_bar_max + REAL(5)*B_yx_max*S_ddot_y_bar_max + REAL(4)*B_zx_max*S_ddot_z_bar_max
            + REAL(3)*S_dot_y_bar_max*omega_z_max + REAL(2)*S_dot_z_bar_max*omega_y_max + STEWART_FABS(q_x_bar));
        const stewart_real q_x_bar_max = STEWART_FABS(q_x_bar) + q_x_bar_err;
        const stewart_real c27 = C_s*tau_k_bar;
        const stewart_real c27_err = C_s_max*tau_k_bar_err + STEWART_UNIT*STEWART_FABS(c27);
        const stewart_real c27_max = STEWART_FABS(c27) + c27_err;
        const stewart_real k_x_bar = S_x*zeta_bar - Y_moment_x*c8 - c27*omega_x + S_y*k_cross_S_z_bar - S_z*k_cross_S_y_bar;
        const stewart_real k_x_bar_err = S_x_err*zeta_bar_max + S_x_max*zeta_bar_err + S_y_err*k_cross_S_z_bar_max
            + S_y_max*k_cross_S_z_bar_err + S_z_err*k_cross_S_y_bar_max + S_z_max*k_cross_S_y_bar_err + Y_moment_x_max*c8_err
            + c27_err*omega_x_max + STEWART_UNIT*(S_z_max*k_cross_S_y_bar_max + REAL(4)*S_x_max*zeta_bar_max
            + REAL(2)*S_y_max*k_cross_S_z_bar_max + REAL(4)*Y_moment_x_max*c8_max + REAL(3)*c27_max*omega_x_max
            + STEWART_FABS(k_x_bar));
        const stewart_real k_x_bar_max = STEWART_FABS(k_x_bar) + k_x_bar_err;
        const stewart_real k_y_bar = S_y*zeta_bar - Y_moment_y*c8 - c27*omega_y + S_z*k_cross_S_x_bar - S_x*k_cross_S_z_bar;
        const stewart_real k_y_bar_err = S_x_err*k_cross_S_z_bar_max + S_x_max*k_cross_S_z_bar_err + S_y_err*zeta_bar_max
            + S_y_max*zeta_bar_err + S_z_err*k_cross_S_x_bar_max + S_z_max*k_cross_S_x_bar_err + Y_moment_y_max*c8_err
            + c27_err*omega_y_max + STEWART_UNIT*(S_x_max*k_cross_S_z_bar_max + REAL(4)*S_y_max*zeta_bar_max
            + REAL(2)*S_z_max*k_cross_S_x_bar_max + REAL(4)*Y_moment_y_max*c8_max + REAL(3)*c27_max*omega_y_max
            + STEWART_FABS(k_y_bar));
        const stewart_real k_y_bar_max = STEWART_FABS(k_y_bar) + k_y_bar_err;
        const stewart_real k_z_bar = S_z*zeta_bar - Y_moment_z*c8 - c27*omega_z + S_x*k_cross_S_y_bar - S_y*k_cross_S_x_bar;
        const stewart_real k_z_bar_err = S_x_err*k_cross_S_y_bar_max + S_x_max*k_cross_S_y_bar_err + S_y_err*k_cross_S_x_bar_max
            + S_y_max*k_cross_S_x_bar_err + S_z_err*zeta_bar_max + S_z_max*zeta_bar_err + Y_moment_z_max*c8_err
            + c27_err*omega_z_max + STEWART_UNIT*(S_y_max*k_cross_S_x_bar_max + REAL(2)*S_x_max*k_cross_S_y_bar_max
            + REAL(4)*S_z_max*zeta_bar_max + REAL(4)*Y_moment_z_max*c8_max + REAL(3)*c27_max*omega_z_max + STEWART_FABS(k_z_bar));
        const stewart_real k_z_bar_max = STEWART_FABS(k_z_bar) + k_z_bar_err;
        const stewart_real h_x_bar = M_phi_L_bar*k33 - D_weight*theta_dot2;
        const stewart_real h_x_bar_err = D_weight_max*theta_dot2_err + M_phi_L_bar_err*k33_max + M_phi_L_bar_max*k33_err
            + STEWART_UNIT*(D_weight_max*theta_dot2_max + M_phi_L_bar_max*k33_max + STEWART_FABS(h_x_bar));
        const stewart_real h_x_bar_max = STEWART_FABS(h_x_bar) + h_x_bar_err;
        const stewart_real h_y_bar = -c7_bar*k3 - L*a3_bar;
        const stewart_real h_y_bar_err = L_err*a3_bar_max + L_max*a3_bar_err + c7_bar_err*k3_max + c7_bar_max*k3_err
            + STEWART_UNIT*(L_max*a3_bar_max + c7_bar_max*k3_max + STEWART_FABS(h_y_bar));
        const stewart_real h_y_bar_max = STEWART_FABS(h_y_bar) + h_y_bar_err;
        const stewart_real h_z_bar = D_weight*theta_ddot + L_ddot*tau_y_bar - M_phi_L_bar*k13;
        const stewart_real h_z_bar_err = D_weight_max*theta_ddot_err + L_ddot_err*tau_y_bar_max + L_ddot_max*tau_y_bar_err
            + M_phi_L_bar_err*k13_max + M_phi_L_bar_max*k13_err + STEWART_UNIT*(M_phi_L_bar_max*k13_max + REAL(2)*D_weight_max*theta_ddot_max
            + REAL(2)*L_ddot_max*tau_y_bar_max + STEWART_FABS(h_z_bar));
        const stewart_real h_z_bar_max = STEWART_FABS(h_z_bar) + h_z_bar_err;
        const stewart_real h2_x_bar = bend*tau_y_bar + L*L_h2_bar;
        const stewart_real h2_x_bar_err = L_err*L_h2_bar_max + L_h2_bar_err*L_max + bend_err*tau_y_bar_max + bend_max*tau_y_bar_err
            + STEWART_UNIT*(L_h2_bar_max*L_max + bend_max*tau_y_bar_max + STEWART_FABS(h2_x_bar));
        const stewart_real h2_x_bar_max = STEWART_FABS(h2_x_bar) + h2_x_bar_err;
        const stewart_real h2_y_bar = -bend*k1*tau_k_bar;
        const stewart_real h2_y_bar_err = bend_err*k1_max*tau_k_bar_max + bend_max*k1_err*tau_k_bar_max + bend_max*k1_max*tau_k_bar_err
            + STEWART_UNIT*(bend_max*k1_max*tau_k_bar_max + STEWART_FABS(h2_y_bar));
        const stewart_real h2_y_bar_max = STEWART_FABS(h2_y_bar) + h2_y_bar_err;
        const stewart_real h2_z_bar = L*c2_bar;
        const stewart_real h2_z_bar_err = L_err*c2_bar_max + L_max*c2_bar_err + STEWART_UNIT*STEWART_FABS(h2_z_bar);
        const stewart_real h2_z_bar_max = STEWART_FABS(h2_z_bar) + h2_z_bar_err;
        const stewart_real w_x_bar = k1*w_k_bar + k3*w_n_bar;
        const stewart_real w_x_bar_err = k1_err*w_k_bar_max + k1_max*w_k_bar_err + k3_err*w_n_bar_max + k3_max*w_n_bar_err
            + STEWART_UNIT*(k1_max*w_k_bar_max + k3_max*w_n_bar_max + STEWART_FABS(w_x_bar));
        const stewart_real w_x_bar_max = STEWART_FABS(w_x_bar) + w_x_bar_err;
        const stewart_real w_y_bar = -gamma_n*tau_k_bar;
        const stewart_real w_y_bar_err = gamma_n_err*tau_k_bar_max + gamma_n_max*tau_k_bar_err + STEWART_UNIT*STEWART_FABS(w_y_bar);
        const stewart_real w_y_bar_max = STEWART_FABS(w_y_bar) + w_y_bar_err;
        const stewart_real w_z_bar = k3*w_k_bar - k1*w_n_bar;
        const stewart_real w_z_bar_err = k1_err*w_n_bar_max + k1_max*w_n_bar_err + k3_err*w_k_bar_max + k3_max*w_k_bar_err
            + STEWART_UNIT*(k1_max*w_n_bar_max + k3_max*w_k_bar_max + STEWART_FABS(w_z_bar));
        const stewart_real w_z_bar_max = STEWART_FABS(w_z_bar) + w_z_bar_err;
        const stewart_real J_xx_bar = M_phi_bar - c23*kappa;
        const stewart_real J_xx_bar_err = M_phi_bar_err + c23_err*kappa_max + c23_max*kappa_err + STEWART_UNIT*(c23_max*kappa_max
            + STEWART_FABS(J_xx_bar));
        const stewart_real J_xx_bar_max = STEWART_FABS(J_xx_bar) + J_xx_bar_err;
        const stewart_real c28 = c12*k13;
        const stewart_real c28_err = c12_err*k13_max + c12_max*k13_err + STEWART_UNIT*STEWART_FABS(c28);
        const stewart_real J_yy_bar = M_theta_bar + c28;
        const stewart_real J_yy_bar_err = M_theta_bar_err + c28_err + STEWART_UNIT*STEWART_FABS(J_yy_bar);
        const stewart_real J_yy_bar_max = STEWART_FABS(J_yy_bar) + J_yy_bar_err;
        const stewart_real J_yz_bar = M_mixed_theta_bar*k1 + M_mixed_bar*k3;
        const stewart_real J_yz_bar_err = M_mixed_bar_err*k3_max + M_mixed_bar_max*k3_err + M_mixed_theta_bar_err*k1_max
            + M_mixed_theta_bar_max*k1_err + STEWART_UNIT*(M_mixed_bar_max*k3_max + M_mixed_theta_bar_max*k1_max
            + STEWART_FABS(J_yz_bar));
        const stewart_real J_yz_bar_max = STEWART_FABS(J_yz_bar) + J_yz_bar_err;
        const stewart_real J2_xz_bar = c13;
        const stewart_real J2_xz_bar_err = c13_err;
        const stewart_real J2_xz_bar_max = STEWART_FABS(J2_xz_bar) + J2_xz_bar_err;
        const stewart_real dJ_zx_bar = a1_bar - c28;
        const stewart_real dJ_zx_bar_err = a1_bar_err + c28_err + STEWART_UNIT*STEWART_FABS(dJ_zx_bar);
        const stewart_real dJ_zx_bar_max = STEWART_FABS(dJ_zx_bar) + dJ_zx_bar_err;
        const stewart_real g_k_bar = tau_y_bar*w_n;
        const stewart_real g_k_bar_err = tau_y_bar_err*w_n_max + tau_y_bar_max*w_n_err + STEWART_UNIT*STEWART_FABS(g_k_bar);
        const stewart_real g_k_bar_max = STEWART_FABS(g_k_bar) + g_k_bar_err;
        const stewart_real g_x_k_x_bar = gamma_n_bar*y_x;
        const stewart_real g_x_k_x_bar_err = gamma_n_bar_err*y_x_max + gamma_n_bar_max*y_x_err + STEWART_UNIT*STEWART_FABS(g_x_k_x_bar);
        const stewart_real g_x_k_x_bar_max = STEWART_FABS(g_x_k_x_bar) + g_x_k_x_bar_err;
        const stewart_real g_x_k_y_bar = gamma_n_bar*y_y;
        const stewart_real g_x_k_y_bar_err = gamma_n_bar_err*y_y_max + gamma_n_bar_max*y_y_err + STEWART_UNIT*STEWART_FABS(g_x_k_y_bar);
        const stewart_real g_x_k_y_bar_max = STEWART_FABS(g_x_k_y_bar) + g_x_k_y_bar_err;
        const stewart_real g_x_k_z_bar = gamma_n_bar*y_z;
        const stewart_real g_x_k_z_bar_err = gamma_n_bar_err*y_z_max + gamma_n_bar_max*y_z_err + STEWART_UNIT*STEWART_FABS(g_x_k_z_bar);
        const stewart_real g_x_k_z_bar_max = STEWART_FABS(g_x_k_z_bar) + g_x_k_z_bar_err;
        const stewart_real C_us_bar = phi_dot*tau_k_bar + tau_y_bar*theta_dot;
        const stewart_real C_us_bar_err = phi_dot_err*tau_k_bar_max + phi_dot_max*tau_k_bar_err + tau_y_bar_err*theta_dot_max
            + tau_y_bar_max*theta_dot_err + STEWART_UNIT*(phi_dot_max*tau_k_bar_max + tau_y_bar_max*theta_dot_max
            + STEWART_FABS(C_us_bar));
        const stewart_real C_us_bar_max = STEWART_FABS(C_us_bar) + C_us_bar_err;
        const stewart_real R_xx_bar = p_x*q_x_bar;
        const stewart_real R_xx_bar_err = p_x_max*q_x_bar_err + STEWART_UNIT*STEWART_FABS(R_xx_bar);
        const stewart_real R_xy_bar = p_y*q_x_bar;
        const stewart_real R_xy_bar_err = p_y_max*q_x_bar_err + STEWART_UNIT*STEWART_FABS(R_xy_bar);
        const stewart_real R_xz_bar = p_z*q_x_bar;
        const stewart_real R_xz_bar_err = p_z_max*q_x_bar_err + STEWART_UNIT*STEWART_FABS(R_xz_bar);
        const stewart_real R_yx_bar = p_x*q_y_bar;
        const stewart_real R_yx_bar_err = p_x_max*q_y_bar_err + STEWART_UNIT*STEWART_FABS(R_yx_bar);
        const stewart_real R_yy_bar = p_y*q_y_bar;
        const stewart_real R_yy_bar_err = p_y_max*q_y_bar_err + STEWART_UNIT*STEWART_FABS(R_yy_bar);
        const stewart_real R_yz_bar = p_z*q_y_bar;
        const stewart_real R_yz_bar_err = p_z_max*q_y_bar_err + STEWART_UNIT*STEWART_FABS(R_yz_bar);
        const stewart_real R_zx_bar = p_x*q_z_bar;
        const stewart_real R_zx_bar_err = p_x_max*q_z_bar_err + STEWART_UNIT*STEWART_FABS(R_zx_bar);
        const stewart_real R_zy_bar = p_y*q_z_bar;
        const stewart_real R_zy_bar_err = p_y_max*q_z_bar_err + STEWART_UNIT*STEWART_FABS(R_zy_bar);
        const stewart_real R_zz_bar = p_z*q_z_bar;
        const stewart_real R_zz_bar_err = p_z_max*q_z_bar_err + STEWART_UNIT*STEWART_FABS(R_zz_bar);
        const stewart_real B_xx_bar = S_ddot_x_bar*q_x;
        const stewart_real B_xx_bar_err = S_ddot_x_bar_err*q_x_max + S_ddot_x_bar_max*q_x_err + STEWART_UNIT*STEWART_FABS(B_xx_bar);
        const stewart_real B_xy_bar = S_ddot_x_bar*q_y;
        const stewart_real B_xy_bar_err = S_ddot_x_bar_err*q_y_max + S_ddot_x_bar_max*q_y_err + STEWART_UNIT*STEWART_FABS(B_xy_bar);
        const stewart_real B_xz_bar = S_ddot_x_bar*q_z;
        const stewart_real B_xz_bar_err = S_ddot_x_bar_err*q_z_max + S_ddot_x_bar_max*q_z_err + STEWART_UNIT*STEWART_FABS(B_xz_bar);
        const stewart_real B_yx_bar = S_ddot_y_bar*q_x;
        const stewart_real B_yx_bar_err = S_ddot_y_bar_err*q_x_max + S_ddot_y_bar_max*q_x_err + STEWART_UNIT*STEWART_FABS(B_yx_bar);
        const stewart_real B_yy_bar = S_ddot_y_bar*q_y;
        const stewart_real B_yy_bar_err = S_ddot_y_bar_err*q_y_max + S_ddot_y_bar_max*q_y_err + STEWART_UNIT*STEWART_FABS(B_yy_bar);
        const stewart_real B_yz_bar = S_ddot_y_bar*q_z;
        const stewart_real B_yz_bar_err = S_ddot_y_bar_err*q_z_max + S_ddot_y_bar_max*q_z_err + STEWART_UNIT*STEWART_FABS(B_yz_bar);
        const stewart_real B_zx_bar = S_ddot_z_bar*q_x;
        const stewart_real B_zx_bar_err = S_ddot_z_bar_err*q_x_max + S_ddot_z_bar_max*q_x_err + STEWART_UNIT*STEWART_FABS(B_zx_bar);
        const stewart_real B_zy_bar = S_ddot_z_bar*q_y;
        const stewart_real B_zy_bar_err = S_ddot_z_bar_err*q_y_max + S_ddot_z_bar_max*q_y_err + STEWART_UNIT*STEWART_FABS(B_zy_bar);
        const stewart_real B_zz_bar = S_ddot_z_bar*q_z;
        const stewart_real B_zz_bar_err = S_ddot_z_bar_err*q_z_max + S_ddot_z_bar_max*q_z_err + STEWART_UNIT*STEWART_FABS(B_zz_bar);
        error[i] = error[i] + k_x_bar_max*k_x_err + k_y_bar_max*k_y_err + k_z_bar_max*k_z_err + h_x_bar_max*h_x_err
            + h_y_bar_max*h_y_err + h_z_bar_max*h_z_err + h2_x_bar_max*h2_x_err + h2_y_bar_max*h2_y_err + h2_z_bar_max*h2_z_err
            + w_x_bar_max*w_x_err + w_y_bar_max*w_y_err + w_z_bar_max*w_z_err + J_xx_bar_max*J_xx_err + a3_bar_max*J_xy_err
            + J_yy_bar_max*J_yy_err + J_yz_bar_max*J_yz_err + J2_xz_bar_max*J2_xz_err + dJ_zx_bar_max*dJ_zx_err
            + g_k_bar_max*g_k_err + g_x_k_x_bar_max*g_x_k_x_err + g_x_k_y_bar_max*g_x_k_y_err + g_x_k_z_bar_max*g_x_k_z_err
            + C_us_bar_max*C_us_err + q_x_bar_max*q_x_own + q_y_bar_max*q_y_own + q_z_bar_max*q_z_own + S_x_bar_max*t_b_x_own
            + S_y_bar_max*t_b_y_own + S_z_bar_max*t_b_z_own + S_x_bar_max*S_x_own + S_y_bar_max*S_y_own + S_z_bar_max*S_z_own
            + zeta_bar_max*zeta_own + k_cross_S_x_bar_max*k_cross_S_x_own + k_cross_S_y_bar_max*k_cross_S_y_own
            + k_cross_S_z_bar_max*k_cross_S_z_own + L_bar_max*L_own + inv_L_bar_max*inv_L_own + s_x_bar_max*s_x_own
            + s_y_bar_max*s_y_own + s_z_bar_max*s_z_own + s_cross_normal_x_bar_max*s_cross_normal_x_own + s_cross_normal_y_bar_max*s_cross_normal_y_own
            + s_cross_normal_z_bar_max*s_cross_normal_z_own + rho_bar_max*rho_own + inv_rho_bar_max*inv_rho_own
            + z_x_bar_max*z_x_own + z_y_bar_max*z_y_own + z_z_bar_max*z_z_own + y_x_bar_max*y_x_own + y_y_bar_max*y_y_own
            + y_z_bar_max*y_z_own + k1_bar_max*k1_own + k3_bar_max*k3_own + kappa_bar_max*kappa_own + S_dot_x_bar_max*S_dot_x_own
            + S_dot_y_bar_max*S_dot_y_own + S_dot_z_bar_max*S_dot_z_own + S_ddot_x_bar_max*S_ddot_x_own + S_ddot_y_bar_max*S_ddot_y_own
            + S_ddot_z_bar_max*S_ddot_z_own + L_dot_bar_max*L_dot_own + phi_dot_bar_max*phi_dot_own + theta_dot_bar_max*theta_dot_own
            + L_share_bar_max*L_share_own + lean_bar_max*lean_own + theta_dot2_bar_max*theta_dot2_own + phi_dot2_bar_max*phi_dot2_own
            + k33_bar_max*k33_own + L_ddot_bar_max*L_ddot_own + own_theta_ddot_bar_max*own_theta_ddot_own + own_phi_ddot_bar_max*own_phi_ddot_own
            + c1_bar_max*c1_own + theta_ddot_bar_max*theta_ddot_own + phi_ddot_bar_max*phi_ddot_own + L_h2_bar_max*L_h2_own
            + a1_bar_max*a1_own + c2_bar_max*c2_own + c3_bar_max*c3_own + a3_bar_max*a3_own + M_phi_bar_max*M_phi_own
            + M_theta_bar_max*M_theta_own + M_mixed_bar_max*M_mixed_own + c7_bar_max*k3_h_own + M_phi_L_bar_max*M_phi_L_own
            + M_mixed_theta_bar_max*M_mixed_theta_own + c4_bar_max*c4_own + gamma_n_bar_max*gamma_n_own + gamma_y_bar_max*gamma_y_own
            + w_k_bar_max*w_k_own + w_n_bar_max*w_n_own + c5_bar_max*c5_own + c6_bar_max*c6_own + c7_bar_max*c7_own
            + tau_y_bar_max*tau_y_own + tau_k_bar_max*tau_k_own + Q_y_bar_max*Q_y_own + Q_z_bar_max*Q_z_own
            + c_force_x_bar_max*K_x_own + c_force_y_bar_max*K_y_own + c_force_z_bar_max*K_z_own + D_weight_max*D_own
            + c8_bar_max*c8_own + c9_bar_max*c9_own + arm_x_bar_max*arm_x_own + arm_y_bar_max*arm_y_own + arm_z_bar_max*arm_z_own
            + Y_moment_x_max*c_moment_x_own + Y_moment_y_max*c_moment_y_own + Y_moment_z_max*c_moment_z_own
            + H_moment_x_weight_max*H_moment_x_own + H_moment_y_weight_max*H_moment_y_own + H_moment_z_weight_max*H_moment_z_own
            + Y_arm_x_max*arm_c_x_own + Y_arm_y_max*arm_c_y_own + Y_arm_z_max*arm_c_z_own;
        add(&slopes->R_legs[0][i], &slopes->R_legs_err[0][i], R_xx_bar, R_xx_bar_err);
        add(&slopes->R_legs[1][i], &slopes->R_legs_err[1][i], R_xy_bar, R_xy_bar_err);
        add(&slopes->R_legs[2][i], &slopes->R_legs_err[2][i], R_xz_bar, R_xz_bar_err);
        add(&slopes->R_legs[3][i], &slopes->R_legs_err[3][i], R_yx_bar, R_yx_bar_err);
        add(&slopes->R_legs[4][i], &slopes->R_legs_err[4][i], R_yy_bar, R_yy_bar_err);
        add(&slopes->R_legs[5][i], &slopes->R_legs_err[5][i], R_yz_bar, R_yz_bar_err);
        add(&slopes->R_legs[6][i], &slopes->R_legs_err[6][i], R_zx_bar, R_zx_bar_err);
        add(&slopes->R_legs[7][i], &slopes->R_legs_err[7][i], R_zy_bar, R_zy_bar_err);
        add(&slopes->R_legs[8][i], &slopes->R_legs_err[8][i], R_zz_bar, R_zz_bar_err);
        add(&slopes->B_legs[0][i], &slopes->B_legs_err[0][i], B_xx_bar, B_xx_bar_err);
        add(&slopes->B_legs[1][i], &slopes->B_legs_err[1][i], B_xy_bar, B_xy_bar_err);
        add(&slopes->B_legs[2][i], &slopes->B_legs_err[2][i], B_xz_bar, B_xz_bar_err);
        add(&slopes->B_legs[3][i], &slopes->B_legs_err[3][i], B_yx_bar, B_yx_bar_err);
        add(&slopes->B_legs[4][i], &slopes->B_legs_err[4][i], B_yy_bar, B_yy_bar_err);
        add(&slopes->B_legs[5][i], &slopes->B_legs_err[5][i], B_yz_bar, B_yz_bar_err);
        add(&slopes->B_legs[6][i], &slopes->B_legs_err[6][i], B_zx_bar, B_zx_bar_err);
        add(&slopes->B_legs[7][i], &slopes->B_legs_err[7][i], B_zy_bar, B_zy_bar_err);
        add(&slopes->B_legs[8][i], &slopes->B_legs_err[8][i], B_zz_bar, B_zz_bar_err);
        add(&slopes->q_1_legs[0][i], &slopes->q_1_legs_err[0][i], -arm_x_bar, arm_x_bar_err);
        add(&slopes->q_1_legs[1][i], &slopes->q_1_legs_err[1][i], -arm_y_bar, arm_y_bar_err);
        add(&slopes->q_1_legs[2][i], &slopes->q_1_legs_err[2][i], -arm_z_bar, arm_z_bar_err);
    }
}

/* The legs and the platform of one pose: D and the platform's equations. Returns a status. `near`: with
 * the legs' code path near the joint singularity, legs having been found to be neither at it nor too
 * short. */
static int equations_of_pose(
    const stewart_exact_drive_bounds_model *model, const stewart_motions *at, const shared_terms *shared,
    int near, stewart_real D[6], platform_equations *out)
{
    int i, j;
    leg_terms leg;
    out->near = near;
    out->close = near != 0 ? out->close : 0;
    for (j = 0; j < 3; ++j) {
        out->c[j] = shared->c_force[j];
        out->c[j + 3] = shared->c_tip[j];
        out->c_own[j] = REAL(0);
        out->c_own[j + 3] = REAL(0);
    }
    for (i = 0; i < 6; ++i) {
        if (near != 0) {
            leg_of_pose_near_singularity(&model->platform, &model->leg[i], at, shared, &leg);
        } else {
            leg_of_pose(&model->platform, &model->leg[i], at, shared, &leg);
            const int status = fault_of(leg.L, leg.k3, leg.reach);
            if (status != STEWART_OK) {
                return status;
            }
            out->near = leg.k3 > STEWART_NEAR_JOINT_SINGULAR ? out->near : 1;
            out->close = leg.L > STEWART_SHORT_SHARE*leg.reach ? out->close : 1;
        }
        D[i] = leg.D;
        out->L[i] = leg.L;
        out->reach[i] = leg.reach;
        for (j = 0; j < 3; ++j) {
            out->arm[i][j] = leg.arm[j];
            out->H[j][i] = leg.H_force[j];
            out->H[j + 3][i] = i > 0 ? leg.H_moment[j] : REAL(0);
            add(&out->c[j], &out->c_own[j], leg.c_force[j], REAL(0));
            add(&out->c[j + 3], &out->c_own[j + 3], leg.c_moment[j], REAL(0));
            if (i > 0) {
                add(&out->c[j + 3], &out->c_own[j + 3], leg.arm_c[j], REAL(0));
            }
        }
    }
    return STEWART_OK;
}

/* Status of the platform's equations; `suspect` is 1 if a pivot is small. */
static int pose_status(const platform_equations *of, const shared_terms *shared, int suspect)
{
    int i, j;
    stewart_real H[6][6];
    stewart_real arm[6][3];
    if (of->close == 0 && suspect == 0) {
        return STEWART_OK;
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            H[i][j] = of->H[i][j];
        }
        for (j = 0; j < 3; ++j) {
            arm[i][j] = of->arm[i][j];
        }
    }
    return singular_status(H, arm, of->L, of->reach, largest_component(shared->q_1, REAL(0)));
}

/* x, and the inverse Y of H, by the solve of the force kernel. Returns 1 for a small pivot, else 0. */
static int solution(
    const platform_equations *of, const stewart_exact_drive_bounds_model *model, stewart_real x[6],
    stewart_real Y[6][6])
{
    int column, i, j;
    columns_pose columns_of_H;
    right_side_pose right_side;
    solution_pose found;
    for (column = 0; column < 7; ++column) {
        for (i = 0; i < 6; ++i) {
            const stewart_real unit = i < 3 ? REAL(1) : model->per_length;
            for (j = 0; j < 6; ++j) {
                columns_of_H.H[i][j] = unit*of->H[i][j];
            }
            columns_of_H.H[i][6] = REAL(0);
            columns_of_H.H[i][7] = REAL(0);
            right_side.c[i] = column < 6 ? (i == column ? unit : REAL(0)) : unit*of->c[i];
        }
        compute_two_blocks_pose(model->arm_cube, &columns_of_H, &right_side, &found);
        if (found.weak > REAL(0)) {
            compute_pivots_pose(&columns_of_H, &right_side, &found);
        }
        for (i = 0; i < 6; ++i) {
            if (column < 6) {
                Y[i][column] = found.x[i];
            } else {
                x[i] = found.x[i];
            }
        }
    }
    return found.suspect > REAL(0) ? 1 : 0;
}

/* Bounds the errors of the forces D - x: the effects of the errors of D, c, and H, the error of the
 * solution, and the error of the difference. Completes the errors of the platform's equations. */
static void bound_of_pose(
    const stewart_exact_drive_bounds_model *model, const stewart_motions *at, const stewart_real x[6],
    stewart_real Y[6][6], const stewart_real F[6], platform_equations *of, stewart_real bound[6])
{
    int i, j, k;
    shared_terms shared;
    leg_terms leg;
    force_rows rows;
    force_slopes slopes;
    stewart_real stretch[9];
    stewart_real error[LANES];
    const stewart_real R_err = rotation_error(at->R, stretch);
    for (i = 0; i < LANES; ++i) {
        error[i] = REAL(0);
        rows.Y_force[0][i] = REAL(0);
        rows.Y_force[1][i] = REAL(0);
        rows.Y_force[2][i] = REAL(0);
        rows.Y_moment[0][i] = REAL(0);
        rows.Y_moment[1][i] = REAL(0);
        rows.Y_moment[2][i] = REAL(0);
        rows.Y_arm[0][i] = REAL(0);
        rows.Y_arm[1][i] = REAL(0);
        rows.Y_arm[2][i] = REAL(0);
        rows.D_weight[i] = REAL(0);
        rows.x[i] = REAL(0);
        slopes.R_legs[0][i] = REAL(0);
        slopes.R_legs[1][i] = REAL(0);
        slopes.R_legs[2][i] = REAL(0);
        slopes.R_legs[3][i] = REAL(0);
        slopes.R_legs[4][i] = REAL(0);
        slopes.R_legs[5][i] = REAL(0);
        slopes.R_legs[6][i] = REAL(0);
        slopes.R_legs[7][i] = REAL(0);
        slopes.R_legs[8][i] = REAL(0);
        slopes.R_legs_err[0][i] = REAL(0);
        slopes.R_legs_err[1][i] = REAL(0);
        slopes.R_legs_err[2][i] = REAL(0);
        slopes.R_legs_err[3][i] = REAL(0);
        slopes.R_legs_err[4][i] = REAL(0);
        slopes.R_legs_err[5][i] = REAL(0);
        slopes.R_legs_err[6][i] = REAL(0);
        slopes.R_legs_err[7][i] = REAL(0);
        slopes.R_legs_err[8][i] = REAL(0);
        slopes.B_legs[0][i] = REAL(0);
        slopes.B_legs[1][i] = REAL(0);
        slopes.B_legs[2][i] = REAL(0);
        slopes.B_legs[3][i] = REAL(0);
        slopes.B_legs[4][i] = REAL(0);
        slopes.B_legs[5][i] = REAL(0);
        slopes.B_legs[6][i] = REAL(0);
        slopes.B_legs[7][i] = REAL(0);
        slopes.B_legs[8][i] = REAL(0);
        slopes.B_legs_err[0][i] = REAL(0);
        slopes.B_legs_err[1][i] = REAL(0);
        slopes.B_legs_err[2][i] = REAL(0);
        slopes.B_legs_err[3][i] = REAL(0);
        slopes.B_legs_err[4][i] = REAL(0);
        slopes.B_legs_err[5][i] = REAL(0);
        slopes.B_legs_err[6][i] = REAL(0);
        slopes.B_legs_err[7][i] = REAL(0);
        slopes.B_legs_err[8][i] = REAL(0);
        slopes.q_1_legs[0][i] = REAL(0);
        slopes.q_1_legs[1][i] = REAL(0);
        slopes.q_1_legs[2][i] = REAL(0);
        slopes.q_1_legs_err[0][i] = REAL(0);
        slopes.q_1_legs_err[1][i] = REAL(0);
        slopes.q_1_legs_err[2][i] = REAL(0);
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            rows.Y_force[j][i] = Y[i][j];
            rows.Y_moment[j][i] = Y[i][j + 3];
        }
    }
    shared_errors(&model->platform, at, R_err, &rows, 0, &slopes, error, &shared);
    for (j = 0; j < 3; ++j) {
        of->c_err[j] = shared.c_force_err[j];
        of->c_err[j + 3] = shared.c_tip_err[j];
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            rows.D_weight[j] = i == j ? REAL(1) : REAL(0);
            rows.x[j] = x[i];
            for (k = 0; k < 3; ++k) {
                rows.Y_arm[k][j] = i > 0 ? rows.Y_moment[k][j] : REAL(0);
            }
        }
        if (of->near != 0) {
            leg_errors_near_singularity(&model->platform, &model->leg[i], at, &shared, R_err, &rows,
                &slopes, error, &leg);
        } else {
            leg_errors(&model->platform, &model->leg[i], at, &shared, R_err, &rows, &slopes, error, &leg);
        }
        for (j = 0; j < 3; ++j) {
            of->H_err[j][i] = leg.H_force_err[j];
            of->H_err[j + 3][i] = i > 0 ? leg.H_moment_err[j] : REAL(0);
            of->c_err[j] = of->c_err[j] + leg.c_force_err[j];
            const stewart_real by_arm = i > 0 ? leg.arm_c_err[j] : REAL(0);
            of->c_err[j + 3] = of->c_err[j + 3] + leg.c_moment_err[j] + by_arm;
        }
    }
    shared_errors(&model->platform, at, R_err, &rows, 1, &slopes, error, &shared);
    for (i = 0; i < 6; ++i) {
        bound[i] = error[i] + stretch_error(at->R, stretch, R_err, &slopes, i);
    }
    solution_error(of, x, Y, bound);
    for (i = 0; i < 6; ++i) {
        bound[i] = STEWART_SLACK*(bound[i] + STEWART_UNIT*STEWART_FABS(F[i]));
        if (!(bound[i] <= STEWART_MAX)) {
            bound[i] = STEWART_INFINITY;
        }
    }
}

/* Forces, bound and reciprocal condition of one pose; the last two may be null. Returns a status. */
static int forces_of_pose(
    const stewart_exact_drive_bounds_model *model, const stewart_motions *at, stewart_real F[6],
    stewart_real bound[6], stewart_real *rcond)
{
    int i;
    shared_terms shared;
    platform_equations equations;
    stewart_real Y[6][6];
    stewart_real x[6];
    stewart_real D[6];
    stewart_real found[6];
    shared_of_pose(&model->platform, at, &shared);
    int status = equations_of_pose(model, at, &shared, 0, D, &equations);
    if (status == STEWART_OK && equations.near != 0) {
        status = equations_of_pose(model, at, &shared, 1, D, &equations);
    }
    if (status == STEWART_OK) {
        const int suspect = solution(&equations, model, x, Y);
        status = pose_status(&equations, &shared, suspect);
    }
    for (i = 0; i < 6; ++i) {
        if (status == STEWART_OK) {
            found[i] = D[i] - x[i];
            status = STEWART_FABS(found[i]) <= STEWART_MAX ? status : STEWART_NOT_FINITE;
        }
    }
    if (status != STEWART_OK) {
        return status;
    }
    for (i = 0; i < 6; ++i) {
        F[i] = found[i];
    }
    if (bound != NULL) {
        bound_of_pose(model, at, x, Y, F, &equations, bound);
    }
    if (rcond != NULL) {
        rcond[0] = reciprocal_condition(equations.H, Y, shared.q_1, model->length);
    }
    return STEWART_OK;
}

/* Returns one pose of a batch, with zeros for optional arrays that are null. */
static stewart_motions pose_at(const stewart_motions *motions, size_t pose, const stewart_real zeros[3])
{
    stewart_motions at;
    at.R = &motions->R[9U*pose];
    at.t = &motions->t[3U*pose];
    at.omega = &motions->omega[3U*pose];
    at.v = &motions->v[3U*pose];
    at.alpha = &motions->alpha[3U*pose];
    at.a = &motions->a[3U*pose];
    at.F_ext = motions->F_ext != NULL ? &motions->F_ext[3U*pose] : zeros;
    at.M_ext = motions->M_ext != NULL ? &motions->M_ext[3U*pose] : zeros;
    return at;
}

/* Returns a motion as a batch of one pose. */
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

int stewart_exact_drive_forces_bounded(
    const stewart_exact_drive_bounds_model *model, const stewart_motion *motion, stewart_real F[6],
    stewart_real bound[6], stewart_real *rcond)
{
    if (model == NULL || motion == NULL || F == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    const stewart_motions at = motion_as_arrays(motion);
    return forces_of_pose(model, &at, F, bound, rcond);
}

int stewart_exact_drive_forces_bounded_batch(
    const stewart_exact_drive_bounds_model *model, size_t count, const stewart_motions *motions,
    stewart_real *F, stewart_real *bound, stewart_real *rcond, int *status)
{
    size_t pose;
    stewart_real zeros[3] = {0, 0, 0};
    if (model == NULL || motions == NULL || F == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL || motions->alpha == NULL || motions->a == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    int result = STEWART_OK;
    for (pose = 0; pose < count; ++pose) {
        const stewart_motions at = pose_at(motions, pose, zeros);
        const int code = forces_of_pose(model, &at, &F[pose*6U], bound != NULL ? &bound[pose*6U] : NULL,
            rcond != NULL ? &rcond[pose] : NULL);
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}
