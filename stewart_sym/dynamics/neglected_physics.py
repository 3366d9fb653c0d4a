"""Physics of a robot file that a fidelity level or another program omits, and the effect on the forces."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..backend.kernel import levels, resolve_level, rotor_of
from ..motion.motion import Motion
from ..robot.robot import Robot
from .inverse_dynamics import Formulation, inverse_dynamics
from .sample_poses import poses

_POSES = 8
"""Number of motions near the home pose from which the effect is estimated."""
_ROUNDING = 1e-12
"""Fraction of the largest force that counts as rounding."""

Forces = Callable[[Motion], NDArray[np.generic]]
"""Function that returns actuator forces (N), (n, 6), of motions (n,)."""


def neglected_physics(robot: Robot, formulation: Formulation, level: str, reduced: Forces) -> str:
    """Return a clause about the physics of the robot that a level omits, or an empty text.

    ``reduced`` computes the forces of the level, from which the error is estimated.
    """
    if level == "general":
        return ""
    found = effect(robot, reduced, formulation)
    if not found:
        return ""
    own = resolve_level(robot, formulation, level)
    named, meaning = ", ".join(_named(robot, own)), levels(robot)[own]["meaning"]
    return (
        f"fidelity {level} ({meaning}) omits physics of the "
        f"robot file{f', such as {named}' if named else ''}; {found}"
    )


def effect(
    robot: Robot, reduced: Forces, formulation: Formulation = "exact", full: Forces | None = None
) -> str:
    """Return a clause about the difference between two forces near the home pose, or an empty text.

    ``full`` computes forces with all physics; by default, it is ``inverse_dynamics``. A robot without
    suitable poses gets a clause without numbers.
    """
    try:
        motion = poses(replace(robot, offsets=None), formulation, _POSES)
        all_physics = full(motion) if full else inverse_dynamics(robot, motion, formulation, "numpy").F
        # Forces in wider arithmetic become doubles.
        F = all_physics.astype(np.float64)
        error = float(np.abs(reduced(motion).astype(np.float64) - F).max())
    except ValueError:
        return "no pose suits an estimate of the effect"
    largest = float(np.abs(F).max())
    if not error > _ROUNDING * largest:
        return ""
    return (
        f"forces differ by up to {error:.3g} N, {100.0 * error / largest:.2g} % of the largest, "
        "in motions about the home pose"
    )


def _named(robot: Robot, level: str) -> Iterator[str]:
    """Yield the physics that a level certainly omits."""
    rotor = rotor_of(robot, level)
    if robot.has_rotors and rotor == "none":
        yield f"rotors with up to {robot.reflected_mass.max():.3g} kg of reflected mass in each leg"
    elif rotor == "mass" and np.any(robot.rotor_momentum):
        yield "angular momentum of the rotors"
    damped = any(np.any(getattr(robot, name)) for name in ("C_u", "C_p", "C_s"))
    if damped and level not in ("no_rotor", "reflected") and not level.endswith("_friction"):
        yield "friction of the joints"
