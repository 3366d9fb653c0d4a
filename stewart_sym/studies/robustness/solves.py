"""Ways to solve H x = c, written plainly: candidates for the kernels' solve."""

from collections.abc import Callable

import numpy as np

from ...io.array_types import Array

Solve = Callable[[Array, Array], Array]


def without_pivoting(A: Array, y: Array) -> Array:
    """Elimination in the order of the rows."""
    return _eliminated(A, y, lambda A, k, scale: (k, k))


def partial_pivoting(A: Array, y: Array) -> Array:
    """Elimination by the largest entry of each column."""
    return _eliminated(A, y, lambda A, k, scale: (k + int(np.argmax(np.abs(A[k:, k]))), k))


def scaled_pivoting(A: Array, y: Array) -> Array:
    """Elimination by the entry of each column that is largest beside its row's largest."""
    return _eliminated(A, y, lambda A, k, scale: (k + int(np.argmax(np.abs(A[k:, k]) / scale[k:])), k))


def complete_pivoting(A: Array, y: Array) -> Array:
    """Elimination by the largest entry of what remains, columns exchanged too."""

    def largest(A: Array, k: int, scale: Array) -> tuple[int, int]:
        i, j = np.unravel_index(np.argmax(np.abs(A[k:, k:])), (len(A) - k, len(A) - k))
        return k + int(i), k + int(j)

    return _eliminated(A, y, largest)


def householder(A: Array, y: Array) -> Array:
    """QR by LAPACK's reflections."""
    Q, R = np.linalg.qr(A)
    return _back(R, Q.T @ y)


def singular_values(A: Array, y: Array) -> Array:
    """By the singular value decomposition, none left out."""
    U, sigma, V_T = np.linalg.svd(A)
    return np.asarray(V_T.T @ ((U.T @ y) / sigma))


def refined(A: Array, y: Array) -> Array:
    """Partial pivoting and one step of refinement, its residual in double."""
    x = partial_pivoting(A, y)
    return x + partial_pivoting(A, y - A @ x)


CANDIDATES: dict[str, Solve] = {
    "no pivoting": without_pivoting,
    "partial pivoting": partial_pivoting,
    "scaled pivoting": scaled_pivoting,
    "complete pivoting": complete_pivoting,
    "Householder QR": householder,
    "SVD": singular_values,
    "partial, refined": refined,
}


def _eliminated(A: Array, y: Array, pivot: Callable[[Array, int, Array], tuple[int, int]]) -> Array:
    A, y = A.copy(), y.copy()
    n = len(y)
    order, scale = np.arange(n), np.abs(A).max(axis=1)
    for k in range(n):
        i, j = pivot(A, k, scale)
        for rows in (A, y, scale):
            rows[[k, i]] = rows[[i, k]]
        A[:, [k, j]] = A[:, [j, k]]
        order[[k, j]] = order[[j, k]]
        factor = A[k + 1 :, k] / A[k, k]
        A[k + 1 :, k:] -= np.outer(factor, A[k, k:])
        y[k + 1 :] -= factor * y[k]
    x = np.empty(n)
    x[order] = _back(A, y)
    return x


def _back(A: Array, y: Array) -> Array:
    x = np.zeros_like(y)
    for k in reversed(range(len(y))):
        x[k] = (y[k] - A[k, k + 1 :] @ x[k + 1 :]) / A[k, k]
    return x
