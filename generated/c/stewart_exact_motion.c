/* stewart_exact_motion.c: see stewart_exact_motion.h.
 *
 * Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_exact_motion.h"

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

static void copy(const stewart_real *from, int count, stewart_real *to)
{
    int i;
    for (i = 0; i < count; ++i) {
        to[i] = from[i];
    }
}

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

/* ---- equations ---- */

typedef struct {
    stewart_real t_1[3];
} equations_pose;

typedef struct {
    stewart_real sum[69][LANES];
    stewart_real H_force[3][8];
    stewart_real H_moment[3][8];
    stewart_real H_dot_force[3][8];
    stewart_real H_dot_moment[3][8];
    leg_judgement judged;
} equations_legs;

/* The platform's part: 155 (93 mul, 62 add, 0 div, 0 sqrt) operations. */
static void equations_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    equations_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT sum)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real M_P = model->M_P;
    const stewart_real h_P_x = model->h_P[0], h_P_y = model->h_P[1], h_P_z = model->h_P[2];
    const stewart_real J_P_xx = model->J_P[0], J_P_xy = model->J_P[1], J_P_xz = model->J_P[2],
        J_P_yy = model->J_P[3], J_P_yz = model->J_P[4], J_P_zz = model->J_P[5];
    const stewart_real C_P = model->C_P;
    const stewart_real b_1_x = model->b_1[0], b_1_y = model->b_1[1], b_1_z = model->b_1[2];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    /* (30) first moment of the platform, base frame */
    const stewart_real h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z;
    const stewart_real h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z;
    const stewart_real h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z;
    const stewart_real c1 = J_P_xx*R_xx + J_P_xy*R_xy + J_P_xz*R_xz;
    const stewart_real c2 = J_P_xy*R_xx + J_P_yy*R_xy + J_P_yz*R_xz;
    const stewart_real c3 = J_P_xz*R_xx + J_P_yz*R_xy + J_P_zz*R_xz;
    const stewart_real c4 = J_P_xx*R_yx + J_P_xy*R_yy + J_P_xz*R_yz;
    const stewart_real c5 = J_P_xy*R_yx + J_P_yy*R_yy + J_P_yz*R_yz;
    const stewart_real c6 = J_P_xz*R_yx + J_P_yz*R_yy + J_P_zz*R_yz;
    /* (32) inertia of the platform, base frame */
    const stewart_real J_base_xx = R_xx*c1 + R_xy*c2 + R_xz*c3;
    const stewart_real J_base_xy = R_yx*c1 + R_yy*c2 + R_yz*c3;
    const stewart_real J_base_xz = R_zx*c1 + R_zy*c2 + R_zz*c3;
    const stewart_real J_base_yy = R_yx*c4 + R_yy*c5 + R_yz*c6;
    const stewart_real J_base_yz = R_zx*c4 + R_zy*c5 + R_zz*c6;
    const stewart_real J_base_zz = R_zx*(J_P_xx*R_zx + J_P_xy*R_zy + J_P_xz*R_zz) + R_zy*(J_P_xy*R_zx
        + J_P_yy*R_zy + J_P_yz*R_zz) + R_zz*(J_P_xz*R_zx + J_P_yz*R_zy + J_P_zz*R_zz);
    /* (31) omega x h */
    const stewart_real w_h_x = h_base_z*omega_y - h_base_y*omega_z;
    const stewart_real w_h_y = h_base_x*omega_z - h_base_z*omega_x;
    const stewart_real w_h_z = h_base_y*omega_x - h_base_x*omega_y;
    const stewart_real half_trace = STEWART_HALF*J_base_xx + STEWART_HALF*J_base_yy
        + STEWART_HALF*J_base_zz;
    const stewart_real c7 = J_base_xy*omega_z;
    const stewart_real c8 = J_base_xz*omega_y;
    const stewart_real c9 = half_trace*omega_z;
    const stewart_real c10 = half_trace*omega_y;
    const stewart_real c11 = -J_base_yz*omega_x;
    const stewart_real c12 = half_trace*omega_x;
    out->t_1[0] = t_x - b_1_x;
    out->t_1[1] = t_y - b_1_y;
    out->t_1[2] = t_z - b_1_z;
    sum[0] = M_P;
    sum[1] = REAL(0);
    sum[2] = REAL(0);
    sum[3] = M_P;
    sum[4] = REAL(0);
    sum[5] = M_P;
    sum[6] = REAL(0);
    sum[7] = h_base_z;
    sum[8] = -h_base_y;
    sum[9] = -h_base_z;
    sum[10] = REAL(0);
    sum[11] = h_base_x;
    sum[12] = h_base_y;
    sum[13] = -h_base_x;
    sum[14] = REAL(0);
    sum[15] = J_base_xx;
    sum[16] = J_base_xy;
    sum[17] = J_base_xz;
    sum[18] = J_base_yy;
    sum[19] = J_base_yz;
    sum[20] = J_base_zz;
    sum[21] = REAL(0);
    sum[22] = REAL(0);
    sum[23] = REAL(0);
    sum[24] = REAL(0);
    sum[25] = REAL(0);
    sum[26] = REAL(0);
    sum[27] = REAL(0);
    sum[28] = REAL(0);
    sum[29] = REAL(0);
    sum[30] = REAL(0);
    sum[31] = w_h_z;
    sum[32] = -w_h_y;
    sum[33] = -w_h_z;
    sum[34] = REAL(0);
    sum[35] = w_h_x;
    sum[36] = w_h_y;
    sum[37] = -w_h_x;
    sum[38] = REAL(0);
    sum[39] = REAL(0);
    sum[40] = REAL(0);
    sum[41] = REAL(0);
    sum[42] = REAL(0);
    sum[43] = REAL(0);
    sum[44] = REAL(0);
    sum[45] = REAL(0);
    sum[46] = REAL(0);
    sum[47] = REAL(0);
    sum[48] = c8 - c7;
    sum[49] = J_base_yz*omega_y + c9 - J_base_yy*omega_z;
    sum[50] = J_base_zz*omega_y - J_base_yz*omega_z - c10;
    sum[51] = J_base_xx*omega_z - J_base_xz*omega_x - c9;
    sum[52] = c11 + c7;
    sum[53] = J_base_xz*omega_z + c12 - J_base_zz*omega_x;
    sum[54] = J_base_xy*omega_x + c10 - J_base_xx*omega_y;
    sum[55] = J_base_yy*omega_x - J_base_xy*omega_y - c12;
    sum[56] = -c11 - c8;
    sum[57] = -M_P*g_x;
    sum[58] = -M_P*g_y;
    sum[59] = -M_P*g_z;
    sum[60] = g_y*h_base_z - g_z*h_base_y;
    sum[61] = g_z*h_base_x - g_x*h_base_z;
    sum[62] = g_x*h_base_y - g_y*h_base_x;
    sum[63] = REAL(0);
    sum[64] = REAL(0);
    sum[65] = REAL(0);
    sum[66] = C_P*omega_x;
    sum[67] = C_P*omega_y;
    sum[68] = C_P*omega_z;
}

