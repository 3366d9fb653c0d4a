/* stewart_exact_massless_forces.c: functions that are declared and described in stewart_exact_massless_forces.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_exact_massless_forces.h"

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
    stewart_real alpha[3][POSES];
    stewart_real a[3][POSES];
    stewart_real F_ext[3][POSES];
    stewart_real M_ext[3][POSES];
} STEWART_ALIGNED motion_lanes;

/* Constants of one leg, and its contributions to the constants of the platform. */
static void prepare_leg(
    const stewart_robot *robot, const stewart_leg *leg, int i, stewart_exact_massless_model *out,
    lumped_terms *added)
{
    (void)robot;
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    out->b[0][i] = b_x;
    out->b[1][i] = b_y;
    out->b[2][i] = b_z;
    out->p[0][i] = p_x;
    out->p[1][i] = p_y;
    out->p[2][i] = p_z;
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
    const stewart_robot *robot, const lumped_terms *sum, stewart_exact_massless_model *out)
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
static stewart_real size_of(const stewart_exact_massless_model *model)
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

int stewart_exact_massless_prepare(const stewart_robot *robot, stewart_exact_massless_model *model)
{
    int i, j;
    stewart_exact_massless_model made;
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
    for (i = 0; i < 67; ++i) {
        if (!(STEWART_FABS(numbers[i]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    *model = made;
    return STEWART_OK;
}

typedef struct {
    stewart_real c_force[3];
    stewart_real c_moment[3];
    stewart_real least_L;
} STEWART_ALIGNED shared_terms_pose;

typedef struct {
    stewart_real L[LANES];
    stewart_real q[3][LANES];
    stewart_real unfit[LANES];
} STEWART_ALIGNED leg_terms_pose;

typedef struct {
    stewart_real any_unfit;
    stewart_real is_short;
} STEWART_ALIGNED legs_fit_pose;

typedef struct {
    stewart_real reach[LANES];
} STEWART_ALIGNED reach_of_legs_pose;

typedef struct {
    stewart_real c_tip[3];
} STEWART_ALIGNED tip_terms_pose;

typedef struct {
    stewart_real F[6];
} STEWART_ALIGNED forces_pose;

typedef struct {
    stewart_real doubtful;
} STEWART_ALIGNED force_terms_pose;

typedef struct {
    stewart_real reach_2[LANES];
} STEWART_ALIGNED reach_of_rows_pose;

/* Computes terms of a pose that are common to all legs: 162 (84 mul, 78 add, 0 div, 0 sqrt). */
static void compute_shared_terms_pose(
    const stewart_exact_massless_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    shared_terms_pose *STEWART_RESTRICT shared_terms)
{
    const stewart_real R_xx = at->R[0];
    const stewart_real omega_x = at->omega[0];
    const stewart_real R_yx = at->R[3];
    const stewart_real omega_y = at->omega[1];
    const stewart_real R_zx = at->R[6];
    const stewart_real omega_z = at->omega[2];
    const stewart_real R_xy = at->R[1], R_yy = at->R[4], R_zy = at->R[7], R_xz = at->R[2], R_yz = at->R[5],
        R_zz = at->R[8];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real g_x = model->g[0];
    const stewart_real a_x = at->a[0];
    const stewart_real g_y = model->g[1];
    const stewart_real a_y = at->a[1];
    const stewart_real g_z = model->g[2];
    const stewart_real a_z = at->a[2];
    const stewart_real M_P = model->M_P;
    const stewart_real r_C_x = model->r_C[0], r_C_z = model->r_C[2], r_C_y = model->r_C[1];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
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
    const stewart_real t_z = at->t[2], t_y = at->t[1], t_x = at->t[0];
    const stewart_real base_reach = model->base_reach;
    /* angular velocity, platform frame */
    const stewart_real omega_P_x = STEWART_FMA(R_zx, omega_z, STEWART_FMA(R_yx, omega_y, R_xx*omega_x));
    const stewart_real omega_P_y = STEWART_FMA(R_zy, omega_z, STEWART_FMA(R_yy, omega_y, R_xy*omega_x));
    const stewart_real omega_P_z = STEWART_FMA(R_zz, omega_z, STEWART_FMA(R_yz, omega_y, R_xz*omega_x));
    /* angular acceleration, platform frame */
    const stewart_real alpha_P_x = STEWART_FMA(R_zx, alpha_z, STEWART_FMA(R_yx, alpha_y, R_xx*alpha_x));
    const stewart_real alpha_P_y = STEWART_FMA(R_zy, alpha_z, STEWART_FMA(R_yy, alpha_y, R_xy*alpha_x));
    const stewart_real alpha_P_z = STEWART_FMA(R_zz, alpha_z, STEWART_FMA(R_yz, alpha_y, R_xz*alpha_x));
    /* (33) g - a */
    const stewart_real fall_x = g_x - a_x;
    const stewart_real fall_y = g_y - a_y;
    const stewart_real fall_z = g_z - a_z;
    /* (33) g - a in the platform frame */
    const stewart_real fall_P_x = STEWART_FMA(R_zx, fall_z, STEWART_FMA(R_yx, fall_y, R_xx*fall_x));
    const stewart_real fall_P_y = STEWART_FMA(R_zy, fall_z, STEWART_FMA(R_yy, fall_y, R_xy*fall_x));
    const stewart_real fall_P_z = STEWART_FMA(R_zz, fall_z, STEWART_FMA(R_yz, fall_y, R_xz*fall_x));
    const stewart_real c1 = omega_P_x*omega_P_x;
    const stewart_real c2 = omega_P_x*omega_P_y;
    const stewart_real c3 = omega_P_x*omega_P_z;
    const stewart_real c4 = omega_P_y*omega_P_y;
    const stewart_real c5 = omega_P_y*omega_P_z;
    const stewart_real c6 = omega_P_z*omega_P_z;
    /* products of omega */
    const stewart_real omega_xx = c1;
    const stewart_real omega_xy = c2;
    const stewart_real omega_xz = c3;
    const stewart_real omega_yy = c4;
    const stewart_real omega_yz = c5;
    const stewart_real omega_zz = c6;
    /* (7) S_ddot = B q + a */
    const stewart_real B_xx = -omega_yy - omega_zz;
    const stewart_real B_xy = omega_xy - alpha_P_z;
    const stewart_real B_xz = alpha_P_y + omega_xz;
    const stewart_real B_yx = alpha_P_z + omega_xy;
    const stewart_real B_yy = -omega_xx - omega_zz;
    const stewart_real B_yz = omega_yz - alpha_P_x;
    const stewart_real B_zx = omega_xz - alpha_P_y;
    const stewart_real B_zy = alpha_P_x + omega_yz;
    const stewart_real B_zz = -omega_xx - omega_yy;
    /* (33) M_P (g - a_C) in the platform frame */
    const stewart_real N_P_x = M_P*STEWART_FMA(-B_xy, r_C_y, STEWART_FMA(-B_xz, r_C_z, STEWART_FMA(-B_xx,
        r_C_x, fall_P_x)));
    const stewart_real N_P_y = M_P*STEWART_FMA(-B_yz, r_C_z, STEWART_FMA(-B_yx, r_C_x, STEWART_FMA(-B_yy,
        r_C_y, fall_P_y)));
    const stewart_real N_P_z = M_P*STEWART_FMA(-B_zx, r_C_x, STEWART_FMA(-B_zy, r_C_y, STEWART_FMA(-B_zz,
        r_C_z, fall_P_z)));
    /* (33) external force less inertia, in the platform frame */
    const stewart_real F_P_load_x = F_ext_x + N_P_x;
    const stewart_real F_P_load_y = F_ext_y + N_P_y;
    const stewart_real F_P_load_z = F_ext_z + N_P_z;
    const stewart_real P_xy = c2;
    const stewart_real P_xz = c3;
    const stewart_real P_yz = c5;
    const stewart_real P_xx = c1;
    const stewart_real P_yy = c4;
    const stewart_real P_zz = c6;
    /* (34) external moment less I alpha + omega x I omega, in the platform frame */
    const stewart_real M_P_load_x = STEWART_FMA(-N_P_y, r_C_z, STEWART_FMA(N_P_z, r_C_y, STEWART_FMA(-B_yx,
        J_C_xz, STEWART_FMA(B_zx, J_C_xy, STEWART_FMA(-P_yz, dJ_C_x, STEWART_FMA(-J_C_xx, alpha_P_x,
        STEWART_FMA(-J_C_yz, P_yy - P_zz, M_ext_x)))))));
    const stewart_real M_P_load_y = STEWART_FMA(-N_P_z, r_C_x, STEWART_FMA(N_P_x, r_C_z, STEWART_FMA(-B_zy,
        J_C_xy, STEWART_FMA(B_xy, J_C_yz, STEWART_FMA(-P_xz, dJ_C_y, STEWART_FMA(-J_C_yy, alpha_P_y,
        STEWART_FMA(-J_C_xz, P_zz - P_xx, M_ext_y)))))));
    const stewart_real M_P_load_z = STEWART_FMA(-N_P_x, r_C_y, STEWART_FMA(N_P_y, r_C_x, STEWART_FMA(-B_xz,
        J_C_yz, STEWART_FMA(B_yz, J_C_xz, STEWART_FMA(-P_xy, dJ_C_z, STEWART_FMA(-J_C_zz, alpha_P_z,
        STEWART_FMA(-J_C_xy, P_xx - P_yy, M_ext_z)))))));
    shared_terms->c_force[0] = STEWART_FMA(F_P_load_z, R_xz, STEWART_FMA(F_P_load_y, R_xy,
        F_P_load_x*R_xx));
    shared_terms->c_force[1] = STEWART_FMA(F_P_load_z, R_yz, STEWART_FMA(F_P_load_y, R_yy,
        F_P_load_x*R_yx));
    shared_terms->c_force[2] = STEWART_FMA(F_P_load_z, R_zz, STEWART_FMA(F_P_load_y, R_zy,
        F_P_load_x*R_zx));
    shared_terms->c_moment[0] = STEWART_FMA(M_P_load_z, R_xz, STEWART_FMA(M_P_load_y, R_xy,
        M_P_load_x*R_xx));
    shared_terms->c_moment[1] = STEWART_FMA(M_P_load_z, R_yz, STEWART_FMA(M_P_load_y, R_yy,
        M_P_load_x*R_yx));
    shared_terms->c_moment[2] = STEWART_FMA(M_P_load_z, R_zz, STEWART_FMA(M_P_load_y, R_zy,
        M_P_load_x*R_zx));
    shared_terms->least_L = REAL(2.25)*STEWART_SHORT_SHARE*STEWART_LARGER(STEWART_FABS(t_z),
        STEWART_LARGER(STEWART_FABS(t_y), STEWART_LARGER(STEWART_FABS(t_x), STEWART_LARGER(base_reach,
        STEWART_SHORTEST/STEWART_ROUNDING))));
}

/* Computes a leg: its D, its column of H, and its part of c: 31 (15 mul, 14 add, 1 div, 1 sqrt). */
STEWART_APART static void compute_leg_terms_pose(
    const stewart_exact_massless_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const shared_terms_pose *STEWART_RESTRICT shared_terms, leg_terms_pose *STEWART_RESTRICT leg_terms,
    columns_pose *STEWART_RESTRICT columns)
{
    int l;
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real least_L = shared_terms->least_L;
    for (l = 0; l < LANES; ++l) {
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
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
        columns->H[0][l] = S_x*inv_L;
        columns->H[1][l] = S_y*inv_L;
        columns->H[2][l] = S_z*inv_L;
        leg_terms->unfit[l] = L <= STEWART_MAX ? (L > least_L ? REAL(0) : REAL(1)) : REAL(1);
        leg_terms->q[0][l] = q_x;
        leg_terms->q[1][l] = q_y;
        leg_terms->q[2][l] = q_z;
        leg_terms->L[l] = L;
    }
}

/* Checks whether a leg must be examined. */
static void compute_legs_fit_pose(
    const leg_terms_pose *STEWART_RESTRICT leg_terms, legs_fit_pose *STEWART_RESTRICT legs_fit)
{
    legs_fit->any_unfit = STEWART_LARGER(leg_terms->unfit[5], STEWART_LARGER(leg_terms->unfit[4],
        STEWART_LARGER(leg_terms->unfit[3], STEWART_LARGER(leg_terms->unfit[2],
        STEWART_LARGER(leg_terms->unfit[1], leg_terms->unfit[0])))));
    legs_fit->is_short = REAL(0);
}

/* Computes the largest component (m) of the vectors whose sum is a leg. */
STEWART_APART static void compute_reach_of_legs_pose(
    const stewart_exact_massless_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const leg_terms_pose *STEWART_RESTRICT leg_terms, reach_of_legs_pose *STEWART_RESTRICT reach_of_legs)
{
    int l;
    const stewart_real t_z = at->t[2], t_y = at->t[1], t_x = at->t[0];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_z = model->b[2][l], b_y = model->b[1][l], b_x = model->b[0][l];
        const stewart_real q_z = leg_terms->q[2][l], q_y = leg_terms->q[1][l], q_x = leg_terms->q[0][l];
        reach_of_legs->reach[l] = STEWART_LARGER(STEWART_FABS(b_z), STEWART_LARGER(STEWART_FABS(b_y),
            STEWART_LARGER(STEWART_FABS(b_x), STEWART_LARGER(STEWART_FABS(t_z),
            STEWART_LARGER(STEWART_FABS(t_y), STEWART_LARGER(STEWART_FABS(t_x),
            STEWART_LARGER(STEWART_FABS(q_z), STEWART_LARGER(STEWART_FABS(q_y),
            STEWART_LARGER(STEWART_FABS(q_x), STEWART_SHORTEST/STEWART_ROUNDING)))))))));
    }
}

/* Marks a pose with a short leg or a leg near its joint singularity. */
STEWART_APART static void compute_examination_pose(
    const leg_terms_pose *STEWART_RESTRICT leg_terms,
    const reach_of_legs_pose *STEWART_RESTRICT reach_of_legs, legs_fit_pose *STEWART_RESTRICT legs_fit)
{
    const stewart_real leg_is_short = leg_terms->L[0] > STEWART_SHORT_SHARE*reach_of_legs->reach[0] ? REAL(0)
        : REAL(1);
    const stewart_real leg_is_short_2 = leg_terms->L[1] > STEWART_SHORT_SHARE*reach_of_legs->reach[1] ? leg_is_short
        : REAL(1);
    const stewart_real leg_is_short_3 = leg_terms->L[2] > STEWART_SHORT_SHARE*reach_of_legs->reach[2] ? leg_is_short_2
        : REAL(1);
    const stewart_real leg_is_short_4 = leg_terms->L[3] > STEWART_SHORT_SHARE*reach_of_legs->reach[3] ? leg_is_short_3
        : REAL(1);
    const stewart_real leg_is_short_5 = leg_terms->L[4] > STEWART_SHORT_SHARE*reach_of_legs->reach[4] ? leg_is_short_4
        : REAL(1);
    legs_fit->is_short = leg_terms->L[5] > STEWART_SHORT_SHARE*reach_of_legs->reach[5] ? leg_is_short_5 : REAL(1);
}

/* Computes the platform's part of c about platform point 1: 12 (6 mul, 6 add, 0 div, 0 sqrt). */
static void compute_tip_terms_pose(
    const shared_terms_pose *STEWART_RESTRICT shared_terms,
    const leg_terms_pose *STEWART_RESTRICT leg_terms, tip_terms_pose *STEWART_RESTRICT tip_terms)
{
    const stewart_real c_moment_x = shared_terms->c_moment[0];
    const stewart_real c_force_y = shared_terms->c_force[1], c_force_z = shared_terms->c_force[2];
    const stewart_real c_moment_y = shared_terms->c_moment[1];
    const stewart_real c_force_x = shared_terms->c_force[0];
    const stewart_real c_moment_z = shared_terms->c_moment[2];
    tip_terms->c_tip[0] = STEWART_FMA(-c_force_z, leg_terms->q[1][0], STEWART_FMA(c_force_y,
        leg_terms->q[2][0], c_moment_x));
    tip_terms->c_tip[1] = STEWART_FMA(-c_force_x, leg_terms->q[2][0], STEWART_FMA(c_force_z,
        leg_terms->q[0][0], c_moment_y));
    tip_terms->c_tip[2] = STEWART_FMA(-c_force_y, leg_terms->q[0][0], STEWART_FMA(c_force_x,
        leg_terms->q[1][0], c_moment_z));
}

/* Computes the moments of a leg about platform point 1: 12 (6 mul, 6 add, 0 div, 0 sqrt). */
STEWART_APART static void compute_moment_terms_pose(
    const leg_terms_pose *STEWART_RESTRICT leg_terms, columns_pose *STEWART_RESTRICT columns)
{
    int l;
    for (l = 0; l < LANES; ++l) {
        const stewart_real q_x = leg_terms->q[0][l], q_y = leg_terms->q[1][l], q_z = leg_terms->q[2][l];
        const stewart_real s_z = columns->H[2][l], s_y = columns->H[1][l], s_x = columns->H[0][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - leg_terms->q[0][0];
        const stewart_real arm_y = q_y - leg_terms->q[1][0];
        const stewart_real arm_z = q_z - leg_terms->q[2][0];
        columns->H[3][l] = STEWART_FMA(-s_y, arm_z, s_z*arm_y);
        columns->H[4][l] = STEWART_FMA(-s_z, arm_x, s_x*arm_z);
        columns->H[5][l] = STEWART_FMA(-s_x, arm_y, s_y*arm_x);
    }
}

/* Adds the parts of c of the platform and the legs. */
static void compute_wrench_pose(
    const shared_terms_pose *STEWART_RESTRICT shared_terms,
    const tip_terms_pose *STEWART_RESTRICT tip_terms, right_side_pose *STEWART_RESTRICT right_side)
{
    const stewart_real c_force_x = shared_terms->c_force[0], c_force_y = shared_terms->c_force[1], c_force_z = shared_terms->c_force[2];
    const stewart_real c_tip_x = tip_terms->c_tip[0], c_tip_y = tip_terms->c_tip[1], c_tip_z = tip_terms->c_tip[2];
    right_side->c[0] = c_force_x;
    right_side->c[1] = c_force_y;
    right_side->c[2] = c_force_z;
    right_side->c[3] = c_tip_x;
    right_side->c[4] = c_tip_y;
    right_side->c[5] = c_tip_z;
}

/* Multiplies the moments of a leg by `per_length`. */
STEWART_APART static void compute_scaled_moments_pose(
    const stewart_exact_massless_model *STEWART_RESTRICT model, columns_pose *STEWART_RESTRICT columns)
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
    const stewart_exact_massless_model *STEWART_RESTRICT model,
    right_side_pose *STEWART_RESTRICT right_side)
{
    const stewart_real c_3 = right_side->c[3];
    const stewart_real per_length = model->per_length;
    const stewart_real c_4 = right_side->c[4], c_5 = right_side->c[5];
    right_side->c[3] = c_3*per_length;
    right_side->c[4] = c_4*per_length;
    right_side->c[5] = c_5*per_length;
}

/* Computes F = D - x, (37). */
static void compute_force_terms_pose(
    const solution_pose *STEWART_RESTRICT solution, const legs_fit_pose *STEWART_RESTRICT legs_fit,
    forces_pose *STEWART_RESTRICT forces, force_terms_pose *STEWART_RESTRICT force_terms)
{
    const stewart_real x_0 = solution->x[0], x_1 = solution->x[1], x_2 = solution->x[2], x_3 = solution->x[3],
        x_4 = solution->x[4], x_5 = solution->x[5];
    const stewart_real is_short = legs_fit->is_short;
    const stewart_real suspect = solution->suspect;
    forces->F[0] = -x_0;
    forces->F[1] = -x_1;
    forces->F[2] = -x_2;
    forces->F[3] = -x_3;
    forces->F[4] = -x_4;
    forces->F[5] = -x_5;
    force_terms->doubtful = is_short > REAL(0) ? REAL(1) : suspect;
}

/* Computes the largest component (m) of the vectors whose sum is a leg. */
STEWART_APART static void compute_reach_of_rows_pose(
    const stewart_exact_massless_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const leg_terms_pose *STEWART_RESTRICT leg_terms, reach_of_rows_pose *STEWART_RESTRICT reach_of_rows)
{
    int l;
    const stewart_real t_z = at->t[2], t_y = at->t[1], t_x = at->t[0];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_z = model->b[2][l], b_y = model->b[1][l], b_x = model->b[0][l];
        const stewart_real q_z = leg_terms->q[2][l], q_y = leg_terms->q[1][l], q_x = leg_terms->q[0][l];
        reach_of_rows->reach_2[l] = STEWART_LARGER(STEWART_FABS(b_z), STEWART_LARGER(STEWART_FABS(b_y),
            STEWART_LARGER(STEWART_FABS(b_x), STEWART_LARGER(STEWART_FABS(t_z),
            STEWART_LARGER(STEWART_FABS(t_y), STEWART_LARGER(STEWART_FABS(t_x),
            STEWART_LARGER(STEWART_FABS(q_z), STEWART_LARGER(STEWART_FABS(q_y),
            STEWART_LARGER(STEWART_FABS(q_x), STEWART_SHORTEST/STEWART_ROUNDING)))))))));
    }
}

int stewart_exact_massless_forces(
    const stewart_exact_massless_model *model, const stewart_motion *motion, stewart_real F[6])
{
    int i;
    shared_terms_pose shared_terms;
    leg_terms_pose leg_terms;
    columns_pose columns;
    legs_fit_pose legs_fit;
    reach_of_legs_pose reach_of_legs;
    tip_terms_pose tip_terms;
    right_side_pose right_side;
    solution_pose solution;
    forces_pose forces;
    force_terms_pose force_terms;
    reach_of_rows_pose reach_of_rows;
    int status = STEWART_OK;
    if (model == NULL || motion == NULL || F == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    compute_shared_terms_pose(model, motion, &shared_terms);
    compute_leg_terms_pose(model, motion, &shared_terms, &leg_terms, &columns);
    compute_legs_fit_pose(&leg_terms, &legs_fit);
    if (legs_fit.any_unfit > REAL(0)) {
        compute_reach_of_legs_pose(model, motion, &leg_terms, &reach_of_legs);
        status = fault_of(leg_terms.L[0], REAL(1), reach_of_legs.reach[0]);
        if (status != STEWART_OK) {
            return status;
        }
        status = fault_of(leg_terms.L[1], REAL(1), reach_of_legs.reach[1]);
        if (status != STEWART_OK) {
            return status;
        }
        status = fault_of(leg_terms.L[2], REAL(1), reach_of_legs.reach[2]);
        if (status != STEWART_OK) {
            return status;
        }
        status = fault_of(leg_terms.L[3], REAL(1), reach_of_legs.reach[3]);
        if (status != STEWART_OK) {
            return status;
        }
        status = fault_of(leg_terms.L[4], REAL(1), reach_of_legs.reach[4]);
        if (status != STEWART_OK) {
            return status;
        }
        status = fault_of(leg_terms.L[5], REAL(1), reach_of_legs.reach[5]);
        if (status != STEWART_OK) {
            return status;
        }
        compute_examination_pose(&leg_terms, &reach_of_legs, &legs_fit);
    }
    compute_tip_terms_pose(&shared_terms, &leg_terms, &tip_terms);
    compute_moment_terms_pose(&leg_terms, &columns);
    compute_wrench_pose(&shared_terms, &tip_terms, &right_side);
    if (model->per_length != REAL(1)) {
        compute_scaled_moments_pose(model, &columns);
        compute_scaled_wrench_pose(model, &right_side);
    }
    compute_two_blocks_pose(model->arm_cube, &columns, &right_side, &solution);
    if (solution.weak > REAL(0)) {
        compute_pivots_pose(&columns, &right_side, &solution);
    }
    compute_force_terms_pose(&solution, &legs_fit, &forces, &force_terms);
    if (force_terms.doubtful > REAL(0)) {
        compute_reach_of_rows_pose(model, motion, &leg_terms, &reach_of_rows);
        status = rows_status(columns.H, leg_terms.q, leg_terms.L, reach_of_rows.reach_2, model->per_length);
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
    stewart_real c_force[3][POSES];
    stewart_real c_moment[3][POSES];
    stewart_real least_L[POSES];
} STEWART_ALIGNED shared_terms_block;

typedef struct {
    stewart_real q[3][POSES];
    stewart_real unfit[POSES];
} STEWART_ALIGNED leg_terms_block;

typedef struct {
    stewart_real any_unfit[POSES];
} STEWART_ALIGNED legs_fit_block;

typedef struct {
    stewart_real F[6][POSES];
    stewart_real unfinished[POSES];
} STEWART_ALIGNED forces_block;

/* Computes terms of a pose that are common to all legs: 162 (84 mul, 78 add, 0 div, 0 sqrt). */
STEWART_APART static void compute_shared_terms_block(
    const stewart_exact_massless_model *STEWART_RESTRICT model, const motion_lanes *STEWART_RESTRICT at,
    shared_terms_block *STEWART_RESTRICT shared_terms)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real R_xx = at->R[0][l], R_yx = at->R[3][l], R_zx = at->R[6][l], R_xy = at->R[1][l],
            R_yy = at->R[4][l], R_zy = at->R[7][l], R_xz = at->R[2][l], R_yz = at->R[5][l], R_zz = at->R[8][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        /* angular velocity, platform frame */
        const stewart_real omega_P_x = STEWART_FMA(R_zx, omega_z, STEWART_FMA(R_yx, omega_y, R_xx*omega_x));
        const stewart_real omega_P_y = STEWART_FMA(R_zy, omega_z, STEWART_FMA(R_yy, omega_y, R_xy*omega_x));
        const stewart_real omega_P_z = STEWART_FMA(R_zz, omega_z, STEWART_FMA(R_yz, omega_y, R_xz*omega_x));
        const stewart_real alpha_x = at->alpha[0][l], alpha_y = at->alpha[1][l], alpha_z = at->alpha[2][l];
        /* angular acceleration, platform frame */
        const stewart_real alpha_P_x = STEWART_FMA(R_zx, alpha_z, STEWART_FMA(R_yx, alpha_y, R_xx*alpha_x));
        const stewart_real alpha_P_y = STEWART_FMA(R_zy, alpha_z, STEWART_FMA(R_yy, alpha_y, R_xy*alpha_x));
        const stewart_real alpha_P_z = STEWART_FMA(R_zz, alpha_z, STEWART_FMA(R_yz, alpha_y, R_xz*alpha_x));
        const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
        const stewart_real a_x = at->a[0][l], a_y = at->a[1][l], a_z = at->a[2][l];
        /* (33) g - a */
        const stewart_real fall_x = g_x - a_x;
        const stewart_real fall_y = g_y - a_y;
        const stewart_real fall_z = g_z - a_z;
        /* (33) g - a in the platform frame */
        const stewart_real fall_P_x = STEWART_FMA(R_zx, fall_z, STEWART_FMA(R_yx, fall_y, R_xx*fall_x));
        const stewart_real fall_P_y = STEWART_FMA(R_zy, fall_z, STEWART_FMA(R_yy, fall_y, R_xy*fall_x));
        const stewart_real fall_P_z = STEWART_FMA(R_zz, fall_z, STEWART_FMA(R_yz, fall_y, R_xz*fall_x));
        const stewart_real c1 = omega_P_x*omega_P_x;
        const stewart_real c2 = omega_P_x*omega_P_y;
        const stewart_real c3 = omega_P_x*omega_P_z;
        const stewart_real c4 = omega_P_y*omega_P_y;
        const stewart_real c5 = omega_P_y*omega_P_z;
        const stewart_real c6 = omega_P_z*omega_P_z;
        /* products of omega */
        const stewart_real omega_xx = c1;
        const stewart_real omega_xy = c2;
        const stewart_real omega_xz = c3;
        const stewart_real omega_yy = c4;
        const stewart_real omega_yz = c5;
        const stewart_real omega_zz = c6;
        /* (7) S_ddot = B q + a */
        const stewart_real B_xx = -omega_yy - omega_zz;
        const stewart_real B_xy = omega_xy - alpha_P_z;
        const stewart_real B_xz = alpha_P_y + omega_xz;
        const stewart_real B_yx = alpha_P_z + omega_xy;
        const stewart_real B_yy = -omega_xx - omega_zz;
        const stewart_real B_yz = omega_yz - alpha_P_x;
        const stewart_real B_zx = omega_xz - alpha_P_y;
        const stewart_real B_zy = alpha_P_x + omega_yz;
        const stewart_real B_zz = -omega_xx - omega_yy;
        const stewart_real M_P = model->M_P;
        const stewart_real r_C_x = model->r_C[0], r_C_z = model->r_C[2], r_C_y = model->r_C[1];
        /* (33) M_P (g - a_C) in the platform frame */
        const stewart_real N_P_x = M_P*STEWART_FMA(-B_xy, r_C_y, STEWART_FMA(-B_xz, r_C_z,
            STEWART_FMA(-B_xx, r_C_x, fall_P_x)));
        const stewart_real N_P_y = M_P*STEWART_FMA(-B_yz, r_C_z, STEWART_FMA(-B_yx, r_C_x,
            STEWART_FMA(-B_yy, r_C_y, fall_P_y)));
        const stewart_real N_P_z = M_P*STEWART_FMA(-B_zx, r_C_x, STEWART_FMA(-B_zy, r_C_y,
            STEWART_FMA(-B_zz, r_C_z, fall_P_z)));
        const stewart_real F_ext_x = at->F_ext[0][l], F_ext_y = at->F_ext[1][l], F_ext_z = at->F_ext[2][l];
        /* (33) external force less inertia, in the platform frame */
        const stewart_real F_P_load_x = F_ext_x + N_P_x;
        const stewart_real F_P_load_y = F_ext_y + N_P_y;
        const stewart_real F_P_load_z = F_ext_z + N_P_z;
        const stewart_real P_xy = c2;
        const stewart_real P_xz = c3;
        const stewart_real P_yz = c5;
        const stewart_real P_xx = c1;
        const stewart_real P_yy = c4;
        const stewart_real P_zz = c6;
        const stewart_real M_ext_x = at->M_ext[0][l], M_ext_y = at->M_ext[1][l], M_ext_z = at->M_ext[2][l];
        const stewart_real J_C_yz = model->J_C[4], J_C_xx = model->J_C[0], J_C_xy = model->J_C[1], J_C_xz = model->J_C[2],
            J_C_yy = model->J_C[3], J_C_zz = model->J_C[5];
        const stewart_real dJ_C_x = model->dJ_C[0], dJ_C_y = model->dJ_C[1], dJ_C_z = model->dJ_C[2];
        const stewart_real t_z = at->t[2][l], t_y = at->t[1][l], t_x = at->t[0][l];
        const stewart_real base_reach = model->base_reach;
        /* (34) external moment less I alpha + omega x I omega, in the platform frame */
        const stewart_real M_P_load_x = STEWART_FMA(-N_P_y, r_C_z, STEWART_FMA(N_P_z, r_C_y,
            STEWART_FMA(-B_yx, J_C_xz, STEWART_FMA(B_zx, J_C_xy, STEWART_FMA(-P_yz, dJ_C_x,
            STEWART_FMA(J_C_xx, -alpha_P_x, STEWART_FMA(J_C_yz, -(P_yy - P_zz), M_ext_x)))))));
        const stewart_real M_P_load_y = STEWART_FMA(-N_P_z, r_C_x, STEWART_FMA(N_P_x, r_C_z,
            STEWART_FMA(-B_zy, J_C_xy, STEWART_FMA(B_xy, J_C_yz, STEWART_FMA(-P_xz, dJ_C_y,
            STEWART_FMA(J_C_yy, -alpha_P_y, STEWART_FMA(J_C_xz, -(P_zz - P_xx), M_ext_y)))))));
        const stewart_real M_P_load_z = STEWART_FMA(-N_P_x, r_C_y, STEWART_FMA(N_P_y, r_C_x,
            STEWART_FMA(-B_xz, J_C_yz, STEWART_FMA(B_yz, J_C_xz, STEWART_FMA(-P_xy, dJ_C_z,
            STEWART_FMA(J_C_zz, -alpha_P_z, STEWART_FMA(J_C_xy, -(P_xx - P_yy), M_ext_z)))))));
        shared_terms->c_force[0][l] = STEWART_FMA(F_P_load_z, R_xz, STEWART_FMA(F_P_load_y, R_xy,
            F_P_load_x*R_xx));
        shared_terms->c_force[1][l] = STEWART_FMA(F_P_load_z, R_yz, STEWART_FMA(F_P_load_y, R_yy,
            F_P_load_x*R_yx));
        shared_terms->c_force[2][l] = STEWART_FMA(F_P_load_z, R_zz, STEWART_FMA(F_P_load_y, R_zy,
            F_P_load_x*R_zx));
        shared_terms->c_moment[0][l] = STEWART_FMA(M_P_load_z, R_xz, STEWART_FMA(M_P_load_y, R_xy,
            M_P_load_x*R_xx));
        shared_terms->c_moment[1][l] = STEWART_FMA(M_P_load_z, R_yz, STEWART_FMA(M_P_load_y, R_yy,
            M_P_load_x*R_yx));
        shared_terms->c_moment[2][l] = STEWART_FMA(M_P_load_z, R_zz, STEWART_FMA(M_P_load_y, R_zy,
            M_P_load_x*R_zx));
        shared_terms->least_L[l] = REAL(2.25)*STEWART_SHORT_SHARE*STEWART_LARGER(STEWART_FABS(t_z),
            STEWART_LARGER(STEWART_FABS(t_y), STEWART_LARGER(STEWART_FABS(t_x), STEWART_LARGER(base_reach,
            STEWART_SHORTEST/STEWART_ROUNDING))));
    }
}

/* Computes a leg: its D, its column of H, and its part of c: 31 (15 mul, 14 add, 1 div, 1 sqrt). */
static void compute_leg_terms_block(
    const stewart_exact_massless_model *STEWART_RESTRICT model, const motion_lanes *STEWART_RESTRICT at,
    int leg, const shared_terms_block *STEWART_RESTRICT shared_terms,
    leg_terms_block *STEWART_RESTRICT leg_terms, columns_block *STEWART_RESTRICT columns)
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
        /* (2) leg length */
        const stewart_real L = STEWART_SQRT(STEWART_FMA(S_z, S_z, STEWART_FMA(S_y, S_y, S_x*S_x)));
        const stewart_real inv_L = REAL(1)/L;
        const stewart_real least_L = shared_terms->least_L[l];
        /* (3) unit vector along the leg */
        columns[leg].H[0][l] = S_x*inv_L;
        columns[leg].H[1][l] = S_y*inv_L;
        columns[leg].H[2][l] = S_z*inv_L;
        leg_terms[leg].unfit[l] = L <= STEWART_MAX ? (L > least_L ? REAL(0) : REAL(1)) : REAL(1);
        leg_terms[leg].q[0][l] = q_x;
        leg_terms[leg].q[1][l] = q_y;
        leg_terms[leg].q[2][l] = q_z;
    }
}

/* Computes the moments of a leg about platform point 1: 12 (6 mul, 6 add, 0 div, 0 sqrt). */
static void compute_moment_terms_block(
    int leg, const leg_terms_block *STEWART_RESTRICT leg_terms, columns_block *STEWART_RESTRICT columns)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real q_x = leg_terms[leg].q[0][l], q_y = leg_terms[leg].q[1][l], q_z = leg_terms[leg].q[2][l];
        const stewart_real q_x_leg1 = leg_terms[0].q[0][l], q_y_leg1 = leg_terms[0].q[1][l], q_z_leg1 = leg_terms[0].q[2][l];
        const stewart_real s_z = columns[leg].H[2][l], s_y = columns[leg].H[1][l], s_x = columns[leg].H[0][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - q_x_leg1;
        const stewart_real arm_y = q_y - q_y_leg1;
        const stewart_real arm_z = q_z - q_z_leg1;
        columns[leg].H[3][l] = STEWART_FMA(-s_y, arm_z, s_z*arm_y);
        columns[leg].H[4][l] = STEWART_FMA(-s_z, arm_x, s_x*arm_z);
        columns[leg].H[5][l] = STEWART_FMA(-s_x, arm_y, s_y*arm_x);
    }
}

