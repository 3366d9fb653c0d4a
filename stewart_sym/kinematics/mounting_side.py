"""Side of the base on which the platform is: opposite to gravity, for any axes of the robot file.

The paths of the paper are rotated to this side.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..io.arguments import instance
from ..io.array_types import Array
from ..io.error_policy import warn
from ..motion.straight_line import PAPER_PATHS, PaperPath
from ..robot.robot import Robot
from ..robot.units import vector_text

DECISIVE = 0.1
"""Smallest fraction of gravity along the base normal for which gravity determines the side."""
# Largest angle (rad) to the normal of the base points at which an axis of the base frame replaces the normal.
_LEVEL = np.radians(15.0)
# Distance of the home pose from the base plane, relative to the machine size, above which it has a side.
_EQUAL = 1e-6
# Largest x component of a unit vector that is far enough from the x axis.
_ACROSS = 0.9
# Coordinate of a mean, relative to the largest coordinate, below which it is rounding error.
_ROUNDING = 16 * np.finfo(float).eps


class AssemblyModeWarning(UserWarning):
    """Issued if two assembly modes are equally plausible and one was selected."""


class Side(NamedTuple):
    """Side of the base on which the platform is.

    Attributes
    ----------
    direction : ndarray, shape (3,)
        Unit vector from the base to the platform in the base frame.
    rule : str
        Rule that determined the side, in words.
    certain : bool
        False if neither gravity nor a home pose determined the side, because the opposite is as plausible.
    """

    direction: Array
    rule: str
    certain: bool


def up_direction(robot: Robot) -> Array:
    """Compute the unit vector from the base to the side on which the platform is searched.

    Parameters
    ----------
    robot : Robot
        Robot geometry, gravity, home pose, and length limits.

    Returns
    -------
    ndarray, shape (3,)
        Unit vector in the base frame.

    Warns
    -----
    AssemblyModeWarning
        If the opposite side is equally plausible.

    See Also
    --------
    forward_kinematics : Compute poses from leg lengths; the search starts on this side.

    Notes
    -----
    The direction is the normal of the plane of the base points, or an axis of the base frame within 15
    degrees of it. Its sign follows from the home pose or from gravity. Otherwise its component of largest
    magnitude is positive.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> ss.up_direction(ss.robots.load("dasgupta1998")).tolist()
    [0.0, 0.0, 1.0]
    """
    side = platform_side(robot)
    if not side.certain:
        warn(f"robot: {side.rule}", AssemblyModeWarning)
    return side.direction


def platform_side(robot: Robot) -> Side:
    """Return the side of the base plane on which the platform is.

    The direction is the normal of the plane of the base points, or an axis of the base frame within 15
    degrees of it. A given home pose determines its sign, otherwise the direction opposite to gravity. If
    gravity is 0 or parallel to the plane, its component of largest magnitude is positive.
    """
    instance(robot, Robot, "robot")
    axis = _axis(robot.b)
    if robot.home_position is not None:
        along = float((robot.home_position + robot.p.mean(axis=0) - robot.b.mean(axis=0)) @ axis)
        if abs(along) > _EQUAL * (radius(robot.b) + radius(robot.p)):
            return Side(-axis if along < 0.0 else axis, "from home_position of the robot file", True)
    g = robot.g / (np.abs(robot.g).max() or 1.0)
    pull = float(_normal(robot.b, axis) @ g)
    if abs(pull) > DECISIVE * np.linalg.norm(g):
        return Side(-axis if pull > 0.0 else axis, "opposite to gravity", True)
    gravity = f"gravity is {'parallel to the base' if np.any(robot.g) else '0'}"
    side, other = vector_text(axis), vector_text(-axis)
    selected = f"selected the side {side} of the base, although {other} is as plausible"
    return Side(axis, f"{gravity}; {selected}; give home_position", False)


def upright(robot: Robot) -> Array:
    """Return the rotation (3, 3) that maps z to ``platform_side``; for -z, half a turn about x."""
    z = platform_side(robot).direction
    across = 0 if abs(z[0]) < _ACROSS else 1
    axis = np.eye(3)[across] - z[across] * z
    axis /= np.linalg.norm(axis)
    x = axis if across == 0 else np.cross(axis, z)
    return np.column_stack([x, np.cross(z, x), z]) + 0.0


def level_positions(robot: Robot, direction: Array, count: int = 400) -> Array:
    """Return positions (m), shape (count, 3), at which the level platform is centered above the base."""
    center = robot.b.mean(axis=0) - robot.p.mean(axis=0)
    size = radius(robot.b) + radius(robot.p)
    # The mean of symmetric points is zero except for rounding.
    largest = max(float(np.abs(robot.b).max()), float(np.abs(robot.p).max()))
    center[np.abs(center) < _ROUNDING * largest] = 0.0
    return np.asarray(center + np.linspace(0.05, 3.0, count)[:, None] * size * direction)


def radius(points: Array) -> float:
    """Return the root mean square distance of points (n, 3) from their mean (m)."""
    return float(np.sqrt(np.mean(np.sum((points - points.mean(axis=0)) ** 2, axis=-1))))


def base_normal(robot: Robot) -> Array:
    """Return the unit normal of the base plane toward the platform, shape (3,), in the base frame."""
    return _normal(robot.b, up_direction(robot))


def _normal(b: Array, side: Array) -> Array:
    n = np.asarray(np.linalg.svd(b - b.mean(axis=0))[2][2])
    return -n if n @ side < 0.0 else n


def _axis(b: Array) -> Array:
    """Return the base normal or the axis near it; its component of largest magnitude is positive."""
    n = np.asarray(np.linalg.svd(b - b.mean(axis=0))[2][2])
    largest = int(np.argmax(np.abs(n)))
    if abs(n[largest]) >= np.cos(_LEVEL):
        return np.asarray(np.eye(3)[largest])
    return -n if n[largest] < 0.0 else n


def path_for(robot: Robot, name: str) -> PaperPath:
    """Return path ``name`` of ``PAPER_PATHS``, rotated so that its z axis points to the platform side.

    The side follows from the given home pose or from gravity. If neither determines it, z is the z axis of
    the base frame. For a robot whose z axis points up, the path is unchanged.
    """
    path, dtau = PAPER_PATHS[name]
    if not platform_side(robot).certain:
        return PAPER_PATHS[name]
    x, y, z = (tuple(row) for row in upright(robot).tolist())
    return PaperPath(replace(path, axes=(x, y, z)), dtau)