/* The legs side by side: 681 (422 mul, 255 add, 2 div, 2 sqrt) operations each. */
STEWART_APART static void equations_of_legs(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const equations_pose *STEWART_RESTRICT pose, equations_legs *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    const stewart_real t_1_x = pose->t_1[0], t_1_y = pose->t_1[1], t_1_z = pose->t_1[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_xz = model->J[2][l],
            J_yy = model->J[3][l], J_yz = model->J[4][l], J_zz = model->J[5][l];
        const stewart_real J2_xz = model->J2_xz[l];
        const stewart_real dJ_zx = model->dJ_zx[l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l],
            g_x_k_z = model->g_x_k[2][l];
        const stewart_real C_us = model->C_us[l];
        const stewart_real r_x = model->r[0][l], r_y = model->r[1][l], r_z = model->r[2][l];
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
        /* (2) leg length, and distance of its tip from the fixed axis */
        const stewart_real L = STEWART_SQRT(S_x*S_x + S_y*S_y + S_z*S_z);
        const stewart_real inv_L = REAL(1)/L;
        /* (3) unit vector along the leg */
        const stewart_real s_x = S_x*inv_L;
        const stewart_real s_y = S_y*inv_L;
        const stewart_real s_z = S_z*inv_L;
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = k_cross_S_z*s_y - k_cross_S_y*s_z;
        const stewart_real s_cross_normal_y = k_cross_S_x*s_z - k_cross_S_z*s_x;
        const stewart_real s_cross_normal_z = k_cross_S_y*s_x - k_cross_S_x*s_y;
        /* (10) leg length, and distance of its tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(s_cross_normal_x*s_cross_normal_x
            + s_cross_normal_y*s_cross_normal_y + s_cross_normal_z*s_cross_normal_z);
        const stewart_real inv_rho = REAL(1)/rho;
        /* (10) third axis of the leg frame */
        const stewart_real z_x = inv_rho*s_cross_normal_x;
        const stewart_real z_y = inv_rho*s_cross_normal_y;
        const stewart_real z_z = inv_rho*s_cross_normal_z;
        /* (10) rotating axis of the universal joint */
        const stewart_real y_x = s_z*z_y - s_y*z_z;
        const stewart_real y_y = s_x*z_z - s_z*z_x;
        const stewart_real y_z = s_y*z_x - s_x*z_y;
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1 = inv_L*zeta;
        const stewart_real k3 = inv_L*rho;
        /* (10) k1 / k3 */
        const stewart_real kappa = inv_rho*zeta;
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = omega_y*q_z + v_x - omega_z*q_y;
        const stewart_real S_dot_y = omega_z*q_x + v_y - omega_x*q_z;
        const stewart_real S_dot_z = omega_x*q_y + v_z - omega_y*q_x;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z;
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z);
        const stewart_real theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z);
        const stewart_real c1 = k3*k3;
        const stewart_real k33 = c1;
        const stewart_real k13 = k1*k3;
        const stewart_real L_h2 = L*h2_x;
        const stewart_real a1 = L_h2 + dJ_zx;
        const stewart_real a2 = J2_xz - L*h2_z;
        const stewart_real c2 = J_xy - L*h_y;
        const stewart_real a3 = c2;
        /* (19) inertia of the joint coordinates */
        const stewart_real M_phi = J_xx + a1*k33 + a2*k13;
        const stewart_real M_theta = J_yy + L_h2;
        const stewart_real M_mixed = J_yz*k3 + a3*k1;
        const stewart_real k3_h = h_y*k3;
        const stewart_real c3 = inv_L*inv_rho;
        const stewart_real c4 = inv_L*inv_L;
        /* inertia at the tip, leg frame */
        const stewart_real m_leg_sy = -inv_rho*k3_h;
        const stewart_real m_leg_sz = -h_z*inv_L;
        const stewart_real m_leg_yy = M_phi*inv_rho*inv_rho;
        const stewart_real m_leg_yz = -M_mixed*c3;
        const stewart_real m_leg_zz = M_theta*c4;
        const stewart_real m_T_xs = m_leg_sy*y_x + m_leg_sz*z_x;
        const stewart_real m_T_xy = m_leg_sy*s_x + m_leg_yy*y_x + m_leg_yz*z_x;
        const stewart_real m_T_xz = m_leg_sz*s_x + m_leg_yz*y_x + m_leg_zz*z_x;
        const stewart_real m_T_ys = m_leg_sy*y_y + m_leg_sz*z_y;
        const stewart_real m_T_yy = m_leg_sy*s_y + m_leg_yy*y_y + m_leg_yz*z_y;
        const stewart_real m_T_yz = m_leg_sz*s_y + m_leg_yz*y_y + m_leg_zz*z_y;
        const stewart_real m_T_zs = m_leg_sy*y_z + m_leg_sz*z_z;
        const stewart_real m_T_zy = m_leg_sy*s_z + m_leg_yy*y_z + m_leg_yz*z_z;
        const stewart_real m_T_zz = m_leg_sz*s_z + m_leg_yz*y_z + m_leg_zz*z_z;
        /* inertia at the tip, base frame */
        const stewart_real m_xx = m_T_xs*s_x + m_T_xy*y_x + m_T_xz*z_x;
        const stewart_real m_xy = m_T_xs*s_y + m_T_xy*y_y + m_T_xz*z_y;
        const stewart_real m_xz = m_T_xs*s_z + m_T_xy*y_z + m_T_xz*z_z;
        const stewart_real m_yy = m_T_ys*s_y + m_T_yy*y_y + m_T_yz*z_y;
        const stewart_real m_yz = m_T_ys*s_z + m_T_yy*y_z + m_T_yz*z_z;
        const stewart_real m_zz = m_T_zs*s_z + m_T_zy*y_z + m_T_zz*z_z;
        const stewart_real c5 = h_x*theta_dot;
        const stewart_real C_xi_12 = -c5;
        const stewart_real c6 = c1*h_x - h_z*k1*k3;
        const stewart_real C_xi_13 = -c6*phi_dot;
        const stewart_real C_xi_21 = c5;
        const stewart_real C_xi_22 = L_dot*h_x;
        const stewart_real c7 = REAL(2)*L;
        const stewart_real c8 = REAL(2)*J_xz - c7*h_z;
        const stewart_real c9 = STEWART_HALF*k1*(c8*k1 + REAL(2)*k3*(J_zz + c7*h_x - J_xx))
            - STEWART_HALF*c1*c8;
        const stewart_real C_xi_23 = -c9*phi_dot;
        const stewart_real c10 = h_y*k1;
        const stewart_real C_xi_31 = c6*phi_dot - c10*theta_dot;
        const stewart_real C_xi_32 = c9*phi_dot + theta_dot*(J_yz*k1 - c2*k3) - L_dot*c10;
        const stewart_real C_xi_33 = L_dot*c6 + c9*theta_dot;
        const stewart_real c11 = k3*phi_dot;
        const stewart_real G_dot_12 = c11;
        const stewart_real G_dot_21 = -inv_L*theta_dot;
        const stewart_real c12 = k1*phi_dot;
        const stewart_real G_dot_22 = c12*inv_L;
        const stewart_real G_dot_23 = L_dot*c4;
        const stewart_real G_dot_31 = -c11*inv_rho;
        const stewart_real G_dot_32 = -L_dot*c3 - inv_rho*kappa*theta_dot;
        const stewart_real G_dot_33 = c12*inv_rho;
        const stewart_real C_leg_11 = G_dot_21*h_z - G_dot_31*k3_h;
        const stewart_real C_leg_12 = C_xi_13*inv_rho + G_dot_22*h_z - G_dot_32*k3_h;
        const stewart_real C_leg_13 = G_dot_23*h_z - C_xi_12*inv_L - G_dot_33*k3_h;
        const stewart_real C_leg_21 = inv_rho*(C_xi_31 + G_dot_21*M_mixed + G_dot_31*M_phi);
        const stewart_real C_leg_22 = inv_rho*(C_xi_33*inv_rho + G_dot_22*M_mixed + G_dot_32*M_phi
            - G_dot_12*k3_h);
        const stewart_real C_leg_23 = inv_rho*(G_dot_23*M_mixed + G_dot_33*M_phi + k3_h*theta_dot
            - C_xi_32*inv_L);
        const stewart_real C_leg_31 = -inv_L*(C_xi_21 + G_dot_21*M_theta + G_dot_31*M_mixed);
        const stewart_real C_leg_32 = -inv_L*(C_xi_23*inv_rho + G_dot_12*h_z + G_dot_22*M_theta
            + G_dot_32*M_mixed);
        const stewart_real C_leg_33 = -inv_L*(G_dot_23*M_theta + G_dot_33*M_mixed - C_xi_22*inv_L
            - h_z*theta_dot);
        const stewart_real C_tip_T_xs = C_leg_11*s_x + C_leg_21*y_x + C_leg_31*z_x;
        const stewart_real C_tip_T_xy = C_leg_12*s_x + C_leg_22*y_x + C_leg_32*z_x;
        const stewart_real C_tip_T_xz = C_leg_13*s_x + C_leg_23*y_x + C_leg_33*z_x;
        const stewart_real C_tip_T_ys = C_leg_11*s_y + C_leg_21*y_y + C_leg_31*z_y;
        const stewart_real C_tip_T_yy = C_leg_12*s_y + C_leg_22*y_y + C_leg_32*z_y;
        const stewart_real C_tip_T_yz = C_leg_13*s_y + C_leg_23*y_y + C_leg_33*z_y;
        const stewart_real C_tip_T_zs = C_leg_11*s_z + C_leg_21*y_z + C_leg_31*z_z;
        const stewart_real C_tip_T_zy = C_leg_12*s_z + C_leg_22*y_z + C_leg_32*z_z;
        const stewart_real C_tip_T_zz = C_leg_13*s_z + C_leg_23*y_z + C_leg_33*z_z;
        /* Coriolis matrix at the tip, base frame */
        const stewart_real C_tip_xx = C_tip_T_xs*s_x + C_tip_T_xy*y_x + C_tip_T_xz*z_x;
        const stewart_real C_tip_xy = C_tip_T_xs*s_y + C_tip_T_xy*y_y + C_tip_T_xz*z_y;
        const stewart_real C_tip_xz = C_tip_T_xs*s_z + C_tip_T_xy*y_z + C_tip_T_xz*z_z;
        const stewart_real C_tip_yx = C_tip_T_ys*s_x + C_tip_T_yy*y_x + C_tip_T_yz*z_x;
        const stewart_real C_tip_yy = C_tip_T_ys*s_y + C_tip_T_yy*y_y + C_tip_T_yz*z_y;
        const stewart_real C_tip_yz = C_tip_T_ys*s_z + C_tip_T_yy*y_z + C_tip_T_yz*z_z;
        const stewart_real C_tip_zx = C_tip_T_zs*s_x + C_tip_T_zy*y_x + C_tip_T_zz*z_x;
        const stewart_real C_tip_zy = C_tip_T_zs*s_y + C_tip_T_zy*y_y + C_tip_T_zz*z_y;
        const stewart_real C_tip_zz = C_tip_T_zs*s_z + C_tip_T_zy*y_z + C_tip_T_zz*z_z;
        /* (4) omega x q */
        const stewart_real w_q_x = S_dot_x - v_x;
        const stewart_real w_q_y = S_dot_y - v_y;
        const stewart_real w_q_z = S_dot_z - v_z;
        const stewart_real c13 = C_tip_xy*q_z;
        const stewart_real c14 = m_xy*w_q_z;
        const stewart_real c15 = C_tip_xz*q_y;
        const stewart_real c16 = m_xz*w_q_y;
        const stewart_real C_q_xx = c15 + c16 - c13 - c14;
        const stewart_real c17 = C_tip_xx*q_z;
        const stewart_real C_q_xy = c17 + m_xx*w_q_z - C_tip_xz*q_x - m_xz*w_q_x;
        const stewart_real c18 = C_tip_xx*q_y;
        const stewart_real C_q_xz = C_tip_xy*q_x + m_xy*w_q_x - c18 - m_xx*w_q_y;
        const stewart_real c19 = C_tip_yy*q_z;
        const stewart_real C_q_yx = C_tip_yz*q_y + m_yz*w_q_y - c19 - m_yy*w_q_z;
        const stewart_real c20 = C_tip_yx*q_z;
        const stewart_real c21 = -C_tip_yz*q_x;
        const stewart_real c22 = -m_yz*w_q_x;
        const stewart_real C_q_yy = c14 + c20 + c21 + c22;
        const stewart_real c23 = -C_tip_yy*q_x;
        const stewart_real C_q_yz = m_yy*w_q_x - C_tip_yx*q_y - c23 - m_xy*w_q_y;
        const stewart_real c24 = -C_tip_zz*q_y;
        const stewart_real C_q_zx = m_zz*w_q_y - C_tip_zy*q_z - c24 - m_yz*w_q_z;
        const stewart_real c25 = -C_tip_zz*q_x;
        const stewart_real C_q_zy = C_tip_zx*q_z + c25 + m_xz*w_q_z - m_zz*w_q_x;
        const stewart_real c26 = C_tip_zx*q_y;
        const stewart_real c27 = -C_tip_zy*q_x;
        const stewart_real C_q_zz = -c16 - c22 - c26 - c27;
        /* gravity along k x y and along y */
        const stewart_real gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z;
        const stewart_real gamma_y = g_x*y_x + g_y*y_y + g_z*y_z;
        /* first moment along k and against k x y */
        const stewart_real w_k = k1*w_x + k3*w_z;
        const stewart_real w_n = k3*w_x - k1*w_z;
        const stewart_real c28 = inv_L*(g_k*w_n + gamma_n*w_k);
        const stewart_real c29 = -gamma_n*w_y - gamma_y*w_n;
        /* against gravity */
        const stewart_real held_x = c29*inv_rho*y_x - c28*z_x;
        const stewart_real held_y = c29*inv_rho*y_y - c28*z_y;
        const stewart_real held_z = c29*inv_rho*y_z - c28*z_z;
        const stewart_real c30 = L_dot*s_x;
        const stewart_real c31 = inv_rho*(C_us*phi_dot - C_s*(k_x*omega_x + k_y*omega_y + k_z*omega_z));
        const stewart_real c32 = inv_L*(C_us*theta_dot - C_s*(omega_x*y_x + omega_y*y_y + omega_z*y_z));
        const stewart_real c33 = L_dot*s_y;
        const stewart_real c34 = L_dot*s_z;
        /* against friction */
        const stewart_real rubbed_x = C_p*c30 + c31*y_x - c32*z_x;
        const stewart_real rubbed_y = C_p*c33 + c31*y_y - c32*z_y;
        const stewart_real rubbed_z = C_p*c34 + c31*y_z - c32*z_z;
        /* (3) rate of s */
        const stewart_real s_dot_x = inv_L*(S_dot_x - c30);
        const stewart_real s_dot_y = inv_L*(S_dot_y - c33);
        const stewart_real s_dot_z = inv_L*(S_dot_z - c34);
        const stewart_real c35 = m_xy*q_z;
        const stewart_real c36 = m_xz*q_y;
        const stewart_real c37 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c35 - c36;
        const stewart_real m_q_xy = m_xz*q_x - m_xx*q_z;
        const stewart_real m_q_xz = m_xx*q_y - m_xy*q_x;
        const stewart_real m_q_yx = m_yy*q_z - m_yz*q_y;
        const stewart_real m_q_yy = -c35 - c37;
        const stewart_real m_q_yz = m_xy*q_y - m_yy*q_x;
        const stewart_real m_q_zx = m_yz*q_z - m_zz*q_y;
        const stewart_real m_q_zy = m_zz*q_x - m_xz*q_z;
        const stewart_real m_q_zz = c36 + c37;
        out->sum[0][l] = m_xx;
        out->sum[1][l] = m_xy;
        out->sum[2][l] = m_xz;
        out->sum[3][l] = m_yy;
        out->sum[4][l] = m_yz;
        out->sum[5][l] = m_zz;
        out->sum[6][l] = -m_q_xx;
        out->sum[7][l] = -m_q_xy;
        out->sum[8][l] = -m_q_xz;
        out->sum[9][l] = -m_q_yx;
        out->sum[10][l] = -m_q_yy;
        out->sum[11][l] = -m_q_yz;
        out->sum[12][l] = -m_q_zx;
        out->sum[13][l] = -m_q_zy;
        out->sum[14][l] = -m_q_zz;
        out->sum[15][l] = m_q_yx*q_z - m_q_zx*q_y;
        out->sum[16][l] = m_q_yy*q_z - m_q_zy*q_y;
        out->sum[17][l] = m_q_yz*q_z - m_q_zz*q_y;
        out->sum[18][l] = m_q_zy*q_x - m_q_xy*q_z;
        out->sum[19][l] = m_q_zz*q_x - m_q_xz*q_z;
        out->sum[20][l] = m_q_xz*q_y - m_q_yz*q_x;
        out->sum[21][l] = C_tip_xx;
        out->sum[22][l] = C_tip_xy;
        out->sum[23][l] = C_tip_xz;
        out->sum[24][l] = C_tip_yx;
        out->sum[25][l] = C_tip_yy;
        out->sum[26][l] = C_tip_yz;
        out->sum[27][l] = C_tip_zx;
        out->sum[28][l] = C_tip_zy;
        out->sum[29][l] = C_tip_zz;
        out->sum[30][l] = C_q_xx;
        out->sum[31][l] = C_q_xy;
        out->sum[32][l] = C_q_xz;
        out->sum[33][l] = C_q_yx;
        out->sum[34][l] = C_q_yy;
        out->sum[35][l] = C_q_yz;
        out->sum[36][l] = C_q_zx;
        out->sum[37][l] = C_q_zy;
        out->sum[38][l] = C_q_zz;
        out->sum[39][l] = c26 - c20;
        out->sum[40][l] = C_tip_zy*q_y - c19;
        out->sum[41][l] = -C_tip_yz*q_z - c24;
        out->sum[42][l] = c17 - C_tip_zx*q_x;
        out->sum[43][l] = c13 + c27;
        out->sum[44][l] = C_tip_xz*q_z + c25;
        out->sum[45][l] = C_tip_yx*q_x - c18;
        out->sum[46][l] = -C_tip_xy*q_y - c23;
        out->sum[47][l] = -c15 - c21;
        out->sum[48][l] = C_q_zx*q_y - C_q_yx*q_z;
        out->sum[49][l] = C_q_zy*q_y - C_q_yy*q_z;
        out->sum[50][l] = C_q_zz*q_y - C_q_yz*q_z;
        out->sum[51][l] = C_q_xx*q_z - C_q_zx*q_x;
        out->sum[52][l] = C_q_xy*q_z - C_q_zy*q_x;
        out->sum[53][l] = C_q_xz*q_z - C_q_zz*q_x;
        out->sum[54][l] = C_q_yx*q_x - C_q_xx*q_y;
        out->sum[55][l] = C_q_yy*q_x - C_q_xy*q_y;
        out->sum[56][l] = C_q_yz*q_x - C_q_xz*q_y;
        out->sum[57][l] = held_x;
        out->sum[58][l] = held_y;
        out->sum[59][l] = held_z;
        out->sum[60][l] = held_z*q_y - held_y*q_z;
        out->sum[61][l] = held_x*q_z - held_z*q_x;
        out->sum[62][l] = held_y*q_x - held_x*q_y;
        out->sum[63][l] = rubbed_x;
        out->sum[64][l] = rubbed_y;
        out->sum[65][l] = rubbed_z;
        out->sum[66][l] = q_y*rubbed_z - C_s*(k_x*phi_dot + theta_dot*y_x) - q_z*rubbed_y;
        out->sum[67][l] = q_z*rubbed_x - C_s*(k_y*phi_dot + theta_dot*y_y) - q_x*rubbed_z;
        out->sum[68][l] = q_x*rubbed_y - C_s*(k_z*phi_dot + theta_dot*y_z) - q_y*rubbed_x;
        out->H_force[0][l] = s_x;
        out->H_force[1][l] = s_y;
        out->H_force[2][l] = s_z;
        out->H_moment[0][l] = q_y*s_z - q_z*s_y;
        out->H_moment[1][l] = q_z*s_x - q_x*s_z;
        out->H_moment[2][l] = q_x*s_y - q_y*s_x;
        out->H_dot_force[0][l] = s_dot_x;
        out->H_dot_force[1][l] = s_dot_y;
        out->H_dot_force[2][l] = s_dot_z;
        out->H_dot_moment[0][l] = q_y*s_dot_z + s_z*w_q_y - q_z*s_dot_y - s_y*w_q_z;
        out->H_dot_moment[1][l] = q_z*s_dot_x + s_x*w_q_z - q_x*s_dot_z - s_z*w_q_x;
        out->H_dot_moment[2][l] = q_x*s_dot_y + s_y*w_q_x - q_y*s_dot_x - s_x*w_q_y;
        stewart_real fault;
        stewart_real reach = STEWART_SHORTEST / STEWART_ROUNDING;
        reach = STEWART_LARGER(STEWART_FABS(S_1_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(S_1_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(S_1_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_z), reach);
        out->judged.reach[l] = reach;
        out->judged.L[l] = L;
        out->judged.k3[l] = k3;
        fault = L <= STEWART_MAX ? REAL(0) : REAL(1);
        fault = L > STEWART_ROUNDING * reach ? fault : REAL(1);
        fault = k3 > STEWART_POLE_SINE ? fault : REAL(1);
        out->judged.bad[l] = fault;
    }
}

/* Platform and legs together; returns a status. */
static int equations_sums(
    const stewart_exact_model *model, const stewart_motion *motion, equations_legs *legs,
    stewart_real *sum)
{
    equations_pose pose;
    int status;
    equations_of_pose(model, motion, &pose, sum);
    equations_of_legs(model, motion, &pose, legs);
    status = legs_status(&legs->judged);
    if (status == STEWART_OK) {
        add_legs(legs->sum, 69, sum);
    }
    return status;
}

/* ---- bias ---- */

typedef struct {
    stewart_real t_1[3];
    stewart_real B_0[9];
} bias_pose;

typedef struct {
    stewart_real sum[6][LANES];
    leg_judgement judged;
} bias_legs;

/* The platform's part: 168 (99 mul, 69 add, 0 div, 0 sqrt) operations. */
static void bias_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    bias_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT sum)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real M_P = model->M_P;
    const stewart_real h_P_x = model->h_P[0], h_P_y = model->h_P[1], h_P_z = model->h_P[2];
    const stewart_real J_P_xx = model->J_P[0], J_P_xy = model->J_P[1], J_P_xz = model->J_P[2],
        J_P_yy = model->J_P[3], J_P_yz = model->J_P[4], J_P_zz = model->J_P[5];
    const stewart_real C_P = model->C_P;
    const stewart_real b_1_x = model->b_1[0], b_1_y = model->b_1[1], b_1_z = model->b_1[2];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    /* (30) first moment of the platform, base frame */
    const stewart_real h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z;
    const stewart_real h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z;
    const stewart_real h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z;
    const stewart_real c1 = J_P_xx*R_xx + J_P_xy*R_xy + J_P_xz*R_xz;
    const stewart_real c2 = J_P_xy*R_xx + J_P_yy*R_xy + J_P_yz*R_xz;
    const stewart_real c3 = J_P_xz*R_xx + J_P_yz*R_xy + J_P_zz*R_xz;
    const stewart_real c4 = J_P_xx*R_yx + J_P_xy*R_yy + J_P_xz*R_yz;
    const stewart_real c5 = J_P_xy*R_yx + J_P_yy*R_yy + J_P_yz*R_yz;
    const stewart_real c6 = J_P_xz*R_yx + J_P_yz*R_yy + J_P_zz*R_yz;
    /* (32) inertia of the platform, base frame */
    const stewart_real J_base_xx = R_xx*c1 + R_xy*c2 + R_xz*c3;
    const stewart_real J_base_xy = R_yx*c1 + R_yy*c2 + R_yz*c3;
    const stewart_real J_base_xz = R_zx*c1 + R_zy*c2 + R_zz*c3;
    const stewart_real J_base_yy = R_yx*c4 + R_yy*c5 + R_yz*c6;
    const stewart_real J_base_yz = R_zx*c4 + R_zy*c5 + R_zz*c6;
    const stewart_real J_base_zz = R_zx*(J_P_xx*R_zx + J_P_xy*R_zy + J_P_xz*R_zz) + R_zy*(J_P_xy*R_zx
        + J_P_yy*R_zy + J_P_yz*R_zz) + R_zz*(J_P_xz*R_zx + J_P_yz*R_zy + J_P_zz*R_zz);
    /* (31) omega x h */
    const stewart_real w_h_x = h_base_z*omega_y - h_base_y*omega_z;
    const stewart_real w_h_y = h_base_x*omega_z - h_base_z*omega_x;
    const stewart_real w_h_z = h_base_y*omega_x - h_base_x*omega_y;
    /* (34) I omega */
    const stewart_real J_w_x = J_base_xx*omega_x + J_base_xy*omega_y + J_base_xz*omega_z;
    const stewart_real J_w_y = J_base_xy*omega_x + J_base_yy*omega_y + J_base_yz*omega_z;
    const stewart_real J_w_z = J_base_xz*omega_x + J_base_yz*omega_y + J_base_zz*omega_z;
    /* products of omega */
    const stewart_real omega_xx = omega_x*omega_x;
    const stewart_real omega_xy = omega_x*omega_y;
    const stewart_real omega_xz = omega_x*omega_z;
    const stewart_real omega_yy = omega_y*omega_y;
    const stewart_real omega_yz = omega_y*omega_z;
    const stewart_real omega_zz = omega_z*omega_z;
    /* (7) S_ddot = B q + a */
    const stewart_real B_xx = -omega_yy - omega_zz;
    const stewart_real B_yy = -omega_xx - omega_zz;
    const stewart_real B_zz = -omega_xx - omega_yy;
    out->t_1[0] = t_x - b_1_x;
    out->t_1[1] = t_y - b_1_y;
    out->t_1[2] = t_z - b_1_z;
    out->B_0[0] = B_xx;
    out->B_0[1] = omega_xy;
    out->B_0[2] = omega_xz;
    out->B_0[3] = omega_xy;
    out->B_0[4] = B_yy;
    out->B_0[5] = omega_yz;
    out->B_0[6] = omega_xz;
    out->B_0[7] = omega_yz;
    out->B_0[8] = B_zz;
    sum[0] = omega_y*w_h_z - M_P*g_x - omega_z*w_h_y;
    sum[1] = omega_z*w_h_x - M_P*g_y - omega_x*w_h_z;
    sum[2] = omega_x*w_h_y - M_P*g_z - omega_y*w_h_x;
    sum[3] = C_P*omega_x + J_w_z*omega_y + g_y*h_base_z - J_w_y*omega_z - g_z*h_base_y;
    sum[4] = C_P*omega_y + J_w_x*omega_z + g_z*h_base_x - J_w_z*omega_x - g_x*h_base_z;
    sum[5] = C_P*omega_z + J_w_y*omega_x + g_x*h_base_y - J_w_x*omega_y - g_y*h_base_x;
}

