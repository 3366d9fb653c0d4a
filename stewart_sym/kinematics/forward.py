"""Forward kinematics: pose, velocity and acceleration of the platform from those of its legs, (2), (5), (8).

Six leg lengths belong to up to forty poses, the assembly modes: which one is found depends on where the
search starts.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io import error_policy
from ..io.arguments import finite_array, instance, leading_shape, option, truth
from ..io.error_policy import ON_FAULT, OnFault
from ..motion.motion import Motion
from ..motion.rotation import (
    cross,
    orthonormal,
    rotation_from_quaternion,
    rotation_from_vector,
    vector_from_rotation,
)
from ..results import (
    NOT_CONVERGED,
    NOT_FINITE,
    OK,
    OUT_OF_LIMITS,
    SINGULAR,
    STATUS_TEXT,
    Accelerations,
    Velocities,
)
from ..robot.robot import Robot
from .conditioning import characteristic_length, condition_number, moments_over
from .inverse import ROUNDING, leg_vectors, legs_or_overflow
from .mounting import base_normal, upright

Array = NDArray[np.float64]
Status = NDArray[np.int32]
Poses = tuple[Array, Array]
Guess = tuple[ArrayLike, ArrayLike]

REASONS = STATUS_TEXT | {SINGULAR: "H is singular there: leg lengths and rates do not settle the platform's"}
"""One line for each status code of forward kinematics."""

_EPS = float(np.finfo(np.float64).eps)
# The search ends below this share of the terms of S; what counts as found is ROUNDING.
_GOAL = 4 * _EPS
_MOST_STEPS = 100
# Damping is added to J^T J, whose trace is about 12.
_FIRST_DAMPING, _LEAST_DAMPING, _MOST_DAMPING = 1e-6, 1e-14, 1e3
# Lengths known to rounding tell two assembly modes apart only if they lie sqrt(eps) from a singular pose.
_MOST_CONDITION = 1.0 / (16.0 * math.sqrt(_EPS))
# Turns about the base's normal, rad, from which the search starts when the first two poses were no good.
_MORE_TURNS = (0.5, -0.5, 1.0, -1.0)
# Most of a short step: rad, and share of the longest leg.
_SHORT = 0.1
# Starts after which the search is given up: without a guess, and about one.
_MOST_STARTS, _MOST_ABOUT = 100, 20
# Lengths whose starts are tried all at once.
_AT_ONCE = 64
# Share of the platform's size by which lengths all but met are missed.
_ALMOST = 1e-6


@dataclass(frozen=True, eq=False)
class PlatformPose:
    """Poses found from leg lengths; a leading shape ``(...)`` is that of the lengths and the guess.

    Attributes
    ----------
    R : ndarray
        Orientation, platform to base, (..., 3, 3).
    t : ndarray
        Position of the reference point, m, (..., 3). Both are nan where the status is not 0.
    residual : ndarray
        Largest difference between the lengths asked for and those of the last pose tried, m, (...).
    iterations : ndarray of int
        Steps taken, those from starts that led nowhere included; int, (...).
    status : Status
        ``results.OK``, NOT_CONVERGED, SINGULAR (lengths fit, but the pose is not settled by them) or
        OUT_OF_LIMITS; int, (...).
    """

    R: Array
    t: Array
    residual: Array
    iterations: NDArray[np.int64]
    status: Status


def forward_kinematics(
    robot: Robot,
    L: ArrayLike,
    guess: Guess | None = None,
    on_failure: OnFault = "raise",
    limits: bool = True,
) -> PlatformPose:
    """Return the poses in which the legs have the lengths L, by damped Newton steps on (2).

    A pose with status 0 has lengths within 16 rounding units of the largest component of the terms of S = q +
    t - b. Of the assembly modes found from a guess it is the one nearest to it, angles counted times the
    platform's size. Where none is found, the error says what was tried, or why there is none.

    Parameters
    ----------
    robot : Robot
        The machine.
    L : array_like
        m, (..., 6).
    guess : Guess, optional
        Pose (R, t) to start from, (..., 3, 3) and (..., 3); None: about parallel to the base and on the side
        of it that ``platform_side`` tells, against gravity; where that leads nowhere, other such poses, and
        in the end the other side.
    on_failure : {"raise", "nan", "warn"}, optional
        What to do about lengths without a pose: "raise" ValueError, "warn" and return nan there, or return
        "nan" silently; ``status`` tells.
    limits : bool, optional
        Whether lengths outside the robot's length_limits count as a failure.

    Returns
    -------
    PlatformPose
        Poses, residuals, iterations and statuses.

    Raises
    ------
    ValueError
        Naming the argument for lengths that are not > 0 and finite, and for a guess that is no pose.
    """
    instance(robot, Robot, "robot")
    option(on_failure, ON_FAULT, "on_failure")
    truth(limits, "limits")
    lengths = checked_lengths(L)
    shape = lengths.shape[:-1]
    if guess is None:
        flat = lengths.reshape(-1, 6)
        R, t, residual, iterations, found = _search(robot, flat)
    else:
        start = _checked_guess(guess)
        shape = leading_shape({"L": shape, "guess": start.shape})
        flat = np.broadcast_to(lengths, (*shape, 6)).reshape(-1, 6)
        R_0, t_0 = np.broadcast_to(start.R, (*shape, 3, 3)), np.broadcast_to(start.t, (*shape, 3))
        R, t, residual, iterations, found = _nearest(robot, flat, R_0.reshape(-1, 3, 3), t_0.reshape(-1, 3))
    status = np.full(len(flat), NOT_CONVERGED)
    status[found] = np.where(_unsettled(robot, R[found], t[found]), SINGULAR, OK)
    if limits:
        low, high = robot.length_limits.T
        status = np.where(np.any((flat < low) | (flat > high), axis=-1), OUT_OF_LIMITS, status)
    bad = status != OK
    R[bad], t[bad] = np.nan, np.nan
    result = PlatformPose(
        R.reshape(*shape, 3, 3),
        t.reshape(*shape, 3),
        residual.reshape(shape),
        iterations.reshape(shape),
        status.astype(np.int32).reshape(shape),
    )

    def describe() -> tuple[tuple[int, ...], str]:
        where, others = error_policy.first(result.status)
        leg_lengths = np.broadcast_to(lengths, (*shape, 6))[where]
        return where, fault(robot, leg_lengths, int(result.status[where]), guess is not None) + others

    error_policy.report(result.status, "L", describe, on_failure, stacklevel=3)
    return result


def fault(robot: Robot, L: Array, status: int, guessed: bool) -> str:
    """Return in words why lengths (6,) have no pose, by the status: proven, or how far was looked for one."""
    if status != NOT_CONVERGED:
        return REASONS[status]
    pairs = np.argwhere(_impossible_pairs(robot, L))
    if len(pairs):
        one, other = (int(leg) + 1 for leg in pairs[0])
        return f"{REASONS[status]}: none exists, legs {one} and {other} cannot have theirs at once"
    tried = "from the guess and about it" if guessed else f"from {_MOST_STARTS} starts"
    return f"{REASONS[status]} {tried}, which does not prove that there is none"


def forward_velocity(
    robot: Robot, R: ArrayLike, t: ArrayLike, L_dot: ArrayLike, on_failure: OnFault = "raise"
) -> Velocities:
    """Return (v, omega), a named tuple, m/s and rad/s, (..., 3), base frame: L_dot = H^T [v; omega], (5).

    Parameters
    ----------
    robot : Robot
        The machine.
    R, t : array_like
        Pose, (..., 3, 3) and (..., 3).
    L_dot : array_like
        Rates of the legs, m/s, (..., 6).
    on_failure : {"raise", "nan", "warn"}, optional
        As in ``forward_kinematics``, about poses where H is singular or the result overflows.

    Returns
    -------
    Velocities
        Named tuple (v, omega), m/s and rad/s, (..., 3).

    Raises
    ------
    ValueError
        Naming the argument; as ``inverse_kinematics`` for a leg of length zero.
    """
    still = np.zeros(3)
    return Velocities(*_rates(robot, R, t, (still, still), L_dot, "L_dot", on_failure))


def forward_acceleration(
    robot: Robot,
    R: ArrayLike,
    t: ArrayLike,
    v: ArrayLike,
    omega: ArrayLike,
    L_ddot: ArrayLike,
    on_failure: OnFault = "raise",
) -> Accelerations:
    """Return (a, alpha), a named tuple, m/s^2 and rad/s^2, (..., 3), base frame.

    L_ddot = H^T [a; alpha] + what the velocities alone make of it, (8).

    Parameters
    ----------
    robot : Robot
        The machine.
    R : array_like
        Orientation, platform to base, (..., 3, 3).
    t : array_like
        Position of the reference point, m, (..., 3).
    v, omega : array_like
        Of the platform, m/s and rad/s, (..., 3).
    L_ddot : array_like
        Accelerations of the legs, m/s^2, (..., 6). The rest as in ``forward_velocity``.
    on_failure : {"raise", "nan", "warn"}, optional
        What to do about lengths without a pose: raise, return NaN, or warn and return NaN.

    Returns
    -------
    Accelerations
        Named tuple (a, alpha), m/s^2 and rad/s^2, (..., 3).
    """
    return Accelerations(*_rates(robot, R, t, (v, omega), L_ddot, "L_ddot", on_failure))


def checked_lengths(L: ArrayLike) -> Array:
    """Return L, (..., 6), as float64; ValueError unless they are finite and > 0."""
    lengths = finite_array(L, (6,), "L")
    if np.any(lengths <= 0.0):
        where = tuple(int(i) for i in np.argwhere(lengths <= 0.0)[0])
        raise ValueError(f"L: expected lengths > 0 m, entry {where} is {lengths[where]}")
    return lengths


def jacobian(robot: Robot, R: Array, t: Array) -> Array:
    """Return J = H^T, (..., 6, 6): rows [s^T, (q x s)^T] take the twist [v; omega] to L_dot, (5)."""
    return _rows(*leg_vectors(robot, R, t))


# Rates


def _rates(
    robot: Robot,
    R: ArrayLike,
    t: ArrayLike,
    twist: tuple[ArrayLike, ArrayLike],
    rates: ArrayLike,
    name: str,
    on_failure: str,
) -> tuple[Array, Array]:
    """Solve (5) or (8) for the highest derivatives; ``twist``: what the velocities are, 0 for (5)."""
    instance(robot, Robot, "robot")
    option(on_failure, ON_FAULT, "on_failure")
    v, omega = twist
    motion = Motion(R, t, omega, v, np.zeros(3), np.zeros(3))  # type: ignore[arg-type]
    wanted = finite_array(rates, (6,), name)
    shape = leading_shape({"R": motion.shape, name: wanted.shape[:-1]})
    with np.errstate(over="ignore", invalid="ignore"):
        # Without accelerations of the platform, what remains of L_ddot is what its velocities make of it.
        wanted = wanted - np.asarray(legs_or_overflow(robot, motion).L_ddot)
        J = jacobian(robot, motion.R, motion.t)
        unsettled = np.broadcast_to(_unsettled(robot, motion.R, motion.t), shape)
        solution, _ = solve(np.broadcast_to(J, (*shape, 6, 6)), np.broadcast_to(wanted, (*shape, 6)))
    finite = np.all(np.isfinite(solution), axis=-1)
    status = np.where(unsettled, SINGULAR, np.where(finite, OK, NOT_FINITE))
    solution[status != OK] = np.nan
    error_policy.report(status, name, lambda: _first_fault(status), on_failure, stacklevel=4)
    return solution[..., :3], solution[..., 3:]


def _unsettled(robot: Robot, R: Array, t: Array) -> NDArray[np.bool_]:
    """Where H is so near to singular that lengths known to rounding leave the pose open."""
    H = moments_over(np.swapaxes(jacobian(robot, R, t), -1, -2), _length(robot))
    size = np.linalg.norm(H, axis=(-2, -1))
    # The smallest singular value is at least |det H| over the fifth power of the mean of the others.
    with np.errstate(all="ignore"):
        most = np.asarray(size * (size**2 / 5.0) ** 2.5 / np.abs(np.linalg.det(H)))
    doubtful = np.asarray(~(most <= 0.5 * _MOST_CONDITION))
    doubtful[doubtful] = ~(condition_number(H[doubtful]) <= _MOST_CONDITION)
    return doubtful


def solve(A: Array, y: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Return x, (..., 6), of A x = y and where A has one; 0 where elimination meets a pivot of 0."""
    regular = np.ones(y.shape[:-1], dtype=np.bool_)
    try:
        x = np.linalg.solve(A, y[..., None])
    except np.linalg.LinAlgError:
        # NumPy does not say at which matrix; the sign of the determinant comes from the same elimination.
        regular = np.asarray(np.linalg.slogdet(A)[0] != 0.0)
        A = np.where(regular[..., None, None], A, np.eye(6))
        x = np.linalg.solve(A, np.where(regular[..., None], y, 0.0)[..., None])
    return np.asarray(x[..., 0]), regular


