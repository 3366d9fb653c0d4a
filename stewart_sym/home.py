"""A home pose: the level platform above the base, where studies and excitations start from.

Stands above ``dynamics``, whose H says which height is good; knows nothing of what is done there.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .conditioning import characteristic_length, condition_number, scaled_condition_number
from .dynamics import inverse_dynamics
from .motion import Motion
from .robot import Robot

Array = NDArray[np.float64]

_HEIGHTS = 400


@dataclass(frozen=True, eq=False)
class HomePose:
    """The level platform at rest, its points centred above the base points (along z of the base frame).

    rule: how the height was chosen. t: position of the reference point, m, (3,). L: leg lengths, m, (6,).
    F: forces that hold it there, N, (6,), NaN if none can. condition, scaled_condition: of H. status: a code
    of ``STATUS_TEXT``.
    """

    rule: str
    t: Array
    L: Array
    F: Array
    condition: float
    scaled_condition: float
    status: int


def home_pose(robot: Robot) -> HomePose:
    """Choose a height: legs in the middle of their length limits, or where there are none H at its best."""
    centre = robot.b.mean(axis=0) - robot.p.mean(axis=0)
    size = radius(robot.b) + radius(robot.p)
    up = np.linspace(0.05, 3.0, _HEIGHTS)[:, None] * size * np.array([0.0, 0.0, 1.0])
    t = centre + up
    L = _lengths(robot, t)
    forces = inverse_dynamics(robot, _resting(t), backend="numpy", on_singular="nan")
    scaled = scaled_condition_number(forces.H, characteristic_length(robot))
    if np.all(np.isfinite(robot.length_limits)):
        rule = "the height that puts the legs, on average, in the middle of their length limits"
        best = int(np.argmin(np.abs(L.mean(axis=-1) - robot.length_limits.mean())))
    else:
        rule = "no length limits are given: the height with the least scaled condition number"
        best = int(np.argmin(np.nan_to_num(scaled, nan=np.inf)))
    return HomePose(
        rule=rule,
        t=t[best],
        L=L[best],
        F=forces.F[best],
        condition=float(condition_number(forces.H[best])),
        scaled_condition=float(scaled[best]),
        status=int(forces.status[best]),
    )


def radius(points: Array) -> float:
    """Root mean square distance of points (n, 3) from their mean, m."""
    return float(np.sqrt(np.mean(np.sum((points - points.mean(axis=0)) ** 2, axis=-1))))


def _lengths(robot: Robot, t: Array) -> Array:
    return np.asarray(np.linalg.norm(t[:, None, :] + robot.p - robot.b, axis=-1))


def _resting(t: Array) -> Motion:
    zero = np.zeros(3)
    return Motion(np.eye(3), t, zero, zero, zero, zero)
