"""Inverse kinematics, and the search for the pose of leg lengths, as written functions.

The search applies Newton's method to (2). Each step solves J d = miss by Householder reflections. They do not
change the singular values of J, so that the triangular factor also indicates the distance from a singular
pose. If a step reduces the largest error of the lengths by less than 30 %, a damped search follows. If a
singular pose is near the way, another search starts beyond it. The result nearest to the guess is returned.
"""


def orientation_status(found: "Orientation") -> "Integer":
    """NOT_FINITE where an orientation or its rates are not finite, else OK."""
    status = OK
    for i in range(9):
        status = where(size(found.R[i]) <= MAX, status, NOT_FINITE)
    for i in range(3):
        status = where(size(found.omega[i]) <= MAX, status, NOT_FINITE)
        status = where(size(found.alpha[i]) <= MAX, status, NOT_FINITE)
    return status


def motions_of(robot: "Robot", motion: "Motion") -> "LegMotions":
    """Lengths of the legs, their rates and second rates, their directions and vectors, and a status."""
    out = LegMotions()
    status = OK
    for i in range(6):
        leg = motion_of(robot.leg[i], motion)
        fault = fault_of(leg.L, 1.0, reach_of(robot.leg[i].b, motion.t, leg.q))
        fault = where((fault != OK) | (size(leg.L_dot) <= MAX), fault, NOT_FINITE)
        fault = where((fault != OK) | (size(leg.L_ddot) <= MAX), fault, NOT_FINITE)
        status = where(status == OK, fault, status)
        out.L[i] = leg.L
        out.L_dot[i] = leg.L_dot
        out.L_ddot[i] = leg.L_ddot
        for j in range(3):
            out.s[i][j] = leg.s[j]
            out.S[i][j] = leg.S[j]
    out.status = status
    return out


def rates_of(robot: "Robot", motion: "Motion", moving: "Integer") -> "LegRates":
    """Lengths of the legs, where ``moving`` is 1 their rates, and a status."""
    out = LegRates()
    pose = Pose()
    status = OK
    for number in numbers(pose):
        pose[number] = motion[number]
    for i in range(6):
        leg = vectors_of(robot.leg[i], pose)
        fault = fault_of(leg.L, 1.0, reach_of(robot.leg[i].b, pose.t, leg.q))
        out.L[i] = leg.L
        if moving == 1:
            found = rate_of(leg, motion)
            out.L_dot[i] = found.L_dot
            fault = where((fault != OK) | (size(found.L_dot) <= MAX), fault, NOT_FINITE)
        status = where(status == OK, fault, status)
    out.status = status
    return out


def inverse_kinematics(robot: "Robot", motion: "Motion") -> "LegRates":
    """Lengths of the legs, (2), their rates, (5), and a status."""
    found = rates_of(robot, motion, 1)
    for i in range(6):
        found.L[i] = where(found.status == OK, found.L[i], NAN)
        found.L_dot[i] = where(found.status == OK, found.L_dot[i], NAN)
    return found


def legs_at(robot: "Robot", pose: "Pose", legs: "LegsAtPose") -> "Integer":
    """Vectors and lengths of the legs at a pose; returns a status."""
    status = OK
    legs.reach = largest_component(pose.t, legs.extent)
    for i in range(6):
        legs.leg[i] = vectors_of(robot.leg[i], pose)
        fault = fault_of(legs.leg[i].L, 1.0, legs.reach)
        status = where(status == OK, fault, status)
    return status


def rows_at(legs: "LegsAtPose", per_size: "Real") -> None:
    """Compute J of the legs at a pose."""
    for i in range(6):
        row = row_of(legs.leg[i])
        for j in range(3):
            legs.A[i][j] = row.H_force[j]
            legs.A[i][j + 3] = row.H_moment[j] * per_size


def square_of(vector: "array(3)") -> "Real":
    """Return the square of a vector's length."""
    return vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]


def extent_of(robot: "Robot") -> "Real":
    """Return the largest distance of a joint from the origin of its part (m)."""
    square = 0.0
    for i in range(6):
        square = larger(square_of(robot.leg[i].b), square)
        square = larger(square_of(robot.leg[i].p), square)
    return sqrt(square)


