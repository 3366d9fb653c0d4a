/* Kernels for many machines, each with one motion, in the arithmetic of STEWART_REAL; tests use them, too.
 *
 * Every function has the same arguments: machines, motions, actuator forces, outputs, and statuses. */
#include <string.h>

#include "stewart_exact.h"
#include "stewart_exact_forces.h"
#include "stewart_exact_motion.h"

#define BATCH 11
#define ARRAYS 8

typedef stewart_real six[6], square[36];

/* Computes motion i in a batch with its neighbors, at a place that differs from motion to motion. */
static int in_batch(
    const stewart_exact_model *model, size_t count, size_t i, const stewart_motion *motions, six out)
{
    static const size_t widths[ARRAYS] = {9, 3, 3, 3, 3, 3, 3, 3};
    const size_t place = i % BATCH;
    stewart_real arrays[BATCH * sizeof(stewart_motion) / sizeof(stewart_real)], F[BATCH][6];
    const stewart_real *parts[ARRAYS];
    stewart_real *to = arrays;
    stewart_motions rows;
    int status[BATCH];
    size_t array, j, start = 0;
    for (array = 0; array < ARRAYS; ++array) {
        parts[array] = to;
        for (j = 0; j < BATCH; ++j) {
            const stewart_motion *motion = motions + (i + count * BATCH + j - place) % count;
            memcpy(to, (const stewart_real *)motion + start, widths[array] * sizeof *to);
            to += widths[array];
        }
        start += widths[array];
    }
    memcpy(&rows, parts, sizeof rows);
    (void)stewart_exact_forces_batch(model, BATCH, &rows, F[0], status);
    if (status[place] == STEWART_OK) {
        memcpy(out, F[place], sizeof F[place]);
    }
    return status[place];
}

#define EACH(name, output, call) \
    void name( \
        size_t count, const stewart_robot *robots, const stewart_motion *motions, const six *forces, \
        output *out, int *status) \
    { \
        size_t i; \
        (void)forces; \
        for (i = 0; i < count; ++i) { \
            stewart_exact_model model; \
            status[i] = stewart_exact_prepare(robots + i, &model); \
            if (status[i] == STEWART_OK) { \
                status[i] = call; \
            } \
        } \
    }

EACH(one_pose, six, stewart_exact_forces(&model, motions + i, out[i]))
EACH(batch, six, in_batch(&model, count, i, motions, out[i]))
EACH(every_output, stewart_forces, stewart_exact_inverse_dynamics(robots + i, motions + i, out + i))
EACH(equations, stewart_equations, stewart_exact_equations(&model, motions + i, out + i))
EACH(bias_and_friction, six, stewart_exact_bias_and_friction(&model, motions + i, out[i]))
EACH(forward_dynamics, six, stewart_exact_forward_dynamics(&model, motions + i, forces[i], out[i]))
EACH(joint_inertia, square, stewart_exact_joint_inertia(&model, motions + i, out[i]))
EACH(derivatives, stewart_derivatives, stewart_exact_derivatives(&model, motions + i, out + i))
EACH(linearization, stewart_linearization, stewart_exact_linearization(&model, motions + i, forces[i], out + i))
