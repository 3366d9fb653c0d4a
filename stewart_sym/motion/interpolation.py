"""Piecewise polynomials of degree 5: a trajectory between its samples, and B-splines.

The quintic between two samples keeps their poses, rates and accelerations.

Between samples whose rates come from a spline of degree 5, as those of ``read_csv``, positions are that
spline.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import real_array
from ..io.array_types import Array
from ..io.toml_reader import positive
from . import rotation
from .motion import Motion, at_rest
from .sample_times import apart, elapsed, parts, time_text
from .straight_line import MOST_STEPS
from .trajectory import PoseLog, Replaced, Trajectory, Uncertainty, need_trajectory

Path = Callable[[Array], Motion]
"""Function that returns the motion, shape (n,), at times (n,) (s)."""


def interpolate(trajectory: Trajectory | PoseLog) -> Path:
    """Return a function that interpolates a trajectory between its first and its last sample.

    Between two samples, position and rotation vector are polynomials of degree 5 in time. Loads change
    linearly.

    Parameters
    ----------
    trajectory : Trajectory or PoseLog
        Times and poses, or a log of poses.

    Returns
    -------
    callable
        Function of times (...) (s) that returns a motion of the same shape. It raises ValueError for times
        outside the trajectory.

    Raises
    ------
    ValueError
        If there are fewer than two samples, times do not increase, or the motion has no accelerations.
    """
    _need_interpolable(trajectory)
    time = trajectory.time
    per_second = parts(time)

    def at(times: ArrayLike) -> Motion:
        when = real_array(times, "times")
        outside = ~((when >= time[0]) & (when <= time[-1]))
        if np.any(outside):
            raise ValueError(
                f"times: expected times in [{time_text(time[0])}, {time_text(time[-1])}] s, "
                f"got {time_text(when[outside][0])}"
            )
        i, share = _steps(time, when)
        h = apart(time[i + 1], time[i], per_second)[..., None]
        if np.all((share == 0.0) | (share == 1.0)):
            return trajectory.at(np.asarray(i + (share[..., 0] == 1.0)))
        # The polynomials of the steps in question alone: those of all would take as much room as the motion.
        start, end = trajectory.at(i), trajectory.at(i + 1)
        R, t, omega, v, alpha, a = _moved(_steps_of(h, start, end), share, h, start.R)
        loads = {
            name: None if load is None or after is None else load + share * (after - load)
            for name, load, after in (("F_ext", start.F_ext, end.F_ext), ("M_ext", start.M_ext, end.M_ext))
        }
        return Motion(R=rotation.orthonormal(R), t=t, omega=omega, v=v, alpha=alpha, a=a, **loads)

    return at


def followed(trajectory: Trajectory) -> Callable[[float], Motion]:
    """Return ``interpolate`` for one time after the other, s since the first sample: at rest after the last.

    The polynomials of all steps are made once, which takes as much room as the motion. Raises as
    ``interpolate``.
    """
    _need_interpolable(trajectory)
    motion, time = trajectory.motion, elapsed(trajectory.time)
    h = np.diff(time)[:, None]
    c = _steps_of(h, motion[:-1], motion[1:])
    loads = {name: getattr(motion, name) for name in ("F_ext", "M_ext")}
    loads = {name: load for name, load in loads.items() if load is not None}
    last = at_rest(motion.R[-1], motion.t[-1], **{name: load[-1] for name, load in loads.items()})

    def at(when: float) -> Motion:
        if when >= time[-1]:
            return last
        i = max(int(np.searchsorted(time, when, side="right")) - 1, 0)
        share = (when - float(time[i])) / float(h[i, 0])
        now = {name: load[i] + share * (load[i + 1] - load[i]) for name, load in loads.items()}
        return Motion._unchecked(*_moved(c[:, i], share, h[i], motion.R[i]), **now)

    return at


def _need_interpolable(trajectory: Trajectory | PoseLog) -> None:
    """Reject, by ValueError, fewer than two samples, times that don't increase, and no accelerations."""
    need_trajectory(trajectory)
    time = trajectory.time
    if len(time) < 2:
        raise ValueError(f"{trajectory.source}: expected at least 2 samples, got {len(time)}")
    if not (time[1:] > time[:-1]).all():
        raise ValueError(f"{trajectory.source}: expected increasing times")
    if isinstance(trajectory, Trajectory) and trajectory.motion.a is None:
        raise ValueError(f"{trajectory.source}: expected a motion with accelerations, got none")


