"""The stability study: what it measures with is right, and it finds of the kernels what it must."""

import dataclasses
import json
import math
from pathlib import Path

import numpy as np
import pytest
import stability_tables
from machines import machine_in_motion, random_motion, random_robot
from sweeps import share

import stewart_sym as ss
from stewart_sym.cli.main import main
from stewart_sym.derive.emit.header import CASES, THRESHOLDS
from stewart_sym.motion.motion import Motion
from stewart_sym.precision.exact_forces import Truth, deviation
from stewart_sym.results import OK, SINGULAR
from stewart_sym.studies.robustness import failures, study
from stewart_sym.studies.robustness.oracle import FORCES, Cases, Verdict, cases_of, check, truth_of

REPOSITORY = Path(__file__).parents[2]

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("sweep_library")]


def sizes(cases: Cases) -> np.ndarray:
    """Sizes of which the errors of forces are counted in rounding units, shape (n,)."""
    return np.abs(truth_of(cases, FORCES[2], samples=0).values[:, :18]).max(axis=1).astype(float)


def test_the_check_agrees_with_fifty_digits() -> None:
    rng = np.random.default_rng(1)
    # Exact numbers: the two differ in what they make of an R that is a rotation to rounding only.
    robot = dataclasses.replace(random_robot(rng), k=np.eye(3)[[0, 1, 1, 0, 0, 1]])
    motion = random_motion(rng, robot, (3,))
    motion = dataclasses.replace(motion, R=np.broadcast_to(np.eye(3), (3, 3, 3)))
    truth = Truth(robot).forces(motion)
    cases = cases_of([robot] * 3, [motion[i] for i in range(3)])
    found, size = check(cases, FORCES), sizes(cases)
    for i in range(3):
        F, status = ss.ForceKernel(robot).forces_and_status(motion[i])
        assert status == OK
        units = np.abs(deviation(F, truth[i])).max() / (np.finfo(float).eps * size[i])
        assert found["one_pose"].error[i] == pytest.approx(units, abs=0.01)


def test_a_summary_tells_a_silent_error_from_a_status() -> None:
    distance = np.array([1.0, 0.1, 0.01])
    truth = np.zeros(3, dtype=np.int32)
    for status, condition, wrong, rejected_good, rejected_at in (
        ([0, 0, 0], 1.0, 1, 0, math.inf),
        ([0, 4, 0], 1e13, 0, 0, 1e13),
        ([0, 4, 0], 1.0, 0, 1, 1.0),
    ):
        error = np.array([0.5, 1e4 * condition, 0.5])
        pose = np.array([1.0, condition, 1.0])
        found = study.summary(Verdict(error, pose, pose, np.array(status, np.int32), truth), distance)
        assert (found["wrong"], found["rejected_good"], found["rejected_at"]) == (
            wrong,
            rejected_good,
            rejected_at,
        )
        assert found["where"] == 0.1 or not wrong


def test_an_answer_for_an_unsolvable_pose_is_wrong() -> None:
    robot, motion = machine_in_motion(3)
    found = check(cases_of([robot], [motion]), FORCES, solvable=False)["batch"]
    assert found.truth[0] == SINGULAR
    assert study.summary(found, np.ones(1))["wrong"] == 1


def test_constants_that_overflow_have_a_status() -> None:
    robot, none = ss.robots.dasgupta1998(), np.zeros(3)
    with np.errstate(all="ignore"):
        vast = dataclasses.replace(robot, M=1e300, R_0=np.array([1e10, 0.0, 0.0]))
        unmoved = Motion(R=np.eye(3), t=np.array([0.1, 0.0, 0.5]), omega=none, v=none)
        found = check(cases_of([vast], [unmoved]), FORCES, samples=0)
    assert [int(each.status[0]) for each in found.values()] == [1, 1, 1]


@pytest.mark.parametrize(
    "family", [each for each in failures.FAMILIES if each.in_range], ids=lambda f: f.name
)
def test_near_a_failure_every_kernel_is_right_or_says_so(family: failures.Family) -> None:
    cases = family.make(np.random.default_rng(family.seed))[::4]
    for kernel, found in check(cases, (*FORCES, *study.CLOSED), floor=True).items():
        summary = study.summary(found, cases.distance)
        assert summary["shown"] == "", kernel
        assert summary["worst"] < 100, kernel


def test_random_cases_near_failure_are_right_or_say_so() -> None:
    cases = share(50_000, 50)
    found = study.sweep(cases, seed=11)
    assert found["cases"] >= 0.99 * cases
    assert [count["shown"] for count in found["counts"] if count["shown"]] == []


def test_the_command_writes_the_study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(failures, "POINTS", 9)
    few = [family for family in failures.FAMILIES if family.name == "zero_length"]
    monkeypatch.setattr(study, "FAMILIES", few)
    assert main(["stability", "-o", str(tmp_path), "--cases", "200"]) == 0
    figures = json.loads((tmp_path / "stability.json").read_text(encoding="utf-8"))
    names = {family["name"] for family in figures["families"]}
    assert {path.stem for path in tmp_path.glob("*.[cp][sn][vg]")} == names == {"zero_length"}
    assert stability_tables.tables(figures).keys() == {"stability_families", "stability_cases"}


def test_the_header_s_reasons_for_its_thresholds_are_what_the_committed_sweep_saw() -> None:
    sweep_s = json.loads((REPOSITORY / ".docs" / "stability.json").read_text())["sweep"]
    assert sweep_s["cases"] >= CASES
    double = [count for count in sweep_s["counts"] if count["precision"] == "double"]
    for each in THRESHOLDS:
        worst = max(
            (count for count in double if count["kind"] == each.kind), key=lambda count: count["worst"]
        )
        assert (math.ceil(worst["worst"]), f"{worst['where']:.1e}") == (each.worst, each.where)
