/* stewart_exact_general_static_forces.c: functions that are declared and described in stewart_exact_general_static_forces.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_exact_general_static_forces.h"

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
    stewart_real F_ext[3][POSES];
    stewart_real M_ext[3][POSES];
} STEWART_ALIGNED motion_lanes;

/* Terms of a pose that are common to all legs. */
typedef struct {
    stewart_real c_force[3];
    stewart_real c_moment[3];
    stewart_real c_tip[3];
} shared_terms;

typedef struct {
    stewart_real least_L[POSES]; /* m: length below which a leg must be checked */
} STEWART_ALIGNED shared_lanes;

/* The legs of one pose. */
typedef struct {
    stewart_real A[6][LANES]; /* H, one column for each leg */
    stewart_real q[3][LANES];
    stewart_real D[LANES];
    stewart_real c_force[3][LANES];
    stewart_real arm_c[3][LANES];
    stewart_real L[LANES];
    stewart_real reach[LANES];
    stewart_real k3[LANES];
    stewart_real bad[LANES]; /* 1 if the leg must be checked, else 0 */
} leg_lanes;

/* Constants of one leg, and its contributions to the constants of the platform. */
static void prepare_leg(
    const stewart_robot *robot, const stewart_leg *leg, int i, stewart_exact_general_static_model *out,
    lumped_terms *added)
{
    stewart_real axis[3];
    scaled_axis(leg->k, axis);
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = axis[0], k_y = axis[1], k_z = axis[2];
    const stewart_real m_d = leg->m_d;
    const stewart_real r_d0_x = leg->r_d0[0], r_d0_y = leg->r_d0[1], r_d0_z = leg->r_d0[2];
    const stewart_real m_u = leg->m_u;
    const stewart_real r_u0_x = leg->r_u0[0], r_u0_y = leg->r_u0[1], r_u0_z = leg->r_u0[2];
    const stewart_real p_1_x = robot->leg[0].p[0], p_1_y = robot->leg[0].p[1], p_1_z = robot->leg[0].p[2];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real k_size = STEWART_SQRT(k_x*k_x + k_y*k_y + k_z*k_z);
    const stewart_real inv_k_size = REAL(1)/k_size;
    /* fixed axis, of length one */
    const stewart_real k_unit_x = inv_k_size*k_x;
    const stewart_real k_unit_y = inv_k_size*k_y;
    const stewart_real k_unit_z = inv_k_size*k_z;
    const stewart_real h_x = m_u*r_u0_x;
    const stewart_real h_y = m_u*r_u0_y;
    const stewart_real h_z = m_u*r_u0_z;
    const stewart_real w_x = h_x + m_d*r_d0_x;
    const stewart_real w_y = h_y + m_d*r_d0_y;
    const stewart_real w_z = h_z + m_d*r_d0_z;
    /* platform point from platform point 1 */
    const stewart_real arm_x = p_x - p_1_x;
    const stewart_real arm_y = p_y - p_1_y;
    const stewart_real arm_z = p_z - p_1_z;
    const stewart_real c1 = arm_x*m_u;
    const stewart_real c2 = arm_y*m_u;
    const stewart_real c3 = arm_y*arm_y;
    const stewart_real c4 = arm_z*arm_z;
    const stewart_real c5 = arm_x*arm_x;
    out->b[0][i] = b_x;
    out->b[1][i] = b_y;
    out->b[2][i] = b_z;
    out->p[0][i] = p_x;
    out->p[1][i] = p_y;
    out->p[2][i] = p_z;
    out->k[0][i] = k_unit_x;
    out->k[1][i] = k_unit_y;
    out->k[2][i] = k_unit_z;
    out->w[0][i] = w_x;
    out->w[1][i] = w_y;
    out->w[2][i] = w_z;
    out->g_k[i] = g_x*k_unit_x + g_y*k_unit_y + g_z*k_unit_z;
    out->g_x_k[0][i] = g_y*k_unit_z - g_z*k_unit_y;
    out->g_x_k[1][i] = g_z*k_unit_x - g_x*k_unit_z;
    out->g_x_k[2][i] = g_x*k_unit_y - g_y*k_unit_x;
    added->M_add = m_u;
    added->h_add[0] = c1;
    added->h_add[1] = c2;
    added->h_add[2] = arm_z*m_u;
    added->J_add[0] = m_u*(c3 + c4);
    added->J_add[1] = -arm_y*c1;
    added->J_add[2] = -arm_z*c1;
    added->J_add[3] = m_u*(c4 + c5);
    added->J_add[4] = -arm_z*c2;
    added->J_add[5] = m_u*(c3 + c5);
    added->C_add = REAL(0);
}

