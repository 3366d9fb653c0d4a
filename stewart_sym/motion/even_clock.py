"""Even clock of sample times that were rounded to decimals."""

import math
from typing import NamedTuple

import numpy as np

from ..io.array_types import Array
from .sample_times import parts

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
