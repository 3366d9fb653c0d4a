"""Rows that stand still at the same numbers while others scatter: dead bands, brakes, logs that stop at rest.

They show nothing of the noise, and their numbers are off by one draw of it for all of them.
"""

import math

import numpy as np

from ...io.array_types import Array, Flags
from ..log_faults import column_of
from ..noise_level import LEAST_SAMPLES, white_noise
from ..sample_times import time_text
from ..trajectory import Log

# Fewest rows of a stretch, and the probability that noise repeats numbers so often in any row of a log.
_FEWEST, _BY_CHANCE = 6, 1e-6
# Noise beyond that of rounding, and least probability of a repeated number.
_BEYOND, _LEAST = 3.0, 1e-9


def still_rows(time: Array, values: Array, steps: Array) -> Flags:
    """Which numbers of columns (n, c), rounded to steps, (c,), stay the same as no noise does, (n, c).

    All columns together, or some of them: rows in which all move show the noise.
    """
    held, count = np.zeros(values.shape, dtype=bool), values.shape[1]
    for columns in (np.arange(count), *np.arange(count)[:, None]):
        own = held.copy()
        own[:, columns] |= _still(time, values[:, columns], steps[columns], count)[:, None]
        if np.count_nonzero(~own.any(axis=1)) >= LEAST_SAMPLES:
            held = own
    return held


def _still(time: Array, values: Array, steps: Array, kinds: int) -> Flags:
    """Which rows of columns that are looked at together stand still, (n,)."""
    same = (np.diff(values, axis=0) == 0.0).all(axis=1)
    runs = np.flatnonzero(np.diff(same, prepend=False, append=False)).reshape(-1, 2) + np.array([0, 1])
    runs = runs[runs[:, 1] - runs[:, 0] >= _FEWEST]
    moving = ~_of_runs(runs, len(values))
    if not len(runs) or np.count_nonzero(moving) < LEAST_SAMPLES:
        return np.zeros(len(values), dtype=bool)
    sigma = white_noise(time[moving], values[moving])
    noisy = sigma > _BEYOND * steps / math.sqrt(12.0)
    # Of two numbers that scatter by sigma both are rounded to one with this probability.
    alike = steps[noisy] / (2.0 * math.sqrt(math.pi) * sigma[noisy])
    surprise = -np.sum(np.log(np.clip(alike, _LEAST, 1.0)))
    sure = (runs[:, 1] - runs[:, 0] - 1) * surprise > math.log(kinds * len(values) / _BY_CHANCE)
    return _of_runs(runs[sure], len(values))


def _of_runs(runs: Array, count: int) -> Flags:
    """Which of the rows are in a stretch from its first to before its last, (k, 2)."""
    found = np.zeros(count, dtype=bool)
    for first, end in runs:
        found[first:end] = True
    return found


def held_offsets(values: Array, held: Flags, sigma: Array) -> Array:
    """By how much numbers, (n, c), held may be off: a deviation, with another sign in each next stretch."""
    begins = held.copy()
    begins[1:] &= ~held[:-1] | (np.diff(values, axis=0) != 0.0)
    sign = np.where(np.cumsum(begins, axis=0) % 2, -1.0, 1.0)
    return np.where(held, sign * sigma, 0.0)


def tell_still(log: Log, held: Flags) -> None:
    """Warn of numbers that stand still: when, and which where others of the rows move."""
    still = held.any(axis=1)
    runs = np.flatnonzero(np.diff(still, prepend=False, append=False)).reshape(-1, 2)
    longest = runs[int(np.argmax(runs[:, 1] - runs[:, 0]))]
    step = float(np.median(np.diff(log.time)))
    start, end = (time_text(log.time[i], step) for i in (longest[0], longest[1] - 1))
    rows = f"lines {log.rows[longest[0]]} to {log.rows[longest[1] - 1]}"
    own = held[longest[0] : longest[1]].any(axis=0)
    of = "" if own.all() else f" of {', '.join(column_of(log, int(i))[0] for i in np.flatnonzero(own))}"
    share = 100.0 * float(np.mean(still))
    more = f"; {len(runs)} such stretches in all, {share:.2g} % of the rows" if len(runs) > 1 else ""
    log.warn(
        f"{rows}{of}: constant numbers from {start} s to {end} s, while others scatter{more}; the noise is "
        "estimated from moving rows",
    )