/* The legs side by side: 305 (183 mul, 118 add, 2 div, 2 sqrt) operations each. */
STEWART_APART static void bias_of_legs(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const bias_pose *STEWART_RESTRICT pose, bias_legs *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real B_0_xx = pose->B_0[0], B_0_xy = pose->B_0[1], B_0_xz = pose->B_0[2],
        B_0_yx = pose->B_0[3], B_0_yy = pose->B_0[4], B_0_yz = pose->B_0[5], B_0_zx = pose->B_0[6],
        B_0_zy = pose->B_0[7], B_0_zz = pose->B_0[8];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    const stewart_real t_1_x = pose->t_1[0], t_1_y = pose->t_1[1], t_1_z = pose->t_1[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real h2_y = model->h2_y[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_yy = model->J[3][l],
            J_yz = model->J[4][l];
        const stewart_real J2_xz = model->J2_xz[l];
        const stewart_real dJ_zx = model->dJ_zx[l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l],
            g_x_k_z = model->g_x_k[2][l];
        const stewart_real C_us = model->C_us[l];
        const stewart_real r_x = model->r[0][l], r_y = model->r[1][l], r_z = model->r[2][l];
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
        /* (2) leg length, and distance of its tip from the fixed axis */
        const stewart_real L = STEWART_SQRT(S_x*S_x + S_y*S_y + S_z*S_z);
        const stewart_real inv_L = REAL(1)/L;
        /* (3) unit vector along the leg */
        const stewart_real s_x = S_x*inv_L;
        const stewart_real s_y = S_y*inv_L;
        const stewart_real s_z = S_z*inv_L;
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = k_cross_S_z*s_y - k_cross_S_y*s_z;
        const stewart_real s_cross_normal_y = k_cross_S_x*s_z - k_cross_S_z*s_x;
        const stewart_real s_cross_normal_z = k_cross_S_y*s_x - k_cross_S_x*s_y;
        /* (10) leg length, and distance of its tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(s_cross_normal_x*s_cross_normal_x
            + s_cross_normal_y*s_cross_normal_y + s_cross_normal_z*s_cross_normal_z);
        const stewart_real inv_rho = REAL(1)/rho;
        /* (10) third axis of the leg frame */
        const stewart_real z_x = inv_rho*s_cross_normal_x;
        const stewart_real z_y = inv_rho*s_cross_normal_y;
        const stewart_real z_z = inv_rho*s_cross_normal_z;
        /* (10) rotating axis of the universal joint */
        const stewart_real y_x = s_z*z_y - s_y*z_z;
        const stewart_real y_y = s_x*z_z - s_z*z_x;
        const stewart_real y_z = s_y*z_x - s_x*z_y;
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1 = inv_L*zeta;
        const stewart_real k3 = inv_L*rho;
        /* (10) k1 / k3 */
        const stewart_real kappa = inv_rho*zeta;
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = omega_y*q_z + v_x - omega_z*q_y;
        const stewart_real S_dot_y = omega_z*q_x + v_y - omega_x*q_z;
        const stewart_real S_dot_z = omega_x*q_y + v_z - omega_y*q_x;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z;
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z);
        const stewart_real theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z);
        /* L_dot / L */
        const stewart_real L_share = L_dot*inv_L;
        const stewart_real lean = kappa*theta_dot;
        const stewart_real theta_dot2 = theta_dot*theta_dot;
        const stewart_real phi_dot2 = phi_dot*phi_dot;
        const stewart_real two_phi_dot = REAL(2)*phi_dot;
        /* (7) acceleration of the platform point, a = alpha = 0 */
        const stewart_real S_ddot_x = B_0_xx*q_x + B_0_xy*q_y + B_0_xz*q_z;
        const stewart_real S_ddot_y = B_0_yx*q_x + B_0_yy*q_y + B_0_yz*q_z;
        const stewart_real S_ddot_z = B_0_zx*q_x + B_0_zy*q_y + B_0_zz*q_z;
        const stewart_real k33 = k3*k3;
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot = L*(k33*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y
            + S_ddot_z*s_z;
        /* (9) accelerations of the joint coordinates but for the turning of the leg frame about s */
        const stewart_real own_theta_ddot = -REAL(2)*L_share*theta_dot - inv_L*(S_ddot_x*z_x + S_ddot_y*z_y
            + S_ddot_z*z_z);
        const stewart_real own_phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z)
            - L_share*two_phi_dot;
        const stewart_real c1 = k1*k3;
        /* (9) accelerations of the joint coordinates */
        const stewart_real theta_ddot = c1*phi_dot2 + own_theta_ddot;
        const stewart_real phi_ddot = own_phi_ddot - lean*two_phi_dot;
        const stewart_real k13 = c1;
        const stewart_real L_h2 = L*h2_x;
        const stewart_real a1 = L_h2 + dJ_zx;
        const stewart_real c2 = L*h2_z;
        const stewart_real c3 = J2_xz - c2;
        const stewart_real a2 = c3;
        const stewart_real a3 = J_xy - L*h_y;
        /* (19) inertia of the joint coordinates */
        const stewart_real M_phi = J_xx + a1*k33 + a2*k13;
        const stewart_real M_theta = J_yy + L_h2;
        const stewart_real M_mixed = J_yz*k3 + a3*k1;
        const stewart_real k3_h = h_y*k3;
        /* (19) slopes of M_phi / 2 along theta and L, of M_mixed along theta */
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
        const stewart_real tau_y = C_us*theta_dot + L_ddot*h_z + M_mixed*phi_ddot + M_theta*own_theta_ddot
            + bend*h2_x + g_k*w_n + gamma_n*w_k + phi_dot2*(k13*(J_yy - dJ_zx) - c3*(STEWART_HALF - k33))
            - C_s*(omega_x*y_x + omega_y*y_y + omega_z*y_z);
        const stewart_real tau_k = C_us*phi_dot + M_mixed*theta_ddot + M_mixed_theta*theta_dot2
            + M_phi*own_phi_ddot + two_phi_dot*(L_dot*M_phi_L - theta_dot*(STEWART_HALF*J2_xz + J_xx*kappa
            - STEWART_HALF*c2)) - C_s*(k_x*omega_x + k_y*omega_y + k_z*omega_z) - L_ddot*k3_h - bend*h2_y*k1
            - gamma_n*w_y - gamma_y*w_n;
        /* (21) K = Q_y y + Q_z z */
        const stewart_real Q_y = inv_rho*tau_k;
        const stewart_real Q_z = -inv_L*tau_y;
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x = Q_y*y_x + Q_z*z_x;
        const stewart_real K_y = Q_y*y_y + Q_z*z_y;
        const stewart_real K_z = Q_y*y_z + Q_z*z_z;
        /* (24) known part of the actuator force, to match */
        const stewart_real D = C_p*L_dot + h_z*theta_ddot - M_phi_L*phi_dot2 - h_x*theta_dot2
            - k3_h*phi_ddot;
        /* force at the tip */
        const stewart_real R_tip_x = D*s_x + K_x;
        const stewart_real R_tip_y = D*s_y + K_y;
        const stewart_real R_tip_z = D*s_z + K_z;
        out->sum[0][l] = R_tip_x;
        out->sum[1][l] = R_tip_y;
        out->sum[2][l] = R_tip_z;
        out->sum[3][l] = R_tip_z*q_y - C_s*(k_x*phi_dot + theta_dot*y_x) - R_tip_y*q_z;
        out->sum[4][l] = R_tip_x*q_z - C_s*(k_y*phi_dot + theta_dot*y_y) - R_tip_z*q_x;
        out->sum[5][l] = R_tip_y*q_x - C_s*(k_z*phi_dot + theta_dot*y_z) - R_tip_x*q_y;
        stewart_real fault;
        stewart_real reach = STEWART_SHORTEST / STEWART_ROUNDING;
        reach = STEWART_LARGER(STEWART_FABS(S_1_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(S_1_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(S_1_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_z), reach);
        out->judged.reach[l] = reach;
        out->judged.L[l] = L;
        out->judged.k3[l] = k3;
        fault = L <= STEWART_MAX ? REAL(0) : REAL(1);
        fault = L > STEWART_ROUNDING * reach ? fault : REAL(1);
        fault = k3 > STEWART_POLE_SINE ? fault : REAL(1);
        out->judged.bad[l] = fault;
    }
}

/* Platform and legs together; returns a status. */
static int bias_sums(
    const stewart_exact_model *model, const stewart_motion *motion, bias_legs *legs,
    stewart_real *sum)
{
    bias_pose pose;
    int status;
    bias_of_pose(model, motion, &pose, sum);
    bias_of_legs(model, motion, &pose, legs);
    status = legs_status(&legs->judged);
    if (status == STEWART_OK) {
        add_legs(legs->sum, 6, sum);
    }
    return status;
}

/* ---- forward_dynamics ---- */

typedef struct {
    stewart_real t_1[3];
    stewart_real B_0[9];
} forward_dynamics_pose;

typedef struct {
    stewart_real sum[27][LANES];
    leg_judgement judged;
} forward_dynamics_legs;

/* The platform's part: 204 (117 mul, 87 add, 0 div, 0 sqrt) operations. */
static void forward_dynamics_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    forward_dynamics_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT sum)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real M_ext_x = at->M_ext[0], M_ext_y = at->M_ext[1], M_ext_z = at->M_ext[2];
    const stewart_real M_P = model->M_P;
    const stewart_real h_P_x = model->h_P[0], h_P_y = model->h_P[1], h_P_z = model->h_P[2];
    const stewart_real J_P_xx = model->J_P[0], J_P_xy = model->J_P[1], J_P_xz = model->J_P[2],
        J_P_yy = model->J_P[3], J_P_yz = model->J_P[4], J_P_zz = model->J_P[5];
    const stewart_real C_P = model->C_P;
    const stewart_real b_1_x = model->b_1[0], b_1_y = model->b_1[1], b_1_z = model->b_1[2];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    /* (30) first moment of the platform, base frame */
    const stewart_real h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z;
    const stewart_real h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z;
    const stewart_real h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z;
    const stewart_real c1 = J_P_xx*R_xx + J_P_xy*R_xy + J_P_xz*R_xz;
    const stewart_real c2 = J_P_xy*R_xx + J_P_yy*R_xy + J_P_yz*R_xz;
    const stewart_real c3 = J_P_xz*R_xx + J_P_yz*R_xy + J_P_zz*R_xz;
    const stewart_real c4 = J_P_xx*R_yx + J_P_xy*R_yy + J_P_xz*R_yz;
    const stewart_real c5 = J_P_xy*R_yx + J_P_yy*R_yy + J_P_yz*R_yz;
    const stewart_real c6 = J_P_xz*R_yx + J_P_yz*R_yy + J_P_zz*R_yz;
    /* (32) inertia of the platform, base frame */
    const stewart_real J_base_xx = R_xx*c1 + R_xy*c2 + R_xz*c3;
    const stewart_real J_base_xy = R_yx*c1 + R_yy*c2 + R_yz*c3;
    const stewart_real J_base_xz = R_zx*c1 + R_zy*c2 + R_zz*c3;
    const stewart_real J_base_yy = R_yx*c4 + R_yy*c5 + R_yz*c6;
    const stewart_real J_base_yz = R_zx*c4 + R_zy*c5 + R_zz*c6;
    const stewart_real J_base_zz = R_zx*(J_P_xx*R_zx + J_P_xy*R_zy + J_P_xz*R_zz) + R_zy*(J_P_xy*R_zx
        + J_P_yy*R_zy + J_P_yz*R_zz) + R_zz*(J_P_xz*R_zx + J_P_yz*R_zy + J_P_zz*R_zz);
    /* (31) omega x h */
    const stewart_real w_h_x = h_base_z*omega_y - h_base_y*omega_z;
    const stewart_real w_h_y = h_base_x*omega_z - h_base_z*omega_x;
    const stewart_real w_h_z = h_base_y*omega_x - h_base_x*omega_y;
    /* (34) I omega */
    const stewart_real J_w_x = J_base_xx*omega_x + J_base_xy*omega_y + J_base_xz*omega_z;
    const stewart_real J_w_y = J_base_xy*omega_x + J_base_yy*omega_y + J_base_yz*omega_z;
    const stewart_real J_w_z = J_base_xz*omega_x + J_base_yz*omega_y + J_base_zz*omega_z;
    /* products of omega */
    const stewart_real omega_xx = omega_x*omega_x;
    const stewart_real omega_xy = omega_x*omega_y;
    const stewart_real omega_xz = omega_x*omega_z;
    const stewart_real omega_yy = omega_y*omega_y;
    const stewart_real omega_yz = omega_y*omega_z;
    const stewart_real omega_zz = omega_z*omega_z;
    /* (7) S_ddot = B q + a */
    const stewart_real B_xx = -omega_yy - omega_zz;
    const stewart_real B_yy = -omega_xx - omega_zz;
    const stewart_real B_zz = -omega_xx - omega_yy;
    out->t_1[0] = t_x - b_1_x;
    out->t_1[1] = t_y - b_1_y;
    out->t_1[2] = t_z - b_1_z;
    out->B_0[0] = B_xx;
    out->B_0[1] = omega_xy;
    out->B_0[2] = omega_xz;
    out->B_0[3] = omega_xy;
    out->B_0[4] = B_yy;
    out->B_0[5] = omega_yz;
    out->B_0[6] = omega_xz;
    out->B_0[7] = omega_yz;
    out->B_0[8] = B_zz;
    sum[0] = M_P;
    sum[1] = REAL(0);
    sum[2] = REAL(0);
    sum[3] = M_P;
    sum[4] = REAL(0);
    sum[5] = M_P;
    sum[6] = REAL(0);
    sum[7] = h_base_z;
    sum[8] = -h_base_y;
    sum[9] = -h_base_z;
    sum[10] = REAL(0);
    sum[11] = h_base_x;
    sum[12] = h_base_y;
    sum[13] = -h_base_x;
    sum[14] = REAL(0);
    sum[15] = J_base_xx;
    sum[16] = J_base_xy;
    sum[17] = J_base_xz;
    sum[18] = J_base_yy;
    sum[19] = J_base_yz;
    sum[20] = J_base_zz;
    sum[21] = F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz + M_P*g_x + omega_z*w_h_y - omega_y*w_h_z;
    sum[22] = F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz + M_P*g_y + omega_x*w_h_z - omega_z*w_h_x;
    sum[23] = F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz + M_P*g_z + omega_y*w_h_x - omega_x*w_h_y;
    sum[24] = J_w_y*omega_z + M_ext_x*R_xx + M_ext_y*R_xy + M_ext_z*R_xz + g_z*h_base_y - C_P*omega_x - J_w_z*omega_y - g_y*h_base_z;
    sum[25] = J_w_z*omega_x + M_ext_x*R_yx + M_ext_y*R_yy + M_ext_z*R_yz + g_x*h_base_z - C_P*omega_y - J_w_x*omega_z - g_z*h_base_x;
    sum[26] = J_w_x*omega_y + M_ext_x*R_zx + M_ext_y*R_zy + M_ext_z*R_zz + g_y*h_base_x - C_P*omega_z - J_w_y*omega_x - g_x*h_base_y;
}

