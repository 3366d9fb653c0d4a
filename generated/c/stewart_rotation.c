/* stewart_rotation.c: functions that are declared and described in stewart_rotation.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_rotation.h"

#include "stewart_arithmetic.h"

/* An orientation and its rates. */
typedef struct {
    stewart_real R[9]; /* 1: orientation of the platform, platform frame to base frame */
    stewart_real omega[3]; /* rad/s: angular velocity of the platform, base frame */
    stewart_real alpha[3]; /* rad/s^2: angular acceleration of the platform, base frame */
} orientation;

/* Orientation, angular velocity, and angular acceleration from roll, pitch, and yaw, (38): 45 (29 mul,
 * 16 add, 0 div, 0 sqrt). */
static orientation turned_by_angles(
    const stewart_real sine[3], const stewart_real cosine[3], const stewart_real theta_dot[3],
    const stewart_real theta_ddot[3])
{
    const stewart_real sine_x = sine[0], sine_y = sine[1], sine_z = sine[2];
    const stewart_real cosine_x = cosine[0], cosine_y = cosine[1], cosine_z = cosine[2];
    const stewart_real theta_dot_x = theta_dot[0], theta_dot_y = theta_dot[1], theta_dot_z = theta_dot[2];
    const stewart_real theta_ddot_x = theta_ddot[0], theta_ddot_y = theta_ddot[1], theta_ddot_z = theta_ddot[2];
    const stewart_real c1 = cosine_y*cosine_z;
    const stewart_real c2 = cosine_y*sine_z;
    /* rate of theta_x about its axis */
    const stewart_real about_x_x = c1*theta_dot_x;
    const stewart_real about_x_y = c2*theta_dot_x;
    const stewart_real about_x_z = -sine_y*theta_dot_x;
    /* rate of theta_y about its axis */
    const stewart_real about_y_x = -sine_z*theta_dot_y;
    const stewart_real about_y_y = cosine_z*theta_dot_y;
    const stewart_real c3 = cosine_x*sine_z;
    const stewart_real c4 = sine_x*sine_z;
    const stewart_real c5 = cosine_x*cosine_z;
    const stewart_real c6 = about_x_x + about_y_x;
    const stewart_real c7 = about_y_y + about_x_y;
    orientation out;
    out.R[0] = c1;
    out.R[1] = (cosine_z*sine_x*sine_y) - c3;
    out.R[2] = c4 + (c5*sine_y);
    out.R[3] = c2;
    out.R[4] = c5 + (c4*sine_y);
    out.R[5] = (c3*sine_y) - (cosine_z*sine_x);
    out.R[6] = -sine_y;
    out.R[7] = cosine_y*sine_x;
    out.R[8] = cosine_x*cosine_y;
    out.omega[0] = c6;
    out.omega[1] = c7;
    out.omega[2] = about_x_z + theta_dot_z;
    out.alpha[0] = ((about_x_z*about_y_y) + (c1*theta_ddot_x)) - (c7*theta_dot_z) - (sine_z*theta_ddot_y);
    out.alpha[1] = ((c2*theta_ddot_x) + (c6*theta_dot_z) + (cosine_z*theta_ddot_y)) - (about_x_z*about_y_x);
    out.alpha[2] = (theta_ddot_z + (about_x_y*about_y_x)) - (about_x_x*about_y_y) - (sine_y*theta_ddot_x);
    return out;
}

/* Orientation, angular velocity, and angular acceleration from a quaternion and its derivatives: 107 (68
 * mul, 38 add, 1 div, 0 sqrt). */