# The search for a pose


class Found(NamedTuple):
    """Poses, (n, 3, 3) and (n, 3), residuals, m, steps taken, and where the search converged, (n,) each."""

    R: Array
    t: Array
    residual: Array
    iterations: NDArray[np.int64]
    found: NDArray[np.bool_]

    def at(self, where: NDArray[np.intp]) -> Found:
        """What was found from some of the starts, as copies."""
        return Found(
            self.R[where], self.t[where], self.residual[where], self.iterations[where], self.found[where]
        )


def _search(robot: Robot, L: Array) -> Found:
    """Go from each likely start in turn to the lengths, (n, 6), that none before has found; then from all."""
    directions = _likely(robot)
    best = newton(robot, L, *_over_base(robot, L, *directions[0]))
    possible = ~_impossible(robot, L)
    for direction in directions[1:]:
        left = np.flatnonzero(~best.found & possible)
        if not left.size:
            return best
        _replace(best, left, newton(robot, L[left], *_over_base(robot, L[left], *direction)))
    orientations, normals = _anywhere(robot, _MOST_STARTS - len(directions))
    for part in _parts(np.flatnonzero(~best.found & possible)):
        starts = _over_base(robot, L[part, None], orientations, normals)
        _replace(best, part, _first_found(robot, L[part], *starts))
    return best


