/* The kernel of every output in the kernels' own type. */
#include "arithmetic.h"

#include "stewart_exact_text.h"
#include "sweep.h"

int OWN(every)(const double *numbers, const double *motion, double F[6])
{
    stewart_robot robot;
    stewart_motion at;
    stewart_forces found;
    int i, status;
    converted((stewart_real *)&robot, numbers, ROBOT_NUMBERS);
    converted((stewart_real *)&at, motion, MOTION_NUMBERS);
    status = stewart_exact_inverse_dynamics(&robot, &at, &found);
    for (i = 0; i < 6 && status == STEWART_OK; ++i) {
        F[i] = (double)found.F[i];
    }
    return status;
}
