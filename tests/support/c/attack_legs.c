/* Oracle of the legs of many poses: each pose alone is what it is in the batch. See attack.h. */
#include "attack.h"
#include HEADER

static const unsigned LEGS_STATUS
    = ALLOWED(STEWART_OK) | ALLOWED(STEWART_NOT_FINITE) | ALLOWED(STEWART_ZERO_LENGTH);

void JOINED(attack_, KERNEL, _legs)(const attack_case *it)
{
    stewart_real L[2][6], L_dot[2][6], L_ddot[2][6], s[2][18], S[2][18], alone[6];
    const stewart_legs_arrays all = {L[0], L_dot[0], L_ddot[0], s[0], S[0]};
    const size_t count = it->count < 2 ? it->count : 2;
    int status[2];
    size_t i;
    memset(L, ATTACK_UNTOUCHED, sizeof L);
    memset(s, ATTACK_UNTOUCHED, sizeof s);
    for (i = 0; i < count; ++i) {
        const stewart_motion *at = &it->pose[i];
        const stewart_motions motions = {at->R, at->t, at->omega, at->v, at->alpha, at->a, 0, 0};
        const stewart_legs_arrays here = {L[i], L_dot[i], L_ddot[i], s[i], S[i]};
        stewart_legs_arrays lengths = {0, 0, 0, 0, 0};
        lengths.L = alone;
        EXPECT(stewart_legs_batch(0, 1, &motions, &all, status) == STEWART_BAD_ARGUMENT);
        EXPECT(stewart_legs_batch(&it->robot, 1, 0, &all, status) == STEWART_BAD_ARGUMENT);
        EXPECT(stewart_legs_batch(&it->robot, 1, &motions, 0, status) == STEWART_BAD_ARGUMENT);
        EXPECT(attack_untouched(L[i], sizeof L[i]));
        EXPECT(stewart_legs_batch(&it->robot, 1, &motions, &here, &status[i]) == status[i]);
        EXPECT(attack_known(status[i], LEGS_STATUS));
        if (status[i] == STEWART_OK) {
            EXPECT(attack_finite(L[i], 6) && attack_finite(L_dot[i], 6) && attack_finite(L_ddot[i], 6));
            EXPECT(attack_finite(s[i], 18) && attack_finite(S[i], 18));
            EXPECT(stewart_legs_batch(&it->robot, 1, &motions, &lengths, 0) == STEWART_OK);
            EXPECT(memcmp(alone, L[i], sizeof alone) == 0);
        } else {
            EXPECT(attack_untouched(L[i], sizeof L[i]) && attack_untouched(s[i], sizeof s[i]));
        }
    }
}
