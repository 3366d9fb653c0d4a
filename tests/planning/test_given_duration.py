"""Limits of jerk, least energy and least peak force in a duration: against IPOPT and simpler motions."""

import dataclasses
from functools import cache

import numpy as np
import pytest
from least_time_oracles import extrapolated
from smooth_oracles import peak_force, smooth_optimum
from sweeps import share
from via_cases import limited_case

from stewart_sym.drives.effort import drive_effort
from stewart_sym.dynamics.inverse_dynamics import inverse_dynamics
from stewart_sym.kinematics.clearance import joint_angles
from stewart_sym.kinematics.inverse_kinematics import inverse_kinematics
from stewart_sym.planning.path_parameterization import TimedPath, parameterize_path
from stewart_sym.planning.plan_certificate import certify_plan
from stewart_sym.planning.timing.path_terms import PathLimits, traveled
from stewart_sym.robot.drive import Drive

LONGER = 1.5
"""Durations over the least time."""


@cache
def case(seed: int):
    """A machine with limits of force, a path, and its least time."""
    robot, path = limited_case(seed)
    return robot, path, parameterize_path(robot, path, grid_size=100)


def jerk_of(seed: int) -> float:
    """A limit of jerk that slows the motion, m/s^3."""
    robot, _, quick = case(seed)
    legs = inverse_kinematics(robot, quick.sample(np.linspace(0.0, quick.duration, 999)))
    return float(np.abs(legs.L_ddot).max() / (0.1 * quick.duration))


def work(plan: TimedPath, motion=None) -> float:
    """Of the leg forces, J."""
    times = np.linspace(0.0, plan.duration, 8001)
    motion = plan.sample(times) if motion is None else motion
    F = inverse_dynamics(plan.robot, motion, backend="reference").F
    return float(np.trapezoid(np.sum(F * inverse_kinematics(plan.robot, motion).L_dot, axis=-1), times))


@pytest.mark.slow
def test_joint_angles_of_a_plan_are_held_against_their_limits_between_its_nodes() -> None:
    robot, path, _ = case(2)
    robot = dataclasses.replace(robot, home_position=path(np.zeros(1)).t[0])
    plan = parameterize_path(robot, path, grid_size=20)
    free = certify_plan(plan)
    dense = joint_angles(robot, plan.sample(np.linspace(0.0, plan.duration, 20_001)))
    nodes = joint_angles(robot, path(plan.profile.nodes.s))
    for side, end in enumerate(("base", "platform")):
        extreme, most_dense = getattr(free, f"{end}_angle"), getattr(dense, end).max(axis=0)
        assert np.all(extreme.value >= most_dense * (1.0 - 1e-12))
        np.testing.assert_allclose(extreme.value, most_dense, rtol=1e-6)
        at_nodes = getattr(nodes, end).max(axis=0)
        leg, limit = int(np.argmax(extreme.value / at_nodes)), np.full((6, 2), np.pi)
        for most, kept in ((extreme.value[leg], True), (at_nodes[leg], False)):
            limit[leg, side] = most
            limited = dataclasses.replace(robot, joint_angle_limit=limit)
            proof = certify_plan(dataclasses.replace(plan, robot=limited))
            assert (proof.angles_ok, proof.is_valid) == (kept, kept)
    assert certify_plan(dataclasses.replace(plan, robot=case(2)[0])).base_angle is None


def peak(plan: TimedPath) -> float:
    return float(
        np.abs(inverse_dynamics(plan.robot, plan.sample(np.linspace(0.0, plan.duration, 8001))).F).max()
    )


def simpler(plan: TimedPath, quick: TimedPath):
    """Of the same duration: the least-time motion slowed, and s = 10 x^3 - 15 x^4 + 6 x^5."""
    slow = dataclasses.replace(quick, profile=quick.profile.slowed(quick.duration / plan.duration))
    x = np.linspace(0.0, 1.0, 8001)
    s = x**3 * (10.0 - 15.0 * x + 6.0 * x**2)
    rate, second = 30.0 * (x * (1.0 - x)) ** 2, 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x)
    quintic = traveled(plan.path(s), rate / plan.duration, second / plan.duration**2)
    return slow.sample(x * slow.duration), quintic


