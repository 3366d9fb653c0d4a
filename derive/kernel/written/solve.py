"""Linear systems of six equations, and whether H is singular to rounding."""


def eliminate(A: "array(6, 7)", x: "array(6)", least: "Real") -> "Integer":
    """Solves [H | c] for x by elimination with partial pivoting, (36); 1 where a pivot is not above least."""
    suspect = 0
    for k in range(6):
        for i in range(k + 1, 6):
            larger_below = size(A[i][k]) > size(A[k][k])
            for j in range(k, 7):
                upper = A[k][j]
                A[k][j] = where(larger_below, A[i][j], A[k][j])
                A[i][j] = where(larger_below, upper, A[i][j])
        suspect = where(size(A[k][k]) > least, suspect, 1)
        inverse = 1.0 / A[k][k]
        x[k] = inverse
        for i in range(k + 1, 6):
            factor = A[i][k] * inverse
            for j in range(k + 1, 7):
                A[i][j] = A[i][j] - factor * A[k][j]
    for i in reversed(range(6)):
        total = A[i][6]
        for j in range(i + 1, 6):
            total = total - A[i][j] * x[j]
        x[i] = where(i == 5, total / A[i][i], total * x[i])
    return suspect


def singular_status(H: "array(6, 6)", L: "array(6)", reach: "array(6)", arm: "array(6)") -> "Integer":
    """Whether H is singular to rounding: OK, SINGULAR or NOT_FINITE; H is replaced.

    L: lengths of the legs; reach: size of the vectors that a leg is the sum of; arm: size of the arms of the
    moments. If H less its error, in size at most E, is singular, then no v > 0 has |Y| E v < v with Y the
    inverse of H: the spectral radius of |Y| E is 1 or more. Powers of |Y| E make v; 1/2 leaves room for the
    errors of Y itself.
    """
    Y = array(6, 6)
    error = array(6)
    v = array(6)
    grown = array(6)
    extent = 0.0
    for i in range(6):
        extent = larger(arm[i], extent)
        error[i] = 4.0 * EPSILON * (reach[i] / L[i] + 2.0)
        v[i] = 1.0
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
    least = 1.0
    for turn in range(4):
        force = 0.0
        moment = 0.0
        for k in range(6):
            force = force + error[k] * v[k]
            moment = moment + (3.0 * error[k] * arm[k] / extent + 8.0 * EPSILON) * v[k]
        worst = 0.0
        greatest = 0.0
        for i in range(6):
            by_force = 0.0
            by_moment = 0.0
            for j in range(3):
                by_force = by_force + size(Y[i][j])
                by_moment = by_moment + size(Y[i][j + 3])
            grown[i] = (by_force * force + by_moment * moment) / size(H[i][i])
            share = grown[i] / v[i]
            worst = where(share <= worst, worst, share)
            greatest = larger(grown[i], greatest)
        least = where(worst <= least, worst, least)
        for i in range(6):
            v[i] = larger(grown[i] / greatest, EPSILON)
    return where(lost == 0.0, where(least <= 0.5, OK, SINGULAR), NOT_FINITE)


def solve_definite(M: "array(6, 6)", x: "array(6)", kept: "Real") -> "Integer":
    """x of M x = x by L D L^T; INDEFINITE where a pivot is not more than ``kept`` of its diagonal number."""
    scale = array(6)
    status = OK
    for k in range(6):
        scale[k] = M[k][k]
    for k in range(6):
        fault = where(size(M[k][k]) <= MAX, INDEFINITE, NOT_FINITE)
        fault = where(M[k][k] > kept * scale[k], OK, fault)
        status = where(status == OK, fault, status)
        inverse = 1.0 / M[k][k]
        for i in range(k + 1, 6):
            factor = M[i][k] * inverse
            for j in range(k + 1, 6):
                M[i][j] = M[i][j] - factor * M[k][j]
            x[i] = x[i] - factor * x[k]
    for k in reversed(range(6)):
        for j in range(k + 1, 6):
            x[k] = x[k] - M[k][j] * x[j]
        x[k] = x[k] / M[k][k]
    return status
