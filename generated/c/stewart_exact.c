/* stewart_exact.c: functions that are declared and described in stewart_exact.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_exact.h"

#include "stewart_outputs.h"

typedef struct {
    stewart_real q[3]; /* m: platform point from the reference point, base frame */
    stewart_real L; /* m: length of the leg */
    stewart_real k3; /* 1: |k x s|, sine of the angle between the leg and the fixed axis */
    stewart_real D; /* N: known part of the actuator force */
    stewart_real K[3]; /* N: transverse force on the leg at its spherical joint, base frame */
    stewart_real H_force[3]; /* 1: the leg's column of H, force rows */
    stewart_real H_moment[3]; /* m: the leg's column of H, moment rows */
    stewart_real c_force[3]; /* N: part of c, force rows, base frame */
    stewart_real c_moment[3]; /* N m: part of c, moment rows, base frame */
} leg_terms;

typedef struct {
    stewart_real F_s[3]; /* N: force on the leg at the spherical joint, base frame */
    stewart_real F_u[3]; /* N: force on the leg at the universal joint, base frame */
    stewart_real F_p[3]; /* N: force of the lower part on the upper at the prismatic joint, without the viscous friction -C_p L_dot s, base frame */
    stewart_real F_c[3]; /* N: constraint part of F_p, base frame */
    /* N m: moment of the lower part, on which the gyroscopic moment of a rotor acts, on the upper at the
     * prismatic joint, base frame */
    stewart_real M_p[3];
    stewart_real M_u; /* N m: constraint moment on the leg at the universal joint, along k x y, y the moving axis; in `paper` along s */
} reaction_terms;

/* One leg: D, K, its column of H and its part of c, (1)-(24), (35). Operations: 414 (229 mul, 181 add, 2
 * div, 2 sqrt). */
