/* stewart_exact_forces.c: functions that are declared and described in stewart_exact_forces.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_exact_forces.h"

/* Number of poses of a block: one register of AVX-512. */
#if defined(STEWART_FLOAT)
#define POSES 16
#else
#define POSES 8
#endif
/* By default gcc uses half the width of AVX-512 and does not schedule instructions before register allocation,
 * which is slower with few registers. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__AVX512F__)
#pragma GCC target("prefer-vector-width=512")
#pragma GCC optimize("schedule-insns")
#endif

#include "stewart_lanes.h"

/* Motions of the poses of a block, component by component. */
typedef struct {
    stewart_real R[9][POSES];
    stewart_real t[3][POSES];
    stewart_real omega[3][POSES];
    stewart_real v[3][POSES];
    stewart_real alpha[3][POSES];
    stewart_real a[3][POSES];
    stewart_real F_ext[3][POSES];
    stewart_real M_ext[3][POSES];
} STEWART_ALIGNED motion_lanes;

/* Constants of one leg, and its contributions to the constants of the platform. */
static void prepare_leg(
    const stewart_robot *robot, const stewart_leg *leg, int i, stewart_exact_model *out,
    lumped_terms *added)
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
    const stewart_real p_1_x = robot->leg[0].p[0], p_1_y = robot->leg[0].p[1], p_1_z = robot->leg[0].p[2];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real k_size = STEWART_SQRT(k_x*k_x + k_y*k_y + k_z*k_z);
    const stewart_real inv_k_size = REAL(1)/k_size;
    /* fixed axis, of length one */
    const stewart_real k_unit_x = inv_k_size*k_x;
    const stewart_real k_unit_y = inv_k_size*k_y;
    const stewart_real k_unit_z = inv_k_size*k_z;
    const stewart_real c1 = m_u*r_u0_x;
    const stewart_real h_x = c1;
    const stewart_real c2 = m_u*r_u0_y;
    const stewart_real h_y = c2;
    const stewart_real h_z = m_u*r_u0_z;
    const stewart_real c3 = m_d*r_d0_x;
    const stewart_real w_x = c3 + h_x;
    const stewart_real c4 = m_d*r_d0_y;
    const stewart_real w_y = c4 + h_y;
    const stewart_real w_z = h_z + m_d*r_d0_z;
    const stewart_real c5 = r_d0_y*r_d0_y;
    const stewart_real c6 = r_d0_z*r_d0_z;
    const stewart_real c7 = r_u0_y*r_u0_y;
    const stewart_real c8 = r_u0_z*r_u0_z;
    const stewart_real J_xx = I_d0_xx + I_u0_xx + m_d*(c5 + c6) + m_u*(c7 + c8);
    const stewart_real J_xy = I_d0_xy + I_u0_xy - c1*r_u0_y - c3*r_d0_y;
    const stewart_real J_xz = I_d0_xz + I_u0_xz - c1*r_u0_z - c3*r_d0_z;
    const stewart_real c9 = r_d0_x*r_d0_x;
    const stewart_real c10 = r_u0_x*r_u0_x;
    const stewart_real J_yy = I_d0_yy + I_u0_yy + m_d*(c6 + c9) + m_u*(c10 + c8);
    const stewart_real J_yz = I_d0_yz + I_u0_yz - c2*r_u0_z - c4*r_d0_z;
    const stewart_real J_zz = I_d0_zz + I_u0_zz + m_d*(c5 + c9) + m_u*(c10 + c7);
    /* platform point from platform point 1 */
    const stewart_real arm_x = p_x - p_1_x;
    const stewart_real arm_y = p_y - p_1_y;
    const stewart_real arm_z = p_z - p_1_z;
    const stewart_real c11 = arm_x*m_u;
    const stewart_real c12 = arm_y*m_u;
    const stewart_real c13 = arm_y*arm_y;
    const stewart_real c14 = arm_z*arm_z;
    const stewart_real c15 = arm_x*arm_x;
    out->b[0][i] = b_x;
    out->b[1][i] = b_y;
    out->b[2][i] = b_z;
    out->p[0][i] = p_x;
    out->p[1][i] = p_y;
    out->p[2][i] = p_z;
    out->k[0][i] = k_unit_x;
    out->k[1][i] = k_unit_y;
    out->k[2][i] = k_unit_z;
    out->C_p[i] = C_p;
    out->C_s[i] = C_s;
    out->h[0][i] = h_x;
    out->h[1][i] = h_y;
    out->h[2][i] = h_z;
    out->h2_x[i] = REAL(2)*h_x;
    out->h2_y[i] = REAL(2)*h_y;
    out->h2_z[i] = REAL(2)*h_z;
    out->w[0][i] = w_x;
    out->w[1][i] = w_y;
    out->w[2][i] = w_z;
    out->J[0][i] = J_xx;
    out->J[1][i] = J_xy;
    out->J[2][i] = J_xz;
    out->J[3][i] = J_yy;
    out->J[4][i] = J_yz;
    out->J[5][i] = J_zz;
    out->J2_xz[i] = REAL(2)*J_xz;
    out->dJ_zx[i] = J_zz - J_xx;
    out->g_k[i] = g_x*k_unit_x + g_y*k_unit_y + g_z*k_unit_z;
    out->g_x_k[0][i] = g_y*k_unit_z - g_z*k_unit_y;
    out->g_x_k[1][i] = g_z*k_unit_x - g_x*k_unit_z;
    out->g_x_k[2][i] = g_x*k_unit_y - g_y*k_unit_x;
    out->C_us[i] = C_s + C_u;
    out->m_u[i] = m_u;
    added->M_add = m_u;
    added->h_add[0] = c11;
    added->h_add[1] = c12;
    added->h_add[2] = arm_z*m_u;
    added->J_add[0] = m_u*(c13 + c14);
    added->J_add[1] = -arm_y*c11;
    added->J_add[2] = -arm_z*c11;
    added->J_add[3] = m_u*(c14 + c15);
    added->J_add[4] = -arm_z*c12;
    added->J_add[5] = m_u*(c13 + c15);
    added->C_add = C_s;
}

/* Constants of the platform. */
static void prepare_platform(const stewart_robot *robot, const lumped_terms *sum, stewart_exact_model *out)
{
    const stewart_real M = robot->M;
    const stewart_real R_0_x = robot->R_0[0], R_0_y = robot->R_0[1], R_0_z = robot->R_0[2];
    const stewart_real I_p_xx = robot->I_p[0], I_p_xy = robot->I_p[1], I_p_xz = robot->I_p[2], I_p_yy = robot->I_p[3],
        I_p_yz = robot->I_p[4], I_p_zz = robot->I_p[5];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real p_1_x = robot->leg[0].p[0], p_1_y = robot->leg[0].p[1], p_1_z = robot->leg[0].p[2];
    const stewart_real M_add = sum->M_add;
    const stewart_real h_add_x = sum->h_add[0], h_add_y = sum->h_add[1], h_add_z = sum->h_add[2];
    const stewart_real J_add_xx = sum->J_add[0], J_add_xy = sum->J_add[1], J_add_xz = sum->J_add[2],
        J_add_yy = sum->J_add[3], J_add_yz = sum->J_add[4], J_add_zz = sum->J_add[5];
    const stewart_real C_add = sum->C_add;
    const stewart_real M_P = M + M_add;
    /* center of mass of the platform without the upper parts, from platform point 1 */
    const stewart_real arm_x = R_0_x - p_1_x;
    const stewart_real arm_y = R_0_y - p_1_y;
    const stewart_real arm_z = R_0_z - p_1_z;
    /* first moment of the lumped masses about this center */
    const stewart_real e_x = h_add_x - M_add*arm_x;
    const stewart_real e_y = h_add_y - M_add*arm_y;
    const stewart_real e_z = h_add_z - M_add*arm_z;
    /* first moment about the reference point */
    const stewart_real h_P_x = h_add_x + M*R_0_x + M_add*p_1_x;
    const stewart_real h_P_y = h_add_y + M*R_0_y + M_add*p_1_y;
    const stewart_real h_P_z = h_add_z + M*R_0_z + M_add*p_1_z;
    const stewart_real c1 = REAL(1)/M_P;
    const stewart_real r_C_x = c1*h_P_x;
    const stewart_real r_C_y = c1*h_P_y;
    const stewart_real r_C_z = c1*h_P_z;
    const stewart_real r_x = c1*h_add_x;
    const stewart_real r_y = c1*h_add_y;
    const stewart_real r_z = c1*h_add_z;
    const stewart_real c2 = STEWART_HALF*M*c1;
    const stewart_real u_x = c2*(h_add_x + e_x);
    const stewart_real u_y = c2*(h_add_y + e_y);
    const stewart_real u_z = c2*(h_add_z + e_z);
    const stewart_real c3 = h_add_z*r_z + REAL(2)*arm_z*u_z;
    const stewart_real c4 = h_add_y*r_y + REAL(2)*arm_y*u_y;
    const stewart_real J_C_xx = I_p_xx + J_add_xx - c3 - c4;
    const stewart_real J_C_xy = I_p_xy + J_add_xy + h_add_x*r_y + arm_x*u_y + arm_y*u_x;
    const stewart_real J_C_xz = I_p_xz + J_add_xz + h_add_x*r_z + arm_x*u_z + arm_z*u_x;
    const stewart_real c5 = h_add_x*r_x + REAL(2)*arm_x*u_x;
    const stewart_real J_C_yy = I_p_yy + J_add_yy - c3 - c5;
    const stewart_real J_C_yz = I_p_yz + J_add_yz + h_add_y*r_z + arm_y*u_z + arm_z*u_y;
    const stewart_real J_C_zz = I_p_zz + J_add_zz - c4 - c5;
    const stewart_real c7 = r_C_y*r_C_y;
    const stewart_real c8 = r_C_z*r_C_z;
    const stewart_real c9 = M_P*r_C_x;
    const stewart_real c10 = r_C_x*r_C_x;
    out->M_P = M_P;
    out->r_C[0] = r_C_x;
    out->r_C[1] = r_C_y;
    out->r_C[2] = r_C_z;
    out->J_C[0] = J_C_xx;
    out->J_C[1] = J_C_xy;
    out->J_C[2] = J_C_xz;
    out->J_C[3] = J_C_yy;
    out->J_C[4] = J_C_yz;
    out->J_C[5] = J_C_zz;
    out->dJ_C[0] = J_C_zz - J_C_yy;
    out->dJ_C[1] = J_C_xx - J_C_zz;
    out->dJ_C[2] = J_C_yy - J_C_xx;
    out->C_P = C_add;
    out->g[0] = g_x;
    out->g[1] = g_y;
    out->g[2] = g_z;
    out->M = M;
    out->R_0[0] = R_0_x;
    out->R_0[1] = R_0_y;
    out->R_0[2] = R_0_z;
    out->I_p[0] = I_p_xx;
    out->I_p[1] = I_p_xy;
    out->I_p[2] = I_p_xz;
    out->I_p[3] = I_p_yy;
    out->I_p[4] = I_p_yz;
    out->I_p[5] = I_p_zz;
    out->h_P[0] = h_P_x;
    out->h_P[1] = h_P_y;
    out->h_P[2] = h_P_z;
    out->J_P[0] = J_C_xx + M_P*(c7 + c8);
    out->J_P[1] = J_C_xy - c9*r_C_y;
    out->J_P[2] = J_C_xz - c9*r_C_z;
    out->J_P[3] = J_C_yy + M_P*(c10 + c8);
    out->J_P[4] = J_C_yz - M_P*r_C_y*r_C_z;
    out->J_P[5] = J_C_zz + M_P*(c10 + c7);
}

/* Returns the largest coordinate (m) of the arms of moments about platform point 1. */
static stewart_real size_of(const stewart_exact_model *model)
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

