"""The closed form's kernels in C and NumPy: equal to each other, to 50 digits and to inverse dynamics."""

import dataclasses
import functools

import numpy as np
import pytest
from command_line import rejects
from fifty_digits import as_stored
from leaning_legs import leaning
from machines import dasgupta, machine_in_motion, random_motion, random_robot
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.calls.c_kernel import CKernel
from stewart_sym.dynamics.forward_dynamics import ForwardDynamics, closed_form_of
from stewart_sym.generated.interface import OUTPUTS
from stewart_sym.kit.interpreter import KitInterpreter
from stewart_sym.motion.motion import Motion
from stewart_sym.results import JOINT_SINGULAR, MASS_MATRIX_INDEFINITE, OK, SINGULAR
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.robustness.oracle import CLOSED

Array = NDArray[np.float64]
EPSILON = np.finfo(np.float64).eps
FORCED = ("forward_dynamics", "linearization")


def forces(robot: Robot, motion: Motion) -> Array:
    return ss.inverse_dynamics(robot, motion).F


def check_bits(robot: Robot, motion: Motion) -> set[int]:
    """Every output of C and of NumPy, and the statuses, are the same numbers; the statuses."""
    F = ss.ForceKernel(robot).forces_and_status(motion)[0]
    F = np.where(np.isfinite(F), F, 1.0)
    of_c, of_numpy = (closed_form_of(robot, "exact", backend) for backend in ("c", "numpy"))
    assert of_c is not None
    assert of_numpy is not None
    seen = set()
    for what in CLOSED:
        expected, found = (kind.run(what, motion, *[F][: what in FORCED]) for kind in (of_c, of_numpy))
        for name in ("status", *OUTPUTS[what]):
            np.testing.assert_array_equal(found[name], expected[name], f"{what}: {name}")
        seen |= set(expected["status"].ravel().tolist())
    return seen


@pytest.mark.slow
@pytest.mark.usefixtures("rounded_twice")
def test_numpy_has_the_bits_of_the_c_batch_near_joint_singularities() -> None:
    rng = np.random.default_rng(17)
    robot, motion = machine_in_motion(rng)
    seen = [check_bits(leaning(robot, motion, sine), motion) for sine in (0.12, 0.015, 1e-5, 1e-10, 0.0)]
    assert seen == [*[{0}] * 4, {JOINT_SINGULAR}]


@pytest.mark.usefixtures("rounded_twice")
def test_numpy_has_the_bits_of_the_c_batch_with_long_arms_and_unlike_inertias() -> None:
    rng = np.random.default_rng(18)
    seen = set()
    for heavy, light in ((1e9, 1e-9), (1e-6, 1e7), (1e30, 1e-300)):
        robot = random_robot(rng, scale=300.0)
        unlike = dataclasses.replace(robot, m_u=heavy * robot.m_u, I_u0=heavy * robot.I_u0, M=light * robot.M)
        seen |= check_bits(
            dataclasses.replace(unlike, I_p=light * robot.I_p), random_motion(rng, robot, (2,))
        )
    assert 0 in seen


@pytest.mark.usefixtures("rounded_twice")
def test_numpy_has_the_statuses_of_the_c_batch_where_h_is_singular() -> None:
    rng = np.random.default_rng(19)
    robot = random_robot(rng)
    flat = dataclasses.replace(robot, b=robot.b * [1.0, 0.0, 0.0])
    assert SINGULAR in check_bits(flat, random_motion(rng, robot, (5,)))


@functools.cache
def at_50_digits(seed: int) -> tuple[Robot, Motion, dict[str, Array]]:
    """A machine, a motion, its equations, forces and their derivatives, rounded once.

    ``tests/kit/test_vectors.py`` compares them with inverse dynamics and differences of forward dynamics.
    """
    rng = np.random.default_rng(seed)
    robot = dasgupta() if seed == 0 else random_robot(rng)
    motion = random_motion(rng, robot)
    numbers, at = as_stored(robot, motion)
    run = KitInterpreter(numbers, "universal")
    found = run.found("equations", at) | run.derivatives(at)
    return robot, motion, {name: each.astype(float) for name, each in found.items()}


@pytest.mark.parametrize("seed", range(2))
def test_equations_agree_with_50_digits_to_rounding(seed: int) -> None:
    robot, motion, true = at_50_digits(seed)
    found = CKernel(robot, "exact", "_motion").run("equations", motion)
    for name in ("M", "C", "g", "friction", "H", "H_dot"):
        expected = true[name].reshape(found[name].shape)
        scale = max(np.abs(expected).max(), 1e-12)
        assert np.abs(found[name] - expected).max() <= 400 * EPSILON * scale, name


@pytest.mark.parametrize("seed", range(2))
def test_derivatives_of_the_forces_agree_with_50_digits(seed: int) -> None:
    robot, motion, true = at_50_digits(seed)
    found = ss.force_derivatives(robot, motion)
    for name in ("F", "by_pose", "by_twist", "by_acceleration"):
        expected = true[name].reshape(getattr(found, name).shape)
        assert np.abs(getattr(found, name) - expected).max() <= 1e-9 * np.abs(expected).max(), name


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_inertias_of_no_body_have_a_status_of_their_own(backend: str) -> None:
    rng = np.random.default_rng(12)
    robot = random_robot(rng)
    heavy = -50.0 * np.abs(robot.I_p).max() * np.eye(3) - 10 * robot.M * np.eye(3)
    impossible = dataclasses.replace(robot, I_p=heavy)
    motion = random_motion(rng, robot)
    rejects("not positive definite", ss.forward_dynamics, impossible, motion, np.zeros(6), backend=backend)
    kernel = closed_form_of(impossible, "exact", backend)
    assert kernel is not None
    assert kernel.run("forward_dynamics", motion, np.zeros(6))["status"] == MASS_MATRIX_INDEFINITE


def test_one_state_gives_what_the_batch_gives() -> None:
    robot, motion = machine_in_motion(13)
    F = forces(robot, motion)
    acceleration, status = ForwardDynamics(robot).one_state()(motion, F)
    assert status == OK
    np.testing.assert_array_equal(acceleration, np.concatenate(ss.forward_dynamics(robot, motion, F)))
