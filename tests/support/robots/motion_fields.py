"""Fields of a motion, motions by coordinates and of several, their work, and the vector of a matrix."""

from collections.abc import Callable, Iterable
from types import ModuleType
from typing import NamedTuple

import numpy as np
from machines import Array, path_period
from numpy.typing import ArrayLike

from stewart_sym.motion.motion import Motion
from stewart_sym.reference import newton_euler
from stewart_sym.robot.robot import Robot

FIELDS = ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext")
UNLOADED = FIELDS[:6]


def waves(time: Array, middle: ArrayLike, size: ArrayLike, rate: ArrayLike, phase: ArrayLike) -> Array:
    """Coordinates middle + size sin(rate t + phase) with two derivatives, (3, n, 6)."""
    w, angle = np.asarray(rate), np.multiply.outer(time, rate) + phase
    return np.array([middle + size * np.sin(angle), size * w * np.cos(angle), -size * w**2 * np.sin(angle)])


def motion_of(values: Array, **loads: ArrayLike) -> Motion:
    """The motion of coordinates with two derivatives, (3, ..., 6)."""
    (t, theta), (v, theta_dot), (a, theta_ddot) = ((x[..., :3], x[..., 3:]) for x in values)
    return Motion.from_rpy(t, theta, v, theta_dot, a, theta_ddot, **loads)


def stacked(motions: Iterable[Motion], names: tuple[str, ...] = FIELDS) -> Motion:
    """Motions of one instant as a batch."""
    every = list(motions)
    return Motion(**{name: np.stack([getattr(motion, name) for motion in every]) for name in names})


def skew_part(matrix: Array) -> Array:
    """The vector whose matrix is the skew part of a matrix, (..., 3)."""
    off = matrix - np.swapaxes(matrix, -1, -2)
    return 0.5 * np.stack([off[..., 2, 1], off[..., 0, 2], off[..., 1, 0]], axis=-1)


def acceleration(motion: Motion) -> Array:
    """[a; alpha], (..., 6)."""
    assert motion.a is not None
    assert motion.alpha is not None
    return np.concatenate([motion.a, motion.alpha], axis=-1)


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
