"""Logs in another unit are rejected with the remedy; sound logs of machines from 1 mm to 10 m are read."""

import dataclasses
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from command_line import Fails
from log_files import LENGTHS, POSE
from machines import Array, dasgupta
from plausible_machines import BASE, PLATFORM, machine_of, ring, sound_machine
from robot_files import written
from sweeps import share, sweep

import stewart_sym as ss
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.kinematics.inverse_kinematics import leg_lengths
from stewart_sym.motion.rotation import rotation_from_rpy
from stewart_sym.motion.trajectory_format import UNITS

pytestmark = pytest.mark.filterwarnings("ignore")
WRONG = {"length_unit": ("mm", "cm", "in"), "angle_unit": ("deg",), "time_unit": ("ms", "us", "ns")}


def sized(size: float) -> ss.Robot:
    """Return a machine of a size (m) with a stroke of about a half of it."""
    t = np.array([0.0, 0.0, 1.3 * size])
    robot = machine_of(np.random.default_rng(3), ring(size, BASE), ring(0.6 * size, PLATFORM), t)
    return dataclasses.replace(robot, home_position=t)


MACHINES = {
    **{name: ss.robots.load(name) for name in ("dasgupta1998", "mathworks2002", "rubin_m2")},
    "travel of 1 mm": sized(3e-3),
    "size of 10 m": sized(5.0),
}


def moves(robot: ss.Robot, rng: np.random.Generator) -> tuple[Array, Array, Array]:
    """Return times (s), positions of the tool (m), and angles (rad), (n, 3), within the length limits."""
    home = home_pose(robot).t
    L = leg_lengths(robot, np.eye(3), home)
    limited = np.isfinite(robot.length_limits).all()
    room = float(np.abs(robot.length_limits - L[:, None]).min()) if limited else 0.2 * float(L.mean())
    travel, tilt = rng.uniform(0.1, 0.3, 2) * [room, room / np.linalg.norm(robot.p, axis=-1).max()]
    # Some of the machines are singular at larger angles; smaller ones may be radians.
    tilt = tilt if room < 0.1 * L.mean() else rng.uniform(0.05, 0.12)
    rate = np.sqrt(rng.uniform(0.05, 2.0) / travel)
    step = min(0.2, 2.0 * np.pi / rate / rng.uniform(12.0, 60.0))
    time = step * np.arange(80)
    phase = np.outer(time, rate * np.array([1.0, 0.7, 0.8])) + rng.uniform(0.0, 6.0, 3)
    theta = tilt * np.sin(phase + 1.0)
    t = home + travel * np.sin(phase)
    return time, t + rotation_from_rpy(theta) @ robot.tool, theta


def log(path: Path, time: Array, columns: Array, names: list[str] = POSE, units: str = "") -> Path:
    header = ",".join(["time", *names]) + (f"\n{units}" if units else "")
    np.savetxt(path, np.column_stack([time, columns]), delimiter=",", header=header, comments="", fmt="%.9g")
    return path


def fault(robot: ss.Robot, path: Path, form: ss.TrajectoryFormat | None = None) -> str:
    """Return the error of reading a file, or an empty text."""
    try:
        ss.read_trajectory(robot, path, form, ss.SmoothingOptions(enabled=False))
    except ValueError as error:
        return str(error)
    return ""


@sweep
@pytest.mark.parametrize("name", MACHINES)
def test_wrong_units_are_named_with_the_option(name: str, tmp_path: Path) -> None:
    robot, rng = MACHINES[name], np.random.default_rng(18)
    for i in range(share(100)):
        kind = list(WRONG)[i % 3]
        unit = str(rng.choice(WRONG[kind]))
        time, t, theta = moves(robot, rng)
        in_unit = dict.fromkeys(WRONG, 1.0) | {kind: 1.0 / UNITS[kind][unit]}
        scaled = np.hstack([in_unit["length_unit"] * t, in_unit["angle_unit"] * theta])
        path = log(tmp_path / "log.csv", in_unit["time_unit"] * time, scaled)
        text = fault(robot, path)
        assert kind in text, (i, kind, unit, text)
        assert unit in text.split("state ")[1].split(", or ")[0], (i, kind, unit, text)
        assert fault(robot, path, ss.TrajectoryFormat(**{kind: unit})) == "", (i, kind, unit)


@sweep
def test_machines_of_all_sizes_are_read_without_a_false_alarm(tmp_path: Path) -> None:
    rng, path = np.random.default_rng(18), tmp_path / "log.csv"
    for i in range(share(200)):
        robot = sound_machine(rng)
        if i % 2:
            robot = dataclasses.replace(robot, tool=rng.normal(size=3) * np.ptp(robot.p, axis=0).max())
        if i % 3:
            robot = dataclasses.replace(robot, home_position=home_pose(robot).t)
        time, t, theta = moves(robot, rng)
        if i % 5 == 0:
            t, theta = t[:1] + 0.0 * t, 0.0 * theta
        assert fault(robot, log(path, time, np.hstack([t, theta]))) == "", i
        L = leg_lengths(robot, rotation_from_rpy(theta), t - rotation_from_rpy(theta) @ robot.tool)
        assert "state " not in fault(robot, log(path, time, L, LENGTHS)), i
        assert "length_unit=mm" in fault(robot, log(path, time, 1e3 * L, LENGTHS)), i


