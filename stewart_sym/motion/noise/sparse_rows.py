"""Rows so few that accelerations at the ends of a log are a guess, as splines without the first rows show."""

import numpy as np

from ...io.array_types import Array
from ...io.extras import absent
from ...io.instants import elapsed, time_text
from ..trajectory import Log

DEGREE = 5
"""Of splines through rows."""
FEWEST = 12
"""Rows of the shortest log whose ends are compared."""
# Rows at an end that it is wrong in, and of the splines that begin farther inside.
_END, _ROWS = 12, 40
# Accelerations that are off by this share of the largest, gravity's at least, are named.
_OFF, _GRAVITY = 0.02, 9.81
# Of values, rates and second rates as time runs backward.
_BACKWARD = np.array([1.0, -1.0, 1.0])[:, None, None]


def end_errors(log: Log, found: Array) -> Array | None:
    """How far rates of rows at the ends may be off, (3, n, 6); None where that does not matter.

    found: coordinates and rates, (3, n, 6). A spline that begins some rows later is off there as this one is
    at its first row, whatever the phase of the motion, while this one is right. None without SciPy, too.
    """
    if absent("scipy"):
        return None
    since, errors = elapsed(log.time), np.zeros_like(found)
    end = min(_END, len(since) // 3)
    errors[1:, :end] = _first_rows(since, found, end)
    errors[1:, -end:] = _first_rows(-since[::-1], _BACKWARD * found[:, ::-1], end)[:, ::-1]
    said = (_text(log, found[2, :, part], errors[2, :, part], name) for name, part in log.kinds())
    told = [text for text in said if text]
    if not told:
        return None
    log.warn(
        f"rows are too far apart for accelerations at the log's ends, off by up to {' and '.join(told)}, "
        "as deviations say; what helps: rows more often, or some at rest before and after",
        8,
    )
    return errors


def _first_rows(since: Array, found: Array, end: int) -> Array:
    """``end_errors`` of the first rows, (2, end, 6), which fall from row to row."""
    from scipy.interpolate import make_interp_spline

    off = np.full((end, 2, end, found.shape[2]), np.nan)
    for i in range(end):
        rows = slice(i + 2, i + 2 + _ROWS)
        spline = make_interp_spline(since[rows], found[0, rows], k=DEGREE)
        for order in (1, 2):
            inside = found[order, rows][:end]
            off[i, order - 1, : len(inside)] = np.abs(spline(since[rows][:end], order) - inside)
    # The median, since accelerations that jump inside are near the beginning of some of the splines.
    usual = np.nanmedian(off, axis=0)
    return np.asarray(np.maximum.accumulate(usual[:, ::-1], axis=1)[:, ::-1])


def _text(log: Log, seconds: Array, errors: Array, name: str) -> str:
    """Where and by how much accelerations, (n, c), are in doubt; nothing if they are not."""
    most = errors.max(axis=1)
    row = int(np.argmax(most))
    if most[row] <= _OFF * max(float(np.abs(seconds).max()), _GRAVITY):
        return ""
    when = time_text(log.time[row], float(np.median(np.diff(log.time))))
    what, in_unit = log.kind(name)
    return f"{in_unit(float(most[row]))}/s^2 in {what} at {when} s"
