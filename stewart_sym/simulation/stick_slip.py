"""Dry friction of the drives in a simulation: each leg sticks or slips, and changes where it must.

A leg sticks while the motor's force, less that with which the leg holds still, is within what friction can
be; its rate of length is zero then, and stays so exactly. Else it slips against the friction of
``drives.friction``. Between two changes the machine is smooth, so that any method integrates it; the changes
are roots of the interpolated motion.
"""

from __future__ import annotations

import itertools
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
"""(state, forces of the legs, N, (6,)) -> [a; alpha], (6,), status."""
Modes = tuple[int, ...]
"""For each of six legs: 0 sticks, 1 slips and extends, -1 slips and retracts."""
STUCK: Modes = (0,) * LEGS

_UNIT = np.eye(LEGS)
_HALVINGS = 40
_MOST_SIGNS = 20
_MOST_CHANGES = 100
"""Changes of legs, one after the other, in which no time goes by."""
_GAUSS, _WEIGHTS = np.polynomial.legendre.leggauss(5)


class Change(NamedTuple):
    """A leg, counted from 0, that comes to rest or, with a direction, breaks away; time in s."""

    time: float
    leg: int
    direction: int


class Found(NamedTuple):
    """[a; alpha], forces of the legs, between their parts and of friction, N, and L_ddot, (..., 6) each."""

    acceleration: Array
    F: Array
    within: Array
    friction: Array
    L_ddot: Array
    status: int


