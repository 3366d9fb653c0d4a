"""Efforts of the motors: numbers worked by hand, and an energy balance that uses none of the formulas."""

import dataclasses
import json
import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import Run
from machines import random_robot
from motion_fields import motion_of, waves
from robot_files import written

import stewart_sym as ss
from stewart_sym.drives.friction import friction_force
from stewart_sym.drives.limits import LEG_LIMITS, LimitTracker
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.motion.rotation import rpy_from_rotation
from stewart_sym.motion.trajectory import Trajectory, Uncertainty
from stewart_sym.reference import newton_euler

LOSSY: dict[str, Any] = {
    "efficiency": 0.9, "backdrive_efficiency": 0.8, "screw_coulomb": 20.0, "screw_viscous": 150.0,
    "motor_coulomb": 0.02, "motor_viscous": 2e-4, "stribeck_force": 8.0, "stribeck_speed": 5e-3,
    "regularization_speed": 1e-3, "torque_constant": 0.5, "resistance": 2.0, "rotor_inertia": 3e-5,
}  # fmt: skip


def with_drive(robot: ss.Robot, lead: Any = 5e-3, **numbers: Any) -> ss.Robot:
    return dataclasses.replace(robot, drive=ss.Drive(lead=lead, **numbers))


def swing(robot: ss.Robot, time: np.ndarray, period: float, size: float = 0.05) -> ss.Motion:
    """A closed motion about the home pose: angles and shifts are sines of several periods."""
    rate = 2.0 * np.pi / period * np.array([1, 2, 1, 2, 1, 3])
    middle = np.append(home_pose(robot).t, np.zeros(3))
    return motion_of(waves(time, middle, size, rate, [0.3, 1.1, 2.0, 0.7, 0.1, 1.9]))


@pytest.fixture(scope="module")
def robot() -> ss.Robot:
    return ss.robots.dasgupta1998()


@pytest.mark.parametrize("lead", [5e-3, -5e-3])
@pytest.mark.parametrize("F", [800.0, -800.0])
@pytest.mark.parametrize("rate", [0.1, -0.1])
def test_torque_is_what_the_formulas_of_a_screw_give(lead: float, F: float, rate: float) -> None:
    drive = ss.Drive(lead=lead, **{**LOSSY, "regularization_speed": 0.0, "stribeck_force": 0.0})
    sign, turns = math.copysign(1.0, rate), 2 * math.pi / lead
    ideal = F / (turns * 0.9) if F * rate > 0 else F * 0.8 / turns
    screw = (20.0 * sign + 150.0 * rate) / turns
    speed = turns * rate
    motor = 0.02 * math.copysign(1.0, speed) + 2e-4 * speed
    found = (F + friction_force(drive, np.full(6, F), np.full(6, rate))) / drive.transmission_ratio
    np.testing.assert_allclose(found, ideal + screw + motor, rtol=1e-13)


def test_friction_never_gives_power_and_is_smooth_within_the_velocity_given() -> None:
    drive = ss.Drive(lead=5e-3, **LOSSY)
    rate = np.linspace(-3e-3, 3e-3, 6001)[:, None] * np.ones(6)
    for F in (300.0, -300.0):
        lost = friction_force(drive, np.full_like(rate, F), rate)
        assert (lost * rate >= 0.0).all()
        step = np.abs(np.diff(lost, axis=0)).max()
        assert step < 2.0 * np.abs(lost).max() * 1e-6 / 1e-3 * 1.5
    beyond = friction_force(drive, np.full(6, 300.0), np.full(6, 1e-3))
    sharp = friction_force(
        dataclasses.replace(drive, regularization_speed=0.0), np.full(6, 300.0), np.full(6, 1e-3)
    )
    np.testing.assert_array_equal(beyond, sharp)


def test_a_drive_without_losses_turns_forces_into_torques(robot: ss.Robot) -> None:
    time = np.linspace(0.0, 2.0, 21)
    motion = swing(robot, time, 2.0)
    found = ss.drive_effort(with_drive(robot), motion)
    F, L_dot = ss.inverse_dynamics(robot, motion).F, ss.inverse_kinematics(robot, motion).L_dot
    np.testing.assert_array_equal(found.force, F)
    np.testing.assert_allclose(found.torque, F * 5e-3 / (2 * math.pi), rtol=1e-14)
    np.testing.assert_allclose(found.power, F * L_dot, rtol=1e-12, atol=1e-12)
    np.testing.assert_array_equal(found.electrical_power, found.power)
    assert found.current is None
    assert found.energy is None


