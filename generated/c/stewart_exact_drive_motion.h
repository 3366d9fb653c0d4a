/* stewart_exact_drive_motion.h: closed form of the equations of motion, forward dynamics, and derivatives.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 *     M [a; alpha] + C [v; omega] + g + friction = H F + [R F_ext; R M_ext]
 *
 * Wrenches [force; moment] and twists [v; omega] are in the base frame at the platform's reference point. M is
 * symmetric and, with physical inertias, positive definite. M_dot - 2 C is skew-symmetric. bias is C [v; omega] + g.
 * Matrices are row-major. A change of the pose by [dt; dphi] (m and rad) changes t to t + dt and R to exp([dphi]x) R.
 * Link with stewart_exact_drive_forces.c, because the functions use its prepared model. a and alpha of the
 * motion are read only by `derivatives`.
 * Units, frames, and status codes: see stewart.h.
 *
 * Operations per pose without linear solver
 * equations         4760 (2691 mul, 2045 add, 12 div, 12 sqrt)
 * bias              2163 (1281 mul, 858 add, 12 div, 12 sqrt)
 * forward_dynamics  3081 (1779 mul, 1278 add, 12 div, 12 sqrt)
 * derivatives       10910 (6036 mul, 4850 add, 12 div, 12 sqrt)
 */
#ifndef STEWART_EXACT_DRIVE_MOTION_H
#define STEWART_EXACT_DRIVE_MOTION_H

#include "stewart_exact_drive_forces.h"

