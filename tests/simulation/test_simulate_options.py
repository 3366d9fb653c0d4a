"""Runs that saturate, start on their path, tell how far they are, and draw only what there is."""

import dataclasses
import json
import pickle
import shutil
import warnings
from pathlib import Path

import numpy as np
import pytest
from command_files import edit
from command_line import Fails, Run
from machines import dasgupta, home_position, machine_size, random_robot
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.simulation.actuator_models import along
from stewart_sym.simulation.scene import read_scene
from stewart_sym.studies.reports.simulation_report import report, summary

pytestmark = pytest.mark.filterwarnings("ignore::stewart_sym.RobotWarning")
ZERO = np.zeros(3)
TRACK = """
schema = 1
robot = "robot.toml"
duration = 0.02
initial_state = "path"
on_force_limit = "saturate"
[actuation]
type = "computed_torque"
path = "I"
k_p = 400
k_d = 40
rate = 500.0
"""


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    shutil.copy(PAPERS, tmp_path / "robot.toml")
    path = tmp_path / "scene.toml"
    path.write_text(TRACK)
    return path


def limit_forces(scene: Path, limit: float) -> None:
    defaults = "[legs.lower]\n"
    edit(scene.parent / "robot.toml", defaults, f"[legs]\nforce_limit = {limit}\n{defaults}")


def machine() -> tuple[ss.Robot, ss.Motion]:
    robot = random_robot(np.random.default_rng(3), scale=1.0)
    return robot, ss.Motion(R=np.eye(3), t=home_position(robot.b, machine_size(robot)), omega=ZERO, v=ZERO)


@pytest.mark.parametrize("rate", [None, 200.0])
def test_clipped_forces_move_the_machine_as_given_ones_do(rate: float | None) -> None:
    """A law beyond its limits in legs 2 and 5, one after the other: the run of the clipped law itself."""
    robot, state = machine()
    hold = ss.inverse_dynamics(
        robot, ss.Motion(R=state.R, t=state.t, omega=ZERO, v=ZERO, alpha=ZERO, a=ZERO)
    ).F
    limit = np.abs(hold) + 50.0
    limited = dataclasses.replace(robot, force_limit=limit)

    def law(time: float, _: ss.Motion) -> np.ndarray:
        F = hold.copy()
        F[1] = limit[1] + 30.0 if time < 0.05 else hold[1]
        F[4] = -limit[4] - 100.0 * (time - 0.05) if time >= 0.05 else hold[4]
        return F

    run = ss.simulate(
        limited, state, law, 0.1, control_rate=rate, on_force_limit="saturate", output_step=0.01
    )
    clipped = ss.simulate(
        robot,
        state,
        lambda time, at: np.clip(law(time, at), -limit, limit),
        0.1,
        control_rate=rate,
        output_step=0.01,
    )
    assert run.stop.reason == "completed"
    np.testing.assert_allclose(run.t, clipped.t, atol=1e-9)
    assert (np.abs(run.F) <= limit).all()
    np.testing.assert_allclose(
        run.saturation.max_excess[[1, 4]], [30.0, 5.0 if rate is None else 4.5], rtol=1e-6
    )
    np.testing.assert_allclose(run.saturation.duration[[1, 4]], 0.05, atol=5e-3)
    assert not run.saturation.max_excess[[0, 2, 3, 5]].any()
    assert not run.saturation.duration[[0, 2, 3, 5]].any()
    assert "saturated  leg 2 for 0.05" in summary(limited, run, run.dense_history, law)
    stopped = ss.simulate(limited, state, law, 0.1, control_rate=rate)
    assert (stopped.stop.reason, stopped.stop.leg, stopped.stop.time) == ("force_limit", 2, 0.0)
    assert not stopped.saturation.max_excess.any()


