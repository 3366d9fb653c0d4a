"""Reduced kernels are the general one wherever the machine is as simple as they say, and cost less."""

import numpy as np
import pytest
from machines import random_motion, random_robot
from motion_fields import FIELDS, stacked
from reduced_machines import as_simple_as, at_rest
from sweeps import slow_but

import stewart_sym as ss
from stewart_sym.derive.mechanics.formulation import PAPER
from stewart_sym.derive.mechanics.reduced_models import (
    FIDELITIES,
    Fidelity,
    fidelity_kernel,
)

EPSILON = np.finfo(np.float64).eps
UNITS = 100
FAST = ("general", "slender", "massless_static")


@pytest.fixture(
    params=slow_but(FAST, FIDELITIES.values(), lambda level: level.name), ids=lambda level: level.name
)
def level(request: pytest.FixtureRequest) -> Fidelity:
    return request.param


@pytest.mark.filterwarnings("ignore::stewart_sym.robot.robot.RobotWarning")
def test_reduction_equals_the_general_kernel_where_the_machine_is_that_simple(level: Fidelity) -> None:
    rng = np.random.default_rng(11)
    for _ in range(3):
        robot = as_simple_as(random_robot(rng), level)
        motion = random_motion(rng, robot)
        same = motion if level.moving else at_rest(motion)
        found = ss.ForceKernel(robot, fidelity=level.name).forces(motion)
        expected = ss.inverse_dynamics(robot, same)
        size = max(np.abs(values).max() for values in (expected.F, expected.D, expected.x))
        condition = ss.condition_number(expected.H)
        assert np.abs(found - expected.F).max() <= UNITS * EPSILON * condition * size


def test_one_pose_and_batch_agree_to_the_last_bit(level: Fidelity) -> None:
    rng = np.random.default_rng(2)
    robot = random_robot(rng)
    poses = [random_motion(rng, robot) for _ in range(11)]
    kernel = ss.ForceKernel(robot, fidelity=level.name)
    batch = kernel.forces(stacked(poses))
    slot = kernel.single_pose()
    for pose, expected in zip(poses, batch, strict=True):
        slot.numbers[:] = np.concatenate([np.ravel(getattr(pose, name)) for name in FIELDS])
        assert slot.solve() == 0
        np.testing.assert_array_equal(slot.F, expected)


@pytest.mark.parametrize("name", ["slender", "point_masses", "massless", "slender_static", "massless_static"])
def test_spherical_base_joints_have_the_levels_that_know_no_universal_joint(name: str) -> None:
    rng = np.random.default_rng(4)
    robot = as_simple_as(random_robot(rng, "spherical"), FIDELITIES[name])
    motion = random_motion(rng, robot)
    same = at_rest(motion) if name.endswith("static") else motion
    expected = ss.inverse_dynamics(robot, same).F
    np.testing.assert_allclose(
        ss.ForceKernel(robot, fidelity=name).forces(motion),
        expected,
        rtol=1e-10,
        atol=1e-10 * np.abs(expected).max(),
    )


def test_what_there_is_not_is_rejected_in_one_line() -> None:
    rng = np.random.default_rng(0)
    with pytest.raises(ValueError, match=r"^fidelity: expected \"general\", .* got 'stiff'$"):
        ss.ForceKernel(random_robot(rng), fidelity="stiff")
    with pytest.raises(ValueError, match=r"^fidelity: expected \"general\", got 'slender'$"):
        ss.ForceKernel(random_robot(rng), "paper", fidelity="slender")
    with pytest.raises(ValueError, match=r"^fidelity: expected \"general\", .* got 'axisymmetric'$"):
        ss.ForceKernel(random_robot(rng, "spherical"), fidelity="axisymmetric")
    with pytest.raises(ValueError, match=r"^fidelity: slender is a reduction of exact, not of paper$"):
        fidelity_kernel(PAPER, FIDELITIES["slender"])
