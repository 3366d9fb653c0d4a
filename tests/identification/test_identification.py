"""Identified parameters are the true ones to within their standard deviations, which are what they claim."""

import dataclasses
import json
import re
from pathlib import Path

import numpy as np
import pytest
from command_line import Fails, Run, read, rejects
from machines import Array, dasgupta, random_motion
from noisy_experiments import excited, robot
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.cli.main import main
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.identification.excitation import choose_excitation
from stewart_sym.motion.rotation import rpy_from_rotation

SIGMA = 0.5


def test_identified_parameters_are_within_three_sigma() -> None:
    for seed in range(3):
        found = ss.simulate_experiment(robot(seed), excited(seed), SIGMA)
        assert np.max(np.abs(found.z_scores)) < 3.0
        assert found.estimate.normalized_residual == pytest.approx(1.0, abs=0.15)
        pi = ss.inertial_parameters(robot(seed))
        assert np.array_equal(found.true_values, found.estimate.base.matrix @ pi.values)


@pytest.mark.parametrize(("most", "verdict"), [(0.0, "consistent"), (6.0, "misfit")])
def test_forces_of_one_leg_that_drift_are_named(most: float, verdict: str) -> None:
    machine, way = robot(0), excited(0)
    F = ss.simulate_experiment(machine, way, SIGMA).F
    F[:, 0] += most * SIGMA * np.linspace(0.0, 1.0, len(F))
    found = ss.identify(machine, way.motion, F, SIGMA, way.base)
    assert found.verdict == verdict
    words = [line.partition(" from")[0] for line in found.warnings[:1]]
    assert words == ["forces: differ smoothly"] * (verdict == "misfit")


def test_masses_and_friction_of_the_robot_file_may_be_wrong_and_load_is_taken_off() -> None:
    machine = robot(1)
    rng = np.random.default_rng(7)
    still = excited(1).motion
    load = rng.normal(size=(2, *still.shape, 3))
    motion = dataclasses.replace(still, F_ext=load[0], M_ext=load[1])
    F = ss.inverse_dynamics(machine, motion).F
    guess = dataclasses.replace(
        machine, M=1.0, m_d=np.ones(6), m_u=np.ones(6), I_p=np.eye(3), C_p=np.zeros(6), R_0=np.zeros(3)
    )
    sigma = rng.uniform(0.5, 2.0, 6)
    base = ss.base_parameters(machine)
    right, wrong = (ss.identify(given, motion, F, sigma) for given in (machine, guess))
    assert np.allclose(right.values, wrong.values, rtol=0, atol=1e-6 * np.max(right.std))
    truth = base.matrix @ ss.inertial_parameters(machine).values
    assert np.max(np.abs(right.values - truth) / right.std) < 1e-3


def test_what_a_motion_does_excite_can_be_identified() -> None:
    machine = dasgupta()
    path, step = ss.PAPER_PATHS["II"]
    motion = path.sample(path.time_grid(step))
    F = ss.inverse_dynamics(machine, motion).F
    base = ss.base_parameters(machine, motion)
    rejects(r"motion: excites \d+ of 100 base parameters", ss.identify, machine, motion[:10], F[:10], 1.0)
    other = dataclasses.replace(machine, b=1.01 * machine.b)
    rejects("base_parameters: expected the b of the robot", ss.identify, other, motion, F, 1.0, base)
    found = ss.identify(machine, motion, F, 1.0, base)
    truth = base.matrix @ ss.inertial_parameters(machine).values
    assert np.max(np.abs(found.values - truth) / found.std) < 0.01


