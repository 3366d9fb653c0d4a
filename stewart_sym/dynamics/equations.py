"""Equations of motion as users call them: M, C, g, friction, forward dynamics and derivatives.

Turns a status into an error, a warning or NaN.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from ..backend.kernel import FORMULATIONS
from ..io.arguments import instance, leading_shape, option, real_array
from ..io.array_types import Array, Codes, Flags
from ..io.error_policy import ON_FAULT, OnFault
from ..kinematics.inverse_kinematics import leg_vectors, wrench_matrix
from ..motion.motion import Motion
from ..motion.rotation import cross
from ..reference import equations_of_motion as reference_equations
from ..reference import newton_euler, offset_joints
from ..reference.equations_of_motion import ActuatorWrench, by_linearity, inertia_and_bias
from ..results import (
    MASS_MATRIX_INDEFINITE,
    NOT_FINITE,
    OK,
    SINGULAR,
    Accelerations,
    EquationsOfMotionResult,
    ForceDerivativesResult,
    LinearizationResult,
)
from ..robot.robot import Robot
from . import inverse_dynamics
from .closed_form import CClosedForm, ClosedForm, NumpyClosedForm
from .forward_from_inverse import ForwardFromInverse


def equations_of_motion(
    robot: Robot,
    motion: Motion,
    formulation: inverse_dynamics.Formulation = "exact",
    backend: inverse_dynamics.Backend = "c",
    on_singular: OnFault = "raise",
) -> EquationsOfMotionResult:
    """M, C, g and friction of M [a; alpha] + C [v; omega] + g + friction = H F + W_ext.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Poses and rates; accelerations and load don't count.
    formulation, backend, on_singular : str, optional
        As for ``inverse_dynamics``. "c" and "numpy" evaluate the closed form in `exact`; of `paper` and of
        machines with spherical base joints they draw the terms from inverse dynamics, which fails
        where H is singular.

    Returns
    -------
    EquationsOfMotionResult
        Shapes and units are documented there.

    Raises
    ------
    ValueError
        For unknown options and for unsolvable poses.
    """
    _need(robot, motion, on_singular)
    closed = _closed_form(robot, formulation, backend)
    if closed is None:
        found = _by_linearity(robot, motion, formulation, backend)
    else:
        terms = closed.run("equations", motion)
        found = EquationsOfMotionResult(**{name: terms[name] for name in _TERMS}, status=terms["status"])
    inverse_dynamics.report_faults(found.status, robot, motion, on_singular)
    return found


_TERMS = ("M", "C", "g", "friction", "bias", "bias_and_friction")


def force_derivatives(
    robot: Robot, motion: Motion, backend: Literal["c", "numpy"] = "c", on_singular: OnFault = "raise"
) -> ForceDerivativesResult:
    """Derivatives of the `exact` actuator forces by pose, twist and acceleration.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        With accelerations. Other arguments: as for ``inverse_dynamics``. Poses move by [dt; dphi], R becoming
        exp([dphi]x) R; the load moves with the platform.
    backend, on_singular : str, optional
        As for ``inverse_dynamics``: "c" or "numpy"; nothing is damped.

    Returns
    -------
    ForceDerivativesResult
        Shapes and units are documented there.

    Raises
    ------
    ValueError
        For unknown options, for spherical base joints, for a motion without accelerations, and for unsolvable
        poses.
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
    """Linear state equations of the `exact` machine about a motion under actuator forces F, N, (..., 6).

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Poses, rates and load; accelerations don't count. Other arguments and errors: as for
        ``forward_dynamics``; spherical base joints are rejected.
    F : array_like
        Actuator forces, N, (..., 6).
    backend, on_singular : str, optional
        As for ``inverse_dynamics``: "c" or "numpy"; nothing is damped.

    Returns
    -------
    LinearizationResult
        Shapes and units are documented there.
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
    """(a, alpha), a named tuple, m/s^2 and rad/s^2, (..., 3), under actuator forces F, N, (..., 6).

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Poses, rates and load F_ext, M_ext; accelerations don't count. The leading shapes of motion and F
        broadcast. Other arguments: as for ``inverse_dynamics``. M is factorized by Cholesky's method, so a
        machine whose inertias belong to no body may be unsolvable.
    F : array_like
        Actuator forces, N, (..., 6).
    formulation, backend, on_singular : str, optional
        As for ``inverse_dynamics``, but nothing is damped.

    Returns
    -------
    Accelerations
        Named tuple (a, alpha), m/s^2 and rad/s^2, (..., 3), base frame.

    Raises
    ------
    ValueError
        For unknown options, for F of another shape or not finite, and for unsolvable poses.
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
    """H^-1 M H^-T, kg, (..., 6, 6): actuator forces that leg accelerations cost, for legs as coordinates.

    Arguments and errors as for ``equations_of_motion``; a pose where H is singular is unsolvable.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.
    formulation, backend, on_singular : str, optional
        As for ``inverse_dynamics``, but nothing is damped.

    Returns
    -------
    ndarray
        Inertia that the actuators feel, kg, (..., 6, 6).
    """
    _need(robot, motion, on_singular)
    closed = _closed_form(robot, formulation, backend)
    if closed is not None:
        direct = closed.run("joint_inertia", motion)
        inverse_dynamics.report_faults(direct["status"], robot, motion, on_singular)
        return np.asarray(direct["inertia"])
    found = _by_linearity(robot, motion, formulation, backend)
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


