"""The stability study: what it measures with is right, and it finds of the kernels what it must."""

import dataclasses
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import Run
from machines import machine_in_motion, random_motion, random_robot
from sweeps import share

import stewart_sym as ss
from stewart_sym.backend.kernel import robot_numbers
from stewart_sym.cli.main import main
from stewart_sym.derive.emit.header import CASES, THRESHOLDS
from stewart_sym.precision.truth import Truth, deviation
from stewart_sym.results import NOT_FINITE, OK
from stewart_sym.studies.common.report import Picture
from stewart_sym.studies.robustness import (
    attitude,
    legs,
    pictures,
    poses,
    runs,
    shipped,
    singular,
)
from stewart_sym.studies.robustness.family import Curve, distances, verdict
from stewart_sym.studies.robustness.singular import CANDIDATES
from stewart_sym.studies.robustness.sweep import oracle
from stewart_sym.studies.robustness.sweep.machines import LEGS, random_machine
from stewart_sym.studies.robustness.sweep.sweep import sweep

REPOSITORY = Path(__file__).parents[2]

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("sweep_library")]


def test_the_check_agrees_with_fifty_digits() -> None:
    rng = np.random.default_rng(1)
    # Exact numbers: the two differ in what they make of an R that is a rotation to rounding only.
    robot = dataclasses.replace(random_robot(rng), k=np.eye(3)[[0, 1, 1, 0, 0, 1]])
    motion = random_motion(rng, robot, (3,))
    motion = dataclasses.replace(motion, R=np.broadcast_to(np.eye(3), (3, 3, 3)))
    truth = Truth(robot).forces(motion)
    checked = oracle.check_poses([robot] * 3, [motion[i] for i in range(3)])
    for i in range(3):
        F, status = ss.ForceKernel(robot).forces_and_status(motion[i])
        assert status == OK
        units = np.abs(deviation(F, truth[i])).max() / (np.finfo(float).eps * checked["size"][i])
        assert checked["error"][i, 0] == pytest.approx(units, rel=1e-9)


def test_the_check_sees_an_error_of_a_few_units() -> None:
    robot, motion = machine_in_motion(2)
    wrong = dataclasses.replace(robot, M=robot.M * (1.0 + 1e-9))
    truth = Truth(wrong).forces(motion)
    checked = oracle.check_poses([robot], [motion])
    F, _ = ss.ForceKernel(robot).forces_and_status(motion)
    assert np.abs(deviation(F, truth)).max() / checked["size"][0] > 1e4 * checked["error"][0, 0] * 2e-16


def test_long_double_and_quadruple_precision_find_the_same() -> None:
    rng = np.random.default_rng(3)
    robots = [random_machine(rng) for _ in range(4)]
    numbers, sizes = np.array([robot_numbers(robot) for robot in robots]), np.ones(4)
    found = oracle.check_random("singular", numbers, sizes, 20, 5)
    found = found[(found["made"] == 1) & (found["status"][:, 0] == OK)]
    assert len(found) > 40
    assert not found["in_quad"].all()
    for index in range(0, 20, 5):
        robot_, motion = oracle.random_case("singular", numbers, sizes, 20, 5, index)
        again = oracle.check_numbers(robot_[None], motion[None])
        first = oracle.check_random("singular", numbers, sizes, 20, 5)[index]
        if first["status"][0] == OK:
            assert again["error"][0, 0] == pytest.approx(
                first["error"][0], rel=0.05, abs=0.01 * first["scaled"]
            )
            assert again["scaled"][0] == pytest.approx(first["scaled"], rel=1e-2)


def test_the_condition_of_a_leg_frame_is_one_over_the_sine() -> None:
    robots, motions = legs._walk(2, LEGS[1], rest=True)
    frames = oracle.check_poses(robots[8:30], motions[8:30])["frames"]
    assert frames == pytest.approx(1.0 / np.sin(distances()[8:30]), rel=1e-4)


def test_a_verdict_tells_a_silent_error_from_a_status() -> None:
    distance = np.array([1.0, 0.1, 0.01])
    error, condition = np.array([1e-16, 1e-6, 1e-16]), np.ones(3)
    for status, of_pose, undetected, false_alarms, rejected_at in (
        ([0, 0, 0], [1, 1, 1], 1, 0, None),
        ([0, 4, 0], [1, 1e9, 1], 0, 0, 1e9),
        ([0, 4, 0], [1, 1, 1], 0, 1, 1),
    ):
        found = verdict(Curve("a", error, condition * of_pose, np.array(status, np.int32)), distance)
        assert (found["undetected"], found["false_alarms"]) == (undetected, false_alarms)
        assert found["rejected_at"] == rejected_at
        assert found["where"] == 0.1 or not undetected


@pytest.mark.parametrize("name", CANDIDATES)
def test_candidate_solves_solve(name: str) -> None:
    rng = np.random.default_rng(4)
    A, x = rng.normal(size=(6, 6)), rng.normal(size=6)
    assert CANDIDATES[name](A, A @ x) == pytest.approx(x, rel=1e-10)


