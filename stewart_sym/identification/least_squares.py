"""Least squares whose unknowns are few that every row may hold, and many of which a row holds few.

The first are parameters, the others coefficients of a motion. Those of a spline at one instant are
neighbors, so that the normal equations of the many are a band, beside which only the few remain.
"""

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ..io.array_types import Array, Indices
from ..motion.smooth_motion import DISTINCT, by_normal_equations

# Columns of the identity for which a band is solved at a time.
_TOGETHER = 256


class DenseFactors(NamedTuple):
    """Normal equations of J, (rows, unknowns), solved.

    span: orthonormal basis of its range; back: B such that B basis^T is the pseudoinverse.
    """

    span: Array
    back: Array

    @property
    def unknowns(self) -> int:
        """How many unknowns."""
        return int(self.span.shape[1])

    def solve(self, y: Array) -> Array:
        """x of J x = y by least squares, (unknowns,), for y (rows,)."""
        return np.asarray(self.back @ (self.span.T @ y))

    def explained(self, y: Array) -> Array:
        """J x of it, for y (rows,) or (rows, columns)."""
        return np.asarray(self.span @ (self.span.T @ y))

    def shares(self, first: int) -> tuple[float, float]:
        """How many unknowns the first rows determine, and the others: traces of the projection there."""
        return float(np.sum(self.span[:first] ** 2)), float(np.sum(self.span[first:] ** 2))

    def covariance(self, count: int) -> Array:
        """Of the first unknowns, by errors of deviation 1 in every row."""
        return np.asarray(self.back[:count] @ self.back[:count].T)


class Arrow(NamedTuple):
    """A matrix by what is not zero in it.

    A: columns of the few unknowns in the first rows, the others being zero, (first rows, few). local: of the
    many in all rows, (rows, width). start: column of the many where a row of these begins, (rows,). many: how
    many.
    """

    A: Array
    local: Array
    start: Indices
    many: int

    def runs(self, first: int = 0) -> Iterator[tuple[slice, slice]]:
        """Rows from the first on that begin in one column, and the columns of the many that they have."""
        ends = np.flatnonzero(np.diff(self.start[first:])) + first + 1
        for row, end in pairwise((first, *ends.tolist(), len(self.start))):
            at = int(self.start[row])
            yield slice(row, end), slice(at, at + self.local.shape[1])

    def __matmul__(self, x: Array) -> Array:
        """Its product with x, (few + many,) or (few + many, columns)."""
        few = self.A.shape[1]
        found = np.empty((len(self.local), *x.shape[1:]))
        for rows, columns in self.runs():
            found[rows] = self.local[rows] @ x[few:][columns]
        found[: len(self.A)] += self.A @ x[:few]
        return found

    def by_many(self, y: Array) -> Array:
        """Products of the columns of the many with y, of the first rows or all, (rows, ...)."""
        found = np.zeros((self.many, *y.shape[1:]))
        for rows, columns in self.runs():
            found[columns] += self.local[rows][: max(len(y) - rows.start, 0)].T @ y[rows]
        return found

    def band(self, first: int = 0) -> Array:
        """Of the products of the columns of the many, in the rows from the first on: (width, many).

        Row ``width - 1 - k`` holds those of each column with the k-th before it, as in LAPACK.
        """
        width = self.local.shape[1]
        one, other = np.triu_indices(width)
        found = np.zeros((width, self.many))
        for rows, columns in self.runs(first):
            block = self.local[rows].T @ self.local[rows]
            found[width - 1 - (other - one), columns.start + other] += block[one, other]
        return found

    def scaled(self, lengths: Array) -> "Arrow":
        """Its columns over lengths."""
        few, width = self.A.shape[1], self.local.shape[1]
        of_local = lengths[few:][self.start[:, None] + np.arange(width)]
        return self._replace(A=self.A / lengths[:few], local=self.local / of_local)

    def dense(self) -> Array:
        """All of it, (rows, few + many)."""
        few = self.A.shape[1]
        J = np.zeros((len(self.local), few + self.many))
        J[: len(self.A), :few] = self.A
        for rows, columns in self.runs():
            J[rows, few + columns.start : few + columns.stop] = self.local[rows]
        return J


