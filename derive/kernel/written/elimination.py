"""Elimination with partial pivoting of six equations, (36), as a written function.

All kernels use this text. ``a[i, k]`` is an entry of the matrix, and ``upper[k, j]`` an entry of the row of a
pivot. ``kernel.elimination`` defines their location, and the lines that consist of a call. If moments are
about platform point 1, the rows from ``FIRST`` on are zero in column 0.
"""


def elimination() -> None:
    """Move the row with the largest entry of each column to the pivot, and clear the column below it."""
    for k in each(6):
        begin(k)
        for i in each(k + 1, FIRST if FIRST < 6 and k == 0 else 6):
            exchange(k, i)
        bring(k)
        weigh_pivot(k)
        invert(k)
        update(k)
    substitute()


def inverted(k) -> None:
    """One over the pivot."""
    if ROLLED or IN_ROWS or k < 5:
        inverse[k,] = 1.0 / a[k, k]
    if IN_ROWS:
        a[k, k] = inverse[k,]


# ---------------------------------------------------------------- rows that lose a column


def by_entries(k) -> None:
    """Entry after entry."""
    if IN_ROWS:
        for j in each(k + 1, 7 if k < 5 else 0):
            upper[k, j] = a[k, j]
    for i in each(k + 1, FIRST if FIRST < 6 and k == 0 else 6):
        factor[i, k] = a[i, k] * inverse[k,]
        for j in each(k + 1, 7):
            a[i, j] = a[i, j] - factor[i, k] * upper[k, j]


def by_long_rows(k) -> None:
    """Rows with many right sides."""
    clear_below_WIDTH(A, k, inverse[k])


def above_as_well(k) -> None:
    """Eliminate column k from all rows except the row of the pivot, and from the rows of the inverse."""
    for i in each(6):
        if i != k:
            factor[i, k] = a[i, k] / a[k, k]
            for j in each(6):
                a[i, j] = a[i, j] - factor[i, k] * a[k, j]
                Y[i][j] = Y[i][j] - factor[i, k] * Y[k][j]


# ---------------------------------------------------------------- the solution


def one_by_one() -> None:
    """Back substitution for one right side: the last unknown first."""
    for i in each(5, -1, -1):
        total[i,] = a[i, 6]
        for j in each(i + 1, 6):
            total[i,] = total[i,] - a[i, j] * x[j,]
        if DIVIDES:
            x[i,] = total[i,] / a[i, i] if i == 5 else total[i,] * inverse[i,]
        else:
            x[i,] = total[i,] * (a[i, i] if IN_ROWS else inverse[i,])


def row_by_row() -> None:
    """Back substitution for many right sides."""
    substitute_back_WIDTH(A, inverse)


# ---------------------------------------------------------------- pivots


def exchange_selected(k, i) -> None:
    """Exchange rows of poses side by side by selection."""
    larger_below = size(a[i, k]) > size(a[k, k])
    for j in each(k, 7):
        above = a[k, j]
        a[k, j] = where(larger_below, a[i, j], a[k, j])
        a[i, j] = where(larger_below, above, a[i, j])


def largest_of_column(k) -> None:
    """Return the largest entry of the column."""
    if k < 5:
        largest[k,] = size(a[k, k])


def exchange_pointers(k, i) -> None:
    """Exchange rows by their addresses."""
    other[k, i] = size(a[i, k])
    if other[k, i] > largest[k,]:
        if i < (FIRST if FIRST < 6 and k == 0 else 6) - 1:
            largest[k,] = other[k, i]
        moved[k, i] = row[i]
        row[i] = row[k]
        row[k] = moved[k, i]


def first_pivot(k) -> None:
    """Find the pivot, and exchange its row afterward."""
    pivot = k
    most = size(a[k, k])


def look_below(k, i) -> None:
    """Return 1 if this row has a larger entry."""
    entry = size(a[i, k])
    pivot = where(entry > most, i, pivot)
    most = where(entry > most, entry, most)


def exchange_once(k) -> None:
    """Move the row of the pivot, and the corresponding row of the inverse, to row k."""
    if anywhere(pivot != k):
        for j in columns(WIDTH):
            moved = a[k, j]
            a[k, j] = A[pivot][j]
            A[pivot][j] = moved
            if BESIDE:
                beside = Y[k][j]
                Y[k][j] = Y[pivot][j]
                Y[pivot][j] = beside


def suspicion(k) -> None:
    """Mark the pose if a pivot is small."""
    suspect = where(size(a[k, k]) > SUSPECT, suspect, 1)


def product(k) -> None:
    """Multiply the pivots; without vector registers this takes fewer instructions than a check of each."""
    pivots = a[k, k] if k == 0 else pivots * a[k, k]


