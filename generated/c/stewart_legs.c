/* stewart_legs.c: functions that are declared and described in stewart_legs.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_legs.h"

#include "stewart_arithmetic.h"

/* A leg. */
typedef struct {
    stewart_real L; /* m: length of the leg */
    stewart_real L_dot; /* m/s: rate of the leg's length, positive when it extends */
    stewart_real L_ddot; /* m/s^2: second derivative of the leg's length */
    stewart_real s[3]; /* 1: unit vector along the leg, base frame */
    stewart_real S[3]; /* m: vector from base point to platform point, base frame */
    stewart_real q[3]; /* m: platform point from the reference point, base frame */
} leg_motion;

/* Six legs of a pose. */
typedef struct {
    stewart_real L[6]; /* m: lengths, (2) */
    stewart_real L_dot[6]; /* m/s: rates, (5) */
    stewart_real L_ddot[6]; /* m/s^2: second rates, (8) */
    stewart_real s[6][3]; /* 1: unit vectors along the legs, base frame, (3) */
    stewart_real S[6][3]; /* m: leg vectors, base frame, (1) */
    int status; /* 0, or the code of an error */
} leg_motions;

/* Length of one leg with its first and second derivative, unit vector s, S, and q, (1)-(5), (7), (8): 90
 * (46 mul, 42 add, 1 div, 1 sqrt). */
static leg_motion motion_of(const stewart_leg *leg, const stewart_motions *motion)
{
    const stewart_real R_xx = motion->R[0], R_xy = motion->R[1], R_xz = motion->R[2], R_yx = motion->R[3],
        R_yy = motion->R[4], R_yz = motion->R[5], R_zx = motion->R[6], R_zy = motion->R[7], R_zz = motion->R[8];
    const stewart_real t_x = motion->t[0], t_y = motion->t[1], t_z = motion->t[2];
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    const stewart_real alpha_x = motion->alpha[0], alpha_y = motion->alpha[1], alpha_z = motion->alpha[2];
    const stewart_real a_x = motion->a[0], a_y = motion->a[1], a_z = motion->a[2];
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    /* (1) platform point from the reference point */
    const stewart_real q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z;
    const stewart_real q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z;
    const stewart_real q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z;
    /* (1) leg vector */
    const stewart_real S_x = t_x - b_x + q_x;
    const stewart_real S_y = t_y - b_y + q_y;
    const stewart_real S_z = t_z - b_z + q_z;
    /* (2) leg length */
    const stewart_real L = STEWART_SQRT(S_x*S_x + S_y*S_y + S_z*S_z);
    const stewart_real inv_L = REAL(1)/L;
    /* (3) unit vector along the leg */
    const stewart_real s_x = S_x*inv_L;
    const stewart_real s_y = S_y*inv_L;
    const stewart_real s_z = S_z*inv_L;
    /* (4) omega x q */
    const stewart_real w_q_x = omega_y*q_z - omega_z*q_y;
    const stewart_real w_q_y = omega_z*q_x - omega_x*q_z;
    const stewart_real w_q_z = omega_x*q_y - omega_y*q_x;
    /* (4) velocity of the platform point */
    const stewart_real S_dot_x = v_x + w_q_x;
    const stewart_real S_dot_y = v_y + w_q_y;
    const stewart_real S_dot_z = v_z + w_q_z;
    /* (7) acceleration of the platform point */
    const stewart_real S_ddot_x = a_x + alpha_y*q_z - alpha_z*q_y + omega_y*w_q_z - omega_z*w_q_y;
    const stewart_real S_ddot_y = a_y + alpha_z*q_x - alpha_x*q_z + omega_z*w_q_x - omega_x*w_q_z;
    const stewart_real S_ddot_z = a_z + alpha_x*q_y - alpha_y*q_x + omega_x*w_q_y - omega_y*w_q_x;
    /* (5) sliding velocity */
    const stewart_real rate = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z;
    /* transverse part of S_dot */
    const stewart_real across_x = S_dot_x - rate*s_x;
    const stewart_real across_y = S_dot_y - rate*s_y;
    const stewart_real across_z = S_dot_z - rate*s_z;
    /* (8) */
    const stewart_real second = inv_L*(across_x*across_x + across_y*across_y + across_z*across_z) + S_ddot_x*s_x
        + S_ddot_y*s_y + S_ddot_z*s_z;
    leg_motion out;
    out.L = L;
    out.L_dot = rate;
    out.L_ddot = second;
    out.s[0] = s_x;
    out.s[1] = s_y;
    out.s[2] = s_z;
    out.S[0] = S_x;
    out.S[1] = S_y;
    out.S[2] = S_z;
    out.q[0] = q_x;
    out.q[1] = q_y;
    out.q[2] = q_z;
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
    if (!(L > STEWART_ROUNDING*reach && L > STEWART_SHORTEST)) {
        return STEWART_ZERO_LENGTH;
    }
    if (!(k3 > STEWART_JOINT_SINGULAR_SINE)) {
        return STEWART_JOINT_SINGULAR;
    }
    return STEWART_OK;
}

