"""Motion: angles and rates agree with each other, shapes broadcast, what is no motion is rejected by name."""

from typing import Any

import numpy as np
import pytest
from command_line import error_of, rejects
from machines import Array
from motion_fields import skew_part

from stewart_sym.motion.motion import Motion
from stewart_sym.motion.rotation import (
    quaternion_from_rotation,
    rotation_from_rpy,
    rotation_from_vector,
    rpy_from_rotation,
    vector_from_rotation,
)

ZERO = np.zeros(3)
E = np.eye(3)


def turn(axis: int, angle: float) -> Array:
    """Rotation about one axis by Rodrigues' formula."""
    k = np.cross(E, E[axis])
    return np.asarray(E + np.sin(angle) * k + (1.0 - np.cos(angle)) * k @ k)


def test_rotations_in_float_are_taken_to_the_nearest_rotation_in_double() -> None:
    rng = np.random.default_rng(32)
    exact = rotation_from_rpy(rng.uniform(-4.0, 4.0, (1000, 3)))
    rounded = exact.astype(np.float32)
    motion = Motion(R=rounded, t=np.zeros(3), omega=np.zeros(3), v=np.zeros(3))
    assert motion.R.dtype == np.float64
    assert np.abs(motion.R - exact).max() < np.finfo(np.float32).eps
    product = np.swapaxes(motion.R, -1, -2) @ motion.R
    assert np.abs(product - np.eye(3)).max() < 8 * np.finfo(np.float64).eps
    # A slice and a second Motion of what is stored leave its bits alone.
    assert np.array_equal(
        Motion(R=motion.R, t=np.zeros(3), omega=np.zeros(3), v=np.zeros(3))[3:7].R, motion.R[3:7]
    )
    for bad in (rounded.astype(np.float64), rounded * np.float32(1.0 + 1e-5), -rounded):
        rejects(
            r"R.*: expected a rotation matrix",
            lambda bad=bad: Motion(R=bad, t=np.zeros(3), omega=np.zeros(3), v=np.zeros(3)),
        )
    with pytest.raises(ValueError, match=r"numbers of single precision, give R as an array of float32$"):
        Motion(R=rounded.tolist(), t=np.zeros(3), omega=np.zeros(3), v=np.zeros(3))


@pytest.mark.parametrize("size", [5e-324, 4e307])
def test_quaternions_may_have_any_length_but_zero(size: float) -> None:
    zero, e, e_dot = np.zeros(3), np.array([1.0, 2.0, 3.0, 1.0]), np.array([0.0, 1.0, -1.0, 2.0])
    one = Motion.from_quaternion(zero, e, zero, e_dot, zero, -e)
    other = Motion.from_quaternion(zero, size * e, zero, size * e_dot, zero, -size * e)
    for name in ("R", "omega", "alpha"):
        assert getattr(other, name) == pytest.approx(getattr(one, name), abs=1e-14)


def test_rotation_is_the_product_of_three_turns() -> None:
    for theta in [*np.random.default_rng(1).uniform(-7.0, 7.0, (50, 3)), np.zeros(3), np.full(3, np.pi / 2)]:
        product = turn(2, theta[2]) @ turn(1, theta[1]) @ turn(0, theta[0])
        np.testing.assert_allclose(rotation_from_rpy(theta), product, atol=1e-15)


def test_angles_in_their_range_come_back() -> None:
    ends = np.array([3.14, 1.57, 3.14])
    angles = np.concatenate(
        [np.random.default_rng(2).uniform(-ends, ends, (200, 3)), np.zeros((1, 3)), [ends, -ends]]
    )
    back = rpy_from_rotation(rotation_from_rpy(angles))
    # Near theta_y = +-pi/2 theta_x and theta_z are known less and less well apart.
    assert (np.abs(back - angles) <= 1e-14 / np.cos(angles[:, 1:2]) ** 2).all()


