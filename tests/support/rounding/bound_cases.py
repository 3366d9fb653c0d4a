"""Machines and poses for tests of error bounds."""

import dataclasses

import numpy as np
from machines import random_motion, random_robot
from near_singular import near_singular_motion

from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

PRECISIONS = ("double", "float")
DTYPE = {"double": np.float64, "float": np.float32}


def case(rng: np.random.Generator, number: int) -> tuple[Robot, Motion]:
    """A robot of its own with a motion; every tenth near a singular pose."""
    robot = random_robot(rng)
    return robot, (near_singular_motion if number % 10 == 9 else random_motion)(rng, robot)


def wild(rng: np.random.Generator, robot: Robot, motion: Motion) -> tuple[Robot, Motion]:
    """Legs as near to their axes as 1e-5, rates and loads from nothing to ten thousand times as large."""
    S = robot.p @ motion.R.T + motion.t - robot.b
    s = S / np.linalg.norm(S, axis=-1, keepdims=True)
    k = s + 10 ** rng.uniform(-5, 0) * rng.normal(size=(6, 3))
    vectors = {
        name: getattr(motion, name) * rng.choice([0.0, 10 ** rng.uniform(-4, 4)])
        for name in ("omega", "v", "alpha", "a", "F_ext", "M_ext")
    }
    return (
        dataclasses.replace(robot, k=k / np.linalg.norm(k, axis=-1, keepdims=True)),
        Motion(motion.R, motion.t, **vectors),
    )
