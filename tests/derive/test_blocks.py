"""Blocks: what they compute, what they cost, and that sharing changes the cost and not the value."""

import functools
import math
import random

import pytest
import sympy as sp
from formulations import OF_EACH_FORMULATION
from mpmath import mp

from stewart_sym.derive.kernel.tree.lower import expression
from stewart_sym.derive.kernel.tree.nodes import Program
from stewart_sym.derive.mechanics.formulation import FORMULATIONS
from stewart_sym.derive.mechanics.inverse_dynamics import kernel
from stewart_sym.derive.print.python import Python
from stewart_sym.derive.program import cse
from stewart_sym.derive.program.block import Block, Builder, Operations, Quantity, count

derived, share = functools.cache(kernel), functools.cache(cse.share)
A, B, X = sp.symbols("a b x", real=True)


def printed(expr: sp.Expr) -> str:
    """An expression in Python; ``on`` has the square root."""
    return Python(Program("", (), ())).text(expression(expr))


@pytest.mark.parametrize(
    ("expr", "expected"),
    [
        (A + B - X, Operations(add=2)),
        (-A, Operations()),
        (-A * B, Operations(mul=1)),
        (2 * A, Operations(mul=1)),
        (A**3, Operations(mul=2)),
        (1 / A, Operations(div=1)),
        (-B / A, Operations(div=1)),
        (A * B / X, Operations(mul=1, div=1)),
        (1 / (A * X), Operations(mul=1, div=1)),
        (sp.sqrt(A**2 + 1), Operations(mul=1, add=1, sqrt=1)),
        (A * (B + X), Operations(mul=1, add=1)),
    ],
)
def test_operations_are_counted_as_printed(expr: sp.Expr, expected: Operations) -> None:
    assert count([expr]) == expected
    text = printed(expr)
    assert text.count(" * ") == expected.mul
    assert text.count(" / ") == expected.div
    assert text.count(" + ") + text.count(" - ") == expected.add
    assert text.count("on.sqrt(") == expected.sqrt


@pytest.mark.parametrize(
    "expr", [sp.sin(A), A ** sp.Rational(1, 3), (A + B) ** 2, A * sp.Rational(1, 3), A**-2, 1 / sp.sqrt(A)]
)
def test_what_no_language_has_is_rejected(expr: sp.Expr) -> None:
    with pytest.raises(ValueError, match=r"cannot lower|base needs a name"):
        printed(expr)


@pytest.mark.parametrize(
    "expr", [A - (B - X) * A, -(A + B) * X, A / (B * X) - 2, -A - B, -(A - B) / X, sp.sqrt(A * A + B * B)]
)
def test_printed_text_has_the_value_of_the_expression(expr: sp.Expr) -> None:
    values = {"a": 1.25, "b": -0.75, "x": 2.5}
    exact = float(expr.subs({sp.Symbol(name, real=True): value for name, value in values.items()}))
    assert eval(printed(expr), {"on": math, **values}) == pytest.approx(exact, rel=1e-15)


def random_values(block: Block, seed: int) -> dict[str, mp.mpf]:
    rng = random.Random(seed)
    return {name: mp.mpf(rng.uniform(0.5, 1.5)) for quantity in block.inputs for name in quantity.names}


@OF_EACH_FORMULATION
def test_sharing_keeps_every_output_and_costs_less(form) -> None:
    with mp.workdps(50):
        for block in derived(form).blocks:
            shared = share(block)
            values = random_values(block, seed=1)
            before, after = block.run(values, mp.sqrt), shared.run(values, mp.sqrt)
            for name, numbers in before.items():
                for left, right in zip(numbers, after[name], strict=True):
                    assert abs(left - right) <= mp.mpf(10) ** -40 * (1 + abs(left))
            assert shared.operations().total < block.operations().total


@OF_EACH_FORMULATION
def test_sharing_keeps_the_named_steps_and_their_order(form) -> None:
    for block in derived(form).blocks:
        names = [step.name for step in block.steps]
        kept = [step.name for step in share(block).steps if step.name in set(names)]
        assert kept == names


@pytest.mark.slow
def test_frictionless_blocks_do_not_know_friction() -> None:
    for form in FORMULATIONS:
        for block in derived(form, False).blocks:
            names = {symbol.name for expr in block.expressions() for symbol in expr.free_symbols}
            assert not names & {"C_u", "C_p", "C_s"}


def test_a_block_drops_steps_and_inputs_that_no_output_needs() -> None:
    build = Builder()
    wanted = build.scalar("wanted", A * B)
    build.scalar("idle", A * X)
    inputs = [Quantity(name, (), "1", "a number") for name in "abx"]
    block = build.block("f", "test", inputs, [(Quantity("y", (), "1", "result"), wanted)])
    assert [step.name for step in block.steps] == ["wanted"]
    assert [quantity.name for quantity in block.inputs] == ["a", "b"]
