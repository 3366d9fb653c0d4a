"""Legs that lean towards their universal joint's fixed axis."""

import dataclasses

import numpy as np

import stewart_sym as ss
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot


def leaning(robot: Robot, motion: Motion, sine: float) -> Robot:
    """The machine with the fixed axis of leg 1 turned towards the leg."""
    s = ss.inverse_kinematics(robot, motion).s[0]
    across = np.cross(s, [0.3, -0.5, 0.8])
    k = robot.k.copy()
    k[0] = np.sqrt(1 - sine**2) * s + sine * across / np.linalg.norm(across)
    return dataclasses.replace(robot, k=k)
