/* stewart_solve.h: common functions for the platform's six equations H x = c, included by the sources of kernels.
 *
 * They add the contributions of the legs, scale moments and axes, and test if H is singular.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#ifndef STEWART_SOLVE_H
#define STEWART_SOLVE_H

#include "stewart_arithmetic.h"

/* Contributions of a leg to the constants of the platform. */
typedef struct {
    stewart_real M_add;
    stewart_real h_add[3];
    stewart_real J_add[6];
    stewart_real C_add;
} lumped_terms;

/* Returns the cube of a length; lengths above 2^40 are replaced by 2^40 to avoid overflow. */
STEWART_SHARED stewart_real cube_of(stewart_real arm)
{
    const stewart_real length = arm <= REAL(1099511627776.0) ? arm : REAL(1099511627776.0);
    return length*length*length;
}

/* Returns the factor (1/m) of moments in the linear solver for arms whose largest coordinate is `size`
 * (m). It is 1 from `smallest` to 16 m. Otherwise it is the reciprocal of the smallest power of two,
 * from 2^-100 to 2^100, that is not below `size`. */
STEWART_SHARED stewart_real per_length_of(stewart_real size, stewart_real smallest)
{
    int i;
    stewart_real per_length = REAL(1);
    if (size < smallest || size > REAL(16)) {
        stewart_real unit = REAL(1);
        for (i = 0; i < 100; ++i) {
            if (unit < size) {
                unit = REAL(2)*unit;
            } else {
                break;
            }
        }
        for (i = 0; i < 100; ++i) {
            if (size > REAL(0) && STEWART_HALF*unit >= size) {
                unit = STEWART_HALF*unit;
            } else {
                break;
            }
        }
        per_length = REAL(1)/unit;
    }
    return per_length;
}

/* Multiplies a fixed axis of any length by a power of two, so that its square does not overflow or
 * underflow. */
STEWART_SHARED void scaled_axis(const stewart_real k[3], stewart_real out[3])
{
    int i, j;
    for (j = 0; j < 3; ++j) {
        out[j] = k[j];
    }
    for (i = 0; i < 64; ++i) {
        stewart_real by = REAL(1);
        stewart_real most = STEWART_FABS(out[0]);
        most = STEWART_LARGER(STEWART_FABS(out[1]), most);
        most = STEWART_LARGER(STEWART_FABS(out[2]), most);
        by = most > REAL(1048576) ? REAL(1)/REAL(4294967296.0) : by;
        by = most < REAL(1)/REAL(1048576) ? REAL(4294967296.0) : by;
        for (j = 0; j < 3; ++j) {
            out[j] = by*out[j];
        }
    }
}

/* Sets the sum over the legs to zero. */
STEWART_SHARED void clear_lumped(lumped_terms *sum)
{
    sum->M_add = REAL(0);
    sum->h_add[0] = REAL(0);
    sum->h_add[1] = REAL(0);
    sum->h_add[2] = REAL(0);
    sum->J_add[0] = REAL(0);
    sum->J_add[1] = REAL(0);
    sum->J_add[2] = REAL(0);
    sum->J_add[3] = REAL(0);
    sum->J_add[4] = REAL(0);
    sum->J_add[5] = REAL(0);
    sum->C_add = REAL(0);
}

/* Adds the contributions of a leg to the sum. */
STEWART_SHARED void add_lumped(lumped_terms *sum, const lumped_terms *more)
{
    sum->M_add = sum->M_add + more->M_add;
    sum->h_add[0] = sum->h_add[0] + more->h_add[0];
    sum->h_add[1] = sum->h_add[1] + more->h_add[1];
    sum->h_add[2] = sum->h_add[2] + more->h_add[2];
    sum->J_add[0] = sum->J_add[0] + more->J_add[0];
    sum->J_add[1] = sum->J_add[1] + more->J_add[1];
    sum->J_add[2] = sum->J_add[2] + more->J_add[2];
    sum->J_add[3] = sum->J_add[3] + more->J_add[3];
    sum->J_add[4] = sum->J_add[4] + more->J_add[4];
    sum->J_add[5] = sum->J_add[5] + more->J_add[5];
    sum->C_add = sum->C_add + more->C_add;
}

/* Returns the largest of ``least`` and the magnitudes of a vector's components. */
STEWART_SHARED stewart_real largest_component(const stewart_real vector[3], stewart_real least)
{
    int j;
    stewart_real most = least;
    for (j = 0; j < 3; ++j) {
        most = STEWART_LARGER(STEWART_FABS(vector[j]), most);
    }
    return most;
}

/* Returns the status of a leg: not finite, short compared with the vectors in its sum, along k, or OK. */
STEWART_APART STEWART_SHARED int fault_of(stewart_real L, stewart_real k3, stewart_real reach)
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

