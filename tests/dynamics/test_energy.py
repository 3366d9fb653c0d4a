"""Work and energy: what the actuators and the load put in is what the bodies gain and friction takes.

The forces of `exact` are the compiled kernel's; powers and energy are the reference's. Faults only
the reference has.
"""

import dataclasses
from collections.abc import Callable

import numpy as np
import pytest
from machines import path_period, random_path, random_robot, with_random_rotors
from numpy.typing import NDArray

from stewart_sym.dynamics.forces import prepare
from stewart_sym.dynamics.inverse import inverse_dynamics
from stewart_sym.motion.motion import Motion
from stewart_sym.reference import newton_euler
from stewart_sym.reference.newton_euler import EXACT
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]
Path = Callable[[Array], Motion]

RELATIVE = 1e-12
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


@dataclasses.dataclass(frozen=True)
class Balance:
    """One path's work and energy, J; a turnover is the integral of a power's magnitude, or of all three's."""

    actuators: float
    load: float
    friction: float
    gain: float
    turnover_load: float
    turnover: float

    @property
    def mismatch(self) -> float:
        return self.actuators + self.load - self.friction - self.gain


@pytest.mark.parametrize("friction", [True, False], ids=["friction", "frictionless"])
@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
@pytest.mark.parametrize("seed", range(3))
def test_exact_balances_on_random_machines_and_smooth_paths(
    seed: int, base_joint: str, friction: bool
) -> None:
    """Relative to the turnover, what all powers move to and fro.

    The gain is no measure here: the path swings about a home pose, so the energy at its end may happen to be
    that at its start, and the work of actuators and load then only balances itself and friction.
    """
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, base_joint=base_joint, friction=friction)
    breaks = np.linspace(0, 0.7 * path_period(robot), 9)
    balance = _balance(robot, random_path(rng, robot), breaks, EXACT)
    assert abs(balance.mismatch) < RELATIVE * balance.turnover
    assert balance.turnover_load > 1e-2 * balance.turnover
    assert balance.friction > 1e-3 * balance.turnover if friction else balance.friction == 0


@pytest.mark.parametrize("seed", range(3))
def test_exact_balances_where_rotors_turn(seed: int) -> None:
    rng = np.random.default_rng(seed)
    robot = with_random_rotors(rng, random_robot(rng))
    path, breaks = random_path(rng, robot), np.linspace(0, 0.7 * path_period(robot), 9)
    balance = _balance(robot, path, breaks, EXACT)
    assert abs(balance.mismatch) < RELATIVE * balance.turnover
    at_rest = dataclasses.replace(robot, drive=None)
    stored = newton_euler.energy(robot, path(breaks)) - newton_euler.energy(at_rest, path(breaks))
    assert np.abs(stored).max() > 1e-3 * balance.turnover


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("fault", [1, 2, 3, 4])
def test_every_fault_breaks_the_balance(fault: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng)
    breaks = np.linspace(0, 0.7 * path_period(robot), 9)
    balance = _balance(robot, random_path(rng, robot), breaks, frozenset({fault}))
    assert abs(balance.mismatch) > 1e-5 * balance.turnover


def test_power_of_a_load_is_taken_in_the_platform_frame() -> None:
    quarter_turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    x, y, z = np.eye(3)
    motion = Motion(quarter_turn, 0 * x, 2 * z, 3 * y, 0 * x, 0 * x, F_ext=5 * x, M_ext=7 * z)
    robot = random_robot(np.random.default_rng(0))
    assert newton_euler.external_power(robot, motion) == 3 * 5 + 2 * 7


def _balance(robot: Robot, path: Path, breaks: Array, faults: frozenset[int]) -> Balance:
    """Gauss-Legendre over each smooth stretch between two breaks."""
    half = np.diff(breaks)[:, None] / 2
    time = (breaks[:-1, None] + half * (NODES + 1)).ravel()
    weights = (half * WEIGHTS).ravel()
    motion = path(time)
    if faults == EXACT:
        F = prepare(robot).forces(motion)
        slow = inverse_dynamics(robot, motion).F
        off = newton_euler.actuator_power(robot, motion, F - slow)
        assert np.abs(off).max() <= RELATIVE * np.abs(F).max()
    else:
        forces = newton_euler.inverse_dynamics(robot, motion, faults)
        assert np.all(forces.status == 0)
        F = forces.F
    actuators = newton_euler.actuator_power(robot, motion, F)
    load = newton_euler.external_power(robot, motion)
    friction = newton_euler.friction_power(robot, motion)
    ends = newton_euler.energy(robot, path(breaks[[0, -1]]))
    return Balance(
        actuators=float(weights @ actuators),
        load=float(weights @ load),
        friction=float(weights @ friction),
        gain=float(ends[1] - ends[0]),
        turnover_load=float(weights @ np.abs(load)),
        turnover=float(weights @ (np.abs(actuators) + np.abs(load) + friction)),
    )
