"""Times of candidates with all their samples, and the names that they go by in ``bench``."""

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...dynamics.inverse import Formulation

NAME: Formulation = "exact"
"""The kernel that is measured."""

PLAIN, CLOSED = "CasADi", "CasADi, closed form"
"""Other times are divided by these, where CasADi is installed; the closed form is the stricter measure."""

ONE_POSE, BATCH, FLOAT = "one pose", "batch, one core", "batch, float"
COLUMNS = "batch, columns"
"""A batch of arrays with a column for each component."""
INVERSE, EQUATIONS, FORWARD = "inverse dynamics", "equations", "forward dynamics"
DERIVATIVES, REGRESSOR = "derivatives", "regressor"


def batched(name: str) -> str:
    """Name of a function of one pose, called for many."""
    return f"{name}, batch"


class Samples:
    """Medians and quartiles of ``raw``."""

    raw: tuple[float, ...]

    @property
    def median(self) -> float:
        """Median of the samples."""
        return float(np.median(self.raw))

    @property
    def quartiles(self) -> tuple[float, float]:
        """First and third quartile of the samples."""
        low, high = np.percentile(self.raw, (25, 75))
        return float(low), float(high)

    def as_json(self) -> dict[str, Any]:
        """Every field, the median and the quartiles, ready for ``json``."""
        assert dataclasses.is_dataclass(self)
        fields = {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}
        return {**fields, "median": self.median, "quartiles": self.quartiles}


@dataclass(frozen=True)
class Figure(Samples):
    """Nanoseconds a pose, one sample of each round in ``raw``; ``operations`` of a pose where counted.

    Of compiled C, ``target`` names the instructions, ``flags`` are the compiler's after those of every
    library, and ``bits`` is the width of the widest vectors that the code computes with, where that is known.
    """

    name: str
    what: str
    kind: str
    poses: int
    raw: tuple[float, ...]
    operations: int | None = None
    target: str = ""
    flags: tuple[str, ...] = ()
    bits: int | None = None

    @property
    def vectors(self) -> str:
        """Instructions and width in a few words; empty where no C is compiled."""
        if self.bits is None:
            return self.target
        return f"{self.target}, {self.bits} bit" if self.bits > 64 else f"{self.target}, scalar"

    def as_json(self) -> dict[str, Any]:
        """Every field, those of compiled C where it is C, ready for ``json``."""
        fields = super().as_json()
        build = {
            "instructions": fields.pop("target"),
            "flags": fields.pop("flags"),
            "bits": fields.pop("bits"),
        }
        return {**fields, **build, "vectors": self.vectors} if self.target else fields


@dataclass(frozen=True)
class Peak:
    """The most that one core does with a target's instructions.

    flags: of the compiler, after those of every library. multiply_add: ns for one fused multiply-add of one
    number; lanes: numbers in one instruction.
    """

    target: str
    flags: tuple[str, ...]
    multiply_add: Figure
    lanes: int

    def limits(self, operations: int) -> dict[str, float]:
        """Least ns for so many operations, by what fills a lane; a division or a root counts as any other."""
        each = operations * self.multiply_add.median
        return {"limit, an operation a lane": each, "limit, all fused in pairs": each / 2}


@dataclass(frozen=True)
class Speedup(Samples):
    """How many times as fast ``cores`` cores are as one over ``poses`` poses, round by round.

    poses: 0 for arithmetic that needs no memory, which shows what the machine had to give.
    """

    cores: int
    poses: int
    raw: tuple[float, ...]


@dataclass(frozen=True)
class CompileTime(Samples):
    """Seconds to compile one kernel's source into a library, one compilation each in ``raw``."""

    source: str
    raw: tuple[float, ...]


@dataclass(frozen=True)
class TextSize:
    """Bytes of machine code of each function that a program of one-pose calls is left with."""

    source: str
    flags: tuple[str, ...]
    functions: Mapping[str, int]

    @property
    def total(self) -> int:
        """Bytes of all of them."""
        return sum(self.functions.values())

    def as_json(self) -> dict[str, Any]:
        """Every field and the sum, ready for ``json``."""
        fields = {"source": self.source, "flags": self.flags, "functions": dict(self.functions)}
        return {**fields, "unit": "bytes", "total": self.total}
