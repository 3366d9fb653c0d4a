/* stewart_exact_drive_bounds.h: actuator forces with bounds of their rounding errors.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * The forces are computed by the same operations as in stewart_exact_drive_forces.h and are identical to the last bit with
 * -ffp-contract=off. The bound is rigorous: it includes the rounding error of every operation to all orders, also the
 * operations of the bound. It is valid for arithmetic that rounds to nearest or fuses products into sums, without
 * overflow and underflow, but not with -ffast-math. It takes far longer than the forces.
 *
 * The bounded error is the distance of F from the exact forces for the given numbers, with R replaced by the nearest
 * rotation. So the bound includes the error of an R that is not exactly a rotation, but no errors of other inputs.
 *
 * Units, frames, equation numbers, and status codes: see stewart.h.
 */
#ifndef STEWART_EXACT_DRIVE_BOUNDS_H
#define STEWART_EXACT_DRIVE_BOUNDS_H

#include "stewart.h"

#if !defined(STEWART_ROTORS)
#error "define STEWART_ROTORS for every source: the legs of this kernel have rotors (see stewart_leg)"
#endif
#ifdef __cplusplus
extern "C" {
#endif

/* Constants of one leg; `_err`: bound of the error of the constant with this name. */
typedef struct {
    stewart_real b[3]; /* m: base point, base frame */
    stewart_real p[3]; /* m: platform point, platform frame */
    stewart_real k[3]; /* 1: unit vector along the fixed axis of the universal joint, base frame */
    stewart_real k_err[3];
    stewart_real C_p; /* N s/m: viscous friction of the prismatic joint */
    stewart_real C_s; /* N m s: viscous friction of the spherical joint */
    stewart_real m_r; /* kg: reflected mass J_r N^2 of the rotor with inertia J_r (kg m^2) and transmission N (rad/m) */
    stewart_real j_r; /* kg m: angular momentum J_r N of the rotor per length rate */
    stewart_real h[3]; /* kg m: first moment of the upper part about the platform point, leg frame */
    stewart_real h_err[3];
    stewart_real h2_x; /* kg m: 2 h_x */
    stewart_real h2_x_err;
    stewart_real h2_y; /* kg m: 2 h_y */
    stewart_real h2_y_err;
    stewart_real h2_z; /* kg m: 2 h_z */
    stewart_real h2_z_err;
    stewart_real w[3]; /* kg m: sum m_d r_d0 + m_u r_u0 of the first moments of both parts, leg frame */
    stewart_real w_err[3];
    /* kg m^2: sum of the inertias of the lower part about the base point and the upper part about the
     * platform point, leg frame */
    stewart_real J[6];
    stewart_real J_err[6];
    stewart_real J2_xz; /* kg m^2: 2 J_xz */
    stewart_real J2_xz_err;
    stewart_real dJ_zx; /* kg m^2: J_zz - J_xx */
    stewart_real dJ_zx_err;
    stewart_real g_k; /* m/s^2: component of g along the fixed axis k */
    stewart_real g_k_err;
    stewart_real g_x_k[3]; /* m/s^2: g x k, base frame */
    stewart_real g_x_k_err[3];
    stewart_real C_us; /* N m s: C_u + C_s */
    stewart_real C_us_err;
} stewart_exact_drive_bounds_leg;

/* Constants of the platform. */
typedef struct {
    stewart_real M_P; /* kg: M plus the masses m_u of all legs (massless legs: M) */
    stewart_real M_P_err;
    stewart_real r_C[3]; /* m: center of mass of M_P, with the masses m_u at the platform points (massless legs: R_0), platform frame */
    stewart_real r_C_err[3];
    stewart_real J_C[6]; /* kg m^2: inertia of the mass M_P about r_C, platform frame */
    stewart_real J_C_err[6];
    stewart_real dJ_C[3]; /* kg m^2: J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx */
    stewart_real dJ_C_err[3];
    stewart_real C_P; /* N m s: sum of C_s of all legs */
    stewart_real C_P_err;
    stewart_real g[3]; /* m/s^2: acceleration due to gravity, base frame */
    stewart_real p_1[3]; /* m: platform point 1, platform frame */
} stewart_exact_drive_bounds_platform;

/* Prepared constants of a robot. The leg frame has x along the leg and y along the moving axis of the
 * universal joint. Inertias have the order xx xy xz yy yz zz. */
typedef struct {
    stewart_exact_drive_bounds_leg leg[6];
    stewart_exact_drive_bounds_platform platform;
    stewart_real length; /* m: root mean square distance of the platform points from the reference point */
    /* 1/m: factor of the moment rows of H and c in the linear solver. It is 1 if the largest coordinate
     * of the arms p_i - p_1 is 0.125 m to 16 m. Otherwise it is the reciprocal of the smallest power of
     * two that is not below this coordinate, and each pose requires 18 to 21 more multiplications. */
    stewart_real per_length;
    stewart_real arm_cube; /* 1: (largest coordinate of p_i - p_1, times per_length)^3, the scale of determinants of moments */
} stewart_exact_drive_bounds_model;

/* Computes the model of a robot, once before the first pose. The vectors k may have any length except zero.
 * Returns a status, and writes the model only if it is STEWART_OK. STEWART_BAD_ARGUMENT: a pointer is null.
 * STEWART_NOT_FINITE: a number of the robot is not finite or too large, or a vector k is zero. */
STEWART_NODISCARD int stewart_exact_drive_bounds_prepare(
    const stewart_robot *robot, stewart_exact_drive_bounds_model *model);

/* Computes the actuator forces F (N) of one pose, (37), with bounds of their errors, `bound` (N). A bound is
 * infinite if H is so close to singular that no bound can be found in this arithmetic. `rcond` is the
 * reciprocal condition number of H, 1/(|H| |1/H|), in the norm of the largest column sum, with moments about
 * the reference point divided by `length` of the model. 1 is best; near STEWART_EPSILON no digit is correct.
 * `bound` and `rcond` may be null. Returns a status, and writes the outputs only if it is STEWART_OK. Other
 * statuses: STEWART_NOT_FINITE, STEWART_ZERO_LENGTH, STEWART_JOINT_SINGULAR, STEWART_SINGULAR, and
 * STEWART_BAD_ARGUMENT if another pointer is null. */
STEWART_NODISCARD int stewart_exact_drive_forces_bounded(
    const stewart_exact_drive_bounds_model *model, const stewart_motion *motion, stewart_real F[6],
    stewart_real bound[6], stewart_real *rcond);

/* Computes F[count][6], bound[count][6], and rcond[count] of `count` poses. `status` receives the code of each
 * pose. It, `bound`, `rcond`, and F_ext and M_ext of the motions may be null. Returns the first code other than
 * STEWART_OK, or STEWART_OK. STEWART_BAD_ARGUMENT: another pointer is null; then nothing is written. */
STEWART_NODISCARD int stewart_exact_drive_forces_bounded_batch(
    const stewart_exact_drive_bounds_model *model, size_t count, const stewart_motions *motions, stewart_real *F,
    stewart_real *bound, stewart_real *rcond, int *status);

#ifdef __cplusplus
}
#endif

#endif
