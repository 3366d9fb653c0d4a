"""Sample times, also in seconds since 1970, as text and as differences without rounding errors."""

import math

import numpy as np

from ..io.array_types import Array

# A double has 15 to 17 digits. With 16 digits a time of few decimals is printed without further decimals.
_FEWEST, _MOST = 6, 16
# Largest number of decimals of times.
_DECIMALS = 15
# A double next to the nearest double of a decimal number is interpreted as this number only if adjacent
# decimal numbers are at least this many doubles apart.
_FAR_APART = 16.0
# Number of times that are examined first.
_FIRST = 1 << 10


def elapsed(times: Array) -> Array:
    """Return the times since the first time (s), shape (n,), without rounding errors, for differentiation.

    A double resolves seconds since 1970 to 2.4e-7 s, which is a considerable fraction of a step of a
    millisecond. If all times are the nearest doubles of numbers with a few decimals, they are interpreted as
    these numbers.
    """
    resolution = float(np.spacing(np.abs(times).max(initial=0.0)))
    for decimals in range(_DECIMALS + 1):
        per_second = 10.0**decimals
        if 2.0 * resolution * per_second > 1.0:
            break
        # The sum of a start time and a step may be a double adjacent to the nearest one.
        adjacent = _FAR_APART * resolution * per_second < 1.0
        # Most numbers of decimals are excluded by the first times.
        if all(_whole_numbers(some, per_second, adjacent) for some in (times[:_FIRST], times)):
            count = np.rint(times * per_second)
            return np.asarray((count - count[:1]) / per_second)
    return np.asarray(times - times[:1])


def _whole_numbers(times: Array, per_second: float, adjacent: bool) -> bool:
    """Return True if times are different whole parts of a second; ``adjacent`` permits adjacent doubles."""
    count = np.rint(times * per_second)
    off = np.abs(count / per_second - times)
    return bool((off <= adjacent * np.spacing(np.abs(times))).all() and (np.diff(count) > 0.0).all())


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