def resample(trajectory: Trajectory | PoseLog, rate: float) -> Trajectory:
    """Resample a trajectory at equal time steps from its first sample.

    Each new sample has the line number of the previous sample. In long gaps of a ``PoseLog``, or of a
    ``Trajectory`` with noise, the standard deviations include the noise at both ends and the error of
    interpolation over gaps of this length. New samples in such gaps are marked as replaced rows.

    Parameters
    ----------
    trajectory : Trajectory or PoseLog
        Times and poses, or a log of poses.
    rate : float
        Sampling rate (Hz).

    Returns
    -------
    Trajectory
        Trajectory at equal time steps.

    Raises
    ------
    ValueError
        If the rate is not > 0, if there are more than ten million samples, or as in ``interpolate``.
    """
    _need_interpolable(trajectory)
    rate = positive(rate, "rate")
    time = trajectory.time
    since = elapsed(time)
    count = float(since[-1]) * rate * (1.0 + 1e-12)
    if not count < MOST_STEPS:
        raise ValueError(f"rate: expected > 0 Hz and at most {MOST_STEPS:,} samples, got {rate:g}")
    path = interpolate(trajectory)
    when = np.minimum(time[0] + np.arange(int(count) + 1) / rate, time[-1])
    i, share = _steps(time, when)
    rows = tuple(trajectory.rows[int(k)] for k in i)
    noise, gaps = trajectory.noise, breaks(since)
    if noise is None and gaps and isinstance(trajectory, PoseLog):
        sure, tool = np.zeros((2, 6, len(PAIRS))), trajectory.tool
        of = trajectory.coordinates
        noise = Uncertainty(of, time[[0, -1]], sure, np.zeros(6), tool=tool, order=trajectory.order)
    if noise is not None:
        start, end = noise.coordinates[:, :-1], noise.coordinates[:, 1:]
        h = np.diff(since)[:, None]
        c = quintic(h, tuple(start), tuple(end))
        if gaps:
            noise = in_gaps(noise, time, gaps, [f"the gap before line {trajectory.rows[k]}" for k in gaps])
        noise = noise._replace(coordinates=np.stack(values(c[:, i], share, h[i])))
    return Trajectory(when, path(when), trajectory.source, rows, noise)


# Times in a gap at which covariances are given, and places of a log at which as long ones are tried.
_IN_GAP, _TRIED = 17, 200


def in_gaps(noise: Uncertainty, time: Array, gaps: list[int], names: Sequence[str]) -> Uncertainty:
    """Return the uncertainty of coordinates bridged by quintics in gaps, before some of the samples.

    A smooth curve holds both ends of a short gap, and its uncertainty remains; both ends of a long gap are
    independent. How far quintics as long miss the motion elsewhere is added.
    """
    since, share, first = elapsed(time), np.linspace(0.0, 1.0, _IN_GAP)[:, None], 0
    missed = functools.cache(functools.partial(_missed, since, noise.coordinates))
    units = np.eye(6).reshape(2, 3, 6)
    grids, covariances, spans, long = [], [], [], breaks(since)
    at_ends = noise.covariances(time[np.add.outer(gaps, [-1, 0]).ravel()]).reshape(len(gaps), 2, 6, -1)
    for i, both, name in zip(gaps, at_ends, names, strict=True):
        ends, h = time[i - 1 : i + 1], since[i : i + 1] - since[i - 1]
        # What value, rate and second rate at each end make of those inside, (g, 6).
        made = values(quintic(h, *map(tuple, units))[:, None], share, h)
        known = np.zeros((len(noise.sigma), 6, 6))
        for end, of in enumerate(both):
            for k, (p, q) in enumerate(PAIRS):
                known[:, 3 * end + p, 3 * end + q] = known[:, 3 * end + q, 3 * end + p] = of[:, k]
        off = missed(float(f"{h[0]:.2g}"))
        inside = np.stack([np.einsum("ga,cab,gb->gc", made[p], known, made[q]) for p, q in PAIRS], axis=-1)
        if i not in long:
            inside = noise.covariances(ends[0] + h * share[:, 0])
        inside = inside + np.stack([off[p] * off[q] for p, q in PAIRS], axis=-1)
        before, after = np.searchsorted(noise.grid, ends[0]), np.searchsorted(noise.grid, ends[1], "right")
        grids += [noise.grid[first:before], ends[0] + h * share[:, 0]]
        covariances += [noise.covariance[first:before], inside]
        spans.append(Replaced(float(ends[0]), float(ends[1]), (name,)))
        first = int(after)
    return noise._replace(
        grid=np.concatenate([*grids, noise.grid[first:]]),
        covariance=np.concatenate([*covariances, noise.covariance[first:]]),
        replaced=(*noise.replaced, *spans),
    )


