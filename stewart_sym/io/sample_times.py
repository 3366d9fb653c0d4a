"""Sample times, also in seconds since 1970, as text and as differences without rounding errors."""

import math
from typing import NamedTuple

import numpy as np

from .array_types import Array

# A double has 15 to 17 digits. With 16 digits a time of few decimals is printed without further decimals.
_FEWEST, _MOST = 6, 16
# Largest number of decimals of times.
_DECIMALS = 15
# A double next to the nearest double of a decimal number is interpreted as this number only if adjacent
# decimal numbers are at least this many doubles apart.
_FAR_APART = 16.0
# Number of times that are processed together.
_PART = 1 << 10

# Smallest number of rows of an even clock, and the range of its step in units of the rounding of times.
# Smaller steps may be caused by missing rows; for larger steps rounding affects no rate.
_CLOCK_ROWS, _CLOCK_LEAST, _CLOCK_MOST = 20, 2.0, 1e4
# Smallest number of steps of two units, and of one unit, that identifies a clock with a step below two units.
# Largest probability that randomly missing rows are as evenly spaced.
_LONG_STEPS, _UNLIKELY = 3, 1e-6
# Largest deviation of times from the clock in these units, half a unit and jitter below half a unit, and
# largest deviation of the last time.
_OFF_CLOCK, _LAST = 0.75, 0.1
# Range of the deviations for a clock that is rounded without jitter.
_EXACT = 1.1


class Clock(NamedTuple):
    """Even clock of rounded times.

    Attributes
    ----------
    times : ndarray, shape (n,)
        Times from the first time as written (s).
    step : float
        Step of the clock (s).
    rounded : float
        Unit to which the times were rounded (s).
    chance : float
        Probability that a clock of whole units with randomly missing rows has such times; 0 if impossible.
    """

    times: Array
    step: float
    rounded: float
    chance: float = 0.0

    @property
    def sure(self) -> bool:
        """True if the times alone identify the clock."""
        return self.chance < _UNLIKELY


def even_clock(times: Array) -> Clock | None:
    """Find the even clock whose times (s), shape (n,), were rounded to decimals.

    Rows may be missing: the differences are whole numbers of steps. Returns None for evenly spaced times, and
    for times without an even clock.
    """
    per_second = parts(times)
    if per_second is None or len(times) < _CLOCK_ROWS:
        return None
    count = np.rint(times * per_second)
    count -= count[0]
    gaps = np.diff(count)
    usual = np.quantile(gaps, 0.5, method="lower")
    # Steps of one and two units result from a clock with a step between them, or from a clock of one unit
    # with missing rows.
    short = gaps.min() == 1.0 and usual <= _CLOCK_LEAST
    if not short and (not np.any(gaps % gaps.min()) or not _CLOCK_LEAST <= usual <= _CLOCK_MOST):
        return None
    # A step is rounded up or down.
    step = gaps[gaps <= _CLOCK_LEAST if short else np.abs(gaps - usual) <= 1.0].mean()
    steps = (
        np.ones(len(gaps)) if short and gaps.max() <= _CLOCK_LEAST else np.maximum(np.rint(gaps / step), 1.0)
    )
    ticks = np.concatenate([[0.0], np.cumsum(steps)])
    since = ticks - ticks.mean()
    step = float(since @ (count - count.mean()) / (since @ since))
    off = count - step * ticks
    if np.ptp(off) > (_EXACT if short else 2.0 * _OFF_CLOCK):
        return None
    chance = _chance(gaps[steps == 1.0]) if short else 0.0
    if chance is None:
        return None
    if abs(off[-1]) < _LAST:
        step = float(count[-1] / ticks[-1])
    return Clock(times[0] + step * ticks / per_second, step / per_second, 1.0 / per_second, chance)


def _chance(gaps: Array) -> float | None:
    """Compute the probability that steps of one and two units, (n,), are by chance as even as a clock.

    About n orders of the same number of long steps are as even. None means too few steps of either kind.
    """
    count, long = len(gaps), int(np.count_nonzero(gaps > 1.0))
    if not _LONG_STEPS <= long <= count - _LONG_STEPS:
        return None
    orders = math.lgamma(count + 1) - math.lgamma(long + 1) - math.lgamma(count - long + 1)
    return math.exp(min(0.0, math.log(count) - orders))


def elapsed(times: Array) -> Array:
    """Return the times since the first time (s), shape (n,), without rounding errors, for differentiation.

    A double resolves seconds since 1970 to 2.4e-7 s, which is a considerable fraction of a step of a
    millisecond. If all times are the nearest doubles of numbers with a few decimals, they are interpreted as
    these numbers.
    """
    return apart(times, times[:1], parts(times))


def apart(later: Array, earlier: Array, per_second: float | None) -> Array:
    """Return differences of times (s) that are whole numbers of parts of a second, or plain differences for
    None.
    """
    if per_second is None:
        return np.asarray(later - earlier)
    return np.asarray((np.rint(later * per_second) - np.rint(earlier * per_second)) / per_second)


def lost(times: Array) -> float:
    """Return the possible rounding error of the times (s), shape (n,): 0 if ``elapsed`` recovers the
    times.
    """
    return _resolution(times) if parts(times) is None else 0.0


def parts(times: Array) -> float | None:
    """Return the smallest power of ten for which all times, shape (n,), are whole parts of a second, or
    None.
    """
    resolution = _resolution(times)
    starts = range(0, len(times), _PART)
    for decimals in range(_DECIMALS + 1):
        per_second = 10.0**decimals
        if 2.0 * resolution * per_second > 1.0:
            break
        # The sum of a start time and a step may be a double adjacent to the nearest one.
        beside = _FAR_APART * resolution * per_second < 1.0
        if all(_whole_numbers(times[i : i + _PART + 1], per_second, beside) for i in starts):
            return per_second
    return None


def _resolution(times: Array) -> float:
    """Return the resolution of the double of the largest time (s)."""
    return float(np.spacing(max(times.max(initial=0.0), -times.min(initial=0.0))))


def _whole_numbers(times: Array, per_second: float, beside: bool) -> bool:
    """Return True if times are different whole parts of a second; ``beside`` permits adjacent doubles."""
    count = np.rint(times * per_second)
    off = np.abs(count / per_second - times)
    return bool((off <= beside * np.spacing(np.abs(times))).all() and (np.diff(count) > 0.0).all())


def least_step(times: Array) -> float:
    """Return the shortest nonzero step of times (s), shape (n,); 0 for a single time."""
    steps = np.diff(times)
    return float(steps[steps > 0.0].min(initial=np.inf)) if np.any(steps > 0.0) else 0.0


def time_text(time: float, step: float = 0.0) -> str:
    """Format a time (s) with full seconds and the decimals of ``step`` (s), or with all decimals for step
    0.
    """
    digits = _MOST
    if step > 0.0 and time != 0.0:
        digits = math.floor(math.log10(abs(time))) - math.floor(math.log10(min(step, 1.0))) + 1
    return f"{time:.{min(max(digits, _FEWEST), _MOST)}g}"
