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

/* Terms of a pose that are common to all legs. */
typedef struct {
    stewart_real B[9];
    stewart_real c_force[3];
    stewart_real c_moment[3];
    stewart_real c_tip[3];
} shared_terms;

typedef struct {
    stewart_real B[9][POSES];
    stewart_real least_L[POSES]; /* m: length below which a leg must be checked */
} STEWART_ALIGNED shared_lanes;

/* The legs of one pose. */
typedef struct {
    stewart_real A[6][LANES]; /* H, one column for each leg */
    stewart_real q[3][LANES];
    stewart_real D[LANES];
    stewart_real c_force[3][LANES];
    stewart_real c_moment[3][LANES];
    stewart_real arm_c[3][LANES];
    stewart_real L[LANES];
    stewart_real reach[LANES];
    stewart_real k3[LANES];
    stewart_real bad[LANES]; /* 1 if the leg must be checked, else 0 */
} leg_lanes;

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

/* Computes the terms of a pose that are common to all legs: 180 (93 mul, 87 add, 0 div, 0 sqrt)
 * operations. */
static void shared_of_pose(const stewart_exact_model *model, const stewart_motion *at, shared_terms *out)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real M_ext_x = at->M_ext[0], M_ext_y = at->M_ext[1], M_ext_z = at->M_ext[2];
    const stewart_real M_P = model->M_P;
    const stewart_real r_C_x = model->r_C[0], r_C_y = model->r_C[1], r_C_z = model->r_C[2];
    const stewart_real J_C_xx = model->J_C[0], J_C_xy = model->J_C[1], J_C_xz = model->J_C[2], J_C_yy = model->J_C[3],
        J_C_yz = model->J_C[4], J_C_zz = model->J_C[5];
    const stewart_real dJ_C_x = model->dJ_C[0], dJ_C_y = model->dJ_C[1], dJ_C_z = model->dJ_C[2];
    const stewart_real C_P = model->C_P;
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
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
    out->B[0] = B_xx;
    out->B[1] = B_xy;
    out->B[2] = B_xz;
    out->B[3] = B_yx;
    out->B[4] = B_yy;
    out->B[5] = B_yz;
    out->B[6] = B_zx;
    out->B[7] = B_zy;
    out->B[8] = B_zz;
    out->c_force[0] = STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy, STEWART_FMA(F_ext_x, R_xx,
        N_x)));
    out->c_force[1] = STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy, STEWART_FMA(F_ext_x, R_yx,
        N_y)));
    out->c_force[2] = STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy, STEWART_FMA(F_ext_x, R_zx,
        N_z)));
    out->c_moment[0] = STEWART_FMA(-N_y, R_C_z, STEWART_FMA(-C_P, omega_x, STEWART_FMA(N_z, R_C_y,
        STEWART_FMA(M_P_load_z, R_xz, STEWART_FMA(M_P_load_y, R_xy, M_P_load_x*R_xx)))));
    out->c_moment[1] = STEWART_FMA(-N_z, R_C_x, STEWART_FMA(-C_P, omega_y, STEWART_FMA(N_x, R_C_z,
        STEWART_FMA(M_P_load_z, R_yz, STEWART_FMA(M_P_load_y, R_yy, M_P_load_x*R_yx)))));
    out->c_moment[2] = STEWART_FMA(-N_x, R_C_y, STEWART_FMA(-C_P, omega_z, STEWART_FMA(N_y, R_C_x,
        STEWART_FMA(M_P_load_z, R_zz, STEWART_FMA(M_P_load_y, R_zy, M_P_load_x*R_zx)))));
}

