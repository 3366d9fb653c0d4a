"""Robots and motions as kernels on arrays take them."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
from machines import random_motion

import stewart_sym as ss
from stewart_sym.derive.kernel.tree.constants import constants
from stewart_sym.derive.kernel.tree.interpret import Arithmetic
from stewart_sym.derive.mechanics import quantities as n

EPSILON = 2.0**-52
ON_ARRAYS = Arithmetic(
    np.asarray,
    {"NAN": np.nan, **constants("double")},
    np.sqrt,
    np.abs,
    lambda one, other: np.where(one > other, one, other),
    np.where,
    lambda test: bool(np.any(test)),
)


def fields(quantities: Any, owner: Any, leg: int | None = None) -> dict[str, Any]:
    """Members of a structure, components first and poses last."""
    found = {}
    for q in quantities:
        value = np.asarray(getattr(owner, q.name), dtype=float)
        value = value if leg is None else value[leg]
        parts = [value[(..., *key)] for key in q.keys]
        found[q.name] = parts if q.shape else parts[0]
    return found


def robot_numbers(robot: ss.Robot) -> SimpleNamespace:
    legs = [SimpleNamespace(**fields(n.OF_LEG, robot, i)) for i in range(6)]
    return SimpleNamespace(**fields(n.PLATFORM, robot), leg=legs)


def motion_numbers(motion: ss.Motion) -> SimpleNamespace:
    still = np.zeros(motion.t.shape)
    loads = {
        name: still if getattr(motion, name) is None else getattr(motion, name) for name in ("F_ext", "M_ext")
    }
    given = {q.name: loads.get(q.name, getattr(motion, q.name)) for q in n.MOTION}
    return SimpleNamespace(**fields(n.MOTION, SimpleNamespace(**given)))


def beside_the_joint_axis(rng: np.random.Generator, robot: ss.Robot, sine: float) -> ss.Motion:
    """A motion in which leg 3 is at this sine to the fixed axis of its universal joint."""
    motion = random_motion(rng, robot)
    k = robot.k[2] / np.linalg.norm(robot.k[2])
    across = np.cross(k, rng.normal(size=3))
    away = k + sine * across / np.linalg.norm(across)
    length = np.linalg.norm(motion.R @ robot.p[2] + motion.t - robot.b[2])
    return replace(motion, t=robot.b[2] - motion.R @ robot.p[2] + length * away / np.linalg.norm(away))
