"""Motors on both sides of nodes, turning points, and rest: plan, certificate, and report agree."""

import dataclasses

import numpy as np
import pytest
from motor_cases import sweep_case
from motor_oracle import fine_motors
from pages import DOCS
from sweeps import FULL, share

import stewart_sym as ss
from stewart_sym.planning.path_parameterization import TimedPath, parameterize_path
from stewart_sym.planning.plan_certificate import certify_plan
from stewart_sym.planning.timing.motor_terms import MotorTerms, directions
from stewart_sym.planning.timing.path_terms import PathLimits
from stewart_sym.robot.drive import Drive
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
    found = Plan(plan.robot, None, plan, proof, rate=100.0).motors.summary
    assert found.exceeded() == []
    for name, limit in PEAKS.items():
        assert (found.peaks[name] / getattr(plan.robot.drive, limit)).max() <= proof.max_utilization * (
            1.0 + 1e-12
        )
    np.testing.assert_allclose(found.peaks["torque"], fine.torque, rtol=1e-3)


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
    plan = parameterize_path(dataclasses.replace(robot, drive=drive), heave, grid_size=20)
    proof = certify_plan(plan)
    assert proof.is_valid
    assert proof.active_fraction > 0.99
    assert plan.profile.ease is None


def cell_of(drive: Drive, through: np.ndarray, rotor: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """Return the torque at places of one cell over limits of 1 N, (6,), at s' = 1 and s'' = 0."""
    six = np.ones(6)
    none, (through, rotor, rate) = (
        np.zeros((len(rate), 6)),
        (x[:, None] * six for x in (through, rotor, rate)),
    )
    force, rotors = np.stack([none, through + rotor, none, none]), np.stack([none, rotor])
    terms = MotorTerms(drive, force, rotors, rate, six, np.inf * six)
    places = np.ones((1, len(rate)))
    return terms.used(places, 0.0 * places)[0, :, :6].max(axis=0)


def test_a_limit_counts_where_the_efficiency_changes_between_places() -> None:
    s = np.linspace(-1.0, 1.0, 4)
    drive = Drive(lead=2.0 * np.pi, efficiency=0.5, backdrive_efficiency=0.5)
    np.testing.assert_allclose(cell_of(drive, s, -1.0 - s, np.ones(4)), 1.0)


def test_a_limit_counts_on_both_sides_of_a_turning_point_between_places() -> None:
    s = np.linspace(-1.0, 1.0, 4)
    drive = Drive(lead=2.0 * np.pi, screw_coulomb=1.0)
    for sign in (-1.0, 1.0):
        np.testing.assert_allclose(cell_of(drive, sign * s, 0.0 * s, -sign * s), 1.0)


def test_legs_move_at_the_ends_of_a_cell_as_they_do_inside() -> None:
    rate = np.array([[-1e-17, 0.1, 0.3, 1e-18], [-0.2, -0.1, 0.1, 0.2], [1e-18, -1e-17, 1e-18, 0.0]])
    found = directions(np.moveaxis(rate[None], 1, 2))
    np.testing.assert_array_equal(found[0].T, [[1, 1, 1, 1], [-1, -1, 1, 1], [0, 0, 0, 0]])
