"""The grid of a path: its terms, and by how much limits are tightened so that they hold between the nodes."""

import functools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ...io.array_types import Array
from .motor_terms import beside
from .path_terms import Terms
from .phase_plane import Bounds, Profile, bounds_of, fastest

Source = Callable[[Array], Terms]
"""Parameters s, (n,) -> terms there."""

# Share by which all limits are tightened from the start, so that neither rounding nor a kink exceeds one.
_MARGIN = 1e-5
AIM = 1.0 - 4e-6
"""Largest share of a limit at the places of a cell that are checked: between them a little more is used."""
IDLE = 1e-3
"""A limit is active from this share below it on."""
# Places of a cell that are checked: denser toward the ends, where friction grows as the root of the way.
_SHARES = 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, 25))
_PARTS = 4
# Limits are tightened by this times the excess, so that few rounds suffice.
_MORE = 1.25
_SECANTS = 5
# Of what holding the machine leaves, limits are tightened by no more than this share.
_FREE = 0.9
# Where a limit is exceeded by more than this share between nodes, tightening alone does not help.
_ROUGH = 5e-4
# Nodes are at least this share of a cell apart.
_APART = 0.05
# Bounds that depend on the motion are updated at most so often, until rates change by no more than a share.
TURNS = 12
_SAME = 1e-3


class Grid(NamedTuple):
    """Nodes s, (n,), terms there, and shares by which limits are tightened, (n, m), those of speed last.

    rate, second: s' and s'' of the motion found last, (n,), 0 before; friction and limits of power are taken
    from these. between: terms at the places of every cell that are checked.
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
        """A grid of nodes s and of those between them at which s'' has no effect on a quantity."""
        zeros = np.sort(_zeros(source, s))
        # A node so near another that rounding shows in the step between them is left out.
        zeros = zeros[np.diff(zeros, prepend=-np.inf) > _APART * (s[1] - s[0])]
        near = np.abs(s[:, None] - zeros).min(axis=1, initial=np.inf) <= _APART * (s[1] - s[0])
        near[[0, -1]] = False
        return cls.at(source, np.union1d(s[~near], zeros))

    @classmethod
    def at(cls, source: Source, s: Array) -> "Grid":
        """A grid of just these nodes."""
        terms = source(s)
        none = np.zeros(len(s))
        margin = np.full((len(s), terms.quantities), _MARGIN)
        places = s[:-1, None] + np.diff(s)[:, None] * _SHARES
        between = functools.cache(lambda: source(places.ravel()))
        return cls(source, s, terms, between, margin, none, none)

    def after(self, profile: Profile, share: float = 1.0) -> "Grid":
        """The grid with the rates of a motion along the path, times a share."""
        square, second = (np.interp(self.s, profile.phase.s, x) for x in (profile.phase.x, profile.second))
        return self._replace(rate=share * np.sqrt(square), second=share**2 * second)

    def fastest(self, turns: int = TURNS) -> tuple["Grid", Profile]:
        """The fastest motion, in turns where bounds depend on its rates, and the grid with these."""
        grid, motors = self, self.terms.motors
        for _ in range(turns):
            profile = Profile.of(fastest(grid.s, grid.bounds()))
            if motors is None:
                break
            rate = np.sqrt(profile.phase.x)
            done = np.abs(rate - grid.rate).max() <= _SAME * rate.max()
            # A limit of power has tangents from rates at which it is kept.
            share = 1.0 if grid.rate.any() else motors.share_within_power(profile.phase.x, profile.second)
            grid = grid.after(profile, share)
            if done:
                break
        return grid, profile

    def bounds(self) -> Bounds:
        """What the tightened limits allow at the nodes."""
        before, after = beside(self.terms.signs)
        twice = np.flatnonzero((before != after).any(axis=-1))
        index = np.append(np.arange(len(self.s)), twice)
        room = 1.0 - self.margin[index]
        terms = self.terms.at(index)
        rows = terms.rows(self.rate[index], self.second[index], room, np.concatenate([after, before[twice]]))
        return bounds_of(rows, terms.caps * room[:, -1] ** 2, twice)

    def divided(self, used: Array) -> "Grid":
        """Cells in which a limit is exceeded, or none is active, in parts."""
        most = used.max(axis=-1)
        chosen = (most.max(axis=-1) > 1.0 + _ROUGH) | (most.min(axis=-1) < 1.0 - IDLE)
        inner = np.linspace(0.0, 1.0, _PARTS + 1)[1:-1]
        start, step = self.s[:-1][chosen, None], np.diff(self.s)[chosen, None]
        return Grid.at(self.source, np.union1d(self.s, start + step * inner))

    def tightened(self, used: Array, turn: int) -> "Grid":
        """Limits lower by what was exceeded beside each node, by more from turn to turn, from 1."""
        excess = np.maximum(used.max(axis=1) - AIM, 0.0)
        none = np.zeros((1, excess.shape[1]))
        beside = np.maximum(np.concatenate([excess, none]), np.concatenate([none, excess]))
        most = _FREE * np.maximum(1.0 - self.terms.held(), 0.0)
        return self._replace(margin=np.minimum(self.margin + _MORE**turn * beside, most))

    def used(self, profile: Profile) -> Array:
        """Shares of the limits that are used in every cell, (cells, shares, m), that of speed last."""
        _, square, second = profile.inside(_SHARES)
        return self.between().used(square, second)


def _zeros(source: Source, s: Array) -> Array:
    """Where the effect of s'' on a quantity or the rate of a leg with friction passes zero."""
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