@pytest.mark.slow
def test_least_time_within_jerk_is_that_of_collocation_and_begins_and_ends_without_acceleration() -> None:
    robot, path, quick = case(1)
    jerk = jerk_of(1)
    plan = parameterize_path(robot, path, limits=PathLimits(jerk=jerk))
    assert plan.duration > quick.duration
    assert plan.duration == pytest.approx(smooth_optimum(robot, plan, 200, jerk=jerk), rel=1e-3)
    proof = certify_plan(plan)
    assert proof.is_valid
    assert proof.max_utilization > 1.0 - 1e-3
    times = np.linspace(0.0, plan.duration, 40_001)
    seconds = inverse_kinematics(robot, plan.sample(times)).L_ddot
    found = np.abs(np.diff(seconds, axis=0)).max() / times[1]
    assert 0.99 * jerk < found <= (1.0 + 1e-6) * jerk
    assert np.abs(seconds[[0, -1]]).max() < 1e-9 * np.abs(seconds).max()
    faster = dataclasses.replace(plan, profile=plan.profile.slowed(1.001))
    assert not certify_plan(faster).is_valid


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(share(10, 10)))
def test_least_energy_is_that_of_collocation_and_below_that_of_simpler_motions(seed: int) -> None:
    robot, path, quick = case(seed)
    duration = LONGER * quick.duration
    plan = parameterize_path(robot, path, minimize="energy", duration=duration, grid_size=150)
    assert plan.duration == pytest.approx(duration, rel=1e-12)
    assert work(plan) == pytest.approx(smooth_optimum(robot, plan, 200, duration=duration), rel=1e-3)
    assert certify_plan(plan).is_valid
    for motion in simpler(plan, quick):
        assert work(plan) < 0.99 * work(plan, motion)


@pytest.mark.slow
def test_least_electrical_energy_has_friction_and_heat_of_windings_in_it() -> None:
    robot, path, quick = case(2)
    lead = 0.01 * float(np.linalg.norm(robot.b, axis=-1).mean())
    force, duration = robot.force_limit, LONGER * quick.duration
    drive = Drive(
        lead=lead,
        efficiency=0.8,
        backdrive_efficiency=0.7,
        screw_coulomb=0.02 * force,
        torque_constant=1e-3 * force * lead,
        resistance=1e-4 * force * lead / duration,
    )
    robot = dataclasses.replace(robot, drive=drive)
    plan = parameterize_path(robot, path, minimize="energy", duration=duration, grid_size=50)
    assert certify_plan(plan).is_valid
    x = np.linspace(0.0, 1.0, 8001) * duration

    def energy(motion) -> float:
        return float(drive_effort(robot, motion, x).energy.sum())

    own = energy(plan.sample(x))
    for motion in simpler(plan, quick):
        assert own < 0.995 * energy(motion)
    free = dataclasses.replace(robot, drive=dataclasses.replace(drive, resistance=0.0, efficiency=1.0))
    cold = parameterize_path(free, path, minimize="energy", duration=duration, grid_size=50)
    assert own < energy(cold.sample(x)) * (1.0 - 1e-4)
    # What is lost by an efficiency alone depends on the motion as well.
    robot = dataclasses.replace(
        free, C_u=0.0, C_p=0.0, C_s=0.0, drive=dataclasses.replace(drive, resistance=0.0)
    )
    worn = parameterize_path(robot, path, minimize="energy", duration=duration, grid_size=50)
    assert energy(worn.sample(x)) < 0.995 * min(energy(motion) for motion in simpler(worn, quick))


@pytest.mark.slow
def test_least_peak_force_is_that_of_collocation_and_below_that_of_simpler_motions() -> None:
    robot, path, quick = case(0)
    duration = 1.2 * quick.duration
    shown: list[str] = []

    def progress(text: str, share: float | None = None) -> None:
        shown.append(text)

    options = {"minimize": "peak_force", "duration": duration, "progress": progress}
    plan = parameterize_path(robot, path, grid_size=100, **options)
    tries = [text for text in shown if "least peak force, try " in text]
    assert len(set(tries)) > 3
    assert shown[-len(tries) :] == tries
    assert plan.duration == pytest.approx(duration, rel=1e-12)
    expected = extrapolated(lambda cells: peak_force(plan, cells), 100)
    assert peak(plan) == pytest.approx(expected, rel=1e-3)
    for motion in simpler(plan, quick):
        assert peak(plan) < np.abs(inverse_dynamics(robot, motion).F).max()
    assert certify_plan(plan).is_valid
