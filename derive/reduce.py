"""Reduction: rewriting a block into an equal one that computes less.

``share`` finds common subexpressions between the named steps and places each right before its first use; the
named steps stay, so that a line of the result can be traced to a line of the paper. Knows blocks, not what
they mean.
"""

from dataclasses import replace

import sympy as sp

from .block import Block, Output, Step


def share(block: Block) -> Block:
    """The block with every subexpression that occurs twice computed once."""
    names = sp.numbered_symbols("c", real=True, start=1)
    taken = {step.name for step in block.steps} | {name for q in block.inputs for name in q.names}
    fresh = (symbol for symbol in names if symbol.name not in taken)
    shared, reduced = sp.cse(block.expressions(), symbols=fresh)
    steps = [
        replace(step, expr=expr) for step, expr in zip(block.steps, reduced[: len(block.steps)], strict=True)
    ]
    rest = iter(reduced[len(block.steps) :])
    outputs = tuple(Output(out.quantity, tuple(next(rest) for _ in out.exprs)) for out in block.outputs)
    return replace(block, steps=_placed(shared, steps, outputs), outputs=outputs)


def _placed(
    shared: list[tuple[sp.Symbol, sp.Expr]], steps: list[Step], outputs: tuple[Output, ...]
) -> tuple[Step, ...]:
    """The steps with each shared subexpression right before the first step that needs it."""
    waiting = dict(shared)
    program: list[Step] = []

    def bring(expr: sp.Expr) -> None:
        for symbol in sorted(expr.free_symbols & waiting.keys(), key=lambda found: int(found.name[1:])):
            if symbol in waiting:
                definition = waiting.pop(symbol)
                bring(definition)
                program.append(Step(symbol.name, definition))

    for step in steps:
        bring(step.expr)
        program.append(step)
    for out in outputs:
        for expr in out.exprs:
            bring(expr)
    return tuple(program)