/* Computes the legs of one pose in lanes: 265 (156 mul, 105 add, 2 div, 2 sqrt) operations each. */
static void legs_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const shared_terms *STEWART_RESTRICT shared, leg_lanes *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real B_xx = shared->B[0], B_xy = shared->B[1], B_xz = shared->B[2], B_yx = shared->B[3],
        B_yy = shared->B[4], B_yz = shared->B[5], B_zx = shared->B[6], B_zy = shared->B[7], B_zz = shared->B[8];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real h2_y = model->h2_y[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_yy = model->J[3][l], J_yz = model->J[4][l];
        const stewart_real J2_xz = model->J2_xz[l];
        const stewart_real dJ_zx = model->dJ_zx[l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l], g_x_k_z = model->g_x_k[2][l];
        const stewart_real C_us = model->C_us[l];
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
        const stewart_real D = STEWART_FMA(-Q_k, k1, STEWART_FMA(-k3_h, phi_ddot, STEWART_FMA(h_z,
            theta_ddot, STEWART_FMA(-M_phi_L, phi_dot2, STEWART_FMA(-h_x, theta_dot2, C_p*L_dot)))));
        const stewart_real c1 = C_s*phi_dot;
        const stewart_real c2 = C_s*theta_dot;
        out->D[l] = D;
        out->A[0][l] = s_x;
        out->A[1][l] = s_y;
        out->A[2][l] = s_z;
        out->c_force[0][l] = -K_x;
        out->c_force[1][l] = -K_y;
        out->c_force[2][l] = -K_z;
        out->c_moment[0][l] = STEWART_FMA(c2, y_x, c1*k_x);
        out->c_moment[1][l] = STEWART_FMA(c2, y_y, c1*k_y);
        out->c_moment[2][l] = STEWART_FMA(c2, y_z, c1*k_z);
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

/* Computes the legs of a pose in which a leg is near its joint singularity: 289 (173 mul, 112 add, 2
 * div, 2 sqrt) operations each. */
static void legs_near_singular(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const shared_terms *STEWART_RESTRICT shared, leg_lanes *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real B_xx = shared->B[0], B_xy = shared->B[1], B_xz = shared->B[2], B_yx = shared->B[3],
        B_yy = shared->B[4], B_yz = shared->B[5], B_zx = shared->B[6], B_zy = shared->B[7], B_zz = shared->B[8];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real h2_y = model->h2_y[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_yy = model->J[3][l], J_yz = model->J[4][l];
        const stewart_real J2_xz = model->J2_xz[l];
        const stewart_real dJ_zx = model->dJ_zx[l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l], g_x_k_z = model->g_x_k[2][l];
        const stewart_real C_us = model->C_us[l];
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
        const stewart_real theta_dot = -inv_L*STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y,
            S_dot_x*z_x));
        /* L_dot / L */
        const stewart_real L_share = L_dot*inv_L;
        const stewart_real lean = kappa*theta_dot;
        const stewart_real theta_dot2 = theta_dot*theta_dot;
        const stewart_real phi_dot2 = phi_dot*phi_dot;
        const stewart_real two_phi_dot = REAL(2)*phi_dot;
        const stewart_real k33 = k3*k3;
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y,
            STEWART_FMA(S_ddot_x, s_x, L*STEWART_FMA(k33, phi_dot2, theta_dot2))));
        /* (9) accelerations of the joint coordinates without the rotation of the leg frame about s */
        const stewart_real own_theta_ddot = STEWART_FMA(REAL(2)*L_share, -theta_dot,
            -inv_L*STEWART_FMA(S_ddot_z, z_z, STEWART_FMA(S_ddot_y, z_y, S_ddot_x*z_x)));
        const stewart_real own_phi_ddot = STEWART_FMA(-L_share, two_phi_dot, inv_rho*STEWART_FMA(S_ddot_z,
            y_z, STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)));
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
        const stewart_real bend = L_dot*theta_dot;
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
        /* (20) generalized forces about y and about k */
        const stewart_real tau_y = STEWART_FMA(M_mixed, phi_ddot, STEWART_FMA(M_theta, own_theta_ddot,
            STEWART_FMA(-C_s, STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x)),
            STEWART_FMA(gamma_n, w_k, STEWART_FMA(bend, h2_x, STEWART_FMA(C_us, theta_dot,
            STEWART_FMA(phi_dot2, STEWART_FMA(-c3, STEWART_HALF - k33, k13*(J_yy - dJ_zx)), STEWART_FMA(g_k,
            w_n, L_ddot*h_z))))))));
        const stewart_real tau_k = STEWART_FMA(M_phi, own_phi_ddot, STEWART_FMA(M_mixed, theta_ddot,
            STEWART_FMA(bend*h2_y, -k1, STEWART_FMA(two_phi_dot, STEWART_FMA(-theta_dot, STEWART_FMA(J_xx,
            kappa, STEWART_FMA(STEWART_HALF, -c2, STEWART_HALF*J2_xz)), L_dot*M_phi_L),
            STEWART_FMA(-gamma_y, w_n, STEWART_FMA(-gamma_n, w_y, STEWART_FMA(C_us, phi_dot,
            STEWART_FMA(-L_ddot, k3_h, STEWART_FMA(-C_s, STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y,
            k_x*omega_x)), M_mixed_theta*theta_dot2)))))))));
        /* (21) K = Q_y y + Q_z z */
        const stewart_real Q_y = inv_rho*tau_k;
        const stewart_real Q_z = -inv_L*tau_y;
        /* (21) force at the spherical joint, base frame */
        const stewart_real K_x = STEWART_FMA(Q_z, z_x, Q_y*y_x);
        const stewart_real K_y = STEWART_FMA(Q_z, z_y, Q_y*y_y);
        const stewart_real K_z = STEWART_FMA(Q_z, z_z, Q_y*y_z);
        /* (24) known part of the actuator force for this K */
        const stewart_real D = STEWART_FMA(-k3_h, phi_ddot, STEWART_FMA(h_z, theta_ddot,
            STEWART_FMA(-M_phi_L, phi_dot2, STEWART_FMA(-h_x, theta_dot2, C_p*L_dot))));
        const stewart_real c4 = C_s*phi_dot;
        const stewart_real c5 = C_s*theta_dot;
        out->D[l] = D;
        out->A[0][l] = s_x;
        out->A[1][l] = s_y;
        out->A[2][l] = s_z;
        out->c_force[0][l] = -K_x;
        out->c_force[1][l] = -K_y;
        out->c_force[2][l] = -K_z;
        out->c_moment[0][l] = STEWART_FMA(c5, y_x, c4*k_x);
        out->c_moment[1][l] = STEWART_FMA(c5, y_y, c4*k_y);
        out->c_moment[2][l] = STEWART_FMA(c5, y_z, c4*k_z);
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