/* Lengths of the legs, their rates and second rates, their directions and vectors, and a status. */
static leg_motions motions_of(const stewart_robot *robot, const stewart_motions *motion)
{
    int i, j;
    leg_motions out = {{0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}, {{0, 0, 0}, {0, 0, 0},
        {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0},
        {0, 0, 0}}, 0};
    int status = STEWART_OK;
    for (i = 0; i < 6; ++i) {
        const leg_motion leg = motion_of(&robot->leg[i], motion);
        int fault = fault_of(leg.L, REAL(1), reach_of(robot->leg[i].b, motion->t, leg.q));
        fault = (fault != STEWART_OK || STEWART_FABS(leg.L_dot) <= STEWART_MAX) ? fault : STEWART_NOT_FINITE;
        fault = (fault != STEWART_OK || STEWART_FABS(leg.L_ddot) <= STEWART_MAX) ? fault : STEWART_NOT_FINITE;
        status = status == STEWART_OK ? fault : status;
        out.L[i] = leg.L;
        out.L_dot[i] = leg.L_dot;
        out.L_ddot[i] = leg.L_ddot;
        for (j = 0; j < 3; ++j) {
            out.s[i][j] = leg.s[j];
            out.S[i][j] = leg.S[j];
        }
    }
    out.status = status;
    return out;
}

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

/* Returns one pose of a batch, with zeros for optional arrays that are null. */
static stewart_motions pose_at(const stewart_motions *motions, size_t pose, const stewart_real zeros[3])
{
    stewart_motions at;
    at.R = &motions->R[9U*pose];
    at.t = &motions->t[3U*pose];
    at.omega = &motions->omega[3U*pose];
    at.v = &motions->v[3U*pose];
    at.alpha = motions->alpha != NULL ? &motions->alpha[3U*pose] : zeros;
    at.a = motions->a != NULL ? &motions->a[3U*pose] : zeros;
    at.F_ext = motions->F_ext;
    at.M_ext = motions->M_ext;
    return at;
}

int stewart_legs_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions,
    const stewart_legs_arrays *legs, int *status)
{
    size_t pose;
    stewart_real zeros[3] = {0, 0, 0};
    if (robot == NULL || motions == NULL || legs == NULL || motions->R == NULL || motions->t == NULL || motions->omega == NULL
        || motions->v == NULL || (legs->L_ddot != NULL && (motions->alpha == NULL || motions->a == NULL))) {
        return STEWART_BAD_ARGUMENT;
    }
    int result = STEWART_OK;
    for (pose = 0; pose < count; ++pose) {
        const stewart_motions at = pose_at(motions, pose, zeros);
        const leg_motions found = motions_of(robot, &at);
        const int code = found.status;
        if (code == STEWART_OK) {
            copy(legs->L, pose, found.L, 6U);
            copy(legs->L_dot, pose, found.L_dot, 6U);
            copy(legs->L_ddot, pose, found.L_ddot, 6U);
            copy(legs->s, pose, &found.s[0][0], 18U);
            copy(legs->S, pose, &found.S[0][0], 18U);
        }
        if (status != NULL) {
            status[pose] = code;
        }
        result = result == STEWART_OK ? code : result;
    }
    return result;
}