/* Constants of the platform. */
static void prepare_platform(
    const stewart_robot *robot, const lumped_terms *sum, stewart_exact_general_static_model *out)
{
    const stewart_real M = robot->M;
    const stewart_real R_0_x = robot->R_0[0], R_0_y = robot->R_0[1], R_0_z = robot->R_0[2];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real p_1_x = robot->leg[0].p[0], p_1_y = robot->leg[0].p[1], p_1_z = robot->leg[0].p[2];
    const stewart_real M_add = sum->M_add;
    const stewart_real h_add_x = sum->h_add[0], h_add_y = sum->h_add[1], h_add_z = sum->h_add[2];
    const stewart_real M_P = M + M_add;
    /* first moment about the reference point */
    const stewart_real h_P_x = h_add_x + M*R_0_x + M_add*p_1_x;
    const stewart_real h_P_y = h_add_y + M*R_0_y + M_add*p_1_y;
    const stewart_real h_P_z = h_add_z + M*R_0_z + M_add*p_1_z;
    const stewart_real c1 = REAL(1)/M_P;
    const stewart_real r_C_x = c1*h_P_x;
    const stewart_real r_C_y = c1*h_P_y;
    const stewart_real r_C_z = c1*h_P_z;
    out->r_C[0] = r_C_x;
    out->r_C[1] = r_C_y;
    out->r_C[2] = r_C_z;
    out->W_P[0] = M_P*g_x;
    out->W_P[1] = M_P*g_y;
    out->W_P[2] = M_P*g_z;
    out->g[0] = g_x;
    out->g[1] = g_y;
    out->g[2] = g_z;
}

/* Returns the largest coordinate (m) of the arms of moments about platform point 1. */
static stewart_real size_of(const stewart_exact_general_static_model *model)
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

int stewart_exact_general_static_prepare(
    const stewart_robot *robot, stewart_exact_general_static_model *model)
{
    int i, j;
    stewart_exact_general_static_model made;
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
    for (i = 0; i < 140; ++i) {
        if (!(STEWART_FABS(numbers[i]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    *model = made;
    return STEWART_OK;
}

/* Computes the terms of a pose that are common to all legs: 60 (33 mul, 27 add, 0 div, 0 sqrt)
 * operations. */
static void shared_of_pose(
    const stewart_exact_general_static_model *model, const stewart_motion *at, shared_terms *out)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real M_ext_x = at->M_ext[0], M_ext_y = at->M_ext[1], M_ext_z = at->M_ext[2];
    const stewart_real r_C_x = model->r_C[0], r_C_y = model->r_C[1], r_C_z = model->r_C[2];
    const stewart_real W_P_x = model->W_P[0], W_P_y = model->W_P[1], W_P_z = model->W_P[2];
    /* (30) center of mass from the reference point, base frame */
    const stewart_real R_C_x = STEWART_FMA(R_xz, r_C_z, STEWART_FMA(R_xy, r_C_y, R_xx*r_C_x));
    const stewart_real R_C_y = STEWART_FMA(R_yz, r_C_z, STEWART_FMA(R_yy, r_C_y, R_yx*r_C_x));
    const stewart_real R_C_z = STEWART_FMA(R_zz, r_C_z, STEWART_FMA(R_zy, r_C_y, R_zx*r_C_x));
    /* (33) M_P (g - a_C) */
    const stewart_real N_x = W_P_x;
    const stewart_real N_y = W_P_y;
    const stewart_real N_z = W_P_z;
    out->c_force[0] = STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy, STEWART_FMA(F_ext_x, R_xx,
        N_x)));
    out->c_force[1] = STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy, STEWART_FMA(F_ext_x, R_yx,
        N_y)));
    out->c_force[2] = STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy, STEWART_FMA(F_ext_x, R_zx,
        N_z)));
    out->c_moment[0] = STEWART_FMA(-N_y, R_C_z, STEWART_FMA(N_z, R_C_y, STEWART_FMA(M_ext_z, R_xz,
        STEWART_FMA(M_ext_y, R_xy, M_ext_x*R_xx))));
    out->c_moment[1] = STEWART_FMA(-N_z, R_C_x, STEWART_FMA(N_x, R_C_z, STEWART_FMA(M_ext_z, R_yz,
        STEWART_FMA(M_ext_y, R_yy, M_ext_x*R_yx))));
    out->c_moment[2] = STEWART_FMA(-N_x, R_C_y, STEWART_FMA(N_y, R_C_x, STEWART_FMA(M_ext_z, R_zz,
        STEWART_FMA(M_ext_y, R_zy, M_ext_x*R_zx))));
}

