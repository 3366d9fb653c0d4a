"""The platform's equations [H | c] as two blocks of three legs, in the part of Python that ``read`` reads.

Without exchanges and with two divisions, which wait for nothing: about half the time of pivots one after the
other. One text for poses in lanes, one pose and arrays. Legs 2, 4 and 6 balance the force, by the adjugate of
their directions; legs 1, 3 and 5 the moment that is left, by that of what they add to it. ``weak`` says where
the first block is nearly singular, or what is left of the second is: there pivots lose fewer digits.
"""


def two_blocks() -> None:
    """The unknowns x, and ``weak``, 1 where another solve is wanted."""
    adjugate_of_directions()
    det = a[0, 1] * r[0, 0] + a[1, 1] * r[0, 1] + a[2, 1] * r[0, 2]
    eliminated()
    for i in each(3):
        for j in each(3):
            u[i, j] = (
                w[(j + 1) % 3, 2 * ((i + 1) % 3)] * w[(j + 2) % 3, 2 * ((i + 2) % 3)]
                - w[(j + 2) % 3, 2 * ((i + 1) % 3)] * w[(j + 1) % 3, 2 * ((i + 2) % 3)]
            )
    rest = w[0, 0] * u[0, 0] + w[1, 0] * u[0, 1] + w[2, 0] * u[0, 2]
    for i in each(3):
        square[i,] = e[i, 0] * e[i, 0] + e[i, 2] * e[i, 2] + e[i, 4] * e[i, 4]
    det2 = det * det
    least = larger(size(det) * BLOCK_LEAST, BLOCK_SINGULAR) * (det2 * arm_cube)
    spread = (square[0,] + square[1,]) + square[2,]
    weak = where(spread > BLOCK_GROWTH * det2, 1.0, 0.0)
    weak = where(size(rest) <= least, 1.0, weak)
    inverse_det = 1.0 / (where(weak > 0.0, 1.0, det) if GUARDED else det)
    inverse_rest = 1.0 / (where(weak > 0.0, 1.0, rest) if GUARDED else rest)
    for i in each(3):
        x[2 * i,] = (u[i, 0] * w[0, 6] + u[i, 1] * w[1, 6] + u[i, 2] * w[2, 6]) * inverse_rest
    for i in each(3):
        x[2 * i + 1,] = (e[i, 6] - e[i, 0] * x[0,] - e[i, 2] * x[2,] - e[i, 4] * x[4,]) * inverse_det


def adjugate_of_directions() -> None:
    """Of legs 2, 4 and 6: cross products of two of their directions."""
    for i in each(3):
        for j in each(3):
            r[i, j] = (
                a[(j + 1) % 3, 2 * ((i + 1) % 3) + 1] * a[(j + 2) % 3, 2 * ((i + 2) % 3) + 1]
                - a[(j + 2) % 3, 2 * ((i + 1) % 3) + 1] * a[(j + 1) % 3, 2 * ((i + 2) % 3) + 1]
            )


def entry_by_entry() -> None:
    """The forces that legs 2, 4 and 6 take from the other columns, and the moments that are left; both times
    the determinant of their directions."""
    for c in each(0, 7, 2):
        for i in each(3):
            e[i, c] = r[i, 0] * a[0, c] + r[i, 1] * a[1, c] + r[i, 2] * a[2, c]
        for k in each(3):
            own[k, c] = det * a[k + 3, c] - a[k + 3, 1] * e[0, c] if c >= OWN else -a[k + 3, 1] * e[0, c]
            w[k, c] = own[k, c] - a[k + 3, 3] * e[1, c] - a[k + 3, 5] * e[2, c]


def column_by_column() -> None:
    """The same of one pose, a row of eight one vector."""
    balanced = blank(array(3, LANES))
    left = blank(array(3, LANES))
    for l in range(LANES):
        for i in each(3):
            of[i,] = r[i, 0] * A[0][l] + r[i, 1] * A[1][l] + r[i, 2] * A[2][l]
            balanced[i][l] = of[i,]
        for k in each(3):
            left[k][l] = (
                det * A[k + 3][l] - A[k + 3][1] * of[0,] - A[k + 3][3] * of[1,] - A[k + 3][5] * of[2,]
            )
    for i in each(3):
        for c in each(0, 6, 2):
            e[i, c] = balanced[i][c]
            w[i, c] = left[i][c]
    column_of_sums()


def one_column() -> None:
    """The column c alone, which the rows do not hold: it was just stored, number by number, and a processor
    would wait for all of it before it reads it as part of a vector."""
    for i in each(3):
        e[i, 6] = r[i, 0] * wrench[0] + r[i, 1] * wrench[1] + r[i, 2] * wrench[2]
    for k in each(3):
        w[k, 6] = det * wrench[k + 3] - A[k + 3][1] * e[0, 6] - A[k + 3][3] * e[1, 6] - A[k + 3][5] * e[2, 6]
