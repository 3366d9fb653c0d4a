"""Cases that ``benchmark`` times: our kernels, the vector reference, CasADi, Pinocchio, and MuJoCo."""

import ctypes
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ...backend import c_kernel, kernel, native
from ...dynamics import closed_form, equations
from ...dynamics.forces import CORES, ForceKernel
from ...dynamics.inverse_dynamics import Formulation, inverse_dynamics, prepared_kernel
from ...exchange.model_from_robot import robot_of_bodies
from ...io.array_types import Array
from ...io.extras import absent
from ...io.progress import Progress
from ...reference import newton_euler
from ...reference.equations_of_motion import regressor
from ..common.timing import Task, Timed, batch, loop, over
from .case import AGREEMENT, CALLS, EQUATIONS, FORCES, PASSES, SIZES, Case, Poses
from .engines import forward_engines, inverse_engines

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

_ALONE = "C, F alone"


def all_cases(poses: Poses, quick: bool, progress: Progress) -> list[Case]:
    """Build all cases; packages that are not installed are omitted."""
    progress("compiling the kernels")
    truth = newton_euler.inverse_dynamics(poses.robot, poses.motion).F
    cases = [*_forces(poses, truth), *_compared(poses.resized(FEW), truth)]
    progress("compiling the equations of motion")
    cases += [*_equations(poses.resized(_EQUATION_POSES)), *_calls(poses.resized(FEW), truth)]
    for size in QUICK_BATCHES if quick else BATCHES:
        timed = batch(poses.resized(size).arrays, ForceKernel(poses.robot, NAME))
        cases.append(Case(SIZES, f"{size:,} poses", _ALONE, *timed, truth))
    progress("deriving the passes")
    return [*cases, *_passes(poses, truth)]


# --- forces -----------------------------------------------------------------------------------


def _forces(poses: Poses, truth: Array) -> Iterator[Case]:
    robot, few, slow, large = poses.robot, *(poses.resized(count) for count in (FEW, SLOW, LARGE))
    module = kernel.module(NAME)
    counts = module.FORCE_OPERATIONS, module.OPERATIONS
    alone, every = (int(sum(each["friction"]["total"])) for each in counts)
    function = getattr(c_kernel.library(f"{NAME}_forces"), f"stewart_{NAME}_forces")
    outputs = getattr(c_kernel.library(NAME), f"stewart_{NAME}_inverse_dynamics")
    prepared = ForceKernel(robot, NAME)
    calls = {name: prepared_kernel(robot, NAME, name).forces for name in ("numpy", "reference")}
    # The structure of all outputs has 78 numbers and begins with F.
    rows: tuple[tuple[str, str, Timed, int | None], ...] = (
        ("one pose", _ALONE, loop(few.rows, function, prepared.model), alone),
        ("batch, one core", _ALONE, batch(large.arrays, prepared), alone),
        (f"batch, {CORES} cores", _ALONE, batch(large.arrays, prepared, CORES), alone),
        ("batch, float", _ALONE, batch(large.arrays, ForceKernel(robot, NAME, "float")), alone),
        ("batch, columns", _ALONE, _columns(large), alone),
        ("every output", "C, D K H c x F", loop(few.rows, outputs, kernel.robot_numbers(robot), 78), every),
        ("NumPy kernel", "vectorized", _whole(calls["numpy"], slow), every),
        ("vector reference", "NumPy, base frame", _whole(calls["reference"], slow), None),
    )
    for name, what, timed, operations in rows:
        tolerance = 1e-3 if "float" in name else AGREEMENT
        yield Case(FORCES, name, what, *timed, truth, operations, tolerance)


def _columns(poses: Poses) -> Timed:
    """Time ``ForceKernel.forces_soa``, for poses stored in columns."""
    prepared = ForceKernel(poses.robot, NAME)
    arrays: list[Any] = [_in_columns(array.reshape(len(poses), -1).T) for array in poses.arrays]
    F, status = _in_columns(np.zeros((6, len(poses)))), np.zeros(len(poses), dtype=np.int32)
    run = over(lambda: prepared.forces_soa(*arrays, out=(F, status)))
    return Task(run, len(poses)), lambda: F.T


