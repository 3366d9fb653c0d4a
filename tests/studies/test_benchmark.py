"""`benchmark`: all cases compute the same results, wrong ones stop the run, and the figures are right."""

import dataclasses
import json
import re
from pathlib import Path
from typing import Any

import benchmark_tables
import numpy as np
import pytest
from command_line import rejects
from machines import dasgupta, random_motion, random_robot
from motion_fields import FIELDS
from quick_compiler import compile_quickly
from robot_files import PAPERS

from stewart_sym.calls.threads import MIN_POSES_PER_THREAD
from stewart_sym.cli.main import main
from stewart_sym.io.progress import silent
from stewart_sym.reference import newton_euler
from stewart_sym.studies.benchmark import benchmark, cases
from stewart_sym.studies.benchmark.benchmark import of_group
from stewart_sym.studies.benchmark.cases import SIZES, Poses, bench_poses
from stewart_sym.studies.common import timing


def shorten(patch: pytest.MonkeyPatch) -> None:
    """Samples so short that the figures mean nothing."""
    compile_quickly(patch)
    patch.setattr(cases, "LARGE", 2 * MIN_POSES_PER_THREAD)
    patch.setattr(cases, "QUICK_BATCHES", (8, 64))
    patch.setattr(timing, "SHORTEST", 1e-5)
    patch.setattr(benchmark, "QUICK_ROUNDS", 3)


@pytest.fixture(scope="module", params=[pytest.param("robot", marks=pytest.mark.slow)])
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the command wrote of a robot file."""
    folder = tmp_path_factory.mktemp("bench")
    file = folder / "mine.toml"
    file.write_text(PAPERS.read_text().replace('name = "Dasgupta & Mruthyunjaya 1998"', 'name = "mine"'))
    with pytest.MonkeyPatch.context() as patch:
        shorten(patch)
        assert main(["benchmark", "--quick", "--robot", str(file), "-o", str(folder / "new")]) == 0
    return folder / "new"


@pytest.fixture(scope="module")
def figures(written: Path) -> dict[str, Any]:
    """The JSON."""
    found: dict[str, Any] = json.loads((written / "bench.json").read_text())
    return found


# what is compared


@pytest.mark.slow
def test_all_cases_and_other_programs_agree_on_any_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    import compare_engines

    shorten(monkeypatch)
    rng = np.random.default_rng(8)
    robot = random_robot(rng)
    motion = random_motion(rng, robot, (70,))
    poses = Poses(robot, tuple(np.ascontiguousarray(getattr(motion, name)) for name in FIELDS))
    truth = newton_euler.inverse_dynamics(robot, motion).F
    made = [*cases.all_cases(poses, truth, True, silent), *compare_engines.compared(poses, truth)]
    assert {case.package for case in made} == {None, "CasADi", "Pinocchio", "MuJoCo"}
    for case in made:
        assert case.difference() <= case.tolerance
        wrong = dataclasses.replace(case, expected=case.expected * (1 + 3 * case.tolerance))
        rejects(f"^{re.escape(case.name)}: results differ", wrong.difference)
        for task in case.tasks:
            task.run(1)


def test_machines_without_poses_or_universal_joints_are_rejected() -> None:
    robot = random_robot(np.random.default_rng(3), "spherical")
    rejects("expected universal base joints", bench_poses, robot, 10)
    none = dataclasses.replace(dasgupta(), p=np.tile(dasgupta().p[:1], (6, 1)))
    rejects("no regular poses", bench_poses, none, 10)


# what is said


def test_every_case_has_positive_figures_and_its_row(figures: dict[str, Any], written: Path) -> None:
    text = (written / "bench.txt").read_text()
    assert figures["robot"] == "mine"
    for case in figures["cases"]:
        low, high = case["quartiles"]
        assert low <= case["median"] <= high
        assert case["median"] > 0
        assert len(case["raw"]) == figures["rounds"] == 3
        assert case["name"] in text
    assert [each["poses"] for each in of_group(figures, SIZES)] == [8, 64]
    assert {"-O3", "-ffp-contract=off"} <= set(figures["software"]["flags"])
    assert "nan" not in text


def test_a_run_without_other_programs_gives_no_tables() -> None:
    rejects(r"^bench\.json: expected .* without CasADi", benchmark_tables.tables, {"cases": []})


# how it is measured


class Clock:
    """A clock that stands still but for what tasks take."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 0
        self.calls: list[tuple[str, int]] = []
        monkeypatch.setattr("time.perf_counter_ns", lambda: self.now)

    def task(self, name: str, units: int, ns: int) -> timing.Task:
        def run(repeats: int) -> None:
            self.calls.append((name, repeats))
            self.now += repeats * units * ns

        return timing.Task(run, units)


def test_a_figure_is_the_time_of_one_unit(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock(monkeypatch)
    short, long = clock.task("short", 64, 100), clock.task("long", 10**6, 750)
    raw = timing.measured([short, long], 3, silent)
    assert raw[short] == pytest.approx(3 * (100.0,))
    assert raw[long] == pytest.approx(3 * (750.0,))
