/* count.c: checks a one-pose kernel on an emulated Cortex-M, and counts its instructions and its stack.
 *
 * `cases.h`, written for the kernel, names its functions and holds motions with their forces, and motions
 * unsolvable ones. Prints one number a line; returns 0 if every answer is right.
 */
#include "board.h"
#include "cases.h"

#define TIMES 100
#define UNTOUCHED ((stewart_real)-1.25)

static stewart_motion at;
static stewart_real F[6];
#if !defined(BAKED)
static MODEL model, blank;
static stewart_robot odd;
#define FORCES_OF(motion, out) FORCES(&model, motion, out)
#else
#define FORCES_OF(motion, out) FORCES(motion, out)
#endif

static int forces(void)
{
    return FORCES_OF(&at, F);
}

/* Nothing but the return of a function with the same arguments. */
#if defined(BAKED)
__attribute__((naked, noinline)) static int nothing(const stewart_motion *motion, stewart_real out[6])
{
    (void)motion;
    (void)out;
    __asm__ volatile("bx lr");
}
static int no_forces(void)
{
    return nothing(&at, F);
}
#else
__attribute__((naked, noinline)) static int nothing(
    const MODEL *of, const stewart_motion *motion, stewart_real out[6])
{
    (void)of;
    (void)motion;
    (void)out;
    __asm__ volatile("bx lr");
}
static int no_forces(void)
{
    return nothing(&model, &at, F);
}
static int prepare(void)
{
    return PREPARE(&ROBOT, &model);
}
#endif

#if defined(NEAR_SINGULAR_JOINTS)
/* The robot with all legs near singularities of their joints at the first motion. */
static int lean(void)
{
    int i, j;
    odd = ROBOT;
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            odd.leg[i].k[j] = near_singular_joints[i][j];
        }
    }
    return PREPARE(&odd, &model);
}
#endif

#if defined(DRIVES)
static stewart_real axial[6], rate[6], torque[6], current[6];

static int torques(void)
{
    return stewart_motor_torques(&DRIVES, F, axial, rate, torque, current);
}
#if defined(AXIAL)
static int axial_forces(void)
{
    return AXIAL(&ROBOT, &at, F, axial, rate);
}
#endif

/* Instructions and stack of what is called after the forces, of motion i, at `at`. */
static int32_t count_torques(int i)
{
    int32_t failed = forces() != STEWART_OK;
    int j;
    for (j = 0; j < 6; ++j) {
        axial[j] = F[j];
        rate[j] = rates[i][j];
    }
#if defined(AXIAL)
    failed += axial_forces() != STEWART_OK;
    board_print_number("ticks_axial_forces", (int32_t)board_ticks(axial_forces, TIMES));
    board_print_number("stack_axial_forces", (int32_t)board_stack(axial_forces));
#endif
    failed += torques() != STEWART_OK;
    board_print_number("ticks_motor_torques", (int32_t)board_ticks(torques, TIMES));
    board_print_number("stack_motor_torques", (int32_t)board_stack(torques));
    return failed;
}
#endif

static void clear(void)
{
    int i;
    for (i = 0; i < 6; ++i) {
        F[i] = UNTOUCHED;
    }
}

/* 1 if a call did not return what it has to, or wrote forces with a status. */
static int32_t wrong(int status, int expected)
{
    int i, touched = 0;
    for (i = 0; i < 6; ++i) {
        touched |= !(F[i] >= UNTOUCHED && F[i] <= UNTOUCHED);
    }
    clear();
    return status != expected || touched;
}

/* Calls with wrong arguments or of unsolvable poses; returns how many were not told so. */
static int32_t rejected(void)
{
    int32_t found = 0;
    int i;
    clear();
    found += wrong(FORCES_OF(0, F), STEWART_BAD_ARGUMENT);
    found += wrong(FORCES_OF(&motions[0], 0), STEWART_BAD_ARGUMENT);
#if !defined(BAKED)
    found += wrong(FORCES(0, &motions[0], F), STEWART_BAD_ARGUMENT);
    found += wrong(PREPARE(0, &blank), STEWART_BAD_ARGUMENT);
    found += wrong(PREPARE(&ROBOT, 0), STEWART_BAD_ARGUMENT);
    odd = ROBOT;
    odd.leg[4].p[1] = (stewart_real)NAN;
    found += wrong(PREPARE(&odd, &blank), STEWART_NOT_FINITE);
    found += wrong(FORCES(&blank, &motions[0], F) == STEWART_OK, 0);
#endif
    for (i = 0; i < REJECTED; ++i) {
        found += wrong(FORCES_OF(&rejected_motions[i], F), rejected_status[i]);
    }
    return found;
}

int main(void)
{
    int32_t failed = 0, untold = 0;
    double worst = 0;
    uint32_t empty, deepest = 0;
    int i, j;
#if !defined(BAKED)
    at = motions[0];
    board_print_number("model_bytes", (int32_t)sizeof model);
    deepest = board_stack(prepare);
    board_print_number("stack_prepare", (int32_t)deepest);
    failed += PREPARE(&ROBOT, &model) != STEWART_OK;
#endif
    for (i = 0; i < MOTIONS; ++i) {
        failed += FORCES_OF(&motions[i], F) != STEWART_OK;
        for (j = 0; j < 6; ++j) {
            const double error = (double)F[j] - expected[i][j];
            const double units = (error < 0 ? -error : error) / bounds[i][j];
            worst = units <= worst ? worst : units;
            failed += !(units <= 1);
        }
    }
    board_print_number("worst_error_ppm_of_bound", worst <= 2000 ? (int32_t)(worst * 1e6) : 2000000000);
    untold = rejected();
    board_print_number("rejected_wrongly", untold);
    board_print_number("known", (int32_t)board_ticks_of_known());
    at = motions[0];
    empty = board_ticks(no_forces, TIMES);
    board_print_number("empty", (int32_t)empty);
    board_print_number("stack_empty", (int32_t)board_stack(no_forces));
    deepest = 0;
    for (i = 0; i < MOTIONS; ++i) {
        uint32_t depth;
        at = motions[i];
        board_print_number("ticks", (int32_t)board_ticks(forces, TIMES));
        depth = board_stack(forces);
        deepest = depth > deepest ? depth : deepest;
#if defined(DRIVES)
        failed += count_torques(i);
#endif
    }
    board_print_number("times", TIMES);
#if defined(NEAR_SINGULAR_JOINTS)
    at = motions[0];
    failed += lean() != STEWART_OK || forces() != STEWART_OK;
    board_print_number("ticks_near_singular_joints", (int32_t)board_ticks(forces, TIMES));
    deepest = board_stack(forces) > deepest ? board_stack(forces) : deepest;
#endif
    board_print_number("stack_forces", (int32_t)deepest);
    board_print_number("failed", failed);
    return failed + untold > 0;
}
