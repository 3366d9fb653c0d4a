"""Results of the closed form in C from its sums, for one pose or eight poses, as written functions.

``lanes`` is the number of poses whose values of a number are consecutive in an array: 1 or 8. One text for
both gives identical rounding.
"""


def equations(model: "Model", motion: "Motion", out: "Result") -> "Integer":
    """Equations of motion of one pose."""
    legs = blank(Legs)
    number = blank(array(ALL))
    none = blank(array(LANES))
    if MISSING:
        return BAD_ARGUMENT
    sums(model, motion, legs, number[FIRST:])
    if legs.status != OK:
        return legs.status
    for leg in range(6):
        TAKEN
    matrices(motion.v[0:], motion.omega[0:], 1, number)
    for i in range(RESULTS, ALL):
        number[i] = 0.0
    not_finite(number, ALL / 8, none)
    if none[0] + none[1] + none[2] + none[3] + none[4] + none[5] + none[6] + none[7] != 0.0:
        return NOT_FINITE
    COPIED
    return OK


def matrices(
    v: "Pointer(Real)", omega: "Pointer(Real)", lanes: "Integer", number: "alone(Pointer(Real))"
) -> None:
    """M from its parts, and the bias."""
    for l in range(lanes):
        SYMMETRIC
    for i in range(6):
        for l in range(lanes):
            total = number[(G + i) * lanes + l]
            for j in each(3):
                total = total + number[(C + 6 * i + j) * lanes + l] * v[j * lanes + l]
                total = total + number[(C + 6 * i + j + 3) * lanes + l] * omega[j * lanes + l]
            number[(BIAS + i) * lanes + l] = total
            number[(WITH_FRICTION + i) * lanes + l] = total + number[(FRICTION + i) * lanes + l]


def not_finite(number: "alone(Pointer(Real))", count: "Integer", none: "alone(array(LANES))") -> None:
    """Zero for each lane; not zero if one of ``count`` numbers of a lane is not finite."""
    for l in range(LANES):
        none[l] = 0.0
    for i in range(count):
        for l in range(LANES):
            none[l] = none[l] + 0.0 * number[LANES * i + l]


def bias_and_friction(model: "Model", motion: "Motion", out: "array(6)") -> "Integer":
    """Bias of one pose, with friction."""
    legs = blank(Legs)
    number = blank(array(6))
    none = 0.0
    if MISSING:
        return BAD_ARGUMENT
    sums(model, motion, legs, number)
    if legs.status != OK:
        return legs.status
    for i in range(6):
        none = none + 0.0 * number[i]
    if none != 0.0:
        return NOT_FINITE
    for i in range(6):
        out[i] = number[i]
    return OK


# ---------------------------------------------------------------- forward dynamics


def solve_inertia(
    number: "alone(Pointer(Real))",
    lanes: "Integer",
    result: "alone(Pointer(Real))",
    pivot: "alone(Pointer(Real))",
) -> None:
    """Accelerations from M and the right side, by L D L^T, and the pivots."""
    for l in range(lanes):
        definite_six()
        for k in each(6):
            result[lanes * k + l] = x[k,]


def accelerations_of(legs: "Legs", summed: "array(COUNT)", out: "Found") -> None:
    """The accelerations of a pose; MASS_MATRIX_INDEFINITE if elimination loses too many digits of M."""
    pivot = blank(array(6))
    out.status = legs.status
    if legs.status == OK:
        solve_inertia(summed, 1, out.acceleration, pivot)
        for k in each(6):
            if out.status == OK and not pivot[k] > KEPT * inertia[k, k]:
                out.status = where(size(pivot[k]) <= MAX, MASS_MATRIX_INDEFINITE, NOT_FINITE)


# ---------------------------------------------------------------- derivatives


def derivatives(model: "Model", motion: "Motion", out: "Result") -> "Integer":
    """Derivatives of one pose."""
    legs = blank(Legs)
    number = blank(array(ALL))
    F = blank(array(6))
    if MISSING:
        return BAD_ARGUMENT
    status = kernel_forces(model, motion, F)
    if status != OK:
        return status
    for i in range(6):
        legs.F[i] = F[i]
    sums(model, motion, legs, number)
    if legs.status != OK:
        return legs.status
    for leg in range(6):
        TAKEN
    number[ALL - 2] = 0.0
    number[ALL - 1] = 0.0
    return slopes(model.per_length, number, F, out)


def slopes(per_length: "Real", number: "Pointer(Real)", F: "Pointer(Real)", out: "Result") -> "Integer":
    """Derivatives of F from H and the derivatives of the wrench: rows [H | by pose | by twist | M]."""
    row = blank(pointers(6))
    table = blank(array(TABLE))
    inverse = blank(array(6))
    X = blank(array(6, 24))
    none = blank(array(LANES))
    for i in range(6):
        row[i] = table[ROW * i :]
        for j in range(LANES):
            row[i][j] = number[H + 6 * i + j]
            row[i][j + 8] = number[BY_POSE + 6 * i + j]
            row[i][j + 16] = number[BY_TWIST + 6 * i + j]
            row[i][j + 24] = 0.0
    place_inertia_40(number[M_VV:], number[M_VW:], number[M_WW:], 24, table)
    if per_length != 1.0:
        for i in range(3, 6):
            for j in range(32):
                row[i][j] = row[i][j] * per_length
    factored(row, inverse)
    back(row, inverse, X)
    not_finite(X[0], 18, none)
    if none[0] + none[1] + none[2] + none[3] + none[4] + none[5] != 0.0:
        return NOT_FINITE
    for i in range(6):
        out.F[i] = F[i]
        for j in range(6):
            out.by_pose[6 * i + j] = X[i][j]
            out.by_twist[6 * i + j] = X[i][j + 8]
            out.by_acceleration[6 * i + j] = X[i][j + 16]
    return OK


def factored(row: "pointers(6)", inverse: "array(6)") -> None:
    """Elimination with partial pivoting, (36), of the first columns; rows are exchanged by addresses."""
    upper = blank(array(LANES))
    for k in range(6):
        pivot = k
        most = size(row[k][k])
        for i in range(k + 1, 6):
            entry = size(row[i][k])
            pivot = where(entry > most, i, pivot)
            most = where(entry > most, entry, most)
        moved = row[k]
        row[k] = row[pivot]
        row[pivot] = moved
        inverse[k] = 1.0 / row[k][k]
        for j in range(LANES):
            upper[j] = row[k][j]
        for i in range(k + 1, 6):
            factor = row[i][k] * inverse[k]
            row[i][32 + k] = factor
            for j in range(LANES):
                row[i][j] = row[i][j] - factor * upper[j]


def back(row: "pointers(6)", inverse: "array(6)", X: "alone(array(6, 24))") -> None:
    """The other columns, and back substitution."""
    for j in range(24):
        for i in each(6):
            y[i,] = row[i][j + 8]
        for k in each(6):
            for i in each(k + 1, 6):
                y[i,] = y[i,] - row[i][k + 32] * y[k,]
        for k in each(5, -1, -1):
            y[k,] = y[k,] * inverse[k]
            for i in each(k):
                y[i,] = y[i,] - row[i][k] * y[k,]
        for i in each(6):
            X[i][j] = y[i,]