def _first_found(robot: Robot, L: Array, R: Array, t: Array) -> Found:
    """Return for lengths (n, 6) what the first good one of their starts, (n, m, ...), finds."""
    n, m = t.shape[:2]
    every = newton(robot, np.repeat(L, m, axis=0), R.reshape(-1, 3, 3), t.reshape(-1, 3))
    good = every.found.reshape(n, m)
    chosen = np.where(good.any(axis=-1), np.argmax(good, axis=-1), m - 1)
    found = every.at(np.arange(n) * m + chosen)
    tried = np.arange(m) <= chosen[:, None]
    return found._replace(iterations=np.sum(every.iterations.reshape(n, m) * tried, axis=-1))


def _parts(indices: NDArray[np.intp]) -> Iterator[NDArray[np.intp]]:
    """Yield indices so many at a time that all their starts fit into memory."""
    for i in range(0, len(indices), _AT_ONCE):
        yield indices[i : i + _AT_ONCE]


def _nearest(robot: Robot, L: Array, R: Array, t: Array) -> Found:
    """Return of the poses found from a guess, (n, ...), the one nearest to it.

    Where the first lies farther away than the next singular pose does, or none was found, short steps are
    tried as well, and from what is found then the other side of the singular poses; in the end starts about
    the guess.
    """
    best = newton(robot, L, R, t)
    far = distance(robot, (R, t), best[:2]) > np.abs(way_to_singular(robot, best.R, best.t)[0])
    doubtful = np.flatnonzero((~best.found | far) & ~_impossible(robot, L))
    if not doubtful.size:
        return best
    guess, lengths = (R[doubtful], t[doubtful]), L[doubtful]
    short = newton(robot, lengths, *guess, _SHORT)
    first = best.R[doubtful], best.t[doubtful]
    tries = [short, *(other_side(robot, lengths, *poses) for poses in (first, short[:2]))]
    for found in tries:
        old = best.at(doubtful)
        nearer = distance(robot, guess, found[:2]) < distance(robot, guess, old[:2])
        take = np.flatnonzero(found.found & (nearer | ~old.found))
        _replace(best, doubtful[take], found.at(take))
    # Lengths all but met belong to a singular pose or to one beside it.
    missed = ~best.found[doubtful] & (best.residual[doubtful] > _ALMOST * _length(robot))
    for part in _parts(doubtful[missed]):
        _replace(best, part, _first_found(robot, L[part], *_about(robot, R[part], t[part], L[part])))
    return best


