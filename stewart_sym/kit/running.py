"""Numbers at 50 digits that know how far rounding may take a machine's own from them, and systems of them.

Running error analysis to first order: every operation adds half a rounding unit of its result to what its
operands bring (Wilkinson; Higham, Accuracy and Stability of Numerical Algorithms, 3.3). Solutions of linear
systems get their error from the inverse, entry by entry (Higham, 7.2 and 9.3): errors carried through an
elimination would grow far beyond what happens. Knows no machine.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..studies.truth import digits

Objects = NDArray[Any]
Sizes = NDArray[np.float64]

HALF_UNIT = 0.5
"""Of the rounding unit epsilon, what rounding to nearest takes from a result at most, over its size."""


class Running:
    """A number, value, at 50 digits, and its error: in rounding units, to first order, absolute.

    Its operations are those of the generated modules: + - * / with its like, integers and exact floats, and
    ``sqrt``, which NumPy calls for arrays of objects.
    """

    __slots__ = ("error", "size", "value")

    def __init__(self, value: Any, error: float = 0.0, rounded: bool = False) -> None:
        """Take value at 50 digits; ``rounded``: it is the result of an operation that rounds."""
        self.value = digits.mpf(value)
        self.size = abs(float(self.value))
        self.error = error + HALF_UNIT * self.size if rounded else error

    def __add__(self, other: Any) -> "Running":
        """Sum; exact where one of both is exactly zero."""
        if isinstance(other, np.ndarray):
            return NotImplemented
        other = running(other)
        rounds = not (self.is_zero or other.is_zero)
        return Running(self.value + other.value, self.error + other.error, rounds)

    def __sub__(self, other: Any) -> "Running":
        """Difference; exact where one of both is exactly zero."""
        return NotImplemented if isinstance(other, np.ndarray) else self + -running(other)

    def __mul__(self, other: Any) -> "Running":
        """Product; exact with powers of two."""
        if isinstance(other, np.ndarray):
            return NotImplemented
        other = running(other)
        carried = self.size * other.error + other.size * self.error
        rounds = not (self.is_power or other.is_power)
        return Running(self.value * other.value, carried, rounds)

    def __truediv__(self, other: Any) -> "Running":
        """Quotient."""
        if isinstance(other, np.ndarray):
            return NotImplemented
        other = running(other)
        value = self.value / other.value
        carried = (self.error + abs(float(value)) * other.error) / other.size
        return Running(value, carried, rounded=True)

    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, other: Any) -> "Running":
        """Difference."""
        return running(other) - self

    def __rtruediv__(self, other: Any) -> "Running":
        """Quotient."""
        return running(other) / self

    def __neg__(self) -> "Running":
        """The number with the other sign, exact."""
        return Running(-self.value, self.error)

    def sqrt(self) -> "Running":
        """Square root."""
        root = digits.sqrt(self.value)
        return Running(root, self.error / (2.0 * float(root)), rounded=True)

    @property
    def is_zero(self) -> bool:
        """Whether it is zero on every machine."""
        return self.size == 0.0 and self.error == 0.0

    @property
    def is_power(self) -> bool:
        """Whether it is zero or a power of two, and exactly so: products with it are exact."""
        return self.error == 0.0 and math.frexp(self.size)[0] in (0.0, 0.5)


def running(value: Any) -> Running:
    """A number as one without error, if it is not one of these already."""
    return value if isinstance(value, Running) else Running(value)


def array(values: Any, shape: tuple[int, ...] | None = None) -> Objects:
    """Numbers, ``Running`` or exact, as an array of ``Running``."""
    given = np.asarray(values, dtype=object)
    given = given if shape is None else np.broadcast_to(given, shape)
    made = np.empty(given.shape, dtype=object)
    for where in np.ndindex(given.shape):
        made[where] = running(given[where])
    return made


def sizes(numbers: Objects) -> Sizes:
    """Sizes of an array of ``Running``, of its shape."""
    return np.array([number.size for number in numbers.flat]).reshape(numbers.shape)


def errors(numbers: Objects) -> Sizes:
    """Errors of an array of ``Running``, in rounding units, of its shape."""
    return np.array([number.error for number in numbers.flat]).reshape(numbers.shape)


def values(numbers: Objects) -> Sizes:
    """Values of an array of ``Running``, each rounded once, of its shape."""
    return np.array([float(number.value) for number in numbers.flat]).reshape(numbers.shape)


def solve(A: Objects, right: Objects) -> Objects:
    """X (n, m) of A X = right, A (n, n), as elimination with partial pivoting finds it.

    Its error: |A^-1| (|dA| |X| + |d right| + n / 2 |L| |U| |X|), half a unit for each of n operations that
    end in an entry of L U.
    """
    return _solved(A, right, _partial_pivot)


def solve_definite(M: Objects, right: Objects) -> Objects:
    """X (n, m) of M X = right, M (n, n) positive definite, as L D L^T finds it; errors as ``solve``."""
    return _solved(M, right, lambda _: 0)


def inverse_sizes(A: Objects) -> Sizes:
    """|A^-1| (n, n), of A (n, n)."""
    n = len(A)
    unit = [[digits.mpf(i == j) for j in range(n)] for i in range(n)]
    X, _ = _eliminated([[a.value for a in row] for row in A], unit, _partial_pivot)
    return _rounded_sizes(X)


def _solved(A: Objects, right: Objects, pivot: Callable[[Sequence[Any]], int]) -> Objects:
    n, m = right.shape
    rows = [[a.value for a in row] for row in A]
    columns = [[b.value for b in right[i]] + [digits.mpf(i == j) for j in range(n)] for i in range(n)]
    found, factors = _eliminated(rows, columns, pivot)
    X = _rounded_sizes([row[:m] for row in found])
    inverse = _rounded_sizes([row[m:] for row in found])
    error = inverse @ ((errors(A) + n * HALF_UNIT * factors) @ X + errors(right))
    solution = np.empty((n, m), dtype=object)
    for i, j in np.ndindex(n, m):
        solution[i, j] = Running(found[i][j], float(error[i, j]))
    return solution


def _partial_pivot(column: Sequence[Any]) -> int:
    return max(range(len(column)), key=lambda i: abs(column[i]))


def _eliminated(
    A: list[list[Any]], right: list[list[Any]], pivot: Callable[[Sequence[Any]], int]
) -> tuple[list[list[Any]], Sizes]:
    """X of A X = right, and |L| |U| with its rows in the order of A's."""
    n = len(A)
    rows = [[*a, *b] for a, b in zip(A, right, strict=True)]
    order, L = list(range(n)), np.eye(n)
    for k in range(n):
        p = k + pivot([rows[i][k] for i in range(k, n)])
        rows[k], rows[p] = rows[p], rows[k]
        order[k], order[p] = order[p], order[k]
        L[[k, p], :k] = L[[p, k], :k]
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            L[i, k] = abs(float(factor))
            for j in range(k, len(rows[i])):
                rows[i][j] -= factor * rows[k][j]
    factors = np.empty((n, n))
    factors[order] = L @ np.triu(_rounded_sizes([row[:n] for row in rows]))
    for i in reversed(range(n)):
        for j in range(n, len(rows[i])):
            total = rows[i][j] - sum(rows[i][k] * rows[k][j] for k in range(i + 1, n))
            rows[i][j] = total / rows[i][i]
    return [row[n:] for row in rows], factors


def _rounded_sizes(rows: list[list[Any]]) -> Sizes:
    return np.array([[abs(float(value)) for value in row] for row in rows])
