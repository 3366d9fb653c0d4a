"""Contents of a kit in a language other than C: program, robot, and calls with expected results."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from ...trace.constants import INTEGERS, STATUS
from ...trace.nodes import Array, Constant, Program, Record, Type, parts_of
from ..functions import Vector
from ..robot_source import Machine

Value = Sequence[float] | Mapping[str, Sequence[float]]
"""Argument of a function: numbers, or the members of a structure as flat arrays."""


@dataclass(frozen=True)
class Contents:
    """Contents of a kit.

    Attributes
    ----------
    machine : Machine
        Robot.
    program : Program
        Program.
    outputs : tuple of str
        Public functions of the program.
    tests : tuple of Vector
        Test vectors, with those of status 0 first. Each function that has vectors has at least one here.
    precision : str
        "double" or "float".
    options : str
        Command-line options.
    """

    machine: Machine
    program: Program
    outputs: tuple[str, ...]
    tests: tuple[Vector, ...]
    precision: str
    options: str

    @property
    def says(self) -> str:
        """Outputs as text."""
        return ", ".join(each.replace("_", " ") for each in self.outputs)

    @property
    def prepared(self) -> bool:
        """True if there are constants to prepare."""
        return any(each.name == "prepare" for each in self.program.functions)

    @property
    def shown(self) -> dict[str, Vector]:
        """First test of each function that has one."""
        return {each.function: each for each in reversed(self.tests)}

    @property
    def examples(self) -> dict[str, Value]:
        """Example of each argument of the functions, except robot and model."""
        found: dict[str, Value] = {}
        for test in self.shown.values():
            found = {**self.given(test), **found}
        return found

    def given(self, test: Vector) -> dict[str, Value]:
        """Return the inputs by argument after robot or model; missing numbers are zero."""
        found: dict[str, Value] = {}
        for each in self.program.function(test.function).arguments[1:]:
            if isinstance(each.type, Record):
                suffix = "_guess" if each.name == "guess" else ""
                members = (member.name for member in self.program.structure(each.type.name).members)
                found[each.name] = {
                    name: list(map(float, test.inputs.get(f"{name}{suffix}", (0.0,) * 3))) for name in members
                }
            else:
                found[each.name] = list(map(float, test.inputs[each.name]))
        return found

    def compared(self, test: Vector) -> dict[str, tuple[list[float], list[float]]]:
        """Return expected results and bounds by member of the result; empty without expected results."""
        answers, bounds = (
            {name: list(map(float, numbers)) for name, numbers in arrays.items()}
            for arrays in (test.answers, test.bounds)
        )
        for arrays in (answers, bounds):
            if whole := arrays.get("acceleration"):
                arrays |= {"a": whole[:3], "alpha": whole[3:]}
        names = {path: path.rpartition(".")[2] for path in compared(self.program, test.function)}
        return {path: (answers[name], bounds[name]) for path, name in names.items()} if answers else {}

    def subject(self, function: str) -> str:
        """Return the name of the first argument of a function, ``robot`` or ``model``."""
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
        possible = {"OK", *self.read} - {"MAX_STEPS", "MAX_SEARCHES"}
        if not self.prepared:
            possible.discard("JOINT_SINGULAR")  # kinematics does not read the joint axes
        return {name: of for name, of in INTEGERS.items() if name in possible}


def compared(program: Program, function: str) -> dict[str, tuple[int, ...]]:
    """Return the arrays of a function's result with their dimensions, by member such as ``pose.R``."""
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
