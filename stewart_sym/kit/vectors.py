"""Test vectors: inputs of a kit's functions, the right answers, and how far from them rounding may lead.

Takes a checked Robot, chooses ``poses``, computes the answers at 50 digits (``interpreter``), and hands out
inputs, answers and bounds as plain arrays.

A bound holds for any sound build: other orders of sums, other pivots, fused multiply-add, legs one after
the other or side by side. It is MARGIN times the bound that running error analysis finds in the interpreter,
whose operations are those of the C up to their grouping.
"""

import math
from dataclasses import replace
from functools import lru_cache, partial

import numpy as np

from ..backend import fidelity as fidelities
from ..backend.kernel import MOTION, need_representable
from ..derive.kernel.outputs import FORCED
from ..derive.package.functions import Vector
from ..drives.friction import drive_numbers
from ..dynamics.sample_poses import neighbor, poses, rounded, significant
from ..io.array_types import Array
from ..kinematics.conditioning import characteristic_length, moments_over
from ..kinematics.forward_kinematics import forward_kinematics
from ..kinematics.inverse_kinematics import wrench_matrix
from ..motion.motion import Motion
from ..motion.rotation import orthonormal
from ..results import JOINT_SINGULAR, SINGULAR, ZERO_LENGTH
from ..robot.robot import LEGS, Robot, of_symbol
from .interpreter import Found, KitInterpreter, Numbers
from .kit_options import PRECISIONS, STEMS
from .parts import fields as fields_of
from .running import FORCES_MARGIN, MARGIN, errors, values
from .selection import Numbered, selection

KINEMATICS = STEMS["kinematics"]
CLOSED_FORM = (*STEMS["motion"], *STEMS["derivatives"])
ROTATION = ("motion_from_rpy", "motion_from_quaternion")
FUNCTIONS = (*(stem for stems in STEMS.values() for stem in stems), *ROTATION)
"""Functions that there are vectors for."""

FEW = 3
"""Poses of the functions with many answers."""

_BACKWARD = ("forward_kinematics", "forward_velocity")
_LARGE = ("equations", "joint_inertia", "derivatives", "linearization", *ROTATION)
# How near a guess is to its pose, from far to near; what counts as the same pose, rad and m over a length.
_CLOSENESS = (1, 4, 16, 64)
_SAME = 1e-3
# Sides of right-angled triangles over their longest; a quaternion of length other than one.
_SINES, _COSINES = (3 / 5, -5 / 13, 15 / 17), (4 / 5, 12 / 13, -8 / 17)
_QUATERNION = (1.5, 0.25, -0.5, 0.75)


def vectors(
    robot: Robot,
    functions: tuple[str, ...],
    formulation: str = "exact",
    fidelity: str | None = None,
    precision: str = "double",
    count: int = 8,
    baked: bool = False,
) -> tuple[Vector, ...]:
    """Vectors of each function in turn, up to ``count`` of each, at most FEW of those with many answers.

    "forces" have further ones on which a wrong constant shows, some with a leg near the joint singularity of
    its universal joint (``selection``).

    fidelity: of "forces", None for "general"; all others have everything. precision: "double" or "float";
    inputs and the robot's constants are rounded to it before anything is computed. baked: the constants are
    folded into the code, so they are the robot's own, rounded last. Forward kinematics is tested only where
    lengths settle the pose in that precision, which may be nowhere in "float".

    Arguments are those of a checked ``Choice``. Raises ValueError for a robot without a good pose.
    """
    level = fidelities.resolved(robot, formulation, fidelity or "general")
    need_representable(robot, precision)
    return _made(Numbered.of(robot), functions, formulation, level, precision, count, baked)


