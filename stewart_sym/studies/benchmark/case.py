"""Poses of ``benchmark``, and timed code with the results that it must return."""

import functools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

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
from ..common.text_tables import Figures
from ..common.timing import Task

FORCES, EQUATIONS, CALLS, SIZES, PASSES = "forces", "equations of motion", "calls", "batch sizes", "passes"
"""Groups of cases, each of which is a table."""

AGREEMENT = 1e-10
"""Largest relative difference between double-precision results, relative to the largest value of a pose."""


@dataclass(frozen=True, eq=False)
class Case:
    """Code that computes a quantity at several poses.

    ``group``, ``name``, and ``what`` are table, row, and description. ``task`` is the timed code, whose unit
    is a pose; times of ``others`` are added with a factor. ``found`` returns the results of
    a run, (n, k), and ``expected`` are results of the reference at the first poses, (m, j), for the first of
    them, with the largest relative difference ``tolerance``. ``package`` is None for code of stewart-sym.
    """

    group: str
    name: str
    what: str
    task: Task
    found: Callable[[], Array]
    expected: Array
    operations: int | None = None
    tolerance: float = AGREEMENT
    package: str | None = None
    others: Mapping[Task, float] = field(default_factory=dict)

    @property
    def tasks(self) -> dict[Task, float]:
        """Timed tasks with their factors."""
        return {self.task: 1.0, **self.others}

    def difference(self) -> float:
        """Return the largest difference relative to the largest value of a pose; ValueError if too large."""
        self.task.run(1)
        found, truth = self.found(), self.expected[: self.task.units]
        off = np.abs(found[: len(truth), : truth.shape[1]] - truth).max(axis=-1)
        worst = float(np.max(off / np.abs(truth).max(axis=-1)))
        if not worst <= self.tolerance:
            text = f"results differ from the reference by {worst:.1e}, expected {self.tolerance:g}"
            raise ValueError(f"{self.name}: {text}")
        return worst

    def figure(self, raw: Mapping[Task, tuple[float, ...]], difference: float) -> Figures:
        """Return the record: time per pose (ns) in each round, median, and quartiles."""
        times = np.sum([factor * np.array(raw[task]) for task, factor in self.tasks.items()], axis=0)
        low, median, high = np.percentile(times, (25, 50, 75)).tolist()
        named = {name: getattr(self, name) for name in ("group", "name", "what", "package", "operations")}
        measured = {"median": median, "quartiles": [low, high], "raw": times.tolist()}
        return {**named, "poses": self.task.units, **measured, "largest_difference": difference}


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
    """Generate different regular poses with motion and load, which are identical in every run."""
    rng, given = np.random.default_rng(1998), robot
    robot = dasgupta1998() if given is None else given
    if robot.base_joint != "universal":
        raise ValueError(f"{robot.name}: expected universal base joints, which the baselines require")
    if robot.has_rotors:
        warn(f"{robot.name}: timed without its rotors, which the baselines do not have")
        robot = replace(robot, drive=None)
    moving = _near_the_paths(rng, count) if given is None else _near_the_middle(rng, count, robot)
    load = 0.5 * robot.M * 9.81
    loads = (scale * rng.normal(size=(count, 3)) for scale in (load, load * float(np.ptp(robot.p))))
    arrays = tuple(np.ascontiguousarray(array, dtype=np.float64) for array in (*moving, *loads))
    poses = Poses(robot, arrays)
    if reference.inverse_dynamics(robot, poses.motion).status.any():
        raise ValueError(f"{robot.name}: no regular poses about the middle of its workspace")
    return poses


def _near_the_paths(rng: np.random.Generator, count: int) -> tuple[Array, ...]:
    """Sample Paths I and II alternately with small random displacements."""
    paths = [PAPER_PATHS[name].path for name in ("I", "II")]
    at = [path.sample(path.tau_f * rng.uniform(size=count)) for path in paths]
    scales = {"R": 0.01, "t": 0.003, **dict.fromkeys(("omega", "v", "alpha", "a"), 0.02)}
    found = []
    for name, scale in scales.items():
        values = np.array(getattr(at[0], name))
        values[1::2] = getattr(at[1], name)[1::2]
        by = scale * rng.normal(size=(count, 3))
        found.append(values @ rotation_from_rpy(by) if name == "R" else values + by)
    return tuple(found)


def _near_the_middle(rng: np.random.Generator, count: int, robot: Robot) -> tuple[Array, ...]:
    """Sample poses near a pose at a height above the base equal to the mean radius of the base."""
    center = robot.b.mean(axis=0)
    size = float(np.linalg.norm(robot.b - center, axis=-1).mean())
    up = -robot.g / np.linalg.norm(robot.g) if robot.g.any() else np.array([0.0, 0.0, 1.0])
    home = center + size * up - robot.p.mean(axis=0)
    rate = np.sqrt(9.81 / size)
    scales = (0.1, 0.05 * size, *(0.2 * each for each in (rate, rate * size, rate**2, rate**2 * size)))
    turns, shifts, *rates = (scale * rng.normal(size=(count, 3)) for scale in scales)
    return rotation_from_rpy(turns), home + shifts, *rates
