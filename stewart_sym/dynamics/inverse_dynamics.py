"""Inverse dynamics and joint reactions for any formulation and backend, with checks of the results.

``inverse_dynamics`` and ``joint_reactions`` run a kernel and report a nonzero status as an error, a warning,
or NaN.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from .. import results
from ..backend.kernel import FORMULATIONS, need_exact, robot_kernel
from ..backend.native import CompilerError
from ..calls.c_kernel import CKernel, prepared
from ..calls.numpy_kernel import NumpyKernel
from ..io.arguments import instance, option, real_array
from ..io.array_types import Array, Codes
from ..io.error_policy import warn
from ..io.toml_reader import per_leg
from ..motion.motion import Motion
from ..reference import newton_euler, offset_joints
from ..results import ON_FAULT, OnFault
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot, need_masses

Formulation = Literal["exact", "paper"]
Backend = Literal["c", "numpy", "reference"]


def faults_of(formulation: str) -> frozenset[int]:
    """Return the fault numbers (1 to 4) that a formulation keeps."""
    return newton_euler.PAPER if formulation == "paper" else newton_euler.EXACT


class _VectorKernel:
    """Vector implementation, which robots with offset joints use for every backend."""

    def __init__(self, robot: Robot, formulation: str) -> None:
        """Raise ValueError for a formulation that the robot does not have."""
        if robot.offsets is None:
            robot_kernel(robot, formulation)
        else:
            need_masses(robot)
            need_exact(formulation, "with offset joints")
        self.robot, self.faults = robot, faults_of(formulation)

    def run(self, output: str, motion: Motion, *given: Array) -> dict[str, Any]:
        """Return the results by name of inverse dynamics or joint reactions, as ``CKernel.run``."""
        offset = self.robot.offsets is not None
        of, faults = (offset_joints, ()) if offset else (newton_euler, (self.faults,))
        return dict(vars(getattr(of, output)(self.robot, motion, *faults, *given)))


DynamicsKernel = CKernel | NumpyKernel | _VectorKernel


def inverse_dynamics(
    robot: Robot,
    motion: Motion,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    on_singular: OnFault = "raise",
) -> results.InverseDynamicsResult:
    """Compute the actuator forces that produce a motion of the platform.

    Parameters
    ----------
    robot : Robot
        Robot model.
    motion : Motion, shape (...)
        Poses, velocities, and accelerations of the platform, with an external wrench if there is one.
    formulation : {"exact", "paper"}, optional
        "exact" for the corrected equations, "paper" for the equations as printed.
    backend : {"c", "numpy", "reference"}, optional
        "c" for C code that is compiled on first use (NumPy if there is no compiler), "numpy" for generated
        NumPy code, "reference" for an independent vector implementation. Robots with offset joints always use
        the vector implementation.
    on_singular : {"raise", "warn", "nan"}, optional
        Treatment of poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
        ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning.

    Returns
    -------
    InverseDynamicsResult
        Actuator forces ``F`` (N), shape (..., 6), positive when they extend the leg; ``status``, shape (...);
        and the terms D, x, K, H, and c of the equations.

    Raises
    ------
    ValueError
        If an option is unknown, if the motion has no accelerations, or if a pose has no solution and
        ``on_singular`` is "raise".

    See Also
    --------
    forward_dynamics : Compute accelerations from actuator forces.
    joint_reactions : Compute the forces and moments in the joints.
    ForceKernel : Compute forces repeatedly for one robot, with threads and in float.
    force_derivatives : Compute the derivatives of the forces.
    drive_effort : Compute motor torques and currents along a motion.

    Notes
    -----
    The function implements equations (1)-(37) of Dasgupta and Mruthyunjaya (1998). The printed
    equations have four faults. "exact" corrects all of them, "paper" keeps faults 1 to 3. Fault 4, a sign in
    (33), affects neither, because both use (35).

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("unal")
    >>> motion = ss.Motion.from_rpy(
    ...     t=[0.02, 0.0, 0.7],
    ...     theta=[0.1, 0.0, 0.0],
    ...     v=[0.0, 0.0, 0.2],
    ...     theta_dot=[0.0, 0.1, 0.0],
    ...     a=[0.0, 0.0, 1.0],
    ...     theta_ddot=[0.0, 0.0, 0.5],
    ... )
    >>> result = ss.inverse_dynamics(robot, motion)
    >>> result.F.round(2).tolist()
    [4.0, 6.33, 11.19, 3.52, 3.79, 10.22]
    >>> int(result.status)
    0
    """
    kernel = _prepared(robot, motion, formulation, backend, on_singular)
    found = kernel.run("inverse_dynamics", motion)
    report_faults(found["status"], robot, motion, on_singular)
    return results.InverseDynamicsResult(**found)


def joint_reactions(
    robot: Robot,
    motion: Motion,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    bearing_distance: ArrayLike | None = None,
    on_singular: OnFault = "raise",
) -> results.JointReactionsResult:
    """Compute the forces and moments in the joints of the legs.

    Parameters
    ----------
    robot : Robot
        Robot model.
    motion : Motion, shape (...)
        Poses, velocities, and accelerations of the platform, with an external wrench if there is one.
    formulation : {"exact", "paper"}, optional
        "exact" for the corrected equations, "paper" for the equations as printed.
    backend : {"c", "numpy", "reference"}, optional
        "c" for C code that is compiled on first use (NumPy if there is no compiler), "numpy" for generated
        NumPy code, "reference" for an independent vector implementation. Robots with offset joints always use
        the vector implementation.
    bearing_distance : array_like, shape () or (6,), optional
        Distance (m) along each leg from its base point to the point at which the moment M_p is taken; by
        default 0. With offset joints, the distance is along the sliding axis, from the point of zero length.
    on_singular : {"raise", "warn", "nan"}, optional
        Treatment of poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
        ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning.

    Returns
    -------
    JointReactionsResult
        Forces (N) and moments (N m) at the spherical, prismatic, and universal joints, base frame, for
        example ``F_s``, shape (..., 6, 3).

    Raises
    ------
    ValueError
        If an option is unknown, if ``bearing_distance`` has another shape, if the motion has no
        accelerations, or if a pose has no solution and ``on_singular`` is "raise". A pose also has no
        solution if its reactions overflow.

    See Also
    --------
    inverse_dynamics : Compute the actuator forces.

    Notes
    -----
    Equations (21), (26)-(29), and M_p of (17) of Dasgupta and Mruthyunjaya, Mechanism and Machine Theory 33
    (1998).

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> reactions = ss.joint_reactions(robot, motion)
    >>> reactions.F_u[0].round(2).tolist()
    [-115.44, -156.74, 348.17]
    >>> reactions.M_p.shape
    (6, 3)
    """
    kernel = _prepared(robot, motion, formulation, backend, on_singular)
    where = per_leg(0.0 if bearing_distance is None else bearing_distance, "bearing_distance")
    found = kernel.run("joint_reactions", motion, where)
    status = found.pop("status")
    values = {name: each for name, each in found.items() if each is not None}
    # Reactions can overflow although the forces do not.
    found = newton_euler.with_status(values, newton_euler.without_overflow(values, status))
    report_faults(found["status"], robot, motion, on_singular)
    return results.JointReactionsResult(**found)


def massless_forces(robot: Robot, motion: Motion) -> Array:
    """Compute the actuator forces of a robot with massless legs, without rotors, and without friction.

    Parameters
    ----------
    robot : Robot
        Robot model.
    motion : Motion, shape (...)
        Poses, velocities, and accelerations of the platform, with an external wrench if there is one.

    Returns
    -------
    ndarray, shape (..., 6)
        Actuator forces F0 (N), positive when they extend the leg. NaN if H is singular, a leg has length
        zero, or a force overflows.

    Raises
    ------
    ValueError
        If ``robot`` is not a ``Robot`` or ``motion`` is not a ``Motion`` with accelerations.

    See Also
    --------
    inverse_dynamics : Compute the forces with all physics.
    leg_dynamics_fraction : Compute the fraction that these forces omit.

    Notes
    -----
    Equation (41) of Dasgupta and Mruthyunjaya, Mechanism and Machine Theory 33 (1998).

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> ss.massless_forces(robot, motion).round(2).tolist()
    [268.53, -827.09, 1096.09, -481.61, -55.66, 332.42]
    """
    need_motion(robot, motion)
    need_masses(robot)
    of = newton_euler if robot.offsets is None else offset_joints
    F0 = of.massless_forces(robot, motion)
    return np.where(np.isfinite(F0).all(axis=-1, keepdims=True), F0, np.nan)


def leg_dynamics_fraction(robot: Robot, motion: Motion, F: ArrayLike) -> Array:
    """Compute the fraction of the actuator forces that is due to the legs.

    The contribution of the legs consists of weight, friction, and inertia, with the inertia of the rotors.

    Parameters
    ----------
    robot : Robot
        Robot model.
    motion : Motion, shape (...)
        Poses, velocities, and accelerations of the platform, with an external wrench if there is one.
    F : array_like, shape (..., 6)
        Actuator forces (N) along the motion, for example of ``inverse_dynamics``.

    Returns
    -------
    ndarray, shape (..., 6)
        Fractions (F - F0) / F without a unit, where F0 are the ``massless_forces``. NaN or infinite if F is 0
        or F0 is NaN.

    Raises
    ------
    ValueError
        If ``F`` has another shape, or if ``motion`` is not a ``Motion`` with accelerations.

    See Also
    --------
    massless_forces : Compute F0.

    Notes
    -----
    Equation (42) and section 4.4 of Dasgupta and Mruthyunjaya, Mechanism and Machine Theory 33 (1998).

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> F = ss.inverse_dynamics(robot, motion).F
    >>> ss.leg_dynamics_fraction(robot, motion, F=F).round(2).tolist()
    [0.28, 0.22, 0.19, 0.15, 0.28, 0.13]
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
    option(on_singular, ON_FAULT, "on_singular")
    return prepared_kernel(robot, formulation, backend)