static void leg_dynamics(
    const stewart_robot *robot, const stewart_leg *leg, const stewart_motions *at, leg_terms *out)
{
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = leg->k[0], k_y = leg->k[1], k_z = leg->k[2];
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
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    /* (1) platform point from the reference point */
    const stewart_real q_x = STEWART_FMA(R_xz, p_z, STEWART_FMA(R_xy, p_y, R_xx*p_x));
    const stewart_real q_y = STEWART_FMA(R_yz, p_z, STEWART_FMA(R_yy, p_y, R_yx*p_x));
    const stewart_real q_z = STEWART_FMA(R_zz, p_z, STEWART_FMA(R_zy, p_y, R_zx*p_x));
    /* (1) leg vector */
    const stewart_real S_x = t_x - b_x + q_x;
    const stewart_real S_y = t_y - b_y + q_y;
    const stewart_real S_z = t_z - b_z + q_z;
    /* (2) leg length */
    const stewart_real L = STEWART_SQRT(STEWART_FMA(S_z, S_z, STEWART_FMA(S_y, S_y, S_x*S_x)));
    const stewart_real inv_L = REAL(1)/L;
    /* (3) unit vector along the leg */
    const stewart_real s_x = S_x*inv_L;
    const stewart_real s_y = S_y*inv_L;
    const stewart_real s_z = S_z*inv_L;
    /* (4) omega x q */
    const stewart_real w_q_x = STEWART_FMA(-omega_z, q_y, omega_y*q_z);
    const stewart_real w_q_y = STEWART_FMA(-omega_x, q_z, omega_z*q_x);
    const stewart_real w_q_z = STEWART_FMA(-omega_y, q_x, omega_x*q_y);
    /* (4) velocity of the platform point */
    const stewart_real S_dot_x = v_x + w_q_x;
    const stewart_real S_dot_y = v_y + w_q_y;
    const stewart_real S_dot_z = v_z + w_q_z;
    /* (7) acceleration of the platform point */
    const stewart_real S_ddot_x = STEWART_FMA(-omega_z, w_q_y, STEWART_FMA(omega_y, w_q_z,
        STEWART_FMA(-alpha_z, q_y, STEWART_FMA(alpha_y, q_z, a_x))));
    const stewart_real S_ddot_y = STEWART_FMA(-omega_x, w_q_z, STEWART_FMA(omega_z, w_q_x,
        STEWART_FMA(-alpha_x, q_z, STEWART_FMA(alpha_z, q_x, a_y))));
    const stewart_real S_ddot_z = STEWART_FMA(-omega_y, w_q_x, STEWART_FMA(omega_x, w_q_y,
        STEWART_FMA(-alpha_y, q_x, STEWART_FMA(alpha_x, q_y, a_z))));
    /* (10) normal to the fixed axis and the leg */
    const stewart_real k_cross_s_x = STEWART_FMA(-k_z, s_y, k_y*s_z);
    const stewart_real k_cross_s_y = STEWART_FMA(-k_x, s_z, k_z*s_x);
    const stewart_real k_cross_s_z = STEWART_FMA(-k_y, s_x, k_x*s_y);
    /* (10) along the third axis of the leg */
    const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_s_y, s_z, k_cross_s_z*s_y);
    const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_s_z, s_x, k_cross_s_x*s_z);
    const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_s_x, s_y, k_cross_s_y*s_x);
    /* (10) k = (k1, 0, k3) in the leg frame */
    const stewart_real k3 = STEWART_SQRT(STEWART_FMA(s_cross_normal_z, s_cross_normal_z,
        STEWART_FMA(s_cross_normal_y, s_cross_normal_y, s_cross_normal_x*s_cross_normal_x)));
    const stewart_real inv_k3 = REAL(1)/k3;
    /* (10) third axis of the leg frame */
    const stewart_real z_x = inv_k3*s_cross_normal_x;
    const stewart_real z_y = inv_k3*s_cross_normal_y;
    const stewart_real z_z = inv_k3*s_cross_normal_z;
    /* (10) rotating axis of the universal joint */
    const stewart_real y_x = STEWART_FMA(-s_y, z_z, s_z*z_y);
    const stewart_real y_y = STEWART_FMA(-s_z, z_x, s_x*z_z);
    const stewart_real y_z = STEWART_FMA(-s_x, z_y, s_y*z_x);
    /* (10) k = (k1, 0, k3) in the leg frame */
    const stewart_real k1 = STEWART_FMA(k_z, s_z, STEWART_FMA(k_y, s_y, k_x*s_x));
    /* spin of the leg about s per rotation about z */
    const stewart_real kappa = inv_k3*k1;
    /* (4), (5) velocity of the platform point, leg frame; u_x is L_dot */
    const stewart_real u_x = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
    const stewart_real u_y = STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y, S_dot_x*y_x));
    const stewart_real u_z = STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y, S_dot_x*z_x));
    /* (7) acceleration of the platform point, leg frame */
    const stewart_real e_x = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y, S_ddot_x*s_x));
    const stewart_real e_y = STEWART_FMA(S_ddot_z, y_z, STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x));
    const stewart_real e_z = STEWART_FMA(S_ddot_z, z_z, STEWART_FMA(S_ddot_y, z_y, S_ddot_x*z_x));
    /* gravity, leg frame */
    const stewart_real gamma_x = STEWART_FMA(g_z, s_z, STEWART_FMA(g_y, s_y, g_x*s_x));
    const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
    const stewart_real gamma_z = STEWART_FMA(g_z, z_z, STEWART_FMA(g_y, z_y, g_x*z_x));
    /* angular velocity of the platform, leg frame */
    const stewart_real w_x = STEWART_FMA(omega_z, s_z, STEWART_FMA(omega_y, s_y, omega_x*s_x));
    const stewart_real w_y = STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x));
    const stewart_real w_z = STEWART_FMA(omega_z, z_z, STEWART_FMA(omega_y, z_y, omega_x*z_x));
    /* (6) angular velocity of the leg, leg frame */
    const stewart_real W_z = inv_L*u_y;
    const stewart_real W_y = -inv_L*u_z;
    const stewart_real W_x = W_z*kappa;
    const stewart_real c1 = W_y*W_y;
    const stewart_real c2 = W_z*W_z;
    /* (8) sliding acceleration */
    const stewart_real L_ddot = STEWART_FMA(L, c2, L*c1) + e_x;
    const stewart_real c3 = REAL(2)*u_x;
    const stewart_real c4 = W_z*c3;
    const stewart_real c5 = W_y*c3;
    /* (9) angular acceleration of the leg without the spin terms, leg frame */
    const stewart_real A_z_own = inv_L*(e_y - c4);
    const stewart_real A_y_own = inv_L*(-e_z - c5);
    const stewart_real c6 = W_y*W_z;
    const stewart_real c7 = W_x*W_y;
    const stewart_real c8 = REAL(2)*c7;
    /* (9) angular acceleration of the leg, leg frame */
    const stewart_real A_x = STEWART_FMA(kappa, A_z_own - c8, -c6);
    /* (12) center of mass of the upper part from the base point */
    const stewart_real r_u_x = r_u0_x + L;
    const stewart_real c9 = W_x*W_z;
    const stewart_real c10 = REAL(2)*c9;
    const stewart_real c11 = W_x*W_x;
    /* (11), (13) acceleration of the lower center of mass */
    const stewart_real a_d_x = STEWART_FMA(-A_z_own, r_d0_y, STEWART_FMA(c8, r_d0_y, STEWART_FMA(c10,
        r_d0_z, STEWART_FMA(-c2, r_d0_x, STEWART_FMA(-c1, r_d0_x, A_y_own*r_d0_z)))));
    const stewart_real a_d_y = STEWART_FMA(-A_x, r_d0_z, STEWART_FMA(A_z_own, r_d0_x, STEWART_FMA(-c2,
        r_d0_y, STEWART_FMA(-c11, r_d0_y, W_y*W_z*r_d0_z))));
    const stewart_real a_d_z = STEWART_FMA(A_x, r_d0_y, STEWART_FMA(-A_y_own, r_d0_x, STEWART_FMA(-c11,
        r_d0_z, STEWART_FMA(-c1, r_d0_z, W_y*W_z*r_d0_y))));
    /* (14) acceleration of the upper center of mass */
    const stewart_real a_u_x = STEWART_FMA(-A_z_own, r_u0_y, STEWART_FMA(c8, r_u0_y, STEWART_FMA(c10,
        r_u0_z, STEWART_FMA(A_y_own, r_u0_z, STEWART_FMA(-c2, r_u_x, STEWART_FMA(-c1, r_u_x, L_ddot))))));
    const stewart_real a_u_y = STEWART_FMA(-A_x, r_u0_z, STEWART_FMA(A_z_own, r_u_x, STEWART_FMA(W_y*W_z,
        r_u0_z, STEWART_FMA(-c2, r_u0_y, STEWART_FMA(-c11, r_u0_y, c4)))));
    const stewart_real a_u_z = STEWART_FMA(A_x, r_u0_y, STEWART_FMA(-A_y_own, r_u_x, STEWART_FMA(-c11,
        r_u0_z, STEWART_FMA(-c1, r_u0_z, W_y*W_z*r_u0_y)) - c5));
    /* (25) m_d (a_d - g) */
    const stewart_real N_d_x = m_d*(a_d_x - gamma_x);
    const stewart_real N_d_y = m_d*(a_d_y - gamma_y);
    const stewart_real N_d_z = m_d*(a_d_z - gamma_z);
    /* (23) m_u (a_u - g) */
    const stewart_real N_u_x = m_u*(a_u_x - gamma_x);
    const stewart_real N_u_y = m_u*(a_u_y - gamma_y);
    const stewart_real N_u_z = m_u*(a_u_z - gamma_z);
    /* (18) friction moment at the spherical joint, leg frame */
    const stewart_real f_leg_x = C_s*(W_x - w_x);
    const stewart_real f_leg_y = C_s*(W_y - w_y);
    const stewart_real f_leg_z = C_s*(W_z - w_z);
    /* (15), (16), (19) I_d + I_u */
    const stewart_real I_xx = I_d0_xx + I_u0_xx;
    const stewart_real I_xy = I_d0_xy + I_u0_xy;
    const stewart_real I_xz = I_d0_xz + I_u0_xz;
    const stewart_real I_yy = I_d0_yy + I_u0_yy;
    const stewart_real I_yz = I_d0_yz + I_u0_yz;
    const stewart_real I_zz = I_d0_zz + I_u0_zz;
    const stewart_real c15 = I_yy - I_zz;
    /* (19) I A + W x I W */
    const stewart_real E_x = STEWART_FMA(A_x, I_xx, STEWART_FMA(A_z_own, I_xz, STEWART_FMA(-c15, c6,
        STEWART_FMA(A_y_own, I_xy, STEWART_FMA(-I_yz, c2, I_yz*c1)))));
    const stewart_real E_y = STEWART_FMA(A_x, I_xy, STEWART_FMA(-I_yz, c8, STEWART_FMA(A_z_own, I_yz,
        STEWART_FMA(c9, I_xx + c15, STEWART_FMA(A_y_own, I_yy, STEWART_FMA(I_xy, c6, STEWART_FMA(-I_xz, c11,
        I_xz*c2)))))));
    const stewart_real E_z = STEWART_FMA(A_x, I_xz, STEWART_FMA(A_z_own, I_zz, STEWART_FMA(I_yz, c10,
        STEWART_FMA(-I_xz, c6, STEWART_FMA(c7, I_yy - I_xx - I_zz, STEWART_FMA(A_y_own, I_yz,
        STEWART_FMA(-I_xy, c1, I_xy*c11)))))));
    /* (20) moment that the joint forces must balance */
    const stewart_real C_x = STEWART_FMA(-N_u_y, r_u0_z, STEWART_FMA(-N_d_y, r_d0_z, STEWART_FMA(N_u_z,
        r_u0_y, STEWART_FMA(N_d_z, r_d0_y, STEWART_FMA(C_u, W_x, f_leg_x) + E_x))));
    const stewart_real C_y = STEWART_FMA(-N_u_z, r_u_x, STEWART_FMA(-N_d_z, r_d0_x, STEWART_FMA(N_u_x,
        r_u0_z, STEWART_FMA(N_d_x, r_d0_z, STEWART_FMA(C_u, W_y, f_leg_y) + E_y))));
    const stewart_real C_z = STEWART_FMA(N_u_y, r_u_x, STEWART_FMA(N_d_y, r_d0_x, STEWART_FMA(-N_u_x,
        r_u0_y, STEWART_FMA(-N_d_x, r_d0_y, STEWART_FMA(C_u, W_z, f_leg_z) + E_z))));
    /* (24) known part of the actuator force */
    const stewart_real D = STEWART_FMA(C_p, u_x, N_u_x);
    /* (21) transverse force at the spherical joint, leg frame */
    const stewart_real K_leg_y = inv_L*STEWART_FMA(C_x, kappa, C_z);
    const stewart_real K_leg_z = -C_y*inv_L;
    /* (21) transverse force at the spherical joint, base frame */
    const stewart_real K_x = STEWART_FMA(K_leg_y, y_x, K_leg_z*z_x);
    const stewart_real K_y = STEWART_FMA(K_leg_y, y_y, K_leg_z*z_y);
    const stewart_real K_z = STEWART_FMA(K_leg_y, y_z, K_leg_z*z_z);
    /* (18) friction moment at the spherical joint, base frame */
    const stewart_real f_x = STEWART_FMA(f_leg_x, s_x, STEWART_FMA(f_leg_z, z_x, f_leg_y*y_x));
    const stewart_real f_y = STEWART_FMA(f_leg_x, s_y, STEWART_FMA(f_leg_z, z_y, f_leg_y*y_y));
    const stewart_real f_z = STEWART_FMA(f_leg_x, s_z, STEWART_FMA(f_leg_z, z_z, f_leg_y*y_z));
    out->q[0] = q_x;
    out->q[1] = q_y;
    out->q[2] = q_z;
    out->L = L;
    out->k3 = k3;
    out->D = D;
    out->K[0] = K_x;
    out->K[1] = K_y;
    out->K[2] = K_z;
    out->H_force[0] = s_x;
    out->H_force[1] = s_y;
    out->H_force[2] = s_z;
    out->H_moment[0] = STEWART_FMA(-q_z, s_y, q_y*s_z);
    out->H_moment[1] = STEWART_FMA(-q_x, s_z, q_z*s_x);
    out->H_moment[2] = STEWART_FMA(-q_y, s_x, q_x*s_y);
    out->c_force[0] = -K_x;
    out->c_force[1] = -K_y;
    out->c_force[2] = -K_z;
    out->c_moment[0] = STEWART_FMA(-K_z, q_y, STEWART_FMA(K_y, q_z, f_x));
    out->c_moment[1] = STEWART_FMA(-K_x, q_z, STEWART_FMA(K_z, q_x, f_y));
    out->c_moment[2] = STEWART_FMA(-K_y, q_x, STEWART_FMA(K_x, q_y, f_z));
}

