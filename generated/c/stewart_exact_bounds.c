/* stewart_exact_bounds.c: see stewart_exact_bounds.h.
 *
 * Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * Of each quantity x the code below may keep
 *     x_err, which bounds its error;
 *     x_own, which bounds what of it comes from computing x, the errors of what x is made of apart;
 *     x_max = |x| + x_err, which bounds the size of x and of its true value;
 *     x_bar, the slope of an actuator force along x, with all that is made of x.
 * Forward goes x_err, which has to be taken for the worst at every step; it is coarse, and it serves to bound
 * the slopes. Backward go these, and the force errs by no more than all x_own, each times its slope at its
 * largest: the mean value theorem, over the segment from the computed to the exact values.
 */
#include "stewart_exact_bounds.h"

#include <math.h>

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

/* A length, sine or pivot below this many rounding units of its terms is rounding error and nothing else. */
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

#define STEWART_INFINITY ((stewart_real)INFINITY)

/* Half an epsilon is the largest relative error of an operation. A 64th more makes up for what the bounds
 * lose by their own roundings and by sizes that are rounded themselves, a few thousand operations deep. */
#define STEWART_UNIT (STEWART_EPSILON * (stewart_real)0.5078125)
#define STEWART_SLACK ((stewart_real)1.015625)

/* In float the solve takes moments over a length: 21 multiplications a pose more. Otherwise the pivots of a
 * machine of millimetres would be chosen among its forces alone, those of a large one among its moments.
 * -DSTEWART_UNSCALED: float without it. -DSTEWART_SCALED: any arithmetic with it. */
#if defined(STEWART_FLOAT) && !defined(STEWART_UNSCALED) && !defined(STEWART_SCALED)
#define STEWART_SCALED
#endif

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

/* A lower limit of the size of what `value` stands for; 0, and so no bound, where half of it may be wrong. */
static stewart_real least(stewart_real value, stewart_real error)
{
    const stewart_real positive = STEWART_FABS(value);
    return error <= STEWART_HALF * positive ? positive - error : 0;
}

/* Of a square root whose argument errs by `error`: |sqrt(a) - r| <= error / (2 r - error / r), r = root. */
static stewart_real root_error(stewart_real root, stewart_real error)
{
    return error / least(2 * root, error / root) + STEWART_UNIT * root;
}

/* Of inverse = 1 / of, where `of` errs by `error`. */
static stewart_real reciprocal_error(stewart_real inverse, stewart_real of, stewart_real error)
{
    const stewart_real positive = STEWART_FABS(inverse);
    return positive * (error / least(of, error)) + STEWART_UNIT * positive;
}

/* Adds a term that errs to a sum that errs. */
static void add(stewart_real *sum, stewart_real *sum_err, stewart_real term, stewart_real term_err)
{
    *sum = *sum + term;
    *sum_err = *sum_err + term_err + STEWART_UNIT * STEWART_FABS(*sum);
}

/* Bounds the entries of R less the rotation nearest to it, by the largest distance of a singular value from
 * 1: half of |R^T R - 1| in the norm of row sums, with a 64th more for the terms of higher order. */
static stewart_real rotation_error(const stewart_real R[9])
{
    stewart_real worst = 0;
    int i, j, k;
    for (i = 0; i < 3; ++i) {
        stewart_real row = 0;
        for (j = 0; j < 3; ++j) {
            stewart_real sum = 0, sizes = 0;
            for (k = 0; k < 3; ++k) {
                const stewart_real product = R[3 * k + i] * R[3 * k + j];
                sum = sum + product;
                sizes = sizes + STEWART_FABS(product) + STEWART_FABS(sum);
            }
            sum = i == j ? sum - 1 : sum;
            row = row + STEWART_FABS(sum) + STEWART_UNIT * (sizes + STEWART_FABS(sum));
        }
        worst = row > worst ? row : worst;
    }
    return worst <= (stewart_real)0.0078125 ? STEWART_HALF * STEWART_SLACK * worst : STEWART_INFINITY;
}

/* What a leg adds to the platform, and the sum of it. */
typedef struct {
    stewart_real M_add, M_add_err;
    stewart_real h_add[3], h_add_err[3];
    stewart_real J_add[6], J_add_err[6];
    stewart_real C_add, C_add_err;
} added_terms;

/* What a pose has for all legs. */
typedef struct {
    stewart_real B[9], B_err[9];
    stewart_real t_1[3], t_1_err[3];
    stewart_real c_force[3], c_force_err[3];
    stewart_real c_moment[3], c_moment_err[3];
} shared_terms;

/* What a leg gives to the platform's equations. */
typedef struct {
    stewart_real D;
    stewart_real H_force[3], H_force_err[3];
    stewart_real H_moment[3], H_moment_err[3];
    stewart_real c_force[3], c_force_err[3];
    stewart_real c_moment[3], c_moment_err[3];
    int status;
} leg_terms;

/* The platform's equations H x = c, moments about base point 1; c_own: what the sums in c round away. */
typedef struct {
    stewart_real H[6][6], H_err[6][6];
    stewart_real c[6], c_err[6], c_own[6];
} platform_equations;

/* How a force hangs on D, on c and on the column of H of one leg: D_weight D - Y (c - H x). */
typedef struct {
    stewart_real Y_force[3], Y_moment[3]; /* its row of the inverse of H */
    stewart_real D_weight, x;
} force_row;

/* Slope of a force along what the pose has for all legs, as far as it goes through the legs. */
typedef struct {
    stewart_real R_legs[9], R_legs_err[9];
    stewart_real B_legs[9], B_legs_err[9];
    stewart_real t_1_legs[3], t_1_legs_err[3];
} slopes_of_legs;

/* Constants of one leg, and what it adds to the platform. */
static void prepare_leg(
    const stewart_robot *robot, const stewart_leg *leg, stewart_exact_bounds_leg *out, added_terms *sum)
{
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = leg->k[0], k_y = leg->k[1], k_z = leg->k[2];
    const stewart_real m_d = leg->m_d;
    const stewart_real r_d0_x = leg->r_d0[0], r_d0_y = leg->r_d0[1], r_d0_z = leg->r_d0[2];
    const stewart_real I_d0_xx = leg->I_d0[0], I_d0_xy = leg->I_d0[1], I_d0_xz = leg->I_d0[2],
        I_d0_yy = leg->I_d0[3], I_d0_yz = leg->I_d0[4], I_d0_zz = leg->I_d0[5];
    const stewart_real m_u = leg->m_u;
    const stewart_real r_u0_x = leg->r_u0[0], r_u0_y = leg->r_u0[1], r_u0_z = leg->r_u0[2];
    const stewart_real I_u0_xx = leg->I_u0[0], I_u0_xy = leg->I_u0[1], I_u0_xz = leg->I_u0[2],
        I_u0_yy = leg->I_u0[3], I_u0_yz = leg->I_u0[4], I_u0_zz = leg->I_u0[5];
    const stewart_real C_u = leg->C_u;
    const stewart_real C_p = leg->C_p;
    const stewart_real C_s = leg->C_s;
    const stewart_real b_1_x = robot->leg[0].b[0], b_1_y = robot->leg[0].b[1],
        b_1_z = robot->leg[0].b[2];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real p_y_max = STEWART_FABS(p_y), p_z_max = STEWART_FABS(p_z);
    const stewart_real k_x_max = STEWART_FABS(k_x), k_y_max = STEWART_FABS(k_y),
        k_z_max = STEWART_FABS(k_z);
    const stewart_real m_d_max = STEWART_FABS(m_d);
    const stewart_real r_d0_y_max = STEWART_FABS(r_d0_y), r_d0_z_max = STEWART_FABS(r_d0_z);
    const stewart_real I_d0_xx_max = STEWART_FABS(I_d0_xx), I_d0_xy_max = STEWART_FABS(I_d0_xy),
        I_d0_xz_max = STEWART_FABS(I_d0_xz), I_d0_yy_max = STEWART_FABS(I_d0_yy),
        I_d0_yz_max = STEWART_FABS(I_d0_yz), I_d0_zz_max = STEWART_FABS(I_d0_zz);
    const stewart_real m_u_max = STEWART_FABS(m_u);
    const stewart_real r_u0_y_max = STEWART_FABS(r_u0_y), r_u0_z_max = STEWART_FABS(r_u0_z);
    const stewart_real I_u0_xx_max = STEWART_FABS(I_u0_xx), I_u0_xy_max = STEWART_FABS(I_u0_xy),
        I_u0_xz_max = STEWART_FABS(I_u0_xz), I_u0_yy_max = STEWART_FABS(I_u0_yy),
        I_u0_yz_max = STEWART_FABS(I_u0_yz), I_u0_zz_max = STEWART_FABS(I_u0_zz);
    const stewart_real g_x_max = STEWART_FABS(g_x), g_y_max = STEWART_FABS(g_y),
        g_z_max = STEWART_FABS(g_z);
    const stewart_real k_size = STEWART_SQRT(k_x*k_x + k_y*k_y + k_z*k_z);
    const stewart_real k_size_err = root_error(k_size, REAL(0) + STEWART_UNIT*(REAL(3)*k_x_max*k_x_max
        + REAL(3)*k_y_max*k_y_max + REAL(3)*k_z_max*k_z_max));
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
    const stewart_real J_xx_err = c5_err*m_d_max + c6_err*m_d_max + c7_err*m_u_max + c8_err*m_u_max
        + STEWART_UNIT*(REAL(2)*I_d0_xx_max + REAL(2)*I_u0_xx_max + REAL(4)*m_d_max*(c5_max + c6_max)
        + REAL(4)*m_u_max*(c7_max + c8_max) + STEWART_FABS(J_xx));
    const stewart_real J_xy = I_d0_xy + I_u0_xy - c1*r_u0_y - c3*r_d0_y;
    const stewart_real J_xy_err = c1_err*r_u0_y_max + c3_err*r_d0_y_max + STEWART_UNIT*(REAL(2)*I_d0_xy_max
        + REAL(2)*I_u0_xy_max + REAL(3)*c1_max*r_u0_y_max + REAL(3)*c3_max*r_d0_y_max + STEWART_FABS(J_xy));
    const stewart_real J_xz = I_d0_xz + I_u0_xz - c1*r_u0_z - c3*r_d0_z;
    const stewart_real J_xz_err = c1_err*r_u0_z_max + c3_err*r_d0_z_max + STEWART_UNIT*(REAL(2)*I_d0_xz_max
        + REAL(2)*I_u0_xz_max + REAL(3)*c1_max*r_u0_z_max + REAL(3)*c3_max*r_d0_z_max + STEWART_FABS(J_xz));
    const stewart_real c9 = r_d0_x*r_d0_x;
    const stewart_real c9_err = STEWART_UNIT*STEWART_FABS(c9);
    const stewart_real c9_max = STEWART_FABS(c9) + c9_err;
    const stewart_real c10 = r_u0_x*r_u0_x;
    const stewart_real c10_err = STEWART_UNIT*STEWART_FABS(c10);
    const stewart_real c10_max = STEWART_FABS(c10) + c10_err;
    const stewart_real J_yy = I_d0_yy + I_u0_yy + m_d*(c6 + c9) + m_u*(c10 + c8);
    const stewart_real J_yy_err = c10_err*m_u_max + c6_err*m_d_max + c8_err*m_u_max + c9_err*m_d_max
        + STEWART_UNIT*(REAL(2)*I_d0_yy_max + REAL(2)*I_u0_yy_max + REAL(4)*m_d_max*(c6_max + c9_max)
        + REAL(4)*m_u_max*(c10_max + c8_max) + STEWART_FABS(J_yy));
    const stewart_real J_yz = I_d0_yz + I_u0_yz - c2*r_u0_z - c4*r_d0_z;
    const stewart_real J_yz_err = c2_err*r_u0_z_max + c4_err*r_d0_z_max + STEWART_UNIT*(REAL(2)*I_d0_yz_max
        + REAL(2)*I_u0_yz_max + REAL(3)*c2_max*r_u0_z_max + REAL(3)*c4_max*r_d0_z_max + STEWART_FABS(J_yz));
    const stewart_real J_zz = I_d0_zz + I_u0_zz + m_d*(c5 + c9) + m_u*(c10 + c7);
    const stewart_real J_zz_err = c10_err*m_u_max + c5_err*m_d_max + c7_err*m_u_max + c9_err*m_d_max
        + STEWART_UNIT*(REAL(2)*I_d0_zz_max + REAL(2)*I_u0_zz_max + REAL(4)*m_d_max*(c5_max + c9_max)
        + REAL(4)*m_u_max*(c10_max + c7_max) + STEWART_FABS(J_zz));
    const stewart_real c11 = m_u*p_x;
    const stewart_real c11_err = STEWART_UNIT*STEWART_FABS(c11);
    const stewart_real c12 = m_u*p_y;
    const stewart_real c12_err = STEWART_UNIT*STEWART_FABS(c12);
    const stewart_real c13 = p_y*p_y;
    const stewart_real c13_err = STEWART_UNIT*STEWART_FABS(c13);
    const stewart_real c13_max = STEWART_FABS(c13) + c13_err;
    const stewart_real c14 = p_z*p_z;
    const stewart_real c14_err = STEWART_UNIT*STEWART_FABS(c14);
    const stewart_real c14_max = STEWART_FABS(c14) + c14_err;
    const stewart_real c15 = p_x*p_x;
    const stewart_real c15_err = STEWART_UNIT*STEWART_FABS(c15);
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
    /* gravity along the fixed axis */
    const stewart_real g_k = g_x*k_unit_x + g_y*k_unit_y + g_z*k_unit_z;
    const stewart_real g_k_err = g_x_max*k_unit_x_err + g_y_max*k_unit_y_err + g_z_max*k_unit_z_err
        + STEWART_UNIT*(REAL(2)*g_x_max*k_unit_x_max + REAL(2)*g_y_max*k_unit_y_max
        + REAL(2)*g_z_max*k_unit_z_max + STEWART_FABS(g_k));
    /* g x k, base frame */
    const stewart_real g_x_k_x = g_y*k_unit_z - g_z*k_unit_y;
    const stewart_real g_x_k_x_err = g_y_max*k_unit_z_err + g_z_max*k_unit_y_err
        + STEWART_UNIT*(g_y_max*k_unit_z_max + g_z_max*k_unit_y_max + STEWART_FABS(g_x_k_x));
    const stewart_real g_x_k_y = g_z*k_unit_x - g_x*k_unit_z;
    const stewart_real g_x_k_y_err = g_x_max*k_unit_z_err + g_z_max*k_unit_x_err
        + STEWART_UNIT*(g_x_max*k_unit_z_max + g_z_max*k_unit_x_max + STEWART_FABS(g_x_k_y));
    const stewart_real g_x_k_z = g_x*k_unit_y - g_y*k_unit_x;
    const stewart_real g_x_k_z_err = g_x_max*k_unit_y_err + g_y_max*k_unit_x_err
        + STEWART_UNIT*(g_x_max*k_unit_y_max + g_y_max*k_unit_x_max + STEWART_FABS(g_x_k_z));
    /* C_u + C_s */
    const stewart_real C_us = C_s + C_u;
    const stewart_real C_us_err = STEWART_UNIT*STEWART_FABS(C_us);
    /* base point from base point 1, base frame */
    const stewart_real r_x = b_x - b_1_x;
    const stewart_real r_x_err = STEWART_UNIT*STEWART_FABS(r_x);
    const stewart_real r_y = b_y - b_1_y;
    const stewart_real r_y_err = STEWART_UNIT*STEWART_FABS(r_y);
    const stewart_real r_z = b_z - b_1_z;
    const stewart_real r_z_err = STEWART_UNIT*STEWART_FABS(r_z);
    /* its first moment, platform frame */
    const stewart_real h_add_z = m_u*p_z;
    const stewart_real h_add_z_err = STEWART_UNIT*STEWART_FABS(h_add_z);
    /* its inertia about the reference point, platform frame */
    const stewart_real J_add_xx = m_u*(c13 + c14);
    const stewart_real J_add_xx_err = c13_err*m_u_max + c14_err*m_u_max + STEWART_UNIT*(m_u_max*(c13_max
        + c14_max) + STEWART_FABS(J_add_xx));
    const stewart_real J_add_xy = -c11*p_y;
    const stewart_real J_add_xy_err = c11_err*p_y_max + STEWART_UNIT*STEWART_FABS(J_add_xy);
    const stewart_real J_add_xz = -c11*p_z;
    const stewart_real J_add_xz_err = c11_err*p_z_max + STEWART_UNIT*STEWART_FABS(J_add_xz);
    const stewart_real J_add_yy = m_u*(c14 + c15);
    const stewart_real J_add_yy_err = c14_err*m_u_max + c15_err*m_u_max + STEWART_UNIT*(m_u_max*(c14_max
        + c15_max) + STEWART_FABS(J_add_yy));
    const stewart_real J_add_yz = -c12*p_z;
    const stewart_real J_add_yz_err = c12_err*p_z_max + STEWART_UNIT*STEWART_FABS(J_add_yz);
    const stewart_real J_add_zz = m_u*(c13 + c15);
    const stewart_real J_add_zz_err = c13_err*m_u_max + c15_err*m_u_max + STEWART_UNIT*(m_u_max*(c13_max
        + c15_max) + STEWART_FABS(J_add_zz));
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
    out->r[0] = r_x;
    out->r_err[0] = r_x_err;
    out->r[1] = r_y;
    out->r_err[1] = r_y_err;
    out->r[2] = r_z;
    out->r_err[2] = r_z_err;
    sum->M_add = m_u;
    sum->M_add_err = REAL(0);
    sum->h_add[0] = c11;
    sum->h_add_err[0] = c11_err;
    sum->h_add[1] = c12;
    sum->h_add_err[1] = c12_err;
    sum->h_add[2] = h_add_z;
    sum->h_add_err[2] = h_add_z_err;
    sum->J_add[0] = J_add_xx;
    sum->J_add_err[0] = J_add_xx_err;
    sum->J_add[1] = J_add_xy;
    sum->J_add_err[1] = J_add_xy_err;
    sum->J_add[2] = J_add_xz;
    sum->J_add_err[2] = J_add_xz_err;
    sum->J_add[3] = J_add_yy;
    sum->J_add_err[3] = J_add_yy_err;
    sum->J_add[4] = J_add_yz;
    sum->J_add_err[4] = J_add_yz_err;
    sum->J_add[5] = J_add_zz;
    sum->J_add_err[5] = J_add_zz_err;
    sum->C_add = C_s;
    sum->C_add_err = REAL(0);
}

/* Constants of the platform. */
static void prepare_platform(
    const stewart_robot *robot, const added_terms *sum, stewart_exact_bounds_platform *out)
{
    const stewart_real M = robot->M;
    const stewart_real R_0_x = robot->R_0[0], R_0_y = robot->R_0[1], R_0_z = robot->R_0[2];
    const stewart_real I_p_xx = robot->I_p[0], I_p_xy = robot->I_p[1], I_p_xz = robot->I_p[2],
        I_p_yy = robot->I_p[3], I_p_yz = robot->I_p[4], I_p_zz = robot->I_p[5];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real b_1_x = robot->leg[0].b[0], b_1_y = robot->leg[0].b[1],
        b_1_z = robot->leg[0].b[2];
    const stewart_real M_add = sum->M_add;
    const stewart_real M_add_err = sum->M_add_err;
    const stewart_real h_add_x = sum->h_add[0], h_add_y = sum->h_add[1], h_add_z = sum->h_add[2];
    const stewart_real h_add_x_err = sum->h_add_err[0], h_add_y_err = sum->h_add_err[1],
        h_add_z_err = sum->h_add_err[2];
    const stewart_real J_add_xx = sum->J_add[0], J_add_xy = sum->J_add[1], J_add_xz = sum->J_add[2],
        J_add_yy = sum->J_add[3], J_add_yz = sum->J_add[4], J_add_zz = sum->J_add[5];
    const stewart_real J_add_xx_err = sum->J_add_err[0], J_add_xy_err = sum->J_add_err[1],
        J_add_xz_err = sum->J_add_err[2], J_add_yy_err = sum->J_add_err[3],
        J_add_yz_err = sum->J_add_err[4], J_add_zz_err = sum->J_add_err[5];
    const stewart_real C_add = sum->C_add;
    const stewart_real C_add_err = sum->C_add_err;
    const stewart_real M_max = STEWART_FABS(M);
    const stewart_real R_0_y_max = STEWART_FABS(R_0_y), R_0_z_max = STEWART_FABS(R_0_z);
    const stewart_real I_p_xx_max = STEWART_FABS(I_p_xx), I_p_xy_max = STEWART_FABS(I_p_xy),
        I_p_xz_max = STEWART_FABS(I_p_xz), I_p_yy_max = STEWART_FABS(I_p_yy),
        I_p_yz_max = STEWART_FABS(I_p_yz), I_p_zz_max = STEWART_FABS(I_p_zz);
    const stewart_real J_add_xx_max = STEWART_FABS(J_add_xx) + J_add_xx_err,
        J_add_xy_max = STEWART_FABS(J_add_xy) + J_add_xy_err,
        J_add_xz_max = STEWART_FABS(J_add_xz) + J_add_xz_err,
        J_add_yy_max = STEWART_FABS(J_add_yy) + J_add_yy_err,
        J_add_yz_max = STEWART_FABS(J_add_yz) + J_add_yz_err,
        J_add_zz_max = STEWART_FABS(J_add_zz) + J_add_zz_err;
    const stewart_real c1 = R_0_y*R_0_y;
    const stewart_real c1_err = STEWART_UNIT*STEWART_FABS(c1);
    const stewart_real c1_max = STEWART_FABS(c1) + c1_err;
    const stewart_real c2 = R_0_z*R_0_z;
    const stewart_real c2_err = STEWART_UNIT*STEWART_FABS(c2);
    const stewart_real c2_max = STEWART_FABS(c2) + c2_err;
    const stewart_real J_P_xx = I_p_xx + J_add_xx + M*(c1 + c2);
    const stewart_real J_P_xx_err = J_add_xx_err + M_max*c1_err + M_max*c2_err + STEWART_UNIT*(I_p_xx_max
        + J_add_xx_max + REAL(3)*M_max*(c1_max + c2_max) + STEWART_FABS(J_P_xx));
    const stewart_real c3 = M*R_0_x;
    const stewart_real c3_err = STEWART_UNIT*STEWART_FABS(c3);
    const stewart_real c3_max = STEWART_FABS(c3) + c3_err;
    const stewart_real J_P_xy = I_p_xy + J_add_xy - R_0_y*c3;
    const stewart_real J_P_xy_err = J_add_xy_err + R_0_y_max*c3_err + STEWART_UNIT*(I_p_xy_max
        + J_add_xy_max + REAL(2)*R_0_y_max*c3_max + STEWART_FABS(J_P_xy));
    const stewart_real J_P_xz = I_p_xz + J_add_xz - R_0_z*c3;
    const stewart_real J_P_xz_err = J_add_xz_err + R_0_z_max*c3_err + STEWART_UNIT*(I_p_xz_max
        + J_add_xz_max + REAL(2)*R_0_z_max*c3_max + STEWART_FABS(J_P_xz));
    const stewart_real c4 = R_0_x*R_0_x;
    const stewart_real c4_err = STEWART_UNIT*STEWART_FABS(c4);
    const stewart_real c4_max = STEWART_FABS(c4) + c4_err;
    const stewart_real J_P_yy = I_p_yy + J_add_yy + M*(c2 + c4);
    const stewart_real J_P_yy_err = J_add_yy_err + M_max*c2_err + M_max*c4_err + STEWART_UNIT*(I_p_yy_max
        + J_add_yy_max + REAL(3)*M_max*(c2_max + c4_max) + STEWART_FABS(J_P_yy));
    const stewart_real c5 = M*R_0_y;
    const stewart_real c5_err = STEWART_UNIT*STEWART_FABS(c5);
    const stewart_real c5_max = STEWART_FABS(c5) + c5_err;
    const stewart_real J_P_yz = I_p_yz + J_add_yz - R_0_z*c5;
    const stewart_real J_P_yz_err = J_add_yz_err + R_0_z_max*c5_err + STEWART_UNIT*(I_p_yz_max
        + J_add_yz_max + REAL(2)*R_0_z_max*c5_max + STEWART_FABS(J_P_yz));
    const stewart_real J_P_zz = I_p_zz + J_add_zz + M*(c1 + c4);
    const stewart_real J_P_zz_err = J_add_zz_err + M_max*c1_err + M_max*c4_err + STEWART_UNIT*(I_p_zz_max
        + J_add_zz_max + REAL(3)*M_max*(c1_max + c4_max) + STEWART_FABS(J_P_zz));
    /* mass of the platform with the upper parts */
    const stewart_real M_P = M + M_add;
    const stewart_real M_P_err = M_add_err + STEWART_UNIT*STEWART_FABS(M_P);
    /* its first moment, platform frame */
    const stewart_real h_P_x = c3 + h_add_x;
    const stewart_real h_P_x_err = c3_err + h_add_x_err + STEWART_UNIT*STEWART_FABS(h_P_x);
    const stewart_real h_P_y = c5 + h_add_y;
    const stewart_real h_P_y_err = c5_err + h_add_y_err + STEWART_UNIT*STEWART_FABS(h_P_y);
    const stewart_real h_P_z = M*R_0_z + h_add_z;
    const stewart_real h_P_z_err = h_add_z_err + STEWART_UNIT*(M_max*R_0_z_max + STEWART_FABS(h_P_z));
    /* J_P_zz - J_P_yy, J_P_xx - J_P_zz, J_P_yy - J_P_xx */
    const stewart_real dJ_P_x = J_P_zz - J_P_yy;
    const stewart_real dJ_P_x_err = J_P_yy_err + J_P_zz_err + STEWART_UNIT*STEWART_FABS(dJ_P_x);
    const stewart_real dJ_P_y = J_P_xx - J_P_zz;
    const stewart_real dJ_P_y_err = J_P_xx_err + J_P_zz_err + STEWART_UNIT*STEWART_FABS(dJ_P_y);
    const stewart_real dJ_P_z = J_P_yy - J_P_xx;
    const stewart_real dJ_P_z_err = J_P_xx_err + J_P_yy_err + STEWART_UNIT*STEWART_FABS(dJ_P_z);
    out->M_P = M_P;
    out->M_P_err = M_P_err;
    out->h_P[0] = h_P_x;
    out->h_P_err[0] = h_P_x_err;
    out->h_P[1] = h_P_y;
    out->h_P_err[1] = h_P_y_err;
    out->h_P[2] = h_P_z;
    out->h_P_err[2] = h_P_z_err;
    out->J_P[0] = J_P_xx;
    out->J_P_err[0] = J_P_xx_err;
    out->J_P[1] = J_P_xy;
    out->J_P_err[1] = J_P_xy_err;
    out->J_P[2] = J_P_xz;
    out->J_P_err[2] = J_P_xz_err;
    out->J_P[3] = J_P_yy;
    out->J_P_err[3] = J_P_yy_err;
    out->J_P[4] = J_P_yz;
    out->J_P_err[4] = J_P_yz_err;
    out->J_P[5] = J_P_zz;
    out->J_P_err[5] = J_P_zz_err;
    out->dJ_P[0] = dJ_P_x;
    out->dJ_P_err[0] = dJ_P_x_err;
    out->dJ_P[1] = dJ_P_y;
    out->dJ_P_err[1] = dJ_P_y_err;
    out->dJ_P[2] = dJ_P_z;
    out->dJ_P_err[2] = dJ_P_z_err;
    out->C_P = C_add;
    out->C_P_err = C_add_err;
    out->g[0] = g_x;
    out->g[1] = g_y;
    out->g[2] = g_z;
    out->b_1[0] = b_1_x;
    out->b_1[1] = b_1_y;
    out->b_1[2] = b_1_z;
}

#if defined(STEWART_SCALED)
/* The least power of two, down to 2^-100 and up to 2^100, that no coordinate of the platform points exceeds;
 * 1 if all of them are zero. */
static stewart_real unit_of_length(const stewart_exact_bounds_model *model)
{
    stewart_real largest = REAL(0), unit = REAL(1);
    int i, j;
    for (j = 0; j < 3; ++j) {
        for (i = 0; i < 6; ++i) {
            largest = STEWART_LARGER(STEWART_FABS(model->leg[i].p[j]), largest);
        }
    }
    for (i = 0; i < 100 && unit < largest; ++i) {
        unit = REAL(2) * unit;
    }
    for (i = 0; i < 100 && largest > REAL(0) && STEWART_HALF * unit >= largest; ++i) {
        unit = STEWART_HALF * unit;
    }
    return unit;
}
#endif

int stewart_exact_bounds_prepare(const stewart_robot *robot, stewart_exact_bounds_model *model)
{
    stewart_exact_bounds_model made;
    added_terms found, sum;
    stewart_real squares = 0;
    int i, j;
    if (!robot || !model) {
        return STEWART_BAD_ARGUMENT;
    }
    sum.M_add = 0;
    sum.M_add_err = 0;
    sum.h_add[0] = 0;
    sum.h_add[1] = 0;
    sum.h_add[2] = 0;
    sum.h_add_err[0] = 0;
    sum.h_add_err[1] = 0;
    sum.h_add_err[2] = 0;
    sum.J_add[0] = 0;
    sum.J_add[1] = 0;
    sum.J_add[2] = 0;
    sum.J_add[3] = 0;
    sum.J_add[4] = 0;
    sum.J_add[5] = 0;
    sum.J_add_err[0] = 0;
    sum.J_add_err[1] = 0;
    sum.J_add_err[2] = 0;
    sum.J_add_err[3] = 0;
    sum.J_add_err[4] = 0;
    sum.J_add_err[5] = 0;
    sum.C_add = 0;
    sum.C_add_err = 0;
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
            squares = squares + robot->leg[i].p[j] * robot->leg[i].p[j];
        }
    }
    prepare_platform(robot, &sum, &made.platform);
    made.length = STEWART_SQRT(squares / 6);
    made.per_length = 1;
#if defined(STEWART_SCALED)
    made.per_length = 1 / unit_of_length(&made);
#endif
    if (!is_finite((const stewart_real *)&made, (int)(sizeof made / sizeof made.length))) {
        return STEWART_NOT_FINITE;
    }
    *model = made;
    return STEWART_OK;
}

/* What one pose has for all legs. */
static void shared_of_pose(
    const stewart_exact_bounds_platform *platform, const stewart_motions *at, shared_terms *out)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real M_ext_x = at->M_ext[0], M_ext_y = at->M_ext[1], M_ext_z = at->M_ext[2];
    const stewart_real M_P = platform->M_P;
    const stewart_real h_P_x = platform->h_P[0], h_P_y = platform->h_P[1], h_P_z = platform->h_P[2];
    const stewart_real J_P_xx = platform->J_P[0], J_P_xy = platform->J_P[1], J_P_xz = platform->J_P[2],
        J_P_yy = platform->J_P[3], J_P_yz = platform->J_P[4], J_P_zz = platform->J_P[5];
    const stewart_real dJ_P_x = platform->dJ_P[0], dJ_P_y = platform->dJ_P[1],
        dJ_P_z = platform->dJ_P[2];
    const stewart_real C_P = platform->C_P;
    const stewart_real g_x = platform->g[0], g_y = platform->g[1], g_z = platform->g[2];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real b_1_x = platform->b_1[0], b_1_y = platform->b_1[1], b_1_z = platform->b_1[2];
    /* products of omega */
    const stewart_real omega_xx = omega_x*omega_x;
    const stewart_real omega_xy = omega_x*omega_y;
    const stewart_real omega_xz = omega_x*omega_z;
    const stewart_real omega_yy = omega_y*omega_y;
    const stewart_real omega_yz = omega_y*omega_z;
    const stewart_real omega_zz = omega_z*omega_z;
    /* (7) S_ddot = B q + a */
    const stewart_real B_xx = -omega_yy - omega_zz;
    const stewart_real B_xy = omega_xy - alpha_z;
    const stewart_real B_xz = alpha_y + omega_xz;
    const stewart_real B_yx = alpha_z + omega_xy;
    const stewart_real B_yy = -omega_xx - omega_zz;
    const stewart_real B_yz = omega_yz - alpha_x;
    const stewart_real B_zx = omega_xz - alpha_y;
    const stewart_real B_zy = alpha_x + omega_yz;
    const stewart_real B_zz = -omega_xx - omega_yy;
    /* (30) first moment of the platform, base frame */
    const stewart_real h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z;
    const stewart_real h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z;
    const stewart_real h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z;
    /* (33) g - a */
    const stewart_real fall_x = g_x - a_x;
    const stewart_real fall_y = g_y - a_y;
    const stewart_real fall_z = g_z - a_z;
    /* angular velocity, platform frame */
    const stewart_real omega_P_x = R_xx*omega_x + R_yx*omega_y + R_zx*omega_z;
    const stewart_real omega_P_y = R_xy*omega_x + R_yy*omega_y + R_zy*omega_z;
    const stewart_real omega_P_z = R_xz*omega_x + R_yz*omega_y + R_zz*omega_z;
    /* angular acceleration, platform frame */
    const stewart_real alpha_P_x = R_xx*alpha_x + R_yx*alpha_y + R_zx*alpha_z;
    const stewart_real alpha_P_y = R_xy*alpha_x + R_yy*alpha_y + R_zy*alpha_z;
    const stewart_real alpha_P_z = R_xz*alpha_x + R_yz*alpha_y + R_zz*alpha_z;
    const stewart_real P_xy = omega_P_x*omega_P_y;
    const stewart_real P_xz = omega_P_x*omega_P_z;
    const stewart_real P_yz = omega_P_y*omega_P_z;
    const stewart_real P_xx = omega_P_x*omega_P_x;
    const stewart_real P_yy = omega_P_y*omega_P_y;
    const stewart_real P_zz = omega_P_z*omega_P_z;
    /* (34) external moment less I alpha + omega x I omega, platform frame */
    const stewart_real M_P_load_x = M_ext_x - J_P_xx*alpha_P_x - J_P_xy*(alpha_P_y - P_xz) - J_P_xz*(P_xy
        + alpha_P_z) - J_P_yz*(P_yy - P_zz) - P_yz*dJ_P_x;
    const stewart_real M_P_load_y = M_ext_y - J_P_xy*(P_yz + alpha_P_x) - J_P_xz*(P_zz - P_xx)
        - J_P_yy*alpha_P_y - J_P_yz*(alpha_P_z - P_xy) - P_xz*dJ_P_y;
    const stewart_real M_P_load_z = M_ext_z - J_P_xy*(P_xx - P_yy) - J_P_xz*(alpha_P_x - P_yz)
        - J_P_yz*(P_xz + alpha_P_y) - J_P_zz*alpha_P_z - P_xy*dJ_P_z;
    /* reference point from base point 1, base frame */
    const stewart_real t_1_x = t_x - b_1_x;
    const stewart_real t_1_y = t_y - b_1_y;
    const stewart_real t_1_z = t_z - b_1_z;
    /* (33) the platform's part of c, force and moment */
    const stewart_real load_x = F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz + M_P*fall_x - B_xx*h_base_x
        - B_xy*h_base_y - B_xz*h_base_z;
    const stewart_real load_y = F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz + M_P*fall_y - B_yx*h_base_x
        - B_yy*h_base_y - B_yz*h_base_z;
    const stewart_real load_z = F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz + M_P*fall_z - B_zx*h_base_x
        - B_zy*h_base_y - B_zz*h_base_z;
    /* part of c, moment rows, base frame */
    const stewart_real c_moment_x = M_P_load_x*R_xx + M_P_load_y*R_xy + M_P_load_z*R_xz + fall_z*h_base_y
        + load_z*t_1_y - C_P*omega_x - fall_y*h_base_z - load_y*t_1_z;
    const stewart_real c_moment_y = M_P_load_x*R_yx + M_P_load_y*R_yy + M_P_load_z*R_yz + fall_x*h_base_z
        + load_x*t_1_z - C_P*omega_y - fall_z*h_base_x - load_z*t_1_x;
    const stewart_real c_moment_z = M_P_load_x*R_zx + M_P_load_y*R_zy + M_P_load_z*R_zz + fall_y*h_base_x
        + load_y*t_1_x - C_P*omega_z - fall_x*h_base_y - load_x*t_1_y;
    out->B[0] = B_xx;
    out->B[1] = B_xy;
    out->B[2] = B_xz;
    out->B[3] = B_yx;
    out->B[4] = B_yy;
    out->B[5] = B_yz;
    out->B[6] = B_zx;
    out->B[7] = B_zy;
    out->B[8] = B_zz;
    out->t_1[0] = t_1_x;
    out->t_1[1] = t_1_y;
    out->t_1[2] = t_1_z;
    out->c_force[0] = load_x;
    out->c_force[1] = load_y;
    out->c_force[2] = load_z;
    out->c_moment[0] = c_moment_x;
    out->c_moment[1] = c_moment_y;
    out->c_moment[2] = c_moment_z;
}

