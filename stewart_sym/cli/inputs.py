"""Robots and trajectories that a subcommand reads, with plausibility warnings."""

import argparse
from pathlib import Path

import numpy as np

import stewart_sym as ss

from ..io.array_types import Array
from ..io.error_policy import warn
from ..io.progress import Progress
from ..kinematics.robot_logs import log_of, samples_of
from ..motion.log_reader import trajectory_of as motion_log_of
from ..motion.log_samples import read_samples
from ..motion.rotation import rotation_from_rpy
from ..motion.trajectory import Trajectory
from ..motion.trajectory_format import std_in_si
from ..plausibility.plausibility import find_implausible
from ..singularities.joint_space import on_platform
from .command import LOG_FORM

FEW_ROWS = 10
"""Number of rows below which a trajectory does not resolve its motion."""


def robot_of(source: Path) -> ss.Robot:
    """Read the robot of a file, and warn of implausible values."""
    try:
        robot = ss.Robot.from_toml(source)
    except ValueError as error:
        if source.suffix.lower() not in (".csv", ".txt", ".dat", ".log"):
            raise
        raise ValueError(f"{source}: expected a robot file (TOML); give the robot before the log") from error
    warn_of_doubts(robot, source)
    return robot


def warn_of_doubts(robot: ss.Robot, source: Path) -> None:
    """Warn of implausible values of a robot, one line each; ``source`` is the file of the robot or scene."""
    for name, text in find_implausible(robot):
        warn(f"{source}: {text} [{name}]", ss.RobotWarning)


def trajectory_of(
    robot: ss.Robot | None, source: Path, arguments: argparse.Namespace, progress: Progress
) -> Trajectory:
    """Read a CSV file as specified by the options; with a robot, leg lengths become poses."""
    progress(f"reading {source}")
    form = log_format(arguments)
    samples = read_samples(str(source), form) if robot is None else samples_of(robot, source, form)
    smoothing = _smoothing(arguments, samples.file_format)
    if robot is None:
        log = motion_log_of(samples, smoothing, progress)
        if arguments.pose_guess is not None or (arguments.rate is not None and log.in_joints):
            raise ValueError("--pose-guess and --rate of leg lengths need the robot; add --robot")
    else:
        log = log_of(robot, samples, smoothing, progress)
        log = on_platform(robot, log, pose_guess(arguments), progress)
    if arguments.rate is None:
        return log
    few = ss.resample(log, arguments.rate)
    if len(few.time) < min(FEW_ROWS, len(log.time)):
        finding = f"{len(few.time)} sample{'s' * (len(few.time) > 1)} of {len(log.time)} rows in "
        finding += f"{log.time[-1] - log.time[0]:.4g} s at {arguments.rate:g} Hz"
        warn(f"{log.source}: {finding}; the motion between them is not computed; raise --rate")
    return few


def _smoothing(arguments: argparse.Namespace, form: ss.TrajectoryFormat) -> ss.SmoothingOptions:
    """Return the smoothing that the options specify, for a file of this format."""
    for name in () if arguments.smoothing else ("position_std", "angle_std", "cutoff"):
        if getattr(arguments, name) is not None:
            raise ValueError(f"--{name.replace('_', '-')} and --no-smoothing cannot be given together")
    std = std_in_si(form, arguments.position_std, arguments.angle_std)
    return ss.SmoothingOptions(*std, arguments.cutoff, arguments.smoothing)


def log_format(arguments: argparse.Namespace) -> ss.TrajectoryFormat:
    """Return the file format of a trajectory that the options specify."""
    names = [name.replace("-", "_") for name in ("columns", *LOG_FORM, "row-rate", "drop-lines")]
    stated = {name: getattr(arguments, name) for name in names}
    return ss.TrajectoryFormat(**{name: value for name, value in stated.items() if value is not None})


def pose_guess(arguments: argparse.Namespace) -> tuple[Array, Array] | None:
    """Return the pose (R, t) of ``--pose-guess``."""
    if arguments.pose_guess is None:
        return None
    t, theta = np.reshape(arguments.pose_guess, (2, 3))
    return rotation_from_rpy(theta), t
