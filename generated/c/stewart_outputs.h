/* stewart_outputs.h: the solve of kernels with every output, and poses of their batches, for the sources to
 * include.
 *
 * Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#ifndef STEWART_OUTPUTS_H
#define STEWART_OUTPUTS_H

#include "stewart_solve.h"

/* Solves [H | c] for x by elimination with partial pivoting, (36); returns 1 where a pivot is small. */
STEWART_SHARED int eliminate(stewart_real A[6][7], stewart_real x[6])
{
    int i, j, k;
    stewart_real inverse[6];
    int suspect = 0;
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        stewart_real most = STEWART_FABS(A[k][k]);
        for (i = k + 1; i < 6; ++i) {
            const stewart_real entry = STEWART_FABS(A[i][k]);
            pivot = entry > most ? i : pivot;
            most = entry > most ? entry : most;
        }
        if (pivot != k) {
            for (j = 0; j < 7; ++j) {
                const stewart_real moved = A[k][j];
                A[k][j] = A[pivot][j];
                A[pivot][j] = moved;
            }
        }
        suspect = STEWART_FABS(A[k][k]) > STEWART_SUSPECT ? suspect : 1;
        inverse[k] = REAL(1)/A[k][k];
        for (i = k + 1; i < 6; ++i) {
            const stewart_real factor = A[i][k]*inverse[k];
            for (j = k + 1; j < 7; ++j) {
                A[i][j] = STEWART_FMA(-factor, A[k][j], A[i][j]);
            }
        }
    }
    for (i = 5; i >= 0; --i) {
        stewart_real total = A[i][6];
        for (j = i + 1; j < 6; ++j) {
            total = STEWART_FMA(-A[i][j], x[j], total);
        }
        x[i] = total*inverse[i];
    }
    return suspect;
}

/* What is wrong with a leg: not finite, short beside the vectors that it is the sum of, or along k. */
STEWART_SHARED int status_of_leg(stewart_real L, stewart_real k3, stewart_real reach)
{
    if (!(L <= STEWART_MAX)) {
        return STEWART_NOT_FINITE;
    }
    if (!(L > STEWART_ROUNDING*reach && L > STEWART_SHORTEST)) {
        return STEWART_ZERO_LENGTH;
    }
    if (!(k3 > STEWART_JOINT_SINGULAR_SINE)) {
        return STEWART_JOINT_SINGULAR;
    }
    return STEWART_OK;
}

/* 1 where all numbers are finite, else 0. */
STEWART_SHARED int is_finite(const stewart_real *values, int count)
{
    int i;
    for (i = 0; i < count; ++i) {
        if (!(STEWART_FABS(values[i]) <= STEWART_MAX)) {
            return 0;
        }
    }
    return 1;
}

/* One pose of a batch; zeros for what may be null and is. */
STEWART_SHARED stewart_motions pose_at(
    const stewart_motions *motions, size_t pose, const stewart_real zeros[3])
{
    stewart_motions at;
    at.R = &motions->R[9U*pose];
    at.t = &motions->t[3U*pose];
    at.omega = &motions->omega[3U*pose];
    at.v = &motions->v[3U*pose];
    at.alpha = &motions->alpha[3U*pose];
    at.a = &motions->a[3U*pose];
    at.F_ext = motions->F_ext != NULL ? &motions->F_ext[3U*pose] : zeros;
    at.M_ext = motions->M_ext != NULL ? &motions->M_ext[3U*pose] : zeros;
    return at;
}

/* A pose that is one of many. */
STEWART_SHARED stewart_motions motion_as_arrays(const stewart_motion *motion)
{
    stewart_motions at;
    at.R = motion->R;
    at.t = motion->t;
    at.omega = motion->omega;
    at.v = motion->v;
    at.alpha = motion->alpha;
    at.a = motion->a;
    at.F_ext = motion->F_ext;
    at.M_ext = motion->M_ext;
    return at;
}

/* The numbers of a pose in an array of all poses, if there is one. */
STEWART_SHARED void copy(stewart_real *to, size_t pose, const stewart_real *values, size_t count)
{
    size_t i;
    if (to != NULL) {
        for (i = 0; i < count; ++i) {
            to[pose*count + i] = values[i];
        }
    }
}

#endif
