"""Rates of a log: splines through its poses, smooth curves where there is noise, gaps, rows that are off."""

import dataclasses
import functools
import itertools
import math
from collections.abc import Callable, Sequence

import numpy as np

from ..io.array_types import Array, Flags
from ..io.extras import absent, needed_for
from . import log_faults
from .interpolation import PAIRS, breaks, check_cutoff, in_gaps
from .noise import in_log
from .noise.frozen_rows import frozen_rows, tell_frozen
from .noise.lines import line_covariance, lines, tell_lines
from .noise.sparse_rows import DEGREE, FEWEST, end_errors
from .noise.still_rows import held_offsets, still_rows, tell_still
from .noise_level import Level
from .sample_times import elapsed, lost, time_text
from .smoothing import smoothed
from .trajectory import Log, Replaced, Uncertainty

# What needs SciPy, and what helps without.
SPLINE = ("a trajectory without derivatives", ", or add columns of all velocities and accelerations")
_PART = 1 << 14


def rates_of(log: Log, values: Array, steps: Array) -> tuple[Array, Uncertainty | None]:
    """Coordinates, (n, 6), with rates and second rates, (3, n, 6), smoothed where there is noise.

    Poses that a log repeats or interpolates from those of a slower sensor don't count. Rows of poses that no
    motion makes are replaced, with a warning; what that changes counts as a deviation.
    """
    steps = np.maximum(steps, _lost_steps(log, values))
    parts = _measured_rows(log, values, steps)
    cutoff = log.smoothing.cutoff_frequency
    if cutoff is not None and log.smoothing.enabled:
        for _, rows in parts:
            if len(rows) >= in_log.MIN_SPLINE_POINTS:
                check_cutoff(log.time[rows], cutoff)
    log_faults.tell_gap(log)
    if len(parts) == 1 and len(parts[0][1]) == len(values):
        return _replaced(log, values, steps)
    found, off, noises = np.empty((3, *values.shape)), np.zeros((3, *values.shape)), []
    for columns, rows in parts:
        few, noise = _replaced(*_measured(log, values, steps, columns, rows))
        found[..., columns] = log_faults.spread(log.time, rows, few[..., columns])
        off[..., columns] = log_faults.unseen(log.time, rows, few[2, :, columns])
        noises.append((columns, noise))
    joined, outside = _joined(found, noises, "L" in log.written), np.asarray(off.any(axis=(0, 2)))
    return found, _with_changes(log.time, found, joined, off, outside) if outside.any() else joined


def _measured_rows(log: Log, values: Array, steps: Array) -> list[tuple[slice, log_faults.Rows]]:
    """Columns of (n, 6) side by side with the rows at which a sensor measured them.

    Positions and angles may be of two sensors of which one is slower, or both.
    """
    rows, kinds = np.arange(len(values)), log.kinds()
    if not log.smoothing.enabled:
        return [(slice(0, 6), rows)]
    whole = log_faults.slower_sampling(log.time, values, steps)
    if whole is not None:
        _tell_slower(log, "", whole)
        rows = whole.rows
    own = (
        [log_faults.slower_sampling(log.time[rows], values[rows, part], steps[part]) for _, part in kinds]
        if len(kinds) > 1
        else []
    )
    # What was interpolated has bends of its own, which are no sensor's.
    if all(each is None for each in own) or (whole is not None and whole.kind != log_faults.HELD):
        return [(slice(0, 6), rows)]
    found = []
    for (name, part), each in zip(kinds, own, strict=True):
        if each is not None:
            each = each._replace(rows=rows[each.rows])
            _tell_slower(log, f"{log.kind(name)[0]} of ", each)
        found.append((part, rows if each is None else each.rows))
    return found


def _tell_slower(log: Log, of: str, slower: log_faults.Sampling) -> None:
    count, taken = len(slower.rows), "each taken for its first row"
    text = f"{of}{len(log.time)} rows are {slower.kind} between {count} measured ones, {taken}"
    log.warn(text)


def _measured(
    log: Log, values: Array, steps: Array, columns: slice, rows: log_faults.Rows
) -> tuple[Log, Array, Array]:
    """The log of some columns at the rows at which they were measured: others are 0."""
    written = {name: [x[rows] for x in vector] for name, vector in log.written.items()}
    few = dataclasses.replace(log, time=log.time[rows], rows=[log.rows[i] for i in rows], written=written)
    own, steps = np.zeros((len(rows), values.shape[1])), steps.copy()
    own[:, columns] = values[rows, columns]
    for name, part in log.kinds():
        if columns not in (part, slice(0, 6)):
            steps[part] = 0.0
        elif name in written:  # what is interpolated has more digits than what is measured
            steps[part] = np.maximum(steps[part], few.steps(name))
    return few, own, steps


