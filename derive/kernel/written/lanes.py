"""Actuator forces with legs or poses side by side in vector lanes, as written functions.

One pose has its legs in lanes; a block has ``POSES`` poses in lanes. Names in capitals are placeholders for
blocks or properties of a kernel. ``BAKED``: constants are numbers. ``ABOUT_TIP``: moments are about platform
point 1. ``HAS_D``: legs have a force D.
"""


def prepare(robot: "Robot", model: "Model") -> "Integer":
    """Computes the model of a robot, once before the first pose.$any_axis Returns a status, and writes the
    model only if it is STEWART_OK. STEWART_BAD_ARGUMENT: a pointer is null. STEWART_NOT_FINITE: a number that
    the model depends on is not finite or too large$zero_axis. The function of one pose is fastest if the
    address of the model is a multiple of 64 bytes."""
    made = blank(Model)
    added = blank(Lumped)
    sum = blank(Lumped)
    if robot is None or model is None:
        return BAD_ARGUMENT
    clear_lumped(sum)
    for i in range(LANES):
        prepare_leg(robot, robot.leg[where(i < 6, i, 5)], i, made, added)
        if i < 6:
            add_lumped(sum, added)
    prepare_platform(robot, sum, made)
    far = 0.0
    for j in range(3):
        for i in range(6):
            far = larger(size(made.b[j][i]), far)
    made.base_reach = far
    hand_over()


def shared_of_pose(model: "Model", at: "Motion", out: "SharedTerms") -> None:
    """Computes the terms of a pose that are common to all legs: $count operations."""
    SHARED


def legs_of_pose(
    model: "alone(Model)", at: "alone(Motion)", shared: "alone(SharedTerms)", out: "alone(LegLanes)"
) -> None:
    """$says: $count operations each."""
    OUTSIDE
    for l in range(LANES):
        BLOCK
        checked(out)


def exchange_rows(upper: "alone(array(LANES))", lower: "alone(array(LANES))") -> None:
    """Exchanges two rows."""
    for j in range(LANES):
        moved = upper[j]
        upper[j] = lower[j]
        lower[j] = moved


def subtract_row(to: "alone(array(LANES))", factor: "Real", row: "alone(array(LANES))") -> None:
    """Subtracts a multiple of a row from another."""
    for j in range(LANES):
        to[j] = to[j] - factor * row[j]


def blocks_of_pose(A: "array(6, LANES)", wrench: "array(6)", arm_cube: "Real", x: "array(6)") -> "Real":
    """Solves H x = c for x in two blocks of three legs. The first six lanes of the rows A are H. Returns 1 if
    the blocks are too inaccurate and pivots are required, else 0."""
    two_blocks()
    return weak


def solve_pose(A: "array(6, LANES)", wrench: "array(6)", arm_cube: "Real", x: "array(6)") -> "Integer":
    """Solves H x = c for x, (36), in two blocks, or by pivots if the blocks are too inaccurate. Returns 1 if
    a pivot is small, else 0."""
    suspect = 0
    wanted = blocks_of_pose(A, wrench, arm_cube, x)
    if wanted > 0.0:
        suspect = pivots_of_pose(A, wrench, x)
    return suspect


def pivots_of_pose(H: "array(6, LANES)", wrench: "array(6)", x: "array(6)") -> "Integer":
    """Solves the augmented rows [H | c | 0] for x by elimination with partial pivoting, (36). Returns 1 if a
    pivot is small, else 0. Whole rows are updated, so a row is one vector. The next column is computed before
    its rows are stored. With moments about platform point 1 the first column has no moments."""
    A = blank(array(6, LANES))
    for i in range(6):
        for l in range(LANES):
            A[i][l] = H[i][l]
        A[i][6] = wrench[i]
        A[i][7] = 0.0
    for i in each(FIRST):
        a[i,] = A[i][0]
    elimination()
    return where(
        size(a[0,]) > SUSPECT
        and size(a[1,]) > SUSPECT
        and size(a[2,]) > SUSPECT
        and size(a[3,]) > SUSPECT
        and size(a[4,]) > SUSPECT
        and size(a[5,]) > SUSPECT,
        0,
        1,
    )