/* The legs side by side: 425 (260 mul, 161 add, 2 div, 2 sqrt) operations each. */
STEWART_APART static void forward_dynamics_of_legs(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const forward_dynamics_pose *STEWART_RESTRICT pose, const stewart_real *STEWART_RESTRICT force, forward_dynamics_legs *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real B_0_xx = pose->B_0[0], B_0_xy = pose->B_0[1], B_0_xz = pose->B_0[2],
        B_0_yx = pose->B_0[3], B_0_yy = pose->B_0[4], B_0_yz = pose->B_0[5], B_0_zx = pose->B_0[6],
        B_0_zy = pose->B_0[7], B_0_zz = pose->B_0[8];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    const stewart_real t_1_x = pose->t_1[0], t_1_y = pose->t_1[1], t_1_z = pose->t_1[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real h2_y = model->h2_y[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_yy = model->J[3][l],
            J_yz = model->J[4][l];
        const stewart_real J2_xz = model->J2_xz[l];
        const stewart_real dJ_zx = model->dJ_zx[l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l],
            g_x_k_z = model->g_x_k[2][l];
        const stewart_real C_us = model->C_us[l];
        const stewart_real F = force[l];
        const stewart_real r_x = model->r[0][l], r_y = model->r[1][l], r_z = model->r[2][l];
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
        /* (2) leg length, and distance of its tip from the fixed axis */
        const stewart_real L = STEWART_SQRT(S_x*S_x + S_y*S_y + S_z*S_z);
        const stewart_real inv_L = REAL(1)/L;
        /* (3) unit vector along the leg */
        const stewart_real s_x = S_x*inv_L;
        const stewart_real s_y = S_y*inv_L;
        const stewart_real s_z = S_z*inv_L;
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = k_cross_S_z*s_y - k_cross_S_y*s_z;
        const stewart_real s_cross_normal_y = k_cross_S_x*s_z - k_cross_S_z*s_x;
        const stewart_real s_cross_normal_z = k_cross_S_y*s_x - k_cross_S_x*s_y;
        /* (10) leg length, and distance of its tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(s_cross_normal_x*s_cross_normal_x
            + s_cross_normal_y*s_cross_normal_y + s_cross_normal_z*s_cross_normal_z);
        const stewart_real inv_rho = REAL(1)/rho;
        /* (10) third axis of the leg frame */
        const stewart_real z_x = inv_rho*s_cross_normal_x;
        const stewart_real z_y = inv_rho*s_cross_normal_y;
        const stewart_real z_z = inv_rho*s_cross_normal_z;
        /* (10) rotating axis of the universal joint */
        const stewart_real y_x = s_z*z_y - s_y*z_z;
        const stewart_real y_y = s_x*z_z - s_z*z_x;
        const stewart_real y_z = s_y*z_x - s_x*z_y;
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1 = inv_L*zeta;
        const stewart_real k3 = inv_L*rho;
        /* (10) k1 / k3 */
        const stewart_real kappa = inv_rho*zeta;
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = omega_y*q_z + v_x - omega_z*q_y;
        const stewart_real S_dot_y = omega_z*q_x + v_y - omega_x*q_z;
        const stewart_real S_dot_z = omega_x*q_y + v_z - omega_y*q_x;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z;
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z);
        const stewart_real theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z);
        /* L_dot / L */
        const stewart_real L_share = L_dot*inv_L;
        const stewart_real lean = kappa*theta_dot;
        const stewart_real theta_dot2 = theta_dot*theta_dot;
        const stewart_real phi_dot2 = phi_dot*phi_dot;
        const stewart_real two_phi_dot = REAL(2)*phi_dot;
        /* (7) acceleration of the platform point, a = alpha = 0 */
        const stewart_real S_ddot_x = B_0_xx*q_x + B_0_xy*q_y + B_0_xz*q_z;
        const stewart_real S_ddot_y = B_0_yx*q_x + B_0_yy*q_y + B_0_yz*q_z;
        const stewart_real S_ddot_z = B_0_zx*q_x + B_0_zy*q_y + B_0_zz*q_z;
        const stewart_real k33 = k3*k3;
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot = L*(k33*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y
            + S_ddot_z*s_z;
        /* (9) accelerations of the joint coordinates but for the turning of the leg frame about s */
        const stewart_real own_theta_ddot = -REAL(2)*L_share*theta_dot - inv_L*(S_ddot_x*z_x + S_ddot_y*z_y
            + S_ddot_z*z_z);
        const stewart_real own_phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z)
            - L_share*two_phi_dot;
        const stewart_real c1 = k1*k3;
        /* (9) accelerations of the joint coordinates */
        const stewart_real theta_ddot = c1*phi_dot2 + own_theta_ddot;
        const stewart_real phi_ddot = own_phi_ddot - lean*two_phi_dot;
        const stewart_real k13 = c1;
        const stewart_real L_h2 = L*h2_x;
        const stewart_real a1 = L_h2 + dJ_zx;
        const stewart_real c2 = L*h2_z;
        const stewart_real c3 = J2_xz - c2;
        const stewart_real a2 = c3;
        const stewart_real a3 = J_xy - L*h_y;
        /* (19) inertia of the joint coordinates */
        const stewart_real M_phi = J_xx + a1*k33 + a2*k13;
        const stewart_real M_theta = J_yy + L_h2;
        const stewart_real M_mixed = J_yz*k3 + a3*k1;
        const stewart_real k3_h = h_y*k3;
        /* (19) slopes of M_phi / 2 along theta and L, of M_mixed along theta */
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
        const stewart_real tau_y = C_us*theta_dot + L_ddot*h_z + M_mixed*phi_ddot + M_theta*own_theta_ddot
            + bend*h2_x + g_k*w_n + gamma_n*w_k + phi_dot2*(k13*(J_yy - dJ_zx) - c3*(STEWART_HALF - k33))
            - C_s*(omega_x*y_x + omega_y*y_y + omega_z*y_z);
        const stewart_real tau_k = C_us*phi_dot + M_mixed*theta_ddot + M_mixed_theta*theta_dot2
            + M_phi*own_phi_ddot + two_phi_dot*(L_dot*M_phi_L - theta_dot*(STEWART_HALF*J2_xz + J_xx*kappa
            - STEWART_HALF*c2)) - C_s*(k_x*omega_x + k_y*omega_y + k_z*omega_z) - L_ddot*k3_h - bend*h2_y*k1
            - gamma_n*w_y - gamma_y*w_n;
        /* (21) K = Q_y y + Q_z z */
        const stewart_real Q_y = inv_rho*tau_k;
        const stewart_real Q_z = -inv_L*tau_y;
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x = Q_y*y_x + Q_z*z_x;
        const stewart_real K_y = Q_y*y_y + Q_z*z_y;
        const stewart_real K_z = Q_y*y_z + Q_z*z_z;
        /* (24) known part of the actuator force, to match */
        const stewart_real D = C_p*L_dot + h_z*theta_ddot - M_phi_L*phi_dot2 - h_x*theta_dot2
            - k3_h*phi_ddot;
        const stewart_real c4 = F - D;
        /* force on the platform at the tip */
        const stewart_real push_x = c4*s_x - K_x;
        const stewart_real push_y = c4*s_y - K_y;
        const stewart_real push_z = c4*s_z - K_z;
        /* inertia at the tip, leg frame */
        const stewart_real m_leg_sy = -inv_rho*k3_h;
        const stewart_real m_leg_sz = -h_z*inv_L;
        const stewart_real m_leg_yy = M_phi*inv_rho*inv_rho;
        const stewart_real m_leg_yz = -M_mixed*inv_L*inv_rho;
        const stewart_real m_leg_zz = M_theta*inv_L*inv_L;
        const stewart_real m_T_xs = m_leg_sy*y_x + m_leg_sz*z_x;
        const stewart_real m_T_xy = m_leg_sy*s_x + m_leg_yy*y_x + m_leg_yz*z_x;
        const stewart_real m_T_xz = m_leg_sz*s_x + m_leg_yz*y_x + m_leg_zz*z_x;
        const stewart_real m_T_ys = m_leg_sy*y_y + m_leg_sz*z_y;
        const stewart_real m_T_yy = m_leg_sy*s_y + m_leg_yy*y_y + m_leg_yz*z_y;
        const stewart_real m_T_yz = m_leg_sz*s_y + m_leg_yz*y_y + m_leg_zz*z_y;
        const stewart_real m_T_zs = m_leg_sy*y_z + m_leg_sz*z_z;
        const stewart_real m_T_zy = m_leg_sy*s_z + m_leg_yy*y_z + m_leg_yz*z_z;
        const stewart_real m_T_zz = m_leg_sz*s_z + m_leg_yz*y_z + m_leg_zz*z_z;
        /* inertia at the tip, base frame */
        const stewart_real m_xx = m_T_xs*s_x + m_T_xy*y_x + m_T_xz*z_x;
        const stewart_real m_xy = m_T_xs*s_y + m_T_xy*y_y + m_T_xz*z_y;
        const stewart_real m_xz = m_T_xs*s_z + m_T_xy*y_z + m_T_xz*z_z;
        const stewart_real m_yy = m_T_ys*s_y + m_T_yy*y_y + m_T_yz*z_y;
        const stewart_real m_yz = m_T_ys*s_z + m_T_yy*y_z + m_T_yz*z_z;
        const stewart_real m_zz = m_T_zs*s_z + m_T_zy*y_z + m_T_zz*z_z;
        const stewart_real c5 = m_xy*q_z;
        const stewart_real c6 = m_xz*q_y;
        const stewart_real c7 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c5 - c6;
        const stewart_real m_q_xy = m_xz*q_x - m_xx*q_z;
        const stewart_real m_q_xz = m_xx*q_y - m_xy*q_x;
        const stewart_real m_q_yx = m_yy*q_z - m_yz*q_y;
        const stewart_real m_q_yy = -c5 - c7;
        const stewart_real m_q_yz = m_xy*q_y - m_yy*q_x;
        const stewart_real m_q_zx = m_yz*q_z - m_zz*q_y;
        const stewart_real m_q_zy = m_zz*q_x - m_xz*q_z;
        const stewart_real m_q_zz = c6 + c7;
        out->sum[0][l] = m_xx;
        out->sum[1][l] = m_xy;
        out->sum[2][l] = m_xz;
        out->sum[3][l] = m_yy;
        out->sum[4][l] = m_yz;
        out->sum[5][l] = m_zz;
        out->sum[6][l] = -m_q_xx;
        out->sum[7][l] = -m_q_xy;
        out->sum[8][l] = -m_q_xz;
        out->sum[9][l] = -m_q_yx;
        out->sum[10][l] = -m_q_yy;
        out->sum[11][l] = -m_q_yz;
        out->sum[12][l] = -m_q_zx;
        out->sum[13][l] = -m_q_zy;
        out->sum[14][l] = -m_q_zz;
        out->sum[15][l] = m_q_yx*q_z - m_q_zx*q_y;
        out->sum[16][l] = m_q_yy*q_z - m_q_zy*q_y;
        out->sum[17][l] = m_q_yz*q_z - m_q_zz*q_y;
        out->sum[18][l] = m_q_zy*q_x - m_q_xy*q_z;
        out->sum[19][l] = m_q_zz*q_x - m_q_xz*q_z;
        out->sum[20][l] = m_q_xz*q_y - m_q_yz*q_x;
        out->sum[21][l] = push_x;
        out->sum[22][l] = push_y;
        out->sum[23][l] = push_z;
        out->sum[24][l] = C_s*(k_x*phi_dot + theta_dot*y_x) + push_z*q_y - push_y*q_z;
        out->sum[25][l] = C_s*(k_y*phi_dot + theta_dot*y_y) + push_x*q_z - push_z*q_x;
        out->sum[26][l] = C_s*(k_z*phi_dot + theta_dot*y_z) + push_y*q_x - push_x*q_y;
        stewart_real fault;
        stewart_real reach = STEWART_SHORTEST / STEWART_ROUNDING;
        reach = STEWART_LARGER(STEWART_FABS(S_1_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(S_1_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(S_1_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_z), reach);
        out->judged.reach[l] = reach;
        out->judged.L[l] = L;
        out->judged.k3[l] = k3;
        fault = L <= STEWART_MAX ? REAL(0) : REAL(1);
        fault = L > STEWART_ROUNDING * reach ? fault : REAL(1);
        fault = k3 > STEWART_POLE_SINE ? fault : REAL(1);
        out->judged.bad[l] = fault;
    }
}

/* Platform and legs together; returns a status. */
static int forward_dynamics_sums(
    const stewart_exact_model *model, const stewart_motion *motion, const stewart_real F[6], forward_dynamics_legs *legs,
    stewart_real *sum)
{
    forward_dynamics_pose pose;
    int status;
    stewart_real force[LANES];
    int i;
    forward_dynamics_of_pose(model, motion, &pose, sum);
    for (i = 0; i < LANES; ++i) {
        force[i] = F[i < 6 ? i : 5];
    }
    forward_dynamics_of_legs(model, motion, &pose, force, legs);
    status = legs_status(&legs->judged);
    if (status == STEWART_OK) {
        add_legs(legs->sum, 27, sum);
    }
    return status;
}

/* ---- derivatives ---- */

typedef struct {
    stewart_real t_1[3];
    stewart_real B[9];
} derivatives_pose;

typedef struct {
    stewart_real sum[93][LANES];
    stewart_real H_force[3][8];
    stewart_real H_moment[3][8];
    leg_judgement judged;
} derivatives_legs;

/* The platform's part: 341 (168 mul, 173 add, 0 div, 0 sqrt) operations. */
static void derivatives_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    derivatives_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT sum)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real M_ext_x = at->M_ext[0], M_ext_y = at->M_ext[1], M_ext_z = at->M_ext[2];
    const stewart_real M_P = model->M_P;
    const stewart_real h_P_x = model->h_P[0], h_P_y = model->h_P[1], h_P_z = model->h_P[2];
    const stewart_real J_P_xx = model->J_P[0], J_P_xy = model->J_P[1], J_P_xz = model->J_P[2],
        J_P_yy = model->J_P[3], J_P_yz = model->J_P[4], J_P_zz = model->J_P[5];
    const stewart_real C_P = model->C_P;
    const stewart_real b_1_x = model->b_1[0], b_1_y = model->b_1[1], b_1_z = model->b_1[2];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    /* (30) first moment of the platform, base frame */
    const stewart_real h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z;
    const stewart_real h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z;
    const stewart_real h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z;
    const stewart_real c1 = J_P_xx*R_xx + J_P_xy*R_xy + J_P_xz*R_xz;
    const stewart_real c2 = J_P_xy*R_xx + J_P_yy*R_xy + J_P_yz*R_xz;
    const stewart_real c3 = J_P_xz*R_xx + J_P_yz*R_xy + J_P_zz*R_xz;
    const stewart_real c4 = J_P_xx*R_yx + J_P_xy*R_yy + J_P_xz*R_yz;
    const stewart_real c5 = J_P_xy*R_yx + J_P_yy*R_yy + J_P_yz*R_yz;
    const stewart_real c6 = J_P_xz*R_yx + J_P_yz*R_yy + J_P_zz*R_yz;
    /* (32) inertia of the platform, base frame */
    const stewart_real J_base_xx = R_xx*c1 + R_xy*c2 + R_xz*c3;
    const stewart_real J_base_xy = R_yx*c1 + R_yy*c2 + R_yz*c3;
    const stewart_real J_base_xz = R_zx*c1 + R_zy*c2 + R_zz*c3;
    const stewart_real J_base_yy = R_yx*c4 + R_yy*c5 + R_yz*c6;
    const stewart_real J_base_yz = R_zx*c4 + R_zy*c5 + R_zz*c6;
    const stewart_real J_base_zz = R_zx*(J_P_xx*R_zx + J_P_xy*R_zy + J_P_xz*R_zz) + R_zy*(J_P_xy*R_zx
        + J_P_yy*R_zy + J_P_yz*R_zz) + R_zz*(J_P_xz*R_zx + J_P_yz*R_zy + J_P_zz*R_zz);
    const stewart_real c7 = h_base_y*omega_z;
    const stewart_real c8 = h_base_z*omega_y;
    const stewart_real c9 = h_base_x*omega_z;
    const stewart_real c10 = h_base_z*omega_x;
    const stewart_real c11 = h_base_x*omega_y;
    const stewart_real c12 = h_base_y*omega_x;
    /* (31) omega x h */
    const stewart_real w_h_x = c8 - c7;
    const stewart_real w_h_y = c9 - c10;
    const stewart_real w_h_z = c12 - c11;
    const stewart_real c13 = J_base_xy*omega_y;
    const stewart_real c14 = J_base_xz*omega_z;
    const stewart_real c15 = J_base_xy*omega_x;
    const stewart_real c16 = J_base_yz*omega_z;
    const stewart_real c17 = J_base_xz*omega_x;
    const stewart_real c18 = J_base_yz*omega_y;
    /* (34) I omega */
    const stewart_real J_w_x = J_base_xx*omega_x + c13 + c14;
    const stewart_real J_w_y = J_base_yy*omega_y + c15 + c16;
    const stewart_real J_w_z = J_base_zz*omega_z + c17 + c18;
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
    const stewart_real c19 = J_base_xy*alpha_y;
    const stewart_real c20 = J_base_xz*alpha_z;
    const stewart_real J_alpha_x = J_base_xx*alpha_x + c19 + c20;
    const stewart_real c21 = J_base_xy*alpha_x;
    const stewart_real c22 = J_base_yz*alpha_z;
    const stewart_real J_alpha_y = J_base_yy*alpha_y + c21 + c22;
    const stewart_real c23 = J_base_xz*alpha_x;
    const stewart_real c24 = J_base_yz*alpha_y;
    const stewart_real J_alpha_z = J_base_zz*alpha_z + c23 + c24;
    /* (33) a - g */
    const stewart_real rise_x = a_x - g_x;
    const stewart_real rise_y = a_y - g_y;
    const stewart_real rise_z = a_z - g_z;
    const stewart_real F_load_x = F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz;
    const stewart_real F_load_y = F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz;
    const stewart_real F_load_z = F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz;
    const stewart_real M_load_x = M_ext_x*R_xx + M_ext_y*R_xy + M_ext_z*R_xz;
    const stewart_real M_load_y = M_ext_x*R_yx + M_ext_y*R_yy + M_ext_z*R_yz;
    const stewart_real M_load_z = M_ext_x*R_zx + M_ext_y*R_zy + M_ext_z*R_zz;
    const stewart_real c25 = J_base_xy*omega_z;
    const stewart_real c26 = J_base_xz*omega_y;
    const stewart_real c28 = J_w_z + c17 - J_base_xx*omega_z;
    const stewart_real c29 = J_w_y + c15 - J_base_xx*omega_y;
    const stewart_real c30 = J_w_z + c18 - J_base_yy*omega_z;
    const stewart_real c31 = J_base_yz*omega_x;
    const stewart_real c33 = c25 - c31;
    const stewart_real c34 = J_w_x + c13 - J_base_yy*omega_x;
    const stewart_real c35 = J_w_y + c16 - J_base_zz*omega_y;
    const stewart_real c36 = J_w_x + c14 - J_base_zz*omega_x;
    /* derivative of I omega by dphi at fixed omega */
    const stewart_real spin_xx = c25 - c26;
    const stewart_real spin_xy = c28;
    const stewart_real spin_xz = -c29;
    const stewart_real spin_yx = -c30;
    const stewart_real spin_yy = -c33;
    const stewart_real spin_yz = c34;
    const stewart_real spin_zx = c35;
    const stewart_real spin_zy = -c36;
    const stewart_real spin_zz = c26 - c31;
    const stewart_real c37 = J_base_xz*alpha_y;
    const stewart_real c38 = h_base_y*rise_y;
    const stewart_real c39 = h_base_z*rise_z;
    const stewart_real c40 = J_base_xy*alpha_z;
    const stewart_real c41 = h_base_x*rise_x;
    const stewart_real c42 = J_base_yz*alpha_x;
    const stewart_real c43 = h_base_y*omega_y;
    const stewart_real c44 = h_base_z*omega_z;
    const stewart_real c45 = h_base_x*omega_x;
    out->t_1[0] = t_x - b_1_x;
    out->t_1[1] = t_y - b_1_y;
    out->t_1[2] = t_z - b_1_z;
    out->B[0] = B_xx;
    out->B[1] = B_xy;
    out->B[2] = B_xz;
    out->B[3] = B_yx;
    out->B[4] = B_yy;
    out->B[5] = B_yz;
    out->B[6] = B_zx;
    out->B[7] = B_zy;
    out->B[8] = B_zz;
    sum[0] = M_P;
    sum[1] = REAL(0);
    sum[2] = REAL(0);
    sum[3] = M_P;
    sum[4] = REAL(0);
    sum[5] = M_P;
    sum[6] = REAL(0);
    sum[7] = h_base_z;
    sum[8] = -h_base_y;
    sum[9] = -h_base_z;
    sum[10] = REAL(0);
    sum[11] = h_base_x;
    sum[12] = h_base_y;
    sum[13] = -h_base_x;
    sum[14] = REAL(0);
    sum[15] = J_base_xx;
    sum[16] = J_base_xy;
    sum[17] = J_base_xz;
    sum[18] = J_base_yy;
    sum[19] = J_base_yz;
    sum[20] = J_base_zz;
    sum[21] = REAL(0);
    sum[22] = REAL(0);
    sum[23] = REAL(0);
    sum[24] = REAL(0);
    sum[25] = REAL(0);
    sum[26] = REAL(0);
    sum[27] = REAL(0);
    sum[28] = REAL(0);
    sum[29] = REAL(0);
    sum[30] = B_xz*h_base_y - B_xy*h_base_z;
    sum[31] = B_xx*h_base_z - B_xz*h_base_x - F_load_z;
    sum[32] = B_xy*h_base_x + F_load_y - B_xx*h_base_y;
    sum[33] = B_yz*h_base_y + F_load_z - B_yy*h_base_z;
    sum[34] = B_yx*h_base_z - B_yz*h_base_x;
    sum[35] = B_yy*h_base_x - B_yx*h_base_y - F_load_x;
    sum[36] = B_zz*h_base_y - B_zy*h_base_z - F_load_y;
    sum[37] = B_zx*h_base_z + F_load_x - B_zz*h_base_x;
    sum[38] = B_zy*h_base_x - B_zx*h_base_y;
    sum[39] = REAL(0);
    sum[40] = REAL(0);
    sum[41] = REAL(0);
    sum[42] = REAL(0);
    sum[43] = REAL(0);
    sum[44] = REAL(0);
    sum[45] = REAL(0);
    sum[46] = REAL(0);
    sum[47] = REAL(0);
    sum[48] = c40 + omega_y*spin_zx - c37 - c38 - c39 - omega_z*spin_yx;
    sum[49] = J_alpha_z + c23 + h_base_x*rise_y + omega_y*spin_zy - J_base_xx*alpha_z - M_load_z - omega_z*spin_yy;
    sum[50] = J_base_xx*alpha_y + M_load_y + h_base_x*rise_z + omega_y*spin_zz - J_alpha_y - c21 - omega_z*spin_yz;
    sum[51] = J_base_yy*alpha_z + M_load_z + h_base_y*rise_x + omega_z*spin_xx - J_alpha_z - c24 - omega_x*spin_zx;
    sum[52] = c42 + omega_z*spin_xy - c39 - c40 - c41 - omega_x*spin_zy;
    sum[53] = J_alpha_x + c19 + h_base_y*rise_z + omega_z*spin_xz - J_base_yy*alpha_x - M_load_x - omega_x*spin_zz;
    sum[54] = J_alpha_y + c22 + h_base_z*rise_x + omega_x*spin_yx - J_base_zz*alpha_y - M_load_y - omega_y*spin_xx;
    sum[55] = J_base_zz*alpha_x + M_load_x + h_base_z*rise_y + omega_x*spin_yy - J_alpha_x - c20 - omega_y*spin_xy;
    sum[56] = c37 + omega_x*spin_yz - c38 - c41 - c42 - omega_y*spin_xz;
    sum[57] = REAL(0);
    sum[58] = REAL(0);
    sum[59] = REAL(0);
    sum[60] = REAL(0);
    sum[61] = REAL(0);
    sum[62] = REAL(0);
    sum[63] = REAL(0);
    sum[64] = REAL(0);
    sum[65] = REAL(0);
    sum[66] = c43 + c44;
    sum[67] = w_h_z - c11;
    sum[68] = -c9 - w_h_y;
    sum[69] = -c12 - w_h_z;
    sum[70] = c44 + c45;
    sum[71] = w_h_x - c7;
    sum[72] = w_h_y - c10;
    sum[73] = -c8 - w_h_x;
    sum[74] = c43 + c45;
    sum[75] = REAL(0);
    sum[76] = REAL(0);
    sum[77] = REAL(0);
    sum[78] = REAL(0);
    sum[79] = REAL(0);
    sum[80] = REAL(0);
    sum[81] = REAL(0);
    sum[82] = REAL(0);
    sum[83] = REAL(0);
    sum[84] = C_P + c26 - c25;
    sum[85] = c30;
    sum[86] = -c35;
    sum[87] = -c28;
    sum[88] = C_P + c33;
    sum[89] = c36;
    sum[90] = c29;
    sum[91] = -c34;
    sum[92] = C_P + c31 - c26;
}