/* S = S_1 - r is known to within rounding of its largest term. */
static int leg_status(stewart_real L, stewart_real k3, const stewart_real terms[9])
{
    stewart_real reach = 0;
    int i;
    for (i = 0; i < 9; ++i) {
        reach = STEWART_FABS(terms[i]) > reach ? STEWART_FABS(terms[i]) : reach;
    }
    if (!(L <= STEWART_MAX)) {
        return STEWART_NOT_FINITE;
    }
    if (!(L > STEWART_ROUNDING * reach && L > STEWART_SHORTEST)) {
        return STEWART_SHORT_LEG;
    }
    return k3 > STEWART_POLE_SINE ? STEWART_OK : STEWART_POLE;
}

/* One leg in joint coordinates: D, its column of H and its part of c. */
static void leg_of_pose(
    const stewart_exact_bounds_platform *platform, const stewart_exact_bounds_leg *leg,
    const stewart_motions *at, const shared_terms *shared, leg_terms *out)
{
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = leg->k[0], k_y = leg->k[1], k_z = leg->k[2];
    const stewart_real C_p = leg->C_p;
    const stewart_real C_s = leg->C_s;
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
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real B_xx = shared->B[0], B_xy = shared->B[1], B_xz = shared->B[2],
        B_yx = shared->B[3], B_yy = shared->B[4], B_yz = shared->B[5], B_zx = shared->B[6],
        B_zy = shared->B[7], B_zz = shared->B[8];
    const stewart_real g_x = platform->g[0], g_y = platform->g[1], g_z = platform->g[2];
    const stewart_real t_1_x = shared->t_1[0], t_1_y = shared->t_1[1], t_1_z = shared->t_1[2];
    const stewart_real r_x = leg->r[0], r_y = leg->r[1], r_z = leg->r[2];
    /* (1) platform point from the reference point */
    const stewart_real q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z;
    const stewart_real q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z;
    const stewart_real q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z;
    /* (1) platform point from base point 1, base frame */
    const stewart_real S_1_x = q_x + t_1_x;
    const stewart_real S_1_y = q_y + t_1_y;
    const stewart_real S_1_z = q_z + t_1_z;
    /* (1) leg vector */
    const stewart_real S_x = S_1_x - r_x;
    const stewart_real S_y = S_1_y - r_y;
    const stewart_real S_z = S_1_z - r_z;
    /* (10) leg vector along the fixed axis, and normal to both */
    const stewart_real zeta = S_x*k_x + S_y*k_y + S_z*k_z;
    const stewart_real k_cross_S_x = S_z*k_y - S_y*k_z;
    const stewart_real k_cross_S_y = S_x*k_z - S_z*k_x;
    const stewart_real k_cross_S_z = S_y*k_x - S_x*k_y;
    const stewart_real rho2 = k_cross_S_x*k_cross_S_x + k_cross_S_y*k_cross_S_y + k_cross_S_z*k_cross_S_z;
    /* (2) leg length, and distance of its tip from the fixed axis */
    const stewart_real L = STEWART_SQRT(rho2 + zeta*zeta);
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
    const stewart_real S_dot_x = omega_y*q_z + v_x - omega_z*q_y;
    const stewart_real S_dot_y = omega_z*q_x + v_y - omega_x*q_z;
    const stewart_real S_dot_z = omega_x*q_y + v_z - omega_y*q_x;
    /* (7) acceleration of the platform point */
    const stewart_real S_ddot_x = B_xx*q_x + B_xy*q_y + B_xz*q_z + a_x;
    const stewart_real S_ddot_y = B_yx*q_x + B_yy*q_y + B_yz*q_z + a_y;
    const stewart_real S_ddot_z = B_zx*q_x + B_zy*q_y + B_zz*q_z + a_z;
    /* (5) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z;
    /* (6) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z);
    const stewart_real theta_dot = inv_rho*(L_dot*k1 - S_dot_x*k_x - S_dot_y*k_y - S_dot_z*k_z);
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
    const stewart_real L_ddot = L*(k33*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z;
    /* (9) accelerations of the joint coordinates */
    const stewart_real theta_ddot = inv_rho*(L_ddot*k1 - S_ddot_x*k_x - S_ddot_y*k_y - S_ddot_z*k_z)
        - theta_dot*(L_share + rho_share);
    const stewart_real phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z)
        - rho_share*two_phi_dot;
    const stewart_real k13 = k1*k3;
    const stewart_real L_h2 = L*h2_x;
    const stewart_real a1 = L_h2 + dJ_zx;
    const stewart_real a2 = J2_xz - L*h2_z;
    const stewart_real a3 = J_xy - L*h_y;
    /* (19) inertia of the joint coordinates */
    const stewart_real M_phi = J_xx + a1*k33 + a2*k13;
    const stewart_real M_theta = J_yy + L_h2;
    const stewart_real M_mixed = J_yz*k3 + a3*k1;
    const stewart_real k3_h = h_y*k3;
    /* (19) slopes of M_phi / 2 along theta and L, of M_mixed along theta */
    const stewart_real M_phi_theta = a1*k13 + a2*(STEWART_HALF - k33);
    const stewart_real M_phi_L = h_x*k33 - h_z*k13;
    const stewart_real M_mixed_theta = J_yz*k1 - a3*k3;
    const stewart_real bend = L_dot*theta_dot;
    /* gravity along k x y and along y */
    const stewart_real gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z;
    const stewart_real gamma_y = g_x*y_x + g_y*y_y + g_z*y_z;
    /* first moment along k and against k x y */
    const stewart_real w_k = k1*w_x + k3*w_z;
    const stewart_real w_n = k3*w_x - k1*w_z;
    /* (20) generalised forces about y and about k */
    const stewart_real tau_y = C_us*theta_dot + L_ddot*h_z + M_mixed*phi_ddot + M_theta*theta_ddot
        + bend*h2_x + g_k*w_n + gamma_n*w_k - C_s*(omega_x*y_x + omega_y*y_y + omega_z*y_z)
        - M_phi_theta*phi_dot2;
    const stewart_real tau_k = C_us*phi_dot + M_mixed*theta_ddot + M_mixed_theta*theta_dot2 + M_phi*phi_ddot
        + two_phi_dot*(L_dot*M_phi_L + M_phi_theta*theta_dot) - C_s*(k_x*omega_x + k_y*omega_y
        + k_z*omega_z) - L_ddot*k3_h - bend*h2_y*k1 - gamma_n*w_y - gamma_y*w_n;
    /* (21) K = Q_k k + Q_y y, up to a part along s */
    const stewart_real Q_k = -inv_rho*tau_y;
    const stewart_real Q_y = inv_rho*tau_k;
    /* (21) force at the spherical joint, base frame */
    const stewart_real K_x = Q_k*k_x + Q_y*y_x;
    const stewart_real K_y = Q_k*k_y + Q_y*y_y;
    const stewart_real K_z = Q_k*k_z + Q_y*y_z;
    /* (24) known part of the actuator force, to match */
    const stewart_real D = C_p*L_dot + h_z*theta_ddot - M_phi_L*phi_dot2 - Q_k*k1 - h_x*theta_dot2
        - k3_h*phi_ddot;
    /* the leg's column of H, moment rows */
    const stewart_real H_moment_x = r_y*s_z - r_z*s_y;
    const stewart_real H_moment_y = r_z*s_x - r_x*s_z;
    const stewart_real H_moment_z = r_x*s_y - r_y*s_x;
    /* part of c, moment rows, base frame */
    const stewart_real c_moment_x = C_s*(k_x*phi_dot + theta_dot*y_x) + K_y*S_1_z - K_z*S_1_y;
    const stewart_real c_moment_y = C_s*(k_y*phi_dot + theta_dot*y_y) + K_z*S_1_x - K_x*S_1_z;
    const stewart_real c_moment_z = C_s*(k_z*phi_dot + theta_dot*y_z) + K_x*S_1_y - K_y*S_1_x;
    out->D = D;
    out->H_force[0] = s_x;
    out->H_force[1] = s_y;
    out->H_force[2] = s_z;
    out->H_moment[0] = H_moment_x;
    out->H_moment[1] = H_moment_y;
    out->H_moment[2] = H_moment_z;
    out->c_force[0] = -K_x;
    out->c_force[1] = -K_y;
    out->c_force[2] = -K_z;
    out->c_moment[0] = c_moment_x;
    out->c_moment[1] = c_moment_y;
    out->c_moment[2] = c_moment_z;
    {
        const stewart_real reach[9] = {q_x, q_y, q_z, t_1_x, t_1_y, t_1_z, r_x, r_y, r_z};
        out->status = leg_status(L, k3, reach);
    }
}

/* Solves the augmented rows [H | c | 1] by elimination with partial pivoting, (36); column 6 becomes x, those
 * after it the inverse Y of H. `moment` is the size of the moment rows; a pivot that is rounding error beside
 * its row means that H is singular. */
static int solve(stewart_real A[6][13], stewart_real moment, stewart_real x[6], stewart_real Y[6][6])
{
    stewart_real scale[6], inverse[6];
    int i, j, k;
    for (i = 0; i < 6; ++i) {
        scale[i] = i < 3 ? 1 : moment;
    }
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        stewart_real row_scale;
        for (i = k + 1; i < 6; ++i) {
            if (STEWART_FABS(A[i][k]) > STEWART_FABS(A[pivot][k])) {
                pivot = i;
            }
        }
        row_scale = scale[pivot];
        scale[pivot] = scale[k];
        for (j = 0; j < 13; ++j) {
            const stewart_real moved = A[k][j];
            A[k][j] = A[pivot][j];
            A[pivot][j] = moved;
        }
        if (!(STEWART_FABS(A[k][k]) > STEWART_ROUNDING * row_scale)) {
            return is_finite(A[k] + k, 1) ? STEWART_SINGULAR : STEWART_NOT_FINITE;
        }
        inverse[k] = 1 / A[k][k];
        for (i = k + 1; i < 6; ++i) {
            const stewart_real factor = A[i][k] * inverse[k];
            for (j = k + 1; j < 13; ++j) {
                A[i][j] = A[i][j] - factor * A[k][j];
            }
        }
    }
    for (i = 5; i >= 0; --i) {
        for (j = 6; j < 13; ++j) {
            for (k = i + 1; k < 6; ++k) {
                A[i][j] = A[i][j] - A[i][k] * A[k][j];
            }
            A[i][j] = i < 5 ? A[i][j] * inverse[i] : A[i][j] / A[i][i];
        }
        x[i] = A[i][6];
        for (j = 0; j < 6; ++j) {
            Y[i][j] = A[i][j + 7];
        }
    }
    return STEWART_OK;
}

/* Bounds what is left of the error of x = Y c when the errors of H and c have been weighed by Y: adds it to
 * `error`. With E_H and e_c bounding these errors, and d the error of x in sizes,
 *     d <= b + G d,    b = |Y| (|c - H x| + E_H |x| + e_c),    G = |1 - Y H| + |Y| E_H,
 * and where G b <= beta b with beta < 1, H is regular and d <= b / (1 - beta) (Rump, Verification methods,
 * Acta Numerica 19 (2010), 10); what is left is |Y| |c - H x| + G d. Where there is no such beta, it is
 * infinite. Sums of seven terms round seven times at most. */
static void solution_error(
    const platform_equations *of, const stewart_real x[6], stewart_real Y[6][6], stewart_real error[6])
{
    stewart_real rest[6], doubt[6], b[6], G[6][6], worst = 0;
    int i, j, k;
    for (i = 0; i < 6; ++i) {
        stewart_real sum = of->c[i], sizes = STEWART_FABS(of->c[i]);
        doubt[i] = of->c_err[i];
        for (j = 0; j < 6; ++j) {
            const stewart_real product = of->H[i][j] * x[j];
            sum = sum - product;
            sizes = sizes + STEWART_FABS(product);
            doubt[i] = doubt[i] + of->H_err[i][j] * STEWART_FABS(x[j]);
        }
        rest[i] = STEWART_FABS(sum) + 7 * STEWART_UNIT * sizes + of->c_own[i];
    }
    for (i = 0; i < 6; ++i) {
        b[i] = 4 / STEWART_MAX; /* so that no entry is zero */
        for (j = 0; j < 6; ++j) {
            b[i] = b[i] + STEWART_FABS(Y[i][j]) * (rest[j] + doubt[j]);
            error[i] = error[i] + STEWART_FABS(Y[i][j]) * rest[j];
        }
    }
    for (i = 0; i < 6; ++i) {
        stewart_real grown = 0;
        for (k = 0; k < 6; ++k) {
            stewart_real sum = i == k ? 1 : 0, sizes = sum, carried = 0;
            for (j = 0; j < 6; ++j) {
                const stewart_real product = Y[i][j] * of->H[j][k];
                sum = sum - product;
                sizes = sizes + STEWART_FABS(product);
                carried = carried + STEWART_FABS(Y[i][j]) * of->H_err[j][k];
            }
            G[i][k] = STEWART_FABS(sum) + carried + 7 * STEWART_UNIT * sizes;
            grown = grown + G[i][k] * b[k];
        }
        worst = grown / b[i] <= worst ? worst : grown / b[i];
    }
    for (i = 0; i < 6; ++i) {
        for (k = 0; k < 6; ++k) {
            error[i] = error[i] + G[i][k] * (b[k] / (1 - worst));
        }
        if (!(worst <= (stewart_real)0.875)) {
            error[i] = STEWART_INFINITY;
        }
    }
}

/* Largest sum of a column in sizes. */
static stewart_real norm(stewart_real A[6][6])
{
    stewart_real worst = 0;
    int i, j;
    for (j = 0; j < 6; ++j) {
        stewart_real sum = 0;
        for (i = 0; i < 6; ++i) {
            sum = sum + STEWART_FABS(A[i][j]);
        }
        worst = sum > worst ? sum : worst;
    }
    return worst;
}

/* 1/(|H| |Y|), moments moved from base point 1 to the reference point, t away, and measured by `length`. */
static stewart_real reciprocal_condition(
    stewart_real H[6][6], stewart_real Y[6][6], const stewart_real t[3], stewart_real length)
{
    stewart_real A[6][6], B[6][6];
    int i, j;
    for (j = 0; j < 3; ++j) {
        const int next = (j + 1) % 3, last = (j + 2) % 3;
        for (i = 0; i < 6; ++i) {
            A[j][i] = H[j][i];
            A[j + 3][i] = (H[j + 3][i] - (t[next] * H[last][i] - t[last] * H[next][i])) / length;
            B[i][j] = Y[i][j] + (Y[i][3 + next] * t[last] - Y[i][3 + last] * t[next]);
            B[i][j + 3] = Y[i][j + 3] * length;
        }
    }
    return 1 / norm(A) / norm(B);
}

/* What one pose has for all legs, with errors; R_err: how far R is from a rotation. Where there are slopes of
 * the legs, adds to the error of each force what these errors do to it: each by the slope of the force along
 * it, at its largest. */
