"""Machines and poses for tests of error bounds, some near a singular pose, some wild."""

import dataclasses
import functools
from collections.abc import Callable

import numpy as np
from machines import MIN_JOINT_SINE, Array, machine_size, random_motion, random_robot, rotation

from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

PRECISIONS = ("double", "float")
DTYPE = {"double": np.float64, "float": np.float32}
NEAREST = 1e-4
"""Share of the way back from the singular pose, at least."""


def near_singular_motion(rng: np.random.Generator, robot: Robot) -> Motion:
    """A motion to a singular pose, 1e-4 to 0.3 of the way before it; no leg is near its joint singularity."""
    for _ in range(1000):
        start = random_motion(rng, robot)
        turn, shift = 1.5 * rng.normal(size=3), 0.3 * machine_size(robot) * rng.normal(size=3)

        pose = functools.partial(_on_the_way, start, turn, shift)
        singular = _first_sign_change(lambda way, pose=pose: _determinant(robot, *pose(way)))
        if singular is None:
            continue
        R, t = pose(singular * (1 - 10 ** rng.uniform(np.log10(NEAREST), np.log10(0.3))))
        if _clear_of_joint_singularities(robot, R, t):
            return Motion(
                R=R,
                t=t,
                omega=start.omega,
                v=start.v,
                alpha=start.alpha,
                a=start.a,
                F_ext=start.F_ext,
                M_ext=start.M_ext,
            )
    raise RuntimeError("no motion toward a singular pose found in 1000 draws")


def _on_the_way(start: Motion, turn: Array, shift: Array, way: float) -> tuple[Array, Array]:
    return rotation((way + 1e-9) * turn) @ start.R, start.t + way * shift


def _first_sign_change(value: Callable[[float], float]) -> float | None:
    """Where a function of 0 to 1 changes its sign for the first time, by bisection; None if it does not."""
    ways = np.linspace(0.0, 1.0, 21)
    signs = np.sign([value(way) for way in ways])
    change = np.flatnonzero(signs != signs[0])
    if change.size == 0:
        return None
    low, high = ways[change[0] - 1], ways[change[0]]
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if np.sign(value(middle)) == signs[0] else (low, middle)
    return float(low)


def _legs(robot: Robot, R: Array, t: Array) -> tuple[Array, Array]:
    """q and s, (6, 3)."""
    q = robot.p @ R.T
    S = q + t - robot.b
    return q, S / np.linalg.norm(S, axis=-1, keepdims=True)


def _determinant(robot: Robot, R: Array, t: Array) -> float:
    q, s = _legs(robot, R, t)
    return float(np.linalg.det(np.vstack([s.T, np.cross(q, s).T])))


def _clear_of_joint_singularities(robot: Robot, R: Array, t: Array) -> bool:
    _, s = _legs(robot, R, t)
    return bool(np.all(np.linalg.norm(np.cross(robot.k, s), axis=-1) > MIN_JOINT_SINE))


def case(rng: np.random.Generator, number: int) -> tuple[Robot, Motion]:
    """A robot of its own with a motion; every tenth near a singular pose."""
    robot = random_robot(rng)
    return robot, (near_singular_motion if number % 10 == 9 else random_motion)(rng, robot)


def wild(rng: np.random.Generator, robot: Robot, motion: Motion) -> tuple[Robot, Motion]:
    """Legs as near to their axes as 1e-5, rates and loads from nothing to ten thousand times as large."""
    S = robot.p @ motion.R.T + motion.t - robot.b
    s = S / np.linalg.norm(S, axis=-1, keepdims=True)
    k = s + 10 ** rng.uniform(-5, 0) * rng.normal(size=(6, 3))
    vectors = {
        name: getattr(motion, name) * rng.choice([0.0, 10 ** rng.uniform(-4, 4)])
        for name in ("omega", "v", "alpha", "a", "F_ext", "M_ext")
    }
    return (
        dataclasses.replace(robot, k=k / np.linalg.norm(k, axis=-1, keepdims=True)),
        Motion(R=motion.R, t=motion.t, **vectors),
    )
