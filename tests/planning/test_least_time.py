"""The fastest motion along a path: against toppra, collocation by IPOPT, and its own limits."""

import dataclasses

import numpy as np
import pytest
from least_time_oracles import coefficients, collocation_duration, extrapolated, toppra_duration
from via_cases import limited_case, planned_case, straight, via_case

from stewart_sym.dynamics.inverse import inverse_dynamics
from stewart_sym.kinematics.inverse import inverse_kinematics
from stewart_sym.planning.certificate import certify_plan
from stewart_sym.planning.time_path import time_path
from stewart_sym.planning.timing.path_terms import Limits, terms_along


@pytest.mark.parametrize("seed", [1, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (6, 16, 30))])
def test_least_time_without_viscous_friction_is_that_of_toppra(seed: int) -> None:
    robot, path = limited_case(seed, friction=False)
    found = time_path(robot, path, cells=150).duration
    expected = extrapolated(lambda cells: toppra_duration(robot, path, robot.force_limit, cells), 150)
    assert found == pytest.approx(expected, rel=3e-4)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [0, 4, 10])
def test_least_time_with_viscous_friction_is_that_of_collocation(seed: int) -> None:
    robot, path = limited_case(seed)
    found = time_path(robot, path, cells=150)
    expected = extrapolated(lambda cells: collocation_duration(found, cells), 125)
    assert found.duration == pytest.approx(expected, rel=3e-4)


@pytest.mark.slow
def test_limits_hold_between_the_nodes_and_one_is_active() -> None:
    robot, path = planned_case(7)
    found = certify_plan(time_path(robot, path, cells=1000))
    assert found.instants >= 100_000
    assert found.used <= 1.0 + 1e-6
    assert found.active >= 0.99
    assert found.holds
    assert found.crossings == ()


def test_terms_are_those_of_the_vector_implementation() -> None:
    robot, poses = via_case(3)
    path, s = straight(robot, poses), np.linspace(0.0, 1.0, 11)
    found = terms_along(robot, path, s, Limits(force=1.0), "exact")
    for ours, theirs in zip((found.a, found.b, found.d, found.e), coefficients(robot, path, s), strict=True):
        np.testing.assert_allclose(ours, theirs, rtol=0.0, atol=1e-9 * np.abs(theirs).max())


@pytest.mark.slow
def test_all_kinds_of_limits_are_kept_in_time() -> None:
    robot, path = limited_case(4)
    free = time_path(robot, path, cells=100)
    legs = inverse_kinematics(robot, free.sample(np.linspace(0.0, free.duration, 2001)))
    motion = free.sample(np.linspace(0.0, free.duration, 2001))
    limits = Limits(
        speed=0.8 * np.abs(legs.L_dot).max(),
        acceleration=0.7 * np.abs(legs.L_ddot).max(),
        platform_speed=0.8 * float(np.linalg.norm(motion.v, axis=-1).max()),
        platform_turn_rate=0.8 * float(np.linalg.norm(motion.omega, axis=-1).max()),
    )
    plan = time_path(robot, path, limits=limits, cells=100)
    assert plan.duration > free.duration
    assert certify_plan(plan).used <= 1.0 + 1e-6
    motion = plan.sample(np.linspace(0.0, plan.duration, 20_001))
    legs = inverse_kinematics(robot, motion)
    assert np.abs(inverse_dynamics(robot, motion).F / robot.force_limit).max() <= 1.0 + 1e-6
    assert np.abs(legs.L_dot).max() <= limits.speed[0] * (1.0 + 1e-6)
    assert np.abs(legs.L_ddot).max() <= limits.acceleration[0] * (1.0 + 1e-6)
    assert np.linalg.norm(motion.v, axis=-1).max() <= limits.platform_speed * (1.0 + 1e-6)
    assert np.linalg.norm(motion.omega, axis=-1).max() <= limits.platform_turn_rate * (1.0 + 1e-6)


@pytest.mark.slow
def test_the_motion_in_time_has_the_rates_of_its_poses() -> None:
    robot, path = limited_case(5)
    plan = time_path(robot, path, cells=100)
    times, h = np.linspace(0.05, 0.95, 41) * plan.duration, 1e-6 * plan.duration
    at, before, after = (plan.sample(times + shift) for shift in (0.0, -h, h))
    np.testing.assert_allclose(at.v, (after.t - before.t) / (2 * h), atol=1e-6 * np.abs(at.v).max())
    # Where s'' jumps between the two the difference is no acceleration.
    off = np.abs(at.a - (after.v - before.v) / (2 * h)).max(axis=-1)
    assert np.median(off) < 1e-5 * np.abs(at.a).max()
    ends = plan.sample([0.0, plan.duration])
    assert np.abs(ends.v).max() < 1e-9
    np.testing.assert_allclose(ends.t, path(np.array([0.0, 1.0])).t, atol=1e-9)


def test_a_faster_motion_breaks_a_limit() -> None:
    robot, path = limited_case(0)
    plan = time_path(robot, path, cells=50)
    phase = plan.profile.phase
    faster = phase._replace(x=phase.x * 1.001, first=phase.first * 1.001, last=phase.last * 1.001)
    quick = dataclasses.replace(plan, profile=type(plan.profile).of(faster))
    assert not certify_plan(quick).holds


@pytest.mark.parametrize(
    ("limits", "message"),
    [
        (Limits(force=1e-3), "at rest at s ="),
        (Limits(force=np.inf), "expected a limit of force, speed or acceleration, there is none"),
    ],
)
def test_what_bounds_no_motion_or_allows_none_is_one_line(limits: Limits, message: str) -> None:
    robot, poses = via_case(1)
    with pytest.raises(ValueError, match=message) as error:
        time_path(robot, straight(robot, poses), limits=limits)
    assert "\n" not in str(error.value)
