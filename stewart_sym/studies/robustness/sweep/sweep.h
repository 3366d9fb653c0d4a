/* What the sources of the sweep share. */
#ifndef SWEEP_H
#define SWEEP_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "stewart_exact_motion.h"

#define NUMBERS(type) ((int)(sizeof(type) / sizeof(stewart_real)))
#define ROBOT_NUMBERS NUMBERS(stewart_robot)
#define MOTION_NUMBERS NUMBERS(stewart_motion)
#define KERNELS 3
#define CLOSED_KERNELS 6

/* Outputs of the closed form's kernels, one after the other. */
typedef struct {
    stewart_equations equations;
    stewart_real bias[6], acceleration[6], inertia[36];
    stewart_derivatives derivatives;
    stewart_linearization linearization;
} outputs;
#define CLOSED_NUMBERS NUMBERS(outputs)

/* Sizes of a motion's members. */
#define MOTION_MEMBERS {9, 3, 3, 3, 3, 3, 3, 3}

/* What a wider type finds: F as high + low, the largest of |F|, |D| and |x|, the problem's own condition
 * number, the scaled one of H, that of the legs' frames, the status. */
typedef struct {
    double high[6], low[6], size, own, scaled, frames;
    int status;
} verdict;

/* What a compilation for a wider type defines, and one for a kernel's own. */
#define WIDER(name) \
    void name##_solve( \
        const double *numbers, const double *motion, double length, double amount, int samples, \
        uint64_t seed, verdict *out); \
    CLOSED_FORM(name)
#define OF_KERNELS(name) \
    int name##_every(const double *numbers, const double *motion, double F[6]); \
    void name##_forces( \
        const double *numbers, const double *motion, const double *calm, int place, double F[2][6], \
        int status[2]); \
    CLOSED_FORM(name)
#define CLOSED_FORM(name) \
    void name##_closed_form( \
        const double *numbers, const double *motion, const double *forces, int wanted, double amount, \
        int samples, uint64_t seed, double *high, double *low, double *change, int *status);

/* Numbers in the kernels' own type. */
static inline void converted(stewart_real *to, const double *from, int count)
{
    int i;
    for (i = 0; i < count; ++i) {
        to[i] = (stewart_real)from[i];
    }
}

static inline uint64_t next(uint64_t *seed)
{
    uint64_t z = (*seed += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/* Between -1 and 1. */
static inline double between(uint64_t *seed)
{
    return (double)(next(seed) >> 11) / 4503599627370496.0 - 1;
}

#endif
