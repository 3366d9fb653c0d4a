/* hold.c: print the force of leg 1 that holds the hexapod 0.65 m above its base. */
#include <stdio.h>

#include "stewart_robot.h"
#include "stewart_exact_forces.h"

int main(void)
{
    static stewart_exact_model model;                    /* constants, prepared once */
    stewart_motion motion = {.R = {1, 0, 0, 0, 1, 0, 0, 0, 1}, .t = {0.0, 0.0, 0.65}};
    stewart_real F[6];

    int status = stewart_exact_prepare(&stewart_robot_hexapod, &model);
    if (status == STEWART_OK) {
        status = stewart_exact_forces(&model, &motion, F);
    }
    if (status != STEWART_OK) {
        return status;                                   /* F keeps its old values */
    }
    printf("leg 1: %.1f N\n", (double)F[0]);
    return 0;
}