int stewart_exact_prepare(const stewart_robot *robot, stewart_exact_model *model)
{
    int i, j;
    stewart_exact_model made;
    lumped_terms added;
    lumped_terms sum;
    if (robot == NULL || model == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    clear_lumped(&sum);
    for (i = 0; i < LANES; ++i) {
        prepare_leg(robot, &robot->leg[i < 6 ? i : 5], i, &made, &added);
        if (i < 6) {
            add_lumped(&sum, &added);
        }
    }
    prepare_platform(robot, &sum, &made);
    stewart_real far = REAL(0);
    for (j = 0; j < 3; ++j) {
        for (i = 0; i < 6; ++i) {
            far = STEWART_LARGER(STEWART_FABS(made.b[j][i]), far);
        }
    }
    made.base_reach = far;
    const stewart_real largest = size_of(&made);
    made.per_length = per_length_of(largest, REAL(0.125));
    made.arm_cube = cube_of(largest*made.per_length);
    const stewart_real *const numbers = (const stewart_real *)&made;
    for (i = 0; i < 311; ++i) {
        if (!(STEWART_FABS(numbers[i]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    *model = made;
    return STEWART_OK;
}

typedef struct {
    stewart_real L[LANES];
    stewart_real S_x[LANES];
    stewart_real S_y[LANES];
    stewart_real S_z[LANES];
    stewart_real inv_L[LANES];
    stewart_real inv_rho[LANES];
    stewart_real k_cross_S_x[LANES];
    stewart_real k_cross_S_y[LANES];
    stewart_real k_cross_S_z[LANES];
    stewart_real q[3][LANES];
    stewart_real rho[LANES];
    stewart_real zeta[LANES];
} STEWART_ALIGNED leg_roots_pose;

typedef struct {
    stewart_real B[9];
    stewart_real c_force[3];
    stewart_real c_moment[3];
    stewart_real least_L;
} STEWART_ALIGNED shared_terms_pose;

typedef struct {
    stewart_real D[LANES];
    stewart_real c_force[3][LANES];
    stewart_real c_moment[3][LANES];
    stewart_real k3[LANES];
    stewart_real unfit_2[LANES];
} STEWART_ALIGNED leg_terms_pose;

typedef struct {
    stewart_real any_unfit;
    stewart_real is_short;
} STEWART_ALIGNED legs_fit_pose;

typedef struct {
    stewart_real reach[LANES];
} STEWART_ALIGNED reach_of_legs_pose;

typedef struct {
    stewart_real near_6;
} STEWART_ALIGNED examination_pose;

typedef struct {
    stewart_real c_tip[3];
    stewart_real q_1_x;
    stewart_real q_1_y;
    stewart_real q_1_z;
} STEWART_ALIGNED tip_terms_pose;

typedef struct {
    stewart_real arm_c[3][LANES];
} STEWART_ALIGNED moment_terms_pose;

typedef struct {
    stewart_real doubtful;
    stewart_real weak;
} STEWART_ALIGNED results_pose;

typedef struct {
    stewart_real F[6];
} STEWART_ALIGNED forces_pose;

typedef struct {
    stewart_real reach_2[LANES];
} STEWART_ALIGNED reach_of_rows_pose;

/* Computes a leg up to its square roots: 46 (22 mul, 20 add, 2 div, 2 sqrt). */
STEWART_APART static void compute_leg_roots_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    leg_roots_pose *STEWART_RESTRICT leg_roots)
{
    int l;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
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
        const stewart_real rho2 = STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y,
            k_cross_S_y, k_cross_S_x*k_cross_S_x));
        /* (2) leg length, and distance of the tip from the fixed axis */
        const stewart_real L = STEWART_SQRT(STEWART_FMA(zeta, zeta, rho2));
        const stewart_real rho = STEWART_SQRT(rho2);
        const stewart_real inv_L = REAL(1)/L;
        const stewart_real inv_rho = REAL(1)/rho;
        leg_roots->q[0][l] = q_x;
        leg_roots->q[1][l] = q_y;
        leg_roots->q[2][l] = q_z;
        leg_roots->S_x[l] = S_x;
        leg_roots->S_y[l] = S_y;
        leg_roots->S_z[l] = S_z;
        leg_roots->zeta[l] = zeta;
        leg_roots->k_cross_S_x[l] = k_cross_S_x;
        leg_roots->k_cross_S_y[l] = k_cross_S_y;
        leg_roots->k_cross_S_z[l] = k_cross_S_z;
        leg_roots->L[l] = L;
        leg_roots->rho[l] = rho;
        leg_roots->inv_L[l] = inv_L;
        leg_roots->inv_rho[l] = inv_rho;
    }
}

/* Computes terms of a pose that are common to all legs: 180 (93 mul, 87 add, 0 div, 0 sqrt). */
static void compute_shared_terms_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    shared_terms_pose *STEWART_RESTRICT shared_terms)
{
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real alpha_z = at->alpha[2], alpha_y = at->alpha[1], alpha_x = at->alpha[0];
    const stewart_real R_xx = at->R[0];
    const stewart_real r_C_x = model->r_C[0];
    const stewart_real R_xy = at->R[1];
    const stewart_real r_C_y = model->r_C[1];
    const stewart_real R_xz = at->R[2];
    const stewart_real r_C_z = model->r_C[2];
    const stewart_real R_yx = at->R[3], R_yy = at->R[4], R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7],
        R_zz = at->R[8];
    const stewart_real M_P = model->M_P;
    const stewart_real g_x = model->g[0];
    const stewart_real a_x = at->a[0];
    const stewart_real g_y = model->g[1];
    const stewart_real a_y = at->a[1];
    const stewart_real g_z = model->g[2];
    const stewart_real a_z = at->a[2];
    const stewart_real M_ext_x = at->M_ext[0];
    const stewart_real J_C_yz = model->J_C[4], J_C_xx = model->J_C[0];
    const stewart_real dJ_C_x = model->dJ_C[0];
    const stewart_real J_C_xy = model->J_C[1], J_C_xz = model->J_C[2];
    const stewart_real M_ext_y = at->M_ext[1];
    const stewart_real J_C_yy = model->J_C[3];
    const stewart_real dJ_C_y = model->dJ_C[1];
    const stewart_real M_ext_z = at->M_ext[2];
    const stewart_real J_C_zz = model->J_C[5];
    const stewart_real dJ_C_z = model->dJ_C[2];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real C_P = model->C_P;
    const stewart_real t_z = at->t[2], t_y = at->t[1], t_x = at->t[0];
    const stewart_real base_reach = model->base_reach;
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
    shared_terms->c_force[0] = STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy, STEWART_FMA(F_ext_x,
        R_xx, N_x)));
    shared_terms->c_force[1] = STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy, STEWART_FMA(F_ext_x,
        R_yx, N_y)));
    shared_terms->c_force[2] = STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy, STEWART_FMA(F_ext_x,
        R_zx, N_z)));
    shared_terms->c_moment[0] = STEWART_FMA(-N_y, R_C_z, STEWART_FMA(-C_P, omega_x, STEWART_FMA(N_z, R_C_y,
        STEWART_FMA(M_P_load_z, R_xz, STEWART_FMA(M_P_load_y, R_xy, M_P_load_x*R_xx)))));
    shared_terms->c_moment[1] = STEWART_FMA(-N_z, R_C_x, STEWART_FMA(-C_P, omega_y, STEWART_FMA(N_x, R_C_z,
        STEWART_FMA(M_P_load_z, R_yz, STEWART_FMA(M_P_load_y, R_yy, M_P_load_x*R_yx)))));
    shared_terms->c_moment[2] = STEWART_FMA(-N_x, R_C_y, STEWART_FMA(-C_P, omega_z, STEWART_FMA(N_y, R_C_x,
        STEWART_FMA(M_P_load_z, R_zz, STEWART_FMA(M_P_load_y, R_zy, M_P_load_x*R_zx)))));
    shared_terms->least_L = REAL(2.25)*STEWART_SHORT_SHARE*STEWART_LARGER(STEWART_FABS(t_z),
        STEWART_LARGER(STEWART_FABS(t_y), STEWART_LARGER(STEWART_FABS(t_x), STEWART_LARGER(base_reach,
        STEWART_SHORTEST/STEWART_ROUNDING))));
    shared_terms->B[0] = B_xx;
    shared_terms->B[1] = B_xy;
    shared_terms->B[2] = B_xz;
    shared_terms->B[3] = B_yx;
    shared_terms->B[4] = B_yy;
    shared_terms->B[5] = B_yz;
    shared_terms->B[6] = B_zx;
    shared_terms->B[7] = B_zy;
    shared_terms->B[8] = B_zz;
}

/* Computes a leg: its D, its column of H, and its part of c: 219 (134 mul, 85 add, 0 div, 0 sqrt). */
STEWART_APART static void compute_leg_terms_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const leg_roots_pose *STEWART_RESTRICT leg_roots,
    const shared_terms_pose *STEWART_RESTRICT shared_terms, columns_pose *STEWART_RESTRICT columns,
    leg_terms_pose *STEWART_RESTRICT leg_terms)
{
    int l;
    const stewart_real v_x = at->v[0];
    const stewart_real omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_y = at->v[1];
    const stewart_real omega_x = at->omega[0];
    const stewart_real v_z = at->v[2];
    const stewart_real a_x = at->a[0];
    const stewart_real B_xx = shared_terms->B[0], B_xy = shared_terms->B[1], B_xz = shared_terms->B[2];
    const stewart_real a_y = at->a[1];
    const stewart_real B_yx = shared_terms->B[3], B_yy = shared_terms->B[4], B_yz = shared_terms->B[5];
    const stewart_real a_z = at->a[2];
    const stewart_real B_zx = shared_terms->B[6], B_zy = shared_terms->B[7], B_zz = shared_terms->B[8];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    const stewart_real least_L = shared_terms->least_L;
    for (l = 0; l < LANES; ++l) {
        const stewart_real S_x = leg_roots->S_x[l];
        const stewart_real inv_L = leg_roots->inv_L[l];
        const stewart_real S_y = leg_roots->S_y[l];
        const stewart_real S_z = leg_roots->S_z[l];
        const stewart_real inv_rho = leg_roots->inv_rho[l];
        const stewart_real k_cross_S_x = leg_roots->k_cross_S_x[l];
        const stewart_real k_cross_S_y = leg_roots->k_cross_S_y[l];
        const stewart_real k_cross_S_z = leg_roots->k_cross_S_z[l];
        const stewart_real zeta = leg_roots->zeta[l];
        const stewart_real rho = leg_roots->rho[l];
        const stewart_real q_z = leg_roots->q[2][l], q_y = leg_roots->q[1][l], q_x = leg_roots->q[0][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real L = leg_roots->L[l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real dJ_zx = model->dJ_zx[l];
        const stewart_real J2_xz = model->J2_xz[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real J_xy = model->J[1][l];
        const stewart_real h_y = model->h[1][l];
        const stewart_real J_xx = model->J[0][l], J_yy = model->J[3][l], J_yz = model->J[4][l];
        const stewart_real h_x = model->h[0][l], h_z = model->h[2][l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l], g_x_k_z = model->g_x_k[2][l];
        const stewart_real w_z = model->w[2][l], w_x = model->w[0][l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real C_us = model->C_us[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real w_y = model->w[1][l];
        const stewart_real h2_y = model->h2_y[l];
        const stewart_real C_p = model->C_p[l];
        /* (3) unit vector along the leg */
        const stewart_real s_x = S_x*inv_L;
        const stewart_real s_y = S_y*inv_L;
        const stewart_real s_z = S_z*inv_L;
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
        const stewart_real S_dot_x = STEWART_FMA(omega_z, -q_y, STEWART_FMA(omega_y, q_z, v_x));
        const stewart_real S_dot_y = STEWART_FMA(omega_x, -q_z, STEWART_FMA(omega_z, q_x, v_y));
        const stewart_real S_dot_z = STEWART_FMA(omega_y, -q_x, STEWART_FMA(omega_x, q_y, v_z));
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
        const stewart_real phi_dot = inv_rho*STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y,
            S_dot_x*y_x));
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
        const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y,
            STEWART_FMA(S_ddot_x, s_x, L*STEWART_FMA(k33, phi_dot2, theta_dot2))));
        /* (9) accelerations of the joint coordinates */
        const stewart_real theta_ddot = STEWART_FMA(-theta_dot, L_share + rho_share,
            inv_rho*STEWART_FMA(-S_ddot_z, k_z, STEWART_FMA(-S_ddot_y, k_y, STEWART_FMA(-S_ddot_x, k_x,
            L_ddot*k1))));
        const stewart_real phi_ddot = STEWART_FMA(-rho_share, two_phi_dot, inv_rho*STEWART_FMA(S_ddot_z,
            y_z, STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)));
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
        const stewart_real bend = L_dot*theta_dot;
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
        /* (20) generalized forces about y and about k */
        const stewart_real tau_y = STEWART_FMA(M_theta, theta_ddot, STEWART_FMA(M_mixed, phi_ddot,
            STEWART_FMA(bend, h2_x, STEWART_FMA(-M_phi_theta, phi_dot2, STEWART_FMA(-C_s,
            STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x)), STEWART_FMA(C_us, theta_dot,
            STEWART_FMA(gamma_n, w_k, STEWART_FMA(g_k, w_n, L_ddot*h_z))))))));
        const stewart_real tau_k = STEWART_FMA(M_mixed, theta_ddot, STEWART_FMA(M_phi, phi_ddot,
            STEWART_FMA(bend*h2_y, -k1, STEWART_FMA(two_phi_dot, STEWART_FMA(M_phi_theta, theta_dot,
            L_dot*M_phi_L), STEWART_FMA(-gamma_y, w_n, STEWART_FMA(-gamma_n, w_y, STEWART_FMA(C_us, phi_dot,
            STEWART_FMA(-L_ddot, k3_h, STEWART_FMA(-C_s, STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y,
            k_x*omega_x)), M_mixed_theta*theta_dot2)))))))));
        /* (21) K = Q_k k + Q_y y, with a component along s */
        const stewart_real Q_k = -inv_rho*tau_y;
        const stewart_real Q_y = inv_rho*tau_k;
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x = STEWART_FMA(Q_k, k_x, Q_y*y_x);
        const stewart_real K_y = STEWART_FMA(Q_k, k_y, Q_y*y_y);
        const stewart_real K_z = STEWART_FMA(Q_k, k_z, Q_y*y_z);
        /* (24) known part of the actuator force for this K */
        leg_terms->D[l] = STEWART_FMA(-Q_k, k1, STEWART_FMA(-k3_h, phi_ddot, STEWART_FMA(h_z, theta_ddot,
            STEWART_FMA(-M_phi_L, phi_dot2, STEWART_FMA(-h_x, theta_dot2, C_p*L_dot)))));
        const stewart_real c1 = C_s*phi_dot;
        const stewart_real c2 = C_s*theta_dot;
        leg_terms->c_force[0][l] = -K_x;
        leg_terms->c_force[1][l] = -K_y;
        leg_terms->c_force[2][l] = -K_z;
        leg_terms->c_moment[0][l] = STEWART_FMA(c2, y_x, c1*k_x);
        leg_terms->c_moment[1][l] = STEWART_FMA(c2, y_y, c1*k_y);
        leg_terms->c_moment[2][l] = STEWART_FMA(c2, y_z, c1*k_z);
        const stewart_real unfit = L > least_L ? REAL(0) : REAL(1);
        leg_terms->unfit_2[l] = k3 > STEWART_NEAR_JOINT_SINGULAR ? unfit : REAL(1);
        columns->H[0][l] = s_x;
        columns->H[1][l] = s_y;
        columns->H[2][l] = s_z;
        leg_terms->k3[l] = k3;
    }
}

/* Marks a pose in which a leg must be examined. */
static void compute_legs_fit_pose(
    const leg_terms_pose *STEWART_RESTRICT leg_terms, legs_fit_pose *STEWART_RESTRICT legs_fit)
{
    legs_fit->any_unfit = STEWART_LARGER(STEWART_LARGER(STEWART_LARGER(STEWART_LARGER(STEWART_LARGER(STEWART_LARGER(REAL(0),
        leg_terms->unfit_2[0]), leg_terms->unfit_2[1]), leg_terms->unfit_2[2]), leg_terms->unfit_2[3]),
        leg_terms->unfit_2[4]), leg_terms->unfit_2[5]);
    legs_fit->is_short = REAL(0);
}

/* Computes the largest component (m) of the vectors whose sum is a leg. */
STEWART_APART static void compute_reach_of_legs_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const leg_roots_pose *STEWART_RESTRICT leg_roots, reach_of_legs_pose *STEWART_RESTRICT reach_of_legs)
{
    int l;
    const stewart_real t_z = at->t[2], t_y = at->t[1], t_x = at->t[0];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_z = model->b[2][l], b_y = model->b[1][l], b_x = model->b[0][l];
        const stewart_real q_z = leg_roots->q[2][l], q_y = leg_roots->q[1][l], q_x = leg_roots->q[0][l];
        reach_of_legs->reach[l] = STEWART_LARGER(STEWART_FABS(b_z), STEWART_LARGER(STEWART_FABS(b_y),
            STEWART_LARGER(STEWART_FABS(b_x), STEWART_LARGER(STEWART_FABS(t_z),
            STEWART_LARGER(STEWART_FABS(t_y), STEWART_LARGER(STEWART_FABS(t_x),
            STEWART_LARGER(STEWART_FABS(q_z), STEWART_LARGER(STEWART_FABS(q_y),
            STEWART_LARGER(STEWART_FABS(q_x), STEWART_SHORTEST/STEWART_ROUNDING)))))))));
    }
}

