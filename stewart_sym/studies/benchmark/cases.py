"""Cases that ``benchmark`` times: our kernels, the vector reference, CasADi, Pinocchio, and MuJoCo."""

import ctypes
import functools
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...backend import c_kernel, kernel, native
from ...dynamics import closed_form, equations
from ...dynamics.forces import CORES, ForceKernel, Precision
from ...dynamics.inverse_dynamics import Formulation, inverse_dynamics, prepared_kernel
from ...exchange.model_from_robot import robot_of_bodies
from ...io.array_types import Array
from ...io.extras import absent
from ...io.progress import Progress
from ...motion.motion import Motion
from ...reference import newton_euler
from ...reference.equations_of_motion import regressor
from ...robot.robot import Robot
from ..common.kernel_loop import kernel_loop
from ..common.timing import Task, over, repeated
from .case import AGREEMENT, CALLS, EQUATIONS, FORCES, PASSES, SIZES, Case
from .engines import forward_engines, inverse_engines
from .poses import Poses

NAME: Formulation = "exact"
"""Measured formulation."""

FEW, SLOW, MANY, LARGE = 64, 1_000, 10_000, 200_000
"""Number of poses of a loop in C (in the first cache), a NumPy batch, the reference, and a C batch."""

_EQUATION_POSES = 16
"""Number of poses whose outputs, except the regressor, fit into the first cache."""

BATCHES, QUICK_BATCHES = (10**3, 10**4, 10**5, 10**6), (10**3, 10**4, 10**5)

CLOSED, PLAIN = "CasADi, closed form", "CasADi"
"""Cases whose times are the bases of the ratios."""

INVERSE, FORWARD = "inverse dynamics", "forward dynamics"

_FUSED = ("-ffp-contract=fast",)
"""Flag for CasADi's C, which is faster with fused products and sums."""

_FORCES = f"stewart_{NAME}_forces"


def all_cases(poses: Poses, quick: bool, progress: Progress) -> list[Case]:
    """Build all cases; packages that are not installed are omitted.

    Raises CompilerError without a C compiler.
    """
    progress("compiling the kernels")
    truth = newton_euler.inverse_dynamics(poses.robot, poses.motion).F
    cases = [*_forces(poses, truth), *_compared(poses, truth)]
    progress("compiling the equations of motion")
    cases += _equations(poses.resized(_EQUATION_POSES))
    cases += [*_calls(poses.resized(FEW), truth), *_batches(poses, truth, quick)]
    progress("deriving the passes")
    return [*cases, *_passes(poses, truth)]


# --- forces -----------------------------------------------------------------------------------


def _operations(counts: str) -> int:
    return int(sum(getattr(kernel.module(NAME), counts)["friction"]["total"]))


def _forces(poses: Poses, truth: Array) -> Iterator[Case]:
    few, robot = poses.resized(FEW), poses.robot
    count = _operations("FORCE_OPERATIONS")
    function = getattr(c_kernel.library(f"{NAME}_forces"), _FORCES)
    model = ForceKernel(robot, NAME).model
    yield _one_pose(FORCES, "one pose", "C, F alone", function, model, few, 6, truth, operations=count)
    large = poses.resized(LARGE)
    yield _batch(FORCES, "batch, one core", large, truth, count)
    yield _batch(FORCES, f"batch, {CORES} cores", large, truth, count, threads=CORES)
    yield _batch(FORCES, "batch, float", large, truth, count, "float")
    yield _columns(large, truth, count)
    function = getattr(c_kernel.library(NAME), f"stewart_{NAME}_inverse_dynamics")
    every, what = _operations("OPERATIONS"), "C, D K H c x F"
    numbers = kernel.robot_numbers(robot)
    # The structure of all outputs has 78 numbers and begins with F.
    yield _one_pose(FORCES, "every output", what, function, numbers, few, 78, truth, operations=every)
    slow = poses.resized(SLOW)
    for name, backend, what, operations in (
        ("NumPy kernel", "numpy", "vectorized", every),
        ("vector reference", "reference", "NumPy, base frame", None),
    ):
        call = functools.partial(prepared_kernel(robot, NAME, backend).forces, slow.motion)
        found = functools.partial(_F_of, call)
        yield Case(FORCES, name, what, Task(repeated(call), SLOW), found, truth, operations)


def _F_of(call: Callable[[], Any]) -> Array:
    return np.asarray(call().F)


