/* kinematics.c: checks inverse and forward kinematics on an emulated Cortex-M, and counts their instructions.
 *
 * `kinematics_cases.h` names the robot and holds motions, with a guess near each of their poses.
 */
#include "board.h"
#include "kinematics_cases.h"
#include <string.h>

#define TIMES 20

static stewart_motion at, there;
static stewart_pose guess, pose;
static stewart_real L[6], L_dot[6], L_found[6];

static int lengths(void)
{
    return stewart_inverse_kinematics(&ROBOT, &at, L, 0);
}

static int rates(void)
{
    return stewart_inverse_kinematics(&ROBOT, &at, L, L_dot);
}

static int search(void)
{
    pose = guess;
    return stewart_forward_kinematics(&ROBOT, L, &pose);
}

/* The copy of the guess and the calls, which are no part of the functions. */
static int copy(void)
{
    pose = guess;
    return 0;
}

int main(void)
{
    int32_t failed = 0;
    int i, j;
    board_print_number("known", (int32_t)board_ticks_of_known());
    board_print_number("empty", (int32_t)board_ticks(copy, TIMES));
    board_print_number("times", TIMES);
    for (i = 0; i < MOTIONS; ++i) {
        at = motions[i];
        guess = guesses[i];
        failed += rates() != STEWART_OK;
        failed += search() != STEWART_OK;
        there = at;
        memcpy(there.R, pose.R, sizeof pose.R);
        memcpy(there.t, pose.t, sizeof pose.t);
        failed += stewart_inverse_kinematics(&ROBOT, &there, L_found, 0) != STEWART_OK;
        for (j = 0; j < 6; ++j) {
            const stewart_real error = L_found[j] - L[j];
            failed += !(error < ERROR && -error < ERROR);
        }
        board_print_number("lengths", (int32_t)board_ticks(lengths, TIMES));
        board_print_number("rates", (int32_t)board_ticks(rates, TIMES));
        board_print_number("search", (int32_t)board_ticks(search, TIMES));
    }
    board_print_number("failed", failed);
    return failed > 0;
}
