/* stewart_exact_motion.c: functions that are declared and described in stewart_exact_motion.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_exact_motion.h"

#include "stewart_lanes.h"

/* Smallest fraction of a diagonal entry of M after elimination; below it, the result loses digits of the
 * robot. */
#define STEWART_KEPT ((stewart_real)0.0625)

/* Sine of the angle between a leg and its fixed axis below which the shorter formulas of C and the
 * derivatives are inaccurate. */
#define STEWART_LEANING ((stewart_real)0.125)

/* Functions for one or eight poses contain a loop that runs only once for one pose, so each caller has its
 * own copy. */
#if defined(__GNUC__)
#define STEWART_INLINE inline __attribute__((always_inline))
#else
#define STEWART_INLINE
#endif

/* Vectors of eight lanes are one register of AVX-512, which GCC does not use by default. */
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 8 && defined(__AVX512F__)
#pragma GCC target("prefer-vector-width=512")
#endif

/* Adds the six legs to the platform's part. Never inlined, because GCC 12 vectorizes the sums incorrectly if
 * it sees the solver too. */
STEWART_APART static void add_legs(
    stewart_real (*STEWART_RESTRICT lanes)[LANES], int count, stewart_real *STEWART_RESTRICT sum)
{
    int i;
    for (i = 0; i < count; ++i) {
        const stewart_real *const leg = lanes[i];
        sum[i] = sum[i] + (leg[0] + leg[1] + (leg[2] + leg[3]) + (leg[4] + leg[5]));
    }
}

/* Accelerations of the platform. */
typedef struct {
    stewart_real acceleration[6];
    int status; /* 0, or the code of an error */
} forward_dynamics_found;

/* Inputs of the blocks of a leg. */
typedef struct {
    stewart_real F; /* N: actuator force of the leg */
    stewart_real net[3]; /* N, N m: generalized forces of the leg less the actuator's, along L, theta, phi */
    stewart_real turned[3]; /* m/s^2, 1/s^2: accelerations of L, theta, phi caused by the platform's accelerations only */
    stewart_real axial; /* 1: 0 for a leg near its joint singularity with little inertia about its own axis, else 1 */
} leg_inputs;

/* M = A^T W A: three rows for each leg, by L, theta, phi, and six of the platform. */
typedef struct {
    leg_inputs given[6]; /* inputs of the derivatives, one for each leg */
    stewart_real extent[24]; /* root of the inertia in each row */
    stewart_real weight[72]; /* 1: W in blocks of three rows */
    stewart_real row[144]; /* A, each row times the root of its inertia; then L and U */
    stewart_real share[144]; /* each row as a sum of the six that serve as coordinates */
    stewart_real inertia[36]; /* M in these coordinates */
    int order[24]; /* number of the row in each place */
    int column[6]; /* number of the column in each place */
    stewart_real length; /* m: moments and rotations are measured by it */
} rows;

/* Result of the rows. */
typedef struct {
    stewart_real x[6]; /* m/s^2, rad/s^2: a and alpha */
    int status; /* 0, or the code of an error */
} apart_found;

/* Inertia that the actuators feel. */
typedef struct {
    stewart_real inertia[36]; /* kg: H^-1 M H^-T */
    int status; /* 0, or the code of an error */
} joint_inertia_found;

/* Forward dynamics and its linearization. */
typedef struct {
    stewart_linearization of;
    int status; /* 0, or the code of an error */
} linearization_found;

/* Result of the rows for a linearization. */
typedef struct {
    stewart_real x[6]; /* m/s^2, rad/s^2: a and alpha */
    stewart_real A[144]; /* the rows solved */
    int status; /* 0, or the code of an error */
} slopes_found;

/* Copies the numbers of a pose to the array of all poses unless it is null. */
static void copy(stewart_real *to, size_t pose, const stewart_real *values, size_t count)
{
    size_t i;
    if (to != NULL) {
        for (i = 0; i < count; ++i) {
            to[pose*count + i] = values[i];
        }
    }
}

/* Copies one pose of a batch, with zeros for optional arrays that are null. */
static void load_pose(const stewart_motions *motions, size_t pose, stewart_motion *one)
{
    int i;
    for (i = 0; i < 9; ++i) {
        one->R[i] = motions->R[pose*9U + (size_t)i];
    }
    for (i = 0; i < 3; ++i) {
        const size_t at = pose*3U + (size_t)i;
        one->t[i] = motions->t[at];
        one->omega[i] = motions->omega[at];
        one->v[i] = motions->v[at];
        one->alpha[i] = motions->alpha != NULL ? motions->alpha[at] : REAL(0);
        one->a[i] = motions->a != NULL ? motions->a[at] : REAL(0);
        one->F_ext[i] = motions->F_ext != NULL ? motions->F_ext[at] : REAL(0);
        one->M_ext[i] = motions->M_ext != NULL ? motions->M_ext[at] : REAL(0);
    }
}

/* Quantities that determine the status of a leg; bad: 1 if it cannot be computed, else 0. */
typedef struct {
    stewart_real L[LANES];
    stewart_real reach[LANES];
    stewart_real k3[LANES];
    stewart_real bad[LANES];
} leg_checks;

/* Motions of eight poses, or of one pose in the first lane, component by component. */
typedef struct {
    stewart_real R[9][LANES];
    stewart_real t[3][LANES];
    stewart_real omega[3][LANES];
    stewart_real v[3][LANES];
    stewart_real alpha[3][LANES];
    stewart_real a[3][LANES];
    stewart_real F_ext[3][LANES];
    stewart_real M_ext[3][LANES];
} STEWART_ALIGNED motion_in_lanes;

/* Returns the status of the first leg that is not OK, or OK. */
static int legs_status(const leg_checks *checked)
{
    int i;
    for (i = 0; i < 6; ++i) {
        if (checked->bad[i] > REAL(0)) {
            return fault_of(checked->L[i], checked->k3[i], checked->reach[i]);
        }
    }
    return STEWART_OK;
}

/* Returns 1 if a leg is so near its joint singularity that the shorter formulas lose digits. */
static int is_near(const leg_checks *checked)
{
    int i;
    int found = 0;
    for (i = 0; i < 6; ++i) {
        found = checked->k3[i] > STEWART_LEANING ? found : 1;
    }
    return found;
}

/* Zero for each lane; not zero if one of ``count`` numbers of a lane is not finite. */
static void not_finite(
    const stewart_real *STEWART_RESTRICT number, int count, stewart_real *STEWART_RESTRICT none)
{
    int i, l;
    for (l = 0; l < LANES; ++l) {
        none[l] = REAL(0);
    }
    for (i = 0; i < count; ++i) {
        for (l = 0; l < LANES; ++l) {
            none[l] = STEWART_FMA(REAL(0), number[LANES*i + l], none[l]);
        }
    }
}

typedef struct {
    stewart_real B_0[9][LANES];
} STEWART_ALIGNED forward_pose;

typedef struct {
    stewart_real sum[27][LANES];
    stewart_real F[LANES];
    leg_checks checked;
    int status;
} STEWART_ALIGNED forward_legs;

/* Computes the terms of the platform, for one pose or eight. */
static STEWART_INLINE void forward_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const motion_in_lanes *STEWART_RESTRICT at,
    int lanes, forward_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT summed)
{
    int l;
    const stewart_real M_P = model->M_P;
    const stewart_real h_P_x = model->h_P[0], h_P_y = model->h_P[1], h_P_z = model->h_P[2];
    const stewart_real J_P_xx = model->J_P[0], J_P_xy = model->J_P[1], J_P_xz = model->J_P[2], J_P_yy = model->J_P[3],
        J_P_yz = model->J_P[4], J_P_zz = model->J_P[5];
    const stewart_real C_P = model->C_P;
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < lanes; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        const stewart_real F_ext_x = at->F_ext[0][l], F_ext_y = at->F_ext[1][l], F_ext_z = at->F_ext[2][l];
        const stewart_real M_ext_x = at->M_ext[0][l], M_ext_y = at->M_ext[1][l], M_ext_z = at->M_ext[2][l];
        /* (30) first moment of the platform, base frame */
        const stewart_real h_base_x = STEWART_FMA(R_xz, h_P_z, STEWART_FMA(R_xy, h_P_y, R_xx*h_P_x));
        const stewart_real h_base_y = STEWART_FMA(R_yz, h_P_z, STEWART_FMA(R_yy, h_P_y, R_yx*h_P_x));
        const stewart_real h_base_z = STEWART_FMA(R_zz, h_P_z, STEWART_FMA(R_zy, h_P_y, R_zx*h_P_x));
        const stewart_real c1 = STEWART_FMA(J_P_xz, R_xz, STEWART_FMA(J_P_xy, R_xy, J_P_xx*R_xx));
        const stewart_real c2 = STEWART_FMA(J_P_yz, R_xz, STEWART_FMA(J_P_yy, R_xy, J_P_xy*R_xx));
        const stewart_real c3 = STEWART_FMA(J_P_zz, R_xz, STEWART_FMA(J_P_yz, R_xy, J_P_xz*R_xx));
        const stewart_real c4 = STEWART_FMA(J_P_xz, R_yz, STEWART_FMA(J_P_xy, R_yy, J_P_xx*R_yx));
        const stewart_real c5 = STEWART_FMA(J_P_yz, R_yz, STEWART_FMA(J_P_yy, R_yy, J_P_xy*R_yx));
        const stewart_real c6 = STEWART_FMA(J_P_zz, R_yz, STEWART_FMA(J_P_yz, R_yy, J_P_xz*R_yx));
        /* (32) inertia of the platform, base frame */
        const stewart_real J_base_xx = STEWART_FMA(R_xz, c3, STEWART_FMA(R_xy, c2, R_xx*c1));
        const stewart_real J_base_xy = STEWART_FMA(R_yz, c3, STEWART_FMA(R_yy, c2, R_yx*c1));
        const stewart_real J_base_xz = STEWART_FMA(R_zz, c3, STEWART_FMA(R_zy, c2, R_zx*c1));
        const stewart_real J_base_yy = STEWART_FMA(R_yz, c6, STEWART_FMA(R_yy, c5, R_yx*c4));
        const stewart_real J_base_yz = STEWART_FMA(R_zz, c6, STEWART_FMA(R_zy, c5, R_zx*c4));
        const stewart_real J_base_zz = STEWART_FMA(R_zz, STEWART_FMA(J_P_zz, R_zz, STEWART_FMA(J_P_yz, R_zy,
            J_P_xz*R_zx)), STEWART_FMA(R_zy, STEWART_FMA(J_P_yz, R_zz, STEWART_FMA(J_P_yy, R_zy,
            J_P_xy*R_zx)), R_zx*STEWART_FMA(J_P_xz, R_zz, STEWART_FMA(J_P_xy, R_zy, J_P_xx*R_zx))));
        /* (31) omega x h */
        const stewart_real w_h_x = STEWART_FMA(-h_base_y, omega_z, h_base_z*omega_y);
        const stewart_real w_h_y = STEWART_FMA(-h_base_z, omega_x, h_base_x*omega_z);
        const stewart_real w_h_z = STEWART_FMA(-h_base_x, omega_y, h_base_y*omega_x);
        /* (34) I omega */
        const stewart_real J_w_x = STEWART_FMA(J_base_xz, omega_z, STEWART_FMA(J_base_xy, omega_y,
            J_base_xx*omega_x));
        const stewart_real J_w_y = STEWART_FMA(J_base_yz, omega_z, STEWART_FMA(J_base_yy, omega_y,
            J_base_xy*omega_x));
        const stewart_real J_w_z = STEWART_FMA(J_base_zz, omega_z, STEWART_FMA(J_base_yz, omega_y,
            J_base_xz*omega_x));
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
        out->B_0[0][l] = B_xx;
        out->B_0[1][l] = omega_xy;
        out->B_0[2][l] = omega_xz;
        out->B_0[3][l] = omega_xy;
        out->B_0[4][l] = B_yy;
        out->B_0[5][l] = omega_yz;
        out->B_0[6][l] = omega_xz;
        out->B_0[7][l] = omega_yz;
        out->B_0[8][l] = B_zz;
        summed[0*lanes + l] = M_P;
        summed[1*lanes + l] = REAL(0);
        summed[2*lanes + l] = REAL(0);
        summed[3*lanes + l] = M_P;
        summed[4*lanes + l] = REAL(0);
        summed[5*lanes + l] = M_P;
        summed[6*lanes + l] = REAL(0);
        summed[7*lanes + l] = h_base_z;
        summed[8*lanes + l] = -h_base_y;
        summed[9*lanes + l] = -h_base_z;
        summed[10*lanes + l] = REAL(0);
        summed[11*lanes + l] = h_base_x;
        summed[12*lanes + l] = h_base_y;
        summed[13*lanes + l] = -h_base_x;
        summed[14*lanes + l] = REAL(0);
        summed[15*lanes + l] = J_base_xx;
        summed[16*lanes + l] = J_base_xy;
        summed[17*lanes + l] = J_base_xz;
        summed[18*lanes + l] = J_base_yy;
        summed[19*lanes + l] = J_base_yz;
        summed[20*lanes + l] = J_base_zz;
        summed[21*lanes + l] = STEWART_FMA(-omega_y, w_h_z, STEWART_FMA(omega_z, w_h_y, STEWART_FMA(M_P,
            g_x, STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy, F_ext_x*R_xx)))));
        summed[22*lanes + l] = STEWART_FMA(-omega_z, w_h_x, STEWART_FMA(omega_x, w_h_z, STEWART_FMA(M_P,
            g_y, STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy, F_ext_x*R_yx)))));
        summed[23*lanes + l] = STEWART_FMA(-omega_x, w_h_y, STEWART_FMA(omega_y, w_h_x, STEWART_FMA(M_P,
            g_z, STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy, F_ext_x*R_zx)))));
        summed[24*lanes + l] = STEWART_FMA(g_y, -h_base_z, STEWART_FMA(-J_w_z, omega_y, STEWART_FMA(C_P,
            -omega_x, STEWART_FMA(g_z, h_base_y, STEWART_FMA(M_ext_z, R_xz, STEWART_FMA(M_ext_y, R_xy,
            STEWART_FMA(M_ext_x, R_xx, J_w_y*omega_z)))))));
        summed[25*lanes + l] = STEWART_FMA(g_z, -h_base_x, STEWART_FMA(-J_w_x, omega_z, STEWART_FMA(C_P,
            -omega_y, STEWART_FMA(g_x, h_base_z, STEWART_FMA(M_ext_z, R_yz, STEWART_FMA(M_ext_y, R_yy,
            STEWART_FMA(M_ext_x, R_yx, J_w_z*omega_x)))))));
        summed[26*lanes + l] = STEWART_FMA(g_x, -h_base_y, STEWART_FMA(-J_w_y, omega_x, STEWART_FMA(C_P,
            -omega_z, STEWART_FMA(g_y, h_base_x, STEWART_FMA(M_ext_z, R_zz, STEWART_FMA(M_ext_y, R_zy,
            STEWART_FMA(M_ext_x, R_zx, J_w_x*omega_y)))))));
    }
}

/* Computes the legs of a pose in lanes. */
STEWART_APART static void forward_of_leg(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT motion,
    const forward_pose *STEWART_RESTRICT pose, forward_legs *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = motion->R[0], R_xy = motion->R[1], R_xz = motion->R[2], R_yx = motion->R[3],
        R_yy = motion->R[4], R_yz = motion->R[5], R_zx = motion->R[6], R_zy = motion->R[7], R_zz = motion->R[8];
    const stewart_real t_x = motion->t[0], t_y = motion->t[1], t_z = motion->t[2];
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    const stewart_real B_0_xx = pose->B_0[0][0], B_0_xy = pose->B_0[1][0], B_0_xz = pose->B_0[2][0], B_0_yx = pose->B_0[3][0],
        B_0_yy = pose->B_0[4][0], B_0_yz = pose->B_0[5][0], B_0_zx = pose->B_0[6][0], B_0_zy = pose->B_0[7][0],
        B_0_zz = pose->B_0[8][0];
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
        const stewart_real F = out->F[l];
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
        /* (10) distance of the tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y,
            k_cross_S_y, k_cross_S_x*k_cross_S_x)));
        const stewart_real inv_rho = REAL(1)/rho;
        /* relative component of the normal along s: rounding */
        const stewart_real n_along_s = inv_rho*STEWART_FMA(k_cross_S_z, s_z, STEWART_FMA(k_cross_S_y, s_y,
            k_cross_S_x*s_x));
        /* one over |s x normal| */
        const stewart_real inv_across = STEWART_FMA(STEWART_HALF*inv_rho*n_along_s, n_along_s, inv_rho);
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_S_y, s_z, k_cross_S_z*s_y);
        const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_S_z, s_x, k_cross_S_x*s_z);
        const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_S_x, s_y, k_cross_S_y*s_x);
        /* (10) third axis of the leg frame */
        const stewart_real z_x = inv_across*s_cross_normal_x;
        const stewart_real z_y = inv_across*s_cross_normal_y;
        const stewart_real z_z = inv_across*s_cross_normal_z;
        /* (10) rotating axis of the universal joint */
        const stewart_real y_x = STEWART_FMA(-s_y, z_z, s_z*z_y);
        const stewart_real y_y = STEWART_FMA(-s_z, z_x, s_x*z_z);
        const stewart_real y_z = STEWART_FMA(-s_x, z_y, s_y*z_x);
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1 = inv_L*zeta;
        const stewart_real k3 = inv_L*rho;
        /* (10) k1 / k3 */
        const stewart_real kappa = inv_rho*zeta;
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(omega_z, -q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(omega_x, -q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(omega_y, -q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
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
        /* (7) acceleration of the platform point, a = alpha = 0 */
        const stewart_real S_ddot_x = STEWART_FMA(B_0_xz, q_z, STEWART_FMA(B_0_xy, q_y, B_0_xx*q_x));
        const stewart_real S_ddot_y = STEWART_FMA(B_0_yz, q_z, STEWART_FMA(B_0_yy, q_y, B_0_yx*q_x));
        const stewart_real S_ddot_z = STEWART_FMA(B_0_zz, q_z, STEWART_FMA(B_0_zy, q_y, B_0_zx*q_x));
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
        const stewart_real c4 = F - D;
        /* force on the platform at the tip */
        const stewart_real push_x = STEWART_FMA(c4, s_x, -K_x);
        const stewart_real push_y = STEWART_FMA(c4, s_y, -K_y);
        const stewart_real push_z = STEWART_FMA(c4, s_z, -K_z);
        /* inertia at the tip, leg frame */
        const stewart_real m_leg_sy = -inv_rho*k3_h;
        const stewart_real m_leg_sz = -h_z*inv_L;
        const stewart_real m_leg_yy = M_phi*inv_rho*inv_rho;
        const stewart_real m_leg_yz = -M_mixed*inv_L*inv_rho;
        const stewart_real m_leg_zz = M_theta*inv_L*inv_L;
        const stewart_real m_T_xs = STEWART_FMA(m_leg_sy, y_x, m_leg_sz*z_x);
        const stewart_real m_T_xy = STEWART_FMA(m_leg_yz, z_x, STEWART_FMA(m_leg_yy, y_x, m_leg_sy*s_x));
        const stewart_real m_T_xz = STEWART_FMA(m_leg_yz, y_x, STEWART_FMA(m_leg_zz, z_x, m_leg_sz*s_x));
        const stewart_real m_T_ys = STEWART_FMA(m_leg_sy, y_y, m_leg_sz*z_y);
        const stewart_real m_T_yy = STEWART_FMA(m_leg_yz, z_y, STEWART_FMA(m_leg_yy, y_y, m_leg_sy*s_y));
        const stewart_real m_T_yz = STEWART_FMA(m_leg_yz, y_y, STEWART_FMA(m_leg_zz, z_y, m_leg_sz*s_y));
        const stewart_real m_T_zs = STEWART_FMA(m_leg_sy, y_z, m_leg_sz*z_z);
        const stewart_real m_T_zy = STEWART_FMA(m_leg_yz, z_z, STEWART_FMA(m_leg_yy, y_z, m_leg_sy*s_z));
        const stewart_real m_T_zz = STEWART_FMA(m_leg_yz, y_z, STEWART_FMA(m_leg_zz, z_z, m_leg_sz*s_z));
        /* inertia at the tip, base frame */
        const stewart_real m_xx = STEWART_FMA(m_T_xy, y_x, STEWART_FMA(m_T_xz, z_x, m_T_xs*s_x));
        const stewart_real m_xy = STEWART_FMA(m_T_xy, y_y, STEWART_FMA(m_T_xz, z_y, m_T_xs*s_y));
        const stewart_real m_xz = STEWART_FMA(m_T_xy, y_z, STEWART_FMA(m_T_xz, z_z, m_T_xs*s_z));
        const stewart_real m_yy = STEWART_FMA(m_T_yy, y_y, STEWART_FMA(m_T_yz, z_y, m_T_ys*s_y));
        const stewart_real m_yz = STEWART_FMA(m_T_yy, y_z, STEWART_FMA(m_T_yz, z_z, m_T_ys*s_z));
        const stewart_real m_zz = STEWART_FMA(m_T_zy, y_z, STEWART_FMA(m_T_zz, z_z, m_T_zs*s_z));
        const stewart_real c5 = m_xy*q_z;
        const stewart_real c6 = m_xz*q_y;
        const stewart_real c7 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c5 - c6;
        const stewart_real m_q_xy = STEWART_FMA(-m_xx, q_z, m_xz*q_x);
        const stewart_real m_q_xz = STEWART_FMA(-m_xy, q_x, m_xx*q_y);
        const stewart_real m_q_yx = STEWART_FMA(-m_yz, q_y, m_yy*q_z);
        const stewart_real m_q_yy = -c5 - c7;
        const stewart_real m_q_yz = STEWART_FMA(-m_yy, q_x, m_xy*q_y);
        const stewart_real m_q_zx = STEWART_FMA(-m_zz, q_y, m_yz*q_z);
        const stewart_real m_q_zy = STEWART_FMA(-m_xz, q_z, m_zz*q_x);
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
        out->sum[15][l] = STEWART_FMA(-m_q_zx, q_y, m_q_yx*q_z);
        out->sum[16][l] = STEWART_FMA(-m_q_zy, q_y, m_q_yy*q_z);
        out->sum[17][l] = STEWART_FMA(-m_q_zz, q_y, m_q_yz*q_z);
        out->sum[18][l] = STEWART_FMA(-m_q_xy, q_z, m_q_zy*q_x);
        out->sum[19][l] = STEWART_FMA(-m_q_xz, q_z, m_q_zz*q_x);
        out->sum[20][l] = STEWART_FMA(-m_q_yz, q_x, m_q_xz*q_y);
        out->sum[21][l] = push_x;
        out->sum[22][l] = push_y;
        out->sum[23][l] = push_z;
        out->sum[24][l] = STEWART_FMA(C_s, STEWART_FMA(theta_dot, y_x, k_x*phi_dot), STEWART_FMA(-push_y,
            q_z, push_z*q_y));
        out->sum[25][l] = STEWART_FMA(C_s, STEWART_FMA(theta_dot, y_y, k_y*phi_dot), STEWART_FMA(-push_z,
            q_x, push_x*q_z));
        out->sum[26][l] = STEWART_FMA(C_s, STEWART_FMA(theta_dot, y_z, k_z*phi_dot), STEWART_FMA(-push_x,
            q_y, push_y*q_x));
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* Computes the sums over platform and legs; ``status`` is the status of the legs. */
static void forward_sums(
    const stewart_exact_model *model, const stewart_motion *motion, forward_legs *legs,
    stewart_real summed[27])
{
    int l;
    motion_in_lanes at;
    forward_pose pose;
    at.R[0][0] = motion->R[0];
    at.R[1][0] = motion->R[1];
    at.R[2][0] = motion->R[2];
    at.R[3][0] = motion->R[3];
    at.R[4][0] = motion->R[4];
    at.R[5][0] = motion->R[5];
    at.R[6][0] = motion->R[6];
    at.R[7][0] = motion->R[7];
    at.R[8][0] = motion->R[8];
    at.omega[0][0] = motion->omega[0];
    at.omega[1][0] = motion->omega[1];
    at.omega[2][0] = motion->omega[2];
    at.F_ext[0][0] = motion->F_ext[0];
    at.F_ext[1][0] = motion->F_ext[1];
    at.F_ext[2][0] = motion->F_ext[2];
    at.M_ext[0][0] = motion->M_ext[0];
    at.M_ext[1][0] = motion->M_ext[1];
    at.M_ext[2][0] = motion->M_ext[2];
    forward_of_pose(model, &at, 1, &pose, summed);
    for (l = 6; l < 8; ++l) {
        legs->F[l] = legs->F[5];
    }
    forward_of_leg(model, motion, &pose, legs);
    legs->status = legs_status(&legs->checked);
    if (legs->status == STEWART_OK) {
        add_legs(legs->sum, 27, summed);
    }
}

/* Accelerations from M and the right side, by L D L^T, and the pivots. */
static STEWART_INLINE void solve_inertia(
    const stewart_real *STEWART_RESTRICT number, int lanes, stewart_real *STEWART_RESTRICT result,
    stewart_real *STEWART_RESTRICT pivot)
{
    int l;
    for (l = 0; l < lanes; ++l) {
        const stewart_real y_0 = number[21*lanes + l], a_0_0 = number[0*lanes + l], a_0_1 = number[1*lanes + l],
            a_0_2 = number[2*lanes + l], a_0_3 = number[6*lanes + l], a_0_4 = number[7*lanes + l], a_0_5 = number[8*lanes
            + l];
        stewart_real y_1 = number[22*lanes + l], a_1_1 = number[3*lanes + l], a_1_2 = number[4*lanes + l],
            a_1_3 = number[9*lanes + l], a_1_4 = number[10*lanes + l], a_1_5 = number[11*lanes + l], y_2 = number[23*lanes
            + l], a_2_2 = number[5*lanes + l], a_2_3 = number[12*lanes + l], a_2_4 = number[13*lanes + l],
            a_2_5 = number[14*lanes + l], y_3 = number[24*lanes + l], a_3_3 = number[15*lanes + l], a_3_4 = number[16*lanes
            + l], a_3_5 = number[17*lanes + l], y_4 = number[25*lanes + l], a_4_4 = number[18*lanes + l],
            a_4_5 = number[19*lanes + l], y_5 = number[26*lanes + l], a_5_5 = number[20*lanes + l];
        pivot[lanes*0 + l] = a_0_0;
        const stewart_real inverse_0 = REAL(1)/a_0_0;
        const stewart_real factor_0_1 = a_0_1*inverse_0;
        a_1_1 = STEWART_FMA(-factor_0_1, a_0_1, a_1_1);
        a_1_2 = STEWART_FMA(-factor_0_1, a_0_2, a_1_2);
        a_1_3 = STEWART_FMA(-factor_0_1, a_0_3, a_1_3);
        a_1_4 = STEWART_FMA(-factor_0_1, a_0_4, a_1_4);
        a_1_5 = STEWART_FMA(-factor_0_1, a_0_5, a_1_5);
        y_1 = STEWART_FMA(-factor_0_1, y_0, y_1);
        const stewart_real factor_0_2 = a_0_2*inverse_0;
        a_2_2 = STEWART_FMA(-factor_0_2, a_0_2, a_2_2);
        a_2_3 = STEWART_FMA(-factor_0_2, a_0_3, a_2_3);
        a_2_4 = STEWART_FMA(-factor_0_2, a_0_4, a_2_4);
        a_2_5 = STEWART_FMA(-factor_0_2, a_0_5, a_2_5);
        y_2 = STEWART_FMA(-factor_0_2, y_0, y_2);
        const stewart_real factor_0_3 = a_0_3*inverse_0;
        a_3_3 = STEWART_FMA(-factor_0_3, a_0_3, a_3_3);
        a_3_4 = STEWART_FMA(-factor_0_3, a_0_4, a_3_4);
        a_3_5 = STEWART_FMA(-factor_0_3, a_0_5, a_3_5);
        y_3 = STEWART_FMA(-factor_0_3, y_0, y_3);
        const stewart_real factor_0_4 = a_0_4*inverse_0;
        a_4_4 = STEWART_FMA(-factor_0_4, a_0_4, a_4_4);
        a_4_5 = STEWART_FMA(-factor_0_4, a_0_5, a_4_5);
        y_4 = STEWART_FMA(-factor_0_4, y_0, y_4);
        const stewart_real factor_0_5 = a_0_5*inverse_0;
        a_5_5 = STEWART_FMA(-factor_0_5, a_0_5, a_5_5);
        y_5 = STEWART_FMA(-factor_0_5, y_0, y_5);
        pivot[lanes*1 + l] = a_1_1;
        const stewart_real inverse_1 = REAL(1)/a_1_1;
        const stewart_real factor_1_2 = a_1_2*inverse_1;
        a_2_2 = STEWART_FMA(-factor_1_2, a_1_2, a_2_2);
        a_2_3 = STEWART_FMA(-factor_1_2, a_1_3, a_2_3);
        a_2_4 = STEWART_FMA(-factor_1_2, a_1_4, a_2_4);
        a_2_5 = STEWART_FMA(-factor_1_2, a_1_5, a_2_5);
        y_2 = STEWART_FMA(-factor_1_2, y_1, y_2);
        const stewart_real factor_1_3 = a_1_3*inverse_1;
        a_3_3 = STEWART_FMA(-factor_1_3, a_1_3, a_3_3);
        a_3_4 = STEWART_FMA(-factor_1_3, a_1_4, a_3_4);
        a_3_5 = STEWART_FMA(-factor_1_3, a_1_5, a_3_5);
        y_3 = STEWART_FMA(-factor_1_3, y_1, y_3);
        const stewart_real factor_1_4 = a_1_4*inverse_1;
        a_4_4 = STEWART_FMA(-factor_1_4, a_1_4, a_4_4);
        a_4_5 = STEWART_FMA(-factor_1_4, a_1_5, a_4_5);
        y_4 = STEWART_FMA(-factor_1_4, y_1, y_4);
        const stewart_real factor_1_5 = a_1_5*inverse_1;
        a_5_5 = STEWART_FMA(-factor_1_5, a_1_5, a_5_5);
        y_5 = STEWART_FMA(-factor_1_5, y_1, y_5);
        pivot[lanes*2 + l] = a_2_2;
        const stewart_real inverse_2 = REAL(1)/a_2_2;
        const stewart_real factor_2_3 = a_2_3*inverse_2;
        a_3_3 = STEWART_FMA(-factor_2_3, a_2_3, a_3_3);
        a_3_4 = STEWART_FMA(-factor_2_3, a_2_4, a_3_4);
        a_3_5 = STEWART_FMA(-factor_2_3, a_2_5, a_3_5);
        y_3 = STEWART_FMA(-factor_2_3, y_2, y_3);
        const stewart_real factor_2_4 = a_2_4*inverse_2;
        a_4_4 = STEWART_FMA(-factor_2_4, a_2_4, a_4_4);
        a_4_5 = STEWART_FMA(-factor_2_4, a_2_5, a_4_5);
        y_4 = STEWART_FMA(-factor_2_4, y_2, y_4);
        const stewart_real factor_2_5 = a_2_5*inverse_2;
        a_5_5 = STEWART_FMA(-factor_2_5, a_2_5, a_5_5);
        y_5 = STEWART_FMA(-factor_2_5, y_2, y_5);
        pivot[lanes*3 + l] = a_3_3;
        const stewart_real inverse_3 = REAL(1)/a_3_3;
        const stewart_real factor_3_4 = a_3_4*inverse_3;
        a_4_4 = STEWART_FMA(-factor_3_4, a_3_4, a_4_4);
        a_4_5 = STEWART_FMA(-factor_3_4, a_3_5, a_4_5);
        y_4 = STEWART_FMA(-factor_3_4, y_3, y_4);
        const stewart_real factor_3_5 = a_3_5*inverse_3;
        a_5_5 = STEWART_FMA(-factor_3_5, a_3_5, a_5_5);
        y_5 = STEWART_FMA(-factor_3_5, y_3, y_5);
        pivot[lanes*4 + l] = a_4_4;
        const stewart_real inverse_4 = REAL(1)/a_4_4;
        const stewart_real factor_4_5 = a_4_5*inverse_4;
        a_5_5 = STEWART_FMA(-factor_4_5, a_4_5, a_5_5);
        y_5 = STEWART_FMA(-factor_4_5, y_4, y_5);
        pivot[lanes*5 + l] = a_5_5;
        const stewart_real inverse_5 = REAL(1)/a_5_5;
        const stewart_real x_5 = y_5*inverse_5;
        stewart_real x_4 = y_4*inverse_4;
        x_4 = STEWART_FMA(-factor_4_5, x_5, x_4);
        stewart_real x_3 = y_3*inverse_3;
        x_3 = STEWART_FMA(-factor_3_5, x_5, x_3);
        x_3 = STEWART_FMA(-factor_3_4, x_4, x_3);
        stewart_real x_2 = y_2*inverse_2;
        x_2 = STEWART_FMA(-factor_2_5, x_5, x_2);
        x_2 = STEWART_FMA(-factor_2_4, x_4, x_2);
        x_2 = STEWART_FMA(-factor_2_3, x_3, x_2);
        stewart_real x_1 = y_1*inverse_1;
        x_1 = STEWART_FMA(-factor_1_5, x_5, x_1);
        x_1 = STEWART_FMA(-factor_1_4, x_4, x_1);
        x_1 = STEWART_FMA(-factor_1_3, x_3, x_1);
        x_1 = STEWART_FMA(-factor_1_2, x_2, x_1);
        stewart_real x_0 = y_0*inverse_0;
        x_0 = STEWART_FMA(-factor_0_5, x_5, x_0);
        x_0 = STEWART_FMA(-factor_0_4, x_4, x_0);
        x_0 = STEWART_FMA(-factor_0_3, x_3, x_0);
        x_0 = STEWART_FMA(-factor_0_2, x_2, x_0);
        x_0 = STEWART_FMA(-factor_0_1, x_1, x_0);
        result[lanes*0 + l] = x_0;
        result[lanes*1 + l] = x_1;
        result[lanes*2 + l] = x_2;
        result[lanes*3 + l] = x_3;
        result[lanes*4 + l] = x_4;
        result[lanes*5 + l] = x_5;
    }
}

/* The accelerations of a pose; MASS_MATRIX_INDEFINITE if elimination loses too many digits of M. */
static void accelerations_of(
    const forward_legs *legs, const stewart_real summed[27], forward_dynamics_found *out)
{
    stewart_real pivot[6];
    out->status = legs->status;
    if (legs->status == STEWART_OK) {
        solve_inertia(summed, 1, out->acceleration, pivot);
        if (out->status == STEWART_OK && !(pivot[0] > STEWART_KEPT*summed[0])) {
            out->status = STEWART_FABS(pivot[0]) <= STEWART_MAX ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_NOT_FINITE;
        }
        if (out->status == STEWART_OK && !(pivot[1] > STEWART_KEPT*summed[3])) {
            out->status = STEWART_FABS(pivot[1]) <= STEWART_MAX ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_NOT_FINITE;
        }
        if (out->status == STEWART_OK && !(pivot[2] > STEWART_KEPT*summed[5])) {
            out->status = STEWART_FABS(pivot[2]) <= STEWART_MAX ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_NOT_FINITE;
        }
        if (out->status == STEWART_OK && !(pivot[3] > STEWART_KEPT*summed[15])) {
            out->status = STEWART_FABS(pivot[3]) <= STEWART_MAX ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_NOT_FINITE;
        }
        if (out->status == STEWART_OK && !(pivot[4] > STEWART_KEPT*summed[18])) {
            out->status = STEWART_FABS(pivot[4]) <= STEWART_MAX ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_NOT_FINITE;
        }
        if (out->status == STEWART_OK && !(pivot[5] > STEWART_KEPT*summed[20])) {
            out->status = STEWART_FABS(pivot[5]) <= STEWART_MAX ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_NOT_FINITE;
        }
    }
}

/* Sets the status if a number of a result is not finite. */
static void check_forward_dynamics(forward_dynamics_found *out)
{
    int i;
    if (out->status != STEWART_OK) {
        return;
    }
    for (i = 0; i < 6; ++i) {
        if (!(STEWART_FABS(out->acceleration[i]) <= STEWART_MAX)) {
            out->status = STEWART_NOT_FINITE;
            return;
        }
    }
}

typedef struct {
    stewart_real B_0[9][LANES];
} STEWART_ALIGNED joint_rows_pose;

typedef struct {
    stewart_real sum[27][LANES];
    stewart_real F[LANES];
    stewart_real M_xi[6][LANES];
    stewart_real row_v[9][LANES];
    stewart_real row_w[9][LANES];
    stewart_real tau[3][LANES];
    leg_checks checked;
    int status;
} STEWART_ALIGNED joint_rows_legs;

/* Computes the terms of the platform, for one pose or eight. */
static STEWART_INLINE void joint_rows_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const motion_in_lanes *STEWART_RESTRICT at,
    int lanes, joint_rows_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT summed)
{
    int l;
    const stewart_real C_P = model->C_P;
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    const stewart_real M = model->M;
    const stewart_real R_0_x = model->R_0[0], R_0_y = model->R_0[1], R_0_z = model->R_0[2];
    const stewart_real I_p_xx = model->I_p[0], I_p_xy = model->I_p[1], I_p_xz = model->I_p[2], I_p_yy = model->I_p[3],
        I_p_yz = model->I_p[4], I_p_zz = model->I_p[5];
    for (l = 0; l < lanes; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        const stewart_real F_ext_x = at->F_ext[0][l], F_ext_y = at->F_ext[1][l], F_ext_z = at->F_ext[2][l];
        const stewart_real M_ext_x = at->M_ext[0][l], M_ext_y = at->M_ext[1][l], M_ext_z = at->M_ext[2][l];
        const stewart_real c1 = R_0_y*R_0_y;
        const stewart_real c2 = R_0_z*R_0_z;
        const stewart_real J_0_xx = STEWART_FMA(M, c1 + c2, I_p_xx);
        const stewart_real c3 = M*R_0_x;
        const stewart_real J_0_xy = STEWART_FMA(R_0_y, -c3, I_p_xy);
        const stewart_real J_0_xz = STEWART_FMA(R_0_z, -c3, I_p_xz);
        const stewart_real c4 = R_0_x*R_0_x;
        const stewart_real J_0_yy = STEWART_FMA(M, c2 + c4, I_p_yy);
        const stewart_real c5 = M*R_0_y;
        const stewart_real J_0_yz = STEWART_FMA(R_0_z, -c5, I_p_yz);
        const stewart_real J_0_zz = STEWART_FMA(M, c1 + c4, I_p_zz);
        const stewart_real c6 = M*R_0_z;
        /* (30) first moment of the platform, base frame */
        const stewart_real h_base_x = STEWART_FMA(R_xz, c6, STEWART_FMA(R_xy, c5, R_xx*c3));
        const stewart_real h_base_y = STEWART_FMA(R_yz, c6, STEWART_FMA(R_yy, c5, R_yx*c3));
        const stewart_real h_base_z = STEWART_FMA(R_zz, c6, STEWART_FMA(R_zy, c5, R_zx*c3));
        const stewart_real c7 = STEWART_FMA(J_0_xx, R_xx, STEWART_FMA(J_0_xz, R_xz, J_0_xy*R_xy));
        const stewart_real c8 = STEWART_FMA(J_0_yy, R_xy, STEWART_FMA(J_0_yz, R_xz, J_0_xy*R_xx));
        const stewart_real c9 = STEWART_FMA(J_0_zz, R_xz, STEWART_FMA(J_0_yz, R_xy, J_0_xz*R_xx));
        const stewart_real c10 = STEWART_FMA(J_0_xx, R_yx, STEWART_FMA(J_0_xz, R_yz, J_0_xy*R_yy));
        const stewart_real c11 = STEWART_FMA(J_0_yy, R_yy, STEWART_FMA(J_0_yz, R_yz, J_0_xy*R_yx));
        const stewart_real c12 = STEWART_FMA(J_0_zz, R_yz, STEWART_FMA(J_0_yz, R_yy, J_0_xz*R_yx));
        /* (32) inertia of the platform, base frame */
        const stewart_real J_base_xx = STEWART_FMA(R_xz, c9, STEWART_FMA(R_xy, c8, R_xx*c7));
        const stewart_real J_base_xy = STEWART_FMA(R_yz, c9, STEWART_FMA(R_yy, c8, R_yx*c7));
        const stewart_real J_base_xz = STEWART_FMA(R_zz, c9, STEWART_FMA(R_zy, c8, R_zx*c7));
        const stewart_real J_base_yy = STEWART_FMA(R_yz, c12, STEWART_FMA(R_yy, c11, R_yx*c10));
        const stewart_real J_base_yz = STEWART_FMA(R_zz, c12, STEWART_FMA(R_zy, c11, R_zx*c10));
        const stewart_real J_base_zz = STEWART_FMA(R_zz, STEWART_FMA(J_0_zz, R_zz, STEWART_FMA(J_0_yz, R_zy,
            J_0_xz*R_zx)), STEWART_FMA(R_zy, STEWART_FMA(J_0_yy, R_zy, STEWART_FMA(J_0_yz, R_zz,
            J_0_xy*R_zx)), R_zx*STEWART_FMA(J_0_xx, R_zx, STEWART_FMA(J_0_xz, R_zz, J_0_xy*R_zy))));
        /* (31) omega x h */
        const stewart_real w_h_x = STEWART_FMA(-h_base_y, omega_z, h_base_z*omega_y);
        const stewart_real w_h_y = STEWART_FMA(-h_base_z, omega_x, h_base_x*omega_z);
        const stewart_real w_h_z = STEWART_FMA(-h_base_x, omega_y, h_base_y*omega_x);
        /* (34) I omega */
        const stewart_real J_w_x = STEWART_FMA(J_base_xz, omega_z, STEWART_FMA(J_base_xy, omega_y,
            J_base_xx*omega_x));
        const stewart_real J_w_y = STEWART_FMA(J_base_yz, omega_z, STEWART_FMA(J_base_yy, omega_y,
            J_base_xy*omega_x));
        const stewart_real J_w_z = STEWART_FMA(J_base_zz, omega_z, STEWART_FMA(J_base_yz, omega_y,
            J_base_xz*omega_x));
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
        out->B_0[0][l] = B_xx;
        out->B_0[1][l] = omega_xy;
        out->B_0[2][l] = omega_xz;
        out->B_0[3][l] = omega_xy;
        out->B_0[4][l] = B_yy;
        out->B_0[5][l] = omega_yz;
        out->B_0[6][l] = omega_xz;
        out->B_0[7][l] = omega_yz;
        out->B_0[8][l] = B_zz;
        summed[0*lanes + l] = M;
        summed[1*lanes + l] = REAL(0);
        summed[2*lanes + l] = REAL(0);
        summed[3*lanes + l] = M;
        summed[4*lanes + l] = REAL(0);
        summed[5*lanes + l] = M;
        summed[6*lanes + l] = REAL(0);
        summed[7*lanes + l] = h_base_z;
        summed[8*lanes + l] = -h_base_y;
        summed[9*lanes + l] = -h_base_z;
        summed[10*lanes + l] = REAL(0);
        summed[11*lanes + l] = h_base_x;
        summed[12*lanes + l] = h_base_y;
        summed[13*lanes + l] = -h_base_x;
        summed[14*lanes + l] = REAL(0);
        summed[15*lanes + l] = J_base_xx;
        summed[16*lanes + l] = J_base_xy;
        summed[17*lanes + l] = J_base_xz;
        summed[18*lanes + l] = J_base_yy;
        summed[19*lanes + l] = J_base_yz;
        summed[20*lanes + l] = J_base_zz;
        summed[21*lanes + l] = STEWART_FMA(-omega_y, w_h_z, STEWART_FMA(omega_z, w_h_y, STEWART_FMA(M, g_x,
            STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy, F_ext_x*R_xx)))));
        summed[22*lanes + l] = STEWART_FMA(-omega_z, w_h_x, STEWART_FMA(omega_x, w_h_z, STEWART_FMA(M, g_y,
            STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy, F_ext_x*R_yx)))));
        summed[23*lanes + l] = STEWART_FMA(-omega_x, w_h_y, STEWART_FMA(omega_y, w_h_x, STEWART_FMA(M, g_z,
            STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy, F_ext_x*R_zx)))));
        summed[24*lanes + l] = STEWART_FMA(g_y, -h_base_z, STEWART_FMA(-J_w_z, omega_y, STEWART_FMA(C_P,
            -omega_x, STEWART_FMA(g_z, h_base_y, STEWART_FMA(M_ext_z, R_xz, STEWART_FMA(M_ext_y, R_xy,
            STEWART_FMA(M_ext_x, R_xx, J_w_y*omega_z)))))));
        summed[25*lanes + l] = STEWART_FMA(g_z, -h_base_x, STEWART_FMA(-J_w_x, omega_z, STEWART_FMA(C_P,
            -omega_y, STEWART_FMA(g_x, h_base_z, STEWART_FMA(M_ext_z, R_yz, STEWART_FMA(M_ext_y, R_yy,
            STEWART_FMA(M_ext_x, R_yx, J_w_z*omega_x)))))));
        summed[26*lanes + l] = STEWART_FMA(g_x, -h_base_y, STEWART_FMA(-J_w_y, omega_x, STEWART_FMA(C_P,
            -omega_z, STEWART_FMA(g_y, h_base_x, STEWART_FMA(M_ext_z, R_zz, STEWART_FMA(M_ext_y, R_zy,
            STEWART_FMA(M_ext_x, R_zx, J_w_x*omega_y)))))));
    }
}

/* Computes the legs of a pose in lanes. */
STEWART_APART static void joint_rows_of_leg(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT motion,
    const joint_rows_pose *STEWART_RESTRICT pose, joint_rows_legs *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = motion->R[0], R_xy = motion->R[1], R_xz = motion->R[2], R_yx = motion->R[3],
        R_yy = motion->R[4], R_yz = motion->R[5], R_zx = motion->R[6], R_zy = motion->R[7], R_zz = motion->R[8];
    const stewart_real t_x = motion->t[0], t_y = motion->t[1], t_z = motion->t[2];
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    const stewart_real B_0_xx = pose->B_0[0][0], B_0_xy = pose->B_0[1][0], B_0_xz = pose->B_0[2][0], B_0_yx = pose->B_0[3][0],
        B_0_yy = pose->B_0[4][0], B_0_yz = pose->B_0[5][0], B_0_zx = pose->B_0[6][0], B_0_zy = pose->B_0[7][0],
        B_0_zz = pose->B_0[8][0];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real m_u = model->m_u[l];
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
        const stewart_real F = out->F[l];
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
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(omega_z, -q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(omega_x, -q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(omega_y, -q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
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
        const stewart_real c1 = STEWART_FMA(B_0_xz, q_z, STEWART_FMA(B_0_xy, q_y, B_0_xx*q_x));
        const stewart_real c2 = STEWART_FMA(B_0_yz, q_z, STEWART_FMA(B_0_yy, q_y, B_0_yx*q_x));
        const stewart_real c3 = STEWART_FMA(B_0_zz, q_z, STEWART_FMA(B_0_zy, q_y, B_0_zx*q_x));
        /* (7) acceleration of the platform point, a = alpha = 0 */
        const stewart_real S_ddot_x = c1;
        const stewart_real S_ddot_y = c2;
        const stewart_real S_ddot_z = c3;
        const stewart_real c4 = k3*k3;
        const stewart_real k33 = c4;
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y,
            STEWART_FMA(S_ddot_x, s_x, L*STEWART_FMA(k33, phi_dot2, theta_dot2))));
        /* (9) accelerations of the joint coordinates without the rotation of the leg frame about s */
        const stewart_real own_theta_ddot = STEWART_FMA(REAL(2)*L_share, -theta_dot,
            -inv_L*STEWART_FMA(S_ddot_z, z_z, STEWART_FMA(S_ddot_y, z_y, S_ddot_x*z_x)));
        const stewart_real own_phi_ddot = STEWART_FMA(-L_share, two_phi_dot, inv_rho*STEWART_FMA(S_ddot_z,
            y_z, STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)));
        const stewart_real c5 = k1*k3;
        /* (9) accelerations of the joint coordinates */
        const stewart_real theta_ddot = STEWART_FMA(c5, phi_dot2, own_theta_ddot);
        const stewart_real phi_ddot = STEWART_FMA(-lean, two_phi_dot, own_phi_ddot);
        const stewart_real k13 = c5;
        const stewart_real L_h2 = L*h2_x;
        const stewart_real a1 = dJ_zx + L_h2;
        const stewart_real c6 = L*h2_z;
        const stewart_real c7 = J2_xz - c6;
        const stewart_real a2 = c7;
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
            STEWART_FMA(phi_dot2, STEWART_FMA(-c7, STEWART_HALF - k33, k13*(J_yy - dJ_zx)), STEWART_FMA(g_k,
            w_n, L_ddot*h_z))))))));
        const stewart_real tau_k = STEWART_FMA(M_phi, own_phi_ddot, STEWART_FMA(M_mixed, theta_ddot,
            STEWART_FMA(bend*h2_y, -k1, STEWART_FMA(two_phi_dot, STEWART_FMA(-theta_dot, STEWART_FMA(J_xx,
            kappa, STEWART_FMA(STEWART_HALF, -c6, STEWART_HALF*J2_xz)), L_dot*M_phi_L),
            STEWART_FMA(-gamma_y, w_n, STEWART_FMA(-gamma_n, w_y, STEWART_FMA(C_us, phi_dot,
            STEWART_FMA(-L_ddot, k3_h, STEWART_FMA(-C_s, STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y,
            k_x*omega_x)), M_mixed_theta*theta_dot2)))))))));
        /* acceleration of the platform point relative to free fall, a = alpha = 0 */
        const stewart_real fall_x = c1 - g_x;
        const stewart_real fall_y = c2 - g_y;
        const stewart_real fall_z = c3 - g_z;
        const stewart_real fall_T_x = STEWART_FMA(fall_z, s_z, STEWART_FMA(fall_y, s_y, fall_x*s_x));
        const stewart_real fall_T_y = STEWART_FMA(fall_z, y_z, STEWART_FMA(fall_y, y_y, fall_x*y_x));
        const stewart_real fall_T_z = STEWART_FMA(fall_z, z_z, STEWART_FMA(fall_y, z_y, fall_x*z_x));
        const stewart_real row_v_yx = -inv_L*z_x;
        const stewart_real row_v_yy = -inv_L*z_y;
        const stewart_real row_v_yz = -inv_L*z_z;
        const stewart_real row_v_zx = inv_rho*y_x;
        const stewart_real row_v_zy = inv_rho*y_y;
        const stewart_real row_v_zz = inv_rho*y_z;
        const stewart_real c8 = m_u*L*L;
        const stewart_real c9 = L*m_u;
        out->sum[0][l] = REAL(0);
        out->sum[1][l] = REAL(0);
        out->sum[2][l] = REAL(0);
        out->sum[3][l] = REAL(0);
        out->sum[4][l] = REAL(0);
        out->sum[5][l] = REAL(0);
        out->sum[6][l] = REAL(0);
        out->sum[7][l] = REAL(0);
        out->sum[8][l] = REAL(0);
        out->sum[9][l] = REAL(0);
        out->sum[10][l] = REAL(0);
        out->sum[11][l] = REAL(0);
        out->sum[12][l] = REAL(0);
        out->sum[13][l] = REAL(0);
        out->sum[14][l] = REAL(0);
        out->sum[15][l] = REAL(0);
        out->sum[16][l] = REAL(0);
        out->sum[17][l] = REAL(0);
        out->sum[18][l] = REAL(0);
        out->sum[19][l] = REAL(0);
        out->sum[20][l] = REAL(0);
        out->sum[21][l] = REAL(0);
        out->sum[22][l] = REAL(0);
        out->sum[23][l] = REAL(0);
        out->sum[24][l] = C_s*STEWART_FMA(theta_dot, y_x, k_x*phi_dot);
        out->sum[25][l] = C_s*STEWART_FMA(theta_dot, y_y, k_y*phi_dot);
        out->sum[26][l] = C_s*STEWART_FMA(theta_dot, y_z, k_z*phi_dot);
        out->M_xi[0][l] = m_u;
        out->M_xi[1][l] = h_z;
        out->M_xi[2][l] = -k3_h;
        out->M_xi[3][l] = M_theta + c8;
        out->M_xi[4][l] = M_mixed;
        out->M_xi[5][l] = STEWART_FMA(c4, c8, M_phi);
        out->row_v[0][l] = s_x;
        out->row_v[1][l] = s_y;
        out->row_v[2][l] = s_z;
        out->row_v[3][l] = row_v_yx;
        out->row_v[4][l] = row_v_yy;
        out->row_v[5][l] = row_v_yz;
        out->row_v[6][l] = row_v_zx;
        out->row_v[7][l] = row_v_zy;
        out->row_v[8][l] = row_v_zz;
        out->row_w[0][l] = STEWART_FMA(-q_z, s_y, q_y*s_z);
        out->row_w[1][l] = STEWART_FMA(-q_x, s_z, q_z*s_x);
        out->row_w[2][l] = STEWART_FMA(-q_y, s_x, q_x*s_y);
        out->row_w[3][l] = STEWART_FMA(-q_z, row_v_yy, q_y*row_v_yz);
        out->row_w[4][l] = STEWART_FMA(-q_x, row_v_yz, q_z*row_v_yx);
        out->row_w[5][l] = STEWART_FMA(-q_y, row_v_yx, q_x*row_v_yy);
        out->row_w[6][l] = STEWART_FMA(-q_z, row_v_zy, q_y*row_v_zz);
        out->row_w[7][l] = STEWART_FMA(-q_x, row_v_zz, q_z*row_v_zx);
        out->row_w[8][l] = STEWART_FMA(-q_y, row_v_zx, q_x*row_v_zy);
        out->tau[0][l] = STEWART_FMA(-k3_h, phi_ddot, STEWART_FMA(-h_x, theta_dot2, STEWART_FMA(-M_phi_L,
            phi_dot2, STEWART_FMA(h_z, theta_ddot, STEWART_FMA(fall_T_x, m_u, C_p*L_dot)) - F)));
        out->tau[1][l] = STEWART_FMA(-c9, fall_T_z, tau_y);
        out->tau[2][l] = STEWART_FMA(c9*fall_T_y, k3, tau_k);
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* Computes the sums over platform and legs; ``status`` is the status of the legs. */
static void joint_rows_sums(
    const stewart_exact_model *model, const stewart_motion *motion, joint_rows_legs *legs,
    stewart_real summed[27])
{
    int l;
    motion_in_lanes at;
    joint_rows_pose pose;
    at.R[0][0] = motion->R[0];
    at.R[1][0] = motion->R[1];
    at.R[2][0] = motion->R[2];
    at.R[3][0] = motion->R[3];
    at.R[4][0] = motion->R[4];
    at.R[5][0] = motion->R[5];
    at.R[6][0] = motion->R[6];
    at.R[7][0] = motion->R[7];
    at.R[8][0] = motion->R[8];
    at.omega[0][0] = motion->omega[0];
    at.omega[1][0] = motion->omega[1];
    at.omega[2][0] = motion->omega[2];
    at.F_ext[0][0] = motion->F_ext[0];
    at.F_ext[1][0] = motion->F_ext[1];
    at.F_ext[2][0] = motion->F_ext[2];
    at.M_ext[0][0] = motion->M_ext[0];
    at.M_ext[1][0] = motion->M_ext[1];
    at.M_ext[2][0] = motion->M_ext[2];
    joint_rows_of_pose(model, &at, 1, &pose, summed);
    for (l = 6; l < 8; ++l) {
        legs->F[l] = legs->F[5];
    }
    joint_rows_of_leg(model, motion, &pose, legs);
    legs->status = legs_status(&legs->checked);
    if (legs->status == STEWART_OK) {
        add_legs(legs->sum, 27, summed);
    }
}

/* Inertia of three coordinates, xx xy xz yy yz zz, as weights of rows of their sizes. */
static void weigh(const stewart_real inertia[6], int first, rows *by)
{
    int i;
    for (i = 0; i < 3; ++i) {
        by->weight[3*first + i] = inertia[i]/by->extent[first]/by->extent[first + i];
        by->weight[3*(first + i) + 0] = inertia[i]/by->extent[first + i]/by->extent[first];
    }
    by->weight[3*(first + 1) + 1] = inertia[3]/by->extent[first + 1]/by->extent[first + 1];
    by->weight[3*(first + 1) + 2] = inertia[4]/by->extent[first + 1]/by->extent[first + 2];
    by->weight[3*(first + 2) + 1] = inertia[4]/by->extent[first + 2]/by->extent[first + 1];
    by->weight[3*(first + 2) + 2] = inertia[5]/by->extent[first + 2]/by->extent[first + 2];
}

/* Rows and weights: each row of A carries the root of its inertia, so that weights are of about one. */
static void make_rows(const stewart_real summed[27], const joint_rows_legs *legs, rows *by)
{
    int i, j, k;
    const stewart_real mass = summed[0];
    stewart_real c[3] = {0, 0, 0};
    stewart_real about[6];
    stewart_real inertia[6];
    stewart_real whole[6] = {0, 0, 0, 0, 0, 0};
    stewart_real heaviest = STEWART_FABS(mass);
    stewart_real length = REAL(0);
    for (i = 0; i < 6; ++i) {
        const stewart_real rho = legs->checked.L[i]*legs->checked.k3[i];
        for (j = 0; j < 3; ++j) {
            length = STEWART_LARGER(STEWART_FABS(legs->row_w[j][i]), length);
        }
        heaviest = STEWART_LARGER(STEWART_FABS(legs->M_xi[3][i])/legs->checked.L[i]/legs->checked.L[i],
            heaviest);
        heaviest = STEWART_LARGER(STEWART_FABS(legs->M_xi[5][i])/rho/rho, heaviest);
    }
    const stewart_real least = STEWART_LARGER(STEWART_EPSILON*STEWART_SQRT(heaviest), STEWART_SHORTEST);
    by->length = length > REAL(0) ? length : REAL(1);
    for (i = 0; i < 6; ++i) {
        const stewart_real reach = least*legs->checked.L[i];
        const stewart_real theta = STEWART_LARGER(STEWART_SQRT(STEWART_FABS(legs->M_xi[3][i])), reach);
        const stewart_real phi = STEWART_LARGER(STEWART_SQRT(STEWART_FABS(legs->M_xi[5][i])),
            reach*legs->checked.k3[i]);
        stewart_real along = STEWART_LARGER(STEWART_FABS(legs->M_xi[1][i])/theta,
            STEWART_FABS(legs->M_xi[2][i])/phi);
        along = STEWART_LARGER(along, STEWART_SQRT(STEWART_FABS(legs->M_xi[0][i])));
        by->extent[3*i] = STEWART_LARGER(along, least);
        by->extent[3*i + 1] = theta;
        by->extent[3*i + 2] = phi;
        for (j = 0; j < 6; ++j) {
            inertia[j] = legs->M_xi[j][i];
        }
        weigh(inertia, 3*i, by);
        for (j = 0; j < 3; ++j) {
            for (k = 0; k < 3; ++k) {
                by->row[6*(3*i + j) + k] = by->extent[3*i + j]*legs->row_v[3*j + k][i];
                const stewart_real turn = legs->row_w[3*j + k][i]/by->length;
                by->row[6*(3*i + j) + (k + 3)] = by->extent[3*i + j]*turn;
            }
        }
    }
    for (i = 18; i < 24; ++i) {
        for (j = 0; j < 6; ++j) {
            by->row[6*i + j] = REAL(0);
        }
    }
    const stewart_real heft = STEWART_LARGER(STEWART_SQRT(STEWART_FABS(mass)), least);
    const stewart_real per_mass = mass > REAL(0) ? REAL(1)/mass : REAL(0);
    c[0] = summed[11]*per_mass;
    c[1] = (-summed[8])*per_mass;
    c[2] = summed[7]*per_mass;
    const stewart_real square = STEWART_FMA(c[2], c[2], STEWART_FMA(c[1], c[1], c[0]*c[0]));
    about[0] = STEWART_FMA(-mass, STEWART_FMA(-c[0], c[0], square), summed[15]);
    about[1] = STEWART_FMA(mass, c[0]*c[1], summed[16]);
    about[2] = STEWART_FMA(mass, c[0]*c[2], summed[17]);
    about[3] = STEWART_FMA(-mass, STEWART_FMA(-c[1], c[1], square), summed[18]);
    about[4] = STEWART_FMA(mass, c[1]*c[2], summed[19]);
    about[5] = STEWART_FMA(-mass, STEWART_FMA(-c[2], c[2], square), summed[20]);
    whole[0] = mass;
    whole[3] = mass;
    whole[5] = mass;
    by->extent[21] = STEWART_LARGER(STEWART_SQRT(STEWART_FABS(about[0])), least*by->length);
    by->extent[22] = STEWART_LARGER(STEWART_SQRT(STEWART_FABS(about[3])), least*by->length);
    by->extent[23] = STEWART_LARGER(STEWART_SQRT(STEWART_FABS(about[5])), least*by->length);
    for (i = 0; i < 3; ++i) {
        by->extent[18 + i] = heft;
        by->row[6*(18 + i) + i] = heft;
        by->row[6*(21 + i) + (i + 3)] = by->extent[21 + i]/by->length;
    }
    by->row[112] = heft*(c[2]/by->length);
    by->row[113] = (-heft)*(c[1]/by->length);
    by->row[119] = heft*(c[0]/by->length);
    by->row[117] = (-heft)*(c[2]/by->length);
    by->row[123] = heft*(c[1]/by->length);
    by->row[124] = (-heft)*(c[0]/by->length);
    weigh(whole, 18, by);
    weigh(about, 21, by);
}

/* Picks six rows as coordinates by elimination with complete pivoting; the others are sums of them.
 *
 * Rows and columns are exchanged: ``order`` and ``column`` say which they were. */
static void pick_rows(rows *by)
{
    int i, j, k;
    stewart_real share[6];
    for (i = 0; i < 24; ++i) {
        by->order[i] = i;
    }
    for (k = 0; k < 6; ++k) {
        by->column[k] = k;
    }
    for (k = 0; k < 6; ++k) {
        int best = k;
        int across = k;
        stewart_real most = STEWART_FABS(by->row[6*k + k]);
        for (i = k; i < 24; ++i) {
            for (j = k; j < 6; ++j) {
                const stewart_real entry = STEWART_FABS(by->row[6*i + j]);
                best = entry > most ? i : best;
                across = entry > most ? j : across;
                most = entry > most ? entry : most;
            }
        }
        const int row = by->order[k];
        by->order[k] = by->order[best];
        by->order[best] = row;
        const int column = by->column[k];
        by->column[k] = by->column[across];
        by->column[across] = column;
        for (j = 0; j < 6; ++j) {
            const stewart_real upper = by->row[6*k + j];
            by->row[6*k + j] = by->row[6*best + j];
            by->row[6*best + j] = upper;
        }
        for (i = 0; i < 24; ++i) {
            const stewart_real left = by->row[6*i + k];
            by->row[6*i + k] = by->row[6*i + across];
            by->row[6*i + across] = left;
        }
        for (i = k + 1; i < 24; ++i) {
            by->row[6*i + k] = by->row[6*i + k]/by->row[6*k + k];
            for (j = k + 1; j < 6; ++j) {
                by->row[6*i + j] = STEWART_FMA(-by->row[6*i + k], by->row[6*k + j], by->row[6*i + j]);
            }
        }
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            by->share[6*by->order[i] + j] = i == j ? REAL(1) : REAL(0);
        }
    }
    for (i = 6; i < 24; ++i) {
        for (j = 5; j >= 0; --j) {
            share[j] = by->row[6*i + j];
            for (k = j + 1; k < 6; ++k) {
                share[j] = STEWART_FMA(-share[k], by->row[6*k + j], share[j]);
            }
            by->share[6*by->order[i] + j] = share[j];
        }
    }
}

/* M in the coordinates. */
static void weigh_rows(rows *by)
{
    int b, i, j, k, n;
    for (k = 0; k < 6; ++k) {
        for (n = 0; n < 6; ++n) {
            by->inertia[6*k + n] = REAL(0);
        }
    }
    for (b = 0; b < 8; ++b) {
        for (i = 0; i < 3; ++i) {
            for (j = 0; j < 3; ++j) {
                for (k = 0; k < 6; ++k) {
                    const stewart_real part = by->share[6*(3*b + i) + k]*by->weight[3*(3*b + i) + j];
                    for (n = 0; n < 6; ++n) {
                        by->inertia[6*k + n] = STEWART_FMA(part, by->share[6*(3*b + j) + n], by->inertia[6*k
                            + n]);
                    }
                }
            }
        }
    }
}

/* Forces of the six coordinates' rows that add up to a wrench. */
static void by_rows(const rows *by, const stewart_real wrench[6], stewart_real held[6])
{
    int j, k;
    for (k = 0; k < 6; ++k) {
        held[k] = wrench[by->column[k]]/(by->column[k] < 3 ? REAL(1) : by->length);
    }
    for (k = 0; k < 6; ++k) {
        for (j = 0; j < k; ++j) {
            held[k] = STEWART_FMA(-by->row[6*j + k], held[j], held[k]);
        }
        held[k] = held[k]/by->row[6*k + k];
    }
    for (k = 5; k >= 0; --k) {
        for (j = k + 1; j < 6; ++j) {
            held[k] = STEWART_FMA(-by->row[6*j + k], held[j], held[k]);
        }
    }
}

/* Accelerations of the coordinates' rows under which the inertia of each block balances their forces.
 *
 * ``balanced``: 1 of these rows, without those that have no inertia of their own beside the rows before
 * them, else 0; ``moved`` is 0 of all others. */
static void balance_rows(
    const rows *by, const stewart_real force[24], stewart_real moved[24], stewart_real balanced[24])
{
    int b, i, j, k;
    stewart_real W[3][3];
    for (i = 0; i < 24; ++i) {
        moved[i] = force[i];
        balanced[i] = REAL(0);
    }
    for (k = 0; k < 6; ++k) {
        balanced[by->order[k]] = REAL(1);
    }
    for (b = 0; b < 8; ++b) {
        for (i = 0; i < 3; ++i) {
            for (j = 0; j < 3; ++j) {
                W[i][j] = by->weight[3*(3*b + i) + j];
            }
        }
        for (k = 0; k < 3; ++k) {
            const stewart_real own = W[k][k] > STEWART_KEPT ? balanced[3*b + k] : REAL(0);
            balanced[3*b + k] = own;
            if (own > REAL(0)) {
                for (i = k + 1; i < 3; ++i) {
                    const stewart_real factor = W[i][k]/W[k][k];
                    moved[3*b + i] = STEWART_FMA(-factor, moved[3*b + k], moved[3*b + i]);
                    for (j = k + 1; j < 3; ++j) {
                        W[i][j] = STEWART_FMA(-factor, W[k][j], W[i][j]);
                    }
                }
            }
        }
        for (k = 2; k >= 0; --k) {
            for (j = k + 1; j < 3; ++j) {
                moved[3*b + k] = STEWART_FMA(-W[k][j], moved[3*b + j], moved[3*b + k]);
            }
            moved[3*b + k] = balanced[3*b + k] > REAL(0) ? moved[3*b + k]/W[k][k] : REAL(0);
        }
    }
}

/* Right side of the equations for the accelerations of the six coordinates, with the wrench ``held``.
 *
 * force: of each row, as its generalized force over its size, without accelerations. start:
 * accelerations of the coordinates that balance their own large forces, from which the unknown ones are
 * measured; rest: the rows' forces there. */
static void row_right(
    const rows *by, const stewart_real force[24], const stewart_real held[6], stewart_real start[6],
    stewart_real rest[24], stewart_real right[6])
{
    int b, i, j, k;
    stewart_real moved[24];
    stewart_real balanced[24];
    balance_rows(by, force, moved, balanced);
    for (k = 0; k < 6; ++k) {
        start[k] = moved[by->order[k]];
    }
    for (i = 0; i < 24; ++i) {
        moved[i] = REAL(0);
        for (k = 0; k < 6; ++k) {
            moved[i] = STEWART_FMA(by->share[6*i + k], start[k], moved[i]);
        }
    }
    for (b = 0; b < 8; ++b) {
        for (i = 0; i < 3; ++i) {
            rest[3*b + i] = balanced[3*b + i] > REAL(0) ? REAL(0) : force[3*b + i];
            for (j = 0; j < 3; ++j) {
                const int own = balanced[3*b + i] > REAL(0) && balanced[3*b + j] > REAL(0);
                const stewart_real less = STEWART_FMA(-by->weight[3*(3*b + i) + j], moved[3*b + j], rest[3*b
                    + i]);
                rest[3*b + i] = own ? rest[3*b + i] : less;
            }
        }
    }
    for (k = 0; k < 6; ++k) {
        right[k] = held[k];
        for (i = 0; i < 24; ++i) {
            right[k] = STEWART_FMA(-by->share[6*i + k], rest[i], right[k]);
        }
    }
}

/* Substitutes back; ``inverse`` contains the reciprocals of the pivots. */
static void substitute_back_8(stewart_real A[48], const stewart_real inverse[6])
{
    int i, j, k;
    stewart_real row[LANES];
    for (k = 5; k >= 0; --k) {
        STEWART_LOOP for (j = 6; j < 8; ++j) {
            row[j] = A[8*k + j]*inverse[k];
            A[8*k + j] = row[j];
        }
        for (i = 0; i < k; ++i) {
            const stewart_real factor = A[8*i + k];
            STEWART_LOOP for (j = 6; j < 8; ++j) {
                A[8*i + j] = STEWART_FMA(-factor, row[j], A[8*i + j]);
            }
        }
    }
}

/* Subtracts multiples of row k from the rows below, so that their column k, which is not stored, is
 * zero.
 *
 * ``row`` is a copy, because compilers then know that it differs from the rows that change. */
static void clear_below_8(stewart_real A[48], int k, stewart_real inverse)
{
    int i, j;
    stewart_real row[LANES];
    STEWART_LOOP for (j = 0; j < 8; ++j) {
        row[j] = A[8*k + j];
    }
    for (i = k + 1; i < 6; ++i) {
        const stewart_real factor = A[8*i + k]*inverse;
        STEWART_LOOP for (j = 0; j < 8; ++j) {
            A[8*i + j] = STEWART_FMA(-factor, row[j], A[8*i + j]);
        }
    }
}

/* Solves the rows [M | Y] for X, which replaces Y, by L D L^T.
 *
 * Returns MASS_MATRIX_INDEFINITE if a pivot is at most ``kept`` times its diagonal entry. */
static int solve_definite_8(stewart_real A[48], stewart_real kept)
{
    int k;
    stewart_real scale[6];
    stewart_real inverse[6];
    int status = STEWART_OK;
    for (k = 0; k < 6; ++k) {
        scale[k] = A[8*k + k];
    }
    for (k = 0; k < 6; ++k) {
        int fault = STEWART_FABS(A[8*k + k]) <= STEWART_MAX ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_NOT_FINITE;
        fault = A[8*k + k] > kept*scale[k] ? STEWART_OK : fault;
        status = status == STEWART_OK ? fault : status;
        inverse[k] = REAL(1)/A[8*k + k];
        clear_below_8(A, k, inverse[k]);
    }
    substitute_back_8(A, inverse);
    return status;
}

/* [a; alpha] from the coordinates' accelerations. */
static void row_back(
    const rows *by, const stewart_real found[6], const stewart_real start[6], stewart_real acceleration[6])
{
    int j, k;
    stewart_real x[6];
    for (k = 0; k < 6; ++k) {
        x[k] = found[k] - start[k];
        for (j = 0; j < k; ++j) {
            x[k] = STEWART_FMA(-by->row[6*k + j], x[j], x[k]);
        }
    }
    for (k = 5; k >= 0; --k) {
        for (j = k + 1; j < 6; ++j) {
            x[k] = STEWART_FMA(-by->row[6*k + j], x[j], x[k]);
        }
        x[k] = x[k]/by->row[6*k + k];
        acceleration[by->column[k]] = x[k]/(by->column[k] < 3 ? REAL(1) : by->length);
    }
}

/* Generalized forces of each leg, accelerations due to the platform, and a mark if a leg is thin.
 *
 * The inertia of a thin leg for a rotation by phi is nearly k3 times its inertia for a rotation by
 * theta. A value between the two would have the rounding errors of both. The rows of the coordinates
 * contain the part of the wrench that the other rows do not balance. For a heavy leg, this part may be
 * much smaller than inertia times acceleration. */
static void rows_held(
    const joint_rows_legs *legs, rows *by, const stewart_real found[6], const stewart_real start[6],
    const stewart_real rest[24], stewart_real held[6])
{
    int b, i, j, k;
    stewart_real whole[24] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    stewart_real force[24];
    for (i = 0; i < 24; ++i) {
        for (j = 0; j < 6; ++j) {
            whole[i] = STEWART_FMA(by->share[6*i + j], found[j], whole[i]);
        }
    }
    for (b = 0; b < 8; ++b) {
        for (i = 0; i < 3; ++i) {
            force[3*b + i] = rest[3*b + i];
            for (j = 0; j < 3; ++j) {
                force[3*b + i] = STEWART_FMA(by->weight[3*(3*b + i) + j], whole[3*b + j], force[3*b + i]);
            }
        }
    }
    for (k = 0; k < 6; ++k) {
        force[by->order[k]] = REAL(0);
    }
    for (k = 0; k < 6; ++k) {
        for (i = 0; i < 24; ++i) {
            held[k] = STEWART_FMA(-by->share[6*i + k], force[i], held[k]);
        }
    }
    for (k = 0; k < 6; ++k) {
        force[by->order[k]] = held[k];
    }
    for (b = 0; b < 6; ++b) {
        const stewart_real k3 = legs->checked.k3[b];
        const stewart_real thin = k3*by->extent[3*b + 1]/by->extent[3*b + 2];
        by->given[b].axial = (k3 < STEWART_LEANING && thin*thin > STEWART_HALF) ? REAL(0) : REAL(1);
        for (i = 0; i < 3; ++i) {
            stewart_real turned = REAL(0);
            for (j = 0; j < 6; ++j) {
                turned = STEWART_FMA(by->share[6*(3*b + i) + j], found[j] - start[j], turned);
            }
            by->given[b].net[i] = force[3*b + i]*by->extent[3*b + i];
            by->given[b].turned[i] = turned/by->extent[3*b + i];
        }
    }
}

/* Forward dynamics in the accelerations of the six stiffest rows; by: the rows, what legs are given. */
static apart_found forward_apart(
    const stewart_exact_model *model, const stewart_motion *motion, const stewart_real F[6], rows *by)
{
    int i, j;
    apart_found out;
    joint_rows_legs legs;
    stewart_real summed[27];
    stewart_real force[24] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    stewart_real wrench[6];
    stewart_real start[6];
    stewart_real rest[24];
    stewart_real held[6];
    stewart_real right[6];
    STEWART_ALIGNED stewart_real A[48] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    for (i = 0; i < 6; ++i) {
        legs.F[i] = F[i];
    }
    joint_rows_sums(model, motion, &legs, summed);
    make_rows(summed, &legs, by);
    pick_rows(by);
    weigh_rows(by);
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            force[3*i + j] = legs.tau[j][i]/by->extent[3*i + j];
        }
    }
    for (i = 0; i < 3; ++i) {
        wrench[i] = summed[21 + i];
        wrench[i + 3] = summed[24 + i];
    }
    by_rows(by, wrench, held);
    row_right(by, force, held, start, rest, right);
    for (i = 0; i < 6; ++i) {
        A[8*i + 6] = right[i];
        for (j = 0; j < 6; ++j) {
            A[8*i + j] = by->inertia[6*i + j];
        }
    }
    const int fault = solve_definite_8(A, STEWART_ROUNDING);
    for (i = 0; i < 6; ++i) {
        right[i] = A[8*i + 6];
    }
    row_back(by, right, start, out.x);
    rows_held(&legs, by, right, start, rest, held);
    out.status = legs.status == STEWART_OK ? fault : legs.status;
    for (i = 0; i < 6; ++i) {
        out.status = (out.status != STEWART_OK || STEWART_FABS(out.x[i]) <= STEWART_MAX) ? out.status : STEWART_NOT_FINITE;
    }
    return out;
}

/* Accelerations a and alpha of the platform under the actuator forces F, N; a and alpha are not read. */
static void find_forward_dynamics(
    const stewart_exact_model *model, const stewart_motion *motion, const stewart_real F[6],
    forward_dynamics_found *out)
{
    int i;
    forward_legs legs;
    stewart_real summed[27];
    for (i = 0; i < 6; ++i) {
        legs.F[i] = F[i];
    }
    forward_sums(model, motion, &legs, summed);
    accelerations_of(&legs, summed, out);
    if (out->status == STEWART_MASS_MATRIX_INDEFINITE) {
        rows by;
        const apart_found apart = forward_apart(model, motion, F, &by);
        const int lost = out->status == STEWART_MASS_MATRIX_INDEFINITE ? 1 : 0;
        for (i = 0; i < 3; ++i) {
            out->acceleration[i] = lost == 1 ? apart.x[i] : out->acceleration[i];
            out->acceleration[3 + i] = lost == 1 ? apart.x[i + 3] : out->acceleration[3 + i];
        }
        out->status = lost == 1 ? apart.status : out->status;
    }
    check_forward_dynamics(out);
}

int stewart_exact_forward_dynamics(
    const stewart_exact_model *model, const stewart_motion *motion, const stewart_real F[6],
    stewart_real acceleration[6])
{
    int i;
    forward_dynamics_found found;
    if (model == NULL || motion == NULL || F == NULL || acceleration == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    find_forward_dynamics(model, motion, F, &found);
    if (found.status == STEWART_OK) {
        for (i = 0; i < 6; ++i) {
            acceleration[i] = found.acceleration[i];
        }
    }
    return found.status;
}

typedef struct {
    int none; /* C has no structure without members */
} equations_pose;

typedef struct {
    stewart_real sum[69][LANES];
    stewart_real H_force[3][LANES];
    stewart_real H_moment[3][LANES];
    stewart_real H_dot_force[3][LANES];
    stewart_real H_dot_moment[3][LANES];
    leg_checks checked;
    int status;
} STEWART_ALIGNED equations_legs;

/* Computes the terms of the platform, for one pose or eight. */
static STEWART_INLINE void equations_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const motion_in_lanes *STEWART_RESTRICT at,
    int lanes, const equations_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT summed)
{
    int l;
    (void)out;
    const stewart_real M_P = model->M_P;
    const stewart_real h_P_x = model->h_P[0], h_P_y = model->h_P[1], h_P_z = model->h_P[2];
    const stewart_real J_P_xx = model->J_P[0], J_P_xy = model->J_P[1], J_P_xz = model->J_P[2], J_P_yy = model->J_P[3],
        J_P_yz = model->J_P[4], J_P_zz = model->J_P[5];
    const stewart_real C_P = model->C_P;
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < lanes; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        /* (30) first moment of the platform, base frame */
        const stewart_real h_base_x = STEWART_FMA(R_xz, h_P_z, STEWART_FMA(R_xy, h_P_y, R_xx*h_P_x));
        const stewart_real h_base_y = STEWART_FMA(R_yz, h_P_z, STEWART_FMA(R_yy, h_P_y, R_yx*h_P_x));
        const stewart_real h_base_z = STEWART_FMA(R_zz, h_P_z, STEWART_FMA(R_zy, h_P_y, R_zx*h_P_x));
        const stewart_real c1 = STEWART_FMA(J_P_xz, R_xz, STEWART_FMA(J_P_xy, R_xy, J_P_xx*R_xx));
        const stewart_real c2 = STEWART_FMA(J_P_yz, R_xz, STEWART_FMA(J_P_yy, R_xy, J_P_xy*R_xx));
        const stewart_real c3 = STEWART_FMA(J_P_zz, R_xz, STEWART_FMA(J_P_yz, R_xy, J_P_xz*R_xx));
        const stewart_real c4 = STEWART_FMA(J_P_xz, R_yz, STEWART_FMA(J_P_xy, R_yy, J_P_xx*R_yx));
        const stewart_real c5 = STEWART_FMA(J_P_yz, R_yz, STEWART_FMA(J_P_yy, R_yy, J_P_xy*R_yx));
        const stewart_real c6 = STEWART_FMA(J_P_zz, R_yz, STEWART_FMA(J_P_yz, R_yy, J_P_xz*R_yx));
        /* (32) inertia of the platform, base frame */
        const stewart_real J_base_xx = STEWART_FMA(R_xz, c3, STEWART_FMA(R_xy, c2, R_xx*c1));
        const stewart_real J_base_xy = STEWART_FMA(R_yz, c3, STEWART_FMA(R_yy, c2, R_yx*c1));
        const stewart_real J_base_xz = STEWART_FMA(R_zz, c3, STEWART_FMA(R_zy, c2, R_zx*c1));
        const stewart_real J_base_yy = STEWART_FMA(R_yz, c6, STEWART_FMA(R_yy, c5, R_yx*c4));
        const stewart_real J_base_yz = STEWART_FMA(R_zz, c6, STEWART_FMA(R_zy, c5, R_zx*c4));
        const stewart_real J_base_zz = STEWART_FMA(R_zz, STEWART_FMA(J_P_zz, R_zz, STEWART_FMA(J_P_yz, R_zy,
            J_P_xz*R_zx)), STEWART_FMA(R_zy, STEWART_FMA(J_P_yz, R_zz, STEWART_FMA(J_P_yy, R_zy,
            J_P_xy*R_zx)), R_zx*STEWART_FMA(J_P_xz, R_zz, STEWART_FMA(J_P_xy, R_zy, J_P_xx*R_zx))));
        /* (31) omega x h */
        const stewart_real w_h_x = STEWART_FMA(-h_base_y, omega_z, h_base_z*omega_y);
        const stewart_real w_h_y = STEWART_FMA(-h_base_z, omega_x, h_base_x*omega_z);
        const stewart_real w_h_z = STEWART_FMA(-h_base_x, omega_y, h_base_y*omega_x);
        const stewart_real half_trace = STEWART_FMA(STEWART_HALF, J_base_zz, STEWART_FMA(STEWART_HALF,
            J_base_yy, STEWART_HALF*J_base_xx));
        const stewart_real c7 = J_base_xy*omega_z;
        const stewart_real c8 = J_base_xz*omega_y;
        const stewart_real c9 = half_trace*omega_z;
        const stewart_real c10 = half_trace*omega_y;
        const stewart_real c11 = -J_base_yz*omega_x;
        const stewart_real c12 = half_trace*omega_x;
        summed[0*lanes + l] = M_P;
        summed[1*lanes + l] = REAL(0);
        summed[2*lanes + l] = REAL(0);
        summed[3*lanes + l] = M_P;
        summed[4*lanes + l] = REAL(0);
        summed[5*lanes + l] = M_P;
        summed[6*lanes + l] = REAL(0);
        summed[7*lanes + l] = h_base_z;
        summed[8*lanes + l] = -h_base_y;
        summed[9*lanes + l] = -h_base_z;
        summed[10*lanes + l] = REAL(0);
        summed[11*lanes + l] = h_base_x;
        summed[12*lanes + l] = h_base_y;
        summed[13*lanes + l] = -h_base_x;
        summed[14*lanes + l] = REAL(0);
        summed[15*lanes + l] = J_base_xx;
        summed[16*lanes + l] = J_base_xy;
        summed[17*lanes + l] = J_base_xz;
        summed[18*lanes + l] = J_base_yy;
        summed[19*lanes + l] = J_base_yz;
        summed[20*lanes + l] = J_base_zz;
        summed[21*lanes + l] = REAL(0);
        summed[22*lanes + l] = REAL(0);
        summed[23*lanes + l] = REAL(0);
        summed[24*lanes + l] = REAL(0);
        summed[25*lanes + l] = w_h_z;
        summed[26*lanes + l] = -w_h_y;
        summed[27*lanes + l] = REAL(0);
        summed[28*lanes + l] = REAL(0);
        summed[29*lanes + l] = REAL(0);
        summed[30*lanes + l] = -w_h_z;
        summed[31*lanes + l] = REAL(0);
        summed[32*lanes + l] = w_h_x;
        summed[33*lanes + l] = REAL(0);
        summed[34*lanes + l] = REAL(0);
        summed[35*lanes + l] = REAL(0);
        summed[36*lanes + l] = w_h_y;
        summed[37*lanes + l] = -w_h_x;
        summed[38*lanes + l] = REAL(0);
        summed[39*lanes + l] = REAL(0);
        summed[40*lanes + l] = REAL(0);
        summed[41*lanes + l] = REAL(0);
        summed[42*lanes + l] = c8 - c7;
        summed[43*lanes + l] = STEWART_FMA(-J_base_yy, omega_z, STEWART_FMA(J_base_yz, omega_y, c9));
        summed[44*lanes + l] = STEWART_FMA(-J_base_yz, omega_z, STEWART_FMA(J_base_zz, omega_y, -c10));
        summed[45*lanes + l] = REAL(0);
        summed[46*lanes + l] = REAL(0);
        summed[47*lanes + l] = REAL(0);
        summed[48*lanes + l] = STEWART_FMA(-J_base_xz, omega_x, STEWART_FMA(J_base_xx, omega_z, -c9));
        summed[49*lanes + l] = c11 + c7;
        summed[50*lanes + l] = STEWART_FMA(-J_base_zz, omega_x, STEWART_FMA(J_base_xz, omega_z, c12));
        summed[51*lanes + l] = REAL(0);
        summed[52*lanes + l] = REAL(0);
        summed[53*lanes + l] = REAL(0);
        summed[54*lanes + l] = STEWART_FMA(-J_base_xx, omega_y, STEWART_FMA(J_base_xy, omega_x, c10));
        summed[55*lanes + l] = STEWART_FMA(-J_base_xy, omega_y, STEWART_FMA(J_base_yy, omega_x, -c12));
        summed[56*lanes + l] = -c11 - c8;
        summed[57*lanes + l] = -M_P*g_x;
        summed[58*lanes + l] = -M_P*g_y;
        summed[59*lanes + l] = -M_P*g_z;
        summed[60*lanes + l] = STEWART_FMA(g_z, -h_base_y, g_y*h_base_z);
        summed[61*lanes + l] = STEWART_FMA(g_x, -h_base_z, g_z*h_base_x);
        summed[62*lanes + l] = STEWART_FMA(g_y, -h_base_x, g_x*h_base_y);
        summed[63*lanes + l] = REAL(0);
        summed[64*lanes + l] = REAL(0);
        summed[65*lanes + l] = REAL(0);
        summed[66*lanes + l] = C_P*omega_x;
        summed[67*lanes + l] = C_P*omega_y;
        summed[68*lanes + l] = C_P*omega_z;
    }
}

/* Computes the legs of a pose in lanes. */
STEWART_APART static void equations_of_leg(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT motion,
    const equations_pose *STEWART_RESTRICT pose, equations_legs *STEWART_RESTRICT out)
{
    int l;
    (void)pose;
    const stewart_real R_xx = motion->R[0], R_xy = motion->R[1], R_xz = motion->R[2], R_yx = motion->R[3],
        R_yy = motion->R[4], R_yz = motion->R[5], R_zx = motion->R[6], R_zy = motion->R[7], R_zz = motion->R[8];
    const stewart_real t_x = motion->t[0], t_y = motion->t[1], t_z = motion->t[2];
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_xz = model->J[2][l], J_yy = model->J[3][l],
            J_yz = model->J[4][l], J_zz = model->J[5][l];
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
        /* (10) distance of the tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y,
            k_cross_S_y, k_cross_S_x*k_cross_S_x)));
        const stewart_real inv_rho = REAL(1)/rho;
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_S_y, s_z, k_cross_S_z*s_y);
        const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_S_z, s_x, k_cross_S_x*s_z);
        const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_S_x, s_y, k_cross_S_y*s_x);
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
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(omega_z, -q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(omega_x, -q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(omega_y, -q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = inv_rho*STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y,
            S_dot_x*y_x));
        const stewart_real theta_dot = -inv_L*STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y,
            S_dot_x*z_x));
        const stewart_real c1 = k3*k3;
        const stewart_real k33 = c1;
        const stewart_real k13 = k1*k3;
        const stewart_real L_h2 = L*h2_x;
        const stewart_real a1 = dJ_zx + L_h2;
        const stewart_real a2 = STEWART_FMA(-L, h2_z, J2_xz);
        const stewart_real c2 = STEWART_FMA(-L, h_y, J_xy);
        const stewart_real a3 = c2;
        /* (19) inertia of the joint coordinates */
        const stewart_real M_phi = STEWART_FMA(a2, k13, STEWART_FMA(a1, k33, J_xx));
        const stewart_real M_theta = J_yy + L_h2;
        const stewart_real M_mixed = STEWART_FMA(a3, k1, J_yz*k3);
        const stewart_real k3_h = h_y*k3;
        const stewart_real c3 = inv_L*inv_rho;
        const stewart_real c4 = inv_L*inv_L;
        /* inertia at the tip, leg frame */
        const stewart_real m_leg_sy = -inv_rho*k3_h;
        const stewart_real m_leg_sz = -h_z*inv_L;
        const stewart_real m_leg_yy = M_phi*inv_rho*inv_rho;
        const stewart_real m_leg_yz = -M_mixed*c3;
        const stewart_real m_leg_zz = M_theta*c4;
        const stewart_real m_T_xs = STEWART_FMA(m_leg_sy, y_x, m_leg_sz*z_x);
        const stewart_real m_T_xy = STEWART_FMA(m_leg_yy, y_x, STEWART_FMA(m_leg_yz, z_x, m_leg_sy*s_x));
        const stewart_real m_T_xz = STEWART_FMA(m_leg_yz, y_x, STEWART_FMA(m_leg_zz, z_x, m_leg_sz*s_x));
        const stewart_real m_T_ys = STEWART_FMA(m_leg_sy, y_y, m_leg_sz*z_y);
        const stewart_real m_T_yy = STEWART_FMA(m_leg_yy, y_y, STEWART_FMA(m_leg_yz, z_y, m_leg_sy*s_y));
        const stewart_real m_T_yz = STEWART_FMA(m_leg_yz, y_y, STEWART_FMA(m_leg_zz, z_y, m_leg_sz*s_y));
        const stewart_real m_T_zs = STEWART_FMA(m_leg_sy, y_z, m_leg_sz*z_z);
        const stewart_real m_T_zy = STEWART_FMA(m_leg_yy, y_z, STEWART_FMA(m_leg_yz, z_z, m_leg_sy*s_z));
        const stewart_real m_T_zz = STEWART_FMA(m_leg_yz, y_z, STEWART_FMA(m_leg_zz, z_z, m_leg_sz*s_z));
        /* inertia at the tip, base frame */
        const stewart_real m_xx = STEWART_FMA(m_T_xz, z_x, STEWART_FMA(m_T_xy, y_x, m_T_xs*s_x));
        const stewart_real m_xy = STEWART_FMA(m_T_xz, z_y, STEWART_FMA(m_T_xy, y_y, m_T_xs*s_y));
        const stewart_real m_xz = STEWART_FMA(m_T_xz, z_z, STEWART_FMA(m_T_xy, y_z, m_T_xs*s_z));
        const stewart_real m_yy = STEWART_FMA(m_T_yz, z_y, STEWART_FMA(m_T_yy, y_y, m_T_ys*s_y));
        const stewart_real m_yz = STEWART_FMA(m_T_yz, z_z, STEWART_FMA(m_T_yy, y_z, m_T_ys*s_z));
        const stewart_real m_zz = STEWART_FMA(m_T_zz, z_z, STEWART_FMA(m_T_zy, y_z, m_T_zs*s_z));
        const stewart_real c5 = h_x*theta_dot;
        const stewart_real C_xi_12 = -c5;
        const stewart_real c6 = STEWART_FMA(h_z*k1, -k3, c1*h_x);
        const stewart_real C_xi_13 = -c6*phi_dot;
        const stewart_real C_xi_21 = c5;
        const stewart_real C_xi_22 = L_dot*h_x;
        const stewart_real c7 = REAL(2)*L;
        const stewart_real c8 = STEWART_FMA(-c7, h_z, REAL(2)*J_xz);
        const stewart_real c9 = STEWART_FMA(STEWART_HALF*c1, -c8, STEWART_HALF*k1*STEWART_FMA(c8, k1,
            REAL(2)*k3*STEWART_FMA(c7, h_x, J_zz - J_xx)));
        const stewart_real C_xi_23 = -c9*phi_dot;
        const stewart_real c10 = h_y*k1;
        const stewart_real C_xi_31 = STEWART_FMA(-c10, theta_dot, c6*phi_dot);
        const stewart_real C_xi_32 = STEWART_FMA(c9, phi_dot, STEWART_FMA(-L_dot, c10,
            theta_dot*STEWART_FMA(-c2, k3, J_yz*k1)));
        const stewart_real C_xi_33 = STEWART_FMA(c9, theta_dot, L_dot*c6);
        const stewart_real c11 = k3*phi_dot;
        const stewart_real G_dot_12 = c11;
        const stewart_real G_dot_21 = -inv_L*theta_dot;
        const stewart_real c12 = k1*phi_dot;
        const stewart_real G_dot_22 = c12*inv_L;
        const stewart_real G_dot_23 = L_dot*c4;
        const stewart_real G_dot_31 = -c11*inv_rho;
        const stewart_real G_dot_32 = STEWART_FMA(inv_rho*kappa, -theta_dot, -L_dot*c3);
        const stewart_real G_dot_33 = c12*inv_rho;
        const stewart_real C_leg_11 = STEWART_FMA(-G_dot_31, k3_h, G_dot_21*h_z);
        const stewart_real C_leg_12 = STEWART_FMA(-G_dot_32, k3_h, STEWART_FMA(G_dot_22, h_z,
            C_xi_13*inv_rho));
        const stewart_real C_leg_13 = STEWART_FMA(-G_dot_33, k3_h, STEWART_FMA(-C_xi_12, inv_L,
            G_dot_23*h_z));
        const stewart_real C_leg_21 = inv_rho*STEWART_FMA(G_dot_31, M_phi, STEWART_FMA(G_dot_21, M_mixed,
            C_xi_31));
        const stewart_real C_leg_22 = inv_rho*STEWART_FMA(-G_dot_12, k3_h, STEWART_FMA(G_dot_32, M_phi,
            STEWART_FMA(G_dot_22, M_mixed, C_xi_33*inv_rho)));
        const stewart_real C_leg_23 = inv_rho*STEWART_FMA(-C_xi_32, inv_L, STEWART_FMA(G_dot_33, M_phi,
            STEWART_FMA(k3_h, theta_dot, G_dot_23*M_mixed)));
        const stewart_real C_leg_31 = -inv_L*STEWART_FMA(G_dot_31, M_mixed, STEWART_FMA(G_dot_21, M_theta,
            C_xi_21));
        const stewart_real C_leg_32 = -inv_L*STEWART_FMA(G_dot_32, M_mixed, STEWART_FMA(G_dot_22, M_theta,
            STEWART_FMA(C_xi_23, inv_rho, G_dot_12*h_z)));
        const stewart_real C_leg_33 = -inv_L*STEWART_FMA(G_dot_33, M_mixed, STEWART_FMA(-h_z, theta_dot,
            STEWART_FMA(-C_xi_22, inv_L, G_dot_23*M_theta)));
        const stewart_real C_tip_T_xs = STEWART_FMA(C_leg_31, z_x, STEWART_FMA(C_leg_21, y_x,
            C_leg_11*s_x));
        const stewart_real C_tip_T_xy = STEWART_FMA(C_leg_32, z_x, STEWART_FMA(C_leg_22, y_x,
            C_leg_12*s_x));
        const stewart_real C_tip_T_xz = STEWART_FMA(C_leg_33, z_x, STEWART_FMA(C_leg_23, y_x,
            C_leg_13*s_x));
        const stewart_real C_tip_T_ys = STEWART_FMA(C_leg_31, z_y, STEWART_FMA(C_leg_21, y_y,
            C_leg_11*s_y));
        const stewart_real C_tip_T_yy = STEWART_FMA(C_leg_32, z_y, STEWART_FMA(C_leg_22, y_y,
            C_leg_12*s_y));
        const stewart_real C_tip_T_yz = STEWART_FMA(C_leg_33, z_y, STEWART_FMA(C_leg_23, y_y,
            C_leg_13*s_y));
        const stewart_real C_tip_T_zs = STEWART_FMA(C_leg_31, z_z, STEWART_FMA(C_leg_21, y_z,
            C_leg_11*s_z));
        const stewart_real C_tip_T_zy = STEWART_FMA(C_leg_32, z_z, STEWART_FMA(C_leg_22, y_z,
            C_leg_12*s_z));
        const stewart_real C_tip_T_zz = STEWART_FMA(C_leg_33, z_z, STEWART_FMA(C_leg_23, y_z,
            C_leg_13*s_z));
        /* Coriolis matrix at the tip, base frame */
        const stewart_real C_tip_xx = STEWART_FMA(C_tip_T_xy, y_x, STEWART_FMA(C_tip_T_xs, s_x,
            C_tip_T_xz*z_x));
        const stewart_real C_tip_xy = STEWART_FMA(C_tip_T_xy, y_y, STEWART_FMA(C_tip_T_xs, s_y,
            C_tip_T_xz*z_y));
        const stewart_real C_tip_xz = STEWART_FMA(C_tip_T_xy, y_z, STEWART_FMA(C_tip_T_xs, s_z,
            C_tip_T_xz*z_z));
        const stewart_real C_tip_yx = STEWART_FMA(C_tip_T_yy, y_x, STEWART_FMA(C_tip_T_ys, s_x,
            C_tip_T_yz*z_x));
        const stewart_real C_tip_yy = STEWART_FMA(C_tip_T_yy, y_y, STEWART_FMA(C_tip_T_ys, s_y,
            C_tip_T_yz*z_y));
        const stewart_real C_tip_yz = STEWART_FMA(C_tip_T_yy, y_z, STEWART_FMA(C_tip_T_ys, s_z,
            C_tip_T_yz*z_z));
        const stewart_real C_tip_zx = STEWART_FMA(C_tip_T_zy, y_x, STEWART_FMA(C_tip_T_zs, s_x,
            C_tip_T_zz*z_x));
        const stewart_real C_tip_zy = STEWART_FMA(C_tip_T_zy, y_y, STEWART_FMA(C_tip_T_zs, s_y,
            C_tip_T_zz*z_y));
        const stewart_real C_tip_zz = STEWART_FMA(C_tip_T_zy, y_z, STEWART_FMA(C_tip_T_zs, s_z,
            C_tip_T_zz*z_z));
        const stewart_real c13 = C_tip_xy*q_z;
        const stewart_real c14 = m_xy*w_q_z;
        const stewart_real c15 = C_tip_xz*q_y;
        const stewart_real c16 = m_xz*w_q_y;
        const stewart_real C_q_xx = c16 - c14 + c15 - c13;
        const stewart_real c17 = C_tip_xx*q_z;
        const stewart_real C_q_xy = STEWART_FMA(-C_tip_xz, q_x, STEWART_FMA(-m_xz, w_q_x, m_xx*w_q_z) + c17);
        const stewart_real c18 = C_tip_xx*q_y;
        const stewart_real C_q_xz = STEWART_FMA(C_tip_xy, q_x, STEWART_FMA(-m_xx, w_q_y, m_xy*w_q_x)) - c18;
        const stewart_real c19 = C_tip_yy*q_z;
        const stewart_real C_q_yx = STEWART_FMA(C_tip_yz, q_y, STEWART_FMA(-m_yy, w_q_z, m_yz*w_q_y)) - c19;
        const stewart_real c20 = C_tip_yx*q_z;
        const stewart_real c21 = -C_tip_yz*q_x;
        const stewart_real c22 = -m_yz*w_q_x;
        const stewart_real C_q_yy = c14 + c22 + c20 + c21;
        const stewart_real c23 = -C_tip_yy*q_x;
        const stewart_real C_q_yz = STEWART_FMA(-C_tip_yx, q_y, STEWART_FMA(-m_xy, w_q_y, m_yy*w_q_x)) - c23;
        const stewart_real c24 = -C_tip_zz*q_y;
        const stewart_real C_q_zx = STEWART_FMA(-C_tip_zy, q_z, STEWART_FMA(-m_yz, w_q_z, m_zz*w_q_y)) - c24;
        const stewart_real c25 = -C_tip_zz*q_x;
        const stewart_real C_q_zy = STEWART_FMA(C_tip_zx, q_z, STEWART_FMA(-m_zz, w_q_x, m_xz*w_q_z)) + c25;
        const stewart_real c26 = C_tip_zx*q_y;
        const stewart_real c27 = -C_tip_zy*q_x;
        const stewart_real C_q_zz = -c16 - c22 - c26 - c27;
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
        const stewart_real c28 = inv_L*STEWART_FMA(gamma_n, w_k, g_k*w_n);
        const stewart_real c29 = STEWART_FMA(-gamma_y, w_n, -gamma_n*w_y);
        /* force at the tip that balances gravity */
        const stewart_real held_x = STEWART_FMA(-c28, z_x, c29*inv_rho*y_x);
        const stewart_real held_y = STEWART_FMA(-c28, z_y, c29*inv_rho*y_y);
        const stewart_real held_z = STEWART_FMA(-c28, z_z, c29*inv_rho*y_z);
        const stewart_real c30 = L_dot*s_x;
        const stewart_real c31 = inv_rho*STEWART_FMA(-C_s, STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y,
            omega_y, k_x*omega_x)), C_us*phi_dot);
        const stewart_real c32 = inv_L*STEWART_FMA(-C_s, STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y,
            omega_x*y_x)), C_us*theta_dot);
        const stewart_real c33 = L_dot*s_y;
        const stewart_real c34 = L_dot*s_z;
        /* force at the tip that balances friction */
        const stewart_real resistance_x = STEWART_FMA(-c32, z_x, STEWART_FMA(c31, y_x, C_p*c30));
        const stewart_real resistance_y = STEWART_FMA(-c32, z_y, STEWART_FMA(c31, y_y, C_p*c33));
        const stewart_real resistance_z = STEWART_FMA(-c32, z_z, STEWART_FMA(c31, y_z, C_p*c34));
        /* (3) derivative of s */
        const stewart_real s_dot_x = inv_L*(S_dot_x - c30);
        const stewart_real s_dot_y = inv_L*(S_dot_y - c33);
        const stewart_real s_dot_z = inv_L*(S_dot_z - c34);
        const stewart_real c35 = m_xy*q_z;
        const stewart_real c36 = m_xz*q_y;
        const stewart_real c37 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c35 - c36;
        const stewart_real m_q_xy = STEWART_FMA(-m_xx, q_z, m_xz*q_x);
        const stewart_real m_q_xz = STEWART_FMA(-m_xy, q_x, m_xx*q_y);
        const stewart_real m_q_yx = STEWART_FMA(-m_yz, q_y, m_yy*q_z);
        const stewart_real m_q_yy = -c35 - c37;
        const stewart_real m_q_yz = STEWART_FMA(-m_yy, q_x, m_xy*q_y);
        const stewart_real m_q_zx = STEWART_FMA(-m_zz, q_y, m_yz*q_z);
        const stewart_real m_q_zy = STEWART_FMA(-m_xz, q_z, m_zz*q_x);
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
        out->sum[15][l] = STEWART_FMA(-m_q_zx, q_y, m_q_yx*q_z);
        out->sum[16][l] = STEWART_FMA(-m_q_zy, q_y, m_q_yy*q_z);
        out->sum[17][l] = STEWART_FMA(-m_q_zz, q_y, m_q_yz*q_z);
        out->sum[18][l] = STEWART_FMA(-m_q_xy, q_z, m_q_zy*q_x);
        out->sum[19][l] = STEWART_FMA(-m_q_xz, q_z, m_q_zz*q_x);
        out->sum[20][l] = STEWART_FMA(-m_q_yz, q_x, m_q_xz*q_y);
        out->sum[21][l] = C_tip_xx;
        out->sum[22][l] = C_tip_xy;
        out->sum[23][l] = C_tip_xz;
        out->sum[24][l] = C_q_xx;
        out->sum[25][l] = C_q_xy;
        out->sum[26][l] = C_q_xz;
        out->sum[27][l] = C_tip_yx;
        out->sum[28][l] = C_tip_yy;
        out->sum[29][l] = C_tip_yz;
        out->sum[30][l] = C_q_yx;
        out->sum[31][l] = C_q_yy;
        out->sum[32][l] = C_q_yz;
        out->sum[33][l] = C_tip_zx;
        out->sum[34][l] = C_tip_zy;
        out->sum[35][l] = C_tip_zz;
        out->sum[36][l] = C_q_zx;
        out->sum[37][l] = C_q_zy;
        out->sum[38][l] = C_q_zz;
        out->sum[39][l] = c26 - c20;
        out->sum[40][l] = STEWART_FMA(C_tip_zy, q_y, -c19);
        out->sum[41][l] = STEWART_FMA(-C_tip_yz, q_z, -c24);
        out->sum[42][l] = STEWART_FMA(-C_q_yx, q_z, C_q_zx*q_y);
        out->sum[43][l] = STEWART_FMA(-C_q_yy, q_z, C_q_zy*q_y);
        out->sum[44][l] = STEWART_FMA(-C_q_yz, q_z, C_q_zz*q_y);
        out->sum[45][l] = STEWART_FMA(-C_tip_zx, q_x, c17);
        out->sum[46][l] = c13 + c27;
        out->sum[47][l] = STEWART_FMA(C_tip_xz, q_z, c25);
        out->sum[48][l] = STEWART_FMA(-C_q_zx, q_x, C_q_xx*q_z);
        out->sum[49][l] = STEWART_FMA(-C_q_zy, q_x, C_q_xy*q_z);
        out->sum[50][l] = STEWART_FMA(-C_q_zz, q_x, C_q_xz*q_z);
        out->sum[51][l] = STEWART_FMA(C_tip_yx, q_x, -c18);
        out->sum[52][l] = STEWART_FMA(-C_tip_xy, q_y, -c23);
        out->sum[53][l] = -c15 - c21;
        out->sum[54][l] = STEWART_FMA(-C_q_xx, q_y, C_q_yx*q_x);
        out->sum[55][l] = STEWART_FMA(-C_q_xy, q_y, C_q_yy*q_x);
        out->sum[56][l] = STEWART_FMA(-C_q_xz, q_y, C_q_yz*q_x);
        out->sum[57][l] = held_x;
        out->sum[58][l] = held_y;
        out->sum[59][l] = held_z;
        out->sum[60][l] = STEWART_FMA(-held_y, q_z, held_z*q_y);
        out->sum[61][l] = STEWART_FMA(-held_z, q_x, held_x*q_z);
        out->sum[62][l] = STEWART_FMA(-held_x, q_y, held_y*q_x);
        out->sum[63][l] = resistance_x;
        out->sum[64][l] = resistance_y;
        out->sum[65][l] = resistance_z;
        out->sum[66][l] = STEWART_FMA(-C_s, STEWART_FMA(theta_dot, y_x, k_x*phi_dot), STEWART_FMA(-q_z,
            resistance_y, q_y*resistance_z));
        out->sum[67][l] = STEWART_FMA(-C_s, STEWART_FMA(theta_dot, y_y, k_y*phi_dot), STEWART_FMA(-q_x,
            resistance_z, q_z*resistance_x));
        out->sum[68][l] = STEWART_FMA(-C_s, STEWART_FMA(theta_dot, y_z, k_z*phi_dot), STEWART_FMA(-q_y,
            resistance_x, q_x*resistance_y));
        out->H_force[0][l] = s_x;
        out->H_force[1][l] = s_y;
        out->H_force[2][l] = s_z;
        out->H_moment[0][l] = STEWART_FMA(-q_z, s_y, q_y*s_z);
        out->H_moment[1][l] = STEWART_FMA(-q_x, s_z, q_z*s_x);
        out->H_moment[2][l] = STEWART_FMA(-q_y, s_x, q_x*s_y);
        out->H_dot_force[0][l] = s_dot_x;
        out->H_dot_force[1][l] = s_dot_y;
        out->H_dot_force[2][l] = s_dot_z;
        out->H_dot_moment[0][l] = STEWART_FMA(-s_y, w_q_z, STEWART_FMA(-q_z, s_dot_y, STEWART_FMA(s_z,
            w_q_y, q_y*s_dot_z)));
        out->H_dot_moment[1][l] = STEWART_FMA(-s_z, w_q_x, STEWART_FMA(-q_x, s_dot_z, STEWART_FMA(s_x,
            w_q_z, q_z*s_dot_x)));
        out->H_dot_moment[2][l] = STEWART_FMA(-s_x, w_q_y, STEWART_FMA(-q_y, s_dot_x, STEWART_FMA(s_y,
            w_q_x, q_x*s_dot_y)));
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* Computes the legs of a pose in lanes. */
STEWART_APART static void equations_of_near(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT motion,
    const equations_pose *STEWART_RESTRICT pose, equations_legs *STEWART_RESTRICT out)
{
    int l;
    (void)pose;
    const stewart_real R_xx = motion->R[0], R_xy = motion->R[1], R_xz = motion->R[2], R_yx = motion->R[3],
        R_yy = motion->R[4], R_yz = motion->R[5], R_zx = motion->R[6], R_zy = motion->R[7], R_zz = motion->R[8];
    const stewart_real t_x = motion->t[0], t_y = motion->t[1], t_z = motion->t[2];
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_xz = model->J[2][l], J_yy = model->J[3][l],
            J_yz = model->J[4][l], J_zz = model->J[5][l];
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
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(omega_z, -q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(omega_x, -q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(omega_y, -q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
        const stewart_real c1 = STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y, S_dot_x*y_x));
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = c1*inv_rho;
        const stewart_real theta_dot = -inv_L*STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y,
            S_dot_x*z_x));
        const stewart_real k33 = k3*k3;
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
        const stewart_real c2 = h_z*inv_L;
        const stewart_real c3 = inv_L*inv_L;
        /* inertia at the tip, leg frame */
        const stewart_real m_leg_sy = -inv_rho*k3_h;
        const stewart_real m_leg_sz = -c2;
        const stewart_real m_leg_yy = M_phi*inv_rho*inv_rho;
        const stewart_real m_leg_yz = -M_mixed*inv_L*inv_rho;
        const stewart_real m_leg_zz = M_theta*c3;
        const stewart_real m_T_xs = STEWART_FMA(m_leg_sy, y_x, m_leg_sz*z_x);
        const stewart_real m_T_xy = STEWART_FMA(m_leg_yz, z_x, STEWART_FMA(m_leg_yy, y_x, m_leg_sy*s_x));
        const stewart_real m_T_xz = STEWART_FMA(m_leg_yz, y_x, STEWART_FMA(m_leg_zz, z_x, m_leg_sz*s_x));
        const stewart_real m_T_ys = STEWART_FMA(m_leg_sy, y_y, m_leg_sz*z_y);
        const stewart_real m_T_yy = STEWART_FMA(m_leg_yz, z_y, STEWART_FMA(m_leg_yy, y_y, m_leg_sy*s_y));
        const stewart_real m_T_yz = STEWART_FMA(m_leg_yz, y_y, STEWART_FMA(m_leg_zz, z_y, m_leg_sz*s_y));
        const stewart_real m_T_zs = STEWART_FMA(m_leg_sy, y_z, m_leg_sz*z_z);
        const stewart_real m_T_zy = STEWART_FMA(m_leg_yz, z_z, STEWART_FMA(m_leg_yy, y_z, m_leg_sy*s_z));
        const stewart_real m_T_zz = STEWART_FMA(m_leg_yz, y_z, STEWART_FMA(m_leg_zz, z_z, m_leg_sz*s_z));
        /* inertia at the tip, base frame */
        const stewart_real m_xx = STEWART_FMA(m_T_xy, y_x, STEWART_FMA(m_T_xz, z_x, m_T_xs*s_x));
        const stewart_real m_xy = STEWART_FMA(m_T_xy, y_y, STEWART_FMA(m_T_xz, z_y, m_T_xs*s_y));
        const stewart_real m_xz = STEWART_FMA(m_T_xy, y_z, STEWART_FMA(m_T_xz, z_z, m_T_xs*s_z));
        const stewart_real m_yy = STEWART_FMA(m_T_yy, y_y, STEWART_FMA(m_T_yz, z_y, m_T_ys*s_y));
        const stewart_real m_yz = STEWART_FMA(m_T_yy, y_z, STEWART_FMA(m_T_yz, z_z, m_T_ys*s_z));
        const stewart_real m_zz = STEWART_FMA(m_T_zy, y_z, STEWART_FMA(m_T_zz, z_z, m_T_zs*s_z));
        const stewart_real inv_k3 = L*inv_rho;
        /* (6) angular velocity of the leg about z */
        const stewart_real W_z = c1*inv_L;
        const stewart_real c4 = W_z*inv_L;
        const stewart_real c5 = c4*h_y;
        const stewart_real c6 = STEWART_FMA(-c2, theta_dot, c5);
        const stewart_real C_leg_11 = c6;
        const stewart_real c7 = c4*h_x;
        const stewart_real c8 = L_dot*c3;
        const stewart_real c9 = c8*h_y;
        const stewart_real c10 = inv_L*theta_dot;
        const stewart_real c11 = c10*h_y;
        const stewart_real c12 = inv_k3*k1;
        const stewart_real c13 = W_z*c2;
        const stewart_real C_leg_12 = STEWART_FMA(REAL(2)*c12, c13, STEWART_FMA(c11, c12, c9)) - c7;
        const stewart_real c14 = STEWART_FMA(-c12, c5, c10*h_x);
        const stewart_real C_leg_13 = STEWART_FMA(c8, h_z, c14);
        const stewart_real c15 = c3*theta_dot;
        const stewart_real c16 = J_yz*c15;
        const stewart_real c17 = J_xy*c15;
        const stewart_real c18 = W_z*c3;
        const stewart_real c19 = inv_k3*inv_k3;
        const stewart_real c20 = J_xx*c19;
        const stewart_real c21 = REAL(2)*J_xz;
        const stewart_real c22 = c18*c21;
        const stewart_real c23 = J_xx - J_zz;
        const stewart_real C_leg_21 = STEWART_FMA(-c12, c22, STEWART_FMA(W_z*h_z*inv_L*inv_k3, k1,
            STEWART_FMA(-c18, c20, STEWART_FMA(-c12, c17, STEWART_FMA(W_z*c23, c3, -c16))) - c7));
        const stewart_real c24 = J_xy*c18;
        const stewart_real c25 = c8*h_x;
        const stewart_real c26 = c19*c5;
        const stewart_real c27 = inv_L*inv_L*inv_L;
        const stewart_real c28 = L_dot*c27;
        const stewart_real c29 = J_xz*c19;
        const stewart_real c30 = c12*c28;
        const stewart_real c31 = J_yz*c18;
        const stewart_real c32 = c12*c31;
        const stewart_real c33 = c19*c24;
        const stewart_real c34 = J_xx*k1*inv_k3*inv_k3*inv_k3;
        const stewart_real C_leg_22 = STEWART_FMA(-c15, c34, STEWART_FMA(-c15, c29,
            STEWART_FMA(c19*h_z*inv_L, theta_dot, STEWART_FMA(-c21, c30, STEWART_FMA(L_dot*c3*h_z*inv_k3,
            k1, STEWART_FMA(-c20, c28, L_dot*c23*c27) - c25))))) + c32 + c33 - c24 - c26;
        const stewart_real c35 = c12*c16;
        const stewart_real c36 = STEWART_FMA(-c13, c19, STEWART_FMA(c18, c29, STEWART_FMA(J_xy, c30,
            J_yz*c28)));
        const stewart_real C_leg_23 = STEWART_FMA(c18, c34, c17) - c35 + c36;
        const stewart_real C_leg_31 = STEWART_FMA(c12, c24, STEWART_FMA(J_yy, c15, c31)) + c14;
        const stewart_real C_leg_32 = STEWART_FMA(c12*c18, -J_yy - c23, STEWART_FMA(-c11, c19,
            STEWART_FMA(c17, c19, STEWART_FMA(-c12, c9, c11) + c13) + c35 - c17)) - c22 + c36;
        const stewart_real C_leg_33 = STEWART_FMA(-J_yy, c28, c24) - c25 + c26 - c32 - c33 - c6;
        const stewart_real C_tip_T_xs = STEWART_FMA(C_leg_21, y_x, STEWART_FMA(C_leg_31, z_x,
            C_leg_11*s_x));
        const stewart_real C_tip_T_xy = STEWART_FMA(C_leg_32, z_x, STEWART_FMA(C_leg_22, y_x,
            C_leg_12*s_x));
        const stewart_real C_tip_T_xz = STEWART_FMA(C_leg_33, z_x, STEWART_FMA(C_leg_13, s_x,
            C_leg_23*y_x));
        const stewart_real C_tip_T_ys = STEWART_FMA(C_leg_21, y_y, STEWART_FMA(C_leg_31, z_y,
            C_leg_11*s_y));
        const stewart_real C_tip_T_yy = STEWART_FMA(C_leg_32, z_y, STEWART_FMA(C_leg_22, y_y,
            C_leg_12*s_y));
        const stewart_real C_tip_T_yz = STEWART_FMA(C_leg_33, z_y, STEWART_FMA(C_leg_13, s_y,
            C_leg_23*y_y));
        const stewart_real C_tip_T_zs = STEWART_FMA(C_leg_21, y_z, STEWART_FMA(C_leg_31, z_z,
            C_leg_11*s_z));
        const stewart_real C_tip_T_zy = STEWART_FMA(C_leg_32, z_z, STEWART_FMA(C_leg_22, y_z,
            C_leg_12*s_z));
        const stewart_real C_tip_T_zz = STEWART_FMA(C_leg_33, z_z, STEWART_FMA(C_leg_13, s_z,
            C_leg_23*y_z));
        /* Coriolis matrix at the tip, base frame */
        const stewart_real C_tip_xx = STEWART_FMA(C_tip_T_xy, y_x, STEWART_FMA(C_tip_T_xs, s_x,
            C_tip_T_xz*z_x));
        const stewart_real C_tip_xy = STEWART_FMA(C_tip_T_xy, y_y, STEWART_FMA(C_tip_T_xs, s_y,
            C_tip_T_xz*z_y));
        const stewart_real C_tip_xz = STEWART_FMA(C_tip_T_xy, y_z, STEWART_FMA(C_tip_T_xs, s_z,
            C_tip_T_xz*z_z));
        const stewart_real C_tip_yx = STEWART_FMA(C_tip_T_yy, y_x, STEWART_FMA(C_tip_T_ys, s_x,
            C_tip_T_yz*z_x));
        const stewart_real C_tip_yy = STEWART_FMA(C_tip_T_yy, y_y, STEWART_FMA(C_tip_T_ys, s_y,
            C_tip_T_yz*z_y));
        const stewart_real C_tip_yz = STEWART_FMA(C_tip_T_yy, y_z, STEWART_FMA(C_tip_T_ys, s_z,
            C_tip_T_yz*z_z));
        const stewart_real C_tip_zx = STEWART_FMA(C_tip_T_zy, y_x, STEWART_FMA(C_tip_T_zs, s_x,
            C_tip_T_zz*z_x));
        const stewart_real C_tip_zy = STEWART_FMA(C_tip_T_zy, y_y, STEWART_FMA(C_tip_T_zs, s_y,
            C_tip_T_zz*z_y));
        const stewart_real C_tip_zz = STEWART_FMA(C_tip_T_zy, y_z, STEWART_FMA(C_tip_T_zs, s_z,
            C_tip_T_zz*z_z));
        const stewart_real c37 = C_tip_xy*q_z;
        const stewart_real c38 = m_xy*w_q_z;
        const stewart_real c39 = C_tip_xz*q_y;
        const stewart_real c40 = m_xz*w_q_y;
        const stewart_real C_q_xx = c40 - c38 + c39 - c37;
        const stewart_real c41 = C_tip_xx*q_z;
        const stewart_real C_q_xy = STEWART_FMA(-C_tip_xz, q_x, STEWART_FMA(-m_xz, w_q_x, m_xx*w_q_z) + c41);
        const stewart_real c42 = C_tip_xx*q_y;
        const stewart_real C_q_xz = STEWART_FMA(C_tip_xy, q_x, STEWART_FMA(-m_xx, w_q_y, m_xy*w_q_x)) - c42;
        const stewart_real c43 = C_tip_yy*q_z;
        const stewart_real C_q_yx = STEWART_FMA(C_tip_yz, q_y, STEWART_FMA(-m_yy, w_q_z, m_yz*w_q_y)) - c43;
        const stewart_real c44 = C_tip_yx*q_z;
        const stewart_real c45 = -C_tip_yz*q_x;
        const stewart_real c46 = -m_yz*w_q_x;
        const stewart_real C_q_yy = c38 + c46 + c44 + c45;
        const stewart_real c47 = -C_tip_yy*q_x;
        const stewart_real C_q_yz = STEWART_FMA(-C_tip_yx, q_y, STEWART_FMA(-m_xy, w_q_y, m_yy*w_q_x)) - c47;
        const stewart_real c48 = -C_tip_zz*q_y;
        const stewart_real C_q_zx = STEWART_FMA(-C_tip_zy, q_z, STEWART_FMA(-m_yz, w_q_z, m_zz*w_q_y)) - c48;
        const stewart_real c49 = -C_tip_zz*q_x;
        const stewart_real C_q_zy = STEWART_FMA(C_tip_zx, q_z, STEWART_FMA(-m_zz, w_q_x, m_xz*w_q_z)) + c49;
        const stewart_real c50 = C_tip_zx*q_y;
        const stewart_real c51 = -C_tip_zy*q_x;
        const stewart_real C_q_zz = -c40 - c46 - c50 - c51;
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
        const stewart_real c52 = inv_L*STEWART_FMA(gamma_n, w_k, g_k*w_n);
        const stewart_real c53 = STEWART_FMA(-gamma_y, w_n, -gamma_n*w_y);
        /* force at the tip that balances gravity */
        const stewart_real held_x = STEWART_FMA(-c52, z_x, c53*inv_rho*y_x);
        const stewart_real held_y = STEWART_FMA(-c52, z_y, c53*inv_rho*y_y);
        const stewart_real held_z = STEWART_FMA(-c52, z_z, c53*inv_rho*y_z);
        const stewart_real c54 = L_dot*s_x;
        const stewart_real c55 = inv_rho*STEWART_FMA(-C_s, STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y,
            omega_y, k_x*omega_x)), C_us*phi_dot);
        const stewart_real c56 = inv_L*STEWART_FMA(-C_s, STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y,
            omega_x*y_x)), C_us*theta_dot);
        const stewart_real c57 = L_dot*s_y;
        const stewart_real c58 = L_dot*s_z;
        /* force at the tip that balances friction */
        const stewart_real resistance_x = STEWART_FMA(-c56, z_x, STEWART_FMA(c55, y_x, C_p*c54));
        const stewart_real resistance_y = STEWART_FMA(-c56, z_y, STEWART_FMA(c55, y_y, C_p*c57));
        const stewart_real resistance_z = STEWART_FMA(-c56, z_z, STEWART_FMA(c55, y_z, C_p*c58));
        /* (3) derivative of s */
        const stewart_real s_dot_x = inv_L*(S_dot_x - c54);
        const stewart_real s_dot_y = inv_L*(S_dot_y - c57);
        const stewart_real s_dot_z = inv_L*(S_dot_z - c58);
        const stewart_real c59 = m_xy*q_z;
        const stewart_real c60 = m_xz*q_y;
        const stewart_real c61 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c59 - c60;
        const stewart_real m_q_xy = STEWART_FMA(-m_xx, q_z, m_xz*q_x);
        const stewart_real m_q_xz = STEWART_FMA(-m_xy, q_x, m_xx*q_y);
        const stewart_real m_q_yx = STEWART_FMA(-m_yz, q_y, m_yy*q_z);
        const stewart_real m_q_yy = -c59 - c61;
        const stewart_real m_q_yz = STEWART_FMA(-m_yy, q_x, m_xy*q_y);
        const stewart_real m_q_zx = STEWART_FMA(-m_zz, q_y, m_yz*q_z);
        const stewart_real m_q_zy = STEWART_FMA(-m_xz, q_z, m_zz*q_x);
        const stewart_real m_q_zz = c60 + c61;
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
        out->sum[15][l] = STEWART_FMA(-m_q_zx, q_y, m_q_yx*q_z);
        out->sum[16][l] = STEWART_FMA(-m_q_zy, q_y, m_q_yy*q_z);
        out->sum[17][l] = STEWART_FMA(-m_q_zz, q_y, m_q_yz*q_z);
        out->sum[18][l] = STEWART_FMA(-m_q_xy, q_z, m_q_zy*q_x);
        out->sum[19][l] = STEWART_FMA(-m_q_xz, q_z, m_q_zz*q_x);
        out->sum[20][l] = STEWART_FMA(-m_q_yz, q_x, m_q_xz*q_y);
        out->sum[21][l] = C_tip_xx;
        out->sum[22][l] = C_tip_xy;
        out->sum[23][l] = C_tip_xz;
        out->sum[24][l] = C_q_xx;
        out->sum[25][l] = C_q_xy;
        out->sum[26][l] = C_q_xz;
        out->sum[27][l] = C_tip_yx;
        out->sum[28][l] = C_tip_yy;
        out->sum[29][l] = C_tip_yz;
        out->sum[30][l] = C_q_yx;
        out->sum[31][l] = C_q_yy;
        out->sum[32][l] = C_q_yz;
        out->sum[33][l] = C_tip_zx;
        out->sum[34][l] = C_tip_zy;
        out->sum[35][l] = C_tip_zz;
        out->sum[36][l] = C_q_zx;
        out->sum[37][l] = C_q_zy;
        out->sum[38][l] = C_q_zz;
        out->sum[39][l] = c50 - c44;
        out->sum[40][l] = STEWART_FMA(C_tip_zy, q_y, -c43);
        out->sum[41][l] = STEWART_FMA(-C_tip_yz, q_z, -c48);
        out->sum[42][l] = STEWART_FMA(-C_q_yx, q_z, C_q_zx*q_y);
        out->sum[43][l] = STEWART_FMA(-C_q_yy, q_z, C_q_zy*q_y);
        out->sum[44][l] = STEWART_FMA(-C_q_yz, q_z, C_q_zz*q_y);
        out->sum[45][l] = STEWART_FMA(-C_tip_zx, q_x, c41);
        out->sum[46][l] = c37 + c51;
        out->sum[47][l] = STEWART_FMA(C_tip_xz, q_z, c49);
        out->sum[48][l] = STEWART_FMA(-C_q_zx, q_x, C_q_xx*q_z);
        out->sum[49][l] = STEWART_FMA(-C_q_zy, q_x, C_q_xy*q_z);
        out->sum[50][l] = STEWART_FMA(-C_q_zz, q_x, C_q_xz*q_z);
        out->sum[51][l] = STEWART_FMA(C_tip_yx, q_x, -c42);
        out->sum[52][l] = STEWART_FMA(-C_tip_xy, q_y, -c47);
        out->sum[53][l] = -c39 - c45;
        out->sum[54][l] = STEWART_FMA(-C_q_xx, q_y, C_q_yx*q_x);
        out->sum[55][l] = STEWART_FMA(-C_q_xy, q_y, C_q_yy*q_x);
        out->sum[56][l] = STEWART_FMA(-C_q_xz, q_y, C_q_yz*q_x);
        out->sum[57][l] = held_x;
        out->sum[58][l] = held_y;
        out->sum[59][l] = held_z;
        out->sum[60][l] = STEWART_FMA(-held_y, q_z, held_z*q_y);
        out->sum[61][l] = STEWART_FMA(-held_z, q_x, held_x*q_z);
        out->sum[62][l] = STEWART_FMA(-held_x, q_y, held_y*q_x);
        out->sum[63][l] = resistance_x;
        out->sum[64][l] = resistance_y;
        out->sum[65][l] = resistance_z;
        out->sum[66][l] = STEWART_FMA(-C_s, STEWART_FMA(theta_dot, y_x, k_x*phi_dot), STEWART_FMA(-q_z,
            resistance_y, q_y*resistance_z));
        out->sum[67][l] = STEWART_FMA(-C_s, STEWART_FMA(theta_dot, y_y, k_y*phi_dot), STEWART_FMA(-q_x,
            resistance_z, q_z*resistance_x));
        out->sum[68][l] = STEWART_FMA(-C_s, STEWART_FMA(theta_dot, y_z, k_z*phi_dot), STEWART_FMA(-q_y,
            resistance_x, q_x*resistance_y));
        out->H_force[0][l] = s_x;
        out->H_force[1][l] = s_y;
        out->H_force[2][l] = s_z;
        out->H_moment[0][l] = STEWART_FMA(-q_z, s_y, q_y*s_z);
        out->H_moment[1][l] = STEWART_FMA(-q_x, s_z, q_z*s_x);
        out->H_moment[2][l] = STEWART_FMA(-q_y, s_x, q_x*s_y);
        out->H_dot_force[0][l] = s_dot_x;
        out->H_dot_force[1][l] = s_dot_y;
        out->H_dot_force[2][l] = s_dot_z;
        out->H_dot_moment[0][l] = STEWART_FMA(-s_y, w_q_z, STEWART_FMA(-q_z, s_dot_y, STEWART_FMA(s_z,
            w_q_y, q_y*s_dot_z)));
        out->H_dot_moment[1][l] = STEWART_FMA(-s_z, w_q_x, STEWART_FMA(-q_x, s_dot_z, STEWART_FMA(s_x,
            w_q_z, q_z*s_dot_x)));
        out->H_dot_moment[2][l] = STEWART_FMA(-s_x, w_q_y, STEWART_FMA(-q_y, s_dot_x, STEWART_FMA(s_y,
            w_q_x, q_x*s_dot_y)));
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* Computes the sums over platform and legs; ``status`` is the status of the legs. */
static void equations_sums(
    const stewart_exact_model *model, const stewart_motion *motion, equations_legs *legs,
    stewart_real summed[69])
{
    motion_in_lanes at;
    equations_pose pose = {0};
    at.R[0][0] = motion->R[0];
    at.R[1][0] = motion->R[1];
    at.R[2][0] = motion->R[2];
    at.R[3][0] = motion->R[3];
    at.R[4][0] = motion->R[4];
    at.R[5][0] = motion->R[5];
    at.R[6][0] = motion->R[6];
    at.R[7][0] = motion->R[7];
    at.R[8][0] = motion->R[8];
    at.omega[0][0] = motion->omega[0];
    at.omega[1][0] = motion->omega[1];
    at.omega[2][0] = motion->omega[2];
    equations_of_pose(model, &at, 1, &pose, summed);
    equations_of_leg(model, motion, &pose, legs);
    if (is_near(&legs->checked) != 0) {
        equations_of_near(model, motion, &pose, legs);
    }
    legs->status = legs_status(&legs->checked);
    if (legs->status == STEWART_OK) {
        add_legs(legs->sum, 69, summed);
    }
}

/* A symmetric 3 x 3 block from xx xy xz yy yz zz. */
static void place_symmetric_12(const stewart_real parts[6], int row, int column, stewart_real A[72])
{
    int i;
    for (i = 0; i < 3; ++i) {
        A[12*row + (column + i)] = parts[i];
        A[12*(row + i) + column] = parts[i];
    }
    A[12*(row + 1) + (column + 1)] = parts[3];
    A[12*(row + 1) + (column + 2)] = parts[4];
    A[12*(row + 2) + (column + 1)] = parts[4];
    A[12*(row + 2) + (column + 2)] = parts[5];
}

/* M into six columns from ``first`` on, from its parts, of which symmetric ones are xx xy xz yy yz zz. */
static void place_inertia_12(
    const stewart_real vv[6], const stewart_real vw[9], const stewart_real ww[6], int first,
    stewart_real A[72])
{
    int i, j;
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 3; ++j) {
            A[12*i + (first + j + 3)] = vw[3*i + j];
            A[12*(j + 3) + (first + i)] = vw[3*i + j];
        }
    }
    place_symmetric_12(vv, 0, first, A);
    place_symmetric_12(ww, 3, first + 3, A);
}

/* Multiplies the rows of moments by one over a length. */
static void scale_moments_12(stewart_real per_length, stewart_real A[72])
{
    int i, j;
    if (per_length != REAL(1)) {
        for (i = 3; i < 6; ++i) {
            for (j = 0; j < 12; ++j) {
                A[12*i + j] = A[12*i + j]*per_length;
            }
        }
    }
}

/* Substitutes back; ``inverse`` contains the reciprocals of the pivots. */
static void substitute_back_12(stewart_real A[72], const stewart_real inverse[6])
{
    int i, j, k;
    stewart_real row[12];
    for (k = 5; k >= 0; --k) {
        STEWART_LOOP for (j = 6; j < 12; ++j) {
            row[j] = A[12*k + j]*inverse[k];
            A[12*k + j] = row[j];
        }
        for (i = 0; i < k; ++i) {
            const stewart_real factor = A[12*i + k];
            STEWART_LOOP for (j = 6; j < 12; ++j) {
                A[12*i + j] = STEWART_FMA(-factor, row[j], A[12*i + j]);
            }
        }
    }
}

/* Subtracts multiples of row k from the rows below, so that their column k, which is not stored, is
 * zero.
 *
 * ``row`` is a copy, because compilers then know that it differs from the rows that change. */
static void clear_below_12(stewart_real A[72], int k, stewart_real inverse)
{
    int i, j;
    stewart_real row[12];
    STEWART_LOOP for (j = 0; j < 12; ++j) {
        row[j] = A[12*k + j];
    }
    for (i = k + 1; i < 6; ++i) {
        const stewart_real factor = A[12*i + k]*inverse;
        STEWART_LOOP for (j = 0; j < 12; ++j) {
            A[12*i + j] = STEWART_FMA(-factor, row[j], A[12*i + j]);
        }
    }
}

/* Solves the rows [H | Y] for X, which replaces Y, by elimination with partial pivoting. Returns 1 if a
 * pivot is small. */
static int solve_pivoted_12(stewart_real A[72])
{
    int i, j, k;
    stewart_real inverse[6];
    int suspect = 0;
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        stewart_real most = STEWART_FABS(A[12*k + k]);
        for (i = k + 1; i < 6; ++i) {
            const stewart_real entry = STEWART_FABS(A[12*i + k]);
            pivot = entry > most ? i : pivot;
            most = entry > most ? entry : most;
        }
        if (pivot != k) {
            STEWART_LOOP for (j = 0; j < 12; ++j) {
                const stewart_real moved = A[12*k + j];
                A[12*k + j] = A[12*pivot + j];
                A[12*pivot + j] = moved;
            }
        }
        suspect = STEWART_FABS(A[12*k + k]) > STEWART_SUSPECT ? suspect : 1;
        inverse[k] = REAL(1)/A[12*k + k];
        clear_below_12(A, k, inverse[k]);
    }
    substitute_back_12(A, inverse);
    return suspect;
}

/* Sets the status if a number of a result is not finite. */
static void check_joint_inertia(joint_inertia_found *out)
{
    int i;
    if (out->status != STEWART_OK) {
        return;
    }
    size_t lost = 0U;
    for (i = 0; i < 36; ++i) {
        lost = lost + (STEWART_FABS(out->inertia[i]) <= STEWART_MAX ? 0U : 1U);
    }
    out->status = lost == 0U ? STEWART_OK : STEWART_NOT_FINITE;
}

/* Returns the status of H: STEWART_SINGULAR if H is singular to rounding. */
static int columns_status(
    const stewart_exact_model *model, const stewart_motion *motion, const equations_legs *legs)
{
    int i, j;
    stewart_real H[6][6];
    stewart_real arm[6][3];
    stewart_real L[6];
    for (i = 0; i < 6; ++i) {
        L[i] = legs->checked.L[i];
        for (j = 0; j < 3; ++j) {
            H[j][i] = legs->H_force[j][i];
            H[j + 3][i] = legs->H_moment[j][i];
            const stewart_real plane = STEWART_FMA(motion->R[3*j + 1], model->p[1][i],
                motion->R[3*j]*model->p[0][i]);
            arm[i][j] = STEWART_FMA(motion->R[3*j + 2], model->p[2][i], plane);
        }
    }
    return singular_status(H, arm, L, legs->checked.reach, REAL(0));
}

/* Mass matrix for leg lengths as coordinates, H^-1 M H^-T. */
static void find_joint_inertia(
    const stewart_exact_model *model, const stewart_motion *motion, joint_inertia_found *out)
{
    int i, j;
    equations_legs legs;
    stewart_real summed[69];
    STEWART_ALIGNED stewart_real A[72];
    stewart_real half[6][6];
    equations_sums(model, motion, &legs, summed);
    int status = legs.status;
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 6; ++j) {
            A[12*i + j] = legs.H_force[i][j];
            A[12*(i + 3) + j] = legs.H_moment[i][j];
        }
    }
    place_inertia_12(&summed[0], &summed[6], &summed[15], 6, A);
    scale_moments_12(model->per_length, A);
    int close = solve_pivoted_12(A);
    for (i = 0; i < 6; ++i) {
        close = legs.checked.L[i] > STEWART_SHORT_SHARE*legs.checked.reach[i] ? close : 1;
        for (j = 0; j < 6; ++j) {
            half[i][j] = A[12*i + (j + 6)];
        }
    }
    if (status == STEWART_OK && close == 1) {
        const int found = columns_status(model, motion, &legs);
        status = found;
    }
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 6; ++j) {
            A[12*i + j] = legs.H_force[i][j];
            A[12*(i + 3) + j] = legs.H_moment[i][j];
            A[12*i + (j + 6)] = half[j][i];
            A[12*(i + 3) + (j + 6)] = half[j][i + 3];
        }
    }
    scale_moments_12(model->per_length, A);
    (void)solve_pivoted_12(A);
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            out->inertia[6*i + j] = (A[12*i + (j + 6)] + A[12*j + (i + 6)])*STEWART_HALF;
        }
    }
    out->status = status;
    check_joint_inertia(out);
}

int stewart_exact_joint_inertia(
    const stewart_exact_model *model, const stewart_motion *motion, stewart_real inertia[36])
{
    int i;
    joint_inertia_found found;
    if (model == NULL || motion == NULL || inertia == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    find_joint_inertia(model, motion, &found);
    if (found.status == STEWART_OK) {
        for (i = 0; i < 36; ++i) {
            inertia[i] = found.inertia[i];
        }
    }
    return found.status;
}

/* The motion with these accelerations. */
static stewart_motion with_acceleration(
    const stewart_motion *motion, const stewart_real a[3], const stewart_real alpha[3])
{
    int i;
    stewart_motion out;
    for (i = 0; i < 9; ++i) {
        out.R[i] = motion->R[i];
    }
    for (i = 0; i < 3; ++i) {
        out.t[i] = motion->t[i];
        out.omega[i] = motion->omega[i];
        out.v[i] = motion->v[i];
        out.alpha[i] = alpha[i];
        out.a[i] = a[i];
        out.F_ext[i] = motion->F_ext[i];
        out.M_ext[i] = motion->M_ext[i];
    }
    return out;
}

typedef struct {
    stewart_real B[9][LANES];
} STEWART_ALIGNED derivatives_pose;

typedef struct {
    stewart_real sum[93][LANES];
    stewart_real F[LANES];
    stewart_real H_force[3][LANES];
    stewart_real H_moment[3][LANES];
    leg_checks checked;
    int status;
} STEWART_ALIGNED derivatives_legs;

/* Computes the terms of the platform, for one pose or eight. */
static STEWART_INLINE void derivatives_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const motion_in_lanes *STEWART_RESTRICT at,
    int lanes, derivatives_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT summed)
{
    int l;
    const stewart_real M_P = model->M_P;
    const stewart_real h_P_x = model->h_P[0], h_P_y = model->h_P[1], h_P_z = model->h_P[2];
    const stewart_real J_P_xx = model->J_P[0], J_P_xy = model->J_P[1], J_P_xz = model->J_P[2], J_P_yy = model->J_P[3],
        J_P_yz = model->J_P[4], J_P_zz = model->J_P[5];
    const stewart_real C_P = model->C_P;
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < lanes; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        const stewart_real alpha_x = at->alpha[0][l], alpha_y = at->alpha[1][l], alpha_z = at->alpha[2][l];
        const stewart_real a_x = at->a[0][l], a_y = at->a[1][l], a_z = at->a[2][l];
        const stewart_real F_ext_x = at->F_ext[0][l], F_ext_y = at->F_ext[1][l], F_ext_z = at->F_ext[2][l];
        const stewart_real M_ext_x = at->M_ext[0][l], M_ext_y = at->M_ext[1][l], M_ext_z = at->M_ext[2][l];
        /* (30) first moment of the platform, base frame */
        const stewart_real h_base_x = STEWART_FMA(R_xz, h_P_z, STEWART_FMA(R_xy, h_P_y, R_xx*h_P_x));
        const stewart_real h_base_y = STEWART_FMA(R_yz, h_P_z, STEWART_FMA(R_yy, h_P_y, R_yx*h_P_x));
        const stewart_real h_base_z = STEWART_FMA(R_zz, h_P_z, STEWART_FMA(R_zy, h_P_y, R_zx*h_P_x));
        const stewart_real c1 = STEWART_FMA(J_P_xz, R_xz, STEWART_FMA(J_P_xy, R_xy, J_P_xx*R_xx));
        const stewart_real c2 = STEWART_FMA(J_P_yz, R_xz, STEWART_FMA(J_P_yy, R_xy, J_P_xy*R_xx));
        const stewart_real c3 = STEWART_FMA(J_P_zz, R_xz, STEWART_FMA(J_P_yz, R_xy, J_P_xz*R_xx));
        const stewart_real c4 = STEWART_FMA(J_P_xz, R_yz, STEWART_FMA(J_P_xy, R_yy, J_P_xx*R_yx));
        const stewart_real c5 = STEWART_FMA(J_P_yz, R_yz, STEWART_FMA(J_P_yy, R_yy, J_P_xy*R_yx));
        const stewart_real c6 = STEWART_FMA(J_P_zz, R_yz, STEWART_FMA(J_P_yz, R_yy, J_P_xz*R_yx));
        /* (32) inertia of the platform, base frame */
        const stewart_real J_base_xx = STEWART_FMA(R_xz, c3, STEWART_FMA(R_xy, c2, R_xx*c1));
        const stewart_real J_base_xy = STEWART_FMA(R_yz, c3, STEWART_FMA(R_yy, c2, R_yx*c1));
        const stewart_real J_base_xz = STEWART_FMA(R_zz, c3, STEWART_FMA(R_zy, c2, R_zx*c1));
        const stewart_real J_base_yy = STEWART_FMA(R_yz, c6, STEWART_FMA(R_yy, c5, R_yx*c4));
        const stewart_real J_base_yz = STEWART_FMA(R_zz, c6, STEWART_FMA(R_zy, c5, R_zx*c4));
        const stewart_real J_base_zz = STEWART_FMA(R_zz, STEWART_FMA(J_P_zz, R_zz, STEWART_FMA(J_P_yz, R_zy,
            J_P_xz*R_zx)), STEWART_FMA(R_zy, STEWART_FMA(J_P_yz, R_zz, STEWART_FMA(J_P_yy, R_zy,
            J_P_xy*R_zx)), R_zx*STEWART_FMA(J_P_xz, R_zz, STEWART_FMA(J_P_xy, R_zy, J_P_xx*R_zx))));
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
        const stewart_real J_w_x = STEWART_FMA(J_base_xx, omega_x, c13) + c14;
        const stewart_real J_w_y = STEWART_FMA(J_base_yy, omega_y, c15) + c16;
        const stewart_real J_w_z = STEWART_FMA(J_base_zz, omega_z, c17) + c18;
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
        const stewart_real J_alpha_x = STEWART_FMA(J_base_xx, alpha_x, c19) + c20;
        const stewart_real c21 = J_base_xy*alpha_x;
        const stewart_real c22 = J_base_yz*alpha_z;
        const stewart_real J_alpha_y = STEWART_FMA(J_base_yy, alpha_y, c21) + c22;
        const stewart_real c23 = J_base_xz*alpha_x;
        const stewart_real c24 = J_base_yz*alpha_y;
        const stewart_real J_alpha_z = STEWART_FMA(J_base_zz, alpha_z, c23) + c24;
        /* (33) a - g */
        const stewart_real rise_x = a_x - g_x;
        const stewart_real rise_y = a_y - g_y;
        const stewart_real rise_z = a_z - g_z;
        const stewart_real F_load_x = STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy, F_ext_x*R_xx));
        const stewart_real F_load_y = STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy, F_ext_x*R_yx));
        const stewart_real F_load_z = STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy, F_ext_x*R_zx));
        const stewart_real M_load_x = STEWART_FMA(M_ext_z, R_xz, STEWART_FMA(M_ext_y, R_xy, M_ext_x*R_xx));
        const stewart_real M_load_y = STEWART_FMA(M_ext_z, R_yz, STEWART_FMA(M_ext_y, R_yy, M_ext_x*R_yx));
        const stewart_real M_load_z = STEWART_FMA(M_ext_z, R_zz, STEWART_FMA(M_ext_y, R_zy, M_ext_x*R_zx));
        const stewart_real c25 = J_base_xy*omega_z;
        const stewart_real c26 = J_base_xz*omega_y;
        const stewart_real c28 = STEWART_FMA(-J_base_xx, omega_z, c17) + J_w_z;
        const stewart_real c29 = STEWART_FMA(-J_base_xx, omega_y, c15) + J_w_y;
        const stewart_real c30 = STEWART_FMA(-J_base_yy, omega_z, c18) + J_w_z;
        const stewart_real c31 = J_base_yz*omega_x;
        const stewart_real c33 = c25 - c31;
        const stewart_real c34 = STEWART_FMA(-J_base_yy, omega_x, c13) + J_w_x;
        const stewart_real c35 = STEWART_FMA(-J_base_zz, omega_y, c16) + J_w_y;
        const stewart_real c36 = STEWART_FMA(-J_base_zz, omega_x, c14) + J_w_x;
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
        out->B[0][l] = B_xx;
        out->B[1][l] = B_xy;
        out->B[2][l] = B_xz;
        out->B[3][l] = B_yx;
        out->B[4][l] = B_yy;
        out->B[5][l] = B_yz;
        out->B[6][l] = B_zx;
        out->B[7][l] = B_zy;
        out->B[8][l] = B_zz;
        summed[0*lanes + l] = M_P;
        summed[1*lanes + l] = REAL(0);
        summed[2*lanes + l] = REAL(0);
        summed[3*lanes + l] = M_P;
        summed[4*lanes + l] = REAL(0);
        summed[5*lanes + l] = M_P;
        summed[6*lanes + l] = REAL(0);
        summed[7*lanes + l] = h_base_z;
        summed[8*lanes + l] = -h_base_y;
        summed[9*lanes + l] = -h_base_z;
        summed[10*lanes + l] = REAL(0);
        summed[11*lanes + l] = h_base_x;
        summed[12*lanes + l] = h_base_y;
        summed[13*lanes + l] = -h_base_x;
        summed[14*lanes + l] = REAL(0);
        summed[15*lanes + l] = J_base_xx;
        summed[16*lanes + l] = J_base_xy;
        summed[17*lanes + l] = J_base_xz;
        summed[18*lanes + l] = J_base_yy;
        summed[19*lanes + l] = J_base_yz;
        summed[20*lanes + l] = J_base_zz;
        summed[21*lanes + l] = REAL(0);
        summed[22*lanes + l] = REAL(0);
        summed[23*lanes + l] = REAL(0);
        summed[24*lanes + l] = STEWART_FMA(-B_xy, h_base_z, B_xz*h_base_y);
        summed[25*lanes + l] = STEWART_FMA(-B_xz, h_base_x, STEWART_FMA(B_xx, h_base_z, -F_load_z));
        summed[26*lanes + l] = STEWART_FMA(-B_xx, h_base_y, STEWART_FMA(B_xy, h_base_x, F_load_y));
        summed[27*lanes + l] = REAL(0);
        summed[28*lanes + l] = REAL(0);
        summed[29*lanes + l] = REAL(0);
        summed[30*lanes + l] = STEWART_FMA(-B_yy, h_base_z, STEWART_FMA(B_yz, h_base_y, F_load_z));
        summed[31*lanes + l] = STEWART_FMA(-B_yz, h_base_x, B_yx*h_base_z);
        summed[32*lanes + l] = STEWART_FMA(-B_yx, h_base_y, STEWART_FMA(B_yy, h_base_x, -F_load_x));
        summed[33*lanes + l] = REAL(0);
        summed[34*lanes + l] = REAL(0);
        summed[35*lanes + l] = REAL(0);
        summed[36*lanes + l] = STEWART_FMA(-B_zy, h_base_z, STEWART_FMA(B_zz, h_base_y, -F_load_y));
        summed[37*lanes + l] = STEWART_FMA(-B_zz, h_base_x, STEWART_FMA(B_zx, h_base_z, F_load_x));
        summed[38*lanes + l] = STEWART_FMA(-B_zx, h_base_y, B_zy*h_base_x);
        summed[39*lanes + l] = REAL(0);
        summed[40*lanes + l] = REAL(0);
        summed[41*lanes + l] = REAL(0);
        summed[42*lanes + l] = STEWART_FMA(-omega_z, spin_yx, STEWART_FMA(omega_y, spin_zx, c40) - c37 - c38
            - c39);
        summed[43*lanes + l] = STEWART_FMA(-omega_z, spin_yy, STEWART_FMA(-J_base_xx, alpha_z,
            STEWART_FMA(omega_y, spin_zy, STEWART_FMA(h_base_x, rise_y, J_alpha_z + c23)) - M_load_z));
        summed[44*lanes + l] = STEWART_FMA(-omega_z, spin_yz, STEWART_FMA(omega_y, spin_zz,
            STEWART_FMA(h_base_x, rise_z, STEWART_FMA(J_base_xx, alpha_y, M_load_y))) - J_alpha_y - c21);
        summed[45*lanes + l] = REAL(0);
        summed[46*lanes + l] = REAL(0);
        summed[47*lanes + l] = REAL(0);
        summed[48*lanes + l] = STEWART_FMA(-omega_x, spin_zx, STEWART_FMA(omega_z, spin_xx,
            STEWART_FMA(h_base_y, rise_x, STEWART_FMA(J_base_yy, alpha_z, M_load_z))) - J_alpha_z - c24);
        summed[49*lanes + l] = STEWART_FMA(-omega_x, spin_zy, STEWART_FMA(omega_z, spin_xy, c42) - c39 - c40
            - c41);
        summed[50*lanes + l] = STEWART_FMA(-omega_x, spin_zz, STEWART_FMA(-J_base_yy, alpha_x,
            STEWART_FMA(omega_z, spin_xz, STEWART_FMA(h_base_y, rise_z, J_alpha_x + c19)) - M_load_x));
        summed[51*lanes + l] = REAL(0);
        summed[52*lanes + l] = REAL(0);
        summed[53*lanes + l] = REAL(0);
        summed[54*lanes + l] = STEWART_FMA(-omega_y, spin_xx, STEWART_FMA(-J_base_zz, alpha_y,
            STEWART_FMA(omega_x, spin_yx, STEWART_FMA(h_base_z, rise_x, J_alpha_y + c22)) - M_load_y));
        summed[55*lanes + l] = STEWART_FMA(-omega_y, spin_xy, STEWART_FMA(omega_x, spin_yy,
            STEWART_FMA(h_base_z, rise_y, STEWART_FMA(J_base_zz, alpha_x, M_load_x))) - J_alpha_x - c20);
        summed[56*lanes + l] = STEWART_FMA(-omega_y, spin_xz, STEWART_FMA(omega_x, spin_yz, c37) - c38 - c41
            - c42);
        summed[57*lanes + l] = REAL(0);
        summed[58*lanes + l] = REAL(0);
        summed[59*lanes + l] = REAL(0);
        summed[60*lanes + l] = c43 + c44;
        summed[61*lanes + l] = w_h_z - c11;
        summed[62*lanes + l] = -c9 - w_h_y;
        summed[63*lanes + l] = REAL(0);
        summed[64*lanes + l] = REAL(0);
        summed[65*lanes + l] = REAL(0);
        summed[66*lanes + l] = -c12 - w_h_z;
        summed[67*lanes + l] = c44 + c45;
        summed[68*lanes + l] = w_h_x - c7;
        summed[69*lanes + l] = REAL(0);
        summed[70*lanes + l] = REAL(0);
        summed[71*lanes + l] = REAL(0);
        summed[72*lanes + l] = w_h_y - c10;
        summed[73*lanes + l] = -c8 - w_h_x;
        summed[74*lanes + l] = c43 + c45;
        summed[75*lanes + l] = REAL(0);
        summed[76*lanes + l] = REAL(0);
        summed[77*lanes + l] = REAL(0);
        summed[78*lanes + l] = C_P + c26 - c25;
        summed[79*lanes + l] = c30;
        summed[80*lanes + l] = -c35;
        summed[81*lanes + l] = REAL(0);
        summed[82*lanes + l] = REAL(0);
        summed[83*lanes + l] = REAL(0);
        summed[84*lanes + l] = -c28;
        summed[85*lanes + l] = C_P + c33;
        summed[86*lanes + l] = c36;
        summed[87*lanes + l] = REAL(0);
        summed[88*lanes + l] = REAL(0);
        summed[89*lanes + l] = REAL(0);
        summed[90*lanes + l] = c29;
        summed[91*lanes + l] = -c34;
        summed[92*lanes + l] = C_P + c31 - c26;
    }
}

/* Computes the legs of a pose in lanes. */
STEWART_APART static void derivatives_of_leg(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT motion,
    const derivatives_pose *STEWART_RESTRICT pose, derivatives_legs *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = motion->R[0], R_xy = motion->R[1], R_xz = motion->R[2], R_yx = motion->R[3],
        R_yy = motion->R[4], R_yz = motion->R[5], R_zx = motion->R[6], R_zy = motion->R[7], R_zz = motion->R[8];
    const stewart_real t_x = motion->t[0], t_y = motion->t[1], t_z = motion->t[2];
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    const stewart_real a_x = motion->a[0], a_y = motion->a[1], a_z = motion->a[2];
    const stewart_real B_xx = pose->B[0][0], B_xy = pose->B[1][0], B_xz = pose->B[2][0], B_yx = pose->B[3][0],
        B_yy = pose->B[4][0], B_yz = pose->B[5][0], B_zx = pose->B[6][0], B_zy = pose->B[7][0], B_zz = pose->B[8][0];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_xz = model->J[2][l], J_yy = model->J[3][l],
            J_yz = model->J[4][l], J_zz = model->J[5][l];
        const stewart_real J2_xz = model->J2_xz[l];
        const stewart_real dJ_zx = model->dJ_zx[l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l], g_x_k_z = model->g_x_k[2][l];
        const stewart_real C_us = model->C_us[l];
        const stewart_real F = out->F[l];
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
        /* (10) distance of the tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y,
            k_cross_S_y, k_cross_S_x*k_cross_S_x)));
        const stewart_real inv_rho = REAL(1)/rho;
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_S_y, s_z, k_cross_S_z*s_y);
        const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_S_z, s_x, k_cross_S_x*s_z);
        const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_S_x, s_y, k_cross_S_y*s_x);
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
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(omega_z, -q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(omega_x, -q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(omega_y, -q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = inv_rho*STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y,
            S_dot_x*y_x));
        const stewart_real theta_dot = -inv_L*STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y,
            S_dot_x*z_x));
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
        const stewart_real S_ddot_x = STEWART_FMA(B_xz, q_z, STEWART_FMA(B_xy, q_y, STEWART_FMA(B_xx, q_x,
            a_x)));
        const stewart_real S_ddot_y = STEWART_FMA(B_yz, q_z, STEWART_FMA(B_yy, q_y, STEWART_FMA(B_yx, q_x,
            a_y)));
        const stewart_real S_ddot_z = STEWART_FMA(B_zz, q_z, STEWART_FMA(B_zy, q_y, STEWART_FMA(B_zx, q_x,
            a_z)));
        const stewart_real c6 = k3*k3;
        const stewart_real k33 = c6;
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y,
            STEWART_FMA(S_ddot_x, s_x, L*STEWART_FMA(k33, phi_dot2, theta_dot2))));
        const stewart_real c7 = REAL(2)*theta_dot;
        /* (9) accelerations of the joint coordinates without the rotation of the leg frame about s */
        const stewart_real own_theta_ddot = STEWART_FMA(-L_share, c7, -inv_L*STEWART_FMA(S_ddot_z, z_z,
            STEWART_FMA(S_ddot_y, z_y, S_ddot_x*z_x)));
        const stewart_real own_phi_ddot = STEWART_FMA(-L_share, two_phi_dot, inv_rho*STEWART_FMA(S_ddot_z,
            y_z, STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)));
        const stewart_real c8 = k1*k3;
        /* (9) accelerations of the joint coordinates */
        const stewart_real theta_ddot = STEWART_FMA(c8, phi_dot2, own_theta_ddot);
        const stewart_real phi_ddot = STEWART_FMA(-lean, two_phi_dot, own_phi_ddot);
        const stewart_real k13 = c8;
        const stewart_real L_h2 = L*h2_x;
        const stewart_real a1 = dJ_zx + L_h2;
        const stewart_real a2 = STEWART_FMA(-L, h2_z, J2_xz);
        const stewart_real c9 = STEWART_FMA(-L, h_y, J_xy);
        const stewart_real a3 = c9;
        const stewart_real c10 = J_yz*k3;
        /* (19) inertia of the joint coordinates */
        const stewart_real M_phi = STEWART_FMA(a2, k13, STEWART_FMA(a1, k33, J_xx));
        const stewart_real M_theta = J_yy + L_h2;
        const stewart_real M_mixed = STEWART_FMA(a3, k1, c10);
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
        const stewart_real m_T_xs = STEWART_FMA(m_leg_sy, y_x, m_leg_sz*z_x);
        const stewart_real m_T_xy = STEWART_FMA(m_leg_yy, y_x, STEWART_FMA(m_leg_yz, z_x, m_leg_sy*s_x));
        const stewart_real m_T_xz = STEWART_FMA(m_leg_yz, y_x, STEWART_FMA(m_leg_zz, z_x, m_leg_sz*s_x));
        const stewart_real m_T_ys = STEWART_FMA(m_leg_sy, y_y, m_leg_sz*z_y);
        const stewart_real m_T_yy = STEWART_FMA(m_leg_yy, y_y, STEWART_FMA(m_leg_yz, z_y, m_leg_sy*s_y));
        const stewart_real m_T_yz = STEWART_FMA(m_leg_yz, y_y, STEWART_FMA(m_leg_zz, z_y, m_leg_sz*s_y));
        const stewart_real m_T_zs = STEWART_FMA(m_leg_sy, y_z, m_leg_sz*z_z);
        const stewart_real m_T_zy = STEWART_FMA(m_leg_yy, y_z, STEWART_FMA(m_leg_yz, z_z, m_leg_sy*s_z));
        const stewart_real m_T_zz = STEWART_FMA(m_leg_yz, y_z, STEWART_FMA(m_leg_zz, z_z, m_leg_sz*s_z));
        /* inertia at the tip, base frame */
        const stewart_real m_xx = STEWART_FMA(m_T_xz, z_x, STEWART_FMA(m_T_xy, y_x, m_T_xs*s_x));
        const stewart_real m_xy = STEWART_FMA(m_T_xz, z_y, STEWART_FMA(m_T_xy, y_y, m_T_xs*s_y));
        const stewart_real m_xz = STEWART_FMA(m_T_xz, z_z, STEWART_FMA(m_T_xy, y_z, m_T_xs*s_z));
        const stewart_real m_yy = STEWART_FMA(m_T_yz, z_y, STEWART_FMA(m_T_yy, y_y, m_T_ys*s_y));
        const stewart_real m_yz = STEWART_FMA(m_T_yz, z_z, STEWART_FMA(m_T_yy, y_z, m_T_ys*s_z));
        const stewart_real m_zz = STEWART_FMA(m_T_zz, z_z, STEWART_FMA(m_T_zy, y_z, m_T_zs*s_z));
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* k x y */
        const stewart_real normal_x = STEWART_FMA(-k_z, y_y, k_y*y_z);
        const stewart_real normal_y = STEWART_FMA(-k_x, y_z, k_z*y_x);
        const stewart_real normal_z = STEWART_FMA(-k_y, y_x, k_x*y_y);
        /* omega along k x y, y and k */
        const stewart_real w_n_omega = STEWART_FMA(normal_z, omega_z, STEWART_FMA(normal_y, omega_y,
            normal_x*omega_x));
        const stewart_real w_y_omega = STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x));
        const stewart_real w_k_omega = STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y, k_x*omega_x));
        const stewart_real c15 = c6*h_x;
        const stewart_real c16 = STEWART_FMA(h_z*k1, -k3, c15);
        const stewart_real tau_L = STEWART_FMA(-c11, phi_ddot, STEWART_FMA(h_z, theta_ddot,
            STEWART_FMA(-c16, c4, STEWART_FMA(-c3, h_x, C_p*L_dot))));
        const stewart_real c18 = c7*h_x;
        const stewart_real c19 = REAL(2)*L;
        const stewart_real c20 = c19*h_x;
        const stewart_real c21 = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real c22 = STEWART_FMA(-k3, w_x, k1*w_z);
        const stewart_real c24 = STEWART_FMA(c9, k1, c10);
        const stewart_real c25 = STEWART_FMA(-c19, h_z, REAL(2)*J_xz);
        const stewart_real c26 = c25*k1;
        const stewart_real c27 = J_zz - J_xx + c20;
        const stewart_real c28 = c27*k3;
        const stewart_real c29 = STEWART_FMA(REAL(2), c28, c26);
        const stewart_real c30 = STEWART_HALF*k1;
        const stewart_real c31 = STEWART_FMA(STEWART_HALF*c25, -c6, c29*c30);
        const stewart_real tau_theta = STEWART_FMA(c24, phi_ddot, STEWART_FMA(theta_ddot, J_yy + c20,
            STEWART_FMA(-C_s, w_y_omega, STEWART_FMA(L_dot, c18, STEWART_FMA(c21, gamma_n, STEWART_FMA(C_us,
            theta_dot, STEWART_FMA(-c31, c4, STEWART_FMA(-c22, g_k, L_ddot*h_z))))))));
        const stewart_real c33 = h_y*theta_dot;
        const stewart_real c34 = c33*k1;
        const stewart_real c35 = L_dot*c16;
        const stewart_real c36 = c31*theta_dot;
        const stewart_real c37 = L_dot*h_y;
        const stewart_real c38 = c37*k1;
        const stewart_real c39 = theta_dot*STEWART_FMA(-c9, k3, J_yz*k1);
        const stewart_real tau_phi = STEWART_FMA(phi_ddot, STEWART_FMA(c25, c8, STEWART_FMA(c27, c6, J_xx)),
            STEWART_FMA(c24, theta_ddot, STEWART_FMA(L_dot, STEWART_FMA(c16, phi_dot, -c34),
            STEWART_FMA(theta_dot, STEWART_FMA(c31, phi_dot, c39 - c38), STEWART_FMA(-gamma_n, w_y,
            STEWART_FMA(phi_dot, c35 + c36, STEWART_FMA(C_us, phi_dot, STEWART_FMA(-L_ddot, c11,
            STEWART_FMA(-C_s, w_k_omega, c22*gamma_y)))))))));
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
        const stewart_real c46 = STEWART_FMA(-c2, inv_rho, -c45);
        const stewart_real G_dot_32 = c46;
        const stewart_real c47 = c42*inv_rho;
        const stewart_real G_dot_33 = c47;
        const stewart_real c48 = c4*c6;
        const stewart_real G_ddot_11 = -c3 - c48;
        const stewart_real c49 = k3*phi_ddot;
        const stewart_real c50 = c5*k1;
        const stewart_real G_ddot_12 = STEWART_FMA(c50, theta_dot, c49);
        const stewart_real c51 = c4*c8;
        const stewart_real G_ddot_13 = c51 - theta_ddot;
        const stewart_real G_ddot_21 = STEWART_FMA(-inv_L, theta_ddot, STEWART_FMA(-c51, inv_L,
            REAL(2)*L_dot*c14*theta_dot));
        const stewart_real G_ddot_22 = STEWART_FMA(-c43, c50, STEWART_FMA(c41*c5, -k3, inv_L*k1*phi_ddot));
        const stewart_real c52 = c4*k1*k1;
        const stewart_real G_ddot_23 = STEWART_FMA(L_ddot, c14, STEWART_FMA(c52, inv_L,
            STEWART_FMA(REAL(2)*L_dot*L_dot*inv_L*inv_L, -inv_L, c3*inv_L)));
        const stewart_real G_ddot_31 = STEWART_FMA(-c49, inv_rho, STEWART_FMA(theta_dot,
            STEWART_FMA(inv_rho*k3*kappa, phi_dot, -c47), STEWART_FMA(-c40, c46, STEWART_FMA(c47, theta_dot,
            c1*c44))));
        const stewart_real c53 = inv_rho*kappa;
        const stewart_real c54 = -c1 - c2;
        const stewart_real G_ddot_32 = STEWART_FMA(-c53, theta_ddot, STEWART_FMA(theta_dot,
            STEWART_FMA(-c53, c54, -inv_rho*theta_dot*STEWART_FMA(-kappa, kappa, -REAL(1))),
            STEWART_FMA(-L_ddot, c13, STEWART_FMA(-c52, inv_rho, STEWART_FMA(-c48, inv_rho,
            L_dot*STEWART_FMA(-c13, c54, c43*inv_rho))))));
        const stewart_real G_ddot_33 = STEWART_FMA(inv_rho*k1, phi_ddot, STEWART_FMA(theta_dot,
            STEWART_FMA(-c47, kappa, -c44), STEWART_FMA(-c42, c45, STEWART_FMA(c44, theta_dot, c42*c46))));
        const stewart_real tau_rate_12 = -c18;
        const stewart_real tau_rate_13 = -c16*c5;
        const stewart_real tau_rate_21 = c18;
        const stewart_real c55 = REAL(2)*h_x;
        const stewart_real tau_rate_22 = STEWART_FMA(L_dot, c55, C_us);
        const stewart_real tau_rate_23 = -c31*c5;
        const stewart_real tau_rate_31 = REAL(2)*STEWART_FMA(c16, phi_dot, -c34);
        const stewart_real tau_rate_32 = STEWART_FMA(c31, c5, STEWART_FMA(REAL(2), -c38, REAL(2)*c39));
        const stewart_real tau_rate_33 = STEWART_FMA(REAL(2), c36, STEWART_FMA(REAL(2), c35, C_us));
        const stewart_real c56 = h_y*phi_ddot;
        const stewart_real c57 = STEWART_FMA(-h_z, k1, c55*k3);
        const stewart_real tau_place_12 = STEWART_FMA(-c48, h_z, k1*(-c4*c57 - c56));
        const stewart_real c58 = REAL(4)*h_x;
        const stewart_real c59 = STEWART_FMA(c30, STEWART_FMA(REAL(2)*h_z, -k1, c58*k3), c6*h_z);
        const stewart_real tau_place_21 = STEWART_FMA(-c56, k1, STEWART_FMA(-c4, c59, c55*theta_ddot));
        const stewart_real c60 = STEWART_FMA(-c25, k3, c30*STEWART_FMA(L, c58, STEWART_FMA(REAL(2), -J_xx,
            REAL(2)*J_zz)));
        const stewart_real c61 = c28 + c26;
        const stewart_real tau_place_22 = STEWART_FMA(-k3, STEWART_FMA(c9, phi_ddot, STEWART_FMA(-c4, c61,
            STEWART_FMA(-g_k, w_z, gamma_n*w_x))), k1*STEWART_FMA(J_yz, phi_ddot, STEWART_FMA(gamma_n, w_z,
            STEWART_FMA(-c4, c60, g_k*w_x))));
        const stewart_real tau_place_23 = STEWART_FMA(-C_s, w_n_omega, -c21*gamma_y);
        const stewart_real c62 = c59*phi_dot;
        const stewart_real tau_place_31 = STEWART_FMA(h_y*k1, -theta_ddot, STEWART_FMA(phi_ddot,
            REAL(2)*STEWART_FMA(-c8, h_z, c15), STEWART_FMA(theta_dot, STEWART_FMA(c11, theta_dot, c62),
            c62*theta_dot)));
        const stewart_real c63 = L_dot*c57;
        const stewart_real tau_place_32 = STEWART_FMA(-k3, STEWART_FMA(c25, c49, STEWART_FMA(L_dot,
            STEWART_FMA(-c40, h_z, -c33), STEWART_FMA(c9, theta_ddot, STEWART_FMA(theta_dot,
            STEWART_FMA(c61, phi_dot, STEWART_FMA(J_yz, theta_dot, -c37)), STEWART_FMA(phi_dot,
            STEWART_FMA(L_dot*h_z, -k3, c61*theta_dot), gamma_y*w_z))))), k1*STEWART_FMA(c29, phi_ddot,
            STEWART_FMA(J_yz, theta_ddot, STEWART_FMA(theta_dot, STEWART_FMA(-c9, theta_dot, c60*phi_dot),
            STEWART_FMA(-gamma_y, w_x, STEWART_FMA(phi_dot, STEWART_FMA(c60, theta_dot, c63),
            STEWART_FMA(-L_ddot, h_y, c63*phi_dot)))))));
        const stewart_real tau_place_33 = STEWART_FMA(gamma_y, w_y, c22*gamma_n);
        const stewart_real c64 = inv_rho*tau_phi;
        const stewart_real c65 = inv_L*tau_theta;
        const stewart_real c66 = tau_L - F;
        /* force at the tip, less the actuator's */
        const stewart_real R_tip_x = STEWART_FMA(-c65, z_x, STEWART_FMA(c66, s_x, c64*y_x));
        const stewart_real R_tip_y = STEWART_FMA(-c65, z_y, STEWART_FMA(c66, s_y, c64*y_y));
        const stewart_real R_tip_z = STEWART_FMA(-c65, z_z, STEWART_FMA(c66, s_z, c64*y_z));
        /* slope of a rate, times C_s */
        const stewart_real theta_dot_by_S_x = C_s*STEWART_FMA(G_dot_22, y_x, STEWART_FMA(G_dot_21, s_x,
            G_dot_23*z_x));
        const stewart_real theta_dot_by_S_y = C_s*STEWART_FMA(G_dot_22, y_y, STEWART_FMA(G_dot_21, s_y,
            G_dot_23*z_y));
        const stewart_real theta_dot_by_S_z = C_s*STEWART_FMA(G_dot_22, y_z, STEWART_FMA(G_dot_21, s_z,
            G_dot_23*z_z));
        const stewart_real phi_dot_by_S_x = C_s*STEWART_FMA(G_dot_31, s_x, STEWART_FMA(G_dot_33, z_x,
            G_dot_32*y_x));
        const stewart_real phi_dot_by_S_y = C_s*STEWART_FMA(G_dot_31, s_y, STEWART_FMA(G_dot_33, z_y,
            G_dot_32*y_y));
        const stewart_real phi_dot_by_S_z = C_s*STEWART_FMA(G_dot_31, s_z, STEWART_FMA(G_dot_33, z_z,
            G_dot_32*y_z));
        const stewart_real c67 = C_s*inv_L;
        /* gradient of theta, times C_s */
        const stewart_real C_s_theta_x = -c67*z_x;
        const stewart_real C_s_theta_y = -c67*z_y;
        const stewart_real C_s_theta_z = -c67*z_z;
        const stewart_real c68 = C_s*inv_rho;
        /* gradient of phi, times C_s */
        const stewart_real C_s_phi_x = c68*y_x;
        const stewart_real C_s_phi_y = c68*y_y;
        const stewart_real C_s_phi_z = c68*y_z;
        const stewart_real y_by_phi_x = normal_x*theta_dot;
        const stewart_real y_by_phi_y = normal_y*theta_dot;
        const stewart_real y_by_phi_z = normal_z*theta_dot;
        /* friction moment by S */
        const stewart_real f_S_xx = STEWART_FMA(k_x, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_x,
            C_s_phi_x*y_by_phi_x));
        const stewart_real f_S_xy = STEWART_FMA(k_x, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_x,
            C_s_phi_y*y_by_phi_x));
        const stewart_real f_S_xz = STEWART_FMA(k_x, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_x,
            C_s_phi_z*y_by_phi_x));
        const stewart_real f_S_yx = STEWART_FMA(k_y, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_y,
            C_s_phi_x*y_by_phi_y));
        const stewart_real f_S_yy = STEWART_FMA(k_y, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_y,
            C_s_phi_y*y_by_phi_y));
        const stewart_real f_S_yz = STEWART_FMA(k_y, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_y,
            C_s_phi_z*y_by_phi_y));
        const stewart_real f_S_zx = STEWART_FMA(k_z, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_z,
            C_s_phi_x*y_by_phi_z));
        const stewart_real f_S_zy = STEWART_FMA(k_z, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_z,
            C_s_phi_y*y_by_phi_z));
        const stewart_real f_S_zz = STEWART_FMA(k_z, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_z,
            C_s_phi_z*y_by_phi_z));
        /* friction moment by S_dot */
        const stewart_real f_S_dot_xx = STEWART_FMA(C_s_phi_x, k_x, C_s_theta_x*y_x);
        const stewart_real f_S_dot_xy = STEWART_FMA(C_s_phi_y, k_x, C_s_theta_y*y_x);
        const stewart_real f_S_dot_xz = STEWART_FMA(C_s_phi_z, k_x, C_s_theta_z*y_x);
        const stewart_real f_S_dot_yx = STEWART_FMA(C_s_phi_x, k_y, C_s_theta_x*y_y);
        const stewart_real f_S_dot_yy = STEWART_FMA(C_s_phi_y, k_y, C_s_theta_y*y_y);
        const stewart_real f_S_dot_yz = STEWART_FMA(C_s_phi_z, k_y, C_s_theta_z*y_y);
        const stewart_real f_S_dot_zx = STEWART_FMA(C_s_phi_x, k_z, C_s_theta_x*y_z);
        const stewart_real f_S_dot_zy = STEWART_FMA(C_s_phi_y, k_z, C_s_theta_y*y_z);
        const stewart_real f_S_dot_zz = STEWART_FMA(C_s_phi_z, k_z, C_s_theta_z*y_z);
        const stewart_real A_0_leg_11 = STEWART_FMA(-G_ddot_31, k3_h, STEWART_FMA(G_ddot_21, h_z,
            STEWART_FMA(G_dot_31, tau_rate_13, G_dot_21*tau_rate_12)));
        const stewart_real A_0_leg_12 = STEWART_FMA(c12*k3, -tau_phi, STEWART_FMA(-G_ddot_32, k3_h,
            STEWART_FMA(G_ddot_22, h_z, STEWART_FMA(G_dot_32, tau_rate_13, STEWART_FMA(G_dot_22,
            tau_rate_12, C_p*G_dot_12)))));
        const stewart_real c69 = c14*tau_theta;
        const stewart_real A_0_leg_13 = STEWART_FMA(-inv_L, tau_place_12, STEWART_FMA(-G_ddot_33, k3_h,
            STEWART_FMA(G_dot_33, tau_rate_13, STEWART_FMA(G_dot_23, tau_rate_12, STEWART_FMA(-C_p,
            theta_dot, G_ddot_23*h_z))) + c69));
        const stewart_real c70 = c13*tau_phi;
        const stewart_real A_0_leg_21 = STEWART_FMA(inv_rho, STEWART_FMA(G_ddot_31, M_phi,
            STEWART_FMA(G_ddot_21, M_mixed, STEWART_FMA(G_dot_31, tau_rate_33, STEWART_FMA(-G_ddot_11, k3_h,
            G_dot_21*tau_rate_32))) + tau_place_31), -c70);
        const stewart_real A_0_leg_22 = STEWART_FMA(inv_rho, STEWART_FMA(-G_ddot_12, k3_h,
            STEWART_FMA(G_ddot_32, M_phi, STEWART_FMA(G_ddot_22, M_mixed, STEWART_FMA(G_dot_22, tau_rate_32,
            STEWART_FMA(G_dot_12, tau_rate_31, STEWART_FMA(inv_rho, tau_place_33,
            G_dot_32*tau_rate_33)))))), STEWART_FMA(c66*inv_rho, k3, c13*k1*tau_theta));
        const stewart_real A_0_leg_23 = STEWART_FMA(inv_rho, STEWART_FMA(-inv_L, tau_place_32,
            STEWART_FMA(G_ddot_33, M_phi, STEWART_FMA(-G_ddot_13, k3_h, STEWART_FMA(-tau_rate_31, theta_dot,
            STEWART_FMA(G_dot_23, tau_rate_32, STEWART_FMA(G_dot_33, tau_rate_33, G_ddot_23*M_mixed)))))),
            c70*kappa);
        const stewart_real A_0_leg_31 = STEWART_FMA(-inv_L, STEWART_FMA(G_ddot_31, M_mixed,
            STEWART_FMA(G_ddot_21, M_theta, STEWART_FMA(G_dot_31, tau_rate_23, STEWART_FMA(G_dot_21,
            tau_rate_22, G_ddot_11*h_z))) + tau_place_21), c69);
        const stewart_real A_0_leg_32 = STEWART_FMA(-inv_L, STEWART_FMA(G_ddot_32, M_mixed,
            STEWART_FMA(G_ddot_22, M_theta, STEWART_FMA(G_ddot_12, h_z, STEWART_FMA(inv_rho, tau_place_23,
            STEWART_FMA(G_dot_32, tau_rate_23, STEWART_FMA(G_dot_22, tau_rate_22,
            G_dot_12*tau_rate_21)))))), c12*k1*tau_phi);
        const stewart_real A_0_leg_33 = STEWART_FMA(-inv_L, STEWART_FMA(-inv_L, tau_place_22,
            STEWART_FMA(G_ddot_33, M_mixed, STEWART_FMA(G_ddot_13, h_z, STEWART_FMA(G_dot_33, tau_rate_23,
            STEWART_FMA(-tau_rate_21, theta_dot, STEWART_FMA(G_dot_23, tau_rate_22, G_ddot_23*M_theta)))))),
            c66*inv_L);
        const stewart_real A_0_T_xs = STEWART_FMA(A_0_leg_31, z_x, STEWART_FMA(A_0_leg_21, y_x,
            A_0_leg_11*s_x));
        const stewart_real A_0_T_xy = STEWART_FMA(A_0_leg_32, z_x, STEWART_FMA(A_0_leg_22, y_x,
            A_0_leg_12*s_x));
        const stewart_real A_0_T_xz = STEWART_FMA(A_0_leg_33, z_x, STEWART_FMA(A_0_leg_23, y_x,
            A_0_leg_13*s_x));
        const stewart_real A_0_T_ys = STEWART_FMA(A_0_leg_31, z_y, STEWART_FMA(A_0_leg_21, y_y,
            A_0_leg_11*s_y));
        const stewart_real A_0_T_yy = STEWART_FMA(A_0_leg_32, z_y, STEWART_FMA(A_0_leg_22, y_y,
            A_0_leg_12*s_y));
        const stewart_real A_0_T_yz = STEWART_FMA(A_0_leg_33, z_y, STEWART_FMA(A_0_leg_23, y_y,
            A_0_leg_13*s_y));
        const stewart_real A_0_T_zs = STEWART_FMA(A_0_leg_31, z_z, STEWART_FMA(A_0_leg_21, y_z,
            A_0_leg_11*s_z));
        const stewart_real A_0_T_zy = STEWART_FMA(A_0_leg_32, z_z, STEWART_FMA(A_0_leg_22, y_z,
            A_0_leg_12*s_z));
        const stewart_real A_0_T_zz = STEWART_FMA(A_0_leg_33, z_z, STEWART_FMA(A_0_leg_23, y_z,
            A_0_leg_13*s_z));
        /* force at the tip by S */
        const stewart_real A_0_xx = STEWART_FMA(A_0_T_xz, z_x, STEWART_FMA(A_0_T_xy, y_x, A_0_T_xs*s_x));
        const stewart_real A_0_xy = STEWART_FMA(A_0_T_xz, z_y, STEWART_FMA(A_0_T_xy, y_y, A_0_T_xs*s_y));
        const stewart_real A_0_xz = STEWART_FMA(A_0_T_xz, z_z, STEWART_FMA(A_0_T_xy, y_z, A_0_T_xs*s_z));
        const stewart_real A_0_yx = STEWART_FMA(A_0_T_yz, z_x, STEWART_FMA(A_0_T_yy, y_x, A_0_T_ys*s_x));
        const stewart_real A_0_yy = STEWART_FMA(A_0_T_yz, z_y, STEWART_FMA(A_0_T_yy, y_y, A_0_T_ys*s_y));
        const stewart_real A_0_yz = STEWART_FMA(A_0_T_yz, z_z, STEWART_FMA(A_0_T_yy, y_z, A_0_T_ys*s_z));
        const stewart_real A_0_zx = STEWART_FMA(A_0_T_zz, z_x, STEWART_FMA(A_0_T_zy, y_x, A_0_T_zs*s_x));
        const stewart_real A_0_zy = STEWART_FMA(A_0_T_zz, z_y, STEWART_FMA(A_0_T_zy, y_y, A_0_T_zs*s_y));
        const stewart_real A_0_zz = STEWART_FMA(A_0_T_zz, z_z, STEWART_FMA(A_0_T_zy, y_z, A_0_T_zs*s_z));
        const stewart_real c71 = REAL(2)*h_z;
        const stewart_real c72 = REAL(2)*k3_h;
        const stewart_real A_1_leg_11 = STEWART_FMA(-G_dot_31, c72, STEWART_FMA(G_dot_21, c71, C_p));
        const stewart_real A_1_leg_12 = STEWART_FMA(-G_dot_32, c72, STEWART_FMA(inv_rho, tau_rate_13,
            G_dot_22*c71));
        const stewart_real A_1_leg_13 = STEWART_FMA(-G_dot_33, c72, STEWART_FMA(-inv_L, tau_rate_12,
            REAL(2)*G_dot_23*h_z));
        const stewart_real c73 = REAL(2)*M_mixed;
        const stewart_real c74 = REAL(2)*M_phi;
        const stewart_real A_1_leg_21 = inv_rho*STEWART_FMA(G_dot_31, c74, STEWART_FMA(G_dot_21, c73,
            tau_rate_31));
        const stewart_real A_1_leg_22 = inv_rho*STEWART_FMA(-G_dot_12, c72, STEWART_FMA(G_dot_32, c74,
            STEWART_FMA(G_dot_22, c73, inv_rho*tau_rate_33)));
        const stewart_real A_1_leg_23 = inv_rho*STEWART_FMA(-inv_L, tau_rate_32, STEWART_FMA(G_dot_33, c74,
            STEWART_FMA(c7, k3_h, G_dot_23*c73)));
        const stewart_real c75 = REAL(2)*M_theta;
        const stewart_real A_1_leg_31 = -inv_L*STEWART_FMA(G_dot_31, c73, STEWART_FMA(G_dot_21, c75,
            tau_rate_21));
        const stewart_real A_1_leg_32 = -inv_L*STEWART_FMA(inv_rho, tau_rate_23, STEWART_FMA(G_dot_32, c73,
            STEWART_FMA(G_dot_22, c75, G_dot_12*c71)));
        const stewart_real A_1_leg_33 = -inv_L*STEWART_FMA(G_dot_33, c73, STEWART_FMA(-c7, h_z,
            STEWART_FMA(-inv_L, tau_rate_22, G_dot_23*c75)));
        const stewart_real A_1_T_xs = STEWART_FMA(A_1_leg_31, z_x, STEWART_FMA(A_1_leg_21, y_x,
            A_1_leg_11*s_x));
        const stewart_real A_1_T_xy = STEWART_FMA(A_1_leg_32, z_x, STEWART_FMA(A_1_leg_22, y_x,
            A_1_leg_12*s_x));
        const stewart_real A_1_T_xz = STEWART_FMA(A_1_leg_23, y_x, STEWART_FMA(A_1_leg_33, z_x,
            A_1_leg_13*s_x));
        const stewart_real A_1_T_ys = STEWART_FMA(A_1_leg_31, z_y, STEWART_FMA(A_1_leg_21, y_y,
            A_1_leg_11*s_y));
        const stewart_real A_1_T_yy = STEWART_FMA(A_1_leg_32, z_y, STEWART_FMA(A_1_leg_22, y_y,
            A_1_leg_12*s_y));
        const stewart_real A_1_T_yz = STEWART_FMA(A_1_leg_23, y_y, STEWART_FMA(A_1_leg_33, z_y,
            A_1_leg_13*s_y));
        const stewart_real A_1_T_zs = STEWART_FMA(A_1_leg_31, z_z, STEWART_FMA(A_1_leg_21, y_z,
            A_1_leg_11*s_z));
        const stewart_real A_1_T_zy = STEWART_FMA(A_1_leg_32, z_z, STEWART_FMA(A_1_leg_22, y_z,
            A_1_leg_12*s_z));
        const stewart_real A_1_T_zz = STEWART_FMA(A_1_leg_23, y_z, STEWART_FMA(A_1_leg_33, z_z,
            A_1_leg_13*s_z));
        /* force at the tip by S_dot */
        const stewart_real A_1_xx = STEWART_FMA(A_1_T_xy, y_x, STEWART_FMA(A_1_T_xs, s_x, A_1_T_xz*z_x));
        const stewart_real A_1_xy = STEWART_FMA(A_1_T_xy, y_y, STEWART_FMA(A_1_T_xs, s_y, A_1_T_xz*z_y));
        const stewart_real A_1_xz = STEWART_FMA(A_1_T_xy, y_z, STEWART_FMA(A_1_T_xs, s_z, A_1_T_xz*z_z));
        const stewart_real A_1_yx = STEWART_FMA(A_1_T_yy, y_x, STEWART_FMA(A_1_T_ys, s_x, A_1_T_yz*z_x));
        const stewart_real A_1_yy = STEWART_FMA(A_1_T_yy, y_y, STEWART_FMA(A_1_T_ys, s_y, A_1_T_yz*z_y));
        const stewart_real A_1_yz = STEWART_FMA(A_1_T_yy, y_z, STEWART_FMA(A_1_T_ys, s_z, A_1_T_yz*z_z));
        const stewart_real A_1_zx = STEWART_FMA(A_1_T_zy, y_x, STEWART_FMA(A_1_T_zs, s_x, A_1_T_zz*z_x));
        const stewart_real A_1_zy = STEWART_FMA(A_1_T_zy, y_y, STEWART_FMA(A_1_T_zs, s_y, A_1_T_zz*z_y));
        const stewart_real A_1_zz = STEWART_FMA(A_1_T_zy, y_z, STEWART_FMA(A_1_T_zs, s_z, A_1_T_zz*z_z));
        /* derivative of the force by rotation about the tip */
        const stewart_real X_xx = STEWART_FMA(-A_1_xz, omega_y, STEWART_FMA(A_1_xy, omega_z,
            STEWART_FMA(B_zx, m_xz, STEWART_FMA(B_yx, m_xy, B_xx*m_xx)))) + A_0_xx;
        const stewart_real X_xy = STEWART_FMA(-A_1_xx, omega_z, STEWART_FMA(A_1_xz, omega_x,
            STEWART_FMA(B_zy, m_xz, STEWART_FMA(B_yy, m_xy, B_xy*m_xx)))) + A_0_xy;
        const stewart_real X_xz = STEWART_FMA(-A_1_xy, omega_x, STEWART_FMA(A_1_xx, omega_y,
            STEWART_FMA(B_zz, m_xz, STEWART_FMA(B_yz, m_xy, B_xz*m_xx)))) + A_0_xz;
        const stewart_real X_yx = STEWART_FMA(-A_1_yz, omega_y, STEWART_FMA(A_1_yy, omega_z,
            STEWART_FMA(B_zx, m_yz, STEWART_FMA(B_yx, m_yy, B_xx*m_xy)))) + A_0_yx;
        const stewart_real X_yy = STEWART_FMA(-A_1_yx, omega_z, STEWART_FMA(A_1_yz, omega_x,
            STEWART_FMA(B_zy, m_yz, STEWART_FMA(B_yy, m_yy, B_xy*m_xy)))) + A_0_yy;
        const stewart_real X_yz = STEWART_FMA(-A_1_yy, omega_x, STEWART_FMA(A_1_yx, omega_y,
            STEWART_FMA(B_zz, m_yz, STEWART_FMA(B_yz, m_yy, B_xz*m_xy)))) + A_0_yz;
        const stewart_real X_zx = STEWART_FMA(-A_1_zz, omega_y, STEWART_FMA(A_1_zy, omega_z,
            STEWART_FMA(B_zx, m_zz, STEWART_FMA(B_yx, m_yz, B_xx*m_xz)))) + A_0_zx;
        const stewart_real X_zy = STEWART_FMA(-A_1_zx, omega_z, STEWART_FMA(A_1_zz, omega_x,
            STEWART_FMA(B_zy, m_zz, STEWART_FMA(B_yy, m_yz, B_xy*m_xz)))) + A_0_zy;
        const stewart_real X_zz = STEWART_FMA(-A_1_zy, omega_x, STEWART_FMA(A_1_zx, omega_y,
            STEWART_FMA(B_zz, m_zz, STEWART_FMA(B_yz, m_yz, B_xz*m_xz)))) + A_0_zz;
        const stewart_real c76 = m_xy*omega_z;
        const stewart_real c77 = m_xz*omega_y;
        const stewart_real Y_xx = c76 - c77 + A_1_xx;
        const stewart_real Y_xy = STEWART_FMA(-m_xx, omega_z, m_xz*omega_x) + A_1_xy;
        const stewart_real Y_xz = STEWART_FMA(-m_xy, omega_x, m_xx*omega_y) + A_1_xz;
        const stewart_real Y_yx = STEWART_FMA(-m_yz, omega_y, m_yy*omega_z) + A_1_yx;
        const stewart_real c78 = m_yz*omega_x;
        const stewart_real Y_yy = c78 - c76 + A_1_yy;
        const stewart_real Y_yz = STEWART_FMA(-m_yy, omega_x, m_xy*omega_y) + A_1_yz;
        const stewart_real Y_zx = STEWART_FMA(-m_zz, omega_y, m_yz*omega_z) + A_1_zx;
        const stewart_real Y_zy = STEWART_FMA(-m_xz, omega_z, m_zz*omega_x) + A_1_zy;
        const stewart_real Y_zz = c77 - c78 + A_1_zz;
        const stewart_real c79 = X_xy*q_z;
        const stewart_real Z_xx = STEWART_FMA(X_xz, q_y, -c79);
        const stewart_real c80 = X_xx*q_z;
        const stewart_real Z_xy = STEWART_FMA(-X_xz, q_x, c80);
        const stewart_real c81 = X_xx*q_y;
        const stewart_real Z_xz = STEWART_FMA(X_xy, q_x, -c81);
        const stewart_real c82 = X_yy*q_z;
        const stewart_real Z_yx = STEWART_FMA(X_yz, q_y, -c82);
        const stewart_real c83 = X_yx*q_z;
        const stewart_real c84 = -X_yz*q_x;
        const stewart_real Z_yy = c83 + c84;
        const stewart_real c85 = -X_yy*q_x;
        const stewart_real Z_yz = -X_yx*q_y - c85;
        const stewart_real c86 = -X_zz*q_y;
        const stewart_real Z_zx = -X_zy*q_z - c86;
        const stewart_real c87 = -X_zz*q_x;
        const stewart_real Z_zy = STEWART_FMA(X_zx, q_z, c87);
        const stewart_real c88 = X_zx*q_y;
        const stewart_real Z_zz = STEWART_FMA(X_zy, q_x, -c88);
        const stewart_real c89 = m_xy*w_q_z;
        const stewart_real c90 = m_xz*w_q_y;
        const stewart_real V_xx = STEWART_FMA(-Y_xy, q_z, STEWART_FMA(Y_xz, q_y, c90 - f_S_dot_xx - c89));
        const stewart_real V_xy = STEWART_FMA(-Y_xz, q_x, STEWART_FMA(Y_xx, q_z, STEWART_FMA(-m_xz, w_q_x,
            STEWART_FMA(m_xx, w_q_z, -f_S_dot_yx))));
        const stewart_real V_xz = STEWART_FMA(-Y_xx, q_y, STEWART_FMA(Y_xy, q_x, STEWART_FMA(-m_xx, w_q_y,
            STEWART_FMA(m_xy, w_q_x, -f_S_dot_zx))));
        const stewart_real V_yx = STEWART_FMA(-Y_yy, q_z, STEWART_FMA(Y_yz, q_y, STEWART_FMA(-m_yy, w_q_z,
            STEWART_FMA(m_yz, w_q_y, -f_S_dot_xy))));
        const stewart_real c91 = m_yz*w_q_x;
        const stewart_real V_yy = STEWART_FMA(-Y_yz, q_x, STEWART_FMA(Y_yx, q_z, c89 - f_S_dot_yy - c91));
        const stewart_real V_yz = STEWART_FMA(-Y_yx, q_y, STEWART_FMA(Y_yy, q_x, STEWART_FMA(-m_xy, w_q_y,
            STEWART_FMA(m_yy, w_q_x, -f_S_dot_zy))));
        const stewart_real V_zx = STEWART_FMA(-Y_zy, q_z, STEWART_FMA(Y_zz, q_y, STEWART_FMA(-m_yz, w_q_z,
            STEWART_FMA(m_zz, w_q_y, -f_S_dot_xz))));
        const stewart_real V_zy = STEWART_FMA(-Y_zz, q_x, STEWART_FMA(Y_zx, q_z, STEWART_FMA(-m_zz, w_q_x,
            STEWART_FMA(m_xz, w_q_z, -f_S_dot_yz))));
        const stewart_real V_zz = STEWART_FMA(-Y_zx, q_y, STEWART_FMA(Y_zy, q_x, c91 - f_S_dot_zz - c90));
        /* derivative of the moment by rotation about the tip */
        const stewart_real Q_xx = STEWART_FMA(-f_S_dot_xz, omega_y, f_S_dot_xy*omega_z) + f_S_xx + c83 - c88;
        const stewart_real Q_xy = STEWART_FMA(-X_zy, q_y, STEWART_FMA(-f_S_dot_xx, omega_z,
            f_S_dot_xz*omega_x) + f_S_xy - R_tip_z + c82);
        const stewart_real Q_xz = STEWART_FMA(X_yz, q_z, STEWART_FMA(-f_S_dot_xy, omega_x,
            f_S_dot_xx*omega_y) + f_S_xz + R_tip_y) + c86;
        const stewart_real Q_yx = STEWART_FMA(X_zx, q_x, STEWART_FMA(-f_S_dot_yz, omega_y,
            f_S_dot_yy*omega_z) + f_S_yx + R_tip_z) - c80;
        const stewart_real Q_yy = STEWART_FMA(X_zy, q_x, STEWART_FMA(-f_S_dot_yx, omega_z,
            f_S_dot_yz*omega_x) + f_S_yy) - c79;
        const stewart_real Q_yz = STEWART_FMA(-X_xz, q_z, STEWART_FMA(-f_S_dot_yy, omega_x,
            f_S_dot_yx*omega_y) + f_S_yz - R_tip_x) - c87;
        const stewart_real Q_zx = STEWART_FMA(-X_yx, q_x, STEWART_FMA(-f_S_dot_zz, omega_y,
            f_S_dot_zy*omega_z) + f_S_zx - R_tip_y + c81);
        const stewart_real Q_zy = STEWART_FMA(X_xy, q_y, STEWART_FMA(-f_S_dot_zx, omega_z,
            f_S_dot_zz*omega_x) + f_S_zy + R_tip_x) + c85;
        const stewart_real Q_zz = STEWART_FMA(X_xz, q_y, STEWART_FMA(-f_S_dot_zy, omega_x,
            f_S_dot_zx*omega_y) + f_S_zz) + c84;
        const stewart_real c92 = m_xy*q_z;
        const stewart_real c93 = m_xz*q_y;
        const stewart_real c94 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c92 - c93;
        const stewart_real m_q_xy = STEWART_FMA(-m_xx, q_z, m_xz*q_x);
        const stewart_real m_q_xz = STEWART_FMA(-m_xy, q_x, m_xx*q_y);
        const stewart_real m_q_yx = STEWART_FMA(-m_yz, q_y, m_yy*q_z);
        const stewart_real m_q_yy = -c92 - c94;
        const stewart_real m_q_yz = STEWART_FMA(-m_yy, q_x, m_xy*q_y);
        const stewart_real m_q_zx = STEWART_FMA(-m_zz, q_y, m_yz*q_z);
        const stewart_real m_q_zy = STEWART_FMA(-m_xz, q_z, m_zz*q_x);
        const stewart_real m_q_zz = c93 + c94;
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
        out->sum[15][l] = STEWART_FMA(-m_q_zx, q_y, m_q_yx*q_z);
        out->sum[16][l] = STEWART_FMA(-m_q_zy, q_y, m_q_yy*q_z);
        out->sum[17][l] = STEWART_FMA(-m_q_zz, q_y, m_q_yz*q_z);
        out->sum[18][l] = STEWART_FMA(-m_q_xy, q_z, m_q_zy*q_x);
        out->sum[19][l] = STEWART_FMA(-m_q_xz, q_z, m_q_zz*q_x);
        out->sum[20][l] = STEWART_FMA(-m_q_yz, q_x, m_q_xz*q_y);
        out->sum[21][l] = A_0_xx;
        out->sum[22][l] = A_0_xy;
        out->sum[23][l] = A_0_xz;
        out->sum[24][l] = Z_xx;
        out->sum[25][l] = Z_xy;
        out->sum[26][l] = Z_xz;
        out->sum[27][l] = A_0_yx;
        out->sum[28][l] = A_0_yy;
        out->sum[29][l] = A_0_yz;
        out->sum[30][l] = Z_yx;
        out->sum[31][l] = Z_yy;
        out->sum[32][l] = Z_yz;
        out->sum[33][l] = A_0_zx;
        out->sum[34][l] = A_0_zy;
        out->sum[35][l] = A_0_zz;
        out->sum[36][l] = Z_zx;
        out->sum[37][l] = Z_zy;
        out->sum[38][l] = Z_zz;
        out->sum[39][l] = STEWART_FMA(-A_0_yx, q_z, STEWART_FMA(A_0_zx, q_y, -f_S_xx));
        out->sum[40][l] = STEWART_FMA(-A_0_yy, q_z, STEWART_FMA(A_0_zy, q_y, -f_S_xy));
        out->sum[41][l] = STEWART_FMA(-A_0_yz, q_z, STEWART_FMA(A_0_zz, q_y, -f_S_xz));
        out->sum[42][l] = STEWART_FMA(-Q_xz, q_y, Q_xy*q_z);
        out->sum[43][l] = STEWART_FMA(-Q_xx, q_z, Q_xz*q_x);
        out->sum[44][l] = STEWART_FMA(-Q_xy, q_x, Q_xx*q_y);
        out->sum[45][l] = STEWART_FMA(-A_0_zx, q_x, STEWART_FMA(A_0_xx, q_z, -f_S_yx));
        out->sum[46][l] = STEWART_FMA(-A_0_zy, q_x, STEWART_FMA(A_0_xy, q_z, -f_S_yy));
        out->sum[47][l] = STEWART_FMA(-A_0_zz, q_x, STEWART_FMA(A_0_xz, q_z, -f_S_yz));
        out->sum[48][l] = STEWART_FMA(-Q_yz, q_y, Q_yy*q_z);
        out->sum[49][l] = STEWART_FMA(-Q_yx, q_z, Q_yz*q_x);
        out->sum[50][l] = STEWART_FMA(-Q_yy, q_x, Q_yx*q_y);
        out->sum[51][l] = STEWART_FMA(-A_0_xx, q_y, STEWART_FMA(A_0_yx, q_x, -f_S_zx));
        out->sum[52][l] = STEWART_FMA(-A_0_xy, q_y, STEWART_FMA(A_0_yy, q_x, -f_S_zy));
        out->sum[53][l] = STEWART_FMA(-A_0_xz, q_y, STEWART_FMA(A_0_yz, q_x, -f_S_zz));
        out->sum[54][l] = STEWART_FMA(-Q_zz, q_y, Q_zy*q_z);
        out->sum[55][l] = STEWART_FMA(-Q_zx, q_z, Q_zz*q_x);
        out->sum[56][l] = STEWART_FMA(-Q_zy, q_x, Q_zx*q_y);
        out->sum[57][l] = A_1_xx;
        out->sum[58][l] = A_1_xy;
        out->sum[59][l] = A_1_xz;
        out->sum[60][l] = V_xx;
        out->sum[61][l] = V_xy;
        out->sum[62][l] = V_xz;
        out->sum[63][l] = A_1_yx;
        out->sum[64][l] = A_1_yy;
        out->sum[65][l] = A_1_yz;
        out->sum[66][l] = V_yx;
        out->sum[67][l] = V_yy;
        out->sum[68][l] = V_yz;
        out->sum[69][l] = A_1_zx;
        out->sum[70][l] = A_1_zy;
        out->sum[71][l] = A_1_zz;
        out->sum[72][l] = V_zx;
        out->sum[73][l] = V_zy;
        out->sum[74][l] = V_zz;
        out->sum[75][l] = STEWART_FMA(-A_1_yx, q_z, STEWART_FMA(A_1_zx, q_y, -f_S_dot_xx));
        out->sum[76][l] = STEWART_FMA(-A_1_yy, q_z, STEWART_FMA(A_1_zy, q_y, -f_S_dot_xy));
        out->sum[77][l] = STEWART_FMA(-A_1_yz, q_z, STEWART_FMA(A_1_zz, q_y, -f_S_dot_xz));
        out->sum[78][l] = STEWART_FMA(-f_S_dot_xz, q_y, STEWART_FMA(-V_yx, q_z, STEWART_FMA(f_S_dot_xy, q_z,
            V_zx*q_y)));
        out->sum[79][l] = STEWART_FMA(-f_S_dot_xx, q_z, STEWART_FMA(-V_yy, q_z, STEWART_FMA(f_S_dot_xz, q_x,
            V_zy*q_y)));
        out->sum[80][l] = STEWART_FMA(-f_S_dot_xy, q_x, STEWART_FMA(-V_yz, q_z, STEWART_FMA(f_S_dot_xx, q_y,
            V_zz*q_y)));
        out->sum[81][l] = STEWART_FMA(-A_1_zx, q_x, STEWART_FMA(A_1_xx, q_z, -f_S_dot_yx));
        out->sum[82][l] = STEWART_FMA(-A_1_zy, q_x, STEWART_FMA(A_1_xy, q_z, -f_S_dot_yy));
        out->sum[83][l] = STEWART_FMA(-A_1_zz, q_x, STEWART_FMA(A_1_xz, q_z, -f_S_dot_yz));
        out->sum[84][l] = STEWART_FMA(-f_S_dot_yz, q_y, STEWART_FMA(-V_zx, q_x, STEWART_FMA(f_S_dot_yy, q_z,
            V_xx*q_z)));
        out->sum[85][l] = STEWART_FMA(-f_S_dot_yx, q_z, STEWART_FMA(-V_zy, q_x, STEWART_FMA(f_S_dot_yz, q_x,
            V_xy*q_z)));
        out->sum[86][l] = STEWART_FMA(-f_S_dot_yy, q_x, STEWART_FMA(-V_zz, q_x, STEWART_FMA(f_S_dot_yx, q_y,
            V_xz*q_z)));
        out->sum[87][l] = STEWART_FMA(-A_1_xx, q_y, STEWART_FMA(A_1_yx, q_x, -f_S_dot_zx));
        out->sum[88][l] = STEWART_FMA(-A_1_xy, q_y, STEWART_FMA(A_1_yy, q_x, -f_S_dot_zy));
        out->sum[89][l] = STEWART_FMA(-A_1_xz, q_y, STEWART_FMA(A_1_yz, q_x, -f_S_dot_zz));
        out->sum[90][l] = STEWART_FMA(-f_S_dot_zz, q_y, STEWART_FMA(-V_xx, q_y, STEWART_FMA(f_S_dot_zy, q_z,
            V_yx*q_x)));
        out->sum[91][l] = STEWART_FMA(-f_S_dot_zx, q_z, STEWART_FMA(-V_xy, q_y, STEWART_FMA(f_S_dot_zz, q_x,
            V_yy*q_x)));
        out->sum[92][l] = STEWART_FMA(-f_S_dot_zy, q_x, STEWART_FMA(-V_xz, q_y, STEWART_FMA(f_S_dot_zx, q_y,
            V_yz*q_x)));
        out->H_force[0][l] = s_x;
        out->H_force[1][l] = s_y;
        out->H_force[2][l] = s_z;
        out->H_moment[0][l] = STEWART_FMA(-q_z, s_y, q_y*s_z);
        out->H_moment[1][l] = STEWART_FMA(-q_x, s_z, q_z*s_x);
        out->H_moment[2][l] = STEWART_FMA(-q_y, s_x, q_x*s_y);
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* Computes the legs of a pose in lanes. */
STEWART_APART static void derivatives_of_near(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT motion,
    const derivatives_pose *STEWART_RESTRICT pose, derivatives_legs *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = motion->R[0], R_xy = motion->R[1], R_xz = motion->R[2], R_yx = motion->R[3],
        R_yy = motion->R[4], R_yz = motion->R[5], R_zx = motion->R[6], R_zy = motion->R[7], R_zz = motion->R[8];
    const stewart_real t_x = motion->t[0], t_y = motion->t[1], t_z = motion->t[2];
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    const stewart_real a_x = motion->a[0], a_y = motion->a[1], a_z = motion->a[2];
    const stewart_real B_xx = pose->B[0][0], B_xy = pose->B[1][0], B_xz = pose->B[2][0], B_yx = pose->B[3][0],
        B_yy = pose->B[4][0], B_yz = pose->B[5][0], B_zx = pose->B[6][0], B_zy = pose->B[7][0], B_zz = pose->B[8][0];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real h2_x = model->h2_x[l];
        const stewart_real h2_z = model->h2_z[l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_xz = model->J[2][l], J_yy = model->J[3][l],
            J_yz = model->J[4][l], J_zz = model->J[5][l];
        const stewart_real J2_xz = model->J2_xz[l];
        const stewart_real dJ_zx = model->dJ_zx[l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l], g_x_k_z = model->g_x_k[2][l];
        const stewart_real C_us = model->C_us[l];
        const stewart_real F = out->F[l];
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
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(omega_z, -q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(omega_x, -q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(omega_y, -q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
        const stewart_real c1 = STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y, S_dot_x*y_x));
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = c1*inv_rho;
        const stewart_real theta_dot = -inv_L*STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y,
            S_dot_x*z_x));
        const stewart_real c2 = L_dot*inv_L;
        /* L_dot / L */
        const stewart_real L_share = c2;
        const stewart_real c3 = theta_dot*theta_dot;
        const stewart_real theta_dot2 = c3;
        const stewart_real phi_dot2 = phi_dot*phi_dot;
        const stewart_real inv_k3 = L*inv_rho;
        /* (6) angular velocity of the leg about z */
        const stewart_real W_z = c1*inv_L;
        /* (7) acceleration of the platform point */
        const stewart_real S_ddot_x = STEWART_FMA(B_xz, q_z, STEWART_FMA(B_xy, q_y, STEWART_FMA(B_xx, q_x,
            a_x)));
        const stewart_real S_ddot_y = STEWART_FMA(B_yz, q_z, STEWART_FMA(B_yy, q_y, STEWART_FMA(B_yx, q_x,
            a_y)));
        const stewart_real S_ddot_z = STEWART_FMA(B_zz, q_z, STEWART_FMA(B_zy, q_y, STEWART_FMA(B_zx, q_x,
            a_z)));
        const stewart_real c4 = k3*k3;
        /* (8) acceleration of the length */
        const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y,
            STEWART_FMA(S_ddot_x, s_x, L*STEWART_FMA(c4, phi_dot2, theta_dot2))));
        const stewart_real c5 = REAL(2)*L_share;
        /* (9) angular accelerations of the leg about y and z without the rotation of the frame about s */
        const stewart_real own_y = STEWART_FMA(-c5, theta_dot, -inv_L*STEWART_FMA(S_ddot_z, z_z,
            STEWART_FMA(S_ddot_y, z_y, S_ddot_x*z_x)));
        const stewart_real own_z = STEWART_FMA(-W_z, c5, inv_L*STEWART_FMA(S_ddot_z, y_z,
            STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)));
        const stewart_real k33 = c4;
        const stewart_real k13 = k1*k3;
        const stewart_real L_h2 = L*h2_x;
        const stewart_real a1 = dJ_zx + L_h2;
        const stewart_real a2 = STEWART_FMA(-L, h2_z, J2_xz);
        const stewart_real c6 = L*h_y;
        const stewart_real a3 = J_xy - c6;
        const stewart_real c7 = J_yz*k3;
        /* (19) inertia of the joint coordinates */
        const stewart_real M_phi = STEWART_FMA(a2, k13, STEWART_FMA(a1, k33, J_xx));
        const stewart_real M_theta = J_yy + L_h2;
        const stewart_real M_mixed = STEWART_FMA(a3, k1, c7);
        const stewart_real c8 = h_y*k3;
        const stewart_real k3_h = c8;
        const stewart_real c9 = h_z*inv_L;
        const stewart_real c10 = inv_L*inv_L;
        /* inertia at the tip, leg frame */
        const stewart_real m_leg_sy = -inv_rho*k3_h;
        const stewart_real m_leg_sz = -c9;
        const stewart_real m_leg_yy = M_phi*inv_rho*inv_rho;
        const stewart_real m_leg_yz = -M_mixed*inv_L*inv_rho;
        const stewart_real m_leg_zz = M_theta*c10;
        const stewart_real m_T_xs = STEWART_FMA(m_leg_sy, y_x, m_leg_sz*z_x);
        const stewart_real m_T_xy = STEWART_FMA(m_leg_yz, z_x, STEWART_FMA(m_leg_yy, y_x, m_leg_sy*s_x));
        const stewart_real m_T_xz = STEWART_FMA(m_leg_yz, y_x, STEWART_FMA(m_leg_zz, z_x, m_leg_sz*s_x));
        const stewart_real m_T_ys = STEWART_FMA(m_leg_sy, y_y, m_leg_sz*z_y);
        const stewart_real m_T_yy = STEWART_FMA(m_leg_yz, z_y, STEWART_FMA(m_leg_yy, y_y, m_leg_sy*s_y));
        const stewart_real m_T_yz = STEWART_FMA(m_leg_yz, y_y, STEWART_FMA(m_leg_zz, z_y, m_leg_sz*s_y));
        const stewart_real m_T_zs = STEWART_FMA(m_leg_sy, y_z, m_leg_sz*z_z);
        const stewart_real m_T_zy = STEWART_FMA(m_leg_yz, z_z, STEWART_FMA(m_leg_yy, y_z, m_leg_sy*s_z));
        const stewart_real m_T_zz = STEWART_FMA(m_leg_yz, y_z, STEWART_FMA(m_leg_zz, z_z, m_leg_sz*s_z));
        /* inertia at the tip, base frame */
        const stewart_real m_xx = STEWART_FMA(m_T_xy, y_x, STEWART_FMA(m_T_xz, z_x, m_T_xs*s_x));
        const stewart_real m_xy = STEWART_FMA(m_T_xy, y_y, STEWART_FMA(m_T_xz, z_y, m_T_xs*s_y));
        const stewart_real m_xz = STEWART_FMA(m_T_xy, y_z, STEWART_FMA(m_T_xz, z_z, m_T_xs*s_z));
        const stewart_real m_yy = STEWART_FMA(m_T_yy, y_y, STEWART_FMA(m_T_yz, z_y, m_T_ys*s_y));
        const stewart_real m_yz = STEWART_FMA(m_T_yy, y_z, STEWART_FMA(m_T_yz, z_z, m_T_ys*s_z));
        const stewart_real m_zz = STEWART_FMA(m_T_zy, y_z, STEWART_FMA(m_T_zz, z_z, m_T_zs*s_z));
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* k x y */
        const stewart_real normal_x = STEWART_FMA(-k_z, y_y, k_y*y_z);
        const stewart_real normal_y = STEWART_FMA(-k_x, y_z, k_z*y_x);
        const stewart_real normal_z = STEWART_FMA(-k_y, y_x, k_x*y_y);
        /* omega along k x y, y and k */
        const stewart_real w_n_omega = STEWART_FMA(normal_z, omega_z, STEWART_FMA(normal_y, omega_y,
            normal_x*omega_x));
        const stewart_real w_y_omega = STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x));
        const stewart_real w_k_omega = STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y, k_x*omega_x));
        const stewart_real c11 = h_y*own_z;
        const stewart_real c12 = W_z*W_z;
        const stewart_real c13 = c12*h_x;
        const stewart_real c14 = c3*h_x;
        const stewart_real c15 = h_y*k1;
        const stewart_real c16 = W_z*inv_k3;
        const stewart_real c17 = REAL(2)*theta_dot;
        const stewart_real c18 = c16*c17;
        const stewart_real c19 = c12*h_z;
        const stewart_real c20 = inv_k3*k1;
        const stewart_real c21 = REAL(2)*c20;
        const stewart_real tau_L = STEWART_FMA(c15, c18, STEWART_FMA(h_z, own_y, STEWART_FMA(c19, c21,
            STEWART_FMA(C_p, L_dot, -c13) - c14))) - c11;
        const stewart_real c22 = C_us*theta_dot;
        const stewart_real c23 = J_yy*own_y;
        const stewart_real c24 = J_yz*own_z;
        const stewart_real c25 = L_ddot*h_z;
        const stewart_real c26 = C_s*w_y_omega;
        const stewart_real c27 = k3*w_x;
        const stewart_real c28 = c27*g_k;
        const stewart_real c29 = k1*w_x;
        const stewart_real c30 = c29*gamma_n;
        const stewart_real c31 = k3*w_z;
        const stewart_real c32 = c31*gamma_n;
        const stewart_real c33 = J_xy*c17;
        const stewart_real c34 = W_z*c33;
        const stewart_real c35 = REAL(2)*L;
        const stewart_real c36 = h_x*own_y;
        const stewart_real c37 = L_dot*c17;
        const stewart_real c38 = k1*w_z;
        const stewart_real c39 = c38*g_k;
        const stewart_real c40 = inv_k3*own_z;
        const stewart_real c41 = J_xy*k1;
        const stewart_real c42 = c40*c41;
        const stewart_real c43 = J_xz*c12;
        const stewart_real c44 = REAL(2)*c43;
        const stewart_real c45 = W_z*c17*c6;
        const stewart_real c46 = J_yz*k1;
        const stewart_real c47 = c18*c46;
        const stewart_real c48 = c6*k1;
        const stewart_real c49 = inv_k3*inv_k3;
        const stewart_real c50 = c43*c49;
        const stewart_real c51 = c12*inv_k3;
        const stewart_real c53 = J_xx - J_zz;
        const stewart_real c54 = J_yy + c53;
        const stewart_real c55 = c54*k1;
        const stewart_real tau_theta = STEWART_FMA(-c40, c48, STEWART_FMA(-c34, c49, STEWART_FMA(c45, c49,
            STEWART_FMA(c35, c36, STEWART_FMA(c37, h_x, STEWART_FMA(c51, c55, STEWART_FMA(-c19, c35,
            STEWART_FMA(L*c19, c49, c44 - c50) + c28)) + c25 - c39 + c22 + c30 + c32 + c34) - c26 + c23))) - c45
            + c24 - c47 + c42);
        const stewart_real c56 = C_s*w_k_omega;
        const stewart_real c57 = gamma_n*w_y;
        const stewart_real c58 = c41*own_y;
        const stewart_real c59 = c38*gamma_y;
        const stewart_real c60 = REAL(2)*own_z;
        const stewart_real c61 = J_xz*k1;
        const stewart_real c62 = J_xy*c12;
        const stewart_real c63 = c62*inv_k3;
        const stewart_real c64 = c12*c46;
        const stewart_real c65 = c3*c46;
        const stewart_real c66 = J_xz*c17;
        const stewart_real c67 = k3*own_z;
        const stewart_real c68 = h_z*k1;
        const stewart_real c69 = REAL(2)*h_x;
        const stewart_real c70 = REAL(2)*W_z;
        const stewart_real c71 = J_xy*c3;
        const stewart_real c72 = c6*k3;
        const stewart_real c73 = c16*theta_dot;
        const stewart_real c75 = REAL(2)*J_xx;
        const stewart_real c76 = c49*c75;
        const stewart_real c77 = W_z*theta_dot;
        const stewart_real tau_phi = STEWART_FMA(-c53, c67, STEWART_FMA(c35*c68, -own_z,
            STEWART_FMA(c35*c67, h_x, STEWART_FMA(c60, c61, STEWART_FMA(J_xx, c40, STEWART_FMA(c76*c77, -k1,
            STEWART_FMA(L_dot*c68, -c70, STEWART_FMA(c35*c73, h_z, STEWART_FMA(-c48, own_y,
            STEWART_FMA(-c16, c66, STEWART_FMA(L_dot*W_z*c69, k3, STEWART_FMA(-c15, c37, STEWART_FMA(c7,
            own_y, STEWART_FMA(C_us, c16, STEWART_FMA(-c27, gamma_y, STEWART_FMA(-L_ddot, c8,
            STEWART_FMA(-c51, c6, STEWART_FMA(-c71, k3, STEWART_FMA(-c62, k3, STEWART_FMA(c3, c72,
            STEWART_FMA(c12, c72, c63 - c56))))) + c64 + c65) + c59) - c57) + c58)))))))))))));
        const stewart_real c78 = inv_rho*tau_phi;
        const stewart_real c79 = inv_L*tau_theta;
        const stewart_real c80 = tau_L - F;
        /* force at the tip, less the actuator's */
        const stewart_real R_tip_x = STEWART_FMA(c78, y_x, STEWART_FMA(-c79, z_x, c80*s_x));
        const stewart_real R_tip_y = STEWART_FMA(c78, y_y, STEWART_FMA(-c79, z_y, c80*s_y));
        const stewart_real R_tip_z = STEWART_FMA(c78, y_z, STEWART_FMA(-c79, z_z, c80*s_z));
        const stewart_real c81 = inv_L*theta_dot;
        const stewart_real G_dot_21 = -c81;
        const stewart_real c82 = k1*phi_dot;
        const stewart_real G_dot_22 = c82*inv_L;
        const stewart_real c83 = L_dot*c10;
        const stewart_real G_dot_23 = c83;
        const stewart_real G_dot_31 = -inv_rho*k3*phi_dot;
        const stewart_real G_dot_32 = STEWART_FMA(inv_rho*kappa, -theta_dot, -c2*inv_rho);
        const stewart_real G_dot_33 = c82*inv_rho;
        /* slope of a rate, times C_s */
        const stewart_real theta_dot_by_S_x = C_s*STEWART_FMA(G_dot_22, y_x, STEWART_FMA(G_dot_21, s_x,
            G_dot_23*z_x));
        const stewart_real theta_dot_by_S_y = C_s*STEWART_FMA(G_dot_22, y_y, STEWART_FMA(G_dot_21, s_y,
            G_dot_23*z_y));
        const stewart_real theta_dot_by_S_z = C_s*STEWART_FMA(G_dot_22, y_z, STEWART_FMA(G_dot_21, s_z,
            G_dot_23*z_z));
        const stewart_real phi_dot_by_S_x = C_s*STEWART_FMA(G_dot_31, s_x, STEWART_FMA(G_dot_33, z_x,
            G_dot_32*y_x));
        const stewart_real phi_dot_by_S_y = C_s*STEWART_FMA(G_dot_31, s_y, STEWART_FMA(G_dot_33, z_y,
            G_dot_32*y_y));
        const stewart_real phi_dot_by_S_z = C_s*STEWART_FMA(G_dot_31, s_z, STEWART_FMA(G_dot_33, z_z,
            G_dot_32*y_z));
        const stewart_real c84 = C_s*inv_L;
        /* gradient of theta, times C_s */
        const stewart_real C_s_theta_x = -c84*z_x;
        const stewart_real C_s_theta_y = -c84*z_y;
        const stewart_real C_s_theta_z = -c84*z_z;
        const stewart_real c85 = C_s*inv_rho;
        /* gradient of phi, times C_s */
        const stewart_real C_s_phi_x = c85*y_x;
        const stewart_real C_s_phi_y = c85*y_y;
        const stewart_real C_s_phi_z = c85*y_z;
        const stewart_real y_by_phi_x = normal_x*theta_dot;
        const stewart_real y_by_phi_y = normal_y*theta_dot;
        const stewart_real y_by_phi_z = normal_z*theta_dot;
        /* friction moment by S */
        const stewart_real f_S_xx = STEWART_FMA(k_x, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_x,
            C_s_phi_x*y_by_phi_x));
        const stewart_real f_S_xy = STEWART_FMA(k_x, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_x,
            C_s_phi_y*y_by_phi_x));
        const stewart_real f_S_xz = STEWART_FMA(k_x, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_x,
            C_s_phi_z*y_by_phi_x));
        const stewart_real f_S_yx = STEWART_FMA(k_y, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_y,
            C_s_phi_x*y_by_phi_y));
        const stewart_real f_S_yy = STEWART_FMA(k_y, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_y,
            C_s_phi_y*y_by_phi_y));
        const stewart_real f_S_yz = STEWART_FMA(k_y, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_y,
            C_s_phi_z*y_by_phi_y));
        const stewart_real f_S_zx = STEWART_FMA(k_z, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_z,
            C_s_phi_x*y_by_phi_z));
        const stewart_real f_S_zy = STEWART_FMA(k_z, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_z,
            C_s_phi_y*y_by_phi_z));
        const stewart_real f_S_zz = STEWART_FMA(k_z, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_z,
            C_s_phi_z*y_by_phi_z));
        /* friction moment by S_dot */
        const stewart_real f_S_dot_xx = STEWART_FMA(C_s_phi_x, k_x, C_s_theta_x*y_x);
        const stewart_real f_S_dot_xy = STEWART_FMA(C_s_phi_y, k_x, C_s_theta_y*y_x);
        const stewart_real f_S_dot_xz = STEWART_FMA(C_s_phi_z, k_x, C_s_theta_z*y_x);
        const stewart_real f_S_dot_yx = STEWART_FMA(C_s_phi_x, k_y, C_s_theta_x*y_y);
        const stewart_real f_S_dot_yy = STEWART_FMA(C_s_phi_y, k_y, C_s_theta_y*y_y);
        const stewart_real f_S_dot_yz = STEWART_FMA(C_s_phi_z, k_y, C_s_theta_z*y_y);
        const stewart_real f_S_dot_zx = STEWART_FMA(C_s_phi_x, k_z, C_s_theta_x*y_z);
        const stewart_real f_S_dot_zy = STEWART_FMA(C_s_phi_y, k_z, C_s_theta_y*y_z);
        const stewart_real f_S_dot_zz = STEWART_FMA(C_s_phi_z, k_z, C_s_theta_z*y_z);
        const stewart_real c86 = c9*own_y;
        const stewart_real c87 = c83*h_z;
        const stewart_real c88 = -c17*c87;
        const stewart_real c89 = c9*k1;
        const stewart_real c90 = c51*c89;
        const stewart_real c91 = c11*inv_L;
        const stewart_real c92 = REAL(2)*h_y;
        const stewart_real c93 = c83*c92;
        const stewart_real c94 = W_z*c93;
        const stewart_real c95 = STEWART_FMA(REAL(4)*c15*c16, c81, c94) - c91;
        const stewart_real A_0_leg_11 = STEWART_FMA(REAL(4), -c90, STEWART_FMA(REAL(2)*c3*h_x, inv_L,
            REAL(2)*c12*h_x*inv_L)) - c88 - c86 - c95;
        const stewart_real c96 = h_x*inv_L;
        const stewart_real c97 = c60*c96;
        const stewart_real c98 = J_yz*c10;
        const stewart_real c99 = c98*own_y;
        const stewart_real c100 = h_y*inv_L;
        const stewart_real c101 = c100*c12;
        const stewart_real c102 = REAL(2)*c101;
        const stewart_real c103 = c10*inv_k3;
        const stewart_real c104 = c103*c58;
        const stewart_real c105 = c103*c59;
        const stewart_real c106 = inv_L*inv_L*inv_L;
        const stewart_real c107 = L_dot*L_dot;
        const stewart_real c108 = c106*c107;
        const stewart_real c109 = c108*c92;
        const stewart_real c110 = C_us*c10;
        const stewart_real c111 = W_z*c110*c49;
        const stewart_real c112 = c10*own_z;
        const stewart_real c113 = J_xx*c49;
        const stewart_real c114 = REAL(2)*c40;
        const stewart_real c115 = c10*c61;
        const stewart_real c116 = c49*c9;
        const stewart_real c117 = c100*c3;
        const stewart_real c118 = REAL(2)*c49;
        const stewart_real c119 = c103*c64;
        const stewart_real c120 = c103*c65;
        const stewart_real c121 = REAL(2)*c87;
        const stewart_real c122 = c16*k1;
        const stewart_real c123 = c10*c62;
        const stewart_real c124 = c123*c49;
        const stewart_real c125 = inv_k3*inv_k3*inv_k3;
        const stewart_real A_0_leg_12 = STEWART_FMA(REAL(3)*h_z*inv_L*inv_k3*k1, own_z, STEWART_FMA(-c114,
            c115, STEWART_FMA(-c112, c113, STEWART_FMA(REAL(2)*h_y*inv_L*inv_k3*k1, own_y,
            STEWART_FMA(REAL(2)*J_xx*W_z*c10*c125*k1, theta_dot, STEWART_FMA(c10*c53, own_z,
            STEWART_FMA(REAL(2)*J_xz*W_z*c10*c49, theta_dot, STEWART_FMA(-c121, c122,
            STEWART_FMA(REAL(2)*W_z*h_z*inv_L, theta_dot, STEWART_FMA(REAL(6)*c116, -c77,
            STEWART_FMA(c10*gamma_n*inv_k3, w_y, STEWART_FMA(c10*gamma_y, w_x, STEWART_FMA(C_p, W_z,
            STEWART_FMA(REAL(2)*L_ddot*c10, h_y, STEWART_FMA(C_s*c10*inv_k3, w_k_omega, STEWART_FMA(-c117,
            c118, STEWART_FMA(REAL(3)*c12*c49*h_y, inv_L, STEWART_FMA(J_xy*c10, c3, J_xy*c10*c12) - c109 - c124)
            - c102)) - c119 - c120)))) - c105 - c111) - c99) - c104)))))) - c97));
        const stewart_real c126 = c10*c22;
        const stewart_real c127 = c10*c23;
        const stewart_real c128 = c10*c24;
        const stewart_real c129 = REAL(2)*c108;
        const stewart_real c130 = c129*h_z;
        const stewart_real c131 = c10*c44;
        const stewart_real c132 = c10*c25;
        const stewart_real c133 = c10*c50;
        const stewart_real c134 = W_z*c10;
        const stewart_real c135 = c134*c33;
        const stewart_real c136 = c12*c9;
        const stewart_real c137 = REAL(3)*c136;
        const stewart_real c138 = c10*c42;
        const stewart_real c139 = c10*c12;
        const stewart_real c140 = c3*c9;
        const stewart_real c141 = c10*c26;
        const stewart_real c142 = REAL(4)*W_z;
        const stewart_real c143 = c142*c81;
        const stewart_real c144 = c143*h_y;
        const stewart_real c145 = STEWART_FMA(-c20, c91, STEWART_FMA(REAL(2)*c36, inv_L, STEWART_FMA(c144,
            c49, STEWART_FMA(c122, c93, STEWART_FMA(c10, c32, STEWART_FMA(c10, c30, STEWART_FMA(-c10, c39,
            STEWART_FMA(c10, c28, c140 - c137)))) - c141))) - c144);
        const stewart_real A_0_leg_13 = STEWART_FMA(-c10, c47, STEWART_FMA(-c135, c49, STEWART_FMA(-C_p,
            theta_dot, STEWART_FMA(REAL(2), c132, STEWART_FMA(c139*c55, inv_k3, STEWART_FMA(c137, c49, c131
            - c130 - c133))) + c126) + c135 + c127) + c128) + c138 + c145;
        const stewart_real c146 = L_ddot*c10;
        const stewart_real c147 = c146*h_y;
        const stewart_real c148 = c10*gamma_y;
        const stewart_real c149 = c100*own_y;
        const stewart_real c150 = L_dot*c106;
        const stewart_real c151 = c150*c17;
        const stewart_real c152 = REAL(3)*c123;
        const stewart_real c153 = REAL(4)*c115;
        const stewart_real c154 = c142*theta_dot;
        const stewart_real c155 = c41*inv_k3;
        const stewart_real c156 = REAL(4)*c61;
        const stewart_real c157 = c150*c16;
        const stewart_real c158 = c17*c83*h_y;
        const stewart_real c159 = W_z*c150;
        const stewart_real c160 = c134*theta_dot;
        const stewart_real c161 = REAL(6)*c160;
        const stewart_real c162 = -REAL(2)*J_zz;
        const stewart_real c163 = c162 + c75;
        const stewart_real c164 = c125*k1;
        const stewart_real c165 = J_xx*c164;
        const stewart_real A_0_leg_21 = STEWART_FMA(-c153, c40, STEWART_FMA(-c112, c76, STEWART_FMA(c114,
            c89, STEWART_FMA(c112, c163, STEWART_FMA(J_xz*c161, c49, STEWART_FMA(-c116, c154,
            STEWART_FMA(REAL(2), -c104, STEWART_FMA(c161, c165, STEWART_FMA(REAL(2), -c99,
            STEWART_FMA(-c159, c163, STEWART_FMA(REAL(2), -c111, STEWART_FMA(c156, c157, STEWART_FMA(c149,
            c20, STEWART_FMA(c159, c76, STEWART_FMA(c158, c20, STEWART_FMA(c151, c155, STEWART_FMA(c148,
            w_x, STEWART_FMA(c103, c57, STEWART_FMA(J_yz, c151, STEWART_FMA(REAL(3), -c120,
            STEWART_FMA(REAL(3), -c119, STEWART_FMA(c103, c56, STEWART_FMA(c102, c49, STEWART_FMA(REAL(3),
            -c124, STEWART_FMA(REAL(3)*c10, c71, c152)) - c101 - c117)) + c147)))))))) - c105))))))))))))) - c97;
        const stewart_real c167 = L_ddot*c106;
        const stewart_real c168 = c14*inv_L;
        const stewart_real c169 = c107*inv_L*inv_L*inv_L*inv_L;
        const stewart_real c170 = c10*c3;
        const stewart_real c171 = J_yy*c139;
        const stewart_real c172 = c13*inv_L;
        const stewart_real c173 = REAL(2)*J_xy;
        const stewart_real c174 = c112*c173;
        const stewart_real c175 = c10*own_y;
        const stewart_real c176 = REAL(2)*J_xz;
        const stewart_real c177 = c175*c176;
        const stewart_real c178 = c148*c49;
        const stewart_real c179 = c139*c49;
        const stewart_real c180 = C_us*c150;
        const stewart_real c181 = inv_k3*inv_k3*inv_k3*inv_k3;
        const stewart_real c182 = c181*c75;
        const stewart_real c183 = c49*c91;
        const stewart_real c184 = c159*c173;
        const stewart_real c185 = REAL(2)*c86;
        const stewart_real c186 = c10*gamma_n;
        const stewart_real c187 = c186*c38;
        const stewart_real c188 = c103*own_y;
        const stewart_real c189 = c10*c43;
        const stewart_real c190 = c184*c49;
        const stewart_real c191 = REAL(2)*c61;
        const stewart_real c192 = c191*inv_k3;
        const stewart_real c193 = c17*c98;
        const stewart_real c194 = W_z*c193;
        const stewart_real c195 = c194*c49;
        const stewart_real c196 = REAL(2)*c164;
        const stewart_real c197 = c49*c66;
        const stewart_real c198 = c125*c170;
        const stewart_real c199 = REAL(2)*c128;
        const stewart_real c200 = c156*inv_k3;
        const stewart_real c201 = c125*c160;
        const stewart_real c202 = REAL(4)*c201*c41;
        const stewart_real c203 = REAL(2)*c46;
        const stewart_real c204 = c157*c203;
        const stewart_real c205 = c164*c75;
        const stewart_real c206 = c205*theta_dot;
        const stewart_real c207 = c125*c143*c15;
        const stewart_real c208 = c10*g_k;
        const stewart_real c209 = STEWART_FMA(-c186, c27, STEWART_FMA(-c146, c69, STEWART_FMA(C_p, c2,
            STEWART_FMA(c208, c29, STEWART_FMA(c208, c31, STEWART_FMA(-F, inv_L, c129*h_x))))) + c187);
        const stewart_real A_0_leg_22 = STEWART_FMA(REAL(2), -c183, STEWART_FMA(c199, c20, STEWART_FMA(c174,
            c49, STEWART_FMA(-c177, c49, STEWART_FMA(-c165, c175, STEWART_FMA(c185, c49, STEWART_FMA(-c141,
            c20, STEWART_FMA(c188, c55, STEWART_FMA(-c126, c164, STEWART_FMA(c187, c49, STEWART_FMA(c178,
            w_y, STEWART_FMA(c150, c197, STEWART_FMA(c126, c20, STEWART_FMA(c150, c206, STEWART_FMA(-c180,
            c49, STEWART_FMA(REAL(3)*c132, c20, STEWART_FMA(-c167, c192, STEWART_FMA(-c113, c167,
            STEWART_FMA(-c140, c21, STEWART_FMA(-c140, c196, STEWART_FMA(c170, c192, STEWART_FMA(c169, c200,
            STEWART_FMA(c167, c53, STEWART_FMA(REAL(3)*c164, -c189, STEWART_FMA(-c130, c20,
            STEWART_FMA(c191, c198, STEWART_FMA(c137, c164, STEWART_FMA(c103*g_k, -w_z, STEWART_FMA(-c163,
            c169, STEWART_FMA(-c170, c53, STEWART_FMA(-c139, c182, STEWART_FMA(-c113, c170,
            STEWART_FMA(c179, J_yy + c75 - J_zz, STEWART_FMA(c170, c182, c169*c76))))) - c171 + c168) - c172))))))))))))))))
            + c88)) + c184)) + c177) + c209) - c195 - c86) + c207) - c190 - c204)) - c174 - c202));
        const stewart_real c210 = c3*c98;
        const stewart_real c211 = c12*c98;
        const stewart_real c212 = J_xy*c49;
        const stewart_real c213 = c211*c49;
        const stewart_real c214 = c210*c49;
        const stewart_real c215 = c149*c49;
        const stewart_real c216 = c150*c33;
        const stewart_real c217 = c10*k1;
        const stewart_real c218 = c217*c63;
        const stewart_real c219 = c110*c164;
        const stewart_real c220 = c17*c9;
        const stewart_real c221 = c151*c46*inv_k3;
        const stewart_real c222 = REAL(2)*J_yz;
        const stewart_real c223 = c9*own_z;
        const stewart_real c224 = c112*c176;
        const stewart_real c225 = c69*c81;
        const stewart_real c226 = c217*c49;
        const stewart_real c227 = REAL(2)*c155;
        const stewart_real c228 = c176*c49;
        const stewart_real c229 = STEWART_FMA(-c118, c223, STEWART_FMA(c224, c49, STEWART_FMA(-c156, c201,
            STEWART_FMA(-c160, c163, STEWART_FMA(c154*c164, c9, STEWART_FMA(-c159, c228, STEWART_FMA(c153,
            c73, STEWART_FMA(-c226, c57, STEWART_FMA(c178, w_z, STEWART_FMA(W_z, c225, STEWART_FMA(-c169,
            c227, STEWART_FMA(-c226, c56, STEWART_FMA(c155, c167, STEWART_FMA(-c169, c222,
            J_yz*c167))))))))))))));
        const stewart_real A_0_leg_23 = STEWART_FMA(J_xx*c161, -c181, STEWART_FMA(c112, c205,
            STEWART_FMA(-c122, c220, STEWART_FMA(c113, c161, STEWART_FMA(-c159, c205, STEWART_FMA(-c158,
            c49, STEWART_FMA(c175, c212, STEWART_FMA(c219, c70, STEWART_FMA(-c147, c20, STEWART_FMA(-c102,
            c164, STEWART_FMA(c155, c170, STEWART_FMA(c123, c196, STEWART_FMA(c117, c20, STEWART_FMA(c101,
            c20, c210 + c213 + c214 - c211))))) - c218) + c158 + c149) + c221 - c216))))) - c215)) + c229;
        const stewart_real c230 = REAL(2)*J_yy;
        const stewart_real c231 = c230*theta_dot;
        const stewart_real c232 = REAL(2)*c41;
        const stewart_real A_0_leg_31 = STEWART_FMA(REAL(2), c138, STEWART_FMA(-c161, c212,
            STEWART_FMA(REAL(6)*c10*c46, -c73, STEWART_FMA(-c157, c232, STEWART_FMA(REAL(2), c127,
            STEWART_FMA(J_xy, c161, STEWART_FMA(-c159, c222, STEWART_FMA(-c150, c231, STEWART_FMA(REAL(2),
            c126, STEWART_FMA(c139*c20, REAL(3)*(J_xx + J_yy - J_zz), STEWART_FMA(c118, c136,
            STEWART_FMA(REAL(3), -c133, REAL(6)*c189))) + c132)))))))) + c199) + c145;
        const stewart_real c233 = c173*c175;
        const stewart_real c234 = REAL(4)*J_xz;
        const stewart_real c236 = c230 + c163;
        const stewart_real c237 = REAL(4)*c122*c9;
        const stewart_real A_0_leg_32 = STEWART_FMA(c217*c40, -c54, STEWART_FMA(-c237, theta_dot,
            STEWART_FMA(c112, c165, STEWART_FMA(REAL(2), -c215, STEWART_FMA(-c160, c182, STEWART_FMA(-c110,
            c122, STEWART_FMA(c233, c49, STEWART_FMA(c160*c49, STEWART_FMA(REAL(4), J_xx, c162) + c230,
            STEWART_FMA(c122*c150, c236, STEWART_FMA(C_s*c103, w_n_omega, STEWART_FMA(-c70, c87,
            STEWART_FMA(-c216, c49, STEWART_FMA(c188, c203, STEWART_FMA(REAL(2), c149, STEWART_FMA(c159,
            c234, STEWART_FMA(W_z, c219, STEWART_FMA(REAL(2)*c147, -c20, STEWART_FMA(-c198, c232,
            STEWART_FMA(REAL(2), -c218, STEWART_FMA(REAL(3)*c101, -c164, STEWART_FMA(c117, c196,
            STEWART_FMA(c152, c164, STEWART_FMA(c109, c20, STEWART_FMA(c102, c20, STEWART_FMA(REAL(2),
            -c211, REAL(3)*c213) - c214))))))))) + c216)))) - c221)))) + c223)))) - c233) - c224)) + c229;
        const stewart_real A_0_leg_33 = STEWART_FMA(-c112, c212, STEWART_FMA(c10*c18, -c41,
            STEWART_FMA(-c49, c94, STEWART_FMA(-J_yy, c167, STEWART_FMA(-c136, c196, STEWART_FMA(REAL(2),
            c90, STEWART_FMA(c131, c164, STEWART_FMA(-c179, c54, STEWART_FMA(-J_yy, c170, STEWART_FMA(c169,
            c230, c171)) + c172) - c168)))) - c180 + c195 - c194 + c185 + c190 + c204 + c209 - c184) + c202)
            - c207 + c183) + c95;
        const stewart_real A_0_T_xs = STEWART_FMA(A_0_leg_21, y_x, STEWART_FMA(A_0_leg_31, z_x,
            A_0_leg_11*s_x));
        const stewart_real A_0_T_xy = STEWART_FMA(A_0_leg_22, y_x, STEWART_FMA(A_0_leg_32, z_x,
            A_0_leg_12*s_x));
        const stewart_real A_0_T_xz = STEWART_FMA(A_0_leg_33, z_x, STEWART_FMA(A_0_leg_23, y_x,
            A_0_leg_13*s_x));
        const stewart_real A_0_T_ys = STEWART_FMA(A_0_leg_21, y_y, STEWART_FMA(A_0_leg_31, z_y,
            A_0_leg_11*s_y));
        const stewart_real A_0_T_yy = STEWART_FMA(A_0_leg_22, y_y, STEWART_FMA(A_0_leg_32, z_y,
            A_0_leg_12*s_y));
        const stewart_real A_0_T_yz = STEWART_FMA(A_0_leg_33, z_y, STEWART_FMA(A_0_leg_23, y_y,
            A_0_leg_13*s_y));
        const stewart_real A_0_T_zs = STEWART_FMA(A_0_leg_21, y_z, STEWART_FMA(A_0_leg_31, z_z,
            A_0_leg_11*s_z));
        const stewart_real A_0_T_zy = STEWART_FMA(A_0_leg_22, y_z, STEWART_FMA(A_0_leg_32, z_z,
            A_0_leg_12*s_z));
        const stewart_real A_0_T_zz = STEWART_FMA(A_0_leg_33, z_z, STEWART_FMA(A_0_leg_23, y_z,
            A_0_leg_13*s_z));
        /* force at the tip by S */
        const stewart_real A_0_xx = STEWART_FMA(A_0_T_xy, y_x, STEWART_FMA(A_0_T_xs, s_x, A_0_T_xz*z_x));
        const stewart_real A_0_xy = STEWART_FMA(A_0_T_xy, y_y, STEWART_FMA(A_0_T_xs, s_y, A_0_T_xz*z_y));
        const stewart_real A_0_xz = STEWART_FMA(A_0_T_xy, y_z, STEWART_FMA(A_0_T_xs, s_z, A_0_T_xz*z_z));
        const stewart_real A_0_yx = STEWART_FMA(A_0_T_yy, y_x, STEWART_FMA(A_0_T_ys, s_x, A_0_T_yz*z_x));
        const stewart_real A_0_yy = STEWART_FMA(A_0_T_yy, y_y, STEWART_FMA(A_0_T_ys, s_y, A_0_T_yz*z_y));
        const stewart_real A_0_yz = STEWART_FMA(A_0_T_yy, y_z, STEWART_FMA(A_0_T_ys, s_z, A_0_T_yz*z_z));
        const stewart_real A_0_zx = STEWART_FMA(A_0_T_zy, y_x, STEWART_FMA(A_0_T_zs, s_x, A_0_T_zz*z_x));
        const stewart_real A_0_zy = STEWART_FMA(A_0_T_zy, y_y, STEWART_FMA(A_0_T_zs, s_y, A_0_T_zz*z_y));
        const stewart_real A_0_zz = STEWART_FMA(A_0_T_zy, y_z, STEWART_FMA(A_0_T_zs, s_z, A_0_T_zz*z_z));
        const stewart_real c238 = c100*c70;
        const stewart_real c239 = c238 - c220;
        const stewart_real A_1_leg_11 = C_p + c239;
        const stewart_real c240 = c70*c96;
        const stewart_real c241 = c81*c92;
        const stewart_real A_1_leg_12 = STEWART_FMA(c20, c241, c93) - c240 + c237;
        const stewart_real c242 = STEWART_FMA(REAL(2)*c100, -c122, c225);
        const stewart_real A_1_leg_13 = c121 + c242;
        const stewart_real c243 = c103*c17;
        const stewart_real A_1_leg_21 = STEWART_FMA(REAL(2)*W_z*h_z*inv_L*inv_k3, k1, STEWART_FMA(-c153,
            c16, STEWART_FMA(-c134, c76, STEWART_FMA(-c243, c41, STEWART_FMA(W_z*c10, c163, -c193)))) - c240);
        const stewart_real c244 = c134*c173;
        const stewart_real c245 = c69*c83;
        const stewart_real c246 = c238*c49;
        const stewart_real c247 = c10*c16;
        const stewart_real c248 = c203*c247;
        const stewart_real c249 = c244*c49;
        const stewart_real A_1_leg_22 = STEWART_FMA(-c10, c197, STEWART_FMA(REAL(2)*c49*h_z*inv_L,
            theta_dot, STEWART_FMA(-c10, c206, STEWART_FMA(REAL(2)*L_dot*c10*h_z*inv_k3, k1,
            STEWART_FMA(-c150, c76, STEWART_FMA(-c150, c200, STEWART_FMA(L_dot*c106, c163, C_us*c10*c49))) - c245)))
            + c248 + c249) - c244 - c246;
        const stewart_real c250 = c10*c33;
        const stewart_real c251 = c243*c46;
        const stewart_real c252 = c70*c9;
        const stewart_real c253 = STEWART_FMA(-c252, c49, STEWART_FMA(c134, c228, STEWART_FMA(c150, c227,
            c150*c222)));
        const stewart_real A_1_leg_23 = STEWART_FMA(c134, c205, c250) - c251 + c253;
        const stewart_real A_1_leg_31 = STEWART_FMA(c232, c247, STEWART_FMA(c70, c98, c10*c231)) + c242;
        const stewart_real A_1_leg_32 = STEWART_FMA(c16*c217, -c236, STEWART_FMA(-c134, c234,
            STEWART_FMA(-c241, c49, STEWART_FMA(c250, c49, STEWART_FMA(-c20, c93, c241) + c251) + c252) - c250))
            + c253;
        const stewart_real A_1_leg_33 = STEWART_FMA(-c150, c230, C_us*c10) - c245 + c244 + c246 - c239 - c248
            - c249;
        const stewart_real A_1_T_xs = STEWART_FMA(A_1_leg_21, y_x, STEWART_FMA(A_1_leg_31, z_x,
            A_1_leg_11*s_x));
        const stewart_real A_1_T_xy = STEWART_FMA(A_1_leg_32, z_x, STEWART_FMA(A_1_leg_22, y_x,
            A_1_leg_12*s_x));
        const stewart_real A_1_T_xz = STEWART_FMA(A_1_leg_33, z_x, STEWART_FMA(A_1_leg_23, y_x,
            A_1_leg_13*s_x));
        const stewart_real A_1_T_ys = STEWART_FMA(A_1_leg_21, y_y, STEWART_FMA(A_1_leg_31, z_y,
            A_1_leg_11*s_y));
        const stewart_real A_1_T_yy = STEWART_FMA(A_1_leg_32, z_y, STEWART_FMA(A_1_leg_22, y_y,
            A_1_leg_12*s_y));
        const stewart_real A_1_T_yz = STEWART_FMA(A_1_leg_33, z_y, STEWART_FMA(A_1_leg_23, y_y,
            A_1_leg_13*s_y));
        const stewart_real A_1_T_zs = STEWART_FMA(A_1_leg_21, y_z, STEWART_FMA(A_1_leg_31, z_z,
            A_1_leg_11*s_z));
        const stewart_real A_1_T_zy = STEWART_FMA(A_1_leg_32, z_z, STEWART_FMA(A_1_leg_22, y_z,
            A_1_leg_12*s_z));
        const stewart_real A_1_T_zz = STEWART_FMA(A_1_leg_33, z_z, STEWART_FMA(A_1_leg_23, y_z,
            A_1_leg_13*s_z));
        /* force at the tip by S_dot */
        const stewart_real A_1_xx = STEWART_FMA(A_1_T_xy, y_x, STEWART_FMA(A_1_T_xz, z_x, A_1_T_xs*s_x));
        const stewart_real A_1_xy = STEWART_FMA(A_1_T_xy, y_y, STEWART_FMA(A_1_T_xz, z_y, A_1_T_xs*s_y));
        const stewart_real A_1_xz = STEWART_FMA(A_1_T_xy, y_z, STEWART_FMA(A_1_T_xz, z_z, A_1_T_xs*s_z));
        const stewart_real A_1_yx = STEWART_FMA(A_1_T_yy, y_x, STEWART_FMA(A_1_T_yz, z_x, A_1_T_ys*s_x));
        const stewart_real A_1_yy = STEWART_FMA(A_1_T_yy, y_y, STEWART_FMA(A_1_T_yz, z_y, A_1_T_ys*s_y));
        const stewart_real A_1_yz = STEWART_FMA(A_1_T_yy, y_z, STEWART_FMA(A_1_T_yz, z_z, A_1_T_ys*s_z));
        const stewart_real A_1_zx = STEWART_FMA(A_1_T_zy, y_x, STEWART_FMA(A_1_T_zz, z_x, A_1_T_zs*s_x));
        const stewart_real A_1_zy = STEWART_FMA(A_1_T_zy, y_y, STEWART_FMA(A_1_T_zz, z_y, A_1_T_zs*s_y));
        const stewart_real A_1_zz = STEWART_FMA(A_1_T_zy, y_z, STEWART_FMA(A_1_T_zz, z_z, A_1_T_zs*s_z));
        /* derivative of the force by rotation about the tip */
        const stewart_real X_xx = STEWART_FMA(-A_1_xz, omega_y, STEWART_FMA(A_1_xy, omega_z,
            STEWART_FMA(B_zx, m_xz, STEWART_FMA(B_yx, m_xy, B_xx*m_xx)))) + A_0_xx;
        const stewart_real X_xy = STEWART_FMA(-A_1_xx, omega_z, STEWART_FMA(A_1_xz, omega_x,
            STEWART_FMA(B_zy, m_xz, STEWART_FMA(B_yy, m_xy, B_xy*m_xx)))) + A_0_xy;
        const stewart_real X_xz = STEWART_FMA(-A_1_xy, omega_x, STEWART_FMA(A_1_xx, omega_y,
            STEWART_FMA(B_zz, m_xz, STEWART_FMA(B_yz, m_xy, B_xz*m_xx)))) + A_0_xz;
        const stewart_real X_yx = STEWART_FMA(-A_1_yz, omega_y, STEWART_FMA(A_1_yy, omega_z,
            STEWART_FMA(B_zx, m_yz, STEWART_FMA(B_yx, m_yy, B_xx*m_xy)))) + A_0_yx;
        const stewart_real X_yy = STEWART_FMA(-A_1_yx, omega_z, STEWART_FMA(A_1_yz, omega_x,
            STEWART_FMA(B_zy, m_yz, STEWART_FMA(B_yy, m_yy, B_xy*m_xy)))) + A_0_yy;
        const stewart_real X_yz = STEWART_FMA(-A_1_yy, omega_x, STEWART_FMA(A_1_yx, omega_y,
            STEWART_FMA(B_zz, m_yz, STEWART_FMA(B_yz, m_yy, B_xz*m_xy)))) + A_0_yz;
        const stewart_real X_zx = STEWART_FMA(-A_1_zz, omega_y, STEWART_FMA(A_1_zy, omega_z,
            STEWART_FMA(B_zx, m_zz, STEWART_FMA(B_yx, m_yz, B_xx*m_xz)))) + A_0_zx;
        const stewart_real X_zy = STEWART_FMA(-A_1_zx, omega_z, STEWART_FMA(A_1_zz, omega_x,
            STEWART_FMA(B_zy, m_zz, STEWART_FMA(B_yy, m_yz, B_xy*m_xz)))) + A_0_zy;
        const stewart_real X_zz = STEWART_FMA(-A_1_zy, omega_x, STEWART_FMA(A_1_zx, omega_y,
            STEWART_FMA(B_zz, m_zz, STEWART_FMA(B_yz, m_yz, B_xz*m_xz)))) + A_0_zz;
        const stewart_real c254 = m_xy*omega_z;
        const stewart_real c255 = m_xz*omega_y;
        const stewart_real Y_xx = c254 - c255 + A_1_xx;
        const stewart_real Y_xy = STEWART_FMA(-m_xx, omega_z, m_xz*omega_x) + A_1_xy;
        const stewart_real Y_xz = STEWART_FMA(-m_xy, omega_x, m_xx*omega_y) + A_1_xz;
        const stewart_real Y_yx = STEWART_FMA(-m_yz, omega_y, m_yy*omega_z) + A_1_yx;
        const stewart_real c256 = m_yz*omega_x;
        const stewart_real Y_yy = c256 - c254 + A_1_yy;
        const stewart_real Y_yz = STEWART_FMA(-m_yy, omega_x, m_xy*omega_y) + A_1_yz;
        const stewart_real Y_zx = STEWART_FMA(-m_zz, omega_y, m_yz*omega_z) + A_1_zx;
        const stewart_real Y_zy = STEWART_FMA(-m_xz, omega_z, m_zz*omega_x) + A_1_zy;
        const stewart_real Y_zz = c255 - c256 + A_1_zz;
        const stewart_real c257 = X_xy*q_z;
        const stewart_real Z_xx = STEWART_FMA(X_xz, q_y, -c257);
        const stewart_real c258 = X_xx*q_z;
        const stewart_real Z_xy = STEWART_FMA(-X_xz, q_x, c258);
        const stewart_real c259 = X_xx*q_y;
        const stewart_real Z_xz = STEWART_FMA(X_xy, q_x, -c259);
        const stewart_real c260 = X_yy*q_z;
        const stewart_real Z_yx = STEWART_FMA(X_yz, q_y, -c260);
        const stewart_real c261 = X_yx*q_z;
        const stewart_real c262 = -X_yz*q_x;
        const stewart_real Z_yy = c261 + c262;
        const stewart_real c263 = -X_yy*q_x;
        const stewart_real Z_yz = -X_yx*q_y - c263;
        const stewart_real c264 = -X_zz*q_y;
        const stewart_real Z_zx = -X_zy*q_z - c264;
        const stewart_real c265 = -X_zz*q_x;
        const stewart_real Z_zy = STEWART_FMA(X_zx, q_z, c265);
        const stewart_real c266 = X_zx*q_y;
        const stewart_real Z_zz = STEWART_FMA(X_zy, q_x, -c266);
        const stewart_real c267 = m_xy*w_q_z;
        const stewart_real c268 = m_xz*w_q_y;
        const stewart_real V_xx = STEWART_FMA(-Y_xy, q_z, STEWART_FMA(Y_xz, q_y, c268 - f_S_dot_xx - c267));
        const stewart_real V_xy = STEWART_FMA(-Y_xz, q_x, STEWART_FMA(Y_xx, q_z, STEWART_FMA(-m_xz, w_q_x,
            STEWART_FMA(m_xx, w_q_z, -f_S_dot_yx))));
        const stewart_real V_xz = STEWART_FMA(-Y_xx, q_y, STEWART_FMA(Y_xy, q_x, STEWART_FMA(-m_xx, w_q_y,
            STEWART_FMA(m_xy, w_q_x, -f_S_dot_zx))));
        const stewart_real V_yx = STEWART_FMA(-Y_yy, q_z, STEWART_FMA(Y_yz, q_y, STEWART_FMA(-m_yy, w_q_z,
            STEWART_FMA(m_yz, w_q_y, -f_S_dot_xy))));
        const stewart_real c269 = m_yz*w_q_x;
        const stewart_real V_yy = STEWART_FMA(-Y_yz, q_x, STEWART_FMA(Y_yx, q_z, c267 - f_S_dot_yy - c269));
        const stewart_real V_yz = STEWART_FMA(-Y_yx, q_y, STEWART_FMA(Y_yy, q_x, STEWART_FMA(-m_xy, w_q_y,
            STEWART_FMA(m_yy, w_q_x, -f_S_dot_zy))));
        const stewart_real V_zx = STEWART_FMA(-Y_zy, q_z, STEWART_FMA(Y_zz, q_y, STEWART_FMA(-m_yz, w_q_z,
            STEWART_FMA(m_zz, w_q_y, -f_S_dot_xz))));
        const stewart_real V_zy = STEWART_FMA(-Y_zz, q_x, STEWART_FMA(Y_zx, q_z, STEWART_FMA(-m_zz, w_q_x,
            STEWART_FMA(m_xz, w_q_z, -f_S_dot_yz))));
        const stewart_real V_zz = STEWART_FMA(-Y_zx, q_y, STEWART_FMA(Y_zy, q_x, c269 - f_S_dot_zz - c268));
        /* derivative of the moment by rotation about the tip */
        const stewart_real Q_xx = STEWART_FMA(-f_S_dot_xz, omega_y, f_S_dot_xy*omega_z) + f_S_xx + c261 - c266;
        const stewart_real Q_xy = STEWART_FMA(-X_zy, q_y, STEWART_FMA(-f_S_dot_xx, omega_z,
            f_S_dot_xz*omega_x) + f_S_xy - R_tip_z + c260);
        const stewart_real Q_xz = STEWART_FMA(X_yz, q_z, STEWART_FMA(-f_S_dot_xy, omega_x,
            f_S_dot_xx*omega_y) + f_S_xz + R_tip_y) + c264;
        const stewart_real Q_yx = STEWART_FMA(X_zx, q_x, STEWART_FMA(-f_S_dot_yz, omega_y,
            f_S_dot_yy*omega_z) + f_S_yx + R_tip_z) - c258;
        const stewart_real Q_yy = STEWART_FMA(X_zy, q_x, STEWART_FMA(-f_S_dot_yx, omega_z,
            f_S_dot_yz*omega_x) + f_S_yy) - c257;
        const stewart_real Q_yz = STEWART_FMA(-X_xz, q_z, STEWART_FMA(-f_S_dot_yy, omega_x,
            f_S_dot_yx*omega_y) + f_S_yz - R_tip_x) - c265;
        const stewart_real Q_zx = STEWART_FMA(-X_yx, q_x, STEWART_FMA(-f_S_dot_zz, omega_y,
            f_S_dot_zy*omega_z) + f_S_zx - R_tip_y + c259);
        const stewart_real Q_zy = STEWART_FMA(X_xy, q_y, STEWART_FMA(-f_S_dot_zx, omega_z,
            f_S_dot_zz*omega_x) + f_S_zy + R_tip_x) + c263;
        const stewart_real Q_zz = STEWART_FMA(X_xz, q_y, STEWART_FMA(-f_S_dot_zy, omega_x,
            f_S_dot_zx*omega_y) + f_S_zz) + c262;
        const stewart_real c270 = m_xy*q_z;
        const stewart_real c271 = m_xz*q_y;
        const stewart_real c272 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c270 - c271;
        const stewart_real m_q_xy = STEWART_FMA(-m_xx, q_z, m_xz*q_x);
        const stewart_real m_q_xz = STEWART_FMA(-m_xy, q_x, m_xx*q_y);
        const stewart_real m_q_yx = STEWART_FMA(-m_yz, q_y, m_yy*q_z);
        const stewart_real m_q_yy = -c270 - c272;
        const stewart_real m_q_yz = STEWART_FMA(-m_yy, q_x, m_xy*q_y);
        const stewart_real m_q_zx = STEWART_FMA(-m_zz, q_y, m_yz*q_z);
        const stewart_real m_q_zy = STEWART_FMA(-m_xz, q_z, m_zz*q_x);
        const stewart_real m_q_zz = c271 + c272;
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
        out->sum[15][l] = STEWART_FMA(-m_q_zx, q_y, m_q_yx*q_z);
        out->sum[16][l] = STEWART_FMA(-m_q_zy, q_y, m_q_yy*q_z);
        out->sum[17][l] = STEWART_FMA(-m_q_zz, q_y, m_q_yz*q_z);
        out->sum[18][l] = STEWART_FMA(-m_q_xy, q_z, m_q_zy*q_x);
        out->sum[19][l] = STEWART_FMA(-m_q_xz, q_z, m_q_zz*q_x);
        out->sum[20][l] = STEWART_FMA(-m_q_yz, q_x, m_q_xz*q_y);
        out->sum[21][l] = A_0_xx;
        out->sum[22][l] = A_0_xy;
        out->sum[23][l] = A_0_xz;
        out->sum[24][l] = Z_xx;
        out->sum[25][l] = Z_xy;
        out->sum[26][l] = Z_xz;
        out->sum[27][l] = A_0_yx;
        out->sum[28][l] = A_0_yy;
        out->sum[29][l] = A_0_yz;
        out->sum[30][l] = Z_yx;
        out->sum[31][l] = Z_yy;
        out->sum[32][l] = Z_yz;
        out->sum[33][l] = A_0_zx;
        out->sum[34][l] = A_0_zy;
        out->sum[35][l] = A_0_zz;
        out->sum[36][l] = Z_zx;
        out->sum[37][l] = Z_zy;
        out->sum[38][l] = Z_zz;
        out->sum[39][l] = STEWART_FMA(-A_0_yx, q_z, STEWART_FMA(A_0_zx, q_y, -f_S_xx));
        out->sum[40][l] = STEWART_FMA(-A_0_yy, q_z, STEWART_FMA(A_0_zy, q_y, -f_S_xy));
        out->sum[41][l] = STEWART_FMA(-A_0_yz, q_z, STEWART_FMA(A_0_zz, q_y, -f_S_xz));
        out->sum[42][l] = STEWART_FMA(-Q_xz, q_y, Q_xy*q_z);
        out->sum[43][l] = STEWART_FMA(-Q_xx, q_z, Q_xz*q_x);
        out->sum[44][l] = STEWART_FMA(-Q_xy, q_x, Q_xx*q_y);
        out->sum[45][l] = STEWART_FMA(-A_0_zx, q_x, STEWART_FMA(A_0_xx, q_z, -f_S_yx));
        out->sum[46][l] = STEWART_FMA(-A_0_zy, q_x, STEWART_FMA(A_0_xy, q_z, -f_S_yy));
        out->sum[47][l] = STEWART_FMA(-A_0_zz, q_x, STEWART_FMA(A_0_xz, q_z, -f_S_yz));
        out->sum[48][l] = STEWART_FMA(-Q_yz, q_y, Q_yy*q_z);
        out->sum[49][l] = STEWART_FMA(-Q_yx, q_z, Q_yz*q_x);
        out->sum[50][l] = STEWART_FMA(-Q_yy, q_x, Q_yx*q_y);
        out->sum[51][l] = STEWART_FMA(-A_0_xx, q_y, STEWART_FMA(A_0_yx, q_x, -f_S_zx));
        out->sum[52][l] = STEWART_FMA(-A_0_xy, q_y, STEWART_FMA(A_0_yy, q_x, -f_S_zy));
        out->sum[53][l] = STEWART_FMA(-A_0_xz, q_y, STEWART_FMA(A_0_yz, q_x, -f_S_zz));
        out->sum[54][l] = STEWART_FMA(-Q_zz, q_y, Q_zy*q_z);
        out->sum[55][l] = STEWART_FMA(-Q_zx, q_z, Q_zz*q_x);
        out->sum[56][l] = STEWART_FMA(-Q_zy, q_x, Q_zx*q_y);
        out->sum[57][l] = A_1_xx;
        out->sum[58][l] = A_1_xy;
        out->sum[59][l] = A_1_xz;
        out->sum[60][l] = V_xx;
        out->sum[61][l] = V_xy;
        out->sum[62][l] = V_xz;
        out->sum[63][l] = A_1_yx;
        out->sum[64][l] = A_1_yy;
        out->sum[65][l] = A_1_yz;
        out->sum[66][l] = V_yx;
        out->sum[67][l] = V_yy;
        out->sum[68][l] = V_yz;
        out->sum[69][l] = A_1_zx;
        out->sum[70][l] = A_1_zy;
        out->sum[71][l] = A_1_zz;
        out->sum[72][l] = V_zx;
        out->sum[73][l] = V_zy;
        out->sum[74][l] = V_zz;
        out->sum[75][l] = STEWART_FMA(-A_1_yx, q_z, STEWART_FMA(A_1_zx, q_y, -f_S_dot_xx));
        out->sum[76][l] = STEWART_FMA(-A_1_yy, q_z, STEWART_FMA(A_1_zy, q_y, -f_S_dot_xy));
        out->sum[77][l] = STEWART_FMA(-A_1_yz, q_z, STEWART_FMA(A_1_zz, q_y, -f_S_dot_xz));
        out->sum[78][l] = STEWART_FMA(-f_S_dot_xz, q_y, STEWART_FMA(-V_yx, q_z, STEWART_FMA(f_S_dot_xy, q_z,
            V_zx*q_y)));
        out->sum[79][l] = STEWART_FMA(-f_S_dot_xx, q_z, STEWART_FMA(-V_yy, q_z, STEWART_FMA(f_S_dot_xz, q_x,
            V_zy*q_y)));
        out->sum[80][l] = STEWART_FMA(-f_S_dot_xy, q_x, STEWART_FMA(-V_yz, q_z, STEWART_FMA(f_S_dot_xx, q_y,
            V_zz*q_y)));
        out->sum[81][l] = STEWART_FMA(-A_1_zx, q_x, STEWART_FMA(A_1_xx, q_z, -f_S_dot_yx));
        out->sum[82][l] = STEWART_FMA(-A_1_zy, q_x, STEWART_FMA(A_1_xy, q_z, -f_S_dot_yy));
        out->sum[83][l] = STEWART_FMA(-A_1_zz, q_x, STEWART_FMA(A_1_xz, q_z, -f_S_dot_yz));
        out->sum[84][l] = STEWART_FMA(-f_S_dot_yz, q_y, STEWART_FMA(-V_zx, q_x, STEWART_FMA(f_S_dot_yy, q_z,
            V_xx*q_z)));
        out->sum[85][l] = STEWART_FMA(-f_S_dot_yx, q_z, STEWART_FMA(-V_zy, q_x, STEWART_FMA(f_S_dot_yz, q_x,
            V_xy*q_z)));
        out->sum[86][l] = STEWART_FMA(-f_S_dot_yy, q_x, STEWART_FMA(-V_zz, q_x, STEWART_FMA(f_S_dot_yx, q_y,
            V_xz*q_z)));
        out->sum[87][l] = STEWART_FMA(-A_1_xx, q_y, STEWART_FMA(A_1_yx, q_x, -f_S_dot_zx));
        out->sum[88][l] = STEWART_FMA(-A_1_xy, q_y, STEWART_FMA(A_1_yy, q_x, -f_S_dot_zy));
        out->sum[89][l] = STEWART_FMA(-A_1_xz, q_y, STEWART_FMA(A_1_yz, q_x, -f_S_dot_zz));
        out->sum[90][l] = STEWART_FMA(-f_S_dot_zz, q_y, STEWART_FMA(-V_xx, q_y, STEWART_FMA(f_S_dot_zy, q_z,
            V_yx*q_x)));
        out->sum[91][l] = STEWART_FMA(-f_S_dot_zx, q_z, STEWART_FMA(-V_xy, q_y, STEWART_FMA(f_S_dot_zz, q_x,
            V_yy*q_x)));
        out->sum[92][l] = STEWART_FMA(-f_S_dot_zy, q_x, STEWART_FMA(-V_xz, q_y, STEWART_FMA(f_S_dot_zx, q_y,
            V_yz*q_x)));
        out->H_force[0][l] = s_x;
        out->H_force[1][l] = s_y;
        out->H_force[2][l] = s_z;
        out->H_moment[0][l] = STEWART_FMA(-q_z, s_y, q_y*s_z);
        out->H_moment[1][l] = STEWART_FMA(-q_x, s_z, q_z*s_x);
        out->H_moment[2][l] = STEWART_FMA(-q_y, s_x, q_x*s_y);
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* Computes the sums over platform and legs; ``status`` is the status of the legs. */
static void derivatives_sums(
    const stewart_exact_model *model, const stewart_motion *motion, derivatives_legs *legs,
    stewart_real summed[93])
{
    int l;
    motion_in_lanes at;
    derivatives_pose pose;
    at.R[0][0] = motion->R[0];
    at.R[1][0] = motion->R[1];
    at.R[2][0] = motion->R[2];
    at.R[3][0] = motion->R[3];
    at.R[4][0] = motion->R[4];
    at.R[5][0] = motion->R[5];
    at.R[6][0] = motion->R[6];
    at.R[7][0] = motion->R[7];
    at.R[8][0] = motion->R[8];
    at.omega[0][0] = motion->omega[0];
    at.omega[1][0] = motion->omega[1];
    at.omega[2][0] = motion->omega[2];
    at.alpha[0][0] = motion->alpha[0];
    at.alpha[1][0] = motion->alpha[1];
    at.alpha[2][0] = motion->alpha[2];
    at.a[0][0] = motion->a[0];
    at.a[1][0] = motion->a[1];
    at.a[2][0] = motion->a[2];
    at.F_ext[0][0] = motion->F_ext[0];
    at.F_ext[1][0] = motion->F_ext[1];
    at.F_ext[2][0] = motion->F_ext[2];
    at.M_ext[0][0] = motion->M_ext[0];
    at.M_ext[1][0] = motion->M_ext[1];
    at.M_ext[2][0] = motion->M_ext[2];
    derivatives_of_pose(model, &at, 1, &pose, summed);
    for (l = 6; l < 8; ++l) {
        legs->F[l] = legs->F[5];
    }
    derivatives_of_leg(model, motion, &pose, legs);
    if (is_near(&legs->checked) != 0) {
        derivatives_of_near(model, motion, &pose, legs);
    }
    legs->status = legs_status(&legs->checked);
    if (legs->status == STEWART_OK) {
        add_legs(legs->sum, 93, summed);
    }
}

/* A symmetric 3 x 3 block from xx xy xz yy yz zz. */
static void place_symmetric_24(const stewart_real parts[6], int row, int column, stewart_real A[144])
{
    int i;
    for (i = 0; i < 3; ++i) {
        A[24*row + (column + i)] = parts[i];
        A[24*(row + i) + column] = parts[i];
    }
    A[24*(row + 1) + (column + 1)] = parts[3];
    A[24*(row + 1) + (column + 2)] = parts[4];
    A[24*(row + 2) + (column + 1)] = parts[4];
    A[24*(row + 2) + (column + 2)] = parts[5];
}

/* M into six columns from ``first`` on, from its parts, of which symmetric ones are xx xy xz yy yz zz. */
static void place_inertia_24(
    const stewart_real vv[6], const stewart_real vw[9], const stewart_real ww[6], int first,
    stewart_real A[144])
{
    int i, j;
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 3; ++j) {
            A[24*i + (first + j + 3)] = vw[3*i + j];
            A[24*(j + 3) + (first + i)] = vw[3*i + j];
        }
    }
    place_symmetric_24(vv, 0, first, A);
    place_symmetric_24(ww, 3, first + 3, A);
}

/* Four 3 x 3 blocks, whose rows are ``ROW`` numbers apart, into six columns from ``first`` on. */
static void place_blocks_24(
    const stewart_real vv[15], const stewart_real vw[15], const stewart_real wv[15],
    const stewart_real ww[15], int first, stewart_real A[144])
{
    int i, j;
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 3; ++j) {
            A[24*i + (first + j)] = vv[6*i + j];
            A[24*i + (first + j + 3)] = vw[6*i + j];
            A[24*(i + 3) + (first + j)] = wv[6*i + j];
            A[24*(i + 3) + (first + j + 3)] = ww[6*i + j];
        }
    }
}

/* Substitutes back; ``inverse`` contains the reciprocals of the pivots. */
static void substitute_back_24(stewart_real A[144], const stewart_real inverse[6])
{
    int i, j, k;
    stewart_real row[24];
    for (k = 5; k >= 0; --k) {
        for (j = 6; j < 24; ++j) {
            row[j] = A[24*k + j]*inverse[k];
            A[24*k + j] = row[j];
        }
        for (i = 0; i < k; ++i) {
            const stewart_real factor = A[24*i + k];
            for (j = 6; j < 24; ++j) {
                A[24*i + j] = STEWART_FMA(-factor, row[j], A[24*i + j]);
            }
        }
    }
}

/* Subtracts multiples of row k from the rows below, so that their column k, which is not stored, is
 * zero.
 *
 * ``row`` is a copy, because compilers then know that it differs from the rows that change. */
static void clear_below_24(stewart_real A[144], int k, stewart_real inverse)
{
    int i, j;
    stewart_real row[24];
    for (j = 0; j < 24; ++j) {
        row[j] = A[24*k + j];
    }
    for (i = k + 1; i < 6; ++i) {
        const stewart_real factor = A[24*i + k]*inverse;
        for (j = 0; j < 24; ++j) {
            A[24*i + j] = STEWART_FMA(-factor, row[j], A[24*i + j]);
        }
    }
}

/* Solves the rows [M | Y] for X, which replaces Y, by L D L^T.
 *
 * Returns MASS_MATRIX_INDEFINITE if a pivot is at most ``kept`` times its diagonal entry. */
static int solve_definite_24(stewart_real A[144], stewart_real kept)
{
    int k;
    stewart_real scale[6];
    stewart_real inverse[6];
    int status = STEWART_OK;
    for (k = 0; k < 6; ++k) {
        scale[k] = A[24*k + k];
    }
    for (k = 0; k < 6; ++k) {
        int fault = STEWART_FABS(A[24*k + k]) <= STEWART_MAX ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_NOT_FINITE;
        fault = A[24*k + k] > kept*scale[k] ? STEWART_OK : fault;
        status = status == STEWART_OK ? fault : status;
        inverse[k] = REAL(1)/A[24*k + k];
        clear_below_24(A, k, inverse[k]);
    }
    substitute_back_24(A, inverse);
    return status;
}

/* Sets the status if a number of a result is not finite. */
static void check_linearization(linearization_found *out)
{
    int i;
    if (out->status != STEWART_OK) {
        return;
    }
    for (i = 0; i < 6; ++i) {
        if (!(STEWART_FABS(out->of.acceleration[i]) <= STEWART_MAX)) {
            out->status = STEWART_NOT_FINITE;
            return;
        }
    }
    size_t lost = 0U;
    for (i = 0; i < 144; ++i) {
        lost = lost + (STEWART_FABS(out->of.A[i]) <= STEWART_MAX ? 0U : 1U);
    }
    for (i = 0; i < 72; ++i) {
        lost = lost + (STEWART_FABS(out->of.B[i]) <= STEWART_MAX ? 0U : 1U);
    }
    out->status = lost == 0U ? STEWART_OK : STEWART_NOT_FINITE;
}

typedef struct {
    stewart_real B[9][LANES];
} STEWART_ALIGNED joint_slopes_pose;

typedef struct {
    stewart_real sum[93][LANES];
    stewart_real net[3][LANES];
    stewart_real turned[3][LANES];
    stewart_real axial[LANES];
    stewart_real tau_t[9][LANES];
    stewart_real tau_r[9][LANES];
    stewart_real tau_v[9][LANES];
    stewart_real tau_w[9][LANES];
    stewart_real H_force[3][LANES];
    stewart_real H_moment[3][LANES];
    leg_checks checked;
    int status;
} STEWART_ALIGNED joint_slopes_legs;

/* Computes the terms of the platform, for one pose or eight. */
static STEWART_INLINE void joint_slopes_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const motion_in_lanes *STEWART_RESTRICT at,
    int lanes, joint_slopes_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT summed)
{
    int l;
    const stewart_real C_P = model->C_P;
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    const stewart_real M = model->M;
    const stewart_real R_0_x = model->R_0[0], R_0_y = model->R_0[1], R_0_z = model->R_0[2];
    const stewart_real I_p_xx = model->I_p[0], I_p_xy = model->I_p[1], I_p_xz = model->I_p[2], I_p_yy = model->I_p[3],
        I_p_yz = model->I_p[4], I_p_zz = model->I_p[5];
    for (l = 0; l < lanes; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        const stewart_real alpha_x = at->alpha[0][l], alpha_y = at->alpha[1][l], alpha_z = at->alpha[2][l];
        const stewart_real a_x = at->a[0][l], a_y = at->a[1][l], a_z = at->a[2][l];
        const stewart_real F_ext_x = at->F_ext[0][l], F_ext_y = at->F_ext[1][l], F_ext_z = at->F_ext[2][l];
        const stewart_real M_ext_x = at->M_ext[0][l], M_ext_y = at->M_ext[1][l], M_ext_z = at->M_ext[2][l];
        const stewart_real c1 = R_0_y*R_0_y;
        const stewart_real c2 = R_0_z*R_0_z;
        const stewart_real J_0_xx = STEWART_FMA(M, c1 + c2, I_p_xx);
        const stewart_real c3 = M*R_0_x;
        const stewart_real J_0_xy = STEWART_FMA(R_0_y, -c3, I_p_xy);
        const stewart_real J_0_xz = STEWART_FMA(R_0_z, -c3, I_p_xz);
        const stewart_real c4 = R_0_x*R_0_x;
        const stewart_real J_0_yy = STEWART_FMA(M, c2 + c4, I_p_yy);
        const stewart_real c5 = M*R_0_y;
        const stewart_real J_0_yz = STEWART_FMA(R_0_z, -c5, I_p_yz);
        const stewart_real J_0_zz = STEWART_FMA(M, c1 + c4, I_p_zz);
        const stewart_real c6 = M*R_0_z;
        /* (30) first moment of the platform, base frame */
        const stewart_real h_base_x = STEWART_FMA(R_xz, c6, STEWART_FMA(R_xy, c5, R_xx*c3));
        const stewart_real h_base_y = STEWART_FMA(R_yz, c6, STEWART_FMA(R_yy, c5, R_yx*c3));
        const stewart_real h_base_z = STEWART_FMA(R_zz, c6, STEWART_FMA(R_zy, c5, R_zx*c3));
        const stewart_real c7 = STEWART_FMA(J_0_xx, R_xx, STEWART_FMA(J_0_xz, R_xz, J_0_xy*R_xy));
        const stewart_real c8 = STEWART_FMA(J_0_yy, R_xy, STEWART_FMA(J_0_yz, R_xz, J_0_xy*R_xx));
        const stewart_real c9 = STEWART_FMA(J_0_zz, R_xz, STEWART_FMA(J_0_yz, R_xy, J_0_xz*R_xx));
        const stewart_real c10 = STEWART_FMA(J_0_xx, R_yx, STEWART_FMA(J_0_xz, R_yz, J_0_xy*R_yy));
        const stewart_real c11 = STEWART_FMA(J_0_yy, R_yy, STEWART_FMA(J_0_yz, R_yz, J_0_xy*R_yx));
        const stewart_real c12 = STEWART_FMA(J_0_zz, R_yz, STEWART_FMA(J_0_yz, R_yy, J_0_xz*R_yx));
        /* (32) inertia of the platform, base frame */
        const stewart_real J_base_xx = STEWART_FMA(R_xz, c9, STEWART_FMA(R_xy, c8, R_xx*c7));
        const stewart_real J_base_xy = STEWART_FMA(R_yz, c9, STEWART_FMA(R_yy, c8, R_yx*c7));
        const stewart_real J_base_xz = STEWART_FMA(R_zz, c9, STEWART_FMA(R_zy, c8, R_zx*c7));
        const stewart_real J_base_yy = STEWART_FMA(R_yz, c12, STEWART_FMA(R_yy, c11, R_yx*c10));
        const stewart_real J_base_yz = STEWART_FMA(R_zz, c12, STEWART_FMA(R_zy, c11, R_zx*c10));
        const stewart_real J_base_zz = STEWART_FMA(R_zz, STEWART_FMA(J_0_zz, R_zz, STEWART_FMA(J_0_yz, R_zy,
            J_0_xz*R_zx)), STEWART_FMA(R_zy, STEWART_FMA(J_0_yy, R_zy, STEWART_FMA(J_0_yz, R_zz,
            J_0_xy*R_zx)), R_zx*STEWART_FMA(J_0_xx, R_zx, STEWART_FMA(J_0_xz, R_zz, J_0_xy*R_zy))));
        const stewart_real c13 = h_base_y*omega_z;
        const stewart_real c14 = h_base_z*omega_y;
        const stewart_real c15 = h_base_x*omega_z;
        const stewart_real c16 = h_base_z*omega_x;
        const stewart_real c17 = h_base_x*omega_y;
        const stewart_real c18 = h_base_y*omega_x;
        /* (31) omega x h */
        const stewart_real w_h_x = c14 - c13;
        const stewart_real w_h_y = c15 - c16;
        const stewart_real w_h_z = c18 - c17;
        const stewart_real c19 = J_base_xy*omega_y;
        const stewart_real c20 = J_base_xz*omega_z;
        const stewart_real c21 = J_base_xy*omega_x;
        const stewart_real c22 = J_base_yz*omega_z;
        const stewart_real c23 = J_base_xz*omega_x;
        const stewart_real c24 = J_base_yz*omega_y;
        /* (34) I omega */
        const stewart_real J_w_x = STEWART_FMA(J_base_xx, omega_x, c19) + c20;
        const stewart_real J_w_y = STEWART_FMA(J_base_yy, omega_y, c21) + c22;
        const stewart_real J_w_z = STEWART_FMA(J_base_zz, omega_z, c23) + c24;
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
        const stewart_real c25 = J_base_xy*alpha_y;
        const stewart_real c26 = J_base_xz*alpha_z;
        const stewart_real J_alpha_x = STEWART_FMA(J_base_xx, alpha_x, c25) + c26;
        const stewart_real c27 = J_base_xy*alpha_x;
        const stewart_real c28 = J_base_yz*alpha_z;
        const stewart_real J_alpha_y = STEWART_FMA(J_base_yy, alpha_y, c27) + c28;
        const stewart_real c29 = J_base_xz*alpha_x;
        const stewart_real c30 = J_base_yz*alpha_y;
        const stewart_real J_alpha_z = STEWART_FMA(J_base_zz, alpha_z, c29) + c30;
        /* (33) a - g */
        const stewart_real rise_x = a_x - g_x;
        const stewart_real rise_y = a_y - g_y;
        const stewart_real rise_z = a_z - g_z;
        const stewart_real F_load_x = STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy, F_ext_x*R_xx));
        const stewart_real F_load_y = STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy, F_ext_x*R_yx));
        const stewart_real F_load_z = STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy, F_ext_x*R_zx));
        const stewart_real M_load_x = STEWART_FMA(M_ext_z, R_xz, STEWART_FMA(M_ext_y, R_xy, M_ext_x*R_xx));
        const stewart_real M_load_y = STEWART_FMA(M_ext_z, R_yz, STEWART_FMA(M_ext_y, R_yy, M_ext_x*R_yx));
        const stewart_real M_load_z = STEWART_FMA(M_ext_z, R_zz, STEWART_FMA(M_ext_y, R_zy, M_ext_x*R_zx));
        const stewart_real c31 = J_base_xy*omega_z;
        const stewart_real c32 = J_base_xz*omega_y;
        const stewart_real c34 = STEWART_FMA(-J_base_xx, omega_z, c23) + J_w_z;
        const stewart_real c35 = STEWART_FMA(-J_base_xx, omega_y, c21) + J_w_y;
        const stewart_real c36 = STEWART_FMA(-J_base_yy, omega_z, c24) + J_w_z;
        const stewart_real c37 = J_base_yz*omega_x;
        const stewart_real c39 = c31 - c37;
        const stewart_real c40 = STEWART_FMA(-J_base_yy, omega_x, c19) + J_w_x;
        const stewart_real c41 = STEWART_FMA(-J_base_zz, omega_y, c22) + J_w_y;
        const stewart_real c42 = STEWART_FMA(-J_base_zz, omega_x, c20) + J_w_x;
        /* derivative of I omega by dphi at fixed omega */
        const stewart_real spin_xx = c31 - c32;
        const stewart_real spin_xy = c34;
        const stewart_real spin_xz = -c35;
        const stewart_real spin_yx = -c36;
        const stewart_real spin_yy = -c39;
        const stewart_real spin_yz = c40;
        const stewart_real spin_zx = c41;
        const stewart_real spin_zy = -c42;
        const stewart_real spin_zz = c32 - c37;
        const stewart_real c43 = J_base_xz*alpha_y;
        const stewart_real c44 = h_base_y*rise_y;
        const stewart_real c45 = h_base_z*rise_z;
        const stewart_real c46 = J_base_xy*alpha_z;
        const stewart_real c47 = h_base_x*rise_x;
        const stewart_real c48 = J_base_yz*alpha_x;
        const stewart_real c49 = h_base_y*omega_y;
        const stewart_real c50 = h_base_z*omega_z;
        const stewart_real c51 = h_base_x*omega_x;
        out->B[0][l] = B_xx;
        out->B[1][l] = B_xy;
        out->B[2][l] = B_xz;
        out->B[3][l] = B_yx;
        out->B[4][l] = B_yy;
        out->B[5][l] = B_yz;
        out->B[6][l] = B_zx;
        out->B[7][l] = B_zy;
        out->B[8][l] = B_zz;
        summed[0*lanes + l] = M;
        summed[1*lanes + l] = REAL(0);
        summed[2*lanes + l] = REAL(0);
        summed[3*lanes + l] = M;
        summed[4*lanes + l] = REAL(0);
        summed[5*lanes + l] = M;
        summed[6*lanes + l] = REAL(0);
        summed[7*lanes + l] = h_base_z;
        summed[8*lanes + l] = -h_base_y;
        summed[9*lanes + l] = -h_base_z;
        summed[10*lanes + l] = REAL(0);
        summed[11*lanes + l] = h_base_x;
        summed[12*lanes + l] = h_base_y;
        summed[13*lanes + l] = -h_base_x;
        summed[14*lanes + l] = REAL(0);
        summed[15*lanes + l] = J_base_xx;
        summed[16*lanes + l] = J_base_xy;
        summed[17*lanes + l] = J_base_xz;
        summed[18*lanes + l] = J_base_yy;
        summed[19*lanes + l] = J_base_yz;
        summed[20*lanes + l] = J_base_zz;
        summed[21*lanes + l] = REAL(0);
        summed[22*lanes + l] = REAL(0);
        summed[23*lanes + l] = REAL(0);
        summed[24*lanes + l] = STEWART_FMA(-B_xy, h_base_z, B_xz*h_base_y);
        summed[25*lanes + l] = STEWART_FMA(-B_xz, h_base_x, STEWART_FMA(B_xx, h_base_z, -F_load_z));
        summed[26*lanes + l] = STEWART_FMA(-B_xx, h_base_y, STEWART_FMA(B_xy, h_base_x, F_load_y));
        summed[27*lanes + l] = REAL(0);
        summed[28*lanes + l] = REAL(0);
        summed[29*lanes + l] = REAL(0);
        summed[30*lanes + l] = STEWART_FMA(-B_yy, h_base_z, STEWART_FMA(B_yz, h_base_y, F_load_z));
        summed[31*lanes + l] = STEWART_FMA(-B_yz, h_base_x, B_yx*h_base_z);
        summed[32*lanes + l] = STEWART_FMA(-B_yx, h_base_y, STEWART_FMA(B_yy, h_base_x, -F_load_x));
        summed[33*lanes + l] = REAL(0);
        summed[34*lanes + l] = REAL(0);
        summed[35*lanes + l] = REAL(0);
        summed[36*lanes + l] = STEWART_FMA(-B_zy, h_base_z, STEWART_FMA(B_zz, h_base_y, -F_load_y));
        summed[37*lanes + l] = STEWART_FMA(-B_zz, h_base_x, STEWART_FMA(B_zx, h_base_z, F_load_x));
        summed[38*lanes + l] = STEWART_FMA(-B_zx, h_base_y, B_zy*h_base_x);
        summed[39*lanes + l] = REAL(0);
        summed[40*lanes + l] = REAL(0);
        summed[41*lanes + l] = REAL(0);
        summed[42*lanes + l] = STEWART_FMA(-omega_z, spin_yx, STEWART_FMA(omega_y, spin_zx, c46) - c43 - c44
            - c45);
        summed[43*lanes + l] = STEWART_FMA(-omega_z, spin_yy, STEWART_FMA(-J_base_xx, alpha_z,
            STEWART_FMA(omega_y, spin_zy, STEWART_FMA(h_base_x, rise_y, J_alpha_z + c29)) - M_load_z));
        summed[44*lanes + l] = STEWART_FMA(-omega_z, spin_yz, STEWART_FMA(omega_y, spin_zz,
            STEWART_FMA(h_base_x, rise_z, STEWART_FMA(J_base_xx, alpha_y, M_load_y))) - J_alpha_y - c27);
        summed[45*lanes + l] = REAL(0);
        summed[46*lanes + l] = REAL(0);
        summed[47*lanes + l] = REAL(0);
        summed[48*lanes + l] = STEWART_FMA(-omega_x, spin_zx, STEWART_FMA(omega_z, spin_xx,
            STEWART_FMA(h_base_y, rise_x, STEWART_FMA(J_base_yy, alpha_z, M_load_z))) - J_alpha_z - c30);
        summed[49*lanes + l] = STEWART_FMA(-omega_x, spin_zy, STEWART_FMA(omega_z, spin_xy, c48) - c45 - c46
            - c47);
        summed[50*lanes + l] = STEWART_FMA(-omega_x, spin_zz, STEWART_FMA(-J_base_yy, alpha_x,
            STEWART_FMA(omega_z, spin_xz, STEWART_FMA(h_base_y, rise_z, J_alpha_x + c25)) - M_load_x));
        summed[51*lanes + l] = REAL(0);
        summed[52*lanes + l] = REAL(0);
        summed[53*lanes + l] = REAL(0);
        summed[54*lanes + l] = STEWART_FMA(-omega_y, spin_xx, STEWART_FMA(-J_base_zz, alpha_y,
            STEWART_FMA(omega_x, spin_yx, STEWART_FMA(h_base_z, rise_x, J_alpha_y + c28)) - M_load_y));
        summed[55*lanes + l] = STEWART_FMA(-omega_y, spin_xy, STEWART_FMA(omega_x, spin_yy,
            STEWART_FMA(h_base_z, rise_y, STEWART_FMA(J_base_zz, alpha_x, M_load_x))) - J_alpha_x - c26);
        summed[56*lanes + l] = STEWART_FMA(-omega_y, spin_xz, STEWART_FMA(omega_x, spin_yz, c43) - c44 - c47
            - c48);
        summed[57*lanes + l] = REAL(0);
        summed[58*lanes + l] = REAL(0);
        summed[59*lanes + l] = REAL(0);
        summed[60*lanes + l] = c49 + c50;
        summed[61*lanes + l] = w_h_z - c17;
        summed[62*lanes + l] = -c15 - w_h_y;
        summed[63*lanes + l] = REAL(0);
        summed[64*lanes + l] = REAL(0);
        summed[65*lanes + l] = REAL(0);
        summed[66*lanes + l] = -c18 - w_h_z;
        summed[67*lanes + l] = c50 + c51;
        summed[68*lanes + l] = w_h_x - c13;
        summed[69*lanes + l] = REAL(0);
        summed[70*lanes + l] = REAL(0);
        summed[71*lanes + l] = REAL(0);
        summed[72*lanes + l] = w_h_y - c16;
        summed[73*lanes + l] = -c14 - w_h_x;
        summed[74*lanes + l] = c49 + c51;
        summed[75*lanes + l] = REAL(0);
        summed[76*lanes + l] = REAL(0);
        summed[77*lanes + l] = REAL(0);
        summed[78*lanes + l] = C_P + c32 - c31;
        summed[79*lanes + l] = c36;
        summed[80*lanes + l] = -c41;
        summed[81*lanes + l] = REAL(0);
        summed[82*lanes + l] = REAL(0);
        summed[83*lanes + l] = REAL(0);
        summed[84*lanes + l] = -c34;
        summed[85*lanes + l] = C_P + c39;
        summed[86*lanes + l] = c42;
        summed[87*lanes + l] = REAL(0);
        summed[88*lanes + l] = REAL(0);
        summed[89*lanes + l] = REAL(0);
        summed[90*lanes + l] = c35;
        summed[91*lanes + l] = -c40;
        summed[92*lanes + l] = C_P + c37 - c32;
    }
}

/* Computes the legs of a pose in lanes. */
STEWART_APART static void joint_slopes_of_leg(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT motion,
    const joint_slopes_pose *STEWART_RESTRICT pose, joint_slopes_legs *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = motion->R[0], R_xy = motion->R[1], R_xz = motion->R[2], R_yx = motion->R[3],
        R_yy = motion->R[4], R_yz = motion->R[5], R_zx = motion->R[6], R_zy = motion->R[7], R_zz = motion->R[8];
    const stewart_real t_x = motion->t[0], t_y = motion->t[1], t_z = motion->t[2];
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    const stewart_real B_xx = pose->B[0][0], B_xy = pose->B[1][0], B_xz = pose->B[2][0], B_yx = pose->B[3][0],
        B_yy = pose->B[4][0], B_yz = pose->B[5][0], B_zx = pose->B[6][0], B_zy = pose->B[7][0], B_zz = pose->B[8][0];
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][l], b_y = model->b[1][l], b_z = model->b[2][l];
        const stewart_real p_x = model->p[0][l], p_y = model->p[1][l], p_z = model->p[2][l];
        const stewart_real k_x = model->k[0][l], k_y = model->k[1][l], k_z = model->k[2][l];
        const stewart_real m_u = model->m_u[l];
        const stewart_real C_p = model->C_p[l];
        const stewart_real C_s = model->C_s[l];
        const stewart_real h_x = model->h[0][l], h_y = model->h[1][l], h_z = model->h[2][l];
        const stewart_real w_x = model->w[0][l], w_y = model->w[1][l], w_z = model->w[2][l];
        const stewart_real J_xx = model->J[0][l], J_xy = model->J[1][l], J_xz = model->J[2][l], J_yy = model->J[3][l],
            J_yz = model->J[4][l], J_zz = model->J[5][l];
        const stewart_real g_k = model->g_k[l];
        const stewart_real g_x_k_x = model->g_x_k[0][l], g_x_k_y = model->g_x_k[1][l], g_x_k_z = model->g_x_k[2][l];
        const stewart_real C_us = model->C_us[l];
        const stewart_real net_x = out->net[0][l], net_y = out->net[1][l], net_z = out->net[2][l];
        const stewart_real turned_x = out->turned[0][l], turned_y = out->turned[1][l], turned_z = out->turned[2][l];
        const stewart_real axial = out->axial[l];
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
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(omega_z, -q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(omega_x, -q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(omega_y, -q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
        const stewart_real c1 = STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y, S_dot_x*y_x));
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = c1*inv_rho;
        const stewart_real theta_dot = -inv_L*STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y,
            S_dot_x*z_x));
        const stewart_real c2 = L_dot*inv_L;
        /* L_dot / L */
        const stewart_real L_share = c2;
        const stewart_real c3 = theta_dot*theta_dot;
        const stewart_real theta_dot2 = c3;
        const stewart_real phi_dot2 = phi_dot*phi_dot;
        const stewart_real c4 = L*inv_rho;
        const stewart_real inv_k3 = c4;
        /* (6) angular velocity of the leg about z */
        const stewart_real W_z = c1*inv_L;
        const stewart_real c5 = omega_z*w_q_y;
        const stewart_real c6 = STEWART_FMA(omega_z, -w_q_x, omega_x*w_q_z);
        const stewart_real c7 = omega_y*w_q_x;
        /* (7) acceleration of the platform point */
        const stewart_real S_ddot_x = STEWART_FMA(omega_y, w_q_z, -c5);
        const stewart_real S_ddot_y = -c6;
        const stewart_real S_ddot_z = STEWART_FMA(omega_x, w_q_y, -c7);
        const stewart_real c8 = k3*k3;
        /* (8) acceleration of the length */
        const stewart_real L_ddot = STEWART_FMA(S_ddot_y, s_y, STEWART_FMA(S_ddot_z, s_z,
            STEWART_FMA(S_ddot_x, s_x, STEWART_FMA(L, STEWART_FMA(c8, phi_dot2, theta_dot2), turned_x))));
        const stewart_real c9 = REAL(2)*L_share;
        const stewart_real c10 = k3*turned_z;
        /* (9) angular accelerations of the leg about y and z without the rotation of the frame about s */
        const stewart_real own_y = STEWART_FMA(-c9, theta_dot, STEWART_FMA(-inv_L, STEWART_FMA(S_ddot_z,
            z_z, STEWART_FMA(S_ddot_y, z_y, S_ddot_x*z_x)), turned_y));
        const stewart_real own_z = STEWART_FMA(-W_z, c9, STEWART_FMA(inv_L, STEWART_FMA(S_ddot_z, y_z,
            STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)), c10));
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* k x y */
        const stewart_real normal_x = STEWART_FMA(-k_z, y_y, k_y*y_z);
        const stewart_real normal_y = STEWART_FMA(-k_x, y_z, k_z*y_x);
        const stewart_real normal_z = STEWART_FMA(-k_y, y_x, k_x*y_y);
        /* omega along k x y, y and k */
        const stewart_real w_n_omega = STEWART_FMA(normal_z, omega_z, STEWART_FMA(normal_y, omega_y,
            normal_x*omega_x));
        const stewart_real w_y_omega = STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x));
        const stewart_real w_k_omega = STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y, k_x*omega_x));
        const stewart_real c11 = inv_rho*net_z;
        const stewart_real c12 = inv_L*net_y;
        /* force at the tip, less the actuator's */
        const stewart_real R_tip_x = STEWART_FMA(c11, y_x, STEWART_FMA(-c12, z_x, net_x*s_x));
        const stewart_real R_tip_y = STEWART_FMA(c11, y_y, STEWART_FMA(-c12, z_y, net_x*s_y));
        const stewart_real R_tip_z = STEWART_FMA(c11, y_z, STEWART_FMA(-c12, z_z, net_x*s_z));
        const stewart_real fall_x = STEWART_FMA(omega_y, w_q_z, -g_x) - c5;
        const stewart_real fall_y = -g_y - c6;
        const stewart_real fall_z = STEWART_FMA(omega_x, w_q_y, -g_z) - c7;
        /* m_u times the acceleration of the platform point relative to free fall, leg frame */
        const stewart_real fall_T_x = STEWART_FMA(fall_y, s_y, STEWART_FMA(fall_z, s_z, STEWART_FMA(fall_x,
            s_x, turned_x)));
        const stewart_real fall_T_y = STEWART_FMA(fall_z, y_z, STEWART_FMA(fall_y, y_y, STEWART_FMA(fall_x,
            y_x, L*c10)));
        const stewart_real fall_T_z = STEWART_FMA(fall_z, z_z, STEWART_FMA(fall_y, z_y, STEWART_FMA(-L,
            turned_y, fall_x*z_x)));
        const stewart_real c13 = h_z*own_y;
        const stewart_real c14 = W_z*W_z;
        const stewart_real c15 = inv_L*inv_L;
        const stewart_real c16 = L_dot*c15;
        const stewart_real c17 = REAL(2)*h_y;
        const stewart_real c18 = W_z*c17;
        const stewart_real c19 = h_y*inv_L;
        const stewart_real c20 = W_z*inv_k3;
        const stewart_real c21 = c20*k1;
        const stewart_real c22 = REAL(4)*c21;
        const stewart_real c23 = c22*theta_dot;
        const stewart_real c24 = c14*h_z;
        const stewart_real c25 = c24*inv_L;
        const stewart_real c26 = inv_k3*k1;
        const stewart_real tau_S_leg_11 = STEWART_FMA(-c19, c23, STEWART_FMA(h_y*inv_L, own_z,
            STEWART_FMA(-c13, inv_L, STEWART_FMA(-c16, c18, STEWART_FMA(REAL(2)*L_dot*c15*h_z, theta_dot,
            STEWART_FMA(REAL(4)*c25, -c26, STEWART_FMA(REAL(2)*c3*h_x, inv_L, REAL(2)*c14*h_x*inv_L)))))));
        const stewart_real c27 = REAL(2)*h_x;
        const stewart_real c28 = c27*inv_L;
        const stewart_real c29 = c28*own_z;
        const stewart_real c30 = axial*m_u;
        const stewart_real c31 = c30*fall_T_y;
        const stewart_real c32 = L_ddot*c15;
        const stewart_real c33 = c15*w_x;
        const stewart_real c34 = c33*gamma_y;
        const stewart_real c35 = c19*c3;
        const stewart_real c36 = h_z*inv_L;
        const stewart_real c37 = REAL(2)*theta_dot;
        const stewart_real c38 = c36*c37;
        const stewart_real c39 = h_y*own_y;
        const stewart_real c40 = inv_L*k1;
        const stewart_real c41 = c40*inv_k3;
        const stewart_real c42 = h_z*own_z;
        const stewart_real c43 = J_zz*own_z;
        const stewart_real c44 = c15*c43;
        const stewart_real c45 = c14*c19;
        const stewart_real c46 = L_dot*L_dot;
        const stewart_real c47 = inv_L*inv_L*inv_L;
        const stewart_real c48 = c46*c47;
        const stewart_real c49 = axial*c16;
        const stewart_real c50 = inv_k3*inv_k3;
        const stewart_real c51 = REAL(4)*W_z;
        const stewart_real c52 = REAL(2)*c50;
        const stewart_real c53 = REAL(4)*c16;
        const stewart_real c54 = h_y*k1;
        const stewart_real c55 = c54*inv_k3;
        const stewart_real c56 = c16*c37;
        const stewart_real tau_S_leg_12 = STEWART_FMA(axial, c44, STEWART_FMA(c36*c50*c51, -theta_dot,
            STEWART_FMA(c21*c53, -h_z, STEWART_FMA(c41, c42, STEWART_FMA(axial, c29, STEWART_FMA(c39, c41,
            STEWART_FMA(-c55, c56, STEWART_FMA(-axial, c34, STEWART_FMA(W_z*c27, c49, STEWART_FMA(c31,
            inv_L, STEWART_FMA(W_z, c38, STEWART_FMA(C_p, W_z, STEWART_FMA(c32, h_y, STEWART_FMA(-c35, c52,
            STEWART_FMA(c45, c52, STEWART_FMA(-c17, c48, c35)) - c45)) + c34)))))))))) - c29)) - c44;
        const stewart_real c57 = c27*own_y;
        const stewart_real c58 = c57*inv_L;
        const stewart_real c59 = c30*fall_T_z;
        const stewart_real c60 = J_yy*c15*own_y;
        const stewart_real c61 = L_ddot*h_z;
        const stewart_real c62 = c3*h_z;
        const stewart_real c63 = W_z*c37;
        const stewart_real c64 = c19*c63;
        const stewart_real c65 = c33*g_k*k3;
        const stewart_real c66 = gamma_n*k1;
        const stewart_real c67 = c33*c66;
        const stewart_real c68 = REAL(2)*h_z;
        const stewart_real c69 = c27*theta_dot;
        const stewart_real c70 = REAL(2)*W_z;
        const stewart_real c71 = c55*c70;
        const stewart_real c73 = J_yy - J_zz;
        const stewart_real c74 = c14*inv_k3;
        const stewart_real c75 = c74*k1;
        const stewart_real c76 = c15*c75;
        const stewart_real tau_S_leg_13 = STEWART_FMA(-axial, c60, STEWART_FMA(-axial, c58,
            STEWART_FMA(-axial, c67, STEWART_FMA(c50, c64, STEWART_FMA(c16, c71, STEWART_FMA(-c49, c69,
            STEWART_FMA(-C_p, theta_dot, STEWART_FMA(c59, inv_L, STEWART_FMA(c15, c61,
            STEWART_FMA(axial*c73, -c76, STEWART_FMA(c73, c76, STEWART_FMA(-axial, c65, STEWART_FMA(c25,
            c52, STEWART_FMA(-c48, c68, c62*inv_L)) - c25 + c65)))))) + c67))) + c58 + c60) - c64));
        const stewart_real c78 = C_us*inv_L;
        const stewart_real c79 = c78*theta_dot;
        const stewart_real c80 = REAL(2)*J_yy;
        const stewart_real c81 = inv_L*own_y;
        const stewart_real c82 = J_yz*inv_L;
        const stewart_real c83 = c17*theta_dot;
        const stewart_real c84 = W_z*c83;
        const stewart_real c85 = axial*c57;
        const stewart_real c86 = J_yy*inv_L;
        const stewart_real c87 = axial*c86;
        const stewart_real c88 = inv_L*theta_dot;
        const stewart_real c89 = J_xy*c88;
        const stewart_real c90 = c51*c89;
        const stewart_real c91 = inv_L*k3;
        const stewart_real c92 = c91*w_x;
        const stewart_real c93 = c92*g_k;
        const stewart_real c94 = inv_L*w_x;
        const stewart_real c95 = c66*c94;
        const stewart_real c96 = J_xz*c14;
        const stewart_real c97 = REAL(4)*inv_L;
        const stewart_real c98 = J_xy*inv_L;
        const stewart_real c99 = c98*k1;
        const stewart_real c100 = c99*inv_k3;
        const stewart_real c101 = axial*c2;
        const stewart_real c102 = c16*c80;
        const stewart_real c103 = REAL(2)*J_yz;
        const stewart_real c104 = c103*c16;
        const stewart_real c105 = c50*c84;
        const stewart_real c106 = c24*c50;
        const stewart_real c107 = REAL(2)*c96;
        const stewart_real c108 = c50*inv_L;
        const stewart_real c109 = REAL(2)*k1;
        const stewart_real c110 = J_xy*c16;
        const stewart_real c111 = c109*c110;
        const stewart_real c112 = c40*c74;
        const stewart_real c113 = REAL(2)*J_xx;
        const stewart_real tau_S_leg_21 = STEWART_FMA(-c82, own_z, STEWART_FMA(-c100, own_z,
            STEWART_FMA(c23, c82, STEWART_FMA(-c80, c81, STEWART_FMA(-c2, c71, STEWART_FMA(c50, c90,
            STEWART_FMA(c87, own_y, STEWART_FMA(c111, c20, STEWART_FMA(axial, c95, STEWART_FMA(W_z, c104,
            STEWART_FMA(c101, c69, STEWART_FMA(c102, theta_dot, STEWART_FMA(axial*c112, c73,
            STEWART_FMA(c112, STEWART_FMA(REAL(3), -J_yy, REAL(3)*J_zz) - c113, STEWART_FMA(axial, c93,
            STEWART_FMA(-c96, c97, STEWART_FMA(c107, c108, c24 - c62 - c106))) - c93)) - c59)) - c79) + c84)))
            - c95) + c85 - c105 - c57 - c90)))));
        const stewart_real c114 = c98*own_y;
        const stewart_real c115 = W_z*c69;
        const stewart_real c116 = gamma_y*inv_L*w_z;
        const stewart_real c117 = c14*c82;
        const stewart_real c118 = C_s*inv_L;
        const stewart_real c119 = W_z*c78*inv_k3;
        const stewart_real c120 = c31*k1;
        const stewart_real c121 = J_yz*c32;
        const stewart_real c122 = c3*c82;
        const stewart_real c123 = k1*own_y;
        const stewart_real c124 = c123*c82;
        const stewart_real c125 = inv_k3*own_z;
        const stewart_real c126 = axial*k1;
        const stewart_real c127 = c126*c27;
        const stewart_real c128 = axial*c43;
        const stewart_real c129 = c110*c37;
        const stewart_real c130 = J_xz*W_z;
        const stewart_real c131 = c130*c53;
        const stewart_real c132 = J_xz*k1;
        const stewart_real c133 = c126*c94;
        const stewart_real c134 = J_xy*k1;
        const stewart_real c135 = c134*c32;
        const stewart_real c136 = W_z*c68;
        const stewart_real c137 = c136*c50;
        const stewart_real c138 = inv_k3*inv_k3*inv_k3;
        const stewart_real c139 = c136*k1;
        const stewart_real c140 = c139*theta_dot;
        const stewart_real c141 = c2*c27;
        const stewart_real c142 = c126*c141;
        const stewart_real c143 = REAL(2)*c54;
        const stewart_real c144 = c138*c14;
        const stewart_real c145 = c138*c3;
        const stewart_real c146 = c40*own_z;
        const stewart_real c147 = c130*c88;
        const stewart_real c148 = J_yz*k1;
        const stewart_real c149 = -REAL(2)*J_zz;
        const stewart_real c150 = c113 + c149;
        const stewart_real c151 = J_xy*c109*c48;
        const stewart_real c152 = REAL(2)*c99;
        const stewart_real c153 = J_xz*c70;
        const stewart_real c154 = c15*c46;
        const stewart_real c155 = c80 + c150;
        const stewart_real c157 = W_z*c50;
        const stewart_real tau_S_leg_22 = STEWART_FMA(c146*c73, inv_k3, STEWART_FMA(c128, c41,
            STEWART_FMA(c155*c16, -c21, STEWART_FMA(-c138, c140, STEWART_FMA(-c124, inv_k3,
            STEWART_FMA(c118*inv_k3, -w_n_omega, STEWART_FMA(c23, h_z, STEWART_FMA(c125, c127,
            STEWART_FMA(c155*c157, -c88, STEWART_FMA(-c137, c2, STEWART_FMA(REAL(4)*c132*c20, -c88,
            STEWART_FMA(-c114, c50, STEWART_FMA(c153*c16, c50, STEWART_FMA(c109*c138, c147, STEWART_FMA(c39,
            c50, STEWART_FMA(c2*c51, h_z, STEWART_FMA(c119, k1, STEWART_FMA(c2*c50, -c83,
            STEWART_FMA(c133*gamma_y, -inv_k3, STEWART_FMA(c148*c56, inv_k3, STEWART_FMA(c142, c20,
            STEWART_FMA(c120, inv_k3, STEWART_FMA(W_z*c150, c88, STEWART_FMA(c129, c50, STEWART_FMA(c2, c83,
            STEWART_FMA(-c135, inv_k3, STEWART_FMA(L_ddot*c19, c26, STEWART_FMA(REAL(2)*c154, -c55,
            STEWART_FMA(-c144, c152, STEWART_FMA(-c143, c145, STEWART_FMA(-c100, c3, STEWART_FMA(c151,
            inv_k3, STEWART_FMA(-c54, c74, STEWART_FMA(c3, c55, STEWART_FMA(c145, c152, STEWART_FMA(c143,
            c144, STEWART_FMA(c74, c99, STEWART_FMA(-c117, c52, STEWART_FMA(c122, c52, STEWART_FMA(c103,
            c48, c117)) - c122)))))))))))) - c121))) - c129) + c114))) - c115 - c116))))) - c131 - c39)) + c42))))))))))));
        const stewart_real c158 = g_k*k1;
        const stewart_real c159 = gamma_n*w_z;
        const stewart_real c160 = h_y*own_z;
        const stewart_real c161 = c51*c88;
        const stewart_real c162 = c138*c161;
        const stewart_real c163 = c16*c20;
        const stewart_real c164 = c107*c40;
        const stewart_real c165 = J_xx + c73;
        const stewart_real tau_S_leg_23 = STEWART_FMA(-c160, c50, STEWART_FMA(J_xy*c50*inv_L, own_z,
            STEWART_FMA(REAL(2)*J_xy*W_z*inv_L*inv_k3*k1, theta_dot, STEWART_FMA(-c134, c162,
            STEWART_FMA(REAL(4)*W_z*c138*h_y*k1, theta_dot, STEWART_FMA(REAL(2)*L_dot*W_z*c50*h_y, inv_L,
            STEWART_FMA(c50*c63, -c82, STEWART_FMA(REAL(2)*c148, -c163, STEWART_FMA(c110*c50, -c70,
            STEWART_FMA(REAL(2)*J_yz*W_z*inv_L, theta_dot, STEWART_FMA(REAL(2)*J_xy*L_dot*W_z, c15,
            STEWART_FMA(-c55, c63, STEWART_FMA(-c18, c2, STEWART_FMA(-c159, c40,
            STEWART_FMA(gamma_n*inv_L*k3, w_x, STEWART_FMA(REAL(2)*L_ddot*h_x, inv_L,
            STEWART_FMA(J_yy*L_ddot, c15, STEWART_FMA(fall_T_x, m_u, STEWART_FMA(-c138, c164,
            STEWART_FMA(REAL(2)*c138*c14*h_z, k1, STEWART_FMA(C_us*L_dot, c15, STEWART_FMA(-c158, c94,
            STEWART_FMA(c91*g_k, -w_z, STEWART_FMA(-c14, c86, STEWART_FMA(c14*c165*c50, inv_L,
            STEWART_FMA(-c48, c80, STEWART_FMA(-c154, c27, STEWART_FMA(-c14, c27,
            J_yy*c3*inv_L))))))))))))))) - c13)))))))))))));
        const stewart_real c166 = c27*k3;
        const stewart_real c167 = c166*own_z;
        const stewart_real c168 = c92*gamma_y;
        const stewart_real c169 = c74*h_y;
        const stewart_real c170 = J_xx*inv_k3;
        const stewart_real c171 = c170*inv_L;
        const stewart_real c172 = REAL(2)*J_xz;
        const stewart_real c173 = c82*k3;
        const stewart_real c174 = c136*inv_k3;
        const stewart_real c175 = J_xz*c20;
        const stewart_real c176 = REAL(4)*c88;
        const stewart_real c177 = REAL(2)*k3;
        const stewart_real c178 = c177*c98;
        const stewart_real c179 = W_z*c166;
        const stewart_real c180 = c91*own_z;
        const stewart_real c181 = J_yz*k3;
        const stewart_real c182 = c50*k1;
        const stewart_real c184 = -W_z*c150*k3;
        const stewart_real tau_S_leg_31 = STEWART_FMA(-c146, c172, STEWART_FMA(c128, c91, STEWART_FMA(-c171,
            own_z, STEWART_FMA(c180, J_xx + c149, STEWART_FMA(axial, c167, STEWART_FMA(-c174, theta_dot,
            STEWART_FMA(-c139, c2, STEWART_FMA(-c114, k1, STEWART_FMA(c16, c184, STEWART_FMA(J_xx*c161,
            c182, STEWART_FMA(-c173, own_y, STEWART_FMA(c175, c176, STEWART_FMA(c131, k1, STEWART_FMA(c113,
            c163, STEWART_FMA(-axial, c168, STEWART_FMA(c101, c179, STEWART_FMA(c31, k3, STEWART_FMA(c181,
            c56, STEWART_FMA(c111, theta_dot, STEWART_FMA(-c109, c122, STEWART_FMA(-c109, c117,
            STEWART_FMA(REAL(2)*c74, -c98, STEWART_FMA(c178, c3, STEWART_FMA(c14, c178, c169)))))) + c168)))))))
            - c119)))))))) - c167)));
        const stewart_real c185 = k3*own_z;
        const stewart_real c186 = c94*gamma_n;
        const stewart_real c187 = c172*inv_k3;
        const stewart_real c188 = c109*c62;
        const stewart_real c189 = c109*c89;
        const stewart_real c190 = c68*theta_dot;
        const stewart_real c191 = c2*k3;
        const stewart_real c192 = c113*inv_L;
        const stewart_real c193 = c68*k1;
        const stewart_real c194 = J_xx - J_zz;
        const stewart_real tau_S_leg_32 = STEWART_FMA(-c185, c98, STEWART_FMA(-c160, inv_k3,
            STEWART_FMA(J_yz*inv_L*k1, own_z, STEWART_FMA(J_xy*inv_L*inv_k3, own_z, STEWART_FMA(-c85, k1,
            STEWART_FMA(J_xx*c108, -c123, STEWART_FMA(REAL(2)*W_z*c50*h_y*k1, theta_dot,
            STEWART_FMA(REAL(2)*J_xz*inv_L*k3, own_y, STEWART_FMA(REAL(2)*J_xy*L_dot*W_z*c15, k3,
            STEWART_FMA(-c187, c81, STEWART_FMA(c148*c16, -c70, STEWART_FMA(REAL(2)*c13, -k3,
            STEWART_FMA(-c123, c87, STEWART_FMA(REAL(2)*h_z*inv_k3, own_y, STEWART_FMA(c165*inv_L*k1, own_y,
            STEWART_FMA(REAL(2)*J_xx*L_dot*c15*c50*k1, theta_dot, STEWART_FMA(-c173, c63, STEWART_FMA(-c157,
            c189, STEWART_FMA(REAL(2)*c110, -c20, STEWART_FMA(-W_z, c189,
            STEWART_FMA(gamma_n*inv_L*inv_k3*k1, w_z, STEWART_FMA(axial*c8*gamma_n*inv_L, w_x,
            STEWART_FMA(REAL(2)*J_xz*L_dot*c15*inv_k3, theta_dot, STEWART_FMA(-c186, c8,
            STEWART_FMA(c126*c2, -c69, STEWART_FMA(-axial, c186, STEWART_FMA(gamma_y*inv_L*inv_k3, w_y,
            STEWART_FMA(-c190, c191, STEWART_FMA(-c182, c79, STEWART_FMA(axial*fall_T_z*k1, m_u,
            STEWART_FMA(J_xz*c109, -c32, STEWART_FMA(REAL(2)*L_ddot*h_z*inv_L, k1, STEWART_FMA(fall_T_x*k3,
            -m_u, STEWART_FMA(-c170, c32, STEWART_FMA(L_ddot*c166, -inv_L, STEWART_FMA(L_ddot*c15*c194, k3,
            STEWART_FMA(C_us*c16, -inv_k3, STEWART_FMA(REAL(2)*J_xz*c3*c50*inv_L, k1, STEWART_FMA(-c188,
            c50, STEWART_FMA(-c164, c50, STEWART_FMA(axial*c158, -c92, STEWART_FMA(g_k*inv_L*k1*k3, w_x,
            STEWART_FMA(REAL(2)*c14*c50*h_z, k1, STEWART_FMA(REAL(4)*J_xz*c46*c47, k1,
            STEWART_FMA(REAL(2)*J_xz*c3*inv_L, k1, STEWART_FMA(-c154, c193, STEWART_FMA(axial*c14*c73*inv_L,
            -inv_k3, STEWART_FMA(c194*c3*inv_L, -k3, STEWART_FMA(-c171, c3, STEWART_FMA(c150*c46*c47, -k3,
            STEWART_FMA(REAL(2)*c15*c46*h_x, k3, STEWART_FMA(axial*c14*c73*inv_L, k3,
            STEWART_FMA(REAL(2)*J_xx*c46*c47, inv_k3, STEWART_FMA(REAL(2)*c3*h_x, k3,
            STEWART_FMA(c14*inv_L*k3, J_xx - J_yy, STEWART_FMA(c14*c165*inv_L, inv_k3, STEWART_FMA(-c144,
            c192, REAL(2)*J_xx*c138*c3*inv_L)))))))))))) - c164 - c188)))))))))))))))))))))))))))))))))))))))))))));
        const stewart_real c196 = J_xx*c146;
        const stewart_real c197 = c157*k1;
        const stewart_real c198 = J_xy*k3;
        const stewart_real c199 = c172*c20;
        const stewart_real c200 = REAL(2)*c181;
        const stewart_real c201 = c14*c50;
        const stewart_real c202 = c113*c197;
        const stewart_real tau_S_leg_33 = STEWART_FMA(-c128, c40, STEWART_FMA(-c177, c42, STEWART_FMA(c196,
            c50, STEWART_FMA(-c16, c202, STEWART_FMA(-c127, own_z, STEWART_FMA(c109*c147, -c50,
            STEWART_FMA(-J_xx, c162, STEWART_FMA(c172, c180, STEWART_FMA(-c16, c199, STEWART_FMA(c184, c88,
            STEWART_FMA(c137*k1, theta_dot, STEWART_FMA(-c136, c191, STEWART_FMA(c197, c78,
            STEWART_FMA(c174, c2, STEWART_FMA(c161, c170, STEWART_FMA(c130*c176, k1, STEWART_FMA(c114, k3,
            STEWART_FMA(-c198, c56, STEWART_FMA(-W_z, c142, STEWART_FMA(c116, k3, STEWART_FMA(c115, k3,
            STEWART_FMA(c148, c56, STEWART_FMA(c133, gamma_y, STEWART_FMA(c121, k3, STEWART_FMA(-c201, c54,
            STEWART_FMA(c152, c3, STEWART_FMA(c201, c99, STEWART_FMA(-c200, c48, c122*c177)))) - c151 + c135))))))
            - c120))))))))) - c124 - c140)) + c196)))))));
        /* derivatives of the generalized forces by the tip's motion */
        const stewart_real tau_S_xx = STEWART_FMA(tau_S_leg_12, y_x, STEWART_FMA(tau_S_leg_13, z_x,
            s_x*tau_S_leg_11));
        const stewart_real tau_S_xy = STEWART_FMA(tau_S_leg_12, y_y, STEWART_FMA(tau_S_leg_13, z_y,
            s_y*tau_S_leg_11));
        const stewart_real tau_S_xz = STEWART_FMA(tau_S_leg_12, y_z, STEWART_FMA(tau_S_leg_13, z_z,
            s_z*tau_S_leg_11));
        const stewart_real tau_S_yx = STEWART_FMA(tau_S_leg_22, y_x, STEWART_FMA(tau_S_leg_23, z_x,
            s_x*tau_S_leg_21));
        const stewart_real tau_S_yy = STEWART_FMA(tau_S_leg_22, y_y, STEWART_FMA(tau_S_leg_23, z_y,
            s_y*tau_S_leg_21));
        const stewart_real tau_S_yz = STEWART_FMA(tau_S_leg_22, y_z, STEWART_FMA(tau_S_leg_23, z_z,
            s_z*tau_S_leg_21));
        const stewart_real tau_S_zx = STEWART_FMA(tau_S_leg_32, y_x, STEWART_FMA(tau_S_leg_33, z_x,
            s_x*tau_S_leg_31));
        const stewart_real tau_S_zy = STEWART_FMA(tau_S_leg_32, y_y, STEWART_FMA(tau_S_leg_33, z_y,
            s_y*tau_S_leg_31));
        const stewart_real tau_S_zz = STEWART_FMA(tau_S_leg_32, y_z, STEWART_FMA(tau_S_leg_33, z_z,
            s_z*tau_S_leg_31));
        const stewart_real tau_S_dot_leg_11 = STEWART_FMA(c19, c70, C_p - c38);
        const stewart_real c203 = c109*c19;
        const stewart_real tau_S_dot_leg_12 = STEWART_FMA(c22, c36, STEWART_FMA(-W_z, c28,
            STEWART_FMA(c203*inv_k3, theta_dot, c16*c17)));
        const stewart_real tau_S_dot_leg_13 = STEWART_FMA(-c20, c203, STEWART_FMA(c27, c88, c16*c68));
        const stewart_real tau_S_dot_leg_21 = STEWART_FMA(-c70, c82, STEWART_FMA(-c152, c20,
            STEWART_FMA(-c80, c88, STEWART_FMA(REAL(2)*W_z*h_y*inv_k3, k1, -c69))));
        const stewart_real c204 = c109*c82;
        const stewart_real c205 = c204*theta_dot;
        const stewart_real tau_S_dot_leg_22 = STEWART_FMA(-c108, c153, STEWART_FMA(W_z*c155*inv_L*inv_k3,
            k1, STEWART_FMA(REAL(2)*W_z*c50, h_z, STEWART_FMA(REAL(4)*J_xz*W_z, inv_L,
            STEWART_FMA(REAL(2)*c50, -c89, STEWART_FMA(-c205, inv_k3, STEWART_FMA(REAL(2)*c50*h_y,
            theta_dot, STEWART_FMA(REAL(2)*J_xy*inv_L, theta_dot, STEWART_FMA(-c111, inv_k3,
            STEWART_FMA(REAL(2)*L_dot*h_y*inv_L*inv_k3, k1, -c104)) - c83))) - c136)))));
        const stewart_real c206 = c70*c98;
        const stewart_real tau_S_dot_leg_23 = STEWART_FMA(-c18, c50, STEWART_FMA(c206, c50, STEWART_FMA(c20,
            c204, c102 - c78 + c141 - c190 + c18))) - c206;
        const stewart_real tau_S_dot_leg_31 = STEWART_FMA(c130*c97, -k1, STEWART_FMA(-c192, c20,
            STEWART_FMA(REAL(2)*W_z*h_z, k1, STEWART_FMA(-c173, c37, W_z*c150*inv_L*k3) - c179 - c189)));
        const stewart_real tau_S_dot_leg_32 = STEWART_FMA(REAL(2)*J_yz*W_z*inv_L, k1,
            STEWART_FMA(REAL(2)*J_xy*W_z*inv_L, inv_k3, STEWART_FMA(-c18, inv_k3, STEWART_FMA(c113*c182,
            -c88, STEWART_FMA(-W_z, c178, STEWART_FMA(-c187, c88, STEWART_FMA(REAL(2)*h_z*inv_k3, theta_dot,
            STEWART_FMA(-c132, c53, STEWART_FMA(c113*c16, -inv_k3, STEWART_FMA(REAL(2)*L_dot*h_z*inv_L, k1,
            STEWART_FMA(-c166, c2, STEWART_FMA(L_dot*c15*c150, k3, C_us*inv_L*inv_k3))))))))))));
        const stewart_real tau_S_dot_leg_33 = STEWART_FMA(c199, inv_L, STEWART_FMA(c113*c157, c40,
            STEWART_FMA(REAL(2)*c198, c88, STEWART_FMA(c16, c200, c111) - c205))) - c174;
        /* derivatives of the generalized forces by the tip's motion */
        const stewart_real tau_S_dot_xx = STEWART_FMA(tau_S_dot_leg_12, y_x, STEWART_FMA(tau_S_dot_leg_13,
            z_x, s_x*tau_S_dot_leg_11));
        const stewart_real tau_S_dot_xy = STEWART_FMA(tau_S_dot_leg_12, y_y, STEWART_FMA(tau_S_dot_leg_13,
            z_y, s_y*tau_S_dot_leg_11));
        const stewart_real tau_S_dot_xz = STEWART_FMA(tau_S_dot_leg_12, y_z, STEWART_FMA(tau_S_dot_leg_13,
            z_z, s_z*tau_S_dot_leg_11));
        const stewart_real tau_S_dot_yx = STEWART_FMA(tau_S_dot_leg_22, y_x, STEWART_FMA(tau_S_dot_leg_23,
            z_x, s_x*tau_S_dot_leg_21));
        const stewart_real tau_S_dot_yy = STEWART_FMA(tau_S_dot_leg_22, y_y, STEWART_FMA(tau_S_dot_leg_23,
            z_y, s_y*tau_S_dot_leg_21));
        const stewart_real tau_S_dot_yz = STEWART_FMA(tau_S_dot_leg_22, y_z, STEWART_FMA(tau_S_dot_leg_23,
            z_z, s_z*tau_S_dot_leg_21));
        const stewart_real tau_S_dot_zx = STEWART_FMA(tau_S_dot_leg_32, y_x, STEWART_FMA(s_x,
            tau_S_dot_leg_31, tau_S_dot_leg_33*z_x));
        const stewart_real tau_S_dot_zy = STEWART_FMA(tau_S_dot_leg_32, y_y, STEWART_FMA(s_y,
            tau_S_dot_leg_31, tau_S_dot_leg_33*z_y));
        const stewart_real tau_S_dot_zz = STEWART_FMA(tau_S_dot_leg_32, y_z, STEWART_FMA(s_z,
            tau_S_dot_leg_31, tau_S_dot_leg_33*z_z));
        const stewart_real tau_S_ddot_leg_12 = -c19;
        const stewart_real tau_S_ddot_leg_13 = -c36;
        const stewart_real tau_S_ddot_leg_22 = c82 + c100 - c55;
        const stewart_real c207 = L*m_u;
        const stewart_real tau_S_ddot_leg_23 = -c27 - c86 - c207;
        const stewart_real c208 = h_y*k3;
        const stewart_real tau_S_ddot_leg_31 = -c208;
        const stewart_real tau_S_ddot_leg_32 = STEWART_FMA(c172, c40, STEWART_FMA(-c194, c91,
            STEWART_FMA(c207, k3, c166) + c171)) - c193;
        const stewart_real tau_S_ddot_leg_33 = STEWART_FMA(h_y, k1, -c173) - c99;
        /* derivatives of the generalized forces by the tip's motion */
        const stewart_real tau_S_ddot_xx = STEWART_FMA(tau_S_ddot_leg_12, y_x,
            STEWART_FMA(tau_S_ddot_leg_13, z_x, m_u*s_x));
        const stewart_real tau_S_ddot_xy = STEWART_FMA(tau_S_ddot_leg_12, y_y,
            STEWART_FMA(tau_S_ddot_leg_13, z_y, m_u*s_y));
        const stewart_real tau_S_ddot_xz = STEWART_FMA(tau_S_ddot_leg_12, y_z,
            STEWART_FMA(tau_S_ddot_leg_13, z_z, m_u*s_z));
        const stewart_real tau_S_ddot_yx = STEWART_FMA(tau_S_ddot_leg_22, y_x,
            STEWART_FMA(tau_S_ddot_leg_23, z_x, h_z*s_x));
        const stewart_real tau_S_ddot_yy = STEWART_FMA(tau_S_ddot_leg_22, y_y,
            STEWART_FMA(tau_S_ddot_leg_23, z_y, h_z*s_y));
        const stewart_real tau_S_ddot_yz = STEWART_FMA(tau_S_ddot_leg_22, y_z,
            STEWART_FMA(tau_S_ddot_leg_23, z_z, h_z*s_z));
        const stewart_real tau_S_ddot_zx = STEWART_FMA(tau_S_ddot_leg_32, y_x,
            STEWART_FMA(tau_S_ddot_leg_33, z_x, s_x*tau_S_ddot_leg_31));
        const stewart_real tau_S_ddot_zy = STEWART_FMA(tau_S_ddot_leg_32, y_y,
            STEWART_FMA(tau_S_ddot_leg_33, z_y, s_y*tau_S_ddot_leg_31));
        const stewart_real tau_S_ddot_zz = STEWART_FMA(tau_S_ddot_leg_32, y_z,
            STEWART_FMA(tau_S_ddot_leg_33, z_z, s_z*tau_S_ddot_leg_31));
        const stewart_real c209 = REAL(1) - axial;
        const stewart_real c210 = L*k1;
        const stewart_real c211 = STEWART_FMA(c209, STEWART_FMA(L*c109, -c42, STEWART_FMA(-J_xx, c185,
            STEWART_FMA(REAL(2)*J_xz*k1, own_z, STEWART_FMA(-c202, theta_dot,
            STEWART_FMA(REAL(2)*L*W_z*h_z*inv_k3, theta_dot, STEWART_FMA(J_xx*inv_k3, own_z,
            STEWART_FMA(-c210, c39, STEWART_FMA(-c175, c37, STEWART_FMA(-L_dot, c139, STEWART_FMA(J_yz*k3,
            own_y, STEWART_FMA(J_xy*k1, own_y, STEWART_FMA(L_dot*c37, -c54, STEWART_FMA(C_us*W_z, inv_k3,
            STEWART_FMA(-gamma_n, w_y, STEWART_FMA(gamma_y*k1, w_z, STEWART_FMA(-L_ddot, c208,
            STEWART_FMA(J_yz*c3, k1, STEWART_FMA(J_yz*c14, k1, STEWART_FMA(-L, c169, STEWART_FMA(-c198, c3,
            STEWART_FMA(-c14, c198, STEWART_FMA(L*c3*h_y, k3, STEWART_FMA(L*c14*h_y, k3, STEWART_FMA(-C_s,
            w_k_omega, J_xy*c14*inv_k3)))))))))))))))))))))))), axial*net_z);
        const stewart_real c212 = c211*inv_rho*inv_rho;
        const stewart_real bent_leg_12 = -c212*k3;
        const stewart_real c213 = J_xy*c63;
        const stewart_real c214 = STEWART_FMA(c209, STEWART_FMA(L*c55, -own_z, STEWART_FMA(c125, c134,
            STEWART_FMA(-c213, c50, STEWART_FMA(c148*c20, -c37, STEWART_FMA(J_yz, own_z, STEWART_FMA(-L,
            c84, STEWART_FMA(L, c105, STEWART_FMA(-C_s, w_y_omega, STEWART_FMA(c159, k3, STEWART_FMA(C_us,
            theta_dot, STEWART_FMA(-c158, w_z, STEWART_FMA(J_xx, c75, STEWART_FMA(REAL(2)*L, -c24,
            STEWART_FMA(L, c106, STEWART_FMA(-c50, c96, c107))))) + c61))) + c213))))))), axial*net_y);
        const stewart_real c215 = c15*c214;
        const stewart_real bent_leg_13 = c215;
        const stewart_real bent_leg_21 = -L*c215;
        const stewart_real bent_leg_22 = -c210*c212;
        const stewart_real bent_leg_23 = -L*inv_L*net_x;
        const stewart_real c216 = c211*c4*c91;
        const stewart_real bent_leg_31 = -c216;
        const stewart_real c217 = inv_rho*k3;
        const stewart_real bent_leg_32 = L*k3*STEWART_FMA(c214*c40, inv_rho, c217*net_x);
        const stewart_real bent_leg_33 = c216*kappa;
        /* derivative of the generalized forces by the tip's position, with the rotation of the rows */
        const stewart_real tau_place_xx = STEWART_FMA(bent_leg_12, y_x, STEWART_FMA(bent_leg_13, z_x,
            tau_S_xx));
        const stewart_real tau_place_xy = STEWART_FMA(bent_leg_12, y_y, STEWART_FMA(bent_leg_13, z_y,
            tau_S_xy));
        const stewart_real tau_place_xz = STEWART_FMA(bent_leg_12, y_z, STEWART_FMA(bent_leg_13, z_z,
            tau_S_xz));
        const stewart_real tau_place_yx = STEWART_FMA(bent_leg_22, y_x, STEWART_FMA(bent_leg_21, s_x,
            bent_leg_23*z_x)) + tau_S_yx;
        const stewart_real tau_place_yy = STEWART_FMA(bent_leg_22, y_y, STEWART_FMA(bent_leg_21, s_y,
            bent_leg_23*z_y)) + tau_S_yy;
        const stewart_real tau_place_yz = STEWART_FMA(bent_leg_22, y_z, STEWART_FMA(bent_leg_21, s_z,
            bent_leg_23*z_z)) + tau_S_yz;
        const stewart_real tau_place_zx = STEWART_FMA(bent_leg_33, z_x, STEWART_FMA(bent_leg_31, s_x,
            bent_leg_32*y_x)) + tau_S_zx;
        const stewart_real tau_place_zy = STEWART_FMA(bent_leg_33, z_y, STEWART_FMA(bent_leg_31, s_y,
            bent_leg_32*y_y)) + tau_S_zy;
        const stewart_real tau_place_zz = STEWART_FMA(bent_leg_33, z_z, STEWART_FMA(bent_leg_31, s_z,
            bent_leg_32*y_z)) + tau_S_zz;
        const stewart_real X_xx = STEWART_FMA(omega_y, -tau_S_dot_xz, STEWART_FMA(omega_z, tau_S_dot_xy,
            STEWART_FMA(B_zx, tau_S_ddot_xz, STEWART_FMA(B_yx, tau_S_ddot_xy, B_xx*tau_S_ddot_xx)))) + tau_place_xx;
        const stewart_real X_xy = STEWART_FMA(omega_z, -tau_S_dot_xx, STEWART_FMA(omega_x, tau_S_dot_xz,
            STEWART_FMA(B_zy, tau_S_ddot_xz, STEWART_FMA(B_yy, tau_S_ddot_xy, B_xy*tau_S_ddot_xx)))) + tau_place_xy;
        const stewart_real X_xz = STEWART_FMA(omega_x, -tau_S_dot_xy, STEWART_FMA(omega_y, tau_S_dot_xx,
            STEWART_FMA(B_zz, tau_S_ddot_xz, STEWART_FMA(B_yz, tau_S_ddot_xy, B_xz*tau_S_ddot_xx)))) + tau_place_xz;
        const stewart_real X_yx = STEWART_FMA(omega_y, -tau_S_dot_yz, STEWART_FMA(omega_z, tau_S_dot_yy,
            STEWART_FMA(B_zx, tau_S_ddot_yz, STEWART_FMA(B_yx, tau_S_ddot_yy, B_xx*tau_S_ddot_yx)))) + tau_place_yx;
        const stewart_real X_yy = STEWART_FMA(omega_z, -tau_S_dot_yx, STEWART_FMA(omega_x, tau_S_dot_yz,
            STEWART_FMA(B_zy, tau_S_ddot_yz, STEWART_FMA(B_yy, tau_S_ddot_yy, B_xy*tau_S_ddot_yx)))) + tau_place_yy;
        const stewart_real X_yz = STEWART_FMA(omega_x, -tau_S_dot_yy, STEWART_FMA(omega_y, tau_S_dot_yx,
            STEWART_FMA(B_zz, tau_S_ddot_yz, STEWART_FMA(B_yz, tau_S_ddot_yy, B_xz*tau_S_ddot_yx)))) + tau_place_yz;
        const stewart_real X_zx = STEWART_FMA(omega_y, -tau_S_dot_zz, STEWART_FMA(omega_z, tau_S_dot_zy,
            STEWART_FMA(B_zx, tau_S_ddot_zz, STEWART_FMA(B_yx, tau_S_ddot_zy, B_xx*tau_S_ddot_zx)))) + tau_place_zx;
        const stewart_real X_zy = STEWART_FMA(omega_z, -tau_S_dot_zx, STEWART_FMA(omega_x, tau_S_dot_zz,
            STEWART_FMA(B_zy, tau_S_ddot_zz, STEWART_FMA(B_yy, tau_S_ddot_zy, B_xy*tau_S_ddot_zx)))) + tau_place_zy;
        const stewart_real X_zz = STEWART_FMA(omega_x, -tau_S_dot_zy, STEWART_FMA(omega_y, tau_S_dot_zx,
            STEWART_FMA(B_zz, tau_S_ddot_zz, STEWART_FMA(B_yz, tau_S_ddot_zy, B_xz*tau_S_ddot_zx)))) + tau_place_zz;
        const stewart_real Y_xx = STEWART_FMA(omega_y, -tau_S_ddot_xz, omega_z*tau_S_ddot_xy) + tau_S_dot_xx;
        const stewart_real Y_xy = STEWART_FMA(omega_z, -tau_S_ddot_xx, omega_x*tau_S_ddot_xz) + tau_S_dot_xy;
        const stewart_real Y_xz = STEWART_FMA(omega_x, -tau_S_ddot_xy, omega_y*tau_S_ddot_xx) + tau_S_dot_xz;
        const stewart_real Y_yx = STEWART_FMA(omega_y, -tau_S_ddot_yz, omega_z*tau_S_ddot_yy) + tau_S_dot_yx;
        const stewart_real Y_yy = STEWART_FMA(omega_z, -tau_S_ddot_yx, omega_x*tau_S_ddot_yz) + tau_S_dot_yy;
        const stewart_real Y_yz = STEWART_FMA(omega_x, -tau_S_ddot_yy, omega_y*tau_S_ddot_yx) + tau_S_dot_yz;
        const stewart_real Y_zx = STEWART_FMA(omega_y, -tau_S_ddot_zz, omega_z*tau_S_ddot_zy) + tau_S_dot_zx;
        const stewart_real Y_zy = STEWART_FMA(omega_z, -tau_S_ddot_zx, omega_x*tau_S_ddot_zz) + tau_S_dot_zy;
        const stewart_real Y_zz = STEWART_FMA(omega_x, -tau_S_ddot_zy, omega_y*tau_S_ddot_zx) + tau_S_dot_zz;
        const stewart_real G_dot_21 = -c88;
        const stewart_real c218 = k1*phi_dot;
        const stewart_real G_dot_22 = c218*inv_L;
        const stewart_real G_dot_23 = c16;
        const stewart_real G_dot_31 = -c217*phi_dot;
        const stewart_real G_dot_32 = STEWART_FMA(inv_rho*kappa, -theta_dot, -c2*inv_rho);
        const stewart_real G_dot_33 = c218*inv_rho;
        /* slope of a rate, times C_s */
        const stewart_real theta_dot_by_S_x = C_s*STEWART_FMA(G_dot_22, y_x, STEWART_FMA(G_dot_21, s_x,
            G_dot_23*z_x));
        const stewart_real theta_dot_by_S_y = C_s*STEWART_FMA(G_dot_22, y_y, STEWART_FMA(G_dot_21, s_y,
            G_dot_23*z_y));
        const stewart_real theta_dot_by_S_z = C_s*STEWART_FMA(G_dot_22, y_z, STEWART_FMA(G_dot_21, s_z,
            G_dot_23*z_z));
        const stewart_real phi_dot_by_S_x = C_s*STEWART_FMA(G_dot_33, z_x, STEWART_FMA(G_dot_32, y_x,
            G_dot_31*s_x));
        const stewart_real phi_dot_by_S_y = C_s*STEWART_FMA(G_dot_33, z_y, STEWART_FMA(G_dot_32, y_y,
            G_dot_31*s_y));
        const stewart_real phi_dot_by_S_z = C_s*STEWART_FMA(G_dot_33, z_z, STEWART_FMA(G_dot_32, y_z,
            G_dot_31*s_z));
        /* gradient of theta, times C_s */
        const stewart_real C_s_theta_x = -c118*z_x;
        const stewart_real C_s_theta_y = -c118*z_y;
        const stewart_real C_s_theta_z = -c118*z_z;
        const stewart_real c219 = C_s*y_x;
        const stewart_real c220 = C_s*y_y;
        const stewart_real c221 = C_s*y_z;
        /* gradient of phi, times C_s */
        const stewart_real C_s_phi_x = c219*inv_rho;
        const stewart_real C_s_phi_y = c220*inv_rho;
        const stewart_real C_s_phi_z = c221*inv_rho;
        const stewart_real y_by_phi_x = normal_x*theta_dot;
        const stewart_real y_by_phi_y = normal_y*theta_dot;
        const stewart_real y_by_phi_z = normal_z*theta_dot;
        /* friction moment by S */
        const stewart_real f_S_xx = STEWART_FMA(k_x, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_x,
            C_s_phi_x*y_by_phi_x));
        const stewart_real f_S_xy = STEWART_FMA(k_x, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_x,
            C_s_phi_y*y_by_phi_x));
        const stewart_real f_S_xz = STEWART_FMA(k_x, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_x,
            C_s_phi_z*y_by_phi_x));
        const stewart_real f_S_yx = STEWART_FMA(k_y, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_y,
            C_s_phi_x*y_by_phi_y));
        const stewart_real f_S_yy = STEWART_FMA(k_y, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_y,
            C_s_phi_y*y_by_phi_y));
        const stewart_real f_S_yz = STEWART_FMA(k_y, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_y,
            C_s_phi_z*y_by_phi_y));
        const stewart_real f_S_zx = STEWART_FMA(k_z, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_z,
            C_s_phi_x*y_by_phi_z));
        const stewart_real f_S_zy = STEWART_FMA(k_z, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_z,
            C_s_phi_y*y_by_phi_z));
        const stewart_real f_S_zz = STEWART_FMA(k_z, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_z,
            C_s_phi_z*y_by_phi_z));
        /* friction moment by S_dot */
        const stewart_real f_S_dot_xx = STEWART_FMA(C_s_phi_x, k_x, C_s_theta_x*y_x);
        const stewart_real f_S_dot_xy = STEWART_FMA(C_s_phi_y, k_x, C_s_theta_y*y_x);
        const stewart_real f_S_dot_xz = STEWART_FMA(C_s_phi_z, k_x, C_s_theta_z*y_x);
        const stewart_real f_S_dot_yx = STEWART_FMA(C_s_phi_x, k_y, C_s_theta_x*y_y);
        const stewart_real f_S_dot_yy = STEWART_FMA(C_s_phi_y, k_y, C_s_theta_y*y_y);
        const stewart_real f_S_dot_yz = STEWART_FMA(C_s_phi_z, k_y, C_s_theta_z*y_y);
        const stewart_real f_S_dot_zx = STEWART_FMA(C_s_phi_x, k_z, C_s_theta_x*y_z);
        const stewart_real f_S_dot_zy = STEWART_FMA(C_s_phi_y, k_z, C_s_theta_y*y_z);
        const stewart_real f_S_dot_zz = STEWART_FMA(C_s_phi_z, k_z, C_s_theta_z*y_z);
        const stewart_real c225 = STEWART_FMA(-f_S_dot_xy, omega_x, STEWART_FMA(f_S_dot_xx, omega_y,
            R_tip_y)) + f_S_xz;
        const stewart_real c226 = STEWART_FMA(-f_S_dot_xx, omega_z, STEWART_FMA(f_S_dot_xz, omega_x,
            -R_tip_z)) + f_S_xy;
        const stewart_real c227 = STEWART_FMA(-f_S_dot_xz, omega_y, f_S_dot_xy*omega_z) + f_S_xx;
        const stewart_real c228 = STEWART_FMA(-f_S_dot_yx, omega_z, f_S_dot_yz*omega_x) + f_S_yy;
        const stewart_real c229 = STEWART_FMA(-f_S_dot_yy, omega_x, STEWART_FMA(f_S_dot_yx, omega_y,
            -R_tip_x)) + f_S_yz;
        const stewart_real c230 = STEWART_FMA(-f_S_dot_yz, omega_y, STEWART_FMA(f_S_dot_yy, omega_z,
            R_tip_z)) + f_S_yx;
        const stewart_real c231 = STEWART_FMA(-f_S_dot_zy, omega_x, f_S_dot_zx*omega_y) + f_S_zz;
        const stewart_real c232 = STEWART_FMA(-f_S_dot_zx, omega_z, STEWART_FMA(f_S_dot_zz, omega_x,
            R_tip_x)) + f_S_zy;
        const stewart_real c233 = STEWART_FMA(-f_S_dot_zz, omega_y, STEWART_FMA(f_S_dot_zy, omega_z,
            -R_tip_y)) + f_S_zx;
        out->sum[0][l] = REAL(0);
        out->sum[1][l] = REAL(0);
        out->sum[2][l] = REAL(0);
        out->sum[3][l] = REAL(0);
        out->sum[4][l] = REAL(0);
        out->sum[5][l] = REAL(0);
        out->sum[6][l] = REAL(0);
        out->sum[7][l] = REAL(0);
        out->sum[8][l] = REAL(0);
        out->sum[9][l] = REAL(0);
        out->sum[10][l] = REAL(0);
        out->sum[11][l] = REAL(0);
        out->sum[12][l] = REAL(0);
        out->sum[13][l] = REAL(0);
        out->sum[14][l] = REAL(0);
        out->sum[15][l] = REAL(0);
        out->sum[16][l] = REAL(0);
        out->sum[17][l] = REAL(0);
        out->sum[18][l] = REAL(0);
        out->sum[19][l] = REAL(0);
        out->sum[20][l] = REAL(0);
        out->sum[21][l] = REAL(0);
        out->sum[22][l] = REAL(0);
        out->sum[23][l] = REAL(0);
        out->sum[24][l] = REAL(0);
        out->sum[25][l] = REAL(0);
        out->sum[26][l] = REAL(0);
        out->sum[27][l] = REAL(0);
        out->sum[28][l] = REAL(0);
        out->sum[29][l] = REAL(0);
        out->sum[30][l] = REAL(0);
        out->sum[31][l] = REAL(0);
        out->sum[32][l] = REAL(0);
        out->sum[33][l] = REAL(0);
        out->sum[34][l] = REAL(0);
        out->sum[35][l] = REAL(0);
        out->sum[36][l] = REAL(0);
        out->sum[37][l] = REAL(0);
        out->sum[38][l] = REAL(0);
        out->sum[39][l] = -f_S_xx;
        out->sum[40][l] = -f_S_xy;
        out->sum[41][l] = -f_S_xz;
        out->sum[42][l] = STEWART_FMA(-c225, q_y, c226*q_z);
        out->sum[43][l] = STEWART_FMA(-c227, q_z, c225*q_x);
        out->sum[44][l] = STEWART_FMA(-c226, q_x, c227*q_y);
        out->sum[45][l] = -f_S_yx;
        out->sum[46][l] = -f_S_yy;
        out->sum[47][l] = -f_S_yz;
        out->sum[48][l] = STEWART_FMA(-c229, q_y, c228*q_z);
        out->sum[49][l] = STEWART_FMA(-c230, q_z, c229*q_x);
        out->sum[50][l] = STEWART_FMA(-c228, q_x, c230*q_y);
        out->sum[51][l] = -f_S_zx;
        out->sum[52][l] = -f_S_zy;
        out->sum[53][l] = -f_S_zz;
        out->sum[54][l] = STEWART_FMA(-c231, q_y, c232*q_z);
        out->sum[55][l] = STEWART_FMA(-c233, q_z, c231*q_x);
        out->sum[56][l] = STEWART_FMA(-c232, q_x, c233*q_y);
        out->sum[57][l] = REAL(0);
        out->sum[58][l] = REAL(0);
        out->sum[59][l] = REAL(0);
        out->sum[60][l] = REAL(0);
        out->sum[61][l] = REAL(0);
        out->sum[62][l] = REAL(0);
        out->sum[63][l] = REAL(0);
        out->sum[64][l] = REAL(0);
        out->sum[65][l] = REAL(0);
        out->sum[66][l] = REAL(0);
        out->sum[67][l] = REAL(0);
        out->sum[68][l] = REAL(0);
        out->sum[69][l] = REAL(0);
        out->sum[70][l] = REAL(0);
        out->sum[71][l] = REAL(0);
        out->sum[72][l] = REAL(0);
        out->sum[73][l] = REAL(0);
        out->sum[74][l] = REAL(0);
        out->sum[75][l] = -f_S_dot_xx;
        out->sum[76][l] = -f_S_dot_xy;
        out->sum[77][l] = -f_S_dot_xz;
        out->sum[78][l] = STEWART_FMA(-f_S_dot_xz, q_y, f_S_dot_xy*q_z);
        out->sum[79][l] = STEWART_FMA(-f_S_dot_xx, q_z, f_S_dot_xz*q_x);
        out->sum[80][l] = STEWART_FMA(-f_S_dot_xy, q_x, f_S_dot_xx*q_y);
        out->sum[81][l] = -f_S_dot_yx;
        out->sum[82][l] = -f_S_dot_yy;
        out->sum[83][l] = -f_S_dot_yz;
        out->sum[84][l] = STEWART_FMA(-f_S_dot_yz, q_y, f_S_dot_yy*q_z);
        out->sum[85][l] = STEWART_FMA(-f_S_dot_yx, q_z, f_S_dot_yz*q_x);
        out->sum[86][l] = STEWART_FMA(-f_S_dot_yy, q_x, f_S_dot_yx*q_y);
        out->sum[87][l] = -f_S_dot_zx;
        out->sum[88][l] = -f_S_dot_zy;
        out->sum[89][l] = -f_S_dot_zz;
        out->sum[90][l] = STEWART_FMA(-f_S_dot_zz, q_y, f_S_dot_zy*q_z);
        out->sum[91][l] = STEWART_FMA(-f_S_dot_zx, q_z, f_S_dot_zz*q_x);
        out->sum[92][l] = STEWART_FMA(-f_S_dot_zy, q_x, f_S_dot_zx*q_y);
        out->tau_t[0][l] = tau_place_xx;
        out->tau_t[1][l] = tau_place_xy;
        out->tau_t[2][l] = tau_place_xz;
        out->tau_t[3][l] = tau_place_yx;
        out->tau_t[4][l] = tau_place_yy;
        out->tau_t[5][l] = tau_place_yz;
        out->tau_t[6][l] = tau_place_zx;
        out->tau_t[7][l] = tau_place_zy;
        out->tau_t[8][l] = tau_place_zz;
        out->tau_r[0][l] = STEWART_FMA(-X_xy, q_z, X_xz*q_y);
        out->tau_r[1][l] = STEWART_FMA(-X_xz, q_x, X_xx*q_z);
        out->tau_r[2][l] = STEWART_FMA(-X_xx, q_y, X_xy*q_x);
        out->tau_r[3][l] = STEWART_FMA(-X_yy, q_z, X_yz*q_y);
        out->tau_r[4][l] = STEWART_FMA(-X_yz, q_x, X_yx*q_z);
        out->tau_r[5][l] = STEWART_FMA(-X_yx, q_y, X_yy*q_x);
        out->tau_r[6][l] = STEWART_FMA(-X_zy, q_z, X_zz*q_y);
        out->tau_r[7][l] = STEWART_FMA(-X_zz, q_x, X_zx*q_z);
        out->tau_r[8][l] = STEWART_FMA(-X_zx, q_y, X_zy*q_x);
        out->tau_v[0][l] = tau_S_dot_xx;
        out->tau_v[1][l] = tau_S_dot_xy;
        out->tau_v[2][l] = tau_S_dot_xz;
        out->tau_v[3][l] = tau_S_dot_yx;
        out->tau_v[4][l] = tau_S_dot_yy;
        out->tau_v[5][l] = tau_S_dot_yz;
        out->tau_v[6][l] = tau_S_dot_zx;
        out->tau_v[7][l] = tau_S_dot_zy;
        out->tau_v[8][l] = tau_S_dot_zz;
        out->tau_w[0][l] = STEWART_FMA(-tau_S_ddot_xy, w_q_z, STEWART_FMA(-Y_xy, q_z,
            STEWART_FMA(tau_S_ddot_xz, w_q_y, Y_xz*q_y)));
        out->tau_w[1][l] = STEWART_FMA(-tau_S_ddot_xz, w_q_x, STEWART_FMA(-Y_xz, q_x,
            STEWART_FMA(tau_S_ddot_xx, w_q_z, Y_xx*q_z)));
        out->tau_w[2][l] = STEWART_FMA(-tau_S_ddot_xx, w_q_y, STEWART_FMA(-Y_xx, q_y,
            STEWART_FMA(tau_S_ddot_xy, w_q_x, Y_xy*q_x)));
        out->tau_w[3][l] = STEWART_FMA(-tau_S_ddot_yy, w_q_z, STEWART_FMA(-Y_yy, q_z,
            STEWART_FMA(tau_S_ddot_yz, w_q_y, Y_yz*q_y) - c219));
        out->tau_w[4][l] = STEWART_FMA(-tau_S_ddot_yz, w_q_x, STEWART_FMA(-Y_yz, q_x,
            STEWART_FMA(tau_S_ddot_yx, w_q_z, Y_yx*q_z) - c220));
        out->tau_w[5][l] = STEWART_FMA(-tau_S_ddot_yx, w_q_y, STEWART_FMA(-Y_yx, q_y,
            STEWART_FMA(tau_S_ddot_yy, w_q_x, Y_yy*q_x) - c221));
        out->tau_w[6][l] = STEWART_FMA(-tau_S_ddot_zy, w_q_z, STEWART_FMA(-Y_zy, q_z, STEWART_FMA(-C_s, k_x,
            STEWART_FMA(tau_S_ddot_zz, w_q_y, Y_zz*q_y))));
        out->tau_w[7][l] = STEWART_FMA(-tau_S_ddot_zz, w_q_x, STEWART_FMA(-Y_zz, q_x, STEWART_FMA(-C_s, k_y,
            STEWART_FMA(tau_S_ddot_zx, w_q_z, Y_zx*q_z))));
        out->tau_w[8][l] = STEWART_FMA(-tau_S_ddot_zx, w_q_y, STEWART_FMA(-Y_zx, q_y, STEWART_FMA(-C_s, k_z,
            STEWART_FMA(tau_S_ddot_zy, w_q_x, Y_zy*q_x))));
        out->H_force[0][l] = s_x;
        out->H_force[1][l] = s_y;
        out->H_force[2][l] = s_z;
        out->H_moment[0][l] = STEWART_FMA(-q_z, s_y, q_y*s_z);
        out->H_moment[1][l] = STEWART_FMA(-q_x, s_z, q_z*s_x);
        out->H_moment[2][l] = STEWART_FMA(-q_y, s_x, q_x*s_y);
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* Computes the sums over platform and legs; ``status`` is the status of the legs. */
static void joint_slopes_sums(
    const stewart_exact_model *model, const stewart_motion *motion, joint_slopes_legs *legs,
    stewart_real summed[93])
{
    int l;
    motion_in_lanes at;
    joint_slopes_pose pose;
    at.R[0][0] = motion->R[0];
    at.R[1][0] = motion->R[1];
    at.R[2][0] = motion->R[2];
    at.R[3][0] = motion->R[3];
    at.R[4][0] = motion->R[4];
    at.R[5][0] = motion->R[5];
    at.R[6][0] = motion->R[6];
    at.R[7][0] = motion->R[7];
    at.R[8][0] = motion->R[8];
    at.omega[0][0] = motion->omega[0];
    at.omega[1][0] = motion->omega[1];
    at.omega[2][0] = motion->omega[2];
    at.alpha[0][0] = motion->alpha[0];
    at.alpha[1][0] = motion->alpha[1];
    at.alpha[2][0] = motion->alpha[2];
    at.a[0][0] = motion->a[0];
    at.a[1][0] = motion->a[1];
    at.a[2][0] = motion->a[2];
    at.F_ext[0][0] = motion->F_ext[0];
    at.F_ext[1][0] = motion->F_ext[1];
    at.F_ext[2][0] = motion->F_ext[2];
    at.M_ext[0][0] = motion->M_ext[0];
    at.M_ext[1][0] = motion->M_ext[1];
    at.M_ext[2][0] = motion->M_ext[2];
    joint_slopes_of_pose(model, &at, 1, &pose, summed);
    for (l = 6; l < 8; ++l) {
        legs->net[0][l] = legs->net[0][5];
        legs->net[1][l] = legs->net[1][5];
        legs->net[2][l] = legs->net[2][5];
        legs->turned[0][l] = legs->turned[0][5];
        legs->turned[1][l] = legs->turned[1][5];
        legs->turned[2][l] = legs->turned[2][5];
        legs->axial[l] = legs->axial[5];
    }
    joint_slopes_of_leg(model, motion, &pose, legs);
    legs->status = legs_status(&legs->checked);
    if (legs->status == STEWART_OK) {
        add_legs(legs->sum, 93, summed);
    }
}

/* M^-1 times the derivatives of the wrench and H, columns 6 to 23 of A, as ``forward_apart`` solves. */
static slopes_found slopes_apart(
    const stewart_exact_model *model, const stewart_motion *motion, const stewart_motion *moving,
    const stewart_real F[6])
{
    int c, i, j, k;
    slopes_found out;
    rows by;
    joint_slopes_legs legs;
    stewart_real summed[93];
    stewart_real start[6];
    stewart_real starts[18][6];
    stewart_real force[24];
    STEWART_ALIGNED stewart_real forces_by[432] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    stewart_real wrench[6];
    stewart_real held[6];
    stewart_real rest[24];
    stewart_real right[6];
    const apart_found apart = forward_apart(model, motion, F, &by);
    for (i = 0; i < 6; ++i) {
        out.x[i] = apart.x[i];
        legs.axial[i] = by.given[i].axial;
        for (j = 0; j < 3; ++j) {
            legs.net[j][i] = by.given[i].net[j];
            legs.turned[j][i] = by.given[i].turned[j];
        }
    }
    joint_slopes_sums(model, moving, &legs, summed);
    place_blocks_24(&summed[21], &summed[24], &summed[39], &summed[42], 6, out.A);
    place_blocks_24(&summed[57], &summed[60], &summed[75], &summed[78], 12, out.A);
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 6; ++j) {
            out.A[24*i + (j + 18)] = legs.H_force[i][j];
            out.A[24*(i + 3) + (j + 18)] = legs.H_moment[i][j];
        }
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            out.A[24*i + j] = by.inertia[6*i + j];
        }
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            for (k = 0; k < 3; ++k) {
                forces_by[24*k + (3*i + j)] = (-legs.tau_t[3*j + k][i])/by.extent[3*i + j];
                forces_by[24*(k + 3) + (3*i + j)] = (-legs.tau_r[3*j + k][i])/by.extent[3*i + j];
                forces_by[24*(k + 6) + (3*i + j)] = (-legs.tau_v[3*j + k][i])/by.extent[3*i + j];
                forces_by[24*(k + 9) + (3*i + j)] = (-legs.tau_w[3*j + k][i])/by.extent[3*i + j];
            }
        }
    }
    for (c = 0; c < 18; ++c) {
        for (i = 0; i < 24; ++i) {
            force[i] = forces_by[24*c + i];
        }
        for (i = 0; i < 6; ++i) {
            wrench[i] = out.A[24*i + (c + 6)];
        }
        by_rows(&by, wrench, held);
        row_right(&by, force, held, start, rest, right);
        for (i = 0; i < 6; ++i) {
            starts[c][i] = start[i];
            out.A[24*i + (c + 6)] = right[i];
        }
    }
    const int fault = solve_definite_24(out.A, STEWART_ROUNDING);
    for (c = 0; c < 18; ++c) {
        for (i = 0; i < 6; ++i) {
            right[i] = out.A[24*i + (c + 6)];
            start[i] = starts[c][i];
        }
        row_back(&by, right, start, wrench);
        for (i = 0; i < 6; ++i) {
            out.A[24*i + (c + 6)] = wrench[i];
        }
    }
    out.status = apart.status == STEWART_OK ? (legs.status == STEWART_OK ? fault : legs.status) : apart.status;
    return out;
}

/* Forward dynamics, and d/dt [dt; dphi; dv; domega] = A [dt; dphi; dv; domega] + B dF about it. */
static void find_linearization(
    const stewart_exact_model *model, const stewart_motion *motion, const stewart_real F[6],
    linearization_found *out)
{
    int i, j;
    derivatives_legs legs;
    stewart_real summed[93];
    STEWART_ALIGNED stewart_real A[144];
    forward_dynamics_found moved;
    find_forward_dynamics(model, motion, F, &moved);
    const int status = moved.status;
    const stewart_motion moving = with_acceleration(motion, &moved.acceleration[0], &moved.acceleration[3]);
    for (i = 0; i < 6; ++i) {
        legs.F[i] = F[i];
    }
    derivatives_sums(model, &moving, &legs, summed);
    place_inertia_24(&summed[0], &summed[6], &summed[15], 0, A);
    place_blocks_24(&summed[21], &summed[24], &summed[39], &summed[42], 6, A);
    place_blocks_24(&summed[57], &summed[60], &summed[75], &summed[78], 12, A);
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 6; ++j) {
            A[24*i + (j + 18)] = legs.H_force[i][j];
            A[24*(i + 3) + (j + 18)] = legs.H_moment[i][j];
        }
    }
    int fault = solve_definite_24(A, STEWART_KEPT);
    if (status == STEWART_OK && fault == STEWART_MASS_MATRIX_INDEFINITE) {
        const slopes_found apart = slopes_apart(model, motion, &moving, F);
        for (i = 0; i < 6; ++i) {
            for (j = 6; j < 24; ++j) {
                A[24*i + j] = apart.A[24*i + j];
            }
        }
        for (i = 0; i < 3; ++i) {
            moved.acceleration[i] = apart.x[i];
            moved.acceleration[3 + i] = apart.x[i + 3];
        }
        fault = apart.status;
    }
    for (i = 0; i < 3; ++i) {
        out->of.acceleration[i] = moved.acceleration[i];
        out->of.acceleration[3 + i] = moved.acceleration[3 + i];
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 12; ++j) {
            out->of.A[12*i + j] = REAL(0);
            out->of.A[12*(i + 6) + j] = -A[24*i + (j + 6)];
        }
        for (j = 0; j < 6; ++j) {
            out->of.B[6*i + j] = REAL(0);
            out->of.B[6*(i + 6) + j] = A[24*i + (j + 18)];
        }
        out->of.A[12*i + (i + 6)] = REAL(1);
    }
    out->of.A[40] = -motion->omega[2];
    out->of.A[41] = motion->omega[1];
    out->of.A[51] = motion->omega[2];
    out->of.A[53] = -motion->omega[0];
    out->of.A[63] = -motion->omega[1];
    out->of.A[64] = motion->omega[0];
    out->status = status == STEWART_OK ? fault : status;
    check_linearization(out);
}

int stewart_exact_linearization(
    const stewart_exact_model *model, const stewart_motion *motion, const stewart_real F[6],
    stewart_linearization *out)
{
    linearization_found found;
    if (model == NULL || motion == NULL || F == NULL || out == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    find_linearization(model, motion, F, &found);
    if (found.status == STEWART_OK) {
        *out = found.of;
    }
    return found.status;
}

typedef struct {
    stewart_real B_0[9][LANES];
} STEWART_ALIGNED bias_pose;

typedef struct {
    stewart_real sum[6][LANES];
    leg_checks checked;
    int status;
} STEWART_ALIGNED bias_legs;

/* Computes the terms of the platform, for one pose or eight. */
static STEWART_INLINE void bias_of_pose(
    const stewart_exact_model *STEWART_RESTRICT model, const motion_in_lanes *STEWART_RESTRICT at,
    int lanes, bias_pose *STEWART_RESTRICT out, stewart_real *STEWART_RESTRICT summed)
{
    int l;
    const stewart_real M_P = model->M_P;
    const stewart_real h_P_x = model->h_P[0], h_P_y = model->h_P[1], h_P_z = model->h_P[2];
    const stewart_real J_P_xx = model->J_P[0], J_P_xy = model->J_P[1], J_P_xz = model->J_P[2], J_P_yy = model->J_P[3],
        J_P_yz = model->J_P[4], J_P_zz = model->J_P[5];
    const stewart_real C_P = model->C_P;
    const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
    for (l = 0; l < lanes; ++l) {
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        /* (30) first moment of the platform, base frame */
        const stewart_real h_base_x = STEWART_FMA(R_xz, h_P_z, STEWART_FMA(R_xy, h_P_y, R_xx*h_P_x));
        const stewart_real h_base_y = STEWART_FMA(R_yz, h_P_z, STEWART_FMA(R_yy, h_P_y, R_yx*h_P_x));
        const stewart_real h_base_z = STEWART_FMA(R_zz, h_P_z, STEWART_FMA(R_zy, h_P_y, R_zx*h_P_x));
        const stewart_real c1 = STEWART_FMA(J_P_xz, R_xz, STEWART_FMA(J_P_xy, R_xy, J_P_xx*R_xx));
        const stewart_real c2 = STEWART_FMA(J_P_yz, R_xz, STEWART_FMA(J_P_yy, R_xy, J_P_xy*R_xx));
        const stewart_real c3 = STEWART_FMA(J_P_zz, R_xz, STEWART_FMA(J_P_yz, R_xy, J_P_xz*R_xx));
        const stewart_real c4 = STEWART_FMA(J_P_xz, R_yz, STEWART_FMA(J_P_xy, R_yy, J_P_xx*R_yx));
        const stewart_real c5 = STEWART_FMA(J_P_yz, R_yz, STEWART_FMA(J_P_yy, R_yy, J_P_xy*R_yx));
        const stewart_real c6 = STEWART_FMA(J_P_zz, R_yz, STEWART_FMA(J_P_yz, R_yy, J_P_xz*R_yx));
        /* (32) inertia of the platform, base frame */
        const stewart_real J_base_xx = STEWART_FMA(R_xz, c3, STEWART_FMA(R_xy, c2, R_xx*c1));
        const stewart_real J_base_xy = STEWART_FMA(R_yz, c3, STEWART_FMA(R_yy, c2, R_yx*c1));
        const stewart_real J_base_xz = STEWART_FMA(R_zz, c3, STEWART_FMA(R_zy, c2, R_zx*c1));
        const stewart_real J_base_yy = STEWART_FMA(R_yz, c6, STEWART_FMA(R_yy, c5, R_yx*c4));
        const stewart_real J_base_yz = STEWART_FMA(R_zz, c6, STEWART_FMA(R_zy, c5, R_zx*c4));
        const stewart_real J_base_zz = STEWART_FMA(R_zz, STEWART_FMA(J_P_zz, R_zz, STEWART_FMA(J_P_yz, R_zy,
            J_P_xz*R_zx)), STEWART_FMA(R_zy, STEWART_FMA(J_P_yz, R_zz, STEWART_FMA(J_P_yy, R_zy,
            J_P_xy*R_zx)), R_zx*STEWART_FMA(J_P_xz, R_zz, STEWART_FMA(J_P_xy, R_zy, J_P_xx*R_zx))));
        /* (31) omega x h */
        const stewart_real w_h_x = STEWART_FMA(-h_base_y, omega_z, h_base_z*omega_y);
        const stewart_real w_h_y = STEWART_FMA(-h_base_z, omega_x, h_base_x*omega_z);
        const stewart_real w_h_z = STEWART_FMA(-h_base_x, omega_y, h_base_y*omega_x);
        /* (34) I omega */
        const stewart_real J_w_x = STEWART_FMA(J_base_xz, omega_z, STEWART_FMA(J_base_xy, omega_y,
            J_base_xx*omega_x));
        const stewart_real J_w_y = STEWART_FMA(J_base_yz, omega_z, STEWART_FMA(J_base_yy, omega_y,
            J_base_xy*omega_x));
        const stewart_real J_w_z = STEWART_FMA(J_base_zz, omega_z, STEWART_FMA(J_base_yz, omega_y,
            J_base_xz*omega_x));
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
        out->B_0[0][l] = B_xx;
        out->B_0[1][l] = omega_xy;
        out->B_0[2][l] = omega_xz;
        out->B_0[3][l] = omega_xy;
        out->B_0[4][l] = B_yy;
        out->B_0[5][l] = omega_yz;
        out->B_0[6][l] = omega_xz;
        out->B_0[7][l] = omega_yz;
        out->B_0[8][l] = B_zz;
        summed[0*lanes + l] = STEWART_FMA(-omega_z, w_h_y, STEWART_FMA(M_P, -g_x, omega_y*w_h_z));
        summed[1*lanes + l] = STEWART_FMA(-omega_x, w_h_z, STEWART_FMA(M_P, -g_y, omega_z*w_h_x));
        summed[2*lanes + l] = STEWART_FMA(-omega_y, w_h_x, STEWART_FMA(M_P, -g_z, omega_x*w_h_y));
        summed[3*lanes + l] = STEWART_FMA(g_z, -h_base_y, STEWART_FMA(-J_w_y, omega_z, STEWART_FMA(g_y,
            h_base_z, STEWART_FMA(J_w_z, omega_y, C_P*omega_x))));
        summed[4*lanes + l] = STEWART_FMA(g_x, -h_base_z, STEWART_FMA(-J_w_z, omega_x, STEWART_FMA(g_z,
            h_base_x, STEWART_FMA(J_w_x, omega_z, C_P*omega_y))));
        summed[5*lanes + l] = STEWART_FMA(g_y, -h_base_x, STEWART_FMA(-J_w_x, omega_y, STEWART_FMA(g_x,
            h_base_y, STEWART_FMA(J_w_y, omega_x, C_P*omega_z))));
    }
}

/* Computes the legs of a pose in lanes. */
STEWART_APART static void bias_of_leg(
    const stewart_exact_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT motion,
    const bias_pose *STEWART_RESTRICT pose, bias_legs *STEWART_RESTRICT out)
{
    int l;
    const stewart_real R_xx = motion->R[0], R_xy = motion->R[1], R_xz = motion->R[2], R_yx = motion->R[3],
        R_yy = motion->R[4], R_yz = motion->R[5], R_zx = motion->R[6], R_zy = motion->R[7], R_zz = motion->R[8];
    const stewart_real t_x = motion->t[0], t_y = motion->t[1], t_z = motion->t[2];
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    const stewart_real B_0_xx = pose->B_0[0][0], B_0_xy = pose->B_0[1][0], B_0_xz = pose->B_0[2][0], B_0_yx = pose->B_0[3][0],
        B_0_yy = pose->B_0[4][0], B_0_yz = pose->B_0[5][0], B_0_zx = pose->B_0[6][0], B_0_zy = pose->B_0[7][0],
        B_0_zz = pose->B_0[8][0];
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
        /* (10) distance of the tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y,
            k_cross_S_y, k_cross_S_x*k_cross_S_x)));
        const stewart_real inv_rho = REAL(1)/rho;
        /* relative component of the normal along s: rounding */
        const stewart_real n_along_s = inv_rho*STEWART_FMA(k_cross_S_z, s_z, STEWART_FMA(k_cross_S_y, s_y,
            k_cross_S_x*s_x));
        /* one over |s x normal| */
        const stewart_real inv_across = STEWART_FMA(STEWART_HALF*inv_rho*n_along_s, n_along_s, inv_rho);
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_S_y, s_z, k_cross_S_z*s_y);
        const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_S_z, s_x, k_cross_S_x*s_z);
        const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_S_x, s_y, k_cross_S_y*s_x);
        /* (10) third axis of the leg frame */
        const stewart_real z_x = inv_across*s_cross_normal_x;
        const stewart_real z_y = inv_across*s_cross_normal_y;
        const stewart_real z_z = inv_across*s_cross_normal_z;
        /* (10) rotating axis of the universal joint */
        const stewart_real y_x = STEWART_FMA(-s_y, z_z, s_z*z_y);
        const stewart_real y_y = STEWART_FMA(-s_z, z_x, s_x*z_z);
        const stewart_real y_z = STEWART_FMA(-s_x, z_y, s_y*z_x);
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1 = inv_L*zeta;
        const stewart_real k3 = inv_L*rho;
        /* (10) k1 / k3 */
        const stewart_real kappa = inv_rho*zeta;
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(omega_z, -q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(omega_x, -q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(omega_y, -q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
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
        /* (7) acceleration of the platform point, a = alpha = 0 */
        const stewart_real S_ddot_x = STEWART_FMA(B_0_xz, q_z, STEWART_FMA(B_0_xy, q_y, B_0_xx*q_x));
        const stewart_real S_ddot_y = STEWART_FMA(B_0_yz, q_z, STEWART_FMA(B_0_yy, q_y, B_0_yx*q_x));
        const stewart_real S_ddot_z = STEWART_FMA(B_0_zz, q_z, STEWART_FMA(B_0_zy, q_y, B_0_zx*q_x));
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
        /* force at the tip */
        const stewart_real R_tip_x = STEWART_FMA(D, s_x, K_x);
        const stewart_real R_tip_y = STEWART_FMA(D, s_y, K_y);
        const stewart_real R_tip_z = STEWART_FMA(D, s_z, K_z);
        out->sum[0][l] = R_tip_x;
        out->sum[1][l] = R_tip_y;
        out->sum[2][l] = R_tip_z;
        out->sum[3][l] = STEWART_FMA(-C_s, STEWART_FMA(theta_dot, y_x, k_x*phi_dot), STEWART_FMA(-R_tip_y,
            q_z, R_tip_z*q_y));
        out->sum[4][l] = STEWART_FMA(-C_s, STEWART_FMA(theta_dot, y_y, k_y*phi_dot), STEWART_FMA(-R_tip_z,
            q_x, R_tip_x*q_z));
        out->sum[5][l] = STEWART_FMA(-C_s, STEWART_FMA(theta_dot, y_z, k_z*phi_dot), STEWART_FMA(-R_tip_x,
            q_y, R_tip_y*q_x));
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* Computes the sums over platform and legs; ``status`` is the status of the legs. */
static void bias_sums(
    const stewart_exact_model *model, const stewart_motion *motion, bias_legs *legs, stewart_real summed[6])
{
    motion_in_lanes at;
    bias_pose pose;
    at.R[0][0] = motion->R[0];
    at.R[1][0] = motion->R[1];
    at.R[2][0] = motion->R[2];
    at.R[3][0] = motion->R[3];
    at.R[4][0] = motion->R[4];
    at.R[5][0] = motion->R[5];
    at.R[6][0] = motion->R[6];
    at.R[7][0] = motion->R[7];
    at.R[8][0] = motion->R[8];
    at.omega[0][0] = motion->omega[0];
    at.omega[1][0] = motion->omega[1];
    at.omega[2][0] = motion->omega[2];
    bias_of_pose(model, &at, 1, &pose, summed);
    bias_of_leg(model, motion, &pose, legs);
    legs->status = legs_status(&legs->checked);
    if (legs->status == STEWART_OK) {
        add_legs(legs->sum, 6, summed);
    }
}

/* A symmetric 3 x 3 block from xx xy xz yy yz zz. */
static void place_symmetric_40(const stewart_real parts[6], int row, int column, stewart_real A[240])
{
    int i;
    for (i = 0; i < 3; ++i) {
        A[40*row + (column + i)] = parts[i];
        A[40*(row + i) + column] = parts[i];
    }
    A[40*(row + 1) + (column + 1)] = parts[3];
    A[40*(row + 1) + (column + 2)] = parts[4];
    A[40*(row + 2) + (column + 1)] = parts[4];
    A[40*(row + 2) + (column + 2)] = parts[5];
}

/* M into six columns from ``first`` on, from its parts, of which symmetric ones are xx xy xz yy yz zz. */
static void place_inertia_40(
    const stewart_real vv[6], const stewart_real vw[9], const stewart_real ww[6], int first,
    stewart_real A[240])
{
    int i, j;
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 3; ++j) {
            A[40*i + (first + j + 3)] = vw[3*i + j];
            A[40*(j + 3) + (first + i)] = vw[3*i + j];
        }
    }
    place_symmetric_40(vv, 0, first, A);
    place_symmetric_40(ww, 3, first + 3, A);
}

/* M from its parts, and the bias. */
static STEWART_INLINE void matrices(
    const stewart_real *v, const stewart_real *omega, int lanes, stewart_real *STEWART_RESTRICT number)
{
    int i, l;
    for (l = 0; l < lanes; ++l) {
        const stewart_real m_0 = number[15*lanes + l], m_1 = number[16*lanes + l], m_2 = number[17*lanes + l],
            m_3 = number[18*lanes + l], m_4 = number[19*lanes + l], m_5 = number[20*lanes + l], m_6 = number[21*lanes
            + l], m_7 = number[22*lanes + l], m_8 = number[23*lanes + l], m_9 = number[24*lanes + l], m_10 = number[25*lanes
            + l], m_11 = number[26*lanes + l], m_12 = number[27*lanes + l], m_13 = number[28*lanes + l],
            m_14 = number[29*lanes + l], m_15 = number[30*lanes + l], m_16 = number[31*lanes + l], m_17 = number[32*lanes
            + l], m_18 = number[33*lanes + l], m_19 = number[34*lanes + l], m_20 = number[35*lanes + l];
        number[0*lanes + l] = m_0;
        number[1*lanes + l] = m_1;
        number[2*lanes + l] = m_2;
        number[3*lanes + l] = m_6;
        number[4*lanes + l] = m_7;
        number[5*lanes + l] = m_8;
        number[6*lanes + l] = m_1;
        number[7*lanes + l] = m_3;
        number[8*lanes + l] = m_4;
        number[9*lanes + l] = m_9;
        number[10*lanes + l] = m_10;
        number[11*lanes + l] = m_11;
        number[12*lanes + l] = m_2;
        number[13*lanes + l] = m_4;
        number[14*lanes + l] = m_5;
        number[15*lanes + l] = m_12;
        number[16*lanes + l] = m_13;
        number[17*lanes + l] = m_14;
        number[18*lanes + l] = m_6;
        number[19*lanes + l] = m_9;
        number[20*lanes + l] = m_12;
        number[21*lanes + l] = m_15;
        number[22*lanes + l] = m_16;
        number[23*lanes + l] = m_17;
        number[24*lanes + l] = m_7;
        number[25*lanes + l] = m_10;
        number[26*lanes + l] = m_13;
        number[27*lanes + l] = m_16;
        number[28*lanes + l] = m_18;
        number[29*lanes + l] = m_19;
        number[30*lanes + l] = m_8;
        number[31*lanes + l] = m_11;
        number[32*lanes + l] = m_14;
        number[33*lanes + l] = m_17;
        number[34*lanes + l] = m_19;
        number[35*lanes + l] = m_20;
    }
    for (i = 0; i < 6; ++i) {
        for (l = 0; l < lanes; ++l) {
            stewart_real total = number[(72 + i)*lanes + l];
            total = STEWART_FMA(number[(36 + 6*i + 0)*lanes + l], v[0*lanes + l], total);
            total = STEWART_FMA(number[(36 + 6*i + 0 + 3)*lanes + l], omega[0*lanes + l], total);
            total = STEWART_FMA(number[(36 + 6*i + 1)*lanes + l], v[1*lanes + l], total);
            total = STEWART_FMA(number[(36 + 6*i + 1 + 3)*lanes + l], omega[1*lanes + l], total);
            total = STEWART_FMA(number[(36 + 6*i + 2)*lanes + l], v[2*lanes + l], total);
            total = STEWART_FMA(number[(36 + 6*i + 2 + 3)*lanes + l], omega[2*lanes + l], total);
            number[(84 + i)*lanes + l] = total;
            number[(90 + i)*lanes + l] = total + number[(78 + i)*lanes + l];
        }
    }
}

int stewart_exact_equations(
    const stewart_exact_model *model, const stewart_motion *motion, stewart_equations *out)
{
    int i, leg;
    equations_legs legs;
    STEWART_ALIGNED stewart_real number[168];
    STEWART_ALIGNED stewart_real none[LANES];
    if (model == NULL || motion == NULL || out == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    equations_sums(model, motion, &legs, &number[15]);
    if (legs.status != STEWART_OK) {
        return legs.status;
    }
    for (leg = 0; leg < 6; ++leg) {
        number[96 + leg] = legs.H_force[0][leg];
        number[102 + leg] = legs.H_force[1][leg];
        number[108 + leg] = legs.H_force[2][leg];
        number[114 + leg] = legs.H_moment[0][leg];
        number[120 + leg] = legs.H_moment[1][leg];
        number[126 + leg] = legs.H_moment[2][leg];
        number[132 + leg] = legs.H_dot_force[0][leg];
        number[138 + leg] = legs.H_dot_force[1][leg];
        number[144 + leg] = legs.H_dot_force[2][leg];
        number[150 + leg] = legs.H_dot_moment[0][leg];
        number[156 + leg] = legs.H_dot_moment[1][leg];
        number[162 + leg] = legs.H_dot_moment[2][leg];
    }
    matrices(&motion->v[0], &motion->omega[0], 1, number);
    for (i = 168; i < 168; ++i) {
        number[i] = REAL(0);
    }
    not_finite(number, 168/8, none);
    if (none[0] + none[1] + none[2] + none[3] + none[4] + none[5] + none[6] + none[7] != REAL(0)) {
        return STEWART_NOT_FINITE;
    }
    for (i = 0; i < 36; ++i) {
        out->M[i] = number[0 + i];
    }
    for (i = 0; i < 36; ++i) {
        out->C[i] = number[36 + i];
    }
    for (i = 0; i < 6; ++i) {
        out->g[i] = number[72 + i];
    }
    for (i = 0; i < 6; ++i) {
        out->friction[i] = number[78 + i];
    }
    for (i = 0; i < 6; ++i) {
        out->bias[i] = number[84 + i];
    }
    for (i = 0; i < 6; ++i) {
        out->bias_and_friction[i] = number[90 + i];
    }
    for (i = 0; i < 36; ++i) {
        out->H[i] = number[96 + i];
    }
    for (i = 0; i < 36; ++i) {
        out->H_dot[i] = number[132 + i];
    }
    return STEWART_OK;
}

int stewart_exact_bias_and_friction(
    const stewart_exact_model *model, const stewart_motion *motion, stewart_real out[6])
{
    int i;
    bias_legs legs;
    stewart_real number[6];
    stewart_real none = REAL(0);
    if (model == NULL || motion == NULL || out == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    bias_sums(model, motion, &legs, number);
    if (legs.status != STEWART_OK) {
        return legs.status;
    }
    for (i = 0; i < 6; ++i) {
        none = STEWART_FMA(REAL(0), number[i], none);
    }
    if (none != REAL(0)) {
        return STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        out[i] = number[i];
    }
    return STEWART_OK;
}

/* Elimination with partial pivoting, (36), of the first columns; rows are exchanged by addresses. */
STEWART_APART static void factored(stewart_real *row[6], stewart_real inverse[6])
{
    int i, j, k;
    stewart_real upper[LANES];
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        stewart_real most = STEWART_FABS(row[k][k]);
        for (i = k + 1; i < 6; ++i) {
            const stewart_real entry = STEWART_FABS(row[i][k]);
            pivot = entry > most ? i : pivot;
            most = entry > most ? entry : most;
        }
        stewart_real *const moved = row[k];
        row[k] = row[pivot];
        row[pivot] = moved;
        inverse[k] = REAL(1)/row[k][k];
        for (j = 0; j < LANES; ++j) {
            upper[j] = row[k][j];
        }
        for (i = k + 1; i < 6; ++i) {
            const stewart_real factor = row[i][k]*inverse[k];
            row[i][32 + k] = factor;
            for (j = 0; j < LANES; ++j) {
                row[i][j] = STEWART_FMA(-factor, upper[j], row[i][j]);
            }
        }
    }
}

/* The other columns, and back substitution. */
STEWART_APART static void back(
    stewart_real *row[6], const stewart_real inverse[6], stewart_real (*STEWART_RESTRICT X)[24])
{
    int j;
    for (j = 0; j < 24; ++j) {
        stewart_real y_0 = row[0][j + 8], y_1 = row[1][j + 8], y_2 = row[2][j + 8], y_3 = row[3][j + 8], y_4 = row[4][j
            + 8], y_5 = row[5][j + 8];
        y_1 = STEWART_FMA(-row[1][32], y_0, y_1);
        y_2 = STEWART_FMA(-row[2][32], y_0, y_2);
        y_3 = STEWART_FMA(-row[3][32], y_0, y_3);
        y_4 = STEWART_FMA(-row[4][32], y_0, y_4);
        y_5 = STEWART_FMA(-row[5][32], y_0, y_5);
        y_2 = STEWART_FMA(-row[2][33], y_1, y_2);
        y_3 = STEWART_FMA(-row[3][33], y_1, y_3);
        y_4 = STEWART_FMA(-row[4][33], y_1, y_4);
        y_5 = STEWART_FMA(-row[5][33], y_1, y_5);
        y_3 = STEWART_FMA(-row[3][34], y_2, y_3);
        y_4 = STEWART_FMA(-row[4][34], y_2, y_4);
        y_5 = STEWART_FMA(-row[5][34], y_2, y_5);
        y_4 = STEWART_FMA(-row[4][35], y_3, y_4);
        y_5 = STEWART_FMA(-row[5][35], y_3, y_5);
        y_5 = STEWART_FMA(-row[5][36], y_4, y_5);
        y_5 = y_5*inverse[5];
        y_0 = STEWART_FMA(-row[0][5], y_5, y_0);
        y_1 = STEWART_FMA(-row[1][5], y_5, y_1);
        y_2 = STEWART_FMA(-row[2][5], y_5, y_2);
        y_3 = STEWART_FMA(-row[3][5], y_5, y_3);
        y_4 = STEWART_FMA(-row[4][5], y_5, y_4);
        y_4 = y_4*inverse[4];
        y_0 = STEWART_FMA(-row[0][4], y_4, y_0);
        y_1 = STEWART_FMA(-row[1][4], y_4, y_1);
        y_2 = STEWART_FMA(-row[2][4], y_4, y_2);
        y_3 = STEWART_FMA(-row[3][4], y_4, y_3);
        y_3 = y_3*inverse[3];
        y_0 = STEWART_FMA(-row[0][3], y_3, y_0);
        y_1 = STEWART_FMA(-row[1][3], y_3, y_1);
        y_2 = STEWART_FMA(-row[2][3], y_3, y_2);
        y_2 = y_2*inverse[2];
        y_0 = STEWART_FMA(-row[0][2], y_2, y_0);
        y_1 = STEWART_FMA(-row[1][2], y_2, y_1);
        y_1 = y_1*inverse[1];
        y_0 = STEWART_FMA(-row[0][1], y_1, y_0);
        y_0 = y_0*inverse[0];
        X[0][j] = y_0;
        X[1][j] = y_1;
        X[2][j] = y_2;
        X[3][j] = y_3;
        X[4][j] = y_4;
        X[5][j] = y_5;
    }
}

/* Derivatives of F from H and the derivatives of the wrench: rows [H | by pose | by twist | M]. */
STEWART_APART static int slopes(
    stewart_real per_length, const stewart_real *number, const stewart_real *F, stewart_derivatives *out)
{
    int i, j;
    stewart_real *row[6];
    STEWART_ALIGNED stewart_real table[240];
    stewart_real inverse[6];
    stewart_real X[6][24];
    STEWART_ALIGNED stewart_real none[LANES];
    for (i = 0; i < 6; ++i) {
        row[i] = &table[40*i];
        for (j = 0; j < LANES; ++j) {
            row[i][j] = number[93 + 6*i + j];
            row[i][j + 8] = number[21 + 6*i + j];
            row[i][j + 16] = number[57 + 6*i + j];
            row[i][j + 24] = REAL(0);
        }
    }
    place_inertia_40(&number[0], &number[6], &number[15], 24, table);
    if (per_length != REAL(1)) {
        for (i = 3; i < 6; ++i) {
            for (j = 0; j < 32; ++j) {
                row[i][j] = row[i][j]*per_length;
            }
        }
    }
    factored(row, inverse);
    back(row, inverse, X);
    not_finite(X[0], 18, none);
    if (none[0] + none[1] + none[2] + none[3] + none[4] + none[5] != REAL(0)) {
        return STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        out->F[i] = F[i];
        for (j = 0; j < 6; ++j) {
            out->by_pose[6*i + j] = X[i][j];
            out->by_twist[6*i + j] = X[i][j + 8];
            out->by_acceleration[6*i + j] = X[i][j + 16];
        }
    }
    return STEWART_OK;
}

int stewart_exact_derivatives(
    const stewart_exact_model *model, const stewart_motion *motion, stewart_derivatives *out)
{
    int i, leg;
    derivatives_legs legs;
    STEWART_ALIGNED stewart_real number[131];
    stewart_real F[6];
    if (model == NULL || motion == NULL || out == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    const int status = stewart_exact_forces(model, motion, F);
    if (status != STEWART_OK) {
        return status;
    }
    for (i = 0; i < 6; ++i) {
        legs.F[i] = F[i];
    }
    derivatives_sums(model, motion, &legs, number);
    if (legs.status != STEWART_OK) {
        return legs.status;
    }
    for (leg = 0; leg < 6; ++leg) {
        number[93 + leg] = legs.H_force[0][leg];
        number[99 + leg] = legs.H_force[1][leg];
        number[105 + leg] = legs.H_force[2][leg];
        number[111 + leg] = legs.H_moment[0][leg];
        number[117 + leg] = legs.H_moment[1][leg];
        number[123 + leg] = legs.H_moment[2][leg];
    }
    number[129] = REAL(0);
    number[130] = REAL(0);
    return slopes(model->per_length, number, F, out);
}

/* Motions of eight poses, component by component. */
static void load_motions(const stewart_motions *motions, size_t first, size_t count, motion_in_lanes *at)
{
    load_matrix(motions->R, 0U, first, count, at->R);
    load_vector(motions->t, 0U, first, count, at->t);
    load_vector(motions->omega, 0U, first, count, at->omega);
    load_vector(motions->v, 0U, first, count, at->v);
    load_vector(motions->alpha, 0U, first, count, at->alpha);
    load_vector(motions->a, 0U, first, count, at->a);
    load_vector(motions->F_ext, 0U, first, count, at->F_ext);
    load_vector(motions->M_ext, 0U, first, count, at->M_ext);
}

/* Actuator forces of eight poses, leg by leg; lanes after the last pose repeat it. */
static void load_forces(const stewart_real *F, size_t first, size_t count, stewart_real acting[6][LANES])
{
    int i, l;
    for (l = 0; l < LANES; ++l) {
        const size_t pose = first + (size_t)l < count ? first + (size_t)l : count - 1U;
        for (i = 0; i < 6; ++i) {
            acting[i][l] = F[pose*6U + (size_t)i];
        }
    }
}

/* Adds two legs to others, in the order in which ``add_legs`` does. */
STEWART_APART static void add_two(
    stewart_real (*STEWART_RESTRICT one)[LANES], stewart_real (*STEWART_RESTRICT other)[LANES], int count,
    int more, stewart_real *STEWART_RESTRICT sum)
{
    int i, l;
    if (more > 0) {
        for (i = 0; i < count; ++i) {
            for (l = 0; l < LANES; ++l) {
                sum[LANES*i + l] = sum[LANES*i + l] + (one[i][l] + other[i][l]);
            }
        }
    } else {
        for (i = 0; i < count; ++i) {
            for (l = 0; l < LANES; ++l) {
                sum[LANES*i + l] = one[i][l] + other[i][l];
            }
        }
    }
}

/* The numbers of each pose side by side. */
STEWART_APART static void in_rows(
    const stewart_real *STEWART_RESTRICT number, int count, stewart_real *STEWART_RESTRICT row)
{
    int i;
    for (i = 0; i < count; ++i) {
        row[0*count + i] = number[LANES*i + 0];
        row[1*count + i] = number[LANES*i + 1];
        row[2*count + i] = number[LANES*i + 2];
        row[3*count + i] = number[LANES*i + 3];
        row[4*count + i] = number[LANES*i + 4];
        row[5*count + i] = number[LANES*i + 5];
        row[6*count + i] = number[LANES*i + 6];
        row[7*count + i] = number[LANES*i + 7];
    }
}

/* Returns 1 if a lane is marked, else 0. */
static int any_of(const stewart_real bad[LANES])
{
    int l;
    stewart_real found = REAL(0);
    for (l = 0; l < LANES; ++l) {
        found = STEWART_LARGER(bad[l], found);
    }
    return found > REAL(0) ? 1 : 0;
}

/* Numbers of eight poses. */
typedef struct {
    stewart_real number[1344];
    stewart_real bad[LANES]; /* 1 if the function for one pose must compute the pose, else 0 */
} STEWART_ALIGNED equations_block;

/* Computes one leg of eight poses in lanes. */
STEWART_APART static void equations_leg_of_poses(
    const stewart_exact_model *STEWART_RESTRICT model, int leg, const motion_in_lanes *STEWART_RESTRICT at,
    const equations_pose *STEWART_RESTRICT pose, equations_legs *STEWART_RESTRICT out)
{
    int l;
    (void)pose;
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][leg], b_y = model->b[1][leg], b_z = model->b[2][leg];
        const stewart_real p_x = model->p[0][leg], p_y = model->p[1][leg], p_z = model->p[2][leg];
        const stewart_real k_x = model->k[0][leg], k_y = model->k[1][leg], k_z = model->k[2][leg];
        const stewart_real C_p = model->C_p[leg];
        const stewart_real C_s = model->C_s[leg];
        const stewart_real h_x = model->h[0][leg], h_y = model->h[1][leg], h_z = model->h[2][leg];
        const stewart_real h2_x = model->h2_x[leg];
        const stewart_real h2_z = model->h2_z[leg];
        const stewart_real w_x = model->w[0][leg], w_y = model->w[1][leg], w_z = model->w[2][leg];
        const stewart_real J_xx = model->J[0][leg], J_xy = model->J[1][leg], J_xz = model->J[2][leg], J_yy = model->J[3][leg],
            J_yz = model->J[4][leg], J_zz = model->J[5][leg];
        const stewart_real J2_xz = model->J2_xz[leg];
        const stewart_real dJ_zx = model->dJ_zx[leg];
        const stewart_real g_k = model->g_k[leg];
        const stewart_real g_x_k_x = model->g_x_k[0][leg], g_x_k_y = model->g_x_k[1][leg], g_x_k_z = model->g_x_k[2][leg];
        const stewart_real C_us = model->C_us[leg];
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real t_x = at->t[0][l], t_y = at->t[1][l], t_z = at->t[2][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        const stewart_real v_x = at->v[0][l], v_y = at->v[1][l], v_z = at->v[2][l];
        const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
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
        /* (10) distance of the tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y,
            k_cross_S_y, k_cross_S_x*k_cross_S_x)));
        const stewart_real inv_rho = REAL(1)/rho;
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_S_y, s_z, k_cross_S_z*s_y);
        const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_S_z, s_x, k_cross_S_x*s_z);
        const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_S_x, s_y, k_cross_S_y*s_x);
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
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(-omega_z, q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(-omega_x, q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(-omega_y, q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = inv_rho*STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y,
            S_dot_x*y_x));
        const stewart_real theta_dot = -inv_L*STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y,
            S_dot_x*z_x));
        const stewart_real c1 = k3*k3;
        const stewart_real k33 = c1;
        const stewart_real k13 = k1*k3;
        const stewart_real L_h2 = L*h2_x;
        const stewart_real a1 = dJ_zx + L_h2;
        const stewart_real a2 = STEWART_FMA(-L, h2_z, J2_xz);
        const stewart_real c2 = STEWART_FMA(-L, h_y, J_xy);
        const stewart_real a3 = c2;
        /* (19) inertia of the joint coordinates */
        const stewart_real M_phi = STEWART_FMA(a2, k13, STEWART_FMA(a1, k33, J_xx));
        const stewart_real M_theta = J_yy + L_h2;
        const stewart_real M_mixed = STEWART_FMA(a3, k1, J_yz*k3);
        const stewart_real k3_h = h_y*k3;
        const stewart_real c3 = inv_L*inv_rho;
        const stewart_real c4 = inv_L*inv_L;
        /* inertia at the tip, leg frame */
        const stewart_real m_leg_sy = -inv_rho*k3_h;
        const stewart_real m_leg_sz = -h_z*inv_L;
        const stewart_real m_leg_yy = M_phi*inv_rho*inv_rho;
        const stewart_real m_leg_yz = -M_mixed*c3;
        const stewart_real m_leg_zz = M_theta*c4;
        const stewart_real m_T_xs = STEWART_FMA(m_leg_sy, y_x, m_leg_sz*z_x);
        const stewart_real m_T_xy = STEWART_FMA(m_leg_yy, y_x, STEWART_FMA(m_leg_yz, z_x, m_leg_sy*s_x));
        const stewart_real m_T_xz = STEWART_FMA(m_leg_yz, y_x, STEWART_FMA(m_leg_zz, z_x, m_leg_sz*s_x));
        const stewart_real m_T_ys = STEWART_FMA(m_leg_sy, y_y, m_leg_sz*z_y);
        const stewart_real m_T_yy = STEWART_FMA(m_leg_yy, y_y, STEWART_FMA(m_leg_yz, z_y, m_leg_sy*s_y));
        const stewart_real m_T_yz = STEWART_FMA(m_leg_yz, y_y, STEWART_FMA(m_leg_zz, z_y, m_leg_sz*s_y));
        const stewart_real m_T_zs = STEWART_FMA(m_leg_sy, y_z, m_leg_sz*z_z);
        const stewart_real m_T_zy = STEWART_FMA(m_leg_yy, y_z, STEWART_FMA(m_leg_yz, z_z, m_leg_sy*s_z));
        const stewart_real m_T_zz = STEWART_FMA(m_leg_yz, y_z, STEWART_FMA(m_leg_zz, z_z, m_leg_sz*s_z));
        /* inertia at the tip, base frame */
        const stewart_real m_xx = STEWART_FMA(m_T_xz, z_x, STEWART_FMA(m_T_xy, y_x, m_T_xs*s_x));
        const stewart_real m_xy = STEWART_FMA(m_T_xz, z_y, STEWART_FMA(m_T_xy, y_y, m_T_xs*s_y));
        const stewart_real m_xz = STEWART_FMA(m_T_xz, z_z, STEWART_FMA(m_T_xy, y_z, m_T_xs*s_z));
        const stewart_real m_yy = STEWART_FMA(m_T_yz, z_y, STEWART_FMA(m_T_yy, y_y, m_T_ys*s_y));
        const stewart_real m_yz = STEWART_FMA(m_T_yz, z_z, STEWART_FMA(m_T_yy, y_z, m_T_ys*s_z));
        const stewart_real m_zz = STEWART_FMA(m_T_zz, z_z, STEWART_FMA(m_T_zy, y_z, m_T_zs*s_z));
        const stewart_real c5 = h_x*theta_dot;
        const stewart_real C_xi_12 = -c5;
        const stewart_real c6 = STEWART_FMA(h_z*k1, -k3, c1*h_x);
        const stewart_real C_xi_13 = -c6*phi_dot;
        const stewart_real C_xi_21 = c5;
        const stewart_real C_xi_22 = L_dot*h_x;
        const stewart_real c7 = REAL(2)*L;
        const stewart_real c8 = STEWART_FMA(-c7, h_z, REAL(2)*J_xz);
        const stewart_real c9 = STEWART_FMA(STEWART_HALF*c1, -c8, STEWART_HALF*k1*STEWART_FMA(c8, k1,
            REAL(2)*k3*STEWART_FMA(c7, h_x, J_zz - J_xx)));
        const stewart_real C_xi_23 = -c9*phi_dot;
        const stewart_real c10 = h_y*k1;
        const stewart_real C_xi_31 = STEWART_FMA(-c10, theta_dot, c6*phi_dot);
        const stewart_real C_xi_32 = STEWART_FMA(c9, phi_dot, STEWART_FMA(-L_dot, c10,
            theta_dot*STEWART_FMA(-c2, k3, J_yz*k1)));
        const stewart_real C_xi_33 = STEWART_FMA(c9, theta_dot, L_dot*c6);
        const stewart_real c11 = k3*phi_dot;
        const stewart_real G_dot_12 = c11;
        const stewart_real G_dot_21 = -inv_L*theta_dot;
        const stewart_real c12 = k1*phi_dot;
        const stewart_real G_dot_22 = c12*inv_L;
        const stewart_real G_dot_23 = L_dot*c4;
        const stewart_real G_dot_31 = -c11*inv_rho;
        const stewart_real G_dot_32 = STEWART_FMA(inv_rho*kappa, -theta_dot, -L_dot*c3);
        const stewart_real G_dot_33 = c12*inv_rho;
        const stewart_real C_leg_11 = STEWART_FMA(-G_dot_31, k3_h, G_dot_21*h_z);
        const stewart_real C_leg_12 = STEWART_FMA(-G_dot_32, k3_h, STEWART_FMA(G_dot_22, h_z,
            C_xi_13*inv_rho));
        const stewart_real C_leg_13 = STEWART_FMA(-G_dot_33, k3_h, STEWART_FMA(-C_xi_12, inv_L,
            G_dot_23*h_z));
        const stewart_real C_leg_21 = inv_rho*STEWART_FMA(G_dot_31, M_phi, STEWART_FMA(G_dot_21, M_mixed,
            C_xi_31));
        const stewart_real C_leg_22 = inv_rho*STEWART_FMA(-G_dot_12, k3_h, STEWART_FMA(G_dot_32, M_phi,
            STEWART_FMA(G_dot_22, M_mixed, C_xi_33*inv_rho)));
        const stewart_real C_leg_23 = inv_rho*STEWART_FMA(-C_xi_32, inv_L, STEWART_FMA(G_dot_33, M_phi,
            STEWART_FMA(k3_h, theta_dot, G_dot_23*M_mixed)));
        const stewart_real C_leg_31 = -inv_L*STEWART_FMA(G_dot_31, M_mixed, STEWART_FMA(G_dot_21, M_theta,
            C_xi_21));
        const stewart_real C_leg_32 = -inv_L*STEWART_FMA(G_dot_32, M_mixed, STEWART_FMA(G_dot_22, M_theta,
            STEWART_FMA(C_xi_23, inv_rho, G_dot_12*h_z)));
        const stewart_real C_leg_33 = -inv_L*STEWART_FMA(G_dot_33, M_mixed, STEWART_FMA(h_z, -theta_dot,
            STEWART_FMA(-C_xi_22, inv_L, G_dot_23*M_theta)));
        const stewart_real C_tip_T_xs = STEWART_FMA(C_leg_31, z_x, STEWART_FMA(C_leg_21, y_x,
            C_leg_11*s_x));
        const stewart_real C_tip_T_xy = STEWART_FMA(C_leg_32, z_x, STEWART_FMA(C_leg_22, y_x,
            C_leg_12*s_x));
        const stewart_real C_tip_T_xz = STEWART_FMA(C_leg_33, z_x, STEWART_FMA(C_leg_23, y_x,
            C_leg_13*s_x));
        const stewart_real C_tip_T_ys = STEWART_FMA(C_leg_31, z_y, STEWART_FMA(C_leg_21, y_y,
            C_leg_11*s_y));
        const stewart_real C_tip_T_yy = STEWART_FMA(C_leg_32, z_y, STEWART_FMA(C_leg_22, y_y,
            C_leg_12*s_y));
        const stewart_real C_tip_T_yz = STEWART_FMA(C_leg_33, z_y, STEWART_FMA(C_leg_23, y_y,
            C_leg_13*s_y));
        const stewart_real C_tip_T_zs = STEWART_FMA(C_leg_31, z_z, STEWART_FMA(C_leg_21, y_z,
            C_leg_11*s_z));
        const stewart_real C_tip_T_zy = STEWART_FMA(C_leg_32, z_z, STEWART_FMA(C_leg_22, y_z,
            C_leg_12*s_z));
        const stewart_real C_tip_T_zz = STEWART_FMA(C_leg_33, z_z, STEWART_FMA(C_leg_23, y_z,
            C_leg_13*s_z));
        /* Coriolis matrix at the tip, base frame */
        const stewart_real C_tip_xx = STEWART_FMA(C_tip_T_xy, y_x, STEWART_FMA(C_tip_T_xs, s_x,
            C_tip_T_xz*z_x));
        const stewart_real C_tip_xy = STEWART_FMA(C_tip_T_xy, y_y, STEWART_FMA(C_tip_T_xs, s_y,
            C_tip_T_xz*z_y));
        const stewart_real C_tip_xz = STEWART_FMA(C_tip_T_xy, y_z, STEWART_FMA(C_tip_T_xs, s_z,
            C_tip_T_xz*z_z));
        const stewart_real C_tip_yx = STEWART_FMA(C_tip_T_yy, y_x, STEWART_FMA(C_tip_T_ys, s_x,
            C_tip_T_yz*z_x));
        const stewart_real C_tip_yy = STEWART_FMA(C_tip_T_yy, y_y, STEWART_FMA(C_tip_T_ys, s_y,
            C_tip_T_yz*z_y));
        const stewart_real C_tip_yz = STEWART_FMA(C_tip_T_yy, y_z, STEWART_FMA(C_tip_T_ys, s_z,
            C_tip_T_yz*z_z));
        const stewart_real C_tip_zx = STEWART_FMA(C_tip_T_zy, y_x, STEWART_FMA(C_tip_T_zs, s_x,
            C_tip_T_zz*z_x));
        const stewart_real C_tip_zy = STEWART_FMA(C_tip_T_zy, y_y, STEWART_FMA(C_tip_T_zs, s_y,
            C_tip_T_zz*z_y));
        const stewart_real C_tip_zz = STEWART_FMA(C_tip_T_zy, y_z, STEWART_FMA(C_tip_T_zs, s_z,
            C_tip_T_zz*z_z));
        const stewart_real c13 = C_tip_xy*q_z;
        const stewart_real c14 = m_xy*w_q_z;
        const stewart_real c15 = C_tip_xz*q_y;
        const stewart_real c16 = m_xz*w_q_y;
        const stewart_real C_q_xx = c16 - c14 + c15 - c13;
        const stewart_real c17 = C_tip_xx*q_z;
        const stewart_real C_q_xy = STEWART_FMA(-C_tip_xz, q_x, STEWART_FMA(-m_xz, w_q_x, m_xx*w_q_z) + c17);
        const stewart_real c18 = C_tip_xx*q_y;
        const stewart_real C_q_xz = STEWART_FMA(C_tip_xy, q_x, STEWART_FMA(-m_xx, w_q_y, m_xy*w_q_x)) - c18;
        const stewart_real c19 = C_tip_yy*q_z;
        const stewart_real C_q_yx = STEWART_FMA(C_tip_yz, q_y, STEWART_FMA(-m_yy, w_q_z, m_yz*w_q_y)) - c19;
        const stewart_real c20 = C_tip_yx*q_z;
        const stewart_real c21 = -C_tip_yz*q_x;
        const stewart_real c22 = -m_yz*w_q_x;
        const stewart_real C_q_yy = c14 + c22 + c20 + c21;
        const stewart_real c23 = -C_tip_yy*q_x;
        const stewart_real C_q_yz = STEWART_FMA(-C_tip_yx, q_y, STEWART_FMA(-m_xy, w_q_y, m_yy*w_q_x)) - c23;
        const stewart_real c24 = -C_tip_zz*q_y;
        const stewart_real C_q_zx = STEWART_FMA(-C_tip_zy, q_z, STEWART_FMA(-m_yz, w_q_z, m_zz*w_q_y)) - c24;
        const stewart_real c25 = -C_tip_zz*q_x;
        const stewart_real C_q_zy = STEWART_FMA(C_tip_zx, q_z, STEWART_FMA(-m_zz, w_q_x, m_xz*w_q_z)) + c25;
        const stewart_real c26 = C_tip_zx*q_y;
        const stewart_real c27 = -C_tip_zy*q_x;
        const stewart_real C_q_zz = -c16 - c22 - c26 - c27;
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* components of the first moment along k and along -k x y */
        const stewart_real w_k = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real w_n = STEWART_FMA(-k1, w_z, k3*w_x);
        const stewart_real c28 = inv_L*STEWART_FMA(gamma_n, w_k, g_k*w_n);
        const stewart_real c29 = STEWART_FMA(-gamma_y, w_n, -gamma_n*w_y);
        /* force at the tip that balances gravity */
        const stewart_real held_x = STEWART_FMA(-c28, z_x, c29*inv_rho*y_x);
        const stewart_real held_y = STEWART_FMA(-c28, z_y, c29*inv_rho*y_y);
        const stewart_real held_z = STEWART_FMA(-c28, z_z, c29*inv_rho*y_z);
        const stewart_real c30 = L_dot*s_x;
        const stewart_real c31 = inv_rho*STEWART_FMA(C_s, -STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y,
            omega_y, k_x*omega_x)), C_us*phi_dot);
        const stewart_real c32 = inv_L*STEWART_FMA(C_s, -STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y,
            omega_x*y_x)), C_us*theta_dot);
        const stewart_real c33 = L_dot*s_y;
        const stewart_real c34 = L_dot*s_z;
        /* force at the tip that balances friction */
        const stewart_real resistance_x = STEWART_FMA(-c32, z_x, STEWART_FMA(c31, y_x, C_p*c30));
        const stewart_real resistance_y = STEWART_FMA(-c32, z_y, STEWART_FMA(c31, y_y, C_p*c33));
        const stewart_real resistance_z = STEWART_FMA(-c32, z_z, STEWART_FMA(c31, y_z, C_p*c34));
        /* (3) derivative of s */
        const stewart_real s_dot_x = inv_L*(S_dot_x - c30);
        const stewart_real s_dot_y = inv_L*(S_dot_y - c33);
        const stewart_real s_dot_z = inv_L*(S_dot_z - c34);
        const stewart_real c35 = m_xy*q_z;
        const stewart_real c36 = m_xz*q_y;
        const stewart_real c37 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c35 - c36;
        const stewart_real m_q_xy = STEWART_FMA(-m_xx, q_z, m_xz*q_x);
        const stewart_real m_q_xz = STEWART_FMA(-m_xy, q_x, m_xx*q_y);
        const stewart_real m_q_yx = STEWART_FMA(-m_yz, q_y, m_yy*q_z);
        const stewart_real m_q_yy = -c35 - c37;
        const stewart_real m_q_yz = STEWART_FMA(-m_yy, q_x, m_xy*q_y);
        const stewart_real m_q_zx = STEWART_FMA(-m_zz, q_y, m_yz*q_z);
        const stewart_real m_q_zy = STEWART_FMA(-m_xz, q_z, m_zz*q_x);
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
        out->sum[15][l] = STEWART_FMA(-m_q_zx, q_y, m_q_yx*q_z);
        out->sum[16][l] = STEWART_FMA(-m_q_zy, q_y, m_q_yy*q_z);
        out->sum[17][l] = STEWART_FMA(-m_q_zz, q_y, m_q_yz*q_z);
        out->sum[18][l] = STEWART_FMA(-m_q_xy, q_z, m_q_zy*q_x);
        out->sum[19][l] = STEWART_FMA(-m_q_xz, q_z, m_q_zz*q_x);
        out->sum[20][l] = STEWART_FMA(-m_q_yz, q_x, m_q_xz*q_y);
        out->sum[21][l] = C_tip_xx;
        out->sum[22][l] = C_tip_xy;
        out->sum[23][l] = C_tip_xz;
        out->sum[24][l] = C_q_xx;
        out->sum[25][l] = C_q_xy;
        out->sum[26][l] = C_q_xz;
        out->sum[27][l] = C_tip_yx;
        out->sum[28][l] = C_tip_yy;
        out->sum[29][l] = C_tip_yz;
        out->sum[30][l] = C_q_yx;
        out->sum[31][l] = C_q_yy;
        out->sum[32][l] = C_q_yz;
        out->sum[33][l] = C_tip_zx;
        out->sum[34][l] = C_tip_zy;
        out->sum[35][l] = C_tip_zz;
        out->sum[36][l] = C_q_zx;
        out->sum[37][l] = C_q_zy;
        out->sum[38][l] = C_q_zz;
        out->sum[39][l] = c26 - c20;
        out->sum[40][l] = STEWART_FMA(C_tip_zy, q_y, -c19);
        out->sum[41][l] = STEWART_FMA(-C_tip_yz, q_z, -c24);
        out->sum[42][l] = STEWART_FMA(-C_q_yx, q_z, C_q_zx*q_y);
        out->sum[43][l] = STEWART_FMA(-C_q_yy, q_z, C_q_zy*q_y);
        out->sum[44][l] = STEWART_FMA(-C_q_yz, q_z, C_q_zz*q_y);
        out->sum[45][l] = STEWART_FMA(-C_tip_zx, q_x, c17);
        out->sum[46][l] = c13 + c27;
        out->sum[47][l] = STEWART_FMA(C_tip_xz, q_z, c25);
        out->sum[48][l] = STEWART_FMA(-C_q_zx, q_x, C_q_xx*q_z);
        out->sum[49][l] = STEWART_FMA(-C_q_zy, q_x, C_q_xy*q_z);
        out->sum[50][l] = STEWART_FMA(-C_q_zz, q_x, C_q_xz*q_z);
        out->sum[51][l] = STEWART_FMA(C_tip_yx, q_x, -c18);
        out->sum[52][l] = STEWART_FMA(-C_tip_xy, q_y, -c23);
        out->sum[53][l] = -c15 - c21;
        out->sum[54][l] = STEWART_FMA(-C_q_xx, q_y, C_q_yx*q_x);
        out->sum[55][l] = STEWART_FMA(-C_q_xy, q_y, C_q_yy*q_x);
        out->sum[56][l] = STEWART_FMA(-C_q_xz, q_y, C_q_yz*q_x);
        out->sum[57][l] = held_x;
        out->sum[58][l] = held_y;
        out->sum[59][l] = held_z;
        out->sum[60][l] = STEWART_FMA(-held_y, q_z, held_z*q_y);
        out->sum[61][l] = STEWART_FMA(-held_z, q_x, held_x*q_z);
        out->sum[62][l] = STEWART_FMA(-held_x, q_y, held_y*q_x);
        out->sum[63][l] = resistance_x;
        out->sum[64][l] = resistance_y;
        out->sum[65][l] = resistance_z;
        out->sum[66][l] = STEWART_FMA(C_s, -STEWART_FMA(theta_dot, y_x, k_x*phi_dot), STEWART_FMA(-q_z,
            resistance_y, q_y*resistance_z));
        out->sum[67][l] = STEWART_FMA(C_s, -STEWART_FMA(theta_dot, y_y, k_y*phi_dot), STEWART_FMA(-q_x,
            resistance_z, q_z*resistance_x));
        out->sum[68][l] = STEWART_FMA(C_s, -STEWART_FMA(theta_dot, y_z, k_z*phi_dot), STEWART_FMA(-q_y,
            resistance_x, q_x*resistance_y));
        out->H_force[0][l] = s_x;
        out->H_force[1][l] = s_y;
        out->H_force[2][l] = s_z;
        out->H_moment[0][l] = STEWART_FMA(-q_z, s_y, q_y*s_z);
        out->H_moment[1][l] = STEWART_FMA(-q_x, s_z, q_z*s_x);
        out->H_moment[2][l] = STEWART_FMA(-q_y, s_x, q_x*s_y);
        out->H_dot_force[0][l] = s_dot_x;
        out->H_dot_force[1][l] = s_dot_y;
        out->H_dot_force[2][l] = s_dot_z;
        out->H_dot_moment[0][l] = STEWART_FMA(-s_y, w_q_z, STEWART_FMA(-q_z, s_dot_y, STEWART_FMA(s_z,
            w_q_y, q_y*s_dot_z)));
        out->H_dot_moment[1][l] = STEWART_FMA(-s_z, w_q_x, STEWART_FMA(-q_x, s_dot_z, STEWART_FMA(s_x,
            w_q_z, q_z*s_dot_x)));
        out->H_dot_moment[2][l] = STEWART_FMA(-s_x, w_q_y, STEWART_FMA(-q_y, s_dot_x, STEWART_FMA(s_y,
            w_q_x, q_x*s_dot_y)));
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* One leg of eight poses; ``bad`` is 1 if the function for one pose must compute the pose. */
static void equations_leg_of_block(
    const stewart_exact_model *model, int leg, const motion_in_lanes *at, const equations_pose *pose,
    equations_legs *STEWART_RESTRICT legs, equations_block *STEWART_RESTRICT out)
{
    int l;
    equations_leg_of_poses(model, leg, at, pose, legs);
    for (l = 0; l < LANES; ++l) {
        out->number[8*(96 + leg) + l] = legs->H_force[0][l];
        out->number[8*(102 + leg) + l] = legs->H_force[1][l];
        out->number[8*(108 + leg) + l] = legs->H_force[2][l];
        out->number[8*(114 + leg) + l] = legs->H_moment[0][l];
        out->number[8*(120 + leg) + l] = legs->H_moment[1][l];
        out->number[8*(126 + leg) + l] = legs->H_moment[2][l];
        out->number[8*(132 + leg) + l] = legs->H_dot_force[0][l];
        out->number[8*(138 + leg) + l] = legs->H_dot_force[1][l];
        out->number[8*(144 + leg) + l] = legs->H_dot_force[2][l];
        out->number[8*(150 + leg) + l] = legs->H_dot_moment[0][l];
        out->number[8*(156 + leg) + l] = legs->H_dot_moment[1][l];
        out->number[8*(162 + leg) + l] = legs->H_dot_moment[2][l];
        stewart_real fault = STEWART_LARGER(legs->checked.bad[l], out->bad[l]);
        fault = legs->checked.k3[l] > STEWART_LEANING ? fault : REAL(1);
        out->bad[l] = fault;
    }
}

/* Sums over platform and legs of eight poses. */
static void equations_of_block(
    const stewart_exact_model *model, const motion_in_lanes *at, equations_block *out)
{
    int i, l;
    equations_pose pose = {0};
    equations_legs even;
    equations_legs odd;
    STEWART_ALIGNED stewart_real own[552];
    equations_of_pose(model, at, LANES, &pose, own);
    for (l = 0; l < LANES; ++l) {
        out->bad[l] = REAL(0);
    }
    for (i = 0; i < 3; ++i) {
        equations_leg_of_block(model, 2*i, at, &pose, &even, out);
        equations_leg_of_block(model, 2*i + 1, at, &pose, &odd, out);
        add_two(even.sum, odd.sum, 69, i, &out->number[15*LANES]);
    }
    for (i = 0; i < 552; ++i) {
        out->number[15*LANES + i] = own[i] + out->number[15*LANES + i];
    }
}

int stewart_exact_equations_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions,
    const stewart_equations_arrays *out, int *status)
{
    size_t first;
    int l;
    motion_in_lanes at;
    equations_block block;
    STEWART_ALIGNED stewart_real row[1344];
    stewart_motion one;
    if (model == NULL || motions == NULL || out == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    stewart_equations found;
    int result = STEWART_OK;
    for (first = 0; first < count; first += (size_t)LANES) {
        load_motions(motions, first, count, &at);
        equations_of_block(model, &at, &block);
        matrices(at.v[0], at.omega[0], LANES, block.number);
        stewart_real none[LANES];
        not_finite(block.number, 168, none);
        for (l = 0; l < LANES; ++l) {
            block.bad[l] = none[l] == REAL(0) ? block.bad[l] : REAL(1);
        }
        if (count - first >= LANES && any_of(block.bad) == 0) {
            if (out->M != NULL) {
                in_rows(&block.number[8*0], 36, &out->M[36U*first]);
            }
            if (out->C != NULL) {
                in_rows(&block.number[8*36], 36, &out->C[36U*first]);
            }
            if (out->g != NULL) {
                in_rows(&block.number[8*72], 6, &out->g[6U*first]);
            }
            if (out->friction != NULL) {
                in_rows(&block.number[8*78], 6, &out->friction[6U*first]);
            }
            if (out->bias != NULL) {
                in_rows(&block.number[8*84], 6, &out->bias[6U*first]);
            }
            if (out->bias_and_friction != NULL) {
                in_rows(&block.number[8*90], 6, &out->bias_and_friction[6U*first]);
            }
            if (out->H != NULL) {
                in_rows(&block.number[8*96], 36, &out->H[36U*first]);
            }
            if (out->H_dot != NULL) {
                in_rows(&block.number[8*132], 36, &out->H_dot[36U*first]);
            }
            if (status != NULL) {
                for (l = 0; l < LANES; ++l) {
                    status[first + (size_t)l] = STEWART_OK;
                }
            }
        } else {
            in_rows(block.number, 168, row);
            for (l = 0; l < LANES; ++l) {
                if (!(first + (size_t)l < count)) {
                    break;
                }
                const size_t pose = first + (size_t)l;
                int code = block.bad[l] > REAL(0) ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_OK;
                if (code == STEWART_OK) {
                    copy(out->M, pose, &row[l*168 + 0], 36U);
                    copy(out->C, pose, &row[l*168 + 36], 36U);
                    copy(out->g, pose, &row[l*168 + 72], 6U);
                    copy(out->friction, pose, &row[l*168 + 78], 6U);
                    copy(out->bias, pose, &row[l*168 + 84], 6U);
                    copy(out->bias_and_friction, pose, &row[l*168 + 90], 6U);
                    copy(out->H, pose, &row[l*168 + 96], 36U);
                    copy(out->H_dot, pose, &row[l*168 + 132], 36U);
                } else {
                    load_pose(motions, pose, &one);
                    code = stewart_exact_equations(model, &one, &found);
                    if (code == STEWART_OK) {
                        copy(out->M, pose, found.M, 36U);
                        copy(out->C, pose, found.C, 36U);
                        copy(out->g, pose, found.g, 6U);
                        copy(out->friction, pose, found.friction, 6U);
                        copy(out->bias, pose, found.bias, 6U);
                        copy(out->bias_and_friction, pose, found.bias_and_friction, 6U);
                        copy(out->H, pose, found.H, 36U);
                        copy(out->H_dot, pose, found.H_dot, 36U);
                    }
                }
                if (status != NULL) {
                    status[pose] = code;
                }
                result = result == STEWART_OK ? code : result;
            }
        }
    }
    return result;
}

/* Numbers of eight poses. */
typedef struct {
    stewart_real number[1032];
    stewart_real bad[LANES]; /* 1 if the function for one pose must compute the pose, else 0 */
} STEWART_ALIGNED derivatives_block;

/* Computes one leg of eight poses in lanes. */
STEWART_APART static void derivatives_leg_of_poses(
    const stewart_exact_model *STEWART_RESTRICT model, int leg, const motion_in_lanes *STEWART_RESTRICT at,
    const derivatives_pose *STEWART_RESTRICT pose, derivatives_legs *STEWART_RESTRICT out)
{
    int l;
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][leg], b_y = model->b[1][leg], b_z = model->b[2][leg];
        const stewart_real p_x = model->p[0][leg], p_y = model->p[1][leg], p_z = model->p[2][leg];
        const stewart_real k_x = model->k[0][leg], k_y = model->k[1][leg], k_z = model->k[2][leg];
        const stewart_real C_p = model->C_p[leg];
        const stewart_real C_s = model->C_s[leg];
        const stewart_real h_x = model->h[0][leg], h_y = model->h[1][leg], h_z = model->h[2][leg];
        const stewart_real h2_x = model->h2_x[leg];
        const stewart_real h2_z = model->h2_z[leg];
        const stewart_real w_x = model->w[0][leg], w_y = model->w[1][leg], w_z = model->w[2][leg];
        const stewart_real J_xx = model->J[0][leg], J_xy = model->J[1][leg], J_xz = model->J[2][leg], J_yy = model->J[3][leg],
            J_yz = model->J[4][leg], J_zz = model->J[5][leg];
        const stewart_real J2_xz = model->J2_xz[leg];
        const stewart_real dJ_zx = model->dJ_zx[leg];
        const stewart_real g_k = model->g_k[leg];
        const stewart_real g_x_k_x = model->g_x_k[0][leg], g_x_k_y = model->g_x_k[1][leg], g_x_k_z = model->g_x_k[2][leg];
        const stewart_real C_us = model->C_us[leg];
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real t_x = at->t[0][l], t_y = at->t[1][l], t_z = at->t[2][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        const stewart_real v_x = at->v[0][l], v_y = at->v[1][l], v_z = at->v[2][l];
        const stewart_real a_x = at->a[0][l], a_y = at->a[1][l], a_z = at->a[2][l];
        const stewart_real B_xx = pose->B[0][l], B_xy = pose->B[1][l], B_xz = pose->B[2][l], B_yx = pose->B[3][l],
            B_yy = pose->B[4][l], B_yz = pose->B[5][l], B_zx = pose->B[6][l], B_zy = pose->B[7][l], B_zz = pose->B[8][l];
        const stewart_real F = out->F[l];
        const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
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
        /* (10) distance of the tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y,
            k_cross_S_y, k_cross_S_x*k_cross_S_x)));
        const stewart_real inv_rho = REAL(1)/rho;
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_S_y, s_z, k_cross_S_z*s_y);
        const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_S_z, s_x, k_cross_S_x*s_z);
        const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_S_x, s_y, k_cross_S_y*s_x);
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
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(-omega_z, q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(-omega_x, q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(-omega_y, q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
        /* (5) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real L_dot = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
        /* (6) rates of the joint coordinates: L, phi about k, theta about y */
        const stewart_real phi_dot = inv_rho*STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y,
            S_dot_x*y_x));
        const stewart_real theta_dot = -inv_L*STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y,
            S_dot_x*z_x));
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
        const stewart_real S_ddot_x = STEWART_FMA(B_xz, q_z, STEWART_FMA(B_xy, q_y, STEWART_FMA(B_xx, q_x,
            a_x)));
        const stewart_real S_ddot_y = STEWART_FMA(B_yz, q_z, STEWART_FMA(B_yy, q_y, STEWART_FMA(B_yx, q_x,
            a_y)));
        const stewart_real S_ddot_z = STEWART_FMA(B_zz, q_z, STEWART_FMA(B_zy, q_y, STEWART_FMA(B_zx, q_x,
            a_z)));
        const stewart_real c6 = k3*k3;
        const stewart_real k33 = c6;
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y,
            STEWART_FMA(S_ddot_x, s_x, L*STEWART_FMA(k33, phi_dot2, theta_dot2))));
        const stewart_real c7 = REAL(2)*theta_dot;
        /* (9) accelerations of the joint coordinates without the rotation of the leg frame about s */
        const stewart_real own_theta_ddot = STEWART_FMA(-L_share, c7, -inv_L*STEWART_FMA(S_ddot_z, z_z,
            STEWART_FMA(S_ddot_y, z_y, S_ddot_x*z_x)));
        const stewart_real own_phi_ddot = STEWART_FMA(-L_share, two_phi_dot, inv_rho*STEWART_FMA(S_ddot_z,
            y_z, STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)));
        const stewart_real c8 = k1*k3;
        /* (9) accelerations of the joint coordinates */
        const stewart_real theta_ddot = STEWART_FMA(c8, phi_dot2, own_theta_ddot);
        const stewart_real phi_ddot = STEWART_FMA(-lean, two_phi_dot, own_phi_ddot);
        const stewart_real k13 = c8;
        const stewart_real L_h2 = L*h2_x;
        const stewart_real a1 = dJ_zx + L_h2;
        const stewart_real a2 = STEWART_FMA(-L, h2_z, J2_xz);
        const stewart_real c9 = STEWART_FMA(-L, h_y, J_xy);
        const stewart_real a3 = c9;
        const stewart_real c10 = J_yz*k3;
        /* (19) inertia of the joint coordinates */
        const stewart_real M_phi = STEWART_FMA(a2, k13, STEWART_FMA(a1, k33, J_xx));
        const stewart_real M_theta = J_yy + L_h2;
        const stewart_real M_mixed = STEWART_FMA(a3, k1, c10);
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
        const stewart_real m_T_xs = STEWART_FMA(m_leg_sy, y_x, m_leg_sz*z_x);
        const stewart_real m_T_xy = STEWART_FMA(m_leg_yy, y_x, STEWART_FMA(m_leg_yz, z_x, m_leg_sy*s_x));
        const stewart_real m_T_xz = STEWART_FMA(m_leg_yz, y_x, STEWART_FMA(m_leg_zz, z_x, m_leg_sz*s_x));
        const stewart_real m_T_ys = STEWART_FMA(m_leg_sy, y_y, m_leg_sz*z_y);
        const stewart_real m_T_yy = STEWART_FMA(m_leg_yy, y_y, STEWART_FMA(m_leg_yz, z_y, m_leg_sy*s_y));
        const stewart_real m_T_yz = STEWART_FMA(m_leg_yz, y_y, STEWART_FMA(m_leg_zz, z_y, m_leg_sz*s_y));
        const stewart_real m_T_zs = STEWART_FMA(m_leg_sy, y_z, m_leg_sz*z_z);
        const stewart_real m_T_zy = STEWART_FMA(m_leg_yy, y_z, STEWART_FMA(m_leg_yz, z_z, m_leg_sy*s_z));
        const stewart_real m_T_zz = STEWART_FMA(m_leg_yz, y_z, STEWART_FMA(m_leg_zz, z_z, m_leg_sz*s_z));
        /* inertia at the tip, base frame */
        const stewart_real m_xx = STEWART_FMA(m_T_xz, z_x, STEWART_FMA(m_T_xy, y_x, m_T_xs*s_x));
        const stewart_real m_xy = STEWART_FMA(m_T_xz, z_y, STEWART_FMA(m_T_xy, y_y, m_T_xs*s_y));
        const stewart_real m_xz = STEWART_FMA(m_T_xz, z_z, STEWART_FMA(m_T_xy, y_z, m_T_xs*s_z));
        const stewart_real m_yy = STEWART_FMA(m_T_yz, z_y, STEWART_FMA(m_T_yy, y_y, m_T_ys*s_y));
        const stewart_real m_yz = STEWART_FMA(m_T_yz, z_z, STEWART_FMA(m_T_yy, y_z, m_T_ys*s_z));
        const stewart_real m_zz = STEWART_FMA(m_T_zz, z_z, STEWART_FMA(m_T_zy, y_z, m_T_zs*s_z));
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* k x y */
        const stewart_real normal_x = STEWART_FMA(k_z, -y_y, k_y*y_z);
        const stewart_real normal_y = STEWART_FMA(k_x, -y_z, k_z*y_x);
        const stewart_real normal_z = STEWART_FMA(k_y, -y_x, k_x*y_y);
        /* omega along k x y, y and k */
        const stewart_real w_n_omega = STEWART_FMA(normal_z, omega_z, STEWART_FMA(normal_y, omega_y,
            normal_x*omega_x));
        const stewart_real w_y_omega = STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x));
        const stewart_real w_k_omega = STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y, k_x*omega_x));
        const stewart_real c15 = c6*h_x;
        const stewart_real c16 = STEWART_FMA(h_z*k1, -k3, c15);
        const stewart_real tau_L = STEWART_FMA(-c11, phi_ddot, STEWART_FMA(h_z, theta_ddot,
            STEWART_FMA(-c16, c4, STEWART_FMA(-c3, h_x, C_p*L_dot))));
        const stewart_real c18 = c7*h_x;
        const stewart_real c19 = REAL(2)*L;
        const stewart_real c20 = c19*h_x;
        const stewart_real c21 = STEWART_FMA(k1, w_x, k3*w_z);
        const stewart_real c22 = STEWART_FMA(-k3, w_x, k1*w_z);
        const stewart_real c24 = STEWART_FMA(c9, k1, c10);
        const stewart_real c25 = STEWART_FMA(-c19, h_z, REAL(2)*J_xz);
        const stewart_real c26 = c25*k1;
        const stewart_real c27 = J_zz - J_xx + c20;
        const stewart_real c28 = c27*k3;
        const stewart_real c29 = STEWART_FMA(REAL(2), c28, c26);
        const stewart_real c30 = STEWART_HALF*k1;
        const stewart_real c31 = STEWART_FMA(STEWART_HALF*c25, -c6, c29*c30);
        const stewart_real tau_theta = STEWART_FMA(c24, phi_ddot, STEWART_FMA(theta_ddot, J_yy + c20,
            STEWART_FMA(C_s, -w_y_omega, STEWART_FMA(L_dot, c18, STEWART_FMA(c21, gamma_n, STEWART_FMA(C_us,
            theta_dot, STEWART_FMA(-c31, c4, STEWART_FMA(-c22, g_k, L_ddot*h_z))))))));
        const stewart_real c33 = h_y*theta_dot;
        const stewart_real c34 = c33*k1;
        const stewart_real c35 = L_dot*c16;
        const stewart_real c36 = c31*theta_dot;
        const stewart_real c37 = L_dot*h_y;
        const stewart_real c38 = c37*k1;
        const stewart_real c39 = theta_dot*STEWART_FMA(-c9, k3, J_yz*k1);
        const stewart_real tau_phi = STEWART_FMA(phi_ddot, STEWART_FMA(c25, c8, STEWART_FMA(c27, c6, J_xx)),
            STEWART_FMA(c24, theta_ddot, STEWART_FMA(L_dot, STEWART_FMA(c16, phi_dot, -c34),
            STEWART_FMA(theta_dot, STEWART_FMA(c31, phi_dot, c39 - c38), STEWART_FMA(-gamma_n, w_y,
            STEWART_FMA(phi_dot, c35 + c36, STEWART_FMA(C_us, phi_dot, STEWART_FMA(-L_ddot, c11,
            STEWART_FMA(C_s, -w_k_omega, c22*gamma_y)))))))));
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
        const stewart_real c46 = STEWART_FMA(-c2, inv_rho, -c45);
        const stewart_real G_dot_32 = c46;
        const stewart_real c47 = c42*inv_rho;
        const stewart_real G_dot_33 = c47;
        const stewart_real c48 = c4*c6;
        const stewart_real G_ddot_11 = -c3 - c48;
        const stewart_real c49 = k3*phi_ddot;
        const stewart_real c50 = c5*k1;
        const stewart_real G_ddot_12 = STEWART_FMA(c50, theta_dot, c49);
        const stewart_real c51 = c4*c8;
        const stewart_real G_ddot_13 = c51 - theta_ddot;
        const stewart_real G_ddot_21 = STEWART_FMA(-inv_L, theta_ddot, STEWART_FMA(-c51, inv_L,
            REAL(2)*L_dot*c14*theta_dot));
        const stewart_real G_ddot_22 = STEWART_FMA(-c43, c50, STEWART_FMA(c41*c5, -k3, inv_L*k1*phi_ddot));
        const stewart_real c52 = c4*k1*k1;
        const stewart_real G_ddot_23 = STEWART_FMA(L_ddot, c14, STEWART_FMA(c52, inv_L,
            STEWART_FMA(REAL(2)*L_dot*L_dot*inv_L*inv_L, -inv_L, c3*inv_L)));
        const stewart_real G_ddot_31 = STEWART_FMA(-c49, inv_rho, STEWART_FMA(theta_dot,
            STEWART_FMA(inv_rho*k3*kappa, phi_dot, -c47), STEWART_FMA(-c40, c46, STEWART_FMA(c47, theta_dot,
            c1*c44))));
        const stewart_real c53 = inv_rho*kappa;
        const stewart_real c54 = -c1 - c2;
        const stewart_real G_ddot_32 = STEWART_FMA(-c53, theta_ddot, STEWART_FMA(theta_dot,
            STEWART_FMA(-c53, c54, -inv_rho*theta_dot*STEWART_FMA(-kappa, kappa, -REAL(1))),
            STEWART_FMA(-L_ddot, c13, STEWART_FMA(-c52, inv_rho, STEWART_FMA(-c48, inv_rho,
            L_dot*STEWART_FMA(-c13, c54, c43*inv_rho))))));
        const stewart_real G_ddot_33 = STEWART_FMA(inv_rho*k1, phi_ddot, STEWART_FMA(theta_dot,
            STEWART_FMA(-c47, kappa, -c44), STEWART_FMA(-c42, c45, STEWART_FMA(c44, theta_dot, c42*c46))));
        const stewart_real tau_rate_12 = -c18;
        const stewart_real tau_rate_13 = -c16*c5;
        const stewart_real tau_rate_21 = c18;
        const stewart_real c55 = REAL(2)*h_x;
        const stewart_real tau_rate_22 = STEWART_FMA(L_dot, c55, C_us);
        const stewart_real tau_rate_23 = -c31*c5;
        const stewart_real tau_rate_31 = REAL(2)*STEWART_FMA(c16, phi_dot, -c34);
        const stewart_real tau_rate_32 = STEWART_FMA(c31, c5, STEWART_FMA(REAL(2), -c38, REAL(2)*c39));
        const stewart_real tau_rate_33 = STEWART_FMA(REAL(2), c36, STEWART_FMA(REAL(2), c35, C_us));
        const stewart_real c56 = h_y*phi_ddot;
        const stewart_real c57 = STEWART_FMA(h_z, -k1, c55*k3);
        const stewart_real tau_place_12 = STEWART_FMA(-c48, h_z, k1*(-c4*c57 - c56));
        const stewart_real c58 = REAL(4)*h_x;
        const stewart_real c59 = STEWART_FMA(c30, STEWART_FMA(REAL(2)*h_z, -k1, c58*k3), c6*h_z);
        const stewart_real tau_place_21 = STEWART_FMA(-c56, k1, STEWART_FMA(-c4, c59, c55*theta_ddot));
        const stewart_real c60 = STEWART_FMA(-c25, k3, c30*STEWART_FMA(L, c58, STEWART_FMA(REAL(2), -J_xx,
            REAL(2)*J_zz)));
        const stewart_real c61 = c28 + c26;
        const stewart_real tau_place_22 = STEWART_FMA(-k3, STEWART_FMA(c9, phi_ddot, STEWART_FMA(-c4, c61,
            STEWART_FMA(g_k, -w_z, gamma_n*w_x))), k1*STEWART_FMA(J_yz, phi_ddot, STEWART_FMA(gamma_n, w_z,
            STEWART_FMA(-c4, c60, g_k*w_x))));
        const stewart_real tau_place_23 = STEWART_FMA(C_s, -w_n_omega, -c21*gamma_y);
        const stewart_real c62 = c59*phi_dot;
        const stewart_real tau_place_31 = STEWART_FMA(h_y*k1, -theta_ddot, STEWART_FMA(phi_ddot,
            REAL(2)*STEWART_FMA(-c8, h_z, c15), STEWART_FMA(theta_dot, STEWART_FMA(c11, theta_dot, c62),
            c62*theta_dot)));
        const stewart_real c63 = L_dot*c57;
        const stewart_real tau_place_32 = STEWART_FMA(-k3, STEWART_FMA(c25, c49, STEWART_FMA(L_dot,
            STEWART_FMA(-c40, h_z, -c33), STEWART_FMA(c9, theta_ddot, STEWART_FMA(theta_dot,
            STEWART_FMA(c61, phi_dot, STEWART_FMA(J_yz, theta_dot, -c37)), STEWART_FMA(phi_dot,
            STEWART_FMA(L_dot*h_z, -k3, c61*theta_dot), gamma_y*w_z))))), k1*STEWART_FMA(c29, phi_ddot,
            STEWART_FMA(J_yz, theta_ddot, STEWART_FMA(theta_dot, STEWART_FMA(-c9, theta_dot, c60*phi_dot),
            STEWART_FMA(-gamma_y, w_x, STEWART_FMA(phi_dot, STEWART_FMA(c60, theta_dot, c63),
            STEWART_FMA(-L_ddot, h_y, c63*phi_dot)))))));
        const stewart_real tau_place_33 = STEWART_FMA(gamma_y, w_y, c22*gamma_n);
        const stewart_real c64 = inv_rho*tau_phi;
        const stewart_real c65 = inv_L*tau_theta;
        const stewart_real c66 = tau_L - F;
        /* force at the tip, less the actuator's */
        const stewart_real R_tip_x = STEWART_FMA(-c65, z_x, STEWART_FMA(c66, s_x, c64*y_x));
        const stewart_real R_tip_y = STEWART_FMA(-c65, z_y, STEWART_FMA(c66, s_y, c64*y_y));
        const stewart_real R_tip_z = STEWART_FMA(-c65, z_z, STEWART_FMA(c66, s_z, c64*y_z));
        /* slope of a rate, times C_s */
        const stewart_real theta_dot_by_S_x = C_s*STEWART_FMA(G_dot_22, y_x, STEWART_FMA(G_dot_21, s_x,
            G_dot_23*z_x));
        const stewart_real theta_dot_by_S_y = C_s*STEWART_FMA(G_dot_22, y_y, STEWART_FMA(G_dot_21, s_y,
            G_dot_23*z_y));
        const stewart_real theta_dot_by_S_z = C_s*STEWART_FMA(G_dot_22, y_z, STEWART_FMA(G_dot_21, s_z,
            G_dot_23*z_z));
        const stewart_real phi_dot_by_S_x = C_s*STEWART_FMA(G_dot_31, s_x, STEWART_FMA(G_dot_33, z_x,
            G_dot_32*y_x));
        const stewart_real phi_dot_by_S_y = C_s*STEWART_FMA(G_dot_31, s_y, STEWART_FMA(G_dot_33, z_y,
            G_dot_32*y_y));
        const stewart_real phi_dot_by_S_z = C_s*STEWART_FMA(G_dot_31, s_z, STEWART_FMA(G_dot_33, z_z,
            G_dot_32*y_z));
        const stewart_real c67 = C_s*inv_L;
        /* gradient of theta, times C_s */
        const stewart_real C_s_theta_x = -c67*z_x;
        const stewart_real C_s_theta_y = -c67*z_y;
        const stewart_real C_s_theta_z = -c67*z_z;
        const stewart_real c68 = C_s*inv_rho;
        /* gradient of phi, times C_s */
        const stewart_real C_s_phi_x = c68*y_x;
        const stewart_real C_s_phi_y = c68*y_y;
        const stewart_real C_s_phi_z = c68*y_z;
        const stewart_real y_by_phi_x = normal_x*theta_dot;
        const stewart_real y_by_phi_y = normal_y*theta_dot;
        const stewart_real y_by_phi_z = normal_z*theta_dot;
        /* friction moment by S */
        const stewart_real f_S_xx = STEWART_FMA(k_x, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_x,
            C_s_phi_x*y_by_phi_x));
        const stewart_real f_S_xy = STEWART_FMA(k_x, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_x,
            C_s_phi_y*y_by_phi_x));
        const stewart_real f_S_xz = STEWART_FMA(k_x, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_x,
            C_s_phi_z*y_by_phi_x));
        const stewart_real f_S_yx = STEWART_FMA(k_y, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_y,
            C_s_phi_x*y_by_phi_y));
        const stewart_real f_S_yy = STEWART_FMA(k_y, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_y,
            C_s_phi_y*y_by_phi_y));
        const stewart_real f_S_yz = STEWART_FMA(k_y, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_y,
            C_s_phi_z*y_by_phi_y));
        const stewart_real f_S_zx = STEWART_FMA(k_z, phi_dot_by_S_x, STEWART_FMA(theta_dot_by_S_x, y_z,
            C_s_phi_x*y_by_phi_z));
        const stewart_real f_S_zy = STEWART_FMA(k_z, phi_dot_by_S_y, STEWART_FMA(theta_dot_by_S_y, y_z,
            C_s_phi_y*y_by_phi_z));
        const stewart_real f_S_zz = STEWART_FMA(k_z, phi_dot_by_S_z, STEWART_FMA(theta_dot_by_S_z, y_z,
            C_s_phi_z*y_by_phi_z));
        /* friction moment by S_dot */
        const stewart_real f_S_dot_xx = STEWART_FMA(C_s_phi_x, k_x, C_s_theta_x*y_x);
        const stewart_real f_S_dot_xy = STEWART_FMA(C_s_phi_y, k_x, C_s_theta_y*y_x);
        const stewart_real f_S_dot_xz = STEWART_FMA(C_s_phi_z, k_x, C_s_theta_z*y_x);
        const stewart_real f_S_dot_yx = STEWART_FMA(C_s_phi_x, k_y, C_s_theta_x*y_y);
        const stewart_real f_S_dot_yy = STEWART_FMA(C_s_phi_y, k_y, C_s_theta_y*y_y);
        const stewart_real f_S_dot_yz = STEWART_FMA(C_s_phi_z, k_y, C_s_theta_z*y_y);
        const stewart_real f_S_dot_zx = STEWART_FMA(C_s_phi_x, k_z, C_s_theta_x*y_z);
        const stewart_real f_S_dot_zy = STEWART_FMA(C_s_phi_y, k_z, C_s_theta_y*y_z);
        const stewart_real f_S_dot_zz = STEWART_FMA(C_s_phi_z, k_z, C_s_theta_z*y_z);
        const stewart_real A_0_leg_11 = STEWART_FMA(-G_ddot_31, k3_h, STEWART_FMA(G_ddot_21, h_z,
            STEWART_FMA(G_dot_31, tau_rate_13, G_dot_21*tau_rate_12)));
        const stewart_real A_0_leg_12 = STEWART_FMA(c12*k3, -tau_phi, STEWART_FMA(-G_ddot_32, k3_h,
            STEWART_FMA(G_ddot_22, h_z, STEWART_FMA(G_dot_32, tau_rate_13, STEWART_FMA(G_dot_22,
            tau_rate_12, C_p*G_dot_12)))));
        const stewart_real c69 = c14*tau_theta;
        const stewart_real A_0_leg_13 = STEWART_FMA(-inv_L, tau_place_12, STEWART_FMA(-G_ddot_33, k3_h,
            STEWART_FMA(G_dot_33, tau_rate_13, STEWART_FMA(G_dot_23, tau_rate_12, STEWART_FMA(C_p,
            -theta_dot, G_ddot_23*h_z))) + c69));
        const stewart_real c70 = c13*tau_phi;
        const stewart_real A_0_leg_21 = STEWART_FMA(inv_rho, STEWART_FMA(G_ddot_31, M_phi,
            STEWART_FMA(G_ddot_21, M_mixed, STEWART_FMA(G_dot_31, tau_rate_33, STEWART_FMA(-G_ddot_11, k3_h,
            G_dot_21*tau_rate_32))) + tau_place_31), -c70);
        const stewart_real A_0_leg_22 = STEWART_FMA(inv_rho, STEWART_FMA(-G_ddot_12, k3_h,
            STEWART_FMA(G_ddot_32, M_phi, STEWART_FMA(G_ddot_22, M_mixed, STEWART_FMA(G_dot_22, tau_rate_32,
            STEWART_FMA(G_dot_12, tau_rate_31, STEWART_FMA(inv_rho, tau_place_33,
            G_dot_32*tau_rate_33)))))), STEWART_FMA(c66*inv_rho, k3, c13*k1*tau_theta));
        const stewart_real A_0_leg_23 = STEWART_FMA(inv_rho, STEWART_FMA(-inv_L, tau_place_32,
            STEWART_FMA(G_ddot_33, M_phi, STEWART_FMA(-G_ddot_13, k3_h, STEWART_FMA(-tau_rate_31, theta_dot,
            STEWART_FMA(G_dot_23, tau_rate_32, STEWART_FMA(G_dot_33, tau_rate_33, G_ddot_23*M_mixed)))))),
            c70*kappa);
        const stewart_real A_0_leg_31 = STEWART_FMA(-inv_L, STEWART_FMA(G_ddot_31, M_mixed,
            STEWART_FMA(G_ddot_21, M_theta, STEWART_FMA(G_dot_31, tau_rate_23, STEWART_FMA(G_dot_21,
            tau_rate_22, G_ddot_11*h_z))) + tau_place_21), c69);
        const stewart_real A_0_leg_32 = STEWART_FMA(-inv_L, STEWART_FMA(G_ddot_32, M_mixed,
            STEWART_FMA(G_ddot_22, M_theta, STEWART_FMA(G_ddot_12, h_z, STEWART_FMA(inv_rho, tau_place_23,
            STEWART_FMA(G_dot_32, tau_rate_23, STEWART_FMA(G_dot_22, tau_rate_22,
            G_dot_12*tau_rate_21)))))), c12*k1*tau_phi);
        const stewart_real A_0_leg_33 = STEWART_FMA(-inv_L, STEWART_FMA(-inv_L, tau_place_22,
            STEWART_FMA(G_ddot_33, M_mixed, STEWART_FMA(G_ddot_13, h_z, STEWART_FMA(G_dot_33, tau_rate_23,
            STEWART_FMA(-tau_rate_21, theta_dot, STEWART_FMA(G_dot_23, tau_rate_22, G_ddot_23*M_theta)))))),
            c66*inv_L);
        const stewart_real A_0_T_xs = STEWART_FMA(A_0_leg_31, z_x, STEWART_FMA(A_0_leg_21, y_x,
            A_0_leg_11*s_x));
        const stewart_real A_0_T_xy = STEWART_FMA(A_0_leg_32, z_x, STEWART_FMA(A_0_leg_22, y_x,
            A_0_leg_12*s_x));
        const stewart_real A_0_T_xz = STEWART_FMA(A_0_leg_33, z_x, STEWART_FMA(A_0_leg_23, y_x,
            A_0_leg_13*s_x));
        const stewart_real A_0_T_ys = STEWART_FMA(A_0_leg_31, z_y, STEWART_FMA(A_0_leg_21, y_y,
            A_0_leg_11*s_y));
        const stewart_real A_0_T_yy = STEWART_FMA(A_0_leg_32, z_y, STEWART_FMA(A_0_leg_22, y_y,
            A_0_leg_12*s_y));
        const stewart_real A_0_T_yz = STEWART_FMA(A_0_leg_33, z_y, STEWART_FMA(A_0_leg_23, y_y,
            A_0_leg_13*s_y));
        const stewart_real A_0_T_zs = STEWART_FMA(A_0_leg_31, z_z, STEWART_FMA(A_0_leg_21, y_z,
            A_0_leg_11*s_z));
        const stewart_real A_0_T_zy = STEWART_FMA(A_0_leg_32, z_z, STEWART_FMA(A_0_leg_22, y_z,
            A_0_leg_12*s_z));
        const stewart_real A_0_T_zz = STEWART_FMA(A_0_leg_33, z_z, STEWART_FMA(A_0_leg_23, y_z,
            A_0_leg_13*s_z));
        /* force at the tip by S */
        const stewart_real A_0_xx = STEWART_FMA(A_0_T_xz, z_x, STEWART_FMA(A_0_T_xy, y_x, A_0_T_xs*s_x));
        const stewart_real A_0_xy = STEWART_FMA(A_0_T_xz, z_y, STEWART_FMA(A_0_T_xy, y_y, A_0_T_xs*s_y));
        const stewart_real A_0_xz = STEWART_FMA(A_0_T_xz, z_z, STEWART_FMA(A_0_T_xy, y_z, A_0_T_xs*s_z));
        const stewart_real A_0_yx = STEWART_FMA(A_0_T_yz, z_x, STEWART_FMA(A_0_T_yy, y_x, A_0_T_ys*s_x));
        const stewart_real A_0_yy = STEWART_FMA(A_0_T_yz, z_y, STEWART_FMA(A_0_T_yy, y_y, A_0_T_ys*s_y));
        const stewart_real A_0_yz = STEWART_FMA(A_0_T_yz, z_z, STEWART_FMA(A_0_T_yy, y_z, A_0_T_ys*s_z));
        const stewart_real A_0_zx = STEWART_FMA(A_0_T_zz, z_x, STEWART_FMA(A_0_T_zy, y_x, A_0_T_zs*s_x));
        const stewart_real A_0_zy = STEWART_FMA(A_0_T_zz, z_y, STEWART_FMA(A_0_T_zy, y_y, A_0_T_zs*s_y));
        const stewart_real A_0_zz = STEWART_FMA(A_0_T_zz, z_z, STEWART_FMA(A_0_T_zy, y_z, A_0_T_zs*s_z));
        const stewart_real c71 = REAL(2)*h_z;
        const stewart_real c72 = REAL(2)*k3_h;
        const stewart_real A_1_leg_11 = STEWART_FMA(-G_dot_31, c72, STEWART_FMA(G_dot_21, c71, C_p));
        const stewart_real A_1_leg_12 = STEWART_FMA(-G_dot_32, c72, STEWART_FMA(inv_rho, tau_rate_13,
            G_dot_22*c71));
        const stewart_real A_1_leg_13 = STEWART_FMA(-G_dot_33, c72, STEWART_FMA(-inv_L, tau_rate_12,
            REAL(2)*G_dot_23*h_z));
        const stewart_real c73 = REAL(2)*M_mixed;
        const stewart_real c74 = REAL(2)*M_phi;
        const stewart_real A_1_leg_21 = inv_rho*STEWART_FMA(G_dot_31, c74, STEWART_FMA(G_dot_21, c73,
            tau_rate_31));
        const stewart_real A_1_leg_22 = inv_rho*STEWART_FMA(-G_dot_12, c72, STEWART_FMA(G_dot_32, c74,
            STEWART_FMA(G_dot_22, c73, inv_rho*tau_rate_33)));
        const stewart_real A_1_leg_23 = inv_rho*STEWART_FMA(-inv_L, tau_rate_32, STEWART_FMA(G_dot_33, c74,
            STEWART_FMA(c7, k3_h, G_dot_23*c73)));
        const stewart_real c75 = REAL(2)*M_theta;
        const stewart_real A_1_leg_31 = -inv_L*STEWART_FMA(G_dot_31, c73, STEWART_FMA(G_dot_21, c75,
            tau_rate_21));
        const stewart_real A_1_leg_32 = -inv_L*STEWART_FMA(inv_rho, tau_rate_23, STEWART_FMA(G_dot_32, c73,
            STEWART_FMA(G_dot_22, c75, G_dot_12*c71)));
        const stewart_real A_1_leg_33 = -inv_L*STEWART_FMA(G_dot_33, c73, STEWART_FMA(-c7, h_z,
            STEWART_FMA(-inv_L, tau_rate_22, G_dot_23*c75)));
        const stewart_real A_1_T_xs = STEWART_FMA(A_1_leg_31, z_x, STEWART_FMA(A_1_leg_21, y_x,
            A_1_leg_11*s_x));
        const stewart_real A_1_T_xy = STEWART_FMA(A_1_leg_32, z_x, STEWART_FMA(A_1_leg_22, y_x,
            A_1_leg_12*s_x));
        const stewart_real A_1_T_xz = STEWART_FMA(A_1_leg_23, y_x, STEWART_FMA(A_1_leg_33, z_x,
            A_1_leg_13*s_x));
        const stewart_real A_1_T_ys = STEWART_FMA(A_1_leg_31, z_y, STEWART_FMA(A_1_leg_21, y_y,
            A_1_leg_11*s_y));
        const stewart_real A_1_T_yy = STEWART_FMA(A_1_leg_32, z_y, STEWART_FMA(A_1_leg_22, y_y,
            A_1_leg_12*s_y));
        const stewart_real A_1_T_yz = STEWART_FMA(A_1_leg_23, y_y, STEWART_FMA(A_1_leg_33, z_y,
            A_1_leg_13*s_y));
        const stewart_real A_1_T_zs = STEWART_FMA(A_1_leg_31, z_z, STEWART_FMA(A_1_leg_21, y_z,
            A_1_leg_11*s_z));
        const stewart_real A_1_T_zy = STEWART_FMA(A_1_leg_32, z_z, STEWART_FMA(A_1_leg_22, y_z,
            A_1_leg_12*s_z));
        const stewart_real A_1_T_zz = STEWART_FMA(A_1_leg_23, y_z, STEWART_FMA(A_1_leg_33, z_z,
            A_1_leg_13*s_z));
        /* force at the tip by S_dot */
        const stewart_real A_1_xx = STEWART_FMA(A_1_T_xy, y_x, STEWART_FMA(A_1_T_xs, s_x, A_1_T_xz*z_x));
        const stewart_real A_1_xy = STEWART_FMA(A_1_T_xy, y_y, STEWART_FMA(A_1_T_xs, s_y, A_1_T_xz*z_y));
        const stewart_real A_1_xz = STEWART_FMA(A_1_T_xy, y_z, STEWART_FMA(A_1_T_xs, s_z, A_1_T_xz*z_z));
        const stewart_real A_1_yx = STEWART_FMA(A_1_T_yy, y_x, STEWART_FMA(A_1_T_ys, s_x, A_1_T_yz*z_x));
        const stewart_real A_1_yy = STEWART_FMA(A_1_T_yy, y_y, STEWART_FMA(A_1_T_ys, s_y, A_1_T_yz*z_y));
        const stewart_real A_1_yz = STEWART_FMA(A_1_T_yy, y_z, STEWART_FMA(A_1_T_ys, s_z, A_1_T_yz*z_z));
        const stewart_real A_1_zx = STEWART_FMA(A_1_T_zy, y_x, STEWART_FMA(A_1_T_zs, s_x, A_1_T_zz*z_x));
        const stewart_real A_1_zy = STEWART_FMA(A_1_T_zy, y_y, STEWART_FMA(A_1_T_zs, s_y, A_1_T_zz*z_y));
        const stewart_real A_1_zz = STEWART_FMA(A_1_T_zy, y_z, STEWART_FMA(A_1_T_zs, s_z, A_1_T_zz*z_z));
        /* derivative of the force by rotation about the tip */
        const stewart_real X_xx = STEWART_FMA(-A_1_xz, omega_y, STEWART_FMA(A_1_xy, omega_z,
            STEWART_FMA(B_zx, m_xz, STEWART_FMA(B_yx, m_xy, B_xx*m_xx)))) + A_0_xx;
        const stewart_real X_xy = STEWART_FMA(-A_1_xx, omega_z, STEWART_FMA(A_1_xz, omega_x,
            STEWART_FMA(B_zy, m_xz, STEWART_FMA(B_yy, m_xy, B_xy*m_xx)))) + A_0_xy;
        const stewart_real X_xz = STEWART_FMA(-A_1_xy, omega_x, STEWART_FMA(A_1_xx, omega_y,
            STEWART_FMA(B_zz, m_xz, STEWART_FMA(B_yz, m_xy, B_xz*m_xx)))) + A_0_xz;
        const stewart_real X_yx = STEWART_FMA(-A_1_yz, omega_y, STEWART_FMA(A_1_yy, omega_z,
            STEWART_FMA(B_zx, m_yz, STEWART_FMA(B_yx, m_yy, B_xx*m_xy)))) + A_0_yx;
        const stewart_real X_yy = STEWART_FMA(-A_1_yx, omega_z, STEWART_FMA(A_1_yz, omega_x,
            STEWART_FMA(B_zy, m_yz, STEWART_FMA(B_yy, m_yy, B_xy*m_xy)))) + A_0_yy;
        const stewart_real X_yz = STEWART_FMA(-A_1_yy, omega_x, STEWART_FMA(A_1_yx, omega_y,
            STEWART_FMA(B_zz, m_yz, STEWART_FMA(B_yz, m_yy, B_xz*m_xy)))) + A_0_yz;
        const stewart_real X_zx = STEWART_FMA(-A_1_zz, omega_y, STEWART_FMA(A_1_zy, omega_z,
            STEWART_FMA(B_zx, m_zz, STEWART_FMA(B_yx, m_yz, B_xx*m_xz)))) + A_0_zx;
        const stewart_real X_zy = STEWART_FMA(-A_1_zx, omega_z, STEWART_FMA(A_1_zz, omega_x,
            STEWART_FMA(B_zy, m_zz, STEWART_FMA(B_yy, m_yz, B_xy*m_xz)))) + A_0_zy;
        const stewart_real X_zz = STEWART_FMA(-A_1_zy, omega_x, STEWART_FMA(A_1_zx, omega_y,
            STEWART_FMA(B_zz, m_zz, STEWART_FMA(B_yz, m_yz, B_xz*m_xz)))) + A_0_zz;
        const stewart_real c76 = m_xy*omega_z;
        const stewart_real c77 = m_xz*omega_y;
        const stewart_real Y_xx = c76 - c77 + A_1_xx;
        const stewart_real Y_xy = STEWART_FMA(-m_xx, omega_z, m_xz*omega_x) + A_1_xy;
        const stewart_real Y_xz = STEWART_FMA(-m_xy, omega_x, m_xx*omega_y) + A_1_xz;
        const stewart_real Y_yx = STEWART_FMA(-m_yz, omega_y, m_yy*omega_z) + A_1_yx;
        const stewart_real c78 = m_yz*omega_x;
        const stewart_real Y_yy = c78 - c76 + A_1_yy;
        const stewart_real Y_yz = STEWART_FMA(-m_yy, omega_x, m_xy*omega_y) + A_1_yz;
        const stewart_real Y_zx = STEWART_FMA(-m_zz, omega_y, m_yz*omega_z) + A_1_zx;
        const stewart_real Y_zy = STEWART_FMA(-m_xz, omega_z, m_zz*omega_x) + A_1_zy;
        const stewart_real Y_zz = c77 - c78 + A_1_zz;
        const stewart_real c79 = X_xy*q_z;
        const stewart_real Z_xx = STEWART_FMA(X_xz, q_y, -c79);
        const stewart_real c80 = X_xx*q_z;
        const stewart_real Z_xy = STEWART_FMA(-X_xz, q_x, c80);
        const stewart_real c81 = X_xx*q_y;
        const stewart_real Z_xz = STEWART_FMA(X_xy, q_x, -c81);
        const stewart_real c82 = X_yy*q_z;
        const stewart_real Z_yx = STEWART_FMA(X_yz, q_y, -c82);
        const stewart_real c83 = X_yx*q_z;
        const stewart_real c84 = -X_yz*q_x;
        const stewart_real Z_yy = c83 + c84;
        const stewart_real c85 = -X_yy*q_x;
        const stewart_real Z_yz = -X_yx*q_y - c85;
        const stewart_real c86 = -X_zz*q_y;
        const stewart_real Z_zx = -X_zy*q_z - c86;
        const stewart_real c87 = -X_zz*q_x;
        const stewart_real Z_zy = STEWART_FMA(X_zx, q_z, c87);
        const stewart_real c88 = X_zx*q_y;
        const stewart_real Z_zz = STEWART_FMA(X_zy, q_x, -c88);
        const stewart_real c89 = m_xy*w_q_z;
        const stewart_real c90 = m_xz*w_q_y;
        const stewart_real V_xx = STEWART_FMA(-Y_xy, q_z, STEWART_FMA(Y_xz, q_y, c90 - f_S_dot_xx - c89));
        const stewart_real V_xy = STEWART_FMA(-Y_xz, q_x, STEWART_FMA(Y_xx, q_z, STEWART_FMA(-m_xz, w_q_x,
            STEWART_FMA(m_xx, w_q_z, -f_S_dot_yx))));
        const stewart_real V_xz = STEWART_FMA(-Y_xx, q_y, STEWART_FMA(Y_xy, q_x, STEWART_FMA(-m_xx, w_q_y,
            STEWART_FMA(m_xy, w_q_x, -f_S_dot_zx))));
        const stewart_real V_yx = STEWART_FMA(-Y_yy, q_z, STEWART_FMA(Y_yz, q_y, STEWART_FMA(-m_yy, w_q_z,
            STEWART_FMA(m_yz, w_q_y, -f_S_dot_xy))));
        const stewart_real c91 = m_yz*w_q_x;
        const stewart_real V_yy = STEWART_FMA(-Y_yz, q_x, STEWART_FMA(Y_yx, q_z, c89 - f_S_dot_yy - c91));
        const stewart_real V_yz = STEWART_FMA(-Y_yx, q_y, STEWART_FMA(Y_yy, q_x, STEWART_FMA(-m_xy, w_q_y,
            STEWART_FMA(m_yy, w_q_x, -f_S_dot_zy))));
        const stewart_real V_zx = STEWART_FMA(-Y_zy, q_z, STEWART_FMA(Y_zz, q_y, STEWART_FMA(-m_yz, w_q_z,
            STEWART_FMA(m_zz, w_q_y, -f_S_dot_xz))));
        const stewart_real V_zy = STEWART_FMA(-Y_zz, q_x, STEWART_FMA(Y_zx, q_z, STEWART_FMA(-m_zz, w_q_x,
            STEWART_FMA(m_xz, w_q_z, -f_S_dot_yz))));
        const stewart_real V_zz = STEWART_FMA(-Y_zx, q_y, STEWART_FMA(Y_zy, q_x, c91 - f_S_dot_zz - c90));
        /* derivative of the moment by rotation about the tip */
        const stewart_real Q_xx = STEWART_FMA(-f_S_dot_xz, omega_y, f_S_dot_xy*omega_z) + f_S_xx + c83 - c88;
        const stewart_real Q_xy = STEWART_FMA(-X_zy, q_y, STEWART_FMA(-f_S_dot_xx, omega_z,
            f_S_dot_xz*omega_x) + f_S_xy - R_tip_z + c82);
        const stewart_real Q_xz = STEWART_FMA(X_yz, q_z, STEWART_FMA(-f_S_dot_xy, omega_x,
            f_S_dot_xx*omega_y) + f_S_xz + R_tip_y) + c86;
        const stewart_real Q_yx = STEWART_FMA(X_zx, q_x, STEWART_FMA(-f_S_dot_yz, omega_y,
            f_S_dot_yy*omega_z) + f_S_yx + R_tip_z) - c80;
        const stewart_real Q_yy = STEWART_FMA(X_zy, q_x, STEWART_FMA(-f_S_dot_yx, omega_z,
            f_S_dot_yz*omega_x) + f_S_yy) - c79;
        const stewart_real Q_yz = STEWART_FMA(-X_xz, q_z, STEWART_FMA(-f_S_dot_yy, omega_x,
            f_S_dot_yx*omega_y) + f_S_yz - R_tip_x) - c87;
        const stewart_real Q_zx = STEWART_FMA(-X_yx, q_x, STEWART_FMA(-f_S_dot_zz, omega_y,
            f_S_dot_zy*omega_z) + f_S_zx - R_tip_y + c81);
        const stewart_real Q_zy = STEWART_FMA(X_xy, q_y, STEWART_FMA(-f_S_dot_zx, omega_z,
            f_S_dot_zz*omega_x) + f_S_zy + R_tip_x) + c85;
        const stewart_real Q_zz = STEWART_FMA(X_xz, q_y, STEWART_FMA(-f_S_dot_zy, omega_x,
            f_S_dot_zx*omega_y) + f_S_zz) + c84;
        const stewart_real c92 = m_xy*q_z;
        const stewart_real c93 = m_xz*q_y;
        const stewart_real c94 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c92 - c93;
        const stewart_real m_q_xy = STEWART_FMA(-m_xx, q_z, m_xz*q_x);
        const stewart_real m_q_xz = STEWART_FMA(-m_xy, q_x, m_xx*q_y);
        const stewart_real m_q_yx = STEWART_FMA(-m_yz, q_y, m_yy*q_z);
        const stewart_real m_q_yy = -c92 - c94;
        const stewart_real m_q_yz = STEWART_FMA(-m_yy, q_x, m_xy*q_y);
        const stewart_real m_q_zx = STEWART_FMA(-m_zz, q_y, m_yz*q_z);
        const stewart_real m_q_zy = STEWART_FMA(-m_xz, q_z, m_zz*q_x);
        const stewart_real m_q_zz = c93 + c94;
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
        out->sum[15][l] = STEWART_FMA(-m_q_zx, q_y, m_q_yx*q_z);
        out->sum[16][l] = STEWART_FMA(-m_q_zy, q_y, m_q_yy*q_z);
        out->sum[17][l] = STEWART_FMA(-m_q_zz, q_y, m_q_yz*q_z);
        out->sum[18][l] = STEWART_FMA(-m_q_xy, q_z, m_q_zy*q_x);
        out->sum[19][l] = STEWART_FMA(-m_q_xz, q_z, m_q_zz*q_x);
        out->sum[20][l] = STEWART_FMA(-m_q_yz, q_x, m_q_xz*q_y);
        out->sum[21][l] = A_0_xx;
        out->sum[22][l] = A_0_xy;
        out->sum[23][l] = A_0_xz;
        out->sum[24][l] = Z_xx;
        out->sum[25][l] = Z_xy;
        out->sum[26][l] = Z_xz;
        out->sum[27][l] = A_0_yx;
        out->sum[28][l] = A_0_yy;
        out->sum[29][l] = A_0_yz;
        out->sum[30][l] = Z_yx;
        out->sum[31][l] = Z_yy;
        out->sum[32][l] = Z_yz;
        out->sum[33][l] = A_0_zx;
        out->sum[34][l] = A_0_zy;
        out->sum[35][l] = A_0_zz;
        out->sum[36][l] = Z_zx;
        out->sum[37][l] = Z_zy;
        out->sum[38][l] = Z_zz;
        out->sum[39][l] = STEWART_FMA(-A_0_yx, q_z, STEWART_FMA(A_0_zx, q_y, -f_S_xx));
        out->sum[40][l] = STEWART_FMA(-A_0_yy, q_z, STEWART_FMA(A_0_zy, q_y, -f_S_xy));
        out->sum[41][l] = STEWART_FMA(-A_0_yz, q_z, STEWART_FMA(A_0_zz, q_y, -f_S_xz));
        out->sum[42][l] = STEWART_FMA(-Q_xz, q_y, Q_xy*q_z);
        out->sum[43][l] = STEWART_FMA(-Q_xx, q_z, Q_xz*q_x);
        out->sum[44][l] = STEWART_FMA(-Q_xy, q_x, Q_xx*q_y);
        out->sum[45][l] = STEWART_FMA(-A_0_zx, q_x, STEWART_FMA(A_0_xx, q_z, -f_S_yx));
        out->sum[46][l] = STEWART_FMA(-A_0_zy, q_x, STEWART_FMA(A_0_xy, q_z, -f_S_yy));
        out->sum[47][l] = STEWART_FMA(-A_0_zz, q_x, STEWART_FMA(A_0_xz, q_z, -f_S_yz));
        out->sum[48][l] = STEWART_FMA(-Q_yz, q_y, Q_yy*q_z);
        out->sum[49][l] = STEWART_FMA(-Q_yx, q_z, Q_yz*q_x);
        out->sum[50][l] = STEWART_FMA(-Q_yy, q_x, Q_yx*q_y);
        out->sum[51][l] = STEWART_FMA(-A_0_xx, q_y, STEWART_FMA(A_0_yx, q_x, -f_S_zx));
        out->sum[52][l] = STEWART_FMA(-A_0_xy, q_y, STEWART_FMA(A_0_yy, q_x, -f_S_zy));
        out->sum[53][l] = STEWART_FMA(-A_0_xz, q_y, STEWART_FMA(A_0_yz, q_x, -f_S_zz));
        out->sum[54][l] = STEWART_FMA(-Q_zz, q_y, Q_zy*q_z);
        out->sum[55][l] = STEWART_FMA(-Q_zx, q_z, Q_zz*q_x);
        out->sum[56][l] = STEWART_FMA(-Q_zy, q_x, Q_zx*q_y);
        out->sum[57][l] = A_1_xx;
        out->sum[58][l] = A_1_xy;
        out->sum[59][l] = A_1_xz;
        out->sum[60][l] = V_xx;
        out->sum[61][l] = V_xy;
        out->sum[62][l] = V_xz;
        out->sum[63][l] = A_1_yx;
        out->sum[64][l] = A_1_yy;
        out->sum[65][l] = A_1_yz;
        out->sum[66][l] = V_yx;
        out->sum[67][l] = V_yy;
        out->sum[68][l] = V_yz;
        out->sum[69][l] = A_1_zx;
        out->sum[70][l] = A_1_zy;
        out->sum[71][l] = A_1_zz;
        out->sum[72][l] = V_zx;
        out->sum[73][l] = V_zy;
        out->sum[74][l] = V_zz;
        out->sum[75][l] = STEWART_FMA(-A_1_yx, q_z, STEWART_FMA(A_1_zx, q_y, -f_S_dot_xx));
        out->sum[76][l] = STEWART_FMA(-A_1_yy, q_z, STEWART_FMA(A_1_zy, q_y, -f_S_dot_xy));
        out->sum[77][l] = STEWART_FMA(-A_1_yz, q_z, STEWART_FMA(A_1_zz, q_y, -f_S_dot_xz));
        out->sum[78][l] = STEWART_FMA(-f_S_dot_xz, q_y, STEWART_FMA(-V_yx, q_z, STEWART_FMA(f_S_dot_xy, q_z,
            V_zx*q_y)));
        out->sum[79][l] = STEWART_FMA(-f_S_dot_xx, q_z, STEWART_FMA(-V_yy, q_z, STEWART_FMA(f_S_dot_xz, q_x,
            V_zy*q_y)));
        out->sum[80][l] = STEWART_FMA(-f_S_dot_xy, q_x, STEWART_FMA(-V_yz, q_z, STEWART_FMA(f_S_dot_xx, q_y,
            V_zz*q_y)));
        out->sum[81][l] = STEWART_FMA(-A_1_zx, q_x, STEWART_FMA(A_1_xx, q_z, -f_S_dot_yx));
        out->sum[82][l] = STEWART_FMA(-A_1_zy, q_x, STEWART_FMA(A_1_xy, q_z, -f_S_dot_yy));
        out->sum[83][l] = STEWART_FMA(-A_1_zz, q_x, STEWART_FMA(A_1_xz, q_z, -f_S_dot_yz));
        out->sum[84][l] = STEWART_FMA(-f_S_dot_yz, q_y, STEWART_FMA(-V_zx, q_x, STEWART_FMA(f_S_dot_yy, q_z,
            V_xx*q_z)));
        out->sum[85][l] = STEWART_FMA(-f_S_dot_yx, q_z, STEWART_FMA(-V_zy, q_x, STEWART_FMA(f_S_dot_yz, q_x,
            V_xy*q_z)));
        out->sum[86][l] = STEWART_FMA(-f_S_dot_yy, q_x, STEWART_FMA(-V_zz, q_x, STEWART_FMA(f_S_dot_yx, q_y,
            V_xz*q_z)));
        out->sum[87][l] = STEWART_FMA(-A_1_xx, q_y, STEWART_FMA(A_1_yx, q_x, -f_S_dot_zx));
        out->sum[88][l] = STEWART_FMA(-A_1_xy, q_y, STEWART_FMA(A_1_yy, q_x, -f_S_dot_zy));
        out->sum[89][l] = STEWART_FMA(-A_1_xz, q_y, STEWART_FMA(A_1_yz, q_x, -f_S_dot_zz));
        out->sum[90][l] = STEWART_FMA(-f_S_dot_zz, q_y, STEWART_FMA(-V_xx, q_y, STEWART_FMA(f_S_dot_zy, q_z,
            V_yx*q_x)));
        out->sum[91][l] = STEWART_FMA(-f_S_dot_zx, q_z, STEWART_FMA(-V_xy, q_y, STEWART_FMA(f_S_dot_zz, q_x,
            V_yy*q_x)));
        out->sum[92][l] = STEWART_FMA(-f_S_dot_zy, q_x, STEWART_FMA(-V_xz, q_y, STEWART_FMA(f_S_dot_zx, q_y,
            V_yz*q_x)));
        out->H_force[0][l] = s_x;
        out->H_force[1][l] = s_y;
        out->H_force[2][l] = s_z;
        out->H_moment[0][l] = STEWART_FMA(-q_z, s_y, q_y*s_z);
        out->H_moment[1][l] = STEWART_FMA(-q_x, s_z, q_z*s_x);
        out->H_moment[2][l] = STEWART_FMA(-q_y, s_x, q_x*s_y);
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* One leg of eight poses; ``bad`` is 1 if the function for one pose must compute the pose. */
static void derivatives_leg_of_block(
    const stewart_exact_model *model, int leg, const motion_in_lanes *at,
    stewart_real (*STEWART_RESTRICT acting)[LANES], const derivatives_pose *pose,
    derivatives_legs *STEWART_RESTRICT legs, derivatives_block *STEWART_RESTRICT out)
{
    int l;
    for (l = 0; l < LANES; ++l) {
        legs->F[l] = acting[leg][l];
    }
    derivatives_leg_of_poses(model, leg, at, pose, legs);
    for (l = 0; l < LANES; ++l) {
        out->number[8*(93 + leg) + l] = legs->H_force[0][l];
        out->number[8*(99 + leg) + l] = legs->H_force[1][l];
        out->number[8*(105 + leg) + l] = legs->H_force[2][l];
        out->number[8*(111 + leg) + l] = legs->H_moment[0][l];
        out->number[8*(117 + leg) + l] = legs->H_moment[1][l];
        out->number[8*(123 + leg) + l] = legs->H_moment[2][l];
        stewart_real fault = STEWART_LARGER(legs->checked.bad[l], out->bad[l]);
        fault = legs->checked.k3[l] > STEWART_LEANING ? fault : REAL(1);
        out->bad[l] = fault;
    }
}

/* Sums over platform and legs of eight poses. */
static void derivatives_of_block(
    const stewart_exact_model *model, const motion_in_lanes *at, stewart_real acting[6][LANES],
    derivatives_block *out)
{
    int i, l;
    derivatives_pose pose;
    derivatives_legs even;
    derivatives_legs odd;
    STEWART_ALIGNED stewart_real own[744];
    derivatives_of_pose(model, at, LANES, &pose, own);
    for (l = 0; l < LANES; ++l) {
        out->bad[l] = REAL(0);
    }
    for (i = 0; i < 3; ++i) {
        derivatives_leg_of_block(model, 2*i, at, acting, &pose, &even, out);
        derivatives_leg_of_block(model, 2*i + 1, at, acting, &pose, &odd, out);
        add_two(even.sum, odd.sum, 93, i, &out->number[0*LANES]);
    }
    for (i = 0; i < 744; ++i) {
        out->number[0*LANES + i] = own[i] + out->number[0*LANES + i];
    }
}

int stewart_exact_derivatives_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions,
    const stewart_derivatives_arrays *out, int *status)
{
    size_t first;
    int l;
    motion_in_lanes at;
    derivatives_block block;
    STEWART_ALIGNED stewart_real row[1034];
    stewart_motion one;
    stewart_real acting[6][LANES];
    stewart_real F[48] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    if (model == NULL || motions == NULL || out == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL || motions->alpha == NULL || motions->a == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    stewart_derivatives found;
    int result = STEWART_OK;
    for (first = 0; first < count; first += (size_t)LANES) {
        load_motions(motions, first, count, &at);
        stewart_motions part;
        const size_t size_of_block = count - first < LANES ? count - first : LANES;
        part.R = &motions->R[9U*first];
        part.t = &motions->t[3U*first];
        part.omega = &motions->omega[3U*first];
        part.v = &motions->v[3U*first];
        part.alpha = &motions->alpha[3U*first];
        part.a = &motions->a[3U*first];
        part.F_ext = motions->F_ext != NULL ? &motions->F_ext[3U*first] : NULL;
        part.M_ext = motions->M_ext != NULL ? &motions->M_ext[3U*first] : NULL;
        const int held = stewart_exact_forces_batch(model, size_of_block, &part, F, NULL);
        load_forces(F, 0, size_of_block, acting);
        derivatives_of_block(model, &at, acting, &block);
        if (held != STEWART_OK) {
            for (l = 0; l < LANES; ++l) {
                block.bad[l] = REAL(1);
            }
        }
        in_rows(block.number, 129, row);
        for (l = 0; l < LANES; ++l) {
            if (!(first + (size_t)l < count)) {
                break;
            }
            const size_t pose = first + (size_t)l;
            int code = block.bad[l] > REAL(0) ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_OK;
            if (code == STEWART_OK) {
                code = slopes(model->per_length, &row[l*129], &F[l*6], &found);
            }
            if (code == STEWART_OK) {
                copy(out->F, pose, found.F, 6U);
                copy(out->by_pose, pose, found.by_pose, 36U);
                copy(out->by_twist, pose, found.by_twist, 36U);
                copy(out->by_acceleration, pose, found.by_acceleration, 36U);
            } else {
                load_pose(motions, pose, &one);
                code = stewart_exact_derivatives(model, &one, &found);
                if (code == STEWART_OK) {
                    copy(out->F, pose, found.F, 6U);
                    copy(out->by_pose, pose, found.by_pose, 36U);
                    copy(out->by_twist, pose, found.by_twist, 36U);
                    copy(out->by_acceleration, pose, found.by_acceleration, 36U);
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

int stewart_exact_linearization_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions, const stewart_real *F,
    const stewart_linearization_arrays *out, int *status)
{
    size_t pose;
    stewart_motion one;
    stewart_linearization found;
    if (model == NULL || motions == NULL || out == NULL || F == NULL || motions->R == NULL || motions->t == NULL
        || motions->omega == NULL || motions->v == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    int result = STEWART_OK;
    for (pose = 0; pose < count; ++pose) {
        load_pose(motions, pose, &one);
        const int code = stewart_exact_linearization(model, &one, &F[pose*6U], &found);
        if (code == STEWART_OK) {
            copy(out->acceleration, pose, found.acceleration, 6U);
            copy(out->A, pose, found.A, 144U);
            copy(out->B, pose, found.B, 72U);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}

/* Numbers of eight poses. */
typedef struct {
    stewart_real number[48];
    stewart_real bad[LANES]; /* 1 if the function for one pose must compute the pose, else 0 */
} STEWART_ALIGNED bias_block;

/* Computes one leg of eight poses in lanes. */
STEWART_APART static void bias_leg_of_poses(
    const stewart_exact_model *STEWART_RESTRICT model, int leg, const motion_in_lanes *STEWART_RESTRICT at,
    const bias_pose *STEWART_RESTRICT pose, bias_legs *STEWART_RESTRICT out)
{
    int l;
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][leg], b_y = model->b[1][leg], b_z = model->b[2][leg];
        const stewart_real p_x = model->p[0][leg], p_y = model->p[1][leg], p_z = model->p[2][leg];
        const stewart_real k_x = model->k[0][leg], k_y = model->k[1][leg], k_z = model->k[2][leg];
        const stewart_real C_p = model->C_p[leg];
        const stewart_real C_s = model->C_s[leg];
        const stewart_real h_x = model->h[0][leg], h_y = model->h[1][leg], h_z = model->h[2][leg];
        const stewart_real h2_x = model->h2_x[leg];
        const stewart_real h2_y = model->h2_y[leg];
        const stewart_real h2_z = model->h2_z[leg];
        const stewart_real w_x = model->w[0][leg], w_y = model->w[1][leg], w_z = model->w[2][leg];
        const stewart_real J_xx = model->J[0][leg], J_xy = model->J[1][leg], J_yy = model->J[3][leg], J_yz = model->J[4][leg];
        const stewart_real J2_xz = model->J2_xz[leg];
        const stewart_real dJ_zx = model->dJ_zx[leg];
        const stewart_real g_k = model->g_k[leg];
        const stewart_real g_x_k_x = model->g_x_k[0][leg], g_x_k_y = model->g_x_k[1][leg], g_x_k_z = model->g_x_k[2][leg];
        const stewart_real C_us = model->C_us[leg];
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real t_x = at->t[0][l], t_y = at->t[1][l], t_z = at->t[2][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        const stewart_real v_x = at->v[0][l], v_y = at->v[1][l], v_z = at->v[2][l];
        const stewart_real B_0_xx = pose->B_0[0][l], B_0_xy = pose->B_0[1][l], B_0_xz = pose->B_0[2][l],
            B_0_yx = pose->B_0[3][l], B_0_yy = pose->B_0[4][l], B_0_yz = pose->B_0[5][l], B_0_zx = pose->B_0[6][l],
            B_0_zy = pose->B_0[7][l], B_0_zz = pose->B_0[8][l];
        const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
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
        /* (10) distance of the tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y,
            k_cross_S_y, k_cross_S_x*k_cross_S_x)));
        const stewart_real inv_rho = REAL(1)/rho;
        /* relative component of the normal along s: rounding */
        const stewart_real n_along_s = inv_rho*STEWART_FMA(k_cross_S_z, s_z, STEWART_FMA(k_cross_S_y, s_y,
            k_cross_S_x*s_x));
        /* one over |s x normal| */
        const stewart_real inv_across = STEWART_FMA(STEWART_HALF*inv_rho*n_along_s, n_along_s, inv_rho);
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_S_y, s_z, k_cross_S_z*s_y);
        const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_S_z, s_x, k_cross_S_x*s_z);
        const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_S_x, s_y, k_cross_S_y*s_x);
        /* (10) third axis of the leg frame */
        const stewart_real z_x = inv_across*s_cross_normal_x;
        const stewart_real z_y = inv_across*s_cross_normal_y;
        const stewart_real z_z = inv_across*s_cross_normal_z;
        /* (10) rotating axis of the universal joint */
        const stewart_real y_x = STEWART_FMA(-s_y, z_z, s_z*z_y);
        const stewart_real y_y = STEWART_FMA(-s_z, z_x, s_x*z_z);
        const stewart_real y_z = STEWART_FMA(-s_x, z_y, s_y*z_x);
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1 = inv_L*zeta;
        const stewart_real k3 = inv_L*rho;
        /* (10) k1 / k3 */
        const stewart_real kappa = inv_rho*zeta;
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(-omega_z, q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(-omega_x, q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(-omega_y, q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
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
        /* (7) acceleration of the platform point, a = alpha = 0 */
        const stewart_real S_ddot_x = STEWART_FMA(B_0_xz, q_z, STEWART_FMA(B_0_xy, q_y, B_0_xx*q_x));
        const stewart_real S_ddot_y = STEWART_FMA(B_0_yz, q_z, STEWART_FMA(B_0_yy, q_y, B_0_yx*q_x));
        const stewart_real S_ddot_z = STEWART_FMA(B_0_zz, q_z, STEWART_FMA(B_0_zy, q_y, B_0_zx*q_x));
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
        const stewart_real M_phi_L = STEWART_FMA(h_z, -k13, h_x*k33);
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
            STEWART_FMA(C_s, -STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x)),
            STEWART_FMA(gamma_n, w_k, STEWART_FMA(bend, h2_x, STEWART_FMA(C_us, theta_dot,
            STEWART_FMA(phi_dot2, STEWART_FMA(-c3, STEWART_HALF - k33, k13*(J_yy - dJ_zx)), STEWART_FMA(g_k,
            w_n, L_ddot*h_z))))))));
        const stewart_real tau_k = STEWART_FMA(M_phi, own_phi_ddot, STEWART_FMA(M_mixed, theta_ddot,
            STEWART_FMA(bend*h2_y, -k1, STEWART_FMA(two_phi_dot, STEWART_FMA(-theta_dot, STEWART_FMA(J_xx,
            kappa, STEWART_FMA(STEWART_HALF, -c2, STEWART_HALF*J2_xz)), L_dot*M_phi_L),
            STEWART_FMA(-gamma_y, w_n, STEWART_FMA(-gamma_n, w_y, STEWART_FMA(C_us, phi_dot,
            STEWART_FMA(-L_ddot, k3_h, STEWART_FMA(C_s, -STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y,
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
            STEWART_FMA(-M_phi_L, phi_dot2, STEWART_FMA(h_x, -theta_dot2, C_p*L_dot))));
        /* force at the tip */
        const stewart_real R_tip_x = STEWART_FMA(D, s_x, K_x);
        const stewart_real R_tip_y = STEWART_FMA(D, s_y, K_y);
        const stewart_real R_tip_z = STEWART_FMA(D, s_z, K_z);
        out->sum[0][l] = R_tip_x;
        out->sum[1][l] = R_tip_y;
        out->sum[2][l] = R_tip_z;
        out->sum[3][l] = STEWART_FMA(C_s, -STEWART_FMA(theta_dot, y_x, k_x*phi_dot), STEWART_FMA(-R_tip_y,
            q_z, R_tip_z*q_y));
        out->sum[4][l] = STEWART_FMA(C_s, -STEWART_FMA(theta_dot, y_y, k_y*phi_dot), STEWART_FMA(-R_tip_z,
            q_x, R_tip_x*q_z));
        out->sum[5][l] = STEWART_FMA(C_s, -STEWART_FMA(theta_dot, y_z, k_z*phi_dot), STEWART_FMA(-R_tip_x,
            q_y, R_tip_y*q_x));
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* One leg of eight poses; ``bad`` is 1 if the function for one pose must compute the pose. */
static void bias_leg_of_block(
    const stewart_exact_model *model, int leg, const motion_in_lanes *at, const bias_pose *pose,
    bias_legs *STEWART_RESTRICT legs, bias_block *STEWART_RESTRICT out)
{
    int l;
    bias_leg_of_poses(model, leg, at, pose, legs);
    for (l = 0; l < LANES; ++l) {
        const stewart_real fault = STEWART_LARGER(legs->checked.bad[l], out->bad[l]);
        out->bad[l] = fault;
    }
}

/* Sums over platform and legs of eight poses. */
static void bias_of_block(const stewart_exact_model *model, const motion_in_lanes *at, bias_block *out)
{
    int i, l;
    bias_pose pose;
    bias_legs even;
    bias_legs odd;
    STEWART_ALIGNED stewart_real own[48];
    bias_of_pose(model, at, LANES, &pose, own);
    for (l = 0; l < LANES; ++l) {
        out->bad[l] = REAL(0);
    }
    for (i = 0; i < 3; ++i) {
        bias_leg_of_block(model, 2*i, at, &pose, &even, out);
        bias_leg_of_block(model, 2*i + 1, at, &pose, &odd, out);
        add_two(even.sum, odd.sum, 6, i, &out->number[0*LANES]);
    }
    for (i = 0; i < 48; ++i) {
        out->number[0*LANES + i] = own[i] + out->number[0*LANES + i];
    }
}

int stewart_exact_bias_and_friction_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions, stewart_real *out,
    int *status)
{
    size_t first;
    int l;
    motion_in_lanes at;
    bias_block block;
    STEWART_ALIGNED stewart_real row[48];
    stewart_motion one;
    if (model == NULL || motions == NULL || out == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    stewart_real found[6];
    int result = STEWART_OK;
    for (first = 0; first < count; first += (size_t)LANES) {
        load_motions(motions, first, count, &at);
        bias_of_block(model, &at, &block);
        stewart_real none[LANES];
        not_finite(block.number, 6, none);
        for (l = 0; l < LANES; ++l) {
            block.bad[l] = none[l] == REAL(0) ? block.bad[l] : REAL(1);
        }
        if (count - first >= LANES && any_of(block.bad) == 0) {
            in_rows(&block.number[8*0], 6, &out[6U*first]);
            if (status != NULL) {
                for (l = 0; l < LANES; ++l) {
                    status[first + (size_t)l] = STEWART_OK;
                }
            }
        } else {
            in_rows(block.number, 6, row);
            for (l = 0; l < LANES; ++l) {
                if (!(first + (size_t)l < count)) {
                    break;
                }
                const size_t pose = first + (size_t)l;
                int code = block.bad[l] > REAL(0) ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_OK;
                if (code == STEWART_OK) {
                    copy(out, pose, &row[l*6 + 0], 6U);
                } else {
                    load_pose(motions, pose, &one);
                    code = stewart_exact_bias_and_friction(model, &one, found);
                    if (code == STEWART_OK) {
                        copy(out, pose, found, 6U);
                    }
                }
                if (status != NULL) {
                    status[pose] = code;
                }
                result = result == STEWART_OK ? code : result;
            }
        }
    }
    return result;
}

/* Numbers of eight poses. */
typedef struct {
    stewart_real number[216];
    stewart_real bad[LANES]; /* 1 if the function for one pose must compute the pose, else 0 */
} STEWART_ALIGNED forward_block;

/* Computes one leg of eight poses in lanes. */
STEWART_APART static void forward_leg_of_poses(
    const stewart_exact_model *STEWART_RESTRICT model, int leg, const motion_in_lanes *STEWART_RESTRICT at,
    const forward_pose *STEWART_RESTRICT pose, forward_legs *STEWART_RESTRICT out)
{
    int l;
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = model->b[0][leg], b_y = model->b[1][leg], b_z = model->b[2][leg];
        const stewart_real p_x = model->p[0][leg], p_y = model->p[1][leg], p_z = model->p[2][leg];
        const stewart_real k_x = model->k[0][leg], k_y = model->k[1][leg], k_z = model->k[2][leg];
        const stewart_real C_p = model->C_p[leg];
        const stewart_real C_s = model->C_s[leg];
        const stewart_real h_x = model->h[0][leg], h_y = model->h[1][leg], h_z = model->h[2][leg];
        const stewart_real h2_x = model->h2_x[leg];
        const stewart_real h2_y = model->h2_y[leg];
        const stewart_real h2_z = model->h2_z[leg];
        const stewart_real w_x = model->w[0][leg], w_y = model->w[1][leg], w_z = model->w[2][leg];
        const stewart_real J_xx = model->J[0][leg], J_xy = model->J[1][leg], J_yy = model->J[3][leg], J_yz = model->J[4][leg];
        const stewart_real J2_xz = model->J2_xz[leg];
        const stewart_real dJ_zx = model->dJ_zx[leg];
        const stewart_real g_k = model->g_k[leg];
        const stewart_real g_x_k_x = model->g_x_k[0][leg], g_x_k_y = model->g_x_k[1][leg], g_x_k_z = model->g_x_k[2][leg];
        const stewart_real C_us = model->C_us[leg];
        const stewart_real R_xx = at->R[0][l], R_xy = at->R[1][l], R_xz = at->R[2][l], R_yx = at->R[3][l],
            R_yy = at->R[4][l], R_yz = at->R[5][l], R_zx = at->R[6][l], R_zy = at->R[7][l], R_zz = at->R[8][l];
        const stewart_real t_x = at->t[0][l], t_y = at->t[1][l], t_z = at->t[2][l];
        const stewart_real omega_x = at->omega[0][l], omega_y = at->omega[1][l], omega_z = at->omega[2][l];
        const stewart_real v_x = at->v[0][l], v_y = at->v[1][l], v_z = at->v[2][l];
        const stewart_real B_0_xx = pose->B_0[0][l], B_0_xy = pose->B_0[1][l], B_0_xz = pose->B_0[2][l],
            B_0_yx = pose->B_0[3][l], B_0_yy = pose->B_0[4][l], B_0_yz = pose->B_0[5][l], B_0_zx = pose->B_0[6][l],
            B_0_zy = pose->B_0[7][l], B_0_zz = pose->B_0[8][l];
        const stewart_real F = out->F[l];
        const stewart_real g_x = model->g[0], g_y = model->g[1], g_z = model->g[2];
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
        /* (10) distance of the tip from the fixed axis */
        const stewart_real rho = STEWART_SQRT(STEWART_FMA(k_cross_S_z, k_cross_S_z, STEWART_FMA(k_cross_S_y,
            k_cross_S_y, k_cross_S_x*k_cross_S_x)));
        const stewart_real inv_rho = REAL(1)/rho;
        /* relative component of the normal along s: rounding */
        const stewart_real n_along_s = inv_rho*STEWART_FMA(k_cross_S_z, s_z, STEWART_FMA(k_cross_S_y, s_y,
            k_cross_S_x*s_x));
        /* one over |s x normal| */
        const stewart_real inv_across = STEWART_FMA(STEWART_HALF*inv_rho*n_along_s, n_along_s, inv_rho);
        /* (10) along the third axis of the leg */
        const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_S_y, s_z, k_cross_S_z*s_y);
        const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_S_z, s_x, k_cross_S_x*s_z);
        const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_S_x, s_y, k_cross_S_y*s_x);
        /* (10) third axis of the leg frame */
        const stewart_real z_x = inv_across*s_cross_normal_x;
        const stewart_real z_y = inv_across*s_cross_normal_y;
        const stewart_real z_z = inv_across*s_cross_normal_z;
        /* (10) rotating axis of the universal joint */
        const stewart_real y_x = STEWART_FMA(-s_y, z_z, s_z*z_y);
        const stewart_real y_y = STEWART_FMA(-s_z, z_x, s_x*z_z);
        const stewart_real y_z = STEWART_FMA(-s_x, z_y, s_y*z_x);
        /* (10) k = (k1, 0, k3) in the leg frame */
        const stewart_real k1 = inv_L*zeta;
        const stewart_real k3 = inv_L*rho;
        /* (10) k1 / k3 */
        const stewart_real kappa = inv_rho*zeta;
        /* (4) omega x q */
        const stewart_real w_q_x = STEWART_FMA(-omega_z, q_y, omega_y*q_z);
        const stewart_real w_q_y = STEWART_FMA(-omega_x, q_z, omega_z*q_x);
        const stewart_real w_q_z = STEWART_FMA(-omega_y, q_x, omega_x*q_y);
        /* (4) velocity of the platform point */
        const stewart_real S_dot_x = v_x + w_q_x;
        const stewart_real S_dot_y = v_y + w_q_y;
        const stewart_real S_dot_z = v_z + w_q_z;
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
        /* (7) acceleration of the platform point, a = alpha = 0 */
        const stewart_real S_ddot_x = STEWART_FMA(B_0_xz, q_z, STEWART_FMA(B_0_xy, q_y, B_0_xx*q_x));
        const stewart_real S_ddot_y = STEWART_FMA(B_0_yz, q_z, STEWART_FMA(B_0_yy, q_y, B_0_yx*q_x));
        const stewart_real S_ddot_z = STEWART_FMA(B_0_zz, q_z, STEWART_FMA(B_0_zy, q_y, B_0_zx*q_x));
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
        const stewart_real M_phi_L = STEWART_FMA(h_z, -k13, h_x*k33);
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
            STEWART_FMA(C_s, -STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x)),
            STEWART_FMA(gamma_n, w_k, STEWART_FMA(bend, h2_x, STEWART_FMA(C_us, theta_dot,
            STEWART_FMA(phi_dot2, STEWART_FMA(-c3, STEWART_HALF - k33, k13*(J_yy - dJ_zx)), STEWART_FMA(g_k,
            w_n, L_ddot*h_z))))))));
        const stewart_real tau_k = STEWART_FMA(M_phi, own_phi_ddot, STEWART_FMA(M_mixed, theta_ddot,
            STEWART_FMA(bend*h2_y, -k1, STEWART_FMA(two_phi_dot, STEWART_FMA(-theta_dot, STEWART_FMA(J_xx,
            kappa, STEWART_FMA(STEWART_HALF, -c2, STEWART_HALF*J2_xz)), L_dot*M_phi_L),
            STEWART_FMA(-gamma_y, w_n, STEWART_FMA(-gamma_n, w_y, STEWART_FMA(C_us, phi_dot,
            STEWART_FMA(-L_ddot, k3_h, STEWART_FMA(C_s, -STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y,
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
            STEWART_FMA(-M_phi_L, phi_dot2, STEWART_FMA(h_x, -theta_dot2, C_p*L_dot))));
        const stewart_real c4 = F - D;
        /* force on the platform at the tip */
        const stewart_real push_x = STEWART_FMA(c4, s_x, -K_x);
        const stewart_real push_y = STEWART_FMA(c4, s_y, -K_y);
        const stewart_real push_z = STEWART_FMA(c4, s_z, -K_z);
        /* inertia at the tip, leg frame */
        const stewart_real m_leg_sy = -inv_rho*k3_h;
        const stewart_real m_leg_sz = -h_z*inv_L;
        const stewart_real m_leg_yy = M_phi*inv_rho*inv_rho;
        const stewart_real m_leg_yz = -M_mixed*inv_L*inv_rho;
        const stewart_real m_leg_zz = M_theta*inv_L*inv_L;
        const stewart_real m_T_xs = STEWART_FMA(m_leg_sy, y_x, m_leg_sz*z_x);
        const stewart_real m_T_xy = STEWART_FMA(m_leg_yz, z_x, STEWART_FMA(m_leg_yy, y_x, m_leg_sy*s_x));
        const stewart_real m_T_xz = STEWART_FMA(m_leg_yz, y_x, STEWART_FMA(m_leg_zz, z_x, m_leg_sz*s_x));
        const stewart_real m_T_ys = STEWART_FMA(m_leg_sy, y_y, m_leg_sz*z_y);
        const stewart_real m_T_yy = STEWART_FMA(m_leg_yz, z_y, STEWART_FMA(m_leg_yy, y_y, m_leg_sy*s_y));
        const stewart_real m_T_yz = STEWART_FMA(m_leg_yz, y_y, STEWART_FMA(m_leg_zz, z_y, m_leg_sz*s_y));
        const stewart_real m_T_zs = STEWART_FMA(m_leg_sy, y_z, m_leg_sz*z_z);
        const stewart_real m_T_zy = STEWART_FMA(m_leg_yz, z_z, STEWART_FMA(m_leg_yy, y_z, m_leg_sy*s_z));
        const stewart_real m_T_zz = STEWART_FMA(m_leg_yz, y_z, STEWART_FMA(m_leg_zz, z_z, m_leg_sz*s_z));
        /* inertia at the tip, base frame */
        const stewart_real m_xx = STEWART_FMA(m_T_xy, y_x, STEWART_FMA(m_T_xz, z_x, m_T_xs*s_x));
        const stewart_real m_xy = STEWART_FMA(m_T_xy, y_y, STEWART_FMA(m_T_xz, z_y, m_T_xs*s_y));
        const stewart_real m_xz = STEWART_FMA(m_T_xy, y_z, STEWART_FMA(m_T_xz, z_z, m_T_xs*s_z));
        const stewart_real m_yy = STEWART_FMA(m_T_yy, y_y, STEWART_FMA(m_T_yz, z_y, m_T_ys*s_y));
        const stewart_real m_yz = STEWART_FMA(m_T_yy, y_z, STEWART_FMA(m_T_yz, z_z, m_T_ys*s_z));
        const stewart_real m_zz = STEWART_FMA(m_T_zy, y_z, STEWART_FMA(m_T_zz, z_z, m_T_zs*s_z));
        const stewart_real c5 = m_xy*q_z;
        const stewart_real c6 = m_xz*q_y;
        const stewart_real c7 = -m_yz*q_x;
        /* m [q]x */
        const stewart_real m_q_xx = c5 - c6;
        const stewart_real m_q_xy = STEWART_FMA(-m_xx, q_z, m_xz*q_x);
        const stewart_real m_q_xz = STEWART_FMA(-m_xy, q_x, m_xx*q_y);
        const stewart_real m_q_yx = STEWART_FMA(-m_yz, q_y, m_yy*q_z);
        const stewart_real m_q_yy = -c5 - c7;
        const stewart_real m_q_yz = STEWART_FMA(-m_yy, q_x, m_xy*q_y);
        const stewart_real m_q_zx = STEWART_FMA(-m_zz, q_y, m_yz*q_z);
        const stewart_real m_q_zy = STEWART_FMA(-m_xz, q_z, m_zz*q_x);
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
        out->sum[15][l] = STEWART_FMA(-m_q_zx, q_y, m_q_yx*q_z);
        out->sum[16][l] = STEWART_FMA(-m_q_zy, q_y, m_q_yy*q_z);
        out->sum[17][l] = STEWART_FMA(-m_q_zz, q_y, m_q_yz*q_z);
        out->sum[18][l] = STEWART_FMA(-m_q_xy, q_z, m_q_zy*q_x);
        out->sum[19][l] = STEWART_FMA(-m_q_xz, q_z, m_q_zz*q_x);
        out->sum[20][l] = STEWART_FMA(-m_q_yz, q_x, m_q_xz*q_y);
        out->sum[21][l] = push_x;
        out->sum[22][l] = push_y;
        out->sum[23][l] = push_z;
        out->sum[24][l] = STEWART_FMA(C_s, STEWART_FMA(theta_dot, y_x, k_x*phi_dot), STEWART_FMA(-push_y,
            q_z, push_z*q_y));
        out->sum[25][l] = STEWART_FMA(C_s, STEWART_FMA(theta_dot, y_y, k_y*phi_dot), STEWART_FMA(-push_z,
            q_x, push_x*q_z));
        out->sum[26][l] = STEWART_FMA(C_s, STEWART_FMA(theta_dot, y_z, k_z*phi_dot), STEWART_FMA(-push_x,
            q_y, push_y*q_x));
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
        out->checked.reach[l] = reach;
        out->checked.L[l] = L;
        out->checked.k3[l] = k3;
        stewart_real fault = L > STEWART_ROUNDING*reach ? REAL(0) : REAL(1);
        fault = k3 > STEWART_JOINT_SINGULAR_SINE ? fault : REAL(1);
        out->checked.bad[l] = fault;
    }
}

/* One leg of eight poses; ``bad`` is 1 if the function for one pose must compute the pose. */
static void forward_leg_of_block(
    const stewart_exact_model *model, int leg, const motion_in_lanes *at,
    stewart_real (*STEWART_RESTRICT acting)[LANES], const forward_pose *pose,
    forward_legs *STEWART_RESTRICT legs, forward_block *STEWART_RESTRICT out)
{
    int l;
    for (l = 0; l < LANES; ++l) {
        legs->F[l] = acting[leg][l];
    }
    forward_leg_of_poses(model, leg, at, pose, legs);
    for (l = 0; l < LANES; ++l) {
        const stewart_real fault = STEWART_LARGER(legs->checked.bad[l], out->bad[l]);
        out->bad[l] = fault;
    }
}

/* Sums over platform and legs of eight poses. */
static void forward_of_block(
    const stewart_exact_model *model, const motion_in_lanes *at, stewart_real acting[6][LANES],
    forward_block *out)
{
    int i, l;
    forward_pose pose;
    forward_legs even;
    forward_legs odd;
    STEWART_ALIGNED stewart_real own[216];
    forward_of_pose(model, at, LANES, &pose, own);
    for (l = 0; l < LANES; ++l) {
        out->bad[l] = REAL(0);
    }
    for (i = 0; i < 3; ++i) {
        forward_leg_of_block(model, 2*i, at, acting, &pose, &even, out);
        forward_leg_of_block(model, 2*i + 1, at, acting, &pose, &odd, out);
        add_two(even.sum, odd.sum, 27, i, &out->number[0*LANES]);
    }
    for (i = 0; i < 216; ++i) {
        out->number[0*LANES + i] = own[i] + out->number[0*LANES + i];
    }
}

int stewart_exact_forward_dynamics_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions, const stewart_real *F,
    stewart_real *out, int *status)
{
    size_t first;
    int i, l;
    motion_in_lanes at;
    forward_block block;
    STEWART_ALIGNED stewart_real row[48];
    stewart_motion one;
    stewart_real acting[6][LANES];
    if (model == NULL || motions == NULL || out == NULL || F == NULL || motions->R == NULL || motions->t == NULL
        || motions->omega == NULL || motions->v == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    stewart_real found[6];
    int result = STEWART_OK;
    for (first = 0; first < count; first += (size_t)LANES) {
        load_motions(motions, first, count, &at);
        load_forces(F, first, count, acting);
        forward_of_block(model, &at, acting, &block);
        stewart_real pivot[48];
        stewart_real solution[48];
        solve_inertia(block.number, LANES, solution, pivot);
        for (l = 0; l < LANES; ++l) {
            block.bad[l] = pivot[LANES*0 + l] > STEWART_KEPT*block.number[0 + l] ? block.bad[l] : REAL(1);
            block.bad[l] = pivot[LANES*1 + l] > STEWART_KEPT*block.number[24 + l] ? block.bad[l] : REAL(1);
            block.bad[l] = pivot[LANES*2 + l] > STEWART_KEPT*block.number[40 + l] ? block.bad[l] : REAL(1);
            block.bad[l] = pivot[LANES*3 + l] > STEWART_KEPT*block.number[120 + l] ? block.bad[l] : REAL(1);
            block.bad[l] = pivot[LANES*4 + l] > STEWART_KEPT*block.number[144 + l] ? block.bad[l] : REAL(1);
            block.bad[l] = pivot[LANES*5 + l] > STEWART_KEPT*block.number[160 + l] ? block.bad[l] : REAL(1);
        }
        for (i = 0; i < 48; ++i) {
            block.number[i] = solution[i];
        }
        stewart_real none[LANES];
        not_finite(block.number, 6, none);
        for (l = 0; l < LANES; ++l) {
            block.bad[l] = none[l] == REAL(0) ? block.bad[l] : REAL(1);
        }
        if (count - first >= LANES && any_of(block.bad) == 0) {
            in_rows(&block.number[8*0], 6, &out[6U*first]);
            if (status != NULL) {
                for (l = 0; l < LANES; ++l) {
                    status[first + (size_t)l] = STEWART_OK;
                }
            }
        } else {
            in_rows(block.number, 6, row);
            for (l = 0; l < LANES; ++l) {
                if (!(first + (size_t)l < count)) {
                    break;
                }
                const size_t pose = first + (size_t)l;
                int code = block.bad[l] > REAL(0) ? STEWART_MASS_MATRIX_INDEFINITE : STEWART_OK;
                if (code == STEWART_OK) {
                    copy(out, pose, &row[l*6 + 0], 6U);
                } else {
                    load_pose(motions, pose, &one);
                    code = stewart_exact_forward_dynamics(model, &one, &F[pose*6U], found);
                    if (code == STEWART_OK) {
                        copy(out, pose, found, 6U);
                    }
                }
                if (status != NULL) {
                    status[pose] = code;
                }
                result = result == STEWART_OK ? code : result;
            }
        }
    }
    return result;
}

int stewart_exact_joint_inertia_batch(
    const stewart_exact_model *model, size_t count, const stewart_motions *motions, stewart_real *out,
    int *status)
{
    size_t pose;
    stewart_motion one;
    stewart_real found[36];
    if (model == NULL || motions == NULL || out == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    int result = STEWART_OK;
    for (pose = 0; pose < count; ++pose) {
        load_pose(motions, pose, &one);
        const int code = stewart_exact_joint_inertia(model, &one, found);
        if (code == STEWART_OK) {
            copy(out, pose, found, 36U);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}
