"""Dense samples of a plan: inside the grid cells, on both sides of nodes and turning points, and at rest."""

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
"""Samples in each grid cell at which limits are checked."""

BLOCK = 1 << 14
"""Number of samples that are evaluated together."""

# Both ends of a cell are included, because accelerations jump there.
_SHARES = np.concatenate([[0.0], (np.arange(FINER) + 0.5) / FINER, [1.0]])
# Bisections of a step between two samples, few enough that leg rates exceed rounding errors.
_BISECTIONS = 30


class Places(NamedTuple):
    """Samples of a plan in order: times (s), parameters s, s'^2, and s'', shape (n,).

    Attributes
    ----------
    sides : ndarray, shape (n, 6)
        Signs of the leg rates on the chosen side of each sample; 0 for legs at rest.
    """

    time: Array
    s: Array
    square: Array
    second: Array
    sides: Array

    def blocks(self) -> Iterator["Places"]:
        """Yield blocks of samples."""
        for i in range(0, len(self.s), BLOCK):
            yield Places(*(part[i : i + BLOCK] for part in self))

    def motion(self, plan: TimedPath) -> Motion:
        """Return the motion of the plan at the samples, shape (n,)."""
        return traveled(plan.path(self.s), np.sqrt(self.square), self.second)

    def motors(self, plan: TimedPath, motion: Motion, F: Array, L_dot: Array) -> MotorStates:
        """Compute the motor states from motion, forces (N), and leg rates (m/s), shape (n, 6) each."""
        assert plan.robot.drive is not None
        return motor_states(plan.robot, plan.robot.drive, motion, F, L_dot, self.sides)


def places_along(plan: TimedPath) -> Places:
    """Return ``FINER`` samples in each cell of a plan, both sides of nodes and turning points, and both ends.

    Accelerations jump at a node. The friction of a leg jumps at its turning point.
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
    """Return the samples of a plan at times (s), shape (n,), on one side each."""
    place = plan.profile.at(times)
    return Places(times, place.s, place.rate**2, place.second, np.sign(_leg_rates(plan, place.s)))


def _turning_points(plan: TimedPath, time: Array, sides: Array) -> list[Places]:
    """Return samples just before and after the turning points of legs inside cells; [] without any.

    Parameters
    ----------
    plan : TimedPath
        Path and parameter over time.
    time : ndarray, shape (cells, k)
        Times of the samples (s).
    sides : ndarray, shape (cells, k, 6)
        Signs of the leg rates at the samples.
    """
    cell, k, leg = np.nonzero(sides[:, :-1] * sides[:, 1:] < 0.0)
    if not len(leg):
        return []
    low, high, before = time[cell, k], time[cell, k + 1], sides[cell, k, leg]
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        rate = _leg_rates(plan, plan.profile.at(middle).s)[np.arange(len(leg)), leg]
        same = rate * before > 0.0
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return [places_at(plan, np.concatenate([low, high]))]


def _leg_rates(plan: TimedPath, s: Array) -> Array:
    """Compute the derivatives of the leg lengths with respect to s (m), shape (n, 6)."""
    parts = [
        inverse_kinematics(plan.robot, plan.path(s[i : i + BLOCK])).L_dot for i in range(0, len(s), BLOCK)
    ]
    return np.concatenate(parts)