/* Marks a pose with a short leg or a leg near its joint singularity. */
STEWART_APART static void compute_examination_pose(
    const leg_roots_pose *STEWART_RESTRICT leg_roots,
    const reach_of_legs_pose *STEWART_RESTRICT reach_of_legs,
    const leg_terms_pose *STEWART_RESTRICT leg_terms, legs_fit_pose *STEWART_RESTRICT legs_fit,
    examination_pose *STEWART_RESTRICT examination)
{
    const stewart_real leg_is_short = leg_roots->L[0] > STEWART_SHORT_SHARE*reach_of_legs->reach[0] ? REAL(0)
        : REAL(1);
    const stewart_real near = leg_terms->k3[0] > STEWART_NEAR_JOINT_SINGULAR ? REAL(0) : REAL(1);
    const stewart_real leg_is_short_2 = leg_roots->L[1] > STEWART_SHORT_SHARE*reach_of_legs->reach[1] ? leg_is_short
        : REAL(1);
    const stewart_real near_2 = leg_terms->k3[1] > STEWART_NEAR_JOINT_SINGULAR ? near : REAL(1);
    const stewart_real leg_is_short_3 = leg_roots->L[2] > STEWART_SHORT_SHARE*reach_of_legs->reach[2] ? leg_is_short_2
        : REAL(1);
    const stewart_real near_3 = leg_terms->k3[2] > STEWART_NEAR_JOINT_SINGULAR ? near_2 : REAL(1);
    const stewart_real leg_is_short_4 = leg_roots->L[3] > STEWART_SHORT_SHARE*reach_of_legs->reach[3] ? leg_is_short_3
        : REAL(1);
    const stewart_real near_4 = leg_terms->k3[3] > STEWART_NEAR_JOINT_SINGULAR ? near_3 : REAL(1);
    const stewart_real leg_is_short_5 = leg_roots->L[4] > STEWART_SHORT_SHARE*reach_of_legs->reach[4] ? leg_is_short_4
        : REAL(1);
    const stewart_real near_5 = leg_terms->k3[4] > STEWART_NEAR_JOINT_SINGULAR ? near_4 : REAL(1);
    legs_fit->is_short = leg_roots->L[5] > STEWART_SHORT_SHARE*reach_of_legs->reach[5] ? leg_is_short_5 : REAL(1);
    examination->near_6 = leg_terms->k3[5] > STEWART_NEAR_JOINT_SINGULAR ? near_5 : REAL(1);
}

/* Computes a leg near its joint singularity: 289 (173 mul, 112 add, 2 div, 2 sqrt). */
STEWART_APART static void compute_leg_near_singular_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const shared_terms_pose *STEWART_RESTRICT shared_terms, leg_roots_pose *STEWART_RESTRICT leg_roots,
    columns_pose *STEWART_RESTRICT columns, leg_terms_pose *STEWART_RESTRICT leg_terms)
{
    int l;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real v_x = at->v[0];
    const stewart_real omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_y = at->v[1];
    const stewart_real omega_x = at->omega[0];
    const stewart_real v_z = at->v[2];
    const stewart_real a_x = at->a[0];
    const stewart_real B_xx = shared_terms->B[0], B_xy = shared_terms->B[1], B_xz = shared_terms->B[2];
    const stewart_real a_y = at->a[1];
    const stewart_real B_yx = shared_terms->B[3], B_yy = shared_terms->B[4], B_yz = shared_terms->B[5];
    const stewart_real a_z = at->a[2];
    const stewart_real B_zx = shared_terms->B[6], B_zy = shared_terms->B[7], B_zz = shared_terms->B[8];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real dJ_zx = model->dJ_zx[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real J2_xz = model->J2_xz[l];
        const stewart_real J_xy = model->J[1][l];
        const stewart_real h_y = model->h[1][l];
        const stewart_real J_xx = model->J[0][l], J_yy = model->J[3][l], J_yz = model->J[4][l];
        const stewart_real h_x = model->h[0][l], h_z = model->h[2][l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l], g_x_k_z = model->g_x_k[2][l];
        const stewart_real w_z = model->w[2][l], w_x = model->w[0][l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real C_us = model->C_us[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real w_y = model->w[1][l];
        const stewart_real h2_y = model->h2_y[l];
        const stewart_real C_p = model->C_p[l];
        /* (1) platform point from the reference point */
        const stewart_real q_x_2 = STEWART_FMA(R_xz, p_z, STEWART_FMA(R_xy, p_y, R_xx*p_x));
        const stewart_real q_y_2 = STEWART_FMA(R_yz, p_z, STEWART_FMA(R_yy, p_y, R_yx*p_x));
        const stewart_real q_z_2 = STEWART_FMA(R_zz, p_z, STEWART_FMA(R_zy, p_y, R_zx*p_x));
        /* (1) reference point from base point, base frame */
        const stewart_real t_b_x_2 = t_x - b_x;
        const stewart_real t_b_y_2 = t_y - b_y;
        const stewart_real t_b_z_2 = t_z - b_z;
        /* (1) leg vector */
        const stewart_real S_x_2 = t_b_x_2 + q_x_2;
        const stewart_real S_y_2 = t_b_y_2 + q_y_2;
        const stewart_real S_z_2 = t_b_z_2 + q_z_2;
        /* (10) component of the leg vector along the fixed axis, and normal to both */
        const stewart_real zeta_2 = STEWART_FMA(S_z_2, k_z, STEWART_FMA(S_y_2, k_y, S_x_2*k_x));
        const stewart_real k_cross_S_x_2 = STEWART_FMA(-S_y_2, k_z, S_z_2*k_y);
        const stewart_real k_cross_S_y_2 = STEWART_FMA(-S_z_2, k_x, S_x_2*k_z);
        const stewart_real k_cross_S_z_2 = STEWART_FMA(-S_x_2, k_y, S_y_2*k_x);
        /* (2) leg length, and distance of the tip from the fixed axis */
        const stewart_real L_2 = STEWART_SQRT(STEWART_FMA(S_z_2, S_z_2, STEWART_FMA(S_y_2, S_y_2,
            S_x_2*S_x_2)));
        const stewart_real inv_L_2 = REAL(1)/L_2;
        /* (3) unit vector along the leg */
        const stewart_real s_x_2 = S_x_2*inv_L_2;
        const stewart_real s_y_2 = S_y_2*inv_L_2;
        const stewart_real s_z_2 = S_z_2*inv_L_2;
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_S_y_2, s_z_2, k_cross_S_z_2*s_y_2);
        const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_S_z_2, s_x_2, k_cross_S_x_2*s_z_2);
        const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_S_x_2, s_y_2, k_cross_S_y_2*s_x_2);
        /* (10) leg length, and distance of the tip from the fixed axis */
        const stewart_real rho_2 = STEWART_SQRT(STEWART_FMA(s_cross_normal_z, s_cross_normal_z,
            STEWART_FMA(s_cross_normal_y, s_cross_normal_y, s_cross_normal_x*s_cross_normal_x)));
        const stewart_real inv_rho_2 = REAL(1)/rho_2;
        /* (10) third axis of the leg frame */
        const stewart_real z_x = inv_rho_2*s_cross_normal_x;
        const stewart_real z_y = inv_rho_2*s_cross_normal_y;
        const stewart_real z_z = inv_rho_2*s_cross_normal_z;
        /* (10) rotating axis of the universal joint */
        const stewart_real y_x_2 = STEWART_FMA(-s_y_2, z_z, s_z_2*z_y);
        const stewart_real y_y_2 = STEWART_FMA(-s_z_2, z_x, s_x_2*z_z);
        const stewart_real y_z_2 = STEWART_FMA(-s_x_2, z_y, s_y_2*z_x);
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1_2 = inv_L_2*zeta_2;
        const stewart_real k3_2 = inv_L_2*rho_2;
        /* (10) k1 / k3 */
        const stewart_real kappa_2 = inv_rho_2*zeta_2;
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x_2 = STEWART_FMA(omega_z, -q_y_2, STEWART_FMA(omega_y, q_z_2, v_x));
        const stewart_real S_dot_y_2 = STEWART_FMA(omega_x, -q_z_2, STEWART_FMA(omega_z, q_x_2, v_y));
        const stewart_real S_dot_z_2 = STEWART_FMA(omega_y, -q_x_2, STEWART_FMA(omega_x, q_y_2, v_z));
        /* (7) acceleration of the platform point */
        const stewart_real S_ddot_x_2 = STEWART_FMA(B_xz, q_z_2, STEWART_FMA(B_xy, q_y_2, STEWART_FMA(B_xx,
            q_x_2, a_x)));
        const stewart_real S_ddot_y_2 = STEWART_FMA(B_yz, q_z_2, STEWART_FMA(B_yy, q_y_2, STEWART_FMA(B_yx,
            q_x_2, a_y)));
        const stewart_real S_ddot_z_2 = STEWART_FMA(B_zz, q_z_2, STEWART_FMA(B_zy, q_y_2, STEWART_FMA(B_zx,
            q_x_2, a_z)));
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot_2 = STEWART_FMA(S_dot_z_2, s_z_2, STEWART_FMA(S_dot_y_2, s_y_2,
            S_dot_x_2*s_x_2));
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot_2 = inv_rho_2*STEWART_FMA(S_dot_z_2, y_z_2, STEWART_FMA(S_dot_y_2, y_y_2,
            S_dot_x_2*y_x_2));
        const stewart_real theta_dot_2 = -inv_L_2*STEWART_FMA(S_dot_z_2, z_z, STEWART_FMA(S_dot_y_2, z_y,
            S_dot_x_2*z_x));
        /* L_dot / L */
        const stewart_real L_share_2 = L_dot_2*inv_L_2;
        const stewart_real lean_2 = kappa_2*theta_dot_2;
        const stewart_real theta_dot2_2 = theta_dot_2*theta_dot_2;
        const stewart_real phi_dot2_2 = phi_dot_2*phi_dot_2;
        const stewart_real two_phi_dot_2 = REAL(2)*phi_dot_2;
        const stewart_real k33_2 = k3_2*k3_2;
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot_2 = STEWART_FMA(S_ddot_z_2, s_z_2, STEWART_FMA(S_ddot_y_2, s_y_2,
            STEWART_FMA(S_ddot_x_2, s_x_2, L_2*STEWART_FMA(k33_2, phi_dot2_2, theta_dot2_2))));
        /* (9) accelerations of the joint coordinates without the rotation of the leg frame about s */
        const stewart_real own_theta_ddot = STEWART_FMA(REAL(2)*L_share_2, -theta_dot_2,
            -inv_L_2*STEWART_FMA(S_ddot_z_2, z_z, STEWART_FMA(S_ddot_y_2, z_y, S_ddot_x_2*z_x)));
        const stewart_real own_phi_ddot = STEWART_FMA(-L_share_2, two_phi_dot_2,
            inv_rho_2*STEWART_FMA(S_ddot_z_2, y_z_2, STEWART_FMA(S_ddot_y_2, y_y_2, S_ddot_x_2*y_x_2)));
        const stewart_real c1_2 = k1_2*k3_2;
        /* (9) accelerations of the joint coordinates */
        const stewart_real theta_ddot_2 = STEWART_FMA(c1_2, phi_dot2_2, own_theta_ddot);
        const stewart_real phi_ddot_2 = STEWART_FMA(-lean_2, two_phi_dot_2, own_phi_ddot);
        const stewart_real k13_2 = c1_2;
        const stewart_real L_h2_2 = L_2*h2_x;
        const stewart_real a1_2 = dJ_zx + L_h2_2;
        const stewart_real c2_2 = L_2*h2_z;
        const stewart_real c3 = J2_xz - c2_2;
        const stewart_real a2_2 = c3;
        const stewart_real a3_2 = STEWART_FMA(-L_2, h_y, J_xy);
        /* (19) inertia of the joint coordinates */
        const stewart_real M_phi_2 = STEWART_FMA(a2_2, k13_2, STEWART_FMA(a1_2, k33_2, J_xx));
        const stewart_real M_theta_2 = J_yy + L_h2_2;
        const stewart_real M_mixed_2 = STEWART_FMA(a3_2, k1_2, J_yz*k3_2);
        const stewart_real k3_h_2 = h_y*k3_2;
        /* (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta */
        const stewart_real M_phi_L_2 = STEWART_FMA(-h_z, k13_2, h_x*k33_2);
        const stewart_real M_mixed_theta_2 = STEWART_FMA(-a3_2, k3_2, J_yz*k1_2);
        const stewart_real bend_2 = L_dot_2*theta_dot_2;
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n_2 = STEWART_FMA(g_x_k_z, y_z_2, STEWART_FMA(g_x_k_y, y_y_2,
            g_x_k_x*y_x_2));
        const stewart_real gamma_y_2 = STEWART_FMA(g_z, y_z_2, STEWART_FMA(g_y, y_y_2, g_x*y_x_2));
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k_2 = STEWART_FMA(k1_2, w_x, k3_2*w_z);
        const stewart_real w_n_2 = STEWART_FMA(-k1_2, w_z, k3_2*w_x);
        /* (20) generalized forces about y and about k */
        const stewart_real tau_y_2 = STEWART_FMA(M_mixed_2, phi_ddot_2, STEWART_FMA(M_theta_2,
            own_theta_ddot, STEWART_FMA(-C_s, STEWART_FMA(omega_z, y_z_2, STEWART_FMA(omega_y, y_y_2,
            omega_x*y_x_2)), STEWART_FMA(gamma_n_2, w_k_2, STEWART_FMA(bend_2, h2_x, STEWART_FMA(C_us,
            theta_dot_2, STEWART_FMA(phi_dot2_2, STEWART_FMA(-c3, STEWART_HALF - k33_2, k13_2*(J_yy - dJ_zx)),
            STEWART_FMA(g_k, w_n_2, L_ddot_2*h_z))))))));
        const stewart_real tau_k_2 = STEWART_FMA(M_phi_2, own_phi_ddot, STEWART_FMA(M_mixed_2, theta_ddot_2,
            STEWART_FMA(bend_2*h2_y, -k1_2, STEWART_FMA(two_phi_dot_2, STEWART_FMA(-theta_dot_2,
            STEWART_FMA(J_xx, kappa_2, STEWART_FMA(STEWART_HALF, -c2_2, STEWART_HALF*J2_xz)),
            L_dot_2*M_phi_L_2), STEWART_FMA(-gamma_y_2, w_n_2, STEWART_FMA(-gamma_n_2, w_y,
            STEWART_FMA(C_us, phi_dot_2, STEWART_FMA(-L_ddot_2, k3_h_2, STEWART_FMA(-C_s, STEWART_FMA(k_z,
            omega_z, STEWART_FMA(k_y, omega_y, k_x*omega_x)), M_mixed_theta_2*theta_dot2_2)))))))));
        /* (21) K = Q_y y + Q_z z */
        const stewart_real Q_y_2 = inv_rho_2*tau_k_2;
        const stewart_real Q_z = -inv_L_2*tau_y_2;
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x_2 = STEWART_FMA(Q_z, z_x, Q_y_2*y_x_2);
        const stewart_real K_y_2 = STEWART_FMA(Q_z, z_y, Q_y_2*y_y_2);
        const stewart_real K_z_2 = STEWART_FMA(Q_z, z_z, Q_y_2*y_z_2);
        /* (24) known part of the actuator force for this K */
        leg_terms->D[l] = STEWART_FMA(-k3_h_2, phi_ddot_2, STEWART_FMA(h_z, theta_ddot_2,
            STEWART_FMA(-M_phi_L_2, phi_dot2_2, STEWART_FMA(-h_x, theta_dot2_2, C_p*L_dot_2))));
        const stewart_real c4 = C_s*phi_dot_2;
        const stewart_real c5 = C_s*theta_dot_2;
        leg_terms->c_force[0][l] = -K_x_2;
        leg_terms->c_force[1][l] = -K_y_2;
        leg_terms->c_force[2][l] = -K_z_2;
        leg_terms->c_moment[0][l] = STEWART_FMA(c5, y_x_2, c4*k_x);
        leg_terms->c_moment[1][l] = STEWART_FMA(c5, y_y_2, c4*k_y);
        leg_terms->c_moment[2][l] = STEWART_FMA(c5, y_z_2, c4*k_z);
        leg_roots->q[0][l] = q_x_2;
        leg_roots->q[1][l] = q_y_2;
        leg_roots->q[2][l] = q_z_2;
        leg_roots->L[l] = L_2;
        columns->H[0][l] = s_x_2;
        columns->H[1][l] = s_y_2;
        columns->H[2][l] = s_z_2;
        leg_terms->k3[l] = k3_2;
    }
}

