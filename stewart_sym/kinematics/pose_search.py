"""Search for poses with given leg lengths by damped Newton steps from likely start poses."""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array, Flags
from ..motion import rotation
from ..robot.robot import Robot
from .conditioning import characteristic_length
from .inverse_kinematics import ROUNDING, leg_vectors, length_rows
from .mounting_side import base_normal, upright
from .offset_legs import actuated_lengths

Poses = tuple[Array, Array]
EPS = float(np.finfo(np.float64).eps)
# Residual, relative to the terms of S, at which the search ends; a pose is accepted below ROUNDING.
_GOAL = 4 * EPS
_MOST_STEPS = 100
# Values of the damping, which is added to J^T J with a trace of about 12.
_FIRST_DAMPING, _LEAST_DAMPING, _MOST_DAMPING = 1e-6, 1e-14, 1e3
# Rotations about the base normal (rad) of further start poses if the first two poses fail.
_MORE_TURNS = (0.5, -0.5, 1.0, -1.0)
# Limit of a short step: angle (rad), and translation relative to the longest leg.
_SHORT = 0.1
# Search that rejects no steps: limit of a step, number of steps, and damping of the first four steps.
_FREE, _FREE_STEPS, _FIRST_FREE = 0.25, 30, 1e-3
# Number of starts after which the search fails: without a guess, and around a guess.
MOST_STARTS, _MOST_ABOUT = 100, 20
# Number of length sets that are tried from all starts at once, which bounds the memory.
_AT_ONCE = 64
# Residual, relative to the platform size, below which the lengths are almost satisfied.
_ALMOST = 1e-6


def rates_per_twist(robot: Robot, R: Array, t: Array, screws: bool = False) -> Array:
    """Compute J, shape (..., 6, 6), whose rows [s^T, (q x s)^T] map the twist [v; omega] to L_dot, (5).

    With joint offsets, J is the derivative of the lengths; with ``screws``, it is H^T, which contains the
    spin of the upper leg parts in their nuts. NaN if a leg has no solution.
    """
    if robot.offsets is not None:
        return actuated_lengths(robot, R, t, screws)[2]
    return length_rows(*leg_vectors(robot, R, t))


def solve(A: Array, y: Array) -> tuple[Array, Flags]:
    """Solve A x = y; return x, shape (..., 6), and a flag.

    The flag is False, and x is 0, if the elimination meets a zero pivot.
    """
    regular = np.ones(y.shape[:-1], dtype=np.bool_)
    try:
        x = np.linalg.solve(A, y[..., None])
    except np.linalg.LinAlgError:
        # NumPy does not report the singular matrix; the sign of the determinant uses the same elimination.
        regular = np.asarray(np.linalg.slogdet(A)[0] != 0.0)
        A = np.where(regular[..., None, None], A, np.eye(6))
        x = np.linalg.solve(A, np.where(regular[..., None], y, 0.0)[..., None])
    return np.asarray(x[..., 0]), regular


class PoseSearchResult(NamedTuple):
    """Poses found from n starts, with residuals (m), numbers of steps, and flags of convergence."""

    R: Array
    t: Array
    residual: Array
    iterations: NDArray[np.int64]
    converged: Flags

    def at(self, index: NDArray[np.intp]) -> "PoseSearchResult":
        """Return copies of the results of selected starts."""
        return PoseSearchResult._make(values[index] for values in self)


def search_poses(robot: Robot, L: Array) -> PoseSearchResult:
    """Search poses with lengths (n, 6) from each likely start in turn, then from random starts."""
    directions = _likely(robot)
    best = newton(robot, L, *_over_base(robot, L, *directions[0]))
    possible = ~impossible_pairs(robot, L).any(axis=(-2, -1))
    for direction in directions[1:]:
        remaining = np.flatnonzero(~best.converged & possible)
        if not remaining.size:
            return best
        lengths = L[remaining]
        _replace(best, remaining, newton(robot, lengths, *_over_base(robot, lengths, *direction)))
    orientations, normals = _anywhere(robot, MOST_STARTS - len(directions))
    for part in _parts(np.flatnonzero(~best.converged & possible)):
        starts = _over_base(robot, L[part, None], orientations, normals)
        _replace(best, part, _first_found(robot, L[part], *starts))
    return best


def _first_found(robot: Robot, L: Array, R: Array, t: Array) -> PoseSearchResult:
    """Return the result of the first successful start for lengths (n, 6) and starts (n, m, ...)."""
    n, m = t.shape[:2]
    results = newton(robot, np.repeat(L, m, axis=0), R.reshape(-1, 3, 3), t.reshape(-1, 3))
    converged = results.converged.reshape(n, m)
    chosen = np.where(converged.any(axis=-1), np.argmax(converged, axis=-1), m - 1)
    tried = np.arange(m) <= chosen[:, None]
    iterations = np.sum(results.iterations.reshape(n, m) * tried, axis=-1)
    return results.at(np.arange(n) * m + chosen)._replace(iterations=iterations)


