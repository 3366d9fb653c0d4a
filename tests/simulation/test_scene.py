"""Scenes: what a file says is what is run; what is wrong with one is one line and leaves nothing behind."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from command_line import Fails, Run, folder_state, read
from plain_logs import read_log
from robot_files import scene_of

import stewart_sym as ss
from stewart_sym.kinematics.trajectory_writer import trajectory_columns
from stewart_sym.motion.interpolation import followed
from stewart_sym.motion.rotation import rotation_from_rpy, rpy_from_rotation
from stewart_sym.simulation.scene import read_scene
from stewart_sym.studies.common.text_tables import csv_lines

SWING = """
schema = 1
robot = "robots/robot.toml"
duration = 0.1
output_step = 0.01

[state]
t = [0.2, 0.0, 0.8]
theta = [0.1, 0.0, 0.2]
v = [0.05, 0.02, 0.03]

[actuation]
type = "spring"
stiffness = 4e4
"""
TRACK = """
schema = 1
robot = "robots/robot.toml"
duration = 0.05
formulation = "paper"

[actuation]
type = "computed_torque"
path = "II"
k_p = 400
k_d = 40
model_formulation = "paper"
rate = 500.0
"""

pytestmark = pytest.mark.filterwarnings("ignore::stewart_sym.RobotWarning")


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    """A scene of springs, the paper's robot in a folder beside it."""
    return scene_of(SWING, tmp_path)


@pytest.mark.slow
def test_a_scene_runs_as_the_library_does(scene: Path, run: Run) -> None:
    output = scene.parent / "deep" / "out"
    captured = run("simulate", scene, "-o", output)
    assert sorted(path.name for path in output.glob("[!.]*")) == [
        "run.csv",
        "run.png",
        "summary.json",
        "summary.txt",
    ]
    assert (output / "summary.txt").read_text() in captured.out
    assert "ran to its end at 0.1 s" in captured.out
    robot = ss.Robot.from_toml(scene.parent / "robots" / "robot.toml")
    state = ss.Motion(
        R=rotation_from_rpy([0.1, 0.0, 0.2]), t=[0.2, 0.0, 0.8], omega=np.zeros(3), v=[0.05, 0.02, 0.03]
    )
    law = ss.LegSprings.in_equilibrium(robot, state, 4e4)
    run = ss.simulate(robot, state, law, 0.1, output_step=0.01)
    rows = read(output / "run.csv")
    assert [float(row["time"]) for row in rows] == run.time.tolist()
    expected = {"t_x": run.t[:, 0], "v_z": run.v[:, 2], "F_5": run.F[:, 4], "L_2": run.L[:, 1]}
    for name, values in expected.items():
        assert [float(row[name]) for row in rows] == values.tolist()
    theta = [[float(row[f"theta_{axis}"]) for axis in "xyz"] for row in rows]
    np.testing.assert_array_equal(theta, rpy_from_rotation(run.R))


def test_tracking_takes_a_path_from_csv(scene: Path) -> None:
    time = np.linspace(1.0, 2.0, 11)
    pose = {"t_x": 0.1 + 0.05 * time, "t_y": 0 * time, "t_z": 0.5 + 0.05 * time**2}
    turn = {"theta_x": 0 * time, "theta_y": 0 * time, "theta_z": 2.6 + 0.5 * time}
    (scene.parent / "path.csv").write_text("".join(csv_lines({"time": time} | pose | turn)))
    wanted = followed(read_log(scene.parent / "path.csv"))
    middle, after = wanted(0.43), wanted(3.0)
    np.testing.assert_allclose(middle.t, [0.1 + 0.05 * 1.43, 0.0, 0.5 + 0.05 * 1.43**2], atol=1e-12)
    np.testing.assert_allclose(middle.v, [0.05, 0.0, 0.1 * 1.43], atol=1e-11)
    np.testing.assert_allclose(middle.a, [0.0, 0.0, 0.1], atol=1e-9)
    # Through half a turn, where the angles of R leap.
    np.testing.assert_allclose(middle.omega, [0.0, 0.0, 0.5], atol=1e-11)
    np.testing.assert_allclose(after.t, [0.2, 0.0, 0.7], atol=1e-12)
    assert not after.v.any()
    text = TRACK.replace("paper", "exact").replace("rate = 500.0", "")
    scene.write_text(text.replace('"II"', '"path.csv"'))
    done = read_scene(scene)
    np.testing.assert_allclose(done.state.t, wanted(0.0).t)
    assert done.run().stop.reason == "completed"


