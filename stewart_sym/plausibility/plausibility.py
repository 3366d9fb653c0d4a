"""Findings of all plausibility checks of a robot, except the suppressed ones.

The checks of forces, legs, and joints use the home pose. Each threshold is between the values of real
machines and the result of the mistake that it detects. Values that may be right cause no finding.
"""

import warnings
from collections.abc import Iterable

import numpy as np

from ..kinematics.mounting_side import AssemblyModeWarning
from ..robot.robot import Robot
from .finding import Finding
from .home_pose_checks import of_home
from .leg_order import of_order
from .level_poses import level_home
from .numbers import of_numbers


def find_implausible(robot: Robot) -> list[Finding]:
    """Return the findings about a robot except the suppressed ones; impossible inertias are not included.

    A finding that explains others replaces them: with a wrong unit, poses are not examined.
    """

    def left(found: Iterable[Finding]) -> list[Finding]:
        return [finding for finding in found if finding.name not in robot.suppressed_warnings]

    with np.errstate(all="ignore"), warnings.catch_warnings():
        # No finding depends on the side of the base on which the platform is.
        warnings.simplefilter("ignore", AssemblyModeWarning)
        found = left(of_numbers(robot))
        if not found:
            t = level_home(robot)
            found = left(of_order(robot, t)) or left(of_home(robot, t))
        return found
