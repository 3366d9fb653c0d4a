"""Places along a plan, finer than its grid, from both sides of every node and turning point, and at rest."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..drives.motor_states import MotorStates, motor_states
from ..io.array_types import Array
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..motion.motion import Motion
from ..robot.robot import LEGS
from .path_parameterization import TimedPath
from .timing.motor_terms import directions
from .timing.path_terms import traveled

FINER = 100
"""Instants in each cell of the plan's grid at which limits are checked."""

BLOCK = 1 << 14
"""Places that are evaluated together."""

# Both ends of a cell, where accelerations jump, are places of it too.
_SHARES = np.concatenate([[0.0], (np.arange(FINER) + 0.5) / FINER, [1.0]])
# Bisections of a step between two places: rates of the legs are still above rounding then.
_BISECTIONS = 30


class Places(NamedTuple):
    """Places along a plan in order: times, s, place s, s'^2 and s'', (n,).

    sides: signs of the rates of the legs on the chosen side, (n, 6); 0 of legs at rest.
    """

    time: Array
    s: Array
    square: Array
    second: Array
    sides: Array

    def blocks(self) -> Iterator["Places"]:
        """Yield the places in parts."""
        for i in range(0, len(self.s), BLOCK):
            yield Places(*(part[i : i + BLOCK] for part in self))

    def motion(self, plan: TimedPath) -> Motion:
        """Return the plan's motion at the places, (n,)."""
        return traveled(plan.path(self.s), np.sqrt(self.square), self.second)

    def motors(self, plan: TimedPath, motion: Motion, F: Array, L_dot: Array) -> MotorStates:
        """Compute the motors' effort at the places from their motion, forces, N, and rates, m/s, (n, 6)."""
        assert plan.robot.drive is not None
        return motor_states(plan.robot, plan.robot.drive, motion, F, L_dot, self.sides)


def places_along(plan: TimedPath) -> Places:
    """Return ``FINER`` places in each cell of a plan, both sides of nodes and turning points, and both rests.

    Accelerations jump at a node. At a turning point of a leg its friction jumps.
    """
    s, square, second = plan.profile.inside(_SHARES)
    time = plan.profile.times_inside(_SHARES)
    sides = directions(_leg_rates(plan, s.ravel()).reshape(*s.shape, LEGS))
    moving = Places(time.ravel(), s.ravel(), square.ravel(), second.ravel(), sides.reshape(-1, LEGS))
    rest = Places(time[[0, -1], [0, -1]], s[[0, -1], [0, -1]], np.zeros(2), np.zeros(2), np.zeros((2, LEGS)))
    start, end = (Places(*(part[i : i + 1] for part in rest)) for i in (0, 1))
    parts = zip(start, moving, *_turning_points(plan, time, sides), end, strict=True)
    found = Places(*(np.concatenate(part) for part in parts))
    order = np.argsort(found.time, kind="stable")
    return Places(*(part[order] for part in found))


def places_at(plan: TimedPath, times: Array) -> Places:
    """Return the places of a plan at times, s, (n,), each from one side alone."""
    place = plan.profile.at(times)
    return Places(times, place.s, place.rate**2, place.second, np.sign(_leg_rates(plan, place.s)))


def _turning_points(plan: TimedPath, time: Array, sides: Array) -> list[Places]:
    """Return the instants before and after which a leg turns back between places of a cell; [] without any.

    time: of the places, s, (cells, k). sides: signs of the rates there, (cells, k, 6).
    """
    cell, k, leg = np.nonzero(sides[:, :-1] * sides[:, 1:] < 0.0)
    if not len(leg):
        return []
    low, high, before = time[cell, k], time[cell, k + 1], sides[cell, k, leg]
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        rate = _leg_rates(plan, plan.profile.at(middle).s)[np.arange(len(leg)), leg]
        low, high = (
            np.where((rate * before > 0.0) == (end == 0), middle, each)
            for end, each in enumerate((low, high))
        )
    return [places_at(plan, np.concatenate([low, high]))]


def _leg_rates(plan: TimedPath, s: Array) -> Array:
    """Return the derivatives of the lengths by s, m, (n, 6)."""
    parts = [
        inverse_kinematics(plan.robot, plan.path(s[i : i + BLOCK])).L_dot for i in range(0, len(s), BLOCK)
    ]
    return np.concatenate(parts)
