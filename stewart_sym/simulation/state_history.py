"""A simulated run as it is handed back: why it stopped, states and forces over time, saturation."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import real_array
from ..io.array_types import Array, Flags
from ..kinematics.inverse_kinematics import leg_vectors, tip_velocities
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_vector
from ..reference import newton_euler, offset_joints
from ..robot.offset_chains import SLIDING, columns_of_H, joint_motion
from ..robot.robot import Robot
from .actuator_models import ForceLaw

Load = Callable[[float, Motion], ArrayLike]
"""(time, s, state) -> [F_ext; M_ext], N and N m, platform frame, (6,)."""
WATCHED = 5
"""Instants of each step at which limits are looked at."""

# Lobatto's rule of six points: instants of a step from -1 to 1, both ends among them, and their weights.
_INNER = math.sqrt((7.0 - 2.0 * math.sqrt(7.0)) / 21.0), math.sqrt((7.0 + 2.0 * math.sqrt(7.0)) / 21.0)
_LOBATTO = np.array([-1.0, -_INNER[1], -_INNER[0], _INNER[0], _INNER[1], 1.0])
_SHARES = np.array([1.0 / 15.0, (14.0 - math.sqrt(7.0)) / 30.0, (14.0 + math.sqrt(7.0)) / 30.0])
_WEIGHTS = np.concatenate([_SHARES, _SHARES[::-1]])


@dataclass(frozen=True)
class StopEvent:
    """Why and when a run ended.

    Attributes
    ----------
    reason : str
        "completed" (it ran to its end), "length_limits", "speed_limit", "force_limit",
        "joint_angle_limit", "singular", "zero_length", "joint_singularity" or "step_failed" (no step is small
        enough).
    time : float
        s.
    leg : int
        Its number from 1, None where no leg is to blame.
    message : str
        All of it in one line.
    """

    reason: str
    time: float
    leg: int | None
    message: str


@dataclass(frozen=True, eq=False)
class ForceSaturation:
    """How long and by how much each leg's actuator was commanded more than its limit; zeros if it never was.

    Attributes
    ----------
    duration : ndarray
        s, (6,); where the law is not sampled, right to a small part of a step.
    max_excess : ndarray
        The largest force beyond the limit, N, (6,).
    """

    duration: Array
    max_excess: Array


@dataclass(frozen=True, eq=False)
class DriveWork:
    """What the motors did in a run and what their drives' friction took of it.

    Attributes
    ----------
    done : ndarray
        Work of each motor, J, (6,).
    lost : ndarray
        Energy that friction of its drive dissipated, J, (6,).
    friction : ndarray
        N times torque less the leg's force, N, (n, 6), at the instants of the trace.
    sticks : ndarray of bool
        Which legs stick, (n, 6).
    """

    done: Array
    lost: Array
    friction: Array
    sticks: Flags


@dataclass(frozen=True, eq=False)
class StateHistory:
    """States and forces at n instants; SI units, base frame.

    Attributes
    ----------
    time : ndarray
        s, (n,).
    R : ndarray
        (n, 3, 3).
    t, v : ndarray
        m and m/s, (n, 3).
    omega : ndarray
        Rad/s, (n, 3).
    F : ndarray
        Actuator forces, N, (n, 6); of a robot whose drives have friction those of the motors, N times torque.
    L : ndarray
        Leg lengths, m, (n, 6).
    kinetic_energy, potential_energy : ndarray
        Energy of the platform, the twelve leg parts and the drives' rotors, J, (n,), with the exact
        kinematics of the legs in either formulation; the potential energy is that of weight, zero at the base
        frame's origin.
    """

    time: Array
    R: Array
    t: Array
    v: Array
    omega: Array
    F: Array
    L: Array
    kinetic_energy: Array
    potential_energy: Array

    @property
    def energy(self) -> Array:
        """Kinetic and potential energy, J, (n,)."""
        return self.kinetic_energy + self.potential_energy

    @property
    def motion(self) -> Motion:
        """The states as a Motion of shape (n,) without accelerations."""
        return Motion(R=self.R, t=self.t, omega=self.omega, v=self.v)


class Actuators(NamedTuple):
    """The law and the limits, N, (6,), inf for none, to which the forces it commands are clipped."""

    law: ForceLaw
    limit: Array

    def at(self, time: float, state: Motion, sampled: Array | None) -> Array:
        """Forces of one state, N, (6,); sampled: what the law commanded last, None unless sampled."""
        return self.clipped(six_forces(self.law(time, state), time) if sampled is None else sampled)

    def commanded(self, when: Array, states: Motion, sampled: Array | None) -> Array:
        """Forces that the law commands at n instants, N, (n, 6)."""
        if sampled is not None:
            return np.broadcast_to(sampled, (len(when), 6))
        rows = zip(when.tolist(), states, strict=True)
        return np.array([six_forces(self.law(time, state), time) for time, state in rows]).reshape(-1, 6)

    def forces(self, when: Array, states: Motion, sampled: Array | None) -> Array:
        """Forces that act at n instants, N, (n, 6)."""
        return self.clipped(self.commanded(when, states, sampled))

    def clipped(self, F: Array) -> Array:
        """Forces (..., 6) within the limits."""
        return np.minimum(np.maximum(F, -self.limit), self.limit)


class Piece(NamedTuple):
    """An accepted step: its times, the interpolant of the chart's numbers, the center, the sampled forces.

    sampled: as the law commanded them; None where the law is not sampled. modes: which legs stick and slip.
    """

    start: float
    end: float
    interpolant: Callable[[Any], Array]
    center: Array
    sampled: Array | None
    modes: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class SimulationResult(StateHistory):
    """A run: its trace, why it stopped, how its forces saturated, and any instant between by ``at``.

    Attributes
    ----------
    stop : StopEvent
        Why and where the run ended.
    saturation : ForceSaturation
        What clipping left out, by leg.
    drive_work : DriveWork, optional
        Work of the motors and what friction took of it; None for a robot whose drives have none.
    has_load : bool
        Whether an external wrench acted on the platform.
    """

    stop: StopEvent
    saturation: ForceSaturation
    _robot: Robot
    _actuators: Actuators
    _pieces: tuple[Piece, ...]
    drive_work: DriveWork | None = None
    has_load: bool = False

    @property
    def step_count(self) -> int:
        """How many steps the integration took."""
        return len(self._pieces)

    @property
    def dense_history(self) -> StateHistory:
        """States and forces at six instants of each step: for peaks and integrals, whatever the rows are.

        Where one step ends and the next begins an instant stands twice, with the forces of either.
        """
        when = [
            np.append(piece.start + 0.5 * (piece.end - piece.start) * (1.0 + _LOBATTO[:-1]), piece.end)
            for piece in self._pieces
        ]
        of = np.repeat(np.arange(len(when)), len(_LOBATTO))
        return sampled_at(self._robot, self._actuators, self._pieces, np.concatenate(when), of)

    @property
    def dense_weights(self) -> Array:
        """Weights, s, (n,), whose sum with numbers at the instants of ``dense_history`` is their integral."""
        return np.concatenate([0.5 * (piece.end - piece.start) * _WEIGHTS for piece in self._pieces])

    def at(self, times: ArrayLike) -> StateHistory:
        """States and forces at given times, interpolated to the accuracy of the run.

        Parameters
        ----------
        times : array_like
            Within the run, s, (n,).

        Returns
        -------
        StateHistory
            Shapes and units are documented there.

        Raises
        ------
        ValueError
            For times outside the run or of another shape.
        """
        when = real_array(times, "times", "times of shape (n,)")
        end = self.stop.time
        if when.ndim != 1:
            raise ValueError(f"times: expected shape (n,), got {when.shape}")
        outside = ~((when >= 0.0) & (when <= end))
        if outside.any():
            raise ValueError(f"times: expected times in [0, {end:g}] s, got {when[outside][0]:g}")
        return sampled_at(self._robot, self._actuators, self._pieces, when)


def motion_of(y: Array, center: Array, F_ext: Array | None = None, M_ext: Array | None = None) -> Motion:
    """The chart's numbers [t; phi; v; omega], (..., 12), as states under a load."""
    R = rotation_from_vector(y[..., 3:6]) @ center
    return Motion._unchecked(R, y[..., :3], y[..., 9:], y[..., 6:9], F_ext=F_ext, M_ext=M_ext)


