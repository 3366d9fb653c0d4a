"""The generated kinematics in C, double and float: what NumPy finds, and nothing found that is wrong."""

import numpy as np
import pytest
from kinematics_calls import (
    PRECISIONS,
    AnyArray,
    Array,
    forward,
    inverse,
    velocity,
)
from leg_lengths import lengths, nudged, paper_poses
from machines import dasgupta, machine_size, random_motion, random_robot
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.kinematics.conditioning import characteristic_length, scaled_condition_number
from stewart_sym.kinematics.pose_search import rates_per_twist
from stewart_sym.motion.rotation import rotation_from_vector

# By how much exact lengths of what is found may miss, in rounding units of the terms of S: 16 and their own.
FOUND = 20.0


def misses(robot: ss.Robot, R: AnyArray, t: AnyArray, L: Array) -> Array:
    """Worst difference of lengths of poses from L, in rounding units of the terms of S, by longer numbers."""
    stored = R.dtype.type
    long = [np.asarray(x, dtype=stored).astype(np.longdouble) for x in (R, t, robot.p, robot.b, L)]
    q = np.einsum("nij,kj->nki", long[0], long[2])
    S = q + long[1][:, None] - long[3]
    reach = np.maximum(np.abs(q).max((1, 2)), np.maximum(np.abs(long[1]).max(1), np.abs(long[3]).max()))
    off = np.abs(np.sqrt((S * S).sum(-1)) - long[4]).max(-1)
    return np.asarray(off / reach / np.finfo(stored).eps, dtype=np.float64)


def assert_nothing_is_silent(
    robot: ss.Robot, R: AnyArray, t: AnyArray, L: Array, status: NDArray[np.int32]
) -> None:
    """What is found has the lengths asked for and is a rotation; the rest says that nothing was found."""
    ok = status == results.OK
    assert set(status) <= {results.OK, results.NOT_CONVERGED, results.SINGULAR}
    assert misses(robot, R[ok], t[ok], L[ok]).max(initial=0.0) <= FOUND
    found = R[ok].astype(np.float64)
    skew = np.abs(np.swapaxes(found, -1, -2) @ found - np.eye(3)).max(initial=0.0)
    assert skew <= 8 * np.finfo(R.dtype).eps
    assert np.all(np.linalg.det(found) > 0.0)


def machines(count: int) -> list[tuple[np.random.Generator, ss.Robot]]:
    """Machines of 1 mm to 10 m."""
    made = []
    for seed in range(count):
        rng = np.random.default_rng(seed)
        made.append((rng, random_robot(rng, scale=10.0 ** rng.uniform(-3.0, 1.0))))
    return made


def one_machine(count: int) -> tuple[np.random.Generator, ss.Robot, ss.Motion, Array]:
    """A machine, some poses and their lengths."""
    rng, robot = machines(1)[0]
    motion = random_motion(rng, robot, (count,))
    return rng, robot, motion, np.ascontiguousarray(ss.inverse_kinematics(robot, motion).L)


# Agreement with NumPy


@pytest.mark.parametrize("precision", PRECISIONS)
def test_lengths_and_rates_are_those_of_numpy(precision: str) -> None:
    for rng, robot in machines(6):
        motion = random_motion(rng, robot, (20,))
        expected = ss.inverse_kinematics(robot, motion)
        eps = float(np.finfo(PRECISIONS[precision]).eps)
        L, L_dot = inverse(robot, motion, precision)
        np.testing.assert_allclose(L, expected.L, rtol=40 * eps)
        speed = np.abs(expected.L_dot).max() + np.abs(motion.v).max()
        np.testing.assert_allclose(L_dot, expected.L_dot, rtol=0.0, atol=100 * eps * speed)


@pytest.mark.slow
@pytest.mark.parametrize("precision", PRECISIONS)
def test_pose_is_that_of_numpy_from_near_and_middling_guesses(precision: str) -> None:
    eps = float(np.finfo(PRECISIONS[precision]).eps)
    for rng, robot in [*machines(12), (np.random.default_rng(7), dasgupta())]:
        motion = random_motion(rng, robot, (50,))
        size, L = machine_size(robot), ss.inverse_kinematics(robot, motion).L
        for angle in (0.01, 0.1):
            guess = nudged(rng, motion.R, motion.t, angle, angle * size)
            expected = ss.forward_kinematics(robot, L, guess)
            R, t, status = forward(robot, L, *guess, precision)
            assert (status == results.OK).all()
            assert_nothing_is_silent(robot, R, t, L, status)
            np.testing.assert_allclose(R, expected.R, rtol=0.0, atol=2e4 * eps)
            np.testing.assert_allclose(t, expected.t, rtol=0.0, atol=2e4 * eps * size)


