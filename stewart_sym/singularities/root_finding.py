"""Points that separate all roots of a smooth function of one variable between samples."""

from collections.abc import Callable

import numpy as np
from numpy.polynomial import chebyshev

from ..io.array_types import Array, Flags

Function = Callable[[Array], Array]

_DEGREE = 20
# Relative size of the last Chebyshev coefficients at which a piece is resolved.
_RESOLVED = 1e-11
_TAIL = 4
_MOST_HALVINGS = 30
_MOST_PIECES = 4096

_ANGLES = np.pi * (np.arange(_DEGREE + 1) + 0.5) / (_DEGREE + 1)
_NODES = -np.cos(_ANGLES)
_TO_COEFFICIENTS = np.linalg.inv(chebyshev.chebvander(_NODES, _DEGREE))


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
