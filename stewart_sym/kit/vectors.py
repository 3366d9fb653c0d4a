"""Test vectors: inputs of the functions of a kit, results with 50 digits, and tolerances of rounding errors.

A tolerance is TOLERANCE rounding units times the condition number of the results, or MARGIN times the largest
error of the same program in double precision, in rounding units, if this is more. The condition number is the
root mean square of the changes of a result for small relative changes of all inputs and constants, of which
each has a random sign.
"""

import math
from dataclasses import replace
from functools import lru_cache, partial
from typing import Any

import numpy as np

from ..backend.kernel import MOTION, levels, overflows, resolve_level, robot_numbers
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
from .extreme_motions import extreme_motions
from .interpreter import FLOATS, KitInterpreter, Numbers
from .kit_options import PRECISIONS, STEMS
from .required_kernels import fields as fields_of

CLOSED_FORM = (*STEMS["motion"], *STEMS["derivatives"])
ROTATION = ("motion_from_rpy", "motion_from_quaternion")
FUNCTIONS = (*(stem for stems in STEMS.values() for stem in stems), *ROTATION)
"""Functions with test vectors."""

FEW = 3
"""Number of poses for functions with many results."""

TOLERANCE = 8.0
"""Tolerance of a result (rounding units, times its condition number)."""

MARGIN = 4.0
"""Smallest ratio of the tolerance of a result to the error of the same program in double precision."""

_SAMPLES, _STEP = 6, 2.0**-20
"""Number of changed copies of all numbers for a condition number, and their relative change."""

_LEAST = 1 / 4
"""Smallest ratio of the tolerance of a result to the largest tolerance in the same array."""

_BACKWARD = ("forward_kinematics", "forward_velocity")
_LARGE = ("equations", "joint_inertia", "derivatives", "linearization", *ROTATION)
# Closeness of a guess to its pose, from far to near, and the tolerance for equal poses (rad, and m relative
# to a length).
_CLOSENESS = (1, 4, 16, 64)
_SAME = 1e-3
# Sines and cosines of angles in Pythagorean triangles, and a quaternion with a norm other than one.
_SINES, _COSINES = (3 / 5, -5 / 13, 15 / 17), (4 / 5, 12 / 13, -8 / 17)
_QUATERNION = (1.5, 0.25, -0.5, 0.75)


@lru_cache(maxsize=64)
def vectors(
    robot: Robot,
    functions: tuple[str, ...],
    formulation: str = "exact",
    fidelity: str | None = None,
    precision: str = "double",
    count: int = 8,
    baked: bool = False,
) -> tuple[Vector, ...]:
    """Compute the test vectors of some functions.

    Each function has at most ``count`` ordinary vectors; functions with many results have at most FEW. The
    forces also have vectors of ``extreme_motions``. Forward kinematics is tested only at poses that the
    lengths determine in the given precision; in "float" there may be none.

    Parameters
    ----------
    robot : Robot
        Robot.
    functions : tuple of str
        Functions in the order of the result.
    formulation : str
        "exact" or "paper".
    fidelity : str or None
        Fidelity level of "forces"; None means "general". All other functions include all physics.
    precision : str
        "double" or "float". Inputs and constants are rounded to it before the computation.
    count : int
        Largest number of ordinary vectors of each function.
    baked : bool
        True if the constants are baked, so that they are rounded last.

    Returns
    -------
    tuple of Vector
        Test vectors.

    Raises
    ------
    ValueError
        If the robot has no suitable pose.
    """
    level = resolve_level(robot, formulation, fidelity or "general")
    kind = PRECISIONS[precision]
    if not np.isfinite(rounded(robot_numbers(robot, "exact_drive"), kind)).all():
        raise overflows(precision)
    every = poses(robot, formulation, count)
    ordinary = [_input(robot, every[i], kind) for i in range(every.shape[0])]
    made = _Vectors(robot, formulation, level, kind, baked)
    found: list[Vector] = []
    for function in functions:
        motions = ordinary[:FEW] if function in _LARGE else ordinary
        found += [
            made.vector(function, at)
            for at in motions
            if function not in _BACKWARD or _settled(robot, at, kind)
        ]
        if function == "forces":
            chosen = extreme_motions(robot, every[0], knows_axes(robot, level))
            inputs = [_input(robot, motion, kind) for motion in chosen]
            found += [replace(made.vector(function, at), ordinary=False) for at in inputs]
    return tuple(found)


