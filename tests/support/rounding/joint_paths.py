"""Random smooth paths of random machines for joint-space tests: some cross singular poses, some graze them.

Ground truth is the sign of det J on a fine grid along the path itself, which no test's subject takes part
in.
"""

from dataclasses import dataclass

import numpy as np
from machines import dasgupta, home_position, machine_size, random_robot
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.kinematics.conditioning import characteristic_length
from stewart_sym.motion.rotation import rotation_from_vector

Array = NDArray[np.float64]

GRID = 10_001


@dataclass(frozen=True, eq=False)
class SmoothPath:
    """Position, m, and twice the vector of a quaternion with scalar 1: a line and harmonics.

    start, change: (6,). sine: (harmonics, 6); each vanishes at both ends. duration: s.
    """

    start: Array
    change: Array
    sine: Array
    duration: float

    def __call__(self, time: Array) -> ss.Motion:
        share = np.asarray(time)[:, None] / self.duration
        rate = np.pi * np.arange(1, len(self.sine) + 1)
        angle = share * rate
        x = self.start + share * self.change + np.sin(angle) @ self.sine
        x_1 = (self.change + (rate * np.cos(angle)) @ self.sine) / self.duration
        x_2 = -((rate**2 * np.sin(angle)) @ self.sine) / self.duration**2
        turns = [
            np.insert(0.5 * part[:, 3:], 0, scalar, axis=1)
            for part, scalar in ((x, 1.0), (x_1, 0.0), (x_2, 0.0))
        ]
        pairs = zip((x, x_1, x_2), turns, strict=True)
        return ss.Motion.from_quaternion(*(each for part, turn in pairs for each in (part[:, :3], turn)))


def random_case(rng: np.random.Generator) -> tuple[ss.Robot, SmoothPath]:
    """A machine and a path: wherever it leads, to the other side of singular poses, or just to them.

    Of the last kind, paths go out and back and are scaled so that they end a little before or behind the
    first singular pose that a growing path touches.
    """
    robot = dasgupta() if rng.uniform() < 0.2 else random_robot(rng, rng.choice(["universal", "spherical"]))
    kind = rng.choice(["anywhere", "across", "grazing"])
    if kind == "anywhere":
        return robot, _draw(rng, robot, rng.uniform(0.1, 0.8), closed=False)
    while True:
        path = _draw(rng, robot, rng.uniform(0.3, 1.5), closed=kind == "grazing")
        if _crosses(robot, path):
            break
    if kind == "across":
        return robot, path
    beyond = float(np.exp(rng.uniform(np.log(1e-3), np.log(0.1))))
    return robot, _grazing(robot, path, rng.choice([-1.0, -1.0, 1.0]) * beyond)


def dipping_case(rng: np.random.Generator) -> tuple[ss.Robot, SmoothPath, int]:
    """A machine, a path and how many samples; between two it crosses a singular pose and returns."""
    while True:
        robot = random_robot(rng, rng.choice(["universal", "spherical"]))
        path, samples = _draw(rng, robot, rng.uniform(0.3, 1.5), closed=True), int(rng.integers(60, 120))
        if not _crosses(robot, path):
            continue
        path = _grazing(robot, path, 10 ** -rng.uniform(3.5, 5.5))
        det = scaled_determinant(robot, path(np.linspace(0.0, path.duration, samples)))
        if np.all(det * det[0] > 0.0) and np.isfinite(truth(robot, path).crossing):
            return robot, path, samples


def _draw(rng: np.random.Generator, robot: ss.Robot, width: float, closed: bool) -> SmoothPath:
    size = machine_size(robot)
    spread = width * np.repeat([size, 1.0], 3)
    home = np.concatenate([home_position(robot.b, size), np.zeros(3)])
    first, last = home + spread * rng.normal(size=(2, 6)) * [[min(0.3, 0.1 / width)], [0.7]]
    order = np.arange(1, rng.integers(2, 6))[:, None]
    sine = rng.normal(size=(len(order), 6)) * spread * rng.uniform(0.0, 0.4) / order
    if closed:
        sine[0] += last - first
    change = np.zeros(6) if closed else last - first
    return SmoothPath(first, change, sine, float(np.exp(rng.uniform(-1.0, 2.0))))


def _grazing(robot: ss.Robot, path: SmoothPath, beyond: float) -> SmoothPath:
    """The path scaled to end by a share beyond the first singular pose that it touches as it grows."""
    low, high = 0.0, 1.0
    while high - low > 1e-6:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if _crosses(robot, _scaled(path, middle)) else (middle, high)
    return _scaled(path, low * (1.0 + beyond))


def _scaled(path: SmoothPath, scale: float) -> SmoothPath:
    return SmoothPath(path.start, scale * path.change, scale * path.sine, path.duration)


def _crosses(robot: ss.Robot, path: SmoothPath) -> bool:
    det = scaled_determinant(robot, path(np.linspace(0.0, path.duration, 1001)))
    return bool(np.any(det * det[0] <= 0.0))


def scaled_determinant(robot: ss.Robot, motion: ss.Motion) -> Array:
    """det of J with angles times the platform's size, no unit: near 0 at a singular pose."""
    return np.asarray(np.linalg.det(_rows(robot, motion.R, motion.t)))


def _rows(robot: ss.Robot, R: Array, t: Array) -> Array:
    q = robot.p @ np.swapaxes(R, -1, -2)
    S = t[..., None, :] + q - robot.b
    s = S / np.linalg.norm(S, axis=-1, keepdims=True)
    return np.concatenate([s, np.cross(q, s) / characteristic_length(robot)], axis=-1)


def lengths_to_singular(robot: ss.Robot, motion: ss.Motion) -> Array:
    """Least change of leg lengths, m, (n,), to first order, that leads to a singular pose.

    Along the twist that changes the lengths least, the least singular value s goes to 0 with a slope, and the
    lengths change by half of s^2 over it.
    """
    size, step = characteristic_length(robot), 1e-5
    U, s, V = np.linalg.svd(_rows(robot, motion.R, motion.t))
    sides = []
    for side in (step, -step):
        twist = side * V[:, -1]
        R = rotation_from_vector(twist[:, 3:] / size) @ motion.R
        J = _rows(robot, R, motion.t + twist[:, :3])
        sides.append(np.einsum("ni,nij,nj->n", U[:, :, -1], J, V[:, -1]))
    slope = np.abs(sides[0] - sides[1]) / (2.0 * step)
    return np.asarray(0.5 * s[:, -1] ** 2 / slope)


@dataclass(frozen=True)
class Truth:
    """First crossing, s, or inf; least |det|, no unit, of the scaled J over the path (0 with a crossing)."""

    crossing: float
    least: float


def truth(robot: ss.Robot, path: SmoothPath) -> Truth:
    time = np.linspace(0.0, path.duration, GRID)
    det = scaled_determinant(robot, path(time))
    turns = np.flatnonzero(det[1:] * det[0] <= 0.0)
    crossing = float(time[turns[0]]) if turns.size else np.inf
    return Truth(crossing, 0.0 if turns.size else float(np.abs(det).min()))


def legs_along(robot: ss.Robot, path: SmoothPath, samples: int) -> tuple[Array, ss.Motion, tuple[Array, ...]]:
    """Times, (n,), the true motion there, and L, L_dot, L_ddot, (n, 6) each."""
    time = np.linspace(0.0, path.duration, samples)
    motion = path(time)
    legs = ss.inverse_kinematics(robot, motion)
    assert legs.L_ddot is not None
    return time, motion, (legs.L, legs.L_dot, legs.L_ddot)
