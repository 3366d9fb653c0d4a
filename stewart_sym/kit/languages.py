"""Kits in languages other than C: available functions and test vectors."""

from ..backend.kernel import resolve_level
from ..derive.generated_files import output_program
from ..derive.mechanics import quantities as n
from ..derive.package import kit_license
from ..derive.package.languages import LANGUAGES
from ..derive.package.languages.contents import Contents
from ..derive.package.robot_source import Machine
from ..io.arguments import option, shown
from ..precision.exact_forces import form_and_level
from ..robot.robot import Robot
from .kit_options import STEMS, Choice, options, robot_toml
from .required_kernels import generator, robot_numbers
from .vectors import rejected, vectors

GROUPS = {name: STEMS[name] for name in ("forces", "motion", "derivatives", "kinematics")}
"""Outputs of each group of functions."""


def check(choice: Choice) -> None:
    """Raise ValueError for options that only C supports."""
    option(choice.language, ("c", *LANGUAGES), "language")
    language = LANGUAGES[choice.language]
    for name in choice.functions:
        if name not in GROUPS:
            raise ValueError(
                f"functions: {choice.language}: expected some of {', '.join(GROUPS)}, got {shown(name)}"
            )
    closed = [name for name in choice.functions if name in ("motion", "derivatives")]
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
    """Generate the files of a kit except its manifest."""
    language = LANGUAGES[choice.language]
    outputs = tuple(output for group in choice.groups for output in GROUPS[group])
    fidelity = resolve_level(robot, choice.formulation, choice.level)
    form, level = form_and_level(robot.base_joint, choice.formulation, fidelity, robot.has_rotors)
    program = output_program(form, outputs, level.name)
    found = vectors(
        robot, outputs, choice.formulation, fidelity=choice.level, precision=choice.precision, count=5
    )
    unsolvable = rejected(robot, choice.level, choice.precision) if "forces" in outputs else []
    rotors = any(each.name == n.m_r.name for each in program.structure("Leg").members)
    machine = Machine(robot.name, robot_numbers(robot, rotors), {}, None, generator())
    tests = (*found, *unsolvable)
    contents = Contents(machine, program, outputs, tests, choice.precision, options(choice))
    made = language.files(contents)
    made["README.md"] = language.readme(contents, made[language.example])
    made["LICENSE"] = kit_license.TEXT
    made["robot.toml"] = robot_toml(robot, choice)
    return made
