"""The trajectory that ``plan`` writes is the plan's own motion as the robot's files are read."""

import dataclasses
import shutil
from pathlib import Path

import numpy as np
import pytest
from motion_fields import FIELDS, motion_of, waves
from pages import DOCS

from stewart_sym.cli.main import main
from stewart_sym.kinematics.robot_logs import read_log_of
from stewart_sym.motion.logs import EULER_ORDERS
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.common.motion_columns import trajectory_columns
from stewart_sym.studies.common.output import csv_lines

HEXAPOD = DOCS / "examples" / "hexapod.toml"
VIA = (DOCS / "examples" / "via.toml").read_text(encoding="utf-8")
LOAD = "\n[load]\nF_ext = [0.0, 0.0, -100.0]\nM_ext = [0.0, 5.0, 0.0]\n"


def waving(time: np.ndarray, pitch: float = 0.2) -> Motion:
    """A motion of the reference point under a load."""
    middle, size = [0.0, 0.0, 0.65, 0.1, pitch, 0.3], np.array([0.03, 0.04, 0.02, 0.3, 0.02, 0.3])
    values = waves(time, middle, size, [2.0, 3.0, 2.5, 1.7, 2.2, 1.3], np.arange(6))
    return motion_of(values, F_ext=[10.0, -20.0, -100.0], M_ext=[1.0, 2.0, 3.0])


def read_back(robot: Robot, motion: Motion, time: np.ndarray, folder: Path) -> tuple[set[str], Motion]:
    """Names of the columns that are written of a motion, and the motion that is read from them."""
    columns = trajectory_columns(robot, time, motion)
    (folder / "trajectory.csv").write_text("".join(csv_lines(columns)), encoding="utf-8")
    return set(columns), read_log_of(robot, folder / "trajectory.csv").motion


@pytest.mark.parametrize("order", EULER_ORDERS)
def test_the_motion_is_written_with_rates_and_load_in_every_euler_order(tmp_path: Path, order: str) -> None:
    robot = dataclasses.replace(Robot.from_toml(HEXAPOD), euler_order=order, tool=np.array([0.1, -0.2, 0.4]))
    time = np.linspace(0.0, 2.0, 41)
    names, found = read_back(robot, waving(time), time, tmp_path)
    assert {"theta_x", "theta_dot_x", "theta_ddot_x", "F_ext_x", "M_ext_x"} <= names
    for name in FIELDS:
        np.testing.assert_allclose(getattr(found, name), getattr(waving(time), name), atol=1e-12)


def test_near_gimbal_lock_poses_and_load_are_written_without_rates(tmp_path: Path) -> None:
    robot, time = Robot.from_toml(HEXAPOD), np.linspace(0.0, 2.0, 41)
    upright = waving(time, 0.5 * np.pi - 0.04)
    names, found = read_back(robot, upright, time, tmp_path)
    assert {"q_w", "F_ext_x", "M_ext_x"} <= names
    assert not {"theta_x", "v_x"} & names
    for name in ("R", "t", "F_ext", "M_ext"):
        np.testing.assert_allclose(getattr(found, name), getattr(upright, name), atol=1e-12)


def test_forces_of_the_written_trajectory_are_the_plans_own(tmp_path: Path) -> None:
    shutil.copy(HEXAPOD, tmp_path)
    file = tmp_path / "hexapod.toml"
    more = '\n[trajectory]\neuler_order = "xyz"\ntool = [0.0, 0.0, 0.1]\n'
    file.write_text(file.read_text(encoding="utf-8") + more, encoding="utf-8")
    short = "[[via]]".join(VIA.split("[[via]]")[:4])
    (tmp_path / "via.toml").write_text(short.replace("0.65]", "0.75]") + LOAD, encoding="utf-8")
    out = tmp_path / "out"
    assert main(["plan", str(tmp_path / "via.toml"), "-o", str(out), "--no-pictures"]) == 0
    forces = str(tmp_path / "forces.csv")
    assert main(["forces", str(file), str(out / "trajectory.csv"), "-o", forces]) == 0
    expected, found = (
        np.genfromtxt(path, delimiter=",", names=True) for path in (out / "path.csv", Path(forces))
    )
    for leg in range(1, 7):
        np.testing.assert_allclose(found[f"F{leg}"], expected[f"F{leg}"], rtol=0.0, atol=1e-9)
