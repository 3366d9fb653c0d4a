"""Which side of the base the platform is on: against gravity, whatever axes the robot file uses.

The paper's paths are turned to that side.
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
from .conditioning import characteristic_length, scaled_condition_number
from .inverse_kinematics import leg_vectors, length_rows
from .offset_legs import without_offsets

DECISIVE = 0.1
"""Gravity decides on the side if more than this share of it is along the base's normal."""
# An axis of the base frame stands for the base points' normal if it is no farther from it than this, rad.
_LEVEL = np.radians(15.0)
# Shares by which the two sides differ clearly, and by more than rounding.
_CLEARLY, _EQUAL = 0.01, 1e-6
_AGAINST_GRAVITY, _AT_HOME = "against gravity", "where the robot file states the home pose"
# A direction whose x is smaller than this is far enough from the x axis.
_ACROSS = 0.9
# Share of the largest coordinate below which that of a mean is rounding.
_ROUNDING = 16 * np.finfo(float).eps


class AssemblyModeWarning(UserWarning):
    """Two assembly modes are equally plausible; one was taken."""


class Side(NamedTuple):
    """Where the platform is.

    direction: unit vector from the base to the platform, base frame, (3,). rule: what settled it, in words.
    settled: whether something did; False: the opposite side is as plausible.
    """

    direction: Array
    rule: str
    settled: bool

    @property
    def by_gravity(self) -> bool:
        """Whether gravity settled it."""
        return self.rule == _AGAINST_GRAVITY

    @property
    def certain(self) -> bool:
        """Whether gravity or a stated home pose settled it."""
        return self.rule in (_AGAINST_GRAVITY, _AT_HOME)


def up_direction(robot: Robot) -> Array:
    """Return the unit vector from the base to the side on which the platform is looked for, (3,), base frame.

    See ``platform_side``; warns with ``AssemblyModeWarning`` where the opposite side is as plausible.

    Parameters
    ----------
    robot : Robot
        The machine.

    Returns
    -------
    ndarray
        Unit vector, (3,).
    """
    side = platform_side(robot)
    if not side.settled:
        warn(f"robot: {side.rule}", AssemblyModeWarning)
    return side.direction


def platform_side(robot: Robot) -> Side:
    """Return the side of the base points' plane that the platform is on.

    The direction is the normal of that plane, or an axis of the base frame within 15 degrees of it. Its sign
    is that of the home pose, if the robot states one, else against gravity; where gravity is 0 or pulls along
    the plane, it is that of the side on which the level platform's legs are nearer to their length limits,
    else on which the condition number of H is smaller.
    """
    instance(robot, Robot, "robot")
    axis = _axis(robot.b)
    if robot.home_position is not None:
        along = float((robot.home_position + robot.p.mean(axis=0) - robot.b.mean(axis=0)) @ axis)
        if abs(along) > _EQUAL * (radius(robot.b) + radius(robot.p)):
            return Side(-axis if along < 0.0 else axis, _AT_HOME, True)
    g = robot.g / (np.abs(robot.g).max() or 1.0)
    pull = float(_normal(robot.b, axis) @ g)
    if abs(pull) > DECISIVE * np.linalg.norm(g):
        return Side(-axis if pull > 0.0 else axis, _AGAINST_GRAVITY, True)
    gravity = f"gravity is {'along the base' if np.any(robot.g) else '0'}"
    outside, condition = zip(*(_level_scores(robot, side) for side in (axis, -axis)), strict=True)
    for name, (one, other) in (("nearer to the length limits", outside), ("of smaller condition", condition)):
        if abs(one - other) > _CLEARLY * max(one, other):
            return Side(axis if one < other else -axis, f"{gravity}, the side {name} is taken", True)
    # Not clearly, but alike for a machine in whatever axes.
    if condition[0] - condition[1] > _EQUAL * condition[0]:
        axis = -axis
    rule = f"{gravity}, the side {_shown(axis)} of the base is taken; {_shown(-axis)} is as plausible"
    return Side(axis, rule, False)


def upright(robot: Robot) -> Array:
    """Return the rotation (3, 3) that takes z to ``platform_side``: half a turn about x where that is -z."""
    z = platform_side(robot).direction
    across = 0 if abs(z[0]) < _ACROSS else 1
    axis = np.eye(3)[across] - z[across] * z
    axis /= np.linalg.norm(axis)
    x = axis if across == 0 else np.cross(axis, z)
    return np.column_stack([x, np.cross(z, x), z]) + 0.0


def level_positions(robot: Robot, direction: Array, count: int = 400) -> Array:
    """Return positions, m, (count, 3), that center the level platform's points on a line above the base's."""
    center = robot.b.mean(axis=0) - robot.p.mean(axis=0)
    size = radius(robot.b) + radius(robot.p)
    # What the means of symmetric points leave for rounding is 0.
    largest = max(float(np.abs(robot.b).max()), float(np.abs(robot.p).max()))
    center[np.abs(center) < _ROUNDING * largest] = 0.0
    return np.asarray(center + np.linspace(0.05, 3.0, count)[:, None] * size * direction)


def radius(points: Array) -> float:
    """Root mean square distance of points (n, 3) from their mean, m."""
    return float(np.sqrt(np.mean(np.sum((points - points.mean(axis=0)) ** 2, axis=-1))))


def base_normal(robot: Robot) -> Array:
    """Return the unit normal of the base points' plane, (3,), to the platform's side, base frame."""
    return _normal(robot.b, up_direction(robot))


def _normal(b: Array, side: Array) -> Array:
    n = np.asarray(np.linalg.svd(b - b.mean(axis=0))[2][2])
    return -n if n @ side < 0.0 else n


def _shown(direction: Array) -> str:
    return f"({', '.join(f'{x + 0.0:.3g}' for x in np.round(direction, 6))})"


def _axis(b: Array) -> Array:
    """Return the normal, or the axis next to it, with its component of largest magnitude positive."""
    n = np.asarray(np.linalg.svd(b - b.mean(axis=0))[2][2])
    largest = int(np.argmax(np.abs(n)))
    if abs(n[largest]) >= np.cos(_LEVEL):
        return np.asarray(np.eye(3)[largest])
    return -n if n[largest] < 0.0 else n


def _level_scores(robot: Robot, direction: Array) -> tuple[float, float]:
    """Return by how far legs miss their limits, m, and the condition number, each least over all heights."""
    t = level_positions(robot, direction)
    q, S, L = leg_vectors(without_offsets(robot), np.broadcast_to(np.eye(3), (len(t), 3, 3)), t)
    low, high = robot.length_limits.T
    outside = np.max(np.maximum(np.maximum(low - L, L - high), 0.0), axis=-1)
    H = np.swapaxes(length_rows(q, S, L), -1, -2)
    condition = scaled_condition_number(H, characteristic_length(robot) or 1.0)
    return float(np.min(outside)), float(np.min(condition))


def path_for(robot: Robot, name: str) -> PaperPath:
    """Return Path ``name`` of ``PAPER_PATHS`` with its z to the platform's side of the base.

    That is the side of the home pose that the robot states, else the one against gravity; where neither
    settles it, z is the base frame's. Of a machine with z up it is the path itself.
    """
    path, dtau = PAPER_PATHS[name]
    if not platform_side(robot).certain:
        return PAPER_PATHS[name]
    x, y, z = (tuple(row) for row in upright(robot).tolist())
    return PaperPath(replace(path, axes=(x, y, z)), dtau)