def _parts(indices: NDArray[np.intp]) -> Iterator[NDArray[np.intp]]:
    """Yield parts of the indices, small enough that all their starts fit into memory."""
    for i in range(0, len(indices), _AT_ONCE):
        yield indices[i : i + _AT_ONCE]


def nearest_poses(robot: Robot, L: Array, R: Array, t: Array) -> PoseSearchResult:
    """Return the pose nearest to each guess (n, ...), out of all poses that searches from the guess find.

    If ``_is_nearest`` does not accept the first pose, further searches follow: with short steps; with steps
    that are never rejected, of which the first four are damped or undamped; from the other side of singular
    poses near the results; and finally from starts around the guess.
    """
    best = newton(robot, L, R, t)
    possible = ~impossible_pairs(robot, L).any(axis=(-2, -1))
    doubtful = np.flatnonzero(~(best.converged & _is_nearest(robot, (R, t), best)) & possible)
    if not doubtful.size:
        return best
    guess, lengths = (R[doubtful], t[doubtful]), L[doubtful]
    short = newton(robot, lengths, *guess, _SHORT)
    free = [newton(robot, lengths, *guess, _FREE, damping)[:2] for damping in (0.0, _FIRST_FREE)]
    tries = [best.at(doubtful), short, *(newton(robot, lengths, *poses) for poses in free)]
    tries += [other_side(robot, lengths, *result[:2]) for result in tries]
    for result in tries[1:]:
        old = best.at(doubtful)
        # A pose that is found twice differs by rounding.
        nearer = distance(guess, result[:2]) < (1.0 - 1e-9) * distance(guess, old[:2])
        better = np.flatnonzero(result.converged & (nearer | ~old.converged))
        _replace(best, doubtful[better], result.at(better))
    # Lengths that are almost satisfied belong to a singular pose or to a pose close to it.
    missed = ~best.converged[doubtful] & (best.residual[doubtful] > _ALMOST * platform_size(robot))
    for part in _parts(doubtful[missed]):
        _replace(best, part, _first_found(robot, L[part], *_about(robot, R[part], t[part], L[part])))
    return best


def _replace(best: PoseSearchResult, index: NDArray[np.intp], result: PoseSearchResult) -> None:
    """Replace results by new results and add the numbers of steps."""
    result.iterations[:] += best.iterations[index]
    for old, new in zip(best, result, strict=True):
        old[index] = new


def other_side(robot: Robot, L: Array, R: Array, t: Array) -> PoseSearchResult:
    """Search poses with lengths L from starts beyond the nearest singular poses, at the same distance."""
    near = way_to_singular(robot, R, t)
    step = np.where(np.isfinite(near.way), 2.0 * near.way, 0.0)[:, None] * near.direction
    angle = np.maximum(1.0, _size(step[:, 3:]))[:, None]
    return newton(robot, L, rotation.rotation_from_vector(step[:, 3:] / angle) @ R, t + step[:, :3] / angle)


class ToSingular(NamedTuple):
    """Path from poses to the nearest singular poses, to first order.

    Attributes
    ----------
    way : ndarray, shape (n,)
        Signed distance (m) at which the smallest singular value of J, extrapolated with its rate, vanishes.
    direction : ndarray, shape (n, 6)
        Twist [v; omega] that changes the lengths least, with norm 1 if angles are multiplied by the platform
        size.
    legs : ndarray, shape (n, 6)
        Corresponding change of the lengths, with norm 1.
    lengths : ndarray, shape (n,)
        Change of the lengths along the path (m); larger changes have no pose nearby.
    """

    way: Array
    direction: Array
    legs: Array
    lengths: Array


def way_to_singular(robot: Robot, R: Array, t: Array) -> ToSingular:
    """Return the paths from poses (n, ...) to the nearest singular poses."""
    unit = np.repeat([1.0, platform_size(robot)], 3)
    q, S, L = leg_vectors(robot, R, t)
    U, s, V_T = np.linalg.svd(np.nan_to_num(length_rows(q, S, L) / unit))
    direction = V_T[:, -1] / unit
    L = np.where(L > 0.0, L, 1.0)[..., None]
    q_dot = rotation.cross(direction[:, None, 3:], q)
    along, S_dot = S / L, direction[:, None, :3] + q_dot
    s_dot = (S_dot - along * np.sum(along * S_dot, axis=-1, keepdims=True)) / L
    J_dot = np.concatenate([s_dot, rotation.cross(q_dot, along) + rotation.cross(q, s_dot)], axis=-1)
    rate = np.einsum("ni,nij,nj->n", U[..., -1], J_dot, direction)
    with np.errstate(divide="ignore", invalid="ignore"):
        way = -s[:, -1] / rate
    return ToSingular(way, direction, U[..., -1], 0.5 * s[:, -1] * np.abs(way))


