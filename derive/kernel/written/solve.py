"""Linear systems of six equations, the test for singular H, and the scaling of moments, as functions."""


def eliminate(A: "array(6, 7)", x: "array(6)") -> "Integer":
    """Solves H x = c for x by elimination with partial pivoting, (36). Returns 1 if a pivot is small."""
    if HAS_INVERSE:
        inverse = blank(array(6))
    suspect = 0
    elimination()
    return suspect


def singular_status(
    H: "array(6, 6)", arm: "array(6, 3)", L: "array(6)", reach: "array(6)", tip: "Real"
) -> "Integer":
    """Returns SINGULAR if H is singular to rounding, NOT_FINITE, or OK; H is overwritten.

    arm (m): moment arms; L (m): lengths of the legs; reach (m): largest component of the vectors whose sum is
    a leg. tip (m): largest component of the platform point from which the arms are measured, 0 for the
    reference point.

    Let Y be the inverse of H. The error of the direction s of a leg is at most 4 epsilon (reach / L + 2).
    Each input and each operation is rounded by half a unit, and the elimination adds its own error.
    This error changes the column (s, arm x s) of H, and Y_force + Y_moment x arm is its factor for any center
    of moments. The rounding of the moment is added.

    G_ik bounds the effect of the error of column k on row i of Y H. If H minus its error is singular, no v >
    0 satisfies G v < v, and the spectral radius of G is at least 1. v is computed by powers of G. The limit
    1/2 covers the errors of Y.
    """
    Y = blank(array(6, 6))
    G = blank(array(6, 6))
    v = blank(array(6))
    grown = blank(array(6))
    extent = tip
    least = 1.0
    if CARRIED:
        status = OK
    for i in range(6):
        v[i] = 1.0
        for j in range(3):
            extent = larger(size(arm[i][j]), extent)
    for i in range(6):
        for j in range(6):
            reject(size(H[i][j]) <= MAX, NOT_FINITE)
            H[i][j] = where(i < 3, H[i][j], H[i][j] / extent)
            Y[i][j] = where(i == j, 1.0, 0.0)
    elimination()
    for i in range(6):
        by_moment = size(Y[i][3]) + size(Y[i][4]) + size(Y[i][5])
        for k in range(6):
            x = size(Y[i][0] + (Y[i][4] * arm[k][2] - Y[i][5] * arm[k][1]) / extent)
            y = size(Y[i][1] + (Y[i][5] * arm[k][0] - Y[i][3] * arm[k][2]) / extent)
            z = size(Y[i][2] + (Y[i][3] * arm[k][1] - Y[i][4] * arm[k][0]) / extent)
            turned = (x + y + z) * (reach[k] / L[k] + 2.0) + 2.0 * by_moment
            G[i][k] = turned * (4.0 * EPSILON) / size(H[i][i])
    for turn in range(4):
        if anywhere(least > 0.5):
            worst = 0.0
            greatest = 0.0
            for i in range(6):
                total = 0.0
                for k in range(6):
                    total = total + G[i][k] * v[k]
                share = total / v[i]
                worst = where(share <= worst, worst, share)
                greatest = larger(total, greatest)
                grown[i] = total
            least = where(worst <= least, worst, least)
            for i in range(6):
                v[i] = larger(grown[i] / greatest, EPSILON)
        else:
            break
    reject(least <= 0.5, SINGULAR)
    return status if CARRIED else OK


def rows_status(
    A: "array(6, LANES)", q: "array(3, LANES)", L: "array(LANES)", reach: "array(LANES)", per_length: "Real"
) -> "Integer":
    """Returns the status of a pose whose H may be singular to rounding."""
    H = blank(array(6, 6))
    arm = blank(array(6, 3))
    tip = 0.0
    if ABOUT_TIP:
        for j in range(3):
            tip = larger(size(q[j][0]), tip)
    for i in range(6):
        for j in range(3):
            arm[i][j] = q[j][i] - q[j][0] if ABOUT_TIP else q[j][i]
            H[j][i] = A[j][i]
            H[j + 3][i] = A[j + 3][i] / per_length
    return singular_status(H, arm, L, reach, tip)


def solve_definite(A: "array(6, WIDTH)", kept: "Real") -> "Integer":
    """Solves the rows [M | Y] for X, which replaces Y, by L D L^T.

    Returns MASS_MATRIX_INDEFINITE if a pivot is at most ``kept`` times its diagonal entry.
    """
    scale = blank(array(6))
    inverse = blank(array(6))
    status = OK
    for k in range(6):
        scale[k] = A[k][k]
    elimination()
    return status


def solve_pivoted(A: "array(6, WIDTH)") -> "Integer":
    """Solves the rows [H | Y] for X, which replaces Y, by elimination with partial pivoting. Returns 1 if a
    pivot is small."""
    inverse = blank(array(6))
    suspect = 0
    elimination()
    return suspect


