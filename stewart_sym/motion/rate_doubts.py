"""Whether rates are those of the numbers beside them, compared over stretches in which these change."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..io.array_types import Array
from ..io.instants import elapsed

# Rates are doubted if what they say is off by this share of the changes.
_OFF = 0.3
# Changes are compared from so many deviations of noise on, that of the rates' sums weighted by a share, and
# from a share of the largest change of their kind on.
_CLEAR, _OF_RATES, _LEAST = 8.0, 0.3, 1e-3
# Changes over a stretch are this share of those over all, but for what moves on and on.
_SHARE = 0.7
_FEWEST, _MOST = 8, 1 << 13
# Ratios within this share are one.
_SAME = 0.1
_FACTORS = {
    -1.0: "are signs opposite",
    math.pi / 180.0: "are the latter in degrees",
    180.0 / math.pi: "are the former in degrees",
}


class _Column(NamedTuple):
    """Root mean squares of one column's changes over stretches.

    ratio: of the changes by those that the rates say; slope: of the latter by the former, which noise of the
    rates leaves as it is. off: their difference; left: that from ratio times what the rates say. size: of the
    changes. noise: of these, by that of the column and that of its rates.
    """

    ratio: float
    slope: float
    off: float
    left: float
    size: float
    noise: float


def rate_doubt(
    time: Array, values: Array, rates: Array, names: Sequence[str], rate_names: Sequence[str], kind: int = 6
) -> str | None:
    """Which columns, (n, c), do not change as their rates say, in words; None: all do.

    kind: how many columns side by side have one unit. Columns that rest, or whose changes noise hides, are
    not compared, and nothing is where all rates are 0: poses at rest.
    """
    if len(time) < _FEWEST or not rates.any():
        return None
    time = elapsed(time)
    found = [_compared(time, column, rate) for column, rate in zip(values.T, rates.T, strict=True)]
    bad = []
    for i, each in enumerate(found):
        first = i - i % kind
        least = _LEAST * max(other.size for other in found[first : first + kind])
        seen = each.size > max(least, _CLEAR * each.noise)
        if seen and each.off > _OFF * each.size and abs(each.slope - 1.0) > _OFF:
            bad.append(i)
    if not bad:
        return None
    if len(bad) == len(found) == kind:
        changed, said = (f"{each[0]} to {each[-1]}" for each in (names, rate_names))
    else:
        changed, said = (", ".join(each[i] for i in bad) for each in (names, rate_names))
    ratios = [found[i].ratio for i in bad]
    alike = max(abs(ratio - ratios[0]) for ratio in ratios) < _SAME * abs(ratios[0])
    if not alike or any(found[i].left > _OFF * found[i].size for i in bad):
        return f"{changed} do not change as {said} say"
    hint = next((text for factor, text in _FACTORS.items() if abs(ratios[0] / factor - 1.0) < _SAME), "")
    return f"{changed} change by {ratios[0]:.2g} of what {said} say{hint and f': {hint}?'}"


def _compared(time: Array, x: Array, rate: Array) -> _Column:
    scatter, of_rates = (math.sqrt(float(np.mean(np.diff(each, n=2) ** 2)) / 6.0) for each in (x, rate))
    step = float(time[-1] - time[0]) / (len(time) - 1)
    summed = rate[1:] + rate[:-1]
    summed *= np.diff(time)
    np.cumsum(summed, out=summed)
    # Of a long log some instants are compared: the sums between them are of all.
    every = max(1, len(x) // _MOST)
    at = np.arange(0, len(x), every)
    x, time, said = x[at], time[at], 0.5 * np.where(at > 0, summed[at - 1], 0.0)
    spread = max(float(np.std(x)), float(np.std(said)))
    stretch = 1
    while True:
        # Across a gap of the log no rates are known.
        apart = time[stretch:] - time[:-stretch]
        kept = apart <= 2.0 * np.median(apart)
        change, by_rate = ((each[stretch:] - each[:-stretch])[kept] for each in (x, said))
        if max(_rms(change), _rms(by_rate)) >= _SHARE * spread or 4 * stretch >= len(time):
            break
        stretch *= 2
    both, squares, own = (float(x @ y) for x, y in ((change, by_rate), (by_rate, by_rate), (change, change)))
    ratio, slope = both / squares if squares else 0.0, both / own if own else 1.0
    off, left = _rms(change - by_rate), _rms(change - ratio * by_rate)
    noise = math.hypot(scatter, _OF_RATES * of_rates * step * math.sqrt(every * stretch))
    return _Column(ratio, slope, off, left, _rms(change), noise)


def _rms(values: Array) -> float:
    return math.sqrt(float(np.mean(values**2)))
