"""Legs with offset joints in plain vectors: chains of joints, and the forces that their motion needs.

Each leg is a chain: about the fixed axis k, about the moving axis y, along s; where the platform joint is
universal also about s, about the axis on the upper part and about the one on the platform. Rates and
accelerations of its joints follow from the platform's, inertial forces from Newton and Euler, and the forces
at the joints from the power of each joint's rate alone (Kane 1985). Shapes as in ``newton_euler``.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..motion.motion import Motion
from ..results import JOINT_SINGULAR, NOT_FINITE, OK, UNREACHABLE, ZERO_LENGTH, Forces, Reactions
from ..robot.offsets import Offsets
from ..robot.robot import Robot
from .newton_euler import ROUNDING, blank, platform_inertia, platform_wrench, solve_linear

Array = NDArray[np.float64]
Codes = NDArray[np.int32]

_MOST_STEPS = 60
SLIDING, SPIN = 2, 3
"""Joints of a chain, counted from 0: along s, and about it."""


@dataclass(frozen=True, eq=False)
class Chains:
    """Where the joints of the legs are, base frame, from the base points, (..., 6, 3); lengths (..., 6, 1).

    y, s, z, o: axes of the lower part and outward normal; A: where o meets the moving axis; T: end of the
    sliding line; P: platform point; q: P from the reference point. spin: from y to the axis on the upper part.
    of_tip: distance of T along o. U: frame of the upper part. y_w, k_w, o_w: both axes of a universal platform
    joint and their normal, None with spherical ones.
    """

    q: Array
    P: Array
    T: Array
    A: Array
    y: Array
    s: Array
    z: Array
    o: Array
    L: Array
    of_tip: Array
    spin: Array
    U: Array
    y_w: Array | None = None
    k_w: Array | None = None
    o_w: Array | None = None


@dataclass(frozen=True, eq=False)
class _Body:
    """One part: mass, centre from the base point, its acceleration, and rate of angular momentum; with the
    velocity of the centre and the angular velocity by each joint's rate, (..., 6, n, 3)."""

    m: Array
    c: Array
    a: Array
    spun: Array
    v: Array
    I: Array  # noqa: E741
    omega: Array
    v_of: Array
    omega_of: Array


@dataclass(frozen=True, eq=False)
class Legs:
    """Motion of the chains and the forces that it needs.

    rates, accelerations: of the joints, (..., 6, n). G: rates by the platform's twist, (..., 6, n, 6).
    tau: generalised forces of the joints that inertia, weight and friction need, (..., 6, n).
    column: generalised forces of a unit force of the actuator. J: of the end, (..., 6, n, n). f: friction
    moment at the platform joint. bodies: cross, lower and upper part.
    """

    at: Chains
    rates: Array
    accelerations: Array
    G: Array
    J: Array
    tau: Array
    column: Array
    f: Array
    W: Array
    bodies: tuple[_Body, ...]


def inverse_dynamics(robot: Robot, motion: Motion) -> Forces:
    """Actuator forces of a machine with offset joints.

    H has the columns that the rates of the legs' lengths are made with; F = D - x as ever, and K is what of the
    force at the platform joint is not x times the column's force.
    """
    with np.errstate(all="ignore"):
        return _solved(robot, motion)[1]


def joint_reactions(robot: Robot, motion: Motion, bearing: ArrayLike | None = None) -> Reactions:
    """Forces and moments in the joints.

    F_s: on the leg at the platform joint; F_u: on the cross at the fixed axis; M_u: on the lower part at the
    moving axis, along k x y. M_p is about the point at ``bearing`` on the line of sliding, m.
    """
    where = np.broadcast_to(0.0 if bearing is None else np.asarray(bearing), 6)[:, None]
    with np.errstate(all="ignore"):
        legs, forces = _solved(robot, motion)
        at, g = legs.at, robot.g
        wrench = _ends(legs, forces.F)
        F_s, M_s = wrench[..., :3], wrench[..., 3:] if wrench.shape[-1] == 6 else np.zeros(at.P.shape)
        needed = [body.m * (body.a - g) for body in legs.bodies]
        friction = robot.C_p[:, None] * legs.rates[..., SLIDING, None] * at.s
        F_p = needed[2] - F_s + friction
        F_u = sum(needed) - F_s

        def moment(about: Array, bodies: slice) -> Array:
            """What holds these parts' motion and the force at the end, about a point."""
            parts = zip(legs.bodies[bodies], needed[bodies], strict=True)
            own = sum((_cross(body.c - about, force) + body.spun for body, force in parts), np.zeros(3))
            return np.asarray(own - _cross(at.P - about, F_s) - M_s + legs.f)

        M = moment(at.A, slice(1, 3)) + robot.C_u[:, None] * legs.W
        bearing_at = at.T + (where - at.L) * at.s
        bad = forces.status != OK
        return Reactions(
            F_s=blank(F_s, bad),
            F_u=blank(F_u, bad),
            F_p=blank(F_p, bad),
            F_c=blank(F_p - forces.F[..., None] * at.s, bad),
            M_p=blank(moment(bearing_at, slice(2, 3)), bad),
            M_u=blank(_dot(M, _cross(robot.k, at.y))[..., 0], bad),
            status=forces.status,
        )


