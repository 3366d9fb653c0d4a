"""Kinematics of machines with offset joints: rates, poses of lengths and of motors' angles."""

import numpy as np
import pytest
from command_line import rejects
from machines import PLATFORM_JOINTS, machine_size, offset_case, path_period, random_path

import stewart_sym as ss


@pytest.mark.parametrize("joint", PLATFORM_JOINTS)
def test_rates_are_derivatives_along_a_path(joint: str) -> None:
    robot, _ = offset_case(0, joint, screws=True)
    path, h = random_path(np.random.default_rng(0), robot), 1e-5 * path_period(robot)
    before, now, after = (path(np.array([0.3 * path_period(robot) + step])) for step in (-h, 0.0, h))
    for function, name, rate in (
        (ss.inverse_kinematics, "L", "L_dot"),
        (ss.inverse_kinematics, "L_dot", "L_ddot"),
        (ss.motor_angles, "angle", "rate"),
        (ss.motor_angles, "rate", "acceleration"),
    ):
        one, other = (getattr(function(robot, at), name) for at in (after, before))
        wanted = getattr(function(robot, now), rate)
        np.testing.assert_allclose((one - other) / (2 * h), wanted, rtol=0, atol=1e-6 * np.abs(wanted).max())
    one, other = (ss.wrench_matrix(robot, at) for at in (after, before))
    wanted = ss.wrench_matrix_rate(robot, now)
    np.testing.assert_allclose((one - other) / (2 * h), wanted, rtol=0, atol=1e-6 * np.abs(wanted).max())


@pytest.mark.parametrize("joint", PLATFORM_JOINTS)
def test_poses_come_back_from_lengths_and_from_motors(joint: str) -> None:
    for seed in range(3):
        robot, motion = offset_case(seed, joint, (3,), screws=True)
        size = machine_size(robot)
        legs = ss.inverse_kinematics(robot, motion)
        near = (motion.R, motion.t + 0.02 * size)
        found = ss.forward_kinematics(robot, legs.L, guess=near)
        np.testing.assert_allclose(found.R, motion.R, atol=1e-12)
        np.testing.assert_allclose(found.t, motion.t, atol=1e-12 * size)
        first = ss.forward_kinematics(robot, legs.L)
        lengths = ss.inverse_kinematics(
            robot, ss.Motion(R=first.R, t=first.t, omega=0 * first.t, v=0 * first.t)
        ).L
        np.testing.assert_allclose(lengths, legs.L, atol=1e-12 * size)
        angle = ss.motor_angles(robot, motion, reference_length=0.9 * legs.L[0]).angle
        R, t = ss.pose_from_motor_angles(robot, angle, near, reference_length=0.9 * legs.L[0])
        np.testing.assert_allclose(R, motion.R, atol=1e-11)
        np.testing.assert_allclose(t, motion.t, atol=1e-11 * size)


@pytest.mark.parametrize("joint", PLATFORM_JOINTS)
def test_velocities_and_accelerations_come_back(joint: str) -> None:
    robot, motion = offset_case(3, joint, (4,))
    legs = ss.inverse_kinematics(robot, motion)
    found = ss.forward_velocity(robot, motion.R, motion.t, legs.L_dot)
    np.testing.assert_allclose(found.v, motion.v, rtol=1e-10)
    np.testing.assert_allclose(found.omega, motion.omega, rtol=1e-10)
    second = ss.forward_acceleration(robot, motion.R, motion.t, motion.v, motion.omega, legs.L_ddot)
    np.testing.assert_allclose(second.a, motion.a, rtol=1e-9)
    np.testing.assert_allclose(second.alpha, motion.alpha, rtol=1e-9)


def test_what_cannot_be_found_is_said() -> None:
    robot, motion = offset_case(0, screws=True)
    with pytest.raises(ValueError, match="L: "):
        ss.forward_kinematics(robot, np.full(6, 50 * machine_size(robot)), guess=(motion.R, motion.t))
    without, motion = offset_case(0)
    rejects("drive: expected a drive with a lead", ss.motor_angles, without, motion)
    rejects("angle: no pose", ss.pose_from_motor_angles, robot, np.full(6, 1e5), (motion.R, motion.t))