@dataclass(frozen=True, eq=False)
class ForwardDynamics:
    """A robot prepared for many evaluations of its forward dynamics, as a simulation makes them."""

    robot: Robot
    formulation: inverse_dynamics.Formulation = "exact"
    backend: inverse_dynamics.Backend = "c"
    closed: ClosedForm | None = field(init=False, repr=False)
    _wrench: ActuatorWrench = field(init=False, repr=False)

    def __post_init__(self) -> None:
        instance(self.robot, Robot, "robot")
        wrench = _actuator_wrench(self.robot, self.formulation, self.backend)
        object.__setattr__(self, "_wrench", wrench)
        object.__setattr__(self, "closed", _closed_form(self.robot, self.formulation, self.backend))

    def solve(self, motion: Motion, F: Array) -> tuple[Array, Array, Codes]:
        """a, alpha (..., 3) and status (...) of poses under F (..., 6), of the motion's shape.

        NaN where the status is not 0; raises nothing.
        """
        if self.closed is not None:
            found = self.closed.run("forward_dynamics", motion, F)
            x = found["acceleration"]
            return x[..., :3], x[..., 3:], found["status"]
        with np.errstate(all="ignore"):
            M, bias, status = inertia_and_bias(self._wrench, self.robot, motion)
            rest = _wrench_of(self.robot, motion, F) - bias
            status = _not_finite(status, np.isfinite(M).all(axis=(-2, -1)) & np.isfinite(rest).all(axis=-1))
            x, definite = solve_positive(M, rest)
            if self.backend == "reference" and self.robot.offsets is None:
                x, definite = self._at_50_digits(motion, F, M, x, definite & (status == OK), status == OK)
            status = np.where((status == OK) & ~definite, MASS_MATRIX_INDEFINITE, status)
            status = _not_finite(status, np.isfinite(x).all(axis=-1))
            x = np.where((status == OK)[..., None], x, np.nan)
        return x[..., :3], x[..., 3:], status

    def _at_50_digits(
        self, motion: Motion, F: Array, M: Array, x: Array, definite: Array, good: Flags
    ) -> tuple[Array, Flags]:
        """x and where M is definite, with 50 digits at the good poses where M has lost digits."""
        faults = inverse_dynamics.faults_of(self.formulation)
        x, known = x.copy(), np.array(definite, dtype=np.bool_)
        for i in map(tuple, np.argwhere(good & _digits_lost(self.robot, motion, M, faults))):
            x[i] = reference_equations.forward_dynamics(self.robot, motion[i], F[i], faults)
            known[i] = np.isfinite(x[i]).all()
        return x, known

    def one_state(self) -> Callable[[Motion, Array], tuple[Array, int]]:
        """``solve`` for loops over single states: (motion, F (6,)) -> [a; alpha] (6,), status.

        What is returned has buffers of its own: one for each thread.
        """
        if isinstance(self.closed, CClosedForm):
            return self.closed.one_state()
        by_forces: ForwardFromInverse | None = None
        if (
            self.backend == "c"
            and self.robot.offsets is not None
            and not self.robot.offsets.has_spinning_parts
        ):
            by_forces = inverse_dynamics.with_compiler(lambda: ForwardFromInverse(self.robot), lambda: None)

        def solve(motion: Motion, F: Array) -> tuple[Array, int]:
            quick = None if by_forces is None else by_forces.solve(motion, F)
            if quick is not None:
                return quick, OK
            a, alpha, status = self.solve(motion, F)
            return np.concatenate([a, alpha]), int(status)

        return solve


