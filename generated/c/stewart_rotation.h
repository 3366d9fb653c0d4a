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
 * to one angle. Returns a status, and writes R, omega, and alpha of the motion only if it is STEWART_OK; the
 * other members are unchanged. STEWART_BAD_ARGUMENT: a pointer is null. STEWART_NOT_FINITE: an input or a
 * result is not finite. */
STEWART_NODISCARD int stewart_motion_from_rpy(
    const stewart_real sine[3], const stewart_real cosine[3], const stewart_real theta_dot[3],
    const stewart_real theta_ddot[3], stewart_motion *motion);

/* Computes R, omega, and alpha from a quaternion e (scalar first, from the platform to the base frame) and its
 * first (1/s) and second (1/s^2) derivatives. e may have any length except zero whose square neither underflows
 * nor overflows; otherwise the status is STEWART_NOT_FINITE. Returns a status as above. */
STEWART_NODISCARD int stewart_motion_from_quaternion(
    const stewart_real e[4], const stewart_real e_dot[4], const stewart_real e_ddot[4],
    stewart_motion *motion);

#ifdef __cplusplus
}
#endif

#endif
