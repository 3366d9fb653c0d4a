"""Preparation of a robot's constants, and the actuator forces."""


def find_legs(model: "Model", motion: "Motion", shared: "SharedTerms", sums: "Sums") -> None:
    """The legs, all by the block that suits a pose in which one is near its joint singularity, if one is."""
    near = 0
    for i in range(6):
        sums.leg[i] = leg_terms(model.leg[i], model.platform, motion, shared)
        near = where(sums.leg[i].k3 > NEAR_JOINT_SINGULAR, near, 1)
    if anywhere(near == 1):
        for i in range(6):
            other = leg_near_terms(model.leg[i], model.platform, motion, shared)
            sums.leg[i] = where(near == 1, other, sums.leg[i])


def find_legs_of_one_form(model: "Model", motion: "Motion", shared: "SharedTerms", sums: "Sums") -> None:
    """The legs."""
    for i in range(6):
        sums.leg[i] = leg_terms(model.leg[i], model.platform, motion, shared)


def add_leg(leg: "LegTerms", i: "Integer", shared: "SharedTerms", sums: "Sums") -> None:
    """Adds a leg's column of H and its part of c, moments about platform point 1."""
    if i == 0:
        for j in range(3):
            sums.q_1[j] = leg.q[j]
        tip = shift(sums, shared)
        for j in range(3):
            sums.c_force[j] = shared.c_force[j] + leg.c_force[j]
            sums.c_moment[j] = tip.c_tip[j] + leg.c_moment[j]
    if i != 0:
        turned = moments_of(leg, sums)
        for j in range(3):
            sums.c_force[j] = sums.c_force[j] + leg.c_force[j]
            sums.c_moment[j] = sums.c_moment[j] + leg.c_moment[j] + turned.arm_c[j]
            sums.H[j + 3][i] = turned.H_moment[j]
            sums.arm[i][j] = leg.q[j] - sums.q_1[j]
    for j in range(3):
        sums.H[j][i] = leg.H_force[j]


def forces(model: "Model", motion: "Motion") -> "Forces":
    """Actuator forces F, N, (37), and a status; where the status is not OK, F is NaN."""
    out = Forces()
    sums = Sums()
    A = array(6, 7)
    D = array(6)
    L = array(6)
    reach = array(6)
    x = array(6)
    status = model.status
    suspect = 0
    shared = shared_terms(model.platform, motion)
    find_legs(model, motion, shared, sums)
    for i in range(6):
        leg = sums.leg[i]
        reach[i] = reach_of(model.leg[i].b, motion.t, leg.q)
        fault = fault_of(leg.L, leg.k3, reach[i])
        status = where(status == OK, fault, status)
        suspect = where(leg.L > SHORT_SHARE * reach[i], suspect, 1)
        L[i] = leg.L
        D[i] = leg.D
        add_leg(leg, i, shared, sums)
    for i in range(3):
        A[i][6] = sums.c_force[i]
        A[i + 3][6] = sums.c_moment[i] * model.per_length
        for j in range(6):
            A[i][j] = sums.H[i][j]
            A[i + 3][j] = sums.H[i + 3][j] * model.per_length
    small_pivot = eliminate(A, x)
    suspect = where(small_pivot == 0, suspect, 1)
    if anywhere(suspect == 1):
        found = singular_status(sums.H, sums.arm, L, reach)
        status = where((status == OK) & (suspect == 1), found, status)
    for i in range(6):
        out.F[i] = D[i] - x[i]
        status = where((status != OK) | (size(out.F[i]) <= MAX), status, NOT_FINITE)
    for i in range(6):
        out.F[i] = where(status == OK, out.F[i], NAN)
    out.status = status
    return out


def prepare(robot: "Robot") -> "Model":
    """A robot's constants, prepared once; every number of the robot must be finite, else status says so."""
    model = Model()
    total = Added()
    for i in range(6):
        found = prepare_leg(robot, robot.leg[0].p, robot.leg[i])
        model.leg[i] = found
        total = add_up(total, found)
    model.platform = prepare_platform(robot, robot.leg[0].p, total)
    extent = 0.0
    for i in range(6):
        for j in range(3):
            extent = larger(size(model.leg[i].p[j] - model.leg[0].p[j]), extent)
    model.per_length = per_length_of(extent)
    model.status = where(lost_digits(model) == 0.0, OK, NOT_FINITE)
    return model


def per_length_of(extent: "Real") -> "Real":
    """By what moments are multiplied in the solve, 1/m: 1 for arms of about a metre, else one over the least
    power of two, from 2^-100 to 2^100, that is no smaller than the longest of them."""
    unit = 1.0
    for turn in range(100):
        unit = where(unit < extent, 2.0 * unit, unit)
    for turn in range(100):
        unit = where((extent > 0.0) & (0.5 * unit >= extent), 0.5 * unit, unit)
    return where((extent >= SMALLEST) & (extent <= LARGEST), 1.0, 1.0 / unit)
