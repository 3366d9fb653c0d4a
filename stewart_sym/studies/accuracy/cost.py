"""What each kernel costs and how far it is off on a machine's motions, in every fidelity and precision.

Error is split into that of the model, beside `exact` general in double, and that of rounding, beside the
kernel's own equations at 50 digits. All errors are shares of the largest actuator force of their motion.
"""

import ctypes
import functools
import itertools
import statistics
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from ...backend import fidelity, native
from ...backend.c_kernel import address
from ...backend.kernel import FORMULATIONS, MOTION
from ...backend.numpy_kernel import loaded
from ...dynamics.forces import CORES, ForceKernel, Precision
from ...dynamics.inverse_dynamics import Backend, prepared_kernel
from ...io.array_types import Array
from ...io.progress import Progress, silent, tracked
from ...kinematics.conditioning import characteristic_length, scaled_condition_number
from ...kinematics.inverse_kinematics import wrench_matrix
from ...motion.motion import Motion
from ...precision.truth import Truth, deviation
from ...robot.robot import Robot
from ..benchmark.compile_times import text_size
from ..common import host
from ..common.loops import own_source
from ..common.output import Figures
from ..common.timing import Task, measured, repeated

PRECISIONS: tuple[Precision, ...] = ("float", "double")
"""The cheaper first."""

ROUNDS, QUICK_ROUNDS = 21, 9
FEW, SLOW, MANY = 64, 1_024, 4_096
"""Poses of a C loop over one-pose calls, of a batch in NumPy, of a batch in C."""

SAMPLED = 12
"""Poses of a motion at which rounding is measured, spread evenly; those of the largest force and the
largest condition number come on top."""

_ROUNDING = 100 * float(np.finfo(np.float64).eps)
"""Two kernels of the same model in double may differ by this share of force times condition number."""


# --- figures ----------------------------------------------------------------------------------


class Candidate(NamedTuple):
    """One kernel that a scene might do with."""

    formulation: str
    fidelity: str
    precision: str

    @property
    def name(self) -> str:
        """The three in words."""
        return f"{self.formulation} {self.fidelity}, {self.precision}"


def candidate_of(entry: Figures) -> Candidate:
    """The kernel that the figures are of."""
    return Candidate(*(entry[name] for name in Candidate._fields))


def entry_of(found: Figures, *kernel: str) -> Figures:
    """Figures of one candidate, of a formulation, a fidelity and a precision."""
    return next(entry for entry in found["candidates"] if candidate_of(entry) == kernel)


def worst(entry: Figures, *parts: str) -> float:
    """The largest error on any motion: of the parts named, which add up at worst, by default of all."""
    named = parts or ("model", "rounding")
    return float(max(sum(errors[part] for part in named) for errors in entry["errors"].values()))


_UNITS = {
    "errors": "share of the motion's peak force",
    "rounding": "share of the motion's peak force",
    "operations": "per pose",
    "ns": "per pose",
    "taken_by_others": "share of the cores' time",
    "load": "busy processes",
}


# --- the study --------------------------------------------------------------------------------


def cost(
    robot: Robot,
    motions: Mapping[str, Motion],
    implementations: bool = False,
    rounds: int = QUICK_ROUNDS,
    progress: Progress = silent,
) -> Figures:
    """Measure every candidate on the motions, each of shape (n,), with an answer at every pose.

    implementations: also other ways to compute `exact` general, for comparison. rounds: of timing.

    Of each motion the largest actuator force; of each candidate, the cheapest first, by operations, then
    precision: operations per pose, ns per pose, alone and in a batch, bytes of code of a program that
    computes one pose at a time (None where no tool can tell), and by motion the largest error of the model
    and its RMS over poses and legs, beside `exact` general (0 where two double kernels of the same equations
    might differ by as much), and the largest of rounding at the sampled poses; infinite where there are
    unsolvable poses. What others took of the cores' time meanwhile, and the load, are None where the system
    doesn't tell.

    A precision that can't hold the robot's constants is left out. Raises ValueError where all forces of a
    motion are zero, native.CompilerError without a C compiler.
    """
    kernels, texts = _compiled(robot, progress)
    paths = tracked(progress, motions.items(), lambda each: f"computing the forces of {each[0]}")
    cases = {name: _Case.of(robot, motion, name) for name, motion in paths}
    progress("compiling the truth of 50 digits")
    ways = _ways(robot) if implementations else {}
    errors: dict[Candidate, Figures] = {candidate: {} for candidate in kernels}
    # Candidates of the same equations, which share their truth, follow one another.
    by_model = [
        [*each] for _, each in itertools.groupby(kernels, lambda each: (each.formulation, each.fidelity))
    ]
    models = [(name, candidates) for name in cases for candidates in by_model]
    for name, candidates in tracked(progress, models, lambda model: f"computing {model[0]} at 50 digits"):
        for candidate, found in cases[name].errors({each: kernels[each] for each in candidates}).items():
            errors[candidate][name] = found
    rounding = {
        way: {name: case.rounding_of(forces) for name, case in cases.items()} for way, forces in ways.items()
    }
    tasks = _tasks(tuple(motions.values()), kernels, ways)
    others = host.Others()
    raw = measured(tasks, dict.fromkeys(tasks, rounds), progress)
    taken, load = others.share(), host.load_average()
    entries = [
        {
            **candidate._asdict(),
            "operations": fidelity.operations(robot, candidate.formulation, candidate.fidelity),
            **_times("one_pose_", raw[candidate, "one pose"]),
            **_times("batch_", raw[candidate, "batch"]),
            "text_bytes": texts[candidate],
            "errors": errors[candidate],
        }
        for candidate in kernels
    ]
    return {
        "robot": robot.name,
        "taken_by_others": taken,
        "load": None if load is None else load[0],
        "motions": {name: {"poses": len(case.F), "peak_force_N": case.peak} for name, case in cases.items()},
        "candidates": sorted(entries, key=_cost),
        "implementations": [
            {"name": way, **_times("", raw[way, ""]), "rounding": rounding[way]} for way in ways
        ],
        "units": _UNITS,
    }