def forces(model: "Model", motion: "Motion", F: "array(6)") -> "Integer":
    """Computes the actuator forces F (N) of one pose, (37), positive when they extend the leg. Reads
    $motion_read of the motion. Returns a status, and writes F only if it is STEWART_OK. Other statuses:
    STEWART_NOT_FINITE, STEWART_ZERO_LENGTH, ${joint_singular}STEWART_SINGULAR, and STEWART_BAD_ARGUMENT if a
    pointer is null."""
    if BAKED:
        model = address(numbers)
    shared = blank(SharedTerms)
    legs = blank(LegLanes)
    wrench = blank(array(6))
    x = blank(array(6))
    found = blank(array(6))
    close = 0
    if HAS_NEAR:
        near_singular = 0
    if MISSING:
        return BAD_ARGUMENT
    shared_of_pose(model, motion, shared)
    legs_of_pose(model, motion, shared, legs)
    for i in range(6):
        if legs.bad[i] > 0.0:
            status = fault_of(legs.L[i], legs.k3[i] if HAS_SINE else 1.0, legs.reach[i])
            if status != OK:
                return status
            close = where(legs.L[i] > SHORT_SHARE * legs.reach[i], close, 1)
            if HAS_NEAR:
                near_singular = where(legs.k3[i] > NEAR_JOINT_SINGULAR, near_singular, 1)
    if HAS_NEAR:
        if near_singular != 0:
            legs_near_singular(model, motion, shared, legs)
    if ABOUT_TIP:
        shift_of_pose(legs.q, shared.c_force, shared.c_moment, shared.c_tip)
        moments_of_pose(legs.q, legs.A, LEGS_C, ARM_C)
    for j in range(3):
        force = shared.c_force[j]
        turn = shared.c_tip[j] if ABOUT_TIP else shared.c_moment[j]
        if HAS_C:
            for i in columns(6):
                part_of_leg(i, j)
        wrench[j] = force
        wrench[j + 3] = turn
    if SCALED == 1:
        if model.per_length != 1.0:
            scale_pose(legs.A, wrench, model.per_length)
    if SCALED == 2:
        scale_pose(legs.A, wrench, PER_LENGTH)
    suspect = solve_pose(legs.A, wrench, ARM_CUBE, x)
    if close != 0 or suspect != 0:
        status = rows_status(legs.A, legs.q, legs.L, legs.reach, UNIT_OF_MOMENTS)
        if status != OK:
            return status
    for i in range(6):
        found[i] = legs.D[i] - x[i] if HAS_D else -x[i]
        if not size(found[i]) <= MAX:
            return NOT_FINITE
    for i in range(6):
        F[i] = found[i]
    return OK


def shared_of_block(
    model: "alone(Model)", at: "alone(MotionLanes)", out: "alone(SharedLanes)", c: "alone(array(6, POSES))"
) -> None:
    """Computes the terms that are common to all legs, and the platform's part of c, of a block of poses."""
    OUTSIDE
    for l in range(POSES):
        INSIDE
        far = larger(BASE_REACH, SHORTEST / ROUNDING)
        for j in each(3):
            far = larger(size(at.t[j][l]), far)
        out.least_L[l] = 2.25 * SHORT_SHARE * far


def roots_of_leg(
    model: "alone(Model)", leg: "Integer", at: "alone(MotionLanes)", out: "alone(LegRoots)"
) -> None:
    """Computes a leg of the poses of a block up to its square roots, $count operations each. The roots of the
    next leg are computed before the other terms of a leg, so that no leg waits for its roots."""
    for l in range(POSES):
        BLOCK