def prepared_kernel(robot: Robot, formulation: str, backend: str) -> DynamicsKernel:
    """Return the kernel of a formulation and a backend for a robot; ValueError for unknown options."""
    option(formulation, FORMULATIONS, "formulation")
    option(backend, ("c", "numpy", "reference"), "backend")
    if robot.offsets is not None or backend == "reference":
        found: DynamicsKernel = prepared(_VectorKernel, robot, formulation)
    elif backend == "numpy":
        found = prepared(NumpyKernel, robot, formulation)
    else:
        found = with_compiler(
            lambda: prepared(CKernel, robot, formulation), lambda: prepared(NumpyKernel, robot, formulation)
        )
    return found


def need_motion(robot: Robot, motion: Motion) -> None:
    """Raise ValueError unless the arguments are a robot and a motion with accelerations."""
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    if motion.alpha is None or motion.a is None:
        raise ValueError("motion: expected accelerations alpha and a, got none")


def need_universal(robot: Robot) -> None:
    """Raise ValueError unless the robot has universal base joints without offsets."""
    instance(robot, Robot, "robot")
    need_no_offsets(robot)
    if robot.base_joint != "universal":
        raise ValueError(f'robot: expected base_joint "universal", got "{robot.base_joint}"')


def with_compiler(compiled: Callable[[], Any], other: Callable[[], Any]) -> Any:
    """Return ``compiled()``; without a working compiler, warn once and return ``other()``."""
    try:
        return compiled()
    except CompilerError as error:
        _say_once(f"the NumPy kernels are used instead of C: {error}")
        return other()


