/* stewart_legs.h: leg lengths with first and second derivatives, and leg vectors, of many poses.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * The function reads only the points b and p of the robot. The spin of a leg about its own axis has no effect, so the
 * function is valid for both formulations and both base joints. Equation numbers and status codes: see stewart.h.
 *
 * Operations, six legs: 540 (276 mul, 252 add, 6 div, 6 sqrt).
 */
#ifndef STEWART_LEGS_H
#define STEWART_LEGS_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Kinematics of the legs of `count` poses. A pointer may be null if its output is not needed. */
typedef struct {
    stewart_real *L; /* [count][6] m: lengths, (2) */
    stewart_real *L_dot; /* [count][6] m/s: length rates, (5) */
    stewart_real *L_ddot; /* [count][6] m/s^2: second derivatives of the lengths, (8) */
    stewart_real *s; /* [count][6][3] 1: unit vectors along the legs, base frame, (3) */
    stewart_real *S; /* [count][6][3] m: leg vectors, base frame, (1) */
} stewart_legs_arrays;

/* Computes the kinematics of the legs from R, t, omega, v, alpha, and a of motions. F_ext and M_ext are
 * not read. `status` receives the code of each pose and may be null. Returns the first code other than
 * STEWART_OK, or STEWART_OK. STEWART_ZERO_LENGTH: a leg is not longer than the rounding error of the terms of
 * S = q + t - b. STEWART_NOT_FINITE: an input is not finite, or a result overflows. Outputs of a pose with
 * these codes are unchanged. STEWART_BAD_ARGUMENT: a pointer is null that must not be; then nothing is written.
 * alpha and a of the motions may be null if L_ddot is null. */
STEWART_NODISCARD int stewart_legs_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const stewart_legs_arrays *legs,
    int *status);

#ifdef __cplusplus
}
#endif

#endif
