/* stewart_lanes.h: moments about platform point 1 and the linear solver, for one pose and for a block of poses in
 * lanes, included by the sources of kernels.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#ifndef STEWART_LANES_H
#define STEWART_LANES_H

#include "stewart_solve.h"

/* Force of a leg, (37). Sources of kernels whose legs have no D define it as -x. gcc would then create a
 * copy of the solver without D that keeps fewer numbers in registers; STEWART_NO_COPY prevents this. */
#if !defined(STEWART_FORCE)
#define STEWART_FORCE(D, x) ((D) - (x))
#endif
#if defined(__GNUC__) && !defined(__clang__)
#define STEWART_NO_COPY __attribute__((noclone))
#else
#define STEWART_NO_COPY
#endif

/* Exchanges two rows. */
STEWART_SHARED void exchange_rows(
    stewart_real *STEWART_RESTRICT upper, stewart_real *STEWART_RESTRICT lower)
{
    int j;
    for (j = 0; j < LANES; ++j) {
        const stewart_real moved = upper[j];
        upper[j] = lower[j];
        lower[j] = moved;
    }
}

/* Subtracts a multiple of a row from another. */
STEWART_SHARED void subtract_row(
    stewart_real *STEWART_RESTRICT to, stewart_real factor, const stewart_real *STEWART_RESTRICT row)
{
    int j;
    for (j = 0; j < LANES; ++j) {
        to[j] = STEWART_FMA(-factor, row[j], to[j]);
    }
}

/* Solves H x = c for x in two blocks of three legs. The first six lanes of the rows A are H. Returns 1
 * if the blocks are too inaccurate and pivots are required, else 0. */
STEWART_SHARED stewart_real blocks_of_pose(
    stewart_real A[6][LANES], const stewart_real wrench[6], stewart_real arm_cube, stewart_real x[6])
{
    int l;
    const stewart_real r_0_0 = STEWART_FMA(-A[2][3], A[1][5], A[1][3]*A[2][5]);
    const stewart_real r_0_1 = STEWART_FMA(-A[0][3], A[2][5], A[2][3]*A[0][5]);
    const stewart_real r_0_2 = STEWART_FMA(-A[1][3], A[0][5], A[0][3]*A[1][5]);
    const stewart_real r_1_0 = STEWART_FMA(-A[2][5], A[1][1], A[1][5]*A[2][1]);
    const stewart_real r_1_1 = STEWART_FMA(-A[0][5], A[2][1], A[2][5]*A[0][1]);
    const stewart_real r_1_2 = STEWART_FMA(-A[1][5], A[0][1], A[0][5]*A[1][1]);
    const stewart_real r_2_0 = STEWART_FMA(-A[2][1], A[1][3], A[1][1]*A[2][3]);
    const stewart_real r_2_1 = STEWART_FMA(-A[0][1], A[2][3], A[2][1]*A[0][3]);
    const stewart_real r_2_2 = STEWART_FMA(-A[1][1], A[0][3], A[0][1]*A[1][3]);
    const stewart_real det = STEWART_FMA(A[2][1], r_0_2, STEWART_FMA(A[1][1], r_0_1, A[0][1]*r_0_0));
    stewart_real balanced[3][LANES];
    stewart_real left[3][LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real of_0 = STEWART_FMA(r_0_2, A[2][l], STEWART_FMA(r_0_1, A[1][l], r_0_0*A[0][l]));
        balanced[0][l] = of_0;
        const stewart_real of_1 = STEWART_FMA(r_1_2, A[2][l], STEWART_FMA(r_1_1, A[1][l], r_1_0*A[0][l]));
        balanced[1][l] = of_1;
        const stewart_real of_2 = STEWART_FMA(r_2_2, A[2][l], STEWART_FMA(r_2_1, A[1][l], r_2_0*A[0][l]));
        balanced[2][l] = of_2;
        left[0][l] = STEWART_FMA(-A[3][5], of_2, STEWART_FMA(-A[3][3], of_1, STEWART_FMA(-A[3][1], of_0,
            det*A[3][l])));
        left[1][l] = STEWART_FMA(-A[4][5], of_2, STEWART_FMA(-A[4][3], of_1, STEWART_FMA(-A[4][1], of_0,
            det*A[4][l])));
        left[2][l] = STEWART_FMA(-A[5][5], of_2, STEWART_FMA(-A[5][3], of_1, STEWART_FMA(-A[5][1], of_0,
            det*A[5][l])));
    }
    const stewart_real e_0_0 = balanced[0][0];
    const stewart_real w_0_0 = left[0][0];
    const stewart_real e_0_2 = balanced[0][2];
    const stewart_real w_0_2 = left[0][2];
    const stewart_real e_0_4 = balanced[0][4];
    const stewart_real w_0_4 = left[0][4];
    const stewart_real e_1_0 = balanced[1][0];
    const stewart_real w_1_0 = left[1][0];
    const stewart_real e_1_2 = balanced[1][2];
    const stewart_real w_1_2 = left[1][2];
    const stewart_real e_1_4 = balanced[1][4];
    const stewart_real w_1_4 = left[1][4];
    const stewart_real e_2_0 = balanced[2][0];
    const stewart_real w_2_0 = left[2][0];
    const stewart_real e_2_2 = balanced[2][2];
    const stewart_real w_2_2 = left[2][2];
    const stewart_real e_2_4 = balanced[2][4];
    const stewart_real w_2_4 = left[2][4];
    const stewart_real e_0_6 = STEWART_FMA(r_0_2, wrench[2], STEWART_FMA(r_0_1, wrench[1],
        r_0_0*wrench[0]));
    const stewart_real e_1_6 = STEWART_FMA(r_1_2, wrench[2], STEWART_FMA(r_1_1, wrench[1],
        r_1_0*wrench[0]));
    const stewart_real e_2_6 = STEWART_FMA(r_2_2, wrench[2], STEWART_FMA(r_2_1, wrench[1],
        r_2_0*wrench[0]));
    const stewart_real w_0_6 = STEWART_FMA(-A[3][5], e_2_6, STEWART_FMA(-A[3][3], e_1_6,
        STEWART_FMA(-A[3][1], e_0_6, det*wrench[3])));
    const stewart_real w_1_6 = STEWART_FMA(-A[4][5], e_2_6, STEWART_FMA(-A[4][3], e_1_6,
        STEWART_FMA(-A[4][1], e_0_6, det*wrench[4])));
    const stewart_real w_2_6 = STEWART_FMA(-A[5][5], e_2_6, STEWART_FMA(-A[5][3], e_1_6,
        STEWART_FMA(-A[5][1], e_0_6, det*wrench[5])));
    const stewart_real u_0_0 = STEWART_FMA(-w_2_2, w_1_4, w_1_2*w_2_4);
    const stewart_real u_0_1 = STEWART_FMA(-w_0_2, w_2_4, w_2_2*w_0_4);
    const stewart_real u_0_2 = STEWART_FMA(-w_1_2, w_0_4, w_0_2*w_1_4);
    const stewart_real u_1_0 = STEWART_FMA(-w_2_4, w_1_0, w_1_4*w_2_0);
    const stewart_real u_1_1 = STEWART_FMA(-w_0_4, w_2_0, w_2_4*w_0_0);
    const stewart_real u_1_2 = STEWART_FMA(-w_1_4, w_0_0, w_0_4*w_1_0);
    const stewart_real u_2_0 = STEWART_FMA(-w_2_0, w_1_2, w_1_0*w_2_2);
    const stewart_real u_2_1 = STEWART_FMA(-w_0_0, w_2_2, w_2_0*w_0_2);
    const stewart_real u_2_2 = STEWART_FMA(-w_1_0, w_0_2, w_0_0*w_1_2);
    const stewart_real complement = STEWART_FMA(w_2_0, u_0_2, STEWART_FMA(w_1_0, u_0_1, w_0_0*u_0_0));
    const stewart_real square_0 = STEWART_FMA(e_0_4, e_0_4, STEWART_FMA(e_0_2, e_0_2, e_0_0*e_0_0));
    const stewart_real square_1 = STEWART_FMA(e_1_4, e_1_4, STEWART_FMA(e_1_2, e_1_2, e_1_0*e_1_0));
    const stewart_real square_2 = STEWART_FMA(e_2_4, e_2_4, STEWART_FMA(e_2_2, e_2_2, e_2_0*e_2_0));
    const stewart_real det2 = det*det;
    const stewart_real least = STEWART_LARGER(STEWART_FABS(det)*STEWART_BLOCK_LEAST,
        STEWART_BLOCK_SINGULAR)*(det2*arm_cube);
    const stewart_real spread = square_0 + square_1 + square_2;
    stewart_real weak = spread > STEWART_BLOCK_GROWTH*det2 ? REAL(1) : REAL(0);
    weak = STEWART_FABS(complement) <= least ? REAL(1) : weak;
    const stewart_real inverse_det = REAL(1)/det;
    const stewart_real inverse_complement = REAL(1)/complement;
    x[0] = STEWART_FMA(u_0_2, w_2_6, STEWART_FMA(u_0_1, w_1_6, u_0_0*w_0_6))*inverse_complement;
    x[2] = STEWART_FMA(u_1_2, w_2_6, STEWART_FMA(u_1_1, w_1_6, u_1_0*w_0_6))*inverse_complement;
    x[4] = STEWART_FMA(u_2_2, w_2_6, STEWART_FMA(u_2_1, w_1_6, u_2_0*w_0_6))*inverse_complement;
    x[1] = STEWART_FMA(-e_0_4, x[4], STEWART_FMA(-e_0_2, x[2], STEWART_FMA(-e_0_0, x[0],
        e_0_6)))*inverse_det;
    x[3] = STEWART_FMA(-e_1_4, x[4], STEWART_FMA(-e_1_2, x[2], STEWART_FMA(-e_1_0, x[0],
        e_1_6)))*inverse_det;
    x[5] = STEWART_FMA(-e_2_4, x[4], STEWART_FMA(-e_2_2, x[2], STEWART_FMA(-e_2_0, x[0],
        e_2_6)))*inverse_det;
    return weak;
}

/* Solves the augmented rows [H | c | 0] for x by elimination with partial pivoting, (36). Returns 1 if a
 * pivot is small, else 0. Whole rows are updated, so a row is one vector. The next column is computed
 * before its rows are stored. With moments about platform point 1 the first column has no moments. */