def _replace(best: Found, where: NDArray[np.intp], found: Found) -> None:
    """Put what was found in place of what was; steps add up."""
    found.iterations[:] += best.iterations[where]
    for old, new in zip(best, found, strict=True):
        old[where] = new


def other_side(robot: Robot, L: Array, R: Array, t: Array) -> Found:
    """Return poses with lengths L found from behind the next singular poses, as far as these are away."""
    near = way_to_singular(robot, R, t)
    step = np.where(np.isfinite(near.way), 2.0 * near.way, 0.0)[:, None] * near.direction
    angle = np.maximum(1.0, _size(step[:, 3:]))[:, None]
    return newton(robot, L, rotation_from_vector(step[:, 3:] / angle) @ R, t + step[:, :3] / angle)


class ToSingular(NamedTuple):
    """The way from poses to the next singular ones, to first order.

    way: how far, signed, m, (n,): until J's smallest singular value, at its rate there, is 0.
    direction: the twist [v; omega] that changes the lengths least, (n, 6), of length 1 with angles times the
    platform's size. legs: the change of lengths, of size 1, that it makes, (n, 6). lengths: how much of that
    is left on the way, m, (n,): with more, the lengths belong to no pose nearby.
    """

    way: Array
    direction: Array
    legs: Array
    lengths: Array


