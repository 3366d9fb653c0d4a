/* stewart_exact_spherical_drive_forces.c: functions that are declared and described in stewart_exact_spherical_drive_forces.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_exact_spherical_drive_forces.h"

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
    stewart_real bad[LANES]; /* 1 if the leg must be checked, else 0 */
} leg_lanes;

/* Constants of one leg, and its contributions to the constants of the platform. */
static void prepare_leg(
    const stewart_robot *robot, const stewart_leg *leg, int i, stewart_exact_spherical_drive_model *out,
    lumped_terms *added)
{
    (void)robot;
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
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
    out->b[0][i] = b_x;
    out->b[1][i] = b_y;
    out->b[2][i] = b_z;
    out->p[0][i] = p_x;
    out->p[1][i] = p_y;
    out->p[2][i] = p_z;
    out->m_d[i] = m_d;
    out->r_d0[0][i] = r_d0_x;
    out->r_d0[1][i] = r_d0_y;
    out->r_d0[2][i] = r_d0_z;
    out->I_d0[0][i] = I_d0_xx;
    out->I_d0[1][i] = I_d0_xy;
    out->I_d0[2][i] = I_d0_xz;
    out->I_d0[3][i] = I_d0_yy;
    out->I_d0[4][i] = I_d0_yz;
    out->I_d0[5][i] = I_d0_zz;
    out->m_u[i] = m_u;
    out->r_u0[0][i] = r_u0_x;
    out->r_u0[1][i] = r_u0_y;
    out->r_u0[2][i] = r_u0_z;
    out->I_u0[0][i] = I_u0_xx;
    out->I_u0[1][i] = I_u0_xy;
    out->I_u0[2][i] = I_u0_xz;
    out->I_u0[3][i] = I_u0_yy;
    out->I_u0[4][i] = I_u0_yz;
    out->I_u0[5][i] = I_u0_zz;
    out->C_u[i] = C_u;
    out->C_p[i] = C_p;
    out->C_s[i] = C_s;
    out->m_r[i] = m_r;
    added->M_add = REAL(0);
    added->h_add[0] = REAL(0);
    added->h_add[1] = REAL(0);
    added->h_add[2] = REAL(0);
    added->J_add[0] = REAL(0);
    added->J_add[1] = REAL(0);
    added->J_add[2] = REAL(0);
    added->J_add[3] = REAL(0);
    added->J_add[4] = REAL(0);
    added->J_add[5] = REAL(0);
    added->C_add = REAL(0);
}

/* Constants of the platform. */
static void prepare_platform(
    const stewart_robot *robot, const lumped_terms *sum, stewart_exact_spherical_drive_model *out)
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
    out->g[0] = g_x;
    out->g[1] = g_y;
    out->g[2] = g_z;
}

/* Returns the largest coordinate (m) of the arms of moments about platform point 1. */
static stewart_real size_of(const stewart_exact_spherical_drive_model *model)
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

