"""Smooth motions along a path within limits: least time, or least energy or peak force in a given time.

The path parameter is eased, s = s(x), so that rest at the ends does not require x' = 0; y = x'^2 is a
quadratic spline. Every limited quantity is a sum of terms in y, dy/dx, sqrt(y), and, for jerk, d2y/dx2.
"""

import functools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...io.array_types import Array
from ...kinematics.inverse_kinematics import inverse_kinematics
from ...motion.motion import Motion
from ...robot.robot import LEGS, Robot
from ..timing.grid import Source
from ..timing.motor_terms import beside
from ..timing.path_terms import Path, Terms, leg_accelerations, traveled
from ..timing.phase_plane import Ease, Profile
from .costs import PeakCost
from .rate_spline import PARTS, Cost, RateSpline, Rooms, duration, in_cells, least

Shown = Callable[[float], None]
"""Function that is called with the completed fraction of a search."""

_ROUNDS = 12
_MARGIN = 5e-5
_MORE = 1.2
# Largest utilization of a limit at the checked positions between the samples.
_AIM = 1.0 - 2e-5
_BETWEEN = np.linspace(0.0, 1.0, 201)
_TURNS = 3
_ROOM, _SLOWER = 0.9, 0.9
_SLOWEST = 1e-6
_STEP = 1e-5
_NEARER = 0.01
# Successive values of the sharpness in the minimization of the peak force.
_SHARPER = (30.0, 100.0, 300.0, 1000.0)


@dataclass(frozen=True, eq=False)
class SmoothPath:
    """Terms of an eased path at the samples and in between, and jerk limits of the legs (m/s^3), shape (6,).

    Attributes
    ----------
    legs : tuple of ndarray
        First to third derivatives of the leg lengths by x at the samples and in between, shape (3, n, 6)
        each.
    places : ndarray, shape (n,)
        Parameters s in between.
    """

    spline: RateSpline
    nodes: Array
    ease: Ease
    at: Terms
    between: Terms
    legs: tuple[Array, Array]
    jerk: Array
    places: Array

    @classmethod
    def of(
        cls, source: Source, lengths: Callable[[Array], Array], ease: Ease, cells: int, jerk: Array
    ) -> "SmoothPath":
        """Create the path from the source of its terms and from the function of its length rates."""
        spline = RateSpline(cells)
        nodes = np.linspace(0.0, 1.0, PARTS * cells + 1)
        fine = (spline.edges[:-1, None] + _BETWEEN / cells).ravel()
        places = ease(fine, fine, fine).s
        each = (lengths(nodes), lengths(fine))
        return cls(spline, nodes, ease, source(nodes), source(fine), each, jerk, places)

    def profile(self, c: Array) -> Profile:
        """Return the motion of given coefficients."""
        return Profile.of(self.spline.phase(c), self.ease)

    @np.errstate(invalid="ignore")
    def used(self, c: Array) -> Array:
        """Compute the utilization of the limits in every cell, shape (cells, m), jerk last.

        It is NaN if the spline is negative in a cell.
        """
        v = self.spline.values(c, _BETWEEN)
        parts = [self.between.used(v[..., 0], 0.5 * v[..., 1])]
        if np.isfinite(self.jerk).any():
            jerk = np.abs(_jerk(self.legs[1], v.reshape(-1, 3))) / self.jerk
            parts.append(jerk.reshape(*v.shape[:2], -1))
        return np.asarray(np.concatenate(parts, axis=-1).max(axis=1))

    def rooms(self, c: Array, margin: Array) -> Rooms:
        """Return the limits at the samples minus a margin, shape (4 cells + 1, m).

        Friction is evaluated at the rates of c.
        """
        v = self.spline.values(c)
        rate = np.sqrt(np.append(v[:, :-1, 0].ravel(), v[-1, -1, 0]))
        room, count = 1.0 - margin, self.at.quantities
        second = 0.5 * np.append(v[:, :-1, 1].ravel(), v[-1, -1, 1])
        rows = self.at.rows(rate, second, room[:, :count], beside(self.at.signs)[1])
        a, b, d, e = rows.form_at(rate**2, second)
        zero, parts = np.zeros_like(a), []
        for sign, bound in ((1.0, rows.high), (-1.0, rows.low)):
            k = np.stack([bound - e, -d, zero, -b, -0.5 * a, zero], axis=-1)
            parts.append(_bounded(sign * k, bound))
        speed = np.zeros((len(rate), 1, 6))
        speed[:, 0, 0], speed[:, 0, 3] = 1.0, -1.0 / (self.at.caps * room[:, count - 1] ** 2)
        parts.append(speed)
        if np.isfinite(self.jerk).any():
            L_1, L_2, L_3 = self.legs[0]
            limit = self.jerk * room[:, count:]
            none = np.zeros_like(L_1)
            for sign in (1.0, -1.0):
                k = np.stack([none, none, limit, sign * L_3, sign * 1.5 * L_2, sign * 0.5 * L_1], axis=-1)
                parts.append(_bounded(k, limit))
        k = np.concatenate(parts, axis=1)
        return Rooms(in_cells(k))

    def fastest(self, shown: Shown) -> Array:
        """Compute the coefficients of least time."""
        c = np.ones(self.spline.cells + 2)
        free = float(self._free().min())
        while c[0] > _SLOWEST and self.used(c).max() > 1.0 - (1.0 - _ROOM) * free:
            c = _SLOWER * c
        return self._settled(c, functools.partial(duration, self.spline), None, shown)

    def _free(self) -> Array:
        """Return the remaining part of each limit after the static load in every cell, (cells, m)."""
        held = self.between.held()
        if np.isfinite(self.jerk).any():
            held = np.concatenate([held, np.zeros_like(self.legs[1][0])], axis=-1)
        most = held.reshape(self.spline.cells, len(_BETWEEN), -1).max(axis=1)
        return np.asarray(np.maximum(1.0 - most, 0.0))

    def cheapest(self, cost: Cost, start: Array, time: float, shown: Shown) -> Array:
        """Compute the coefficients of least cost in a duration, from a faster motion."""
        return self._settled(self._lasting(start, time), cost, time, shown)

    def gentlest(self, start: Array, time: float, shown: Shown) -> Array:
        """Compute the coefficients of least peak force in a duration, from a faster motion."""
        c = start = self._lasting(start, time)
        for turn, sharpness in enumerate(_SHARPER):
            cost = PeakCost.of(self.at, self.spline.values(start), self.spline.values(c), sharpness)

            def part(share: float, turn: int = turn) -> None:
                shown((turn + share) / len(_SHARPER))

            c = self.cheapest(cost, c, time, part)
        return c

    def _settled(self, c: Array, cost: Cost, time: float | None, shown: Shown) -> Array:
        """Compute the coefficients of least cost that are also within the limits between the samples."""
        most = _ROOM * _beside(self._free(), np.minimum)
        margin = np.minimum(_MARGIN, most)
        turns, start = (1 if self.at.motors is None else _TURNS), c
        for turn in range(_ROUNDS):
            shown(turn / _ROUNDS)
            rooms = self.rooms(c, margin)
            # The search starts far within the limits; with a given duration, at a motion of this duration.
            begin = self._slowed(_ROOM * c if time is None else start, rooms)
            c = least(self.spline, begin, rooms, cost, time)
            excess = np.maximum(self.used(c) - _AIM, 0.0)
            # The spline may be negative between the samples if the motion nearly stops.
            stops = time is not None and bool(np.isnan(excess).any())
            if stops or (turn >= turns and excess.max() <= 0.5 * (1.0 - _AIM)):
                break
            if turn + 1 >= turns:
                # In earlier rounds the excess is due to friction at the rates of another motion.
                margin = np.minimum(margin + _MORE * _beside(excess, np.maximum), most)
        return c if time is None else self._between(start, c, time)

    def _lasting(self, c: Array, time: float) -> Array:
        """Scale the coefficients of a motion to a duration."""
        return np.asarray(c * (duration(self.spline, self.spline.values(c))[0] / time) ** 2)

    def _between(self, start: Array, c: Array, time: float) -> Array:
        """Return the blend closest to c, toward a motion far within the limits, that satisfies the limits."""
        share = 0.0
        while share < 1.0:
            found = self._lasting((1.0 - share) * c + share * start, time)
            if self.used(found).max() <= 0.5 * (1.0 + _AIM):
                return found
            share += _NEARER
        return start

    def _slowed(self, c: Array, rooms: Rooms) -> Array:
        """Scale the coefficients down until all limits are satisfied."""
        share = 1.0
        while share > _SLOWEST:
            if rooms.values(self.spline.values(share * c)).min() > 0.0:
                return share * c
            share *= _SLOWER
        used = self.used(share * c)
        cell, k = np.unravel_index(int(np.argmax(used)), used.shape)
        names = (*self.at.all_names, *(f"jerk of leg {leg + 1}" for leg in range(LEGS)))
        where = self.places[cell * len(_BETWEEN)]
        raise ValueError(
            f"limits: no slow and smooth motion within the limits was found: {names[k]} is "
            f"{used[cell, k]:.4g} times its limit near s = {where:.6g} of the path"
        )


