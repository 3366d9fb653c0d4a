"""Rates of a log: curves through its good rows, with standard deviations, and checks of given rates."""

import math
from collections.abc import Callable, Sequence

import numpy as np
from scipy.interpolate import make_interp_spline

from ..io.array_types import Array, Flags, Indices
from .bad_rows import FittedRows, fit_good_rows, flagged_spans
from .log_samples import LogSamples, line_ranges, warn_of
from .sample_times import elapsed, time_text
from .spline import DEGREE, PAIRS, SmoothCurve, Smoother
from .trajectory import LEAST_NOISE, Replaced, SmoothingOptions, Uncertainty, noise_text
from .trajectory_format import ANGLE_UNITS, LENGTH_UNITS

# Number of rows per period below which accelerations are inaccurate, and range of a moving column in standard
# deviations of its noise.
_FEWEST_PER_PERIOD, _VISIBLE = 6, 50.0
# Numbers of rows that a spline and smoothing require.
_FEWEST_ROWS, _FEWEST_SMOOTHED = 4, 12
# Standard deviations of values, rates, and second rates of an interpolating spline for noise 1 and steps 1.
_GAINS = np.array([1.0, 1.38, 4.8])
# Noise is negligible if its accelerations are less than this fraction of the largest one, or of gravity.
_NEGLIGIBLE = 1e-5
_GRAVITY = 9.81
# Ratio of the stated and the estimated noise, or its inverse, above which they contradict each other.
_CONTRADICTS = 5.0
# A step this many times as long as nine of ten is a gap.
_GAP = 8.0
# Distance (decades) from a power of 1000 of the ratio of changes to integrals if a unit is wrong.
_NEAR_UNIT = 0.2
# Largest differences of changes and integrals, relative to the changes, in addition to noise: of positions
# and of rates, whose derivatives may have peaks between the samples.
_OFF_POSITIONS, _OFF_RATES = 0.05, 1.1
# Number of standard deviations of noise that are no contradiction.
_SURE = 5.0
# Orders of the differences that contain noise, for few and for many samples, and median of the magnitude of a
# standard normal distribution.
_ORDER, _HIGH_ORDER, _MEDIAN_OF_NORMAL = 6, 10, 0.6745
# Largest bias of rates, relative to their root mean square, that is no contradiction.
_BIAS = 0.05


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
        return _interpolated(since, values, since), None
    rounding, stated = steps / math.sqrt(12.0), _stated(log, options)
    if len(since) < _FEWEST_SMOOTHED:
        return _few_rows(log, values, stated, rounding)
    smoother = Smoother(since, values, stated, rounding, options.cutoff_frequency)
    fitted = fit_good_rows(smoother)
    curves, used = fitted.curves, ~(fitted.outliers | fitted.frozen)
    sigma = np.array([curve.noise_std for curve in curves])
    if options.cutoff_frequency is not None or not np.isnan(stated).all():
        _check_options(log, options, sigma, np.maximum(scatter(values, _HIGH_ORDER), rounding))
    _warn_of_rows(log, used, fitted)
    found, step = smoother.derivatives(curves), float(np.median(np.diff(since)))
    unsmoothed = _GAINS[2] * sigma / step**2
    clean = unsmoothed < _NEGLIGIBLE * np.maximum(np.abs(found[2]).max(axis=0), _GRAVITY)
    whole = not _gaps(since[used]).size
    if options.cutoff_frequency is None and clean.all() and whole:
        found = _interpolated(since[used], values[used], since)
    coarse = _coarse_columns(log, step, found, sigma)
    if clean.all() and used.all() and whole and np.isnan(stated).all() and not coarse.any():
        return found, None
    uncertainty = _uncertainty(log, curves, used)
    # Accelerations of such a column are unknown, so that limits are inconclusive.
    unknown = np.mean(found[2] ** 2, axis=0) + unsmoothed**2
    uncertainty.covariance[:, coarse, -1] += unknown[coarse]
    # Noise of half a step or less cannot be distinguished from rounding.
    if np.any((uncertainty.sigma > 0.5 * steps)[~clean]):
        remedy = "; position_std replaces the estimate" if np.isnan(stated).all() else ""
        form = log.file_format
        noise = noise_text(uncertainty.sigma, "L" in log.vectors, form.length_unit, form.angle_unit)
        warn_of(log, f"{noise}; the columns are smoothed{remedy}")
    return found, uncertainty


def as_given(log: LogSamples, options: SmoothingOptions, steps: Sequence[Array]) -> Uncertainty | None:
    """Return the uncertainty of measured coordinates, rates, and second rates, rounded to ``steps``."""
    sigma = np.array(steps) / math.sqrt(12.0)
    stated = _stated(log, options)
    sigma[0] = np.where(np.isnan(stated), sigma[0], stated)
    return _constant(log, sigma) if options.enabled else None


def _few_rows(
    log: LogSamples, values: Array, stated: Array, rounding: Array
) -> tuple[Array, Uncertainty | None]:
    """Interpolate rows that are too few for an estimate of their noise."""
    assert log.time is not None
    since = elapsed(log.time)
    found = _interpolated(since, values, since)
    step = float(np.median(np.diff(log.time)))
    sigma = np.where(np.isnan(stated), rounding, stated) * (_GAINS / step ** np.arange(3))[:, None]
    unknown = np.isnan(stated) & (np.ptp(values, axis=0) > 0.0)
    if unknown.any():
        finding = f"{len(values)} rows are too few for an estimate of their noise"
        warn_of(log, f"{finding}; accelerations are unknown; add rows, or state position_std")
        # Limits are then inconclusive.
        sigma[2] += np.where(unknown, np.abs(found[2]).max(axis=0), 0.0)
    return found, _constant(log, sigma)


