/* Oracle of a force kernel: prepare, one pose, batch and batch of columns. See attack.h. */
#include "attack.h"
#include HEADER

#define MODEL KERNEL_NAME(_model)

static const unsigned POSE_STATUS = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE) | ALLOWED(STEWART_ZERO_LENGTH)
    | ALLOWED(STEWART_JOINT_SINGULAR) | ALLOWED(STEWART_SINGULAR);

static MODEL *prepared(const attack_case *it)
{
    MODEL *model = (MODEL *)malloc(sizeof *model);
    int status;
    EXPECT(model);
    memset(model, ATTACK_UNTOUCHED, sizeof *model);
    EXPECT(KERNEL_NAME(_prepare)(0, model) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_prepare)(&it->robot, 0) == STEWART_BAD_ARGUMENT);
    EXPECT(attack_untouched(model, sizeof *model));
    status = KERNEL_NAME(_prepare)(&it->robot, model);
    EXPECT(status == STEWART_OK || status == STEWART_NOT_FINITE);
    if (status == STEWART_OK) {
        EXPECT(attack_finite((const stewart_real *)model, sizeof *model / sizeof(stewart_real)));
        return model;
    }
    EXPECT(attack_untouched(model, sizeof *model));
    free(model);
    return 0;
}

static int one_pose(const attack_case *it, const MODEL *model, size_t pose, stewart_real F[6])
{
    int status;
    memset(F, ATTACK_UNTOUCHED, 6 * sizeof *F);
    status = KERNEL_NAME(_forces)(model, &it->pose[pose], F);
    EXPECT(attack_known(status, POSE_STATUS));
    EXPECT(status == STEWART_OK ? attack_finite(F, 6) : attack_untouched(F, 6 * sizeof *F));
    return status;
}

/* A rejection where something is missing that this kernel reads, else what one pose at a time gives. */
static void batch(
    const attack_case *it, const MODEL *model, stewart_real (*alone)[6], const int *expected, int *status)
{
    attack_arrays arrays;
    void *block;
    stewart_real *F = attack_array(it, it->count * 6, &block);
    const unsigned nulls = it->flags;
    const unsigned load = NULL_ARRAY(ARRAY_F_EXT) | NULL_ARRAY(ARRAY_M_EXT) | NULL_STATUS | ONE_OFF;
    int found;
    attack_arrays_make(it, &arrays);
    memset(status, ATTACK_UNTOUCHED, it->count * sizeof *status);
    found = KERNEL_NAME(_forces_batch)(
        nulls & NULL_MODEL ? 0 : model, it->count, nulls & NULL_MOTIONS ? 0 : &arrays.motions,
        nulls & NULL_OUT ? 0 : F, nulls & NULL_STATUS ? 0 : status);
    if (nulls & (NULL_MODEL | NULL_MOTIONS | NULL_OUT | NULL_ARRAY(ARRAY_R) | NULL_ARRAY(ARRAY_T))) {
        EXPECT(found == STEWART_BAD_ARGUMENT);
    }
    if (found == STEWART_BAD_ARGUMENT) {
        EXPECT(nulls & ~load);
        EXPECT(attack_untouched(F, it->count * 6 * sizeof *F));
        EXPECT(attack_untouched(status, it->count * sizeof *status));
    } else {
        EXPECT(found == attack_first(expected, it->count));
        EXPECT(memcmp(alone, F, it->count * sizeof *alone) == 0);
        EXPECT(nulls & NULL_STATUS ? attack_untouched(status, it->count * sizeof *status)
                                   : memcmp(status, expected, it->count * sizeof *status) == 0);
    }
    attack_arrays_free(&arrays);
    free(block);
}

/* The same of columns, one after the other. */
static void columns(const attack_case *it, const MODEL *model, stewart_real (*alone)[6], const int *expected)
{
    attack_arrays rows;
    stewart_motions motions;
    const stewart_real *from[ARRAYS], *to[ARRAYS];
    void *block[ARRAYS + 1];
    stewart_real *F = attack_array(it, it->count * 6, &block[ARRAYS]);
    size_t pose, j;
    int i, found;
    attack_arrays_make(it, &rows);
    memcpy(from, &rows.motions, sizeof from);
    for (i = 0; i < ARRAYS; ++i) {
        const size_t width = i == ARRAY_R ? 9 : 3;
        stewart_real *numbers = attack_array(it, it->count * width, &block[i]);
        for (j = 0; from[i] && j < it->count * width; ++j) {
            numbers[j % width * it->count + j / width] = from[i][j];
        }
        to[i] = from[i] ? numbers : 0;
    }
    memcpy(&motions, to, sizeof to);
    found = KERNEL_NAME(_forces_columns)(model, it->count, it->count, &motions, F, 0);
    if (found == STEWART_BAD_ARGUMENT) {
        EXPECT(attack_untouched(F, it->count * 6 * sizeof *F));
    } else {
        EXPECT(found == attack_first(expected, it->count));
        for (pose = 0; pose < it->count; ++pose) {
            for (j = 0; j < 6; ++j) {
                EXPECT(memcmp(&alone[pose][j], &F[j * it->count + pose], sizeof *F) == 0);
            }
        }
    }
    if (it->count > 0) {
        EXPECT(KERNEL_NAME(_forces_columns)(model, it->count, it->count - 1, &motions, F, 0) == STEWART_BAD_ARGUMENT);
    }
    EXPECT(KERNEL_NAME(_forces_columns)(0, it->count, it->count, &motions, F, 0) == STEWART_BAD_ARGUMENT);
    for (i = 0; i <= ARRAYS; ++i) {
        free(block[i]);
    }
    attack_arrays_free(&rows);
}

void JOINED(attack_, KERNEL, _forces)(const attack_case *it)
{
    MODEL *model = prepared(it);
    stewart_real F[MOST_POSES][6];
    int *status = (int *)malloc(it->count * sizeof *status + 1);
    int expected[MOST_POSES];
    size_t pose;
    EXPECT(status);
    if (model) {
        for (pose = 0; pose < it->count; ++pose) {
            expected[pose] = one_pose(it, model, pose, F[pose]);
        }
        batch(it, model, F, expected, status);
        columns(it, model, F, expected);
        memset(F, ATTACK_UNTOUCHED, sizeof F);
        EXPECT(KERNEL_NAME(_forces)(0, &it->pose[0], F[0]) == STEWART_BAD_ARGUMENT);
        EXPECT(KERNEL_NAME(_forces)(model, 0, F[0]) == STEWART_BAD_ARGUMENT);
        EXPECT(attack_untouched(F, sizeof F));
        EXPECT(KERNEL_NAME(_forces)(model, &it->pose[0], 0) == STEWART_BAD_ARGUMENT);
    }
    free(status);
    free(model);
}
