"""Actuator forces with a bound of their rounding error; names in capitals are placeholders for blocks."""


def least(value: "Real", error: "Real") -> "Real":
    """A lower limit of the magnitude of the exact value; 0 if the error may exceed half of `value`."""
    positive = size(value)
    return where(error <= 0.5 * positive, positive - error, 0.0)


def root_error(root: "Real", error: "Real") -> "Real":
    """Error of a square root r of an argument with `error`: |sqrt(a) - r| <= error / (2 r - error / r)."""
    return error / least(2.0 * root, error / root) + UNIT * root


def reciprocal_error(inverse: "Real", of: "Real", error: "Real") -> "Real":
    """Error of inverse = 1 / of, if `of` has the error `error`."""
    positive = size(inverse)
    return positive * (error / least(of, error)) + UNIT * positive


def add(total: "Real", total_err: "Real", term: "Real", term_err: "Real") -> None:
    """Adds a term with an error to a sum with an error."""
    total = total + term
    total_err = total_err + term_err + UNIT * size(total)


def rotation_error(R: "array(9)", stretch: "array(9)") -> "Real":
    """Bounds the sizes of R^T R - 1, in `stretch`, and the entries of R less the rotation nearest to it, by
    the largest distance of a singular value from 1: half of the norm of row sums, with a 64th more for the
    terms of higher order. Entries of R are multiples of `grid` and a rest: products of the multiples have no
    rounding error, nor has their sum less 1."""
    high = blank(array(9))
    low = blank(array(9))
    grid = 1.0
    worst = 0.0
    for i in range(64):
        if not 0.5 * grid * 0.5 * grid >= EPSILON:
            break
        grid = 0.5 * grid
    for i in range(9):
        shift = 1.5 * (grid / EPSILON)
        high[i] = (R[i] + shift) - shift
        low[i] = R[i] - high[i]
    for i in range(3):
        row = 0.0
        for j in range(3):
            total = where(i == j, -1.0, 0.0)
            rest = 0.0
            sizes = 0.0
            for k in range(0, 9, 3):
                small = high[k + i] * low[k + j] + low[k + i] * R[k + j]
                total = total + high[k + i] * high[k + j]
                rest = rest + small
                sizes = sizes + size(high[k + i] * low[k + j]) + size(low[k + i] * R[k + j])
            total = total + rest
            stretch[3 * i + j] = size(total) + UNIT * (5.0 * sizes + size(total))
            row = row + stretch[3 * i + j]
        worst = where(row > worst, row, worst)
    return where(worst <= 0.0078125, 0.5 * SLACK * worst, INFINITY)


def prepare_leg(robot: "Robot", leg: "RawLeg", out: "Leg", added: "Added") -> None:
    """Computes the constants of one leg, and its contributions to the constants of the platform."""
    BODY


def prepare_platform(robot: "Robot", added: "Added", out: "Platform") -> None:
    """Computes the constants of the platform."""
    BODY


def prepare(robot: "Robot", model: "Model") -> "Integer":
    """Computes the model of a robot; see the header."""
    made = blank(Model)
    found = blank(Added)
    sum = blank(Added)
    squares = 0.0
    if robot is None or model is None:
        return BAD_ARGUMENT
    CLEARED
    for i in range(6):
        prepare_leg(robot, robot.leg[i], made.leg[i], found)
        SUMMED
        for j in range(3):
            squares = squares + robot.leg[i].p[j] * robot.leg[i].p[j]
    prepare_platform(robot, sum, made.platform)
    made.length = sqrt(squares / 6.0)
    hand_over()


def shared_of_pose(platform: "Platform", at: "Motions", out: "Shared") -> None:
    """Terms of one pose that are common to all legs."""
    BODY


def leg_of_pose(platform: "Platform", leg: "Leg", at: "Motions", shared: "Shared", out: "LegTerms") -> None:
    """One leg in joint coordinates: D, its column of H and its part of c."""
    BODY
    largest_term()
    out.reach = reach


