"""Rates of a log: splines through its poses, smooth curves where there is noise, gaps, rows that are off."""

import dataclasses
import itertools
import math
import warnings
from collections.abc import Callable, Sequence

import numpy as np

from ..io.array_types import Array, Flags
from ..io.extras import needed_for
from ..io.instants import elapsed, least_step, lost, time_text
from .log_faults import Fault, faults, offsets, slower_sampling, spread
from .noise_level import LEAST_SAMPLES, Level, LogWarning, decided_noise, noise_level, stated
from .smoothing import PAIRS, check_cutoff, smoothed
from .trajectory import POSE, Log, Replaced, Uncertainty

_MIN_SPLINE_POINTS = 4
# What needs SciPy, and what helps without.
SPLINE = ("a trajectory without derivatives", ", or add columns of all velocities and accelerations")
_PART = 1 << 14


def rates_of(log: Log, values: Array, steps: Array) -> tuple[Array, Uncertainty | None]:
    """Coordinates, (n, 6), with rates and second rates, (3, n, 6), smoothed where there is noise.

    Poses that a log repeats or interpolates from those of a slower sensor don't count. Rows of poses that no
    motion makes are replaced, with a warning; what that changes counts as a deviation.
    """
    steps = np.maximum(steps, _lost_steps(log, values))
    slower = slower_sampling(values, steps) if log.smoothing.on and "L" not in log.written else None
    measured_at = log.time if slower is None else log.time[slower[0]]
    cutoff = log.smoothing.cutoff
    if cutoff is not None and log.smoothing.on and len(measured_at) >= _MIN_SPLINE_POINTS:
        check_cutoff(measured_at, cutoff)
    _warn_of_gap(log)
    if slower is None:
        return _replaced(log, values, steps)
    rows, kind = slower
    text = f"{len(log.time)} rows are {kind} between {len(rows)} measured ones, each taken for its first row"
    warnings.warn(f"{log.source}: {text}", LogWarning, stacklevel=6)
    measured = dataclasses.replace(log, time=log.time[rows], rows=[log.rows[i] for i in rows])
    few, noise = _replaced(measured, values[rows], steps)
    found = spread(log.time, rows, few)
    return found, None if noise is None else noise._replace(coordinates=found)


# Share of the usual step in time, rounded off, from which on accelerations tell.
_LOST = 1e-6
# Share of the steps that are not faster than the speed that counts.
_FAST = 0.9


def _lost_steps(log: Log, values: Array) -> Array | float:
    """What coordinates, (n, c), change by in the digits that their times have beyond those of doubles, (c,).

    Such times make the same errors as rounded coordinates do.
    """
    step, rounded = np.diff(log.time), lost(log.time)
    if not step.size or rounded <= _LOST * np.median(step):
        return 0.0
    return rounded * np.quantile(np.abs(np.diff(values, axis=0)) / step[:, None], _FAST, axis=0)


def _replaced(log: Log, values: Array, steps: Array) -> tuple[Array, Uncertainty | None]:
    """``rates_of`` of rows that were measured."""
    _warn_of_stated(log, values, steps)
    shown = noise_level(log.time, values, steps)
    level = _level(log, shown)
    # Neither a cut-off nor a statement makes rows wrong that are within the scatter of all.
    bad = [] if "L" in log.written else faults(log.time, values, np.maximum(level.sigma, shown.sigma))
    if bad:
        _tell_faults(log, bad)
    if not bad or not log.smoothing.on:
        return _derivatives(log, values, level)
    good = values - offsets(bad, values.shape)
    found, noise = _derivatives(log, good, _level(log, noise_level(log.time, good, steps)))
    changed = found - _derivatives(log, values, level, tell=False)[0]
    near = _changed_instants(changed)
    return found, _with_changes(log.time, found, noise, changed, near)._replace(
        replaced=_replaced_rows(log, bad, near)
    )


def _with_changes(
    time: Array, found: Array, noise: Uncertainty | None, changed: Array, near: Flags
) -> Uncertainty:
    """Uncertainty in which changes of coordinates and rates, (3, n, 6), count as a deviation, ``near``."""
    if noise is None:
        noise = Uncertainty(found, time[[0, -1]], np.zeros((2, 6, len(PAIRS))), np.zeros(6))
    rows = np.flatnonzero(np.convolve(near, np.ones(3), "same"))
    squares = np.stack([changed[i, rows] * changed[j, rows] for i, j in PAIRS], axis=-1)
    squares *= near[rows, None, None]
    grid = np.union1d(noise.grid, time[rows])

    def on_grid(times: Array, covariance: Array) -> Array:
        flat = covariance.reshape(len(times), -1)
        return np.stack([np.interp(grid, times, x) for x in flat.T], axis=-1).reshape(-1, 6, len(PAIRS))

    covariance = on_grid(noise.grid, noise.covariance) + on_grid(time[rows], squares)
    return noise._replace(grid=grid, covariance=covariance)


