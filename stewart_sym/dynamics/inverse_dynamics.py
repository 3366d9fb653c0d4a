"""Inverse dynamics and joint reactions as users call them: any backend, either formulation, checked results.

Chooses the kernel, runs it, and turns a status into an error, a warning or NaN as the caller chooses.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Callable
from typing import Any, Literal, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from .. import results
from ..backend.c_kernel import CKernel
from ..backend.kernel import FORMULATIONS, need_offset_formulation, robot_kernel
from ..backend.native import CompilerError
from ..backend.numpy_kernel import NumpyKernel
from ..io import error_policy
from ..io.arguments import instance, option, real_array
from ..io.array_types import Array, Codes
from ..io.error_policy import ON_SINGULAR, OnSingular, warn
from ..kinematics.conditioning import characteristic_length
from ..motion.motion import Motion
from ..reference import newton_euler, offset_joints
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot
from .damping import damped_least_squares

Formulation = Literal["exact", "paper"]
Backend = Literal["c", "numpy", "reference"]


def faults_of(formulation: str) -> frozenset[int]:
    """Which faults of the printed equations the reference has in a formulation."""
    return newton_euler.PAPER if formulation == "paper" else newton_euler.EXACT


class _VectorKernel:
    """The vector implementation as a kernel; of machines with offset joints whatever the backend."""

    def __init__(self, robot: Robot, formulation: str) -> None:
        """Reject, by ValueError, a formulation that the robot does not have."""
        if robot.offsets is None:
            robot_kernel(robot, formulation)
        else:
            need_offset_formulation(formulation)
        self.robot, self.faults = robot, faults_of(formulation)

    def forces(self, motion: Motion) -> results.InverseDynamicsResult:
        """Inverse dynamics of every pose; NaN where the status is not 0."""
        if self.robot.offsets is not None:
            return offset_joints.inverse_dynamics(self.robot, motion)
        return newton_euler.inverse_dynamics(self.robot, motion, self.faults)

    def reactions(self, motion: Motion, bearing: Array) -> results.JointReactionsResult:
        """Joint reactions of every pose; bearing (6,), m."""
        if self.robot.offsets is not None:
            return offset_joints.joint_reactions(self.robot, motion, bearing)
        return newton_euler.joint_reactions(self.robot, motion, self.faults, bearing)


DynamicsKernel = CKernel | NumpyKernel | _VectorKernel


def inverse_dynamics(
    robot: Robot,
    motion: Motion,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    on_singular: OnSingular = "raise",
) -> results.InverseDynamicsResult:
    """Actuator forces that make the platform follow ``motion``, with D, x, K, H, c, (1)-(37).

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.
    formulation : {"exact", "paper"}, optional
        "exact", or "paper" for the equations as printed.
    backend : {"c", "numpy", "reference"}, optional
        "c" (compiled on first use; NumPy serves where there is no compiler), "numpy" or "reference".
    on_singular : {"raise", "nan", "warn", "damped"}, optional
        What to do about unsolvable poses: "raise" ValueError, "warn" and return NaN there, or return
        "nan" without a warning; ``status`` is that of each pose. "damped": where H is singular, F by damped
        least squares (``damped_least_squares``) with the status as it is, and ``wrench_error`` is the part of
        the wrench that F does not balance. Legs of length zero or along their universal axis have no damped
        forces: NaN, and a warning. All other poses are the same bits as without it.

    Returns
    -------
    InverseDynamicsResult
        Shapes and units are documented there.

    Raises
    ------
    ValueError
        For unknown options, for a motion without accelerations, and for unsolvable poses.
    """
    kernel = _prepared(robot, motion, formulation, backend, on_singular)
    found = kernel.forces(motion)
    if on_singular == "damped":
        error = np.where((found.status == results.OK)[..., None], np.zeros(6), np.nan)
        found = dataclasses.replace(found, wrench_error=error)
        found = _damped(found, motion, lambda poses: damped_terms(robot, poses, formulation))
    return _checked(found, found.F, robot, motion, on_singular)


def joint_reactions(
    robot: Robot,
    motion: Motion,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    bearing_distance: ArrayLike | None = None,
    on_singular: OnSingular = "raise",
) -> results.JointReactionsResult:
    """Forces and moments in the joints, (21), (26)-(29) and M_p of (17).

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.
    formulation, backend : str, optional
        As for ``inverse_dynamics``.
    bearing_distance : array_like, optional
        Where M_p is taken, distance along each leg from its base point, with offset joints along the line of
        sliding from where the length is 0, m, scalar or (6,); None: at that point.
    on_singular : str, optional
        As for ``inverse_dynamics``, as are errors; a pose whose reactions overflow is unsolvable too. Damped,
        they are those of the damped forces.

    Returns
    -------
    JointReactionsResult
        Shapes and units are documented there.
    """
    kernel = _prepared(robot, motion, formulation, backend, on_singular)
    where = _bearing(bearing_distance)
    found = _without_overflow(kernel.reactions(motion, where))
    if on_singular == "damped":
        found = _damped(found, motion, lambda poses: _damped_reactions(robot, poses, formulation, where))
    return _checked(found, found.M_u, robot, motion, on_singular)


def massless_forces(robot: Robot, motion: Motion) -> Array:
    """F0 of (41): actuator forces if legs had no mass, drives no rotors and joints no friction, N, (..., 6).

    NaN where H is singular, a leg has length zero or a force overflows.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.

    Returns
    -------
    ndarray
        Actuator forces, N, (..., 6).
    """
    need_motion(robot, motion)
    of = newton_euler if robot.offsets is None else offset_joints
    F0 = of.massless_forces(robot, motion)
    return np.where(np.isfinite(F0).all(axis=-1, keepdims=True), F0, np.nan)


def leg_dynamics_fraction(robot: Robot, motion: Motion, F: ArrayLike) -> Array:
    """F_d / F of (42) and section 4.4, (..., 6): the share of leg and rotor inertia, leg weight and friction.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.
    F : array_like
        Actuator forces along the motion, N, of its shape, (..., 6). NaN or infinite where F is 0 or F0 is
        NaN.

    Returns
    -------
    ndarray
        Shares, no unit, (..., 6).

    Raises
    ------
    ValueError
        For any other shape.
    """
    F0 = massless_forces(robot, motion)
    forces = real_array(F, "F", f"forces of shape {F0.shape}")
    if forces.shape != F0.shape:
        raise ValueError(f"F: expected forces of shape {F0.shape}, got {forces.shape}")
    with np.errstate(all="ignore"):
        return (forces - F0) / forces


def _prepared(
    robot: Robot, motion: Motion, formulation: str, backend: str, on_singular: str
) -> DynamicsKernel:
    need_motion(robot, motion)
    option(on_singular, ON_SINGULAR, "on_singular")
    return prepared_kernel(robot, formulation, backend)


def prepared_kernel(robot: Robot, formulation: str, backend: str) -> DynamicsKernel:
    """The kernel of a formulation and backend with the robot's numbers; ValueError for unknown options."""
    option(formulation, FORMULATIONS, "formulation")
    option(backend, ("c", "numpy", "reference"), "backend")
    if robot.offsets is not None or backend == "reference":
        return _VectorKernel(robot, formulation)
    if backend == "numpy":
        return NumpyKernel.prepare(robot, formulation)
    found: DynamicsKernel = with_compiler(
        lambda: CKernel.prepare(robot, formulation), lambda: NumpyKernel.prepare(robot, formulation)
    )
    return found


