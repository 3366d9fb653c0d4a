"""Rows that no motion makes, gaps, clipped columns, rows that repeat or interpolate a slower sensor's.

For the former, blocks of samples, of several lengths, are fitted by polynomials. Where one offset explains
what these leave, and no jump of a velocity, an acceleration or a jerk does nearly as well, it is a fault.
"""

import itertools
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array
from .interpolation import quintic, values
from .sample_times import elapsed, least_step, time_text
from .trajectory import Log

# Lengths of blocks, samples, and the degrees of their polynomials.
_BLOCKS = ((8, 3), (16, 5), (32, 5), (64, 5), (128, 5))
# Rows that are off by the same amount before the numbers are right again.
_LONGEST = 4
# An offset is sure if it lowers the squares by so many variances of the noise and times what is left.
_SURE, _MOST_LEFT = 100.0, 6.0
# A jump of a derivative explains the rows as well unless it leaves so many times more, and so many variances.
_BETTER, _BETTER_BY = 4.0, 40.0
# Second differences of the motion that an offset exceeds.
_BENDS = 0.5
# An offset is seen only if the polynomial cannot follow at least this part of it.
_LEAST_SEEN = 0.02
# Numbers are read to this share of the largest.
_DIGITS = 1e-13
# Repeated rows are off by so many deviations and in line with the speeds beside them; rows that hold them and
# three good ones on both sides.
_MOVES, _IN_LINE, _CROWDED = 12.0, 0.25, 12
_ROUNDS, _CHUNK = 6, 1 << 14


class Fault(NamedTuple):
    """Samples of one column that are off: rows ``first`` to before ``end`` (None: all later) by ``size``."""

    column: int
    first: int
    end: int | None
    size: float


def faults(time: Array, values: Array, sigma: Array) -> list[Fault]:
    """Return the faults of columns (n, c) with white noise sigma, (c,) or (n, c), in order of time.

    Without noise sigma is 0. An offset is seen from about nine deviations of the noise divided by the root of
    the samples that tell it, and, without noise, from about what an acceleration of the motion moves between
    two samples.
    """
    found = _repeated(elapsed(time), values, sigma)
    corrected = values - offsets(found, values.shape)
    for _ in range(_ROUNDS):
        more = _separate(_scan(time, corrected, sigma))
        if not more:
            break
        corrected = corrected - offsets(more, values.shape)
        found += more
    return sorted(found, key=lambda fault: (fault.first, fault.column))


def _repeated(time: Array, values: Array, sigma: Array) -> list[Fault]:
    """Faults of rows near each other that repeat the one before them while a log moves on.

    Each is off by another amount: by how far a polynomial through three rows on both sides goes on. Rows that
    stand alone are left to ``_scan``.
    """
    same = np.concatenate([[False], (np.diff(values, axis=0) == 0.0).all(axis=1), [False]])
    edges = np.flatnonzero(np.diff(same.astype(np.int8))).reshape(-1, 2) + 1
    own, found = np.flatnonzero(~same[:-1]), []
    most = np.atleast_2d(sigma).max(axis=0)
    clear = _MOVES * np.maximum(most, _DIGITS * np.abs(values).max(axis=0, initial=1.0))
    for first, end in edges[edges[:, 1] - edges[:, 0] < _LONGEST]:
        i = int(np.searchsorted(own, first))
        near = own[max(i - 3, 0) : i + 3]
        apart = near[-1] - near[0] + 1
        if len(near) < 6 or apart > _CROWDED or apart == 7:
            continue
        t, y = time[near], values[near]
        bridge, speed = y[3] - y[2], (y[2] - y[1]) / (t[2] - t[1]) + (y[4] - y[3]) / (t[4] - t[3])
        off_line = (bridge - (t[3] - t[2]) / 2.0 * speed) / clear
        if np.linalg.norm(off_line) > _IN_LINE * np.linalg.norm(bridge / clear):
            continue
        fit = np.polynomial.polynomial.polyfit((t - t[2]) / (t[3] - t[2]), y, 5)
        since = (time[first:end] - t[2]) / (t[3] - t[2])
        off = values[first:end] - np.polynomial.polynomial.polyval(since, fit).T
        if (np.abs(off) > clear).any():
            sizes = [(i, j, float(off[i, j])) for i, j in np.ndindex(off.shape)]
            found += [Fault(j, int(first) + i, int(first) + i + 1, size) for i, j, size in sizes if size]
    return found


