"""Preparation of a robot's constants, and actuator forces, as written functions."""


def forces(model: "Model", motion: "Motion") -> "Forces":
    """Actuator forces F, N, (37), and a status; F is NaN if the status is not OK."""
    out = Forces()
    sums = Sums()
    A = array(6, 7)
    L = array(6)
    reach = array(6)
    x = array(6)
    status = model.status
    suspect = 0
    if HAS_NEAR:
        near = 0
    shared = shared_terms(model.platform, motion)
    for i in range(6):
        leg = leg_terms(model.leg[i], model.platform, motion, shared)
        reach[i] = reach_of(model.leg[i].b, motion.t, leg.q)
        fault = fault_of(leg.L, leg.k3, reach[i])
        status = where(status == OK, fault, status)
        suspect = where(leg.L > SHORT_SHARE * reach[i], suspect, 1)
        if HAS_NEAR:
            near = where(leg.k3 > NEAR_JOINT_SINGULAR, near, 1)
        sums.leg[i] = leg
    if HAS_NEAR:
        if anywhere(near == 1):
            for i in range(6):
                other = leg_near_terms(model.leg[i], model.platform, motion, shared)
                sums.leg[i] = where(near == 1, other, sums.leg[i])
    for j in range(3):
        sums.q_1[j] = sums.leg[0].q[j]
    tip = shift(sums, shared)
    for j in range(3):
        sums.c[j] = shared.c_force[j]
        sums.c[j + 3] = tip.c_tip[j]
    for i in range(6):
        leg = sums.leg[i]
        turned = MomentTerms()
        if i > 0:
            turned = moments_of(leg, sums)
        L[i] = leg.L
        for j in range(3):
            sums.arm[i][j] = leg.q[j] - sums.q_1[j]
            add_leg(i, j)
    for i in range(3):
        A[i][6] = sums.c[i]
        A[i + 3][6] = sums.c[i + 3] * model.per_length
        for j in range(6):
            A[i][j] = sums.H[i][j]
            A[i + 3][j] = sums.H[i + 3][j] * model.per_length
    small_pivot = solve_legs(A, model.arm_cube, x)
    suspect = where(small_pivot == 0, suspect, 1)
    if anywhere(suspect == 1):
        found = singular_status(sums.H, sums.arm, L, reach, largest_component(sums.q_1, 0.0))
        status = where((status == OK) & (suspect == 1), found, status)
    for i in range(6):
        out.F[i] = sums.leg[i].D - x[i]
        status = where((status != OK) | (size(out.F[i]) <= MAX), status, NOT_FINITE)
    for i in range(6):
        out.F[i] = where(status == OK, out.F[i], NAN)
    out.status = status
    return out


def prepare(robot: "Robot") -> "Model":
    """Constants of a robot, prepared once; the status is not OK if a number of the robot is not finite."""
    model = Model()
    total = Added()
    for i in range(6):
        found = prepare_leg(robot, robot.leg[0].p, robot.leg[i])
        model.leg[i] = found
        total = add_up(total, found)
    model.platform = prepare_platform(robot, robot.leg[0].p, total)
    largest = size_of(model)
    model.per_length = per_length_of(largest, SMALLEST)
    model.arm_cube = cube_of(largest * model.per_length)
    model.status = where(lost_digits(model) == 0.0, OK, NOT_FINITE)
    return model


def add_up(total: "Added", more: "LegConstants") -> "Added":
    """Add one leg to the contributions of the legs to the platform."""
    out = Added()
    for number in numbers(out):
        out[number] = total[number] + more[number]
    return out


def lost_digits(model: "Model") -> "Real":
    """Zero as long as all constants are finite."""
    lost = 0.0
    for leg in range(6):
        for number in numbers(model.leg[leg]):
            lost = lost + 0.0 * model.leg[leg][number]
    for number in numbers(model.platform):
        lost = lost + 0.0 * model.platform[number]
    return lost


def check(out: "Result") -> None:
    """Set the status if a number of a result is not finite, and NaN for all results if it is not OK."""
    lost = 0.0
    for number in numbers(out):
        lost = lost + 0.0 * out[number]
    out.status = where((out.status != OK) | (lost == 0.0), out.status, NOT_FINITE)
    for number in numbers(out):
        out[number] = where(out.status == OK, out[number], NAN)
