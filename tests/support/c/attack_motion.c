/* Oracle of the closed form: its six functions, one pose and batch. See attack.h. */
#include "attack.h"
#include HEADER

#define MODEL KERNEL_NAME(_model)
#define MOST_NUMBERS 256
#define MOST_ARRAYS 9

static const unsigned POSE_STATUS = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE) | ALLOWED(STEWART_ZERO_LENGTH)
    | ALLOWED(STEWART_JOINT_SINGULAR) | ALLOWED(STEWART_SINGULAR) | ALLOWED(STEWART_MASS_MATRIX_INDEFINITE);

enum { EQUATIONS, BIAS, FORWARD_DYNAMICS, JOINT_INERTIA, DERIVATIVES, LINEARISATION, FUNCTIONS };

/* Widths of a pose's parts in each function's output, in the order of its struct, up to a 0. */
static const size_t WIDTHS[FUNCTIONS][MOST_ARRAYS] = {
    {36, 36, 6, 6, 6, 6, 36, 36, 0}, {6, 0}, {6, 0}, {36, 0}, {6, 36, 36, 36, 0}, {6, 144, 72, 0},
};

static int one(int what, const MODEL *model, const stewart_motion *motion, const stewart_real *F, stewart_real *out)
{
    switch (what) {
    case EQUATIONS: return KERNEL_NAME(_equations)(model, motion, (stewart_equations *)(void *)out);
    case BIAS: return KERNEL_NAME(_bias_and_friction)(model, motion, out);
    case FORWARD_DYNAMICS: return KERNEL_NAME(_forward_dynamics)(model, motion, F, out);
    case JOINT_INERTIA: return KERNEL_NAME(_joint_inertia)(model, motion, out);
    case DERIVATIVES: return KERNEL_NAME(_derivatives)(model, motion, (stewart_derivatives *)(void *)out);
    default: return KERNEL_NAME(_linearization)(model, motion, F, (stewart_linearization *)(void *)out);
    }
}

static int many(
    int what, const MODEL *model, size_t count, const stewart_motions *motions, const stewart_real *F,
    stewart_real *const *out, int missing, int *status)
{
    stewart_equations_arrays equations;
    stewart_derivatives_arrays derivatives;
    stewart_linearization_arrays linearization;
    stewart_real *single = missing ? 0 : out[0];
    memcpy(&equations, out, sizeof equations);
    memcpy(&derivatives, out, sizeof derivatives);
    memcpy(&linearization, out, sizeof linearization);
    switch (what) {
    case EQUATIONS: return KERNEL_NAME(_equations_batch)(model, count, motions, missing ? 0 : &equations, status);
    case BIAS: return KERNEL_NAME(_bias_and_friction_batch)(model, count, motions, single, status);
    case FORWARD_DYNAMICS: return KERNEL_NAME(_forward_dynamics_batch)(model, count, motions, F, single, status);
    case JOINT_INERTIA: return KERNEL_NAME(_joint_inertia_batch)(model, count, motions, single, status);
    case DERIVATIVES: return KERNEL_NAME(_derivatives_batch)(model, count, motions, missing ? 0 : &derivatives, status);
    default:
        return KERNEL_NAME(_linearization_batch)(model, count, motions, F, missing ? 0 : &linearization, status);
    }
}

static size_t width_of(int what)
{
    size_t sum = 0;
    int i;
    for (i = 0; WIDTHS[what][i]; ++i) {
        sum += WIDTHS[what][i];
    }
    return sum;
}

static int one_pose(const attack_case *it, int what, const MODEL *model, size_t pose, stewart_real *out)
{
    const size_t width = width_of(what);
    int status;
    memset(out, ATTACK_UNTOUCHED, width * sizeof *out);
    status = one(what, model, &it->pose[pose], it->F[pose], out);
    EXPECT(attack_known(status, POSE_STATUS));
    EXPECT(status == STEWART_OK ? attack_finite(out, width) : attack_untouched(out, width * sizeof *out));
    return status;
}

