"""Level poses at which robots are examined, and their condition numbers."""

import numpy as np

from ..dynamics.home_pose import home_pose
from ..io.array_types import Array
from ..kinematics.conditioning import scaled_condition_number
from ..kinematics.inverse_kinematics import leg_lengths, length_rows
from ..kinematics.mounting_side import level_positions, radius
from ..robot.robot import Robot

GOOD_CONDITION, MISPAIRED = 12.0, 6.0
"""Thresholds of the scaled condition number, and of its ratio to the best order of the legs.

Level poses of machines have condition numbers from 1.5 to 3, unusual ones up to 30. Legs in a wrong order
have at least 15 or a twisted platform, and at least 6 times the value of the right order.
"""
HEIGHTS = 50
"""Number of level poses on a line above the base."""


def level_home(robot: Robot) -> Array:
    """Return the position of the home pose of the robot, or of a better level pose if none is given.

    Poses along the base normal are tried too, because ``home_pose`` does not suit a machine on a wall, for
    example. Without length limits, the result is the best height at which the leg parts do not overlap.
    """
    if robot.home_position is not None:
        return robot.home_position
    t = home_pose(robot).t
    toward = t + robot.p.mean(axis=0) - robot.b.mean(axis=0)
    normal = np.linalg.svd(robot.b - robot.b.mean(axis=0))[2][2]
    directions = (toward / np.linalg.norm(toward), normal, -normal)
    others = np.concatenate([t[None], *(level_positions(robot, axis, HEIGHTS) for axis in directions)])
    found, lengths = level_conditions(robot.b, robot.p, others), leg_lengths(robot, np.eye(3), others)
    if np.all(np.isfinite(robot.length_limits)):
        away = np.abs(lengths - robot.length_limits.mean(axis=-1)).mean(axis=-1)
        away[0] = 0.0
        score = np.where(found > max(GOOD_CONDITION, found.min()), np.inf, away)
    else:
        passing = np.all(lengths >= np.nan_to_num(robot.r_d0[:, 0] - robot.r_u0[:, 0]), axis=-1)
        score = np.where(passing | ~passing.any(), found, np.inf)
    return np.asarray(others[int(np.argmin(score))])


def level_conditions(b: Array, p: Array, t: Array) -> Array:
    """Return scaled condition numbers of level poses at t (n, 3), shape (..., n); infinity if H is singular.

    p: (6, 3), or the same points in several orders, (..., 1, 6, 3). Moments are about the platform center.
    """
    S = p + t[..., None, :] - b
    arm = (p - p.mean(axis=-2, keepdims=True)) / (radius(p.reshape(-1, 3)) or 1.0)
    rows = length_rows(arm, S, np.linalg.norm(S, axis=-1))
    return scaled_condition_number(np.swapaxes(rows, -1, -2), 1.0)
