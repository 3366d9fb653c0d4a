"""The noise in a log: as it is stated or shown, and what is doubtful about either."""

import dataclasses
import math
from collections.abc import Callable

import numpy as np

from ...io.array_types import Array, Flags
from ..noise_level import (
    FEWEST_SAMPLES,
    LEAST_SAMPLES,
    Level,
    decided_noise,
    like_noise,
    noise_level,
    varying_noise,
)
from ..sample_times import elapsed, time_text
from ..smoothing import likeliest_noise, shown_noise, smoothed
from ..trajectory import Log

MIN_SPLINE_POINTS = 4
"""Fewest rows that a spline goes through."""


# Stretches of rows in which noise is looked for by likelihood, and how far what they show differs.
_STRETCHES, _LENGTH, _ALIKE = 4, 96, 3.0
# By how much -2 log likelihood of all columns falls with noise; longest step over the usual one.
_DECIDED, _UNEVEN = 100.0, 4.0


def found_noise(time: Array, values: Array, steps: Array) -> Level:
    """``shown_noise``, and where differences show none, that with which curves are likeliest.

    Beside a motion of five to ten rows a period differences show the motion alone.
    """
    level = shown_noise(time, values, steps)
    count = min(_LENGTH, len(time))
    none = level.sigma <= level.least
    if len(time) < LEAST_SAMPLES or 2 * np.count_nonzero(none) <= len(none):
        return level
    least = np.maximum(level.least, 1e-12 * np.abs(values).max(axis=0))[none] + np.finfo(float).tiny
    found = []
    for start in {int(i) for i in np.linspace(0, len(time) - count, _STRETCHES)}:
        rows = slice(start, start + count)
        step = np.diff(time[rows])
        own = values[rows, none]
        if step.max() > _UNEVEN * np.median(step):
            return level
        sigma, gain = likeliest_noise(time[rows], own, least)
        noisy = like_noise(elapsed(time[rows]), own, sigma)
        if np.sum(gain[noisy]) < _DECIDED or 2 * np.count_nonzero(noisy) < len(noisy):
            return level
        found.append(sigma)
    usual = np.median(found, axis=0)
    if np.max(found / usual) > _ALIKE or np.max(usual / found) > _ALIKE:
        return level
    sigma = level.sigma.copy()
    sigma[none] = usual
    return level._replace(sigma=sigma)


def shown_level(log: Log, values: Array, steps: Array, held: Flags, tell: bool = False) -> Level:
    """Noise that coordinates, (n, 6), show, rounded to steps, (6,): of rows in which none is held still."""
    if not held.any():
        return with_scale(log, values, found_noise(log.time, values, steps), tell)
    moving = ~held.any(axis=1)
    time, values = log.time[moving], values[moving]
    level = with_scale(dataclasses.replace(log, time=time), values, found_noise(time, values, steps), tell)
    scale = level.scale
    if scale is not None:
        scale = np.stack([np.interp(log.time, time, column) for column in scale.T], axis=-1)
    sigma, noisy = level.sigma.copy(), level.sigma > level.least
    if noisy.any() and scale is None:
        # What a curve through these rows alone leaves: through all of them it would be less.
        own = Level(level.sigma[noisy], level.least[noisy])
        sigma[noisy] = smoothed(time, values[:, noisy], own, None).noise_std
    return level._replace(sigma=sigma, least=sigma, scale=scale)


def chosen_level(log: Log, shown: Level) -> Level:
    """Noise of six coordinates as stated or shown; with a cut-off only as stated."""
    known = stated_noise(log)
    if log.smoothing.cutoff_frequency is not None:
        return Level(known, known)
    return Level(
        np.where(known > 0.0, known, shown.sigma),
        np.where(known > 0.0, known, shown.least),
        1.0 if known.all() else shown.correlation,
        None if shown.scale is None or known.all() else np.where(known > 0.0, 1.0, shown.scale),
    )


def with_scale(log: Log, values: Array, level: Level, tell: bool = False) -> Level:
    """The level of the noise with its scale where it changes along the log, of each sensor by itself."""
    if level.correlation > 1.0 or log.smoothing.cutoff_frequency is not None or not log.smoothing.enabled:
        return level
    for name, part in log.kinds():
        varies = None
        if (level.sigma[part] > level.least[part]).any() and log.smoothing.stated(name) is None:
            varies = varying_noise(log.time, values[:, part], level.least[part])
        if varies is not None:
            sigma, scale = level.sigma.copy(), np.ones(values.shape) if level.scale is None else level.scale
            sigma[part], scale[:, part] = varies[0], varies[1][:, None]
            level = level._replace(sigma=sigma, scale=scale)
            if tell:
                _warn_of_varying(log, name, varies[1])
    return level


