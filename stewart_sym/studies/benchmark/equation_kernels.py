"""Second group of ``benchmark``: equations of motion, one pose per call, and baselines of forward dynamics.

All candidates use the same machine with inertia tensors of rigid bodies, because MuJoCo rejects other
tensors.
"""

import ctypes
import dataclasses
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ...backend import c_kernel, native
from ...backend.kernel import robot_numbers
from ...dynamics import forces
from ...dynamics.equations import joint_space_inertia
from ...exchange.model_from_robot import robot_of_bodies
from ...io.array_types import Array
from ...io.extras import absent
from ...kinematics.inverse_kinematics import wrench_matrix, wrench_matrix_rate
from ...motion.motion import Motion
from ...motion.rotation import cross_matrix, rotation_from_vector
from ...reference import newton_euler
from ...reference.equations_of_motion import equations_of_motion, regressor
from ...robot.robot import Robot
from ..common.loops import loops
from ..common.output import Figures
from .baselines import AGREEMENT, SLOW, Called, c_batch, c_loop, difference
from .engines.tree import Tree, tree
from .figures import (
    DERIVATIVES,
    EQUATIONS,
    FORWARD,
    INVERSE,
    MOST,
    NAME,
    REGRESSOR,
    TIMES_FASTER,
    Raw,
    Timed,
    batched,
    build_of,
    quickest,
)
from .poses import Poses
from .processor import Flags, Target, widest

POSES = 16
"""Number of poses of every loop, so that all outputs except the largest, the regressor, remain in the first
cache.
"""

DIFFERENCES = 1e-6
"""Largest relative difference of derivatives from finite differences of the reference."""

SOLVED = 1e-8
"""Largest relative difference of our accelerations; the solve multiplies rounding errors by the condition
number of M.
"""


def _model(robot: Robot) -> Array:
    return forces.ForceKernel(robot, NAME).model


@dataclass(frozen=True, eq=False)
class Function:
    """Function of the generated C for one pose and, with the suffix ``_batch``, for many.

    Attributes
    ----------
    expected : callable
        Function of robot, motion, and actuator forces that returns the parts of the result in their order,
        shape (n, ...).
    before : tuple of str
        Arguments between motion and output; ``F`` are the six forces.
    struct : str or None
        Type of the output, if it is not an array.
    machine : callable
        Function that returns the constants of a robot as the C function takes them.
    """

    name: str
    function: str
    expected: Callable[[Robot, Motion, Array], Sequence[Array]]
    tolerance: float = AGREEMENT
    before: tuple[str, ...] = ()
    struct: str | None = None
    machine: Callable[[Robot], Array] = _model

    @property
    def arguments(self) -> str:
        """C arguments after machine and motion for one pose; ``out`` receives the results."""
        return ", ".join((*self.before, "out" if self.struct is None else f"({self.struct} *)out"))


# --- expected results of the reference -------------------------------------------------------


def _expected_equations(robot: Robot, motion: Motion, F: Array) -> Sequence[Array]:
    found = equations_of_motion(robot, motion)
    H, H_dot = wrench_matrix(robot, motion), wrench_matrix_rate(robot, motion)
    return found.M, found.C, found.g, found.friction, found.bias, found.bias_and_friction, H, H_dot


def _expected_derivatives(robot: Robot, motion: Motion, F: Array) -> tuple[Array, ...]:
    """Compute F and its derivatives, (n, 6, 6), by fourth-order finite differences."""
    step = 1e-4 * float(np.abs(robot.b).max())
    steps = step * np.repeat([1.0, 1.0 / float(np.abs(robot.p).max())], 3)

    def difference(moved: Callable[[Motion, Array], Motion]) -> Array:
        columns = []
        for direction in steps * np.eye(6):
            near, far = (
                newton_euler.inverse_dynamics(robot, moved(motion, n * direction)).F
                - newton_euler.inverse_dynamics(robot, moved(motion, -n * direction)).F
                for n in (1, 2)
            )
            columns.append((8 * near - far) / (12 * np.linalg.norm(direction)))
        return np.stack(columns, axis=-1)

    moves = (_other_pose, _other_rates("v", "omega"), _other_rates("a", "alpha"))
    return F, *map(difference, moves)


def _other_pose(motion: Motion, by: Array) -> Motion:
    return dataclasses.replace(motion, t=motion.t + by[:3], R=rotation_from_vector(by[3:]) @ motion.R)


