"""Machines and poses of which no pose is solvable, each with its status."""

import dataclasses
from collections.abc import Callable

import numpy as np
from machines import dasgupta, rotation
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.motion import motion

BACKENDS = ["c", "numpy", "reference"]


def at_rest(t: list[float]) -> ss.Motion:
    return motion.at_rest(np.eye(3), np.array(t))


def zero_length_leg() -> tuple[ss.Robot, ss.Motion]:
    robot = dasgupta()
    return robot, at_rest(list(robot.b[2] - robot.p[2]))


def leg_along_its_axis() -> tuple[ss.Robot, ss.Motion]:
    robot, t = dasgupta(), np.array([0.1, 0.0, 0.5])
    axes = np.array(robot.k)
    axes[4] = robot.p[4] + t - robot.b[4]
    return dataclasses.replace(robot, k=axes), at_rest(list(t))


def semiregular(corners: list[float], radius: float) -> NDArray[np.float64]:
    angles = np.radians(corners)
    return radius * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(6)])


def singular() -> tuple[ss.Robot, ss.Motion]:
    """A machine of threefold symmetry turned by 90 degrees about its axis: its legs cannot hold the yaw."""
    base, plate = [-12, 12, 108, 132, 228, 252], [-45, 45, 75, 165, 195, 285]
    robot = dataclasses.replace(
        dasgupta(), b=semiregular(base, 1.0), p=semiregular(plate, 0.5), k=np.tile([0.0, 0.0, 1.0], (6, 1))
    )
    zero = np.zeros(3)
    return robot, ss.Motion.from_rpy([0, 0, 1.0], [0, 0, np.pi / 2], zero, zero, zero, zero)


def hexagons(turn: float) -> tuple[ss.Robot, NDArray[np.float64]]:
    """Base and platform similar hexagons, long sides of one above short sides of the other; turned, rad."""
    base, plate = [-12, 12, 108, 132, 228, 252], [-48, 48, 72, 168, 192, 288]
    robot = dataclasses.replace(dasgupta(), b=semiregular(base, 1.0), p=semiregular(plate, 0.6))
    return robot, rotation(np.array([0.0, 0.0, turn]))


Case = tuple[Callable[[], tuple[ss.Robot, ss.Motion]], int, str]
CASES: dict[str, Case] = {
    "short": (zero_length_leg, results.ZERO_LENGTH, "length zero (leg 3)"),
    "joint singularity": (leg_along_its_axis, results.JOINT_SINGULAR, "universal joint (leg 5)"),
    "singular": (singular, results.SINGULAR, "H is singular"),
}