def shared_errors(
    platform: "Platform",
    at: "Motions",
    R_err: "Real",
    rows: "alone(Rows)",
    weighed: "Integer",
    slopes: "alone(Slopes)",
    error: "alone(array(LANES))",
    out: "Shared",
) -> None:
    """Terms of one pose that are common to all legs, with their errors. R_err is the deviation of R from a
    rotation. If `weighed` is not 0, adds the effects of the errors to the error of each force: largest error
    times the derivative of the force. Also adds to the derivatives with respect to R."""
    BODY
    if weighed != 0:
        for i in range(LANES):
            EACH


def leg_errors(
    platform: "Platform",
    leg: "Leg",
    at: "Motions",
    shared: "Shared",
    R_err: "Real",
    rows: "alone(Rows)",
    slopes: "alone(Slopes)",
    error: "alone(array(LANES))",
    out: "LegTerms",
) -> None:
    """Terms of one leg with their errors. Adds the effects of the errors to the error of each force, and to
    the derivatives of each force with respect to the common terms of the pose."""
    BODY
    for i in range(LANES):
        EACH


def stretch_error(
    R: "array(9)", stretch: "array(9)", R_err: "Real", of: "Slopes", force: "Integer"
) -> "Real":
    """Bounds the effect on a force if R is not exactly a rotation. The difference between R and the nearest
    rotation is R (E / 2 - 3 E^2 / 8 + ...) with the symmetric matrix E = R^T R - 1. Therefore only the
    symmetric part of R^T times the derivatives of the force has an effect. A rotation of R is no error."""
    total = 0.0
    slopes = 0.0
    for i in range(3):
        for j in range(3):
            sum = 0.0
            doubt = 0.0
            for k in range(0, 9, 3):
                one = R[k + i] * of.R_legs[k + j][force]
                other = R[k + j] * of.R_legs[k + i][force]
                sum = sum + (one + other)
                doubt = doubt + 5.0 * UNIT * (size(one) + size(other))
                doubt = doubt + size(R[k + i]) * of.R_legs_err[k + j][force]
                doubt = doubt + size(R[k + j]) * of.R_legs_err[k + i][force]
            total = total + stretch[3 * i + j] * (size(sum) + doubt) / 4.0
            slopes = slopes + size(of.R_legs[3 * i + j][force]) + of.R_legs_err[3 * i + j][force]
    return total + 2.0 * R_err * R_err * slopes


def solution_error(of: "Equations", x: "array(6)", Y: "array(6, 6)", error: "array(6)") -> None:
    """Bounds the rest of the error of x = Y c when the errors of H and c have been weighed by Y: adds it
    to `error`. With E_H and e_c bounding these errors, and d the error of x in sizes, d <= b + G d, where
    b = |Y| (|c - H x| + E_H |x| + e_c) and G = |1 - Y H| + |Y| E_H,
    and where G b <= beta b with beta < 1, H is regular and d <= b / (1 - beta) (Rump, Verification methods,
    Acta Numerica 19 (2010), 10); the rest is |Y| |c - H x| + G d. Where there is no such beta, it is
    infinite. Sums of seven terms round seven times at most."""
    rest = blank(array(6))
    doubt = blank(array(6))
    b = blank(array(6))
    G = blank(array(6, 6))
    worst = 0.0
    for i in range(6):
        sum = of.c[i]
        sizes = size(of.c[i])
        doubt[i] = of.c_err[i]
        for j in range(6):
            product = of.H[i][j] * x[j]
            sum = sum - product
            sizes = sizes + size(product)
            doubt[i] = doubt[i] + of.H_err[i][j] * size(x[j])
        rest[i] = size(sum) + 7.0 * UNIT * sizes + of.c_own[i]
    for i in range(6):
        "So that no entry is zero."
        b[i] = 4.0 / MAX
        for j in range(6):
            b[i] = b[i] + size(Y[i][j]) * (rest[j] + doubt[j])
            error[i] = error[i] + size(Y[i][j]) * rest[j]
    for i in range(6):
        grown = 0.0
        for k in range(6):
            lack = where(i == k, 1.0, 0.0)
            around = where(i == k, 1.0, 0.0)
            carried = 0.0
            for j in range(6):
                term = Y[i][j] * of.H[j][k]
                lack = lack - term
                around = around + size(term)
                carried = carried + size(Y[i][j]) * of.H_err[j][k]
            G[i][k] = size(lack) + carried + 7.0 * UNIT * around
            grown = grown + G[i][k] * b[k]
        worst = where(grown / b[i] <= worst, worst, grown / b[i])
    for i in range(6):
        for k in range(6):
            error[i] = error[i] + G[i][k] * (b[k] / (1.0 - worst))
        if not worst <= 0.875:
            error[i] = INFINITY