/* Checks whether a leg must be examined. */
STEWART_APART static void compute_legs_fit_block(
    const leg_terms_block *STEWART_RESTRICT leg_terms,
    const shared_terms_block *STEWART_RESTRICT shared_terms, legs_fit_block *STEWART_RESTRICT legs_fit,
    right_side_block *STEWART_RESTRICT right_side)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real unfit_leg6 = leg_terms[5].unfit[l];
        const stewart_real unfit_leg5 = leg_terms[4].unfit[l];
        const stewart_real unfit_leg4 = leg_terms[3].unfit[l];
        const stewart_real unfit_leg3 = leg_terms[2].unfit[l];
        const stewart_real unfit_leg2 = leg_terms[1].unfit[l];
        const stewart_real unfit_leg1 = leg_terms[0].unfit[l];
        const stewart_real c_moment_x = shared_terms->c_moment[0][l], c_moment_y = shared_terms->c_moment[1][l],
            c_moment_z = shared_terms->c_moment[2][l];
        const stewart_real c_force_y = shared_terms->c_force[1][l], c_force_z = shared_terms->c_force[2][l],
            c_force_x = shared_terms->c_force[0][l];
        const stewart_real q_z_leg1 = leg_terms[0].q[2][l], q_y_leg1 = leg_terms[0].q[1][l], q_x_leg1 = leg_terms[0].q[0][l];
        legs_fit->any_unfit[l] = STEWART_LARGER(unfit_leg6, STEWART_LARGER(unfit_leg5,
            STEWART_LARGER(unfit_leg4, STEWART_LARGER(unfit_leg3, STEWART_LARGER(unfit_leg2,
            unfit_leg1)))));
        const stewart_real c_tip_x = STEWART_FMA(-c_force_z, q_y_leg1, STEWART_FMA(c_force_y, q_z_leg1,
            c_moment_x));
        const stewart_real c_tip_y = STEWART_FMA(-c_force_x, q_z_leg1, STEWART_FMA(c_force_z, q_x_leg1,
            c_moment_y));
        const stewart_real c_tip_z = STEWART_FMA(-c_force_y, q_x_leg1, STEWART_FMA(c_force_x, q_y_leg1,
            c_moment_z));
        right_side->c[0][l] = c_force_x;
        right_side->c[1][l] = c_force_y;
        right_side->c[2][l] = c_force_z;
        right_side->c[3][l] = c_tip_x;
        right_side->c[4][l] = c_tip_y;
        right_side->c[5][l] = c_tip_z;
    }
}