def need_motion(robot: Robot, motion: Motion) -> None:
    """Reject, by ValueError, what is no robot and no motion with accelerations."""
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    if motion.alpha is None or motion.a is None:
        raise ValueError("motion: expected accelerations alpha and a, got none")


def need_universal(robot: Robot) -> None:
    """Reject, by ValueError, what is no robot with universal base joints whose axes meet."""
    instance(robot, Robot, "robot")
    need_no_offsets(robot)
    if robot.base_joint != "universal":
        raise ValueError(f'robot: expected base_joint "universal", got "{robot.base_joint}"')


def with_compiler(compiled: Callable[[], Any], other: Callable[[], Any]) -> Any:
    """``compiled()``, or ``other()`` and one warning where there is no working compiler."""
    try:
        return compiled()
    except CompilerError as error:
        _say_once(f"the NumPy kernels serve instead of C: {error}")
        return other()


@functools.cache
def _say_once(text: str) -> None:
    warn(text, RuntimeWarning)


def _bearing(bearing: ArrayLike | None) -> Array:
    expected = "one finite distance or six"
    values = np.zeros(6) if bearing is None else real_array(bearing, "bearing_distance", expected)
    if values.shape not in ((), (6,)):
        raise ValueError(f"bearing_distance: expected {expected}, got shape {values.shape}")
    if not np.isfinite(values).all():
        raise ValueError(f"bearing_distance: expected {expected}, got {values[~np.isfinite(values)][0]}")
    return np.broadcast_to(values, (6,))