def _derivatives(
    log: Log, values: Array, level: Level, tell: bool = True
) -> tuple[Array, Uncertainty | None]:
    """``rates_of`` of numbers with a level of noise."""
    noisy = level.sigma > 0.0
    if log.smoothing.cutoff is not None:
        noisy[:] = True
    if len(log.time) < _MIN_SPLINE_POINTS or not log.smoothing.on:
        noisy[:] = False
    found = np.empty((3, *values.shape))
    if not noisy.all():
        found[0][:, ~noisy] = values[:, ~noisy]
        since = elapsed(log.time)
        spline = _spline(since, values[:, ~noisy], log.source)
        # In parts, since a spline's values come in arrays of their own.
        for part in (slice(i, i + _PART) for i in range(0, len(since), _PART)):
            for order in (1, 2):
                found[order, part][:, ~noisy] = spline(since[part], order)
    if not noisy.any():
        return found, None
    own = Level(level.sigma[noisy], level.least[noisy])
    smooth = smoothed(log.time, values[:, noisy], own if own.sigma.all() else None, log.smoothing.cutoff)
    found[..., noisy] = [smooth.values, smooth.rates, smooth.second_rates]
    covariance, sigma = np.zeros((len(smooth.grid), 6, 6)), np.zeros(6)
    covariance[:, noisy], sigma[noisy] = smooth.covariance, smooth.sigma
    noise = Uncertainty(found, smooth.grid, covariance, sigma, "L" in log.written)
    if tell and log.smoothing.cutoff is not None:
        _warn_of_cutoff(log, values, found)
    if tell and _matters(noise):
        more = _CORRELATED.format(level.correlation) if level.correlation > 1.0 else ""
        warnings.warn(f"{log.source}: {noise_text(noise)}: smoothed{more}", LogWarning, stacklevel=8)
    return found, noise


# A cut-off removes motion where what it removes is so many times what changes from row to row, and would be
# this share of usual accelerations at the cut-off.
_NOT_NOISE, _MISSED = 3.0, 0.05


def _warn_of_cutoff(log: Log, values: Array, found: Array) -> None:
    """Warn of a cut-off below frequencies of the motion; found: coordinates and rates, (3, n, 6)."""
    assert log.smoothing.cutoff is not None
    removed = values - found[0]
    missed = np.sqrt(np.mean(removed**2, axis=0))
    # White noise changes by the root of 2 of its deviation.
    slow = missed > _NOT_NOISE * np.sqrt(np.mean(np.diff(removed, axis=0) ** 2, axis=0) / 2.0)
    parts = []
    for name, part in _kinds(log):
        # Not the largest: at the ends it is that of what is lost.
        usual = float(np.quantile(np.abs(found[2][:, part]), 0.9))
        least = _MISSED * usual / (2.0 * math.pi * log.smoothing.cutoff) ** 2
        most = float(np.max(missed[part] * slow[part]))
        if most > least:
            what, in_unit = _kind(log, name)
            parts.append(f"of {what} of {in_unit(most)}")
    if parts:
        text = f"the cut-off of {log.smoothing.cutoff:g} Hz removes changes {' and '.join(parts)}"
        warnings.warn(
            f"{log.source}: {text}: motion, not noise, and the forces lack it", LogWarning, stacklevel=9
        )


def _kinds(log: Log) -> tuple[tuple[str, slice], ...]:
    """Names of vectors in a log, with their columns."""
    return (("L", slice(6)),) if "L" in log.written else (("t", slice(3)), ("theta", slice(3, 6)))


def _kind(log: Log, name: str) -> tuple[str, Callable[[float], str]]:
    """What vectors of a log are called, and how a number of them is written in the log's units."""
    scale = log.scale(name)
    unit = log.form.angle_unit if name == "theta" else log.form.length_unit
    what = {"L": "lengths", "t": "positions", "theta": "angles"}[name]
    return what, lambda number: f"{number / scale:.2g} {unit}"


# Noise without a warning: shares of the largest acceleration, gravity's at least, and of the path.
_LITTLE, _PATH = 1e-3, 1e-6
_GRAVITY = 9.81
_CORRELATED = (
    "; it is correlated, {:.2g} times as large in slow changes as white noise is, which the deviations hold "
    "as far as it shows beside the motion"
)