def leg_of_block(
    model: "alone(Model)",
    leg: "Integer",
    at: "alone(MotionLanes)",
    shared: "alone(SharedLanes)",
    roots: "alone(LegRoots)",
    column: "alone(array(6, POSES))",
    own: "alone(LegBlock)",
    c: "alone(array(6, POSES))",
    known: "alone(array(POSES))",
    bad: "alone(array(POSES))",
) -> None:
    """$says, $count operations each: its column of H, its D, and its part of c. A leg is q + t - b, so a leg
    that is short compared with q is also short compared with t or b."""
    for l in range(POSES):
        BLOCK
        mark(bad[l], bad[l])


def blocks_of_lanes(
    column: "alone(array(7, 6, POSES))",
    D: "alone(array(6, POSES))",
    arm_cube: "Real",
    F: "alone(array(6, POSES))",
    bad: "alone(array(POSES))",
    wanted: "alone(array(POSES))",
) -> None:
    """Solves H x = c for x in two blocks of three legs, (36), and computes F = D - x, (37), for all poses of
    a block. The loop over lanes has no branches. Sets `bad` if a force is not finite, and `wanted` if the
    blocks are too inaccurate and pivots are required."""
    for l in range(POSES):
        for i in each(6):
            for j in each(1 if i >= FIRST else 0, 7):
                a[i, j] = column[j][i][l]
        fault = bad[l]
        two_blocks()
        for i in each(6):
            force[i,] = STEWART_FORCE(D[i][l], x[i,])
            fault = where(size(force[i,]) <= MAX, fault, 1.0)
            F[i][l] = force[i,]
        bad[l] = where(weak > 0.0, bad[l], fault)
        wanted[l] = weak


def pivots_of_lanes(
    column: "alone(array(7, 6, POSES))",
    D: "alone(array(6, POSES))",
    F: "alone(array(6, POSES))",
    bad: "alone(array(POSES))",
    wanted: "alone(array(POSES))",
) -> None:
    """Solves H x = c by elimination with partial pivoting for the poses with `wanted`, and computes F = D -
    x. The row with the largest entry moves to its place by conditional exchanges in each lane. Sets `bad` if
    a pivot is small or a force is not finite."""
    for l in range(POSES):
        for i in each(6):
            for j in each(1 if i >= FIRST else 0, 7):
                a[i, j] = column[j][i][l]
        fault = bad[l]
        elimination()
        for i in each(6):
            force[i,] = STEWART_FORCE(D[i][l], x[i,])
            fault = where(size(force[i,]) <= MAX, fault, 1.0)
            F[i][l] = where(wanted[l] > 0.0, force[i,], F[i][l])
        bad[l] = where(wanted[l] > 0.0, fault, bad[l])


def solve_block(
    column: "array(7, 6, POSES)",
    D: "array(6, POSES)",
    arm_cube: "Real",
    F: "array(6, POSES)",
    bad: "array(POSES)",
) -> None:
    """Computes the forces of a block of poses from H, c, and D, (36) and (37), in two blocks of legs or by
    pivots."""
    wanted = blank(array(POSES))
    most = 0.0
    blocks_of_lanes(column, D, arm_cube, F, bad, wanted)
    for l in range(POSES):
        most = larger(wanted[l], most)
    if most > 0.0:
        pivots_of_lanes(column, D, F, bad, wanted)


def load_block(
    motions: "Motions", stride: "Count", first: "Count", count: "Count", at: "MotionLanes"
) -> None:
    """Loads the motions of a block of poses, component by component."""
    LOADS