/* One leg: joint reactions, (21), (26)-(29), (17). Operations: 508 (275 mul, 229 add, 2 div, 2 sqrt). */
static void leg_reactions(
    const stewart_robot *robot, const stewart_leg *leg, const stewart_motions *at, stewart_real x,
    stewart_real bearing, reaction_terms *out)
{
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = leg->k[0], k_y = leg->k[1], k_z = leg->k[2];
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
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real t_x = at->t[0], t_y = at->t[1], t_z = at->t[2];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real v_x = at->v[0], v_y = at->v[1], v_z = at->v[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    /* (1) platform point from the reference point */
    const stewart_real q_x = STEWART_FMA(R_xz, p_z, STEWART_FMA(R_xy, p_y, R_xx*p_x));
    const stewart_real q_y = STEWART_FMA(R_yz, p_z, STEWART_FMA(R_yy, p_y, R_yx*p_x));
    const stewart_real q_z = STEWART_FMA(R_zz, p_z, STEWART_FMA(R_zy, p_y, R_zx*p_x));
    /* (1) leg vector */
    const stewart_real S_x = t_x - b_x + q_x;
    const stewart_real S_y = t_y - b_y + q_y;
    const stewart_real S_z = t_z - b_z + q_z;
    /* (2) leg length */
    const stewart_real L = STEWART_SQRT(STEWART_FMA(S_z, S_z, STEWART_FMA(S_y, S_y, S_x*S_x)));
    const stewart_real inv_L = REAL(1)/L;
    /* (3) unit vector along the leg */
    const stewart_real s_x = S_x*inv_L;
    const stewart_real s_y = S_y*inv_L;
    const stewart_real s_z = S_z*inv_L;
    /* (4) omega x q */
    const stewart_real w_q_x = STEWART_FMA(-omega_z, q_y, omega_y*q_z);
    const stewart_real w_q_y = STEWART_FMA(-omega_x, q_z, omega_z*q_x);
    const stewart_real w_q_z = STEWART_FMA(-omega_y, q_x, omega_x*q_y);
    /* (4) velocity of the platform point */
    const stewart_real S_dot_x = v_x + w_q_x;
    const stewart_real S_dot_y = v_y + w_q_y;
    const stewart_real S_dot_z = v_z + w_q_z;
    /* (7) acceleration of the platform point */
    const stewart_real S_ddot_x = STEWART_FMA(-omega_z, w_q_y, STEWART_FMA(omega_y, w_q_z,
        STEWART_FMA(-alpha_z, q_y, STEWART_FMA(alpha_y, q_z, a_x))));
    const stewart_real S_ddot_y = STEWART_FMA(-omega_x, w_q_z, STEWART_FMA(omega_z, w_q_x,
        STEWART_FMA(-alpha_x, q_z, STEWART_FMA(alpha_z, q_x, a_y))));
    const stewart_real S_ddot_z = STEWART_FMA(-omega_y, w_q_x, STEWART_FMA(omega_x, w_q_y,
        STEWART_FMA(-alpha_y, q_x, STEWART_FMA(alpha_x, q_y, a_z))));
    /* (10) normal to the fixed axis and the leg */
    const stewart_real k_cross_s_x = STEWART_FMA(-k_z, s_y, k_y*s_z);
    const stewart_real k_cross_s_y = STEWART_FMA(-k_x, s_z, k_z*s_x);
    const stewart_real k_cross_s_z = STEWART_FMA(-k_y, s_x, k_x*s_y);
    /* (10) along the third axis of the leg */
    const stewart_real s_cross_normal_x = STEWART_FMA(-k_cross_s_y, s_z, k_cross_s_z*s_y);
    const stewart_real s_cross_normal_y = STEWART_FMA(-k_cross_s_z, s_x, k_cross_s_x*s_z);
    const stewart_real s_cross_normal_z = STEWART_FMA(-k_cross_s_x, s_y, k_cross_s_y*s_x);
    /* (10) k = (k1, 0, k3) in the leg frame */
    const stewart_real k3 = STEWART_SQRT(STEWART_FMA(s_cross_normal_z, s_cross_normal_z,
        STEWART_FMA(s_cross_normal_y, s_cross_normal_y, s_cross_normal_x*s_cross_normal_x)));
    const stewart_real inv_k3 = REAL(1)/k3;
    /* (10) third axis of the leg frame */
    const stewart_real z_x = inv_k3*s_cross_normal_x;
    const stewart_real z_y = inv_k3*s_cross_normal_y;
    const stewart_real z_z = inv_k3*s_cross_normal_z;
    /* (10) rotating axis of the universal joint */
    const stewart_real y_x = STEWART_FMA(-s_y, z_z, s_z*z_y);
    const stewart_real y_y = STEWART_FMA(-s_z, z_x, s_x*z_z);
    const stewart_real y_z = STEWART_FMA(-s_x, z_y, s_y*z_x);
    /* (10) k = (k1, 0, k3) in the leg frame */
    const stewart_real k1 = STEWART_FMA(k_z, s_z, STEWART_FMA(k_y, s_y, k_x*s_x));
    /* spin of the leg about s per rotation about z */
    const stewart_real kappa = inv_k3*k1;
    /* (4), (5) velocity of the platform point, leg frame; u_x is L_dot */
    const stewart_real u_x = STEWART_FMA(S_dot_z, s_z, STEWART_FMA(S_dot_y, s_y, S_dot_x*s_x));
    const stewart_real u_y = STEWART_FMA(S_dot_z, y_z, STEWART_FMA(S_dot_y, y_y, S_dot_x*y_x));
    const stewart_real u_z = STEWART_FMA(S_dot_z, z_z, STEWART_FMA(S_dot_y, z_y, S_dot_x*z_x));
    /* (7) acceleration of the platform point, leg frame */
    const stewart_real e_x = STEWART_FMA(S_ddot_z, s_z, STEWART_FMA(S_ddot_y, s_y, S_ddot_x*s_x));
    const stewart_real e_y = STEWART_FMA(S_ddot_z, y_z, STEWART_FMA(S_ddot_y, y_y, S_ddot_x*y_x));
    const stewart_real e_z = STEWART_FMA(S_ddot_z, z_z, STEWART_FMA(S_ddot_y, z_y, S_ddot_x*z_x));
    /* gravity, leg frame */
    const stewart_real gamma_x = STEWART_FMA(g_z, s_z, STEWART_FMA(g_y, s_y, g_x*s_x));
    const stewart_real gamma_y = STEWART_FMA(g_z, y_z, STEWART_FMA(g_y, y_y, g_x*y_x));
    const stewart_real gamma_z = STEWART_FMA(g_z, z_z, STEWART_FMA(g_y, z_y, g_x*z_x));
    /* angular velocity of the platform, leg frame */
    const stewart_real w_x = STEWART_FMA(omega_z, s_z, STEWART_FMA(omega_y, s_y, omega_x*s_x));
    const stewart_real w_y = STEWART_FMA(omega_z, y_z, STEWART_FMA(omega_y, y_y, omega_x*y_x));
    const stewart_real w_z = STEWART_FMA(omega_z, z_z, STEWART_FMA(omega_y, z_y, omega_x*z_x));
    /* (6) angular velocity of the leg, leg frame */
    const stewart_real W_z = inv_L*u_y;
    const stewart_real W_y = -inv_L*u_z;
    const stewart_real W_x = W_z*kappa;
    const stewart_real c1 = W_y*W_y;
    const stewart_real c2 = W_z*W_z;
    /* (8) sliding acceleration */
    const stewart_real L_ddot = STEWART_FMA(L, c2, L*c1) + e_x;
    const stewart_real c3 = REAL(2)*u_x;
    const stewart_real c4 = W_z*c3;
    const stewart_real c5 = W_y*c3;
    /* (9) angular acceleration of the leg without the spin terms, leg frame */
    const stewart_real A_z_own = inv_L*(e_y - c4);
    const stewart_real A_y_own = inv_L*(-e_z - c5);
    const stewart_real c6 = W_y*W_z;
    const stewart_real c7 = W_x*W_y;
    const stewart_real c8 = REAL(2)*c7;
    /* (9) angular acceleration of the leg, leg frame */
    const stewart_real A_x = STEWART_FMA(kappa, A_z_own - c8, -c6);
    /* (12) center of mass of the upper part from the base point */
    const stewart_real r_u_x = r_u0_x + L;
    const stewart_real c9 = W_x*W_z;
    const stewart_real c10 = REAL(2)*c9;
    const stewart_real c11 = W_x*W_x;
    /* (11), (13) acceleration of the lower center of mass */
    const stewart_real a_d_x = STEWART_FMA(-A_z_own, r_d0_y, STEWART_FMA(c8, r_d0_y, STEWART_FMA(c10,
        r_d0_z, STEWART_FMA(-c2, r_d0_x, STEWART_FMA(-c1, r_d0_x, A_y_own*r_d0_z)))));
    const stewart_real a_d_y = STEWART_FMA(-A_x, r_d0_z, STEWART_FMA(A_z_own, r_d0_x, STEWART_FMA(-c2,
        r_d0_y, STEWART_FMA(-c11, r_d0_y, W_y*W_z*r_d0_z))));
    const stewart_real a_d_z = STEWART_FMA(A_x, r_d0_y, STEWART_FMA(-A_y_own, r_d0_x, STEWART_FMA(-c11,
        r_d0_z, STEWART_FMA(-c1, r_d0_z, W_y*W_z*r_d0_y))));
    /* (14) acceleration of the upper center of mass */
    const stewart_real a_u_x = STEWART_FMA(-A_z_own, r_u0_y, STEWART_FMA(c8, r_u0_y, STEWART_FMA(c10,
        r_u0_z, STEWART_FMA(A_y_own, r_u0_z, STEWART_FMA(-c2, r_u_x, STEWART_FMA(-c1, r_u_x, L_ddot))))));
    const stewart_real a_u_y = STEWART_FMA(-A_x, r_u0_z, STEWART_FMA(A_z_own, r_u_x, STEWART_FMA(W_y*W_z,
        r_u0_z, STEWART_FMA(-c2, r_u0_y, STEWART_FMA(-c11, r_u0_y, c4)))));
    const stewart_real a_u_z = STEWART_FMA(A_x, r_u0_y, STEWART_FMA(-A_y_own, r_u_x, STEWART_FMA(-c11,
        r_u0_z, STEWART_FMA(-c1, r_u0_z, W_y*W_z*r_u0_y)) - c5));
    /* (25) m_d (a_d - g) */
    const stewart_real N_d_x = m_d*(a_d_x - gamma_x);
    const stewart_real N_d_y = m_d*(a_d_y - gamma_y);
    const stewart_real N_d_z = m_d*(a_d_z - gamma_z);
    /* (23) m_u (a_u - g) */
    const stewart_real N_u_x = m_u*(a_u_x - gamma_x);
    const stewart_real N_u_y = m_u*(a_u_y - gamma_y);
    const stewart_real N_u_z = m_u*(a_u_z - gamma_z);
    /* (18) friction moment at the spherical joint, leg frame */
    const stewart_real f_leg_x = C_s*(W_x - w_x);
    const stewart_real f_leg_y = C_s*(W_y - w_y);
    const stewart_real f_leg_z = C_s*(W_z - w_z);
    /* (15), (16), (19) I_d + I_u */
    const stewart_real I_xx = I_d0_xx + I_u0_xx;
    const stewart_real I_xy = I_d0_xy + I_u0_xy;
    const stewart_real I_xz = I_d0_xz + I_u0_xz;
    const stewart_real I_yy = I_d0_yy + I_u0_yy;
    const stewart_real I_yz = I_d0_yz + I_u0_yz;
    const stewart_real I_zz = I_d0_zz + I_u0_zz;
    const stewart_real c15 = I_yy - I_zz;
    /* (19) I A + W x I W */
    const stewart_real E_x = STEWART_FMA(A_x, I_xx, STEWART_FMA(A_z_own, I_xz, STEWART_FMA(-c15, c6,
        STEWART_FMA(A_y_own, I_xy, STEWART_FMA(-I_yz, c2, I_yz*c1)))));
    const stewart_real E_y = STEWART_FMA(A_x, I_xy, STEWART_FMA(-I_yz, c8, STEWART_FMA(A_z_own, I_yz,
        STEWART_FMA(c9, I_xx + c15, STEWART_FMA(A_y_own, I_yy, STEWART_FMA(I_xy, c6, STEWART_FMA(-I_xz, c11,
        I_xz*c2)))))));
    const stewart_real E_z = STEWART_FMA(A_x, I_xz, STEWART_FMA(A_z_own, I_zz, STEWART_FMA(I_yz, c10,
        STEWART_FMA(-I_xz, c6, STEWART_FMA(c7, I_yy - I_xx - I_zz, STEWART_FMA(A_y_own, I_yz,
        STEWART_FMA(-I_xy, c1, I_xy*c11)))))));
    const stewart_real c16 = I_d0_yy - I_d0_zz;
    /* (17) I_d A + W x I_d W */
    const stewart_real E_d_x = STEWART_FMA(A_x, I_d0_xx, STEWART_FMA(A_z_own, I_d0_xz, STEWART_FMA(-c16, c6,
        STEWART_FMA(A_y_own, I_d0_xy, STEWART_FMA(-I_d0_yz, c2, I_d0_yz*c1)))));
    const stewart_real E_d_y = STEWART_FMA(A_x, I_d0_xy, STEWART_FMA(-I_d0_yz, c8, STEWART_FMA(A_z_own,
        I_d0_yz, STEWART_FMA(c9, I_d0_xx + c16, STEWART_FMA(A_y_own, I_d0_yy, STEWART_FMA(I_d0_xy, c6,
        STEWART_FMA(-I_d0_xz, c11, I_d0_xz*c2)))))));
    const stewart_real E_d_z = STEWART_FMA(A_x, I_d0_xz, STEWART_FMA(A_z_own, I_d0_zz, STEWART_FMA(I_d0_yz,
        c10, STEWART_FMA(-I_d0_xz, c6, STEWART_FMA(c7, I_d0_yy - I_d0_xx - I_d0_zz, STEWART_FMA(A_y_own,
        I_d0_yz, STEWART_FMA(-I_d0_xy, c1, I_d0_xy*c11)))))));
    const stewart_real c17 = STEWART_FMA(-N_d_y, r_d0_z, STEWART_FMA(N_d_z, r_d0_y, C_u*W_x));
    const stewart_real c18 = STEWART_FMA(-N_d_z, r_d0_x, STEWART_FMA(N_d_x, r_d0_z, C_u*W_y));
    const stewart_real c19 = STEWART_FMA(N_d_y, r_d0_x, STEWART_FMA(-N_d_x, r_d0_y, C_u*W_z));
    /* (20) moment that the joint forces must balance */
    const stewart_real C_x = STEWART_FMA(-N_u_y, r_u0_z, STEWART_FMA(N_u_z, r_u0_y, f_leg_x + E_x)) + c17;
    const stewart_real C_y = STEWART_FMA(-N_u_z, r_u_x, STEWART_FMA(N_u_x, r_u0_z, f_leg_y + E_y)) + c18;
    const stewart_real C_z = STEWART_FMA(N_u_y, r_u_x, STEWART_FMA(-N_u_x, r_u0_y, f_leg_z + E_z)) + c19;
    const stewart_real c20 = C_x*kappa;
    const stewart_real c21 = C_z + c20;
    const stewart_real c22 = C_y*inv_L;
    /* (21) transverse force at the spherical joint, leg frame */
    const stewart_real K_leg_y = c21*inv_L;
    const stewart_real K_leg_z = -c22;
    const stewart_real c23 = N_u_x - x;
    const stewart_real c24 = STEWART_FMA(-c21, inv_L, N_u_y);
    const stewart_real c25 = N_u_z + c22;
    /* F_u, leg frame */
    const stewart_real F_u_leg_x = N_d_x + c23;
    const stewart_real F_u_leg_y = N_d_y + c24;
    const stewart_real F_u_leg_z = N_d_z + c25;
    /* F_p, leg frame */
    const stewart_real F_p_leg_x = STEWART_FMA(C_p, u_x, c23);
    const stewart_real F_p_leg_y = c24;
    const stewart_real F_p_leg_z = c25;
    /* F_c, leg frame */
    const stewart_real F_c_leg_y = c24;
    const stewart_real F_c_leg_z = c25;
    /* M_p, leg frame */
    const stewart_real M_p_leg_x = C_x - E_d_x - c17;
    const stewart_real M_p_leg_y = STEWART_FMA(C_y*bearing, inv_L, STEWART_FMA(N_u_z, bearing, -E_d_y) - c18);
    const stewart_real M_p_leg_z = STEWART_FMA(-N_u_y, bearing, STEWART_FMA(inv_L, STEWART_FMA(bearing, c20,
        C_z*bearing), -E_d_z)) - c19 - c20;
    out->F_s[0] = STEWART_FMA(s_x, x, STEWART_FMA(K_leg_z, z_x, K_leg_y*y_x));
    out->F_s[1] = STEWART_FMA(s_y, x, STEWART_FMA(K_leg_z, z_y, K_leg_y*y_y));
    out->F_s[2] = STEWART_FMA(s_z, x, STEWART_FMA(K_leg_z, z_z, K_leg_y*y_z));
    out->F_u[0] = STEWART_FMA(F_u_leg_z, z_x, STEWART_FMA(F_u_leg_y, y_x, F_u_leg_x*s_x));
    out->F_u[1] = STEWART_FMA(F_u_leg_z, z_y, STEWART_FMA(F_u_leg_y, y_y, F_u_leg_x*s_y));
    out->F_u[2] = STEWART_FMA(F_u_leg_z, z_z, STEWART_FMA(F_u_leg_y, y_z, F_u_leg_x*s_z));
    out->F_p[0] = STEWART_FMA(F_p_leg_z, z_x, STEWART_FMA(F_p_leg_y, y_x, F_p_leg_x*s_x));
    out->F_p[1] = STEWART_FMA(F_p_leg_z, z_y, STEWART_FMA(F_p_leg_y, y_y, F_p_leg_x*s_y));
    out->F_p[2] = STEWART_FMA(F_p_leg_z, z_z, STEWART_FMA(F_p_leg_y, y_z, F_p_leg_x*s_z));
    out->F_c[0] = STEWART_FMA(F_c_leg_z, z_x, F_c_leg_y*y_x);
    out->F_c[1] = STEWART_FMA(F_c_leg_z, z_y, F_c_leg_y*y_y);
    out->F_c[2] = STEWART_FMA(F_c_leg_z, z_z, F_c_leg_y*y_z);
    out->M_p[0] = STEWART_FMA(M_p_leg_z, z_x, STEWART_FMA(M_p_leg_y, y_x, M_p_leg_x*s_x));
    out->M_p[1] = STEWART_FMA(M_p_leg_z, z_y, STEWART_FMA(M_p_leg_y, y_y, M_p_leg_x*s_y));
    out->M_p[2] = STEWART_FMA(M_p_leg_z, z_z, STEWART_FMA(M_p_leg_y, y_z, M_p_leg_x*s_z));
    out->M_u = -C_x*inv_k3;
}

/* Computes the inverse dynamics of one pose, (1)-(37). */
static int pose_forces(const stewart_robot *robot, const stewart_motions *at, stewart_forces *out)
{
    int i, j;
    leg_terms terms;
    platform_terms own;
    stewart_real A[6][7];
    stewart_real arm[6][3];
    stewart_real reach[6];
    stewart_real L[6];
    stewart_real extent = REAL(0);
    int close = 0;
    platform_wrench(robot, at, &own);
    for (j = 0; j < 3; ++j) {
        out->c[j] = own.c_force[j];
        out->c[j + 3] = own.c_moment[j];
    }
    for (i = 0; i < 6; ++i) {
        leg_dynamics(robot, &robot->leg[i], at, &terms);
        reach[i] = largest_component(terms.q, REAL(0));
        extent = STEWART_LARGER(reach[i], extent);
        reach[i] = largest_component(robot->leg[i].b, largest_component(at->t, reach[i]));
        L[i] = terms.L;
        const int status = status_of_leg(terms.L, terms.k3, reach[i]);
        if (status != STEWART_OK) {
            return status;
        }
        close = L[i] > STEWART_SHORT_SHARE*reach[i] ? close : 1;
        out->D[i] = terms.D;
        for (j = 0; j < 3; ++j) {
            arm[i][j] = terms.q[j];
            out->K[i][j] = terms.K[j];
            out->H[j][i] = terms.H_force[j];
            out->H[j + 3][i] = terms.H_moment[j];
            out->c[j] = out->c[j] + terms.c_force[j];
            out->c[j + 3] = out->c[j + 3] + terms.c_moment[j];
        }
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            A[i][j] = out->H[i][j];
        }
        A[i][6] = out->c[i];
    }
    const stewart_real per_length = per_length_of(extent, REAL(0.0625));
    if (per_length != REAL(1)) {
        for (i = 0; i < 7; ++i) {
            A[3][i] = A[3][i]*per_length;
            A[4][i] = A[4][i]*per_length;
            A[5][i] = A[5][i]*per_length;
        }
    }
    const int suspect = eliminate(A, out->x);
    if (close != 0 || suspect != 0) {
        stewart_real H[6][6];
        for (i = 0; i < 6; ++i) {
            for (j = 0; j < 6; ++j) {
                H[i][j] = out->H[i][j];
            }
        }
        const int status = singular_status(H, arm, L, reach, REAL(0));
        if (status != STEWART_OK) {
            return status;
        }
    }
    for (i = 0; i < 6; ++i) {
        out->F[i] = out->D[i] - out->x[i];
    }
    return is_finite(out->F, 6) != 0 ? STEWART_OK : STEWART_NOT_FINITE;
}

