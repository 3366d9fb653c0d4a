"""What motions need of legs and motors: against inverse dynamics, over time, with a margin, beside limits."""

import dataclasses
import warnings
from typing import Any, NamedTuple

import numpy as np
import pytest
from command_line import error_of
from machines import machine_in_motion, path_period, random_path, random_robot
from motion_fields import motion_of
from noisy_logs import Case, case, logged, read
from scipy.integrate import trapezoid
from sweeps import share

import stewart_sym as ss
from stewart_sym.design.actuator_requirements import weighted_quantiles
from stewart_sym.design.limit_margins import compared
from stewart_sym.drives.limit_status import EXCEEDED, INCONCLUSIVE_NOISE, WITHIN, legs_text
from stewart_sym.io.progress import silent
from stewart_sym.motion.trajectory import Trajectory
from stewart_sym.studies.design.actuator_report import figure, report
from stewart_sym.studies.reports.force_report import ForceReport


def along(seed: int, count: int = 200) -> tuple[ss.Robot, np.ndarray, ss.Motion]:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng)
    time = np.linspace(0.0, path_period(robot), count)
    return robot, time, random_path(rng, robot)(time)


def test_peaks_are_those_of_inverse_dynamics_and_kinematics() -> None:
    robot, time, motion = along(1)
    needs = ss.actuator_requirements(robot, [(time, motion)])
    F = ss.inverse_dynamics(robot, motion).F
    legs = ss.inverse_kinematics(robot, motion)
    np.testing.assert_allclose(needs.force[-1], np.abs(F).max(axis=0), rtol=1e-12)
    np.testing.assert_allclose(needs.speed[-1], np.abs(legs.L_dot).max(axis=0), rtol=1e-12)
    power = F * legs.L_dot
    np.testing.assert_allclose(needs.power[-1], np.abs(power).max(axis=0), rtol=1e-12)
    np.testing.assert_allclose(needs.max_driving_power, np.maximum(power.max(axis=0), 0.0), rtol=1e-12)
    np.testing.assert_allclose(needs.max_braking_power, np.maximum(-power.min(axis=0), 0.0), rtol=1e-12)
    np.testing.assert_allclose(
        np.maximum(needs.max_push_force, needs.max_pull_force), needs.force[-1], rtol=1e-12
    )
    np.testing.assert_allclose(needs.stroke, np.ptp(legs.L, axis=0), rtol=1e-12)
    # Work is power over time.
    work = trapezoid(power, time, axis=0)
    np.testing.assert_allclose(needs.history.time_weight @ needs.history.power, work, rtol=1e-9)


def test_a_quantile_is_of_the_time_and_not_of_the_rows() -> None:
    values = np.array([[3.0], [1.0], [2.0]])
    found = weighted_quantiles(values, np.array([0.1, 0.6, 0.3]), np.array([0.5, 0.6, 0.61, 0.9, 0.91, 1.0]))
    assert found[:, 0].tolist() == [1.0, 1.0, 2.0, 2.0, 3.0, 3.0]


def names(lines: list[str]) -> list[str]:
    return [line.partition(":")[0] for line in lines]


def test_limits_that_are_exceeded_or_kept_without_the_margin_are_named() -> None:
    robot, time, motion = along(5)
    needs = ss.actuator_requirements(robot, [(time, motion)], margin=0.5)
    assert compared(robot, needs) == ([], [], [], [])
    enough, few = 1.5 * needs.force[-1], needs.length + np.array([-1e-9, 1e-9])
    limited = dataclasses.replace(
        robot,
        home_position=motion.t[0],
        force_limit=np.where(np.arange(6) == 2, 0.99, 1.01) * enough,
        speed_limit=np.where(np.arange(6) == 4, 0.99, 1.01) * 1.5 * needs.speed[-1],
        length_limits=few,
        joint_angle_limit=np.full((6, 2), [np.pi, 1e-3]),
    )
    needs = ss.actuator_requirements(limited, [(time, motion)], margin=0.5)
    found = compared(limited, needs)
    over, short = names(found.exceeded), names(found.margin_missing)
    assert over == [f"joint_angle_limit at the platform of leg {leg}" for leg in range(1, 7)]
    assert short == [
        "force_limit of leg 3",
        "speed_limit of leg 5",
        *(f"stroke of leg {i}" for i in range(1, 7)),
    ]
    short = dataclasses.replace(robot, length_limits=needs.length + np.array([1e-3, 1.0]))
    assert any(line.startswith("length_limits of leg 6") for line in compared(short, needs).exceeded)


