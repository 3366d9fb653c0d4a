"""Rows of a log that do not belong to its motion: outliers, frozen rows, and the time around gaps."""

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import maximum_filter1d

from ..io.array_types import Array, Flags
from .spline import SmoothCurves, likeliest, smooth_columns

LIMIT = 8.0
"""Number of standard deviations beyond which a row is an outlier."""
# Distances of the rows with which a row is first compared: of five bad rows, at most one is among them.
_DISTANCES = (3, 8, 13)
_BLOCK_ROWS = 100
_MOST_ESTIMATES, _MOST_PASSES = 3, 12
# A row is compared with the curve only if the curve is at most so many times as uncertain as a sample.
_MOST_UNCERTAIN = 5.0
_FROZEN_ROWS = 3
_FEWEST_ROWS = 12


@dataclass(frozen=True, eq=False)
class FittedRows:
    """Curves through the good rows of a log, and the rows that they leave out.

    Attributes
    ----------
    curves : SmoothCurves
        Curves through the good rows.
    outliers, frozen : ndarray of bool, shape (n,)
        Rows that are left out.
    """

    curves: SmoothCurves
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

    The first curves use the rows near their neighbors. Then rows that agree with the curves are added, and
    others are left out, until the set of rows stays the same. Therefore the size of an error has no effect.

    Parameters
    ----------
    time, values, noise_std, least_std, cutoff
        As in ``smooth_columns``.

    Returns
    -------
    FittedRows
        Curves and rows left out.
    """
    runs = _equal_runs(values)
    used = _near_neighbors(values) & ~runs
    options = noise_std, least_std, cutoff
    for _ in range(_MOST_ESTIMATES):
        if np.count_nonzero(used) < _FEWEST_ROWS:
            used = np.ones(len(time), dtype=bool)
        smoothness = likeliest(time[used], values[used], *options)
        before = used
        for _ in range(_MOST_PASSES):
            curves = smooth_columns(time[used], values[used], *options, smoothness)
            found = _agree(curves, time, values, used, runs)
            if np.array_equal(found, used):
                break
            used = found
        if np.array_equal(used, before):
            break
    return FittedRows(curves, ~used & ~runs, ~used & runs)


def _near_neighbors(values: Array) -> Flags:
    """Return True for rows whose columns are all near the line between rows before and after them.

    The scale of the differences is the largest median of the adjacent blocks of rows.
    """
    most, count = min(_DISTANCES[-1], len(values) - 1), len(values)
    padded = np.pad(values, ((most, most), (0, 0)), mode="reflect", reflect_type="odd")
    shifts = [min(distance, most) for distance in _DISTANCES]
    sides = [[padded[most + sign * k :][:count] for k in shifts] for sign in (-1, 1)]
    off = np.abs(values - 0.5 * (np.median(sides[0], axis=0) + np.median(sides[1], axis=0)))
    starts = np.arange(0, max(count - _BLOCK_ROWS // 2, 1), _BLOCK_ROWS)
    medians = [np.median(block, axis=0) for block in np.split(off, starts[1:])]
    usual = np.repeat(maximum_filter1d(medians, 3, axis=0), np.diff([*starts, count]), axis=0)
    return np.asarray((off <= LIMIT * 1.4826 * usual).all(axis=1))


def _equal_runs(values: Array) -> Flags:
    """Return True for rows that repeat the row before in all columns, in runs of three or more rows."""
    repeated = np.concatenate([[False], (np.diff(values, axis=0) == 0.0).all(axis=1)])
    starts, ends = flagged_spans(repeated)
    found = np.zeros(len(values) + 1, dtype=int)
    long = ends - starts + 1 >= _FROZEN_ROWS
    found[starts[long]], found[ends[long]] = 1, -1
    return np.cumsum(found[:-1]) > 0


def flagged_spans(flags: Flags) -> tuple[Array, Array]:
    """Return the first index of each run of flags, and the index after its last one."""
    edges = np.flatnonzero(np.diff(flags.astype(np.int8), prepend=0, append=0))
    return edges[::2], edges[1::2]


def _agree(curves: SmoothCurves, time: Array, values: Array, used: Flags, runs: Flags) -> Flags:
    """Return the rows that agree with the curves; of a run of equal rows all or none."""
    agree, certain = np.ones((2, len(time)), dtype=bool)
    for curve, column in zip(curves.columns, values.T, strict=True):
        knots = curve.knots
        variance = np.interp(time, knots, np.maximum(curve.covariance(knots)[:, 0], 0.0))
        noise = max(curve.noise_std, 1e-12 * float(np.abs(column).max()))
        agree &= np.abs(column - curve.evaluate(time)[0]) <= LIMIT * np.sqrt(noise**2 + variance)
        certain &= variance <= (_MOST_UNCERTAIN * noise) ** 2
    # A row inside a gap is added after its neighbors.
    found = agree & (certain | np.convolve(used, np.ones(3), "same").astype(bool))
    for first, end in zip(*flagged_spans(runs), strict=True):
        found[first:end] = agree[first:end].all()
    return found
