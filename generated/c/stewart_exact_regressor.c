/* stewart_exact_regressor.c: functions that are declared and described in stewart_exact_regressor.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_exact_regressor.h"

#include "stewart_solve.h"

/* Quantities that determine the status of a leg; bad: 1 if it cannot be computed, else 0. */
typedef struct {
    stewart_real L[LANES];
    stewart_real reach[LANES];
    stewart_real k3[LANES];
    stewart_real bad[LANES];
} leg_checks;

/* Columns of a pose with the row as first index, and inputs of the legs. lost: 1 if not finite. */
typedef struct {
    stewart_real of_legs[6][23][LANES];
    stewart_real b[3][LANES];
    stewart_real p[3][LANES];
    stewart_real k[3][LANES];
    stewart_real lost[LANES];
    leg_checks checked;
    stewart_real of_platform[6][10];
} STEWART_ALIGNED regressor_columns;

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

/* Computes the columns of the legs in lanes, 618 operations each. Marks a leg whose status is not OK or
 * whose moments are not finite; moments are computed from forces, so forces need no check. */
STEWART_APART static void columns_of_legs(
    const stewart_robot *STEWART_RESTRICT robot, const stewart_motion *STEWART_RESTRICT at,
    regressor_columns *STEWART_RESTRICT out)
{
    int i, l;
    for (i = 0; i < LANES; ++i) {
        out->b[0][i] = robot->leg[i < 6 ? i : 5].b[0];
        out->b[1][i] = robot->leg[i < 6 ? i : 5].b[1];
        out->b[2][i] = robot->leg[i < 6 ? i : 5].b[2];
        out->p[0][i] = robot->leg[i < 6 ? i : 5].p[0];
        out->p[1][i] = robot->leg[i < 6 ? i : 5].p[1];
        out->p[2][i] = robot->leg[i < 6 ? i : 5].p[2];
        out->k[0][i] = robot->leg[i < 6 ? i : 5].k[0];
        out->k[1][i] = robot->leg[i < 6 ? i : 5].k[1];
        out->k[2][i] = robot->leg[i < 6 ? i : 5].k[2];
    }
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    for (l = 0; l < LANES; ++l) {
        const stewart_real b_x = out->b[0][l], b_y = out->b[1][l], b_z = out->b[2][l];
        const stewart_real p_x = out->p[0][l], p_y = out->p[1][l], p_z = out->p[2][l];
        const stewart_real k_x = out->k[0][l], k_y = out->k[1][l], k_z = out->k[2][l];
        /* (1) platform point from the reference point */
        const stewart_real q_x = STEWART_FMA(R_xz, p_z, STEWART_FMA(R_xy, p_y, R_xx*p_x));
        const stewart_real q_y = STEWART_FMA(R_yz, p_z, STEWART_FMA(R_yy, p_y, R_yx*p_x));
        const stewart_real q_z = STEWART_FMA(R_zz, p_z, STEWART_FMA(R_zy, p_y, R_zx*p_x));
        /* (1) leg vector */
        const stewart_real S_x = t_x - b_x + q_x;
        const stewart_real S_y = t_y - b_y + q_y;
        const stewart_real S_z = t_z - b_z + q_z;
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
        /* (7) acceleration of the platform point */
        const stewart_real S_ddot_x = STEWART_FMA(omega_z, -w_q_y, STEWART_FMA(omega_y, w_q_z,
            STEWART_FMA(alpha_z, -q_y, STEWART_FMA(alpha_y, q_z, a_x))));
        const stewart_real S_ddot_y = STEWART_FMA(omega_x, -w_q_z, STEWART_FMA(omega_z, w_q_x,
            STEWART_FMA(alpha_x, -q_z, STEWART_FMA(alpha_z, q_x, a_y))));
        const stewart_real S_ddot_z = STEWART_FMA(omega_y, -w_q_x, STEWART_FMA(omega_x, w_q_y,
            STEWART_FMA(alpha_y, -q_x, STEWART_FMA(alpha_x, q_y, a_z))));
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
        const stewart_real c1 = theta_dot*theta_dot;
        const stewart_real theta_dot2 = c1;
        const stewart_real c2 = phi_dot*phi_dot;
        const stewart_real phi_dot2 = c2;
        const stewart_real c3 = REAL(2)*phi_dot;
        const stewart_real two_phi_dot = c3;
        const stewart_real c4 = k3*k3;
        const stewart_real k33 = c4;
        /* (8) accelerations of the joint coordinates */
        const stewart_real L_ddot = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y,
            STEWART_FMA(S_ddot_x, s_x, L*STEWART_FMA(k33, phi_dot2, theta_dot2))));
        const stewart_real c5 = REAL(2)*theta_dot;
        /* (9) accelerations of the joint coordinates without the rotation of the leg frame about s */
        const stewart_real own_theta_ddot = STEWART_FMA(-L_share, c5, -inv_L*STEWART_FMA(S_ddot_z, z_z,
            STEWART_FMA(S_ddot_y, z_y, S_ddot_x*z_x)));
        const stewart_real own_phi_ddot = STEWART_FMA(-L_share, two_phi_dot, inv_rho*STEWART_FMA(S_ddot_z,
            y_z, STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x)));
        const stewart_real c6 = k1*k3;
        /* (9) accelerations of the joint coordinates */
        const stewart_real theta_ddot = STEWART_FMA(c6, phi_dot2, own_theta_ddot);
        const stewart_real phi_ddot = STEWART_FMA(-lean, two_phi_dot, own_phi_ddot);
        /* component of g along the fixed axis k */
        const stewart_real g_k = STEWART_FMA(g_z, k_z, STEWART_FMA(g_y, k_y, g_x*k_x));
        /* g x k, base frame */
        const stewart_real g_x_k_x = STEWART_FMA(g_z, -k_y, g_y*k_z);
        const stewart_real g_x_k_y = STEWART_FMA(g_x, -k_z, g_z*k_x);
        const stewart_real g_x_k_z = STEWART_FMA(g_y, -k_x, g_x*k_y);
        /* components of gravity along k x y and along y */
        const stewart_real gamma_n = STEWART_FMA(g_x_k_z, y_z, STEWART_FMA(g_x_k_y, y_y, g_x_k_x*y_x));
        const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
        /* omega along k x y, y and k */
        const stewart_real w_y_omega = STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x));
        const stewart_real w_k_omega = STEWART_FMA(k_z, omega_z, STEWART_FMA(k_y, omega_y, k_x*omega_x));
        const stewart_real c7 = STEWART_FMA(gamma_n, k1, g_k*k3);
        const stewart_real c8 = -gamma_y*k3;
        /* (20) torques by h_d_x */
        const stewart_real tau_theta_h_d_x = c7;
        const stewart_real tau_phi_h_d_x = c8;
        const stewart_real c9 = g_k*k1;
        /* (20) torques by h_d_z */
        const stewart_real tau_theta_h_d_z = STEWART_FMA(gamma_n, k3, -c9);
        const stewart_real tau_phi_h_d_z = gamma_y*k1;
        const stewart_real c10 = c2*c4;
        const stewart_real c11 = REAL(2)*L;
        const stewart_real c12 = L_dot*c5;
        const stewart_real c13 = c4*own_phi_ddot;
        const stewart_real c14 = c3*c4;
        /* (20) torques by h_u_x */
        const stewart_real tau_L_h_u_x = -c1 - c10;
        const stewart_real tau_theta_h_u_x = STEWART_FMA(c11, own_theta_ddot, c12 + c7);
        const stewart_real tau_phi_h_u_x = STEWART_FMA(c11, c13, STEWART_FMA(L_dot, c14, c8));
        const stewart_real c15 = k3*phi_ddot;
        const stewart_real c16 = k1*phi_ddot;
        const stewart_real c17 = k1*theta_ddot;
        /* (20) torques by h_u_y */
        const stewart_real tau_L_h_u_y = -c15;
        const stewart_real tau_theta_h_u_y = -L*c16;
        const stewart_real tau_phi_h_u_y = STEWART_FMA(-L, c17, STEWART_FMA(-c12, k1, STEWART_FMA(-L_ddot,
            k3, L*c1*k3) - gamma_n));
        const stewart_real c18 = c2*c6;
        const stewart_real c19 = k1*k1;
        const stewart_real c20 = c19*c2;
        const stewart_real c21 = c15*k1;
        const stewart_real c22 = c3*theta_dot;
        const stewart_real c23 = c19*c22;
        /* (20) torques by h_u_z */
        const stewart_real tau_L_h_u_z = c18 + theta_ddot;
        const stewart_real tau_theta_h_u_z = STEWART_FMA(gamma_n, k3, STEWART_FMA(-L, c10, L*c20) - c9 + L_ddot);
        const stewart_real tau_phi_h_u_z = STEWART_FMA(-c11, c21, STEWART_FMA(-L, c23, STEWART_FMA(L_dot*c3,
            -c6, STEWART_FMA(REAL(2)*L*c4*phi_dot, theta_dot, gamma_y*k1))));
        /* (20) torques by J_u_xx */
        const stewart_real tau_theta_J_u_xx = c18;
        const stewart_real tau_phi_J_u_xx = STEWART_FMA(-c4, phi_ddot, STEWART_FMA(-c22, c6, phi_ddot));
        /* (20) torques by J_u_xy */
        const stewart_real tau_theta_J_u_xy = c16;
        const stewart_real tau_phi_J_u_xy = STEWART_FMA(-c1, k3, c17);
        /* (20) torques by J_u_xz */
        const stewart_real tau_theta_J_u_xz = c10 - c20;
        const stewart_real tau_phi_J_u_xz = STEWART_FMA(REAL(2), c21, STEWART_FMA(-c14, theta_dot, c23));
        /* (20) torques by J_u_yz */
        const stewart_real tau_theta_J_u_yz = c15;
        const stewart_real tau_phi_J_u_yz = STEWART_FMA(k3, theta_ddot, c1*k1);
        /* (20) torques by J_u_zz */
        const stewart_real tau_theta_J_u_zz = -c18;
        const stewart_real tau_phi_J_u_zz = c13;
        /* (20) torques by C_s */
        const stewart_real tau_theta_C_s = theta_dot - w_y_omega;
        const stewart_real tau_phi_C_s = phi_dot - w_k_omega;
        /* (6) angular velocity of the leg */
        const stewart_real W_x = STEWART_FMA(k_x, phi_dot, theta_dot*y_x);
        const stewart_real W_y = STEWART_FMA(k_y, phi_dot, theta_dot*y_y);
        const stewart_real W_z = STEWART_FMA(k_z, phi_dot, theta_dot*y_z);
        const stewart_real c24 = inv_L*tau_theta_h_d_x;
        /* force at the tip by h_d_x */
        const stewart_real R_h_d_x_x = STEWART_FMA(-c24, z_x, inv_rho*tau_phi_h_d_x*y_x);
        const stewart_real R_h_d_x_y = STEWART_FMA(-c24, z_y, inv_rho*tau_phi_h_d_x*y_y);
        const stewart_real R_h_d_x_z = STEWART_FMA(-c24, z_z, inv_rho*tau_phi_h_d_x*y_z);
        const stewart_real c25 = gamma_n*inv_rho;
        /* force at the tip by h_d_y */
        const stewart_real R_h_d_y_x = -c25*y_x;
        const stewart_real R_h_d_y_y = -c25*y_y;
        const stewart_real R_h_d_y_z = -c25*y_z;
        const stewart_real c26 = inv_L*tau_theta_h_d_z;
        /* force at the tip by h_d_z */
        const stewart_real R_h_d_z_x = STEWART_FMA(-c26, z_x, inv_rho*tau_phi_h_d_z*y_x);
        const stewart_real R_h_d_z_y = STEWART_FMA(-c26, z_y, inv_rho*tau_phi_h_d_z*y_y);
        const stewart_real R_h_d_z_z = STEWART_FMA(-c26, z_z, inv_rho*tau_phi_h_d_z*y_z);
        const stewart_real c27 = inv_rho*tau_phi_h_u_x;
        const stewart_real c28 = inv_L*tau_theta_h_u_x;
        /* force at the tip by h_u_x */
        const stewart_real R_h_u_x_x = STEWART_FMA(c27, y_x, STEWART_FMA(-c28, z_x, s_x*tau_L_h_u_x));
        const stewart_real R_h_u_x_y = STEWART_FMA(c27, y_y, STEWART_FMA(-c28, z_y, s_y*tau_L_h_u_x));
        const stewart_real R_h_u_x_z = STEWART_FMA(c27, y_z, STEWART_FMA(-c28, z_z, s_z*tau_L_h_u_x));
        const stewart_real c29 = inv_rho*tau_phi_h_u_y;
        const stewart_real c30 = inv_L*tau_theta_h_u_y;
        /* force at the tip by h_u_y */
        const stewart_real R_h_u_y_x = STEWART_FMA(-c30, z_x, STEWART_FMA(c29, y_x, s_x*tau_L_h_u_y));
        const stewart_real R_h_u_y_y = STEWART_FMA(-c30, z_y, STEWART_FMA(c29, y_y, s_y*tau_L_h_u_y));
        const stewart_real R_h_u_y_z = STEWART_FMA(-c30, z_z, STEWART_FMA(c29, y_z, s_z*tau_L_h_u_y));
        const stewart_real c31 = inv_rho*tau_phi_h_u_z;
        const stewart_real c32 = inv_L*tau_theta_h_u_z;
        /* force at the tip by h_u_z */
        const stewart_real R_h_u_z_x = STEWART_FMA(c31, y_x, STEWART_FMA(-c32, z_x, s_x*tau_L_h_u_z));
        const stewart_real R_h_u_z_y = STEWART_FMA(c31, y_y, STEWART_FMA(-c32, z_y, s_y*tau_L_h_u_z));
        const stewart_real R_h_u_z_z = STEWART_FMA(c31, y_z, STEWART_FMA(-c32, z_z, s_z*tau_L_h_u_z));
        const stewart_real c33 = inv_L*tau_theta_J_u_xx;
        /* force at the tip by J_u_xx */
        const stewart_real R_J_u_xx_x = STEWART_FMA(-c33, z_x, inv_rho*tau_phi_J_u_xx*y_x);
        const stewart_real R_J_u_xx_y = STEWART_FMA(-c33, z_y, inv_rho*tau_phi_J_u_xx*y_y);
        const stewart_real R_J_u_xx_z = STEWART_FMA(-c33, z_z, inv_rho*tau_phi_J_u_xx*y_z);
        const stewart_real c34 = inv_L*tau_theta_J_u_xy;
        /* force at the tip by J_u_xy */
        const stewart_real R_J_u_xy_x = STEWART_FMA(-c34, z_x, inv_rho*tau_phi_J_u_xy*y_x);
        const stewart_real R_J_u_xy_y = STEWART_FMA(-c34, z_y, inv_rho*tau_phi_J_u_xy*y_y);
        const stewart_real R_J_u_xy_z = STEWART_FMA(-c34, z_z, inv_rho*tau_phi_J_u_xy*y_z);
        const stewart_real c35 = inv_L*tau_theta_J_u_xz;
        /* force at the tip by J_u_xz */
        const stewart_real R_J_u_xz_x = STEWART_FMA(-c35, z_x, inv_rho*tau_phi_J_u_xz*y_x);
        const stewart_real R_J_u_xz_y = STEWART_FMA(-c35, z_y, inv_rho*tau_phi_J_u_xz*y_y);
        const stewart_real R_J_u_xz_z = STEWART_FMA(-c35, z_z, inv_rho*tau_phi_J_u_xz*y_z);
        const stewart_real c36 = inv_L*theta_ddot;
        /* force at the tip by J_u_yy */
        const stewart_real R_J_u_yy_x = -c36*z_x;
        const stewart_real R_J_u_yy_y = -c36*z_y;
        const stewart_real R_J_u_yy_z = -c36*z_z;
        const stewart_real c37 = inv_L*tau_theta_J_u_yz;
        /* force at the tip by J_u_yz */
        const stewart_real R_J_u_yz_x = STEWART_FMA(-c37, z_x, inv_rho*tau_phi_J_u_yz*y_x);
        const stewart_real R_J_u_yz_y = STEWART_FMA(-c37, z_y, inv_rho*tau_phi_J_u_yz*y_y);
        const stewart_real R_J_u_yz_z = STEWART_FMA(-c37, z_z, inv_rho*tau_phi_J_u_yz*y_z);
        const stewart_real c38 = inv_L*tau_theta_J_u_zz;
        /* force at the tip by J_u_zz */
        const stewart_real R_J_u_zz_x = STEWART_FMA(-c38, z_x, inv_rho*tau_phi_J_u_zz*y_x);
        const stewart_real R_J_u_zz_y = STEWART_FMA(-c38, z_y, inv_rho*tau_phi_J_u_zz*y_y);
        const stewart_real R_J_u_zz_z = STEWART_FMA(-c38, z_z, inv_rho*tau_phi_J_u_zz*y_z);
        const stewart_real c39 = inv_L*theta_dot;
        /* force at the tip by C_u */
        const stewart_real R_C_u_x = STEWART_FMA(-c39, z_x, inv_rho*phi_dot*y_x);
        const stewart_real R_C_u_y = STEWART_FMA(-c39, z_y, inv_rho*phi_dot*y_y);
        const stewart_real R_C_u_z = STEWART_FMA(-c39, z_z, inv_rho*phi_dot*y_z);
        /* force at the tip by C_p */
        const stewart_real R_C_p_x = L_dot*s_x;
        const stewart_real R_C_p_y = L_dot*s_y;
        const stewart_real R_C_p_z = L_dot*s_z;
        const stewart_real c40 = inv_L*tau_theta_C_s;
        /* force at the tip by C_s */
        const stewart_real R_C_s_x = STEWART_FMA(-c40, z_x, inv_rho*tau_phi_C_s*y_x);
        const stewart_real R_C_s_y = STEWART_FMA(-c40, z_y, inv_rho*tau_phi_C_s*y_y);
        const stewart_real R_C_s_z = STEWART_FMA(-c40, z_z, inv_rho*tau_phi_C_s*y_z);
        /* (18) S_ddot - g */
        const stewart_real rise_x = S_ddot_x - g_x;
        const stewart_real rise_y = S_ddot_y - g_y;
        const stewart_real rise_z = S_ddot_z - g_z;
        const stewart_real c41 = STEWART_FMA(-R_J_u_xx_y, q_z, R_J_u_xx_z*q_y);
        const stewart_real c42 = STEWART_FMA(-R_J_u_xx_z, q_x, R_J_u_xx_x*q_z);
        const stewart_real c43 = STEWART_FMA(-R_J_u_xx_x, q_y, R_J_u_xx_y*q_x);
        const stewart_real c44 = STEWART_FMA(-R_J_u_xy_y, q_z, R_J_u_xy_z*q_y);
        const stewart_real c45 = STEWART_FMA(-R_J_u_xy_z, q_x, R_J_u_xy_x*q_z);
        const stewart_real c46 = STEWART_FMA(-R_J_u_xy_x, q_y, R_J_u_xy_y*q_x);
        const stewart_real c47 = STEWART_FMA(-R_J_u_xz_y, q_z, R_J_u_xz_z*q_y);
        const stewart_real c48 = STEWART_FMA(-R_J_u_xz_z, q_x, R_J_u_xz_x*q_z);
        const stewart_real c49 = STEWART_FMA(-R_J_u_xz_x, q_y, R_J_u_xz_y*q_x);
        const stewart_real c50 = STEWART_FMA(-R_J_u_yy_y, q_z, R_J_u_yy_z*q_y);
        const stewart_real c51 = STEWART_FMA(-R_J_u_yy_z, q_x, R_J_u_yy_x*q_z);
        const stewart_real c52 = STEWART_FMA(-R_J_u_yy_x, q_y, R_J_u_yy_y*q_x);
        const stewart_real c53 = STEWART_FMA(-R_J_u_yz_y, q_z, R_J_u_yz_z*q_y);
        const stewart_real c54 = STEWART_FMA(-R_J_u_yz_z, q_x, R_J_u_yz_x*q_z);
        const stewart_real c55 = STEWART_FMA(-R_J_u_yz_x, q_y, R_J_u_yz_y*q_x);
        const stewart_real c56 = STEWART_FMA(-R_J_u_zz_y, q_z, R_J_u_zz_z*q_y);
        const stewart_real c57 = STEWART_FMA(-R_J_u_zz_z, q_x, R_J_u_zz_x*q_z);
        const stewart_real c58 = STEWART_FMA(-R_J_u_zz_x, q_y, R_J_u_zz_y*q_x);
        out->of_legs[0][0][l] = REAL(0);
        out->of_legs[1][0][l] = REAL(0);
        out->of_legs[2][0][l] = REAL(0);
        out->of_legs[3][0][l] = REAL(0);
        out->of_legs[4][0][l] = REAL(0);
        out->of_legs[5][0][l] = REAL(0);
        out->of_legs[0][1][l] = R_h_d_x_x;
        out->of_legs[1][1][l] = R_h_d_x_y;
        out->of_legs[2][1][l] = R_h_d_x_z;
        out->of_legs[3][1][l] = STEWART_FMA(-R_h_d_x_y, q_z, R_h_d_x_z*q_y);
        out->of_legs[4][1][l] = STEWART_FMA(-R_h_d_x_z, q_x, R_h_d_x_x*q_z);
        out->of_legs[5][1][l] = STEWART_FMA(-R_h_d_x_x, q_y, R_h_d_x_y*q_x);
        out->of_legs[0][2][l] = R_h_d_y_x;
        out->of_legs[1][2][l] = R_h_d_y_y;
        out->of_legs[2][2][l] = R_h_d_y_z;
        out->of_legs[3][2][l] = STEWART_FMA(-R_h_d_y_y, q_z, R_h_d_y_z*q_y);
        out->of_legs[4][2][l] = STEWART_FMA(-R_h_d_y_z, q_x, R_h_d_y_x*q_z);
        out->of_legs[5][2][l] = STEWART_FMA(-R_h_d_y_x, q_y, R_h_d_y_y*q_x);
        out->of_legs[0][3][l] = R_h_d_z_x;
        out->of_legs[1][3][l] = R_h_d_z_y;
        out->of_legs[2][3][l] = R_h_d_z_z;
        out->of_legs[3][3][l] = STEWART_FMA(-R_h_d_z_y, q_z, R_h_d_z_z*q_y);
        out->of_legs[4][3][l] = STEWART_FMA(-R_h_d_z_z, q_x, R_h_d_z_x*q_z);
        out->of_legs[5][3][l] = STEWART_FMA(-R_h_d_z_x, q_y, R_h_d_z_y*q_x);
        out->of_legs[0][4][l] = R_J_u_xx_x;
        out->of_legs[1][4][l] = R_J_u_xx_y;
        out->of_legs[2][4][l] = R_J_u_xx_z;
        out->of_legs[3][4][l] = c41;
        out->of_legs[4][4][l] = c42;
        out->of_legs[5][4][l] = c43;
        out->of_legs[0][5][l] = R_J_u_xy_x;
        out->of_legs[1][5][l] = R_J_u_xy_y;
        out->of_legs[2][5][l] = R_J_u_xy_z;
        out->of_legs[3][5][l] = c44;
        out->of_legs[4][5][l] = c45;
        out->of_legs[5][5][l] = c46;
        out->of_legs[0][6][l] = R_J_u_xz_x;
        out->of_legs[1][6][l] = R_J_u_xz_y;
        out->of_legs[2][6][l] = R_J_u_xz_z;
        out->of_legs[3][6][l] = c47;
        out->of_legs[4][6][l] = c48;
        out->of_legs[5][6][l] = c49;
        out->of_legs[0][7][l] = R_J_u_yy_x;
        out->of_legs[1][7][l] = R_J_u_yy_y;
        out->of_legs[2][7][l] = R_J_u_yy_z;
        out->of_legs[3][7][l] = c50;
        out->of_legs[4][7][l] = c51;
        out->of_legs[5][7][l] = c52;
        out->of_legs[0][8][l] = R_J_u_yz_x;
        out->of_legs[1][8][l] = R_J_u_yz_y;
        out->of_legs[2][8][l] = R_J_u_yz_z;
        out->of_legs[3][8][l] = c53;
        out->of_legs[4][8][l] = c54;
        out->of_legs[5][8][l] = c55;
        out->of_legs[0][9][l] = R_J_u_zz_x;
        out->of_legs[1][9][l] = R_J_u_zz_y;
        out->of_legs[2][9][l] = R_J_u_zz_z;
        out->of_legs[3][9][l] = c56;
        out->of_legs[4][9][l] = c57;
        out->of_legs[5][9][l] = c58;
        out->of_legs[0][10][l] = rise_x;
        out->of_legs[1][10][l] = rise_y;
        out->of_legs[2][10][l] = rise_z;
        out->of_legs[3][10][l] = STEWART_FMA(-q_z, rise_y, q_y*rise_z);
        out->of_legs[4][10][l] = STEWART_FMA(-q_x, rise_z, q_z*rise_x);
        out->of_legs[5][10][l] = STEWART_FMA(-q_y, rise_x, q_x*rise_y);
        out->of_legs[0][11][l] = R_h_u_x_x;
        out->of_legs[1][11][l] = R_h_u_x_y;
        out->of_legs[2][11][l] = R_h_u_x_z;
        out->of_legs[3][11][l] = STEWART_FMA(-R_h_u_x_y, q_z, R_h_u_x_z*q_y);
        out->of_legs[4][11][l] = STEWART_FMA(-R_h_u_x_z, q_x, R_h_u_x_x*q_z);
        out->of_legs[5][11][l] = STEWART_FMA(-R_h_u_x_x, q_y, R_h_u_x_y*q_x);
        out->of_legs[0][12][l] = R_h_u_y_x;
        out->of_legs[1][12][l] = R_h_u_y_y;
        out->of_legs[2][12][l] = R_h_u_y_z;
        out->of_legs[3][12][l] = STEWART_FMA(-R_h_u_y_y, q_z, R_h_u_y_z*q_y);
        out->of_legs[4][12][l] = STEWART_FMA(-R_h_u_y_z, q_x, R_h_u_y_x*q_z);
        out->of_legs[5][12][l] = STEWART_FMA(-R_h_u_y_x, q_y, R_h_u_y_y*q_x);
        out->of_legs[0][13][l] = R_h_u_z_x;
        out->of_legs[1][13][l] = R_h_u_z_y;
        out->of_legs[2][13][l] = R_h_u_z_z;
        out->of_legs[3][13][l] = STEWART_FMA(-R_h_u_z_y, q_z, R_h_u_z_z*q_y);
        out->of_legs[4][13][l] = STEWART_FMA(-R_h_u_z_z, q_x, R_h_u_z_x*q_z);
        out->of_legs[5][13][l] = STEWART_FMA(-R_h_u_z_x, q_y, R_h_u_z_y*q_x);
        out->of_legs[0][14][l] = R_J_u_xx_x;
        out->of_legs[1][14][l] = R_J_u_xx_y;
        out->of_legs[2][14][l] = R_J_u_xx_z;
        out->of_legs[3][14][l] = c41;
        out->of_legs[4][14][l] = c42;
        out->of_legs[5][14][l] = c43;
        out->of_legs[0][15][l] = R_J_u_xy_x;
        out->of_legs[1][15][l] = R_J_u_xy_y;
        out->of_legs[2][15][l] = R_J_u_xy_z;
        out->of_legs[3][15][l] = c44;
        out->of_legs[4][15][l] = c45;
        out->of_legs[5][15][l] = c46;
        out->of_legs[0][16][l] = R_J_u_xz_x;
        out->of_legs[1][16][l] = R_J_u_xz_y;
        out->of_legs[2][16][l] = R_J_u_xz_z;
        out->of_legs[3][16][l] = c47;
        out->of_legs[4][16][l] = c48;
        out->of_legs[5][16][l] = c49;
        out->of_legs[0][17][l] = R_J_u_yy_x;
        out->of_legs[1][17][l] = R_J_u_yy_y;
        out->of_legs[2][17][l] = R_J_u_yy_z;
        out->of_legs[3][17][l] = c50;
        out->of_legs[4][17][l] = c51;
        out->of_legs[5][17][l] = c52;
        out->of_legs[0][18][l] = R_J_u_yz_x;
        out->of_legs[1][18][l] = R_J_u_yz_y;
        out->of_legs[2][18][l] = R_J_u_yz_z;
        out->of_legs[3][18][l] = c53;
        out->of_legs[4][18][l] = c54;
        out->of_legs[5][18][l] = c55;
        out->of_legs[0][19][l] = R_J_u_zz_x;
        out->of_legs[1][19][l] = R_J_u_zz_y;
        out->of_legs[2][19][l] = R_J_u_zz_z;
        out->of_legs[3][19][l] = c56;
        out->of_legs[4][19][l] = c57;
        out->of_legs[5][19][l] = c58;
        out->of_legs[0][20][l] = R_C_u_x;
        out->of_legs[1][20][l] = R_C_u_y;
        out->of_legs[2][20][l] = R_C_u_z;
        out->of_legs[3][20][l] = STEWART_FMA(-R_C_u_y, q_z, R_C_u_z*q_y);
        out->of_legs[4][20][l] = STEWART_FMA(-R_C_u_z, q_x, R_C_u_x*q_z);
        out->of_legs[5][20][l] = STEWART_FMA(-R_C_u_x, q_y, R_C_u_y*q_x);
        out->of_legs[0][21][l] = R_C_p_x;
        out->of_legs[1][21][l] = R_C_p_y;
        out->of_legs[2][21][l] = R_C_p_z;
        out->of_legs[3][21][l] = STEWART_FMA(-R_C_p_y, q_z, R_C_p_z*q_y);
        out->of_legs[4][21][l] = STEWART_FMA(-R_C_p_z, q_x, R_C_p_x*q_z);
        out->of_legs[5][21][l] = STEWART_FMA(-R_C_p_x, q_y, R_C_p_y*q_x);
        out->of_legs[0][22][l] = R_C_s_x;
        out->of_legs[1][22][l] = R_C_s_y;
        out->of_legs[2][22][l] = R_C_s_z;
        out->of_legs[3][22][l] = STEWART_FMA(-R_C_s_y, q_z, STEWART_FMA(R_C_s_z, q_y, omega_x) - W_x);
        out->of_legs[4][22][l] = STEWART_FMA(-R_C_s_z, q_x, STEWART_FMA(R_C_s_x, q_z, omega_y) - W_y);
        out->of_legs[5][22][l] = STEWART_FMA(-R_C_s_x, q_y, STEWART_FMA(R_C_s_y, q_x, omega_z) - W_z);
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
        fault = STEWART_FABS(out->of_legs[3][1][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][1][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][1][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][2][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][2][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][2][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][3][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][3][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][3][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][14][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][14][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][14][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][15][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][15][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][15][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][16][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][16][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][16][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][17][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][17][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][17][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][18][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][18][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][18][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][19][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][19][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][19][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][10][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][10][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][10][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][11][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][11][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][11][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][12][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][12][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][12][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][13][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][13][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][13][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][20][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][20][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][20][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][21][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][21][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][21][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[3][22][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[4][22][l]) <= STEWART_MAX ? fault : REAL(1);
        fault = STEWART_FABS(out->of_legs[5][22][l]) <= STEWART_MAX ? fault : REAL(1);
        out->lost[l] = fault;
    }
}

