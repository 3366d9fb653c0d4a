"""Tracking controllers: their forces, their errors with an exact model, and errors of their arguments."""

import dataclasses
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from machines import dasgupta

import stewart_sym as ss
from stewart_sym.motion.rotation import rotation_from_vector
from stewart_sym.simulation.actuator_models import along

ZERO = np.zeros(3)
FAST = ss.PAPER_PATHS["II"].path


def test_a_perfect_model_tracks_to_rounding_when_its_forces_are_not_held() -> None:
    """To 1e-12 m and 1e-11 rad, the tolerance of the integration, over 20 ms."""
    robot = dasgupta()
    law = ss.ComputedTorque(ss.ForceKernel(robot).forces, along(FAST), 900.0, 60.0)
    start = FAST.sample(0.0)
    run = ss.simulate(
        robot, ss.Motion(R=start.R, t=start.t, omega=ZERO, v=ZERO), law, 0.02, rtol=1e-12, atol=1e-15
    )
    reference = FAST.sample(run.time)
    assert np.abs(run.t - reference.t).max() < 1e-12
    assert np.abs(run.R - reference.R).max() < 1e-11


def test_the_tracking_error_is_the_difference_from_the_reference() -> None:
    robot, off, turn = dasgupta(), np.array([1e-3, -2e-3, 3e-3]), np.array([2e-3, 1e-3, -1e-3])
    law = ss.ComputedTorque(robot, along(FAST), 900.0, 60.0)
    run = ss.simulate(robot, "path", law, 0.05, control_rate=1000.0)

    def shifted(time: np.ndarray) -> ss.Motion:
        motion = FAST.sample(time)
        return dataclasses.replace(motion, R=rotation_from_vector(-turn) @ motion.R, t=motion.t - off)

    own, error = ss.tracking_error(run, FAST.sample), ss.tracking_error(run, shifted)
    assert own.peak.max() < 3e-5
    np.testing.assert_allclose(error.rms, np.abs(np.concatenate([off, turn])), atol=3e-5)
    np.testing.assert_allclose(error.peak, np.abs(np.concatenate([off, turn])), atol=3e-5)
    rejects("^reference: expected a motion of shape", ss.tracking_error, run, lambda time: FAST.sample(0.0))


@pytest.mark.parametrize("method", ["DOP853", "RK45"])
def test_a_sampled_law_gives_the_same_motion_and_stop_with_every_method(method: Any) -> None:
    """Constant forces, sampled at 1 kHz or not, until the machine is near a singular pose."""
    robot, state = dasgupta(), ss.PAPER_PATHS["I"].path.sample(0.0)
    plain = ss.simulate(robot, state, np.zeros(6), 1.0, rtol=1e-11)
    sampled = ss.simulate(robot, state, np.zeros(6), 1.0, rtol=1e-11, control_rate=1000.0, method=method)
    assert plain.stop.reason == sampled.stop.reason == "singular"
    assert sampled.stop.time == pytest.approx(plain.stop.time, abs=1e-8)
    times = np.linspace(0.0, 0.2, 21)
    np.testing.assert_allclose(sampled.at(times).t, plain.at(times).t, atol=1e-9)
    np.testing.assert_allclose(sampled.at(times).R, plain.at(times).R, atol=1e-8)
