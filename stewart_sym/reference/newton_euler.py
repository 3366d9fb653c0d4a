"""Reference implementation of the printed equations (1)-(37) and their corrections, in base frame vectors.

The code follows the symbols and the order of the paper, with one line per equation, so that both can be
compared. A fault of the printed equations is a number in `faults`. The set selects the lines that are taken
as printed; the empty set is the correct mechanics.

`(...)` is the leading shape of the motion. Vectors of the legs have the shape (..., 6, 3) and scalars have
(..., 6, 1), so that scalars multiply vectors as in the paper. SI units.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..motion.motion import Motion
from ..motion.rotation import cross as _cross
from ..results import (
    JOINT_SINGULAR,
    NOT_FINITE,
    OK,
    SINGULAR,
    ZERO_LENGTH,
    InverseDynamicsResult,
    JointReactionsResult,
)
from ..robot.offset_chains import applied as _mul
from ..robot.offset_chains import transposed as _transpose
from ..robot.offset_positions import dot as _dot
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot

Array = NDArray[np.float64]
Codes = NDArray[np.int32]

SPIN = 1
"""Fault 1, (6), (8), (9): s.W = 0 and s.A = 0, although the universal joint makes the leg spin."""
MOMENT = 2
"""Fault 2, (17), (19), (20): the constraint moment of the joint is along s instead of n = k x y."""
TRANSPORT = 3
"""Fault 3, (16): m_u L^2 diag(0, 1, 1) in I_u, although m_u r_u x a_u already contains it."""
SIGN = 4
"""Fault 4, (33): + sum K_i, but (35) has - sum K_i."""

EXACT: frozenset[int] = frozenset()
"""Formulation `exact`: no fault."""
PAPER: frozenset[int] = frozenset({SPIN, MOMENT, TRANSPORT})
"""Formulation `paper`: the printed equations, with (35) instead of (33) for the force rows."""

ROUNDING = 16 * np.finfo(np.float64).eps
"""Fraction below which a value is rounding error and counts as zero.

