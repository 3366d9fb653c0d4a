"""Parameter over time: in each cell s'' is linear in s, so s, s' and s'' are sums of exponentials of time."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ...io.array_types import Array
from .phase_plane import PhasePath


class Place(NamedTuple):
    """s, s' and s'' at some instants, (n,) each."""

    s: Array
    rate: Array
    second: Array


class Ease(NamedTuple):
    """s from start to end as a polynomial of x from 0 to 1 whose first rates at both ends are 0.

    A motion from rest has a rate of x above 0 everywhere: with two such rates s'' begins at 0 too.
    """

    start: float
    end: float
    rests: int

    def __call__(self, x: Array, rate: Array, second: Array) -> Place:
        """s, s' and s'' at x, x' and x''."""
        way = self.end - self.start
        if self.rests == 1:
            share, by, twice = x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x), 6.0 - 12.0 * x
        else:
            share = x**3 * (10.0 - 15.0 * x + 6.0 * x * x)
            by, twice = 30.0 * (x * (1.0 - x)) ** 2, 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x)
        s = np.clip(self.start + way * share, min(self.start, self.end), max(self.start, self.end))
        return Place(s, way * by * rate, way * (twice * rate**2 + by * second))


class Profile(NamedTuple):
    """A path's parameter over time; times of the nodes, s, (n,), from 0.

    ease: the parameter as a function of that of the phase plane; None: they are the same.
    """

    phase: PhasePath
    times: Array
    ease: Ease | None = None

    @classmethod
    def of(cls, phase: PhasePath, ease: Ease | None = None) -> Profile:
        """The profile of a path in the phase plane."""
        return cls(phase, np.concatenate([[0.0], np.cumsum(durations(phase))]), ease)

    @property
    def nodes(self) -> Place:
        """s, s' and s'' at the nodes."""
        return self._eased(self.phase.s, np.sqrt(self.phase.x), self.second)

    def slowed(self, share: float) -> Profile:
        """The same with all rates multiplied by a share."""
        phase = self.phase
        squared = {name: share**2 * getattr(phase, name) for name in ("x", "first", "last")}
        return Profile.of(phase._replace(**squared), self.ease)

    def _eased(self, x: Array, rate: Array, second: Array) -> Place:
        return Place(x, rate, second) if self.ease is None else self.ease(x, rate, second)

    @property
    def duration(self) -> float:
        """Duration of the whole path, s."""
        return float(self.times[-1])

    @property
    def second(self) -> Array:
        """s'' at the nodes, at the start of the cell after each."""
        return np.append(self.phase.first, self.phase.last[-1])

    def at(self, times: Array) -> Place:
        """s, s' and s'' at times from 0 to the duration, s."""
        phase = self.phase
        cell = np.clip(np.searchsorted(self.times, times, side="right") - 1, 0, len(phase.first) - 1)
        tau = times - self.times[cell]
        slope = ((phase.last - phase.first) / np.diff(phase.s))[cell]
        rate, second = np.sqrt(phase.x[cell]), phase.first[cell]
        cosine, sine, lift = _exponentials(slope * tau**2)
        moved = rate * tau * sine + second * tau**2 * lift
        moved = np.clip(moved, 0.0, np.diff(phase.s)[cell])
        # Rounding makes no motion turn back where it ends: friction would be that of the other way.
        rate = np.maximum(rate * cosine + second * tau * sine, 0.0)
        return self._eased(phase.s[cell] + moved, rate, second + slope * moved)

    def inside(self, shares: Array) -> tuple[Array, Array, Array]:
        """s, s'^2 and s'' at shares of every cell, (cells, shares)."""
        phase, h = self.phase, np.diff(self.phase.s)[:, None]
        slope = (phase.last - phase.first)[:, None] / h
        step = h * shares
        second = phase.first[:, None] + slope * step
        square = phase.x[:-1, None] + (phase.first[:, None] + second) * step
        place = self._eased(phase.s[:-1, None] + step, np.sqrt(np.maximum(square, 0.0)), second)
        return place.s, place.rate**2, place.second


def durations(phase: PhasePath) -> Array:
    """Time of each cell, s: 2 artanh(sqrt(c) h / (s'_0 + s'_1)) / sqrt(c), c the slope of s'' in s."""
    h, rate = np.diff(phase.s), np.sqrt(phase.x)
    plain = 2.0 * h / (rate[:-1] + rate[1:])
    y = (phase.last - phase.first) * h / (rate[:-1] + rate[1:]) ** 2
    root = np.sqrt(np.abs(y))
    safe = np.where(root > 0.0, root, 1.0)
    with np.errstate(invalid="ignore"):
        curved = np.where(y > 0.0, np.arctanh(np.minimum(safe, 1.0 - 1e-15)), np.arctan(safe)) / safe
    return np.asarray(plain * np.where(root > 1e-4, curved, 1.0 + y / 3.0))


def _exponentials(y: Array) -> tuple[Array, Array, Array]:
    """cosh(r), sinh(r) / r and (cosh(r) - 1) / r^2 of r^2 = y; cosines and sines where y < 0."""
    root = np.sqrt(np.abs(y))
    safe = np.where(root > 1e-4, root, 1.0)
    half = 0.5 * safe
    cosine = np.where(y > 0.0, np.cosh(root), np.cos(root))
    sine = np.where(y > 0.0, np.sinh(safe), np.sin(safe)) / safe
    lift = 0.5 * (np.where(y > 0.0, np.sinh(half), np.sin(half)) / half) ** 2
    small = root <= 1e-4
    return cosine, np.where(small, 1.0 + y / 6.0, sine), np.where(small, 0.5 + y / 24.0, lift)