def _joined(
    found: Array, noises: Sequence[tuple[slice, Uncertainty | None]], in_joints: bool
) -> Uncertainty | None:
    """Uncertainty of coordinates and rates, (3, n, 6), whose columns have each their own."""
    some = [(columns, noise) for columns, noise in noises if noise is not None]
    if not some:
        return None
    grid = functools.reduce(np.union1d, (noise.grid for _, noise in some))
    covariance, sigma = np.zeros((len(grid), 6, len(PAIRS))), np.zeros(6)
    for columns, noise in some:
        # Of the same columns some may be smoothed and others not: each noise is 0 in those of another.
        covariance[:, columns] += noise.covariances(grid)[:, columns]
        sigma[columns] += noise.sigma[columns]
    replaced = tuple(itertools.chain.from_iterable(noise.replaced for _, noise in some))
    return Uncertainty(found, grid, covariance, sigma, in_joints, replaced)


# Share of the usual step in time, rounded off, from which on accelerations tell.
_LOST = 1e-6
# Share of the steps that are not faster than the speed that counts.
_FAST = 0.9
# Noise of so many steps of rounding leaves none of its own patterns.
_DITHERED = 0.87
# Times that what is left is stated noise that is too small.
_TOO_SMALL = 2.0
# Share of the largest change of a second rate beyond which one counts.
_CHANGED = 0.02


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
    in_log.warn_of_stated(log, values, steps)
    in_log.warn_of_few(log, values)
    log_faults.tell_plateaus(log, values, steps)
    held = still_rows(log.time, values, steps)
    replaces = log.smoothing.enabled or log.smoothing.repair
    frozen = frozen_rows(log, values, steps, held)
    if frozen.any():
        tell_frozen(log, frozen, bridged=replaces)
    if frozen.any() and replaces:
        rows = np.flatnonzero(~frozen)
        found, noise = _replaced(*_measured(log, values, steps, slice(0, 6), rows))
        return _bridged(log, rows, found, noise)
    if held.any():
        tell_still(log, held)
    shown = in_log.shown_level(log, values, steps, held, tell=True)
    level = in_log.chosen_level(log, shown)
    # Neither a cut-off nor a statement makes rows wrong that are within the scatter of all.
    sigma = np.maximum(level.of_samples(), shown.of_samples())
    bad = log_faults.faults(log.time, values, sigma)
    if bad:
        log_faults.tell_faults(log, bad)
    if not bad or not replaces:
        return _curve(log, values, steps, level, held)
    log_faults.tell_no_repair(log, values - log_faults.offsets(bad, values.shape), bad)
    return _without(log, values, steps, bad, held, level)


def _without(
    log: Log, values: Array, steps: Array, bad: Sequence[log_faults.Fault], held: Flags, level: Level
) -> tuple[Array, Uncertainty | None]:
    """Return ``rates_of`` rows without faults: single rows are bridged, steps are taken away.

    Only the change by steps is a standard deviation: bridged rows have no effect, however far they are off.
    """
    stepped = [fault for fault in bad if fault.end is None]
    off = np.zeros(len(values), dtype=bool)
    for fault in bad:
        if fault.end is not None:
            off[fault.first : fault.end] = True
    rows, good = np.flatnonzero(~off), values - log_faults.offsets(stepped, values.shape)
    few, _, own_steps = _measured(log, good, steps, slice(0, 6), rows)
    own = in_log.chosen_level(few, in_log.shown_level(few, good[rows], own_steps, held[rows]))
    found, noise = _curve(few, good[rows], own_steps, own, held[rows])
    if stepped:
        level = _at_rows(level, rows)
        changed = found - _derivatives(few, values[rows], level, tell=False)[0]
        near = _near(changed)
        noise = _with_changes(few.time, found, noise, changed, near)
        noise = noise._replace(replaced=_replaced_rows(log, few.time, stepped, near))
    return _bridged(log, rows, found, noise)


def _at_rows(level: Level, rows: log_faults.Rows) -> Level:
    """Return the level of the noise at some of the rows."""
    return level if level.scale is None else level._replace(scale=level.scale[rows])


