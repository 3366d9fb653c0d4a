"""Motors on both sides of nodes, turning points, and rest: plan, certificate, and report agree."""

import dataclasses

import numpy as np
import pytest
from motor_cases import sweep_case
from motor_oracle import fine_motors
from pages import DOCS
from sweeps import FULL, share

import stewart_sym as ss
from stewart_sym.drives.limits import MOTOR_LIMITS
from stewart_sym.io.progress import silent
from stewart_sym.planning.path_parameterization import TimedPath, parameterize_path
from stewart_sym.planning.plan_certificate import certify_plan
from stewart_sym.planning.timing.path_terms import PathLimits
from stewart_sym.robot.drive import Drive
from stewart_sym.studies.reports.force_report import ForceReport
from stewart_sym.studies.reports.plan import Plan

PEAKS = {"torque": "torque_limit", "current": "current_limit", "power": "power_limit"}


def check_agreement(plan: TimedPath) -> None:
    """Compare a plan, its certificate, and its report with the oracle: the same peaks, within limits."""
    fine, proof = fine_motors(plan), certify_plan(plan)
    assert fine.used <= 1.0 + 1e-6
    assert proof.is_valid
    # The certificate has a limit of jerk too.
    assert proof.max_utilization >= fine.used - 1e-6
    if plan.limits.jerk is None:
        assert proof.max_utilization <= fine.used + 1e-6
    # Peaks between the places of either grid are not found.
    np.testing.assert_array_less(fine.force, proof.force.value * (1.0 + 1e-4))
    found = Plan(plan.robot, None, plan, proof, rate=100.0).motors
    assert found is not None
    assert found.exceeded() == []
    peaks = {name: found.peaks(MOTOR_LIMITS[name])[0] for name in PEAKS}
    for name, limit in PEAKS.items():
        used = peaks[name] / getattr(plan.robot.drive, limit)
        assert used.max() <= proof.max_utilization * (1.0 + 1e-12)
    np.testing.assert_allclose(peaks["torque"], fine.torque, rtol=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(share(200, 100)))
def test_plan_certificate_and_report_agree_on_limits_of_motors_with_all_terms(seed: int) -> None:
    robot, path = sweep_case(seed)
    check_agreement(parameterize_path(robot, path, grid_size=60 if FULL else 40))


@pytest.mark.slow
def test_smooth_plans_keep_the_limits_of_motors_on_both_sides_of_turning_points() -> None:
    robot, path = sweep_case(3)
    plan = parameterize_path(robot, path, grid_size=40, limits=PathLimits(jerk=1e6))
    assert plan.profile.ease is not None
    check_agreement(plan)


def heave(s: np.ndarray) -> ss.Motion:
    """A rise of 0.12 m."""
    none, up = np.zeros((len(s), 3)), np.array([0.0, 0.0, 0.12])
    R, t = np.tile(np.eye(3), (len(s), 1, 1)), [0.0, 0.0, 0.6] + up * s[:, None]
    return ss.Motion(R=R, t=t, v=none + up, omega=none, a=none, alpha=none)


def test_a_heave_with_coulomb_friction_is_as_fast_as_its_limits_allow_and_certified() -> None:
    robot = ss.Robot.from_toml(DOCS / "examples" / "hexapod.toml")
    drive = Drive(lead=0.005, efficiency=0.9, backdrive_efficiency=0.8, motor_coulomb=0.1, torque_limit=0.25)
    robot = dataclasses.replace(robot, drive=drive)
    plan = parameterize_path(robot, heave, grid_size=20)
    proof = certify_plan(plan)
    assert proof.is_valid
    assert proof.active_fraction > 0.99
    assert plan.profile.ease is None
    # Also in the report of the forces, where the last sample is at rest and still braking.
    time = np.linspace(0.0, plan.duration, 50)
    report = ForceReport(robot, ss.Trajectory(time, plan.sample(time)))
    assert "".join(report.rows(silent)).count("\n") == len(time) + 1
    assert report.doubts(1.0) == []