def actuator_wrench(robot: Robot, motion: Motion) -> tuple[Array, Codes]:
    """Wrench H F = H D - c of the actuators, (..., 6), and status; no equation is solved for it."""
    with np.errstate(all="ignore"):
        _, H, D, _, c, status = _equations(robot, motion)
        return blank(_mul(H, D) - c, status != OK), status


def legs(robot: Robot, motion: Motion) -> Legs:
    """Motion of the chains and generalised forces; NaN where the offsets leave no solution."""
    with np.errstate(all="ignore"):
        return _legs(robot, motion)


def energy(robot: Robot, motion: Motion) -> Array:
    """Kinetic and potential energy of platform, crosses and parts of the legs, J, (...)."""
    with np.errstate(all="ignore"):
        total = np.zeros(motion.shape)
        for body in _legs(robot, _without_accelerations(motion)).bodies:
            kinetic = (body.m * _dot(body.v, body.v) + _dot(body.omega, _mul(body.I, body.omega))) / 2
            total += np.sum(kinetic - body.m * _dot(robot.b + body.c, robot.g), axis=(-2, -1))
        r, I = platform_inertia(robot, motion)  # noqa: E741
        v, omega = motion.v + _cross(motion.omega, r), motion.omega
        own = (robot.M * _dot(v, v) + _dot(omega, _mul(I, omega))) / 2
        return np.asarray(total + (own - robot.M * _dot(motion.t + r, robot.g))[..., 0])


def friction_power(robot: Robot, motion: Motion) -> Array:
    """Power that the friction of the joints takes, W, (...), never negative."""
    with np.errstate(all="ignore"):
        found = _legs(robot, _without_accelerations(motion))
        slip = found.bodies[2].omega - motion.omega[..., None, :]
        power = robot.C_u[:, None] * _dot(found.W, found.W) + robot.C_s[:, None] * _dot(slip, slip)
        return np.asarray(np.sum(power[..., 0] + robot.C_p * found.rates[..., SLIDING] ** 2, axis=-1))


def status_of(robot: Robot, motion: Motion) -> Codes:
    """What is wrong with the first faulty leg of each pose, (...); H is not looked at."""
    with np.errstate(all="ignore"):
        return _status(robot, motion, _chains(robot, motion))


# ---------------------------------------------------------------- where the joints are


def _chains(robot: Robot, motion: Motion) -> Chains:
    offsets = _of(robot)
    q = _mul(motion.R[..., None, :, :], robot.p)
    P = motion.t[..., None, :] + q - robot.b
    if not offsets.spins:
        return _lower(robot, offsets, q, P, P)
    k_w = _mul(motion.R[..., None, :, :], offsets.platform_axis)
    w = offsets.wrist[:, None]
    T, o_w = P, np.zeros_like(P)
    # Each step brings the end of the leg nearer by the wrist's share of the leg's length.
    for _ in range(_MOST_STEPS):
        at = _lower(robot, offsets, q, P, T)
        y_w = _cross(k_w, at.s)
        y_w = y_w / np.sqrt(_dot(y_w, y_w))
        o_w = _cross(y_w, k_w)
        if not w.any():
            break
        T = P - w * o_w
    spin = np.arctan2(_dot(at.z, y_w), _dot(at.y, y_w))
    U = np.stack([at.s, y_w, _cross(at.s, y_w)], axis=-1)
    return Chains(**{**vars(at), "spin": spin, "U": U, "y_w": y_w, "k_w": k_w, "o_w": o_w})