def _bridged(
    log: Log, rows: log_faults.Rows, few: Array, noise: Uncertainty | None
) -> tuple[Array, Uncertainty | None]:
    """Return coordinates and rates, (3, n, 6), from those at some rows, (3, m, 6), and their uncertainty."""
    gaps = (np.flatnonzero(np.diff(rows) > 1) + 1).tolist()
    names = [log_faults.rows_text(log, int(rows[i - 1]) + 1, int(rows[i])) for i in gaps]
    found = log_faults.spread(log.time, rows, few)
    off = log_faults.unseen(log.time, rows, few[2])
    if gaps:
        noise = _known(few, log.time[rows], noise)
        noise = in_gaps(noise._replace(coordinates=few), log.time[rows], gaps, names)
    if noise is not None:
        noise = noise._replace(coordinates=found)
    outside = np.asarray(off.any(axis=(0, 2)))
    return found, _with_changes(log.time, found, noise, off, outside) if outside.any() else noise


def _known(found: Array, time: Array, noise: Uncertainty | None) -> Uncertainty:
    """Return the uncertainty of coordinates and rates, (3, n, 6); None is none."""
    if noise is not None:
        return noise
    return Uncertainty(found, time[[0, -1]], np.zeros((2, 6, len(PAIRS))), np.zeros(6))


def _near(changed: Array) -> Flags:
    """Rows in which second rates of (3, n, c) change by a share of their largest change or more, (n,)."""
    size = np.abs(changed[2])
    return np.asarray((size > _CHANGED * size.max(axis=0)).any(axis=1))


def _curve(
    log: Log, values: Array, steps: Array, level: Level, held: Flags
) -> tuple[Array, Uncertainty | None]:
    """Coordinates and rates, (3, n, 6), and their uncertainty, also by what is left out that is no noise.

    Numbers that stand still are all off alike; lines may be motion.
    """
    found, noise = _derivatives(log, values, level)
    if log.smoothing.enabled and log.smoothing.cutoff_frequency is None and len(values) >= FEWEST:
        off = end_errors(log, found)
        if off is not None:
            noise = _with_changes(log.time, found, noise, off, _near(off))
    if noise is None or not noise.sigma.any():
        return found, noise
    if held.any():
        off = held_offsets(values, held, noise.sigma)
        changed = _derivatives(log, values + off, level, tell=False)[0] - found
        noise = _with_changes(log.time, found, noise, changed, _near(changed))
    if log.smoothing.cutoff_frequency is None:
        left = (values - found[0]) / (1.0 if level.scale is None else level.scale)
        # Rounded numbers of a periodic motion have lines of their own, and so has what noise stated too
        # small leaves.
        doubtful = np.sqrt(np.mean(left**2, axis=0)) > _TOO_SMALL * np.where(
            in_log.stated_noise(log) > 0.0, noise.sigma, np.inf
        )
        seen = np.where(doubtful | (noise.sigma < _DITHERED * steps), 0.0, noise.sigma)
        beside = lines(log.time, left, seen)
        if beside:
            tell_lines(log, beside)
            noise = noise._replace(covariance=noise.covariance + line_covariance(beside, 6))
    return found, noise


def _with_changes(
    time: Array, found: Array, noise: Uncertainty | None, changed: Array, near: Flags
) -> Uncertainty:
    """Uncertainty in which changes of coordinates and rates, (3, n, 6), count as a deviation, ``near``."""
    noise = _known(found, time, noise)
    rows = np.flatnonzero(np.convolve(near, np.ones(3), "same"))
    squares = np.stack([changed[i, rows] * changed[j, rows] for i, j in PAIRS], axis=-1)
    squares *= near[rows, None, None]
    grid = np.union1d(noise.grid, time[rows])
    changes = noise._replace(grid=time[rows], covariance=squares)
    covariance = noise.covariances(grid) + changes.covariances(grid)
    return noise._replace(grid=grid, covariance=covariance)


