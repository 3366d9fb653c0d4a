"""Robots and motions as kernels on arrays take them."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
from machines import random_motion

import stewart_sym as ss
from stewart_sym.backend.numpy_kernel import loaded
from stewart_sym.derive.kernel.tree.constants import constants
from stewart_sym.derive.kernel.tree.interpret import Arithmetic
from stewart_sym.derive.mechanics import quantities as n
from stewart_sym.formulas.trees import robot_structure

ON_ARRAYS = Arithmetic(
    np.asarray,
    {"NAN": np.nan, **constants("double")},
    np.sqrt,
    np.abs,
    lambda one, other: np.where(one > other, one, other),
    np.where,
    lambda test: bool(np.any(test)),
)


def robot_numbers(robot: ss.Robot) -> SimpleNamespace:
    return robot_structure(robot, lambda _, value: value)


def motion_numbers(motion: ss.Motion) -> SimpleNamespace:
    """Components first and poses last."""
    numbers = vars(loaded(motion))
    return SimpleNamespace(**{q.name: [numbers[q.name][(..., *key)] for key in q.keys] for q in n.MOTION})


def beside_the_joint_axis(rng: np.random.Generator, robot: ss.Robot, sine: float) -> ss.Motion:
    """A motion in which leg 3 is at this sine to the fixed axis of its universal joint."""
    motion = random_motion(rng, robot)
    k = robot.k[2] / np.linalg.norm(robot.k[2])
    across = np.cross(k, rng.normal(size=3))
    away = k + sine * across / np.linalg.norm(across)
    length = np.linalg.norm(motion.R @ robot.p[2] + motion.t - robot.b[2])
    return replace(motion, t=robot.b[2] - motion.R @ robot.p[2] + length * away / np.linalg.norm(away))