def test_excitation_keeps_within_the_limits_and_tells_more_the_more_is_tried() -> None:
    machine = robot(0)
    free = ss.choose_excitation(machine, samples=100, candidates=3)
    legs = ss.inverse_kinematics(machine, free.motion)
    middle, L = home_pose(machine).L, legs.L
    limits = np.column_stack([middle - 0.3 * np.ptp(L, axis=0), middle + 0.3 * np.ptp(L, axis=0)])
    limited = dataclasses.replace(
        machine, length_limits=limits, speed_limit=0.4 * np.max(np.abs(legs.L_dot), axis=0)
    )
    angles = ss.joint_angles(dataclasses.replace(machine, home_position=home_pose(machine).t), free.motion)
    narrow = np.stack([0.2 * angles.base.max(axis=0), 0.3 * angles.platform.max(axis=0)], axis=-1)
    stiff = dataclasses.replace(machine, home_position=home_pose(machine).t, joint_angle_limit=narrow)
    swung = ss.joint_angles(stiff, ss.choose_excitation(stiff, samples=100, candidates=3).motion)
    assert np.all(swung.base <= narrow[:, 0])
    assert np.all(swung.platform <= narrow[:, 1])
    kept = ss.choose_excitation(limited, samples=100, candidates=3)
    inside = ss.inverse_kinematics(limited, kept.motion)
    assert np.all((inside.L >= limits[:, 0]) & (inside.L <= limits[:, 1]))
    assert np.all(np.abs(inside.L_dot) <= limited.speed_limit)
    assert kept.condition > free.condition
    assert ss.choose_excitation(machine, samples=100, candidates=6).condition <= free.condition
    H = ss.inverse_dynamics(machine, free.motion).H
    bound = 3.0 * home_pose(machine).scaled_condition
    assert np.max(ss.scaled_condition_number(H, ss.characteristic_length(machine))) <= bound


@pytest.mark.parametrize(
    ("F", "sigma", "words"),
    [
        (np.zeros((4, 5)), 1.0, "F: expected shape"),
        (np.zeros((3, 6)), 1.0, "F: expected forces of shape"),
        (np.zeros((4, 6)), 0.0, "force_std: expected"),
        (np.zeros((4, 6)), [1.0, 2.0], "force_std: expected"),
        (np.full((4, 6), np.nan), 1.0, "F: expected finite"),
    ],
)
def test_bad_measurements_are_named(F: Array, sigma: float, words: str) -> None:
    machine = robot(0)
    motion = random_motion(np.random.default_rng(0), machine, (4,))
    rejects(words, ss.identify, machine, motion, F, sigma)


# The command


FEW = ("--samples", "60", "--candidates", "2")


@pytest.fixture(scope="module")
def simulated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Results of an experiment with the paper's machine."""
    folder = tmp_path_factory.mktemp("simulated")
    assert main(["identify", str(PAPERS), *FEW, "-o", str(folder)]) == 0
    return folder


def test_identify_writes_a_table_a_trajectory_and_forces(tmp_path: Path, run: Run) -> None:
    target = tmp_path / "out"
    printed = run("identify", PAPERS, *FEW, "--force-std", "0.1", "-o", target).out
    assert (target / "report.txt").read_text() in printed
    assert sorted(p.name for p in target.glob("[!.]*")) == [
        "forces.csv",
        "parameters.csv",
        "report.json",
        "report.txt",
        "trajectory.csv",
    ]
    rows = read(target / "parameters.csv")
    assert len(rows) == 100
    for row in rows:
        true, estimated, sigma, deviation = (float(row[k]) for k in ("true", "estimated", "std", "z_score"))
        assert (estimated - true) / sigma == pytest.approx(deviation)
        assert row["name"] in printed
    assert rows[-10]["formula"] == "M + m_u1 + m_u2 + m_u3 + m_u4 + m_u5 + m_u6"


