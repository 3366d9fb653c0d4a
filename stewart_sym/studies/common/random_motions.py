"""Random motions of a machine around its home pose, for studies of rounding."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...dynamics.home_pose import home_pose, radius
from ...motion.motion import Motion
from ...motion.rotation import rotation_from_rpy
from ...robot.robot import Robot

Array = NDArray[Any]


@dataclass(frozen=True)
class Spread:
    """Standard deviations of random motions.

    ``shift`` of positions is relative to the radius of the base, ``turn`` of angles in rad, and ``rate`` of
    rates and accelerations in units of the radius and of the time sqrt(radius / gravity).
    """

    shift: float
    turn: float
    rate: float


def random_motions(
    rng: np.random.Generator, robot: Robot, count: int, spread: Spread, gravity: float, load: float = 0.0
) -> Motion:
    """Generate random motions of shape (count,) near the home pose.

    ``gravity`` (m/s^2) defines the time scale of the machine. The external force is the weight of the mass
    ``load`` (kg), and its lever arm is the radius of the base.
    """
    size, home = radius(robot.b), home_pose(robot).t
    rate = np.sqrt(gravity / size)

    def vectors(scale: float) -> Array:
        return np.asarray(scale * rng.normal(size=(count, 3)))

    return Motion(
        R=rotation_from_rpy(vectors(spread.turn)),
        t=home + vectors(spread.shift * size),
        omega=vectors(spread.rate * rate),
        v=vectors(spread.rate * rate * size),
        alpha=vectors(spread.rate * rate**2),
        a=vectors(spread.rate * rate**2 * size),
        F_ext=vectors(load * gravity),
        M_ext=vectors(load * gravity * size),
    )