def _missed(since: Array, rows: Array, h: float) -> Array:
    """By how much quintics over a time h miss values and rates of rows, (3, n, c), at most: (3, g, c).

    Where no rows are that far apart without a gap, over less, and what is missed of values grows with its
    sixth power.
    """
    edges = np.array([0, *breaks(since), len(since)])
    until = np.repeat(since[edges[1:] - 1], np.diff(edges))
    tried = min(h, float(np.max(until - since))) * (1.0 - 1e-9)
    first = np.flatnonzero(since + tried <= until)
    first = first[np.linspace(0, len(first) - 1, min(len(first), _TRIED)).astype(np.int64)]
    last = np.searchsorted(since, since[first] + tried)
    at = first[:, None] + np.rint((last - first)[:, None] * np.linspace(0.0, 1.0, _IN_GAP)).astype(np.int64)
    step = (since[last] - since[first])[:, None, None]
    share = (since[at] - since[first, None])[..., None] / step
    c = quintic(step, tuple(rows[:, first, None]), tuple(rows[:, last, None]))
    missed = np.abs(rows[:, at] - np.stack(values(c, share, step))).max(axis=1)
    return np.asarray(missed * (h / tried) ** np.array([6.0, 5.0, 4.0])[:, None, None])


def _steps(time: Array, when: Array) -> tuple[NDArray[np.int64], Array]:
    """Step in which each time lies, and the share of it that has passed, (..., 1)."""
    i = np.minimum(np.searchsorted(time, when, side="right") - 1, len(time) - 2)
    return i, ((when - time[i]) / (time[i + 1] - time[i]))[..., None]


Ends = tuple[Array, Array, Array]


def _steps_of(h: Array, start: Motion, end: Motion) -> Array:
    """Coefficients as of ``quintic`` of positions and of rotation vectors from the start of each step."""
    assert start.alpha is not None
    assert end.alpha is not None
    turn = rotation.vector_from_rotation(end.R @ np.swapaxes(start.R, -1, -2))
    rates = rotation.vector_rate(turn, end.omega), rotation.vector_second_rate(turn, end.omega, end.alpha)
    turning = quintic(h, (np.zeros_like(turn), start.omega, start.alpha), (turn, *rates))
    places = quintic(h, *((each.t, each.v, np.asarray(each.a)) for each in (start, end)))
    return np.concatenate([places, turning], axis=-1)


def _moved(c: Array, share: Array | float, h: Array, R: Array) -> tuple[Array, ...]:
    """R, t, omega, v, alpha and a at shares of steps h, s, of coefficients (6, ..., 6) that begin with R."""
    pose, rate, second = values(c, share, h)
    omega, alpha = rotation.angular_motion_from_vector(pose[..., 3:], rate[..., 3:], second[..., 3:])
    R = rotation.rotation_from_vector(pose[..., 3:]) @ R
    return R, pose[..., :3], omega, rate[..., :3], alpha, second[..., :3]


def quintic(h: Array, first: Ends, last: Ends) -> Array:
    """Coefficients, (6, ..., 3), of powers of the share of a step h, from values, rates and second rates."""
    c_0, c_1, c_2 = first[0], h * first[1], 0.5 * h**2 * first[2]
    d, e, f = last[0] - c_0 - c_1 - c_2, h * last[1] - c_1 - 2.0 * c_2, h**2 * last[2] - 2.0 * c_2
    c_3, c_4, c_5 = 10.0 * d - 4.0 * e + 0.5 * f, -15.0 * d + 7.0 * e - f, 6.0 * d - 3.0 * e + 0.5 * f
    return np.stack([c_0, c_1, c_2, c_3, c_4, c_5])


