/* kinematics.c: checks inverse and forward kinematics on an emulated Cortex-M, and counts instructions and stack.
 *
 * `poses.h` holds motions and guesses near their poses. Prints one number a line; returns 0 if every answer is
 * right.
 */
#include "board.h"
#include "stewart_kinematics.h"
#include "stewart_robot.h"

#include "poses.h"

#define TIMES 20

static stewart_motion at;
static stewart_pose guess, pose;
static stewart_real L[6], L_dot[6], v[3], omega[3];

static int inverse(void)
{
    return stewart_inverse_kinematics(&ROBOT, &at, L, L_dot);
}

static int forward(void)
{
    pose = guess;
    return stewart_forward_kinematics(&ROBOT, L, &pose);
}

static int velocity(void)
{
    return stewart_forward_velocity(&ROBOT, &pose, L_dot, v, omega);
}

/* Nothing but the return of a function without arguments. */
__attribute__((naked, noinline)) static int nothing(void)
{
    __asm__ volatile("bx lr");
}

/* 1 if numbers differ by more than the tolerance. */
static int32_t differ(const stewart_real *one, const stewart_real *other, int count)
{
    int i;
    for (i = 0; i < count; ++i) {
        const double error = (double)one[i] - (double)other[i];
        if (!(error <= TOLERANCE && error >= -TOLERANCE)) {
            return 1;
        }
    }
    return 0;
}

int main(void)
{
    int32_t failed = 0;
    int i;
    board_print_number("known", (int32_t)board_ticks_of_known());
    board_print_number("times", TIMES);
    board_print_number("empty", (int32_t)board_ticks(nothing, TIMES));
    board_print_number("stack_empty", (int32_t)board_stack(nothing));
    for (i = 0; i < MOTIONS; ++i) {
        at = motions[i];
        guess = guesses[i];
        failed += inverse() != STEWART_OK;
        failed += forward() != STEWART_OK || differ(pose.R, at.R, 9) || differ(pose.t, at.t, 3);
        failed += velocity() != STEWART_OK || differ(v, at.v, 3) || differ(omega, at.omega, 3);
        board_print_number("ticks_inverse", (int32_t)board_ticks(inverse, TIMES));
        board_print_number("stack_inverse", (int32_t)board_stack(inverse));
        board_print_number("ticks_forward", (int32_t)board_ticks(forward, TIMES));
        board_print_number("stack_forward", (int32_t)board_stack(forward));
        board_print_number("ticks_velocity", (int32_t)board_ticks(velocity, TIMES));
        board_print_number("stack_velocity", (int32_t)board_stack(velocity));
    }
    board_print_number("failed", failed);
    return failed > 0;
}
