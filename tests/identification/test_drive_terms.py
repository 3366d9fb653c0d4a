"""Terms of the drives from forces of motors: recovered as their covariance says, or not identifiable."""

import dataclasses
import json
import math
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from robot_files import written

import stewart_sym as ss
from stewart_sym.motion.rotation import rotation_from_vector

SIGMA = 2.0
TERMS = ("reflected_mass", "coulomb", "offset")
TRUE = {
    "reflected_mass": np.array([40.0, 42.0, 38.0, 41.0, 39.0, 45.0]),
    "coulomb": np.array([30.0, 25.0, 35.0, 28.0, 31.0, 27.0]),
    "offset": np.array([-5.0, 3.0, 0.0, 8.0, -2.0, 1.0]),
}


@pytest.fixture(scope="module")
def robot() -> ss.Robot:
    return ss.robots.dasgupta1998()


@pytest.fixture(scope="module")
def excited(robot: ss.Robot) -> ss.Excitation:
    return ss.choose_excitation(robot, samples=120, candidates=8)


def motor_forces(robot: ss.Robot, motion: ss.Motion) -> np.ndarray:
    legs = ss.inverse_kinematics(robot, motion)
    drive = TRUE["reflected_mass"] * legs.L_ddot + TRUE["coulomb"] * np.sign(legs.L_dot) + TRUE["offset"]
    return ss.inverse_dynamics(robot, motion).F + drive


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", ["torque_limit", "power_limit"])
def test_excitation_keeps_within_the_limits_of_the_motors(robot: ss.Robot, name: str) -> None:
    driven = dataclasses.replace(robot, drive=ss.Drive(lead=5e-3, torque_constant=0.5))
    still, free = (
        ss.drive_effort(driven, ss.choose_excitation(driven, period, samples=60, candidates=1).motion)
        for period in (1e3, None)
    )
    quantity = "rms_torque" if name == "rated_torque" else f"peak_{name.removesuffix('_limit')}"
    limit = np.mean([getattr(each, quantity).max() for each in (still, free)])
    limited = dataclasses.replace(driven, drive=dataclasses.replace(driven.drive, **{name: limit}))
    motion = ss.choose_excitation(limited, samples=60, candidates=1).motion
    assert ss.drive_effort(limited, motion).limit_messages == ()


@pytest.mark.slow
def test_noisy_experiments_scatter_as_the_covariance_says(robot: ss.Robot, excited: ss.Excitation) -> None:
    count = 12
    exact = motor_forces(robot, excited.motion)
    true = np.concatenate(list(TRUE.values()))
    rng = np.random.default_rng(5)
    off, squares = [], []
    for _ in range(count):
        F = exact + SIGMA * rng.normal(size=exact.shape)
        found = ss.identify(robot, excited.motion, F, SIGMA, excited.base, drive_terms=TERMS)
        assert found.verdict == "consistent"
        error = found.drive.values - true
        off.append(error / found.drive.std)
        squares.append(error @ np.linalg.solve(found.drive.covariance, error))
    assert found.drive.names[6:8] == ("coulomb1", "coulomb2")
    assert found.drive.identifiable.all()
    size = np.abs(off)
    shares = [float(np.mean(size < width)) for width in (1.0, 2.0, 3.0)]
    print("within 1, 2, 3 sigma:", shares, "mean square:", np.mean(squares) / 18)
    # Four deviations of each share of so many values, which are a little dependent.
    for share, normal in zip(shares, (0.6827, 0.9545, 0.9973), strict=True):
        assert share == pytest.approx(normal, abs=4.0 * math.sqrt(normal * (1.0 - normal) / (18 * count)))
    assert np.abs(np.mean(off, axis=0)).max() < 4.0 / math.sqrt(count)
    assert np.mean(squares) == pytest.approx(18.0, abs=4.0 * math.sqrt(2.0 * 18.0 / count))


