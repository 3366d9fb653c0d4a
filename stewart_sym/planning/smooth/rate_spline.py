"""Squared rate y of a parameter x as a quadratic spline on even cells from 0 to 1.

Two motions along a path differ by y only: x'' = dy/dx / 2, and x''' = sqrt(y) d2y/dx2 / 2. The motion of
least cost within limits is computed by a primal-dual interior-point method whose iterates are always
feasible. Costs and limits are sums over samples, so that the matrix of each step is banded with three upper
diagonals.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ...io.array_types import Array
from ..timing.phase_plane import PhasePath

PARTS = 4
"""Parts of each cell; the samples are at their ends, five in a cell."""
SHARES = np.linspace(0.0, 1.0, PARTS + 1)
"""Relative positions of the samples in a cell, 0 to 1."""
WEIGHTS = np.array([7.0, 32.0, 12.0, 32.0, 7.0]) / 90.0
"""Quadrature weights of the samples of a cell (Boole's rule)."""
_ACTIVE = 3


class RateSpline(NamedTuple):
    """Splines with a number of cells; they have cells + 2 coefficients, three of them in each cell."""

    cells: int

    @property
    def edges(self) -> Array:
        """Edges of the cells, shape (cells + 1,)."""
        return np.linspace(0.0, 1.0, self.cells + 1)

    def basis(self, shares: Array) -> Array:
        """Compute y, dy/dx, and d2y/dx2 at positions in a cell from its three coefficients, (k, 3, 3)."""
        z, n = shares, float(self.cells)
        one = np.ones_like(z)
        value = np.stack([0.5 * (1.0 - z) ** 2, 0.5 + z - z * z, 0.5 * z * z], axis=-1)
        rate = n * np.stack([z - 1.0, 1.0 - 2.0 * z, z], axis=-1)
        return np.stack([value, rate, n * n * np.stack([one, -2.0 * one, one], axis=-1)], axis=1)

    def values(self, c: Array, shares: Array = SHARES) -> Array:
        """Compute y and its two derivatives at relative positions in every cell, shape (cells, k, 3)."""
        inside, basis = np.lib.stride_tricks.sliding_window_view(c, _ACTIVE), self.basis(shares)
        return np.asarray((inside @ basis.reshape(-1, _ACTIVE).T).reshape(self.cells, *basis.shape[:2]))

    def gradient(self, by_values: Array) -> Array:
        """Convert a gradient by values at the samples, shape (cells, 5, 3), to coefficients."""
        each = by_values.reshape(self.cells, -1) @ self.basis(SHARES).reshape(-1, _ACTIVE)
        found = np.zeros(self.cells + 2)
        for j in range(_ACTIVE):
            found[j : j + self.cells] += each[:, j]
        return found

    def band(self, by_values: Array) -> Array:
        """Convert a Hessian by values, shape (cells, 5, 3, 3), to coefficients, as an upper band."""
        basis = self.basis(SHARES)
        pairs = basis[:, :, None, :, None] * basis[:, None, :, None, :]
        each = by_values.reshape(self.cells, -1) @ pairs.reshape(-1, _ACTIVE**2)
        each = each.reshape(self.cells, _ACTIVE, _ACTIVE)
        found = np.zeros((_ACTIVE, self.cells + 2))
        for j in range(_ACTIVE):
            for k in range(j, _ACTIVE):
                found[_ACTIVE - 1 - (k - j), k : k + self.cells] += each[:, j, k]
        return found

    def phase(self, c: Array) -> PhasePath:
        """Return the path in the phase plane."""
        first, last = self.values(c, np.array([0.0, 1.0])).transpose(1, 0, 2)
        x = np.append(first[:, 0], last[-1, 0])
        free = np.full_like(x, np.inf)
        return PhasePath(self.edges, x, 0.5 * first[:, 1], 0.5 * last[:, 1], free, free)


def in_cells(nodes: Array) -> Array:
    """Return values at the ends of all parts, (4 cells + 1, ...), by cells, shape (cells, 5, ...)."""
    starts = [nodes[part:-1:PARTS] for part in range(PARTS)]
    return np.stack([*starts, nodes[PARTS::PARTS]], axis=1)


# Minimization of a cost

_STEPS = 400
_CENTRING = 0.15
_KEPT = 0.99
_SHORTEST = 1e-9
# Smallest decrease of a step relative to its slope (Armijo condition), and tolerance for rounding errors.
_FALL, _SAME = 1e-4, 1e-12
# Penalty of an error of the duration, relative to its multiplier.
_FINE = 1.5
# Relative duality gap at which the search ends.
GAP = 1e-7


class Rooms(NamedTuple):
    """r limits at the samples: k . (1, sqrt(y), 1 / sqrt(y), y, y', y'') >= 0, shape (cells, 5, r, 6)."""

    k: Array

    def values(self, v: Array) -> Array:
        """Compute the distances from the limits, (cells, 5, r), from y and its derivatives, (cells, 5, 3)."""
        root = np.sqrt(v[..., :1])
        terms = np.concatenate([np.ones_like(root), root, 1.0 / root, v], axis=-1)
        return np.asarray((self.k @ terms[..., None])[..., 0])

    def rates(self, v: Array) -> tuple[Array, Array]:
        """Compute their derivatives, shape (cells, 5, r, 3), and second derivatives by y, (cells, 5, r)."""
        y = v[..., 0, None]
        found = self.k[..., 3:].copy()
        found[..., 0] += 0.5 * self.k[..., 1] * y**-0.5 - 0.5 * self.k[..., 2] * y**-1.5
        return found, -0.25 * self.k[..., 1] * y**-1.5 + 0.75 * self.k[..., 2] * y**-2.5


Cost = Callable[[Array], tuple[float, Array, Array]]
"""Function: y and derivatives at the samples -> cost, gradient (cells, 5, 3), Hessian (cells, 5, 3, 3)."""


def duration(spline: RateSpline, v: Array) -> tuple[float, Array, Array]:
    """Compute the duration of a motion as a ``Cost``."""
    weight = WEIGHTS / spline.cells
    by, twice = np.zeros_like(v), np.zeros((*v.shape, 3))
    by[..., 0] = -0.5 * weight * v[..., 0] ** -1.5
    twice[..., 0, 0] = 0.75 * weight * v[..., 0] ** -2.5
    return float(np.sum(weight * v[..., 0] ** -0.5)), by, twice


# Too long steps cause overflows and undefined costs; the line search rejects them.
@np.errstate(over="ignore", divide="ignore", invalid="ignore")
def least(spline: RateSpline, c: Array, rooms: Rooms, cost: Cost, time: float | None = None) -> Array:
    """Minimize a cost from feasible coefficients; with ``time`` the duration is fixed."""
    from scipy.linalg import solveh_banded

    v = spline.values(c)
    g = rooms.values(v)
    f, by, twice = cost(v)
    mu = 1e-2 * max(abs(f), 1e-300) / g.size
    price = 0.0 if time is None else abs(f) / time
    multiplier, late, fine = mu / g, 0.0, 0.0

    def merit(v: Array, g: Array, f: float) -> float:
        missed = 0.0 if time is None else duration(spline, v)[0] - time
        return f - mu * float(np.log(g).sum()) + fine * abs(missed)

    for _ in range(_STEPS):
        slope, bend = rooms.rates(v)
        stiff = np.swapaxes(slope * (multiplier / g)[..., None], -1, -2) @ slope
        stiff[..., 0, 0] += np.sum(multiplier * np.maximum(-bend, 0.0), axis=-1)
        stiff = stiff + twice
        if time is not None:
            now, by_time, twice_time = duration(spline, v)
            late = now - time
            stiff = stiff + max(price, 1e-6 * abs(f) / time) * twice_time
        band = spline.band(stiff)
        band[-1] *= 1.0 + 1e-12
        pull = spline.gradient(np.einsum("ikr,ikra->ika", mu / g, slope) - by)
        step = solveh_banded(band, pull)
        if time is not None:
            row = spline.gradient(by_time)
            side = solveh_banded(band, row)
            price = float((late + row @ step) / (row @ side))
            step = step - price * side
            fine = max(fine, _FINE * abs(price))
        moved = spline.values(step)
        change = mu / g - multiplier - multiplier / g * np.einsum("ikra,ika->ikr", slope, moved)
        share = _share(rooms, v, moved, g)
        # The merit function contains cost, barrier, and the penalty of an error of the duration.
        before, falls = merit(v, g, f), float(pull @ step) + fine * abs(late)
        while share > _SHORTEST:
            there = v + share * moved
            g = rooms.values(there)
            f, by, twice = cost(there)
            if merit(there, g, f) <= before - _FALL * share * falls + _SAME * abs(f):
                break
            share *= 0.5
        else:
            # The distance from a limit has reached rounding errors, so no further progress is possible.
            break
        c, v = c + share * step, there
        falling = change < 0.0
        dual = min(1.0, _KEPT * float(np.min(-multiplier[falling] / change[falling], initial=np.inf)))
        multiplier = multiplier + dual * change
        gap = float(np.sum(multiplier * g))
        if gap <= GAP * abs(f) and np.abs(moved[..., 0] / v[..., 0]).max() < 1e-5:
            break
        if share > 0.5:
            mu = _CENTRING * gap / g.size
    return c


def _share(rooms: Rooms, v: Array, moved: Array, g: Array) -> float:
    """Return the largest fraction of a step that preserves a part of the distance from every limit."""
    falling = moved[..., 0] < 0.0
    share = min(1.0, 0.9 * float(np.min(-v[..., 0][falling] / moved[..., 0][falling], initial=np.inf)))
    while share > _SHORTEST and np.any(rooms.values(v + share * moved) <= (1.0 - _KEPT) * g):
        share *= 0.8
    return share