@pytest.mark.parametrize("precision", PRECISIONS)
def test_velocity_is_that_of_numpy(precision: str) -> None:
    eps = float(np.finfo(PRECISIONS[precision]).eps)
    for rng, robot in [*machines(6), (np.random.default_rng(8), dasgupta())]:
        motion = random_motion(rng, robot, (50,))
        rates = ss.inverse_kinematics(robot, motion).L_dot
        v, omega = ss.forward_velocity(robot, motion.R, motion.t, rates)
        twist, status = velocity(robot, motion.R, motion.t, rates, precision)
        assert (status == results.OK).all()
        size = machine_size(robot)
        speed = np.abs(motion.v).max() + size * np.abs(motion.omega).max()
        np.testing.assert_allclose(twist[:, :3], v, rtol=0.0, atol=2e3 * eps * speed)
        np.testing.assert_allclose(twist[:, 3:], omega, rtol=0.0, atol=2e3 * eps * speed / size)


@pytest.mark.parametrize("precision", PRECISIONS)
def test_nothing_is_silent_far_from_the_guess_and_among_singular_poses(precision: str) -> None:
    rng = np.random.default_rng(9)
    robot = dasgupta()
    R, t = paper_poses(rng, 1500, angle=0.4, way=0.2)
    L = lengths(robot, R, t)
    for angle, way, lost in ((0.05, 0.05, 0.002), (0.5, 0.3, 0.02)):
        *found, status = forward(robot, L, *nudged(rng, R, t, angle, way), precision)
        assert_nothing_is_silent(robot, *found, L, status)
        assert np.count_nonzero(status == results.NOT_CONVERGED) <= lost * len(L)


def test_a_guess_that_drifted_from_a_rotation_serves_and_another_does_not() -> None:
    rng, robot, motion, L = one_machine(10)
    drifted = motion.R + 0.01 * rng.uniform(-1.0, 1.0, motion.R.shape)
    R, t, status = forward(robot, L, drifted, motion.t)
    assert (status == results.OK).all()
    assert_nothing_is_silent(robot, R, t, L, status)
    for wrong in (0.0 * motion.R, -motion.R, 1.1 * motion.R, np.full_like(motion.R, 1e300)):
        assert (forward(robot, L, wrong, motion.t)[2] == results.NOT_CONVERGED).all()


# Where it fails


def singular_poses(count: int, shift: float) -> tuple[ss.Robot, Array, Array]:
    """Poses of the paper's machine, a share of a line through its workspace away from where det H is 0."""
    rng, robot = np.random.default_rng(1), dasgupta()
    R_0, t_0 = paper_poses(rng, count, angle=0.1, way=0.1)
    phi, way = rng.uniform(-1.2, 1.2, (count, 3)), rng.uniform(-0.3, 0.3, (count, 3))

    def at(u: Array) -> tuple[Array, Array]:
        return rotation_from_vector(u[:, None] * phi) @ R_0, t_0 + u[:, None] * way

    def sign(u: Array) -> Array:
        return np.asarray(np.sign(np.linalg.det(rates_per_twist(robot, *at(u)))))

    low, high = np.zeros(count), np.ones(count)
    side = sign(low)
    crosses = side != sign(high)
    for _ in range(60):
        middle = (low + high) / 2
        same = sign(middle) == side
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    R, t = at(low - shift)
    return robot, R[crosses], t[crosses]


def condition(robot: ss.Robot, R: AnyArray, t: AnyArray) -> Array:
    H = np.swapaxes(rates_per_twist(robot, R.astype(np.float64), t.astype(np.float64)), -1, -2)
    return scaled_condition_number(H, characteristic_length(robot))


@pytest.mark.parametrize("precision", PRECISIONS)
@pytest.mark.parametrize("shift", [0.0, 1e-7, 1e-5, 1e-4, 1e-2])
def test_near_singular_poses_are_singular_or_right(shift: float, precision: str) -> None:
    """SINGULAR begins no later than at its condition number and no earlier than at a sixth of it."""
    robot, R, t = singular_poses(150, shift)
    L = lengths(robot, R, t)
    most = 1.0 / (16.0 * np.sqrt(float(np.finfo(PRECISIONS[precision]).eps)))
    for guess in ((R, t), nudged(np.random.default_rng(2), R, t, 1e-3, 1e-3)):
        *found, status = forward(robot, L, *guess, precision)
        assert_nothing_is_silent(robot, *found, L, status)
        ok = status == results.OK
        assert condition(robot, found[0][ok], found[1][ok]).max(initial=1.0) <= 1.01 * most
    # From the poses themselves there is nothing to search.
    *found, status = forward(robot, L, R, t, precision)
    assert (condition(robot, R, t)[status == results.SINGULAR] >= most / 6.1).all()
    assert (status[condition(robot, R, t) > 1.01 * most] == results.SINGULAR).all()
    speeds, status = velocity(robot, R, t, np.ones_like(L), precision)
    assert (status[condition(robot, R, t) > 1.01 * most] == results.SINGULAR).all()
    assert np.isfinite(speeds[status == results.OK]).all()
