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
    for (i = 0; i < ROBOT_NUMBERS; ++i) {
        ((stewart_real *)&robot)[i] = (stewart_real)numbers[i];
    }
    for (i = 0; i < MOTION_NUMBERS; ++i) {
        ((stewart_real *)&at)[i] = (stewart_real)motion[i];
    }
    status[0] = status[1] = stewart_exact_prepare(&robot, &model);
    if (status[0] != STEWART_OK) {
        return;
    }
    for (group = 0; group < 8; ++group) {
        parts[group] = arrays + start * BATCH;
        for (j = 0; j < BATCH; ++j) {
            const double *from = j == place ? motion : calm;
            for (i = 0; i < widths[group]; ++i) {
                arrays[start * BATCH + j * widths[group] + i] = (stewart_real)from[start + i];
            }
        }
        start += widths[group];
    }
    motions.R = parts[0];
    motions.t = parts[1];
    motions.omega = parts[2];
    motions.v = parts[3];
    motions.alpha = parts[4];
    motions.a = parts[5];
    motions.F_ext = parts[6];
    motions.M_ext = parts[7];
    status[0] = stewart_exact_forces(&model, &at, one);
    stewart_exact_forces_batch(&model, BATCH, &motions, many, codes);
    status[1] = codes[place];
    for (i = 0; i < 6; ++i) {
        F[0][i] = (double)one[i];
        F[1][i] = (double)many[6 * place + i];
    }
}