def regular(k) -> None:
    """Reject a zero pivot."""
    reject(size(a[k, k]) > 0.0, SINGULAR)


def definite(k) -> None:
    """Check that the pivot of a symmetric matrix, whose rows are not exchanged, retains enough digits."""
    fault = where(size(a[k, k]) <= MAX, MASS_MATRIX_INDEFINITE, NOT_FINITE)
    fault = where(a[k, k] > kept * scale[k,], OK, fault)
    status = where(status == OK, fault, status)


def returned(holds, code) -> None:
    """Return from the function with a status."""
    if not holds:
        return code


def carried(holds, code) -> None:
    """Keep the first status other than OK."""
    status = where((status != OK) | (holds), status, code)


# ---------------------------------------------------------------- L D L^T, every entry a variable


def definite_six() -> None:
    """Solve ``inertia`` x = ``right``; only the diagonal of ``inertia`` and the entries above it are read."""
    for i in each(6):
        y[i,] = right[i,]
        for j in each(i, 6):
            a[i, j] = inertia[i, j]
    for k in each(6):
        weigh_pivot(k)
        inverse[k,] = 1.0 / a[k, k]
        for i in each(k + 1, 6):
            factor[k, i] = a[k, i] * inverse[k,]
            for j in each(i, 6):
                a[i, j] = a[i, j] - factor[k, i] * a[k, j]
            y[i,] = y[i,] - factor[k, i] * y[k,]
    for k in each(5, -1, -1):
        x[k,] = y[k,] * inverse[k,]
        for j in each(5, k, -1):
            x[k,] = x[k,] - factor[k, j] * x[j,]


# ---------------------------------------------------------------- two blocks of three legs


def two_blocks() -> None:
    """Solve for x in two blocks; ``weak`` is 1 if the first block or its Schur complement is nearly singular.

    Pivots then lose fewer digits. The two blocks require no exchanges and only two independent divisions,
    about half the time of six pivots in sequence. The adjugate of the directions of legs 2, 4, and 6 solves
    the first block, and the adjugate of the Schur complement the second one for legs 1, 3, and 5.
    """
    for i in each(3):
        for j in each(3):
            r[i, j] = (
                a[(j + 1) % 3, 2 * ((i + 1) % 3) + 1] * a[(j + 2) % 3, 2 * ((i + 2) % 3) + 1]
                - a[(j + 2) % 3, 2 * ((i + 1) % 3) + 1] * a[(j + 1) % 3, 2 * ((i + 2) % 3) + 1]
            )
    det = a[0, 1] * r[0, 0] + a[1, 1] * r[0, 1] + a[2, 1] * r[0, 2]
    for c in each(0, 7, 2):
        for i in each(3):
            e[i, c] = r[i, 0] * a[0, c] + r[i, 1] * a[1, c] + r[i, 2] * a[2, c]
        for k in each(3):
            own[k, c] = det * a[k + 3, c] - a[k + 3, 1] * e[0, c]
            w[k, c] = own[k, c] - a[k + 3, 3] * e[1, c] - a[k + 3, 5] * e[2, c]
    for i in each(3):
        for j in each(3):
            u[i, j] = (
                w[(j + 1) % 3, 2 * ((i + 1) % 3)] * w[(j + 2) % 3, 2 * ((i + 2) % 3)]
                - w[(j + 2) % 3, 2 * ((i + 1) % 3)] * w[(j + 1) % 3, 2 * ((i + 2) % 3)]
            )
    complement = w[0, 0] * u[0, 0] + w[1, 0] * u[0, 1] + w[2, 0] * u[0, 2]
    for i in each(3):
        square[i,] = e[i, 0] * e[i, 0] + e[i, 2] * e[i, 2] + e[i, 4] * e[i, 4]
    det2 = det * det
    least = larger(size(det) * BLOCK_LEAST, BLOCK_SINGULAR) * (det2 * arm_cube)
    spread = (square[0,] + square[1,]) + square[2,]
    weak = where(spread > BLOCK_GROWTH * det2, 1.0, 0.0)
    weak = where(size(complement) <= least, 1.0, weak)
    inverse_det = 1.0 / (where(weak > 0.0, 1.0, det) if GUARDED else det)
    inverse_complement = 1.0 / (where(weak > 0.0, 1.0, complement) if GUARDED else complement)
    for i in each(3):
        x[2 * i,] = (u[i, 0] * w[0, 6] + u[i, 1] * w[1, 6] + u[i, 2] * w[2, 6]) * inverse_complement
    for i in each(3):
        x[2 * i + 1,] = (e[i, 6] - e[i, 0] * x[0,] - e[i, 2] * x[2,] - e[i, 4] * x[4,]) * inverse_det