STEWART_APART STEWART_SHARED int pivots_of_pose(
    stewart_real H[6][LANES], const stewart_real wrench[6], stewart_real x[6])
{
    int i, l;
    stewart_real A[6][LANES];
    for (i = 0; i < 6; ++i) {
        for (l = 0; l < LANES; ++l) {
            A[i][l] = H[i][l];
        }
        A[i][6] = wrench[i];
        A[i][7] = REAL(0);
    }
    stewart_real a_0 = A[0][0], a_1 = A[1][0], a_2 = A[2][0];
    if (STEWART_FABS(a_1) > STEWART_FABS(a_0)) {
        const stewart_real moved = a_0;
        exchange_rows(A[0], A[1]);
        a_0 = a_1;
        a_1 = moved;
    }
    if (STEWART_FABS(a_2) > STEWART_FABS(a_0)) {
        const stewart_real moved = a_0;
        exchange_rows(A[0], A[2]);
        a_0 = a_2;
        a_2 = moved;
    }
    const stewart_real inverse_0 = REAL(1)/a_0;
    const stewart_real factor_1_0 = a_1*inverse_0;
    const stewart_real factor_2_0 = a_2*inverse_0;
    a_1 = STEWART_FMA(-factor_1_0, A[0][1], A[1][1]);
    a_2 = STEWART_FMA(-factor_2_0, A[0][1], A[2][1]);
    stewart_real a_3 = A[3][1], a_4 = A[4][1], a_5 = A[5][1];
    subtract_row(A[1], factor_1_0, A[0]);
    subtract_row(A[2], factor_2_0, A[0]);
    if (STEWART_FABS(a_2) > STEWART_FABS(a_1)) {
        const stewart_real moved = a_1;
        exchange_rows(A[1], A[2]);
        a_1 = a_2;
        a_2 = moved;
    }
    if (STEWART_FABS(a_3) > STEWART_FABS(a_1)) {
        const stewart_real moved = a_1;
        exchange_rows(A[1], A[3]);
        a_1 = a_3;
        a_3 = moved;
    }
    if (STEWART_FABS(a_4) > STEWART_FABS(a_1)) {
        const stewart_real moved = a_1;
        exchange_rows(A[1], A[4]);
        a_1 = a_4;
        a_4 = moved;
    }
    if (STEWART_FABS(a_5) > STEWART_FABS(a_1)) {
        const stewart_real moved = a_1;
        exchange_rows(A[1], A[5]);
        a_1 = a_5;
        a_5 = moved;
    }
    const stewart_real inverse_1 = REAL(1)/a_1;
    const stewart_real factor_2_1 = a_2*inverse_1;
    const stewart_real factor_3_1 = a_3*inverse_1;
    const stewart_real factor_4_1 = a_4*inverse_1;
    const stewart_real factor_5_1 = a_5*inverse_1;
    a_2 = STEWART_FMA(-factor_2_1, A[1][2], A[2][2]);
    a_3 = STEWART_FMA(-factor_3_1, A[1][2], A[3][2]);
    a_4 = STEWART_FMA(-factor_4_1, A[1][2], A[4][2]);
    a_5 = STEWART_FMA(-factor_5_1, A[1][2], A[5][2]);
    subtract_row(A[2], factor_2_1, A[1]);
    subtract_row(A[3], factor_3_1, A[1]);
    subtract_row(A[4], factor_4_1, A[1]);
    subtract_row(A[5], factor_5_1, A[1]);
    if (STEWART_FABS(a_3) > STEWART_FABS(a_2)) {
        const stewart_real moved = a_2;
        exchange_rows(A[2], A[3]);
        a_2 = a_3;
        a_3 = moved;
    }
    if (STEWART_FABS(a_4) > STEWART_FABS(a_2)) {
        const stewart_real moved = a_2;
        exchange_rows(A[2], A[4]);
        a_2 = a_4;
        a_4 = moved;
    }
    if (STEWART_FABS(a_5) > STEWART_FABS(a_2)) {
        const stewart_real moved = a_2;
        exchange_rows(A[2], A[5]);
        a_2 = a_5;
        a_5 = moved;
    }
    const stewart_real inverse_2 = REAL(1)/a_2;
    const stewart_real factor_3_2 = a_3*inverse_2;
    const stewart_real factor_4_2 = a_4*inverse_2;
    const stewart_real factor_5_2 = a_5*inverse_2;
    a_3 = STEWART_FMA(-factor_3_2, A[2][3], A[3][3]);
    a_4 = STEWART_FMA(-factor_4_2, A[2][3], A[4][3]);
    a_5 = STEWART_FMA(-factor_5_2, A[2][3], A[5][3]);
    subtract_row(A[3], factor_3_2, A[2]);
    subtract_row(A[4], factor_4_2, A[2]);
    subtract_row(A[5], factor_5_2, A[2]);
    if (STEWART_FABS(a_4) > STEWART_FABS(a_3)) {
        const stewart_real moved = a_3;
        exchange_rows(A[3], A[4]);
        a_3 = a_4;
        a_4 = moved;
    }
    if (STEWART_FABS(a_5) > STEWART_FABS(a_3)) {
        const stewart_real moved = a_3;
        exchange_rows(A[3], A[5]);
        a_3 = a_5;
        a_5 = moved;
    }
    const stewart_real inverse_3 = REAL(1)/a_3;
    const stewart_real factor_4_3 = a_4*inverse_3;
    const stewart_real factor_5_3 = a_5*inverse_3;
    a_4 = STEWART_FMA(-factor_4_3, A[3][4], A[4][4]);
    a_5 = STEWART_FMA(-factor_5_3, A[3][4], A[5][4]);
    subtract_row(A[4], factor_4_3, A[3]);
    subtract_row(A[5], factor_5_3, A[3]);
    if (STEWART_FABS(a_5) > STEWART_FABS(a_4)) {
        const stewart_real moved = a_4;
        exchange_rows(A[4], A[5]);
        a_4 = a_5;
        a_5 = moved;
    }
    const stewart_real inverse_4 = REAL(1)/a_4;
    const stewart_real factor_5_4 = a_5*inverse_4;
    a_5 = STEWART_FMA(-factor_5_4, A[4][5], A[5][5]);
    subtract_row(A[5], factor_5_4, A[4]);
    const stewart_real total_5 = A[5][6];
    x[5] = total_5/a_5;
    stewart_real total_4 = A[4][6];
    total_4 = STEWART_FMA(-A[4][5], x[5], total_4);
    x[4] = total_4*inverse_4;
    stewart_real total_3 = A[3][6];
    total_3 = STEWART_FMA(-A[3][4], x[4], total_3);
    total_3 = STEWART_FMA(-A[3][5], x[5], total_3);
    x[3] = total_3*inverse_3;
    stewart_real total_2 = A[2][6];
    total_2 = STEWART_FMA(-A[2][3], x[3], total_2);
    total_2 = STEWART_FMA(-A[2][4], x[4], total_2);
    total_2 = STEWART_FMA(-A[2][5], x[5], total_2);
    x[2] = total_2*inverse_2;
    stewart_real total_1 = A[1][6];
    total_1 = STEWART_FMA(-A[1][2], x[2], total_1);
    total_1 = STEWART_FMA(-A[1][3], x[3], total_1);
    total_1 = STEWART_FMA(-A[1][4], x[4], total_1);
    total_1 = STEWART_FMA(-A[1][5], x[5], total_1);
    x[1] = total_1*inverse_1;
    stewart_real total_0 = A[0][6];
    total_0 = STEWART_FMA(-A[0][1], x[1], total_0);
    total_0 = STEWART_FMA(-A[0][2], x[2], total_0);
    total_0 = STEWART_FMA(-A[0][3], x[3], total_0);
    total_0 = STEWART_FMA(-A[0][4], x[4], total_0);
    total_0 = STEWART_FMA(-A[0][5], x[5], total_0);
    x[0] = total_0*inverse_0;
    return (STEWART_FABS(a_0) > STEWART_SUSPECT && STEWART_FABS(a_1) > STEWART_SUSPECT && STEWART_FABS(a_2) > STEWART_SUSPECT
        && STEWART_FABS(a_3) > STEWART_SUSPECT && STEWART_FABS(a_4) > STEWART_SUSPECT && STEWART_FABS(a_5) > STEWART_SUSPECT)
        ? 0 : 1;
}

/* Solves H x = c for x, (36), in two blocks, or by pivots if the blocks are too inaccurate. Returns 1 if
 * a pivot is small, else 0. */
STEWART_SHARED int solve_pose(
    stewart_real A[6][LANES], const stewart_real wrench[6], stewart_real arm_cube, stewart_real x[6])
{
    int suspect = 0;
    const stewart_real wanted = blocks_of_pose(A, wrench, arm_cube, x);
    if (wanted > REAL(0)) {
        suspect = pivots_of_pose(A, wrench, x);
    }
    return suspect;
}

/* Moves the platform's part of c to moments about platform point 1. */
STEWART_SHARED void shift_of_pose(
    stewart_real (*STEWART_RESTRICT q)[LANES], const stewart_real *STEWART_RESTRICT c_force,
    const stewart_real *STEWART_RESTRICT c_moment, stewart_real *STEWART_RESTRICT c_tip)
{
    const stewart_real q_1_x = q[0][0], q_1_y = q[1][0], q_1_z = q[2][0];
    const stewart_real c_force_x = c_force[0], c_force_y = c_force[1], c_force_z = c_force[2];
    const stewart_real c_moment_x = c_moment[0], c_moment_y = c_moment[1], c_moment_z = c_moment[2];
    c_tip[0] = STEWART_FMA(-c_force_z, q_1_y, STEWART_FMA(c_force_y, q_1_z, c_moment_x));
    c_tip[1] = STEWART_FMA(-c_force_x, q_1_z, STEWART_FMA(c_force_z, q_1_x, c_moment_y));
    c_tip[2] = STEWART_FMA(-c_force_y, q_1_x, STEWART_FMA(c_force_x, q_1_y, c_moment_z));
}

/* Computes the moments of the legs of a pose about platform point 1, 21 (12 mul, 9 add, 0 div, 0 sqrt)
 * operations each. Leg 1 has none. */
