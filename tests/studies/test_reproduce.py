"""Section 5 of the paper computed again: figures, verdicts, tables and pictures."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from pages import DOCS, same_picture

from stewart_sym.backend.kernel import FORMULATIONS
from stewart_sym.dynamics.inverse_dynamics import inverse_dynamics
from stewart_sym.motion.straight_line import PAPER_PATHS
from stewart_sym.reference.newton_euler import EXACT, PAPER
from stewart_sym.robots import dasgupta1998
from stewart_sym.studies.common.report import draw
from stewart_sym.studies.paper import plots
from stewart_sym.studies.paper.claims import (
    FAILS,
    HOLDS,
    PAPER_FLOPS,
    PARTLY,
    SERIAL_ARM_FLOPS,
    claims,
    counted_fractions,
    crossing_legs,
    rank_correlation,
)
from stewart_sym.studies.paper.paper_report import WIDTH, report
from stewart_sym.studies.paper.reproduce import Reproduction, reproduce, run_columns, work_energy


@pytest.fixture(scope="module")
def found() -> Reproduction:
    return reproduce()


def test_peaks_of_path_three(found: Reproduction) -> None:
    for form, force in (("paper", 9.60e5), ("exact", 9.73e5)):
        run = found.runs["III", form]
        assert run.condition.max() == pytest.approx(2.1e4, rel=0.005)
        assert run.time[run.condition.argmax()] == pytest.approx(3.7)
        assert np.abs(run.F).max() == pytest.approx(force, rel=0.001)


def test_path_three_is_singular_between_two_instants_of_the_grid(found: Reproduction) -> None:
    assert found.singular_time == pytest.approx(3.6705, abs=1e-4)


def test_both_formulations_share_massless_forces_and_condition(found: Reproduction) -> None:
    for path in PAPER_PATHS:
        paper, exact = found.runs[path, "paper"], found.runs[path, "exact"]
        np.testing.assert_array_equal(paper.F0, exact.F0)
        np.testing.assert_allclose(paper.condition, exact.condition, rtol=1e-9)


@pytest.mark.parametrize(
    ("faults", "one", "two"),
    [({1}, 6.68e-5, 5.03e-3), ({2}, 0.01931, 0.01718), ({3}, 7.71e-4, 0.05801), (PAPER, 0.01924, 0.05781)],
)
def test_cost_of_the_printed_faults(found: Reproduction, faults: set[int], one: float, two: float) -> None:
    moving = next(cost["moving"] for cost in found.fault_costs if cost["faults"] == sorted(faults))
    assert [moving["I"], moving["II"]] == pytest.approx([one, two], rel=2e-3)


def test_only_the_joint_moment_and_the_sign_cost_anything_at_rest(found: Reproduction) -> None:
    felt = [cost["faults"] for cost in found.fault_costs if max(cost["at_rest"].values()) > 1e-12]
    assert felt == [[2], sorted(PAPER), [4]]


@pytest.mark.parametrize(("path", "percent"), [("I", -0.713), ("II", -1.129), ("III", -0.045)])
def test_paper_misses_the_gain_of_energy(found: Reproduction, path: str, percent: float) -> None:
    mismatch = _mismatch(found, path, PAPER)
    assert 100 * mismatch == pytest.approx(percent, abs=0.001)


def test_exact_meets_the_gain_of_energy_even_through_the_singular_pose(found: Reproduction) -> None:
    assert abs(_mismatch(found, "I", EXACT)) < 1e-13
    assert abs(_mismatch(found, "II", EXACT)) < 1e-13
    # Rounding times condition numbers of 4e5 beside the singular pose.
    assert abs(_mismatch(found, "III", EXACT)) < 1e-12


def test_work_is_that_of_the_compiled_forces(monkeypatch: pytest.MonkeyPatch) -> None:
    def doubled(*arguments: object) -> object:
        forces = inverse_dynamics(*arguments)  # type: ignore[arg-type]
        return dataclasses.replace(forces, F=2 * forces.F)

    robot = dasgupta1998()
    before = [work_energy(robot, "I", faults)["work_J"] for faults in (EXACT, PAPER, frozenset({2}))]
    monkeypatch.setattr("stewart_sym.studies.paper.reproduce.inverse_dynamics", doubled)
    after = [work_energy(robot, "I", faults)["work_J"] for faults in (EXACT, PAPER, frozenset({2}))]
    np.testing.assert_allclose(np.divide(after, before), [2, 2, 1])


def test_operations_add_up(found: Reproduction) -> None:
    assert len(found.operations) == 4
    for row in found.operations:
        parts = 6 * np.array(row["leg"]) + row["platform"] + row["final"]
        assert parts.tolist() == row["total"]
        assert min(row["final"]) >= 0
        assert sum(row["total"]) <= (3600 if row["friction"] else 3300)
    assert 6 * PAPER_FLOPS["leg"] + PAPER_FLOPS["platform"] + PAPER_FLOPS["final"] == PAPER_FLOPS["total"]
    assert PAPER_FLOPS["total"] / SERIAL_ARM_FLOPS == pytest.approx(3.36, abs=0.005)


def test_verdicts_on_the_text(found: Reproduction) -> None:
    rows = claims(found)
    assert {row["says"] for row in rows if row["paper"]["verdict"] == PARTLY} == {
        "leg inertia generally contributes 20 to 50% of the forces",
        "the higher the condition number, the higher the forces",
    }
    assert not [row["says"] for row in rows if row["paper"]["verdict"] == FAILS]
    assert [row["says"] for row in rows if row["exact"]["verdict"] != row["paper"]["verdict"]] == [
        "Path I: its maximum may even go up to 40%"
    ]


def test_a_false_claim_is_called_false(found: Reproduction) -> None:
    heavier = {key: dataclasses.replace(run, F=100 * run.F) for key, run in found.runs.items()}
    for runs, verdict in ((heavier, FAILS), (found.runs, HOLDS)):
        every = claims(dataclasses.replace(found, runs=runs))
        row = next(row for row in every if "order as the weight" in row["says"])
        assert (row["paper"]["verdict"], row["exact"]["verdict"]) == (verdict, verdict)


def test_dynamic_fractions_of_path_one_as_the_paper_tells_them(found: Reproduction) -> None:
    run = found.runs["I", "paper"]
    assert np.median(counted_fractions(run)) == pytest.approx(0.184, abs=1e-3)
    assert crossing_legs(run) == [5, 6]
    assert np.abs(run.fraction[:, :4]).max() == pytest.approx(0.405, abs=1e-3)


def test_a_light_platform_leaves_most_of_the_force_to_the_legs(found: Reproduction) -> None:
    for form in FORMULATIONS:
        assert np.mean(counted_fractions(found.light[form]) > 0.6) > 0.8


def test_rank_correlation() -> None:
    x = np.array([1.0, 2.0, 5.0, 3.0])
    assert rank_correlation(x, x**3) == pytest.approx(1.0)
    assert rank_correlation(x, -x) == pytest.approx(-1.0)
    assert rank_correlation(x, np.array([2.0, 1.0, 4.0, 3.0])) == pytest.approx(0.8)


def test_columns_of_a_run_keep_the_papers_decomposition(found: Reproduction) -> None:
    columns = run_columns(found.runs["II", "exact"])
    assert len(columns) == 27
    np.testing.assert_allclose(columns["F0_4"] + columns["Fd_4"], columns["F_4"], rtol=1e-12)
    np.testing.assert_allclose(columns["dynamic_fraction_4"] * columns["F_4"], columns["Fd_4"], rtol=1e-12)


def test_report_shows_every_claim_and_fits_its_width(found: Reproduction) -> None:
    text = report(found)
    words = " ".join(text.split())
    for number in ("34.69 to 47.19", "-0.7130%", "-1.1288%", "5.80%", "40.5%", "4889", "694", "273", "452"):
        assert number in words
    tables = text[text.index("(a)") :]
    assert max(map(len, tables.splitlines())) <= WIDTH


@pytest.mark.slow
def test_every_figure_has_a_picture_that_is_reproducible_and_the_one_of_the_documentation(
    found: Reproduction, tmp_path: Path
) -> None:
    pictures = plots.pictures(found)
    assert [name[:5] for name in sorted(pictures)] == [f"fig{n:02d}" for n in range(4, 11)]
    name = min(pictures)
    for folder in (tmp_path / "one", tmp_path / "two"):
        folder.mkdir()
        draw(pictures[name], folder / name)
    assert same_picture(tmp_path / "one" / f"{name}.png", DOCS / "path_I_forces.png")
    written = sorted((tmp_path / "one").glob("[!.]*"))
    assert [path.name for path in written] == [f"{name}.png", f"{name}.svg"]
    for path in written:
        content = path.read_bytes()
        assert len(content) > 10_000
        assert (path.suffix == ".png") == content.startswith(b"\x89PNG")
        assert content == (tmp_path / "two" / path.name).read_bytes()


@pytest.mark.parametrize(("number", "path"), [(6, "I"), (8, "II")])
def test_no_line_of_a_fraction_leads_through_a_zero_of_the_force(
    found: Reproduction, number: int, path: str
) -> None:
    figure = plots.fraction_figure(number, found.runs[path, "paper"], found.runs[path, "exact"])
    for axes in figure.axes:
        low, high = axes.get_ylim()
        for line in axes.get_lines()[:2]:
            steps = np.abs(np.diff(np.asarray(line.get_ydata(), dtype=float)))
            assert np.nanmax(steps) <= 0.5 * (high - low)


def _mismatch(found: Reproduction, path: str, faults: frozenset[int]) -> float:
    of = (path, sorted(faults))
    return next(row["mismatch"] for row in found.work_energy if (row["path"], row["faults"]) == of)
