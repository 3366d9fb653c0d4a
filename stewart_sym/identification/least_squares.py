"""Sparse least squares with a few dense unknowns and many local unknowns.

The dense unknowns are parameters, which affect every row. The local unknowns are coefficients of a spline
motion, of which each row contains a few neighbors. The normal equations of the local unknowns are therefore
banded. Elimination of the band gives a small dense system for the parameters.
"""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from ..io.array_types import Array, Indices

# Number of columns of the identity in one banded solve, because all columns need too much memory.
_TOGETHER = 256


# Least diagonal entry of the Cholesky factor of columns of length 1.
_DISTINCT = 1e-6


class DenseFactors(NamedTuple):
    """Factors of the normal equations of a dense matrix J, shape (rows, unknowns).

    Attributes
    ----------
    span : ndarray, shape (rows, unknowns)
        Orthonormal basis of the range of J.
    back : ndarray, shape (unknowns, unknowns)
        Matrix B such that B span^T is the pseudoinverse of J.
    """

    span: Array
    back: Array

    @property
    def unknowns(self) -> int:
        """Number of unknowns."""
        return int(self.span.shape[1])

    def solve(self, y: Array) -> Array:
        """Solve J x = y by least squares; y has shape (rows,)."""
        return np.asarray(self.back @ (self.span.T @ y))

    def explained(self, y: Array) -> Array:
        """Compute the projection of y, shape (rows,) or (rows, columns), onto the range of J."""
        return np.asarray(self.span @ (self.span.T @ y))

    def shares(self, counts: Sequence[int]) -> list[float]:
        """Return the effective numbers of unknowns that successive parts of the rows determine.

        The numbers are the traces of the projection onto the range of J over these rows.
        """
        parts = np.split(self.span, np.cumsum(counts)[:-1])
        return [float(np.sum(part**2)) for part in parts]

    def covariance(self, count: int) -> Array:
        """Return the covariance of the first unknowns for unit variance in every row."""
        return np.asarray(self.back[:count] @ self.back[:count].T)


class Arrow(NamedTuple):
    """Sparse matrix with a few dense columns followed by many local columns.

    Attributes
    ----------
    A : ndarray, shape (first rows, few)
        Dense columns in the first rows; they are zero in the other rows.
    local : scipy.sparse.csr_array, shape (rows, many)
        Local columns.
    """

    A: Array
    local: Any

    def __matmul__(self, x: Array) -> Array:
        """Compute the product with x, shape (few + many,) or (few + many, columns)."""
        few = self.A.shape[1]
        found = np.asarray(self.local @ x[few:])
        found[: len(self.A)] += self.A @ x[:few]
        return found

    def by_many(self, y: Array) -> Array:
        """Compute the product of the transposed local columns with y, over the first rows or all rows."""
        return np.asarray(self.local[: len(y)].T @ y)

    def band(self) -> Array:
        """Compute the Gram matrix of the local columns as an upper band, shape (width, many)."""
        gram = (self.local.T @ self.local).tocoo()
        above = gram.col - gram.row
        width, upper = int(above.max()) + 1, above >= 0
        found = np.zeros((width, gram.shape[0]))
        found[width - 1 - above[upper], gram.col[upper]] = gram.data[upper]
        return found

    def scaled(self, lengths: Array) -> "Arrow":
        """Divide the columns by lengths."""
        few, local = self.A.shape[1], self.local.copy()
        local.data /= lengths[few:][local.indices]
        return self._replace(A=self.A / lengths[:few], local=local)

    def dense(self) -> Array:
        """Return the dense matrix, shape (rows, few + many)."""
        below = np.zeros((self.local.shape[0] - len(self.A), self.A.shape[1]))
        return np.hstack([np.concatenate([self.A, below]), self.local.toarray()])


def arrow(A: Array, local: Array, start: Indices, others: Any) -> Array | Arrow:
    """Return the matrix with dense columns A, local columns, and other rows of local columns only.

    ``local``, shape (rows, width), contains the entries of the columns from ``start``, shape (rows,), on. The
    matrix is dense if each row has entries in all columns.
    """
    (rows, width), many = local.shape, others.shape[1]
    if width == many:
        return np.hstack([np.concatenate([A, np.zeros((rows - len(A), A.shape[1]))]), local])
    from scipy.sparse import csr_matrix, vstack

    columns = (start[:, None] + np.arange(width)).ravel()
    entries = csr_matrix((local.ravel(), columns, width * np.arange(rows + 1)), shape=(rows, many))
    return Arrow(A, vstack([entries, others], "csr"))


