"""Axis travel against closed forms, linear programs, capability polytopes, and its table in reports."""

import dataclasses
import json
import math
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from machines import in_axes, machine_size, random_robot, with_random_drives
from robot_files import HANGING
from scipy.optimize import brentq, linprog
from scipy.spatial.transform import Rotation

import stewart_sym as ss
from stewart_sym.design.axis_travel import AXES
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.motion.motion import at_rest
from stewart_sym.robot.offsets import SHAPES


def machine(seed: int, **limits: np.ndarray | float) -> ss.Robot:
    """A random machine with a tool, a home pose, and limits."""
    rng = np.random.default_rng(seed)
    robot = random_robot(rng)
    tool = machine_size(robot) * rng.uniform(-0.3, 0.3, 3)
    return dataclasses.replace(robot, tool=tool, home_position=home_pose(robot).t, **limits)


def displaced(robot: ss.Robot, axis: int, distance: float) -> np.ndarray:
    """Leg lengths, m, after a displacement of the tool along or about an axis."""
    twist = distance * np.eye(6)[axis]
    R = Rotation.from_rotvec(twist[3:]).as_matrix()
    t = robot.home_position + robot.tool + twist[:3] - R @ robot.tool
    return np.linalg.norm(robot.p @ R.T + t - robot.b, axis=-1)


def margin(distance: float, robot: ss.Robot, axis: int, sign: float) -> float:
    """Smallest distance, m, of a leg length from its limits; negative beyond them."""
    L = displaced(robot, axis, sign * distance)
    return float(np.min([L - robot.length_limits[:, 0], robot.length_limits[:, 1] - L]))


def test_travel_within_leg_lengths_is_the_first_root_of_a_leg() -> None:
    for seed in range(2):
        robot = machine(seed)
        L = displaced(robot, 0, 0.0)
        limits = L[:, None] * np.random.default_rng(seed).uniform([0.9, 1.05], [0.95, 1.1], (6, 2))
        robot = dataclasses.replace(robot, length_limits=limits)
        found = ss.axis_travel(robot)
        np.testing.assert_allclose(found.position, robot.home_position + robot.tool)
        for (axis, column), end in np.ndenumerate(found.travel):
            sign = (-1.0, 1.0)[column]
            assert found.limits[axis][column] == "leg_length"
            steps = np.linspace(0.0, 2.0 * abs(end), 200)
            first = int(np.argmax([margin(x, robot, axis, sign) < 0.0 for x in steps]))
            root = brentq(margin, steps[first - 1], steps[first], args=(robot, axis, sign))
            assert end == pytest.approx(sign * root, rel=1e-8)


def test_travel_without_limits_ends_where_the_determinant_is_zero() -> None:
    robot = machine(5)
    found = ss.axis_travel(robot)
    assert {cause for both in found.limits for cause in both} <= {"singularity", "assembly_mode", "none"}
    ends = [
        (axis, end)
        for (axis, column), end in np.ndenumerate(found.travel)
        if found.limits[axis][column] == "singularity"
    ]
    assert len(ends) > 4
    for axis, end in ends:
        twist = end * np.linspace(0.0, 1.0 + 1e-6, 3000)[1:, None] * np.eye(6)[axis]
        R = Rotation.from_rotvec(twist[:, 3:]).as_matrix()
        t = robot.home_position + robot.tool + twist[:, :3] - R @ robot.tool
        sides = np.sign(np.linalg.det(ss.wrench_matrix(robot, at_rest(R, t))))
        assert len(set(sides[:-1])) == 1
        assert sides[-1] == -sides[0]


def test_speeds_solve_a_linear_program() -> None:
    robot = machine(1, speed_limit=np.arange(1.0, 7.0))
    drive = ss.Drive(lead=np.linspace(0.01, 0.02, 6), speed_limit=np.linspace(2000.0, 900.0, 6))
    for limited in (robot, dataclasses.replace(robot, drive=drive)):
        most = limited.speed_limit
        if limited.drive is not None:
            most = np.minimum(most, drive.speed_limit * drive.lead / (2.0 * np.pi))
        speeds = ss.axis_travel(limited).speed
        for axis in range(6):
            rate = (displaced(robot, axis, 1e-5) - displaced(robot, axis, -1e-5)) / 2e-5
            program = linprog([-1.0], np.concatenate([rate, -rate])[:, None], np.tile(most, 2))
            assert speeds[axis] == pytest.approx(-program.fun, rel=1e-7)


def test_accelerations_are_those_of_the_capability_polytope() -> None:
    robot = machine(2)
    rest = at_rest(np.eye(3), robot.home_position)
    F = np.abs(ss.inverse_dynamics(robot, rest).F)
    robot = dataclasses.replace(robot, force_limit=F * np.linspace(1.2, 2.0, 6))
    found = ss.axis_travel(robot)
    for axis in range(6):
        quantity = "acceleration" if axis < 3 else "angular_acceleration"
        polytope = ss.capability_polytope(robot, rest, quantity)
        ends = [sign * polytope.max_along(sign * np.eye(3)[axis % 3]) for sign in (-1.0, 1.0)]
        np.testing.assert_allclose(found.acceleration[axis], ends, rtol=1e-9)


