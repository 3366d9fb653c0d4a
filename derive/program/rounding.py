"""Bounds of the rounding error of each step of a block, by running error analysis.

A step x = f(y, z, ...) is evaluated in floating point with inputs y, z, ... that have errors. Let y_err be a
bound of the error of y, and y_max = |y| + y_err a bound of the computed and the true |y|. Let u be the unit
roundoff. Then

    x_err = sum over y of |df/dy| y_err + u (sum of the magnitudes of all intermediate results + |x|).

To bound |df/dy| and the intermediate results, all terms are made positive, with y_max for each symbol y. By
the mean value theorem the first sum bounds the effect of the errors of y, z, ... to all orders. The second
sum counts each operation once, in the order in which sums are printed and added (Wilkinson; Higham, Accuracy
and Stability of Numerical Algorithms, 3.1 and 3.3). Products with powers of two are exact, except for
underflow. The value of u must be slightly larger than the unit roundoff, to cover the rounding of x_err
itself.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from math import prod

import sympy as sp

from .block import Block, Output, Quantity, Step, component_name
from .order import NOTHING, Ready, ready_in, terms_in_order

PLAIN, ROOT, RECIPROCAL = "plain", "root", "reciprocal"


@dataclass(frozen=True)
class RoundedStep:
    """Step with the terms of its error bound.

    Attributes
    ----------
    step : Step
        Step.
    kind : str
        PLAIN, or ROOT or RECIPROCAL of an argument; ``carried`` and ``rounded`` then belong to the argument.
    carried : Expr
        Effect of the errors of the inputs.
    rounded : Expr
        Sum of the magnitudes of intermediate results that are rounded.
    own : bool
        True if the last operation rounds, with an error of u |x|.
    """

    step: Step
    kind: str
    carried: sp.Expr
    rounded: sp.Expr
    own: bool

    @property
    def rounds(self) -> bool:
        """True if the step adds a rounding error to the errors of its inputs."""
        return self.own or self.rounded != 0

    @property
    def exact(self) -> bool:
        """True if the value of the step has no error."""
        return not self.rounds and self.carried == 0


@dataclass(frozen=True)
class RoundedBlock:
    """Block whose steps compute bounds of their errors.

    Attributes
    ----------
    block : Block
        The same program, in which each output is a name or a negated name.
    steps : tuple of RoundedStep
        Steps with their error bounds.
    errors : mapping
        Error of each input and step: a symbol or zero.
    limits : frozenset of str
        Names of inputs and steps whose largest magnitude y_max occurs in an error bound.
    ready : mapping
        Times at which the steps are available.
    """

    block: Block
    steps: tuple[RoundedStep, ...]
    errors: Mapping[str, sp.Expr]
    limits: frozenset[str]
    ready: Ready

    def order_of(self, step: Step) -> Ready:
        """Return the times that order the terms of a step, or NOTHING for components of outputs.

        Output components are computed where they are stored, after all steps.
        """
        return self.ready if step.name in self.ready else NOTHING

    def output_error(self, expr: sp.Expr) -> sp.Expr:
        """Return the error of an output component."""
        return self.errors[next(iter(expr.free_symbols)).name] if expr.free_symbols else sp.S.Zero

    def inexact(self, quantity: Quantity) -> bool:
        """Return True if a component of an output has an error."""
        out = next(out for out in self.block.outputs if out.quantity == quantity)
        return any(self.output_error(expr) != 0 for expr in out.exprs)


def rounded(block: Block, errors: Mapping[str, sp.Expr], ready: Ready | None = None) -> RoundedBlock:
    """Derive the error bounds of a block.

    Parameters
    ----------
    errors : mapping
        Errors of input components by name; omitted components are exact.
    ready : mapping, optional
        Times at which the steps are available, required if the block combines several blocks.
    """
    named = _outputs_named(block)
    known = {name: errors.get(name, sp.S.Zero) for quantity in named.inputs for name in quantity.names}
    ready = ready_in(block.steps) if ready is None else ready
    steps = []
    for step in named.steps:
        steps.append(_rounded_step(step, known, ready if step.name in ready else NOTHING))
        known[step.name] = sp.S.Zero if steps[-1].exact else error_symbol(step.name)
    limits = {
        symbol.name.removesuffix(_MAX)
        for step in steps
        for expr in (step.carried, step.rounded)
        for symbol in expr.free_symbols
        if symbol.name.endswith(_MAX)
    }
    return RoundedBlock(named, tuple(steps), known, frozenset(limits), ready)


_ERROR, _MAX = "_err", "_max"


def error_symbol(name: str) -> sp.Symbol:
    """Return ``q_x_err``, the bound of the error of ``q_x``."""
    return sp.Symbol(name + _ERROR, real=True)


def limit_symbol(name: str) -> sp.Symbol:
    """Return ``q_x_max``, the bound of the magnitude of the computed and the true ``q_x``."""
    return sp.Symbol(name + _MAX, real=True)


def component_errors(quantities: Iterable[Quantity]) -> dict[str, sp.Expr]:
    """Return a separate error symbol for each component of the quantities."""
    return {name: error_symbol(name) for quantity in quantities for name in quantity.names}


def _outputs_named(block: Block) -> Block:
    """Add a step for each output component that is an expression."""
    steps, outputs = list(block.steps), []
    taken = {step.name for step in steps} | {name for q in block.inputs for name in q.names}
    for out in block.outputs:
        names = []
        for key, expr in zip(out.quantity.keys, map(sp.sympify, out.exprs), strict=True):
            if expr.is_Atom or (-expr).is_Atom:
                names.append(expr)
                continue
            step = Step(component_name(out.quantity.name, key), expr, "", out.quantity.meaning)
            if step.name in taken:
                raise ValueError(f"{step.name}: expected an output with an unused name")
            steps.append(step)
            names.append(step.symbol)
        outputs.append(Output(out.quantity, tuple(names)))
    return replace(block, steps=tuple(steps), outputs=tuple(outputs))


def _rounded_step(step: Step, errors: Mapping[str, sp.Expr], ready: Ready) -> RoundedStep:
    expr = step.expr
    if expr.is_Pow and expr.exp == sp.Rational(1, 2):
        argument = expr.base
        return RoundedStep(step, ROOT, _carried(argument, errors), _roundings(argument, ready), True)
    if expr.is_Pow and expr.exp == -1 and expr.base.is_Symbol:
        return RoundedStep(step, RECIPROCAL, errors[expr.base.name], sp.S.Zero, True)
    inner, own = _inner_roundings(expr, ready)
    return RoundedStep(step, PLAIN, _carried(expr, errors), inner, own)


def _carried(expr: sp.Expr, errors: Mapping[str, sp.Expr]) -> sp.Expr:
    """Bound the effect of the symbols' errors: the sum of error times largest partial derivative."""
    size = _size(expr)
    shares: dict[sp.Expr, sp.Expr] = {}
    for name in sorted(symbol.name for symbol in expr.free_symbols):
        error = errors[name]
        if error != 0:
            shares[error] = shares.get(error, sp.S.Zero) + sp.diff(size, limit_symbol(name))
    return sp.Add(*(error * slope for error, slope in shares.items()))


