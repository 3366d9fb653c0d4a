"""Smooth motions as logs with noise."""

import warnings
from typing import NamedTuple

import numpy as np
from machines import GRAVITY, home_position, machine_size, random_robot
from motion_fields import motion_of
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.motion.log_reader import AS_SHOWN, _pose_log, trajectory_from
from stewart_sym.motion.trajectory import Log, Trajectory

Array = NDArray[np.float64]
WHITE = 1e-4


class Case(NamedTuple):
    """A random smooth motion of a random machine: times, coordinates and rates (3, n, 6), forces."""

    robot: ss.Robot
    time: Array
    true: Array
    F: Array


def coordinates(rng: np.random.Generator, size: float, time: Array, highest: float) -> Array:
    """Six band-limited random functions up to a frequency, Hz, with two derivatives, (3, n, 6)."""
    waves = 24
    omega = 2 * np.pi * rng.uniform(0.0, highest, (waves, 6))
    width = 0.08 * rng.normal(size=(waves, 6)) * np.exp(-2.0 * (omega / (2 * np.pi * highest)) ** 2) / 3.0
    phase = rng.uniform(0.0, 2 * np.pi, (waves, 6))
    angle = omega * time[:, None, None] + phase
    found = [np.sum(width * omega**k * np.sin(angle + k * np.pi / 2), axis=1) for k in range(3)]
    return np.array(found) * np.repeat([size, 2.0], 3)


def case(seed: int) -> Case:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, scale=float(rng.uniform(0.4, 2.0)))
    size = machine_size(robot)
    # Accelerations of the order of a tenth of gravity to gravity; 12 to 60 samples of the shortest period.
    highest = float(np.sqrt(GRAVITY / size)) * rng.uniform(0.15, 0.5)
    time = np.arange(0.0, rng.uniform(4.0, 12.0) / highest, 1.0 / (highest * rng.uniform(12.0, 60.0)))
    true = coordinates(rng, size, time, highest)
    true[0, :, :3] += home_position(robot.b, size)
    return Case(robot, time, true, ss.inverse_dynamics(robot, motion_of(true)).F)


def logged(found: Case, noise: str, seed: int) -> Array:
    """The coordinates as a log holds them, (n, 6)."""
    values = found.true[0]
    if noise == "white":
        return values + WHITE * np.random.default_rng([seed, 1]).normal(size=values.shape)
    return np.round(values, int(noise))


def from_poses(time: Array, t: Array, theta: Array, smoothing: ss.SmoothingOptions = AS_SHOWN) -> Trajectory:
    """The trajectory of poses over time, differentiated as those of a file."""
    written = {"t": [*t.T], "theta": [*theta.T]}
    log = Log("poses", range(len(time)), time, written, smoothing=smoothing)
    return trajectory_from(_pose_log(log))


def read(time: Array, values: Array) -> tuple[Trajectory, list[str]]:
    """The trajectory of poses, (n, 6), and the warnings about it."""
    with warnings.catch_warnings(record=True, action="always") as caught:
        found = from_poses(time, *np.hsplit(values, 2))
    return found, [str(each.message) for each in caught]
