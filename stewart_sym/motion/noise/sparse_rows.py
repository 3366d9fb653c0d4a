"""Rows so few that accelerations at the ends of a log, or beside long gaps, are a guess: splines without the
first rows show it.
"""

import itertools

import numpy as np

from ...io.array_types import Array
from ..interpolation import breaks
from ..sample_times import elapsed, time_text
from ..trajectory import Log

DEGREE = 5
"""Of splines through rows."""
FEWEST = 12
"""Rows of the shortest log whose ends are compared."""
# Rows at an end that it is wrong in, and of the splines there, the first of which begins at the first row.
_END, _ROWS = 8, 20
# Accelerations that are off by this share of the largest, gravity's at least, are named.
_OFF, _GRAVITY = 0.02, 9.81
# Of values, rates and second rates as time runs backward.
_BACKWARD = np.array([1.0, -1.0, 1.0])[:, None, None]


def end_errors(log: Log, found: Array) -> Array | None:
    """How far rates of rows at the ends may be off, (3, n, 6); None where that does not matter.

    found: coordinates and rates, (3, n, 6). A spline that begins some rows later is off there as one through
    all rows is at its first, whatever the phase of the motion, while that one is right there.
    """
    since, errors = elapsed(log.time), np.zeros_like(found)
    gaps = breaks(since)
    for first, last in itertools.pairwise([0, *gaps, len(since)]):
        part, end = slice(first, last), min(_END, (last - first) // 3)
        if last - first < FEWEST:
            continue
        errors[1:, first : first + end] = _first_rows(since[part], found[:, part], end)
        backward = _first_rows(-since[part][::-1], _BACKWARD * found[:, part][:, ::-1], end)
        errors[1:, last - end : last] = backward[:, ::-1]
    said = (_text(log, found[2, :, part], errors[2, :, part], name) for name, part in log.kinds())
    told = [text for text in said if text]
    if not told:
        return None
    where = "the ends of the log" + (" and at its gaps" if gaps else "")
    log.warn(
        f"accelerations at {where}: errors of up to {' and '.join(told)}, included in the standard "
        "deviations (rows too far apart, or jumps); add rows, especially at rest before and after the motion",
    )
    return errors


def _first_rows(since: Array, found: Array, end: int) -> Array:
    """``end_errors`` of the first rows, (2, end, 6), which fall from row to row."""
    off = np.full((end + 1, 2, end, found.shape[2]), np.nan)
    for i in range(end + 1):
        start = i + (i > 0)
        rows = slice(start, start + _ROWS)
        rates = _rates(since[rows], found[0, rows])[:, :end]
        off[i, :, : rates.shape[1]] = np.abs(rates - found[1:, rows][:, :end])
    # The median, since accelerations that jump inside are near the beginning of some of the splines; and how
    # far the curve is from the spline through its own values.
    usual = np.maximum(np.nanmedian(off[1:], axis=0), off[0])
    return np.asarray(np.maximum.accumulate(usual[:, ::-1], axis=1)[:, ::-1])


def _rates(since: Array, values: Array) -> Array:
    """Rates and second rates, (2, n, c), of the spline through values, (n, c), whose ends are not knots."""
    step = (since[-1] - since[0]) / (len(since) - 1)
    x = (since - since[0]) / step
    knots = x[3:-3]
    powers = np.arange(DEGREE + 1)
    steep = np.maximum(x[:, None] - knots, 0.0)

    def columns(rate: int) -> Array:
        factor = np.prod([np.ones(DEGREE + 1), *(powers - k for k in range(rate))], axis=0)
        plain = factor * x[:, None] ** np.maximum(powers - rate, 0)
        return np.hstack([plain, factor[-1] * steep ** (DEGREE - rate)])

    c = np.linalg.solve(columns(0), values)
    return np.stack([columns(rate) @ c / step**rate for rate in (1, 2)])


def _text(log: Log, seconds: Array, errors: Array, name: str) -> str:
    """Where and by how much accelerations, (n, c), are in doubt; nothing if they are not."""
    most = errors.max(axis=1)
    row = int(np.argmax(most))
    if most[row] <= _OFF * max(float(np.abs(seconds).max()), _GRAVITY):
        return ""
    when = time_text(log.time[row], float(np.median(np.diff(log.time))))
    what, in_unit = log.kind(name)
    return f"{in_unit(float(most[row]))}/s^2 in {what} at {when} s"
