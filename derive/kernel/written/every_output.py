"""Inverse dynamics with all terms in C as written functions."""


def pose_forces(robot: "Robot", at: "Motions", out: "Forces") -> "Integer":
    """Computes the inverse dynamics of one pose, (1)-(37)."""
    terms = blank(LegTerms)
    own = blank(PlatformTerms)
    A = blank(array(6, 7))
    arm = blank(array(6, 3))
    reach = blank(array(6))
    L = blank(array(6))
    extent = 0.0
    close = 0
    platform_wrench(robot, at, own)
    for j in range(3):
        out.c[j] = own.c_force[j]
        out.c[j + 3] = own.c_moment[j]
    for i in range(6):
        leg_dynamics(robot, robot.leg[i], at, terms)
        reach[i] = largest_component(terms.q, 0.0)
        extent = larger(reach[i], extent)
        reach[i] = largest_component(robot.leg[i].b, largest_component(at.t, reach[i]))
        L[i] = terms.L
        status = status_of_leg(terms.L, terms.k3 if HAS_SINE else 1.0, reach[i])
        if status != OK:
            return status
        close = where(L[i] > SHORT_SHARE * reach[i], close, 1)
        out.D[i] = terms.D
        for j in range(3):
            arm[i][j] = terms.q[j]
            out.K[i][j] = terms.K[j]
            add_leg(i, j)
    for i in range(6):
        for j in range(6):
            A[i][j] = out.H[i][j]
        A[i][6] = out.c[i]
    per_length = per_length_of(extent, SMALLEST)
    if per_length != 1.0:
        for i in range(7):
            A[3][i] = A[3][i] * per_length
            A[4][i] = A[4][i] * per_length
            A[5][i] = A[5][i] * per_length
    suspect = eliminate(A, out.x)
    if close != 0 or suspect != 0:
        H = blank(array(6, 6))
        for i in range(6):
            for j in range(6):
                H[i][j] = out.H[i][j]
        status = singular_status(H, arm, L, reach, 0.0)
        if status != OK:
            return status
    for i in range(6):
        out.F[i] = out.D[i] - out.x[i]
    return where(is_finite(out.F, 6) != 0, OK, NOT_FINITE)


def pose_reactions(
    robot: "Robot", at: "Motions", bearing: "Pointer(Real)", x: "array(6)", out: "Reactions"
) -> "Integer":
    """Computes the joint reactions of one pose from its axial forces, (21), (26)-(29), (17). Returns a
    status."""
    terms = blank(ReactionTerms)
    for i in range(6):
        leg_reactions(robot, robot.leg[i], at, x[i], where(bearing is not None, bearing[i], 0.0), terms)
        for j in range(3):
            out.F_s[i][j] = terms.F_s[j]
            out.F_u[i][j] = terms.F_u[j]
            out.F_p[i][j] = terms.F_p[j]
            out.F_c[i][j] = terms.F_c[j]
            out.M_p[i][j] = terms.M_p[j]
        out.M_u[i] = terms.M_u
    return where(is_finite(numbers_of(out), COUNT) != 0, OK, NOT_FINITE)


def inverse_dynamics(robot: "Robot", motion: "Motion", forces: "Forces") -> "Integer":
    """Computes the actuator forces of one pose and the terms D, x, K, H, and c. Returns a status, and writes
    `forces` only if it is STEWART_OK. Other statuses: STEWART_NOT_FINITE, STEWART_ZERO_LENGTH,
    ${joint_singular}STEWART_SINGULAR, and STEWART_BAD_ARGUMENT if a pointer is null."""
    result = blank(Forces)
    if robot is None or motion is None or forces is None:
        return BAD_ARGUMENT
    at = motion_as_arrays(motion)
    status = pose_forces(robot, at, result)
    if status == OK:
        forces = result
    return status


def joint_reactions(
    robot: "Robot", motion: "Motion", bearing: "array(6)", forces: "Forces", reactions: "Reactions"
) -> "Integer":
    """Computes the inverse dynamics and the joint reactions of one pose. `bearing` (m): distance along each
    leg from its base point to the reference point of M_p; null: 0. Returns a status as above, and writes
    `forces` and `reactions` only if it is STEWART_OK."""
    result = blank(Forces)
    found = blank(Reactions)
    if robot is None or motion is None or forces is None or reactions is None:
        return BAD_ARGUMENT
    at = motion_as_arrays(motion)
    status = pose_forces(robot, at, result)
    if status == OK:
        status = pose_reactions(robot, at, bearing, result.x, found)
    if status == OK:
        forces = result
        reactions = found
    return status


def inverse_dynamics_batch(
    robot: "Robot", count: "Count", motions: "Motions", forces: "ForcesArrays", status: "Pointer(Integer)"
) -> "Integer":
    """Computes the inverse dynamics of `count` poses. `status` receives the code of each pose and may be
    null. Returns the first code other than STEWART_OK, or STEWART_OK. STEWART_BAD_ARGUMENT: another pointer,
    or an array of the motions except F_ext and M_ext, is null; then nothing is written."""
    zeros = array(3)
    found = blank(Forces)
    if MISSING:
        return BAD_ARGUMENT
    batch()


def one_forces() -> None:
    """Compute one pose of the batch."""
    at = pose_at(motions, pose, zeros)
    code = pose_forces(robot, at, found)


def joint_reactions_batch(
    robot: "Robot",
    count: "Count",
    motions: "Motions",
    bearing: "array(6)",
    reactions: "ReactionsArrays",
    status: "Pointer(Integer)",
) -> "Integer":
    """Computes the joint reactions of `count` poses. `bearing` is valid for all poses and may be null.
    `status` and the returned code are as above."""
    zeros = array(3)
    forces = blank(Forces)
    found = blank(Reactions)
    if MISSING:
        return BAD_ARGUMENT
    batch()


def one_reactions() -> None:
    """Compute one pose of the batch."""
    at = pose_at(motions, pose, zeros)
    code = pose_forces(robot, at, forces)
    if code == OK:
        code = pose_reactions(robot, at, bearing, forces.x, found)
