"""Smooth motions along a path within limits: least time; least energy or peak force in a given time.

The path's parameter is eased, s = s(x), so that rest at the ends needs no rate 0 of x; y = x'^2 is a
quadratic spline. Every limited quantity is then a sum of y, dy/dx, sqrt(y) and, for jerk, d2y/dx2.
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
"""Called with the share of a search that is done."""

_ROUNDS = 12
_MARGIN = 5e-5
_MORE = 1.2
# Largest share of a limit at the places between the samples that are checked.
_AIM = 1.0 - 2e-5
_BETWEEN = np.linspace(0.0, 1.0, 201)
_TURNS = 3
_ROOM, _SLOWER = 0.9, 0.9
_SLOWEST = 1e-6
_STEP = 1e-5
_NEARER = 0.01
# Sharpness of the costs by which the least peak force is found, one after another.
_SHARPER = (30.0, 100.0, 300.0, 1000.0)


@dataclass(frozen=True, eq=False)
class SmoothPath:
    """Terms of an eased path at samples and between; jerk: limits of the legs', m/s^3, (6,), or infinite.

    legs: first to third derivatives of the lengths by x at samples, then between, (3, n, 6) each. places: s
    between.
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
        """A path by the source of its terms and ``lengths``, x -> derivatives of the legs' lengths by x."""
        spline = RateSpline(cells)
        nodes = np.linspace(0.0, 1.0, PARTS * cells + 1)
        fine = (spline.edges[:-1, None] + _BETWEEN / cells).ravel()
        places = ease(fine, fine, fine).s
        each = (lengths(nodes), lengths(fine))
        return cls(spline, nodes, ease, source(nodes), source(fine), each, jerk, places)

    def profile(self, c: Array) -> Profile:
        """The motion of coefficients."""
        return Profile.of(self.spline.phase(c), self.ease)

    @np.errstate(invalid="ignore")
    def used(self, c: Array) -> Array:
        """Compute the used shares of the limits in every cell, (cells, m): of the terms, then of jerk.

        NaN if the spline is below 0 in a cell.
        """
        v = self.spline.values(c, _BETWEEN)
        parts = [self.between.used(v[..., 0], 0.5 * v[..., 1])]
        if np.isfinite(self.jerk).any():
            jerk = np.abs(_jerk(self.legs[1], v.reshape(-1, 3))) / self.jerk
            parts.append(jerk.reshape(*v.shape[:2], -1))
        return np.asarray(np.concatenate(parts, axis=-1).max(axis=1))

    def rooms(self, c: Array, margin: Array) -> Rooms:
        """Limits at the samples, less a margin, (4 cells + 1, m), friction as at the rates of c."""
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
        """Coefficients of least time."""
        c = np.ones(self.spline.cells + 2)
        free = float(self._free().min())
        while c[0] > _SLOWEST and self.used(c).max() > 1.0 - (1.0 - _ROOM) * free:
            c = _SLOWER * c
        return self._settled(c, functools.partial(duration, self.spline), None, shown)

    def _free(self) -> Array:
        """Shares of the limits that holding the machine leaves for a motion in every cell, (cells, m)."""
        held = self.between.held()
        if np.isfinite(self.jerk).any():
            held = np.concatenate([held, np.zeros_like(self.legs[1][0])], axis=-1)
        most = held.reshape(self.spline.cells, len(_BETWEEN), -1).max(axis=1)
        return np.asarray(np.maximum(1.0 - most, 0.0))

    def cheapest(self, cost: Cost, start: Array, time: float, shown: Shown) -> Array:
        """Coefficients of least cost in a duration, from those of a faster motion."""
        return self._settled(self._lasting(start, time), cost, time, shown)

    def gentlest(self, start: Array, time: float, shown: Shown) -> Array:
        """Coefficients of least peak force in a duration, from those of a faster motion."""
        c = start = self._lasting(start, time)
        for turn, sharpness in enumerate(_SHARPER):
            cost = PeakCost.of(self.at, self.spline.values(start), self.spline.values(c), sharpness)

            def part(share: float, turn: int = turn) -> None:
                shown((turn + share) / len(_SHARPER))

            c = self.cheapest(cost, c, time, part)
        return c

    def _settled(self, c: Array, cost: Cost, time: float | None, shown: Shown) -> Array:
        """Coefficients of least cost that keep all limits between the samples too."""
        most = _ROOM * _beside(self._free(), np.minimum)
        margin = np.minimum(_MARGIN, most)
        turns, start = (1 if self.at.motors is None else _TURNS), c
        for turn in range(_ROUNDS):
            shown(turn / _ROUNDS)
            rooms = self.rooms(c, margin)
            # The search begins far within the limits; for a given duration at a motion that takes as long.
            begin = self._slowed(_ROOM * c if time is None else start, rooms)
            c = least(self.spline, begin, rooms, cost, time)
            excess = np.maximum(self.used(c) - _AIM, 0.0)
            # Nearly at a stop the spline may be below 0 between the samples.
            stops = time is not None and bool(np.isnan(excess).any())
            if stops or (turn >= turns and excess.max() <= 0.5 * (1.0 - _AIM)):
                break
            if turn + 1 >= turns:
                # Before, what is too much is of friction at the rates of another motion.
                margin = np.minimum(margin + _MORE * _beside(excess, np.maximum), most)
        return c if time is None else self._between(start, c, time)

    def _lasting(self, c: Array, time: float) -> Array:
        """Coefficients of the same motion, slower or faster, that takes a time."""
        return np.asarray(c * (duration(self.spline, self.spline.values(c))[0] / time) ** 2)

    def _between(self, start: Array, c: Array, time: float) -> Array:
        """Coefficients as near to c as limits allow, toward those of a motion far within them."""
        share = 0.0
        while share < 1.0:
            found = self._lasting((1.0 - share) * c + share * start, time)
            if self.used(found).max() <= 0.5 * (1.0 + _AIM):
                return found
            share += _NEARER
        return start

    def _slowed(self, c: Array, rooms: Rooms) -> Array:
        """Coefficients, slowed until all limits are kept."""
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
            f"limits: expected limits that some slow and smooth motion keeps, none was found: {names[k]} is "
            f"{used[cell, k]:.4g} times its limit near s = {where:.6g} of the path"
        )


