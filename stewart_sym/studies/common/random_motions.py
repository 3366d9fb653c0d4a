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
    """Standard deviations: of places over the radius of the base, of angles in rad, and of rates and
    accelerations in the time in which the machine falls its own radius.
    """

    shift: float
    turn: float
    rate: float


def random_motions(
    rng: np.random.Generator, robot: Robot, count: int, spread: Spread, gravity: float, load: float = 0.0
) -> Motion:
    """Motions, (count,), around the home pose.

    gravity: m/s^2, sets the machine's own time. load: kg, mass whose weight the external force is about, with
    the radius as its lever.
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
