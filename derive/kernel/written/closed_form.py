"""Closed form as written functions.

All kernels of the closed form use ``sums``, ``sums_of_two_forms``, and ``legs_of``: ``Sums``, ``Legs``, and
the blocks are placeholders for the parts of a kernel. The number at the end of a function name, as in
``solve_definite_24``, is its width.
"""


def legs_of(model: "Model", motion: "Motion", pose: "Pose", legs: "Legs") -> None:
    """Terms of the legs, their status, and a mark if a leg is near its joint singularity."""
    status = model.status
    leaning = 0
    for i in range(6):
        legs.leg[i] = leg_terms(model.leg[i], model.platform, motion, pose, legs.given[i])
        legs.reach[i] = reach_of(model.leg[i].b, motion.t, legs.leg[i].q)
        fault = fault_of(legs.leg[i].L, legs.leg[i].k3, legs.reach[i])
        status = where(status == OK, fault, status)
        leaning = where(legs.leg[i].k3 > LEANING, leaning, 1)
    legs.status = status
    legs.leaning = leaning


def sums(model: "Model", motion: "Motion", legs: "Legs", summed: "Sums") -> None:
    """Sums over platform and legs."""
    pose = pose_terms(model.platform, motion)
    legs_of(model, motion, pose, legs)
    total(pose, legs, summed)


def sums_of_two_forms(model: "Model", motion: "Motion", legs: "Legs", summed: "Sums") -> None:
    """Sums over platform and legs, by other blocks if a leg is near its joint singularity."""
    pose = pose_terms(model.platform, motion)
    legs_of(model, motion, pose, legs)
    if anywhere(legs.leaning == 1):
        for i in range(6):
            near = near_terms(model.leg[i], model.platform, motion, pose, legs.given[i])
            legs.leg[i] = where(legs.leaning == 1, near, legs.leg[i])
    total(pose, legs, summed)


def total(pose: "Pose", legs: "Legs", out: "Sums") -> None:
    """The sums over platform and legs."""
    for number in numbers(out):
        out[number] = pose[number] + (
            (legs.leg[0][number] + legs.leg[1][number])
            + (legs.leg[2][number] + legs.leg[3][number])
            + (legs.leg[4][number] + legs.leg[5][number])
        )


def equations(model: "Model", motion: "Motion") -> "Equations":
    """M, C, g, friction, bias, H and its rate of M [a; alpha] + C [v; omega] + g + friction = H F + loads."""
    out = blank(Equations)
    legs = blank(EquationsLegs)
    summed = blank(EquationsSums)
    equations_sums(model, motion, legs, summed)
    place_inertia_6(summed.M_vv, summed.M_vw, summed.M_ww, 0, out.M)
    place_blocks_6(summed.C_vv, summed.C_vw, summed.C_wv, summed.C_ww, 0, out.C)
    for i in range(3):
        out.g[i] = summed.g_force[i]
        out.g[i + 3] = summed.g_moment[i]
        out.friction[i] = summed.friction_force[i]
        out.friction[i + 3] = summed.friction_moment[i]
        for j in range(6):
            out.H[i][j] = legs.leg[j].H_force[i]
            out.H[i + 3][j] = legs.leg[j].H_moment[i]
            out.H_dot[i][j] = legs.leg[j].H_dot_force[i]
            out.H_dot[i + 3][j] = legs.leg[j].H_dot_moment[i]
    for i in range(6):
        total_bias = out.g[i]
        for j in range(3):
            total_bias = total_bias + out.C[i][j] * motion.v[j] + out.C[i][j + 3] * motion.omega[j]
        out.bias[i] = total_bias
        out.bias_and_friction[i] = total_bias + out.friction[i]
    out.status = legs.status
    check_equations(out)
    return out


def bias_and_friction(model: "Model", motion: "Motion") -> "BiasAndFriction":
    """C [v; omega] + g + friction without C."""
    out = blank(BiasAndFriction)
    legs = blank(BiasLegs)
    summed = blank(BiasSums)
    bias_sums(model, motion, legs, summed)
    for i in range(3):
        out.bias_and_friction[i] = summed.bias_force[i]
        out.bias_and_friction[i + 3] = summed.bias_moment[i]
    out.status = legs.status
    check_bias_and_friction(out)
    return out


def forward_dynamics(model: "Model", motion: "Motion", F: "array(6)") -> "Accelerations":
    """Accelerations a and alpha of the platform under the actuator forces F, N; a and alpha are not read."""
    out = blank(Accelerations)
    legs = blank(ForwardLegs)
    summed = blank(ForwardSums)
    for i in range(6):
        legs.given[i].F = F[i]
    forward_sums(model, motion, legs, summed)
    accelerations_of(legs, summed, out)
    if anywhere(out.status == MASS_MATRIX_INDEFINITE):
        by = blank(Rows)
        apart = forward_apart(model, motion, F, by)
        lost = where(out.status == MASS_MATRIX_INDEFINITE, 1, 0)
        for i in range(3):
            out.a[i] = where(lost == 1, apart.x[i], out.a[i])
            out.alpha[i] = where(lost == 1, apart.x[i + 3], out.alpha[i])
        out.status = where(lost == 1, apart.status, out.status)
    check_forward_dynamics(out)
    return out


