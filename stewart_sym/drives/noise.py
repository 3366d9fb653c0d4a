"""Standard deviations of forces, leg motion, and motor quantities at every sample, due to noise in a log.

They are of first order in the noise with two exceptions. Products include the product of both errors, and dry
friction, which is discontinuous, takes the value of any rate within ``SURE`` standard deviations.
"""

from collections.abc import Callable

import numpy as np

from ..dynamics.force_noise import CHUNK, between, displaced, near_knots
from ..dynamics.forces import forces_of
from ..dynamics.inverse_dynamics import Backend, Formulation
from ..io.array_types import Array, Flags
from ..kinematics.clearance import angles_between, neutral_directions
from ..kinematics.inverse_kinematics import inverse_kinematics, leg_vectors
from ..motion.motion import Motion
from ..motion.rotation import cross
from ..motion.trajectory import Trajectory
from ..robot.drive import Drive
from ..robot.robot import Robot
from .friction import friction_force, smooth_sign
from .limit_status import SURE
from .motor_states import motor_rates, rotor_force

# Largest mean square of the product of two normal errors with standard deviation 1.
_PRODUCT = 3.0


Deviations = dict[str, Array]
"""Standard deviations at n samples by quantity, (n, 6); infinite if a pose within the noise is unsolvable.

F: actuator forces (N). L, L_dot: leg lengths (m) and rates (m/s). leg_power: mechanical power F L_dot (W).
base, platform: joint angles (rad), if they are requested or limited. A drive adds the quantities of
``MotorStates`` that have units other than N. torque_rise, torque_fall, current_rise, current_fall: standard
deviations of the magnitudes, upward and downward. They differ because the opposite direction of dry friction
makes the magnitude either larger or smaller.
"""


def deviations_in_parts(
    robot: Robot,
    trajectory: Trajectory,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    neutral: Array | None = None,
) -> Callable[..., Deviations]:
    """Return a function that computes the standard deviations of a slice of at most about 16,384 samples.

    Further arguments of the function are the motion of these samples and its forces (N), if they are known.
    ``neutral`` contains the directions from which joint angles at base and platform are measured, (2, 6, 3)
    or (6, 3); None for the neutral directions of a robot that limits these angles.
    """
    forces = forces_of(robot, formulation, backend)
    if neutral is None and robot.has_joint_angle_limits:
        neutral = neutral_directions(robot)

    def deviations(part: slice, motion: Motion | None = None, F: Array | None = None) -> Deviations:
        rows, time = near_knots(trajectory, part), trajectory.time
        motion = trajectory.at(part) if motion is None else motion
        # Changes of forces are differences of results of one kernel.
        at = _State(robot, motion, forces, neutral, F=F if len(rows) < len(motion.t) else None)
        some = at if len(rows) == len(at.F) else _State(robot, trajectory.at(rows), forces, neutral)
        found = {name: np.zeros(values.shape) for name, values in some.values.items()}
        products = {name: np.zeros(some.F.shape) for name in some.products(some)}
        for moved in displaced(robot, trajectory, rows):
            other = _State(robot, moved, forces, neutral, some.sign)
            with np.errstate(all="ignore"):
                for name, values in other.values.items():
                    found[name] = np.hypot(found[name], _open(values, values - some.values[name]))
                for name, values in some.products(other).items():
                    products[name] = np.hypot(products[name], _open(values, values))
        found, products = (
            {name: between(time[part], time[rows], sd) for name, sd in each.items()}
            for each in (found, products)
        )
        return _finished(robot, at, found, products)

    return deviations


def all_deviations(
    robot: Robot,
    trajectory: Trajectory,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    neutral: Array | None = None,
) -> Deviations:
    """Compute ``deviations_in_parts`` for all samples."""
    some = deviations_in_parts(robot, trajectory, formulation, backend, neutral)
    parts = [some(slice(i, i + CHUNK)) for i in range(0, len(trajectory.time), CHUNK)]
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def at_replaced(trajectory: Trajectory, time: Array) -> Flags:
    """Return True for samples, shape (n,), whose standard deviations include replaced rows of a log."""
    found = np.zeros(len(time), dtype=bool)
    for span in () if trajectory.noise is None else trajectory.noise.replaced:
        found |= (span.start <= time) & (time <= span.end)
    return found


def _open(values: Array, changes: Array) -> Array:
    return np.where(np.isfinite(values), changes, np.inf)