/* Computes the legs of one pose in lanes: 88 (53 mul, 31 add, 2 div, 2 sqrt) operations each. */
static void legs_of_pose(
    const stewart_exact_general_static_model *STEWART_RESTRICT model,
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
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l], g_x_k_z = model->g_x_k[2][l];
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
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
        /* (20) generalized forces about y and about k */
        const stewart_real tau_y = STEWART_FMA(gamma_n, w_k, g_k*w_n);
        const stewart_real tau_k = STEWART_FMA(-gamma_y, w_n, -gamma_n*w_y);
        /* (21) K = Q_k k + Q_y y, with a component along s */
        const stewart_real Q_k = -inv_rho*tau_y;
        const stewart_real Q_y = inv_rho*tau_k;
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x = STEWART_FMA(Q_y, y_x, Q_k*k_x);
        const stewart_real K_y = STEWART_FMA(Q_y, y_y, Q_k*k_y);
        const stewart_real K_z = STEWART_FMA(Q_y, y_z, Q_k*k_z);
        /* (24) known part of the actuator force for this K */
        const stewart_real D = -Q_k*k1;
        out->D[l] = D;
        out->A[0][l] = s_x;
        out->A[1][l] = s_y;
        out->A[2][l] = s_z;
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
        out->k3[l] = k3;
        stewart_real fault = L > STEWART_SHORT_SHARE*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_NEAR_JOINT_SINGULAR ? fault : REAL(1);
        out->bad[l] = fault;
    }
}

/* Computes the legs of a pose in which a leg is near its joint singularity: 108 (66 mul, 38 add, 2 div,
 * 2 sqrt) operations each. */
static void legs_near_singular(
    const stewart_exact_general_static_model *STEWART_RESTRICT model,
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
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l], g_x_k_z = model->g_x_k[2][l];
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
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
        /* (20) generalized forces about y and about k */
        const stewart_real tau_y = STEWART_FMA(gamma_n, w_k, g_k*w_n);
        const stewart_real tau_k = STEWART_FMA(-gamma_y, w_n, -gamma_n*w_y);
        /* (21) K = Q_y y + Q_z z */
        const stewart_real Q_y = inv_rho*tau_k;
        const stewart_real Q_z = -inv_L*tau_y;
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x = STEWART_FMA(Q_y, y_x, Q_z*z_x);
        const stewart_real K_y = STEWART_FMA(Q_y, y_y, Q_z*z_y);
        const stewart_real K_z = STEWART_FMA(Q_y, y_z, Q_z*z_z);
        out->D[l] = REAL(0);
        out->A[0][l] = s_x;
        out->A[1][l] = s_y;
        out->A[2][l] = s_z;
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
        out->k3[l] = k3;
        stewart_real fault = L > STEWART_SHORT_SHARE*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->bad[l] = fault;
    }
}

