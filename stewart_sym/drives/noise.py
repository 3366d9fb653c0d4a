"""What noise in a log leaves open about forces, legs and motors: standard deviations at every instant.

To first order in the noise, but for two things: of products the product of both deviations counts as well,
and dry friction, which steps, may be that of any rate within ``SURE`` deviations.
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..dynamics.force_noise import CHUNK, displaced, forces_of
from ..dynamics.inverse_dynamics import Backend, Formulation
from ..io.array_types import Array, Flags
from ..kinematics.clearance import angles_between, neutral_directions
from ..kinematics.inverse_kinematics import inverse_kinematics, leg_vectors
from ..motion.motion import Motion
from ..motion.rotation import cross
from ..motion.trajectory import PoseLog, Trajectory
from ..robot.drive import Drive
from ..robot.robot import Robot
from .friction import friction_force, smooth_sign
from .limit_status import SURE
from .motor_states import motor_rates, rotor_force

# Mean square of the product of two normal errors of deviation 1, at most.
_PRODUCT = 3.0


class MotorDeviations(NamedTuple):
    """Standard deviations of fields of ``MotorStates`` of the same name, (n, 6).

    torque_rise, torque_fall: of the torque's size upward and downward: the other direction of dry friction
    makes it either larger or smaller.
    """

    torque: Array
    speed: Array
    current: Array | None
    power: Array
    electrical_power: Array
    torque_rise: Array
    torque_fall: Array


class Deviations(NamedTuple):
    """Standard deviations at n instants, (n, 6); infinite where a pose within the noise is unsolvable.

    F: N. L, L_dot: m and m/s. power: of F L_dot, W. base, platform: of the joints' angles, rad, if they were
    asked for or have limits. motors: of a robot with a drive.
    """

    F: Array
    L: Array
    L_dot: Array
    power: Array
    base: Array | None = None
    platform: Array | None = None
    motors: MotorDeviations | None = None


def deviations_in_parts(
    robot: Robot,
    trajectory: Trajectory | PoseLog,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    neutral: Array | None = None,
) -> Callable[[slice], Deviations]:
    """Deviations of some of the instants, at best 16,384 or fewer.

    neutral: directions from which angles of the joints at base and platform count, (2, 6, 3) or (6, 3); None:
    those of a robot that limits these angles.
    """
    forces = forces_of(robot, formulation, backend)
    if neutral is None and robot.has_joint_angle_limits:
        neutral = neutral_directions(robot)

    def deviations(part: slice) -> Deviations:
        at = _State(robot, trajectory.at(part), forces, neutral)
        found = {name: np.zeros(values.shape) for name, values in at.values.items()}
        products = {name: np.zeros(at.F.shape) for name in at.products(at)}
        for motion in displaced(robot, trajectory, part):
            other = _State(robot, motion, forces, neutral, at.sign)
            with np.errstate(all="ignore"):
                for name, values in other.values.items():
                    found[name] = np.hypot(found[name], _open(values, values - at.values[name]))
                for name, values in at.products(other).items():
                    products[name] = np.hypot(products[name], _open(values, values))
        return _finished(robot, at, found, products)

    return deviations


def all_deviations(
    robot: Robot,
    trajectory: Trajectory | PoseLog,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    neutral: Array | None = None,
) -> Deviations:
    """``deviations_in_parts`` of all instants."""
    some = deviations_in_parts(robot, trajectory, formulation, backend, neutral)
    parts = [some(slice(i, i + CHUNK)) for i in range(0, len(trajectory.time), CHUNK)]
    motors = [part.motors for part in parts if part.motors is not None]
    joined = Deviations(*_joined([part[:-1] for part in parts]))
    return joined._replace(motors=MotorDeviations(*_joined(motors)) if motors else None)


def at_replaced(trajectory: Trajectory | PoseLog, time: Array) -> Flags:
    """Instants, (n,), whose deviations hold what is changed by replaced rows of a log."""
    found = np.zeros(len(time), dtype=bool)
    for span in () if trajectory.noise is None else trajectory.noise.replaced:
        found |= (span.start <= time) & (time <= span.end)
    return found


def _joined(parts: Sequence[tuple[Any, ...]]) -> list[Any]:
    return [None if each[0] is None else np.concatenate(each) for each in zip(*parts, strict=True)]


def _open(values: Array, changes: Array) -> Array:
    return np.where(np.isfinite(values), changes, np.inf)


class _State:
    """What a motion takes, (n, 6) by name: F, L, L_dot, base, platform, and of motors force and rate.

    sign: of dry friction, held where the motion is displaced; None: that of the rates.
    """

    def __init__(
        self,
        robot: Robot,
        motion: Motion,
        forces: Callable[[Motion], Array],
        neutral: Array | None,
        sign: Array | None = None,
    ) -> None:
        self.F, (L, self.L_dot, s) = forces(motion), reached_legs(robot, motion)
        self.values = {"F": self.F, "L": L, "L_dot": self.L_dot}
        if neutral is not None:
            base, platform = np.broadcast_to(neutral, (2, *s.shape[1:]))
            self.values |= {"base": angles_between(s, base)}
            self.values |= {"platform": angles_between(s @ motion.R, platform)}
        self.drive, self.sign = robot.drive, sign
        if self.drive is not None:
            self.rate = motor_rates(robot, self.drive, motion, self.L_dot)
            if sign is None:
                self.sign = smooth_sign(self.rate, np.asarray(self.drive.regularization_speed))
            # Without losses in proportion to the force it does not matter which part of it turns the rotor.
            losses = np.any(self.drive.efficiency != 1.0) or np.any(self.drive.backdrive_efficiency != 1.0)
            self.through = self.F - rotor_force(robot, motion) if losses else self.F
            self.force = self.F + friction_force(self.drive, self.through, self.rate, self.sign)
            self.values |= {"force": self.force, "rate": self.rate}

    def products(self, other: "_State") -> dict[str, Array]:
        """Changes of powers and heat, W, from this to another state, to first order."""
        found = {"power": self.F * (other.L_dot - self.L_dot) + self.L_dot * (other.F - self.F)}
        if self.drive is not None:
            change = other.force - self.force
            found["shaft"] = self.force * (other.rate - self.rate) + self.rate * change
            found["electrical"] = found["shaft"] + 2.0 * _heat(self.drive) * self.force * change
        return found


def reached_legs(robot: Robot, motion: Motion) -> tuple[Array, Array, Array]:
    """Lengths, rates and directions of the legs; NaN where the legs of offset joints do not reach."""
    if robot.offsets is None:
        with np.errstate(all="ignore"):
            q, S, L = leg_vectors(robot, motion.R, motion.t)
            s = S / L[..., None]
            rates = motion.v[:, None] + cross(motion.omega[:, None], q)
            return L, np.einsum("nli,nli->nl", s, rates), s
    try:
        legs = inverse_kinematics(robot, motion)
        return legs.L, legs.L_dot, legs.s
    except ValueError:
        L, L_dot, s = (np.full((*motion.shape, 6, *core), np.nan) for core in ((), (), (3,)))
        for i in range(len(L)):
            try:
                legs = inverse_kinematics(robot, motion[i])
            except ValueError:
                continue
            L[i], L_dot[i], s[i] = legs.L, legs.L_dot, legs.s
        return L, L_dot, s


def _heat(drive: Drive) -> Array:
    """Heat of the windings per square of the motor's force along the leg, W/N^2, (6,)."""
    constant = np.asarray(drive.transmission_ratio * drive.torque_constant)
    known = constant != 0.0
    heat = np.where(known, np.asarray(drive.resistance), 0.0) / np.where(known, constant, 1.0) ** 2
    return np.asarray(heat)


