"""The advice is the cheapest that is good enough, with its reasons, on paper and on the command line."""

import dataclasses
import json
import math
import sys
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import Run, read
from cost_figures import (
    CHEAP,
    DEAR,
    FRICTIONLESS,
    MIDDLE,
    SCENE,
    TOLERANCES,
    budget,
    entry,
    errors,
    figures_of,
    hasty,
)
from kits import few_vectors
from machines import dasgupta, random_motion, random_robot, with_random_rotors
from reduced_machines import as_simple_as

import stewart_sym as ss
from stewart_sym.backend.fidelity import DRIVE_FIDELITIES, available, operations
from stewart_sym.cli.main import main
from stewart_sym.derive.mechanics.legs.rotor import FULL, NONE
from stewart_sym.derive.mechanics.reduced_models import FIDELITIES, Fidelity, level_of
from stewart_sym.generated import exact, paper
from stewart_sym.generated.fidelities import FIDELITIES as TABLE
from stewart_sym.io.json_text import json_text
from stewart_sym.motion.motion import Motion
from stewart_sym.reference import newton_euler
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.accuracy import cost as study
from stewart_sym.studies.accuracy.advice import (
    TERMS,
    Advice,
    advice,
    answer,
    as_json,
    closest,
    excess,
    report,
    terms,
    without_effect,
)
from stewart_sym.studies.accuracy.budget import MARGIN, Budget, papers_motions
from stewart_sym.studies.accuracy.cost import Candidate, candidate_of, cost, entry_of, worst
from stewart_sym.studies.common.output import Figures

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


def test_rounding_and_model_errors_add_up_on_the_worst_motion() -> None:
    both = MIDDLE | {"errors": {"I": errors(0.1, 0.05, 0.01), "II": errors(0.02, 0.01, 0.2)}}
    assert worst(both) == pytest.approx(0.22)
    assert [worst(both, part) for part in ("model", "model_rms", "rounding")] == [0.1, 0.05, 0.2]


def test_a_kernel_slower_than_the_rate_is_not_good_enough() -> None:
    slow = CHEAP | {"one_pose_ns": 5000.0}
    given = figures_of(slow, MIDDLE, DEAR)
    assert advice(given, budget(9.0, rate=1e6)).chosen is MIDDLE
    none = advice(given, budget(9.0, rate=1e8))
    assert none.chosen is None
    assert none.closest is MIDDLE
    assert "a pose takes 100 ns, 10 times what is allowed" in answer(none)[0]


def test_both_misses_are_named_and_the_larger_comes_first() -> None:
    slow = MIDDLE | {"one_pose_ns": 201.0}
    error = "the error is 4.0e-02, 10 times what is allowed"
    time = "a pose takes 201 ns, {:.3g} times what is allowed".format
    for rate, expected in ((1e9, f"{time(201)}; {error}"), (1e7, f"{error}; {time(2.01)}"), (1e6, error)):
        said = closest(advice(figures_of(slow), budget(0.004, 1.0, rate)))
        assert said == f"exact slender, double, {expected}"


def test_where_nothing_is_good_enough_the_closest_is_named() -> None:
    given = figures_of(CHEAP, MIDDLE, DEAR | {"errors": {"I": errors(0.03, 0.01, 0.0)}})
    found = advice(given, budget(0.01))
    assert found.chosen is None
    assert candidate_of(found.closest) == candidate_of(DEAR)
    assert answer(found) == [
        "Nothing keeps the budget; closest: exact general, double, the error is 3.0e-02, "
        "9 times what is allowed."
    ]
    assert found.needed() == ()


def reasons(found: Advice) -> dict[frozenset[str], str]:
    return {left_out: candidate_of(entry).name for left_out, entry in found.needed()}


def test_what_forces_a_choice_is_what_the_next_cheaper_ones_leave_out(on_path_i: Figures) -> None:
    found = advice(on_path_i, budget(1e-9))
    assert reasons(found) == {
        frozenset({"digits"}): "exact general, float",
        frozenset({"joint"}): "paper general, double",
        frozenset({"friction"}): "exact frictionless, double",
        frozenset({"off-axis"}): "exact axisymmetric_friction, double",
    }
    lines = answer(found)
    assert (
        f"Forced by joint friction: without (exact frictionless, double: {FRICTIONLESS} operations) the error"
        in str(lines)
    )
    for left_out, without in found.needed():
        assert left_out == terms(candidate_of(DEAR)) - terms(candidate_of(without))
        assert excess(without, found.budget) > 1.0


def test_at_rest_inertia_forces_nothing(on_path_i: Figures) -> None:
    found = advice(on_path_i, budget(0.05))
    assert found.chosen is not None
    assert found.chosen["fidelity"] == "general_static"
    assert reasons(found) == {frozenset({"off-axis"}): "exact slender_static, double"}


