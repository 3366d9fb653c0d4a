"""``stewart-sym plan``: what it writes, that it can be read again, and what it rejects in one line."""

import contextlib
import dataclasses
import io
import json
import shutil
import tomllib
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from motion_fields import FIELDS, motion_of, waves
from pages import DOCS
from plain_logs import read_log

from stewart_sym.cli.main import main
from stewart_sym.drives.effort import DriveLimitWarning, drive_effort
from stewart_sym.dynamics.inverse_dynamics import inverse_dynamics
from stewart_sym.kinematics.robot_logs import read_log_of
from stewart_sym.kinematics.trajectory_writer import trajectory_columns
from stewart_sym.motion.motion import Motion
from stewart_sym.motion.trajectory_format import EULER_ORDERS, TrajectoryFormat
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.common.text_tables import csv_lines

VIA = (DOCS / "examples" / "via.toml").read_text(encoding="utf-8")
SHORT = "[[via]]".join(VIA.split("[[via]]")[:4])
"""The first three via poses."""
HEAD = 'schema = 1\nrobot = "hexapod.toml"\n'
FIRST = "[[via]]\nt = [0.0, 0.0, 0.65]\ntheta = [0.0, 0.0, 0.0]\n"
SECOND = "[[via]]\nt = [0.1, 0.0, 0.65]\ntheta = [0.0, 0.0, 0.0]\n"
PLAN = HEAD + FIRST + SECOND


def via(folder: Path, text: str = VIA) -> str:
    (folder / "via.toml").write_text(text, encoding="utf-8")
    return str(folder / "via.toml")


@pytest.mark.slow
def test_the_example_is_planned_and_its_trajectory_keeps_the_limits(folder: Path) -> None:
    out = folder / "out"
    assert main(["plan", via(folder), "-o", str(out), "--no-plots"]) == 0
    found = json.loads((out / "report.json").read_text())
    assert found["certificate"]["is_valid"]
    assert found["certificate"]["crossings_s"] == []
    assert found["condition_numbers"]["peak"] <= 12.0
    log = read_log(out / "trajectory.csv")
    np.testing.assert_allclose(np.diff(log.time)[:-1], 1.0 / 200.0)
    assert log.time[-1] == pytest.approx(found["duration_s"])
    F = inverse_dynamics(Robot.from_toml(folder / "hexapod.toml"), log.motion).F
    assert np.abs(F).max() <= 500.0 * (1.0 + 1e-9)
    assert np.abs(F).max() > 450.0


@pytest.mark.slow
def test_limits_of_motors_bound_the_plan_and_their_rated_torque_is_checked(folder: Path, run: Run) -> None:
    file = folder / "hexapod.toml"
    free = file.read_text()
    drive = "\n[legs.drive]\nlead = -0.005\ntorque_constant = 0.5\nspeed_limit = 100.0\ntorque_limit = 0.2\n"
    drive += "rated_torque = 0.02\n"
    file.write_text(free + drive)
    out = folder / "out"
    shown = run("plan", via(folder, SHORT), "-o", out, "--no-plots")
    found = json.loads((out / "report.json").read_text())
    speeds = [leg["motor_peak_speed_rad_per_s"] for leg in found["legs"]]
    assert shown.out.startswith("certificate  valid\n")
    assert 99.0 < max(speeds) <= 100.0 * (1.0 + 1e-9)
    assert found["certificate"]["is_valid"]
    assert found["certificate"]["max_utilization"] <= 1.0 + 1e-9
    assert "warning: drive: drive.rated_torque exceeded by " in shown.err
    assert "_limit exceeded" not in shown.err
    assert " of 0.2 " in shown.out
    log = read_log(out / "trajectory.csv")
    with pytest.warns(DriveLimitWarning):
        effort = drive_effort(Robot.from_toml(file), log.motion, log.time)
    torques = [leg["motor_peak_torque_N_m"] for leg in found["legs"]]
    assert np.all(np.array(torques) >= effort.peak_torque * (1.0 - 1e-6))
    np.testing.assert_allclose(torques, effort.peak_torque, rtol=0.1)
    assert 0.199 < max(torques) <= 0.2 * (1.0 + 1e-6)


