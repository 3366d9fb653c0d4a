"""The platform's side of the base: the same machine in other axes gives the same answers there."""

import csv
import dataclasses
import itertools
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from command_line import Run
from machines import (
    Array,
    dasgupta,
    in_axes,
    machine_size,
    path_period,
    random_motion,
    random_path,
    random_robot,
)
from robot_files import written
from sweeps import FULL

import stewart_sym as ss
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.kinematics.mounting import path_for, platform_side
from stewart_sym.motion.rotation import rpy_from_rotation
from stewart_sym.studies.common.output import csv_lines

SEEDS = 20 if FULL else 1

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


class Outcomes(NamedTuple):
    """What subcommands write of a machine and a motion: lines of text, and tables by name."""

    check: list[str]
    tables: dict[str, dict[str, Array]]
    estimates: list[list[str]]


@pytest.mark.parametrize(
    "seed", [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(1, SEEDS))]
)
def test_subcommands_give_the_mirrored_result_with_z_down(tmp_path: Path, run: Run, seed: int) -> None:
    robot = standing(seed)
    time = np.linspace(0.0, path_period(robot), 60)
    motion = random_path(np.random.default_rng(seed), robot, load=False)(time)
    up = outcomes(robot, time, motion, tmp_path / "up", run)
    down = outcomes(in_axes(robot, Z_DOWN), time, motion.in_rotated_frames(Z_DOWN), tmp_path / "down", run)
    assert len(up.check) == 3
    assert down.check == up.check
    for name, columns in up.tables.items():
        assert list(down.tables[name]) == list(columns)
        whole = {kind: max(np.abs(columns[each]).max() for each in group) for kind, group in kinds(columns)}
        for column, values in columns.items():
            np.testing.assert_allclose(
                turned(column) * down.tables[name][column],
                values,
                rtol=1e-6,
                atol=1e-8 * whole[kind_of(column)],
                err_msg=f"{name}: {column}",
            )
    for one, other in zip(up.estimates, down.estimates, strict=True):
        compare_estimates(one, other)


def outcomes(robot: ss.Robot, time: Array, motion: ss.Motion, folder: Path, run: Run) -> Outcomes:
    folder.mkdir()
    file = str(written(robot, folder / "robot.toml"))
    legs, poses, scene = (str(folder / name) for name in ("legs.csv", "poses.csv", "scene.toml"))
    theta = rpy_from_rotation(motion.R)
    found = ss.inverse_kinematics(robot, motion)
    lengths = {"L": found.L, "L_dot": found.L_dot, "L_ddot": found.L_ddot}
    write(Path(legs), {f"{n}_{i + 1}": x[:, i] for n, x in lengths.items() for i in range(6)}, time)
    parts = {"t": motion.t, "theta": theta}
    write(Path(poses), {f"{n}_{'xyz'[i]}": x[:, i] for n, x in parts.items() for i in range(3)}, time)
    F = ss.inverse_dynamics(robot, motion[0]).F.tolist()
    state = f"[state]\nt = {motion.t[0].tolist()}\ntheta = {theta[0].tolist()}\n"
    Path(scene).write_text(
        f'schema = 1\nrobot = "robot.toml"\nduration = {0.02 * time[-1]}\n{state}'
        f'[actuation]\ntype = "constant_force"\nforces = {F}\n'
    )
    small = ["--harmonics", "2", "--samples", "30", "--candidates", "2"]
    calls = {
        "forces.csv": ["forces", file, legs],
        "reactions.csv": ["forces", file, poses, "--reactions"],
        "along/path.csv": ["singularities", file, poses, "--no-plots"],
        "simulated/run.csv": ["simulate", scene, "--no-plots"],
        "excited/parameters.csv": ["identify", file, *small],
        "measured/parameters.csv": ["identify", file, "--measured", poses, str(folder / "reactions.csv")],
    }
    for name, call in calls.items():
        output = folder / name
        run(*call, "-o", output if output.parent == folder else output.parent)
    lines = run("check", file).out.splitlines()
    tables, estimates = {}, []
    for name in calls:
        text = (folder / name).read_text().splitlines()
        if name.endswith("parameters.csv"):
            estimates.append(text)
        else:
            values = np.array([[float(x) for x in line.split(",")] for line in text[1:]])
            tables[name] = dict(zip(text[0].split(","), values.T, strict=True))
    return Outcomes(
        [line for line in lines if line.startswith(("leg lengths", "condition", "holding"))],
        tables,
        estimates,
    )


