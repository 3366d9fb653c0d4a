"""Unsolvable poses and bad arguments: one clear line, or a status and NaN, as the caller chooses."""

import dataclasses
import re
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from machines import dasgupta, machine_in_motion, random_motion, random_robot
from motion_fields import UNLOADED, stacked
from unsolvable_poses import BACKENDS, CASES, at_rest

import stewart_sym as ss
from stewart_sym import results


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("case", CASES)
def test_a_pose_without_an_answer_is_one_clear_line_or_nan_that_leaves_its_neighbours(
    backend, case: str
) -> None:
    make, code, text = CASES[case]
    robot, bad = make()
    for function in (ss.inverse_dynamics, ss.joint_reactions):
        with pytest.raises(ValueError, match=re.escape(text)) as caught:
            function(robot, bad, backend=backend)
        assert "\n" not in str(caught.value)
    good = at_rest([0.13, 0.04, 0.6])
    both = stacked([good, bad, good], UNLOADED)
    found = ss.inverse_dynamics(robot, both, backend=backend, on_singular="nan")
    assert list(found.status) == [0, code, 0]
    assert np.isnan([*found.F[1], *found.H[1].ravel()]).all()
    alone = ss.inverse_dynamics(robot, good, backend=backend).F
    np.testing.assert_allclose(found.F[[0, 2]], [alone, alone], rtol=1e-12)
    with pytest.warns(ss.SingularPoseWarning, match=r"motion\[1\]"):
        ss.inverse_dynamics(robot, both, backend=backend, on_singular="warn")
    reactions = ss.joint_reactions(robot, both, backend=backend, on_singular="nan")
    assert np.isnan([*reactions.F_u[1].ravel(), *reactions.M_u[1]]).all()
    assert np.isfinite(reactions.F_u[[0, 2]]).all()


@pytest.mark.parametrize("backend", BACKENDS)
def test_numbers_that_overflow_are_reported(backend) -> None:
    robot, motion = machine_in_motion(1)
    huge = ss.Motion(motion.R, motion.t, motion.omega, np.full(3, 1e200), motion.alpha, motion.a)
    with warnings.catch_warnings(action="error"):
        found = ss.inverse_dynamics(robot, huge, backend=backend, on_singular="nan")
    assert found.status == results.NOT_FINITE


@pytest.mark.parametrize(
    "function", [ss.inverse_dynamics, ss.joint_reactions, ss.massless_forces, ss.inverse_kinematics]
)
def test_what_is_no_robot_or_motion_is_named(function: Callable[..., object]) -> None:
    robot, motion = dasgupta(), at_rest([0.1, 0, 0.5])
    with pytest.raises(ValueError, match=r"^robot: expected a Robot, got Motion$"):
        function(motion, motion)
    with pytest.raises(ValueError, match=r"^motion: expected a Motion, got ndarray$"):
        function(robot, motion.R)


@pytest.mark.parametrize("F", [np.zeros(5), np.zeros((2, 6)), 1.0, "a", None, [1j] * 6], ids=str)
def test_forces_of_another_shape_have_no_dynamic_fraction(F: Any) -> None:
    with pytest.raises(ValueError, match=r"^F: expected forces of shape \(6,\)"):
        ss.dynamic_fraction(dasgupta(), at_rest([0.1, 0, 0.5]), F)


@pytest.mark.parametrize(
    ("bearing", "got"),
    [
        ([0.1] * 5, r"shape \(5,\)"),
        (np.zeros((2, 6)), r"shape \(2, 6\)"),
        (np.nan, "nan"),
        ([0, 0, 0, np.inf, 0, 0], "inf"),
        ("a", ".* entries"),
        (1j, "complex128 entries"),
        ([[0.1], [0.1, 0.2]], "a ragged sequence"),
    ],
    ids=str,
)
def test_bad_bearings_are_named(bearing: Any, got: str) -> None:
    with pytest.raises(ValueError, match=rf"\Abearing: expected one finite distance or six, got {got}\Z"):
        ss.joint_reactions(dasgupta(), at_rest([0.1, 0, 0.5]), bearing=bearing)


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("shape", [(), (3,)])
def test_reactions_that_overflow_are_reported(backend, shape: tuple[int, ...]) -> None:
    robot = dasgupta()
    motion = ss.Motion(np.eye(3), np.broadcast_to([0.13, 0.04, 0.6], (*shape, 3)), *np.zeros((4, 3)))
    with warnings.catch_warnings(action="error"):
        found = ss.joint_reactions(robot, motion, backend=backend, bearing=1e308, on_singular="nan")
    assert np.all(found.status == results.NOT_FINITE)
    for name in ("F_s", "F_u", "F_p", "F_c", "M_p", "M_u"):
        assert np.isnan(getattr(found, name)).all()
    with pytest.raises(ValueError, match="a result overflows"):
        ss.joint_reactions(robot, motion, backend=backend, bearing=1e308)


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_platform_too_far_away_overflows(backend) -> None:
    found = ss.inverse_dynamics(dasgupta(), at_rest([1e155] * 3), backend=backend, on_singular="nan")
    assert found.status == results.NOT_FINITE


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
def test_a_leg_of_length_zero_is_seen_wherever_the_base_stands(backend, base_joint: str) -> None:
    """Of S = q + t - b only rounding is left, of the size of the base's distance and not of the leg's."""
    rng = np.random.default_rng(7)
    robot = random_robot(rng, base_joint)
    poses = random_motion(rng, robot, (18,), load=False)
    for i in range(18):
        offset = 10 ** rng.uniform(-2, 4) * rng.uniform(-1, 1, 3)
        away, leg = dataclasses.replace(robot, b=robot.b + offset), i % 6
        pose = dataclasses.replace(poses[i], t=away.b[leg] - poses.R[i] @ robot.p[leg])
        found = ss.inverse_dynamics(away, pose, backend=backend, on_singular="nan")
        assert found.status == results.ZERO_LENGTH, offset


def test_inverse_dynamics_needs_accelerations() -> None:
    still = at_rest([0.1, 0, 0.5])
    with pytest.raises(ValueError, match="motion: expected accelerations"):
        ss.inverse_dynamics(dasgupta(), ss.Motion(still.R, still.t, still.omega, still.v))


def test_without_a_compiler_numpy_serves_and_says_so_once(monkeypatch) -> None:
    from stewart_sym.backend import c_kernel, native
    from stewart_sym.dynamics import inverse

    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(native, "_candidates", lambda: iter(()))
    c_kernel.library.cache_clear()
    inverse._say_once.cache_clear()
    robot, motion = dasgupta(), at_rest([0.1, 0, 0.5])
    with pytest.warns(RuntimeWarning, match="NumPy kernels serve"):
        first = ss.inverse_dynamics(robot, motion).F
    with warnings.catch_warnings(action="error"):
        second = ss.inverse_dynamics(robot, motion).F
    assert (first == second).all()
    assert (first == ss.inverse_dynamics(robot, motion, backend="numpy").F).all()
    c_kernel.library.cache_clear()
