"""Motor torque, speed, current, and power at each sample of a motion."""

from typing import NamedTuple

import numpy as np

from ..io.array_types import Array
from ..motion.motion import Motion
from ..reference import newton_euler, offset_joints
from ..robot.drive import Drive
from ..robot.offset_chains import joint_motion, motor_motion
from ..robot.robot import Robot
from .friction import dry_sign, friction_force


class MotorStates(NamedTuple):
    """Fields of ``DriveEffortResult`` that have a value at every sample, shape (..., 6)."""

    force: Array
    friction: Array
    rotor: Array
    torque: Array
    speed: Array
    current: Array | None
    power: Array
    electrical_power: Array


def motor_states(
    robot: Robot, drive: Drive, motion: Motion, F: Array, L_dot: Array, side: Array | None = None
) -> MotorStates:
    """Compute the motor quantities from forces of ``inverse_dynamics`` (N) and leg rates (m/s), (..., 6).

    ``side`` contains the signs of the rates just before or after each sample, shape (..., 6); None for the
    signs at the sample. NaN forces give NaN results.
    """
    rotor, L_dot = rotor_force(robot, motion), motor_rates(robot, drive, motion, L_dot)
    sign = None if side is None else dry_sign(drive, L_dot, side)
    friction = friction_force(drive, F - rotor, L_dot, sign)
    return _instants(drive, F + friction, friction, rotor, L_dot)


def rotor_force(robot: Robot, motion: Motion) -> Array:
    """Return the part of the motor forces that accelerates the rotors (N), shape (..., 6)."""
    with np.errstate(all="ignore"):
        of = newton_euler if robot.offsets is None else offset_joints
        return np.asarray(of.rotor_force(robot, motion))


def of_motor_forces(robot: Robot, drive: Drive, motion: Motion, force: Array, L_dot: Array) -> MotorStates:
    """Compute the motor quantities from motor forces, N times torque (N), (..., 6); others are NaN."""
    unknown = np.full(np.shape(force), np.nan)
    return _instants(drive, force, unknown, unknown, motor_rates(robot, drive, motion, L_dot))


def _instants(drive: Drive, force: Array, friction: Array, rotor: Array, L_dot: Array) -> MotorStates:
    torque = force / drive.transmission_ratio
    speed = drive.transmission_ratio * L_dot
    power = electrical = torque * speed
    current = None
    if np.any(drive.torque_constant):
        known = drive.torque_constant > 0.0
        current = torque / np.where(known, drive.torque_constant, np.nan)
        electrical = power + np.where(known, np.asarray(drive.resistance) * current**2, 0.0)
    return MotorStates(force, friction, rotor, torque, speed, current, power, electrical)


def motor_rates(robot: Robot, drive: Drive, motion: Motion, L_dot: Array) -> Array:
    """Return motor speeds over transmission ratios (m/s), (..., 6): L_dot unless parts turn in nuts."""
    if robot.offsets is None:
        return L_dot
    with np.errstate(all="ignore"):
        return motor_motion(robot, joint_motion(robot, motion).rates) / np.asarray(drive.transmission_ratio)
