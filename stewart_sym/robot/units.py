"""Units of lengths and angles in texts and plots of reports: the units of the robot file."""

import math
from typing import NamedTuple

import numpy as np

from ..io.array_types import Array
from ..motion.trajectory_format import ANGLE_UNITS, LENGTH_UNITS
from .robot import Robot


class Units(NamedTuple):
    """Names of the units of length and angle, and their sizes in m and rad."""

    length: str
    meters: float
    angle: str
    radians: float

    @classmethod
    def of(cls, robot: Robot) -> "Units":
        """Return the units of the file of a robot."""
        angle = robot.angle_unit
        return cls(robot.length_unit, LENGTH_UNITS[robot.length_unit], angle, ANGLE_UNITS[angle])

    def of_unit(self, unit: str) -> tuple[float, str]:
        """Return the factor from an SI unit, such as m/s, to the unit of the file, and its name."""
        base, per, rest = unit.partition("/")
        sizes = {"m": (self.meters, self.length), "rad": (self.radians, self.angle)}
        size, name = sizes.get(base, (1.0, base))
        return 1.0 / size, f"{name}{per}{rest}"

    def lengths(self, values: Array) -> str:
        """Format a vector of lengths (m) with a resolution of a tenth of a millimeter or finer."""
        digits = 4 if self.meters == 1.0 else 5 + round(math.log10(self.meters))
        return vector_text(np.asarray(values) / self.meters, digits)


def vector_text(values: Array, digits: int = 4) -> str:
    """Format a vector, rounded to ``digits`` decimals."""
    return "(" + ", ".join(f"{round(value, digits) + 0.0:g}" for value in values.tolist()) + ")"
