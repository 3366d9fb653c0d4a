"""Leg lengths of poses, and poses moved a little."""

from typing import Any

import numpy as np
from machines import Array, dasgupta

import stewart_sym as ss
from stewart_sym.motion.rotation import rotation_from_rpy, rotation_from_vector

Poses = tuple[Array, Array]
STILL = np.zeros(3)
HOME = np.array([0.2, 0.0, 0.5])


def paper_poses(rng: np.random.Generator, count: int, angle: float, way: float) -> Poses:
    """Poses of the paper's machine around the middle of Path I: angles within +-angle, position +-way."""
    R = rotation_from_rpy(rng.uniform(-angle, angle, (count, 3)))
    return R, HOME + rng.uniform(-way, way, (count, 3))


def paper_case(rng: int | np.random.Generator, count: int) -> tuple[ss.Robot, Array, Array, Array]:
    """The paper's machine, poses near the middle of Path I, and their leg lengths."""
    robot, (R, t) = dasgupta(), paper_poses(np.random.default_rng(rng), count, angle=0.1, way=0.1)
    return robot, R, t, lengths(robot, R, t)


def paper_legs(name: str = "I") -> tuple[ss.Robot, ss.Motion, Any]:
    """The paper's machine along one of its paths, and its legs."""
    robot, (path, step) = dasgupta(), ss.PAPER_PATHS[name]
    motion = path.sample(path.time_grid(step))
    return robot, motion, ss.inverse_kinematics(robot, motion)


def lengths(robot: ss.Robot, R: Array, t: Array) -> Array:
    return ss.inverse_kinematics(robot, ss.Motion(R=R, t=t, omega=STILL, v=STILL)).L


def nudged(rng: np.random.Generator, R: Array, t: Array, angle: float, way: float) -> Poses:
    """Poses near others: turned by at most angle, rad, and moved by at most way, m."""
    phi, step = (x / np.linalg.norm(x, axis=-1, keepdims=True) for x in rng.normal(size=(2, *t.shape)))
    share = rng.uniform(size=(*t.shape[:-1], 1))
    return rotation_from_vector(angle * share * phi) @ R, t + way * share * step
