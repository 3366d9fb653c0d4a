"""Levels of fidelity: which reduced force kernels there are, and what each says of the machine.

A level drops physics of the legs that a scene may not need; each has a kernel of its own.
"""

from ..generated.fidelities import FIDELITIES as _TABLE
from ..generated.interface import MODELS
from ..io.arguments import shown
from ..robot.robot import Robot
from .kernel import OFFSET_KERNEL, kernel_name, module, offset_kernel

FIDELITIES: tuple[str, ...] = tuple(_TABLE)
"""Names, from everything to nothing but the platform: legs ``general`` (with friction), ``frictionless``,
``axisymmetric``, ``slender``, ``point_masses``, ``massless``, the last four also with ``_friction``; with
``_static`` neither velocities nor accelerations."""

_SAME = {"axisymmetric_static": "slender_static", "point_masses_static": "slender_static"}
_GENERAL = "general"


def available(robot: Robot, formulation: str = "exact") -> tuple[str, ...]:
    """Levels that there are for a robot: all for ``exact`` and universal base joints.

    With spherical base joints those without universal joints; ``paper`` has ``general`` alone. Raises
    ValueError for an unknown formulation.
    """
    kernel_name(formulation, robot.base_joint)
    if formulation != "exact" or robot.offsets is not None:
        return (_GENERAL,)
    return tuple(
        name
        for name, level in _TABLE.items()
        if name == _GENERAL or robot.base_joint == "universal" or not level["universal"]
    )


def resolved(robot: Robot, formulation: str, fidelity: str) -> str:
    """The level that a name stands for; at rest, axisymmetric legs and point masses are slender ones.

    Raises ValueError naming the levels that there are.
    """
    name = _SAME.get(fidelity, fidelity) if isinstance(fidelity, str) else fidelity
    names = available(robot, formulation)
    if not isinstance(name, str) or name not in names:
        joints = f" with {robot.base_joint} base joints" if formulation == "exact" else ""
        joints = joints if robot.offsets is None else " with offset joints"
        raise ValueError(
            f"fidelity: expected one of {', '.join(names)} for {formulation}{joints}, got {shown(fidelity)}"
        )
    return name


def force_kernel_name(robot: Robot, formulation: str, fidelity: str) -> str:
    """Name of the generated force kernel, as in ``stewart_<name>_forces.c``; raises as ``resolved``."""
    level = resolved(robot, formulation, fidelity)
    if robot.offsets is not None:
        return offset_kernel(robot, formulation)
    own = kernel_name(formulation, robot.base_joint)
    return own if level == _GENERAL else str(_TABLE[level]["kernel"])


def model_numbers(robot: Robot, formulation: str, fidelity: str) -> int:
    """How many numbers the kernel's prepared model holds."""
    return MODELS[force_kernel_name(robot, formulation, fidelity)]


def operations(robot: Robot, formulation: str = "exact", fidelity: str = _GENERAL) -> int:
    """Operations per pose: +, -, *, / and sqrt one each, solve included."""
    level = resolved(robot, formulation, fidelity)
    if robot.offsets is not None:
        return int(module(f"{OFFSET_KERNEL}_operations").OPERATIONS["friction"])
    if level == _GENERAL:
        counts = module(kernel_name(formulation, robot.base_joint)).FORCE_OPERATIONS["friction"]
        return sum(counts["total"])
    return int(_TABLE[level]["operations"]["total"])


def meaning(fidelity: str) -> str:
    """What a level says of the machine, in words."""
    return str(_TABLE[_SAME.get(fidelity, fidelity)]["meaning"])