int stewart_exact_forces(const stewart_exact_model *model, const stewart_motion *motion, stewart_real F[6])
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
            turn = turn + legs.c_moment[j][i];
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
    stewart_real c_moment[3][POSES];
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
    const stewart_exact_model *STEWART_RESTRICT model, const motion_lanes *STEWART_RESTRICT at,
    shared_lanes *STEWART_RESTRICT out, stewart_real (*STEWART_RESTRICT c)[POSES])
{
    int l;
    const stewart_real M_P = model->M_P;
    const stewart_real r_C_x = model->r_C[0], r_C_y = model->r_C[1], r_C_z = model->r_C[2];
    const stewart_real J_C_xx = model->J_C[0], J_C_xy = model->J_C[1], J_C_xz = model->J_C[2], J_C_yy = model->J_C[3],
        J_C_yz = model->J_C[4], J_C_zz = model->J_C[5];
    const stewart_real dJ_C_x = model->dJ_C[0], dJ_C_y = model->dJ_C[1], dJ_C_z = model->dJ_C[2];
    const stewart_real C_P = model->C_P;
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < POSES; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        const stewart_real alpha_x = at->alpha[0][l], alpha_y = at->alpha[1][l], alpha_z = at->alpha[2][l];
        const stewart_real a_x = at->a[0][l], a_y = at->a[1][l], a_z = at->a[2][l];
        const stewart_real F_ext_x = at->F_ext[0][l], F_ext_y = at->F_ext[1][l], F_ext_z = at->F_ext[2][l];
        const stewart_real M_ext_x = at->M_ext[0][l], M_ext_y = at->M_ext[1][l], M_ext_z = at->M_ext[2][l];
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
        out->B[0][l] = B_xx;
        out->B[1][l] = B_xy;
        out->B[2][l] = B_xz;
        out->B[3][l] = B_yx;
        out->B[4][l] = B_yy;
        out->B[5][l] = B_yz;
        out->B[6][l] = B_zx;
        out->B[7][l] = B_zy;
        out->B[8][l] = B_zz;
        c[0][l] = STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy, STEWART_FMA(F_ext_x, R_xx, N_x)));
        c[1][l] = STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy, STEWART_FMA(F_ext_x, R_yx, N_y)));
        c[2][l] = STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy, STEWART_FMA(F_ext_x, R_zx, N_z)));
        c[3][l] = STEWART_FMA(-N_y, R_C_z, STEWART_FMA(C_P, -omega_x, STEWART_FMA(N_z, R_C_y,
            STEWART_FMA(M_P_load_z, R_xz, STEWART_FMA(M_P_load_y, R_xy, M_P_load_x*R_xx)))));
        c[4][l] = STEWART_FMA(-N_z, R_C_x, STEWART_FMA(C_P, -omega_y, STEWART_FMA(N_x, R_C_z,
            STEWART_FMA(M_P_load_z, R_yz, STEWART_FMA(M_P_load_y, R_yy, M_P_load_x*R_yx)))));
        c[5][l] = STEWART_FMA(-N_x, R_C_y, STEWART_FMA(C_P, -omega_z, STEWART_FMA(N_y, R_C_x,
            STEWART_FMA(M_P_load_z, R_zz, STEWART_FMA(M_P_load_y, R_zy, M_P_load_x*R_zx)))));
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
    const stewart_exact_model *STEWART_RESTRICT model, int leg, const motion_lanes *STEWART_RESTRICT at,
    leg_roots *STEWART_RESTRICT out)
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

/* Computes the rest of a leg, 219 (134 mul, 85 add, 0 div, 0 sqrt) operations each: its column of H, its
 * D, and its part of c. A leg is q + t - b, so a leg that is short compared with q is also short
 * compared with t or b. */
