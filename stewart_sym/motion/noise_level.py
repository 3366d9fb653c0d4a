"""How large the noise of a log's numbers is: their last decimals, and what differences of them show."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from ..io.array_types import Array, Flags
from .sample_times import elapsed


class TrajectoryWarning(UserWarning):
    """Warning of noise or implausible numbers in a log."""


LEAST_SAMPLES = 40
"""Below which differences of samples are too few to estimate noise."""
FEWEST_SAMPLES = 12
"""Below which noise is not distinguished from motion."""
# Digits of a number that is taken for exact, and noise below that share of the largest value for none.
_EXACT_DIGITS = 12
# Least part that the samples have in a mode whose noise is counted.
SEEN = 1e-6
# How far columns of one sensor differ in noise.
_ALIKE = 3.0
# Samples of which means are taken to see correlated noise, and the fewest means.
_MEANS, _LEAST_MEANS = (2, 3, 4, 6, 8, 12, 16, 24, 32), 60
# Share of what differences of order 5 show that those of order 8 show of noise, and growths that white
# noise does not have: over all, and from single samples to means of two.
_NOISE_LIKE, _CORRELATED, _AT_ONCE = 0.75, 1.6, 1.1
# Least of these shares, and least share that small differences of order 3 are of the noise, if few tell.
_LEAST_LIKE, _NOT_ABSENT = 0.2, 0.15
# Growth, for each sample of the means, that noise has at most; share of the numbers that are to change;
# columns that tell; noise beyond that of rounding.
_STEEPEST, _CHANGING, _FEWEST_COLUMNS, _BEYOND = 1.3, 0.7, 3, 1.5

# Differences in a stretch that shows the noise there, and how many times that of others it is that varies;
# by more than the latter, rows that are nearly still count for so much that equations are singular.
_STRETCH, _VARIES, _MOST_VARIED = 48, 3.0, 1e3
# Differences that tell of a column at most.
_MOST_DIFFERENCES = 20_000

# A grid shows in so many distinct numbers of so many rows, the closest of them up to so many steps apart.
# Its step is so many times what the numbers resolve, and by so much coarser than that of what is written.
_FEWEST_NUMBERS, _ROWS, _APART, _RESOLVED, _COARSER = 30, 10_000, 32, 2.5, 1.5
_LEAST_GAPS = 50
_SINGLE = 2.0**-23
# Share of what they resolve that numbers are off a grid: half of it by rounding, the rest as the fit is.
_OFF_GRID = 0.75
# Differences of this order of clean polynomials that are whole steps by themselves are 0; those of rounded
# numbers are 0 only where these rest: least share of the distinct numbers.
_ORDER, _ROUGH = 6, 0.75

# Quantiles of the size of a normal number of deviation 1; within what factor all that tells of noise agrees
# where it is decided, and how far beyond that of rounding it is then.
_QUANTILES = ((0.2, 0.2533), (0.5, 0.6745), (0.8, 1.2816))
_AGREED, _WELL_BEYOND = 1.25, 3.0


class Level(NamedTuple):
    """Standard deviations of the noise of columns, (c,): as counted for white, and the least it can be.

    correlation: how much larger the noise of slow changes, which ``sigma`` is for, is than that from one
    sample to the next; 1 for white noise. scale: by how much the noise of each sample is larger than sigma,
    (n, c); None: it is alike.
    """

    sigma: Array
    least: Array
    correlation: float = 1.0
    scale: Array | None = None

    def of_samples(self) -> Array:
        """Deviation of the noise of each sample, (n, c), or of all of them alike, (c,)."""
        return self.sigma if self.scale is None else self.sigma * self.scale


def noise_level(time: Array, values: Array, step: Array | None = None) -> Level:
    """Noise of each column of (n, c); 0 where there is none.

    That of rounding to ``step``, (c,), None: ``rounding_steps``, or that of noise where larger: high divided
    differences of a smooth motion shrink with their order, those of white noise do not. Noise that means of
    several samples show more of than white noise leaves them is correlated: what the slowest of these that
    still look like noise show is taken for white. A number that stays the same over several samples counts as
    one observation.
    """
    time = elapsed(time)
    rounding = (rounding_steps(values) if step is None else step) / math.sqrt(12.0)
    runs = 1 + np.count_nonzero(np.diff(values, axis=0), axis=0)
    white, correlation = white_noise(time, values), _correlation(time, values, rounding)
    sigma = np.maximum(rounding * np.sqrt(len(values) / runs), correlation * white)
    # The residuals of correlated noise show less than what slow changes are made of.
    known = (correlation > 1.0) & (white > 0.0)
    return Level(sigma, np.where(known, sigma, rounding), correlation)


def decided_noise(time: Array, values: Array, step: Array) -> float:
    """Deviation of the noise of a sensor's columns, (n, c), where the samples leave no doubt of it; else 0.

    White noise beyond that of rounding to ``step``, (c,), is what differences of order 5, of order 8 and of
    means of two samples agree on, each with its small, usual and large values, in most of the columns: jumps,
    kinks, filtered noise and vibration make these differ.
    """
    half = len(time) // 2
    if half < _LEAST_MEANS:
        return 0.0
    time = elapsed(time)
    pairs = (x[: 2 * half].reshape(half, 2, -1).mean(axis=1) for x in (time, values))
    means_time, means = next(pairs)[:, 0], math.sqrt(2.0) * next(pairs)
    sizes = [*(_differences(time, values, order) for order in (5, 8)), _differences(means_time, means, 8)]
    found = np.concatenate([_size_quantiles(size) for size in sizes])
    usual = np.median(found, axis=0)
    agreed = (found.max(axis=0) < _AGREED * usual) & (usual < _AGREED * found.min(axis=0))
    agreed &= usual > np.maximum(_WELL_BEYOND * step / math.sqrt(12.0), 10.0**-_EXACT_DIGITS)
    return float(np.median(usual[agreed])) if 2 * np.count_nonzero(agreed) > len(usual) else 0.0


def scatter(time: Array, values: Array) -> Array:
    """Size of high differences of columns, (c,): the noise, or what times that are wrong make of a motion."""
    return _levels(elapsed(time), values)[1]


def varying_noise(time: Array, values: Array, rounding: Array) -> tuple[Array, Array] | None:
    """Noise of a sensor's columns, (n, c), that changes: its deviations, (c,), and times these at rows, (n,).

    None: noise that stays, and that of rounding. Of a stretch of rows it is the least that differences of
    several orders show: low ones of the motion are more, and high ones of accelerations that jump.
    """
    if len(time) < 2 * _STRETCH:
        return None
    usual = np.median(np.abs(_differences(elapsed(time), values, 8)), axis=0) / _QUANTILES[1][1]
    noisy = usual > _BEYOND * rounding
    if 2 * np.count_nonzero(noisy) <= np.count_nonzero(np.ptp(values, axis=0)):
        return None
    unit, columns = usual[noisy], values[:, noisy]
    sizes = [np.abs(_differences(elapsed(time), columns, order)) / unit for order in (3, 4, 5, 8)]
    found = [
        np.median(sliding_window_view(each, _STRETCH, axis=0)[:: _STRETCH // 4], axis=(1, 2))
        for each in sizes
    ]
    count = min(map(len, found))
    local = np.min([each[:count] for each in found], axis=0) / _QUANTILES[1][1]
    local = np.maximum(local, max(float(np.median(rounding[noisy] / unit)), local.max() / _MOST_VARIED))
    if local.max() < _VARIES * np.quantile(local, 0.1):
        return None
    every = max(1, (len(time) - 8) // _MOST_DIFFERENCES)
    scale = np.zeros(len(time))
    for i, here in enumerate(local):
        first = i * (_STRETCH // 4)
        # Stretches in which the noise begins show less of it than those beside them.
        rows = slice(first * every if i else 0, (first + _STRETCH) * every + 8 if i < count - 1 else None)
        scale[rows] = np.maximum(scale[rows], here)
    scale /= np.quantile(scale, 0.1)
    white = (
        np.abs(_differences(elapsed(time), values, 8))
        / scale[4 : len(time) - 4 : every, None][: len(sizes[3])]
    )
    return np.maximum(np.median(white, axis=0) / _QUANTILES[1][1], rounding), scale


def rounding_steps(values: Array) -> Array:
    """Step to which each column of (n, c) is rounded, (c,): ``grid_steps``, or ``rounding_step`` without."""
    return np.maximum([rounding_step(column) for column in values.T], grid_steps(values.T))


def rounding_step(values: Array) -> float:
    """Step to which the numbers, (n,), are rounded: by decimals or significant digits; 0 for none found."""
    return max(by for by, _ in _written_steps(values))


def grid_steps(columns: Sequence[Array] | Array) -> Array:
    """Steps of grids other than of decimals, such as a converter's counts, on which columns, (n,) each, are.

    0 for none found: all numbers are whole steps apart, to the digits that are written. Columns of too few
    numbers have the finest step of the others if they fit it.
    """
    steps = np.array([_grid_step(column) for column in columns])
    finest = float(np.min(steps[steps > 0.0], initial=math.inf))
    for i, column in enumerate(columns):
        if steps[i] == 0.0 < np.ptp(column) and finest < math.inf:
            resolved = 2.0 * max(_resolved(column))
            steps[i] = finest * (finest > resolved and _on_grid(column, finest, resolved))
    return steps


def _grid_step(values: Array) -> float:
    """Step of the grid on which the numbers, (n,), are, coarser than what they are written to; 0 for none."""
    some = np.unique(values[:: max(1, len(values) // _ROWS)])
    if len(some) < _FEWEST_NUMBERS:
        return 0.0
    exact, written, _ = allowed = _resolved(values)
    gaps = np.sort(np.diff(some))
    gaps = gaps[gaps > exact]
    for resolved in allowed:
        for step in _steps_of_gaps(gaps, resolved):
            counts = np.rint((some - some[0]) / step)
            counts -= counts.mean()
            step = float(counts @ (some - some.mean()) / (counts @ counts))
            if step < max(_RESOLVED * resolved, _COARSER * written):
                break
            if _on_grid(values, step, resolved):
                changes = np.diff(np.rint((values - some[0]) / step), n=_ORDER)
                return step if np.count_nonzero(changes) > _ROUGH * len(some) else 0.0
    return 0.0


def _resolved(values: Array) -> tuple[float, float, float]:
    """What the numbers, (n,), may resolve: that of doubles, of what is written, and of single precision."""
    largest = float(np.abs(values).max(initial=0.0))
    written = max(most for _, most in _written_steps(values))
    return 10.0**-_EXACT_DIGITS * largest, written, _SINGLE * largest


def _steps_of_gaps(gaps: Array, resolved: float) -> Iterator[float]:
    """Steps of which gaps, (m,), in ascending order, are whole numbers: the least is 1 step, 2 or more."""
    if gaps.size and gaps[0] >= (_RESOLVED - 1.0) * resolved:
        # The least gaps leave few numbers open that the least of them may be.
        for apart in _refined(gaps[:_LEAST_GAPS], np.arange(1.0, _APART + 1.0), resolved)[1]:
            yield from _refined(gaps, np.array([apart]), resolved)[0].tolist()


def _refined(gaps: Array, apart: Array, resolved: float) -> tuple[Array, Array]:
    """Steps, (k,), of which all gaps, (m,), are whole numbers, and how many of them, (k,), the least is.

    apart: numbers to be tried, (n,).
    """
    near, reach = np.searchsorted(gaps, gaps[0] + 2.0 * resolved, side="right"), 1.0
    steps = np.mean(gaps[:near]) / apart
    while np.any(near < len(gaps)):
        # Few steps first, by which the step is known well enough to count many.
        near = np.searchsorted(gaps, reach * (apart + 0.5) * steps)
        within = np.arange(near.max(initial=0)) < near[:, None]
        some = gaps[: within.shape[1]] * within
        counts = np.rint(some / steps[:, None])
        steps = some.sum(axis=1) / counts.sum(axis=1)
        off = np.abs(some - counts * steps[:, None])
        fits = off.max(axis=1, initial=0.0) <= 2.0 * _OFF_GRID * resolved
        apart, steps, near, reach = apart[fits], steps[fits], near[fits], 2.0 * reach
    return steps, apart


def _on_grid(values: Array, step: float, resolved: float) -> bool:
    """Whether numbers, (n,), are whole steps apart, to what they resolve."""
    off = values - values[0]
    off -= step * np.rint(off / step)
    return bool(np.ptp(off) <= 2.0 * _OFF_GRID * resolved)


def _written_steps(values: Array) -> list[tuple[float, float]]:
    """Root mean square and largest step to which the numbers, (n,), are written, in each of two ways.

    By decimals, and by significant digits; as ``rounding_step`` has it.
    """
    largest = float(np.abs(values).max(initial=0.0))
    found = [(0.0, 0.0)]
    if largest == 0.0:
        return found
    decade = math.floor(math.log10(largest))
    some = values[np.abs(values) > 1e-9 * largest]
    decades = np.floor(np.log10(np.abs(some)))
    for digits in range(-1, _EXACT_DIGITS):
        if _written(values, digits, decade):
            found.append((10.0 ** (decade - digits), 10.0 ** (decade - digits)))
            break
    for digits in range(1, _EXACT_DIGITS - 1):
        if _written(some, digits, decades):
            usual = float(np.sqrt(np.mean(10.0 ** (2.0 * (decades - digits)))))
            found.append((usual, 10.0 ** (decade - digits)))
            break
    return found


def white_noise(time: Array, values: Array) -> Array:
    """Standard deviation of noise from one sample to the next, (c,), from divided differences; 0 for none."""
    if len(time) < LEAST_SAMPLES:
        return np.zeros(values.shape[1])
    low, high = _levels(elapsed(time), values)
    counts = high > 10.0**-_EXACT_DIGITS * np.abs(values).max(axis=0)
    noisy = (high > 0.6 * low) & counts
    if 2 * np.count_nonzero(noisy) >= len(noisy):
        # Short logs show it too little in some of the columns of a sensor.
        usual = float(np.median(high[noisy]))
        noisy |= counts & (high > usual / _ALIKE) & (low < usual * _ALIKE)
    return np.where(noisy, high, 0.0)


def like_noise(time: Array, values: Array, sigma: Array) -> Flags:
    """Whether differences of columns, (n, c), n > 8, allow noise sigma, (c,): in none of them it is absent.

    Those of order 8 of a smooth motion are much less than those of order 5, and those of order 3 vanish
    between jumps of an acceleration.
    """
    low, high = (np.sqrt(np.mean(_differences(time, values, order) ** 2, axis=0)) for order in (5, 8))
    small = _size_quantiles(_differences(time, values, 3))[0]
    return np.asarray((high > _LEAST_LIKE * low) & (small > _NOT_ABSENT * sigma))


def _levels(time: Array, values: Array) -> tuple[Array, Array]:
    """Noise as differences of low and of high order show it, (c,) each.

    Of the smallest fifth of them, in which there is no jump of an acceleration.
    """
    low, high = (_size_quantiles(_differences(time, values, order))[0] for order in (5, 8))
    return low, high


def _correlation(time: Array, values: Array, rounding: Array) -> float:
    """How much larger the noise of slow changes is in most columns (n, c); 1 for white noise and for none.

    Of each column with more noise than rounding makes, the longest means count whose differences still look
    like noise, not like motion.
    """
    first = white_noise(time, values)
    changing = np.count_nonzero(np.diff(values, axis=0), axis=0) >= _CHANGING * (len(values) - 1)
    noisy = np.flatnonzero((first > _BEYOND * rounding) & changing)
    if len(noisy) < _FEWEST_COLUMNS:
        return 1.0
    found = np.ones(len(noisy))
    like = np.ones(len(noisy), dtype=bool)
    for length in _MEANS:
        count = len(time) // length
        if count < _LEAST_MEANS or not like.any():
            break
        whole = values[: count * length, noisy].reshape(count, length, -1).mean(axis=1)
        low, high = _levels(time[: count * length].reshape(count, length).mean(axis=1), whole)
        growth = high / first[noisy] * math.sqrt(length)
        like &= (high > _NOISE_LIKE * low) & (growth < _STEEPEST * length)
        found = np.where(like, growth, found)
        if length == _MEANS[0] and np.quantile(found, 1 / 3) < _AT_ONCE:
            return 1.0
    slow = float(np.quantile(found, 1 / 3))
    return slow if slow > _CORRELATED else 1.0


def _written(values: Array, digits: int, decades: Array | int) -> bool:
    """Whether all numbers end so many digits after their decade, or one for all; a few are tried first."""
    for part in (slice(100), slice(None)):
        per_step = 10.0 ** (digits - (decades if isinstance(decades, int) else decades[part]))
        if not (np.rint(values[part] * per_step) / per_step == values[part]).all():
            return False
    return True


def _size_quantiles(differences: Array) -> Array:
    """Small, usual and large sizes of differences, (3, c), over those of a normal number of deviation 1."""
    shares, normal = zip(*_QUANTILES, strict=True)
    return np.asarray(np.quantile(np.abs(differences), shares, axis=0) / np.array(normal)[:, None])


def _differences(time: Array, values: Array, order: int) -> Array:
    """Divided differences of columns, (m, c): white noise of deviation 1 makes them of deviation 1."""
    count = len(time) - order
    at = np.arange(0, count, max(1, count // _MOST_DIFFERENCES))[:, None] + np.arange(order + 1)
    apart = (time[at][:, :, None] - time[at][:, None, :]) / (time[at[:, -1]] - time[at[:, 0]])[:, None, None]
    apart[:, np.arange(order + 1), np.arange(order + 1)] = 1.0
    factors = 1.0 / apart.prod(axis=-1)
    factors /= np.linalg.norm(factors, axis=-1, keepdims=True)
    return np.asarray(np.einsum("nk,nkc->nc", factors, values[at]))