STEWART_SHARED void moments_of_pose(
    stewart_real (*STEWART_RESTRICT q)[LANES], stewart_real (*STEWART_RESTRICT A)[LANES],
    stewart_real (*STEWART_RESTRICT c_force)[LANES], stewart_real (*STEWART_RESTRICT arm_c)[LANES])
{
    int l;
    const stewart_real q_1_x = q[0][0], q_1_y = q[1][0], q_1_z = q[2][0];
    for (l = 0; l < LANES; ++l) {
        const stewart_real q_x = q[0][l], q_y = q[1][l], q_z = q[2][l];
        const stewart_real H_force_x = A[0][l], H_force_y = A[1][l], H_force_z = A[2][l];
        const stewart_real c_force_x = c_force[0][l], c_force_y = c_force[1][l], c_force_z = c_force[2][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - q_1_x;
        const stewart_real arm_y = q_y - q_1_y;
        const stewart_real arm_z = q_z - q_1_z;
        A[3][l] = STEWART_FMA(-H_force_y, arm_z, H_force_z*arm_y);
        A[4][l] = STEWART_FMA(-H_force_z, arm_x, H_force_x*arm_z);
        A[5][l] = STEWART_FMA(-H_force_x, arm_y, H_force_y*arm_x);
        arm_c[0][l] = STEWART_FMA(-arm_z, c_force_y, arm_y*c_force_z);
        arm_c[1][l] = STEWART_FMA(-arm_x, c_force_z, arm_z*c_force_x);
        arm_c[2][l] = STEWART_FMA(-arm_y, c_force_x, arm_x*c_force_y);
    }
}

/* Computes the moments of the legs of a pose about platform point 1, 12 (6 mul, 6 add, 0 div, 0 sqrt)
 * operations each. Leg 1 has none. */
STEWART_SHARED void moments_of_pose_without_c(
    stewart_real (*STEWART_RESTRICT q)[LANES], stewart_real (*STEWART_RESTRICT A)[LANES])
{
    int l;
    const stewart_real q_1_x = q[0][0], q_1_y = q[1][0], q_1_z = q[2][0];
    for (l = 0; l < LANES; ++l) {
        const stewart_real q_x = q[0][l], q_y = q[1][l], q_z = q[2][l];
        const stewart_real H_force_x = A[0][l], H_force_y = A[1][l], H_force_z = A[2][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - q_1_x;
        const stewart_real arm_y = q_y - q_1_y;
        const stewart_real arm_z = q_z - q_1_z;
        A[3][l] = STEWART_FMA(-H_force_y, arm_z, H_force_z*arm_y);
        A[4][l] = STEWART_FMA(-H_force_z, arm_x, H_force_x*arm_z);
        A[5][l] = STEWART_FMA(-H_force_x, arm_y, H_force_y*arm_x);
    }
}

/* Moves the platform's part of c of a block of poses to platform point 1, and adds the part of leg 1. */
STEWART_SHARED void moments_of_first(
    stewart_real (*STEWART_RESTRICT q)[POSES], stewart_real (*STEWART_RESTRICT c_force)[POSES],
    stewart_real (*STEWART_RESTRICT c_moment)[POSES], stewart_real (*STEWART_RESTRICT c)[POSES])
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real q_1_x = q[0][l], q_1_y = q[1][l], q_1_z = q[2][l];
        const stewart_real c_force_x = c[0][l], c_force_y = c[1][l], c_force_z = c[2][l], c_moment_x = c[3][l],
            c_moment_y = c[4][l], c_moment_z = c[5][l];
        c[3][l] = STEWART_FMA(-c_force_z, q_1_y, STEWART_FMA(c_force_y, q_1_z, c_moment_x));
        c[4][l] = STEWART_FMA(-c_force_x, q_1_z, STEWART_FMA(c_force_z, q_1_x, c_moment_y));
        c[5][l] = STEWART_FMA(-c_force_y, q_1_x, STEWART_FMA(c_force_x, q_1_y, c_moment_z));
        c[0][l] = c[0][l] + c_force[0][l];
        c[1][l] = c[1][l] + c_force[1][l];
        c[2][l] = c[2][l] + c_force[2][l];
        c[3][l] = c[3][l] + c_moment[0][l];
        c[4][l] = c[4][l] + c_moment[1][l];
        c[5][l] = c[5][l] + c_moment[2][l];
    }
}

/* Computes the moments of legs 2 to 6 about platform point 1, 21 (12 mul, 9 add, 0 div, 0 sqrt)
 * operations each, and adds their parts of c. */
STEWART_SHARED void moments_of_block(
    stewart_real (*STEWART_RESTRICT q)[POSES], stewart_real (*STEWART_RESTRICT q_1)[POSES],
    stewart_real (*STEWART_RESTRICT c_force)[POSES], stewart_real (*STEWART_RESTRICT c_moment)[POSES],
    stewart_real (*STEWART_RESTRICT column)[POSES], stewart_real (*STEWART_RESTRICT c)[POSES])
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real q_x = q[0][l], q_y = q[1][l], q_z = q[2][l];
        const stewart_real q_1_x = q_1[0][l], q_1_y = q_1[1][l], q_1_z = q_1[2][l];
        const stewart_real H_force_x = column[0][l], H_force_y = column[1][l], H_force_z = column[2][l];
        const stewart_real c_force_x = c_force[0][l], c_force_y = c_force[1][l], c_force_z = c_force[2][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - q_1_x;
        const stewart_real arm_y = q_y - q_1_y;
        const stewart_real arm_z = q_z - q_1_z;
        column[3][l] = STEWART_FMA(-H_force_y, arm_z, H_force_z*arm_y);
        column[4][l] = STEWART_FMA(-H_force_z, arm_x, H_force_x*arm_z);
        column[5][l] = STEWART_FMA(-H_force_x, arm_y, H_force_y*arm_x);
        c[0][l] = c[0][l] + c_force[0][l];
        c[1][l] = c[1][l] + c_force[1][l];
        c[2][l] = c[2][l] + c_force[2][l];
        c[3][l] = c[3][l] + c_moment[0][l];
        c[4][l] = c[4][l] + c_moment[1][l];
        c[5][l] = c[5][l] + c_moment[2][l];
        c[3][l] = c[3][l] + STEWART_FMA(-arm_z, c_force_y, arm_y*c_force_z);
        c[4][l] = c[4][l] + STEWART_FMA(-arm_x, c_force_z, arm_z*c_force_x);
        c[5][l] = c[5][l] + STEWART_FMA(-arm_y, c_force_x, arm_x*c_force_y);
    }
}

/* Moves the platform's part of c of a block of poses to platform point 1, and adds the part of leg 1. */
STEWART_SHARED void moments_of_first_without_moment(
    stewart_real (*STEWART_RESTRICT q)[POSES], stewart_real (*STEWART_RESTRICT c_force)[POSES],
    stewart_real (*STEWART_RESTRICT c)[POSES])
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real q_1_x = q[0][l], q_1_y = q[1][l], q_1_z = q[2][l];
        const stewart_real c_force_x = c[0][l], c_force_y = c[1][l], c_force_z = c[2][l], c_moment_x = c[3][l],
            c_moment_y = c[4][l], c_moment_z = c[5][l];
        c[3][l] = STEWART_FMA(-c_force_z, q_1_y, STEWART_FMA(c_force_y, q_1_z, c_moment_x));
        c[4][l] = STEWART_FMA(-c_force_x, q_1_z, STEWART_FMA(c_force_z, q_1_x, c_moment_y));
        c[5][l] = STEWART_FMA(-c_force_y, q_1_x, STEWART_FMA(c_force_x, q_1_y, c_moment_z));
        c[0][l] = c[0][l] + c_force[0][l];
        c[1][l] = c[1][l] + c_force[1][l];
        c[2][l] = c[2][l] + c_force[2][l];
    }
}

/* Computes the moments of legs 2 to 6 about platform point 1, 21 (12 mul, 9 add, 0 div, 0 sqrt)
 * operations each, and adds their parts of c. */
STEWART_SHARED void moments_of_block_without_moment(
    stewart_real (*STEWART_RESTRICT q)[POSES], stewart_real (*STEWART_RESTRICT q_1)[POSES],
    stewart_real (*STEWART_RESTRICT c_force)[POSES], stewart_real (*STEWART_RESTRICT column)[POSES],
    stewart_real (*STEWART_RESTRICT c)[POSES])
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real q_x = q[0][l], q_y = q[1][l], q_z = q[2][l];
        const stewart_real q_1_x = q_1[0][l], q_1_y = q_1[1][l], q_1_z = q_1[2][l];
        const stewart_real H_force_x = column[0][l], H_force_y = column[1][l], H_force_z = column[2][l];
        const stewart_real c_force_x = c_force[0][l], c_force_y = c_force[1][l], c_force_z = c_force[2][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - q_1_x;
        const stewart_real arm_y = q_y - q_1_y;
        const stewart_real arm_z = q_z - q_1_z;
        column[3][l] = STEWART_FMA(-H_force_y, arm_z, H_force_z*arm_y);
        column[4][l] = STEWART_FMA(-H_force_z, arm_x, H_force_x*arm_z);
        column[5][l] = STEWART_FMA(-H_force_x, arm_y, H_force_y*arm_x);
        c[0][l] = c[0][l] + c_force[0][l];
        c[1][l] = c[1][l] + c_force[1][l];
        c[2][l] = c[2][l] + c_force[2][l];
        c[3][l] = c[3][l] + STEWART_FMA(-arm_z, c_force_y, arm_y*c_force_z);
        c[4][l] = c[4][l] + STEWART_FMA(-arm_x, c_force_z, arm_z*c_force_x);
        c[5][l] = c[5][l] + STEWART_FMA(-arm_y, c_force_x, arm_x*c_force_y);
    }
}

/* Moves the platform's part of c of a block of poses to platform point 1, and adds the part of leg 1. */
STEWART_SHARED void moments_of_first_without_c(
    stewart_real (*STEWART_RESTRICT q)[POSES], stewart_real (*STEWART_RESTRICT c)[POSES])
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real q_1_x = q[0][l], q_1_y = q[1][l], q_1_z = q[2][l];
        const stewart_real c_force_x = c[0][l], c_force_y = c[1][l], c_force_z = c[2][l], c_moment_x = c[3][l],
            c_moment_y = c[4][l], c_moment_z = c[5][l];
        c[3][l] = STEWART_FMA(-c_force_z, q_1_y, STEWART_FMA(c_force_y, q_1_z, c_moment_x));
        c[4][l] = STEWART_FMA(-c_force_x, q_1_z, STEWART_FMA(c_force_z, q_1_x, c_moment_y));
        c[5][l] = STEWART_FMA(-c_force_y, q_1_x, STEWART_FMA(c_force_x, q_1_y, c_moment_z));
    }
}

