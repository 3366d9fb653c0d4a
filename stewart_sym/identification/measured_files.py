"""Files of a measured motion, and of the forces of the legs or the currents of their motors."""

import os
from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..drives.effort import motor_forces
from ..drives.noise import at_replaced
from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.array_types import Array
from ..io.progress import Progress, silent
from ..kinematics.forward_kinematics import Guess
from ..kinematics.robot_logs import log_of, samples_of
from ..motion.csv_table import Lines
from ..motion.log_samples import FORCES, components_of, possible_units, read_samples
from ..motion.motion import Motion
from ..motion.rotation import cross_matrix
from ..motion.trajectory import SmoothingOptions, Trajectory
from ..motion.trajectory_format import PLAIN, TrajectoryFormat, std_in_si
from ..robot.robot import LEGS, Robot
from ..singularities.joint_space import on_platform
from .motion_basis import PoseNoise

# Smallest standard deviation (m, rad): columns with a smaller one are taken as exact.
_EXACT = 1e-10


class Measurement(NamedTuple):
    """Measured motion and forces.

    trajectory: motion, with the measured coordinates if they have noise. time, F, sigma: times (s), (n,),
    forces (N), (n, 6), and their standard deviations (N). source, lines: file of the forces and its lines.
    noise: noise of the poses, None if they are exact. units: units that the forces may have, the assumed one
    first, with their factors. of_currents: True if the forces are computed from motor currents.
    """

    trajectory: Trajectory
    time: Array
    F: Array
    sigma: Array
    source: str
    lines: Lines
    noise: PoseNoise | None = None
    units: Mapping[str, float] = {}
    of_currents: bool = False


def read_measurement(
    robot: Robot,
    files: tuple[str | os.PathLike[str], str | os.PathLike[str]],
    force_std: float,
    form: TrajectoryFormat = PLAIN,
    std: tuple[float | None, float | None] = (None, None),
    fourier: tuple[float | None, int | None] = (None, None),
    guess: Guess | None = None,
    progress: Progress = silent,
) -> Measurement:
    """Read the files of the motion and of the forces, whose columns ``form`` names.

    ``std`` are the standard deviations of positions or leg lengths and of angles, in the units of the file;
    None: estimated. ``fourier`` are the period (s) and the number of harmonics of the motion.
    """
    poses, forces = map(os.fsdecode, files)
    leg_columns = [column for name in FORCES for column in components_of(name)]
    of_forces = {name: form.columns[name] for name in leg_columns if name in form.columns}
    of_poses = {name: header for name, header in form.columns.items() if name not in of_forces}
    samples = samples_of(robot, poses, replace(form, columns=of_poses))
    std = std_in_si(samples.file_format, *std)
    log = log_of(robot, samples, SmoothingOptions(*std), progress)
    # Rates of the file are used unchanged unless the noise of the poses is stated.
    noisy = log.noise is not None and not {"v", "L_dot"} & set(samples.vectors)
    if noisy := noisy or std[0] is not None:
        # The fit smooths the values with its own model of the noise.
        log = _measured_rows(log, log_of(robot, samples, SmoothingOptions(enabled=False)))
    trajectory = on_platform(robot, log, guess, progress)
    # The file of the forces may have other units, times, and delimiters than the motion.
    clock = {name: header for name, header in samples.file_format.columns.items() if name == "time"}
    defaults = TrajectoryFormat(clock, time_unit=form.time_unit, row_rate=samples.file_format.row_rate)
    measured = read_samples(forces, TrajectoryFormat(of_forces), defaults, forces=True)
    time = np.arange(float(len(measured.lines))) if measured.time is None else measured.time
    if samples.start and measured.start:
        time = time + (measured.start - samples.start)
    ((kind, F),) = measured.vectors.items()
    sigma = np.asarray(force_std)
    if kind == "current":
        F, sigma = motor_forces(robot, F), np.abs(motor_forces(robot, np.full(LEGS, sigma)))
    noise = noise_of_log(robot, trajectory, std, *fourier) if noisy else None
    units = possible_units(measured, kind)
    return Measurement(
        trajectory, time, F, sigma, forces, measured.lines, noise, units, of_currents=kind == "current"
    )


def _measured_rows(smooth: Trajectory, measured: Trajectory) -> Trajectory:
    """Return a smooth trajectory with the measured values, except at rows that the reader did not use."""
    assert smooth.coordinates is not None
    assert measured.coordinates is not None
    unused = at_replaced(smooth, smooth.time)[:, None]
    values = np.where(unused, smooth.coordinates[0], measured.coordinates[0])
    return replace(smooth, coordinates=np.stack([values, *smooth.coordinates[1:]]))


def noise_of_log(
    robot: Robot,
    log: Trajectory,
    stated: tuple[float | None, float | None] = (None, None),
    period: float | None = None,
    harmonics: int | None = None,
) -> PoseNoise | None:
    """Return the noise of the poses of a log about the reference point; None if they are exact.

    The noise of the log belongs to the poses of the tool or to the leg lengths. ``stated`` are standard
    deviations of positions or leg lengths (m) and of angles (rad); None: the estimate of the reader.
    ``period`` and ``harmonics`` are as in ``PoseNoise``.
    """
    sigma = np.zeros(6) if log.noise is None else log.noise.sigma
    if not log.has_lengths:
        sigma = np.repeat(np.sqrt(np.mean(sigma.reshape(2, 3) ** 2, axis=1)), 3)
    position, angle = stated[0], stated[0] if log.has_lengths else stated[1]
    given = np.repeat([np.nan if each is None else each for each in (position, angle)], 3)
    sigma = np.where(np.isnan(given), sigma, given)
    if sigma.max() < _EXACT:
        return None
    sigma = np.maximum(sigma, _EXACT)
    if log.has_lengths:
        back = np.linalg.inv(np.swapaxes(inverse_dynamics(robot, log.motion).H, -1, -2))
        return _with_covariance(log, back * sigma, period, harmonics)
    if robot.tool.any():
        return _with_covariance(log, _from_tool(log.motion, robot.tool) * sigma, period, harmonics)
    return PoseNoise(log.time, float(sigma[0]), float(sigma[3]), period, harmonics)


def _from_tool(motion: Motion, tool: Array) -> Array:
    """Return the derivatives of the pose of the reference point by the pose of the tool, shape (n, 6, 6)."""
    J = np.broadcast_to(np.eye(6), (*motion.shape, 6, 6)).copy()
    J[:, :3, 3:] = cross_matrix(motion.R @ tool)
    return J


def _with_covariance(log: Trajectory, roots: Array, period: float | None, harmonics: int | None) -> PoseNoise:
    """Return the noise whose covariance is the square of roots, shape (n, 6, 6)."""
    covariance = roots @ np.swapaxes(roots, -1, -2)
    position, angle = np.sqrt(np.diagonal(covariance.mean(axis=0)).reshape(2, 3).mean(axis=1)).tolist()
    return PoseNoise(log.time, position, angle, period, harmonics, covariance)
