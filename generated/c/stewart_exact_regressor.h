/* stewart_exact_regressor.h: regressor, the matrix Y of the equations of motion that are linear in the parameters.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 *     H F + [R F_ext; R M_ext] = Y pi
 *
 * pi has 148 parameters. Each leg has 23: mass m_d, first moment h_d[3], and inertia J_d[6] (xx xy xz yy yz zz)
 * of the lower part about the base point, frame D; m_u, h_u[3], and J_u[6] of the upper part about the platform point,
 * frame U; C_u, C_p, C_s. The platform has 10: M, h_P[3], and J_P[6] about its reference point, platform frame. Y is
 * row-major: three rows of forces (N) and three rows of moments (N m) about the reference point, base frame, each
 * divided by the unit of its parameter. Of the robot only b, p, k, and g are read; of the motion everything except the
 * load.
 *
 * The forces depend on fewer combinations of the parameters, the base parameters. `base_parameters` of the Python
 * package computes them for a robot, with their columns of Y: `independent_columns`.
 *
 * Operations per pose: 3963 (2574 mul, 1365 add, 12 div, 12 sqrt).
 */
#ifndef STEWART_EXACT_REGRESSOR_H
#define STEWART_EXACT_REGRESSOR_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Regressor Y[6][width] of one pose: the columns that `columns` numbers, from 0, or all, with null for
 * `columns` and 0 for `width`. Returns a status: STEWART_BAD_ARGUMENT also for a column that there is
 * not. Y is written only if it is STEWART_OK. */
STEWART_NODISCARD int stewart_exact_regressor(
    const stewart_robot *robot, const stewart_motion *motion, const int *columns, size_t width,
    stewart_real *Y);

/* Regressors Y[count][6][width] of `count` poses. `status` takes one code for each pose; null: not
 * wanted. Returns the first code other than STEWART_OK, or STEWART_OK. No pose's result depends on the
 * others. */
STEWART_NODISCARD int stewart_exact_regressor_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const int *columns,
    size_t width, stewart_real *Y, int *status);

#ifdef __cplusplus
}
#endif

#endif