/* Computes the moments of legs 2 to 6 about platform point 1, 12 (6 mul, 6 add, 0 div, 0 sqrt)
 * operations each, and adds their parts of c. */
STEWART_SHARED void moments_of_block_without_c(
    stewart_real (*STEWART_RESTRICT q)[POSES], stewart_real (*STEWART_RESTRICT q_1)[POSES],
    stewart_real (*STEWART_RESTRICT column)[POSES])
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real q_x = q[0][l], q_y = q[1][l], q_z = q[2][l];
        const stewart_real q_1_x = q_1[0][l], q_1_y = q_1[1][l], q_1_z = q_1[2][l];
        const stewart_real H_force_x = column[0][l], H_force_y = column[1][l], H_force_z = column[2][l];
        /* platform point from platform point 1 */
        const stewart_real arm_x = q_x - q_1_x;
        const stewart_real arm_y = q_y - q_1_y;
        const stewart_real arm_z = q_z - q_1_z;
        column[3][l] = STEWART_FMA(-H_force_y, arm_z, H_force_z*arm_y);
        column[4][l] = STEWART_FMA(-H_force_z, arm_x, H_force_x*arm_z);
        column[5][l] = STEWART_FMA(-H_force_x, arm_y, H_force_y*arm_x);
    }
}

/* Multiplies the moment rows of [H | c] of a pose by `per_length`. */
STEWART_SHARED void scale_pose(stewart_real A[6][LANES], stewart_real wrench[6], stewart_real per_length)
{
    int i, j;
    for (i = 3; i < 6; ++i) {
        wrench[i] = wrench[i]*per_length;
        for (j = 0; j < LANES; ++j) {
            A[i][j] = A[i][j]*per_length;
        }
    }
}

/* Multiplies the moment rows of [H | c] of a block of poses by `per_length`. */
STEWART_SHARED void scale_block(stewart_real column[7][6][POSES], stewart_real per_length)
{
    int i, j, l;
    for (i = 1; i < 7; ++i) {
        for (j = 3; j < 6; ++j) {
            for (l = 0; l < POSES; ++l) {
                column[i][j][l] = column[i][j][l]*per_length;
            }
        }
    }
}

/* Returns the status of a pose whose H may be singular to rounding. */
STEWART_APART STEWART_SHARED int rows_status(
    stewart_real A[6][LANES], stewart_real q[3][LANES], const stewart_real L[LANES],
    const stewart_real reach[LANES], stewart_real per_length)
{
    int i, j;
    stewart_real H[6][6];
    stewart_real arm[6][3];
    stewart_real tip = REAL(0);
    for (j = 0; j < 3; ++j) {
        tip = STEWART_LARGER(STEWART_FABS(q[j][0]), tip);
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            arm[i][j] = q[j][i] - q[j][0];
            H[j][i] = A[j][i];
            H[j + 3][i] = A[j + 3][i]/per_length;
        }
    }
    return singular_status(H, arm, L, reach, tip);
}

/* Solves H x = c for x in two blocks of three legs, (36), and computes F = D - x, (37), for all poses of
 * a block. The loop over lanes has no branches. Sets `bad` if a force is not finite, and `wanted` if the
 * blocks are too inaccurate and pivots are required. */
STEWART_APART STEWART_SHARED STEWART_NO_COPY void blocks_of_lanes(
    stewart_real (*STEWART_RESTRICT column)[6][POSES], stewart_real (*STEWART_RESTRICT D)[POSES],
    stewart_real arm_cube, stewart_real (*STEWART_RESTRICT F)[POSES], stewart_real *STEWART_RESTRICT bad,
    stewart_real *STEWART_RESTRICT wanted)
{
    int l;
    (void)D;
    for (l = 0; l < POSES; ++l) {
        const stewart_real a_0_0 = column[0][0][l], a_0_1 = column[1][0][l], a_0_2 = column[2][0][l], a_0_3 = column[3][0][l],
            a_0_4 = column[4][0][l], a_0_5 = column[5][0][l], a_0_6 = column[6][0][l], a_1_0 = column[0][1][l],
            a_1_1 = column[1][1][l], a_1_2 = column[2][1][l], a_1_3 = column[3][1][l], a_1_4 = column[4][1][l],
            a_1_5 = column[5][1][l], a_1_6 = column[6][1][l], a_2_0 = column[0][2][l], a_2_1 = column[1][2][l],
            a_2_2 = column[2][2][l], a_2_3 = column[3][2][l], a_2_4 = column[4][2][l], a_2_5 = column[5][2][l],
            a_2_6 = column[6][2][l], a_3_1 = column[1][3][l], a_3_2 = column[2][3][l], a_3_3 = column[3][3][l],
            a_3_4 = column[4][3][l], a_3_5 = column[5][3][l], a_3_6 = column[6][3][l], a_4_1 = column[1][4][l],
            a_4_2 = column[2][4][l], a_4_3 = column[3][4][l], a_4_4 = column[4][4][l], a_4_5 = column[5][4][l],
            a_4_6 = column[6][4][l], a_5_1 = column[1][5][l], a_5_2 = column[2][5][l], a_5_3 = column[3][5][l],
            a_5_4 = column[4][5][l], a_5_5 = column[5][5][l], a_5_6 = column[6][5][l];
        stewart_real fault = bad[l];
        const stewart_real r_0_0 = STEWART_FMA(-a_2_3, a_1_5, a_1_3*a_2_5);
        const stewart_real r_0_1 = STEWART_FMA(-a_0_3, a_2_5, a_2_3*a_0_5);
        const stewart_real r_0_2 = STEWART_FMA(-a_1_3, a_0_5, a_0_3*a_1_5);
        const stewart_real r_1_0 = STEWART_FMA(-a_2_5, a_1_1, a_1_5*a_2_1);
        const stewart_real r_1_1 = STEWART_FMA(-a_0_5, a_2_1, a_2_5*a_0_1);
        const stewart_real r_1_2 = STEWART_FMA(-a_1_5, a_0_1, a_0_5*a_1_1);
        const stewart_real r_2_0 = STEWART_FMA(-a_2_1, a_1_3, a_1_1*a_2_3);
        const stewart_real r_2_1 = STEWART_FMA(-a_0_1, a_2_3, a_2_1*a_0_3);
        const stewart_real r_2_2 = STEWART_FMA(-a_1_1, a_0_3, a_0_1*a_1_3);
        const stewart_real det = STEWART_FMA(a_2_1, r_0_2, STEWART_FMA(a_1_1, r_0_1, a_0_1*r_0_0));
        const stewart_real e_0_0 = STEWART_FMA(r_0_2, a_2_0, STEWART_FMA(r_0_1, a_1_0, r_0_0*a_0_0));
        const stewart_real e_1_0 = STEWART_FMA(r_1_2, a_2_0, STEWART_FMA(r_1_1, a_1_0, r_1_0*a_0_0));
        const stewart_real e_2_0 = STEWART_FMA(r_2_2, a_2_0, STEWART_FMA(r_2_1, a_1_0, r_2_0*a_0_0));
        const stewart_real own_0_0 = (-a_3_1)*e_0_0;
        const stewart_real w_0_0 = STEWART_FMA(-a_3_5, e_2_0, STEWART_FMA(-a_3_3, e_1_0, own_0_0));
        const stewart_real own_1_0 = (-a_4_1)*e_0_0;
        const stewart_real w_1_0 = STEWART_FMA(-a_4_5, e_2_0, STEWART_FMA(-a_4_3, e_1_0, own_1_0));
        const stewart_real own_2_0 = (-a_5_1)*e_0_0;
        const stewart_real w_2_0 = STEWART_FMA(-a_5_5, e_2_0, STEWART_FMA(-a_5_3, e_1_0, own_2_0));
        const stewart_real e_0_2 = STEWART_FMA(r_0_2, a_2_2, STEWART_FMA(r_0_1, a_1_2, r_0_0*a_0_2));
        const stewart_real e_1_2 = STEWART_FMA(r_1_2, a_2_2, STEWART_FMA(r_1_1, a_1_2, r_1_0*a_0_2));
        const stewart_real e_2_2 = STEWART_FMA(r_2_2, a_2_2, STEWART_FMA(r_2_1, a_1_2, r_2_0*a_0_2));
        const stewart_real own_0_2 = STEWART_FMA(-a_3_1, e_0_2, det*a_3_2);
        const stewart_real w_0_2 = STEWART_FMA(-a_3_5, e_2_2, STEWART_FMA(-a_3_3, e_1_2, own_0_2));
        const stewart_real own_1_2 = STEWART_FMA(-a_4_1, e_0_2, det*a_4_2);
        const stewart_real w_1_2 = STEWART_FMA(-a_4_5, e_2_2, STEWART_FMA(-a_4_3, e_1_2, own_1_2));
        const stewart_real own_2_2 = STEWART_FMA(-a_5_1, e_0_2, det*a_5_2);
        const stewart_real w_2_2 = STEWART_FMA(-a_5_5, e_2_2, STEWART_FMA(-a_5_3, e_1_2, own_2_2));
        const stewart_real e_0_4 = STEWART_FMA(r_0_2, a_2_4, STEWART_FMA(r_0_1, a_1_4, r_0_0*a_0_4));
        const stewart_real e_1_4 = STEWART_FMA(r_1_2, a_2_4, STEWART_FMA(r_1_1, a_1_4, r_1_0*a_0_4));
        const stewart_real e_2_4 = STEWART_FMA(r_2_2, a_2_4, STEWART_FMA(r_2_1, a_1_4, r_2_0*a_0_4));
        const stewart_real own_0_4 = STEWART_FMA(-a_3_1, e_0_4, det*a_3_4);
        const stewart_real w_0_4 = STEWART_FMA(-a_3_5, e_2_4, STEWART_FMA(-a_3_3, e_1_4, own_0_4));
        const stewart_real own_1_4 = STEWART_FMA(-a_4_1, e_0_4, det*a_4_4);
        const stewart_real w_1_4 = STEWART_FMA(-a_4_5, e_2_4, STEWART_FMA(-a_4_3, e_1_4, own_1_4));
        const stewart_real own_2_4 = STEWART_FMA(-a_5_1, e_0_4, det*a_5_4);
        const stewart_real w_2_4 = STEWART_FMA(-a_5_5, e_2_4, STEWART_FMA(-a_5_3, e_1_4, own_2_4));
        const stewart_real e_0_6 = STEWART_FMA(r_0_2, a_2_6, STEWART_FMA(r_0_1, a_1_6, r_0_0*a_0_6));
        const stewart_real e_1_6 = STEWART_FMA(r_1_2, a_2_6, STEWART_FMA(r_1_1, a_1_6, r_1_0*a_0_6));
        const stewart_real e_2_6 = STEWART_FMA(r_2_2, a_2_6, STEWART_FMA(r_2_1, a_1_6, r_2_0*a_0_6));
        const stewart_real own_0_6 = STEWART_FMA(-a_3_1, e_0_6, det*a_3_6);
        const stewart_real w_0_6 = STEWART_FMA(-a_3_5, e_2_6, STEWART_FMA(-a_3_3, e_1_6, own_0_6));
        const stewart_real own_1_6 = STEWART_FMA(-a_4_1, e_0_6, det*a_4_6);
        const stewart_real w_1_6 = STEWART_FMA(-a_4_5, e_2_6, STEWART_FMA(-a_4_3, e_1_6, own_1_6));
        const stewart_real own_2_6 = STEWART_FMA(-a_5_1, e_0_6, det*a_5_6);
        const stewart_real w_2_6 = STEWART_FMA(-a_5_5, e_2_6, STEWART_FMA(-a_5_3, e_1_6, own_2_6));
        const stewart_real u_0_0 = STEWART_FMA(-w_2_2, w_1_4, w_1_2*w_2_4);
        const stewart_real u_0_1 = STEWART_FMA(-w_0_2, w_2_4, w_2_2*w_0_4);
        const stewart_real u_0_2 = STEWART_FMA(-w_1_2, w_0_4, w_0_2*w_1_4);
        const stewart_real u_1_0 = STEWART_FMA(-w_2_4, w_1_0, w_1_4*w_2_0);
        const stewart_real u_1_1 = STEWART_FMA(-w_0_4, w_2_0, w_2_4*w_0_0);
        const stewart_real u_1_2 = STEWART_FMA(-w_1_4, w_0_0, w_0_4*w_1_0);
        const stewart_real u_2_0 = STEWART_FMA(-w_2_0, w_1_2, w_1_0*w_2_2);
        const stewart_real u_2_1 = STEWART_FMA(-w_0_0, w_2_2, w_2_0*w_0_2);
        const stewart_real u_2_2 = STEWART_FMA(-w_1_0, w_0_2, w_0_0*w_1_2);
        const stewart_real complement = STEWART_FMA(w_2_0, u_0_2, STEWART_FMA(w_1_0, u_0_1, w_0_0*u_0_0));
        const stewart_real square_0 = STEWART_FMA(e_0_4, e_0_4, STEWART_FMA(e_0_2, e_0_2, e_0_0*e_0_0));
        const stewart_real square_1 = STEWART_FMA(e_1_4, e_1_4, STEWART_FMA(e_1_2, e_1_2, e_1_0*e_1_0));
        const stewart_real square_2 = STEWART_FMA(e_2_4, e_2_4, STEWART_FMA(e_2_2, e_2_2, e_2_0*e_2_0));
        const stewart_real det2 = det*det;
        const stewart_real least = STEWART_LARGER(STEWART_FABS(det)*STEWART_BLOCK_LEAST,
            STEWART_BLOCK_SINGULAR)*(det2*arm_cube);
        const stewart_real spread = square_0 + square_1 + square_2;
        stewart_real weak = spread > STEWART_BLOCK_GROWTH*det2 ? REAL(1) : REAL(0);
        weak = STEWART_FABS(complement) <= least ? REAL(1) : weak;
        const stewart_real inverse_det = REAL(1)/det;
        const stewart_real inverse_complement = REAL(1)/complement;
        const stewart_real x_0 = STEWART_FMA(u_0_2, w_2_6, STEWART_FMA(u_0_1, w_1_6,
            u_0_0*w_0_6))*inverse_complement;
        const stewart_real x_2 = STEWART_FMA(u_1_2, w_2_6, STEWART_FMA(u_1_1, w_1_6,
            u_1_0*w_0_6))*inverse_complement;
        const stewart_real x_4 = STEWART_FMA(u_2_2, w_2_6, STEWART_FMA(u_2_1, w_1_6,
            u_2_0*w_0_6))*inverse_complement;
        const stewart_real x_1 = STEWART_FMA(-e_0_4, x_4, STEWART_FMA(-e_0_2, x_2, STEWART_FMA(-e_0_0, x_0,
            e_0_6)))*inverse_det;
        const stewart_real x_3 = STEWART_FMA(-e_1_4, x_4, STEWART_FMA(-e_1_2, x_2, STEWART_FMA(-e_1_0, x_0,
            e_1_6)))*inverse_det;
        const stewart_real x_5 = STEWART_FMA(-e_2_4, x_4, STEWART_FMA(-e_2_2, x_2, STEWART_FMA(-e_2_0, x_0,
            e_2_6)))*inverse_det;
        const stewart_real force_0 = STEWART_FORCE(D[0][l], x_0);
        fault = STEWART_FABS(force_0) <= STEWART_MAX ? fault : REAL(1);
        F[0][l] = force_0;
        const stewart_real force_1 = STEWART_FORCE(D[1][l], x_1);
        fault = STEWART_FABS(force_1) <= STEWART_MAX ? fault : REAL(1);
        F[1][l] = force_1;
        const stewart_real force_2 = STEWART_FORCE(D[2][l], x_2);
        fault = STEWART_FABS(force_2) <= STEWART_MAX ? fault : REAL(1);
        F[2][l] = force_2;
        const stewart_real force_3 = STEWART_FORCE(D[3][l], x_3);
        fault = STEWART_FABS(force_3) <= STEWART_MAX ? fault : REAL(1);
        F[3][l] = force_3;
        const stewart_real force_4 = STEWART_FORCE(D[4][l], x_4);
        fault = STEWART_FABS(force_4) <= STEWART_MAX ? fault : REAL(1);
        F[4][l] = force_4;
        const stewart_real force_5 = STEWART_FORCE(D[5][l], x_5);
        fault = STEWART_FABS(force_5) <= STEWART_MAX ? fault : REAL(1);
        F[5][l] = force_5;
        bad[l] = weak > REAL(0) ? bad[l] : fault;
        wanted[l] = weak;
    }
}

