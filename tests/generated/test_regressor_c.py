"""The regressor in C: NumPy's bits, 50-digit truth near joint singularities too, the contract of statuses."""

import ctypes
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from fifty_digits import DIGITS, block_inputs, whole_regressor
from leaning_legs import leaning
from machines import dasgupta, home_position, machine_in_motion, machine_size, random_motion
from mpmath import mp

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.backend.c_kernel import address, contiguous, library
from stewart_sym.backend.kernel import MOTION, robot_numbers
from stewart_sym.dynamics import inverse_dynamics
from stewart_sym.identification import parameters
from stewart_sym.motion.motion import Motion
from stewart_sym.results import BAD_ARGUMENT, JOINT_SINGULAR, NOT_FINITE, OK, ZERO_LENGTH
from stewart_sym.robot.robot import Robot

ALL = 148
UNTOUCHED = -7.0
EPSILON = np.finfo(np.float32).eps
NULL = ctypes.c_void_p(None)
SOME = np.array([147, 0, 3, 22, 23, 137, 138, 3], dtype=np.int32)


def function(name: str, *defines: str) -> Callable[..., int]:
    return getattr(library("exact_regressor", defines), f"stewart_exact_regressor{name}")


def one_pose(
    robot: Robot, motion: Motion, columns: np.ndarray | None = None, dtype: type = np.float64
) -> Any:
    """Y of a motion's only pose, and its status."""
    width = 0 if columns is None else len(columns)
    Y = np.full((6, width if columns is not None else ALL), UNTOUCHED, dtype=dtype)
    numbers = robot_numbers(robot).astype(dtype)
    moved = np.concatenate([np.ravel(getattr(motion, name)) for name in MOTION]).astype(dtype)
    one = function("", *(["STEWART_FLOAT"] if dtype == np.float32 else []))
    status = one(address(numbers), address(moved), address(columns), ctypes.c_size_t(width), address(Y))
    return Y, status


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


def test_one_pose_is_the_batch_and_chosen_columns_are_those_of_all_bit_for_bit() -> None:
    rng = np.random.default_rng(3)
    for _ in range(4):
        robot, motion = machine_in_motion(rng, (11,))
        Y = ss.regressor(robot, motion)
        np.testing.assert_array_equal(ss.regressor(robot, motion, columns=SOME), Y[..., SOME])
        for i in range(11):
            np.testing.assert_array_equal(one_pose(robot, motion[i])[0], Y[i])
            np.testing.assert_array_equal(one_pose(robot, motion[i], SOME)[0], Y[i][:, SOME])


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
    rng = np.random.default_rng(5)
    for _ in range(20):
        robot, motion = machine_in_motion(rng, scale=1.0)
        found, status = one_pose(robot, motion, dtype=np.float32)
        assert status == OK
        expected, _ = one_pose(robot, motion)
        error, size = np.abs(found - expected).max(axis=0), np.abs(expected).max(axis=0)
        of_leg, largest = error[:-10].reshape(6, 23), size[:-10].reshape(6, 23).max(axis=0)
        assert (of_leg <= 256.0 * EPSILON * largest).all()
        assert (error[-10:] <= 256.0 * EPSILON * size[-10:]).all()


@pytest.mark.parametrize("columns", [None, SOME])
def test_a_pose_without_a_regressor_has_a_status_and_is_left_as_it_was(columns: np.ndarray | None) -> None:
    robot = dasgupta()
    motion, expected = faulty(robot)
    numbers, arrays = robot_numbers(robot), [contiguous(getattr(motion, name)) for name in MOTION]
    Y = np.full((6, 6, ALL if columns is None else len(columns)), UNTOUCHED)
    status = np.full(6, -1, dtype=np.int32)
    first = function("_batch")(
        address(numbers),
        ctypes.c_size_t(6),
        (ctypes.c_void_p * 8)(*map(address, arrays)),
        address(columns),
        ctypes.c_size_t(0 if columns is None else len(columns)),
        address(Y),
        address(status),
    )
    assert first == ZERO_LENGTH
    assert status.tolist() == expected
    assert np.isfinite(Y[0]).all()
    assert (Y[1:] == UNTOUCHED).all()
    for i, code in enumerate(expected):
        pose = Motion._unchecked(**{name: getattr(motion, name)[i] for name in MOTION})
        found, alone = one_pose(robot, pose, columns)
        assert alone == code
        np.testing.assert_array_equal(found, Y[i])


@pytest.mark.parametrize("backend", ["c", "numpy", "reference"])
def test_every_backend_finds_the_same_faults(backend: Any) -> None:
    robot = dasgupta()
    motion, expected = faulty(robot)
    Y = ss.regressor(robot, motion, on_singular="nan", backend=backend)
    assert np.isnan(Y).all(axis=(-1, -2)).tolist() == [code != OK for code in expected]
    rejects(r"^motion\[1\]: a leg has length zero \(leg 4\)", ss.regressor, robot, motion, backend=backend)


def test_arguments_that_are_needed_and_columns_that_there_are_not_are_rejected() -> None:
    robot, pose, Y = robot_numbers(dasgupta()), np.zeros(30), np.full(6 * ALL, UNTOUCHED)
    zeros = np.zeros(9)
    arrays = (ctypes.c_void_p * 8)(*[address(zeros)] * 6)
    none, one = ctypes.c_size_t(0), ctypes.c_size_t(1)
    given = (address(robot), address(pose), NULL, none, address(Y))
    of_many = (address(robot), one, arrays, NULL, none, address(Y), NULL)
    wrong = [
        ((*given[:i], NULL, *given[i + 1 :]), (*of_many[:j], NULL, *of_many[j + 1 :]))
        for i, j in ((0, 0), (1, 2), (4, 5))
    ]
    for number in (-1, ALL):
        columns = (address(np.array([number], dtype=np.int32)), one)
        wrong.append(((*given[:2], *columns, given[4]), (*of_many[:3], *columns, *of_many[5:])))
    wrong.append(((*given[:2], NULL, one, given[4]), (*of_many[:3], NULL, one, *of_many[5:])))
    for of_one, many in wrong:
        assert function("")(*of_one) == BAD_ARGUMENT
        assert function("_batch")(*many) == BAD_ARGUMENT
    for missing in range(6):
        lacking = (ctypes.c_void_p * 8)(*[None if i == missing else arrays[i] for i in range(6)])
        assert function("_batch")(*of_many[:2], lacking, *of_many[3:]) == BAD_ARGUMENT
    assert (Y == UNTOUCHED).all()


@pytest.mark.usefixtures("rounded_twice")
def test_without_a_compiler_numpy_serves_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    def nothing(name: str) -> ctypes.CDLL:
        raise native.CompilerError("none")

    robot, motion = machine_in_motion(1, (2,))
    expected = ss.regressor(robot, motion)
    monkeypatch.setattr(parameters, "library", nothing)
    inverse_dynamics._say_once.cache_clear()
    with pytest.warns(RuntimeWarning, match="NumPy kernels are used"):
        np.testing.assert_array_equal(ss.regressor(robot, motion), expected)


@pytest.mark.parametrize("columns", [[148], [-1], [0.5], [[1]], ["m_d1"]])
def test_columns_that_there_are_not_are_named(columns: Any) -> None:
    robot = dasgupta()
    motion = random_motion(np.random.default_rng(0), robot)
    for backend in ("c", "numpy"):
        with pytest.raises(ValueError, match=r"^columns: expected whole numbers from 0 to 147, \(n,\), got "):
            ss.regressor(robot, motion, columns=columns, backend=backend)
    assert ss.regressor(robot, motion, columns=[]).shape == (6, 0)
