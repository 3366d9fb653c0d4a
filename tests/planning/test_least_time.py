"""The fastest motion along a path and within limits of motors: against IPOPT and its own limits."""

import dataclasses

import numpy as np
import pytest
from command_line import rejects
from least_time_oracles import collocation_duration, extrapolated
from motor_cases import motor_case
from smooth_oracles import motor_duration
from sweeps import share
from via_cases import limited_case, planned_case, straight, via_case

from stewart_sym.drives.effort import drive_effort
from stewart_sym.planning.path_parameterization import parameterize_path
from stewart_sym.planning.plan_certificate import certify_plan
from stewart_sym.planning.timing.path_terms import PathLimits


@pytest.mark.parametrize(
    ("seed", "friction"),
    [
        (1, False),
        *(pytest.param(seed, False, marks=pytest.mark.slow) for seed in (6,)),
        *(pytest.param(seed, True, marks=pytest.mark.slow) for seed in (0,)),
    ],
)
def test_least_time_is_that_of_collocation_with_viscous_friction_or_none(seed: int, friction: bool) -> None:
    robot, path = limited_case(seed, friction=friction)
    found = parameterize_path(robot, path, grid_size=150)
    expected = extrapolated(lambda cells: collocation_duration(found, cells), 125)
    assert found.duration == pytest.approx(expected, rel=3e-4)


@pytest.mark.slow
def test_limits_hold_between_the_nodes_and_one_is_active() -> None:
    robot, path = planned_case(7)
    found = certify_plan(parameterize_path(robot, path, grid_size=1000))
    assert found.samples >= 100_000
    assert found.max_utilization <= 1.0 + 1e-6
    assert found.active_fraction >= 0.99
    assert found.is_valid
    assert found.crossings == ()


@pytest.mark.parametrize(
    ("limits", "message"),
    [
        (PathLimits(force=1e-3), "at rest at s ="),
        (PathLimits(force=np.inf), "expected a limit of force, speed, or acceleration, got none"),
    ],
)
def test_what_bounds_no_motion_or_allows_none_is_one_line(limits: PathLimits, message: str) -> None:
    robot, poses = via_case(1)
    rejects(message, parameterize_path, robot, straight(robot, poses), limits=limits)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(share(10, 10)))
def test_least_time_within_the_motors_limits_is_that_of_collocation(seed: int) -> None:
    robot, path = motor_case(seed)
    found = parameterize_path(robot, path, grid_size=100)
    expected = extrapolated(lambda cells: motor_duration(found, cells), 125)
    assert found.duration == pytest.approx(expected, rel=1e-3)


@pytest.mark.slow
def test_each_limit_of_the_motors_is_reached_and_kept_between_the_nodes() -> None:
    quantity = "power"
    robot, path = motor_case(1, (quantity,))
    plan = parameterize_path(robot, path, grid_size=100)
    proof = certify_plan(plan)
    assert proof.max_utilization <= 1.0 + 1e-6
    assert proof.active_fraction >= 0.95
    # At rest itself there is no friction, but the acceleration of the motion.
    times = np.linspace(0.0, plan.duration, 4001)[1:-1]
    found = drive_effort(robot, plan.sample(times), times)
    share = getattr(found, f"peak_{quantity}") / getattr(robot.drive, f"{quantity}_limit")
    assert 1.0 - 5e-3 < share.max() <= 1.0 + 1e-6


@pytest.mark.slow
def test_a_motor_that_cannot_move_the_machine_slowly_is_named() -> None:
    robot, path = motor_case(1, ("torque",))
    drive = dataclasses.replace(robot.drive, torque_limit=0.3 * robot.drive.torque_limit)
    with pytest.raises(
        ValueError, match=r"limits: torque of the motor of leg \d is .* times its limit at rest"
    ):
        parameterize_path(dataclasses.replace(robot, drive=drive), path)
