"""Operation counter: a type of numbers that counts operations when a kernel tree runs on it.

Products with thresholds and arithmetic constants are not counted, because they are not part of the equations.
"""

import math
import operator
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from functools import total_ordering
from typing import Any

from ...program.block import Operations
from .constants import constants
from .interpret import Arithmetic, Interpreter, filled
from .nodes import Integer, Program, Type


def _counts(operation: str, of: Callable[..., float]) -> Callable[..., "Counting"]:
    """An operator that counts itself, unless it is done with a threshold."""

    def made(*numbers: "Counting") -> "Counting":
        first, *others = numbers
        first.done[operation] += not any(each.threshold for each in numbers)
        # A product with a threshold is one, too.
        threshold = operation == "mul" and any(each.threshold for each in others)
        return Counting(of(*(each.value for each in numbers)), first.done, threshold)

    return made


@total_ordering
@dataclass(frozen=True, eq=False)
class Counting:
    """A number that adds each operation with it to ``done``; a threshold counts none."""

    value: float
    done: Counter[str]
    threshold: bool = False

    __add__ = _counts("add", operator.add)
    __sub__ = _counts("add", operator.sub)
    __mul__ = _counts("mul", operator.mul)
    __truediv__ = _counts("div", operator.truediv)
    sqrt = _counts("sqrt", math.sqrt)

    def __neg__(self) -> "Counting":
        """The number with the other sign, which costs nothing."""
        return Counting(-self.value, self.done)

    def __abs__(self) -> "Counting":
        """Size, which costs nothing."""
        return Counting(abs(self.value), self.done)

    def __eq__(self, other: object) -> bool:
        """Return True if the values are equal."""
        return isinstance(other, Counting) and self.value == other.value

    def __lt__(self, other: "Counting") -> bool:
        """Return True if the value is less."""
        return self.value < other.value

    __hash__ = None  # type: ignore[assignment]


def counted(
    program: Program, function: str, numbers: Callable[[str], float], instead: dict[str, int] | None = None
) -> Operations:
    """Operations of a function.

    numbers: what an argument's or a structure's member's number is, by name; instead: values of whole
    constants such as MAX_STEPS.
    """
    done: Counter[str] = Counter()
    known = {name: Counting(value, done, True) for name, value in constants("double").items()}
    known |= {"MAX": Counting(known["MAX"].value, done), "NAN": Counting(math.nan, done)}
    on = Arithmetic(lambda value: Counting(float(value), done), known | (instead or {}), Counting.sqrt)

    def number(name: str, kind: Type) -> Any:
        return int(numbers(name)) if isinstance(kind, Integer) else Counting(numbers(name), done)

    arguments = program.function(function).arguments
    given = [filled(program, each.type, number, each.name) for each in arguments]
    Interpreter(program, on).run(function, *given)
    return Operations(**done)
