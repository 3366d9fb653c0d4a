"""Rows that stand still at the same numbers while all others scatter: dead bands, logs that stop at rest.

They show nothing of the noise, and their numbers are off by one draw of it for all of them.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ...io.array_types import Array, Flags
from ...io.instants import time_text
from ..noise_level import LEAST_SAMPLES, white_noise
from ..trajectory import Log

Runs = NDArray[np.int64]
"""First rows of stretches and those after their last, (k, 2)."""

# Fewest rows of a stretch, and the probability that noise repeats numbers so often in any row of a log.
_FEWEST, _BY_CHANCE = 6, 1e-6
# Noise beyond that of rounding, and least probability of a repeated number.
_BEYOND, _LEAST = 3.0, 1e-9


def still_runs(time: Array, values: Array, steps: Array) -> Runs:
    """Stretches of columns (n, c), rounded to steps, (c,), that stay the same, as no noise does."""
    same = (np.diff(values, axis=0) == 0.0).all(axis=1)
    runs = np.flatnonzero(np.diff(same, prepend=False, append=False)).reshape(-1, 2) + np.array([0, 1])
    runs = runs[runs[:, 1] - runs[:, 0] >= _FEWEST]
    moving = moving_rows(runs, len(values))
    if not len(runs) or np.count_nonzero(moving) < LEAST_SAMPLES:
        return np.zeros((0, 2), dtype=np.int64)
    sigma = white_noise(time[moving], values[moving])
    noisy = sigma > _BEYOND * steps / math.sqrt(12.0)
    # Of two numbers that scatter by sigma both are rounded to one with this probability.
    alike = steps[noisy] / (2.0 * math.sqrt(math.pi) * sigma[noisy])
    surprise = -np.sum(np.log(np.clip(alike, _LEAST, 1.0)))
    return np.asarray(runs[(runs[:, 1] - runs[:, 0] - 1) * surprise > math.log(len(values) / _BY_CHANCE)])


def moving_rows(runs: Runs, count: int) -> Flags:
    """Which of the rows are in none of the stretches, (n,)."""
    moving = np.ones(count, dtype=bool)
    for first, end in runs:
        moving[first:end] = False
    return moving


def held_offsets(runs: Runs, sigma: Array, count: int) -> Array:
    """By how much rows of the stretches may be off, (n, c): one deviation, with another sign in each next."""
    off = np.zeros((count, len(sigma)))
    for i, (first, end) in enumerate(runs):
        off[first:end] = sigma if i % 2 else -sigma
    return off


def tell_still(log: Log, runs: Runs) -> None:
    """Warn of stretches that stand still: when."""
    longest = runs[int(np.argmax(runs[:, 1] - runs[:, 0]))]
    step = float(np.median(np.diff(log.time)))
    start, end = (time_text(log.time[i], step) for i in (longest[0], longest[1] - 1))
    share = 100.0 * float(np.sum(runs[:, 1] - runs[:, 0])) / len(log.time)
    rows = f"rows {log.rows[longest[0]]} to {log.rows[longest[1] - 1]}"
    more = f"; {len(runs)} such stretches in all, {share:.2g} % of the rows" if len(runs) > 1 else ""
    log.warn(
        f"{rows} stand still at the same numbers from {start} s to {end} s, while others scatter{more}: the "
        "noise is that of the rows that move",
        7,
    )