@pytest.mark.parametrize("seed", range(2))
def test_electrical_energy_is_work_and_losses(seed: int) -> None:
    """Energies and powers of the joints by the reference; the loss of a transmission by its efficiencies."""
    rng = np.random.default_rng(seed)
    robot = with_drive(
        random_robot(rng, scale=1.0), lead=rng.choice([-1, 1], 6) * rng.uniform(3e-3, 2e-2, 6), **LOSSY
    )
    drive = robot.drive
    time = np.linspace(0.0, 1.3, 4001)
    motion = swing(robot, time, 2.0)
    with warnings.catch_warnings(action="ignore"):
        found = ss.drive_effort(robot, motion, time)
    F, legs = found.force - found.friction - found.rotor, ss.inverse_kinematics(robot, motion)
    electrical = np.sum(
        found.current * (found.current * drive.resistance + drive.torque_constant * found.speed), -1
    )
    copper = np.sum(drive.resistance * found.current**2, axis=-1)
    x = np.clip(legs.L_dot / 1e-3, -1.0, 1.0)
    fade = 0.5 * x * (3 - x**2)
    out = F * legs.L_dot
    screw_in = out + fade * np.sign(legs.L_dot) * np.abs(out) * np.where(out > 0, 1 / 0.9 - 1, 1 - 0.8)
    dragging = (
        np.abs(fade * legs.L_dot) * (20.0 + 8.0 * np.exp(-((legs.L_dot / 5e-3) ** 2))) + 150.0 * legs.L_dot**2
    )
    motor = 0.02 * np.abs(fade * found.speed) + 2e-4 * found.speed**2
    losses = (
        copper + np.sum(screw_in - out + dragging + motor, -1) + newton_euler.friction_power(robot, motion)
    )
    gained = newton_euler.energy(robot, motion[-1]) - newton_euler.energy(robot, motion[0])
    total = np.trapezoid(electrical, time)
    assert total == pytest.approx(
        gained + np.trapezoid(losses, time), abs=2e-5 * np.trapezoid(np.abs(electrical), time)
    )
    assert np.sum(found.energy) == pytest.approx(total, rel=1e-12)


def test_limits_are_named_with_leg_value_and_time(robot: ss.Robot) -> None:
    time = np.linspace(0.0, 2.0, 41)
    motion = swing(robot, time, 2.0)
    free = ss.drive_effort(with_drive(robot), motion, time)
    assert free.limit_messages == ()
    worst = int(np.argmax(free.peak_torque))
    limit = np.full(6, math.inf)
    limit[worst] = 0.9 * free.peak_torque[worst]
    tight = with_drive(robot, torque_limit=limit)
    at = int(np.argmax(np.abs(free.torque[:, worst])))
    peak = f"{free.peak_torque[worst]:.6g} N m"
    words = rf"drive\.torque_limit exceeded by leg {worst + 1}: torque {peak} at {time[at]:g}\d* s"
    with pytest.warns(ss.DriveLimitWarning, match=words):
        assert len(ss.drive_effort(tight, motion, time).limit_messages) == 1
    with pytest.warns(ss.DriveLimitWarning, match=f"at sample {at}, limit"):
        ss.drive_effort(tight, motion)
    rated = with_drive(robot, rated_torque=0.9 * free.rms_torque.max())
    with pytest.warns(
        ss.DriveLimitWarning, match=r"drive\.rated_torque exceeded by leg.*root mean square of torque"
    ):
        ss.drive_effort(rated, motion, time)


def forces(folder: Path, robot: ss.Robot, time: np.ndarray, *options: str) -> list[str]:
    """Files of a robot and its swing, and the command that takes them."""
    motion = swing(robot, time, 2.0)
    theta = rpy_from_rotation(motion.R)
    rows = np.column_stack([time, motion.t, theta])
    names = ",".join(["time", *(f"{name}_{axis}" for name in ("t", "theta") for axis in "xyz")])
    np.savetxt(folder / "log.csv", rows, delimiter=",", header=names, comments="", fmt="%.17g")
    written(robot, folder / "robot.toml")
    return [
        "forces",
        str(folder / "robot.toml"),
        str(folder / "log.csv"),
        "-o",
        str(folder / "F.csv"),
        *options,
    ]


