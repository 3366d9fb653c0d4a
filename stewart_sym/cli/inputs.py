"""Robots and trajectories that a subcommand is given, with a warning for each doubt about them."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from ..io.error_policy import warn
from ..io.progress import Progress

if TYPE_CHECKING:
    from ..motion.logs import TrajectoryFormat
    from ..motion.trajectory import JointTrajectory, PoseLog, Trajectory
    from ..robot.robot import Robot


FEW_ROWS = 10
"""So few rows of a trajectory don't show its motion."""


def robot_of(source: Path) -> "Robot":
    """The robot of a file; warns of what is doubtful about it."""
    from ..robot.robot import Robot

    robot = Robot.from_toml(source)
    warn_of_doubts(robot, source)
    return robot


def warn_of_doubts(robot: "Robot", source: Path) -> None:
    """Warn of a robot's doubtful numbers, in one line each; ``source``: the file that gives or names it."""
    from ..plausibility.plausibility import find_implausible
    from ..robot.robot import RobotWarning

    for name, text in find_implausible(robot):
        warn(f"{source}: {text} [{name}]", RobotWarning)


def trajectory_of(
    robot: "Robot", source: Path, arguments: argparse.Namespace, progress: Progress
) -> "Trajectory | PoseLog":
    """Poses over time from a CSV file of poses or of leg lengths, read as the options say."""
    from ..kinematics.robot_logs import read_log_of
    from ..motion.interpolation import resample
    from ..motion.trajectory import SmoothingOptions

    if not arguments.smoothing:
        for name in ("position_std", "angle_std", "cutoff"):
            if getattr(arguments, name) is not None:
                option = name.replace("_", "-")
                raise ValueError(f"--{option} and --no-smoothing cannot be given together")
    form = log_format(arguments, source)
    smoothing = SmoothingOptions(*stated_noise(arguments, form), arguments.cutoff, arguments.smoothing)
    log = read_log_of(robot, source, log_format(arguments), smoothing, progress)
    trajectory = poses_of(robot, log, arguments, progress)
    if arguments.rate is None:
        return trajectory
    few = resample(trajectory, arguments.rate)
    if len(few.time) < min(FEW_ROWS, len(trajectory.time)):
        warn(
            f"{source}: {len(few.time)} instant{'s' * (len(few.time) > 1)} of "
            f"{trajectory.time[-1] - trajectory.time[0]:.4g} s at a rate of {arguments.rate:g} Hz, of "
            f"{len(trajectory.time)} rows; the motion between them is not computed"
        )
    return few


def stated_noise(
    arguments: argparse.Namespace, form: "TrajectoryFormat"
) -> "tuple[float | None, float | None]":
    """Stated noise of positions, m, and of angles, rad: the options are in the units of the log."""
    position, angle = arguments.position_std, arguments.angle_std
    return (
        None if position is None else position * form.meters_per_unit,
        None if angle is None else angle * form.radians_per_unit,
    )


def log_format(arguments: argparse.Namespace, source: Path | None = None) -> "TrajectoryFormat":
    """How the options say that a trajectory's file is read.

    source: a file whose row of units states the units that no option does; without it these are open.
    """
    from ..motion.log_reader import with_units_of
    from ..motion.logs import TrajectoryFormat

    units = ("length_unit", "angle_unit", "time_unit")
    names = ("columns", *units, "delimiter", "decimal", "euler_order", "length_mode")
    form = TrajectoryFormat(**{name: getattr(arguments, name) for name in names})
    return form if source is None else with_units_of(source, form)


def poses_of(
    robot: "Robot",
    log: "Trajectory | PoseLog | JointTrajectory",
    arguments: argparse.Namespace,
    progress: Progress,
) -> "Trajectory | PoseLog":
    """Poses of a log that was read as the options say, found from leg lengths if it holds these."""
    import numpy as np

    from ..kinematics.trajectory_checks import side_doubt
    from ..motion.rotation import rotation_from_rpy
    from ..motion.trajectory import JointTrajectory
    from ..singularities.joint_space import on_platform

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
