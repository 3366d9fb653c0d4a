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
        cross(omega, legs.leg[i].q, turning)
        cross(omega, turning, bending)
        rate = 0.0
        second = 0.0
        for j in range(3):
            moving = v[j] + turning[j]
            rate = rate + legs.leg[i].S[j] * moving
            second = second + moving * moving + legs.leg[i].S[j] * bending[j]
        per_L = 1.0 / legs.leg[i].L
        rate = rate * per_L
        second = (second - rate * rate) * per_L
        square = square + rate * rate
        bent = bent + rate * second
    way = where(size(bent) > 0.0, -2.0 * square / bent, 0.0)
    way = where(size(way) <= MAX, way, 0.0)
    for i in range(6):
        x[i] = way * x[i]


def bend_of(per_size: "Real", legs: "LegsAtPose") -> "Real":
    """Estimate the rate of J at a pose (1/m), from the shortest leg and the size of the platform."""
    shortest = legs.leg[0].L
    for i in range(1, 6):
        shortest = where(legs.leg[i].L < shortest, legs.leg[i].L, shortest)
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


def pass_over(L: "array(6)", per_size: "Real", away: "Real", pose: "Pose", legs: "LegsAtPose") -> "Integer":
    """Move a pose, with its triangle, behind the next singular pose. Return 1 if the step is shorter than
    sqrt(6) times the distance of the nearest pose found from the guess, else 0."""
    x = array(6)
    along = array(3)
    turn = array(3)
    step_beyond(legs, per_size, x)
    for i in range(3):
        along[i] = x[i]
        turn[i] = x[i + 3] * per_size
    hopeful = where(square_of(along) + square_of(turn) >= 6.0 * away, 0, 1)
    if anywhere(hopeful == 1):
        trusted(x, per_size, per_longest_of(L), along, turn)
        advance(pose, along, turn, 0.5, 1)
    return hopeful


def measure(robot: "Robot", per_size: "Real", pose: "Pose", legs: "LegsAtPose") -> None:
    """Compute the triangle of J at a pose."""
    legs_at(robot, pose, legs)
    rows_at(legs, per_size)
    reflect(legs.A)
    is_open(legs, 1.0)


def start_of(
    number: "Integer",
    L: "array(6)",
    per_size: "Real",
    nearest: "NearestPose",
    pose: "Pose",
    legs: "LegsAtPose",
) -> "Integer":
    """Replace ``pose``, the nearest found so far, by the first pose of a search. The third search starts
    behind the next singular pose, the others at the guess. Return 1 if the search may find a nearer pose."""
    hopeful = 1
    if number == 2:
        hopeful = pass_over(L, per_size, nearest.away, pose, legs)
    else:
        for each in numbers(pose):
            pose[each] = nearest.guess[each]
    return hopeful


def pose_of(robot: "Robot", L: "array(6)", guess: "Pose") -> "FoundPose":
    """Return the pose for lengths L that is nearest to a guess, and a status."""
    out = FoundPose()
    legs = LegsAtPose()
    nearest = NearestPose()
    pose = Pose()
    squares = array(2)
    per_size = 1.0 / platform_size(robot)
    legs.extent = extent_of(robot)
    status = first_fault(L, guess)
    for number in numbers(guess):
        pose[number] = guess[number]
    near = make_rotation(pose.R)
    status = where((status != OK) | (near == 1), status, NOT_CONVERGED)
    going = where(status == OK, 1, 0)
    nearest.away = MAX
    straight = 0
    measured = 1
    for number in numbers(pose):
        nearest.guess[number] = pose[number]
        nearest.pose[number] = pose[number]
    for turn in range(MAX_SEARCHES):
        active = where((turn == 1) & (straight == 1), 0, going)
        if anywhere((turn == 2) & (active == 1) & (measured == 0)):
            for number in numbers(pose):
                pose[number] = nearest.pose[number]
            measure(robot, per_size, pose, legs)
        if anywhere(active == 1):
            hopeful = start_of(turn, L, per_size, nearest, pose, legs)
            active = where(hopeful == 1, active, 0)
        if anywhere(active == 1):
            fault = legs_at(robot, pose, legs)
            status = where((turn == 0) & (status == OK), fault, status)
            active = where(status == OK, active, 0)
            found = search(robot, L, per_size, turn, nearest, pose, legs)
            measured = 0
            straight = 0
            going = where(status == OK, going, 0)
            if anywhere(found == 1):
                bend = bend_of(per_size, legs)
                flat = 1.0 / (bend * bend)
                unsettled = settle(per_size, flat, legs)
                basin = flat * per_size * per_size / legs.of_inverse
                apart(pose, nearest.guess, squares)
                away = squares[0] + squares[1]
                take = where((active == 1) & (away < nearest.away), found, 0)
                nearest.away = where(take == 1, away, nearest.away)
                nearest.basin = where(take == 1, basin, nearest.basin)
                for number in numbers(pose):
                    nearest.pose[number] = where(take == 1, pose[number], nearest.pose[number])
                fault = where(unsettled == 1, SINGULAR, OK)
                status = where(take == 1, fault, status)
                measured = take
                straight = where(found == 1, legs.straight, 0)
                certain = where(per_size * per_size * squares[0] + squares[1] <= basin, found, 0)
                going = where(((active == 1) & (certain == 1)) | (status != OK), 0, going)
    for number in numbers(pose):
        out.pose[number] = nearest.pose[number]
    status = where((status == OK) & (nearest.away >= MAX), NOT_CONVERGED, status)
    out.status = status
    return out