def way_to_singular(robot: Robot, R: Array, t: Array) -> ToSingular:
    """Return the way from poses (n, ...) to the next singular ones."""
    unit = np.repeat([1.0, _length(robot)], 3)
    q, S, L = leg_vectors(robot, R, t)
    U, s, V_T = np.linalg.svd(np.nan_to_num(_rows(q, S, L) / unit))
    direction = V_T[:, -1] / unit
    L = np.where(L > 0.0, L, 1.0)[..., None]
    q_dot = cross(direction[:, None, 3:], q)
    along, S_dot = S / L, direction[:, None, :3] + q_dot
    s_dot = (S_dot - along * np.sum(along * S_dot, axis=-1, keepdims=True)) / L
    J_dot = np.concatenate([s_dot, cross(q_dot, along) + cross(q, s_dot)], axis=-1)
    rate = np.einsum("ni,nij,nj->n", U[..., -1], J_dot, direction)
    with np.errstate(divide="ignore", invalid="ignore"):
        way = -s[:, -1] / rate
    return ToSingular(way, direction, U[..., -1], 0.5 * s[:, -1] * np.abs(way))


def distance(robot: Robot, one: tuple[Array, Array], other: tuple[Array, Array]) -> Array:
    """Return how far poses (n, ...) are from others, m, (n,): angles count times the platform's size."""
    turn = vector_from_rotation(other[0] @ np.swapaxes(one[0], -1, -2))
    return np.hypot(_size(other[1] - one[1]), _length(robot) * _size(turn))


