"""What the dynamics functions return: plain records of arrays, the same for every backend.

Their arrays belong to the caller, who may write to them: nothing else refers to them.
"""

from dataclasses import dataclass
from typing import NamedTuple

from .generated.interface import STATUS
from .io.array_types import Array, Codes

OK, NOT_FINITE, ZERO_LENGTH, JOINT_SINGULAR, SINGULAR, BAD_ARGUMENT, MASS_MATRIX_INDEFINITE, NOT_CONVERGED = (
    code for code, _ in STATUS.values()
)
OUT_OF_LIMITS, UNREACHABLE = 8, 9

STATUS_TEXT = dict(STATUS.values()) | {
    OUT_OF_LIMITS: "a leg length lies outside the robot's length_limits",
    UNREACHABLE: "a platform point lies where no leg with its offsets ends",
}
"""Meaning of each status code, 0 to 7 of the kernels, the rest of forward kinematics and offset joints."""


@dataclass(frozen=True, eq=False)
class InverseDynamicsResult:
    """Inverse dynamics of one or many poses; a leading shape ``(...)`` is that of the motion.

    Attributes
    ----------
    F : ndarray
        Actuator forces, N, (..., 6), positive when they extend the leg, (37).
    D : ndarray
        Known part of the actuator force, N, (..., 6), (24).
    x : ndarray
        Axial force on the leg at its spherical joint, N, (..., 6), (22).
    K : ndarray
        Transverse force on the leg at its spherical joint, N, base frame, (..., 6, 3), (21).
    H : ndarray
        H x = c, (36); F acts on the platform by H F, x by -H x. (..., 6, 6); rows 0-2 unitless, rows 3-5 m.
    c : ndarray
        Wrench that the axial forces must balance, N and N m, base frame, (..., 6), (36).
    status : ndarray of int
        0 where the pose was solved, else a code of ``STATUS_TEXT``; int, (...).
    wrench_error : ndarray, optional
        c - H x, N and N m, (..., 6): by how much the wrench of F exceeds the one that the motion needs. 0
        where H x = c was solved, NaN where the pose is unsolvable; None without damping.
    """

    F: Array
    D: Array
    x: Array
    K: Array
    H: Array
    c: Array
    status: Codes
    wrench_error: Array | None = None


@dataclass(frozen=True, eq=False)
class JointReactionsResult:
    """Joint reactions of one or many poses, base frame; a leading shape ``(...)`` is that of the motion.

    Attributes
    ----------
    F_s : ndarray
        Force on the leg at the spherical joint, N, (..., 6, 3), (21).
    F_u : ndarray
        Force on the leg at the universal joint, N, (..., 6, 3), (27).
    F_p : ndarray
        Force of the lower part on the upper at the prismatic joint, N, (..., 6, 3), (26); without the viscous
        friction -C_p L_dot s, which comes to it.
    F_c : ndarray
        Its constraint part, (28): F_p less s times the actuator's force on the upper part, which is F less
        what turns a rotor of the drive, N, (..., 6, 3).
    M_p : ndarray
        Moment of the lower part, on which the gyroscopic moment of a rotor acts, on the upper at the
        prismatic joint, N m, (..., 6, 3), (17).
    M_u : ndarray
        Constraint moment on the leg at the universal joint, N m, (..., 6), (29), along k x y, y the moving
        axis; in `paper` along the leg.
    status : ndarray of int
        As in ``InverseDynamicsResult``.
    M_s : ndarray, optional
        Constraint moment on the leg at a universal platform joint, about the platform point, N m,
        (..., 6, 3); None where the joint is spherical.
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
    """M [a; alpha] + C [v; omega] + g + friction = H F + W_ext, of one or many poses; (...) is the motion's.

    Wrenches are [force; moment], twists [v; omega], both at the platform's reference point in base axes;
    W_ext = [R F_ext; R M_ext].

    Attributes
    ----------
    M : ndarray
        Inertia matrix, symmetric, (..., 6, 6): kg, kg m and kg m^2 by blocks.
    C : ndarray
        Coriolis matrix, (..., 6, 6): linear in the twist. In `exact` dM/dt = C + C^T.
    g : ndarray
        Wrench that holds the weight of the whole machine at rest, N and N m, (..., 6).
    friction : ndarray
        Wrench that overcomes the friction of the eighteen joints, N and N m, (..., 6).
    bias : ndarray
        C [v; omega] + g, N and N m, (..., 6).
    bias_and_friction : ndarray
        C [v; omega] + g + friction, N and N m, (..., 6).
    status : ndarray of int
        As in ``InverseDynamicsResult``; all else is NaN where it is not 0.
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
    """Actuator forces of inverse dynamics and their derivatives, of one or many poses; (...) is the motion's.

    Rows are legs. Poses move by [dt; dphi], m and rad, base axes, R becoming exp([dphi]x) R.

    Attributes
    ----------
    F : ndarray
        Actuator forces, N, (..., 6).
    by_pose : ndarray
        dF by [dt; dphi], N/m and N, (..., 6, 6), at fixed rates, accelerations, F_ext, M_ext.
    by_twist : ndarray
        dF by [v; omega], N s/m and N s, (..., 6, 6).
    by_acceleration : ndarray
        dF by [a; alpha], kg and kg m, (..., 6, 6): H^-1 M.
    status : ndarray of int
        As in ``InverseDynamicsResult``; all else is NaN where it is not 0.
    """

    F: Array
    by_pose: Array
    by_twist: Array
    by_acceleration: Array
    status: Codes


@dataclass(frozen=True, eq=False)
class LinearizationResult:
    """Forward dynamics and its derivatives, of one or many poses; (...) is the motion's.

    With the state x = [dt; dphi; dv; domega] about the motion, poses moving as in
    ``ForceDerivativesResult``, dx/dt = A x + B dF.

    Attributes
    ----------
    acceleration : ndarray
        [a; alpha] under the given forces, m/s^2 and rad/s^2, (..., 6).
    A : ndarray
        (..., 12, 12), SI units by blocks.
    B : ndarray
        (..., 12, 6).
    status : ndarray of int
        As in ``InverseDynamicsResult``; all else is NaN where it is not 0.
    """

    acceleration: Array
    A: Array
    B: Array
    status: Codes


class Velocities(NamedTuple):
    """Velocities of the platform, base frame, (..., 3): v of the reference point, m/s, and omega, rad/s."""

    v: Array
    omega: Array


class Accelerations(NamedTuple):
    """Accelerations of the platform, base frame, (..., 3): a of the reference point, m/s^2; alpha.

    alpha: rad/s^2.
    """

    a: Array
    alpha: Array


class DampedLeastSquaresResult(NamedTuple):
    """Axial forces x, N, (..., 6), and wrench_error = c - H x, N and N m, (..., 6)."""

    x: Array
    wrench_error: Array