def values(c: Array, share: Array | float, h: Array) -> Ends:
    """Value, rate and second rate at shares of steps h, s, of coefficients (6, ..., 3)."""
    x = c[0] + share * (c[1] + share * (c[2] + share * (c[3] + share * (c[4] + share * c[5]))))
    rate = c[1] + share * (2.0 * c[2] + share * (3.0 * c[3] + share * (4.0 * c[4] + share * 5.0 * c[5])))
    second = 2.0 * c[2] + share * (6.0 * c[3] + share * (12.0 * c[4] + share * 20.0 * c[5]))
    return x, rate / h, second / h**2


# B-splines

DEGREE = 5


def places(since: Array, step: float, cells: int) -> tuple[NDArray[np.int64], Array]:
    """Cell of each time and the place in it, 0 to 1."""
    place = since / step
    cell = np.clip(place.astype(np.int64), 0, cells - 1)
    return cell, place - cell


def b_splines(u: Array, degree: int, rate: int = 0) -> Array:
    """The degree + 1 B-splines on knots 1 apart that are not 0 at u in [0, 1], (n, degree + 1), or rates."""
    # One row for each spline: sums along long rows are the fast ones.
    N = np.ones((1, len(u)))
    for k in range(1, degree - rate + 1):
        starts = np.arange(1 - k, 1)[:, None]
        rise, fall = (u - starts) / k * N, (starts + k - u) / k * N
        N = _sum_of_neighbors(rise, fall)
    for _ in range(rate):
        N = _sum_of_neighbors(N, -N)
    return N.T


def _sum_of_neighbors(before: Array, here: Array) -> Array:
    """Rows, one more than given, of what stands before each and at it."""
    rows = np.zeros((len(here) + 1, here.shape[1]))
    rows[1:] = before
    rows[:-1] += here
    return rows


def along(N: Array, cell: NDArray[np.int64], coefficients: Array) -> Array:
    """Spline of coefficients (p, c) where the B-splines of the cells are N, (n, c)."""
    total = np.zeros((len(cell), coefficients.shape[1]))
    for i in range(N.shape[1]):
        total += N[:, i, None] * coefficients[cell + i]
    return total


def dense(cell: NDArray[np.int64], N: Array, width: int) -> Array:
    """The B-splines of the cells as rows of all coefficients, (n, width + DEGREE)."""
    B = np.zeros((len(cell), width + DEGREE))
    B[np.arange(len(cell))[:, None], cell[:, None] + np.arange(DEGREE + 1)] = N
    return B


@functools.lru_cache(maxsize=8)
def rates_at_half_cells(width: int) -> list[Array]:
    """Values, rates and second rates of B-splines of knots 1 apart at every half cell: (g, p) each."""
    cell, u = places(np.arange(2 * width + 1) / 2.0, 1.0, width)
    return [dense(cell, b_splines(u, DEGREE, rate), width) for rate in range(3)]


def inverse_factor(M: Array) -> Array:
    """Inverse of the Cholesky factor of normal equations, (p, p); ValueError where samples don't fix them."""
    try:
        return np.asarray(np.linalg.inv(np.linalg.cholesky(M)))
    except np.linalg.LinAlgError:
        raise ValueError(
            "smooth curve: the noise of some rows is much smaller than the noise of others; remove these "
            "rows, or state the noise"
        ) from None


# What is off in a smooth curve besides noise: jumps that it rounds off, joints of windows

PAIRS = ((0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2))
"""Entries of a covariance: pairs of value, 0, rate, 1, and second rate, 2."""


def beside_noise(coefficients: Array, resolved: Array, apart: Array, step: float) -> Array:
    """Covariance at every half cell, (g, c, 6), that jumps of second rates and joints of windows add.

    Where a second rate that may jump seems to rise, anything between what it is before and after is as
    likely. resolved: cells over which a jump becomes a ramp, (g, c); 0 where none is likely. apart: mean of
    the windows' own values, rates and second rates, (3, g, c), from which the joined curve differs.
    """
    grid = np.arange(len(resolved)) / 2.0
    cell, u = places(grid, 1.0, len(coefficients) - DEGREE)
    joined = np.stack([along(b_splines(u, DEGREE, i), cell, coefficients) / step**i for i in range(3)])
    joints, ramps = joined - apart, np.zeros(apart.shape)
    for i, ramp in enumerate(resolved.T):
        before, after = (np.interp(grid + side * ramp, grid, joined[2, :, i]) for side in (-1.0, 1.0))
        ramps[2, :, i] = (after - before) / math.sqrt(12.0)
    ramps[1] = 0.25 * step * resolved * ramps[2]
    return np.stack([ramps[i] * ramps[j] + joints[i] * joints[j] for i, j in PAIRS], axis=-1)


