/* stewart_exact_spherical.h: inverse dynamics and joint reactions of a Gough-Stewart platform.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * Formulation `exact`: corrected equations.
 * Base joint: spherical. The legs must be axisymmetric. M_u is zero.
 *
 * Inputs from each leg: b[3] m, p[3] m, m_d kg, r_d0[3] m, I_d0[6] kg m^2, m_u kg, r_u0[3] m,
 *     I_u0[6] kg m^2, C_u N m s, C_p N s/m, C_s N m s.
 * Inputs from the robot: M kg, R_0[3] m, I_p[6] kg m^2, g[3] m/s^2.
 * Inputs from the motion: R[9] 1, t[3] m, omega[3] rad/s, v[3] m/s, alpha[3] rad/s^2, a[3] m/s^2,
 *     F_ext[3] N, M_ext[3] N m.
 * Outputs in forces: F[6] N, D[6] N, x[6] N, K[6][3] N, H[6][6] 1 and m, c[6] N and N m.
 * Outputs in reactions: F_s[6][3] N, F_u[6][3] N, F_p[6][3] N, F_c[6][3] N, M_p[6][3] N m,
 *     M_u[6] N m.
 * Meanings, frames, storage order, equation numbers, and status codes: see stewart.h.
 *
 * Operations of the inverse dynamics of one pose, without the checks for the status:
 * 6 x leg   248 (143 mul, 103 add, 1 div, 1 sqrt)
 * platform  219 (123 mul, 96 add, 0 div, 0 sqrt)
 * sum of c  36 (0 mul, 36 add, 0 div, 0 sqrt)
 * solve     197 (106 mul, 85 add, 6 div, 0 sqrt)
 * forces    6 (0 mul, 6 add, 0 div, 0 sqrt)
 * total     1946 (1087 mul, 841 add, 12 div, 6 sqrt)
 * leg: one leg. platform: terms that are common to all legs, and the platform's part of c.
 * sum of c: sum of the parts of c. solve: H x = c, (36). forces: F = D - x, (37).
 * add: additions and subtractions. Negations, copies, and comparisons are not counted.
 */
#ifndef STEWART_EXACT_SPHERICAL_H
#define STEWART_EXACT_SPHERICAL_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Computes the actuator forces of one pose and the terms D, x, K, H, and c. Returns a status, and writes
 * `forces` only if it is STEWART_OK. Other statuses: STEWART_NOT_FINITE, STEWART_ZERO_LENGTH,
 * STEWART_SINGULAR, and STEWART_BAD_ARGUMENT if a pointer is null. */
STEWART_NODISCARD int stewart_exact_spherical_inverse_dynamics(
    const stewart_robot *robot, const stewart_motion *motion, stewart_forces *forces);

/* Computes the inverse dynamics and the joint reactions of one pose. `bearing` (m): distance along each
 * leg from its base point to the reference point of M_p; null: 0. Returns a status as above, and writes
 * `forces` and `reactions` only if it is STEWART_OK. */
STEWART_NODISCARD int stewart_exact_spherical_joint_reactions(
    const stewart_robot *robot, const stewart_motion *motion, const stewart_real bearing[6],
    stewart_forces *forces, stewart_reactions *reactions);

/* Computes the inverse dynamics of `count` poses. `status` receives the code of each pose and may be
 * null. Returns the first code other than STEWART_OK, or STEWART_OK. STEWART_BAD_ARGUMENT: another
 * pointer, or an array of the motions except F_ext and M_ext, is null; then nothing is written. */
STEWART_NODISCARD int stewart_exact_spherical_inverse_dynamics_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions,
    const stewart_forces_arrays *forces, int *status);

/* Computes the joint reactions of `count` poses. `bearing` is valid for all poses and may be null.
 * `status` and the returned code are as above. */
STEWART_NODISCARD int stewart_exact_spherical_joint_reactions_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const stewart_real bearing[6],
    const stewart_reactions_arrays *reactions, int *status);

#ifdef __cplusplus
}
#endif

#endif
