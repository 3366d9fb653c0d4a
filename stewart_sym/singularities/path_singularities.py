"""How a path passes the machine's singular poses and limits, found between its samples. det H is a smooth
function of time, so its roots are found from its sign at all its turning points. Which intervals are searched
is settled by the rate of H: no singular value changes faster than H does (Weyl).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..backend.kernel import FORMULATIONS
from ..backend.numpy_kernel import NumpyKernel
from ..dynamics.inverse_dynamics import Formulation, need_motion
from ..io.arguments import instance, option, real_array
from ..io.array_types import Array, Flags
from ..kinematics.conditioning import characteristic_length, moments_over
from ..kinematics.inverse_kinematics import ROUNDING, joint_sines, leg_vectors, wrench_matrix_rate
from ..motion.interpolation import Path
from ..motion.motion import Motion
from ..motion.rotation import cross
from ..robot.robot import Robot
from .root_finding import at_each, minima, minimum, root, runs, turning_points
from .singular_poses import SingularityResult, last_directions, singularity

# Intervals are searched unless the singular values at both ends exceed what twice the rate of H there allows.
_CARE = 2.0
# They are skipped by lower bounds of these values only where the bounds exceed four times that, and the
# change of H.
_SURE = 4.0 * _CARE
# A smallest singular value below this share of the largest is rounding error along a path.
_NOTHING = 1e-13
# Rounding error of det H = 0 by elimination, over the product of the columns' sizes.
_FLOOR = 1e-14
# A leg shorter than this share of the longest turns its direction round, and with it the sign of det H.
_SHORT = 1e-9
# Minima shallower than this share are rounding error.
_SHALLOW = 1e-12
_INSTANTS = 512
_CHUNK = 1 << 13


@dataclass(frozen=True, eq=False)
class SingularityCrossing:
    """A time at which det H changes its sign, between or at the samples of a path.

    Attributes
    ----------
    time : float
        s.
    time_error : float
        What rounding in H leaves open of it, s; inf where the path rests there.
    sign_before, sign_after : int
        Sign of det H, -1 or 1.
    singularity : SingularityResult
        The singular pose there.
    """

    time: float
    time_error: float
    sign_before: int
    sign_after: int
    singularity: SingularityResult


@dataclass(frozen=True, eq=False)
class SingularityApproach:
    """A time at which the smallest singular value of the scaled H is least, s, and the pose there.

    Attributes
    ----------
    time : float
        s.
    singularity : SingularityResult
        How near it is to a singular pose.
    """

    time: float
    singularity: SingularityResult


class LegExtreme(NamedTuple):
    """Where along a path something of each leg is extreme: times, s, (6,), and values, (6,).

    Attributes
    ----------
    time : ndarray
        s.
    value : ndarray
        Of each leg, (6,).
    """

    time: Array
    value: Array


@dataclass(frozen=True, eq=False)
class PathSingularitiesResult:
    """How a path passes singular poses and limits.

    Attributes
    ----------
    start, end : float
        s.
    crossings : tuple
        Where det H changes its sign, in order of time.
    approaches : tuple
        The other local minima of the smallest singular value, in order of time.
    spans : tuple
        Times (from, to), s, through which H is singular to rounding.
    nearest : SingularityApproach
        Of all times, ends and crossings included, the one with the smallest singular value.
    min_joint_sine : LegExtreme
        Least sine of the angle between each leg and its universal joint's fixed axis; 1 with spherical base
        joints.
    min_length, max_length : LegExtreme
        Least and greatest length of each leg, m.
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
    """Return the times at which a path crosses singular poses, in order, each to rounding.

    Parameters
    ----------
    robot : Robot
        The machine.
    path : Path
        Times, s, (n,) -> Motion of shape (n,), such as ``StraightLinePath.sample`` or ``interpolate``; its
        rates must be those of its poses.
    time : array_like
        Where to begin, s, (n,), increasing, at least two: the first and the last, and between them the
        samples or wherever an acceleration jumps. Two crossings between two times are found as well, though
        the determinant of H has the same sign at both.

    Returns
    -------
    tuple
        One ``SingularityCrossing`` for each time.

    Raises
    ------
    ValueError
        Naming the argument.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        return _Search(robot, path, _checked(robot, path, time), everywhere=False).crossings


def path_singularities(robot: Robot, path: Path, time: ArrayLike) -> PathSingularitiesResult:
    """Return how a path passes singular poses, singularities of the universal joints and the legs' limits.

    Arguments and errors as for ``singularity_crossings``. Times of minima are accurate to about 1e-8 of the
    interval between two times.

    Parameters
    ----------
    robot : Robot
        The machine.
    path : Path
        Function of times that returns motions.
    time : array_like
        Instants between which the path is smooth, s, (n,).

    Returns
    -------
    PathSingularitiesResult
        Crossings, nearest approaches and extremes of the legs.
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
    """Return the actuator forces' residue, N s, (..., 6), where ``motion`` crosses a singular pose.

    Within a crossing at time t_0 they go as F = singular_force_residue / (t - t_0): to one infinity before
    and to the other after. It is -v_6 (u_6 . c) / (u_6 . H' v_6), see ``SingularityResult``; not finite where
    the motion rests or moves along singular poses, 0 where nothing loads the unconstrained twist.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.
    formulation : {"exact", "paper"}, optional
        The corrected equations or those printed.

    Returns
    -------
    ndarray
        Residues, N s, (..., 6).

    Raises
    ------
    ValueError
        As ``inverse_dynamics``.
    """
    need_motion(robot, motion)
    option(formulation, FORMULATIONS, "formulation")
    length = characteristic_length(robot) or 1.0
    terms = NumpyKernel.prepare(robot, formulation).terms(motion)
    u, _, v = last_directions(moments_over(terms["H"], length))
    rate = np.einsum("...i,...ij,...j->...", u, _scaled_rate(robot, motion, length), v)
    load = np.sum(u / np.repeat([1.0, length], 3) * terms["c"], axis=-1)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(-v * (load / rate)[..., None])


