"""`benchmark`: all candidates take part and compute the same forces, and the figures are right. No timing."""

import dataclasses
import gc
import re
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from machines import dasgupta, random_motion, random_robot
from small_bench import CONTESTANTS, Array, poses_of

import stewart_sym as ss
from stewart_sym.io.extras import EXTRAS
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.benchmark import baselines, bench, equation_kernels
from stewart_sym.studies.benchmark.baselines import JAX, Called, Candidate, Runner, jax_one_pose
from stewart_sym.studies.benchmark.engines.drake_inverse import drake_inverse
from stewart_sym.studies.benchmark.engines.pinocchio import pinocchio_rnea
from stewart_sym.studies.benchmark.equation_kernels import engines
from stewart_sym.studies.benchmark.figures import batched
from stewart_sym.studies.benchmark.poses import Poses, bench_poses
from stewart_sym.studies.benchmark.processor import FUSED, Flags, targets

TENSORS = ("I_p", "I_d0", "I_u0")
pytestmark = pytest.mark.usefixtures("quickly")


def off(candidate: Candidate, share: float) -> Candidate:
    """The candidate with forces wrong by a share of the largest."""

    def make(poses: Poses, flags: Flags) -> Runner:
        runner = candidate.make(poses, flags)
        return Runner(runner.run, lambda: runner.F() + share * np.abs(runner.F()).max())

    return dataclasses.replace(candidate, make=make)


# what is compared


@pytest.mark.parametrize("candidate", CONTESTANTS, ids=lambda candidate: candidate.name)
def test_a_candidate_computes_the_forces_of_any_machine(candidate: Candidate, stranger: Poses) -> None:
    runner = candidate.runner(stranger)
    runner.run(1)
    F = ss.inverse_dynamics(stranger.robot, stranger.motion, backend="reference").F
    assert np.abs(runner.F() - F).max() <= candidate.tolerance * np.abs(F).max()


@pytest.mark.parametrize(
    "candidate", [each for each in CONTESTANTS if each.function], ids=lambda candidate: candidate.name
)
def test_c_with_other_flags_computes_the_same_forces(candidate: Candidate, stranger: Poses) -> None:
    other = dataclasses.replace(candidate, flags=(*targets()[-1].flags, *FUSED))
    assert other.label != candidate.label
    assert other.runner(stranger).library is not candidate.runner(stranger).library
    test_a_candidate_computes_the_forces_of_any_machine(other, stranger)


def test_jax_runs_the_kernel_on_every_pose(stranger: Poses, monkeypatch: pytest.MonkeyPatch) -> None:
    """With a formula in the kernel's place, which JAX compiles at once."""

    def weighed(robot: Robot, on: Any, formulation: str) -> Any:
        assert (robot, formulation) == (stranger.robot, "exact")
        return SimpleNamespace(
            forces=lambda R, t, *rest: SimpleNamespace(F=on.full(6, R[0] @ t + rest[-1][1]))
        )

    monkeypatch.setattr(baselines, "ArrayKernel", weighed)
    motion = stranger.motion
    F = np.einsum("ni,ni->n", motion.R[:, 0], motion.t) + motion.M_ext[:, 1]
    runner, one_pose = JAX.runner(stranger), jax_one_pose(stranger)
    for found in (runner.F(), one_pose.found()):
        np.testing.assert_allclose(found, np.tile(F[:, None], 6), rtol=1e-12)
    for part in (runner, *one_pose.parts):
        part.run(1)


def test_a_full_run_without_jax_says_so_and_a_quick_one_needs_none(
    monkeypatch: pytest.MonkeyPatch, stranger: Poses
) -> None:
    asked: list[tuple[str, ...]] = []

    def none_of(*packages: str) -> tuple[str, ...]:
        asked.append(packages)
        raise KeyboardInterrupt

    monkeypatch.setattr(bench, "absent", none_of)
    for quick in (True, False):
        with pytest.raises(KeyboardInterrupt):
            bench.bench(stranger.robot, quick=quick)
    assert ["jax" in packages for packages in asked] == [False, True]
    assert EXTRAS["jax"] == ("JAX", "bench")


def test_pinocchio_computes_the_same_forces_with_friction_and_load(stranger: Poses) -> None:
    called_computes_the_forces_of(pinocchio_rnea(stranger.robot, stranger.motion), stranger)


def test_drake_computes_the_same_forces_with_friction_and_load(stranger: Poses) -> None:
    called_computes_the_forces_of(drake_inverse(stranger.robot, stranger.motion), stranger)
    printed = bench_poses(None, 4)
    called_computes_the_forces_of(drake_inverse(printed.robot, printed.motion), printed)


def called_computes_the_forces_of(called: Called, poses: Poses) -> None:
    F = ss.inverse_dynamics(poses.robot, poses.motion, backend="reference").F
    assert np.abs(called.found() - F).max() <= 1e-10 * np.abs(F).max()
    for part in called.parts:
        part.run(1)


