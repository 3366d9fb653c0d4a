"""Cost and errors of each kernel for the motions of a machine, at every fidelity level and precision.

The modeling error is relative to `exact` general in double precision. The rounding error is relative to the
equations of the kernel in 50-digit arithmetic. All errors are fractions of the largest actuator force of
their motion.
"""

import contextlib
import functools
import itertools
import statistics
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...backend.kernel import FORMULATIONS, MOTION, levels, operations_per_pose
from ...calls.c_kernel import function
from ...calls.numpy_kernel import loaded
from ...calls.threads import CORES
from ...dynamics.forces import ForceKernel, Precision
from ...dynamics.inverse_dynamics import Backend, DynamicsKernel, prepared_kernel
from ...io.array_types import Array
from ...io.progress import Progress, silent, tracked
from ...kinematics.conditioning import characteristic_length, scaled_condition_number
from ...kinematics.inverse_kinematics import wrench_matrix
from ...motion.motion import Motion
from ...precision.exact_forces import Truth, deviation
from ...robot.robot import Robot
from ..common.text_tables import Figures
from ..common.timing import Task, batch, loop, measured, over

PRECISIONS: tuple[Precision, ...] = ("float", "double")
"""Precisions, the cheaper first."""

ROUNDS, QUICK_ROUNDS = 21, 9
FEW, SLOW, MANY = 64, 1_024, 4_096
"""Number of poses of a C loop of one-pose calls, of a NumPy batch, and of a C batch."""

BACKENDS: Mapping[str, Backend] = {
    "every output": "c",
    "NumPy kernel": "numpy",
    "vector reference": "reference",
}
"""Other implementations of `exact` general, by name."""

SAMPLED = 12
"""Number of poses of a motion for rounding, and more with the largest force and condition number."""

_ROUNDING = 100 * float(np.finfo(np.float64).eps)
"""Largest difference of two double-precision kernels of a model over force times condition number."""


class Candidate(NamedTuple):
    """Kernel that a scene may use."""

    formulation: str
    fidelity: str
    precision: str

    @property
    def name(self) -> str:
        """Formulation, fidelity level, and precision as text."""
        return f"{self.formulation} {self.fidelity}, {self.precision}"


def candidate_of(entry: Figures) -> Candidate:
    """Return the kernel of a record."""
    return Candidate(*(entry[name] for name in Candidate._fields))


def worst(entry: Figures, *parts: str) -> float:
    """Return the largest error over all motions; ``parts`` selects the parts to add, by default all."""
    named = parts or ("model", "rounding")
    return float(max(sum(errors[part] for part in named) for errors in entry["errors"].values()))


def cost(
    robot: Robot,
    motions: Mapping[str, Motion],
    implementations: bool = False,
    rounds: int = QUICK_ROUNDS,
    progress: Progress = silent,
) -> Figures:
    """Measure every candidate for motions of shape (n,) with a solution at every pose, the cheapest first.

    A modeling error within the differences of two double-precision kernels of the same equations counts as 0.
    Errors are infinite if poses are unsolvable. A precision that cannot represent the constants of the robot
    is omitted. ``implementations`` also measures other implementations of `exact` general.
    """
    kernels = _compiled(robot, progress)
    paths = tracked(progress, motions.items(), lambda each: f"computing the forces of {each[0]}")
    cases = {name: _Case(robot, motion, name) for name, motion in paths}
    progress("compiling the truth of 50 digits")
    backends = BACKENDS if implementations else {}
    ways = {name: prepared_kernel(robot, "exact", backend) for name, backend in backends.items()}
    errors: dict[Candidate, Figures] = {candidate: {} for candidate in kernels}
    # Candidates with the same equations, which share the reference solution, are adjacent.
    by_model = [[*each] for _, each in itertools.groupby(kernels, lambda candidate: candidate[:2])]
    models = [(name, candidates) for name in cases for candidates in by_model]
    for name, candidates in tracked(progress, models, lambda model: f"computing {model[0]} at 50 digits"):
        for candidate, found in cases[name].errors({each: kernels[each] for each in candidates}).items():
            errors[candidate][name] = found
    tasks = _tasks(tuple(motions.values()), kernels, ways)
    times = measured(list(tasks.values()), rounds, progress)
    entries = [
        {
            **candidate._asdict(),
            "operations": operations_per_pose(robot, candidate.formulation, candidate.fidelity),
            "one_pose_ns": statistics.median(times[tasks[candidate, "one pose"]]),
            "batch_ns": statistics.median(times[tasks[candidate, "batch"]]),
            "errors": errors[candidate],
        }
        for candidate in kernels
    ]
    return {
        "robot": robot.name,
        "motions": {name: {"poses": len(case.F), "peak_force_N": case.peak} for name, case in cases.items()},
        # Sorting keeps the order of equally cheap candidates, with the more complete model first.
        "candidates": sorted(
            entries, key=lambda entry: (entry["operations"], PRECISIONS.index(entry["precision"]))
        ),
        "implementations": [
            {
                "name": way,
                "ns": statistics.median(times[tasks[way, ""]]),
                "rounding": {name: case.rounding_of(kernel) for name, case in cases.items()},
            }
            for way, kernel in ways.items()
        ],
        "units": {
            **dict.fromkeys(("errors", "rounding"), "share of the motion's peak force"),
            **dict.fromkeys(("operations", "ns"), "per pose"),
        },
    }


