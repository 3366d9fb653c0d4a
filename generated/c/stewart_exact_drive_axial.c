/* stewart_exact_drive_axial.c: functions that are declared and described in stewart_exact_drive_axial.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_exact_drive_axial.h"

#include "stewart_arithmetic.h"

/* A leg. */
typedef struct {
    stewart_real q[3]; /* m: platform point from the reference point, base frame */
    stewart_real L; /* m: length of the leg */
    stewart_real k3; /* 1: |k x s|, sine of the angle between the leg and the fixed axis */
    stewart_real L_dot; /* m/s: rate of the leg's length, positive when it extends */
    stewart_real F_rotor; /* N: part of the actuator force that accelerates the leg's rotor */
} rotor_terms;

/* Axial forces of six legs. */
typedef struct {
    stewart_real axial[6]; /* N: forces between the parts of the legs */
    stewart_real L_dot[6]; /* m/s: rates of the lengths, (5) */
    int status; /* 0, or the code of an error */
} axial_loads;

/* Length rate of one leg and the force that accelerates its rotor, (5), (8), (9): 157 (92 mul, 61 add, 2
 * div, 2 sqrt). */
static rotor_terms axial_terms(const stewart_leg *leg, const stewart_motion *motion)
{
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    const stewart_real k_x = leg->k[0], k_y = leg->k[1], k_z = leg->k[2];
    const stewart_real m_r = leg->m_r;
    const stewart_real j_r = leg->j_r;
    const stewart_real R_xx = motion->R[0], R_xy = motion->R[1], R_xz = motion->R[2], R_yx = motion->R[3],
        R_yy = motion->R[4], R_yz = motion->R[5], R_zx = motion->R[6], R_zy = motion->R[7], R_zz = motion->R[8];
    const stewart_real t_x = motion->t[0], t_y = motion->t[1], t_z = motion->t[2];
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    const stewart_real alpha_x = motion->alpha[0], alpha_y = motion->alpha[1], alpha_z = motion->alpha[2];
    const stewart_real a_x = motion->a[0], a_y = motion->a[1], a_z = motion->a[2];
    /* (1) platform point from the reference point */
    const stewart_real q_x = (R_xx*p_x) + (R_xy*p_y) + (R_xz*p_z);
    const stewart_real q_y = (R_yx*p_x) + (R_yy*p_y) + (R_yz*p_z);
    const stewart_real q_z = (R_zx*p_x) + (R_zy*p_y) + (R_zz*p_z);
    /* (1) leg vector */
    const stewart_real S_x = (t_x - b_x) + q_x;
    const stewart_real S_y = (t_y - b_y) + q_y;
    const stewart_real S_z = (t_z - b_z) + q_z;
    /* (2) leg length */
    const stewart_real L = STEWART_SQRT((S_x*S_x) + (S_y*S_y) + (S_z*S_z));
    const stewart_real inv_L = REAL(1)/L;
    /* (3) unit vector along the leg */
    const stewart_real s_x = S_x*inv_L;
    const stewart_real s_y = S_y*inv_L;
    const stewart_real s_z = S_z*inv_L;
    /* (4) omega x q */
    const stewart_real w_q_x = (omega_y*q_z) - (omega_z*q_y);
    const stewart_real w_q_y = (omega_z*q_x) - (omega_x*q_z);
    const stewart_real w_q_z = (omega_x*q_y) - (omega_y*q_x);
    /* (4) velocity of the platform point */
    const stewart_real S_dot_x = v_x + w_q_x;
    const stewart_real S_dot_y = v_y + w_q_y;
    const stewart_real S_dot_z = v_z + w_q_z;
    /* (7) acceleration of the platform point */
    const stewart_real S_ddot_x = (((a_x + (alpha_y*q_z)) - (alpha_z*q_y)) + (omega_y*w_q_z)) - (omega_z*w_q_y);
    const stewart_real S_ddot_y = (((a_y + (alpha_z*q_x)) - (alpha_x*q_z)) + (omega_z*w_q_x)) - (omega_x*w_q_z);
    const stewart_real S_ddot_z = (((a_z + (alpha_x*q_y)) - (alpha_y*q_x)) + (omega_x*w_q_y)) - (omega_y*w_q_x);
    /* (10) normal to the fixed axis and the leg */
    const stewart_real k_cross_s_x = (k_y*s_z) - (k_z*s_y);
    const stewart_real k_cross_s_y = (k_z*s_x) - (k_x*s_z);
    const stewart_real k_cross_s_z = (k_x*s_y) - (k_y*s_x);
    /* (10) along the third axis of the leg */
    const stewart_real s_cross_normal_x = (k_cross_s_z*s_y) - (k_cross_s_y*s_z);
    const stewart_real s_cross_normal_y = (k_cross_s_x*s_z) - (k_cross_s_z*s_x);
    const stewart_real s_cross_normal_z = (k_cross_s_y*s_x) - (k_cross_s_x*s_y);
    /* (10) k = (k1, 0, k3) in the leg frame */
    const stewart_real k3 = STEWART_SQRT((s_cross_normal_x*s_cross_normal_x) + (s_cross_normal_y*s_cross_normal_y)
        + (s_cross_normal_z*s_cross_normal_z));
    const stewart_real inv_k3 = REAL(1)/k3;
    /* (10) third axis of the leg frame */
    const stewart_real z_x = inv_k3*s_cross_normal_x;
    const stewart_real z_y = inv_k3*s_cross_normal_y;
    const stewart_real z_z = inv_k3*s_cross_normal_z;
    /* (10) rotating axis of the universal joint */
    const stewart_real y_x = (s_z*z_y) - (s_y*z_z);
    const stewart_real y_y = (s_x*z_z) - (s_z*z_x);
    const stewart_real y_z = (s_y*z_x) - (s_x*z_y);
    /* (10) k = (k1, 0, k3) in the leg frame */
    const stewart_real k1 = (k_x*s_x) + (k_y*s_y) + (k_z*s_z);
    /* spin of the leg about s per rotation about z */
    const stewart_real kappa = inv_k3*k1;
    /* (4), (5) velocity of the platform point, leg frame */
    const stewart_real u_x = (S_dot_x*s_x) + (S_dot_y*s_y) + (S_dot_z*s_z);
    const stewart_real u_y = (S_dot_x*y_x) + (S_dot_y*y_y) + (S_dot_z*y_z);
    const stewart_real u_z = (S_dot_x*z_x) + (S_dot_y*z_y) + (S_dot_z*z_z);
    /* (7) acceleration of the platform point, leg frame */
    const stewart_real e_x = (S_ddot_x*s_x) + (S_ddot_y*s_y) + (S_ddot_z*s_z);
    const stewart_real e_y = (S_ddot_x*y_x) + (S_ddot_y*y_y) + (S_ddot_z*y_z);
    /* (6) angular velocity of the leg, leg frame */
    const stewart_real W_z = inv_L*u_y;
    const stewart_real W_y = -inv_L*u_z;
    const stewart_real W_x = W_z*kappa;
    /* (8) sliding acceleration */
    const stewart_real L_ddot = (L*W_y*W_y) + (L*W_z*W_z) + e_x;
    /* (9) angular acceleration of the leg without the spin terms, leg frame */
    const stewart_real A_z_own = inv_L*(e_y - (REAL(2)*W_z*u_x));
    /* (9) angular acceleration of the leg, leg frame */
    const stewart_real A_x = (kappa*(A_z_own - (REAL(2)*W_x*W_y))) - (W_y*W_z);
    rotor_terms out;
    out.q[0] = q_x;
    out.q[1] = q_y;
    out.q[2] = q_z;
    out.L = L;
    out.k3 = k3;
    out.L_dot = u_x;
    out.F_rotor = (A_x*j_r) + (L_ddot*m_r);
    return out;
}

