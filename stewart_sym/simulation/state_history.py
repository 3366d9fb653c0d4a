"""Result of a simulation: stop event, states and forces over time, and force saturation."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import real_array
from ..io.array_types import Array, Flags
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_quaternion
from ..reference import newton_euler, offset_joints
from ..robot.robot import Robot
from .actuator_models import ForceLaw, leg_states

Load = Callable[[float, Motion], ArrayLike]
"""Function (time in s, state) -> [F_ext; M_ext] (N and N m) in the platform frame, shape (6,)."""
WATCHED = 5
"""Number of times in each step at which limits are checked."""

# Gauss-Lobatto quadrature with six points on [-1, 1], including both ends, and its weights.
_INNER = math.sqrt((7.0 - 2.0 * math.sqrt(7.0)) / 21.0), math.sqrt((7.0 + 2.0 * math.sqrt(7.0)) / 21.0)
_LOBATTO = np.array([-1.0, -_INNER[1], -_INNER[0], _INNER[0], _INNER[1], 1.0])
_SHARES = np.array([1.0 / 15.0, (14.0 - math.sqrt(7.0)) / 30.0, (14.0 + math.sqrt(7.0)) / 30.0])
_WEIGHTS = np.concatenate([_SHARES, _SHARES[::-1]])


@dataclass(frozen=True)
class StopEvent:
    """Reason and time of the end of a simulation.

    Attributes
    ----------
    reason : str
        "completed" if the simulation ran to its end; otherwise "length_limits", "speed_limit", "force_limit",
        "joint_angle_limit", "singular", "zero_length", "joint_singularity", or "step_failed" (no step size
        satisfies the tolerance).
    time : float
        Time (s).
    leg : int
        Number of the leg, from 1; None if the reason does not concern a single leg.
    message : str
        Description in one line.
    """

    reason: str
    time: float
    leg: int | None
    message: str


@dataclass(frozen=True, eq=False)
class ForceSaturation:
    """Duration and amount of excess of each commanded force over its limit; zeros without saturation.

    Attributes
    ----------
    duration : ndarray, shape (6,)
        Saturated time (s). For a law that is not sampled it is accurate to a small fraction of a step.
    max_excess : ndarray, shape (6,)
        Largest force beyond the limit (N).
    """

    duration: Array
    max_excess: Array


@dataclass(frozen=True, eq=False)
class DriveWork:
    """Work of the motors and energy dissipated by the friction of the drives in a simulation.

    done, lost: work (J), shape (6,). friction: motor force less leg force (N), sticks: sticking legs, at the
    times of the history, shape (n, 6).
    """

    done: Array
    lost: Array
    friction: Array
    sticks: Flags


@dataclass(frozen=True, eq=False)
class StateHistory:
    """States, forces, and energies at n times, in SI units and the base frame.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Time (s).
    R : ndarray, shape (n, 3, 3)
        Rotation matrix.
    t, v : ndarray, shape (n, 3)
        Position (m) and velocity (m/s) of the reference point.
    omega : ndarray, shape (n, 3)
        Angular velocity (rad/s).
    F : ndarray, shape (n, 6)
        Actuator forces (N). For a robot with drive friction these are motor forces (motor torque times
        transmission ratio).
    L : ndarray, shape (n, 6)
        Leg lengths (m).
    kinetic_energy, potential_energy : ndarray, shape (n,)
        Energy (J) of the platform, the twelve leg parts, and the rotors of the drives, with the exact
        kinematics of the legs in either formulation. The potential energy is due to gravity; it is zero at
        the origin of the base frame.
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
        """Sum of kinetic and potential energy (J), shape (n,)."""
        return self.kinetic_energy + self.potential_energy

    @property
    def motion(self) -> Motion:
        """States as a Motion of shape (n,) without accelerations."""
        return Motion(R=self.R, t=self.t, omega=self.omega, v=self.v)


class Actuators(NamedTuple):
    """Force law and the force limits (N), shape (6,), at which forces are clipped; inf without a limit."""

    law: ForceLaw
    limit: Array

    def at(self, time: float, state: Motion, sampled: Array | None) -> Array:
        """Compute the forces of one state (N), shape (6,), from the law or from its last sample."""
        return self.clipped(six_forces(self.law(time, state), time) if sampled is None else sampled)

    def commanded(self, when: Array, states: Motion, sampled: Array | None) -> Array:
        """Compute the forces that the law commands at n times (N), shape (n, 6)."""
        if sampled is not None:
            return np.broadcast_to(sampled, (len(when), 6))
        rows = zip(when.tolist(), states, strict=True)
        return np.array([six_forces(self.law(time, state), time) for time, state in rows]).reshape(-1, 6)

    def forces(self, when: Array, states: Motion, sampled: Array | None) -> Array:
        """Compute the forces that act at n times (N), shape (n, 6)."""
        return self.clipped(self.commanded(when, states, sampled))

    def clipped(self, F: Array) -> Array:
        """Clip forces (N), shape (..., 6), to the limits."""
        return np.minimum(np.maximum(F, -self.limit), self.limit)


class Piece(NamedTuple):
    """Accepted step: times (s), interpolant of the coordinates, forces, leg modes."""

    start: float
    end: float
    interpolant: Callable[[Any], Array]
    sampled: Array | None
    modes: tuple[int, ...] = ()