/* Computes the joint reactions of one pose from its axial forces, (21), (26)-(29), (17). Returns a
 * status. */
static int pose_reactions(
    const stewart_robot *robot, const stewart_motions *at, const stewart_real *bearing,
    const stewart_real x[6], stewart_reactions *out)
{
    int i, j;
    reaction_terms terms;
    for (i = 0; i < 6; ++i) {
        leg_reactions(robot, &robot->leg[i], at, x[i], bearing != NULL ? bearing[i] : REAL(0), &terms);
        for (j = 0; j < 3; ++j) {
            out->F_s[i][j] = terms.F_s[j];
            out->F_u[i][j] = terms.F_u[j];
            out->F_p[i][j] = terms.F_p[j];
            out->F_c[i][j] = terms.F_c[j];
            out->M_p[i][j] = terms.M_p[j];
        }
        out->M_u[i] = terms.M_u;
    }
    return is_finite((const stewart_real *)out, 96) != 0 ? STEWART_OK : STEWART_NOT_FINITE;
}

int stewart_exact_inverse_dynamics(
    const stewart_robot *robot, const stewart_motion *motion, stewart_forces *forces)
{
    stewart_forces result;
    if (robot == NULL || motion == NULL || forces == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    const stewart_motions at = motion_as_arrays(motion);
    const int status = pose_forces(robot, &at, &result);
    if (status == STEWART_OK) {
        *forces = result;
    }
    return status;
}

int stewart_exact_joint_reactions(
    const stewart_robot *robot, const stewart_motion *motion, const stewart_real bearing[6],
    stewart_forces *forces, stewart_reactions *reactions)
{
    stewart_forces result;
    stewart_reactions found;
    if (robot == NULL || motion == NULL || forces == NULL || reactions == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    const stewart_motions at = motion_as_arrays(motion);
    int status = pose_forces(robot, &at, &result);
    if (status == STEWART_OK) {
        status = pose_reactions(robot, &at, bearing, result.x, &found);
    }
    if (status == STEWART_OK) {
        *forces = result;
        *reactions = found;
    }
    return status;
}

int stewart_exact_inverse_dynamics_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions,
    const stewart_forces_arrays *forces, int *status)
{
    size_t pose;
    stewart_real zeros[3] = {0, 0, 0};
    stewart_forces found;
    if (robot == NULL || motions == NULL || forces == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL || motions->alpha == NULL || motions->a == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    int result = STEWART_OK;
    for (pose = 0; pose < count; ++pose) {
        const stewart_motions at = pose_at(motions, pose, zeros);
        const int code = pose_forces(robot, &at, &found);
        if (code == STEWART_OK) {
            copy(forces->F, pose, found.F, 6U);
            copy(forces->D, pose, found.D, 6U);
            copy(forces->x, pose, found.x, 6U);
            copy(forces->K, pose, &found.K[0][0], 18U);
            copy(forces->H, pose, &found.H[0][0], 36U);
            copy(forces->c, pose, found.c, 6U);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}

int stewart_exact_joint_reactions_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const stewart_real bearing[6],
    const stewart_reactions_arrays *reactions, int *status)
{
    size_t pose;
    stewart_real zeros[3] = {0, 0, 0};
    stewart_forces forces;
    stewart_reactions found;
    if (robot == NULL || motions == NULL || reactions == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL || motions->alpha == NULL || motions->a == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    int result = STEWART_OK;
    for (pose = 0; pose < count; ++pose) {
        const stewart_motions at = pose_at(motions, pose, zeros);
        int code = pose_forces(robot, &at, &forces);
        if (code == STEWART_OK) {
            code = pose_reactions(robot, &at, bearing, forces.x, &found);
        }
        if (code == STEWART_OK) {
            copy(reactions->F_s, pose, &found.F_s[0][0], 18U);
            copy(reactions->F_u, pose, &found.F_u[0][0], 18U);
            copy(reactions->F_p, pose, &found.F_p[0][0], 18U);
            copy(reactions->F_c, pose, &found.F_c[0][0], 18U);
            copy(reactions->M_p, pose, &found.M_p[0][0], 18U);
            copy(reactions->M_u, pose, found.M_u, 6U);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}