/* Computes the platform's part of c about platform point 1: 12 (6 mul, 6 add, 0 div, 0 sqrt). */
static void compute_tip_terms_pose(
    const leg_roots_pose *STEWART_RESTRICT leg_roots,
    const shared_terms_pose *STEWART_RESTRICT shared_terms, tip_terms_pose *STEWART_RESTRICT tip_terms)
{
    const stewart_real c_moment_x = shared_terms->c_moment[0];
    const stewart_real c_force_y = shared_terms->c_force[1], c_force_z = shared_terms->c_force[2];
    const stewart_real c_moment_y = shared_terms->c_moment[1];
    const stewart_real c_force_x = shared_terms->c_force[0];
    const stewart_real c_moment_z = shared_terms->c_moment[2];
    const stewart_real q_1_x = leg_roots->q[0][0], q_1_y = leg_roots->q[1][0], q_1_z = leg_roots->q[2][0];
    tip_terms->c_tip[0] = STEWART_FMA(-c_force_z, q_1_y, STEWART_FMA(c_force_y, q_1_z, c_moment_x));
    tip_terms->c_tip[1] = STEWART_FMA(-c_force_x, q_1_z, STEWART_FMA(c_force_z, q_1_x, c_moment_y));
    tip_terms->c_tip[2] = STEWART_FMA(-c_force_y, q_1_x, STEWART_FMA(c_force_x, q_1_y, c_moment_z));
    tip_terms->q_1_x = q_1_x;
    tip_terms->q_1_y = q_1_y;
    tip_terms->q_1_z = q_1_z;
}

/* Computes the moments of a leg about platform point 1: 21 (12 mul, 9 add, 0 div, 0 sqrt). */
static void compute_moment_terms_pose(
    const leg_roots_pose *STEWART_RESTRICT leg_roots, const tip_terms_pose *STEWART_RESTRICT tip_terms,
    columns_pose *STEWART_RESTRICT columns, const leg_terms_pose *STEWART_RESTRICT leg_terms,
    moment_terms_pose *STEWART_RESTRICT moment_terms)
{
    int l;
    const stewart_real q_1_x = tip_terms->q_1_x;
    const stewart_real q_1_y = tip_terms->q_1_y;
    const stewart_real q_1_z = tip_terms->q_1_z;
    for (l = 0; l < LANES; ++l) {
        const stewart_real q_x = leg_roots->q[0][l], q_y = leg_roots->q[1][l], q_z = leg_roots->q[2][l];
        const stewart_real s_z = columns->H[2][l], s_y = columns->H[1][l], s_x = columns->H[0][l];
        const stewart_real c_force_z_2 = leg_terms->c_force[2][l], c_force_y_2 = leg_terms->c_force[1][l],
            c_force_x_2 = leg_terms->c_force[0][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - q_1_x;
        const stewart_real arm_y = q_y - q_1_y;
        const stewart_real arm_z = q_z - q_1_z;
        columns->H[3][l] = STEWART_FMA(-s_y, arm_z, s_z*arm_y);
        columns->H[4][l] = STEWART_FMA(-s_z, arm_x, s_x*arm_z);
        columns->H[5][l] = STEWART_FMA(-s_x, arm_y, s_y*arm_x);
        moment_terms->arm_c[0][l] = STEWART_FMA(-arm_z, c_force_y_2, arm_y*c_force_z_2);
        moment_terms->arm_c[1][l] = STEWART_FMA(-arm_x, c_force_z_2, arm_z*c_force_x_2);
        moment_terms->arm_c[2][l] = STEWART_FMA(-arm_y, c_force_x_2, arm_x*c_force_y_2);
    }
}

/* Adds the parts of c of the platform and the legs. */
static void compute_wrench_pose(
    const shared_terms_pose *STEWART_RESTRICT shared_terms,
    const leg_terms_pose *STEWART_RESTRICT leg_terms, const tip_terms_pose *STEWART_RESTRICT tip_terms,
    const moment_terms_pose *STEWART_RESTRICT moment_terms, right_side_pose *STEWART_RESTRICT right_side)
{
    const stewart_real c_force_x = shared_terms->c_force[0], c_force_y = shared_terms->c_force[1], c_force_z = shared_terms->c_force[2];
    const stewart_real c_tip_x = tip_terms->c_tip[0], c_tip_y = tip_terms->c_tip[1], c_tip_z = tip_terms->c_tip[2];
    right_side->c[0] = c_force_x + leg_terms->c_force[0][0] + leg_terms->c_force[0][1] + leg_terms->c_force[0][2]
        + leg_terms->c_force[0][3] + leg_terms->c_force[0][4] + leg_terms->c_force[0][5];
    right_side->c[1] = c_force_y + leg_terms->c_force[1][0] + leg_terms->c_force[1][1] + leg_terms->c_force[1][2]
        + leg_terms->c_force[1][3] + leg_terms->c_force[1][4] + leg_terms->c_force[1][5];
    right_side->c[2] = c_force_z + leg_terms->c_force[2][0] + leg_terms->c_force[2][1] + leg_terms->c_force[2][2]
        + leg_terms->c_force[2][3] + leg_terms->c_force[2][4] + leg_terms->c_force[2][5];
    right_side->c[3] = c_tip_x + leg_terms->c_moment[0][0] + leg_terms->c_moment[0][1] + moment_terms->arm_c[0][1]
        + leg_terms->c_moment[0][2] + moment_terms->arm_c[0][2] + leg_terms->c_moment[0][3] + moment_terms->arm_c[0][3]
        + leg_terms->c_moment[0][4] + moment_terms->arm_c[0][4] + leg_terms->c_moment[0][5] + moment_terms->arm_c[0][5];
    right_side->c[4] = c_tip_y + leg_terms->c_moment[1][0] + leg_terms->c_moment[1][1] + moment_terms->arm_c[1][1]
        + leg_terms->c_moment[1][2] + moment_terms->arm_c[1][2] + leg_terms->c_moment[1][3] + moment_terms->arm_c[1][3]
        + leg_terms->c_moment[1][4] + moment_terms->arm_c[1][4] + leg_terms->c_moment[1][5] + moment_terms->arm_c[1][5];
    right_side->c[5] = c_tip_z + leg_terms->c_moment[2][0] + leg_terms->c_moment[2][1] + moment_terms->arm_c[2][1]
        + leg_terms->c_moment[2][2] + moment_terms->arm_c[2][2] + leg_terms->c_moment[2][3] + moment_terms->arm_c[2][3]
        + leg_terms->c_moment[2][4] + moment_terms->arm_c[2][4] + leg_terms->c_moment[2][5] + moment_terms->arm_c[2][5];
}

/* Multiplies the moments of a leg by `per_length`. */
STEWART_APART static void compute_scaled_moments_pose(
    const stewart_exact_model *STEWART_RESTRICT model, columns_pose *STEWART_RESTRICT columns)
{
    int l;
    const stewart_real per_length = model->per_length;
    for (l = 0; l < LANES; ++l) {
        const stewart_real H_moment_x = columns->H[3][l], H_moment_y = columns->H[4][l], H_moment_z = columns->H[5][l];
        columns->H[3][l] = H_moment_x*per_length;
        columns->H[4][l] = H_moment_y*per_length;
        columns->H[5][l] = H_moment_z*per_length;
    }
}

/* Multiplies the moments of c by `per_length`. */
STEWART_APART static void compute_scaled_wrench_pose(
    const stewart_exact_model *STEWART_RESTRICT model, right_side_pose *STEWART_RESTRICT right_side)
{
    const stewart_real c_3 = right_side->c[3];
    const stewart_real per_length = model->per_length;
    const stewart_real c_4 = right_side->c[4], c_5 = right_side->c[5];
    right_side->c[3] = c_3*per_length;
    right_side->c[4] = c_4*per_length;
    right_side->c[5] = c_5*per_length;
}

/* Solves H x = c for x in two blocks of three legs, (36). Sets `weak` if the blocks are too inaccurate,
 * so that pivots are required. */
static void compute_results_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const columns_pose *STEWART_RESTRICT columns,
    const right_side_pose *STEWART_RESTRICT right_side, const leg_terms_pose *STEWART_RESTRICT leg_terms,
    const legs_fit_pose *STEWART_RESTRICT legs_fit, results_pose *STEWART_RESTRICT results,
    forces_pose *STEWART_RESTRICT forces)
{
    int l;
    const stewart_real c_0 = right_side->c[0], c_1 = right_side->c[1], c_2 = right_side->c[2], c_3 = right_side->c[3],
        c_4 = right_side->c[4], c_5 = right_side->c[5];
    const stewart_real arm_cube = model->arm_cube;
    const stewart_real is_short = legs_fit->is_short;
    const stewart_real r_0_0 = STEWART_FMA(columns->H[2][3], -columns->H[1][5],
        columns->H[1][3]*columns->H[2][5]);
    const stewart_real r_0_1 = STEWART_FMA(columns->H[0][3], -columns->H[2][5],
        columns->H[2][3]*columns->H[0][5]);
    const stewart_real r_0_2 = STEWART_FMA(columns->H[1][3], -columns->H[0][5],
        columns->H[0][3]*columns->H[1][5]);
    const stewart_real r_1_0 = STEWART_FMA(columns->H[2][5], -columns->H[1][1],
        columns->H[1][5]*columns->H[2][1]);
    const stewart_real r_1_1 = STEWART_FMA(columns->H[0][5], -columns->H[2][1],
        columns->H[2][5]*columns->H[0][1]);
    const stewart_real r_1_2 = STEWART_FMA(columns->H[1][5], -columns->H[0][1],
        columns->H[0][5]*columns->H[1][1]);
    const stewart_real r_2_0 = STEWART_FMA(columns->H[2][1], -columns->H[1][3],
        columns->H[1][1]*columns->H[2][3]);
    const stewart_real r_2_1 = STEWART_FMA(columns->H[0][1], -columns->H[2][3],
        columns->H[2][1]*columns->H[0][3]);
    const stewart_real r_2_2 = STEWART_FMA(columns->H[1][1], -columns->H[0][3],
        columns->H[0][1]*columns->H[1][3]);
    const stewart_real det = STEWART_FMA(columns->H[2][1], r_0_2, STEWART_FMA(columns->H[1][1], r_0_1,
        columns->H[0][1]*r_0_0));
    stewart_real e_0_of[LANES];
    stewart_real e_1_of[LANES];
    stewart_real e_2_of[LANES];
    stewart_real w_0_of[LANES];
    stewart_real w_1_of[LANES];
    stewart_real w_2_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real s_x = columns->H[0][l], s_y = columns->H[1][l], s_z = columns->H[2][l],
            H_moment_x = columns->H[3][l], H_moment_y = columns->H[4][l], H_moment_z = columns->H[5][l];
        const stewart_real e_0 = STEWART_FMA(r_0_2, s_z, STEWART_FMA(r_0_1, s_y, r_0_0*s_x));
        const stewart_real e_1 = STEWART_FMA(r_1_2, s_z, STEWART_FMA(r_1_1, s_y, r_1_0*s_x));
        const stewart_real e_2 = STEWART_FMA(r_2_2, s_z, STEWART_FMA(r_2_1, s_y, r_2_0*s_x));
        const stewart_real w_0 = STEWART_FMA(columns->H[3][5], -e_2, STEWART_FMA(columns->H[3][3], -e_1,
            STEWART_FMA(columns->H[3][1], -e_0, det*H_moment_x)));
        const stewart_real w_1 = STEWART_FMA(columns->H[4][5], -e_2, STEWART_FMA(columns->H[4][3], -e_1,
            STEWART_FMA(columns->H[4][1], -e_0, det*H_moment_y)));
        const stewart_real w_2 = STEWART_FMA(columns->H[5][5], -e_2, STEWART_FMA(columns->H[5][3], -e_1,
            STEWART_FMA(columns->H[5][1], -e_0, det*H_moment_z)));
        e_0_of[l] = e_0;
        e_1_of[l] = e_1;
        e_2_of[l] = e_2;
        w_0_of[l] = w_0;
        w_1_of[l] = w_1;
        w_2_of[l] = w_2;
    }
    const stewart_real e_c_0 = STEWART_FMA(r_0_2, c_2, STEWART_FMA(r_0_1, c_1, r_0_0*c_0));
    const stewart_real e_c_1 = STEWART_FMA(r_1_2, c_2, STEWART_FMA(r_1_1, c_1, r_1_0*c_0));
    const stewart_real e_c_2 = STEWART_FMA(r_2_2, c_2, STEWART_FMA(r_2_1, c_1, r_2_0*c_0));
    const stewart_real w_c_0 = STEWART_FMA(columns->H[3][5], -e_c_2, STEWART_FMA(columns->H[3][3], -e_c_1,
        STEWART_FMA(columns->H[3][1], -e_c_0, det*c_3)));
    const stewart_real w_c_1 = STEWART_FMA(columns->H[4][5], -e_c_2, STEWART_FMA(columns->H[4][3], -e_c_1,
        STEWART_FMA(columns->H[4][1], -e_c_0, det*c_4)));
    const stewart_real w_c_2 = STEWART_FMA(columns->H[5][5], -e_c_2, STEWART_FMA(columns->H[5][3], -e_c_1,
        STEWART_FMA(columns->H[5][1], -e_c_0, det*c_5)));
    const stewart_real u_0_0 = STEWART_FMA(w_2_of[2], -w_1_of[4], w_1_of[2]*w_2_of[4]);
    const stewart_real u_0_1 = STEWART_FMA(w_0_of[2], -w_2_of[4], w_2_of[2]*w_0_of[4]);
    const stewart_real u_0_2 = STEWART_FMA(w_1_of[2], -w_0_of[4], w_0_of[2]*w_1_of[4]);
    const stewart_real u_1_0 = STEWART_FMA(w_2_of[4], -w_1_of[0], w_1_of[4]*w_2_of[0]);
    const stewart_real u_1_1 = STEWART_FMA(w_0_of[4], -w_2_of[0], w_2_of[4]*w_0_of[0]);
    const stewart_real u_1_2 = STEWART_FMA(w_1_of[4], -w_0_of[0], w_0_of[4]*w_1_of[0]);
    const stewart_real u_2_0 = STEWART_FMA(w_2_of[0], -w_1_of[2], w_1_of[0]*w_2_of[2]);
    const stewart_real u_2_1 = STEWART_FMA(w_0_of[0], -w_2_of[2], w_2_of[0]*w_0_of[2]);
    const stewart_real u_2_2 = STEWART_FMA(w_1_of[0], -w_0_of[2], w_0_of[0]*w_1_of[2]);
    const stewart_real complement = STEWART_FMA(w_2_of[0], u_0_2, STEWART_FMA(w_1_of[0], u_0_1,
        w_0_of[0]*u_0_0));
    const stewart_real det2 = det*det;
    const stewart_real least = STEWART_LARGER(STEWART_FABS(det)*STEWART_BLOCK_LEAST,
        STEWART_BLOCK_SINGULAR)*(det2*arm_cube);
    const stewart_real grown = STEWART_FMA(e_0_of[4], e_0_of[4], STEWART_FMA(e_0_of[2], e_0_of[2],
        e_0_of[0]*e_0_of[0])) + STEWART_FMA(e_1_of[4], e_1_of[4], STEWART_FMA(e_1_of[2], e_1_of[2],
        e_1_of[0]*e_1_of[0])) + STEWART_FMA(e_2_of[4], e_2_of[4], STEWART_FMA(e_2_of[2], e_2_of[2],
        e_2_of[0]*e_2_of[0])) > STEWART_BLOCK_GROWTH*det2 ? REAL(1) : REAL(0);
    results->weak = STEWART_FABS(complement) <= least ? REAL(1) : grown;
    const stewart_real inverse_det = REAL(1)/det;
    const stewart_real inverse_complement = REAL(1)/complement;
    const stewart_real x_0 = STEWART_FMA(u_0_2, w_c_2, STEWART_FMA(u_0_1, w_c_1,
        u_0_0*w_c_0))*inverse_complement;
    const stewart_real x_2 = STEWART_FMA(u_1_2, w_c_2, STEWART_FMA(u_1_1, w_c_1,
        u_1_0*w_c_0))*inverse_complement;
    const stewart_real x_4 = STEWART_FMA(u_2_2, w_c_2, STEWART_FMA(u_2_1, w_c_1,
        u_2_0*w_c_0))*inverse_complement;
    const stewart_real x_1 = STEWART_FMA(e_0_of[4], -x_4, STEWART_FMA(e_0_of[2], -x_2,
        STEWART_FMA(e_0_of[0], -x_0, e_c_0)))*inverse_det;
    const stewart_real x_3 = STEWART_FMA(e_1_of[4], -x_4, STEWART_FMA(e_1_of[2], -x_2,
        STEWART_FMA(e_1_of[0], -x_0, e_c_1)))*inverse_det;
    const stewart_real x_5 = STEWART_FMA(e_2_of[4], -x_4, STEWART_FMA(e_2_of[2], -x_2,
        STEWART_FMA(e_2_of[0], -x_0, e_c_2)))*inverse_det;
    forces->F[0] = leg_terms->D[0] - x_0;
    forces->F[1] = leg_terms->D[1] - x_1;
    forces->F[2] = leg_terms->D[2] - x_2;
    forces->F[3] = leg_terms->D[3] - x_3;
    forces->F[4] = leg_terms->D[4] - x_4;
    forces->F[5] = leg_terms->D[5] - x_5;
    results->doubtful = is_short > REAL(0) ? REAL(1) : REAL(0);
}

