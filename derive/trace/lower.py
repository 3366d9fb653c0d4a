"""Conversion of expressions and steps of the derivation to tree nodes, in the order of their rounding."""

import operator
from collections.abc import Iterable, Sequence
from functools import partial, reduce

import sympy as sp

from ..program.block import Step, common_factor
from ..program.order import AS_DERIVED, NOTHING, Ready, ready_in, terms_in_order
from . import nodes as t


def expression(expr: sp.Expr, ready: Ready = NOTHING) -> t.Expression:
    """An expression of symbols, sums, products, whole powers, reciprocals and square roots as a tree.

    ready: when named steps are, which orders the terms of sums. Raises ValueError for anything else.
    """
    expr = sp.sympify(expr)
    if expr.is_Symbol:
        return t.Name(expr.name)
    if expr.is_Integer:
        return t.Negative(t.Number(float(-expr))) if expr < 0 else t.Number(float(expr))
    if expr == sp.Rational(1, 2):
        return t.Number(0.5)
    if expr.is_Add and (common := common_factor(expr)) != 1:
        return expression(common, ready) * expression(expr / common, ready)
    if expr.is_Add:
        first, *others = terms_in_order(expr, ready)
        return reduce(partial(_plus, ready=ready), others, expression(first, ready))
    if expr.is_Mul:
        return _product(expr, ready)
    if expr.is_Pow:
        return _power(expr, ready)
    raise ValueError(f"cannot lower {type(expr).__name__}: {expr}")


def _plus(total: t.Expression, term: sp.Expr, ready: Ready) -> t.Expression:
    if term.could_extract_minus_sign():
        return total - expression(-term, ready)
    return total + expression(term, ready)


def _product(expr: sp.Mul, ready: Ready) -> t.Expression:
    coefficient, rest = expr.as_coeff_Mul()
    if coefficient.is_negative:
        return t.Negative(expression(-expr, ready))
    factors = ([coefficient] if coefficient != 1 else []) + list(sp.Mul.make_args(rest))
    over = [f.base for f in factors if f.is_Pow and f.exp == -1]
    upper = [f for f in factors if not (f.is_Pow and f.exp == -1)]
    value = _multiplied(upper, ready)
    return value / _multiplied(over, ready) if over else value


def _multiplied(factors: Iterable[sp.Expr], ready: Ready) -> t.Expression:
    # Whole powers are factors one by one: m L^2 is (m L) L, as the emitters of C and NumPy print it.
    apart = [part for factor in factors for part in _repeated(factor)]
    found = [expression(factor, ready) for factor in apart] or [t.Number(1.0)]
    return reduce(operator.mul, found)


def _repeated(factor: sp.Expr) -> list[sp.Expr]:
    if factor.is_Pow and factor.exp.is_Integer and factor.exp > 1 and factor.base.is_Symbol:
        return [factor.base] * int(factor.exp)
    return [factor]


def _power(expr: sp.Pow, ready: Ready) -> t.Expression:
    if expr.exp == sp.Rational(1, 2):
        return t.Call("sqrt", (expression(expr.base, ready),))
    if expr.exp == -1:
        return t.Number(1.0) / expression(expr.base, ready)
    if expr.exp.is_Integer and expr.exp > 1 and expr.base.is_Symbol:
        return _multiplied([expr.base] * int(expr.exp), ready)
    raise ValueError(f"cannot lower the power {expr}: its base needs a name")


def steps_of(steps: Sequence[Step], ready: Ready | None = None) -> list[t.Statement]:
    """Each step, with its equation and meaning before the first of a run that shares them.

    ready: when they are; steps that are not in it are computed as where results are stored.
    """
    ready = ready_in(steps) if ready is None else ready
    found: list[t.Statement] = []
    for step, before in zip(steps, (None, *steps), strict=False):
        order = ready if ready is AS_DERIVED or step.name in ready else NOTHING
        found += [*remark(step, before), t.Let(step.name, expression(step.expr, order))]
    return found


def remark(step: Step, before: Step | None) -> list[t.Statement]:
    """Equation and meaning of a step, unless the one before it has the same."""
    said = (step.equation, step.meaning)
    alike = before is not None and said == (before.equation, before.meaning)
    return [t.Comment(" ".join(filter(None, said)))] if any(said) and not alike else []