def _impossible(robot: Robot, L: Array) -> NDArray[np.bool_]:
    """Where lengths, (n, 6), have no pose for certain, (n,)."""
    return np.asarray(_impossible_pairs(robot, L).any(axis=(-2, -1)))


def _impossible_pairs(robot: Robot, L: Array) -> NDArray[np.bool_]:
    """Which two legs' lengths, (..., 6), differ by more, or add up to less, than their joints allow."""
    base, platform = (np.linalg.norm(x[:, None] - x, axis=-1) for x in (robot.b, robot.p))
    one, other = L[..., :, None], L[..., None, :]
    with np.errstate(over="ignore"):
        slack = 64 * _EPS * (one + other)
        too_far = np.abs(one - other) > base + platform + slack
        too_near = one + other < np.abs(base - platform) - slack
    return np.asarray((too_far | too_near) & ~np.eye(6, dtype=np.bool_))


def newton(robot: Robot, L: Array, R: Array, t: Array, most: float = 1.0) -> Found:
    """Return what is found from poses (n, ...) for lengths L, (n, 6); most: of a step, see below.

    Each step is a twist: t <- t + dt, R <- exp([dphi]x) R.  It solves (J^T J + damping E) d = J^T (L - |S|),
    angles times the platform's size; damping falls with every step that brings the lengths nearer, until the
    steps are Newton's own, and a step that does not is taken back and tried shorter.
    """
    R, t = orthonormal(R), t.copy()
    length = _length(robot)
    damping = np.full(len(L), _FIRST_DAMPING)
    iterations = np.zeros(len(L), dtype=np.int64)
    live = np.arange(len(L))
    with np.errstate(over="ignore", invalid="ignore"):
        for _ in range(_MOST_STEPS):
            q, S, now = leg_vectors(robot, R[live], t[live])
            miss = L[live] - now
            far = np.max(np.abs(miss), axis=-1) > _GOAL * _reach(robot, q, t[live])
            go = far & (damping[live] <= _MOST_DAMPING)
            live, q, S, now, miss = live[go], q[go], S[go], now[go], miss[go]
            if not live.size:
                break
            J = _rows(q, S, now) / np.repeat([1.0, length], 3)
            d = _damped_step(J, miss, damping[live])
            d[:, 3:] /= length
            # Beyond its own reach or a turn of one radian a step has nothing to do with the machine.
            share = np.maximum(_size(d[:, :3]) / np.max(L[live], axis=-1), _size(d[:, 3:])) / most
            d /= np.maximum(1.0, share)[:, None]
            R_1 = orthonormal(rotation_from_vector(d[:, 3:]) @ R[live])
            t_1 = t[live] + d[:, :3]
            nearer = _size(L[live] - leg_vectors(robot, R_1, t_1)[2]) < _size(miss)
            R[live[nearer]], t[live[nearer]] = R_1[nearer], t_1[nearer]
            iterations[live] += 1
            damping[live] = np.where(
                nearer,
                np.maximum(damping[live] * 1e-2, _LEAST_DAMPING),
                np.maximum(damping[live] * 10.0, 1e-8),
            )
        q, _, now = leg_vectors(robot, R, t)
        residual = np.max(np.abs(L - now), axis=-1)
    return Found(R, t, residual, iterations, residual <= ROUNDING * _reach(robot, q, t))


def _damped_step(J: Array, miss: Array, damping: Array) -> Array:
    J_T = np.swapaxes(J, -1, -2)
    return solve(J_T @ J + damping[:, None, None] * np.eye(6), np.einsum("...ji,...j->...i", J, miss))[0]


def _rows(q: Array, S: Array, L: Array) -> Array:
    # A leg of length zero has no direction: its row is 0 and makes J singular.
    s = S / np.where(L > 0.0, L, 1.0)[..., None]
    return np.concatenate([s, cross(q, s)], axis=-1)


def _reach(robot: Robot, q: Array, t: Array) -> Array:
    """Largest component of the terms of S = q + t - b, m, (...)."""
    of_platform = np.maximum(np.max(np.abs(q), axis=(-2, -1)), np.max(np.abs(t), axis=-1))
    return np.asarray(np.maximum(of_platform, np.max(np.abs(robot.b))))