def test_terms_are_exact_without_noise_and_change_no_bodies(robot: ss.Robot, excited: ss.Excitation) -> None:
    found = ss.identify(
        robot, excited.motion, motor_forces(robot, excited.motion), 1e-6, excited.base, drive_terms=TERMS
    )
    np.testing.assert_allclose(found.drive.values, np.concatenate(list(TRUE.values())), atol=1e-5)
    plain = ss.identify(
        robot, excited.motion, ss.inverse_dynamics(robot, excited.motion).F, 1e-6, excited.base
    )
    scale = np.abs(plain.values).max()
    np.testing.assert_allclose(found.values, plain.values, atol=1e-6 * scale)


def test_what_does_the_same_is_said(robot: ss.Robot, excited: ss.Excitation) -> None:
    motion = excited.motion
    F = motor_forces(robot, motion)
    both = ss.identify(robot, motion, F, SIGMA, excited.base, drive_terms=("viscous", "coulomb", "offset"))
    assert both.drive.names[-1] == "viscous6"
    assert not both.drive.identifiable[-6:].any()
    assert both.drive.unidentifiable[0] == "viscous1: not identifiable along this motion, acts as C_p1"
    assert np.isnan(both.drive.values[-6:]).all()
    assert np.isinf(both.drive.std[-6:]).all()
    without = ss.base_parameters(robot, motion, friction=False)
    one = ss.identify(
        robot, motion, F, SIGMA, without, drive_terms=("viscous", "coulomb", "offset", "reflected_mass")
    )
    assert one.drive.identifiable.all()


def test_currents_become_forces_of_the_motors(robot: ss.Robot, excited: ss.Excitation) -> None:
    drive = ss.Drive(lead=[5e-3, -5e-3, 4e-3, 4e-3, 1e-2, 1e-2], torque_constant=0.5, screw_coulomb=30.0)
    machine = dataclasses.replace(robot, drive=drive)
    effort = ss.drive_effort(machine, excited.motion)
    F = ss.motor_forces(machine, effort.current)
    np.testing.assert_allclose(F, effort.force, rtol=1e-12)
    found = ss.identify(machine, excited.motion, F, 1e-6, excited.base, drive_terms=("coulomb",))
    np.testing.assert_allclose(found.drive.values, 30.0, atol=1e-4)
    with pytest.raises(ValueError, match=r"robot: expected a drive with a torque_constant for every leg"):
        ss.motor_forces(robot, effort.current)


def with_rotors(robot: ss.Robot, **changes: float) -> ss.Robot:
    return dataclasses.replace(robot, drive=ss.Drive(lead=5e-3, rotor_inertia=5e-5), **changes)


def test_forces_of_motors_identify_the_bodies_beside_the_rotors_of_the_robot_file(
    robot: ss.Robot, excited: ss.Excitation
) -> None:
    machine = with_rotors(robot)
    F = ss.inverse_dynamics(machine, excited.motion).F
    found = ss.identify(machine, excited.motion, F, 1e-6, excited.base)
    assert found.verdict == "consistent"
    right = excited.base.matrix @ ss.inertial_parameters(robot).values
    assert (np.abs(found.values - right) < found.std).all()
    without = ss.identify(robot, excited.motion, F, 1e-6, excited.base)
    assert without.verdict == "rejected"
    other = dataclasses.replace(machine, drive=ss.Drive(lead=5e-3, rotor_inertia=6e-5))
    wrong = ss.identify(other, excited.motion, F, 1e-6, excited.base)
    assert any(line.startswith("rotors: ") for line in wrong.warnings)


def noisy(excited: ss.Excitation, size: float, seed: int) -> tuple[ss.Motion, ss.PoseNoise]:
    """Poses of a motion as measured, by so many m and rad."""
    shape, rng = (len(excited.time), 3), np.random.default_rng((7, seed))
    R = rotation_from_vector(size * rng.normal(size=shape)) @ excited.motion.R
    measured = ss.Motion(
        R=R, t=excited.motion.t + size * rng.normal(size=shape), omega=(zero := np.zeros(shape)), v=zero
    )
    return measured, ss.PoseNoise(excited.time, size, size, excited.path.period, len(excited.path.sine))


