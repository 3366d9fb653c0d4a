"""Forward kinematics from a guess: never farther from it than SciPy's Levenberg-Marquardt search gets."""

import dataclasses
import functools
from collections.abc import Callable

import numpy as np
import pytest
from kinematics_calls import forward
from leg_lengths import lengths
from machines import Array, dasgupta, home_position, random_robot
from scipy.optimize import least_squares
from sweeps import FULL, share, sweep

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.kinematics.pose_search import distance, newton
from stewart_sym.motion.rotation import rotation_from_quaternion, rotation_from_vector

# Machine with 40 real assembly modes: P. Dietmaier, "The Stewart-Gough platform of general geometry can have
# 40 real postures", 1998.
BASE = [
    *([0.0, 0.0, 0.0], [1.107915, 0.0, 0.0], [0.549094, 0.756063, 0.0]),
    *([0.735077, -0.223935, 0.525991], [0.514188, -0.526063, -0.368418], [0.590473, 0.094733, -0.205018]),
]
PLATFORM = [
    *([0.0, 0.0, 0.0], [0.542805, 0.0, 0.0], [0.956919, -0.528915, 0.0]),
    *([0.665885, -0.353482, 1.402538], [0.478359, 1.158742, 0.107672], [-0.137087, -0.235121, 0.353913]),
]
LENGTHS = [1.0, 0.645275, 1.086284, 1.503439, 1.281933, 0.771071]
RADII = (1e-3, 3e-3, 1e-2, 2e-2, 5e-2) if FULL else (1e-3, 5e-2)
Poses = tuple[Array, Array]


def any_rotations(rng: np.random.Generator, count: int) -> Array:
    e = rng.normal(size=(count, 4))
    return rotation_from_quaternion(e / np.linalg.norm(e, axis=-1, keepdims=True))


@functools.cache
def forty_modes() -> tuple[ss.Robot, Poses]:
    """The machine of 40 assembly modes, and these, found from random starts."""
    robot = dataclasses.replace(dasgupta(), b=np.array(BASE), p=np.array(PLATFORM))
    rng = np.random.default_rng(0)
    modes: list[Poses] = []
    while len(modes) < 40:
        start = any_rotations(rng, 1000), rng.normal(size=(1000, 3))
        found = newton(robot, np.tile(LENGTHS, (1000, 1)), *start)
        for R, t in zip(found.R[found.converged], found.t[found.converged], strict=True):
            if all(distance((R, t), mode) > 1e-6 for mode in modes):
                modes.append((R, t))
    return robot, (np.array([R for R, _ in modes]), np.array([t for _, t in modes]))


def random_case(seed: int) -> tuple[ss.Robot, Poses]:
    """A machine with random points, or every other one with points near hexagons, and poses at random."""
    rng, count = np.random.default_rng(seed), 40
    if seed % 2:
        b, p = 0.5 * rng.normal(size=(2, 6, 3))
        robot = dataclasses.replace(dasgupta(), b=b, p=p)
        return robot, (any_rotations(rng, count), 0.7 * rng.normal(size=(count, 3)))
    robot = random_robot(rng, scale=1.0)
    R = rotation_from_vector(0.4 * rng.normal(size=(count, 3)))
    return robot, (R, home_position(robot.b, 1.0) + 0.2 * rng.normal(size=(count, 3)))


def guesses(rng: np.random.Generator, R: Array, t: Array, radius: float) -> Poses:
    """Poses at a distance from others, m and rad."""
    z = rng.normal(size=(len(R), 6))
    z *= radius / np.linalg.norm(z, axis=-1, keepdims=True)
    return rotation_from_vector(z[:, 3:]) @ R, t + z[:, :3]


def levenberg_marquardt(robot: ss.Robot, L: Array, R: Array, t: Array) -> Poses | None:
    """Pose that SciPy's search finds from a guess, by position and rotation vector; None without one."""

    def at(x: Array) -> Poses:
        return rotation_from_vector(x[3:]) @ R, x[:3]

    def misses(x: Array) -> Array:
        turned, where = at(x)
        return np.linalg.norm(robot.p @ turned.T + where - robot.b, axis=-1) - L

    start = np.concatenate([t, np.zeros(3)])
    found = least_squares(misses, start, method="lm", xtol=1e-14, ftol=1e-14, gtol=1e-14)
    return at(found.x) if np.abs(found.fun).max() < 1e-9 else None


def by_numpy(robot: ss.Robot, L: Array, guess: Poses) -> tuple[Poses, Array]:
    found = ss.forward_kinematics(robot, L, guess, "nan")
    return (found.R, found.t), found.status


def by_c(robot: ss.Robot, L: Array, guess: Poses) -> tuple[Poses, Array]:
    R, t, status = forward(robot, L, *guess)
    return (R.astype(np.float64), t.astype(np.float64)), status


@functools.cache
def asked(case: int, radius: float) -> tuple[ss.Robot, Array, Poses, list[Poses | None]]:
    """Robot, lengths, guesses and what SciPy finds from these; case 0: the machine of 40 modes."""
    robot, (R, t) = random_case(case) if case else forty_modes()
    each = np.arange(share(400, 40 if case else 10)) % len(R)
    R, t = R[each], t[each]
    L, guess = lengths(robot, R, t), guesses(np.random.default_rng(case), R, t, radius)
    return robot, L, guess, [levenberg_marquardt(robot, *one) for one in zip(L, *guess, strict=True)]


@pytest.mark.slow
@sweep
@pytest.mark.parametrize("search", [by_numpy, by_c])
@pytest.mark.parametrize("radius", RADII)
def test_no_pose_is_farther_from_a_near_guess_than_levenberg_marquardt_s(
    radius: float, search: Callable[[ss.Robot, Array, Poses], tuple[Poses, Array]]
) -> None:
    compared = 0
    for case in range(1 + share(20, 10)):
        robot, L, guess, theirs = asked(case, radius)
        (R, t), status = search(robot, L, guess)
        for i, other in enumerate(theirs):
            if other is not None:
                assert status[i] == results.OK, (case, i)
                at = guess[0][i], guess[1][i]
                own = float(distance(at, (R[i], t[i])))
                assert own <= float(distance(at, other)) * (1.0 + 1e-6) + 1e-9, (case, i)
                compared += 1
    assert compared > 40
