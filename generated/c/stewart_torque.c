/* stewart_torque.c: functions that are declared and described in stewart_torque.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_torque.h"

#include "stewart_arithmetic.h"

/* Torques and currents of six motors. */
typedef struct {
    stewart_real torque[6]; /* N m: torques */
    stewart_real current[6]; /* A: currents */
    int status; /* 0, or the code of an error */
} torques;

/* exp(-ratio^2), 0 beyond a ratio of 8: series for 1/256 of the exponent, then squared eight times.
 *
 * The squared number is exp(-y) - 1, so that no digits are lost. */
static stewart_real decay_of(stewart_real ratio)
{
    int turn;
    const stewart_real most = REAL(8);
    const stewart_real kept = (STEWART_FABS(ratio) < most) ? ratio : most;
    const stewart_real y = kept*kept*REAL(0.00390625);
    stewart_real series = REAL(2.08767569878681e-09);
    series = REAL(2.505210838544172e-08) - (y*series);
    series = REAL(2.755731922398589e-07) - (y*series);
    series = REAL(2.7557319223985893e-06) - (y*series);
    series = REAL(2.48015873015873e-05) - (y*series);
    series = REAL(0.0001984126984126984) - (y*series);
    series = REAL(0.001388888888888889) - (y*series);
    series = REAL(0.008333333333333333) - (y*series);
    series = REAL(0.041666666666666664) - (y*series);
    series = REAL(0.16666666666666666) - (y*series);
    series = STEWART_HALF - (y*series);
    stewart_real less = (-y)*(REAL(1) - (y*series));
    for (turn = 0; turn < 8; ++turn) {
        less = less*(REAL(2) + less);
    }
    return (STEWART_FABS(ratio) < most) ? REAL(1) + less : REAL(0);
}

/* Sign of a rate, with an odd cubic polynomial from -within to within. */
static stewart_real sign_of(stewart_real rate, stewart_real within)
{
    const stewart_real above = (rate > REAL(0)) ? REAL(1) : (rate < REAL(0)) ? -REAL(1) : REAL(0);
    const stewart_real divisor = (within > REAL(0)) ? within : REAL(1);
    const stewart_real x = (STEWART_FABS(rate) < within) ? rate/divisor : above;
    return STEWART_HALF*x*(REAL(3) - (x*x));
}

/* Torques and currents of the motors, and a status; without a torque constant a current is 0. */
static torques motor_torques(
    const stewart_drives *drives, const stewart_real F[6], const stewart_real axial[6],
    const stewart_real L_dot[6])
{
    int i;
    torques out = {{0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}, 0};
    int status = STEWART_OK;
    for (i = 0; i < 6; ++i) {
        const stewart_real sign = sign_of(L_dot[i], drives->smoothing[i]);
        const stewart_real load = ((axial[i]*sign) > REAL(0)) ? drives->driving[i] : drives->driven[i];
        stewart_real dry = drives->coulomb[i] + (load*STEWART_FABS(axial[i]));
        if (drives->stribeck[i] > REAL(0)) {
            dry = dry + (drives->stribeck[i]*decay_of(L_dot[i]/drives->stribeck_speed[i]));
        }
        const stewart_real friction = (sign*dry) + (drives->viscous[i]*L_dot[i]);
        out.torque[i] = (F[i] + friction)/drives->turns[i];
        const stewart_real divisor = (drives->torque_constant[i] > REAL(0)) ? drives->torque_constant[i] : REAL(1);
        out.current[i] = (drives->torque_constant[i] > REAL(0)) ? out.torque[i]/divisor : REAL(0);
        status = (STEWART_FABS(out.torque[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
        status = (STEWART_FABS(out.current[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        status = (STEWART_FABS(drives->turns[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        status = (STEWART_FABS(drives->driving[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        status = (STEWART_FABS(drives->driven[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        status = (STEWART_FABS(drives->coulomb[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        status = (STEWART_FABS(drives->viscous[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        status = (STEWART_FABS(drives->stribeck[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        status = (STEWART_FABS(drives->stribeck_speed[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        status = (STEWART_FABS(drives->smoothing[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        status = (STEWART_FABS(drives->torque_constant[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    out.status = status;
    return out;
}

int stewart_motor_torques(
    const stewart_drives *drives, const stewart_real F[6], const stewart_real axial[6],
    const stewart_real L_dot[6], stewart_real torque[6], stewart_real current[6])
{
    int status = STEWART_BAD_ARGUMENT;
    int i;
    if ((drives != NULL) && (F != NULL) && (L_dot != NULL) && (torque != NULL)) {
        torques found;
        found = motor_torques(drives, F, (axial != NULL) ? axial : F, L_dot);
        status = found.status;
        for (i = 0; (i < 6) && (status == STEWART_OK); ++i) {
            torque[i] = found.torque[i];
            if (current != NULL) {
                current[i] = found.current[i];
            }
        }
    }
    return status;
}
