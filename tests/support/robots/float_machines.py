"""Machines within the range of float."""

import dataclasses

import numpy as np
from machines import random_motion, random_robot

from stewart_sym.motion.motion import Motion
from stewart_sym.robot import units
from stewart_sym.robot.robot import Robot

BOUND = 100.0


def any_machine(rng: np.random.Generator) -> tuple[Robot, Motion]:
    """From 1 mm to 10 m, platform and legs from 1e-6 to 1e6 kg, each by itself."""
    joint = "universal" if rng.random() < 0.7 else "spherical"
    robot = random_robot(rng, joint, friction=rng.random() < 0.7, scale=float(10 ** rng.uniform(-3, 1)))
    platform, legs = 10 ** rng.uniform(-6, 6, 2) / (robot.M, max(robot.m_d.max(), robot.m_u.max()))
    similar = units.rescaled(robot, 1.0, float(platform))
    parts = {name: getattr(robot, name) * legs for name in ("m_d", "m_u", "I_d0", "I_u0")}
    robot = dataclasses.replace(similar, **parts)
    return robot, random_motion(rng, robot)
