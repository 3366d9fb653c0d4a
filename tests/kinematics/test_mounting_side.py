"""The platform's side of the base: the same machine in other axes gives the same answers there."""

import dataclasses
import warnings

import numpy as np
import pytest
from machines import (
    dasgupta,
    in_axes,
    machine_size,
    random_motion,
    random_robot,
)

import stewart_sym as ss
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.kinematics.mounting_side import path_for, platform_side

Z_DOWN = np.diag([1.0, -1.0, -1.0])
# Base and platform frames with the former z along x, y, -x and -y.
ON_ITS_SIDE = [
    np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]),
    np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]),
    np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
    np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]),
]


def standing(seed: int) -> ss.Robot:
    """A random machine that stands: its gravity pulls from the platform to the base."""
    rng = np.random.default_rng(seed)
    while True:
        robot = random_robot(rng)
        if robot.g[2] < -0.3 * np.linalg.norm(robot.g):
            return robot


@pytest.mark.parametrize("seed", range(3))
def test_home_and_default_pose_are_the_same_in_other_axes(seed: int) -> None:
    robot = standing(seed)
    home, size = home_pose(robot), machine_size(robot)
    motion = random_motion(np.random.default_rng(seed), robot, (10,))
    L = ss.inverse_kinematics(robot, motion).L
    pose = ss.forward_kinematics(robot, L)
    for Q in (Z_DOWN, *ON_ITS_SIDE):
        turned = in_axes(robot, Q)
        there = home_pose(turned)
        np.testing.assert_allclose(there.t, Q @ home.t, atol=1e-13 * size)
        np.testing.assert_allclose(there.L, home.L, rtol=1e-13)
        np.testing.assert_allclose(there.F, home.F, rtol=1e-9)
        np.testing.assert_allclose(ss.up_direction(turned), Q @ ss.up_direction(robot), atol=1e-13)
        found = ss.forward_kinematics(turned, L)
        np.testing.assert_allclose(found.R, Q @ pose.R @ Q.T, atol=1e-11)
        np.testing.assert_allclose(found.t, pose.t @ Q.T, atol=1e-11 * size)


def test_without_gravity_across_the_base_both_sides_are_named() -> None:
    robot = dasgupta()
    assert platform_side(robot).rule == "opposite to gravity"
    sides = (
        r"selected the side \(0, 0, 1\) of the base, although \(0, 0, -1\) is as plausible; "
        "give home_position"
    )
    L = ss.inverse_kinematics(
        robot, ss.Motion(R=np.eye(3), t=[0.0, 0.0, 0.5], omega=np.zeros(3), v=np.zeros(3))
    ).L
    flat = {"b": robot.b * [1.0, 1.0, 0.0]}
    for given, gravity in (
        ({"g": np.zeros(3)}, "0"),
        (flat | {"g": np.array([3.0, 9.0, -0.5])}, "parallel to the base"),
    ):
        other = dataclasses.replace(robot, **given)
        with pytest.warns(ss.AssemblyModeWarning, match=f"^robot: gravity is {gravity}; {sides}$"):
            home_pose(other)
        with pytest.warns(ss.AssemblyModeWarning, match=f"^robot: gravity is {gravity}; {sides}$"):
            ss.forward_kinematics(other, L, check_limits=False)
        with warnings.catch_warnings(action="error"):
            ss.forward_kinematics(other, L, (np.eye(3), [0.0, 0.0, 0.5]))


def test_a_stated_home_pose_settles_the_side_and_is_the_home_pose() -> None:
    """Gravity pulls the same way: the machine stands, and hangs."""
    robot = standing(0)
    middle = robot.b.mean(axis=0) - robot.p.mean(axis=0)
    for sign in (1.0, -1.0):
        place = middle + sign * np.array([0.0, 0.0, 1.2 * machine_size(robot)])
        stated = dataclasses.replace(robot, home_position=place)
        side = platform_side(stated)
        assert side.direction.tolist() == [0.0, 0.0, sign]
        assert side.certain
        home = home_pose(stated)
        np.testing.assert_array_equal(home.t, place)
        found = ss.forward_kinematics(stated, home.L)
        np.testing.assert_allclose(found.t, place, atol=1e-9 * machine_size(robot))
        path = path_for(stated, "I").path.sample([0.0]).t[0]
        assert np.sign(path[2]) == sign