@functools.cache
def _say_once(text: str) -> None:
    warn(text, RuntimeWarning)


def report_faults(status: Codes, robot: Robot, motion: Motion, on_singular: str) -> None:
    """Raise or warn according to ``on_singular`` if a pose has no solution."""
    results.report_faults(
        status, "motion", lambda at: _reason(int(status[at]), robot, motion[at]), on_singular
    )


def first_fault(status: Codes, robot: Robot, motion: Motion) -> tuple[tuple[int, ...], str]:
    """Return the index of the first pose without a solution, and the reason in one line.

    ``status`` has the shape of the motion and contains at least one nonzero code of ``STATUS_TEXT``.
    """
    return results.first_fault(status, lambda at: _reason(int(status[at]), robot, motion[at]))


def _reason(code: int, robot: Robot, motion: Motion) -> str:
    """Return the text of a status code for one pose, with the number of the leg that causes it."""
    if code not in (results.ZERO_LENGTH, results.JOINT_SINGULAR, results.UNREACHABLE):
        return results.STATUS_TEXT[code]
    return f"{results.STATUS_TEXT[code]} (leg {_worst_leg(code, robot, motion) + 1})"


def _worst_leg(code: int, robot: Robot, motion: Motion) -> int:
    """Return the index of the shortest leg, or of the leg nearest to its universal axis."""
    if robot.offsets is not None:
        return offset_joints.worst_leg(code, robot, motion)
    S = robot.p @ motion.R.T + motion.t - robot.b
    L = np.linalg.norm(S, axis=-1)
    return int(
        np.argmin(L if code == results.ZERO_LENGTH else np.linalg.norm(np.cross(robot.k, S), axis=-1) / L)
    )
