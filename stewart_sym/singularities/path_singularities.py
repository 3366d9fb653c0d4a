"""Singular poses and limits that a path crosses or approaches, located between its samples."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import ArrayLike

from ..backend.kernel import FORMULATIONS
from ..calls.numpy_kernel import NumpyKernel
from ..dynamics.inverse_dynamics import Formulation, need_motion
from ..io.arguments import instance, option, real_array
from ..io.array_types import Array, Flags, Indices
from ..kinematics.conditioning import characteristic_length, moments_over
from ..kinematics.inverse_kinematics import (
    ROUNDING,
    joint_sines,
    leg_vectors,
    length_rows,
    wrench_matrix_rate,
)
from ..motion.interpolation import Path
from ..motion.motion import Motion
from ..motion.rotation import cross, vector_from_rotation
from ..robot.robot import LEGS, Robot
from .singular_poses import SingularityResult, last_directions, singularity

# Search an interval unless the singular values at both ends exceed twice the possible change of H (Weyl).
_CARE = 2.0
# Smallest singular values below this fraction of the largest are rounding errors.
_NOTHING = 1e-13
# Rounding error of a zero determinant, relative to the product of the column norms.
_FLOOR = 1e-14
# A leg shorter than this fraction of the longest may reverse its direction and the sign of det H.
_SHORT = 1e-9
# Minima with a smaller relative depth are rounding errors.
_SHALLOW = 1e-12
# Each grid divides the interval of a minimum by 8, at last to 1e-8: nearby values differ by its square.
_GRID, _ZOOMS = 17, 9
_INSTANTS = 512
_CHUNK = 1 << 13
# Number of samples whose distance from singular poses is bounded at once.
_BLOCK = 16
_DEGREE = 20
# Relative size of the last Chebyshev coefficients at which a piece is resolved.
_RESOLVED = 1e-11
_TAIL = 4
_MOST_HALVINGS = 30
_MOST_PIECES = 4096

_NODES = chebyshev.chebpts1(_DEGREE + 1)
_TO_COEFFICIENTS = np.linalg.inv(chebyshev.chebvander(_NODES, _DEGREE))


@dataclass(frozen=True, eq=False)
class SingularityCrossing:
    """Time at which det H changes its sign.

    Attributes
    ----------
    time : float
        Time of the crossing (s).
    time_error : float
        Uncertainty of ``time`` due to rounding of H (s); infinite if the path is at rest at this time.
    sign_before, sign_after : int
        Sign of det H before and after the crossing, -1 or 1.
    singularity : SingularityResult
        Singularity measures of the pose at ``time``.
    """

    time: float
    time_error: float
    sign_before: int
    sign_after: int
    singularity: SingularityResult


@dataclass(frozen=True, eq=False)
class SingularityApproach:
    """Local minimum of the smallest singular value of the scaled H along a path.

    Attributes
    ----------
    time : float
        Time of the minimum (s).
    singularity : SingularityResult
        Singularity measures of the pose at ``time``.
    """

    time: float
    singularity: SingularityResult


class LegExtreme(NamedTuple):
    """Extreme value of a quantity of each leg along a path.

    Attributes
    ----------
    time, value : ndarray, shape (6,)
        Times (s) of the extremes, and extreme values.
    """

    time: Array
    value: Array


@dataclass(frozen=True, eq=False)
class PathSingularitiesResult:
    """Singular poses and extreme leg values along a path.

    Attributes
    ----------
    start, end : float
        First and last time (s).
    crossings : tuple of SingularityCrossing
        Sign changes of det H, in order of time.
    approaches : tuple of SingularityApproach
        Local minima of the smallest singular value without a sign change, in order of time.
    spans : tuple of tuple of float
        Time intervals (start, end) in which H is singular to rounding (s).
    nearest : SingularityApproach
        Time with the smallest singular value of the whole path, including ends, crossings, and ``spans``.
    min_joint_sine : LegExtreme
        Smallest sine of the angle between each leg and its universal axis; 1 for spherical base joints.
    min_length, max_length : LegExtreme
        Minimum and maximum length of each leg (m).
    """

    start: float
    end: float
    crossings: tuple[SingularityCrossing, ...]
    approaches: tuple[SingularityApproach, ...]
    spans: tuple[tuple[float, float], ...]
    nearest: SingularityApproach
    min_joint_sine: LegExtreme
    min_length: LegExtreme
    max_length: LegExtreme


def singularity_crossings(robot: Robot, path: Path, time: ArrayLike) -> tuple[SingularityCrossing, ...]:
    """Find the times at which a path crosses singular poses.

    Parameters
    ----------
    robot : Robot
        Robot geometry without joint offsets.
    path : callable
        Function of times (s), (n,), that returns a Motion of shape (n,) with the derivatives of its poses,
        such as ``StraightLinePath.sample`` or a result of ``interpolate``.
    time : array_like, shape (n,)
        Increasing sample times (s), n >= 2, including every time at which an acceleration is discontinuous.

    Returns
    -------
    tuple of SingularityCrossing
        All sign changes of det H in order of time, accurate to rounding, including pairs between two samples,
        but without those across an interval in which H is singular to rounding, as at rest in one.

    Raises
    ------
    ValueError
        If an argument is invalid.

    See Also
    --------
    path_singularities : Also find near-singular poses and extreme leg values.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> path, step = ss.PAPER_PATHS["III"]
    >>> crossings = ss.singularity_crossings(robot, path.sample, time=path.time_grid(10 * step))
    >>> [(round(item.time, 4), item.sign_before, item.sign_after) for item in crossings]
    [(3.6705, -1, 1)]
    """
    times = _checked(robot, path, time)
    with np.errstate(over="ignore", invalid="ignore"):
        parts = [times[i : i + _CHUNK + 1] for i in range(0, len(times) - 1, _CHUNK)]
        steps = np.concatenate([step_bounds(path(part), part) for part in parts], axis=-1)
        runs = near_singular(robot, steps, lambda samples: path(times[samples]))
        return tuple(found for run in runs for found in _Search(robot, path, times[run]).crossings)


def path_singularities(robot: Robot, path: Path, time: ArrayLike) -> PathSingularitiesResult:
    """Find singular poses, near-singular poses, and extreme leg values along a path.

    Parameters
    ----------
    robot : Robot
        Robot geometry without joint offsets.
    path : callable
        Function that maps times (s), shape (n,), to a Motion of shape (n,), as in ``singularity_crossings``.
    time : array_like, shape (n,)
        Increasing sample times (s), n >= 2, between which the path is smooth.

    Returns
    -------
    PathSingularitiesResult
        Crossings, approaches, and leg extremes. Times of minima are accurate to 1e-8 of an interval.

    Raises
    ------
    ValueError
        If an argument is invalid.

    See Also
    --------
    singularity_crossings : Find only the crossings.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> path, step = ss.PAPER_PATHS["III"]
    >>> result = ss.path_singularities(robot, path.sample, time=path.time_grid(10 * step))
    >>> result.max_length.value.round(3).tolist()
    [2.422, 2.43, 2.766, 3.082, 2.675, 2.532]
    """
    with np.errstate(over="ignore", invalid="ignore"):
        search = _Search(robot, path, _checked(robot, path, time))
        approaches = search.approaches()
    ends = [
        SingularityApproach(time, search.at(time))
        for time in (float(search.times[0]), float(search.times[-1]))
    ]
    known = [
        *ends,
        *approaches,
        *(SingularityApproach(found.time, found.singularity) for found in search.crossings),
        *(SingularityApproach(time, search.at(time)) for time, _ in search.spans),
    ]
    joint_sine, shortest, longest = _leg_extremes(robot, path, search.times)
    return PathSingularitiesResult(
        start=ends[0].time,
        end=ends[1].time,
        crossings=search.crossings,
        approaches=approaches,
        spans=search.spans,
        nearest=min(known, key=lambda approach: float(approach.singularity.smallest_singular_value)),
        min_joint_sine=joint_sine,
        min_length=shortest,
        max_length=longest,
    )


def singular_force_residue(robot: Robot, motion: Motion, formulation: Formulation = "exact") -> Array:
    """Compute the residue of the actuator forces at a crossing of a singular pose.

    Near a crossing at time t_0 the forces are F = residue / (t - t_0).

    Parameters
    ----------
    robot : Robot
        Robot geometry and inertia.
    motion : Motion
        Motion at the crossings, with accelerations and any leading shape.
    formulation : {"exact", "paper"}, optional
        Corrected equations, or the equations as printed.

    Returns
    -------
    ndarray, shape (..., 6)
        Residues -v_6 (u_6 . c) / (u_6 . H' v_6) (N s), with u_6 and v_6 of ``SingularityResult``. Not finite
        at rest or along singular poses, and 0 if no wrench acts on the unconstrained twist.

    Raises
    ------
    ValueError
        If an argument is invalid or the motion has no accelerations, as in ``inverse_dynamics``.

    See Also
    --------
    singularity_crossings : Find the times of the crossings.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> path, step = ss.PAPER_PATHS["III"]
    >>> crossing = ss.singularity_crossings(robot, path.sample, time=path.time_grid(10 * step))[0]
    >>> ss.singular_force_residue(robot, path.sample(crossing.time)).round(-2).tolist()
    [-27600.0, 28500.0, -17000.0, -12000.0, 20500.0, 7800.0]
    """
    need_motion(robot, motion)
    option(formulation, FORMULATIONS, "formulation")
    length = characteristic_length(robot) or 1.0
    terms = NumpyKernel(robot, formulation).terms(motion)
    u, _, v = last_directions(moments_over(terms["H"], length))
    rate = np.einsum("...i,...ij,...j->...", u, _scaled_rate(robot, motion, length), v)
    load = np.sum(u / np.repeat([1.0, length], 3) * terms["c"], axis=-1)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(-v * (load / rate)[..., None])


class _Samples(NamedTuple):
    """Properties of the scaled H at n times, shape (n,) each.

    They are the determinant, the smallest and the largest singular value, the rate of the smallest one (1/s),
    and the norm of the rate of H (1/s).
    """

    determinant: Array
    smallest: Array
    largest: Array
    rate: Array
    speed: Array


class _Search:
    """Search for the singular poses of a path by the signs of the smooth det H at its turning points."""

    def __init__(self, robot: Robot, path: Path, times: Array) -> None:
        """Sample the path, and find the crossings and the intervals of singular poses."""
        self.robot, self.path, self.times = robot, path, times
        self.length = characteristic_length(robot) or 1.0
        ends = path(times[[0, -1]])
        self.reach = float(leg_vectors(robot, ends.R, ends.t)[2].max()) or 1.0
        at_times = self._look(times)
        inner = np.setdiff1d(self._inner_points(at_times), times)
        self.points, order = np.unique(np.concatenate([times, inner]), return_index=True)
        both = zip(at_times, self._look(inner), strict=True)
        self.samples = _Samples(*(np.concatenate(parts)[order] for parts in both))
        self.singular = self.samples.smallest <= _NOTHING * self.samples.largest
        self.spans = tuple((float(self.points[i]), float(self.points[j])) for i, j in _runs(self.singular))
        self.crossings = tuple(self._crossings())

    def at(self, time: float) -> SingularityResult:
        """Return the singularity measures at a time."""
        return singularity(self.robot, self.path(np.array([time]))[0])

    def approaches(self) -> tuple[SingularityApproach, ...]:
        """Return the local minima of the smallest singular value that are not singular."""
        from scipy.signal import find_peaks

        times = np.array([found.time for found in self.crossings])
        points, order = np.unique(np.concatenate([self.points, times]), return_index=True)
        values = np.concatenate([self.samples.smallest, np.zeros(len(times))])[order]
        depths = -np.log(np.clip(values, np.finfo(np.float64).tiny, np.finfo(np.float64).max))
        _, peaks = find_peaks(depths, prominence=_SHALLOW, plateau_size=1)
        intervals = []
        for left, right in zip(peaks["left_edges"], peaks["right_edges"], strict=True):
            low, high = points[left - 1], points[right + 1]
            crossed = np.any((times > low) & (times < high))
            inside = any(start <= points[left] <= end for start, end in self.spans)
            if not crossed and not inside:
                intervals.append((low, high))
        found, _ = _minima(
            lambda grid: self._look(grid.ravel()).smallest.reshape(grid.shape),
            *np.array(intervals).reshape(-1, 2).T,
        )
        return tuple(SingularityApproach(time, self.at(time)) for time in found.tolist())

    def _inner_points(self, at_times: _Samples) -> Array:
        """Return points in the intervals in which the smallest singular value may vanish or turn."""
        times, smallest, rate, speed = self.times, at_times.smallest, at_times.rate, at_times.speed
        change = np.maximum(speed[:-1], speed[1:]) * np.diff(times)
        may_vanish = smallest[:-1] + smallest[1:] <= _CARE * change
        may_turn = (rate[:-1] < 0.0) & (rate[1:] > 0.0)
        unknown = ~np.isfinite(smallest[:-1] + smallest[1:] + speed[:-1] + speed[1:])
        chosen = np.flatnonzero(may_vanish | may_turn | unknown)
        edges = np.stack([times[chosen], times[chosen + 1]], axis=-1)
        # Include the effect of rounded times, for example seconds since 1970.
        moved = np.spacing(np.abs(edges).max(axis=1)) * np.fmax(speed[chosen], speed[chosen + 1])
        floor = (_FLOOR + 6.0 * np.nan_to_num(moved)) * self._size
        return _turning_points(self._determinants, edges, floor)

    def _look(self, times: Array) -> _Samples:
        """Sample the path; a leg without a direction gives infinite singular values and NaN rates."""
        if not len(times):
            return _Samples(*np.empty((5, 0)))

        def once(times: Array) -> Array:
            motion = self.path(times)
            H, L = self._scaled_H(motion)
            known = np.asarray(np.isfinite(H).all(axis=(-2, -1)))
            H_dot = np.full(H.shape, np.nan)
            H_dot[known] = _scaled_rate(self.robot, motion[known], self.length)
            u, s, v = last_directions(np.where(known[:, None, None], H, 0.0))
            smallest, largest = (np.where(known, s[:, i], np.inf) for i in (-1, 0))
            rate = np.einsum("ni,nij,nj->n", u, H_dot, v)
            speed = np.linalg.norm(H_dot, axis=(-2, -1))
            return np.stack([self._determinant(H, L), smallest, largest, rate, speed], axis=-1)

        return _Samples(*_in_chunks(once, times).T)

    def _crossings(self) -> list[SingularityCrossing]:
        """Find one crossing per sign change; points at which H is singular are skipped."""
        from scipy.optimize import brentq

        known = np.flatnonzero(~self.singular & np.isfinite(self.samples.determinant))
        signs = np.sign(self.samples.determinant[known])
        found = []
        for i in np.flatnonzero(signs[:-1] * signs[1:] < 0.0):
            low, high = float(self.points[known[i]]), float(self.points[known[i + 1]])
            if any(low <= start and end <= high for start, end in self.spans):
                continue
            spacing = float(np.spacing(max(abs(low), abs(high))))
            since_low = brentq(
                lambda since, low=low: self._determinants(np.array([low + since]))[0],
                0.0,
                high - low,
                xtol=spacing,
            )
            time, before = low + float(since_low), int(signs[i])
            there = self._look(np.array([time]))
            # A leg of length zero reverses its direction and the sign of det H without a singular pose.
            if np.isfinite(there.smallest[0]):
                rate = abs(float(there.rate[0]))
                rounding = ROUNDING * float(there.largest[0]) / rate if rate else np.inf
                error = max(spacing, rounding)
                found.append(SingularityCrossing(time, error, before, -before, self.at(time)))
        return found

    def _determinants(self, times: Array) -> Array:
        return _in_chunks(lambda part: self._determinant(*self._scaled_H(self.path(part))), times)

    def _determinant(self, H: Array, L: Array) -> Array:
        """Return det H scaled by leg lengths, which is smooth even if a leg passes through length zero."""
        return np.asarray(np.linalg.det(np.nan_to_num(H) * (L / self.reach)[:, None, :]))

    @property
    def _size(self) -> float:
        """Upper bound of the determinant for leg lengths up to ``reach``."""
        arms = np.linalg.norm(self.robot.p, axis=-1) / self.length
        return float(np.prod(np.sqrt(1.0 + arms**2)))

    def _scaled_H(self, motion: Motion) -> tuple[Array, Array]:
        """Return the dimensionless H, (n, 6, 6), NaN for legs of length zero, and leg lengths (m), (n, 6)."""
        q, S, L = leg_vectors(self.robot, motion.R, motion.t)
        s = S / np.where(_SHORT * self.reach < L, L, np.nan)[..., None]
        rows = np.concatenate([s, cross(q, s) / self.length], axis=-1)
        return np.swapaxes(rows, -1, -2), L


def _scaled_rate(robot: Robot, motion: Motion, length: float) -> Array:
    """Return the time derivative of the dimensionless H (1/s), shape (..., 6, 6)."""
    return moments_over(wrench_matrix_rate(robot, motion), length)


def _turning_points(function: Callable[[Array], Array], edges: Array, floor: Array) -> Array:
    """Return sorted points within the edges, shape (m, 2), that separate all roots of a smooth function.

    Each piece is approximated by a Chebyshev series and halved until the series is accurate. The points are
    the nodes and the zeros of the derivative of the series. One of these points separates any two roots, so
    the signs at the points reveal all roots. ``floor``, shape (m,), is the rounding error of the function.
    """
    found: list[Array] = []
    pieces, noise = np.asarray(edges, dtype=np.float64).reshape(-1, 2), np.asarray(floor, dtype=np.float64)
    for halving in range(_MOST_HALVINGS + 1):
        if not len(pieces):
            break
        middle, half = pieces.mean(axis=1)[:, None], 0.5 * (pieces[:, 1:] - pieces[:, :1])
        nodes = middle + half * _NODES
        values = function(nodes.ravel()).reshape(nodes.shape)
        finite = np.asarray(np.isfinite(values).all(axis=1))
        series = np.where(finite[:, None], values, 0.0) @ _TO_COEFFICIENTS.T
        largest = np.max(np.abs(series), axis=1)
        tail = np.max(np.abs(series[:, -_TAIL:]), axis=1)
        done = finite & (tail <= np.maximum(_RESOLVED * largest, noise))
        if halving == _MOST_HALVINGS or 2 * np.count_nonzero(~done) > _MOST_PIECES:
            done[:] = True
        found.append(nodes[done].ravel())
        flat = largest <= noise
        for i in np.flatnonzero(done & finite & ~flat):
            found.append(middle[i] + half[i] * _zeros(chebyshev.chebder(series[i])))
        left = pieces[~done]
        cut = left.mean(axis=1)
        pieces = np.concatenate([np.stack([left[:, 0], cut], axis=1), np.stack([cut, left[:, 1]], axis=1)])
        noise = np.tile(noise[~done], 2)
    return np.unique(np.concatenate([np.empty(0), *found]))


def _zeros(series: Array) -> Array:
    """Return the real zeros in (-1, 1), including zeros within rounding of the real axis."""
    size = np.max(np.abs(series))
    trimmed = chebyshev.chebtrim(series, 1e-14 * size) if size else series
    if len(trimmed) < 2:
        return np.empty(0)
    zeros = chebyshev.chebroots(trimmed)
    real = zeros.real[np.abs(zeros.imag) < 1e-3]
    return np.asarray(real[np.abs(real) < 1.0])


def _runs(flags: Flags) -> list[tuple[int, int]]:
    """Return first and last index of each run of at least three flags; shorter runs are crossings."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    return [(int(i), int(j) - 1) for i, j in edges.reshape(-1, 2) if j - i >= 3]


def _leg_extremes(robot: Robot, path: Path, times: Array) -> tuple[LegExtreme, LegExtreme, LegExtreme]:
    """Return the smallest joint sine and the minimum and maximum length of each leg."""

    def sought(when: Array) -> Array:
        """Return sines, lengths (m), and negative lengths (m), shape (n, 18)."""
        motion = path(when)
        _, S, L = leg_vectors(robot, motion.R, motion.t)
        sines = joint_sines(robot, S / np.where(L > 0.0, L, 1.0)[..., None])
        return np.concatenate([sines, L, -L], axis=-1)

    time, value = (each.reshape(3, 6) for each in extremes(sought, times))
    return LegExtreme(time[0], value[0]), LegExtreme(time[1], value[1]), LegExtreme(time[2], -value[2])


def extremes(function: Callable[[Array], Array], times: Array) -> tuple[Array, Array]:
    """Return the time (s) and the value of the minimum of each column of a function, shape (m,) each."""
    points = np.union1d(times, np.linspace(times[0], times[-1], _INSTANTS))
    sampled, last = _in_chunks(function, points), len(points) - 1
    index, columns = np.argmin(sampled, axis=0), np.arange(sampled.shape[1])
    time, value = points[index], sampled.min(axis=0)

    def own(grid: Array) -> Array:
        return function(grid.ravel()).reshape(*grid.shape, -1)[:, columns, columns]

    refined, least = _minima(own, points[np.maximum(index - 1, 0)], points[np.minimum(index + 1, last)])
    better = least < value - _SHALLOW * np.abs(value)
    return np.where(better, refined, time), np.where(better, least, value)


def _minima(function: Callable[[Array], Array], low: Array, high: Array) -> tuple[Array, Array]:
    """Return times (s) and values of the minima between times (m,) of a function of times (n, m).

    Each call of the function evaluates a grid for all minima, because single times take much longer.
    """
    columns = np.arange(len(low))
    for _ in range(_ZOOMS):
        grid = np.linspace(low, high, _GRID)
        values = function(grid)
        least = np.argmin(values, axis=0)
        low, high = (grid[np.clip(least + step, 0, _GRID - 1), columns] for step in (-1, 1))
    return grid[least, columns], values[least, columns]


def step_bounds(motion: Motion, time: Array) -> Array:
    """Return bounds of the translation (m) and the rotation (rad) between n samples of a path, (2, n - 1)."""
    speeds = np.linalg.norm([motion.v, motion.omega], axis=-1)
    turns = vector_from_rotation(motion.R[1:] @ np.swapaxes(motion.R[:-1], -1, -2))
    # The distances and the accelerations count as well, because samples may be at rest.
    chords = np.linalg.norm([np.diff(motion.t, axis=0), turns], axis=-1)
    duration = np.diff(time)
    if motion.a is not None and motion.alpha is not None:
        rates = np.linalg.norm([motion.a, motion.alpha], axis=-1)
        chords += 0.5 * np.maximum(rates[:, 1:], rates[:, :-1]) * duration**2
    return np.asarray(np.maximum(speeds[:, 1:], speeds[:, :-1]) * duration + chords)


def near_singular(robot: Robot, steps: Array, at: Callable[[Indices], Motion]) -> list[slice]:
    """Return the runs of samples among which all singular poses of a path are.

    ``steps`` are the bounds of ``step_bounds``, and ``at`` returns the motion at some samples.
    """
    last = steps.shape[1] - 1
    found = np.arange(last + 1)
    # Most blocks of steps are far from singular poses, so that few single steps are examined.
    for size in (_BLOCK, 1):
        if not len(found):
            return []
        starts = found[::size]
        blocks = np.minimum(starts[:, None] + np.arange(size), last)
        middles = at(np.minimum(starts + size // 2, last + 1))
        found = np.unique(blocks[_may_be_singular(robot, middles, *steps[:, blocks].sum(axis=-1))])
    runs = np.split(found, np.flatnonzero(np.diff(found) > 1) + 1)
    return [slice(int(run[0]), int(run[-1]) + 2) for run in runs if len(run)]


def _may_be_singular(robot: Robot, motion: Motion, moved: Array, turned: Array) -> Flags:
    """Return True for poses (n,) with a singular pose within a path (m) and a turn (rad), (n,).

    The smallest singular value of H changes by at most the norm of the change of H.
    """
    arm, size = float(np.linalg.norm(robot.p, axis=-1).max()), characteristic_length(robot) or 1.0
    q, S, L = leg_vectors(robot, motion.R, motion.t)
    shortest, tips = L.min(axis=-1), moved + arm * turned
    with np.errstate(divide="ignore"):
        direction = np.where(tips < shortest, tips / np.maximum(shortest - tips, 0.0), np.inf)
    change = np.hypot(direction, arm * (turned + direction) / size) * math.sqrt(LEGS)
    H = moments_over(np.swapaxes(length_rows(q, S, L), -1, -2), size)
    s = np.linalg.svd(H, compute_uv=False)
    return ~np.asarray(s[:, -1] > change + ROUNDING * s[:, 0])


def _in_chunks(function: Callable[[Array], Array], times: Array) -> Array:
    """Evaluate a function at many times in chunks to limit memory."""
    parts = [function(times[i : i + _CHUNK]) for i in range(0, len(times), _CHUNK)]
    return parts[0] if len(parts) == 1 else np.concatenate(parts)


def _checked(robot: Robot, path: Path, times: ArrayLike) -> Array:
    instance(robot, Robot, "robot")
    if not callable(path):
        raise ValueError(f"path: expected a function of times, got {type(path).__name__}")
    when = real_array(times, "time", "increasing times")
    if when.ndim != 1 or len(when) < 2 or not np.all(np.isfinite(when)) or np.any(np.diff(when) <= 0.0):
        raise ValueError("time: expected at least two finite times, increasing, of shape (n,)")
    first = path(when[:1])
    instance(first, Motion, "path")
    if first.shape != (1,):
        raise ValueError(f"path: expected a motion of shape (n,) at times (n,), got {first.shape} at (1,)")
    return when