/* Solves H x = c by elimination with partial pivoting for the poses with `wanted`, and computes F = D -
 * x. The row with the largest entry moves to its place by conditional exchanges in each lane. Sets `bad`
 * if a pivot is small or a force is not finite. */
STEWART_APART STEWART_SHARED STEWART_NO_COPY void pivots_of_lanes(
    stewart_real (*STEWART_RESTRICT column)[6][POSES], stewart_real (*STEWART_RESTRICT D)[POSES],
    stewart_real (*STEWART_RESTRICT F)[POSES], stewart_real *STEWART_RESTRICT bad,
    const stewart_real *STEWART_RESTRICT wanted)
{
    int l;
    (void)D;
    for (l = 0; l < POSES; ++l) {
        stewart_real a_0_0 = column[0][0][l], a_0_1 = column[1][0][l], a_0_2 = column[2][0][l], a_0_3 = column[3][0][l],
            a_0_4 = column[4][0][l], a_0_5 = column[5][0][l], a_0_6 = column[6][0][l], a_1_0 = column[0][1][l],
            a_1_1 = column[1][1][l], a_1_2 = column[2][1][l], a_1_3 = column[3][1][l], a_1_4 = column[4][1][l],
            a_1_5 = column[5][1][l], a_1_6 = column[6][1][l], a_2_0 = column[0][2][l], a_2_1 = column[1][2][l],
            a_2_2 = column[2][2][l], a_2_3 = column[3][2][l], a_2_4 = column[4][2][l], a_2_5 = column[5][2][l],
            a_2_6 = column[6][2][l], a_3_1 = column[1][3][l], a_3_2 = column[2][3][l], a_3_3 = column[3][3][l],
            a_3_4 = column[4][3][l], a_3_5 = column[5][3][l], a_3_6 = column[6][3][l], a_4_1 = column[1][4][l],
            a_4_2 = column[2][4][l], a_4_3 = column[3][4][l], a_4_4 = column[4][4][l], a_4_5 = column[5][4][l],
            a_4_6 = column[6][4][l], a_5_1 = column[1][5][l], a_5_2 = column[2][5][l], a_5_3 = column[3][5][l],
            a_5_4 = column[4][5][l], a_5_5 = column[5][5][l], a_5_6 = column[6][5][l];
        stewart_real fault = bad[l];
        const stewart_real below_1_0 = STEWART_FABS(a_1_0) > STEWART_FABS(a_0_0) ? REAL(1) : REAL(0);
        const stewart_real above_0_0_1 = below_1_0 > REAL(0) ? a_1_0 : a_0_0;
        a_1_0 = below_1_0 > REAL(0) ? a_0_0 : a_1_0;
        a_0_0 = above_0_0_1;
        const stewart_real above_0_1_1 = below_1_0 > REAL(0) ? a_1_1 : a_0_1;
        a_1_1 = below_1_0 > REAL(0) ? a_0_1 : a_1_1;
        a_0_1 = above_0_1_1;
        const stewart_real above_0_2_1 = below_1_0 > REAL(0) ? a_1_2 : a_0_2;
        a_1_2 = below_1_0 > REAL(0) ? a_0_2 : a_1_2;
        a_0_2 = above_0_2_1;
        const stewart_real above_0_3_1 = below_1_0 > REAL(0) ? a_1_3 : a_0_3;
        a_1_3 = below_1_0 > REAL(0) ? a_0_3 : a_1_3;
        a_0_3 = above_0_3_1;
        const stewart_real above_0_4_1 = below_1_0 > REAL(0) ? a_1_4 : a_0_4;
        a_1_4 = below_1_0 > REAL(0) ? a_0_4 : a_1_4;
        a_0_4 = above_0_4_1;
        const stewart_real above_0_5_1 = below_1_0 > REAL(0) ? a_1_5 : a_0_5;
        a_1_5 = below_1_0 > REAL(0) ? a_0_5 : a_1_5;
        a_0_5 = above_0_5_1;
        const stewart_real above_0_6_1 = below_1_0 > REAL(0) ? a_1_6 : a_0_6;
        a_1_6 = below_1_0 > REAL(0) ? a_0_6 : a_1_6;
        a_0_6 = above_0_6_1;
        const stewart_real below_2_0 = STEWART_FABS(a_2_0) > STEWART_FABS(a_0_0) ? REAL(1) : REAL(0);
        const stewart_real above_0_0_2 = below_2_0 > REAL(0) ? a_2_0 : a_0_0;
        a_2_0 = below_2_0 > REAL(0) ? a_0_0 : a_2_0;
        a_0_0 = above_0_0_2;
        const stewart_real above_0_1_2 = below_2_0 > REAL(0) ? a_2_1 : a_0_1;
        a_2_1 = below_2_0 > REAL(0) ? a_0_1 : a_2_1;
        a_0_1 = above_0_1_2;
        const stewart_real above_0_2_2 = below_2_0 > REAL(0) ? a_2_2 : a_0_2;
        a_2_2 = below_2_0 > REAL(0) ? a_0_2 : a_2_2;
        a_0_2 = above_0_2_2;
        const stewart_real above_0_3_2 = below_2_0 > REAL(0) ? a_2_3 : a_0_3;
        a_2_3 = below_2_0 > REAL(0) ? a_0_3 : a_2_3;
        a_0_3 = above_0_3_2;
        const stewart_real above_0_4_2 = below_2_0 > REAL(0) ? a_2_4 : a_0_4;
        a_2_4 = below_2_0 > REAL(0) ? a_0_4 : a_2_4;
        a_0_4 = above_0_4_2;
        const stewart_real above_0_5_2 = below_2_0 > REAL(0) ? a_2_5 : a_0_5;
        a_2_5 = below_2_0 > REAL(0) ? a_0_5 : a_2_5;
        a_0_5 = above_0_5_2;
        const stewart_real above_0_6_2 = below_2_0 > REAL(0) ? a_2_6 : a_0_6;
        a_2_6 = below_2_0 > REAL(0) ? a_0_6 : a_2_6;
        a_0_6 = above_0_6_2;
        fault = STEWART_FABS(a_0_0) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real inverse_0 = REAL(1)/a_0_0;
        const stewart_real factor_1_0 = a_1_0*inverse_0;
        a_1_1 = STEWART_FMA(-factor_1_0, a_0_1, a_1_1);
        a_1_2 = STEWART_FMA(-factor_1_0, a_0_2, a_1_2);
        a_1_3 = STEWART_FMA(-factor_1_0, a_0_3, a_1_3);
        a_1_4 = STEWART_FMA(-factor_1_0, a_0_4, a_1_4);
        a_1_5 = STEWART_FMA(-factor_1_0, a_0_5, a_1_5);
        a_1_6 = STEWART_FMA(-factor_1_0, a_0_6, a_1_6);
        const stewart_real factor_2_0 = a_2_0*inverse_0;
        a_2_1 = STEWART_FMA(-factor_2_0, a_0_1, a_2_1);
        a_2_2 = STEWART_FMA(-factor_2_0, a_0_2, a_2_2);
        a_2_3 = STEWART_FMA(-factor_2_0, a_0_3, a_2_3);
        a_2_4 = STEWART_FMA(-factor_2_0, a_0_4, a_2_4);
        a_2_5 = STEWART_FMA(-factor_2_0, a_0_5, a_2_5);
        a_2_6 = STEWART_FMA(-factor_2_0, a_0_6, a_2_6);
        const stewart_real below_2_1 = STEWART_FABS(a_2_1) > STEWART_FABS(a_1_1) ? REAL(1) : REAL(0);
        const stewart_real above_1_1_2 = below_2_1 > REAL(0) ? a_2_1 : a_1_1;
        a_2_1 = below_2_1 > REAL(0) ? a_1_1 : a_2_1;
        a_1_1 = above_1_1_2;
        const stewart_real above_1_2_2 = below_2_1 > REAL(0) ? a_2_2 : a_1_2;
        a_2_2 = below_2_1 > REAL(0) ? a_1_2 : a_2_2;
        a_1_2 = above_1_2_2;
        const stewart_real above_1_3_2 = below_2_1 > REAL(0) ? a_2_3 : a_1_3;
        a_2_3 = below_2_1 > REAL(0) ? a_1_3 : a_2_3;
        a_1_3 = above_1_3_2;
        const stewart_real above_1_4_2 = below_2_1 > REAL(0) ? a_2_4 : a_1_4;
        a_2_4 = below_2_1 > REAL(0) ? a_1_4 : a_2_4;
        a_1_4 = above_1_4_2;
        const stewart_real above_1_5_2 = below_2_1 > REAL(0) ? a_2_5 : a_1_5;
        a_2_5 = below_2_1 > REAL(0) ? a_1_5 : a_2_5;
        a_1_5 = above_1_5_2;
        const stewart_real above_1_6_2 = below_2_1 > REAL(0) ? a_2_6 : a_1_6;
        a_2_6 = below_2_1 > REAL(0) ? a_1_6 : a_2_6;
        a_1_6 = above_1_6_2;
        const stewart_real below_3_1 = STEWART_FABS(a_3_1) > STEWART_FABS(a_1_1) ? REAL(1) : REAL(0);
        const stewart_real above_1_1_3 = below_3_1 > REAL(0) ? a_3_1 : a_1_1;
        a_3_1 = below_3_1 > REAL(0) ? a_1_1 : a_3_1;
        a_1_1 = above_1_1_3;
        const stewart_real above_1_2_3 = below_3_1 > REAL(0) ? a_3_2 : a_1_2;
        a_3_2 = below_3_1 > REAL(0) ? a_1_2 : a_3_2;
        a_1_2 = above_1_2_3;
        const stewart_real above_1_3_3 = below_3_1 > REAL(0) ? a_3_3 : a_1_3;
        a_3_3 = below_3_1 > REAL(0) ? a_1_3 : a_3_3;
        a_1_3 = above_1_3_3;
        const stewart_real above_1_4_3 = below_3_1 > REAL(0) ? a_3_4 : a_1_4;
        a_3_4 = below_3_1 > REAL(0) ? a_1_4 : a_3_4;
        a_1_4 = above_1_4_3;
        const stewart_real above_1_5_3 = below_3_1 > REAL(0) ? a_3_5 : a_1_5;
        a_3_5 = below_3_1 > REAL(0) ? a_1_5 : a_3_5;
        a_1_5 = above_1_5_3;
        const stewart_real above_1_6_3 = below_3_1 > REAL(0) ? a_3_6 : a_1_6;
        a_3_6 = below_3_1 > REAL(0) ? a_1_6 : a_3_6;
        a_1_6 = above_1_6_3;
        const stewart_real below_4_1 = STEWART_FABS(a_4_1) > STEWART_FABS(a_1_1) ? REAL(1) : REAL(0);
        const stewart_real above_1_1_4 = below_4_1 > REAL(0) ? a_4_1 : a_1_1;
        a_4_1 = below_4_1 > REAL(0) ? a_1_1 : a_4_1;
        a_1_1 = above_1_1_4;
        const stewart_real above_1_2_4 = below_4_1 > REAL(0) ? a_4_2 : a_1_2;
        a_4_2 = below_4_1 > REAL(0) ? a_1_2 : a_4_2;
        a_1_2 = above_1_2_4;
        const stewart_real above_1_3_4 = below_4_1 > REAL(0) ? a_4_3 : a_1_3;
        a_4_3 = below_4_1 > REAL(0) ? a_1_3 : a_4_3;
        a_1_3 = above_1_3_4;
        const stewart_real above_1_4_4 = below_4_1 > REAL(0) ? a_4_4 : a_1_4;
        a_4_4 = below_4_1 > REAL(0) ? a_1_4 : a_4_4;
        a_1_4 = above_1_4_4;
        const stewart_real above_1_5_4 = below_4_1 > REAL(0) ? a_4_5 : a_1_5;
        a_4_5 = below_4_1 > REAL(0) ? a_1_5 : a_4_5;
        a_1_5 = above_1_5_4;
        const stewart_real above_1_6_4 = below_4_1 > REAL(0) ? a_4_6 : a_1_6;
        a_4_6 = below_4_1 > REAL(0) ? a_1_6 : a_4_6;
        a_1_6 = above_1_6_4;
        const stewart_real below_5_1 = STEWART_FABS(a_5_1) > STEWART_FABS(a_1_1) ? REAL(1) : REAL(0);
        const stewart_real above_1_1_5 = below_5_1 > REAL(0) ? a_5_1 : a_1_1;
        a_5_1 = below_5_1 > REAL(0) ? a_1_1 : a_5_1;
        a_1_1 = above_1_1_5;
        const stewart_real above_1_2_5 = below_5_1 > REAL(0) ? a_5_2 : a_1_2;
        a_5_2 = below_5_1 > REAL(0) ? a_1_2 : a_5_2;
        a_1_2 = above_1_2_5;
        const stewart_real above_1_3_5 = below_5_1 > REAL(0) ? a_5_3 : a_1_3;
        a_5_3 = below_5_1 > REAL(0) ? a_1_3 : a_5_3;
        a_1_3 = above_1_3_5;
        const stewart_real above_1_4_5 = below_5_1 > REAL(0) ? a_5_4 : a_1_4;
        a_5_4 = below_5_1 > REAL(0) ? a_1_4 : a_5_4;
        a_1_4 = above_1_4_5;
        const stewart_real above_1_5_5 = below_5_1 > REAL(0) ? a_5_5 : a_1_5;
        a_5_5 = below_5_1 > REAL(0) ? a_1_5 : a_5_5;
        a_1_5 = above_1_5_5;
        const stewart_real above_1_6_5 = below_5_1 > REAL(0) ? a_5_6 : a_1_6;
        a_5_6 = below_5_1 > REAL(0) ? a_1_6 : a_5_6;
        a_1_6 = above_1_6_5;
        fault = STEWART_FABS(a_1_1) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real inverse_1 = REAL(1)/a_1_1;
        const stewart_real factor_2_1 = a_2_1*inverse_1;
        a_2_2 = STEWART_FMA(-factor_2_1, a_1_2, a_2_2);
        a_2_3 = STEWART_FMA(-factor_2_1, a_1_3, a_2_3);
        a_2_4 = STEWART_FMA(-factor_2_1, a_1_4, a_2_4);
        a_2_5 = STEWART_FMA(-factor_2_1, a_1_5, a_2_5);
        a_2_6 = STEWART_FMA(-factor_2_1, a_1_6, a_2_6);
        const stewart_real factor_3_1 = a_3_1*inverse_1;
        a_3_2 = STEWART_FMA(-factor_3_1, a_1_2, a_3_2);
        a_3_3 = STEWART_FMA(-factor_3_1, a_1_3, a_3_3);
        a_3_4 = STEWART_FMA(-factor_3_1, a_1_4, a_3_4);
        a_3_5 = STEWART_FMA(-factor_3_1, a_1_5, a_3_5);
        a_3_6 = STEWART_FMA(-factor_3_1, a_1_6, a_3_6);
        const stewart_real factor_4_1 = a_4_1*inverse_1;
        a_4_2 = STEWART_FMA(-factor_4_1, a_1_2, a_4_2);
        a_4_3 = STEWART_FMA(-factor_4_1, a_1_3, a_4_3);
        a_4_4 = STEWART_FMA(-factor_4_1, a_1_4, a_4_4);
        a_4_5 = STEWART_FMA(-factor_4_1, a_1_5, a_4_5);
        a_4_6 = STEWART_FMA(-factor_4_1, a_1_6, a_4_6);
        const stewart_real factor_5_1 = a_5_1*inverse_1;
        a_5_2 = STEWART_FMA(-factor_5_1, a_1_2, a_5_2);
        a_5_3 = STEWART_FMA(-factor_5_1, a_1_3, a_5_3);
        a_5_4 = STEWART_FMA(-factor_5_1, a_1_4, a_5_4);
        a_5_5 = STEWART_FMA(-factor_5_1, a_1_5, a_5_5);
        a_5_6 = STEWART_FMA(-factor_5_1, a_1_6, a_5_6);
        const stewart_real below_3_2 = STEWART_FABS(a_3_2) > STEWART_FABS(a_2_2) ? REAL(1) : REAL(0);
        const stewart_real above_2_2_3 = below_3_2 > REAL(0) ? a_3_2 : a_2_2;
        a_3_2 = below_3_2 > REAL(0) ? a_2_2 : a_3_2;
        a_2_2 = above_2_2_3;
        const stewart_real above_2_3_3 = below_3_2 > REAL(0) ? a_3_3 : a_2_3;
        a_3_3 = below_3_2 > REAL(0) ? a_2_3 : a_3_3;
        a_2_3 = above_2_3_3;
        const stewart_real above_2_4_3 = below_3_2 > REAL(0) ? a_3_4 : a_2_4;
        a_3_4 = below_3_2 > REAL(0) ? a_2_4 : a_3_4;
        a_2_4 = above_2_4_3;
        const stewart_real above_2_5_3 = below_3_2 > REAL(0) ? a_3_5 : a_2_5;
        a_3_5 = below_3_2 > REAL(0) ? a_2_5 : a_3_5;
        a_2_5 = above_2_5_3;
        const stewart_real above_2_6_3 = below_3_2 > REAL(0) ? a_3_6 : a_2_6;
        a_3_6 = below_3_2 > REAL(0) ? a_2_6 : a_3_6;
        a_2_6 = above_2_6_3;
        const stewart_real below_4_2 = STEWART_FABS(a_4_2) > STEWART_FABS(a_2_2) ? REAL(1) : REAL(0);
        const stewart_real above_2_2_4 = below_4_2 > REAL(0) ? a_4_2 : a_2_2;
        a_4_2 = below_4_2 > REAL(0) ? a_2_2 : a_4_2;
        a_2_2 = above_2_2_4;
        const stewart_real above_2_3_4 = below_4_2 > REAL(0) ? a_4_3 : a_2_3;
        a_4_3 = below_4_2 > REAL(0) ? a_2_3 : a_4_3;
        a_2_3 = above_2_3_4;
        const stewart_real above_2_4_4 = below_4_2 > REAL(0) ? a_4_4 : a_2_4;
        a_4_4 = below_4_2 > REAL(0) ? a_2_4 : a_4_4;
        a_2_4 = above_2_4_4;
        const stewart_real above_2_5_4 = below_4_2 > REAL(0) ? a_4_5 : a_2_5;
        a_4_5 = below_4_2 > REAL(0) ? a_2_5 : a_4_5;
        a_2_5 = above_2_5_4;
        const stewart_real above_2_6_4 = below_4_2 > REAL(0) ? a_4_6 : a_2_6;
        a_4_6 = below_4_2 > REAL(0) ? a_2_6 : a_4_6;
        a_2_6 = above_2_6_4;
        const stewart_real below_5_2 = STEWART_FABS(a_5_2) > STEWART_FABS(a_2_2) ? REAL(1) : REAL(0);
        const stewart_real above_2_2_5 = below_5_2 > REAL(0) ? a_5_2 : a_2_2;
        a_5_2 = below_5_2 > REAL(0) ? a_2_2 : a_5_2;
        a_2_2 = above_2_2_5;
        const stewart_real above_2_3_5 = below_5_2 > REAL(0) ? a_5_3 : a_2_3;
        a_5_3 = below_5_2 > REAL(0) ? a_2_3 : a_5_3;
        a_2_3 = above_2_3_5;
        const stewart_real above_2_4_5 = below_5_2 > REAL(0) ? a_5_4 : a_2_4;
        a_5_4 = below_5_2 > REAL(0) ? a_2_4 : a_5_4;
        a_2_4 = above_2_4_5;
        const stewart_real above_2_5_5 = below_5_2 > REAL(0) ? a_5_5 : a_2_5;
        a_5_5 = below_5_2 > REAL(0) ? a_2_5 : a_5_5;
        a_2_5 = above_2_5_5;
        const stewart_real above_2_6_5 = below_5_2 > REAL(0) ? a_5_6 : a_2_6;
        a_5_6 = below_5_2 > REAL(0) ? a_2_6 : a_5_6;
        a_2_6 = above_2_6_5;
        fault = STEWART_FABS(a_2_2) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real inverse_2 = REAL(1)/a_2_2;
        const stewart_real factor_3_2 = a_3_2*inverse_2;
        a_3_3 = STEWART_FMA(-factor_3_2, a_2_3, a_3_3);
        a_3_4 = STEWART_FMA(-factor_3_2, a_2_4, a_3_4);
        a_3_5 = STEWART_FMA(-factor_3_2, a_2_5, a_3_5);
        a_3_6 = STEWART_FMA(-factor_3_2, a_2_6, a_3_6);
        const stewart_real factor_4_2 = a_4_2*inverse_2;
        a_4_3 = STEWART_FMA(-factor_4_2, a_2_3, a_4_3);
        a_4_4 = STEWART_FMA(-factor_4_2, a_2_4, a_4_4);
        a_4_5 = STEWART_FMA(-factor_4_2, a_2_5, a_4_5);
        a_4_6 = STEWART_FMA(-factor_4_2, a_2_6, a_4_6);
        const stewart_real factor_5_2 = a_5_2*inverse_2;
        a_5_3 = STEWART_FMA(-factor_5_2, a_2_3, a_5_3);
        a_5_4 = STEWART_FMA(-factor_5_2, a_2_4, a_5_4);
        a_5_5 = STEWART_FMA(-factor_5_2, a_2_5, a_5_5);
        a_5_6 = STEWART_FMA(-factor_5_2, a_2_6, a_5_6);
        const stewart_real below_4_3 = STEWART_FABS(a_4_3) > STEWART_FABS(a_3_3) ? REAL(1) : REAL(0);
        const stewart_real above_3_3_4 = below_4_3 > REAL(0) ? a_4_3 : a_3_3;
        a_4_3 = below_4_3 > REAL(0) ? a_3_3 : a_4_3;
        a_3_3 = above_3_3_4;
        const stewart_real above_3_4_4 = below_4_3 > REAL(0) ? a_4_4 : a_3_4;
        a_4_4 = below_4_3 > REAL(0) ? a_3_4 : a_4_4;
        a_3_4 = above_3_4_4;
        const stewart_real above_3_5_4 = below_4_3 > REAL(0) ? a_4_5 : a_3_5;
        a_4_5 = below_4_3 > REAL(0) ? a_3_5 : a_4_5;
        a_3_5 = above_3_5_4;
        const stewart_real above_3_6_4 = below_4_3 > REAL(0) ? a_4_6 : a_3_6;
        a_4_6 = below_4_3 > REAL(0) ? a_3_6 : a_4_6;
        a_3_6 = above_3_6_4;
        const stewart_real below_5_3 = STEWART_FABS(a_5_3) > STEWART_FABS(a_3_3) ? REAL(1) : REAL(0);
        const stewart_real above_3_3_5 = below_5_3 > REAL(0) ? a_5_3 : a_3_3;
        a_5_3 = below_5_3 > REAL(0) ? a_3_3 : a_5_3;
        a_3_3 = above_3_3_5;
        const stewart_real above_3_4_5 = below_5_3 > REAL(0) ? a_5_4 : a_3_4;
        a_5_4 = below_5_3 > REAL(0) ? a_3_4 : a_5_4;
        a_3_4 = above_3_4_5;
        const stewart_real above_3_5_5 = below_5_3 > REAL(0) ? a_5_5 : a_3_5;
        a_5_5 = below_5_3 > REAL(0) ? a_3_5 : a_5_5;
        a_3_5 = above_3_5_5;
        const stewart_real above_3_6_5 = below_5_3 > REAL(0) ? a_5_6 : a_3_6;
        a_5_6 = below_5_3 > REAL(0) ? a_3_6 : a_5_6;
        a_3_6 = above_3_6_5;
        fault = STEWART_FABS(a_3_3) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real inverse_3 = REAL(1)/a_3_3;
        const stewart_real factor_4_3 = a_4_3*inverse_3;
        a_4_4 = STEWART_FMA(-factor_4_3, a_3_4, a_4_4);
        a_4_5 = STEWART_FMA(-factor_4_3, a_3_5, a_4_5);
        a_4_6 = STEWART_FMA(-factor_4_3, a_3_6, a_4_6);
        const stewart_real factor_5_3 = a_5_3*inverse_3;
        a_5_4 = STEWART_FMA(-factor_5_3, a_3_4, a_5_4);
        a_5_5 = STEWART_FMA(-factor_5_3, a_3_5, a_5_5);
        a_5_6 = STEWART_FMA(-factor_5_3, a_3_6, a_5_6);
        const stewart_real below_5_4 = STEWART_FABS(a_5_4) > STEWART_FABS(a_4_4) ? REAL(1) : REAL(0);
        const stewart_real above_4_4_5 = below_5_4 > REAL(0) ? a_5_4 : a_4_4;
        a_5_4 = below_5_4 > REAL(0) ? a_4_4 : a_5_4;
        a_4_4 = above_4_4_5;
        const stewart_real above_4_5_5 = below_5_4 > REAL(0) ? a_5_5 : a_4_5;
        a_5_5 = below_5_4 > REAL(0) ? a_4_5 : a_5_5;
        a_4_5 = above_4_5_5;
        const stewart_real above_4_6_5 = below_5_4 > REAL(0) ? a_5_6 : a_4_6;
        a_5_6 = below_5_4 > REAL(0) ? a_4_6 : a_5_6;
        a_4_6 = above_4_6_5;
        fault = STEWART_FABS(a_4_4) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real inverse_4 = REAL(1)/a_4_4;
        const stewart_real factor_5_4 = a_5_4*inverse_4;
        a_5_5 = STEWART_FMA(-factor_5_4, a_4_5, a_5_5);
        a_5_6 = STEWART_FMA(-factor_5_4, a_4_6, a_5_6);
        fault = STEWART_FABS(a_5_5) > STEWART_SUSPECT ? fault : REAL(1);
        const stewart_real total_5 = a_5_6;
        const stewart_real x_5 = total_5/a_5_5;
        stewart_real total_4 = a_4_6;
        total_4 = STEWART_FMA(-a_4_5, x_5, total_4);
        const stewart_real x_4 = total_4*inverse_4;
        stewart_real total_3 = a_3_6;
        total_3 = STEWART_FMA(-a_3_4, x_4, total_3);
        total_3 = STEWART_FMA(-a_3_5, x_5, total_3);
        const stewart_real x_3 = total_3*inverse_3;
        stewart_real total_2 = a_2_6;
        total_2 = STEWART_FMA(-a_2_3, x_3, total_2);
        total_2 = STEWART_FMA(-a_2_4, x_4, total_2);
        total_2 = STEWART_FMA(-a_2_5, x_5, total_2);
        const stewart_real x_2 = total_2*inverse_2;
        stewart_real total_1 = a_1_6;
        total_1 = STEWART_FMA(-a_1_2, x_2, total_1);
        total_1 = STEWART_FMA(-a_1_3, x_3, total_1);
        total_1 = STEWART_FMA(-a_1_4, x_4, total_1);
        total_1 = STEWART_FMA(-a_1_5, x_5, total_1);
        const stewart_real x_1 = total_1*inverse_1;
        stewart_real total_0 = a_0_6;
        total_0 = STEWART_FMA(-a_0_1, x_1, total_0);
        total_0 = STEWART_FMA(-a_0_2, x_2, total_0);
        total_0 = STEWART_FMA(-a_0_3, x_3, total_0);
        total_0 = STEWART_FMA(-a_0_4, x_4, total_0);
        total_0 = STEWART_FMA(-a_0_5, x_5, total_0);
        const stewart_real x_0 = total_0*inverse_0;
        const stewart_real force_0 = STEWART_FORCE(D[0][l], x_0);
        fault = STEWART_FABS(force_0) <= STEWART_MAX ? fault : REAL(1);
        F[0][l] = wanted[l] > REAL(0) ? force_0 : F[0][l];
        const stewart_real force_1 = STEWART_FORCE(D[1][l], x_1);
        fault = STEWART_FABS(force_1) <= STEWART_MAX ? fault : REAL(1);
        F[1][l] = wanted[l] > REAL(0) ? force_1 : F[1][l];
        const stewart_real force_2 = STEWART_FORCE(D[2][l], x_2);
        fault = STEWART_FABS(force_2) <= STEWART_MAX ? fault : REAL(1);
        F[2][l] = wanted[l] > REAL(0) ? force_2 : F[2][l];
        const stewart_real force_3 = STEWART_FORCE(D[3][l], x_3);
        fault = STEWART_FABS(force_3) <= STEWART_MAX ? fault : REAL(1);
        F[3][l] = wanted[l] > REAL(0) ? force_3 : F[3][l];
        const stewart_real force_4 = STEWART_FORCE(D[4][l], x_4);
        fault = STEWART_FABS(force_4) <= STEWART_MAX ? fault : REAL(1);
        F[4][l] = wanted[l] > REAL(0) ? force_4 : F[4][l];
        const stewart_real force_5 = STEWART_FORCE(D[5][l], x_5);
        fault = STEWART_FABS(force_5) <= STEWART_MAX ? fault : REAL(1);
        F[5][l] = wanted[l] > REAL(0) ? force_5 : F[5][l];
        bad[l] = wanted[l] > REAL(0) ? fault : bad[l];
    }
}

