"""Transformations of a block into an equal one with fewer operations.

``share`` eliminates common subexpressions. Each one is placed before the first group of steps that requires
it. The named steps remain, so each line of the result can be traced to an equation of the paper.
"""

from collections.abc import Iterable, Mapping
from dataclasses import fields, replace
from typing import Any, ClassVar, Protocol, TypeVar

import sympy as sp

from .block import Block, Builder, Output, Quantity, Step, count, rebuilt


def specialized(block: Block, values: Mapping[sp.Symbol, sp.Expr], new: Iterable[Quantity] = ()) -> Block:
    """Replace some inputs of a block; steps that become a number or a symbol are removed.

    Parameters
    ----------
    values : mapping
        Number or expression for each replaced input symbol, in terms of the block's or the ``new`` inputs.
    new : iterable of Quantity
        Additional inputs.
    """
    known = dict(values)
    build = Builder()
    for step in block.steps:
        named = build.scalar(step.name, step.expr.xreplace(known), step.equation, step.meaning)
        if named != step.symbol:
            known[step.symbol] = named
    outputs = [Output(out.quantity, tuple(e.xreplace(known) for e in out.exprs)) for out in block.outputs]
    return rebuilt(block, build.steps, outputs, (*block.inputs, *new))


def share(block: Block) -> Block:
    """Eliminate common subexpressions of a block."""
    names = sp.numbered_symbols("c", real=True, start=1)
    taken = {step.name for step in block.steps} | {name for q in block.inputs for name in q.names}
    fresh = (symbol for symbol in names if symbol.name not in taken)
    shared, reduced = _without_free(*sp.cse(block.expressions(), symbols=fresh))
    steps = [
        replace(step, expr=expr) for step, expr in zip(block.steps, reduced[: len(block.steps)], strict=True)
    ]
    rest = iter(reduced[len(block.steps) :])
    outputs = tuple(Output(out.quantity, tuple(next(rest) for _ in out.exprs)) for out in block.outputs)
    return replace(block, steps=_placed(shared, steps, outputs), outputs=outputs)


class _Dataclass(Protocol):
    __dataclass_fields__: ClassVar[dict[str, Any]]


_Kernel = TypeVar("_Kernel", bound=_Dataclass)


def shared_blocks(kernel: _Kernel) -> _Kernel:
    """Apply ``share`` to each block of a dataclass."""
    members = {each.name: getattr(kernel, each.name) for each in fields(kernel)}
    return replace(
        kernel, **{name: share(block) for name, block in members.items() if isinstance(block, Block)}
    )


def _without_free(
    shared: list[tuple[sp.Symbol, sp.Expr]], reduced: list[sp.Expr]
) -> tuple[list[tuple[sp.Symbol, sp.Expr]], list[sp.Expr]]:
    """Substitute shared subexpressions that need no operation, such as a negation."""
    free: dict[sp.Symbol, sp.Expr] = {}
    kept = []
    for symbol, expr in shared:
        expr = expr.xreplace(free)
        if count([expr]).total == 0:
            free[symbol] = expr
        else:
            kept.append((symbol, expr))
    return kept, [expr.xreplace(free) for expr in reduced]


def _placed(
    shared: list[tuple[sp.Symbol, sp.Expr]], steps: list[Step], outputs: tuple[Output, ...]
) -> tuple[Step, ...]:
    """Insert each shared subexpression before the first group of steps that requires it.

    A group is a sequence of steps with one meaning, such as the components of a vector, in which no component
    uses another one.
    """
    waiting = dict(shared)
    program: list[Step] = []

    def bring(expr: sp.Expr) -> None:
        for symbol in sorted(expr.free_symbols & waiting.keys(), key=lambda found: int(found.name[1:])):
            if symbol in waiting:
                definition = waiting.pop(symbol)
                bring(definition)
                program.append(Step(symbol.name, definition))

    for group in _groups(steps, waiting):
        for step in group:
            bring(step.expr)
        program.extend(group)
    for out in outputs:
        for expr in out.exprs:
            bring(expr)
    return tuple(program)


def _groups(steps: list[Step], shared: dict[sp.Symbol, sp.Expr]) -> list[list[Step]]:
    """Group successive steps with equal equation and meaning that do not use each other's results."""
    reach: dict[sp.Symbol, set[sp.Symbol]] = {}
    for symbol, expr in shared.items():
        reach[symbol] = set().union(expr.free_symbols, *(reach.get(s, set()) for s in expr.free_symbols))
    groups: list[list[Step]] = []
    for step in steps:
        needs = set().union(step.expr.free_symbols, *(reach.get(s, set()) for s in step.expr.free_symbols))
        group = groups[-1] if groups else []
        alike = (
            group and step.meaning and (step.equation, step.meaning) == (group[0].equation, group[0].meaning)
        )
        if alike and not needs & {member.symbol for member in group}:
            group.append(step)
        else:
            groups.append([step])
    return groups