def _without_overflow(found: results.JointReactionsResult) -> results.JointReactionsResult:
    """Give poses whose reactions overflow, though the forces did not, a status and NaN like any other."""
    values = {name: each for name, each in vars(found).items() if name != "status" and each is not None}
    status = newton_euler.without_overflow(values, found.status)
    if (status == found.status).all():
        return found
    return results.JointReactionsResult(**newton_euler.with_status(values, status))


def damped_terms(robot: Robot, motion: Motion, formulation: str) -> dict[str, Array]:
    """F, D, x, K, H, c and wrench_error by ``damped_least_squares``, of poses that may be singular; no
    status.

    By the NumPy kernel, whatever backend rejected the poses. NaN where a leg has no direction.
    """
    if robot.offsets is not None:
        terms = offset_joints.terms(robot, motion)
    else:
        terms = NumpyKernel.prepare(robot, formulation).terms(motion)
    with np.errstate(over="ignore", invalid="ignore"):
        x, error = damped_least_squares(terms["H"], terms["c"], characteristic_length(robot) or 1.0)
        F = terms["D"] - x
    return terms | {"F": F, "x": x, "wrench_error": error}


def _damped_reactions(robot: Robot, motion: Motion, formulation: str, bearing: Array) -> dict[str, Array]:
    x = damped_terms(robot, motion, formulation)["x"]
    if robot.offsets is not None:
        return offset_joints.reactions_of(robot, motion, x, bearing)
    return NumpyKernel.prepare(robot, formulation).reactions_of(motion, x, bearing)


Result = TypeVar("Result", results.InverseDynamicsResult, results.JointReactionsResult)


def _damped(found: Result, motion: Motion, values: Callable[[Motion], dict[str, Array]]) -> Result:
    """Results with the damped values of the poses, by name, where H is singular."""
    singular = found.status == results.SINGULAR
    if not singular.any():
        return found
    changed = {}
    for name, value in values(motion[singular]).items():
        changed[name] = getattr(found, name).copy()
        changed[name][singular] = value
    return dataclasses.replace(found, **changed)


def _checked(result: Result, values: Array, robot: Robot, motion: Motion, on_singular: str) -> Result:
    """The result, once its unsolvable poses are reported; values (..., 6) are finite where damped."""
    status = result.status
    if on_singular == "damped":
        status = np.where(np.isfinite(values).all(axis=-1), results.OK, status).astype(np.int32)
    report_faults(status, robot, motion, on_singular)
    return result


def report_faults(status: Codes, robot: Robot, motion: Motion, on_singular: str) -> None:
    """Raise or warn, as ``on_singular`` says, if a pose is unsolvable."""
    error_policy.report(status, "motion", lambda at: _reason(int(status[at]), robot, motion[at]), on_singular)


def first_fault(status: Codes, robot: Robot, motion: Motion) -> tuple[tuple[int, ...], str]:
    """Index of the first unsolvable pose, and in one line why it is unsolvable.

    status: codes of ``STATUS_TEXT``, one at least not 0, of the motion's shape.
    """
    where, others = error_policy.first(status)
    return where, _reason(int(status[where]), robot, motion[where]) + others


def _reason(code: int, robot: Robot, motion: Motion) -> str:
    """What a status says of one pose, with the leg that it is about."""
    if code not in (results.ZERO_LENGTH, results.JOINT_SINGULAR, results.UNREACHABLE):
        return results.STATUS_TEXT[code]
    return f"{results.STATUS_TEXT[code]} (leg {_worst_leg(code, robot, motion) + 1})"


def _worst_leg(code: int, robot: Robot, motion: Motion) -> int:
    """Index of the shortest leg, or of the one nearest to its universal axis."""
    if robot.offsets is not None:
        return offset_joints.worst_leg(code, robot, motion)
    S = robot.p @ motion.R.T + motion.t - robot.b
    L = np.linalg.norm(S, axis=-1)
    return int(
        np.argmin(L if code == results.ZERO_LENGTH else np.linalg.norm(np.cross(robot.k, S), axis=-1) / L)
    )
