"""Steps of leg lengths from sample to sample: their times, accelerations, and those that no motion makes."""

import numpy as np

from ..io.array_types import Array
from ..io.instants import elapsed

# A jump exceeds this many times what accelerations in its surroundings move in a step.
_JUMP = 10.0
# Samples on either side of a jump that tell these accelerations.
_SURROUNDINGS = 12
# Accelerations between samples may exceed those at the samples by this factor.
_BETWEEN = 4.0
# Share of the steps that follow their rates as well as rounding or noise lets all of them.
_MOST = 0.9
# A step in time follows from lengths where rates exceed this share of their median.
_MOVING = 0.01


def times_from_rates(L: Array, L_dot: Array) -> Array | None:
    """Return times from 0, s, (n,), at which lengths, (n, 6), change as their rates say; None at rest.

    The trapezoidal rule tells each step; where the legs all but rest, it is the median of the others.
    """
    change, mean = np.diff(L, axis=0), 0.5 * (L_dot[1:] + L_dot[:-1])
    square = np.sum(mean**2, axis=-1)
    if not np.any(square):
        return None
    own = np.sum(change * mean, axis=-1)
    moving = square > _MOVING**2 * np.median(square)
    usual = float(np.median(own[moving] / square[moving]))
    weight = _MOVING**2 * float(np.median(square[moving]))
    step = (own + weight * usual) / (square + weight)
    if usual <= 0.0:
        return None
    return np.concatenate([[0.0], np.cumsum(np.where(step > 0.0, step, usual))])


def accelerations(time: Array, L: Array, L_dot: Array) -> Array:
    """Return L_ddot, m/s^2, (n, 6), of the polynomials of degree 5 through each sample and its neighbours.

    At the first and the last sample the polynomial is of degree 3.
    """
    h = np.diff(elapsed(time))[:, None]
    change, first, last = np.diff(L, axis=0) / h, L_dot[:-1], L_dot[1:]
    found = np.empty_like(L)
    found[:-1] = (6.0 * change - 4.0 * first - 2.0 * last) / h
    found[-1] = (-6.0 * change[-1] + 2.0 * first[-1] + 4.0 * last[-1]) / h[-1]
    if len(L) < 3:
        return found
    power = np.arange(2, 6)
    sides = []
    for step, other in ((-h[:-1], slice(None, -2)), (h[1:], slice(2, None))):
        # Offsets are measured by the step after the sample, which keeps the equations' terms alike.
        x, unit = step / h[1:], h[1:]
        value = L[other] - L[1:-1] - step * L_dot[1:-1]
        sides += [(x**power, value), (power * x ** (power - 1), (L_dot[other] - L_dot[1:-1]) * unit)]
    matrix, wanted = (np.stack([side[i] for side in sides], axis=1) for i in (0, 1))
    found[1:-1] = 2.0 * np.linalg.solve(matrix, wanted)[:, 0] / h[1:] ** 2
    return found


def jump(L: Array) -> int | None:
    """Return the sample at which lengths, (n, 6), jump as no motion sampled often enough does, or None.

    Second differences around a jump change sign and are ten times as large as all in their surroundings.
    """
    second = np.diff(L, n=2, axis=0)
    if len(second) < 4:
        return None
    # Entry i belongs to sample i + 1; a jump from sample i + 1 to i + 2 shows in entries i and i + 1.
    turned = second[:-1] * second[1:] < 0.0
    size = np.max(np.where(turned, np.minimum(np.abs(second[:-1]), np.abs(second[1:])), 0.0), axis=-1)
    steps = np.abs(np.diff(L, axis=0))
    resolution = float(np.min(steps[steps > 0.0], initial=np.inf))
    floor = 4.0 * resolution if np.isfinite(resolution) else 0.0
    largest = np.max(np.abs(second), axis=-1)
    for i in np.flatnonzero(size > floor):
        low, high = max(i - _SURROUNDINGS, 0), i + 2 + _SURROUNDINGS
        around = np.concatenate([largest[low : max(i - 1, 0)], largest[i + 3 : high]])
        if around.size and size[i] > _JUMP * np.max(around):
            return int(i + 2)
    return None


def step_beyond_rates(time: Array, L: Array, L_dot: Array, L_ddot: Array) -> int | None:
    """Return the first sample, or None, that the rates do not reach from the one before.

    With accelerations of at most A between samples, a step differs from that of the mean rate by h^2 A / 4.
    """
    h = np.diff(elapsed(time))[:, None]
    off = np.max(np.abs(np.diff(L, axis=0) - 0.5 * h * (L_dot[1:] + L_dot[:-1])), axis=-1)
    most = max(float(np.max(np.abs(L_ddot))), float(np.max(np.abs(np.diff(L_dot, axis=0) / h))))
    noise = min(float(np.quantile(off, _MOST)), float(np.max(np.abs(np.diff(L, axis=0)))))
    bad = np.flatnonzero(off > _BETWEEN * (0.25 * h[:, 0] ** 2 * most) + _JUMP * noise)
    return int(bad[0]) + 1 if bad.size else None