@lru_cache(maxsize=64)
def _made(
    numbered: Numbered,
    functions: tuple[str, ...],
    formulation: str,
    level: str,
    precision: str,
    count: int,
    baked: bool,
) -> tuple[Vector, ...]:
    robot, kind = numbered.robot, PRECISIONS[precision]
    constants = {
        name: np.asarray(of_symbol(robot, name), dtype=np.float64) for name in fields_of(robot.has_rotors)
    }
    if not baked:
        constants = {name: rounded(value, kind) for name, value in constants.items()}
    drives = {} if robot.drive is None else drive_numbers(robot.drive)
    drives = {name: rounded(value, kind) for name, value in drives.items()}
    interpreter = KitInterpreter(constants, robot.base_joint, formulation, level, baked, drives)
    every = poses(robot, formulation, count)
    ordinary = [_input(robot, every[i], kind) for i in range(every.shape[0])]
    made = partial(_vector, interpreter, robot, kind)
    found: list[Vector] = []
    for function in functions:
        motions = ordinary[:FEW] if function in _LARGE else ordinary
        found += [
            made(function, at) for at in motions if function not in _BACKWARD or _settled(robot, at, kind)
        ]
        if function == "forces":
            chosen = selection(numbered, formulation, level, precision).motions
            found += [replace(made(function, at), ordinary=False) for at in chosen]
    return tuple(found)


def rejected(robot: Robot, fidelity: str, precision: str) -> list[Vector]:
    """Motions for which there are no forces, with the status that says so."""
    first = poses(robot, "exact", 1)[0]
    start = _input(robot, first, PRECISIONS[precision])
    still = start | {"R": np.eye(3).ravel()}
    cases = [
        (still | {"t": robot.b[2] - robot.p[2]}, ZERO_LENGTH),
        # With all platform points in one place the legs' lines meet there.
        (start | {"R": np.zeros(9)}, SINGULAR),
    ]
    if knows_axes(robot, fidelity):
        k = robot.k[4] / np.linalg.norm(robot.k[4])
        along = k * np.linalg.norm(start["t"] - robot.b[4])
        cases.append((still | {"t": robot.b[4] + along - robot.p[4]}, JOINT_SINGULAR))
    return [Vector("forces", inputs, {}, {}, False, status) for inputs, status in cases]


def knows_axes(robot: Robot, fidelity: str) -> bool:
    """Whether a level's forces depend on the fixed axes of the universal joints."""
    level = fidelities.resolved(robot, "exact", fidelity)
    return robot.base_joint == "universal" and fidelities.knows_axes(robot, level)


def _settled(robot: Robot, motion: Numbers, kind: type) -> bool:
    """Whether lengths known to rounding settle the pose, with a factor of two to spare.

    Forward kinematics needs a condition number, by Frobenius norms, of 1 / (16 sqrt(eps)) at most.
    """
    pose = Motion._unchecked(motion["R"].reshape(3, 3), *(motion[name] for name in list(MOTION)[1:]))
    H = moments_over(wrench_matrix(robot, pose), characteristic_length(robot))
    condition = float(np.linalg.norm(H) * np.linalg.norm(np.linalg.inv(H)))
    return 2.0 * condition <= 1.0 / (16.0 * math.sqrt(np.finfo(kind).eps))


def _vector(interpreter: KitInterpreter, robot: Robot, kind: type, function: str, motion: Numbers) -> Vector:
    near = partial(rounded, kind=kind)
    inputs = dict(motion)
    at = motion
    if function in FORCED:
        # More than what holds the motion: the platform has to be accelerated.
        inputs["F"] = near(significant(1.5 * values(interpreter.forces(motion)["F"]), 4))
    elif function == "joint_reactions":
        L = values(interpreter.inverse_kinematics(motion)["L"])
        inputs["bearing"] = near(significant(L * np.linspace(0.3, 0.8, 6), 2))
    elif function == "axial_forces":
        inputs["F"] = near(significant(values(interpreter.forces(motion)["F"]), 4))
    elif function == "motor_torques":
        inputs = {name: near(value) for name, value in _torque_inputs(interpreter, motion).items()}
    elif function in ROTATION:
        inputs = {name: near(value) for name, value in _rotation_inputs(function, motion).items()}
    elif function in KINEMATICS:
        inputs, at = _kinematic_inputs(interpreter, robot, kind, function, motion)
    found = interpreter.found(function, at if function == "forward_kinematics" else inputs)
    margin = FORCES_MARGIN if function == "forces" else MARGIN
    return Vector(function, inputs, *_answers(found, kind, margin))