@pytest.mark.parametrize("path", ["_one_pose", "_batch", "_closed_form"])
def test_an_error_of_a_code_path_is_no_status(path: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Constants that overflow have a status; any other error is one."""

    def wrong(*_: object, **__: object) -> None:
        raise ValueError("wrong")

    monkeypatch.setattr(shipped, "equations_of_motion", wrong)
    robot, none = ss.robots.dasgupta1998(), np.zeros(3)
    unmoved = ss.Motion(R=np.eye(3), t=np.array([0.1, 0.0, 0.5]), omega=none, v=none)
    with pytest.raises(ValueError, match=r"wrong|accelerations"):
        getattr(shipped, path)(robot, unmoved)
    with np.errstate(all="ignore"):
        vast = dataclasses.replace(robot, M=1e300, R_0=np.array([1e10, 0.0, 0.0]))
    assert getattr(shipped, path)(vast, unmoved)[1] == NOT_FINITE


def test_near_a_singular_pose_every_kernel_is_right_or_says_so() -> None:
    robots, motions = singular.path_III()
    for curve in shipped.curves(robots[::4], motions[::4]):
        found = verdict(curve, distances()[::4])
        assert found["undetected"] == found["false_alarms"] == 0, curve.method
        assert found["worst"] < 100, curve.method


def test_the_sine_from_the_cosine_loses_what_the_product_keeps() -> None:
    family = next(each for each in legs.axis_families() if each.name == "joint_sine")
    found = {curve.method: verdict(curve, family.distance) for curve in family.curves}
    assert found["sqrt(1 - (k.s)^2)"]["worst"] > 1e6
    assert found["|k x s|"]["worst"] < 10


def test_limits_of_length_are_told_from_the_first_rounding_unit_on() -> None:
    family = legs._limits(3)
    assert all(np.all(curve.error == 0.0) for curve in family.curves)
    assert any((curve.status != OK).any() for curve in family.curves if curve.status is not None)


def test_orientations_without_a_singularity_keep_their_digits_at_a_pitch_of_90_degrees() -> None:
    family = attitude.families()[0]
    found = {curve.method: verdict(curve, family.distance) for curve in family.curves}
    assert found["roll-pitch-yaw"]["digits"] < 2
    for name in attitude.INPUTS[1:]:
        assert found[name]["digits"] > 12
        assert found[name]["worst"] < 100


def test_damped_steps_find_more_poses_than_newton_s_own() -> None:
    found = poses.basins(grid=15, proofs=5)
    assert found.share("damped, as shipped", poses.LOST) < found.share("Newton as it is", poses.LOST)
    assert found.proven == 1.0


def test_random_cases_near_failure_are_right_or_say_so() -> None:
    cases = share(100_000)
    found = sweep(cases, seed=11)
    assert found.figures["cases"] >= cases
    assert (found.figures["wrong"], found.figures["rejected_good"], found.shown) == (0, 0, [])


def test_the_command_prints_the_sweep(capsys: pytest.CaptureFixture[str]) -> None:
    code = main(["stability", "--cases", "200", "--seed", "1"])
    assert code in (0, 1)
    assert "random cases near failure" in capsys.readouterr().out


def test_too_few_cases_are_rejected_in_one_line(run: Run) -> None:
    assert run("stability", "--cases", "3", code=2).err.startswith(
        "stewart-sym: error: cases: expected at least"
    )


def test_the_command_writes_the_study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for each in ("family", "scales"):
        monkeypatch.setattr(f"stewart_sym.studies.robustness.{each}.POINTS", 9)
    monkeypatch.setattr(runs, "LONGEST", 0.05)
    monkeypatch.setattr(runs, "TIME_CONSTANTS", runs.TIME_CONSTANTS[:2])
    every: dict[str, Picture] = {}
    all_pictures = pictures.pictures

    def two(*found: Any) -> dict[str, Picture]:
        """A family's picture, since they are drawn alike, and that of the basins."""
        every.update(all_pictures(*found))
        return {name: every[name] for name in ("run_stiff", "basins")}

    monkeypatch.setattr(pictures, "pictures", two)
    assert main(["stability", "-o", str(tmp_path), "--cases", "90"]) == 0
    figures = json.loads((tmp_path / "stability.json").read_text(encoding="utf-8"))
    names = {family["name"] for family in figures["families"]}
    assert {path.stem for path in tmp_path.glob("*.csv")} == names
    assert every.keys() == names | {"basins"}
    assert {path.stem for path in tmp_path.glob("*.png")} == {"run_stiff", "basins"}


def test_the_header_s_reasons_for_its_thresholds_are_what_the_committed_sweep_saw() -> None:
    sweep_s = json.loads((REPOSITORY / ".docs" / "stability.json").read_text())["sweep"]["counts"]
    double = [count for count in sweep_s if count["precision"] == "double"]
    kinds = len({count["kind"] for count in double})
    assert CASES <= kinds * double[0]["cases"] < 1.01 * CASES
    for each in THRESHOLDS:
        worst = max(
            (count for count in double if count["kind"] == each.kind), key=lambda count: count["worst"]
        )
        assert (math.ceil(worst["worst"]), f"{worst['where']:.1e}") == (each.worst, each.where)
