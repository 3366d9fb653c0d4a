"""Outliers of measured forces leave an estimate as it is without them; a wrong model is no outlier."""

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from machines import Array, dasgupta
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.motion.rotation import rpy_from_rotation

SIGMA, PERIOD, ROWS = 0.5, 60.0, 6000
"""Standard deviation of the forces (N) in a log of 60 s at 100 Hz."""


@cache
def excited(rows: int = ROWS) -> ss.Excitation:
    return ss.choose_excitation(dasgupta(), samples=rows, candidates=1, period=PERIOD)


@cache
def measured(rows: int = ROWS) -> Array:
    noise = np.random.default_rng(3).normal(size=(rows, 6))
    return ss.inverse_dynamics(dasgupta(), excited(rows).motion).F + SIGMA * noise


def estimate(F: Array) -> ss.IdentificationResult:
    way = excited(len(F))
    return ss.identify(dasgupta(), way.motion, F, SIGMA, way.base)


@cache
def undisturbed() -> ss.IdentificationResult:
    return estimate(measured())


def disturbed(sizes: Array, seed: int) -> tuple[Array, Array]:
    """Forces with one wrong value in some rows, and these rows."""
    rng = np.random.default_rng(seed)
    F, rows = measured().copy(), np.sort(rng.choice(ROWS, len(sizes), replace=False))
    F[rows, rng.integers(6, size=len(rows))] += sizes * rng.choice([-1.0, 1.0], len(rows))
    return F, rows


@pytest.mark.parametrize(
    "sizes", [np.array([10.0]), np.full(20, 1e4), np.geomspace(10.0, 1e4, 20)], ids=["one", "huge", "mixed"]
)
def test_outliers_of_any_size_change_an_estimate_by_a_fraction_of_its_deviation(sizes: Array) -> None:
    F, rows = disturbed(sizes, len(sizes))
    found = estimate(F)
    assert found.verdict == "consistent"
    assert found.excluded_samples.tolist() == rows.tolist()
    off = (found.values - undisturbed().values) / undisturbed().std
    # Without these rows, the estimate has other noise.
    assert np.abs(off).max() < 0.25
    assert np.allclose(found.std, undisturbed().std, rtol=0.02)


def test_outliers_along_noisy_poses_are_left_out_too() -> None:
    machine, way = dasgupta(), ss.choose_excitation(dasgupta(), candidates=2)
    experiment = ss.simulate_experiment(machine, way, SIGMA, 0, 1e-4, 1e-4)
    F, noise = experiment.F.copy(), experiment.pose_noise
    F[[30, 120], [1, 4]] += 30.0, -1e4
    found = ss.identify(machine, experiment.measured_motion, F, SIGMA, way.base, noise)
    assert found.verdict == experiment.estimate.verdict == "consistent"
    assert found.excluded_samples.tolist() == [30, 120]
    off = (found.values - experiment.estimate.values) / found.std
    # Two of 200 samples contain more of the information than a few of 6000.
    assert np.abs(off).max() < 1.0


def test_forces_without_outliers_are_all_used() -> None:
    assert undisturbed().verdict == "consistent"
    assert not undisturbed().excluded_samples.size


def with_friction(F: Array) -> Array:
    """Forces with dry friction of 5 N in all legs."""
    rates = ss.inverse_kinematics(dasgupta(), excited(len(F)).motion).L_dot
    return F + 5.0 * np.sign(rates)


def with_contact(F: Array) -> Array:
    """Forces with a contact of 100 N in leg 3 during 2 % of the rows."""
    contact = F.copy()
    contact[100 : 100 + len(F) // 50, 2] += 100.0
    return contact


def with_late_forces(F: Array) -> Array:
    """Forces that are 50 ms late."""
    return np.roll(F, round(0.05 * len(F) / PERIOD), axis=0)


@pytest.mark.parametrize("effect", [with_friction, with_contact, with_late_forces])
def test_a_model_without_an_effect_is_not_saved_by_leaving_rows_out(effect: object) -> None:
    F = effect(measured(2000))  # type: ignore[operator]
    found = estimate(F)
    assert found.verdict in ("misfit", "rejected")
    assert not found.excluded_samples.size
    if effect is with_contact:
        (line,) = (line for line in found.warnings if "robust standard deviations" in line)
        assert "of 2000 samples, more than 1 %, differ from the model" in line
        assert "the residuals do not fit the model" in line


def test_outliers_of_a_file_are_listed_in_one_warning_and_counted(tmp_path: Path, run: Run) -> None:
    F, rows = disturbed(np.array([30.0, 300.0, 3000.0]), 1)
    way = excited()
    poses = np.hstack([way.motion.t, rpy_from_rotation(way.motion.R)])
    for name, columns, values in (
        ("poses.csv", "t_x,t_y,t_z,theta_x,theta_y,theta_z", poses),
        ("forces.csv", "F_1,F_2,F_3,F_4,F_5,F_6", F),
    ):
        table = np.column_stack([way.time, values])
        np.savetxt(tmp_path / name, table, "%.17g", ",", header=f"time,{columns}", comments="")
    files = tmp_path / "poses.csv", tmp_path / "forces.csv"
    told = run("identify", PAPERS, "--force-std", SIGMA, "-o", tmp_path / "out", "--measured", *files)
    (line,) = (line for line in told.err.splitlines() if "outliers" in line)
    lines = ", ".join(str(row + 2) for row in rows)
    assert f"forces.csv: outliers (lines {lines}): more than 8 robust standard deviations" in line
    assert "they are left out of the fit" in line
    data = json.loads((tmp_path / "out" / "report.json").read_text())
    assert (data["samples"], data["excluded_samples"], data["verdict"]) == (ROWS, 3, "consistent")
    assert f"samples: {ROWS}, of which 3 are excluded as outliers" in told.out
