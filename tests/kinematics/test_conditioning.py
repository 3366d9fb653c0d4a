"""Condition numbers: the 2-norm ratio, infinite at singular poses, and free of units when scaled."""

import dataclasses
from typing import Any

import numpy as np
import pytest
from machines import dasgupta, random_robot
from numpy.typing import NDArray

from stewart_sym.kinematics.conditioning import (
    characteristic_length,
    condition_number,
    scaled_condition_number,
)
from stewart_sym.kinematics.inverse import wrench_matrix
from stewart_sym.motion.motion import Motion

Array = NDArray[np.float64]


def with_singular_values(values: list[float]) -> Array:
    rng = np.random.default_rng(4)
    U, V = (np.linalg.qr(rng.normal(size=(6, 6)))[0] for _ in range(2))
    return np.asarray(U @ np.diag(values) @ V)


def test_ratio_of_extreme_singular_values() -> None:
    assert condition_number(np.eye(6)) == 1.0
    assert condition_number(with_singular_values([5, 4, 3, 2, 1, 0.02])) == pytest.approx(250.0)


def test_batch_of_any_shape() -> None:
    H = np.random.default_rng(5).normal(size=(3, 2, 6, 6))
    numbers = condition_number(H)
    assert numbers.shape == (3, 2)
    assert numbers[2, 1] == pytest.approx(np.linalg.cond(H[2, 1]))
    assert condition_number(np.zeros((0, 6, 6))).shape == (0,)


def test_singular_is_infinite_and_not_finite_is_nan() -> None:
    broken = np.eye(6)
    broken[0, 0] = np.nan
    deficient = with_singular_values([5, 4, 3, 2, 1, 0.0])
    numbers = condition_number(np.stack([np.eye(6), np.zeros((6, 6)), deficient, broken]))
    np.testing.assert_array_equal(numbers, [1.0, np.inf, np.inf, np.nan])
    assert np.isfinite(condition_number(with_singular_values([1, 1, 1, 1, 1, 1e-13])))


def test_scaled_number_does_not_change_with_the_unit_of_length() -> None:
    rng = np.random.default_rng(6)
    robot = random_robot(rng, scale=1.0)
    motion = Motion.from_rpy([0.1, 0.0, 1.5], 0.2 * rng.normal(size=3), np.zeros(3), np.zeros(3))
    millimetres = dataclasses.replace(robot, b=1e3 * robot.b, p=1e3 * robot.p)
    in_millimetres = dataclasses.replace(motion, t=1e3 * motion.t)
    H, H_mm = wrench_matrix(robot, motion), wrench_matrix(millimetres, in_millimetres)
    scaled = scaled_condition_number(H, characteristic_length(robot))
    assert scaled_condition_number(H_mm, characteristic_length(millimetres)) == pytest.approx(float(scaled))
    assert condition_number(H_mm) > 10.0 * condition_number(H)
    assert scaled_condition_number(H, 1.0) == condition_number(H)


def test_characteristic_length_is_the_rms_radius_of_the_platform() -> None:
    robot = dasgupta()
    radii = [sum(x * x for x in point) for point in robot.p.tolist()]
    assert characteristic_length(robot) == pytest.approx((sum(radii) / 6.0) ** 0.5)


@pytest.mark.parametrize("length", [0.0, -1.0, np.nan, np.inf, "a", [1.0, 1.0]])
def test_length_out_of_range_is_named(length: Any) -> None:
    with pytest.raises(ValueError, match=r"^length: expected a finite length > 0 m, got"):
        scaled_condition_number(np.eye(6), length)


@pytest.mark.parametrize("H", ["a", 1j * np.eye(6), [[1.0], [1.0, 2.0]], None, np.eye(3)], ids=str)
def test_what_is_no_matrix_of_real_numbers_is_named(H: Any) -> None:
    with pytest.raises(ValueError, match=r"\AH: expected .*shape \(\.\.\., 6, 6\), got .*\Z"):
        condition_number(H)