@dataclass(eq=False)
class StickSlip:
    """The drives' friction of one run, and in which mode each leg is.

    loaded: (time, state) -> the state with its load.
    """

    robot: Robot
    drive: Drive
    plant: Plant
    loaded: Callable[[float, Motion], Motion]
    modes: Modes = STUCK
    pending: Change | None = None
    _stalled: int = field(default=0)

    def __post_init__(self) -> None:
        """Reject screws that only their rotor's inertia moves."""
        for leg in np.flatnonzero(self.drive.backdrive_efficiency <= 0.0).tolist():
            raise ValueError(
                f"robot: drive: leg {leg + 1}: backdrive_efficiency: expected a number > 0 in a simulation, "
                f"got {self.drive.backdrive_efficiency[leg]:g}, of a screw that locks itself"
            )

    # State of the legs

    def begin(self, time: float, state: Motion, motor: Array) -> Motion:
        """Set the modes of a first state: legs at rest stick if they can."""
        L_dot = leg_rates(self.robot, state).L_dot
        self.modes = tuple(int(sign) for sign in np.sign(L_dot))
        return self.settled(time, state, motor)

    def settled(self, time: float, state: Motion, motor: Array) -> Motion:
        """Modes anew of the legs at rest, and the state with their rates of length exactly zero."""
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
        """States (...) without the part of their twist that changes the lengths of some legs."""
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
        """Consistent modes of legs at rest: first all stick, then the worst one changes, one by one."""
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
        for some in itertools.product((0, 1, -1), repeat=len(resting)):
            for leg, mode in zip(resting, some, strict=True):
                modes[leg] = mode
            if self._contradiction(state, motor, tuple(modes), resting) is None:
                break
        return tuple(modes)

    def _contradiction(
        self, state: Motion, motor: Array, modes: Modes, resting: list[int]
    ) -> tuple[float, int, int] | None:
        """The leg at rest that contradicts its mode most: by how much, its number, its better mode."""
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
        """Least and largest force of the motors, N, (6,), with which legs stick."""
        rest, load = constant_part(self.drive, np.zeros(LEGS)), np.abs(found.within)
        down, up = (load_share(self.drive, found.within, np.full(LEGS, sign)) for sign in (-1.0, 1.0))
        return found.F - rest - down * load, found.F + rest + up * load

    # Dynamics

    def solved(self, state: Motion, motor: Array, modes: Modes | None = None) -> Found:
        """Accelerations of states (...) with their load under the motors' forces, N, (..., 6), in modes."""
        modes = self.modes if modes is None else modes
        sign = np.array(modes, dtype=np.float64)
        legs = leg_rates(self.robot, state)
        left = motor - self._viscous * legs.L_dot - sign * constant_part(self.drive, legs.L_dot)
        if sign.all() and not self._rotors_count:
            # F + sign mu |F| = left: F has the sign of left, and mu goes by the direction of power.
            F = left / (1.0 + sign * np.sign(left) * load_share(self.drive, left, sign))
            accelerations, status = self._accelerations(state, F[..., None, :])
            acceleration = accelerations[..., 0, :]
            return Found(acceleration, F, F, motor - F, product(legs.J, acceleration) + legs.own, status)
        # Accelerations are linear in the forces: without any, and with one leg's at a time.
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
        """[a; alpha] of states (...) under each of m forces, N, (..., m, 6) or (m, 6), first status not 0."""
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
        """Forces of the legs and those between their parts, N, (..., 6), by accelerations first + B F.

        left: the motors' forces less the friction that no force changes, N, (..., 6).
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
            # Friction in proportion to the force between the parts, of the sign that this is taken to have.
            share = sign * np.sign(within) * load_share(self.drive, within, sign)
            F = _solved(A + share[..., None] * by, right - share * own)
            before, within = within, own + product(by, F)
            if np.array_equal(np.sign(before), np.sign(within)):
                break
        return F, within

    @cached_property
    def _rotors_count(self) -> bool:
        """Whether the force between a leg's parts differs from its actuator's, and friction goes by it."""
        drive = self.drive
        lossy = np.any(drive.efficiency != 1.0) or np.any(drive.backdrive_efficiency != 1.0)
        return bool(lossy and np.any(drive.rotor_inertia))

    @cached_property
    def _viscous(self) -> Array:
        return viscous(self.drive)

    @cached_property
    def _probes(self) -> Array:
        """No forces of the legs, and the scale's of one after another, N, (7, 6)."""
        return self._scale * np.eye(LEGS + 1, LEGS, -1)

    @cached_property
    def _scale(self) -> float:
        """A force of the size of the machine's weight, N."""
        mass = self.robot.M + float(np.sum(self.robot.m_d + self.robot.m_u))
        return mass * (float(np.linalg.norm(self.robot.g)) or 1.0)

    # Changes

    def first_change(self, piece: Piece, actuators: Actuators) -> Change | None:
        """The first change within a piece, None if there is none."""
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
        """Whether legs change on and on and no time goes by."""
        return self._stalled > _MOST_CHANGES

    def _root(self, leg: int, start: float, end: float, piece: Piece, actuators: Actuators) -> float:
        """Where a leg's margin comes to zero on the way to an end at which it is below."""
        from scipy.optimize import brentq

        def margin(time: float) -> float:
            return float(self._margins(np.array([time]), piece, actuators)[0, leg])

        # A leg that has just begun to slip has no rate yet.
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
        """For each leg, (n, 6): its rate in the direction in which it slips, m/s, or what holds it, N."""
        state = motion_of(piece.interpolant(when).T, piece.center)
        found = np.array(self.modes) * leg_rates(self.robot, state).L_dot
        resting = np.array(self.modes) == 0
        if resting.any():
            motor, holding = self._forces(when, piece, actuators)
            low, high = self._holding(holding)
            # Rounding does not move a leg.
            slack = 1e-12 * (np.abs(motor) + np.abs(holding.F))
            found[:, resting] = (np.minimum(high - motor, motor - low) + slack)[:, resting]
        return found

    def _forces(self, when: Array, piece: Piece, actuators: Actuators) -> tuple[Array, Found]:
        """Forces of the motors, N, (n, 6), and the solution for the legs at times within a piece."""
        state, motor = self.at(when, piece, actuators)
        return motor, self.solved(state, motor, piece.modes)

    def at(self, when: Array, piece: Piece, actuators: Actuators) -> tuple[Motion, Array]:
        """States with their load at n times within a piece, and the motors' forces, N, (n, 6)."""
        states = self.moving(motion_of(piece.interpolant(when).T, piece.center), piece.modes)
        rows = [self.loaded(time, state) for time, state in zip(when.tolist(), states, strict=True)]
        load = {
            name: np.array([getattr(row, name) for row in rows])
            for name in ("F_ext", "M_ext")
            if getattr(rows[0], name) is not None
        }
        states = Motion._unchecked(states.R, states.t, states.omega, states.v, **load)
        return states, actuators.forces(when, states, piece.sampled)

    def moving(self, state: Motion, modes: Modes | None = None) -> Motion:
        """The state without what errors of the integration move legs that stick."""
        modes = self.modes if modes is None else modes
        return self._at_rest(state, [leg for leg in range(LEGS) if modes[leg] == 0])

    # Results

    def results(self, pieces: tuple[Piece, ...], actuators: Actuators, times: Array) -> DriveWork:
        """Work and losses over a run, and friction at times within it, s, (n,)."""
        of = np.searchsorted([piece.start for piece in pieces], times, side="right") - 1
        friction = [
            self._forces(times[j : j + 1], pieces[i], actuators)[1].friction for j, i in enumerate(of)
        ]
        sticks = np.array([pieces[i].modes for i in of], dtype=np.int64).reshape(-1, LEGS) == 0
        done, lost = self._work(pieces, actuators)
        return DriveWork(done, lost, np.array(friction).reshape(-1, LEGS), sticks)

    def _work(self, pieces: tuple[Piece, ...], actuators: Actuators) -> tuple[Array, Array]:
        """Work of the motors and what friction took of it, J, (6,) each."""
        done, lost = np.zeros((2, LEGS))
        for piece in pieces:
            half = 0.5 * (piece.end - piece.start)
            state, motor = self.at(piece.start + half * (1.0 + _GAUSS), piece, actuators)
            moved = half * np.array(piece.modes) ** 2 * leg_rates(self.robot, state).L_dot
            done += _WEIGHTS @ (motor * moved)
            lost += _WEIGHTS @ (self.solved(state, motor, piece.modes).friction * moved)
        return done, lost


def _solved(A: Array, y: Array) -> Array:
    return np.asarray(np.linalg.solve(A, y[..., None])[..., 0])
