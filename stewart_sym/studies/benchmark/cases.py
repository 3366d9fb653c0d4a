"""Poses of ``benchmark``, and the timed code with the results that it must return."""

import functools
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ...backend import kernel
from ...calls.c_kernel import function
from ...calls.threads import CORES
from ...dynamics import equations
from ...dynamics.forces import ForceKernel
from ...dynamics.inverse_dynamics import DynamicsKernel, Formulation, inverse_dynamics, prepared_kernel
from ...exchange.model_from_robot import robot_of_bodies
from ...io.array_types import Array
from ...io.error_policy import warn
from ...io.progress import Progress
from ...motion.motion import Motion
from ...motion.rotation import rotation_from_rpy
from ...reference import newton_euler
from ...reference.equations_of_motion import regressor
from ...robot.robot import Robot
from ...robots import dasgupta1998
from ..common.text_tables import Figures
from ..common.timing import Task, Timed, batch, loop, over

NAME: Formulation = "exact"
"""Measured formulation."""

FORCES, EQUATIONS, CALLS, SIZES = "forces", "equations of motion", "calls", "batch sizes"
"""Groups of cases, each of which is a table."""

FEW, SLOW, MANY, LARGE = 64, 1_000, 10_000, 200_000
"""Number of poses of a loop in C (in the first cache), a NumPy batch, the reference, and a C batch."""

EQUATION_POSES = 16
"""Number of poses whose outputs, except the regressor, fit into the first cache."""

BATCHES, QUICK_BATCHES = (10**3, 10**4, 10**5, 10**6), (10**3, 10**4, 10**5)

AGREEMENT = 1e-10
"""Largest relative difference between double-precision results, relative to the largest value of a pose."""

_ALONE = "C, F alone"


@dataclass(frozen=True, eq=False)
class Case:
    """Code that computes a quantity at several poses.

    ``group``, ``name``, and ``what`` are table, row, and description. ``task`` is the timed code, whose unit
    is a pose; times of ``others`` are added with a factor. ``results`` returns the results of a run, (n, k),
    and ``expected`` are results of the reference at the first poses, (m, j), for the first of them, with the
    largest relative difference ``tolerance``. ``package`` is None for code of stewart-sym.
    """

    group: str
    name: str
    what: str
    task: Task
    results: Callable[[], Array]
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
        results, truth = self.results(), self.expected[: self.task.units]
        off = np.abs(results[: len(truth), : truth.shape[1]] - truth).max(axis=-1)
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
        return Motion(**dict(zip(kernel.MOTION, self.arrays, strict=True)))

    @functools.cached_property
    def rows(self) -> Array:
        """Rows of ``struct stewart_motion``, one per pose, shape (n, 30)."""
        return np.concatenate([array.reshape(len(self), -1) for array in self.arrays], axis=1)


def bench_poses(robot: Robot | None, count: int) -> Poses:
    """Generate regular poses with motion and load near the middle of the workspace, equal in every run."""
    rng = np.random.default_rng(1998)
    robot = dasgupta1998() if robot is None else robot
    if robot.base_joint != "universal":
        raise ValueError(f"{robot.name}: expected universal base joints, which the timed kernels require")
    if robot.has_rotors:
        warn(f"{robot.name}: timed without its rotors")
        robot = replace(robot, drive=None)
    center = robot.b.mean(axis=0)
    size = float(np.linalg.norm(robot.b - center, axis=-1).mean())
    up = -robot.g / np.linalg.norm(robot.g) if robot.g.any() else np.array([0.0, 0.0, 1.0])
    home = center + size * up - robot.p.mean(axis=0)
    rate, load = np.sqrt(9.81 / size), 0.5 * robot.M * 9.81
    rates = (0.2 * each for each in (rate, rate * size, rate**2, rate**2 * size))
    # With twice these rotations and shifts, some poses are so nearly singular that kernels check them twice.
    scales = (0.05, 0.025 * size, *rates, load, load * float(np.ptp(robot.p)))
    turns, shifts, *others = (scale * rng.normal(size=(count, 3)) for scale in scales)
    poses = Poses(robot, (rotation_from_rpy(turns), home + shifts, *others))
    if newton_euler.inverse_dynamics(robot, poses.motion).status.any():
        raise ValueError(f"{robot.name}: no regular poses about the middle of its workspace")
    return poses


def all_cases(poses: Poses, truth: Array, quick: bool, progress: Progress) -> list[Case]:
    """Build all cases; ``truth`` are the forces of the reference (N), (n, 6)."""
    progress("compiling the kernels")
    few, motions = poses.resized(FEW), poses.resized(EQUATION_POSES)
    cases = [*_forces(poses, truth), *_equations(motions), *_calls(few, truth)]
    for size in QUICK_BATCHES if quick else BATCHES:
        timed = batch(poses.resized(size).arrays, ForceKernel(poses.robot, NAME))
        cases.append(Case(SIZES, f"{size:,} poses", _ALONE, *timed, truth))
    return cases