#if !defined(STEWART_ROTORS)
#error "define STEWART_ROTORS for every source: the legs of this kernel have rotors (see stewart_leg)"
#endif
#ifdef __cplusplus
extern "C" {
#endif

/* Terms of the equations of motion, base frame, moments about the reference point. */
typedef struct {
    stewart_real M[36]; /* kg, kg m and kg m^2: mass matrix, row-major */
    stewart_real C[36]; /* units of M over s: Coriolis and centrifugal matrix, row-major */
    stewart_real g[6]; /* N and N m: wrench of gravity */
    stewart_real friction[6]; /* N and N m: wrench of the joint friction */
    stewart_real bias[6]; /* N and N m: C [v; omega] + g */
    stewart_real bias_and_friction[6]; /* N and N m: C [v; omega] + g + friction */
    stewart_real H[36]; /* 1 and m: wrench matrix: H F is the generalized force of F, row-major */
    stewart_real H_dot[36]; /* 1/s and m/s: time derivative of H, row-major */
} stewart_equations;

/* Actuator forces of inverse dynamics, and their derivatives by pose, twist, and acceleration. */
typedef struct {
    stewart_real F[6]; /* N: actuator forces */
    stewart_real by_pose[36]; /* N/m and N/rad: derivatives of F by [dt; dphi], row-major */
    stewart_real by_twist[36]; /* N s/m and N s/rad: derivatives of F by [v; omega], row-major */
    stewart_real by_acceleration[36]; /* N s^2/m and N s^2/rad: derivatives of F by [a; alpha], row-major */
} stewart_derivatives;

/* Forward dynamics, and its linearization about the motion: d/dt [dt; dphi; dv; domega] = A [dt; dphi;
 * dv; domega] + B dF. */
typedef struct {
    stewart_real acceleration[6]; /* m/s^2 and rad/s^2: [a; alpha], base frame */
    stewart_real A[144]; /* mixed: state matrix, 12 by 12, row-major */
    stewart_real B[72]; /* mixed: input matrix of dF, 12 by 6, row-major */
} stewart_linearization;

/* Results of `count` poses. A pointer may be null if its output is not needed. */
typedef struct {
    stewart_real *M; /* [count][36] */
    stewart_real *C; /* [count][36] */
    stewart_real *g; /* [count][6] */
    stewart_real *friction; /* [count][6] */
    stewart_real *bias; /* [count][6] */
    stewart_real *bias_and_friction; /* [count][6] */
    stewart_real *H; /* [count][36] */
    stewart_real *H_dot; /* [count][36] */
} stewart_equations_arrays;

typedef struct {
    stewart_real *F; /* [count][6] */
    stewart_real *by_pose; /* [count][36] */
    stewart_real *by_twist; /* [count][36] */
    stewart_real *by_acceleration; /* [count][36] */
} stewart_derivatives_arrays;

typedef struct {
    stewart_real *acceleration; /* [count][6] */
    stewart_real *A; /* [count][144] */
    stewart_real *B; /* [count][72] */
} stewart_linearization_arrays;

/* Functions for one pose. They return a status, and write outputs only if it is STEWART_OK. All of them may return
 * STEWART_NOT_FINITE, STEWART_ZERO_LENGTH, STEWART_JOINT_SINGULAR, and STEWART_BAD_ARGUMENT if a pointer is null. */

/* Computes the terms of the equations of motion. */
STEWART_NODISCARD int stewart_exact_drive_equations(
    const stewart_exact_drive_model *model, const stewart_motion *motion, stewart_equations *out);
/* Computes C [v; omega] + g + friction (N and N m), base frame. */
STEWART_NODISCARD int stewart_exact_drive_bias_and_friction(
    const stewart_exact_drive_model *model, const stewart_motion *motion,
    stewart_real bias_and_friction[6]);
/* Computes the acceleration [a; alpha] (m/s^2 and rad/s^2, base frame) caused by the actuator forces F
 * (N). Also returns STEWART_MASS_MATRIX_INDEFINITE. */
STEWART_NODISCARD int stewart_exact_drive_forward_dynamics(
    const stewart_exact_drive_model *model, const stewart_motion *motion, const stewart_real F[6],
    stewart_real acceleration[6]);
/* Computes the inertia seen by the actuators (kg), H^-1 M H^-T, row-major. The length rates are H^T [v;
 * omega]. Also returns STEWART_SINGULAR. */
STEWART_NODISCARD int stewart_exact_drive_joint_inertia(
    const stewart_exact_drive_model *model, const stewart_motion *motion, stewart_real inertia[36]);
/* Computes the actuator forces of inverse dynamics and their derivatives. Also returns STEWART_SINGULAR. */
STEWART_NODISCARD int stewart_exact_drive_derivatives(
    const stewart_exact_drive_model *model, const stewart_motion *motion, stewart_derivatives *out);
/* Computes the forward dynamics for the actuator forces F (N) and its linearization. Also returns
 * STEWART_MASS_MATRIX_INDEFINITE. */
STEWART_NODISCARD int stewart_exact_drive_linearization(
    const stewart_exact_drive_model *model, const stewart_motion *motion, const stewart_real F[6],
    stewart_linearization *out);

/* Functions for `count` poses. F is [count][6]. `out` is an array with one row for each pose, or a structure of such
 * arrays. F_ext and M_ext of the motions may be null, and alpha and a if they are not read. `status` receives the code
 * of each pose and may be null. The functions return the first code other than STEWART_OK, or STEWART_OK.
 * STEWART_BAD_ARGUMENT: another pointer is null; then nothing is written. */
STEWART_NODISCARD int stewart_exact_drive_equations_batch(
    const stewart_exact_drive_model *model, size_t count, const stewart_motions *motions,
    const stewart_equations_arrays *out, int *status);
STEWART_NODISCARD int stewart_exact_drive_derivatives_batch(
    const stewart_exact_drive_model *model, size_t count, const stewart_motions *motions,
    const stewart_derivatives_arrays *out, int *status);
STEWART_NODISCARD int stewart_exact_drive_linearization_batch(
    const stewart_exact_drive_model *model, size_t count, const stewart_motions *motions,
    const stewart_real *F, const stewart_linearization_arrays *out, int *status);
STEWART_NODISCARD int stewart_exact_drive_bias_and_friction_batch(
    const stewart_exact_drive_model *model, size_t count, const stewart_motions *motions, stewart_real *out,
    int *status);
STEWART_NODISCARD int stewart_exact_drive_forward_dynamics_batch(
    const stewart_exact_drive_model *model, size_t count, const stewart_motions *motions,
    const stewart_real *F, stewart_real *out, int *status);
STEWART_NODISCARD int stewart_exact_drive_joint_inertia_batch(
    const stewart_exact_drive_model *model, size_t count, const stewart_motions *motions, stewart_real *out,
    int *status);

#ifdef __cplusplus
}
#endif

#endif
