"""Simulation: energy is kept, attitude has no singularity, limits stop a run where they are reached."""

import dataclasses
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from machines import dasgupta, home_position, machine_size, offset_case, random_robot
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.reference import newton_euler
from stewart_sym.simulation.actuator_models import along
from stewart_sym.studies.reports.simulation_report import springs_drift
from stewart_sym.studies.reports.simulation_report import summary as run_summary

Array = NDArray[np.float64]
ZERO = np.zeros(3)


def machine(seed: int = 3, **options: Any) -> ss.Robot:
    return random_robot(np.random.default_rng(seed), scale=1.0, **options)


def home(robot: ss.Robot, v: Any = ZERO, omega: Any = ZERO) -> ss.Motion:
    return ss.Motion(R=np.eye(3), t=home_position(robot.b, machine_size(robot)), omega=omega, v=v)


def stiffness(robot: ss.Robot, frequency: float) -> float:
    """Of each of six legs, N/m, that carries the machine at about that frequency, Hz."""
    g = ss.equations_of_motion(robot, home(robot)).g
    return float(np.linalg.norm(g[:3]) / 9.81 * (2 * np.pi * frequency) ** 2 / 3)


@pytest.mark.slow
def test_exact_keeps_the_energy_and_paper_does_not() -> None:
    """Over 4 s: `exact` to 1e-9 of the mean kinetic energy; `paper` is off by more than 0.1 of it."""
    robot = machine(friction=False)
    state = home(robot, v=[0.5, 0.2, 0.2], omega=[0.5, -0.5, 0.5])
    springs = ss.LegSprings.in_equilibrium(robot, state, stiffness(robot, 1.6))
    drift = {}
    for formulation in ("exact", "paper"):
        done = ss.simulate(robot, state, springs, 4.0, formulation=formulation, rtol=1e-9)  # type: ignore[arg-type]
        assert done.stop.reason == "completed"
        drift[formulation] = springs_drift(done, done.dense_history, springs)
    assert drift["exact"] < 1e-9
    assert drift["paper"] > 0.1


def test_friction_and_dampers_take_the_energy_they_should() -> None:
    robot = machine()
    state = home(robot, v=[0.5, 0.2, 0.2])
    k = stiffness(robot, 2.0)
    springs = ss.LegSprings.in_equilibrium(robot, state, k, damping=0.01 * k)
    run = ss.simulate(robot, state, springs, 0.5)
    nodes, weights = np.polynomial.legendre.leggauss(60)
    at = run.at(0.25 * (nodes + 1))
    taken = newton_euler.friction_power(robot, at.motion) - newton_euler.actuator_power(
        robot, at.motion, at.F
    )
    lost = run.energy[0] - run.energy[-1]
    assert 0.25 * weights @ taken == pytest.approx(lost, rel=1e-7, abs=1e-8 * run.kinetic_energy.max())
    assert run_summary(robot, run, run.dense_history, springs).endswith(
        "of the mean kinetic energy, by dampers and friction"
    )
    pushed = ss.simulate(robot, dataclasses.replace(state, F_ext=np.array([1.0, 0.0, 0.0])), springs, 0.01)
    assert run_summary(robot, pushed, pushed.dense_history, springs).endswith(
        ", by dampers, friction and the load"
    )


def test_start_and_accelerations_are_those_asked_for() -> None:
    robot = machine()
    state = home(robot, v=[0.1, -0.2, 0.3], omega=[0.3, 0.2, -0.1])
    F = np.arange(6.0) * 100
    run = ss.simulate(robot, state, F, 0.05)
    for name in ("R", "t", "v", "omega"):
        np.testing.assert_array_equal(getattr(run, name)[0], getattr(state, name))
    a, alpha = ss.forward_dynamics(robot, state, F)
    h = 1e-3
    at = run.at([0.0, h, 2 * h])
    # Difference of second order from the left end.
    for rate, true in ((at.v, a), (at.omega, alpha)):
        np.testing.assert_allclose(
            (-3 * rate[0] + 4 * rate[1] - rate[2]) / (2 * h), true, rtol=1e-3, atol=1e-2
        )


