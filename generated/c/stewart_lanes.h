/* stewart_lanes.h: the linear solver, for one pose and for a block of poses in lanes, included by the sources of kernels.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#ifndef STEWART_LANES_H
#define STEWART_LANES_H

#include "stewart_solve.h"

typedef struct {
    stewart_real H[6][LANES];
} STEWART_ALIGNED columns_pose;

typedef struct {
    stewart_real c[6];
} STEWART_ALIGNED right_side_pose;

typedef struct {
    stewart_real weak;
} STEWART_ALIGNED two_blocks_pose;

typedef struct {
    stewart_real suspect;
    stewart_real x[6];
} STEWART_ALIGNED solution_pose;

/* Solves H x = c for x in two blocks of three legs, (36). Sets `weak` if the blocks are too inaccurate,
 * so that pivots are required. */
STEWART_SHARED void compute_two_blocks_pose(
    stewart_real arm_cube, const columns_pose *STEWART_RESTRICT columns,
    const right_side_pose *STEWART_RESTRICT right_side, two_blocks_pose *STEWART_RESTRICT two_blocks,
    solution_pose *STEWART_RESTRICT solution)
{
    int l;
    const stewart_real c_0 = right_side->c[0], c_1 = right_side->c[1], c_2 = right_side->c[2], c_3 = right_side->c[3],
        c_4 = right_side->c[4], c_5 = right_side->c[5];
    const stewart_real r_0_0 = STEWART_FMA(columns->H[2][3], -columns->H[1][5],
        columns->H[1][3]*columns->H[2][5]);
    const stewart_real r_0_1 = STEWART_FMA(columns->H[0][3], -columns->H[2][5],
        columns->H[2][3]*columns->H[0][5]);
    const stewart_real r_0_2 = STEWART_FMA(columns->H[1][3], -columns->H[0][5],
        columns->H[0][3]*columns->H[1][5]);
    const stewart_real r_1_0 = STEWART_FMA(columns->H[2][5], -columns->H[1][1],
        columns->H[1][5]*columns->H[2][1]);
    const stewart_real r_1_1 = STEWART_FMA(columns->H[0][5], -columns->H[2][1],
        columns->H[2][5]*columns->H[0][1]);
    const stewart_real r_1_2 = STEWART_FMA(columns->H[1][5], -columns->H[0][1],
        columns->H[0][5]*columns->H[1][1]);
    const stewart_real r_2_0 = STEWART_FMA(columns->H[2][1], -columns->H[1][3],
        columns->H[1][1]*columns->H[2][3]);
    const stewart_real r_2_1 = STEWART_FMA(columns->H[0][1], -columns->H[2][3],
        columns->H[2][1]*columns->H[0][3]);
    const stewart_real r_2_2 = STEWART_FMA(columns->H[1][1], -columns->H[0][3],
        columns->H[0][1]*columns->H[1][3]);
    const stewart_real det = STEWART_FMA(columns->H[2][1], r_0_2, STEWART_FMA(columns->H[1][1], r_0_1,
        columns->H[0][1]*r_0_0));
    stewart_real e_0_of[LANES];
    stewart_real e_1_of[LANES];
    stewart_real e_2_of[LANES];
    stewart_real w_0_of[LANES];
    stewart_real w_1_of[LANES];
    stewart_real w_2_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real H_0 = columns->H[0][l], H_1 = columns->H[1][l], H_2 = columns->H[2][l], H_3 = columns->H[3][l],
            H_4 = columns->H[4][l], H_5 = columns->H[5][l];
        const stewart_real e_0 = STEWART_FMA(r_0_2, H_2, STEWART_FMA(r_0_1, H_1, r_0_0*H_0));
        const stewart_real e_1 = STEWART_FMA(r_1_2, H_2, STEWART_FMA(r_1_1, H_1, r_1_0*H_0));
        const stewart_real e_2 = STEWART_FMA(r_2_2, H_2, STEWART_FMA(r_2_1, H_1, r_2_0*H_0));
        const stewart_real w_0 = STEWART_FMA(columns->H[3][5], -e_2, STEWART_FMA(columns->H[3][3], -e_1,
            STEWART_FMA(columns->H[3][1], -e_0, det*H_3)));
        const stewart_real w_1 = STEWART_FMA(columns->H[4][5], -e_2, STEWART_FMA(columns->H[4][3], -e_1,
            STEWART_FMA(columns->H[4][1], -e_0, det*H_4)));
        const stewart_real w_2 = STEWART_FMA(columns->H[5][5], -e_2, STEWART_FMA(columns->H[5][3], -e_1,
            STEWART_FMA(columns->H[5][1], -e_0, det*H_5)));
        e_0_of[l] = e_0;
        e_1_of[l] = e_1;
        e_2_of[l] = e_2;
        w_0_of[l] = w_0;
        w_1_of[l] = w_1;
        w_2_of[l] = w_2;
    }
    const stewart_real e_c_0 = STEWART_FMA(r_0_2, c_2, STEWART_FMA(r_0_1, c_1, r_0_0*c_0));
    const stewart_real e_c_1 = STEWART_FMA(r_1_2, c_2, STEWART_FMA(r_1_1, c_1, r_1_0*c_0));
    const stewart_real e_c_2 = STEWART_FMA(r_2_2, c_2, STEWART_FMA(r_2_1, c_1, r_2_0*c_0));
    const stewart_real w_c_0 = STEWART_FMA(columns->H[3][5], -e_c_2, STEWART_FMA(columns->H[3][3], -e_c_1,
        STEWART_FMA(columns->H[3][1], -e_c_0, det*c_3)));
    const stewart_real w_c_1 = STEWART_FMA(columns->H[4][5], -e_c_2, STEWART_FMA(columns->H[4][3], -e_c_1,
        STEWART_FMA(columns->H[4][1], -e_c_0, det*c_4)));
    const stewart_real w_c_2 = STEWART_FMA(columns->H[5][5], -e_c_2, STEWART_FMA(columns->H[5][3], -e_c_1,
        STEWART_FMA(columns->H[5][1], -e_c_0, det*c_5)));
    const stewart_real u_0_0 = STEWART_FMA(w_2_of[2], -w_1_of[4], w_1_of[2]*w_2_of[4]);
    const stewart_real u_0_1 = STEWART_FMA(w_0_of[2], -w_2_of[4], w_2_of[2]*w_0_of[4]);
    const stewart_real u_0_2 = STEWART_FMA(w_1_of[2], -w_0_of[4], w_0_of[2]*w_1_of[4]);
    const stewart_real u_1_0 = STEWART_FMA(w_2_of[4], -w_1_of[0], w_1_of[4]*w_2_of[0]);
    const stewart_real u_1_1 = STEWART_FMA(w_0_of[4], -w_2_of[0], w_2_of[4]*w_0_of[0]);
    const stewart_real u_1_2 = STEWART_FMA(w_1_of[4], -w_0_of[0], w_0_of[4]*w_1_of[0]);
    const stewart_real u_2_0 = STEWART_FMA(w_2_of[0], -w_1_of[2], w_1_of[0]*w_2_of[2]);
    const stewart_real u_2_1 = STEWART_FMA(w_0_of[0], -w_2_of[2], w_2_of[0]*w_0_of[2]);
    const stewart_real u_2_2 = STEWART_FMA(w_1_of[0], -w_0_of[2], w_0_of[0]*w_1_of[2]);
    const stewart_real complement = STEWART_FMA(w_2_of[0], u_0_2, STEWART_FMA(w_1_of[0], u_0_1,
        w_0_of[0]*u_0_0));
    const stewart_real det2 = det*det;
    const stewart_real least = STEWART_LARGER(STEWART_FABS(det)*STEWART_BLOCK_LEAST,
        STEWART_BLOCK_SINGULAR)*(det2*arm_cube);
    const stewart_real grown = STEWART_FMA(e_0_of[4], e_0_of[4], STEWART_FMA(e_0_of[2], e_0_of[2],
        e_0_of[0]*e_0_of[0])) + STEWART_FMA(e_1_of[4], e_1_of[4], STEWART_FMA(e_1_of[2], e_1_of[2],
        e_1_of[0]*e_1_of[0])) + STEWART_FMA(e_2_of[4], e_2_of[4], STEWART_FMA(e_2_of[2], e_2_of[2],
        e_2_of[0]*e_2_of[0])) > STEWART_BLOCK_GROWTH*det2 ? REAL(1) : REAL(0);
    two_blocks->weak = STEWART_FABS(complement) <= least ? REAL(1) : grown;
    const stewart_real inverse_det = REAL(1)/det;
    const stewart_real inverse_complement = REAL(1)/complement;
    const stewart_real x_0 = STEWART_FMA(u_0_2, w_c_2, STEWART_FMA(u_0_1, w_c_1,
        u_0_0*w_c_0))*inverse_complement;
    const stewart_real x_2 = STEWART_FMA(u_1_2, w_c_2, STEWART_FMA(u_1_1, w_c_1,
        u_1_0*w_c_0))*inverse_complement;
    const stewart_real x_4 = STEWART_FMA(u_2_2, w_c_2, STEWART_FMA(u_2_1, w_c_1,
        u_2_0*w_c_0))*inverse_complement;
    const stewart_real x_1 = STEWART_FMA(e_0_of[4], -x_4, STEWART_FMA(e_0_of[2], -x_2,
        STEWART_FMA(e_0_of[0], -x_0, e_c_0)))*inverse_det;
    const stewart_real x_3 = STEWART_FMA(e_1_of[4], -x_4, STEWART_FMA(e_1_of[2], -x_2,
        STEWART_FMA(e_1_of[0], -x_0, e_c_1)))*inverse_det;
    const stewart_real x_5 = STEWART_FMA(e_2_of[4], -x_4, STEWART_FMA(e_2_of[2], -x_2,
        STEWART_FMA(e_2_of[0], -x_0, e_c_2)))*inverse_det;
    solution->x[0] = x_0;
    solution->x[1] = x_1;
    solution->x[2] = x_2;
    solution->x[3] = x_3;
    solution->x[4] = x_4;
    solution->x[5] = x_5;
    solution->suspect = REAL(0);
}

