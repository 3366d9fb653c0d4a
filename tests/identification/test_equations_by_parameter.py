"""What parameters add to M, C, g and friction sums up to the closed form and to the regressor."""

from typing import Any

import numpy as np
import pytest
from machines import dasgupta, machine_in_motion

import stewart_sym as ss


@pytest.mark.parametrize("backend", ["c", "numpy", "reference"])
def test_terms_by_parameter_sum_to_those_of_the_closed_form(backend: Any) -> None:
    robot, motion = machine_in_motion(0, (1, 2))
    pi, found = (
        ss.inertial_parameters(robot).values,
        ss.equations_by_parameter(robot, motion, backend=backend),
    )
    expected = ss.equations_of_motion(robot, motion)
    for name in ("M", "C", "g", "friction"):
        terms, whole = getattr(found, name) * pi, getattr(expected, name)
        assert terms.shape == (*whole.shape, 148)
        error, size = np.abs(terms.sum(axis=-1) - whole), np.abs(terms).sum(axis=-1)
        rows = size.reshape(*size.shape[:2], 2, -1).max(axis=-1)
        assert (error.reshape(*size.shape[:2], 2, -1).max(axis=-1) <= 1e-12 * rows).all(), name


def test_terms_by_parameter_sum_to_the_regressor() -> None:
    robot, motion = machine_in_motion(7, (4,))
    found, Y = ss.equations_by_parameter(robot, motion), ss.regressor(robot, motion)
    twist, rate = (
        np.concatenate(pair, axis=-1) for pair in ((motion.v, motion.omega), (motion.a, motion.alpha))
    )
    total = np.einsum("nijk,nj->nik", found.M, rate) + np.einsum("nijk,nj->nik", found.C, twist)
    total += found.g + found.friction
    np.testing.assert_allclose(total, Y, rtol=0.0, atol=1e-11 * np.abs(Y).max())
    for name, value in vars(ss.equations_by_parameter(robot, motion[2])).items():
        np.testing.assert_array_equal(value, getattr(found, name)[2])


def test_a_pose_without_a_regressor_is_named_or_is_nan_alone() -> None:
    robot = dasgupta()
    zero = np.zeros((2, 3))
    S = np.array([robot.k[1], [0.0, 0.0, 1.0]])
    motion = ss.Motion(np.eye(3), robot.b[1] - robot.p[1] + S, zero, zero)
    with pytest.raises(ValueError, match=r"motion\[0\].*leg 2"):
        ss.equations_by_parameter(robot, motion)
    for value in vars(ss.equations_by_parameter(robot, motion, on_singular="nan")).values():
        assert np.isnan(value[0]).all()
        assert np.isfinite(value[1]).all()