def _derivatives(
    log: Log, values: Array, level: Level, tell: bool = True
) -> tuple[Array, Uncertainty | None]:
    """``rates_of`` of numbers with a level of noise."""
    noisy = level.sigma > 0.0
    if level.scale is None and len(log.time) >= in_log.MIN_SPLINE_POINTS and not absent("scipy"):
        noisy = level.sigma > _least_noise(log, values)
    if log.smoothing.cutoff_frequency is not None:
        noisy[:] = True
    if len(log.time) < in_log.MIN_SPLINE_POINTS or not log.smoothing.enabled:
        noisy[:] = False
    found = np.empty((3, *values.shape))
    if not noisy.all():
        found[0][:, ~noisy] = values[:, ~noisy]
        since = elapsed(log.time)
        # What is before a long gap says nothing of what is after it, and a spline through both overshoots.
        for first, end in itertools.pairwise([0, *breaks(since), len(since)]):
            spline = _spline(since[first:end], values[first:end, ~noisy], log.source)
            # In parts, since a spline's values come in arrays of their own.
            for part in (slice(i, min(i + _PART, end)) for i in range(first, end, _PART)):
                for order in (1, 2):
                    found[order, part][:, ~noisy] = spline(since[part], order)
    fine = np.where(noisy | (not log.smoothing.enabled), 0.0, level.sigma)
    noises: list[tuple[slice, Uncertainty | None]] = [
        (slice(i, i + 1), _of_spline(log, found, np.where(np.arange(6) == i, fine, 0.0)))
        for i in np.flatnonzero(fine)
    ]
    # Columns of the same scale share their matrices.
    for part in (slice(0, 6),) if level.scale is None else [part for _, part in log.kinds()]:
        own = np.flatnonzero(noisy[part]) + part.start
        if not own.size:
            continue
        chosen = Level(level.sigma[own], level.least[own])
        known = chosen if chosen.sigma.all() else None
        scale = None if level.scale is None else level.scale[:, own[0]]
        smooth = smoothed(log.time, values[:, own], known, log.smoothing.cutoff_frequency, scale)
        found[..., own] = [smooth.values, smooth.derivatives, smooth.second_derivatives]
        covariance, sigma = np.zeros((len(smooth.covariance_time), 6, 6)), np.zeros(6)
        covariance[:, own], sigma[own] = smooth.covariance, smooth.noise_std
        noises.append(
            (part, Uncertainty(found, smooth.covariance_time, covariance, sigma, "L" in log.written))
        )
    noise = _joined(found, noises, "L" in log.written)
    if noise is None:
        return found, None
    if tell and log.smoothing.cutoff_frequency is None:
        left = values - found[0]
        _warn_of_jumps(log, left if level.scale is None else left / level.scale, noise)
    elif tell:
        _warn_of_cutoff(log, values, found)
    if tell and noisy.any() and _matters(noise) and not in_log.too_few(log):
        more = _CORRELATED.format(level.correlation) if level.correlation > 1.0 else ""
        log.warn(f"{noise_text(noise)}: smoothed{more}")
    return found, noise


# Deviations of rates and second rates of a spline through rows of noise 1, 1 apart: at an end, and inside.
_AT_END, _INSIDE = (11.6, 42.0), (1.38, 4.8)
_INSIDE_FROM = 4


def _least_noise(log: Log, values: Array) -> Array:
    """Noise, (6,), that makes a small share of the largest accelerations of a spline through the rows.

    A smooth curve would follow jumps of the accelerations worse.
    """
    steps = np.diff(log.time)[:, None]
    least, step = np.empty(6), float(np.median(steps))
    before, after = steps[:-1], steps[1:]
    for _, part in log.kinds():
        change = np.diff(values[:, part], axis=0)
        # Twice how far a row is off the line of its neighbors, as even rows have it: a gap bends no more.
        bent = 2.0 * np.abs(change[1:] * before - change[:-1] * after) / (before + after)
        bend = float(np.max(bent * step**2 / np.maximum(before * after, step**2), initial=0.0))
        least[part] = _LITTLE / _AT_END[1] * max(bend, _GRAVITY * step**2)
    return least


def _of_spline(log: Log, found: Array, sigma: Array) -> Uncertainty:
    """Uncertainty of coordinates and rates, (3, n, 6), of a spline through rows with noise, (6,)."""
    step, edges = float(np.median(np.diff(log.time))), [0, *breaks(elapsed(log.time)), len(log.time)]
    rows, kinds = [], []
    for first, end in itertools.pairwise(edges):
        last = end - 1
        rows += [first, min(first + _INSIDE_FROM, last), max(last - _INSIDE_FROM, first), last]
        kinds += [_AT_END, _INSIDE, _INSIDE, _AT_END]
    grid, covariance = log.time[rows], np.zeros((len(rows), 6, len(PAIRS)))
    for row, (rate, second) in zip(covariance, kinds, strict=True):
        row[:, [0, 2, 5]] = (sigma[:, None] * [1.0, rate / step, second / step**2]) ** 2
    return Uncertainty(found, grid, covariance, sigma, "L" in log.written)


# A smooth curve leaves what jumps by so many deviations of the noise, in few of the rows.
_TORN, _FEW = 6.0, 0.05