def test_motor_limits_are_used_up_at_the_extreme_accelerations() -> None:
    robot = with_random_drives(np.random.default_rng(3), machine(3))
    drive = dataclasses.replace(robot.drive, regularization_speed=0.0, torque_constant=1.0)
    home = robot.home_position + robot.tool
    for name in ("torque_limit", "current_limit"):
        at_home = ss.drive_effort(
            dataclasses.replace(robot, drive=drive), at_rest(np.eye(3), robot.home_position)
        )
        most = 10.0 * np.max(np.abs(at_home.torque))
        limited = dataclasses.replace(robot, drive=dataclasses.replace(drive, **{name: most}))
        found = ss.axis_travel(limited)
        for (axis, column), end in np.ndenumerate(found.acceleration):
            unit = np.eye(6)[axis]
            start = 1e-9 * (-1.0, 1.0)[column] * unit
            motion = ss.Motion(
                R=np.eye(3), t=home, omega=start[3:], v=start[:3], alpha=end * unit[3:], a=end * unit[:3]
            )
            torque = ss.drive_effort(limited, motion.at_point(-robot.tool)).torque
            assert np.max(np.abs(torque)) == pytest.approx(most, rel=1e-5)
        # A regularized sign is zero at rest, but friction opposes the beginning motion.
        regular = dataclasses.replace(limited.drive, regularization_speed=1e-3)
        again = ss.axis_travel(dataclasses.replace(limited, drive=regular))
        np.testing.assert_array_equal(again.acceleration, found.acceleration)


def test_missing_limits_are_infinite_and_a_home_pose_beyond_a_limit_has_no_travel() -> None:
    robot = machine(4)
    found = ss.axis_travel(robot)
    assert np.isinf(found.speed).all()
    assert np.isinf(found.acceleration).all()
    outside = dataclasses.replace(robot, length_limits=[1e-3, 2e-3], force_limit=1e-3)
    found = ss.axis_travel(outside)
    assert np.isnan(found.travel).all()
    assert np.isnan(found.acceleration).all()
    assert found.limits[0] == ("leg_length", "leg_length")
    limits = ss.PoseLimits(max_condition=5.0 * home_pose(robot).scaled_condition)
    assert "condition_number" in {cause for both in ss.axis_travel(robot, limits).limits for cause in both}


@pytest.mark.slow
def test_a_machine_with_z_down_and_zero_offsets_travels_as_the_same_machine() -> None:
    robot = machine(6, force_limit=1e6, speed_limit=1.0)
    L = displaced(robot, 0, 0.0)
    robot = dataclasses.replace(robot, length_limits=np.stack([0.9 * L, 1.1 * L], axis=-1))
    plain = ss.axis_travel(robot)
    half_turn = np.diag([1.0, -1.0, -1.0])
    down = dataclasses.replace(
        in_axes(robot, half_turn), tool=half_turn @ robot.tool, home_position=half_turn @ robot.home_position
    )
    turned = ss.axis_travel(down)
    for axis, sign in enumerate([1.0, -1.0, -1.0] * 2):
        expected = plain.travel[axis] if sign > 0.0 else -plain.travel[axis][::-1]
        np.testing.assert_allclose(turned.travel[axis], expected, rtol=1e-7)
    np.testing.assert_allclose(turned.speed, plain.speed)
    zeros = {name: np.zeros(shape) for name, shape in SHAPES.items() if name != "platform_axis"}
    offsets = ss.JointOffsets(**zeros, platform_joint="spherical")
    with_offsets = ss.axis_travel(dataclasses.replace(robot, offsets=offsets))
    np.testing.assert_allclose(with_offsets.travel, plain.travel, rtol=1e-7)
    np.testing.assert_allclose(with_offsets.acceleration, plain.acceleration, rtol=1e-7)


@pytest.mark.slow
def test_check_and_workspace_print_the_table_in_the_units_of_the_file(folder: Path, run: Run) -> None:
    (folder / "hanging.toml").write_text(HANGING)
    found = ss.axis_travel(ss.Robot.from_toml("hanging.toml"))
    few = ("workspace", "hanging.toml", "--samples", 200, "--no-plots")
    for command in (("check", "hanging.toml"), few):
        lines = run(*command, "--json", f"{command[0]}.json").out.splitlines()
        start = next(i for i, line in enumerate(lines) if line.startswith("axis travel:"))
        assert "(mm, deg, s)" in lines[start]
        rows = dict(zip(AXES, lines[start + 3 : start + 9], strict=True))
        for i, name in enumerate(AXES):
            assert rows[name].startswith(f"{name}, ")
            scale = 1e3 if i < 3 else math.degrees(1.0)
            assert all(f"{scale * end:.4g}" in rows[name] for end in found.travel[i])
            assert "no limit" in rows[name]
        data = json.loads((folder / f"{command[0]}.json").read_text())["axis_travel"]
        assert data["yaw"]["travel_rad"] == found.travel[5].tolist()
        assert data["surge"]["speed_m_per_s"] is None
        assert data["heave"]["limits"] == ["leg_length", "leg_length"]


def test_a_machine_that_is_singular_at_home_has_no_travel() -> None:
    angles = np.deg2rad(np.arange(0.0, 360.0, 60.0))
    hexagon = np.stack([np.cos(angles), np.sin(angles), np.zeros(6)], axis=1)
    robot = dataclasses.replace(
        machine(1), b=0.5 * hexagon, p=0.25 * hexagon, home_position=np.array([0.0, 0.0, 0.5])
    )
    found = ss.axis_travel(robot)
    assert np.isnan(found.travel).all()
    assert {cause for both in found.limits for cause in both} == {"singularity"}