def _matters(noise: Uncertainty) -> bool:
    """Whether noise in the log is beyond a small share of the path or of the accelerations."""
    second = np.sqrt(np.max(noise.covariance[:, :, 5], axis=0))
    for part in (slice(6),) if noise.in_joints else (slice(3), slice(3, 6)):
        values, _, seconds = noise.coordinates[..., part]
        largest = max(float(np.abs(seconds).max()), _GRAVITY)
        path = float(np.ptp(values, axis=0).max())
        if second[part].max() > _LITTLE * largest or noise.sigma[part].max() > _PATH * path:
            return True
    return False


def noise_text(noise: Uncertainty) -> str:
    """The noise found in a log, in words."""
    parts = [(slice(6), "m")] if noise.in_joints else [(slice(3), "m"), (slice(3, 6), "rad")]
    text = " and ".join(
        f"{noise.sigma[part].max():.2g} {unit}" for part, unit in parts if noise.sigma[part].any()
    )
    return f"noise of {text} in the log"


def _level(log: Log, shown: Level) -> Level:
    """Noise of six coordinates as stated or shown; with a cut-off only as stated."""
    names = ("L", "L") if "L" in log.written else POSE
    known = np.repeat([log.smoothing.stated(name) or 0.0 for name in names], 3)
    if log.smoothing.cutoff is not None:
        return stated(known)
    return Level(
        np.where(known > 0.0, known, shown.sigma),
        np.where(known > 0.0, known, shown.least),
        1.0 if known.all() else shown.correlation,
    )


# Times that the scatter of a log is its stated noise without a warning. Smaller is soon harmful: the decided
# scatter is within 1.3 of the noise. Larger may be: noise within the motion's own frequencies shows in no
# scatter, but in how far the numbers move. A wrong unit makes at least 25.
_SMALLER, _LARGER, _OF_RANGE, _OTHER_UNIT = 1.5, 30.0, 1.0 / 3.0, 10.0
# Times that the noise of rounding is the stated noise without a warning.
_ROUNDED = 3.0
# Noise of so many times the largest number, m or rad, or 1, is none.
_ABSURD = 10.0


def _warn_of_stated(log: Log, values: Array, steps: Array) -> None:
    """Warn of stated noise that is far from what the log shows beyond doubt, in the log's own units."""
    for name, part in _kinds(log):
        known = log.smoothing.stated(name)
        if known is None or (name == "L" and not log.smoothing.on):  # without it a noise of poses is stated
            continue
        what, text = _kind(log, name)
        statement = f"{log.source}: stated noise of {what} of {text(known)}"
        most = _ABSURD * max(1.0, float(np.abs(values[:, part]).max()))
        if known > most:
            raise ValueError(f"{statement}: expected less than {text(most)}; is its unit right?")
        doubt = _doubt_of_noise(known, log.time, values[:, part], steps[part], text)
        if doubt is not None:
            warnings.warn(f"{statement}, but they {doubt}", LogWarning, stacklevel=8)


