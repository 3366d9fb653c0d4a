"""Control: errors are those of the model and not of the integration, and order as the models do."""

import dataclasses
import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from command_line import Fails, folder_state, read, rejects
from command_line import Run as RunCommand
from machines import dasgupta, home_position, machine_in_motion, machine_size, random_robot
from numpy.typing import NDArray
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.simulation.actuator_models import GravityCompensation, ModelTorque, along
from stewart_sym.studies.control import control
from stewart_sym.studies.control.control import CONTROLLERS, PreparedModel, Run, Settings, figures, follow

Array = NDArray[np.float64]
ZERO = np.zeros(3)
STEADY = Settings(offset_t=(0.0, 0.0, 0.0), offset_phi=(0.0, 0.0, 0.0))
FAST = ss.PAPER_PATHS["II"].path


def gap(one: Run, other: Run) -> float:
    """Largest difference of the positions, m."""
    return float(np.abs(one.t - other.t).max())


def apart(runs: dict[str, Run]) -> float:
    """Smallest difference, m, between the largest position errors of any two controllers."""
    return float(np.diff(sorted(run.position.max() for run in runs.values())).min())


def test_half_the_step_changes_nothing_that_tells_controllers_apart() -> None:
    """Over a quarter of Path II, in which its acceleration changes."""
    robot = dasgupta()
    duration = 0.15
    assert any(0.0 < time < duration for time in FAST.breakpoints())
    runs, fine = (
        follow(robot, FAST, dataclasses.replace(STEADY, step=step), duration) for step in (1e-3, 5e-4)
    )
    for name in CONTROLLERS:
        assert gap(runs[name], fine[name]) < 1e-4 * apart(runs), name


@pytest.mark.parametrize("controller", ["exact", "gravity"])
def test_runs_are_those_of_the_adaptive_integration(controller: str) -> None:
    """To 1e-9 m and rad over the first 30 ms of Path II from a start off the path."""
    robot, settings = dasgupta(), Settings()
    run = follow(robot, FAST, settings, 0.03)[controller]
    law = control.controllers(robot, along(FAST), settings)[controller]
    state = ss.Motion(R=run.R[0], t=run.t[0], omega=FAST.sample(0.0).omega, v=FAST.sample(0.0).v)
    true = ss.simulate(robot, state, law, 0.03, control_rate=settings.rate, rtol=1e-10, output_step=1e-3)
    np.testing.assert_allclose(run.t, true.t, atol=1e-9)
    np.testing.assert_allclose(run.R, true.R, atol=1e-9)
    np.testing.assert_allclose(run.F[:-1], true.F[:-1], rtol=1e-6)


def test_a_perfect_model_tracks_to_rounding_when_its_forces_are_not_held() -> None:
    """To 1e-12 m and 1e-11 rad, the tolerance of the integration, over 20 ms without a start off the path."""
    robot = dasgupta()
    law = ModelTorque(PreparedModel(robot), along(FAST), STEADY.k_p, STEADY.k_d)
    start = FAST.sample(0.0)
    run = ss.simulate(
        robot, ss.Motion(R=start.R, t=start.t, omega=ZERO, v=ZERO), law, 0.02, rtol=1e-12, atol=1e-15
    )
    wanted = FAST.sample(run.time)
    assert np.abs(run.t - wanted.t).max() < 1e-12
    assert np.abs(run.R - wanted.R).max() < 1e-11


def test_a_perfect_model_errs_by_the_hold_alone() -> None:
    """Half the hold, half the error; what remains at no hold, by extrapolation, is a hundredth at most."""
    robot = dasgupta()
    coarse, fine = (
        follow(robot, FAST, dataclasses.replace(STEADY, rate=rate), 0.04)["exact"] for rate in (2e3, 4e3)
    )
    wanted = FAST.sample(coarse.time).t
    once, twice = coarse.t - wanted, fine.t[::2] - wanted
    assert coarse.position[-1] / fine.position[::2][-1] == pytest.approx(2.0, rel=0.02)
    assert np.abs(2.0 * twice - once).max() < 0.01 * np.abs(once).max() < 1e-8


