/* The kernel of the forces alone in the kernels' own type: one pose, and a batch around it. */
#include "arithmetic.h"

#include "stewart_exact_forces_text.h"
#include "sweep.h"

#define BATCH 11

void OWN(forces)(
    const double *numbers, const double *motion, const double *calm, int place, double F[2][6], int status[2])
{
    static const int widths[8] = MOTION_MEMBERS;
    stewart_robot robot;
    stewart_exact_model model;
    stewart_motion at;
    stewart_real arrays[MOTION_NUMBERS * BATCH], one[6], many[6 * BATCH];
    const stewart_real *parts[8];
    stewart_motions motions;
    int codes[BATCH], i, j, group, start = 0;
    converted((stewart_real *)&robot, numbers, ROBOT_NUMBERS);
    converted((stewart_real *)&at, motion, MOTION_NUMBERS);
    status[0] = status[1] = stewart_exact_prepare(&robot, &model);
    if (status[0] != STEWART_OK) {
        return;
    }
    for (group = 0; group < 8; ++group) {
        parts[group] = arrays + start * BATCH;
        for (j = 0; j < BATCH; ++j) {
            stewart_real *to = arrays + start * BATCH + j * widths[group];
            converted(to, (j == place ? motion : calm) + start, widths[group]);
        }
        start += widths[group];
    }
    memcpy(&motions, parts, sizeof motions);
    status[0] = stewart_exact_forces(&model, &at, one);
    stewart_exact_forces_batch(&model, BATCH, &motions, many, codes);
    status[1] = codes[place];
    for (i = 0; i < 6; ++i) {
        F[0][i] = (double)one[i];
        F[1][i] = (double)many[6 * place + i];
    }
}