static void shared_errors(
    const stewart_exact_bounds_platform *platform, const stewart_motions *at, stewart_real R_err,
    const force_row rows[6], const slopes_of_legs *slopes, stewart_real error[6], shared_terms *out)
{
    int i;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real M_ext_x = at->M_ext[0], M_ext_y = at->M_ext[1], M_ext_z = at->M_ext[2];
    const stewart_real M_P = platform->M_P;
    const stewart_real M_P_err = platform->M_P_err;
    const stewart_real h_P_x = platform->h_P[0], h_P_y = platform->h_P[1], h_P_z = platform->h_P[2];
    const stewart_real h_P_x_err = platform->h_P_err[0], h_P_y_err = platform->h_P_err[1],
        h_P_z_err = platform->h_P_err[2];
    const stewart_real J_P_xx = platform->J_P[0], J_P_xy = platform->J_P[1], J_P_xz = platform->J_P[2],
        J_P_yy = platform->J_P[3], J_P_yz = platform->J_P[4], J_P_zz = platform->J_P[5];
    const stewart_real J_P_xx_err = platform->J_P_err[0], J_P_xy_err = platform->J_P_err[1],
        J_P_xz_err = platform->J_P_err[2], J_P_yy_err = platform->J_P_err[3],
        J_P_yz_err = platform->J_P_err[4], J_P_zz_err = platform->J_P_err[5];
    const stewart_real dJ_P_x = platform->dJ_P[0], dJ_P_y = platform->dJ_P[1],
        dJ_P_z = platform->dJ_P[2];
    const stewart_real dJ_P_x_err = platform->dJ_P_err[0], dJ_P_y_err = platform->dJ_P_err[1],
        dJ_P_z_err = platform->dJ_P_err[2];
    const stewart_real C_P = platform->C_P;
    const stewart_real C_P_err = platform->C_P_err;
    const stewart_real g_x = platform->g[0], g_y = platform->g[1], g_z = platform->g[2];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real b_1_x = platform->b_1[0], b_1_y = platform->b_1[1], b_1_z = platform->b_1[2];
    const stewart_real R_xx_max = STEWART_FABS(R_xx) + R_err, R_xy_max = STEWART_FABS(R_xy) + R_err,
        R_xz_max = STEWART_FABS(R_xz) + R_err, R_yx_max = STEWART_FABS(R_yx) + R_err,
        R_yy_max = STEWART_FABS(R_yy) + R_err, R_yz_max = STEWART_FABS(R_yz) + R_err,
        R_zx_max = STEWART_FABS(R_zx) + R_err, R_zy_max = STEWART_FABS(R_zy) + R_err,
        R_zz_max = STEWART_FABS(R_zz) + R_err;
    const stewart_real omega_x_max = STEWART_FABS(omega_x), omega_y_max = STEWART_FABS(omega_y),
        omega_z_max = STEWART_FABS(omega_z);
    const stewart_real alpha_x_max = STEWART_FABS(alpha_x), alpha_y_max = STEWART_FABS(alpha_y),
        alpha_z_max = STEWART_FABS(alpha_z);
    const stewart_real F_ext_x_max = STEWART_FABS(F_ext_x), F_ext_y_max = STEWART_FABS(F_ext_y),
        F_ext_z_max = STEWART_FABS(F_ext_z);
    const stewart_real M_ext_x_max = STEWART_FABS(M_ext_x), M_ext_y_max = STEWART_FABS(M_ext_y),
        M_ext_z_max = STEWART_FABS(M_ext_z);
    const stewart_real M_P_max = STEWART_FABS(M_P) + M_P_err;
    const stewart_real h_P_x_max = STEWART_FABS(h_P_x) + h_P_x_err,
        h_P_y_max = STEWART_FABS(h_P_y) + h_P_y_err, h_P_z_max = STEWART_FABS(h_P_z) + h_P_z_err;
    const stewart_real J_P_xx_max = STEWART_FABS(J_P_xx) + J_P_xx_err,
        J_P_xy_max = STEWART_FABS(J_P_xy) + J_P_xy_err, J_P_xz_max = STEWART_FABS(J_P_xz) + J_P_xz_err,
        J_P_yy_max = STEWART_FABS(J_P_yy) + J_P_yy_err, J_P_yz_max = STEWART_FABS(J_P_yz) + J_P_yz_err,
        J_P_zz_max = STEWART_FABS(J_P_zz) + J_P_zz_err;
    const stewart_real dJ_P_x_max = STEWART_FABS(dJ_P_x) + dJ_P_x_err,
        dJ_P_y_max = STEWART_FABS(dJ_P_y) + dJ_P_y_err,
        dJ_P_z_max = STEWART_FABS(dJ_P_z) + dJ_P_z_err;
    const stewart_real C_P_max = STEWART_FABS(C_P) + C_P_err;
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
    /* (30) first moment of the platform, base frame */
    const stewart_real h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z;
    const stewart_real h_base_x_own = STEWART_UNIT*(REAL(2)*R_xx_max*h_P_x_max + REAL(2)*R_xy_max*h_P_y_max
        + REAL(2)*R_xz_max*h_P_z_max + STEWART_FABS(h_base_x));
    const stewart_real h_base_x_err = R_err*(h_P_x_max + h_P_y_max + h_P_z_max) + R_xx_max*h_P_x_err
        + R_xy_max*h_P_y_err + R_xz_max*h_P_z_err + h_base_x_own;
    const stewart_real h_base_x_max = STEWART_FABS(h_base_x) + h_base_x_err;
    const stewart_real h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z;
    const stewart_real h_base_y_own = STEWART_UNIT*(REAL(2)*R_yx_max*h_P_x_max + REAL(2)*R_yy_max*h_P_y_max
        + REAL(2)*R_yz_max*h_P_z_max + STEWART_FABS(h_base_y));
    const stewart_real h_base_y_err = R_err*(h_P_x_max + h_P_y_max + h_P_z_max) + R_yx_max*h_P_x_err
        + R_yy_max*h_P_y_err + R_yz_max*h_P_z_err + h_base_y_own;
    const stewart_real h_base_y_max = STEWART_FABS(h_base_y) + h_base_y_err;
    const stewart_real h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z;
    const stewart_real h_base_z_own = STEWART_UNIT*(REAL(2)*R_zx_max*h_P_x_max + REAL(2)*R_zy_max*h_P_y_max
        + REAL(2)*R_zz_max*h_P_z_max + STEWART_FABS(h_base_z));
    const stewart_real h_base_z_err = R_err*(h_P_x_max + h_P_y_max + h_P_z_max) + R_zx_max*h_P_x_err
        + R_zy_max*h_P_y_err + R_zz_max*h_P_z_err + h_base_z_own;
    const stewart_real h_base_z_max = STEWART_FABS(h_base_z) + h_base_z_err;
    /* (33) g - a */
    const stewart_real fall_x = g_x - a_x;
    const stewart_real fall_x_own = STEWART_UNIT*STEWART_FABS(fall_x);
    const stewart_real fall_x_err = fall_x_own;
    const stewart_real fall_x_max = STEWART_FABS(fall_x) + fall_x_err;
    const stewart_real fall_y = g_y - a_y;
    const stewart_real fall_y_own = STEWART_UNIT*STEWART_FABS(fall_y);
    const stewart_real fall_y_err = fall_y_own;
    const stewart_real fall_y_max = STEWART_FABS(fall_y) + fall_y_err;
    const stewart_real fall_z = g_z - a_z;
    const stewart_real fall_z_own = STEWART_UNIT*STEWART_FABS(fall_z);
    const stewart_real fall_z_err = fall_z_own;
    const stewart_real fall_z_max = STEWART_FABS(fall_z) + fall_z_err;
    /* angular velocity, platform frame */
    const stewart_real omega_P_x = R_xx*omega_x + R_yx*omega_y + R_zx*omega_z;
    const stewart_real omega_P_x_own = STEWART_UNIT*(REAL(2)*R_xx_max*omega_x_max
        + REAL(2)*R_yx_max*omega_y_max + REAL(2)*R_zx_max*omega_z_max + STEWART_FABS(omega_P_x));
    const stewart_real omega_P_x_err = R_err*(omega_x_max + omega_y_max + omega_z_max) + omega_P_x_own;
    const stewart_real omega_P_x_max = STEWART_FABS(omega_P_x) + omega_P_x_err;
    const stewart_real omega_P_y = R_xy*omega_x + R_yy*omega_y + R_zy*omega_z;
    const stewart_real omega_P_y_own = STEWART_UNIT*(REAL(2)*R_xy_max*omega_x_max
        + REAL(2)*R_yy_max*omega_y_max + REAL(2)*R_zy_max*omega_z_max + STEWART_FABS(omega_P_y));
    const stewart_real omega_P_y_err = R_err*(omega_x_max + omega_y_max + omega_z_max) + omega_P_y_own;
    const stewart_real omega_P_y_max = STEWART_FABS(omega_P_y) + omega_P_y_err;
    const stewart_real omega_P_z = R_xz*omega_x + R_yz*omega_y + R_zz*omega_z;
    const stewart_real omega_P_z_own = STEWART_UNIT*(REAL(2)*R_xz_max*omega_x_max
        + REAL(2)*R_yz_max*omega_y_max + REAL(2)*R_zz_max*omega_z_max + STEWART_FABS(omega_P_z));
    const stewart_real omega_P_z_err = R_err*(omega_x_max + omega_y_max + omega_z_max) + omega_P_z_own;
    const stewart_real omega_P_z_max = STEWART_FABS(omega_P_z) + omega_P_z_err;
    /* angular acceleration, platform frame */
    const stewart_real alpha_P_x = R_xx*alpha_x + R_yx*alpha_y + R_zx*alpha_z;
    const stewart_real alpha_P_x_own = STEWART_UNIT*(REAL(2)*R_xx_max*alpha_x_max
        + REAL(2)*R_yx_max*alpha_y_max + REAL(2)*R_zx_max*alpha_z_max + STEWART_FABS(alpha_P_x));
    const stewart_real alpha_P_x_err = R_err*(alpha_x_max + alpha_y_max + alpha_z_max) + alpha_P_x_own;
    const stewart_real alpha_P_x_max = STEWART_FABS(alpha_P_x) + alpha_P_x_err;
    const stewart_real alpha_P_y = R_xy*alpha_x + R_yy*alpha_y + R_zy*alpha_z;
    const stewart_real alpha_P_y_own = STEWART_UNIT*(REAL(2)*R_xy_max*alpha_x_max
        + REAL(2)*R_yy_max*alpha_y_max + REAL(2)*R_zy_max*alpha_z_max + STEWART_FABS(alpha_P_y));
    const stewart_real alpha_P_y_err = R_err*(alpha_x_max + alpha_y_max + alpha_z_max) + alpha_P_y_own;
    const stewart_real alpha_P_y_max = STEWART_FABS(alpha_P_y) + alpha_P_y_err;
    const stewart_real alpha_P_z = R_xz*alpha_x + R_yz*alpha_y + R_zz*alpha_z;
    const stewart_real alpha_P_z_own = STEWART_UNIT*(REAL(2)*R_xz_max*alpha_x_max
        + REAL(2)*R_yz_max*alpha_y_max + REAL(2)*R_zz_max*alpha_z_max + STEWART_FABS(alpha_P_z));
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
    const stewart_real M_P_load_x = M_ext_x - J_P_xx*alpha_P_x - J_P_xy*(alpha_P_y - P_xz) - J_P_xz*(P_xy
        + alpha_P_z) - J_P_yz*(P_yy - P_zz) - P_yz*dJ_P_x;
    const stewart_real M_P_load_x_own = STEWART_UNIT*(REAL(5)*J_P_xx_max*alpha_P_x_max
        + REAL(6)*J_P_xy_max*(P_xz_max + alpha_P_y_max) + REAL(6)*J_P_xz_max*(P_xy_max + alpha_P_z_max)
        + REAL(6)*J_P_yz_max*(P_yy_max + P_zz_max) + REAL(4)*M_ext_x_max + REAL(5)*P_yz_max*dJ_P_x_max
        + STEWART_FABS(M_P_load_x));
    const stewart_real M_P_load_x_err = J_P_xx_err*alpha_P_x_max + J_P_xx_max*alpha_P_x_err
        + J_P_xy_err*(P_xz_max + alpha_P_y_max) + J_P_xy_max*P_xz_err + J_P_xy_max*alpha_P_y_err
        + J_P_xz_err*(P_xy_max + alpha_P_z_max) + J_P_xz_max*P_xy_err + J_P_xz_max*alpha_P_z_err
        + J_P_yz_err*(P_yy_max + P_zz_max) + J_P_yz_max*P_yy_err + J_P_yz_max*P_zz_err + P_yz_err*dJ_P_x_max
        + P_yz_max*dJ_P_x_err + M_P_load_x_own;
    const stewart_real M_P_load_x_max = STEWART_FABS(M_P_load_x) + M_P_load_x_err;
    const stewart_real M_P_load_y = M_ext_y - J_P_xy*(P_yz + alpha_P_x) - J_P_xz*(P_zz - P_xx)
        - J_P_yy*alpha_P_y - J_P_yz*(alpha_P_z - P_xy) - P_xz*dJ_P_y;
    const stewart_real M_P_load_y_own = STEWART_UNIT*(REAL(6)*J_P_xy_max*(P_yz_max + alpha_P_x_max)
        + REAL(6)*J_P_xz_max*(P_xx_max + P_zz_max) + REAL(5)*J_P_yy_max*alpha_P_y_max
        + REAL(6)*J_P_yz_max*(P_xy_max + alpha_P_z_max) + REAL(4)*M_ext_y_max + REAL(5)*P_xz_max*dJ_P_y_max
        + STEWART_FABS(M_P_load_y));
    const stewart_real M_P_load_y_err = J_P_xy_err*(P_yz_max + alpha_P_x_max) + J_P_xy_max*P_yz_err
        + J_P_xy_max*alpha_P_x_err + J_P_xz_err*(P_xx_max + P_zz_max) + J_P_xz_max*P_xx_err
        + J_P_xz_max*P_zz_err + J_P_yy_err*alpha_P_y_max + J_P_yy_max*alpha_P_y_err + J_P_yz_err*(P_xy_max
        + alpha_P_z_max) + J_P_yz_max*P_xy_err + J_P_yz_max*alpha_P_z_err + P_xz_err*dJ_P_y_max
        + P_xz_max*dJ_P_y_err + M_P_load_y_own;
    const stewart_real M_P_load_y_max = STEWART_FABS(M_P_load_y) + M_P_load_y_err;
    const stewart_real M_P_load_z = M_ext_z - J_P_xy*(P_xx - P_yy) - J_P_xz*(alpha_P_x - P_yz)
        - J_P_yz*(P_xz + alpha_P_y) - J_P_zz*alpha_P_z - P_xy*dJ_P_z;
    const stewart_real M_P_load_z_own = STEWART_UNIT*(REAL(6)*J_P_xy_max*(P_xx_max + P_yy_max)
        + REAL(6)*J_P_xz_max*(P_yz_max + alpha_P_x_max) + REAL(6)*J_P_yz_max*(P_xz_max + alpha_P_y_max)
        + REAL(5)*J_P_zz_max*alpha_P_z_max + REAL(4)*M_ext_z_max + REAL(5)*P_xy_max*dJ_P_z_max
        + STEWART_FABS(M_P_load_z));
    const stewart_real M_P_load_z_err = J_P_xy_err*(P_xx_max + P_yy_max) + J_P_xy_max*P_xx_err
        + J_P_xy_max*P_yy_err + J_P_xz_err*(P_yz_max + alpha_P_x_max) + J_P_xz_max*P_yz_err
        + J_P_xz_max*alpha_P_x_err + J_P_yz_err*(P_xz_max + alpha_P_y_max) + J_P_yz_max*P_xz_err
        + J_P_yz_max*alpha_P_y_err + J_P_zz_err*alpha_P_z_max + J_P_zz_max*alpha_P_z_err
        + P_xy_err*dJ_P_z_max + P_xy_max*dJ_P_z_err + M_P_load_z_own;
    const stewart_real M_P_load_z_max = STEWART_FABS(M_P_load_z) + M_P_load_z_err;
    /* reference point from base point 1, base frame */
    const stewart_real t_1_x = t_x - b_1_x;
    const stewart_real t_1_x_own = STEWART_UNIT*STEWART_FABS(t_1_x);
    const stewart_real t_1_x_err = t_1_x_own;
    const stewart_real t_1_x_max = STEWART_FABS(t_1_x) + t_1_x_err;
    const stewart_real t_1_y = t_y - b_1_y;
    const stewart_real t_1_y_own = STEWART_UNIT*STEWART_FABS(t_1_y);
    const stewart_real t_1_y_err = t_1_y_own;
    const stewart_real t_1_y_max = STEWART_FABS(t_1_y) + t_1_y_err;
    const stewart_real t_1_z = t_z - b_1_z;
    const stewart_real t_1_z_own = STEWART_UNIT*STEWART_FABS(t_1_z);
    const stewart_real t_1_z_err = t_1_z_own;
    const stewart_real t_1_z_max = STEWART_FABS(t_1_z) + t_1_z_err;
    /* (33) the platform's part of c, force and moment */
    const stewart_real load_x = F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz + M_P*fall_x - B_xx*h_base_x
        - B_xy*h_base_y - B_xz*h_base_z;
    const stewart_real load_x_own = STEWART_UNIT*(REAL(6)*B_xx_max*h_base_x_max
        + REAL(6)*B_xy_max*h_base_y_max + REAL(6)*B_xz_max*h_base_z_max + REAL(6)*F_ext_x_max*R_xx_max
        + REAL(6)*F_ext_y_max*R_xy_max + REAL(6)*F_ext_z_max*R_xz_max + REAL(6)*M_P_max*fall_x_max
        + STEWART_FABS(load_x));
    const stewart_real load_x_err = B_xx_err*h_base_x_max + B_xx_max*h_base_x_err + B_xy_err*h_base_y_max
        + B_xy_max*h_base_y_err + B_xz_err*h_base_z_max + B_xz_max*h_base_z_err + M_P_err*fall_x_max
        + M_P_max*fall_x_err + R_err*(F_ext_x_max + F_ext_y_max + F_ext_z_max) + load_x_own;
    const stewart_real load_x_max = STEWART_FABS(load_x) + load_x_err;
    const stewart_real load_y = F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz + M_P*fall_y - B_yx*h_base_x
        - B_yy*h_base_y - B_yz*h_base_z;
    const stewart_real load_y_own = STEWART_UNIT*(REAL(6)*B_yx_max*h_base_x_max
        + REAL(6)*B_yy_max*h_base_y_max + REAL(6)*B_yz_max*h_base_z_max + REAL(6)*F_ext_x_max*R_yx_max
        + REAL(6)*F_ext_y_max*R_yy_max + REAL(6)*F_ext_z_max*R_yz_max + REAL(6)*M_P_max*fall_y_max
        + STEWART_FABS(load_y));
    const stewart_real load_y_err = B_yx_err*h_base_x_max + B_yx_max*h_base_x_err + B_yy_err*h_base_y_max
        + B_yy_max*h_base_y_err + B_yz_err*h_base_z_max + B_yz_max*h_base_z_err + M_P_err*fall_y_max
        + M_P_max*fall_y_err + R_err*(F_ext_x_max + F_ext_y_max + F_ext_z_max) + load_y_own;
    const stewart_real load_y_max = STEWART_FABS(load_y) + load_y_err;
    const stewart_real load_z = F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz + M_P*fall_z - B_zx*h_base_x
        - B_zy*h_base_y - B_zz*h_base_z;
    const stewart_real load_z_own = STEWART_UNIT*(REAL(6)*B_zx_max*h_base_x_max
        + REAL(6)*B_zy_max*h_base_y_max + REAL(6)*B_zz_max*h_base_z_max + REAL(6)*F_ext_x_max*R_zx_max
        + REAL(6)*F_ext_y_max*R_zy_max + REAL(6)*F_ext_z_max*R_zz_max + REAL(6)*M_P_max*fall_z_max
        + STEWART_FABS(load_z));
    const stewart_real load_z_err = B_zx_err*h_base_x_max + B_zx_max*h_base_x_err + B_zy_err*h_base_y_max
        + B_zy_max*h_base_y_err + B_zz_err*h_base_z_max + B_zz_max*h_base_z_err + M_P_err*fall_z_max
        + M_P_max*fall_z_err + R_err*(F_ext_x_max + F_ext_y_max + F_ext_z_max) + load_z_own;
    const stewart_real load_z_max = STEWART_FABS(load_z) + load_z_err;
    /* part of c, moment rows, base frame */
    const stewart_real c_moment_x = M_P_load_x*R_xx + M_P_load_y*R_xy + M_P_load_z*R_xz + fall_z*h_base_y
        + load_z*t_1_y - C_P*omega_x - fall_y*h_base_z - load_y*t_1_z;
    const stewart_real c_moment_x_own = STEWART_UNIT*(REAL(7)*C_P_max*omega_x_max
        + REAL(7)*M_P_load_x_max*R_xx_max + REAL(7)*M_P_load_y_max*R_xy_max
        + REAL(7)*M_P_load_z_max*R_xz_max + REAL(7)*fall_y_max*h_base_z_max
        + REAL(7)*fall_z_max*h_base_y_max + REAL(7)*load_y_max*t_1_z_max + REAL(7)*load_z_max*t_1_y_max
        + STEWART_FABS(c_moment_x));
    const stewart_real c_moment_x_err = C_P_err*omega_x_max + M_P_load_x_err*R_xx_max
        + M_P_load_y_err*R_xy_max + M_P_load_z_err*R_xz_max + R_err*(M_P_load_x_max + M_P_load_y_max
        + M_P_load_z_max) + fall_y_err*h_base_z_max + fall_y_max*h_base_z_err + fall_z_err*h_base_y_max
        + fall_z_max*h_base_y_err + load_y_err*t_1_z_max + load_y_max*t_1_z_err + load_z_err*t_1_y_max
        + load_z_max*t_1_y_err + c_moment_x_own;
    const stewart_real c_moment_y = M_P_load_x*R_yx + M_P_load_y*R_yy + M_P_load_z*R_yz + fall_x*h_base_z
        + load_x*t_1_z - C_P*omega_y - fall_z*h_base_x - load_z*t_1_x;
    const stewart_real c_moment_y_own = STEWART_UNIT*(REAL(7)*C_P_max*omega_y_max
        + REAL(7)*M_P_load_x_max*R_yx_max + REAL(7)*M_P_load_y_max*R_yy_max
        + REAL(7)*M_P_load_z_max*R_yz_max + REAL(7)*fall_x_max*h_base_z_max
        + REAL(7)*fall_z_max*h_base_x_max + REAL(7)*load_x_max*t_1_z_max + REAL(7)*load_z_max*t_1_x_max
        + STEWART_FABS(c_moment_y));
    const stewart_real c_moment_y_err = C_P_err*omega_y_max + M_P_load_x_err*R_yx_max
        + M_P_load_y_err*R_yy_max + M_P_load_z_err*R_yz_max + R_err*(M_P_load_x_max + M_P_load_y_max
        + M_P_load_z_max) + fall_x_err*h_base_z_max + fall_x_max*h_base_z_err + fall_z_err*h_base_x_max
        + fall_z_max*h_base_x_err + load_x_err*t_1_z_max + load_x_max*t_1_z_err + load_z_err*t_1_x_max
        + load_z_max*t_1_x_err + c_moment_y_own;
    const stewart_real c_moment_z = M_P_load_x*R_zx + M_P_load_y*R_zy + M_P_load_z*R_zz + fall_y*h_base_x
        + load_y*t_1_x - C_P*omega_z - fall_x*h_base_y - load_x*t_1_y;
    const stewart_real c_moment_z_own = STEWART_UNIT*(REAL(7)*C_P_max*omega_z_max
        + REAL(7)*M_P_load_x_max*R_zx_max + REAL(7)*M_P_load_y_max*R_zy_max
        + REAL(7)*M_P_load_z_max*R_zz_max + REAL(7)*fall_x_max*h_base_y_max
        + REAL(7)*fall_y_max*h_base_x_max + REAL(7)*load_x_max*t_1_y_max + REAL(7)*load_y_max*t_1_x_max
        + STEWART_FABS(c_moment_z));
    const stewart_real c_moment_z_err = C_P_err*omega_z_max + M_P_load_x_err*R_zx_max
        + M_P_load_y_err*R_zy_max + M_P_load_z_err*R_zz_max + R_err*(M_P_load_x_max + M_P_load_y_max
        + M_P_load_z_max) + fall_x_err*h_base_y_max + fall_x_max*h_base_y_err + fall_y_err*h_base_x_max
        + fall_y_max*h_base_x_err + load_x_err*t_1_y_max + load_x_max*t_1_y_err + load_y_err*t_1_x_max
        + load_y_max*t_1_x_err + c_moment_z_own;
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
    out->t_1[0] = t_1_x;
    out->t_1_err[0] = t_1_x_err;
    out->t_1[1] = t_1_y;
    out->t_1_err[1] = t_1_y_err;
    out->t_1[2] = t_1_z;
    out->t_1_err[2] = t_1_z_err;
    out->c_force[0] = load_x;
    out->c_force_err[0] = load_x_err;
    out->c_force[1] = load_y;
    out->c_force_err[1] = load_y_err;
    out->c_force[2] = load_z;
    out->c_force_err[2] = load_z_err;
    out->c_moment[0] = c_moment_x;
    out->c_moment_err[0] = c_moment_x_err;
    out->c_moment[1] = c_moment_y;
    out->c_moment_err[1] = c_moment_y_err;
    out->c_moment[2] = c_moment_z;
    out->c_moment_err[2] = c_moment_z_err;
    for (i = 0; slopes && i < 6; ++i) {
        const force_row *row = &rows[i];
        const slopes_of_legs *of_legs = &slopes[i];
        const stewart_real Y_force_x = row->Y_force[0], Y_force_y = row->Y_force[1],
            Y_force_z = row->Y_force[2];
        const stewart_real Y_moment_x = row->Y_moment[0], Y_moment_y = row->Y_moment[1],
            Y_moment_z = row->Y_moment[2];
        const stewart_real R_legs_xx = of_legs->R_legs[0], R_legs_xy = of_legs->R_legs[1],
            R_legs_xz = of_legs->R_legs[2], R_legs_yx = of_legs->R_legs[3], R_legs_yy = of_legs->R_legs[4],
            R_legs_yz = of_legs->R_legs[5], R_legs_zx = of_legs->R_legs[6], R_legs_zy = of_legs->R_legs[7],
            R_legs_zz = of_legs->R_legs[8];
        const stewart_real R_legs_xx_err = of_legs->R_legs_err[0], R_legs_xy_err = of_legs->R_legs_err[1],
            R_legs_xz_err = of_legs->R_legs_err[2], R_legs_yx_err = of_legs->R_legs_err[3],
            R_legs_yy_err = of_legs->R_legs_err[4], R_legs_yz_err = of_legs->R_legs_err[5],
            R_legs_zx_err = of_legs->R_legs_err[6], R_legs_zy_err = of_legs->R_legs_err[7],
            R_legs_zz_err = of_legs->R_legs_err[8];
        const stewart_real B_legs_xx = of_legs->B_legs[0], B_legs_xy = of_legs->B_legs[1],
            B_legs_xz = of_legs->B_legs[2], B_legs_yx = of_legs->B_legs[3], B_legs_yy = of_legs->B_legs[4],
            B_legs_yz = of_legs->B_legs[5], B_legs_zx = of_legs->B_legs[6], B_legs_zy = of_legs->B_legs[7],
            B_legs_zz = of_legs->B_legs[8];
        const stewart_real B_legs_xx_err = of_legs->B_legs_err[0], B_legs_xy_err = of_legs->B_legs_err[1],
            B_legs_xz_err = of_legs->B_legs_err[2], B_legs_yx_err = of_legs->B_legs_err[3],
            B_legs_yy_err = of_legs->B_legs_err[4], B_legs_yz_err = of_legs->B_legs_err[5],
            B_legs_zx_err = of_legs->B_legs_err[6], B_legs_zy_err = of_legs->B_legs_err[7],
            B_legs_zz_err = of_legs->B_legs_err[8];
        const stewart_real t_1_legs_x = of_legs->t_1_legs[0], t_1_legs_y = of_legs->t_1_legs[1],
            t_1_legs_z = of_legs->t_1_legs[2];
        const stewart_real t_1_legs_x_err = of_legs->t_1_legs_err[0],
            t_1_legs_y_err = of_legs->t_1_legs_err[1], t_1_legs_z_err = of_legs->t_1_legs_err[2];
        const stewart_real Y_force_x_max = STEWART_FABS(Y_force_x),
            Y_force_y_max = STEWART_FABS(Y_force_y), Y_force_z_max = STEWART_FABS(Y_force_z);
        const stewart_real Y_moment_x_max = STEWART_FABS(Y_moment_x),
            Y_moment_y_max = STEWART_FABS(Y_moment_y), Y_moment_z_max = STEWART_FABS(Y_moment_z);
        const stewart_real R_legs_xx_max = STEWART_FABS(R_legs_xx) + R_legs_xx_err,
            R_legs_xy_max = STEWART_FABS(R_legs_xy) + R_legs_xy_err,
            R_legs_xz_max = STEWART_FABS(R_legs_xz) + R_legs_xz_err,
            R_legs_yx_max = STEWART_FABS(R_legs_yx) + R_legs_yx_err,
            R_legs_yy_max = STEWART_FABS(R_legs_yy) + R_legs_yy_err,
            R_legs_yz_max = STEWART_FABS(R_legs_yz) + R_legs_yz_err,
            R_legs_zx_max = STEWART_FABS(R_legs_zx) + R_legs_zx_err,
            R_legs_zy_max = STEWART_FABS(R_legs_zy) + R_legs_zy_err,
            R_legs_zz_max = STEWART_FABS(R_legs_zz) + R_legs_zz_err;
        const stewart_real t_1_legs_x_max = STEWART_FABS(t_1_legs_x) + t_1_legs_x_err,
            t_1_legs_y_max = STEWART_FABS(t_1_legs_y) + t_1_legs_y_err,
            t_1_legs_z_max = STEWART_FABS(t_1_legs_z) + t_1_legs_z_err;
        const stewart_real load_z_bar = Y_moment_y*t_1_x - Y_force_z - Y_moment_x*t_1_y;
        const stewart_real load_z_bar_err = Y_moment_x_max*t_1_y_err + Y_moment_y_max*t_1_x_err
            + STEWART_UNIT*(Y_force_z_max + REAL(2)*Y_moment_x_max*t_1_y_max + REAL(2)*Y_moment_y_max*t_1_x_max
            + STEWART_FABS(load_z_bar));
        const stewart_real load_z_bar_max = STEWART_FABS(load_z_bar) + load_z_bar_err;
        const stewart_real load_y_bar = Y_moment_x*t_1_z - Y_force_y - Y_moment_z*t_1_x;
        const stewart_real load_y_bar_err = Y_moment_x_max*t_1_z_err + Y_moment_z_max*t_1_x_err
            + STEWART_UNIT*(Y_force_y_max + REAL(2)*Y_moment_x_max*t_1_z_max + REAL(2)*Y_moment_z_max*t_1_x_max
            + STEWART_FABS(load_y_bar));
        const stewart_real load_y_bar_max = STEWART_FABS(load_y_bar) + load_y_bar_err;
        const stewart_real load_x_bar = Y_moment_z*t_1_y - Y_force_x - Y_moment_y*t_1_z;
        const stewart_real load_x_bar_err = Y_moment_y_max*t_1_z_err + Y_moment_z_max*t_1_y_err
            + STEWART_UNIT*(Y_force_x_max + REAL(2)*Y_moment_y_max*t_1_z_max + REAL(2)*Y_moment_z_max*t_1_y_max
            + STEWART_FABS(load_x_bar));
        const stewart_real load_x_bar_max = STEWART_FABS(load_x_bar) + load_x_bar_err;
        const stewart_real t_1_z_bar = Y_moment_x*load_y + t_1_legs_z - Y_moment_y*load_x;
        const stewart_real t_1_z_bar_err = Y_moment_x_max*load_y_err + Y_moment_y_max*load_x_err
            + t_1_legs_z_err + STEWART_UNIT*(REAL(2)*Y_moment_x_max*load_y_max
            + REAL(2)*Y_moment_y_max*load_x_max + t_1_legs_z_max + STEWART_FABS(t_1_z_bar));
        const stewart_real t_1_z_bar_max = STEWART_FABS(t_1_z_bar) + t_1_z_bar_err;
        const stewart_real t_1_y_bar = Y_moment_z*load_x + t_1_legs_y - Y_moment_x*load_z;
        const stewart_real t_1_y_bar_err = Y_moment_x_max*load_z_err + Y_moment_z_max*load_x_err
            + t_1_legs_y_err + STEWART_UNIT*(REAL(2)*Y_moment_x_max*load_z_max
            + REAL(2)*Y_moment_z_max*load_x_max + t_1_legs_y_max + STEWART_FABS(t_1_y_bar));
        const stewart_real t_1_y_bar_max = STEWART_FABS(t_1_y_bar) + t_1_y_bar_err;
        const stewart_real t_1_x_bar = Y_moment_y*load_z + t_1_legs_x - Y_moment_z*load_y;
        const stewart_real t_1_x_bar_err = Y_moment_y_max*load_z_err + Y_moment_z_max*load_y_err
            + t_1_legs_x_err + STEWART_UNIT*(REAL(2)*Y_moment_y_max*load_z_max
            + REAL(2)*Y_moment_z_max*load_y_max + t_1_legs_x_max + STEWART_FABS(t_1_x_bar));
        const stewart_real t_1_x_bar_max = STEWART_FABS(t_1_x_bar) + t_1_x_bar_err;
        const stewart_real M_P_load_z_bar = -R_xz*Y_moment_x - R_yz*Y_moment_y - R_zz*Y_moment_z;
        const stewart_real M_P_load_z_bar_err = R_err*(Y_moment_x_max + Y_moment_y_max + Y_moment_z_max)
            + STEWART_UNIT*(REAL(2)*R_xz_max*Y_moment_x_max + REAL(2)*R_yz_max*Y_moment_y_max
            + REAL(2)*R_zz_max*Y_moment_z_max + STEWART_FABS(M_P_load_z_bar));
        const stewart_real M_P_load_z_bar_max = STEWART_FABS(M_P_load_z_bar) + M_P_load_z_bar_err;
        const stewart_real M_P_load_y_bar = -R_xy*Y_moment_x - R_yy*Y_moment_y - R_zy*Y_moment_z;
        const stewart_real M_P_load_y_bar_err = R_err*(Y_moment_x_max + Y_moment_y_max + Y_moment_z_max)
            + STEWART_UNIT*(REAL(2)*R_xy_max*Y_moment_x_max + REAL(2)*R_yy_max*Y_moment_y_max
            + REAL(2)*R_zy_max*Y_moment_z_max + STEWART_FABS(M_P_load_y_bar));
        const stewart_real M_P_load_y_bar_max = STEWART_FABS(M_P_load_y_bar) + M_P_load_y_bar_err;
        const stewart_real M_P_load_x_bar = -R_xx*Y_moment_x - R_yx*Y_moment_y - R_zx*Y_moment_z;
        const stewart_real M_P_load_x_bar_err = R_err*(Y_moment_x_max + Y_moment_y_max + Y_moment_z_max)
            + STEWART_UNIT*(REAL(2)*R_xx_max*Y_moment_x_max + REAL(2)*R_yx_max*Y_moment_y_max
            + REAL(2)*R_zx_max*Y_moment_z_max + STEWART_FABS(M_P_load_x_bar));
        const stewart_real M_P_load_x_bar_max = STEWART_FABS(M_P_load_x_bar) + M_P_load_x_bar_err;
        const stewart_real c1 = J_P_xz*M_P_load_y_bar;
        const stewart_real c1_err = J_P_xz_err*M_P_load_y_bar_max + J_P_xz_max*M_P_load_y_bar_err
            + STEWART_UNIT*STEWART_FABS(c1);
        const stewart_real c2 = -J_P_yz*M_P_load_x_bar;
        const stewart_real c2_err = J_P_yz_err*M_P_load_x_bar_max + J_P_yz_max*M_P_load_x_bar_err
            + STEWART_UNIT*STEWART_FABS(c2);
        const stewart_real P_zz_bar = -c1 - c2;
        const stewart_real P_zz_bar_err = c1_err + c2_err + STEWART_UNIT*STEWART_FABS(P_zz_bar);
        const stewart_real P_zz_bar_max = STEWART_FABS(P_zz_bar) + P_zz_bar_err;
        const stewart_real c3 = J_P_xy*M_P_load_z_bar;
        const stewart_real c3_err = J_P_xy_err*M_P_load_z_bar_max + J_P_xy_max*M_P_load_z_bar_err
            + STEWART_UNIT*STEWART_FABS(c3);
        const stewart_real P_yy_bar = c2 + c3;
        const stewart_real P_yy_bar_err = c2_err + c3_err + STEWART_UNIT*STEWART_FABS(P_yy_bar);
        const stewart_real P_yy_bar_max = STEWART_FABS(P_yy_bar) + P_yy_bar_err;
        const stewart_real P_xx_bar = c1 - c3;
        const stewart_real P_xx_bar_err = c1_err + c3_err + STEWART_UNIT*STEWART_FABS(P_xx_bar);
        const stewart_real P_xx_bar_max = STEWART_FABS(P_xx_bar) + P_xx_bar_err;
        const stewart_real c4 = J_P_xy*M_P_load_y_bar;
        const stewart_real c4_err = J_P_xy_err*M_P_load_y_bar_max + J_P_xy_max*M_P_load_y_bar_err
            + STEWART_UNIT*STEWART_FABS(c4);
        const stewart_real c4_max = STEWART_FABS(c4) + c4_err;
        const stewart_real c5 = J_P_xz*M_P_load_z_bar;
        const stewart_real c5_err = J_P_xz_err*M_P_load_z_bar_max + J_P_xz_max*M_P_load_z_bar_err
            + STEWART_UNIT*STEWART_FABS(c5);
        const stewart_real c5_max = STEWART_FABS(c5) + c5_err;
        const stewart_real P_yz_bar = c5 - M_P_load_x_bar*dJ_P_x - c4;
        const stewart_real P_yz_bar_err = M_P_load_x_bar_err*dJ_P_x_max + M_P_load_x_bar_max*dJ_P_x_err + c4_err
            + c5_err + STEWART_UNIT*(REAL(2)*M_P_load_x_bar_max*dJ_P_x_max + c4_max + c5_max
            + STEWART_FABS(P_yz_bar));
        const stewart_real P_yz_bar_max = STEWART_FABS(P_yz_bar) + P_yz_bar_err;
        const stewart_real c6 = J_P_yz*M_P_load_z_bar;
        const stewart_real c6_err = J_P_yz_err*M_P_load_z_bar_max + J_P_yz_max*M_P_load_z_bar_err
            + STEWART_UNIT*STEWART_FABS(c6);
        const stewart_real c6_max = STEWART_FABS(c6) + c6_err;
        const stewart_real c7 = J_P_xy*M_P_load_x_bar;
        const stewart_real c7_err = J_P_xy_err*M_P_load_x_bar_max + J_P_xy_max*M_P_load_x_bar_err
            + STEWART_UNIT*STEWART_FABS(c7);
        const stewart_real c7_max = STEWART_FABS(c7) + c7_err;
        const stewart_real P_xz_bar = c7 - M_P_load_y_bar*dJ_P_y - c6;
        const stewart_real P_xz_bar_err = M_P_load_y_bar_err*dJ_P_y_max + M_P_load_y_bar_max*dJ_P_y_err + c6_err
            + c7_err + STEWART_UNIT*(REAL(2)*M_P_load_y_bar_max*dJ_P_y_max + c6_max + c7_max
            + STEWART_FABS(P_xz_bar));
        const stewart_real P_xz_bar_max = STEWART_FABS(P_xz_bar) + P_xz_bar_err;
        const stewart_real c8 = J_P_xz*M_P_load_x_bar;
        const stewart_real c8_err = J_P_xz_err*M_P_load_x_bar_max + J_P_xz_max*M_P_load_x_bar_err
            + STEWART_UNIT*STEWART_FABS(c8);
        const stewart_real c8_max = STEWART_FABS(c8) + c8_err;
        const stewart_real c9 = J_P_yz*M_P_load_y_bar;
        const stewart_real c9_err = J_P_yz_err*M_P_load_y_bar_max + J_P_yz_max*M_P_load_y_bar_err
            + STEWART_UNIT*STEWART_FABS(c9);
        const stewart_real c9_max = STEWART_FABS(c9) + c9_err;
        const stewart_real P_xy_bar = c9 - M_P_load_z_bar*dJ_P_z - c8;
        const stewart_real P_xy_bar_err = M_P_load_z_bar_err*dJ_P_z_max + M_P_load_z_bar_max*dJ_P_z_err + c8_err
            + c9_err + STEWART_UNIT*(REAL(2)*M_P_load_z_bar_max*dJ_P_z_max + c8_max + c9_max
            + STEWART_FABS(P_xy_bar));
        const stewart_real P_xy_bar_max = STEWART_FABS(P_xy_bar) + P_xy_bar_err;
        const stewart_real alpha_P_z_bar = -J_P_zz*M_P_load_z_bar - c8 - c9;
        const stewart_real alpha_P_z_bar_err = J_P_zz_err*M_P_load_z_bar_max + J_P_zz_max*M_P_load_z_bar_err
            + c8_err + c9_err + STEWART_UNIT*(REAL(2)*J_P_zz_max*M_P_load_z_bar_max + c8_max + c9_max
            + STEWART_FABS(alpha_P_z_bar));
        const stewart_real alpha_P_z_bar_max = STEWART_FABS(alpha_P_z_bar) + alpha_P_z_bar_err;
        const stewart_real alpha_P_y_bar = -J_P_yy*M_P_load_y_bar - c6 - c7;
        const stewart_real alpha_P_y_bar_err = J_P_yy_err*M_P_load_y_bar_max + J_P_yy_max*M_P_load_y_bar_err
            + c6_err + c7_err + STEWART_UNIT*(REAL(2)*J_P_yy_max*M_P_load_y_bar_max + c6_max + c7_max
            + STEWART_FABS(alpha_P_y_bar));
        const stewart_real alpha_P_y_bar_max = STEWART_FABS(alpha_P_y_bar) + alpha_P_y_bar_err;
        const stewart_real alpha_P_x_bar = -J_P_xx*M_P_load_x_bar - c4 - c5;
        const stewart_real alpha_P_x_bar_err = J_P_xx_err*M_P_load_x_bar_max + J_P_xx_max*M_P_load_x_bar_err
            + c4_err + c5_err + STEWART_UNIT*(REAL(2)*J_P_xx_max*M_P_load_x_bar_max + c4_max + c5_max
            + STEWART_FABS(alpha_P_x_bar));
        const stewart_real alpha_P_x_bar_max = STEWART_FABS(alpha_P_x_bar) + alpha_P_x_bar_err;
        const stewart_real omega_P_z_bar = P_xz_bar*omega_P_x + P_yz_bar*omega_P_y + REAL(2)*P_zz_bar*omega_P_z;
        const stewart_real omega_P_z_bar_err = P_xz_bar_err*omega_P_x_max + P_xz_bar_max*omega_P_x_err
            + P_yz_bar_err*omega_P_y_max + P_yz_bar_max*omega_P_y_err + REAL(2)*P_zz_bar_err*omega_P_z_max
            + REAL(2)*P_zz_bar_max*omega_P_z_err + STEWART_UNIT*(REAL(2)*P_xz_bar_max*omega_P_x_max
            + REAL(2)*P_yz_bar_max*omega_P_y_max + REAL(4)*P_zz_bar_max*omega_P_z_max
            + STEWART_FABS(omega_P_z_bar));
        const stewart_real omega_P_z_bar_max = STEWART_FABS(omega_P_z_bar) + omega_P_z_bar_err;
        const stewart_real omega_P_y_bar = P_xy_bar*omega_P_x + REAL(2)*P_yy_bar*omega_P_y + P_yz_bar*omega_P_z;
        const stewart_real omega_P_y_bar_err = P_xy_bar_err*omega_P_x_max + P_xy_bar_max*omega_P_x_err
            + REAL(2)*P_yy_bar_err*omega_P_y_max + REAL(2)*P_yy_bar_max*omega_P_y_err
            + P_yz_bar_err*omega_P_z_max + P_yz_bar_max*omega_P_z_err
            + STEWART_UNIT*(REAL(2)*P_xy_bar_max*omega_P_x_max + REAL(4)*P_yy_bar_max*omega_P_y_max
            + REAL(2)*P_yz_bar_max*omega_P_z_max + STEWART_FABS(omega_P_y_bar));
        const stewart_real omega_P_y_bar_max = STEWART_FABS(omega_P_y_bar) + omega_P_y_bar_err;
        const stewart_real omega_P_x_bar = REAL(2)*P_xx_bar*omega_P_x + P_xy_bar*omega_P_y + P_xz_bar*omega_P_z;
        const stewart_real omega_P_x_bar_err = REAL(2)*P_xx_bar_err*omega_P_x_max
            + REAL(2)*P_xx_bar_max*omega_P_x_err + P_xy_bar_err*omega_P_y_max + P_xy_bar_max*omega_P_y_err
            + P_xz_bar_err*omega_P_z_max + P_xz_bar_max*omega_P_z_err
            + STEWART_UNIT*(REAL(4)*P_xx_bar_max*omega_P_x_max + REAL(2)*P_xy_bar_max*omega_P_y_max
            + REAL(2)*P_xz_bar_max*omega_P_z_max + STEWART_FABS(omega_P_x_bar));
        const stewart_real omega_P_x_bar_max = STEWART_FABS(omega_P_x_bar) + omega_P_x_bar_err;
        const stewart_real fall_z_bar = M_P*load_z_bar + Y_moment_y*h_base_x - Y_moment_x*h_base_y;
        const stewart_real fall_z_bar_err = M_P_err*load_z_bar_max + M_P_max*load_z_bar_err
            + Y_moment_x_max*h_base_y_err + Y_moment_y_max*h_base_x_err
            + STEWART_UNIT*(REAL(2)*M_P_max*load_z_bar_max + REAL(2)*Y_moment_x_max*h_base_y_max
            + REAL(2)*Y_moment_y_max*h_base_x_max + STEWART_FABS(fall_z_bar));
        const stewart_real fall_z_bar_max = STEWART_FABS(fall_z_bar) + fall_z_bar_err;
        const stewart_real fall_y_bar = M_P*load_y_bar + Y_moment_x*h_base_z - Y_moment_z*h_base_x;
        const stewart_real fall_y_bar_err = M_P_err*load_y_bar_max + M_P_max*load_y_bar_err
            + Y_moment_x_max*h_base_z_err + Y_moment_z_max*h_base_x_err
            + STEWART_UNIT*(REAL(2)*M_P_max*load_y_bar_max + REAL(2)*Y_moment_x_max*h_base_z_max
            + REAL(2)*Y_moment_z_max*h_base_x_max + STEWART_FABS(fall_y_bar));
        const stewart_real fall_y_bar_max = STEWART_FABS(fall_y_bar) + fall_y_bar_err;
        const stewart_real fall_x_bar = M_P*load_x_bar + Y_moment_z*h_base_y - Y_moment_y*h_base_z;
        const stewart_real fall_x_bar_err = M_P_err*load_x_bar_max + M_P_max*load_x_bar_err
            + Y_moment_y_max*h_base_z_err + Y_moment_z_max*h_base_y_err
            + STEWART_UNIT*(REAL(2)*M_P_max*load_x_bar_max + REAL(2)*Y_moment_y_max*h_base_z_max
            + REAL(2)*Y_moment_z_max*h_base_y_max + STEWART_FABS(fall_x_bar));
        const stewart_real fall_x_bar_max = STEWART_FABS(fall_x_bar) + fall_x_bar_err;
        const stewart_real h_base_z_bar = Y_moment_x*fall_y - B_xz*load_x_bar - B_yz*load_y_bar
            - B_zz*load_z_bar - Y_moment_y*fall_x;
        const stewart_real h_base_z_bar_err = B_xz_err*load_x_bar_max + B_xz_max*load_x_bar_err
            + B_yz_err*load_y_bar_max + B_yz_max*load_y_bar_err + B_zz_err*load_z_bar_max
            + B_zz_max*load_z_bar_err + Y_moment_x_max*fall_y_err + Y_moment_y_max*fall_x_err
            + STEWART_UNIT*(REAL(4)*B_xz_max*load_x_bar_max + REAL(4)*B_yz_max*load_y_bar_max
            + REAL(4)*B_zz_max*load_z_bar_max + REAL(4)*Y_moment_x_max*fall_y_max
            + REAL(4)*Y_moment_y_max*fall_x_max + STEWART_FABS(h_base_z_bar));
        const stewart_real h_base_z_bar_max = STEWART_FABS(h_base_z_bar) + h_base_z_bar_err;
        const stewart_real h_base_y_bar = Y_moment_z*fall_x - B_xy*load_x_bar - B_yy*load_y_bar
            - B_zy*load_z_bar - Y_moment_x*fall_z;
        const stewart_real h_base_y_bar_err = B_xy_err*load_x_bar_max + B_xy_max*load_x_bar_err
            + B_yy_err*load_y_bar_max + B_yy_max*load_y_bar_err + B_zy_err*load_z_bar_max
            + B_zy_max*load_z_bar_err + Y_moment_x_max*fall_z_err + Y_moment_z_max*fall_x_err
            + STEWART_UNIT*(REAL(4)*B_xy_max*load_x_bar_max + REAL(4)*B_yy_max*load_y_bar_max
            + REAL(4)*B_zy_max*load_z_bar_max + REAL(4)*Y_moment_x_max*fall_z_max
            + REAL(4)*Y_moment_z_max*fall_x_max + STEWART_FABS(h_base_y_bar));
        const stewart_real h_base_y_bar_max = STEWART_FABS(h_base_y_bar) + h_base_y_bar_err;
        const stewart_real h_base_x_bar = Y_moment_y*fall_z - B_xx*load_x_bar - B_yx*load_y_bar
            - B_zx*load_z_bar - Y_moment_z*fall_y;
        const stewart_real h_base_x_bar_err = B_xx_err*load_x_bar_max + B_xx_max*load_x_bar_err
            + B_yx_err*load_y_bar_max + B_yx_max*load_y_bar_err + B_zx_err*load_z_bar_max
            + B_zx_max*load_z_bar_err + Y_moment_y_max*fall_z_err + Y_moment_z_max*fall_y_err
            + STEWART_UNIT*(REAL(4)*B_xx_max*load_x_bar_max + REAL(4)*B_yx_max*load_y_bar_max
            + REAL(4)*B_zx_max*load_z_bar_max + REAL(4)*Y_moment_y_max*fall_z_max
            + REAL(4)*Y_moment_z_max*fall_y_max + STEWART_FABS(h_base_x_bar));
        const stewart_real h_base_x_bar_max = STEWART_FABS(h_base_x_bar) + h_base_x_bar_err;
        const stewart_real B_zz_bar = B_legs_zz - h_base_z*load_z_bar;
        const stewart_real B_zz_bar_err = B_legs_zz_err + h_base_z_err*load_z_bar_max
            + h_base_z_max*load_z_bar_err + STEWART_UNIT*(h_base_z_max*load_z_bar_max + STEWART_FABS(B_zz_bar));
        const stewart_real B_zz_bar_max = STEWART_FABS(B_zz_bar) + B_zz_bar_err;
        const stewart_real B_zy_bar = B_legs_zy - h_base_y*load_z_bar;
        const stewart_real B_zy_bar_err = B_legs_zy_err + h_base_y_err*load_z_bar_max
            + h_base_y_max*load_z_bar_err + STEWART_UNIT*(h_base_y_max*load_z_bar_max + STEWART_FABS(B_zy_bar));
        const stewart_real B_zy_bar_max = STEWART_FABS(B_zy_bar) + B_zy_bar_err;
        const stewart_real B_zx_bar = B_legs_zx - h_base_x*load_z_bar;
        const stewart_real B_zx_bar_err = B_legs_zx_err + h_base_x_err*load_z_bar_max
            + h_base_x_max*load_z_bar_err + STEWART_UNIT*(h_base_x_max*load_z_bar_max + STEWART_FABS(B_zx_bar));
        const stewart_real B_zx_bar_max = STEWART_FABS(B_zx_bar) + B_zx_bar_err;
        const stewart_real B_yz_bar = B_legs_yz - h_base_z*load_y_bar;
        const stewart_real B_yz_bar_err = B_legs_yz_err + h_base_z_err*load_y_bar_max
            + h_base_z_max*load_y_bar_err + STEWART_UNIT*(h_base_z_max*load_y_bar_max + STEWART_FABS(B_yz_bar));
        const stewart_real B_yz_bar_max = STEWART_FABS(B_yz_bar) + B_yz_bar_err;
        const stewart_real B_yy_bar = B_legs_yy - h_base_y*load_y_bar;
        const stewart_real B_yy_bar_err = B_legs_yy_err + h_base_y_err*load_y_bar_max
            + h_base_y_max*load_y_bar_err + STEWART_UNIT*(h_base_y_max*load_y_bar_max + STEWART_FABS(B_yy_bar));
        const stewart_real B_yy_bar_max = STEWART_FABS(B_yy_bar) + B_yy_bar_err;
        const stewart_real B_yx_bar = B_legs_yx - h_base_x*load_y_bar;
        const stewart_real B_yx_bar_err = B_legs_yx_err + h_base_x_err*load_y_bar_max
            + h_base_x_max*load_y_bar_err + STEWART_UNIT*(h_base_x_max*load_y_bar_max + STEWART_FABS(B_yx_bar));
        const stewart_real B_yx_bar_max = STEWART_FABS(B_yx_bar) + B_yx_bar_err;
        const stewart_real B_xz_bar = B_legs_xz - h_base_z*load_x_bar;
        const stewart_real B_xz_bar_err = B_legs_xz_err + h_base_z_err*load_x_bar_max
            + h_base_z_max*load_x_bar_err + STEWART_UNIT*(h_base_z_max*load_x_bar_max + STEWART_FABS(B_xz_bar));
        const stewart_real B_xz_bar_max = STEWART_FABS(B_xz_bar) + B_xz_bar_err;
        const stewart_real B_xy_bar = B_legs_xy - h_base_y*load_x_bar;
        const stewart_real B_xy_bar_err = B_legs_xy_err + h_base_y_err*load_x_bar_max
            + h_base_y_max*load_x_bar_err + STEWART_UNIT*(h_base_y_max*load_x_bar_max + STEWART_FABS(B_xy_bar));
        const stewart_real B_xy_bar_max = STEWART_FABS(B_xy_bar) + B_xy_bar_err;
        const stewart_real B_xx_bar = B_legs_xx - h_base_x*load_x_bar;
        const stewart_real B_xx_bar_err = B_legs_xx_err + h_base_x_err*load_x_bar_max
            + h_base_x_max*load_x_bar_err + STEWART_UNIT*(h_base_x_max*load_x_bar_max + STEWART_FABS(B_xx_bar));
        const stewart_real B_xx_bar_max = STEWART_FABS(B_xx_bar) + B_xx_bar_err;
        const stewart_real omega_zz_bar = -B_xx_bar - B_yy_bar;
        const stewart_real omega_zz_bar_err = B_xx_bar_err + B_yy_bar_err
            + STEWART_UNIT*STEWART_FABS(omega_zz_bar);
        const stewart_real omega_zz_bar_max = STEWART_FABS(omega_zz_bar) + omega_zz_bar_err;
        const stewart_real omega_yz_bar = B_yz_bar + B_zy_bar;
        const stewart_real omega_yz_bar_err = B_yz_bar_err + B_zy_bar_err
            + STEWART_UNIT*STEWART_FABS(omega_yz_bar);
        const stewart_real omega_yz_bar_max = STEWART_FABS(omega_yz_bar) + omega_yz_bar_err;
        const stewart_real omega_yy_bar = -B_xx_bar - B_zz_bar;
        const stewart_real omega_yy_bar_err = B_xx_bar_err + B_zz_bar_err
            + STEWART_UNIT*STEWART_FABS(omega_yy_bar);
        const stewart_real omega_yy_bar_max = STEWART_FABS(omega_yy_bar) + omega_yy_bar_err;
        const stewart_real omega_xz_bar = B_xz_bar + B_zx_bar;
        const stewart_real omega_xz_bar_err = B_xz_bar_err + B_zx_bar_err
            + STEWART_UNIT*STEWART_FABS(omega_xz_bar);
        const stewart_real omega_xz_bar_max = STEWART_FABS(omega_xz_bar) + omega_xz_bar_err;
        const stewart_real omega_xy_bar = B_xy_bar + B_yx_bar;
        const stewart_real omega_xy_bar_err = B_xy_bar_err + B_yx_bar_err
            + STEWART_UNIT*STEWART_FABS(omega_xy_bar);
        const stewart_real omega_xy_bar_max = STEWART_FABS(omega_xy_bar) + omega_xy_bar_err;
        const stewart_real omega_xx_bar = -B_yy_bar - B_zz_bar;
        const stewart_real omega_xx_bar_err = B_yy_bar_err + B_zz_bar_err
            + STEWART_UNIT*STEWART_FABS(omega_xx_bar);
        const stewart_real omega_xx_bar_max = STEWART_FABS(omega_xx_bar) + omega_xx_bar_err;
        const stewart_real R_xx_bar = F_ext_x*load_x_bar + R_legs_xx + alpha_P_x_bar*alpha_x
            + h_P_x*h_base_x_bar + omega_P_x_bar*omega_x - M_P_load_x*Y_moment_x;
        const stewart_real R_xx_bar_err = F_ext_x_max*load_x_bar_err + M_P_load_x_err*Y_moment_x_max
            + R_legs_xx_err + alpha_P_x_bar_err*alpha_x_max + h_P_x_err*h_base_x_bar_max
            + h_P_x_max*h_base_x_bar_err + omega_P_x_bar_err*omega_x_max
            + STEWART_UNIT*(REAL(5)*F_ext_x_max*load_x_bar_max + REAL(5)*M_P_load_x_max*Y_moment_x_max
            + REAL(4)*R_legs_xx_max + REAL(5)*alpha_P_x_bar_max*alpha_x_max + REAL(5)*h_P_x_max*h_base_x_bar_max
            + REAL(5)*omega_P_x_bar_max*omega_x_max + STEWART_FABS(R_xx_bar));
        const stewart_real R_xx_bar_max = STEWART_FABS(R_xx_bar) + R_xx_bar_err;
        const stewart_real R_xy_bar = F_ext_y*load_x_bar + R_legs_xy + alpha_P_y_bar*alpha_x
            + h_P_y*h_base_x_bar + omega_P_y_bar*omega_x - M_P_load_y*Y_moment_x;
        const stewart_real R_xy_bar_err = F_ext_y_max*load_x_bar_err + M_P_load_y_err*Y_moment_x_max
            + R_legs_xy_err + alpha_P_y_bar_err*alpha_x_max + h_P_y_err*h_base_x_bar_max
            + h_P_y_max*h_base_x_bar_err + omega_P_y_bar_err*omega_x_max
            + STEWART_UNIT*(REAL(5)*F_ext_y_max*load_x_bar_max + REAL(5)*M_P_load_y_max*Y_moment_x_max
            + REAL(4)*R_legs_xy_max + REAL(5)*alpha_P_y_bar_max*alpha_x_max + REAL(5)*h_P_y_max*h_base_x_bar_max
            + REAL(5)*omega_P_y_bar_max*omega_x_max + STEWART_FABS(R_xy_bar));
        const stewart_real R_xy_bar_max = STEWART_FABS(R_xy_bar) + R_xy_bar_err;
        const stewart_real R_xz_bar = F_ext_z*load_x_bar + R_legs_xz + alpha_P_z_bar*alpha_x
            + h_P_z*h_base_x_bar + omega_P_z_bar*omega_x - M_P_load_z*Y_moment_x;
        const stewart_real R_xz_bar_err = F_ext_z_max*load_x_bar_err + M_P_load_z_err*Y_moment_x_max
            + R_legs_xz_err + alpha_P_z_bar_err*alpha_x_max + h_P_z_err*h_base_x_bar_max
            + h_P_z_max*h_base_x_bar_err + omega_P_z_bar_err*omega_x_max
            + STEWART_UNIT*(REAL(5)*F_ext_z_max*load_x_bar_max + REAL(5)*M_P_load_z_max*Y_moment_x_max
            + REAL(4)*R_legs_xz_max + REAL(5)*alpha_P_z_bar_max*alpha_x_max + REAL(5)*h_P_z_max*h_base_x_bar_max
            + REAL(5)*omega_P_z_bar_max*omega_x_max + STEWART_FABS(R_xz_bar));
        const stewart_real R_xz_bar_max = STEWART_FABS(R_xz_bar) + R_xz_bar_err;
        const stewart_real R_yx_bar = F_ext_x*load_y_bar + R_legs_yx + alpha_P_x_bar*alpha_y
            + h_P_x*h_base_y_bar + omega_P_x_bar*omega_y - M_P_load_x*Y_moment_y;
        const stewart_real R_yx_bar_err = F_ext_x_max*load_y_bar_err + M_P_load_x_err*Y_moment_y_max
            + R_legs_yx_err + alpha_P_x_bar_err*alpha_y_max + h_P_x_err*h_base_y_bar_max
            + h_P_x_max*h_base_y_bar_err + omega_P_x_bar_err*omega_y_max
            + STEWART_UNIT*(REAL(5)*F_ext_x_max*load_y_bar_max + REAL(5)*M_P_load_x_max*Y_moment_y_max
            + REAL(4)*R_legs_yx_max + REAL(5)*alpha_P_x_bar_max*alpha_y_max + REAL(5)*h_P_x_max*h_base_y_bar_max
            + REAL(5)*omega_P_x_bar_max*omega_y_max + STEWART_FABS(R_yx_bar));
        const stewart_real R_yx_bar_max = STEWART_FABS(R_yx_bar) + R_yx_bar_err;
        const stewart_real R_yy_bar = F_ext_y*load_y_bar + R_legs_yy + alpha_P_y_bar*alpha_y
            + h_P_y*h_base_y_bar + omega_P_y_bar*omega_y - M_P_load_y*Y_moment_y;
        const stewart_real R_yy_bar_err = F_ext_y_max*load_y_bar_err + M_P_load_y_err*Y_moment_y_max
            + R_legs_yy_err + alpha_P_y_bar_err*alpha_y_max + h_P_y_err*h_base_y_bar_max
            + h_P_y_max*h_base_y_bar_err + omega_P_y_bar_err*omega_y_max
            + STEWART_UNIT*(REAL(5)*F_ext_y_max*load_y_bar_max + REAL(5)*M_P_load_y_max*Y_moment_y_max
            + REAL(4)*R_legs_yy_max + REAL(5)*alpha_P_y_bar_max*alpha_y_max + REAL(5)*h_P_y_max*h_base_y_bar_max
            + REAL(5)*omega_P_y_bar_max*omega_y_max + STEWART_FABS(R_yy_bar));
        const stewart_real R_yy_bar_max = STEWART_FABS(R_yy_bar) + R_yy_bar_err;
        const stewart_real R_yz_bar = F_ext_z*load_y_bar + R_legs_yz + alpha_P_z_bar*alpha_y
            + h_P_z*h_base_y_bar + omega_P_z_bar*omega_y - M_P_load_z*Y_moment_y;
        const stewart_real R_yz_bar_err = F_ext_z_max*load_y_bar_err + M_P_load_z_err*Y_moment_y_max
            + R_legs_yz_err + alpha_P_z_bar_err*alpha_y_max + h_P_z_err*h_base_y_bar_max
            + h_P_z_max*h_base_y_bar_err + omega_P_z_bar_err*omega_y_max
            + STEWART_UNIT*(REAL(5)*F_ext_z_max*load_y_bar_max + REAL(5)*M_P_load_z_max*Y_moment_y_max
            + REAL(4)*R_legs_yz_max + REAL(5)*alpha_P_z_bar_max*alpha_y_max + REAL(5)*h_P_z_max*h_base_y_bar_max
            + REAL(5)*omega_P_z_bar_max*omega_y_max + STEWART_FABS(R_yz_bar));
        const stewart_real R_yz_bar_max = STEWART_FABS(R_yz_bar) + R_yz_bar_err;
        const stewart_real R_zx_bar = F_ext_x*load_z_bar + R_legs_zx + alpha_P_x_bar*alpha_z
            + h_P_x*h_base_z_bar + omega_P_x_bar*omega_z - M_P_load_x*Y_moment_z;
        const stewart_real R_zx_bar_err = F_ext_x_max*load_z_bar_err + M_P_load_x_err*Y_moment_z_max
            + R_legs_zx_err + alpha_P_x_bar_err*alpha_z_max + h_P_x_err*h_base_z_bar_max
            + h_P_x_max*h_base_z_bar_err + omega_P_x_bar_err*omega_z_max
            + STEWART_UNIT*(REAL(5)*F_ext_x_max*load_z_bar_max + REAL(5)*M_P_load_x_max*Y_moment_z_max
            + REAL(4)*R_legs_zx_max + REAL(5)*alpha_P_x_bar_max*alpha_z_max + REAL(5)*h_P_x_max*h_base_z_bar_max
            + REAL(5)*omega_P_x_bar_max*omega_z_max + STEWART_FABS(R_zx_bar));
        const stewart_real R_zx_bar_max = STEWART_FABS(R_zx_bar) + R_zx_bar_err;
        const stewart_real R_zy_bar = F_ext_y*load_z_bar + R_legs_zy + alpha_P_y_bar*alpha_z
            + h_P_y*h_base_z_bar + omega_P_y_bar*omega_z - M_P_load_y*Y_moment_z;
        const stewart_real R_zy_bar_err = F_ext_y_max*load_z_bar_err + M_P_load_y_err*Y_moment_z_max
            + R_legs_zy_err + alpha_P_y_bar_err*alpha_z_max + h_P_y_err*h_base_z_bar_max
            + h_P_y_max*h_base_z_bar_err + omega_P_y_bar_err*omega_z_max
            + STEWART_UNIT*(REAL(5)*F_ext_y_max*load_z_bar_max + REAL(5)*M_P_load_y_max*Y_moment_z_max
            + REAL(4)*R_legs_zy_max + REAL(5)*alpha_P_y_bar_max*alpha_z_max + REAL(5)*h_P_y_max*h_base_z_bar_max
            + REAL(5)*omega_P_y_bar_max*omega_z_max + STEWART_FABS(R_zy_bar));
        const stewart_real R_zy_bar_max = STEWART_FABS(R_zy_bar) + R_zy_bar_err;
        const stewart_real R_zz_bar = F_ext_z*load_z_bar + R_legs_zz + alpha_P_z_bar*alpha_z
            + h_P_z*h_base_z_bar + omega_P_z_bar*omega_z - M_P_load_z*Y_moment_z;
        const stewart_real R_zz_bar_err = F_ext_z_max*load_z_bar_err + M_P_load_z_err*Y_moment_z_max
            + R_legs_zz_err + alpha_P_z_bar_err*alpha_z_max + h_P_z_err*h_base_z_bar_max
            + h_P_z_max*h_base_z_bar_err + omega_P_z_bar_err*omega_z_max
            + STEWART_UNIT*(REAL(5)*F_ext_z_max*load_z_bar_max + REAL(5)*M_P_load_z_max*Y_moment_z_max
            + REAL(4)*R_legs_zz_max + REAL(5)*alpha_P_z_bar_max*alpha_z_max + REAL(5)*h_P_z_max*h_base_z_bar_max
            + REAL(5)*omega_P_z_bar_max*omega_z_max + STEWART_FABS(R_zz_bar));
        const stewart_real R_zz_bar_max = STEWART_FABS(R_zz_bar) + R_zz_bar_err;
        const stewart_real M_P_bar = fall_x*load_x_bar + fall_y*load_y_bar + fall_z*load_z_bar;
        const stewart_real M_P_bar_err = fall_x_err*load_x_bar_max + fall_x_max*load_x_bar_err
            + fall_y_err*load_y_bar_max + fall_y_max*load_y_bar_err + fall_z_err*load_z_bar_max
            + fall_z_max*load_z_bar_err + STEWART_UNIT*(REAL(2)*fall_x_max*load_x_bar_max
            + REAL(2)*fall_y_max*load_y_bar_max + REAL(2)*fall_z_max*load_z_bar_max + STEWART_FABS(M_P_bar));
        const stewart_real M_P_bar_max = STEWART_FABS(M_P_bar) + M_P_bar_err;
        const stewart_real h_P_x_bar = R_xx*h_base_x_bar + R_yx*h_base_y_bar + R_zx*h_base_z_bar;
        const stewart_real h_P_x_bar_err = R_err*(h_base_x_bar_max + h_base_y_bar_max + h_base_z_bar_max)
            + R_xx_max*h_base_x_bar_err + R_yx_max*h_base_y_bar_err + R_zx_max*h_base_z_bar_err
            + STEWART_UNIT*(REAL(2)*R_xx_max*h_base_x_bar_max + REAL(2)*R_yx_max*h_base_y_bar_max
            + REAL(2)*R_zx_max*h_base_z_bar_max + STEWART_FABS(h_P_x_bar));
        const stewart_real h_P_x_bar_max = STEWART_FABS(h_P_x_bar) + h_P_x_bar_err;
        const stewart_real h_P_y_bar = R_xy*h_base_x_bar + R_yy*h_base_y_bar + R_zy*h_base_z_bar;
        const stewart_real h_P_y_bar_err = R_err*(h_base_x_bar_max + h_base_y_bar_max + h_base_z_bar_max)
            + R_xy_max*h_base_x_bar_err + R_yy_max*h_base_y_bar_err + R_zy_max*h_base_z_bar_err
            + STEWART_UNIT*(REAL(2)*R_xy_max*h_base_x_bar_max + REAL(2)*R_yy_max*h_base_y_bar_max
            + REAL(2)*R_zy_max*h_base_z_bar_max + STEWART_FABS(h_P_y_bar));
        const stewart_real h_P_y_bar_max = STEWART_FABS(h_P_y_bar) + h_P_y_bar_err;
        const stewart_real h_P_z_bar = R_xz*h_base_x_bar + R_yz*h_base_y_bar + R_zz*h_base_z_bar;
        const stewart_real h_P_z_bar_err = R_err*(h_base_x_bar_max + h_base_y_bar_max + h_base_z_bar_max)
            + R_xz_max*h_base_x_bar_err + R_yz_max*h_base_y_bar_err + R_zz_max*h_base_z_bar_err
            + STEWART_UNIT*(REAL(2)*R_xz_max*h_base_x_bar_max + REAL(2)*R_yz_max*h_base_y_bar_max
            + REAL(2)*R_zz_max*h_base_z_bar_max + STEWART_FABS(h_P_z_bar));
        const stewart_real h_P_z_bar_max = STEWART_FABS(h_P_z_bar) + h_P_z_bar_err;
        const stewart_real J_P_xx_bar = -M_P_load_x_bar*alpha_P_x;
        const stewart_real J_P_xx_bar_err = M_P_load_x_bar_err*alpha_P_x_max + M_P_load_x_bar_max*alpha_P_x_err
            + STEWART_UNIT*STEWART_FABS(J_P_xx_bar);
        const stewart_real J_P_xx_bar_max = STEWART_FABS(J_P_xx_bar) + J_P_xx_bar_err;
        const stewart_real J_P_xy_bar = M_P_load_x_bar*(P_xz - alpha_P_y) + M_P_load_y_bar*(-P_yz - alpha_P_x)
            + M_P_load_z_bar*(P_yy - P_xx);
        const stewart_real J_P_xy_bar_err = M_P_load_x_bar_err*(P_xz_max + alpha_P_y_max)
            + M_P_load_x_bar_max*P_xz_err + M_P_load_x_bar_max*alpha_P_y_err + M_P_load_y_bar_err*(P_yz_max
            + alpha_P_x_max) + M_P_load_y_bar_max*P_yz_err + M_P_load_y_bar_max*alpha_P_x_err
            + M_P_load_z_bar_err*(P_xx_max + P_yy_max) + M_P_load_z_bar_max*P_xx_err
            + M_P_load_z_bar_max*P_yy_err + STEWART_UNIT*(REAL(3)*M_P_load_x_bar_max*(P_xz_max + alpha_P_y_max)
            + REAL(3)*M_P_load_y_bar_max*(P_yz_max + alpha_P_x_max) + REAL(3)*M_P_load_z_bar_max*(P_xx_max
            + P_yy_max) + STEWART_FABS(J_P_xy_bar));
        const stewart_real J_P_xy_bar_max = STEWART_FABS(J_P_xy_bar) + J_P_xy_bar_err;
        const stewart_real J_P_xz_bar = M_P_load_x_bar*(-P_xy - alpha_P_z) + M_P_load_y_bar*(P_xx - P_zz)
            + M_P_load_z_bar*(P_yz - alpha_P_x);
        const stewart_real J_P_xz_bar_err = M_P_load_x_bar_err*(P_xy_max + alpha_P_z_max)
            + M_P_load_x_bar_max*P_xy_err + M_P_load_x_bar_max*alpha_P_z_err + M_P_load_y_bar_err*(P_xx_max
            + P_zz_max) + M_P_load_y_bar_max*P_xx_err + M_P_load_y_bar_max*P_zz_err
            + M_P_load_z_bar_err*(P_yz_max + alpha_P_x_max) + M_P_load_z_bar_max*P_yz_err
            + M_P_load_z_bar_max*alpha_P_x_err + STEWART_UNIT*(REAL(3)*M_P_load_x_bar_max*(P_xy_max
            + alpha_P_z_max) + REAL(3)*M_P_load_y_bar_max*(P_xx_max + P_zz_max)
            + REAL(3)*M_P_load_z_bar_max*(P_yz_max + alpha_P_x_max) + STEWART_FABS(J_P_xz_bar));
        const stewart_real J_P_xz_bar_max = STEWART_FABS(J_P_xz_bar) + J_P_xz_bar_err;
        const stewart_real J_P_yy_bar = -M_P_load_y_bar*alpha_P_y;
        const stewart_real J_P_yy_bar_err = M_P_load_y_bar_err*alpha_P_y_max + M_P_load_y_bar_max*alpha_P_y_err
            + STEWART_UNIT*STEWART_FABS(J_P_yy_bar);
        const stewart_real J_P_yy_bar_max = STEWART_FABS(J_P_yy_bar) + J_P_yy_bar_err;
        const stewart_real J_P_yz_bar = M_P_load_x_bar*(P_zz - P_yy) + M_P_load_y_bar*(P_xy - alpha_P_z)
            + M_P_load_z_bar*(-P_xz - alpha_P_y);
        const stewart_real J_P_yz_bar_err = M_P_load_x_bar_err*(P_yy_max + P_zz_max)
            + M_P_load_x_bar_max*P_yy_err + M_P_load_x_bar_max*P_zz_err + M_P_load_y_bar_err*(P_xy_max
            + alpha_P_z_max) + M_P_load_y_bar_max*P_xy_err + M_P_load_y_bar_max*alpha_P_z_err
            + M_P_load_z_bar_err*(P_xz_max + alpha_P_y_max) + M_P_load_z_bar_max*P_xz_err
            + M_P_load_z_bar_max*alpha_P_y_err + STEWART_UNIT*(REAL(3)*M_P_load_x_bar_max*(P_yy_max + P_zz_max)
            + REAL(3)*M_P_load_y_bar_max*(P_xy_max + alpha_P_z_max) + REAL(3)*M_P_load_z_bar_max*(P_xz_max
            + alpha_P_y_max) + STEWART_FABS(J_P_yz_bar));
        const stewart_real J_P_yz_bar_max = STEWART_FABS(J_P_yz_bar) + J_P_yz_bar_err;
        const stewart_real J_P_zz_bar = -M_P_load_z_bar*alpha_P_z;
        const stewart_real J_P_zz_bar_err = M_P_load_z_bar_err*alpha_P_z_max + M_P_load_z_bar_max*alpha_P_z_err
            + STEWART_UNIT*STEWART_FABS(J_P_zz_bar);
        const stewart_real J_P_zz_bar_max = STEWART_FABS(J_P_zz_bar) + J_P_zz_bar_err;
        const stewart_real dJ_P_x_bar = -M_P_load_x_bar*P_yz;
        const stewart_real dJ_P_x_bar_err = M_P_load_x_bar_err*P_yz_max + M_P_load_x_bar_max*P_yz_err
            + STEWART_UNIT*STEWART_FABS(dJ_P_x_bar);
        const stewart_real dJ_P_x_bar_max = STEWART_FABS(dJ_P_x_bar) + dJ_P_x_bar_err;
        const stewart_real dJ_P_y_bar = -M_P_load_y_bar*P_xz;
        const stewart_real dJ_P_y_bar_err = M_P_load_y_bar_err*P_xz_max + M_P_load_y_bar_max*P_xz_err
            + STEWART_UNIT*STEWART_FABS(dJ_P_y_bar);
        const stewart_real dJ_P_y_bar_max = STEWART_FABS(dJ_P_y_bar) + dJ_P_y_bar_err;
        const stewart_real dJ_P_z_bar = -M_P_load_z_bar*P_xy;
        const stewart_real dJ_P_z_bar_err = M_P_load_z_bar_err*P_xy_max + M_P_load_z_bar_max*P_xy_err
            + STEWART_UNIT*STEWART_FABS(dJ_P_z_bar);
        const stewart_real dJ_P_z_bar_max = STEWART_FABS(dJ_P_z_bar) + dJ_P_z_bar_err;
        const stewart_real C_P_bar = Y_moment_x*omega_x + Y_moment_y*omega_y + Y_moment_z*omega_z;
        const stewart_real C_P_bar_err = STEWART_UNIT*(REAL(2)*Y_moment_x_max*omega_x_max
            + REAL(2)*Y_moment_y_max*omega_y_max + REAL(2)*Y_moment_z_max*omega_z_max + STEWART_FABS(C_P_bar));
        const stewart_real C_P_bar_max = STEWART_FABS(C_P_bar) + C_P_bar_err;
        error[i] = error[i] + R_xx_bar_max*R_err + R_xy_bar_max*R_err + R_xz_bar_max*R_err
            + R_yx_bar_max*R_err + R_yy_bar_max*R_err + R_yz_bar_max*R_err + R_zx_bar_max*R_err
            + R_zy_bar_max*R_err + R_zz_bar_max*R_err + M_P_bar_max*M_P_err + h_P_x_bar_max*h_P_x_err
            + h_P_y_bar_max*h_P_y_err + h_P_z_bar_max*h_P_z_err + J_P_xx_bar_max*J_P_xx_err
            + J_P_xy_bar_max*J_P_xy_err + J_P_xz_bar_max*J_P_xz_err + J_P_yy_bar_max*J_P_yy_err
            + J_P_yz_bar_max*J_P_yz_err + J_P_zz_bar_max*J_P_zz_err + dJ_P_x_bar_max*dJ_P_x_err
            + dJ_P_y_bar_max*dJ_P_y_err + dJ_P_z_bar_max*dJ_P_z_err + C_P_bar_max*C_P_err
            + omega_xx_bar_max*omega_xx_own + omega_xy_bar_max*omega_xy_own + omega_xz_bar_max*omega_xz_own
            + omega_yy_bar_max*omega_yy_own + omega_yz_bar_max*omega_yz_own + omega_zz_bar_max*omega_zz_own
            + B_xx_bar_max*B_xx_own + B_xy_bar_max*B_xy_own + B_xz_bar_max*B_xz_own + B_yx_bar_max*B_yx_own
            + B_yy_bar_max*B_yy_own + B_yz_bar_max*B_yz_own + B_zx_bar_max*B_zx_own + B_zy_bar_max*B_zy_own
            + B_zz_bar_max*B_zz_own + h_base_x_bar_max*h_base_x_own + h_base_y_bar_max*h_base_y_own
            + h_base_z_bar_max*h_base_z_own + fall_x_bar_max*fall_x_own + fall_y_bar_max*fall_y_own
            + fall_z_bar_max*fall_z_own + omega_P_x_bar_max*omega_P_x_own + omega_P_y_bar_max*omega_P_y_own
            + omega_P_z_bar_max*omega_P_z_own + alpha_P_x_bar_max*alpha_P_x_own
            + alpha_P_y_bar_max*alpha_P_y_own + alpha_P_z_bar_max*alpha_P_z_own + P_xy_bar_max*P_xy_own
            + P_xz_bar_max*P_xz_own + P_yz_bar_max*P_yz_own + P_xx_bar_max*P_xx_own + P_yy_bar_max*P_yy_own
            + P_zz_bar_max*P_zz_own + M_P_load_x_bar_max*M_P_load_x_own + M_P_load_y_bar_max*M_P_load_y_own
            + M_P_load_z_bar_max*M_P_load_z_own + t_1_x_bar_max*t_1_x_own + t_1_y_bar_max*t_1_y_own
            + t_1_z_bar_max*t_1_z_own + load_x_bar_max*load_x_own + load_y_bar_max*load_y_own
            + load_z_bar_max*load_z_own + Y_moment_x_max*c_moment_x_own + Y_moment_y_max*c_moment_y_own
            + Y_moment_z_max*c_moment_z_own;
    }
}