/* The legs side by side: 1725 (1022 mul, 699 add, 2 div, 2 sqrt) operations each. */
STEWART_APART static void derivatives_of_legs(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const derivatives_pose *STEWART_RESTRICT pose, const stewart_real *STEWART_RESTRICT force, derivatives_legs *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3],
        R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real B_xx = pose->B[0], B_xy = pose->B[1], B_xz = pose->B[2], B_yx = pose->B[3],
        B_yy = pose->B[4], B_yz = pose->B[5], B_zx = pose->B[6], B_zy = pose->B[7], B_zz = pose->B[8];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    const stewart_real t_1_x = pose->t_1[0], t_1_y = pose->t_1[1], t_1_z = pose->t_1[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_xz = model->J[2][l],
            J_yy = model->J[3][l], J_yz = model->J[4][l], J_zz = model->J[5][l];
        const stewart_real J2_xz = model->J2_xz[l];
        const stewart_real dJ_zx = model->dJ_zx[l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l],
            g_x_k_z = model->g_x_k[2][l];
        const stewart_real C_us = model->C_us[l];
        const stewart_real F = force[l];
        const stewart_real r_x = model->r[0][l], r_y = model->r[1][l], r_z = model->r[2][l];
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
        /* (2) leg length, and distance of its tip from the fixed axis */
        const stewart_real L = STEWART_SQRT(S_x*S_x + S_y*S_y + S_z*S_z);
        const stewart_real inv_L = REAL(1)/L;
        /* (3) unit vector along the leg */
        const stewart_real s_x = S_x*inv_L;
        const stewart_real s_y = S_y*inv_L;
        const stewart_real s_z = S_z*inv_L;
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = k_cross_S_z*s_y - k_cross_S_y*s_z;
        const stewart_real s_cross_normal_y = k_cross_S_x*s_z - k_cross_S_z*s_x;
        const stewart_real s_cross_normal_z = k_cross_S_y*s_x - k_cross_S_x*s_y;
        /* (10) leg length, and distance of its tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(s_cross_normal_x*s_cross_normal_x
            + s_cross_normal_y*s_cross_normal_y + s_cross_normal_z*s_cross_normal_z);
        const stewart_real inv_rho = REAL(1)/rho;
        /* (10) third axis of the leg frame */
        const stewart_real z_x = inv_rho*s_cross_normal_x;
        const stewart_real z_y = inv_rho*s_cross_normal_y;
        const stewart_real z_z = inv_rho*s_cross_normal_z;
        /* (10) rotating axis of the universal joint */
        const stewart_real y_x = s_z*z_y - s_y*z_z;
        const stewart_real y_y = s_x*z_z - s_z*z_x;
        const stewart_real y_z = s_y*z_x - s_x*z_y;
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1 = inv_L*zeta;
        const stewart_real k3 = inv_L*rho;
        /* (10) k1 / k3 */
        const stewart_real kappa = inv_rho*zeta;
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = omega_y*q_z + v_x - omega_z*q_y;
        const stewart_real S_dot_y = omega_z*q_x + v_y - omega_x*q_z;
        const stewart_real S_dot_z = omega_x*q_y + v_z - omega_y*q_x;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z;
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z);
        const stewart_real theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z);
        const stewart_real c1 = L_dot*inv_L;
        /* L_dot / L */
        const stewart_real L_share = c1;
        const stewart_real c2 = kappa*theta_dot;
        const stewart_real lean = c2;
        const stewart_real c3 = theta_dot*theta_dot;
        const stewart_real theta_dot2 = c3;
        const stewart_real c4 = phi_dot*phi_dot;
        const stewart_real phi_dot2 = c4;
        const stewart_real c5 = REAL(2)*phi_dot;
        const stewart_real two_phi_dot = c5;
        /* (7) acceleration of the platform point */
        const stewart_real S_ddot_x = B_xx*q_x + B_xy*q_y + B_xz*q_z + a_x;
        const stewart_real S_ddot_y = B_yx*q_x + B_yy*q_y + B_yz*q_z + a_y;
        const stewart_real S_ddot_z = B_zx*q_x + B_zy*q_y + B_zz*q_z + a_z;
        const stewart_real c6 = k3*k3;
        const stewart_real k33 = c6;
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot = L*(k33*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y
            + S_ddot_z*s_z;
        const stewart_real c7 = REAL(2)*theta_dot;
        /* (9) accelerations of the joint coordinates but for the turning of the leg frame about s */
        const stewart_real own_theta_ddot = -L_share*c7 - inv_L*(S_ddot_x*z_x + S_ddot_y*z_y
            + S_ddot_z*z_z);
        const stewart_real own_phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z)
            - L_share*two_phi_dot;
        const stewart_real c8 = k1*k3;
        /* (9) accelerations of the joint coordinates */
        const stewart_real theta_ddot = c8*phi_dot2 + own_theta_ddot;
        const stewart_real phi_ddot = own_phi_ddot - lean*two_phi_dot;
        const stewart_real k13 = c8;
        const stewart_real L_h2 = L*h2_x;
        const stewart_real a1 = L_h2 + dJ_zx;
        const stewart_real a2 = J2_xz - L*h2_z;
        const stewart_real c9 = J_xy - L*h_y;
        const stewart_real a3 = c9;
        const stewart_real c10 = J_yz*k3;
        /* (19) inertia of the joint coordinates */
        const stewart_real M_phi = J_xx + a1*k33 + a2*k13;
        const stewart_real M_theta = J_yy + L_h2;
        const stewart_real M_mixed = a3*k1 + c10;
        const stewart_real c11 = h_y*k3;
        const stewart_real k3_h = c11;
        const stewart_real c12 = inv_rho*inv_rho;
        const stewart_real c13 = inv_L*inv_rho;
        const stewart_real c14 = inv_L*inv_L;
        /* inertia at the tip, leg frame */
        const stewart_real m_leg_sy = -inv_rho*k3_h;
        const stewart_real m_leg_sz = -h_z*inv_L;
        const stewart_real m_leg_yy = M_phi*c12;
        const stewart_real m_leg_yz = -M_mixed*c13;
        const stewart_real m_leg_zz = M_theta*c14;
        const stewart_real m_T_xs = m_leg_sy*y_x + m_leg_sz*z_x;
        const stewart_real m_T_xy = m_leg_sy*s_x + m_leg_yy*y_x + m_leg_yz*z_x;
        const stewart_real m_T_xz = m_leg_sz*s_x + m_leg_yz*y_x + m_leg_zz*z_x;
        const stewart_real m_T_ys = m_leg_sy*y_y + m_leg_sz*z_y;
        const stewart_real m_T_yy = m_leg_sy*s_y + m_leg_yy*y_y + m_leg_yz*z_y;
        const stewart_real m_T_yz = m_leg_sz*s_y + m_leg_yz*y_y + m_leg_zz*z_y;
        const stewart_real m_T_zs = m_leg_sy*y_z + m_leg_sz*z_z;
        const stewart_real m_T_zy = m_leg_sy*s_z + m_leg_yy*y_z + m_leg_yz*z_z;
        const stewart_real m_T_zz = m_leg_sz*s_z + m_leg_yz*y_z + m_leg_zz*z_z;
        /* inertia at the tip, base frame */
        const stewart_real m_xx = m_T_xs*s_x + m_T_xy*y_x + m_T_xz*z_x;
        const stewart_real m_xy = m_T_xs*s_y + m_T_xy*y_y + m_T_xz*z_y;
        const stewart_real m_xz = m_T_xs*s_z + m_T_xy*y_z + m_T_xz*z_z;
        const stewart_real m_yy = m_T_ys*s_y + m_T_yy*y_y + m_T_yz*z_y;
        const stewart_real m_yz = m_T_ys*s_z + m_T_yy*y_z + m_T_yz*z_z;
        const stewart_real m_zz = m_T_zs*s_z + m_T_zy*y_z + m_T_zz*z_z;
        /* gravity along k x y and along y */
        const stewart_real gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z;
        const stewart_real gamma_y = g_x*y_x + g_y*y_y + g_z*y_z;
        /* k x y */
        const stewart_real normal_x = k_y*y_z - k_z*y_y;
        const stewart_real normal_y = k_z*y_x - k_x*y_z;
        const stewart_real normal_z = k_x*y_y - k_y*y_x;
        /* omega along k x y, y and k */
        const stewart_real w_n_omega = normal_x*omega_x + normal_y*omega_y + normal_z*omega_z;
        const stewart_real w_y_omega = omega_x*y_x + omega_y*y_y + omega_z*y_z;
        const stewart_real w_k_omega = k_x*omega_x + k_y*omega_y + k_z*omega_z;
        const stewart_real c15 = c6*h_x;
        const stewart_real c16 = c15 - h_z*k1*k3;
        const stewart_real tau_L = C_p*L_dot + h_z*theta_ddot - c11*phi_ddot - c16*c4 - c3*h_x;
        const stewart_real c18 = c7*h_x;
        const stewart_real c19 = REAL(2)*L;
        const stewart_real c20 = c19*h_x;
        const stewart_real c21 = k1*w_x + k3*w_z;
        const stewart_real c22 = k1*w_z - k3*w_x;
        const stewart_real c24 = c10 + c9*k1;
        const stewart_real c25 = REAL(2)*J_xz - c19*h_z;
        const stewart_real c26 = c25*k1;
        const stewart_real c27 = J_zz + c20 - J_xx;
        const stewart_real c28 = c27*k3;
        const stewart_real c29 = c26 + REAL(2)*c28;
        const stewart_real c30 = STEWART_HALF*k1;
        const stewart_real c31 = c29*c30 - STEWART_HALF*c25*c6;
        const stewart_real tau_theta = C_us*theta_dot + L_ddot*h_z + L_dot*c18 + c21*gamma_n + c24*phi_ddot
            + theta_ddot*(J_yy + c20) - C_s*w_y_omega - c22*g_k - c31*c4;
        const stewart_real c33 = h_y*theta_dot;
        const stewart_real c34 = c33*k1;
        const stewart_real c35 = L_dot*c16;
        const stewart_real c36 = c31*theta_dot;
        const stewart_real c37 = L_dot*h_y;
        const stewart_real c38 = c37*k1;
        const stewart_real c39 = theta_dot*(J_yz*k1 - c9*k3);
        const stewart_real tau_phi = C_us*phi_dot + L_dot*(c16*phi_dot - c34) + c22*gamma_y + c24*theta_ddot
            + phi_ddot*(J_xx + c25*c8 + c27*c6) + phi_dot*(c35 + c36) + theta_dot*(c31*phi_dot + c39 - c38)
            - C_s*w_k_omega - L_ddot*c11 - gamma_n*w_y;
        const stewart_real c40 = k3*phi_dot;
        const stewart_real G_dot_12 = c40;
        const stewart_real c41 = inv_L*theta_dot;
        const stewart_real G_dot_21 = -c41;
        const stewart_real c42 = k1*phi_dot;
        const stewart_real G_dot_22 = c42*inv_L;
        const stewart_real c43 = L_dot*c14;
        const stewart_real G_dot_23 = c43;
        const stewart_real c44 = c40*inv_rho;
        const stewart_real G_dot_31 = -c44;
        const stewart_real c45 = c1*inv_rho;
        const stewart_real c46 = -c2*inv_rho - c45;
        const stewart_real G_dot_32 = c46;
        const stewart_real c47 = c42*inv_rho;
        const stewart_real G_dot_33 = c47;
        const stewart_real c48 = c4*c6;
        const stewart_real G_ddot_11 = -c3 - c48;
        const stewart_real c49 = k3*phi_ddot;
        const stewart_real c50 = c5*k1;
        const stewart_real G_ddot_12 = c49 + c50*theta_dot;
        const stewart_real c51 = c4*c8;
        const stewart_real G_ddot_13 = c51 - theta_ddot;
        const stewart_real G_ddot_21 = REAL(2)*L_dot*c14*theta_dot - c51*inv_L - inv_L*theta_ddot;
        const stewart_real G_ddot_22 = inv_L*k1*phi_ddot - c41*c5*k3 - c43*c50;
        const stewart_real c52 = c4*k1*k1;
        const stewart_real G_ddot_23 = L_ddot*c14 + c3*inv_L + c52*inv_L
            - REAL(2)*L_dot*L_dot*inv_L*inv_L*inv_L;
        const stewart_real G_ddot_31 = c1*c44 + c47*theta_dot + theta_dot*(inv_rho*k3*kappa*phi_dot - c47)
            - c40*c46 - c49*inv_rho;
        const stewart_real c53 = inv_rho*kappa;
        const stewart_real c54 = -c1 - c2;
        const stewart_real c55 = inv_rho*theta_dot;
        const stewart_real G_ddot_32 = L_dot*(c43*inv_rho - c13*c54) + theta_dot*(-c53*c54
            - c55*(-kappa*kappa - REAL(1))) - L_ddot*c13 - c48*inv_rho - c52*inv_rho - c53*theta_ddot;
        const stewart_real G_ddot_33 = c42*c46 + c44*theta_dot + inv_rho*k1*phi_ddot + theta_dot*(-c44
            - c47*kappa) - c42*c45;
        const stewart_real tau_rate_12 = -c18;
        const stewart_real tau_rate_13 = -c16*c5;
        const stewart_real tau_rate_21 = c18;
        const stewart_real c56 = REAL(2)*h_x;
        const stewart_real tau_rate_22 = C_us + L_dot*c56;
        const stewart_real tau_rate_23 = -c31*c5;
        const stewart_real tau_rate_31 = REAL(2)*c16*phi_dot - REAL(2)*c34;
        const stewart_real tau_rate_32 = c31*c5 + REAL(2)*c39 - REAL(2)*c38;
        const stewart_real tau_rate_33 = C_us + REAL(2)*c35 + REAL(2)*c36;
        const stewart_real c57 = h_y*phi_ddot;
        const stewart_real c58 = c56*k3 - h_z*k1;
        const stewart_real tau_place_12 = k1*(-c4*c58 - c57) - c48*h_z;
        const stewart_real c59 = REAL(4)*h_x;
        const stewart_real c60 = c30*(c59*k3 - REAL(2)*h_z*k1) + c6*h_z;
        const stewart_real tau_place_21 = c56*theta_ddot - c4*c60 - c57*k1;
        const stewart_real c61 = c30*(REAL(2)*J_zz + L*c59 - REAL(2)*J_xx) - c25*k3;
        const stewart_real c62 = c26 + c28;
        const stewart_real tau_place_22 = k1*(J_yz*phi_ddot + g_k*w_x + gamma_n*w_z - c4*c61)
            - k3*(c9*phi_ddot + gamma_n*w_x - c4*c62 - g_k*w_z);
        const stewart_real tau_place_23 = -C_s*w_n_omega - c21*gamma_y;
        const stewart_real c63 = c60*phi_dot;
        const stewart_real tau_place_31 = c63*theta_dot + phi_ddot*(REAL(2)*c15 - REAL(2)*c8*h_z)
            + theta_dot*(c11*theta_dot + c63) - h_y*k1*theta_ddot;
        const stewart_real c64 = L_dot*c58;
        const stewart_real tau_place_32 = k1*(J_yz*theta_ddot + c29*phi_ddot + c64*phi_dot
            + phi_dot*(c61*theta_dot + c64) + theta_dot*(c61*phi_dot - c9*theta_dot) - L_ddot*h_y
            - gamma_y*w_x) - k3*(L_dot*(-c33 - c40*h_z) + c25*c49 + c9*theta_ddot + gamma_y*w_z
            + phi_dot*(c62*theta_dot - L_dot*h_z*k3) + theta_dot*(J_yz*theta_dot + c62*phi_dot - c37));
        const stewart_real tau_place_33 = c22*gamma_n + gamma_y*w_y;
        const stewart_real c65 = inv_rho*tau_phi;
        const stewart_real c66 = inv_L*tau_theta;
        const stewart_real c67 = tau_L - F;
        /* force at the tip, less the actuator's */
        const stewart_real R_tip_x = c65*y_x + c67*s_x - c66*z_x;
        const stewart_real R_tip_y = c65*y_y + c67*s_y - c66*z_y;
        const stewart_real R_tip_z = c65*y_z + c67*s_z - c66*z_z;
        const stewart_real c68 = C_s*inv_rho;
        const stewart_real c69 = c68*k1;
        const stewart_real A_3_leg_21 = -c69;
        const stewart_real c70 = c68*k3;
        const stewart_real A_3_leg_23 = -c70;
        const stewart_real c71 = C_s*inv_L;
        const stewart_real A_3_leg_32 = c71;
        const stewart_real A_3_T_xs = A_3_leg_21*y_x;
        const stewart_real A_3_T_xy = A_3_leg_32*z_x;
        const stewart_real A_3_T_xz = A_3_leg_23*y_x;
        const stewart_real A_3_T_ys = A_3_leg_21*y_y;
        const stewart_real A_3_T_yy = A_3_leg_32*z_y;
        const stewart_real A_3_T_yz = A_3_leg_23*y_y;
        const stewart_real A_3_T_zs = A_3_leg_21*y_z;
        const stewart_real A_3_T_zy = A_3_leg_32*z_z;
        const stewart_real A_3_T_zz = A_3_leg_23*y_z;
        /* force at the tip by omega */
        const stewart_real A_3_xx = A_3_T_xs*s_x + A_3_T_xy*y_x + A_3_T_xz*z_x;
        const stewart_real A_3_xy = A_3_T_xs*s_y + A_3_T_xy*y_y + A_3_T_xz*z_y;
        const stewart_real A_3_xz = A_3_T_xs*s_z + A_3_T_xy*y_z + A_3_T_xz*z_z;
        const stewart_real A_3_yx = A_3_T_ys*s_x + A_3_T_yy*y_x + A_3_T_yz*z_x;
        const stewart_real A_3_yy = A_3_T_ys*s_y + A_3_T_yy*y_y + A_3_T_yz*z_y;
        const stewart_real A_3_yz = A_3_T_ys*s_z + A_3_T_yy*y_z + A_3_T_yz*z_z;
        const stewart_real A_3_zx = A_3_T_zs*s_x + A_3_T_zy*y_x + A_3_T_zz*z_x;
        const stewart_real A_3_zy = A_3_T_zs*s_y + A_3_T_zy*y_y + A_3_T_zz*z_y;
        const stewart_real A_3_zz = A_3_T_zs*s_z + A_3_T_zy*y_z + A_3_T_zz*z_z;
        const stewart_real c72 = C_s*k1;
        const stewart_real f_S_leg_11 = G_dot_31*c72;
        const stewart_real f_S_leg_12 = C_s*(G_dot_32*k1 - c55*k3);
        const stewart_real f_S_leg_13 = G_dot_33*c72;
        const stewart_real f_S_leg_21 = C_s*G_dot_21;
        const stewart_real f_S_leg_22 = C_s*G_dot_22;
        const stewart_real f_S_leg_23 = C_s*G_dot_23;
        const stewart_real c73 = C_s*k3;
        const stewart_real f_S_leg_31 = G_dot_31*c73;
        const stewart_real f_S_leg_32 = C_s*(G_dot_32*k3 + c55*k1);
        const stewart_real f_S_leg_33 = G_dot_33*c73;
        const stewart_real f_S_T_xs = f_S_leg_11*s_x + f_S_leg_21*y_x + f_S_leg_31*z_x;
        const stewart_real f_S_T_xy = f_S_leg_12*s_x + f_S_leg_22*y_x + f_S_leg_32*z_x;
        const stewart_real f_S_T_xz = f_S_leg_13*s_x + f_S_leg_23*y_x + f_S_leg_33*z_x;
        const stewart_real f_S_T_ys = f_S_leg_11*s_y + f_S_leg_21*y_y + f_S_leg_31*z_y;
        const stewart_real f_S_T_yy = f_S_leg_12*s_y + f_S_leg_22*y_y + f_S_leg_32*z_y;
        const stewart_real f_S_T_yz = f_S_leg_13*s_y + f_S_leg_23*y_y + f_S_leg_33*z_y;
        const stewart_real f_S_T_zs = f_S_leg_11*s_z + f_S_leg_21*y_z + f_S_leg_31*z_z;
        const stewart_real f_S_T_zy = f_S_leg_12*s_z + f_S_leg_22*y_z + f_S_leg_32*z_z;
        const stewart_real f_S_T_zz = f_S_leg_13*s_z + f_S_leg_23*y_z + f_S_leg_33*z_z;
        /* friction moment by S */
        const stewart_real f_S_xx = f_S_T_xs*s_x + f_S_T_xy*y_x + f_S_T_xz*z_x;
        const stewart_real f_S_xy = f_S_T_xs*s_y + f_S_T_xy*y_y + f_S_T_xz*z_y;
        const stewart_real f_S_xz = f_S_T_xs*s_z + f_S_T_xy*y_z + f_S_T_xz*z_z;
        const stewart_real f_S_yx = f_S_T_ys*s_x + f_S_T_yy*y_x + f_S_T_yz*z_x;
        const stewart_real f_S_yy = f_S_T_ys*s_y + f_S_T_yy*y_y + f_S_T_yz*z_y;
        const stewart_real f_S_yz = f_S_T_ys*s_z + f_S_T_yy*y_z + f_S_T_yz*z_z;
        const stewart_real f_S_zx = f_S_T_zs*s_x + f_S_T_zy*y_x + f_S_T_zz*z_x;
        const stewart_real f_S_zy = f_S_T_zs*s_y + f_S_T_zy*y_y + f_S_T_zz*z_y;
        const stewart_real f_S_zz = f_S_T_zs*s_z + f_S_T_zy*y_z + f_S_T_zz*z_z;
        const stewart_real f_S_dot_leg_12 = c69;
        const stewart_real f_S_dot_leg_23 = -c71;
        const stewart_real f_S_dot_leg_32 = c70;
        const stewart_real f_S_dot_T_xy = f_S_dot_leg_12*s_x + f_S_dot_leg_32*z_x;
        const stewart_real f_S_dot_T_xz = f_S_dot_leg_23*y_x;
        const stewart_real f_S_dot_T_yy = f_S_dot_leg_12*s_y + f_S_dot_leg_32*z_y;
        const stewart_real f_S_dot_T_yz = f_S_dot_leg_23*y_y;
        const stewart_real f_S_dot_T_zy = f_S_dot_leg_12*s_z + f_S_dot_leg_32*z_z;
        const stewart_real f_S_dot_T_zz = f_S_dot_leg_23*y_z;
        /* friction moment by S_dot */
        const stewart_real f_S_dot_xx = f_S_dot_T_xy*y_x + f_S_dot_T_xz*z_x;
        const stewart_real f_S_dot_xy = f_S_dot_T_xy*y_y + f_S_dot_T_xz*z_y;
        const stewart_real f_S_dot_xz = f_S_dot_T_xy*y_z + f_S_dot_T_xz*z_z;
        const stewart_real f_S_dot_yx = f_S_dot_T_yy*y_x + f_S_dot_T_yz*z_x;
        const stewart_real f_S_dot_yy = f_S_dot_T_yy*y_y + f_S_dot_T_yz*z_y;
        const stewart_real f_S_dot_yz = f_S_dot_T_yy*y_z + f_S_dot_T_yz*z_z;
        const stewart_real f_S_dot_zx = f_S_dot_T_zy*y_x + f_S_dot_T_zz*z_x;
        const stewart_real f_S_dot_zy = f_S_dot_T_zy*y_y + f_S_dot_T_zz*z_y;
        const stewart_real f_S_dot_zz = f_S_dot_T_zy*y_z + f_S_dot_T_zz*z_z;
        const stewart_real A_0_leg_11 = G_ddot_21*h_z + G_dot_21*tau_rate_12 + G_dot_31*tau_rate_13
            - G_ddot_31*k3_h;
        const stewart_real A_0_leg_12 = C_p*G_dot_12 + G_ddot_22*h_z + G_dot_22*tau_rate_12
            + G_dot_32*tau_rate_13 - G_ddot_32*k3_h - c12*k3*tau_phi;
        const stewart_real c74 = c14*tau_theta;
        const stewart_real A_0_leg_13 = G_ddot_23*h_z + G_dot_23*tau_rate_12 + G_dot_33*tau_rate_13 + c74
            - C_p*theta_dot - G_ddot_33*k3_h - inv_L*tau_place_12;
        const stewart_real c75 = c13*tau_phi;
        const stewart_real A_0_leg_21 = inv_rho*(G_ddot_21*M_mixed + G_ddot_31*M_phi + G_dot_21*tau_rate_32
            + G_dot_31*tau_rate_33 + tau_place_31 - G_ddot_11*k3_h) - c75;
        const stewart_real c76 = inv_rho*k3;
        const stewart_real A_0_leg_22 = c13*k1*tau_theta + c76*tau_L + inv_rho*(G_ddot_22*M_mixed
            + G_ddot_32*M_phi + G_dot_12*tau_rate_31 + G_dot_22*tau_rate_32 + G_dot_32*tau_rate_33
            + inv_rho*tau_place_33 - G_ddot_12*k3_h) - F*c76;
        const stewart_real A_0_leg_23 = c75*kappa + inv_rho*(G_ddot_23*M_mixed + G_ddot_33*M_phi
            + G_dot_23*tau_rate_32 + G_dot_33*tau_rate_33 - G_ddot_13*k3_h - inv_L*tau_place_32
            - tau_rate_31*theta_dot);
        const stewart_real A_0_leg_31 = c74 - inv_L*(G_ddot_11*h_z + G_ddot_21*M_theta + G_ddot_31*M_mixed
            + G_dot_21*tau_rate_22 + G_dot_31*tau_rate_23 + tau_place_21);
        const stewart_real A_0_leg_32 = c12*k1*tau_phi - inv_L*(G_ddot_12*h_z + G_ddot_22*M_theta
            + G_ddot_32*M_mixed + G_dot_12*tau_rate_21 + G_dot_22*tau_rate_22 + G_dot_32*tau_rate_23
            + inv_rho*tau_place_23);
        const stewart_real A_0_leg_33 = inv_L*tau_L - F*inv_L - inv_L*(G_ddot_13*h_z + G_ddot_23*M_theta
            + G_ddot_33*M_mixed + G_dot_23*tau_rate_22 + G_dot_33*tau_rate_23 - inv_L*tau_place_22
            - tau_rate_21*theta_dot);
        const stewart_real A_0_T_xs = A_0_leg_11*s_x + A_0_leg_21*y_x + A_0_leg_31*z_x;
        const stewart_real A_0_T_xy = A_0_leg_12*s_x + A_0_leg_22*y_x + A_0_leg_32*z_x;
        const stewart_real A_0_T_xz = A_0_leg_13*s_x + A_0_leg_23*y_x + A_0_leg_33*z_x;
        const stewart_real A_0_T_ys = A_0_leg_11*s_y + A_0_leg_21*y_y + A_0_leg_31*z_y;
        const stewart_real A_0_T_yy = A_0_leg_12*s_y + A_0_leg_22*y_y + A_0_leg_32*z_y;
        const stewart_real A_0_T_yz = A_0_leg_13*s_y + A_0_leg_23*y_y + A_0_leg_33*z_y;
        const stewart_real A_0_T_zs = A_0_leg_11*s_z + A_0_leg_21*y_z + A_0_leg_31*z_z;
        const stewart_real A_0_T_zy = A_0_leg_12*s_z + A_0_leg_22*y_z + A_0_leg_32*z_z;
        const stewart_real A_0_T_zz = A_0_leg_13*s_z + A_0_leg_23*y_z + A_0_leg_33*z_z;
        /* force at the tip by S */
        const stewart_real A_0_xx = A_0_T_xs*s_x + A_0_T_xy*y_x + A_0_T_xz*z_x;
        const stewart_real A_0_xy = A_0_T_xs*s_y + A_0_T_xy*y_y + A_0_T_xz*z_y;
        const stewart_real A_0_xz = A_0_T_xs*s_z + A_0_T_xy*y_z + A_0_T_xz*z_z;
        const stewart_real A_0_yx = A_0_T_ys*s_x + A_0_T_yy*y_x + A_0_T_yz*z_x;
        const stewart_real A_0_yy = A_0_T_ys*s_y + A_0_T_yy*y_y + A_0_T_yz*z_y;
        const stewart_real A_0_yz = A_0_T_ys*s_z + A_0_T_yy*y_z + A_0_T_yz*z_z;
        const stewart_real A_0_zx = A_0_T_zs*s_x + A_0_T_zy*y_x + A_0_T_zz*z_x;
        const stewart_real A_0_zy = A_0_T_zs*s_y + A_0_T_zy*y_y + A_0_T_zz*z_y;
        const stewart_real A_0_zz = A_0_T_zs*s_z + A_0_T_zy*y_z + A_0_T_zz*z_z;
        const stewart_real c77 = REAL(2)*h_z;
        const stewart_real c78 = REAL(2)*k3_h;
        const stewart_real A_1_leg_11 = C_p + G_dot_21*c77 - G_dot_31*c78;
        const stewart_real A_1_leg_12 = G_dot_22*c77 + inv_rho*tau_rate_13 - G_dot_32*c78;
        const stewart_real A_1_leg_13 = REAL(2)*G_dot_23*h_z - G_dot_33*c78 - inv_L*tau_rate_12;
        const stewart_real c79 = REAL(2)*M_mixed;
        const stewart_real c80 = REAL(2)*M_phi;
        const stewart_real A_1_leg_21 = inv_rho*(G_dot_21*c79 + G_dot_31*c80 + tau_rate_31);
        const stewart_real A_1_leg_22 = inv_rho*(G_dot_22*c79 + G_dot_32*c80 + inv_rho*tau_rate_33
            - G_dot_12*c78);
        const stewart_real A_1_leg_23 = inv_rho*(G_dot_23*c79 + G_dot_33*c80 + c7*k3_h - inv_L*tau_rate_32);
        const stewart_real c81 = REAL(2)*M_theta;
        const stewart_real A_1_leg_31 = -inv_L*(G_dot_21*c81 + G_dot_31*c79 + tau_rate_21);
        const stewart_real A_1_leg_32 = -inv_L*(G_dot_12*c77 + G_dot_22*c81 + G_dot_32*c79
            + inv_rho*tau_rate_23);
        const stewart_real A_1_leg_33 = -inv_L*(G_dot_23*c81 + G_dot_33*c79 - c7*h_z - inv_L*tau_rate_22);
        const stewart_real A_1_T_xs = A_1_leg_11*s_x + A_1_leg_21*y_x + A_1_leg_31*z_x;
        const stewart_real A_1_T_xy = A_1_leg_12*s_x + A_1_leg_22*y_x + A_1_leg_32*z_x;
        const stewart_real A_1_T_xz = A_1_leg_13*s_x + A_1_leg_23*y_x + A_1_leg_33*z_x;
        const stewart_real A_1_T_ys = A_1_leg_11*s_y + A_1_leg_21*y_y + A_1_leg_31*z_y;
        const stewart_real A_1_T_yy = A_1_leg_12*s_y + A_1_leg_22*y_y + A_1_leg_32*z_y;
        const stewart_real A_1_T_yz = A_1_leg_13*s_y + A_1_leg_23*y_y + A_1_leg_33*z_y;
        const stewart_real A_1_T_zs = A_1_leg_11*s_z + A_1_leg_21*y_z + A_1_leg_31*z_z;
        const stewart_real A_1_T_zy = A_1_leg_12*s_z + A_1_leg_22*y_z + A_1_leg_32*z_z;
        const stewart_real A_1_T_zz = A_1_leg_13*s_z + A_1_leg_23*y_z + A_1_leg_33*z_z;
        /* force at the tip by S_dot */
        const stewart_real A_1_xx = A_1_T_xs*s_x + A_1_T_xy*y_x + A_1_T_xz*z_x;
        const stewart_real A_1_xy = A_1_T_xs*s_y + A_1_T_xy*y_y + A_1_T_xz*z_y;
        const stewart_real A_1_xz = A_1_T_xs*s_z + A_1_T_xy*y_z + A_1_T_xz*z_z;
        const stewart_real A_1_yx = A_1_T_ys*s_x + A_1_T_yy*y_x + A_1_T_yz*z_x;
        const stewart_real A_1_yy = A_1_T_ys*s_y + A_1_T_yy*y_y + A_1_T_yz*z_y;
        const stewart_real A_1_yz = A_1_T_ys*s_z + A_1_T_yy*y_z + A_1_T_yz*z_z;
        const stewart_real A_1_zx = A_1_T_zs*s_x + A_1_T_zy*y_x + A_1_T_zz*z_x;
        const stewart_real A_1_zy = A_1_T_zs*s_y + A_1_T_zy*y_y + A_1_T_zz*z_y;
        const stewart_real A_1_zz = A_1_T_zs*s_z + A_1_T_zy*y_z + A_1_T_zz*z_z;
        /* (4) omega x q */
        const stewart_real w_q_x = S_dot_x - v_x;
        const stewart_real w_q_y = S_dot_y - v_y;
        const stewart_real w_q_z = S_dot_z - v_z;
        /* force by rotation about the tip */
        const stewart_real X_xx = A_0_xx + A_1_xy*omega_z + B_xx*m_xx + B_yx*m_xy + B_zx*m_xz
            - A_1_xz*omega_y;
        const stewart_real X_xy = A_0_xy + A_1_xz*omega_x + B_xy*m_xx + B_yy*m_xy + B_zy*m_xz
            - A_1_xx*omega_z;
        const stewart_real X_xz = A_0_xz + A_1_xx*omega_y + B_xz*m_xx + B_yz*m_xy + B_zz*m_xz
            - A_1_xy*omega_x;
        const stewart_real X_yx = A_0_yx + A_1_yy*omega_z + B_xx*m_xy + B_yx*m_yy + B_zx*m_yz
            - A_1_yz*omega_y;
        const stewart_real X_yy = A_0_yy + A_1_yz*omega_x + B_xy*m_xy + B_yy*m_yy + B_zy*m_yz
            - A_1_yx*omega_z;
        const stewart_real X_yz = A_0_yz + A_1_yx*omega_y + B_xz*m_xy + B_yz*m_yy + B_zz*m_yz
            - A_1_yy*omega_x;
        const stewart_real X_zx = A_0_zx + A_1_zy*omega_z + B_xx*m_xz + B_yx*m_yz + B_zx*m_zz
            - A_1_zz*omega_y;
        const stewart_real X_zy = A_0_zy + A_1_zz*omega_x + B_xy*m_xz + B_yy*m_yz + B_zy*m_zz
            - A_1_zx*omega_z;
        const stewart_real X_zz = A_0_zz + A_1_zx*omega_y + B_xz*m_xz + B_yz*m_yz + B_zz*m_zz
            - A_1_zy*omega_x;
        const stewart_real c82 = m_xy*omega_z;
        const stewart_real c83 = m_xz*omega_y;
        const stewart_real Y_xx = A_1_xx + c82 - c83;
        const stewart_real Y_xy = A_1_xy + m_xz*omega_x - m_xx*omega_z;
        const stewart_real Y_xz = A_1_xz + m_xx*omega_y - m_xy*omega_x;
        const stewart_real Y_yx = A_1_yx + m_yy*omega_z - m_yz*omega_y;
        const stewart_real c84 = m_yz*omega_x;
        const stewart_real Y_yy = A_1_yy + c84 - c82;
        const stewart_real Y_yz = A_1_yz + m_xy*omega_y - m_yy*omega_x;
        const stewart_real Y_zx = A_1_zx + m_yz*omega_z - m_zz*omega_y;
        const stewart_real Y_zy = A_1_zy + m_zz*omega_x - m_xz*omega_z;
        const stewart_real Y_zz = A_1_zz + c83 - c84;
        const stewart_real Z_xx = X_xz*q_y - X_xy*q_z;
        const stewart_real Z_xy = X_xx*q_z - X_xz*q_x;
        const stewart_real Z_xz = X_xy*q_x - X_xx*q_y;
        const stewart_real Z_yx = X_yz*q_y - X_yy*q_z;
        const stewart_real Z_yy = X_yx*q_z - X_yz*q_x;
        const stewart_real Z_yz = X_yy*q_x - X_yx*q_y;
        const stewart_real Z_zx = X_zz*q_y - X_zy*q_z;
        const stewart_real Z_zy = X_zx*q_z - X_zz*q_x;
        const stewart_real Z_zz = X_zy*q_x - X_zx*q_y;
        const stewart_real c85 = m_xz*w_q_y;
        const stewart_real c86 = m_xy*w_q_z;
        const stewart_real V_xx = A_3_xx + Y_xz*q_y + c85 - Y_xy*q_z - c86;
        const stewart_real V_xy = A_3_xy + Y_xx*q_z + m_xx*w_q_z - Y_xz*q_x - m_xz*w_q_x;
        const stewart_real V_xz = A_3_xz + Y_xy*q_x + m_xy*w_q_x - Y_xx*q_y - m_xx*w_q_y;
        const stewart_real V_yx = A_3_yx + Y_yz*q_y + m_yz*w_q_y - Y_yy*q_z - m_yy*w_q_z;
        const stewart_real c87 = m_yz*w_q_x;
        const stewart_real V_yy = A_3_yy + Y_yx*q_z + c86 - Y_yz*q_x - c87;
        const stewart_real V_yz = A_3_yz + Y_yy*q_x + m_yy*w_q_x - Y_yx*q_y - m_xy*w_q_y;
        const stewart_real V_zx = A_3_zx + Y_zz*q_y + m_zz*w_q_y - Y_zy*q_z - m_yz*w_q_z;
        const stewart_real V_zy = A_3_zy + Y_zx*q_z + m_xz*w_q_z - Y_zz*q_x - m_zz*w_q_x;
        const stewart_real V_zz = A_3_zz + Y_zy*q_x + c87 - Y_zx*q_y - c85;
        const stewart_real c88 = m_xy*q_z;
        const stewart_real c89 = m_xz*q_y;
        const stewart_real c90 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c88 - c89;
        const stewart_real m_q_xy = m_xz*q_x - m_xx*q_z;
        const stewart_real m_q_xz = m_xx*q_y - m_xy*q_x;
        const stewart_real m_q_yx = m_yy*q_z - m_yz*q_y;
        const stewart_real m_q_yy = -c88 - c90;
        const stewart_real m_q_yz = m_xy*q_y - m_yy*q_x;
        const stewart_real m_q_zx = m_yz*q_z - m_zz*q_y;
        const stewart_real m_q_zy = m_zz*q_x - m_xz*q_z;
        const stewart_real m_q_zz = c89 + c90;
        const stewart_real c91 = R_tip_y*q_y;
        const stewart_real c92 = R_tip_z*q_z;
        const stewart_real c93 = f_S_dot_xx*omega_y + f_S_xz - f_S_dot_xy*omega_x;
        const stewart_real c94 = f_S_dot_xz*omega_x + f_S_xy - f_S_dot_xx*omega_z;
        const stewart_real c95 = f_S_dot_xy*omega_z + f_S_xx - f_S_dot_xz*omega_y;
        const stewart_real c96 = f_S_dot_yz*omega_x + f_S_yy - f_S_dot_yx*omega_z;
        const stewart_real c97 = f_S_dot_yx*omega_y + f_S_yz - f_S_dot_yy*omega_x;
        const stewart_real c98 = R_tip_x*q_x;
        const stewart_real c99 = f_S_dot_yy*omega_z + f_S_yx - f_S_dot_yz*omega_y;
        const stewart_real c100 = f_S_dot_zz*omega_x + f_S_zy - f_S_dot_zx*omega_z;
        const stewart_real c101 = f_S_dot_zx*omega_y + f_S_zz - f_S_dot_zy*omega_x;
        const stewart_real c102 = f_S_dot_zy*omega_z + f_S_zx - f_S_dot_zz*omega_y;
        out->sum[0][l] = m_xx;
        out->sum[1][l] = m_xy;
        out->sum[2][l] = m_xz;
        out->sum[3][l] = m_yy;
        out->sum[4][l] = m_yz;
        out->sum[5][l] = m_zz;
        out->sum[6][l] = -m_q_xx;
        out->sum[7][l] = -m_q_xy;
        out->sum[8][l] = -m_q_xz;
        out->sum[9][l] = -m_q_yx;
        out->sum[10][l] = -m_q_yy;
        out->sum[11][l] = -m_q_yz;
        out->sum[12][l] = -m_q_zx;
        out->sum[13][l] = -m_q_zy;
        out->sum[14][l] = -m_q_zz;
        out->sum[15][l] = m_q_yx*q_z - m_q_zx*q_y;
        out->sum[16][l] = m_q_yy*q_z - m_q_zy*q_y;
        out->sum[17][l] = m_q_yz*q_z - m_q_zz*q_y;
        out->sum[18][l] = m_q_zy*q_x - m_q_xy*q_z;
        out->sum[19][l] = m_q_zz*q_x - m_q_xz*q_z;
        out->sum[20][l] = m_q_xz*q_y - m_q_yz*q_x;
        out->sum[21][l] = A_0_xx;
        out->sum[22][l] = A_0_xy;
        out->sum[23][l] = A_0_xz;
        out->sum[24][l] = A_0_yx;
        out->sum[25][l] = A_0_yy;
        out->sum[26][l] = A_0_yz;
        out->sum[27][l] = A_0_zx;
        out->sum[28][l] = A_0_zy;
        out->sum[29][l] = A_0_zz;
        out->sum[30][l] = Z_xx;
        out->sum[31][l] = Z_xy;
        out->sum[32][l] = Z_xz;
        out->sum[33][l] = Z_yx;
        out->sum[34][l] = Z_yy;
        out->sum[35][l] = Z_yz;
        out->sum[36][l] = Z_zx;
        out->sum[37][l] = Z_zy;
        out->sum[38][l] = Z_zz;
        out->sum[39][l] = A_0_zx*q_y - A_0_yx*q_z - f_S_xx;
        out->sum[40][l] = A_0_zy*q_y - A_0_yy*q_z - f_S_xy;
        out->sum[41][l] = A_0_zz*q_y - A_0_yz*q_z - f_S_xz;
        out->sum[42][l] = A_0_xx*q_z - A_0_zx*q_x - f_S_yx;
        out->sum[43][l] = A_0_xy*q_z - A_0_zy*q_x - f_S_yy;
        out->sum[44][l] = A_0_xz*q_z - A_0_zz*q_x - f_S_yz;
        out->sum[45][l] = A_0_yx*q_x - A_0_xx*q_y - f_S_zx;
        out->sum[46][l] = A_0_yy*q_x - A_0_xy*q_y - f_S_zy;
        out->sum[47][l] = A_0_yz*q_x - A_0_xz*q_y - f_S_zz;
        out->sum[48][l] = Z_zx*q_y + c94*q_z - Z_yx*q_z - c91 - c92 - c93*q_y;
        out->sum[49][l] = R_tip_y*q_x + Z_zy*q_y + c93*q_x - Z_yy*q_z - c95*q_z;
        out->sum[50][l] = R_tip_z*q_x + Z_zz*q_y + c95*q_y - Z_yz*q_z - c94*q_x;
        out->sum[51][l] = R_tip_x*q_y + Z_xx*q_z + c96*q_z - Z_zx*q_x - c97*q_y;
        out->sum[52][l] = Z_xy*q_z + c97*q_x - Z_zy*q_x - c92 - c98 - c99*q_z;
        out->sum[53][l] = R_tip_z*q_y + Z_xz*q_z + c99*q_y - Z_zz*q_x - c96*q_x;
        out->sum[54][l] = R_tip_x*q_z + Z_yx*q_x + c100*q_z - Z_xx*q_y - c101*q_y;
        out->sum[55][l] = R_tip_y*q_z + Z_yy*q_x + c101*q_x - Z_xy*q_y - c102*q_z;
        out->sum[56][l] = Z_yz*q_x + c102*q_y - Z_xz*q_y - c100*q_x - c91 - c98;
        out->sum[57][l] = A_1_xx;
        out->sum[58][l] = A_1_xy;
        out->sum[59][l] = A_1_xz;
        out->sum[60][l] = A_1_yx;
        out->sum[61][l] = A_1_yy;
        out->sum[62][l] = A_1_yz;
        out->sum[63][l] = A_1_zx;
        out->sum[64][l] = A_1_zy;
        out->sum[65][l] = A_1_zz;
        out->sum[66][l] = V_xx;
        out->sum[67][l] = V_xy;
        out->sum[68][l] = V_xz;
        out->sum[69][l] = V_yx;
        out->sum[70][l] = V_yy;
        out->sum[71][l] = V_yz;
        out->sum[72][l] = V_zx;
        out->sum[73][l] = V_zy;
        out->sum[74][l] = V_zz;
        out->sum[75][l] = A_1_zx*q_y - A_1_yx*q_z - f_S_dot_xx;
        out->sum[76][l] = A_1_zy*q_y - A_1_yy*q_z - f_S_dot_xy;
        out->sum[77][l] = A_1_zz*q_y - A_1_yz*q_z - f_S_dot_xz;
        out->sum[78][l] = A_1_xx*q_z - A_1_zx*q_x - f_S_dot_yx;
        out->sum[79][l] = A_1_xy*q_z - A_1_zy*q_x - f_S_dot_yy;
        out->sum[80][l] = A_1_xz*q_z - A_1_zz*q_x - f_S_dot_yz;
        out->sum[81][l] = A_1_yx*q_x - A_1_xx*q_y - f_S_dot_zx;
        out->sum[82][l] = A_1_yy*q_x - A_1_xy*q_y - f_S_dot_zy;
        out->sum[83][l] = A_1_yz*q_x - A_1_xz*q_y - f_S_dot_zz;
        out->sum[84][l] = V_zx*q_y + f_S_dot_xy*q_z - V_yx*q_z - f_S_dot_xz*q_y;
        out->sum[85][l] = V_zy*q_y + f_S_dot_xz*q_x - V_yy*q_z - f_S_dot_xx*q_z;
        out->sum[86][l] = V_zz*q_y + f_S_dot_xx*q_y - V_yz*q_z - f_S_dot_xy*q_x;
        out->sum[87][l] = V_xx*q_z + f_S_dot_yy*q_z - V_zx*q_x - f_S_dot_yz*q_y;
        out->sum[88][l] = V_xy*q_z + f_S_dot_yz*q_x - V_zy*q_x - f_S_dot_yx*q_z;
        out->sum[89][l] = V_xz*q_z + f_S_dot_yx*q_y - V_zz*q_x - f_S_dot_yy*q_x;
        out->sum[90][l] = V_yx*q_x + f_S_dot_zy*q_z - V_xx*q_y - f_S_dot_zz*q_y;
        out->sum[91][l] = V_yy*q_x + f_S_dot_zz*q_x - V_xy*q_y - f_S_dot_zx*q_z;
        out->sum[92][l] = V_yz*q_x + f_S_dot_zx*q_y - V_xz*q_y - f_S_dot_zy*q_x;
        out->H_force[0][l] = s_x;
        out->H_force[1][l] = s_y;
        out->H_force[2][l] = s_z;
        out->H_moment[0][l] = q_y*s_z - q_z*s_y;
        out->H_moment[1][l] = q_z*s_x - q_x*s_z;
        out->H_moment[2][l] = q_x*s_y - q_y*s_x;
        stewart_real fault;
        stewart_real reach = STEWART_SHORTEST / STEWART_ROUNDING;
        reach = STEWART_LARGER(STEWART_FABS(S_1_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(S_1_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(S_1_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(t_1_z), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_x), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_y), reach);
        reach = STEWART_LARGER(STEWART_FABS(r_z), reach);
        out->judged.reach[l] = reach;
        out->judged.L[l] = L;
        out->judged.k3[l] = k3;
        fault = L <= STEWART_MAX ? REAL(0) : REAL(1);
        fault = L > STEWART_ROUNDING * reach ? fault : REAL(1);
        fault = k3 > STEWART_POLE_SINE ? fault : REAL(1);
        out->judged.bad[l] = fault;
    }
}

