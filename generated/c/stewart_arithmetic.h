/* stewart_arithmetic.h: arithmetic and thresholds of the kernels, included by their sources.
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

/* STEWART_FMA(a, b, c) = a b + c. It is rounded once if the processor has an instruction for it; then one
 * pose, every place of a batch, and every compiler give the same bits. -DSTEWART_NO_FMA: rounded twice, as
 * in NumPy. */
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

/* STEWART_FMA for a known product a b, which is not computed again. gcc 12 fuses some products in sums even
 * with -ffp-contract=off, and not in every function. */
#if !defined(STEWART_FMA_OF)
#define STEWART_FMA_OF(product, a, b, c) STEWART_FMA(a, b, c)
#endif

/* A length or sine below this multiple of its terms is a rounding error. */
#define STEWART_ROUNDING (REAL(16) * STEWART_EPSILON)

/* Sine of the angle between a leg and the fixed axis of its universal joint below which the third axis of
 * the leg is used. Below it, projections on the fixed axis lose more than five bits. */
#define STEWART_NEAR_JOINT_SINGULAR ((stewart_real)0.03125)

/* Shortest length of a leg whose square the arithmetic represents with all digits. */
#if !defined(STEWART_SHORTEST)
#define STEWART_SHORTEST STEWART_SQRT(REAL(1) / STEWART_MAX / STEWART_EPSILON)
#endif

#define REAL(value) ((stewart_real)(value))
#define STEWART_HALF ((stewart_real)0.5)
#define STEWART_LARGER(one, other) ((one) > (other) ? (one) : (other))

/* Singularity of the universal joint: sine of the angle between a leg and the fixed axis below which
 * rounding errors determine the second axis of the leg. */
#define STEWART_JOINT_SINGULAR_SINE (REAL(4096) * STEWART_EPSILON)

/* Smallest length of a leg relative to the vectors of which it is the sum. A shorter leg is so inaccurate
 * that H may be singular to rounding although the pivots are large. */
#if !defined(STEWART_SHORT_SHARE)
#if defined(STEWART_FLOAT)
#define STEWART_SHORT_SHARE REAL(0.0625)
#else
#define STEWART_SHORT_SHARE (REAL(64) * STEWART_SQRT(STEWART_EPSILON))
#endif
#endif

/* Pivot below which H may be singular to rounding, 2^-13 or 2^-7. The product of all pivots of a singular H
 * is a few epsilon. If n pivots are small, the smallest is at most of the order of the n-th root of epsilon.
 * For singular robots that are also nearly singular in other ways, the largest value found was 5e-7, in
 * float 2.5e-3. */
#if !defined(STEWART_SUSPECT)
#if defined(STEWART_FLOAT)
#define STEWART_SUSPECT REAL(0.0078125)
#else
#define STEWART_SUSPECT REAL(0.0001220703125)
#endif
#endif

/* Limits of the solution in two blocks of three legs; beyond them pivots are used. STEWART_BLOCK_GROWTH: sum
 * of the squares of the forces in legs 2, 4, and 6 caused by unit forces along the others.
 * STEWART_BLOCK_LEAST: determinant of the Schur complement (the moments of legs 1, 3, and 5) relative to the
 * cube of the largest arm. STEWART_BLOCK_SINGULAR: this determinant times the determinant of the directions.
 * Within these limits neither the median nor the maximum of the errors exceeds twice the error with pivots. */
#if !defined(STEWART_BLOCK_GROWTH)
#define STEWART_BLOCK_GROWTH REAL(16)
#define STEWART_BLOCK_LEAST REAL(0.00048828125)
#if defined(STEWART_FLOAT)
#define STEWART_BLOCK_SINGULAR REAL(0.000244140625)
#else
#define STEWART_BLOCK_SINGULAR REAL(0.00000762939453125)
#endif
#endif

/* Number of lanes for the legs of a pose, or for poses. */
#define LANES 8
#if !defined(POSES)
#define POSES LANES
#endif

#if defined(__cplusplus)
#define STEWART_RESTRICT __restrict
#else
#define STEWART_RESTRICT restrict
#endif

/* Alignment of vectors: a load across two cache lines takes twice as long. */
#if defined(__GNUC__) && defined(__AVX__)
#define STEWART_ALIGNED __attribute__((aligned(64)))
#else
#define STEWART_ALIGNED
#endif

/* STEWART_ASK: prefetch a cache line, which contains a number of each pose of a block. Loading it from
 * memory takes as long as the forces of a block. */
#if defined(__GNUC__)
#define STEWART_ASK(address) __builtin_prefetch(address)
#else
#define STEWART_ASK(address) ((void)(address))
#endif

/* GCC unrolls short loops before it vectorizes, and then vectorizes few of them. */
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 8
#define STEWART_LOOP _Pragma("GCC unroll 1")
#else
#define STEWART_LOOP
#endif

/* STEWART_APART: never inlined. Compilers vectorize a long loop more readily in a separate function, and a
 * rarely called function then costs its callers no registers. STEWART_SHARED: function of a header that not
 * every source calls. */
#if defined(__GNUC__)
#define STEWART_APART __attribute__((noinline))
#define STEWART_SHARED static __attribute__((unused))
#else
#define STEWART_APART
#define STEWART_SHARED static
#endif

#endif
