"""Nanoseconds a pose: the generated kernels beside their baselines and the processor's limit, in one process.

Every candidate computes the actuator forces of `exact`, friction, load and solve included, for the same
poses; those of the second group the equations of motion and what follows from them. C is compiled for all
instructions of the processor and, where it has AVX-512, without. Their answers are compared before any is
timed. What the extra ``bench`` would bring is left out where it is missing.
"""

import contextlib
import ctypes
import dataclasses
import functools
import os
import sys
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np

from ...backend import c_kernel, kernel, native, numpy_kernel
from ...dynamics import forces
from ...dynamics.inverse_dynamics import inverse_dynamics
from ...io.array_types import Array
from ...io.extras import EXTRAS, absent
from ...io.progress import Progress, silent
from ...reference import newton_euler as reference
from ...robot.robot import Robot
from ..common import host, timing
from ..common.loops import loop_source
from ..common.output import Figures
from ..common.timing import Task, measured, repeated, time_source
from . import compile_times as bench_compile
from . import equation_kernels
from .baselines import (
    FEW,
    JAX,
    LARGE,
    MANY,
    PEERS,
    SLOW,
    Called,
    Candidate,
    Runner,
    Stage,
    c_loop,
    checked,
    difference,
    forces_loop,
    jax_one_pose,
    stages,
    succeed,
)
from .figures import (
    BATCH,
    CLOSED,
    COLUMNS,
    FLOAT,
    NAME,
    ONE_POSE,
    PLAIN,
    Raw,
    Timed,
    build_of,
    figure,
    flatness,
    limits,
    quickest,
    sampled,
    shares,
    with_ratios,
)
from .poses import Poses, bench_poses
from .processor import FUSED, Flags, MultiplyAdd, Target, additions, multiply_add, targets, widest

ROUNDS, QUICK_ROUNDS = 41, 9
COMPILATIONS, QUICK_COMPILATIONS = 7, 3

SIZES, QUICK_SIZES = (10**3, 10**4, 10**5, 10**6, 10**7), (10**3, 10**4, 10**5)
_SWEEP_ROUNDS = {10**6: 15, 10**7: 7}

_Make = Callable[[Poses, Flags], Runner]


# --- the candidates --------------------------------------------------------------------------


def _one_pose(poses: Poses, flags: Flags) -> Runner:
    """``stewart_exact_inverse_dynamics`` called from a C loop."""
    body = (
        f"stewart_forces out; const int status = stewart_{NAME}_inverse_dynamics(machine, motion, &out); "
        "memcpy(F, out.F, sizeof out.F); return status;"
    )
    loop = loop_source(f"stewart_{NAME}.h", body)
    library = native.load("bench_one_pose", c_kernel.c_sources(NAME) | loop, flags)
    return c_loop(library, kernel.robot_numbers(poses.robot), poses)


def _fast_pose(poses: Poses, flags: Flags) -> Runner:
    """``stewart_exact_forces`` with prepared constants, called from a C loop."""
    sources = c_kernel.c_sources(f"{NAME}_forces") | forces_loop()
    library = native.load("bench_fast_pose", sources, flags)
    return c_loop(library, forces.ForceKernel(poses.robot, NAME).model, poses)


def _batch(precision: forces.Precision, threads: int) -> _Make:
    """``stewart_exact_forces_batch``, called from Python with given arrays."""

    def make(poses: Poses, flags: Flags) -> Runner:
        defines = ("STEWART_FLOAT",) if precision == "float" else ()
        library = c_kernel.library(f"{NAME}_forces", defines, flags)
        prepared = _compiled(library, poses.robot, precision)
        arrays = [np.asarray(array, dtype=prepared.dtype) for array in poses.arrays]
        F = np.zeros((len(poses), 6), dtype=prepared.dtype)
        status = np.zeros(len(poses), dtype=np.int32)
        run = repeated(lambda: prepared.forces(arrays, threads, out=(F, status)))
        return Runner(run, checked(F, status), library=library)

    return make


def _columns(poses: Poses, flags: Flags) -> Runner:
    """``stewart_exact_forces_columns`` of the same poses, which lie in columns already."""
    library = c_kernel.library(f"{NAME}_forces", (), flags)
    prepared = _compiled(library, poses.robot, "double")
    arrays = [_in_columns(array.reshape(len(poses), -1).T) for array in poses.arrays]
    F, status = _in_columns(np.zeros((6, len(poses)))), np.zeros(len(poses), dtype=np.int32)
    compute: Callable[..., object] = prepared.forces_soa
    run = repeated(lambda: compute(*arrays, out=(F, status)))
    return Runner(run, checked(F.T, status), library=library)


