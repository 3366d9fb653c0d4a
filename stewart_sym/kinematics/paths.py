"""The paper's paths for a machine in whatever axes its file is written.

Needs the robot file and the paths, no dynamics.
"""

from dataclasses import replace

from ..motion.straight_line import PATHS, PaperPath
from ..robot.robot import Robot
from .mounting import platform_side, upright

__all__ = ["PATHS", "path_for"]


def path_for(robot: Robot, name: str) -> PaperPath:
    """Return Path ``name`` of ``PATHS`` with its z to the platform's side of the base.

    That is the side of the home pose that the robot states, else the one against gravity; where neither
    settles it, z is the base frame's. Of a machine with z up it is the path itself.
    """
    path, dtau = PATHS[name]
    if not platform_side(robot).certain:
        return PATHS[name]
    x, y, z = (tuple(row) for row in upright(robot).tolist())
    return PaperPath(replace(path, axes=(x, y, z)), dtau)
