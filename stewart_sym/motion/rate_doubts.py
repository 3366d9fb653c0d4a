"""Whether rates are those of the numbers beside them, compared over stretches in which these change."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..io.array_types import Array
from ..io.instants import elapsed
from .rotation import angle_rates, distance_from_lock, rotation_about_axes

# Rates are of another motion if what they say is off by this share of the changes: more than a filter's lag.
_OFF = 0.3
# They lag if it is off by this share and by so many deviations of noise, and a delay leaves less than half.
_LAG, _BEYOND, _LEFT = 0.03, 10.0, 0.5
# So they are where noise is less than a share of the changes, a factor differs from 1 by a second, and of it
# is left less than half: lag leaves much more.
_QUIET, _FACTOR, _ALL_BUT = 0.1, 0.08, 0.5
# What is off is explained if it is so many deviations of noise or more.
_SEEN = 2.0
# Rates of angles are an angular velocity where this leaves less than a share of what is off.
_EXPLAINED = 0.25
# From so near to angles that are not unique their rates are not compared with an angular velocity.
_LOCK = 0.05
# Changes are compared from so many deviations of noise on, that of the rates' sums weighted by a share, and
# from a share of the largest change of their kind on.
_CLEAR, _OF_RATES, _LEAST = 8.0, 0.3, 1e-3
# Changes over a stretch are this share of those over all, but for what moves on and on.
_SHARE = 0.7
_FEWEST, _MOST, _FASTEST = 8, 1 << 13, 1 << 11
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
    rates leaves as it is. off: their difference; left: that from ratio times what the rates say. late: delay
    of the rates, s, that explains off best; after: what it leaves. size: of the changes. noise: of these, by
    that of the column and that of its rates.
    """

    ratio: float
    slope: float
    off: float
    left: float
    late: float
    after: float
    size: float
    noise: float


def rate_doubt(
    time: Array, values: Array, rates: Array, names: Sequence[str], rate_names: Sequence[str], kind: int = 6
) -> str | None:
    """Which columns, (n, c), do not change as their rates say, in words; None: all do.

    kind: how many columns side by side have one unit. Columns that rest, or whose changes noise hides, are
    not compared.
    """
    if len(time) < _FEWEST:
        return None
    time = elapsed(time)
    found = [_compared(time, column, rate) for column, rate in zip(values.T, rates.T, strict=True)]
    least = [_LEAST * max(each.size for each in found[i - i % kind :][:kind]) for i in range(len(found))]
    seen = [i for i, each in enumerate(found) if each.size > max(least[i], _CLEAR * each.noise)]
    bad = [i for i in seen if _of_another(found[i]) or _scaled(found[i])]
    if not bad:
        return _lag({i: found[i] for i in seen if _late(found[i])}, names, rate_names)
    if len(bad) == len(found) == kind:
        changed, said = (f"{each[0]} to {each[-1]}" for each in (names, rate_names))
    else:
        changed, said = (", ".join(each[i] for i in bad) for each in (names, rate_names))
    ratios = [found[i].ratio for i in bad]
    alike = max(abs(ratio - ratios[0]) for ratio in ratios) < _SAME * abs(ratios[0])
    if not alike or any(found[i].left > _OFF * found[i].size for i in bad):
        return f"{changed} do not change as {said} say"
    hint = next((text for factor, text in _FACTORS.items() if abs(ratios[0] / factor - 1.0) < _SAME), "")
    return f"{changed} change by {ratios[0]:.2g} times what {said} say{hint and f': {hint}?'}"


def _of_another(column: _Column) -> bool:
    """Whether rates are those of another motion."""
    return column.off > _OFF * column.size and abs(column.slope - 1.0) > _OFF


def _late(column: _Column) -> bool:
    """Whether a delay of the rates explains most of what is off."""
    least = max(_LAG * column.size, _BEYOND * column.noise)
    return least < column.off < column.size and column.after < _LEFT * column.off


def _lag(late: dict[int, _Column], names: Sequence[str], rate_names: Sequence[str]) -> str | None:
    """Which columns' rates are late, in words; None of none."""
    if not late:
        return None
    columns, rates = (", ".join(each[i] for i in late) for each in (names, rate_names))
    share = 100 * max(each.off / each.size for each in late.values())
    delay = 1e3 * float(np.median([each.late for each in late.values()]))
    when = f"{abs(delay):.2g} ms {'late' if delay > 0.0 else 'early'}"
    return f"{rates} say up to {share:.2g} % other changes than those of {columns}: are they {when}?"


def angular_velocity_doubt(time: Array, theta: Array, rates: Array, order: str) -> str | None:
    """Whether what are said to be rates of angles, (n, 3), are an angular velocity instead, in words.

    theta: rad, unwrapped, turns multiplied in ``order``. Turns about one axis have both alike.
    """
    # Of a long log those rows tell enough in which it turns fastest.
    fastest = int(np.argmax(np.einsum("ij,ij->i", rates, rates)))
    start = min(max(fastest - _FASTEST // 2, 0), max(len(time) - _FASTEST, 0))
    time, theta, rates = (each[start : start + _FASTEST] for each in (time, theta, rates))
    if len(time) < _FEWEST or not rates.any() or distance_from_lock(theta, order).min() < _LOCK:
        return None
    time = elapsed(time)
    found, noise = _left(time, theta, rates)
    if found <= _SEEN * noise:
        return None
    in_platform = (rotation_about_axes(theta, order) @ rates[..., None])[..., 0]
    for omega, frame in ((rates, "base"), (in_platform, "platform")):
        said, _ = angle_rates(theta, omega, np.zeros_like(omega), order)
        if _left(time, theta, said)[0] < _EXPLAINED * found:
            return (
                f"theta_x to theta_z change as if theta_dot_* were an angular velocity, {frame} frame: "
                "expected the rates of the angles"
            )
    return None


def _left(time: Array, theta: Array, rates: Array) -> tuple[float, float]:
    """By how much three angles' changes differ from what rates say, and noise in it: root sums of squares."""
    found = [_compared(time, *columns) for columns in zip(theta.T, rates.T, strict=True)]
    return math.hypot(*(each.off for each in found)), math.hypot(*(each.noise for each in found))


def _scaled(column: _Column) -> bool:
    """Whether changes are what rates say but for a factor."""
    factor = abs(column.ratio - 1.0)
    quiet = column.noise < _QUIET * column.size
    return quiet and factor > _FACTOR and column.left < _ALL_BUT * factor * column.size


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
        change, by_rate, of_rate = ((each[stretch:] - each[:-stretch])[kept] for each in (x, said, rate[at]))
        if max(_rms(change), _rms(by_rate)) >= _SHARE * spread or 4 * stretch >= len(time):
            break
        stretch *= 2
    both, squares, own = (float(x @ y) for x, y in ((change, by_rate), (by_rate, by_rate), (change, change)))
    ratio, slope = both / squares if squares else 0.0, both / own if own else 1.0
    off, left = _rms(change - by_rate), _rms(change - ratio * by_rate)
    gone = change - by_rate
    faster = float(of_rate @ of_rate)
    late = float(gone @ of_rate) / faster if faster else 0.0
    after = _rms(gone - late * of_rate)
    noise = math.hypot(scatter, _OF_RATES * of_rates * step * math.sqrt(every * stretch))
    return _Column(ratio, slope, off, left, late, after, _rms(change), noise)


def _rms(values: Array) -> float:
    return math.sqrt(float(np.mean(values**2)))
