"""Actuator forces of one pose for controllers, one leg after the other, as written functions.

The functions return early after an error. ``BAKED``: the constants of the robot are numbers in the code.
"""


def size_sum(vector: "array(3)") -> "Real":
    """Computes the sum of the magnitudes of a vector's components (m)."""
    return size(vector[0]) + size(vector[1]) + size(vector[2])


def prepare(robot: "Robot", model: "Model") -> "Integer":
    """Computes the model of a robot, once before the first pose.$any_axis Returns a status, and writes the
    model only if it is STEWART_OK. STEWART_BAD_ARGUMENT: a pointer is null. STEWART_NOT_FINITE: a number that
    the model depends on is not finite or too large$zero_axis."""
    found = blank(Leg)
    added = blank(Lumped)
    sum = blank(Lumped)
    platform = blank(Platform)
    largest = 0.0
    lost = 0.0
    if robot is None or model is None:
        return BAD_ARGUMENT
    clear_lumped(sum)
    for i in range(6):
        prepare_leg(robot, robot.leg[i], found, added)
        add_lumped(sum, added)
        for number in entries(OF_LEG):
            lost = lost + 0.0 * found[number]
        largest = larger(size_sum(found.p), largest)
        largest = larger(size_sum(found.b), largest)
    prepare_platform(robot, sum, platform)
    for number in entries(OF_PLATFORM):
        lost = lost + 0.0 * platform[number]
    lost = lost + 0.0 * largest
    "Zero as long as all numbers are finite."
    if not lost >= 0.0:
        return NOT_FINITE
    "Once more, as a second model would not fit on a small stack."
    for i in range(6):
        prepare_leg(robot, robot.leg[i], model.leg[i], added)
    for number in entries(OF_PLATFORM):
        model[number] = platform[number]
    model.size = largest
    model.per_length = per_length_of(size_of(model), SMALLEST)
    model.least = least_pivots(size_of(model) * model.per_length)
    return OK


def pose_of(model: "Model", at: "Motion", out: "PoseTerms", A: "array(6, 7)") -> None:
    """Computes the terms that are common to all legs, and the platform's part of c: $count operations."""
    SHARED


def leg_closely(model: "Model", leg: "Leg", at: "Motion", q_1: "array(3)", out: "LegSizes") -> None:
    """Computes the inputs for the check of a zero-length leg: its length, the largest component of the
    vectors in its sum, its moment arm, and its column of H."""
    COLUMN
    largest_term()
    out.reach = reach
    SIZES


def short_status(model: "Model", leg: "Leg", at: "Motion", pose: "PoseTerms") -> "Integer":
    """Returns the status of a leg, and marks the pose if the leg is short compared with the vectors in its
    sum."""
    sizes = blank(LegSizes)
    "Any vector will do for q_1: the arm and the column are not read."
    leg_closely(model, leg, at, at.t, sizes)
    if not sizes.L > SHORT_SHARE * sizes.reach:
        pose.close = 1
    return fault_of(sizes.L, 1.0, sizes.reach)


def shift_of(model: "Model", leg: "Leg", at: "Motion", pose: "PoseTerms", A: "array(6, 7)") -> None:
    """Computes platform point 1, and moves the platform's part of c to moments about this point."""
    FIRST
    SHIFT


def leg_of(
    model: "Model",
    leg: "Leg",
    at: "Motion",
    pose: "PoseTerms",
    column: "Integer",
    A: "array(6, 7)",
    known: "Real",
    least: "Real",
) -> "Integer":
    """Computes one leg, $count operations: its column of H, its D, and its part of c. Returns a status."""
    BEFORE
    if not NEAR:
        if not LENGTH > least:
            status = short_status(model, leg, at, pose)
            if status != OK:
                return status
    if HAS_SINE:
        if not SINE > LEAST_SINE:
            if HAS_NEAR and not NEAR:
                return leg_near_singular(model, leg, at, pose, column, A, known)
            else:
                return fault_of(LENGTH, SINE, 0.0)
    AFTER
    MOMENTS
    return OK