def _other_rates(linear: str, angular: str) -> Callable[[Motion, Array], Motion]:
    def moved(motion: Motion, by: Array) -> Motion:
        parts = ((linear, by[:3]), (angular, by[3:]))
        return dataclasses.replace(motion, **{name: getattr(motion, name) + part for name, part in parts})

    return moved


def _expected_linearization(robot: Robot, motion: Motion, F: Array) -> Sequence[Array]:
    """Compute acceleration, A, and B; dF is zero, and [dphi] rotates with the platform."""
    _, by_pose, by_twist, by_acceleration = _expected_derivatives(robot, motion, F)
    inverse = np.linalg.inv(by_acceleration)
    A, B = np.zeros((*F.shape[:-1], 12, 12)), np.zeros((*F.shape[:-1], 12, 6))
    A[..., 3:6, 3:6], A[..., :6, 6:] = cross_matrix(motion.omega), np.eye(6)
    A[..., 6:, :6], A[..., 6:, 6:] = -inverse @ by_pose, -inverse @ by_twist
    B[..., 6:, :] = inverse
    return acceleration(motion), A, B


def acceleration(motion: Motion) -> Array:
    """Return [a; alpha], shape (n, 6)."""
    assert motion.a is not None
    assert motion.alpha is not None
    return np.concatenate([motion.a, motion.alpha], axis=-1)


FUNCTIONS = (
    Function(INVERSE, "forces", lambda robot, motion, F: (F,)),
    Function(
        "bias",
        "bias_and_friction",
        lambda robot, motion, F: (equations_of_motion(robot, motion).bias_and_friction,),
    ),
    Function(EQUATIONS, "equations", _expected_equations, struct="stewart_equations"),
    Function(
        FORWARD, "forward_dynamics", lambda robot, motion, F: (acceleration(motion),), SOLVED, before=("F",)
    ),
    Function(
        "joint-space inertia",
        "joint_inertia",
        lambda robot, motion, F: (joint_space_inertia(robot, motion, backend="reference"),),
    ),
    Function(DERIVATIVES, "derivatives", _expected_derivatives, DIFFERENCES, struct="stewart_derivatives"),
    Function(
        "linearization",
        "linearization",
        _expected_linearization,
        DIFFERENCES,
        before=("F",),
        struct="stewart_linearization",
    ),
    Function(
        REGRESSOR,
        "regressor",
        lambda robot, motion, F: (regressor(robot, motion)[0],),
        before=("0", "0"),
        machine=robot_numbers,
    ),
)
"""Functions of the generated C; every ratio is relative to the first."""


# --- the C ------------------------------------------------------------------------------------


def library(flags: Flags = ()) -> ctypes.CDLL:
    """Compile the functions, and the loop ``drive_<function>`` of each over poses; raise CompilerError.

    ``flags`` follow the common compiler flags.
    """
    calls = {
        f"drive_{each.function}": f"stewart_{NAME}_{each.function}(machine, motion, {each.arguments})"
        for each in FUNCTIONS
    }
    before = f'#include "stewart_{NAME}_motion.h"\n#include "stewart_{NAME}_regressor.h"\n'
    sources = {
        **c_kernel.c_sources(f"{NAME}_forces"),
        **c_kernel.c_sources(f"{NAME}_motion"),
        **c_kernel.c_sources(f"{NAME}_regressor"),
        **loops(before, calls),
    }
    return native.load("bench_motion", sources, flags)