/* Returns the largest of ``least`` and the magnitudes of a vector's components. */
static stewart_real largest_component(const stewart_real vector[3], stewart_real least)
{
    int j;
    stewart_real most = least;
    for (j = 0; j < 3; ++j) {
        most = STEWART_LARGER(STEWART_FABS(vector[j]), most);
    }
    return most;
}

/* Returns the largest component (m) of the vectors q, t, and b, whose sum is a leg. */
static stewart_real reach_of(const stewart_real b[3], const stewart_real t[3], const stewart_real q[3])
{
    return largest_component(b, largest_component(t, largest_component(q, REAL(0))));
}

/* Returns the status of a leg: not finite, short compared with the vectors in its sum, along k, or OK. */
static int fault_of(stewart_real L, stewart_real k3, stewart_real reach)
{
    if (!(L <= STEWART_MAX)) {
        return STEWART_NOT_FINITE;
    }
    if (!((L > (STEWART_ROUNDING*reach)) && (L > STEWART_SHORTEST))) {
        return STEWART_ZERO_LENGTH;
    }
    if (!(k3 > STEWART_JOINT_SINGULAR_SINE)) {
        return STEWART_JOINT_SINGULAR;
    }
    return STEWART_OK;
}

/* Actuator forces minus the forces that accelerate the rotors, rates of the legs, and a status. */
static axial_loads axial_forces(
    const stewart_robot *robot, const stewart_motion *motion, const stewart_real F[6])
{
    int i;
    axial_loads out = {{0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}, 0};
    int status = STEWART_OK;
    for (i = 0; i < 6; ++i) {
        rotor_terms leg;
        leg = axial_terms(&robot->leg[i], motion);
        int fault = fault_of(leg.L, leg.k3, reach_of(robot->leg[i].b, motion->t, leg.q));
        out.axial[i] = F[i] - leg.F_rotor;
        out.L_dot[i] = leg.L_dot;
        fault = ((fault != STEWART_OK) || (STEWART_FABS(out.axial[i]) <= STEWART_MAX)) ? fault : STEWART_NOT_FINITE;
        fault = ((fault != STEWART_OK) || (STEWART_FABS(out.L_dot[i]) <= STEWART_MAX)) ? fault : STEWART_NOT_FINITE;
        status = (status == STEWART_OK) ? fault : status;
    }
    out.status = status;
    return out;
}

int stewart_exact_drive_axial_forces(
    const stewart_robot *robot, const stewart_motion *motion, const stewart_real F[6], stewart_real axial[6],
    stewart_real L_dot[6])
{
    int status = STEWART_BAD_ARGUMENT;
    int i;
    if ((robot != NULL) && (motion != NULL) && (F != NULL) && (axial != NULL)) {
        axial_loads found;
        found = axial_forces(robot, motion, F);
        status = found.status;
        for (i = 0; (i < 6) && (status == STEWART_OK); ++i) {
            axial[i] = found.axial[i];
            if (L_dot != NULL) {
                L_dot[i] = found.L_dot[i];
            }
        }
    }
    return status;
}