class LegStates(NamedTuple):
    """Points, lengths, rates and directions of the legs; with offset joints H and the joints' sines too."""

    q: Array
    L: Array
    L_dot: Array
    s: Array
    H: Array | None = None
    sine: Array | None = None


def leg_states(robot: Robot, state: Motion) -> LegStates:
    """Leg kinematics without the rejections of ``inverse_kinematics``: a watched leg may come to nothing."""
    if robot.offsets is not None:
        with np.errstate(all="ignore"):
            moving = joint_motion(robot, state)
            sine = np.minimum(moving.at.of_tip / moving.at.L, 1.0)[..., 0]
        of_legs = moving.at.q, moving.at.L[..., 0], moving.rates[..., SLIDING], moving.at.s
        return LegStates(*of_legs, columns_of_H(robot, moving.G), sine)
    q, S, L = leg_vectors(robot, state.R, state.t)
    with np.errstate(all="ignore"):
        s = S / L[..., None]
    return LegStates(q, L, np.einsum("...i,...i->...", s, tip_velocities(state, q)), s)


def sampled_at(
    robot: Robot,
    actuators: Actuators,
    pieces: tuple[Piece, ...],
    when: Array,
    of: NDArray[np.intp] | None = None,
) -> StateHistory:
    """The trace at times within the pieces; of: the piece of each, None for the last that has begun."""
    n = len(when)
    y, centers, F = np.empty((n, 12)), np.empty((n, 3, 3)), np.empty((n, 6))
    if of is None:
        of = np.searchsorted([piece.start for piece in pieces], when, side="right") - 1
    order = np.argsort(of, kind="stable")
    for here in np.split(order, np.flatnonzero(np.diff(of[order])) + 1) if n else ():
        piece = pieces[of[here[0]]]
        y[here], centers[here] = piece.interpolant(when[here]).T, piece.center
        if piece.sampled is not None:
            F[here] = actuators.clipped(piece.sampled)
    motion = motion_of(y, centers)
    if pieces[0].sampled is None:
        F = actuators.forces(when, motion, None)
    rest = Motion._unchecked(motion.R, motion.t, np.zeros((n, 3)), np.zeros((n, 3)))
    energy = newton_euler.energy if robot.offsets is None else offset_joints.energy
    potential = energy(robot, rest)
    kinetic = energy(robot, motion) - potential
    L = leg_states(robot, motion).L
    return StateHistory(when, motion.R, motion.t, motion.v, motion.omega, F, L, kinetic, potential)


