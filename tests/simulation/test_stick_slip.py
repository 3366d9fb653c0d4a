"""Dry friction in a simulation: legs stick without creep, and what is lost is what friction took."""

import dataclasses
import tomllib

import numpy as np
import pytest
from robot_files import PRESS

import stewart_sym as ss
from stewart_sym.motion.motion import at_rest
from stewart_sym.simulation.actuator_models import ForceLaw

DRIVE = ss.Drive(
    **{"lead": 5e-3, "efficiency": 0.9, "backdrive_efficiency": 0.8},
    **{"screw_coulomb": 20.0, "screw_viscous": 50.0, "stribeck_force": 10.0, "stribeck_speed": 5e-3},
)
HOME = ss.Motion(R=np.eye(3), t=np.array([0.0, 0.0, 0.7]), omega=np.zeros(3), v=np.zeros(3))


@pytest.fixture(scope="module")
def bare() -> ss.Robot:
    """A machine whose joints have no friction, nor its drives."""
    return ss.Robot.from_dict(tomllib.loads(PRESS))


@pytest.fixture(scope="module")
def robot(bare: ss.Robot) -> ss.Robot:
    return dataclasses.replace(bare, drive=DRIVE)


@pytest.fixture(scope="module")
def holding(bare: ss.Robot) -> np.ndarray:
    return ss.inverse_dynamics(bare, at_rest(HOME.R, HOME.t)).F


def swinging(bare: ss.Robot) -> ForceLaw:
    """Springs and dampers between the motors and places that swing."""
    springs = ss.LegSprings.in_equilibrium(bare, at_rest(HOME.R, HOME.t), 2e4, 600.0)
    return lambda time, state: springs(time, state) + 200.0 * np.sin(6.0 * time + np.arange(6))


def test_a_machine_at_rest_under_load_does_not_creep(robot: ss.Robot, holding: np.ndarray) -> None:
    load = {"F_ext": np.array([5.0, -3.0, -40.0]), "M_ext": np.array([0.5, 0.2, 1.0])}
    start = dataclasses.replace(HOME, **load)
    found = ss.simulate(robot, start, lambda time, state: holding + 8.0 * np.sin(3.0 * time), 10.0)
    assert found.stop.reason == "completed"
    for drift in (np.ptp(found.t, axis=0), np.ptp(found.R, axis=0), np.ptp(found.L, axis=0)):
        assert not drift.any()
    assert not found.v.any()
    assert not found.omega.any()
    assert found.drive_work.sticks.all()
    assert not found.drive_work.lost.any()
    assert (np.ptp(found.drive_work.friction, axis=0) > 5.0).all()


def test_a_leg_breaks_away_where_friction_can_hold_no_more(robot: ss.Robot, holding: np.ndarray) -> None:
    rate = 100.0
    share = np.where(holding > 0.0, 1.0 / 0.9 - 1.0, 1.0 - 0.8)
    expected = (30.0 + share * np.abs(holding)) / rate
    found = ss.simulate(robot, HOME, lambda time, state: holding + rate * time, 1.02 * expected.min())
    breaks = found.time[np.argmin(found.drive_work.sticks, axis=0)]
    # The machine is symmetric: all six of them at once.
    np.testing.assert_allclose(breaks, expected.min(), rtol=1e-9)
    assert (found.L[-1] > found.L[0]).all()


@pytest.mark.parametrize("rotor_inertia", [0.0, pytest.param(2e-5, marks=pytest.mark.slow)])
def test_energy_is_work_less_what_friction_took(bare: ss.Robot, rotor_inertia: float) -> None:
    robot = dataclasses.replace(bare, drive=dataclasses.replace(DRIVE, rotor_inertia=rotor_inertia))
    found = ss.simulate(robot, HOME, swinging(bare), 0.1, rtol=1e-10)
    work = found.drive_work
    assert np.abs(np.diff(work.sticks.astype(int), axis=0)).sum() >= 3
    assert (work.lost > 0.0).any()
    gained = found.energy[-1] - found.energy[0]
    assert work.done.sum() - gained == pytest.approx(work.lost.sum(), rel=1e-8)
    for leg in range(6):
        ends = np.flatnonzero(np.diff(np.concatenate([[0], work.sticks[:, leg], [0]]))).reshape(-1, 2)
        assert all(np.ptp(found.L[start : end - 1, leg]) < 1e-12 for start, end in ends if end - start > 1)


def test_the_motors_of_a_simulated_motion_are_those_of_inverse_dynamics(bare: ss.Robot) -> None:
    robot = dataclasses.replace(
        bare, drive=dataclasses.replace(DRIVE, rotor_inertia=2e-5, backdrive_efficiency=0.7)
    )
    law = swinging(bare)
    times, h = np.array([0.03, 0.04]), 1e-5
    found = ss.simulate(robot, HOME, law, 0.041, rtol=1e-11)
    at, after, before = (found.at(times + shift) for shift in (0.0, h, -h))
    a, alpha = ((getattr(after, name) - getattr(before, name)) / (2 * h) for name in ("v", "omega"))
    motion = ss.Motion(R=at.R, t=at.t, omega=at.omega, v=at.v, alpha=alpha, a=a)
    slips = np.abs(ss.inverse_kinematics(robot, motion).L_dot) > 1e-3
    motors = np.array([law(time, at.motion[i]) for i, time in enumerate(times)])
    assert slips.sum() >= 6
    np.testing.assert_allclose(ss.drive_effort(robot, motion).force[slips], motors[slips], atol=0.01)


@pytest.mark.slow
def test_forces_held_between_samples_stick_as_well(bare: ss.Robot, robot: ss.Robot) -> None:
    law = swinging(bare)
    held = ss.simulate(robot, HOME, law, 0.1, control_rate=400.0)
    free = ss.simulate(robot, HOME, law, 0.1)
    assert held.drive_work.sticks.any()
    np.testing.assert_allclose(held.L[-1], free.L[-1], atol=2e-4)
    assert held.drive_work.done.sum() - np.diff(held.energy[[0, -1]])[0] == pytest.approx(
        held.drive_work.lost.sum(), rel=1e-6
    )


def test_a_drive_without_losses_changes_nothing(bare: ss.Robot, holding: np.ndarray) -> None:
    plain = dataclasses.replace(bare, drive=ss.Drive(lead=5e-3))
    one, other = (ss.simulate(each, HOME, holding + 1.0, 0.05) for each in (bare, plain))
    np.testing.assert_array_equal(one.t, other.t)
    assert other.drive_work is None


def test_a_screw_that_locks_itself_is_rejected(bare: ss.Robot, holding: np.ndarray) -> None:
    locked = dataclasses.replace(bare, drive=ss.Drive(lead=5e-3, efficiency=0.4, backdrive_efficiency=-0.2))
    with pytest.raises(
        ValueError, match="leg 1: backdrive_efficiency: expected a number > 0 in a simulation"
    ):
        ss.simulate(locked, HOME, holding, 0.1)


def test_offsets_beside_friction_of_the_drives_are_named(robot: ss.Robot) -> None:
    both = dataclasses.replace(robot, offsets=ss.JointOffsets(axis_offset=0.01))
    with pytest.raises(ValueError, match="expected joint offsets or drive friction, got both"):
        ss.simulate(both, HOME, np.zeros(6), 0.01)
