/* The closed form's kernels in one type: their outputs one after the other, a status for each kernel, and how
 * far each output moves with its inputs. */
#include "arithmetic.h"

#include "stewart_exact_motion_text.h"
#include "sweep.h"

/* Numbers with each changed by `amount` of itself, up or down; or, where `only` is not null, the one alone to
 * which it counts down. */
static void changed(
    stewart_real *to, const double *from, int count, double amount, uint64_t *seed, int *only)
{
    double by;
    int i;
    for (i = 0; i < count; ++i) {
        to[i] = (stewart_real)from[i];
        by = only ? amount * ((*only)-- == 0) : between(seed) < 0 ? -amount : amount;
        to[i] += to[i] * (stewart_real)by;
    }
}

static void solved(
    const double *numbers, const double *motion, const double *forces, double amount, uint64_t *seed,
    int wanted, int *only, outputs *out, int *status)
{
    stewart_robot robot;
    stewart_motion at;
    stewart_exact_model model;
    stewart_real F[6];
    int prepared, k;
    changed((stewart_real *)&robot, numbers, ROBOT_NUMBERS, amount, seed, only);
    changed((stewart_real *)&at, motion, MOTION_NUMBERS, amount, seed, only);
    changed(F, forces, 6, amount, seed, only);
    prepared = stewart_exact_prepare(&robot, &model);
    for (k = 0; k < CLOSED_KERNELS; ++k) {
        status[k] = prepared;
        if (prepared != STEWART_OK || !(wanted >> k & 1)) {
            continue;
        }
        status[k] = k == 0 ? stewart_exact_equations(&model, &at, &out->equations)
            : k == 1       ? stewart_exact_bias_and_friction(&model, &at, out->bias)
            : k == 2       ? stewart_exact_forward_dynamics(&model, &at, F, out->acceleration)
            : k == 3       ? stewart_exact_joint_inertia(&model, &at, out->inertia)
            : k == 4       ? stewart_exact_derivatives(&model, &at, &out->derivatives)
                           : stewart_exact_linearization(&model, &at, F, &out->linearization);
    }
}

/* high + low: the outputs; change: the largest of any sample over `amount`, infinite with a status;
 * with a negative number of samples the sum of what every input does by itself. */
void OWN(closed_form)(
    const double *numbers, const double *motion, const double *forces, int wanted, double amount, int samples,
    uint64_t seed, double *high, double *low, double *change, int *status)
{
    static const int of_kernel[CLOSED_KERNELS] = {
        NUMBERS(stewart_equations), 6, 6, 36, NUMBERS(stewart_derivatives), NUMBERS(stewart_linearization)
    };
    union {
        outputs of;
        stewart_real numbers[CLOSED_NUMBERS];
    } truth, moved;
    const stewart_real *const at = truth.numbers, *const beside = moved.numbers;
    int moved_status[CLOSED_KERNELS], sample, i, k;
    memset(&truth, 0, sizeof truth);
    memset(&moved, 0, sizeof moved);
    solved(numbers, motion, forces, 0, &seed, wanted, 0, &truth.of, status);
    for (i = 0; i < CLOSED_NUMBERS; ++i) {
        high[i] = (double)at[i];
        low[i] = (double)(at[i] - (stewart_real)high[i]);
        change[i] = 0;
    }
    for (sample = 0; sample < (samples < 0 ? ROBOT_NUMBERS + MOTION_NUMBERS + 6 : samples); ++sample) {
        int only = sample;
        solved(
            numbers, motion, forces, amount, &seed, wanted, samples < 0 ? &only : 0, &moved.of, moved_status);
        for (k = i = 0; k < CLOSED_KERNELS; ++k) {
            const int end = i + of_kernel[k];
            for (; i < end && wanted >> k & 1 && !status[k]; ++i) {
                const double moved_by = moved_status[k]
                    ? INFINITY
                    : fabs((double)((beside[i] - at[i]) / (stewart_real)amount));
                change[i] = samples < 0 ? change[i] + moved_by : fmax(change[i], moved_by);
            }
            i = end;
        }
    }
}
