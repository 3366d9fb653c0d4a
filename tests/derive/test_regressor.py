"""The regressor times the parameters is the wrench of the actuators and the load."""

import numpy as np
import pytest
from fifty_digits import DIGITS
from machines import random_motion, random_robot
from motion_blocks import case
from mpmath import mp
from numpy.typing import NDArray
from regressor_blocks import columns

import stewart_sym as ss
from stewart_sym.derive.mechanics import regressor as derived
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]


def wrench(robot: Robot, motion: Motion) -> Array:
    """H F + [R F_ext; R M_ext] of the C kernel."""
    found = ss.inverse_dynamics(robot, motion)
    total = np.einsum("...ij,...j", found.H, found.F)
    if motion.F_ext is not None and motion.M_ext is not None:
        load = [np.einsum("...ij,...j", motion.R, vector) for vector in (motion.F_ext, motion.M_ext)]
        total = total + np.concatenate(load, axis=-1)
    return total


@pytest.mark.parametrize("friction", [True, False])
@pytest.mark.parametrize("seed", range(10))
def test_regressor_times_parameters_is_the_wrench_of_actuators_and_load(seed: int, friction: bool) -> None:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, friction=friction)
    motion = random_motion(rng, robot, (5, 2))
    Y, pi = ss.regressor(robot, motion), ss.inertial_parameters(robot)
    assert Y.shape == (5, 2, 6, 148)
    expected = wrench(robot, motion)
    for rows in (slice(0, 3), slice(3, 6)):
        difference = (Y @ pi.values - expected)[..., rows]
        terms = np.abs(Y * pi.values)[..., rows, :].sum(axis=-1)
        assert np.max(np.abs(difference)) <= 1e-12 * np.max(terms)


def test_columns_that_are_sums_of_others_on_every_machine_are_so_at_50_digits() -> None:
    dependent = derived.dependencies()
    assert len(dependent) == 8
    for seed in range(3):
        with mp.workdps(DIGITS):
            _, _, raw = case(seed)
            legs, platform = columns(raw)
            for leg, values in zip(legs, raw, strict=True):
                for lost, shares in dependent.items():
                    total = mp.zeros(6, 1)
                    for base, share in shares.items():
                        factor = share.evalf(DIGITS, subs={s: values[s.name] for s in share.free_symbols})
                        total += (platform | leg)[base] * mp.mpf(factor)
                    assert mp.norm(total - leg[lost]) <= mp.mpf(10) ** -40 * (1 + mp.norm(leg[lost])), lost


def test_parameters_are_named_and_placed_as_the_columns() -> None:
    robot = random_robot(np.random.default_rng(1))
    pi = ss.inertial_parameters(robot)
    assert len(pi.names) == len(set(pi.names)) == len(pi.units) == len(pi.values) == 148
    at = dict(zip(pi.names, zip(pi.values, pi.units, strict=True), strict=True))
    assert at["m_u3"] == (robot.m_u[2], "kg")
    assert at["C_p6"] == (robot.C_p[5], "N s/m")
    assert at["h_d2_y"] == (robot.m_d[1] * robot.r_d0[1, 1], "kg m")
    x, y, _ = robot.R_0
    assert at["J_P_xy"][0] == pytest.approx(robot.I_p[0, 1] - robot.M * x * y, rel=1e-14)
    assert at["M"] == (robot.M, "kg")


def test_regressor_depends_on_the_geometry_alone() -> None:
    rng = np.random.default_rng(4)
    robot = random_robot(rng)
    motion = random_motion(rng, robot, (3,))
    other = ss.Robot(**{**vars(random_robot(rng)), "b": robot.b, "p": robot.p, "k": robot.k, "g": robot.g})
    assert np.array_equal(ss.regressor(robot, motion), ss.regressor(other, motion))
