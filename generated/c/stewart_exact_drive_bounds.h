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
 * rotation. So the deviation of R from a rotation is included. Errors of the other inputs are not included.
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

/* Constants of one leg; `_err`: bound of the error of what has this name. */
typedef struct {
    stewart_real b[3]; /* m: base point, base frame */
    stewart_real p[3]; /* m: platform point, platform frame */
    stewart_real k[3]; /* 1: unit vector along the fixed axis of the universal joint, base frame */
    stewart_real k_err[3];
    stewart_real C_p; /* N s/m: viscous friction of the prismatic joint */
    stewart_real C_s; /* N m s: viscous friction of the spherical joint */
    stewart_real m_r; /* kg: reflected mass of the leg's rotor, J_r N^2 with the transmission ratio N, rad/m */
    stewart_real j_r; /* kg m: angular momentum of the leg's rotor per rate of length, J_r N */
    stewart_real h[3]; /* kg m: first moment of the upper part about the platform point, leg frame */
    stewart_real h_err[3];
    stewart_real h2_x; /* kg m: 2 h_x */
    stewart_real h2_x_err;
    stewart_real h2_y; /* kg m: 2 h_y */
    stewart_real h2_y_err;
    stewart_real h2_z; /* kg m: 2 h_z */
    stewart_real h2_z_err;
    stewart_real w[3]; /* kg m: first moments of both parts, about the base and the platform point, leg frame */
    stewart_real w_err[3];
    stewart_real J[6]; /* kg m^2: inertias of the parts about base and platform point, leg frame */
    stewart_real J_err[6];
    stewart_real J2_xz; /* kg m^2: 2 J_xz */
    stewart_real J2_xz_err;
    stewart_real dJ_zx; /* kg m^2: J_zz - J_xx */
    stewart_real dJ_zx_err;
    stewart_real g_k; /* m/s^2: gravity along the fixed axis */
    stewart_real g_k_err;
    stewart_real g_x_k[3]; /* m/s^2: g x k, base frame */
    stewart_real g_x_k_err[3];
    stewart_real C_us; /* N m s: C_u + C_s */
    stewart_real C_us_err;
} stewart_exact_drive_bounds_leg;

/* Constants of the platform. */
typedef struct {
    stewart_real M_P; /* kg: mass of the platform with the upper parts */
    stewart_real M_P_err;
    stewart_real r_C[3]; /* m: center of mass of the platform with the upper parts, platform frame */
    stewart_real r_C_err[3];
    stewart_real J_C[6]; /* kg m^2: inertia of this mass about r_C, platform frame */
    stewart_real J_C_err[6];
    stewart_real dJ_C[3]; /* kg m^2: J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx */
    stewart_real dJ_C_err[3];
    stewart_real C_P; /* N m s: friction of all spherical joints */
    stewart_real C_P_err;
    stewart_real g[3]; /* m/s^2: acceleration due to gravity, base frame */
    stewart_real p_1[3]; /* m: platform point 1, platform frame */
} stewart_exact_drive_bounds_platform;

/* A robot's constants, prepared once. */
typedef struct {
    stewart_exact_drive_bounds_leg leg[6];
    stewart_exact_drive_bounds_platform platform;
    stewart_real length; /* m: root mean square distance of the platform points from the reference point */
    /* 1/m: by which the solve multiplies moments, 18 to 21 multiplications, unless it is 1: for
     * platforms of 0.125 to 16 m. Otherwise one over the least power of two that no arm exceeds. */
    stewart_real per_length;
    stewart_real arm_cube; /* cube of the largest arm over that length: what determinants of moments are beside */
} stewart_exact_drive_bounds_model;

/* Prepares the constants; k may have any length except zero. Returns a status: STEWART_NOT_FINITE if a
 * number of the robot is not finite or too large, or if k is zero. The model is written only if the status
 * is STEWART_OK. */
STEWART_NODISCARD int stewart_exact_drive_bounds_prepare(
    const stewart_robot *robot, stewart_exact_drive_bounds_model *model);

/* Computes the actuator forces F (N) of one pose, (37), with bounds of their errors, `bound` (N). A bound is
 * infinite if H is so close to singular that no bound can be found in this arithmetic. `rcond` is the
 * reciprocal condition number of H, 1/(|H| |1/H|), in the norm of the largest column sum, with moments about
 * the reference point divided by the length of the model. 1 is best; near STEWART_EPSILON no digit is
 * correct. `bound` and `rcond` may be null. Returns a status; the outputs are written only if it is
 * STEWART_OK. */
STEWART_NODISCARD int stewart_exact_drive_forces_bounded(
    const stewart_exact_drive_bounds_model *model, const stewart_motion *motion, stewart_real F[6],
    stewart_real bound[6], stewart_real *rcond);

/* Computes the same for `count` poses: F[count][6], bound[count][6], rcond[count]. `status` receives one
 * code for each pose and may be null. Returns the first code other than STEWART_OK, or STEWART_OK. */
STEWART_NODISCARD int stewart_exact_drive_forces_bounded_batch(
    const stewart_exact_drive_bounds_model *model, size_t count, const stewart_motions *motions, stewart_real *F,
    stewart_real *bound, stewart_real *rcond, int *status);

#ifdef __cplusplus
}
#endif

#endif
