"""Texts of reports contain one unit of length and one unit of angle: the units of the robot file."""

import re
import tomllib
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from robot_files import HANGING

import stewart_sym as ss
from stewart_sym.io.output import toml_text
from stewart_sym.kinematics.trajectory_writer import trajectory_columns
from stewart_sym.studies.common.text_tables import csv_lines

DRIVE = "[legs.drive]\nlead = 5.0\ntorque_limit = 5.0\nspeed_limit = 9e4\n"
LOG_UNITS = '[trajectory]\nlength_unit = "m"\nangle_unit = "rad"\n'


def in_meters(text: str) -> str:
    """The robot file in m and rad."""
    return toml_text(ss.Robot.from_dict(tomllib.loads(text)).to_dict())


@pytest.mark.slow
@pytest.mark.parametrize("unit", ["mm", "m"])
def test_reports_have_the_units_of_the_robot_file(unit: str, folder: Path, run: Run) -> None:
    text = f"{HANGING}{DRIVE}{LOG_UNITS}"
    (folder / "machine.toml").write_text(text if unit == "mm" else in_meters(text))
    robot = ss.Robot.from_toml("machine.toml")
    time = np.linspace(0.0, 1.0, 101)
    wave, zero = np.sin(2.0 * np.pi * time) ** 3, np.zeros((101, 3))
    t = np.array([0.0, 0.0, 0.7]) + 0.03 * wave[:, None]
    motion = ss.Motion(R=np.broadcast_to(np.eye(3), (101, 3, 3)), t=t, omega=zero, v=zero)
    (folder / "log.csv").write_text("".join(csv_lines(trajectory_columns(robot, time, motion))))
    foreign = r"\d\)? (m|rad|degrees)\b(?!/s\^2)|, (m|rad|m/s|rad/s|degrees)\b"
    if unit == "m":
        foreign = r"\d\)? (mm|deg)\b|, (mm|deg|mm/s|deg/s|degrees)\b"
    for command in (
        ("check", "machine.toml"),
        ("workspace", "machine.toml", "--samples", 300, "--no-plots"),
        ("forces", "machine.toml", "log.csv", "-o", "forces.csv"),
        ("size-actuators", "machine.toml", "log.csv", "--no-plots"),
        ("singularities", "machine.toml", "log.csv", "--no-plots"),
    ):
        told = run(*command).out
        assert not re.findall(foreign, told), told
        assert re.search(rf"\b{unit}\b", told)
