"""Columns of a motion in the trajectory format that ``forces`` reads."""

import numpy as np

from ...io.array_types import Array
from ...motion.motion import Motion
from ...motion.rotation import angle_rates, angles_from_rotation, distance_from_lock
from ...robot.robot import Robot
from .output import Columns, of_axes, of_rotations

_PLAIN = 0.05
"""Smallest distance from gimbal lock at which angles are written (rad)."""


def trajectory_columns(robot: Robot, times: Array, motion: Motion) -> Columns:
    """Return poses of the tool of the robot, rates if the motion has accelerations, and the load at the tool.

    Angles are in the ``euler_order`` of the robot. Near gimbal lock, quaternions without rates are written.
    """
    at_tool = motion.at_point(robot.tool) if robot.tool.any() else motion
    theta = np.unwrap(angles_from_rotation(at_tool.R, robot.euler_order), axis=0)
    columns: Columns = {"time": times, **of_axes("t", at_tool.t)}
    if distance_from_lock(theta, robot.euler_order).min() < _PLAIN:
        columns |= of_rotations(at_tool.R)
    else:
        columns |= of_axes("theta", theta) | _rates(at_tool, theta, robot.euler_order)
    for name, load in (("F_ext", at_tool.F_ext), ("M_ext", at_tool.M_ext)):
        columns |= {} if load is None else of_axes(name, load)
    return columns


def _rates(motion: Motion, theta: Array, order: str) -> Columns:
    """Return the columns of all first and second derivatives; none for a motion without accelerations."""
    if motion.alpha is None or motion.a is None:
        return {}
    theta_dot, theta_ddot = angle_rates(theta, motion.omega, motion.alpha, order)
    return (
        of_axes("v", motion.v)
        | of_axes("theta_dot", theta_dot)
        | of_axes("a", motion.a)
        | of_axes("theta_ddot", theta_ddot)
    )
