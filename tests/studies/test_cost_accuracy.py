"""Speed against accuracy: figures are what they say, and the advice is the cheapest that is good enough."""

import csv
import dataclasses
import io
import json
import math
import shutil
import sys
import warnings
from collections.abc import Mapping
from importlib.resources import as_file, files
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import fails_in_one_line, folder_state
from fifty_digits import truth as eliminated
from machines import dasgupta, random_motion, random_robot
from mpmath import mp
from numpy.typing import NDArray
from reduced_machines import as_simple_as

import stewart_sym as ss
from stewart_sym.backend import fidelity
from stewart_sym.cli.main import main
from stewart_sym.derive.mechanics.formulation import FORMULATIONS
from stewart_sym.derive.mechanics.reduced_models import FIDELITIES
from stewart_sym.generated import exact, paper
from stewart_sym.generated.fidelities import FIDELITIES as TABLE
from stewart_sym.io.extras import install
from stewart_sym.motion.motion import Motion
from stewart_sym.motion.trajectory import read_csv
from stewart_sym.precision.truth import Truth, deviation
from stewart_sym.reference import newton_euler
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.accuracy import bound_plot, scales
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
)
from stewart_sym.studies.accuracy.budget import MARGIN, Budget, papers_motions, read_budget
from stewart_sym.studies.accuracy.charts import charts
from stewart_sym.studies.accuracy.cost import Candidate, CostAccuracy, Entry, Errors, cost
from stewart_sym.studies.common import timing
from stewart_sym.studies.common.output import csv_lines

FRICTIONLESS = TABLE["frictionless"]["operations"]["total"]

Array = NDArray[np.float64]

EPSILON = np.finfo(np.float64).eps
TOLERANCES = (0.5, 0.05, 0.01, 1e-9)
SCENE = """
schema = 1
robot = "robots/robot.toml"
motions = ["I"]
tolerance = 0.05
margin = 2
rate = 1000.0
"""

pytestmark = pytest.mark.filterwarnings("ignore::stewart_sym.PhysicalityWarning")


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    """A scene on Path I, the paper's robot in a folder beside it."""
    (tmp_path / "robots").mkdir()
    with as_file(files("stewart_sym.robots") / "dasgupta1998.toml") as source:
        shutil.copy(source, tmp_path / "robots" / "robot.toml")
    path = tmp_path / "scene.toml"
    path.write_text(SCENE)
    return path


def hasty(patch: pytest.MonkeyPatch) -> None:
    """Times without meaning, and no sizes: nothing here depends on them."""
    patch.setattr(timing, "SHORTEST", 1e-7)
    patch.setattr(study, "QUICK_ROUNDS", 1)
    patch.setattr(study, "ROUNDS", 1)
    patch.setattr(study, "MANY", 64)
    patch.setattr(study, "SAMPLED", 4)
    patch.setattr(study, "text_size", lambda *_: None)


@pytest.fixture(scope="module")
def found() -> CostAccuracy:
    """Figures of the paper's machine on all paths, and of other implementations."""
    with pytest.MonkeyPatch.context() as patch:
        hasty(patch)
        return cost(dasgupta(), papers_motions(), True, 1)


@pytest.fixture
def on_path_i(found: CostAccuracy) -> CostAccuracy:
    """The same on Path I alone."""
    entries = tuple(dataclasses.replace(entry, errors={"I": entry.errors["I"]}) for entry in found.entries)
    return dataclasses.replace(found, peaks={"I": found.peaks["I"]}, poses={"I": 61}, entries=entries)


def budget(tolerance: float, margin: float = MARGIN, rate: float | None = None) -> Budget:
    return Budget(dasgupta(), {"I": papers_motions()["I"]}, tolerance, margin, rate)


def at_rest(motion: Motion) -> Motion:
    zero = np.zeros_like(motion.t)
    return Motion(motion.R, motion.t, zero, zero, zero, zero)


# the scene


