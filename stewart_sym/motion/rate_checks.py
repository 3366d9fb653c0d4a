"""Checks of given rates: their integrals must be the changes of positions and rates."""

import math

import numpy as np
from scipy.interpolate import make_interp_spline

from ..io.array_types import Array
from .sample_times import elapsed

_FEWEST = 4
# Distance (decades) from a power of 1000 of the ratio of changes to integrals if a unit is wrong.
_NEAR_UNIT = 0.2
# Largest differences of changes and integrals, relative to the changes, in addition to noise: of positions
# and of rates, whose derivatives may have peaks between the samples.
_CONTRADICTS, _CONTRADICTS_RATES = 0.05, 1.1
# Number of standard deviations of noise that are no contradiction.
_SURE = 5.0
# Order of the differences that contain noise, and median of the magnitude of a standard normal distribution.
_ORDER, _MEDIAN_OF_NORMAL = 6, 0.6745
# Largest bias of rates, relative to their root mean square, that is no contradiction.
_BIAS = 0.05


def rate_error(time: Array, found: Array) -> tuple[str, str | None]:
    """Compare the integrals of rates with changes of positions, and of second rates with changes of rates.

    ``found``, (3, n, c), are positions, rates, and second rates at increasing times (s). Returns the
    contradiction or an empty text, and the unit of time in which there is none, or None. A linear drift,
    for example due to a bias of the rates, is no contradiction. The tolerance includes the difference of
    two rules of integration, which is large for coarse samples.
    """
    if len(time) < _FEWEST or not found[1:].any():
        return "", None
    since = elapsed(time)
    span, spread = float(since[-1]), float(np.sqrt(np.sum(np.diff(since) ** 2)))
    for value, rate, names, most in (
        (found[0], found[1], ("positions", "rates"), _CONTRADICTS),
        (found[1], found[2], ("rates", "second rates"), _CONTRADICTS_RATES),
    ):
        change, integral = value - value[0], make_interp_spline(since, rate).antiderivative()(since)
        trapezoids = 0.5 * np.diff(since)[:, None] * (rate[1:] + rate[:-1])
        coarse = _rms(integral - np.cumsum(np.vstack([np.zeros_like(rate[:1]), trapezoids]), axis=0))
        noise = _SURE * (_rms(noise_of(value)) + _rms(noise_of(rate)) * spread) + coarse
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


def noise_of(values: Array) -> Array:
    """Return the noise of each column of samples; differences of high order contain little of a motion."""
    if len(values) <= 2 * _ORDER:
        return np.zeros(values.shape[1:])
    scatter = np.median(np.abs(np.diff(values, _ORDER, axis=0)), axis=0)
    return np.asarray(scatter / (_MEDIAN_OF_NORMAL * math.sqrt(math.comb(2 * _ORDER, _ORDER))))


def _without_drift(values: Array, most: float) -> Array:
    """Subtract a straight line with a change of at most ``most`` from each column."""
    x = np.linspace(-1.0, 1.0, len(values))[:, None]
    slope = np.sum(x * values, axis=0) / max(float(np.sum(x**2)), 1.0)
    return np.asarray(values - values.mean(axis=0) - np.clip(slope, -0.5 * most, 0.5 * most) * x)
