"""Rows of a log that do not belong to its motion: outliers, frozen rows, and the time around gaps."""

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import median_filter

from ..io.array_types import Array, Flags
from .spline import SmoothCurve, likeliest, smooth_columns

LIMIT = 8.0
"""Number of standard deviations beyond which a row is an outlier."""
_MEDIAN_ROWS = 15
_MOST_ESTIMATES, _MOST_PASSES = 3, 12
# A row is compared with the curve only if the curve is at most so many times as uncertain as a sample.
_MOST_UNCERTAIN = 5.0
_FROZEN_ROWS = 3
_FEWEST_ROWS = 8


@dataclass(frozen=True, eq=False)
class FittedRows:
    """A curve through the good rows of a log, and the rows that it leaves out.

    Attributes
    ----------
    curve : SmoothCurve
        Curve through the good rows.
    outliers, frozen : ndarray of bool, shape (n,)
        Rows that are left out.
    """

    curve: SmoothCurve
    outliers: Flags
    frozen: Flags


def fit_good_rows(
    time: Array,
    values: Array,
    noise_std: Array | None = None,
    least_std: Array | float = 0.0,
    cutoff: float | None = None,
) -> FittedRows:
    """Smooth columns of samples without the rows that contradict the others.

    The first curve uses the rows near the running median. Then rows that agree with the curve are added, and
    others are left out, until the set of rows stays the same. Therefore the size of an error has no effect.

    Parameters
    ----------
    time, values, noise_std, least_std, cutoff
        As in ``smooth_columns``.

    Returns
    -------
    FittedRows
        Curve and rows left out.
    """
    runs = _equal_runs(values)
    used = _near_median(values) & ~runs
    options = noise_std, least_std, cutoff
    for _ in range(_MOST_ESTIMATES):
        if np.count_nonzero(used) < _FEWEST_ROWS:
            used = np.ones(len(time), dtype=bool)
        smoothness = likeliest(time[used], values[used], *options)
        before = used
        for _ in range(_MOST_PASSES):
            curve = smooth_columns(time[used], values[used], *options, smoothness)
            found = _agree(curve, time, values, used, runs)
            if np.array_equal(found, used):
                break
            used = found
        if np.array_equal(used, before):
            break
    return FittedRows(curve, ~used & ~runs, ~used & runs)


def _near_median(values: Array) -> Flags:
    """Return True for rows whose columns are all near their running medians."""
    off = np.abs(values - median_filter(values, size=(_MEDIAN_ROWS, 1), mode="nearest"))
    usual = 1.4826 * np.median(off, axis=0)
    usual = np.maximum(usual, np.mean(off, axis=0) * 1e-3)
    return np.asarray((off <= LIMIT * usual).all(axis=1))


def _equal_runs(values: Array) -> Flags:
    """Return True for rows that repeat the row before in all columns, in runs of three or more rows."""
    repeated = np.concatenate([[False], (np.diff(values, axis=0) == 0.0).all(axis=1)])
    edges = np.flatnonzero(np.diff(np.concatenate([[False], repeated, [False]]).astype(int)))
    found = np.zeros(len(values), dtype=bool)
    for first, end in edges.reshape(-1, 2):
        if end - first + 1 >= _FROZEN_ROWS:
            found[first:end] = True
    return found


def _agree(curve: SmoothCurve, time: Array, values: Array, used: Flags, runs: Flags) -> Flags:
    """Return the rows that agree with the curve; of a run of equal rows all or none."""
    variance = np.maximum(curve.covariance(time)[..., 0], 0.0)
    noise = np.maximum(curve.noise_std, 1e-12 * np.abs(values).max(axis=0))
    off = np.abs(values - curve.evaluate(time)[0])
    agree = (off <= LIMIT * np.sqrt(noise**2 + variance)).all(axis=1)
    certain = (variance <= (_MOST_UNCERTAIN * noise) ** 2).all(axis=1)
    # A row inside a gap is added after its neighbors.
    reached = certain | np.convolve(used, np.ones(3), "same").astype(bool)
    found = agree & reached
    edges = np.flatnonzero(np.diff(np.concatenate([[False], runs, [False]]).astype(int)))
    for first, end in edges.reshape(-1, 2):
        found[first:end] = agree[first:end].all()
    return found