/* Computes the forces of a block of poses from H, c, and D, (36) and (37), in two blocks of legs or by
 * pivots. */
STEWART_SHARED STEWART_NO_COPY void solve_block(
    stewart_real column[7][6][POSES], stewart_real D[6][POSES], stewart_real arm_cube,
    stewart_real F[6][POSES], stewart_real bad[POSES])
{
    int l;
    (void)D;
    stewart_real wanted[POSES];
    stewart_real most = REAL(0);
    blocks_of_lanes(column, D, arm_cube, F, bad, wanted);
    for (l = 0; l < POSES; ++l) {
        most = STEWART_LARGER(wanted[l], most);
    }
    if (most > REAL(0)) {
        pivots_of_lanes(column, D, F, bad, wanted);
    }
}

/* Returns the address of `width` numbers of each pose of a complete block, and prefetches the block after
 * the next. */
STEWART_SHARED const stewart_real *block_at(
    const stewart_real *from, size_t width, size_t first, size_t count)
{
    size_t i;
    const stewart_real *found = &from[first * width];
    if (first + 3U * (size_t)POSES <= count) {
        for (i = 2U * width; i < 3U * width; ++i) {
            STEWART_ASK(&found[i * (size_t)POSES]);
        }
    }
    return found;
}

/* Returns the address of the numbers of any block; an incomplete block is padded with the last pose. */
STEWART_SHARED const stewart_real *whole(
    const stewart_real *from, size_t width, size_t first, size_t count, stewart_real *padded)
{
    size_t l, i;
    if (first + (size_t)POSES <= count) {
        return block_at(from, width, first, count);
    }
    for (l = 0; l < (size_t)POSES; ++l) {
        const size_t pose = first + l < count ? first + l : count - 1U;
        for (i = 0; i < width; ++i) {
            padded[l * width + i] = from[pose * width + i];
        }
    }
    return padded;
}