def test_a_stated_unit_is_used_and_a_wrong_row_has_no_effect(tmp_path: Path) -> None:
    robot, path = dasgupta(), tmp_path / "log.csv"
    time, t, theta = moves(robot, np.random.default_rng(1))
    scaled = np.hstack([1e3 * t, np.degrees(theta)])
    log(path, time, scaled)
    assert "angle_unit=deg" in fault(robot, path)
    assert "length_unit=mm" in fault(robot, path, ss.TrajectoryFormat(angle_unit="deg"))
    assert fault(robot, path, ss.TrajectoryFormat(length_unit="mm", angle_unit="deg")) == ""
    assert fault(robot, log(path, time, scaled, units="s,mm,mm,mm,deg,deg,deg")) == ""
    theta[7] = 500.0
    assert "angle_unit" not in fault(robot, log(path, time, np.hstack([t, theta])))


@pytest.mark.parametrize(
    ("lengths", "angles", "units", "fix"),
    [
        (1e3, 1.0, "s,m,m,m,rad,rad,rad", {"length_unit": "mm"}),
        (1e2, 1.0, "s,mm,mm,mm,rad,rad,rad", {"length_unit": "cm"}),
        (1.0, np.degrees(1.0), "s,m,m,m,rad,rad,rad", {"angle_unit": "deg"}),
    ],
)
def test_units_of_a_file_that_contradict_its_numbers_are_an_error_with_the_option(
    lengths: float, angles: float, units: str, fix: dict[str, str], tmp_path: Path
) -> None:
    robot = dasgupta()
    L = leg_lengths(robot, np.eye(3), home_pose(robot).t)
    robot = dataclasses.replace(robot, length_limits=np.outer(L, [0.7, 1.3]))
    time, t, theta = moves(robot, np.random.default_rng(1))
    path = log(tmp_path / "log.csv", time, np.hstack([lengths * t, angles * theta]), units=units)
    ((name, unit),) = fix.items()
    stated = units.split(",")[1 if name == "length_unit" else 4]
    text = fault(robot, path)
    assert f"({stated} in " in text
    assert f"state {name}={unit}" in text
    assert text.endswith(f"or {name}={stated} if it is right")
    found = ss.read_trajectory(robot, path, ss.TrajectoryFormat(**fix))
    np.testing.assert_allclose(found.motion.t + found.motion.R @ robot.tool, t, atol=1e-6)


Columns = Callable[[Array, Array, Array], Array]
RELATIVE = ss.TrajectoryFormat(pose_mode="relative", length_mode="relative")


@pytest.mark.parametrize(
    ("columns", "names", "form", "text"),
    [
        (lambda t, theta, L: np.hstack([t - t[0], theta]), POSE, None, "state pose_mode=relative, or "),
        (lambda t, theta, L: np.hstack([t, theta]), POSE, RELATIVE, "state pose_mode=absolute, or "),
        (lambda t, theta, L: L - L[0], LENGTHS, None, "state length_mode=relative, or "),
        (lambda t, theta, L: L, LENGTHS, RELATIVE, "state length_mode=absolute, or "),
        (lambda t, theta, L: np.hstack([t[:, ::-1], theta]), POSE, None, "in the order z, y, x; correct"),
        (lambda t, theta, L: np.hstack([theta, t]), POSE, None, "by the columns of angles; correct"),
        (
            lambda t, theta, L: np.hstack([1e3 * (t - t[0]), theta]),
            POSE,
            None,
            "length_unit=mm with pose_mode=relative",
        ),
    ],
)
def test_modes_and_exchanged_columns_that_contradict_the_home_pose_are_named(
    columns: Columns, names: list[str], form: ss.TrajectoryFormat | None, text: str, tmp_path: Path
) -> None:
    robot = MACHINES["mathworks2002"]
    time, t, theta = moves(robot, np.random.default_rng(5))
    L = leg_lengths(robot, rotation_from_rpy(theta), t)
    path = log(tmp_path / "log.csv", time, columns(t, theta, L), names)
    if form is None:
        assert text in fault(robot, path)
    else:
        with pytest.warns(ss.TrajectoryWarning, match=text):
            fault(robot, path, form)


@pytest.mark.parametrize("command", ["forces", "identify"])
def test_every_command_that_reads_a_log_names_its_option(command: str, tmp_path: Path, fails: Fails) -> None:
    robot = dasgupta()
    written(robot, tmp_path / "robot.toml")
    time, t, theta = moves(robot, np.random.default_rng(1))
    path = log(tmp_path / "log.csv", time, np.hstack([1e3 * t, theta]))
    given = ["--measured", path, path] if command == "identify" else [path]
    line = fails(command, tmp_path / "robot.toml", *given, "-o", tmp_path / "out.html")
    assert f"{path}: lengths of " in line
    assert line.endswith("--length-unit mm, or --length-unit m if it is right")
    assert not (tmp_path / "out.html").exists()
