"""The search for poses of given leg lengths: Newton's damped steps from likely starts."""

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
from .mounting import base_normal, upright
from .offset_legs import length_jacobian, search

Poses = tuple[Array, Array]
EPS = float(np.finfo(np.float64).eps)
# The search ends below this share of the terms of S; what counts as found is ROUNDING.
_GOAL = 4 * EPS
_MOST_STEPS = 100
# Damping is added to J^T J, whose trace is about 12.
_FIRST_DAMPING, _LEAST_DAMPING, _MOST_DAMPING = 1e-6, 1e-14, 1e3
# Turns about the base's normal, rad, from which the search starts when the first two poses were no good.
_MORE_TURNS = (0.5, -0.5, 1.0, -1.0)
# Limit of a short step: rad, and share of the longest leg.
_SHORT = 0.1
# Steps of a search that takes none back: the limit and number of them, and the damping of the first four.
_FREE, _FREE_STEPS, _FIRST_FREE = 0.25, 30, 1e-3
# Starts after which the search is given up: without a guess, and about one.
MOST_STARTS, _MOST_ABOUT = 100, 20
# So many sets of lengths are tried from all starts at once, which bounds memory.
_AT_ONCE = 64
# Lengths that are met within this share of the platform's size count as almost met.
_ALMOST = 1e-6


def jacobian(robot: Robot, R: Array, t: Array) -> Array:
    """Return J = H^T, (..., 6, 6): rows [s^T, (q x s)^T] take the twist [v; omega] to L_dot, (5).

    With offset joints those of the lengths.
    """
    if robot.offsets is not None:
        return length_jacobian(robot, R, t)
    return length_rows(*leg_vectors(robot, R, t))


def solve(A: Array, y: Array) -> tuple[Array, Flags]:
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


class Found(NamedTuple):
    """Poses, (n, 3, 3) and (n, 3), residuals, m, steps taken, and where the search converged, (n,) each."""

    R: Array
    t: Array
    residual: Array
    iterations: NDArray[np.int64]
    found: Flags

    def at(self, where: NDArray[np.intp]) -> "Found":
        """What was found from some of the starts, as copies."""
        return Found._make(each[where] for each in self)


def searched(robot: Robot, L: Array) -> Found:
    """Go from each likely start in turn to the lengths, (n, 6), that none before has found; then from all."""
    directions = _likely(robot)
    best = newton(robot, L, *_over_base(robot, L, *directions[0]))
    possible = ~_impossible(robot, L)
    for direction in directions[1:]:
        left = np.flatnonzero(~best.found & possible)
        if not left.size:
            return best
        _replace(best, left, newton(robot, L[left], *_over_base(robot, L[left], *direction)))
    orientations, normals = _anywhere(robot, MOST_STARTS - len(directions))
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


def nearest_found(robot: Robot, L: Array, R: Array, t: Array) -> Found:
    """Return of the poses found from a guess, (n, ...), the one nearest to it.

    Unless a bound proves that the first is the nearest, short steps are tried as well, and steps that are
    never taken back, the first four of them damped or not; then the other side of the singular poses next to
    what these find; in the end starts about the guess.
    """
    best = newton(robot, L, R, t)
    doubtful = np.flatnonzero(~(best.found & _is_nearest(robot, (R, t), best)) & ~_impossible(robot, L))
    if not doubtful.size:
        return best
    guess, lengths = (R[doubtful], t[doubtful]), L[doubtful]
    short = newton(robot, lengths, *guess, _SHORT)
    free = [newton(robot, lengths, *guess, _FREE, damping)[:2] for damping in (0.0, _FIRST_FREE)]
    tries = [best.at(doubtful), short, *(newton(robot, lengths, *poses) for poses in free)]
    tries += [other_side(robot, lengths, *found[:2]) for found in tries]
    for found in tries[1:]:
        old = best.at(doubtful)
        # The same pose found again differs by rounding.
        nearer = distance(guess, found[:2]) < (1.0 - 1e-9) * distance(guess, old[:2])
        take = np.flatnonzero(found.found & (nearer | ~old.found))
        _replace(best, doubtful[take], found.at(take))
    # Lengths all but met belong to a singular pose or to one beside it.
    missed = ~best.found[doubtful] & (best.residual[doubtful] > _ALMOST * platform_size(robot))
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
    return newton(robot, L, rotation.rotation_from_vector(step[:, 3:] / angle) @ R, t + step[:, :3] / angle)


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
    """Return the distance between poses (n, ...), (n,): the root of the sum of squares in m and rad.

    length: m, by which angles are multiplied instead of 1 m.
    """
    turn = rotation.vector_from_rotation(other[0] @ np.swapaxes(one[0], -1, -2))
    return np.hypot(_size(other[1] - one[1]), length * _size(turn))


