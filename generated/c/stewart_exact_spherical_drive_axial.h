/* stewart_exact_spherical_drive_axial.h: axial forces in the screws of legs with rotors.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * The function computes one pose, for a controller. Its results are inputs of stewart_motor_torques (stewart_torque.h).
 * It reads b, p, and m_r of the robot. Units, frames, equation numbers, and status codes: see stewart.h.
 *
 * Operations for six legs: 552 (282 mul, 258 add, 6 div, 6 sqrt).
 */
#ifndef STEWART_EXACT_SPHERICAL_DRIVE_AXIAL_H
#define STEWART_EXACT_SPHERICAL_DRIVE_AXIAL_H

#include "stewart.h"

#if !defined(STEWART_ROTORS)
#error "define STEWART_ROTORS for every source: the legs of this kernel have rotors (see stewart_leg)"
#endif
#ifdef __cplusplus
extern "C" {
#endif

/* Computes the axial forces (N) between the two parts of each leg, positive when they extend the leg, and the length
 * rates L_dot (m/s), (5). axial is F (N) minus the force that accelerates the rotor, m_r L_ddot.
 * F is computed by inverse dynamics with rotors. L_dot may be null. F_ext and M_ext of the motion are not read.
 * Returns a status, and writes the outputs only if it is STEWART_OK. STEWART_BAD_ARGUMENT: another pointer is null.
 * Other statuses: STEWART_NOT_FINITE, STEWART_ZERO_LENGTH. */
STEWART_NODISCARD int stewart_exact_spherical_drive_axial_forces(
    const stewart_robot *robot, const stewart_motion *motion, const stewart_real F[6], stewart_real axial[6],
    stewart_real L_dot[6]);

#ifdef __cplusplus
}
#endif

#endif