/* One leg with its errors. Adds to the error of each force what they do to it, and to its slopes along what
 * the pose has for all legs. */
static void leg_errors(
    const stewart_exact_bounds_platform *platform, const stewart_exact_bounds_leg *leg,
    const stewart_motions *at, const shared_terms *shared, stewart_real R_err, const force_row rows[6],
    slopes_of_legs slopes[6], stewart_real error[6], leg_terms *out)
{
    int i;
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = leg->k[0], k_y = leg->k[1], k_z = leg->k[2];
    const stewart_real k_x_err = leg->k_err[0], k_y_err = leg->k_err[1], k_z_err = leg->k_err[2];
    const stewart_real C_p = leg->C_p;
    const stewart_real C_s = leg->C_s;
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
    const stewart_real g_x_k_x_err = leg->g_x_k_err[0], g_x_k_y_err = leg->g_x_k_err[1],
        g_x_k_z_err = leg->g_x_k_err[2];
    const stewart_real C_us = leg->C_us;
    const stewart_real C_us_err = leg->C_us_err;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real B_xx = shared->B[0], B_xy = shared->B[1], B_xz = shared->B[2],
        B_yx = shared->B[3], B_yy = shared->B[4], B_yz = shared->B[5], B_zx = shared->B[6],
        B_zy = shared->B[7], B_zz = shared->B[8];
    const stewart_real B_xx_err = shared->B_err[0], B_xy_err = shared->B_err[1],
        B_xz_err = shared->B_err[2], B_yx_err = shared->B_err[3], B_yy_err = shared->B_err[4],
        B_yz_err = shared->B_err[5], B_zx_err = shared->B_err[6], B_zy_err = shared->B_err[7],
        B_zz_err = shared->B_err[8];
    const stewart_real g_x = platform->g[0], g_y = platform->g[1], g_z = platform->g[2];
    const stewart_real t_1_x = shared->t_1[0], t_1_y = shared->t_1[1], t_1_z = shared->t_1[2];
    const stewart_real t_1_x_err = shared->t_1_err[0], t_1_y_err = shared->t_1_err[1],
        t_1_z_err = shared->t_1_err[2];
    const stewart_real r_x = leg->r[0], r_y = leg->r[1], r_z = leg->r[2];
    const stewart_real r_x_err = leg->r_err[0], r_y_err = leg->r_err[1], r_z_err = leg->r_err[2];
    const stewart_real p_x_max = STEWART_FABS(p_x), p_y_max = STEWART_FABS(p_y),
        p_z_max = STEWART_FABS(p_z);
    const stewart_real k_x_max = STEWART_FABS(k_x) + k_x_err, k_y_max = STEWART_FABS(k_y) + k_y_err,
        k_z_max = STEWART_FABS(k_z) + k_z_err;
    const stewart_real C_p_max = STEWART_FABS(C_p);
    const stewart_real C_s_max = STEWART_FABS(C_s);
    const stewart_real h_x_max = STEWART_FABS(h_x) + h_x_err, h_y_max = STEWART_FABS(h_y) + h_y_err,
        h_z_max = STEWART_FABS(h_z) + h_z_err;
    const stewart_real h2_x_max = STEWART_FABS(h2_x) + h2_x_err;
    const stewart_real h2_y_max = STEWART_FABS(h2_y) + h2_y_err;
    const stewart_real h2_z_max = STEWART_FABS(h2_z) + h2_z_err;
    const stewart_real w_x_max = STEWART_FABS(w_x) + w_x_err, w_y_max = STEWART_FABS(w_y) + w_y_err,
        w_z_max = STEWART_FABS(w_z) + w_z_err;
    const stewart_real J_xx_max = STEWART_FABS(J_xx) + J_xx_err,
        J_yz_max = STEWART_FABS(J_yz) + J_yz_err;
    const stewart_real g_k_max = STEWART_FABS(g_k) + g_k_err;
    const stewart_real g_x_k_x_max = STEWART_FABS(g_x_k_x) + g_x_k_x_err,
        g_x_k_y_max = STEWART_FABS(g_x_k_y) + g_x_k_y_err,
        g_x_k_z_max = STEWART_FABS(g_x_k_z) + g_x_k_z_err;
    const stewart_real C_us_max = STEWART_FABS(C_us) + C_us_err;
    const stewart_real R_xx_max = STEWART_FABS(R_xx) + R_err, R_xy_max = STEWART_FABS(R_xy) + R_err,
        R_xz_max = STEWART_FABS(R_xz) + R_err, R_yx_max = STEWART_FABS(R_yx) + R_err,
        R_yy_max = STEWART_FABS(R_yy) + R_err, R_yz_max = STEWART_FABS(R_yz) + R_err,
        R_zx_max = STEWART_FABS(R_zx) + R_err, R_zy_max = STEWART_FABS(R_zy) + R_err,
        R_zz_max = STEWART_FABS(R_zz) + R_err;
    const stewart_real omega_x_max = STEWART_FABS(omega_x), omega_y_max = STEWART_FABS(omega_y),
        omega_z_max = STEWART_FABS(omega_z);
    const stewart_real v_x_max = STEWART_FABS(v_x), v_y_max = STEWART_FABS(v_y),
        v_z_max = STEWART_FABS(v_z);
    const stewart_real a_x_max = STEWART_FABS(a_x), a_y_max = STEWART_FABS(a_y),
        a_z_max = STEWART_FABS(a_z);
    const stewart_real B_xx_max = STEWART_FABS(B_xx) + B_xx_err,
        B_xy_max = STEWART_FABS(B_xy) + B_xy_err, B_xz_max = STEWART_FABS(B_xz) + B_xz_err,
        B_yx_max = STEWART_FABS(B_yx) + B_yx_err, B_yy_max = STEWART_FABS(B_yy) + B_yy_err,
        B_yz_max = STEWART_FABS(B_yz) + B_yz_err, B_zx_max = STEWART_FABS(B_zx) + B_zx_err,
        B_zy_max = STEWART_FABS(B_zy) + B_zy_err, B_zz_max = STEWART_FABS(B_zz) + B_zz_err;
    const stewart_real g_x_max = STEWART_FABS(g_x), g_y_max = STEWART_FABS(g_y),
        g_z_max = STEWART_FABS(g_z);
    const stewart_real r_x_max = STEWART_FABS(r_x) + r_x_err, r_y_max = STEWART_FABS(r_y) + r_y_err,
        r_z_max = STEWART_FABS(r_z) + r_z_err;
    /* (1) platform point from the reference point */
    const stewart_real q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z;
    const stewart_real q_x_own = STEWART_UNIT*(REAL(2)*R_xx_max*p_x_max + REAL(2)*R_xy_max*p_y_max
        + REAL(2)*R_xz_max*p_z_max + STEWART_FABS(q_x));
    const stewart_real q_x_err = R_err*(p_x_max + p_y_max + p_z_max) + q_x_own;
    const stewart_real q_x_max = STEWART_FABS(q_x) + q_x_err;
    const stewart_real q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z;
    const stewart_real q_y_own = STEWART_UNIT*(REAL(2)*R_yx_max*p_x_max + REAL(2)*R_yy_max*p_y_max
        + REAL(2)*R_yz_max*p_z_max + STEWART_FABS(q_y));
    const stewart_real q_y_err = R_err*(p_x_max + p_y_max + p_z_max) + q_y_own;
    const stewart_real q_y_max = STEWART_FABS(q_y) + q_y_err;
    const stewart_real q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z;
    const stewart_real q_z_own = STEWART_UNIT*(REAL(2)*R_zx_max*p_x_max + REAL(2)*R_zy_max*p_y_max
        + REAL(2)*R_zz_max*p_z_max + STEWART_FABS(q_z));
    const stewart_real q_z_err = R_err*(p_x_max + p_y_max + p_z_max) + q_z_own;
    const stewart_real q_z_max = STEWART_FABS(q_z) + q_z_err;
    /* (1) platform point from base point 1, base frame */
    const stewart_real S_1_x = q_x + t_1_x;
    const stewart_real S_1_x_own = STEWART_UNIT*STEWART_FABS(S_1_x);
    const stewart_real S_1_x_err = q_x_err + t_1_x_err + S_1_x_own;
    const stewart_real S_1_x_max = STEWART_FABS(S_1_x) + S_1_x_err;
    const stewart_real S_1_y = q_y + t_1_y;
    const stewart_real S_1_y_own = STEWART_UNIT*STEWART_FABS(S_1_y);
    const stewart_real S_1_y_err = q_y_err + t_1_y_err + S_1_y_own;
    const stewart_real S_1_y_max = STEWART_FABS(S_1_y) + S_1_y_err;
    const stewart_real S_1_z = q_z + t_1_z;
    const stewart_real S_1_z_own = STEWART_UNIT*STEWART_FABS(S_1_z);
    const stewart_real S_1_z_err = q_z_err + t_1_z_err + S_1_z_own;
    const stewart_real S_1_z_max = STEWART_FABS(S_1_z) + S_1_z_err;
    /* (1) leg vector */
    const stewart_real S_x = S_1_x - r_x;
    const stewart_real S_x_own = STEWART_UNIT*STEWART_FABS(S_x);
    const stewart_real S_x_err = S_1_x_err + r_x_err + S_x_own;
    const stewart_real S_x_max = STEWART_FABS(S_x) + S_x_err;
    const stewart_real S_y = S_1_y - r_y;
    const stewart_real S_y_own = STEWART_UNIT*STEWART_FABS(S_y);
    const stewart_real S_y_err = S_1_y_err + r_y_err + S_y_own;
    const stewart_real S_y_max = STEWART_FABS(S_y) + S_y_err;
    const stewart_real S_z = S_1_z - r_z;
    const stewart_real S_z_own = STEWART_UNIT*STEWART_FABS(S_z);
    const stewart_real S_z_err = S_1_z_err + r_z_err + S_z_own;
    const stewart_real S_z_max = STEWART_FABS(S_z) + S_z_err;
    /* (10) leg vector along the fixed axis, and normal to both */
    const stewart_real zeta = S_x*k_x + S_y*k_y + S_z*k_z;
    const stewart_real zeta_own = STEWART_UNIT*(REAL(2)*S_x_max*k_x_max + REAL(2)*S_y_max*k_y_max
        + REAL(2)*S_z_max*k_z_max + STEWART_FABS(zeta));
    const stewart_real zeta_err = S_x_err*k_x_max + S_x_max*k_x_err + S_y_err*k_y_max + S_y_max*k_y_err
        + S_z_err*k_z_max + S_z_max*k_z_err + zeta_own;
    const stewart_real zeta_max = STEWART_FABS(zeta) + zeta_err;
    const stewart_real k_cross_S_x = S_z*k_y - S_y*k_z;
    const stewart_real k_cross_S_x_own = STEWART_UNIT*(S_y_max*k_z_max + S_z_max*k_y_max
        + STEWART_FABS(k_cross_S_x));
    const stewart_real k_cross_S_x_err = S_y_err*k_z_max + S_y_max*k_z_err + S_z_err*k_y_max
        + S_z_max*k_y_err + k_cross_S_x_own;
    const stewart_real k_cross_S_x_max = STEWART_FABS(k_cross_S_x) + k_cross_S_x_err;
    const stewart_real k_cross_S_y = S_x*k_z - S_z*k_x;
    const stewart_real k_cross_S_y_own = STEWART_UNIT*(S_x_max*k_z_max + S_z_max*k_x_max
        + STEWART_FABS(k_cross_S_y));
    const stewart_real k_cross_S_y_err = S_x_err*k_z_max + S_x_max*k_z_err + S_z_err*k_x_max
        + S_z_max*k_x_err + k_cross_S_y_own;
    const stewart_real k_cross_S_y_max = STEWART_FABS(k_cross_S_y) + k_cross_S_y_err;
    const stewart_real k_cross_S_z = S_y*k_x - S_x*k_y;
    const stewart_real k_cross_S_z_own = STEWART_UNIT*(S_x_max*k_y_max + S_y_max*k_x_max
        + STEWART_FABS(k_cross_S_z));
    const stewart_real k_cross_S_z_err = S_x_err*k_y_max + S_x_max*k_y_err + S_y_err*k_x_max
        + S_y_max*k_x_err + k_cross_S_z_own;
    const stewart_real k_cross_S_z_max = STEWART_FABS(k_cross_S_z) + k_cross_S_z_err;
    const stewart_real rho2 = k_cross_S_x*k_cross_S_x + k_cross_S_y*k_cross_S_y + k_cross_S_z*k_cross_S_z;
    const stewart_real rho2_own = STEWART_UNIT*(REAL(2)*k_cross_S_x_max*k_cross_S_x_max
        + REAL(2)*k_cross_S_y_max*k_cross_S_y_max + REAL(2)*k_cross_S_z_max*k_cross_S_z_max
        + STEWART_FABS(rho2));
    const stewart_real rho2_err = REAL(2)*k_cross_S_x_err*k_cross_S_x_max
        + REAL(2)*k_cross_S_y_err*k_cross_S_y_max + REAL(2)*k_cross_S_z_err*k_cross_S_z_max + rho2_own;
    const stewart_real rho2_max = STEWART_FABS(rho2) + rho2_err;
    /* (2) leg length, and distance of its tip from the fixed axis */
    const stewart_real L = STEWART_SQRT(rho2 + zeta*zeta);
    const stewart_real L_own = root_error(L, STEWART_UNIT*(rho2_max + REAL(2)*zeta_max*zeta_max));
    const stewart_real L_err = root_error(L, rho2_err + REAL(2)*zeta_err*zeta_max + STEWART_UNIT*(rho2_max
        + REAL(2)*zeta_max*zeta_max));
    const stewart_real L_max = STEWART_FABS(L) + L_err;
    const stewart_real rho = STEWART_SQRT(rho2);
    const stewart_real rho_own = root_error(rho, 0);
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
    const stewart_real S_dot_x = omega_y*q_z + v_x - omega_z*q_y;
    const stewart_real S_dot_x_own = STEWART_UNIT*(REAL(2)*omega_y_max*q_z_max + REAL(2)*omega_z_max*q_y_max
        + v_x_max + STEWART_FABS(S_dot_x));
    const stewart_real S_dot_x_err = omega_y_max*q_z_err + omega_z_max*q_y_err + S_dot_x_own;
    const stewart_real S_dot_x_max = STEWART_FABS(S_dot_x) + S_dot_x_err;
    const stewart_real S_dot_y = omega_z*q_x + v_y - omega_x*q_z;
    const stewart_real S_dot_y_own = STEWART_UNIT*(REAL(2)*omega_x_max*q_z_max + REAL(2)*omega_z_max*q_x_max
        + v_y_max + STEWART_FABS(S_dot_y));
    const stewart_real S_dot_y_err = omega_x_max*q_z_err + omega_z_max*q_x_err + S_dot_y_own;
    const stewart_real S_dot_y_max = STEWART_FABS(S_dot_y) + S_dot_y_err;
    const stewart_real S_dot_z = omega_x*q_y + v_z - omega_y*q_x;
    const stewart_real S_dot_z_own = STEWART_UNIT*(REAL(2)*omega_x_max*q_y_max + REAL(2)*omega_y_max*q_x_max
        + v_z_max + STEWART_FABS(S_dot_z));
    const stewart_real S_dot_z_err = omega_x_max*q_y_err + omega_y_max*q_x_err + S_dot_z_own;
    const stewart_real S_dot_z_max = STEWART_FABS(S_dot_z) + S_dot_z_err;
    /* (7) acceleration of the platform point */
    const stewart_real S_ddot_x = B_xx*q_x + B_xy*q_y + B_xz*q_z + a_x;
    const stewart_real S_ddot_x_own = STEWART_UNIT*(REAL(3)*B_xx_max*q_x_max + REAL(3)*B_xy_max*q_y_max
        + REAL(3)*B_xz_max*q_z_max + REAL(2)*a_x_max + STEWART_FABS(S_ddot_x));
    const stewart_real S_ddot_x_err = B_xx_err*q_x_max + B_xx_max*q_x_err + B_xy_err*q_y_max
        + B_xy_max*q_y_err + B_xz_err*q_z_max + B_xz_max*q_z_err + S_ddot_x_own;
    const stewart_real S_ddot_x_max = STEWART_FABS(S_ddot_x) + S_ddot_x_err;
    const stewart_real S_ddot_y = B_yx*q_x + B_yy*q_y + B_yz*q_z + a_y;
    const stewart_real S_ddot_y_own = STEWART_UNIT*(REAL(3)*B_yx_max*q_x_max + REAL(3)*B_yy_max*q_y_max
        + REAL(3)*B_yz_max*q_z_max + REAL(2)*a_y_max + STEWART_FABS(S_ddot_y));
    const stewart_real S_ddot_y_err = B_yx_err*q_x_max + B_yx_max*q_x_err + B_yy_err*q_y_max
        + B_yy_max*q_y_err + B_yz_err*q_z_max + B_yz_max*q_z_err + S_ddot_y_own;
    const stewart_real S_ddot_y_max = STEWART_FABS(S_ddot_y) + S_ddot_y_err;
    const stewart_real S_ddot_z = B_zx*q_x + B_zy*q_y + B_zz*q_z + a_z;
    const stewart_real S_ddot_z_own = STEWART_UNIT*(REAL(3)*B_zx_max*q_x_max + REAL(3)*B_zy_max*q_y_max
        + REAL(3)*B_zz_max*q_z_max + REAL(2)*a_z_max + STEWART_FABS(S_ddot_z));
    const stewart_real S_ddot_z_err = B_zx_err*q_x_max + B_zx_max*q_x_err + B_zy_err*q_y_max
        + B_zy_max*q_y_err + B_zz_err*q_z_max + B_zz_max*q_z_err + S_ddot_z_own;
    const stewart_real S_ddot_z_max = STEWART_FABS(S_ddot_z) + S_ddot_z_err;
    /* (5) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z;
    const stewart_real L_dot_own = STEWART_UNIT*(REAL(2)*S_dot_x_max*s_x_max + REAL(2)*S_dot_y_max*s_y_max
        + REAL(2)*S_dot_z_max*s_z_max + STEWART_FABS(L_dot));
    const stewart_real L_dot_err = S_dot_x_err*s_x_max + S_dot_x_max*s_x_err + S_dot_y_err*s_y_max
        + S_dot_y_max*s_y_err + S_dot_z_err*s_z_max + S_dot_z_max*s_z_err + L_dot_own;
    const stewart_real L_dot_max = STEWART_FABS(L_dot) + L_dot_err;
    /* (6) rates of the joint coordinates: L, phi about k, theta about y */
    const stewart_real phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z);
    const stewart_real phi_dot_own = STEWART_UNIT*(inv_rho_max*(REAL(3)*S_dot_x_max*y_x_max
        + REAL(3)*S_dot_y_max*y_y_max + REAL(3)*S_dot_z_max*y_z_max) + STEWART_FABS(phi_dot));
    const stewart_real phi_dot_err = S_dot_x_err*inv_rho_max*y_x_max + S_dot_x_max*inv_rho_max*y_x_err
        + S_dot_y_err*inv_rho_max*y_y_max + S_dot_y_max*inv_rho_max*y_y_err
        + S_dot_z_err*inv_rho_max*y_z_max + S_dot_z_max*inv_rho_max*y_z_err
        + inv_rho_err*(S_dot_x_max*y_x_max + S_dot_y_max*y_y_max + S_dot_z_max*y_z_max) + phi_dot_own;
    const stewart_real phi_dot_max = STEWART_FABS(phi_dot) + phi_dot_err;
    const stewart_real theta_dot = inv_rho*(L_dot*k1 - S_dot_x*k_x - S_dot_y*k_y - S_dot_z*k_z);
    const stewart_real theta_dot_own = STEWART_UNIT*(inv_rho_max*(REAL(4)*L_dot_max*k1_max
        + REAL(4)*S_dot_x_max*k_x_max + REAL(4)*S_dot_y_max*k_y_max + REAL(4)*S_dot_z_max*k_z_max)
        + STEWART_FABS(theta_dot));
    const stewart_real theta_dot_err = L_dot_err*inv_rho_max*k1_max + L_dot_max*inv_rho_max*k1_err
        + S_dot_x_err*inv_rho_max*k_x_max + S_dot_x_max*inv_rho_max*k_x_err
        + S_dot_y_err*inv_rho_max*k_y_max + S_dot_y_max*inv_rho_max*k_y_err
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
    const stewart_real L_ddot = L*(k33*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z;
    const stewart_real L_ddot_own = STEWART_UNIT*(REAL(3)*L_max*(k33_max*phi_dot2_max + theta_dot2_max)
        + L_max*(REAL(2)*k33_max*phi_dot2_max + theta_dot2_max) + REAL(3)*S_ddot_x_max*s_x_max
        + REAL(3)*S_ddot_y_max*s_y_max + REAL(3)*S_ddot_z_max*s_z_max + STEWART_FABS(L_ddot));
    const stewart_real L_ddot_err = L_err*(k33_max*phi_dot2_max + theta_dot2_max)
        + L_max*k33_err*phi_dot2_max + L_max*k33_max*phi_dot2_err + L_max*theta_dot2_err
        + S_ddot_x_err*s_x_max + S_ddot_x_max*s_x_err + S_ddot_y_err*s_y_max + S_ddot_y_max*s_y_err
        + S_ddot_z_err*s_z_max + S_ddot_z_max*s_z_err + L_ddot_own;
    const stewart_real L_ddot_max = STEWART_FABS(L_ddot) + L_ddot_err;
    /* (9) accelerations of the joint coordinates */
    const stewart_real theta_ddot = inv_rho*(L_ddot*k1 - S_ddot_x*k_x - S_ddot_y*k_y - S_ddot_z*k_z)
        - theta_dot*(L_share + rho_share);
    const stewart_real theta_ddot_own = STEWART_UNIT*(inv_rho_max*(L_ddot_max*k1_max + S_ddot_x_max*k_x_max
        + S_ddot_y_max*k_y_max + S_ddot_z_max*k_z_max) + inv_rho_max*(REAL(4)*L_ddot_max*k1_max
        + REAL(4)*S_ddot_x_max*k_x_max + REAL(4)*S_ddot_y_max*k_y_max + REAL(4)*S_ddot_z_max*k_z_max)
        + REAL(2)*theta_dot_max*(L_share_max + rho_share_max) + STEWART_FABS(theta_ddot));
    const stewart_real theta_ddot_err = L_ddot_err*inv_rho_max*k1_max + L_ddot_max*inv_rho_max*k1_err
        + L_share_err*theta_dot_max + S_ddot_x_err*inv_rho_max*k_x_max + S_ddot_x_max*inv_rho_max*k_x_err
        + S_ddot_y_err*inv_rho_max*k_y_max + S_ddot_y_max*inv_rho_max*k_y_err
        + S_ddot_z_err*inv_rho_max*k_z_max + S_ddot_z_max*inv_rho_max*k_z_err
        + inv_rho_err*(L_ddot_max*k1_max + S_ddot_x_max*k_x_max + S_ddot_y_max*k_y_max
        + S_ddot_z_max*k_z_max) + rho_share_err*theta_dot_max + theta_dot_err*(L_share_max + rho_share_max)
        + theta_ddot_own;
    const stewart_real theta_ddot_max = STEWART_FABS(theta_ddot) + theta_ddot_err;
    const stewart_real phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z)
        - rho_share*two_phi_dot;
    const stewart_real phi_ddot_own = STEWART_UNIT*(inv_rho_max*(S_ddot_x_max*y_x_max + S_ddot_y_max*y_y_max
        + S_ddot_z_max*y_z_max) + inv_rho_max*(REAL(3)*S_ddot_x_max*y_x_max + REAL(3)*S_ddot_y_max*y_y_max
        + REAL(3)*S_ddot_z_max*y_z_max) + rho_share_max*two_phi_dot_max + STEWART_FABS(phi_ddot));
    const stewart_real phi_ddot_err = S_ddot_x_err*inv_rho_max*y_x_max + S_ddot_x_max*inv_rho_max*y_x_err
        + S_ddot_y_err*inv_rho_max*y_y_max + S_ddot_y_max*inv_rho_max*y_y_err
        + S_ddot_z_err*inv_rho_max*y_z_max + S_ddot_z_max*inv_rho_max*y_z_err
        + inv_rho_err*(S_ddot_x_max*y_x_max + S_ddot_y_max*y_y_max + S_ddot_z_max*y_z_max)
        + rho_share_err*two_phi_dot_max + rho_share_max*two_phi_dot_err + phi_ddot_own;
    const stewart_real phi_ddot_max = STEWART_FABS(phi_ddot) + phi_ddot_err;
    const stewart_real k13 = k1*k3;
    const stewart_real k13_own = STEWART_UNIT*STEWART_FABS(k13);
    const stewart_real k13_err = k1_err*k3_max + k1_max*k3_err + k13_own;
    const stewart_real k13_max = STEWART_FABS(k13) + k13_err;
    const stewart_real L_h2 = L*h2_x;
    const stewart_real L_h2_own = STEWART_UNIT*STEWART_FABS(L_h2);
    const stewart_real L_h2_err = L_err*h2_x_max + L_max*h2_x_err + L_h2_own;
    const stewart_real a1 = L_h2 + dJ_zx;
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
    const stewart_real M_phi_own = STEWART_UNIT*(J_xx_max + REAL(2)*a1_max*k33_max + REAL(2)*a2_max*k13_max
        + STEWART_FABS(M_phi));
    const stewart_real M_phi_err = J_xx_err + a1_err*k33_max + a1_max*k33_err + a2_err*k13_max
        + a2_max*k13_err + M_phi_own;
    const stewart_real M_phi_max = STEWART_FABS(M_phi) + M_phi_err;
    const stewart_real M_theta = J_yy + L_h2;
    const stewart_real M_theta_own = STEWART_UNIT*STEWART_FABS(M_theta);
    const stewart_real M_theta_err = J_yy_err + L_h2_err + M_theta_own;
    const stewart_real M_theta_max = STEWART_FABS(M_theta) + M_theta_err;
    const stewart_real M_mixed = J_yz*k3 + a3*k1;
    const stewart_real M_mixed_own = STEWART_UNIT*(J_yz_max*k3_max + a3_max*k1_max + STEWART_FABS(M_mixed));
    const stewart_real M_mixed_err = J_yz_err*k3_max + J_yz_max*k3_err + a3_err*k1_max + a3_max*k1_err
        + M_mixed_own;
    const stewart_real M_mixed_max = STEWART_FABS(M_mixed) + M_mixed_err;
    const stewart_real k3_h = h_y*k3;
    const stewart_real k3_h_own = STEWART_UNIT*STEWART_FABS(k3_h);
    const stewart_real k3_h_err = h_y_err*k3_max + h_y_max*k3_err + k3_h_own;
    const stewart_real k3_h_max = STEWART_FABS(k3_h) + k3_h_err;
    /* (19) slopes of M_phi / 2 along theta and L, of M_mixed along theta */
    const stewart_real M_phi_theta = a1*k13 + a2*(STEWART_HALF - k33);
    const stewart_real M_phi_theta_own = STEWART_UNIT*(a1_max*k13_max + REAL(2)*a2_max*(k33_max
        + STEWART_HALF) + STEWART_FABS(M_phi_theta));
    const stewart_real M_phi_theta_err = a1_err*k13_max + a1_max*k13_err + a2_err*(k33_max + STEWART_HALF)
        + a2_max*k33_err + M_phi_theta_own;
    const stewart_real M_phi_theta_max = STEWART_FABS(M_phi_theta) + M_phi_theta_err;
    const stewart_real M_phi_L = h_x*k33 - h_z*k13;
    const stewart_real M_phi_L_own = STEWART_UNIT*(h_x_max*k33_max + h_z_max*k13_max
        + STEWART_FABS(M_phi_L));
    const stewart_real M_phi_L_err = h_x_err*k33_max + h_x_max*k33_err + h_z_err*k13_max + h_z_max*k13_err
        + M_phi_L_own;
    const stewart_real M_phi_L_max = STEWART_FABS(M_phi_L) + M_phi_L_err;
    const stewart_real M_mixed_theta = J_yz*k1 - a3*k3;
    const stewart_real M_mixed_theta_own = STEWART_UNIT*(J_yz_max*k1_max + a3_max*k3_max
        + STEWART_FABS(M_mixed_theta));
    const stewart_real M_mixed_theta_err = J_yz_err*k1_max + J_yz_max*k1_err + a3_err*k3_max + a3_max*k3_err
        + M_mixed_theta_own;
    const stewart_real M_mixed_theta_max = STEWART_FABS(M_mixed_theta) + M_mixed_theta_err;
    const stewart_real bend = L_dot*theta_dot;
    const stewart_real bend_own = STEWART_UNIT*STEWART_FABS(bend);
    const stewart_real bend_err = L_dot_err*theta_dot_max + L_dot_max*theta_dot_err + bend_own;
    const stewart_real bend_max = STEWART_FABS(bend) + bend_err;
    /* gravity along k x y and along y */
    const stewart_real gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z;
    const stewart_real gamma_n_own = STEWART_UNIT*(REAL(2)*g_x_k_x_max*y_x_max + REAL(2)*g_x_k_y_max*y_y_max
        + REAL(2)*g_x_k_z_max*y_z_max + STEWART_FABS(gamma_n));
    const stewart_real gamma_n_err = g_x_k_x_err*y_x_max + g_x_k_x_max*y_x_err + g_x_k_y_err*y_y_max
        + g_x_k_y_max*y_y_err + g_x_k_z_err*y_z_max + g_x_k_z_max*y_z_err + gamma_n_own;
    const stewart_real gamma_n_max = STEWART_FABS(gamma_n) + gamma_n_err;
    const stewart_real gamma_y = g_x*y_x + g_y*y_y + g_z*y_z;
    const stewart_real gamma_y_own = STEWART_UNIT*(REAL(2)*g_x_max*y_x_max + REAL(2)*g_y_max*y_y_max
        + REAL(2)*g_z_max*y_z_max + STEWART_FABS(gamma_y));
    const stewart_real gamma_y_err = g_x_max*y_x_err + g_y_max*y_y_err + g_z_max*y_z_err + gamma_y_own;
    const stewart_real gamma_y_max = STEWART_FABS(gamma_y) + gamma_y_err;
    /* first moment along k and against k x y */
    const stewart_real w_k = k1*w_x + k3*w_z;
    const stewart_real w_k_own = STEWART_UNIT*(k1_max*w_x_max + k3_max*w_z_max + STEWART_FABS(w_k));
    const stewart_real w_k_err = k1_err*w_x_max + k1_max*w_x_err + k3_err*w_z_max + k3_max*w_z_err
        + w_k_own;
    const stewart_real w_k_max = STEWART_FABS(w_k) + w_k_err;
    const stewart_real w_n = k3*w_x - k1*w_z;
    const stewart_real w_n_own = STEWART_UNIT*(k1_max*w_z_max + k3_max*w_x_max + STEWART_FABS(w_n));
    const stewart_real w_n_err = k1_err*w_z_max + k1_max*w_z_err + k3_err*w_x_max + k3_max*w_x_err
        + w_n_own;
    const stewart_real w_n_max = STEWART_FABS(w_n) + w_n_err;
    /* (20) generalised forces about y and about k */
    const stewart_real tau_y = C_us*theta_dot + L_ddot*h_z + M_mixed*phi_ddot + M_theta*theta_ddot
        + bend*h2_x + g_k*w_n + gamma_n*w_k - C_s*(omega_x*y_x + omega_y*y_y + omega_z*y_z)
        - M_phi_theta*phi_dot2;
    const stewart_real tau_y_own = STEWART_UNIT*(REAL(8)*C_s_max*(omega_x_max*y_x_max + omega_y_max*y_y_max
        + omega_z_max*y_z_max) + C_s_max*(REAL(3)*omega_x_max*y_x_max + REAL(3)*omega_y_max*y_y_max
        + REAL(3)*omega_z_max*y_z_max) + REAL(8)*C_us_max*theta_dot_max + REAL(8)*L_ddot_max*h_z_max
        + REAL(8)*M_mixed_max*phi_ddot_max + REAL(8)*M_phi_theta_max*phi_dot2_max
        + REAL(8)*M_theta_max*theta_ddot_max + REAL(8)*bend_max*h2_x_max + REAL(8)*g_k_max*w_n_max
        + REAL(8)*gamma_n_max*w_k_max + STEWART_FABS(tau_y));
    const stewart_real tau_y_err = C_s_max*omega_x_max*y_x_err + C_s_max*omega_y_max*y_y_err
        + C_s_max*omega_z_max*y_z_err + C_us_err*theta_dot_max + C_us_max*theta_dot_err + L_ddot_err*h_z_max
        + L_ddot_max*h_z_err + M_mixed_err*phi_ddot_max + M_mixed_max*phi_ddot_err
        + M_phi_theta_err*phi_dot2_max + M_phi_theta_max*phi_dot2_err + M_theta_err*theta_ddot_max
        + M_theta_max*theta_ddot_err + bend_err*h2_x_max + bend_max*h2_x_err + g_k_err*w_n_max
        + g_k_max*w_n_err + gamma_n_err*w_k_max + gamma_n_max*w_k_err + tau_y_own;
    const stewart_real tau_y_max = STEWART_FABS(tau_y) + tau_y_err;
    const stewart_real tau_k = C_us*phi_dot + M_mixed*theta_ddot + M_mixed_theta*theta_dot2 + M_phi*phi_ddot
        + two_phi_dot*(L_dot*M_phi_L + M_phi_theta*theta_dot) - C_s*(k_x*omega_x + k_y*omega_y
        + k_z*omega_z) - L_ddot*k3_h - bend*h2_y*k1 - gamma_n*w_y - gamma_y*w_n;
    const stewart_real tau_k_own = STEWART_UNIT*(REAL(9)*C_s_max*(k_x_max*omega_x_max + k_y_max*omega_y_max
        + k_z_max*omega_z_max) + C_s_max*(REAL(3)*k_x_max*omega_x_max + REAL(3)*k_y_max*omega_y_max
        + REAL(3)*k_z_max*omega_z_max) + REAL(9)*C_us_max*phi_dot_max + REAL(9)*L_ddot_max*k3_h_max
        + REAL(9)*M_mixed_max*theta_ddot_max + REAL(9)*M_mixed_theta_max*theta_dot2_max
        + REAL(9)*M_phi_max*phi_ddot_max + REAL(10)*bend_max*h2_y_max*k1_max + REAL(9)*gamma_n_max*w_y_max
        + REAL(9)*gamma_y_max*w_n_max + REAL(9)*two_phi_dot_max*(L_dot_max*M_phi_L_max
        + M_phi_theta_max*theta_dot_max) + two_phi_dot_max*(REAL(2)*L_dot_max*M_phi_L_max
        + REAL(2)*M_phi_theta_max*theta_dot_max) + STEWART_FABS(tau_k));
    const stewart_real tau_k_err = C_s_max*k_x_err*omega_x_max + C_s_max*k_y_err*omega_y_max
        + C_s_max*k_z_err*omega_z_max + C_us_err*phi_dot_max + C_us_max*phi_dot_err + L_ddot_err*k3_h_max
        + L_ddot_max*k3_h_err + L_dot_err*M_phi_L_max*two_phi_dot_max
        + L_dot_max*M_phi_L_err*two_phi_dot_max + M_mixed_err*theta_ddot_max + M_mixed_max*theta_ddot_err
        + M_mixed_theta_err*theta_dot2_max + M_mixed_theta_max*theta_dot2_err + M_phi_err*phi_ddot_max
        + M_phi_max*phi_ddot_err + M_phi_theta_err*theta_dot_max*two_phi_dot_max
        + M_phi_theta_max*theta_dot_err*two_phi_dot_max + bend_err*h2_y_max*k1_max
        + bend_max*h2_y_err*k1_max + bend_max*h2_y_max*k1_err + gamma_n_err*w_y_max + gamma_n_max*w_y_err
        + gamma_y_err*w_n_max + gamma_y_max*w_n_err + two_phi_dot_err*(L_dot_max*M_phi_L_max
        + M_phi_theta_max*theta_dot_max) + tau_k_own;
    const stewart_real tau_k_max = STEWART_FABS(tau_k) + tau_k_err;
    /* (21) K = Q_k k + Q_y y, up to a part along s */
    const stewart_real Q_k = -inv_rho*tau_y;
    const stewart_real Q_k_own = STEWART_UNIT*STEWART_FABS(Q_k);
    const stewart_real Q_k_err = inv_rho_err*tau_y_max + inv_rho_max*tau_y_err + Q_k_own;
    const stewart_real Q_k_max = STEWART_FABS(Q_k) + Q_k_err;
    const stewart_real Q_y = inv_rho*tau_k;
    const stewart_real Q_y_own = STEWART_UNIT*STEWART_FABS(Q_y);
    const stewart_real Q_y_err = inv_rho_err*tau_k_max + inv_rho_max*tau_k_err + Q_y_own;
    const stewart_real Q_y_max = STEWART_FABS(Q_y) + Q_y_err;
    /* (21) force at the spherical joint, base frame */
    const stewart_real K_x = Q_k*k_x + Q_y*y_x;
    const stewart_real K_x_own = STEWART_UNIT*(Q_k_max*k_x_max + Q_y_max*y_x_max + STEWART_FABS(K_x));
    const stewart_real K_x_err = Q_k_err*k_x_max + Q_k_max*k_x_err + Q_y_err*y_x_max + Q_y_max*y_x_err
        + K_x_own;
    const stewart_real K_x_max = STEWART_FABS(K_x) + K_x_err;
    const stewart_real K_y = Q_k*k_y + Q_y*y_y;
    const stewart_real K_y_own = STEWART_UNIT*(Q_k_max*k_y_max + Q_y_max*y_y_max + STEWART_FABS(K_y));
    const stewart_real K_y_err = Q_k_err*k_y_max + Q_k_max*k_y_err + Q_y_err*y_y_max + Q_y_max*y_y_err
        + K_y_own;
    const stewart_real K_y_max = STEWART_FABS(K_y) + K_y_err;
    const stewart_real K_z = Q_k*k_z + Q_y*y_z;
    const stewart_real K_z_own = STEWART_UNIT*(Q_k_max*k_z_max + Q_y_max*y_z_max + STEWART_FABS(K_z));
    const stewart_real K_z_err = Q_k_err*k_z_max + Q_k_max*k_z_err + Q_y_err*y_z_max + Q_y_max*y_z_err
        + K_z_own;
    const stewart_real K_z_max = STEWART_FABS(K_z) + K_z_err;
    /* (24) known part of the actuator force, to match */
    const stewart_real D = C_p*L_dot + h_z*theta_ddot - M_phi_L*phi_dot2 - Q_k*k1 - h_x*theta_dot2
        - k3_h*phi_ddot;
    const stewart_real D_own = STEWART_UNIT*(REAL(5)*C_p_max*L_dot_max + REAL(5)*M_phi_L_max*phi_dot2_max
        + REAL(5)*Q_k_max*k1_max + REAL(5)*h_x_max*theta_dot2_max + REAL(5)*h_z_max*theta_ddot_max
        + REAL(5)*k3_h_max*phi_ddot_max + STEWART_FABS(D));
    /* the leg's column of H, moment rows */
    const stewart_real H_moment_x = r_y*s_z - r_z*s_y;
    const stewart_real H_moment_x_own = STEWART_UNIT*(r_y_max*s_z_max + r_z_max*s_y_max
        + STEWART_FABS(H_moment_x));
    const stewart_real H_moment_x_err = r_y_err*s_z_max + r_y_max*s_z_err + r_z_err*s_y_max
        + r_z_max*s_y_err + H_moment_x_own;
    const stewart_real H_moment_y = r_z*s_x - r_x*s_z;
    const stewart_real H_moment_y_own = STEWART_UNIT*(r_x_max*s_z_max + r_z_max*s_x_max
        + STEWART_FABS(H_moment_y));
    const stewart_real H_moment_y_err = r_x_err*s_z_max + r_x_max*s_z_err + r_z_err*s_x_max
        + r_z_max*s_x_err + H_moment_y_own;
    const stewart_real H_moment_z = r_x*s_y - r_y*s_x;
    const stewart_real H_moment_z_own = STEWART_UNIT*(r_x_max*s_y_max + r_y_max*s_x_max
        + STEWART_FABS(H_moment_z));
    const stewart_real H_moment_z_err = r_x_err*s_y_max + r_x_max*s_y_err + r_y_err*s_x_max
        + r_y_max*s_x_err + H_moment_z_own;
    /* part of c, moment rows, base frame */
    const stewart_real c_moment_x = C_s*(k_x*phi_dot + theta_dot*y_x) + K_y*S_1_z - K_z*S_1_y;
    const stewart_real c_moment_x_own = STEWART_UNIT*(REAL(2)*C_s_max*(k_x_max*phi_dot_max
        + theta_dot_max*y_x_max) + C_s_max*(REAL(2)*k_x_max*phi_dot_max + REAL(2)*theta_dot_max*y_x_max)
        + REAL(2)*K_y_max*S_1_z_max + REAL(2)*K_z_max*S_1_y_max + STEWART_FABS(c_moment_x));
    const stewart_real c_moment_x_err = C_s_max*k_x_err*phi_dot_max + C_s_max*k_x_max*phi_dot_err
        + C_s_max*theta_dot_err*y_x_max + C_s_max*theta_dot_max*y_x_err + K_y_err*S_1_z_max
        + K_y_max*S_1_z_err + K_z_err*S_1_y_max + K_z_max*S_1_y_err + c_moment_x_own;
    const stewart_real c_moment_y = C_s*(k_y*phi_dot + theta_dot*y_y) + K_z*S_1_x - K_x*S_1_z;
    const stewart_real c_moment_y_own = STEWART_UNIT*(REAL(2)*C_s_max*(k_y_max*phi_dot_max
        + theta_dot_max*y_y_max) + C_s_max*(REAL(2)*k_y_max*phi_dot_max + REAL(2)*theta_dot_max*y_y_max)
        + REAL(2)*K_x_max*S_1_z_max + REAL(2)*K_z_max*S_1_x_max + STEWART_FABS(c_moment_y));
    const stewart_real c_moment_y_err = C_s_max*k_y_err*phi_dot_max + C_s_max*k_y_max*phi_dot_err
        + C_s_max*theta_dot_err*y_y_max + C_s_max*theta_dot_max*y_y_err + K_x_err*S_1_z_max
        + K_x_max*S_1_z_err + K_z_err*S_1_x_max + K_z_max*S_1_x_err + c_moment_y_own;
    const stewart_real c_moment_z = C_s*(k_z*phi_dot + theta_dot*y_z) + K_x*S_1_y - K_y*S_1_x;
    const stewart_real c_moment_z_own = STEWART_UNIT*(REAL(2)*C_s_max*(k_z_max*phi_dot_max
        + theta_dot_max*y_z_max) + C_s_max*(REAL(2)*k_z_max*phi_dot_max + REAL(2)*theta_dot_max*y_z_max)
        + REAL(2)*K_x_max*S_1_y_max + REAL(2)*K_y_max*S_1_x_max + STEWART_FABS(c_moment_z));
    const stewart_real c_moment_z_err = C_s_max*k_z_err*phi_dot_max + C_s_max*k_z_max*phi_dot_err
        + C_s_max*theta_dot_err*y_z_max + C_s_max*theta_dot_max*y_z_err + K_x_err*S_1_y_max
        + K_x_max*S_1_y_err + K_y_err*S_1_x_max + K_y_max*S_1_x_err + c_moment_z_own;
    out->H_force[0] = s_x;
    out->H_force_err[0] = s_x_err;
    out->H_force[1] = s_y;
    out->H_force_err[1] = s_y_err;
    out->H_force[2] = s_z;
    out->H_force_err[2] = s_z_err;
    out->H_moment[0] = H_moment_x;
    out->H_moment_err[0] = H_moment_x_err;
    out->H_moment[1] = H_moment_y;
    out->H_moment_err[1] = H_moment_y_err;
    out->H_moment[2] = H_moment_z;
    out->H_moment_err[2] = H_moment_z_err;
    out->c_force[0] = -K_x;
    out->c_force_err[0] = K_x_err;
    out->c_force[1] = -K_y;
    out->c_force_err[1] = K_y_err;
    out->c_force[2] = -K_z;
    out->c_force_err[2] = K_z_err;
    out->c_moment[0] = c_moment_x;
    out->c_moment_err[0] = c_moment_x_err;
    out->c_moment[1] = c_moment_y;
    out->c_moment_err[1] = c_moment_y_err;
    out->c_moment[2] = c_moment_z;
    out->c_moment_err[2] = c_moment_z_err;
    for (i = 0; i < 6; ++i) {
        const force_row *row = &rows[i];
        const stewart_real Y_force_x = row->Y_force[0], Y_force_y = row->Y_force[1],
            Y_force_z = row->Y_force[2];
        const stewart_real Y_moment_x = row->Y_moment[0], Y_moment_y = row->Y_moment[1],
            Y_moment_z = row->Y_moment[2];
        const stewart_real D_weight = row->D_weight;
        const stewart_real x = row->x;
        const stewart_real Y_force_x_max = STEWART_FABS(Y_force_x),
            Y_force_y_max = STEWART_FABS(Y_force_y), Y_force_z_max = STEWART_FABS(Y_force_z);
        const stewart_real Y_moment_x_max = STEWART_FABS(Y_moment_x),
            Y_moment_y_max = STEWART_FABS(Y_moment_y), Y_moment_z_max = STEWART_FABS(Y_moment_z);
        const stewart_real D_weight_max = STEWART_FABS(D_weight);
        const stewart_real H_force_x_bar = Y_force_x*x;
        const stewart_real H_force_x_bar_err = STEWART_UNIT*STEWART_FABS(H_force_x_bar);
        const stewart_real H_force_x_bar_max = STEWART_FABS(H_force_x_bar) + H_force_x_bar_err;
        const stewart_real H_force_y_bar = Y_force_y*x;
        const stewart_real H_force_y_bar_err = STEWART_UNIT*STEWART_FABS(H_force_y_bar);
        const stewart_real H_force_y_bar_max = STEWART_FABS(H_force_y_bar) + H_force_y_bar_err;
        const stewart_real H_force_z_bar = Y_force_z*x;
        const stewart_real H_force_z_bar_err = STEWART_UNIT*STEWART_FABS(H_force_z_bar);
        const stewart_real H_force_z_bar_max = STEWART_FABS(H_force_z_bar) + H_force_z_bar_err;
        const stewart_real H_moment_x_bar = Y_moment_x*x;
        const stewart_real H_moment_x_bar_err = STEWART_UNIT*STEWART_FABS(H_moment_x_bar);
        const stewart_real H_moment_x_bar_max = STEWART_FABS(H_moment_x_bar) + H_moment_x_bar_err;
        const stewart_real H_moment_y_bar = Y_moment_y*x;
        const stewart_real H_moment_y_bar_err = STEWART_UNIT*STEWART_FABS(H_moment_y_bar);
        const stewart_real H_moment_y_bar_max = STEWART_FABS(H_moment_y_bar) + H_moment_y_bar_err;
        const stewart_real H_moment_z_bar = Y_moment_z*x;
        const stewart_real H_moment_z_bar_err = STEWART_UNIT*STEWART_FABS(H_moment_z_bar);
        const stewart_real H_moment_z_bar_max = STEWART_FABS(H_moment_z_bar) + H_moment_z_bar_err;
        const stewart_real K_z_bar = S_1_y*Y_moment_x + Y_force_z - S_1_x*Y_moment_y;
        const stewart_real K_z_bar_err = S_1_x_err*Y_moment_y_max + S_1_y_err*Y_moment_x_max
            + STEWART_UNIT*(REAL(2)*S_1_x_max*Y_moment_y_max + REAL(2)*S_1_y_max*Y_moment_x_max + Y_force_z_max
            + STEWART_FABS(K_z_bar));
        const stewart_real K_z_bar_max = STEWART_FABS(K_z_bar) + K_z_bar_err;
        const stewart_real K_y_bar = S_1_x*Y_moment_z + Y_force_y - S_1_z*Y_moment_x;
        const stewart_real K_y_bar_err = S_1_x_err*Y_moment_z_max + S_1_z_err*Y_moment_x_max
            + STEWART_UNIT*(REAL(2)*S_1_x_max*Y_moment_z_max + REAL(2)*S_1_z_max*Y_moment_x_max + Y_force_y_max
            + STEWART_FABS(K_y_bar));
        const stewart_real K_y_bar_max = STEWART_FABS(K_y_bar) + K_y_bar_err;
        const stewart_real K_x_bar = S_1_z*Y_moment_y + Y_force_x - S_1_y*Y_moment_z;
        const stewart_real K_x_bar_err = S_1_y_err*Y_moment_z_max + S_1_z_err*Y_moment_y_max
            + STEWART_UNIT*(REAL(2)*S_1_y_max*Y_moment_z_max + REAL(2)*S_1_z_max*Y_moment_y_max + Y_force_x_max
            + STEWART_FABS(K_x_bar));
        const stewart_real K_x_bar_max = STEWART_FABS(K_x_bar) + K_x_bar_err;
        const stewart_real Q_y_bar = K_x_bar*y_x + K_y_bar*y_y + K_z_bar*y_z;
        const stewart_real Q_y_bar_err = K_x_bar_err*y_x_max + K_x_bar_max*y_x_err + K_y_bar_err*y_y_max
            + K_y_bar_max*y_y_err + K_z_bar_err*y_z_max + K_z_bar_max*y_z_err
            + STEWART_UNIT*(REAL(2)*K_x_bar_max*y_x_max + REAL(2)*K_y_bar_max*y_y_max
            + REAL(2)*K_z_bar_max*y_z_max + STEWART_FABS(Q_y_bar));
        const stewart_real Q_y_bar_max = STEWART_FABS(Q_y_bar) + Q_y_bar_err;
        const stewart_real Q_k_bar = K_x_bar*k_x + K_y_bar*k_y + K_z_bar*k_z - D_weight*k1;
        const stewart_real Q_k_bar_err = D_weight_max*k1_err + K_x_bar_err*k_x_max + K_x_bar_max*k_x_err
            + K_y_bar_err*k_y_max + K_y_bar_max*k_y_err + K_z_bar_err*k_z_max + K_z_bar_max*k_z_err
            + STEWART_UNIT*(REAL(3)*D_weight_max*k1_max + REAL(3)*K_x_bar_max*k_x_max
            + REAL(3)*K_y_bar_max*k_y_max + REAL(3)*K_z_bar_max*k_z_max + STEWART_FABS(Q_k_bar));
        const stewart_real Q_k_bar_max = STEWART_FABS(Q_k_bar) + Q_k_bar_err;
        const stewart_real tau_k_bar = Q_y_bar*inv_rho;
        const stewart_real tau_k_bar_err = Q_y_bar_err*inv_rho_max + Q_y_bar_max*inv_rho_err
            + STEWART_UNIT*STEWART_FABS(tau_k_bar);
        const stewart_real tau_k_bar_max = STEWART_FABS(tau_k_bar) + tau_k_bar_err;
        const stewart_real tau_y_bar = -Q_k_bar*inv_rho;
        const stewart_real tau_y_bar_err = Q_k_bar_err*inv_rho_max + Q_k_bar_max*inv_rho_err
            + STEWART_UNIT*STEWART_FABS(tau_y_bar);
        const stewart_real tau_y_bar_max = STEWART_FABS(tau_y_bar) + tau_y_bar_err;
        const stewart_real w_n_bar = g_k*tau_y_bar - gamma_y*tau_k_bar;
        const stewart_real w_n_bar_err = g_k_err*tau_y_bar_max + g_k_max*tau_y_bar_err
            + gamma_y_err*tau_k_bar_max + gamma_y_max*tau_k_bar_err + STEWART_UNIT*(g_k_max*tau_y_bar_max
            + gamma_y_max*tau_k_bar_max + STEWART_FABS(w_n_bar));
        const stewart_real w_n_bar_max = STEWART_FABS(w_n_bar) + w_n_bar_err;
        const stewart_real w_k_bar = gamma_n*tau_y_bar;
        const stewart_real w_k_bar_err = gamma_n_err*tau_y_bar_max + gamma_n_max*tau_y_bar_err
            + STEWART_UNIT*STEWART_FABS(w_k_bar);
        const stewart_real w_k_bar_max = STEWART_FABS(w_k_bar) + w_k_bar_err;
        const stewart_real gamma_y_bar = -tau_k_bar*w_n;
        const stewart_real gamma_y_bar_err = tau_k_bar_err*w_n_max + tau_k_bar_max*w_n_err
            + STEWART_UNIT*STEWART_FABS(gamma_y_bar);
        const stewart_real gamma_y_bar_max = STEWART_FABS(gamma_y_bar) + gamma_y_bar_err;
        const stewart_real gamma_n_bar = tau_y_bar*w_k - tau_k_bar*w_y;
        const stewart_real gamma_n_bar_err = tau_k_bar_err*w_y_max + tau_k_bar_max*w_y_err
            + tau_y_bar_err*w_k_max + tau_y_bar_max*w_k_err + STEWART_UNIT*(tau_k_bar_max*w_y_max
            + tau_y_bar_max*w_k_max + STEWART_FABS(gamma_n_bar));
        const stewart_real gamma_n_bar_max = STEWART_FABS(gamma_n_bar) + gamma_n_bar_err;
        const stewart_real c1 = h2_y*tau_k_bar;
        const stewart_real c1_err = h2_y_err*tau_k_bar_max + h2_y_max*tau_k_bar_err
            + STEWART_UNIT*STEWART_FABS(c1);
        const stewart_real c1_max = STEWART_FABS(c1) + c1_err;
        const stewart_real bend_bar = h2_x*tau_y_bar - c1*k1;
        const stewart_real bend_bar_err = c1_err*k1_max + c1_max*k1_err + h2_x_err*tau_y_bar_max
            + h2_x_max*tau_y_bar_err + STEWART_UNIT*(c1_max*k1_max + h2_x_max*tau_y_bar_max
            + STEWART_FABS(bend_bar));
        const stewart_real bend_bar_max = STEWART_FABS(bend_bar) + bend_bar_err;
        const stewart_real M_mixed_theta_bar = tau_k_bar*theta_dot2;
        const stewart_real M_mixed_theta_bar_err = tau_k_bar_err*theta_dot2_max + tau_k_bar_max*theta_dot2_err
            + STEWART_UNIT*STEWART_FABS(M_mixed_theta_bar);
        const stewart_real M_mixed_theta_bar_max = STEWART_FABS(M_mixed_theta_bar) + M_mixed_theta_bar_err;
        const stewart_real M_phi_L_bar = L_dot*tau_k_bar*two_phi_dot - D_weight*phi_dot2;
        const stewart_real M_phi_L_bar_err = D_weight_max*phi_dot2_err + L_dot_err*tau_k_bar_max*two_phi_dot_max
            + L_dot_max*tau_k_bar_err*two_phi_dot_max + L_dot_max*tau_k_bar_max*two_phi_dot_err
            + STEWART_UNIT*(D_weight_max*phi_dot2_max + REAL(2)*L_dot_max*tau_k_bar_max*two_phi_dot_max
            + STEWART_FABS(M_phi_L_bar));
        const stewart_real M_phi_L_bar_max = STEWART_FABS(M_phi_L_bar) + M_phi_L_bar_err;
        const stewart_real M_phi_theta_bar = tau_k_bar*theta_dot*two_phi_dot - phi_dot2*tau_y_bar;
        const stewart_real M_phi_theta_bar_err = phi_dot2_err*tau_y_bar_max + phi_dot2_max*tau_y_bar_err
            + tau_k_bar_err*theta_dot_max*two_phi_dot_max + tau_k_bar_max*theta_dot_err*two_phi_dot_max
            + tau_k_bar_max*theta_dot_max*two_phi_dot_err + STEWART_UNIT*(phi_dot2_max*tau_y_bar_max
            + REAL(2)*tau_k_bar_max*theta_dot_max*two_phi_dot_max + STEWART_FABS(M_phi_theta_bar));
        const stewart_real M_phi_theta_bar_max = STEWART_FABS(M_phi_theta_bar) + M_phi_theta_bar_err;
        const stewart_real k3_h_bar = -D_weight*phi_ddot - L_ddot*tau_k_bar;
        const stewart_real k3_h_bar_err = D_weight_max*phi_ddot_err + L_ddot_err*tau_k_bar_max
            + L_ddot_max*tau_k_bar_err + STEWART_UNIT*(D_weight_max*phi_ddot_max + L_ddot_max*tau_k_bar_max
            + STEWART_FABS(k3_h_bar));
        const stewart_real k3_h_bar_max = STEWART_FABS(k3_h_bar) + k3_h_bar_err;
        const stewart_real M_mixed_bar = phi_ddot*tau_y_bar + tau_k_bar*theta_ddot;
        const stewart_real M_mixed_bar_err = phi_ddot_err*tau_y_bar_max + phi_ddot_max*tau_y_bar_err
            + tau_k_bar_err*theta_ddot_max + tau_k_bar_max*theta_ddot_err
            + STEWART_UNIT*(phi_ddot_max*tau_y_bar_max + tau_k_bar_max*theta_ddot_max
            + STEWART_FABS(M_mixed_bar));
        const stewart_real M_mixed_bar_max = STEWART_FABS(M_mixed_bar) + M_mixed_bar_err;
        const stewart_real M_theta_bar = tau_y_bar*theta_ddot;
        const stewart_real M_theta_bar_err = tau_y_bar_err*theta_ddot_max + tau_y_bar_max*theta_ddot_err
            + STEWART_UNIT*STEWART_FABS(M_theta_bar);
        const stewart_real M_theta_bar_max = STEWART_FABS(M_theta_bar) + M_theta_bar_err;
        const stewart_real M_phi_bar = phi_ddot*tau_k_bar;
        const stewart_real M_phi_bar_err = phi_ddot_err*tau_k_bar_max + phi_ddot_max*tau_k_bar_err
            + STEWART_UNIT*STEWART_FABS(M_phi_bar);
        const stewart_real M_phi_bar_max = STEWART_FABS(M_phi_bar) + M_phi_bar_err;
        const stewart_real a3_bar = M_mixed_bar*k1 - M_mixed_theta_bar*k3;
        const stewart_real a3_bar_err = M_mixed_bar_err*k1_max + M_mixed_bar_max*k1_err
            + M_mixed_theta_bar_err*k3_max + M_mixed_theta_bar_max*k3_err + STEWART_UNIT*(M_mixed_bar_max*k1_max
            + M_mixed_theta_bar_max*k3_max + STEWART_FABS(a3_bar));
        const stewart_real a3_bar_max = STEWART_FABS(a3_bar) + a3_bar_err;
        const stewart_real a2_bar = M_phi_bar*k13 + M_phi_theta_bar*(STEWART_HALF - k33);
        const stewart_real a2_bar_err = M_phi_bar_err*k13_max + M_phi_bar_max*k13_err
            + M_phi_theta_bar_err*(k33_max + STEWART_HALF) + M_phi_theta_bar_max*k33_err
            + STEWART_UNIT*(M_phi_bar_max*k13_max + REAL(2)*M_phi_theta_bar_max*(k33_max + STEWART_HALF)
            + STEWART_FABS(a2_bar));
        const stewart_real a2_bar_max = STEWART_FABS(a2_bar) + a2_bar_err;
        const stewart_real a1_bar = M_phi_bar*k33 + M_phi_theta_bar*k13;
        const stewart_real a1_bar_err = M_phi_bar_err*k33_max + M_phi_bar_max*k33_err
            + M_phi_theta_bar_err*k13_max + M_phi_theta_bar_max*k13_err + STEWART_UNIT*(M_phi_bar_max*k33_max
            + M_phi_theta_bar_max*k13_max + STEWART_FABS(a1_bar));
        const stewart_real a1_bar_max = STEWART_FABS(a1_bar) + a1_bar_err;
        const stewart_real L_h2_bar = M_theta_bar + a1_bar;
        const stewart_real L_h2_bar_err = M_theta_bar_err + a1_bar_err + STEWART_UNIT*STEWART_FABS(L_h2_bar);
        const stewart_real L_h2_bar_max = STEWART_FABS(L_h2_bar) + L_h2_bar_err;
        const stewart_real k13_bar = M_phi_bar*a2 + M_phi_theta_bar*a1 - M_phi_L_bar*h_z;
        const stewart_real k13_bar_err = M_phi_L_bar_err*h_z_max + M_phi_L_bar_max*h_z_err
            + M_phi_bar_err*a2_max + M_phi_bar_max*a2_err + M_phi_theta_bar_err*a1_max
            + M_phi_theta_bar_max*a1_err + STEWART_UNIT*(REAL(2)*M_phi_L_bar_max*h_z_max
            + REAL(2)*M_phi_bar_max*a2_max + REAL(2)*M_phi_theta_bar_max*a1_max + STEWART_FABS(k13_bar));
        const stewart_real k13_bar_max = STEWART_FABS(k13_bar) + k13_bar_err;
        const stewart_real phi_ddot_bar = M_mixed*tau_y_bar + M_phi*tau_k_bar - D_weight*k3_h;
        const stewart_real phi_ddot_bar_err = D_weight_max*k3_h_err + M_mixed_err*tau_y_bar_max
            + M_mixed_max*tau_y_bar_err + M_phi_err*tau_k_bar_max + M_phi_max*tau_k_bar_err
            + STEWART_UNIT*(REAL(2)*D_weight_max*k3_h_max + REAL(2)*M_mixed_max*tau_y_bar_max
            + REAL(2)*M_phi_max*tau_k_bar_max + STEWART_FABS(phi_ddot_bar));
        const stewart_real phi_ddot_bar_max = STEWART_FABS(phi_ddot_bar) + phi_ddot_bar_err;
        const stewart_real theta_ddot_bar = D_weight*h_z + M_mixed*tau_k_bar + M_theta*tau_y_bar;
        const stewart_real theta_ddot_bar_err = D_weight_max*h_z_err + M_mixed_err*tau_k_bar_max
            + M_mixed_max*tau_k_bar_err + M_theta_err*tau_y_bar_max + M_theta_max*tau_y_bar_err
            + STEWART_UNIT*(REAL(2)*D_weight_max*h_z_max + REAL(2)*M_mixed_max*tau_k_bar_max
            + REAL(2)*M_theta_max*tau_y_bar_max + STEWART_FABS(theta_ddot_bar));
        const stewart_real theta_ddot_bar_max = STEWART_FABS(theta_ddot_bar) + theta_ddot_bar_err;
        const stewart_real c2 = inv_rho*k1;
        const stewart_real c2_err = inv_rho_err*k1_max + inv_rho_max*k1_err + STEWART_UNIT*STEWART_FABS(c2);
        const stewart_real c2_max = STEWART_FABS(c2) + c2_err;
        const stewart_real L_ddot_bar = c2*theta_ddot_bar + h_z*tau_y_bar - k3_h*tau_k_bar;
        const stewart_real L_ddot_bar_err = c2_err*theta_ddot_bar_max + c2_max*theta_ddot_bar_err
            + h_z_err*tau_y_bar_max + h_z_max*tau_y_bar_err + k3_h_err*tau_k_bar_max + k3_h_max*tau_k_bar_err
            + STEWART_UNIT*(REAL(2)*c2_max*theta_ddot_bar_max + REAL(2)*h_z_max*tau_y_bar_max
            + REAL(2)*k3_h_max*tau_k_bar_max + STEWART_FABS(L_ddot_bar));
        const stewart_real L_ddot_bar_max = STEWART_FABS(L_ddot_bar) + L_ddot_bar_err;
        const stewart_real c3 = L*L_ddot_bar;
        const stewart_real c3_err = L_ddot_bar_err*L_max + L_ddot_bar_max*L_err + STEWART_UNIT*STEWART_FABS(c3);
        const stewart_real c3_max = STEWART_FABS(c3) + c3_err;
        const stewart_real k33_bar = M_phi_L_bar*h_x + M_phi_bar*a1 + c3*phi_dot2 - M_phi_theta_bar*a2;
        const stewart_real k33_bar_err = M_phi_L_bar_err*h_x_max + M_phi_L_bar_max*h_x_err
            + M_phi_bar_err*a1_max + M_phi_bar_max*a1_err + M_phi_theta_bar_err*a2_max
            + M_phi_theta_bar_max*a2_err + c3_err*phi_dot2_max + c3_max*phi_dot2_err
            + STEWART_UNIT*(REAL(3)*M_phi_L_bar_max*h_x_max + REAL(3)*M_phi_bar_max*a1_max
            + REAL(3)*M_phi_theta_bar_max*a2_max + REAL(3)*c3_max*phi_dot2_max + STEWART_FABS(k33_bar));
        const stewart_real k33_bar_max = STEWART_FABS(k33_bar) + k33_bar_err;
        const stewart_real c4 = theta_ddot_bar*theta_dot;
        const stewart_real c4_err = theta_ddot_bar_err*theta_dot_max + theta_ddot_bar_max*theta_dot_err
            + STEWART_UNIT*STEWART_FABS(c4);
        const stewart_real rho_share_bar = -c4 - phi_ddot_bar*two_phi_dot;
        const stewart_real rho_share_bar_err = c4_err + phi_ddot_bar_err*two_phi_dot_max
            + phi_ddot_bar_max*two_phi_dot_err + STEWART_UNIT*(phi_ddot_bar_max*two_phi_dot_max
            + STEWART_FABS(rho_share_bar));
        const stewart_real rho_share_bar_max = STEWART_FABS(rho_share_bar) + rho_share_bar_err;
        const stewart_real two_phi_dot_bar = tau_k_bar*(L_dot*M_phi_L + M_phi_theta*theta_dot)
            - phi_ddot_bar*rho_share;
        const stewart_real two_phi_dot_bar_err = L_dot_err*M_phi_L_max*tau_k_bar_max
            + L_dot_max*M_phi_L_err*tau_k_bar_max + M_phi_theta_err*tau_k_bar_max*theta_dot_max
            + M_phi_theta_max*tau_k_bar_max*theta_dot_err + phi_ddot_bar_err*rho_share_max
            + phi_ddot_bar_max*rho_share_err + tau_k_bar_err*(L_dot_max*M_phi_L_max
            + M_phi_theta_max*theta_dot_max) + STEWART_UNIT*(phi_ddot_bar_max*rho_share_max
            + tau_k_bar_max*(L_dot_max*M_phi_L_max + M_phi_theta_max*theta_dot_max)
            + tau_k_bar_max*(REAL(2)*L_dot_max*M_phi_L_max + REAL(2)*M_phi_theta_max*theta_dot_max)
            + STEWART_FABS(two_phi_dot_bar));
        const stewart_real two_phi_dot_bar_max = STEWART_FABS(two_phi_dot_bar) + two_phi_dot_bar_err;
        const stewart_real phi_dot2_bar = L*L_ddot_bar*k33 - D_weight*M_phi_L - M_phi_theta*tau_y_bar;
        const stewart_real phi_dot2_bar_err = D_weight_max*M_phi_L_err + L_ddot_bar_err*L_max*k33_max
            + L_ddot_bar_max*L_err*k33_max + L_ddot_bar_max*L_max*k33_err + M_phi_theta_err*tau_y_bar_max
            + M_phi_theta_max*tau_y_bar_err + STEWART_UNIT*(REAL(2)*D_weight_max*M_phi_L_max
            + REAL(3)*L_ddot_bar_max*L_max*k33_max + REAL(2)*M_phi_theta_max*tau_y_bar_max
            + STEWART_FABS(phi_dot2_bar));
        const stewart_real phi_dot2_bar_max = STEWART_FABS(phi_dot2_bar) + phi_dot2_bar_err;
        const stewart_real theta_dot2_bar = M_mixed_theta*tau_k_bar + c3 - D_weight*h_x;
        const stewart_real theta_dot2_bar_err = D_weight_max*h_x_err + M_mixed_theta_err*tau_k_bar_max
            + M_mixed_theta_max*tau_k_bar_err + c3_err + STEWART_UNIT*(REAL(2)*D_weight_max*h_x_max
            + REAL(2)*M_mixed_theta_max*tau_k_bar_max + c3_max + STEWART_FABS(theta_dot2_bar));
        const stewart_real theta_dot2_bar_max = STEWART_FABS(theta_dot2_bar) + theta_dot2_bar_err;
        const stewart_real L_share_bar = rho_share_bar - c4;
        const stewart_real L_share_bar_err = c4_err + rho_share_bar_err
            + STEWART_UNIT*STEWART_FABS(L_share_bar);
        const stewart_real L_share_bar_max = STEWART_FABS(L_share_bar) + L_share_bar_err;
        const stewart_real c5 = tau_k_bar*two_phi_dot;
        const stewart_real c5_err = tau_k_bar_err*two_phi_dot_max + tau_k_bar_max*two_phi_dot_err
            + STEWART_UNIT*STEWART_FABS(c5);
        const stewart_real c5_max = STEWART_FABS(c5) + c5_err;
        const stewart_real c6 = C_s*Y_moment_x;
        const stewart_real c6_err = STEWART_UNIT*STEWART_FABS(c6);
        const stewart_real c6_max = STEWART_FABS(c6) + c6_err;
        const stewart_real c7 = C_s*Y_moment_y;
        const stewart_real c7_err = STEWART_UNIT*STEWART_FABS(c7);
        const stewart_real c7_max = STEWART_FABS(c7) + c7_err;
        const stewart_real c8 = C_s*Y_moment_z;
        const stewart_real c8_err = STEWART_UNIT*STEWART_FABS(c8);
        const stewart_real c8_max = STEWART_FABS(c8) + c8_err;
        const stewart_real theta_dot_bar = C_us*tau_y_bar + L_dot*bend_bar + M_phi_theta*c5
            + kappa*rho_share_bar + theta_ddot_bar*(-L_share - rho_share) + REAL(2)*theta_dot*theta_dot2_bar
            - c6*y_x - c7*y_y - c8*y_z;
        const stewart_real theta_dot_bar_err = C_us_err*tau_y_bar_max + C_us_max*tau_y_bar_err
            + L_dot_err*bend_bar_max + L_dot_max*bend_bar_err + L_share_err*theta_ddot_bar_max
            + M_phi_theta_err*c5_max + M_phi_theta_max*c5_err + c6_err*y_x_max + c6_max*y_x_err + c7_err*y_y_max
            + c7_max*y_y_err + c8_err*y_z_max + c8_max*y_z_err + kappa_err*rho_share_bar_max
            + kappa_max*rho_share_bar_err + rho_share_err*theta_ddot_bar_max + theta_ddot_bar_err*(L_share_max
            + rho_share_max) + REAL(2)*theta_dot2_bar_err*theta_dot_max
            + REAL(2)*theta_dot2_bar_max*theta_dot_err + STEWART_UNIT*(REAL(8)*C_us_max*tau_y_bar_max
            + REAL(8)*L_dot_max*bend_bar_max + REAL(8)*M_phi_theta_max*c5_max + REAL(8)*c6_max*y_x_max
            + REAL(8)*c7_max*y_y_max + REAL(8)*c8_max*y_z_max + REAL(8)*kappa_max*rho_share_bar_max
            + REAL(9)*theta_ddot_bar_max*(L_share_max + rho_share_max)
            + REAL(16)*theta_dot2_bar_max*theta_dot_max + STEWART_FABS(theta_dot_bar));
        const stewart_real theta_dot_bar_max = STEWART_FABS(theta_dot_bar) + theta_dot_bar_err;
        const stewart_real phi_dot_bar = C_us*tau_k_bar + REAL(2)*phi_dot*phi_dot2_bar + REAL(2)*two_phi_dot_bar
            - c6*k_x - c7*k_y - c8*k_z;
        const stewart_real phi_dot_bar_err = C_us_err*tau_k_bar_max + C_us_max*tau_k_bar_err + c6_err*k_x_max
            + c6_max*k_x_err + c7_err*k_y_max + c7_max*k_y_err + c8_err*k_z_max + c8_max*k_z_err
            + REAL(2)*phi_dot2_bar_err*phi_dot_max + REAL(2)*phi_dot2_bar_max*phi_dot_err
            + REAL(2)*two_phi_dot_bar_err + STEWART_UNIT*(REAL(5)*C_us_max*tau_k_bar_max
            + REAL(5)*c6_max*k_x_max + REAL(5)*c7_max*k_y_max + REAL(5)*c8_max*k_z_max
            + REAL(10)*phi_dot2_bar_max*phi_dot_max + REAL(8)*two_phi_dot_bar_max + STEWART_FABS(phi_dot_bar));
        const stewart_real phi_dot_bar_max = STEWART_FABS(phi_dot_bar) + phi_dot_bar_err;
        const stewart_real L_dot_bar = C_p*D_weight + L_share_bar*inv_L + M_phi_L*c5 + bend_bar*theta_dot
            + c2*theta_dot_bar;
        const stewart_real L_dot_bar_err = L_share_bar_err*inv_L_max + L_share_bar_max*inv_L_err
            + M_phi_L_err*c5_max + M_phi_L_max*c5_err + bend_bar_err*theta_dot_max + bend_bar_max*theta_dot_err
            + c2_err*theta_dot_bar_max + c2_max*theta_dot_bar_err + STEWART_UNIT*(REAL(4)*C_p_max*D_weight_max
            + REAL(4)*L_share_bar_max*inv_L_max + REAL(4)*M_phi_L_max*c5_max
            + REAL(4)*bend_bar_max*theta_dot_max + REAL(4)*c2_max*theta_dot_bar_max + STEWART_FABS(L_dot_bar));
        const stewart_real L_dot_bar_max = STEWART_FABS(L_dot_bar) + L_dot_bar_err;
        const stewart_real c9 = inv_rho*phi_ddot_bar;
        const stewart_real c9_err = inv_rho_err*phi_ddot_bar_max + inv_rho_max*phi_ddot_bar_err
            + STEWART_UNIT*STEWART_FABS(c9);
        const stewart_real c9_max = STEWART_FABS(c9) + c9_err;
        const stewart_real c10 = inv_rho*theta_ddot_bar;
        const stewart_real c10_err = inv_rho_err*theta_ddot_bar_max + inv_rho_max*theta_ddot_bar_err
            + STEWART_UNIT*STEWART_FABS(c10);
        const stewart_real c10_max = STEWART_FABS(c10) + c10_err;
        const stewart_real S_ddot_z_bar = L_ddot_bar*s_z + c9*y_z - c10*k_z;
        const stewart_real S_ddot_z_bar_err = L_ddot_bar_err*s_z_max + L_ddot_bar_max*s_z_err + c10_err*k_z_max
            + c10_max*k_z_err + c9_err*y_z_max + c9_max*y_z_err + STEWART_UNIT*(REAL(2)*L_ddot_bar_max*s_z_max
            + REAL(2)*c10_max*k_z_max + REAL(2)*c9_max*y_z_max + STEWART_FABS(S_ddot_z_bar));
        const stewart_real S_ddot_z_bar_max = STEWART_FABS(S_ddot_z_bar) + S_ddot_z_bar_err;
        const stewart_real S_ddot_y_bar = L_ddot_bar*s_y + c9*y_y - c10*k_y;
        const stewart_real S_ddot_y_bar_err = L_ddot_bar_err*s_y_max + L_ddot_bar_max*s_y_err + c10_err*k_y_max
            + c10_max*k_y_err + c9_err*y_y_max + c9_max*y_y_err + STEWART_UNIT*(REAL(2)*L_ddot_bar_max*s_y_max
            + REAL(2)*c10_max*k_y_max + REAL(2)*c9_max*y_y_max + STEWART_FABS(S_ddot_y_bar));
        const stewart_real S_ddot_y_bar_max = STEWART_FABS(S_ddot_y_bar) + S_ddot_y_bar_err;
        const stewart_real S_ddot_x_bar = L_ddot_bar*s_x + c9*y_x - c10*k_x;
        const stewart_real S_ddot_x_bar_err = L_ddot_bar_err*s_x_max + L_ddot_bar_max*s_x_err + c10_err*k_x_max
            + c10_max*k_x_err + c9_err*y_x_max + c9_max*y_x_err + STEWART_UNIT*(REAL(2)*L_ddot_bar_max*s_x_max
            + REAL(2)*c10_max*k_x_max + REAL(2)*c9_max*y_x_max + STEWART_FABS(S_ddot_x_bar));
        const stewart_real S_ddot_x_bar_max = STEWART_FABS(S_ddot_x_bar) + S_ddot_x_bar_err;
        const stewart_real c11 = inv_rho*phi_dot_bar;
        const stewart_real c11_err = inv_rho_err*phi_dot_bar_max + inv_rho_max*phi_dot_bar_err
            + STEWART_UNIT*STEWART_FABS(c11);
        const stewart_real c11_max = STEWART_FABS(c11) + c11_err;
        const stewart_real c12 = inv_rho*theta_dot_bar;
        const stewart_real c12_err = inv_rho_err*theta_dot_bar_max + inv_rho_max*theta_dot_bar_err
            + STEWART_UNIT*STEWART_FABS(c12);
        const stewart_real c12_max = STEWART_FABS(c12) + c12_err;
        const stewart_real S_dot_z_bar = L_dot_bar*s_z + c11*y_z - c12*k_z;
        const stewart_real S_dot_z_bar_err = L_dot_bar_err*s_z_max + L_dot_bar_max*s_z_err + c11_err*y_z_max
            + c11_max*y_z_err + c12_err*k_z_max + c12_max*k_z_err + STEWART_UNIT*(REAL(2)*L_dot_bar_max*s_z_max
            + REAL(2)*c11_max*y_z_max + REAL(2)*c12_max*k_z_max + STEWART_FABS(S_dot_z_bar));
        const stewart_real S_dot_z_bar_max = STEWART_FABS(S_dot_z_bar) + S_dot_z_bar_err;
        const stewart_real S_dot_y_bar = L_dot_bar*s_y + c11*y_y - c12*k_y;
        const stewart_real S_dot_y_bar_err = L_dot_bar_err*s_y_max + L_dot_bar_max*s_y_err + c11_err*y_y_max
            + c11_max*y_y_err + c12_err*k_y_max + c12_max*k_y_err + STEWART_UNIT*(REAL(2)*L_dot_bar_max*s_y_max
            + REAL(2)*c11_max*y_y_max + REAL(2)*c12_max*k_y_max + STEWART_FABS(S_dot_y_bar));
        const stewart_real S_dot_y_bar_max = STEWART_FABS(S_dot_y_bar) + S_dot_y_bar_err;
        const stewart_real S_dot_x_bar = L_dot_bar*s_x + c11*y_x - c12*k_x;
        const stewart_real S_dot_x_bar_err = L_dot_bar_err*s_x_max + L_dot_bar_max*s_x_err + c11_err*y_x_max
            + c11_max*y_x_err + c12_err*k_x_max + c12_max*k_x_err + STEWART_UNIT*(REAL(2)*L_dot_bar_max*s_x_max
            + REAL(2)*c11_max*y_x_max + REAL(2)*c12_max*k_x_max + STEWART_FABS(S_dot_x_bar));
        const stewart_real S_dot_x_bar_max = STEWART_FABS(S_dot_x_bar) + S_dot_x_bar_err;
        const stewart_real kappa_bar = rho_share_bar*theta_dot;
        const stewart_real kappa_bar_err = rho_share_bar_err*theta_dot_max + rho_share_bar_max*theta_dot_err
            + STEWART_UNIT*STEWART_FABS(kappa_bar);
        const stewart_real kappa_bar_max = STEWART_FABS(kappa_bar) + kappa_bar_err;
        const stewart_real k3_bar = J_yz*M_mixed_bar + h_y*k3_h_bar + k1*k13_bar + REAL(2)*k3*k33_bar
            + w_k_bar*w_z + w_n_bar*w_x - M_mixed_theta_bar*a3;
        const stewart_real k3_bar_err = J_yz_err*M_mixed_bar_max + J_yz_max*M_mixed_bar_err
            + M_mixed_theta_bar_err*a3_max + M_mixed_theta_bar_max*a3_err + h_y_err*k3_h_bar_max
            + h_y_max*k3_h_bar_err + k13_bar_err*k1_max + k13_bar_max*k1_err + REAL(2)*k33_bar_err*k3_max
            + REAL(2)*k33_bar_max*k3_err + w_k_bar_err*w_z_max + w_k_bar_max*w_z_err + w_n_bar_err*w_x_max
            + w_n_bar_max*w_x_err + STEWART_UNIT*(REAL(6)*J_yz_max*M_mixed_bar_max
            + REAL(6)*M_mixed_theta_bar_max*a3_max + REAL(6)*h_y_max*k3_h_bar_max + REAL(6)*k13_bar_max*k1_max
            + REAL(12)*k33_bar_max*k3_max + REAL(6)*w_k_bar_max*w_z_max + REAL(6)*w_n_bar_max*w_x_max
            + STEWART_FABS(k3_bar));
        const stewart_real k3_bar_max = STEWART_FABS(k3_bar) + k3_bar_err;
        const stewart_real k1_bar = J_yz*M_mixed_theta_bar + L_ddot*c10 + L_dot*c12 + M_mixed_bar*a3
            + k13_bar*k3 + w_k_bar*w_x - D_weight*Q_k - bend*c1 - w_n_bar*w_z;
        const stewart_real k1_bar_err = D_weight_max*Q_k_err + J_yz_err*M_mixed_theta_bar_max
            + J_yz_max*M_mixed_theta_bar_err + L_ddot_err*c10_max + L_ddot_max*c10_err + L_dot_err*c12_max
            + L_dot_max*c12_err + M_mixed_bar_err*a3_max + M_mixed_bar_max*a3_err + bend_err*c1_max
            + bend_max*c1_err + k13_bar_err*k3_max + k13_bar_max*k3_err + w_k_bar_err*w_x_max
            + w_k_bar_max*w_x_err + w_n_bar_err*w_z_max + w_n_bar_max*w_z_err
            + STEWART_UNIT*(REAL(8)*D_weight_max*Q_k_max + REAL(8)*J_yz_max*M_mixed_theta_bar_max
            + REAL(8)*L_ddot_max*c10_max + REAL(8)*L_dot_max*c12_max + REAL(8)*M_mixed_bar_max*a3_max
            + REAL(8)*bend_max*c1_max + REAL(8)*k13_bar_max*k3_max + REAL(8)*w_k_bar_max*w_x_max
            + REAL(8)*w_n_bar_max*w_z_max + STEWART_FABS(k1_bar));
        const stewart_real k1_bar_max = STEWART_FABS(k1_bar) + k1_bar_err;
        const stewart_real c13 = C_s*tau_y_bar;
        const stewart_real c13_err = C_s_max*tau_y_bar_err + STEWART_UNIT*STEWART_FABS(c13);
        const stewart_real c13_max = STEWART_FABS(c13) + c13_err;
        const stewart_real y_z_bar = K_z_bar*Q_y + S_ddot_z*c9 + S_dot_z*c11 + g_x_k_z*gamma_n_bar
            + g_z*gamma_y_bar - c13*omega_z - c8*theta_dot;
        const stewart_real y_z_bar_err = K_z_bar_err*Q_y_max + K_z_bar_max*Q_y_err + S_ddot_z_err*c9_max
            + S_ddot_z_max*c9_err + S_dot_z_err*c11_max + S_dot_z_max*c11_err + c13_err*omega_z_max
            + c8_err*theta_dot_max + c8_max*theta_dot_err + g_x_k_z_err*gamma_n_bar_max
            + g_x_k_z_max*gamma_n_bar_err + g_z_max*gamma_y_bar_err + STEWART_UNIT*(REAL(6)*K_z_bar_max*Q_y_max
            + REAL(6)*S_ddot_z_max*c9_max + REAL(6)*S_dot_z_max*c11_max + REAL(6)*c13_max*omega_z_max
            + REAL(6)*c8_max*theta_dot_max + REAL(6)*g_x_k_z_max*gamma_n_bar_max
            + REAL(6)*g_z_max*gamma_y_bar_max + STEWART_FABS(y_z_bar));
        const stewart_real y_z_bar_max = STEWART_FABS(y_z_bar) + y_z_bar_err;
        const stewart_real y_y_bar = K_y_bar*Q_y + S_ddot_y*c9 + S_dot_y*c11 + g_x_k_y*gamma_n_bar
            + g_y*gamma_y_bar - c13*omega_y - c7*theta_dot;
        const stewart_real y_y_bar_err = K_y_bar_err*Q_y_max + K_y_bar_max*Q_y_err + S_ddot_y_err*c9_max
            + S_ddot_y_max*c9_err + S_dot_y_err*c11_max + S_dot_y_max*c11_err + c13_err*omega_y_max
            + c7_err*theta_dot_max + c7_max*theta_dot_err + g_x_k_y_err*gamma_n_bar_max
            + g_x_k_y_max*gamma_n_bar_err + g_y_max*gamma_y_bar_err + STEWART_UNIT*(REAL(6)*K_y_bar_max*Q_y_max
            + REAL(6)*S_ddot_y_max*c9_max + REAL(6)*S_dot_y_max*c11_max + REAL(6)*c13_max*omega_y_max
            + REAL(6)*c7_max*theta_dot_max + REAL(6)*g_x_k_y_max*gamma_n_bar_max
            + REAL(6)*g_y_max*gamma_y_bar_max + STEWART_FABS(y_y_bar));
        const stewart_real y_y_bar_max = STEWART_FABS(y_y_bar) + y_y_bar_err;
        const stewart_real y_x_bar = K_x_bar*Q_y + S_ddot_x*c9 + S_dot_x*c11 + g_x*gamma_y_bar
            + g_x_k_x*gamma_n_bar - c13*omega_x - c6*theta_dot;
        const stewart_real y_x_bar_err = K_x_bar_err*Q_y_max + K_x_bar_max*Q_y_err + S_ddot_x_err*c9_max
            + S_ddot_x_max*c9_err + S_dot_x_err*c11_max + S_dot_x_max*c11_err + c13_err*omega_x_max
            + c6_err*theta_dot_max + c6_max*theta_dot_err + g_x_k_x_err*gamma_n_bar_max
            + g_x_k_x_max*gamma_n_bar_err + g_x_max*gamma_y_bar_err + STEWART_UNIT*(REAL(6)*K_x_bar_max*Q_y_max
            + REAL(6)*S_ddot_x_max*c9_max + REAL(6)*S_dot_x_max*c11_max + REAL(6)*c13_max*omega_x_max
            + REAL(6)*c6_max*theta_dot_max + REAL(6)*g_x_k_x_max*gamma_n_bar_max
            + REAL(6)*g_x_max*gamma_y_bar_max + STEWART_FABS(y_x_bar));
        const stewart_real y_x_bar_max = STEWART_FABS(y_x_bar) + y_x_bar_err;
        const stewart_real inv_rho_bar = Q_y_bar*tau_k + k_cross_S_x*y_x_bar + k_cross_S_y*y_y_bar
            + k_cross_S_z*y_z_bar + kappa_bar*zeta + phi_ddot_bar*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z)
            + phi_dot_bar*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z) + theta_ddot_bar*(L_ddot*k1 - S_ddot_x*k_x
            - S_ddot_y*k_y - S_ddot_z*k_z) + theta_dot_bar*(L_dot*k1 - S_dot_x*k_x - S_dot_y*k_y - S_dot_z*k_z)
            - Q_k_bar*tau_y;
        const stewart_real inv_rho_bar_err = L_ddot_err*k1_max*theta_ddot_bar_max
            + L_dot_err*k1_max*theta_dot_bar_max + Q_k_bar_err*tau_y_max + Q_k_bar_max*tau_y_err
            + Q_y_bar_err*tau_k_max + Q_y_bar_max*tau_k_err + S_ddot_x_err*(k_x_max*theta_ddot_bar_max
            + phi_ddot_bar_max*y_x_max) + S_ddot_y_err*(k_y_max*theta_ddot_bar_max + phi_ddot_bar_max*y_y_max)
            + S_ddot_z_err*(k_z_max*theta_ddot_bar_max + phi_ddot_bar_max*y_z_max)
            + S_dot_x_err*(k_x_max*theta_dot_bar_max + phi_dot_bar_max*y_x_max)
            + S_dot_y_err*(k_y_max*theta_dot_bar_max + phi_dot_bar_max*y_y_max)
            + S_dot_z_err*(k_z_max*theta_dot_bar_max + phi_dot_bar_max*y_z_max)
            + k1_err*(L_ddot_max*theta_ddot_bar_max + L_dot_max*theta_dot_bar_max) + k_cross_S_x_err*y_x_bar_max
            + k_cross_S_x_max*y_x_bar_err + k_cross_S_y_err*y_y_bar_max + k_cross_S_y_max*y_y_bar_err
            + k_cross_S_z_err*y_z_bar_max + k_cross_S_z_max*y_z_bar_err
            + k_x_err*(S_ddot_x_max*theta_ddot_bar_max + S_dot_x_max*theta_dot_bar_max)
            + k_y_err*(S_ddot_y_max*theta_ddot_bar_max + S_dot_y_max*theta_dot_bar_max)
            + k_z_err*(S_ddot_z_max*theta_ddot_bar_max + S_dot_z_max*theta_dot_bar_max) + kappa_bar_err*zeta_max
            + kappa_bar_max*zeta_err + phi_ddot_bar_err*(S_ddot_x_max*y_x_max + S_ddot_y_max*y_y_max
            + S_ddot_z_max*y_z_max) + phi_dot_bar_err*(S_dot_x_max*y_x_max + S_dot_y_max*y_y_max
            + S_dot_z_max*y_z_max) + theta_ddot_bar_err*(L_ddot_max*k1_max + S_ddot_x_max*k_x_max
            + S_ddot_y_max*k_y_max + S_ddot_z_max*k_z_max) + theta_dot_bar_err*(L_dot_max*k1_max
            + S_dot_x_max*k_x_max + S_dot_y_max*k_y_max + S_dot_z_max*k_z_max)
            + y_x_err*(S_ddot_x_max*phi_ddot_bar_max + S_dot_x_max*phi_dot_bar_max)
            + y_y_err*(S_ddot_y_max*phi_ddot_bar_max + S_dot_y_max*phi_dot_bar_max)
            + y_z_err*(S_ddot_z_max*phi_ddot_bar_max + S_dot_z_max*phi_dot_bar_max)
            + STEWART_UNIT*(REAL(9)*Q_k_bar_max*tau_y_max + REAL(9)*Q_y_bar_max*tau_k_max
            + REAL(9)*k_cross_S_x_max*y_x_bar_max + REAL(9)*k_cross_S_y_max*y_y_bar_max
            + REAL(9)*k_cross_S_z_max*y_z_bar_max + REAL(9)*kappa_bar_max*zeta_max
            + REAL(9)*phi_ddot_bar_max*(S_ddot_x_max*y_x_max + S_ddot_y_max*y_y_max + S_ddot_z_max*y_z_max)
            + phi_ddot_bar_max*(REAL(3)*S_ddot_x_max*y_x_max + REAL(3)*S_ddot_y_max*y_y_max
            + REAL(3)*S_ddot_z_max*y_z_max) + REAL(9)*phi_dot_bar_max*(S_dot_x_max*y_x_max + S_dot_y_max*y_y_max
            + S_dot_z_max*y_z_max) + phi_dot_bar_max*(REAL(3)*S_dot_x_max*y_x_max + REAL(3)*S_dot_y_max*y_y_max
            + REAL(3)*S_dot_z_max*y_z_max) + REAL(9)*theta_ddot_bar_max*(L_ddot_max*k1_max
            + S_ddot_x_max*k_x_max + S_ddot_y_max*k_y_max + S_ddot_z_max*k_z_max)
            + theta_ddot_bar_max*(REAL(4)*L_ddot_max*k1_max + REAL(4)*S_ddot_x_max*k_x_max
            + REAL(4)*S_ddot_y_max*k_y_max + REAL(4)*S_ddot_z_max*k_z_max)
            + REAL(9)*theta_dot_bar_max*(L_dot_max*k1_max + S_dot_x_max*k_x_max + S_dot_y_max*k_y_max
            + S_dot_z_max*k_z_max) + theta_dot_bar_max*(REAL(4)*L_dot_max*k1_max + REAL(4)*S_dot_x_max*k_x_max
            + REAL(4)*S_dot_y_max*k_y_max + REAL(4)*S_dot_z_max*k_z_max) + STEWART_FABS(inv_rho_bar));
        const stewart_real inv_rho_bar_max = STEWART_FABS(inv_rho_bar) + inv_rho_bar_err;
        const stewart_real s_z_bar = H_force_z_bar + H_moment_x_bar*r_y + L_ddot_bar*S_ddot_z
            + L_dot_bar*S_dot_z - H_moment_y_bar*r_x;
        const stewart_real s_z_bar_err = H_force_z_bar_err + H_moment_x_bar_err*r_y_max
            + H_moment_x_bar_max*r_y_err + H_moment_y_bar_err*r_x_max + H_moment_y_bar_max*r_x_err
            + L_ddot_bar_err*S_ddot_z_max + L_ddot_bar_max*S_ddot_z_err + L_dot_bar_err*S_dot_z_max
            + L_dot_bar_max*S_dot_z_err + STEWART_UNIT*(REAL(3)*H_force_z_bar_max
            + REAL(4)*H_moment_x_bar_max*r_y_max + REAL(4)*H_moment_y_bar_max*r_x_max
            + REAL(4)*L_ddot_bar_max*S_ddot_z_max + REAL(4)*L_dot_bar_max*S_dot_z_max + STEWART_FABS(s_z_bar));
        const stewart_real s_z_bar_max = STEWART_FABS(s_z_bar) + s_z_bar_err;
        const stewart_real s_y_bar = H_force_y_bar + H_moment_z_bar*r_x + L_ddot_bar*S_ddot_y
            + L_dot_bar*S_dot_y - H_moment_x_bar*r_z;
        const stewart_real s_y_bar_err = H_force_y_bar_err + H_moment_x_bar_err*r_z_max
            + H_moment_x_bar_max*r_z_err + H_moment_z_bar_err*r_x_max + H_moment_z_bar_max*r_x_err
            + L_ddot_bar_err*S_ddot_y_max + L_ddot_bar_max*S_ddot_y_err + L_dot_bar_err*S_dot_y_max
            + L_dot_bar_max*S_dot_y_err + STEWART_UNIT*(REAL(3)*H_force_y_bar_max
            + REAL(4)*H_moment_x_bar_max*r_z_max + REAL(4)*H_moment_z_bar_max*r_x_max
            + REAL(4)*L_ddot_bar_max*S_ddot_y_max + REAL(4)*L_dot_bar_max*S_dot_y_max + STEWART_FABS(s_y_bar));
        const stewart_real s_y_bar_max = STEWART_FABS(s_y_bar) + s_y_bar_err;
        const stewart_real s_x_bar = H_force_x_bar + H_moment_y_bar*r_z + L_ddot_bar*S_ddot_x
            + L_dot_bar*S_dot_x - H_moment_z_bar*r_y;
        const stewart_real s_x_bar_err = H_force_x_bar_err + H_moment_y_bar_err*r_z_max
            + H_moment_y_bar_max*r_z_err + H_moment_z_bar_err*r_y_max + H_moment_z_bar_max*r_y_err
            + L_ddot_bar_err*S_ddot_x_max + L_ddot_bar_max*S_ddot_x_err + L_dot_bar_err*S_dot_x_max
            + L_dot_bar_max*S_dot_x_err + STEWART_UNIT*(REAL(3)*H_force_x_bar_max
            + REAL(4)*H_moment_y_bar_max*r_z_max + REAL(4)*H_moment_z_bar_max*r_y_max
            + REAL(4)*L_ddot_bar_max*S_ddot_x_max + REAL(4)*L_dot_bar_max*S_dot_x_max + STEWART_FABS(s_x_bar));
        const stewart_real s_x_bar_max = STEWART_FABS(s_x_bar) + s_x_bar_err;
        const stewart_real inv_L_bar = L_dot*L_share_bar + S_x*s_x_bar + S_y*s_y_bar + S_z*s_z_bar + k1_bar*zeta
            + k3_bar*rho;
        const stewart_real inv_L_bar_err = L_dot_err*L_share_bar_max + L_dot_max*L_share_bar_err
            + S_x_err*s_x_bar_max + S_x_max*s_x_bar_err + S_y_err*s_y_bar_max + S_y_max*s_y_bar_err
            + S_z_err*s_z_bar_max + S_z_max*s_z_bar_err + k1_bar_err*zeta_max + k1_bar_max*zeta_err
            + k3_bar_err*rho_max + k3_bar_max*rho_err + STEWART_UNIT*(REAL(5)*L_dot_max*L_share_bar_max
            + REAL(5)*S_x_max*s_x_bar_max + REAL(5)*S_y_max*s_y_bar_max + REAL(5)*S_z_max*s_z_bar_max
            + REAL(5)*k1_bar_max*zeta_max + REAL(5)*k3_bar_max*rho_max + STEWART_FABS(inv_L_bar));
        const stewart_real inv_L_bar_max = STEWART_FABS(inv_L_bar) + inv_L_bar_err;
        const stewart_real rho_bar = inv_L*k3_bar - inv_rho_bar*inv_rho*inv_rho;
        const stewart_real rho_bar_err = inv_L_err*k3_bar_max + inv_L_max*k3_bar_err
            + inv_rho_bar_err*inv_rho_max*inv_rho_max + REAL(2)*inv_rho_bar_max*inv_rho_err*inv_rho_max
            + STEWART_UNIT*(inv_L_max*k3_bar_max + REAL(2)*inv_rho_bar_max*inv_rho_max*inv_rho_max
            + STEWART_FABS(rho_bar));
        const stewart_real rho_bar_max = STEWART_FABS(rho_bar) + rho_bar_err;
        const stewart_real L_bar = L_ddot_bar*(k33*phi_dot2 + theta_dot2) + L_h2_bar*h2_x - a2_bar*h2_z
            - a3_bar*h_y - inv_L_bar*inv_L*inv_L;
        const stewart_real L_bar_err = L_ddot_bar_err*(k33_max*phi_dot2_max + theta_dot2_max)
            + L_ddot_bar_max*k33_err*phi_dot2_max + L_ddot_bar_max*k33_max*phi_dot2_err
            + L_ddot_bar_max*theta_dot2_err + L_h2_bar_err*h2_x_max + L_h2_bar_max*h2_x_err
            + a2_bar_err*h2_z_max + a2_bar_max*h2_z_err + a3_bar_err*h_y_max + a3_bar_max*h_y_err
            + inv_L_bar_err*inv_L_max*inv_L_max + REAL(2)*inv_L_bar_max*inv_L_err*inv_L_max
            + STEWART_UNIT*(REAL(4)*L_ddot_bar_max*(k33_max*phi_dot2_max + theta_dot2_max)
            + L_ddot_bar_max*(REAL(2)*k33_max*phi_dot2_max + theta_dot2_max) + REAL(4)*L_h2_bar_max*h2_x_max
            + REAL(4)*a2_bar_max*h2_z_max + REAL(4)*a3_bar_max*h_y_max
            + REAL(5)*inv_L_bar_max*inv_L_max*inv_L_max + STEWART_FABS(L_bar));
        const stewart_real L_bar_max = STEWART_FABS(L_bar) + L_bar_err;
        const stewart_real c14 = L_bar*inv_L;
        const stewart_real c14_err = L_bar_err*inv_L_max + L_bar_max*inv_L_err + STEWART_UNIT*STEWART_FABS(c14);
        const stewart_real c14_max = STEWART_FABS(c14) + c14_err;
        const stewart_real rho2_bar = STEWART_HALF*c14 + STEWART_HALF*inv_rho*rho_bar;
        const stewart_real rho2_bar_err = STEWART_HALF*c14_err + STEWART_HALF*inv_rho_err*rho_bar_max
            + STEWART_HALF*inv_rho_max*rho_bar_err + STEWART_UNIT*(STEWART_HALF*inv_rho_max*rho_bar_max
            + STEWART_FABS(rho2_bar));
        const stewart_real rho2_bar_max = STEWART_FABS(rho2_bar) + rho2_bar_err;
        const stewart_real c15 = REAL(2)*rho2_bar;
        const stewart_real c15_err = REAL(2)*rho2_bar_err;
        const stewart_real c15_max = STEWART_FABS(c15) + c15_err;
        const stewart_real k_cross_S_z_bar = c15*k_cross_S_z + inv_rho*y_z_bar;
        const stewart_real k_cross_S_z_bar_err = c15_err*k_cross_S_z_max + c15_max*k_cross_S_z_err
            + inv_rho_err*y_z_bar_max + inv_rho_max*y_z_bar_err + STEWART_UNIT*(c15_max*k_cross_S_z_max
            + inv_rho_max*y_z_bar_max + STEWART_FABS(k_cross_S_z_bar));
        const stewart_real k_cross_S_z_bar_max = STEWART_FABS(k_cross_S_z_bar) + k_cross_S_z_bar_err;
        const stewart_real k_cross_S_y_bar = c15*k_cross_S_y + inv_rho*y_y_bar;
        const stewart_real k_cross_S_y_bar_err = c15_err*k_cross_S_y_max + c15_max*k_cross_S_y_err
            + inv_rho_err*y_y_bar_max + inv_rho_max*y_y_bar_err + STEWART_UNIT*(c15_max*k_cross_S_y_max
            + inv_rho_max*y_y_bar_max + STEWART_FABS(k_cross_S_y_bar));
        const stewart_real k_cross_S_y_bar_max = STEWART_FABS(k_cross_S_y_bar) + k_cross_S_y_bar_err;
        const stewart_real k_cross_S_x_bar = c15*k_cross_S_x + inv_rho*y_x_bar;
        const stewart_real k_cross_S_x_bar_err = c15_err*k_cross_S_x_max + c15_max*k_cross_S_x_err
            + inv_rho_err*y_x_bar_max + inv_rho_max*y_x_bar_err + STEWART_UNIT*(c15_max*k_cross_S_x_max
            + inv_rho_max*y_x_bar_max + STEWART_FABS(k_cross_S_x_bar));
        const stewart_real k_cross_S_x_bar_max = STEWART_FABS(k_cross_S_x_bar) + k_cross_S_x_bar_err;
        const stewart_real zeta_bar = c14*zeta + inv_L*k1_bar + inv_rho*kappa_bar;
        const stewart_real zeta_bar_err = c14_err*zeta_max + c14_max*zeta_err + inv_L_err*k1_bar_max
            + inv_L_max*k1_bar_err + inv_rho_err*kappa_bar_max + inv_rho_max*kappa_bar_err
            + STEWART_UNIT*(REAL(2)*c14_max*zeta_max + REAL(2)*inv_L_max*k1_bar_max
            + REAL(2)*inv_rho_max*kappa_bar_max + STEWART_FABS(zeta_bar));
        const stewart_real zeta_bar_max = STEWART_FABS(zeta_bar) + zeta_bar_err;
        const stewart_real S_z_bar = inv_L*s_z_bar + k_cross_S_x_bar*k_y + k_z*zeta_bar - k_cross_S_y_bar*k_x;
        const stewart_real S_z_bar_err = inv_L_err*s_z_bar_max + inv_L_max*s_z_bar_err
            + k_cross_S_x_bar_err*k_y_max + k_cross_S_x_bar_max*k_y_err + k_cross_S_y_bar_err*k_x_max
            + k_cross_S_y_bar_max*k_x_err + k_z_err*zeta_bar_max + k_z_max*zeta_bar_err
            + STEWART_UNIT*(REAL(3)*inv_L_max*s_z_bar_max + REAL(3)*k_cross_S_x_bar_max*k_y_max
            + REAL(3)*k_cross_S_y_bar_max*k_x_max + REAL(3)*k_z_max*zeta_bar_max + STEWART_FABS(S_z_bar));
        const stewart_real S_z_bar_max = STEWART_FABS(S_z_bar) + S_z_bar_err;
        const stewart_real S_y_bar = inv_L*s_y_bar + k_cross_S_z_bar*k_x + k_y*zeta_bar - k_cross_S_x_bar*k_z;
        const stewart_real S_y_bar_err = inv_L_err*s_y_bar_max + inv_L_max*s_y_bar_err
            + k_cross_S_x_bar_err*k_z_max + k_cross_S_x_bar_max*k_z_err + k_cross_S_z_bar_err*k_x_max
            + k_cross_S_z_bar_max*k_x_err + k_y_err*zeta_bar_max + k_y_max*zeta_bar_err
            + STEWART_UNIT*(REAL(3)*inv_L_max*s_y_bar_max + REAL(3)*k_cross_S_x_bar_max*k_z_max
            + REAL(3)*k_cross_S_z_bar_max*k_x_max + REAL(3)*k_y_max*zeta_bar_max + STEWART_FABS(S_y_bar));
        const stewart_real S_y_bar_max = STEWART_FABS(S_y_bar) + S_y_bar_err;
        const stewart_real S_x_bar = inv_L*s_x_bar + k_cross_S_y_bar*k_z + k_x*zeta_bar - k_cross_S_z_bar*k_y;
        const stewart_real S_x_bar_err = inv_L_err*s_x_bar_max + inv_L_max*s_x_bar_err
            + k_cross_S_y_bar_err*k_z_max + k_cross_S_y_bar_max*k_z_err + k_cross_S_z_bar_err*k_y_max
            + k_cross_S_z_bar_max*k_y_err + k_x_err*zeta_bar_max + k_x_max*zeta_bar_err
            + STEWART_UNIT*(REAL(3)*inv_L_max*s_x_bar_max + REAL(3)*k_cross_S_y_bar_max*k_z_max
            + REAL(3)*k_cross_S_z_bar_max*k_y_max + REAL(3)*k_x_max*zeta_bar_max + STEWART_FABS(S_x_bar));
        const stewart_real S_x_bar_max = STEWART_FABS(S_x_bar) + S_x_bar_err;
        const stewart_real S_1_z_bar = K_x*Y_moment_y + S_z_bar - K_y*Y_moment_x;
        const stewart_real S_1_z_bar_err = K_x_err*Y_moment_y_max + K_y_err*Y_moment_x_max + S_z_bar_err
            + STEWART_UNIT*(REAL(2)*K_x_max*Y_moment_y_max + REAL(2)*K_y_max*Y_moment_x_max + S_z_bar_max
            + STEWART_FABS(S_1_z_bar));
        const stewart_real S_1_z_bar_max = STEWART_FABS(S_1_z_bar) + S_1_z_bar_err;
        const stewart_real S_1_y_bar = K_z*Y_moment_x + S_y_bar - K_x*Y_moment_z;
        const stewart_real S_1_y_bar_err = K_x_err*Y_moment_z_max + K_z_err*Y_moment_x_max + S_y_bar_err
            + STEWART_UNIT*(REAL(2)*K_x_max*Y_moment_z_max + REAL(2)*K_z_max*Y_moment_x_max + S_y_bar_max
            + STEWART_FABS(S_1_y_bar));
        const stewart_real S_1_y_bar_max = STEWART_FABS(S_1_y_bar) + S_1_y_bar_err;
        const stewart_real S_1_x_bar = K_y*Y_moment_z + S_x_bar - K_z*Y_moment_y;
        const stewart_real S_1_x_bar_err = K_y_err*Y_moment_z_max + K_z_err*Y_moment_y_max + S_x_bar_err
            + STEWART_UNIT*(REAL(2)*K_y_max*Y_moment_z_max + REAL(2)*K_z_max*Y_moment_y_max + S_x_bar_max
            + STEWART_FABS(S_1_x_bar));
        const stewart_real S_1_x_bar_max = STEWART_FABS(S_1_x_bar) + S_1_x_bar_err;
        const stewart_real q_z_bar = B_xz*S_ddot_x_bar + B_yz*S_ddot_y_bar + B_zz*S_ddot_z_bar + S_1_z_bar
            + S_dot_x_bar*omega_y - S_dot_y_bar*omega_x;
        const stewart_real q_z_bar_err = B_xz_err*S_ddot_x_bar_max + B_xz_max*S_ddot_x_bar_err
            + B_yz_err*S_ddot_y_bar_max + B_yz_max*S_ddot_y_bar_err + B_zz_err*S_ddot_z_bar_max
            + B_zz_max*S_ddot_z_bar_err + S_1_z_bar_err + S_dot_x_bar_err*omega_y_max
            + S_dot_y_bar_err*omega_x_max + STEWART_UNIT*(REAL(5)*B_xz_max*S_ddot_x_bar_max
            + REAL(5)*B_yz_max*S_ddot_y_bar_max + REAL(5)*B_zz_max*S_ddot_z_bar_max + REAL(4)*S_1_z_bar_max
            + REAL(5)*S_dot_x_bar_max*omega_y_max + REAL(5)*S_dot_y_bar_max*omega_x_max
            + STEWART_FABS(q_z_bar));
        const stewart_real q_z_bar_max = STEWART_FABS(q_z_bar) + q_z_bar_err;
        const stewart_real q_y_bar = B_xy*S_ddot_x_bar + B_yy*S_ddot_y_bar + B_zy*S_ddot_z_bar + S_1_y_bar
            + S_dot_z_bar*omega_x - S_dot_x_bar*omega_z;
        const stewart_real q_y_bar_err = B_xy_err*S_ddot_x_bar_max + B_xy_max*S_ddot_x_bar_err
            + B_yy_err*S_ddot_y_bar_max + B_yy_max*S_ddot_y_bar_err + B_zy_err*S_ddot_z_bar_max
            + B_zy_max*S_ddot_z_bar_err + S_1_y_bar_err + S_dot_x_bar_err*omega_z_max
            + S_dot_z_bar_err*omega_x_max + STEWART_UNIT*(REAL(5)*B_xy_max*S_ddot_x_bar_max
            + REAL(5)*B_yy_max*S_ddot_y_bar_max + REAL(5)*B_zy_max*S_ddot_z_bar_max + REAL(4)*S_1_y_bar_max
            + REAL(5)*S_dot_x_bar_max*omega_z_max + REAL(5)*S_dot_z_bar_max*omega_x_max
            + STEWART_FABS(q_y_bar));
        const stewart_real q_y_bar_max = STEWART_FABS(q_y_bar) + q_y_bar_err;
        const stewart_real q_x_bar = B_xx*S_ddot_x_bar + B_yx*S_ddot_y_bar + B_zx*S_ddot_z_bar + S_1_x_bar
            + S_dot_y_bar*omega_z - S_dot_z_bar*omega_y;
        const stewart_real q_x_bar_err = B_xx_err*S_ddot_x_bar_max + B_xx_max*S_ddot_x_bar_err
            + B_yx_err*S_ddot_y_bar_max + B_yx_max*S_ddot_y_bar_err + B_zx_err*S_ddot_z_bar_max
            + B_zx_max*S_ddot_z_bar_err + S_1_x_bar_err + S_dot_y_bar_err*omega_z_max
            + S_dot_z_bar_err*omega_y_max + STEWART_UNIT*(REAL(5)*B_xx_max*S_ddot_x_bar_max
            + REAL(5)*B_yx_max*S_ddot_y_bar_max + REAL(5)*B_zx_max*S_ddot_z_bar_max + REAL(4)*S_1_x_bar_max
            + REAL(5)*S_dot_y_bar_max*omega_z_max + REAL(5)*S_dot_z_bar_max*omega_y_max
            + STEWART_FABS(q_x_bar));
        const stewart_real q_x_bar_max = STEWART_FABS(q_x_bar) + q_x_bar_err;
        const stewart_real c16 = C_s*tau_k_bar;
        const stewart_real c16_err = C_s_max*tau_k_bar_err + STEWART_UNIT*STEWART_FABS(c16);
        const stewart_real c16_max = STEWART_FABS(c16) + c16_err;
        const stewart_real k_x_bar = K_x_bar*Q_k + S_x*zeta_bar + S_y*k_cross_S_z_bar - S_ddot_x*c10
            - S_dot_x*c12 - S_z*k_cross_S_y_bar - c16*omega_x - c6*phi_dot;
        const stewart_real k_x_bar_err = K_x_bar_err*Q_k_max + K_x_bar_max*Q_k_err + S_ddot_x_err*c10_max
            + S_ddot_x_max*c10_err + S_dot_x_err*c12_max + S_dot_x_max*c12_err + S_x_err*zeta_bar_max
            + S_x_max*zeta_bar_err + S_y_err*k_cross_S_z_bar_max + S_y_max*k_cross_S_z_bar_err
            + S_z_err*k_cross_S_y_bar_max + S_z_max*k_cross_S_y_bar_err + c16_err*omega_x_max
            + c6_err*phi_dot_max + c6_max*phi_dot_err + STEWART_UNIT*(REAL(7)*K_x_bar_max*Q_k_max
            + REAL(7)*S_ddot_x_max*c10_max + REAL(7)*S_dot_x_max*c12_max + REAL(7)*S_x_max*zeta_bar_max
            + REAL(7)*S_y_max*k_cross_S_z_bar_max + REAL(7)*S_z_max*k_cross_S_y_bar_max
            + REAL(7)*c16_max*omega_x_max + REAL(7)*c6_max*phi_dot_max + STEWART_FABS(k_x_bar));
        const stewart_real k_x_bar_max = STEWART_FABS(k_x_bar) + k_x_bar_err;
        const stewart_real k_y_bar = K_y_bar*Q_k + S_y*zeta_bar + S_z*k_cross_S_x_bar - S_ddot_y*c10
            - S_dot_y*c12 - S_x*k_cross_S_z_bar - c16*omega_y - c7*phi_dot;
        const stewart_real k_y_bar_err = K_y_bar_err*Q_k_max + K_y_bar_max*Q_k_err + S_ddot_y_err*c10_max
            + S_ddot_y_max*c10_err + S_dot_y_err*c12_max + S_dot_y_max*c12_err + S_x_err*k_cross_S_z_bar_max
            + S_x_max*k_cross_S_z_bar_err + S_y_err*zeta_bar_max + S_y_max*zeta_bar_err
            + S_z_err*k_cross_S_x_bar_max + S_z_max*k_cross_S_x_bar_err + c16_err*omega_y_max
            + c7_err*phi_dot_max + c7_max*phi_dot_err + STEWART_UNIT*(REAL(7)*K_y_bar_max*Q_k_max
            + REAL(7)*S_ddot_y_max*c10_max + REAL(7)*S_dot_y_max*c12_max + REAL(7)*S_x_max*k_cross_S_z_bar_max
            + REAL(7)*S_y_max*zeta_bar_max + REAL(7)*S_z_max*k_cross_S_x_bar_max + REAL(7)*c16_max*omega_y_max
            + REAL(7)*c7_max*phi_dot_max + STEWART_FABS(k_y_bar));
        const stewart_real k_y_bar_max = STEWART_FABS(k_y_bar) + k_y_bar_err;
        const stewart_real k_z_bar = K_z_bar*Q_k + S_x*k_cross_S_y_bar + S_z*zeta_bar - S_ddot_z*c10
            - S_dot_z*c12 - S_y*k_cross_S_x_bar - c16*omega_z - c8*phi_dot;
        const stewart_real k_z_bar_err = K_z_bar_err*Q_k_max + K_z_bar_max*Q_k_err + S_ddot_z_err*c10_max
            + S_ddot_z_max*c10_err + S_dot_z_err*c12_max + S_dot_z_max*c12_err + S_x_err*k_cross_S_y_bar_max
            + S_x_max*k_cross_S_y_bar_err + S_y_err*k_cross_S_x_bar_max + S_y_max*k_cross_S_x_bar_err
            + S_z_err*zeta_bar_max + S_z_max*zeta_bar_err + c16_err*omega_z_max + c8_err*phi_dot_max
            + c8_max*phi_dot_err + STEWART_UNIT*(REAL(7)*K_z_bar_max*Q_k_max + REAL(7)*S_ddot_z_max*c10_max
            + REAL(7)*S_dot_z_max*c12_max + REAL(7)*S_x_max*k_cross_S_y_bar_max
            + REAL(7)*S_y_max*k_cross_S_x_bar_max + REAL(7)*S_z_max*zeta_bar_max + REAL(7)*c16_max*omega_z_max
            + REAL(7)*c8_max*phi_dot_max + STEWART_FABS(k_z_bar));
        const stewart_real k_z_bar_max = STEWART_FABS(k_z_bar) + k_z_bar_err;
        const stewart_real h_x_bar = M_phi_L_bar*k33 - D_weight*theta_dot2;
        const stewart_real h_x_bar_err = D_weight_max*theta_dot2_err + M_phi_L_bar_err*k33_max
            + M_phi_L_bar_max*k33_err + STEWART_UNIT*(D_weight_max*theta_dot2_max + M_phi_L_bar_max*k33_max
            + STEWART_FABS(h_x_bar));
        const stewart_real h_x_bar_max = STEWART_FABS(h_x_bar) + h_x_bar_err;
        const stewart_real h_y_bar = k3*k3_h_bar - L*a3_bar;
        const stewart_real h_y_bar_err = L_err*a3_bar_max + L_max*a3_bar_err + k3_err*k3_h_bar_max
            + k3_h_bar_err*k3_max + STEWART_UNIT*(L_max*a3_bar_max + k3_h_bar_max*k3_max
            + STEWART_FABS(h_y_bar));
        const stewart_real h_y_bar_max = STEWART_FABS(h_y_bar) + h_y_bar_err;
        const stewart_real h_z_bar = D_weight*theta_ddot + L_ddot*tau_y_bar - M_phi_L_bar*k13;
        const stewart_real h_z_bar_err = D_weight_max*theta_ddot_err + L_ddot_err*tau_y_bar_max
            + L_ddot_max*tau_y_bar_err + M_phi_L_bar_err*k13_max + M_phi_L_bar_max*k13_err
            + STEWART_UNIT*(REAL(2)*D_weight_max*theta_ddot_max + REAL(2)*L_ddot_max*tau_y_bar_max
            + REAL(2)*M_phi_L_bar_max*k13_max + STEWART_FABS(h_z_bar));
        const stewart_real h_z_bar_max = STEWART_FABS(h_z_bar) + h_z_bar_err;
        const stewart_real h2_x_bar = L*L_h2_bar + bend*tau_y_bar;
        const stewart_real h2_x_bar_err = L_err*L_h2_bar_max + L_h2_bar_err*L_max + bend_err*tau_y_bar_max
            + bend_max*tau_y_bar_err + STEWART_UNIT*(L_h2_bar_max*L_max + bend_max*tau_y_bar_max
            + STEWART_FABS(h2_x_bar));
        const stewart_real h2_x_bar_max = STEWART_FABS(h2_x_bar) + h2_x_bar_err;
        const stewart_real h2_y_bar = -bend*k1*tau_k_bar;
        const stewart_real h2_y_bar_err = bend_err*k1_max*tau_k_bar_max + bend_max*k1_err*tau_k_bar_max
            + bend_max*k1_max*tau_k_bar_err + STEWART_UNIT*(bend_max*k1_max*tau_k_bar_max
            + STEWART_FABS(h2_y_bar));
        const stewart_real h2_y_bar_max = STEWART_FABS(h2_y_bar) + h2_y_bar_err;
        const stewart_real h2_z_bar = -L*a2_bar;
        const stewart_real h2_z_bar_err = L_err*a2_bar_max + L_max*a2_bar_err
            + STEWART_UNIT*STEWART_FABS(h2_z_bar);
        const stewart_real h2_z_bar_max = STEWART_FABS(h2_z_bar) + h2_z_bar_err;
        const stewart_real w_x_bar = k1*w_k_bar + k3*w_n_bar;
        const stewart_real w_x_bar_err = k1_err*w_k_bar_max + k1_max*w_k_bar_err + k3_err*w_n_bar_max
            + k3_max*w_n_bar_err + STEWART_UNIT*(k1_max*w_k_bar_max + k3_max*w_n_bar_max
            + STEWART_FABS(w_x_bar));
        const stewart_real w_x_bar_max = STEWART_FABS(w_x_bar) + w_x_bar_err;
        const stewart_real w_y_bar = -gamma_n*tau_k_bar;
        const stewart_real w_y_bar_err = gamma_n_err*tau_k_bar_max + gamma_n_max*tau_k_bar_err
            + STEWART_UNIT*STEWART_FABS(w_y_bar);
        const stewart_real w_y_bar_max = STEWART_FABS(w_y_bar) + w_y_bar_err;
        const stewart_real w_z_bar = k3*w_k_bar - k1*w_n_bar;
        const stewart_real w_z_bar_err = k1_err*w_n_bar_max + k1_max*w_n_bar_err + k3_err*w_k_bar_max
            + k3_max*w_k_bar_err + STEWART_UNIT*(k1_max*w_n_bar_max + k3_max*w_k_bar_max
            + STEWART_FABS(w_z_bar));
        const stewart_real w_z_bar_max = STEWART_FABS(w_z_bar) + w_z_bar_err;
        const stewart_real J_yz_bar = M_mixed_bar*k3 + M_mixed_theta_bar*k1;
        const stewart_real J_yz_bar_err = M_mixed_bar_err*k3_max + M_mixed_bar_max*k3_err
            + M_mixed_theta_bar_err*k1_max + M_mixed_theta_bar_max*k1_err + STEWART_UNIT*(M_mixed_bar_max*k3_max
            + M_mixed_theta_bar_max*k1_max + STEWART_FABS(J_yz_bar));
        const stewart_real J_yz_bar_max = STEWART_FABS(J_yz_bar) + J_yz_bar_err;
        const stewart_real g_k_bar = tau_y_bar*w_n;
        const stewart_real g_k_bar_err = tau_y_bar_err*w_n_max + tau_y_bar_max*w_n_err
            + STEWART_UNIT*STEWART_FABS(g_k_bar);
        const stewart_real g_k_bar_max = STEWART_FABS(g_k_bar) + g_k_bar_err;
        const stewart_real g_x_k_x_bar = gamma_n_bar*y_x;
        const stewart_real g_x_k_x_bar_err = gamma_n_bar_err*y_x_max + gamma_n_bar_max*y_x_err
            + STEWART_UNIT*STEWART_FABS(g_x_k_x_bar);
        const stewart_real g_x_k_x_bar_max = STEWART_FABS(g_x_k_x_bar) + g_x_k_x_bar_err;
        const stewart_real g_x_k_y_bar = gamma_n_bar*y_y;
        const stewart_real g_x_k_y_bar_err = gamma_n_bar_err*y_y_max + gamma_n_bar_max*y_y_err
            + STEWART_UNIT*STEWART_FABS(g_x_k_y_bar);
        const stewart_real g_x_k_y_bar_max = STEWART_FABS(g_x_k_y_bar) + g_x_k_y_bar_err;
        const stewart_real g_x_k_z_bar = gamma_n_bar*y_z;
        const stewart_real g_x_k_z_bar_err = gamma_n_bar_err*y_z_max + gamma_n_bar_max*y_z_err
            + STEWART_UNIT*STEWART_FABS(g_x_k_z_bar);
        const stewart_real g_x_k_z_bar_max = STEWART_FABS(g_x_k_z_bar) + g_x_k_z_bar_err;
        const stewart_real C_us_bar = phi_dot*tau_k_bar + tau_y_bar*theta_dot;
        const stewart_real C_us_bar_err = phi_dot_err*tau_k_bar_max + phi_dot_max*tau_k_bar_err
            + tau_y_bar_err*theta_dot_max + tau_y_bar_max*theta_dot_err
            + STEWART_UNIT*(phi_dot_max*tau_k_bar_max + tau_y_bar_max*theta_dot_max + STEWART_FABS(C_us_bar));
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
        const stewart_real B_xx_bar_err = S_ddot_x_bar_err*q_x_max + S_ddot_x_bar_max*q_x_err
            + STEWART_UNIT*STEWART_FABS(B_xx_bar);
        const stewart_real B_xy_bar = S_ddot_x_bar*q_y;
        const stewart_real B_xy_bar_err = S_ddot_x_bar_err*q_y_max + S_ddot_x_bar_max*q_y_err
            + STEWART_UNIT*STEWART_FABS(B_xy_bar);
        const stewart_real B_xz_bar = S_ddot_x_bar*q_z;
        const stewart_real B_xz_bar_err = S_ddot_x_bar_err*q_z_max + S_ddot_x_bar_max*q_z_err
            + STEWART_UNIT*STEWART_FABS(B_xz_bar);
        const stewart_real B_yx_bar = S_ddot_y_bar*q_x;
        const stewart_real B_yx_bar_err = S_ddot_y_bar_err*q_x_max + S_ddot_y_bar_max*q_x_err
            + STEWART_UNIT*STEWART_FABS(B_yx_bar);
        const stewart_real B_yy_bar = S_ddot_y_bar*q_y;
        const stewart_real B_yy_bar_err = S_ddot_y_bar_err*q_y_max + S_ddot_y_bar_max*q_y_err
            + STEWART_UNIT*STEWART_FABS(B_yy_bar);
        const stewart_real B_yz_bar = S_ddot_y_bar*q_z;
        const stewart_real B_yz_bar_err = S_ddot_y_bar_err*q_z_max + S_ddot_y_bar_max*q_z_err
            + STEWART_UNIT*STEWART_FABS(B_yz_bar);
        const stewart_real B_zx_bar = S_ddot_z_bar*q_x;
        const stewart_real B_zx_bar_err = S_ddot_z_bar_err*q_x_max + S_ddot_z_bar_max*q_x_err
            + STEWART_UNIT*STEWART_FABS(B_zx_bar);
        const stewart_real B_zy_bar = S_ddot_z_bar*q_y;
        const stewart_real B_zy_bar_err = S_ddot_z_bar_err*q_y_max + S_ddot_z_bar_max*q_y_err
            + STEWART_UNIT*STEWART_FABS(B_zy_bar);
        const stewart_real B_zz_bar = S_ddot_z_bar*q_z;
        const stewart_real B_zz_bar_err = S_ddot_z_bar_err*q_z_max + S_ddot_z_bar_max*q_z_err
            + STEWART_UNIT*STEWART_FABS(B_zz_bar);
        const stewart_real r_x_bar = H_moment_z_bar*s_y - H_moment_y_bar*s_z - S_x_bar;
        const stewart_real r_x_bar_err = H_moment_y_bar_err*s_z_max + H_moment_y_bar_max*s_z_err
            + H_moment_z_bar_err*s_y_max + H_moment_z_bar_max*s_y_err + S_x_bar_err
            + STEWART_UNIT*(REAL(2)*H_moment_y_bar_max*s_z_max + REAL(2)*H_moment_z_bar_max*s_y_max
            + S_x_bar_max + STEWART_FABS(r_x_bar));
        const stewart_real r_x_bar_max = STEWART_FABS(r_x_bar) + r_x_bar_err;
        const stewart_real r_y_bar = H_moment_x_bar*s_z - H_moment_z_bar*s_x - S_y_bar;
        const stewart_real r_y_bar_err = H_moment_x_bar_err*s_z_max + H_moment_x_bar_max*s_z_err
            + H_moment_z_bar_err*s_x_max + H_moment_z_bar_max*s_x_err + S_y_bar_err
            + STEWART_UNIT*(REAL(2)*H_moment_x_bar_max*s_z_max + REAL(2)*H_moment_z_bar_max*s_x_max
            + S_y_bar_max + STEWART_FABS(r_y_bar));
        const stewart_real r_y_bar_max = STEWART_FABS(r_y_bar) + r_y_bar_err;
        const stewart_real r_z_bar = H_moment_y_bar*s_x - H_moment_x_bar*s_y - S_z_bar;
        const stewart_real r_z_bar_err = H_moment_x_bar_err*s_y_max + H_moment_x_bar_max*s_y_err
            + H_moment_y_bar_err*s_x_max + H_moment_y_bar_max*s_x_err + S_z_bar_err
            + STEWART_UNIT*(REAL(2)*H_moment_x_bar_max*s_y_max + REAL(2)*H_moment_y_bar_max*s_x_max
            + S_z_bar_max + STEWART_FABS(r_z_bar));
        const stewart_real r_z_bar_max = STEWART_FABS(r_z_bar) + r_z_bar_err;
        error[i] = error[i] + k_x_bar_max*k_x_err + k_y_bar_max*k_y_err + k_z_bar_max*k_z_err
            + h_x_bar_max*h_x_err + h_y_bar_max*h_y_err + h_z_bar_max*h_z_err + h2_x_bar_max*h2_x_err
            + h2_y_bar_max*h2_y_err + h2_z_bar_max*h2_z_err + w_x_bar_max*w_x_err + w_y_bar_max*w_y_err
            + w_z_bar_max*w_z_err + M_phi_bar_max*J_xx_err + a3_bar_max*J_xy_err + M_theta_bar_max*J_yy_err
            + J_yz_bar_max*J_yz_err + a2_bar_max*J2_xz_err + a1_bar_max*dJ_zx_err + g_k_bar_max*g_k_err
            + g_x_k_x_bar_max*g_x_k_x_err + g_x_k_y_bar_max*g_x_k_y_err + g_x_k_z_bar_max*g_x_k_z_err
            + C_us_bar_max*C_us_err + r_x_bar_max*r_x_err + r_y_bar_max*r_y_err + r_z_bar_max*r_z_err
            + q_x_bar_max*q_x_own + q_y_bar_max*q_y_own + q_z_bar_max*q_z_own + S_1_x_bar_max*S_1_x_own
            + S_1_y_bar_max*S_1_y_own + S_1_z_bar_max*S_1_z_own + S_x_bar_max*S_x_own + S_y_bar_max*S_y_own
            + S_z_bar_max*S_z_own + zeta_bar_max*zeta_own + k_cross_S_x_bar_max*k_cross_S_x_own
            + k_cross_S_y_bar_max*k_cross_S_y_own + k_cross_S_z_bar_max*k_cross_S_z_own
            + rho2_bar_max*rho2_own + L_bar_max*L_own + rho_bar_max*rho_own + inv_L_bar_max*inv_L_own
            + s_x_bar_max*s_x_own + s_y_bar_max*s_y_own + s_z_bar_max*s_z_own + inv_rho_bar_max*inv_rho_own
            + y_x_bar_max*y_x_own + y_y_bar_max*y_y_own + y_z_bar_max*y_z_own + k1_bar_max*k1_own
            + k3_bar_max*k3_own + kappa_bar_max*kappa_own + S_dot_x_bar_max*S_dot_x_own
            + S_dot_y_bar_max*S_dot_y_own + S_dot_z_bar_max*S_dot_z_own + S_ddot_x_bar_max*S_ddot_x_own
            + S_ddot_y_bar_max*S_ddot_y_own + S_ddot_z_bar_max*S_ddot_z_own + L_dot_bar_max*L_dot_own
            + phi_dot_bar_max*phi_dot_own + theta_dot_bar_max*theta_dot_own + L_share_bar_max*L_share_own
            + rho_share_bar_max*lean_own + theta_dot2_bar_max*theta_dot2_own + phi_dot2_bar_max*phi_dot2_own
            + rho_share_bar_max*rho_share_own + k33_bar_max*k33_own + L_ddot_bar_max*L_ddot_own
            + theta_ddot_bar_max*theta_ddot_own + phi_ddot_bar_max*phi_ddot_own + k13_bar_max*k13_own
            + L_h2_bar_max*L_h2_own + a1_bar_max*a1_own + a2_bar_max*a2_own + a3_bar_max*a3_own
            + M_phi_bar_max*M_phi_own + M_theta_bar_max*M_theta_own + M_mixed_bar_max*M_mixed_own
            + k3_h_bar_max*k3_h_own + M_phi_theta_bar_max*M_phi_theta_own + M_phi_L_bar_max*M_phi_L_own
            + M_mixed_theta_bar_max*M_mixed_theta_own + bend_bar_max*bend_own + gamma_n_bar_max*gamma_n_own
            + gamma_y_bar_max*gamma_y_own + w_k_bar_max*w_k_own + w_n_bar_max*w_n_own
            + tau_y_bar_max*tau_y_own + tau_k_bar_max*tau_k_own + Q_k_bar_max*Q_k_own + Q_y_bar_max*Q_y_own
            + K_x_bar_max*K_x_own + K_y_bar_max*K_y_own + K_z_bar_max*K_z_own + D_weight_max*D_own
            + H_moment_x_bar_max*H_moment_x_own + H_moment_y_bar_max*H_moment_y_own
            + H_moment_z_bar_max*H_moment_z_own + Y_moment_x_max*c_moment_x_own
            + Y_moment_y_max*c_moment_y_own + Y_moment_z_max*c_moment_z_own;
        add(&slopes[i].R_legs[0], &slopes[i].R_legs_err[0], R_xx_bar, R_xx_bar_err);
        add(&slopes[i].R_legs[1], &slopes[i].R_legs_err[1], R_xy_bar, R_xy_bar_err);
        add(&slopes[i].R_legs[2], &slopes[i].R_legs_err[2], R_xz_bar, R_xz_bar_err);
        add(&slopes[i].R_legs[3], &slopes[i].R_legs_err[3], R_yx_bar, R_yx_bar_err);
        add(&slopes[i].R_legs[4], &slopes[i].R_legs_err[4], R_yy_bar, R_yy_bar_err);
        add(&slopes[i].R_legs[5], &slopes[i].R_legs_err[5], R_yz_bar, R_yz_bar_err);
        add(&slopes[i].R_legs[6], &slopes[i].R_legs_err[6], R_zx_bar, R_zx_bar_err);
        add(&slopes[i].R_legs[7], &slopes[i].R_legs_err[7], R_zy_bar, R_zy_bar_err);
        add(&slopes[i].R_legs[8], &slopes[i].R_legs_err[8], R_zz_bar, R_zz_bar_err);
        add(&slopes[i].B_legs[0], &slopes[i].B_legs_err[0], B_xx_bar, B_xx_bar_err);
        add(&slopes[i].B_legs[1], &slopes[i].B_legs_err[1], B_xy_bar, B_xy_bar_err);
        add(&slopes[i].B_legs[2], &slopes[i].B_legs_err[2], B_xz_bar, B_xz_bar_err);
        add(&slopes[i].B_legs[3], &slopes[i].B_legs_err[3], B_yx_bar, B_yx_bar_err);
        add(&slopes[i].B_legs[4], &slopes[i].B_legs_err[4], B_yy_bar, B_yy_bar_err);
        add(&slopes[i].B_legs[5], &slopes[i].B_legs_err[5], B_yz_bar, B_yz_bar_err);
        add(&slopes[i].B_legs[6], &slopes[i].B_legs_err[6], B_zx_bar, B_zx_bar_err);
        add(&slopes[i].B_legs[7], &slopes[i].B_legs_err[7], B_zy_bar, B_zy_bar_err);
        add(&slopes[i].B_legs[8], &slopes[i].B_legs_err[8], B_zz_bar, B_zz_bar_err);
        add(&slopes[i].t_1_legs[0], &slopes[i].t_1_legs_err[0], S_1_x_bar, S_1_x_bar_err);
        add(&slopes[i].t_1_legs[1], &slopes[i].t_1_legs_err[1], S_1_y_bar, S_1_y_bar_err);
        add(&slopes[i].t_1_legs[2], &slopes[i].t_1_legs_err[2], S_1_z_bar, S_1_z_bar_err);
    }
}

