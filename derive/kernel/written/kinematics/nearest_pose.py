"""Choice of the pose nearest to a guess, in the part of Python that ``read`` reads."""


def flattest(A: "array(6, 7)", x: "array(6)") -> None:
    """Estimate the direction x, of length 1, that changes the lengths least, by inverse iteration."""
    for i in range(6):
        x[i] = 1.0
    for turn in range(3):
        for i in range(6):
            total = x[i]
            for j in range(i):
                total = total - A[j][i] * A[j][6]
            A[i][6] = where(size(A[i][i]) > 0.0, total / A[i][i], 0.0)
        substitute(A, x)
        square = 0.0
        for i in range(6):
            square = square + x[i] * x[i]
        per_norm = where(square > 0.0, 1.0 / sqrt(square), 0.0)
        for i in range(6):
            x[i] = x[i] * per_norm


def cross(x: "array(3)", y: "array(3)", out: "array(3)") -> None:
    """Compute the cross product of x and y."""
    out[0] = x[1] * y[2] - x[2] * y[1]
    out[1] = x[2] * y[0] - x[0] * y[2]
    out[2] = x[0] * y[1] - x[1] * y[0]


def go_beyond(
    robot: "Robot", per_size: "Real", per_longest: "Real", pose: "Pose", legs: "LegsAtPose"
) -> None:
    """Move a pose near the one with the same lengths behind the next singular pose. The step goes along the
    flattest direction, twice as far as the rate of the lengths takes to become 0."""
    x = array(6)
    v = array(3)
    omega = array(3)
    turning = array(3)
    legs_at(robot, pose, per_size, legs)
    reflect(legs.A)
    flattest(legs.A, x)
    for i in range(3):
        v[i] = x[i]
        omega[i] = x[i + 3] * per_size
    square = 0.0
    bent = 0.0
    for i in range(6):
        leg = vectors_of(robot.leg[i], pose)
        cross(omega, leg.q, turning)
        rate = 0.0
        speed = 0.0
        inward = 0.0
        around = 0.0
        along = 0.0
        for j in range(3):
            moving = v[j] + turning[j]
            rate = rate + leg.S[j] * moving
            speed = speed + moving * moving
            around = around + omega[j] * leg.q[j]
        for j in range(3):
            inward = inward + leg.S[j] * leg.q[j]
            along = along + leg.S[j] * omega[j]
        rate = rate / leg.L
        second = (speed - rate * rate + along * around - square_of(omega) * inward) / leg.L
        square = square + rate * rate
        bent = bent + rate * second
    way = where(size(bent) > 0.0, -2.0 * square / bent, 0.0)
    way = where(size(way) <= MAX, way, 0.0)
    for i in range(6):
        x[i] = way * x[i]
    trusted(x, per_size, per_longest, v, omega)
    advance(pose, v, omega, 1)


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


def is_nearest(robot: "Robot", per_size: "Real", away: "Real", legs: "LegsAtPose") -> "Integer":
    """Return 1 if any other pose with the same lengths is farther away than twice a distance, else 0.

    ``away`` is the square of the distance. An estimate of second order, from second
    derivatives at this pose."""
    shortest = legs.L[0]
    arm = 0.0
    for i in range(6):
        shortest = where(legs.L[i] < shortest, legs.L[i], shortest)
        square = 0.0
        for j in range(3):
            square = square + robot.leg[i].p[j] * robot.leg[i].p[j]
        arm = larger(square, arm)
    arm = arm * per_size * per_size
    bend = (1.0 + arm) / shortest + sqrt(arm) * per_size
    return where(bend * bend * away * legs.of_inverse <= 1.0, 1, 0)


def start_of(
    robot: "Robot",
    number: "Integer",
    L: "array(6)",
    per_size: "Real",
    guess: "Pose",
    pose: "Pose",
    legs: "LegsAtPose",
) -> "Integer":
    """Replace ``pose``, the nearest found so far, by the first pose of a search, and return a status. The
    third search starts behind the next singular pose, the others at the guess."""
    if number == 2:
        go_beyond(robot, per_size, per_longest_of(L), pose, legs)
    else:
        for each in numbers(guess):
            pose[each] = guess[each]
    status = legs_at(robot, pose, per_size, legs)
    return status


def pose_of(robot: "Robot", L: "array(6)", guess: "Pose") -> "FoundPose":
    """Return the pose for lengths L that is nearest to a guess, and a status."""
    out = FoundPose()
    legs = LegsAtPose()
    start = Pose()
    pose = Pose()
    squares = array(2)
    length = platform_size(robot)
    per_size = 1.0 / length
    status = first_fault(L, guess)
    for number in numbers(guess):
        start[number] = guess[number]
    near = make_rotation(start.R)
    status = where((status != OK) | (near == 1), status, NOT_CONVERGED)
    going = where(status == OK, 1, 0)
    best = MAX
    for number in numbers(start):
        out.pose[number] = start[number]
    for turn in range(MAX_SEARCHES):
        if anywhere(going == 1):
            for number in numbers(start):
                pose[number] = out.pose[number]
            fault = start_of(robot, turn, L, per_size, start, pose, legs)
            status = where((turn == 0) & (status == OK), fault, status)
            going = where(status == OK, going, 0)
            damping = where(turn == 1, 1e-3, 0.0)
            found = search(robot, L, per_size, damping, pose, legs)
            reflect(legs.A)
            unsettled = is_open(legs)
            fault = where(unsettled == 1, SINGULAR, OK)
            apart(pose, start, squares)
            away = squares[0] + squares[1]
            take = where((going == 1) & (found == 1) & (away < best), 1, 0)
            best = where(take == 1, away, best)
            status = where(take == 1, fault, status)
            for number in numbers(start):
                out.pose[number] = where(take == 1, pose[number], out.pose[number])
            settled = is_nearest(robot, per_size, squares[0] + length * length * squares[1], legs)
            going = where((found == 1) & (settled == 1), 0, going)
        else:
            break
    status = where((status == OK) & (best >= MAX), NOT_CONVERGED, status)
    out.status = status
    return out
