"""Home pose: given in the robot file, or a level platform above the base from which studies start."""

from dataclasses import dataclass

import numpy as np

from ..io.array_types import Array
from ..kinematics.conditioning import characteristic_length, condition_number, scaled_condition_number
from ..kinematics.inverse_kinematics import leg_lengths, wrench_matrix
from ..kinematics.mounting_side import Side, level_positions, platform_side, up_direction
from ..motion.motion import Motion
from ..robot.robot import Robot
from .inverse_dynamics import inverse_dynamics


@dataclass(frozen=True, eq=False)
class HomePose:
    """Level platform at rest at the given home position, or with its points centered above the base points.

    side: side of the base on which the platform is. rule: rule by which the position was chosen. t: position
    of the reference point (m), (3,). L: leg lengths (m), (6,). F: forces that balance the platform (N), (6,),
    NaN if there are none or masses are missing. condition, scaled_condition: condition numbers of H. status:
    code of ``STATUS_TEXT``.
    """

    side: Side
    rule: str
    t: Array
    L: Array
    F: Array
    condition: float
    scaled_condition: float
    status: int


def home_pose(robot: Robot) -> HomePose:
    """Return the home pose of the robot file, or choose a height.

    The height puts the legs in the middle of their limits; without limits, it minimizes the scaled condition
    number of H.
    """
    length = characteristic_length(robot)
    t = (
        level_positions(robot, up_direction(robot))
        if robot.home_position is None
        else robot.home_position[None]
    )
    L = leg_lengths(robot, np.eye(3), t)
    if robot.home_position is not None:
        rule = "from the robot file"
    elif np.all(np.isfinite(robot.length_limits)):
        rule = "height at which the mean leg length is in the middle of its limits"
        amid = int(np.argmin(np.abs(L.mean(axis=-1) - robot.length_limits.mean())))
        t, L = t[amid, None], L[amid, None]
    else:
        rule = "height with the smallest scaled condition number, because no length limits are given"
    rest = Motion.at_rest(np.eye(3), t)
    if robot.missing_bodies:
        H, F = wrench_matrix(robot, rest), np.full((len(t), 6), np.nan)
        status = np.zeros(len(t), dtype=np.int32)
    else:
        forces = inverse_dynamics(robot, rest, backend="numpy", on_singular="nan")
        H, F, status = forces.H, forces.F, forces.status
    scaled = scaled_condition_number(H, length)
    best = int(np.argmin(np.nan_to_num(scaled, nan=np.inf)))
    return HomePose(
        side=platform_side(robot),
        rule=rule,
        t=t[best],
        L=L[best],
        F=F[best],
        condition=float(condition_number(H[best])),
        scaled_condition=float(scaled[best]),
        status=int(status[best]),
    )
