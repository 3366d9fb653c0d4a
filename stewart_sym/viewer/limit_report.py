"""Limits of a robot compared with its motion: texts, and status codes at each sample."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..drives.effort import Summary, motor_codes, trapezoids
from ..drives.leg_limits import LegLimits, leg_codes, limited_angles
from ..drives.limit_status import INCONCLUSIVE_NOISE, unknown_forces
from ..drives.motor_states import MotorStates as Motors
from ..drives.motor_states import motor_states, of_motor_forces
from ..io.array_types import Array
from ..motion.sample_times import elapsed, least_step
from ..robot.robot import Robot
from .motion_history import FORMULATIONS, MotionHistory

_OF_LEGS = ("force_limit", "speed_limit", "length_limits", "joint_angle_limit")
_OF_MOTORS = ("torque_limit", "speed_limit", "current_limit", "power_limit", "rated_torque")


@dataclass(frozen=True, eq=False)
class LimitReport:
    """Limits of a robot compared with its motion.

    Attributes
    ----------
    stated : bool
        True if the robot has limits.
    told : tuple of tuple of str
        Status and text of each limit that is exceeded or inconclusive, as in the subcommand ``forces``.
    codes : dict of ndarray, shape (n, 6)
        Indices of ``VERDICTS`` at each sample by quantity: F with its formulation, L, L_dot, and motor
        torque, speed, current, and power.
    F : ndarray, shape (n, 6)
        Forces from which the motor quantities are computed (N).
    motors, summary : MotorStates, Summary, optional
        Motor quantities of each sample and of the whole motion; None without a drive.
    """

    stated: bool
    told: tuple[tuple[str, str], ...]
    codes: Mapping[str, NDArray[np.uint8]]
    F: Array
    motors: Motors | None
    summary: Summary | None


def limits(robot: Robot, shown: MotionHistory) -> LimitReport:
    """Compare a motion with all limits; without forces, only with the limits of lengths and speeds."""
    name, noise = next(iter(shown.forces), None), shown.noise
    F = np.full_like(shown.L, np.nan) if name is None else shown.forces[name]
    sd, there = (None, None) if noise is None else (noise.sd, noise.there)
    legs = LegLimits(robot, shown.time, () if noise is None else noise.replaced)
    values = {"F": F, "L": shown.L, "L_dot": shown.L_dot}
    legs.add(slice(None), values | limited_angles(robot, shown.motion), sd, there)
    unknown = None if noise is None else unknown_forces(F, np.where(noise.there[:, None], 0.0, noise.sd.F))
    told = [*([] if unknown is None else [(INCONCLUSIVE_NOISE, unknown)]), *legs.told()]
    codes = dict(_leg_codes(robot, shown))
    if robot.drive is None:
        return LimitReport(_stated(robot), tuple(told), codes, F, None, None)
    of = motor_states if name in FORMULATIONS else of_motor_forces
    motors = of(robot, robot.drive, shown.motion, F, shown.L_dot)
    motors_sd = None if sd is None else sd.motors
    summary = Summary(robot, least_step(shown.time))
    summary.add(motors, trapezoids(elapsed(shown.time)), shown.time, motors_sd, there)
    codes |= motor_codes(robot.drive, motors, motors_sd, there)
    return LimitReport(_stated(robot), (*told, *summary.told()), codes, F, motors, summary)


def _leg_codes(robot: Robot, shown: MotionHistory) -> Iterator[tuple[str, NDArray[np.uint8]]]:
    noise = shown.noise
    there = None if noise is None else noise.there
    for name, F in shown.forces.items():
        yield f"F_{name}", leg_codes(robot, "F", F, None if noise is None else noise.forces[name], there)
    for name in ("L", "L_dot"):
        sd = None if noise is None else getattr(noise.sd, name)
        yield name, leg_codes(robot, name, getattr(shown, name), sd, there)


def _stated(robot: Robot) -> bool:
    found = [getattr(robot, name) for name in _OF_LEGS]
    if robot.drive is not None:
        found += [getattr(robot.drive, name) for name in _OF_MOTORS]
    return any(bool(np.any(np.isfinite(each) & (np.asarray(each) != 0.0))) for each in found)