def _constant(log: LogSamples, sigma: Array) -> Uncertainty | None:
    """Return the uncertainty for standard deviations, (3, 6), that are equal at all times; None for 0."""
    assert log.time is not None
    if not sigma.any():
        return None
    covariance = np.zeros((2, 6, len(PAIRS)))
    covariance[..., [i == k for i, k in PAIRS]] = sigma.T**2
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


def _interpolated(since: Array, values: Array, at: Array) -> Array:
    """Return values, rates, and second rates at times (s) of a spline through rows, (3, n, c)."""
    spline: Callable[..., Array] = make_interp_spline(since, values, DEGREE if len(since) > DEGREE else 3)
    return np.stack([spline(at, order) for order in range(3)])


def _uncertainty(log: LogSamples, curves: list[SmoothCurve], used: Flags) -> Uncertainty:
    """Return the uncertainty of smoothed columns at every second one of the finest knots."""
    assert log.time is not None
    runs = [(max(a - 1, 0), min(b, len(used) - 1)) for a, b in zip(*flagged_spans(~used), strict=True)]
    replaced = tuple(
        Replaced(float(log.time[a]), float(log.time[b]), (f"lines {log.lines[a]} to {log.lines[b]}",))
        for a, b in runs
    )
    knots = min(curves, key=lambda curve: curve.step).knots
    grid = np.append(knots[:-1:2], knots[-1])
    covariance = np.stack([curve.covariance(grid) for curve in curves], axis=1)
    sigma = np.array([curve.noise_std for curve in curves])
    return Uncertainty(log.time[0] + grid, covariance, sigma, replaced)


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


def _coarse_columns(log: LogSamples, step: float, found: Array, noise: Array) -> Flags:
    """Return True for columns with few rows per period of a sine with the same rates, with a warning."""
    rate, second_rate = np.sqrt(np.mean(found[1:] ** 2, axis=1))
    # Differences of noise have less than four rows per period.
    moves = np.ptp(found[0], axis=0) > _VISIBLE * np.maximum(noise, 1e-12)
    rows = np.where(moves, 2.0 * math.pi * rate / np.maximum(second_rate, 1e-300), math.inf) / step
    coarse = np.asarray(rows < _FEWEST_PER_PERIOD)
    if coarse.any():
        finding = f"about {rows.min():.2g} rows per period of the fastest motion"
        warn_of(log, f"{finding}; accelerations are unknown; log {2 * _FEWEST_PER_PERIOD} rows or more")
    return coarse


def rate_error(time: Array, found: Array) -> tuple[str, str | None]:
    """Compare the integrals of rates with changes of positions, and of second rates with changes of rates.

    ``found``, (3, n, c), are positions, rates, and second rates at increasing times (s). Returns the
    contradiction or an empty text, and the unit of time in which there is none, or None. A linear drift,
    for example due to a bias of the rates, is no contradiction. The tolerance includes the difference of
    two rules of integration, which is large for coarse samples.
    """
    if len(time) < _FEWEST_ROWS or not found[1:].any():
        return "", None
    since = elapsed(time)
    span, spread = float(since[-1]), float(np.sqrt(np.sum(np.diff(since) ** 2)))
    for value, rate, names, most in (
        (found[0], found[1], ("positions", "rates"), _OFF_POSITIONS),
        (found[1], found[2], ("rates", "second rates"), _OFF_RATES),
    ):
        change = value - value[0]
        trapezoids, integral = (make_interp_spline(since, rate, k).antiderivative()(since) for k in (1, 3))
        coarse = _rms(integral - trapezoids)
        noise = _SURE * (_rms(scatter(value)) + _rms(scatter(rate)) * spread) + coarse
        size, expected = _rms(change), _rms(integral)
        if max(size, expected) <= noise:
            continue
        decades = math.log10(size / expected) if size and expected else 0.0
        nearest = 3 * round(decades / 3)
        if nearest and abs(decades - nearest) < _NEAR_UNIT:
            unit = {-3: "ms", -6: "us"}.get(nearest)
            return f"{names[0]} change by {size / expected:.2g} times the integral of {names[1]}", unit
        off = _rms(_without_drift(change - integral, _BIAS * _rms(rate) * span))
        if off > most * size + noise + 1e-9 * float(np.abs(change).max()):
            difference = f"{off / size:.0%} of the changes" if size else "a part"
            return f"the integral of {names[1]} differs from the {names[0]} by {difference}", None
    return "", None


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


def scatter(values: Array, order: int = _ORDER) -> Array:
    """Return the noise of samples (n, c) by their differences of high order, (c,); 0 for few samples."""
    if len(values) <= 2 * order:
        return np.zeros(values.shape[1])
    usual = np.median(np.abs(np.diff(values, order, axis=0)), axis=0)
    return np.asarray(usual / (_MEDIAN_OF_NORMAL * math.sqrt(math.comb(2 * order, order))))


def _without_drift(values: Array, most: float) -> Array:
    """Subtract a straight line with a change of at most ``most`` from each column."""
    x = np.linspace(-1.0, 1.0, len(values))[:, None]
    slope = np.sum(x * values, axis=0) / max(float(np.sum(x**2)), 1.0)
    return np.asarray(values - values.mean(axis=0) - np.clip(slope, -0.5 * most, 0.5 * most) * x)