@dataclass(frozen=True, eq=False)
class SimulationResult(StateHistory):
    """Result of a simulation: history, stop event, force saturation, and states at any time by ``at``.

    Attributes
    ----------
    stop : StopEvent
        Reason and time of the end.
    saturation : ForceSaturation
        Duration and amount of clipping of each leg.
    drive_work : DriveWork, optional
        Work of the motors and dissipated energy; None for a robot without drive friction.
    has_load : bool
        True if an external wrench acts on the platform.
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
        """Number of integration steps."""
        return len(self._pieces)

    @property
    def dense_history(self) -> StateHistory:
        """States and forces at six times in each step, for peaks and integrals.

        The boundary between two steps occurs twice, with the forces of each step.
        """
        when = [
            np.append(piece.start + 0.5 * (piece.end - piece.start) * (1.0 + _LOBATTO[:-1]), piece.end)
            for piece in self._pieces
        ]
        of = np.repeat(np.arange(len(when)), len(_LOBATTO))
        return sampled_at(self._robot, self._actuators, self._pieces, np.concatenate(when), of)

    @property
    def dense_weights(self) -> Array:
        """Quadrature weights (s), shape (n,), for integrals over the times of ``dense_history``."""
        return np.concatenate([0.5 * (piece.end - piece.start) * _WEIGHTS for piece in self._pieces])

    def at(self, time: ArrayLike) -> StateHistory:
        """Interpolate states and forces to the accuracy of the simulation.

        Parameters
        ----------
        time : array_like, shape (n,)
            Times within the simulation (s).

        Returns
        -------
        StateHistory
            States, forces, and energies at ``time``.

        Raises
        ------
        ValueError
            If a time is outside the simulation, or if ``time`` has another shape.
        """
        when = real_array(time, "time", "times of shape (n,)")
        end = self.stop.time
        if when.ndim != 1:
            raise ValueError(f"time: expected shape (n,), got {when.shape}")
        outside = ~((when >= 0.0) & (when <= end))
        if outside.any():
            raise ValueError(f"time: expected times in [0, {end:g}] s, got {when[outside][0]:g}")
        return sampled_at(self._robot, self._actuators, self._pieces, when)


def motion_of(y: Array) -> Motion:
    """Convert coordinates [t; quaternion; v; omega], shape (..., 13), to states."""
    R = rotation_from_quaternion(y[..., 3:7])
    return Motion._unchecked(R, y[..., :3], y[..., 10:], y[..., 7:10])


def sampled_at(
    robot: Robot,
    actuators: Actuators,
    pieces: tuple[Piece, ...],
    when: Array,
    of: NDArray[np.intp] | None = None,
) -> StateHistory:
    """Return the history at times (s); ``of`` is the piece of each time, by default the last begun."""
    n = len(when)
    y, F = np.empty((n, 13)), np.empty((n, 6))
    if of is None:
        of = np.searchsorted([piece.start for piece in pieces], when, side="right") - 1
    order = np.argsort(of, kind="stable")
    for here in np.split(order, np.flatnonzero(np.diff(of[order])) + 1) if n else ():
        piece = pieces[of[here[0]]]
        y[here] = piece.interpolant(when[here]).T
        if piece.sampled is not None:
            F[here] = actuators.clipped(piece.sampled)
    motion = motion_of(y)
    if pieces[0].sampled is None:
        F = actuators.forces(when, motion, None)
    rest = Motion._unchecked(motion.R, motion.t, np.zeros((n, 3)), np.zeros((n, 3)))
    energy = newton_euler.energy if robot.offsets is None else offset_joints.energy
    potential = energy(robot, rest)
    kinetic = energy(robot, motion) - potential
    L = leg_states(robot, motion).L
    return StateHistory(when, motion.R, motion.t, motion.v, motion.omega, F, L, kinetic, potential)


def saturation_of(actuators: Actuators, pieces: Sequence[Piece]) -> ForceSaturation:
    """Compute duration and amount by which the commanded forces exceed their limits, over all pieces."""
    time, excess = np.zeros(6), np.zeros(6)
    for piece in pieces if np.isfinite(actuators.limit).any() else ():
        when = np.linspace(piece.start, piece.end, WATCHED + 1)
        state = motion_of(piece.interpolant(when).T)
        beyond = np.abs(actuators.commanded(when, state, piece.sampled)) - actuators.limit
        excess = np.maximum(excess, beyond.max(axis=0))
        time += np.diff(when) @ _share_above_zero(beyond[:-1], beyond[1:])
    return ForceSaturation(time, excess)


def _share_above_zero(start: Array, end: Array) -> Array:
    """Compute the fraction, 0 to 1, of the line between two numbers that is above zero."""
    above = np.maximum(start, 0.0) + np.maximum(end, 0.0)
    with np.errstate(invalid="ignore"):
        share = above / (np.abs(start) + np.abs(end))
    return np.where(above > 0.0, np.where(np.minimum(start, end) >= 0.0, 1.0, share), 0.0)


def output_times(pieces: Sequence[Piece], end: float, step: float | None) -> Array:
    """Return the output times (s): the ends of the steps, or every ``step`` s."""
    if step is None:
        return np.unique([pieces[0].start, *(piece.end for piece in pieces)])
    grid = np.arange(math.floor(end / step * (1.0 + 1e-12)) + 1) * step
    return np.append(grid[grid < end * (1.0 - 1e-12)], end)


def six_forces(value: ArrayLike, time: float) -> Array:
    """Return the result of a law as six numbers; raise ValueError for another shape."""
    F = real_array(value, "forces", "six numbers")
    if F.shape != (6,):
        raise ValueError(f"forces: expected six numbers from the law at {time:g} s, got shape {F.shape}")
    return F