def test_motors_are_sized_where_there_are_drives() -> None:
    robot, time, motion = along(6)
    assert ss.actuator_requirements(robot, [(time, motion)]).torque is None
    drive = ss.Drive(lead=np.full(6, 5e-3), rotor_inertia=1e-6, efficiency=0.9, torque_limit=1e-9)
    driven = dataclasses.replace(robot, drive=drive)
    needs = ss.actuator_requirements(driven, [(time, motion)])
    with pytest.warns(ss.DriveLimitWarning):
        effort = ss.drive_effort(driven, motion, time)
    np.testing.assert_allclose(needs.torque[-1], effort.peak_torque, rtol=1e-12)
    np.testing.assert_allclose(needs.rms_torque, effort.rms_torque, rtol=1e-9)
    assert [line[:18] for line in compared(driven, needs).exceeded] == ["drive.torque_limit"] * 6
    panels = figure(driven, needs).axes
    assert [axes.get_ylabel()[:12] for axes in panels] == [
        "actuator for",
        "length, m",
        "joint angle,",
        "motor torque",
    ]
    np.testing.assert_allclose([bar.get_height() for bar in panels[1].patches[6:]], needs.stroke)


def test_what_is_no_question_is_one_line() -> None:
    robot, motion = machine_in_motion(7, (3,))
    time = np.arange(3.0)
    for motions, message in (
        ([], "motions: expected at least one"),
        (3, "motions: expected pairs"),
        (motion[0], "motions: expected pairs"),
        ([time], "motions[0]: expected a pair"),
        ([(time[:2], motion)], "motions[0]: time: expected a time for each sample"),
        ([(time, motion), (time[::-1], motion)], "motions[1]: time: expected finite, increasing"),
        ([([0.0, np.nan, 1.0], motion)], "motions[0]: time: expected finite"),
    ):
        assert error_of(lambda motions=motions: ss.actuator_requirements(robot, motions)).startswith(message)
    pairs = [(time, motion)]
    assert error_of(lambda: ss.actuator_requirements(robot, pairs, margin=-0.1)).startswith(
        "margin: expected"
    )
    for quantiles in ([], [0.0], [1.1], [0.5, np.nan], "half"):
        assert error_of(
            lambda quantiles=quantiles: ss.actuator_requirements(robot, pairs, quantiles=quantiles)
        ).startswith("quantiles: expected")


SIZES = {
    "force_limit": ("force", "force_limit"),
    "speed_limit": ("speed", "speed_limit"),
    "joint_angle_limit at the base": ("base_angle", "joint_angle_limit"),
    "joint_angle_limit at the platform": ("platform_angle", "joint_angle_limit"),
    "drive.torque_limit": ("torque", "torque_limit"),
    "drive.speed_limit": ("motor_speed", "speed_limit"),
    "drive.current_limit": ("current", "current_limit"),
    "drive.power_limit": ("motor_power", "power_limit"),
    "drive.rated_torque": ("rms_torque", "rated_torque"),
}
"""Limits, with the needs that they limit and the fields of robot or drive that state them."""


def driven(one: Case) -> ss.Robot:
    drive = ss.Drive(
        lead=np.full(6, 1e-2),
        rotor_inertia=1e-5,
        efficiency=0.85,
        screw_coulomb=0.1 * float(np.abs(one.F).mean()),
        motor_viscous=1e-5,
        torque_constant=0.3,
        resistance=0.5,
    )
    return dataclasses.replace(one.robot, drive=drive, home_position=one.true[0, 0, :3])


class Noisy(NamedTuple):
    robot: ss.Robot
    true: ss.ActuatorRequirementsResult
    log: Trajectory
    needs: ss.ActuatorRequirementsResult


@pytest.fixture(scope="module", params=[share(100, 20)])
def noisy(request: pytest.FixtureRequest) -> list[Noisy]:
    """Machines with drives, what their motions need, logs of these with noise, and what they say of it."""
    found = []
    for seed in range(request.param):
        one = case(seed)
        robot = driven(one)
        true = ss.actuator_requirements(robot, [(one.time, motion_of(one.true))])
        for noise in ("3", "4", "white"):
            log, _ = read(one.time, logged(one, noise, seed))
            found.append(Noisy(robot, true, log, ss.actuator_requirements(robot, [log], margin=0.5)))
    return found


@pytest.mark.slow
def test_deviations_of_needs_cover_the_errors_that_noise_makes(noisy: list[Noisy]) -> None:
    off: dict[str, list[np.ndarray]] = {}
    for _, true, _, needs in noisy:
        for where, found, exact in (("history.", needs.history, true.history), ("", needs, true)):
            for name, sd in found.std.items():
                if name.endswith(("_rise", "_fall")):
                    continue
                errors = np.abs(getattr(found, name) - getattr(exact, name))
                assert np.all(errors[sd == 0.0] == 0.0), name
                off.setdefault(where + name, []).append((errors / np.where(sd > 0.0, sd, 1.0)).ravel())
    assert {
        "history.torque",
        "history.motor_power",
        "history.base_angle",
        "length",
        "stroke",
        "rms_torque",
    } < set(off)
    for name, sizes in off.items():
        joined = np.concatenate(sizes)
        # Peaks of the six legs in one motion are correlated.
        assert np.mean(joined < 3.0) > 0.96, name
        if name.startswith("history."):
            assert np.mean(joined < 1.0) == pytest.approx(0.6827, abs=0.07), name
            assert np.mean(joined < 1.96) == pytest.approx(0.95, abs=0.04), name