def _finished(robot: Robot, at: _State, sd: dict[str, Array], products: dict[str, Array]) -> Deviations:
    sd = {name: np.where(np.isfinite(at.values[name]), each, np.nan) for name, each in sd.items()}
    power = _with_product(products["power"], sd["F"], sd["L_dot"])
    found = Deviations(sd["F"], sd["L"], sd["L_dot"], power, sd.get("base"), sd.get("platform"))
    if robot.drive is None:
        return found
    drive, turns = robot.drive, np.abs(robot.drive.transmission_ratio)
    step, rise, fall = _steps(drive, at, sd["rate"])
    force = np.hypot(sd["force"], step)
    shaft = np.hypot(products["shaft"], _times(step, np.abs(at.rate)))
    by_step = _times(step, np.abs(at.rate) + 2.0 * _heat(drive) * np.abs(at.force))
    electrical = _with_product(np.hypot(products["electrical"], by_step), force, sd["rate"])
    torque, current = force / turns, None
    if np.any(drive.torque_constant):
        known = drive.torque_constant > 0.0
        current = torque / np.where(known, drive.torque_constant, np.nan)
        electrical = _with_product(electrical, _heat(drive) * force, force)
    shaft = _with_product(shaft, force, sd["rate"])
    sides = (np.hypot(sd["force"], side) / turns for side in (rise, fall))
    motors = MotorDeviations(torque, turns * sd["rate"], current, shaft, electrical, *sides)
    return found._replace(motors=motors)


def _steps(drive: Drive, at: _State, sd: Array) -> Array:
    """Deviations, N, (3, n, 6), by dry friction of any direction within ``SURE`` deviations of the rate.

    Of the motor's force, and of its size upward and downward.
    """
    found = np.zeros((3, *at.force.shape))
    for side in (-SURE, SURE):
        sign = smooth_sign(at.rate + side * sd, np.asarray(drive.regularization_speed))
        other = at.F + friction_force(drive, at.through, at.rate, sign)
        larger = np.abs(other) - np.abs(at.force)
        found = np.maximum(found, [np.abs(other - at.force), larger, -larger])
    return found / SURE


def _times(x: Array, y: Array) -> Array:
    """Product of deviations, 0 where one is."""
    with np.errstate(invalid="ignore"):
        return np.asarray(np.where((x == 0.0) | (y == 0.0), 0.0, x * y))


def _with_product(sd: Array, one: Array, other: Array) -> Array:
    """A product's deviation to first order with that of the product of its factors' errors."""
    return np.asarray(np.hypot(sd, np.sqrt(_PRODUCT) * _times(one, other)))
