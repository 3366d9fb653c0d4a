/* stewart_exact_drive_reflected_slender_forces.h: actuator forces from prepared constants, optimized for speed.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * Units, frames, equation numbers, and status codes: see stewart.h.
 *
 * Lanes are elements of a vector register. A single pose uses six of eight lanes for its legs. A batch uses eight
 * lanes, or sixteen in float, for poses. Compilers vectorize the loops over lanes (gcc and clang: -O3 -std=c99
 * -fno-math-errno and -march for your processor). With -ffp-contract=off one pose and a batch agree to the last bit.
 *
 * Fidelity level: reflected masses, no inertia about the leg's axis. The joints have no friction.
 *
 * Operations of the inverse dynamics of one pose, without the checks for the status:
 * 6 x leg      116 (65 mul, 49 add, 1 div, 1 sqrt)
 * platform     186 (96 mul, 90 add, 0 div, 0 sqrt)
 * 5 x moments  21 (12 mul, 9 add, 0 div, 0 sqrt)
 * sum of c     33 (0 mul, 33 add, 0 div, 0 sqrt)
 * solve        262 (158 mul, 102 add, 2 div, 0 sqrt)
 * forces       6 (0 mul, 6 add, 0 div, 0 sqrt)
 * total        1288 (704 mul, 570 add, 8 div, 6 sqrt)
 * Total with fused multiply-add instructions: 827.
 * leg: one leg. platform: terms that are common to all legs, and the platform's part of c.
 * moments: moments of one leg about platform point 1; leg 1 has none.
 * sum of c: sum of the parts of c. solve: H x = c, (36). forces: F = D - x, (37).
 * add: additions and subtractions. Negations, copies, and comparisons are not counted.
 */
#ifndef STEWART_EXACT_DRIVE_REFLECTED_SLENDER_FORCES_H
#define STEWART_EXACT_DRIVE_REFLECTED_SLENDER_FORCES_H

#include "stewart.h"

#if !defined(STEWART_ROTORS)
#error "define STEWART_ROTORS for every source: the legs of this kernel have rotors (see stewart_leg)"
#endif
#ifdef __cplusplus
extern "C" {
#endif

/* Prepared constants of a robot. In arrays that end with [8] the last index is the leg; the values 7 and
 * 8 repeat leg 6. Inertias have the order xx xy xz yy yz zz. */
typedef struct {
    stewart_real b[3][8]; /* m: base point, base frame */
    stewart_real p[3][8]; /* m: platform point, platform frame */
    stewart_real m_r[8]; /* kg: reflected mass J_r N^2 of the rotor with inertia J_r (kg m^2) and transmission N (rad/m) */
    stewart_real h_s[8]; /* kg m: first moment of the upper part about the platform point, along the leg */
    stewart_real w_s[8]; /* kg m: component of w along the leg */
    stewart_real J_t[8]; /* kg m^2: transverse inertia (J_yy + J_zz) / 2 of both parts */
    stewart_real M_P; /* kg: M plus the masses m_u of all legs (massless legs: M) */
    stewart_real r_C[3]; /* m: center of mass of M_P, with the masses m_u at the platform points (massless legs: R_0), platform frame */
    stewart_real J_C[6]; /* kg m^2: inertia of the mass M_P about r_C, platform frame */
    stewart_real dJ_C[3]; /* kg m^2: J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx */
    stewart_real g[3]; /* m/s^2: acceleration due to gravity, base frame */
    /* 1/m: factor of the moment rows of H and c in the linear solver. It is 1 if the largest coordinate
     * of the arms p_i - p_1 is 0.125 m to 16 m. Otherwise it is the reciprocal of the smallest power of
     * two that is not below this coordinate, and each pose requires 18 to 21 more multiplications. */
    stewart_real per_length;
    stewart_real arm_cube; /* 1: (largest coordinate of p_i - p_1, times per_length)^3, the scale of determinants of moments */
    stewart_real base_reach; /* m: largest magnitude of a coordinate of the base points */
} stewart_exact_drive_reflected_slender_model;

/* Computes the model of a robot, once before the first pose. Returns a status, and writes the model only
 * if it is STEWART_OK. STEWART_BAD_ARGUMENT: a pointer is null. STEWART_NOT_FINITE: a number that the
 * model depends on is not finite or too large. The function of one pose is fastest if the address of the
 * model is a multiple of 64 bytes. */
STEWART_NODISCARD int stewart_exact_drive_reflected_slender_prepare(
    const stewart_robot *robot, stewart_exact_drive_reflected_slender_model *model);

/* Computes the actuator forces F (N) of one pose, (37), positive when they extend the leg. Reads R, t,
 * omega, v, alpha, a, F_ext, and M_ext of the motion. Returns a status, and writes F only if it is
 * STEWART_OK. Other statuses: STEWART_NOT_FINITE, STEWART_ZERO_LENGTH, STEWART_SINGULAR, and
 * STEWART_BAD_ARGUMENT if a pointer is null. */
STEWART_NODISCARD int stewart_exact_drive_reflected_slender_forces(
    const stewart_exact_drive_reflected_slender_model *model, const stewart_motion *motion,
    stewart_real F[6]);

/* Computes the actuator forces F[count][6] (N) of `count` poses. `status` receives the code of each pose
 * and may be null; F_ext and M_ext may be null for zero load. Returns the first code other than
 * STEWART_OK, or STEWART_OK. A pose with another code keeps its old numbers in F and does not affect the
 * other poses. STEWART_BAD_ARGUMENT: R, t, omega, v, alpha, a, or another pointer is null; then nothing
 * is written. */
STEWART_NODISCARD int stewart_exact_drive_reflected_slender_forces_batch(
    const stewart_exact_drive_reflected_slender_model *model, size_t count, const stewart_motions *motions,
    stewart_real *F, int *status);

/* Computes the same forces, identical to the last bit, from arrays with one column for each component:
 * component i of pose j is element [i*stride + j] of its array. i is 0 to 8 in R, 0 to 2 in vectors, and
 * 0 to 5 in F. STEWART_BAD_ARGUMENT: as above, or `stride` is less than `count`. Arrays may have any
 * address. Eight poses (sixteen in float) are read at a time. This is fastest if the arrays begin at
 * multiples of 64 bytes, and if `stride` times sizeof(stewart_real) is a multiple of 64 but not of 4096. */
STEWART_NODISCARD int stewart_exact_drive_reflected_slender_forces_columns(
    const stewart_exact_drive_reflected_slender_model *model, size_t count, size_t stride,
    const stewart_motions *motions, stewart_real *F, int *status);

#ifdef __cplusplus
}
#endif

#endif
