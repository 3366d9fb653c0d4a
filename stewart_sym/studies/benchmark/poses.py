"""Poses for ``benchmark``: near the paths of the paper, or near the middle of the workspace of another
robot.
"""

import functools
from dataclasses import dataclass, replace

import numpy as np

from ...backend.kernel import MOTION
from ...io.array_types import Array
from ...io.error_policy import warn
from ...motion.motion import Motion
from ...motion.rotation import rotation_from_rpy
from ...motion.straight_line import PAPER_PATHS
from ...reference import newton_euler as reference
from ...robot.robot import Robot
from ...robots import dasgupta1998


@dataclass(frozen=True, eq=False)
class Poses:
    """Motions of one robot: contiguous ``arrays`` (n, ...) in the order of ``struct stewart_motions``."""

    robot: Robot
    arrays: tuple[Array, ...]

    def __len__(self) -> int:
        """Return the number of poses."""
        return len(self.arrays[0])

    def resized(self, count: int) -> "Poses":
        """Return the first ``count`` poses without a copy, or all poses repeated."""
        if count <= len(self):
            return Poses(self.robot, tuple(array[:count] for array in self.arrays))
        return Poses(self.robot, tuple(np.resize(array, (count, *array.shape[1:])) for array in self.arrays))

    @functools.cached_property
    def motion(self) -> Motion:
        """Poses as a Motion."""
        return Motion(**dict(zip(MOTION, self.arrays, strict=True)))

    @functools.cached_property
    def rows(self) -> Array:
        """Rows of ``struct stewart_motion``, one per pose, shape (n, 30)."""
        return np.concatenate([array.reshape(len(self), -1) for array in self.arrays], axis=1)


def bench_poses(robot: Robot | None, count: int) -> Poses:
    """Generate different regular poses with motion and load, which are identical in every run.

    ``robot`` None means the robot of the paper. Raises ValueError if its base joints are not universal or if
    it has no regular poses near its middle.
    """
    rng = np.random.default_rng(1998)
    if robot is None:
        robot = dasgupta1998()
        R, t, omega, v, alpha, a = _near_the_paths(rng, count)
    elif robot.base_joint != "universal":
        raise ValueError(f"{robot.name}: expected universal base joints, which the baselines require")
    else:
        if robot.has_rotors:
            warn(f"{robot.name}: timed without its rotors, which the baselines do not have")
            robot = replace(robot, drive=None)
        R, t, omega, v, alpha, a = _near_the_middle(rng, count, robot)
    weight = robot.M * 9.81
    F_ext = 0.5 * weight * rng.normal(size=(count, 3))
    M_ext = 0.5 * weight * float(np.ptp(robot.p)) * rng.normal(size=(count, 3))
    arrays = (R, t, omega, v, alpha, a, F_ext, M_ext)
    poses = Poses(robot, tuple(np.ascontiguousarray(array, dtype=np.float64) for array in arrays))
    if reference.inverse_dynamics(robot, poses.motion).status.any():
        raise ValueError(f"{robot.name}: no regular poses about the middle of its workspace")
    return poses


def _near_the_paths(rng: np.random.Generator, count: int) -> tuple[Array, ...]:
    """Sample Paths I and II alternately with small random displacements."""
    paths = [PAPER_PATHS[name].path for name in ("I", "II")]
    at = [path.sample(path.tau_f * rng.uniform(size=count)) for path in paths]
    turn = np.arange(count) % len(paths)

    def taken(name: str) -> Array:
        both = np.stack([getattr(motion, name) for motion in at])
        return np.asarray(both[turn, np.arange(count)])

    R = taken("R") @ rotation_from_rpy(0.01 * rng.normal(size=(count, 3)))
    t = taken("t") + 0.003 * rng.normal(size=(count, 3))
    rates = (taken(name) + 0.02 * rng.normal(size=(count, 3)) for name in ("omega", "v", "alpha", "a"))
    return R, t, *rates


def _near_the_middle(rng: np.random.Generator, count: int, robot: Robot) -> tuple[Array, ...]:
    """Sample poses near a pose at a height above the base equal to the mean radius of the base."""
    center = robot.b.mean(axis=0)
    size = float(np.linalg.norm(robot.b - center, axis=-1).mean())
    up = -robot.g / np.linalg.norm(robot.g) if robot.g.any() else np.array([0.0, 0.0, 1.0])
    home = center + size * up - robot.p.mean(axis=0)
    rate = np.sqrt(9.81 / size)

    def some(scale: float) -> Array:
        return scale * rng.normal(size=(count, 3))

    R, t = rotation_from_rpy(some(0.1)), home + some(0.05 * size)
    return R, t, some(0.2 * rate), some(0.2 * rate * size), some(0.2 * rate**2), some(0.2 * rate**2 * size)
