"""Numbers in 50-digit arithmetic with bounds of floating-point rounding errors, and linear systems of them.

Running error analysis to first order (Wilkinson; Higham, Accuracy and Stability of Numerical Algorithms,
3.3): every operation adds half a rounding unit of its result to the propagated errors of its operands. The
error of the solution of a linear system is computed from the inverse, entry by entry (Higham, 7.2 and 9.3),
because bounds propagated through an elimination would be far too large.
"""

import math
from functools import total_ordering
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from ..precision.truth import digits

Objects = NDArray[Any]
Sizes = NDArray[np.float64]

HALF_UNIT = 0.5
"""Largest relative error of rounding to nearest, in rounding units (epsilon)."""

MARGIN = 2.1
"""Ratio of the error bound of a test to the computed error bound.

C groups the same operations in another way, and a bound may decrease by a twentieth when it is rounded to two
digits.
"""

FORCES_MARGIN = 1.25
"""Ratio of the error bound of a test of the forces to the computed error bound.

The C code of the forces has the same steps. It may differ in the order of the sums over the legs, and in the
pivots if two candidates are nearly equal.
"""


@total_ordering
class Running:
    """Number in 50-digit arithmetic with the first-order bound of its absolute error in rounding units.

    The operations are the operations of kernels: + - * / and comparisons with other ``Running`` numbers,
    integers, and exact floats, and ``sqrt``.
    """

    __slots__ = ("error", "size", "value")
    # NumPy applies the operations to each number of an object array.
    _spread_by: ClassVar[tuple[type, ...]] = (np.ndarray,)

    def __init__(self, value: Any, error: Any = 0.0, rounded: bool = False) -> None:
        """Convert ``value`` to 50 digits; ``rounded`` is True for the result of an operation that rounds."""
        self.value, self.size = self._stored(value)
        self.error = error + HALF_UNIT * self.size if rounded else error

    @staticmethod
    def _stored(value: Any) -> tuple[Any, Any]:
        """Return the stored value, and its absolute value in double precision."""
        number = value if isinstance(value, digits.mpf) else digits.mpf(value)
        return number, abs(float(number))

    @classmethod
    def of(cls, value: Any) -> Self:
        """Convert a number to an error-free ``Running``, unless it is a ``Running`` already."""
        return value if isinstance(value, cls) else cls(value)

    def __add__(self, other: Any) -> Self:
        """Add; exact if one operand is exactly zero."""
        if isinstance(other, self._spread_by):
            return NotImplemented
        other = self.of(other)
        rounds = not (self.is_zero or other.is_zero)
        return type(self)(self.value + other.value, self.error + other.error, rounds)

    def __sub__(self, other: Any) -> Self:
        """Subtract; exact if one operand is exactly zero."""
        return NotImplemented if isinstance(other, self._spread_by) else self + -self.of(other)

    def __mul__(self, other: Any) -> Self:
        """Multiply; exact if one operand is a power of two."""
        if isinstance(other, self._spread_by):
            return NotImplemented
        other = self.of(other)
        carried = self.size * other.error + other.size * self.error
        rounds = not (self.is_power or other.is_power)
        return type(self)(self.value * other.value, carried, rounds)

    def __truediv__(self, other: Any) -> Self:
        """Divide."""
        if isinstance(other, self._spread_by):
            return NotImplemented
        other = self.of(other)
        made = type(self)(self.value / other.value, 0.0, rounded=True)
        made.error = made.error + (self.error + made.size * other.error) / other.size
        return made

    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, other: Any) -> Self:
        """Subtract this number from another one."""
        return self.of(other) - self

    def __rtruediv__(self, other: Any) -> Self:
        """Divide another number by this one."""
        return self.of(other) / self

    def __neg__(self) -> Self:
        """Reverse the sign; exact."""
        return type(self)(-self.value, self.error)

    def __abs__(self) -> Self:
        """Return the absolute value; exact."""
        return type(self)(abs(self.value), self.error)

    def __lt__(self, other: Any) -> bool:
        """Compare the values without their errors."""
        return bool(self.value < self.of(other).value)

    def __eq__(self, other: object) -> bool:
        """Compare the values without their errors."""
        return bool(self.value == self.of(other).value)

    __hash__ = None  # type: ignore[assignment]

    def sqrt(self) -> Self:
        """Compute the square root."""
        made = type(self)(self._root(self.value), 0.0, rounded=True)
        made.error = made.error + self.error / (2.0 * made.size)
        return made

    @staticmethod
    def _root(value: Any) -> Any:
        return digits.sqrt(value)

    @property
    def is_zero(self) -> bool:
        """True if the number is zero on every machine."""
        return bool(self.size == 0.0 and self.error == 0.0)

    @property
    def is_power(self) -> bool:
        """True if the number is exactly zero or a power of two, so that products with it are exact."""
        return bool(self.error == 0.0 and math.frexp(self.size)[0] in (0.0, 0.5))


