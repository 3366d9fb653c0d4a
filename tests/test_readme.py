"""The figures in the README are those that the code computes."""

import re
from pathlib import Path

import numpy as np
import pytest
from machines import dasgupta
from pinocchio_model import pinocchio_inverse_dynamics

import stewart_sym as ss
from stewart_sym.kernel import module

README = (Path(__file__).parent.parent / "README.md").read_text(encoding="utf-8")


def row(label: str) -> list[str]:
    """Cells of the table row that begins with ``label``."""
    found = re.search(rf"^\| {re.escape(label)} \|(.*)\|$", README, re.MULTILINE)
    assert found, label
    return [cell.strip() for cell in found[1].split("|")]


@pytest.mark.parametrize("name", ["I", "II"])
def test_paper_differs_from_pinocchio_by_what_the_readme_says(name: str) -> None:
    robot = dasgupta(friction=False)
    path, step = ss.PATHS[name]
    motion = path.sample(path.times(step))
    truth = np.array([pinocchio_inverse_dynamics(robot, motion[i]).F for i in range(motion.shape[0])])

    def error(formulation) -> float:
        F = ss.inverse_dynamics(robot, motion, formulation).F
        return float(100 * np.sqrt(np.mean((F - truth) ** 2) / np.mean(truth**2)))

    said = row(name)
    assert said[0] == f"{error('paper'):.2f} %"
    assert said[1] == "below 1e-10 %"
    assert error("exact") < 1e-10


@pytest.mark.parametrize("formulation", ["paper", "exact"])
def test_operations_in_the_readme_are_those_of_the_kernels(formulation: str) -> None:
    operations = module(formulation).OPERATIONS
    counts = [sum(operations[label]["total"]) for label in ("frictionless", "friction")]
    assert row(f"`{formulation}`") == [str(count) for count in counts]


def test_python_example_runs_as_printed() -> None:
    code = re.search(r"```python\n(.*?)```", README, re.DOTALL)
    assert code
    names: dict[str, object] = {}
    exec(code[1], names)
    assert np.isfinite(names["r"].F).all()  # type: ignore[attr-defined]


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
