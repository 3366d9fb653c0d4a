"""Kits, kernels, and exports that omit physics of the robot file warn, with the effect on the forces."""

import dataclasses
import re
import warnings
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from kits import few_vectors
from machines import dasgupta
from robot_files import written

import stewart_sym as ss
from stewart_sym.dynamics.sample_poses import poses
from stewart_sym.robot.robot import Robot

LOSSY = ss.Drive(lead=5e-3, rotor_inertia=7.5e-5, efficiency=0.7, screw_coulomb=50.0)


def with_rotors(robot: Robot) -> Robot:
    return dataclasses.replace(robot, drive=ss.Drive(lead=5e-3, rotor_inertia=7.5e-5))


def check_effect(line: str, found: np.ndarray, full: np.ndarray) -> None:
    """Compare the numbers of a warning with two arrays of forces (N)."""
    error, largest = np.abs(found - full).max(), np.abs(full).max()
    effect = re.search(r"differ by up to (\S+) N, (\S+) % of the largest", line)
    assert effect is not None, line
    assert float(effect[1]) == pytest.approx(error, rel=0.01)
    assert float(effect[2]) == pytest.approx(100.0 * error / largest, rel=0.05)


@pytest.mark.parametrize("options", [[], pytest.param(["--bake", "--fmu"], marks=pytest.mark.slow)])
def test_generate_and_prepare_warn_of_omitted_rotors_with_the_same_effect(
    options: list[str], tmp_path: Path, run: Run
) -> None:
    robot = with_rotors(dasgupta())
    written(robot, tmp_path / "robot.toml")
    command = ["generate", tmp_path / "robot.toml", "-o", tmp_path / "kit", *options]
    with few_vectors():
        told = run(*command, "--fidelity", "slender").err
    (line,) = [each for each in told.splitlines() if "omits" in each]
    assert f"rotors with up to {robot.reflected_mass.max():.3g} kg of reflected mass in each leg" in line
    with pytest.warns(UserWarning, match="omits physics") as caught:
        kernel = ss.ForceKernel(robot, fidelity="slender")
    assert str(caught[0].message).partition("; for all")[0] in line
    motion = poses(robot, "exact", 8)
    check_effect(line, kernel.forces(motion), ss.inverse_dynamics(robot, motion).F)
    readme = (tmp_path / "kit" / "README.md").read_text(encoding="utf-8")
    assert f"rotors with up to {robot.reflected_mass.max():.3g} kg" in " ".join(readme.split())


@pytest.mark.parametrize(
    ("friction", "rotors", "level", "named"),
    [
        (False, False, "frictionless", ""),
        (True, False, "frictionless", "friction of the joints"),
        (False, True, "reflected", "angular momentum of the rotors"),
        (False, False, "massless", "legs without mass"),
    ],
)
def test_prepare_names_the_physics_that_a_level_omits(
    friction: bool, rotors: bool, level: str, named: str
) -> None:
    robot = dasgupta(friction=friction)
    with warnings.catch_warnings(record=True, action="always") as caught:
        ss.ForceKernel(with_rotors(robot) if rotors else robot, fidelity=level)
    lines = [str(each.message) for each in caught]
    assert len(lines) == bool(named)
    assert all(named in line and "forces differ by up to" in line for line in lines)


@pytest.mark.parametrize(("form", "cross"), [("mjcf", 0.0), ("sdf", 0.0), ("drake", 0.01), ("usd", 0.01)])
@pytest.mark.filterwarnings("ignore::stewart_sym.RobotWarning")
def test_export_states_the_effect_of_physics_without_a_place(form: str, cross: float) -> None:
    robot = dataclasses.replace(dasgupta(), drive=LOSSY)
    motion = poses(robot, "exact", 8)
    if cross:
        robot = dataclasses.replace(robot, offsets=ss.JointOffsets(axis_offset=cross))
    full = ss.inverse_dynamics(robot, motion).F
    effort = ss.drive_effort(robot, motion)
    found = {
        "friction of spherical joints": (dataclasses.replace(robot, C_s=0.0), full),
        "friction of drives": (robot, effort.force),
    }
    if form in ("sdf", "drake"):
        found["inertia of rotors"] = (dataclasses.replace(robot, drive=None), full)
    with pytest.warns(UserWarning, match="no place") as caught:
        ss.export_model(robot, form)
    lines = [str(each.message) for each in caught if "forces differ" in str(each.message)]
    assert ("angular momentum of rotors" in "".join(lines)) == (form in ("mjcf", "usd"))
    for name, (reduced, exact) in found.items():
        (line,) = [each for each in lines if name in each]
        check_effect(line, ss.inverse_dynamics(reduced, motion).F, exact)


@pytest.mark.parametrize("physics", ["rotors", "offsets"])
def test_paper_rejects_physics_that_its_equations_omit(physics: str, tmp_path: Path) -> None:
    robot = with_rotors(dasgupta())
    if physics == "offsets":
        robot = dataclasses.replace(dasgupta(), offsets=ss.JointOffsets(axis_offset=0.01))
    motion = poses(dasgupta(), "exact", 2)
    for call in (ss.inverse_dynamics, ss.simulate, ss.ForceKernel):
        arguments = {ss.inverse_dynamics: (motion,), ss.simulate: (motion[0], np.zeros(6), 0.1)}.get(call, ())
        with pytest.raises(ValueError, match='formulation: expected "exact" for a robot'):
            call(robot, *arguments, formulation="paper")