/* Computes the columns of the platform: 255 operations. */
STEWART_APART static void columns_of_platform(
    const stewart_robot *STEWART_RESTRICT robot, const stewart_motion *STEWART_RESTRICT at,
    regressor_columns *STEWART_RESTRICT out)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    /* (33) a - g */
    const stewart_real rise_x = a_x - g_x;
    const stewart_real rise_y = a_y - g_y;
    const stewart_real rise_z = a_z - g_z;
    /* angular velocity, platform frame */
    const stewart_real omega_P_x = STEWART_FMA(R_zx, omega_z, STEWART_FMA(R_yx, omega_y, R_xx*omega_x));
    const stewart_real omega_P_y = STEWART_FMA(R_zy, omega_z, STEWART_FMA(R_yy, omega_y, R_xy*omega_x));
    const stewart_real omega_P_z = STEWART_FMA(R_zz, omega_z, STEWART_FMA(R_yz, omega_y, R_xz*omega_x));
    /* angular acceleration, platform frame */
    const stewart_real alpha_P_x = STEWART_FMA(R_zx, alpha_z, STEWART_FMA(R_yx, alpha_y, R_xx*alpha_x));
    const stewart_real alpha_P_y = STEWART_FMA(R_zy, alpha_z, STEWART_FMA(R_yy, alpha_y, R_xy*alpha_x));
    const stewart_real alpha_P_z = STEWART_FMA(R_zz, alpha_z, STEWART_FMA(R_yz, alpha_y, R_xz*alpha_x));
    /* (31) omega x an axis of the platform */
    const stewart_real w_h_P_x_x = STEWART_FMA(-R_yx, omega_z, R_zx*omega_y);
    const stewart_real w_h_P_x_y = STEWART_FMA(-R_zx, omega_x, R_xx*omega_z);
    const stewart_real w_h_P_x_z = STEWART_FMA(-R_xx, omega_y, R_yx*omega_x);
    const stewart_real w_h_P_y_x = STEWART_FMA(-R_yy, omega_z, R_zy*omega_y);
    const stewart_real w_h_P_y_y = STEWART_FMA(-R_zy, omega_x, R_xy*omega_z);
    const stewart_real w_h_P_y_z = STEWART_FMA(-R_xy, omega_y, R_yy*omega_x);
    const stewart_real w_h_P_z_x = STEWART_FMA(-R_yz, omega_z, R_zz*omega_y);
    const stewart_real w_h_P_z_y = STEWART_FMA(-R_zz, omega_x, R_xz*omega_z);
    const stewart_real w_h_P_z_z = STEWART_FMA(-R_xz, omega_y, R_yz*omega_x);
    const stewart_real c1 = omega_P_x*omega_P_z;
    const stewart_real c2 = omega_P_x*omega_P_y;
    /* (34) I alpha + omega x I omega by J_P_xx */
    const stewart_real E_J_P_xx_y = c1;
    const stewart_real E_J_P_xx_z = -c2;
    const stewart_real c5 = omega_P_y*omega_P_z;
    const stewart_real c6 = omega_P_x*omega_P_x;
    const stewart_real c7 = omega_P_y*omega_P_y;
    /* (34) I alpha + omega x I omega by J_P_xy */
    const stewart_real E_J_P_xy_x = alpha_P_y - c1;
    const stewart_real E_J_P_xy_y = alpha_P_x + c5;
    const stewart_real E_J_P_xy_z = c6 - c7;
    const stewart_real c8 = -omega_P_z*omega_P_z;
    /* (34) I alpha + omega x I omega by J_P_xz */
    const stewart_real E_J_P_xz_x = alpha_P_z + c2;
    const stewart_real E_J_P_xz_y = -c6 - c8;
    const stewart_real E_J_P_xz_z = alpha_P_x - c5;
    /* (34) I alpha + omega x I omega by J_P_yy */
    const stewart_real E_J_P_yy_x = -c5;
    const stewart_real E_J_P_yy_z = c2;
    /* (34) I alpha + omega x I omega by J_P_yz */
    const stewart_real E_J_P_yz_x = c7 + c8;
    const stewart_real E_J_P_yz_y = alpha_P_z - c2;
    const stewart_real E_J_P_yz_z = alpha_P_y + c1;
    /* (34) I alpha + omega x I omega by J_P_zz */
    const stewart_real E_J_P_zz_x = c5;
    const stewart_real E_J_P_zz_y = -c1;
    out->of_platform[0][0] = rise_x;
    out->of_platform[1][0] = rise_y;
    out->of_platform[2][0] = rise_z;
    out->of_platform[3][0] = REAL(0);
    out->of_platform[4][0] = REAL(0);
    out->of_platform[5][0] = REAL(0);
    out->of_platform[0][1] = STEWART_FMA(-omega_z, w_h_P_x_y, STEWART_FMA(-R_yx, alpha_z,
        STEWART_FMA(omega_y, w_h_P_x_z, R_zx*alpha_y)));
    out->of_platform[1][1] = STEWART_FMA(-omega_x, w_h_P_x_z, STEWART_FMA(-R_zx, alpha_x,
        STEWART_FMA(omega_z, w_h_P_x_x, R_xx*alpha_z)));
    out->of_platform[2][1] = STEWART_FMA(-omega_y, w_h_P_x_x, STEWART_FMA(-R_xx, alpha_y,
        STEWART_FMA(omega_x, w_h_P_x_y, R_yx*alpha_x)));
    out->of_platform[3][1] = STEWART_FMA(-R_zx, rise_y, R_yx*rise_z);
    out->of_platform[4][1] = STEWART_FMA(-R_xx, rise_z, R_zx*rise_x);
    out->of_platform[5][1] = STEWART_FMA(-R_yx, rise_x, R_xx*rise_y);
    out->of_platform[0][2] = STEWART_FMA(-omega_z, w_h_P_y_y, STEWART_FMA(-R_yy, alpha_z,
        STEWART_FMA(omega_y, w_h_P_y_z, R_zy*alpha_y)));
    out->of_platform[1][2] = STEWART_FMA(-omega_x, w_h_P_y_z, STEWART_FMA(-R_zy, alpha_x,
        STEWART_FMA(omega_z, w_h_P_y_x, R_xy*alpha_z)));
    out->of_platform[2][2] = STEWART_FMA(-omega_y, w_h_P_y_x, STEWART_FMA(-R_xy, alpha_y,
        STEWART_FMA(omega_x, w_h_P_y_y, R_yy*alpha_x)));
    out->of_platform[3][2] = STEWART_FMA(-R_zy, rise_y, R_yy*rise_z);
    out->of_platform[4][2] = STEWART_FMA(-R_xy, rise_z, R_zy*rise_x);
    out->of_platform[5][2] = STEWART_FMA(-R_yy, rise_x, R_xy*rise_y);
    out->of_platform[0][3] = STEWART_FMA(-omega_z, w_h_P_z_y, STEWART_FMA(-R_yz, alpha_z,
        STEWART_FMA(omega_y, w_h_P_z_z, R_zz*alpha_y)));
    out->of_platform[1][3] = STEWART_FMA(-omega_x, w_h_P_z_z, STEWART_FMA(-R_zz, alpha_x,
        STEWART_FMA(omega_z, w_h_P_z_x, R_xz*alpha_z)));
    out->of_platform[2][3] = STEWART_FMA(-omega_y, w_h_P_z_x, STEWART_FMA(-R_xz, alpha_y,
        STEWART_FMA(omega_x, w_h_P_z_y, R_yz*alpha_x)));
    out->of_platform[3][3] = STEWART_FMA(-R_zz, rise_y, R_yz*rise_z);
    out->of_platform[4][3] = STEWART_FMA(-R_xz, rise_z, R_zz*rise_x);
    out->of_platform[5][3] = STEWART_FMA(-R_yz, rise_x, R_xz*rise_y);
    out->of_platform[0][4] = REAL(0);
    out->of_platform[1][4] = REAL(0);
    out->of_platform[2][4] = REAL(0);
    out->of_platform[3][4] = STEWART_FMA(R_xx, alpha_P_x, STEWART_FMA(E_J_P_xx_z, R_xz, E_J_P_xx_y*R_xy));
    out->of_platform[4][4] = STEWART_FMA(R_yx, alpha_P_x, STEWART_FMA(E_J_P_xx_z, R_yz, E_J_P_xx_y*R_yy));
    out->of_platform[5][4] = STEWART_FMA(R_zx, alpha_P_x, STEWART_FMA(E_J_P_xx_z, R_zz, E_J_P_xx_y*R_zy));
    out->of_platform[0][5] = REAL(0);
    out->of_platform[1][5] = REAL(0);
    out->of_platform[2][5] = REAL(0);
    out->of_platform[3][5] = STEWART_FMA(E_J_P_xy_z, R_xz, STEWART_FMA(E_J_P_xy_y, R_xy, E_J_P_xy_x*R_xx));
    out->of_platform[4][5] = STEWART_FMA(E_J_P_xy_z, R_yz, STEWART_FMA(E_J_P_xy_y, R_yy, E_J_P_xy_x*R_yx));
    out->of_platform[5][5] = STEWART_FMA(E_J_P_xy_z, R_zz, STEWART_FMA(E_J_P_xy_y, R_zy, E_J_P_xy_x*R_zx));
    out->of_platform[0][6] = REAL(0);
    out->of_platform[1][6] = REAL(0);
    out->of_platform[2][6] = REAL(0);
    out->of_platform[3][6] = STEWART_FMA(E_J_P_xz_z, R_xz, STEWART_FMA(E_J_P_xz_y, R_xy, E_J_P_xz_x*R_xx));
    out->of_platform[4][6] = STEWART_FMA(E_J_P_xz_z, R_yz, STEWART_FMA(E_J_P_xz_y, R_yy, E_J_P_xz_x*R_yx));
    out->of_platform[5][6] = STEWART_FMA(E_J_P_xz_z, R_zz, STEWART_FMA(E_J_P_xz_y, R_zy, E_J_P_xz_x*R_zx));
    out->of_platform[0][7] = REAL(0);
    out->of_platform[1][7] = REAL(0);
    out->of_platform[2][7] = REAL(0);
    out->of_platform[3][7] = STEWART_FMA(R_xy, alpha_P_y, STEWART_FMA(E_J_P_yy_z, R_xz, E_J_P_yy_x*R_xx));
    out->of_platform[4][7] = STEWART_FMA(R_yy, alpha_P_y, STEWART_FMA(E_J_P_yy_z, R_yz, E_J_P_yy_x*R_yx));
    out->of_platform[5][7] = STEWART_FMA(R_zy, alpha_P_y, STEWART_FMA(E_J_P_yy_z, R_zz, E_J_P_yy_x*R_zx));
    out->of_platform[0][8] = REAL(0);
    out->of_platform[1][8] = REAL(0);
    out->of_platform[2][8] = REAL(0);
    out->of_platform[3][8] = STEWART_FMA(E_J_P_yz_z, R_xz, STEWART_FMA(E_J_P_yz_y, R_xy, E_J_P_yz_x*R_xx));
    out->of_platform[4][8] = STEWART_FMA(E_J_P_yz_z, R_yz, STEWART_FMA(E_J_P_yz_y, R_yy, E_J_P_yz_x*R_yx));
    out->of_platform[5][8] = STEWART_FMA(E_J_P_yz_z, R_zz, STEWART_FMA(E_J_P_yz_y, R_zy, E_J_P_yz_x*R_zx));
    out->of_platform[0][9] = REAL(0);
    out->of_platform[1][9] = REAL(0);
    out->of_platform[2][9] = REAL(0);
    out->of_platform[3][9] = STEWART_FMA(R_xz, alpha_P_z, STEWART_FMA(E_J_P_zz_y, R_xy, E_J_P_zz_x*R_xx));
    out->of_platform[4][9] = STEWART_FMA(R_yz, alpha_P_z, STEWART_FMA(E_J_P_zz_y, R_yy, E_J_P_zz_x*R_yx));
    out->of_platform[5][9] = STEWART_FMA(R_zz, alpha_P_z, STEWART_FMA(E_J_P_zz_y, R_zy, E_J_P_zz_x*R_zx));
}