# Even knots of splines, and the windows in which these are fitted

WINDOW = 96
"""Knot intervals of a window."""
# Times are even if they are off multiples of the mean interval by less than this share of it.
_UNEVEN = 1e-6
# A step this many times as long as nine of ten splits a series, if both parts keep this many samples.
_GAP, _FEWEST_SAMPLES = 8.0, 6


class Instants(NamedTuple):
    """Times of samples since the first, in units, s; of even samples whole numbers of their interval.

    scale: how many times the noise of a column that of each sample is, (n,).
    """

    start: float
    unit: float
    since: Array
    even: bool
    scale: Array

    @classmethod
    def of(cls, time: Array, scale: Array) -> Instants:
        """Of increasing times."""
        since = elapsed(time)
        unit = float(since[-1]) / (len(time) - 1)
        count = np.rint(since / unit)
        even = bool(np.abs(since / unit - count).max() < _UNEVEN)
        unit, since = (unit, count) if even else (1.0, since)
        return cls(float(time[0]), unit, since, even, scale)


class Knots(NamedTuple):
    """Even knots: their distance, the number of intervals between them, and samples in each on average.

    whole: half a window holds a whole number of samples, so that windows see the same pattern of them.
    """

    step: float
    cells: int
    density: float
    whole: bool

    @classmethod
    def of(cls, instants: Instants, cells: float) -> Knots:
        """About so many intervals over the times: a few more where windows need them."""
        span, half = float(instants.since[-1]), WINDOW // 2
        step = span / cells
        whole = instants.even and cells > WINDOW
        if whole:
            step = math.ceil(half * step) / half
        needed = math.ceil(span / step * (1.0 - 1e-12))
        return cls(step, needed if whole else whole_windows(needed), len(instants.since) * step / span, whole)

    def place(self, cell: int) -> float:
        """Time at which a cell begins."""
        return float(round(cell * self.step)) if self.whole else cell * self.step

    def windows(self) -> list[int]:
        """First cell of every window; a single one takes all."""
        return list(range(0, max(0, self.cells - WINDOW) + 1, WINDOW // 2))

    def width(self, start: int) -> int:
        """Cells of the window from cell ``start``; the last takes all that are left."""
        left = self.cells - start
        return left if left < 3 * WINDOW // 2 else WINDOW

    def share(self, start: int, places: Array) -> Array:
        """Weight of a window from cell ``start`` at places in cells; of all windows they add up to 1.

        It is 0 next to an end that another window overlaps, where the one has fewer samples than the other,
        and has no kinks, which would be accelerations where one curve is rougher than the other.
        """
        margin = WINDOW / 24.0
        overlap = WINDOW / 2.0 - 2.0 * margin
        last = start + self.width(start) >= self.cells
        rise = np.ones_like(places) if start == 0 else (places - start - margin) / overlap
        fall = np.ones_like(places) if last else (start + WINDOW - places - margin) / overlap
        x = np.clip(np.minimum(rise, fall), 0.0, 1.0)
        return np.asarray(x**3 * (10.0 - x * (15.0 - 6.0 * x)))


def whole_windows(cells: int) -> int:
    """At least as many cells, such that windows fill them."""
    half = WINDOW // 2
    return cells if cells <= WINDOW else -(-cells // half) * half


def breaks(time: Array) -> list[int]:
    """First samples after long gaps, so that each part has its fewest samples."""
    step = np.diff(time)
    found: list[int] = []
    if len(time) < 2 * _FEWEST_SAMPLES:
        return found
    for i in (np.flatnonzero(step > _GAP * np.quantile(step, 0.9)) + 1).tolist():
        if i - (found[-1] if found else 0) >= _FEWEST_SAMPLES and len(time) - i >= _FEWEST_SAMPLES:
            found.append(i)
    return found


def check_cutoff(time: Array, cutoff: float) -> None:
    """Raise ValueError unless samples at these times show a cut-off frequency, Hz."""
    nyquist = 0.5 / float(np.median(np.diff(elapsed(time))))
    if not 0.0 < cutoff < nyquist:
        raise ValueError(
            f"cutoff: expected a frequency > 0 and < {nyquist:g} Hz, half the rate, got {cutoff:g}"
        )
