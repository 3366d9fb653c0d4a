"""The advice is the cheapest that is good enough, on paper and on the command line."""

import json
import math
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from chart_tables import entry_of
from command_line import Run
from cost_figures import (
    CHEAP,
    DEAR,
    MIDDLE,
    SCENE,
    TOLERANCES,
    budget,
    errors,
    figures_of,
    hasty,
)
from kits import few_vectors
from machines import dasgupta, random_motion, random_robot
from reduced_machines import as_simple_as

import stewart_sym as ss
from stewart_sym.derive.mechanics.reduced_models import FIDELITIES
from stewart_sym.generated import exact, paper
from stewart_sym.generated.fidelities import FIDELITIES as TABLE
from stewart_sym.io.output import json_text
from stewart_sym.motion.motion import Motion
from stewart_sym.reference import newton_euler
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.accuracy import cost as study
from stewart_sym.studies.accuracy.advice import advice, answer, as_json
from stewart_sym.studies.accuracy.budget import MARGIN, Budget, papers_motions
from stewart_sym.studies.accuracy.cost import Candidate, candidate_of, cost, worst
from stewart_sym.studies.common.text_tables import Figures

pytestmark = pytest.mark.filterwarnings("ignore::stewart_sym.RobotWarning")


# the advice


def brute_force(tolerance: float) -> tuple[str, str, str]:
    """The cheapest good enough kernel on Path I, from forces, the reference and the generated counts."""
    robot, motion = dasgupta(), papers_motions()["I"]
    true = newton_euler.inverse_dynamics(robot, motion).F
    peak = np.abs(true).max()
    best: tuple[int, int] | None = None
    chosen = ("", "", "")
    for formulation in ("exact", "paper"):
        for level in TABLE if formulation == "exact" else ["general"]:
            counts = {"exact": exact, "paper": paper}[formulation].FORCE_OPERATIONS["friction"]
            operations = sum(counts["total"]) if level == "general" else TABLE[level]["operations"]["total"]
            for width, precision in ((4, "float"), (8, "double")):
                F = ss.ForceKernel(robot, formulation, precision, level).forces(motion)  # type: ignore[arg-type]
                error = np.abs(F - true).max() / peak
                good = error * MARGIN <= tolerance
                if good and (best is None or (operations, width) < best):
                    best, chosen = (operations, width), (formulation, level, precision)
    return chosen


@pytest.mark.slow
def test_path_i_gets_four_answers_and_each_is_the_cheapest(on_path_i: Figures) -> None:
    answers = []
    for tolerance in TOLERANCES:
        chosen = advice(on_path_i, budget(tolerance)).chosen
        assert chosen is not None
        answers.append(candidate_of(chosen))
        assert answers[-1] == brute_force(tolerance)
    assert len(set(answers)) == len(TOLERANCES)
    assert answers[-1] == ("exact", "general", "double")


def simple(level: str, seed: int) -> tuple[Robot, Motion]:
    rng = np.random.default_rng(seed)
    with warnings.catch_warnings(action="ignore"):
        robot = as_simple_as(random_robot(rng), FIDELITIES[level])
    return robot, random_motion(rng, robot, (6,))