/* The legs and the platform of one pose: D and the platform's equations. */
static int equations_of_pose(
    const stewart_exact_bounds_model *model, const stewart_motions *at, const shared_terms *shared,
    stewart_real D[6], platform_equations *out)
{
    leg_terms leg;
    int i, j;
    for (j = 0; j < 3; ++j) {
        out->c[j] = shared->c_force[j];
        out->c[j + 3] = shared->c_moment[j];
        out->c_own[j] = 0;
        out->c_own[j + 3] = 0;
    }
    for (i = 0; i < 6; ++i) {
        leg_of_pose(&model->platform, &model->leg[i], at, shared, &leg);
        if (leg.status != STEWART_OK) {
            return leg.status;
        }
        D[i] = leg.D;
        for (j = 0; j < 3; ++j) {
            out->H[j][i] = leg.H_force[j];
            out->H[j + 3][i] = leg.H_moment[j];
            add(&out->c[j], &out->c_own[j], leg.c_force[j], 0);
            add(&out->c[j + 3], &out->c_own[j + 3], leg.c_moment[j], 0);
        }
    }
    return STEWART_OK;
}

/* Largest size of a moment entry of H. */
static stewart_real moment_size(stewart_real H[6][6])
{
    stewart_real worst = 0;
    int i, j;
    for (i = 3; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            worst = STEWART_FABS(H[i][j]) > worst ? STEWART_FABS(H[i][j]) : worst;
        }
    }
    return worst;
}