def rejected(robot: Robot, fidelity: str, precision: str) -> list[Vector]:
    """Return motions without a solution for the forces, with the expected status."""
    first = poses(robot, "exact", 1)[0]
    start = _input(robot, first, PRECISIONS[precision])
    still = start | {"R": np.eye(3).ravel()}
    cases = [
        (still | {"t": robot.b[2] - robot.p[2]}, ZERO_LENGTH),
        # If all platform points coincide, the lines of the legs intersect at that point.
        (start | {"R": np.zeros(9)}, SINGULAR),
    ]
    if knows_axes(robot, fidelity):
        k = robot.k[4] / np.linalg.norm(robot.k[4])
        along = k * np.linalg.norm(start["t"] - robot.b[4])
        cases.append((still | {"t": robot.b[4] + along - robot.p[4]}, JOINT_SINGULAR))
    return [Vector("forces", inputs, {}, {}, False, status) for inputs, status in cases]


def knows_axes(robot: Robot, fidelity: str) -> bool:
    """Return True if the forces of a level depend on the fixed axes of the universal joints."""
    level = resolve_level(robot, "exact", fidelity)
    return robot.base_joint == "universal" and bool(levels(robot)[level]["universal"])


def _settled(robot: Robot, motion: Numbers, kind: type) -> bool:
    """Return True if lengths with rounding errors determine the pose, with a margin of two.

    Forward kinematics requires a condition number, by Frobenius norms, of at most 1 / (16 sqrt(eps)).
    """
    pose = Motion._unchecked(motion["R"].reshape(3, 3), *(motion[name] for name in list(MOTION)[1:]))
    H = moments_over(wrench_matrix(robot, pose), characteristic_length(robot))
    condition = float(np.linalg.norm(H) * np.linalg.norm(np.linalg.inv(H)))
    return 2.0 * condition <= 1.0 / (16.0 * math.sqrt(np.finfo(kind).eps))


