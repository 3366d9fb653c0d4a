/* lengths.c: one control cycle from measured leg lengths and rates, with feedback of position and orientation. */
#include <stdio.h>

#include "stewart_kinematics.h"
#include "stewart_kit.h"

static const stewart_robot *const robot = &stewart_robot_hexapod;
static stewart_kit_model model;
static stewart_pose pose = {.R = {1, 0, 0, 0, 1, 0, 0, 0, 1}, .t = {0, 0, (stewart_real)0.65}};   /* first guess */

static int cycle(const stewart_motion *reference, const stewart_real L[6], const stewart_real L_dot[6],
                 stewart_real F[6])
{
    const stewart_real k_p = 900, k_d = 60;              /* 1/s^2, 1/s */
    const stewart_real *R = pose.R, *R_w = reference->R;
    stewart_motion motion = *reference;
    int i, j, status = stewart_forward_kinematics(robot, L, &pose);   /* the pose is the next guess */

    if (status == STEWART_OK) {
        status = stewart_forward_velocity(robot, &pose, L_dot, motion.v, motion.omega);
    }
    if (status != STEWART_OK) {
        return status;                                   /* F keeps its old values */
    }
    for (i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3, m = (i + 2) % 3;
        stewart_real e = 0;                              /* rotation from R to R_w, if it is small (rad) */

        for (j = 0; j < 3; ++j) {
            e += (R[3 * k + j] * R_w[3 * m + j] - R[3 * m + j] * R_w[3 * k + j]) / 2;
            motion.R[3 * i + j] = R[3 * i + j];
        }
        motion.t[i] = pose.t[i];
        motion.a[i] += k_d * (reference->v[i] - motion.v[i]) + k_p * (reference->t[i] - pose.t[i]);
        motion.alpha[i] += k_d * (reference->omega[i] - motion.omega[i]) + k_p * e;
    }
    return stewart_kit_forces(&model, &motion, F);
}

int main(void)
{
    const stewart_motion reference = {.R = {1, 0, 0, 0, 1, 0, 0, 0, 1}, .t = {0, 0, (stewart_real)0.65}};
    const stewart_real L[6] = {0.73663f, 0.73247f, 0.72842f, 0.72338f, 0.73306f, 0.72789f};
    const stewart_real L_dot[6] = {-0.0028f, 0.0074f, 0.0039f, 0.0033f, -0.0009f, -0.0107f};
    stewart_real F[6] = {0};
    int status = stewart_kit_prepare(&model);

    if (status == STEWART_OK) {
        status = cycle(&reference, L, L_dot, F);
    }
    printf("status %d, leg 1: %.1f N\n", status, (double)F[0]);
    return status;
}