def _one_pose(
    group: str,
    name: str,
    what: str,
    function: Any,
    machine: NDArray[Any],
    poses: Poses,
    numbers: int,
    expected: Array,
    F: Array | None = None,
    **more: Any,
) -> Case:
    """Return the case of a C function for one pose, called from a loop in C, with input forces ``F``.

    ``numbers`` is the number of results of each pose, the first of which are compared.
    """
    out, columns = np.zeros((len(poses), numbers)), more.pop("all_columns", False)
    run = kernel_loop(function, machine, poses.rows, out, F, columns)
    compared = expected.shape[-1]
    return Case(group, name, what, Task(run, len(poses)), lambda: out[:, :compared], expected, **more)


def _batch(
    group: str,
    name: str,
    poses: Poses,
    truth: Array,
    operations: int | None = None,
    precision: Precision = "double",
    threads: int = 1,
) -> Case:
    """Return the case of ``ForceKernel.forces`` with given arrays."""
    prepared = ForceKernel(poses.robot, NAME, precision)
    arrays = [np.asarray(array, dtype=prepared.dtype) for array in poses.arrays]
    F, status = np.zeros((len(poses), 6), dtype=prepared.dtype), np.zeros(len(poses), dtype=np.int32)
    task = Task(repeated(lambda: prepared.forces(arrays, threads, out=(F, status))), len(poses))
    tolerance = AGREEMENT if precision == "double" else 1e-3
    return Case(group, name, "C, F alone", task, lambda: F, truth, operations, tolerance)


def _columns(poses: Poses, truth: Array, operations: int) -> Case:
    """Return the case of ``ForceKernel.forces_soa``, for poses stored in columns."""
    prepared = ForceKernel(poses.robot, NAME)
    arrays: list[Any] = [_in_columns(array.reshape(len(poses), -1).T) for array in poses.arrays]
    F, status = _in_columns(np.zeros((6, len(poses)))), np.zeros(len(poses), dtype=np.int32)
    task = Task(repeated(lambda: prepared.forces_soa(*arrays, out=(F, status))), len(poses))
    return Case(FORCES, "batch, columns", "C, F alone", task, lambda: F.T, truth, operations)