def _doubt_of_noise(
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


def as_given(log: Log, found: Array, steps: Sequence[Array]) -> Uncertainty | None:
    """Uncertainty of coordinates and rates, (3, n, 6), all of them measured and rounded to steps, (3, 6)."""
    names = ("L", "L") if "L" in log.written else POSE
    if log.smoothing.cutoff is not None:
        text = "the file has rates, which are taken as they are: the cut-off changes nothing"
        warnings.warn(f"{log.source}: {text}", LogWarning, stacklevel=7)
    known = np.repeat([log.smoothing.stated(name) or 0.0 for name in names], 3)
    _warn_of_stated(log, found[0], steps[0])
    sigma = np.array(steps) / math.sqrt(12.0)
    sigma[0] = np.where(known > 0.0, known, sigma[0])
    if not sigma.any() or not log.smoothing.on:
        return None
    covariance = np.zeros((2, 6, 6))
    covariance[:, :, [0, 2, 5]] = sigma.T**2
    return Uncertainty(found, log.time[[0, -1]], covariance, sigma[0])


# A step in time that is this many times the usual one, and of nine in ten steps, is a gap.
_GAP = 5.0


def _warn_of_gap(log: Log) -> None:
    """Warn of the longest gap in time, which a curve bridges."""
    step = np.diff(log.time)
    if len(step) < _MIN_SPLINE_POINTS:
        return
    usual, most = (float(x) for x in np.quantile(step, (0.5, 0.9)))
    gaps = np.flatnonzero(step > _GAP * max(usual, most))
    if not gaps.size:
        return
    i = int(gaps[np.argmax(step[gaps])])
    start, end = (time_text(time, usual) for time in log.time[i : i + 2])
    text = (
        f"rows {log.rows[i]} and {log.rows[i + 1]}: nothing from {start} s to {end} s, "
        f"{step[i] / usual:.3g} times the usual step of {usual:.3g} s"
    )
    more = f"; {gaps.size - 1} more gaps" if gaps.size > 1 else ""
    warnings.warn(f"{log.source}: {text}{more}: bridged by a smooth curve", LogWarning, stacklevel=7)


# Rows that one line names at most; coordinates of a row that point to the row itself.
_MOST_NAMED, _MANY = 4, 3


def _tell_faults(log: Log, found: Sequence[Fault]) -> None:
    """Warn of rows that no motion makes: when, which columns and by how much."""
    by_rows: dict[tuple[int, int | None], list[str]] = {}
    for fault in found:
        names = ("t", "t", "t", "theta", "theta", "theta")
        unit = "m" if fault.column < 3 else "rad"
        text = f"{names[fault.column]}_{'xyz'[fault.column % 3]} by {fault.size:.3g} {unit}"
        by_rows.setdefault((fault.first, fault.end), []).append(text)
    lines = []
    for (first, end), texts in itertools.islice(by_rows.items(), _MOST_NAMED):
        when = time_text(log.time[first], least_step(log.time))
        lines.append(f"{_rows_text(log, first, end)} ({when} s): {', '.join(texts)}")
    more = len(by_rows) - len(lines)
    ending = f"; and {more} more" if more > 0 else ""
    done = "replaced, and deviations there hold what this changes" if log.smoothing.on else "left as they are"
    cause = " (rows repeated or missing?)" if any(len(texts) >= _MANY for texts in by_rows.values()) else ""
    warnings.warn(
        f"{log.source}: numbers are off as no motion makes them{cause}: {'; '.join(lines)}{ending}: {done}",
        LogWarning,
        stacklevel=7,
    )


# Share of the largest change of a second rate beyond which one counts.
_CHANGED = 0.02


def _changed_instants(changed: Array) -> Flags:
    """Instants, (n,), at which changes of coordinates and rates, (3, n, 6), count."""
    size = np.abs(changed[2])
    return np.asarray((size > _CHANGED * size.max(axis=0)).any(axis=1))


def _replaced_rows(log: Log, bad: Sequence[Fault], near: Flags) -> tuple[Replaced, ...]:
    """Spans of instants at which replaced rows count, with the faults that are nearest to each."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], near, [False]]).astype(np.int8)))
    rows = list(dict.fromkeys((fault.first, fault.end) for fault in bad))
    first = np.array([start for start, _ in rows])
    names = [
        f"the step at row {log.rows[start]}" if end is None else _rows_text(log, start, end)
        for start, end in rows
    ]
    found, last = [], len(log.time) - 1
    for a, b in edges.reshape(-1, 2):
        apart = np.maximum(np.maximum(a - first, first - b + 1), 0)
        nearest = tuple(name for name, away in zip(names, apart, strict=True) if away == apart.min())
        ends = float(log.time[max(a - 1, 0)]), float(log.time[min(b, last)])
        found.append(Replaced(*ends, nearest))
    return tuple(found)


def _rows_text(log: Log, first: int, end: int | None) -> str:
    """Rows of a fault, ``end`` None: to the log's end."""
    last = len(log.rows) if end is None else min(end, len(log.rows))
    rows = f"row {log.rows[first]}"
    if last - first > 1:
        rows += " on" if last == len(log.rows) else f" to {log.rows[last - 1]}"
    return rows


def _spline(since: Array, values: Array, source: str) -> Callable[..., Array]:
    if len(since) < _MIN_SPLINE_POINTS:
        raise ValueError(
            f"{source}: expected at least {_MIN_SPLINE_POINTS} rows to fit a spline, got {len(since)}; "
            "add rows, or columns with velocities and accelerations"
        )
    with needed_for(*SPLINE):
        from scipy.interpolate import make_interp_spline
    try:
        found: Callable[..., Array] = make_interp_spline(since, values, k=5 if len(since) > 5 else 3)
        return found
    except (ValueError, np.linalg.LinAlgError) as error:
        raise ValueError(f"{source}: no spline fits these times: {' '.join(str(error).split())}") from None