class _State:
    """Values of a motion by name, (n, 6), with the sign of dry friction, which displaced motions keep."""

    def __init__(
        self,
        robot: Robot,
        motion: Motion,
        forces: Callable[[Motion], Array],
        neutral: Array | None,
        sign: Array | None = None,
        F: Array | None = None,
    ) -> None:
        (L, self.L_dot, s), self.F = reached_legs(robot, motion), forces(motion) if F is None else F
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
            # Only losses proportional to the force depend on the part of it that accelerates the rotor.
            losses = np.any(self.drive.efficiency != 1.0) or np.any(self.drive.backdrive_efficiency != 1.0)
            self.through = self.F - rotor_force(robot, motion) if losses else self.F
            self.force = self.F + friction_force(self.drive, self.through, self.rate, self.sign)
            self.values |= {"force": self.force, "rate": self.rate}

    def products(self, other: "_State") -> dict[str, Array]:
        """Return the first-order changes of powers and heat (W) from this state to another."""
        found = {"power": self.F * (other.L_dot - self.L_dot) + self.L_dot * (other.F - self.F)}
        if self.drive is not None:
            change = other.force - self.force
            found["shaft"] = self.force * (other.rate - self.rate) + self.rate * change
            found["electrical"] = found["shaft"] + 2.0 * _heat(self.drive) * self.force * change
        return found


def reached_legs(robot: Robot, motion: Motion) -> tuple[Array, Array, Array]:
    """Return lengths, rates, and directions of the legs; NaN if offset joints do not reach the pose."""
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
    """Return the winding heat per squared motor force along the leg (W/N^2), shape (6,)."""
    constant = np.asarray(drive.transmission_ratio * drive.torque_constant)
    known = constant != 0.0
    heat = np.where(known, np.asarray(drive.resistance), 0.0) / np.where(known, constant, 1.0) ** 2
    return np.asarray(heat)


def _finished(robot: Robot, at: _State, sd: Deviations, products: Deviations) -> Deviations:
    sd = {name: np.where(np.isfinite(at.values[name]), each, np.nan) for name, each in sd.items()}
    found = {name: each for name, each in sd.items() if name not in ("force", "rate")}
    found["leg_power"] = _with_product(products["power"], sd["F"], sd["L_dot"])
    if robot.drive is None:
        return found
    drive, turns = robot.drive, np.abs(robot.drive.transmission_ratio)
    step, rise, fall = _steps(drive, at, sd["rate"])
    force = np.hypot(sd["force"], step)
    shaft = np.hypot(products["shaft"], _times(step, np.abs(at.rate)))
    by_step = _times(step, np.abs(at.rate) + 2.0 * _heat(drive) * np.abs(at.force))
    electrical = _with_product(np.hypot(products["electrical"], by_step), force, sd["rate"])
    found |= {"torque": force / turns, "speed": turns * sd["rate"]}
    found |= {"power": _with_product(shaft, force, sd["rate"]), "electrical_power": electrical}
    for name, side in (("torque_rise", rise), ("torque_fall", fall)):
        found[name] = np.hypot(sd["force"], side) / turns
    if np.any(drive.torque_constant):
        found["electrical_power"] = _with_product(electrical, _heat(drive) * force, force)
        constant = np.where(drive.torque_constant > 0.0, drive.torque_constant, np.nan)
        found |= {f"current{side}": found[f"torque{side}"] / constant for side in ("", "_rise", "_fall")}
    return found


def _steps(drive: Drive, at: _State, sd: Array) -> Array:
    """Return deviations (N), (3, n, 6), by dry friction: of the force, and of its magnitude up and down."""
    found = np.zeros((3, *at.force.shape))
    for side in (-SURE, SURE):
        sign = smooth_sign(at.rate + side * sd, np.asarray(drive.regularization_speed))
        other = at.F + friction_force(drive, at.through, at.rate, sign)
        larger = np.abs(other) - np.abs(at.force)
        found = np.maximum(found, [np.abs(other - at.force), larger, -larger])
    return found / SURE


def _times(x: Array, y: Array) -> Array:
    """Return the product of standard deviations; 0 if one factor is 0."""
    with np.errstate(invalid="ignore"):
        return np.asarray(np.where((x == 0.0) | (y == 0.0), 0.0, x * y))


def _with_product(sd: Array, one: Array, other: Array) -> Array:
    """Return the first-order standard deviation of a product, combined with the product of the errors."""
    return np.asarray(np.hypot(sd, np.sqrt(_PRODUCT) * _times(one, other)))