@pytest.mark.slow
def test_of_noisy_poses_bodies_and_terms_scatter_as_the_covariance_says(
    robot: ss.Robot, excited: ss.Excitation
) -> None:
    """Also where the noise of the poses moves them farther than that of the forces."""
    size = 3e-4
    count, exact = 4, motor_forces(robot, excited.motion)
    bodies, terms = (
        excited.base.matrix @ ss.inertial_parameters(robot).values,
        np.concatenate([*TRUE.values()]),
    )
    squares = []
    for seed in range(count):
        F = exact + SIGMA * np.random.default_rng((8, seed)).normal(size=exact.shape)
        measured, noise = noisy(excited, size, seed)
        found = ss.identify(robot, measured, F, SIGMA, excited.base, noise, drive_terms=TERMS)
        assert found.verdict == "consistent"
        for estimate, true in ((found, bodies), (found.drive, terms)):
            error = estimate.values - true
            squares.append(error @ np.linalg.solve(estimate.covariance, error) / len(error))
    for found, unknowns in ((squares[::2], len(bodies)), (squares[1::2], len(terms))):
        assert np.mean(found) == pytest.approx(1.0, abs=4.0 * math.sqrt(2.0 / (unknowns * count)))


def tables(excited: ss.Excitation, folder: Path, measured: dict[str, np.ndarray]) -> list[str]:
    """Files of an exact motion and of what was measured beside it, as options of ``identify``."""
    columns = {"time": excited.time}
    for (place, turn), x in zip(
        (("t", "theta"), ("v", "theta_dot"), ("a", "theta_ddot")),
        excited.path.coordinates(excited.time),
        strict=True,
    ):
        columns |= {f"{place}_{axis}": x[:, i] for i, axis in enumerate("xyz")}
        columns |= {f"{turn}_{axis}": x[:, 3 + i] for i, axis in enumerate("xyz")}
    for name, table in (("log", columns), ("measured", {"time": excited.time} | measured)):
        rows = np.column_stack(list(table.values()))
        head = ",".join(table)
        np.savetxt(folder / f"{name}.csv", rows, delimiter=",", header=head, comments="", fmt="%.17g")
    return ["--measured", str(folder / "log.csv"), str(folder / "measured.csv")]


def test_command_takes_currents(robot: ss.Robot, excited: ss.Excitation, tmp_path: Path, run: Run) -> None:
    drive = ss.Drive(lead=[5e-3, -5e-3, 4e-3, 4e-3, 1e-2, 1e-2], torque_constant=0.5, screw_coulomb=30.0)
    drive = dataclasses.replace(drive, screw_viscous=800.0, motor_viscous=1e-3)
    machine = dataclasses.replace(robot, drive=drive)
    noisy = ss.drive_effort(machine, excited.motion).current
    noisy = noisy + 0.01 * np.random.default_rng(2).normal(size=noisy.shape)
    given = tables(excited, tmp_path, {f"current_{leg + 1}": noisy[:, leg] for leg in range(6)})
    words = ["identify", str(written(machine, tmp_path / "robot.toml")), *given, "--drive-terms", "coulomb"]
    out = ["--force-std", "0.01", "--json", "-", "-o", str(tmp_path / "found")]
    found = json.loads(run(*words, *out).out)
    np.testing.assert_allclose(found["force_noise_N"], 0.01 * 0.5 * np.abs(drive.transmission_ratio))
    assert found["verdict"] == "consistent"
    assert all(abs(row["estimated"] - 30.0) < 5.0 * row["std"] for row in found["drive"])
    assert [row["robot_file"] for row in found["drive"]] == [30.0] * 6
    # Viscous friction of the drives is in that of the prismatic joints.
    assert found["robot_file"]["agreement"] == "agrees"
    found = json.loads(run(*words[:-2], *out, code=1).out)
    assert any("dry friction of up to 30 N in the robot file" in line for line in found["warnings"])
    assert not any("--position-std" in line for line in found["warnings"])
    assert found["robot_file"] == {"agreement": "not compared", "probability": None}
    words[1] = str(written(robot, tmp_path / "plain.toml"))
    assert "expected a drive with a torque_constant for every leg" in run(*words, *out, code=2).err
