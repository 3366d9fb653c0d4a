"""Rows of a log that do not belong to its motion: outliers, frozen rows, and the time around gaps."""

from typing import NamedTuple

import numpy as np
from scipy.ndimage import maximum_filter1d

from ..io.array_types import Array, Flags, Indices
from .spline import PAIRS, SmoothCurve, Smoother

LIMIT = 8.0
"""Number of standard deviations beyond which a row is an outlier."""
# Distances (rows) of the rows on each side from which a row is first predicted, twice. Five bad rows disturb
# at most one of both predictions.
_PREDICTORS = ((3, 8), (13, 18))
_BLOCK_ROWS = 100
_MOST_ESTIMATES, _MOST_PASSES = 2, 12
# A row is compared with the curve only if the curve is at most so many times as uncertain as a sample.
_MOST_UNCERTAIN = 5.0
# Errors below this fraction of the usual second difference have no effect.
_NEGLIGIBLE = 1e-3
# Rounding error of a curve relative to the largest value of its column.
_ROUNDING = 1e-10
_FROZEN_ROWS = 3
_FEWEST_ROWS = 12


class FittedRows(NamedTuple):
    """Curves through the good rows of a log, and the rows that they leave out."""

    curves: list[SmoothCurve]
    outliers: Flags
    frozen: Flags


def fit_good_rows(smoother: Smoother) -> FittedRows:
    """Smooth columns of samples without the rows that contradict the others.

    The first curves use the rows that their neighbors predict. Then rows that agree with the curves are
    added, and others are left out, until the set of rows stays the same. Therefore the size of an error has
    no effect.
    """
    runs = _equal_runs(smoother.values)
    used = _near_predictions(smoother.values) & ~runs
    for _ in range(_MOST_ESTIMATES):
        if np.count_nonzero(used) < _FEWEST_ROWS:
            used = np.ones(len(used), dtype=bool)
        before, smoothness = used, smoother.likeliest(used)
        for distance in 2 ** np.arange(_MOST_PASSES):
            curves = smoother.curves(smoothness, used)
            found = _agree(curves, smoother, runs, maximum_filter1d(used, 2 * distance + 1))
            # A stated noise that is much too small makes all rows outliers.
            if np.array_equal(found, used) or np.count_nonzero(found) < _FEWEST_ROWS:
                break
            used = found
        if np.array_equal(used, before):
            break
    return FittedRows(curves, ~used & ~runs, ~used & runs)


def _near_predictions(values: Array) -> Flags:
    """Return True for rows whose columns are all near a cubic polynomial through two rows on each side.

    The scale of the differences is the largest median of the adjacent blocks of rows.
    """
    most, count = _PREDICTORS[-1][-1], len(values)
    if count <= 2 * most:
        return np.ones(count, dtype=bool)
    padded = np.pad(values, ((most, most), (0, 0)), mode="reflect", reflect_type="odd")
    off = np.full(values.shape, np.inf)
    for near, far in _PREDICTORS:
        sums = [padded[most - k :][:count] + padded[most + k :][:count] for k in (near, far)]
        predicted = (far**2 * sums[0] - near**2 * sums[1]) / (2.0 * (far**2 - near**2))
        off = np.minimum(off, np.abs(values - predicted))
    starts = np.arange(0, max(count - _BLOCK_ROWS // 2, 1), _BLOCK_ROWS)
    whole = off[: starts[-1]].reshape(-1, _BLOCK_ROWS, values.shape[1])
    medians = np.vstack([np.median(whole, axis=1), np.median(off[starts[-1] :], axis=0)])
    usual = np.repeat(maximum_filter1d(medians, 3, axis=0), np.diff([*starts, count]), axis=0)
    return np.asarray((off <= LIMIT * 1.4826 * usual).all(axis=1))


def _equal_runs(values: Array) -> Flags:
    """Return True for rows that repeat the row before in all columns, in runs of three or more rows.

    Equal rows at the beginning and the end of a log are rest.
    """
    repeated = np.concatenate([[False], (np.diff(values, axis=0) == 0.0).all(axis=1)])
    starts, ends = flagged_spans(repeated)
    found = np.zeros(len(values) + 1, dtype=int)
    long = (ends - starts + 1 >= _FROZEN_ROWS) & (starts > 1) & (ends < len(values))
    found[starts[long]], found[ends[long]] = 1, -1
    return np.cumsum(found[:-1]) > 0


def flagged_spans(flags: Flags) -> tuple[Indices, Indices]:
    """Return the first index of each run of flags, and the index after its last one."""
    edges = np.flatnonzero(np.diff(flags.astype(np.int8), prepend=0, append=0))
    return edges[::2], edges[1::2]


def _agree(curves: list[SmoothCurve], smoother: Smoother, runs: Flags, near: Flags) -> Flags:
    """Return the rows that agree with the curves; of a run of equal rows all or none.

    A row where the curves are uncertain, inside a gap, is compared only if it is near other rows.
    """
    agree, certain = np.ones((2, len(runs)), dtype=bool)
    for curve, column in zip(curves, smoother.values.T, strict=True):
        variance = np.maximum(curve.covariance(curve.knots, PAIRS[:1])[:, 0], 0.0)
        variance = np.interp(smoother.time, curve.knots, variance)
        bend = float(np.median(np.abs(np.diff(column, 2))))
        noise = max(curve.noise_std, _NEGLIGIBLE * bend, _ROUNDING * float(np.abs(column).max()))
        agree &= np.abs(column - curve.values) <= LIMIT * np.sqrt(noise**2 + variance)
        certain &= variance <= (_MOST_UNCERTAIN * noise) ** 2
    found = agree & (certain | near)
    for first, end in zip(*flagged_spans(runs), strict=True):
        found[first:end] = agree[first:end].all()
    return found
