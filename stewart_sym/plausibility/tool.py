"""Doubts about the tool of trajectories: in another unit than that of the file."""

from collections.abc import Iterator

import numpy as np

from ..dynamics.home_pose import radius
from ..robot.robot import Robot
from .level_poses import Doubt

FAR = 10.0
"""Distance from the platform over the machine's size: millimetres read as metres make it 50 and more."""
NEAR = (1e-6, 1e-3)
"""The same from the frame's origin: metres in a file of millimetres; below it, zero but for rounding."""


def of_tool(robot: Robot) -> Iterator[Doubt]:
    """A tool far from the machine, or next to the origin of the platform frame but not there."""
    size = radius(robot.b) + radius(robot.p)
    away = float(np.linalg.norm(robot.tool))
    apart = min(away, float(np.linalg.norm(robot.tool - robot.p.mean(axis=0))))
    if apart > FAR * size:
        yield Doubt(
            "tool",
            f"tool: {apart:.3g} m from the platform, on a machine of {size:.3g} m; likely cause: given in "
            "millimetres, or in micrometres in a file of millimetres",
        )
    elif NEAR[0] * size < away < NEAR[1] * size:
        yield Doubt(
            "tool",
            f"tool: {away:.3g} m from the origin of the platform frame, on a machine of {size:.3g} m; likely "
            "cause: given in metres in a file of millimetres",
        )
