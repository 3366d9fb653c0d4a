"""Limits of a robot compared with its motion: texts, and status codes at each sample."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..drives.limit_status import INCONCLUSIVE_NOISE, unknown_forces
from ..drives.limits import LimitTracker, limit_codes, limited_angles, limits_of
from ..drives.motor_states import MotorStates as Motors
from ..drives.motor_states import motor_states, of_motor_forces
from ..io.array_types import Array
from ..robot.robot import Robot
from .motion_history import FORMULATIONS, MotionHistory


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
    motors : MotorStates, optional
        Motor quantities of each sample; None without a drive.
    tracker : LimitTracker
        Status of the limits, and motor quantities of the whole motion.
    """

    stated: bool
    told: tuple[tuple[str, str], ...]
    codes: Mapping[str, NDArray[np.uint8]]
    F: Array
    motors: Motors | None
    tracker: LimitTracker


def limits(robot: Robot, shown: MotionHistory) -> LimitReport:
    """Compare a motion with all limits; without forces, only with the limits of lengths and speeds."""
    first, noise = next(iter(shown.forces), None), shown.noise
    F = np.full_like(shown.L, np.nan) if first is None else shown.forces[first]
    sd, there = (None, None) if noise is None else (noise.sd, noise.there)
    tracker = LimitTracker(robot, shown.time, () if noise is None else noise.replaced)
    lengths = {"L": shown.L, "L_dot": shown.L_dot}
    values = {"F": F, **lengths, **limited_angles(robot, shown.motion)}
    codes = limit_codes(robot, lengths, sd, there)
    for name, forces in shown.forces.items():
        off = None if noise is None else {"F": noise.forces[name]}
        codes[f"F_{name}"] = limit_codes(robot, {"F": forces}, off, there)["F"]
    motors = None
    if robot.drive is not None:
        of = motor_states if first in FORMULATIONS else of_motor_forces
        motors = of(robot, robot.drive, shown.motion, F, shown.L_dot)
        values |= motors._asdict()
        codes |= limit_codes(robot, motors._asdict(), sd, there)
    tracker.add(slice(None), values, sd, there)
    unknown = None if noise is None else unknown_forces(F, np.where(noise.there[:, None], 0.0, noise.sd["F"]))
    told = [*([] if unknown is None else [(INCONCLUSIVE_NOISE, unknown)]), *tracker.told()]
    stated = any(limit.is_stated(robot) for limit in limits_of(robot))
    return LimitReport(stated, tuple(told), codes, F, motors, tracker)
