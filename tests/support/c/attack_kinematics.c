/* Oracle of the kinematics: lengths from a pose, pose and velocity back. See attack.h. */
#include "attack.h"
#include HEADER

static const unsigned LENGTH_STATUS
    = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE) | ALLOWED(STEWART_ZERO_LENGTH);
static const unsigned VELOCITY_STATUS = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE)
    | ALLOWED(STEWART_ZERO_LENGTH) | ALLOWED(STEWART_SINGULAR);
static const unsigned SEARCH_STATUS = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE)
    | ALLOWED(STEWART_ZERO_LENGTH) | ALLOWED(STEWART_SINGULAR) | ALLOWED(STEWART_NOT_CONVERGED);

static int lengths(const attack_case *it, const stewart_motion *motion, stewart_real L[6], stewart_real L_dot[6])
{
    const size_t size = 6 * sizeof *L;
    stewart_real alone[6];
    int status, i;
    memset(L, ATTACK_UNTOUCHED, size);
    memset(L_dot, ATTACK_UNTOUCHED, size);
    memset(alone, ATTACK_UNTOUCHED, size);
    EXPECT(stewart_inverse_kinematics(0, motion, L, L_dot) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_inverse_kinematics(&it->robot, 0, L, L_dot) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_inverse_kinematics(&it->robot, motion, 0, L_dot) == STEWART_BAD_ARGUMENT);
    EXPECT(attack_untouched(L, size));
    status = stewart_inverse_kinematics(&it->robot, motion, L, L_dot);
    EXPECT(attack_known(status, LENGTH_STATUS));
    if (status == STEWART_OK) {
        EXPECT(attack_finite(L, 6) && attack_finite(L_dot, 6));
        for (i = 0; i < 6; ++i) {
            EXPECT(L[i] > 0);
        }
        EXPECT(stewart_inverse_kinematics(&it->robot, motion, alone, 0) == STEWART_OK);
        EXPECT(memcmp(alone, L, size) == 0);
    } else {
        EXPECT(attack_untouched(L, size) && attack_untouched(L_dot, size));
    }
    return status;
}

static void velocity(const attack_case *it, const stewart_pose *pose, const stewart_real L_dot[6])
{
    stewart_real v[3], omega[3];
    int status;
    memset(v, ATTACK_UNTOUCHED, sizeof v);
    memset(omega, ATTACK_UNTOUCHED, sizeof omega);
    EXPECT(stewart_forward_velocity(0, pose, L_dot, v, omega) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_forward_velocity(&it->robot, 0, L_dot, v, omega) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_forward_velocity(&it->robot, pose, 0, v, omega) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_forward_velocity(&it->robot, pose, L_dot, 0, omega) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_forward_velocity(&it->robot, pose, L_dot, v, 0) == STEWART_BAD_ARGUMENT);
    EXPECT(attack_untouched(v, sizeof v) && attack_untouched(omega, sizeof omega));
    status = stewart_forward_velocity(&it->robot, pose, L_dot, v, omega);
    EXPECT(attack_known(status, VELOCITY_STATUS));
    if (status == STEWART_OK) {
        EXPECT(attack_finite(v, 3) && attack_finite(omega, 3));
    } else {
        EXPECT(attack_untouched(v, sizeof v) && attack_untouched(omega, sizeof omega));
    }
}

/* Whether two stretches of numbers are the same, bit for bit. */
static int same(const void *one, const void *other, size_t size)
{
    return memcmp(one, other, size) == 0;
}

static void search(const attack_case *it, const stewart_real L[6], const stewart_pose *guess)
{
    stewart_pose pose = *guess;
    int status;
    EXPECT(stewart_forward_kinematics(0, L, &pose) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_forward_kinematics(&it->robot, 0, &pose) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_forward_kinematics(&it->robot, L, 0) == STEWART_BAD_ARGUMENT);
    EXPECT(same(&pose, guess, sizeof pose));
    status = stewart_forward_kinematics(&it->robot, L, &pose);
    EXPECT(attack_known(status, SEARCH_STATUS));
    if (status == STEWART_OK) {
        stewart_motion motion;
        stewart_real found[6], reach = 0;
        int i, j;
        memset(&motion, 0, sizeof motion);
        memcpy(motion.R, pose.R, sizeof pose.R);
        memcpy(motion.t, pose.t, sizeof pose.t);
        EXPECT(attack_finite(pose.R, 9) && attack_finite(pose.t, 3));
        EXPECT(stewart_inverse_kinematics(&it->robot, &motion, found, 0) == STEWART_OK);
        for (i = 0; i < 6; ++i) {
            for (j = 0; j < 3; ++j) {
                /* A component of q is no larger than the three of p together. */
                const double terms[3] = {
                    fabs((double)pose.t[j]), fabs((double)it->robot.leg[i].b[j]),
                    fabs((double)it->robot.leg[i].p[0]) + fabs((double)it->robot.leg[i].p[1])
                        + fabs((double)it->robot.leg[i].p[2]),
                };
                int k;
                for (k = 0; k < 3; ++k) {
                    reach = (double)reach < terms[k] ? (stewart_real)terms[k] : reach;
                }
            }
        }
        for (i = 0; i < 6; ++i) {
            EXPECT(fabs((double)found[i] - (double)L[i]) <= 20.0 * ATTACK_EPSILON * (double)reach);
        }
    } else {
        EXPECT(same(&pose, guess, sizeof pose));
    }
}

void JOINED(attack_, KERNEL, _kinematics)(const attack_case *it)
{
    stewart_real L[6], L_dot[6];
    stewart_pose pose;
    /* A search takes longer than a force: of a batch, two poses, each from the other. */
    const size_t count = it->count < 2 ? it->count : 2;
    size_t i;
    for (i = 0; i < count; ++i) {
        const stewart_motion *from = &it->pose[count - 1 - i];
        const int status = lengths(it, &it->pose[i], L, L_dot);
        memcpy(pose.R, from->R, sizeof pose.R);
        memcpy(pose.t, from->t, sizeof pose.t);
        velocity(it, &pose, status == STEWART_OK ? L_dot : it->F[i]);
        search(it, status == STEWART_OK ? L : it->F[i], &pose);
    }
}