def test_on_heavy_legs_exact_errs_less_than_paper_and_paper_less_than_massless() -> None:
    robot = random_robot(np.random.default_rng(0), scale=1.0)
    heavy = {name: 3.0 * robot.M / robot.m_u.mean() * getattr(robot, name) for name in ("m_u", "I_u0")}
    robot = dataclasses.replace(robot, **heavy)
    size = machine_size(robot)
    home = home_position(robot.b, size)
    path = ss.StraightLinePath(
        tuple(home - 0.05 * size), (0.0, 0.0, -0.1), tuple(home + 0.05 * size), (0.0, 0.0, 0.1), 0.6, 0.5, 0.5
    )
    found = {name: figures(run) for name, run in follow(robot, path, STEADY, 0.3).items()}
    for measure in ("position_rms_mm", "orientation_rms_mrad"):
        exact, paper, massless = (found[name][measure] for name in CONTROLLERS[:3])
        assert exact < paper < massless, measure


def test_models_are_the_inverse_dynamics_they_are_named_after() -> None:
    robot, motion = machine_in_motion(4, load=False)
    laws = control.controllers(robot, lambda _: motion, STEADY)
    expected = {
        "exact": ss.inverse_dynamics(robot, motion).F,
        "paper": ss.inverse_dynamics(robot, motion, "paper").F,
        "massless": ss.massless_forces(robot, motion),
        "gravity": ss.inverse_dynamics(
            robot, ss.Motion(R=motion.R, t=motion.t, omega=ZERO, v=ZERO, alpha=ZERO, a=ZERO)
        ).F,
    }
    assert tuple(expected) == CONTROLLERS
    for name, F in expected.items():
        # No error, so no feedback.
        np.testing.assert_allclose(laws[name](0.0, motion), F, rtol=1e-9, atol=1e-9 * np.abs(F).max())


def test_gravity_compensation_pushes_by_the_wrench_of_its_gains() -> None:
    rng = np.random.default_rng(7)
    robot, state = machine_in_motion(rng, load=False)
    off = 0.01 * rng.normal(size=3)
    wanted = ss.Motion(R=state.R, t=state.t + off, omega=ZERO, v=ZERO, alpha=ZERO, a=ZERO)
    inertia = ss.equations_of_motion(robot, state).M
    law = GravityCompensation(PreparedModel(robot), inertia, lambda _: wanted, k_p=50.0, k_d=3.0)
    asked = inertia @ np.concatenate([50.0 * off - 3.0 * state.v, -3.0 * state.omega])
    found = ss.wrench_matrix(robot, state) @ law(0.0, state) - ss.equations_of_motion(robot, state).g
    np.testing.assert_allclose(found, asked, rtol=1e-9, atol=1e-9 * np.abs(asked).max())


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"k_p": -1.0}, "k_p: expected a finite gain >= 0"),
        ({"k_d": np.nan}, "k_d: expected a finite gain >= 0"),
        ({"inertia": np.eye(3)}, r"inertia: expected a matrix of shape \(6, 6\)"),
    ],
)
def test_bad_gains_are_named(wrong: dict[str, Any], words: str) -> None:
    robot = dasgupta()
    good = {
        "model": PreparedModel(robot),
        "inertia": np.eye(6),
        "wanted": along(FAST),
        "k_p": 1.0,
        "k_d": 1.0,
    }
    rejects(f"^{words}", GravityCompensation, **{**good, **wrong})


def test_a_controller_without_an_answer_is_named_with_path_and_time() -> None:
    light = dataclasses.replace(
        dasgupta(), p=dasgupta().p[[0, 0, 2, 2, 4, 4]], b=dasgupta().b[[0, 0, 2, 2, 4, 4]]
    )
    rejects(r"^Dasgupta & Mruthyunjaya 1998: Path II: ", control.track_paths, light, ("II",))


