/* stewart_torque.h: motor torques and currents from the forces of the legs.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * The function computes one pose, for a controller. Friction and efficiency act between the force of a leg and its
 * motor; the force kernels contain neither. For each leg, with the length rate L_dot and the axial force in the screw:
 *     friction = sgn(L_dot) (coulomb + stribeck exp(-(L_dot / stribeck_speed)^2) + mu |axial|) + viscous L_dot
 *     torque   = (F + friction) / turns
 *     current  = torque / torque_constant
 * mu is `driving` if the motor drives the leg (axial L_dot > 0), else `driven`. For |L_dot| < smoothing, sgn is
 * x (3 - x^2) / 2 with x = L_dot / smoothing. With smoothing <= 0, sgn is a step function and 0 at rest. With
 * stribeck_speed = 0 there is no Stribeck friction. With torque_constant <= 0 (unknown) the current is 0.
 *
 * Operations for six legs
 * with Stribeck friction     352 (180 mul, 150 add, 22 div, 0 sqrt)
 * without Stribeck friction  82 (42 mul, 24 add, 16 div, 0 sqrt)
 */
#ifndef STEWART_TORQUE_H
#define STEWART_TORQUE_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Constants of six drives; `turns` > 0 for a right-handed screw. */
typedef struct {
    stewart_real turns[6]; /* rad/m: motor angle per length, 2 pi gear / lead or gear / radius; not 0 */
    stewart_real driving[6]; /* 1: friction per axial force if the motor drives the leg: 1 / efficiency - 1 */
    stewart_real driven[6]; /* 1: friction per axial force if the leg drives the motor: 1 - backdrive_efficiency */
    stewart_real coulomb[6]; /* N: dry friction along the leg: screw_coulomb + |turns| motor_coulomb */
    stewart_real viscous[6]; /* N s/m: viscous friction: screw_viscous + turns^2 motor_viscous */
    stewart_real stribeck[6]; /* N: additional dry friction at rest */
    stewart_real stribeck_speed[6]; /* m/s: length rate at which this friction has decayed to 1/e */
    stewart_real smoothing[6]; /* m/s: length rate below which the sign of the rate is smoothed */
    stewart_real torque_constant[6]; /* N m/A: torque per current; 0 if unknown */
} stewart_drives;

/* Computes motor torques (N m) and currents (A).
 *
 * F (N): actuator forces of an inverse dynamics. L_dot (m/s): length rates, computed or measured.
 * axial (N): results of stewart_..._axial_forces if F includes the acceleration of rotors. axial may be null if
 * the legs have no rotors, or if F was computed without them. Then F is used instead, and the torques do not
 * include the acceleration of the rotors.
 * current may be null.
 *
 * Returns a status, and writes the outputs only if it is STEWART_OK. STEWART_BAD_ARGUMENT: another pointer is
 * null. STEWART_NOT_FINITE: an input, a constant of the drives, a torque, or a current is not finite, or
 * `turns` is 0. */
STEWART_NODISCARD int stewart_motor_torques(
    const stewart_drives *drives, const stewart_real F[6], const stewart_real axial[6],
    const stewart_real L_dot[6], stewart_real torque[6], stewart_real current[6]);

#ifdef __cplusplus
}
#endif

#endif
