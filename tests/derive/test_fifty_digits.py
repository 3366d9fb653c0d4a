"""Blocks and what the C makes of them at 50 digits: forces, regrouped blocks, closed form and regressor."""

import functools
from typing import Any

import numpy as np
import pytest
from fifty_digits import DIGITS, columns, forces, further, orthonormal, orthonormal_inputs, truth
from machines import machine_in_motion, random_motion, random_robot, random_robot_of
from motion_fields import FIELDS
from mpmath import mp
from numpy.typing import NDArray
from sweeps import slow_but

import stewart_sym as ss
from stewart_sym.derive.mechanics.actuator_forces import force_kernel
from stewart_sym.derive.mechanics.formulation import EXACT, FORMULATIONS, PAPER, Formulation
from stewart_sym.derive.mechanics.regressor import dependencies
from stewart_sym.kit.interpreter import KitInterpreter
from stewart_sym.motion.motion import Motion
from stewart_sym.precision.exact_forces import digits
from stewart_sym.robot.robot import Robot

UNITS = 40
EPSILON = np.finfo(np.float64).eps


def error(found: NDArray[np.float64], true: mp.matrix) -> float:
    """Largest difference beside the largest entry."""
    expected = list(true)
    difference = max(abs(mp.mpf(float(a)) - b) for a, b in zip(found.ravel(), expected, strict=True))
    return float(difference / max(abs(value) for value in expected))


@pytest.mark.slow
@pytest.mark.parametrize("form", slow_but([EXACT, PAPER], FORMULATIONS), ids=lambda form: form.kernel_name)
def test_c_equals_50_digit_truth_to_rounding(form: Formulation) -> None:
    """Every output, and forces of the prepared kernel, of one pose and of a batch."""
    rng = np.random.default_rng(1)
    robot = random_robot_of(rng, form)
    motion = random_motion(rng, robot)
    found = ss.inverse_dynamics(robot, motion, form.name)  # type: ignore[arg-type]
    kernel = ss.ForceKernel(robot, form.name)  # type: ignore[arg-type]
    slot = kernel.single_pose()
    slot.numbers[:] = np.concatenate([np.ravel(getattr(motion, name)) for name in FIELDS])
    assert slot.solve() == 0
    condition = ss.condition_number(found.H)
    with mp.workdps(DIGITS):
        true = truth(form, robot, motion)
        for name in ("D", "K", "H", "c"):
            assert error(getattr(found, name), true[name]) <= UNITS * EPSILON, name
        for name in ("x", "F"):
            assert error(getattr(found, name), true[name]) <= UNITS * EPSILON * condition, name
        for F in (slot.F, kernel.forces(motion)):
            assert error(F, true["F"]) <= UNITS * EPSILON * condition


ROUNDING = 1e-13
derived = functools.cache(force_kernel)


@pytest.mark.parametrize("form", slow_but([EXACT, PAPER], FORMULATIONS), ids=lambda form: form.kernel_name)
@pytest.mark.parametrize("friction", [True, False])
def test_forces_are_those_of_the_elimination(form: Formulation, friction: bool) -> None:
    rng = np.random.default_rng(0)
    robot = random_robot_of(rng, form, friction)
    motion = random_motion(rng, robot)
    with mp.workdps(50):
        expected = truth(form, robot, motion)["F"]
        found = forces(derived(form, friction), robot, motion)
        # R and k are orthonormal to double rounding only, and the two forms use that at different places.
        assert mp.mnorm(found - expected, mp.inf) <= ROUNDING * mp.mnorm(expected, mp.inf)


def test_rate_of_the_inertia_less_twice_the_coriolis_matrix_is_skew() -> None:
    rng = np.random.default_rng(0)
    robot = random_robot(rng)
    numbers, at = orthonormal(robot, random_motion(rng, robot))
    run, step = KitInterpreter(numbers, "universal"), digits.mpf("1e-15")

    def matrices(h: Any) -> dict[str, NDArray[Any]]:
        """A moment further along the motion."""
        moment = further(at, t=h * at["v"], R=h * at["omega"])
        return run.found("equations", moment)

    now, forth, back = map(matrices, (0 * step, step, -step))
    rate = {name: (forth[name] - back[name]) / (2 * step) for name in ("M", "H")}
    skew = (rate["M"] - 2 * now["C"]).reshape(6, 6)
    assert abs(skew + skew.T).max() <= 1e-25 * abs(now["C"]).max()
    assert abs(rate["H"] - now["H_dot"]).max() <= 1e-25 * abs(now["H_dot"]).max()


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
@pytest.mark.parametrize("seed", range(3))
def test_regressor_times_parameters_is_the_wrench_of_actuators_and_load(seed: int, friction: bool) -> None:
    robot, motion = machine_in_motion(seed, (5, 2), friction=friction)
    Y, pi = ss.regressor(robot, motion), ss.inertial_parameters(robot)
    assert Y.shape == (5, 2, 6, 148)
    expected = wrench(robot, motion)
    for rows in (slice(0, 3), slice(3, 6)):
        difference = (Y @ pi.values - expected)[..., rows]
        terms = np.abs(Y * pi.values)[..., rows, :].sum(axis=-1)
        assert np.max(np.abs(difference)) <= 1e-12 * np.max(terms)


@pytest.mark.slow
def test_columns_that_are_sums_of_others_on_every_machine_are_so_at_50_digits() -> None:
    dependent = dependencies()
    assert len(dependent) == 8
    for seed in range(1):
        with mp.workdps(DIGITS):
            rng = np.random.default_rng(seed)
            robot = random_robot(rng)
            raw = orthonormal_inputs(robot, random_motion(rng, robot))
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
    robot, motion = machine_in_motion(rng, (3,))
    other = ss.Robot(**{**vars(random_robot(rng)), "b": robot.b, "p": robot.p, "k": robot.k, "g": robot.g})
    assert np.array_equal(ss.regressor(robot, motion), ss.regressor(other, motion))