/* Multiplies the moments of a leg by `per_length`. */
STEWART_APART static void compute_scaled_moments_block(
    const stewart_exact_massless_model *STEWART_RESTRICT model, int leg,
    columns_block *STEWART_RESTRICT columns)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real H_moment_x = columns[leg].H[3][l], H_moment_y = columns[leg].H[4][l], H_moment_z = columns[leg].H[5][l];
        const stewart_real per_length = model->per_length;
        columns[leg].H[3][l] = H_moment_x*per_length;
        columns[leg].H[4][l] = H_moment_y*per_length;
        columns[leg].H[5][l] = H_moment_z*per_length;
    }
}

/* Multiplies the moments of c by `per_length`. */
STEWART_APART static void compute_scaled_wrench_block(
    const stewart_exact_massless_model *STEWART_RESTRICT model,
    right_side_block *STEWART_RESTRICT right_side)
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

/* Computes F = D - x, (37). */
STEWART_APART static void compute_force_terms_block(
    const solution_block *STEWART_RESTRICT solution, const legs_fit_block *STEWART_RESTRICT legs_fit,
    forces_block *STEWART_RESTRICT forces)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real x_0 = solution->x[0][l], x_1 = solution->x[1][l], x_2 = solution->x[2][l], x_3 = solution->x[3][l],
            x_4 = solution->x[4][l], x_5 = solution->x[5][l];
        const stewart_real suspect = solution->suspect[l];
        const stewart_real any_unfit = legs_fit->any_unfit[l];
        const stewart_real F_0 = -x_0;
        const stewart_real F_1 = -x_1;
        const stewart_real F_2 = -x_2;
        const stewart_real F_3 = -x_3;
        const stewart_real F_4 = -x_4;
        const stewart_real F_5 = -x_5;
        const stewart_real doubtful = suspect;
        forces->unfinished[l] = STEWART_FABS(F_5) <= STEWART_MAX ? (STEWART_FABS(F_4) <= STEWART_MAX ? (STEWART_FABS(F_3) <= STEWART_MAX
            ? (STEWART_FABS(F_2) <= STEWART_MAX ? (STEWART_FABS(F_1) <= STEWART_MAX ? (STEWART_FABS(F_0) <= STEWART_MAX
            ? STEWART_LARGER(any_unfit, doubtful) : REAL(1)) : REAL(1)) : REAL(1)) : REAL(1)) : REAL(1)) : REAL(1);
        forces->F[0][l] = F_0;
        forces->F[1][l] = F_1;
        forces->F[2][l] = F_2;
        forces->F[3][l] = F_3;
        forces->F[4][l] = F_4;
        forces->F[5][l] = F_5;
    }
}

