"""Speed against accuracy: figures are what they say, and the advice is the cheapest that is good enough."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from chart_tables import entry_of
from command_line import fails_in_one_line, folder_state
from cost_figures import SCENE, hasty
from machines import dasgupta
from plain_logs import read_log
from reduced_machines import at_rest

import stewart_sym as ss
from stewart_sym.motion.motion import Motion
from stewart_sym.precision.exact_forces import Truth, deviation
from stewart_sym.reference import newton_euler
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.accuracy.budget import papers_motions, read_budget
from stewart_sym.studies.accuracy.cost import cost
from stewart_sym.studies.common.text_tables import Figures, csv_lines

pytestmark = pytest.mark.usefixtures("quickly")

EPSILON = np.finfo(np.float64).eps


# the scene


def test_a_scene_is_what_its_file_says(scene: Path) -> None:
    time = np.linspace(0.0, 1.0, 11)
    pose = {"t_x": 0.1 + 0.05 * time, "t_y": 0 * time, "t_z": 0.5 + 0.05 * time**2}
    turn = {"theta_x": 0 * time, "theta_y": 0 * time, "theta_z": 0.1 * time}
    (scene.parent / "poses.csv").write_text("".join(csv_lines({"time": time} | pose | turn)))
    robot = Robot.from_toml(scene.parent / "robots" / "robot.toml")
    motion = read_log(scene.parent / "poses.csv").motion
    legs = ss.inverse_kinematics(robot, motion)
    columns = {"time": time} | {f"L_{leg + 1}": legs.L[:, leg] for leg in range(6)}
    (scene.parent / "legs.csv").write_text("".join(csv_lines(columns)))
    scene.write_text(SCENE.replace('"I"', '"II", "poses.csv", "legs.csv"'))
    read = read_budget(scene)
    assert (read.tolerance, read.margin, read.rate) == (0.05, 2.0, 1000.0)
    assert read.robot.name == robot.name
    assert list(read.motions) == ["II", "poses.csv", "legs.csv"]
    assert read.motions["II"].shape == (61,)
    np.testing.assert_array_equal(read.motions["poses.csv"].t, motion.t)
    np.testing.assert_allclose(read.motions["legs.csv"].t, motion.t, atol=1e-9)


def test_a_motion_through_a_singular_pose_is_told(scene: Path) -> None:
    scene.write_text(SCENE.replace('"I"', '"III"'))
    with pytest.warns(ss.SingularPoseWarning, match="path III: the path crosses a singular pose at 3.67"):
        read_budget(scene)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("schema = 1", "schema = 2", "schema: expected 1, got 2"),
        ("margin", "margn", 'margn: unknown key, did you mean "margin"?'),
        ("robots/robot.toml", "robots/none.toml", "scene.toml: robot: expected a file, there is no "),
        ('motions = ["I"]', "motions = []", "motions: expected a list of one or more of I, II, III or CSV"),
        ('["I"]', '["IV"]', "scene.toml: motions: expected a file, there is no "),
        ("tolerance = 0.05", "tolerance = 0", "tolerance: expected a number > 0, got 0"),
        ("tolerance = 0.05", "tolerance = nan", "tolerance: expected a finite number, got nan"),
        ("tolerance = 0.05", "", "tolerance: missing"),
        ("margin = 2", "margin = 0.5", "margin: expected a number >= 1, got 0.5"),
    ],
)
def test_bad_scenes_are_rejected_in_one_line_and_leave_nothing(
    scene: Path, capsys: pytest.CaptureFixture[str], old: str, new: str, words: str
) -> None:
    assert old in SCENE
    scene.write_text(SCENE.replace(old, new, 1))
    before = folder_state(scene.parent)
    line = fails_in_one_line(capsys, "chart", scene, "-o", scene.parent / "out")
    assert words in line
    assert str(scene) in line
    assert folder_state(scene.parent) == before


# 50 digits


# the figures


def model_errors(robot: Robot, motion: Motion) -> dict[str, tuple[float, float]]:
    """Largest and RMS errors of some fidelities and of `paper`, from the slow reference alone."""
    smooth = dataclasses.replace(robot, **dict.fromkeys(("C_u", "C_p", "C_s"), np.zeros(6)))
    true = newton_euler.inverse_dynamics(robot, motion).F
    forces = {
        "paper": newton_euler.inverse_dynamics(robot, motion, newton_euler.PAPER).F,
        "frictionless": newton_euler.inverse_dynamics(smooth, motion).F,
        "general_static": newton_euler.inverse_dynamics(smooth, at_rest(motion)).F,
        "massless": newton_euler.massless_forces(robot, motion),
        "massless_static": newton_euler.massless_forces(robot, at_rest(motion)),
    }
    peak = np.abs(true).max()
    return {
        name: (np.abs(F - true).max() / peak, np.sqrt(np.mean((F - true) ** 2)) / peak)
        for name, F in forces.items()
    }


@pytest.mark.slow
@pytest.mark.parametrize("path", ["I", "II", "III"])
def test_model_errors_are_those_of_the_reference(found: Figures, path: str) -> None:
    for name, expected in model_errors(dasgupta(), papers_motions()[path]).items():
        of = ("paper", "general") if name == "paper" else ("exact", name)
        for precision in ("double", "float"):
            errors = entry_of(found, *of, precision)["errors"][path]
            assert (errors["model"], errors["model_rms"]) == pytest.approx(expected, rel=1e-6)


def peak_of(found: Figures, path: str) -> float:
    return float(found["motions"][path]["peak_force_N"])


@pytest.mark.slow
def test_rounding_errors_are_those_beside_50_digits(found: Figures) -> None:
    robot, motions = dasgupta(), papers_motions()
    for name in ("general", "slender", "massless_static"):
        for precision, epsilon in (("double", EPSILON), ("float", np.finfo(np.float32).eps)):
            errors, peak = entry_of(found, "exact", name, precision)["errors"]["I"], peak_of(found, "I")
            F = ss.ForceKernel(robot, "exact", precision, name).forces(motions["I"][:3])  # type: ignore[arg-type]
            off = np.abs(deviation(F, Truth(robot, "exact", name).forces(motions["I"][:3]))).max()
            # Three poses of those that were sampled or are like them.
            assert 0.2 * off <= errors["rounding"] * peak <= 100 * epsilon * peak


@pytest.mark.slow
def test_other_implementations_are_near_the_truth(found: Figures) -> None:
    assert [each["name"] for each in found["implementations"]] == [
        "every output",
        "NumPy kernel",
        "vector reference",
    ]
    for each in found["implementations"]:
        assert each["ns"] > 0.0
        assert 0.0 < each["rounding"]["I"] < 1e-13


def test_a_motion_without_forces_is_rejected(monkeypatch: pytest.MonkeyPatch) -> None:
    hasty(monkeypatch)
    robot = dataclasses.replace(dasgupta(), g=np.zeros(3))
    with pytest.raises(ValueError, match="still: all forces are zero"):
        cost(robot, {"still": at_rest(papers_motions()["I"])})


@pytest.mark.slow
def test_constants_that_float_cannot_hold_leave_float_out(monkeypatch: pytest.MonkeyPatch) -> None:
    hasty(monkeypatch)
    robot = dataclasses.replace(dasgupta(), M=1e39)
    made = cost(robot, {"I": papers_motions()["I"][:4]})
    assert {entry["precision"] for entry in made["candidates"]} == {"double"}
