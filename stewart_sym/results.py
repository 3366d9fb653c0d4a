"""Results of the dynamics functions, identical for every backend, and treatment of unsolvable poses.

The arrays belong to the caller, who may write to them; no other object refers to them.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from .generated.interface import STATUS
from .io.array_types import Array, Codes
from .io.error_policy import warn

OK, NOT_FINITE, ZERO_LENGTH, JOINT_SINGULAR, SINGULAR, BAD_ARGUMENT, MASS_MATRIX_INDEFINITE, NOT_CONVERGED = (
    code for code, _ in STATUS.values()
)
OUT_OF_LIMITS, UNREACHABLE = 8, 9

STATUS_TEXT = dict(STATUS.values()) | {
    OUT_OF_LIMITS: "a leg length is outside the robot's length_limits",
    UNREACHABLE: "a leg with its joint offsets cannot reach its platform point",
}
"""Meaning of each status code: 0 to 7 from kernels, 8 and 9 from forward kinematics and offset joints."""

OnFault = Literal["raise", "warn", "nan"]
ON_FAULT = ("raise", "warn", "nan")
"""Treatments of unsolvable poses."""

Index = tuple[int, ...]


class SingularPoseWarning(UserWarning):
    """Warning of poses without a finite solution; their results are NaN."""


def report_faults(status: Codes, name: str, reason: Callable[[Index], str], choice: str) -> None:
    """Raise ValueError or warn if a status is not 0, as ``choice`` of ON_FAULT specifies.

    ``name`` is the argument with the pose, and ``reason`` returns the reason for the pose at an index.
    """
    if choice == "nan" or not status.any():
        return
    where, text = first_fault(status, reason)
    place = f"{name}[{', '.join(map(str, where))}]" if where else name
    if choice == "raise":
        raise ValueError(f"{place}: {text}")
    warn(f"{place}: {text}", SingularPoseWarning)


def first_fault(status: Codes, reason: Callable[[Index], str]) -> tuple[Index, str]:
    """Return the index of the first status that is not 0, and its reason with the number of the others."""
    where = tuple(int(i) for i in np.argwhere(status)[0])
    more = int(np.count_nonzero(status)) - 1
    return where, f"{reason(where)}; {more} more poses are unsolvable too" if more else reason(where)


@dataclass(frozen=True, eq=False)
class InverseDynamicsResult:
    """Actuator forces of inverse dynamics, with the system H x = c that determines them.

    ``(...)`` is the shape of the motion. Equation numbers refer to Dasgupta and Mruthyunjaya (1998).

    Attributes
    ----------
    F : ndarray, shape (..., 6)
        Actuator forces (N), positive when they extend the leg, (37).
    D : ndarray, shape (..., 6)
        Part of the actuator forces (N) from weight, inertia, and friction of the leg, (24); F = D - x.
    x : ndarray, shape (..., 6)
        Axial forces (N) on the legs at their spherical joints, (22).
    K : ndarray, shape (..., 6, 3)
        Transverse forces (N) on the legs at their spherical joints, base frame, (21).
    H : ndarray, shape (..., 6, 6)
        Matrix of H x = c, (36); rows 0-2 without a unit, rows 3-5 in m. The wrench of F on the platform is H
        F, the wrench of x is -H x.
    c : ndarray, shape (..., 6)
        Wrench (N and N m) that the axial forces must balance, base frame, (36).
    status : ndarray of int, shape (...)
        Status of each pose: 0 if it was solved, otherwise a code of ``STATUS_TEXT``.
    """

    F: Array
    D: Array
    x: Array
    K: Array
    H: Array
    c: Array
    status: Codes


@dataclass(frozen=True, eq=False)
class JointReactionsResult:
    """Forces and moments in the joints of the legs, base frame.

    ``(...)`` is the shape of the motion. Equation numbers refer to Dasgupta and Mruthyunjaya (1998).

    Attributes
    ----------
    F_s : ndarray, shape (..., 6, 3)
        Forces (N) on the legs at the spherical joints, (21).
    F_u : ndarray, shape (..., 6, 3)
        Forces (N) on the legs at the universal joints, (27).
    F_p : ndarray, shape (..., 6, 3)
        Forces (N) of the lower on the upper part at the prismatic joints, (26). The viscous friction -C_p
        L_dot s is not included.
    F_c : ndarray, shape (..., 6, 3)
        Constraint part of F_p (N), (28): F_p minus s times the force of the actuator on the upper part. This
        force is F minus the part of F that accelerates a rotor of the drive.
    M_p : ndarray, shape (..., 6, 3)
        Moments (N m) of the lower on the upper part at the prismatic joints, (17). The gyroscopic moment of a
        rotor acts on the lower part.
    M_u : ndarray, shape (..., 6)
        Constraint moments (N m) on the legs at the universal joints, (29), about k x y, with the moving axis
        y; in formulation `paper` about the leg.
    status : ndarray of int, shape (...)
        Status of each pose, as in ``InverseDynamicsResult``.
    M_s : ndarray, shape (..., 6, 3), optional
        Constraint moments (N m) on the legs at universal platform joints, about the platform points; None for
        spherical joints.
    """

    F_s: Array
    F_u: Array
    F_p: Array
    F_c: Array
    M_p: Array
    M_u: Array
    status: Codes
    M_s: Array | None = None


@dataclass(frozen=True, eq=False)
class EquationsOfMotionResult:
    """Terms of the equations of motion M [a; alpha] + C [v; omega] + g + friction = H F + W_ext.

    ``(...)`` is the shape of the motion. Wrenches are [force; moment] and twists are [v; omega], both at the
    reference point in base axes. W_ext = [R F_ext; R M_ext].

    Attributes
    ----------
    M : ndarray, shape (..., 6, 6)
        Mass matrix, symmetric (blocks in kg, kg m, and kg m^2).
    C : ndarray, shape (..., 6, 6)
        Coriolis matrix, linear in the twist. In formulation `exact`, dM/dt = C + C^T.
    g : ndarray, shape (..., 6)
        Gravity term (N and N m): wrench that balances the weight of the whole machine at rest.
    friction : ndarray, shape (..., 6)
        Wrench (N and N m) that overcomes the friction of the eighteen joints.
    bias : ndarray, shape (..., 6)
        C [v; omega] + g (N and N m).
    bias_and_friction : ndarray, shape (..., 6)
        C [v; omega] + g + friction (N and N m).
    status : ndarray of int, shape (...)
        Status of each pose, as in ``InverseDynamicsResult``; the other values are NaN if it is not 0.
    """

    M: Array
    C: Array
    g: Array
    friction: Array
    bias: Array
    bias_and_friction: Array
    status: Codes


@dataclass(frozen=True, eq=False)
class ForceDerivativesResult:
    """Actuator forces of inverse dynamics and their derivatives.

    ``(...)`` is the shape of the motion. Rows are legs. A pose changes by [dt; dphi] (m and rad, base axes):
    t becomes t + dt, and R becomes exp([dphi]x) R.

    Attributes
    ----------
    F : ndarray, shape (..., 6)
        Actuator forces (N).
    by_pose : ndarray, shape (..., 6, 6)
        Derivatives of F with respect to [dt; dphi] (N/m and N), with constant v, omega, a, alpha, F_ext, and
        M_ext.
    by_twist : ndarray, shape (..., 6, 6)
        Derivatives of F with respect to [v; omega] (N s/m and N s).
    by_acceleration : ndarray, shape (..., 6, 6)
        Derivatives of F with respect to [a; alpha] (kg and kg m), H^-1 M.
    status : ndarray of int, shape (...)
        Status of each pose, as in ``InverseDynamicsResult``; the other values are NaN if it is not 0.
    """

    F: Array
    by_pose: Array
    by_twist: Array
    by_acceleration: Array
    status: Codes


@dataclass(frozen=True, eq=False)
class LinearizationResult:
    """Linear state equations dx/dt = A x + B dF about a motion.

    ``(...)`` is the shape of the motion. The state is x = [dt; dphi; dv; domega], the difference from the
    motion. Poses change as in ``ForceDerivativesResult``.

    Attributes
    ----------
    acceleration : ndarray, shape (..., 6)
        Acceleration [a; alpha] of the platform under the given forces (m/s^2 and rad/s^2).
    A : ndarray, shape (..., 12, 12)
        State matrix, in SI units.
    B : ndarray, shape (..., 12, 6)
        Input matrix, in SI units.
    status : ndarray of int, shape (...)
        Status of each pose, as in ``InverseDynamicsResult``; the other values are NaN if it is not 0.
    """

    acceleration: Array
    A: Array
    B: Array
    status: Codes


class Velocities(NamedTuple):
    """Velocities of the platform, base frame, as a named tuple.

    Attributes
    ----------
    v : ndarray, shape (..., 3)
        Velocity of the reference point (m/s).
    omega : ndarray, shape (..., 3)
        Angular velocity (rad/s).
    """

    v: Array
    omega: Array


class Accelerations(NamedTuple):
    """Accelerations of the platform, base frame, as a named tuple.

    Attributes
    ----------
    a : ndarray, shape (..., 3)
        Acceleration of the reference point (m/s^2).
    alpha : ndarray, shape (..., 3)
        Angular acceleration (rad/s^2).
    """

    a: Array
    alpha: Array