def test_a_scene_is_what_its_file_says(scene: Path) -> None:
    time = np.linspace(0.0, 1.0, 11)
    pose = {"t_x": 0.1 + 0.05 * time, "t_y": 0 * time, "t_z": 0.5 + 0.05 * time**2}
    turn = {"theta_x": 0 * time, "theta_y": 0 * time, "theta_z": 0.1 * time}
    (scene.parent / "poses.csv").write_text("".join(csv_lines({"time": time} | pose | turn)))
    robot = Robot.from_toml(scene.parent / "robots" / "robot.toml")
    motion = read_csv(scene.parent / "poses.csv").motion
    legs = ss.inverse_kinematics(robot, motion)
    columns = {"time": time} | {f"L_{leg + 1}": legs.L[:, leg] for leg in range(6)}
    (scene.parent / "legs.csv").write_text("".join(csv_lines(columns)))
    scene.write_text(SCENE.replace('"I"', '"II", "poses.csv", "legs.csv"'))
    read = read_budget(scene)
    assert (read.tolerance, read.margin, read.rate) == (0.05, 2.0, 1000.0)
    assert read.robot.name == robot.name
    assert list(read.motions) == ["II", "poses.csv", "legs.csv"]
    assert read.motions["II"].shape == (61,)
    np.testing.assert_array_equal(read.motions["poses.csv"].t, motion.t)
    np.testing.assert_allclose(read.motions["legs.csv"].t, motion.t, atol=1e-9)


def test_margin_and_rate_have_defaults(scene: Path) -> None:
    scene.write_text(SCENE.replace("margin = 2", "").replace("rate = 1000.0", ""))
    read = read_budget(scene)
    assert (read.margin, read.rate) == (MARGIN, None)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("schema = 1", "schema = 2", "schema: expected 1, got 2"),
        ("schema = 1", "", "schema: missing"),
        ("schema = 1", "schema = ", "not valid TOML"),
        ("margin", "margn", 'margn: unknown key, did you mean "margin"?'),
        ("rate = 1000.0", "xyz = 1", "xyz: unknown key, expected one of schema, robot, motions"),
        ("robots/robot.toml", "robots/none.toml", "none.toml: cannot read the robot file"),
        ('"robots/robot.toml"', "7", "robot: expected one line of text, got 7"),
        ('robot = "robots/robot.toml"', "", "robot: missing"),
        ('motions = ["I"]', "motions = []", "motions: expected a list of one or more of I, II, III or CSV"),
        ('motions = ["I"]', 'motions = "I"', "motions: expected a list of one or more of I, II, III or CSV"),
        ('motions = ["I"]', "", "motions: missing"),
        ('motions = ["I"]', "motions = [1]", "motions: expected one line of text, got 1"),
        ('["I"]', '["I", "II", "I"]', "motions: expected each motion once, 'I' is given twice"),
        ('["I"]', '["IV"]', "IV: cannot read the trajectory"),
        ("tolerance = 0.05", "tolerance = 0", "tolerance: expected a number > 0, got 0"),
        ("tolerance = 0.05", "tolerance = -0.1", "tolerance: expected a number > 0, got -0.1"),
        ("tolerance = 0.05", "tolerance = nan", "tolerance: expected a finite number, got nan"),
        ("tolerance = 0.05", "tolerance = inf", "tolerance: expected a finite number, got inf"),
        ("tolerance = 0.05", 'tolerance = "5 %"', "tolerance: expected a finite number, got '5 %'"),
        ("tolerance = 0.05", "", "tolerance: missing"),
        ("margin = 2", "margin = 0.5", "margin: expected a number >= 1, got 0.5"),
        ("rate = 1000.0", "rate = 0", "rate: expected a number > 0, got 0"),
        ("rate = 1000.0", "rate = inf", "rate: expected a finite number, got inf"),
    ],
)
@pytest.mark.parametrize("subcommand", ["advise", "chart"])
def test_bad_scenes_are_rejected_in_one_line_and_leave_nothing(
    scene: Path, capsys: pytest.CaptureFixture[str], subcommand: str, old: str, new: str, words: str
) -> None:
    assert old in SCENE
    scene.write_text(SCENE.replace(old, new, 1))
    before = folder_state(scene.parent)
    more = {"advise": ["--json", scene.parent / "out.json"], "chart": ["-o", scene.parent / "out"]}[
        subcommand
    ]
    line = fails_in_one_line(capsys, subcommand, scene, *more)
    assert words in line
    elsewhere = "cannot read the" in words
    assert str(scene.parent if elsewhere else scene) in line
    assert folder_state(scene.parent) == before