class ArrowFactors:
    """Factors of an ``Arrow`` with the interface of ``DenseFactors``.

    Raises
    ------
    numpy.linalg.LinAlgError
        If columns are nearly dependent.
    """

    def __init__(self, J: Arrow) -> None:
        """Factorize the scaled normal equations."""
        from scipy.linalg import cholesky_banded

        squares = np.bincount(J.local.indices, J.local.data**2, minlength=J.local.shape[1])
        self._lengths = np.sqrt(np.concatenate([np.sum(J.A**2, axis=0), squares]))
        if not self._lengths.all():
            raise np.linalg.LinAlgError("a column is zero")
        self._J = J = J.scaled(self._lengths)
        self._band = cholesky_banded(J.band())
        cross = J.by_many(J.A)
        self._beside = self._solved(cross)
        self._corner = np.linalg.cholesky(J.A.T @ J.A - cross.T @ self._beside)
        if min(self._band[-1].min(), self._corner.diagonal().min()) < _DISTINCT:
            raise np.linalg.LinAlgError("columns are nearly dependent")

    @property
    def unknowns(self) -> int:
        """Number of unknowns."""
        return len(self._lengths)

    def solve(self, y: Array) -> Array:
        """Solve J x = y by least squares."""
        return np.asarray(self._scaled(y) / self._lengths)

    def explained(self, y: Array) -> Array:
        """Compute the projection of y onto the range of J."""
        return self._J @ self._scaled(y)

    def shares(self, counts: Sequence[int]) -> list[float]:
        """Return the effective numbers of unknowns that successive parts of the rows determine."""
        ends = np.cumsum(counts)
        others = [self._share(*edges) for edges in pairwise(ends.tolist())]
        return [self.unknowns - sum(others), *others]

    def _share(self, first: int, end: int) -> float:
        """Return the trace of the projection over rows without dense unknowns."""
        local = self._J.local[first:end]
        gram, found = (local.T @ local).tocsc(), 0.0
        for at in range(0, gram.shape[0], _TOGETHER):
            columns = slice(at, at + _TOGETHER)
            G = gram[:, columns].toarray()
            inverse = self._solved(G)[columns] + self._beside[columns] @ self._cornered(self._beside.T @ G)
            found += float(np.trace(inverse))
        return found

    def covariance(self, count: int) -> Array:
        """Return the covariance of the first unknowns, which must be dense unknowns."""
        lengths = self._lengths[:count]
        inverse = self._cornered(np.eye(len(self._corner)))[:count, :count]
        return np.asarray(inverse / np.outer(lengths, lengths))

    def _scaled(self, y: Array) -> Array:
        """Solve the scaled system; one step of refinement recovers the digits that squares lose."""
        x = self._first_solution(y)
        return x + self._first_solution(y - self._J @ x)

    def _first_solution(self, y: Array) -> Array:
        """Solve the scaled system by block elimination."""
        A, by_many = self._J.A, self._J.by_many(y)
        few = self._cornered(A.T @ y[: len(A)] - self._beside.T @ by_many)
        return np.concatenate([few, self._solved(by_many) - self._beside @ few])

    def _solved(self, y: Array) -> Array:
        """Solve the banded system of the local unknowns."""
        from scipy.linalg import cho_solve_banded

        return np.asarray(cho_solve_banded((self._band, False), y))

    def _cornered(self, y: Array) -> Array:
        """Solve the Schur complement of the dense unknowns."""
        return np.asarray(np.linalg.solve(self._corner.T, np.linalg.solve(self._corner, y)))


Factors = DenseFactors | ArrowFactors


def factors(J: Array | Arrow) -> Factors:
    """Return the factors of J, of full rank, by sparse or, if this is inaccurate, dense elimination."""
    if isinstance(J, Arrow):
        try:
            return ArrowFactors(J)
        except np.linalg.LinAlgError:
            J = J.dense()
    lengths = np.linalg.norm(J, axis=0)
    Q, corner = np.linalg.qr(J / lengths)
    return DenseFactors(Q, np.linalg.inv(corner) / lengths[:, None])


def solution(J: Array | Arrow, y: Array) -> Array:
    """Solve J x = y, of full rank, by least squares; y has shape (rows,) or, for a dense J, (rows, c)."""
    if isinstance(J, Arrow):
        return factors(J).solve(y)
    count = J.shape[1]
    corner = np.asarray(np.linalg.qr(np.column_stack([J, y]), mode="r"))[:count]
    return np.asarray(np.linalg.solve(corner[:, :count], corner[:, count:])).reshape(count, *y.shape[1:])


# Tail probabilities of the test statistics


def tail(ratio: float, freedom: float, other: float = math.inf) -> float:
    """Return the probability that an F-distributed ratio exceeds ``ratio``.

    If ``other`` is infinite, the ratio is chi-square over its degrees of freedom. The formula is Paulson's
    normal approximation of the cube root. The relative error of the probability is a few percent from 10
    degrees of freedom on, and one sixth from 4 on.
    """
    a, b = 2.0 / (9.0 * freedom), 2.0 / (9.0 * other)
    root = math.cbrt(ratio)
    return 0.5 * math.erfc(((1.0 - b) * root - (1.0 - a)) / math.sqrt(2.0 * (b * root**2 + a)))


def departure(off: Array, covariance: Array) -> tuple[Array, float]:
    """Return differences (n,) in standard deviations, and their joint p-value for a covariance."""
    sigma = np.sqrt(np.diagonal(covariance))
    scaled = off / sigma
    squares = float(scaled @ np.linalg.solve(covariance / np.outer(sigma, sigma), scaled))
    return scaled, tail(squares / len(off), len(off))
