/* firmware.c: one control cycle with the kit of the microcontroller, called here a thousand times. */
#include <stdio.h>

#include "stewart_kit.h"

static stewart_kit_model model;

/* Once, before the loop. */
static int start(void)
{
    return stewart_kit_prepare(&model);
}

/* Every cycle: forces from the reference motion plus feedback of position and velocity. */
static int cycle(const stewart_motion *reference, const stewart_real t[3], const stewart_real v[3],
                 stewart_real F[6])
{
    const stewart_real k_p = 900, k_d = 60;              /* 1/s^2, 1/s */
    stewart_motion motion = *reference;
    int i;

    for (i = 0; i < 3; ++i) {
        motion.t[i] = t[i];
        motion.v[i] = v[i];
        motion.a[i] += k_d * (reference->v[i] - v[i]) + k_p * (reference->t[i] - t[i]);
    }
    return stewart_kit_forces(&model, &motion, F);
}

int main(void)
{
    const stewart_motion reference = {.R = {1, 0, 0, 0, 1, 0, 0, 0, 1}, .t = {0, 0, (stewart_real)0.65}};
    const stewart_real t[3] = {0, 0, (stewart_real)0.649}, v[3] = {0, 0, 0};
    stewart_real F[6] = {0};
    int i, status = start();

    for (i = 0; i < 1000 && status == STEWART_OK; ++i) {
        status = cycle(&reference, t, v, F);
    }
    printf("status %d, leg 1: %.1f N\n", status, (double)F[0]);
    return status;
}
