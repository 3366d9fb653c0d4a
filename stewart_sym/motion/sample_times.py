"""Sample times, also in seconds since 1970, as text and as differences without rounding errors."""

import math

import numpy as np

from ..io.array_types import Array

# A double has 15 to 17 digits. With 16 digits a time of few decimals is printed without further decimals.
_FEWEST, _MOST = 6, 16
# Largest number of decimals of times.
_DECIMALS = 15


def elapsed(times: Array) -> Array:
    """Return the times since the first time (s), shape (n,), without rounding errors, for differentiation.

    A double resolves seconds since 1970 to 2.4e-7 s, which is a considerable fraction of a step of a
    millisecond. Differences that are decimal numbers to this resolution are rounded to them.
    """
    since = np.asarray(times - times[:1])
    resolution = float(np.spacing(np.abs(times).max(initial=0.0)))
    rounded = np.round(since, min(math.floor(-math.log10(4.0 * resolution)), _DECIMALS))
    exact = bool((np.abs(rounded - since) <= resolution).all() and (np.diff(rounded) > 0.0).all())
    return rounded if exact else since


def least_step(times: Array) -> float:
    """Return the shortest nonzero step of times (s), shape (n,); 0 for a single time."""
    steps = np.diff(times)
    return float(steps[steps > 0.0].min(initial=np.inf)) if np.any(steps > 0.0) else 0.0


def time_text(time: float, step: float = 0.0) -> str:
    """Format a time (s) with full seconds and the decimals of ``step`` (s), or all decimals for step 0."""
    digits = _MOST
    if step > 0.0 and time != 0.0:
        digits = math.floor(math.log10(abs(time))) - math.floor(math.log10(min(step, 1.0))) + 1
    return f"{time:.{min(max(digits, _FEWEST), _MOST)}g}"