/* Solves H x = c for x by elimination with partial pivoting, (36). Sets `suspect` if a pivot is small. */
STEWART_APART STEWART_SHARED void compute_pivots_pose(
    const columns_pose *STEWART_RESTRICT columns, const right_side_pose *STEWART_RESTRICT right_side,
    solution_pose *STEWART_RESTRICT solution)
{
    int l;
    const stewart_real c_1 = right_side->c[1], c_0 = right_side->c[0], c_2 = right_side->c[2], c_3 = right_side->c[3],
        c_4 = right_side->c[4], c_5 = right_side->c[5];
    const stewart_real below_1_0 = STEWART_FABS(columns->H[1][0]) > STEWART_FABS(columns->H[0][0]) ? REAL(1)
        : REAL(0);
    stewart_real row_0_of[LANES];
    stewart_real row_1_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real H_1 = columns->H[1][l], H_0 = columns->H[0][l];
        const stewart_real row_0 = below_1_0 > REAL(0) ? H_1 : H_0;
        const stewart_real row_1 = below_1_0 > REAL(0) ? H_0 : H_1;
        row_0_of[l] = row_0;
        row_1_of[l] = row_1;
    }
    const stewart_real right_0 = below_1_0 > REAL(0) ? c_1 : c_0;
    const stewart_real right_1 = below_1_0 > REAL(0) ? c_0 : c_1;
    const stewart_real below_2_0 = STEWART_FABS(columns->H[2][0]) > STEWART_FABS(row_0_of[0]) ? REAL(1) : REAL(0);
    stewart_real row_0_2_of[LANES];
    stewart_real row_2_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real H_2 = columns->H[2][l];
        const stewart_real row_0 = row_0_of[l];
        const stewart_real row_0_2 = below_2_0 > REAL(0) ? H_2 : row_0;
        const stewart_real row_2 = below_2_0 > REAL(0) ? row_0 : H_2;
        row_0_2_of[l] = row_0_2;
        row_2_of[l] = row_2;
    }
    const stewart_real right_0_2 = below_2_0 > REAL(0) ? c_2 : right_0;
    const stewart_real right_2 = below_2_0 > REAL(0) ? right_0 : c_2;
    const stewart_real inverse_0 = REAL(1)/row_0_2_of[0];
    const stewart_real factor_1_0 = row_1_of[0]*inverse_0;
    stewart_real row_1_2_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_1 = row_1_of[l];
        const stewart_real row_0_2 = row_0_2_of[l];
        const stewart_real row_1_2 = STEWART_FMA(-factor_1_0, row_0_2, row_1);
        row_1_2_of[l] = row_1_2;
    }
    const stewart_real right_1_2 = STEWART_FMA(-factor_1_0, right_0_2, right_1);
    const stewart_real factor_2_0 = row_2_of[0]*inverse_0;
    stewart_real row_2_2_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_2 = row_2_of[l];
        const stewart_real row_0_2 = row_0_2_of[l];
        const stewart_real row_2_2 = STEWART_FMA(-factor_2_0, row_0_2, row_2);
        row_2_2_of[l] = row_2_2;
    }
    const stewart_real right_2_2 = STEWART_FMA(-factor_2_0, right_0_2, right_2);
    const stewart_real below_2_1 = STEWART_FABS(row_2_2_of[1]) > STEWART_FABS(row_1_2_of[1]) ? REAL(1) : REAL(0);
    stewart_real row_1_3_of[LANES];
    stewart_real row_2_3_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_2_2 = row_2_2_of[l];
        const stewart_real row_1_2 = row_1_2_of[l];
        const stewart_real row_1_3 = below_2_1 > REAL(0) ? row_2_2 : row_1_2;
        const stewart_real row_2_3 = below_2_1 > REAL(0) ? row_1_2 : row_2_2;
        row_1_3_of[l] = row_1_3;
        row_2_3_of[l] = row_2_3;
    }
    const stewart_real right_1_3 = below_2_1 > REAL(0) ? right_2_2 : right_1_2;
    const stewart_real right_2_3 = below_2_1 > REAL(0) ? right_1_2 : right_2_2;
    const stewart_real below_3_1 = STEWART_FABS(columns->H[3][1]) > STEWART_FABS(row_1_3_of[1]) ? REAL(1) : REAL(0);
    stewart_real row_1_4_of[LANES];
    stewart_real row_3_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real H_3 = columns->H[3][l];
        const stewart_real row_1_3 = row_1_3_of[l];
        const stewart_real row_1_4 = below_3_1 > REAL(0) ? H_3 : row_1_3;
        const stewart_real row_3 = below_3_1 > REAL(0) ? row_1_3 : H_3;
        row_1_4_of[l] = row_1_4;
        row_3_of[l] = row_3;
    }
    const stewart_real right_1_4 = below_3_1 > REAL(0) ? c_3 : right_1_3;
    const stewart_real right_3 = below_3_1 > REAL(0) ? right_1_3 : c_3;
    const stewart_real below_4_1 = STEWART_FABS(columns->H[4][1]) > STEWART_FABS(row_1_4_of[1]) ? REAL(1) : REAL(0);
    stewart_real row_1_5_of[LANES];
    stewart_real row_4_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real H_4 = columns->H[4][l];
        const stewart_real row_1_4 = row_1_4_of[l];
        const stewart_real row_1_5 = below_4_1 > REAL(0) ? H_4 : row_1_4;
        const stewart_real row_4 = below_4_1 > REAL(0) ? row_1_4 : H_4;
        row_1_5_of[l] = row_1_5;
        row_4_of[l] = row_4;
    }
    const stewart_real right_1_5 = below_4_1 > REAL(0) ? c_4 : right_1_4;
    const stewart_real right_4 = below_4_1 > REAL(0) ? right_1_4 : c_4;
    const stewart_real below_5_1 = STEWART_FABS(columns->H[5][1]) > STEWART_FABS(row_1_5_of[1]) ? REAL(1) : REAL(0);
    stewart_real row_1_6_of[LANES];
    stewart_real row_5_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real H_5 = columns->H[5][l];
        const stewart_real row_1_5 = row_1_5_of[l];
        const stewart_real row_1_6 = below_5_1 > REAL(0) ? H_5 : row_1_5;
        const stewart_real row_5 = below_5_1 > REAL(0) ? row_1_5 : H_5;
        row_1_6_of[l] = row_1_6;
        row_5_of[l] = row_5;
    }
    const stewart_real right_1_6 = below_5_1 > REAL(0) ? c_5 : right_1_5;
    const stewart_real right_5 = below_5_1 > REAL(0) ? right_1_5 : c_5;
    const stewart_real inverse_1 = REAL(1)/row_1_6_of[1];
    const stewart_real factor_2_1 = row_2_3_of[1]*inverse_1;
    stewart_real row_2_4_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_2_3 = row_2_3_of[l];
        const stewart_real row_1_6 = row_1_6_of[l];
        const stewart_real row_2_4 = STEWART_FMA(-factor_2_1, row_1_6, row_2_3);
        row_2_4_of[l] = row_2_4;
    }
    const stewart_real right_2_4 = STEWART_FMA(-factor_2_1, right_1_6, right_2_3);
    const stewart_real factor_3_1 = row_3_of[1]*inverse_1;
    stewart_real row_3_2_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_3 = row_3_of[l];
        const stewart_real row_1_6 = row_1_6_of[l];
        const stewart_real row_3_2 = STEWART_FMA(-factor_3_1, row_1_6, row_3);
        row_3_2_of[l] = row_3_2;
    }
    const stewart_real right_3_2 = STEWART_FMA(-factor_3_1, right_1_6, right_3);
    const stewart_real factor_4_1 = row_4_of[1]*inverse_1;
    stewart_real row_4_2_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_4 = row_4_of[l];
        const stewart_real row_1_6 = row_1_6_of[l];
        const stewart_real row_4_2 = STEWART_FMA(-factor_4_1, row_1_6, row_4);
        row_4_2_of[l] = row_4_2;
    }
    const stewart_real right_4_2 = STEWART_FMA(-factor_4_1, right_1_6, right_4);
    const stewart_real factor_5_1 = row_5_of[1]*inverse_1;
    stewart_real row_5_2_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_5 = row_5_of[l];
        const stewart_real row_1_6 = row_1_6_of[l];
        const stewart_real row_5_2 = STEWART_FMA(-factor_5_1, row_1_6, row_5);
        row_5_2_of[l] = row_5_2;
    }
    const stewart_real right_5_2 = STEWART_FMA(-factor_5_1, right_1_6, right_5);
    const stewart_real below_3_2 = STEWART_FABS(row_3_2_of[2]) > STEWART_FABS(row_2_4_of[2]) ? REAL(1) : REAL(0);
    stewart_real row_2_5_of[LANES];
    stewart_real row_3_3_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_3_2 = row_3_2_of[l];
        const stewart_real row_2_4 = row_2_4_of[l];
        const stewart_real row_2_5 = below_3_2 > REAL(0) ? row_3_2 : row_2_4;
        const stewart_real row_3_3 = below_3_2 > REAL(0) ? row_2_4 : row_3_2;
        row_2_5_of[l] = row_2_5;
        row_3_3_of[l] = row_3_3;
    }
    const stewart_real right_2_5 = below_3_2 > REAL(0) ? right_3_2 : right_2_4;
    const stewart_real right_3_3 = below_3_2 > REAL(0) ? right_2_4 : right_3_2;
    const stewart_real below_4_2 = STEWART_FABS(row_4_2_of[2]) > STEWART_FABS(row_2_5_of[2]) ? REAL(1) : REAL(0);
    stewart_real row_2_6_of[LANES];
    stewart_real row_4_3_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_4_2 = row_4_2_of[l];
        const stewart_real row_2_5 = row_2_5_of[l];
        const stewart_real row_2_6 = below_4_2 > REAL(0) ? row_4_2 : row_2_5;
        const stewart_real row_4_3 = below_4_2 > REAL(0) ? row_2_5 : row_4_2;
        row_2_6_of[l] = row_2_6;
        row_4_3_of[l] = row_4_3;
    }
    const stewart_real right_2_6 = below_4_2 > REAL(0) ? right_4_2 : right_2_5;
    const stewart_real right_4_3 = below_4_2 > REAL(0) ? right_2_5 : right_4_2;
    const stewart_real below_5_2 = STEWART_FABS(row_5_2_of[2]) > STEWART_FABS(row_2_6_of[2]) ? REAL(1) : REAL(0);
    stewart_real row_2_7_of[LANES];
    stewart_real row_5_3_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_5_2 = row_5_2_of[l];
        const stewart_real row_2_6 = row_2_6_of[l];
        const stewart_real row_2_7 = below_5_2 > REAL(0) ? row_5_2 : row_2_6;
        const stewart_real row_5_3 = below_5_2 > REAL(0) ? row_2_6 : row_5_2;
        row_2_7_of[l] = row_2_7;
        row_5_3_of[l] = row_5_3;
    }
    const stewart_real right_2_7 = below_5_2 > REAL(0) ? right_5_2 : right_2_6;
    const stewart_real right_5_3 = below_5_2 > REAL(0) ? right_2_6 : right_5_2;
    const stewart_real inverse_2 = REAL(1)/row_2_7_of[2];
    const stewart_real factor_3_2 = row_3_3_of[2]*inverse_2;
    stewart_real row_3_4_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_3_3 = row_3_3_of[l];
        const stewart_real row_2_7 = row_2_7_of[l];
        const stewart_real row_3_4 = STEWART_FMA(-factor_3_2, row_2_7, row_3_3);
        row_3_4_of[l] = row_3_4;
    }
    const stewart_real right_3_4 = STEWART_FMA(-factor_3_2, right_2_7, right_3_3);
    const stewart_real factor_4_2 = row_4_3_of[2]*inverse_2;
    stewart_real row_4_4_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_4_3 = row_4_3_of[l];
        const stewart_real row_2_7 = row_2_7_of[l];
        const stewart_real row_4_4 = STEWART_FMA(-factor_4_2, row_2_7, row_4_3);
        row_4_4_of[l] = row_4_4;
    }
    const stewart_real right_4_4 = STEWART_FMA(-factor_4_2, right_2_7, right_4_3);
    const stewart_real factor_5_2 = row_5_3_of[2]*inverse_2;
    stewart_real row_5_4_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_5_3 = row_5_3_of[l];
        const stewart_real row_2_7 = row_2_7_of[l];
        const stewart_real row_5_4 = STEWART_FMA(-factor_5_2, row_2_7, row_5_3);
        row_5_4_of[l] = row_5_4;
    }
    const stewart_real right_5_4 = STEWART_FMA(-factor_5_2, right_2_7, right_5_3);
    const stewart_real below_4_3 = STEWART_FABS(row_4_4_of[3]) > STEWART_FABS(row_3_4_of[3]) ? REAL(1) : REAL(0);
    stewart_real row_3_5_of[LANES];
    stewart_real row_4_5_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_4_4 = row_4_4_of[l];
        const stewart_real row_3_4 = row_3_4_of[l];
        const stewart_real row_3_5 = below_4_3 > REAL(0) ? row_4_4 : row_3_4;
        const stewart_real row_4_5 = below_4_3 > REAL(0) ? row_3_4 : row_4_4;
        row_3_5_of[l] = row_3_5;
        row_4_5_of[l] = row_4_5;
    }
    const stewart_real right_3_5 = below_4_3 > REAL(0) ? right_4_4 : right_3_4;
    const stewart_real right_4_5 = below_4_3 > REAL(0) ? right_3_4 : right_4_4;
    const stewart_real below_5_3 = STEWART_FABS(row_5_4_of[3]) > STEWART_FABS(row_3_5_of[3]) ? REAL(1) : REAL(0);
    stewart_real row_3_6_of[LANES];
    stewart_real row_5_5_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_5_4 = row_5_4_of[l];
        const stewart_real row_3_5 = row_3_5_of[l];
        const stewart_real row_3_6 = below_5_3 > REAL(0) ? row_5_4 : row_3_5;
        const stewart_real row_5_5 = below_5_3 > REAL(0) ? row_3_5 : row_5_4;
        row_3_6_of[l] = row_3_6;
        row_5_5_of[l] = row_5_5;
    }
    const stewart_real right_3_6 = below_5_3 > REAL(0) ? right_5_4 : right_3_5;
    const stewart_real right_5_5 = below_5_3 > REAL(0) ? right_3_5 : right_5_4;
    const stewart_real inverse_3 = REAL(1)/row_3_6_of[3];
    const stewart_real factor_4_3 = row_4_5_of[3]*inverse_3;
    stewart_real row_4_6_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_4_5 = row_4_5_of[l];
        const stewart_real row_3_6 = row_3_6_of[l];
        const stewart_real row_4_6 = STEWART_FMA(-factor_4_3, row_3_6, row_4_5);
        row_4_6_of[l] = row_4_6;
    }
    const stewart_real right_4_6 = STEWART_FMA(-factor_4_3, right_3_6, right_4_5);
    const stewart_real factor_5_3 = row_5_5_of[3]*inverse_3;
    stewart_real row_5_6_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_5_5 = row_5_5_of[l];
        const stewart_real row_3_6 = row_3_6_of[l];
        const stewart_real row_5_6 = STEWART_FMA(-factor_5_3, row_3_6, row_5_5);
        row_5_6_of[l] = row_5_6;
    }
    const stewart_real right_5_6 = STEWART_FMA(-factor_5_3, right_3_6, right_5_5);
    const stewart_real below_5_4 = STEWART_FABS(row_5_6_of[4]) > STEWART_FABS(row_4_6_of[4]) ? REAL(1) : REAL(0);
    stewart_real row_4_7_of[LANES];
    stewart_real row_5_7_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_5_6 = row_5_6_of[l];
        const stewart_real row_4_6 = row_4_6_of[l];
        const stewart_real row_4_7 = below_5_4 > REAL(0) ? row_5_6 : row_4_6;
        const stewart_real row_5_7 = below_5_4 > REAL(0) ? row_4_6 : row_5_6;
        row_4_7_of[l] = row_4_7;
        row_5_7_of[l] = row_5_7;
    }
    const stewart_real right_4_7 = below_5_4 > REAL(0) ? right_5_6 : right_4_6;
    const stewart_real right_5_7 = below_5_4 > REAL(0) ? right_4_6 : right_5_6;
    const stewart_real inverse_4 = REAL(1)/row_4_7_of[4];
    const stewart_real factor_5_4 = row_5_7_of[4]*inverse_4;
    stewart_real row_5_8_of[LANES];
    for (l = 0; l < LANES; ++l) {
        const stewart_real row_5_7 = row_5_7_of[l];
        const stewart_real row_4_7 = row_4_7_of[l];
        const stewart_real row_5_8 = STEWART_FMA(-factor_5_4, row_4_7, row_5_7);
        row_5_8_of[l] = row_5_8;
    }
    const stewart_real right_5_8 = STEWART_FMA(-factor_5_4, right_4_7, right_5_7);
    const stewart_real y_5 = right_5_8/row_5_8_of[5];
    const stewart_real y_4 = STEWART_FMA(row_4_7_of[5], -y_5, right_4_7)*inverse_4;
    const stewart_real y_3 = STEWART_FMA(row_3_6_of[5], -y_5, STEWART_FMA(row_3_6_of[4], -y_4,
        right_3_6))*inverse_3;
    const stewart_real y_2 = STEWART_FMA(row_2_7_of[5], -y_5, STEWART_FMA(row_2_7_of[4], -y_4,
        STEWART_FMA(row_2_7_of[3], -y_3, right_2_7)))*inverse_2;
    const stewart_real y_1 = STEWART_FMA(row_1_6_of[5], -y_5, STEWART_FMA(row_1_6_of[4], -y_4,
        STEWART_FMA(row_1_6_of[3], -y_3, STEWART_FMA(row_1_6_of[2], -y_2, right_1_6))))*inverse_1;
    const stewart_real y_0 = STEWART_FMA(row_0_2_of[5], -y_5, STEWART_FMA(row_0_2_of[4], -y_4,
        STEWART_FMA(row_0_2_of[3], -y_3, STEWART_FMA(row_0_2_of[2], -y_2, STEWART_FMA(row_0_2_of[1], -y_1,
        right_0_2)))))*inverse_0;
    const stewart_real small = STEWART_FABS(row_0_2_of[0]) > STEWART_SUSPECT ? REAL(0) : REAL(1);
    const stewart_real small_2 = STEWART_FABS(row_1_6_of[1]) > STEWART_SUSPECT ? small : REAL(1);
    const stewart_real small_3 = STEWART_FABS(row_2_7_of[2]) > STEWART_SUSPECT ? small_2 : REAL(1);
    const stewart_real small_4 = STEWART_FABS(row_3_6_of[3]) > STEWART_SUSPECT ? small_3 : REAL(1);
    const stewart_real small_5 = STEWART_FABS(row_4_7_of[4]) > STEWART_SUSPECT ? small_4 : REAL(1);
    const stewart_real small_6 = STEWART_FABS(row_5_8_of[5]) > STEWART_SUSPECT ? small_5 : REAL(1);
    solution->x[0] = y_0;
    solution->x[1] = y_1;
    solution->x[2] = y_2;
    solution->x[3] = y_3;
    solution->x[4] = y_4;
    solution->x[5] = y_5;
    solution->suspect = small_6;
}