/* Computes the forces of a block of poses, and marks the poses that must be examined. */
static void forces_of_block(
    const stewart_exact_massless_model *model, const motion_lanes *at, forces_block *forces)
{
    int l, leg;
    shared_terms_block shared_terms;
    leg_terms_block leg_terms[6];
    columns_block columns[6];
    legs_fit_block legs_fit;
    right_side_block right_side;
    solution_block solution;
    compute_shared_terms_block(model, at, &shared_terms);
    for (leg = 0; leg < 6; ++leg) {
        compute_leg_terms_block(model, at, leg, &shared_terms, leg_terms, columns);
    }
    for (leg = 1; leg < 6; ++leg) {
        compute_moment_terms_block(leg, leg_terms, columns);
    }
    compute_legs_fit_block(leg_terms, &shared_terms, &legs_fit, &right_side);
    if (model->per_length != REAL(1)) {
        for (leg = 1; leg < 6; ++leg) {
            compute_scaled_moments_block(model, leg, columns);
        }
        compute_scaled_wrench_block(model, &right_side);
    }
    compute_two_blocks_block(model->arm_cube, columns, &right_side, &solution);
    stewart_real most_weak = REAL(0);
    for (l = 0; l < POSES; ++l) {
        most_weak = STEWART_LARGER(solution.weak[l], most_weak);
    }
    if (most_weak > REAL(0)) {
        compute_pivots_block(columns, &right_side, &solution);
    }
    compute_force_terms_block(&solution, &legs_fit, forces);
}

