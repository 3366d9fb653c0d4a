"""Options of a kit: functions, formulation, fidelity, arithmetic, and language."""

from dataclasses import dataclass

import numpy as np

from ..backend.kernel import robot_kernel
from ..derive.kernel.outputs import FORCES, OUTPUTS
from ..derive.package.fmu import KINDS, PLANT
from ..derive.package.text_format import template
from ..io.arguments import option, shown
from ..io.output import toml_text
from ..robot.robot import Robot

TORQUE = "torque"
"""Name of the group of functions that requires a robot with a drive."""
FUNCTIONS = ("forces", "reactions", "motion", "derivatives", "kinematics", TORQUE)
"""Groups of functions that a kit may contain, in the order of its documentation."""

_DERIVATIVES = ("derivatives", "linearization")
STEMS: dict[str, tuple[str, ...]] = {
    "forces": ("forces",),
    "reactions": ("inverse_dynamics", "joint_reactions"),
    "motion": tuple(each for each in OUTPUTS if each not in (FORCES, *_DERIVATIVES)),
    "derivatives": _DERIVATIVES,
    "kinematics": ("inverse_kinematics", "forward_kinematics", "forward_velocity"),
    TORQUE: ("axial_forces", "motor_torques"),
}
"""C functions of each group; ``axial_forces`` exists only for legs with rotors."""

PRECISIONS: dict[str, type] = {"double": np.float64, "float": np.float32}
"""Floating-point types of a kit."""

_OF_FORCES = ("fidelity", "bake", "scalar")
_UNIVERSAL = ("motion", "derivatives")


@dataclass(frozen=True)
class Choice:
    """Options of a kit.

    Attributes
    ----------
    functions : tuple of str
        Groups of functions, some of ``FUNCTIONS``.
    formulation : str
        "exact" or "paper".
    fidelity : str or None
        Fidelity level of the forces, one of ``backend.kernel.levels``; None means ``general``.
    bake : bool
        True inserts the constants of the robot into the kernel of the forces.
    scalar : bool
        True processes one pose with its legs in sequence, with small code and stack, for processors without
        vector registers. Applies to the forces.
    precision : str
        "double" or "float".
    fmu : str or None
        Kind of an additional co-simulation unit, one of ``derive.package.fmu.KINDS``; None adds none.
    language : str
        "c", or one of ``derive.package.languages.LANGUAGES``.
    """

    functions: tuple[str, ...] = ("forces",)
    formulation: str = "exact"
    fidelity: str | None = None
    bake: bool = False
    scalar: bool = False
    precision: str = "double"
    fmu: str | None = None
    language: str = "c"

    @property
    def level(self) -> str:
        """Fidelity level of the forces."""
        return self.fidelity or "general"

    @property
    def groups(self) -> tuple[str, ...]:
        """Requested groups of functions in the order of ``FUNCTIONS``."""
        return tuple(name for name in FUNCTIONS if name in self.functions)


DEFAULT = Choice()
"""Default options: only the forces, formulation ``exact``, double precision."""


def check(choice: Choice, robot: Robot) -> None:
    """Raise ValueError for an option that is unknown or conflicts with another one."""
    option(choice.precision, tuple(PRECISIONS), "precision")
    robot_kernel(robot, choice.formulation)
    if not choice.functions:
        raise ValueError(f"functions: expected some of {', '.join(FUNCTIONS)}, got none")
    for name in choice.functions:
        if name not in FUNCTIONS:
            raise ValueError(f"functions: expected some of {', '.join(FUNCTIONS)}, got {shown(name)}")
        if name in _UNIVERSAL:
            _need_closed_form(choice, robot, f"functions: {name}")
    if TORQUE in choice.functions and robot.drive is None:
        raise ValueError("functions: torque: expected a robot with a drive, got one without ([legs.drive])")
    if choice.fmu is not None:
        option(choice.fmu, KINDS, "fmu")
    if choice.fmu == PLANT:
        _need_closed_form(choice, robot, "fmu: plant")
    for name in _OF_FORCES if choice.fmu == PLANT else (*_OF_FORCES, "fmu"):
        if getattr(choice, name) and "forces" not in choice.functions:
            raise ValueError(f"{name}: applies to the function forces, got {', '.join(choice.functions)}")


def _need_closed_form(choice: Choice, robot: Robot, item: str) -> None:
    """Raise ValueError for a formulation or base joints whose equations of motion have no closed form."""
    if choice.formulation != "exact" or robot.base_joint != "universal":
        what = f"{choice.formulation} with {robot.base_joint} base joints"
        raise ValueError(f"{item}: expected exact with universal base joints, got {what}")


def robot_toml(robot: Robot, choice: Choice) -> str:
    """Format the robot file of the kit: the same robot to the bit, with the kit options as a comment."""
    return template("kit/robot.toml", {"options": options(choice)}) + toml_text(robot.to_dict())


def options(choice: Choice) -> str:
    """Format the options as arguments of the command line."""
    given = [f"--functions {','.join(choice.groups)}"]
    given += [f"--formulation {choice.formulation}"] if choice.formulation != "exact" else []
    given += [f"--fidelity {choice.fidelity}"] if choice.fidelity else []
    given += [f"--{name}" for name in ("bake", "scalar") if getattr(choice, name)]
    given += ["--precision float"] if choice.precision == "float" else []
    given += [f"--fmu {choice.fmu}"] if choice.fmu else []
    return " ".join(given)
