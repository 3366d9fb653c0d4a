"""The closed form's blocks with the legs of a pose in lanes, in the part of Python that ``read`` reads."""


def pose_terms(
    model: "alone(Model)", at: "alone(Motion)", out: "alone(Pose)", summed: "alone(array(COUNT))"
) -> None:
    """The platform's part."""
    POSE


def leg_terms(model: "alone(Model)", at: "alone(Motion)", pose: "alone(Pose)", out: "alone(Legs)") -> None:
    """The legs side by side."""
    OUTSIDE
    for l in range(LANES):
        BLOCK
        checked(out.checked)


def legs_status(checked: "Checked") -> "Integer":
    """What is wrong with the first leg that is not fit."""
    for i in range(6):
        if checked.bad[i] > 0.0:
            return fault_of(checked.L[i], checked.k3[i], checked.reach[i])
    return OK


def is_near(checked: "Checked") -> "Integer":
    """Whether a leg is so near its joint singularity that the shorter formulas lose digits."""
    found = 0
    for i in range(6):
        found = where(checked.k3[i] > LEANING, found, 1)
    return found


def sums(model: "Model", motion: "Motion", legs: "Legs", summed: "array(COUNT)") -> None:
    """Platform and legs together; ``status``: of the legs."""
    pose = blank(Pose)
    pose_terms(model, motion, pose, summed)
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