# The search


class _Samples(NamedTuple):
    """At times (n,): det of the scaled H times lengths over reach, smallest and largest singular value."""

    determinant: Array
    smallest: Array
    largest: Array


class _Search:
    """A path's singular poses: the points looked at, then what lies between them."""

    def __init__(self, robot: Robot, path: Path, times: Array, everywhere: bool = True) -> None:
        """everywhere: whether singular values count at all times, or only where one may vanish."""
        self.robot, self.path, self.times = robot, path, times
        self.length = characteristic_length(robot) or 1.0
        ends = path(times[[0, -1]])
        self.reach = float(leg_vectors(robot, *_pose(ends))[2].max()) or 1.0
        at_times = _in_chunks(lambda part: self._look_about(part, everywhere), times)
        inner = np.setdiff1d(self._inner_points(at_times), times)
        order = np.argsort(np.concatenate([times, inner]))
        self.points = np.concatenate([times, inner])[order]
        looks = [at_times[:, :3], *([self._look(inner)] if len(inner) else [])]
        self.samples = _Samples(*np.concatenate(looks)[order].T)
        self.singular = self.samples.smallest <= _NOTHING * self.samples.largest
        self.spans = tuple((float(self.points[i]), float(self.points[j])) for i, j in runs(self.singular))
        self.crossings = tuple(self._crossings())

    def at(self, time: float) -> SingularityResult:
        """The pose at a time; a leg of length zero has no direction there."""
        return singularity(self.robot, self.path(np.array([time]))[0])

    def approaches(self) -> tuple[SingularityApproach, ...]:
        """Local minima of the smallest singular value that are no crossings and in no singular span."""
        times = np.array([found.time for found in self.crossings])
        order = np.argsort(np.concatenate([self.points, times]), kind="stable")
        points = np.concatenate([self.points, times])[order]
        values = np.concatenate([self.samples.smallest, np.zeros(len(times))])[order]
        found = []
        for before, i, after in _minima(values):
            low, high = float(points[before]), float(points[after])
            crossed = np.any((times > low) & (times < high))
            inside = any(start <= points[i] <= end for start, end in self.spans)
            if not crossed and not inside:
                time = minimum(self._smallest, low, high)
                found.append(SingularityApproach(time, self.at(time)))
        return tuple(found)

    def _inner_points(self, at_times: Array) -> Array:
        """Points inside those intervals in which the smallest singular value may vanish or turn."""
        times, (_, smallest, _, rate, speed) = self.times, at_times.T
        may_vanish = smallest[:-1] + smallest[1:] <= _CARE * np.maximum(speed[:-1], speed[1:]) * np.diff(
            times
        )
        may_turn = (rate[:-1] < 0.0) & (rate[1:] > 0.0)
        unknown = ~np.isfinite(smallest[:-1] + smallest[1:] + speed[:-1] + speed[1:])
        chosen = np.flatnonzero(may_vanish | may_turn | unknown)
        edges = np.stack([times[chosen], times[chosen + 1]], axis=-1)
        # Rounding of the times themselves, seconds since 1970 for instance, moves H too.
        moved = np.spacing(np.abs(edges).max(axis=1)) * np.fmax(speed[chosen], speed[chosen + 1])
        floor = (_FLOOR + 6.0 * np.nan_to_num(moved)) * self._size
        return turning_points(self._determinants, edges, floor)

    def _look_about(self, times: Array, everywhere: bool) -> Array:
        """A sample, the rate of its smallest singular value and a bound of any's, 1/s, (n, 5).

        Unless everywhere, bounds stand for singular values, and no rate, but beside steps in which one may
        vanish. The smallest is at least |det H| over the fifth power of the mean of the five others.
        """
        motion = self.path(times)
        H, L = self._scaled_H(motion)
        good, found = _known(H), np.full((len(times), 5), np.nan)
        H_dot = np.full(H.shape, np.nan)
        H_dot[good] = _scaled_rate(self.robot, motion[good], self.length)
        found[:, 4] = speed = np.linalg.norm(H_dot, axis=(-2, -1))
        near = np.full(len(times), True)
        if not everywhere:
            found[:, 0], found[:, 2] = self._determinant(H, L), np.linalg.norm(H, axis=(-2, -1))
            with np.errstate(divide="ignore"):
                volume = np.abs(found[:, 0]) / np.prod(L / self.reach, axis=-1)
            found[:, 1] = least = volume / (found[:, 2] ** 2 / 5.0) ** 2.5
            change = np.maximum(speed[:-1], speed[1:]) * np.diff(times)
            change = _SURE * np.maximum(change, np.linalg.norm(np.diff(H, axis=0), axis=(-2, -1)))
            doubtful = ~(least[:-1] + least[1:] > change)
            # At the ends of a part singular values are found in any case.
            near = np.append(doubtful, True) | np.append(True, doubtful)
        u, s, v = last_directions(np.where(good[near, None, None], H[near], 0.0))
        found[near, :3] = self._sample(H[near], L[near], s)
        found[near, 3] = np.einsum("ni,nij,nj->n", u, H_dot[near], v)
        return found

    def _crossings(self) -> list[SingularityCrossing]:
        """One in each change of sign between points; points where H is singular tell no sign."""
        known = np.flatnonzero(~self.singular & np.isfinite(self.samples.determinant))
        signs = np.sign(self.samples.determinant[known])
        found = []
        for i in np.flatnonzero(signs[:-1] * signs[1:] < 0.0):
            low, high = float(self.points[known[i]]), float(self.points[known[i + 1]])
            if any(low <= start and end <= high for start, end in self.spans):
                continue
            ends = root(self._determinants, low, high)
            time = ends[int(np.argmin(self._smallest(np.array(ends))))]
            if not self._short(time):
                found.append(self._crossing(time, ends[1] - ends[0], int(signs[i])))
        return found

    def _crossing(self, time: float, width: float, before: int) -> SingularityCrossing:
        motion = self.path(np.array([time]))
        u, s, v = last_directions(self._scaled_H(motion)[0])
        rate = abs(float(u[0] @ _scaled_rate(self.robot, motion, self.length)[0] @ v[0]))
        open_ = ROUNDING * float(s[0, 0]) / rate if rate else np.inf
        return SingularityCrossing(
            time, max(width, open_), before, -before, singularity(self.robot, motion[0])
        )

    def _short(self, time: float) -> bool:
        L = leg_vectors(self.robot, *_pose(self.path(np.array([time]))))[2]
        return bool(np.min(L) <= _SHORT * self.reach)

    def _look(self, times: Array) -> Array:
        def once(times: Array) -> Array:
            H, L = self._scaled_H(self.path(times))
            s = np.linalg.svd(np.where(_known(H)[:, None, None], H, 0.0), compute_uv=False)
            return self._sample(H, L, s.astype(np.float64))

        return _in_chunks(once, times)

    def _sample(self, H: Array, L: Array, s: Array) -> Array:
        """``_Samples`` as columns, (n, 3), of singular values s, (n, 6); inf where a leg has no direction."""
        smallest, largest = (np.where(_known(H), s[:, i], np.inf) for i in (-1, 0))
        return np.stack([self._determinant(H, L), smallest, largest], axis=-1)

    def _determinants(self, times: Array) -> Array:
        return _in_chunks(lambda part: self._determinant(*self._scaled_H(self.path(part))), times)

    def _smallest(self, times: Array) -> Array:
        return np.asarray(self._look(times)[:, 1])

    def _determinant(self, H: Array, L: Array) -> Array:
        """Smooth where a leg passes through length zero too: its column is S and not s."""
        return np.asarray(np.linalg.det(np.nan_to_num(H) * (L / self.reach)[:, None, :]))

    @property
    def _size(self) -> float:
        """Bound of the determinant: product of the sizes of the columns at leg lengths up to reach."""
        arms = np.linalg.norm(self.robot.p, axis=-1) / self.length
        return float(np.prod(np.sqrt(1.0 + arms**2)))

    def _scaled_H(self, motion: Motion) -> tuple[Array, Array]:
        """H without units, (n, 6, 6), nan at a leg without a direction, and the lengths, m, (n, 6)."""
        q, S, L = leg_vectors(self.robot, *_pose(motion))
        s = S / np.where(_SHORT * self.reach < L, L, np.nan)[..., None]
        rows = np.concatenate([s, cross(q, s) / self.length], axis=-1)
        return np.swapaxes(rows, -1, -2), L