def distance(one: Poses, other: Poses, length: float = 1.0) -> Array:
    """Return the distance between poses, shape (n,): the root of the sum of squares in m and rad.

    Angles are multiplied by ``length`` (m).
    """
    turn = rotation.vector_from_rotation(other[0] @ np.swapaxes(one[0], -1, -2))
    return np.hypot(_size(other[1] - one[1]), length * _size(turn))


def _is_nearest(robot: Robot, guess: Poses, found: PoseSearchResult) -> Flags:
    """Return True for poses that are the nearest to the guess according to an estimate, shape (n,).

    The estimate limits the second derivatives of the lengths by their values at the pose found. To second
    order, any other pose is then at least twice as far away from the pose found as the guess. This is not a
    rigorous proof, because the second derivatives can be larger between the poses.
    """
    length = platform_size(robot)
    with np.errstate(over="ignore", invalid="ignore"):
        q, S, L = leg_vectors(robot, found.R, found.t)
        least = np.linalg.svd(
            np.nan_to_num(length_rows(q, S, L) / np.repeat([1.0, length], 3)), compute_uv=False
        )[:, -1]
        arm = np.max(_size(q), axis=-1) / length
        bend = (1.0 + arm**2) / np.min(L, axis=-1) + arm / length
        return np.asarray(bend * distance(guess, found[:2], length) <= least)


def impossible_pairs(robot: Robot, L: Array) -> Flags:
    """Return True for pairs of legs with lengths (..., 6) that their joints do not allow at the same time.

    The lengths differ by more, or have a smaller sum, than the distances of the joints allow.
    """
    base, platform = (np.linalg.norm(x[:, None] - x, axis=-1) for x in (robot.b, robot.p))
    one, other = L[..., :, None], L[..., None, :]
    with np.errstate(over="ignore"):
        slack = 64 * EPS * (one + other)
        too_far = np.abs(one - other) > base + platform + slack
        too_near = one + other < np.abs(base - platform) - slack
    return np.asarray((too_far | too_near) & ~np.eye(6, dtype=np.bool_))


def newton(
    robot: Robot,
    L: Array,
    R: Array,
    t: Array,
    most: float = 1.0,
    free: float | None = None,
    screws: bool = False,
) -> PoseSearchResult:
    """Search poses with lengths L, shape (n, 6), from start poses (n, ...) by damped Newton steps.

    A step is a twist: t <- t + dt, R <- exp([dphi]x) R. It solves (J^T J + damping E) d = J^T (L - |S|) with
    angles scaled by the platform size. The damping decreases after each step that reduces the residual, so
    that the last steps are Newton steps. Other steps are rejected and repeated with more damping. ``most``
    limits a step. A search with ``free`` rejects no steps; ``free`` is the damping of its first four steps.
    With ``screws``, L are motor angles divided by N, which include the spin of the upper leg parts.
    """
    R, t = rotation.orthonormal(R), t.copy()
    length = platform_size(robot)
    damping = np.full(len(L), _FIRST_DAMPING if free is None else free)
    iterations = np.zeros(len(L), dtype=np.int64)
    live = np.arange(len(L))
    with np.errstate(all="ignore"):
        now, J, reach = at = _at(robot, R, t, screws)
        for step in range(_MOST_STEPS if free is None else _FREE_STEPS):
            far = np.max(np.abs(L[live] - now[live]), axis=-1) > _GOAL * reach[live]
            far &= (damping[live] <= _MOST_DAMPING) & np.isfinite(J[live]).all(axis=(-2, -1))
            live = live[far]
            if not live.size:
                break
            miss = L[live] - now[live]
            rows = J[live] / np.repeat([1.0, length], 3)
            A = np.swapaxes(rows, -1, -2) @ rows + damping[live][:, None, None] * np.eye(6)
            d, _ = solve(A, np.einsum("...ji,...j->...i", rows, miss))
            d[:, 3:] /= length
            # The linearization is meaningless beyond the length of the legs or a rotation of one radian.
            share = np.maximum(_size(d[:, :3]) / np.max(L[live], axis=-1), _size(d[:, 3:])) / most
            d /= np.maximum(1.0, share)[:, None]
            moved = (
                rotation.orthonormal(rotation.rotation_from_vector(d[:, 3:]) @ R[live]),
                t[live] + d[:, :3],
            )
            there = _at(robot, *moved, screws)
            nearer = (free is not None) | (_size(L[live] - there[0]) < _size(miss))
            for old, new in zip((R, t, *at), (*moved, *there), strict=True):
                old[live[nearer]] = new[nearer]
            iterations[live] += 1
            if free is not None:
                damping[live] = free if step < 3 else 0.0
                continue
            damping[live] = np.where(
                nearer,
                np.maximum(damping[live] * 1e-2, _LEAST_DAMPING),
                np.maximum(damping[live] * 10.0, 1e-8),
            )
        residual = np.max(np.abs(L - now), axis=-1)
    return PoseSearchResult(R, t, residual, iterations, residual <= ROUNDING * reach)


