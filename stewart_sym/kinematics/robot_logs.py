"""Logs of a robot, read as its file says that they are written: tool point, order of rotations, lengths."""

import dataclasses
import os
from functools import partial

import numpy as np

from ..io.array_types import Array
from ..io.error_policy import warn
from ..io.progress import Progress, silent
from ..motion.log_reader import AS_SHOWN, PLAIN, read_log, trajectory_from, with_units_of
from ..motion.logs import TrajectoryFormat
from ..motion.noise_level import TrajectoryWarning
from ..motion.trajectory import JointTrajectory, PoseLog, SmoothingOptions, Trajectory
from ..robot.robot import Robot
from .offset_legs import leg_lengths
from .trajectory_checks import log_doubts, need_units


def form_of(robot: Robot, form: TrajectoryFormat = PLAIN) -> TrajectoryFormat:
    """How the robot's logs are written, where the form does not say otherwise."""
    order, lengths = form.euler_order or robot.euler_order, form.length_mode or robot.length_mode
    return dataclasses.replace(form, euler_order=order, length_mode=lengths)


def read_log_of(
    robot: Robot,
    path: str | os.PathLike[str],
    form: TrajectoryFormat = PLAIN,
    smoothing: SmoothingOptions = AS_SHOWN,
    progress: Progress = silent,
) -> PoseLog | JointTrajectory:
    """Read a log whose poses and loads are those of the robot's tool; relative lengths become absolute.

    What the form leaves open is the robot's. Motions made of the result are those of the reference point.
    Raises as ``read_log``, and ValueError for relative lengths without a home pose, or of legs that have none
    left. Raises ValueError for numbers that fit the robot in another unit only, if neither the form nor the
    file states the unit. Warns of other numbers that do not fit the robot.
    """
    log = read_log(path, form_of(robot, form), smoothing, progress, partial(need_units, robot))
    if isinstance(log, PoseLog):
        log = log.of_tool(robot.tool)
    else:
        log = _loaded_at(robot.tool, _absolute(robot, log) if log.relative else log)
    for doubt in log_doubts(robot, log, with_units_of(path, form).length_unit or "m"):
        warn(f"{log.source}: {doubt}", TrajectoryWarning)
    return log


def _loaded_at(tool: Array, log: JointTrajectory) -> JointTrajectory:
    """The log with its load, which acts at a point, m, platform frame, (3,), at the reference point."""
    if log.F_ext is None or not tool.any():
        return log
    moment = np.cross(tool, log.F_ext)
    return log._replace(M_ext=moment if log.M_ext is None else log.M_ext + moment)


def trajectory_for(
    robot: Robot,
    path: str | os.PathLike[str],
    form: TrajectoryFormat = PLAIN,
    smoothing: SmoothingOptions = AS_SHOWN,
) -> Trajectory | JointTrajectory:
    """Read a log as ``read_log_of``, of poses as a motion of the reference point."""
    log = read_log_of(robot, path, form, smoothing)
    return trajectory_from(log) if isinstance(log, PoseLog) else log


def _absolute(robot: Robot, log: JointTrajectory) -> JointTrajectory:
    """The log with the lengths at the home pose added."""
    if robot.home_position is None:
        raise ValueError(f"{log.source}: relative lengths: expected a robot file with a key home_position")
    L = log.L + leg_lengths(robot, np.eye(3), robot.home_position)
    if np.any(L <= 0.0):
        i, leg = (int(index) for index in np.argwhere(L <= 0.0)[0])
        raise ValueError(
            f"{log.source}: line {log.rows[i]}: L_{leg + 1}: expected a length > 0 m, got {L[i, leg]:g} with "
            "the length of the home pose added"
        )
    return log._replace(L=L, relative=False)