@pytest.mark.slow
def test_a_duration_has_a_motion_of_least_energy_or_peak_force(
    folder: Path,
) -> None:
    def found(*options: str, text: str = SHORT) -> dict:
        out = folder / "-".join(("out", *options))
        assert main(["plan", via(folder, text), "-o", str(out), "--no-plots", *options]) == 0
        report = json.loads((out / "report.json").read_text())
        assert report["certificate"]["is_valid"]
        assert report["duration_s"] == pytest.approx(3.0)
        return report

    def peak(report: dict) -> float:
        return max(leg["peak_force_N"] for leg in report["legs"])

    with (folder / "hexapod.toml").open("a") as file:
        file.write('\n[trajectory]\neuler_order = "xyz"\n')
    thrifty = found("--minimize", "energy", "--duration", "3")
    for stated, reported in zip(tomllib.loads(SHORT)["via"], thrifty["via_poses"], strict=True):
        np.testing.assert_allclose(reported["theta_rad"], stated["theta"], atol=1e-15)
    in_file = found(text='minimize = "peak_force"\nduration = 3.0\n' + SHORT)
    assert thrifty["energy_J"] < in_file["energy_J"]
    assert peak(in_file) < peak(thrifty)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--minimize", "energy", "--duration", "0.01"], "duration: expected at least the least time, "),
        (["--minimize", "energy"], 'minimize: expected a duration for "energy"'),
        (["--duration", "2"], 'duration: applies to minimize "energy" or "peak_force", got "time"'),
    ],
)
def test_an_error_about_an_option_names_it(folder: Path, run: Run, options: list[str], words: str) -> None:
    told = run("plan", via(folder, PLAN), "-o", folder / "out", *options, code=2).err
    assert f"error: {words}" in told
    assert not (folder / "out").exists()


@pytest.mark.slow
def test_via_poses_may_stand_in_a_csv_file(folder: Path) -> None:
    rows = ["time,t_x,t_y,t_z,theta_x,theta_y,theta_z", "0,0,0,0.65,0,0,0", "1,0.1,0.05,0.7,0.1,-0.1,0.2"]
    (folder / "poses.csv").write_text("\n".join(rows) + "\n")
    text = 'schema = 1\nrobot = "hexapod.toml"\nvia_file = "poses.csv"\n'
    assert main(["plan", via(folder, text), "-o", str(folder / "out"), "--no-plots"]) == 0
    (folder / "poses.csv").write_text("\n".join([rows[0], rows[2], rows[1]]) + "\n")
    check_rejected(folder, text, "sort the rows or drop the line", out="other")
    (folder / "poses.csv").write_text("\n".join([*rows[:2], "1,0.1,0.05,7,0.1,-0.1,0.2"]) + "\n")
    check_rejected(folder, text, "poses.csv: via pose 2: out of reach", out="other")
    (folder / "poses.csv").write_text("\n".join(rows[:2]) + "\n")
    check_rejected(folder, text, "poses.csv: via poses: expected at least 2, got 1", out="other")


def check_rejected(folder: Path, text: str, words: str, out: str = "out") -> None:
    before = sorted(path.name for path in folder.iterdir() if path.name != "via.toml")
    source, errors = via(folder, text), io.StringIO()
    with contextlib.redirect_stderr(errors):
        assert main(["plan", source, "-o", str(folder / out), "--no-plots"]) == 2
    lines = errors.getvalue().splitlines()
    assert [line for line in lines if "error:" in line] == lines[-1:], lines
    assert words in lines[-1]
    after = sorted(path.name for path in folder.iterdir() if path.name != "via.toml")
    assert after == before


