"""Times, also in seconds since 1970, as text and as differences, without what is rounded off."""

import math
from typing import NamedTuple

import numpy as np

from .array_types import Array

# A double has 15 to 17 digits; with 16 a time of few decimals is printed with these alone.
_FEWEST, _MOST = 6, 16
# Most decimals of times that are looked for.
_DECIMALS = 15
# A double next to that of such a number is taken for it only where the numbers are so many doubles apart.
_FAR_APART = 16.0
# Times that are looked at together.
_PART = 1 << 10

# Rows that show an even clock; its step in units of what times are rounded to: the least, below which rows
# may be missing instead, and the most, beyond which rounding tells in no rate.
_CLOCK_ROWS, _CLOCK_LEAST, _CLOCK_MOST = 20, 2.0, 1e4
# Steps of two units among those of one that show a clock of less than two, and how unlikely it must be that
# rows missing at random lie as evenly.
_LONG_STEPS, _UNLIKELY = 3, 1e-6
# How far times are off it, in these units: half of one and jitter below that; how near to it the last is it.
_OFF_CLOCK, _LAST = 0.75, 0.1
# How far apart these are of a clock that is rounded without jitter.
_EXACT = 1.1


class Clock(NamedTuple):
    """An even clock: times, s, (n,), from the first as written, its step and what they were rounded to, s.

    chance: of rows of a clock of whole units that are missing at random to have such times; 0: of none.
    """

    times: Array
    step: float
    rounded: float
    chance: float = 0.0

    @property
    def sure(self) -> bool:
        """Whether the times alone leave no doubt of it."""
        return self.chance < _UNLIKELY


def even_clock(times: Array) -> Clock | None:
    """The even clock whose times, s, (n,), are rounded to decimals; None for even times and without any.

    Rows may be missing: whole numbers of steps lie between those that are there.
    """
    per_second = parts(times)
    if per_second is None or len(times) < _CLOCK_ROWS:
        return None
    count = np.rint(times * per_second)
    count -= count[0]
    gaps = np.diff(count)
    usual = np.quantile(gaps, 0.5, method="lower")
    # Steps of one and of two units are those of a clock between, or of one of one unit with rows missing.
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
    """Chance that steps of one and of two units, (n,), in any order are as even as those of a clock.

    Of the orders of so many long ones about n are. None: too few of either.
    """
    count, long = len(gaps), int(np.count_nonzero(gaps > 1.0))
    if not _LONG_STEPS <= long <= count - _LONG_STEPS:
        return None
    orders = math.lgamma(count + 1) - math.lgamma(long + 1) - math.lgamma(count - long + 1)
    return math.exp(min(0.0, math.log(count) - orders))


def elapsed(times: Array) -> Array:
    """Times since the first, s, (n,), without what doubles round off: for all that is differentiated.

    A double keeps seconds since 1970 to 2.4e-7 s, which is much of a millisecond's step. Times that all are
    the nearest doubles of numbers with a few decimals are taken for these numbers.
    """
    return apart(times, times[:1], parts(times))


def apart(later: Array, earlier: Array, per_second: float | None) -> Array:
    """Differences of times, s, that are whole numbers of parts of a second; None: of times as they are."""
    if per_second is None:
        return np.asarray(later - earlier)
    return np.asarray((np.rint(later * per_second) - np.rint(earlier * per_second)) / per_second)


def lost(times: Array) -> float:
    """What doubles may have rounded off the times, s, (n,): 0 where ``elapsed`` restores it."""
    return _resolution(times) if parts(times) is None else 0.0


def parts(times: Array) -> float | None:
    """The fewest parts of a second, a power of ten, that times, (n,), are whole numbers of; None for none."""
    resolution = _resolution(times)
    starts = range(0, len(times), _PART)
    for decimals in range(_DECIMALS + 1):
        per_second = 10.0**decimals
        if 2.0 * resolution * per_second > 1.0:
            break
        # A sum of a start and a step may be the double beside the nearest one.
        beside = _FAR_APART * resolution * per_second < 1.0
        if all(_whole_numbers(times[i : i + _PART + 1], per_second, beside) for i in starts):
            return per_second
    return None


def _resolution(times: Array) -> float:
    """What the double of the largest time resolves, s."""
    return float(np.spacing(max(times.max(initial=0.0), -times.min(initial=0.0))))


def _whole_numbers(times: Array, per_second: float, beside: bool) -> bool:
    """Whether times are different whole numbers of parts of a second, ``beside``: or next to such."""
    count = np.rint(times * per_second)
    off = np.abs(count / per_second - times)
    return bool((off <= beside * np.spacing(np.abs(times))).all() and (np.diff(count) > 0.0).all())


def least_step(times: Array) -> float:
    """The shortest step of times, s, (n,), that has a duration; 0 of a single one."""
    steps = np.diff(times)
    return float(steps[steps > 0.0].min(initial=np.inf)) if np.any(steps > 0.0) else 0.0


def time_text(time: float, step: float = 0.0) -> str:
    """A time, s, with full seconds and the decimals of a step, s; with all that it has without a step."""
    digits = _MOST
    if step > 0.0 and time != 0.0:
        digits = math.floor(math.log10(abs(time))) - math.floor(math.log10(min(step, 1.0))) + 1
    return f"{time:.{min(max(digits, _FEWEST), _MOST)}g}"
