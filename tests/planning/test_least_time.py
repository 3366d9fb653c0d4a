"""The fastest motion along a path and within limits of motors: against IPOPT and its own limits."""

import dataclasses

import numpy as np
import pytest
from command_line import rejects
from least_time_oracles import collocation_duration, extrapolated
from machines import machine_size
from motor_cases import motor_case
from smooth_oracles import motor_duration
from sweeps import share
from via_cases import limited_case, planned_case, straight, via_case

import stewart_sym as ss
from stewart_sym.drives.effort import drive_effort
from stewart_sym.planning.path_parameterization import parameterize_path
from stewart_sym.planning.plan_certificate import certify_plan
from stewart_sym.planning.timing.path_terms import PathLimits, terms_along


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


@pytest.mark.slow
def test_the_motion_in_time_has_the_rates_of_its_poses() -> None:
    robot, path = limited_case(5)
    plan = parameterize_path(robot, path, grid_size=100)
    times, h = np.linspace(0.05, 0.95, 41) * plan.duration, 1e-6 * plan.duration
    at, before, after = (plan.sample(times + shift) for shift in (0.0, -h, h))
    np.testing.assert_allclose(at.v, (after.t - before.t) / (2 * h), atol=1e-6 * np.abs(at.v).max())
    # Where s'' jumps between the two the difference is no acceleration.
    off = np.abs(at.a - (after.v - before.v) / (2 * h)).max(axis=-1)
    assert np.median(off) < 1e-5 * np.abs(at.a).max()
    ends = plan.sample([0.0, plan.duration])
    assert np.abs(ends.v).max() < 1e-9
    np.testing.assert_allclose(ends.t, path(np.array([0.0, 1.0])).t, atol=1e-9)


@pytest.mark.slow
def test_a_faster_motion_breaks_a_limit() -> None:
    robot, path = limited_case(0)
    plan = parameterize_path(robot, path, grid_size=50)
    phase = plan.profile.phase
    faster = phase._replace(x=phase.x * 1.001, first=phase.first * 1.001, last=phase.last * 1.001)
    quick = dataclasses.replace(plan, profile=type(plan.profile).of(faster))
    assert not certify_plan(quick).is_valid


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


@pytest.mark.parametrize(
    ("found", "words"),
    [
        (np.zeros((2, 6)), "path: expected a Motion, got ndarray"),
        (
            ss.Motion(R=np.eye(3), t=np.zeros((2, 3)), omega=np.zeros(3), v=np.zeros(3)),
            "path: expected motions with accel",
        ),
        (
            ss.Motion(
                R=np.eye(3), t=np.zeros(3), omega=np.zeros(3), v=np.zeros(3), alpha=np.zeros(3), a=np.zeros(3)
            ),
            "path: expected a motion of shape",
        ),
    ],
)
def test_a_path_that_gives_something_else_is_one_line(found: object, words: str) -> None:
    robot, _ = limited_case(0)
    rejects(words, parameterize_path, robot, lambda s: found)


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


@pytest.mark.full
@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::stewart_sym.drives.effort.DriveLimitWarning")
def test_motors_that_hold_the_machine_with_nearly_all_their_torque_move_it_as_fast_as_they_can() -> None:
    """Not slower than the motion of stronger motors played more slowly."""
    seed, jerk = 0, 1.0
    robot, path = motor_case(seed, ("torque",))
    quick = parameterize_path(robot, path, grid_size=50)
    if jerk:
        jerk *= 1e3 * machine_size(robot) / quick.duration**3
    motors = terms_along(robot, path, np.linspace(0.0, 1.0, 2001), PathLimits(), "exact").motors
    held = motors.at_rest()[:, :6].max(axis=0)
    weak = dataclasses.replace(robot.drive, torque_limit=1.02 * held * robot.drive.torque_limit)
    robot = dataclasses.replace(robot, drive=weak)
    plan = parameterize_path(robot, path, limits=PathLimits(jerk=jerk), grid_size=100)
    proof = certify_plan(plan)
    assert proof.is_valid
    assert proof.active_fraction > 0.5
    slow, times = 1.0, np.linspace(0.0, 1.0, 2001)
    while True:
        played = dataclasses.replace(quick, profile=quick.profile.slowed(slow))
        effort = drive_effort(robot, played.sample(times * played.duration), times * played.duration)
        if np.all(effort.peak_torque <= weak.torque_limit):
            break
        slow *= 0.9
    assert plan.duration < played.duration


@pytest.mark.slow
def test_a_motor_that_cannot_move_the_machine_slowly_is_named() -> None:
    robot, path = motor_case(1, ("torque",))
    drive = dataclasses.replace(robot.drive, torque_limit=0.3 * robot.drive.torque_limit)
    with pytest.raises(
        ValueError, match=r"limits: torque of the motor of leg \d is .* times its limit at rest"
    ):
        parameterize_path(dataclasses.replace(robot, drive=drive), path)
