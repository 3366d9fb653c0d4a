/* stewart_paper_spherical.c: functions that are declared and described in stewart_paper_spherical.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_paper_spherical.h"

#include "stewart_outputs.h"

typedef struct {
    stewart_real q[3]; /* m: platform point from the reference point, base frame */
    stewart_real L; /* m: length of the leg */
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

/* One leg: D, K, its column of H and its part of c, (1)-(24), (35). Operations: 249 (144 mul, 103 add, 1
 * div, 1 sqrt). */
static void leg_dynamics(
    const stewart_robot *robot, const stewart_leg *leg, const stewart_motions *at, leg_terms *out)
{
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real m_d = leg->m_d;
    const stewart_real r_d0_x = leg->r_d0[0];
    const stewart_real I_d0_yy = leg->I_d0[3];
    const stewart_real m_u = leg->m_u;
    const stewart_real r_u0_x = leg->r_u0[0];
    const stewart_real I_u0_yy = leg->I_u0[3];
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
    const stewart_real u_square = STEWART_FMA(u_across_z, u_across_z, STEWART_FMA(u_across_y, u_across_y,
        u_across_x*u_across_x));
    const stewart_real c4 = inv_L*inv_L;
    const stewart_real c5 = m_u*r_u0_x;
    /* (24) known part of the actuator force */
    const stewart_real D = STEWART_FMA(e_x, m_u, STEWART_FMA(-gamma_x, m_u, STEWART_FMA((-c4)*c5, u_square,
        C_p*u_x)));
    const stewart_real c6 = m_d*r_d0_x*r_d0_x;
    const stewart_real c7 = m_u*r_u0_x*r_u0_x;
    const stewart_real c8 = L*m_u;
    const stewart_real c9 = m_u*L*L;
    const stewart_real K_e = c4*STEWART_FMA(REAL(2)*c8, r_u0_x, STEWART_FMA(REAL(2), c9, I_d0_yy + I_u0_yy + c6
        + c7));
    const stewart_real c10 = REAL(2)*inv_L*u_x;
    const stewart_real c11 = REAL(4)*inv_L*u_x;
    const stewart_real K_u = c4*STEWART_FMA((-c11)*c8, r_u0_x, STEWART_FMA(-c11, c9, STEWART_FMA(-c10, c7,
        STEWART_FMA(-c10, c6, STEWART_FMA(-I_u0_yy, c10, STEWART_FMA(-I_d0_yy, c10,
        STEWART_FMA(REAL(2)*m_u*r_u0_x, u_x, STEWART_FMA(REAL(2)*L*m_u, u_x, C_s + C_u))))))));
    const stewart_real K_gamma = -inv_L*(STEWART_FMA(m_d, r_d0_x, c5) + c8);
    const stewart_real c12 = C_s*inv_L;
    const stewart_real K_s_w = c12;
    /* K, base frame */
    const stewart_real K_x = STEWART_FMA(K_u, u_across_x, STEWART_FMA(K_e, e_across_x, STEWART_FMA(K_s_w,
        STEWART_FMA(-s_z, w_across_y, s_y*w_across_z), K_gamma*gamma_across_x)));
    const stewart_real K_y = STEWART_FMA(K_u, u_across_y, STEWART_FMA(K_e, e_across_y, STEWART_FMA(K_s_w,
        STEWART_FMA(-s_x, w_across_z, s_z*w_across_x), K_gamma*gamma_across_y)));
    const stewart_real K_z = STEWART_FMA(K_u, u_across_z, STEWART_FMA(K_e, e_across_z, STEWART_FMA(K_s_w,
        STEWART_FMA(-s_y, w_across_x, s_x*w_across_y), K_gamma*gamma_across_z)));
    const stewart_real f_s_u = c12;
    /* f, base frame */
    const stewart_real f_x = STEWART_FMA(-C_s, w_across_x, STEWART_FMA(-C_s, c1, f_s_u*STEWART_FMA(-s_z,
        u_across_y, s_y*u_across_z)));
    const stewart_real f_y = STEWART_FMA(-C_s, w_across_y, STEWART_FMA(-C_s, c2, f_s_u*STEWART_FMA(-s_x,
        u_across_z, s_z*u_across_x)));
    const stewart_real f_z = STEWART_FMA(-C_s, w_across_z, STEWART_FMA(-C_s, c3, f_s_u*STEWART_FMA(-s_y,
        u_across_x, s_x*u_across_y)));
    out->q[0] = q_x;
    out->q[1] = q_y;
    out->q[2] = q_z;
    out->L = L;
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

/* One leg: joint reactions, (21), (26)-(29), (17). Operations: 462 (269 mul, 191 add, 1 div, 1 sqrt). */
static void leg_reactions(
    const stewart_robot *robot, const stewart_leg *leg, const stewart_motions *at, stewart_real x,
    stewart_real bearing, reaction_terms *out)
{
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real m_d = leg->m_d;
    const stewart_real r_d0_x = leg->r_d0[0];
    const stewart_real I_d0_yy = leg->I_d0[3];
    const stewart_real m_u = leg->m_u;
    const stewart_real r_u0_x = leg->r_u0[0];
    const stewart_real I_u0_yy = leg->I_u0[3];
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
    /* part of w across the leg */
    const stewart_real w_across_x = STEWART_FMA(-s_x, w_x, omega_x);
    const stewart_real w_across_y = STEWART_FMA(-s_y, w_x, omega_y);
    const stewart_real w_across_z = STEWART_FMA(-s_z, w_x, omega_z);
    /* square of u across the leg */
    const stewart_real u_square = STEWART_FMA(u_across_z, u_across_z, STEWART_FMA(u_across_y, u_across_y,
        u_across_x*u_across_x));
    const stewart_real c1 = inv_L*inv_L;
    const stewart_real c2 = m_d*r_d0_x*r_d0_x;
    const stewart_real c3 = m_u*r_u0_x*r_u0_x;
    const stewart_real c4 = L*m_u;
    const stewart_real c5 = L*L;
    const stewart_real c6 = REAL(2)*m_u;
    const stewart_real c7 = c5*c6;
    const stewart_real F_s_e = c1*STEWART_FMA(REAL(2)*c4, r_u0_x, I_d0_yy + I_u0_yy + c2 + c3 + c7);
    const stewart_real c9 = REAL(2)*u_x;
    const stewart_real c8 = I_d0_yy*inv_L;
    const stewart_real c10 = c8*c9;
    const stewart_real c11 = I_u0_yy*inv_L;
    const stewart_real c12 = REAL(4)*u_x;
    const stewart_real c13 = c4*inv_L;
    const stewart_real c14 = c13*r_u0_x;
    const stewart_real c15 = c5*inv_L;
    const stewart_real c16 = c12*m_u;
    const stewart_real c17 = c2*inv_L;
    const stewart_real c18 = c17*c9;
    const stewart_real c19 = c3*inv_L;
    const stewart_real F_s_u = c1*STEWART_FMA(-c15, c16, STEWART_FMA(-c19, c9, STEWART_FMA(-c12, c14,
        STEWART_FMA(-c11, c9, STEWART_FMA(REAL(2)*m_u*r_u0_x, u_x, STEWART_FMA(REAL(2)*L*m_u, u_x, C_s + C_u))
        - c10)) - c18));
    const stewart_real c20 = m_d*r_d0_x;
    const stewart_real c21 = m_u*r_u0_x;
    const stewart_real F_s_gamma = -inv_L*(c20 + c21 + c4);
    const stewart_real c22 = C_s*inv_L;
    const stewart_real F_s_s_w = c22;
    const stewart_real c23 = STEWART_FMA(-s_z, w_across_y, s_y*w_across_z);
    const stewart_real c24 = STEWART_FMA(-s_x, w_across_z, s_z*w_across_x);
    const stewart_real c25 = STEWART_FMA(-s_y, w_across_x, s_x*w_across_y);
    /* F_s, base frame */
    const stewart_real F_s_x = STEWART_FMA(F_s_u, u_across_x, STEWART_FMA(F_s_e, e_across_x,
        STEWART_FMA(F_s_s_w, c23, STEWART_FMA(F_s_gamma, gamma_across_x, s_x*x))));
    const stewart_real F_s_y = STEWART_FMA(F_s_u, u_across_y, STEWART_FMA(F_s_e, e_across_y,
        STEWART_FMA(F_s_s_w, c24, STEWART_FMA(F_s_gamma, gamma_across_y, s_y*x))));
    const stewart_real F_s_z = STEWART_FMA(F_s_u, u_across_z, STEWART_FMA(F_s_e, e_across_z,
        STEWART_FMA(F_s_s_w, c25, STEWART_FMA(F_s_gamma, gamma_across_z, s_z*x))));
    const stewart_real c27 = STEWART_FMA(REAL(2), c14, STEWART_FMA(c7, inv_L, c11 - c21 + c17 + c19) + c8 - c4);
    const stewart_real F_u_e = -inv_L*(c27 - c20);
    const stewart_real c29 = c1*c9;
    const stewart_real c30 = I_d0_yy*c29;
    const stewart_real c31 = I_u0_yy*c29;
    const stewart_real c32 = c1*c12*r_u0_x;
    const stewart_real c33 = c1*c5;
    const stewart_real c34 = c2*c29;
    const stewart_real c35 = c29*c3;
    const stewart_real c36 = STEWART_FMA((-REAL(4))*inv_L*m_u*r_u0_x, u_x,
        STEWART_FMA((-REAL(4))*L*inv_L*m_u, u_x, STEWART_FMA(c32, c4, STEWART_FMA(c16, c33,
        STEWART_FMA(-C_u, inv_L, c6*u_x) - c22) + c30 + c31 + c34 + c35)));
    const stewart_real F_u_u = -inv_L*STEWART_FMA(REAL(2)*inv_L*m_d*r_d0_x, u_x, -c36);
    const stewart_real c37 = c20*inv_L;
    const stewart_real c38 = c21*inv_L;
    const stewart_real c39 = c37 - m_u + c38 + c13;
    const stewart_real F_u_gamma = c39 - m_d;
    const stewart_real F_u_s_w = -c22;
    const stewart_real c40 = c1*u_square;
    const stewart_real c41 = STEWART_FMA(-e_x, m_u, STEWART_FMA(gamma_x, m_u, STEWART_FMA(c21, c40, x)));
    const stewart_real c42 = STEWART_FMA(-gamma_x, m_d, -c20*c40) - c41;
    /* F_u, base frame */
    const stewart_real F_u_x = STEWART_FMA(F_u_u, u_across_x, STEWART_FMA(c42, s_x, STEWART_FMA(F_u_e,
        e_across_x, STEWART_FMA(F_u_s_w, c23, F_u_gamma*gamma_across_x))));
    const stewart_real F_u_y = STEWART_FMA(F_u_u, u_across_y, STEWART_FMA(c42, s_y, STEWART_FMA(F_u_e,
        e_across_y, STEWART_FMA(F_u_s_w, c24, F_u_gamma*gamma_across_y))));
    const stewart_real F_u_z = STEWART_FMA(F_u_u, u_across_z, STEWART_FMA(c42, s_z, STEWART_FMA(F_u_e,
        e_across_z, STEWART_FMA(F_u_s_w, c25, F_u_gamma*gamma_across_z))));
    const stewart_real c43 = -c27*inv_L;
    const stewart_real F_p_e = c43;
    const stewart_real c44 = c36*inv_L;
    const stewart_real F_p_u = c44;
    const stewart_real F_p_gamma = c39;
    const stewart_real F_p_s_w = -c22;
    const stewart_real c45 = STEWART_FMA(C_p, u_x, -c41);
    /* F_p, base frame */
    const stewart_real F_p_x = STEWART_FMA(F_p_u, u_across_x, STEWART_FMA(c45, s_x, STEWART_FMA(F_p_e,
        e_across_x, STEWART_FMA(F_p_s_w, c23, F_p_gamma*gamma_across_x))));
    const stewart_real F_p_y = STEWART_FMA(F_p_u, u_across_y, STEWART_FMA(c45, s_y, STEWART_FMA(F_p_e,
        e_across_y, STEWART_FMA(F_p_s_w, c24, F_p_gamma*gamma_across_y))));
    const stewart_real F_p_z = STEWART_FMA(F_p_u, u_across_z, STEWART_FMA(c45, s_z, STEWART_FMA(F_p_e,
        e_across_z, STEWART_FMA(F_p_s_w, c25, F_p_gamma*gamma_across_z))));
    const stewart_real F_c_e = c43;
    const stewart_real F_c_u = c44;
    const stewart_real F_c_gamma = c39;
    const stewart_real F_c_s_w = -c22;
    /* F_c, base frame */
    const stewart_real F_c_x = STEWART_FMA(F_c_u, u_across_x, STEWART_FMA(F_c_e, e_across_x,
        STEWART_FMA(F_c_s_w, c23, F_c_gamma*gamma_across_x)));
    const stewart_real F_c_y = STEWART_FMA(F_c_u, u_across_y, STEWART_FMA(F_c_e, e_across_y,
        STEWART_FMA(F_c_s_w, c24, F_c_gamma*gamma_across_y)));
    const stewart_real F_c_z = STEWART_FMA(F_c_u, u_across_z, STEWART_FMA(F_c_e, e_across_z,
        STEWART_FMA(F_c_s_w, c25, F_c_gamma*gamma_across_z)));
    const stewart_real c46 = bearing*c4;
    const stewart_real c47 = bearing*c13;
    const stewart_real c48 = bearing*m_u;
    const stewart_real M_p_s_e = inv_L*STEWART_FMA(REAL(2)*c47, r_u0_x, STEWART_FMA(REAL(2)*c15, c48,
        STEWART_FMA(bearing, c8, STEWART_FMA(bearing, c19, STEWART_FMA(bearing, c17, STEWART_FMA(-bearing,
        c21, STEWART_FMA(bearing, c11, -I_d0_yy)) - c2)))) - c46);
    const stewart_real c49 = -bearing*c22;
    const stewart_real M_p_s_u = inv_L*STEWART_FMA(-c32, c46, STEWART_FMA(-bearing, c35,
        STEWART_FMA(-bearing, c34, STEWART_FMA(-bearing, c31, STEWART_FMA(-bearing, c30,
        STEWART_FMA(REAL(4)*bearing*inv_L*m_u*r_u0_x, u_x, STEWART_FMA(REAL(4)*L*bearing*inv_L*m_u, u_x,
        STEWART_FMA((-c12)*c33, c48, STEWART_FMA(-c48, c9, STEWART_FMA(C_u*bearing, inv_L, -C_u) - c49 + c10
        + c18)))))))));
    const stewart_real M_p_s_gamma = STEWART_FMA(-bearing, c38, STEWART_FMA(-bearing, c37,
        STEWART_FMA(bearing, m_u, c20))) - c47;
    const stewart_real M_p_w = c49;
    /* M_p, base frame */
    const stewart_real M_p_x = STEWART_FMA(M_p_s_u, STEWART_FMA(-s_z, u_across_y, s_y*u_across_z),
        STEWART_FMA(M_p_s_e, STEWART_FMA(-e_across_y, s_z, e_across_z*s_y), STEWART_FMA(M_p_s_gamma,
        STEWART_FMA(-gamma_across_y, s_z, gamma_across_z*s_y), M_p_w*w_across_x)));
    const stewart_real M_p_y = STEWART_FMA(M_p_s_u, STEWART_FMA(-s_x, u_across_z, s_z*u_across_x),
        STEWART_FMA(M_p_s_e, STEWART_FMA(-e_across_z, s_x, e_across_x*s_z), STEWART_FMA(M_p_s_gamma,
        STEWART_FMA(-gamma_across_z, s_x, gamma_across_x*s_z), M_p_w*w_across_y)));
    const stewart_real M_p_z = STEWART_FMA(M_p_s_u, STEWART_FMA(-s_y, u_across_x, s_x*u_across_y),
        STEWART_FMA(M_p_s_e, STEWART_FMA(-e_across_x, s_y, e_across_y*s_x), STEWART_FMA(M_p_s_gamma,
        STEWART_FMA(-gamma_across_x, s_y, gamma_across_y*s_x), M_p_w*w_across_z)));
    out->F_s[0] = F_s_x;
    out->F_s[1] = F_s_y;
    out->F_s[2] = F_s_z;
    out->F_u[0] = F_u_x;
    out->F_u[1] = F_u_y;
    out->F_u[2] = F_u_z;
    out->F_p[0] = F_p_x;
    out->F_p[1] = F_p_y;
    out->F_p[2] = F_p_z;
    out->F_c[0] = F_c_x;
    out->F_c[1] = F_c_y;
    out->F_c[2] = F_c_z;
    out->M_p[0] = M_p_x;
    out->M_p[1] = M_p_y;
    out->M_p[2] = M_p_z;
    out->M_u = REAL(0);
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
        const int status = status_of_leg(terms.L, REAL(1), reach[i]);
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

int stewart_paper_spherical_inverse_dynamics(
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

int stewart_paper_spherical_joint_reactions(
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

int stewart_paper_spherical_inverse_dynamics_batch(
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

int stewart_paper_spherical_joint_reactions_batch(
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