def _is_nearest(robot: Robot, guess: Poses, found: Found) -> Flags:
    """Return True for poses, (n,), that a bound proves to be the nearest to the guess.

    The bound limits the second derivatives of the lengths: any other pose is at least twice as far away.
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


def _impossible(robot: Robot, L: Array) -> Flags:
    """Where lengths, (n, 6), have no pose for certain, (n,)."""
    return np.asarray(impossible_pairs(robot, L).any(axis=(-2, -1)))


def impossible_pairs(robot: Robot, L: Array) -> Flags:
    """Which two legs' lengths, (..., 6), differ by more, or add up to less, than their joints allow."""
    base, platform = (np.linalg.norm(x[:, None] - x, axis=-1) for x in (robot.b, robot.p))
    one, other = L[..., :, None], L[..., None, :]
    with np.errstate(over="ignore"):
        slack = 64 * EPS * (one + other)
        too_far = np.abs(one - other) > base + platform + slack
        too_near = one + other < np.abs(base - platform) - slack
    return np.asarray((too_far | too_near) & ~np.eye(6, dtype=np.bool_))


def newton(robot: Robot, L: Array, R: Array, t: Array, most: float = 1.0, free: float | None = None) -> Found:
    """Return what is found from poses (n, ...) for lengths L, (n, 6); most: of a step, see below.

    free: damping of the first four steps of a search that takes no step back.

    Each step is a twist: t <- t + dt, R <- exp([dphi]x) R.  It solves (J^T J + damping E) d = J^T (L - |S|),
    angles times the platform's size; damping falls with every step that brings the lengths nearer, until the
    steps are Newton's own, and a step that does not is taken back and tried shorter. With offset joints the
    steps are those of ``offset_legs.search``.
    """
    if robot.offsets is not None:
        R, t, found, residual, steps = search(robot, L, R, t)
        return Found(R, t, residual, steps, found)
    R, t = rotation.orthonormal(R), t.copy()
    length = platform_size(robot)
    damping = np.full(len(L), _FIRST_DAMPING if free is None else free)
    iterations = np.zeros(len(L), dtype=np.int64)
    live = np.arange(len(L))
    with np.errstate(over="ignore", invalid="ignore"):
        for step in range(_MOST_STEPS if free is None else _FREE_STEPS):
            q, S, now = leg_vectors(robot, R[live], t[live])
            miss = L[live] - now
            far = np.max(np.abs(miss), axis=-1) > _GOAL * _reach(robot, q, t[live])
            go = far & (damping[live] <= _MOST_DAMPING)
            live, q, S, now, miss = live[go], q[go], S[go], now[go], miss[go]
            if not live.size:
                break
            J = length_rows(q, S, now) / np.repeat([1.0, length], 3)
            J_T = np.swapaxes(J, -1, -2)
            A = J_T @ J + damping[live][:, None, None] * np.eye(6)
            d, _ = solve(A, np.einsum("...ji,...j->...i", J, miss))
            d[:, 3:] /= length
            # Beyond its own reach or a turn of one radian a step has nothing to do with the machine.
            share = np.maximum(_size(d[:, :3]) / np.max(L[live], axis=-1), _size(d[:, 3:])) / most
            d /= np.maximum(1.0, share)[:, None]
            R_1 = rotation.orthonormal(rotation.rotation_from_vector(d[:, 3:]) @ R[live])
            t_1 = t[live] + d[:, :3]
            nearer = (free is not None) | (_size(L[live] - leg_vectors(robot, R_1, t_1)[2]) < _size(miss))
            R[live[nearer]], t[live[nearer]] = R_1[nearer], t_1[nearer]
            iterations[live] += 1
            if free is not None:
                damping[live] = free if step < 3 else 0.0
                continue
            damping[live] = np.where(
                nearer,
                np.maximum(damping[live] * 1e-2, _LEAST_DAMPING),
                np.maximum(damping[live] * 10.0, 1e-8),
            )
        q, _, now = leg_vectors(robot, R, t)
        residual = np.max(np.abs(L - now), axis=-1)
    return Found(R, t, residual, iterations, residual <= ROUNDING * _reach(robot, q, t))


def _reach(robot: Robot, q: Array, t: Array) -> Array:
    """Largest component of the terms of S = q + t - b, m, (...)."""
    of_platform = np.maximum(np.max(np.abs(q), axis=(-2, -1)), np.max(np.abs(t), axis=-1))
    return np.asarray(np.maximum(of_platform, np.max(np.abs(robot.b))))


def _size(vector: Array) -> Array:
    return np.asarray(np.linalg.norm(vector, axis=-1))


def platform_size(robot: Robot) -> float:
    """Characteristic length, m; 1 for a platform that is a point."""
    return characteristic_length(robot) or 1.0


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
    turned = [rotation.rotation_from_vector(angle * normal) @ R for angle in _MORE_TURNS for R in first]
    return [*((R, normal) for R in (*first, *turned)), *((R, -normal) for R in first)]


def _anywhere(robot: Robot, count: int) -> Poses:
    """Return orientations, (count, 3, 3), and sides, (count, 3), drawn evenly, alike in whatever axes."""
    rng, turn = np.random.default_rng(0), upright(robot)
    e, n = rng.normal(size=(count, 4)), rng.normal(size=(count, 3))
    R = rotation.rotation_from_quaternion(e / _size(e)[:, None])
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
    return rotation.rotation_from_vector(phi) @ R[:, None], t[:, None] + mean * step