def _compiled(robot: Robot, progress: Progress) -> dict[Candidate, ForceKernel]:
    """Compile every available fidelity level of every formulation in both precisions, in parallel."""
    choices = [(each, level) for each in FORMULATIONS for level in levels(robot, each)]
    every = [Candidate(*choice, precision) for choice in choices for precision in PRECISIONS]
    kernels = {}
    with ThreadPoolExecutor(CORES) as pool:
        given: Any = [(each, (each.formulation, each.precision, each.fidelity)) for each in every]
        futures = [(each, pool.submit(ForceKernel, robot, *kind, warns=False)) for each, kind in given]
        for each, future in tracked(progress, futures, lambda pair: f"compiling {pair[0].name}"):
            # A precision that cannot represent the constants of the robot is omitted.
            unsuitable = [ValueError] if each.precision == "float" else []
            with contextlib.suppress(*unsuitable):
                kernels[each] = future.result()
    return kernels


class _Case:
    """Motion with its `exact` forces (N), their peak and accuracy (N), and poses for the rounding error."""

    def __init__(self, robot: Robot, motion: Motion, name: str) -> None:
        self.robot, self.motion, self.F = robot, motion, ForceKernel(robot).forces(motion)
        self.peak = float(np.abs(self.F).max())
        if self.peak == 0.0:
            raise ValueError(f"{name}: all forces are zero; relative errors are undefined")
        condition = scaled_condition_number(wrench_matrix(robot, motion), characteristic_length(robot))
        largest, count = np.abs(self.F).max(axis=-1), len(self.F)
        spread = np.linspace(0, count - 1, min(SAMPLED, count)).round().astype(int).tolist()
        self.sample = sorted({*spread, int(largest.argmax()), int(condition.argmax())})
        self.accuracy = (_ROUNDING * condition * largest)[:, None]

    def errors(self, kernels: Mapping[Candidate, ForceKernel]) -> dict[Candidate, Figures]:
        """Compute the errors of kernels with the same equations, one of them in double precision."""
        F = {each: kernel.forces(self.motion, on_singular="nan") for each, kernel in kernels.items()}
        in_double = next(forces for each, forces in F.items() if each.precision == "double")
        off = _or_infinite(in_double - self.F)
        off[off <= self.accuracy] = 0.0
        # The pose with the largest difference of the precisions probably has the largest rounding error.
        worst = {int(np.argmax(_or_infinite(forces - in_double).max(axis=-1))) for forces in F.values()}
        sample = sorted({*self.sample, *worst})
        candidate = next(iter(kernels))
        truth = Truth(self.robot, candidate.formulation, candidate.fidelity).forces(self.motion[sample])
        return {
            each: {
                "model": float(off.max()) / self.peak,
                "model_rms": float(np.sqrt(np.mean(off**2))) / self.peak,
                "rounding": float(_or_infinite(deviation(forces[sample], truth)).max()) / self.peak,
            }
            for each, forces in F.items()
        }

    def rounding_of(self, kernel: DynamicsKernel) -> float:
        """Compute the rounding error of another implementation of `exact` general."""
        motion = self.motion[self.sample]
        off = deviation(kernel.run("inverse_dynamics", motion)["F"], Truth(self.robot).forces(motion))
        return float(_or_infinite(off).max()) / self.peak


def _or_infinite(difference: NDArray[Any]) -> Array:
    """Return absolute differences, infinite for unsolvable poses."""
    return np.abs(np.nan_to_num(np.asarray(difference, dtype=np.float64), nan=np.inf))


def _tasks(
    motions: Sequence[Motion],
    kernels: Mapping[Candidate, ForceKernel],
    ways: Mapping[str, DynamicsKernel],
) -> dict[tuple[Candidate | str, str], Task]:
    """Return the timed tasks: "one pose" and "batch" of each kernel, and "" of other implementations."""
    few, slow, many = (_poses(motions, count) for count in (FEW, SLOW, MANY))
    tasks: dict[tuple[Candidate | str, str], Task] = {}
    rows = np.concatenate([array.reshape(FEW, -1) for array in few], axis=1)
    for candidate, kernel in kernels.items():
        compiled = function(kernel.name, "forces", "_forces", kernel.precision)
        one_pose = loop(rows.astype(kernel.dtype), compiled, kernel.model)
        tasks[candidate, "one pose"], tasks[candidate, "batch"] = one_pose[0], batch(many, kernel)[0]
    motion = Motion(**dict(zip(MOTION, slow, strict=True)))
    for name, other in ways.items():
        tasks[name, ""] = Task(over(functools.partial(other.run, "inverse_dynamics", motion)), SLOW)
    return tasks


def _poses(motions: Sequence[Motion], count: int) -> list[Array]:
    """Return the fields of a motion, shape (count, ...), with poses of all motions, repeated if necessary."""
    parts = [loaded(motion) for motion in motions]
    arrays = [np.concatenate([part[name] for part in parts]) for name in MOTION]
    # If fewer poses are required, they are spread evenly along the motions.
    every = np.linspace(0, len(arrays[0]) - 1, min(count, len(arrays[0]))).round().astype(int)
    return [np.resize(array[every], (count, *array.shape[1:])) for array in arrays]
