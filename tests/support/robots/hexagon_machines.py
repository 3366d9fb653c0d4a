"""Similar hexagons."""

import dataclasses

import numpy as np
from machines import dasgupta, rotation
from numpy.typing import NDArray
from unsolvable_poses import semiregular

import stewart_sym as ss

Array = NDArray[np.float64]


def hexagons(turn: float) -> tuple[ss.Robot, Array]:
    """Base and platform similar hexagons, long sides of one above short sides of the other; turned, rad."""
    base, plate = [-12, 12, 108, 132, 228, 252], [-48, 48, 72, 168, 192, 288]
    robot = dataclasses.replace(dasgupta(), b=semiregular(base, 1.0), p=semiregular(plate, 0.6))
    return robot, rotation(np.array([0.0, 0.0, turn]))