def _not_finite(status: Codes, finite: Flags | np.bool_) -> Codes:
    return np.where((status == OK) & ~finite, NOT_FINITE, status).astype(np.int32)


_KEPT = 2.0**-5
"""Digits are lost where elimination leaves less than this share of a diagonal number of M, or where a leg and
its fixed axis make an angle with a smaller sine."""


def _digits_lost(robot: Robot, motion: Motion, M: Array, faults: frozenset[int]) -> Flags:
    """Where double precision loses digits that the machine has, (...): then the reference takes 50."""
    near = newton_euler.legs(robot, _at_rest(motion), faults).sin_joint.min(axis=(-2, -1)) < _KEPT
    return np.asarray(near | ~(digits_kept(M) > _KEPT))


def _by_linearity(robot: Robot, motion: Motion, formulation: str, backend: str) -> EquationsOfMotionResult:
    """The terms drawn from inverse dynamics; the reference's at 50 digits where it loses its own."""
    found = by_linearity(_actuator_wrench(robot, formulation, backend), robot, motion)
    if backend != "reference" or robot.offsets is not None:
        return found
    parts = {name: np.array(getattr(found, name)) for name in _TERMS}
    with np.errstate(all="ignore"):
        lost = (found.status == OK) & _digits_lost(
            robot, motion, found.M, inverse_dynamics.faults_of(formulation)
        )
    for i in map(tuple, np.argwhere(lost)):
        for name, value in reference_equations.at_50_digits(
            robot, motion[i], inverse_dynamics.faults_of(formulation)
        ).items():
            parts[name][i] = value
    return EquationsOfMotionResult(**parts, status=found.status)


def _at_rest(motion: Motion) -> Motion:
    none = np.zeros_like(motion.t)
    return Motion._unchecked(motion.R, motion.t, none, none, none, none)


def digits_kept(M: Array) -> Array:
    """Least share of a diagonal number of M, (..., n, n), that elimination leaves of it, (...)."""
    A, kept = M.copy(), np.full(M.shape[:-2], np.inf)
    for k in range(M.shape[-1]):
        pivot = A[..., k, k, None]
        kept = np.fmin(kept, pivot[..., 0] / M[..., k, k])
        A[..., k + 1 :, :] -= (A[..., k + 1 :, k] / pivot)[..., None] * A[..., k, None, :]
    return np.asarray(kept)


def solve_positive(M: Array, w: Array) -> tuple[Array, Flags]:
    """x of M x = w by Cholesky's method, (..., n), and where M is positive definite, (...); NaN elsewhere."""
    try:
        G = np.linalg.cholesky(M)
        definite = np.ones(M.shape[:-2], dtype=np.bool_)
    except np.linalg.LinAlgError:
        # One bad matrix rejects a whole batch: find out which, and put the unit matrix in its place.
        flat = np.array([_is_positive(matrix) for matrix in M.reshape(-1, *M.shape[-2:])], dtype=np.bool_)
        definite = flat.reshape(M.shape[:-2])
        G = np.linalg.cholesky(np.where(definite[..., None, None], M, np.eye(M.shape[-1])))
    half = np.linalg.solve(G, w[..., None])
    x = np.linalg.solve(np.swapaxes(G, -1, -2), half)[..., 0]
    return np.where(definite[..., None], x, np.nan), definite


