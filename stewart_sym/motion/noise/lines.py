"""Lines in what a smooth curve leaves of a log: vibration, which may be motion and is no white noise."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ...io.array_types import Array
from ..trajectory import Log

# Fewest rows, and the probability that white noise makes a line in a log.
_FEWEST, _BY_CHANCE = 32, 1e-5
# Frequencies on each side whose median is the noise beside a line.
_BESIDE = 16
# Most rows whose spectrum is one: of longer logs it is that of each stretch of them.
_MOST = 1 << 14


class Line(NamedTuple):
    """A frequency, Hz, and the amplitude at it of each column, (c,)."""

    frequency: float
    amplitude: Array


def lines(time: Array, left: Array, sigma: Array) -> list[Line]:
    """Lines in what is left of columns, (n, c), over noise sigma, (c,), 0 where there is none; surest first.

    The power of white noise is exponentially distributed about one mean at every frequency; a line is power
    beyond that and beyond what is usual at frequencies beside it, in one column or in all together.
    """
    found: list[tuple[float, Line]] = []
    noisy = np.flatnonzero(sigma > 0.0)
    parts = max(1, math.ceil(len(time) / _MOST))
    for rows in np.array_split(np.arange(len(time)), parts):
        if len(rows) >= _FEWEST and len(noisy):
            found += _lines(time[rows], left[rows][:, noisy] / sigma[noisy], sigma[noisy], parts)
    lines_by_frequency: dict[int, tuple[float, Line]] = {}
    for sure, line in sorted(found, key=lambda each: each[0]):
        # Stretches of a long log may all show one line.
        lines_by_frequency[round(line.frequency * (time[-1] - time[0]) / parts / 2.0)] = sure, line
    surest = sorted(lines_by_frequency.values(), key=lambda each: -each[0])
    amplitudes = np.zeros((len(surest), len(sigma)))
    for amplitude, (_, line) in zip(amplitudes, surest, strict=True):
        amplitude[noisy] = line.amplitude
    return [Line(line.frequency, x) for (_, line), x in zip(surest, amplitudes, strict=True)]


def _lines(time: Array, left: Array, sigma: Array, parts: int) -> list[tuple[float, Line]]:
    """``lines`` of one stretch, with how sure each is; left: over sigma."""
    count = len(left)
    window = np.hanning(count + 2)[1:-1, None]
    power = np.abs(np.fft.rfft(window * left, axis=0)) ** 2 / np.sum(window**2)
    power = power[1:-1]
    # What is stated of the noise may be too small.
    usual = np.maximum(_beside(power), np.median(power, axis=0))
    level = np.maximum(usual / math.log(2.0), 1.0)
    # Minus the log of the probability of as much power: in one column, and as a bound in all of them.
    c, total = left.shape[1], np.sum(power / level, axis=1)
    joint = total - c - c * np.log(np.maximum(total / c, 1.0))
    least = math.log(len(power) * parts * (c + 1) / _BY_CHANCE)
    sure = np.maximum((power / level).max(axis=1), joint)
    step, found = (len(time) - 1) / (time[-1] - time[0]) / count, []
    edges = np.flatnonzero(np.diff(sure > least, prepend=False, append=False)).reshape(-1, 2)
    for first, end in edges:
        near = slice(max(first - 1, 0), end + 1)
        beyond = np.maximum(power[near] - level[near], 0.0)
        at = np.arange(near.start, near.start + len(beyond)) + 1
        frequency = step * float(at @ beyond.sum(axis=1) / beyond.sum())
        amplitude = sigma * np.sqrt(4.0 / count * beyond.sum(axis=0))
        found.append((float(sure[first:end].max()), Line(frequency, amplitude)))
    return found


def _beside(power: Array) -> Array:
    """Usual power at the frequencies about each, (m, c)."""
    reach = min(_BESIDE, len(power) // 2)
    wide = np.pad(power, ((reach, reach), (0, 0)), mode="reflect")
    return np.asarray(
        np.median(np.lib.stride_tricks.sliding_window_view(wide, 2 * reach + 1, axis=0), axis=-1)
    )


def line_covariance(found: Sequence[Line], columns: int) -> Array:
    """Covariance of value, rate and second rate, (c, 6), if lines are motion that a curve lacks.

    A deviation is the amplitude: legs may move in all coordinates at once.
    """
    total = np.zeros((columns, 6))
    for line in found:
        turn = 2.0 * math.pi * line.frequency
        total += np.outer(line.amplitude**2, [1.0, 0.0, turn**2, -(turn**2), 0.0, turn**4])
    return total


def tell_lines(log: Log, found: Sequence[Line]) -> None:
    """Warn of lines: at which frequency and how large the surest is."""
    line = found[0]
    parts = []
    for name, part in log.kinds():
        if line.amplitude[part].any():
            what, text = log.kind(name)
            parts.append(f"{text(float(line.amplitude[part].max()))} of {what}")
    more = f" and {len(found) - 1} more lines" if len(found) > 1 else ""
    log.warn(
        f"vibration of {line.frequency:.3g} Hz ({' and '.join(parts)}{more}): removed as noise, with its "
        "forces in the standard deviations; if it is motion, state the noise, raise --cutoff, or sample "
        "faster",
    )
