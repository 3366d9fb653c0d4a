"""Checks of given rates: their integrals must be the changes of positions and rates."""

import math

import numpy as np

from ..io.array_types import Array
from .sample_times import elapsed

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

    A linear drift, for example due to a bias of the rates, is no contradiction.

    Parameters
    ----------
    time : ndarray, shape (n,)
        Increasing times (s).
    found : ndarray, shape (3, n, c)
        Positions, rates, and second rates.

    Returns
    -------
    text : str
        Contradiction, or an empty text.
    time_unit : str or None
        Unit of time in which there is no contradiction.
    """
    if len(time) < 2 or not found[1:].any():
        return "", None
    steps = np.diff(elapsed(time))[:, None]
    # The trapezoidal rule with the derivatives at both ends has an error of fifth order.
    ends = steps**2 / 12.0 * np.diff(found[2], axis=0)
    for value, rate, names, correction, most in (
        (found[0], found[1], ("positions", "rates"), ends, _CONTRADICTS),
        (found[1], found[2], ("rates", "second rates"), np.zeros(ends.shape), _CONTRADICTS_RATES),
    ):
        integral = np.cumsum(0.5 * steps * (rate[1:] + rate[:-1]) - correction, axis=0)
        noise = _SURE * (_noise(value) + _noise(rate) * _spread(steps)) + _rms(_remainder(rate, steps))
        bias = _BIAS * _rms(rate) * float(steps.sum())
        text, unit = _difference((value[1:] - value[0], integral), (most, noise, bias), names)
        if text:
            return text, unit
    return "", None


def _remainder(rate: Array, steps: Array) -> Array:
    """Return the error of the trapezoidal rule from the integral with half of the samples."""
    middle, (before, after) = rate[1:-1:2], (steps[0:-1:2], steps[1::2])
    chord = (rate[:-2:2] * after + rate[2::2] * before) / (before + after)
    return np.cumsum(0.5 * (middle - chord) * (before + after), axis=0) / 3.0


def _difference(
    changes: tuple[Array, Array], tolerances: tuple[float, float, float], names: tuple[str, str]
) -> tuple[str, str | None]:
    """Compare changes with integrals; tolerances are a fraction of the changes, noise, and a bias."""
    (change, integral), (share, noise, bias) = changes, tolerances
    size, expected = _rms(change), _rms(integral)
    if max(size, expected) <= noise:
        return "", None
    decades = math.log10(size / expected) if size and expected else 0.0
    nearest = 3 * round(decades / 3)
    if nearest and abs(decades - nearest) < _NEAR_UNIT:
        unit = {-3: "ms", -6: "us"}.get(nearest)
        return f"{names[0]} change by {size / expected:.2g} times the integral of {names[1]}", unit
    off = _rms(_without_drift(change - integral, bias))
    if off > share * size + noise + 1e-9 * float(np.abs(change).max()):
        difference = f"{off / size:.0%} of the changes" if size else "a part"
        return f"the integral of {names[1]} differs from the {names[0]} by {difference}", None
    return "", None


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _noise(values: Array) -> float:
    """Return the noise of samples, whose differences of high order contain little of a motion."""
    if len(values) <= 2 * _ORDER:
        return 0.0
    scatter = np.median(np.abs(np.diff(values, _ORDER, axis=0)), axis=0)
    return _rms(scatter) / (_MEDIAN_OF_NORMAL * math.sqrt(math.comb(2 * _ORDER, _ORDER)))


def _spread(steps: Array) -> float:
    """Return the spread (s) of the integral of noise of standard deviation 1."""
    return float(np.sqrt(np.sum(steps**2)))


def _without_drift(values: Array, most: float) -> Array:
    """Subtract a straight line with a change of at most ``most`` from each column."""
    x = np.linspace(-1.0, 1.0, len(values))[:, None]
    slope = np.sum(x * values, axis=0) / max(float(np.sum(x**2)), 1.0)
    return np.asarray(values - values.mean(axis=0) - np.clip(slope, -0.5 * most, 0.5 * most) * x)
