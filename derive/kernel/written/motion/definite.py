"""Six equations with a symmetric definite matrix by L D L^T, in the part of Python that ``read`` reads."""


def definite_six() -> None:
    """``inertia`` x = ``right``; only what is on the diagonal and above it is read."""
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


def remains(k) -> None:
    """What is wrong where too little remains of a diagonal number."""
    fault = where(size(a[k, k]) <= MAX, INDEFINITE, NOT_FINITE)
    fault = where(a[k, k] > KEPT * inertia[k, k], OK, fault)
    status = where(status == OK, fault, status)