def norm(A: "array(6, 6)") -> "Real":
    """Largest sum of a column in sizes."""
    worst = 0.0
    for j in range(6):
        sum = 0.0
        for i in range(6):
            sum = sum + size(A[i][j])
        worst = where(sum > worst, sum, worst)
    return worst


def reciprocal_condition(H: "array(6, 6)", Y: "array(6, 6)", q: "array(3)", length: "Real") -> "Real":
    """1/(|H| |Y|), moments moved from platform point 1, q away, to the reference point, measured by
    `length`."""
    A = blank(array(6, 6))
    B = blank(array(6, 6))
    for j in each(3):
        for i in range(6):
            A[j][i] = H[j][i]
            turned[j,] = q[(j + 1) % 3] * H[(j + 2) % 3][i] - q[(j + 2) % 3] * H[(j + 1) % 3][i]
            A[j + 3][i] = (H[j + 3][i] + turned[j,]) / length
            back[j,] = Y[i][3 + (j + 1) % 3] * q[(j + 2) % 3] - Y[i][3 + (j + 2) % 3] * q[(j + 1) % 3]
            B[i][j] = Y[i][j] - back[j,]
            B[i][j + 3] = Y[i][j + 3] * length
    return 1.0 / norm(A) / norm(B)


def equations_of_pose(
    model: "Model", at: "Motions", shared: "Shared", near: "Integer", D: "array(6)", out: "Equations"
) -> "Integer":
    """The legs and the platform of one pose: D and the platform's equations. Returns a status. `near`: with
    the legs' code path near the joint singularity, legs having been found to be neither at it nor too
    short."""
    leg = blank(LegTerms)
    out.near = near
    out.close = where(near != 0, out.close, 0)
    for j in range(3):
        out.c[j] = shared.c_force[j]
        out.c[j + 3] = shared.c_tip[j]
        out.c_own[j] = 0.0
        out.c_own[j + 3] = 0.0
    for i in range(6):
        if near != 0:
            leg_of_pose_near_singularity(model.platform, model.leg[i], at, shared, leg)
        else:
            leg_of_pose(model.platform, model.leg[i], at, shared, leg)
            status = fault_of(leg.L, leg.k3, leg.reach)
            if status != OK:
                return status
            out.near = where(leg.k3 > NEAR_JOINT_SINGULAR, out.near, 1)
            out.close = where(leg.L > SHORT_SHARE * leg.reach, out.close, 1)
        D[i] = leg.D
        out.L[i] = leg.L
        out.reach[i] = leg.reach
        for j in range(3):
            out.arm[i][j] = leg.arm[j]
            add_leg(i, j)
    return OK


def pose_status(of: "Equations", shared: "Shared", suspect: "Integer") -> "Integer":
    """Status of the platform's equations; `suspect` is 1 if a pivot is small."""
    H = blank(array(6, 6))
    arm = blank(array(6, 3))
    if of.close == 0 and suspect == 0:
        return OK
    for i in range(6):
        for j in range(6):
            H[i][j] = of.H[i][j]
        for j in range(3):
            arm[i][j] = of.arm[i][j]
    return singular_status(H, arm, of.L, of.reach, largest_component(shared.q_1, 0.0))


def solution(of: "Equations", model: "Model", x: "array(6)", Y: "array(6, 6)") -> "Integer":
    """x, and the inverse Y of H, by the solve of the force kernel. Returns 1 for a small pivot, else
    0."""
    columns_of_H = blank(Columns)
    right_side = blank(RightSide)
    blocks = blank(TwoBlocks)
    found = blank(Solution)
    for column in range(7):
        for i in range(6):
            unit = where(i < 3, 1.0, model.per_length)
            for j in range(6):
                columns_of_H.H[i][j] = unit * of.H[i][j]
            columns_of_H.H[i][6] = 0.0
            columns_of_H.H[i][7] = 0.0
            right_side.c[i] = where(column < 6, where(i == column, unit, 0.0), unit * of.c[i])
        compute_two_blocks_pose(model.arm_cube, columns_of_H, right_side, blocks, found)
        if blocks.weak > 0.0:
            compute_pivots_pose(columns_of_H, right_side, found)
        for i in range(6):
            if column < 6:
                Y[i][column] = found.x[i]
            else:
                x[i] = found.x[i]
    return where(found.suspect > 0.0, 1, 0)


