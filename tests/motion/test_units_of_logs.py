"""Logs in another unit are rejected with the remedy; sound logs of machines from 1 mm to 10 m are read."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from command_line import Fails
from machines import dasgupta
from plausible_machines import sound_machine
from robot_files import written
from sweeps import share

import stewart_sym as ss
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.kinematics.offset_legs import leg_lengths
from stewart_sym.motion.rotation import rotation_from_rpy

pytestmark = pytest.mark.filterwarnings("ignore")
POSES = ["t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z"]
LENGTHS = [f"L_{leg}" for leg in range(1, 7)]
TIME = np.linspace(0.0, 2.0, 41)


def moves(robot: ss.Robot, travel: float, tilt: float) -> tuple[np.ndarray, np.ndarray]:
    """Return positions of the tool (m) and angles (rad), (n, 3), about the home pose."""
    phase = np.outer(TIME, [3.0, 2.0, 4.0]) + np.arange(3)
    size = float(leg_lengths(robot, np.eye(3), home_pose(robot).t).mean())
    theta = tilt * np.sin(phase + 1.0)
    t = home_pose(robot).t + travel * size * np.sin(phase)
    return t + rotation_from_rpy(theta) @ robot.tool, theta


def log(path: Path, columns: np.ndarray, names: list[str] = POSES, units: str = "") -> Path:
    header = ",".join(["time", *names]) + (f"\n{units}" if units else "")
    np.savetxt(path, np.column_stack([TIME, columns]), delimiter=",", header=header, comments="", fmt="%.9g")
    return path


def poses(t: np.ndarray, theta: np.ndarray, lengths: float = 1.0, angles: float = 1.0) -> np.ndarray:
    return np.column_stack([lengths * t, angles * theta])


def fault(robot: ss.Robot, path: Path, form: ss.TrajectoryFormat | None = None) -> str:
    try:
        ss.read_trajectory(robot, path, form)
    except ValueError as error:
        return str(error)
    return ""


@pytest.mark.slow
@pytest.mark.parametrize("tooled", [False, True])
def test_machines_of_all_sizes_are_read_and_other_units_named(tooled: bool, tmp_path: Path) -> None:
    rng, path = np.random.default_rng(18), tmp_path / "log.csv"
    for i in range(share(120, 25)):
        robot = sound_machine(rng)
        if tooled:
            tool = rng.normal(size=3) * np.ptp(robot.p, axis=0).max()
            robot = dataclasses.replace(robot, tool=tool)
        travel, tilt = rng.uniform(0.0, 0.02), rng.uniform(0.0, 0.02)
        if i % 5 == 0:
            travel = tilt = 0.0
        t, theta = moves(robot, travel, tilt)
        assert fault(robot, log(path, poses(t, theta))) == "", i
        if not tooled:
            assert "length_unit=mm" in fault(robot, log(path, poses(t, theta, 1e3))), i
        theta = moves(robot, 0.0, 0.03)[1]
        degrees = fault(robot, log(path, poses(t, 2.0 * theta, 1.0, np.degrees(1.0))))
        assert not tilt or "angle_unit=deg" in degrees, i
        L = leg_lengths(robot, rotation_from_rpy(0.0 * theta), t - robot.tool)
        assert "length_unit" not in fault(robot, log(path, L, LENGTHS)), i
        assert "length_unit=mm" in fault(robot, log(path, 1e3 * L, LENGTHS)), i


def test_a_stated_unit_is_taken_as_stated_and_a_wrong_row_does_not_count(tmp_path: Path) -> None:
    robot, path = dasgupta(), tmp_path / "log.csv"
    t, theta = moves(robot, 0.02, 0.05)
    log(path, poses(t, theta, 1e3, np.degrees(1.0)))
    assert "length_unit=mm" in fault(robot, path)
    assert "angle_unit=deg" in fault(robot, path, ss.TrajectoryFormat(length_unit="mm"))
    assert fault(robot, path, ss.TrajectoryFormat(length_unit="mm", angle_unit="deg")) == ""
    assert "give TrajectoryFormat" not in fault(
        robot, path, ss.TrajectoryFormat(length_unit="m", angle_unit="rad")
    )
    log(path, poses(t, theta, 1e3, np.degrees(1.0)), units="s,mm,mm,mm,deg,deg,deg")
    assert fault(robot, path) == ""
    theta[7] = 500.0
    assert "angle_unit" not in fault(robot, log(path, poses(t, theta)))


@pytest.mark.parametrize(
    ("lengths", "angles", "units", "fix"),
    [
        (1e3, 1.0, "s,m,m,m,rad,rad,rad", {"length_unit": "mm"}),
        (1e2, 1.0, "s,mm,mm,mm,rad,rad,rad", {"length_unit": "cm"}),
        (1.0, 1.0, "s,mm,mm,mm,rad,rad,rad", {"length_unit": "m"}),
        (1.0, np.degrees(1.0), "s,m,m,m,rad,rad,rad", {"angle_unit": "deg"}),
    ],
)
def test_a_row_of_units_that_contradicts_its_numbers_is_an_error_with_the_option(
    lengths: float, angles: float, units: str, fix: dict[str, str], tmp_path: Path
) -> None:
    robot = dasgupta()
    L = leg_lengths(robot, np.eye(3), home_pose(robot).t)
    robot = dataclasses.replace(robot, length_limits=np.outer(L, [0.7, 1.3]))
    t, theta = moves(robot, 0.02, 0.05)
    path = log(tmp_path / "log.csv", poses(t, theta, lengths, angles), units=units)
    ((name, unit),) = fix.items()
    stated = units.split(",")[1 if name == "length_unit" else 4]
    text = fault(robot, path)
    assert text.startswith(f"{path}: line 2: the row of units ({stated}) contradicts ")
    assert f"{name}={unit}" in text
    assert text.endswith(f"{name}={stated} if {stated} is right")
    with pytest.warns(ss.TrajectoryWarning, match=rf"line 2: the row of units \({stated}\) contradicts"):
        found = ss.read_trajectory(robot, path, ss.TrajectoryFormat(**fix))
    np.testing.assert_allclose(found.motion.t + found.motion.R @ robot.tool, t, atol=1e-6)
    assert fault(robot, path, ss.TrajectoryFormat(**{name: stated})) == ""


@pytest.mark.parametrize("command", ["forces", "identify"])
def test_every_command_that_reads_a_log_names_its_option(command: str, tmp_path: Path, fails: Fails) -> None:
    robot = dasgupta()
    written(robot, tmp_path / "robot.toml")
    path = log(tmp_path / "log.csv", poses(*moves(robot, 0.02, 0.05), 1e3))
    given = ["--measured", path, path] if command == "identify" else [path]
    line = fails(command, tmp_path / "robot.toml", *given, "-o", tmp_path / "out.html")
    assert f"{path}: lengths of " in line
    assert line.endswith("length_unit=mm, or length_unit=m if m is right")
    assert not (tmp_path / "out.html").exists()
