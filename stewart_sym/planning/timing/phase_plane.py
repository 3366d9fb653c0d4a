"""Fastest s' along a path by a backward and a forward pass in the phase plane of s and s'.

In a cell of the grid s'' is linear in s, so that x = s'^2 is quadratic: dx/ds = 2 s''. At each node s'' is
between the largest lower and the smallest upper bound

    s'' >= (-limit - e - b x - d sqrt(x)) / a,    s'' <= (limit - e - b x - d sqrt(x)) / a    (a > 0).

Every step is therefore the first root of quadratic equations in sqrt(x). The backward pass computes the
largest x from which the robot can stop at the end. The forward pass computes the largest x that it reaches
below these values. Without viscous friction the feasible x at a node are an interval; with viscous friction
there may be further intervals, which are not used. A bound may have two forms, one of which must be
satisfied, and may jump at a node.
"""

import itertools
import math
from typing import NamedTuple

import numpy as np

from ...io.array_types import Array, Indices
from .motor_terms import Rows

# Relative effect of s'' on a quantity, compared with its largest one, below which it does not bound s''.
_NO_EFFECT = 1e-9
# Number of nodes in a block, which limits the memory for pairs of bounds.
_BLOCK = 64
_SAMPLES = 65
_ROUNDS = 4


class Bounds(NamedTuple):
    """Bounds at n nodes: s'' >= low, s'' <= high, and x <= cap, shape (n,).

    Attributes
    ----------
    low, high : ndarray, shape (n + j, 3, 2, m)
        Coefficients of (1, x, sqrt(x)) for m quantities in two forms: after each node, followed by the j
        bounds before nodes at which they jump.
    before : ndarray of int, shape (n,)
        Index of the bounds before each node.
    """

    low: Array
    high: Array
    cap: Array
    before: Indices


class PhasePath(NamedTuple):
    """Path in the phase plane at n nodes s: x = s'^2, and s'' at start and end of each cell, shape (n - 1,).

    Attributes
    ----------
    most : ndarray, shape (n,)
        Largest x at which some s'' is feasible.
    stops : ndarray, shape (n,)
        Largest x from which rest at the end can be reached.
    """

    s: Array
    x: Array
    first: Array
    last: Array
    most: Array
    stops: Array


def bounds_of(rows: Rows, caps: Array, twice: Indices) -> Bounds:
    """Compute the bounds of s'' from rows, and of x from rows and caps, shape (n + j,).

    ``twice`` contains the j nodes at which bounds jump.
    """
    effect = np.abs(rows.a).max(axis=-1)
    least_a = _NO_EFFECT * effect.max(axis=0)
    free = effect <= least_a
    # A single form without effect, for example of a leg without motor load, becomes a distant bound.
    slight = np.abs(rows.a) < least_a[..., None]
    a = np.where(slight, np.copysign(least_a[..., None], rows.a), rows.a)
    a = np.where(free[..., None], 1.0, a)
    rest = -np.stack([rows.e, rows.b, rows.d], axis=-1) / a[..., None]
    low, high = rest.copy(), rest.copy()
    least, most = rows.low[..., None], rows.high[..., None]
    low[..., 0] += np.where(a > 0.0, least, most) / a
    high[..., 0] += np.where(a > 0.0, most, least) / a
    low[free], high[free] = (-np.inf, 0.0, 0.0), (np.inf, 0.0, 0.0)
    # Quantities that do not depend on s'' bound x directly.
    above = first_root(rows.e - most, rows.b, rows.d).max(axis=-1)
    below = first_root(least - rows.e, -rows.b, -rows.d).max(axis=-1)
    alone = np.where(free, np.minimum(above, below), np.inf).min(axis=-1)
    low, high = (_bounding(side) for side in (low, high))
    blocks = [slice(i, i + _BLOCK) for i in range(0, len(caps), _BLOCK)]
    together = np.concatenate([_first_contradiction(low[block], high[block]) for block in blocks])
    cap = np.minimum(caps, np.minimum(alone, together) ** 2)
    n = len(cap) - len(twice)
    before = np.arange(n)
    before[twice] = np.arange(n, len(cap))
    low, high = (np.ascontiguousarray(side.transpose(0, 3, 2, 1)) for side in (low, high))
    return Bounds(low, high, np.minimum(cap[:n], cap[before]), before)


