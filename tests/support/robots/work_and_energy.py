"""Work of all powers along a path beside the energy that the bodies gain."""

from collections.abc import Callable
from types import ModuleType
from typing import NamedTuple

import numpy as np
from machines import Array, path_period

from stewart_sym.motion.motion import Motion
from stewart_sym.reference import newton_euler
from stewart_sym.robot.robot import Robot

NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


class Balance(NamedTuple):
    """What the work of all powers is more than the gain of energy, and what each moves to and fro, J."""

    mismatch: float
    moved: dict[str, float]

    @property
    def turnover(self) -> float:
        return sum(self.moved.values())


def breaks_of(robot: Robot) -> Array:
    """Ends of stretches that are smooth enough for one Gauss-Legendre rule each, s."""
    return np.linspace(0, 0.7 * path_period(robot), 9)


def balance_of(
    robot: Robot,
    path: Callable[[Array], Motion],
    actuators: Callable[[Motion], Array],
    reference: ModuleType = newton_euler,
) -> Balance:
    """Along a path; ``actuators`` gives their power, W."""
    breaks = breaks_of(robot)
    half = np.diff(breaks)[:, None] / 2
    motion, weights = path((breaks[:-1, None] + half * (NODES + 1)).ravel()), (half * WEIGHTS).ravel()
    powers = {
        "actuators": actuators(motion),
        "load": newton_euler.external_power(robot, motion),
        "friction": -reference.friction_power(robot, motion),
    }
    gain = np.diff(reference.energy(robot, path(breaks[[0, -1]])))[0]
    mismatch = float(weights @ sum(powers.values()) - gain)
    return Balance(mismatch, {name: float(weights @ np.abs(power)) for name, power in powers.items()})
