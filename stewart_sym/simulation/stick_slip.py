"""Dry friction of the drives in a simulation, with transitions of each leg between sticking and slipping.

A leg sticks while the motor force minus the leg force that keeps the leg at rest is within the limits of
friction. Its length rate is exactly zero then. Otherwise the leg slips with the friction of
``drives.friction``. The motion is smooth between two transitions, so that any integrator applies; a
transition is a root of the interpolated motion.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ..drives.friction import constant_part, load_share, viscous
from ..drives.rotors import LegRates, leg_rates, product, rotors_by_acceleration
from ..io.array_types import Array
from ..motion.motion import Motion
from ..results import SINGULAR
from ..robot.drive import Drive
from ..robot.robot import LEGS, Robot
from .state_history import WATCHED, Actuators, DriveWork, Piece, motion_of

Plant = Callable[[Motion, Array], tuple[Array, int]]
"""Function (state, leg forces (N), shape (6,)) -> [a; alpha], shape (6,), and status."""
Modes = tuple[int, ...]
"""Mode of each of six legs: 0 sticks, 1 slips and extends, -1 slips and retracts."""
STUCK: Modes = (0,) * LEGS

_UNIT = np.eye(LEGS)
_HALVINGS = 40
_MOST_SIGNS = 20
_MOST_CHANGES = 100
"""Largest number of successive transitions at the same time."""
_GAUSS, _WEIGHTS = np.polynomial.legendre.leggauss(5)


class Change(NamedTuple):
    """Transition of a leg (from 0) at a time (s): to rest (direction 0), or to slipping in a direction."""

    time: float
    leg: int
    direction: int


class Found(NamedTuple):
    """[a; alpha], leg forces, forces between leg parts, friction (N), and L_ddot, shape (..., 6) each."""

    acceleration: Array
    F: Array
    within: Array
    friction: Array
    L_ddot: Array
    status: int


@dataclass(eq=False)
class StickSlip:
    """Drive friction of one simulation, and the current mode of each leg.

    Attributes
    ----------
    loaded : callable
        Function (time, state) -> state with its load.
    """

    robot: Robot
    drive: Drive
    plant: Plant
    loaded: Callable[[float, Motion], Motion]
    modes: Modes = STUCK
    pending: Change | None = None
    _stalled: int = field(default=0)

    def __post_init__(self) -> None:
        """Reject a self-locking screw, which only the inertia of its rotor can move."""
        for leg in np.flatnonzero(self.drive.backdrive_efficiency <= 0.0).tolist():
            raise ValueError(
                f"robot: drive: leg {leg + 1}: backdrive_efficiency: expected a number > 0 in a simulation, "
                f"got {self.drive.backdrive_efficiency[leg]:g} (self-locking screw)"
            )

    # State of the legs

    def begin(self, time: float, state: Motion, motor: Array) -> Motion:
        """Set the modes of an initial state: legs at rest stick if friction permits."""
        L_dot = leg_rates(self.robot, state).L_dot
        self.modes = tuple(int(sign) for sign in np.sign(L_dot))
        return self.settled(time, state, motor)

    def settled(self, time: float, state: Motion, motor: Array) -> Motion:
        """Update the modes of legs at rest, and return the state with their length rates set to zero."""
        modes, change = list(self.modes), self.pending
        self.pending = None
        resting = [leg for leg in range(LEGS) if modes[leg] == 0]
        if change is not None:
            if change.direction:
                resting.remove(change.leg)
            else:
                resting.append(change.leg)
            modes[change.leg] = change.direction
        still = self._at_rest(state, resting)
        self.modes = self._decided(self.loaded(time, still), motor, modes, resting)
        return still

    def _at_rest(self, state: Motion, resting: list[int]) -> Motion:
        """Remove the part of the twist that changes the lengths of some legs, for states of shape (...)."""
        if not resting:
            return state
        twist = np.zeros((*state.shape, 6))
        if len(resting) < LEGS:
            J = leg_rates(self.robot, state).J[..., resting, :]
            twist = np.concatenate([state.v, state.omega], axis=-1)
            twist = twist - product(np.asarray(np.linalg.pinv(J)), product(J, twist))
        v, omega = twist[..., :3], twist[..., 3:]
        return Motion._unchecked(state.R, state.t, omega, v, F_ext=state.F_ext, M_ext=state.M_ext)

    def _decided(self, state: Motion, motor: Array, modes: list[int], resting: list[int]) -> Modes:
        """Find consistent modes of the legs at rest: all stick at first, then the worst leg changes."""
        if not resting:
            return tuple(modes)
        for leg in resting:
            modes[leg] = 0
        seen = set()
        while (now := tuple(modes)) not in seen:
            seen.add(now)
            worst = self._contradiction(state, motor, now, resting)
            if worst is None:
                return now
            modes[worst[1]] = worst[2]
        # Without consistent modes the next step begins with another change, until the simulation stalls.
        return now

    def _contradiction(
        self, state: Motion, motor: Array, modes: Modes, resting: list[int]
    ) -> tuple[float, int, int] | None:
        """Return the leg at rest that violates its mode most: violation, index, and better mode."""
        found = self.solved(state, motor, modes)
        if found.status:
            return None
        low, high = self._holding(found)
        scale = float(np.abs([*motor, *found.F]).max()) + np.finfo(np.float64).tiny
        rates = float(np.abs(found.L_ddot).max()) + np.finfo(np.float64).tiny
        faults = []
        for leg in resting:
            if modes[leg] == 0:
                faults += [
                    ((motor[leg] - high[leg]) / scale, leg, 1),
                    ((low[leg] - motor[leg]) / scale, leg, -1),
                ]
            else:
                faults.append((-modes[leg] * found.L_ddot[leg] / rates, leg, 0))
        worst = max(faults, default=(0.0, 0, 0))
        return worst if worst[0] > 1e-12 else None

    def _holding(self, found: Found) -> tuple[Array, Array]:
        """Compute the smallest and largest motor forces (N), shape (6,), at which legs stick."""
        rest, load = constant_part(self.drive, np.zeros(LEGS)), np.abs(found.within)
        down, up = (load_share(self.drive, found.within, np.full(LEGS, sign)) for sign in (-1.0, 1.0))
        return found.F - rest - down * load, found.F + rest + up * load

    # Dynamics

    def solved(self, state: Motion, motor: Array, modes: Modes | None = None) -> Found:
        """Compute the accelerations of loaded states (...) under motor forces (N), shape (..., 6)."""
        modes = self.modes if modes is None else modes
        sign = np.array(modes, dtype=np.float64)
        legs = leg_rates(self.robot, state)
        left = motor - self._viscous * legs.L_dot - sign * constant_part(self.drive, legs.L_dot)
        if sign.all() and not self._rotors_count:
            # F + sign mu |F| = left: F has the sign of left, and mu depends on the direction of power.
            F = left / (1.0 + sign * np.sign(left) * load_share(self.drive, left, sign))
            accelerations, status = self._accelerations(state, F[..., None, :])
            acceleration = accelerations[..., 0, :]
            return Found(acceleration, F, F, motor - F, product(legs.J, acceleration) + legs.own, status)
        # Accelerations are affine in the forces: evaluate without forces, then with one leg at a time.
        answers, status = self._accelerations(state, self._probes)
        first = answers[..., 0, :]
        try:
            if status:
                raise np.linalg.LinAlgError
            B = np.swapaxes(answers[..., 1:, :] - first[..., None, :], -1, -2) / self._scale
            F, within = self._forces_of(left, sign, legs, first, B)
        except np.linalg.LinAlgError:
            nothing = np.zeros_like(left)
            return Found(nothing * np.nan, nothing, nothing, nothing, nothing, status or SINGULAR)
        acceleration = first + product(B, F) if sign.any() else np.zeros_like(F)
        return Found(acceleration, F, within, motor - F, product(legs.J, acceleration) + legs.own, 0)

    def _accelerations(self, state: Motion, forces: Array) -> tuple[Array, int]:
        """Compute [a; alpha], shape (..., m, 6), of states (...) under m forces (N), and the status."""
        if not state.shape:
            rows = [self.plant(state, F) for F in forces]
        else:
            each = np.broadcast_to(forces, (*state.shape, *forces.shape[-2:]))
            rows = [self.plant(one, F) for one, some in zip(state, each, strict=True) for F in some]
        found = np.array([row[0] for row in rows]).reshape(*state.shape, -1, 6)
        return found, next((status for _, status in rows if status), 0)

    def _forces_of(
        self, left: Array, sign: Array, legs: LegRates, first: Array, B: Array
    ) -> tuple[Array, Array]:
        """Compute leg forces and forces between leg parts (N), shape (..., 6), for accelerations first + B F.

        ``left`` contains the motor forces minus the load-independent friction (N), shape (..., 6).
        """
        own, by = np.zeros(LEGS), _UNIT
        if self._rotors_count:
            alone, per = rotors_by_acceleration(self.robot, legs)
            own, by = -(alone + product(per, first)), _UNIT - per @ B
        resting = sign == 0.0
        A, right = _UNIT, left
        if resting.any():
            A = np.where(resting[:, None], legs.J @ B, _UNIT)
            right = np.where(resting, -(product(legs.J, first) + legs.own), left)
        within = left
        for _ in range(_MOST_SIGNS):
            # Load-dependent friction is linear for an assumed sign of the force between the leg parts.
            share = sign * np.sign(within) * load_share(self.drive, within, sign)
            known = (right - share * own)[..., None]
            F = np.asarray(np.linalg.solve(A + share[..., None] * by, known)[..., 0])
            before, within = within, own + product(by, F)
            if np.array_equal(np.sign(before), np.sign(within)):
                break
        return F, within

    @cached_property
    def _rotors_count(self) -> bool:
        """True if load-dependent friction depends on rotor inertia."""
        drive = self.drive
        lossy = np.any(drive.efficiency != 1.0) or np.any(drive.backdrive_efficiency != 1.0)
        return bool(lossy and np.any(drive.rotor_inertia))

    @cached_property
    def _viscous(self) -> Array:
        """Viscous friction coefficients (N s/m), shape (6,)."""
        return viscous(self.drive)

    @cached_property
    def _probes(self) -> Array:
        """Force vectors with no force and with the reference force in one leg each (N), shape (7, 6)."""
        return self._scale * np.eye(LEGS + 1, LEGS, -1)

    @cached_property
    def _scale(self) -> float:
        """Reference force: the weight of the robot (N)."""
        mass = self.robot.M + float(np.sum(self.robot.m_d + self.robot.m_u))
        return mass * (float(np.linalg.norm(self.robot.g)) or 1.0)

    # Changes

    def first_change(self, piece: Piece, actuators: Actuators) -> Change | None:
        """Return the first transition within a piece, or None."""
        when = np.linspace(piece.start, piece.end, WATCHED + 1)
        margins = self._margins(when, piece, actuators)
        found = []
        for leg in np.flatnonzero((margins[1:] < 0.0).any(axis=0)).tolist():
            i = 1 + int(np.argmax(margins[1:, leg] < 0.0))
            time = self._root(leg, float(when[i - 1]), float(when[i]), piece, actuators)
            direction = 0
            if self.modes[leg] == 0:
                motor, holding = self._forces(when[i : i + 1], piece, actuators)
                direction = 1 if motor[0, leg] > holding.F[0, leg] else -1
            found.append(Change(time, leg, direction))
        change = min(found, default=None)
        self._stalled = self._stalled + 1 if change and change.time <= piece.start else 0
        self.pending = change
        return change

    @property
    def stalled(self) -> bool:
        """True if legs change their modes again and again at the same time."""
        return self._stalled > _MOST_CHANGES

    def _root(self, leg: int, start: float, end: float, piece: Piece, actuators: Actuators) -> float:
        """Return the time (s) before ``end`` at which the margin of a leg becomes zero."""
        from scipy.optimize import brentq

        def margin(time: float) -> float:
            return float(self._margins(np.array([time]), piece, actuators)[0, leg])

        # The rate of a leg is zero when it begins to slip.
        for _ in range(_HALVINGS):
            if margin(start) > 0.0:
                return float(brentq(margin, start, end, xtol=1e-15 * max(end, 1.0), rtol=1e-14))
            middle = 0.5 * (start + end)
            if margin(middle) > 0.0:
                start = middle
            else:
                end = middle
        return piece.start

    def _margins(self, when: Array, piece: Piece, actuators: Actuators) -> Array:
        """Return the margin of each leg, shape (n, 6): slip speed (m/s), or remaining friction force (N)."""
        state = motion_of(piece.interpolant(when).T)
        found = np.array(self.modes) * leg_rates(self.robot, state).L_dot
        resting = np.array(self.modes) == 0
        if resting.any():
            motor, holding = self._forces(when, piece, actuators)
            low, high = self._holding(holding)
            # Rounding errors must not move a leg.
            slack = 1e-12 * (np.abs(motor) + np.abs(holding.F))
            found[:, resting] = (np.minimum(high - motor, motor - low) + slack)[:, resting]
        return found

    def _forces(self, when: Array, piece: Piece, actuators: Actuators) -> tuple[Array, Found]:
        """Return the motor forces (N), shape (n, 6), and the solution of the legs at times within a piece."""
        state, motor = self.at(when, piece, actuators)
        return motor, self.solved(state, motor, piece.modes)

    def at(self, when: Array, piece: Piece, actuators: Actuators) -> tuple[Motion, Array]:
        """Return the loaded states at n times within a piece, and the motor forces (N), shape (n, 6)."""
        states = self.moving(motion_of(piece.interpolant(when).T), piece.modes)
        rows = [self.loaded(time, state) for time, state in zip(when.tolist(), states, strict=True)]
        load = {
            name: np.array([getattr(row, name) for row in rows])
            for name in ("F_ext", "M_ext")
            if getattr(rows[0], name) is not None
        }
        states = Motion._unchecked(states.R, states.t, states.omega, states.v, **load)
        return states, actuators.forces(when, states, piece.sampled)

    def moving(self, state: Motion, modes: Modes | None = None) -> Motion:
        """Remove the motion of sticking legs that is due to integration errors."""
        modes = self.modes if modes is None else modes
        return self._at_rest(state, [leg for leg in range(LEGS) if modes[leg] == 0])

    # Results

    def results(self, pieces: tuple[Piece, ...], actuators: Actuators, times: Array) -> DriveWork:
        """Compute work and losses over a simulation, and friction at n times (s) within it."""
        of = np.searchsorted([piece.start for piece in pieces], times, side="right") - 1
        friction = [
            self._forces(times[j : j + 1], pieces[i], actuators)[1].friction for j, i in enumerate(of)
        ]
        sticks = np.array([pieces[i].modes for i in of], dtype=np.int64).reshape(-1, LEGS) == 0
        done, lost = self._work(pieces, actuators)
        return DriveWork(done, lost, np.array(friction).reshape(-1, LEGS), sticks)

    def _work(self, pieces: tuple[Piece, ...], actuators: Actuators) -> tuple[Array, Array]:
        """Compute the work of the motors and the energy dissipated by friction (J), shape (6,) each."""
        done, lost = np.zeros((2, LEGS))
        for piece in pieces:
            half = 0.5 * (piece.end - piece.start)
            state, motor = self.at(piece.start + half * (1.0 + _GAUSS), piece, actuators)
            moved = half * np.array(piece.modes) ** 2 * leg_rates(self.robot, state).L_dot
            done += _WEIGHTS @ (motor * moved)
            lost += _WEIGHTS @ (self.solved(state, motor, piece.modes).friction * moved)
        return done, lost
