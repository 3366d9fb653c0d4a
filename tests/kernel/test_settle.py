"""Selections that a condition around them decides are gone from functions of one pose, and no others."""

import itertools
import math
from typing import Any

import pytest

from stewart_sym.derive.kernel.tree import read
from stewart_sym.derive.kernel.tree.constants import constants
from stewart_sym.derive.kernel.tree.interpret import Arithmetic, Interpreter
from stewart_sym.derive.kernel.tree.nodes import Program, Select, parts_of
from stewart_sym.derive.kernel.tree.settle import of_one_pose

# What stands in these texts are names of the program that they are read into.
# ruff: noqa: F821

ON_NUMBERS = Arithmetic(
    float,
    {"NAN": math.nan, **constants("double")},
    math.sqrt,
    abs,
    lambda one, other: one if one > other else other,
    lambda test, yes, no: yes if test else no,
    bool,
)


def branched(x: "Real", going: "Integer") -> "Real":  # type: ignore[name-defined]
    """The first and the last are decided, those after an assignment are not."""
    total = 0.5
    if anywhere(going == 1):
        total = where(going == 1, x, total)
        going = where(x > 1.0, 0, going)
        total = where(going == 1, total + x, total)
    else:
        total = where(going == 1, 7.0, total)
    return total


def looped(x: "Real", going: "Integer") -> "Real":  # type: ignore[name-defined]
    """Of both conditions one stays as it was throughout the loop."""
    total = 0.5
    if anywhere((going == 1) & (x > 0.0)):
        for i in range(3):
            total = where(going == 1, total + x, total)
            going = where(total > 2.0, 0, going)
            total = where(x > 0.0, total + i, 0.0)
    return total


def either(x: "Real", going: "Integer") -> "Real":  # type: ignore[name-defined]
    """Where neither holds both are decided; where one of them does, none is."""
    total = 0.5
    if anywhere((going == 1) | (x > 0.0)):
        total = where(going == 1, total + x, where(x > 0.0, 3.0, 4.0))
    else:
        total = where(going == 1, 1.0, where(x > 0.0, 5.0, total))
    return total


def outside(x: "Real", going: "Integer") -> "Real":  # type: ignore[name-defined]
    """Behind a condition nothing is known."""
    total = 0.5
    if going == 1:
        total = x
    return where(going == 1, total, -total)


def of_member(x: "array(3)", going: "Integer") -> "Real":  # type: ignore[name-defined]
    """What has an address may change by another name."""
    total = 0.5
    if x[0] > 0.0:
        total = where(x[0] > 0.0, total, 1.0)
    return total


@pytest.mark.parametrize(
    ("text", "left"),
    [(branched, (4, 2)), (looped, (3, 2)), (either, (4, 2)), (outside, (1, 1)), (of_member, (1, 1))],
)
def test_selections_that_a_condition_decides_are_gone_and_values_stay(
    text: Any, left: tuple[int, int]
) -> None:
    whole = Program("test", (), (read.function(text, {}, {}),))
    short = of_one_pose(whole)
    assert (
        tuple(sum(isinstance(each, Select) for each in parts_of(tree.functions)) for tree in (whole, short))
        == left
    )
    numbers = itertools.product((-1.0, 0.0, 0.75, 3.0), (0, 1, 2))
    for x, going in numbers:
        given = [x] * 3 if text is of_member else x
        found = [Interpreter(tree, ON_NUMBERS).run(text.__name__, given, going) for tree in (whole, short)]
        assert found[0] == found[1]
