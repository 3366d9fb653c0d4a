"""Rates of a log: curves through its poses or leg lengths, with standard deviations, without bad rows."""

import itertools
import math
from collections.abc import Callable, Sequence

import numpy as np
from scipy.interpolate import make_interp_spline

from ..io.array_types import Array, Flags, Indices
from .bad_rows import FittedRows, fit_good_rows, flagged_spans
from .log_samples import LogSamples, line_ranges, warn_of
from .sample_times import elapsed, time_text
from .spline import DEGREE, PAIRS, SmoothCurves
from .trajectory import LEAST_NOISE, Replaced, SmoothingOptions, Uncertainty, noise_text
from .trajectory_format import ANGLE_UNITS, LENGTH_UNITS

# Number of rows per period below which accelerations are inaccurate, and range of a moving column in standard
# deviations of its noise.
_FEWEST_PER_PERIOD, _VISIBLE = 6, 50.0
# Ratio of the noise of columns, and fraction of the range, from which noise may be a fast motion.
_UNLIKE, _TAKEN_FOR_NOISE = 30.0, 0.05
# Numbers of rows that a spline and smoothing require.
_FEWEST_ROWS, _FEWEST_SMOOTHED = 4, 12
# Standard deviations of rates and second rates of an interpolating spline for noise 1 and steps 1, inside.
_RATE, _SECOND_RATE = 1.38, 4.8
# Components of a covariance that are variances.
_VARIANCES = [0, 2, 5]
# Noise is negligible if its accelerations are less than this fraction of the largest one, or of gravity.
_NEGLIGIBLE = 1e-5
_GRAVITY = 9.81
# Ratio of the stated and the estimated noise, or its inverse, that is a contradiction, and the number of rows
# from which the noise is estimated.
_CONTRADICTS, _COMPARED_ROWS = 5.0, 1 << 13
# Distances of covariances in periods of the fastest motion, and distances from the ends of parts of a log.
_EVEN, _NEAR_EDGES = 0.25, np.linspace(0.04, 1.0, 25)
# A step this many times as long as nine of ten is a gap.
_GAP = 8.0