/* Bounds the errors of the forces D - x: those of D, c and H as they reach the forces, that of the solution,
 * and that of the difference. Completes the errors of the platform's equations. */
static void bound_of_pose(
    const stewart_exact_bounds_model *model, const stewart_motions *at, const stewart_real x[6],
    stewart_real Y[6][6], const stewart_real F[6], platform_equations *of, stewart_real bound[6])
{
    shared_terms shared;
    leg_terms leg;
    force_row rows[6];
    slopes_of_legs slopes[6];
    stewart_real *numbers = (stewart_real *)slopes;
    const stewart_real R_err = rotation_error(at->R);
    size_t number;
    int i, j;
    for (number = 0; number < 6 * (sizeof(slopes_of_legs) / sizeof(stewart_real)); ++number) {
        numbers[number] = 0;
    }
    for (i = 0; i < 6; ++i) {
        bound[i] = 0;
        for (j = 0; j < 3; ++j) {
            rows[i].Y_force[j] = Y[i][j];
            rows[i].Y_moment[j] = Y[i][j + 3];
        }
    }
    shared_errors(&model->platform, at, R_err, rows, NULL, bound, &shared);
    for (j = 0; j < 3; ++j) {
        of->c_err[j] = shared.c_force_err[j];
        of->c_err[j + 3] = shared.c_moment_err[j];
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            rows[j].D_weight = i == j ? 1 : 0;
            rows[j].x = x[i];
        }
        leg_errors(&model->platform, &model->leg[i], at, &shared, R_err, rows, slopes, bound, &leg);
        for (j = 0; j < 3; ++j) {
            of->H_err[j][i] = leg.H_force_err[j];
            of->H_err[j + 3][i] = leg.H_moment_err[j];
            of->c_err[j] = of->c_err[j] + leg.c_force_err[j];
            of->c_err[j + 3] = of->c_err[j + 3] + leg.c_moment_err[j];
        }
    }
    shared_errors(&model->platform, at, R_err, rows, slopes, bound, &shared);
    solution_error(of, x, Y, bound);
    for (i = 0; i < 6; ++i) {
        bound[i] = STEWART_SLACK * (bound[i] + STEWART_UNIT * STEWART_FABS(F[i]));
        if (!(bound[i] <= STEWART_MAX)) {
            bound[i] = STEWART_INFINITY;
        }
    }
}