# --- the group --------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class MotionGroup:
    """Candidates of the group, built and compared.

    Attributes
    ----------
    robot : Robot
        Robot with tensors of rigid bodies.
    built : tuple of Timed
        Generated functions, for one pose and for many, for all targets.
    engines : tuple of Called
        Baselines.
    differences : mapping of str to float
        Largest relative difference by candidate.
    """

    robot: Robot
    built: tuple[Timed, ...]
    engines: tuple[Called, ...]
    differences: Mapping[str, float]

    @property
    def tasks(self) -> tuple[Timed, ...]:
        """Timed tasks."""
        return (*self.built, *(part for engine in self.engines for part in engine.parts))

    def figures(self, raw: Raw) -> Figures:
        """Return the data of one pose for the first target, with ratios to the first function and with
        targets.
        """
        first = self.built[0].build["instructions"]
        ours = [
            each.figure(raw)
            for each in self.built
            if (each.kind, each.build["instructions"]) == ("one pose", first)
        ]
        summed = [engine.figures(raw) for engine in self.engines]
        baselines = [net for net, _ in summed]
        inverse, better = ours[0]["median"], quickest(baselines)
        (forward,) = (each["median"] for each in ours if each["name"] == FORWARD)

        def entry(figure: Figures, **more: float) -> Figures:
            targets = dict(zip(("target", "goal"), MOST.get(figure["name"], ()), strict=False))
            return {**figure, "ratio_to_inverse_dynamics": figure["median"] / inverse, **targets, **more}

        compared: Figures = {}
        if better is not None:
            compared = {"better_baseline": better["name"], "times_faster": better["median"] / forward}
        opened = [each.opened for each in self.engines if each.opened is not None]
        return {
            "unit": "ns/pose",
            "robot": self.robot.name,
            "inertia_tensors": "near the given ones, such as bodies can have",
            "ratio_to": ours[0]["name"],
            "ours": [entry(each) for each in ours],
            "baselines": [
                entry(each, ratio_to_forward_dynamics=each["median"] / forward) for each in baselines
            ],
            "calls": [call for _, (call, _) in summed],
            "empty_calls": [empty for _, (_, empty) in summed],
            **compared,
            "target_times_faster": TIMES_FASTER,
            **({"loops_open_m": opened[0]} if opened else {}),
            "largest_difference": dict(self.differences),
        }


def motion_group(poses: Poses, targets: Sequence[Target]) -> MotionGroup:
    """Build the group with the installed engines for the first poses, for a robot with tensors of rigid
    bodies.

    Base joints must be universal. Raises ValueError if a result is wrong, and CompilerError without a C
    compiler.
    """
    robot = robot_of_bodies(poses.robot)
    few = Poses(robot, poses.resized(POSES).arrays)
    motion, F = few.motion, np.ascontiguousarray(newton_euler.inverse_dynamics(robot, few.motion).F)
    expected = {each.name: each.expected(robot, motion, F) for each in FUNCTIONS}
    built: list[Timed] = []
    differences: dict[str, float] = {}
    for target in targets:
        drives = library(target.flags)
        for each in FUNCTIONS:
            called, parts = f"stewart_{NAME}_{each.function}", expected[each.name]
            machine, counts = each.machine(robot), [int(part[0].size) for part in parts]
            one = c_loop(drives, machine, few, sum(counts), F, f"_{each.function}")
            before = [np.resize(F, (SLOW, 6)) if word == "F" else None for word in each.before]
            found = [np.zeros((SLOW, numbers)) for numbers in counts]
            out = found[0] if each.struct is None else found
            many = c_batch(getattr(drives, f"{called}_batch"), machine, few.resized(SLOW), out, before)
            for name, what, kind, count, runner, measured in (
                (each.name, called, "one pose", POSES, one, f"drive_{each.function}"),
                (batched(each.name), f"{called}_batch", "batch", SLOW, many, f"{called}_batch"),
            ):
                runner.run(1)
                off = difference(name, runner.F()[:POSES], parts, each.tolerance, "numbers")
                differences[name] = max(off, differences.get(name, 0.0))
                build = build_of(target.name, target.flags, widest(drives, measured))
                built.append(Timed(runner.run, count, name, what, kind, build=build))
    baselines = engines(robot, tree(robot, motion, F))
    for engine in baselines:
        truth = [acceleration(motion)]
        differences[engine.name] = difference(engine.name, engine.found(), truth, engine.tolerance, "numbers")
    return MotionGroup(robot, tuple(built), baselines, differences)


def engines(robot: Robot, tree: Tree) -> tuple[Called, ...]:
    """Build the installed engines among Pinocchio and MuJoCo for the poses of the tree.

    Each engine closes five loops by constraints and is called from Python, one pose per call, with a prepared
    state. A call for a model without bodies measures the overhead of the call.
    """
    found = []
    if not absent("pinocchio"):
        from .engines.pinocchio import pinocchio_engine

        found.append(pinocchio_engine(robot, tree))
    if not absent("mujoco"):
        from .engines.mujoco_constraints import mujoco_engine

        found.append(mujoco_engine(robot, tree))
    return tuple(found)
