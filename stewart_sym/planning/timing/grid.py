"""Grid of a path: its terms, and margins of the limits that prevent violations between the nodes."""

import functools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ...io.array_types import Array
from .motor_terms import beside
from .path_terms import Terms
from .phase_plane import Bounds, Profile, bounds_of, fastest

Source = Callable[[Array], Terms]
"""Function: parameters s, shape (n,) -> terms at these parameters."""

# Relative initial margin of all limits, which covers rounding errors and kinks.
_MARGIN = 1e-5
AIM = 1.0 - 4e-6
"""Largest utilization at the checked samples of a cell; slightly larger values may occur in between."""
IDLE = 1e-3
"""Relative distance from a limit up to which the limit is active."""
# Checked samples of a cell, denser near its ends, where friction is a square root of the distance.
_SHARES = 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, 25))
_PARTS = 4
# Factor of the excess by which limits are tightened, so that few rounds suffice.
_MORE = 1.25
_SECANTS = 5
# Largest margin of a limit, relative to the part that remains after the static load.
_FREE = 0.9
# Relative excess between nodes from which a cell is divided instead of tightening the limits.
_ROUGH = 5e-4
# Smallest distance of nodes, relative to a cell.
_APART = 0.05
# Largest number of updates of bounds that depend on the motion, and the relative change that ends them.
TURNS = 12
_SAME = 1e-3


class Grid(NamedTuple):
    """Nodes s, shape (n,), terms at the nodes, and relative margins of the limits, shape (n, m), speed last.

    Attributes
    ----------
    between : callable
        Function that returns the terms at the checked samples of every cell.
    rate, second : ndarray, shape (n,)
        s' and s'' of the previous motion, 0 at first. Friction and power limits are linearized there.
    """

    source: Source
    s: Array
    terms: Terms
    between: Callable[[], Terms]
    margin: Array
    rate: Array
    second: Array

    @classmethod
    def of(cls, source: Source, s: Array) -> "Grid":
        """Create a grid of nodes s and of the zeros of the coefficients of s'' in between."""
        zeros = np.sort(_zeros(source, s))
        # Nodes very close to another node are omitted, because rounding errors dominate such steps.
        zeros = zeros[np.diff(zeros, prepend=-np.inf) > _APART * (s[1] - s[0])]
        near = np.abs(s[:, None] - zeros).min(axis=1, initial=np.inf) <= _APART * (s[1] - s[0])
        near[[0, -1]] = False
        return cls.at(source, np.union1d(s[~near], zeros))

    @classmethod
    def at(cls, source: Source, s: Array) -> "Grid":
        """Create a grid of given nodes."""
        terms = source(s)
        none = np.zeros(len(s))
        margin = np.full((len(s), terms.quantities), _MARGIN)
        places = s[:-1, None] + np.diff(s)[:, None] * _SHARES
        between = functools.cache(lambda: source(places.ravel()))
        return cls(source, s, terms, between, margin, none, none)

    def after(self, profile: Profile, share: float = 1.0) -> "Grid":
        """Return the grid with the rates of a motion along the path, multiplied by a factor."""
        square, second = (np.interp(self.s, profile.phase.s, x) for x in (profile.phase.x, profile.second))
        return self._replace(rate=share * np.sqrt(square), second=share**2 * second)

    def fastest(self, turns: int = TURNS) -> tuple["Grid", Profile]:
        """Compute the fastest motion and the new grid, with updates of rate-dependent bounds."""
        grid, motors = self, self.terms.motors
        for _ in range(turns):
            profile = Profile.of(fastest(grid.s, grid.bounds()))
            if motors is None:
                break
            rate = np.sqrt(profile.phase.x)
            done = np.abs(rate - grid.rate).max() <= _SAME * rate.max()
            # The tangent of a power limit requires rates within the limit.
            share = 1.0 if grid.rate.any() else motors.share_within_power(profile.phase.x, profile.second)
            grid = grid.after(profile, share)
            if done:
                break
        return grid, profile

    def bounds(self) -> Bounds:
        """Compute the bounds at the nodes from the tightened limits."""
        before, after = beside(self.terms.signs)
        twice = np.flatnonzero((before != after).any(axis=-1))
        index = np.append(np.arange(len(self.s)), twice)
        room = 1.0 - self.margin[index]
        terms = self.terms.at(index)
        rows = terms.rows(self.rate[index], self.second[index], room, np.concatenate([after, before[twice]]))
        return bounds_of(rows, terms.caps * room[:, -1] ** 2, twice)

    def divided(self, used: Array) -> "Grid":
        """Divide the cells in which a limit is exceeded or no limit is active."""
        most = used.max(axis=-1)
        chosen = (most.max(axis=-1) > 1.0 + _ROUGH) | (most.min(axis=-1) < 1.0 - IDLE)
        inner = np.linspace(0.0, 1.0, _PARTS + 1)[1:-1]
        start, step = self.s[:-1][chosen, None], np.diff(self.s)[chosen, None]
        return Grid.at(self.source, np.union1d(self.s, start + step * inner))

    def tightened(self, used: Array, turn: int) -> "Grid":
        """Reduce the limits by the excess next to each node, more in each round ``turn``, from 1."""
        excess = np.maximum(used.max(axis=1) - AIM, 0.0)
        none = np.zeros((1, excess.shape[1]))
        beside = np.maximum(np.concatenate([excess, none]), np.concatenate([none, excess]))
        most = _FREE * np.maximum(1.0 - self.terms.held(), 0.0)
        return self._replace(margin=np.minimum(self.margin + _MORE**turn * beside, most))

    def used(self, profile: Profile) -> Array:
        """Compute the utilization of the limits in every cell, shape (cells, samples, m), speed last."""
        _, square, second = profile.inside(_SHARES)
        return self.between().used(square, second)


def _zeros(source: Source, s: Array) -> Array:
    """Find the zeros of the coefficients of s'' and of the rates of legs with friction."""
    a = source(s).crossings
    cell, row = np.nonzero(a[:-1] * a[1:] < 0.0)
    low, high = s[cell], s[cell + 1]
    below, above = a[cell, row], a[cell + 1, row]
    for _ in range(_SECANTS if len(cell) else 0):
        middle = low - below * (high - low) / (above - below)
        value = source(middle).crossings[np.arange(len(row)), row]
        same = value * below > 0.0
        low, below = np.where(same, middle, low), np.where(same, value, below)
        high, above = np.where(same, high, middle), np.where(same, above, value)
    return np.where(np.abs(below) < np.abs(above), low, high)
