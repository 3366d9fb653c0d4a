"""Conditions that stop a simulation: leg limits, singular poses, and joint singularities."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..io.arguments import number_in
from ..io.array_types import Array, Flags
from ..kinematics.clearance import angles_from, neutral_directions
from ..kinematics.conditioning import condition_number
from ..kinematics.inverse_kinematics import joint_sines
from ..kinematics.pose_search import platform_size
from ..motion.motion import Motion
from ..motion.rotation import cross
from ..robot.robot import Robot
from ..robot.units import Units
from .actuator_models import LegStates, leg_states
from .state_history import WATCHED, Actuators, Piece, StopEvent, motion_of

NEAR_SINGULAR, CROSSING = 48, 49
"""Columns of the margins for the condition number of H and for the sign of det H relative to the start."""


@dataclass(frozen=True)
class StopConditions:
    """Limits of the model at which a simulation stops, in addition to the limits of the robot.

    Attributes
    ----------
    max_condition : float, optional
        Largest scaled condition number of H (see ``scaled_condition_number``), > 1. With inf the simulation
        continues through singular poses.
    min_length : float, optional
        Smallest leg length (m), > 0; by default a thousandth of the characteristic length of the robot.
    min_joint_sine : float, optional
        Smallest sine of the angle between a leg and the fixed axis of its universal joint, between 0 and 1.

    Raises
    ------
    ValueError
        If a value is outside its range.
    """

    max_condition: float = 1e6
    min_length: float | None = None
    min_joint_sine: float = 1e-3

    def __post_init__(self) -> None:
        """Check each value."""
        ranges = {
            "max_condition": (1.0, math.inf),
            "min_length": (0.0, math.inf),
            "min_joint_sine": (0.0, 1.0),
        }
        for name, (low, high) in ranges.items():
            value = getattr(self, name)
            through = name == "max_condition" and isinstance(value, float) and value == math.inf
            if value is not None and not through:
                need_between(value, name, low, high)


@dataclass(frozen=True, eq=False)
class Watch:
    """Margins of all stop conditions; a margin is positive while its condition is satisfied."""

    robot: Robot
    thresholds: StopConditions
    # Infinite if forces are clipped (N), (6,).
    force_limit: Array
    # Sign of det H at the start.
    side: float

    def first(self, pieces: Sequence[Piece], actuators: Actuators) -> tuple[int, StopEvent] | None:
        """Return the first stop event in consecutive pieces with the index of its piece, or None."""
        starts, ends = ([getattr(piece, name) for piece in pieces] for name in ("start", "end"))
        when = np.linspace(starts, ends, WATCHED + 1, axis=-1)
        below = self._margins(when, pieces, actuators) <= 0.0
        if not below.any():
            return None
        i = int(np.argmax(below.any(axis=(1, 2))))
        return i, self._first_in(pieces[i], when[i], below[i], actuators)

    def _first_in(self, piece: Piece, when: Array, below: Flags, actuators: Actuators) -> StopEvent:
        """Return the first stop event in a piece; ``below`` marks its margins at some times (s)."""
        roots = []
        for row in np.flatnonzero(below.any(axis=0)).tolist():
            i = int(np.argmax(below[:, row]))
            start = float(when[max(i - 1, 0)])
            time = start if i == 0 else self._root(row, start, float(when[i]), piece, actuators)
            if row == CROSSING:
                # The condition number exceeds its limit too briefly to be detected itself.
                time = self._root(NEAR_SINGULAR, start, time, piece, actuators)
            roots.append((time, row))
        return self._stop(*min(roots), piece, actuators)

    def _root(self, row: int, start: float, end: float, piece: Piece, actuators: Actuators) -> float:
        """Return the time (s) at which a margin becomes zero, or an end of the span without a zero."""
        from scipy.optimize import brentq

        def margin(time: float) -> float:
            return float(self._margins(np.array([[time]]), [piece], actuators)[0, 0, row])

        if not margin(start) > 0.0:
            return start
        if margin(end) > 0.0:
            return end
        return float(brentq(margin, start, end, xtol=1e-14 * max(end, 1.0), rtol=1e-14))

    def _margins(self, when: Array, pieces: Sequence[Piece], actuators: Actuators) -> Array:
        """Compute the margins at k times (s), (n, k), in each of n pieces, shape (n, k, 50).

        Six columns each: minimum length, maximum length, speed, force, zero length, joint sine, base joint
        angle, and platform joint angle. The last two columns: condition number and sign of det H.
        """
        robot = self.robot
        k = when.shape[1]
        y = np.concatenate([piece.interpolant(at).T for piece, at in zip(pieces, when, strict=True)])
        state = motion_of(y)
        legs = leg_states(robot, state)
        F = np.zeros((when.size, 6))
        if np.isfinite(self.force_limit).any():
            parts = (state[i : i + k] for i in range(0, when.size, k))
            each = zip(when, parts, (piece.sampled for piece in pieces), strict=True)
            F = np.concatenate([actuators.forces(*given) for given in each])
        shortest = self.thresholds.min_length or 1e-3 * platform_size(robot)
        margins = [
            legs.L - np.where(robot.length_limits[:, 0] > 0.0, robot.length_limits[:, 0], -math.inf),
            robot.length_limits[:, 1] - legs.L,
            robot.speed_limit - np.abs(legs.L_dot),
            self.force_limit - np.abs(F),
            legs.L - shortest,
            (joint_sines(robot, legs.s) if legs.sine is None else legs.sine) - self.thresholds.min_joint_sine,
            *(robot.joint_angle_limit.T[:, None] - self._angles(legs, state)),
            *self._singular_margins(legs),
        ]
        return np.concatenate(margins, axis=-1).reshape(*when.shape, -1)

    def _angles(self, legs: LegStates, state: Motion) -> Array:
        """Return joint angles at base and platform (rad), shape (2, n, 6); 0 without angle limits."""
        if not self.robot.has_joint_angle_limits:
            return np.zeros((2, *legs.L.shape))
        return np.stack(angles_from(self._neutral, legs.s, state.R))

    @cached_property
    def _neutral(self) -> Array:
        return neutral_directions(self.robot)

    def _singular_margins(self, legs: LegStates) -> tuple[Array, Array]:
        """Compute the margins of the condition number and of the sign of det H, shape (n, 1) each."""
        if self.thresholds.max_condition == math.inf:
            none = np.ones((len(legs.L), 1))
            return none, none
        H = _scaled_H(legs, platform_size(self.robot))
        near = 1.0 / condition_number(H) - 1.0 / self.thresholds.max_condition
        return near[:, None], self.side * np.linalg.det(H)[:, None]

    def _stop(self, time: float, row: int, piece: Piece, actuators: Actuators) -> StopEvent:
        """Create the stop event for a column of the margins at a time (s)."""
        robot, leg = self.robot, row % 6
        at = np.array([time])
        state = motion_of(piece.interpolant(at).T)
        legs = leg_states(robot, state)
        units = Units.of(robot)
        unit, turn = units.length, units.angle
        low, high = robot.length_limits[leg] / units.meters
        speed, fastest = legs.L_dot[0, leg] / units.meters, robot.speed_limit[leg] / units.meters
        length = f"{legs.L[0, leg] / units.meters:.6g} {unit}"
        angles = np.array([self._angles(legs, state)[:, 0, leg], robot.joint_angle_limit[leg]]).T
        if row >= NEAR_SINGULAR:
            condition = condition_number(_scaled_H(legs, platform_size(robot)))[0]
            text = f"condition number of H reaches {condition:.4g} at {time:.9g} s"
            return StopEvent("singular", time, None, f"near a singular pose: {text}")
        (base, most_b), (tip, most_p) = angles / units.radians
        F = actuators.forces(at, state, piece.sampled)[0, leg]
        kind, text = (
            ("length_limits", f"length {length} reaches its lower limit {low:g} {unit}"),
            ("length_limits", f"length {length} reaches its upper limit {high:g} {unit}"),
            ("speed_limit", f"speed {speed:.6g} {unit}/s reaches its limit {fastest:g} {unit}/s"),
            ("force_limit", f"force {F:.6g} N reaches its limit {robot.force_limit[leg]:g} N"),
            ("zero_length", f"length {length} is near zero"),
            ("joint_singularity", "is nearly parallel to the fixed axis of its universal joint"),
            (
                "joint_angle_limit",
                f"joint angle at the base {base:.6g} {turn} reaches its limit {most_b:g} {turn}",
            ),
            (
                "joint_angle_limit",
                f"joint angle at the platform {tip:.6g} {turn} reaches its limit {most_p:g} {turn}",
            ),
        )[row // 6]
        return StopEvent(kind, time, leg + 1, f"leg {leg + 1}: {text} at {time:.9g} s")


def _scaled_H(legs: LegStates, size: float) -> Array:
    """Return H^T with its moments divided by a length (m), shape (..., 6, 6)."""
    if legs.H is not None:
        return np.asarray(np.swapaxes(legs.H, -1, -2) / np.repeat([1.0, size], 3))
    return np.concatenate([legs.s, cross(legs.q, legs.s) / size], axis=-1)


def det_sign(robot: Robot, state: Motion) -> float:
    """Return the sign of det H."""
    return float(np.sign(np.linalg.det(_scaled_H(leg_states(robot, state), platform_size(robot)))))


def need_between(value: object, name: str, low: float, high: float) -> None:
    """Raise ValueError unless a value is a number strictly between two others."""
    text = f"a number > {low:g}" + (f" and < {high:g}" if math.isfinite(high) else "")
    number_in(value, name, text, low, high)