/* Returns the status of the legs, or NOT_FINITE if a number is not finite. */
static int columns_status(const regressor_columns *found)
{
    int i, j;
    const int status = legs_status(&found->checked);
    stewart_real lost = REAL(0);
    for (i = 0; i < 6; ++i) {
        lost = STEWART_LARGER(found->lost[i], lost);
        for (j = 0; j < 10; ++j) {
            lost = STEWART_FABS(found->of_platform[i][j]) <= STEWART_MAX ? lost : REAL(1);
        }
    }
    return (status == STEWART_OK && lost > REAL(0)) ? STEWART_NOT_FINITE : status;
}

/* Copies all columns: leg after leg, then the platform. */
static void all_columns(const regressor_columns *found, stewart_real *Y)
{
    int i, j, leg;
    for (i = 0; i < 6; ++i) {
        for (leg = 0; leg < 6; ++leg) {
            for (j = 0; j < 23; ++j) {
                Y[i*148 + leg*23 + j] = found->of_legs[i][j][leg];
            }
        }
        for (j = 0; j < 10; ++j) {
            Y[i*148 + 138 + j] = found->of_platform[i][j];
        }
    }
}

/* Copies the requested columns. */
static void chosen_columns(
    const regressor_columns *found, const int *columns, size_t width, stewart_real *Y)
{
    size_t each;
    int i;
    for (each = 0; each < width; ++each) {
        const int column = columns[each];
        const int leg = column/23;
        for (i = 0; i < 6; ++i) {
            if (column < 138) {
                Y[(size_t)i*width + each] = found->of_legs[i][column - leg*23][leg];
            } else {
                Y[(size_t)i*width + each] = found->of_platform[i][column - 138];
            }
        }
    }
}

