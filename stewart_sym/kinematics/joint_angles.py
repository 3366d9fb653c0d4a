"""Angles by which the joints at both ends of a leg swing away from a neutral direction of the leg."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..io.arguments import instance
from ..io.array_types import Array
from ..motion.motion import Motion, at_rest
from ..robot.robot import Robot
from .inverse import inverse_kinematics, leg_vectors


@dataclass(frozen=True, eq=False)
class JointAngles:
    """Angles between legs and their neutral directions, rad, 0 to pi; ``(...)`` is the poses' shape.

    Attributes
    ----------
    base : ndarray
        Of the joints at the base, (..., 6): between the leg, with offsets its line of sliding, and its
        neutral direction in the base frame.
    platform : ndarray
        Of the joints at the platform, (..., 6): between the leg and its neutral direction in the platform
        frame.
    """

    base: Array
    platform: Array


def joint_angles(robot: Robot, motion: Motion) -> JointAngles:
    """Return how far the joints of each leg are from where the home pose has them.

    A joint is mounted so that its neutral direction is that of the leg at the home pose, at both ends.

    Parameters
    ----------
    robot : Robot
        The machine, with a home pose.
    motion : Motion
        Poses of the platform, any leading shape; rates don't count.

    Returns
    -------
    JointAngles
        Angles, rad.

    Raises
    ------
    ValueError
        For a robot that states no home pose.
    """
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    neutral = neutral_directions(robot)
    S = _along_legs(robot, motion)
    return JointAngles(angles_between(S, neutral), angles_between(S @ motion.R, neutral))


def neutral_directions(robot: Robot) -> Array:
    """Unit vectors of the legs at the home pose, (6, 3), in both frames; ValueError where none is stated."""
    if robot.home is None:
        raise ValueError("robot: home: joint angles are from the home pose, expected home")
    S = _along_legs(robot, at_rest(np.eye(3), robot.home))
    return np.asarray(S / np.linalg.norm(S, axis=-1, keepdims=True))


def _along_legs(robot: Robot, motion: Motion) -> Array:
    """Vectors along the legs, base frame, (..., 6, 3); with offsets along their lines of sliding."""
    if robot.offsets is not None:
        return inverse_kinematics(robot, motion).s
    return leg_vectors(robot, motion.R, motion.t)[1]


def angles_between(S: Array, directions: Array) -> Array:
    """Angles, rad, (...), between vectors (..., 3), exact near 0 and pi too."""
    return np.asarray(
        np.arctan2(np.linalg.norm(np.cross(S, directions), axis=-1), np.sum(S * directions, axis=-1))
    )
