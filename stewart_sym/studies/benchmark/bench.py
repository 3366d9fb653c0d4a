"""Nanoseconds a pose: the generated kernels beside their baselines and the processor's limit, in one process.

Every candidate computes the actuator forces of `exact`, friction, load and solve included, for the same
poses; those of the second group the equations of motion and what follows from them. Their answers are
compared before any is timed. What the extra ``bench`` would bring is left out where it is missing.
"""

import contextlib
import functools
import os
import sys
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ...backend import c_kernel, kernel, native, numpy_kernel
from ...dynamics import forces
from ...dynamics.inverse import inverse_dynamics
from ...io.extras import EXTRAS, absent
from ...io.progress import Progress, silent
from ...motion.rotation import rotation_from_rpy
from ...motion.straight_line import PATHS
from ...reference import newton_euler as reference
from ...robot.robot import Robot
from ...robots import dasgupta1998
from ..common import host, timing
from ..common.loops import loop_source
from ..common.timing import Task, measured, time_source
from . import compile_times as bench_compile
from . import equation_kernels, reductions
from .baselines import (
    AGREEMENT,
    FEW,
    JAX,
    LARGE,
    MANY,
    NAME,
    PEERS,
    SLOW,
    Candidate,
    Poses,
    Runner,
    c_loop,
    forces_loop,
    multiply_add,
    repeated,
    succeed,
)
from .figures import Benchmark, Figure, PassFigures, Speedup

if TYPE_CHECKING:
    from .baselines_pinocchio import PinocchioMachine

Array = NDArray[np.float64]

ROUNDS, QUICK_ROUNDS = 41, 9
COMPILATIONS, QUICK_COMPILATIONS = 7, 3

SIZES, QUICK_SIZES = (10**3, 10**4, 10**5, 10**6, 10**7), (10**3, 10**4, 10**5)
_SWEEP_ROUNDS = {10**6: 15, 10**7: 7}


# --- the candidates --------------------------------------------------------------------------


def _one_pose(poses: Poses) -> Runner:
    """``stewart_exact_inverse_dynamics`` called from a C loop."""
    body = (
        f"stewart_forces out; const int status = stewart_{NAME}_inverse_dynamics(machine, motion, &out); "
        "memcpy(F, out.F, sizeof out.F); return status;"
    )
    loop = loop_source(f"stewart_{NAME}.h", body)
    library = native.load("bench_one_pose", c_kernel.c_sources(NAME) | loop)
    return c_loop(library, kernel.robot_numbers(poses.robot), poses)


def _fast_pose(poses: Poses) -> Runner:
    """``stewart_exact_forces`` with prepared constants, called from a C loop."""
    sources = c_kernel.c_sources(f"{NAME}_forces") | forces_loop()
    library = native.load("bench_fast_pose", sources)
    return c_loop(library, forces.prepare(poses.robot, NAME).model, poses)


def _batch(precision: forces.Precision, threads: int) -> Callable[[Poses], Runner]:
    """``stewart_exact_forces_batch``, called from Python with given arrays."""

    def make(poses: Poses) -> Runner:
        prepared = forces.prepare(poses.robot, NAME, precision)
        arrays = [np.asarray(array, dtype=prepared.dtype) for array in poses.arrays]
        F = np.zeros((len(poses), 6), dtype=prepared.dtype)
        status = np.zeros(len(poses), dtype=np.int32)

        def found() -> Array:
            succeed(int(status.max()))
            return F

        return repeated(lambda: prepared.forces_into(arrays, F, status, threads), found)

    return make


def _prepared_call(poses: Poses) -> Runner:
    """``OnePose.solve``, one pose a call, numbers and forces in place."""
    slot = forces.prepare(poses.robot, NAME).one_pose()
    slot.numbers[...] = poses.rows[0]

    def run(repeats: int) -> None:
        for _ in range(repeats):
            slot.solve()

    def found() -> Array:
        F = []
        for row in poses.rows:
            slot.numbers[...] = row
            succeed(slot.solve())
            F.append(slot.F.copy())
        return np.array(F)

    return Runner(run, found)