def platform_size(robot: "Robot") -> "Real":
    """Root mean square distance of the platform points from the reference point, by which moments are
    measured, m; 1 if they lie in it."""
    total = 0.0
    for i in range(6):
        for j in range(3):
            total = total + robot.leg[i].p[j] * robot.leg[i].p[j]
    extent = sqrt(total / 6.0)
    return where(extent > SHORTEST, extent, 1.0)


def reflect(A: "array(6, 7)") -> None:
    """Makes a triangle of [J | right side] by Householder's reflections. Its diagonal holds reciprocals, or 0
    where the entry is 0."""
    for k in range(6):
        square = 0.0
        for i in range(k, 6):
            square = square + A[i][k] * A[i][k]
        norm = sqrt(square)
        diagonal = where(A[k][k] > 0.0, -norm, norm)
        first = A[k][k] - diagonal
        factor = where(square > 0.0, 1.0 / (diagonal * first), 0.0)
        A[k][k] = first
        for j in range(k + 1, 7):
            total = 0.0
            for i in range(k, 6):
                total = total + A[i][k] * A[i][j]
            total = total * factor
            for i in range(k, 6):
                A[i][j] = A[i][j] + total * A[i][k]
        A[k][k] = factor * first


def substitute(A: "array(6, 7)", x: "array(6)") -> "Real":
    """Compute x of the triangle's equations, the last first, or 0 where the diagonal entry is 0. Return the
    square of the size of x."""
    square = 0.0
    for i in reversed(range(6)):
        total = A[i][6]
        # The number that was computed last comes last.
        for back in range(5 - i):
            total = total - A[i][5 - back] * x[5 - back]
        x[i] = total * A[i][i]
        square = square + x[i] * x[i]
    return square


def is_open(legs: "LegsAtPose", factor: "Real") -> "Integer":
    """1 where the triangle's condition number, by Frobenius norms, exceeds 1 / (16 sqrt(eps)), else 0. Two
    poses with the same lengths meet where H is singular, and sqrt(eps) from there they differ by
    rounding: lengths known to rounding leave the pose open. ``factor`` multiplies the square of the condition
    number. Stores |J^-1|^2 in ``legs``."""
    total = 0.0
    of_inverse = 0.0
    regular = 1
    for k in range(6):
        pivot = legs.A[k][k]
        regular = where(size(pivot) > 0.0, regular, 0)
        legs.A[k][6] = pivot
        total = total + where(size(pivot) > 0.0, 1.0 / (pivot * pivot), 0.0)
        of_inverse = of_inverse + pivot * pivot
        for back in range(k):
            corner = legs.A[k - 1 - back][k]
            entry = corner * pivot
            for j in range(k - back, k):
                entry = entry + legs.A[k - 1 - back][j] * legs.A[k][j]
            entry = -entry * legs.A[k - 1 - back][k - 1 - back]
            legs.A[k][k - 1 - back] = entry
            total = total + corner * corner
            of_inverse = of_inverse + entry * entry
    legs.of_inverse = of_inverse
    square = 256.0 * EPSILON * factor * total * of_inverse
    return where((regular == 1) & (square <= 1.0), 0, 1)


def polish(R: "array(9)", half: "Real") -> "Real":
    """One of Newton's steps toward the rotation nearest to R, R <- R + R (E - R^T R) / 2, or none where
    ``half`` is 0; returns how far an entry of R^T R was from E."""
    lack = array(9)
    skew = 0.0
    for i in range(3):
        for j in range(i, 3):
            product = R[i] * R[j] + R[3 + i] * R[3 + j] + R[6 + i] * R[6 + j]
            missing = where(i == j, 1.0, 0.0) - product
            skew = larger(size(missing), skew)
            part = half * missing
            lack[3 * i + j] = part
            lack[3 * j + i] = part
    for k in range(3):
        x = R[3 * k]
        y = R[3 * k + 1]
        z = R[3 * k + 2]
        for j in range(3):
            R[3 * k + j] = R[3 * k + j] + (x * lack[j] + y * lack[3 + j] + z * lack[6 + j])
    return skew