/* Loads the motions of a block of poses, component by component. */
STEWART_APART static void load_block(
    const stewart_motions *motions, size_t stride, size_t first, size_t count, motion_lanes *at)
{
    load_matrix(motions->R, stride, first, count, at->R);
    load_vector(motions->t, stride, first, count, at->t);
    load_vector(motions->omega, stride, first, count, at->omega);
    load_vector(motions->alpha, stride, first, count, at->alpha);
    load_vector(motions->a, stride, first, count, at->a);
    load_vector(motions->F_ext, stride, first, count, at->F_ext);
    load_vector(motions->M_ext, stride, first, count, at->M_ext);
}

/* Computes the forces and the status of one pose of a block. */
static int forces_of(
    const stewart_exact_massless_model *model, const motion_lanes *at, int l, stewart_real F[6])
{
    int i;
    stewart_motion one;
    for (i = 0; i < 9; ++i) {
        one.R[i] = at->R[i][l];
    }
    for (i = 0; i < 3; ++i) {
        one.t[i] = at->t[i][l];
        one.omega[i] = at->omega[i][l];
        one.alpha[i] = at->alpha[i][l];
        one.a[i] = at->a[i][l];
        one.F_ext[i] = at->F_ext[i][l];
        one.M_ext[i] = at->M_ext[i][l];
    }
    return stewart_exact_massless_forces(model, &one, F);
}

/* Computes the forces block by block. The arrays contain pose after pose if stride is 0, else columns. */
static int forces_of_poses(
    const stewart_exact_massless_model *model, size_t count, size_t stride, const stewart_motions *motions,
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

int stewart_exact_massless_forces_batch(
    const stewart_exact_massless_model *model, size_t count, const stewart_motions *motions,
    stewart_real *F, int *status)
{
    if (model == NULL || motions == NULL || F == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->alpha == NULL || motions->a == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    return forces_of_poses(model, count, 0, motions, F, status);
}

int stewart_exact_massless_forces_columns(
    const stewart_exact_massless_model *model, size_t count, size_t stride, const stewart_motions *motions,
    stewart_real *F, int *status)
{
    if (model == NULL || motions == NULL || F == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->alpha == NULL || motions->a == NULL || stride < count) {
        return STEWART_BAD_ARGUMENT;
    }
    return forces_of_poses(model, count, stride, motions, F, status);
}