/* Computes the results again. */
STEWART_APART static void compute_results_of_pivots_pose(
    const leg_terms_pose *STEWART_RESTRICT leg_terms, const solution_pose *STEWART_RESTRICT solution,
    const legs_fit_pose *STEWART_RESTRICT legs_fit, forces_pose *STEWART_RESTRICT forces,
    results_pose *STEWART_RESTRICT results)
{
    const stewart_real x_0_2 = solution->x[0], x_1_2 = solution->x[1], x_2_2 = solution->x[2], x_3_2 = solution->x[3],
        x_4_2 = solution->x[4], x_5_2 = solution->x[5];
    const stewart_real is_short = legs_fit->is_short;
    const stewart_real suspect = solution->suspect;
    forces->F[0] = leg_terms->D[0] - x_0_2;
    forces->F[1] = leg_terms->D[1] - x_1_2;
    forces->F[2] = leg_terms->D[2] - x_2_2;
    forces->F[3] = leg_terms->D[3] - x_3_2;
    forces->F[4] = leg_terms->D[4] - x_4_2;
    forces->F[5] = leg_terms->D[5] - x_5_2;
    results->doubtful = is_short > REAL(0) ? REAL(1) : suspect;
}

/* Computes the largest component (m) of the vectors whose sum is a leg. */
STEWART_APART static void compute_reach_of_rows_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const leg_roots_pose *STEWART_RESTRICT leg_roots, reach_of_rows_pose *STEWART_RESTRICT reach_of_rows)
{
    int l;
    const stewart_real t_z = at->t[2], t_y = at->t[1], t_x = at->t[0];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_z = model->b[2][l], b_y = model->b[1][l], b_x = model->b[0][l];
        const stewart_real q_z = leg_roots->q[2][l], q_y = leg_roots->q[1][l], q_x = leg_roots->q[0][l];
        reach_of_rows->reach_2[l] = STEWART_LARGER(STEWART_FABS(b_z), STEWART_LARGER(STEWART_FABS(b_y),
            STEWART_LARGER(STEWART_FABS(b_x), STEWART_LARGER(STEWART_FABS(t_z),
            STEWART_LARGER(STEWART_FABS(t_y), STEWART_LARGER(STEWART_FABS(t_x),
            STEWART_LARGER(STEWART_FABS(q_z), STEWART_LARGER(STEWART_FABS(q_y),
            STEWART_LARGER(STEWART_FABS(q_x), STEWART_SHORTEST/STEWART_ROUNDING)))))))));
    }
}

int stewart_exact_forces(const stewart_exact_model *model, const stewart_motion *motion, stewart_real F[6])
{
    int i;
    leg_roots_pose leg_roots;
    shared_terms_pose shared_terms;
    columns_pose columns;
    leg_terms_pose leg_terms;
    legs_fit_pose legs_fit;
    reach_of_legs_pose reach_of_legs;
    examination_pose examination;
    tip_terms_pose tip_terms;
    moment_terms_pose moment_terms;
    right_side_pose right_side;
    results_pose results;
    forces_pose forces;
    solution_pose solution;
    reach_of_rows_pose reach_of_rows;
    int status = STEWART_OK;
    if (model == NULL || motion == NULL || F == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    compute_leg_roots_pose(model, motion, &leg_roots);
    compute_shared_terms_pose(model, motion, &shared_terms);
    compute_leg_terms_pose(model, motion, &leg_roots, &shared_terms, &columns, &leg_terms);
    compute_legs_fit_pose(&leg_terms, &legs_fit);
    if (legs_fit.any_unfit > REAL(0)) {
        compute_reach_of_legs_pose(model, motion, &leg_roots, &reach_of_legs);
        status = fault_of(leg_roots.L[0], leg_terms.k3[0], reach_of_legs.reach[0]);
        if (status != STEWART_OK) {
            return status;
        }
        status = fault_of(leg_roots.L[1], leg_terms.k3[1], reach_of_legs.reach[1]);
        if (status != STEWART_OK) {
            return status;
        }
        status = fault_of(leg_roots.L[2], leg_terms.k3[2], reach_of_legs.reach[2]);
        if (status != STEWART_OK) {
            return status;
        }
        status = fault_of(leg_roots.L[3], leg_terms.k3[3], reach_of_legs.reach[3]);
        if (status != STEWART_OK) {
            return status;
        }
        status = fault_of(leg_roots.L[4], leg_terms.k3[4], reach_of_legs.reach[4]);
        if (status != STEWART_OK) {
            return status;
        }
        status = fault_of(leg_roots.L[5], leg_terms.k3[5], reach_of_legs.reach[5]);
        if (status != STEWART_OK) {
            return status;
        }
        compute_examination_pose(&leg_roots, &reach_of_legs, &leg_terms, &legs_fit, &examination);
        if (examination.near_6 > REAL(0)) {
            compute_leg_near_singular_pose(model, motion, &shared_terms, &leg_roots, &columns, &leg_terms);
        }
    }
    compute_tip_terms_pose(&leg_roots, &shared_terms, &tip_terms);
    compute_moment_terms_pose(&leg_roots, &tip_terms, &columns, &leg_terms, &moment_terms);
    compute_wrench_pose(&shared_terms, &leg_terms, &tip_terms, &moment_terms, &right_side);
    if (model->per_length != REAL(1)) {
        compute_scaled_moments_pose(model, &columns);
        compute_scaled_wrench_pose(model, &right_side);
    }
    compute_results_pose(model, &columns, &right_side, &leg_terms, &legs_fit, &results, &forces);
    if (results.weak > REAL(0)) {
        compute_pivots_pose(&columns, &right_side, &solution);
        compute_results_of_pivots_pose(&leg_terms, &solution, &legs_fit, &forces, &results);
    }
    if (results.doubtful > REAL(0)) {
        compute_reach_of_rows_pose(model, motion, &leg_roots, &reach_of_rows);
        status = rows_status(columns.H, leg_roots.q, leg_roots.L, reach_of_rows.reach_2, model->per_length);
        if (status != STEWART_OK) {
            return status;
        }
    }
    for (i = 0; i < 6; ++i) {
        if (!(STEWART_FABS(forces.F[i]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    for (i = 0; i < 6; ++i) {
        F[i] = forces.F[i];
    }
    return STEWART_OK;
}

typedef struct {
    stewart_real L[POSES];
    stewart_real S_x[POSES];
    stewart_real S_y[POSES];
    stewart_real S_z[POSES];
    stewart_real inv_L[POSES];
    stewart_real inv_rho[POSES];
    stewart_real k_cross_S_x[POSES];
    stewart_real k_cross_S_y[POSES];
    stewart_real k_cross_S_z[POSES];
    stewart_real q[3][POSES];
    stewart_real rho[POSES];
    stewart_real zeta[POSES];
} STEWART_ALIGNED leg_roots_block;

typedef struct {
    stewart_real B[9][POSES];
    stewart_real c_force[3][POSES];
    stewart_real c_moment[3][POSES];
    stewart_real least_L[POSES];
} STEWART_ALIGNED shared_terms_block;

typedef struct {
    stewart_real any_unfit[POSES];
} STEWART_ALIGNED legs_fit_block;

typedef struct {
    stewart_real D[POSES];
} STEWART_ALIGNED leg_terms_block;

typedef struct {
    stewart_real c_force[3][POSES];
    stewart_real c_moment[3][POSES];
} STEWART_ALIGNED leg_terms_now_block;

typedef struct {
    stewart_real q_1_x[POSES];
    stewart_real q_1_y[POSES];
    stewart_real q_1_z[POSES];
} STEWART_ALIGNED tip_terms_block;

typedef struct {
    stewart_real weak[POSES];
} STEWART_ALIGNED results_block;

typedef struct {
    stewart_real F[6][POSES];
    stewart_real unfinished[POSES];
} STEWART_ALIGNED forces_block;

/* Computes a leg up to its square roots: 46 (22 mul, 20 add, 2 div, 2 sqrt). */
STEWART_APART static void compute_leg_roots_block(
    const stewart_exact_model *STEWART_RESTRICT model, const motion_lanes *STEWART_RESTRICT at, int leg,
    leg_roots_block *STEWART_RESTRICT leg_roots)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real p_x = model->p[0][leg], p_y = model->p[1][leg], p_z = model->p[2][leg];
        /* (1) platform point from the reference point */
        const stewart_real q_x = STEWART_FMA(R_xz, p_z, STEWART_FMA(R_xy, p_y, R_xx*p_x));
        const stewart_real q_y = STEWART_FMA(R_yz, p_z, STEWART_FMA(R_yy, p_y, R_yx*p_x));
        const stewart_real q_z = STEWART_FMA(R_zz, p_z, STEWART_FMA(R_zy, p_y, R_zx*p_x));
        const stewart_real t_x = at->t[0][l], t_y = at->t[1][l], t_z = at->t[2][l];
        const stewart_real b_x = model->b[0][leg], b_y = model->b[1][leg], b_z = model->b[2][leg];
        /* (1) reference point from base point, base frame */
        const stewart_real t_b_x = t_x - b_x;
        const stewart_real t_b_y = t_y - b_y;
        const stewart_real t_b_z = t_z - b_z;
        /* (1) leg vector */
        const stewart_real S_x = t_b_x + q_x;
        const stewart_real S_y = t_b_y + q_y;
        const stewart_real S_z = t_b_z + q_z;
        const stewart_real k_x = model->k[0][leg], k_y = model->k[1][leg], k_z = model->k[2][leg];
        /* (10) component of the leg vector along the fixed axis, and normal to both */
        const stewart_real zeta = STEWART_FMA(S_z, k_z, STEWART_FMA(S_y, k_y, S_x*k_x));
        const stewart_real k_cross_S_x = STEWART_FMA(-S_y, k_z, S_z*k_y);
        const stewart_real k_cross_S_y = STEWART_FMA(-S_z, k_x, S_x*k_z);
        const stewart_real k_cross_S_z = STEWART_FMA(-S_x, k_y, S_y*k_x);
        const stewart_real rho2 = STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y,
            k_cross_S_y, k_cross_S_x*k_cross_S_x));
        /* (2) leg length, and distance of the tip from the fixed axis */
        const stewart_real L = STEWART_SQRT(STEWART_FMA(zeta, zeta, rho2));
        const stewart_real rho = STEWART_SQRT(rho2);
        const stewart_real inv_L = REAL(1)/L;
        const stewart_real inv_rho = REAL(1)/rho;
        leg_roots->q[0][l] = q_x;
        leg_roots->q[1][l] = q_y;
        leg_roots->q[2][l] = q_z;
        leg_roots->S_x[l] = S_x;
        leg_roots->S_y[l] = S_y;
        leg_roots->S_z[l] = S_z;
        leg_roots->zeta[l] = zeta;
        leg_roots->k_cross_S_x[l] = k_cross_S_x;
        leg_roots->k_cross_S_y[l] = k_cross_S_y;
        leg_roots->k_cross_S_z[l] = k_cross_S_z;
        leg_roots->L[l] = L;
        leg_roots->rho[l] = rho;
        leg_roots->inv_L[l] = inv_L;
        leg_roots->inv_rho[l] = inv_rho;
    }
}

/* Computes terms of a pose that are common to all legs: 180 (93 mul, 87 add, 0 div, 0 sqrt). */
static void compute_shared_terms_block(
    const stewart_exact_model *STEWART_RESTRICT model, const motion_lanes *STEWART_RESTRICT at,
    shared_terms_block *STEWART_RESTRICT shared_terms)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
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
        const stewart_real alpha_z = at->alpha[2][l], alpha_y = at->alpha[1][l], alpha_x = at->alpha[0][l];
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
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real r_C_x = model->r_C[0], r_C_y = model->r_C[1], r_C_z = model->r_C[2];
        /* (30) center of mass from the reference point, base frame */
        const stewart_real R_C_x = STEWART_FMA(R_xz, r_C_z, STEWART_FMA(R_xy, r_C_y, R_xx*r_C_x));
        const stewart_real R_C_y = STEWART_FMA(R_yz, r_C_z, STEWART_FMA(R_yy, r_C_y, R_yx*r_C_x));
        const stewart_real R_C_z = STEWART_FMA(R_zz, r_C_z, STEWART_FMA(R_zy, r_C_y, R_zx*r_C_x));
        const stewart_real M_P = model->M_P;
        const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
        const stewart_real a_x = at->a[0][l], a_y = at->a[1][l], a_z = at->a[2][l];
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
        const stewart_real M_ext_x = at->M_ext[0][l], M_ext_y = at->M_ext[1][l], M_ext_z = at->M_ext[2][l];
        const stewart_real J_C_yz = model->J_C[4], J_C_xx = model->J_C[0], J_C_xy = model->J_C[1], J_C_xz = model->J_C[2],
            J_C_yy = model->J_C[3], J_C_zz = model->J_C[5];
        const stewart_real dJ_C_x = model->dJ_C[0], dJ_C_y = model->dJ_C[1], dJ_C_z = model->dJ_C[2];
        const stewart_real F_ext_x = at->F_ext[0][l], F_ext_y = at->F_ext[1][l], F_ext_z = at->F_ext[2][l];
        const stewart_real C_P = model->C_P;
        const stewart_real t_z = at->t[2][l], t_y = at->t[1][l], t_x = at->t[0][l];
        const stewart_real base_reach = model->base_reach;
        /* (34) external moment less I alpha + omega x I omega, platform frame */
        const stewart_real M_P_load_x = STEWART_FMA(J_C_xz, -STEWART_FMA_OF(P_xy, omega_P_x, omega_P_y,
            alpha_P_z), STEWART_FMA(J_C_xy, STEWART_FMA_OF(P_xz, omega_P_x, omega_P_z, -alpha_P_y),
            STEWART_FMA(-P_yz, dJ_C_x, STEWART_FMA(J_C_xx, -alpha_P_x, STEWART_FMA(J_C_yz,
            -STEWART_FMA_OF(-P_zz, -omega_P_z, omega_P_z, P_yy), M_ext_x)))));
        const stewart_real M_P_load_y = STEWART_FMA(J_C_xy, -STEWART_FMA_OF(P_yz, omega_P_y, omega_P_z,
            alpha_P_x), STEWART_FMA(J_C_yz, STEWART_FMA_OF(P_xy, omega_P_x, omega_P_y, -alpha_P_z),
            STEWART_FMA(-P_xz, dJ_C_y, STEWART_FMA(J_C_yy, -alpha_P_y, STEWART_FMA(J_C_xz,
            -STEWART_FMA_OF(-P_xx, -omega_P_x, omega_P_x, P_zz), M_ext_y)))));
        const stewart_real M_P_load_z = STEWART_FMA(J_C_yz, -STEWART_FMA_OF(P_xz, omega_P_x, omega_P_z,
            alpha_P_y), STEWART_FMA(J_C_xz, STEWART_FMA_OF(P_yz, omega_P_y, omega_P_z, -alpha_P_x),
            STEWART_FMA(-P_xy, dJ_C_z, STEWART_FMA(J_C_zz, -alpha_P_z, STEWART_FMA(J_C_xy,
            -STEWART_FMA_OF(-P_yy, -omega_P_y, omega_P_y, P_xx), M_ext_z)))));
        shared_terms->c_force[0][l] = STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy,
            STEWART_FMA(F_ext_x, R_xx, N_x)));
        shared_terms->c_force[1][l] = STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy,
            STEWART_FMA(F_ext_x, R_yx, N_y)));
        shared_terms->c_force[2][l] = STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy,
            STEWART_FMA(F_ext_x, R_zx, N_z)));
        shared_terms->c_moment[0][l] = STEWART_FMA(-N_y, R_C_z, STEWART_FMA(C_P, -omega_x, STEWART_FMA(N_z,
            R_C_y, STEWART_FMA(M_P_load_z, R_xz, STEWART_FMA(M_P_load_y, R_xy, M_P_load_x*R_xx)))));
        shared_terms->c_moment[1][l] = STEWART_FMA(-N_z, R_C_x, STEWART_FMA(C_P, -omega_y, STEWART_FMA(N_x,
            R_C_z, STEWART_FMA(M_P_load_z, R_yz, STEWART_FMA(M_P_load_y, R_yy, M_P_load_x*R_yx)))));
        shared_terms->c_moment[2][l] = STEWART_FMA(-N_x, R_C_y, STEWART_FMA(C_P, -omega_z, STEWART_FMA(N_y,
            R_C_x, STEWART_FMA(M_P_load_z, R_zz, STEWART_FMA(M_P_load_y, R_zy, M_P_load_x*R_zx)))));
        shared_terms->least_L[l] = REAL(2.25)*STEWART_SHORT_SHARE*STEWART_LARGER(STEWART_FABS(t_z),
            STEWART_LARGER(STEWART_FABS(t_y), STEWART_LARGER(STEWART_FABS(t_x), STEWART_LARGER(base_reach,
            STEWART_SHORTEST/STEWART_ROUNDING))));
        shared_terms->B[0][l] = B_xx;
        shared_terms->B[1][l] = B_xy;
        shared_terms->B[2][l] = B_xz;
        shared_terms->B[3][l] = B_yx;
        shared_terms->B[4][l] = B_yy;
        shared_terms->B[5][l] = B_yz;
        shared_terms->B[6][l] = B_zx;
        shared_terms->B[7][l] = B_zy;
        shared_terms->B[8][l] = B_zz;
    }
}

