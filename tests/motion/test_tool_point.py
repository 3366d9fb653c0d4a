"""Trajectories of a robot whose file states a tool point, an order of rotations or relative lengths."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from log_files import LENGTHS, NAMES, write
from machines import machine_in_motion
from motion_fields import motion_of, waves
from plain_logs import read_log
from robot_files import written

import stewart_sym as ss
from stewart_sym.kinematics.robot_logs import read_log_of
from stewart_sym.motion.rotation import rotation_about_axes

TOOL = np.array([0.1, -0.2, 0.4])
LOADS = [f"{name}_{axis}" for name in ("F_ext", "M_ext") for axis in "xyz"]


@pytest.fixture
def robot() -> ss.Robot:
    plain = ss.Robot.from_toml(Path(__file__).parents[2] / ".docs" / "examples" / "hexapod.toml")
    return dataclasses.replace(plain, tool=TOOL, home_position=np.array([0.0, 0.0, 0.65]))


RATES, TURNS = np.array([3.0, 2.0, 1.5]), np.array([0.1, 0.08, 0.12])


def waving(time: np.ndarray) -> ss.Motion:
    """A motion of the reference point."""
    size, phase = np.array([0.05, 0.04, 0.03, *TURNS]), np.repeat([0.0, 0.5 * np.pi], 3)
    return motion_of(waves(time, [0.0, 0.0, 0.65, 0.0, 0.0, 0.0], size, np.tile(RATES, 2), phase))


def tool_poses(time: np.ndarray) -> np.ndarray:
    """The same motion as rows of a log of the tool, (n, 6)."""
    return np.hstack([waving(time).at_point(TOOL).t, TURNS * np.cos(np.outer(time, RATES))])


def saved_poses(path: Path, time: np.ndarray, poses: np.ndarray) -> Path:
    return write(path, NAMES, np.column_stack([time, poses]))


def test_the_motion_of_another_point_has_the_rates_of_its_place() -> None:
    step = 1e-5
    at = waving(np.array([0.4 - step, 0.4, 0.4 + step])).at_point(TOOL)
    np.testing.assert_allclose((at.t[2] - at.t[0]) / (2 * step), at.v[1], atol=1e-9)
    np.testing.assert_allclose((at.v[2] - at.v[0]) / (2 * step), at.a[1], atol=1e-8)


def test_a_machine_named_by_another_reference_point_needs_the_same_forces() -> None:
    """Loads included: the wrench is that about the new point."""
    rng = np.random.default_rng(31)
    for _ in range(5):
        robot, motion = machine_in_motion(rng, (3,))
        other = dataclasses.replace(robot, p=robot.p - TOOL, R_0=robot.R_0 - TOOL)
        expected = ss.inverse_dynamics(robot, motion).F
        found = ss.inverse_dynamics(other, motion.at_point(TOOL)).F
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())


def test_rows_are_poses_of_the_tool(robot: ss.Robot, tmp_path: Path) -> None:
    time = np.linspace(0.0, 1.0, 201)
    motion = waving(time)
    path = saved_poses(tmp_path / "log.csv", time, tool_poses(time))
    for found in (read_log_of(robot, path), read_log_of(robot, path)):
        np.testing.assert_allclose(found.motion.t, motion.t, atol=1e-15)
        np.testing.assert_allclose(found.motion.a, motion.a, atol=1e-5)
        np.testing.assert_allclose(
            ss.interpolate(found)(0.5025).t, waving(np.array([0.5025])).t[0], atol=1e-9
        )
    plain = dataclasses.replace(robot, tool=np.zeros(3))
    np.testing.assert_array_equal(read_log_of(plain, path).motion.t, read_log(path).motion.t)


@pytest.mark.parametrize("moments", [True, False])
def test_a_load_beside_lengths_or_poses_acts_at_the_tool(
    robot: ss.Robot, tmp_path: Path, moments: bool
) -> None:
    time = np.linspace(0.0, 1.0, 21)
    poses, load = tool_poses(time), np.tile([100.0, -50.0, 20.0, 3.0, 4.0, 5.0], (21, 1))
    load, names = (load, LOADS) if moments else (load[:, :3], LOADS[:3])
    L = ss.inverse_kinematics(robot, waving(time)).L
    made = [
        read_log_of(robot, write(tmp_path / f"{name}.csv", [*head, *names], np.column_stack([time, x, load])))
        for name, head, x in (("poses", NAMES, poses), ("lengths", ["time", *LENGTHS], L))
    ]
    at = made[0].motion
    moment = np.cross(TOOL, load[:, :3]) + (load[:, 3:] if moments else 0.0)
    for found in (at, made[1]):
        np.testing.assert_allclose(found.F_ext, load[:, :3])
        np.testing.assert_allclose(found.M_ext, moment, atol=1e-9)


def test_deviations_of_forces_are_those_of_noise_at_the_tool(robot: ss.Robot, tmp_path: Path) -> None:
    """The same machine, its reference point at the tool, has them without a tool point."""
    rng = np.random.default_rng(32)
    time = np.linspace(0.0, 2.0, 201)
    noisy = tool_poses(time) + 1e-4 * rng.normal(size=(201, 6))
    path = saved_poses(tmp_path / "log.csv", time, noisy)
    there = dataclasses.replace(robot, p=robot.p - TOOL, R_0=robot.R_0 - TOOL, tool=np.zeros(3))
    with pytest.warns(ss.TrajectoryWarning):
        expected = ss.force_std(there, read_log_of(there, path))
    with pytest.warns(ss.TrajectoryWarning):
        found = ss.force_std(robot, read_log_of(robot, path))
    assert expected.min() > 0.0
    np.testing.assert_allclose(found, expected, rtol=1e-6)


def test_the_robot_file_says_in_which_order_rotations_are_multiplied(robot: ss.Robot, tmp_path: Path) -> None:
    theta = np.linspace([0.1, 0.2, -0.1], [0.2, -0.1, 0.3], 20)
    poses = np.hstack([np.tile([0.0, 0.0, 0.6], (20, 1)), theta])
    path = saved_poses(tmp_path / "log.csv", np.linspace(0.0, 1.0, 20), poses)
    own = dataclasses.replace(robot, trajectory_format=ss.TrajectoryFormat(euler_order="xyz"))
    for form in (ss.TrajectoryFormat(), ss.TrajectoryFormat(angle_unit="rad")):
        found = read_log_of(own, path, form).motion.R
        np.testing.assert_allclose(found, rotation_about_axes(theta, "xyz"), atol=1e-14)
    stated = read_log_of(own, path, ss.TrajectoryFormat(euler_order="zyx"))
    np.testing.assert_allclose(stated.motion.R, rotation_about_axes(theta, "zyx"), atol=1e-14)


@pytest.mark.parametrize("order", ["zyx", "xyz"])
def test_the_motion_that_identify_writes_is_read_as_the_robot_says(
    order: str, robot: ss.Robot, tmp_path: Path, run: Run
) -> None:
    own = dataclasses.replace(robot, trajectory_format=ss.TrajectoryFormat(euler_order=order))
    file = str(written(own, tmp_path / "robot.toml"))
    out = [str(tmp_path / "out" / name) for name in ("trajectory.csv", "forces.csv")]
    options = ["--force-std", "1", "--samples", "80", "--candidates", "2", "-o", str(tmp_path / "out")]
    run("identify", file, *options)
    poses = read_log_of(ss.Robot.from_toml(file), out[0])
    L = ss.inverse_kinematics(robot, poses.motion).L
    assert np.all((L >= robot.length_limits[:, 0]) & (L <= robot.length_limits[:, 1]))
    told = run("identify", file, "--force-std", "1", "-o", tmp_path / "again", "--measured", *out).out
    assert "verdict: consistent" in told