/* Platform and legs together; returns a status. */
static int derivatives_sums(
    const stewart_exact_model *model, const stewart_motion *motion, const stewart_real F[6], derivatives_legs *legs,
    stewart_real *sum)
{
    derivatives_pose pose;
    int status;
    stewart_real force[LANES];
    int i;
    derivatives_of_pose(model, motion, &pose, sum);
    for (i = 0; i < LANES; ++i) {
        force[i] = F[i < 6 ? i : 5];
    }
    derivatives_of_legs(model, motion, &pose, force, legs);
    status = legs_status(&legs->judged);
    if (status == STEWART_OK) {
        add_legs(legs->sum, 93, sum);
    }
    return status;
}

/* Solves for X the rows [M | Y] of 8 numbers by L D L^T, M positive definite, leaving X in place of Y.
 * Returns a status. */
static int solve_definite_8(stewart_real A[6 * 8])
{
    stewart_real scale[6], inverse[6];
    int i, j, k;
    for (k = 0; k < 6; ++k) {
        scale[k] = A[k * 8 + k];
    }
    for (k = 0; k < 6; ++k) {
        if (!(A[k * 8 + k] > STEWART_ROUNDING * scale[k])) {
            return STEWART_FABS(A[k * 8 + k]) <= STEWART_MAX ? STEWART_INDEFINITE : STEWART_NOT_FINITE;
        }
        inverse[k] = REAL(1) / A[k * 8 + k];
        for (i = k + 1; i < 6; ++i) {
            const stewart_real factor = A[i * 8 + k] * inverse[k];
            for (j = 0; j < 8; ++j) {
                A[i * 8 + j] = A[i * 8 + j] - factor * A[k * 8 + j];
            }
        }
    }
    for (k = 5; k >= 0; --k) {
        for (j = 6; j < 8; ++j) {
            A[k * 8 + j] = A[k * 8 + j] * inverse[k];
        }
        for (i = 0; i < k; ++i) {
            const stewart_real factor = A[i * 8 + k];
            for (j = 6; j < 8; ++j) {
                A[i * 8 + j] = A[i * 8 + j] - factor * A[k * 8 + j];
            }
        }
    }
    return STEWART_OK;
}