int stewart_exact_general_static_forces(
    const stewart_exact_general_static_model *model, const stewart_motion *motion, stewart_real F[6])
{
    int i, j;
    shared_terms shared;
    leg_lanes legs;
    stewart_real wrench[6];
    stewart_real x[6];
    stewart_real found[6];
    int close = 0;
    int near_singular = 0;
    if (model == NULL || motion == NULL || F == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    shared_of_pose(model, motion, &shared);
    legs_of_pose(model, motion, &shared, &legs);
    for (i = 0; i < 6; ++i) {
        if (legs.bad[i] > REAL(0)) {
            const int status = fault_of(legs.L[i], legs.k3[i], legs.reach[i]);
            if (status != STEWART_OK) {
                return status;
            }
            close = legs.L[i] > STEWART_SHORT_SHARE*legs.reach[i] ? close : 1;
            near_singular = legs.k3[i] > STEWART_NEAR_JOINT_SINGULAR ? near_singular : 1;
        }
    }
    if (near_singular != 0) {
        legs_near_singular(model, motion, &shared, &legs);
    }
    shift_of_pose(legs.q, shared.c_force, shared.c_moment, shared.c_tip);
    moments_of_pose(legs.q, legs.A, legs.c_force, legs.arm_c);
    for (j = 0; j < 3; ++j) {
        stewart_real force = shared.c_force[j];
        stewart_real turn = shared.c_tip[j];
        STEWART_LOOP for (i = 0; i < 6; ++i) {
            force = force + legs.c_force[j][i];
            turn = turn + legs.arm_c[j][i];
        }
        wrench[j] = force;
        wrench[j + 3] = turn;
    }
    if (model->per_length != REAL(1)) {
        scale_pose(legs.A, wrench, model->per_length);
    }
    const int suspect = solve_pose(legs.A, wrench, model->arm_cube, x);
    if (close != 0 || suspect != 0) {
        const int status = rows_status(legs.A, legs.q, legs.L, legs.reach, model->per_length);
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

/* Intermediate results of a block of poses. */
typedef struct {
    stewart_real column[7][6][POSES]; /* [H | c], column by column */
    stewart_real D[6][POSES];
    stewart_real F[6][POSES];
    stewart_real bad[POSES]; /* 1 if a leg, a pivot, or a force must be checked, else 0 */
} STEWART_ALIGNED block;

/* Terms of a leg that the moments require. */
typedef struct {
    stewart_real q[3][POSES];
    stewart_real c_force[3][POSES];
} STEWART_ALIGNED leg_block;

/* A leg of the poses of a block up to its square roots. */
typedef struct {
    stewart_real q_x[POSES];
    stewart_real q_y[POSES];
    stewart_real q_z[POSES];
    stewart_real S_x[POSES];
    stewart_real S_y[POSES];
    stewart_real S_z[POSES];
    stewart_real zeta[POSES];
    stewart_real k_cross_S_x[POSES];
    stewart_real k_cross_S_y[POSES];
    stewart_real k_cross_S_z[POSES];
    stewart_real L[POSES];
    stewart_real rho[POSES];
    stewart_real inv_L[POSES];
    stewart_real inv_rho[POSES];
} STEWART_ALIGNED leg_roots;

typedef struct {
    leg_roots leg[6];
} STEWART_ALIGNED roots_of_legs;

/* Computes the terms that are common to all legs, and the platform's part of c, of a block of poses. */
static void shared_of_block(
    const stewart_exact_general_static_model *STEWART_RESTRICT model,
    const motion_lanes *STEWART_RESTRICT at, shared_lanes *STEWART_RESTRICT out,
    stewart_real (*STEWART_RESTRICT c)[POSES])
{
    int l;
    const stewart_real r_C_x = model->r_C[0], r_C_y = model->r_C[1], r_C_z = model->r_C[2];
    const stewart_real W_P_x = model->W_P[0], W_P_y = model->W_P[1], W_P_z = model->W_P[2];
    for (l = 0; l < POSES; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real F_ext_x = at->F_ext[0][l], F_ext_y = at->F_ext[1][l], F_ext_z = at->F_ext[2][l];
        const stewart_real M_ext_x = at->M_ext[0][l], M_ext_y = at->M_ext[1][l], M_ext_z = at->M_ext[2][l];
        /* (30) center of mass from the reference point, base frame */
        const stewart_real R_C_x = STEWART_FMA(R_xz, r_C_z, STEWART_FMA(R_xy, r_C_y, R_xx*r_C_x));
        const stewart_real R_C_y = STEWART_FMA(R_yz, r_C_z, STEWART_FMA(R_yy, r_C_y, R_yx*r_C_x));
        const stewart_real R_C_z = STEWART_FMA(R_zz, r_C_z, STEWART_FMA(R_zy, r_C_y, R_zx*r_C_x));
        /* (33) M_P (g - a_C) */
        const stewart_real N_x = W_P_x;
        const stewart_real N_y = W_P_y;
        const stewart_real N_z = W_P_z;
        c[0][l] = STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy, STEWART_FMA(F_ext_x, R_xx, N_x)));
        c[1][l] = STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy, STEWART_FMA(F_ext_x, R_yx, N_y)));
        c[2][l] = STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy, STEWART_FMA(F_ext_x, R_zx, N_z)));
        c[3][l] = STEWART_FMA(-N_y, R_C_z, STEWART_FMA(N_z, R_C_y, STEWART_FMA(M_ext_z, R_xz,
            STEWART_FMA(M_ext_y, R_xy, M_ext_x*R_xx))));
        c[4][l] = STEWART_FMA(-N_z, R_C_x, STEWART_FMA(N_x, R_C_z, STEWART_FMA(M_ext_z, R_yz,
            STEWART_FMA(M_ext_y, R_yy, M_ext_x*R_yx))));
        c[5][l] = STEWART_FMA(-N_x, R_C_y, STEWART_FMA(N_y, R_C_x, STEWART_FMA(M_ext_z, R_zz,
            STEWART_FMA(M_ext_y, R_zy, M_ext_x*R_zx))));
        stewart_real far = STEWART_LARGER(model->base_reach, STEWART_SHORTEST/STEWART_ROUNDING);
        far = STEWART_LARGER(STEWART_FABS(at->t[0][l]), far);
        far = STEWART_LARGER(STEWART_FABS(at->t[1][l]), far);
        far = STEWART_LARGER(STEWART_FABS(at->t[2][l]), far);
        out->least_L[l] = REAL(2.25)*STEWART_SHORT_SHARE*far;
    }
}