def _kinematic_inputs(
    interpreter: KitInterpreter, robot: Robot, kind: type, function: str, motion: Numbers
) -> tuple[dict[str, Array], Numbers]:
    """Inputs of a function of the kinematics, and what the interpreter is given in their place."""
    if function == "inverse_kinematics":
        inputs = {name: motion[name] for name in ("R", "t", "omega", "v")}
        return inputs, inputs
    legs = interpreter.inverse_kinematics(motion)
    pose = {name: motion[name] for name in ("R", "t")}
    if function == "forward_velocity":
        inputs = {**pose, "L_dot": rounded(significant(values(legs["L_dot"]), 4), kind)}
        return inputs, inputs
    L = rounded(values(legs["L"]), kind)
    R, t = _guess(robot, pose["R"].reshape(3, 3), pose["t"], L)
    inputs = {"L": L, "R_guess": rounded(R.ravel(), kind), "t_guess": rounded(t, kind)}
    return inputs, {**pose, "L": L}


def _torque_inputs(interpreter: KitInterpreter, motion: Numbers) -> dict[str, Array]:
    """Forces of a motion, and rates beside those at which friction changes; half of the motors are driven."""
    F = significant(values(interpreter.forces(motion)["F"]), 4)
    L_dot = values(interpreter.inverse_kinematics(motion)["L_dot"])
    at = np.array([interpreter.drives["smoothing"], interpreter.drives["stribeck_speed"], L_dot])
    at = np.abs(np.where(at == 0.0, L_dot, at)[np.arange(LEGS) % len(at), np.arange(LEGS)])
    way = np.where(F < 0.0, -0.6, 0.6) * np.repeat([1.0, -1.0], LEGS // 2)
    return {"F": F, "axial": significant(0.9 * F, 4), "L_dot": significant(way * at, 4)}


def _rotation_inputs(function: str, motion: Numbers) -> dict[str, Array]:
    """Angles and a quaternion in numbers that no machine rounds another way, with the motion's own rates."""
    first, second = motion["omega"], motion["alpha"]
    if function == "motion_from_rpy":
        sine, cosine = (np.array(parts) for parts in (_SINES, _COSINES))
        return {"sine": sine, "cosine": cosine, "theta_dot": first, "theta_ddot": second}
    rates = {"e_dot": np.array([0.3, *first]), "e_ddot": np.array([-0.2, *second])}
    return {"e": np.array(_QUATERNION), **rates}


def _guess(robot: Robot, R: Array, t: Array, L: Array) -> tuple[Array, Array]:
    """A pose near R, t from which the lengths L lead back to it."""
    size = characteristic_length(robot)
    for closeness in _CLOSENESS:
        guess = neighbor(robot, R, t, closeness)
        start = orthonormal(guess[0]), guess[1]
        found = forward_kinematics(robot, L, start, "nan", check_limits=False)
        # From lengths in float the pose comes out as good as float, far from any other assembly mode.
        if max(np.abs(found.R - R).max(), np.abs(found.t - t).max() / size) < _SAME:
            return guess
    return R, t


def _answers(found: Found, kind: type, margin: float) -> tuple[dict[str, Array], dict[str, Array]]:
    """Answers and their bounds, which have two digits and are never zero."""
    limits = np.finfo(kind)
    least = float(limits.tiny) / float(limits.eps)
    bounds = {name: np.maximum(margin * errors(numbers), least) for name, numbers in found.items()}
    return (
        {name: values(numbers) for name, numbers in found.items()},
        {name: significant(bound, 2) for name, bound in bounds.items()},
    )


def _input(robot: Robot, motion: Motion, kind: type) -> dict[str, Array]:
    """Fields of a ``stewart_motion``; ValueError where the load, some weights of the platform, overflows."""
    found = {name: rounded(np.ravel(getattr(motion, name)), kind) for name in MOTION}
    if not all(np.isfinite(value).all() for value in found.values()):
        precision = next(name for name, known in PRECISIONS.items() if known is kind)
        raise ValueError(f"robot: M: expected a mass whose weight {precision} can hold, got {robot.M:g}")
    return found