@pytest.mark.parametrize("noisy", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_wrong_rows_of_a_log_are_left_out_of_the_fit(tmp_path: Path, run: Run, noisy: bool) -> None:
    machine, rng = ss.Robot.from_toml(PAPERS), np.random.default_rng(5)
    chosen = choose_excitation(machine, harmonics=3, samples=600, candidates=5)
    F = ss.inverse_dynamics(machine, chosen.motion).F + 0.5 * rng.normal(size=(600, 6))
    t, theta = chosen.motion.t.copy(), rpy_from_rotation(chosen.motion.R)
    if noisy:
        t, theta = t + 1e-5 * rng.normal(size=t.shape), theta + 1e-5 * rng.normal(size=t.shape)
    t[[150, 400], 0] += 0.02
    for name, columns, values in (
        ("log.csv", "t_x,t_y,t_z,theta_x,theta_y,theta_z", np.hstack([t, theta])),
        ("forces.csv", "F_1,F_2,F_3,F_4,F_5,F_6", F),
    ):
        rows = np.column_stack([chosen.time, values])
        np.savetxt(tmp_path / name, rows, "%.17g", ",", header=f"time,{columns}", comments="")
    noise = ["--position-std", "1e-5", "--angle-std", "1e-5"] * noisy
    measured = ("--measured", tmp_path / "log.csv", tmp_path / "forces.csv", "--force-std", "0.5")
    told = run("identify", PAPERS, *measured, *noise, "-o", tmp_path / "out")
    found = json.loads((tmp_path / "out" / "report.json").read_text())
    assert found["verdict"] == "consistent"
    assert found["robot_file"]["agreement"] == "agrees"
    assert "of 600 samples at wrong rows are left out of the fit" in told.err
    assert "lines 152, 402" in told.err


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("time,F_1", "time,G1", "no column F_1"),
        ("\n0.0,", "\n0.001,", "line 2: time: expected the time 0"),
        (
            "\n0.0,",
            "\n" + "".join(f"{-9 + k}.5,1,1,1,1,1,1\n" for k in range(9)) + "0.0,",
            "60 of 69 samples and 60 of ",
        ),
    ],
)
def test_bad_forces_are_rejected_in_one_line(
    simulated: Path, tmp_path: Path, fails: Fails, old: str, new: str, words: str
) -> None:
    forces = tmp_path / "forces.csv"
    forces.write_text((simulated / "forces.csv").read_text().replace(old, new, 1))
    inputs = "--measured", simulated / "trajectory.csv", forces
    line = fails("identify", PAPERS, *inputs, "-o", tmp_path / "out")
    assert f"{forces}: " in line
    assert words in line
    assert not (tmp_path / "out").exists()


def test_rows_without_numbers_in_one_file_are_left_out_of_both(
    simulated: Path, tmp_path: Path, run: Run
) -> None:
    rows = (simulated / "forces.csv").read_text().splitlines(keepends=True)
    rows[20] = f"{rows[20].partition(',')[0]},nan,1,1,1,1,1\n"
    forces = tmp_path / "forces.csv"
    forces.write_text("".join(rows))
    inputs = "--measured", simulated / "trajectory.csv", forces, "--json"
    told = run("identify", PAPERS, *inputs, "-o", tmp_path / "out")
    line = next(line for line in told.err.splitlines() if "left out of the fit" in line)
    assert re.search(
        r"trajectory\.csv: 1 sample, the first at \S+ s, left out of the fit: no sample of the", line
    )
    assert json.loads(told.out)["verdict"] == "consistent"


@pytest.mark.parametrize(
    ("unit", "code", "said"),
    [
        ("", 2, "state the unit in the header: [kN], or [N] if it is right"),
        (" [N]", 0, "check that their unit"),
    ],
)
def test_forces_in_kn_without_a_unit_are_an_error(
    unit: str, code: int, said: str, simulated: Path, tmp_path: Path, run: Run
) -> None:
    rows = np.loadtxt(simulated / "forces.csv", delimiter=",", skiprows=1)
    forces, head = tmp_path / "forces.csv", ",".join(["time", *(f"F_{leg}{unit}" for leg in range(1, 7))])
    np.savetxt(forces, rows * [1.0, *6 * [1e-3]], delimiter=",", header=head, comments="")
    inputs = simulated / "trajectory.csv", forces, "-o", tmp_path / "out"
    told = run("identify", PAPERS, "--measured", *inputs, code=code)
    assert said in told.err
    assert (f"{forces}: forces: RMS of " in told.err) == (code == 2)


def test_forces_with_dates_and_units_are_read_and_their_sign_is_checked(
    simulated: Path, tmp_path: Path, run: Run
) -> None:
    time, *F = np.loadtxt(simulated / "forces.csv", delimiter=",", skiprows=1, unpack=True)
    start, forces = np.datetime64("2025-11-29T23:59:59", "ns"), tmp_path / "forces.csv"
    rows = [
        ";".join([str(start + round(1e9 * x)), *(f"{-1e-3 * f:.9g}" for f in row)])
        for x, *row in zip(time, *F, strict=True)
    ]
    forces.write_text("\n".join(["stamp;" + ";".join(f"Force{leg} [kN]" for leg in range(1, 7)), *rows]))
    told = run("identify", PAPERS, "--measured", simulated / "trajectory.csv", forces, "-o", tmp_path / "out")
    assert "forces: opposite to the forces by the robot file; change their sign" in told.err
