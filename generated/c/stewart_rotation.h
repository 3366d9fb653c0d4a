/* stewart_rotation.h: R, omega, and alpha of a motion from roll, pitch, and yaw or from a quaternion.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#ifndef STEWART_ROTATION_H
#define STEWART_ROTATION_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Computes R = Rz(theta_z) Ry(theta_y) Rx(theta_x), (38), omega, and alpha. Inputs are the sines and cosines
 * of theta_x, theta_y, and theta_z, and the first (rad/s) and second (rad/s^2) derivatives of these angles.
 * The derivatives of the angles differ from omega. The function does not check that sine and cosine belong
 * to one angle. Returns a status: STEWART_NOT_FINITE if a number or result is not finite. Other members of
 * the motion are unchanged. */
STEWART_NODISCARD int stewart_motion_from_rpy(
    const stewart_real sine[3], const stewart_real cosine[3], const stewart_real theta_dot[3],
    const stewart_real theta_ddot[3], stewart_motion *motion);

/* Computes R, omega, and alpha from a quaternion that rotates from the platform to the base frame, scalar
 * first, its derivative (1/s), and its second derivative (1/s^2). The quaternion may have any length whose
 * square the arithmetic represents with all digits; else the status is STEWART_NOT_FINITE. */
STEWART_NODISCARD int stewart_motion_from_quaternion(
    const stewart_real e[4], const stewart_real e_dot[4], const stewart_real e_ddot[4],
    stewart_motion *motion);

#ifdef __cplusplus
}
#endif

#endif