def _scaled_rate(robot: Robot, motion: Motion, length: float) -> Array:
    """Rate of H without units along the motion, 1/s, (..., 6, 6)."""
    return moments_over(wrench_matrix_rate(robot, motion), length)


def _known(H: Array) -> Flags:
    """Which matrices, (n, 6, 6), belong to legs that all have a direction, (n,)."""
    return np.asarray(np.isfinite(H).all(axis=(-2, -1)))


def _pose(motion: Motion) -> tuple[Array, Array]:
    return motion.R, motion.t


def _minima(values: Array) -> list[tuple[int, int, int]]:
    """Inner entries less than what surrounds them: indices of the first larger one before, it, and after."""
    found: list[tuple[int, int, int]] = []
    for i in np.flatnonzero((values[:-2] >= values[1:-1]) & (values[2:] >= values[1:-1])) + 1:
        if found and i < found[-1][2]:
            continue
        # Rounding alone makes no minimum of an entry: what counts is where the values leave it.
        higher = (values > values[i] * (1.0 + _SHALLOW)) & np.isfinite(values)
        before, after = np.flatnonzero(higher[:i]), np.flatnonzero(higher[i:])
        if before.size and after.size:
            flat = values[before[-1] + 1 : i + after[0]]
            if np.all(flat >= values[i] * (1.0 - _SHALLOW)):
                found.append((int(before[-1]), int(i), int(i + after[0])))
    return found


