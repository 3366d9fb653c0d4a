"""Closed form and regressor with the legs of a pose in vector lanes, as written functions."""


def pose_terms(
    model: "alone(Model)",
    at: "alone(MotionLanes)",
    lanes: "Integer",
    out: "alone(Pose)",
    summed: "alone(Pointer(Real))",
) -> None:
    """Computes the terms of the platform, for one pose or eight."""
    OUTSIDE
    for l in range(lanes):
        BLOCK


def leg_terms(
    model: "alone(Model)", motion: "alone(Motion)", pose: "alone(Pose)", out: "alone(Legs)"
) -> None:
    """Computes the legs of a pose in lanes."""
    OUTSIDE
    for l in range(LANES):
        BLOCK
        checked(out.checked)


def leg_of_poses(
    model: "alone(Model)", leg: "Integer", at: "alone(MotionLanes)", pose: "alone(Pose)", out: "alone(Legs)"
) -> None:
    """Computes one leg of eight poses in lanes."""
    for l in range(LANES):
        BLOCK
        checked(out.checked)


def legs_status(checked: "Checked") -> "Integer":
    """Returns the status of the first leg that is not OK, or OK."""
    for i in range(6):
        if checked.bad[i] > 0.0:
            return fault_of(checked.L[i], checked.k3[i], checked.reach[i])
    return OK


def is_near(checked: "Checked") -> "Integer":
    """Returns 1 if a leg is so near its joint singularity that the shorter formulas lose digits."""
    found = 0
    for i in range(6):
        found = where(checked.k3[i] > LEANING, found, 1)
    return found


def sums(model: "Model", motion: "Motion", legs: "Legs", summed: "array(COUNT)") -> None:
    """Computes the sums over platform and legs; ``status`` is the status of the legs."""
    at = blank(MotionLanes)
    pose = blank(Pose)
    for number in entries(MOVED):
        at[number, 0] = motion[number]
    pose_terms(model, at, 1, pose, summed)
    for l in range(6, 8):
        for number in entries(GIVEN):
            legs[number, l] = legs[number, 5]
    leg_terms(model, motion, pose, legs)
    if HAS_NEAR:
        if is_near(legs.checked) != 0:
            near_terms(model, motion, pose, legs)
    legs.status = legs_status(legs.checked)
    if legs.status == OK:
        add_legs(legs.sum, COUNT, summed)


def forces(model: "Model", motion: "Motion", out: "Forces") -> None:
    """Actuator forces."""
    for i in range(6):
        out.F[i] = 0.0
    out.status = kernel_forces(model, motion, out.F)


# ---------------------------------------------------------------- regressor


def columns_of_legs(robot: "alone(Robot)", at: "alone(Motion)", out: "alone(Columns)") -> None:
    """Computes the columns of the legs in lanes, $count operations each. Marks a leg whose status is not OK
    or whose moments are not finite; moments are computed from forces, so forces need no check."""
    for i in range(LANES):
        for number in entries(OF_LEG):
            out[number, i] = robot.leg[where(i < 6, i, 5)][number]
    OUTSIDE
    for l in range(LANES):
        BLOCK
        checked(out.checked)
        for number in entries(MOMENTS):
            fault = where(size(number) <= MAX, fault, 1.0)
        out.lost[l] = fault


def columns_of_platform(robot: "alone(Robot)", at: "alone(Motion)", out: "alone(Columns)") -> None:
    """Computes the columns of the platform: $count operations."""
    POSE


def columns_status(found: "Columns") -> "Integer":
    """Returns the status of the legs, or NOT_FINITE if a number is not finite."""
    status = legs_status(found.checked)
    lost = 0.0
    for i in range(6):
        lost = larger(found.lost[i], lost)
        for j in range(OF_PLATFORM):
            lost = where(size(found.of_platform[i][j]) <= MAX, lost, 1.0)
    return where(status == OK and lost > 0.0, NOT_FINITE, status)


def regressor(
    robot: "Robot", motion: "Motion", columns: "Pointer(Integer)", width: "Count", Y: "Pointer(Real)"
) -> "Integer":
    """Computes the regressor Y[6][width] of one pose. `columns` contains the indices of `width` columns, from
    0. For all $count columns, Y[6][$count], `columns` is null and `width` 0. Returns a status, and writes Y
    only if it is STEWART_OK. Other statuses: STEWART_NOT_FINITE, STEWART_ZERO_LENGTH, STEWART_JOINT_SINGULAR,
    and STEWART_BAD_ARGUMENT if another pointer is null, an index is out of range, or `columns` is null and
    `width` is not 0."""
    found = blank(Columns)
    if MISSING:
        return BAD_ARGUMENT
    for i in range(width):
        if columns[i] < 0 or columns[i] >= OF_ALL:
            return BAD_ARGUMENT
    columns_of_legs(robot, motion, found)
    columns_of_platform(robot, motion, found)
    status = columns_status(found)
    if status == OK:
        if columns is None:
            all_columns(found, Y)
        else:
            chosen_columns(found, columns, width, Y)
    return status


def all_columns(found: "Columns", Y: "Pointer(Real)") -> None:
    """Copies all columns: leg after leg, then the platform."""
    for i in range(6):
        for leg in range(6):
            for j in range(OF_ONE_LEG):
                Y[i * OF_ALL + leg * OF_ONE_LEG + j] = found.of_legs[i][j][leg]
        for j in range(OF_PLATFORM):
            Y[i * OF_ALL + OF_LEGS + j] = found.of_platform[i][j]


def chosen_columns(found: "Columns", columns: "Pointer(Integer)", width: "Count", Y: "Pointer(Real)") -> None:
    """Copies the requested columns."""
    for each in range(width):
        column = columns[each]
        leg = column / OF_ONE_LEG
        for i in range(6):
            if column < OF_LEGS:
                Y[i * width + each] = found.of_legs[i][column - leg * OF_ONE_LEG][leg]
            else:
                Y[i * width + each] = found.of_platform[i][column - OF_LEGS]


def regressor_batch(
    robot: "Robot",
    count: "Count",
    motions: "Motions",
    columns: "Pointer(Integer)",
    width: "Count",
    Y: "Pointer(Real)",
    status: "Pointer(Integer)",
) -> "Integer":
    """Computes the regressors Y[count][6][width] of `count` poses. `status` receives the code of each pose
    and may be null. F_ext and M_ext of the motions are not read. Returns the first code other than
    STEWART_OK, or STEWART_OK. A pose with another code keeps its old numbers in Y and does not affect the
    other poses.
    STEWART_BAD_ARGUMENT: as above, or R, t, omega, v, alpha, or a of the motions is null."""
    one = blank(Motion)
    each = 6 * where(columns is not None, width, OF_ALL)
    if MISSING:
        return BAD_ARGUMENT
    batch()


def one_regressor() -> None:
    """Compute one pose of the batch."""
    load_pose(motions, pose, one)
    code = regressor(robot, one, columns, width, Y[pose * each :])
