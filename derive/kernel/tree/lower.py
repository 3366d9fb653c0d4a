"""From the derivation to the tree: expressions and blocks as nodes, in the order in which they round."""

import operator
from collections.abc import Iterable, Sequence
from functools import partial, reduce

import sympy as sp

from ...program.block import Block, Quantity, Step, common_factor
from ...program.order import AS_DERIVED, NOTHING, Ready, ready_in, terms_in_order
from . import nodes as t

OUT = "out"

Arguments = dict[str, tuple[str, tuple[Quantity, ...]]]
"""Structure of each argument of a block, "" of a number or an array, and the quantities that it holds."""


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


def stored_type(quantity: Quantity) -> t.Type:
    """The type of a quantity as a member: a number, or an array of its components in storage order."""
    return t.Array(t.Real(), (len(quantity.keys),)) if quantity.shape else t.Real()


def unit_and_meaning(quantity: Quantity) -> str:
    """``kg m: first moment``; of what has no unit the meaning alone."""
    return f"{quantity.unit}: {quantity.meaning}".removeprefix(": ")


def structure(name: str, meaning: str, quantities: Iterable[Quantity], *more: t.Field) -> t.Structure:
    """A structure with one member for each quantity, and ``more``."""
    members = tuple(t.Field(q.name, stored_type(q), unit_and_meaning(q)) for q in quantities)
    return t.Structure(name, meaning, (*members, *more))


def component(owner: t.Expression, quantity: Quantity, index: int) -> t.Expression:
    """One component of a quantity that is a member of a structure."""
    member = t.Member(owner, quantity.name)
    return t.Element(member, (t.Number(index),)) if quantity.shape else member


def block_function(block: Block, name: str, result: str, arguments: Arguments) -> t.Function:
    """A block as a function that returns a structure of its outputs.

    result: the structure's name. arguments: the structures that it reads, with the quantities in each, by the
    name of the argument; without a structure's name the argument is a number, or an array of all components.
    """
    owners = {q: argument for argument, (_, held) in arguments.items() for q in held}
    used = {symbol.name for expr in block.expressions() for symbol in expr.free_symbols}
    kinds = {name: _argument_type(kind, held) for name, (kind, held) in arguments.items()}
    loads = [
        t.Let(part, component(t.Name(owners[q]), q, i))
        for q in block.used_inputs()
        if arguments[owners[q]][0]
        for i, part in enumerate(q.names)
        if part in used
    ]
    loads += [
        t.Let(part, t.Element(t.Name(argument), (t.Number(i),)))
        for argument, (_, held) in arguments.items()
        if isinstance(kinds[argument], t.Array)
        for i, part in enumerate(part for q in held for part in q.names)
        if part in used
    ]
    out = t.Name(OUT)
    stores = [
        t.Assign(component(out, output.quantity, i), expression(expr))
        for output in block.outputs
        for i, expr in enumerate(output.exprs)
    ]
    meaning = f"{block.meaning[0].upper()}{block.meaning[1:]}: {block.operations()}."
    given = tuple(t.Argument(name, kind) for name, kind in kinds.items())
    made = t.Variable(OUT, t.Record(result), blank=True)
    body = (*loads, *steps_of(block.steps), made, *stores, t.Return(out))
    return t.Function(name, meaning, given, t.Record(result), body)


def _argument_type(kind: str, held: tuple[Quantity, ...]) -> t.Type:
    if kind:
        return t.Record(kind)
    return t.Array(t.Real(), (sum(len(q.keys) for q in held),)) if any(q.shape for q in held) else t.Real()


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
