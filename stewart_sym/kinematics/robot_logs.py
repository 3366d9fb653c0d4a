"""Logs of a robot, read with the conventions of its robot file: tool point, rotation order, home pose."""

import os
from dataclasses import replace
from functools import partial

import numpy as np

from ..io.array_types import Array
from ..io.error_policy import warn
from ..io.progress import Progress, silent
from ..motion.log_reader import AS_SHOWN, PLAIN, read_log
from ..motion.trajectory import SmoothingOptions, Trajectory
from ..motion.trajectory_format import TrajectoryFormat, TrajectoryWarning
from ..robot.robot import Robot
from .offset_legs import leg_lengths
from .trajectory_checks import log_doubts, need_units


def form_of(robot: Robot, form: TrajectoryFormat = PLAIN) -> TrajectoryFormat:
    """Return the format of the robot's logs; the robot file supplies unspecified settings."""
    order, lengths = form.euler_order or robot.euler_order, form.length_mode or robot.length_mode
    return replace(form, euler_order=order, length_mode=lengths)


def read_log_of(
    robot: Robot,
    path: str | os.PathLike[str],
    form: TrajectoryFormat = PLAIN,
    smoothing: SmoothingOptions = AS_SHOWN,
    progress: Progress = silent,
) -> Trajectory:
    """Read a log whose poses and loads refer to the robot's tool; relative coordinates become absolute.

    Raises the errors of ``read_log``, and ValueError if numbers fit the robot only in another unit that
    neither the format nor the file states. Warns if other numbers do not fit the robot.
    """
    form = form_of(robot, form)
    log = read_log(path, form, smoothing, progress, partial(need_units, robot))
    if form.length_mode == "relative" and log.in_joints:
        log = _with_home(robot, log, leg_lengths(robot, np.eye(3), _home(robot, log)))
    if form.pose_mode == "relative" and not log.in_joints:
        log = _with_home(robot, log, np.concatenate([_home(robot, log) + robot.tool, np.zeros(3)]))
    log = log.of_tool(robot.tool)
    for doubt in log_doubts(robot, log):
        warn(f"{log.source}: {doubt}", TrajectoryWarning)
    return log


def _home(robot: Robot, log: Trajectory) -> Array:
    """Return the home position (m); raise ValueError if the robot has none."""
    if robot.home_position is None:
        raise ValueError(f"{log.source}: relative coordinates; add home_position to the robot file")
    return robot.home_position


def _with_home(robot: Robot, log: Trajectory, home: Array) -> Trajectory:
    """Return the log with coordinates, shape (6,), added to its values."""
    assert log.coordinates is not None
    found = log.coordinates.copy()
    found[0] += home
    if log.in_joints and np.any(found[0] <= 0.0):
        i, leg = (int(index) for index in np.argwhere(found[0] <= 0.0)[0])
        place = f"{log.source}: line {log.rows[i]}: L_{leg + 1}"
        raise ValueError(f"{place}: length {found[0, i, leg]:g} m with the length at home; check length_unit")
    noise = None if log.noise is None else replace(log.noise, coordinates=found)
    return replace(log, coordinates=found, noise=noise)