/* Computes a leg of the poses of a block up to its square roots, 46 (22 mul, 20 add, 2 div, 2 sqrt)
 * operations each. The roots of the next leg are computed before the other terms of a leg, so that no
 * leg waits for its roots. */
static void roots_of_leg(
    const stewart_exact_general_static_model *STEWART_RESTRICT model, int leg,
    const motion_lanes *STEWART_RESTRICT at, leg_roots *STEWART_RESTRICT out)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real p_x = model->p[0][leg], p_y = model->p[1][leg], p_z = model->p[2][leg];
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        /* (1) platform point from the reference point */
        const stewart_real q_x = STEWART_FMA(R_xz, p_z, STEWART_FMA(R_xy, p_y, R_xx*p_x));
        const stewart_real q_y = STEWART_FMA(R_yz, p_z, STEWART_FMA(R_yy, p_y, R_yx*p_x));
        const stewart_real q_z = STEWART_FMA(R_zz, p_z, STEWART_FMA(R_zy, p_y, R_zx*p_x));
        const stewart_real b_x = model->b[0][leg], b_y = model->b[1][leg], b_z = model->b[2][leg];
        const stewart_real t_x = at->t[0][l], t_y = at->t[1][l], t_z = at->t[2][l];
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
        out->q_x[l] = q_x;
        out->q_y[l] = q_y;
        out->q_z[l] = q_z;
        out->S_x[l] = S_x;
        out->S_y[l] = S_y;
        out->S_z[l] = S_z;
        out->zeta[l] = zeta;
        out->k_cross_S_x[l] = k_cross_S_x;
        out->k_cross_S_y[l] = k_cross_S_y;
        out->k_cross_S_z[l] = k_cross_S_z;
        out->L[l] = L;
        out->rho[l] = rho;
        out->inv_L[l] = inv_L;
        out->inv_rho[l] = inv_rho;
    }
}