def _lower(robot: Robot, offsets: Offsets, q: Array, P: Array, T: Array) -> Chains:
    """The lower part from the end T of the line of sliding: of the solutions, o towards T and s outward."""
    k = np.broadcast_to(robot.k, T.shape)
    a, d, e = (x[:, None] for x in (offsets.cross, offsets.across, offsets.along))
    zeta, normal = _dot(k, T), _cross(k, T)
    rho2 = _dot(normal, normal)
    of_tip = np.sqrt(rho2 - e * e)
    y = (of_tip * normal + e * (T - zeta * k)) / rho2
    o = _cross(y, k)
    out = of_tip - a
    L = np.sqrt(out * out + zeta * zeta - d * d)
    beside = T - a * o - e * y
    s = (L * beside - d * _cross(beside, y)) / (L * L + d * d)
    z = _cross(s, y)
    U = np.stack([s, y, z], axis=-1)
    return Chains(q, P, T, a * o, y, s, z, o, L, of_tip, np.zeros_like(L), U)


def _status(robot: Robot, motion: Motion, at: Chains) -> Codes:
    reach = np.max(
        np.abs(np.broadcast_arrays(at.q, motion.t[..., None, :], robot.b)), axis=(0, -1), keepdims=False
    )[..., None]
    known = np.isfinite(at.P).all(axis=-1, keepdims=True)
    code = np.where(ROUNDING * reach >= at.L, ZERO_LENGTH, OK)
    code = np.where((code == OK) & (at.of_tip <= ROUNDING * at.L), JOINT_SINGULAR, code)
    lost = ~np.isfinite(at.L) | ~np.isfinite(at.U).all(axis=(-2, -1))[..., None]
    meets = np.sqrt(_dot(_cross(robot.k, at.P), _cross(robot.k, at.P))) <= ROUNDING * reach
    # Without a distance from the fixed axis there is no direction: the same as in legs without offsets.
    along_axis = meets & (_of(robot).along[:, None] == 0.0)
    code = np.where(lost, np.where(along_axis, JOINT_SINGULAR, UNREACHABLE), code)
    codes = np.where(known, code, NOT_FINITE)[..., 0]
    first = np.argmax(codes != OK, axis=-1)[..., None]
    return np.take_along_axis(codes, first, axis=-1)[..., 0].astype(np.int32)


# ---------------------------------------------------------------- how they move


def _legs(robot: Robot, motion: Motion) -> Legs:
    a, alpha = _accelerations(motion)
    offsets, at = _of(robot), _chains(robot, motion)
    omega, alpha = motion.omega[..., None, :], alpha[..., None, :]
    speed = motion.v[..., None, :] + _cross(omega, at.q)
    quick = a[..., None, :] + _cross(alpha, at.q) + _cross(omega, _cross(omega, at.q))
    if offsets.spins:
        speed, quick = (
            np.concatenate([x, np.broadcast_to(turn, x.shape)], axis=-1)
            for x, turn in ((speed, omega), (quick, alpha))
        )
    J = _jacobian(robot, at)
    bad = ~np.isfinite(J).all(axis=(-2, -1)) | (np.linalg.slogdet(np.nan_to_num(J))[0] == 0.0)
    inverse = np.linalg.inv(np.where(bad[..., None, None], np.eye(J.shape[-1]), J))
    inverse[bad] = np.nan
    rates = _mul(inverse, speed)
    drift = _motion_of_end(robot, at, rates, np.zeros_like(rates))
    seconds = _mul(inverse, quick - drift)
    bodies = tuple(_bodies(robot, at, rates, seconds))
    W = bodies[1].omega
    f = robot.C_s[:, None] * (bodies[2].omega - omega)
    tau = sum(
        (_mul(body.v_of, body.m * (body.a - robot.g)) + _mul(body.omega_of, body.spun) for body in bodies),
        np.zeros(1),
    )
    tau = tau + _mul(bodies[1].omega_of, robot.C_u[:, None] * W) + _mul(bodies[2].omega_of, f)
    tau[..., SLIDING] += robot.C_p * rates[..., SLIDING]
    X = np.zeros((*at.P.shape[:-1], J.shape[-1], 6))
    X[..., :3, :3], X[..., :3, 3:] = np.eye(3), -_skew(at.q)
    if offsets.spins:
        X[..., 3:, 3:] = np.eye(3)
    column = np.zeros((6, J.shape[-1]))
    column[:, SLIDING] = 1.0
    return Legs(at, rates, seconds, inverse @ X, J, np.asarray(tau), column, f, W, bodies)


