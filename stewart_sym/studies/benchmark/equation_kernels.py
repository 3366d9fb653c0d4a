"""The second group of ``bench``: equations of motion, one pose a call, and the baselines of forward dynamics.

All of the group share one machine, whose inertia tensors are those of bodies: MuJoCo takes no others.
"""

import ctypes
import dataclasses
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...backend import c_kernel, native
from ...backend.c_kernel import address
from ...backend.kernel import robot_numbers
from ...dynamics import forces
from ...dynamics.equations import joint_space_inertia
from ...kinematics.inverse import wrench_matrix, wrench_matrix_rate
from ...motion.motion import Motion
from ...motion.rotation import cross_matrix, rotation_from_vector
from ...reference import newton_euler
from ...reference.equations_of_motion import equations_of_motion
from ...reference.regressor import regressor
from ...robot.robot import Robot
from ..common.loops import own_source
from .baselines import AGREEMENT, NAME, Poses, Runner, succeed
from .baselines_constraints import engines
from .baselines_tree import Engine, tensors_of_bodies, tree
from .figures import DERIVATIVES, FORWARD, Figure, MotionFigures

Array = NDArray[np.float64]
Run = Callable[[int], object]

POSES = 16
"""Poses of every loop; few, so that all outputs but the largest, the regressor, stay in the first cache."""

DIFFERENCES = 1e-6
"""Largest difference of derivatives from differences of the reference, share of a pose's largest."""

SOLVED = 1e-8
"""Largest difference of our accelerations; the solve multiplies rounding by the condition of M."""


def _model(robot: Robot) -> Array:
    return forces.prepare(robot, NAME).model


@dataclass(frozen=True, eq=False)
class Function:
    """One function of the generated C.

    arguments: after the machine and the motion, where ``F`` holds six forces and ``out`` takes the numbers.
    expected: the parts of those numbers in their order, (n, ...) each, from robot, motion, actuator forces.
    machine: its numbers as the function takes them.
    """

    name: str
    function: str
    arguments: str
    expected: Callable[[Robot, Motion, Array], Sequence[Array]]
    tolerance: float = AGREEMENT
    machine: Callable[[Robot], Array] = _model


# --- what the reference says ------------------------------------------------------------------


def _expected_equations(robot: Robot, motion: Motion, F: Array) -> Sequence[Array]:
    found = equations_of_motion(robot, motion)
    wrenches = np.concatenate([found.g, found.friction, found.bias], axis=-1)
    return found.M, found.C, wrenches, wrench_matrix(robot, motion), wrench_matrix_rate(robot, motion)


def _expected_derivatives(robot: Robot, motion: Motion, F: Array) -> tuple[Array, ...]:
    """F, and its derivatives by pose, twist and acceleration, (n, 6, 6), from differences of fourth order."""
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

    return F, difference(_other_pose), difference(_other_twist), difference(_other_acceleration)


def _other_pose(motion: Motion, by: Array) -> Motion:
    return dataclasses.replace(motion, t=motion.t + by[:3], R=rotation_from_vector(by[3:]) @ motion.R)


def _other_twist(motion: Motion, by: Array) -> Motion:
    return dataclasses.replace(motion, v=motion.v + by[:3], omega=motion.omega + by[3:])


def _other_acceleration(motion: Motion, by: Array) -> Motion:
    assert motion.a is not None
    assert motion.alpha is not None
    return dataclasses.replace(motion, a=motion.a + by[:3], alpha=motion.alpha + by[3:])


def _expected_linearisation(robot: Robot, motion: Motion, F: Array) -> Sequence[Array]:
    """Acceleration, A and B: at constant forces dF is zero, and [dphi] turns with the platform."""
    _, by_pose, by_twist, by_acceleration = _expected_derivatives(robot, motion, F)
    inverse = np.linalg.inv(by_acceleration)
    A, B = np.zeros((*F.shape[:-1], 12, 12)), np.zeros((*F.shape[:-1], 12, 6))
    A[..., 3:6, 3:6], A[..., :6, 6:] = cross_matrix(motion.omega), np.eye(6)
    A[..., 6:, :6], A[..., 6:, 6:] = -inverse @ by_pose, -inverse @ by_twist
    B[..., 6:, :] = inverse
    return acceleration(motion), A, B


def acceleration(motion: Motion) -> Array:
    """[a; alpha], (n, 6)."""
    assert motion.a is not None
    assert motion.alpha is not None
    return np.concatenate([motion.a, motion.alpha], axis=-1)


FUNCTIONS = (
    Function("inverse dynamics", "forces", "out", lambda robot, motion, F: (F,)),
    Function(
        "bias", "bias", "out", lambda robot, motion, F: (_expected_equations(robot, motion, F)[2][..., 12:],)
    ),
    Function("equations", "equations", "(stewart_equations *)out", _expected_equations),
    Function(FORWARD, "forward_dynamics", "F, out", lambda robot, motion, F: (acceleration(motion),), SOLVED),
    Function(
        "joint-space inertia",
        "joint_inertia",
        "out",
        lambda robot, motion, F: (joint_space_inertia(robot, motion, backend="reference"),),
    ),
    Function(DERIVATIVES, "derivatives", "(stewart_derivatives *)out", _expected_derivatives, DIFFERENCES),
    Function(
        "linearisation",
        "linearisation",
        "F, (stewart_linearisation *)out",
        _expected_linearisation,
        DIFFERENCES,
    ),
    Function(
        "regressor",
        "regressor",
        "0, 0, out",
        lambda robot, motion, F: (regressor(robot, motion)[0],),
        machine=robot_numbers,
    ),
)
"""Ours; every ratio is to the first."""


# --- the C ------------------------------------------------------------------------------------