def _times(name: str, raw: tuple[float, ...]) -> Figures:
    return {f"{name}ns": statistics.median(raw), f"{name}raw_ns": raw}


def candidates(robot: Robot) -> list[Candidate]:
    """Every fidelity of every formulation that there is for a robot, in either precision."""
    return [
        Candidate(formulation, level, precision)
        for formulation in FORMULATIONS
        for level in fidelity.available(robot, formulation)
        for precision in PRECISIONS
    ]


_RICHEST_FIRST = tuple(dict.fromkeys((*fidelity.DRIVE_FIDELITIES, *fidelity.FIDELITIES)))


def _cost(entry: Figures) -> tuple[int, int, int, int]:
    """The same on every run, other than times: operations, width of the numbers; then the richer model."""
    return (
        entry["operations"],
        PRECISIONS.index(entry["precision"]),
        FORMULATIONS.index(entry["formulation"]),
        _RICHEST_FIRST.index(entry["fidelity"]),
    )


# --- compiling --------------------------------------------------------------------------------


def _compiled(
    robot: Robot, progress: Progress
) -> tuple[dict[Candidate, ForceKernel], dict[Candidate, int | None]]:
    """Kernels, and bytes of their code, compiled side by side."""
    every = candidates(robot)
    with ThreadPoolExecutor(CORES) as pool:
        made = {each: pool.submit(_kernel, robot, each) for each in every}
        sizes = {each: pool.submit(_text, robot, each) for each in every}
        done = tracked(progress, made.items(), lambda pair: f"compiling {pair[0].name}")
        kernels = {each: future.result() for each, future in done}
        ended = tracked(progress, sizes.items(), lambda pair: f"measuring the code of {pair[0].name}")
        texts = {each: future.result() for each, future in ended}
    return {each: kernel for each, kernel in kernels.items() if kernel is not None}, texts


def _kernel(robot: Robot, candidate: Candidate) -> ForceKernel | None:
    """The kernel with the robot's constants, None if its precision can't hold them."""
    formulation, precision = cast(Any, candidate.formulation), cast(Precision, candidate.precision)
    try:
        return ForceKernel(robot, formulation, precision, candidate.fidelity, warns=False)
    except ValueError:
        if precision == "double":
            raise
        return None


def _text(robot: Robot, candidate: Candidate) -> int | None:
    name = fidelity.force_kernel_name(robot, candidate.formulation, candidate.fidelity)
    size = text_size(name, ("STEWART_FLOAT",) if candidate.precision == "float" else ())
    return None if size is None else int(size["total"])