def test_a_run_that_stops_says_which_leg_and_when(scene: Path, run: Run) -> None:
    robot = scene.parent / "robots" / "robot.toml"
    limits = "[legs]\nspeed_limit = 0.157\n\n[legs.lower]"
    robot.write_text(robot.read_text().replace("[legs.lower]", limits))
    scene.write_text(SWING.replace("duration = 0.1", "duration = 9").replace("v = [0.05", "v = [0.25"))
    out = run("simulate", scene, "-o", scene.parent / "out", "--no-plots").out
    assert "stopped    leg " in out
    assert "reaches its limit 0.157 m/s at " in out


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("", "", ""),
        ("[0.2, 0.0, 0.8]", "[200.0, 0.0, 800.0]", "state.t: lengths of 824.6 m compared with a machine of "),
        ("[0.1, 0.0, 0.2]", "[5.0, 0.0, 0.2]", "state.theta: 5 rad about x: in degrees, expected radians?"),
    ],
)
def test_a_start_that_is_no_machines_is_warned_of(
    scene: Path, run: Run, old: str, new: str, words: str
) -> None:
    scene.write_text(SWING.replace(old, new, 1).replace("duration = 0.1", "duration = 0.01"))
    told = [
        line
        for line in run("simulate", scene, "-o", scene.parent / "out", "--no-plots").err.splitlines()
        if str(scene) in line
    ]
    assert len(told) == bool(words)
    assert words in "".join(told)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("schema = 1", "schema = ", "not valid TOML"),
        ("duration = 0.1", "", "duration: missing"),
        ("duration = 0.1", "duraton = 0.1", 'duraton: unknown key, did you mean "duration"?'),
        ("output_step = 0.01", 'method = "Euler"', 'method: expected "DOP853", "RK45" or "Radau"'),
        (
            "stiffness = 4e4",
            "stiffness = [1, 2]",
            "actuation.stiffness: expected one number or six, got [1, 2]",
        ),
        ("stiffness = 4e4", "stiffness = -1", "actuation.stiffness: expected a number >= 0, got -1"),
        (
            "[actuation]",
            "[stop_conditions]\nmax_condition = 0.5\n[actuation]",
            "stop_conditions.max_condition: expected",
        ),
    ],
)
def test_bad_scenes_are_rejected_in_one_line_and_leave_nothing(
    scene: Path, fails: Fails, old: str, new: str, words: str
) -> None:
    assert old in SWING
    scene.write_text(SWING.replace(old, new, 1))
    before = folder_state(scene.parent)
    line = fails("simulate", scene, "-o", scene.parent / "out")
    assert words in line
    assert str(scene) in line
    assert folder_state(scene.parent) == before


def test_tracking_takes_rates_and_loads_as_the_file_has_them(scene: Path) -> None:
    """As `forces` does: those of rows so far apart that no curve through the poses has their rates."""
    motion = ss.PAPER_PATHS["II"].path.sample([0.0, 0.2, 0.4])
    F_ext, M_ext = np.array([[3.0, 1.0, -40.0]] * 3) * [[1.0], [0.5], [0.0]], np.full((3, 3), 2.0)
    loaded = dataclasses.replace(motion, F_ext=F_ext, M_ext=M_ext)
    robot = ss.Robot.from_toml(scene.parent / "robots" / "robot.toml")
    columns = trajectory_columns(robot, np.array([0.0, 0.2, 0.4]), loaded)
    (scene.parent / "path.csv").write_text("".join(csv_lines(columns)))
    scene.write_text(
        TRACK.replace('"II"', '"path.csv"').replace("paper", "exact").replace("rate = 500.0", "")
    )
    tracked, needed = read_scene(scene).run(), ss.inverse_dynamics(robot, loaded).F
    np.testing.assert_allclose(tracked.F[0], needed[0], rtol=1e-12)
    np.testing.assert_allclose(
        tracked.t[-1], followed(read_log(scene.parent / "path.csv"))(0.05).t, atol=1e-9
    )
    text = scene.read_text()
    scene.write_text(text.replace("[actuation]", "[load]\nF_ext = [0.0, 0.0, -500.0]\n[actuation]"))
    heavier = read_scene(scene).run()
    np.testing.assert_allclose(heavier.F[0], needed[0], rtol=1e-12)
    assert heavier.t[-1, 2] < tracked.t[-1, 2] - 1e-4