def write(path: Path, columns: dict[str, Array], time: Array) -> None:
    path.write_text("".join(csv_lines({"time": time} | columns)))


def turned(column: str) -> float:
    """What half a turn about x makes of a column: components along y and z change their signs."""
    return -1.0 if column.endswith(("_y", "_z")) else 1.0


def kind_of(column: str) -> str:
    """A column's name without leg and component."""
    return column.rstrip("xyz").rstrip("_").rstrip("123456")


def kinds(columns: dict[str, Array]) -> Iterator[tuple[str, Iterator[str]]]:
    return itertools.groupby(sorted(columns, key=kind_of), kind_of)


def compare_estimates(one: list[str], other: list[str]) -> None:
    """Names and sizes agree; components along y and z of the platform's frame change their signs."""
    for row, mirrored in zip(csv.DictReader(one), csv.DictReader(other), strict=True):
        assert mirrored["name"] == row["name"]
        sign = -1.0 if row["name"] in ("h_P_y", "h_P_z", "J_P_xy", "J_P_xz") else 1.0
        value, sigma = float(row["estimated"]), float(row["std"])
        assert abs(sign * float(mirrored["estimated"]) - value) <= 1e-5 * (abs(value) + sigma)
        assert float(mirrored["std"]) == pytest.approx(sigma, rel=1e-5)


def test_gravity_settles_the_side_and_then_limits_and_then_the_condition() -> None:
    robot = dasgupta()
    assert platform_side(robot).rule == "against gravity"
    afloat = dataclasses.replace(robot, g=np.zeros(3))
    side = platform_side(afloat)
    assert side.rule == "gravity is 0, the side of smaller condition is taken"
    assert side.settled
    for direction in (1.0, -1.0):
        # Limits that the level platform keeps on one side only.
        L = ss.inverse_kinematics(
            robot, ss.Motion(R=np.eye(3), t=[0.0, 0.0, 0.5 * direction], omega=np.zeros(3), v=np.zeros(3))
        ).L
        limited = dataclasses.replace(afloat, length_limits=np.stack([L - 1e-2, L + 1e-2], axis=-1))
        found = platform_side(limited)
        assert found.rule == "gravity is 0, the side nearer to the length limits is taken"
        assert found.direction[2] == direction
    sideways = dataclasses.replace(robot, b=robot.b * [1.0, 1.0, 0.0], g=np.array([3.0, 9.0, -0.5]))
    assert platform_side(sideways).rule == "gravity is along the base, the side of smaller condition is taken"


def test_two_sides_as_plausible_as_each_other_are_both_named() -> None:
    flat = np.array([1.0, 1.0, 0.0])
    robot = dataclasses.replace(dasgupta(), b=dasgupta().b * flat, p=dasgupta().p * flat, g=np.zeros(3))
    text = r"robot: gravity is 0, the side \(0, 0, 1\) of the base is taken; \(0, 0, -1\) is as plausible"
    L = ss.inverse_kinematics(
        robot, ss.Motion(R=np.eye(3), t=[0.0, 0.0, 0.5], omega=np.zeros(3), v=np.zeros(3))
    ).L
    for call in (lambda: home_pose(robot), lambda: ss.forward_kinematics(robot, L)):
        with pytest.warns(ss.AssemblyModeWarning, match=f"^{text}$"):
            call()
    with warnings.catch_warnings(action="error"):
        ss.forward_kinematics(robot, L, (np.eye(3), [0.0, 0.0, 0.5]))


def test_a_stated_home_pose_settles_the_side_and_is_the_home_pose() -> None:
    """Gravity pulls the same way: the machine stands, and hangs."""
    robot = standing(0)
    middle = robot.b.mean(axis=0) - robot.p.mean(axis=0)
    for sign in (1.0, -1.0):
        place = middle + sign * np.array([0.0, 0.0, 1.2 * machine_size(robot)])
        stated = dataclasses.replace(robot, home_position=place)
        side = platform_side(stated)
        assert side.direction.tolist() == [0.0, 0.0, sign]
        assert (side.settled, side.by_gravity, side.certain) == (True, False, True)
        home = home_pose(stated)
        np.testing.assert_array_equal(home.t, place)
        found = ss.forward_kinematics(stated, home.L)
        np.testing.assert_allclose(found.t, place, atol=1e-9 * machine_size(robot))
        path = path_for(stated, "I").path.sample([0.0]).t[0]
        assert np.sign(path[2]) == sign
