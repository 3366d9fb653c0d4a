/* Oracle of the axial forces of legs with rotors. See attack.h. */
#include "attack.h"
#include HEADER

#define AXIAL KERNEL_NAME(_axial_forces)

static const unsigned STATUS = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE)
    | ALLOWED(STEWART_ZERO_LENGTH) | ALLOWED(STEWART_JOINT_SINGULAR);

void JOINED(attack_, KERNEL, _axial)(const attack_case *it)
{
    size_t pose;
    for (pose = 0; pose < it->count; ++pose) {
        const stewart_motion *motion = &it->pose[pose];
        const stewart_real *F = it->F[pose];
        stewart_real axial[6], L_dot[6], alone[6];
        const size_t size = sizeof axial;
        int status;
        memset(axial, ATTACK_UNTOUCHED, size);
        memset(L_dot, ATTACK_UNTOUCHED, size);
        memcpy(alone, F, size);
        EXPECT(AXIAL(0, motion, F, axial, L_dot) == STEWART_BAD_ARGUMENT);
        EXPECT(AXIAL(&it->robot, 0, F, axial, L_dot) == STEWART_BAD_ARGUMENT);
        EXPECT(AXIAL(&it->robot, motion, 0, axial, L_dot) == STEWART_BAD_ARGUMENT);
        EXPECT(AXIAL(&it->robot, motion, F, 0, L_dot) == STEWART_BAD_ARGUMENT);
        EXPECT(attack_untouched(axial, size) && attack_untouched(L_dot, size));
        status = AXIAL(&it->robot, motion, F, axial, L_dot);
        EXPECT(attack_known(status, STATUS));
        if (status == STEWART_OK) {
            EXPECT(attack_finite(axial, 6) && attack_finite(L_dot, 6));
        } else {
            EXPECT(attack_untouched(axial, size) && attack_untouched(L_dot, size));
        }
        EXPECT(status == AXIAL(&it->robot, motion, alone, alone, 0));
        EXPECT(memcmp(alone, status == STEWART_OK ? axial : F, size) == 0);
    }
}