def _warn_of_varying(log: Log, name: str, scale: Array) -> None:
    """Warn of noise of one kind of coordinates that is larger for a while, at rows times scale, (n,)."""
    large = scale > math.sqrt(scale.max())
    edges = np.flatnonzero(np.diff(large.astype(np.int8), prepend=0, append=0)).reshape(-1, 2)
    step = float(np.median(np.diff(log.time)))
    first, last = (time_text(log.time[i], step) for i in (edges[0, 0], edges[0, 1] - 1))
    more = f"; larger in {len(edges)} stretches in all" if len(edges) > 1 else ""
    times = float(np.median(scale[large]) / np.median(scale[~large]))
    log.warn(
        f"noise of {log.kind(name)[0]} is {times:.2g} times as large from {first} s to {last} s as elsewhere"
        f"{more}: smoothed and counted as it is there",
    )


def stated_noise(log: Log) -> Array:
    """What is stated of the noise of six coordinates, (6,); 0 where nothing is."""
    known = np.zeros(6)
    for name, part in log.kinds():
        known[part] = log.smoothing.stated(name) or 0.0
    return known


# Times that the scatter of a log is its stated noise without a warning. Smaller is soon harmful: the decided
# scatter is within 1.3 of the noise. Larger may be: noise within the motion's own frequencies shows in no
# scatter, but in how far the numbers move. A wrong unit makes at least 25.
_SMALLER, _LARGER, _OF_RANGE, _OTHER_UNIT = 1.5, 30.0, 1.0 / 3.0, 10.0
# Times that the noise of rounding is the stated noise without a warning.
_ROUNDED = 3.0
# Noise of so many times the largest number, m or rad, or 1, is none.
_ABSURD = 10.0


def warn_of_stated(log: Log, values: Array, steps: Array) -> None:
    """Warn of stated noise that is far from what the log shows beyond doubt, in the log's own units."""
    for name, part in log.kinds():
        known = log.smoothing.stated(name)
        if known is None or (
            name == "L" and not log.smoothing.enabled
        ):  # without it a noise of poses is stated
            continue
        what, text = log.kind(name)
        statement = f"stated noise of {what} of {text(known)}"
        most = _ABSURD * max(1.0, float(np.abs(values[:, part]).max()))
        if known > most:
            raise ValueError(
                f"{log.source}: {statement}: expected less than {text(most)}; is its unit right?"
            )
        doubt = doubt_of_noise(known, log.time, values[:, part], steps[part], text)
        if doubt is not None:
            log.warn(f"{statement}, but they {doubt}")


def too_few(log: Log) -> bool:
    """Whether rows are too few to look for noise that is not stated."""
    looked_for = (
        log.smoothing.enabled and log.smoothing.cutoff_frequency is None and not stated_noise(log).all()
    )
    return looked_for and len(log.time) < FEWEST_SAMPLES


def warn_of_few(log: Log, values: Array) -> None:
    """Warn of rows that are too few to look for their noise."""
    if too_few(log) and len(log.time) >= MIN_SPLINE_POINTS and np.ptp(values, axis=0).any():
        text = (
            f"{len(log.time)} rows are too few to distinguish noise from motion: forces and deviations are "
            "those without noise beyond rounding; where there is more, state it "
            "(--position-std, --angle-std; in Python Smoothing)"
        )
        log.warn(text)


def doubt_of_noise(
    known: float, time: Array, values: Array, steps: Array, text: Callable[[float], str]
) -> str | None:
    """What a sensor's columns, (n, c), say against noise that is stated, in words; None: nothing."""
    shown = decided_noise(time, values, steps)
    if not shown:
        if len(time) < 2 * LEAST_SAMPLES:
            return None
        moving = steps[np.ptp(values, axis=0) > 0.0]
        step = float(moving.min(initial=math.inf))
        if known < step / math.sqrt(12.0) / _ROUNDED < math.inf:
            return f"are rounded to {text(step)}, which alone makes {text(step / math.sqrt(12.0))}"
        path = float(np.ptp(values, axis=0).max())
        most = max(_OF_RANGE * path, _LARGER * float(noise_level(time, values, steps).sigma.max()))
        return f"move over {text(path)} in all: is its unit right?" if known > most > 0.0 else None
    if shown / _SMALLER <= known <= _LARGER * shown:
        return None
    cause = (
        "is its unit right?"
        if not shown / _OTHER_UNIT <= known < shown
        else "stated too small, it leaves noise in the accelerations"
    )
    return f"scatter by {text(shown)}: {cause}"
