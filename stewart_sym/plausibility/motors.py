"""Doubts about motors: too weak to hold the machine, too slow for the legs."""

from collections.abc import Iterator

import numpy as np

from ..io.array_types import Array
from ..robot.robot import Robot, legs_text
from .level_poses import Doubt

SLOW = 0.3
"""Of a leg's speed limit: a motor chosen for its leg drives it faster than this."""


def of_torques(robot: Robot, F: Array) -> Iterator[Doubt]:
    """Motors that cannot hold the machine at rest by forces F, N, (6,), whatever friction does for them."""
    drive = robot.drive
    if drive is None:
        return
    turns = np.abs(drive.turns)
    friction = drive.screw_coulomb + drive.stribeck + turns * drive.motor_coulomb
    torque = (drive.back_efficiency * np.abs(F) - friction) / turns
    for name in ("torque_limit", "rated_torque"):
        limit = getattr(drive, name)
        with np.errstate(invalid="ignore"):
            weak = np.flatnonzero(torque > limit).tolist()
        if weak:
            worst = max(weak, key=lambda i: float(torque[i] / limit[i]))
            yield Doubt(
                "drive-limit",
                f"{name} of the drives of {legs_text(weak)}: {limit[worst]:.4g} N m, but {torque[worst]:.4g} "
                "N m hold the machine at rest at the home pose; likely cause: a gear left out, lead in "
                "another unit, or motors too weak",
            )
            return


def of_speeds(robot: Robot) -> Iterator[Doubt]:
    """Motors whose speed limits leave the legs a small share of their own."""
    if robot.drive is None:
        return
    speed = robot.drive.speed_limit / np.abs(robot.drive.turns)
    slow = np.flatnonzero((speed < SLOW * robot.speed_limit) & np.isfinite(robot.speed_limit)).tolist()
    if slow:
        i = slow[0]
        yield Doubt(
            "drive-speed",
            f"speed_limit of the drives of {legs_text(slow)}: {speed[i]:.4g} m/s of the leg, whose "
            f"speed_limit is {robot.speed_limit[i]:.4g} m/s; likely cause: revolutions a minute given, "
            "expected angle_unit a second, or a gear counted twice",
        )