def test_a_missing_scene_is_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    line = fails_in_one_line(capsys, "advise", tmp_path / "none.toml")
    assert "none.toml: cannot read the scene of advise: No such file" in line


def test_a_pose_without_an_answer_is_named(scene: Path, capsys: pytest.CaptureFixture[str]) -> None:
    names = [f"{name}_{axis}" for name in ("t", "theta") for axis in "xyz"]
    names += [f"{name}_{axis}" for name in ("v", "theta_dot", "a", "theta_ddot") for axis in "xyz"]
    columns = {"time": 0.1 * np.arange(3.0)} | dict.fromkeys(names, np.zeros(3))
    # In the second row platform point 2 is on base point 2.
    columns |= {"t_x": np.array([0.1, -0.2, 0.1]), "t_y": np.array([0.0, 0.3, 0.0])}
    columns |= {"t_z": np.array([0.5, 0.1, 0.5])}
    (scene.parent / "poses.csv").write_text("".join(csv_lines(columns)))
    scene.write_text(SCENE.replace('"I"', '"poses.csv"'))
    line = fails_in_one_line(capsys, "advise", scene)
    assert "poses.csv: row 3: a leg has length zero" in line


# 50 digits


@pytest.mark.parametrize("form", FORMULATIONS, ids=lambda form: form.kernel_name)
def test_forces_at_50_digits_are_those_of_the_elimination(form: Any) -> None:
    """Which has its own text of the sums over the legs, and its own solve."""
    rng = np.random.default_rng(5)
    robot = random_robot(rng, form.base_joint)
    motion = random_motion(rng, robot)
    with mp.workdps(50):
        expected = [float(value) for value in eliminated(form, robot, motion)["F"]]
    found = Truth(robot, form.name).forces(motion)
    # R and k are orthonormal to double rounding only, and the two forms use that at different places.
    np.testing.assert_allclose(found.astype(float), expected, rtol=0, atol=1e-13 * np.abs(expected).max())


@pytest.mark.parametrize("level", FIDELITIES)
def test_every_fidelity_is_within_rounding_of_its_own_truth(level: str) -> None:
    rng = np.random.default_rng(6)
    robot = random_robot(rng)
    motion = random_motion(rng, robot, (2,))
    condition = float(ss.condition_number(ss.wrench_matrix(robot, motion)).max())
    for precision, epsilon in (("double", EPSILON), ("float", np.finfo(np.float32).eps)):
        F = ss.prepare(robot, "exact", precision, level).forces(motion)  # type: ignore[arg-type]
        off = np.abs(Truth(robot, "exact", level).deviation(F, motion)).max()
        assert 0.0 < off <= 100 * epsilon * condition * np.abs(F).max()


def test_deviations_keep_digits_that_double_has_not() -> None:
    robot, motion = dasgupta(), papers_motions()["I"][3:5]
    true = Truth(robot).forces(motion)
    nearest = true.astype(np.float64)
    off = deviation(nearest, true)
    assert off.shape == (2, 6)
    assert 0.0 < np.abs(off).max() <= 0.5 * np.spacing(np.abs(nearest).max())
    assert np.isnan(deviation(np.full((2, 6), np.nan), true)).all()


# the figures


def test_every_candidate_is_there_once_and_the_cheapest_comes_first(found: CostAccuracy) -> None:
    names = [vars(entry.candidate) for entry in found.entries]
    expected = [
        {"formulation": formulation, "fidelity": level, "precision": precision}
        for formulation, levels in (("exact", TABLE), ("paper", ["general"]))
        for level in levels
        for precision in ("double", "float")
    ]
    assert sorted(map(str, names)) == sorted(map(str, expected))
    cost = [(entry.operations, entry.candidate.precision == "double") for entry in found.entries]
    assert cost == sorted(cost)


