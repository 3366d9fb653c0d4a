"""The platform's side of the base: the same machine in other axes gives the same answers there."""

import dataclasses
import warnings
from pathlib import Path

import numpy as np
import pytest
from machines import dasgupta, machine_size, path_period, random_motion, random_path, random_robot
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.cli import main
from stewart_sym.home import home_pose
from stewart_sym.mounting import platform_side, upright
from stewart_sym.studies.output import csv_lines

Array = NDArray[np.float64]

Z_DOWN = np.diag([1.0, -1.0, -1.0])
# Base and platform frames with the former z along x, y, -x and -y.
ON_ITS_SIDE = [
    np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]),
    np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]),
    np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
    np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]),
]


def in_axes(robot: ss.Robot, Q: Array) -> ss.Robot:
    """The same machine with the base and the platform frame turned: a vector x becomes Q x."""
    return dataclasses.replace(
        robot,
        g=Q @ robot.g,
        b=robot.b @ Q.T,
        p=robot.p @ Q.T,
        k=robot.k @ Q.T,
        R_0=Q @ robot.R_0,
        I_p=Q @ robot.I_p @ Q.T,
    )


def standing(seed: int) -> ss.Robot:
    """A random machine that stands: its gravity pulls from the platform to the base."""
    rng = np.random.default_rng(seed)
    while True:
        robot = random_robot(rng)
        if robot.g[2] < -0.3 * np.linalg.norm(robot.g):
            return robot


@pytest.mark.parametrize("seed", range(20))
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


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(20))
def test_excitation_is_the_same_with_z_down(seed: int) -> None:
    robot = standing(seed)
    one, other = (
        ss.choose_excitation(machine, harmonics=2, samples=20, candidates=2)
        for machine in (robot, in_axes(robot, Z_DOWN))
    )
    np.testing.assert_allclose(other.motion.t, one.motion.t @ Z_DOWN, atol=1e-12 * machine_size(robot))
    np.testing.assert_allclose(other.motion.R, Z_DOWN @ one.motion.R @ Z_DOWN, atol=1e-12)
    np.testing.assert_allclose(other.condition, one.condition, rtol=1e-6)


def written(robot: ss.Robot, path: Path) -> Path:
    """The robot as a file that can be read."""
    path.write_text(toml(robot.to_dict()))
    return path


def toml(table: dict[str, object], name: str = "") -> str:
    plain = {k: v for k, v in table.items() if not isinstance(v, dict) and not is_tables(v)}
    text = "".join(f"{key} = {value_text(value)}\n" for key, value in plain.items())
    for key, value in table.items():
        path = f"{name}.{key}" if name else key
        if isinstance(value, dict):
            text += f"\n[{path}]\n{toml(value, path)}"
        elif is_tables(value):
            text += "".join(f"\n[[{path}]]\n{toml(item, path)}" for item in value)  # type: ignore[attr-defined]
    return text


def is_tables(value: object) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def value_text(value: object) -> str:
    if isinstance(value, list):
        return f"[{', '.join(value_text(item) for item in value)}]"
    return f'"{value}"' if isinstance(value, str) else repr(value)


@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(1, 4))])
def test_commands_say_the_same_with_z_down(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], seed: int
) -> None:
    robot = standing(seed)
    time = np.linspace(0.0, path_period(robot), 60)
    legs = ss.inverse_kinematics(robot, random_path(np.random.default_rng(seed), robot, load=False)(time))
    assert legs.L_ddot is not None
    columns = {"time": time}
    for name, values in (("L", legs.L), ("L_dot", legs.L_dot), ("L_ddot", legs.L_ddot)):
        columns |= {f"{name}_{leg + 1}": values[:, leg] for leg in range(6)}
    trajectory = tmp_path / "legs.csv"
    trajectory.write_text("".join(csv_lines(columns)))
    forces, texts, estimates = [], [], []
    for name, machine in (("up", robot), ("down", in_axes(robot, Z_DOWN))):
        file, output = written(machine, tmp_path / f"{name}.toml"), tmp_path / f"{name}.csv"
        assert main(["forces", str(file), str(trajectory), "-o", str(output)]) == 0
        forces.append(np.loadtxt(output, delimiter=",", skiprows=1))
        capsys.readouterr()
        assert main(["check", str(file)]) == 0
        lines = capsys.readouterr().out.splitlines()
        texts.append([line for line in lines if line.startswith(("leg lengths", "condition", "holding"))])
        folder = tmp_path / name
        small = ["--harmonics", "2", "--samples", "30", "--candidates", "2"]
        assert main(["identify", str(file), "-o", str(folder), *small]) == 0
        estimates.append((folder / "parameters.csv").read_text().splitlines())
    np.testing.assert_allclose(forces[1], forces[0], rtol=1e-7, atol=1e-9 * np.abs(forces[0]).max())
    assert texts[1] == texts[0]
    assert len(texts[0]) == 3
    compare_estimates(*estimates)


def compare_estimates(one: list[str], other: list[str]) -> None:
    """Names and sizes agree; components along y and z of the platform's frame change their signs."""
    rows = [[line.split(",") for line in lines[1:]] for lines in (one, other)]
    assert [row[0] for row in rows[0]] == [row[0] for row in rows[1]]
    values, mirrored = (np.array([[float(x) for x in row[3:6]] for row in part]) for part in rows)
    turned = [row[0] in ("h_P_y", "h_P_z", "J_P_xy", "J_P_xz") for row in rows[0]]
    values[turned, :2] *= -1.0
    assert np.all(np.abs(mirrored - values) <= 1e-5 * (np.abs(values) + values[:, 2:]))


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
            robot, ss.Motion(np.eye(3), [0.0, 0.0, 0.5 * direction], np.zeros(3), np.zeros(3))
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
    L = ss.inverse_kinematics(robot, ss.Motion(np.eye(3), [0.0, 0.0, 0.5], np.zeros(3), np.zeros(3))).L
    for call in (lambda: home_pose(robot), lambda: ss.forward_kinematics(robot, L)):
        with pytest.warns(ss.AssemblyModeWarning, match=f"^{text}$"):
            call()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ss.forward_kinematics(robot, L, (np.eye(3), [0.0, 0.0, 0.5]))


def test_upright_turns_z_to_the_side() -> None:
    robot = dasgupta()
    np.testing.assert_array_equal(upright(robot), np.eye(3))
    np.testing.assert_array_equal(upright(in_axes(robot, Z_DOWN)), Z_DOWN)
    for Q in ON_ITS_SIDE:
        R = upright(in_axes(robot, Q))
        np.testing.assert_allclose(R.T @ R, np.eye(3), atol=1e-15)
        np.testing.assert_allclose(R[:, 2], Q[:, 2], atol=1e-15)
        assert np.linalg.det(R) > 0.0