/* Marks a pose in which a leg must be examined. */
static void compute_legs_fit_block(legs_fit_block *STEWART_RESTRICT legs_fit)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        legs_fit->any_unfit[l] = REAL(0);
    }
}

/* Computes a leg: its D, its column of H, and its part of c: 219 (134 mul, 85 add, 0 div, 0 sqrt). */
static void compute_leg_terms_block(
    const stewart_exact_model *STEWART_RESTRICT model, const motion_lanes *STEWART_RESTRICT at, int leg,
    const leg_roots_block *STEWART_RESTRICT leg_roots,
    const shared_terms_block *STEWART_RESTRICT shared_terms, legs_fit_block *STEWART_RESTRICT legs_fit,
    columns_block *STEWART_RESTRICT columns, leg_terms_block *STEWART_RESTRICT leg_terms,
    leg_terms_now_block *STEWART_RESTRICT leg_terms_now)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real S_x = leg_roots->S_x[l];
        const stewart_real inv_L = leg_roots->inv_L[l];
        const stewart_real S_y = leg_roots->S_y[l];
        const stewart_real S_z = leg_roots->S_z[l];
        /* (3) unit vector along the leg */
        const stewart_real s_x = S_x*inv_L;
        const stewart_real s_y = S_y*inv_L;
        const stewart_real s_z = S_z*inv_L;
        const stewart_real inv_rho = leg_roots->inv_rho[l];
        const stewart_real k_cross_S_x = leg_roots->k_cross_S_x[l];
        const stewart_real k_cross_S_y = leg_roots->k_cross_S_y[l];
        const stewart_real k_cross_S_z = leg_roots->k_cross_S_z[l];
        /* (10) second axis of the leg frame */
        const stewart_real y_x = inv_rho*k_cross_S_x;
        const stewart_real y_y = inv_rho*k_cross_S_y;
        const stewart_real y_z = inv_rho*k_cross_S_z;
        const stewart_real zeta = leg_roots->zeta[l];
        const stewart_real rho = leg_roots->rho[l];
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1 = inv_L*zeta;
        const stewart_real k3 = inv_L*rho;
        /* (10) k1 / k3 */
        const stewart_real kappa = inv_rho*zeta;
        const stewart_real v_x = at->v[0][l], v_y = at->v[1][l], v_z = at->v[2][l];
        const stewart_real omega_y = at->omega[1][l], omega_z = at->omega[2][l], omega_x = at->omega[0][l];
        const stewart_real q_z = leg_roots->q[2][l], q_y = leg_roots->q[1][l], q_x = leg_roots->q[0][l];
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = STEWART_FMA(-omega_z, q_y, STEWART_FMA(omega_y, q_z, v_x));
        const stewart_real S_dot_y = STEWART_FMA(-omega_x, q_z, STEWART_FMA(omega_z, q_x, v_y));
        const stewart_real S_dot_z = STEWART_FMA(-omega_y, q_x, STEWART_FMA(omega_x, q_y, v_z));
        const stewart_real a_x = at->a[0][l], a_y = at->a[1][l], a_z = at->a[2][l];
        const stewart_real B_xx = shared_terms->B[0][l], B_xy = shared_terms->B[1][l], B_xz = shared_terms->B[2][l],
            B_yx = shared_terms->B[3][l], B_yy = shared_terms->B[4][l], B_yz = shared_terms->B[5][l], B_zx = shared_terms->B[6][l],
            B_zy = shared_terms->B[7][l], B_zz = shared_terms->B[8][l];
        /* (7) acceleration of the platform point */
        const stewart_real S_ddot_x = STEWART_FMA(B_xz, q_z, STEWART_FMA(B_xy, q_y, STEWART_FMA(B_xx, q_x,
            a_x)));
        const stewart_real S_ddot_y = STEWART_FMA(B_yz, q_z, STEWART_FMA(B_yy, q_y, STEWART_FMA(B_yx, q_x,
            a_y)));
        const stewart_real S_ddot_z = STEWART_FMA(B_zz, q_z, STEWART_FMA(B_zy, q_y, STEWART_FMA(B_zx, q_x,
            a_z)));
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
        const stewart_real k_x = model->k[0][leg], k_y = model->k[1][leg], k_z = model->k[2][leg];
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = inv_rho*STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y,
            S_dot_x*y_x));
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
        const stewart_real L = leg_roots->L[l];
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y,
            STEWART_FMA(S_ddot_x, s_x, L*STEWART_FMA(k33, phi_dot2, theta_dot2))));
        const stewart_real h2_x = model->h2_x[leg];
        const stewart_real dJ_zx = model->dJ_zx[leg];
        const stewart_real J2_xz = model->J2_xz[leg];
        const stewart_real h2_z = model->h2_z[leg];
        const stewart_real J_xy = model->J[1][leg], J_xx = model->J[0][leg], J_yy = model->J[3][leg], J_yz = model->J[4][leg];
        const stewart_real h_y = model->h[1][leg], h_x = model->h[0][leg], h_z = model->h[2][leg];
        /* (9) accelerations of the joint coordinates */
        const stewart_real theta_ddot = STEWART_FMA(-theta_dot, L_share + rho_share,
            inv_rho*STEWART_FMA(-S_ddot_z, k_z, STEWART_FMA(-S_ddot_y, k_y, STEWART_FMA(-S_ddot_x, k_x,
            L_ddot*k1))));
        const stewart_real phi_ddot = STEWART_FMA(-rho_share, two_phi_dot, inv_rho*STEWART_FMA(S_ddot_z,
            y_z, STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)));
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
        const stewart_real M_phi_L = STEWART_FMA(h_z, -k13, h_x*k33);
        const stewart_real M_mixed_theta = STEWART_FMA(-a3, k3, J_yz*k1);
        const stewart_real bend = L_dot*theta_dot;
        const stewart_real g_x_k_x = model->g_x_k[0][leg], g_x_k_y = model->g_x_k[1][leg], g_x_k_z = model->g_x_k[2][leg];
        const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        const stewart_real w_z = model->w[2][leg], w_x = model->w[0][leg], w_y = model->w[1][leg];
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
        const stewart_real g_k = model->g_k[leg];
        const stewart_real C_us = model->C_us[leg];
        const stewart_real C_s = model->C_s[leg];
        const stewart_real h2_y = model->h2_y[leg];
        /* (20) generalized forces about y and about k */
        const stewart_real tau_y = STEWART_FMA(M_theta, theta_ddot, STEWART_FMA(M_mixed, phi_ddot,
            STEWART_FMA(bend, h2_x, STEWART_FMA(-M_phi_theta, phi_dot2, STEWART_FMA(C_s,
            -STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x)), STEWART_FMA(C_us, theta_dot,
            STEWART_FMA(gamma_n, w_k, STEWART_FMA(g_k, w_n, L_ddot*h_z))))))));
        const stewart_real tau_k = STEWART_FMA(M_mixed, theta_ddot, STEWART_FMA(M_phi, phi_ddot,
            STEWART_FMA(bend*h2_y, -k1, STEWART_FMA(two_phi_dot, STEWART_FMA(M_phi_theta, theta_dot,
            L_dot*M_phi_L), STEWART_FMA(-gamma_y, w_n, STEWART_FMA(-gamma_n, w_y, STEWART_FMA(C_us, phi_dot,
            STEWART_FMA(-L_ddot, k3_h, STEWART_FMA(C_s, -STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y,
            k_x*omega_x)), M_mixed_theta*theta_dot2)))))))));
        /* (21) K = Q_k k + Q_y y, with a component along s */
        const stewart_real Q_k = -inv_rho*tau_y;
        const stewart_real Q_y = inv_rho*tau_k;
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x = STEWART_FMA(Q_k, k_x, Q_y*y_x);
        const stewart_real K_y = STEWART_FMA(Q_k, k_y, Q_y*y_y);
        const stewart_real K_z = STEWART_FMA(Q_k, k_z, Q_y*y_z);
        const stewart_real C_p = model->C_p[leg];
        const stewart_real least_L = shared_terms->least_L[l];
        const stewart_real any_unfit = legs_fit->any_unfit[l];
        /* (24) known part of the actuator force for this K */
        leg_terms->D[l] = STEWART_FMA(-Q_k, k1, STEWART_FMA(-k3_h, phi_ddot, STEWART_FMA(h_z, theta_ddot,
            STEWART_FMA(-M_phi_L, phi_dot2, STEWART_FMA(h_x, -theta_dot2, C_p*L_dot)))));
        const stewart_real c1 = C_s*phi_dot;
        const stewart_real c2 = C_s*theta_dot;
        leg_terms_now->c_force[0][l] = -K_x;
        leg_terms_now->c_force[1][l] = -K_y;
        leg_terms_now->c_force[2][l] = -K_z;
        leg_terms_now->c_moment[0][l] = STEWART_FMA(c2, y_x, c1*k_x);
        leg_terms_now->c_moment[1][l] = STEWART_FMA(c2, y_y, c1*k_y);
        leg_terms_now->c_moment[2][l] = STEWART_FMA(c2, y_z, c1*k_z);
        const stewart_real unfit = L > least_L ? any_unfit : REAL(1);
        const stewart_real unfit_2 = k3 > STEWART_NEAR_JOINT_SINGULAR ? unfit : REAL(1);
        legs_fit->any_unfit[l] = unfit_2;
        columns->H[0][l] = s_x;
        columns->H[1][l] = s_y;
        columns->H[2][l] = s_z;
    }
}