static orientation turned_by_quaternion(
    const stewart_real e[4], const stewart_real e_dot[4], const stewart_real e_ddot[4])
{
    const stewart_real e_w = e[0], e_x = e[1], e_y = e[2], e_z = e[3];
    const stewart_real e_dot_w = e_dot[0], e_dot_x = e_dot[1], e_dot_y = e_dot[2], e_dot_z = e_dot[3];
    const stewart_real e_ddot_w = e_ddot[0], e_ddot_x = e_ddot[1], e_ddot_y = e_ddot[2], e_ddot_z = e_ddot[3];
    const stewart_real c1 = e_x*e_x;
    const stewart_real c2 = e_y*e_y;
    const stewart_real c3 = e_z*e_z;
    const stewart_real c4 = c2 + c3;
    /* 1 / |e|^2 */
    const stewart_real inv_square = REAL(1)/(c1 + (e_w*e_w) + c4);
    const stewart_real growth = inv_square*((e_dot_w*e_w) + (e_dot_x*e_x) + (e_dot_y*e_y) + (e_dot_z*e_z));
    /* half the angular velocity */
    const stewart_real half_omega_x = inv_square*(((e_dot_x*e_w) + (e_dot_z*e_y)) - (e_dot_w*e_x) - (e_dot_y*e_z));
    const stewart_real half_omega_y = inv_square*(((e_dot_x*e_z) + (e_dot_y*e_w)) - (e_dot_w*e_y) - (e_dot_z*e_x));
    const stewart_real half_omega_z = inv_square*(((e_dot_y*e_x) + (e_dot_z*e_w)) - (e_dot_w*e_z) - (e_dot_x*e_y));
    const stewart_real c5 = REAL(2)*inv_square;
    const stewart_real c6 = e_w*e_z;
    const stewart_real c7 = e_w*e_y;
    const stewart_real c8 = e_w*e_x;
    const stewart_real c9 = REAL(4)*growth;
    orientation out;
    out.R[0] = REAL(1) - (c4*c5);
    out.R[1] = c5*((e_x*e_y) - c6);
    out.R[2] = c5*(c7 + (e_x*e_z));
    out.R[3] = c5*(c6 + (e_x*e_y));
    out.R[4] = REAL(1) + (c5*(-c1 - c3));
    out.R[5] = c5*((e_y*e_z) - c8);
    out.R[6] = c5*((e_x*e_z) - c7);
    out.R[7] = c5*(c8 + (e_y*e_z));
    out.R[8] = REAL(1) + (c5*(-c1 - c2));
    out.omega[0] = REAL(2)*half_omega_x;
    out.omega[1] = REAL(2)*half_omega_y;
    out.omega[2] = REAL(2)*half_omega_z;
    out.alpha[0] = (REAL(2)*inv_square*(((e_ddot_x*e_w) + (e_ddot_z*e_y)) - (e_ddot_w*e_x) - (e_ddot_y*e_z)))
        - (c9*half_omega_x);
    out.alpha[1] = (REAL(2)*inv_square*(((e_ddot_x*e_z) + (e_ddot_y*e_w)) - (e_ddot_w*e_y) - (e_ddot_z*e_x)))
        - (c9*half_omega_y);
    out.alpha[2] = (REAL(2)*inv_square*(((e_ddot_y*e_x) + (e_ddot_z*e_w)) - (e_ddot_w*e_z) - (e_ddot_x*e_y)))
        - (c9*half_omega_z);
    return out;
}

/* NOT_FINITE where an orientation or its rates are not finite, else OK. */
static int orientation_status(const orientation *found)
{
    int i;
    int status = STEWART_OK;
    for (i = 0; i < 9; ++i) {
        status = (STEWART_FABS(found->R[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 3; ++i) {
        status = (STEWART_FABS(found->omega[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
        status = (STEWART_FABS(found->alpha[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    return status;
}

/* Copies the orientation to the motion if it is finite. */
static int taken(const orientation *found, stewart_motion *motion)
{
    const int status = orientation_status(found);
    int i;
    if (status == STEWART_OK) {
        for (i = 0; i < 9; ++i) {
            motion->R[i] = found->R[i];
        }
        for (i = 0; i < 3; ++i) {
            motion->omega[i] = found->omega[i];
            motion->alpha[i] = found->alpha[i];
        }
    }
    return status;
}

int stewart_motion_from_rpy(
    const stewart_real sine[3], const stewart_real cosine[3], const stewart_real theta_dot[3],
    const stewart_real theta_ddot[3], stewart_motion *motion)
{
    int status = STEWART_BAD_ARGUMENT;
    if ((sine != NULL) && (cosine != NULL) && (theta_dot != NULL) && (theta_ddot != NULL) &&
        (motion != NULL)) {
        orientation found;
        found = turned_by_angles(sine, cosine, theta_dot, theta_ddot);
        status = taken(&found, motion);
    }
    return status;
}

int stewart_motion_from_quaternion(
    const stewart_real e[4], const stewart_real e_dot[4], const stewart_real e_ddot[4],
    stewart_motion *motion)
{
    int status = STEWART_BAD_ARGUMENT;
    if ((e != NULL) && (e_dot != NULL) && (e_ddot != NULL) && (motion != NULL)) {
        const stewart_real square = (e[0]*e[0] + e[1]*e[1]) + (e[2]*e[2] + e[3]*e[3]);
        status = STEWART_NOT_FINITE;
        if ((square >= (REAL(1) / STEWART_MAX / STEWART_EPSILON)) && (square <= STEWART_MAX)) {
            orientation found;
            found = turned_by_quaternion(e, e_dot, e_ddot);
            status = taken(&found, motion);
        }
    }
    return status;
}
