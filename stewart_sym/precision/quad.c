/* Plain elimination kernel in quadruple precision for robots and motions in double precision. */
/* kernel.h includes the header of a kernel and defines INVERSE_DYNAMICS. */
#include "kernel.h"

/* Sizes of the members of a motion, in order. */
static const size_t widths[8] = {9, 3, 3, 3, 3, 3, 3, 3};

static void widen(__float128 *to, const double *from, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i) {
        to[i] = from ? from[i] : 0;
    }
}

static void normalize(__float128 k[3])
{
    const __float128 size = sqrtq(k[0] * k[0] + k[1] * k[1] + k[2] * k[2]);
    int i;
    for (i = 0; i < 3 && size > 0; ++i) {
        k[i] = k[i] / size;
    }
}

/* Newton-Schulz: R (3 - R^T R) / 2 squares the distance to the nearest rotation. */
static void nearest_rotation(__float128 R[9])
{
    int step, i, j, k, m;
    for (step = 0; step < 5; ++step) {
        __float128 next[9];
        for (i = 0; i < 3; ++i) {
            for (j = 0; j < 3; ++j) {
                next[3 * i + j] = 3 * R[3 * i + j] / 2;
                for (k = 0; k < 3; ++k) {
                    for (m = 0; m < 3; ++m) {
                        next[3 * i + j] -= R[3 * i + k] * R[3 * m + k] * R[3 * m + j] / 2;
                    }
                }
            }
        }
        for (i = 0; i < 9; ++i) {
            R[i] = next[i];
        }
    }
}

/* motions: pointers to the numbers of each member; the pointers of the load may be NULL. */
void quad_forces(
    const double *numbers, size_t count, const double *const motions[8], int ideal, double *high, double *low)
{
    stewart_robot robot;
    stewart_forces forces;
    size_t pose;
    int i;
    widen((__float128 *)&robot, numbers, sizeof robot / sizeof robot.M);
    for (i = 0; i < 6 && ideal; ++i) {
        normalize(robot.leg[i].k);
    }
    for (pose = 0; pose < count; ++pose) {
        stewart_motion at;
        __float128 *to = (__float128 *)&at;
        for (i = 0; i < 8; ++i) {
            widen(to, motions[i] ? motions[i] + widths[i] * pose : 0, widths[i]);
            to += widths[i];
        }
        if (ideal) {
            nearest_rotation(at.R);
        }
        if (INVERSE_DYNAMICS(&robot, &at, &forces) != STEWART_OK) {
            continue;
        }
        for (i = 0; i < 6; ++i) {
            high[6 * pose + (size_t)i] = (double)forces.F[i];
            low[6 * pose + (size_t)i] = (double)(forces.F[i] - high[6 * pose + (size_t)i]);
        }
    }
}
