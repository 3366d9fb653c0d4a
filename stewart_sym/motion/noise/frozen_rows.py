"""Rows in which a log is frozen: they repeat the row before them while the machine moves on."""

import math

import numpy as np

from ...io.array_types import Array, Flags
from ..noise_level import LEAST_SAMPLES, white_noise
from ..sample_times import elapsed, time_text
from ..trajectory import Log

# Fewest repeated rows: shorter runs are single faults. Noisy runs up to the second are bridged
# without harm even if the machine rests.
_FEWEST, _SHORT = 4, 12
# Rows without repetitions that must be on both sides.
_BESIDE = 3
# The next row differs by so many standard deviations of the noise, and by so many steps at the later speed.
_MOVES, _STEPS = 12.0, 2.0
# Fraction of the largest number to which numbers are read.
_DIGITS = 1e-13
# Runs that a warning names.
_MOST_NAMED = 4


def frozen_rows(log: Log, values: Array, steps: Array, held: Flags) -> Flags:
    """Return the rows, (n,), in which a sensor's columns of (n, 6), rounded to steps, (6,), are frozen.

    The first row after a rest continues the rest, the first row after a frozen log is where the motion is
    then. held: numbers that stay the same while others scatter, (n, 6).
    """
    time, frozen = elapsed(log.time), np.zeros(len(values), dtype=bool)
    moving = ~held.any(axis=1)
    noise = white_noise(time[moving], values[moving]) if np.count_nonzero(moving) >= LEAST_SAMPLES else 0.0
    floor = np.maximum(steps / math.sqrt(12.0), _DIGITS * np.abs(values).max(axis=0, initial=1.0))
    clear = _MOVES * np.maximum(noise, floor)
    for _, part in log.kinds():
        y = values[:, part] / clear[part]
        same = (np.diff(y, axis=0) == 0.0).all(axis=1)
        for first, end in np.flatnonzero(np.diff(same, prepend=False, append=False)).reshape(-1, 2) + 1:
            beside = [*same[max(first - 1 - _BESIDE, 0) : first - 1], *same[end : end + _BESIDE]]
            if end - first < _FEWEST or len(beside) < 2 * _BESIDE or any(beside):
                continue
            jump = float(np.linalg.norm(y[end] - y[first - 1]))
            speed = float(np.linalg.norm(y[end + 2] - y[end]) / (time[end + 2] - time[end]))
            moves_on = jump > max(1.0, _STEPS * speed * (time[end] - time[end - 1]))
            if moves_on or (end - first <= _SHORT and held[first:end, part].all()):
                frozen[first:end] = True
    return frozen


def runs_of(rows: Flags) -> list[tuple[int, int]]:
    """Return the first row of each run of True, and the row after its last one."""
    edges = np.flatnonzero(np.diff(rows, prepend=False, append=False)).reshape(-1, 2)
    return [(int(first), int(end)) for first, end in edges]


def tell_frozen(log: Log, frozen: Flags, bridged: bool) -> None:
    """Warn of frozen rows: lines, times, and the treatment."""
    step, runs, lines = float(np.median(np.diff(log.time))), runs_of(frozen), []
    for first, end in runs[:_MOST_NAMED]:
        start, last = (time_text(log.time[i], step) for i in (first, end - 1))
        lines.append(f"lines {log.rows[first]} to {log.rows[end - 1]} ({start} s to {last} s)")
    more = f" and {len(runs) - _MOST_NAMED} more runs" if len(runs) > _MOST_NAMED else ""
    done = "left out and bridged by a smooth curve" if bridged else "left as they are"
    fraction = 100.0 * float(np.mean(frozen))
    log.warn(
        f"{'; '.join(lines)}{more}: the log is frozen, each row repeats the row before it "
        f"({fraction:.2g} % of the rows): {done}; check the logger"
    )