def _python_call(poses: Poses) -> Runner:
    """``inverse_dynamics`` as users call it, one pose a call."""
    robot, motions = poses.robot, [poses.motion[i] for i in range(len(poses))]

    def run(repeats: int) -> None:
        for _ in range(repeats):
            for motion in motions:
                inverse_dynamics(robot, motion)

    return Runner(run, lambda: np.array([inverse_dynamics(robot, motion).F for motion in motions]))


def _numpy(poses: Poses) -> Runner:
    prepared, motion = numpy_kernel.NumpyKernel.prepare(poses.robot, NAME), poses.motion
    return repeated(lambda: prepared.forces(motion), lambda: prepared.forces(motion).F)


def _operations() -> int:
    return sum(kernel.module(NAME).OPERATIONS["friction"]["total"])


def _force_operations() -> int:
    return sum(kernel.module(NAME).FORCE_OPERATIONS["friction"]["total"])


CORES = os.cpu_count() or 1
FLOAT_AGREEMENT = 1e-3
BATCH, ALL_CORES = "batch, one core", f"batch, {CORES} cores"
OURS = (
    Candidate("one pose", "C, F alone", "one pose", FEW, _fast_pose, operations=_force_operations),
    Candidate(
        BATCH, "C, F alone", "batch", LARGE, _batch("double", 1), sweep=True, operations=_force_operations
    ),
    Candidate(ALL_CORES, "C, F alone", "batch", LARGE, _batch("double", CORES), operations=_force_operations),
    Candidate(
        "batch, float",
        "C, F alone",
        "batch",
        LARGE,
        _batch("float", 1),
        operations=_force_operations,
        tolerance=FLOAT_AGREEMENT,
    ),
    Candidate("every output", "C, D K H c x F", "one pose", FEW, _one_pose, operations=_operations),
    Candidate("NumPy kernel", "vectorised", "batch", SLOW, _numpy, operations=_operations),
)
CALLS = (
    Candidate("prepared, one pose", "Python", "call", 1, _prepared_call),
    Candidate("inverse_dynamics()", "Python", "call", 1, _python_call),
)
"""Calls for one pose; what they take over the first of ``OURS`` is the price of the call."""

PINOCCHIO = "Pinocchio"
COMPARED = {"casadi": "casadi", "pinocchio": "pin", "mujoco": "mujoco", "jax": "jax"}
"""Distribution of each optional package that is compared, by the name it is imported by."""

SLOW_TO_COMPILE = ("jax",)
"""Those that a quick run leaves alone."""

ARITHMETIC = f"multiply-add, {CORES} cores"


# --- the run ----------------------------------------------------------------------------------