def _jacobian(robot: Robot, at: Chains) -> Array:
    """Velocity of the platform point, and of U-C-U legs the platform's angular velocity, by the joints."""
    k = np.broadcast_to(robot.k, at.s.shape)
    v = [_cross(k, at.P), _cross(at.y, at.P - at.A), at.s]
    if at.y_w is None or at.k_w is None:
        return np.stack(v, axis=-1)
    none = np.zeros_like(at.s)
    v += [_cross(at.s, at.P - at.T), _cross(at.y_w, at.P - at.T), none]
    turns = [k, at.y, none, at.s, at.y_w, at.k_w]
    return np.concatenate([np.stack(v, axis=-1), np.stack(turns, axis=-1)], axis=-2)


def _motion_of_end(robot: Robot, at: Chains, rates: Array, seconds: Array) -> Array:
    """Acceleration of the platform point, and of U-C-U legs the platform's angular one, by the joints'."""
    lower, upper = _lower_motion(robot, at, rates, seconds), _upper_motion(robot, at, rates, seconds)
    if at.y_w is None or at.k_w is None:
        return upper.a + 0.0 * lower.a
    turn = rates[..., 4, None] * at.y_w
    omega = upper.omega + turn
    alpha = upper.alpha + seconds[..., 4, None] * at.y_w + _cross(upper.omega, turn)
    a = upper.a + _swung(omega, alpha, at.P - at.T)
    last = rates[..., 5, None] * at.k_w
    return np.concatenate([a, alpha + seconds[..., 5, None] * at.k_w + _cross(omega, last)], axis=-1)


@dataclass(frozen=True, eq=False)
class _Moving:
    """Motion of a part: angular velocity and acceleration; velocity and acceleration of one of its points."""

    omega: Array
    alpha: Array
    v: Array
    a: Array


def _cross_motion(robot: Robot, at: Chains, rates: Array, seconds: Array) -> _Moving:
    """Of the cross, and where o meets the moving axis."""
    omega, alpha = rates[..., 0, None] * robot.k, seconds[..., 0, None] * robot.k
    return _Moving(omega, alpha, _cross(omega, at.A), _swung(omega, alpha, at.A))


def _lower_motion(robot: Robot, at: Chains, rates: Array, seconds: Array) -> _Moving:
    """Of the lower part, and of that point."""
    cross = _cross_motion(robot, at, rates, seconds)
    turn = rates[..., 1, None] * at.y
    alpha = cross.alpha + seconds[..., 1, None] * at.y + _cross(cross.omega, turn)
    return _Moving(cross.omega + turn, alpha, cross.v, cross.a)


def _upper_motion(robot: Robot, at: Chains, rates: Array, seconds: Array) -> _Moving:
    """Of the upper part, and of the end of the leg."""
    lower = _lower_motion(robot, at, rates, seconds)
    r, slide = at.T - at.A, rates[..., 2, None] * at.s
    v = lower.v + _cross(lower.omega, r) + slide
    a = lower.a + _swung(lower.omega, lower.alpha, r) + 2 * _cross(lower.omega, slide)
    a = a + seconds[..., 2, None] * at.s
    if at.y_w is None:
        return _Moving(lower.omega, lower.alpha, v, a)
    turn = rates[..., SPIN, None] * at.s
    alpha = lower.alpha + seconds[..., SPIN, None] * at.s + _cross(lower.omega, turn)
    return _Moving(lower.omega + turn, alpha, v, a)


def _bodies(robot: Robot, at: Chains, rates: Array, seconds: Array) -> Iterator[_Body]:
    """Cross, lower and upper part."""
    offsets, k = _of(robot), np.broadcast_to(robot.k, at.s.shape)
    none = np.zeros_like(at.s)
    n = rates.shape[-1]
    turns = {0: [k], 1: [k, at.y], 2: [k, at.y, none, at.s][: 4 if n == 6 else 3]}
    lower = np.stack([at.s, at.y, at.z], axis=-1)
    C = np.stack([at.o, at.y, k], axis=-1)
    about_k = offsets.cross_inertia[:, None, None] * np.diag([0.0, 0.0, 1.0])
    parts = (
        (offsets.cross_mass, none, _mul(C, offsets.cross_center), C @ about_k @ _transpose(C), _cross_motion),
        (robot.m_d, at.A, _mul(lower, robot.r_d0), lower @ robot.I_d0 @ _transpose(lower), _lower_motion),
        (robot.m_u, at.T, _mul(at.U, robot.r_u0), at.U @ robot.I_u0 @ _transpose(at.U), _upper_motion),
    )
    for i, (mass, origin, r, I, motion) in enumerate(parts):  # noqa: E741
        moving = motion(robot, at, rates, seconds)
        omega, alpha, c = moving.omega, moving.alpha, origin + r
        # The cross turns about the base point, which rests.
        v, a = (none, none) if i == 0 else (moving.v, moving.a)
        omega_of = np.stack([*turns[i], *[none] * (n - len(turns[i]))], axis=-2)
        arms = [c, c - at.A, c - at.T, c - at.T]
        v_of = np.stack(
            [_cross(turn, arm) for turn, arm in zip(turns[i], arms, strict=False)]
            + [none] * (n - len(turns[i])),
            axis=-2,
        )
        if i == 2:
            v_of[..., SLIDING, :] = at.s
        yield _Body(
            m=mass[:, None],
            c=c,
            a=a + _swung(omega, alpha, r),
            spun=_mul(I, alpha) + _cross(omega, _mul(I, omega)),
            v=v + _cross(omega, r),
            I=I,
            omega=omega,
            v_of=v_of,
            omega_of=omega_of,
        )


