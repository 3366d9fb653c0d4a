"""Forward dynamics of a robot that is prepared once, and the mass matrix and bias that it needs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from ..backend.kernel import FORMULATIONS
from ..calls.c_kernel import CKernel, prepared
from ..io.arguments import instance, option
from ..io.array_types import Array, Codes, Flags
from ..kinematics.conditioning import characteristic_length
from ..kinematics.pose_search import rates_per_twist
from ..motion.motion import Motion
from ..reference import newton_euler, offset_joints
from ..reference.equations_of_motion import ActuatorWrench, bare_robot, inertia_and_bias
from ..results import MASS_MATRIX_INDEFINITE, NOT_FINITE, OK
from ..robot.robot import Robot
from . import inverse_dynamics
from .arrays import NumpyClosedForm
from .forces import ForceKernel

ClosedForm = CKernel | NumpyClosedForm
"""Kernels of the closed form: equations of motion, forward dynamics, and derivatives."""

_MOST_CONDITION = 1e5
"""Largest condition number of H^-1 M, scaled by the characteristic length, for an accurate inverse."""


@dataclass(frozen=True, eq=False)
class ForwardDynamics:
    """Robot prepared for repeated evaluation of its forward dynamics, as in a simulation."""

    robot: Robot
    formulation: inverse_dynamics.Formulation = "exact"
    backend: inverse_dynamics.Backend = "c"
    closed: ClosedForm | None = field(init=False, repr=False)
    _wrench: ActuatorWrench = field(init=False, repr=False)

    def __post_init__(self) -> None:
        instance(self.robot, Robot, "robot")
        wrench = actuator_wrench(self.robot, self.formulation, self.backend)
        object.__setattr__(self, "_wrench", wrench)
        object.__setattr__(self, "closed", closed_form_of(self.robot, self.formulation, self.backend))

    def solve(self, motion: Motion, F: Array) -> tuple[Array, Array, Codes]:
        """Compute a, alpha (..., 3) and the status (...) of poses under F (N), shape (..., 6).

        F has the shape of the motion. Values are NaN if the status is not 0; no error is raised.
        """
        if self.closed is not None:
            found = self.closed.run("forward_dynamics", motion, F)
            x = found["acceleration"]
            return x[..., :3], x[..., 3:], found["status"]
        with np.errstate(all="ignore"):
            M, bias, status = inertia_and_bias(self._wrench, self.robot, motion)
            H_T = rates_per_twist(self.robot, motion.R, motion.t, screws=True)
            rest = np.einsum("...ji,...j->...i", H_T, F) + motion.external_wrench() - bias
            status = _not_finite(status, np.isfinite(M).all(axis=(-2, -1)) & np.isfinite(rest).all(axis=-1))
            x, definite = solve_positive(M, rest)
            status = np.where((status == OK) & ~definite, MASS_MATRIX_INDEFINITE, status)
            status = _not_finite(status, np.isfinite(x).all(axis=-1))
            x = np.where((status == OK)[..., None], x, np.nan)
        return x[..., :3], x[..., 3:], status

    def one_state(self) -> Callable[[Motion, Array], tuple[Array, int]]:
        """Return ``solve`` for loops over single states: (motion, F (6,)) -> [a; alpha] (6,), status.

        The returned function owns its buffers. Create one function per thread.
        """
        if isinstance(self.closed, CKernel):
            return _one_state(self.closed)
        by_forces, offsets = None, self.robot.offsets
        if self.backend == "c" and offsets is not None and not offsets.has_spinning_parts:
            by_forces = inverse_dynamics.with_compiler(lambda: from_forces(self.robot), lambda: None)

        def solve(motion: Motion, F: Array) -> tuple[Array, int]:
            quick = None if by_forces is None else by_forces(motion, F)
            if quick is not None:
                return quick, OK
            a, alpha, status = self.solve(motion, F)
            return np.concatenate([a, alpha]), int(status)

        return solve


def _not_finite(status: Codes, finite: Flags | np.bool_) -> Codes:
    return np.where((status == OK) & ~finite, NOT_FINITE, status).astype(np.int32)


def solve_positive(M: Array, w: Array) -> tuple[Array, Flags]:
    """Solve M x = w; return x (..., n) and a mask (...) of positive definite M.

    x is NaN if M is not positive definite.
    """
    size = np.sqrt(np.diagonal(M, axis1=-2, axis2=-1))
    scaled = M / (size[..., :, None] * size[..., None, :])
    finite = np.isfinite(scaled).all(axis=(-2, -1))
    unit = np.eye(M.shape[-1])
    least = np.linalg.eigvalsh(np.where(finite[..., None, None], scaled, unit))[..., 0]
    definite = np.asarray(finite & (least > 0.0))
    x = np.linalg.solve(np.where(definite[..., None, None], scaled, unit), (w / size)[..., None])[..., 0]
    return np.where(definite[..., None], x / size, np.nan), definite


def actuator_wrench(robot: Robot, formulation: str, backend: str) -> ActuatorWrench:
    """Return the function H F = H D - c for robots that differ from this one only in numbers."""
    inverse_dynamics.prepared_kernel(robot, formulation, backend)
    if robot.offsets is not None:
        return offset_joints.actuator_wrench
    if backend == "reference":
        faults = inverse_dynamics.faults_of(formulation)
        return lambda robot, motion: newton_euler.actuator_wrench(robot, motion, faults)

    def wrench(robot: Robot, motion: Motion) -> tuple[Array, Codes]:
        kernel = inverse_dynamics.prepared_kernel(robot, formulation, backend)
        found = kernel.run("inverse_dynamics", motion)
        return np.einsum("...ij,...j->...i", found["H"], found["D"]) - found["c"], found["status"]

    return wrench


def closed_form_of(robot: Robot, formulation: str, backend: str) -> ClosedForm | None:
    """Return the closed-form kernels, or None if they do not apply; ValueError for unknown options."""
    option(formulation, FORMULATIONS, "formulation")
    option(backend, ("c", "numpy", "reference"), "backend")
    if formulation != "exact" or robot.base_joint != "universal" or backend == "reference":
        return None
    if robot.offsets is not None:
        return None
    if backend == "numpy":
        found: ClosedForm = prepared(NumpyClosedForm, robot, np)
    else:
        found = inverse_dynamics.with_compiler(
            lambda: prepared(CKernel, robot, "exact", "_motion"), lambda: prepared(NumpyClosedForm, robot, np)
        )
    return found


def _one_state(closed: CKernel) -> Callable[[Motion, Array], tuple[Array, int]]:
    x = np.empty(6)
    pose = closed.single_pose("forward_dynamics", np.zeros(6), x)

    def solve(motion: Motion, F: Array) -> tuple[Array, int]:
        pose.load(motion)
        pose.F[...] = F
        status = pose.solve()
        return (x.copy() if status == OK else np.full(6, np.nan)), status

    return solve


def from_forces(robot: Robot) -> Callable[[Motion, Array], Array | None]:
    """Return a function (motion, F (6,)) -> [a; alpha] (6,) of single states, None near a singular pose.

    Forces by the C kernel are F_0 + A [a; alpha]. The columns of A = H^-1 M are the forces of six unit
    accelerations at rest, without gravity and friction. F_0 are the forces without acceleration. The function
    owns its buffers. Raises ValueError for a robot without a force kernel.
    """
    moving, still = (ForceKernel(each).single_pose() for each in (robot, bare_robot(robot)))
    length = np.repeat([1.0, 1.0 / characteristic_length(robot)], 3)

    def solve(motion: Motion, F: Array) -> Array | None:
        moving.load(motion)
        moving.alpha[:], moving.a[:] = 0.0, 0.0
        still.R[:], still.t[:] = motion.R, motion.t
        status, A = moving.solve(), np.empty((6, 6))
        for i in range(6):
            part = still.a if i < 3 else still.alpha
            part[i % 3] = 1.0
            status = status or still.solve()
            part[i % 3] = 0.0
            A[:, i] = still.F * length[i]
        if status or not np.isfinite(A).all() or not np.linalg.cond(A) < _MOST_CONDITION:
            return None
        return np.asarray(length * np.linalg.solve(A, F - moving.F))

    return solve
