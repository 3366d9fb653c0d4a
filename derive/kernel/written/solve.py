"""Linear systems of six equations, and whether H is singular to rounding."""


def eliminate(A: "array(6, 7)", x: "array(6)") -> "Integer":
    """Solves [H | c] for x by elimination with partial pivoting, (36); returns 1 where a pivot is small."""
    suspect = 0
    elimination()
    return suspect


def singular_status(H: "array(6, 6)", arm: "array(6, 3)", L: "array(6)", reach: "array(6)") -> "Integer":
    """Whether H is singular to rounding: OK, SINGULAR or NOT_FINITE; H is replaced.

    arm: of the moments; L: lengths of the legs; reach: size of the vectors that a leg is the sum of. The
    direction s of a leg errs by 4 epsilon (reach / L + 2) at most, its column of H, (s, arm x s), by that
    through Y_force + Y_moment x arm with Y the inverse of H, and by the rounding of the moment. Where H less
    its error is singular, no v > 0 has G v < v, G_ik what the error of column k does to row i of Y H: the
    spectral radius of G is 1 or more. Powers of G make v; 1/2 leaves room for the errors of Y itself.
    """
    Y = array(6, 6)
    G = array(6, 6)
    v = array(6)
    grown = array(6)
    extent = 0.0
    for i in range(6):
        v[i] = 1.0
        for j in range(3):
            extent = larger(size(arm[i][j]), extent)
    lost = 0.0
    for i in range(6):
        for j in range(6):
            lost = lost + 0.0 * H[i][j]
            H[i][j] = where(i < 3, H[i][j], H[i][j] / extent)
            Y[i][j] = where(i == j, 1.0, 0.0)
    for k in range(6):
        for i in range(k + 1, 6):
            larger_below = size(H[i][k]) > size(H[k][k])
            for j in range(6):
                upper_h = H[k][j]
                upper_y = Y[k][j]
                H[k][j] = where(larger_below, H[i][j], H[k][j])
                Y[k][j] = where(larger_below, Y[i][j], Y[k][j])
                H[i][j] = where(larger_below, upper_h, H[i][j])
                Y[i][j] = where(larger_below, upper_y, Y[i][j])
        for i in range(6):
            factor = where(i == k, 0.0, H[i][k] / H[k][k])
            for j in range(6):
                H[i][j] = H[i][j] - factor * H[k][j]
                Y[i][j] = Y[i][j] - factor * Y[k][j]
    for i in range(6):
        by_moment = size(Y[i][3]) + size(Y[i][4]) + size(Y[i][5])
        for k in range(6):
            x = size(Y[i][0] + (Y[i][4] * arm[k][2] - Y[i][5] * arm[k][1]) / extent)
            y = size(Y[i][1] + (Y[i][5] * arm[k][0] - Y[i][3] * arm[k][2]) / extent)
            z = size(Y[i][2] + (Y[i][3] * arm[k][1] - Y[i][4] * arm[k][0]) / extent)
            turned = (x + y + z) * (reach[k] / L[k] + 2.0) + 2.0 * by_moment
            G[i][k] = turned * (4.0 * EPSILON) / size(H[i][i])
    least = 1.0
    for turn in range(4):
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
    return where(lost == 0.0, where(least <= 0.5, OK, SINGULAR), NOT_FINITE)


def solve_definite(A: "array(6, WIDTH)", kept: "Real") -> "Integer":
    """Solves the rows [M | Y] for X, left in place of Y, by L D L^T.

    INDEFINITE where a pivot is not more than ``kept`` of its diagonal number.
    """
    scale = blank(array(6))
    inverse = blank(array(6))
    status = OK
    for k in range(6):
        scale[k] = A[k][k]
    for k in range(6):
        fault = where(size(A[k][k]) <= MAX, INDEFINITE, NOT_FINITE)
        fault = where(A[k][k] > kept * scale[k], OK, fault)
        status = where(status == OK, fault, status)
        inverse[k] = 1.0 / A[k][k]
        clear_below_WIDTH(A, k, inverse[k])
    substitute_back_WIDTH(A, inverse)
    return status


def solve_pivoted(A: "array(6, WIDTH)") -> "Integer":
    """Solves the rows [H | Y] for X, left in place of Y, by elimination with partial pivoting; returns 1
    where a pivot is small."""
    inverse = blank(array(6))
    suspect = 0
    for k in range(6):
        pivot = k
        most = size(A[k][k])
        for i in range(k + 1, 6):
            entry = size(A[i][k])
            pivot = where(entry > most, i, pivot)
            most = where(entry > most, entry, most)
        if anywhere(pivot != k):
            for j in columns(WIDTH):
                upper = A[k][j]
                A[k][j] = A[pivot][j]
                A[pivot][j] = upper
        suspect = where(size(A[k][k]) > SUSPECT, suspect, 1)
        inverse[k] = 1.0 / A[k][k]
        clear_below_WIDTH(A, k, inverse[k])
    substitute_back_WIDTH(A, inverse)
    return suspect


def clear_below(A: "array(6, WIDTH)", k: "Integer", inverse: "Real") -> None:
    """Takes row k from those below it so that column k is zero there, which is not stored.

    ``row``: a copy, which no compiler takes for one of those that change.
    """
    row = blank(array(WIDTH))
    for j in columns(WIDTH):
        row[j] = A[k][j]
    for i in range(k + 1, 6):
        factor = A[i][k] * inverse
        for j in columns(WIDTH):
            A[i][j] = A[i][j] - factor * row[j]


def substitute_back(A: "array(6, WIDTH)", inverse: "array(6)") -> None:
    """Back substitution; inverse: of the pivots."""
    row = blank(array(WIDTH))
    for k in reversed(range(6)):
        for j in columns(6, WIDTH):
            row[j] = A[k][j] * inverse[k]
            A[k][j] = row[j]
        for i in range(k):
            factor = A[i][k]
            for j in columns(6, WIDTH):
                A[i][j] = A[i][j] - factor * row[j]