int stewart_exact_spherical_drive_prepare(
    const stewart_robot *robot, stewart_exact_spherical_drive_model *model)
{
    int i, j;
    stewart_exact_spherical_drive_model made;
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
    for (i = 0; i < 259; ++i) {
        if (!(STEWART_FABS(numbers[i]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    *model = made;
    return STEWART_OK;
}

/* Computes the terms of a pose that are common to all legs: 174 (90 mul, 84 add, 0 div, 0 sqrt)
 * operations. */
static void shared_of_pose(
    const stewart_exact_spherical_drive_model *model, const stewart_motion *at, shared_terms *out)
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
    out->c_moment[0] = STEWART_FMA(-N_y, R_C_z, STEWART_FMA(N_z, R_C_y, STEWART_FMA(M_P_load_z, R_xz,
        STEWART_FMA(M_P_load_y, R_xy, M_P_load_x*R_xx))));
    out->c_moment[1] = STEWART_FMA(-N_z, R_C_x, STEWART_FMA(N_x, R_C_z, STEWART_FMA(M_P_load_z, R_yz,
        STEWART_FMA(M_P_load_y, R_yy, M_P_load_x*R_yx))));
    out->c_moment[2] = STEWART_FMA(-N_x, R_C_y, STEWART_FMA(N_y, R_C_x, STEWART_FMA(M_P_load_z, R_zz,
        STEWART_FMA(M_P_load_y, R_zy, M_P_load_x*R_zx))));
}

/* Computes the legs of one pose in lanes: 226 (131 mul, 93 add, 1 div, 1 sqrt) operations each. */
static void legs_of_pose(
    const stewart_exact_spherical_drive_model *STEWART_RESTRICT model,
    const stewart_motion *STEWART_RESTRICT at, const shared_terms *STEWART_RESTRICT shared,
    leg_lanes *STEWART_RESTRICT out)
{
    int l;
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real B_xx = shared->B[0], B_xy = shared->B[1], B_xz = shared->B[2], B_yx = shared->B[3],
        B_yy = shared->B[4], B_yz = shared->B[5], B_zx = shared->B[6], B_zy = shared->B[7], B_zz = shared->B[8];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real m_d = model->m_d[l];
        const stewart_real r_d0_x = model->r_d0[0][l];
        const stewart_real I_d0_yy = model->I_d0[3][l];
        const stewart_real m_u = model->m_u[l];
        const stewart_real r_u0_x = model->r_u0[0][l];
        const stewart_real I_u0_yy = model->I_u0[3][l];
        const stewart_real C_u = model->C_u[l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real m_r = model->m_r[l];
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
        /* (2) leg length */
        const stewart_real L = STEWART_SQRT(STEWART_FMA(S_z, S_z, STEWART_FMA(S_y, S_y, S_x*S_x)));
        const stewart_real inv_L = REAL(1)/L;
        /* (3) unit vector along the leg */
        const stewart_real s_x = S_x*inv_L;
        const stewart_real s_y = S_y*inv_L;
        const stewart_real s_z = S_z*inv_L;
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(omega_z, -q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(omega_x, -q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(omega_y, -q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
        /* (7) acceleration of the platform point */
        const stewart_real S_ddot_x = STEWART_FMA(B_xz, q_z, STEWART_FMA(B_xy, q_y, STEWART_FMA(B_xx, q_x,
            a_x)));
        const stewart_real S_ddot_y = STEWART_FMA(B_yz, q_z, STEWART_FMA(B_yy, q_y, STEWART_FMA(B_yx, q_x,
            a_y)));
        const stewart_real S_ddot_z = STEWART_FMA(B_zz, q_z, STEWART_FMA(B_zy, q_y, STEWART_FMA(B_zx, q_x,
            a_z)));
        /* part of e along the leg */
        const stewart_real e_x = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y, S_ddot_x*s_x));
        /* part of u along the leg */
        const stewart_real u_x = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
        /* part of gamma along the leg */
        const stewart_real gamma_x = STEWART_FMA(g_z, s_z, STEWART_FMA(g_y, s_y, g_x*s_x));
        /* part of w along the leg */
        const stewart_real w_x = STEWART_FMA(omega_z, s_z, STEWART_FMA(omega_y, s_y, omega_x*s_x));
        /* part of e across the leg */
        const stewart_real e_across_x = STEWART_FMA(-e_x, s_x, S_ddot_x);
        const stewart_real e_across_y = STEWART_FMA(-e_x, s_y, S_ddot_y);
        const stewart_real e_across_z = STEWART_FMA(-e_x, s_z, S_ddot_z);
        /* part of u across the leg */
        const stewart_real u_across_x = STEWART_FMA(-s_x, u_x, S_dot_x);
        const stewart_real u_across_y = STEWART_FMA(-s_y, u_x, S_dot_y);
        const stewart_real u_across_z = STEWART_FMA(-s_z, u_x, S_dot_z);
        /* part of gamma across the leg */
        const stewart_real gamma_across_x = STEWART_FMA(-gamma_x, s_x, g_x);
        const stewart_real gamma_across_y = STEWART_FMA(-gamma_x, s_y, g_y);
        const stewart_real gamma_across_z = STEWART_FMA(-gamma_x, s_z, g_z);
        const stewart_real c1 = s_x*w_x;
        const stewart_real c2 = s_y*w_x;
        const stewart_real c3 = s_z*w_x;
        /* part of w across the leg */
        const stewart_real w_across_x = omega_x - c1;
        const stewart_real w_across_y = omega_y - c2;
        const stewart_real w_across_z = omega_z - c3;
        /* square of u across the leg */
        const stewart_real u_square = STEWART_FMA(u_across_z, u_across_z, STEWART_FMA(u_across_y,
            u_across_y, u_across_x*u_across_x));
        const stewart_real c4 = inv_L*inv_L;
        const stewart_real c5 = c4*u_square;
        const stewart_real c6 = m_u*r_u0_x;
        /* (24) known part of the actuator force */
        const stewart_real D = STEWART_FMA(e_x, m_u, STEWART_FMA(e_x, m_r, STEWART_FMA(C_p, u_x,
            STEWART_FMA(-gamma_x, m_u, STEWART_FMA(-c5, c6, L*c5*m_r)))));
        const stewart_real c7 = m_u*L*L;
        const stewart_real c8 = m_d*r_d0_x*r_d0_x;
        const stewart_real c9 = m_u*r_u0_x*r_u0_x;
        const stewart_real c10 = L*m_u;
        const stewart_real K_e = c4*STEWART_FMA(REAL(2)*c10, r_u0_x, I_d0_yy + I_u0_yy + c7 + c8 + c9);
        const stewart_real c11 = REAL(2)*inv_L*u_x;
        const stewart_real K_u = c4*STEWART_FMA(-c11, c9, STEWART_FMA(-c11, c8, STEWART_FMA(-c11, c7,
            STEWART_FMA(REAL(4)*c10*inv_L*r_u0_x, -u_x, STEWART_FMA(-I_u0_yy, c11, STEWART_FMA(-I_d0_yy,
            c11, STEWART_FMA(REAL(2)*m_u*r_u0_x, u_x, STEWART_FMA(REAL(2)*L*m_u, u_x, C_s + C_u))))))));
        const stewart_real K_gamma = -inv_L*(STEWART_FMA(m_d, r_d0_x, c6) + c10);
        const stewart_real c12 = C_s*inv_L;
        const stewart_real K_s_w = c12;
        /* K, base frame */
        const stewart_real K_x = STEWART_FMA(K_u, u_across_x, STEWART_FMA(K_s_w, STEWART_FMA(-s_z,
            w_across_y, s_y*w_across_z), STEWART_FMA(K_e, e_across_x, K_gamma*gamma_across_x)));
        const stewart_real K_y = STEWART_FMA(K_u, u_across_y, STEWART_FMA(K_s_w, STEWART_FMA(-s_x,
            w_across_z, s_z*w_across_x), STEWART_FMA(K_e, e_across_y, K_gamma*gamma_across_y)));
        const stewart_real K_z = STEWART_FMA(K_u, u_across_z, STEWART_FMA(K_s_w, STEWART_FMA(-s_y,
            w_across_x, s_x*w_across_y), STEWART_FMA(K_e, e_across_z, K_gamma*gamma_across_z)));
        const stewart_real f_s_u = c12;
        /* f, base frame */
        const stewart_real f_x = STEWART_FMA(-C_s, w_across_x, STEWART_FMA(-C_s, c1, f_s_u*STEWART_FMA(-s_z,
            u_across_y, s_y*u_across_z)));
        const stewart_real f_y = STEWART_FMA(-C_s, w_across_y, STEWART_FMA(-C_s, c2, f_s_u*STEWART_FMA(-s_x,
            u_across_z, s_z*u_across_x)));
        const stewart_real f_z = STEWART_FMA(-C_s, w_across_z, STEWART_FMA(-C_s, c3, f_s_u*STEWART_FMA(-s_y,
            u_across_x, s_x*u_across_y)));
        out->D[l] = D;
        out->A[0][l] = s_x;
        out->A[1][l] = s_y;
        out->A[2][l] = s_z;
        out->c_force[0][l] = -K_x;
        out->c_force[1][l] = -K_y;
        out->c_force[2][l] = -K_z;
        out->c_moment[0][l] = f_x;
        out->c_moment[1][l] = f_y;
        out->c_moment[2][l] = f_z;
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
        stewart_real fault = L > STEWART_SHORT_SHARE*reach ? REAL(0) : REAL(1);
        fault = L <= STEWART_MAX ? fault : REAL(1);
        out->bad[l] = fault;
    }
}

int stewart_exact_spherical_drive_forces(
    const stewart_exact_spherical_drive_model *model, const stewart_motion *motion, stewart_real F[6])
{
    int i, j;
    shared_terms shared;
    leg_lanes legs;
    stewart_real wrench[6];
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
            const int status = fault_of(legs.L[i], REAL(1), legs.reach[i]);
            if (status != STEWART_OK) {
                return status;
            }
            close = legs.L[i] > STEWART_SHORT_SHARE*legs.reach[i] ? close : 1;
        }
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
    stewart_real L[POSES];
    stewart_real inv_L[POSES];
} STEWART_ALIGNED leg_roots;

typedef struct {
    leg_roots leg[6];
} STEWART_ALIGNED roots_of_legs;

/* Computes the terms that are common to all legs, and the platform's part of c, of a block of poses. */
static void shared_of_block(
    const stewart_exact_spherical_drive_model *STEWART_RESTRICT model,
    const motion_lanes *STEWART_RESTRICT at, shared_lanes *STEWART_RESTRICT out,
    stewart_real (*STEWART_RESTRICT c)[POSES])
{
    int l;
    const stewart_real M_P = model->M_P;
    const stewart_real r_C_x = model->r_C[0], r_C_y = model->r_C[1], r_C_z = model->r_C[2];
    const stewart_real J_C_xx = model->J_C[0], J_C_xy = model->J_C[1], J_C_xz = model->J_C[2], J_C_yy = model->J_C[3],
        J_C_yz = model->J_C[4], J_C_zz = model->J_C[5];
    const stewart_real dJ_C_x = model->dJ_C[0], dJ_C_y = model->dJ_C[1], dJ_C_z = model->dJ_C[2];
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
        c[3][l] = STEWART_FMA(-N_y, R_C_z, STEWART_FMA(N_z, R_C_y, STEWART_FMA(M_P_load_z, R_xz,
            STEWART_FMA(M_P_load_y, R_xy, M_P_load_x*R_xx))));
        c[4][l] = STEWART_FMA(-N_z, R_C_x, STEWART_FMA(N_x, R_C_z, STEWART_FMA(M_P_load_z, R_yz,
            STEWART_FMA(M_P_load_y, R_yy, M_P_load_x*R_yx))));
        c[5][l] = STEWART_FMA(-N_x, R_C_y, STEWART_FMA(N_y, R_C_x, STEWART_FMA(M_P_load_z, R_zz,
            STEWART_FMA(M_P_load_y, R_zy, M_P_load_x*R_zx))));
        stewart_real far = STEWART_LARGER(model->base_reach, STEWART_SHORTEST/STEWART_ROUNDING);
        far = STEWART_LARGER(STEWART_FABS(at->t[0][l]), far);
        far = STEWART_LARGER(STEWART_FABS(at->t[1][l]), far);
        far = STEWART_LARGER(STEWART_FABS(at->t[2][l]), far);
        out->least_L[l] = REAL(2.25)*STEWART_SHORT_SHARE*far;
    }
}

/* Computes a leg of the poses of a block up to its square roots, 28 (12 mul, 14 add, 1 div, 1 sqrt)
 * operations each. The roots of the next leg are computed before the other terms of a leg, so that no
 * leg waits for its roots. */
static void roots_of_leg(
    const stewart_exact_spherical_drive_model *STEWART_RESTRICT model, int leg,
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
        /* (2) leg length */
        const stewart_real L = STEWART_SQRT(STEWART_FMA(S_z, S_z, STEWART_FMA(S_y, S_y, S_x*S_x)));
        const stewart_real inv_L = REAL(1)/L;
        out->q_x[l] = q_x;
        out->q_y[l] = q_y;
        out->q_z[l] = q_z;
        out->S_x[l] = S_x;
        out->S_y[l] = S_y;
        out->S_z[l] = S_z;
        out->L[l] = L;
        out->inv_L[l] = inv_L;
    }
}

/* Computes the rest of a leg, 198 (119 mul, 79 add, 0 div, 0 sqrt) operations each: its column of H, its
 * D, and its part of c. A leg is q + t - b, so a leg that is short compared with q is also short
 * compared with t or b. */
static void leg_of_block(
    const stewart_exact_spherical_drive_model *STEWART_RESTRICT model, int leg,
    const motion_lanes *STEWART_RESTRICT at, const shared_lanes *STEWART_RESTRICT shared,
    const leg_roots *STEWART_RESTRICT roots, stewart_real (*STEWART_RESTRICT column)[POSES],
    leg_block *STEWART_RESTRICT own, stewart_real *STEWART_RESTRICT known,
    stewart_real *STEWART_RESTRICT bad)
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
        const stewart_real q_x = roots->q_x[l];
        const stewart_real q_y = roots->q_y[l];
        const stewart_real q_z = roots->q_z[l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(-omega_z, q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(-omega_x, q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(-omega_y, q_x, omega_x*q_y);
        const stewart_real v_x = at->v[0][l], v_y = at->v[1][l], v_z = at->v[2][l];
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
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
        /* part of e along the leg */
        const stewart_real e_x = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y, S_ddot_x*s_x));
        /* part of u along the leg */
        const stewart_real u_x = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
        const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
        /* part of gamma along the leg */
        const stewart_real gamma_x = STEWART_FMA(g_z, s_z, STEWART_FMA(g_y, s_y, g_x*s_x));
        /* part of w along the leg */
        const stewart_real w_x = STEWART_FMA(omega_z, s_z, STEWART_FMA(omega_y, s_y, omega_x*s_x));
        /* part of e across the leg */
        const stewart_real e_across_x = STEWART_FMA(-e_x, s_x, S_ddot_x);
        const stewart_real e_across_y = STEWART_FMA(-e_x, s_y, S_ddot_y);
        const stewart_real e_across_z = STEWART_FMA(-e_x, s_z, S_ddot_z);
        /* part of u across the leg */
        const stewart_real u_across_x = STEWART_FMA(-s_x, u_x, S_dot_x);
        const stewart_real u_across_y = STEWART_FMA(-s_y, u_x, S_dot_y);
        const stewart_real u_across_z = STEWART_FMA(-s_z, u_x, S_dot_z);
        /* part of gamma across the leg */
        const stewart_real gamma_across_x = STEWART_FMA(-gamma_x, s_x, g_x);
        const stewart_real gamma_across_y = STEWART_FMA(-gamma_x, s_y, g_y);
        const stewart_real gamma_across_z = STEWART_FMA(-gamma_x, s_z, g_z);
        const stewart_real c1 = s_x*w_x;
        const stewart_real c2 = s_y*w_x;
        const stewart_real c3 = s_z*w_x;
        /* part of w across the leg */
        const stewart_real w_across_x = omega_x - c1;
        const stewart_real w_across_y = omega_y - c2;
        const stewart_real w_across_z = omega_z - c3;
        const stewart_real m_u = model->m_u[leg];
        const stewart_real r_u0_x = model->r_u0[0][leg];
        /* square of u across the leg */
        const stewart_real u_square = STEWART_FMA(u_across_z, u_across_z, STEWART_FMA(u_across_y,
            u_across_y, u_across_x*u_across_x));
        const stewart_real c4 = inv_L*inv_L;
        const stewart_real c5 = c4*u_square;
        const stewart_real c6 = m_u*r_u0_x;
        const stewart_real L = roots->L[l];
        const stewart_real m_d = model->m_d[leg];
        const stewart_real r_d0_x = model->r_d0[0][leg];
        const stewart_real I_d0_yy = model->I_d0[3][leg];
        const stewart_real I_u0_yy = model->I_u0[3][leg];
        const stewart_real C_u = model->C_u[leg];
        const stewart_real C_p = model->C_p[leg];
        const stewart_real C_s = model->C_s[leg];
        const stewart_real m_r = model->m_r[leg];
        /* (24) known part of the actuator force */
        const stewart_real D = STEWART_FMA(e_x, m_u, STEWART_FMA(e_x, m_r, STEWART_FMA(C_p, u_x,
            STEWART_FMA(-gamma_x, m_u, STEWART_FMA(-c5, c6, L*c5*m_r)))));
        const stewart_real c7 = m_u*L*L;
        const stewart_real c8 = m_d*r_d0_x*r_d0_x;
        const stewart_real c9 = m_u*r_u0_x*r_u0_x;
        const stewart_real c10 = L*m_u;
        const stewart_real K_e = c4*STEWART_FMA(REAL(2)*c10, r_u0_x, I_d0_yy + I_u0_yy + c7 + c8 + c9);
        const stewart_real c11 = REAL(2)*inv_L*u_x;
        const stewart_real K_u = c4*STEWART_FMA(-c11, c9, STEWART_FMA(-c11, c8, STEWART_FMA(-c11, c7,
            STEWART_FMA(REAL(4)*c10*inv_L*r_u0_x, -u_x, STEWART_FMA(I_u0_yy, -c11, STEWART_FMA(I_d0_yy,
            -c11, STEWART_FMA(REAL(2)*m_u*r_u0_x, u_x, STEWART_FMA(REAL(2)*L*m_u, u_x, C_s + C_u))))))));
        const stewart_real K_gamma = -inv_L*(STEWART_FMA(m_d, r_d0_x, c6) + c10);
        const stewart_real c12 = C_s*inv_L;
        const stewart_real K_s_w = c12;
        /* K, base frame */
        const stewart_real K_x = STEWART_FMA(K_u, u_across_x, STEWART_FMA(K_s_w, STEWART_FMA(-s_z,
            w_across_y, s_y*w_across_z), STEWART_FMA(K_e, e_across_x, K_gamma*gamma_across_x)));
        const stewart_real K_y = STEWART_FMA(K_u, u_across_y, STEWART_FMA(K_s_w, STEWART_FMA(-s_x,
            w_across_z, s_z*w_across_x), STEWART_FMA(K_e, e_across_y, K_gamma*gamma_across_y)));
        const stewart_real K_z = STEWART_FMA(K_u, u_across_z, STEWART_FMA(K_s_w, STEWART_FMA(-s_y,
            w_across_x, s_x*w_across_y), STEWART_FMA(K_e, e_across_z, K_gamma*gamma_across_z)));
        const stewart_real f_s_u = c12;
        /* f, base frame */
        const stewart_real f_x = STEWART_FMA(C_s, -w_across_x, STEWART_FMA(C_s, -c1, f_s_u*STEWART_FMA(-s_z,
            u_across_y, s_y*u_across_z)));
        const stewart_real f_y = STEWART_FMA(C_s, -w_across_y, STEWART_FMA(C_s, -c2, f_s_u*STEWART_FMA(-s_x,
            u_across_z, s_z*u_across_x)));
        const stewart_real f_z = STEWART_FMA(C_s, -w_across_z, STEWART_FMA(C_s, -c3, f_s_u*STEWART_FMA(-s_y,
            u_across_x, s_x*u_across_y)));
        column[0][l] = s_x;
        column[1][l] = s_y;
        column[2][l] = s_z;
        own->q[0][l] = q_x;
        own->q[1][l] = q_y;
        own->q[2][l] = q_z;
        own->c_force[0][l] = -K_x;
        own->c_force[1][l] = -K_y;
        own->c_force[2][l] = -K_z;
        own->c_moment[0][l] = f_x;
        own->c_moment[1][l] = f_y;
        own->c_moment[2][l] = f_z;
        known[l] = D;
        stewart_real fault = L > shared->least_L[l] ? bad[l] : REAL(1);
        fault = L <= STEWART_MAX ? fault : REAL(1);
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
static void forces_of_block(
    const stewart_exact_spherical_drive_model *model, const motion_lanes *at, block *out)
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
static int forces_of(
    const stewart_exact_spherical_drive_model *model, const motion_lanes *at, int l, stewart_real F[6])
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
    return stewart_exact_spherical_drive_forces(model, &one, F);
}

/* Computes the forces block by block. The arrays contain pose after pose if stride is 0, else columns. */
static int forces_of_poses(
    const stewart_exact_spherical_drive_model *model, size_t count, size_t stride,
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

int stewart_exact_spherical_drive_forces_batch(
    const stewart_exact_spherical_drive_model *model, size_t count, const stewart_motions *motions,
    stewart_real *F, int *status)
{
    if (model == NULL || motions == NULL || F == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL || motions->alpha == NULL || motions->a == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    return forces_of_poses(model, count, 0, motions, F, status);
}

int stewart_exact_spherical_drive_forces_columns(
    const stewart_exact_spherical_drive_model *model, size_t count, size_t stride,
    const stewart_motions *motions, stewart_real *F, int *status)
{
    if (model == NULL || motions == NULL || F == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL || motions->alpha == NULL || motions->a == NULL || stride < count) {
        return STEWART_BAD_ARGUMENT;
    }
    return forces_of_poses(model, count, stride, motions, F, status);
}