def _first_contradiction(low: Array, high: Array) -> Array:
    """Return the smallest z for which no s'' satisfies all lower and upper bounds, shape (n,)."""
    first = np.full(len(low), np.inf)
    for below, above in itertools.product(_by_forms(low), _by_forms(high)):
        gap = below[:, :, None, :, None] - above[:, None, :, None, :]
        roots = first_root(gap[..., 0], gap[..., 1], gap[..., 2]).max(axis=(-2, -1))
        first = np.minimum(first, roots.min(axis=(1, 2), initial=np.inf))
    return first


def _by_forms(side: Array) -> tuple[Array, Array]:
    """Split bounds into the quantities whose two forms are equal, reduced to one form, and the others."""
    same = (side[..., 0, :] == side[..., 1, :]).all(axis=(0, 2))
    return side[:, same, :1], side[:, ~same]


def _bounding(side: Array) -> Array:
    """Remove the quantities that never bound s'', but keep at least one."""
    kept = np.isfinite(side[..., 0]).any(axis=(0, 2))
    return side[:, kept] if kept.any() else side[:, :1]


def first_root(c_0: Array, c_1: Array, c_2: Array) -> Array:
    """Return the smallest z > 0 with c_0 + c_1 z^2 + c_2 z = 0 for c_0 < 0, or inf without one."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        square = c_2 * c_2 - 4.0 * c_1 * c_0
        below = c_2 + np.sqrt(np.where(square >= 0.0, square, np.nan))
        return np.where((below > 0.0) & (c_0 > -np.inf), -2.0 * c_0 / below, np.inf)


def fastest(s: Array, bounds: Bounds) -> PhasePath:
    """Compute the fastest s' from rest to rest."""
    step = np.diff(s)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        stops = _stops(step, bounds)
        x = _starts(step, bounds, stops)
        first, last = _seconds(step, bounds, x)
    return PhasePath(s, x, first, last, bounds.cap, stops)


def _stops(step: Array, bounds: Bounds) -> Array:
    """Compute the largest x at each node from which rest at the end can be reached."""
    stops = np.zeros(len(bounds.cap))
    ways = _ways(step, bounds.low[: len(step)])
    for i in range(len(step) - 1, -1, -1):
        most = _most_left(float(step[i]), bounds.low[bounds.before[i + 1]], float(stops[i + 1]))[1]
        stops[i] = min(bounds.cap[i], _first_of_all(ways[i], most))
    return stops


def _ways(step: Array, side: Array) -> Array:
    """Return c, 4 a, b, b^2 - 4 a c of x + step times bounds = c + a x + b sqrt(x), shape (n, 4, 2, m)."""
    c, a, b = np.moveaxis(side * step[:, None, None, None], 1, 0)
    a = 4.0 * (1.0 + a)
    return np.stack([c, a, b, np.where(np.isfinite(c), b * b - a * c, np.nan)], axis=1)


def _first_of_all(way: Array, value: float) -> float:
    """Return the smallest x at which any quantity equals a value; the larger one of its two forms counts."""
    c, a, b, square = way
    below = b + np.sqrt(square + a * value)
    one, other = np.where(below > 0.0, 2.0 * (value - c) / below, np.inf)
    return float(min(np.maximum(one, other).tolist())) ** 2


def _most_left(h: float, low: Array, top: float) -> tuple[float, float]:
    """Return the x in [0, top] that maximizes x - h low(x), and the maximum."""
    at_top, near = top - h * _tightest(low, top), top * (1.0 - 2e-6)
    if at_top >= near - h * _tightest(low, near):
        return top, at_top
    a, b = 0.0, math.sqrt(top)
    for _ in range(_ROUNDS):
        tried = np.linspace(a, b, _SAMPLES)
        found = tried * tried - h * lowest(low, tried * tried)
        k = int(np.argmax(found))
        a, b = tried[max(k - 1, 0)], tried[min(k + 1, _SAMPLES - 1)]
    return float(tried[k] ** 2), float(found[k])


def _starts(step: Array, bounds: Bounds, stops: Array) -> Array:
    """Compute the largest x at each node that is reachable from rest and from which the robot can stop."""
    x = np.zeros(len(stops))
    low, rising, ends = bounds.low, -bounds.high, bounds.before[1:].tolist()
    ways, now, least = _ways(step, rising[ends]), 0.0, _tightest(low[0], 0.0)
    for i, (h, end) in enumerate(zip(step.tolist(), ends, strict=True)):
        top = min(float(stops[i + 1]), _first_of_all(ways[i], now - h * _tightest(rising[i], now)))
        needed, now, least = now + h * least, top, _tightest(low[end], top)
        if now - h * least < needed:
            now = _largest(h, low[end], top, needed)
        if now < top or end != i + 1:
            least = _tightest(low[i + 1], now)
        x[i + 1] = now
    return x