int stewart_exact_regressor(
    const stewart_robot *robot, const stewart_motion *motion, const int *columns, size_t width,
    stewart_real *Y)
{
    size_t i;
    regressor_columns found;
    if (robot == NULL || motion == NULL || Y == NULL || (columns == NULL && width != 0U)) {
        return STEWART_BAD_ARGUMENT;
    }
    for (i = 0; i < width; ++i) {
        if (columns[i] < 0 || columns[i] >= 148) {
            return STEWART_BAD_ARGUMENT;
        }
    }
    columns_of_legs(robot, motion, &found);
    columns_of_platform(robot, motion, &found);
    const int status = columns_status(&found);
    if (status == STEWART_OK) {
        if (columns == NULL) {
            all_columns(&found, Y);
        } else {
            chosen_columns(&found, columns, width, Y);
        }
    }
    return status;
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
        one->alpha[i] = motions->alpha[at];
        one->a[i] = motions->a[at];
        one->F_ext[i] = motions->F_ext != NULL ? motions->F_ext[at] : REAL(0);
        one->M_ext[i] = motions->M_ext != NULL ? motions->M_ext[at] : REAL(0);
    }
}

int stewart_exact_regressor_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const int *columns,
    size_t width, stewart_real *Y, int *status)
{
    size_t pose;
    stewart_motion one;
    const size_t each = 6U*(columns != NULL ? width : 148);
    if (robot == NULL || motions == NULL || Y == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL || motions->alpha == NULL || motions->a == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    int result = STEWART_OK;
    for (pose = 0; pose < count; ++pose) {
        load_pose(motions, pose, &one);
        const int code = stewart_exact_regressor(robot, &one, columns, width, &Y[pose*each]);
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}