# The legs


def _leg_extremes(robot: Robot, path: Path, times: Array) -> tuple[LegExtreme, LegExtreme, LegExtreme]:
    """Least joint sine, least and greatest length of each leg."""

    def sought(when: Array) -> Array:
        """Sines, lengths and negative lengths, (n, 18)."""
        _, S, L = leg_vectors(robot, *_pose(path(when)))
        sines = joint_sines(robot, S / np.where(L > 0.0, L, 1.0)[..., None])
        return np.concatenate([sines, L, -L], axis=-1)

    time, value = (each.reshape(3, 6) for each in extremes(sought, times))
    return LegExtreme(time[0], value[0]), LegExtreme(time[1], value[1]), LegExtreme(time[2], -value[2])


def extremes(function: Callable[[Array], Array], times: Array) -> tuple[Array, Array]:
    """When each column of a function of times, (n, m), is least, (m,), and its value there, (m,)."""
    points = np.union1d(times, np.linspace(times[0], times[-1], _INSTANTS))
    i, last = np.argmin(_in_chunks(function, points), axis=0), len(points) - 1
    sampled = points[i]
    refined = minima(function, points[np.maximum(i - 1, 0)], points[np.minimum(i + 1, last)])
    given, better = at_each(function, np.array([sampled, refined]))
    time = np.where(better < given - _SHALLOW * np.abs(given), refined, sampled)
    return time, at_each(function, time[None])[0]


def _in_chunks(function: Callable[[Array], Array], times: Array) -> Array:
    """The function's values at many times without all its arrays in memory at once."""
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
