"""Where a simulated run stops: limits of the legs, singular poses and joints, watched during each step."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..io.arguments import number_in
from ..io.array_types import Array
from ..kinematics.clearance import angles_from, neutral_directions
from ..kinematics.conditioning import condition_number
from ..kinematics.inverse_kinematics import joint_sines
from ..kinematics.pose_search import platform_size
from ..motion.motion import Motion
from ..motion.rotation import cross
from ..robot.robot import Robot
from .state_history import WATCHED, Actuators, LegStates, Piece, StopEvent, leg_states, motion_of

NEAR_SINGULAR, CROSSING = 48, 49
"""Columns of the watched margins: condition number of H, and det H on the side where the run began."""


@dataclass(frozen=True)
class StopConditions:
    """Where a run stops because the model ends, besides the robot's own limits.

    Attributes
    ----------
    max_condition : float, optional
        Scaled condition number of H (see ``scaled_condition_number``), > 1; inf: a run goes through singular
        poses.
    min_length : float, optional
        Of a leg, m, > 0; None: a thousandth of the machine's characteristic length.
    min_joint_sine : float, optional
        Sine of the angle between a leg and its universal axis, > 0 and < 1.

    Raises
    ------
    ValueError
        Naming the argument.
    """

    max_condition: float = 1e6
    min_length: float | None = None
    min_joint_sine: float = 1e-3

    def __post_init__(self) -> None:
        """Check every threshold."""
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
    """Everything that stops a run, as numbers that are positive while all is well.

    force_limit: N, (6,); inf where forces are clipped instead. side: sign of det H at the start of the run.
    """

    robot: Robot
    thresholds: StopConditions
    force_limit: Array
    side: float

    def first(self, piece: Piece, actuators: Actuators) -> StopEvent | None:
        """The first stop in a piece, None if there is none."""
        when = np.linspace(piece.start, piece.end, WATCHED + 1)
        margins = self._margins(when, piece, actuators)
        below = margins <= 0.0
        if not below.any():
            return None
        roots = []
        for row in np.flatnonzero(below.any(axis=0)).tolist():
            i = int(np.argmax(below[:, row]))
            start = float(when[max(i - 1, 0)])
            time = start if i == 0 else self._root(row, start, float(when[i]), piece, actuators)
            if row == CROSSING:
                # The condition number passes its threshold on the way, too shortly to be seen itself.
                time = self._root(NEAR_SINGULAR, start, time, piece, actuators)
            roots.append((time, row))
        return self._stop(*min(roots), piece, actuators)

    def _root(self, row: int, start: float, end: float, piece: Piece, actuators: Actuators) -> float:
        """Where a margin comes to zero; an end of the span where it doesn't within."""
        from scipy.optimize import brentq

        def margin(time: float) -> float:
            return float(self._margins(np.array([time]), piece, actuators)[0, row])

        if not margin(start) > 0.0:
            return start
        if margin(end) > 0.0:
            return end
        return float(brentq(margin, start, end, xtol=1e-14 * max(end, 1.0), rtol=1e-14))

    def _margins(self, when: Array, piece: Piece, actuators: Actuators) -> Array:
        """(n, 50): six each of shortest, longest, speed, force, length zero, joint sine, angle at the base.

        Six of angle at the platform; condition, side of H.
        """
        robot = self.robot
        state = motion_of(piece.interpolant(when).T, piece.center)
        legs = leg_states(robot, state)
        F = np.zeros((len(when), 6))
        if np.isfinite(self.force_limit).any():
            F = actuators.forces(when, state, piece.sampled)
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
        return np.concatenate(margins, axis=-1)

    def _angles(self, legs: LegStates, state: Motion) -> Array:
        """Angles of the joints at base and platform, (2, n, 6); 0 where none has a limit."""
        if not self.robot.has_joint_angle_limits:
            return np.zeros((2, *legs.L.shape))
        return np.stack(angles_from(self._neutral, legs.s, state.R))

    @cached_property
    def _neutral(self) -> Array:
        return neutral_directions(self.robot)

    def _singular_margins(self, legs: LegStates) -> tuple[Array, Array]:
        if self.thresholds.max_condition == math.inf:
            none = np.ones((len(legs.L), 1))
            return none, none
        H = _scaled_H(legs, platform_size(self.robot))
        near = 1.0 / condition_number(H) - 1.0 / self.thresholds.max_condition
        return near[:, None], self.side * np.linalg.det(H)[:, None]

    def _stop(self, time: float, row: int, piece: Piece, actuators: Actuators) -> StopEvent:
        robot, leg = self.robot, row % 6
        at = np.array([time])
        state = motion_of(piece.interpolant(at).T, piece.center)
        legs = leg_states(robot, state)
        low, high = robot.length_limits[leg]
        length = f"{legs.L[0, leg]:.6g} m"
        angles = np.degrees([self._angles(legs, state)[:, 0, leg], robot.joint_angle_limit[leg]]).T
        if row >= NEAR_SINGULAR:
            condition = condition_number(_scaled_H(legs, platform_size(robot)))[0]
            text = f"condition number of H reaches {condition:.4g} at {time:.9g} s"
            return StopEvent("singular", time, None, f"near a singular pose: {text}")
        kind, text = (
            ("length_limits", f"length {length} reaches its lower limit {low:g} m"),
            ("length_limits", f"length {length} reaches its upper limit {high:g} m"),
            (
                "speed_limit",
                f"speed {legs.L_dot[0, leg]:.6g} m/s reaches its limit {robot.speed_limit[leg]:g} m/s",
            ),
            (
                "force_limit",
                f"force {actuators.forces(at, state, piece.sampled)[0, leg]:.6g} N reaches its limit "
                f"{robot.force_limit[leg]:g} N",
            ),
            ("zero_length", f"length {length} is near zero"),
            ("joint_singularity", "lies nearly along the fixed axis of its universal joint"),
            *(
                (
                    "joint_angle_limit",
                    f"joint angle at the {end} {angle:.6g} degrees reaches its limit {most:g} degrees",
                )
                for end, (angle, most) in zip(("base", "platform"), angles, strict=True)
            ),
        )[row // 6]
        return StopEvent(kind, time, leg + 1, f"leg {leg + 1}: {text} at {time:.9g} s")


def _scaled_H(legs: LegStates, size: float) -> Array:
    """H^T with its moments over a length, (..., 6, 6)."""
    if legs.H is not None:
        return np.asarray(np.swapaxes(legs.H, -1, -2) / np.repeat([1.0, size], 3))
    return np.concatenate([legs.s, cross(legs.q, legs.s) / size], axis=-1)


def det_sign(robot: Robot, state: Motion) -> float:
    """Sign of det H."""
    return float(np.sign(np.linalg.det(_scaled_H(leg_states(robot, state), platform_size(robot)))))


def need_between(value: object, name: str, low: float, high: float) -> None:
    """Reject, by ValueError, what is no number between two others."""
    text = f"a number > {low:g}" + (f" and < {high:g}" if math.isfinite(high) else "")
    number_in(value, name, text, low, high)
