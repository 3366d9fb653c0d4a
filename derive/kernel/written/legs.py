"""Checks of a leg, its contributions to the equations of the platform, and its motor torque, as functions."""


def fault_of(L: "Real", k3: "Real", reach: "Real") -> "Integer":
    """Returns the status of a leg: not finite, short compared with the vectors in its sum, along k, or OK."""
    if CARRIED:
        status = OK
    reject(L <= MAX, NOT_FINITE)
    reject((L > ROUNDING * reach) & (L > SHORTEST), ZERO_LENGTH)
    reject(k3 > JOINT_SINGULAR_SINE, JOINT_SINGULAR)
    return status if CARRIED else OK


def reach_of(b: "array(3)", t: "array(3)", q: "array(3)") -> "Real":
    """Returns the largest component (m) of the vectors q, t, and b, whose sum is a leg."""
    return largest_component(b, largest_component(t, largest_component(q, 0.0)))


def largest_component(vector: "array(3)", least: "Real") -> "Real":
    """Returns the largest of ``least`` and the magnitudes of a vector's components."""
    most = least
    for j in range(3):
        most = larger(size(vector[j]), most)
    return most


# ---------------------------------------------------------------- a leg in its lane: ``layouts.checks``


def largest_term() -> None:
    """Compute the largest term of the sum that is a leg, and the limit of a short leg."""
    reach = SHORTEST / ROUNDING
    for term in entries(TERMS):
        reach = larger(size(term), reach)


def checked(out) -> None:
    """Store the quantities that determine the status of a leg, and mark a leg that must be checked."""
    largest_term()
    out.reach[l] = reach
    out.L[l] = LENGTH
    if HAS_SINE:
        out.k3[l] = SINE
    mark(0.0, out.bad[l])


def mark(before, after) -> None:
    """Set ``after`` to 1 if a leg is not finite, short, or near its joint singularity, else to ``before``.

    The sine of a leg without finite length is zero or NaN.
    """
    fault = where(LENGTH > LEAST_LENGTH, before, 1.0)
    fault = where(SINE > LEAST_SINE if HAS_SINE else LENGTH <= MAX, fault, 1.0)
    after = fault


# ---------------------------------------------------------------- what a leg adds; places: ``kernel.shared``


def add_leg(i, j) -> None:
    """A component of a leg's column of H and of its part of c."""
    H[j, i] = H_force[j, i]
    H[j + 3, i] = H_moment[j, i]
    part_of_leg(i, j)


def part_of_leg(i, j) -> None:
    """A component of a leg's part of c; with moments about platform point 1 leg 1 has no arm."""
    plus(j, c_force[j, i])
    if HAS_C_MOMENT:
        plus(j + 3, c_moment[j, i])
    if ABOUT_TIP and ALL_LEGS:
        plus(j + 3, arm_c[j, i])
    if ABOUT_TIP and not ALL_LEGS:
        if i > 0:
            plus(j + 3, arm_c[j, i])


def plus(row, term) -> None:
    """Adds a term to a sum."""
    c[row,] = c[row,] + term


def plus_error(row, term) -> None:
    """Adds a term to a sum, and its rounding error to the error of the sum."""
    add(c[row,], c_own[row,], term, 0.0)


# ---------------------------------------------------------------- torques of the motors: ``kernel.torque``


def decay_of(ratio: "Real") -> "Real":
    """exp(-ratio^2), 0 beyond a ratio of 8: series for 1/256 of the exponent, then squared eight times.

    The squared number is exp(-y) - 1, so that no digits are lost.
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
    """Sign of a rate, with an odd cubic polynomial from -within to within."""
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
    """Actuator forces minus the forces that accelerate the rotors, rates of the legs, and a status."""
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
