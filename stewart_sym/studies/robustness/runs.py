"""Families 6: simulation across a singular pose, with stiff friction, and over long times, by integrator."""

import dataclasses
from typing import cast

import numpy as np

from ...dynamics.equations import ForwardDynamics
from ...dynamics.home_pose import home_pose
from ...io.array_types import Array
from ...kinematics.inverse_kinematics import leg_vectors
from ...motion.motion import Motion
from ...motion.straight_line import PAPER_PATHS
from ...reference import newton_euler
from ...results import NOT_FINITE, OK
from ...robot.robot import Robot
from ...robots import dasgupta1998
from ...simulation.actuator_models import LegSprings
from ...simulation.fixed_step import advance
from ...simulation.simulation import METHODS, Method, simulate
from ...simulation.stop_conditions import StopConditions
from ..paper.reproduce import without_friction
from .family import EPS, Curve, Family
from .singular import crossing_of_path_III
from .sweep.machines import GRAVITY, machine_size, random_machine

STEP = 1e-3
"""Length of the fixed steps (s)."""
LONGEST = 2.0
"""Duration of the long runs (s)."""
TIME_CONSTANTS = np.logspace(0, -6, 10)
"""Time constants of increasingly stiff friction (s)."""
LONG_RTOL: dict[str, float] = {"DOP853": 1e-9, "Radau": 1e-5}
FIXED = f"RK4, {1e3 * STEP:g} ms"
HELD = f"{FIXED}, forces held"
INTEGRATORS = cast(tuple[Method, ...], METHODS)
NOT_STOPPED = StopConditions(max_condition=float("inf"))


def families() -> list[Family]:
    """Return the families: across a singular pose, stiff friction, and long runs."""
    return [_across(), _stiff(), _long()]


def _across() -> Family:
    """Simulate a free fall over the crossing of Path III; error over the tolerance."""
    robot = dasgupta1998()
    path, crossing = PAPER_PATHS["III"].path, crossing_of_path_III()
    moving = path.sample(crossing - 0.1)
    start = Motion(R=moving.R, t=moving.t, omega=moving.omega, v=moving.v)
    F = np.zeros(6)
    duration = 0.2
    truth = simulate(robot, start, F, duration, rtol=1e-13, atol=1e-15, stop_conditions=NOT_STOPPED)
    tolerances = np.logspace(-3, -10, 15)
    curves = []
    for method in INTEGRATORS:
        error = []
        for rtol in tolerances:
            run = simulate(
                robot,
                start,
                F,
                duration,
                method=method,
                rtol=rtol,
                atol=1e-3 * rtol,
                stop_conditions=NOT_STOPPED,
            )
            error.append(np.abs(run.t[-1] - truth.t[-1]).max() / machine_size(robot))
        curves.append(Curve(method, np.array(error), tolerances / EPS, shipped=True))
    stopped = simulate(robot, start, F, duration)
    return Family(
        "run_across_singular",
        "Simulation across a singular pose",
        "simulation across a singular pose",
        "forward dynamics needs no inverse of H; a run stops at a condition number of 1e6 by default",
        "relative tolerance of a step",
        tuple(curves),
        tolerances,
        notes=(f"with the thresholds as they are the run ends: {stopped.stop.message}.",),
        error_axis="error of the position over the machine's size",
    )