def scale_moments(A: "array(6, 7)", per_length: "Real") -> None:
    """Multiplies the moment rows of [H | c] by `per_length`."""
    for i in range(7):
        A[3][i] = A[3][i] * per_length
        A[4][i] = A[4][i] * per_length
        A[5][i] = A[5][i] * per_length


def pose_status(model: "Model", at: "Motion", pose: "PoseTerms") -> "Integer":
    """Returns the status of a pose whose H may be singular to rounding."""
    sizes = blank(LegSizes)
    H = blank(array(6, 6))
    length = blank(array(6))
    reach = blank(array(6))
    arm = blank(array(6, 3))
    for i in range(6):
        leg_closely(model, legs[i] if BAKED else model.leg[i], at, pose.q_1, sizes)
        if not sizes.L <= MAX:
            return NOT_FINITE
        length[i] = sizes.L
        reach[i] = sizes.reach
        for j in range(3):
            arm[i][j] = sizes.arm[j]
        for j in range(6):
            H[j][i] = sizes.column[j]
    return singular_status(H, arm, length, reach, largest_component(pose.q_1, 0.0))


def pose_forces(model: "Model", motion: "Motion", F: "array(6)") -> "Integer":
    """Computes the actuator forces F (N) of one pose, (37), positive when they extend the leg. Reads
    $motion_read of the motion. Returns a status, and writes F only if it is STEWART_OK. Other statuses:
    STEWART_NOT_FINITE, STEWART_ZERO_LENGTH, ${joint_singular}STEWART_SINGULAR, and STEWART_BAD_ARGUMENT if a
    pointer is null."""
    pose = blank(PoseTerms)
    A = blank(array(6, 7))
    x = blank(array(6))
    if HAS_D:
        known = blank(array(6))
    if MISSING:
        return BAD_ARGUMENT
    pose.close = 0
    pose_of(model, motion, pose, A)
    shift_of(model, legs[0] if BAKED else model.leg[0], motion, pose, A)
    "A longer leg is long compared with the vectors in its sum."
    least = SHORTEST + SHORT_SHARE * (size(motion.t[0]) + size(motion.t[1]) + size(motion.t[2]) + SIZE)
    for i in range(6):
        status = leg_of(model, legs[i] if BAKED else model.leg[i], motion, pose, i, A, known[i], least)
        if status != OK:
            return status
    if SCALED == 1:
        if model.per_length != 1.0:
            scale_moments(A, model.per_length)
    if SCALED == 2:
        scale_moments(A, PER_LENGTH)
    pivots = solve(A, x)
    if pose.close != 0 or not size(pivots) > LEAST:
        found = pose_status(model, motion, pose)
        if found != OK:
            return found
    for i in each(6):
        x[i] = known[i] - x[i] if HAS_D else -x[i]
    if not size(x[0]) + size(x[1]) + size(x[2]) + size(x[3]) + size(x[4]) + size(x[5]) <= MAX:
        "The sum may overflow although no force does."
        if not (
            size(x[0]) <= MAX
            and size(x[1]) <= MAX
            and size(x[2]) <= MAX
            and size(x[3]) <= MAX
            and size(x[4]) <= MAX
            and size(x[5]) <= MAX
        ):
            return NOT_FINITE
    for i in each(6):
        F[i] = x[i]
    return OK


def least_pivots(size: "Real") -> "Real":
    """Returns the product of the pivots below which H may be singular, for arms of at most `size`."""
    least = STEWART_LEAST_PIVOTS(size)
    return where(least <= MAX, least, MAX)


def solve(A: "array(6, 7)", x: "array(6)") -> "Real":
    """Solves H x = c for x by elimination with partial pivoting, (36), and returns the product of the pivots.
    The first column has no moments. Rows are exchanged by pointer."""
    row = blank(pointers(6))
    for i in each(6):
        row[i] = A[i]
    elimination()
    return pivots