/* Forces, bound and reciprocal condition of one pose; the last two may be null. */
static int forces_of_pose(
    const stewart_exact_bounds_model *model, const stewart_motions *at, stewart_real F[6],
    stewart_real *bound, stewart_real *rcond)
{
    shared_terms shared;
    platform_equations equations;
    stewart_real A[6][13], Y[6][6], x[6], D[6], found[6], unit[6];
    int i, j, status;
    for (i = 0; i < 6; ++i) {
        unit[i] = i < 3 ? 1 : model->per_length;
    }
    shared_of_pose(&model->platform, at, &shared);
    status = equations_of_pose(model, at, &shared, D, &equations);
    if (status != STEWART_OK) {
        return status;
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            A[i][j] = unit[i] * equations.H[i][j];
            A[i][j + 7] = i == j ? unit[i] : 0;
        }
        A[i][6] = unit[i] * equations.c[i];
    }
    status = solve(A, model->per_length * moment_size(equations.H), x, Y);
    if (status != STEWART_OK) {
        return status;
    }
    for (i = 0; i < 6; ++i) {
        found[i] = D[i] - x[i];
    }
    if (!is_finite(found, 6)) {
        return STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        F[i] = found[i];
    }
    if (bound) {
        bound_of_pose(model, at, x, Y, F, &equations, bound);
    }
    if (rcond) {
        *rcond = reciprocal_condition(equations.H, Y, shared.t_1, model->length);
    }
    return STEWART_OK;
}

