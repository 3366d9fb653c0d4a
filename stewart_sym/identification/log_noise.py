"""Noise of the poses of a log, stated or estimated by its reader, about the reference point of the robot."""

import numpy as np

from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.array_types import Array
from ..motion.motion import Motion
from ..motion.rotation import cross_matrix
from ..motion.trajectory import Trajectory
from ..robot.robot import Robot
from .motion_basis import PoseNoise

# Smallest standard deviation (m, rad): columns with a smaller one are taken as exact.
_EXACT = 1e-10


def noise_of_log(
    robot: Robot,
    log: Trajectory,
    stated: tuple[float | None, float | None] = (None, None),
    period: float | None = None,
    harmonics: int | None = None,
) -> PoseNoise | None:
    """Return the noise of the poses of a log; None if they are exact.

    Parameters
    ----------
    robot : Robot
        Robot of the log.
    log : Trajectory
        Poses of the reference point, with the noise of the poses of the tool or of the leg lengths.
    stated : tuple of float or None
        Standard deviations of positions or leg lengths (m) and of angles (rad); None: estimate of the reader.
    period, harmonics : optional
        As in ``PoseNoise``.

    Returns
    -------
    PoseNoise or None
        Noise about the reference point.
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
