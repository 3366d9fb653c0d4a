"""Trajectories of leg lengths: poses along them, jumps, assembly modes, and `forces` of a file of them."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from command_line import Run, rejects
from leg_lengths import Array, paper_legs
from machines import dasgupta
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.cli.main import main
from stewart_sym.kinematics.pose_search import rates_per_twist
from stewart_sym.motion.rotation import rotation_from_rpy
from stewart_sym.studies.common.text_tables import csv_lines

# Joint-space trajectories


@pytest.mark.parametrize("name", ["I", "II"])
@pytest.mark.parametrize("guessed", [True, False])
def test_paths_planned_in_joint_space_need_the_same_forces(name: str, guessed: bool) -> None:
    robot, motion, legs = paper_legs(name)
    guess = (motion.R[0], motion.t[0]) if guessed else None
    back = ss.motion_from_lengths(robot, legs.L, legs.L_dot, legs.L_ddot, guess)
    for formulation in ("exact", "paper"):
        F, wanted = (ss.inverse_dynamics(robot, m, formulation).F for m in (back, motion))
        np.testing.assert_allclose(F, wanted, rtol=1e-9)


def test_path_iii_leads_through_a_singular_pose_and_no_farther() -> None:
    robot, motion, legs = paper_legs("III")
    sign = np.linalg.slogdet(rates_per_twist(robot, motion.R, motion.t))[0]
    turn = int(np.flatnonzero(sign != sign[0])[0])
    start = motion.R[0], motion.t[0]
    before = ss.motion_from_lengths(robot, legs.L[:turn], legs.L_dot[:turn], guess=start)
    np.testing.assert_allclose(before.t, motion.t[:turn], atol=1e-9)
    assert before.a is None
    with pytest.raises(ValueError, match=rf"^L\[{turn}\]: a singular pose is crossed"):
        ss.motion_from_lengths(robot, legs.L, legs.L_dot, guess=start)


def test_jumps_are_named_and_not_followed_into_another_mode() -> None:
    robot, _, legs = paper_legs()
    L = legs.L.copy()
    L[30:, 2] += 1.0
    rejects(r"^L\[30\]: the lengths jump here", ss.motion_from_lengths, robot, L, legs.L_dot)
    L[0, 2] += 5.0
    with pytest.raises(
        ValueError, match=r"^L\[0\]: no pose with these leg lengths was found: none exists, legs 1 and 3 "
    ):
        ss.motion_from_lengths(robot, L, legs.L_dot)


def test_each_assembly_mode_is_kept() -> None:
    """Start the same lengths in two modes: both are followed, apart from each other all the way."""
    robot, _, legs = paper_legs()
    up = ss.motion_from_lengths(robot, legs.L, legs.L_dot)
    mirrored = up.t[0] * [1.0, 1.0, -1.0]
    down = ss.motion_from_lengths(robot, legs.L, legs.L_dot, guess=(up.R[0], mirrored))
    for motion in (up, down):
        np.testing.assert_allclose(ss.inverse_kinematics(robot, motion).L, legs.L, atol=1e-14)
        np.testing.assert_allclose(ss.inverse_kinematics(robot, motion).L_dot, legs.L_dot, atol=1e-12)
    assert np.all(up.t[:, 2] > 0.2)
    assert np.all(down.t[:, 2] < -0.2)


# The command line


LEGS = [f"L_{leg}" for leg in range(1, 7)]
RATES = [f"{name}_{leg}" for name in ("L_dot", "L_ddot") for leg in range(1, 7)]


def joint_csv(path: Path, motion: ss.Motion, time: Array, rates: bool, loads: bool = False) -> Path:
    legs = ss.inverse_kinematics(dasgupta(), motion)
    columns = {"time": time, **dict(zip(LEGS, legs.L.T, strict=True))}
    if rates:
        columns |= dict(zip(RATES, [*legs.L_dot.T, *legs.L_ddot.T], strict=True))
    if loads:
        columns |= {f"F_ext_{axis}": motion.F_ext[:, j] for j, axis in enumerate("xyz")}
    path.write_text("".join(csv_lines(columns)))
    return path


def written(path: Path) -> dict[str, Array]:
    header, *rows = path.read_text().splitlines()
    values = np.array([row.split(",") for row in rows], dtype=np.float64)
    return dict(zip(header.split(","), values.T, strict=True))


def forces_of(table: dict[str, Array]) -> Array:
    return np.column_stack([table[f"F_{leg}"] for leg in range(1, 7)])


@pytest.mark.parametrize("loads", [True, False])
def test_forces_takes_leg_lengths(tmp_path: Path, loads: bool) -> None:
    path, _ = ss.PAPER_PATHS["I"]
    time = np.linspace(0.0, 6.0, 41)
    motion = path.sample(time)
    if loads:
        motion = dataclasses.replace(motion, F_ext=np.array([5.0, 0.0, -100.0]))
    trajectory = joint_csv(tmp_path / "legs.csv", motion, time, rates=True, loads=loads)
    output = tmp_path / "forces.csv"
    assert main(["forces", str(PAPERS), str(trajectory), "-o", str(output)]) == 0
    table = written(output)
    wanted = ss.inverse_dynamics(dasgupta(), motion).F
    np.testing.assert_allclose(forces_of(table), wanted, rtol=1e-9)
    np.testing.assert_array_equal(table["time"], time)


def test_start_chooses_the_assembly_mode(tmp_path: Path, run: Run) -> None:
    path, _ = ss.PAPER_PATHS["I"]
    time = np.linspace(0.0, 6.0, 13)
    motion = path.sample(time)
    trajectory = joint_csv(tmp_path / "legs.csv", motion, time, rates=True)
    legs = ss.inverse_kinematics(dasgupta(), motion)
    start = ["0.1", "0", "-0.4", "0", "0", "-0.2"]
    output = tmp_path / "forces.csv"
    told = run("forces", PAPERS, trajectory, "-o", output, "--pose-guess", *start).err
    assert "pose guess: the platform is below the base, in the direction of gravity" in told
    guess = rotation_from_rpy([0.0, 0.0, -0.2]), np.array([0.1, 0.0, -0.4])
    below = ss.motion_from_lengths(dasgupta(), legs.L, legs.L_dot, legs.L_ddot, guess)
    assert np.all(below.t[:, 2] < 0.0)
    np.testing.assert_allclose(
        forces_of(written(output)), ss.inverse_dynamics(dasgupta(), below).F, rtol=1e-9
    )
    poses = tmp_path / "poses.csv"
    poses.write_text("time,t_x,t_y,t_z,theta_x,theta_y,theta_z\n" + "0,0.1,0,0.5,0,0,0\n")
    for arguments, expected in (
        (
            [trajectory, "--pose-guess", *start[:5], "nan"],
            "--pose-guess: expected a finite number, got 'nan'",
        ),
        ([poses, "--pose-guess", *start], "too few rows for rates"),
    ):
        assert expected in run("forces", PAPERS, *arguments, "-o", output, code=2).err


def test_a_row_without_a_pose_is_named(tmp_path: Path, run: Run) -> None:
    path, step = ss.PAPER_PATHS["I"]
    time = path.time_grid(step)
    trajectory = joint_csv(tmp_path / "legs.csv", path.sample(time), time, rates=True)
    lines = trajectory.read_text().splitlines()
    cells = lines[20].split(",")
    cells[1] = "5.0"
    lines[20] = ",".join(cells)
    # An empty line counts as a row of the file.
    trajectory.write_text("\n".join([*lines[:3], "", *lines[3:]]))
    said = run("forces", PAPERS, trajectory, "-o", tmp_path / "f.csv", code=2).err
    assert f"stewart-sym: error: {trajectory}: line 22: the lengths jump here" in said