def make_rotation(R: "array(9)") -> "Integer":
    """Makes R a rotation to rounding; returns 1 if it was near to one, else 0."""
    first = R[0] * (R[4] * R[8] - R[5] * R[7])
    volume = first + R[1] * (R[5] * R[6] - R[3] * R[8]) + R[2] * (R[3] * R[7] - R[4] * R[6])
    skew = polish(R, 0.5)
    near = 1
    near = where((volume > 0.0) & (skew <= 0.0625), near, 0)
    # The distance is squared each time: 2^-4, 2^-8, down to 2^-64.
    for turn in range(4):
        half = where(skew * skew > EPSILON, 0.5, 0.0)
        if anywhere(half > 0.0):
            skew = polish(R, half)
        else:
            break
    return near


def compare(L: "array(6)", legs: "LegsAtPose") -> "Real":
    """Stores the given lengths minus the lengths of a pose (m) next to J; returns the largest magnitude."""
    worst = 0.0
    for i in range(6):
        miss = L[i] - legs.leg[i].L
        legs.A[i][6] = miss
        worst = larger(size(miss), worst)
    return worst


def damp(A: "array(6, 7)", damping: "Real") -> None:
    """Turn [J | miss] into [J^T J + damping E | J^T miss], the equations of a Levenberg-Marquardt step."""
    J = array(6, 7)
    for i in range(6):
        for j in range(7):
            J[i][j] = A[i][j]
    for i in range(6):
        for j in range(i, 7):
            total = where(i == j, damping, 0.0)
            for k in range(6):
                total = total + J[k][i] * J[k][j]
            A[i][j] = total
        for j in range(i):
            A[i][j] = A[j][i]


def per_longest_of(L: "array(6)") -> "Real":
    """Return 1 over the largest of six lengths (1/m)."""
    longest = L[0]
    for i in range(1, 6):
        longest = larger(L[i], longest)
    return 1.0 / longest


def trusted(
    x: "array(6)", per_size: "Real", per_longest: "Real", along: "array(3)", turn: "array(3)"
) -> None:
    """Split a step x into [along; turn], no longer than 0.4 rad and 0.4 times the longest leg. Beyond this,
    (2) is far from linear. Such steps need no damping: a search that rejects steps loses more poses."""
    for i in range(3):
        along[i] = x[i]
        turn[i] = x[i + 3] * per_size
    # ``larger`` may evaluate its arguments twice.
    way = 6.25 * per_longest * per_longest * square_of(along)
    angle = 6.25 * square_of(turn)
    excess = larger(larger(way, angle), 1.0)
    if anywhere(excess > 1.0):
        shorter = 1.0 / sqrt(excess)
        for i in range(3):
            along[i] = along[i] * shorter
            turn[i] = turn[i] * shorter


def advance(pose: "Pose", along: "array(3)", turn: "array(3)", half: "Real", going: "Integer") -> None:
    """Move a pose by a step if ``going`` is 1, and polish R by ``half``."""
    R = array(9)
    turned = turned_by(turn)
    for i in range(3):
        for j in range(3):
            part = turned.Q[3 * i] * pose.R[j] + turned.Q[3 * i + 1] * pose.R[3 + j]
            R[3 * i + j] = part + turned.Q[3 * i + 2] * pose.R[6 + j]
    if anywhere(half > 0.0):
        polish(R, half)
    for i in range(9):
        pose.R[i] = where(going == 1, R[i], pose.R[i])
    for i in range(3):
        pose.t[i] = where(going == 1, pose.t[i] + along[i], pose.t[i])


def apart(one: "Pose", other: "Pose", squares: "array(2)") -> None:
    """Compute the squares of the distance (m^2) and of the angle (rad^2) between poses."""
    way = 0.0
    chord = 0.0
    for i in range(9):
        gap = one.R[i] - other.R[i]
        chord = chord + gap * gap
    for i in range(3):
        gap = one.t[i] - other.t[i]
        way = way + gap * gap
    # The angle follows from its chord, 2 sin(angle / 2), whose square is half of the sum, by a series.
    chord = 0.5 * chord
    squares[0] = way
    squares[1] = chord * (1.0 + chord * (0.08333333333333333 + 0.011111111111111112 * chord))


def is_futile(nearest: "NearestPose", per_size: "Real", pose: "Pose") -> "Integer":
    """Return 1 if a search at a pose leads to the nearest pose found so far or is farther from the guess."""
    squares = array(2)
    apart(pose, nearest.pose, squares)
    futile = where(per_size * per_size * squares[0] + squares[1] < nearest.basin, 1, 0)
    apart(pose, nearest.guess, squares)
    return where(0.8 * (squares[0] + squares[1]) > nearest.away, 1, futile)


