/* stewart_kinematics.h: inverse and forward kinematics: leg lengths and rates, and the platform's pose and twist.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * Each function computes one pose, for a controller. The functions read only the points b and p of the robot. The spin
 * of a leg about its own axis has no effect, so they are valid for both formulations and both base joints. Units,
 * frames, equation numbers, and status codes: see stewart.h. All functions return STEWART_BAD_ARGUMENT if a pointer
 * that must not be null is null.
 *
 * Operations for six legs
 * lengths         162 (72 mul, 84 add, 0 div, 6 sqrt)
 * lengths, rates  270 (126 mul, 132 add, 6 div, 6 sqrt)
 * search          380 (187 mul, 182 add, 3 div, 8 sqrt)
 * step            878 (473 mul, 378 add, 14 div, 13 sqrt)
 * velocity        1028 (558 mul, 436 add, 20 div, 14 sqrt)
 * Forward kinematics requires at most the operations of `search` once per search and of `step` once per step. For
 * guesses within 0.001, 0.05, and 0.3 rad and the same fractions of the longest leg, 99 of 100 poses of random robots
 * require at most 3, 4, and 6 steps. In float they require at most 2, 3, and 5 steps. A second search follows
 * if a step reduced the largest error of the lengths by less than 30 %. A third search follows if another pose is
 * estimated to be near, behind the next singular pose. Both end as soon as they approach the pose that is already
 * known, or get 1.12 times as far from the guess. Within 0.05 (m and rad) of a pose that is not near a singular
 * pose, one search usually suffices.
 * STEWART_MAX_SEARCHES 1 omits these searches.
 */
#ifndef STEWART_KINEMATICS_H
#define STEWART_KINEMATICS_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Largest number of steps of a search, and number of searches; their product bounds the time. */
#if !defined(STEWART_MAX_STEPS)
#define STEWART_MAX_STEPS 30
#endif
#if !defined(STEWART_MAX_SEARCHES)
#define STEWART_MAX_SEARCHES 3
#endif

/* Pose of the platform. */
typedef struct {
    stewart_real R[9]; /* 1: orientation of the platform, platform frame to base frame, row-major */
    stewart_real t[3]; /* m: position of the platform's reference point, base frame */
} stewart_pose;

/* Computes the leg lengths L (m), (2), and length rates L_dot (m/s), (5), from R, t, v, and omega of a motion.
 * L_dot may be null; then v and omega are not read. Returns a status, and writes the outputs only if it is STEWART_OK.
 * STEWART_ZERO_LENGTH: a leg is not longer than the rounding error of the terms of S = q + t - b.
 * STEWART_NOT_FINITE: an input is not finite, or a result overflows. */
STEWART_NODISCARD int stewart_inverse_kinematics(
    const stewart_robot *robot, const stewart_motion *motion, stewart_real L[6], stewart_real L_dot[6]);

/* Computes the pose for the leg lengths L (m), > 0, by up to three Newton searches on (2). On entry `pose` is the
 * guess. The searches begin at the guess; at the guess, with four damped steps; and beyond the singular pose next to
 * the result. No step is longer than 0.4 rad and 0.4 times the longest leg.
 * Returns a status, and writes the pose only if it is STEWART_OK.
 * STEWART_OK: the error of the lengths is at most 16 rounding units of the largest component of t, or of the
 *     largest distance of a joint from the origin of its part. R is a rotation to rounding. Six lengths belong to up to forty poses. The result is the
 *     nearest one to the guess of the poses found, by the root of the sum of squares in m and rad. If the guess may
 *     be farther away than 0.05 (m and rad), compare the result with it.
 * STEWART_NOT_CONVERGED: no search found such a pose in STEWART_MAX_STEPS steps. Or R of the guess is not a
 *     rotation: det R < 0, or an entry of R^T R differs by more than 1/16 from the unit matrix.
 * STEWART_SINGULAR: H is so close to singular at the result that lengths with rounding errors do not determine the
 *     pose. The condition number of H exceeds 1 / (16 sqrt(eps)). It is computed with Frobenius norms and with
 *     moments over the root mean square distance of the platform points from the reference point. It is one to six
 *     times the ratio of the largest and the smallest singular value.
 * STEWART_ZERO_LENGTH: a length is not > 0, or a leg has length zero at the guess.
 * STEWART_NOT_FINITE: an input is not finite, or the lengths at the guess overflow. */
STEWART_NODISCARD int stewart_forward_kinematics(
    const stewart_robot *robot, const stewart_real L[6], stewart_pose *pose);

/* Computes the velocity v (m/s) of the reference point and the angular velocity omega (rad/s) of the platform, base
 * frame, from the length rates L_dot (m/s) at a pose. Solves L_dot = H^T [v; omega], (5). Returns a status, and writes
 * v and omega only if it is STEWART_OK. Other statuses: STEWART_SINGULAR if H at the pose exceeds the same condition
 * number, STEWART_ZERO_LENGTH, or STEWART_NOT_FINITE. */
STEWART_NODISCARD int stewart_forward_velocity(
    const stewart_robot *robot, const stewart_pose *pose, const stewart_real L_dot[6], stewart_real v[3],
    stewart_real omega[3]);

#ifdef __cplusplus
}
#endif

#endif
