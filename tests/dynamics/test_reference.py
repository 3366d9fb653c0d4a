"""The reference satisfies its own equations, as printed and corrected; work is energy."""

import dataclasses
from collections.abc import Callable

import numpy as np
import pytest
from machines import (
    Array,
    machine_in_motion,
    random_path,
    random_robot,
    with_random_rotors,
)
from motion_fields import balance_of, breaks_of

from stewart_sym.dynamics.forces import ForceKernel
from stewart_sym.dynamics.inverse_dynamics import inverse_dynamics
from stewart_sym.motion.motion import Motion
from stewart_sym.reference import newton_euler
from stewart_sym.reference.newton_euler import EXACT, PAPER
from stewart_sym.robot.robot import Robot

FORMULATIONS = pytest.mark.parametrize("faults", [EXACT, PAPER], ids=["exact", "paper"])


# The equations themselves


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
@FORMULATIONS
def test_reactions_satisfy_the_equations_of_both_leg_parts(
    faults: frozenset[int], base_joint: str, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    robot, motion = machine_in_motion(rng, (4,), base_joint, friction=base_joint == "universal")
    bearing = rng.uniform(-1, 1, 6)
    leg = newton_euler.legs(robot, motion, faults)
    j = newton_euler.joint_reactions(robot, motion, faults, bearing)
    g, r = robot.g, bearing[:, None] * leg.s
    m_d, m_u = robot.m_d[:, None], robot.m_u[:, None]
    r_x_F_p = np.cross(r, j.F_p)
    prismatic = robot.C_p[:, None] * leg.Ldot * leg.s

    lower_moment = [  # (17)
        -m_d * np.cross(leg.r_d, leg.a_d - g),
        -_euler(leg.I_d, leg.A, leg.W),
        j.M_u[..., None] * leg.axis,
        -r_x_F_p,
        -j.M_p,
        -robot.C_u[:, None] * leg.W,
    ]
    upper_moment = [  # (18)
        -m_u * np.cross(leg.r_u, leg.a_u - g),
        -_euler(leg.I_u, leg.A, leg.W),
        np.cross(leg.S, j.F_s),
        r_x_F_p,
        j.M_p,
        -leg.f,
    ]
    upper_force = [-m_u * (leg.a_u - g), j.F_p, j.F_s, -prismatic]  # (23)
    lower_force = [-m_d * (leg.a_d - g), -j.F_p, j.F_u, prismatic]  # (25)
    for terms in (lower_moment, upper_moment, upper_force, lower_force):
        _assert_sums_to_zero(terms)
    F = newton_euler.inverse_dynamics(robot, motion, faults).F
    np.testing.assert_allclose(np.sum(leg.s * j.F_p, axis=-1), F, atol=1e-12 * np.abs(F).max())
    np.testing.assert_allclose(np.sum(leg.s * j.F_c, axis=-1), 0, atol=1e-12 * np.abs(F).max())


@pytest.mark.parametrize("seed", range(2))
@FORMULATIONS
def test_reactions_satisfy_the_platforms_equations(faults: frozenset[int], seed: int) -> None:
    robot, motion = machine_in_motion(seed, (4,))
    leg = newton_euler.legs(robot, motion, faults)
    F_s = newton_euler.joint_reactions(robot, motion, faults).F_s
    R = motion.R @ robot.R_0
    a = np.cross(motion.alpha, R) + np.cross(motion.omega, np.cross(motion.omega, R)) + motion.a
    inertia = motion.R @ robot.I_p @ np.swapaxes(motion.R, -1, -2)
    weight = robot.M * (robot.g - a)
    _assert_sums_to_zero([weight, _turn(motion.R, motion.F_ext), -F_s.sum(axis=-2)])
    _assert_sums_to_zero(
        [
            np.cross(R, weight),
            -_euler(inertia, motion.alpha, motion.omega),
            _turn(motion.R, motion.M_ext),
            -np.cross(leg.q, F_s).sum(axis=-2),
            leg.f.sum(axis=-2),
        ]
    )


def _turn(matrix: Array, vector: Array) -> Array:
    return (matrix @ vector[..., None])[..., 0]


def _euler(inertia: Array, acceleration: Array, velocity: Array) -> Array:
    return _turn(inertia, acceleration) + np.cross(velocity, _turn(inertia, velocity))


def _assert_sums_to_zero(terms: list[Array]) -> None:
    scale = max(np.abs(term).max() for term in terms)
    np.testing.assert_allclose(sum(terms), 0, atol=1e-12 * scale)


RELATIVE = 1e-12


def exact(robot: Robot) -> Callable[[Motion], Array]:
    """Power of the compiled kernel's forces, which are those of all outputs."""

    def power(motion: Motion) -> Array:
        F = ForceKernel(robot).forces(motion)
        off = newton_euler.actuator_power(robot, motion, F - inverse_dynamics(robot, motion).F)
        assert np.abs(off).max() <= RELATIVE * np.abs(F).max()
        return newton_euler.actuator_power(robot, motion, F)

    return power


@pytest.mark.parametrize("friction", [True, False], ids=["friction", "frictionless"])
@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
@pytest.mark.parametrize("seed", range(2))
def test_exact_balances_on_random_machines_and_smooth_paths(
    seed: int, base_joint: str, friction: bool
) -> None:
    """Relative to the turnover, what all powers move to and fro.

    The gain is no measure here: the path swings about a home pose, so the energy at its end may happen to be
    that at its start, and the work of actuators and load then only balances itself and friction.
    """
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, base_joint=base_joint, friction=friction)
    balance = balance_of(robot, random_path(rng, robot), exact(robot))
    assert abs(balance.mismatch) < RELATIVE * balance.turnover
    assert balance.moved["load"] > 1e-2 * balance.turnover
    lost = balance.moved["friction"]
    assert lost > 1e-3 * balance.turnover if friction else lost == 0


@pytest.mark.parametrize("seed", range(2))
def test_exact_balances_where_rotors_turn(seed: int) -> None:
    rng = np.random.default_rng(seed)
    robot = with_random_rotors(rng, random_robot(rng))
    path, at_rest = random_path(rng, robot), dataclasses.replace(robot, drive=None)
    balance = balance_of(robot, path, exact(robot))
    assert abs(balance.mismatch) < RELATIVE * balance.turnover
    at, bare = (newton_euler.energy(each, path(breaks_of(robot))) for each in (robot, at_rest))
    assert np.abs(at - bare).max() > 1e-3 * balance.turnover


def test_power_of_a_load_is_taken_in_the_platform_frame() -> None:
    quarter_turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    x, y, z = np.eye(3)
    motion = Motion(
        R=quarter_turn, t=0 * x, omega=2 * z, v=3 * y, alpha=0 * x, a=0 * x, F_ext=5 * x, M_ext=7 * z
    )
    robot = random_robot(np.random.default_rng(0))
    assert newton_euler.external_power(robot, motion) == 3 * 5 + 2 * 7
