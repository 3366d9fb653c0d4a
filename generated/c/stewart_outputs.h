/* stewart_outputs.h: platform's part of c, linear solver, and batches of the complete inverse dynamics, included by
 * the sources of kernels.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#ifndef STEWART_OUTPUTS_H
#define STEWART_OUTPUTS_H

#include "stewart_solve.h"

typedef struct {
    stewart_real c_force[3]; /* N: part of c, force rows, base frame */
    stewart_real c_moment[3]; /* N m: part of c, moment rows, base frame */
} platform_terms;

/* Part of c that belongs to the platform, (33)-(35). Operations: 219 (123 mul, 96 add, 0 div, 0 sqrt). */
STEWART_SHARED void platform_wrench(
    const stewart_robot *robot, const stewart_motions *at, platform_terms *out)
{
    const stewart_real R_xx = at->R[0], R_xy = at->R[1], R_xz = at->R[2], R_yx = at->R[3], R_yy = at->R[4],
        R_yz = at->R[5], R_zx = at->R[6], R_zy = at->R[7], R_zz = at->R[8];
    const stewart_real omega_x = at->omega[0], omega_y = at->omega[1], omega_z = at->omega[2];
    const stewart_real alpha_x = at->alpha[0], alpha_y = at->alpha[1], alpha_z = at->alpha[2];
    const stewart_real a_x = at->a[0], a_y = at->a[1], a_z = at->a[2];
    const stewart_real F_ext_x = at->F_ext[0], F_ext_y = at->F_ext[1], F_ext_z = at->F_ext[2];
    const stewart_real M_ext_x = at->M_ext[0], M_ext_y = at->M_ext[1], M_ext_z = at->M_ext[2];
    const stewart_real M = robot->M;
    const stewart_real R_0_x = robot->R_0[0], R_0_y = robot->R_0[1], R_0_z = robot->R_0[2];
    const stewart_real I_p_xx = robot->I_p[0], I_p_xy = robot->I_p[1], I_p_xz = robot->I_p[2], I_p_yy = robot->I_p[3],
        I_p_yz = robot->I_p[4], I_p_zz = robot->I_p[5];
    const stewart_real g_x = robot->g[0], g_y = robot->g[1], g_z = robot->g[2];
    /* (30) center of mass from the reference point, base frame */
    const stewart_real R_G_x = STEWART_FMA(R_0_z, R_xz, STEWART_FMA(R_0_y, R_xy, R_0_x*R_xx));
    const stewart_real R_G_y = STEWART_FMA(R_0_z, R_yz, STEWART_FMA(R_0_y, R_yy, R_0_x*R_yx));
    const stewart_real R_G_z = STEWART_FMA(R_0_z, R_zz, STEWART_FMA(R_0_y, R_zy, R_0_x*R_zx));
    const stewart_real c1 = STEWART_FMA(-R_G_x, omega_y, R_G_y*omega_x);
    const stewart_real c2 = STEWART_FMA(-R_G_z, omega_x, R_G_x*omega_z);
    const stewart_real c3 = STEWART_FMA(-R_G_y, omega_z, R_G_z*omega_y);
    /* (31) acceleration of the center of mass */
    const stewart_real a_G_x = STEWART_FMA(-c2, omega_z, STEWART_FMA(c1, omega_y, STEWART_FMA(-R_G_y,
        alpha_z, STEWART_FMA(R_G_z, alpha_y, a_x))));
    const stewart_real a_G_y = STEWART_FMA(-c1, omega_x, STEWART_FMA(c3, omega_z, STEWART_FMA(-R_G_z,
        alpha_x, STEWART_FMA(R_G_x, alpha_z, a_y))));
    const stewart_real a_G_z = STEWART_FMA(-c3, omega_y, STEWART_FMA(c2, omega_x, STEWART_FMA(-R_G_x,
        alpha_y, STEWART_FMA(R_G_y, alpha_x, a_z))));
    const stewart_real c4 = STEWART_FMA(I_p_xz, R_xz, STEWART_FMA(I_p_xy, R_xy, I_p_xx*R_xx));
    const stewart_real c5 = STEWART_FMA(I_p_yz, R_xz, STEWART_FMA(I_p_yy, R_xy, I_p_xy*R_xx));
    const stewart_real c6 = STEWART_FMA(I_p_zz, R_xz, STEWART_FMA(I_p_yz, R_xy, I_p_xz*R_xx));
    const stewart_real c7 = STEWART_FMA(I_p_xz, R_yz, STEWART_FMA(I_p_xy, R_yy, I_p_xx*R_yx));
    const stewart_real c8 = STEWART_FMA(I_p_yz, R_yz, STEWART_FMA(I_p_yy, R_yy, I_p_xy*R_yx));
    const stewart_real c9 = STEWART_FMA(I_p_zz, R_yz, STEWART_FMA(I_p_yz, R_yy, I_p_xz*R_yx));
    /* (32) inertia of the platform, base frame */
    const stewart_real I_xx = STEWART_FMA(R_xz, c6, STEWART_FMA(R_xy, c5, R_xx*c4));
    const stewart_real I_xy = STEWART_FMA(R_yz, c6, STEWART_FMA(R_yy, c5, R_yx*c4));
    const stewart_real I_xz = STEWART_FMA(R_zz, c6, STEWART_FMA(R_zy, c5, R_zx*c4));
    const stewart_real I_yy = STEWART_FMA(R_yz, c9, STEWART_FMA(R_yy, c8, R_yx*c7));
    const stewart_real I_yz = STEWART_FMA(R_zz, c9, STEWART_FMA(R_zy, c8, R_zx*c7));
    const stewart_real I_zz = STEWART_FMA(R_zz, STEWART_FMA(I_p_zz, R_zz, STEWART_FMA(I_p_yz, R_zy,
        I_p_xz*R_zx)), STEWART_FMA(R_zy, STEWART_FMA(I_p_yz, R_zz, STEWART_FMA(I_p_yy, R_zy, I_p_xy*R_zx)),
        R_zx*STEWART_FMA(I_p_xz, R_zz, STEWART_FMA(I_p_xy, R_zy, I_p_xx*R_zx))));
    /* (33) M (g - a_G) */
    const stewart_real N_x = M*(g_x - a_G_x);
    const stewart_real N_y = M*(g_y - a_G_y);
    const stewart_real N_z = M*(g_z - a_G_z);
    const stewart_real c10 = STEWART_FMA(I_zz, omega_z, STEWART_FMA(I_yz, omega_y, I_xz*omega_x));
    const stewart_real c11 = STEWART_FMA(I_yz, omega_z, STEWART_FMA(I_yy, omega_y, I_xy*omega_x));
    const stewart_real c12 = STEWART_FMA(I_xz, omega_z, STEWART_FMA(I_xy, omega_y, I_xx*omega_x));
    /* (34) I alpha + omega x I omega */
    const stewart_real E_x = STEWART_FMA(-c11, omega_z, STEWART_FMA(c10, omega_y, STEWART_FMA(I_xz, alpha_z,
        STEWART_FMA(I_xy, alpha_y, I_xx*alpha_x))));
    const stewart_real E_y = STEWART_FMA(-c10, omega_x, STEWART_FMA(c12, omega_z, STEWART_FMA(I_yz, alpha_z,
        STEWART_FMA(I_yy, alpha_y, I_xy*alpha_x))));
    const stewart_real E_z = STEWART_FMA(-c12, omega_y, STEWART_FMA(c11, omega_x, STEWART_FMA(I_zz, alpha_z,
        STEWART_FMA(I_yz, alpha_y, I_xz*alpha_x))));
    /* (33) external force, base frame */
    const stewart_real F_load_x = STEWART_FMA(F_ext_z, R_xz, STEWART_FMA(F_ext_y, R_xy, F_ext_x*R_xx));
    const stewart_real F_load_y = STEWART_FMA(F_ext_z, R_yz, STEWART_FMA(F_ext_y, R_yy, F_ext_x*R_yx));
    const stewart_real F_load_z = STEWART_FMA(F_ext_z, R_zz, STEWART_FMA(F_ext_y, R_zy, F_ext_x*R_zx));
    /* (34) external moment, base frame */
    const stewart_real M_load_x = STEWART_FMA(M_ext_z, R_xz, STEWART_FMA(M_ext_y, R_xy, M_ext_x*R_xx));
    const stewart_real M_load_y = STEWART_FMA(M_ext_z, R_yz, STEWART_FMA(M_ext_y, R_yy, M_ext_x*R_yx));
    const stewart_real M_load_z = STEWART_FMA(M_ext_z, R_zz, STEWART_FMA(M_ext_y, R_zy, M_ext_x*R_zx));
    out->c_force[0] = F_load_x + N_x;
    out->c_force[1] = F_load_y + N_y;
    out->c_force[2] = F_load_z + N_z;
    out->c_moment[0] = STEWART_FMA(-N_y, R_G_z, STEWART_FMA(N_z, R_G_y, M_load_x) - E_x);
    out->c_moment[1] = STEWART_FMA(-N_z, R_G_x, STEWART_FMA(N_x, R_G_z, M_load_y) - E_y);
    out->c_moment[2] = STEWART_FMA(-N_x, R_G_y, STEWART_FMA(N_y, R_G_x, M_load_z) - E_z);
}

/* Solves H x = c for x by elimination with partial pivoting, (36). Returns 1 if a pivot is small. */
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

/* Returns the status of a leg: not finite, short compared with the vectors in its sum, along k, or OK. */
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

/* Returns 1 if all numbers are finite, else 0. */
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

/* Returns one pose of a batch, with zeros for optional arrays that are null. */
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

/* Returns a motion as a batch of one pose. */
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

/* Copies the numbers of a pose to the array of all poses unless it is null. */
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