int stewart_exact_forces_bounded(
    const stewart_exact_bounds_model *model, const stewart_motion *motion, stewart_real F[6],
    stewart_real bound[6], stewart_real *rcond)
{
    stewart_motions at;
    if (!model || !motion || !F) {
        return STEWART_BAD_ARGUMENT;
    }
    at.R = motion->R;
    at.t = motion->t;
    at.omega = motion->omega;
    at.v = motion->v;
    at.alpha = motion->alpha;
    at.a = motion->a;
    at.F_ext = motion->F_ext;
    at.M_ext = motion->M_ext;
    return forces_of_pose(model, &at, F, bound, rcond);
}

static const stewart_real no_load[3] = {0, 0, 0};

int stewart_exact_forces_bounded_batch(
    const stewart_exact_bounds_model *model, size_t count, const stewart_motions *motions, stewart_real *F,
    stewart_real *bound, stewart_real *rcond, int *status)
{
    size_t pose;
    int result = STEWART_OK;
    if (!model || !motions || !F || !motions->R || !motions->t || !motions->omega || !motions->v
        || !motions->alpha || !motions->a) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        stewart_motions at;
        int code;
        at.R = motions->R + 9 * pose;
        at.t = motions->t + 3 * pose;
        at.omega = motions->omega + 3 * pose;
        at.v = motions->v + 3 * pose;
        at.alpha = motions->alpha + 3 * pose;
        at.a = motions->a + 3 * pose;
        at.F_ext = motions->F_ext ? motions->F_ext + 3 * pose : no_load;
        at.M_ext = motions->M_ext ? motions->M_ext + 3 * pose : no_load;
        code = forces_of_pose(
            model, &at, F + 6 * pose, bound ? bound + 6 * pose : NULL, rcond ? rcond + pose : NULL);
        if (status) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}