def accelerations_of(legs: "ForwardLegs", summed: "ForwardSums", out: "Accelerations") -> None:
    """The accelerations of a pose; MASS_MATRIX_INDEFINITE if elimination loses too many digits of M."""
    status = OK
    definite_six()
    for i in each(3):
        out.a[i] = x[i,]
        out.alpha[i] = x[i + 3,]
    out.status = where(legs.status == OK, status, legs.status)


def joint_inertia(model: "Model", motion: "Motion") -> "JointInertia":
    """Mass matrix for leg lengths as coordinates, H^-1 M H^-T."""
    out = blank(JointInertia)
    legs = blank(EquationsLegs)
    summed = blank(EquationsSums)
    A = blank(array(6, 12))
    half = blank(array(6, 6))
    equations_sums(model, motion, legs, summed)
    status = legs.status
    for i in range(3):
        for j in range(6):
            A[i][j] = legs.leg[j].H_force[i]
            A[i + 3][j] = legs.leg[j].H_moment[i]
    place_inertia_12(summed.M_vv, summed.M_vw, summed.M_ww, 6, A)
    scale_moments_12(model.per_length, A)
    close = solve_pivoted_12(A)
    for i in range(6):
        close = where(legs.leg[i].L > SHORT_SHARE * legs.reach[i], close, 1)
        for j in range(6):
            half[i][j] = A[i][j + 6]
    if anywhere((status == OK) & (close == 1)):
        found = columns_status(model, motion, legs)
        status = where((status == OK) & (close == 1), found, status)
    for i in range(3):
        for j in range(6):
            A[i][j] = legs.leg[j].H_force[i]
            A[i + 3][j] = legs.leg[j].H_moment[i]
            A[i][j + 6] = half[j][i]
            A[i + 3][j + 6] = half[j][i + 3]
    scale_moments_12(model.per_length, A)
    solve_pivoted_12(A)
    for i in range(6):
        for j in range(6):
            out.inertia[i][j] = (A[i][j + 6] + A[j][i + 6]) * 0.5
    out.status = status
    check_joint_inertia(out)
    return out


def columns_status(model: "Model", motion: "Motion", legs: "EquationsLegs") -> "Integer":
    """Returns the status of H: STEWART_SINGULAR if H is singular to rounding."""
    H = blank(array(6, 6))
    arm = blank(array(6, 3))
    L = blank(array(6))
    for i in range(6):
        L[i] = legs.leg[i].L
        for j in range(3):
            H[j][i] = legs.leg[i].H_force[j]
            H[j + 3][i] = legs.leg[i].H_moment[j]
            plane = motion.R[3 * j] * model.leg[i].p[0] + motion.R[3 * j + 1] * model.leg[i].p[1]
            arm[i][j] = plane + motion.R[3 * j + 2] * model.leg[i].p[2]
    return singular_status(H, arm, L, legs.reach, 0.0)


def derivatives(model: "Model", motion: "Motion") -> "Derivatives":
    """Actuator forces of inverse dynamics and their derivatives by [dt; dphi], [v; omega], [a; alpha]."""
    out = blank(Derivatives)
    legs = blank(DerivativesLegs)
    summed = blank(DerivativesSums)
    A = blank(array(6, 24))
    acting = forces(model, motion)
    for i in range(6):
        legs.given[i].F = acting.F[i]
    derivatives_sums(model, motion, legs, summed)
    for i in range(3):
        for j in range(6):
            A[i][j] = legs.leg[j].H_force[i]
            A[i + 3][j] = legs.leg[j].H_moment[i]
    place_blocks_24(summed.W_ft, summed.W_fr, summed.W_mt, summed.W_mr, 6, A)
    place_blocks_24(summed.W_fv, summed.W_fw, summed.W_mv, summed.W_mw, 12, A)
    place_inertia_24(summed.M_vv, summed.M_vw, summed.M_ww, 18, A)
    scale_moments_24(model.per_length, A)
    solve_pivoted_24(A)
    for i in range(6):
        out.F[i] = acting.F[i]
        for j in range(6):
            out.by_pose[i][j] = A[i][j + 6]
            out.by_twist[i][j] = A[i][j + 12]
            out.by_acceleration[i][j] = A[i][j + 18]
    out.status = where(acting.status == OK, legs.status, acting.status)
    check_derivatives(out)
    return out


