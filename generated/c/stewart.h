/* stewart.h: arithmetic, status codes, and data types of the stewart-sym kernels.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * Units: lengths in m, masses in kg, inertias in kg m^2, angles in rad, times in s. The comment of a member begins with
 * its unit; 1 marks numbers without unit. Vectors are in the base frame unless noted otherwise. Equation numbers refer
 * to Dasgupta and Mruthyunjaya, Mechanism and Machine Theory 33 (1998) 1135-1152.
 */
#ifndef STEWART_H
#define STEWART_H

#include <stddef.h>

#define STEWART_SYM_VERSION "0.1.0.dev0" /* version of the generator */

/* Compilers that assume finite numbers remove the checks of inputs and results, and wrong inputs then give
 * STEWART_OK. With -DSTEWART_ALLOW_FAST_MATH the caller must check all inputs and results. */
#if (defined(__FAST_MATH__) || defined(_M_FP_FAST) || \
     (defined(__FINITE_MATH_ONLY__) && (__FINITE_MATH_ONLY__ != 0))) && !defined(STEWART_ALLOW_FAST_MATH)
#error "compile without -ffast-math and -ffinite-math-only, or define STEWART_ALLOW_FAST_MATH (see stewart.h)"
#endif

/* Prefix of functions that return a status: compilers warn if it is ignored. */
#if !defined(STEWART_NODISCARD)
#if (defined(__cplusplus) && (__cplusplus >= 201703L)) || \
    (defined(__STDC_VERSION__) && (__STDC_VERSION__ >= 202311L))
#define STEWART_NODISCARD [[nodiscard]]
#elif defined(__GNUC__)
#define STEWART_NODISCARD __attribute__((warn_unused_result))
#else
#define STEWART_NODISCARD
#endif
#endif

/* Arithmetic: double, or float with -DSTEWART_FLOAT. For another type define STEWART_REAL, STEWART_SQRT(x),
 * STEWART_FABS(x), STEWART_EPSILON, and STEWART_MAX. */
#if defined(STEWART_REAL)
typedef STEWART_REAL stewart_real;
#elif defined(STEWART_FLOAT)
typedef float stewart_real;
#else
typedef double stewart_real;
#endif

/* Status codes. If the status of a pose is not STEWART_OK, its outputs are unchanged.
 * A batch returns the first code other than STEWART_OK, or STEWART_OK.
 *
 * Functions of one pose write their outputs last. An output may overlap the motion and other inputs, but not the robot,
 * the model, or another output. In a batch no output may overlap an input or another output. */
#define STEWART_OK 0 /* solved */
#define STEWART_NOT_FINITE 1 /* an input is not finite, or a result overflows */
#define STEWART_ZERO_LENGTH 2 /* a leg has length zero */
#define STEWART_JOINT_SINGULAR 3 /* a leg lies along the fixed axis of its universal joint */
#define STEWART_SINGULAR 4 /* H is singular: no leg forces can hold the platform */
#define STEWART_BAD_ARGUMENT 5 /* an argument is invalid: a pointer is null, stride < count, or an index is out of range */
#define STEWART_MASS_MATRIX_INDEFINITE 6 /* the mass matrix M is not positive definite: no body has such inertias */
#define STEWART_NOT_CONVERGED 7 /* no pose with these leg lengths was found, or R of the guess is not a rotation */

/* Thresholds of the statuses, and the largest error of results with STEWART_OK for
 * 10^6 random poses near a failure (`stewart-sym stability`), in rounding units
 * times the condition number of the problem, with the relative distance of the pose from the failure.
 * STEWART_ZERO_LENGTH: leg shorter than 16 rounding units of the vectors in its sum; error 5 at the distance 7.9e-02
 * STEWART_JOINT_SINGULAR: sine between leg and fixed axis below 4096 rounding units; error 15 at the distance 4.9e-02
 * STEWART_SINGULAR: spectral radius of |inverse of H| times the error bounds of H above 1/2; error 10 at the distance 7.1e-09 */

/* One leg. The origin of frame D is the base point, and the origin of frame U the platform point. In both
 * frames x is along the leg and y along the moving axis of the universal joint. */
typedef struct {
    stewart_real b[3]; /* m: base point, base frame */
    stewart_real p[3]; /* m: platform point, platform frame */
    stewart_real k[3]; /* 1: unit vector along the fixed axis of the universal joint, base frame */
    stewart_real m_d; /* kg: mass of the lower part */
    stewart_real r_d0[3]; /* m: center of mass of the lower part, frame D */
    stewart_real I_d0[6]; /* kg m^2: inertia of the lower part about its center of mass, frame D, order xx xy xz yy yz zz */
    stewart_real m_u; /* kg: mass of the upper part */
    stewart_real r_u0[3]; /* m: center of mass of the upper part, frame U */
    stewart_real I_u0[6]; /* kg m^2: inertia of the upper part about its center of mass, frame U, order xx xy xz yy yz zz */
    stewart_real C_u; /* N m s: viscous friction of the universal joint */
    stewart_real C_p; /* N s/m: viscous friction of the prismatic joint */
    stewart_real C_s; /* N m s: viscous friction of the spherical joint */
#if defined(STEWART_ROTORS) /* define it in every source if a kernel has `drive` in its name */
    stewart_real m_r; /* kg: reflected mass J_r N^2 of the rotor with inertia J_r (kg m^2) and transmission N (rad/m) */
    stewart_real j_r; /* kg m: angular momentum J_r N of the rotor per length rate */
#endif
} stewart_leg;