def _forces(poses: Poses, truth: Array) -> Iterator[Case]:
    robot, few, slow, large = poses.robot, *(poses.resized(count) for count in (FEW, SLOW, LARGE))
    module = kernel.module(NAME)
    counts = module.FORCE_OPERATIONS, module.OPERATIONS
    alone, every = (int(sum(each["friction"]["total"])) for each in counts)
    forces, outputs = function(NAME, "forces", "_forces"), function(NAME, "inverse_dynamics")
    prepared = ForceKernel(robot, NAME)
    numpy, vectors = (prepared_kernel(robot, NAME, name) for name in ("numpy", "reference"))
    # The structure of all outputs has 78 numbers and begins with F.
    rows: tuple[tuple[str, str, Timed, int | None], ...] = (
        ("one pose", _ALONE, loop(few.rows, forces, prepared.model), alone),
        ("batch, one core", _ALONE, batch(large.arrays, prepared), alone),
        (f"batch, {CORES} cores", _ALONE, batch(large.arrays, prepared, CORES), alone),
        ("batch, float", _ALONE, batch(large.arrays, ForceKernel(robot, NAME, "float")), alone),
        ("batch, columns", _ALONE, _columns(large), alone),
        ("every output", "C, D K H c x F", loop(few.rows, outputs, kernel.robot_numbers(robot), 78), every),
        ("NumPy kernel", "vectorized", _whole(numpy, slow), every),
        ("vector reference", "NumPy, base frame", _whole(vectors, slow), None),
    )
    for name, what, timed, operations in rows:
        tolerance = 1e-3 if "float" in name else AGREEMENT
        yield Case(FORCES, name, what, *timed, truth, operations, tolerance)


def _columns(poses: Poses) -> Timed:
    """Time ``ForceKernel.forces`` for poses stored in columns."""
    prepared, count = ForceKernel(poses.robot, NAME), len(poses)
    R, *others = (_in_columns(array.reshape(count, -1).T) for array in poses.arrays)
    arrays = [np.moveaxis(R.reshape(3, 3, count), -1, 0), *(each.T for each in others)]
    F, status = _in_columns(np.zeros((6, count))), np.zeros(count, dtype=np.int32)
    run = over(lambda: prepared.forces(arrays, out=(F.T, status)))
    return Task(run, count), lambda: F.T


def _in_columns(array: Array) -> Array:
    """Copy an array so that rows begin at cache lines, at different offsets within pages."""
    width, count = array.shape
    stride = 8 * (-(-count // 8) | 1)
    room = np.zeros(width * stride + 7)
    first = -room.ctypes.data // 8 % 8
    rows = room[first : first + width * stride].reshape(width, stride)[:, :count]
    rows[...] = array
    return rows


def _whole(prepared: DynamicsKernel, poses: Poses) -> Timed:
    """Time the inverse dynamics of a motion."""
    run = over(lambda: prepared.run("inverse_dynamics", poses.motion))
    return Task(run, len(poses)), lambda: np.asarray(prepared.run("inverse_dynamics", poses.motion)["F"])


def _equations(poses: Poses) -> Iterator[Case]:
    """Yield cases of the equations of motion, for a robot of physically possible bodies."""
    robot, motion = robot_of_bodies(poses.robot), poses.motion
    F = np.ascontiguousarray(newton_euler.inverse_dynamics(robot, motion).F)
    acceleration = np.concatenate([motion.a, motion.alpha], axis=-1)
    terms = equations.equations_of_motion(robot, motion, backend="reference")
    slopes = equations.force_derivatives(robot, motion, backend="numpy")
    linear = equations.linearize(robot, motion, F, backend="numpy")
    inertia = equations.joint_space_inertia(robot, motion, backend="reference")
    model = ForceKernel(robot, NAME).model
    columns = _flat(regressor(robot, motion)[0])
    # The solve multiplies rounding errors by the condition number of M. Row: name, library, function, numbers
    # of a result, expected results, and input forces.
    rows: tuple[tuple[str, str, str, int, Array, Array | None], ...] = (
        ("inverse dynamics", "_forces", "forces", 6, F, None),
        ("bias", "_motion", "bias_and_friction", 6, terms.bias_and_friction, None),
        ("equations", "_motion", "equations", 168, _numbers(terms), None),
        ("forward dynamics", "_motion", "forward_dynamics", 6, acceleration, F),
        ("joint-space inertia", "_motion", "joint_inertia", 36, _flat(inertia), None),
        ("derivatives", "_motion", "derivatives", 114, _numbers(slopes), None),
        ("linearization", "_motion", "linearization", 222, _numbers(linear), F),
    )
    for name, part, suffix, width, expected, given in rows:
        what, tolerance = f"stewart_{NAME}_{suffix}", AGREEMENT if given is None else 1e-8
        timed = loop(poses.rows, function(NAME, suffix, part), model, width, given)
        yield Case(EQUATIONS, name, what, *timed, expected, tolerance=tolerance)
    what = f"stewart_{NAME}_regressor"
    compiled = function(NAME, "regressor", "_regressor")
    timed = loop(poses.rows, compiled, kernel.robot_numbers(robot), columns.shape[1], all_columns=True)
    yield Case(EQUATIONS, "regressor", what, *timed, columns)


def _numbers(result: Any) -> Array:
    """Return all quantities of a result except the status."""
    return _flat(*(values for name, values in vars(result).items() if name != "status"))


def _flat(*parts: Array) -> Array:
    """Return the numbers of arrays of shape (n, ...) as rows, shape (n, k)."""
    return np.concatenate([part.reshape(len(part), -1) for part in parts], axis=-1)


def _calls(poses: Poses, truth: Array) -> Iterator[Case]:
    """Yield calls of one pose from Python."""
    slot = ForceKernel(poses.robot, NAME).single_pose()
    slot.numbers[...] = poses.rows[0]
    yield Case(CALLS, "OnePose.solve()", "Python", Task(over(slot.solve), 1), lambda: slot.F[None], truth)
    given = [(poses.robot, poses.motion[i]) for i in range(len(poses))]
    task = Task(over(inverse_dynamics, given), len(poses))

    def results() -> Array:
        return np.array([inverse_dynamics(*each).F for each in given])

    yield Case(CALLS, "inverse_dynamics()", "Python", task, results, truth)