def bench(robot: Robot | None = None, quick: bool = False, progress: Progress = silent) -> Benchmark:
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
    pinocchio = None if "pinocchio" in missing else _pinocchio(few)
    present = {None, *compared} - {*missing}
    baselines = tuple(each for each in (*PEERS, JAX) if each.package in present)
    stages = reductions.stages(progress)
    candidates = (*OURS, *CALLS, *baselines, *(each for stage in stages for each in stage.candidates))
    sized = functools.cache(poses.resized)
    runners = {each.name: each.make(sized(each.poses)) for each in candidates}
    progress("comparing their forces")
    differences = _differences(poses, candidates, runners, pinocchio)
    motion = equation_kernels.motion_group(few)

    processor = multiply_add()
    tasks = {each.name: Task(runners[each.name].run, each.poses) for each in candidates}
    tasks |= {
        "multiply-add": Task(processor.run, processor.count),
        ARITHMETIC: Task(_on_all_cores(processor.run), CORES * processor.count),
    }
    if pinocchio is not None:
        tasks |= _pinocchio_tasks(pinocchio)
    tasks |= {name: Task(*each) for name, each in motion.tasks.items()}
    rounds = QUICK_ROUNDS if quick else ROUNDS
    others = host.Others()
    raw = measured(tasks, dict.fromkeys(tasks, rounds), progress)
    sweep = _swept(poses, QUICK_SIZES if quick else SIZES, rounds, progress)
    machine["taken_by_others"] = others.share()
    compiling = bench_compile.compile_times(QUICK_COMPILATIONS if quick else COMPILATIONS, progress)
    parts = () if pinocchio is None else _pinocchio_parts(pinocchio, raw)
    return Benchmark(
        robot=poses.robot.name,
        rounds=rounds,
        shortest_sample=timing.SHORTEST,
        ours=tuple(_figure(each, raw) for each in OURS),
        baselines=(*(_figure(each, raw) for each in baselines), *_pinocchio_figure(parts)),
        cores=Speedup(CORES, LARGE, _times(raw[BATCH], raw[ALL_CORES])),
        arithmetic=Speedup(CORES, 0, _times(raw["multiply-add"], raw[ARITHMETIC])),
        calls=tuple(_figure(each, raw) for each in CALLS),
        parts=parts,
        sweep=sweep,
        motion=motion.figures(raw),
        passes=tuple(_pass_figures(stage, raw) for stage in stages),
        compiling=compiling,
        text=bench_compile.text_size(),
        multiply_add=Figure("multiply-add", "fused", "loop", 1, raw["multiply-add"]),
        lanes=processor.lanes,
        differences=differences,
        machine=machine,
        software=host.software(*(COMPARED[name] for name in compared if name not in missing)),
        clock=clock,
        left_out=tuple(EXTRAS[name][0] for name in missing),
    )


def _on_all_cores(run: Callable[[int], object]) -> Callable[[int], None]:
    """The same work on every core at once."""
    workers = ThreadPoolExecutor(CORES)

    def run_all(repeats: int) -> None:
        others = [workers.submit(run, repeats) for _ in range(CORES - 1)]
        run(repeats)
        for other in others:
            other.result()

    return run_all


def _times(one: Sequence[float], many: Sequence[float]) -> tuple[float, ...]:
    """How many times as fast the second is, round by round."""
    return tuple(slow / fast for slow, fast in zip(one, many, strict=True))


def _figure(each: Candidate, raw: Mapping[str, tuple[float, ...]]) -> Figure:
    count = None if each.operations is None else each.operations()
    return Figure(each.name, each.what, each.kind, each.poses, raw[each.name], count)


def _pass_figures(stage: reductions.Stage, raw: Mapping[str, tuple[float, ...]]) -> PassFigures:
    one_pose, batch = (_figure(each, raw) for each in stage.candidates)
    return PassFigures(stage.name, stage.meaning, stage.operations, one_pose, batch)


def _pinocchio(poses: Poses) -> "PinocchioMachine":
    from .baselines_pinocchio import PinocchioMachine

    return PinocchioMachine(poses.robot, poses.motion)


def _pinocchio_tasks(machine: "PinocchioMachine") -> dict[str, Task]:
    return {
        "rnea": Task(machine.newton_euler, FEW),
        "empty call": Task(machine.empty_calls, FEW),
        "solve": Task(machine.solve, machine.solves),
    }


def _pinocchio_parts(
    machine: "PinocchioMachine", raw: Mapping[str, tuple[float, ...]]
) -> tuple[Figure, Figure, Figure]:
    return (
        Figure("rnea", "pin.rnea, 24 joint coordinates", "call", 1, raw["rnea"]),
        Figure("empty call", "pin.rnea over a model without joints", "call", 1, raw["empty call"]),
        Figure("solve", "numpy.linalg.solve, 6x6", "batch", machine.solves, raw["solve"]),
    )


def _pinocchio_figure(parts: Sequence[Figure]) -> tuple[Figure, ...]:
    """The figure that the parts make; none without them."""
    if not parts:
        return ()
    rounds = zip(*(part.raw for part in parts), strict=True)
    times = tuple(rnea - empty + solve for rnea, empty, solve in rounds)
    return (Figure(PINOCCHIO, "rnea + solve - call", "call", 1, times),)