/* Computes the rest of a leg, 42 (31 mul, 11 add, 0 div, 0 sqrt) operations each: its column of H, its
 * D, and its part of c. A leg is q + t - b, so a leg that is short compared with q is also short
 * compared with t or b. */
static void leg_of_block(
    const stewart_exact_general_static_model *STEWART_RESTRICT model, int leg,
    const motion_lanes *STEWART_RESTRICT at, const shared_lanes *STEWART_RESTRICT shared,
    const leg_roots *STEWART_RESTRICT roots, stewart_real (*STEWART_RESTRICT column)[POSES],
    leg_block *STEWART_RESTRICT own, stewart_real *STEWART_RESTRICT known,
    stewart_real *STEWART_RESTRICT bad)
{
    int l;
    (void)at;
    for (l = 0; l < POSES; ++l) {
        const stewart_real S_x = roots->S_x[l];
        const stewart_real S_y = roots->S_y[l];
        const stewart_real S_z = roots->S_z[l];
        const stewart_real inv_L = roots->inv_L[l];
        /* (3) unit vector along the leg */
        const stewart_real s_x = S_x*inv_L;
        const stewart_real s_y = S_y*inv_L;
        const stewart_real s_z = S_z*inv_L;
        const stewart_real k_cross_S_x = roots->k_cross_S_x[l];
        const stewart_real k_cross_S_y = roots->k_cross_S_y[l];
        const stewart_real k_cross_S_z = roots->k_cross_S_z[l];
        const stewart_real inv_rho = roots->inv_rho[l];
        /* (10) second axis of the leg frame */
        const stewart_real y_x = inv_rho*k_cross_S_x;
        const stewart_real y_y = inv_rho*k_cross_S_y;
        const stewart_real y_z = inv_rho*k_cross_S_z;
        const stewart_real zeta = roots->zeta[l];
        const stewart_real rho = roots->rho[l];
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1 = inv_L*zeta;
        const stewart_real k3 = inv_L*rho;
        const stewart_real g_x_k_x = model->g_x_k[0][leg], g_x_k_y = model->g_x_k[1][leg], g_x_k_z = model->g_x_k[2][leg];
        const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        const stewart_real w_x = model->w[0][leg], w_y = model->w[1][leg], w_z = model->w[2][leg];
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
        const stewart_real g_k = model->g_k[leg];
        /* (20) generalized forces about y and about k */
        const stewart_real tau_y = STEWART_FMA(gamma_n, w_k, g_k*w_n);
        const stewart_real tau_k = STEWART_FMA(-gamma_y, w_n, -gamma_n*w_y);
        /* (21) K = Q_k k + Q_y y, with a component along s */
        const stewart_real Q_k = -inv_rho*tau_y;
        const stewart_real Q_y = inv_rho*tau_k;
        const stewart_real k_x = model->k[0][leg], k_y = model->k[1][leg], k_z = model->k[2][leg];
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x = STEWART_FMA(Q_y, y_x, Q_k*k_x);
        const stewart_real K_y = STEWART_FMA(Q_y, y_y, Q_k*k_y);
        const stewart_real K_z = STEWART_FMA(Q_y, y_z, Q_k*k_z);
        /* (24) known part of the actuator force for this K */
        const stewart_real D = -Q_k*k1;
        const stewart_real q_x = roots->q_x[l];
        const stewart_real q_y = roots->q_y[l];
        const stewart_real q_z = roots->q_z[l];
        const stewart_real L = roots->L[l];
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
        stewart_real fault = L > shared->least_L[l] ? bad[l] : REAL(1);
        fault = k3 > STEWART_NEAR_JOINT_SINGULAR ? fault : REAL(1);
        bad[l] = fault;
    }
}

