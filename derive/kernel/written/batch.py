"""Batches of poses as written functions: a loop over the poses, and the call for one pose.

Every kernel has functions with this text; ``one_pose`` is its computation of one pose.
"""


def batch() -> None:
    """Computes the poses in order; returns the first code other than OK."""
    result = OK
    for pose in range(count):
        one_pose()
        if COPIES:
            if code == OK:
                COPIED
        note_status()
    return result


def noted() -> None:
    """Stores the status of a pose, and keeps the first code other than OK."""
    if status is not None:
        status[pose] = code
    result = where(result == OK, code, result)


def copy(to: "Pointer(Real)", pose: "Count", values: "Pointer(Real)", count: "Count") -> None:
    """Copies the numbers of a pose to the array of all poses unless it is null."""
    if to is not None:
        for i in range(count):
            to[pose * count + i] = values[i]


def is_finite(values: "Pointer(Real)", count: "Integer") -> "Integer":
    """Returns 1 if all numbers are finite, else 0."""
    for i in range(count):
        if not size(values[i]) <= MAX:
            return 0
    return 1


def pose_at(motions: "Motions", pose: "Count", zeros: "array(3)") -> "Motions":
    """Returns one pose of a batch, with zeros for optional arrays that are null."""
    at = blank(Motions)
    PARTS
    return at


def motion_as_arrays(motion: "Motion") -> "Motions":
    """Returns a motion as a batch of one pose."""
    at = blank(Motions)
    PARTS
    return at


def load_pose(motions: "Motions", pose: "Count", one: "Motion") -> None:
    """Copies one pose of a batch, with zeros for optional arrays that are null."""
    for i in range(9):
        one.R[i] = motions.R[pose * 9 + i]
    for i in range(3):
        at = pose * 3 + i
        ONE


# ---------------------------------------------------------------- legs


def legs_batch(
    robot: "Robot", count: "Count", motions: "Motions", legs: "LegsArrays", status: "Pointer(Integer)"
) -> "Integer":
    """Kinematics of the legs of many poses."""
    zeros = array(3)
    if MISSING:
        return BAD_ARGUMENT
    batch()


def one_kinematics() -> None:
    """Compute one pose of the batch."""
    at = pose_at(motions, pose, zeros)
    found = motions_of(robot, at)
    code = found.status


# ---------------------------------------------------------------- bounds


def forces_bounded(
    model: "Model", motion: "Motion", F: "array(6)", bound: "array(6)", rcond: "Pointer(Real)"
) -> "Integer":
    """Forces of one pose with their bounds."""
    if MISSING:
        return BAD_ARGUMENT
    at = motion_as_arrays(motion)
    return forces_of_pose(model, at, F, bound, rcond)


def forces_bounded_batch(
    model: "Model",
    count: "Count",
    motions: "Motions",
    F: "Pointer(Real)",
    bound: "Pointer(Real)",
    rcond: "Pointer(Real)",
    status: "Pointer(Integer)",
) -> "Integer":
    """Forces of many poses with their bounds."""
    zeros = array(3)
    if MISSING:
        return BAD_ARGUMENT
    batch()


def one_bounded() -> None:
    """Compute one pose of the batch."""
    at = pose_at(motions, pose, zeros)
    code = forces_of_pose(
        model,
        at,
        F[pose * 6 :],
        where(bound is not None, bound[pose * 6 :], None),
        where(rcond is not None, rcond[pose:], None),
    )


# ---------------------------------------------------------------- closed form


def closed_form(model: "Model", motion: "Motion", F: "array(6)", out: "Result") -> "Integer":
    """One output of the closed form."""
    found = blank(Found)
    if MISSING:
        return BAD_ARGUMENT
    find(model, motion, F, found)
    if found.status == OK:
        COPIED
    return found.status


def closed_form_batch(
    model: "Model",
    count: "Count",
    motions: "Motions",
    F: "Pointer(Real)",
    out: "ResultArrays",
    status: "Pointer(Integer)",
) -> "Integer":
    """One output of the closed form for many poses."""
    one = blank(Motion)
    found = blank(Found)
    if MISSING:
        return BAD_ARGUMENT
    batch()


def one_closed_form() -> None:
    """Compute one pose of the batch."""
    load_pose(motions, pose, one)
    code = of_pose(model, one, F[pose * 6 :], found)