It applies to the length of a leg relative to the terms of S, the sine of its angle with k, and a singular
value of H.
"""


@dataclass(frozen=True, eq=False)
class _Positions:
    """Leg vectors and their rates, (1)-(5), which depend only on the platform."""

    q: Array
    S: Array
    L: Array
    s: Array
    Sdot: Array
    Ldot: Array


@dataclass(frozen=True, eq=False)
class _Turning(_Positions):
    """Rotation of the leg, (6) and (10); `axis` is the direction of M_u, `n` the normal of both axes."""

    T: Array
    y: Array
    n: Array
    axis: Array
    W: Array
    sin_joint: Array


@dataclass(frozen=True, eq=False)
class _Velocities(_Turning):
    """Centers of mass and inertias of the leg parts, (11), (12), (15), and (16)."""

    r_d: Array
    r_u: Array
    I_d: Array
    I_u: Array


@dataclass(frozen=True, eq=False)
class Legs(_Velocities):
    """All quantities of the legs that do not depend on x: adds (7)-(9), (13), (14), (20), (21), (24), (29).

    Base frame; vectors (..., 6, 3), scalars (..., 6, 1), inertias (..., 6, 3, 3). Names are as in the paper.
    F_rotor: force along the leg that accelerates its rotor (N). h_rotor: rate of the rotor's angular momentum
    (N m).
    """

    Lddot: Array
    A: Array
    F_rotor: Array
    h_rotor: Array
    a_d: Array
    a_u: Array
    f: Array
    M_u: Array
    K: Array
    D: Array


def inverse_dynamics(robot: Robot, motion: Motion, faults: frozenset[int] = EXACT) -> InverseDynamicsResult:
    """Compute the actuator forces of a given motion, (1)-(24) and (30)-(37).

    ``robot`` has no offsets; with spherical base joints the legs do not spin, and faults 1 and 2 have no
    effect. ``motion`` has the shape (...). ``faults`` contains the numbers of the printed faults to keep, 1
    to 4; usually it is `EXACT` or `PAPER`.

    Returns an `InverseDynamicsResult`, with NaN if the status of a pose is not 0. Raises ValueError if the
    motion has no accelerations or a fault has an unknown number.
    """
    with np.errstate(all="ignore"):
        return _solve(robot, motion, faults)[1]


def joint_reactions(
    robot: Robot, motion: Motion, faults: frozenset[int] = EXACT, bearing_distance: ArrayLike | None = None
) -> JointReactionsResult:
    """Compute the forces and moments in the joints, (21), (25)-(29), and (17).

    Arguments and errors are as for `inverse_dynamics`. ``bearing_distance`` is the distance (m) along the leg
    from its base point to the point at which M_p is taken, one number or (6,); None is 0.

    Returns a `JointReactionsResult`, base frame. M_u is along s with fault 2, otherwise along n = k x y.
    """
    l = np.broadcast_to(0.0 if bearing_distance is None else np.asarray(bearing_distance), 6)[:, None]  # noqa: E741
    with np.errstate(all="ignore"):
        leg, forces = _solve(robot, motion, faults)
        g, s = robot.g, leg.s
        m_d, m_u = robot.m_d[:, None], robot.m_u[:, None]
        C_u, C_p = robot.C_u[:, None], robot.C_p[:, None]
        F, x = forces.F[..., None], forces.x[..., None]
        r = l * s

        F_s = x * s + leg.K  # (21)
        F_p = m_u * (leg.a_u - g) - F_s + C_p * leg.Ldot * s  # (26)
        F_u = m_d * leg.a_d + m_u * leg.a_u - (m_d + m_u) * g - F_s  # (27)
        F_c = F_p - s * (F - leg.F_rotor)  # (28)
        M_p = (  # (17)
            -m_d * _cross(leg.r_d, leg.a_d)
            + m_d * _cross(leg.r_d, g)
            - _mul(leg.I_d, leg.A)
            - _cross(leg.W, _mul(leg.I_d, leg.W))
            - leg.h_rotor
            + leg.M_u * leg.axis
            - _cross(r, F_p)
            - C_u * leg.W
        )
        found = {"F_s": F_s, "F_u": F_u, "F_p": F_p, "F_c": F_c, "M_p": M_p, "M_u": leg.M_u[..., 0]}
        return JointReactionsResult(**with_status(found, forces.status))


def actuator_wrench(robot: Robot, motion: Motion, faults: frozenset[int] = EXACT) -> tuple[Array, Codes]:
    """Compute the wrench H F = H D - c of the actuators for a motion, (..., 6), and the status.

    Arguments and errors are as for `inverse_dynamics`. No system is solved, so the wrench also exists if H is
    singular. It is NaN if the status, (...), is not 0.
    """
    with np.errstate(all="ignore"):
        leg, H, c, status = _equations(robot, motion, faults)
        wrench = _mul(H, leg.D[..., 0]) - c
        return blank(wrench, status != OK), status


def rotor_force(robot: Robot, motion: Motion) -> Array:
    """Compute the part of the actuator forces (N), (..., 6), that accelerates the rotors."""
    with np.errstate(all="ignore"):
        leg = _turning(robot, motion, EXACT)
        Lddot, A = _seconds(robot, motion, leg, EXACT)
        return _rotor_force(robot, leg, Lddot, A)[..., 0]


def massless_forces(robot: Robot, motion: Motion) -> Array:
    """Compute the actuator forces F0 (N), (..., 6), for massless legs and joints without friction, (41).

    NaN if H is singular or a leg has length zero. Raises ValueError without accelerations.
    """
    with np.errstate(all="ignore"):
        leg = _positions(robot, motion)
        H = _H(leg)
        c_0 = platform_wrench(robot, motion)
        status = status_of_legs(_leg_faults(robot, motion, leg), all_finite(H, 2) & all_finite(c_0, 1))
        return -solve_linear(robot, H, c_0, status)[0]


def energy(robot: Robot, motion: Motion) -> Array:
    """Compute the kinetic and potential energy (J), (...), of the platform, the leg parts, and the rotors.

    The kinematics of the legs is always exact. The potential energy is zero at the origin of the base frame.
    NaN if the direction or the spin of a leg is undefined.
    """
    with np.errstate(all="ignore"):
        leg = _velocities(robot, motion)
        W = leg.W
        v_d = _cross(W, leg.r_d)
        v_u = leg.Ldot * leg.s + _cross(W, leg.r_u)
        kinetic_legs = (
            robot.m_d[:, None] * _dot(v_d, v_d)
            + robot.m_u[:, None] * _dot(v_u, v_u)
            + _dot(W, _mul(leg.I_d, W))
            + _dot(W, _mul(leg.I_u, W))
            + robot.reflected_mass[:, None] * leg.Ldot**2
        ) / 2 + robot.rotor_momentum[:, None] * leg.Ldot * _dot(W, leg.s)
        potential_legs = -_dot(
            robot.m_d[:, None] * (robot.b + leg.r_d) + robot.m_u[:, None] * (robot.b + leg.r_u), robot.g
        )
        total = np.sum(kinetic_legs + potential_legs, axis=(-2, -1)) + platform_energy(robot, motion)
        return blank(total, ~np.isfinite(total))


def friction_power(robot: Robot, motion: Motion) -> Array:
    """Compute the power (W), (...), that friction in the eighteen joints dissipates; it is never negative.

    The kinematics of the legs is always exact. NaN if the direction or the spin of a leg is undefined.
    """
    with np.errstate(all="ignore"):
        leg = _velocities(robot, motion)
        slip = leg.W - motion.omega[..., None, :]
        power = (
            robot.C_u[:, None] * _dot(leg.W, leg.W)
            + robot.C_p[:, None] * leg.Ldot**2
            + robot.C_s[:, None] * _dot(slip, slip)
        )
        total: Array = np.sum(power, axis=(-2, -1))
        return blank(total, ~np.isfinite(total))


def actuator_power(robot: Robot, motion: Motion, F: ArrayLike) -> Array:
    """Compute the power (W), (...), of the actuator forces F (N), (..., 6)."""
    with np.errstate(all="ignore"):
        Ldot = _positions(robot, motion).Ldot[..., 0]
        return np.asarray(np.sum(np.asarray(F, dtype=np.float64) * Ldot, axis=-1))


def external_power(robot: Robot, motion: Motion) -> Array:
    """Compute the power (W), (...), of the external load F_ext, M_ext; zero without a load."""
    F, M = _load(motion)
    return (_dot(F, motion.v) + _dot(M, motion.omega))[..., 0]


def _positions(robot: Robot, motion: Motion) -> _Positions:
    need_no_offsets(robot)
    q = _mul(motion.R[..., None, :, :], robot.p)  # (1)
    S = motion.t[..., None, :] + q - robot.b  # (2)
    L = np.sqrt(_dot(S, S))
    s = S / L  # (3)
    Sdot = _cross(motion.omega[..., None, :], q) + motion.v[..., None, :]  # (4)
    Ldot = _dot(s, Sdot)  # (5)
    return _Positions(q=q, S=S, L=L, s=s, Sdot=Sdot, Ldot=Ldot)


def _turning(robot: Robot, motion: Motion, faults: frozenset[int]) -> _Turning:
    leg = _positions(robot, motion)
    s, L = leg.s, leg.L
    spherical = robot.base_joint == "spherical"

    # A leg between two spherical joints is axisymmetric, so y may be any vector perpendicular to s.
    k = np.eye(3)[np.argmin(np.abs(s), axis=-1)] if spherical else np.broadcast_to(robot.k, s.shape)
    k_x_s = _cross(k, s)
    sin_joint = np.sqrt(_dot(k_x_s, k_x_s))
    y = k_x_s / sin_joint
    z = _cross(s, y)
    T = np.stack([s, y, z], axis=-1)  # (10)
    n = _cross(k, y)
    if spherical:
        axis = np.zeros_like(s)
    elif MOMENT in faults:
        axis = s
    else:
        axis = n

    W = _cross(s, leg.Sdot) / L  # (6)
    if not spherical and SPIN not in faults:
        W = W - _dot(W, n) / _dot(s, n) * s  # (6) corrected: W.n = 0
    return _Turning(**vars(leg), T=T, y=y, n=n, axis=axis, W=W, sin_joint=sin_joint)


def _velocities(robot: Robot, motion: Motion, faults: frozenset[int] = EXACT) -> _Velocities:
    leg = _turning(robot, motion, faults)
    T, L = leg.T, leg.L
    r_d = _mul(T, robot.r_d0)  # (11)
    v = L * np.array([1.0, 0.0, 0.0])
    r_u = _mul(T, v + robot.r_u0)  # (12)
    I_u0 = np.broadcast_to(robot.I_u0, T.shape)
    if TRANSPORT in faults:
        I_u0 = I_u0 + (robot.m_u[:, None] * L**2)[..., None] * np.diag([0.0, 1.0, 1.0])
    I_d = T @ robot.I_d0 @ _transpose(T)  # (15)
    I_u = T @ I_u0 @ _transpose(T)  # (16)
    return _Velocities(**vars(leg), r_d=r_d, r_u=r_u, I_d=I_d, I_u=I_u)


def _seconds(robot: Robot, motion: Motion, leg: _Turning, faults: frozenset[int]) -> tuple[Array, Array]:
    """Compute Lddot and A, (7)-(9)."""
    a, alpha = _accelerations(motion)
    s, L, Ldot, W, q, n = leg.s, leg.L, leg.Ldot, leg.W, leg.q, leg.n
    omega, alpha = motion.omega[..., None, :], alpha[..., None, :]
    Sddot = _cross(alpha, q) + _cross(omega, _cross(omega, q)) + a[..., None, :]  # (7)
    W_s = _dot(s, W)  # 0 as printed, in (8) and (9)
    W_t = W - W_s * s
    Lddot = _dot(s, Sddot) + L * _dot(W_t, W_t)  # (8)
    A = (_cross(s, Sddot) - 2 * Ldot * W_t) / L - W_s * _cross(s, W)  # (9)
    if robot.base_joint != "spherical" and SPIN not in faults:
        ndot = _cross(robot.k, _cross(W, leg.y))
        A = A - (_dot(A, n) + _dot(W, ndot)) / _dot(s, n) * s  # (9) corrected: d/dt (W.n) = 0
    return Lddot, A


def _rotor_force(robot: Robot, leg: _Turning, Lddot: Array, A: Array) -> Array:
    return robot.reflected_mass[:, None] * Lddot + robot.rotor_momentum[:, None] * _dot(leg.s, A)


@np.errstate(all="ignore")
def legs(robot: Robot, motion: Motion, faults: frozenset[int] = EXACT) -> Legs:
    """Compute the motion, inertia, and known forces of the six legs, (1)-(24) and (29).

    Arguments and errors are as for `inverse_dynamics`. There is no status: undefined values are NaN or
    infinite. Arrays may contain numbers of any type, such as mpmath numbers.
    """
    if not faults <= {SPIN, MOMENT, TRANSPORT, SIGN}:
        raise ValueError(f"faults: expected numbers from 1 to 4, got {sorted(faults)}")
    leg = _velocities(robot, motion, faults)
    Lddot, A = _seconds(robot, motion, leg, faults)
    s, L, Ldot, W = leg.s, leg.L, leg.Ldot, leg.W
    g = robot.g
    m_d, m_u = robot.m_d[:, None], robot.m_u[:, None]
    spherical = robot.base_joint == "spherical"

    a_d = _cross(A, leg.r_d) + _cross(W, _cross(W, leg.r_d))  # (13)
    a_u = (  # (14)
        Lddot * s + _cross(A, leg.r_u) + _cross(W, _cross(W, leg.r_u)) + 2 * Ldot * _cross(W, s)
    )
    f = robot.C_s[:, None] * (W - motion.omega[..., None, :])  # friction in (18)
    I_du = leg.I_d + leg.I_u
    F_rotor = _rotor_force(robot, leg, Lddot, A)
    h_rotor = robot.rotor_momentum[:, None] * (Lddot * s + Ldot * _cross(W, s))
    C = (  # right side of (20)
        m_d * _cross(leg.r_d, a_d)
        + m_u * _cross(leg.r_u, a_u)
        - _cross(m_d * leg.r_d + m_u * leg.r_u, g)
        + _mul(I_du, A)
        + _cross(W, _mul(I_du, W))
        + h_rotor
        + robot.C_u[:, None] * W
        + f
    )
    # (29) is the scalar product of s and M_u axis + S x F_s = C, (20); (21) is the vector product.
    M_u = np.zeros_like(L) if spherical else _dot(s, C) / _dot(s, leg.axis)
    K = _cross(C - M_u * leg.axis, s) / L
    D = m_u * _dot(s, a_u - g) + robot.C_p[:, None] * Ldot + F_rotor  # (24)
    moving = {"Lddot": Lddot, "A": A, "a_d": a_d, "a_u": a_u, "F_rotor": F_rotor, "h_rotor": h_rotor}
    return Legs(**vars(leg), **moving, f=f, M_u=M_u, K=K, D=D)


def _solve(robot: Robot, motion: Motion, faults: frozenset[int]) -> tuple[Legs, InverseDynamicsResult]:
    """Compute the legs, then solve the six equations of the platform, (33)-(37)."""
    leg, H, c, status = _equations(robot, motion, faults)
    x, status = solve_linear(robot, H, c, status)  # (36)
    D = leg.D[..., 0]
    F = D - x  # (37)
    return leg, InverseDynamicsResult(
        **with_status({"F": F, "D": D, "x": x, "K": leg.K, "H": H, "c": c}, status)
    )


def _equations(robot: Robot, motion: Motion, faults: frozenset[int]) -> tuple[Legs, Array, Array, Codes]:
    """Compute the legs, H and c of (36), and a status that does not depend on the rank of H."""
    leg, H, c = balance(robot, motion, faults)
    D, K = leg.D[..., 0], leg.K
    faults_of_legs = _leg_faults(robot, motion, leg)
    joint_singular = (faults_of_legs == OK) & ~(leg.sin_joint[..., 0] > ROUNDING)
    finite = all_finite(H, 2) & all_finite(c, 1) & all_finite(D, 1) & all_finite(K, 2)
    return leg, H, c, status_of_legs(np.where(joint_singular, JOINT_SINGULAR, faults_of_legs), finite)


def balance(robot: Robot, motion: Motion, faults: frozenset[int] = EXACT) -> tuple[Legs, Array, Array]:
    """Compute the legs, and H and c of (36), without checks."""
    leg = legs(robot, motion, faults)
    sum_K = np.sum(leg.K, axis=-2)
    sum_qK_f = np.sum(_cross(leg.q, leg.K) - leg.f, axis=-2)

    force_rows = sum_K if SIGN in faults else -sum_K  # (33) as printed, else (35)
    c = platform_wrench(robot, motion) + np.concatenate([force_rows, -sum_qK_f], axis=-1)  # (35)
    return leg, _H(leg), c


def _H(leg: _Positions) -> Array:
    """Compute H of (36), (..., 6, 6): row blocks s and q x s, one column per leg."""
    return _transpose(np.concatenate([leg.s, _cross(leg.q, leg.s)], axis=-1))


def platform_inertia(robot: Robot, motion: Motion) -> tuple[Array, Array]:
    """Compute the center of mass relative to the reference point, and the inertia, in base axes."""
    R = _mul(motion.R, robot.R_0)  # (30)
    I = motion.R @ robot.I_p @ _transpose(motion.R)  # (32)  # noqa: E741
    return R, I


def platform_energy(robot: Robot, motion: Motion) -> Array:
    """Compute the kinetic and potential energy of the platform (J), (...)."""
    omega = motion.omega
    R, I = platform_inertia(robot, motion)  # noqa: E741
    v = motion.v + _cross(omega, R)
    kinetic = (robot.M * _dot(v, v) + _dot(omega, _mul(I, omega))) / 2
    return np.asarray((kinetic - robot.M * _dot(motion.t + R, robot.g))[..., 0])


def platform_wrench(robot: Robot, motion: Motion) -> Array:
    """Compute c_0 of (41), (..., 6): the wrench without mass and friction of the legs."""
    a_t, alpha = _accelerations(motion)
    omega, g, M = motion.omega, robot.g, robot.M
    R, I = platform_inertia(robot, motion)  # noqa: E741
    F_ext, M_ext = _load(motion)
    a = _cross(alpha, R) + _cross(omega, _cross(omega, R)) + a_t  # (31)
    force = F_ext + M * (g - a)  # (33)
    moment = M * _cross(R, g - a) - _mul(I, alpha) - _cross(omega, _mul(I, omega)) + M_ext  # (34)
    return np.concatenate([force, moment], axis=-1)


def _load(motion: Motion) -> tuple[Array, Array]:
    """Return the external force and moment in the base frame, (..., 3) each."""
    none = np.zeros_like(motion.t)
    F = none if motion.F_ext is None else _mul(motion.R, motion.F_ext)
    M = none if motion.M_ext is None else _mul(motion.R, motion.M_ext)
    return F, M


def _accelerations(motion: Motion) -> tuple[Array, Array]:
    if motion.a is None or motion.alpha is None:
        raise ValueError("motion: accelerations expected, but alpha or a is None")
    return motion.a, motion.alpha


def _leg_faults(robot: Robot, motion: Motion, leg: _Positions) -> Codes:
    """Return codes of the legs, (..., 6), for lengths that overflow or are rounding errors of (2)."""
    L = leg.L[..., 0]
    reach = np.max(np.abs(np.broadcast_arrays(leg.q, motion.t[..., None, :], robot.b)), axis=(0, -1))
    return np.where(np.isfinite(L), np.where(ROUNDING * reach >= L, ZERO_LENGTH, OK), NOT_FINITE)


def status_of_legs(faults_of_legs: Codes, finite: NDArray[np.bool_]) -> Codes:
    """Return the status of each pose: the code of the first faulty leg, else whether all is finite."""
    first = np.argmax(faults_of_legs != OK, axis=-1)[..., None]
    of_legs = np.take_along_axis(faults_of_legs, first, axis=-1)[..., 0]
    return np.where((of_legs == OK) & ~finite, NOT_FINITE, of_legs).astype(np.int32)


def solve_linear(robot: Robot, H: Array, c: Array, status: Codes) -> tuple[Array, Codes]:
    """Solve H x = c at poses with status 0, with NaN at the others; return x and the new status."""
    x = np.full_like(c, np.nan)
    status = status.copy()
    ok = status == OK
    status[ok] = np.where(is_singular(robot, H[ok]), SINGULAR, OK)
    ok = status == OK
    x[ok] = np.linalg.solve(H[ok], c[ok][..., None])[..., 0]
    status[ok & ~all_finite(x, 1)] = NOT_FINITE
    return x, status


def is_singular(robot: Robot, H: Array) -> NDArray[np.bool_]:
    """Return a mask (...) of H, (..., 6, 6), that are singular to rounding, with scaled moments."""
    length = np.linalg.norm(robot.p, axis=-1).max() or 1.0
    sigma = np.linalg.svd(H / np.repeat([1.0, length], 3)[:, None], compute_uv=False)
    # `solve` rejects a whole batch for one zero pivot; slogdet, the same elimination, finds the pose.
    return np.asarray((sigma[..., -1] <= ROUNDING * sigma[..., 0]) | (np.linalg.slogdet(H)[0] == 0))


def all_finite(value: Array, axes: int) -> NDArray[np.bool_]:
    """Return True if all numbers along the last `axes` axes are finite."""
    return np.asarray(np.all(np.isfinite(value), axis=tuple(range(-axes, 0))))


def blank(value: Array, bad: NDArray[np.bool_]) -> Array:
    """Replace `value` by NaN at the bad poses."""
    return np.where(bad.reshape(bad.shape + (1,) * (value.ndim - bad.ndim)), np.nan, value)


def without_overflow(found: dict[str, Array], status: Codes) -> Codes:
    """Replace status 0 by NOT_FINITE if a value of the pose is not finite."""
    finite = [all_finite(value, value.ndim - status.ndim) for value in found.values()]
    return np.where((status == OK) & ~np.logical_and.reduce(finite), NOT_FINITE, status).astype(np.int32)


def with_status(found: dict[str, Array], status: Codes) -> dict[str, Any]:
    """Return the results by name, NaN if the status is not 0, and the status."""
    return {name: blank(value, status != OK) for name, value in found.items()} | {"status": status}
