"""What goes into a kit in another language than C: a program, a robot's numbers, calls with their answers."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from ...kernel.tree.constants import INTEGERS, STATUS
from ...kernel.tree.nodes import Array, Constant, Program, Record, Type, parts_of
from ..words import Numbers

Value = Sequence[float] | Mapping[str, Sequence[float]]
"""What a function is given: numbers, or a structure's members."""


@dataclass(frozen=True)
class Test:
    """One call: function, what it is given, answers and their bounds in rounding units.

    given: by argument, without robot and model; answers, bounds: by member, of a structure in a result
    ``pose.R``; all flat. Where status is not 0 nothing is computed.
    """

    function: str
    given: Mapping[str, Value]
    answers: Mapping[str, Sequence[float]]
    bounds: Mapping[str, Sequence[float]]
    status: int = 0


@dataclass(frozen=True)
class Contents:
    """What goes into a kit.

    name, symbol: of the robot, the second fit for identifiers; numbers: quantity -> nested lists; outputs:
    public functions of the program; tests: at least one of each that has any, those with status 0 first;
    precision: "double" or "float"; options: of the command line.
    """

    name: str
    symbol: str
    numbers: Numbers
    program: Program
    outputs: tuple[str, ...]
    tests: tuple[Test, ...]
    precision: str
    options: str
    version: str

    @property
    def says(self) -> str:
        """The outputs in words."""
        return ", ".join(each.replace("_", " ") for each in self.outputs)

    @property
    def prepared(self) -> bool:
        """Whether there are constants to prepare."""
        return any(each.name == "prepare" for each in self.program.functions)

    @property
    def shown(self) -> dict[str, Test]:
        """The first test of each function that has one."""
        return {each.function: each for each in reversed(self.tests)}

    @property
    def given(self) -> dict[str, Value]:
        """An example of each argument of the functions, but robot and model."""
        found: dict[str, Value] = {}
        for test in self.shown.values():
            found = {**test.given, **found}
        return found

    def subject(self, function: str) -> str:
        """``robot`` or ``model``, the first argument of a function."""
        return self.program.function(function).arguments[0].name

    @cached_property
    def read(self) -> set[str]:
        """Names of the statuses and limits that the program reads."""
        return {each.name for each in parts_of(self.program.functions) if isinstance(each, Constant)}

    @property
    def whole_numbers(self) -> dict[str, tuple[int, str]]:
        """Value and meaning of each status and limit of the program, by name."""
        return {name: of for name, of in INTEGERS.items() if name in {*STATUS, *self.read}}

    @property
    def returned(self) -> dict[str, tuple[int, str]]:
        """Value and meaning of each status that a function may return, by name."""
        possible = {"OK", *self.read} - {"MAX_STEPS"}
        if not self.prepared:
            possible.discard("JOINT_SINGULAR")  # kinematics alone needs no joint axes
        return {name: of for name, of in INTEGERS.items() if name in possible}


def compared(program: Program, function: str) -> dict[str, tuple[int, ...]]:
    """Arrays of a function's result by member, those of structures in it as ``pose.R``, with dimensions."""
    result = program.function(function).result
    return {} if result is None else _arrays(program, result, "")


def _arrays(program: Program, kind: Type, path: str) -> dict[str, tuple[int, ...]]:
    if isinstance(kind, Array):
        return {path: kind.dims}
    members = program.structure(kind.name).members if isinstance(kind, Record) else ()
    found: dict[str, tuple[int, ...]] = {}
    for each in members:
        found |= _arrays(program, each.type, f"{path}.{each.name}" if path else each.name)
    return found