def _size(vector: Array) -> Array:
    return np.asarray(np.linalg.norm(vector, axis=-1))


def _length(robot: Robot) -> float:
    return characteristic_length(robot) or 1.0


# Where the search starts


def _likely(robot: Robot) -> list[Poses]:
    """Return orientations, (3, 3), and the sides of the base they are looked for on, (3,), likeliest first.

    Orientations: E, and the one that brings each platform point nearest to its base point (Kabsch, 1976);
    the latter first when E tilts or turns the platform far from it; then both turned about the base's normal,
    and both on its other side.
    """
    b, p = (points - points.mean(axis=0) for points in (robot.b, robot.p))
    U, _, V_T = np.linalg.svd(b.T @ p)
    nearest = U @ np.diag([1.0, 1.0, np.linalg.det(U @ V_T)]) @ V_T
    normal = base_normal(robot)
    as_drawn = normal @ nearest @ normal > math.cos(math.radians(30.0)) and np.trace(nearest) > 1.0
    first = [np.eye(3), nearest] if as_drawn else [nearest, np.eye(3)]
    turned = [rotation_from_vector(angle * normal) @ R for angle in _MORE_TURNS for R in first]
    return [*((R, normal) for R in (*first, *turned)), *((R, -normal) for R in first)]


def _anywhere(robot: Robot, count: int) -> Poses:
    """Return orientations, (count, 3, 3), and sides, (count, 3), drawn evenly, alike in whatever axes."""
    rng, turn = np.random.default_rng(0), upright(robot)
    e, n = rng.normal(size=(count, 4)), rng.normal(size=(count, 3))
    R = rotation_from_quaternion(e / _size(e)[:, None])
    return turn @ R @ turn.T, n / _size(n)[:, None] @ turn.T


def _over_base(robot: Robot, L: Array, R: Array, n: Array) -> Poses:
    """Return poses (..., 3, 3), (..., 3) at orientations R, on sides n, as high as the mean square length."""
    b, p = (points - points.mean(axis=0) for points in (robot.b, robot.p))
    across = np.sqrt(np.mean(np.sum((p @ np.swapaxes(R, -1, -2) - b) ** 2, axis=-1), axis=-1))
    longest = np.max(L, axis=-1)
    mean_length = longest * np.sqrt(np.mean((L / longest[..., None]) ** 2, axis=-1))
    height = np.sqrt(np.maximum(mean_length - across, 0.01 * mean_length)) * np.sqrt(mean_length + across)
    t = robot.b.mean(axis=0) - R @ robot.p.mean(axis=0) + height[..., None] * n
    return np.broadcast_to(R, (*t.shape, 3)), t


def _about(robot: Robot, R: Array, t: Array, L: Array) -> Poses:
    """Return poses (n, m, ...) about others, (n, ...), up to half a radian and half a leg's length away."""
    rng, turn = np.random.default_rng(0), upright(robot)
    width = 0.5 * np.arange(1, _MOST_ABOUT + 1)[:, None] / _MOST_ABOUT
    phi, step = width * rng.normal(size=(2, _MOST_ABOUT, 3)) @ turn.T
    mean = np.mean(L, axis=-1)[:, None, None]
    return rotation_from_vector(phi) @ R[:, None], t[:, None] + mean * step


def _checked_guess(guess: object) -> Motion:
    if not isinstance(guess, tuple | list) or len(guess) != 2:
        raise ValueError(f"guess: expected a pose (R, t) or None, got {type(guess).__name__}")
    R, t = guess
    try:
        return Motion(R, t, np.zeros(3), np.zeros(3))
    except ValueError as error:
        raise ValueError(f"guess: {error}") from None


def _first_fault(status: NDArray[np.integer]) -> tuple[tuple[int, ...], str]:
    where, others = error_policy.first(status)
    return where, f"{REASONS[int(status[where])]}{others}"