def saturation_of(actuators: Actuators, pieces: Sequence[Piece]) -> ForceSaturation:
    """What the commanded forces exceed their limits by, in all pieces."""
    time, excess = np.zeros(6), np.zeros(6)
    for piece in pieces if np.isfinite(actuators.limit).any() else ():
        when = np.linspace(piece.start, piece.end, WATCHED + 1)
        state = motion_of(piece.interpolant(when).T, piece.center)
        beyond = np.abs(actuators.commanded(when, state, piece.sampled)) - actuators.limit
        excess = np.maximum(excess, beyond.max(axis=0))
        time += np.diff(when) @ _share_above_zero(beyond[:-1], beyond[1:])
    return ForceSaturation(time, excess)


def _share_above_zero(start: Array, end: Array) -> Array:
    """Share, 0 to 1, of the straight line from one number to another that is above zero."""
    above = np.maximum(start, 0.0) + np.maximum(end, 0.0)
    with np.errstate(invalid="ignore"):
        share = above / (np.abs(start) + np.abs(end))
    return np.where(above > 0.0, np.where(np.minimum(start, end) >= 0.0, 1.0, share), 0.0)


def output_times(pieces: Sequence[Piece], end: float, step: float | None) -> Array:
    """Times of a run's results, s: ends of steps, or every ``step`` s."""
    if step is None:
        return np.unique([pieces[0].start, *(piece.end for piece in pieces)])
    grid = np.arange(math.floor(end / step * (1.0 + 1e-12)) + 1) * step
    return np.append(grid[grid < end * (1.0 - 1e-12)], end)


def six_forces(value: ArrayLike, time: float) -> Array:
    """What a law returned, as six numbers; ValueError if it is anything else."""
    F = real_array(value, "forces", "six numbers")
    if F.shape != (6,):
        raise ValueError(f"forces: expected six numbers from the law at {time:g} s, got shape {F.shape}")
    return F
