"""Rows of a log that were not measured: held, or interpolated linearly, between those of a slower sensor."""

import itertools
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array
from ..io.instants import elapsed
from .interpolation import quintic, values

Rows = NDArray[np.int64]

# Rows that must have been measured for their distances to tell.
_FEWEST = 12
# Share of the distances between measured rows that are alike, to one row.
_REGULAR = 0.9
# Changes at measured rows are this many steps of rounding or more.
_STEPS = 4.0
_DIGITS = 1e-12


class Sampling(NamedTuple):
    """Which rows of a log were measured, (m,), and how the others came about, in words."""

    rows: Rows
    kind: str


def slower_sampling(values: Array, steps: Array) -> Sampling | None:
    """Return which rows of columns (n, c), rounded to steps, (c,), were measured; None for all of them.

    Held values change all at once and every few rows; interpolated ones bend so. Where nothing moves, rows
    at the same distance stand for those that can't be distinguished.
    """
    rounding = np.maximum(steps, _DIGITS * np.abs(values).max(axis=0, initial=0.0)) + np.finfo(float).tiny
    change = np.abs(np.diff(values, axis=0)) / rounding
    repeated = _regular(np.max(change, axis=1, initial=0.0), 0.0, len(values), 1)
    if repeated is not None:
        return Sampling(repeated, "held")
    bend = np.abs(np.diff(values, n=2, axis=0)) / rounding
    bent = _regular(np.max(bend, axis=1, initial=0.0), 2.5, len(values), 1)
    return None if bent is None else Sampling(bent, "interpolated linearly")


def _regular(size: Array, quiet: float, count: int, offset: int) -> Rows | None:
    """Rows, from entries of size above ``quiet``, that lie a few rows apart; None if they don't."""
    rows = np.flatnonzero(size > quiet)
    gaps = np.diff(rows)
    if len(rows) < _FEWEST or np.median(size[rows]) < _STEPS:
        return None
    usual = float(np.median(gaps))
    moving = gaps[gaps < 4.0 * usual]
    # A row at which a number happens not to change makes one distance of two.
    alike = np.abs(moving / np.maximum(np.rint(moving / usual), 1.0) - usual) <= 1.0
    if usual < 2.0 or np.mean(alike) < _REGULAR or np.min(gaps) < 0.5 * usual:
        return None
    every = max(2, round(usual))
    seen = rows + offset
    missing = [np.arange(a + every, b - every // 2, every) for a, b in itertools.pairwise(seen)]
    before, after = np.arange(seen[0] - every, -1, -every), np.arange(seen[-1] + every, count, every)
    return np.unique(np.concatenate([before, seen, after, *missing]))


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
