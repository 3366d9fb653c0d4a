/* Oracle of the forces with their bound: prepare, one pose and batch. See attack.h. */
#include "attack.h"
#include HEADER

#define MODEL KERNEL_NAME(_bounds_model)

static const unsigned POSE_STATUS = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE) | ALLOWED(STEWART_ZERO_LENGTH)
    | ALLOWED(STEWART_JOINT_SINGULAR) | ALLOWED(STEWART_SINGULAR);

static MODEL *prepared(const attack_case *it)
{
    MODEL *model = (MODEL *)malloc(sizeof *model);
    int status;
    EXPECT(model);
    memset(model, ATTACK_UNTOUCHED, sizeof *model);
    EXPECT(KERNEL_NAME(_bounds_prepare)(0, model) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_bounds_prepare)(&it->robot, 0) == STEWART_BAD_ARGUMENT);
    EXPECT(attack_untouched(model, sizeof *model));
    status = KERNEL_NAME(_bounds_prepare)(&it->robot, model);
    EXPECT(status == STEWART_OK || status == STEWART_NOT_FINITE);
    if (status == STEWART_OK) {
        return model;
    }
    EXPECT(attack_untouched(model, sizeof *model));
    free(model);
    return 0;
}

/* F is finite; a bound is a number, perhaps infinite, and no less than zero. */
static int one_pose(const attack_case *it, const MODEL *model, size_t pose, stewart_real F[6])
{
    stewart_real bound[6], rcond, alone[6];
    int status, i;
    memset(F, ATTACK_UNTOUCHED, 6 * sizeof *F);
    memset(alone, ATTACK_UNTOUCHED, sizeof alone);
    memset(bound, ATTACK_UNTOUCHED, sizeof bound);
    memset(&rcond, ATTACK_UNTOUCHED, sizeof rcond);
    status = KERNEL_NAME(_forces_bounded)(model, &it->pose[pose], F, bound, &rcond);
    EXPECT(attack_known(status, POSE_STATUS));
    EXPECT(KERNEL_NAME(_forces_bounded)(model, &it->pose[pose], alone, 0, 0) == status);
    EXPECT(memcmp(alone, F, sizeof alone) == 0);
    if (status == STEWART_OK) {
        EXPECT(attack_finite(F, 6));
        for (i = 0; i < 6; ++i) {
            EXPECT(bound[i] >= 0);
        }
    } else {
        EXPECT(attack_untouched(F, 6 * sizeof *F));
        EXPECT(attack_untouched(bound, sizeof bound));
        EXPECT(attack_untouched(&rcond, sizeof rcond));
    }
    return status;
}

void JOINED(attack_, KERNEL, _bounds)(const attack_case *it)
{
    MODEL *model = prepared(it);
    stewart_real F[MOST_POSES][6], found[MOST_POSES][6];
    int expected[MOST_POSES], status[MOST_POSES];
    /* A bound takes a hundred times as long as a force: of a batch, two poses. */
    const size_t count = it->count < 2 ? it->count : 2;
    attack_arrays arrays;
    size_t pose;
    if (!model) {
        return;
    }
    for (pose = 0; pose < count; ++pose) {
        expected[pose] = one_pose(it, model, pose, F[pose]);
    }
    attack_arrays_make(it, &arrays);
    if (!(it->flags & ~(NULL_ARRAY(ARRAY_F_EXT) | NULL_ARRAY(ARRAY_M_EXT) | ONE_OFF))) {
        memset(found, ATTACK_UNTOUCHED, sizeof found);
        EXPECT(KERNEL_NAME(_forces_bounded_batch)(model, count, &arrays.motions, found[0], 0, 0, status)
            == attack_first(expected, count));
        EXPECT(memcmp(found, F, count * sizeof *F) == 0);
        EXPECT(memcmp(status, expected, count * sizeof *status) == 0);
    }
    EXPECT(KERNEL_NAME(_forces_bounded)(0, &it->pose[0], found[0], 0, 0) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_forces_bounded)(model, 0, found[0], 0, 0) == STEWART_BAD_ARGUMENT);
    EXPECT(KERNEL_NAME(_forces_bounded)(model, &it->pose[0], 0, 0, 0) == STEWART_BAD_ARGUMENT);
    attack_arrays_free(&arrays);
    free(model);
}