/* Store vectors, matrices, and zeros component by component. */
STEWART_SHARED void spread_vector(
    const stewart_real *STEWART_RESTRICT from, stewart_real (*STEWART_RESTRICT to)[POSES])
{
    int l;
    for (l = 0; l < POSES; ++l) {
        to[0][l] = from[3 * l];
        to[1][l] = from[3 * l + 1];
        to[2][l] = from[3 * l + 2];
    }
}

STEWART_SHARED void spread_matrix(
    const stewart_real *STEWART_RESTRICT from, stewart_real (*STEWART_RESTRICT to)[POSES])
{
    int i, l;
    for (i = 0; i < 9; ++i) {
        for (l = 0; l < POSES; ++l) {
            to[i][l] = from[9 * l + i];
        }
    }
}

STEWART_SHARED void clear(stewart_real (*to)[POSES])
{
    int i, l;
    for (i = 0; i < 3; ++i) {
        for (l = 0; l < POSES; ++l) {
            to[i][l] = REAL(0);
        }
    }
}

/* Copies columns that are `stride` numbers apart. */
STEWART_SHARED void take_columns(
    const stewart_real *from, int width, size_t stride, size_t first, size_t count,
    stewart_real (*STEWART_RESTRICT to)[POSES])
{
    int i, l;
    if (first + 3U * (size_t)POSES <= count) {
        for (i = 0; i < width; ++i) {
            STEWART_ASK(&from[(size_t)i * stride + first + 2U * (size_t)POSES]);
        }
    }
    if (first + (size_t)POSES <= count) {
        for (i = 0; i < width; ++i) {
            const stewart_real *column = &from[(size_t)i * stride + first];
            for (l = 0; l < POSES; ++l) {
                to[i][l] = column[l];
            }
        }
        return;
    }
    for (l = 0; l < POSES; ++l) {
        const size_t pose = first + (size_t)l < count ? first + (size_t)l : count - 1U;
        for (i = 0; i < width; ++i) {
            to[i][l] = from[(size_t)i * stride + pose];
        }
    }
}

