/* stewart_exact_regressor.h: regressor, the matrix Y of the equations of motion that are linear in the parameters.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 *     H F + [R F_ext; R M_ext] = Y pi
 *
 * pi has 148 parameters. Each leg has 23: mass m_d, first moment h_d[3], and inertia J_d[6] (xx xy xz yy yz zz)
 * of the lower part about the base point, frame D. The next are m_u, h_u[3], and J_u[6] of the upper part about the
 * platform point, frame U, and C_u, C_p, and C_s. The platform has 10: M, h_P[3], and J_P[6] about its reference
 * point, platform frame. Y is row-major: three rows of forces (N) and three rows of moments (N m) about the reference
 * point, base frame, each divided by the unit of its parameter. The functions read b, p, k, and g of the robot, and
 * the motion without F_ext and M_ext. The vectors k must have length 1.
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

/* Computes the regressor Y[6][width] of one pose. `columns` contains the indices of `width` columns,
 * from 0. For all 148 columns, Y[6][148], `columns` is null and `width` 0. Returns a status, and writes
 * Y only if it is STEWART_OK. Other statuses: STEWART_NOT_FINITE, STEWART_ZERO_LENGTH,
 * STEWART_JOINT_SINGULAR, and STEWART_BAD_ARGUMENT if another pointer is null, an index is out of range,
 * or `columns` is null and `width` is not 0. */
STEWART_NODISCARD int stewart_exact_regressor(
    const stewart_robot *robot, const stewart_motion *motion, const int *columns, size_t width,
    stewart_real *Y);

/* Computes the regressors Y[count][6][width] of `count` poses. `status` receives the code of each pose
 * and may be null. F_ext and M_ext of the motions are not read. Returns the first code other than
 * STEWART_OK, or STEWART_OK. A pose with another code keeps its old numbers in Y and does not affect the
 * other poses. STEWART_BAD_ARGUMENT: as above, or R, t, omega, v, alpha, or a of the motions is null. */
STEWART_NODISCARD int stewart_exact_regressor_batch(
    const stewart_robot *robot, size_t count, const stewart_motions *motions, const int *columns,
    size_t width, stewart_real *Y, int *status);

#ifdef __cplusplus
}
#endif

#endif