typedef struct {
    stewart_real c[6][POSES];
} STEWART_ALIGNED right_side_block;

typedef struct {
    stewart_real H[6][POSES];
} STEWART_ALIGNED columns_block;

typedef struct {
    stewart_real suspect[POSES];
    stewart_real x[6][POSES];
} STEWART_ALIGNED solution_block;

/* Solves H x = c for x by elimination with partial pivoting, (36). Sets `suspect` if a pivot is small. */
STEWART_APART STEWART_SHARED void compute_pivots_block(
    const columns_block *STEWART_RESTRICT columns, const right_side_block *STEWART_RESTRICT right_side,
    solution_block *STEWART_RESTRICT solution)
{
    int l;
    for (l = 0; l < POSES; ++l) {
        const stewart_real H_1_leg1 = columns[0].H[1][l], H_0_leg1 = columns[0].H[0][l], H_2_leg1 = columns[0].H[2][l];
        const stewart_real H_1_leg2 = columns[1].H[1][l], H_0_leg2 = columns[1].H[0][l], H_2_leg2 = columns[1].H[2][l],
            H_3_leg2 = columns[1].H[3][l], H_4_leg2 = columns[1].H[4][l], H_5_leg2 = columns[1].H[5][l];
        const stewart_real H_1_leg3 = columns[2].H[1][l], H_0_leg3 = columns[2].H[0][l], H_2_leg3 = columns[2].H[2][l],
            H_3_leg3 = columns[2].H[3][l], H_4_leg3 = columns[2].H[4][l], H_5_leg3 = columns[2].H[5][l];
        const stewart_real H_1_leg4 = columns[3].H[1][l], H_0_leg4 = columns[3].H[0][l], H_2_leg4 = columns[3].H[2][l],
            H_3_leg4 = columns[3].H[3][l], H_4_leg4 = columns[3].H[4][l], H_5_leg4 = columns[3].H[5][l];
        const stewart_real H_1_leg5 = columns[4].H[1][l], H_0_leg5 = columns[4].H[0][l], H_2_leg5 = columns[4].H[2][l],
            H_3_leg5 = columns[4].H[3][l], H_4_leg5 = columns[4].H[4][l], H_5_leg5 = columns[4].H[5][l];
        const stewart_real H_1_leg6 = columns[5].H[1][l], H_0_leg6 = columns[5].H[0][l], H_2_leg6 = columns[5].H[2][l],
            H_3_leg6 = columns[5].H[3][l], H_4_leg6 = columns[5].H[4][l], H_5_leg6 = columns[5].H[5][l];
        const stewart_real c_1 = right_side->c[1][l], c_0 = right_side->c[0][l], c_2 = right_side->c[2][l],
            c_3 = right_side->c[3][l], c_4 = right_side->c[4][l], c_5 = right_side->c[5][l];
        const stewart_real below_1_0 = STEWART_FABS(H_1_leg1) > STEWART_FABS(H_0_leg1) ? REAL(1) : REAL(0);
        const stewart_real row_0_leg1 = below_1_0 > REAL(0) ? H_1_leg1 : H_0_leg1;
        const stewart_real row_0_leg2 = below_1_0 > REAL(0) ? H_1_leg2 : H_0_leg2;
        const stewart_real row_0_leg3 = below_1_0 > REAL(0) ? H_1_leg3 : H_0_leg3;
        const stewart_real row_0_leg4 = below_1_0 > REAL(0) ? H_1_leg4 : H_0_leg4;
        const stewart_real row_0_leg5 = below_1_0 > REAL(0) ? H_1_leg5 : H_0_leg5;
        const stewart_real row_0_leg6 = below_1_0 > REAL(0) ? H_1_leg6 : H_0_leg6;
        const stewart_real row_1_leg1 = below_1_0 > REAL(0) ? H_0_leg1 : H_1_leg1;
        const stewart_real row_1_leg2 = below_1_0 > REAL(0) ? H_0_leg2 : H_1_leg2;
        const stewart_real row_1_leg3 = below_1_0 > REAL(0) ? H_0_leg3 : H_1_leg3;
        const stewart_real row_1_leg4 = below_1_0 > REAL(0) ? H_0_leg4 : H_1_leg4;
        const stewart_real row_1_leg5 = below_1_0 > REAL(0) ? H_0_leg5 : H_1_leg5;
        const stewart_real row_1_leg6 = below_1_0 > REAL(0) ? H_0_leg6 : H_1_leg6;
        const stewart_real right_0 = below_1_0 > REAL(0) ? c_1 : c_0;
        const stewart_real right_1 = below_1_0 > REAL(0) ? c_0 : c_1;
        const stewart_real below_2_0 = STEWART_FABS(H_2_leg1) > STEWART_FABS(row_0_leg1) ? REAL(1) : REAL(0);
        const stewart_real row_0_2_leg1 = below_2_0 > REAL(0) ? H_2_leg1 : row_0_leg1;
        const stewart_real row_0_2_leg2 = below_2_0 > REAL(0) ? H_2_leg2 : row_0_leg2;
        const stewart_real row_0_2_leg3 = below_2_0 > REAL(0) ? H_2_leg3 : row_0_leg3;
        const stewart_real row_0_2_leg4 = below_2_0 > REAL(0) ? H_2_leg4 : row_0_leg4;
        const stewart_real row_0_2_leg5 = below_2_0 > REAL(0) ? H_2_leg5 : row_0_leg5;
        const stewart_real row_0_2_leg6 = below_2_0 > REAL(0) ? H_2_leg6 : row_0_leg6;
        const stewart_real row_2_leg1 = below_2_0 > REAL(0) ? row_0_leg1 : H_2_leg1;
        const stewart_real row_2_leg2 = below_2_0 > REAL(0) ? row_0_leg2 : H_2_leg2;
        const stewart_real row_2_leg3 = below_2_0 > REAL(0) ? row_0_leg3 : H_2_leg3;
        const stewart_real row_2_leg4 = below_2_0 > REAL(0) ? row_0_leg4 : H_2_leg4;
        const stewart_real row_2_leg5 = below_2_0 > REAL(0) ? row_0_leg5 : H_2_leg5;
        const stewart_real row_2_leg6 = below_2_0 > REAL(0) ? row_0_leg6 : H_2_leg6;
        const stewart_real right_0_2 = below_2_0 > REAL(0) ? c_2 : right_0;
        const stewart_real right_2 = below_2_0 > REAL(0) ? right_0 : c_2;
        const stewart_real inverse_0 = REAL(1)/row_0_2_leg1;
        const stewart_real factor_1_0 = row_1_leg1*inverse_0;
        const stewart_real row_1_2_leg2 = STEWART_FMA(-factor_1_0, row_0_2_leg2, row_1_leg2);
        const stewart_real row_1_2_leg3 = STEWART_FMA(-factor_1_0, row_0_2_leg3, row_1_leg3);
        const stewart_real row_1_2_leg4 = STEWART_FMA(-factor_1_0, row_0_2_leg4, row_1_leg4);
        const stewart_real row_1_2_leg5 = STEWART_FMA(-factor_1_0, row_0_2_leg5, row_1_leg5);
        const stewart_real row_1_2_leg6 = STEWART_FMA(-factor_1_0, row_0_2_leg6, row_1_leg6);
        const stewart_real right_1_2 = STEWART_FMA(-factor_1_0, right_0_2, right_1);
        const stewart_real factor_2_0 = row_2_leg1*inverse_0;
        const stewart_real row_2_2_leg2 = STEWART_FMA(-factor_2_0, row_0_2_leg2, row_2_leg2);
        const stewart_real row_2_2_leg3 = STEWART_FMA(-factor_2_0, row_0_2_leg3, row_2_leg3);
        const stewart_real row_2_2_leg4 = STEWART_FMA(-factor_2_0, row_0_2_leg4, row_2_leg4);
        const stewart_real row_2_2_leg5 = STEWART_FMA(-factor_2_0, row_0_2_leg5, row_2_leg5);
        const stewart_real row_2_2_leg6 = STEWART_FMA(-factor_2_0, row_0_2_leg6, row_2_leg6);
        const stewart_real right_2_2 = STEWART_FMA(-factor_2_0, right_0_2, right_2);
        const stewart_real below_2_1 = STEWART_FABS(row_2_2_leg2) > STEWART_FABS(row_1_2_leg2) ? REAL(1) : REAL(0);
        const stewart_real row_1_3_leg2 = below_2_1 > REAL(0) ? row_2_2_leg2 : row_1_2_leg2;
        const stewart_real row_1_3_leg3 = below_2_1 > REAL(0) ? row_2_2_leg3 : row_1_2_leg3;
        const stewart_real row_1_3_leg4 = below_2_1 > REAL(0) ? row_2_2_leg4 : row_1_2_leg4;
        const stewart_real row_1_3_leg5 = below_2_1 > REAL(0) ? row_2_2_leg5 : row_1_2_leg5;
        const stewart_real row_1_3_leg6 = below_2_1 > REAL(0) ? row_2_2_leg6 : row_1_2_leg6;
        const stewart_real row_2_3_leg2 = below_2_1 > REAL(0) ? row_1_2_leg2 : row_2_2_leg2;
        const stewart_real row_2_3_leg3 = below_2_1 > REAL(0) ? row_1_2_leg3 : row_2_2_leg3;
        const stewart_real row_2_3_leg4 = below_2_1 > REAL(0) ? row_1_2_leg4 : row_2_2_leg4;
        const stewart_real row_2_3_leg5 = below_2_1 > REAL(0) ? row_1_2_leg5 : row_2_2_leg5;
        const stewart_real row_2_3_leg6 = below_2_1 > REAL(0) ? row_1_2_leg6 : row_2_2_leg6;
        const stewart_real right_1_3 = below_2_1 > REAL(0) ? right_2_2 : right_1_2;
        const stewart_real right_2_3 = below_2_1 > REAL(0) ? right_1_2 : right_2_2;
        const stewart_real below_3_1 = STEWART_FABS(H_3_leg2) > STEWART_FABS(row_1_3_leg2) ? REAL(1) : REAL(0);
        const stewart_real row_1_4_leg2 = below_3_1 > REAL(0) ? H_3_leg2 : row_1_3_leg2;
        const stewart_real row_1_4_leg3 = below_3_1 > REAL(0) ? H_3_leg3 : row_1_3_leg3;
        const stewart_real row_1_4_leg4 = below_3_1 > REAL(0) ? H_3_leg4 : row_1_3_leg4;
        const stewart_real row_1_4_leg5 = below_3_1 > REAL(0) ? H_3_leg5 : row_1_3_leg5;
        const stewart_real row_1_4_leg6 = below_3_1 > REAL(0) ? H_3_leg6 : row_1_3_leg6;
        const stewart_real row_3_leg2 = below_3_1 > REAL(0) ? row_1_3_leg2 : H_3_leg2;
        const stewart_real row_3_leg3 = below_3_1 > REAL(0) ? row_1_3_leg3 : H_3_leg3;
        const stewart_real row_3_leg4 = below_3_1 > REAL(0) ? row_1_3_leg4 : H_3_leg4;
        const stewart_real row_3_leg5 = below_3_1 > REAL(0) ? row_1_3_leg5 : H_3_leg5;
        const stewart_real row_3_leg6 = below_3_1 > REAL(0) ? row_1_3_leg6 : H_3_leg6;
        const stewart_real right_1_4 = below_3_1 > REAL(0) ? c_3 : right_1_3;
        const stewart_real right_3 = below_3_1 > REAL(0) ? right_1_3 : c_3;
        const stewart_real below_4_1 = STEWART_FABS(H_4_leg2) > STEWART_FABS(row_1_4_leg2) ? REAL(1) : REAL(0);
        const stewart_real row_1_5_leg2 = below_4_1 > REAL(0) ? H_4_leg2 : row_1_4_leg2;
        const stewart_real row_1_5_leg3 = below_4_1 > REAL(0) ? H_4_leg3 : row_1_4_leg3;
        const stewart_real row_1_5_leg4 = below_4_1 > REAL(0) ? H_4_leg4 : row_1_4_leg4;
        const stewart_real row_1_5_leg5 = below_4_1 > REAL(0) ? H_4_leg5 : row_1_4_leg5;
        const stewart_real row_1_5_leg6 = below_4_1 > REAL(0) ? H_4_leg6 : row_1_4_leg6;
        const stewart_real row_4_leg2 = below_4_1 > REAL(0) ? row_1_4_leg2 : H_4_leg2;
        const stewart_real row_4_leg3 = below_4_1 > REAL(0) ? row_1_4_leg3 : H_4_leg3;
        const stewart_real row_4_leg4 = below_4_1 > REAL(0) ? row_1_4_leg4 : H_4_leg4;
        const stewart_real row_4_leg5 = below_4_1 > REAL(0) ? row_1_4_leg5 : H_4_leg5;
        const stewart_real row_4_leg6 = below_4_1 > REAL(0) ? row_1_4_leg6 : H_4_leg6;
        const stewart_real right_1_5 = below_4_1 > REAL(0) ? c_4 : right_1_4;
        const stewart_real right_4 = below_4_1 > REAL(0) ? right_1_4 : c_4;
        const stewart_real below_5_1 = STEWART_FABS(H_5_leg2) > STEWART_FABS(row_1_5_leg2) ? REAL(1) : REAL(0);
        const stewart_real row_1_6_leg2 = below_5_1 > REAL(0) ? H_5_leg2 : row_1_5_leg2;
        const stewart_real row_1_6_leg3 = below_5_1 > REAL(0) ? H_5_leg3 : row_1_5_leg3;
        const stewart_real row_1_6_leg4 = below_5_1 > REAL(0) ? H_5_leg4 : row_1_5_leg4;
        const stewart_real row_1_6_leg5 = below_5_1 > REAL(0) ? H_5_leg5 : row_1_5_leg5;
        const stewart_real row_1_6_leg6 = below_5_1 > REAL(0) ? H_5_leg6 : row_1_5_leg6;
        const stewart_real row_5_leg2 = below_5_1 > REAL(0) ? row_1_5_leg2 : H_5_leg2;
        const stewart_real row_5_leg3 = below_5_1 > REAL(0) ? row_1_5_leg3 : H_5_leg3;
        const stewart_real row_5_leg4 = below_5_1 > REAL(0) ? row_1_5_leg4 : H_5_leg4;
        const stewart_real row_5_leg5 = below_5_1 > REAL(0) ? row_1_5_leg5 : H_5_leg5;
        const stewart_real row_5_leg6 = below_5_1 > REAL(0) ? row_1_5_leg6 : H_5_leg6;
        const stewart_real right_1_6 = below_5_1 > REAL(0) ? c_5 : right_1_5;
        const stewart_real right_5 = below_5_1 > REAL(0) ? right_1_5 : c_5;
        const stewart_real inverse_1 = REAL(1)/row_1_6_leg2;
        const stewart_real factor_2_1 = row_2_3_leg2*inverse_1;
        const stewart_real row_2_4_leg3 = STEWART_FMA(-factor_2_1, row_1_6_leg3, row_2_3_leg3);
        const stewart_real row_2_4_leg4 = STEWART_FMA(-factor_2_1, row_1_6_leg4, row_2_3_leg4);
        const stewart_real row_2_4_leg5 = STEWART_FMA(-factor_2_1, row_1_6_leg5, row_2_3_leg5);
        const stewart_real row_2_4_leg6 = STEWART_FMA(-factor_2_1, row_1_6_leg6, row_2_3_leg6);
        const stewart_real right_2_4 = STEWART_FMA(-factor_2_1, right_1_6, right_2_3);
        const stewart_real factor_3_1 = row_3_leg2*inverse_1;
        const stewart_real row_3_2_leg3 = STEWART_FMA(-factor_3_1, row_1_6_leg3, row_3_leg3);
        const stewart_real row_3_2_leg4 = STEWART_FMA(-factor_3_1, row_1_6_leg4, row_3_leg4);
        const stewart_real row_3_2_leg5 = STEWART_FMA(-factor_3_1, row_1_6_leg5, row_3_leg5);
        const stewart_real row_3_2_leg6 = STEWART_FMA(-factor_3_1, row_1_6_leg6, row_3_leg6);
        const stewart_real right_3_2 = STEWART_FMA(-factor_3_1, right_1_6, right_3);
        const stewart_real factor_4_1 = row_4_leg2*inverse_1;
        const stewart_real row_4_2_leg3 = STEWART_FMA(-factor_4_1, row_1_6_leg3, row_4_leg3);
        const stewart_real row_4_2_leg4 = STEWART_FMA(-factor_4_1, row_1_6_leg4, row_4_leg4);
        const stewart_real row_4_2_leg5 = STEWART_FMA(-factor_4_1, row_1_6_leg5, row_4_leg5);
        const stewart_real row_4_2_leg6 = STEWART_FMA(-factor_4_1, row_1_6_leg6, row_4_leg6);
        const stewart_real right_4_2 = STEWART_FMA(-factor_4_1, right_1_6, right_4);
        const stewart_real factor_5_1 = row_5_leg2*inverse_1;
        const stewart_real row_5_2_leg3 = STEWART_FMA(-factor_5_1, row_1_6_leg3, row_5_leg3);
        const stewart_real row_5_2_leg4 = STEWART_FMA(-factor_5_1, row_1_6_leg4, row_5_leg4);
        const stewart_real row_5_2_leg5 = STEWART_FMA(-factor_5_1, row_1_6_leg5, row_5_leg5);
        const stewart_real row_5_2_leg6 = STEWART_FMA(-factor_5_1, row_1_6_leg6, row_5_leg6);
        const stewart_real right_5_2 = STEWART_FMA(-factor_5_1, right_1_6, right_5);
        const stewart_real below_3_2 = STEWART_FABS(row_3_2_leg3) > STEWART_FABS(row_2_4_leg3) ? REAL(1) : REAL(0);
        const stewart_real row_2_5_leg3 = below_3_2 > REAL(0) ? row_3_2_leg3 : row_2_4_leg3;
        const stewart_real row_2_5_leg4 = below_3_2 > REAL(0) ? row_3_2_leg4 : row_2_4_leg4;
        const stewart_real row_2_5_leg5 = below_3_2 > REAL(0) ? row_3_2_leg5 : row_2_4_leg5;
        const stewart_real row_2_5_leg6 = below_3_2 > REAL(0) ? row_3_2_leg6 : row_2_4_leg6;
        const stewart_real row_3_3_leg3 = below_3_2 > REAL(0) ? row_2_4_leg3 : row_3_2_leg3;
        const stewart_real row_3_3_leg4 = below_3_2 > REAL(0) ? row_2_4_leg4 : row_3_2_leg4;
        const stewart_real row_3_3_leg5 = below_3_2 > REAL(0) ? row_2_4_leg5 : row_3_2_leg5;
        const stewart_real row_3_3_leg6 = below_3_2 > REAL(0) ? row_2_4_leg6 : row_3_2_leg6;
        const stewart_real right_2_5 = below_3_2 > REAL(0) ? right_3_2 : right_2_4;
        const stewart_real right_3_3 = below_3_2 > REAL(0) ? right_2_4 : right_3_2;
        const stewart_real below_4_2 = STEWART_FABS(row_4_2_leg3) > STEWART_FABS(row_2_5_leg3) ? REAL(1) : REAL(0);
        const stewart_real row_2_6_leg3 = below_4_2 > REAL(0) ? row_4_2_leg3 : row_2_5_leg3;
        const stewart_real row_2_6_leg4 = below_4_2 > REAL(0) ? row_4_2_leg4 : row_2_5_leg4;
        const stewart_real row_2_6_leg5 = below_4_2 > REAL(0) ? row_4_2_leg5 : row_2_5_leg5;
        const stewart_real row_2_6_leg6 = below_4_2 > REAL(0) ? row_4_2_leg6 : row_2_5_leg6;
        const stewart_real row_4_3_leg3 = below_4_2 > REAL(0) ? row_2_5_leg3 : row_4_2_leg3;
        const stewart_real row_4_3_leg4 = below_4_2 > REAL(0) ? row_2_5_leg4 : row_4_2_leg4;
        const stewart_real row_4_3_leg5 = below_4_2 > REAL(0) ? row_2_5_leg5 : row_4_2_leg5;
        const stewart_real row_4_3_leg6 = below_4_2 > REAL(0) ? row_2_5_leg6 : row_4_2_leg6;
        const stewart_real right_2_6 = below_4_2 > REAL(0) ? right_4_2 : right_2_5;
        const stewart_real right_4_3 = below_4_2 > REAL(0) ? right_2_5 : right_4_2;
        const stewart_real below_5_2 = STEWART_FABS(row_5_2_leg3) > STEWART_FABS(row_2_6_leg3) ? REAL(1) : REAL(0);
        const stewart_real row_2_7_leg3 = below_5_2 > REAL(0) ? row_5_2_leg3 : row_2_6_leg3;
        const stewart_real row_2_7_leg4 = below_5_2 > REAL(0) ? row_5_2_leg4 : row_2_6_leg4;
        const stewart_real row_2_7_leg5 = below_5_2 > REAL(0) ? row_5_2_leg5 : row_2_6_leg5;
        const stewart_real row_2_7_leg6 = below_5_2 > REAL(0) ? row_5_2_leg6 : row_2_6_leg6;
        const stewart_real row_5_3_leg3 = below_5_2 > REAL(0) ? row_2_6_leg3 : row_5_2_leg3;
        const stewart_real row_5_3_leg4 = below_5_2 > REAL(0) ? row_2_6_leg4 : row_5_2_leg4;
        const stewart_real row_5_3_leg5 = below_5_2 > REAL(0) ? row_2_6_leg5 : row_5_2_leg5;
        const stewart_real row_5_3_leg6 = below_5_2 > REAL(0) ? row_2_6_leg6 : row_5_2_leg6;
        const stewart_real right_2_7 = below_5_2 > REAL(0) ? right_5_2 : right_2_6;
        const stewart_real right_5_3 = below_5_2 > REAL(0) ? right_2_6 : right_5_2;
        const stewart_real inverse_2 = REAL(1)/row_2_7_leg3;
        const stewart_real factor_3_2 = row_3_3_leg3*inverse_2;
        const stewart_real row_3_4_leg4 = STEWART_FMA(-factor_3_2, row_2_7_leg4, row_3_3_leg4);
        const stewart_real row_3_4_leg5 = STEWART_FMA(-factor_3_2, row_2_7_leg5, row_3_3_leg5);
        const stewart_real row_3_4_leg6 = STEWART_FMA(-factor_3_2, row_2_7_leg6, row_3_3_leg6);
        const stewart_real right_3_4 = STEWART_FMA(-factor_3_2, right_2_7, right_3_3);
        const stewart_real factor_4_2 = row_4_3_leg3*inverse_2;
        const stewart_real row_4_4_leg4 = STEWART_FMA(-factor_4_2, row_2_7_leg4, row_4_3_leg4);
        const stewart_real row_4_4_leg5 = STEWART_FMA(-factor_4_2, row_2_7_leg5, row_4_3_leg5);
        const stewart_real row_4_4_leg6 = STEWART_FMA(-factor_4_2, row_2_7_leg6, row_4_3_leg6);
        const stewart_real right_4_4 = STEWART_FMA(-factor_4_2, right_2_7, right_4_3);
        const stewart_real factor_5_2 = row_5_3_leg3*inverse_2;
        const stewart_real row_5_4_leg4 = STEWART_FMA(-factor_5_2, row_2_7_leg4, row_5_3_leg4);
        const stewart_real row_5_4_leg5 = STEWART_FMA(-factor_5_2, row_2_7_leg5, row_5_3_leg5);
        const stewart_real row_5_4_leg6 = STEWART_FMA(-factor_5_2, row_2_7_leg6, row_5_3_leg6);
        const stewart_real right_5_4 = STEWART_FMA(-factor_5_2, right_2_7, right_5_3);
        const stewart_real below_4_3 = STEWART_FABS(row_4_4_leg4) > STEWART_FABS(row_3_4_leg4) ? REAL(1) : REAL(0);
        const stewart_real row_3_5_leg4 = below_4_3 > REAL(0) ? row_4_4_leg4 : row_3_4_leg4;
        const stewart_real row_3_5_leg5 = below_4_3 > REAL(0) ? row_4_4_leg5 : row_3_4_leg5;
        const stewart_real row_3_5_leg6 = below_4_3 > REAL(0) ? row_4_4_leg6 : row_3_4_leg6;
        const stewart_real row_4_5_leg4 = below_4_3 > REAL(0) ? row_3_4_leg4 : row_4_4_leg4;
        const stewart_real row_4_5_leg5 = below_4_3 > REAL(0) ? row_3_4_leg5 : row_4_4_leg5;
        const stewart_real row_4_5_leg6 = below_4_3 > REAL(0) ? row_3_4_leg6 : row_4_4_leg6;
        const stewart_real right_3_5 = below_4_3 > REAL(0) ? right_4_4 : right_3_4;
        const stewart_real right_4_5 = below_4_3 > REAL(0) ? right_3_4 : right_4_4;
        const stewart_real below_5_3 = STEWART_FABS(row_5_4_leg4) > STEWART_FABS(row_3_5_leg4) ? REAL(1) : REAL(0);
        const stewart_real row_3_6_leg4 = below_5_3 > REAL(0) ? row_5_4_leg4 : row_3_5_leg4;
        const stewart_real row_3_6_leg5 = below_5_3 > REAL(0) ? row_5_4_leg5 : row_3_5_leg5;
        const stewart_real row_3_6_leg6 = below_5_3 > REAL(0) ? row_5_4_leg6 : row_3_5_leg6;
        const stewart_real row_5_5_leg4 = below_5_3 > REAL(0) ? row_3_5_leg4 : row_5_4_leg4;
        const stewart_real row_5_5_leg5 = below_5_3 > REAL(0) ? row_3_5_leg5 : row_5_4_leg5;
        const stewart_real row_5_5_leg6 = below_5_3 > REAL(0) ? row_3_5_leg6 : row_5_4_leg6;
        const stewart_real right_3_6 = below_5_3 > REAL(0) ? right_5_4 : right_3_5;
        const stewart_real right_5_5 = below_5_3 > REAL(0) ? right_3_5 : right_5_4;
        const stewart_real inverse_3 = REAL(1)/row_3_6_leg4;
        const stewart_real factor_4_3 = row_4_5_leg4*inverse_3;
        const stewart_real row_4_6_leg5 = STEWART_FMA(-factor_4_3, row_3_6_leg5, row_4_5_leg5);
        const stewart_real row_4_6_leg6 = STEWART_FMA(-factor_4_3, row_3_6_leg6, row_4_5_leg6);
        const stewart_real right_4_6 = STEWART_FMA(-factor_4_3, right_3_6, right_4_5);
        const stewart_real factor_5_3 = row_5_5_leg4*inverse_3;
        const stewart_real row_5_6_leg5 = STEWART_FMA(-factor_5_3, row_3_6_leg5, row_5_5_leg5);
        const stewart_real row_5_6_leg6 = STEWART_FMA(-factor_5_3, row_3_6_leg6, row_5_5_leg6);
        const stewart_real right_5_6 = STEWART_FMA(-factor_5_3, right_3_6, right_5_5);
        const stewart_real below_5_4 = STEWART_FABS(row_5_6_leg5) > STEWART_FABS(row_4_6_leg5) ? REAL(1) : REAL(0);
        const stewart_real row_4_7_leg5 = below_5_4 > REAL(0) ? row_5_6_leg5 : row_4_6_leg5;
        const stewart_real row_4_7_leg6 = below_5_4 > REAL(0) ? row_5_6_leg6 : row_4_6_leg6;
        const stewart_real row_5_7_leg5 = below_5_4 > REAL(0) ? row_4_6_leg5 : row_5_6_leg5;
        const stewart_real row_5_7_leg6 = below_5_4 > REAL(0) ? row_4_6_leg6 : row_5_6_leg6;
        const stewart_real right_4_7 = below_5_4 > REAL(0) ? right_5_6 : right_4_6;
        const stewart_real right_5_7 = below_5_4 > REAL(0) ? right_4_6 : right_5_6;
        const stewart_real inverse_4 = REAL(1)/row_4_7_leg5;
        const stewart_real factor_5_4 = row_5_7_leg5*inverse_4;
        const stewart_real row_5_8_leg6 = STEWART_FMA(-factor_5_4, row_4_7_leg6, row_5_7_leg6);
        const stewart_real right_5_8 = STEWART_FMA(-factor_5_4, right_4_7, right_5_7);
        const stewart_real y_5 = right_5_8/row_5_8_leg6;
        const stewart_real y_4 = STEWART_FMA(-row_4_7_leg6, y_5, right_4_7)*inverse_4;
        const stewart_real y_3 = STEWART_FMA(-row_3_6_leg6, y_5, STEWART_FMA(-row_3_6_leg5, y_4,
            right_3_6))*inverse_3;
        const stewart_real y_2 = STEWART_FMA(-row_2_7_leg6, y_5, STEWART_FMA(-row_2_7_leg5, y_4,
            STEWART_FMA(-row_2_7_leg4, y_3, right_2_7)))*inverse_2;
        const stewart_real y_1 = STEWART_FMA(-row_1_6_leg6, y_5, STEWART_FMA(-row_1_6_leg5, y_4,
            STEWART_FMA(-row_1_6_leg4, y_3, STEWART_FMA(-row_1_6_leg3, y_2, right_1_6))))*inverse_1;
        const stewart_real y_0 = STEWART_FMA(-row_0_2_leg6, y_5, STEWART_FMA(-row_0_2_leg5, y_4,
            STEWART_FMA(-row_0_2_leg4, y_3, STEWART_FMA(-row_0_2_leg3, y_2, STEWART_FMA(-row_0_2_leg2, y_1,
            right_0_2)))))*inverse_0;
        const stewart_real small = STEWART_FABS(row_0_2_leg1) > STEWART_SUSPECT ? REAL(0) : REAL(1);
        const stewart_real small_2 = STEWART_FABS(row_1_6_leg2) > STEWART_SUSPECT ? small : REAL(1);
        const stewart_real small_3 = STEWART_FABS(row_2_7_leg3) > STEWART_SUSPECT ? small_2 : REAL(1);
        const stewart_real small_4 = STEWART_FABS(row_3_6_leg4) > STEWART_SUSPECT ? small_3 : REAL(1);
        const stewart_real small_5 = STEWART_FABS(row_4_7_leg5) > STEWART_SUSPECT ? small_4 : REAL(1);
        const stewart_real small_6 = STEWART_FABS(row_5_8_leg6) > STEWART_SUSPECT ? small_5 : REAL(1);
        solution->x[0][l] = y_0;
        solution->x[1][l] = y_1;
        solution->x[2][l] = y_2;
        solution->x[3][l] = y_3;
        solution->x[4][l] = y_4;
        solution->x[5][l] = y_5;
        solution->suspect[l] = small_6;
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