/* Solves for X the rows [M | Y] of 24 numbers by L D L^T, M positive definite, leaving X in place of Y.
 * Returns a status. */
static int solve_definite_24(stewart_real A[6 * 24])
{
    stewart_real scale[6], inverse[6];
    int i, j, k;
    for (k = 0; k < 6; ++k) {
        scale[k] = A[k * 24 + k];
    }
    for (k = 0; k < 6; ++k) {
        if (!(A[k * 24 + k] > STEWART_ROUNDING * scale[k])) {
            return STEWART_FABS(A[k * 24 + k]) <= STEWART_MAX ? STEWART_INDEFINITE : STEWART_NOT_FINITE;
        }
        inverse[k] = REAL(1) / A[k * 24 + k];
        for (i = k + 1; i < 6; ++i) {
            const stewart_real factor = A[i * 24 + k] * inverse[k];
            for (j = 0; j < 24; ++j) {
                A[i * 24 + j] = A[i * 24 + j] - factor * A[k * 24 + j];
            }
        }
    }
    for (k = 5; k >= 0; --k) {
        for (j = 6; j < 24; ++j) {
            A[k * 24 + j] = A[k * 24 + j] * inverse[k];
        }
        for (i = 0; i < k; ++i) {
            const stewart_real factor = A[i * 24 + k];
            for (j = 6; j < 24; ++j) {
                A[i * 24 + j] = A[i * 24 + j] - factor * A[k * 24 + j];
            }
        }
    }
    return STEWART_OK;
}