/* Whether this function must reject, or may, since a pointer is null that it reads, or might. */
static int must_reject(const attack_case *it, int what)
{
    const unsigned forced = what == FORWARD_DYNAMICS || what == LINEARISATION ? NULL_FORCES : 0;
    const unsigned accelerated = what == DERIVATIVES ? NULL_ARRAY(ARRAY_ALPHA) | NULL_ARRAY(ARRAY_A) : 0;
    const unsigned single = what == BIAS || what == FORWARD_DYNAMICS || what == JOINT_INERTIA ? 1u << 16 : 0;
    return (it->flags
            & (NULL_MODEL | NULL_MOTIONS | NULL_OUT | forced | accelerated | single | NULL_ARRAY(ARRAY_R)
                | NULL_ARRAY(ARRAY_T) | NULL_ARRAY(ARRAY_OMEGA) | NULL_ARRAY(ARRAY_V)))
        != 0;
}

static void attack(const attack_case *it, int what, const MODEL *model)
{
    stewart_real alone[MOST_NUMBERS];
    void *block[MOST_ARRAYS] = {0}, *F_block;
    stewart_real *out[MOST_ARRAYS] = {0};
    stewart_real *F = attack_array(it, it->count * 6, &F_block);
    int *status = (int *)malloc(it->count * sizeof *status + 1);
    int expected[MOST_POSES];
    attack_arrays arrays;
    size_t pose;
    int i, found;
    EXPECT(status);
    memcpy(F, it->F, it->count * 6 * sizeof *F);
    attack_arrays_make(it, &arrays);
    memset(status, ATTACK_UNTOUCHED, it->count * sizeof *status);
    memset(alone, ATTACK_UNTOUCHED, sizeof alone);
    EXPECT(one(what, 0, &it->pose[0], it->F[0], alone) == STEWART_BAD_ARGUMENT);
    EXPECT(one(what, model, 0, it->F[0], alone) == STEWART_BAD_ARGUMENT);
    EXPECT(one(what, model, &it->pose[0], it->F[0], 0) == STEWART_BAD_ARGUMENT);
    if (what == FORWARD_DYNAMICS || what == LINEARISATION) {
        EXPECT(one(what, model, &it->pose[0], 0, alone) == STEWART_BAD_ARGUMENT);
    }
    EXPECT(attack_untouched(alone, sizeof alone));
    for (i = 0; WIDTHS[what][i]; ++i) {
        if (!(it->flags >> (16 + i) & 1u)) {
            out[i] = attack_array(it, it->count * WIDTHS[what][i], &block[i]);
        }
    }
    found = many(
        what, it->flags & NULL_MODEL ? 0 : model, it->count, it->flags & NULL_MOTIONS ? 0 : &arrays.motions,
        it->flags & NULL_FORCES ? 0 : F, out, (it->flags & NULL_OUT) != 0, it->flags & NULL_STATUS ? 0 : status);
    EXPECT((found == STEWART_BAD_ARGUMENT) == must_reject(it, what));
    for (pose = 0; pose < it->count; ++pose) {
        const stewart_real *part = alone;
        expected[pose] = one_pose(it, what, model, pose, alone);
        if (found == STEWART_BAD_ARGUMENT) {
            memset(alone, ATTACK_UNTOUCHED, sizeof alone);
        }
        for (i = 0; WIDTHS[what][i]; ++i) {
            if (out[i]) {
                EXPECT(memcmp(out[i] + pose * WIDTHS[what][i], part, WIDTHS[what][i] * sizeof *part) == 0);
            }
            part += WIDTHS[what][i];
        }
    }
    if (found == STEWART_BAD_ARGUMENT || it->flags & NULL_STATUS) {
        EXPECT(attack_untouched(status, it->count * sizeof *status));
    } else {
        EXPECT(memcmp(status, expected, it->count * sizeof *status) == 0);
    }
    EXPECT(found == STEWART_BAD_ARGUMENT || found == attack_first(expected, it->count));
    for (i = 0; i < MOST_ARRAYS; ++i) {
        free(block[i]);
    }
    attack_arrays_free(&arrays);
    free(F_block);
    free(status);
}

void JOINED(attack_, KERNEL, _motion)(const attack_case *it)
{
    MODEL *model = (MODEL *)malloc(sizeof *model);
    int what;
    EXPECT(model);
    if (KERNEL_NAME(_prepare)(&it->robot, model) == STEWART_OK) {
        for (what = 0; what < FUNCTIONS; ++what) {
            attack(it, what, model);
        }
    }
    free(model);
}