class RunningArrays(Running):
    """Arrays of running numbers in double precision, for the magnitude of their errors."""

    __slots__ = ()
    _spread_by = ()
    __array_ufunc__ = None

    @staticmethod
    def _stored(value: Any) -> tuple[Any, Any]:
        stored = np.asarray(value, dtype=np.float64)
        return stored, np.abs(stored)

    @staticmethod
    def _root(value: Any) -> Any:
        return np.sqrt(value)

    def __getitem__(self, index: Any) -> Self:
        """Select some of the numbers."""
        shape = np.broadcast_shapes(np.shape(self.value), np.shape(self.error))
        value, error = (np.broadcast_to(each, shape)[index] for each in (self.value, self.error))
        return type(self)(value, error)

    @property
    def is_zero(self) -> bool:
        """True if all numbers are zero on every machine."""
        return not (np.any(self.error) or np.any(self.size))

    @property
    def is_power(self) -> bool:
        """True if all numbers are exactly zero or exactly powers of two."""
        if np.any(self.error):
            return False
        fraction = np.frexp(self.size)[0]
        return bool(np.all((fraction == 0.0) | (fraction == 0.5)))


def array(values: Any, shape: tuple[int, ...] | None = None) -> Objects:
    """Convert ``Running`` or exact numbers to an array of ``Running``."""
    given = np.asarray(values, dtype=object)
    given = given if shape is None else np.broadcast_to(given, shape)
    made = np.empty(given.shape, dtype=object)
    for where in np.ndindex(given.shape):
        made[where] = Running.of(given[where])
    return made


def sizes(numbers: Objects) -> Sizes:
    """Return the absolute values of an array of ``Running``, with the same shape."""
    return np.array([number.size for number in numbers.flat]).reshape(numbers.shape)


def errors(numbers: Objects) -> Sizes:
    """Return the errors of an array of ``Running`` (rounding units), with the same shape."""
    return np.array([number.error for number in numbers.flat]).reshape(numbers.shape)


def values(numbers: Objects) -> Sizes:
    """Return the values of an array of ``Running``, each rounded once, with the same shape."""
    return np.array([float(number.value) for number in numbers.flat]).reshape(numbers.shape)


def solve(A: Objects, right: Objects) -> Objects:
    """Solve A X = right with errors of elimination with partial pivoting.

    The shapes are (n, n) of A and (n, m) of ``right`` and of the result. The error is |A^-1| (|dA| |X| + |d
    right| + n / 2 |L| |U| |X|), half a unit for each of the n operations of an entry of L U.
    """
    return _solved(A, right, pivoted=True)


def solve_definite(M: Objects, right: Objects) -> Objects:
    """Solve M X = right for positive definite M (n, n) with errors of the factorization L D L^T; shapes as in
    ``solve``.
    """
    return _solved(M, right, pivoted=False)


def inverse_sizes(A: Objects) -> Sizes:
    """Compute |A^-1|, shape (n, n)."""
    return _rounded_sizes(_inverse(A))


def _inverse(A: Objects) -> Any:
    return digits.inverse(digits.matrix([[a.value for a in row] for row in A]))


def _solved(A: Objects, right: Objects, pivoted: bool) -> Objects:
    inverse = _inverse(A)
    found = inverse * digits.matrix([[b.value for b in row] for row in right])
    factors = factor_sizes(values(A)[None], pivoted)[0]
    terms = (errors(A) + len(A) * HALF_UNIT * factors) @ _rounded_sizes(found) + errors(right)
    error = _rounded_sizes(inverse) @ terms
    solution = np.empty(right.shape, dtype=object)
    for i, j in np.ndindex(right.shape):
        solution[i, j] = Running(found[i, j], float(error[i, j]))
    return solution


def factor_sizes(A: Sizes, pivoted: bool = True) -> Sizes:
    """Compute |L| |U| of an elimination, with rows in the order of A; shapes (m, n, n).

    ``pivoted`` selects partial pivoting.
    """
    U = A.copy()
    count, n, _ = U.shape
    order, L = np.tile(np.arange(n), (count, 1)), np.tile(np.eye(n), (count, 1, 1))
    each = np.arange(count)
    for k in range(n):
        p = k + (np.argmax(np.abs(U[:, k:, k]), axis=1) if pivoted else np.zeros(count, dtype=int))
        for rows in (U, order, L[:, :, :k]):
            rows[each, k], rows[each, p] = rows[each, p], rows[each, k].copy()
        factor = U[:, k + 1 :, k] / U[:, k, None, k]
        L[:, k + 1 :, k] = np.abs(factor)
        U[:, k + 1 :] -= factor[..., None] * U[:, k, None]
    factors = np.empty_like(U)
    factors[each[:, None], order] = L @ np.abs(np.triu(U))
    return factors


def _rounded_sizes(matrix: Any) -> Sizes:
    return np.abs(np.array(matrix.tolist(), dtype=np.float64))
