"""Leg kinematics: rates are derivatives of lengths, geometry does what it does; condition numbers."""

import dataclasses

import numpy as np
import pytest
from command_line import rejects
from machines import Array, dasgupta, random_robot
from motion_fields import motion_of

from stewart_sym.dynamics.inverse_dynamics import inverse_dynamics
from stewart_sym.kinematics.conditioning import (
    characteristic_length,
    condition_number,
    scaled_condition_number,
)
from stewart_sym.kinematics.inverse_kinematics import (
    MIN_JOINT_SINE,
    clear_of_joint_singularities,
    inverse_kinematics,
    wrench_matrix,
    wrench_matrix_rate,
)
from stewart_sym.motion.motion import Motion
from stewart_sym.motion.rotation import rotation_from_rpy


def arc(rng: np.random.Generator, h: float) -> tuple[Motion, Motion, Motion]:
    """Three poses at -h, 0 and h of one accelerated motion; the rates are those of the middle one."""
    q, v, a = rng.normal(size=(3, 6)) + np.array([[0, 0, 9, 0, 0, 0], *[[0] * 6] * 2])

    def at(x: float) -> Motion:
        return motion_of(np.array([q + v * x + 0.5 * a * x**2, v + a * x, a]))

    return at(-h), at(0.0), at(h)


@pytest.mark.parametrize("seed", range(2))
def test_rates_are_the_derivatives_of_the_lengths(seed: int) -> None:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, scale=1.0)
    h = 1e-4
    before, now, after = (inverse_kinematics(robot, motion) for motion in arc(rng, h))
    scale = 1.0 + np.abs(now.L_dot).max() ** 3 + np.abs(now.L_ddot).max() ** 2
    np.testing.assert_allclose(now.L_dot, (after.L - before.L) / (2 * h), atol=1e-6 * scale)
    np.testing.assert_allclose(now.L_ddot, (after.L_dot - before.L_dot) / (2 * h), atol=1e-6 * scale)


def test_legs_span_from_base_to_platform_points() -> None:
    rng = np.random.default_rng(7)
    robot = random_robot(rng, scale=1.0)
    theta, t = rng.normal(size=(2, 3)) + np.array([[0.0], [4.0]])
    motion = Motion.from_rpy(t, theta, np.zeros(3), np.zeros(3))
    legs = inverse_kinematics(robot, motion)
    assert legs.L_ddot is None
    for i in range(6):
        platform_point = rotation_from_rpy(theta) @ robot.p[i] + t
        np.testing.assert_allclose(robot.b[i] + legs.L[i] * legs.s[i], platform_point, atol=1e-14)
        np.testing.assert_allclose(legs.S[i], platform_point - robot.b[i], atol=1e-14)
    np.testing.assert_allclose(np.linalg.norm(legs.s, axis=-1), 1.0, rtol=1e-15)
    np.testing.assert_array_equal(legs.L_dot, np.zeros(6))


def test_leg_of_length_zero_is_named() -> None:
    robot = random_robot(np.random.default_rng(10), scale=1.0)
    still = np.zeros(3)
    on_base = Motion(R=np.eye(3), t=np.stack([np.ones(3), robot.b[3] - robot.p[3]]), omega=still, v=still)
    rejects(r"^motion: leg 4 has length zero at motion\[1\]$", inverse_kinematics, robot, on_base)
    rejects(r"^motion: leg 4 has length zero$", inverse_kinematics, robot, on_base[1])


@pytest.mark.parametrize("seed", range(2))
def test_H_maps_the_twist_to_leg_rates_and_its_rate_to_their_accelerations(seed: int) -> None:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, scale=1.0)
    _, now, _ = arc(rng, 0.0)
    legs = inverse_kinematics(robot, now)
    H, H_dot = wrench_matrix(robot, now), wrench_matrix_rate(robot, now)
    twist, rate = np.concatenate([now.v, now.omega]), np.concatenate([now.a, now.alpha])
    np.testing.assert_allclose(H.T @ twist, legs.L_dot, rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(H.T @ rate + H_dot.T @ twist, legs.L_ddot, rtol=1e-11, atol=1e-12)
    np.testing.assert_allclose(H, inverse_dynamics(robot, now).H, rtol=1e-12, atol=1e-13)


def test_a_leg_near_its_universal_axis_is_not_clear_of_it() -> None:
    robot = dasgupta()
    motion = Motion(R=np.eye(3), t=np.array([0.1, 0.0, 0.5]), omega=np.zeros(3), v=np.zeros(3))
    legs = inverse_kinematics(robot, motion)
    across = np.cross(legs.s, [1.0, 0.0, 0.0])
    across /= np.linalg.norm(across, axis=-1)[:, None]
    for off, expected in ((1.01 * MIN_JOINT_SINE, True), (0.99 * MIN_JOINT_SINE, False)):
        k = across.copy()
        k[3] = off * across[3] + np.sqrt(1 - off**2) * legs.s[3]
        assert clear_of_joint_singularities(dataclasses.replace(robot, k=k), legs) == expected
    spherical = random_robot(np.random.default_rng(0), "spherical")
    assert clear_of_joint_singularities(spherical, legs)


def with_singular_values(values: list[float]) -> Array:
    rng = np.random.default_rng(4)
    U, V = (np.linalg.qr(rng.normal(size=(6, 6)))[0] for _ in range(2))
    return np.asarray(U @ np.diag(values) @ V)


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
    millimeters = dataclasses.replace(robot, b=1e3 * robot.b, p=1e3 * robot.p)
    in_millimeters = dataclasses.replace(motion, t=1e3 * motion.t)
    H, H_mm = wrench_matrix(robot, motion), wrench_matrix(millimeters, in_millimeters)
    scaled = scaled_condition_number(H, characteristic_length(robot))
    assert scaled_condition_number(H_mm, characteristic_length(millimeters)) == pytest.approx(float(scaled))
    assert condition_number(H_mm) > 10.0 * condition_number(H)
    assert scaled_condition_number(H, 1.0) == condition_number(H)