def test_what_a_machine_has_not_forces_nothing() -> None:
    rng = np.random.default_rng(0)
    robot = random_robot(rng)
    assert without_effect(robot) == frozenset()
    smooth = dataclasses.replace(robot, **dict.fromkeys(("C_u", "C_p", "C_s"), np.zeros(6)))
    assert without_effect(smooth) == {"friction"}
    assert without_effect(random_robot(rng, "spherical")) == {"off-axis", "axial", "momentum"}


def test_the_cheapest_of_all_needs_no_reason() -> None:
    assert answer(advice(figures_of(CHEAP, DEAR), budget(9.0)))[1:] == ["Nothing is cheaper."]


def test_a_cheaper_kernel_with_more_physics_is_no_reason() -> None:
    richer = entry("exact slender double", 1000, 0.5)
    poorer = entry("exact point_masses double", 1000, 0.1)
    found = advice(figures_of(richer, poorer), budget(0.4))
    assert found.chosen is poorer
    assert answer(found)[1:] == ["Cheaper ones leave nothing out that it has, yet err more."]


def test_terms_are_what_the_derivation_says_of_each_fidelity() -> None:
    for name, level in FIDELITIES.items():
        has = terms(Candidate("exact", name, "double"))
        assert has <= TERMS.keys()
        assert ("friction" in has) == level.friction
        assert ("rates" in has) == level.moving
        kept = {"off-axis": "general", "axial": "axisymmetric", "rods": "slender", "masses": "point_masses"}
        order = ["general", "axisymmetric", "slender", "point_masses", "massless"]
        for term, last in kept.items():
            assert (term in has) == (order.index(level.legs) <= order.index(last)), (name, term)


def test_terms_of_rotors_are_what_the_derivation_says() -> None:
    for name in DRIVE_FIDELITIES:
        level = level_of(name, rotors=True)
        has = terms(Candidate("exact", name, "double"), rotors=True)
        assert has <= TERMS.keys()
        assert ("friction" in has) == level.friction
        assert ("reflected" in has) == (level.rotor != NONE)
        assert ("momentum" in has) == (level.rotor == FULL)
        plain = "general" if name in ("reflected", "no_rotor") else name.removeprefix("reflected_")
        assert has - {"reflected", "momentum"} == terms(Candidate("exact", plain, "double"))


def test_a_level_has_the_terms_of_its_legs_by_any_name(monkeypatch: pytest.MonkeyPatch) -> None:
    level = Fidelity("two_points", "point_masses", True, False, "two points, at rest, with friction")
    monkeypatch.setitem(FIDELITIES, level.name, level)
    assert terms(Candidate("exact", level.name, "float")) == {"masses", "friction", "joint"}


@pytest.mark.slow
def test_rotors_get_the_cheapest_that_serves_and_a_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every level in both precisions is tried on tolerances from coarse to fine."""
    hasty(monkeypatch)
    monkeypatch.setattr(study, "SAMPLED", 8)
    rng = np.random.default_rng(0)
    robot = with_random_rotors(rng, random_robot(rng))
    motion = random_motion(rng, robot, (8,))
    found = cost(robot, {"motion": motion}, rounds=1)
    true = newton_euler.inverse_dynamics(robot, motion).F
    peak, chosen = np.abs(true).max(), set()
    for tolerance in 10.0 ** -np.arange(0, 12):
        good = {}
        for level in available(robot):
            for width, precision in ((4, "float"), (8, "double")):
                F = ss.ForceKernel(robot, "exact", precision, level).forces(motion)  # type: ignore[arg-type]
                if np.abs(F - true).max() / peak * MARGIN <= tolerance:
                    good[level, precision] = (operations(robot, fidelity=level), width)
        given = advice(found, Budget(robot, {"motion": motion}, tolerance))
        assert (given.chosen is None) == (not good)
        if given.chosen is not None:
            level, precision = given.chosen["fidelity"], given.chosen["precision"]
            assert good[level, precision] == min(good.values())
            chosen.add(level)
            named = set().union(*(left_out for left_out, _ in given.needed()))
            assert named <= terms(candidate_of(given.chosen), rotors=True)
            if level == "general":
                assert "momentum" in named
    assert "general" in chosen
    assert any(level.startswith("reflected") for level in chosen)


def test_the_report_has_every_figure(on_path_i: Figures) -> None:
    text = report(advice(on_path_i, budget(0.05)))
    assert "tolerance 0.05, margin 3: good enough up to an error of 1.67e-02" in text
    for each in on_path_i["candidates"]:
        line = next(line for line in text.splitlines() if line.startswith(f"{candidate_of(each).name} "))
        assert f" {each['operations']} " in line
        assert f"{worst(each):.1e}" in line or worst(each) == 0.0
    assert text.count("chosen") == 1


def test_the_report_names_the_poses_of_the_rounding_errors(on_path_i: Figures) -> None:
    expected = f"Rounding is measured at {study.SAMPLED} poses spread over each motion and where force"
    assert expected in " ".join(report(advice(on_path_i, budget(0.05))).split())


def test_json_holds_what_was_found_and_no_infinity(on_path_i: Figures) -> None:
    given = figures_of(CHEAP | {"errors": {"I": errors(math.inf, math.inf, math.inf)}}, DEAR)
    for found in (advice(on_path_i, budget(1e-9)), advice(given, budget(0.1))):
        written: dict[str, Any] = json.loads(json_text(as_json(found)))
        assert written["chosen"] == {"formulation": "exact", "fidelity": "general", "precision": "double"}
        assert len(written["candidates"]) == len(found.cost["candidates"])
        assert [each["terms"] for each in written["needed"]] == [sorted(t) for t, _ in found.needed()]


# commands


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch, on_path_i: Figures) -> None:
    """The study's figures without running it again."""

    def measured(robot: Robot, motions: Mapping[str, Motion], *_: object, **__: object) -> Figures:
        assert list(motions) == ["I"]
        return on_path_i

    monkeypatch.setattr(study, "cost", measured)


