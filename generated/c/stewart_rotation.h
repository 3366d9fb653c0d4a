/* stewart_rotation.h: R, omega and alpha of a motion, from roll, pitch and yaw or from a quaternion.
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

/* R = Rz(theta_z) Ry(theta_y) Rx(theta_x), (38), omega and alpha from sines and cosines of theta_x, theta_y
 * and theta_z, rates, rad/s, and second rates, rad/s^2. The rates of the angles are not omega. That sine and
 * cosine belong to one angle is not checked. Returns a status: STEWART_NOT_FINITE if a number or result is
 * not finite; other members of the motion stay as they are. */
STEWART_NODISCARD int stewart_motion_from_rpy(
    const stewart_real sine[3], const stewart_real cosine[3], const stewart_real theta_dot[3],
    const stewart_real theta_ddot[3], stewart_motion *motion);

/* The same from a quaternion, platform to base, scalar first, of any length whose square is a number that
 * the arithmetic holds to all digits, else STEWART_NOT_FINITE; its rate, 1/s, and second rate, 1/s^2. */
STEWART_NODISCARD int stewart_motion_from_quaternion(
    const stewart_real e[4], const stewart_real e_dot[4], const stewart_real e_ddot[4],
    stewart_motion *motion);

#ifdef __cplusplus
}
#endif

#endif