@pytest.mark.slow
@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("group", ["OURS", "CALLS", "PEERS"])
def test_wrong_forces_stop_the_run_before_anything_is_timed(
    group: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, *others = getattr(bench, group)
    monkeypatch.setattr(bench, group, (off(first, 1e-9), *others))
    monkeypatch.setattr(bench, "targets", lambda: targets()[:1])
    monkeypatch.setattr(bench, "stages", lambda _: ())
    monkeypatch.setattr(bench, "measured", None)
    rejects(f"^{re.escape(first.name)}: forces differ", bench.bench, quick=True)


def test_poses_all_differ_and_are_the_same_in_every_run() -> None:
    rows, again = (bench_poses(None, 500).rows for _ in range(2))
    np.testing.assert_array_equal(rows, again)
    assert all(len(np.unique(column)) == 500 for column in rows.T)


def test_a_machine_without_universal_joints_is_rejected() -> None:
    robot = random_robot(np.random.default_rng(3), "spherical")
    rejects("expected universal base joints", bench_poses, robot, 10)


def test_a_machine_that_is_singular_everywhere_is_rejected() -> None:
    robot = dasgupta()
    none = dataclasses.replace(robot, p=np.tile(robot.p[:1], (6, 1)))
    rejects("no regular poses", bench_poses, none, 10)


def test_a_robot_with_rotors_is_timed_without_them() -> None:
    robot = ss.robots.rubin_m2()
    driven = dataclasses.replace(robot, drive=ss.Drive(lead=0.005, rotor_inertia=1e-5))
    with pytest.warns(UserWarning, match="timed without its rotors"):
        assert not bench_poses(driven, 10).robot.has_rotors


def test_fewer_poses_are_the_first_without_a_copy_and_more_come_round_again() -> None:
    poses = bench_poses(None, 10)
    fewer, more = poses.resized(4), poses.resized(25)
    assert all(map(np.shares_memory, fewer.arrays, poses.arrays))
    np.testing.assert_array_equal(fewer.rows, poses.rows[:4])
    np.testing.assert_array_equal(more.rows, poses.rows[np.arange(25) % 10])


@pytest.mark.usefixtures("small")
def test_every_pass_computes_the_forces_of_any_machine_from_its_own_model(stranger: Poses) -> None:
    stages_compute_the_forces_of(stranger)


@pytest.mark.slow
def test_every_derived_pass_computes_the_forces_of_any_machine(stranger: Poses) -> None:
    stages_compute_the_forces_of(stranger)


def stages_compute_the_forces_of(stranger: Poses) -> None:
    F = ss.inverse_dynamics(stranger.robot, stranger.motion, backend="reference").F
    for stage in baselines.stages():
        for candidate in stage.candidates:
            runner = candidate.runner(stranger)
            runner.run(1)
            assert np.abs(runner.F() - F).max() <= candidate.tolerance * np.abs(F).max()


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("number", [0, 1], ids=["one pose", "batch"])
def test_a_pass_with_wrong_forces_stops_the_run(number: int, monkeypatch: pytest.MonkeyPatch) -> None:
    first, *others = baselines.stages()
    candidates = [off(each, 1e-9) if i == number else each for i, each in enumerate(first.candidates)]
    bad = dataclasses.replace(first, candidates=tuple(candidates))
    monkeypatch.setattr(bench, "stages", lambda _: (bad, *others))
    monkeypatch.setattr(bench, "targets", lambda: targets()[:1])
    monkeypatch.setattr(bench, "measured", None)
    rejects(r"^as derived, .*: forces differ", bench.bench, quick=True)


# equations of motion and their baselines


@pytest.mark.slow
@pytest.mark.parametrize("friction", [False, True])
def test_all_of_the_second_group_agree_on_any_machine(friction: bool) -> None:
    rng = np.random.default_rng(7 + friction)
    robot = random_robot(rng, friction=friction)
    group = equation_kernels.motion_group(poses_of(robot, random_motion(rng, robot, (20,))), targets())
    assert all(np.array_equal(getattr(group.robot, name), getattr(robot, name)) for name in TENSORS)
    baselines = [engine.name for engine in group.engines]
    ours = [name for each in equation_kernels.FUNCTIONS for name in (each.name, batched(each.name))]
    assert [*group.differences] == [*ours, *baselines]
    assert len(group.tasks) == len(targets()) * len(ours) + 2 * len(baselines)
    assert all(group.differences[name] < 1e-6 for name in baselines)
    gc.collect()
    for task in group.tasks:
        task.run(1)


@pytest.mark.parametrize("function", equation_kernels.FUNCTIONS, ids=lambda function: function.name)
def test_a_wrong_answer_of_the_second_group_stops_the_run(
    function: equation_kernels.Function, monkeypatch: pytest.MonkeyPatch, stranger: Poses
) -> None:
    drives = equation_kernels.library()

    def wrong(robot: Robot, motion: ss.Motion, F: Array) -> list[Array]:
        *others, last = function.expected(robot, motion, F)
        return [*others, last * (1 + 2 * function.tolerance)]

    monkeypatch.setattr(equation_kernels, "FUNCTIONS", (dataclasses.replace(function, expected=wrong),))
    monkeypatch.setattr(equation_kernels, "library", lambda _: drives)
    with pytest.raises(ValueError, match=f"^{re.escape(function.name)}: numbers differ"):
        equation_kernels.motion_group(stranger, targets()[:1])


@pytest.mark.slow
def test_a_wrong_baseline_stops_the_run(monkeypatch: pytest.MonkeyPatch, stranger: Poses) -> None:
    def heavier(robot: Robot, *rest: Any) -> Any:
        return engines(dataclasses.replace(robot, M=1.01 * robot.M), *rest)

    monkeypatch.setattr(equation_kernels, "engines", heavier)
    with pytest.raises(ValueError, match=r"^Pinocchio: numbers differ"):
        equation_kernels.motion_group(stranger, targets()[:1])