def forces_of_block(model: "Model", at: "MotionLanes", out: "Block") -> None:
    """Computes the forces of a block of poses, and marks the poses that must be checked."""
    shared = blank(SharedLanes)
    if AHEAD:
        roots = blank(Roots)
    if ABOUT_TIP:
        first = blank(LegBlock)
        other = blank(LegBlock)
    for l in range(POSES):
        out.bad[l] = 0.0
    if AHEAD:
        roots_of_leg(model, 0, at, roots.leg[0])
    shared_of_block(model, at, shared, out.column[6])
    for i in range(6):
        if AHEAD:
            if i < 5:
                roots_of_leg(model, i + 1, at, roots.leg[i + 1])
        leg_of_block(model, i, at, shared, ROOTS, out.column[i], OWN, C, KNOWN, out.bad)
        if ABOUT_TIP:
            if i == 0:
                moments_of_first(first.q, FIRST_C, FIRST_MOMENT, out.column[6])
            else:
                moments_of_block(other.q, first.q, OTHER_C, OTHER_MOMENT, out.column[i], ALL_C)
    if SCALED == 1:
        if model.per_length != 1.0:
            scale_block(out.column, model.per_length)
    if SCALED == 2:
        scale_block(out.column, PER_LENGTH)
    solve_block(out.column, D, ARM_CUBE, out.F, out.bad)


def forces_of(model: "Model", at: "MotionLanes", l: "Integer", F: "array(6)") -> "Integer":
    """Computes the forces and the status of one pose of a block."""
    one = blank(Motion)
    for i in range(9):
        one.R[i] = at.R[i][l]
    for i in range(3):
        ONE
    return forces(model, one, F)


def forces_of_poses(
    model: "Model",
    count: "Count",
    stride: "Count",
    motions: "Motions",
    F: "Pointer(Real)",
    status: "Pointer(Integer)",
) -> "Integer":
    """Computes the forces block by block. The arrays contain pose after pose if stride is 0, else columns."""
    if BAKED:
        model = address(numbers)
    at = blank(MotionLanes)
    done = blank(Block)
    found = blank(array(6))
    result = OK
    for first in range(0, count, POSES):
        load_block(motions, stride, first, count, at)
        forces_of_block(model, at, done)
        for l in range(POSES):
            if not first + l < count:
                break
            pose = first + l
            code = OK
            if done.bad[l] > 0.0:
                if BAKED:  # noqa: SIM108
                    code = forces_of(at, l, found)
                else:
                    code = forces_of(model, at, l, found)
                if code == OK:
                    done.bad[l] = 0.0
                    for i in range(6):
                        done.F[i][l] = found[i]
            note_status()
        store_forces(done.F, done.bad, stride, first, count, F)
    return result


def forces_batch(
    model: "Model", count: "Count", motions: "Motions", F: "Pointer(Real)", status: "Pointer(Integer)"
) -> "Integer":
    """Computes the actuator forces F[count][6] (N) of `count` poses. `status` receives the code of each pose
    and may be null; F_ext and M_ext may be null for zero load. Returns the first code other than STEWART_OK,
    or STEWART_OK. A pose with another code keeps its old numbers in F and does not affect the other poses.
    STEWART_BAD_ARGUMENT: $motion_needed, or another pointer is null; then nothing is written."""
    if MISSING:
        return BAD_ARGUMENT
    return forces_of_poses(model, count, 0, motions, F, status)


def forces_columns(
    model: "Model",
    count: "Count",
    stride: "Count",
    motions: "Motions",
    F: "Pointer(Real)",
    status: "Pointer(Integer)",
) -> "Integer":
    """Computes the same forces, identical to the last bit, from arrays with one column for each component:
    component i of pose j is element [i*stride + j] of its array. i is 0 to 8 in R, 0 to 2 in vectors, and 0
    to 5 in F. STEWART_BAD_ARGUMENT: as above, or `stride` is less than `count`. Arrays may have any address.
    Eight poses (sixteen in float) are read at a time. This is fastest if the arrays begin at multiples of 64
    bytes, and if `stride` times sizeof(stewart_real) is a multiple of 64 but not of 4096."""
    if MISSING:
        return BAD_ARGUMENT
    return forces_of_poses(model, count, stride, motions, F, status)
