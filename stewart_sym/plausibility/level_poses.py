"""Finding about a robot, and level poses at which robots are examined."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..dynamics.home_pose import home_pose, level_lengths, radius
from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.array_types import Array
from ..kinematics.conditioning import scaled_condition_number
from ..kinematics.inverse_kinematics import length_rows
from ..kinematics.mounting import level_positions
from ..motion.motion import at_rest
from ..motion.rotation import rotation_from_vector
from ..robot.robot import Robot

GOOD_CONDITION, MISPAIRED, TWISTED = 12.0, 6.0, np.radians(75.0)
"""Thresholds of the scaled condition number, of its ratio to the best order, and of the twist (rad).

Level poses of machines have condition numbers from 1.5 to 3, unusual ones up to 30. Legs in a wrong order
have at least 15, at least 6 times the value of the right order, or a platform that is twisted by 120 degrees.
"""
MOST_CONDITION = 1e3
HEIGHTS = 50
"""Number of level poses on a line above the base."""


class Finding(NamedTuple):
    """Finding about a robot: name, as in ``suppressed_warnings``, and text with the likely cause."""

    name: str
    text: str


@dataclass(frozen=True, eq=False)
class Home:
    """Pose at rest: R, t (m), L (m), and F (N); ``fits`` is True if the legs are within their limits."""

    R: Array
    t: Array
    L: Array
    F: Array
    fits: bool


def centered_H(b: Array, q: Array, t: Array, unit: float) -> tuple[Array, Array]:
    """Return H with moments about the platform center over a unit (m), (..., 6, 6), and L (m), (..., 6).

    q: platform points relative to the reference point in the base frame (m), (..., 6, 3). t: (..., 3).
    """
    S = q + t[..., None, :] - b
    L = np.linalg.norm(S, axis=-1)
    arm = (q - q.mean(axis=-2, keepdims=True)) / (unit or 1.0)
    return np.swapaxes(length_rows(arm, S, L), -1, -2), L


def level_home(robot: Robot) -> Array:
    """Return the position of the home pose of the robot, or of a better level pose if none is given.

    Poses along the base normal are tried if ``home_pose`` does not suit the machine, for example on a wall.
    Without length limits, the home pose is a guess; the result is then the best height at which the leg parts
    do not overlap.
    """
    if robot.home_position is not None:
        return robot.home_position
    t = home_pose(robot).t
    condition = float(level_conditions(robot.b, robot.p, t[None])[0])
    limited = np.all(np.isfinite(robot.length_limits))
    toward = t + robot.p.mean(axis=0) - robot.b.mean(axis=0)
    directions = [toward / np.linalg.norm(toward)]
    if not condition <= GOOD_CONDITION:
        normal = np.linalg.svd(robot.b - robot.b.mean(axis=0))[2][2]
        directions += [normal, -normal]
    others = np.concatenate([level_positions(robot, direction, HEIGHTS) for direction in directions])
    found = level_conditions(robot.b, robot.p, others)
    lengths = level_lengths(robot, others)
    if limited:
        score = np.abs(lengths - robot.length_limits.mean(axis=-1)).mean(axis=-1)
        score[found > max(GOOD_CONDITION, found.min())] = np.inf
    else:
        passing = np.all(lengths >= parts_of(robot), axis=-1)
        score = np.where(passing | ~passing.any(), found, np.inf)
    best = int(np.argmin(score))
    if not limited or MISPAIRED * found[best] < condition:
        return np.asarray(others[best])
    return t


def home_of(robot: Robot, t: Array) -> Home:
    """Return the level pose at t, or a pose nearby at which the legs are within their limits."""
    low, high = robot.length_limits.T
    margin = np.where(np.isfinite(high), 0.25 * (high - low), 0.0)
    R, L, fits = np.eye(3), level_lengths(robot, t), False
    for inner in (margin, 0.0 * margin):
        pose = _pose_within(robot, t, low + inner, high - inner)
        if pose is not None:
            (R, t), fits = pose, True
            L = np.linalg.norm(t + robot.p @ R.T - robot.b, axis=-1)
            break
    forces = inverse_dynamics(robot, at_rest(R, t), backend="numpy", on_singular="nan")
    return Home(R, t, L, forces.F, fits)


def parts_of(robot: Robot) -> Array:
    """Return the sum of the distances of both centers of mass from their joints along each leg (m), (6,)."""
    return np.asarray(robot.r_d0[:, 0] - robot.r_u0[:, 0])


def level_conditions(b: Array, p: Array, t: Array) -> Array:
    """Return scaled condition numbers of level poses at t (n, 3), shape (..., n); infinity if H is singular.

    p: (6, 3), or the same points in several orders, (..., 1, 6, 3).
    """
    H, _ = centered_H(b, p, t, radius(p.reshape(-1, 3)))
    return scaled_condition_number(H, 1.0)


def _pose_within(robot: Robot, t: Array, low: Array, high: Array) -> tuple[Array, Array] | None:
    """Return a pose (R, t) with leg lengths from low to high (m), (6,), by damped Newton steps, or None."""
    middle, offset = robot.b.mean(axis=0), robot.p.mean(axis=0)
    reach = robot.p - offset
    unit = np.repeat([1.0, radius(robot.p)], 3)
    for share in (1.0, 0.7, 1.4):
        R, r = np.eye(3), (t + offset - middle) * share + middle
        for _ in range(_MOST_STEPS):
            q = reach @ R.T
            S = r + q - robot.b
            L = np.linalg.norm(S, axis=-1)
            miss = np.clip(L, low, high) - L
            if np.abs(miss).max() <= 1e-9 * L.max():
                return R, r - R @ offset
            J = length_rows(q, S, L) / unit
            step = np.linalg.solve(J.T @ J + 1e-4 * np.eye(6), J.T @ miss) / unit
            step *= min(1.0, 0.3 / max(float(np.abs(step[3:]).max()), 0.3))
            R, r = rotation_from_vector(step[3:]) @ R, r + step[:3]
    return None


_MOST_STEPS = 100