def linearization(model: "Model", motion: "Motion", F: "array(6)") -> "LinearizationResult":
    """Forward dynamics, and d/dt [dt; dphi; dv; domega] = A [dt; dphi; dv; domega] + B dF about it."""
    out = blank(LinearizationResult)
    legs = blank(DerivativesLegs)
    summed = blank(DerivativesSums)
    A = blank(array(6, 24))
    moved = forward_dynamics(model, motion, F)
    status = moved.status
    moving = with_acceleration(motion, moved.a, moved.alpha)
    for i in range(6):
        legs.given[i].F = F[i]
    derivatives_sums(model, moving, legs, summed)
    place_inertia_24(summed.M_vv, summed.M_vw, summed.M_ww, 0, A)
    place_blocks_24(summed.W_ft, summed.W_fr, summed.W_mt, summed.W_mr, 6, A)
    place_blocks_24(summed.W_fv, summed.W_fw, summed.W_mv, summed.W_mw, 12, A)
    for i in range(3):
        for j in range(6):
            A[i][j + 18] = legs.leg[j].H_force[i]
            A[i + 3][j + 18] = legs.leg[j].H_moment[i]
    fault = solve_definite_24(A, KEPT)
    if anywhere((status == OK) & (fault == MASS_MATRIX_INDEFINITE)):
        apart = slopes_apart(model, motion, moving, F)
        for i in range(6):
            for j in range(6, 24):
                A[i][j] = where(fault == MASS_MATRIX_INDEFINITE, apart.A[i][j], A[i][j])
        for i in range(3):
            moved.a[i] = where(fault == MASS_MATRIX_INDEFINITE, apart.x[i], moved.a[i])
            moved.alpha[i] = where(fault == MASS_MATRIX_INDEFINITE, apart.x[i + 3], moved.alpha[i])
        fault = where(fault == MASS_MATRIX_INDEFINITE, apart.status, fault)
    for i in range(3):
        out.a[i] = moved.a[i]
        out.alpha[i] = moved.alpha[i]
    for i in range(6):
        for j in range(12):
            out.A[i][j] = 0.0
            out.A[i + 6][j] = -A[i][j + 6]
        for j in range(6):
            out.B[i][j] = 0.0
            out.B[i + 6][j] = A[i][j + 18]
        out.A[i][i + 6] = 1.0
    out.A[3][4] = -motion.omega[2]
    out.A[3][5] = motion.omega[1]
    out.A[4][3] = motion.omega[2]
    out.A[4][5] = -motion.omega[0]
    out.A[5][3] = -motion.omega[1]
    out.A[5][4] = motion.omega[0]
    out.status = where(status == OK, fault, status)
    check_linearization(out)
    return out


def with_acceleration(motion: "Motion", a: "array(3)", alpha: "array(3)") -> "Motion":
    """The motion with these accelerations."""
    out = blank(Motion)
    for i in range(9):
        out.R[i] = motion.R[i]
    for i in range(3):
        out.t[i] = motion.t[i]
        out.omega[i] = motion.omega[i]
        out.v[i] = motion.v[i]
        out.alpha[i] = alpha[i]
        out.a[i] = a[i]
        out.F_ext[i] = motion.F_ext[i]
        out.M_ext[i] = motion.M_ext[i]
    return out


def place_inertia(
    vv: "array(6)", vw: "array(9)", ww: "array(6)", first: "Integer", A: "array(6, WIDTH)"
) -> None:
    """M into six columns from ``first`` on, from its parts, of which symmetric ones are xx xy xz yy yz zz."""
    for i in range(3):
        for j in range(3):
            A[i][first + j + 3] = vw[3 * i + j]
            A[j + 3][first + i] = vw[3 * i + j]
    place_symmetric_WIDTH(vv, 0, first, A)
    place_symmetric_WIDTH(ww, 3, first + 3, A)


def place_symmetric(parts: "array(6)", row: "Integer", column: "Integer", A: "array(6, WIDTH)") -> None:
    """A symmetric 3 x 3 block from xx xy xz yy yz zz."""
    for i in range(3):
        A[row][column + i] = parts[i]
        A[row + i][column] = parts[i]
    A[row + 1][column + 1] = parts[3]
    A[row + 1][column + 2] = parts[4]
    A[row + 2][column + 1] = parts[4]
    A[row + 2][column + 2] = parts[5]


def place_blocks(
    vv: "array(PART)",
    vw: "array(PART)",
    wv: "array(PART)",
    ww: "array(PART)",
    first: "Integer",
    A: "array(6, WIDTH)",
) -> None:
    """Four 3 x 3 blocks, whose rows are ``ROW`` numbers apart, into six columns from ``first`` on."""
    for i in range(3):
        for j in range(3):
            A[i][first + j] = vv[ROW * i + j]
            A[i][first + j + 3] = vw[ROW * i + j]
            A[i + 3][first + j] = wv[ROW * i + j]
            A[i + 3][first + j + 3] = ww[ROW * i + j]


def scale_moments(per_length: "Real", A: "array(6, WIDTH)") -> None:
    """Multiplies the rows of moments by one over a length."""
    if anywhere(per_length != 1.0):
        for i in range(3, 6):
            for j in range(WIDTH):
                A[i][j] = A[i][j] * per_length
