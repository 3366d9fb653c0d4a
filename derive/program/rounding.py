"""Rounding: every step of a block with a bound of the rounding error it carries, by running error analysis.

A step x = f(y, z, ...) is run in floating point on y, z, ... that carry errors themselves. With y_err >=
the error of y and y_max = |y| + y_err, which neither y nor its true value exceeds in size,

    x_err = sum over y of |df/dy| y_err + u (sum of the sizes of all intermediate results + |x|),

where |df/dy| and the intermediate results are bounded by taking every term positive and at its y_max. By
the mean value theorem the first sum bounds what the errors of y, z, ... do to f in all orders; the second
one counts each operation once, in the order in which sums are printed and added up (Wilkinson; Higham,
Accuracy and Stability of Numerical Algorithms, 3.1 and 3.3). Products with powers of two are exact, barring
underflow. A few units u of relative error in x_err itself are left to whoever chooses u.
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
    """A step and what bounds its error.

    kind: PLAIN; or ROOT or RECIPROCAL of an argument, then ``carried`` and ``rounded`` are the argument's.
    carried: what the errors of the inputs come to; rounded: sizes of intermediate results, each rounded once.
    own: whether the last operation rounds, by u |x|.
    """

    step: Step
    kind: str
    carried: sp.Expr
    rounded: sp.Expr
    own: bool

    @property
    def rounds(self) -> bool:
        """Whether the step adds an error to those that it is given."""
        return self.own or self.rounded != 0

    @property
    def exact(self) -> bool:
        """Whether the step's value has no error at all."""
        return not self.rounds and self.carried == 0


@dataclass(frozen=True)
class RoundedBlock:
    """A block whose steps bound their errors.

    block: the same program; every output is a name or a negated one. errors: of every input and step, a
    symbol or zero. limits: names of inputs and steps whose largest size some error needs.
    """

    block: Block
    steps: tuple[RoundedStep, ...]
    errors: Mapping[str, sp.Expr]
    limits: frozenset[str]
    ready: Ready

    def order_of(self, step: Step) -> Ready:
        """What orders the terms of a step; components of outputs are computed where they are stored."""
        return self.ready if step.name in self.ready else NOTHING

    def output_error(self, expr: sp.Expr) -> sp.Expr:
        """Error of a component that leaves the block."""
        return self.errors[next(iter(expr.free_symbols)).name] if expr.free_symbols else sp.S.Zero

    def inexact(self, quantity: Quantity) -> bool:
        """Whether some component of an output has an error."""
        out = next(out for out in self.block.outputs if out.quantity == quantity)
        return any(self.output_error(expr) != 0 for expr in out.exprs)


def rounded(block: Block, errors: Mapping[str, sp.Expr], ready: Ready | None = None) -> RoundedBlock:
    """The block with its error bounds; errors: of input components by name, those left out are exact.

    ready: when its steps are, where the block is made of several.
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
    """``q_x_err``: bound of the error of ``q_x``."""
    return sp.Symbol(name + _ERROR, real=True)


def limit_symbol(name: str) -> sp.Symbol:
    """``q_x_max``: what neither the computed nor the true ``q_x`` exceeds in size."""
    return sp.Symbol(name + _MAX, real=True)


def component_errors(quantities: Iterable[Quantity]) -> dict[str, sp.Expr]:
    """An error of its own for every component of the quantities."""
    return {name: error_symbol(name) for quantity in quantities for name in quantity.names}


def _outputs_named(block: Block) -> Block:
    """The block with a step for every output component that is still computed."""
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
                raise ValueError(f"{step.name}: expected an output with a name of its own")
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
    """What the errors of the symbols come to, by the largest slope along each."""
    size = _size(expr)
    shares: dict[sp.Expr, sp.Expr] = {}
    for name in sorted(symbol.name for symbol in expr.free_symbols):
        error = errors[name]
        if error != 0:
            shares[error] = shares.get(error, sp.S.Zero) + sp.diff(size, limit_symbol(name))
    return sp.Add(*(error * slope for error, slope in shares.items()))


def _size(expr: sp.Expr) -> sp.Expr:
    """The expression with every term positive and every symbol at its limit."""
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
    raise ValueError(f"no error bound for {type(expr).__name__} in {expr}: it needs a name")


def _roundings(expr: sp.Expr, ready: Ready) -> sp.Expr:
    """Sum of the sizes of all results that are rounded on the way to ``expr``, itself the last."""
    inner, own = _inner_roundings(expr, ready)
    return inner + _size(expr) if own else inner


def _inner_roundings(expr: sp.Expr, ready: Ready) -> tuple[sp.Expr, bool]:
    """The same without the last operation, and whether that one rounds."""
    if expr.is_Atom:
        return sp.S.Zero, False
    if expr.is_Add:
        terms = terms_in_order(expr, ready)
        below = sum((_roundings(term, ready) for term in terms), sp.S.Zero)
        # The first term is in every sum on the way, the second one too, each later one in one less.
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
    """The factors of an integer power."""
    if factor.is_Pow and factor.exp.is_Integer and factor.exp > 1:
        return [factor.base] * int(factor.exp)
    return [factor]


def _power_of_two(number: sp.Rational) -> bool:
    return all(part & (part - 1) == 0 for part in (abs(number.p), number.q))