def _in_columns(array: Array) -> Array:
    """Copy an array so that rows begin at cache lines, at different offsets within pages."""
    width, count = array.shape
    stride = 8 * (-(-count // 8) | 1)
    room = np.zeros(width * stride + 7)
    first = -room.ctypes.data // 8 % 8
    rows = room[first : first + width * stride].reshape(width, stride)[:, :count]
    rows[...] = array
    return rows


def _compared(poses: Poses, truth: Array) -> Iterator[Case]:
    """Yield cases of other installed packages that compute forces."""
    few = poses.resized(FEW)
    if not absent("casadi"):
        from . import casadi_forces

        numbers = kernel.robot_numbers(few.robot)
        programs = ((CLOSED, "leg", casadi_forces.leg_frame), (PLAIN, "base", casadi_forces.base_frame))
        for name, frame, legs in programs:
            made = casadi_forces.program(legs)
            function = native.load("bench_casadi", made.sources, _FUSED).one_pose
            more: dict[str, Any] = {"operations": made.operations, "package": "CasADi"}
            yield _one_pose(FORCES, name, f"C, {frame} frame", function, numbers, few, 6, truth, **more)
    yield from inverse_engines(few, truth)


# --- equations of motion ----------------------------------------------------------------------


def _equations(poses: Poses) -> Iterator[Case]:
    """Yield cases of the equations of motion, for a robot of rigid bodies as MuJoCo requires."""
    robot, motion = robot_of_bodies(poses.robot), poses.motion
    few = Poses(robot, poses.arrays)
    F = np.ascontiguousarray(newton_euler.inverse_dynamics(robot, motion).F)
    acceleration = np.concatenate([few.arrays[5], few.arrays[4]], axis=-1)
    terms = equations.equations_of_motion(robot, motion, backend="reference")
    slopes = equations.force_derivatives(robot, motion, backend="numpy")
    linear = equations.linearize(robot, motion, F, backend="numpy")
    inertia = equations.joint_space_inertia(robot, motion, backend="reference")
    columns = _flat(regressor(robot, motion)[0])
    # The solve multiplies rounding errors by the condition number of M. Row: name, library, function, numbers
    # of a result, expected results, and further arguments.
    solved: Any = {"F": F, "tolerance": 1e-8}
    forces, motions = c_kernel.library(f"{NAME}_forces"), closed_form.library(NAME)
    of_columns = c_kernel.library(f"{NAME}_regressor")
    model, numbers = ForceKernel(robot, NAME).model, kernel.robot_numbers(robot)
    rows: tuple[tuple[str, Any, str, int, Array, dict[str, Any]], ...] = (
        (INVERSE, forces, "forces", 6, F, {}),
        ("bias", motions, "bias_and_friction", 6, terms.bias_and_friction, {}),
        ("equations", motions, "equations", 168, _numbers(terms), {}),
        (FORWARD, motions, "forward_dynamics", 6, acceleration, solved),
        ("joint-space inertia", motions, "joint_inertia", 36, _flat(inertia), {}),
        ("derivatives", motions, "derivatives", 114, _numbers(slopes), {}),
        ("linearization", motions, "linearization", 222, _numbers(linear), solved),
        ("regressor", of_columns, "regressor", columns.shape[-1], columns, {"all_columns": True}),
    )
    for name, library, function, size, expected, more in rows:
        what = f"stewart_{NAME}_{function}"
        compiled, machine = getattr(library, what), numbers if "all_columns" in more else model
        yield _one_pose(EQUATIONS, name, what, compiled, machine, few, size, expected, **more)
    yield from forward_engines(few, F, acceleration)


def _numbers(result: Any) -> Array:
    """Return all quantities of a result except the status."""
    return _flat(*(values for name, values in vars(result).items() if name != "status"))


def _flat(*parts: Array) -> Array:
    """Return the numbers of arrays of shape (n, ...) as rows, shape (n, k)."""
    return np.concatenate([part.reshape(len(part), -1) for part in parts], axis=-1)


# --- calls, batch sizes, and passes -----------------------------------------------------------


def _calls(poses: Poses, truth: Array) -> Iterator[Case]:
    """Yield calls of one pose from Python."""
    slot = ForceKernel(poses.robot, NAME).single_pose()
    slot.numbers[...] = poses.rows[0]
    yield Case(CALLS, "OnePose.solve()", "Python", Task(repeated(slot.solve), 1), lambda: slot.F[None], truth)
    given: list[tuple[Robot, Motion]] = [(poses.robot, poses.motion[i]) for i in range(len(poses))]
    task = Task(over(inverse_dynamics, given), len(poses))

    def called() -> Array:
        return np.array([inverse_dynamics(*each).F for each in given])

    yield Case(CALLS, "inverse_dynamics()", "Python", task, called, truth)


def _batches(poses: Poses, truth: Array, quick: bool) -> Iterator[Case]:
    for size in QUICK_BATCHES if quick else BATCHES:
        yield _batch(SIZES, f"{size:,} poses", poses.resized(size), truth)


def _passes(poses: Poses, truth: Array) -> Iterator[Case]:
    """Yield the kernel after every pass of the derivation, for one pose and for a batch."""
    from ...derive.passes import passes

    numbers, few = kernel.robot_numbers(poses.robot), poses.resized(FEW)
    for number, made in enumerate(passes(), 1):
        library = native.load(f"bench_pass_{number}", made.sources)
        model, pointer = np.zeros(made.model_numbers), c_kernel.address
        if getattr(library, f"stewart_{NAME}_prepare")(pointer(numbers), pointer(model)):
            raise ValueError(f"{made.name}: the constants of the robot cannot be prepared")
        function, name, what = getattr(library, _FORCES), f"{made.name}, one pose", made.meaning
        count = made.operations[1]
        yield _one_pose(PASSES, name, what, function, model, few, 6, truth, operations=count)
        task, F = _batch_of_pass(getattr(library, f"{_FORCES}_batch"), model, poses)
        yield Case(PASSES, f"{made.name}, batch", what, task, F, truth, count)


def _batch_of_pass(function: Any, model: Array, poses: Poses) -> tuple[Task, Callable[[], Array]]:
    """Return the task that calls a batch function in C, and the function that returns its forces."""
    F, status = np.zeros((len(poses), 6)), np.zeros(len(poses), dtype=np.int32)
    size, address, motions = ctypes.c_size_t(len(poses)), c_kernel.address, c_kernel.pointers(poses.arrays)

    def call() -> None:
        function(address(model), size, motions, address(F), address(status))

    return Task(repeated(call), len(poses)), lambda: F
