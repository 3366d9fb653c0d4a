"""Fidelity levels: the physics that each includes, its force kernel, and the levels available for a robot."""

from typing import Any

from ..generated.fidelities import DRIVE_FIDELITIES as _WITH_ROTORS
from ..generated.fidelities import FIDELITIES as _TABLE
from ..io.arguments import option
from ..robot.robot import Robot
from .kernel import OFFSET_KERNEL, force_kernel, kernel_name, module

FIDELITIES: tuple[str, ...] = tuple(_TABLE)
"""Names of the levels, from all physics to the platform alone.

``general`` includes all physics. ``frictionless``, ``axisymmetric``, ``slender``, ``point_masses``, and
``massless`` have no friction; the last four also exist with friction (``_friction``). Levels with ``_static``
omit velocities and accelerations.
"""

_DRIVE_TABLE = {
    **_WITH_ROTORS,
    "no_rotor": {**_TABLE["general"], "meaning": "everything but the rotors"},
    **{name: level for name, level in _TABLE.items() if name != "general"},
}
DRIVE_FIDELITIES: tuple[str, ...] = tuple(_DRIVE_TABLE)
"""Names of the levels of a robot whose legs have rotors.

``general`` includes all effects of the rotors, and ``reflected`` only their reflected masses, also with
``slender`` and ``massless`` legs. The other levels omit the rotors.
"""


def available(robot: Robot, formulation: str = "exact") -> tuple[str, ...]:
    """List the levels of a robot.

    All levels require ``exact`` and universal base joints. With spherical base joints, only levels whose legs
    do not depend on the fixed axis exist, and ``general``. Offset joints and ``paper`` have only ``general``,
    ``paper`` with rotors has none. Raises ValueError for an unknown formulation.
    """
    kernel_name(formulation, robot.base_joint)
    if robot.offsets is not None or formulation == "paper":
        return () if robot.has_rotors and robot.offsets is None else ("general",)
    table, any_joint = levels(robot), robot.base_joint == "universal"
    return tuple(name for name in table if any_joint or name == "general" or not table[name]["universal"])


def resolve_level(robot: Robot, formulation: str, fidelity: str) -> str:
    """Return a level; raise ValueError, which lists the available levels, for an unavailable one."""
    force_kernel(robot, formulation)
    return option(fidelity, available(robot, formulation), "fidelity")


def force_kernel_name(robot: Robot, formulation: str, fidelity: str) -> str:
    """Return the name in ``stewart_<name>_forces.c`` of a generated kernel; raises as ``resolve_level``."""
    level = resolve_level(robot, formulation, fidelity)
    return force_kernel(robot, formulation) if level == "general" else str(levels(robot)[level]["kernel"])


def operations(robot: Robot, formulation: str = "exact", fidelity: str = "general") -> int:
    """Count the operations per pose: +, -, *, /, and sqrt count one each, including the linear solve."""
    level = resolve_level(robot, formulation, fidelity)
    if robot.offsets is not None:
        return int(module(f"{OFFSET_KERNEL}_operations").OPERATIONS["forces"])
    if level == "general":
        return sum(module(force_kernel(robot, formulation)).FORCE_OPERATIONS["friction"]["total"])
    return int(levels(robot)[level]["operations"]["total"])


def rotor_of(robot: Robot, fidelity: str) -> str:
    """Return the effects of the rotors in a level: "all", "mass" (reflected mass), or "none"."""
    if not robot.has_rotors or fidelity not in _WITH_ROTORS:
        return "none"
    return "all" if fidelity == "general" else "mass"


def levels(robot: Robot) -> dict[str, dict[str, Any]]:
    """Return kernel, meaning, and operations of the levels of a robot with universal base joints."""
    return _DRIVE_TABLE if robot.has_rotors else _TABLE