def bound_of_pose(
    model: "Model",
    at: "Motions",
    x: "array(6)",
    Y: "array(6, 6)",
    F: "array(6)",
    of: "Equations",
    bound: "array(6)",
) -> None:
    """Bounds the errors of the forces D - x: the effects of the errors of D, c, and H, the error of the
    solution, and the error of the difference. Completes the errors of the platform's equations."""
    shared = blank(Shared)
    leg = blank(LegTerms)
    rows = blank(Rows)
    slopes = blank(Slopes)
    stretch = blank(array(9))
    error = blank(array(LANES))
    R_err = rotation_error(at.R, stretch)
    for i in range(LANES):
        error[i] = 0.0
        CLEARED
    for i in range(6):
        for j in range(3):
            rows.Y_force[j][i] = Y[i][j]
            rows.Y_moment[j][i] = Y[i][j + 3]
    shared_errors(model.platform, at, R_err, rows, 0, slopes, error, shared)
    for j in range(3):
        of.c_err[j] = shared.c_force_err[j]
        of.c_err[j + 3] = shared.c_tip_err[j]
    for i in range(6):
        for j in range(6):
            rows.D_weight[j] = where(i == j, 1.0, 0.0)
            rows.x[j] = x[i]
            for k in range(3):
                rows.Y_arm[k][j] = where(i > 0, rows.Y_moment[k][j], 0.0)
        if of.near != 0:
            leg_errors_near_singularity(
                model.platform, model.leg[i], at, shared, R_err, rows, slopes, error, leg
            )
        else:
            leg_errors(model.platform, model.leg[i], at, shared, R_err, rows, slopes, error, leg)
        for j in range(3):
            of.H_err[j][i] = leg.H_force_err[j]
            of.H_err[j + 3][i] = where(i > 0, leg.H_moment_err[j], 0.0)
            of.c_err[j] = of.c_err[j] + leg.c_force_err[j]
            by_arm = where(i > 0, leg.arm_c_err[j], 0.0)
            of.c_err[j + 3] = of.c_err[j + 3] + leg.c_moment_err[j] + by_arm
    shared_errors(model.platform, at, R_err, rows, 1, slopes, error, shared)
    for i in range(6):
        bound[i] = error[i] + stretch_error(at.R, stretch, R_err, slopes, i)
    solution_error(of, x, Y, bound)
    for i in range(6):
        bound[i] = SLACK * (bound[i] + UNIT * size(F[i]))
        if not bound[i] <= MAX:
            bound[i] = INFINITY


def forces_of_pose(
    model: "Model", at: "Motions", F: "array(6)", bound: "array(6)", rcond: "Pointer(Real)"
) -> "Integer":
    """Forces, bound and reciprocal condition of one pose; the last two may be null. Returns a status."""
    shared = blank(Shared)
    equations = blank(Equations)
    Y = blank(array(6, 6))
    x = blank(array(6))
    D = blank(array(6))
    found = blank(array(6))
    shared_of_pose(model.platform, at, shared)
    status = equations_of_pose(model, at, shared, 0, D, equations)
    if status == OK and equations.near != 0:
        status = equations_of_pose(model, at, shared, 1, D, equations)
    if status == OK:
        suspect = solution(equations, model, x, Y)
        status = pose_status(equations, shared, suspect)
    for i in range(6):
        if status == OK:
            found[i] = D[i] - x[i]
            status = where(size(found[i]) <= MAX, status, NOT_FINITE)
    if status != OK:
        return status
    for i in range(6):
        F[i] = found[i]
    if bound is not None:
        bound_of_pose(model, at, x, Y, F, equations, bound)
    if rcond is not None:
        rcond[0] = reciprocal_condition(equations.H, Y, shared.q_1, model.length)
    return OK