@pytest.mark.slow
def test_forces_has_columns_table_and_picture_of_the_motors_and_so_has_its_page(
    robot: ss.Robot, tmp_path: Path, run: Run
) -> None:
    time = np.linspace(0.0, 2.0, 81)
    machine = with_drive(robot, **LOSSY, torque_limit=1.2, speed_limit=450.0)
    picture = tmp_path / "motors.png"
    more = ("--json", str(tmp_path / "F.json"), "--html", str(tmp_path / "F.html"))
    command = forces(tmp_path, machine, time, "--plot", str(picture), *more)
    out, err = run(*command)
    table = np.genfromtxt(tmp_path / "F.csv", delimiter=",", names=True)
    with pytest.warns(ss.DriveLimitWarning, match=r"\Adrive\.(speed|torque)_limit exceeded"):
        found = ss.drive_effort(machine, swing(machine, time, 2.0), time)
    for column, values in (
        ("torque", found.torque),
        ("motor_speed", found.speed),
        ("current", found.current),
        ("power", found.power),
    ):
        written_ones = np.column_stack([table[f"{column}_{leg}"] for leg in range(1, 7)])
        np.testing.assert_allclose(
            written_ones[3:-3], values[3:-3], rtol=0.02, atol=0.02 * np.abs(values).max()
        )
    assert "drive.speed_limit exceeded by leg" in err
    assert "RMS torque, N m" in out
    leg = json.loads((tmp_path / "F.json").read_text())["legs"][2]
    assert leg["motor_rms_torque_N_m"] == pytest.approx(found.rms_torque[2], rel=0.02)
    assert leg["motor_energy_J"] == pytest.approx(found.energy[2], rel=0.05)
    assert picture.read_bytes()[:4] == b"\x89PNG"
    assert run(*command).out == out  # The picture of the program is replaced.
    picture.write_bytes(b"other")
    assert "motors.png: exists with other content" in run(*command, code=2).err
    page = (tmp_path / "F.html").read_text(encoding="utf-8")
    assert f'data-value="{leg["motor_rms_torque_N_m"]!r}"' in page
    assert 'alt="forces"' in page


def test_dry_friction_is_as_unsure_as_the_direction_of_the_leg(robot: ss.Robot) -> None:
    """Rates have a deviation each; torques else depend on them by viscous friction alone."""
    n, rate = 3, 1e-3
    coulomb, turns = 40.0, 2.0 * np.pi / 5e-3
    driven, still = with_drive(robot, screw_coulomb=coulomb), np.zeros((n, 3))
    t = home_pose(robot).t * np.ones((n, 1))
    up = ss.Motion.from_rpy(t, still, 0.05 * np.array([[0.0, 0.0, 1.0]] * n), still, still, still)
    L_dot = ss.inverse_kinematics(robot, up).L_dot
    for sure, least, most in ((0.1 * np.abs(L_dot).min(), 0.0, 1e-9), (np.abs(L_dot).max(), 1.0, 1.0)):
        covariance = np.zeros((n, 6, 6))
        covariance[:, :, 2] = sure**2
        coordinates = np.concatenate([t, still], axis=1)
        found = np.array([coordinates, np.hstack([up.v, still]), 0.0 * coordinates])
        noise = Uncertainty(np.arange(n) * 1.0, covariance, np.full(6, rate))
        log = Trajectory(np.arange(n) * 1.0, up, "log.csv", range(n), noise, found)
        effort = ss.drive_effort(driven, log)
        # Joints' friction is in both.
        through = ss.drive_effort(with_drive(robot), log).std
        step = np.sqrt(effort.std["torque"] ** 2 - through["torque"] ** 2)
        np.testing.assert_array_less(least * 2.0 * coulomb / 3.0 / turns * (1.0 - 1e-6), step + 1e-12)
        np.testing.assert_array_less(step, most * 2.0 * coulomb / 3.0 / turns * (1.0 + 1e-6) + 1e-6)
        assert np.all(effort.std["speed"] > 0.0)


def test_limits_of_legs_at_which_a_motion_stops_are_kept_but_for_its_rounding(robot: ss.Robot) -> None:
    limited = dataclasses.replace(
        robot,
        length_limits=np.tile([0.4, 0.9], (6, 1)),
        force_limit=np.full(6, 500.0),
        speed_limit=np.full(6, 0.3),
        home_position=np.array([0.0, 0.0, 0.6]),
        joint_angle_limit=np.full((6, 2), 0.5),
    )
    for limit in LEG_LIMITS:
        bound = limit.bound(limited)
        for share, verdict in ((1e-9, "within_limit"), (1e-4, "exceeded")):
            run = LimitTracker(limited, np.array([0.0, 1.0]))
            values = limit.sign * np.stack([bound, bound + share * np.abs(bound)])
            run.add(slice(None), {limit.values: values})
            assert run.verdicts(limit) == [verdict] * 6, (limit.name, share)