def _tightest(side: Array, x: float) -> float:
    """Return ``lowest`` at one node for a number x."""
    c, a, b = side
    one, other = c + a * x + b * math.sqrt(x)
    return float(max(np.minimum(one, other).tolist()))


def _largest(h: float, low: Array, top: float, needed: float) -> float:
    """Return the largest x <= top from which the step back to the previous node is not too steep."""
    c, a, b = h * low
    c, a = c + needed, 1.0 - a
    twice = b + np.copysign(np.sqrt(b * b + 4.0 * a * c), b)
    roots = np.stack([0.5 * twice / a, -2.0 * c / twice])
    end = math.sqrt(top)
    z = np.concatenate([[0.0], np.sort(roots[(roots > 0.0) & (roots < end)]), [end]])
    middle = (0.5 * (z[1:] + z[:-1])) ** 2
    kept = np.flatnonzero(middle - h * lowest(low, middle) >= needed)
    return float(z[kept[-1] + 1] ** 2) if len(kept) else _most_left(h, low, top)[0]


def lowest(low: Array, x: Array | float) -> Array:
    """Evaluate lower bounds of s'', shape (..., 3, 2, m), at x: smaller form, largest of all bounds."""
    return np.asarray(_values(low, x).min(axis=-2).max(axis=-1))


def highest(high: Array, x: Array | float) -> Array:
    """Evaluate upper bounds of s'' at x: the larger form, the smallest of all bounds."""
    return np.asarray(_values(high, x).max(axis=-2).min(axis=-1))


def _values(side: Array, x: Array | float) -> Array:
    """Evaluate bounds at x."""
    at = np.asarray(x)[..., None, None]
    return np.asarray(side[..., 0, :, :] + side[..., 1, :, :] * at + side[..., 2, :, :] * np.sqrt(at))


def _seconds(step: Array, bounds: Bounds, x: Array) -> tuple[Array, Array]:
    """Compute s'' at start and end of each cell, at the same relative position between both bounds.

    If s'' is unbounded at one of the nodes, the two values are as close as the bounds of the other node
    permit.
    """
    start, end = slice(len(x) - 1), bounds.before[1:]
    low = lowest(bounds.low[start], x[:-1]), lowest(bounds.low[end], x[1:])
    high = highest(bounds.high[start], x[:-1]), highest(bounds.high[end], x[1:])
    total = np.diff(x) / step
    width = high[0] - low[0] + high[1] - low[1]
    share = (total - low[0] - low[1]) / np.where(width > 0.0, width, 1.0)
    same = low[0] + np.where(width > 0.0, share, 0.5) * (high[0] - low[0])
    near = np.clip(0.5 * total, np.maximum(low[0], total - high[1]), np.minimum(high[0], total - low[1]))
    first = np.where(np.isfinite(width), same, near)
    return first, total - first


# Parameter over time. In each cell s'' is linear in s, so s, s', and s'' are sums of exponentials of time.


class Place(NamedTuple):
    """Values of s, s', and s'', shape (n,) each."""

    s: Array
    rate: Array
    second: Array


class Ease(NamedTuple):
    """Polynomial s(x) from start to end, x from 0 to 1, whose first ``rests`` derivatives are 0 at both ends.

    For a motion from rest the rate x' is positive everywhere. With two zero derivatives s'' also starts at 0.
    """

    start: float
    end: float
    rests: int

    def __call__(self, x: Array, rate: Array, second: Array) -> Place:
        """Compute s, s', and s'' from x, x', and x''."""
        way = self.end - self.start
        if self.rests == 1:
            share, by, twice = x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x), 6.0 - 12.0 * x
        else:
            share = x**3 * (10.0 - 15.0 * x + 6.0 * x * x)
            by, twice = 30.0 * (x * (1.0 - x)) ** 2, 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x)
        s = np.clip(self.start + way * share, min(self.start, self.end), max(self.start, self.end))
        return Place(s, way * by * rate, way * (twice * rate**2 + by * second))