/* Load vectors (zeros if null) and matrices of the poses of a block, component by component: from successive
 * poses if stride is 0, else from columns. */
STEWART_SHARED void load_vector(
    const stewart_real *from, size_t stride, size_t first, size_t count, stewart_real (*to)[POSES])
{
    stewart_real padded[3 * POSES];
    if (from == NULL) {
        clear(to);
    } else if (stride > 0U) {
        take_columns(from, 3, stride, first, count, to);
    } else {
        spread_vector(whole(from, 3U, first, count, padded), to);
    }
}

STEWART_SHARED void load_matrix(
    const stewart_real *from, size_t stride, size_t first, size_t count, stewart_real (*to)[POSES])
{
    stewart_real padded[9 * POSES];
    if (stride > 0U) {
        take_columns(from, 9, stride, first, count, to);
    } else {
        spread_matrix(whole(from, 9U, first, count, padded), to);
    }
}

/* Stores the forces of the poses of a block that are not bad. */
STEWART_SHARED void store_forces(
    stewart_real (*STEWART_RESTRICT F)[POSES], const stewart_real *STEWART_RESTRICT bad, size_t stride,
    size_t first, size_t count, stewart_real *STEWART_RESTRICT to)
{
    int i, l;
    const size_t by_pose = stride > 0U ? (size_t)1 : (size_t)6;
    const size_t by_leg = stride > 0U ? stride : (size_t)1;
    stewart_real *const here = &to[first * by_pose];
    if (first + 3U * (size_t)POSES <= count) {
        for (i = 0; i < 6; ++i) {
            STEWART_ASK(&here[2U * (size_t)POSES * by_pose + (size_t)i * (stride > 0U ? stride : (size_t)POSES)]);
        }
    }
    for (l = 0; l < POSES && first + (size_t)l < count; ++l) {
        if (bad[l] == REAL(0)) {
            for (i = 0; i < 6; ++i) {
                here[(size_t)l * by_pose + (size_t)i * by_leg] = F[i][l];
            }
        }
    }
}

#endif