TABLES = ["chart.csv", "chart.json", "chart.txt"]


@pytest.mark.usefixtures("quick")
def test_advise_prints_and_writes_its_answer(scene: Path, run: Run) -> None:
    output = scene.parent / "advice.json"
    captured = run("choose-fidelity", scene, "--json", output)
    assert "Cheapest that is good enough: exact general_static, float" in captured.out
    assert "Forced by centers of mass off the legs' axes" in captured.out
    written = json.loads(output.read_text())
    assert written["chosen"]["fidelity"] == "general_static"
    assert (written["tolerance"], written["margin"], written["rate_Hz"]) == (0.05, 2.0, 1000.0)


def test_advise_runs_the_whole_study(scene: Path, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    hasty(monkeypatch)
    assert "Cheapest that is good enough: exact general_static, float" in run("choose-fidelity", scene).out


@pytest.mark.usefixtures("quick")
def test_advise_without_an_answer_prints_the_table_and_fails_in_one_line(scene: Path, run: Run) -> None:
    scene.write_text(SCENE.replace("0.05", "1e-17"))
    output, kit = scene.parent / "advice.json", scene.parent / "kit"
    captured = run("choose-fidelity", scene, "--json", output, "--generate", kit, code=2)
    assert captured.out.count("\n") > 28
    (line,) = captured.err.splitlines()
    assert f"{scene}: no kernel is within the tolerance; closest: exact general, double" in line
    assert json.loads(output.read_text())["chosen"] is None
    assert not kit.exists()


@pytest.mark.slow
@pytest.mark.usefixtures("quick")
def test_every_long_part_of_advise_is_shown_and_its_share_where_it_is_known(
    monkeypatch: pytest.MonkeyPatch, scene: Path, run: Run
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    shown = run("choose-fidelity", scene, "--generate", scene.parent / "kit").err
    for part in ("generating kernels", "computing test vectors"):
        assert f"{part} ..." in shown
    hasty(monkeypatch)
    steps: list[tuple[str, float | None]] = []
    robot, motion = simple("frictionless", 11)
    cost(robot, {"some": motion}, progress=lambda text, share=None: steps.append((text, share)))
    for part in (
        "compiling exact",
        "computing the forces of",
        "computing some at 50",
    ):
        shares = [share for text, share in steps if text.startswith(part)]
        assert shares[0] == 0.0, part
        assert None not in shares


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


@pytest.mark.slow
@pytest.mark.usefixtures("quick")
def test_chart_writes_tables_without_matplotlib(
    scene: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    output = scene.parent / "out"
    told = run("chart", scene, "-o", output, "--no-plots").out
    assert sorted(path.name for path in output.glob("[!.]*")) == TABLES
    assert (output / "chart.txt").read_text() in told


@pytest.mark.slow
def test_chart_of_the_papers_machine_needs_no_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, found: Figures
) -> None:
    asked: list[list[str]] = []

    def measured(robot: Robot, motions: Mapping[str, Motion], *_: object) -> Figures:
        asked.append(list(motions))
        return found

    monkeypatch.setattr(study, "cost", measured)
    assert main(["chart", "-o", str(tmp_path / "out")]) == 0
    assert asked == [["I", "II", "III"]]
    pictures = ["chart.png", "chart.svg"]
    assert sorted(path.name for path in (tmp_path / "out").glob("[!.]*")) == sorted([*TABLES, *pictures])
    rows = read(tmp_path / "out" / "chart.csv")
    assert {row["motion"] for row in rows} == {"I", "II", "III"}
    written = json.loads((tmp_path / "out" / "chart.json").read_text())
    assert written["software"]["compiler"]
    assert len(written["candidates"]) == len(found["candidates"])