static void leg_of_block(
    const stewart_exact_model *STEWART_RESTRICT model, int leg, const motion_lanes *STEWART_RESTRICT at,
    const shared_lanes *STEWART_RESTRICT shared, const leg_roots *STEWART_RESTRICT roots,
    stewart_real (*STEWART_RESTRICT column)[POSES], leg_block *STEWART_RESTRICT own,
    stewart_real *STEWART_RESTRICT known, stewart_real *STEWART_RESTRICT bad)
{
    int l;
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
        /* (10) k1 / k3 */
        const stewart_real kappa = inv_rho*zeta;
        const stewart_real q_x = roots->q_x[l];
        const stewart_real q_y = roots->q_y[l];
        const stewart_real q_z = roots->q_z[l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        const stewart_real v_x = at->v[0][l], v_y = at->v[1][l], v_z = at->v[2][l];
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = STEWART_FMA(-omega_z, q_y, STEWART_FMA(omega_y, q_z, v_x));
        const stewart_real S_dot_y = STEWART_FMA(-omega_x, q_z, STEWART_FMA(omega_z, q_x, v_y));
        const stewart_real S_dot_z = STEWART_FMA(-omega_y, q_x, STEWART_FMA(omega_x, q_y, v_z));
        const stewart_real a_x = at->a[0][l], a_y = at->a[1][l], a_z = at->a[2][l];
        const stewart_real B_xx = shared->B[0][l], B_xy = shared->B[1][l], B_xz = shared->B[2][l], B_yx = shared->B[3][l],
            B_yy = shared->B[4][l], B_yz = shared->B[5][l], B_zx = shared->B[6][l], B_zy = shared->B[7][l],
            B_zz = shared->B[8][l];
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
        const stewart_real L = roots->L[l];
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y,
            STEWART_FMA(S_ddot_x, s_x, L*STEWART_FMA(k33, phi_dot2, theta_dot2))));
        const stewart_real h_x = model->h[0][leg], h_y = model->h[1][leg], h_z = model->h[2][leg];
        const stewart_real h2_x = model->h2_x[leg];
        const stewart_real h2_z = model->h2_z[leg];
        const stewart_real J_xx = model->J[0][leg], J_xy = model->J[1][leg], J_yy = model->J[3][leg], J_yz = model->J[4][leg];
        const stewart_real J2_xz = model->J2_xz[leg];
        const stewart_real dJ_zx = model->dJ_zx[leg];
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
        const stewart_real w_x = model->w[0][leg], w_y = model->w[1][leg], w_z = model->w[2][leg];
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
        const stewart_real C_s = model->C_s[leg];
        const stewart_real h2_y = model->h2_y[leg];
        const stewart_real g_k = model->g_k[leg];
        const stewart_real C_us = model->C_us[leg];
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
        /* (24) known part of the actuator force for this K */
        const stewart_real D = STEWART_FMA(-Q_k, k1, STEWART_FMA(-k3_h, phi_ddot, STEWART_FMA(h_z,
            theta_ddot, STEWART_FMA(-M_phi_L, phi_dot2, STEWART_FMA(h_x, -theta_dot2, C_p*L_dot)))));
        const stewart_real c1 = C_s*phi_dot;
        const stewart_real c2 = C_s*theta_dot;
        column[0][l] = s_x;
        column[1][l] = s_y;
        column[2][l] = s_z;
        own->q[0][l] = q_x;
        own->q[1][l] = q_y;
        own->q[2][l] = q_z;
        own->c_force[0][l] = -K_x;
        own->c_force[1][l] = -K_y;
        own->c_force[2][l] = -K_z;
        own->c_moment[0][l] = STEWART_FMA(c2, y_x, c1*k_x);
        own->c_moment[1][l] = STEWART_FMA(c2, y_y, c1*k_y);
        own->c_moment[2][l] = STEWART_FMA(c2, y_z, c1*k_z);
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
    load_vector(motions->omega, stride, first, count, at->omega);
    load_vector(motions->v, stride, first, count, at->v);
    load_vector(motions->alpha, stride, first, count, at->alpha);
    load_vector(motions->a, stride, first, count, at->a);
    load_vector(motions->F_ext, stride, first, count, at->F_ext);
    load_vector(motions->M_ext, stride, first, count, at->M_ext);
}

/* Computes the forces of a block of poses, and marks the poses that must be checked. */
static void forces_of_block(const stewart_exact_model *model, const motion_lanes *at, block *out)
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
            moments_of_first(first.q, first.c_force, first.c_moment, out->column[6]);
        } else {
            moments_of_block(other.q, first.q, other.c_force, other.c_moment, out->column[i],
                out->column[6]);
        }
    }
    if (model->per_length != REAL(1)) {
        scale_block(out->column, model->per_length);
    }
    solve_block(out->column, out->D, model->arm_cube, out->F, out->bad);
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