/* Robot: legs, platform, and gravity. */
typedef struct {
    stewart_leg leg[6];
    stewart_real M; /* kg: mass of the platform with its payload */
    stewart_real R_0[3]; /* m: center of mass of the platform, platform frame */
    stewart_real I_p[6]; /* kg m^2: inertia of the platform about its center of mass, platform frame, order xx xy xz yy yz zz */
    stewart_real g[3]; /* m/s^2: acceleration due to gravity, base frame */
} stewart_robot;

/* Limits of the robot file. The functions do not check them. A missing lower limit is 0, a missing upper limit
 * the largest number. */
typedef struct {
    stewart_real shortest[6]; /* m: smallest leg length */
    stewart_real longest[6]; /* m: largest leg length */
    stewart_real force[6]; /* N: largest magnitude of the actuator force */
    stewart_real speed[6]; /* m/s: largest magnitude of the sliding velocity */
} stewart_limits;

/* Motion of the platform, and its load. */
typedef struct {
    stewart_real R[9]; /* 1: orientation of the platform, platform frame to base frame, row-major */
    stewart_real t[3]; /* m: position of the platform's reference point, base frame */
    stewart_real omega[3]; /* rad/s: angular velocity of the platform, base frame */
    stewart_real v[3]; /* m/s: velocity of the reference point, base frame */
    stewart_real alpha[3]; /* rad/s^2: angular acceleration of the platform, base frame */
    stewart_real a[3]; /* m/s^2: acceleration of the reference point, base frame */
    stewart_real F_ext[3]; /* N: external force at the reference point, platform frame */
    stewart_real M_ext[3]; /* N m: external moment about the reference point, platform frame */
} stewart_motion;

/* Motions of `count` poses. F_ext and M_ext may be null for zero load. */
typedef struct {
    const stewart_real *R; /* [count][9] */
    const stewart_real *t; /* [count][3] */
    const stewart_real *omega; /* [count][3] */
    const stewart_real *v; /* [count][3] */
    const stewart_real *alpha; /* [count][3] */
    const stewart_real *a; /* [count][3] */
    const stewart_real *F_ext; /* [count][3] */
    const stewart_real *M_ext; /* [count][3] */
} stewart_motions;

/* Inverse dynamics of one pose. */
typedef struct {
    stewart_real F[6]; /* N: actuator forces, positive when they extend the leg, (37) */
    stewart_real D[6]; /* N: known part of the actuator forces, (24) */
    stewart_real x[6]; /* N: axial forces on the legs at their spherical joints, (22) */
    stewart_real K[6][3]; /* N: transverse forces on the legs at their spherical joints, base frame, (21) */
    stewart_real H[6][6]; /* 1 and m: columns [s; q x s], row-major, H x = c, (36); wrenches on the platform: H F and -H x */
    stewart_real c[6]; /* N and N m: wrench that x must balance, base frame, about the reference point, (36) */
} stewart_forces;

/* Inverse dynamics of `count` poses. A pointer may be null if its output is not needed. */
typedef struct {
    stewart_real *F; /* [count][6] */
    stewart_real *D; /* [count][6] */
    stewart_real *x; /* [count][6] */
    stewart_real *K; /* [count][6][3] */
    stewart_real *H; /* [count][6][6] */
    stewart_real *c; /* [count][6] */
} stewart_forces_arrays;

/* Joint reactions of one pose. */
typedef struct {
    stewart_real F_s[6][3]; /* N: force on the leg at the spherical joint, base frame */
    stewart_real F_u[6][3]; /* N: force on the leg at the universal joint, base frame */
    stewart_real F_p[6][3]; /* N: force of the lower part on the upper at the prismatic joint, without the viscous friction -C_p L_dot s, base frame */
    stewart_real F_c[6][3]; /* N: constraint part of F_p, base frame */
    stewart_real M_p[6][3]; /* N m: moment of the lower part, on which the gyroscopic moment of a rotor acts, on the upper at the prismatic joint, base frame */
    stewart_real M_u[6]; /* N m: constraint moment on the leg at the universal joint, along k x y, y the moving axis; in `paper` along s */
} stewart_reactions;

/* Joint reactions of `count` poses. A pointer may be null if its output is not needed. */
typedef struct {
    stewart_real *F_s; /* [count][6][3] */
    stewart_real *F_u; /* [count][6][3] */
    stewart_real *F_p; /* [count][6][3] */
    stewart_real *F_c; /* [count][6][3] */
    stewart_real *M_p; /* [count][6][3] */
    stewart_real *M_u; /* [count][6] */
} stewart_reactions_arrays;

#endif