def clear_below(A: "array(6, WIDTH)", k: "Integer", inverse: "Real") -> None:
    """Subtracts multiples of row k from the rows below, so that their column k, which is not stored, is zero.

    ``row`` is a copy, because compilers then know that it differs from the rows that change.
    """
    row = blank(array(WIDTH))
    for j in columns(WIDTH):
        row[j] = A[k][j]
    for i in range(k + 1, 6):
        factor = A[i][k] * inverse
        for j in columns(WIDTH):
            A[i][j] = A[i][j] - factor * row[j]


def substitute_back(A: "array(6, WIDTH)", inverse: "array(6)") -> None:
    """Substitutes back; ``inverse`` contains the reciprocals of the pivots."""
    row = blank(array(WIDTH))
    for k in reversed(range(6)):
        for j in columns(6, WIDTH):
            row[j] = A[k][j] * inverse[k]
            A[k][j] = row[j]
        for i in range(k):
            factor = A[i][k]
            for j in columns(6, WIDTH):
                A[i][j] = A[i][j] - factor * row[j]


def per_length_of(size: "Real", smallest: "Real") -> "Real":
    """Returns the factor (1/m) of moments in the linear solver for arms whose largest coordinate is `size`
    (m). It is 1 from `smallest` to 16 m. Otherwise it is the reciprocal of the smallest power of two, from
    2^-100 to 2^100, that is not below `size`."""
    per_length = 1.0
    if anywhere((size < smallest) | (size > LARGEST)):
        unit = 1.0
        for i in range(100):
            if anywhere(unit < size):
                unit = where(unit < size, 2.0 * unit, unit)
            else:
                break
        for i in range(100):
            if anywhere((size > 0.0) & (0.5 * unit >= size)):
                unit = where((size > 0.0) & (0.5 * unit >= size), 0.5 * unit, unit)
            else:
                break
        per_length = where((size < smallest) | (size > LARGEST), 1.0 / unit, 1.0)
    return per_length


def cube_of(arm: "Real") -> "Real":
    """Returns the cube of a length; lengths above 2^40 are replaced by 2^40 to avoid overflow."""
    length = where(arm <= 1099511627776.0, arm, 1099511627776.0)
    return length * length * length


def solve_legs(A: "array(6, 7)", arm_cube: "Real", x: "array(6)") -> "Integer":
    """Solves [H | c] for x, (36), in two blocks of three legs, or by pivots if their determinants are small.

    Returns 1 if a pivot is small.
    """
    suspect = 0
    two_blocks()
    if anywhere(weak > 0.0):
        other = array(6)
        small = eliminate(A, other)
        for number in range(6):
            x[number] = where(weak > 0.0, other[number], x[number])
        suspect = where(weak > 0.0, small, suspect)
    return suspect


def solve_by_pivots(A: "array(6, 7)", arm_cube: "Real", x: "array(6)") -> "Integer":
    """Solves [H | c] for x, (36), only by pivots, for formulas, in which no determinant has a value."""
    suspect = eliminate(A, x)
    return suspect


def size_of(model: "Model") -> "Real":
    """Returns the largest coordinate (m) of the arms of moments about platform point 1."""
    largest = 0.0
    for j in range(3):
        for i in range(1, 6):
            if BY_LEGS:
                largest = larger(size(model.leg[i].p[j] - model.leg[0].p[j]), largest)
            else:
                largest = larger(size(model.p[j][i] - model.p[j][0]), largest)
    return largest


def scaled_axis(k: "array(3)", out: "array(3)") -> None:
    """Multiplies a fixed axis of any length by a power of two, so that its square does not overflow or
    underflow."""
    for j in range(3):
        out[j] = k[j]
    for i in range(64):
        by = 1.0
        most = size(out[0])
        most = larger(size(out[1]), most)
        most = larger(size(out[2]), most)
        by = where(most > 1048576.0, 1.0 / 4294967296.0, by)
        by = where(most < 1.0 / 1048576.0, 4294967296.0, by)
        for j in range(3):
            out[j] = by * out[j]


def clear_lumped(sum: "Lumped") -> None:
    """Sets the sum over the legs to zero."""
    for number in entries(ADDED):
        sum[number] = 0.0


def add_lumped(sum: "Lumped", more: "Lumped") -> None:
    """Adds the contributions of a leg to the sum."""
    for number in entries(ADDED):
        sum[number] = sum[number] + more[number]


def handed_over() -> None:
    """Writes the model if its numbers are finite."""
    largest = size_of(made)
    made.per_length = per_length_of(largest, SMALLEST)
    made.arm_cube = cube_of(largest * made.per_length)
    numbers = numbers_of(made)
    for i in range(COUNT):
        if not size(numbers[i]) <= MAX:
            return NOT_FINITE
    model = made
    return OK