def model_errors(robot: Robot, motion: Motion) -> dict[str, tuple[float, float]]:
    """Largest and RMS errors of some fidelities and of `paper`, from the slow reference alone."""
    smooth = dataclasses.replace(robot, **dict.fromkeys(("C_u", "C_p", "C_s"), np.zeros(6)))
    true = newton_euler.inverse_dynamics(robot, motion).F
    forces = {
        "paper": newton_euler.inverse_dynamics(robot, motion, newton_euler.PAPER).F,
        "frictionless": newton_euler.inverse_dynamics(smooth, motion).F,
        "general_static": newton_euler.inverse_dynamics(smooth, at_rest(motion)).F,
        "massless": newton_euler.massless_forces(robot, motion),
        "massless_static": newton_euler.massless_forces(robot, at_rest(motion)),
    }
    peak = np.abs(true).max()
    return {
        name: (np.abs(F - true).max() / peak, np.sqrt(np.mean((F - true) ** 2)) / peak)
        for name, F in forces.items()
    }


@pytest.mark.parametrize("path", ["I", "II", "III"])
def test_model_errors_are_those_of_the_reference(found: CostAccuracy, path: str) -> None:
    for name, expected in model_errors(dasgupta(), papers_motions()[path]).items():
        of = ("paper", "general") if name == "paper" else ("exact", name)
        for precision in ("double", "float"):
            errors = found.entry(*of, precision).errors[path]
            assert (errors.model, errors.model_rms) == pytest.approx(expected, rel=1e-6)


def test_exact_general_has_no_model_error_and_others_are_off(found: CostAccuracy) -> None:
    for entry in found.entries:
        right = (entry.candidate.formulation, entry.candidate.fidelity) == ("exact", "general")
        assert (entry.model == 0.0) == right
        assert (entry.model_rms == 0.0) == right


def test_rounding_errors_are_those_beside_50_digits(found: CostAccuracy) -> None:
    robot, motions = dasgupta(), papers_motions()
    for name in ("general", "slender", "massless_static"):
        for precision, epsilon in (("double", EPSILON), ("float", np.finfo(np.float32).eps)):
            errors = found.entry("exact", name, precision).errors["I"]
            F = ss.prepare(robot, "exact", precision, name).forces(motions["I"][:3])  # type: ignore[arg-type]
            off = np.abs(Truth(robot, "exact", name).deviation(F, motions["I"][:3])).max()
            # Three poses of those that were sampled or are like them.
            assert 0.2 * off <= errors.rounding * found.peaks["I"] <= 100 * epsilon * found.peaks["I"]


def test_rounding_in_float_is_the_worst_of_all_poses(found: CostAccuracy) -> None:
    robot, motions = dasgupta(), papers_motions()
    for path, motion in motions.items():
        one, other = (ss.prepare(robot, "exact", p).forces(motion) for p in ("float", "double"))  # type: ignore[arg-type]
        worst = np.abs(one - other).max() / found.peaks[path]
        errors = found.entry("exact", "general", "float").errors[path]
        assert errors.rounding == pytest.approx(worst, rel=1e-6)


def test_peaks_are_the_largest_forces(found: CostAccuracy) -> None:
    for name, motion in papers_motions().items():
        F = newton_euler.inverse_dynamics(dasgupta(), motion).F
        assert found.peaks[name] == pytest.approx(np.abs(F).max(), rel=1e-9)
        assert found.poses[name] == 61


def test_other_implementations_are_near_the_truth(found: CostAccuracy) -> None:
    assert [each.name for each in found.implementations] == [
        "every output",
        "NumPy kernel",
        "vector reference",
    ]
    for each in found.implementations:
        assert each.ns > 0.0
        assert 0.0 < each.rounding["I"] < 1e-13


def test_a_motion_without_forces_is_rejected(monkeypatch: pytest.MonkeyPatch) -> None:
    hasty(monkeypatch)
    robot = dataclasses.replace(dasgupta(), g=np.zeros(3))
    with pytest.raises(ValueError, match="still: all forces are zero"):
        cost(robot, {"still": at_rest(papers_motions()["I"])})


