"""What a kit contains: functions, formulation, fidelity, arithmetic.

The bottom of the kit.
"""

from dataclasses import dataclass

import numpy as np

from ..backend.kernel import robot_kernel
from ..derive.kernel.outputs import FORCES, OUTPUTS
from ..derive.package.text_format import template
from ..io.arguments import option, shown
from ..io.toml_text import toml_text
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot

TORQUE = "torque"
"""The group of functions that needs a robot with a drive."""
FUNCTIONS = ("forces", "reactions", "motion", "derivatives", "kinematics", TORQUE)
"""Groups of functions that a kit may hold, in the order in which it lists them."""

_DERIVATIVES = ("derivatives", "linearization")
STEMS: dict[str, tuple[str, ...]] = {
    "forces": ("forces",),
    "reactions": ("inverse_dynamics", "joint_reactions"),
    "motion": tuple(each for each in OUTPUTS if each not in (FORCES, *_DERIVATIVES)),
    "derivatives": _DERIVATIVES,
    "kinematics": ("inverse_kinematics", "forward_kinematics", "forward_velocity"),
    TORQUE: ("axial_forces", "motor_torques"),
}
"""C functions of each group; of ``axial_forces`` there is only that of legs with rotors."""


PRECISIONS: dict[str, type] = {"double": np.float64, "float": np.float32}
"""Types of the numbers of a kit."""

_OF_FORCES = ("fidelity", "bake", "scalar")
_UNIVERSAL = ("motion", "derivatives")


@dataclass(frozen=True)
class Choice:
    """What goes into a kit.

    functions: some of ``FUNCTIONS``. formulation: "exact" or "paper". precision: "double" or "float". Of the
    forces alone: fidelity, a level of ``fidelity.FIDELITIES``, None for ``general``; bake: fold the robot's
    numbers in; scalar: one pose, its legs one after the other, small in code and stack, for processors
    without vector registers. fmu: a co-simulation unit of the forces as well. language: "c", or one of
    ``derive.package.languages.LANGUAGES``.
    """

    functions: tuple[str, ...] = ("forces",)
    formulation: str = "exact"
    fidelity: str | None = None
    bake: bool = False
    scalar: bool = False
    precision: str = "double"
    fmu: bool = False
    language: str = "c"

    @property
    def level(self) -> str:
        """Fidelity of the forces."""
        return self.fidelity or "general"

    @property
    def groups(self) -> tuple[str, ...]:
        """The functions requested, in the order of ``FUNCTIONS``."""
        return tuple(name for name in FUNCTIONS if name in self.functions)


DEFAULT = Choice()
"""The forces alone, exact and in double."""


def check(choice: Choice, robot: Robot) -> None:
    """Raise ValueError, of one line, for an option that is unknown or contradicts another one."""
    need_no_offsets(robot)
    option(choice.precision, tuple(PRECISIONS), "precision")
    option(choice.formulation, ("exact", "paper"), "formulation")
    robot_kernel(robot, choice.formulation)
    if not choice.functions:
        raise ValueError(f"functions: expected some of {', '.join(FUNCTIONS)}, got none")
    for name in choice.functions:
        if name not in FUNCTIONS:
            raise ValueError(f"functions: expected some of {', '.join(FUNCTIONS)}, got {shown(name)}")
        if name in _UNIVERSAL and (choice.formulation != "exact" or robot.base_joint != "universal"):
            what = f"{choice.formulation} with {robot.base_joint} base joints"
            raise ValueError(f"functions: {name}: expected exact with universal base joints, got {what}")
    if TORQUE in choice.functions and robot.drive is None:
        raise ValueError("functions: torque: expected a robot with a drive, got one without ([legs.drive])")
    for name in (*_OF_FORCES, "fmu"):
        if getattr(choice, name) and "forces" not in choice.functions:
            raise ValueError(f"{name}: applies to the function forces, got {', '.join(choice.functions)}")


def robot_toml(robot: Robot, choice: Choice) -> str:
    """The kit's copy of the robot file: the same robot to the bit, and how the kit was made of it."""
    return template("kit/robot.toml", {"options": options(choice)}) + toml_text(robot.to_dict(), inline=False)


def options(choice: Choice) -> str:
    """The options as the command line takes them."""
    given = [f"--functions {','.join(choice.groups)}"]
    given += [f"--formulation {choice.formulation}"] if choice.formulation != "exact" else []
    given += [f"--fidelity {choice.fidelity}"] if choice.fidelity else []
    given += [f"--{name}" for name in ("bake", "scalar") if getattr(choice, name)]
    given += ["--precision float"] if choice.precision == "float" else []
    given += ["--fmu"] if choice.fmu else []
    return " ".join(given)
