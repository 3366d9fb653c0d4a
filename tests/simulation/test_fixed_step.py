"""Fixed steps: fourth order, the same motion as the adaptive integration, rotations that stay rotations."""

import numpy as np
from machines import home_position, machine_size, random_robot

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.dynamics.equations import ForwardDynamics
from stewart_sym.motion.rotation import rotation_from_vector, vector_from_rotation
from stewart_sym.simulation.fixed_step import advance

DURATION = 0.1


def swinging(robot: ss.Robot, count: int = 1) -> ss.Motion:
    """States (count,) near home, moving and turning fast."""
    rng = np.random.default_rng(5)
    return ss.Motion(
        R=rotation_from_vector(0.2 * rng.normal(size=(count, 3))),
        t=home_position(robot.b, machine_size(robot)) + 0.05 * rng.normal(size=(count, 3)),
        omega=2.0 * rng.normal(size=(count, 3)),
        v=0.5 * rng.normal(size=(count, 3)),
    )


def machine() -> ss.Robot:
    return random_robot(np.random.default_rng(3), scale=1.0)


def holding(robot: ss.Robot, state: ss.Motion) -> np.ndarray:
    zero = np.zeros_like(state.t)
    return ss.inverse_dynamics(
        robot, ss.Motion(R=state.R, t=state.t, omega=zero, v=zero, alpha=zero, a=zero)
    ).F


def distance(one: ss.Motion, other: ss.Motion) -> float:
    turn = vector_from_rotation(one.R @ np.swapaxes(other.R, -1, -2))
    gaps = (turn, one.t - other.t, one.v - other.v, one.omega - other.omega)
    return max(float(np.abs(gap).max()) for gap in gaps)


def test_twice_the_steps_leave_a_sixteenth_of_the_error() -> None:
    robot = machine()
    plant, state = ForwardDynamics(robot), swinging(robot, 4)
    F = holding(robot, state)
    found = {steps: advance(plant, state, F, DURATION, steps)[0] for steps in (8, 16, 64)}
    coarse, fine = (distance(found[steps], found[64]) for steps in (8, 16))
    assert 12.0 < coarse / fine < 22.0
    assert fine < 1e-5


def test_a_state_without_accelerations_has_a_status_and_leaves_the_others_alone() -> None:
    robot = machine()
    state = swinging(robot, 2)
    F = holding(robot, state)
    alone, _ = advance(ForwardDynamics(robot), state, F, 0.01)
    F[1] = np.nan
    end, status = advance(ForwardDynamics(robot), state, F, 0.01)
    assert status.tolist() == [results.OK, results.NOT_FINITE]
    assert np.isnan(end.t[1]).all()
    np.testing.assert_array_equal(end.t[0], alone.t[0])
