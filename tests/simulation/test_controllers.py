"""Tracking controllers: their forces, their errors with an exact model, and errors of their arguments."""

from typing import Any

import numpy as np
import pytest
from command_line import rejects
from machines import dasgupta, machine_in_motion

import stewart_sym as ss
from stewart_sym.simulation.actuator_models import GravityCompensation, ModelTorque, along

ZERO = np.zeros(3)
FAST = ss.PAPER_PATHS["II"].path


def test_a_perfect_model_tracks_to_rounding_when_its_forces_are_not_held() -> None:
    """To 1e-12 m and 1e-11 rad, the tolerance of the integration, over 20 ms."""
    robot = dasgupta()
    law = ModelTorque(ss.ForceKernel(robot).forces, along(FAST), 900.0, 60.0)
    start = FAST.sample(0.0)
    run = ss.simulate(
        robot, ss.Motion(R=start.R, t=start.t, omega=ZERO, v=ZERO), law, 0.02, rtol=1e-12, atol=1e-15
    )
    reference = FAST.sample(run.time)
    assert np.abs(run.t - reference.t).max() < 1e-12
    assert np.abs(run.R - reference.R).max() < 1e-11


def test_gravity_compensation_pushes_by_the_wrench_of_its_gains() -> None:
    rng = np.random.default_rng(7)
    robot, state = machine_in_motion(rng, load=False)
    off = 0.01 * rng.normal(size=3)
    reference = ss.Motion(R=state.R, t=state.t + off, omega=ZERO, v=ZERO, alpha=ZERO, a=ZERO)
    inertia = ss.equations_of_motion(robot, state).M
    law = GravityCompensation(ss.ForceKernel(robot).forces, inertia, lambda _: reference, k_p=50.0, k_d=3.0)
    asked = inertia @ np.concatenate([50.0 * off - 3.0 * state.v, -3.0 * state.omega])
    found = ss.wrench_matrix(robot, state) @ law(0.0, state) - ss.equations_of_motion(robot, state).g
    np.testing.assert_allclose(found, asked, rtol=1e-9, atol=1e-9 * np.abs(asked).max())


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"k_p": -1.0}, "k_p: expected a finite gain >= 0"),
        ({"inertia": np.eye(3)}, r"inertia: expected a matrix of shape \(6, 6\)"),
    ],
)
def test_bad_gains_are_named(wrong: dict[str, Any], words: str) -> None:
    good = {"model": ss.ForceKernel(dasgupta()).forces, "inertia": np.eye(6), "reference": along(FAST)}
    rejects(f"^{words}", GravityCompensation, **{**good, "k_p": 1.0, "k_d": 1.0, **wrong})