def _stiff() -> Family:
    """Simulate friction in the legs with decreasing time constants."""
    rng = np.random.default_rng(8)
    robot = random_machine(rng)
    start = _moving(robot)
    times = TIME_CONSTANTS
    duration = 0.02
    curves: dict[str, list[float]] = {name: [] for name in (*METHODS, FIXED)}
    status: dict[str, list[int]] = {name: [] for name in curves}
    steps: dict[str, list[float]] = {name: [] for name in METHODS}
    F = np.zeros(6)
    for time in times:
        machine = dataclasses.replace(robot, C_p=np.full(6, robot.M / time))
        truth = simulate(machine, start, F, duration, method="Radau", rtol=1e-10, atol=1e-13)
        for method in INTEGRATORS:
            run = simulate(machine, start, F, duration, method=method)
            curves[method].append(_off(run.t[-1], truth.t[-1], machine))
            status[method].append(OK)
            steps[method].append(float(run.step_count))
        with np.errstate(all="ignore"):
            end, codes = advance(ForwardDynamics(machine), start, F, duration, round(duration / STEP))
        curves[FIXED].append(_off(end.t, truth.t[-1], machine))
        status[FIXED].append(int(codes) or (OK if np.isfinite(end.t).all() else NOT_FINITE))
    # Error that the tolerance of a step permits.
    allowed = np.full(len(times), 1e-9 / EPS)
    return Family(
        "run_stiff",
        "Simulation with stiff friction",
        "stiff friction or springs",
        'DOP853 remains accurate with more steps; method "Radau" if the steps become too many',
        "time constant of the friction, s",
        tuple(
            Curve(name, np.array(curves[name]), allowed, np.array(status[name], np.int32), name != FIXED)
            for name in curves
        ),
        times,
        {f"steps, {name}": np.array(steps[name]) for name in METHODS},
        "steps of a run",
        growth_title="the price",
        notes=(
            f"steps at a time constant of {times[-1]:.0e} s: "
            + ", ".join(f"{name} {steps[name][-1]:.0f}" for name in METHODS)
            + ".",
        ),
        error_axis="error of the position over the machine's size",
    )


def _long() -> Family:
    """Return the largest energy change until a time, relative to the kinetic energy."""
    robot = without_friction(random_machine(np.random.default_rng(8)))
    start = _moving(robot)
    springs = LegSprings.in_equilibrium(robot, start, stiffness=1e2 * robot.M * GRAVITY / machine_size(robot))
    times = np.logspace(np.log10(LONGEST), -2, 25)
    even = np.linspace(0.0, LONGEST, round(LONGEST / STEP) + 1)
    drifts: dict[str, Array] = {}
    scale = 0.0
    for method in INTEGRATORS:
        run = simulate(robot, start, springs, LONGEST, method=method, rtol=LONG_RTOL[method])
        trace = run.at(even)
        energy = trace.energy + springs.energy(trace.L)
        scale = scale or float(trace.kinetic_energy.mean())
        drifts[f"{method}, rtol {LONG_RTOL[method]:.0e}"] = np.abs(energy - energy[0]) / scale
    drifts[HELD] = _fixed_drift(robot, start, springs, len(even)) / scale
    curves = []
    for name, drift in drifts.items():
        until = np.maximum.accumulate(drift)
        error = until[np.minimum(np.searchsorted(even, times), len(even) - 1)]
        # Error that may accumulate over the steps at this tolerance.
        rtol = LONG_RTOL.get(name.split(",")[0], STEP**3)
        curves.append(Curve(name, error, np.full(len(times), rtol / EPS), shipped=name != HELD))
    return Family(
        "run_long",
        "Energy of a frictionless machine on springs over time",
        "long runs",
        "error grows with time at the rate of the tolerance; the energy shows it",
        "time, s",
        tuple(curves),
        times,
        error_axis="change of energy over kinetic energy",
    )


def _fixed_drift(robot: Robot, state: Motion, springs: LegSprings, count: int) -> Array:
    """Return the energy change at each fixed step (J), (count,), with constant forces during a step."""
    plant = ForwardDynamics(robot)
    energy = np.empty(count)
    for i in range(count):
        lengths = leg_vectors(robot, state.R, state.t)[2]
        energy[i] = float(newton_euler.energy(robot, state)) + float(springs.energy(lengths))
        state, _ = advance(plant, state, springs(0.0, state), STEP)
    return np.asarray(np.abs(energy - energy[0]))


def _moving(robot: Robot) -> Motion:
    return Motion(
        R=np.eye(3), t=home_pose(robot).t, omega=np.array([0.2, -0.1, 0.3]), v=np.array([0.1, 0.2, -0.1])
    )


def _off(found: Array, truth: Array, robot: Robot) -> float:
    return float(np.abs(found - truth).max() / machine_size(robot))
