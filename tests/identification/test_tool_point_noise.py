"""Poses of a tool point with noise: the estimate is that of the machine, with deviations that hold."""

import dataclasses

import numpy as np
import pytest

import stewart_sym as ss
from stewart_sym.identification.tool_point import about_reference
from stewart_sym.motion.rotation import rotation_from_vector
from stewart_sym.motion.trajectory import Trajectory
from stewart_sym.robot.robot import about_point
from stewart_sym.studies.reports.identify import from_measurement

TOOL = np.array([0.1, -0.2, 0.6])


@pytest.fixture(scope="module")
def robot() -> ss.Robot:
    return dataclasses.replace(ss.robots.dasgupta1998(), tool=TOOL)


@pytest.fixture(scope="module")
def excited(robot: ss.Robot) -> ss.Excitation:
    return ss.choose_excitation(robot, samples=120, candidates=5)


def test_exact_forces_give_the_parameters_about_either_point(robot: ss.Robot, excited: ss.Excitation) -> None:
    F = ss.inverse_dynamics(robot, excited.motion).F
    moved = about_point(robot, TOOL)
    motion = excited.motion.at_point(TOOL)
    np.testing.assert_allclose(ss.inverse_dynamics(moved, motion).F, F, rtol=1e-9, atol=1e-9)
    found = ss.identify(moved, motion, F, 1e-6, ss.base_parameters(moved))
    back = about_reference(robot, excited.base, found, TOOL)
    right = excited.base.matrix @ ss.inertial_parameters(robot).values
    np.testing.assert_allclose(back.values, right, atol=1e-6 * np.abs(right).max())
    direct = ss.identify(robot, excited.motion, F, 1e-6, excited.base)
    np.testing.assert_allclose(back.std, direct.std, rtol=1e-5)


@pytest.mark.slow
def test_noisy_poses_of_the_tool_are_taken_as_measured(robot: ss.Robot, excited: ss.Excitation) -> None:
    rng = np.random.default_rng(3)
    sigma, position, angle = 0.5, 2e-5, 2e-5
    exact = excited.motion.at_point(TOOL)
    R = rotation_from_vector(angle * rng.normal(size=(120, 3))) @ exact.R
    measured = ss.Motion(R=R, t=exact.t + position * rng.normal(size=(120, 3)), omega=exact.omega, v=exact.v)
    F = ss.inverse_dynamics(robot, excited.motion).F + sigma * rng.normal(size=(120, 6))
    noise = ss.PoseNoise(excited.time, position, angle, excited.path.period)
    trajectory = Trajectory(excited.time, measured.at_point(-TOOL), "log.csv", tuple(range(2, 122)))
    found = from_measurement(robot, trajectory, excited.time, F, sigma, "F.csv", noise)
    assert found.verdict == "consistent", found.warnings
    off = (found.values - found.base.matrix @ ss.inertial_parameters(robot).values) / found.std
    assert np.abs(off).max() < 4.5
    assert 0.75 < np.sqrt(np.mean(off**2)) < 1.25
    assert found.compare_with(robot)[1] > 1e-3