/* Returns SINGULAR if H is singular to rounding, NOT_FINITE, or OK; H is overwritten.
 *
 * arm (m): moment arms; L (m): lengths of the legs; reach (m): largest component of the vectors whose
 * sum is a leg. tip (m): largest component of the platform point from which the arms are measured, 0 for
 * the reference point.
 *
 * Let Y be the inverse of H. The error of the direction s of a leg is at most 4 epsilon (reach / L + 2).
 * Each input and each operation is rounded by half a unit, and the elimination adds its own error. This
 * error changes the column (s, arm x s) of H, and Y_force + Y_moment x arm is its factor for any center
 * of moments. The rounding of the moment is added.
 *
 * G_ik bounds the effect of the error of column k on row i of Y H. If H minus its error is singular, no
 * v > 0 satisfies G v < v, and the spectral radius of G is at least 1. v is computed by powers of G. The
 * limit 1/2 covers the errors of Y. */
STEWART_APART STEWART_SHARED int singular_status(
    stewart_real H[6][6], stewart_real arm[6][3], const stewart_real L[6], const stewart_real reach[6],
    stewart_real tip)
{
    int i, j, k, turn;
    stewart_real Y[6][6];
    stewart_real G[6][6];
    stewart_real v[6];
    stewart_real grown[6];
    stewart_real extent = tip;
    stewart_real least = REAL(1);
    for (i = 0; i < 6; ++i) {
        v[i] = REAL(1);
        for (j = 0; j < 3; ++j) {
            extent = STEWART_LARGER(STEWART_FABS(arm[i][j]), extent);
        }
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            if (!(STEWART_FABS(H[i][j]) <= STEWART_MAX)) {
                return STEWART_NOT_FINITE;
            }
            H[i][j] = i < 3 ? H[i][j] : H[i][j]/extent;
            Y[i][j] = i == j ? REAL(1) : REAL(0);
        }
    }
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        stewart_real most = STEWART_FABS(H[k][k]);
        for (i = k + 1; i < 6; ++i) {
            const stewart_real entry = STEWART_FABS(H[i][k]);
            pivot = entry > most ? i : pivot;
            most = entry > most ? entry : most;
        }
        if (pivot != k) {
            for (j = 0; j < 6; ++j) {
                const stewart_real moved = H[k][j];
                H[k][j] = H[pivot][j];
                H[pivot][j] = moved;
                const stewart_real beside = Y[k][j];
                Y[k][j] = Y[pivot][j];
                Y[pivot][j] = beside;
            }
        }
        if (!(STEWART_FABS(H[k][k]) > REAL(0))) {
            return STEWART_SINGULAR;
        }
        for (i = 0; i < 6; ++i) {
            if (i != k) {
                const stewart_real factor = H[i][k]/H[k][k];
                for (j = 0; j < 6; ++j) {
                    H[i][j] = STEWART_FMA(-factor, H[k][j], H[i][j]);
                    Y[i][j] = STEWART_FMA(-factor, Y[k][j], Y[i][j]);
                }
            }
        }
    }
    for (i = 0; i < 6; ++i) {
        const stewart_real by_moment = STEWART_FABS(Y[i][3]) + STEWART_FABS(Y[i][4]) + STEWART_FABS(Y[i][5]);
        for (k = 0; k < 6; ++k) {
            const stewart_real x = STEWART_FABS(Y[i][0] + STEWART_FMA(-Y[i][5], arm[k][1],
                Y[i][4]*arm[k][2])/extent);
            const stewart_real y = STEWART_FABS(Y[i][1] + STEWART_FMA(-Y[i][3], arm[k][2],
                Y[i][5]*arm[k][0])/extent);
            const stewart_real z = STEWART_FABS(Y[i][2] + STEWART_FMA(-Y[i][4], arm[k][0],
                Y[i][3]*arm[k][1])/extent);
            const stewart_real turned = STEWART_FMA(REAL(2), by_moment, (x + y + z)*(reach[k]/L[k] + REAL(2)));
            G[i][k] = turned*(REAL(4)*STEWART_EPSILON)/STEWART_FABS(H[i][i]);
        }
    }
    for (turn = 0; turn < 4; ++turn) {
        if (least > STEWART_HALF) {
            stewart_real worst = REAL(0);
            stewart_real greatest = REAL(0);
            for (i = 0; i < 6; ++i) {
                stewart_real total = REAL(0);
                for (k = 0; k < 6; ++k) {
                    total = STEWART_FMA(G[i][k], v[k], total);
                }
                const stewart_real share = total/v[i];
                worst = share <= worst ? worst : share;
                greatest = STEWART_LARGER(total, greatest);
                grown[i] = total;
            }
            least = worst <= least ? worst : least;
            for (i = 0; i < 6; ++i) {
                v[i] = STEWART_LARGER(grown[i]/greatest, STEWART_EPSILON);
            }
        } else {
            break;
        }
    }
    if (!(least <= STEWART_HALF)) {
        return STEWART_SINGULAR;
    }
    return STEWART_OK;
}

#endif
