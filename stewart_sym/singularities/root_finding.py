"""Roots and minima of functions of one number between samples: brackets cut by many points at a time."""

from collections.abc import Callable

import numpy as np
from numpy.polynomial import chebyshev

from ..io.array_types import Array, Flags

Function = Callable[[Array], Array]

_PARTS = 16
_DEGREE = 20
# A piece is resolved when its last Chebyshev coefficients are this share of its largest.
_RESOLVED = 1e-11
_TAIL = 4
_MOST_HALVINGS = 30
_MOST_PIECES = 4096
# Relative accuracy of the place of a minimum: values beside it differ by the square of this.
_MINIMUM = float(np.sqrt(np.finfo(np.float64).eps))

_ANGLES = np.pi * (np.arange(_DEGREE + 1) + 0.5) / (_DEGREE + 1)
_NODES = -np.cos(_ANGLES)
_TO_COEFFICIENTS = np.linalg.inv(chebyshev.chebvander(_NODES, _DEGREE))


def root(function: Function, low: float, high: float) -> tuple[float, float]:
    """Return the narrowest bracket of a change of sign that floating point allows, or twice a root.

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
    """Return where the function is least in [low, high], as near as its values tell; one minimum inside."""
    return float(minima(lambda points: function(points)[:, None], np.array([low]), np.array([high]))[0])


def at_each(function: Function, points: Array) -> Array:
    """Columns of a function of increasing numbers, (k,) to (k, m), at points of their own, (n, m)."""
    every, place = np.unique(points, return_inverse=True)
    return function(every)[place.reshape(points.shape), np.arange(points.shape[1])]


def minima(function: Function, low: Array, high: Array) -> Array:
    """Return where each column of a function, (k,) to (k, m), is least between ends of its own, (m,)."""
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
        # Neighboring numbers have nothing new between them.
        new = np.any((inner > low) & (inner < high) & (inner != best), axis=0)
        if not np.any((high - low > goal) & new):
            return np.asarray(best)
        # A point that rounding alone sets apart from the best would cut off one of its sides.
        inner = np.where(np.abs(inner - best) < 1e-3 / _PARTS * (high - low), best, inner)
        points = np.concatenate([inner, [best]])
        values = at_each(function, points)
        # Rounding may hide the best point found; it must not be lost for a worse one.
        values = np.where(points == best, np.minimum(values, least), values)


def turning_points(function: Function, edges: Array, floor: Array) -> Array:
    """Return sorted points between the edges, (m, 2), among them all where a smooth function turns.

    On each piece the function becomes a Chebyshev series; pieces for which that does not do are halved. The
    points are the nodes and the zeros of the series' derivative: between two roots lies one of these, so
    signs at the points miss no pair of roots. floor, (m,): what is rounding error in the function.
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
    """Real zeros in (-1, 1), those within rounding of the real axis too."""
    size = np.max(np.abs(series))
    trimmed = chebyshev.chebtrim(series, 1e-14 * size) if size else series
    if len(trimmed) < 2:
        return np.empty(0)
    zeros = chebyshev.chebroots(trimmed)
    real = zeros.real[np.abs(zeros.imag) < 1e-3]
    return np.asarray(real[np.abs(real) < 1.0])


def runs(flags: Flags) -> list[tuple[int, int]]:
    """First and last index of each run of at least three flags; fewer are a crossing looked at closely."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    return [(int(i), int(j) - 1) for i, j in edges.reshape(-1, 2) if j - i >= 3]