class _Vectors:
    """Functions of one robot in 50 digits, and in double precision with changed constants."""

    def __init__(self, robot: Robot, formulation: str, level: str, kind: type, baked: bool) -> None:
        """Round the constants, and draw the signs of their changes."""
        names = fields_of(robot.has_rotors)
        constants = {name: np.asarray(of_symbol(robot, name), dtype=np.float64) for name in names}
        if not baked:
            constants = {name: rounded(value, kind) for name, value in constants.items()}
        drives = {} if robot.drive is None else drive_numbers(robot.drive)
        drives = {name: rounded(value, kind) for name, value in drives.items()}
        self._robot, self._kind, self._draw = robot, kind, np.random.RandomState(1)
        self._exact = KitInterpreter(constants, robot.base_joint, formulation, level, drives)
        self._changed = [
            replace(
                self._exact,
                robot=self._change(constants),
                drives=self._change(drives),
                arithmetic=FLOATS,
            )
            for _ in range(_SAMPLES)
        ]
        self._rounding = replace(self._exact, arithmetic=FLOATS)

    def vector(self, function: str, motion: Numbers) -> Vector:
        """Compute the test vector of a function for a motion."""
        inputs, at = self._inputs(function, motion)
        answers = {name: _rounded(each) for name, each in self._exact.found(function, at).items()}
        return Vector(function, inputs, answers, self._tolerances(function, at, answers))

    def _tolerances(self, function: str, at: Numbers, answers: Numbers) -> dict[str, Array]:
        """Return tolerances of two digits, which are never zero (rounding units)."""
        changed = [each.found(function, self._change(at)) for each in self._changed]
        inexact = self._rounding.found(function, at)
        limits = np.finfo(self._kind)
        least = float(limits.tiny) / float(limits.eps)
        found = {}
        for name, answer in answers.items():
            moved = [(_rounded(each[name]) - answer) / _STEP for each in changed]
            scale = np.maximum(np.sqrt(np.mean(np.square(moved), axis=0)), np.abs(answer))
            scale = np.maximum(scale, _LEAST * scale.max())
            error = np.abs(_rounded(inexact[name]) - answer) / float(np.finfo(np.float64).eps)
            units = max(TOLERANCE, MARGIN * float((error / np.maximum(scale, least)).max()))
            found[name] = significant(np.maximum(units * scale, least), 2)
        return found

    def _change(self, numbers: Numbers) -> dict[str, Array]:
        return {
            name: value * (1.0 + _STEP * self._draw.choice((-1.0, 1.0), size=np.shape(value)))
            for name, value in numbers.items()
        }

    def _inputs(self, function: str, motion: Numbers) -> tuple[dict[str, Array], Numbers]:
        """Return the inputs of a function in C, and the inputs of the interpreter."""
        near = partial(rounded, kind=self._kind)
        inputs = dict(motion)
        if function in FORCED:
            # The forces exceed the forces of the motion, so that the platform accelerates.
            inputs["F"] = near(significant(1.5 * self._found("forces", motion)["F"], 4))
        elif function == "joint_reactions":
            L = self._found("inverse_kinematics", motion)["L"]
            inputs["bearing"] = near(significant(L * np.linspace(0.3, 0.8, 6), 2))
        elif function == "axial_forces":
            inputs["F"] = near(significant(self._found("forces", motion)["F"], 4))
        elif function == "motor_torques":
            inputs = {name: near(value) for name, value in self._torque_inputs(motion).items()}
        elif function in ROTATION:
            inputs = {name: near(value) for name, value in _rotation_inputs(function, motion).items()}
        elif function == "inverse_kinematics":
            inputs = {name: motion[name] for name in ("R", "t", "omega", "v")}
        elif function == "forward_velocity":
            rates = near(significant(self._found("inverse_kinematics", motion)["L_dot"], 4))
            inputs = {"R": motion["R"], "t": motion["t"], "L_dot": rates}
        elif function == "forward_kinematics":
            L = near(self._found("inverse_kinematics", motion)["L"])
            R, t = _guess(self._robot, motion["R"].reshape(3, 3), motion["t"], L)
            guess = {"R_guess": near(R.ravel()), "t_guess": near(t)}
            return {"L": L, **guess}, {"R": motion["R"], "t": motion["t"], "L": L}
        return inputs, inputs

    def _found(self, function: str, motion: Numbers) -> dict[str, Array]:
        return {name: _rounded(each) for name, each in self._exact.found(function, motion).items()}

    def _torque_inputs(self, motion: Numbers) -> dict[str, Array]:
        """Return forces and rates near the thresholds of friction; half of the motors are back-driven."""
        drives = self._exact.drives
        F = significant(self._found("forces", motion)["F"], 4)
        L_dot = self._found("inverse_kinematics", motion)["L_dot"]
        at = np.array([drives["smoothing"], drives["stribeck_speed"], L_dot])
        at = np.abs(np.where(at == 0.0, L_dot, at)[np.arange(LEGS) % len(at), np.arange(LEGS)])
        way = np.where(F < 0.0, -0.6, 0.6) * np.repeat([1.0, -1.0], LEGS // 2)
        return {"F": F, "axial": significant(0.9 * F, 4), "L_dot": significant(way * at, 4)}


def _rotation_inputs(function: str, motion: Numbers) -> dict[str, Array]:
    """Return angles or a quaternion that every machine rounds equally, with the rates of the motion."""
    first, second = motion["omega"], motion["alpha"]
    if function == "motion_from_rpy":
        sine, cosine = (np.array(parts) for parts in (_SINES, _COSINES))
        return {"sine": sine, "cosine": cosine, "theta_dot": first, "theta_ddot": second}
    rates = {"e_dot": np.array([0.3, *first]), "e_ddot": np.array([-0.2, *second])}
    return {"e": np.array(_QUATERNION), **rates}


def _guess(robot: Robot, R: Array, t: Array, L: Array) -> tuple[Array, Array]:
    """Return a pose near R, t from which the solution for the lengths L converges to R, t."""
    size = characteristic_length(robot)
    for closeness in _CLOSENESS:
        guess = neighbor(robot, R, t, closeness)
        start = orthonormal(guess[0]), guess[1]
        found = forward_kinematics(robot, L, start, "nan", check_limits=False)
        # Lengths in float determine the pose to the accuracy of float, far from any other assembly mode.
        if max(np.abs(found.R - R).max(), np.abs(found.t - t).max() / size) < _SAME:
            return guess
    return R, t


def _rounded(values: Any) -> Array:
    """Round each number once."""
    return np.array([float(value) for value in values])


def _input(robot: Robot, motion: Motion, kind: type) -> dict[str, Array]:
    """Return the fields of a ``stewart_motion``; raise ValueError if the load overflows."""
    found = {name: rounded(np.ravel(getattr(motion, name)), kind) for name in MOTION}
    if not all(np.isfinite(value).all() for value in found.values()):
        precision = next(name for name, known in PRECISIONS.items() if known is kind)
        raise ValueError(f"robot: M: {robot.M:g} kg exceeds the range of {precision}; use a smaller mass")
    return found
