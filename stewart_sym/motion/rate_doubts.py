"""Whether rates are those of the numbers beside them, compared over stretches in which these change."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ..io.array_types import Array, Flags
from .noise_level import rounding_step
from .rotation import angle_rates, distance_from_lock, rotation_about_axes
from .sample_times import elapsed

# Rates are of another motion if what they say over some stretch is off by this share of the changes, which is
# more than a filter's lag, by a share of the largest of their kind or, where all rest, by this much in units
# of SI; and by so many deviations of what noise makes of it.
_OFF, _SMALL, _REST, _SURE = 0.3, 0.03, 1e-6, 4.0
# A number that stays tells nothing of rounding, nor do so many limits of which rates of a profile are made.
_LIMITS = 8
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
# Second differences over first ones of a motion of nine rows a period.
_FOLLOWED = 0.7
# Steps of so many times the usual one are gaps.
_GAP = 2.5
# Steps of an even clock differ by less than this share.
_EVEN = 0.1
_FEWEST, _MOST, _FASTEST = 8, 1 << 13, 1 << 11
# Ratios within this share are one.
_SAME = 0.1
_FACTORS = {
    -1.0: "are signs opposite",
    math.pi / 180.0: "are the latter in degrees",
    180.0 / math.pi: "are the former in degrees",
}


class _Changes(NamedTuple):
    """Root mean squares of one column's changes over stretches of one length.

    ratio: of the changes by those that the rates say; slope: of the latter by the former, which noise of the
    rates leaves as it is. off: their difference; left: that from ratio times what the rates say. late: delay
    of the rates, s, that explains off best; after: what it leaves. size: of the changes. noise: of these, by
    that of the column and that of its rates. chance: deviation of off by white noise and rounding of both.
    """

    ratio: float
    slope: float
    off: float
    left: float
    late: float
    after: float
    size: float
    noise: float
    chance: float


class _Column(NamedTuple):
    """Changes of one column over stretches of 1, 2, 4, ... rows.

    most: over which of these it changes about as much as over all. moves: more than its noise.
    """

    over: list[_Changes]
    most: int
    moves: bool


def rate_doubts(
    time: Array, columns: Sequence[Array], names: Sequence[Sequence[str]], kind: int = 6
) -> Iterator[tuple[int, str]]:
    """Which columns do not change as those after them say, which are their rates: their index, and words.

    columns: of coordinates, rates and accelerations, (n, c) each, without or with the last. kind: how many
    columns side by side have one unit.
    """
    often = np.ones(columns[0].shape[1], bool)
    if len(columns) > 2 and len(time) > 1:
        # Fewer than six rows a period show another motion than that which the rates are of.
        step = float(np.median(np.diff(time)))
        v, a = (np.linalg.norm(each.reshape(len(time), -1, kind), axis=(0, 2)) for each in columns[1:])
        often = np.repeat((step * a <= v) | (v == 0.0), kind)
    for i, ((values, rates), said) in enumerate(zip(pairwise(columns), pairwise(names), strict=True)):
        doubt = rate_doubt(time, values, rates, *said, kind, often)
        if doubt:
            yield i, doubt


def rate_doubt(
    time: Array,
    values: Array,
    rates: Array,
    names: Sequence[str],
    rate_names: Sequence[str],
    kind: int = 6,
    often: Flags | None = None,
) -> str | None:
    """Which columns, (n, c), do not change as their rates say, in words; None: all do.

    often: which columns have rows often enough to follow their motion; None: all.
    """
    if len(time) < _FEWEST:
        return None
    time, clock = elapsed(time), _clock_noise(time)
    steps, rate_steps = _rounding(values, kind, 1), _rounding(rates, kind, _LIMITS)
    columns = zip(values.T, rates.T, steps, rate_steps, strict=True)
    found = [_compared(time, x, rate, by, rate_by, clock) for x, rate, by, rate_by in columns]
    own = [each.over[each.most] for each in found]
    least = [_LEAST * max(each.size for each in own[i - i % kind :][:kind]) for i in range(len(found))]
    seen = [i for i, each in enumerate(own) if each.size > max(least[i], _CLEAR * each.noise)]
    followed = np.ones(len(found), bool) if often is None else often
    beyond = {i: _contradicting(found, i, kind) if followed[i] else [] for i in range(len(found))}
    bad = [i for i in beyond if beyond[i] or (i in seen and _wrong(own[i]))]
    if not bad:
        return _lag({i: own[i] for i in seen if _late(own[i])}, names, rate_names)
    if len(bad) == len(found) == kind:
        changed, said = (f"{each[0]} to {each[-1]}" for each in (names, rate_names))
    else:
        changed, said = (", ".join(each[i] for i in bad) for each in (names, rate_names))
    ratios = [own[i].ratio for i in bad]
    alike = max(abs(ratio - ratios[0]) for ratio in ratios) < _SAME * abs(ratios[0])
    # The longest stretch tells best whether a factor explains what is off.
    longest = [each[-1] for each in beyond.values() if each]
    unlike = [each for each in longest if each.left > _ALL_BUT * each.off]
    if not alike or unlike or any(own[i].left > _OFF * own[i].size for i in bad):
        return f"{changed} do not change as {said} say"
    hint = next((text for factor, text in _FACTORS.items() if abs(ratios[0] / factor - 1.0) < _SAME), "")
    return f"{changed} change by {ratios[0]:.2g} times what {said} say{hint and f': {hint}?'}"


def _rounding(values: Array, kind: int, fewest: int) -> list[float]:
    """Step to which each column is rounded; of no more than the fewest values, the finest of its kind."""
    some = values[:: max(1, len(values) // _MOST)].T
    known = [rounding_step(each) if len(np.unique(each)) > fewest else math.inf for each in some]
    finest = [min(known[i - i % kind :][:kind]) for i in range(len(known))]
    least = [step if step < math.inf else 0.0 for step in finest]
    return [step if step < math.inf else other for step, other in zip(known, least, strict=True)]


def _clock_noise(time: Array) -> float:
    """Deviation, s, of times that are rounded; an even clock's are not."""
    duration = np.diff(time)
    even = float(np.ptp(duration)) < _EVEN * float(np.median(duration))
    return 0.0 if even else rounding_step(time[:: max(1, len(time) // _MOST)]) / math.sqrt(12.0)


def _contradicting(found: Sequence[_Column], i: int, kind: int) -> list[_Changes]:
    """The changes of a column that are off by more than noise and a delay of its rates explain."""
    alike = found[i - i % kind :][:kind]
    # Over how long a column that rests should have moved, those tell that do: bias of rates adds up.
    moving = next((some for some in ([found[i]], alike, found) if any(each.moves for each in some)), alike)
    most = max((each.most for each in moving if each.moves), default=len(found[i].over) - 1)
    small = [max(each.over[j].size for each in alike) for j in range(most + 1)]
    return [
        each
        for each, size in zip(found[i].over[: most + 1], small, strict=True)
        if each.off > max(_OFF * each.size, _SMALL * size, _REST * (size == 0.0), _SURE * each.chance)
        and not (each.off < each.size and each.after < _LEFT * each.off)
    ]


def _wrong(column: _Changes) -> bool:
    """Whether rates are those of another motion, or changes are what they say but for a factor."""
    if column.off > _OFF * column.size and abs(column.slope - 1.0) > _OFF:
        return True
    factor = abs(column.ratio - 1.0)
    quiet = column.noise < _QUIET * column.size
    return quiet and factor > _FACTOR and column.left < _ALL_BUT * factor * column.size


def _late(column: _Changes) -> bool:
    """Whether a delay of the rates explains most of what is off."""
    least = max(_LAG * column.size, _BEYOND * column.noise)
    return least < column.off < column.size and column.after < _LEFT * column.off


def _lag(late: dict[int, _Changes], names: Sequence[str], rate_names: Sequence[str]) -> str | None:
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
    compared = (_compared(time, *columns) for columns in zip(theta.T, rates.T, strict=True))
    found = [each.over[each.most] for each in compared]
    return math.hypot(*(each.off for each in found)), math.hypot(*(each.noise for each in found))


def _compared(
    time: Array, x: Array, rate: Array, step: float = 0.0, rate_step: float = 0.0, clock: float = 0.0
) -> _Column:
    """One column and its rates, rounded to steps, at times with some noise."""
    duration = np.diff(time)
    # Across a gap of the log no rates are known.
    gaps = np.flatnonzero(duration > _GAP * np.median(duration))
    if gaps.size:
        duration[gaps], jumps = 0.0, np.zeros(len(x))
        jumps[gaps + 1] = x[gaps + 1] - x[gaps]
        x = x - np.cumsum(jumps)
    scatter, of_rates = _scatter(x), _scatter(rate)
    of_each = math.hypot(max(scatter, step / math.sqrt(12.0)), clock * _rms(rate))
    # Numbers that stay the same over several rows count once.
    runs = 1 + np.count_nonzero(np.diff(rate))
    rounding = max(of_rates, rate_step * math.sqrt(len(rate) / (12.0 * runs)))
    summed = 0.5 * (rate[1:] + rate[:-1]) * duration
    said = np.concatenate([[0.0], np.cumsum(summed, out=summed)])
    moves = float(np.std(x)) > _CLEAR * scatter
    spread, most = _SHARE * float(np.std(x if moves else said)), None
    over: list[_Changes] = []
    # Of a long log some stretches are compared: the sums over them are of all.
    h, every, rows = _rms(duration), max(1, len(x) // _MOST), 1
    while not over or 4 * rows <= len(x):
        noise = math.hypot(scatter, _OF_RATES * of_rates * h * math.sqrt(rows))
        of_x = of_each * math.sqrt(2.0 + 2.0 * rows * len(gaps) / len(duration))
        chance = math.hypot(of_x, rounding * h * math.sqrt(rows))
        change, by_rate, of_rate = (each[rows::every] - each[:-rows:every] for each in (x, said, rate))
        over.append(_changes(change, by_rate, of_rate, noise, chance))
        if most is None and _rms(change if moves else by_rate) >= spread:
            most = len(over) - 1
        rows *= 2
    return _Column(over, len(over) - 1 if most is None else most, moves)


def _scatter(x: Array) -> float:
    """Deviation of white noise that differences show: those of order 4 have less of a fast motion.

    They are taken from nine rows a period on.
    """
    first, second, fourth = (_rms(np.diff(x, n=order)) if len(x) > order else math.inf for order in (1, 2, 4))
    noise = second / math.sqrt(6.0)
    return min(noise, fourth / math.sqrt(70.0)) if second < _FOLLOWED * first else noise


def _changes(change: Array, by_rate: Array, of_rate: Array, noise: float, chance: float) -> _Changes:
    both, squares, own = (float(x @ y) for x, y in ((change, by_rate), (by_rate, by_rate), (change, change)))
    ratio, slope = both / squares if squares else 0.0, both / own if own else 1.0
    off, left = _rms(change - by_rate), _rms(change - ratio * by_rate)
    gone = change - by_rate
    faster = float(of_rate @ of_rate)
    late = float(gone @ of_rate) / faster if faster else 0.0
    after = _rms(gone - late * of_rate)
    return _Changes(ratio, slope, off, left, late, after, _rms(change), noise, chance)


def _rms(values: Array) -> float:
    return math.sqrt(float(np.mean(values**2)))