def test_orientation_passes_gimbal_lock_of_roll_pitch_yaw() -> None:
    """A platform on legs so far below that it can turn over about y, through 90 degrees and on."""
    robot = machine(base_joint="spherical", friction=False)
    robot = dataclasses.replace(
        robot, g=ZERO, p=0.1 * robot.p, b=10 * robot.b, R_0=ZERO, m_d=robot.m_d / 1e6, m_u=robot.m_u / 1e6
    )
    state = home(robot, omega=[0.0, 2.0, 0.0])
    run = ss.simulate(robot, state, np.zeros(6), 1.4, stop_conditions=ss.StopConditions(max_condition=np.inf))
    assert run.stop.reason == "completed"
    pitch = np.arctan2(-run.R[:, 2, 0], run.R[:, 0, 0])
    assert pitch[-1] > np.radians(140)
    np.testing.assert_allclose(
        np.swapaxes(run.R, -1, -2) @ run.R, np.broadcast_to(np.eye(3), run.R.shape), atol=1e-14
    )
    at = run.at(np.linspace(0, run.stop.time, 500))
    assert np.abs(np.swapaxes(at.R, -1, -2) @ at.R - np.eye(3)).max() < 1e-14
    energy = run.energy
    assert np.ptp(energy) < 1e-9 * run.kinetic_energy.max()


# Limits


def falling(robot: ss.Robot, **limits: Any) -> ss.SimulationResult:
    """The machine let go, with the limits given."""
    robot = dataclasses.replace(robot, **limits)
    return ss.simulate(robot, home(robot), np.zeros(6), 3.0)


def test_a_leg_at_its_shortest_stops_the_run_at_the_root() -> None:
    robot = machine()
    L = ss.inverse_kinematics(robot, home(robot)).L
    low = np.where(np.arange(6) == 2, L - 0.05, 0.0)
    run = falling(robot, length_limits=np.stack([low, np.full(6, 99.0)], axis=-1))
    assert (run.stop.reason, run.stop.leg) == ("length_limits", 3)
    assert run.time[-1] == run.stop.time
    assert run.L[-1, 2] == pytest.approx(low[2], abs=1e-13)
    assert (run.L[:-1, 2] > low[2]).all()
    assert run.stop.message.startswith(f"leg 3: length {low[2]:.6g} m reaches its lower limit")
    assert f"{run.stop.time:.9g} s" in run.stop.message


@pytest.mark.slow
@pytest.mark.parametrize("joint", [None, "universal"], ids=["plain", "U-C-U"])
@pytest.mark.parametrize("end", ["base", "platform"])
def test_a_joint_at_its_largest_angle_stops_the_run_at_the_root(end: str, joint: str | None) -> None:
    robot = machine(base_joint="spherical") if joint is None else offset_case(3, joint)[0]
    at_home = home_position(robot.b, machine_size(robot))
    limits = np.full((6, 2), [np.pi, 0.1] if end == "platform" else [0.1, np.pi])
    robot = dataclasses.replace(robot, home_position=at_home, joint_angle_limit=limits)
    speed = 0.1 * machine_size(robot)
    state = ss.Motion(R=np.eye(3), t=at_home, omega=[0.0, 0.3, 1.0], v=[speed, 0.0, 0.0])
    run = ss.simulate(robot, state, np.zeros(6), 3.0)
    assert run.stop.reason == "joint_angle_limit"
    assert run.stop.leg is not None
    angles = getattr(ss.joint_angles(robot, run.motion), end)
    assert angles[-1, run.stop.leg - 1] == pytest.approx(0.1, abs=1e-12)
    assert angles[:-1].max() < 0.1
    text = f"leg {run.stop.leg}: joint angle at the {end} 0.1 rad reaches its limit 0.1 rad"
    assert run.stop.message == f"{text} at {run.stop.time:.9g} s"


def test_a_law_at_its_force_limit_stops_the_run() -> None:
    robot = machine()
    state = home(robot)
    limited = dataclasses.replace(robot, force_limit=np.full(6, 1e3))
    run = ss.simulate(limited, state, lambda time, _: np.array([0, 0, 0, 0, -4e4 * time, 0]), 1.0)
    assert (run.stop.reason, run.stop.leg) == ("force_limit", 5)
    assert run.stop.time == pytest.approx(0.025, abs=1e-12)
    assert "leg 5: force -1000 N reaches its limit 1000 N at 0.025 s" in run.stop.message


def test_a_singular_pose_stops_the_run() -> None:
    """The platform is twisted about the vertical by a moment until the legs' lines meet."""
    robot = dataclasses.replace(machine(friction=False), g=ZERO)
    state = dataclasses.replace(home(robot), M_ext=np.array([0.0, 0.0, 500.0]))
    run = ss.simulate(robot, state, np.zeros(6), 20.0, stop_conditions=ss.StopConditions(max_condition=50.0))
    assert (run.stop.reason, run.stop.leg) == ("singular", None)
    H = ss.wrench_matrix(robot, run.motion)
    condition = ss.scaled_condition_number(H, ss.characteristic_length(robot))
    assert condition[-1] == pytest.approx(50.0, rel=1e-9)
    assert (condition[:-1] < 50.0).all()


