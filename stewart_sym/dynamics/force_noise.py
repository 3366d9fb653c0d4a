"""What noise in a log does to actuator forces: their standard deviation at every instant.

The deviations of the six coordinates and their rates, as smoothing or rounding leave them, are carried
through kinematics and dynamics one after another, so every formulation and every machine is served.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from ..io.arguments import instance
from ..io.array_types import Array
from ..kinematics.forward_kinematics import inverse_jacobian
from ..kinematics.inverse_kinematics import legs_or_overflow
from ..motion.motion import Motion
from ..motion.rotation import motion_about_axes, orthonormal, rotation_from_vector
from ..motion.trajectory import PoseLog, Trajectory, Uncertainty, need_trajectory
from ..robot.robot import Robot
from .forces import ForceKernel
from .inverse_dynamics import Backend, Formulation, inverse_dynamics, with_compiler

CHUNK = 16_384
"""Instants at a time: their eighteen deviations fit into memory whatever the length of the log."""


def force_std(
    robot: Robot, trajectory: Trajectory | PoseLog, formulation: Formulation = "exact", backend: Backend = "c"
) -> Array:
    """Return the standard deviation of each actuator force, N, (n, 6), from the noise of a log.

    To first order in the noise; 0 for a trajectory without noise, NaN where a pose is unsolvable, infinite
    where one within the noise is.

    Parameters
    ----------
    robot : Robot
        The machine.
    trajectory : Trajectory or PoseLog
        Times and poses, or a log of poses.
    formulation, backend : str, optional
        As for ``inverse_dynamics``.

    Returns
    -------
    ndarray
        Standard deviations, N, (n, 6).

    Raises
    ------
    ValueError
        For unknown options.
    """
    instance(robot, Robot, "robot")
    need_trajectory(trajectory)
    forces = forces_of(robot, formulation, backend)
    count = len(trajectory.time)
    starts = range(0, count, CHUNK)
    parts = [_deviations_of_forces(robot, trajectory, slice(i, i + CHUNK), forces) for i in starts]
    return np.concatenate(parts) if parts else np.empty((0, 6))


def _deviations_of_forces(
    robot: Robot, trajectory: Trajectory | PoseLog, part: slice, forces: Callable[[Motion], Array]
) -> Array:
    F = forces(trajectory.at(part))
    deviation = np.zeros(F.shape)
    for other in displaced(robot, trajectory, part):
        moved = forces(other)
        deviation = np.hypot(deviation, np.where(np.isfinite(moved), moved - F, np.inf))
    return np.where(np.isfinite(F), deviation, np.nan)


def forces_of(robot: Robot, formulation: Formulation, backend: Backend) -> Callable[[Motion], Array]:
    """Forces of motions, (n, 6), NaN for unsolvable poses, by the fastest kernel of the backend."""

    def full(motion: Motion) -> Array:
        return inverse_dynamics(robot, motion, formulation, backend, on_singular="nan").F

    if (
        not isinstance(backend, str)
        or backend != "c"
        or (robot.offsets is not None and robot.offsets.has_spinning_parts)
    ):
        return full  # which checks the options, and computes what no kernel does
    kernel = with_compiler(lambda: ForceKernel(robot, formulation), lambda: None)
    return full if kernel is None else lambda motion: kernel.forces_and_status(motion)[0]


def _factors(noise: Uncertainty, time: Array) -> Array:
    """Lower Cholesky factors of the covariances of value, rate and second rate, (n, 6, 3, 3)."""
    flat = noise.covariance.reshape(len(noise.grid), -1)
    at = np.clip(np.searchsorted(noise.grid, time, side="right") - 1, 0, len(noise.grid) - 2)
    share = np.clip((time - noise.grid[at]) / (noise.grid[at + 1] - noise.grid[at]), 0.0, 1.0)[:, None]
    c = np.moveaxis((flat[at] + share * (flat[at + 1] - flat[at])).reshape(len(time), 6, 6), -1, 0)
    L = np.zeros((len(time), 6, 3, 3))
    L[..., 0, 0] = np.sqrt(np.maximum(c[0], 0.0))
    L[..., 1, 0] = _quotient(c[1], L[..., 0, 0])
    L[..., 1, 1] = np.sqrt(np.maximum(c[2] - L[..., 1, 0] ** 2, 0.0))
    L[..., 2, 0] = _quotient(c[3], L[..., 0, 0])
    L[..., 2, 1] = _quotient(c[4] - L[..., 2, 0] * L[..., 1, 0], L[..., 1, 1])
    L[..., 2, 2] = np.sqrt(np.maximum(c[5] - L[..., 2, 0] ** 2 - L[..., 2, 1] ** 2, 0.0))
    return L


def _quotient(x: Array, y: Array) -> Array:
    return np.divide(x, y, out=np.zeros_like(x), where=y > 0.0)


def displaced(robot: Robot, trajectory: Trajectory | PoseLog, part: slice) -> Iterator[Motion]:
    """Motions displaced by independent deviations of one each, those that are 0 throughout left out.

    The root of the sum of squares of what they change of a quantity is its deviation.
    """
    if trajectory.noise is None:
        return
    L = _factors(trajectory.noise, trajectory.time[part])
    motion, tool = trajectory.at(part), trajectory.noise.tool
    coordinates = trajectory.noise.coordinates[:, part]
    inverse = inverse_jacobian(robot, motion.R, motion.t) if trajectory.noise.in_joints else None
    motion = motion if tool is None else motion.at_point(tool)
    for i in range(6):
        for k in range(3):
            if not L[:, i, :, k].any():
                continue
            moved = coordinates.copy()
            moved[:, :, i] += L[:, i, :, k].T
            if inverse is not None:
                yield _on_legs(robot, motion, inverse, moved[0] - coordinates[0], moved)
                continue
            if i < 3:
                other = _moved(motion, t=moved[0, :, :3], v=moved[1, :, :3], a=moved[2, :, :3])
            else:
                theta, theta_dot, theta_ddot = moved[..., 3:]
                R, omega, alpha = motion_about_axes(theta, theta_dot, theta_ddot, trajectory.noise.order)
                other = _moved(motion, R=R, omega=omega, alpha=alpha)
            yield other if tool is None else other.at_point(-tool)


def _on_legs(robot: Robot, motion: Motion, inverse: Array, shift: Array, legs: Array) -> Motion:
    """The motion whose leg lengths are shifted, (n, 6), and whose legs have rates legs[1] and legs[2].

    The pose to first order. inverse: J^-1 at the motion's poses, (n, 6, 6).
    """
    R, t = motion.R, motion.t
    if shift.any():
        step = np.einsum("nij,nj->ni", inverse, shift)
        R, t = orthonormal(rotation_from_vector(step[:, 3:]) @ R), t + step[:, :3]
        inverse = inverse_jacobian(robot, R, t)
    twist = np.einsum("nij,nj->ni", inverse, legs[1])
    # Without accelerations of the platform, what remains of L_ddot is what its velocities make of it.
    none = np.zeros(t.shape)
    own = legs_or_overflow(robot, Motion._unchecked(R, t, twist[:, 3:], twist[:, :3], none, none)).L_ddot
    rate = np.einsum("nij,nj->ni", inverse, legs[2] - np.asarray(own))
    return _moved(motion, R=R, t=t, v=twist[:, :3], omega=twist[:, 3:], a=rate[:, :3], alpha=rate[:, 3:])


def _moved(motion: Motion, **changes: Array) -> Motion:
    return Motion._unchecked(**{**vars(motion), **changes})
