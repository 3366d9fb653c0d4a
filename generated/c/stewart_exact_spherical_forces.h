/* stewart_exact_spherical_forces.h: actuator forces from prepared constants, optimized for speed.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * A single pose uses six of eight lanes for its legs. A batch uses eight lanes, or sixteen in float, for poses.
 * Compilers vectorize the loops over lanes (gcc and clang: -O3 -std=c99 -fno-math-errno and -march for your
 * processor). With -ffp-contract=off one pose and a batch agree to the last bit.
 *
 * Operations of the inverse dynamics of one pose: six legs and linear solver, without checks
 * leg      221 (128 mul, 91 add, 1 div, 1 sqrt)
 * platform 186 (96 mul, 90 add, 0 div, 0 sqrt)
 * moments  21 (12 mul, 9 add, 0 div, 0 sqrt)
 * sum of c 51 (0 mul, 51 add, 0 div, 0 sqrt)
 * solve    262 (158 mul, 102 add, 2 div, 0 sqrt)
 * forces   6 (0 mul, 6 add, 0 div, 0 sqrt)
 * total    1936 (1082 mul, 840 add, 8 div, 6 sqrt)
 * With fused multiply-add instructions: 1295.
 */
#ifndef STEWART_EXACT_SPHERICAL_FORCES_H
#define STEWART_EXACT_SPHERICAL_FORCES_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Prepared constants of a robot, legs in lanes; the last two lanes repeat leg 6. */
typedef struct {
    stewart_real b[3][8]; /* m: base point, base frame */
    stewart_real p[3][8]; /* m: platform point, platform frame */
    stewart_real m_d[8]; /* kg: mass of the lower part */
    stewart_real r_d0[3][8]; /* m: center of mass of the lower part, frame D */
    stewart_real I_d0[6][8]; /* kg m^2: inertia of the lower part about its center of mass, frame D */
    stewart_real m_u[8]; /* kg: mass of the upper part */
    stewart_real r_u0[3][8]; /* m: center of mass of the upper part, frame U */
    stewart_real I_u0[6][8]; /* kg m^2: inertia of the upper part about its center of mass, frame U */
    stewart_real C_u[8]; /* N m s: viscous friction of the universal joint */
    stewart_real C_p[8]; /* N s/m: viscous friction of the prismatic joint */
    stewart_real C_s[8]; /* N m s: viscous friction of the spherical joint */
    stewart_real M_P; /* kg: mass of the platform with the upper parts */
    stewart_real r_C[3]; /* m: center of mass of the platform with the upper parts, platform frame */
    stewart_real J_C[6]; /* kg m^2: inertia of this mass about r_C, platform frame */
    stewart_real dJ_C[3]; /* kg m^2: J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx */
    stewart_real g[3]; /* m/s^2: acceleration due to gravity, base frame */
    /* 1/m: by which the solve multiplies moments, 18 to 21 multiplications, unless it is 1: for
     * platforms of 0.125 to 16 m. Otherwise one over the least power of two that no arm exceeds. */
    stewart_real per_length;
    stewart_real arm_cube; /* cube of the largest arm over that length: what determinants of moments are beside */
    stewart_real base_reach; /* m: largest coordinate of the base points */
} stewart_exact_spherical_model;

/* Prepares the constants; k may have any length but zero. Returns a status: STEWART_NOT_FINITE if a
 * number of the robot is not finite or too large, or k is zero; the model is written only if it is
 * STEWART_OK. One pose is fastest where the model begins at a multiple of 64 bytes. */
STEWART_NODISCARD int stewart_exact_spherical_prepare(
    const stewart_robot *robot, stewart_exact_spherical_model *model);

/* Actuator forces F, N, of one pose, (37). Returns a status; F is written only if it is STEWART_OK. */
STEWART_NODISCARD int stewart_exact_spherical_forces(
    const stewart_exact_spherical_model *model, const stewart_motion *motion, stewart_real F[6]);

/* Actuator forces F[count][6] of `count` poses. `status` takes one code for each pose; null: not wanted.
 * Returns the first code other than STEWART_OK, or STEWART_OK. No pose's result depends on the others. */
STEWART_NODISCARD int stewart_exact_spherical_forces_batch(
    const stewart_exact_spherical_model *model, size_t count, const stewart_motions *motions,
    stewart_real *F, int *status);

/* The same, bit for bit, of columns: component i of pose j is number [i*stride + j] of its array, i from
 * 0 to 8 of R and to 5 of F. STEWART_BAD_ARGUMENT where `stride` is less than `count`. Arrays may begin
 * anywhere; eight poses, in float sixteen, are read at a time: fastest where arrays begin at multiples
 * of 64 bytes and `stride` is a multiple of 64 bytes, and none of 4096. */
STEWART_NODISCARD int stewart_exact_spherical_forces_columns(
    const stewart_exact_spherical_model *model, size_t count, size_t stride, const stewart_motions *motions,
    stewart_real *F, int *status);

#ifdef __cplusplus
}
#endif

#endif
