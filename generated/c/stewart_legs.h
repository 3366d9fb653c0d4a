/* stewart_legs.h: lengths of the legs, their rates and second rates, and their vectors, of many poses.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * Of the robot, the points b and p are read and nothing else. The spin of a leg about its own axis has no
 * part in this: it serves both formulations and either base joint.
 *
 * Operations, six legs: 540 (276 mul, 252 add, 6 div, 6 sqrt).
 */
#ifndef STEWART_LEGS_H
#define STEWART_LEGS_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Kinematics of the legs of `count` poses. Any pointer may be null: not wanted. */
typedef struct {
    stewart_real *L; /* [count][6] m: lengths, (2) */
    stewart_real *L_dot; /* [count][6] m/s: rates, (5) */
    stewart_real *L_ddot; /* [count][6] m/s^2: second rates, (8) */
    stewart_real *s; /* [count][6][3] 1: unit vectors along the legs, base frame, (3) */
    stewart_real *S; /* [count][6][3] m: leg vectors, base frame, (1) */
} stewart_legs_arrays;

/* Kinematics of the legs at R, t, omega, v, alpha and a of motions; alpha and a may be null where L_ddot is.
 * Writes each pose's status unless `status` is null, and returns the first that is not STEWART_OK:
 * STEWART_ZERO_LENGTH if a leg is no longer than the rounding of the terms of S = q + t - b,
 * STEWART_NOT_FINITE. Outputs of such a pose are left as they were. */
STEWART_NODISCARD int stewart_legs_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const stewart_legs_arrays *legs,
    int *status);

#ifdef __cplusplus
}
#endif

#endif