def limited(limit: str) -> str:
    return f"{HEAD}[limits]\n{limit}\n{FIRST}{SECOND}"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (HEAD + FIRST, "via: expected at least 2 via poses, got 1 (at line 3)"),
        (HEAD + FIRST + SECOND.replace("0.1", "nan"), "via 2: t: expected 3 finite numbers"),
        (PLAN.replace("0.1", "9.0"), "via 2: out of reach, the pose exceeds the limit of leg length of leg"),
        (
            limited("max_condition = 12.0").replace("[0.1", "[900.0"),
            "via poses: lengths of 450.2 m compared with",
        ),
        *(
            (
                PLAN.replace("0.1", x) + "tolerance.yaw = [-0.2, 0.2]\ntolerance.x = [-0.1, 0.0]\n",
                words,
            )
            for x, words in (
                ("9.0", "via 2: out of reach, the nearest pose within its tolerance exceeds the limit of"),
                ("900.0", "via poses: lengths of 450.2 m compared with"),
            )
        ),
        (PLAN + FIRST, "via 2: the path turns back at the pose"),
        (HEAD + FIRST + FIRST, "via 2: expected another pose than via pose 1 (at line 6)"),
        (limited("force = 10.0"), "at rest at s ="),
        (limited("max_condition = 1.1"), "via 1: expected a condition number of at most 1.1"),
        ("", "schema: missing (at line 1)"),
    ],
)
def test_bad_input_is_one_line_and_leaves_nothing_behind(folder: Path, text: str, words: str) -> None:
    check_rejected(folder, text, words)


HEXAPOD = DOCS / "examples" / "hexapod.toml"
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
    robot = dataclasses.replace(
        Robot.from_toml(HEXAPOD),
        trajectory_format=TrajectoryFormat(euler_order=order),
        tool=np.array([0.1, -0.2, 0.4]),
    )
    time = np.linspace(0.0, 2.0, 41)
    names, found = read_back(robot, waving(time), time, tmp_path)
    assert {"theta_x", "theta_dot_x", "theta_ddot_x", "F_ext_x", "M_ext_x"} <= names
    for name in FIELDS:
        np.testing.assert_allclose(getattr(found, name), getattr(waving(time), name), atol=1e-12)


@pytest.mark.slow
def test_forces_of_the_written_trajectory_are_the_plans_own(tmp_path: Path) -> None:
    shutil.copy(HEXAPOD, tmp_path)
    file = tmp_path / "hexapod.toml"
    more = '\n[trajectory]\neuler_order = "xyz"\ntool = [0.0, 0.0, 0.1]\n'
    file.write_text(file.read_text(encoding="utf-8") + more, encoding="utf-8")
    (tmp_path / "via.toml").write_text(SHORT.replace("0.65]", "0.75]") + LOAD, encoding="utf-8")
    out = tmp_path / "out"
    assert main(["plan", str(tmp_path / "via.toml"), "-o", str(out), "--no-plots"]) == 0
    forces = str(tmp_path / "forces.csv")
    assert main(["forces", str(file), str(out / "trajectory.csv"), "-o", forces]) == 0
    expected, found = (
        np.genfromtxt(path, delimiter=",", names=True) for path in (out / "path.csv", Path(forces))
    )
    for leg in range(1, 7):
        np.testing.assert_allclose(found[f"F_{leg}"], expected[f"F_{leg}"], rtol=0.0, atol=1e-9)


def test_a_singular_start_is_rejected(folder: Path) -> None:
    """The platform in the plane of its base, level: no leg bears weight."""
    robot = (folder / "hexapod.toml").read_text().replace("length_limits = [0.55, 0.95]\n", "")
    (folder / "flat.toml").write_text(robot)
    text = PLAN.replace("hexapod", "flat").replace("0.65]\ntheta", "0.05]\ntheta", 1)
    check_rejected(folder, text, "via 1: expected a regular pose, got a singular pose")