def _beside(cells: Array, of_two: np.ufunc) -> Array:
    """Values of cells, (cells, m), at the samples, (4 cells + 1, m): at an edge that of both sides."""
    found = np.concatenate([np.repeat(cells, PARTS, axis=0), cells[-1:]])
    found[PARTS:-1:PARTS] = of_two(cells[:-1], cells[1:])
    return found


def _bounded(k: Array, limit: Array) -> Array:
    """Rows over their limits, without those that no limit bounds anywhere; one that does not bound is 1."""
    kept = np.isfinite(limit).any(axis=0)
    k, limit = k[:, kept], limit[:, kept]
    none = ~np.isfinite(limit)
    scaled = k / np.where(none, 1.0, np.abs(limit))[..., None]
    scaled[none] = (1.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    return np.asarray(scaled)


def eased(path: Path, ease: Ease) -> Path:
    """The path by the parameter of an ease."""

    def by_x(x: Array) -> Motion:
        s, rate, second = ease(x, np.ones_like(x), np.zeros_like(x))
        return traveled(path(s), rate, second)

    return by_x


def length_rates(robot: Robot, path: Path, x: Array) -> Array:
    """First to third derivatives of the legs' lengths by the parameter of an eased path, (3, n, 6)."""

    middle = np.clip(x, _STEP, 1.0 - _STEP)
    before, at, after = (leg_accelerations(robot, path(middle + step)) for step in (-_STEP, 0.0, _STEP))
    # Through three points: at the ends the derivative there, elsewhere at the middle one.
    bend = ((x - middle) / _STEP**2)[:, None] * (after - 2.0 * at + before)
    legs = inverse_kinematics(robot, path(x))
    assert legs.L_ddot is not None
    return np.stack([legs.L_dot, legs.L_ddot, 0.5 * (after - before) / _STEP + bend])


def _jerk(legs: Array, v: Array) -> Array:
    """Third derivatives of the lengths by time, m/s^3, (n, 6)."""
    y, y_1, y_2 = v.T[..., None]
    L_1, L_2, L_3 = legs
    return np.asarray(np.sqrt(y) * (L_3 * y + 1.5 * L_2 * y_1 + 0.5 * L_1 * y_2))
