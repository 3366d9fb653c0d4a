"""Physics of a robot file that a fidelity level omits, with its effect on the forces."""

from collections.abc import Iterator

import numpy as np

from ..backend import fidelity
from ..precision.truth import Truth
from ..robot.robot import Robot
from .kit_options import Choice
from .sample_poses import poses

_POSES = 8
"""Motions about the home pose by whose forces the effect is estimated."""
_ROUNDING = 1e-12
"""Share of the largest force that counts as rounding."""


def left_out(robot: Robot, choice: Choice) -> str:
    """Return a clause about the physics of the robot file that the forces of a kit omit, or an empty text."""
    if choice.level == "general" or "forces" not in choice.functions:
        return ""
    level = fidelity.resolved(robot, choice.formulation, choice.level)
    motion = poses(robot, choice.formulation, _POSES)
    full, reduced = (
        Truth(robot, choice.formulation, name).forces(motion).astype(float) for name in ("general", level)
    )
    error, largest = float(np.abs(reduced - full).max()), float(np.abs(full).max())
    if not error > _ROUNDING * largest:
        return ""
    named = ", ".join(_named(robot, level))
    return (
        f"fidelity {choice.level} ({fidelity.meaning(level, robot.has_rotors)}) omits physics of the "
        f"robot file{f', such as {named}' if named else ''}; forces differ by up to {error:.3g} N, "
        f"{100.0 * error / largest:.2g} % of the largest, in motions about the home pose"
    )


def _named(robot: Robot, level: str) -> Iterator[str]:
    """Yield the physics that a level omits for certain."""
    rotor = fidelity.rotor_of(robot, level)
    if robot.has_rotors and rotor == "none":
        yield f"rotors with up to {robot.reflected_mass.max():.3g} kg of reflected mass in each leg"
    elif rotor == "mass" and np.any(robot.rotor_momentum):
        yield "angular momentum of the rotors"
    damped = any(np.any(getattr(robot, name)) for name in ("C_u", "C_p", "C_s"))
    if damped and level not in ("no_rotor", "reflected") and not level.endswith("_friction"):
        yield "friction of the joints"