def test_zero_length_legs_and_legs_along_their_axes_stop_the_run() -> None:
    robot = machine()
    L = ss.inverse_kinematics(robot, home(robot)).L
    short = ss.simulate(
        robot, home(robot), np.zeros(6), 3.0, stop_conditions=ss.StopConditions(min_length=L.min() - 0.02)
    )
    assert short.stop.reason == "zero_length"
    assert short.L[-1].min() == pytest.approx(L.min() - 0.02, abs=1e-13)
    sine = np.linalg.norm(np.cross(robot.k, ss.inverse_kinematics(robot, home(robot)).s), axis=-1)
    limit = sine.min() - 1e-3
    state = home(robot, v=[3.0, 0.0, 0.0])
    near_joint = ss.simulate(
        robot, state, np.zeros(6), 3.0, stop_conditions=ss.StopConditions(min_joint_sine=limit)
    )
    assert near_joint.stop.reason == "joint_singularity"
    leg = near_joint.stop.leg
    assert leg is not None
    s = ss.inverse_kinematics(robot, near_joint.motion).s[-1, leg - 1]
    assert np.linalg.norm(np.cross(robot.k[leg - 1], s)) == pytest.approx(limit, abs=1e-12)


# Laws


def test_computed_torque_follows_a_path_and_takes_an_error_away() -> None:
    robot = dasgupta()
    path = ss.PAPER_PATHS["I"].path
    law = ss.ComputedTorque(robot, along(path), k_p=400.0, k_d=40.0)
    start = path.sample(0.0)
    state = ss.Motion(R=start.R, t=start.t + np.array([0.01, 0.0, 0.0]), omega=start.omega, v=start.v)
    run = ss.simulate(robot, state, law, 0.5, rtol=1e-8)
    wanted = path.sample(run.time)
    error = np.linalg.norm(run.t - wanted.t, axis=-1)
    # Both eigenvalues are -20 1/s.
    np.testing.assert_allclose(error, 0.01 * (1 + 20 * run.time) * np.exp(-20 * run.time), atol=1e-7)
    np.testing.assert_allclose(run.R, wanted.R, atol=1e-6)


def test_a_sampled_law_is_asked_once_a_period_and_held_between() -> None:
    robot = machine()
    asked: list[float] = []

    def law(time: float, state: ss.Motion) -> Array:
        asked.append(time)
        return np.full(6, 100.0 * len(asked))

    run = ss.simulate(robot, home(robot), law, 0.05, control_rate=100.0)
    assert asked == [0.0, 0.01, 0.02, 0.03, 0.04]
    F = run.at([0.0, 0.0099, 0.0101, 0.045, 0.05]).F[:, 0]
    assert F.tolist() == [100.0, 100.0, 200.0, 500.0, 500.0]


@pytest.mark.parametrize("name", ["forces", "load"])
@pytest.mark.parametrize("rate", [None, 100.0])
def test_forces_and_loads_that_are_no_numbers_end_the_run_by_name(name: str, rate: float | None) -> None:
    robot = machine()
    odd = {name: lambda time, _: np.full(6, np.nan if time > 0.099 else 0.0)}
    run = ss.simulate(
        robot, home(robot), **{"forces": np.zeros(6), "duration": 1.0, "control_rate": rate} | odd
    )
    assert run.stop.reason == "step_failed"
    assert run.stop.time == pytest.approx(0.1 if rate and name == "forces" else 0.099, abs=1e-9)
    assert "no step is small enough" in run.stop.message
    assert f"{name}: expected six finite numbers at {run.stop.time:.6g}" in run.stop.message


def test_output_is_on_the_grid_and_ends_with_the_run() -> None:
    robot = machine()
    run = ss.simulate(robot, home(robot), np.zeros(6), 0.25, output_step=0.1)
    np.testing.assert_allclose(run.time, [0.0, 0.1, 0.2, 0.25], atol=1e-15)
    for name in ("R", "t", "v", "omega", "F", "L", "kinetic_energy", "potential_energy"):
        np.testing.assert_array_equal(getattr(run.at(run.time), name), getattr(run, name))


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"duration": 0.0}, r"^duration: expected a number > 0, got 0.0$"),
        ({"forces": lambda time, state: np.zeros(3)}, r"^forces: expected six numbers from the law at 0 s"),
        ({"control_rate": -1.0}, r"^control_rate: expected a number > 0"),
        ({"output_step": 1e-12}, r"^output_step: expected at least 1e-08 s, for at most 10000000 samples"),
        ({"rtol": 1e-14}, r"^rtol: expected a number in \[1e-13, 0.01\], got 1e-14$"),
        ({"load": lambda time, state: 1.0}, r"^load: expected six numbers"),
    ],
)
def test_bad_arguments_are_named(wrong: dict[str, Any], words: str) -> None:
    robot = machine()
    arguments = {"initial_state": home(robot), "forces": np.zeros(6), "duration": 0.1} | wrong
    rejects(words, ss.simulate, robot, **arguments)