def _in_columns(array: Array) -> Array:
    """Copy an array so that rows begin at cache lines, at different offsets within pages."""
    width, count = array.shape
    stride = 8 * (-(-count // 8) | 1)
    room = np.zeros(width * stride + 7)
    first = -room.ctypes.data // 8 % 8
    rows = room[first : first + width * stride].reshape(width, stride)[:, :count]
    rows[...] = array
    return rows


def _whole(forces: Callable[..., Any], poses: Poses) -> Timed:
    """Time a function that computes the forces of a motion."""
    run = over(lambda: forces(poses.motion))
    return Task(run, len(poses)), lambda: np.asarray(forces(poses.motion).F)


def _compared(few: Poses, truth: Array) -> Iterator[Case]:
    """Yield cases of other installed packages that compute forces."""
    if not absent("casadi"):
        from . import casadi_forces

        numbers = kernel.robot_numbers(few.robot)
        programs = ((CLOSED, "leg", casadi_forces.leg_frame), (PLAIN, "base", casadi_forces.base_frame))
        for name, frame, legs in programs:
            sources, count = casadi_forces.program(legs)
            timed = loop(few.rows, native.load("bench_casadi", sources, _FUSED).one_pose, numbers)
            yield Case(FORCES, name, f"C, {frame} frame", *timed, truth, count, package="CasADi")
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
    model = ForceKernel(robot, NAME).model
    columns = _flat(regressor(robot, motion)[0])
    # The solve multiplies rounding errors by the condition number of M. Row: name, library, function, numbers
    # of a result, expected results, and input forces.
    forces, motions = c_kernel.library(f"{NAME}_forces"), closed_form.library(NAME)
    rows: tuple[tuple[str, Any, str, int, Array, Array | None], ...] = (
        (INVERSE, forces, "forces", 6, F, None),
        ("bias", motions, "bias_and_friction", 6, terms.bias_and_friction, None),
        ("equations", motions, "equations", 168, _numbers(terms), None),
        (FORWARD, motions, "forward_dynamics", 6, acceleration, F),
        ("joint-space inertia", motions, "joint_inertia", 36, _flat(inertia), None),
        ("derivatives", motions, "derivatives", 114, _numbers(slopes), None),
        ("linearization", motions, "linearization", 222, _numbers(linear), F),
    )
    for name, library, function, width, expected, given in rows:
        what, tolerance = f"stewart_{NAME}_{function}", AGREEMENT if given is None else 1e-8
        timed = loop(few.rows, getattr(library, what), model, width, given)
        yield Case(EQUATIONS, name, what, *timed, expected, tolerance=tolerance)
    what = f"stewart_{NAME}_regressor"
    compiled = getattr(c_kernel.library(f"{NAME}_regressor"), what)
    timed = loop(few.rows, compiled, kernel.robot_numbers(robot), columns.shape[1], all_columns=True)
    yield Case(EQUATIONS, "regressor", what, *timed, columns)
    yield from forward_engines(few, F, acceleration)


def _numbers(result: Any) -> Array:
    """Return all quantities of a result except the status."""
    return _flat(*(values for name, values in vars(result).items() if name != "status"))


def _flat(*parts: Array) -> Array:
    """Return the numbers of arrays of shape (n, ...) as rows, shape (n, k)."""
    return np.concatenate([part.reshape(len(part), -1) for part in parts], axis=-1)


# --- calls and passes -------------------------------------------------------------------------


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


def _passes(poses: Poses, truth: Array) -> Iterator[Case]:
    """Yield the kernel after every pass of the derivation, for one pose and for a batch."""
    from ...derive.passes import passes

    numbers, few, address = kernel.robot_numbers(poses.robot), poses.resized(FEW), c_kernel.address
    for number, made in enumerate(passes(), 1):
        library = native.load(f"bench_pass_{number}", made.sources)
        one, batch, prepare = (
            getattr(library, f"stewart_{NAME}_{name}") for name in ("forces", "forces_batch", "prepare")
        )
        model = np.zeros(made.model_numbers)
        if prepare(address(numbers), address(model)):
            raise ValueError(f"{made.name}: the constants of the robot cannot be prepared")
        for kind, timed in (
            ("one pose", loop(few.rows, one, model)),
            ("batch", _c_batch(batch, model, poses)),
        ):
            yield Case(PASSES, f"{made.name}, {kind}", made.meaning, *timed, truth, made.operations[1])


def _c_batch(function: Any, model: Array, poses: Poses) -> Timed:
    """Time a batch function in C."""
    F, status = np.zeros((len(poses), 6)), np.zeros(len(poses), dtype=np.int32)
    size, motions, address = ctypes.c_size_t(len(poses)), c_kernel.pointers(poses.arrays), c_kernel.address
    # The addresses are computed in each call, because a pointer does not keep its array alive.
    run = over(lambda: function(address(model), size, motions, address(F), address(status)))
    return Task(run, len(poses)), lambda: F