def offsets(found: list[Fault], shape: tuple[int, ...]) -> Array:
    """By how much the samples of columns are off, of a shape (n, c)."""
    off = np.zeros(shape)
    for fault in found:
        off[fault.first : fault.end, fault.column] += fault.size
    return off


class _Seen(NamedTuple):
    """A fault, by how much it is sure and how long the block is that shows it."""

    sureness: float
    length: int
    fault: Fault


def _separate(seen: list[_Seen]) -> list[Fault]:
    """The surest faults of each column that no surer one disturbs."""
    kept: list[_Seen] = []
    for each in sorted(seen, key=lambda one: -one.sureness):
        if all(
            abs(each.fault.first - other.fault.first) > max(each.length, other.length)
            for other in kept
            if other.fault.column == each.fault.column
        ):
            kept.append(each)
    return [each.fault for each in kept]


def _scan(time: Array, values: Array, sigma: Array) -> list[_Seen]:
    found: list[_Seen] = []
    time = elapsed(time)
    even = np.ptp(np.diff(time)) <= 1e-6 * np.median(np.diff(time)) if len(time) > 1 else True
    floor = np.maximum(sigma, _DIGITS * np.abs(values).max(axis=0, initial=0.0))
    for length, degree in _BLOCKS:
        for starts in _starts(len(time), length):
            at = starts[:, None] + np.arange(length)
            t = time[at[:1] if even else at]
            t = 2.0 * (t - t[:, :1]) / (t[:, -1:] - t[:, :1]) - 1.0
            noise = floor if floor.ndim == 1 else floor[at].max(axis=1)
            found += _in_blocks(t, values[at], noise, degree, starts, len(time))
    return found


