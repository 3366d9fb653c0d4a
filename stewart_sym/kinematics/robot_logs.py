"""Logs of a robot, read with the conventions of its robot file: tool point, rotation order, home pose."""

import os
from dataclasses import replace

import numpy as np

from ..io.array_types import Array
from ..io.error_policy import warn
from ..io.progress import Progress, silent
from ..motion.log_reader import AS_SHOWN, poses_of, trajectory_of
from ..motion.log_samples import LogSamples, read_samples
from ..motion.trajectory import SmoothingOptions, Trajectory
from ..motion.trajectory_format import PLAIN, TrajectoryFormat, TrajectoryWarning
from ..robot.robot import Robot
from .inverse_kinematics import leg_lengths
from .trajectory_checks import log_doubts, need_units


def samples_of(robot: Robot, path: str | os.PathLike[str], form: TrajectoryFormat = PLAIN) -> LogSamples:
    """Read the samples of a robot's log; raise ValueError if they fit the robot only in another unit.

    The robot file supplies properties of the format that neither ``form`` nor the header states.
    """
    samples = read_samples(os.fsdecode(path), form, robot.trajectory_format)
    need_units(robot, samples)
    return samples


def read_log_of(
    robot: Robot,
    path: str | os.PathLike[str],
    form: TrajectoryFormat = PLAIN,
    smoothing: SmoothingOptions = AS_SHOWN,
    progress: Progress = silent,
) -> Trajectory:
    """Read a log of poses or leg lengths; raises the errors of ``samples_of`` and ``log_of``."""
    progress(f"reading {os.fsdecode(path)}")
    return log_of(robot, samples_of(robot, path, form), smoothing, progress)


def log_of(
    robot: Robot,
    samples: LogSamples,
    smoothing: SmoothingOptions = AS_SHOWN,
    progress: Progress = silent,
) -> Trajectory:
    """Compute the trajectory of samples whose poses and loads refer to the robot's tool.

    Relative coordinates become absolute. Raises the errors of ``trajectory_of``. Warns if numbers do not fit
    the robot.
    """
    form, home = samples.file_format, np.zeros(6)
    if "L" in samples.vectors:
        if form.length_mode == "relative":
            home = leg_lengths(robot, np.eye(3), _home(robot, samples.source))
        _need_lengths(samples, home)
    elif form.pose_mode == "relative":
        home[:3] = _home(robot, samples.source) + robot.tool
    log = _of_tool(_with_home(trajectory_of(samples, smoothing, progress), home), robot.tool)
    for doubt in log_doubts(robot, log):
        warn(f"{log.source}: {doubt}", TrajectoryWarning)
    return log


def read_poses_of(
    robot: Robot, path: str | os.PathLike[str], form: TrajectoryFormat = PLAIN
) -> tuple[Array, Array]:
    """Read poses of the robot's tool without rates: R, shape (n, 3, 3), and t (m), shape (n, 3)."""
    samples = samples_of(robot, path, form)
    R, t = poses_of(samples)
    relative = samples.file_format.pose_mode == "relative"
    return R, t + (_home(robot, samples.source) + robot.tool if relative else 0.0)


def _home(robot: Robot, source: str) -> Array:
    """Return the home position (m); raise ValueError if the robot has none."""
    if robot.home_position is None:
        raise ValueError(f"{source}: relative coordinates; add home_position to the robot file")
    return robot.home_position


def _need_lengths(samples: LogSamples, home: Array) -> None:
    """Raise ValueError unless leg lengths, with added lengths at home (m), (6,), are > 0."""
    L = samples.vectors["L"] + home
    if np.any(L <= 0.0):
        i, leg = (int(index) for index in np.argwhere(L <= 0.0)[0])
        place = f"{samples.source}: line {samples.lines[i]}: L_{leg + 1}"
        raise ValueError(f"{place}: {L[i, leg]:g} m is no length; check length_mode and length_unit")


def _with_home(log: Trajectory, home: Array) -> Trajectory:
    """Return the log with coordinates, shape (6,), added to its values."""
    if not home.any():
        return log
    assert log.coordinates is not None
    found = log.coordinates.copy()
    found[0] += home
    return replace(log, coordinates=found)


def _of_tool(log: Trajectory, tool: Array) -> Trajectory:
    """Return the log with poses and loads that refer to a point (m), platform frame."""
    if not tool.any():
        return log
    if not log.has_lengths:
        return replace(log, tool=tool)
    moment = 0.0 if log.M_ext is None else log.M_ext
    return log if log.F_ext is None else replace(log, M_ext=moment + np.cross(tool, log.F_ext))
