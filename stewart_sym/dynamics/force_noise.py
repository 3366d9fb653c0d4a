"""Standard deviation of the actuator forces at every sample, caused by noise in a log.

The standard deviations of the six coordinates and their derivatives, after smoothing or rounding, are
propagated one at a time through kinematics and dynamics. Therefore every formulation and every robot is
supported. Between the knots of a smooth log, standard deviations are interpolated.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from ..io.arguments import instance
from ..io.array_types import Array, Indices
from ..kinematics.forward_kinematics import twist_per_rates
from ..kinematics.inverse_kinematics import legs_or_overflow
from ..motion.motion import Motion
from ..motion.rotation import motion_about_axes, orthonormal, rotation_from_vector
from ..motion.trajectory import Trajectory, Uncertainty
from ..robot.robot import Robot
from .forces import forces_of
from .inverse_dynamics import Backend, Formulation

CHUNK = 16_384
"""Samples that are processed together; the limit bounds the memory for logs of any length."""
# Number of samples between two times of covariances from which one sample next to a time is sufficient.
_MANY = 16


def force_std(
    robot: Robot, trajectory: Trajectory, formulation: Formulation = "exact", backend: Backend = "c"
) -> Array:
    """Compute the standard deviation of each actuator force caused by the noise of a log.

    Parameters
    ----------
    robot : Robot
        Robot model.
    trajectory : Trajectory
        Trajectory with n samples and the noise of its log, as returned by ``read_trajectory``.
    formulation : {"exact", "paper"}, optional
        "exact" for the corrected equations, "paper" for the equations as printed.
    backend : {"c", "numpy", "reference"}, optional
        "c" for C code that is compiled on first use (NumPy if there is no compiler), "numpy" for generated
        NumPy code, "reference" for an independent vector implementation.

    Returns
    -------
    ndarray, shape (n, 6)
        Standard deviations (N), to first order in the noise. 0 for a trajectory without noise, NaN if a pose
        has no solution, and infinite if a pose within the noise has none.

    Raises
    ------
    ValueError
        If an option is unknown or an argument has another type.

    See Also
    --------
    read_trajectory : Read a log with an estimate of its noise.
    inverse_dynamics : Compute the forces.
    force_error_bounds : Compute bounds of the rounding error.

    Examples
    --------
    A log of one second with a noise of 1 mm and 1 mrad:

    >>> import pathlib, tempfile, warnings
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("unal")
    >>> time = np.linspace(0.0, 1.0, 26)
    >>> log = np.zeros((26, 7)) + [0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0]
    >>> log[:, 0], log[:, 1] = time, 0.05 * np.sin(np.pi * time)
    >>> names = "time,t_x,t_y,t_z,theta_x,theta_y,theta_z"
    >>> noise = ss.SmoothingOptions(position_std=0.001, angle_std=0.001)
    >>> with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
    ...     warnings.simplefilter("ignore")
    ...     path = pathlib.Path(folder, "log.csv")
    ...     np.savetxt(path, log, fmt="%.4f", delimiter=",", header=names, comments="")
    ...     trajectory = ss.read_trajectory(robot, path, smoothing=noise)
    >>> std = ss.force_std(robot, trajectory)
    >>> std.shape, bool((std > 0.0).all())
    ((26, 6), True)
    """
    instance(robot, Robot, "robot")
    instance(trajectory, Trajectory, "trajectory")
    forces = forces_of(robot, formulation, backend)
    count = len(trajectory.time)
    starts = range(0, count, CHUNK)
    parts = [_deviations_of_forces(robot, trajectory, slice(i, i + CHUNK), forces) for i in starts]
    return np.concatenate(parts) if parts else np.empty((0, 6))


def _deviations_of_forces(
    robot: Robot, trajectory: Trajectory, part: slice, forces: Callable[[Motion], Array]
) -> Array:
    rows = near_knots(trajectory, part)
    F = forces(trajectory.at(rows))
    deviation = np.zeros(F.shape)
    for other in displaced(robot, trajectory, rows):
        moved = forces(other)
        deviation = np.hypot(deviation, np.where(np.isfinite(moved), moved - F, np.inf))
    deviation = np.where(np.isfinite(F), deviation, np.nan)
    if len(rows) == len(trajectory.time[part]):
        return deviation
    known = np.isfinite(forces(trajectory.at(part)))
    return np.where(known, between(trajectory.time[part], trajectory.time[rows], deviation), np.nan)


def near_knots(trajectory: Trajectory, part: slice) -> Indices:
    """Return the samples of a slice at which standard deviations are computed, with both ends.

    They are the samples next to each time of the covariances of a smooth log, or all samples. Samples on both
    sides of a time are included unless there are many between the times.
    """
    rows = np.arange(len(trajectory.time))[part]
    noise, time = trajectory.noise, trajectory.time[part]
    if noise is None or len(noise.grid) <= 2 or len(rows) <= 2:
        return rows
    after = np.clip(np.searchsorted(time, noise.grid), 1, len(rows) - 1)
    few = _MANY * (time[after] - time[after - 1]) > noise.grid[1] - noise.grid[0]
    return np.asarray(rows[np.unique(np.concatenate([after, after[few] - 1, [0, len(rows) - 1]]))])


def between(time: Array, known: Array, deviations: Array) -> Array:
    """Interpolate standard deviations (m, 6), given at some times (m,), as covariances, linearly in squares.

    They are infinite next to an unknown one.
    """
    if len(known) == len(time):
        return deviations
    i = np.clip(np.searchsorted(known, time, side="right") - 1, 0, len(known) - 2)
    share = ((time - known[i]) / (known[i + 1] - known[i]))[:, None]
    with np.errstate(invalid="ignore"):
        found = np.sqrt((1.0 - share) * deviations[i] ** 2 + share * deviations[i + 1] ** 2)
    return np.where(np.isfinite(found), found, np.inf)


def _factors(noise: Uncertainty, time: Array) -> Array:
    """Return the lower Cholesky factors of the covariances of value, rate, and second rate, (n, 6, 3, 3)."""
    c = np.moveaxis(noise.covariances(time), -1, 0)
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


def displaced(robot: Robot, trajectory: Trajectory, part: slice | Indices) -> Iterator[Motion]:
    """Yield motions that are each displaced by one independent standard deviation, except zero displacements.

    The square root of the sum of the squared changes of a quantity is its standard deviation.
    """
    if trajectory.noise is None:
        return
    L = _factors(trajectory.noise, trajectory.time[part])
    motion, tool = trajectory.at(part), trajectory.tool
    assert trajectory.coordinates is not None
    coordinates = trajectory.coordinates[:, part]
    inverse = twist_per_rates(robot, motion.R, motion.t) if trajectory.has_lengths else None
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
                R, omega, alpha = motion_about_axes(theta, theta_dot, theta_ddot, trajectory.order)
                other = _moved(motion, R=R, omega=omega, alpha=alpha)
            yield other if tool is None else other.at_point(-tool)


def _on_legs(robot: Robot, motion: Motion, inverse: Array, shift: Array, legs: Array) -> Motion:
    """Return the motion with leg lengths shifted by (n, 6) and with the leg rates legs[1] and legs[2].

    The pose is correct to first order. ``inverse`` is J^-1 at the poses of the motion, (n, 6, 6).
    """
    R, t = motion.R, motion.t
    if shift.any():
        step = np.einsum("nij,nj->ni", inverse, shift)
        R, t = orthonormal(rotation_from_vector(step[:, 3:]) @ R), t + step[:, :3]
        inverse = twist_per_rates(robot, R, t)
    twist = np.einsum("nij,nj->ni", inverse, legs[1])
    # Zero accelerations of the platform give the part of L_ddot that depends on the velocities.
    none = np.zeros(t.shape)
    own = legs_or_overflow(robot, Motion._unchecked(R, t, twist[:, 3:], twist[:, :3], none, none)).L_ddot
    rate = np.einsum("nij,nj->ni", inverse, legs[2] - np.asarray(own))
    return _moved(motion, R=R, t=t, v=twist[:, :3], omega=twist[:, 3:], a=rate[:, :3], alpha=rate[:, 3:])


def _moved(motion: Motion, **changes: Array) -> Motion:
    return Motion._unchecked(**{**vars(motion), **changes})