def _warn_of_jumps(log: Log, left: Array, noise: Uncertainty) -> None:
    """Warn where accelerations jump by what the curve leaves, (n, 6)."""
    off = np.abs(left) / np.where(noise.sigma > 0.0, noise.sigma, np.inf)
    if not 0.0 < np.mean(off.max(axis=1) > _TORN) <= _FEW:
        return
    row, column = (int(i) for i in np.unravel_index(np.argmax(off), off.shape))
    when = time_text(log.time[row], float(np.median(np.diff(log.time))))
    name, unit = log_faults.column_of(log, column)
    at_row = f"line {log.rows[row]}: {name} by {left[row, column]:.2g} {unit}"
    text = (
        f"near {when} s a smooth motion is {off[row, column]:.2g} deviations of the noise off ({at_row}): do "
        "accelerations jump, or are rows wrong? Where they jump forces overshoot, as their deviations say"
    )
    log.warn(text)


# A cut-off removes motion where what it removes is so many times what changes from row to row, and would be
# this share of usual accelerations at the cut-off.
_NOT_NOISE, _MISSED = 3.0, 0.01


def _warn_of_cutoff(log: Log, values: Array, found: Array) -> None:
    """Warn of a cut-off below frequencies of the motion; found: coordinates and rates, (3, n, 6)."""
    assert log.smoothing.cutoff_frequency is not None
    removed = values - found[0]
    missed = np.sqrt(np.mean(removed**2, axis=0))
    # White noise changes by the root of 2 of its deviation.
    slow = missed > _NOT_NOISE * np.sqrt(np.mean(np.diff(removed, axis=0) ** 2, axis=0) / 2.0)
    parts = []
    for name, part in log.kinds():
        # Not the largest: at the ends it is that of what is lost.
        usual = float(np.quantile(np.abs(found[2][:, part]), 0.9))
        least = _MISSED * usual / (2.0 * math.pi * log.smoothing.cutoff_frequency) ** 2
        most = float(np.max(missed[part] * slow[part]))
        if most > least:
            what, in_unit = log.kind(name)
            parts.append(f"of {what} of {in_unit(most)}")
    if parts:
        text = f"the cut-off of {log.smoothing.cutoff_frequency:g} Hz removes changes {' and '.join(parts)}"
        log.warn(f"{text}: motion, not noise, and the forces lack it")


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


def as_given(log: Log, found: Array, steps: Sequence[Array]) -> Uncertainty | None:
    """Uncertainty of coordinates and rates, (3, n, 6), all of them measured and rounded to steps, (3, 6)."""
    if log.smoothing.cutoff_frequency is not None:
        text = "the file has rates, which are taken as they are: the cut-off changes nothing"
        log.warn(text)
    known = in_log.stated_noise(log)
    in_log.warn_of_stated(log, found[0], steps[0])
    sigma = np.array(steps) / math.sqrt(12.0)
    sigma[0] = np.where(known > 0.0, known, sigma[0])
    if not sigma.any() or not log.smoothing.enabled:
        return None
    covariance = np.zeros((2, 6, 6))
    covariance[:, :, [0, 2, 5]] = sigma.T**2
    return Uncertainty(found, log.time[[0, -1]], covariance, sigma[0])


def _replaced_rows(
    log: Log, time: Array, steps: Sequence[log_faults.Fault], near: Flags
) -> tuple[Replaced, ...]:
    """Return spans of times, (m,), at which steps of the log count, with the nearest steps of each."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], near, [False]]).astype(np.int8)))
    rows = list(dict.fromkeys(fault.first for fault in steps))
    first = np.searchsorted(time, log.time[rows])
    names = [f"the step at line {log.rows[start]}" for start in rows]
    found, last = [], len(time) - 1
    for a, b in edges.reshape(-1, 2):
        apart = np.maximum(np.maximum(a - first, first - b + 1), 0)
        nearest = tuple(name for name, away in zip(names, apart, strict=True) if away == apart.min())
        ends = float(time[max(a - 1, 0)]), float(time[min(b, last)])
        found.append(Replaced(*ends, nearest))
    return tuple(found)


def _spline(since: Array, values: Array, source: str) -> Callable[..., Array]:
    if len(since) < in_log.MIN_SPLINE_POINTS:
        raise ValueError(
            f"{source}: expected at least {in_log.MIN_SPLINE_POINTS} rows to fit a spline, got {len(since)}; "
            "add rows, or columns with velocities and accelerations"
        )
    with needed_for(*SPLINE):
        from scipy.interpolate import make_interp_spline
    try:
        found: Callable[..., Array] = make_interp_spline(
            since, values, k=DEGREE if len(since) > DEGREE else 3
        )
        return found
    except (ValueError, np.linalg.LinAlgError) as error:
        raise ValueError(f"{source}: no spline fits these times: {' '.join(str(error).split())}") from None