def _size(expr: sp.Expr) -> sp.Expr:
    """Return the expression with positive terms and each symbol at its bound."""
    if expr.is_Symbol:
        return limit_symbol(expr.name)
    if expr.is_Rational:
        return abs(expr)
    if expr.is_Add:
        return sp.Add(*map(_size, expr.args))
    if expr.is_Mul:
        return sp.Mul(*map(_size, expr.args))
    if expr.is_Pow and expr.exp.is_Integer and expr.exp > 1:
        return _size(expr.base) ** expr.exp
    raise ValueError(f"no error bound for {type(expr).__name__} in {expr}: name it as a step")


def _roundings(expr: sp.Expr, ready: Ready) -> sp.Expr:
    """Sum the magnitudes of all rounded results of an expression, including the last one."""
    inner, own = _inner_roundings(expr, ready)
    return inner + _size(expr) if own else inner


def _inner_roundings(expr: sp.Expr, ready: Ready) -> tuple[sp.Expr, bool]:
    """Sum the magnitudes of the rounded results before the last operation, and return whether it rounds."""
    if expr.is_Atom:
        return sp.S.Zero, False
    if expr.is_Add:
        terms = terms_in_order(expr, ready)
        below = sum((_roundings(term, ready) for term in terms), sp.S.Zero)
        # The first and the second term are in every partial sum, each later term in one fewer
        # than the term before.
        on_the_way = ((len(terms) - max(i, 2)) * _size(term) for i, term in enumerate(terms, start=1))
        return below + sum(on_the_way, sp.S.Zero), True
    coefficient, rest = expr.as_coeff_Mul()
    factors = [base for factor in sp.Mul.make_args(rest) for base in _repeated(factor)]
    sizes = [_size(factor) for factor in factors]
    below = sum(
        (
            abs(coefficient) * _roundings(factor, ready) * prod(sizes[:i] + sizes[i + 1 :], start=sp.S.One)
            for i, factor in enumerate(factors)
        ),
        sp.S.Zero,
    )
    products = len(factors) - 1 + (not _power_of_two(coefficient))
    return below + max(products - 1, 0) * _size(expr), products > 0


def _repeated(factor: sp.Expr) -> list[sp.Expr]:
    """Return the factors of an integer power."""
    if factor.is_Pow and factor.exp.is_Integer and factor.exp > 1:
        return [factor.base] * int(factor.exp)
    return [factor]


def _power_of_two(number: sp.Rational) -> bool:
    return all(part & (part - 1) == 0 for part in (abs(number.p), number.q))
