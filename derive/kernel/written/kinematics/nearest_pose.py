"""Choice of the pose nearest to a guess as a written function."""


def flattest(legs: "LegsAtPose", x: "array(6)") -> None:
    """Estimate the direction x that changes the lengths least, by inverse iteration."""
    y = array(6)
    shrink = 1.0 / legs.of_inverse
    for i in range(6):
        x[i] = 1.0
    for turn in range(3):
        for k in range(6):
            total = legs.A[k][6] * x[k]
            for i in range(k):
                total = total + legs.A[k][i] * x[i]
            y[k] = total * shrink
        for i in range(6):
            total = legs.A[i][6] * y[i]
            for k in range(i + 1, 6):
                total = total + legs.A[k][i] * y[k]
            x[i] = total


def cross(x: "array(3)", y: "array(3)", out: "array(3)") -> None:
    """Compute the cross product of x and y."""
    out[0] = x[1] * y[2] - x[2] * y[1]
    out[1] = x[2] * y[0] - x[0] * y[2]
    out[2] = x[0] * y[1] - x[1] * y[0]


def step_beyond(legs: "LegsAtPose", per_size: "Real", x: "array(6)") -> None:
    """Estimate the step x to the pose with the same lengths behind the next singular pose. It goes along the
    flattest direction, twice as far as the rate of the lengths takes to become 0."""
    q = array(3)
    v = array(3)
    omega = array(3)
    turning = array(3)
    bending = array(3)
    flattest(legs, x)
    for i in range(3):
        v[i] = x[i]
        omega[i] = x[i + 3] * per_size
    square = 0.0
    bent = 0.0
    for i in range(6):
        for j in range(3):
            q[j] = legs.q[i][j]
        cross(omega, q, turning)
        cross(omega, turning, bending)
        rate = 0.0
        second = 0.0
        for j in range(3):
            moving = v[j] + turning[j]
            rate = rate + legs.S[i][j] * moving
            second = second + moving * moving + legs.S[i][j] * bending[j]
        per_L = 1.0 / legs.L[i]
        rate = rate * per_L
        second = (second - rate * rate) * per_L
        square = square + rate * rate
        bent = bent + rate * second
    way = where(size(bent) > 0.0, -2.0 * square / bent, 0.0)
    way = where(size(way) <= MAX, way, 0.0)
    for i in range(6):
        x[i] = way * x[i]


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


def bend_of(per_size: "Real", legs: "LegsAtPose") -> "Real":
    """Estimate the rate of J at a pose (1/m), from the shortest leg and the size of the platform."""
    shortest = legs.L[0]
    for i in range(1, 6):
        shortest = where(legs.L[i] < shortest, legs.L[i], shortest)
    return 2.0 / shortest + per_size


def settle(per_size: "Real", flat: "Real", legs: "LegsAtPose") -> "Integer":
    """Return 1 if the lengths do not determine the pose that a search found, else 0. The triangle before the
    last step suffices if this step hardly changed J; ``flat`` is 1 over the square of the rate of J."""
    unsettled = is_open(legs, 4.0)
    redo = where(4096.0 * legs.last * legs.of_inverse <= flat, unsettled, 1)
    if anywhere(redo == 1):
        rows_at(legs, per_size)
        reflect(legs.A)
        unsettled = is_open(legs, 1.0)
    return unsettled


def pass_over(
    robot: "Robot",
    L: "array(6)",
    per_size: "Real",
    best: "Real",
    start: "Pose",
    pose: "Pose",
    legs: "LegsAtPose",
) -> "Integer":
    """Move a pose, with its triangle, behind the next singular pose. Return 1 if the pose there is estimated
    to be less than sqrt(2) times as far from the guess as the nearest pose found, else 0."""
    x = array(6)
    along = array(3)
    turn = array(3)
    squares = array(2)
    there = Pose()
    step_beyond(legs, per_size, x)
    for i in range(3):
        along[i] = x[i]
        turn[i] = x[i + 3] * per_size
    hopeful = where(square_of(along) + square_of(turn) >= 6.0 * best, 0, 1)
    if anywhere(hopeful == 1):
        for number in numbers(pose):
            there[number] = pose[number]
        advance(there, along, turn, 1)
        apart(there, start, squares)
        hopeful = where(squares[0] + squares[1] >= 2.0 * best, 0, hopeful)
        trusted(x, per_size, per_longest_of(L), along, turn)
        advance(pose, along, turn, 1)
    return hopeful


def measure(robot: "Robot", per_size: "Real", pose: "Pose", legs: "LegsAtPose") -> None:
    """Compute the triangle of J at a pose."""
    legs_at(robot, pose, legs)
    rows_at(legs, per_size)
    reflect(legs.A)
    is_open(legs, 1.0)


def is_straight(away: "Real", legs: "LegsAtPose") -> "Integer":
    """Return 1 if the steps of a search shrank by halves, and the first one was 0.7 to 1.4 times as long as
    the way to the result, else 0. ``away`` is the square of the way (m^2)."""
    least = 0.5 * away
    most = 2.0 * away
    return where((legs.first >= least) & (legs.first <= most), legs.straight, 0)


def start_of(
    robot: "Robot",
    number: "Integer",
    L: "array(6)",
    per_size: "Real",
    best: "Real",
    start: "Pose",
    pose: "Pose",
    legs: "LegsAtPose",
) -> "Integer":
    """Replace ``pose``, the nearest found so far, by the first pose of a search. The third search starts
    behind the next singular pose, the others at the guess. Return 1 if the search may find a nearer pose."""
    hopeful = 1
    if number == 2:
        hopeful = pass_over(robot, L, per_size, best, start, pose, legs)
    else:
        for each in numbers(start):
            pose[each] = start[each]
    return hopeful


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
    straight = 0
    measured = 1
    for number in numbers(start):
        out.pose[number] = start[number]
    for turn in range(MAX_SEARCHES):
        active = where((turn == 1) & (straight == 1), 0, going)
        if anywhere((turn == 2) & (active == 1) & (measured == 0)):
            for number in numbers(start):
                pose[number] = out.pose[number]
            measure(robot, per_size, pose, legs)
        if anywhere(active == 1):
            hopeful = start_of(robot, turn, L, per_size, best, start, pose, legs)
            active = where(hopeful == 1, active, 0)
        if anywhere(active == 1):
            fault = legs_at(robot, pose, legs)
            status = where((turn == 0) & (status == OK), fault, status)
            active = where(status == OK, active, 0)
            damping = where(turn == 1, 1e-3, 0.0)
            found = search(robot, L, per_size, damping, pose, legs)
            bend = bend_of(per_size, legs)
            flat = 1.0 / (bend * bend)
            unsettled = settle(per_size, flat, legs)
            fault = where(unsettled == 1, SINGULAR, OK)
            apart(pose, start, squares)
            away = squares[0] + squares[1]
            take = where((active == 1) & (found == 1) & (away < best), 1, 0)
            best = where(take == 1, away, best)
            status = where(take == 1, fault, status)
            for number in numbers(start):
                out.pose[number] = where(take == 1, pose[number], out.pose[number])
            measured = take
            away = squares[0] + length * length * squares[1]
            straight = is_straight(away, legs)
            bound = away * legs.of_inverse
            farthest = 512.0 * flat
            straight = where((found == 1) & (bound <= farthest), straight, 0)
            going = where(status == OK, going, 0)
            going = where((active == 1) & (found == 1) & (bound <= flat), 0, going)
    status = where((status == OK) & (best >= MAX), NOT_CONVERGED, status)
    out.status = status
    return out
