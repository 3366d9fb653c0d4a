"""Equations of motion, forward dynamics, joint-space inertia, force derivatives, and linearization.

For poses without a solution, the argument ``on_singular`` selects an error, a warning, or NaN.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import finite_array, instance, leading_shape, option
from ..io.array_types import Array
from ..kinematics.inverse_kinematics import wrench_matrix
from ..motion.motion import Motion
from ..reference import newton_euler
from ..reference.equations_of_motion import by_linearity
from ..results import (
    OK,
    ON_FAULT,
    SINGULAR,
    Accelerations,
    EquationsOfMotionResult,
    ForceDerivativesResult,
    LinearizationResult,
    OnFault,
)
from ..robot.robot import Robot
from . import inverse_dynamics
from .forward_dynamics import ClosedForm, actuator_wrench, closed_form_of
from .forward_dynamics import ForwardDynamics as ForwardDynamics


def equations_of_motion(
    robot: Robot,
    motion: Motion,
    formulation: inverse_dynamics.Formulation = "exact",
    backend: inverse_dynamics.Backend = "c",
    on_singular: OnFault = "raise",
) -> EquationsOfMotionResult:
    """Compute the terms of M [a; alpha] + C [v; omega] + g + friction = H F + W_ext.

    Parameters
    ----------
    robot : Robot
        Robot model.
    motion : Motion, shape (...)
        Poses and velocities of the platform; accelerations and the external wrench are ignored.
    formulation : {"exact", "paper"}, optional
        "exact" for the corrected equations, "paper" for the equations as printed.
    backend : {"c", "numpy", "reference"}, optional
        "c" for C code that is compiled on first use (NumPy if there is no compiler), "numpy" for generated
        NumPy code, "reference" for an independent vector implementation.
    on_singular : {"raise", "warn", "nan"}, optional
        Treatment of poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
        ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning.

    Returns
    -------
    EquationsOfMotionResult
        Mass matrix ``M``, Coriolis matrix ``C``, shape (..., 6, 6); ``g``, ``friction``, ``bias``, and
        ``bias_and_friction`` (N and N m), shape (..., 6); and ``status``, shape (...). Wrenches and twists
        are at the reference point in base axes.

    Raises
    ------
    ValueError
        If an option is unknown, or if a pose has no solution and ``on_singular`` is "raise".

    See Also
    --------
    forward_dynamics : Compute the accelerations from actuator forces.
    joint_space_inertia : Compute the mass matrix with leg lengths as coordinates.
    inverse_dynamics : Compute H and the actuator forces.

    Notes
    -----
    The terms have a closed form, which Dasgupta and Mruthyunjaya, Mechanism and Machine Theory 33 (1998),
    mention but do not derive. Each leg is treated as a mechanism with three degrees of freedom, and C follows
    from Christoffel symbols, so that dM/dt - 2 C is skew-symmetric. The backends "c" and "numpy" evaluate
    this closed form for the formulation "exact" and universal base joints without offsets. In all other cases
    the terms are computed from inverse dynamics by linearity, which can require that H is regular.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> terms = ss.equations_of_motion(robot, motion)
    >>> terms.M.diagonal().round(2).tolist()
    [49.28, 54.99, 50.44, 0.66, 0.7, 1.02]
    >>> terms.g.round(2).tolist()
    [-9.79, 21.84, 479.06, 15.94, -24.89, 5.27]
    """
    _need(robot, motion, on_singular)
    closed = closed_form_of(robot, formulation, backend)
    if closed is None:
        found = by_linearity(actuator_wrench(robot, formulation, backend), robot, motion)
    else:
        terms = closed.run("equations", motion)
        del terms["H"], terms["H_dot"]
        found = EquationsOfMotionResult(**terms)
    inverse_dynamics.report_faults(found.status, robot, motion, on_singular)
    return found


def force_derivatives(
    robot: Robot, motion: Motion, backend: Literal["c", "numpy"] = "c", on_singular: OnFault = "raise"
) -> ForceDerivativesResult:
    """Compute the derivatives of the actuator forces with respect to pose, twist, and acceleration.

    Parameters
    ----------
    robot : Robot
        Robot model with universal base joints without offsets.
    motion : Motion, shape (...)
        Poses, velocities, and accelerations of the platform, with an external wrench if there is one. The
        wrench is constant in the platform frame.
    backend : {"c", "numpy"}, optional
        "c" for C code that is compiled on first use (NumPy if there is no compiler), "numpy" for generated
        NumPy code.
    on_singular : {"raise", "warn", "nan"}, optional
        Treatment of poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
        ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning.

    Returns
    -------
    ForceDerivativesResult
        Forces ``F`` (N), shape (..., 6); derivatives ``by_pose``, ``by_twist``, and ``by_acceleration``,
        shape (..., 6, 6), with one row per leg; and ``status``, shape (...). A pose changes by [dt; dphi] (m
        and rad, base axes): R becomes exp([dphi]x) R.

    Raises
    ------
    ValueError
        If an option is unknown, the robot has spherical or offset base joints, the motion has no
        accelerations, or a pose has no solution and ``on_singular`` is "raise".

    See Also
    --------
    inverse_dynamics : Compute the forces.
    linearize : Compute the linear state equations about a motion.

    Notes
    -----
    Analytic derivatives of the closed form, formulation "exact".

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> derivatives = ss.force_derivatives(robot, motion)
    >>> derivatives.by_acceleration[0].round(2).tolist()
    [-104.98, -17.45, 36.34, 5.21, 4.43, 2.06]
    """
    inverse_dynamics.need_motion(robot, motion)
    found = _with_closed_form(robot, backend, on_singular).run("derivatives", motion)
    inverse_dynamics.report_faults(found["status"], robot, motion, on_singular)
    return ForceDerivativesResult(**found)


def linearize(
    robot: Robot,
    motion: Motion,
    F: ArrayLike,
    backend: Literal["c", "numpy"] = "c",
    on_singular: OnFault = "raise",
) -> LinearizationResult:
    """Compute the linear state equations dx/dt = A x + B dF about a motion.

    The state x = [dt; dphi; dv; domega] is the difference from the motion, and dF is the change of the
    actuator forces.

    Parameters
    ----------
    robot : Robot
        Robot model with universal base joints without offsets.
    motion : Motion, shape (...)
        Poses and velocities of the platform, with an external wrench if there is one; accelerations are
        ignored.
    F : array_like, shape (..., 6)
        Actuator forces (N) at the operating point, positive when they extend the leg.
    backend : {"c", "numpy"}, optional
        "c" for C code that is compiled on first use (NumPy if there is no compiler), "numpy" for generated
        NumPy code.
    on_singular : {"raise", "warn", "nan"}, optional
        Treatment of poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
        ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning.

    Returns
    -------
    LinearizationResult
        State matrix ``A``, shape (..., 12, 12), and input matrix ``B``, shape (..., 12, 6), in SI units; the
        ``acceleration`` [a; alpha] (m/s^2 and rad/s^2) at the operating point, shape (..., 6); and
        ``status``, shape (...).

    Raises
    ------
    ValueError
        If an option is unknown, the robot has spherical or offset base joints, or ``F`` has another shape or
        is not finite. Also if a pose has no solution and ``on_singular`` is "raise".

    See Also
    --------
    forward_dynamics : Compute the accelerations alone.
    force_derivatives : Compute the derivatives of inverse dynamics.

    Notes
    -----
    Analytic derivatives of the closed form, formulation "exact". The leading shapes of ``motion`` and ``F``
    broadcast.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> system = ss.linearize(robot, motion, F=ss.inverse_dynamics(robot, motion).F)
    >>> system.A.shape, system.B.shape
    ((12, 12), (12, 6))
    >>> system.B[8].round(3).tolist()
    [-0.008, -0.004, 0.011, 0.02, 0.052, 0.023]
    """
    _need(robot, motion, on_singular)
    closed = _with_closed_form(robot, backend, on_singular)
    motion, forces = _together(motion, F)
    found = closed.run("linearization", motion, forces)
    inverse_dynamics.report_faults(found["status"], robot, motion, on_singular)
    return LinearizationResult(**found)


def forward_dynamics(
    robot: Robot,
    motion: Motion,
    F: ArrayLike,
    formulation: inverse_dynamics.Formulation = "exact",
    backend: inverse_dynamics.Backend = "c",
    on_singular: OnFault = "raise",
) -> Accelerations:
    """Compute the accelerations of the platform under given actuator forces.

    Parameters
    ----------
    robot : Robot
        Robot model.
    motion : Motion, shape (...)
        Poses and velocities of the platform, with an external wrench if there is one; accelerations are
        ignored.
    F : array_like, shape (..., 6)
        Actuator forces (N), positive when they extend the leg.
    formulation : {"exact", "paper"}, optional
        "exact" for the corrected equations, "paper" for the equations as printed.
    backend : {"c", "numpy", "reference"}, optional
        "c" for C code that is compiled on first use (NumPy if there is no compiler), "numpy" for generated
        NumPy code, "reference" for an independent vector implementation.
    on_singular : {"raise", "warn", "nan"}, optional
        Treatment of poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
        ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning.

    Returns
    -------
    Accelerations
        Named tuple (a, alpha): acceleration of the reference point (m/s^2) and angular acceleration
        (rad/s^2), base frame, shape (..., 3) each.

    Raises
    ------
    ValueError
        If an option is unknown, if ``F`` has another shape or is not finite, or if a pose has no solution and
        ``on_singular`` is "raise".

    See Also
    --------
    inverse_dynamics : Compute the actuator forces of a motion.
    equations_of_motion : Compute the terms of the equations.
    linearize : Compute the derivatives of the accelerations.
    simulate : Integrate the accelerations over time.

    Notes
    -----
    The equations M [a; alpha] = H F + W_ext - C [v; omega] - g - friction are solved by Cholesky
    factorization. A pose has no solution if M is not positive definite, for example because of an inertia
    tensor that no rigid body can have. The leading shapes of ``motion`` and ``F`` broadcast.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> F = ss.inverse_dynamics(robot, motion).F
    >>> a, alpha = ss.forward_dynamics(robot, motion, F=F)
    >>> bool(abs(a - motion.a).max() < 1e-9)
    True

    The acceleration without actuator forces:

    >>> ss.forward_dynamics(robot, motion, F=[0.0] * 6).a.round(2).tolist()
    [0.67, -0.35, -9.31]
    """
    _need(robot, motion, on_singular)
    motion, forces = _together(motion, F)
    a, alpha, status = ForwardDynamics(robot, formulation, backend).solve(motion, forces)
    inverse_dynamics.report_faults(status, robot, motion, on_singular)
    return Accelerations(a, alpha)


def joint_space_inertia(
    robot: Robot,
    motion: Motion,
    formulation: inverse_dynamics.Formulation = "exact",
    backend: inverse_dynamics.Backend = "c",
    on_singular: OnFault = "raise",
) -> Array:
    """Compute the mass matrix with the leg lengths as coordinates, H^-1 M H^-T.

    Column i contains the actuator forces for L_ddot_i = 1 m/s^2 and no acceleration of the other legs, at
    rest and without gravity.

    Parameters
    ----------
    robot : Robot
        Robot model.
    motion : Motion, shape (...)
        Poses of the platform; velocities, accelerations, and the external wrench are ignored.
    formulation : {"exact", "paper"}, optional
        "exact" for the corrected equations, "paper" for the equations as printed.
    backend : {"c", "numpy", "reference"}, optional
        "c" for C code that is compiled on first use (NumPy if there is no compiler), "numpy" for generated
        NumPy code, "reference" for an independent vector implementation.
    on_singular : {"raise", "warn", "nan"}, optional
        Treatment of poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
        ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning.

    Returns
    -------
    ndarray, shape (..., 6, 6)
        Mass matrix at the actuators (kg), symmetric.

    Raises
    ------
    ValueError
        If an option is unknown, or if a pose is singular or has no solution and ``on_singular`` is "raise".

    See Also
    --------
    equations_of_motion : Compute the mass matrix M of the platform.
    wrench_matrix : Compute H.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> inertia = ss.joint_space_inertia(robot, motion)
    >>> inertia.diagonal().round(2).tolist()
    [298.06, 357.33, 784.72, 190.62, 309.07, 888.89]
    """
    _need(robot, motion, on_singular)
    closed = closed_form_of(robot, formulation, backend)
    if closed is not None:
        direct = closed.run("joint_inertia", motion)
        inverse_dynamics.report_faults(direct["status"], robot, motion, on_singular)
        return np.asarray(direct["inertia"])
    found = by_linearity(actuator_wrench(robot, formulation, backend), robot, motion)
    ok = found.status == OK
    H, M = wrench_matrix(robot, motion[ok]), found.M[ok]
    regular = ~newton_euler.is_singular(robot, H)
    inertia = np.full_like(found.M, np.nan)
    status = found.status.copy()
    status[ok] = np.where(regular, OK, SINGULAR)
    half = np.linalg.solve(H[regular], M[regular])
    inertia[status == OK] = np.swapaxes(np.linalg.solve(H[regular], np.swapaxes(half, -1, -2)), -1, -2)
    inverse_dynamics.report_faults(status, robot, motion, on_singular)
    return inertia


def _with_closed_form(robot: Robot, backend: str, on_singular: str) -> ClosedForm:
    """Return the closed-form kernels; ValueError for a robot to which they do not apply."""
    option(backend, ("c", "numpy"), "backend")
    option(on_singular, ON_FAULT, "on_singular")
    inverse_dynamics.need_universal(robot)
    closed = closed_form_of(robot, "exact", backend)
    assert closed is not None
    return closed


def _together(motion: Motion, F: ArrayLike) -> tuple[Motion, Array]:
    """Broadcast a motion and forces to one leading shape."""
    forces = finite_array(F, (6,), "F")
    shape = leading_shape({"motion": motion.shape, "F": forces.shape[:-1]})
    return _broadcast(motion, shape), np.broadcast_to(forces, (*shape, 6))


def _need(robot: Robot, motion: Motion, on_singular: str) -> None:
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    option(on_singular, ON_FAULT, "on_singular")


def _broadcast(motion: Motion, shape: tuple[int, ...]) -> Motion:
    """Broadcast a motion to a leading shape; if the shape changes, accelerations are omitted."""
    lead = len(motion.shape)
    if shape == motion.shape:
        return motion
    wide: dict[str, Any] = {
        # Copies, because NumPy's products with broadcast rows (stride 0) can round differently.
        name: value if value is None else np.array(np.broadcast_to(value, (*shape, *value.shape[lead:])))
        for name, value in vars(motion).items()
        if name not in ("alpha", "a")
    }
    return Motion._unchecked(**wide)
