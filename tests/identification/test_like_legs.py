"""Legs that are built alike: their parameters are sought once, and found so."""

import dataclasses
import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from machines import random_motion, random_robot
from noisy_experiments import change
from robot_files import written

import stewart_sym as ss

SIGMA = 0.5
OF_LEGS = ("m_d", "r_d0", "I_d0", "m_u", "r_u0", "I_u0", "C_u", "C_p", "C_s")


@cache
def robot(seed: int) -> ss.Robot:
    """A random machine all whose legs are as its first."""
    machine = random_robot(np.random.default_rng(seed))
    same = {name: np.repeat(getattr(machine, name)[:1], 6, axis=0) for name in OF_LEGS}
    return dataclasses.replace(machine, **same)


@cache
def excited(seed: int) -> ss.Excitation:
    return ss.choose_excitation(robot(seed), samples=60, candidates=3, identical_legs=True)


@pytest.mark.parametrize("seed", range(3))
def test_legs_alike_have_22_combinations_and_three_of_friction(seed: int) -> None:
    base = ss.base_parameters(robot(seed), identical_legs=True)
    assert base.rank == 25
    assert base.rank_gap > 1e9
    assert [name for name in base.names if name.startswith("C_")] == ["C_u", "C_p", "C_s"]
    assert ss.base_parameters(robot(seed), friction=False, identical_legs=True).rank == 22
    assert not any(character.isdigit() for name in base.names for character in name)
    assert "M + 6*m_u" in base.formulas


@pytest.mark.parametrize("seed", range(3))
def test_they_give_the_wrench_of_any_motion(seed: int) -> None:
    rng = np.random.default_rng(seed)
    base, pi = ss.base_parameters(robot(seed), identical_legs=True), ss.inertial_parameters(robot(seed))
    motion = random_motion(rng, robot(seed), (20,))
    Y = ss.regressor(robot(seed), motion)
    values = base.matrix @ pi.values
    wrench = Y @ pi.values
    within = 1e-11 * np.max(np.abs(Y) @ np.abs(pi.values))
    np.testing.assert_allclose(Y @ base.expansion @ values, wrench, rtol=0, atol=within)
    reduced = base.reduce(ss.regressor(robot(seed), motion, columns=base.required_columns()))
    np.testing.assert_allclose(reduced @ values, wrench, rtol=0, atol=within)
    np.testing.assert_allclose(base.matrix @ base.expansion, np.eye(25), atol=1e-15)


@pytest.mark.slow
def test_noisy_forces_give_them_within_what_the_covariance_says() -> None:
    runs = [ss.simulate_experiment(robot(1), excited(1), SIGMA, noise) for noise in range(40)]
    off = [run.estimate.values - run.true_values for run in runs]
    weighed = [x @ np.linalg.solve(run.estimate.covariance, x) for x, run in zip(off, runs, strict=True)]
    assert np.mean(weighed) == pytest.approx(25, abs=4.0 * np.sqrt(2.0 * 25 / len(runs)))
    assert np.mean([np.max(np.abs(run.z_scores)) < 4.0 for run in runs]) >= 0.95
    assert np.mean([run.estimate.verdict == "consistent" for run in runs]) >= 0.95


def test_a_leg_that_differs_is_seen_in_the_residual() -> None:
    machine, way = robot(0), excited(0)
    odd = dataclasses.replace(machine, m_u=machine.m_u * [1, 1, 1.5, 1, 1, 1])
    assert np.abs(change(machine, odd, way.motion)).max() > 10.0 * SIGMA
    F = ss.inverse_dynamics(odd, way.motion).F + SIGMA * np.random.default_rng(4).normal(size=(60, 6))
    assert ss.identify(odd, way.motion, F, SIGMA, identical_legs=True).verdict in ("misfit", "rejected")


def test_the_flag_reports_shared_parameters(tmp_path: Path, run: Run) -> None:
    file = written(robot(1), tmp_path / "robot.toml")
    out = ["-o", str(tmp_path / "out"), "--samples", "60", "--candidates", "2", "--force-std", "0.5"]
    told = run("identify", file, "--identical-legs", *out).out
    assert "25 base parameters of 148" in told
    assert "all legs have the same" in told
    data = json.loads((tmp_path / "out" / "report.json").read_text())
    assert (data["identical_legs"], len(data["parameters"])) == (True, 25)
    measured = ["--measured", *(str(tmp_path / "out" / name) for name in ("trajectory.csv", "forces.csv"))]
    again = ["-o", str(tmp_path / "again"), "--force-std", "0.5", "--identical-legs", *measured]
    assert "verdict: consistent" in run("identify", file, *again).out
