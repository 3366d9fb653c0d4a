"""Legs that lean toward their universal joint's fixed axis."""

import dataclasses

import numpy as np
from numpy.typing import ArrayLike

import stewart_sym as ss
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot


def leaning(
    robot: Robot, motion: Motion, sine: float, leg: int = 0, about: ArrayLike = (0.3, -0.5, 0.8)
) -> Robot:
    """The machine with the fixed axis of a leg turned toward the leg."""
    s = ss.inverse_kinematics(robot, motion).s[leg]
    across = np.cross(s, about)
    k = robot.k.copy()
    k[leg] = np.sqrt(1 - sine**2) * s + sine * across / np.linalg.norm(across)
    return dataclasses.replace(robot, k=k)