# --- errors -----------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class _Case:
    """One motion: forces (n, 6) of `exact` general, their peak, the forces' accuracy in double (n, 1), and
    poses that are hard to compute.
    """

    robot: Robot
    motion: Motion
    F: Array
    peak: float
    accuracy: Array
    sample: Sequence[int]

    @classmethod
    def of(cls, robot: Robot, motion: Motion, name: str) -> "_Case":
        F = ForceKernel(robot).forces(motion)
        peak = float(np.abs(F).max())
        if peak == 0.0:
            raise ValueError(f"{name}: all forces are zero, errors can't be shares of them")
        condition = scaled_condition_number(wrench_matrix(robot, motion), characteristic_length(robot))
        largest = np.abs(F).max(axis=-1)
        spread = np.linspace(0, len(F) - 1, min(SAMPLED, len(F))).round().astype(int).tolist()
        sample = {*spread, int(largest.argmax()), int(condition.argmax())}
        accuracy = (_ROUNDING * condition * largest)[:, None]
        return cls(robot, motion, F, peak, accuracy, sorted(sample))

    def errors(self, kernels: Mapping[Candidate, ForceKernel]) -> dict[Candidate, Figures]:
        """Of kernels of the same equations, one of them in double."""
        F = {each: kernel.forces(self.motion, on_singular="nan") for each, kernel in kernels.items()}
        in_double = next(forces for each, forces in F.items() if each.precision == "double")
        off = _or_infinite(in_double - self.F)
        off[off <= self.accuracy] = 0.0
        # The rounding error is largest where the precisions differ most.
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

    def rounding_of(self, forces: Callable[[Motion], Array]) -> float:
        """Rounding error of another way to compute `exact` general."""
        motion = self.motion[list(self.sample)]
        off = deviation(forces(motion), Truth(self.robot).forces(motion))
        return float(_or_infinite(off).max()) / self.peak


def _or_infinite(difference: NDArray[Any]) -> Array:
    """Sizes of differences; infinite where the pose is unsolvable."""
    return np.abs(np.nan_to_num(np.asarray(difference, dtype=np.float64), nan=np.inf))


# --- time -------------------------------------------------------------------------------------


def _ways(robot: Robot) -> dict[str, Callable[[Motion], Array]]:
    """Other implementations of `exact` general: F, (n, 6), of a motion."""

    def way(backend: Backend) -> Callable[[Motion], Array]:
        prepared = prepared_kernel(robot, "exact", backend)
        return lambda motion: prepared.forces(motion).F

    return {"every output": way("c"), "NumPy kernel": way("numpy"), "vector reference": way("reference")}


def _tasks(
    motions: Sequence[Motion],
    kernels: Mapping[Candidate, ForceKernel],
    ways: Mapping[str, Callable[[Motion], Array]],
) -> dict[tuple[Candidate | str, str], Task]:
    """What is timed: each kernel's "one pose" and "batch", and the other ways, key ""."""
    few, slow, many = (_poses(motions, count) for count in (FEW, SLOW, MANY))
    tasks: dict[tuple[Candidate | str, str], Task] = {}
    for candidate, kernel in kernels.items():
        tasks[candidate, "one pose"] = Task(_one_pose(kernel, few), FEW)
        arrays = [np.ascontiguousarray(array, dtype=kernel.dtype) for array in many]
        F, status = np.zeros((MANY, 6), dtype=kernel.dtype), np.zeros(MANY, dtype=np.int32)
        batch = functools.partial(kernel.forces, arrays, out=(F, status))
        tasks[candidate, "batch"] = Task(repeated(batch), MANY)
    motion = Motion(**dict(zip(MOTION, slow, strict=True)))
    for name, forces in ways.items():
        tasks[name, ""] = Task(repeated(functools.partial(forces, motion)), SLOW)
    return tasks


def _poses(motions: Sequence[Motion], count: int) -> list[Array]:
    """The fields of a motion, (count, ...): poses of all motions, over and over."""
    parts = [loaded(motion) for motion in motions]
    arrays = [np.concatenate([getattr(part, name) for part in parts]) for name in MOTION]
    # Fewer poses than there are: spread evenly along the motions.
    every = np.linspace(0, len(arrays[0]) - 1, min(count, len(arrays[0]))).round().astype(int)
    return [np.resize(array[every], (count, *array.shape[1:])) for array in arrays]


def _one_pose(kernel: ForceKernel, poses: Sequence[Array]) -> Callable[[int], object]:
    loop = native.load("cost_loop", {"loop.c": own_source("kernel_loop.c")})
    count = len(poses[0])
    rows = np.concatenate([array.reshape(count, -1) for array in poses], axis=1).astype(kernel.dtype)
    F = np.zeros(6, dtype=kernel.dtype)
    function = ctypes.cast(kernel.c_function("forces"), ctypes.c_void_p)
    row_bytes = ctypes.c_size_t(rows.strides[0])

    def run(repeats: int) -> object:
        return loop.drive(
            function,
            address(kernel.model),
            ctypes.c_size_t(count),
            ctypes.c_size_t(repeats),
            address(rows),
            row_bytes,
            address(F),
        )

    return run