class Profile(NamedTuple):
    """Path parameter over time, with the times of the nodes (s), shape (n,), from 0.

    Attributes
    ----------
    ease : Ease, optional
        Parameter as a function of the parameter of the phase plane; None if they are equal.
    """

    phase: PhasePath
    times: Array
    ease: Ease | None = None

    @classmethod
    def of(cls, phase: PhasePath, ease: Ease | None = None) -> "Profile":
        """Create the profile of a path in the phase plane."""
        return cls(phase, np.concatenate([[0.0], np.cumsum(durations(phase))]), ease)

    @property
    def nodes(self) -> Place:
        """Values of s, s', and s'' at the nodes."""
        return self._eased(self.phase.s, np.sqrt(self.phase.x), self.second)

    def slowed(self, share: float) -> "Profile":
        """Return the profile with all rates multiplied by a factor."""
        phase = self.phase
        squared = {name: share**2 * getattr(phase, name) for name in ("x", "first", "last")}
        return Profile.of(phase._replace(**squared), self.ease)

    def _eased(self, x: Array, rate: Array, second: Array) -> Place:
        """Apply the ease."""
        return Place(x, rate, second) if self.ease is None else self.ease(x, rate, second)

    @property
    def duration(self) -> float:
        """Duration of the whole path (s)."""
        return float(self.times[-1])

    @property
    def second(self) -> Array:
        """s'' at the nodes, at the start of the following cell."""
        return np.append(self.phase.first, self.phase.last[-1])

    def at(self, times: Array) -> Place:
        """Return s, s', and s'' at times (s) from 0 to the duration."""
        phase = self.phase
        cell = np.clip(np.searchsorted(self.times, times, side="right") - 1, 0, len(phase.first) - 1)
        tau = times - self.times[cell]
        slope = ((phase.last - phase.first) / np.diff(phase.s))[cell]
        rate, second = np.sqrt(phase.x[cell]), phase.first[cell]
        cosine, sine, lift = _exponentials(slope * tau**2)
        moved = rate * tau * sine + second * tau**2 * lift
        moved = np.clip(moved, 0.0, np.diff(phase.s)[cell])
        # Rounding errors must not reverse the motion at its end, because friction would change its sign.
        rate = np.maximum(rate * cosine + second * tau * sine, 0.0)
        return self._eased(phase.s[cell] + moved, rate, second + slope * moved)

    def inside(self, shares: Array) -> tuple[Array, Array, Array]:
        """Return s, s'^2, and s'' at relative positions in every cell, shape (cells, positions)."""
        step, rate, second = self._steps(shares)
        place = self._eased(self.phase.s[:-1, None] + step, rate, second)
        return place.s, place.rate**2, place.second

    def times_inside(self, shares: Array) -> Array:
        """Return the times (s) of relative positions in every cell, shape (cells, positions)."""
        step, rate, second = self._steps(shares)
        first = self.phase.first[:, None]
        return self.times[:-1, None] + _durations(
            step, rate + np.sqrt(self.phase.x[:-1, None]), second - first
        )

    def _steps(self, shares: Array) -> tuple[Array, Array, Array]:
        """Return distance from the start of the cell, s', and s'' at relative positions in every cell."""
        phase, h = self.phase, np.diff(self.phase.s)[:, None]
        step = h * shares
        second = phase.first[:, None] + (phase.last - phase.first)[:, None] * shares
        square = phase.x[:-1, None] + (phase.first[:, None] + second) * step
        if phase.x[-1] == 0.0:
            # The motion ends at rest, but rounding errors give a small rate.
            square[-1] = np.where(np.broadcast_to(shares, square.shape)[-1] == 1.0, 0.0, square[-1])
        return step, np.sqrt(np.maximum(square, 0.0)), second


def durations(phase: PhasePath) -> Array:
    """Return the duration of each cell (s)."""
    rate = np.sqrt(phase.x)
    return _durations(np.diff(phase.s), rate[:-1] + rate[1:], phase.last - phase.first)


def _durations(h: Array, rates: Array, change: Array) -> Array:
    """Return the durations (s) of steps h: 2 artanh(sqrt(c) h / rates) / sqrt(c), c = change / h.

    ``rates`` is the sum of s' at both ends; ``change`` is the change of s'', which is linear in s.
    """
    moving = np.where(rates > 0.0, rates, 1.0)
    y = np.minimum(change * h / moving**2, (1.0 - 1e-15) ** 2)
    curved = np.abs(y) > 1e-8
    root = np.sqrt(np.where(curved, y, 0.25).astype(np.complex128))
    return np.asarray(2.0 * h / moving * np.where(curved, (np.arctanh(root) / root).real, 1.0 + y / 3.0))


def _exponentials(y: Array) -> tuple[Array, Array, Array]:
    """Return cosh(r), sinh(r) / r, and (cosh(r) - 1) / r^2 for r^2 = y; trigonometric functions if y < 0."""
    root = np.sqrt(y.astype(np.complex128))
    sine, half = (np.sinc(1j * share * root / np.pi).real for share in (1.0, 0.5))
    return np.cosh(root).real, sine, 0.5 * half**2
