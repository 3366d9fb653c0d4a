"""Kits and kernels that leave out physics of the robot file say so, with the effect on the forces."""

import dataclasses
import re
import warnings
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from machines import dasgupta
from robot_files import written

import stewart_sym as ss
from stewart_sym.kit import Choice
from stewart_sym.kit.left_out import left_out
from stewart_sym.kit.sample_poses import poses
from stewart_sym.robot.robot import Robot


def with_rotors(robot: Robot) -> Robot:
    return dataclasses.replace(robot, drive=ss.Drive(lead=5e-3, rotor_inertia=7.5e-5))


@pytest.mark.parametrize("language", ["c", "python"])
def test_generate_warns_of_rotors_left_out_with_their_effect(language: str, tmp_path: Path, run: Run) -> None:
    robot = with_rotors(dasgupta())
    written(robot, tmp_path / "robot.toml")
    command = ["generate", tmp_path / "robot.toml", "-o", tmp_path / "kit", "--language", language]
    told = run(*command, "--fidelity", "slender").err
    (line,) = [each for each in told.splitlines() if "omits" in each]
    assert f"rotors with up to {robot.m_r.max():.3g} kg of reflected mass in each leg" in line
    motion = poses(robot, "exact", 8)
    full = ss.inverse_dynamics(robot, motion).F
    with pytest.warns(UserWarning, match="omits rotors"):
        kernel = ss.prepare(robot, fidelity="slender")
    error = np.abs(kernel.forces_and_status(motion)[0] - full).max()
    found = re.search(r"differ by up to (\S+) N, (\S+) % of the largest", line)
    assert found is not None
    assert float(found[1]) == pytest.approx(error, rel=0.01)
    assert float(found[2]) == pytest.approx(100.0 * error / np.abs(full).max(), rel=0.05)
    readme = (tmp_path / "kit" / "README.md").read_text(encoding="utf-8")
    assert f"rotors with up to {robot.m_r.max():.3g} kg" in " ".join(readme.split())


def test_nothing_is_said_of_levels_that_contain_all_that_the_file_states() -> None:
    plain = dasgupta(friction=False)
    assert left_out(plain, Choice()) == ""
    assert left_out(plain, Choice(fidelity="frictionless")) == ""
    assert "friction of the joints" in left_out(dasgupta(), Choice(fidelity="frictionless"))
    assert "angular momentum of the rotors" in left_out(with_rotors(plain), Choice(fidelity="reflected"))
    with warnings.catch_warnings(action="error"):
        ss.prepare(plain, fidelity="massless")