/* Computes the platform's part of c about platform point 1: 12 (6 mul, 6 add, 0 div, 0 sqrt). */
static void compute_tip_terms_block(
    const leg_roots_block *STEWART_RESTRICT leg_roots,
    const shared_terms_block *STEWART_RESTRICT shared_terms, right_side_block *STEWART_RESTRICT right_side,
    const leg_terms_now_block *STEWART_RESTRICT leg_terms_now, tip_terms_block *STEWART_RESTRICT tip_terms)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real q_x_leg1 = leg_roots[0].q[0][l], q_y_leg1 = leg_roots[0].q[1][l], q_z_leg1 = leg_roots[0].q[2][l];
        const stewart_real c_moment_x = shared_terms->c_moment[0][l], c_moment_y = shared_terms->c_moment[1][l],
            c_moment_z = shared_terms->c_moment[2][l];
        const stewart_real c_force_y = shared_terms->c_force[1][l], c_force_z = shared_terms->c_force[2][l],
            c_force_x = shared_terms->c_force[0][l];
        const stewart_real c_force_x_2_leg1 = leg_terms_now->c_force[0][l], c_force_y_2_leg1 = leg_terms_now->c_force[1][l],
            c_force_z_2_leg1 = leg_terms_now->c_force[2][l];
        const stewart_real c_moment_x_2_leg1 = leg_terms_now->c_moment[0][l], c_moment_y_2_leg1 = leg_terms_now->c_moment[1][l],
            c_moment_z_2_leg1 = leg_terms_now->c_moment[2][l];
        const stewart_real q_1_x = q_x_leg1;
        const stewart_real q_1_y = q_y_leg1;
        const stewart_real q_1_z = q_z_leg1;
        const stewart_real c_tip_x = STEWART_FMA(-c_force_z, q_1_y, STEWART_FMA(c_force_y, q_1_z,
            c_moment_x));
        const stewart_real c_tip_y = STEWART_FMA(-c_force_x, q_1_z, STEWART_FMA(c_force_z, q_1_x,
            c_moment_y));
        const stewart_real c_tip_z = STEWART_FMA(-c_force_y, q_1_x, STEWART_FMA(c_force_x, q_1_y,
            c_moment_z));
        right_side->c[0][l] = c_force_x + c_force_x_2_leg1;
        right_side->c[1][l] = c_force_y + c_force_y_2_leg1;
        right_side->c[2][l] = c_force_z + c_force_z_2_leg1;
        right_side->c[3][l] = c_tip_x + c_moment_x_2_leg1;
        right_side->c[4][l] = c_tip_y + c_moment_y_2_leg1;
        right_side->c[5][l] = c_tip_z + c_moment_z_2_leg1;
        tip_terms->q_1_x[l] = q_1_x;
        tip_terms->q_1_y[l] = q_1_y;
        tip_terms->q_1_z[l] = q_1_z;
    }
}

/* Computes the moments of a leg about platform point 1: 21 (12 mul, 9 add, 0 div, 0 sqrt). */
static void compute_moment_terms_block(
    right_side_block *STEWART_RESTRICT right_side,
    const leg_terms_now_block *STEWART_RESTRICT leg_terms_now,
    const leg_roots_block *STEWART_RESTRICT leg_roots, const tip_terms_block *STEWART_RESTRICT tip_terms,
    columns_block *STEWART_RESTRICT columns)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real c_force_x_2 = leg_terms_now->c_force[0][l], c_force_y_2 = leg_terms_now->c_force[1][l],
            c_force_z_2 = leg_terms_now->c_force[2][l];
        const stewart_real c_moment_x_2 = leg_terms_now->c_moment[0][l], c_moment_y_2 = leg_terms_now->c_moment[1][l],
            c_moment_z_2 = leg_terms_now->c_moment[2][l];
        const stewart_real q_x = leg_roots->q[0][l], q_y = leg_roots->q[1][l], q_z = leg_roots->q[2][l];
        const stewart_real q_1_x = tip_terms->q_1_x[l];
        const stewart_real q_1_y = tip_terms->q_1_y[l];
        const stewart_real q_1_z = tip_terms->q_1_z[l];
        const stewart_real s_z = columns->H[2][l], s_y = columns->H[1][l], s_x = columns->H[0][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - q_1_x;
        const stewart_real arm_y = q_y - q_1_y;
        const stewart_real arm_z = q_z - q_1_z;
        columns->H[3][l] = STEWART_FMA(-s_y, arm_z, s_z*arm_y);
        columns->H[4][l] = STEWART_FMA(-s_z, arm_x, s_x*arm_z);
        columns->H[5][l] = STEWART_FMA(-s_x, arm_y, s_y*arm_x);
        const stewart_real arm_c_x = STEWART_FMA(-arm_z, c_force_y_2, arm_y*c_force_z_2);
        const stewart_real arm_c_y = STEWART_FMA(-arm_x, c_force_z_2, arm_z*c_force_x_2);
        const stewart_real arm_c_z = STEWART_FMA(-arm_y, c_force_x_2, arm_x*c_force_y_2);
        right_side->c[0][l] = right_side->c[0][l] + c_force_x_2;
        right_side->c[1][l] = right_side->c[1][l] + c_force_y_2;
        right_side->c[2][l] = right_side->c[2][l] + c_force_z_2;
        right_side->c[3][l] = right_side->c[3][l] + c_moment_x_2 + arm_c_x;
        right_side->c[4][l] = right_side->c[4][l] + c_moment_y_2 + arm_c_y;
        right_side->c[5][l] = right_side->c[5][l] + c_moment_z_2 + arm_c_z;
    }
}

/* Multiplies the moments of a leg by `per_length`. */
STEWART_APART static void compute_scaled_moments_block(
    const stewart_exact_model *STEWART_RESTRICT model, columns_block *STEWART_RESTRICT columns)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real H_moment_x = columns->H[3][l], H_moment_y = columns->H[4][l], H_moment_z = columns->H[5][l];
        const stewart_real per_length = model->per_length;
        columns->H[3][l] = H_moment_x*per_length;
        columns->H[4][l] = H_moment_y*per_length;
        columns->H[5][l] = H_moment_z*per_length;
    }
}

/* Multiplies the moments of c by `per_length`. */
STEWART_APART static void compute_scaled_wrench_block(
    const stewart_exact_model *STEWART_RESTRICT model, right_side_block *STEWART_RESTRICT right_side)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real c_3 = right_side->c[3][l], c_4 = right_side->c[4][l], c_5 = right_side->c[5][l];
        const stewart_real per_length = model->per_length;
        right_side->c[3][l] = c_3*per_length;
        right_side->c[4][l] = c_4*per_length;
        right_side->c[5][l] = c_5*per_length;
    }
}

/* Solves H x = c for x in two blocks of three legs, (36). Sets `weak` if the blocks are too inaccurate,
 * so that pivots are required. */
STEWART_APART static void compute_results_block(
    const stewart_exact_model *STEWART_RESTRICT model, const columns_block *STEWART_RESTRICT columns,
    const right_side_block *STEWART_RESTRICT right_side, const leg_terms_block *STEWART_RESTRICT leg_terms,
    const legs_fit_block *STEWART_RESTRICT legs_fit, results_block *STEWART_RESTRICT results,
    forces_block *STEWART_RESTRICT forces)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real s_y_leg4 = columns[3].H[1][l], s_z_leg4 = columns[3].H[2][l], s_x_leg4 = columns[3].H[0][l],
            H_moment_x_leg4 = columns[3].H[3][l], H_moment_y_leg4 = columns[3].H[4][l], H_moment_z_leg4 = columns[3].H[5][l];
        const stewart_real s_z_leg6 = columns[5].H[2][l], s_y_leg6 = columns[5].H[1][l], s_x_leg6 = columns[5].H[0][l],
            H_moment_x_leg6 = columns[5].H[3][l], H_moment_y_leg6 = columns[5].H[4][l], H_moment_z_leg6 = columns[5].H[5][l];
        const stewart_real s_z_leg2 = columns[1].H[2][l], s_y_leg2 = columns[1].H[1][l], s_x_leg2 = columns[1].H[0][l],
            H_moment_x_leg2 = columns[1].H[3][l], H_moment_y_leg2 = columns[1].H[4][l], H_moment_z_leg2 = columns[1].H[5][l];
        const stewart_real s_x_leg1 = columns[0].H[0][l], s_y_leg1 = columns[0].H[1][l], s_z_leg1 = columns[0].H[2][l];
        const stewart_real s_x_leg3 = columns[2].H[0][l], s_y_leg3 = columns[2].H[1][l], s_z_leg3 = columns[2].H[2][l],
            H_moment_x_leg3 = columns[2].H[3][l], H_moment_y_leg3 = columns[2].H[4][l], H_moment_z_leg3 = columns[2].H[5][l];
        const stewart_real s_x_leg5 = columns[4].H[0][l], s_y_leg5 = columns[4].H[1][l], s_z_leg5 = columns[4].H[2][l],
            H_moment_x_leg5 = columns[4].H[3][l], H_moment_y_leg5 = columns[4].H[4][l], H_moment_z_leg5 = columns[4].H[5][l];
        const stewart_real c_0 = right_side->c[0][l], c_1 = right_side->c[1][l], c_2 = right_side->c[2][l],
            c_3 = right_side->c[3][l], c_4 = right_side->c[4][l], c_5 = right_side->c[5][l];
        const stewart_real arm_cube = model->arm_cube;
        const stewart_real D_leg1 = leg_terms[0].D[l];
        const stewart_real D_leg2 = leg_terms[1].D[l];
        const stewart_real D_leg3 = leg_terms[2].D[l];
        const stewart_real D_leg4 = leg_terms[3].D[l];
        const stewart_real D_leg5 = leg_terms[4].D[l];
        const stewart_real D_leg6 = leg_terms[5].D[l];
        const stewart_real any_unfit = legs_fit->any_unfit[l];
        const stewart_real r_0_0 = STEWART_FMA(-s_z_leg4, s_y_leg6, s_y_leg4*s_z_leg6);
        const stewart_real r_0_1 = STEWART_FMA(-s_x_leg4, s_z_leg6, s_z_leg4*s_x_leg6);
        const stewart_real r_0_2 = STEWART_FMA(-s_y_leg4, s_x_leg6, s_x_leg4*s_y_leg6);
        const stewart_real r_1_0 = STEWART_FMA(-s_z_leg6, s_y_leg2, s_y_leg6*s_z_leg2);
        const stewart_real r_1_1 = STEWART_FMA(-s_x_leg6, s_z_leg2, s_z_leg6*s_x_leg2);
        const stewart_real r_1_2 = STEWART_FMA(-s_y_leg6, s_x_leg2, s_x_leg6*s_y_leg2);
        const stewart_real r_2_0 = STEWART_FMA(-s_z_leg2, s_y_leg4, s_y_leg2*s_z_leg4);
        const stewart_real r_2_1 = STEWART_FMA(-s_x_leg2, s_z_leg4, s_z_leg2*s_x_leg4);
        const stewart_real r_2_2 = STEWART_FMA(-s_y_leg2, s_x_leg4, s_x_leg2*s_y_leg4);
        const stewart_real det = STEWART_FMA(s_z_leg2, r_0_2, STEWART_FMA(s_y_leg2, r_0_1, s_x_leg2*r_0_0));
        const stewart_real e_0_leg1 = STEWART_FMA(r_0_2, s_z_leg1, STEWART_FMA(r_0_1, s_y_leg1,
            r_0_0*s_x_leg1));
        const stewart_real e_0_leg3 = STEWART_FMA(r_0_2, s_z_leg3, STEWART_FMA(r_0_1, s_y_leg3,
            r_0_0*s_x_leg3));
        const stewart_real e_0_leg5 = STEWART_FMA(r_0_2, s_z_leg5, STEWART_FMA(r_0_1, s_y_leg5,
            r_0_0*s_x_leg5));
        const stewart_real e_1_leg1 = STEWART_FMA(r_1_2, s_z_leg1, STEWART_FMA(r_1_1, s_y_leg1,
            r_1_0*s_x_leg1));
        const stewart_real e_1_leg3 = STEWART_FMA(r_1_2, s_z_leg3, STEWART_FMA(r_1_1, s_y_leg3,
            r_1_0*s_x_leg3));
        const stewart_real e_1_leg5 = STEWART_FMA(r_1_2, s_z_leg5, STEWART_FMA(r_1_1, s_y_leg5,
            r_1_0*s_x_leg5));
        const stewart_real e_2_leg1 = STEWART_FMA(r_2_2, s_z_leg1, STEWART_FMA(r_2_1, s_y_leg1,
            r_2_0*s_x_leg1));
        const stewart_real e_2_leg3 = STEWART_FMA(r_2_2, s_z_leg3, STEWART_FMA(r_2_1, s_y_leg3,
            r_2_0*s_x_leg3));
        const stewart_real e_2_leg5 = STEWART_FMA(r_2_2, s_z_leg5, STEWART_FMA(r_2_1, s_y_leg5,
            r_2_0*s_x_leg5));
        const stewart_real w_0_leg1 = STEWART_FMA(-H_moment_x_leg6, e_2_leg1, STEWART_FMA(-H_moment_x_leg4,
            e_1_leg1, -H_moment_x_leg2*e_0_leg1));
        const stewart_real w_0_leg3 = STEWART_FMA(-H_moment_x_leg6, e_2_leg3, STEWART_FMA(-H_moment_x_leg4,
            e_1_leg3, STEWART_FMA(-H_moment_x_leg2, e_0_leg3, det*H_moment_x_leg3)));
        const stewart_real w_0_leg5 = STEWART_FMA(-H_moment_x_leg6, e_2_leg5, STEWART_FMA(-H_moment_x_leg4,
            e_1_leg5, STEWART_FMA(-H_moment_x_leg2, e_0_leg5, det*H_moment_x_leg5)));
        const stewart_real w_1_leg1 = STEWART_FMA(-H_moment_y_leg6, e_2_leg1, STEWART_FMA(-H_moment_y_leg4,
            e_1_leg1, -H_moment_y_leg2*e_0_leg1));
        const stewart_real w_1_leg3 = STEWART_FMA(-H_moment_y_leg6, e_2_leg3, STEWART_FMA(-H_moment_y_leg4,
            e_1_leg3, STEWART_FMA(-H_moment_y_leg2, e_0_leg3, det*H_moment_y_leg3)));
        const stewart_real w_1_leg5 = STEWART_FMA(-H_moment_y_leg6, e_2_leg5, STEWART_FMA(-H_moment_y_leg4,
            e_1_leg5, STEWART_FMA(-H_moment_y_leg2, e_0_leg5, det*H_moment_y_leg5)));
        const stewart_real w_2_leg1 = STEWART_FMA(-H_moment_z_leg6, e_2_leg1, STEWART_FMA(-H_moment_z_leg4,
            e_1_leg1, -H_moment_z_leg2*e_0_leg1));
        const stewart_real w_2_leg3 = STEWART_FMA(-H_moment_z_leg6, e_2_leg3, STEWART_FMA(-H_moment_z_leg4,
            e_1_leg3, STEWART_FMA(-H_moment_z_leg2, e_0_leg3, det*H_moment_z_leg3)));
        const stewart_real w_2_leg5 = STEWART_FMA(-H_moment_z_leg6, e_2_leg5, STEWART_FMA(-H_moment_z_leg4,
            e_1_leg5, STEWART_FMA(-H_moment_z_leg2, e_0_leg5, det*H_moment_z_leg5)));
        const stewart_real e_c_0 = STEWART_FMA(r_0_2, c_2, STEWART_FMA(r_0_1, c_1, r_0_0*c_0));
        const stewart_real e_c_1 = STEWART_FMA(r_1_2, c_2, STEWART_FMA(r_1_1, c_1, r_1_0*c_0));
        const stewart_real e_c_2 = STEWART_FMA(r_2_2, c_2, STEWART_FMA(r_2_1, c_1, r_2_0*c_0));
        const stewart_real w_c_0 = STEWART_FMA(-H_moment_x_leg6, e_c_2, STEWART_FMA(-H_moment_x_leg4, e_c_1,
            STEWART_FMA(-H_moment_x_leg2, e_c_0, det*c_3)));
        const stewart_real w_c_1 = STEWART_FMA(-H_moment_y_leg6, e_c_2, STEWART_FMA(-H_moment_y_leg4, e_c_1,
            STEWART_FMA(-H_moment_y_leg2, e_c_0, det*c_4)));
        const stewart_real w_c_2 = STEWART_FMA(-H_moment_z_leg6, e_c_2, STEWART_FMA(-H_moment_z_leg4, e_c_1,
            STEWART_FMA(-H_moment_z_leg2, e_c_0, det*c_5)));
        const stewart_real u_0_0 = STEWART_FMA(-w_2_leg3, w_1_leg5, w_1_leg3*w_2_leg5);
        const stewart_real u_0_1 = STEWART_FMA(-w_0_leg3, w_2_leg5, w_2_leg3*w_0_leg5);
        const stewart_real u_0_2 = STEWART_FMA(-w_1_leg3, w_0_leg5, w_0_leg3*w_1_leg5);
        const stewart_real u_1_0 = STEWART_FMA(-w_2_leg5, w_1_leg1, w_1_leg5*w_2_leg1);
        const stewart_real u_1_1 = STEWART_FMA(-w_0_leg5, w_2_leg1, w_2_leg5*w_0_leg1);
        const stewart_real u_1_2 = STEWART_FMA(-w_1_leg5, w_0_leg1, w_0_leg5*w_1_leg1);
        const stewart_real u_2_0 = STEWART_FMA(-w_2_leg1, w_1_leg3, w_1_leg1*w_2_leg3);
        const stewart_real u_2_1 = STEWART_FMA(-w_0_leg1, w_2_leg3, w_2_leg1*w_0_leg3);
        const stewart_real u_2_2 = STEWART_FMA(-w_1_leg1, w_0_leg3, w_0_leg1*w_1_leg3);
        const stewart_real complement = STEWART_FMA(w_2_leg1, u_0_2, STEWART_FMA(w_1_leg1, u_0_1,
            w_0_leg1*u_0_0));
        const stewart_real det2 = det*det;
        const stewart_real least = STEWART_LARGER(STEWART_FABS(det)*STEWART_BLOCK_LEAST,
            STEWART_BLOCK_SINGULAR)*(det2*arm_cube);
        const stewart_real grown = STEWART_FMA(e_0_leg5, e_0_leg5, STEWART_FMA(e_0_leg3, e_0_leg3,
            e_0_leg1*e_0_leg1)) + STEWART_FMA(e_1_leg5, e_1_leg5, STEWART_FMA(e_1_leg3, e_1_leg3,
            e_1_leg1*e_1_leg1)) + STEWART_FMA(e_2_leg5, e_2_leg5, STEWART_FMA(e_2_leg3, e_2_leg3,
            e_2_leg1*e_2_leg1)) > STEWART_BLOCK_GROWTH*det2 ? REAL(1) : REAL(0);
        results->weak[l] = STEWART_FABS(complement) <= least ? REAL(1) : grown;
        const stewart_real inverse_det = REAL(1)/det;
        const stewart_real inverse_complement = REAL(1)/complement;
        const stewart_real x_0 = STEWART_FMA(u_0_2, w_c_2, STEWART_FMA(u_0_1, w_c_1,
            u_0_0*w_c_0))*inverse_complement;
        const stewart_real x_2 = STEWART_FMA(u_1_2, w_c_2, STEWART_FMA(u_1_1, w_c_1,
            u_1_0*w_c_0))*inverse_complement;
        const stewart_real x_4 = STEWART_FMA(u_2_2, w_c_2, STEWART_FMA(u_2_1, w_c_1,
            u_2_0*w_c_0))*inverse_complement;
        const stewart_real x_1 = STEWART_FMA(-e_0_leg5, x_4, STEWART_FMA(-e_0_leg3, x_2,
            STEWART_FMA(-e_0_leg1, x_0, e_c_0)))*inverse_det;
        const stewart_real x_3 = STEWART_FMA(-e_1_leg5, x_4, STEWART_FMA(-e_1_leg3, x_2,
            STEWART_FMA(-e_1_leg1, x_0, e_c_1)))*inverse_det;
        const stewart_real x_5 = STEWART_FMA(-e_2_leg5, x_4, STEWART_FMA(-e_2_leg3, x_2,
            STEWART_FMA(-e_2_leg1, x_0, e_c_2)))*inverse_det;
        const stewart_real F_0 = D_leg1 - x_0;
        const stewart_real F_1 = D_leg2 - x_1;
        const stewart_real F_2 = D_leg3 - x_2;
        const stewart_real F_3 = D_leg4 - x_3;
        const stewart_real F_4 = D_leg5 - x_4;
        const stewart_real F_5 = D_leg6 - x_5;
        const stewart_real unfinished = any_unfit;
        const stewart_real unfinished_2 = STEWART_FABS(F_0) <= STEWART_MAX ? unfinished : REAL(1);
        const stewart_real unfinished_3 = STEWART_FABS(F_1) <= STEWART_MAX ? unfinished_2 : REAL(1);
        const stewart_real unfinished_4 = STEWART_FABS(F_2) <= STEWART_MAX ? unfinished_3 : REAL(1);
        const stewart_real unfinished_5 = STEWART_FABS(F_3) <= STEWART_MAX ? unfinished_4 : REAL(1);
        const stewart_real unfinished_6 = STEWART_FABS(F_4) <= STEWART_MAX ? unfinished_5 : REAL(1);
        forces->unfinished[l] = STEWART_FABS(F_5) <= STEWART_MAX ? unfinished_6 : REAL(1);
        forces->F[0][l] = F_0;
        forces->F[1][l] = F_1;
        forces->F[2][l] = F_2;
        forces->F[3][l] = F_3;
        forces->F[4][l] = F_4;
        forces->F[5][l] = F_5;
    }
}