def test_constants_that_float_cannot_hold_leave_float_out(monkeypatch: pytest.MonkeyPatch) -> None:
    hasty(monkeypatch)
    robot = dataclasses.replace(dasgupta(), M=1e39)
    made = cost(robot, {"I": papers_motions()["I"][:4]})
    assert {entry.candidate.precision for entry in made.entries} == {"double"}


def test_a_machine_with_spherical_base_joints_has_fewer_candidates(monkeypatch: pytest.MonkeyPatch) -> None:
    hasty(monkeypatch)
    rng = np.random.default_rng(8)
    robot = random_robot(rng, "spherical")
    made = cost(robot, {"some": random_motion(rng, robot, (4,))})
    levels = {entry.candidate.fidelity for entry in made.entries}
    assert levels == set(fidelity.available(robot))
    assert made.entry("exact", "general", "double").model == 0.0


@pytest.mark.parametrize("precision", ["double", "float"])
def test_bytes_of_code_are_those_of_a_program_of_one_pose(precision: str) -> None:
    sizes = {
        level: study._text(dasgupta(), Candidate("exact", level, precision))
        for level in ("general", "massless_static")
    }
    assert sizes["general"] is not None
    assert sizes["massless_static"] is not None
    assert 1_000 < sizes["massless_static"] < sizes["general"] < 50_000


def test_one_pose_and_batch_run_the_kernel_they_are_named_after() -> None:
    robot, motion = dasgupta(), papers_motions()["II"]
    poses = study._poses([motion], 64)
    for precision in ("double", "float"):
        kernel = ss.prepare(robot, "exact", precision, "slender")  # type: ignore[arg-type]
        assert study._one_pose(kernel, poses)(2) == 0
        study._batch(kernel, poses)(2)


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
                F = ss.prepare(robot, formulation, precision, level).forces(motion)  # type: ignore[arg-type]
                error = np.abs(F - true).max() / peak
                good = error * MARGIN <= tolerance
                if good and (best is None or (operations, width) < best):
                    best, chosen = (operations, width), (formulation, level, precision)
    return chosen


def test_path_i_gets_four_answers_and_each_is_the_cheapest(on_path_i: CostAccuracy) -> None:
    answers = []
    for tolerance in TOLERANCES:
        chosen = advice(on_path_i, budget(tolerance)).chosen
        assert chosen is not None
        answers.append(tuple(vars(chosen.candidate).values()))
        assert answers[-1] == brute_force(tolerance)
    assert len(set(answers)) == len(TOLERANCES)
    assert answers[-1] == ("exact", "general", "double")


def test_a_choice_does_not_depend_on_times(on_path_i: CostAccuracy) -> None:
    rng = np.random.default_rng(9)
    for tolerance in TOLERANCES:
        chosen = advice(on_path_i, budget(tolerance)).chosen
        entries = tuple(
            dataclasses.replace(entry, one_pose=(float(rng.uniform(10, 1000)),), batch=(1.0,))
            for entry in on_path_i.entries
        )
        again = advice(dataclasses.replace(on_path_i, entries=entries), budget(tolerance)).chosen
        assert again is not None
        assert chosen is not None
        assert again.candidate == chosen.candidate


def simple(level: str, seed: int) -> tuple[Robot, Motion]:
    rng = np.random.default_rng(seed)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        robot = as_simple_as(random_robot(rng), FIDELITIES[level])
    return robot, random_motion(rng, robot, (6,))