@pytest.mark.slow
@pytest.mark.parametrize("level", ["frictionless", "slender"])
def test_a_machine_that_truly_is_simple_gets_the_simple_kernel(
    level: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    hasty(monkeypatch)
    robot, motion = simple(level, 11)
    made = cost(robot, {"some": motion})
    assert worst(entry_of(made, "exact", level, "double"), "model") == 0.0
    chosen = advice(made, Budget(robot, {"some": motion}, 1e-9)).chosen
    assert chosen is not None
    assert candidate_of(chosen) == Candidate("exact", level, "double")


def test_the_first_that_keeps_tolerance_and_margin_is_chosen() -> None:
    given = figures_of(CHEAP, MIDDLE, DEAR)
    for tolerance, margin, expected in (
        (1.21, 3.0, CHEAP),
        (1.1, 3.0, MIDDLE),
        (0.1, 3.0, DEAR),
        (0.1, 1.0, MIDDLE),
    ):
        assert advice(given, budget(tolerance, margin)).chosen is expected


def test_a_kernel_slower_than_the_rate_is_not_good_enough() -> None:
    slow = CHEAP | {"one_pose_ns": 5000.0}
    given = figures_of(slow, MIDDLE, DEAR)
    assert advice(given, budget(9.0, rate=1e6)).chosen is MIDDLE
    none = advice(given, budget(9.0, rate=1e8))
    assert none.chosen is None
    assert none.closest is MIDDLE
    assert "100 ns per pose, 10 times the limit" in answer(none)


@pytest.mark.slow
def test_the_best_of_the_cheaper_kernels_is_named_with_its_physics(on_path_i: Figures) -> None:
    found = advice(on_path_i, budget(1e-9))
    text = "exact general, float (everything): 2206 operations; error "
    assert f"Best of the cheaper kernels: {text}" in answer(found)
    assert answer(advice(on_path_i, budget(9.0))).endswith("Best of the cheaper kernels: none")


@pytest.mark.slow
def test_json_holds_what_was_found_and_no_infinity(on_path_i: Figures) -> None:
    given = figures_of(CHEAP | {"errors": {"I": errors(math.inf, math.inf, math.inf)}}, DEAR)
    for found in (advice(on_path_i, budget(1e-9)), advice(given, budget(0.1))):
        written: dict[str, Any] = json.loads(json_text(as_json(found)))
        assert written["chosen"] == {"formulation": "exact", "fidelity": "general", "precision": "double"}
        assert len(written["candidates"]) == len(found.cost["candidates"])
        assert written["closest"]["fidelity"] in ("frictionless", "general", "massless_static")


# commands


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch, on_path_i: Figures) -> None:
    """The study's figures without running it again."""

    def measured(robot: Robot, motions: Mapping[str, Motion], *_: object, **__: object) -> Figures:
        assert list(motions) == ["I"]
        return on_path_i

    monkeypatch.setattr(study, "cost", measured)


@pytest.mark.slow
@pytest.mark.usefixtures("quick")
def test_advise_prints_and_writes_its_answer(scene: Path, run: Run) -> None:
    output = scene.parent / "advice.json"
    captured = run("choose-fidelity", scene, "--json", output)
    assert "Cheapest kernel within the budget: exact general_static, float" in captured.out
    written = json.loads(output.read_text())
    assert written["chosen"]["fidelity"] == "general_static"
    assert (written["tolerance"], written["margin"], written["rate_Hz"]) == (0.05, 2.0, 1000.0)


@pytest.mark.slow
@pytest.mark.usefixtures("quick")
def test_advise_without_an_answer_prints_the_table_and_fails_in_one_line(scene: Path, run: Run) -> None:
    scene.write_text(SCENE.replace("0.05", "1e-17"))
    output, kit = scene.parent / "advice.json", scene.parent / "kit"
    captured = run("choose-fidelity", scene, "--json", output, "--generate", kit, code=2)
    assert captured.out.count("\n") > 28
    (line,) = captured.err.splitlines()
    assert f"{scene}: No kernel is within the budget; closest: exact general, double (everything)" in line
    assert json.loads(output.read_text())["chosen"] is None
    assert not kit.exists()


@pytest.mark.slow
@pytest.mark.usefixtures("quick")
@few_vectors()
def test_advise_generates_the_kernel_that_it_chose(scene: Path, run: Run) -> None:
    kit = scene.parent / "kit"
    printed = run("choose-fidelity", scene, "--generate", kit).out
    names = sorted(path.name for path in kit.iterdir())
    assert "stewart_exact_general_static_forces.c" in names
    assert all(str(kit / name) in printed for name in names)
    # Nothing is replaced unasked.
    (kit / "stewart_robot.c").write_text("mine")
    *warned, error = run("choose-fidelity", scene, "--generate", kit, code=2).err.splitlines()
    assert all("omits physics of the robot file" in line for line in warned)
    assert "use --force" in error
    run("choose-fidelity", scene, "--generate", kit, "--force", "--bake")
