"""The figures in the README are those that the code computes."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from machines import dasgupta, random_motion, random_robot
from numpy.typing import NDArray
from pinocchio_model import pinocchio_inverse_dynamics

import stewart_sym as ss
from stewart_sym import reference
from stewart_sym.kernel import module
from stewart_sym.studies.reproduce import work_energy

README_FOLDER = Path(__file__).parent.parent
README = (README_FOLDER / "README.md").read_text(encoding="utf-8")


def row(label: str) -> list[str]:
    """Cells of the table row that begins with ``label``."""
    found = re.search(rf"^\| {re.escape(label)} \|(.*)\|$", README, re.MULTILINE)
    assert found, label
    return [cell.strip() for cell in found[1].split("|")]


def rms(difference: NDArray[np.float64], truth: NDArray[np.float64]) -> float:
    """RMS of the difference in per cent of the RMS of the truth."""
    return float(100 * np.sqrt(np.mean(difference**2) / np.mean(truth**2)))


@pytest.mark.parametrize("name", ["I", "II"])
def test_paper_differs_from_pinocchio_on_the_paths_by_what_the_readme_says(name: str) -> None:
    robot = dasgupta(friction=False)
    path, step = ss.PATHS[name]
    motion = path.sample(path.times(step))
    truth = np.array([pinocchio_inverse_dynamics(robot, motion[i]).F for i in range(motion.shape[0])])
    paper, exact = (rms(ss.inverse_dynamics(robot, motion, f).F - truth, truth) for f in ("paper", "exact"))
    assert row(name)[:2] == [f"{paper:.2f} %", "below 1e-10 %"]
    assert exact < 1e-10


@pytest.mark.parametrize("name", ["I", "II"])
def test_work_differs_from_energy_by_what_the_readme_says(name: str) -> None:
    robot = dasgupta(friction=False)
    paper, exact = (
        100 * (found.work - found.gain) / found.gain
        for found in (work_energy(robot, name, faults) for faults in (reference.PAPER, reference.EXACT))
    )
    assert row(name)[2:] == [f"{paper:.2f} %", "below 1e-10 %"]
    assert abs(exact) < 1e-10


def test_paper_differs_from_pinocchio_on_random_machines_by_what_the_readme_says() -> None:
    errors = []
    for seed in range(60):
        rng = np.random.default_rng(seed)
        robot = random_robot(rng)
        motion = random_motion(rng, robot, (3,))
        truth = np.array([pinocchio_inverse_dynamics(robot, motion[i]).F for i in range(3)])
        errors.append(rms(ss.inverse_dynamics(robot, motion, "paper").F - truth, truth))
    said = re.search(r"off by (\d+) % at least and by (\d+) % in the\s+median", README)
    assert said
    assert [int(said[1]), int(said[2])] == [round(min(errors)), round(float(np.median(errors)))]


def test_fault_2_costs_at_rest_what_the_readme_says() -> None:
    robot = dasgupta(friction=False)
    path, step = ss.PATHS["I"]
    moving = path.sample(path.times(step))
    zero = np.zeros_like(moving.t)
    rest = ss.Motion(moving.R, moving.t, zero, zero, zero, zero)
    truth = reference.inverse_dynamics(robot, rest).F
    error = rms(reference.inverse_dynamics(robot, rest, frozenset({2})).F - truth, truth)
    assert f"Fault 2 acts even at rest: {error:.2f} %" in README


@pytest.mark.parametrize("formulation", ["paper", "exact"])
def test_operations_in_the_readme_are_those_of_the_kernels(formulation: str) -> None:
    kernel = module(formulation)
    for label, counts in (("", kernel.OPERATIONS), (", forces alone", kernel.FORCE_OPERATIONS)):
        totals = [str(sum(counts[kind]["total"])) for kind in ("frictionless", "friction")]
        assert row(f"`{formulation}`{label}") == totals


def test_times_in_the_readme_are_those_of_the_benchmark() -> None:
    found = json.loads((README_FOLDER / ".docs" / "bench.json").read_text(encoding="utf-8"))
    for figure in (*found["ours"], *found["peers"]):
        assert row(figure["name"]) == [f"{figure['median']:.0f}", f"{figure['ratio_to_casadi']:.2f}"]


def test_python_example_runs_as_printed() -> None:
    blocks = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    names: dict[str, Any] = {}
    exec("\n".join(blocks), names)
    assert np.isfinite(names["r"].F).all()
    assert names["status"] == 0


def test_robot_example_is_a_valid_robot_file(tmp_path: Path) -> None:
    text = re.search(r"```toml\n(.*?)```", README, re.DOTALL)
    assert text
    head, leg = text[1].split("[[leg]]")
    legs = []
    for angle in np.radians([0, 60, 120, 180, 240, 300]):
        point = f"[{np.cos(angle):.3f}, {np.sin(angle):.3f}, 0.0]"
        legs.append("[[leg]]" + re.sub(r"base_point = \[.*?\]", f"base_point = {point}", leg, count=1))
    path = tmp_path / "hexapod.toml"
    path.write_text(head + "\n".join(legs))
    assert ss.Robot.from_toml(path).name == "hexapod"
