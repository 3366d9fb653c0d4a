"""The regressor in C: NumPy's bits, 50-digit truth near joint singularities too, the same faults everywhere.

One pose, chosen columns, statuses, and null pointers: ``test_attack_c``.
"""

import ctypes
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from fifty_digits import DIGITS, block_inputs, whole_regressor
from leaning_legs import leaning
from machines import dasgupta, home_position, machine_in_motion, machine_size
from mpmath import mp

import stewart_sym as ss
from stewart_sym.backend.kernel import MOTION, robot_numbers
from stewart_sym.calls.c_kernel import address, library
from stewart_sym.motion.motion import Motion
from stewart_sym.results import JOINT_SINGULAR, NOT_FINITE, OK, ZERO_LENGTH
from stewart_sym.robot.robot import Robot

ALL = 148
EPSILON = np.finfo(np.float32).eps


def faulty(robot: Robot) -> tuple[Motion, list[int]]:
    """Poses of which all but the first have no regressor, and their statuses."""
    t = np.tile(home_position(robot.b, machine_size(robot)), (6, 1))
    omega, v, a = np.ones((3, 6, 3))
    t[1], t[2] = robot.b[3] - robot.p[3], robot.b[4] - robot.p[4] + robot.k[4]
    t[3], omega[4], v[5] = np.nan, np.inf, 1e300
    statuses = [OK, ZERO_LENGTH, JOINT_SINGULAR, NOT_FINITE, NOT_FINITE, NOT_FINITE]
    return Motion._unchecked(np.tile(np.eye(3), (6, 1, 1)), t, omega, v, a, a, a, a), statuses


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.usefixtures("rounded_twice")
def test_numpy_has_the_same_bits_and_the_reference_the_same_numbers(seed: int) -> None:
    robot, motion = machine_in_motion(seed, (3, 5))
    Y = ss.regressor(robot, motion)
    np.testing.assert_array_equal(Y, ss.regressor(robot, motion, backend="numpy"))
    expected = ss.regressor(robot, motion, backend="reference")
    size = np.abs(expected).max(axis=(0, 1, 2))
    assert np.abs(Y - expected).max(axis=(0, 1, 2)) == pytest.approx(0.0, abs=1e-12 * size.max())
    assert (size[np.abs(Y).max(axis=(0, 1, 2)) == 0.0] == 0.0).all()


def near_joint_singularity(seed: int, sine: float) -> tuple[Robot, Motion]:
    """A machine and a pose with legs 2 and 5 at an angle of this sine to their axes."""
    rng = np.random.default_rng(seed)
    robot, motion = machine_in_motion(rng)
    for leg in (1, 4):
        robot = leaning(robot, motion, sine, leg, rng.normal(size=3))
    return robot, motion


def changed(values: dict[str, mp.mpf], rng: np.random.Generator) -> dict[str, mp.mpf]:
    """Numbers that differ by some half of a rounding unit."""
    return {
        name: value * (1 + mp.mpf(rng.uniform(-0.5, 0.5)) * mp.mpf(2) ** -52)
        for name, value in values.items()
    }


@pytest.mark.parametrize("sine", [1.0, 1e-3, 1e-9])
def test_error_is_a_few_times_the_sensitivity_near_joint_singularities(sine: float) -> None:
    """Of each column, by the 50-digit blocks at inputs that differ by half a rounding unit."""
    robot, motion = near_joint_singularity(1, sine)
    Y = ss.regressor(robot, motion)
    with mp.workdps(DIGITS):
        rng = np.random.default_rng(2)
        raw = [block_inputs(robot, motion, leg) for leg in range(6)]
        others = [whole_regressor([changed(each, rng) for each in raw]) for _ in range(4)]
        true = whole_regressor(raw)
        spread = np.max([np.abs(other - true) for other in others], axis=0).astype(float)
        error = np.abs(Y - true).astype(float)
    size = np.abs(true).astype(float)
    for rows in (slice(0, 3), slice(3, 6)):
        allowed = 10.0 * spread[rows].max(axis=0) + 64.0 * 2.0**-52 * size[rows].max(axis=0)
        assert (error[rows].max(axis=0) <= allowed).all()


def test_float_has_the_digits_of_float() -> None:
    """Beside the largest column of the same parameter, of any leg."""
    single = library("exact_regressor", "float").stewart_exact_regressor
    rng = np.random.default_rng(5)
    for _ in range(10):
        robot, motion = machine_in_motion(rng, scale=1.0)
        numbers = [np.concatenate([np.ravel(getattr(motion, name)) for name in MOTION]), np.zeros((6, ALL))]
        given = [each.astype(np.float32) for each in (robot_numbers(robot), *numbers)]
        none = (ctypes.c_void_p(), ctypes.c_size_t(0))
        assert single(address(given[0]), address(given[1]), *none, address(given[2])) == OK
        found, expected = given[2], ss.regressor(robot, motion)
        error, size = np.abs(found - expected).max(axis=0), np.abs(expected).max(axis=0)
        of_leg, largest = error[:-10].reshape(6, 23), size[:-10].reshape(6, 23).max(axis=0)
        assert (of_leg <= 256.0 * EPSILON * largest).all()
        assert (error[-10:] <= 256.0 * EPSILON * size[-10:]).all()


@pytest.mark.parametrize("backend", ["c", "numpy", "reference"])
def test_every_backend_finds_the_same_faults(backend: Any) -> None:
    robot = dasgupta()
    motion, expected = faulty(robot)
    Y = ss.regressor(robot, motion, on_singular="nan", backend=backend)
    assert np.isnan(Y).all(axis=(-1, -2)).tolist() == [code != OK for code in expected]
    rejects(r"^motion\[1\]: a leg has length zero \(leg 4\)", ss.regressor, robot, motion, backend=backend)