/* Loads the motions of a block of poses, component by component. */
STEWART_APART static void load_block(
    const stewart_motions *motions, size_t stride, size_t first, size_t count, motion_lanes *at)
{
    load_matrix(motions->R, stride, first, count, at->R);
    load_vector(motions->t, stride, first, count, at->t);
    load_vector(motions->F_ext, stride, first, count, at->F_ext);
    load_vector(motions->M_ext, stride, first, count, at->M_ext);
}

/* Computes the forces of a block of poses, and marks the poses that must be checked. */
static void forces_of_block(
    const stewart_exact_general_static_model *model, const motion_lanes *at, block *out)
{
    int i, l;
    shared_lanes shared;
    roots_of_legs roots;
    leg_block first;
    leg_block other;
    for (l = 0; l < POSES; ++l) {
        out->bad[l] = REAL(0);
    }
    roots_of_leg(model, 0, at, &roots.leg[0]);
    shared_of_block(model, at, &shared, out->column[6]);
    for (i = 0; i < 6; ++i) {
        if (i < 5) {
            roots_of_leg(model, i + 1, at, &roots.leg[i + 1]);
        }
        leg_of_block(model, i, at, &shared, &roots.leg[i], out->column[i], i == 0 ? &first : &other,
            out->D[i], out->bad);
        if (i == 0) {
            moments_of_first_without_moment(first.q, first.c_force, out->column[6]);
        } else {
            moments_of_block_without_moment(other.q, first.q, other.c_force, out->column[i],
                out->column[6]);
        }
    }
    if (model->per_length != REAL(1)) {
        scale_block(out->column, model->per_length);
    }
    solve_block(out->column, out->D, model->arm_cube, out->F, out->bad);
}

/* Computes the forces and the status of one pose of a block. */
static int forces_of(
    const stewart_exact_general_static_model *model, const motion_lanes *at, int l, stewart_real F[6])
{
    int i;
    stewart_motion one;
    for (i = 0; i < 9; ++i) {
        one.R[i] = at->R[i][l];
    }
    for (i = 0; i < 3; ++i) {
        one.t[i] = at->t[i][l];
        one.F_ext[i] = at->F_ext[i][l];
        one.M_ext[i] = at->M_ext[i][l];
    }
    return stewart_exact_general_static_forces(model, &one, F);
}

/* Computes the forces block by block. The arrays contain pose after pose if stride is 0, else columns. */
static int forces_of_poses(
    const stewart_exact_general_static_model *model, size_t count, size_t stride,
    const stewart_motions *motions, stewart_real *F, int *status)
{
    size_t first;
    int i, l;
    motion_lanes at;
    block done;
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
            if (done.bad[l] > REAL(0)) {
                code = forces_of(model, &at, l, found);
                if (code == STEWART_OK) {
                    done.bad[l] = REAL(0);
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
        store_forces(done.F, done.bad, stride, first, count, F);
    }
    return result;
}

int stewart_exact_general_static_forces_batch(
    const stewart_exact_general_static_model *model, size_t count, const stewart_motions *motions,
    stewart_real *F, int *status)
{
    if (model == NULL || motions == NULL || F == NULL || motions->R == NULL || motions->t == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    return forces_of_poses(model, count, 0, motions, F, status);
}

int stewart_exact_general_static_forces_columns(
    const stewart_exact_general_static_model *model, size_t count, size_t stride,
    const stewart_motions *motions, stewart_real *F, int *status)
{
    if (model == NULL || motions == NULL || F == NULL || motions->R == NULL || motions->t == NULL || stride < count) {
        return STEWART_BAD_ARGUMENT;
    }
    return forces_of_poses(model, count, stride, motions, F, status);
}