@pytest.mark.parametrize("level", ["frictionless", "axisymmetric", "slender", "axisymmetric_friction"])
def test_a_machine_that_truly_is_simple_gets_the_simple_kernel(
    level: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    hasty(monkeypatch)
    robot, motion = simple(level, 11)
    made = cost(robot, {"some": motion})
    assert made.entry("exact", level, "double").model == 0.0
    chosen = advice(made, Budget(robot, {"some": motion}, 1e-9)).chosen
    assert chosen is not None
    assert chosen.candidate == Candidate("exact", level, "double")


def entry(name: str, operations: int, error: float, ns: float = 100.0) -> Entry:
    formulation, level, precision = name.split()
    errors = {"I": Errors(error, error / 2, 0.0)}
    return Entry(Candidate(formulation, level, precision), operations, (ns,), (ns / 2,), 1000, errors)


def made_up(*entries: Entry) -> CostAccuracy:
    return CostAccuracy("machine", {"I": 1000.0}, {"I": 61}, entries)


CHEAP = entry("exact massless_static float", 400, 0.4)
MIDDLE = entry("exact slender double", 1100, 0.04)
DEAR = entry("exact general double", 2000, 0.0, 300.0)


def test_the_first_that_keeps_tolerance_and_margin_is_chosen() -> None:
    given = made_up(CHEAP, MIDDLE, DEAR)
    for tolerance, margin, expected in (
        (1.21, 3.0, CHEAP),
        (1.1, 3.0, MIDDLE),
        (0.1, 3.0, DEAR),
        (0.1, 1.0, MIDDLE),
    ):
        assert advice(given, budget(tolerance, margin)).chosen is expected


def test_rounding_and_model_errors_add_up_on_the_worst_motion() -> None:
    errors = {"I": Errors(0.1, 0.05, 0.01), "II": Errors(0.02, 0.01, 0.2)}
    both = dataclasses.replace(MIDDLE, errors=errors)
    assert both.total == pytest.approx(0.22)
    assert (both.model, both.model_rms, both.rounding) == (0.1, 0.05, 0.2)


def test_a_kernel_slower_than_the_rate_is_not_good_enough() -> None:
    slow = dataclasses.replace(CHEAP, one_pose=(5000.0,))
    given = made_up(slow, MIDDLE, DEAR)
    assert advice(given, budget(9.0, rate=1e6)).chosen is MIDDLE
    none = advice(given, budget(9.0, rate=1e8))
    assert none.chosen is None
    assert none.closest is MIDDLE
    assert "a pose takes 100 ns, 10 times what is allowed" in answer(none)[0]


def test_both_misses_are_named_and_the_larger_comes_first() -> None:
    slow = dataclasses.replace(MIDDLE, one_pose=(201.0,))
    error = "the error is 4.0e-02, 10 times what is allowed"
    time = "a pose takes 201 ns, {:.3g} times what is allowed".format
    for rate, expected in (
        (1e9, f"{time(201)}; {error}"),
        (1e7, f"{error}; {time(2.01)}"),
        (1e6, error),
    ):
        said = closest(advice(made_up(slow), budget(0.004, 1.0, rate)))
        assert said == f"exact slender, double, {expected}"


def test_where_nothing_is_good_enough_the_closest_is_named() -> None:
    given = made_up(CHEAP, MIDDLE, dataclasses.replace(DEAR, errors={"I": Errors(0.03, 0.01, 0.0)}))
    found = advice(given, budget(0.01))
    assert found.chosen is None
    assert found.closest.candidate == DEAR.candidate
    assert answer(found) == [
        "Nothing keeps the budget; closest: exact general, double, the error is 3.0e-02, "
        "9 times what is allowed."
    ]
    assert found.needed() == ()


def reasons(found: Advice) -> dict[frozenset[str], str]:
    return {left_out: entry.candidate.name for left_out, entry in found.needed()}


def test_what_forces_a_choice_is_what_the_next_cheaper_ones_leave_out(on_path_i: CostAccuracy) -> None:
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
        assert left_out == terms(DEAR.candidate) - terms(without.candidate)
        assert excess(without, found.budget) > 1.0


def test_at_rest_inertia_forces_nothing(on_path_i: CostAccuracy) -> None:
    found = advice(on_path_i, budget(0.05))
    assert found.chosen is not None
    assert found.chosen.candidate.fidelity == "general_static"
    assert reasons(found) == {frozenset({"off-axis"}): "exact slender_static, double"}


def test_the_cheapest_of_all_needs_no_reason() -> None:
    assert answer(advice(made_up(CHEAP, DEAR), budget(9.0)))[1:] == ["Nothing is cheaper."]


def test_a_cheaper_kernel_with_more_physics_is_no_reason() -> None:
    richer = dataclasses.replace(entry("exact slender double", 1000, 0.5))
    poorer = entry("exact point_masses double", 1000, 0.1)
    found = advice(made_up(richer, poorer), budget(0.4))
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


def test_the_report_has_every_figure(on_path_i: CostAccuracy) -> None:
    text = report(advice(on_path_i, budget(0.05)))
    assert "tolerance 0.05, margin 3: good enough up to an error of 1.67e-02" in text
    for each in on_path_i.entries:
        line = next(line for line in text.splitlines() if line.startswith(f"{each.candidate.name} "))
        assert f" {each.operations} " in line
        assert f"{each.total:.1e}" in line or each.total == 0.0
    assert text.count("chosen") == 1


def test_report_and_help_say_where_rounding_is_measured(
    on_path_i: CostAccuracy, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        main(["advise", "--help"])
    said = f"Rounding is measured at {study.SAMPLED} poses spread over each motion and at its hardest"
    for text in (capsys.readouterr().out, report(advice(on_path_i, budget(0.05)))):
        assert said in " ".join(text.split())


def test_json_holds_what_was_found_and_no_infinity(on_path_i: CostAccuracy) -> None:
    given = made_up(dataclasses.replace(CHEAP, errors={"I": Errors(math.inf, math.inf, math.inf)}), DEAR)
    for found in (advice(on_path_i, budget(1e-9)), advice(given, budget(0.1))):
        written: dict[str, Any] = json.loads(json.dumps(as_json(found), allow_nan=False))
        assert written["chosen"] == {"formulation": "exact", "fidelity": "general", "precision": "double"}
        assert len(written["candidates"]) == len(found.cost.entries)
        assert [each["terms"] for each in written["needed"]] == [sorted(t) for t, _ in found.needed()]


# commands


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch, on_path_i: CostAccuracy) -> None:
    """The study's figures without running it again."""

    def measured(robot: Robot, motions: Mapping[str, Motion], *_: object, **__: object) -> CostAccuracy:
        assert list(motions) == ["I"]
        return on_path_i

    monkeypatch.setattr(study, "cost", measured)


TABLES = ["bounds.csv", "chart.csv", "chart.json", "chart.txt", "scales.csv"]


def few(patch: pytest.MonkeyPatch) -> None:
    """Few machines and poses in the studies beside the chart."""
    scales_study, bounds_study = scales.scales_study, bound_plot.bounds_study

    def some_scales(progress: Any, robot: Robot) -> scales.Scales:
        return scales_study(progress, robot, "exact", (1.0,), (1.0,), 1, 4)

    def some_bounds(progress: Any, robot: Robot) -> bound_plot.Bounds:
        return bounds_study(progress, 20, robot)

    patch.setattr(scales, "scales_study", some_scales)
    patch.setattr(bound_plot, "bounds_study", some_bounds)


def test_pictures_that_a_machine_cannot_have_are_left_out_with_a_warning(
    found: CostAccuracy, monkeypatch: pytest.MonkeyPatch
) -> None:
    few(monkeypatch)
    robot = random_robot(np.random.default_rng(12), "spherical")
    with pytest.warns(UserWarning, match="^bounds: left out: "):
        made = [chart.name for chart in charts(found, robot)]
    assert made[0] == "chart"
    assert "bounds" not in made


@pytest.mark.usefixtures("quick")
def test_advise_prints_and_writes_its_answer(scene: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = scene.parent / "advice.json"
    assert main(["advise", str(scene), "--json", str(output)]) == 0
    captured = capsys.readouterr()
    assert "Cheapest that is good enough: exact general_static, float" in captured.out
    assert "Forced by centres of mass off the legs' axes" in captured.out
    written = json.loads(output.read_text())
    assert written["chosen"]["fidelity"] == "general_static"
    assert (written["tolerance"], written["margin"], written["rate_Hz"]) == (0.05, 2.0, 1000.0)


def test_advise_runs_the_whole_study(
    scene: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    hasty(monkeypatch)
    assert main(["advise", str(scene)]) == 0
    assert "Cheapest that is good enough: exact general_static, float" in capsys.readouterr().out


@pytest.mark.usefixtures("quick")
def test_advise_without_an_answer_prints_the_table_and_fails_in_one_line(
    scene: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene.write_text(SCENE.replace("0.05", "1e-17"))
    output, kit = scene.parent / "advice.json", scene.parent / "kit"
    assert main(["advise", str(scene), "--json", str(output), "--generate", str(kit)]) == 2
    captured = capsys.readouterr()
    assert captured.out.count("\n") > 28
    (line,) = captured.err.splitlines()
    assert f"{scene}: nothing keeps the budget; closest: exact general, double" in line
    assert json.loads(output.read_text())["chosen"] is None
    assert not kit.exists()


@pytest.mark.usefixtures("quick")
def test_advise_generates_the_kernel_that_it_chose(scene: Path, capsys: pytest.CaptureFixture[str]) -> None:
    kit = scene.parent / "kit"
    assert main(["advise", str(scene), "--generate", str(kit)]) == 0
    names = sorted(path.name for path in kit.iterdir())
    assert "stewart_exact_general_static_forces.c" in names
    printed = capsys.readouterr().out
    assert all(str(kit / name) in printed for name in names)
    # Nothing is replaced unasked.
    (kit / "stewart_robot.c").write_text("mine")
    assert "use --force" in fails_in_one_line(capsys, "advise", scene, "--generate", kit)
    assert main(["advise", str(scene), "--generate", str(kit), "--force", "--bake"]) == 0


def test_advise_does_not_write_over_its_scene(scene: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "is an input" in fails_in_one_line(capsys, "advise", scene, "--json", scene)


@pytest.mark.usefixtures("quick")
def test_chart_writes_tables_without_matplotlib(
    scene: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    few(monkeypatch)
    monkeypatch.delitem(sys.modules, "stewart_sym.studies.paper.plots", raising=False)
    monkeypatch.delattr("stewart_sym.studies.paper.plots", raising=False)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    output = scene.parent / "out"
    before = folder_state(scene.parent)
    assert install("plot") in fails_in_one_line(capsys, "chart", scene, "-o", output)
    assert folder_state(scene.parent) == before
    assert main(["chart", str(scene), "-o", str(output), "--no-pictures"]) == 0
    assert sorted(path.name for path in output.glob("[!.]*")) == TABLES
    assert (output / "chart.txt").read_text() in capsys.readouterr().out


def test_chart_of_the_papers_machine_needs_no_scene(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, found: CostAccuracy
) -> None:
    asked: list[list[str]] = []

    def measured(robot: Robot, motions: Mapping[str, Motion], *_: object) -> CostAccuracy:
        asked.append(list(motions))
        return found

    few(monkeypatch)
    monkeypatch.setattr(study, "cost", measured)
    assert main(["chart", "-o", str(tmp_path / "out")]) == 0
    assert asked == [["I", "II", "III"]]
    pictures = [f"{name}.{kind}" for name in ("chart", "scales", "bounds") for kind in ("png", "svg")]
    assert sorted(path.name for path in (tmp_path / "out").glob("[!.]*")) == sorted([*TABLES, *pictures])
    header, *rows_of_scales = (tmp_path / "out" / "scales.csv").read_text().splitlines()
    assert header.startswith("size_m,platform_mass_kg")
    assert len(rows_of_scales) == 1
    assert len((tmp_path / "out" / "bounds.csv").read_text().splitlines()) > 10
    rows = list(csv.DictReader(io.StringIO((tmp_path / "out" / "chart.csv").read_text())))
    assert {row["motion"] for row in rows} == {"I", "II", "III"}
    written = json.loads((tmp_path / "out" / "chart.json").read_text())
    assert written["software"]["compiler"]
    assert len(written["candidates"]) == len(found.entries)
    capsys.readouterr()


@pytest.mark.parametrize("subcommand", ["advise", "chart"])
def test_help_shows_an_example(subcommand: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main([subcommand, "--help"])
    assert f"Example: stewart-sym {subcommand} enough.toml" in capsys.readouterr().out
