"""Errors of all shipped code for the actuator forces along a family, relative to 50 digits."""

import warnings
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...backend.kernel import robot_numbers
from ...dynamics.equations import equations_of_motion
from ...dynamics.forces import ForceKernel
from ...dynamics.inverse_dynamics import inverse_dynamics
from ...io.array_types import Array
from ...kinematics.inverse_kinematics import wrench_matrix
from ...motion.motion import Motion
from ...precision.truth import Truth, deviation
from ...results import NOT_FINITE, OK
from ...robot.robot import Robot
from .family import EPS, Curve
from .sweep.oracle import CLOSED_KERNELS, check_poses, closed_form_errors, motion_numbers
from .sweep.sweep import condition_of

FLOAT_EPS = float(np.finfo(np.float32).eps)


def curves(robots: Sequence[Robot], motions: Sequence[Motion], in_float: bool = False) -> tuple[Curve, ...]:
    """Return one curve for each implementation: forces of one pose and of a batch, and all outputs in C and
    NumPy.

    Parameters
    ----------
    robots, motions : sequence
        n robots and n motions of shape ().
    in_float : bool
        True adds the forces in float, whose inputs are rounded to float first.

    Returns
    -------
    tuple of Curve
        Curves. The condition number is the condition number of the problem, at least the scaled one of H.

    Raises
    ------
    native.CompilerError
        Without ``__float128``.
    """
    checked = check_poses(robots, motions)
    truth = np.array([_truth(robot, motion) for robot, motion in zip(robots, motions, strict=True)])
    found = [
        _curve(name, path, robots, motions, truth, checked)
        for name, path in (
            ("forces, one pose", _one_pose),
            ("forces, batch", _batch),
            ("every output, C", lambda robot, motion: _every(robot, motion, "c")),
            ("every output, NumPy", lambda robot, motion: _every(robot, motion, "numpy")),
            ("closed form, H solved", _closed_form),
        )
    ]
    return (*found, float_curve(robots, motions)) if in_float else tuple(found)


def float_curve(robots: Sequence[Robot], motions: Sequence[Motion]) -> Curve:
    """Return the curve of the forces in float, with inputs rounded to float and checked in this form."""
    checked = check_poses(robots, motions, "float")
    condition = condition_of(checked)
    return Curve(
        "forces, float",
        checked["error"][:, 0] * FLOAT_EPS,
        np.where(checked["truth"] == OK, condition, np.inf),
        checked["status"][:, 0].copy(),
        shipped=True,
        epsilon=FLOAT_EPS,
        pose=checked["frames"].copy(),
    )


def closed_form_curves(robots: Sequence[Robot], motions: Sequence[Motion]) -> tuple[Curve, ...]:
    """Return a curve of each kernel of the closed form: the worst output relative to quadruple precision."""
    numbers = np.array([robot_numbers(robot) for robot in robots])
    poses = np.array([motion_numbers(motion) for motion in motions])
    found = closed_form_errors(
        "joint singularity", numbers, np.ones(len(numbers)), 1, 0, in_quad=True, motions=poses
    )
    pose = np.maximum(found["frames"], found["scaled"])
    return tuple(
        Curve(
            kernel.replace("_", " "),
            np.where(error < 0.0, np.nan, error * condition) * EPS,
            condition,
            status.copy(),
            shipped=True,
            pose=pose,
        )
        for kernel, error, condition, status in zip(
            CLOSED_KERNELS, found["error"].T, found["condition"].T, found["status"].T, strict=True
        )
    )


def pose_condition(robots: Sequence[Robot], motions: Sequence[Motion]) -> Array:
    """Return the largest condition number of each pose, shape (n,): of the problem, of the scaled H, and of
    the leg frames.
    """
    checked = check_poses(robots, motions)
    return np.asarray(np.maximum(condition_of(checked), checked["frames"]))


def _curve(
    name: str,
    path: Any,
    robots: Sequence[Robot],
    motions: Sequence[Motion],
    truth: NDArray[np.object_],
    checked: NDArray[Any],
) -> Curve:
    error, status = np.full(len(robots), np.nan), np.zeros(len(robots), dtype=np.int32)
    size = np.where(checked["truth"] == OK, checked["size"], 1.0)
    for i, (robot, motion) in enumerate(zip(robots, motions, strict=True)):
        F, status[i] = path(robot, motion)
        # The 50-digit solver rejects matrices with very different rows; these poses have no error.
        if status[i] != OK or checked["truth"][i] != OK or truth[i, 0] is None:
            continue
        error[i] = np.abs(deviation(F, truth[i])).max() / size[i]
    condition = np.where(checked["truth"] == OK, condition_of(checked), np.inf)
    return Curve(name, error, condition, status, shipped=True, pose=checked["frames"].copy())


def _truth(robot: Robot, motion: Motion) -> NDArray[np.object_]:
    try:
        return _prepared_truth(robot).forces(motion)
    except ZeroDivisionError:
        return np.full(6, None, dtype=object)


# Most families have one machine, and its constants require a third of the time.
_prepared_truth = lru_cache(maxsize=1)(Truth)


def _forces(robot: Robot, motion: Motion) -> tuple[Array, NDArray[np.int32]]:
    """Return forces and statuses; a robot with overflowing constants has status NOT_FINITE."""
    try:
        kernel = ForceKernel(robot)
    except ValueError:
        return np.full((*motion.shape, 6), np.nan), np.full(motion.shape, NOT_FINITE, np.int32)
    return kernel.forces_and_status(motion)


def _one_pose(robot: Robot, motion: Motion) -> tuple[Array, int]:
    F, status = _forces(robot, motion)
    return F, int(status)


def _batch(robot: Robot, motion: Motion) -> tuple[Array, int]:
    """Compute the pose in the middle of a full block of eight."""
    many: dict[str, Any] = {
        name: None if x is None else np.repeat(x[None], 8, axis=0) for name, x in vars(motion).items()
    }
    F, status = _forces(robot, Motion(**many))
    return F[4], int(status[4])


def _every(robot: Robot, motion: Motion, backend: Any) -> tuple[Array, int]:
    with warnings.catch_warnings(action="ignore", category=RuntimeWarning), np.errstate(all="ignore"):
        found = inverse_dynamics(robot, motion, backend=backend, on_singular="nan")
    return found.F, int(found.status)


def _closed_form(robot: Robot, motion: Motion) -> tuple[Array, int]:
    """Compute F of H F = M [a; alpha] + bias - W_ext by NumPy's elimination, without assumptions about H."""
    try:
        ForceKernel(robot)
    except ValueError:
        return np.full(6, np.nan), NOT_FINITE
    found = equations_of_motion(robot, motion, on_singular="nan")
    if int(found.status) != OK or motion.a is None or motion.alpha is None:
        return np.full(6, np.nan), int(found.status)
    load = np.concatenate(
        [motion.R @ (np.zeros(3) if part is None else part) for part in (motion.F_ext, motion.M_ext)]
    )
    wrench = found.M @ np.concatenate([motion.a, motion.alpha]) + found.bias_and_friction - load
    try:
        return np.linalg.solve(wrench_matrix(robot, motion), wrench), OK
    except (np.linalg.LinAlgError, ValueError):
        return np.full(6, np.nan), OK
