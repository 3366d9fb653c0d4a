"""The square y of a parameter's rate as a quadratic spline of the parameter x, on even cells from 0 to 1.

Any two motions along a path differ by y alone: x'' = dy/dx / 2, and x''' = sqrt(y) d2y/dx2 / 2.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ...io.array_types import Array
from ..timing.phase_plane import PhasePath

PARTS = 4
"""Parts of each cell: samples are at their ends, five in a cell."""
SHARES = np.linspace(0.0, 1.0, PARTS + 1)
"""Where the samples of a cell are, from 0 to 1."""
WEIGHTS = np.array([7.0, 32.0, 12.0, 32.0, 7.0]) / 90.0
"""Weights of a cell's samples in an integral over it, by Boole's rule."""
_ACTIVE = 3


class RateSpline(NamedTuple):
    """Splines with a number of cells: cells + 2 coefficients, three of them in each cell."""

    cells: int

    @property
    def edges(self) -> Array:
        """Edges of the cells, (cells + 1,)."""
        return np.linspace(0.0, 1.0, self.cells + 1)

    def basis(self, shares: Array) -> Array:
        """y, dy/dx and d2y/dx2 at shares of a cell by its three coefficients, (k, 3, 3)."""
        z, n = shares, float(self.cells)
        one = np.ones_like(z)
        value = np.stack([0.5 * (1.0 - z) ** 2, 0.5 + z - z * z, 0.5 * z * z], axis=-1)
        rate = n * np.stack([z - 1.0, 1.0 - 2.0 * z, z], axis=-1)
        return np.stack([value, rate, n * n * np.stack([one, -2.0 * one, one], axis=-1)], axis=1)

    def values(self, c: Array, shares: Array = SHARES) -> Array:
        """y and its two derivatives at shares of every cell, (cells, k, 3)."""
        inside = np.lib.stride_tricks.sliding_window_view(c, _ACTIVE)
        return np.asarray(np.einsum("kdj,ij->ikd", self.basis(shares), inside))

    def gradient(self, by_values: Array) -> Array:
        """Derivative by the coefficients of one by values at the samples, (cells, 5, 3)."""
        each = np.einsum("kdj,ikd->ij", self.basis(SHARES), by_values)
        found = np.zeros(self.cells + 2)
        for j in range(_ACTIVE):
            found[j : j + self.cells] += each[:, j]
        return found

    def band(self, by_values: Array) -> Array:
        """Second derivative by the coefficients of one by values, (cells, 5, 3, 3), as an upper band."""
        basis = self.basis(SHARES)
        each = np.einsum("kdj,ikde,kel->ijl", basis, by_values, basis, optimize=True)
        found = np.zeros((_ACTIVE, self.cells + 2))
        for j in range(_ACTIVE):
            for k in range(j, _ACTIVE):
                found[_ACTIVE - 1 - (k - j), k : k + self.cells] += each[:, j, k]
        return found

    def phase(self, c: Array) -> PhasePath:
        """The path in the phase plane."""
        first, last = self.values(c, np.array([0.0, 1.0])).transpose(1, 0, 2)
        x = np.append(first[:, 0], last[-1, 0])
        free = np.full_like(x, np.inf)
        return PhasePath(self.edges, x, 0.5 * first[:, 1], 0.5 * last[:, 1], free, free)


def in_cells(nodes: Array) -> Array:
    """Values at the ends of all parts, (4 cells + 1, ...), at the samples of each cell, (cells, 5, ...)."""
    starts = [nodes[part:-1:PARTS] for part in range(PARTS)]
    return np.stack([*starts, nodes[PARTS::PARTS]], axis=1)