@pytest.mark.parametrize(("output_step", "rtol"), [(None, 1e-9), (0.003, 1e-9)])
def test_motors_of_held_forces_do_the_work_of_each_held_force(output_step: float | None, rtol: float) -> None:
    """Force times change of length between the samples, and the heat of the winding."""
    robot, state = machine()
    drive = ss.Drive(lead=5e-3, torque_constant=0.5, resistance=2.0)
    robot = dataclasses.replace(robot, drive=drive)
    hold = ss.inverse_dynamics(
        robot, ss.Motion(R=state.R, t=state.t, omega=ZERO, v=ZERO, alpha=ZERO, a=ZERO)
    ).F

    def law(time: float, _: ss.Motion) -> np.ndarray:
        return hold * (1.0 + 0.3 * np.sin(40.0 * time + np.arange(6)))

    run = ss.simulate(robot, state, law, 0.1, control_rate=50.0, output_step=output_step, rtol=rtol)
    samples = np.linspace(0.0, 0.1, 6)
    L, F = run.at(samples).L, np.array([law(time, state) for time in samples[:-1]])
    heat = 2.0 * (F / drive.transmission_ratio / 0.5) ** 2 * 0.02
    expected = np.sum(F * np.diff(L, axis=0) + heat, axis=0)
    found = [leg["motor_energy_J"] for leg in report(robot, run, law).data["legs"]]
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-6 * np.abs(expected).max())


def test_a_law_that_follows_a_path_starts_on_it() -> None:
    robot = dasgupta()
    path = ss.PAPER_PATHS["I"].path
    law = ss.ComputedTorque(robot, along(path), k_p=400.0, k_d=40.0)
    run = ss.simulate(robot, "path", law, 0.02, control_rate=500.0)
    sent = pickle.loads(pickle.dumps(ss.ComputedTorque(robot, path.sample, k_p=400.0, k_d=40.0)))
    np.testing.assert_array_equal(sent(0.01, run.motion[1]), law(0.01, run.motion[1]))
    np.testing.assert_array_equal(run.t[0], path.sample(0.0).t)
    np.testing.assert_allclose(run.R[0], path.sample(0.0).R, atol=1e-15)
    for start, other in (("path", np.zeros(6)), ("home", law)):
        with pytest.raises(ValueError, match=r'^initial_state: expected a Motion, or "path" with a law'):
            ss.simulate(robot, start, other, 0.02)
    with pytest.raises(ValueError, match=r'^on_force_limit: expected "stop" or "saturate", got "clip"|clip'):
        ss.simulate(robot, "path", law, 0.02, on_force_limit="clip")


def test_a_scene_starts_on_its_path_and_saturates(scene: Path, run: Run) -> None:
    found = read_scene(scene).run()
    limit = float(np.abs(found.F).max()) - 5.0
    limit_forces(scene, limit)
    done = read_scene(scene)
    assert done.on_force_limit == "saturate"
    np.testing.assert_array_equal(done.state.t, ss.PAPER_PATHS["I"].path.sample(0.0).t)
    out = run("simulate", scene, "-o", scene.parent / "out", "--no-plots").out
    assert "N beyond its limit" in out
    error = ss.tracking_error(done.run().dense_history, done.reference)
    written = json.loads((scene.parent / "out/summary.json").read_text())["tracking_error"]
    assert [row.get("peak_m", row.get("peak_rad")) for row in written] == pytest.approx(error.peak.tolist())
    assert f"{error.rms[0]:.3g} m" in out


def test_a_run_that_stops_at_its_start_is_an_error_and_writes_nothing(scene: Path, fails: Fails) -> None:
    limit_forces(scene, 1e-3)
    scene.write_text(TRACK.replace('"saturate"', '"stop"'))
    line = fails("simulate", scene, "-o", scene.parent / "out", "--no-plots")
    assert line.startswith(f"stewart-sym: error: {scene}: ")
    assert "reaches its limit 0.001 N at 0 s" in line
    assert not (scene.parent / "out").exists()


def test_warnings_about_the_robot_name_the_robot_file(scene: Path, run: Run) -> None:
    limit_forces(scene, 1e-3)
    with warnings.catch_warnings():
        warnings.simplefilter("default")
        err = run("simulate", scene, "-o", scene.parent / "out", "--no-plots").err
    assert f"warning: {scene.parent / 'robot.toml'}: " in err


def test_progress_is_told_in_shares_that_end_at_one() -> None:
    rate = 200.0
    robot, state = machine()
    shares: list[float] = []
    ss.simulate(robot, state, np.zeros(6), 0.05, control_rate=rate, progress=shares.append)
    assert len(shares) > 1
    assert shares == sorted(shares)
    assert shares[0] > 0.0
    assert shares[-1] == pytest.approx(1.0)
    with pytest.raises(ValueError, match=r"^progress: expected a function \(fraction\), got int"):
        ss.simulate(robot, state, np.zeros(6), 0.05, progress=3)