def test_leading_shapes_broadcast() -> None:
    motion = Motion(R=E, t=np.zeros((5, 3)), omega=np.zeros((4, 1, 3)), v=np.array([1.0, 2.0, 3.0]))
    assert motion.shape == (4, 5)
    assert motion.R.shape == (4, 5, 3, 3)
    np.testing.assert_array_equal(motion.v[3, 4], [1.0, 2.0, 3.0])
    assert Motion.from_rpy(np.zeros((5, 3)), ZERO, ZERO, np.zeros((4, 1, 3))).shape == (4, 5)


@pytest.mark.parametrize(
    "index",
    [2, slice(1, 3), (1, 2), (..., 1), None, np.array([True, False, True, False])],
)
def test_slices_are_those_of_the_leading_shape(index: Any) -> None:
    rng = np.random.default_rng(2)
    t, theta, v, theta_dot = rng.normal(size=(4, 4, 5, 3))
    motion = Motion.from_rpy(t, theta, v, theta_dot)
    places = np.arange(20).reshape(4, 5)[index]
    part = motion[index]
    assert part.shape == places.shape
    np.testing.assert_array_equal(part.t, t.reshape(20, 3)[places])
    np.testing.assert_array_equal(part.R, motion.R.reshape(20, 3, 3)[places])


NAN = np.array([0.0, np.nan, 0.0])
BAD: list[tuple[dict[str, Any], str]] = [
    ({"t": np.zeros(4)}, "t: expected shape (..., 3), got (4,)"),
    ({"v": NAN}, "v: expected finite numbers, entry (1,) is nan"),
    ({"omega": ["1", "2", "3"]}, "omega: expected real numbers"),
    ({"omega": [[1, 2, 3], [1]]}, "omega: expected real numbers of shape (..., 3), got a ragged sequence"),
    ({"alpha": None}, "alpha: expected both accelerations"),
    ({"R": 1.00001 * E}, "R: expected a rotation matrix, R^T R differs from E by 2e-05"),
    ({"R": -E}, "R: expected a rotation matrix, this one is a reflection"),
    ({"R": np.stack([E, np.zeros((3, 3))])}, "R[1]: expected a rotation matrix, R^T R differs from E by 1"),
    (
        {"t": np.zeros((2, 3)), "v": np.zeros((3, 3))},
        "v: expected a leading shape that broadcasts with (2,), got (3,)",
    ),
]


@pytest.mark.parametrize(("wrong", "expected"), BAD)
def test_what_is_no_motion_is_named(wrong: dict[str, Any], expected: str) -> None:
    good = {"R": E, "t": ZERO, "omega": ZERO, "v": ZERO, "alpha": ZERO, "a": ZERO}
    assert error_of(lambda: Motion(**(good | wrong))).startswith(expected)


@pytest.mark.parametrize("seed", range(4))
def test_rates_of_quaternions_of_any_length_are_those_of_the_rotation(seed: int) -> None:
    x, x_dot, x_ddot = np.random.default_rng(seed).normal(size=(3, 4))

    def at(s: float) -> Motion:
        place, rate = x + x_dot * s + 0.5 * x_ddot * s * s, x_dot + x_ddot * s
        return Motion.from_quaternion(ZERO, place, ZERO, rate, ZERO, x_ddot)

    h = 1e-5
    here, before, after = at(0.0), at(-h), at(h)
    spin = (after.R - before.R) / (2 * h) @ here.R.T
    assert skew_part(spin) == pytest.approx(here.omega, abs=1e-8, rel=1e-8)
    assert (after.omega - before.omega) / (2 * h) == pytest.approx(here.alpha, abs=1e-7, rel=1e-7)


def test_quaternions_and_vectors_of_a_rotation_give_it_back() -> None:
    rng = np.random.default_rng(6)
    zero = np.zeros((50, 3))
    phi = rng.normal(size=(50, 3)) * np.logspace(-9, 0.4, 50)[:, None]
    R = rotation_from_vector(phi)
    e = quaternion_from_rotation(R)
    assert rotation_from_vector(vector_from_rotation(R)) == pytest.approx(R, abs=1e-14)
    assert Motion.from_quaternion(zero, e, zero, np.zeros((50, 4))).R == pytest.approx(R, abs=1e-14)
    assert rotation_from_rpy(rpy_from_rotation(R)) == pytest.approx(R, abs=1e-14)
