"""Roots and minima of functions of one variable between samples, with many points per bracket."""

from collections.abc import Callable

import numpy as np
from numpy.polynomial import chebyshev

from ..io.array_types import Array, Flags

Function = Callable[[Array], Array]

_PARTS = 16
_DEGREE = 20
# Relative size of the last Chebyshev coefficients at which a piece is resolved.
_RESOLVED = 1e-11
_TAIL = 4
_MOST_HALVINGS = 30
_MOST_PIECES = 4096
# Relative accuracy of the location of a minimum: nearby values differ by the square of it.
_MINIMUM = float(np.sqrt(np.finfo(np.float64).eps))

_ANGLES = np.pi * (np.arange(_DEGREE + 1) + 0.5) / (_DEGREE + 1)
_NODES = -np.cos(_ANGLES)
_TO_COEFFICIENTS = np.linalg.inv(chebyshev.chebvander(_NODES, _DEGREE))


def root(function: Function, low: float, high: float) -> tuple[float, float]:
    """Return the narrowest floating-point bracket of a sign change, or twice the root.

    The signs at ``low`` and ``high`` must differ.
    """
    side = float(np.sign(function(np.array([low]))[0]))
    while True:
        inner = _inside(low, high)
        if not inner.size:
            return low, high
        signs = np.sign(function(inner))
        if np.any(signs == 0.0):
            low = high = float(inner[np.argmax(signs == 0.0)])
            return low, high
        points = np.concatenate([[low], inner, [high]])
        first = int(np.argmax(np.append(signs != side, True)))
        low, high = float(points[first]), float(points[first + 1])


def minimum(function: Function, low: float, high: float) -> float:
    """Return the location of the only minimum in [low, high], as accurate as the function values allow."""
    return float(minima(lambda points: function(points)[:, None], np.array([low]), np.array([high]))[0])


def at_each(function: Function, points: Array) -> Array:
    """Evaluate columns of a function, (k,) to (k, m), of increasing numbers at individual points (n, m)."""
    every, place = np.unique(points, return_inverse=True)
    return function(every)[place.reshape(points.shape), np.arange(points.shape[1])]


def minima(function: Function, low: Array, high: Array) -> Array:
    """Return the location of the minimum of each column of a function, (k,) to (k, m), shape (m,).

    Column j is minimized between ``low[j]`` and ``high[j]``.
    """
    goal = _MINIMUM * (high - low)
    points = _between(low, high)
    values = at_each(function, points)
    while True:
        i = np.argmin(np.where(np.isfinite(values), values, np.inf), axis=0)[None]
        best, least = (np.take_along_axis(x, i, axis=0)[0] for x in (points, values))
        low = np.where(points < best, points, -np.inf).max(axis=0)
        high = np.where(points > best, points, np.inf).min(axis=0)
        low, high = (np.where(np.isfinite(end), end, best) for end in (low, high))
        inner = _between(low, high)
        # No floating-point number exists between neighboring numbers.
        new = np.any((inner > low) & (inner < high) & (inner != best), axis=0)
        if not np.any((high - low > goal) & new):
            return np.asarray(best)
        # A point that differs from the best only by rounding would remove one of its sides.
        inner = np.where(np.abs(inner - best) < 1e-3 / _PARTS * (high - low), best, inner)
        points = np.concatenate([inner, [best]])
        values = at_each(function, points)
        # Keep the best point even if rounding makes another one appear better.
        values = np.where(points == best, np.minimum(values, least), values)


def turning_points(function: Function, edges: Array, floor: Array) -> Array:
    """Return sorted points within the edges, shape (m, 2), that separate all roots of a smooth function.

    Each piece is approximated by a Chebyshev series and halved until the series is accurate. The points are
    the nodes and the zeros of the derivative of the series. One of these points separates any two roots, so
    the signs at the points reveal all roots. ``floor``, shape (m,), is the rounding error of the function.
    """
    found: list[Array] = []
    pieces, noise = np.asarray(edges, dtype=np.float64).reshape(-1, 2), np.asarray(floor, dtype=np.float64)
    for halving in range(_MOST_HALVINGS + 1):
        if not len(pieces):
            break
        middle, half = pieces.mean(axis=1)[:, None], 0.5 * (pieces[:, 1:] - pieces[:, :1])
        nodes = middle + half * _NODES
        values = function(nodes.ravel()).reshape(nodes.shape)
        finite = np.asarray(np.isfinite(values).all(axis=1))
        series = np.where(finite[:, None], values, 0.0) @ _TO_COEFFICIENTS.T
        largest = np.max(np.abs(series), axis=1)
        tail = np.max(np.abs(series[:, -_TAIL:]), axis=1)
        done = finite & (tail <= np.maximum(_RESOLVED * largest, noise))
        if halving == _MOST_HALVINGS or 2 * np.count_nonzero(~done) > _MOST_PIECES:
            done[:] = True
        found.append(nodes[done].ravel())
        flat = largest <= noise
        for i in np.flatnonzero(done & finite & ~flat):
            found.append(middle[i] + half[i] * _zeros(chebyshev.chebder(series[i])))
        left = pieces[~done]
        cut = left.mean(axis=1)
        pieces = np.concatenate([np.stack([left[:, 0], cut], axis=1), np.stack([cut, left[:, 1]], axis=1)])
        noise = np.tile(noise[~done], 2)
    return np.unique(np.concatenate([np.empty(0), *found]))


def _inside(low: float, high: float) -> Array:
    points = _between(low, high)
    return np.unique(points[(points > low) & (points < high)])


def _between(low: Array | float, high: Array | float) -> Array:
    return np.linspace(low, high, _PARTS + 1)


def _zeros(series: Array) -> Array:
    """Return the real zeros in (-1, 1), including zeros within rounding of the real axis."""
    size = np.max(np.abs(series))
    trimmed = chebyshev.chebtrim(series, 1e-14 * size) if size else series
    if len(trimmed) < 2:
        return np.empty(0)
    zeros = chebyshev.chebroots(trimmed)
    real = zeros.real[np.abs(zeros.imag) < 1e-3]
    return np.asarray(real[np.abs(real) < 1.0])


def runs(flags: Flags) -> list[tuple[int, int]]:
    """Return first and last index of each run of at least three flags; shorter runs are crossings."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    return [(int(i), int(j) - 1) for i, j in edges.reshape(-1, 2) if j - i >= 3]
