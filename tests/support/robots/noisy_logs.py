"""Logs of known motions: sums of sines, minimum jerk, and trapezoids, with rounding, noise, and faults."""

import tempfile
import warnings
from pathlib import Path
from typing import NamedTuple

import numpy as np
from log_files import NAMES, write
from machines import GRAVITY, home_position, machine_size, random_robot
from motion_fields import motion_of
from numpy.typing import NDArray
from plain_logs import read_log

import stewart_sym as ss
from stewart_sym.motion.log_reader import AS_SHOWN
from stewart_sym.motion.trajectory import SmoothingOptions, Trajectory
from stewart_sym.motion.trajectory_format import PLAIN

Array = NDArray[np.float64]
WHITE = 1e-4
KINDS = ("sines", "minimum jerk", "trapezoids")
NOISES = ("3", "4", "5", "white")


class Case(NamedTuple):
    """Motion of a random machine: times (s), coordinates and rates (3, n, 6), and forces (N), (n, 6)."""

    robot: ss.Robot
    time: Array
    true: Array
    F: Array


def coordinates(rng: np.random.Generator, size: float, time: Array, highest: float) -> Array:
    """Return six band-limited random functions up to a frequency (Hz) with two derivatives, (3, n, 6)."""
    waves = 24
    omega = 2 * np.pi * rng.uniform(0.0, highest, (waves, 6))
    width = 0.08 * rng.normal(size=(waves, 6)) * np.exp(-2.0 * (omega / (2 * np.pi * highest)) ** 2) / 3.0
    phase = rng.uniform(0.0, 2 * np.pi, (waves, 6))
    angle = omega * time[:, None, None] + phase
    found = [np.sum(width * omega**k * np.sin(angle + k * np.pi / 2), axis=1) for k in range(3)]
    return np.array(found) * np.repeat([size, 2.0], 3)


def moves(rng: np.random.Generator, size: float, time: Array, duration: float, kind: str) -> Array:
    """Return moves between random poses, each of a duration (s), with two derivatives, (3, n, 6)."""
    time = time - time[0]
    move = (time / duration).astype(int)
    s = (time / duration - move)[:, None]
    poses = rng.normal(size=(move[-1] + 2, 6)) * np.repeat([0.05 * size, 0.1], 3)
    if kind == "minimum jerk":
        x = [10 * s**3 - 15 * s**4 + 6 * s**5, 30 * s**2 * (1 - s) ** 2, 60 * s * (1 - s) * (1 - 2 * s)]
    else:
        blend = 0.25
        a = 1.0 / (blend * (1.0 - blend)) * (1.0 * (s < blend) - (s >= 1.0 - blend))
        v = np.minimum(np.minimum(s, 1.0 - s), blend) / (blend * (1.0 - blend))
        half = np.minimum(s, 1.0 - s)
        rise = np.where(half < blend, 0.5 * half**2, blend * (half - 0.5 * blend)) / (blend * (1.0 - blend))
        x = [np.where(s < 0.5, rise, 1.0 - rise), v, a]
    change = poses[move + 1] - poses[move]
    return np.array([poses[move] + change * x[0], change * x[1] / duration, change * x[2] / duration**2])


def case(
    seed: int, kind: str = "sines", samples: tuple[float, float] = (12.0, 60.0), jitter: float = 0.0
) -> Case:
    """Return a motion with accelerations of a tenth of gravity to gravity.

    ``samples`` is the range of the number of samples of the shortest period; ``jitter`` is the largest
    deviation of a time relative to the step.
    """
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, scale=float(rng.uniform(0.4, 2.0)))
    size = machine_size(robot)
    highest = float(np.sqrt(GRAVITY / size)) * rng.uniform(0.15, 0.5)
    time = np.arange(0.0, rng.uniform(4.0, 12.0) / highest, 1.0 / (highest * rng.uniform(*samples)))
    if jitter:
        time = np.round(time + jitter * time[1] * rng.uniform(0.0, 1.0, len(time)), 6)
    if kind == "sines":
        true = coordinates(rng, size, time, highest)
    else:
        true = moves(rng, size, time, 1.0 / highest, kind)
    true[0, :, :3] += home_position(robot.b, size)
    return Case(robot, time, true, ss.inverse_dynamics(robot, motion_of(true)).F)


def logged(found: Case, noise: str, seed: int) -> Array:
    """Return the coordinates as a log contains them, (n, 6)."""
    values = found.true[0]
    if noise == "white":
        return values + WHITE * np.random.default_rng([seed, 1]).normal(size=values.shape)
    return np.round(values, int(noise))


class Faults(NamedTuple):
    """Faults of a log: jitter, time of the first row (s), numbers of rows of a gap and of equal rows, and
    fraction of rows without a number."""

    jitter: float = 0.0
    start: float = 0.0
    gap: float = 0
    frozen: float = 0
    missing: float = 0.0


def random_faults(rng: np.random.Generator) -> Faults:
    """Return a random combination of faults, each with probability 1/2."""
    some = rng.random(5) < 0.5
    gap, frozen = int(rng.integers(5, 201)), int(rng.integers(3, 20))
    return Faults(*(np.array([0.5, 1.7e9, gap, frozen, 0.02]) * some).tolist())


def faulty(one: Case, noise: str, faults: Faults, seed: int) -> tuple[Array, Array, Array]:
    """Return times and poses with faults, and the indices of the rows of the motion."""
    rng = np.random.default_rng([seed, 2])
    gap, frozen = int(faults.gap), int(faults.frozen)
    count, values, rows = len(one.time), logged(one, noise, seed), np.arange(len(one.time))
    if frozen:
        first = int(rng.integers(count // 10, count // 2))
        values[first : first + frozen] = values[first]
    values[rng.random(count) < faults.missing, int(rng.integers(6))] = np.nan
    if gap:
        first = int(rng.integers(count // 10, max(count // 10 + 1, 9 * count // 10 - gap)))
        rows = np.delete(rows, slice(first, first + gap))
    return faults.start + one.time[rows], values[rows], rows


def read(time: Array, values: Array, smoothing: SmoothingOptions = AS_SHOWN) -> tuple[Trajectory, list[str]]:
    """Return the trajectory of poses, (n, 6), read from a file, and the warnings about it."""
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        path = write(Path(folder, "log.csv"), NAMES, np.column_stack([time, values]))
        path.write_text(path.read_text(encoding="utf-8").replace("nan", ""), encoding="utf-8")
        found = read_log(path, PLAIN, smoothing)
    return found, [str(each.message).removeprefix(f"{path}: ") for each in caught]


def errors(one: Case, found: Trajectory) -> tuple[Array, Array]:
    """Return errors of the forces (N) and their standard deviations, (n, 6), at the times of the log."""
    # Times since 1970 are counted from the first row of the file.
    start = found.time[0] - one.time[found.rows[0] - 2]
    rows = np.searchsorted(one.time, found.time - start - 1e-4 * one.time[1])
    return ss.inverse_dynamics(one.robot, found.motion).F - one.F[rows], ss.force_std(one.robot, found)
