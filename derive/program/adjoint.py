"""Reverse-mode differentiation of a block.

It computes the derivatives of a weighted sum of outputs with respect to all steps and inputs. The result is a
block that runs after the original one and may read all of its quantities.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import sympy as sp

from .block import Block, Builder, Output, Quantity, Step, component_name
from .cse import share

Weights = Mapping[Quantity, sp.Matrix | sp.Expr]

_SLOPE = "_bar"


@dataclass(frozen=True)
class Adjoint:
    """Derivatives with respect to the steps and inputs of a block.

    Attributes
    ----------
    block : Block
        Program that computes the derivatives from all quantities of the original block and the weights.
    slopes : mapping
        Maps the name of each step and requested input to its derivative, a symbol of ``block`` or its
        negative. Quantities without influence are omitted.
    """

    block: Block
    slopes: Mapping[str, sp.Expr]


def adjoint(
    block: Block,
    weights: Weights,
    given: Iterable[Quantity],
    wanted: Iterable[str],
    more: Mapping[str, sp.Expr] | None = None,
) -> Adjoint:
    """Differentiate the sum of weights times outputs of a block.

    Parameters
    ----------
    weights : mapping
        Weights of some outputs, as expressions of the quantities ``given``.
    given : iterable of Quantity
        Quantities in the weights.
    wanted : iterable of str
        Names of the input components by which to differentiate.
    more : mapping, optional
        Terms that other programs add to these derivatives.
    """
    build = Builder()
    terms: dict[str, list[sp.Expr]] = {name: [expr] for name, expr in (more or {}).items()}
    for out in block.outputs:
        if out.quantity in weights:
            for weight, expr in zip(_entries(build, out.quantity, weights), out.exprs, strict=True):
                _spread(expr, weight, terms)
    slopes: dict[str, sp.Expr] = {}
    roots = {step.expr.base: step.symbol for step in block.steps if _is_reciprocal(step.expr)}
    for step in reversed(block.steps):
        if step.name in terms:
            slopes[step.name] = build.scalar(step.name + _SLOPE, sp.Add(*terms[step.name]))
            _through(step, slopes[step.name], roots, terms)
    for name in wanted:
        if name in terms:
            slopes[name] = build.scalar(name + _SLOPE, sp.Add(*terms[name]))
    scalars = [Quantity(step.name, (), "", "") for step in block.steps]
    outputs = tuple(
        Output(Quantity(f"slope of {name}", (), "", ""), (expr,)) for name, expr in slopes.items()
    )
    found = Block(f"{block.name}_adjoint", "", (*block.inputs, *scalars, *given), tuple(build.steps), outputs)
    shared = share(found)
    return Adjoint(
        replace(shared, inputs=shared.used_inputs()),
        {name: out.exprs[0] for name, out in zip(slopes, shared.outputs, strict=True)},
    )


def _entries(build: Builder, quantity: Quantity, weights: Weights) -> list[sp.Expr]:
    """Name the weights of a quantity's components."""
    values = weights[quantity]
    entries = list(values) if isinstance(values, sp.MatrixBase) else [values]
    return [
        build.scalar(component_name(quantity.name, key) + "_weight", value)
        for key, value in zip(quantity.keys, entries, strict=True)
    ]


def _spread(expr: sp.Expr, slope: sp.Expr, terms: dict[str, list[sp.Expr]]) -> None:
    """Add the chain-rule terms of a polynomial to the terms of its symbols."""
    for name in sorted(symbol.name for symbol in sp.sympify(expr).free_symbols):
        along = sp.diff(expr, sp.Symbol(name, real=True))
        terms.setdefault(name, []).append(slope * along)


def _through(
    step: Step, slope: sp.Expr, roots: Mapping[sp.Expr, sp.Symbol], terms: dict[str, list[sp.Expr]]
) -> None:
    """Add the chain-rule terms of a step to the terms of its symbols."""
    expr = step.expr
    if _is_reciprocal(expr):
        _spread(expr.base, -slope * step.symbol**2, terms)
    elif expr.is_Pow and expr.exp == sp.Rational(1, 2):
        _spread(expr.base, slope * roots[step.symbol] / 2, terms)
    else:
        _spread(expr, slope, terms)


def _is_reciprocal(expr: sp.Expr) -> bool:
    return bool(expr.is_Pow and expr.exp == -1)