def _starts(count: int, length: int) -> Iterator[NDArray[np.int64]]:
    """First samples of blocks that overlap by half, and of one that ends with the log."""
    if count < length:
        return
    every = np.unique(np.append(np.arange(0, count - length + 1, length // 2), count - length))
    per_chunk = max(1, _CHUNK // length)
    yield from (every[i : i + per_chunk] for i in range(0, len(every), per_chunk))


def _in_blocks(
    t: Array, y: Array, sigma: Array, degree: int, starts: NDArray[np.int64], count: int
) -> list[_Seen]:
    """Faults in blocks of samples, (b, l, c), with noise sigma, (c,) or (b, c).

    t: times from -1 to 1, (b, l) or (1, l).
    """
    blocks, length, columns = y.shape
    sigma = np.broadcast_to(sigma, (blocks, columns))
    B = np.linalg.qr(np.polynomial.legendre.legvander(t, degree))[0]
    y = y - y.mean(axis=1, keepdims=True)
    r = y - B @ (np.swapaxes(B, -1, -2) @ y)
    squares = np.sum(r**2, axis=1)
    # A motion that the polynomial follows leaves noise alone: nothing is to be explained.
    if not np.any(squares > _SURE * sigma**2):
        return []
    explained, size, last = _offset_gains(B, r)
    first, end = starts == 0, starts + length == count
    place, quarter = np.arange(length), length // 4
    own = (place >= quarter) | first[:, None]
    own &= (place < length - quarter) | end[:, None]
    explained = np.where(own[:, None, :, None], explained, 0.0).reshape(blocks, -1, columns)
    best = np.argmax(explained, axis=1)
    gain = np.take_along_axis(explained, best[:, None], axis=1)[:, 0]
    left = np.maximum(squares - gain, 0.0)
    dof = length - degree - 2
    excess = np.maximum(left - (dof + 4.0 * np.sqrt(2.0 * dof)) * sigma**2, 0.0)
    variance = np.maximum(sigma**2, left / dof)
    sure = gain > _SURE * variance + _MOST_LEFT * excess
    if not sure.any():
        return []
    other = squares - _jump_gains(t, B, r)
    sure &= other > _BETTER * excess + left + _BETTER_BY * variance
    found = []
    for block, column in np.argwhere(sure):
        kind, at = divmod(int(best[block, column]), length)
        run = last[kind]
        row = int(starts[block]) + at
        amount = float(size[block, kind, at, column])
        plain = y[block, :, column].copy()
        plain[at : at + run if run else None] -= amount
        bend = float(np.abs(np.diff(plain, n=2)).max())
        if abs(amount) < _BENDS * (bend - 10.0 * sigma[block, column]):
            continue
        weight = float(gain[block, column] / variance[block, column])
        found.append(_Seen(weight, length, Fault(int(column), row, row + run if run else None, amount)))
    return found


def _offset_gains(B: Array, r: Array) -> tuple[Array, Array, tuple[int, ...]]:
    """Squares that offsets explain and their sizes, (b, kinds, l, c); rows of each kind, 0 for all later."""
    length = r.shape[1]
    sums = np.concatenate([np.cumsum(r[:, ::-1], axis=1)[:, ::-1], np.zeros_like(r[:, :1])], axis=1)
    bases = np.concatenate([np.cumsum(B[:, ::-1], axis=1)[:, ::-1], np.zeros_like(B[:, :1])], axis=1)
    lasts = (0, *range(1, _LONGEST + 1))
    gains, sizes = np.zeros((2, r.shape[0], len(lasts), *r.shape[1:]))
    for kind, last in enumerate(lasts):
        end = np.full(length, length) if last == 0 else np.arange(length) + last
        at = np.flatnonzero(end <= length) if last else np.arange(1, length)
        end = end[at]
        product = sums[:, at] - sums[:, end]
        norm = (end - at) - np.sum((bases[:, at] - bases[:, end]) ** 2, axis=-1)
        seen = norm > _LEAST_SEEN * np.minimum(end - at, at + length - end)
        scale = np.where(seen, norm, 1.0)[..., None]
        gains[:, kind, at] = np.where(seen[..., None], product**2 / scale, 0.0)
        sizes[:, kind, at] = product / scale
    return gains, sizes, lasts


def _jump_gains(t: Array, B: Array, r: Array) -> Array:
    """Squares that the best jump of velocity, acceleration or jerk at any sample explains, (b, c)."""
    best = np.zeros((r.shape[0], r.shape[2]))
    apart = np.maximum(t[:, :, None] - t[:, None, :], 0.0)  # (b, sample, jump)
    for power in (1, 2, 3):
        h = apart**power
        product = np.swapaxes(h, -1, -2) @ r
        norm = np.sum(h**2, axis=1) - np.sum((np.swapaxes(B, -1, -2) @ h) ** 2, axis=1)
        seen = norm > 1e-9 * np.maximum(np.sum(h**2, axis=1), 1e-300)
        gain = np.where(seen[..., None], product**2 / np.where(seen, norm, 1.0)[..., None], 0.0)
        best = np.maximum(best, gain.max(axis=1))
    return best


# Rows that one line names at most; coordinates of a row that point to the row itself.
_MOST_NAMED, _MANY = 4, 3


def tell_faults(log: Log, found: Sequence[Fault]) -> None:
    """Warn of rows that no motion makes: when, which columns and by how much."""
    by_rows: dict[tuple[int, int | None], list[str]] = {}
    for fault in found:
        name, unit = column_of(log, fault.column)
        text = f"{name} by {fault.size:.3g} {unit}"
        by_rows.setdefault((fault.first, fault.end), []).append(text)
    lines = []
    for (first, end), texts in itertools.islice(by_rows.items(), _MOST_NAMED):
        when = time_text(log.time[first], least_step(log.time))
        lines.append(f"{rows_text(log, first, end)} ({when} s): {', '.join(texts)}")
    more = len(by_rows) - len(lines)
    ending = f"; and {more} more" if more > 0 else ""
    done = "left as they are"
    if log.smoothing.enabled or log.smoothing.repair:
        done = "replaced by a smooth curve"
        if any(fault.end is None for fault in found):
            done += "; standard deviations include the change by the step"
    cause = " (rows repeated or missing?)" if any(len(texts) >= _MANY for texts in by_rows.values()) else ""
    log.warn(f"numbers are off as no motion makes them{cause}: {'; '.join(lines)}{ending}: {done}")


def column_of(log: Log, column: int) -> tuple[str, str]:
    """Name of one of the six coordinates, and its SI unit."""
    name, part = next((name, part) for name, part in log.kinds() if column < part.stop)
    i = column - part.start
    return f"{name}_{('123456' if name == 'L' else 'xyz')[i]}", "rad" if name == "theta" else "m"


def rows_text(log: Log, first: int, end: int | None) -> str:
    """Rows of a fault, ``end`` None: to the log's end."""
    last = len(log.rows) if end is None else min(end, len(log.rows))
    rows = f"line {log.rows[first]}"
    if last - first > 1:
        rows += " on" if last == len(log.rows) else f" to {log.rows[last - 1]}"
    return rows


# A repair leaves nearly all rows as they are, and takes steps away that are small beside the path.
_REPAIRED, _STEPPED = 0.05, 0.1


def tell_no_repair(log: Log, good: Array, found: list[Fault]) -> None:
    """Warn of faults so many, or steps so large, that good columns, (n, 6), are not those of the log."""
    rows = {row for each in found for row in range(each.first, each.end or each.first + 1)}
    share, kinds = len(rows) / len(good), log.kinds()
    off = np.abs(offsets(found, good.shape)).max(axis=0)
    stepped = np.abs(offsets([each for each in found if each.end is None], good.shape)).max(axis=0)
    far = any(stepped[part].max() > _STEPPED * np.ptp(good[:, part], axis=0).max() for _, part in kinds)
    if not far and share <= _REPAIRED:
        return
    most = [log.kind(name)[1](float(off[part].max())) for name, part in kinds if off[part].any()]
    text = (
        f"{len(rows)} of {len(good)} rows ({100.0 * share:.2g} %) are replaced, and numbers change by up to "
        f"{' and '.join(most)}: that is no repair, and the results are not to be trusted"
    )
    log.warn(text)


# A step in time that is this many times the usual one, and of nine in ten steps, is a gap.
_GAP, _FEWEST_STEPS = 5.0, 4


def tell_gap(log: Log) -> None:
    """Warn of the longest gap in time, which a curve bridges."""
    step = np.diff(log.time)
    if len(step) < _FEWEST_STEPS:
        return
    usual, most = (float(x) for x in np.quantile(step, (0.5, 0.9)))
    gaps = np.flatnonzero(step > _GAP * max(usual, most))
    if not gaps.size:
        return
    i = int(gaps[np.argmax(step[gaps])])
    start, end = (time_text(time, usual) for time in log.time[i : i + 2])
    text = (
        f"lines {log.rows[i]} and {log.rows[i + 1]}: nothing from {start} s to {end} s, "
        f"{step[i] / usual:.3g} times the usual step of {usual:.3g} s"
    )
    more = f"; {gaps.size - 1} more gaps" if gaps.size > 1 else ""
    log.warn(f"{text}{more}: bridged by a smooth curve, as if the motion there were like elsewhere")


# Rows of a slower sensor

Rows = NDArray[np.int64]

# Rows that must have been measured for their distances to tell.
_FEWEST = 12
# Share of the distances between measured rows that are alike, to one row.
_REGULAR = 0.9
# Changes at measured rows are this many steps of rounding or more.
_STEPS = 4.0
_SAME_DIGITS = 1e-12
# Rows next to the first and the last that tell how fast accelerations change beyond them.
_NEAREST = 6


HELD = "held"
"""How rows between measured ones are filled that repeat these."""


class Sampling(NamedTuple):
    """Which rows of a log were measured, (m,), and how the others came about, in words."""

    rows: Rows
    kind: str


def slower_sampling(time: Array, values: Array, steps: Array) -> Sampling | None:
    """Return which rows of columns (n, c), rounded to steps, (c,), were measured; None for all of them.

    Held values change all at once and every few rows; interpolated ones bend so, by rows and by time: at a
    gap in time they bend by rows alone. Where nothing moves, rows
    at the same distance stand for those that can't be distinguished.
    """
    rounding = (
        np.maximum(steps, _SAME_DIGITS * np.abs(values).max(axis=0, initial=0.0)) + np.finfo(float).tiny
    )
    change = np.abs(np.diff(values, axis=0)) / rounding
    repeated = _regular(np.max(change, axis=1, initial=0.0), 0.0, len(values))
    if repeated is not None:
        return Sampling(repeated, HELD)
    before, after = np.diff(elapsed(time))[:-1, None], np.diff(elapsed(time))[1:, None]
    by_time = 2.0 * (np.diff(values, axis=0)[1:] * before - np.diff(values, axis=0)[:-1] * after)
    bend = np.minimum(np.abs(np.diff(values, n=2, axis=0)), np.abs(by_time) / (before + after)) / rounding
    bent = _regular(np.max(bend, axis=1, initial=0.0), 2.5, len(values))
    return None if bent is None else Sampling(bent, "interpolated linearly")


def _regular(size: Array, quiet: float, count: int) -> Rows | None:
    """Rows next to entries of size above ``quiet`` that lie a few rows apart; None if they don't."""
    rows = np.flatnonzero(size > quiet)
    gaps = np.diff(rows)
    if len(rows) < _FEWEST or np.median(size[rows]) < _STEPS:
        return None
    usual = float(np.median(gaps))
    moving = gaps[gaps < 4.0 * usual]
    # A row at which a number happens not to change makes one distance of two.
    alike = np.abs(moving / np.maximum(np.rint(moving / usual), 1.0) - usual) <= 1.0
    if usual < 2.0 or np.mean(alike) < _REGULAR or np.min(gaps) <= 0.5 * usual:
        return None
    every = max(2, round(usual))
    seen = rows + 1
    missing = [np.arange(a + every, b - every // 2, every) for a, b in itertools.pairwise(seen)]
    before, after = np.arange(seen[0] - every, -1, -every), np.arange(seen[-1] + every, count, every)
    return np.unique(np.concatenate([before, seen, after, *missing]))


# Columns that a sensor or a program clips

# Rows that stay at an extreme, the least speed that enters or leaves it, of the usual one, and how far that
# is the speed before: a motion that comes to rest has a third of it, one that is clipped a half or more.
_PLATEAU, _KINK, _AT_FULL_SPEED = 5, 0.2, (0.45, 2.2)
# Ends of stretches that show it; rows in which a motion goes on, and of these the last that would be at rest.
_ENDS, _GOES_ON, _STILL = 2, 10, 3


class Plateau(NamedTuple):
    """A number at which column ``column`` stays, at its largest or smallest, and the rows that have it."""

    column: int
    value: float
    rows: Rows


def plateaus(time: Array, values: Array, steps: Array) -> list[Plateau]:
    """Return the extremes at which columns (n, c), rounded to steps, (c,), are clipped.

    Two ends or more of such stretches have a kink: a motion that rests at an extreme gets there smoothly.
    """
    return [
        Plateau(i, extreme, at)
        for i, column in enumerate(values.T)
        for extreme in (float(column.min()), float(column.max()))
        if (at := _clipped(elapsed(time), column, extreme, float(steps[i]))).size
    ]


def _clipped(time: Array, column: Array, extreme: float, step: float) -> Rows:
    """Rows, (m,), of stretches at an extreme that are entered or left with a kink; none if these are few."""
    edges = np.flatnonzero(np.diff(column == extreme, prepend=False, append=False)).reshape(-1, 2)
    long = edges[edges[:, 1] - edges[:, 0] >= _PLATEAU]
    if not long.size or np.ptp(column) == 0.0:
        return np.zeros(0, dtype=np.int64)
    speeds = np.abs(np.diff(column) / np.diff(time))
    usual = float(np.median(speeds[speeds > 0.0]))
    low, high = _AT_FULL_SPEED

    def kinked(at: int, toward: int) -> bool:
        """Whether row ``at``, the last one that is clipped, is left at full speed."""
        i, j, k = at, at + 2 * toward, at + 4 * toward
        beyond = at + toward * np.arange(_GOES_ON)
        # A short step between rests is none.
        if not 0 <= beyond[-1] < len(time) or np.ptp(column[beyond[-_STILL:]]) == 0.0:
            return False
        near, far = (abs((column[b] - column[a]) / (time[b] - time[a])) for a, b in ((i, j), (j, k)))
        clear = abs(column[j] - column[i]) >= _STEPS * step
        return bool(clear and near > _KINK * usual and low * far < near < high * far)

    ends = [(kinked(int(a), -1), kinked(int(b) - 1, 1)) for a, b in long]
    if np.count_nonzero(ends) < _ENDS:
        return np.zeros(0, dtype=np.int64)
    return np.concatenate([np.arange(a, b) for (a, b), each in zip(long, ends, strict=True) if any(each)])


def tell_plateaus(log: Log, values: Array, steps: Array) -> None:
    """Warn of columns, (n, 6), that are clipped: at which numbers and for how long."""
    found = plateaus(log.time, values, steps)
    for column in dict.fromkeys(each.column for each in found):
        own = [each for each in found if each.column == column]
        name = column_of(log, column)[0]
        kind = name.rpartition("_")[0]
        at = " and ".join(f"{each.value / log.scale(kind):.6g}" for each in own)
        rows = np.sort(np.concatenate([each.rows for each in own]))
        share = len(rows) / len(log.time)
        lasts = share * (log.time[-1] - log.time[0])
        text = (
            f"{name} gets to {at} {log.unit(kind)} or away at full "
            f"speed and stays there for {lasts:.3g} s in all ({100.0 * share:.2g} % of the rows; first at "
            f"line {log.rows[rows[0]]}): is it clipped? forces there and nearby are wrong"
        )
        log.warn(text)


def spread(time: Array, rows: Rows, found: Array) -> Array:
    """Values, rates and second rates, (3, m, c), at some rows of n times as such at all of them, (3, n, c).

    Polynomials of degree 5 between the rows; before and after them the acceleration stays.
    """
    time = elapsed(time)
    at = time[rows]
    i = np.clip(np.searchsorted(at, time, side="right") - 1, 0, len(rows) - 2)
    h, since = (at[i + 1] - at[i])[:, None], (time - at[i])[:, None]
    between = np.stack(values(quintic(h, tuple(found[:, i]), tuple(found[:, i + 1])), since / h, h))
    for outside, end in ((time < at[0], 0), (time > at[-1], -1)):
        since, (x, v, a) = (time[outside] - at[end])[:, None], found[:, end]
        between[:, outside] = x + since * (v + 0.5 * since * a), v + since * a, a + 0.0 * since
    return between


def unseen(time: Array, rows: Rows, second_rates: Array) -> Array:
    """By how much values, rates and second rates, (3, n, c), of ``spread`` are off before and after the rows.

    There the second rates, (m, c) at the rows, change as fast as they do at most over the nearest few.
    """
    time = elapsed(time)
    at, off = time[rows], np.zeros((3, len(time), second_rates.shape[1]))
    ends = (time < at[0], 0, slice(_NEAREST)), (time > at[-1], -1, slice(-_NEAREST, None))
    for outside, end, near in ends:
        steps = np.diff(second_rates[near], axis=0) / np.diff(at[near])[:, None]
        since = np.abs(time[outside] - at[end])[:, None]
        fastest = np.abs(steps).max(axis=0)
        off[:, outside] = fastest * since**3 / 6.0, fastest * since**2 / 2.0, fastest * since
    return off
