"""Noise of leg lengths and of poses of a tool point: the deviations of the parameters hold."""

import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from robot_files import PAPERS
from sweeps import FULL

import stewart_sym as ss
from stewart_sym.identification.measured_files import Measurement, noise_of_log
from stewart_sym.identification.measured_forces import from_measurement
from stewart_sym.motion.rotation import rotation_from_vector
from stewart_sym.motion.trajectory import Trajectory

TOOL = np.array([0.1, -0.2, 0.6])
LINES = np.arange(2, 122)


@pytest.fixture(scope="module")
def robot() -> ss.Robot:
    return dataclasses.replace(ss.robots.dasgupta1998(), tool=TOOL)


@pytest.fixture(scope="module")
def excited(robot: ss.Robot) -> ss.Excitation:
    return ss.choose_excitation(robot, samples=120, candidates=5)


def test_noisy_poses_of_the_tool_are_taken_as_measured(robot: ss.Robot, excited: ss.Excitation) -> None:
    rng = np.random.default_rng(3)
    sigma, position, angle = 0.5, 2e-5, 2e-5
    exact = excited.motion.at_point(TOOL)
    R = rotation_from_vector(angle * rng.normal(size=(120, 3))) @ exact.R
    measured = ss.Motion(R=R, t=exact.t + position * rng.normal(size=(120, 3)), omega=exact.omega, v=exact.v)
    F = ss.inverse_dynamics(robot, excited.motion).F + sigma * rng.normal(size=(120, 6))
    trajectory = Trajectory(excited.time, measured.at_point(-TOOL), "log.csv", tuple(LINES.tolist()))
    noise = noise_of_log(robot, trajectory, (position, angle), excited.path.period)
    assert noise is not None
    assert noise.position > position
    measurement = Measurement(trajectory, excited.time, F, np.array(sigma), "F.csv", LINES, noise)
    found = from_measurement(robot, measurement)
    assert found.verdict == "consistent", found.warnings
    off = (found.values - found.base.matrix @ ss.inertial_parameters(robot).values) / found.std
    assert np.abs(off).max() < 4.5
    assert 0.75 < np.sqrt(np.mean(off**2)) < 1.25
    assert found.compare_with(robot)[1] > 1e-3


def test_undetermined_parameters_and_a_wrong_force_are_named(robot: ss.Robot, excited: ss.Excitation) -> None:
    trajectory = Trajectory(excited.time, excited.motion, "log.csv", tuple(LINES.tolist()))
    F = ss.inverse_dynamics(robot, excited.motion).F
    F[[18, 40], 1] += 1e4, 9e3
    for sigma, words in (
        (1e9, "parameters: none is determined"),
        (1.0, "F.csv: largest residual: leg 2 at "),
    ):
        measurement = Measurement(trajectory, excited.time, F, np.array(sigma), "F.csv", LINES)
        found = from_measurement(robot, measurement)
        (line,) = (line for line in found.warnings if line.startswith(words))
    assert " s, line 20: " in line
    assert any(" of 120 samples, more than 1 %, differ from the model" in line for line in found.warnings)


@pytest.fixture(scope="module")
def lengths(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """Options of ``identify``: leg lengths with noise of 0.02 mm, and forces with noise of 0.5 N."""
    machine, rng = ss.Robot.from_toml(PAPERS), np.random.default_rng(3)
    way = ss.choose_excitation(machine, harmonics=3, samples=800, candidates=5)
    L = ss.inverse_kinematics(machine, way.motion).L + 2e-5 * rng.normal(size=(800, 6))
    F = ss.inverse_dynamics(machine, way.motion).F + 0.5 * rng.normal(size=(800, 6))
    folder = tmp_path_factory.mktemp("lengths")
    for name, values in (("L", L), ("F", F)):
        head = ",".join(["time", *(f"{name}_{leg}" for leg in range(1, 7))])
        rows = np.column_stack([way.time, values])
        np.savetxt(folder / f"{name}.csv", rows, "%.17g", ",", header=head, comments="")
    return ["--measured", str(folder / "L.csv"), str(folder / "F.csv"), "--force-std", "0.5"]


@pytest.mark.slow
@pytest.mark.parametrize("stated", [True, False] if FULL else [False])
def test_noise_of_leg_lengths_is_noise_along_the_legs(
    lengths: list[str], stated: bool, tmp_path: Path, run: Run
) -> None:
    options = ["--position-std", "2e-5"] * stated
    run("identify", PAPERS, *lengths, *options, "-o", tmp_path / "out")
    found = json.loads((tmp_path / "out" / "report.json").read_text())
    assert (found["verdict"], found["robot_file"]["agreement"]) == ("consistent", "agrees")
    assert found["normalized_residual"] == pytest.approx(1.0, abs=0.06)
    off = np.array([row["departure"] for row in found["parameters"]])
    assert np.abs(off).max() < 4.0
    assert 0.75 < np.sqrt(np.mean(off**2)) < 1.25
