"""Parameter over time: in each cell s'' is linear in s, so s, s' and s'' are sums of exponentials of time."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..io.array_types import Array
from .phase_plane import PhasePath


class Place(NamedTuple):
    """s, s' and s'' at some instants, (n,) each."""

    s: Array
    rate: Array
    second: Array


class Profile(NamedTuple):
    """A path's parameter over time; times of the nodes, s, (n,), from 0."""

    phase: PhasePath
    times: Array

    @classmethod
    def of(cls, phase: PhasePath) -> Profile:
        """The profile of a path in the phase plane."""
        return cls(phase, np.concatenate([[0.0], np.cumsum(durations(phase))]))

    @property
    def duration(self) -> float:
        """Of the whole path, s."""
        return float(self.times[-1])

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
        return Place(phase.s[cell] + moved, rate * cosine + second * tau * sine, second + slope * moved)

    def inside(self, shares: Array) -> tuple[Array, Array, Array]:
        """s, s'^2 and s'' at shares of every cell, (cells, shares)."""
        phase, h = self.phase, np.diff(self.phase.s)[:, None]
        slope = (phase.last - phase.first)[:, None] / h
        step = h * shares
        second = phase.first[:, None] + slope * step
        square = phase.x[:-1, None] + (phase.first[:, None] + second) * step
        return phase.s[:-1, None] + step, np.maximum(square, 0.0), second


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
