"""The spline of least cost within limits, by a primal-dual interior-point method that never leaves them.

Costs and limits are sums over samples, so that the matrix of every step has three diagonals on either side.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ...io.array_types import Array
from ...io.extras import needed_for
from .rate_spline import WEIGHTS, RateSpline

_STEPS = 400
_CENTRING = 0.15
_KEPT = 0.99
_SHORTEST = 1e-9
# Duality gap at which the search ends, over the cost.
GAP = 1e-7


class Rooms(NamedTuple):
    """r limits at the samples: k . (1, sqrt(y), 1 / sqrt(y), y, y', y'') >= 0, (cells, 5, r, 6)."""

    k: Array

    def values(self, v: Array) -> Array:
        """How far limits are, (cells, 5, r), at y and its derivatives, (cells, 5, 3)."""
        root = np.sqrt(v[..., 0])
        terms = np.stack([np.ones_like(root), root, 1.0 / root, *np.moveaxis(v, -1, 0)], axis=-1)
        return np.asarray(np.einsum("ikrt,ikt->ikr", self.k, terms))

    def rates(self, v: Array) -> tuple[Array, Array]:
        """Their derivatives, (cells, 5, r, 3), and the second ones by y, (cells, 5, r)."""
        y = v[..., 0, None]
        found = self.k[..., 3:].copy()
        found[..., 0] += 0.5 * self.k[..., 1] * y**-0.5 - 0.5 * self.k[..., 2] * y**-1.5
        return found, -0.25 * self.k[..., 1] * y**-1.5 + 0.75 * self.k[..., 2] * y**-2.5


Cost = Callable[[Array], tuple[float, Array, Array]]
"""y and its derivatives at the samples -> cost, derivatives (cells, 5, 3), second ones (cells, 5, 3, 3)."""


def duration(spline: RateSpline, v: Array) -> tuple[float, Array, Array]:
    """Time along a spline, as a ``Cost``."""
    weight = WEIGHTS / spline.cells
    by, twice = np.zeros_like(v), np.zeros((*v.shape, 3))
    by[..., 0] = -0.5 * weight * v[..., 0] ** -1.5
    twice[..., 0, 0] = 0.75 * weight * v[..., 0] ** -2.5
    return float(np.sum(weight * v[..., 0] ** -0.5)), by, twice


def least(spline: RateSpline, c: Array, rooms: Rooms, cost: Cost, time: float | None = None) -> Array:
    """Coefficients of least cost from some that keep all limits; time: the duration, where it is given."""
    with needed_for("a motion"):
        from scipy.linalg import solveh_banded
    v = spline.values(c)
    g = rooms.values(v)
    f, by, twice = cost(v)
    mu = 1e-2 * max(abs(f), 1e-300) / g.size
    price = 0.0 if time is None else abs(f) / time
    multiplier = mu / g
    for _ in range(_STEPS):
        slope, bend = rooms.rates(v)
        stiff = np.einsum("ikr,ikra,ikrb->ikab", multiplier / g, slope, slope, optimize=True)
        stiff[..., 0, 0] += np.sum(multiplier * np.maximum(-bend, 0.0), axis=-1)
        stiff = stiff + twice
        if time is not None:
            now, by_time, twice_time = duration(spline, v)
            stiff = stiff + max(price, 1e-6 * abs(f) / time) * twice_time
        band = spline.band(stiff)
        band[-1] *= 1.0 + 1e-12
        pull = spline.gradient(np.einsum("ikr,ikra->ika", mu / g, slope) - by)
        step = solveh_banded(band, pull)
        if time is not None:
            row = spline.gradient(by_time)
            side = solveh_banded(band, row)
            price = float((now - time + row @ step) / (row @ side))
            step = step - price * side
        moved = spline.values(step)
        change = mu / g - multiplier - multiplier / g * np.einsum("ikra,ika->ikr", slope, moved)
        share = _share(rooms, v, moved, g)
        if share <= _SHORTEST:
            # So near a limit its distance is rounding: nothing is gained any more.
            break
        c, v = c + share * step, v + share * moved
        falling = change < 0.0
        dual = min(1.0, _KEPT * float(np.min(-multiplier[falling] / change[falling], initial=np.inf)))
        multiplier = multiplier + dual * change
        g = rooms.values(v)
        f, by, twice = cost(v)
        gap = float(np.sum(multiplier * g))
        if gap <= GAP * abs(f) and np.abs(moved[..., 0] / v[..., 0]).max() < 1e-5:
            break
        if share > 0.5:
            mu = _CENTRING * gap / g.size
    return c


def _share(rooms: Rooms, v: Array, moved: Array, g: Array) -> float:
    """Largest share of a step that leaves a part of the distance from every limit."""
    falling = moved[..., 0] < 0.0
    share = min(1.0, 0.9 * float(np.min(-v[..., 0][falling] / moved[..., 0][falling], initial=np.inf)))
    while share > _SHORTEST and np.any(rooms.values(v + share * moved) <= (1.0 - _KEPT) * g):
        share *= 0.8
    return share