@pytest.mark.slow
def test_noise_makes_no_wrong_verdict_and_every_command_has_the_same(noisy: list[Noisy]) -> None:
    rng, seen = np.random.default_rng(0), set()
    for robot, true, log, needs in noisy:
        peaks, limits, limited = limited_near(rng, robot, true)
        lines = verdicts_of_size(limited, needs)
        for name, peak in peaks.items():
            for leg in range(6):
                verdict = lines.get((name, leg), WITHIN)
                seen.add(verdict)
                if verdict != INCONCLUSIVE_NOISE:
                    assert (verdict == EXCEEDED) == bool(peak[leg] > limits[name][leg]), (name, leg)
        forces = ForceReport(limited, log)
        assert len([*forces.rows(silent)]) > 1
        told = " ".join(forces.doubts(1e9))
        with warnings.catch_warnings(action="ignore", category=ss.DriveLimitWarning):
            assert set(ss.drive_effort(limited, log).limit_messages) <= set(forces.doubts(1e9))
        for name, verdict in {(name, verdict) for (name, _), verdict in lines.items()}:
            legs = [leg for leg in range(6) if lines.get((name, leg)) == verdict]
            assert f"{name} {verdict.replace('_', ' ')} by {legs_text(legs)}: " in told
        assert told.count("_limit ") + told.count("rated_torque ") == len(
            {(name, verdict) for (name, _), verdict in lines.items()}
        )
    assert seen == {WITHIN, EXCEEDED, INCONCLUSIVE_NOISE}


def limited_near(
    rng: np.random.Generator, robot: ss.Robot, true: ss.ActuatorRequirementsResult
) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray], ss.Robot]:
    """Peaks of the needs, limits beside them, and the robot with these limits."""
    peaks = {name: np.atleast_2d(getattr(true, need))[-1] for name, (need, _) in SIZES.items()}
    limits = {name: peak * rng.uniform(0.97, 1.03, 6) for name, peak in peaks.items()}
    stated = {name: limits[name] for name in ("force_limit", "speed_limit")}
    angles = [limits[f"joint_angle_limit at the {end}"] for end in ("base", "platform")]
    stated |= {"joint_angle_limit": np.stack(angles, axis=-1)}
    motors = {SIZES[name][1]: limit for name, limit in limits.items() if name.startswith("drive.")}
    drive = dataclasses.replace(robot.drive, **motors)
    return peaks, limits, dataclasses.replace(robot, drive=drive, **stated)


def verdicts_of_size(robot: ss.Robot, needs: ss.ActuatorRequirementsResult) -> dict[tuple[str, int], str]:
    """By limit and leg, as the lines of ``size`` have them."""
    lines, found = compared(robot, needs), {}
    for line in [*(f"{EXCEEDED}: {line}" for line in lines.exceeded), *lines.inconclusive]:
        verdict, name = line.split(": ")[:2]
        verdict = verdict.replace(" ", "_")
        limit, _, leg = name.partition(" of leg ")
        found[limit, int(leg) - 1] = verdict
    return found


@pytest.mark.parametrize("in_log", [False, True])
def test_no_limit_suffices_for_a_motion_through_a_singular_pose(in_log: bool) -> None:
    path = ss.PAPER_PATHS["III"].path
    time = path.time_grid(0.3)
    motion, rows = path.sample(time), range(2, len(time) + 2)
    given: Any = Trajectory(time, motion, "III", rows) if in_log else (time, motion)
    strong = dataclasses.replace(ss.robots.dasgupta1998(), force_limit=1e9, drive=ss.Drive(lead=0.005))
    where = "at 3.67" if in_log else "between samples 12 and 13, where det H changes its sign"
    with pytest.warns(ss.SingularPoseWarning, match=f"the path crosses a singular pose {where}"):
        needs = ss.actuator_requirements(strong, [given])
    written = report(strong, ["III"], needs)
    assert written.data["crossings"] == list(needs.crossings)
    assert needs.crossings[0] in written.text
    assert written.text.startswith("verdict no force is sufficient: a motion crosses a singular pose\n")
    with pytest.warns(ss.SingularPoseWarning, match="between 3.6 and 3.9 s, where det H changes its sign"):
        ss.drive_effort(strong, motion, time)
