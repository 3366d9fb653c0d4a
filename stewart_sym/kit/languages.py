"""Kits in other languages than C: which functions they have, and their test vectors."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from ..checks import option, shown
from ..derive.formulation import FORMULATIONS
from ..derive.generate import output_program
from ..derive.kernel.nodes import Program
from ..derive.package import licence
from ..derive.package.languages import LANGUAGES, RESULTS, Contents, Test
from ..derive.package.robot import robot_toml
from ..derive.package.words import robot_symbol
from ..fidelity import resolved
from ..kernel import kernel_name
from ..robot import Robot
from .choice import STEMS, Choice, options
from .parts import generator, robot_numbers
from .vectors import Vector, vectors

GROUPS = {name: STEMS[name] for name in ("forces", "motion", "derivatives")}
"""Outputs of each group of functions."""


def check(choice: Choice) -> None:
    """Raise ValueError, of one line, for what there is in C alone."""
    option(choice.language, ("c", *LANGUAGES), "language")
    language = LANGUAGES[choice.language]
    for name in choice.functions:
        if name not in GROUPS:
            raise ValueError(
                f"functions: {choice.language}: expected some of {', '.join(GROUPS)}, got {shown(name)}"
            )
    closed = [name for name in choice.functions if name != "forces"]
    if closed and choice.level != "general":
        raise ValueError(
            f"fidelity: {choice.language}: expected general with the function {closed[0]}, got {choice.level}"
        )
    if choice.precision not in language.precisions:
        expected = " or ".join(language.precisions)
        raise ValueError(f"precision: {choice.language}: expected {expected}, got {choice.precision}")
    for name in ("bake", "scalar", "fmu"):
        if getattr(choice, name):
            raise ValueError(f"{name}: expected language c, got {choice.language}")


def texts(robot: Robot, choice: Choice) -> dict[str, str]:
    """The files of a kit but its manifest."""
    language = LANGUAGES[choice.language]
    outputs = tuple(output for group in choice.groups for output in GROUPS[group])
    found = vectors(
        robot, outputs, choice.formulation, fidelity=choice.level, precision=choice.precision, count=5
    )
    contents = Contents(
        robot.name,
        robot_symbol(robot.name),
        robot_numbers(robot),
        _program(robot, choice, outputs),
        outputs,
        tuple(_test(vector) for vector in found),
        choice.precision,
        options(choice),
        generator(),
    )
    made = language.files(contents)
    made["README.md"] = language.readme(contents)
    made["LICENSE"] = licence.TEXT
    made["robot.toml"] = robot_toml(robot.to_dict(), options(choice))
    return made


def _program(robot: Robot, choice: Choice, outputs: tuple[str, ...]) -> Program:
    level = resolved(robot, choice.formulation, choice.level)
    name = kernel_name(choice.formulation, robot.base_joint if level == "general" else "universal")
    return output_program(next(each for each in FORMULATIONS if each.kernel_name == name), outputs, level)


def _test(vector: Vector) -> Test:
    motion = {name: _plain(vector.inputs.get(name, np.zeros(3))) for name in _MOTION}
    F = vector.inputs.get("F")
    return Test(
        vector.function,
        motion,
        None if F is None else _plain(F),
        _members(vector.function, vector.answers),
        _members(vector.function, vector.bounds),
    )


_MOTION = ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext")


def _members(function: str, values: Mapping[str, NDArray[np.float64]]) -> dict[str, list[float]]:
    parts = dict(values)
    if "acceleration" in parts:
        parts["a"], parts["alpha"] = np.split(parts["acceleration"], 2)
    return {name: _plain(parts[name]) for name in RESULTS[function]}


def _plain(values: NDArray[np.float64]) -> list[float]:
    return [float(value) for value in values]
