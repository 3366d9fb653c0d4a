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

from ..program.block import Operations
from .constants import constants
from .interpret import Arithmetic, Interpreter, filled
from .nodes import Integer, Program, Type


def _counts(operation: str, of: Callable[..., float]) -> Callable[..., "Counting"]:
    """Return an operator that counts itself, except for operations with a threshold."""

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
    """Number that adds each operation to ``done``; operations with a threshold are not counted."""

    value: float
    done: Counter[str]
    threshold: bool = False

    __add__ = _counts("add", operator.add)
    __sub__ = _counts("add", operator.sub)
    __mul__ = _counts("mul", operator.mul)
    __truediv__ = _counts("div", operator.truediv)
    sqrt = _counts("sqrt", math.sqrt)

    def __neg__(self) -> "Counting":
        """Return the negative number without counting an operation."""
        return Counting(-self.value, self.done)

    def __abs__(self) -> "Counting":
        """Return the magnitude without counting an operation."""
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
    """Count the operations of a function.

    ``numbers`` are the values of arguments or members by name, and ``instead`` the values of integer
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
