/* stewart_kinematics.h: lengths and rates of the legs, and the platform's pose and velocity from them.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * One pose at a time, for a controller. Of the robot, the points b and p are read and nothing else. The spin
 * of a leg about its own axis has no part in this: it serves both formulations and either base joint.
 *
 * Operations, six legs
 * lengths         162 (72 mul, 84 add, 0 div, 6 sqrt)
 * lengths, rates  270 (126 mul, 132 add, 6 div, 6 sqrt)
 * search          1161 (606 mul, 519 add, 22 div, 14 sqrt)
 * step            975 (516 mul, 426 add, 20 div, 13 sqrt)
 * velocity        969 (509 mul, 421 add, 26 div, 13 sqrt)
 * A search takes the operations of `search` once and the operations of `step` for each step. Steps from
 * guesses within 0.001, 0.05 and 0.3 rad of the pose, and as many lengths of the longest leg: in 99 of 100
 * poses of random machines no more than 3, 4 and 6 (double) and 2, 3 and 5 (float). A second and a third
 * search follow unless a bound proves that the first result is the nearest to the guess, as it mostly does
 * within 0.02 (m and rad) of a pose that is not near a singular one. STEWART_MAX_SEARCHES 1 omits them.
 */
#ifndef STEWART_KINEMATICS_H
#define STEWART_KINEMATICS_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Steps after which a search of a pose gives up, and number of searches: their product bounds the time. */
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

/* Lengths L of the legs, m, (2), and their rates L_dot, m/s, (5), at R, t, v and omega of a motion;
 * nothing else of it is read. L_dot may be null: then neither v nor omega is read. Returns a status:
 * STEWART_ZERO_LENGTH if a leg is no longer than the rounding of the terms of S = q + t - b,
 * STEWART_NOT_FINITE. */
STEWART_NODISCARD int stewart_inverse_kinematics(
    const stewart_robot *robot, const stewart_motion *motion, stewart_real L[6], stewart_real L_dot[6]);

/* Pose in which the legs have the lengths L, m, > 0, from a guess: `pose` in. Up to three searches by
 * Newton's steps on (2), none longer than a quarter of a radian and of the longest leg: from the guess; from
 * the guess with four damped steps first; and from behind the singular pose next to the result.
 * Returns a status, and writes the pose only if it is STEWART_OK:
 * STEWART_OK: the lengths are those asked for to within 16 rounding units of the largest component of the
 *     terms of S = q + t - b, and R is a rotation to rounding. Six lengths belong to up to forty poses: of
 *     the poses found, this one is the nearest to the guess, by the root of the sum of squares in m and rad.
 *     From a guess farther than 0.05 (m and rad) compare it with the guess.
 * STEWART_NOT_CONVERGED: none of the searches found such a pose in STEWART_MAX_STEPS steps; or the guess's R
 *     is no rotation: det R < 0, or an entry of R^T R farther than 1/16 from that of E.
 * STEWART_SINGULAR: the lengths are met where H is so near to singular that lengths known to rounding leave
 *     the pose open: its condition number, by Frobenius norms and with moments over the root mean square
 *     distance of the platform points from the reference point, exceeds 1 / (16 sqrt(eps)). That number is no
 *     less than the one by largest and smallest singular value, and no more than six times it.
 * STEWART_ZERO_LENGTH: a length is not > 0, or a leg has length zero at the guess.
 * STEWART_NOT_FINITE: an input is not finite, or the lengths at the guess overflow. */
STEWART_NODISCARD int stewart_forward_kinematics(
    const stewart_robot *robot, const stewart_real L[6], stewart_pose *pose);

/* Velocity v, m/s, of the reference point and angular velocity omega, rad/s, of the platform, base frame,
 * from the rates of the legs, m/s, at a pose: L_dot = H^T [v; omega], (5). Returns a status:
 * STEWART_SINGULAR as above, STEWART_ZERO_LENGTH and STEWART_NOT_FINITE. */
STEWART_NODISCARD int stewart_forward_velocity(
    const stewart_robot *robot, const stewart_pose *pose, const stewart_real L_dot[6], stewart_real v[3],
    stewart_real omega[3]);

#ifdef __cplusplus
}
#endif

#endif
