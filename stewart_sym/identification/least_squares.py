"""Linear least squares with a few dense unknowns and many local unknowns, and tests of its residual.

The dense unknowns are parameters, on which every force depends. The local unknowns are coefficients of a
motion, of which each row contains a few neighbors; their normal equations are sparse and well conditioned.
"""

from typing import Any

import numpy as np
from scipy.linalg import solve_triangular
from scipy.sparse.linalg import splu
from scipy.special import chdtrc

from ..io.array_types import Array

# Number of rows in one step of the QR decomposition, to save memory.
_ROWS = 20_000
# Number of random signs that estimate a trace, and the number of solutions that refine each other.
_PROBES, _REFINED = 16, 2
# Relative size of singular values below which columns are dependent.
_ROUNDING = 1e-12


class Factors:
    """Factors of J = [A, L] with dense columns A, which are zero in later rows, and sparse columns L.

    Attributes
    ----------
    A : ndarray, shape (first rows, few)
        Dense columns.
    L : scipy.sparse.csr_matrix, shape (rows, many)
        Local columns.
    """

    def __init__(self, A: Array, L: Any) -> None:
        """Eliminate the local unknowns, and factorize the dense columns by QR."""
        self.A, self.L = A, L
        self._local = splu((L.T @ L).tocsc()).solve if L.shape[1] else np.asarray
        self._adjacent = self._local(L[: len(A)].T @ A)
        R = np.zeros((0, A.shape[1]))
        for rows in (slice(first, first + _ROWS) for first in range(0, L.shape[0], _ROWS)):
            block = -np.asarray(L[rows] @ self._adjacent)
            block[: len(A[rows])] += A[rows]
            R = np.asarray(np.linalg.qr(np.vstack([R, block]), mode="r"))
        self._lengths = np.linalg.norm(R, axis=0)
        self._R = R / np.where(self._lengths > 0.0, self._lengths, 1.0)

    @property
    def unknowns(self) -> int:
        """Number of unknowns."""
        return int(self.A.shape[1] + self.L.shape[1])

    def rank(self, count: int) -> int:
        """Return the rank of the first dense columns, scaled to length 1."""
        values = np.linalg.svd(self._R[:, :count], compute_uv=False)
        return int(np.count_nonzero(values > _ROUNDING * values[0])) if values.size else 0

    def product(self, x: Array) -> Array:
        """Compute J x; x has shape (unknowns,) or (unknowns, columns)."""
        found = np.asarray(self.L @ x[self.A.shape[1] :])
        found[: len(self.A)] += self.A @ x[: self.A.shape[1]]
        return found

    def solve(self, y: Array) -> Array:
        """Solve J x = y by least squares; y has shape (rows,) or (rows, columns)."""
        x = np.zeros((self.unknowns, *y.shape[1:]))
        for _ in range(_REFINED):
            x += self._solution(y - self.product(x))
        return x

    def unexplained(self, y: Array) -> Array:
        """Return the part of y, shape (rows,) or (rows, columns), that no unknown explains."""
        return y - self.product(self.solve(y))

    def freedom(self, rows: slice) -> float:
        """Estimate the number of unknowns that some rows determine, the trace of the projection onto J."""
        signs = np.random.default_rng(0).choice([-1.0, 1.0], (self.L.shape[0], _PROBES))
        signs[: rows.start], signs[rows.stop :] = 0.0, 0.0
        return float(np.sum(signs * self.product(self.solve(signs)))) / _PROBES

    def covariance(self) -> Array:
        """Return the covariance of the dense unknowns for unit variance in every row."""
        back = solve_triangular(self._R, np.eye(len(self._R))) / self._lengths[:, None]
        return np.asarray(back @ back.T)

    def _solution(self, y: Array) -> Array:
        """Solve by block elimination and the seminormal equations of the dense unknowns."""
        local = self._local(self.L.T @ y)
        left = (y - self.L @ local)[: len(self.A)]
        scale = self._lengths.reshape(-1, *[1] * (y.ndim - 1))
        few = solve_triangular(self._R, self.A.T @ left / scale, trans="T")
        few = solve_triangular(self._R, few) / scale
        return np.concatenate([few, local - self._adjacent @ few])


def departure(off: Array, covariance: Array) -> tuple[Array, float]:
    """Return differences (n,) in standard deviations, and their joint p-value for a covariance."""
    sigma = np.sqrt(np.diagonal(covariance))
    scaled = off / sigma
    squares = float(scaled @ np.linalg.solve(covariance / np.outer(sigma, sigma), scaled))
    return scaled, float(chdtrc(len(off), squares))