def library() -> ctypes.CDLL:
    """The functions, and ``drive_<function>`` for each: the loop over poses. Raises CompilerError."""
    loops = "".join(
        f"#define DRIVE drive_{each.function}\n#define CALL(motion, F, out) "
        f'stewart_{NAME}_{each.function}(machine, motion, {each.arguments})\n#include "loop_of_outputs.h"\n'
        for each in FUNCTIONS
    )
    sources = {
        **c_kernel.c_sources(f"{NAME}_forces"),
        **c_kernel.c_sources(f"{NAME}_motion"),
        **c_kernel.c_sources(f"{NAME}_regressor"),
        "loop_of_outputs.h": own_source("loop_of_outputs.h"),
        "drive.c": f'#include "stewart_{NAME}_motion.h"\n#include "stewart_{NAME}_regressor.h"\n{loops}',
    }
    return native.load("bench_motion", sources)


# --- the group --------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class MotionGroup:
    """Everybody of the group, built and compared.

    tasks: what is to be timed, a run and its poses, by the names that ``figures`` reads. differences: by
    candidate, share of a pose's largest.
    """

    robot: Robot
    tasks: Mapping[str, tuple[Run, int]]
    engines: tuple[Engine, ...]
    differences: Mapping[str, float]

    def figures(self, raw: Mapping[str, tuple[float, ...]]) -> MotionFigures:
        """The group's figures from ns per pose of every task."""
        ours, calls, empty, baselines = [], [], [], []
        for each in FUNCTIONS:
            what = f"stewart_{NAME}_{each.function}"
            ours.append(Figure(each.name, what, "one pose", POSES, raw[_task(each.name)]))
        for engine in self.engines:
            call, nothing = raw[_task(engine.name)], raw[_task(engine.name, _EMPTY)]
            net = tuple(one - none for one, none in zip(call, nothing, strict=True))
            calls.append(Figure(engine.name, engine.what, "call", 1, call))
            empty.append(Figure(engine.name, "call over a model without bodies", "call", 1, nothing))
            baselines.append(Figure(engine.name, f"{engine.what} - call", "call", 1, net))
        return MotionFigures(
            robot=self.robot.name,
            ours=tuple(ours),
            baselines=tuple(baselines),
            calls=tuple(calls),
            empty=tuple(empty),
            opened=next((engine.opened for engine in self.engines if engine.opened is not None), None),
            differences=self.differences,
        )


def motion_group(poses: Poses) -> MotionGroup:
    """Build the group, with the engines installed, for the first poses; their machine has tensors of bodies.

    Base joints must be universal. Raises ValueError if somebody's answer is wrong, CompilerError without a C
    compiler.
    """
    robot = robot_of_bodies(poses.robot)
    few = Poses(robot, poses.resized(POSES).arrays)
    motion, F = few.motion, np.ascontiguousarray(newton_euler.inverse_dynamics(robot, few.motion).F)
    drives, tasks, differences = library(), {}, {}
    for each in FUNCTIONS:
        parts = each.expected(robot, motion, F)
        drive = getattr(drives, f"drive_{each.function}")
        runner = _loop(drive, each.machine(robot), few, F, sum(map(_numbers, parts)))
        runner.run(1)
        differences[each.name] = _difference(each.name, runner.F(), parts, each.tolerance)
        tasks[_task(each.name)] = (runner.run, POSES)
    baselines = engines(robot, tree(robot, motion, F))
    for baseline in baselines:
        found = baseline.accelerations()
        differences[baseline.name] = _difference(
            baseline.name, found, [acceleration(motion)], baseline.tolerance
        )
        tasks[_task(baseline.name)], tasks[_task(baseline.name, _EMPTY)] = (
            (baseline.run, POSES),
            (baseline.empty, POSES),
        )
    return MotionGroup(robot, tasks, baselines, differences)


def robot_of_bodies(robot: Robot) -> Robot:
    """The robot with tensors near its own that bodies can have."""
    platform, lower, upper = map(tensors_of_bodies, (robot.I_p, robot.I_d0, robot.I_u0))
    return dataclasses.replace(robot, I_p=platform, I_d0=lower, I_u0=upper)


_EMPTY = ", nothing"
"""Ends the names of tasks that call over models without bodies."""


def _task(name: str, kind: str = "") -> str:
    """Name of a task, different from all of the first group."""
    return f"motion, {name}{kind}"


def _loop(drive: Any, machine: Array, poses: Poses, F: Array, numbers: int) -> Runner:
    """A loop over the poses in C; ``numbers`` come out of each."""
    rows, out = poses.rows, np.zeros((len(poses), numbers))
    count, width = ctypes.c_size_t(len(poses)), ctypes.c_size_t(numbers)

    def run(repeats: int) -> None:
        given = (address(machine), count, ctypes.c_size_t(repeats), address(rows), address(F))
        succeed(drive(*given, width, address(out)))

    return Runner(run, lambda: out)


def _numbers(part: Array) -> int:
    return int(part[0].size)


def _difference(name: str, found: Array, parts: Sequence[Array], tolerance: float) -> float:
    """Largest difference of the parts, each as a share of a pose's largest; ValueError if it is too large."""
    ends = np.cumsum([_numbers(part) for part in parts])
    worst = 0.0
    for numbers, part in zip(np.split(found, ends[:-1], axis=-1), parts, strict=True):
        truth = part.reshape(len(part), -1)
        error, largest = np.abs(numbers - truth).max(axis=-1), np.abs(truth).max(axis=-1)
        worst = max(worst, float(np.max(error / np.where(largest > 0, largest, 1.0))))
    if not worst <= tolerance:
        raise ValueError(
            f"{name}: numbers differ from the reference's by {worst:.1e}, expected {tolerance:g}"
        )
    return worst
