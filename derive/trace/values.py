"""Values of a kernel: one number for each pose, or one number for each leg of a pose.

A kernel is an ordinary Python function that computes with values. Python runs it once, and ``recorder.Trace``
records the steps. Loops, conditions, and functions of Python leave no trace.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..trace import nodes as t

if TYPE_CHECKING:
    from .recorder import Trace

LEGS = 6
ZERO = t.Number(0.0)


@dataclass(frozen=True, eq=False)
class Value:
    """Number of a pose, or one number for each of its legs.

    Attributes
    ----------
    expr : Expression
        Expression of recorded names and inputs.
    per_leg : bool
        True for one number for each leg.
    trace : Trace, optional
        Trace that records the steps; constants have none.
    """

    expr: t.Expression
    per_leg: bool = False
    trace: Trace | None = None

    def _with(self, operator: str, other: Value | float, swapped: bool = False) -> Value:
        left, right = (as_value(other), self) if swapped else (self, as_value(other))
        expr = binary(operator, left.expr, right.expr)
        return Value(expr, left.per_leg or right.per_leg, self.trace or right.trace)

    def __add__(self, other: Value | float) -> Value:
        return self._with("+", other)

    def __sub__(self, other: Value | float) -> Value:
        return self._with("-", other)

    def __mul__(self, other: Value | float) -> Value:
        return self._with("*", other)

    def __truediv__(self, other: Value | float) -> Value:
        return self._with("/", other)

    def __radd__(self, other: Value | float) -> Value:
        return self._with("+", other, swapped=True)

    def __rsub__(self, other: Value | float) -> Value:
        return self._with("-", other, swapped=True)

    def __rmul__(self, other: Value | float) -> Value:
        return self._with("*", other, swapped=True)

    def __rtruediv__(self, other: Value | float) -> Value:
        return self._with("/", other, swapped=True)

    def __gt__(self, other: Value | float) -> Value:
        return self._with(">", other)

    def __le__(self, other: Value | float) -> Value:
        return self._with("<=", other)

    def differs_from(self, other: Value | float) -> Value:
        """Return the test that two numbers are not equal."""
        return self._with("!=", other)

    def __neg__(self) -> Value:
        return Value(t.Negative(self.expr), self.per_leg, self.trace)

    def __abs__(self) -> Value:
        return Value(t.Call("size", (self.expr,)), self.per_leg, self.trace)

    def __bool__(self) -> bool:
        """Reject ``if`` and ``while`` on a number that is unknown when the kernel is traced."""
        raise TypeError("a value has no truth while a kernel is traced; use where(test, yes, no)")

    @property
    def name(self) -> str:
        """Name of a recorded value."""
        assert isinstance(self.expr, t.Name)
        return self.expr.name

    def at(self, leg: int) -> Value:
        """Return the number of one leg, counted from 0."""
        assert self.trace is not None
        if leg == 0 and self.name in self.trace.zero_at_first:
            return Value(ZERO, False, self.trace)
        return Value(t.Element(self.expr, (t.Number(leg),)), False, self.trace)

    def legs(self) -> list[Value]:
        """Return the numbers of the six legs."""
        return [self.at(leg) for leg in range(LEGS)]


def binary(operator: str, left: t.Expression, right: t.Expression) -> t.Expression:
    """Return an operation; sums and products with the literal zero are simplified."""
    if operator == "*" and ZERO in (left, right):
        return ZERO
    if operator == "-" and left == ZERO:
        return t.Negative(right)
    if operator in "+-" and right == ZERO:
        return left
    return right if operator == "+" and left == ZERO else t.Binary(operator, left, right)


def as_value(number: Value | float) -> Value:
    """Return a number as a value."""
    return number if isinstance(number, Value) else Value(t.Number(float(number)))


def constant(name: str) -> Value:
    """Return an arithmetic constant such as ``ROUNDING``."""
    return Value(t.Constant(name))


def where(test: Value, yes: Value | float, no: Value | float) -> Value:
    """Return ``yes`` if the test is true, else ``no``."""
    one, other = as_value(yes), as_value(no)
    per_leg = test.per_leg or one.per_leg or other.per_leg
    return Value(t.Select(test.expr, one.expr, other.expr), per_leg, test.trace)


def larger(one: Value, two: Value | float) -> Value:
    """Return the larger of two values."""
    other = as_value(two)
    expr = t.Call("larger", (one.expr, other.expr))
    return Value(expr, one.per_leg or other.per_leg, one.trace or other.trace)
