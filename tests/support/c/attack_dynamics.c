/* Oracle of a kernel of every output: inverse dynamics and joint reactions, one pose and batch. See attack.h. */
#include "attack.h"
#include HEADER

static const unsigned POSE_STATUS = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE) | ALLOWED(STEWART_ZERO_LENGTH)
    | ALLOWED(STEWART_JOINT_SINGULAR) | ALLOWED(STEWART_SINGULAR);

#define NUMBERS(type) (sizeof(type) / sizeof(stewart_real))

static int forces_of(const attack_case *it, size_t pose, stewart_forces *out)
{
    int status;
    memset(out, ATTACK_UNTOUCHED, sizeof *out);
    status = KERNEL_NAME(_inverse_dynamics)(&it->robot, &it->pose[pose], out);
    EXPECT(attack_known(status, POSE_STATUS));
    EXPECT(status == STEWART_OK ? attack_finite((const stewart_real *)out, NUMBERS(stewart_forces))
                                : attack_untouched(out, sizeof *out));
    return status;
}

static int reactions_of(
    const attack_case *it, size_t pose, const stewart_real *bearing, stewart_forces *forces,
    stewart_reactions *out)
{
    int status;
    memset(forces, ATTACK_UNTOUCHED, sizeof *forces);
    memset(out, ATTACK_UNTOUCHED, sizeof *out);
    status = KERNEL_NAME(_joint_reactions)(&it->robot, &it->pose[pose], bearing, forces, out);
    EXPECT(attack_known(status, POSE_STATUS));
    if (status == STEWART_OK) {
        EXPECT(attack_finite((const stewart_real *)forces, NUMBERS(stewart_forces)));
        EXPECT(attack_finite((const stewart_real *)out, NUMBERS(stewart_reactions)));
    } else {
        EXPECT(attack_untouched(forces, sizeof *forces));
        EXPECT(attack_untouched(out, sizeof *out));
    }
    return status;
}

/* The arrays of a batch laid side by side, each of its own size; some of them null. */
typedef struct {
    void *block[6];
    stewart_real *array[6];
} outputs;

static void make(const attack_case *it, const size_t *width, unsigned missing, outputs *out)
{
    int i;
    for (i = 0; i < 6; ++i) {
        out->array[i] = attack_array(it, it->count * width[i], &out->block[i]);
        if (missing >> i & 1u) {
            free(out->block[i]);
            out->block[i] = 0;
            out->array[i] = 0;
        }
    }
}

static void check(const attack_case *it, const size_t *width, const outputs *out, size_t pose, const stewart_real *one)
{
    int i;
    for (i = 0; i < 6; ++i) {
        if (out->array[i]) {
            EXPECT(memcmp(out->array[i] + pose * width[i], one, width[i] * sizeof *one) == 0);
        }
        one += width[i];
    }
    (void)it;
}

static void drop(outputs *out)
{
    int i;
    for (i = 0; i < 6; ++i) {
        free(out->block[i]);
    }
}

static void check_case(const attack_case *it, int found, const int *expected, const int *status)
{
    const unsigned needed = NULL_MODEL | NULL_MOTIONS | NULL_OUT | 0x3Fu << FIRST_ARRAY;
    if (it->flags & needed) {
        EXPECT(found == STEWART_BAD_ARGUMENT);
        EXPECT(attack_untouched(status, it->count * sizeof *status));
        return;
    }
    EXPECT(found == attack_first(expected, it->count));
    EXPECT(it->flags & NULL_STATUS ? attack_untouched(status, it->count * sizeof *status)
                                   : memcmp(status, expected, it->count * sizeof *status) == 0);
}

void JOINED(attack_, KERNEL, _dynamics)(const attack_case *it)
{
    static const size_t force_width[6] = {6, 6, 6, 18, 36, 6}, reaction_width[6] = {18, 18, 18, 18, 18, 6};
    const stewart_real *bearing = it->flags & NULL_BEARING ? 0 : it->bearing;
    const stewart_robot *robot = it->flags & NULL_MODEL ? 0 : &it->robot;
    int *status = (int *)malloc(it->count * sizeof *status + 1);
    int expected[MOST_POSES];
    stewart_forces forces, again;
    stewart_reactions reactions;
    stewart_forces_arrays forces_out;
    stewart_reactions_arrays reactions_out;
    attack_arrays arrays;
    outputs out;
    size_t pose;
    int found;
    EXPECT(status);
    attack_arrays_make(it, &arrays);
    memset(&forces, ATTACK_UNTOUCHED, sizeof forces);
    memset(&reactions, ATTACK_UNTOUCHED, sizeof reactions);
    EXPECT(KERNEL_NAME(_inverse_dynamics)(0, &it->pose[0], &forces) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_inverse_dynamics)(&it->robot, 0, &forces) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_inverse_dynamics)(&it->robot, &it->pose[0], 0) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_joint_reactions)(0, &it->pose[0], bearing, &forces, &reactions) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_joint_reactions)(&it->robot, 0, bearing, &forces, &reactions) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_joint_reactions)(&it->robot, &it->pose[0], bearing, 0, &reactions) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_joint_reactions)(&it->robot, &it->pose[0], bearing, &forces, 0) == STEWART_BAD_ARGUMENT);
    EXPECT(attack_untouched(&forces, sizeof forces));
    EXPECT(attack_untouched(&reactions, sizeof reactions));

    memset(status, ATTACK_UNTOUCHED, it->count * sizeof *status);
    make(it, force_width, it->flags >> 16, &out);
    memcpy(&forces_out, out.array, sizeof forces_out);
    found = KERNEL_NAME(_inverse_dynamics_batch)(
        robot, it->count, it->flags & NULL_MOTIONS ? 0 : &arrays.motions, it->flags & NULL_OUT ? 0 : &forces_out,
        it->flags & NULL_STATUS ? 0 : status);
    for (pose = 0; pose < it->count; ++pose) {
        expected[pose] = forces_of(it, pose, &forces);
        if (found == STEWART_BAD_ARGUMENT) {
            memset(&forces, ATTACK_UNTOUCHED, sizeof forces);
        }
        check(it, force_width, &out, pose, (const stewart_real *)&forces);
    }
    check_case(it, found, expected, status);
    drop(&out);

    memset(status, ATTACK_UNTOUCHED, it->count * sizeof *status);
    make(it, reaction_width, it->flags >> 16, &out);
    memcpy(&reactions_out, out.array, sizeof reactions_out);
    found = KERNEL_NAME(_joint_reactions_batch)(
        robot, it->count, it->flags & NULL_MOTIONS ? 0 : &arrays.motions, bearing,
        it->flags & NULL_OUT ? 0 : &reactions_out, it->flags & NULL_STATUS ? 0 : status);
    for (pose = 0; pose < it->count; ++pose) {
        expected[pose] = reactions_of(it, pose, bearing, &forces, &reactions);
        if (expected[pose] == STEWART_OK) {
            EXPECT(forces_of(it, pose, &again) == STEWART_OK);
            EXPECT(memcmp(&forces, &again, sizeof forces) == 0);
        }
        if (found == STEWART_BAD_ARGUMENT) {
            memset(&reactions, ATTACK_UNTOUCHED, sizeof reactions);
        }
        check(it, reaction_width, &out, pose, (const stewart_real *)&reactions);
    }
    check_case(it, found, expected, status);
    drop(&out);
    attack_arrays_free(&arrays);
    free(status);
}
