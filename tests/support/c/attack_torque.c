/* Oracle of the torques: from forces, axial forces and rates. See attack.h.
 *
 * The constants of the drives are the robot's numbers, whatever those are.
 */
#include "attack.h"
#include HEADER

static const unsigned STATUS = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE);

static void torques(
    const stewart_drives *drives, const stewart_real F[6], const stewart_real axial[6],
    const stewart_real L_dot[6])
{
    stewart_real torque[6], current[6], alone[6];
    const size_t size = sizeof torque;
    int status;
    memset(torque, ATTACK_UNTOUCHED, size);
    memset(current, ATTACK_UNTOUCHED, size);
    memset(alone, ATTACK_UNTOUCHED, size);
    EXPECT(stewart_motor_torques(0, F, axial, L_dot, torque, current) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_motor_torques(drives, 0, axial, L_dot, torque, current) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_motor_torques(drives, F, axial, 0, torque, current) == STEWART_BAD_ARGUMENT);
    EXPECT(stewart_motor_torques(drives, F, axial, L_dot, 0, current) == STEWART_BAD_ARGUMENT);
    EXPECT(attack_untouched(torque, size) && attack_untouched(current, size));
    status = stewart_motor_torques(drives, F, axial, L_dot, torque, current);
    EXPECT(attack_known(status, STATUS));
    if (status == STEWART_OK) {
        EXPECT(attack_finite(torque, 6) && attack_finite(current, 6));
        EXPECT(stewart_motor_torques(drives, F, axial, L_dot, alone, 0) == STEWART_OK);
        EXPECT(memcmp(alone, torque, size) == 0);
    } else {
        EXPECT(attack_untouched(torque, size) && attack_untouched(current, size));
    }
    memcpy(alone, F, size);
    status = stewart_motor_torques(drives, F, 0, L_dot, torque, current);
    /* Outputs may overlap inputs. */
    EXPECT(status == stewart_motor_torques(drives, alone, alone, L_dot, alone, 0));
    EXPECT(memcmp(alone, status == STEWART_OK ? torque : F, size) == 0);
}

void attack_torque_torque(const attack_case *it)
{
    stewart_drives drives;
    size_t pose;
    memcpy(&drives, &it->robot, sizeof drives);
    for (pose = 0; pose < it->count; ++pose) {
        const stewart_motion *motion = &it->pose[pose];
        const stewart_real L_dot[6] = {motion->v[0],     motion->v[1],     motion->v[2],
                                       motion->omega[0], motion->omega[1], motion->omega[2]};
        torques(&drives, it->F[pose], it->bearing, L_dot);
    }
}