class ArrowFactors:
    """``DenseFactors`` of an arrow; needs SciPy.

    Raises numpy.linalg.LinAlgError where columns are nearly dependent.
    """

    def __init__(self, J: Arrow) -> None:
        from scipy.linalg import cholesky_banded

        self._lengths = np.sqrt(np.concatenate([np.sum(J.A**2, axis=0), J.band()[-1]]))
        if not self._lengths.all():
            raise np.linalg.LinAlgError("a column is zero")
        self._J = J = J.scaled(self._lengths)
        self._band = cholesky_banded(J.band())
        cross = J.by_many(J.A)
        self._beside = self._solved(cross)
        self._corner = np.linalg.cholesky(J.A.T @ J.A - cross.T @ self._beside)
        if min(self._band[-1].min(), self._corner.diagonal().min()) < DISTINCT:
            raise np.linalg.LinAlgError("columns are nearly dependent")

    @property
    def unknowns(self) -> int:
        """See ``DenseFactors``."""
        return len(self._lengths)

    def solve(self, y: Array) -> Array:
        """x of J x = y by least squares."""
        return np.asarray(self._scaled(y) / self._lengths)

    def explained(self, y: Array) -> Array:
        """J x of it."""
        return self._J @ self._scaled(y)

    def shares(self, first: int) -> tuple[float, float]:
        """Of the first rows, which are those that hold the few unknowns, and of the others."""
        others, band = 0.0, self._J.band(first)
        for at in range(0, self._J.many, _TOGETHER):
            columns = np.arange(at, min(at + _TOGETHER, self._J.many))
            G = _columns(band, columns)
            inverse = self._solved(G)
            inverse += self._beside @ self._cornered(self._beside.T @ G)
            others += float(np.trace(inverse[columns]))
        return self.unknowns - others, others

    def covariance(self, count: int) -> Array:
        """Of the first unknowns, few of them."""
        lengths = self._lengths[:count]
        inverse = self._cornered(np.eye(len(self._corner)))[:count, :count]
        return np.asarray(inverse / np.outer(lengths, lengths))

    def _scaled(self, y: Array) -> Array:
        # The residual is corrected once, which gives back the digits that squares lose.
        x = self._first_solution(y)
        return x + self._first_solution(y - self._J @ x)

    def _first_solution(self, y: Array) -> Array:
        A, by_many = self._J.A, self._J.by_many(y)
        few = self._cornered(A.T @ y[: len(A)] - self._beside.T @ by_many)
        return np.concatenate([few, self._solved(by_many) - self._beside @ few])

    def _solved(self, y: Array) -> Array:
        from scipy.linalg import cho_solve_banded

        return np.asarray(cho_solve_banded((self._band, False), y))

    def _cornered(self, y: Array) -> Array:
        return np.asarray(np.linalg.solve(self._corner.T, np.linalg.solve(self._corner, y)))


def _columns(band: Array, columns: Indices) -> Array:
    """Columns of the symmetric matrix of a band, (many, columns)."""
    width, many = band.shape
    found = np.zeros((many, len(columns)))
    for above in range(width):
        here = columns[columns >= above]
        found[here - above, here - columns[0]] = band[width - 1 - above, here]
        here = columns[columns + above < many]
        found[here + above, here - columns[0]] = band[width - 1 - above, here + above]
    return found


Factors = DenseFactors | ArrowFactors


def factors(J: Array | Arrow) -> Factors:
    """The factors of J, of full rank: by its own structure, or dense where that leaves too few digits."""
    if isinstance(J, Arrow):
        try:
            return ArrowFactors(J)
        except np.linalg.LinAlgError:
            J = J.dense()
    lengths = np.linalg.norm(J, axis=0)
    Q, corner = np.linalg.qr(J / lengths)
    return DenseFactors(Q, np.linalg.inv(corner) / lengths[:, None])


def solution(J: Array | Arrow, y: Array) -> Array:
    """x of J x = y by least squares."""
    x = None if isinstance(J, Arrow) else by_normal_equations(J, y)
    return factors(J).solve(y) if x is None else x


# Tails of the distributions by which fits are tested


def tail(ratio: float, freedom: float, other: float = math.inf) -> float:
    """Probability of an F ratio above this one; chi-square over its freedom if ``other`` is infinite.

    Paulson's normal approximation of its cube root, right to some per cent of the probability from 10 degrees
    of freedom on, to a sixth from 4 on.
    """
    a, b = 2.0 / (9.0 * freedom), 2.0 / (9.0 * other)
    root = math.cbrt(ratio)
    return 0.5 * math.erfc(((1.0 - b) * root - (1.0 - a)) / math.sqrt(2.0 * (b * root**2 + a)))


def departure(off: Array, covariance: Array) -> tuple[Array, float]:
    """Differences (n,) of a covariance in their deviations, and the probability of ones so far from 0."""
    sigma = np.sqrt(np.diagonal(covariance))
    scaled = off / sigma
    squares = float(scaled @ np.linalg.solve(covariance / np.outer(sigma, sigma), scaled))
    return scaled, tail(squares / len(off), len(off))
