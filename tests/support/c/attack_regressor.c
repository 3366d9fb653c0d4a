/* Oracle of the regressor: one pose is what it is in the batch, chosen columns are those of all. See attack.h. */
#include "attack.h"
#include HEADER

#define ALL ((size_t)148)
#define CHOSEN ((size_t)5)

static const unsigned REGRESSOR_STATUS = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE)
    | ALLOWED(STEWART_ZERO_LENGTH) | ALLOWED(STEWART_JOINT_SINGULAR);
static const int COLUMNS[CHOSEN] = {147, 0, 23, 137, 138}, BEYOND[1] = {148}, BELOW[1] = {-1};
static const unsigned NEEDED = NULL_MODEL | NULL_MOTIONS | NULL_OUT | NULL_ARRAY(ARRAY_R) | NULL_ARRAY(ARRAY_T)
    | NULL_ARRAY(ARRAY_OMEGA) | NULL_ARRAY(ARRAY_V) | NULL_ARRAY(ARRAY_ALPHA) | NULL_ARRAY(ARRAY_A);

static int one(const attack_case *it, size_t pose, const int *columns, size_t width, stewart_real *Y, size_t numbers)
{
    int status;
    memset(Y, ATTACK_UNTOUCHED, numbers * sizeof *Y);
    status = KERNEL_NAME(_regressor)(&it->robot, &it->pose[pose], columns, width, Y);
    EXPECT(attack_known(status, REGRESSOR_STATUS));
    EXPECT(status == STEWART_OK ? attack_finite(Y, numbers) : attack_untouched(Y, numbers * sizeof *Y));
    return status;
}

static void chosen(const attack_case *it, size_t pose, const stewart_real *all, int code)
{
    stewart_real some[6 * CHOSEN];
    size_t i, j;
    EXPECT(one(it, pose, COLUMNS, CHOSEN, some, 6 * CHOSEN) == code);
    for (i = 0; code == STEWART_OK && i < 6; ++i) {
        for (j = 0; j < CHOSEN; ++j) {
            EXPECT(memcmp(&some[i * CHOSEN + j], &all[i * ALL + (size_t)COLUMNS[j]], sizeof *all) == 0);
        }
    }
}

void JOINED(attack_, KERNEL, _regressor)(const attack_case *it)
{
    const size_t numbers = 6 * ALL;
    const stewart_robot *robot = it->flags & NULL_MODEL ? 0 : &it->robot;
    stewart_real alone[6 * 148];
    int status[MOST_POSES];
    attack_arrays arrays;
    void *block;
    stewart_real *Y = attack_array(it, it->count * numbers, &block), *out = it->flags & NULL_OUT ? 0 : Y;
    const stewart_motions *motions;
    int first;
    size_t i;
    attack_arrays_make(it, &arrays);
    motions = it->flags & NULL_MOTIONS ? 0 : &arrays.motions;
    first = KERNEL_NAME(_regressor_batch)(
        robot, it->count, motions, 0, 0, out, it->flags & NULL_STATUS ? 0 : status);
    if (it->flags & NEEDED) {
        EXPECT(first == STEWART_BAD_ARGUMENT);
        EXPECT(attack_untouched(Y, it->count * numbers * sizeof *Y));
    } else {
        int codes[MOST_POSES];
        for (i = 0; i < it->count; ++i) {
            codes[i] = one(it, i, 0, 0, alone, numbers);
            EXPECT(memcmp(alone, Y + i * numbers, sizeof alone) == 0);
            EXPECT((it->flags & NULL_STATUS) || status[i] == codes[i]);
            chosen(it, i, alone, codes[i]);
        }
        EXPECT(first == attack_first(codes, it->count));
    }
    EXPECT(KERNEL_NAME(_regressor)(&it->robot, &it->pose[0], BEYOND, 1, alone) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_regressor)(&it->robot, &it->pose[0], BELOW, 1, alone) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_regressor)(&it->robot, &it->pose[0], 0, 1, alone) == STEWART_BAD_ARGUMENT);
    attack_arrays_free(&arrays);
    free(block);
}
