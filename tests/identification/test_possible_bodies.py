"""Bodies that cannot be are named, and the command identifies with noise, units and possible bodies."""

import csv
import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest
from command_line import Run, read
from log_files import NAMES
from machines import dasgupta
from noisy_experiments import excited, experiment, robot, truth
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.identification import physical
from stewart_sym.identification.excitation import force_regressor
from stewart_sym.identification.parameters import BODIES, FRICTION
from stewart_sym.studies.reports import identify


def test_possible_machines_are_not_named_and_impossible_ones_are() -> None:
    for seed in (3, 11, 19):
        base, values = truth(robot(seed))
        assert physical.negative(robot(seed), base, values, np.eye(base.rank)) == ((), ())
    place = {name: i for i, name in enumerate(base.names)}
    for name, shift, words in (
        ("C_p3", -1e6, "C_p3: expected no negative value"),
        ("J_u2_yy", -1e6, "leg 2: second moment"),
        ("M", -1e6, "platform: smallest pseudo-inertia"),
        ("h_P_x", 1e6, "platform: smallest pseudo-inertia"),
    ):
        wrong = values.copy()
        wrong[place[name]] += shift
        named, near = physical.negative(robot(seed), base, wrong, np.eye(base.rank))
        assert (len(named), near) == (1, ())
        assert named[0].startswith(words)


@pytest.mark.parametrize(("deviations", "sure"), [(3.5, False), (4.5, True)])
def test_a_value_below_zero_by_noise_is_not_distinguishable_from_0(deviations: float, sure: bool) -> None:
    base, values = truth(robot(0))
    i = base.names.index("C_p3")
    values[i], sigma = -0.02, 0.02 / deviations
    found = physical.negative(robot(0), base, values, sigma**2 * np.eye(base.rank))
    lines = found.impossible if sure else found.near_zero
    assert sum(map(len, found)) == 1
    said = "expected no negative value, got" if sure else "not distinguishable from 0,"
    assert lines[0].startswith(f"C_p3: {said} -0.02 +- ")


def test_a_right_experiment_calls_no_result_impossible() -> None:
    machine = dataclasses.replace(robot(0), C_u=np.zeros(6), C_p=np.zeros(6), C_s=np.zeros(6))
    found = ss.simulate_experiment(machine, excited(0), 30.0).estimate
    assert found.nonphysical == ()
    assert found.near_zero
    assert all("not distinguishable from 0" in line for line in found.near_zero)
    assert identify.doubts(found) == list(found.warnings)


@pytest.mark.slow
def test_physical_estimates_belong_to_bodies_also_from_a_wrong_robot_file() -> None:
    machine, found = robot(1), experiment(1)
    guess = dataclasses.replace(machine, M=3.0 * machine.M, m_u=2.0 * machine.m_u, C_p=0.0 * machine.C_p)
    base = found.estimate.base
    seen = ss.identify(
        guess, found.measured_motion, found.F, 1.0, base, found.pose_noise, enforce_physical=True
    )
    assert seen.verdict == "consistent"
    assert seen.nonphysical == ()
    assert np.allclose(base.matrix @ seen.parameters.values, seen.values)
    assert np.max(np.abs(seen.values - found.true_values) / seen.std) < 4.0
    assert np.all(seen.std <= found.estimate.std * 1.001)
    assert seen.compare_with(guess)[1] < 1e-3 < seen.compare_with(machine)[1]
    pi = seen.parameters.values
    assert all(np.linalg.eigvalsh(physical.pseudo_inertia(pi[body])).min() > 0.0 for body in BODIES)
    assert pi[FRICTION].min() >= 0.0
    A = force_regressor(machine, excited(1).motion, base)
    off, free = (A @ (each.values - found.true_values) for each in (seen, found.estimate))
    assert np.mean(off**2) < 1.2 * np.mean(free**2)


STATED = ("--position-std", "1e-4", "--angle-std", "1e-4")


@pytest.mark.slow
def test_command_states_noise_and_verdict(tmp_path: Path, run: Run) -> None:
    few = ("--samples", "80", "--candidates", "2")
    simulated = tmp_path / "simulated"
    run("identify", PAPERS, *few, *STATED, "-o", simulated)
    verdict = (simulated / "report.txt").read_text().splitlines()[0]
    assert verdict.startswith("verdict: consistent")
    assert verdict.endswith("if all legs are alike, --identical-legs determines more")
    columns = read(simulated / "parameters.csv")
    sure = sum(abs(float(row["estimated"])) > 3.0 * float(row["std"]) for row in columns)
    assert f"; {sure} of 100 parameters are determined" in verdict
    with open(simulated / "trajectory.csv", newline="") as stream:
        assert next(csv.reader(stream)) == NAMES
    measured = ["--measured", *(str(simulated / name) for name in ("trajectory.csv", "forces.csv"))]
    period = str(ss.choose_excitation(dasgupta(), samples=8, candidates=1).path.period)
    right = tmp_path / "right"
    told = [*measured, *STATED, "--period", period, "--harmonics", "5"]
    run("identify", PAPERS, *told, "-o", right)
    tables = [read(folder / "parameters.csv") for folder in (simulated, right)]
    for before, after in zip(*tables, strict=True):
        off = float(after["estimated"]) - float(before["estimated"])
        assert abs(off) < 1e-2 * float(before["std"])
        assert float(after["robot_file"]) == pytest.approx(float(before["true"]))
    assert "robot file: agrees with the forces" in (right / "report.txt").read_text()
    # Without a statement, the noise is estimated.
    estimated = tmp_path / "estimated"
    told = run("identify", PAPERS, *measured, "--period", period, "--harmonics", "5", "-o", estimated).err
    assert "trajectory.csv: noise of " in told
    found = json.loads((estimated / "report.json").read_text())
    assert (found["verdict"], found["robot_file"]["agreement"]) == ("consistent", "agrees")
    assert found["position_noise_m"] == pytest.approx(1e-4, rel=0.4)