def search(
    robot: "Robot",
    L: "array(6)",
    per_size: "Real",
    number: "Integer",
    nearest: "NearestPose",
    pose: "Pose",
    legs: "LegsAtPose",
) -> "Integer":
    """Step from a pose, with its legs, to lengths L. The first four steps of search 1 are damped. Return 1 if
    a pose with these lengths was found, else 0. ``legs`` keeps the triangle of J before the last step."""
    x = array(6)
    along = array(3)
    turn = array(3)
    per_longest = per_longest_of(L)
    status = OK
    worst = compare(L, legs)
    going = 1
    legs.straight = 1
    legs.last = 1e30
    for step in range(MAX_STEPS):
        going = where(status == OK, going, 0)
        going = where(worst > 4.0 * EPSILON * legs.reach, going, 0)
        if number > 0:
            going = where(is_futile(nearest, per_size, pose) == 1, 0, going)
        if anywhere(going == 1):
            rows_at(legs, per_size)
            damping = where((number == 1) & (step < 4), 1e-3, 0.0)
            if anywhere(damping > 0.0):
                damp(legs.A, damping)
            reflect(legs.A)
            square = substitute(legs.A, x)
            # A damped step has no triangle of J. With 1e30 m^2, ``settle`` computes the triangle.
            square = where(damping > 0.0, 1e30, square)
            legs.last = where(going == 1, square, legs.last)
            trusted(x, per_size, per_longest, along, turn)
            # Far from the result, the rounding errors of R are of no effect.
            half = where(worst > 0.0009765625 * legs.reach, 0.0, 0.5)
            advance(pose, along, turn, half, going)
            # At convergence, rounding errors determine the lengths.
            allowed = larger(0.7 * worst, ROUNDING * legs.reach)
            status = legs_at(robot, pose, legs)
            worst = compare(L, legs)
            legs.straight = where(worst > allowed, 0, legs.straight)
        else:
            break
    return where((status == OK) & (worst <= ROUNDING * legs.reach), 1, 0)


def first_fault(L: "array(6)", guess: "Pose") -> "Integer":
    """Returns the status of the inputs of a search: not finite, or not a length."""
    status = OK
    for i in range(6):
        status = where(size(L[i]) <= MAX, status, NOT_FINITE)
    for number in numbers(guess):
        status = where(size(guess[number]) <= MAX, status, NOT_FINITE)
    for i in range(6):
        status = where((status != OK) | (L[i] > 0.0), status, ZERO_LENGTH)
    return status


def forward_kinematics(robot: "Robot", L: "array(6)", guess: "Pose") -> "FoundPose":
    """Return the pose with leg lengths L (m) nearest to a guess, by up to three searches, and a status."""
    out = pose_of(robot, L, guess)
    for number in numbers(guess):
        out.pose[number] = where(out.status == OK, out.pose[number], NAN)
    return out


def twist_of(robot: "Robot", pose: "Pose", L_dot: "array(6)") -> "Twist":
    """Velocities of the platform that the rates of the legs make, and a status."""
    out = Twist()
    legs = LegsAtPose()
    x = array(6)
    per_size = 1.0 / platform_size(robot)
    legs.extent = extent_of(robot)
    status = legs_at(robot, pose, legs)
    rows_at(legs, per_size)
    for i in range(6):
        legs.A[i][6] = L_dot[i]
    reflect(legs.A)
    substitute(legs.A, x)
    unsettled = is_open(legs, 1.0)
    status = where((status == OK) & (unsettled == 1), SINGULAR, status)
    for i in range(3):
        out.v[i] = x[i]
        out.omega[i] = x[i + 3] * per_size
        status = where((status != OK) | (size(out.v[i]) <= MAX), status, NOT_FINITE)
        status = where((status != OK) | (size(out.omega[i]) <= MAX), status, NOT_FINITE)
    out.status = status
    return out


def forward_velocity(robot: "Robot", pose: "Pose", L_dot: "array(6)") -> "Twist":
    """Velocities of the platform, v and omega, from the rates of the legs, (5), and a status."""
    out = twist_of(robot, pose, L_dot)
    for i in range(3):
        out.v[i] = where(out.status == OK, out.v[i], NAN)
        out.omega[i] = where(out.status == OK, out.omega[i], NAN)
    return out