# ---------------------------------------------------------------- balance


def _ends(legs: Legs, F: Array) -> Array:
    """Wrench on each leg at the platform joint, (..., 6, n)."""
    right = legs.tau - F[..., None] * legs.column
    J_T = _transpose(legs.J)
    bad = ~np.isfinite(J_T).all(axis=(-2, -1)) | ~np.isfinite(right).all(axis=-1)
    found = np.linalg.solve(np.where(bad[..., None, None], np.eye(J_T.shape[-1]), J_T), right[..., None])
    return np.asarray(found[..., 0])


def _equations(robot: Robot, motion: Motion) -> tuple[Legs, Array, Array, Array, Array, Codes]:
    """The legs, H, D, K (of forces), c and a status that does not assess H."""
    found = _legs(robot, motion)
    H = _transpose(np.einsum("...ij,...ijk->...ik", np.broadcast_to(found.column, found.tau.shape), found.G))
    D = found.tau[..., SLIDING]
    rest = found.tau - D[..., None] * found.column
    of_legs = np.einsum("...ij,...ijk->...k", rest, found.G)
    K = _ends(found, D)[..., :3]
    c = platform_wrench(robot, motion) - of_legs
    c[..., 3:] += np.sum(found.f, axis=-2)
    status = _status(robot, motion, found.at)
    finite = np.isfinite(H).all(axis=(-2, -1)) & np.isfinite(c).all(axis=-1) & np.isfinite(D).all(axis=-1)
    status = np.where((status == OK) & ~finite, NOT_FINITE, status).astype(np.int32)
    return found, H, D, K, c, status


def _solved(robot: Robot, motion: Motion) -> tuple[Legs, Forces]:
    found, H, D, K, c, status = _equations(robot, motion)
    x, status = solve_linear(robot, H, c, status)
    parts = {"F": D - x, "D": D, "x": x, "K": K, "H": H, "c": c}
    bad = status != OK
    return found, Forces(**{name: blank(value, bad) for name, value in parts.items()}, status=status)


def _of(robot: Robot) -> Offsets:
    return Offsets() if robot.offsets is None else robot.offsets


def _accelerations(motion: Motion) -> tuple[Array, Array]:
    if motion.a is None or motion.alpha is None:
        raise ValueError("motion: accelerations expected, but alpha or a is None")
    return motion.a, motion.alpha


def _without_accelerations(motion: Motion) -> Motion:
    none = np.zeros_like(motion.t)
    return Motion.unchecked(motion.R, motion.t, motion.omega, motion.v, none, none)


def _swung(omega: Array, alpha: Array, r: Array) -> Array:
    """Acceleration of a point of a body against another of its points."""
    return _cross(alpha, r) + _cross(omega, _cross(omega, r))


def _skew(v: Array) -> Array:
    x, y, z = v[..., 0], v[..., 1], v[..., 2]
    o = np.zeros_like(x)
    rows = [np.stack(row, axis=-1) for row in ((o, -z, y), (z, o, -x), (-y, x, o))]
    return np.stack(rows, axis=-2)


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.sum(a * b, axis=-1, keepdims=True))


def _cross(a: Array, b: Array) -> Array:
    return np.cross(a, b)


def _mul(A: Array, v: Array) -> Array:
    return np.asarray((A @ v[..., None])[..., 0])


def _transpose(A: Array) -> Array:
    return np.swapaxes(A, -1, -2)