def _differences(
    poses: Poses,
    candidates: Sequence[Candidate],
    runners: Mapping[str, Runner],
    pinocchio: "PinocchioMachine | None",
) -> dict[str, float]:
    """Compare everybody's forces with the reference's."""
    truth = reference.inverse_dynamics(poses.robot, poses.motion).F
    largest = np.abs(truth).max(axis=-1, keepdims=True)
    found: dict[str, float] = {}
    answers = [(each.name, each.tolerance, runners[each.name]) for each in candidates]
    if pinocchio is not None:
        answers.append((PINOCCHIO, AGREEMENT, Runner(pinocchio.newton_euler, pinocchio.F)))
    for name, tolerance, runner in answers:
        runner.run(1)
        F = runner.F()[: len(truth)]
        found[name] = float(np.max(np.abs(F - truth[: len(F)]) / largest[: len(F)]))
        if not found[name] <= tolerance:
            raise ValueError(
                f"{name}: forces differ from the reference's by {found[name]:.1e}, expected {tolerance:g}"
            )
    return found


def _swept(poses: Poses, sizes: Sequence[int], rounds: int, progress: Progress) -> tuple[Figure, ...]:
    """Batches of all sizes that fit into memory; small ones are the beginning of the largest."""
    swept = [each for each in OURS if each.sweep]
    room = _free_memory()
    # Motions of 240 bytes, forces of 48 and a status for each candidate, and as much again to breathe.
    sizes = [size for size in sizes if 2 * size * (240 + 52 * len(swept)) < room or size == min(sizes)]
    progress("preparing the batches")
    largest = poses.resized(max(sizes))
    runners = {(each.name, size): each.make(largest.resized(size)) for size in sizes for each in swept}
    tasks = {key: Task(runner.run, key[1]) for key, runner in runners.items()}
    raw = measured(tasks, {key: min(rounds, _SWEEP_ROUNDS.get(key[1], rounds)) for key in tasks}, progress)
    return tuple(
        Figure(each.name, each.what, each.kind, size, raw[each.name, size])
        for each in swept
        for size in sizes
    )


# --- poses ------------------------------------------------------------------------------------


def bench_poses(robot: Robot | None, count: int) -> Poses:
    """Poses that all differ, moving, loaded and regular, the same in every run.

    robot: None for the paper's machine. Raises ValueError if its base joints are not universal or it has no
    regular poses about its middle.
    """
    rng = np.random.default_rng(1998)
    if robot is None:
        robot = dasgupta1998()
        R, t, omega, v, alpha, a = _near_the_paths(rng, count)
    elif robot.base_joint != "universal":
        raise ValueError(f"{robot.name}: expected universal base joints, the baselines have no others")
    else:
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
    """Instants of Paths I and II by turns, each moved a little."""
    paths = [PATHS[name].path for name in ("I", "II")]
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
    """Poses about the one where the platform is above the base by as much as the base is wide."""
    centre = robot.b.mean(axis=0)
    size = float(np.linalg.norm(robot.b - centre, axis=-1).mean())
    up = -robot.g / np.linalg.norm(robot.g) if robot.g.any() else np.array([0.0, 0.0, 1.0])
    home = centre + size * up - robot.p.mean(axis=0)
    rate = np.sqrt(9.81 / size)

    def some(scale: float) -> Array:
        return scale * rng.normal(size=(count, 3))

    R, t = rotation_from_rpy(some(0.1)), home + some(0.05 * size)
    return R, t, some(0.2 * rate), some(0.2 * rate * size), some(0.2 * rate**2), some(0.2 * rate**2 * size)


# --- memory ---------------------------------------------------------------------------------------


def _free_memory() -> int:
    """Bytes that may be used; 2 GiB where the system doesn't tell."""
    if sys.platform.startswith("linux"):
        with contextlib.suppress(OSError, ValueError, IndexError):
            for text in Path("/proc/meminfo").read_text(encoding="utf-8").splitlines():
                if text.startswith("MemAvailable:"):
                    return 1024 * int(text.split()[1])
    return 2 << 30
