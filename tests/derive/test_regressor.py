"""The regressor times the parameters is the wrench of the actuators and the load; at 50 digits as well."""

import numpy as np
import pytest
from fifty_digits import DIGITS, truth
from machines import dasgupta, random_motion, random_robot
from motion_blocks import case, load
from mpmath import mp
from numpy.typing import NDArray
from regressor_blocks import columns

import stewart_sym as ss
from stewart_sym.derive.mechanics import regressor as derived
from stewart_sym.derive.mechanics.formulation import EXACT
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


def test_blocks_give_the_wrench_of_the_elimination_at_50_digits() -> None:
    for seed in range(2):
        with mp.workdps(DIGITS):
            robot, motion, raw = case(seed)
            true = truth(EXACT, robot, motion, raw)
            expected = true["H"] * true["F"] + load(raw[0])
            legs, platform = columns(raw)
            total = mp.zeros(6, 1)
            for leg, values in zip(legs, raw, strict=True):
                total += sum((leg[name] * value for name, value in leg_parameters(values).items()), total * 0)
            own = platform_parameters(raw[0])
            total += sum((platform[name] * value for name, value in own.items()), total * 0)
            assert mp.norm(total - expected) <= mp.mpf(10) ** -40 * mp.norm(expected)


def leg_parameters(values: dict[str, mp.mpf]) -> dict[str, mp.mpf]:
    """A leg's parameters from the robot's numbers, by name."""
    found = {name: values[name] for name in ("m_d", "m_u", "C_u", "C_p", "C_s")}
    return (
        found
        | about_joint(values, "d", "m_d", "r_d0", "I_d0")
        | about_joint(values, "u", "m_u", "r_u0", "I_u0")
    )


def platform_parameters(values: dict[str, mp.mpf]) -> dict[str, mp.mpf]:
    return {"M": values["M"]} | about_joint(values, "P", "M", "R_0", "I_p")


def about_joint(values: dict[str, mp.mpf], part: str, m: str, r: str, inertia: str) -> dict[str, mp.mpf]:
    mass, at = values[m], {axis: values[f"{r}_{axis}"] for axis in "xyz"}
    square = sum(x * x for x in at.values())
    found = {f"h_{part}_{axis}": mass * at[axis] for axis in "xyz"}
    for i, j in ("xx", "xy", "xz", "yy", "yz", "zz"):
        transport = (square if i == j else 0) - at[i] * at[j]
        found[f"J_{part}_{i}{j}"] = values[f"{inertia}_{i}{j}"] + mass * transport
    return found


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


def test_what_has_no_regressor_is_rejected_in_one_line() -> None:
    rng = np.random.default_rng(0)
    robot, ball = random_robot(rng), random_robot(rng, "spherical")
    motion = random_motion(rng, robot, (2,))
    with pytest.raises(ValueError, match=r'robot: expected base_joint "universal"'):
        ss.regressor(ball, motion)
    with pytest.raises(ValueError, match=r'robot: expected base_joint "universal"'):
        ss.inertial_parameters(ball)
    with pytest.raises(ValueError, match="motion: expected accelerations"):
        ss.regressor(robot, ss.Motion(motion.R, motion.t, motion.omega, motion.v))
    with pytest.raises(ValueError, match="on_singular"):
        ss.regressor(robot, motion, on_singular="pass")  # type: ignore[arg-type]


def test_a_leg_along_its_axis_is_named_or_gives_nan() -> None:
    robot = dasgupta()
    zero = np.zeros((2, 3))
    S = np.array([robot.k[1], [0.0, 0.0, 1.0]])
    motion = ss.Motion(np.eye(3), robot.b[1] - robot.p[1] + S, zero, zero, zero, zero)
    with pytest.raises(ValueError, match=r"motion\[0\].*leg 2"):
        ss.regressor(robot, motion)
    Y = ss.regressor(robot, motion, on_singular="nan")
    assert np.isnan(Y[0]).all()
    assert np.isfinite(Y[1]).all()