def _is_positive(matrix: Array) -> bool:
    try:
        np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        return False
    return True


def _wrench_of(robot: Robot, motion: Motion, F: Array) -> Array:
    """H F + W_ext, (..., 6). NaN where a leg has length zero."""
    if robot.offsets is not None:
        H = offset_joints.terms(robot, _at_rest(motion))["H"]
        return np.asarray(np.einsum("...ij,...j->...i", H, F) + motion.external_wrench())
    q, S, L = leg_vectors(robot, motion.R, motion.t)
    push = S * (F / L)[..., None]
    actuators = np.concatenate([push.sum(axis=-2), cross(q, push).sum(axis=-2)], axis=-1)
    return np.asarray(actuators + motion.external_wrench())


def _actuator_wrench(robot: Robot, formulation: str, backend: str) -> ActuatorWrench:
    """H F = H D - c of any robot that differs from this one in numbers alone."""
    first = inverse_dynamics.prepared_kernel(robot, formulation, backend)
    if robot.offsets is not None:
        return offset_joints.actuator_wrench
    if backend == "reference":
        faults = inverse_dynamics.faults_of(formulation)
        return lambda robot, motion: newton_euler.actuator_wrench(robot, motion, faults)
    kernels: dict[Robot, inverse_dynamics.DynamicsKernel] = {robot: first}

    def wrench(robot: Robot, motion: Motion) -> tuple[Array, Codes]:
        if robot not in kernels:
            kernels[robot] = inverse_dynamics.prepared_kernel(robot, formulation, backend)
        found = kernels[robot].forces(motion)
        return np.einsum("...ij,...j->...i", found.H, found.D) - found.c, found.status

    return wrench


def _closed_form(robot: Robot, formulation: str, backend: str) -> ClosedForm | None:
    """The closed form's kernels where they serve; ValueError for unknown options."""
    option(formulation, FORMULATIONS, "formulation")
    option(backend, ("c", "numpy", "reference"), "backend")
    if formulation != "exact" or robot.base_joint != "universal" or backend == "reference":
        return None
    if robot.offsets is not None:
        return None
    if backend == "numpy":
        return NumpyClosedForm(robot)
    found: ClosedForm = inverse_dynamics.with_compiler(
        lambda: CClosedForm(robot), lambda: NumpyClosedForm(robot)
    )
    return found


def _with_closed_form(robot: Robot, backend: str, on_singular: str) -> ClosedForm:
    """``_closed_form`` where there must be one."""
    option(backend, ("c", "numpy"), "backend")
    option(on_singular, ON_FAULT, "on_singular")
    inverse_dynamics.need_universal(robot)
    closed = _closed_form(robot, "exact", backend)
    assert closed is not None
    return closed


def _together(motion: Motion, F: ArrayLike) -> tuple[Motion, Array]:
    """Motion and forces of one leading shape."""
    forces = real_array(F, "F", "forces of shape (..., 6)")
    if forces.shape[-1:] != (6,):
        raise ValueError(f"F: expected forces of shape (..., 6), got {forces.shape}")
    if not np.isfinite(forces).all():
        raise ValueError(f"F: expected finite forces, got {forces[~np.isfinite(forces)][0]}")
    shape = leading_shape({"motion": motion.shape, "F": forces.shape[:-1]})
    return _broadcast(motion, shape), np.broadcast_to(forces, (*shape, 6))


def _need(robot: Robot, motion: Motion, on_singular: str) -> None:
    instance(robot, Robot, "robot")
    instance(motion, Motion, "motion")
    option(on_singular, ON_FAULT, "on_singular")


def _broadcast(motion: Motion, shape: tuple[int, ...]) -> Motion:
    """The motion, without its accelerations, of a leading shape to which its own broadcasts."""
    lead = len(motion.shape)
    if shape == motion.shape:
        return motion
    wide: dict[str, Any] = {
        # Copies, since products of arrays whose rows are one and the same round in another way.
        name: value if value is None else np.array(np.broadcast_to(value, (*shape, *value.shape[lead:])))
        for name, value in vars(motion).items()
        if name not in ("alpha", "a")
    }
    return Motion._unchecked(**wide)
