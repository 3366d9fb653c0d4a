"""The figures in the README and in the documentation are those that the code computes."""

import json
import re
from typing import Any

import numpy as np
import published
import pytest
from benchmark_tables import FORWARD, PLAIN
from machines import dasgupta, machine_in_motion
from numpy.typing import NDArray
from pages import DOCS, TOP, prose_of, table_row
from pinocchio_model import pinocchio_inverse_dynamics

import stewart_sym as ss
from stewart_sym.backend.kernel import module, operations_per_pose
from stewart_sym.reference import newton_euler
from stewart_sym.studies.accuracy.budget import papers_motions
from stewart_sym.studies.benchmark.benchmark import of_group
from stewart_sym.studies.benchmark.cases import EQUATIONS
from stewart_sym.studies.paper.reproduce import work_energy

FAULTS, CHECKS = ".docs/explanation/faults.md", ".docs/explanation/checks.md"
REWRITE = f"run `{published.COMMAND}` and look at what changed"


def rms(difference: NDArray[np.float64], truth: NDArray[np.float64]) -> float:
    """RMS of the difference in per cent of the RMS of the truth."""
    return float(100 * np.sqrt(np.mean(difference**2) / np.mean(truth**2)))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["I", "II"])
def test_paper_differs_from_pinocchio_on_the_paths_by_what_the_page_says(name: str) -> None:
    robot = dasgupta(friction=False)
    path, step = ss.PAPER_PATHS[name]
    motion = path.sample(path.time_grid(step))
    truth = np.array([pinocchio_inverse_dynamics(robot, motion[i]).F for i in range(motion.shape[0])])
    paper, exact = (rms(ss.inverse_dynamics(robot, motion, f).F - truth, truth) for f in ("paper", "exact"))
    assert table_row(FAULTS, name)[:2] == [f"{paper:.2f} %", "below 1e-10 %"]
    assert exact < 1e-10


@pytest.mark.parametrize("name", ["I", "II"])
def test_work_differs_from_energy_by_what_the_page_says(name: str) -> None:
    robot = dasgupta(friction=False)
    paper, exact = (100 * work_energy(robot, name, form)["mismatch"] for form in ("paper", "exact"))
    assert table_row(FAULTS, name)[2:] == [f"{paper:.2f} %", "below 1e-10 %"]
    assert abs(exact) < 1e-10


@pytest.mark.slow
def test_paper_differs_from_pinocchio_on_random_machines_by_what_the_page_says() -> None:
    errors = []
    for seed in range(60):
        robot, motion = machine_in_motion(seed, (3,))
        truth = np.array([pinocchio_inverse_dynamics(robot, motion[i]).F for i in range(3)])
        errors.append(rms(ss.inverse_dynamics(robot, motion, "paper").F - truth, truth))
    said = re.search(r"off by (\d+) % at least and by (\d+) % in the median", prose_of(FAULTS))
    assert said
    assert [int(said[1]), int(said[2])] == [round(min(errors)), round(float(np.median(errors)))]


@pytest.mark.parametrize("formulation", ["paper", "exact"])
def test_operations_in_the_table_are_those_of_the_kernels(formulation: str) -> None:
    kernel = module(formulation)
    for label, counts in (("", kernel.OPERATIONS), (", forces alone", kernel.FORCE_OPERATIONS)):
        totals = [str(sum(counts[kind]["total"])) for kind in ("frictionless", "friction")]
        assert table_row(CHECKS, f"`{formulation}`{label}") == totals


def figures(study: str = "bench") -> dict[str, Any]:
    """What the committed run of a study wrote."""
    text = (DOCS / f"{study}.json").read_text(encoding="utf-8")
    found: dict[str, Any] = json.loads(text)
    return found


def test_every_table_is_what_the_study_writes_of_its_figures() -> None:
    files = published.written(TOP)
    assert {path.name for path in files} == {
        "README.md",
        *(path.name for path in (DOCS / "tables").iterdir()),
    }
    assert [path for path, text in files.items() if path.read_text(encoding="utf-8") != text] == [], REWRITE


def test_the_committed_run_keeps_what_the_kernels_promise() -> None:
    found = figures()
    medians = {case["name"]: case["median"] for case in found["cases"]}
    assert medians["one pose"] <= 0.33 * medians[PLAIN]
    assert medians["batch, one core"] <= 0.11 * medians[PLAIN]
    # A call from Python takes 25 us at most beside what its poses take.
    assert 1_000 * (medians["1,000 poses"] - medians["1,000,000 poses"]) <= 25_000
    engines = [case["median"] for case in of_group(found, EQUATIONS) if case["package"]]
    assert min(engines) >= 20 * medians[FORWARD]


@pytest.mark.slow
def test_the_committed_chart_is_what_the_code_computes() -> None:
    robot, motions = dasgupta(), papers_motions()
    for each in figures("chart")["candidates"]:
        how = each["formulation"], each["fidelity"]
        assert each["operations"] == operations_per_pose(robot, *how)
        for path, motion in motions.items():
            true = newton_euler.inverse_dynamics(robot, motion).F
            off = np.abs(ss.ForceKernel(robot, how[0], "double", how[1]).forces(motion) - true).max()
            assert off / np.abs(true).max() == pytest.approx(
                each["errors"][path]["model"], rel=1e-6, abs=1e-12
            )