/* Computes the results again. */
STEWART_APART static void compute_results_of_pivots_block(
    const leg_terms_block *STEWART_RESTRICT leg_terms, const solution_block *STEWART_RESTRICT solution,
    const results_block *STEWART_RESTRICT results, const legs_fit_block *STEWART_RESTRICT legs_fit,
    forces_block *STEWART_RESTRICT forces)
{
    int l;
    stewart_real F_0_2_of[POSES];
    stewart_real F_1_2_of[POSES];
    stewart_real F_2_2_of[POSES];
    stewart_real F_3_2_of[POSES];
    stewart_real F_4_2_of[POSES];
    stewart_real F_5_2_of[POSES];
    stewart_real unfinished_14_of[POSES];
    for (l = 0; l < POSES; ++l) {
        const stewart_real D_leg1 = leg_terms[0].D[l];
        const stewart_real x_0_2 = solution->x[0][l], x_1_2 = solution->x[1][l], x_2_2 = solution->x[2][l],
            x_3_2 = solution->x[3][l], x_4_2 = solution->x[4][l], x_5_2 = solution->x[5][l];
        const stewart_real D_leg2 = leg_terms[1].D[l];
        const stewart_real D_leg3 = leg_terms[2].D[l];
        const stewart_real D_leg4 = leg_terms[3].D[l];
        const stewart_real D_leg5 = leg_terms[4].D[l];
        const stewart_real D_leg6 = leg_terms[5].D[l];
        const stewart_real suspect = solution->suspect[l];
        const stewart_real any_unfit = legs_fit->any_unfit[l];
        const stewart_real F_0_2 = D_leg1 - x_0_2;
        const stewart_real F_1_2 = D_leg2 - x_1_2;
        const stewart_real F_2_2 = D_leg3 - x_2_2;
        const stewart_real F_3_2 = D_leg4 - x_3_2;
        const stewart_real F_4_2 = D_leg5 - x_4_2;
        const stewart_real F_5_2 = D_leg6 - x_5_2;
        const stewart_real unfinished_8 = suspect > REAL(0) ? REAL(1) : any_unfit;
        const stewart_real unfinished_9 = STEWART_FABS(F_0_2) <= STEWART_MAX ? unfinished_8 : REAL(1);
        const stewart_real unfinished_10 = STEWART_FABS(F_1_2) <= STEWART_MAX ? unfinished_9 : REAL(1);
        const stewart_real unfinished_11 = STEWART_FABS(F_2_2) <= STEWART_MAX ? unfinished_10 : REAL(1);
        const stewart_real unfinished_12 = STEWART_FABS(F_3_2) <= STEWART_MAX ? unfinished_11 : REAL(1);
        const stewart_real unfinished_13 = STEWART_FABS(F_4_2) <= STEWART_MAX ? unfinished_12 : REAL(1);
        const stewart_real unfinished_14 = STEWART_FABS(F_5_2) <= STEWART_MAX ? unfinished_13 : REAL(1);
        F_0_2_of[l] = F_0_2;
        F_1_2_of[l] = F_1_2;
        F_2_2_of[l] = F_2_2;
        F_3_2_of[l] = F_3_2;
        F_4_2_of[l] = F_4_2;
        F_5_2_of[l] = F_5_2;
        unfinished_14_of[l] = unfinished_14;
    }
    for (l = 0; l < POSES; ++l) {
        forces->F[0][l] = results->weak[l] > REAL(0) ? F_0_2_of[l] : forces->F[0][l];
        forces->F[1][l] = results->weak[l] > REAL(0) ? F_1_2_of[l] : forces->F[1][l];
        forces->F[2][l] = results->weak[l] > REAL(0) ? F_2_2_of[l] : forces->F[2][l];
        forces->F[3][l] = results->weak[l] > REAL(0) ? F_3_2_of[l] : forces->F[3][l];
        forces->F[4][l] = results->weak[l] > REAL(0) ? F_4_2_of[l] : forces->F[4][l];
        forces->F[5][l] = results->weak[l] > REAL(0) ? F_5_2_of[l] : forces->F[5][l];
        forces->unfinished[l] = results->weak[l] > REAL(0) ? unfinished_14_of[l] : forces->unfinished[l];
    }
}

/* Computes the forces of a block of poses, and marks the poses that must be examined. */
static void forces_of_block(const stewart_exact_model *model, const motion_lanes *at, forces_block *forces)
{
    int l, leg;
    leg_roots_block leg_roots[6];
    shared_terms_block shared_terms;
    legs_fit_block legs_fit;
    columns_block columns[6];
    leg_terms_block leg_terms[6];
    leg_terms_now_block leg_terms_now;
    tip_terms_block tip_terms;
    right_side_block right_side;
    results_block results;
    solution_block solution;
    compute_leg_roots_block(model, at, 0, &leg_roots[0]);
    compute_shared_terms_block(model, at, &shared_terms);
    compute_legs_fit_block(&legs_fit);
    for (leg = 0; leg < 6; ++leg) {
        if (leg < 5) {
            compute_leg_roots_block(model, at, leg + 1, &leg_roots[leg + 1]);
        }
        compute_leg_terms_block(model, at, leg, &leg_roots[leg], &shared_terms, &legs_fit, &columns[leg],
            &leg_terms[leg], &leg_terms_now);
        if (leg == 0) {
            compute_tip_terms_block(leg_roots, &shared_terms, &right_side, &leg_terms_now, &tip_terms);
        }
        if (leg > 0) {
            compute_moment_terms_block(&right_side, &leg_terms_now, &leg_roots[leg], &tip_terms,
                &columns[leg]);
        }
    }
    if (model->per_length != REAL(1)) {
        for (leg = 1; leg < 6; ++leg) {
            compute_scaled_moments_block(model, &columns[leg]);
        }
        compute_scaled_wrench_block(model, &right_side);
    }
    compute_results_block(model, columns, &right_side, leg_terms, &legs_fit, &results, forces);
    stewart_real most_weak = REAL(0);
    for (l = 0; l < POSES; ++l) {
        most_weak = STEWART_LARGER(results.weak[l], most_weak);
    }
    if (most_weak > REAL(0)) {
        compute_pivots_block(columns, &right_side, &solution);
        compute_results_of_pivots_block(leg_terms, &solution, &results, &legs_fit, forces);
    }
}

/* Loads the motions of a block of poses, component by component. */
STEWART_APART static void load_block(
    const stewart_motions *motions, size_t stride, size_t first, size_t count, motion_lanes *at)
{
    load_matrix(motions->R, stride, first, count, at->R);
    load_vector(motions->t, stride, first, count, at->t);
    load_vector(motions->omega, stride, first, count, at->omega);
    load_vector(motions->v, stride, first, count, at->v);
    load_vector(motions->alpha, stride, first, count, at->alpha);
    load_vector(motions->a, stride, first, count, at->a);
    load_vector(motions->F_ext, stride, first, count, at->F_ext);
    load_vector(motions->M_ext, stride, first, count, at->M_ext);
}

/* Computes the forces and the status of one pose of a block. */
static int forces_of(const stewart_exact_model *model, const motion_lanes *at, int l, stewart_real F[6])
{
    int i;
    stewart_motion one;
    for (i = 0; i < 9; ++i) {
        one.R[i] = at->R[i][l];
    }
    for (i = 0; i < 3; ++i) {
        one.t[i] = at->t[i][l];
        one.omega[i] = at->omega[i][l];
        one.v[i] = at->v[i][l];
        one.alpha[i] = at->alpha[i][l];
        one.a[i] = at->a[i][l];
        one.F_ext[i] = at->F_ext[i][l];
        one.M_ext[i] = at->M_ext[i][l];
    }
    return stewart_exact_forces(model, &one, F);
}

/* Computes the forces block by block. The arrays contain pose after pose if stride is 0, else columns. */
static int forces_of_poses(
    const stewart_exact_model *model, size_t count, size_t stride, const stewart_motions *motions,
    stewart_real *F, int *status)
{
    size_t first;
    int i, l;
    motion_lanes at;
    forces_block done;
    stewart_real found[6];
    int result = STEWART_OK;
    for (first = 0; first < count; first += (size_t)POSES) {
        load_block(motions, stride, first, count, &at);
        forces_of_block(model, &at, &done);
        for (l = 0; l < POSES; ++l) {
            if (!(first + (size_t)l < count)) {
                break;
            }
            const size_t pose = first + (size_t)l;
            int code = STEWART_OK;
            if (done.unfinished[l] > REAL(0)) {
                code = forces_of(model, &at, l, found);
                if (code == STEWART_OK) {
                    done.unfinished[l] = REAL(0);
                    for (i = 0; i < 6; ++i) {
                        done.F[i][l] = found[i];
                    }
                }
            }
            if (status != NULL) {
                status[pose] = code;
            }
            result = result == STEWART_OK ? code : result;
        }
        store_forces(done.F, done.unfinished, stride, first, count, F);
    }
    return result;
}

int stewart_exact_forces_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions, stewart_real *F,
    int *status)
{
    if (model == NULL || motions == NULL || F == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL || motions->alpha == NULL || motions->a == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    return forces_of_poses(model, count, 0, motions, F, status);
}

int stewart_exact_forces_columns(
    const stewart_exact_model *model, size_t count, size_t stride, const stewart_motions *motions,
    stewart_real *F, int *status)
{
    if (model == NULL || motions == NULL || F == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL || motions->alpha == NULL || motions->a == NULL || stride < count) {
        return STEWART_BAD_ARGUMENT;
    }
    return forces_of_poses(model, count, stride, motions, F, status);
}