def _beside(cells: Array, of_two: np.ufunc) -> Array:
    """Expand values of cells, (cells, m), to the samples, (4 cells + 1, m), combining both sides of edges."""
    found = np.concatenate([np.repeat(cells, PARTS, axis=0), cells[-1:]])
    found[PARTS:-1:PARTS] = of_two(cells[:-1], cells[1:])
    return found


def _bounded(k: Array, limit: Array) -> Array:
    """Divide rows by their limits, and remove quantities without a limit; single unbounded rows become 1."""
    kept = np.isfinite(limit).any(axis=0)
    k, limit = k[:, kept], limit[:, kept]
    none = ~np.isfinite(limit)
    scaled = k / np.where(none, 1.0, np.abs(limit))[..., None]
    scaled[none] = (1.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    return np.asarray(scaled)


def eased(path: Path, ease: Ease) -> Path:
    """Return the path as a function of the eased parameter."""

    def by_x(x: Array) -> Motion:
        s, rate, second = ease(x, np.ones_like(x), np.zeros_like(x))
        return traveled(path(s), rate, second)

    return by_x


def length_rates(robot: Robot, path: Path, x: Array) -> Array:
    """Compute first to third derivatives of the leg lengths by the eased parameter, shape (3, n, 6)."""

    middle = np.clip(x, _STEP, 1.0 - _STEP)
    before, at, after = (leg_accelerations(robot, path(middle + step)) for step in (-_STEP, 0.0, _STEP))
    # Parabola through three points: one-sided derivatives at the ends, central ones elsewhere.
    bend = ((x - middle) / _STEP**2)[:, None] * (after - 2.0 * at + before)
    legs = inverse_kinematics(robot, path(x))
    assert legs.L_ddot is not None
    return np.stack([legs.L_dot, legs.L_ddot, 0.5 * (after - before) / _STEP + bend])


def _jerk(legs: Array, v: Array) -> Array:
    """Compute the third derivatives of the leg lengths by time (m/s^3), shape (n, 6)."""
    y, y_1, y_2 = v.T[..., None]
    L_1, L_2, L_3 = legs
    return np.asarray(np.sqrt(y) * (L_3 * y + 1.5 * L_2 * y_1 + 0.5 * L_1 * y_2))