def _at(robot: Robot, R: Array, t: Array, screws: bool) -> tuple[Array, Array, Array]:
    """Return lengths, their derivative by the twist, and the largest component in S = q + t - b (m), (n,)."""
    if robot.offsets is None:
        q, S, L = leg_vectors(robot, R, t)
        J = length_rows(q, S, L)
    else:
        q, L, J = actuated_lengths(robot, R, t, screws)
    of_platform = np.maximum(np.max(np.abs(q), axis=(-2, -1)), np.max(np.abs(t), axis=-1))
    return L, J, np.asarray(np.maximum(of_platform, np.max(np.abs(robot.b))))


def _size(vector: Array) -> Array:
    return np.asarray(np.linalg.norm(vector, axis=-1))


def platform_size(robot: Robot) -> float:
    """Return the characteristic length (m); 1 if it is zero."""
    return characteristic_length(robot) or 1.0


def _likely(robot: Robot) -> list[Poses]:
    """Return start orientations (3, 3) and base sides (3,), ordered from the most to the least likely.

    Orientations are E and the rotation that minimizes the distances between platform and base points (Kabsch,
    1976). The latter is first if it tilts or turns the platform far from E. Both follow rotated about the
    base normal, and both on the other side of the base.
    """
    b, p = (points - points.mean(axis=0) for points in (robot.b, robot.p))
    U, _, V_T = np.linalg.svd(b.T @ p)
    nearest = U @ np.diag([1.0, 1.0, np.linalg.det(U @ V_T)]) @ V_T
    normal = base_normal(robot)
    as_drawn = normal @ nearest @ normal > math.cos(math.radians(30.0)) and np.trace(nearest) > 1.0
    first = [np.eye(3), nearest] if as_drawn else [nearest, np.eye(3)]
    turned = [rotation.rotation_from_vector(angle * normal) @ R for angle in _MORE_TURNS for R in first]
    return [*((R, normal) for R in (*first, *turned)), *((R, -normal) for R in first)]


def _anywhere(robot: Robot, count: int) -> Poses:
    """Return random uniform orientations (count, 3, 3) and sides (count, 3), equal for any robot axes."""
    rng, turn = np.random.default_rng(0), upright(robot)
    e, n = rng.normal(size=(count, 4)), rng.normal(size=(count, 3))
    R = rotation.rotation_from_quaternion(e / _size(e)[:, None])
    return turn @ R @ turn.T, n / _size(n)[:, None] @ turn.T


def _over_base(robot: Robot, L: Array, R: Array, n: Array) -> Poses:
    """Return poses at orientations R on sides n, with heights from the mean square length."""
    b, p = (points - points.mean(axis=0) for points in (robot.b, robot.p))
    across = np.sqrt(np.mean(np.sum((p @ np.swapaxes(R, -1, -2) - b) ** 2, axis=-1), axis=-1))
    longest = np.max(L, axis=-1)
    mean_length = longest * np.sqrt(np.mean((L / longest[..., None]) ** 2, axis=-1))
    height = np.sqrt(np.maximum(mean_length - across, 0.01 * mean_length)) * np.sqrt(mean_length + across)
    t = robot.b.mean(axis=0) - R @ robot.p.mean(axis=0) + height[..., None] * n
    return np.broadcast_to(R, (*t.shape, 3)), t


def _about(robot: Robot, R: Array, t: Array, L: Array) -> Poses:
    """Return poses (n, m, ...) around given poses, up to half a radian and half a leg length away."""
    rng, turn = np.random.default_rng(0), upright(robot)
    width = 0.5 * np.arange(1, _MOST_ABOUT + 1)[:, None] / _MOST_ABOUT
    phi, step = width * rng.normal(size=(2, _MOST_ABOUT, 3)) @ turn.T
    mean = np.mean(L, axis=-1)[:, None, None]
    return rotation.rotation_from_vector(phi) @ R[:, None], t[:, None] + mean * step