def _in_columns(array: Array) -> Array:
    """The rows of an array, each beginning where a line of the cache does, and elsewhere in a page."""
    width, count = array.shape
    stride = 8 * (-(-count // 8) | 1)
    room = np.zeros(width * stride + 7)
    first = -room.ctypes.data // 8 % 8
    found = room[first : first + width * stride].reshape(width, stride)[:, :count]
    found[...] = array
    return found


def _compiled(library: ctypes.CDLL, robot: Robot, precision: forces.Precision) -> forces.ForceKernel:
    """The prepared kernel whose functions are those of a library."""

    class Compiled(forces.ForceKernel):
        def c_function(self, what: str) -> Any:
            return getattr(library, f"stewart_{self.name}_{what}")

    return Compiled(robot, NAME, precision)


def _prepared_call(poses: Poses, _: Flags) -> Runner:
    """``OnePose.solve``, one pose a call, numbers and forces in place."""
    slot = forces.ForceKernel(poses.robot, NAME).single_pose()
    slot.numbers[...] = poses.rows[0]

    def found() -> Array:
        F = []
        for row in poses.rows:
            slot.numbers[...] = row
            succeed(slot.solve())
            F.append(slot.F.copy())
        return np.array(F)

    return Runner(repeated(slot.solve), found)


def _python_call(poses: Poses, _: Flags) -> Runner:
    """``inverse_dynamics`` as users call it, one pose a call."""
    given = [(poses.robot, poses.motion[i]) for i in range(len(poses))]
    found = timing.over(inverse_dynamics, given)
    return Runner(found, lambda: np.array([inverse_dynamics(*each).F for each in given]))


def _numpy(poses: Poses, _: Flags) -> Runner:
    prepared, motion = numpy_kernel.NumpyKernel.prepare(poses.robot, NAME), poses.motion
    return Runner(repeated(lambda: prepared.forces(motion)), lambda: prepared.forces(motion).F)


def _operations(counts: str = "OPERATIONS") -> int:
    return sum(getattr(kernel.module(NAME), counts)["friction"]["total"])


_force_operations = functools.partial(_operations, "FORCE_OPERATIONS")


CORES = os.cpu_count() or 1
FLOAT_AGREEMENT = 1e-3
ALL_CORES = f"batch, {CORES} cores"
_BATCH = f"stewart_{NAME}_forces_batch"


def _forces_batch(name: str, make: _Make, function: str = _BATCH, **more: Any) -> Candidate:
    """The forces alone of many poses in one call of the C."""
    counted: Any = {"operations": _force_operations, "function": function, **more}
    return Candidate(name, "C, F alone", "batch", LARGE, make, **counted)


OURS = (
    Candidate(
        ONE_POSE, "C, F alone", "one pose", FEW, _fast_pose, operations=_force_operations, function="drive"
    ),
    _forces_batch(BATCH, _batch("double", 1), sweep=True),
    _forces_batch(COLUMNS, _columns, f"stewart_{NAME}_forces_columns"),
    _forces_batch(ALL_CORES, _batch("double", CORES)),
    _forces_batch(FLOAT, _batch("float", 1), tolerance=FLOAT_AGREEMENT),
    Candidate(
        "every output", "C, D K H c x F", "one pose", FEW, _one_pose, operations=_operations, function="drive"
    ),
    Candidate("NumPy kernel", "vectorized", "batch", SLOW, _numpy, operations=_operations),
)
CALLS = (
    Candidate("prepared, one pose", "Python", "call", 1, _prepared_call),
    Candidate("inverse_dynamics()", "Python", "call", 1, _python_call),
)
"""Calls for one pose; what they take over the first of ``OURS`` is the price of the call."""

COMPARED = {"casadi": "casadi", "pinocchio": "pin", "pydrake": "drake", "mujoco": "mujoco", "jax": "jax"}
"""Distribution of each optional package that is compared, by the name it is imported by."""

SLOW_TO_COMPILE = ("jax",)
"""Those that a quick run leaves alone."""


# --- the run ----------------------------------------------------------------------------------


def bench(robot: Robot | None = None, quick: bool = False, progress: Progress = silent) -> Figures:
    """Measure everything on this machine.

    robot: None for the paper's machine near its Paths I and II; another one moves about its middle. quick:
    fewer rounds and sizes, and without JAX, which compiles for half a minute.

    Raises ValueError if the robot's base joints are not universal, if it has no regular poses there, if a
    candidate's forces are wrong, or if the clock is too coarse; CompilerError without a C compiler.
    """
    clock, machine = time_source(), host.machine()
    progress("preparing the poses")
    poses = bench_poses(robot, MANY)
    few = poses.resized(FEW)
    progress("compiling the baselines")
    compared = [each for each in COMPARED if not (quick and each in SLOW_TO_COMPILE)]
    missing = absent(*compared)
    present = {None, *compared} - {*missing}
    baselines = tuple(each for each in (*PEERS, JAX) if each.package in present)
    passes = stages(progress)
    kinds = targets()
    variants = _variants((*OURS, *baselines), kinds)
    candidates = (*OURS, *CALLS, *baselines, *variants)
    candidates += tuple(each for stage in passes for each in stage.candidates)
    sized = functools.cache(poses.resized)
    runners = {each.label: each.runner(sized(each.poses)) for each in candidates}
    called = _called(few, present)
    progress("comparing their forces")
    differences = _differences(poses, candidates, runners, called)
    motion = equation_kernels.motion_group(few, kinds)

    timed = {each.label: _timed(each, runners[each.label], kinds) for each in candidates}
    loops = {kind: multiply_add(kind.flags) for kind in kinds}
    first, chain = loops[kinds[0]], additions()
    together = Task(_on_all_cores(first.run), CORES * first.units)
    tasks = [*timed.values(), *loops.values(), together, chain, *motion.tasks]
    tasks += [part for each in called for part in each.parts]
    rounds = QUICK_ROUNDS if quick else ROUNDS
    others = host.Others()
    raw = measured({task: task for task in tasks}, dict.fromkeys(tasks, rounds), progress)
    sweep = _swept(poses, QUICK_SIZES if quick else SIZES, rounds, progress)
    machine["taken_by_others"] = others.share()
    compiling = bench_compile.compile_times(QUICK_COMPILATIONS if quick else COMPILATIONS, progress)
    figures = {label: each.figure(raw) for label, each in timed.items()}
    of_c = [each for each in figures.values() if "instructions" in each]
    summed = {each.name: each.figures(raw) for each in called}
    builds = [*of_c, *(each.figure(raw) for each in motion.built)]
    names = [*dict.fromkeys(each["name"] for each in builds)]
    cycle = figure("addition in a chain", "whole numbers", "loop", 1, raw[chain])
    over_casadi = with_ratios(
        {
            "ours": [figures[each.label] for each in OURS],
            "baselines": [
                *(_fastest(figures, of_c, each, kinds[0]) for each in baselines),
                *(sum_of_parts for sum_of_parts, _ in summed.values()),
            ],
            "builds": sorted(builds, key=lambda each: names.index(each["name"])),
            "cycle": {**cycle, "unit": "ns", "clock_GHz": 1 / cycle["median"]},
        }
    )
    one_pose = over_casadi["ours"][0]
    calls = [figures[each.label] for each in CALLS]
    peaks = [_peak(kind, loop, raw, one_pose["operations"], cycle["median"]) for kind, loop in loops.items()]
    return {
        "schema": 4,
        "unit": "ns/pose",
        "robot": poses.robot.name,
        "formulation": NAME,
        "rounds": rounds,
        "shortest_sample_s": timing.SHORTEST,
        "machine": machine,
        "software": host.software(*(COMPARED[name] for name in compared if name not in missing)),
        "clock": clock,
        "left_out": [EXTRAS[name][0] for name in missing],
        **({"ratio_to": [CLOSED, PLAIN]} if "casadi" in present else {}),
        "ours": over_casadi["ours"],
        "baselines": over_casadi["baselines"],
        "builds": over_casadi["builds"],
        "shares": shares(over_casadi | {"peaks": peaks}),
        "cores": _speedup(LARGE, raw[timed[BATCH]], raw[timed[ALL_CORES]]),
        "cores_arithmetic": _speedup(0, raw[first], raw[together]),
        "parts": {name: parts for name, (_, parts) in summed.items()},
        "calls": [{**each, "overhead_over_c_ns": each["median"] - one_pose["median"]} for each in calls],
        "sweep": sweep,
        "flatness": flatness(sweep),
        "motion": motion.figures(raw),
        "passes": [_pass_figures(stage, figures) for stage in passes],
        "compiling": compiling,
        "text": bench_compile.text_size(),
        "cycle": over_casadi["cycle"],
        "peaks": peaks,
        "largest_difference": differences,
    }


def _variants(candidates: Sequence[Candidate], kinds: Sequence[Target]) -> tuple[Candidate, ...]:
    """The C once more for the other targets, and others' C with products and sums fused as well."""
    return tuple(
        dataclasses.replace(each, flags=(*kind.flags, *fused))
        for each in candidates
        if each.function
        for kind in kinds
        for fused in ((), FUSED)
        if (kind.flags or fused) and (each.package or not fused)
    )


def _timed(each: Candidate, runner: Runner, kinds: Sequence[Target]) -> Timed:
    """A candidate as it is timed; C with what it was compiled for."""
    count = None if each.operations is None else each.operations()
    build: Figures = {}
    if each.function is not None and runner.library is not None:
        kind = next(kind for kind in reversed(kinds) if kind.flags == each.flags[: len(kind.flags)])
        build = build_of(kind.name, each.flags, widest(runner.library, each.function))
    return Timed(runner.run, each.poses, each.name, each.what, each.kind, count, build)


def _fastest(
    figures: Mapping[str, Figures], of_c: Iterable[Figures], each: Candidate, kind: Target
) -> Figures:
    """The fastest of a candidate's builds for a target; the only one of what is no C."""
    builds = [found for found in of_c if (found["name"], found["instructions"]) == (each.name, kind.name)]
    return quickest(builds) or figures[each.label]


def _on_all_cores(run: Callable[[int], object]) -> Callable[[int], None]:
    workers = ThreadPoolExecutor(CORES)

    def run_all(repeats: int) -> None:
        others = [workers.submit(run, repeats) for _ in range(CORES - 1)]
        run(repeats)
        for other in others:
            other.result()

    return run_all


def _speedup(poses: int, one: Sequence[float], many: Sequence[float]) -> Figures:
    """How many times as fast all cores are as one, round by round; no poses: arithmetic without memory."""
    raw = tuple(slow / fast for slow, fast in zip(one, many, strict=True))
    return sampled(cores=CORES, poses=poses, raw=raw) | {"unit": "times as fast as one core"}


def _pass_figures(stage: Stage, figures: Mapping[str, Figures]) -> Figures:
    one_pose, batch = (figures[each.label] for each in stage.candidates)
    without, with_friction = stage.source.operations
    operations = {"without_friction": without, "with_friction": with_friction}
    named = {"name": stage.source.name, "meaning": stage.source.meaning, "operations": operations}
    return {**named, "one_pose": one_pose, "batch": batch}


def _peak(kind: Target, loop: MultiplyAdd, raw: Raw, operations: int, cycle: float) -> Figures:
    """The most that one core does with a target's instructions."""
    found = figure("multiply-add", "fused", "loop", 1, raw[loop])
    each = found["median"]
    return {
        **found,
        "unit": "ns per fused multiply-add of one number, one core",
        "instructions": kind.name,
        "flags": kind.flags,
        "rate_per_s": 1e9 / each,
        "numbers_in_a_vector": loop.lanes,
        "vectors_in_a_cycle": cycle / (each * loop.lanes),
        "limits": limits(operations, each),
    }


def _called(poses: Poses, present: Collection[str | None]) -> tuple[Called, ...]:
    """The baselines that Python calls pose by pose, of the packages present."""
    found = []
    if "pinocchio" in present:
        from .engines.pinocchio import pinocchio_rnea

        found.append(pinocchio_rnea(poses.robot, poses.motion))
    if "pydrake" in present:
        from .engines.drake_inverse import drake_inverse

        found.append(drake_inverse(poses.robot, poses.motion))
    if "jax" in present:
        found.append(jax_one_pose(poses))
    return tuple(found)


def _differences(
    poses: Poses, candidates: Sequence[Candidate], runners: Mapping[str, Runner], called: Sequence[Called]
) -> dict[str, float]:
    truth = reference.inverse_dynamics(poses.robot, poses.motion).F
    for each in candidates:
        runners[each.label].run(1)
    answers = [(each.label, each.tolerance, runners[each.label].F()) for each in candidates]
    answers += [(each.name, each.tolerance, each.found()) for each in called]
    return {
        name: difference(name, F[: len(truth)], [truth[: len(F)]], tolerance, "forces")
        for name, tolerance, F in answers
    }


def _swept(poses: Poses, sizes: Sequence[int], rounds: int, progress: Progress) -> list[Figures]:
    """Batches of all sizes that fit into memory; small ones are the beginning of the largest."""
    swept = [each for each in OURS if each.sweep]
    room = _free_memory()
    # A motion takes 240 bytes, forces and a status 52 for each candidate; half of the memory stays free.
    sizes = [size for size in sizes if 2 * size * (240 + 52 * len(swept)) < room or size == min(sizes)]
    progress("preparing the batches")
    largest = poses.resized(max(sizes))
    tasks = [
        Timed(each.runner(largest.resized(size)).run, size, each.name, each.what, each.kind)
        for each in swept
        for size in sizes
    ]
    taken = {task: min(rounds, _SWEEP_ROUNDS.get(task.units, rounds)) for task in tasks}
    raw = measured({task: task for task in tasks}, taken, progress)
    return [task.figure(raw) for task in tasks]


def _free_memory() -> int:
    """Bytes that may be used; 2 GiB where the system doesn't tell."""
    if sys.platform.startswith("linux"):
        with contextlib.suppress(OSError, ValueError, IndexError):
            for text in Path("/proc/meminfo").read_text(encoding="utf-8").splitlines():
                if text.startswith("MemAvailable:"):
                    return 1024 * int(text.split()[1])
    return 2 << 30
