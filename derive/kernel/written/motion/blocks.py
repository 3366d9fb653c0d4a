"""Closed form of eight poses side by side, and batches of such blocks, as written functions.

The blocks are the same as for one pose, whose lanes are legs; here lanes are poses. The functions that
compute a result from the sums read the numbers of each pose from its lane.
"""


def load_motions(motions: "Motions", first: "Count", count: "Count", at: "MotionLanes") -> None:
    """Motions of eight poses, component by component."""
    LOADS


def load_forces(F: "Pointer(Real)", first: "Count", count: "Count", acting: "array(6, LANES)") -> None:
    """Actuator forces of eight poses, leg by leg; lanes after the last pose repeat it."""
    for l in range(LANES):
        pose = where(first + l < count, first + l, count - 1)
        for i in range(6):
            acting[i][l] = F[pose * 6 + i]


def add_two(
    one: "alone(array(1, LANES))",
    other: "alone(array(1, LANES))",
    count: "Integer",
    more: "Integer",
    sum: "alone(Pointer(Real))",
) -> None:
    """Adds two legs to others, in the order in which ``add_legs`` does."""
    if more > 0:
        for i in range(count):
            for l in range(LANES):
                sum[LANES * i + l] = sum[LANES * i + l] + (one[i][l] + other[i][l])
    else:
        for i in range(count):
            for l in range(LANES):
                sum[LANES * i + l] = one[i][l] + other[i][l]


def in_rows(number: "alone(Pointer(Real))", count: "Integer", row: "alone(Pointer(Real))") -> None:
    """The numbers of each pose side by side."""
    for i in range(count):
        for l in each(LANES):
            row[l * count + i] = number[LANES * i + l]


def leg_of_block(
    model: "Model",
    leg: "Integer",
    at: "MotionLanes",
    acting: "alone(array(6, LANES))",
    pose: "Pose",
    legs: "alone(Legs)",
    out: "alone(Block)",
) -> None:
    """One leg of eight poses; ``bad`` is 1 if the function for one pose must compute the pose."""
    if HAS_F:
        for l in range(LANES):
            legs.F[l] = acting[leg][l]
    leg_of_poses(model, leg, at, pose, legs)
    for l in range(LANES):
        KEPT_OF_LEG
        fault = larger(legs.checked.bad[l], out.bad[l])
        if HAS_NEAR:
            fault = where(legs.checked.k3[l] > LEANING, fault, 1.0)
        out.bad[l] = fault


def sums_of_block(model: "Model", at: "MotionLanes", acting: "array(6, LANES)", out: "Block") -> None:
    """Sums over platform and legs of eight poses."""
    pose = blank(Pose)
    even = blank(Legs)
    odd = blank(Legs)
    own = blank(array(OF_LANES))
    pose_terms(model, at, LANES, pose, own)
    for l in range(LANES):
        out.bad[l] = 0.0
    for i in range(3):
        leg_of_block(model, 2 * i, at, acting, pose, even, out)
        leg_of_block(model, 2 * i + 1, at, acting, pose, odd, out)
        add_two(even.sum, odd.sum, COUNT, i, out.number[FIRST * LANES :])
    for i in range(OF_LANES):
        out.number[FIRST * LANES + i] = own[i] + out.number[FIRST * LANES + i]


def batch_of_blocks(
    model: "Model",
    count: "Count",
    motions: "Motions",
    F: "Pointer(Real)",
    out: "ResultArrays",
    status: "Pointer(Integer)",
) -> "Integer":
    """Computes the poses in blocks of eight; poses that must be checked are computed one by one."""
    at = blank(MotionLanes)
    block = blank(Block)
    row = blank(array(ROWS))
    one = blank(Motion)
    if HAS_F:
        acting = blank(array(6, LANES))
    if FORCES_FIRST:
        F = array(48)
    if MISSING:
        return BAD_ARGUMENT
    found = blank(Found)
    result = OK
    for first in range(0, count, LANES):
        load_motions(motions, first, count, at)
        if FORCES_FIRST:
            part = blank(Motions)
            size_of_block = where(count - first < LANES, count - first, LANES)
            PARTS
            held = kernel_forces_batch(model, size_of_block, part, F, None)
            load_forces(F, 0, size_of_block, acting)
        elif HAS_F:
            load_forces(F, first, count, acting)
        sums_of_block(model, at, acting, block)
        finish_block()
        if FORCES_FIRST:
            one_by_one()
        elif count - first >= LANES and any_of(block.bad) == 0:
            IN_PLACE
            if status is not None:
                for l in range(LANES):
                    status[first + l] = OK
        else:
            one_by_one()
    return result


def any_of(bad: "array(LANES)") -> "Integer":
    """Returns 1 if a lane is marked, else 0."""
    found = 0.0
    for l in range(LANES):
        found = larger(bad[l], found)
    return where(found > 0.0, 1, 0)


def one_by_one() -> None:
    """Computes the marked poses of a block one by one."""
    in_rows(block.number, WIDTH, row)
    for l in range(LANES):
        if not first + l < count:
            break
        pose = first + l
        code = where(block.bad[l] > 0.0, MASS_MATRIX_INDEFINITE, OK)
        if FORCES_FIRST:
            if code == OK:
                code = slopes(model.per_length, row[l * WIDTH :], F[l * 6 :], found)
        if code == OK:
            COPIED
        else:
            load_pose(motions, pose, one)
            if FORCES_FIRST:  # noqa: SIM108
                code = of_pose(model, one, found)
            else:
                code = of_pose(model, one, F[pose * 6 :], found)
            if code == OK:
                COPIED_ALONE
        note_status()


# ---------------------------------------------------------------- the results of each output


def finished_in_lanes() -> None:
    """Marks poses with a number that is not finite."""
    none = blank(array(LANES))
    not_finite(block.number, WIDTH, none)
    for l in range(LANES):
        block.bad[l] = where(none[l] == 0.0, block.bad[l], 1.0)


def finished_equations() -> None:
    """Matrices of eight poses."""
    matrices(at.v[0], at.omega[0], LANES, block.number)
    finished_in_lanes()


def finished_accelerations() -> None:
    """Accelerations of eight poses."""
    pivot = blank(array(48))
    solution = blank(array(48))
    solve_inertia(block.number, LANES, solution, pivot)
    for l in range(LANES):
        for k in each(6):
            block.bad[l] = where(pivot[LANES * k + l] > KEPT * inertia[k, k], block.bad[l], 1.0)
    for i in range(48):
        block.number[i] = solution[i]
    finished_in_lanes()


def finished_forces() -> None:
    """Without forces there are no derivatives."""
    if held != OK:
        for l in range(LANES):
            block.bad[l] = 1.0


def stored_pivot(k) -> None:
    """Store the pivot of one pose or eight."""
    pivot[lanes * k + l] = a[k, k]