def test_figures_are_those_of_the_run() -> None:
    run = Run(
        time=np.arange(4.0),
        t=np.zeros((4, 3)),
        R=np.zeros((4, 3, 3)),
        F=np.array([[1.0, -7.0, 0.0, 0.0, 0.0, 0.0]] * 4),
        position=np.array([4e-3, 2e-3, 1e-3, 1e-3]),
        orientation=np.array([0.0, 0.0, 3e-3, 0.0]),
    )
    found = SimpleNamespace(**figures(run))
    assert found.position_max_mm == pytest.approx(4.0)
    assert found.position_rms_mm == pytest.approx(np.sqrt(22 / 4))
    assert found.position_settled_rms_mm == pytest.approx(1.0)
    assert found.orientation_rms_mrad == pytest.approx(1.5)
    assert found.force_peak_N == 7.0
    assert found.force_rms_N == pytest.approx(np.sqrt(50 / 6))


# The command


def test_control_writes_tables_curves_and_pictures_that_agree(tmp_path: Path, run: RunCommand) -> None:
    out = run("control", "-o", tmp_path, "--path", "II", "--rate", "200").out
    names = {"control.csv", "control.json", "control.txt", "control.png", "control_friction.png"}
    assert {path.name for path in tmp_path.glob("[!.]*")} == names | {"path_II.csv", "path_II_friction.csv"}
    assert out.startswith((tmp_path / "control.txt").read_text())
    found = json.loads((tmp_path / "control.json").read_text())
    table = read(tmp_path / "control.csv")
    rows = [row for machine in found["machines"].values() for row in machine["rows"]]
    assert [row["controller"] for row in rows] == 2 * list(CONTROLLERS)
    for row, line in zip(rows, table, strict=True):
        assert {name: line[name] for name in row} == {name: str(value) for name, value in row.items()}
    curves = np.genfromtxt(tmp_path / "path_II_friction.csv", delimiter=",", names=True)
    paper = rows[5]
    assert paper["position_max_mm"] == pytest.approx(1e3 * curves["paper_position"].max())
    assert paper["force_peak_N"] == max(np.abs(curves[f"paper_F_{leg}"]).max() for leg in range(1, 7))
    assert paper["force_peak_N_to_exact"] == pytest.approx(paper["force_peak_N"] / rows[4]["force_peak_N"])
    assert found["settings"]["rate"] == 200.0


def test_control_takes_a_robot_and_warns_of_its_limits(tmp_path: Path, run: RunCommand) -> None:
    text = PAPERS.read_text(encoding="utf-8").replace(
        "[legs.lower]", "[legs]\nforce_limit = 1000.0\n\n[legs.lower]"
    )
    file = tmp_path / "weak.toml"
    file.write_text(text.replace('Dasgupta & Mruthyunjaya 1998"', 'weak"'))
    out = tmp_path / "out"
    arguments = ["control", "-o", out, "--path", "II", "--rate", "100", "--robot", file]
    told = run(*arguments, "--no-plots").err
    assert {path.name for path in out.glob("[!.]*")} == {
        "control.csv",
        "control.json",
        "control.txt",
        "path_II.csv",
    }
    assert "weak: Path II, controller exact: force_limit exceeded by leg" in told


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--path", "III"], '--path: expected "I" or "II", got'),
        (["--rate", "0"], "--rate: expected a number > 0, got '0'"),
        (["--path", "II", "--rate", "1"], "Path II: dtau: expected a step > 0 and <= tau_f"),
        (["--robot", "missing.toml"], "missing.toml: cannot read the robot"),
        (["--path", "II", "--rate", "20"], "Path II: controller"),
    ],
)
def test_what_cannot_be_tracked_is_one_line_and_leaves_nothing(
    arguments: list[str], words: str, tmp_path: Path, fails: Fails
) -> None:
    before = folder_state(tmp_path)
    assert words in fails("control", "-o", tmp_path / "out", *arguments)
    assert folder_state(tmp_path) == before