/* Solves for X the rows [H | Y] of 12 numbers by elimination with partial pivoting, leaving X in place of Y.
 * Returns a status. */
static int solve_pivoted_12(stewart_real A[6 * 12])
{
    stewart_real scale[6], inverse[6];
    int i, j, k;
    stewart_real moment = REAL(0);
    for (i = 3; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            moment = STEWART_LARGER(STEWART_FABS(A[i * 12 + j]), moment);
        }
    }
    for (i = 0; i < 6; ++i) {
        scale[i] = i < 3 ? REAL(1) : moment;
    }
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        stewart_real row_scale, size;
        for (i = k + 1; i < 6; ++i) {
            if (STEWART_FABS(A[i * 12 + k]) > STEWART_FABS(A[pivot * 12 + k])) {
                pivot = i;
            }
        }
        row_scale = scale[pivot];
        scale[pivot] = scale[k];
        size = STEWART_FABS(A[pivot * 12 + k]);
        if (!(size > STEWART_ROUNDING * row_scale)) {
            return size <= STEWART_MAX ? STEWART_SINGULAR : STEWART_NOT_FINITE;
        }
        for (j = 0; pivot != k && j < 12; ++j) {
            const stewart_real moved = A[k * 12 + j];
            A[k * 12 + j] = A[pivot * 12 + j];
            A[pivot * 12 + j] = moved;
        }
        inverse[k] = REAL(1) / A[k * 12 + k];
        for (i = k + 1; i < 6; ++i) {
            const stewart_real factor = A[i * 12 + k] * inverse[k];
            for (j = 0; j < 12; ++j) {
                A[i * 12 + j] = A[i * 12 + j] - factor * A[k * 12 + j];
            }
        }
    }
    for (k = 5; k >= 0; --k) {
        for (j = 6; j < 12; ++j) {
            A[k * 12 + j] = A[k * 12 + j] * inverse[k];
        }
        for (i = 0; i < k; ++i) {
            const stewart_real factor = A[i * 12 + k];
            for (j = 6; j < 12; ++j) {
                A[i * 12 + j] = A[i * 12 + j] - factor * A[k * 12 + j];
            }
        }
    }
    return STEWART_OK;
}

/* Solves for X the rows [H | Y] of 24 numbers by elimination with partial pivoting, leaving X in place of Y.
 * Returns a status. */
static int solve_pivoted_24(stewart_real A[6 * 24])
{
    stewart_real scale[6], inverse[6];
    int i, j, k;
    stewart_real moment = REAL(0);
    for (i = 3; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            moment = STEWART_LARGER(STEWART_FABS(A[i * 24 + j]), moment);
        }
    }
    for (i = 0; i < 6; ++i) {
        scale[i] = i < 3 ? REAL(1) : moment;
    }
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        stewart_real row_scale, size;
        for (i = k + 1; i < 6; ++i) {
            if (STEWART_FABS(A[i * 24 + k]) > STEWART_FABS(A[pivot * 24 + k])) {
                pivot = i;
            }
        }
        row_scale = scale[pivot];
        scale[pivot] = scale[k];
        size = STEWART_FABS(A[pivot * 24 + k]);
        if (!(size > STEWART_ROUNDING * row_scale)) {
            return size <= STEWART_MAX ? STEWART_SINGULAR : STEWART_NOT_FINITE;
        }
        for (j = 0; pivot != k && j < 24; ++j) {
            const stewart_real moved = A[k * 24 + j];
            A[k * 24 + j] = A[pivot * 24 + j];
            A[pivot * 24 + j] = moved;
        }
        inverse[k] = REAL(1) / A[k * 24 + k];
        for (i = k + 1; i < 6; ++i) {
            const stewart_real factor = A[i * 24 + k] * inverse[k];
            for (j = 0; j < 24; ++j) {
                A[i * 24 + j] = A[i * 24 + j] - factor * A[k * 24 + j];
            }
        }
    }
    for (k = 5; k >= 0; --k) {
        for (j = 6; j < 24; ++j) {
            A[k * 24 + j] = A[k * 24 + j] * inverse[k];
        }
        for (i = 0; i < k; ++i) {
            const stewart_real factor = A[i * 24 + k];
            for (j = 6; j < 24; ++j) {
                A[i * 24 + j] = A[i * 24 + j] - factor * A[k * 24 + j];
            }
        }
    }
    return STEWART_OK;
}

int stewart_exact_equations(
    const stewart_exact_model *model, const stewart_motion *motion, stewart_equations *out)
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

int stewart_exact_bias(
    const stewart_exact_model *model, const stewart_motion *motion, stewart_real bias[6])
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

int stewart_exact_forward_dynamics(
    const stewart_exact_model *model, const stewart_motion *motion, const stewart_real F[6],
    stewart_real acceleration[6])
{
    forward_dynamics_legs legs;
    stewart_real A[48], sum[27];
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
    status = solve_definite_8(A);
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

int stewart_exact_joint_inertia(
    const stewart_exact_model *model, const stewart_motion *motion, stewart_real inertia[36])
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
    status = solve_pivoted_12(A);
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
    status = solve_pivoted_12(A);
    if (status != STEWART_OK) {
        return status;
    }
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

int stewart_exact_derivatives(
    const stewart_exact_model *model, const stewart_motion *motion, stewart_derivatives *out)
{
    derivatives_legs legs;
    stewart_derivatives found;
    stewart_real A[144], sum[93];
    int i, j, status;
    if (model == NULL || motion == NULL || out == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    status = stewart_exact_forces(model, motion, found.F);
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
    status = solve_pivoted_24(A);
    if (status != STEWART_OK) {
        return status;
    }
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

int stewart_exact_linearisation(
    const stewart_exact_model *model, const stewart_motion *motion, const stewart_real F[6],
    stewart_linearisation *out)
{
    derivatives_legs legs;
    stewart_linearisation found;
    stewart_motion moving;
    stewart_real A[144], sum[93];
    int i, j, status;
    if (model == NULL || motion == NULL || F == NULL || out == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    status = stewart_exact_forward_dynamics(model, motion, F, found.acceleration);
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
    status = solve_definite_24(A);
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

/* Numbers of one pose to their place in an array of all poses, if there is one. */
static void copy_to(const stewart_real *from, int count, size_t pose, stewart_real *to)
{
    if (to != NULL) {
        copy(from, count, &to[pose * (size_t)count]);
    }
}

static void load_three(const stewart_real *from, size_t pose, stewart_real *to)
{
    int i;
    for (i = 0; i < 3; ++i) {
        to[i] = from != NULL ? from[pose * 3U + (size_t)i] : REAL(0);
    }
}

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

int stewart_exact_equations_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions,
    const stewart_equations_arrays *out, int *status)
{
    stewart_motion one;
    stewart_equations found;
    size_t pose;
    int result = STEWART_OK;
    if (model == NULL || motions == NULL || out == NULL || motions->R == NULL || motions->t == NULL
        || motions->omega == NULL || motions->v == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        int code;
        load_pose(motions, pose, &one);
        code = stewart_exact_equations(model, &one, &found);
        if (code == STEWART_OK) {
            copy_to(found.M, 36, pose, out->M);
            copy_to(found.C, 36, pose, out->C);
            copy_to(found.g, 6, pose, out->g);
            copy_to(found.friction, 6, pose, out->friction);
            copy_to(found.bias, 6, pose, out->bias);
            copy_to(found.H, 36, pose, out->H);
            copy_to(found.H_dot, 36, pose, out->H_dot);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}

int stewart_exact_derivatives_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions,
    const stewart_derivatives_arrays *out, int *status)
{
    stewart_motion one;
    stewart_derivatives found;
    size_t pose;
    int result = STEWART_OK;
    if (model == NULL || motions == NULL || out == NULL || motions->R == NULL || motions->t == NULL
        || motions->omega == NULL || motions->v == NULL || motions->alpha == NULL || motions->a == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        int code;
        load_pose(motions, pose, &one);
        code = stewart_exact_derivatives(model, &one, &found);
        if (code == STEWART_OK) {
            copy_to(found.F, 6, pose, out->F);
            copy_to(found.by_pose, 36, pose, out->by_pose);
            copy_to(found.by_twist, 36, pose, out->by_twist);
            copy_to(found.by_acceleration, 36, pose, out->by_acceleration);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}

int stewart_exact_linearisation_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions,
    const stewart_real *F, const stewart_linearisation_arrays *out, int *status)
{
    stewart_motion one;
    stewart_linearisation found;
    size_t pose;
    int result = STEWART_OK;
    if (model == NULL || motions == NULL || out == NULL || motions->R == NULL || motions->t == NULL
        || motions->omega == NULL || motions->v == NULL || F == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        int code;
        load_pose(motions, pose, &one);
        code = stewart_exact_linearisation(model, &one, &F[pose * 6U], &found);
        if (code == STEWART_OK) {
            copy_to(found.acceleration, 6, pose, out->acceleration);
            copy_to(found.A, 144, pose, out->A);
            copy_to(found.B, 72, pose, out->B);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}

int stewart_exact_bias_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions,
    stewart_real *out, int *status)
{
    stewart_motion one;
    stewart_real found[6];
    size_t pose;
    int result = STEWART_OK;
    if (model == NULL || motions == NULL || out == NULL || motions->R == NULL || motions->t == NULL
        || motions->omega == NULL || motions->v == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        int code;
        load_pose(motions, pose, &one);
        code = stewart_exact_bias(model, &one, found);
        if (code == STEWART_OK) {
            copy_to(found, 6, pose, out);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}

int stewart_exact_forward_dynamics_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions,
    const stewart_real *F, stewart_real *out, int *status)
{
    stewart_motion one;
    stewart_real found[6];
    size_t pose;
    int result = STEWART_OK;
    if (model == NULL || motions == NULL || out == NULL || motions->R == NULL || motions->t == NULL
        || motions->omega == NULL || motions->v == NULL || F == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        int code;
        load_pose(motions, pose, &one);
        code = stewart_exact_forward_dynamics(model, &one, &F[pose * 6U], found);
        if (code == STEWART_OK) {
            copy_to(found, 6, pose, out);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}

int stewart_exact_joint_inertia_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions,
    stewart_real *out, int *status)
{
    stewart_motion one;
    stewart_real found[36];
    size_t pose;
    int result = STEWART_OK;
    if (model == NULL || motions == NULL || out == NULL || motions->R == NULL || motions->t == NULL
        || motions->omega == NULL || motions->v == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    for (pose = 0; pose < count; ++pose) {
        int code;
        load_pose(motions, pose, &one);
        code = stewart_exact_joint_inertia(model, &one, found);
        if (code == STEWART_OK) {
            copy_to(found, 36, pose, out);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}
