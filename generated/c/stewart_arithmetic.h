/* stewart_arithmetic.h: arithmetic and thresholds of the sources of kernels, which include it.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#ifndef STEWART_ARITHMETIC_H
#define STEWART_ARITHMETIC_H

#include "stewart.h"

#if !defined(STEWART_REAL)
#include <float.h>
#include <math.h>
#if defined(STEWART_FLOAT)
#define STEWART_SQRT(value) sqrtf(value)
#define STEWART_FABS(value) fabsf(value)
#define STEWART_EPSILON FLT_EPSILON
#define STEWART_MAX FLT_MAX
#else
#define STEWART_SQRT(value) sqrt(value)
#define STEWART_FABS(value) fabs(value)
#define STEWART_EPSILON DBL_EPSILON
#define STEWART_MAX DBL_MAX
#endif
#endif

/* a b + c, rounded once where the processor has that in one instruction: one pose, every place of a batch and
 * every compiler then give the same bits. -DSTEWART_NO_FMA: rounded twice, as NumPy does it. */
#if !defined(STEWART_FMA)
#if !defined(STEWART_REAL) && !defined(STEWART_NO_FMA) \
    && (defined(__FP_FAST_FMA) || defined(__FMA__) || defined(__ARM_FEATURE_FMA))
#if defined(STEWART_FLOAT)
#define STEWART_FMA(a, b, c) fmaf(a, b, c)
#else
#define STEWART_FMA(a, b, c) fma(a, b, c)
#endif
#else
#define STEWART_FMA(a, b, c) ((a) * (b) + (c))
#define STEWART_FMA_OF(product, a, b, c) ((product) + (c))
#endif
#endif

/* The same of a known product a b, which is not computed again. gcc 12 fuses some of those that stand in sums by
 * themselves, even with -ffp-contract=off, and not in every function. */
#if !defined(STEWART_FMA_OF)
#define STEWART_FMA_OF(product, a, b, c) STEWART_FMA(a, b, c)
#endif

/* A length or sine below this many rounding units of its terms is rounding error and nothing else. */
#define STEWART_ROUNDING (REAL(16) * STEWART_EPSILON)

/* Below this sine of the angle between a leg and the fixed axis of its universal joint, what is measured
 * along that axis has lost five bits; the leg's third axis is taken instead. */
#define STEWART_NEAR_JOINT_SINGULAR ((stewart_real)0.03125)

/* A leg shorter than this has a square that the arithmetic does not hold to all its digits. */
#if !defined(STEWART_SHORTEST)
#define STEWART_SHORTEST STEWART_SQRT(REAL(1) / STEWART_MAX / STEWART_EPSILON)
#endif

#define REAL(value) ((stewart_real)(value))
#define STEWART_HALF ((stewart_real)0.5)
#define STEWART_LARGER(one, other) ((one) > (other) ? (one) : (other))

/* Sine of the angle between a leg and the fixed axis below which rounding decides where the leg's second axis
 * points: the singularity of the universal joint. */
#define STEWART_JOINT_SINGULAR_SINE (REAL(4096) * STEWART_EPSILON)

/* Below this share of the vectors that it is the sum of, a leg has lost so many digits that its column of H
 * may be singular to rounding with others while the pivots are large. */
#if !defined(STEWART_SHORT_SHARE)
#if defined(STEWART_FLOAT)
#define STEWART_SHORT_SHARE REAL(0.0625)
#else
#define STEWART_SHORT_SHARE (REAL(64) * STEWART_SQRT(STEWART_EPSILON))
#endif
#endif

/* Pivot below which H may be singular to rounding, 2^-13 or 2^-7. The product of all pivots of a singular H
 * is a few epsilon: where n of them are small, the least is of the order of the n-th root of epsilon at most.
 * Of singular machines that are nearly singular in other ways as well, it was seen to reach 5e-7, in float
 * 2.5e-3. */
#if !defined(STEWART_SUSPECT)
#if defined(STEWART_FLOAT)
#define STEWART_SUSPECT REAL(0.0078125)
#else
#define STEWART_SUSPECT REAL(0.0001220703125)
#endif
#endif

/* Where two blocks of three legs are not solved one after the other, but by pivots: where the squares of what
 * legs 2, 4 and 6 take from unit forces along the others add up to more than this, or the Schur complement, the
 * moments of legs 1, 3 and 5, has a determinant below the second share of the cube of the largest arm, or that
 * times the determinant of the directions is below the third. Between them neither the median nor the
 * largest of the errors is above twice that of pivots. */
#if !defined(STEWART_BLOCK_GROWTH)
#define STEWART_BLOCK_GROWTH REAL(16)
#define STEWART_BLOCK_LEAST REAL(0.00048828125)
#if defined(STEWART_FLOAT)
#define STEWART_BLOCK_SINGULAR REAL(0.000244140625)
#else
#define STEWART_BLOCK_SINGULAR REAL(0.00000762939453125)
#endif
#endif

/* Legs of a pose, or poses, side by side. */
#define LANES 8
#if !defined(POSES)
#define POSES LANES
#endif

#if defined(__cplusplus)
#define STEWART_RESTRICT __restrict
#else
#define STEWART_RESTRICT restrict
#endif

/* Vectors load from what begins where they do: one across two lines of the cache takes twice as long. */
#if defined(__GNUC__) && defined(__AVX__)
#define STEWART_ALIGNED __attribute__((aligned(64)))
#else
#define STEWART_ALIGNED
#endif

/* STEWART_ASK: has a line of the cache, which holds a number of each pose of a block, brought from memory, which
 * takes as long as the forces of a block. */
#if defined(__GNUC__)
#define STEWART_ASK(address) __builtin_prefetch(address)
#else
#define STEWART_ASK(address) ((void)(address))
#endif

/* GCC writes short loops out before it looks for vectors, and then finds few. */
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 8
#define STEWART_LOOP _Pragma("GCC unroll 1")
#else
#define STEWART_LOOP
#endif

/* STEWART_APART: never merged into its callers. Compilers make vector instructions of a long loop more readily
 * when it stands in a function of its own, and what is seldom called costs its callers no registers.
 * STEWART_SHARED: of a header, which not every source calls. */
#if defined(__GNUC__)
#define STEWART_APART __attribute__((noinline))
#define STEWART_SHARED static __attribute__((unused))
#else
#define STEWART_APART
#define STEWART_SHARED static
#endif

#endif