def rates_of(
    log: LogSamples, options: SmoothingOptions, values: Array, steps: Array
) -> tuple[Array, Uncertainty | None]:
    """Compute coordinates with rates and second rates, (3, n, 6), and their uncertainty or None.

    ``values``, (n, 6), are poses or leg lengths (SI), which are rounded to ``steps``, (6,).
    """
    assert log.time is not None
    since = elapsed(log.time)
    if len(since) < _FEWEST_ROWS:
        raise ValueError(
            f"{log.source}: too few rows for rates, {len(since)}; add rows, or columns of all rates"
        )
    if not options.enabled:
        return _interpolated(since, values), None
    rounding, stated = steps / math.sqrt(12.0), _stated(log, options)
    if len(since) < _FEWEST_SMOOTHED:
        found = _interpolated(since, values)
        return found, _of_few_rows(log, found, stated, rounding)
    fitted = fit_good_rows(since, values, stated, rounding, options.cutoff_frequency)
    if options.cutoff_frequency is not None or not np.isnan(stated).all():
        first = max((len(since) - _COMPARED_ROWS) // 2, 0)
        some = slice(first, first + _COMPARED_ROWS)
        estimated = fit_good_rows(since[some], values[some], None, rounding).curves.noise_std
        _check_options(log, options, fitted.curves.noise_std, estimated)
    used = ~(fitted.outliers | fitted.frozen)
    _warn_of_rows(log, used, fitted)
    found = fitted.curves.evaluate(since)
    clean = _is_clean(since[used], fitted.curves, found[2])
    if options.cutoff_frequency is None and clean.any():
        found[:, :, clean] = _interpolated(since[used], values[used][:, clean], since)
    coarse = _coarse_columns(log, since, found, fitted)
    if clean.all() and used.all() and np.isnan(stated).all() and not coarse.any():
        return found, None
    uncertainty = _of_curve(log, fitted.curves, used, clean)
    # Accelerations of such a column are unknown, so that limits are inconclusive.
    fastest = _SECOND_RATE * fitted.curves.noise_std / float(np.median(np.diff(since))) ** 2
    unknown = np.mean(found[2] ** 2, axis=0) + fastest**2
    uncertainty.covariance[:, coarse, -1] += unknown[coarse]
    # Noise of half a step or less cannot be distinguished from rounding.
    if np.any((uncertainty.sigma > 0.5 * steps)[~clean]):
        remedy = "; position_std replaces the estimate" if np.isnan(stated).all() else ""
        form = log.file_format
        noise = noise_text(uncertainty.sigma, "L" in log.vectors, form.length_unit, form.angle_unit)
        warn_of(log, f"{noise}; the columns are smoothed{remedy}")
    return found, uncertainty


def as_given(
    log: LogSamples, options: SmoothingOptions, found: Array, steps: Sequence[Array]
) -> Uncertainty | None:
    """Return the uncertainty of coordinates, rates, and second rates that were all measured, (3, n, 6)."""
    sigma = np.array(steps) / math.sqrt(12.0)
    stated = _stated(log, options)
    sigma[0] = np.where(np.isnan(stated), sigma[0], stated)
    return _constant(log, sigma) if options.enabled else None


def _of_few_rows(log: LogSamples, found: Array, stated: Array, rounding: Array) -> Uncertainty | None:
    """Return the uncertainty of interpolated rows that are too few for an estimate of their noise."""
    unknown = np.isnan(stated) & (np.ptp(found[0], axis=0) > 0.0)
    noise = np.where(np.isnan(stated), rounding, stated)
    sigma = np.sqrt(_interpolated_variances(log.time, noise)).T
    # Limits are then inconclusive.
    sigma[2] = np.hypot(sigma[2], np.where(unknown, np.abs(found[2]).max(axis=0), 0.0))
    if unknown.any():
        finding = f"{len(found[0])} rows are too few for an estimate of their noise"
        warn_of(log, f"{finding}; accelerations are unknown; add rows, or state position_std")
    return _constant(log, sigma)


def _constant(log: LogSamples, sigma: Array) -> Uncertainty | None:
    """Return the uncertainty for standard deviations, (3, 6), that are equal at all times; None for 0."""
    assert log.time is not None
    if not sigma.any():
        return None
    covariance = np.zeros((2, 6, len(PAIRS)))
    covariance[..., _VARIANCES] = sigma.T**2
    return Uncertainty(log.time[[0, -1]], covariance, sigma[0])


def _check_options(log: LogSamples, options: SmoothingOptions, assumed: Array, estimated: Array) -> None:
    """Warn of a stated noise, or of a cut-off frequency, that contradicts the estimated noise, both (6,)."""
    ratio = np.where(estimated > LEAST_NOISE, assumed / np.maximum(estimated, LEAST_NOISE), 1.0)
    column = int(np.argmax(np.abs(np.log(ratio))))
    is_length = column < 3 or "L" in log.vectors
    unit = (log.file_format.length_unit or "m") if is_length else (log.file_format.angle_unit or "rad")
    scatter = estimated[column] / (LENGTH_UNITS | ANGLE_UNITS)[unit]
    factor = f"{ratio[column]:.2g} times the scatter of the rows ({scatter:.2g} {unit})"
    if options.cutoff_frequency is not None and ratio.max() > _CONTRADICTS:
        finding = f"the cut-off frequency removes {factor}"
        warn_of(log, f"{finding}; the deviations do not include removed motion; raise the frequency")
    elif options.cutoff_frequency is None and not 1.0 / _CONTRADICTS < ratio[column] < _CONTRADICTS:
        name = "position_std" if is_length else "angle_std"
        warn_of(log, f"{name} is {factor}; smoothing and deviations are wrong; check the unit of {name}")


def _stated(log: LogSamples, options: SmoothingOptions) -> Array:
    """Return the stated standard deviation of each coordinate; NaN if none is stated."""
    stated = (options.position_std, options.position_std if "L" in log.vectors else options.angle_std)
    return np.repeat([math.nan if each is None else each for each in stated], 3)


def _gaps(time: Array) -> Indices:
    """Return the index of the first row after each gap."""
    step = np.diff(time)
    return np.flatnonzero(step > _GAP * np.quantile(step, 0.9)) + 1


def _interpolated(since: Array, values: Array, at: Array | None = None) -> Array:
    """Return values and derivatives of splines through rows, one for each part between gaps, (3, n, c).

    Rows are not divided if a part has too few rows for a spline.
    """
    at = since if at is None else at
    found = np.empty((3, len(at), values.shape[1]))
    edges = [0, *_gaps(since).tolist(), len(since)]
    edges = edges if min(np.diff(edges)) >= _FEWEST_ROWS else [0, len(since)]
    starts = [0, *np.searchsorted(at, since[edges[1:-1]]).tolist(), len(at)]
    for i, (first, end) in enumerate(itertools.pairwise(edges)):
        degree, part = DEGREE if end - first > DEGREE else 3, slice(starts[i], starts[i + 1])
        spline: Callable[..., Array] = make_interp_spline(since[first:end], values[first:end], k=degree)
        for order in range(3):
            found[order, part] = spline(at[part], order)
    return found


def _is_clean(since: Array, curves: SmoothCurves, second_rates: Array) -> Flags:
    """Return True for columns whose noise has no effect on accelerations even without smoothing."""
    step = float(np.median(np.diff(since)))
    largest = np.maximum(np.abs(second_rates).max(axis=0), _GRAVITY)
    return np.asarray(_SECOND_RATE * curves.noise_std / step**2 < _NEGLIGIBLE * largest)


def _interpolated_variances(time: Array | None, sigma: Array) -> Array:
    """Return variances of values, rates, and second rates of interpolated columns, (c, 3)."""
    assert time is not None
    step = float(np.median(np.diff(time)))
    return np.asarray((sigma[:, None] * [1.0, _RATE / step, _SECOND_RATE / step**2]) ** 2)


def _of_curve(log: LogSamples, curves: SmoothCurves, used: Flags, clean: Flags) -> Uncertainty:
    """Return the uncertainty of smoothed columns, on a grid that is fine near rows that are left out."""
    assert log.time is not None
    since = elapsed(log.time)
    runs = [(max(a - 1, 0), min(b, len(used) - 1)) for a, b in zip(*flagged_spans(~used), strict=True)]
    inside = [np.linspace(since[a], since[b], 9) for a, b in runs]
    period = min(curve.period for curve in curves.columns)
    even = np.linspace(0.0, since[-1], min(math.ceil(since[-1] / (_EVEN * period)), len(since)) + 1)
    edges = since[[0, -1, *itertools.chain(*runs)]]
    near = [edges + side * distance * period for side in (-1.0, 1.0) for distance in _NEAR_EDGES]
    grid = np.unique(np.clip(np.concatenate([even, edges, *near, *inside]), 0.0, since[-1]))
    covariance = curves.covariance(grid)
    exact = _interpolated_variances(log.time, np.where(clean, curves.noise_std, 0.0))
    covariance[..., _VARIANCES] = np.maximum(covariance[..., _VARIANCES], exact)
    replaced = tuple(
        Replaced(float(log.time[a]), float(log.time[b]), (f"lines {log.lines[a]} to {log.lines[b]}",))
        for a, b in runs
    )
    return Uncertainty(log.time[0] + grid, covariance, curves.noise_std, replaced)


def _warn_of_rows(log: LogSamples, used: Flags, fitted: FittedRows) -> None:
    """Warn of rows that are left out, and of gaps."""
    assert log.time is not None
    kinds = {"outliers": fitted.outliers, "frozen rows": fitted.frozen}
    texts = [f"{name} ({line_ranges(log.lines[rows])})" for name, rows in kinds.items() if rows.any()]
    if texts:
        advice = "check the deviations there, or leave out more with drop_lines"
        warn_of(log, f"{' and '.join(texts)}; they are not used; {advice}")
    step, gaps = np.diff(log.time[used]), _gaps(log.time[used]) - 1
    if gaps.size:
        i = int(gaps[np.argmax(step[gaps])])
        start, end = (time_text(each, float(np.median(step))) for each in log.time[used][i : i + 2])
        more = f" and {gaps.size - 1} more" if gaps.size > 1 else ""
        advice = "the motion in it is uncertain; add rows, or cut the log"
        warn_of(log, f"gap from {start} s to {end} s{more}; {advice}")


def _coarse_columns(log: LogSamples, since: Array, found: Array, fitted: FittedRows) -> Flags:
    """Return True for columns with few rows per period of a sine with the same rates, with a warning."""
    rate, second_rate = np.sqrt(np.mean(found[1:] ** 2, axis=1))
    step = float(np.median(np.diff(since)))
    # Differences of noise have less than four rows per period.
    moves = np.ptp(found[0], axis=0) > _VISIBLE * np.maximum(fitted.curves.noise_std, 1e-12)
    rows = np.where(moves, 2.0 * math.pi * rate / np.maximum(second_rate, 1e-300), math.inf) / step
    # The columns of a sensor have similar noise; columns at rest may be exact.
    noise = fitted.curves.noise_std
    least = np.repeat(np.where(moves & (noise > 0.0), noise, math.inf).reshape(2, 3).min(axis=1), 3)
    unlike = (noise > _UNLIKE * least) & (noise > _TAKEN_FOR_NOISE * np.ptp(found[0], axis=0))
    coarse = (rows < _FEWEST_PER_PERIOD) | unlike
    if coarse.any():
        finding = f"about {rows.min():.2g} rows per period of the fastest motion"
        if unlike.any():
            ratio = float((noise / least).max())
            finding = f"one column has {ratio:.2g} times the noise of the others, or a fast motion"
        warn_of(log, f"{finding}; accelerations are unknown; log {2 * _FEWEST_PER_PERIOD} rows or more")
    return np.asarray(coarse)
