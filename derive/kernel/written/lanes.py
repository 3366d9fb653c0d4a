"""Preparation and batches of the actuator forces, as written functions.

Names in capitals are placeholders for properties of a kernel. ``BAKED``: constants are numbers.
"""

FORCES = """Computes the actuator forces F (N) of one pose, (37), positive when they extend the leg. Reads
$motion_read of the motion. Returns a status, and writes F only if it is STEWART_OK. Other statuses:
STEWART_NOT_FINITE, STEWART_ZERO_LENGTH, ${joint_singular}STEWART_SINGULAR, and STEWART_BAD_ARGUMENT if a
pointer is null."""
"""Description of the function of one pose."""


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


def load_block(
    motions: "Motions", stride: "Count", first: "Count", count: "Count", at: "MotionLanes"
) -> None:
    """Loads the motions of a block of poses, component by component."""
    LOADS


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
            if done.unfinished[l] > 0.0:
                if BAKED:  # noqa: SIM108
                    code = forces_of(at, l, found)
                else:
                    code = forces_of(model, at, l, found)
                if code == OK:
                    done.unfinished[l] = 0.0
                    for i in range(6):
                        done.F[i][l] = found[i]
            note_status()
        store_forces(done.F, done.unfinished, stride, first, count, F)
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
