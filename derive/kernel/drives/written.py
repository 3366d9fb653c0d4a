"""Torques of the motors, in the part of Python that ``read`` reads."""


def decay_of(ratio: "Real") -> "Real":
    """exp(-ratio^2), 0 beyond a ratio of 8: of 1/256 of the exponent by its series, then squared eight times.

    It is exp(-y) - 1 that is kept, of which squaring loses no digits.
    """
    most = 8.0
    kept = where(size(ratio) < most, ratio, most)
    y = kept * kept * 0.00390625
    # Factors of the series: 1/11! to 1/2!; the last is 1/12!.
    series = LAST
    for factor in entries(FACTORS):
        series = factor - y * series
    less = -y * (1.0 - y * series)
    for turn in range(8):
        less = less * (2.0 + less)
    return where(size(ratio) < most, 1.0 + less, 0.0)


def sign_of(rate: "Real", within: "Real") -> "Real":
    """Sign of a rate, an odd cubic from -within to within."""
    above = where(rate > 0.0, 1.0, where(rate < 0.0, -1.0, 0.0))
    divisor = where(within > 0.0, within, 1.0)
    x = where(size(rate) < within, rate / divisor, above)
    return 0.5 * x * (3.0 - x * x)


def motor_torques(drives: "Drives", F: "array(6)", axial: "array(6)", L_dot: "array(6)") -> "Torques":
    """Torques and currents of the motors, and a status; without a torque constant a current is 0."""
    out = Torques()
    status = OK
    for i in range(6):
        sign = sign_of(L_dot[i], drives.smoothing[i])
        load = where(axial[i] * sign > 0.0, drives.driving[i], drives.driven[i])
        dry = drives.coulomb[i] + load * size(axial[i])
        if anywhere(drives.stribeck[i] > 0.0):
            dry = dry + drives.stribeck[i] * decay_of(L_dot[i] / drives.stribeck_speed[i])
        friction = sign * dry + drives.viscous[i] * L_dot[i]
        out.torque[i] = (F[i] + friction) / drives.turns[i]
        divisor = where(drives.torque_constant[i] > 0.0, drives.torque_constant[i], 1.0)
        out.current[i] = where(drives.torque_constant[i] > 0.0, out.torque[i] / divisor, 0.0)
        status = where(size(out.torque[i]) <= MAX, status, NOT_FINITE)
        status = where(size(out.current[i]) <= MAX, status, NOT_FINITE)
    for number in numbers(drives):
        status = where(size(drives[number]) <= MAX, status, NOT_FINITE)
    out.status = status
    return out


def axial_forces(robot: "Robot", motion: "Motion", F: "array(6)") -> "AxialLoads":
    """Actuator forces less what turns the rotors, rates of the legs, and a status."""
    out = AxialLoads()
    status = OK
    for i in range(6):
        leg = axial_terms(robot.leg[i], motion)
        fault = fault_of(leg.L, leg.k3, reach_of(robot.leg[i].b, motion.t, leg.q))
        out.axial[i] = F[i] - leg.F_rotor
        out.L_dot[i] = leg.L_dot
        fault = where((fault != OK) | (size(out.axial[i]) <= MAX), fault, NOT_FINITE)
        fault = where((fault != OK) | (size(out.L_dot[i]) <= MAX), fault, NOT_FINITE)
        status = where(status == OK, fault, status)
    out.status = status
    return out
