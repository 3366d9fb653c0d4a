"""Robots and trajectories that a subcommand reads, with plausibility warnings."""

import argparse
from pathlib import Path

import numpy as np

import stewart_sym as ss

from ..io.error_policy import warn
from ..io.progress import Progress
from ..kinematics.robot_logs import read_log_of
from ..kinematics.trajectory_checks import side_doubt
from ..motion.log_reader import with_units_of
from ..motion.rotation import rotation_from_rpy
from ..motion.trajectory import JointTrajectory, PoseLog, Trajectory
from ..plausibility.plausibility import find_implausible
from ..singularities.joint_space import on_platform

FEW_ROWS = 10
"""Number of rows below which a trajectory does not resolve its motion."""


def robot_of(source: Path) -> ss.Robot:
    """Read the robot of a file, and warn of implausible values."""
    robot = ss.Robot.from_toml(source)
    warn_of_doubts(robot, source)
    return robot


def warn_of_doubts(robot: ss.Robot, source: Path) -> None:
    """Warn of implausible values of a robot, one line each.

    ``source`` is the file that contains or references the robot.
    """
    for name, text in find_implausible(robot):
        warn(f"{source}: {text} [{name}]", ss.RobotWarning)


def trajectory_of(
    robot: ss.Robot, source: Path, arguments: argparse.Namespace, progress: Progress
) -> Trajectory | PoseLog:
    """Read a CSV file of poses or leg lengths as specified by the options, and return poses over time."""
    if not arguments.smoothing:
        for name in ("position_std", "angle_std", "cutoff"):
            if getattr(arguments, name) is not None:
                option = name.replace("_", "-")
                raise ValueError(f"--{option} and --no-smoothing cannot be given together")
    form = log_format(arguments, source)
    smoothing = ss.SmoothingOptions(*stated_noise(arguments, form), arguments.cutoff, arguments.smoothing)
    log = read_log_of(robot, source, log_format(arguments), smoothing, progress)
    trajectory = poses_of(robot, log, arguments, progress)
    if arguments.rate is None:
        return trajectory
    few = ss.resample(trajectory, arguments.rate)
    if len(few.time) < min(FEW_ROWS, len(trajectory.time)):
        warn(
            f"{source}: {len(few.time)} sample{'s' * (len(few.time) > 1)} of {len(trajectory.time)} rows in "
            f"{trajectory.time[-1] - trajectory.time[0]:.4g} s at {arguments.rate:g} Hz; the motion between "
            "them is not computed; raise --rate"
        )
    return few


def stated_noise(
    arguments: argparse.Namespace, form: ss.TrajectoryFormat
) -> tuple[float | None, float | None]:
    """Convert the noise options from units of the log to m and rad; return (position_std, angle_std)."""
    position, angle = arguments.position_std, arguments.angle_std
    return (
        None if position is None else position * form.meters_per_unit,
        None if angle is None else angle * form.radians_per_unit,
    )


def log_format(arguments: argparse.Namespace, source: Path | None = None) -> ss.TrajectoryFormat:
    """Return the file format of a trajectory that the options specify.

    ``source`` is a file whose unit row supplies the units that no option specifies. Without ``source``, these
    units remain undefined.
    """
    units = ("length_unit", "angle_unit", "time_unit")
    names = ("columns", *units, "delimiter", "decimal", "euler_order", "length_mode")
    form = ss.TrajectoryFormat(**{name: getattr(arguments, name) for name in names})
    return form if source is None else with_units_of(source, form)


def poses_of(
    robot: ss.Robot,
    log: Trajectory | PoseLog | JointTrajectory,
    arguments: argparse.Namespace,
    progress: Progress,
) -> Trajectory | PoseLog:
    """Return the poses of a log, computed by forward kinematics if the log contains leg lengths."""
    start = None if arguments.pose_guess is None else np.asarray(arguments.pose_guess)
    if isinstance(log, JointTrajectory):
        guess = None if start is None else (rotation_from_rpy(start[3:]), start[:3])
        poses = on_platform(robot, log, guess, progress)
        if start is not None and (doubt := side_doubt(robot, poses.motion)) is not None:
            warn(f"--pose-guess: {doubt}")
        return poses
    if start is not None:
        raise ValueError("--pose-guess: the trajectory contains poses; omit the option")
    return log
