"""The closed form at 50 digits: equal to the elimination, skew, and its derivatives equal to differences."""

import functools

import numpy as np
import pytest
from machines import random_motion, random_robot
from mpmath import mp
from test_precision import DIGITS, block_inputs, named, truth
from test_regroup import by_name

from stewart_sym.derive.formulation import EXACT
from stewart_sym.derive.motion import SumKernel, kernels
from stewart_sym.derive.prepared import ADDED, Riding, prepare_leg, prepare_platform
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

STEP = mp.mpf(10) ** -15
Values = dict[str, mp.mpf]


@functools.cache
def symbolic(friction: bool) -> dict[str, SumKernel]:
    """The kernels of the closed form by name, before sharing."""
    return {kernel.name: kernel for kernel in kernels(friction)}


@functools.cache
def preparation(friction: bool) -> tuple:
    """Blocks that prepare every constant that some kernel reads."""
    every = symbolic(friction).values()
    of_leg = dict.fromkeys(q for kernel in every for q in kernel.leg.inputs)
    of_platform = dict.fromkeys(q for kernel in every for q in kernel.pose.inputs)
    return prepare_leg(of_leg, Riding(mass=True, friction=friction)), prepare_platform(of_platform)


def summed(kernel: SumKernel, friction: bool, raw: list[Values], F: list[mp.mpf]) -> dict[str, mp.matrix]:
    """Sums of a kernel over the machine as matrices by name, and H and its rate where they are handed out."""
    leg_block, platform_block = preparation(friction)
    legs = [by_name(leg_block, leg_block.run(values, mp.sqrt)) for values in raw]
    added = {name: sum(leg[name] for leg in legs) for q in ADDED for name in q.names}
    platform = by_name(platform_block, platform_block.run(raw[0] | added, mp.sqrt))
    pose = by_name(kernel.pose, kernel.pose.run(raw[0] | platform, mp.sqrt))
    total = {name: pose[name] for q in kernel.summed for name in q.names}
    columns = []
    for values, leg, force in zip(raw, legs, F, strict=True):
        found = kernel.leg.run(values | leg | pose | {"F": force}, mp.sqrt)
        parts = by_name(kernel.leg, found)
        for name in total:
            total[name] += parts[name]
        columns.append(found)
    result = {q.name: filled(q, total) for q in kernel.summed}
    for name in ("H", "H_dot"):
        if f"{name}_force" in columns[0]:
            rows = [[*leg[f"{name}_force"], *leg[f"{name}_moment"]] for leg in columns]
            result[name] = mp.matrix(rows).T
    return result


def filled(quantity, values: Values) -> mp.matrix:
    """A vector or a matrix from its components, the symmetric ones twice."""
    if len(quantity.shape) == 1:
        return mp.matrix([values[name] for name in quantity.names])
    table = dict(zip(quantity.keys, quantity.names, strict=True))

    def entry(i: int, j: int) -> mp.mpf:
        return values[table[(min(i, j), max(i, j)) if quantity.symmetric else (i, j)]]

    return mp.matrix([[entry(i, j) for j in range(3)] for i in range(3)])


def blocks(a: mp.matrix, b: mp.matrix, c: mp.matrix, d: mp.matrix) -> mp.matrix:
    """[[a, b], [c, d]]."""
    whole = mp.matrix(6, 6)
    whole[:3, :3], whole[:3, 3:], whole[3:, :3], whole[3:, 3:] = a, b, c, d
    return whole


def stacked(a: mp.matrix, b: mp.matrix) -> mp.matrix:
    """[a; b]."""
    return mp.matrix([*a, *b])


def inertia(found: dict[str, mp.matrix]) -> mp.matrix:
    """M, 6x6."""
    return blocks(found["M_vv"], found["M_vw"], found["M_vw"].T, found["M_ww"])


def inputs(robot: Robot, motion: Motion) -> list[Values]:
    first = named("b_1", robot.b[0]) | named("p_1", robot.p[0])
    return [block_inputs(robot, motion, leg) | first for leg in range(6)]


def vector(values: Values, *names: str) -> mp.matrix:
    return mp.matrix([values[f"{name}_{axis}"] for name in names for axis in "xyz"])


def rotation(w: mp.matrix) -> mp.matrix:
    return mp.expm(mp.matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]]))


def moved(raw: list[Values], pose: mp.matrix, twist: mp.matrix, acceleration: mp.matrix) -> list[Values]:
    """The motion with [dt; dphi], [dv; domega] and [da; dalpha] added, R turned in the base frame."""
    first = raw[0]
    R = mp.matrix([[first[f"R_{i}{j}"] for j in "xyz"] for i in "xyz"])
    turned = rotation(pose[3:]) * R
    change = {f"R_{i}{j}": turned[m, k] for m, i in enumerate("xyz") for k, j in enumerate("xyz")}
    parts = (("t", pose[:3]), ("v", twist[:3]), ("omega", twist[3:]), ("a", acceleration[:3]))
    for name, difference in (*parts, ("alpha", acceleration[3:])):
        change |= {f"{name}_{axis}": first[f"{name}_{axis}"] + difference[i] for i, axis in enumerate("xyz")}
    return [values | change for values in raw]


def case(seed: int, friction: bool) -> tuple[Robot, Motion, list[Values]]:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, friction=friction)
    motion = random_motion(rng, robot)
    raw = inputs(robot, motion)
    # R and k are orthonormal to double rounding only; here they must be so to 50 digits.
    with mp.workdps(DIGITS):
        R = mp.matrix([[raw[0][f"R_{i}{j}"] for j in "xyz"] for i in "xyz"])
        for _ in range(6):
            R = R * (3 * mp.eye(3) - R.T * R) / 2
        fixed = {f"R_{i}{j}": R[m, n] for m, i in enumerate("xyz") for n, j in enumerate("xyz")}
        for values in raw:
            k = vector(values, "k")
            values |= fixed | {f"k_{axis}": k[i] / mp.norm(k) for i, axis in enumerate("xyz")}
    return robot, motion, raw


def nothing() -> mp.matrix:
    return mp.zeros(6, 1)


def unit(i: int) -> mp.matrix:
    found = nothing()
    found[i] = STEP
    return found


def load(values: Values) -> mp.matrix:
    R = mp.matrix([[values[f"R_{i}{j}"] for j in "xyz"] for i in "xyz"])
    return stacked(R * vector(values, "F_ext"), R * vector(values, "M_ext"))


def small(difference: mp.matrix, beside: mp.matrix, tolerance: float = 1e-30) -> bool:
    return mp.mnorm(difference, mp.inf) <= tolerance * mp.mnorm(beside, mp.inf)


@pytest.mark.parametrize("friction", [True, False])
@pytest.mark.parametrize("seed", range(2))
def test_equations_of_motion_are_those_of_the_elimination(friction: bool, seed: int) -> None:
    with mp.workdps(DIGITS):
        robot, motion, raw = case(seed, friction)
        F = truth(EXACT, robot, motion, raw)["F"]
        found = summed(symbolic(friction)["equations"], friction, raw, [mp.mpf(0)] * 6)
        bias = summed(symbolic(friction)["bias"], friction, raw, [mp.mpf(0)] * 6)
        M, C = inertia(found), blocks(*(found[f"C_{name}"] for name in ("vv", "vw", "wv", "ww")))
        left = M * vector(raw[0], "a", "alpha") + C * vector(raw[0], "v", "omega")
        left += stacked(found["g_force"], found["g_moment"])
        left += stacked(found["friction_force"], found["friction_moment"])
        right = found["H"] * F + load(raw[0])
        assert small(left - right, right)
        short = M * vector(raw[0], "a", "alpha") + stacked(bias["bias_force"], bias["bias_moment"])
        assert small(short - right, right)


@pytest.mark.parametrize("seed", range(2))
def test_rate_of_the_inertia_less_twice_the_coriolis_matrix_is_skew(seed: int) -> None:
    with mp.workdps(DIGITS):
        _, _, raw = case(seed, True)
        kernel, zero = symbolic(True)["equations"], [mp.mpf(0)] * 6
        forth, back = (
            summed(kernel, True, moved(raw, sign * STEP * twist, nothing(), nothing()), zero)
            for twist in (vector(raw[0], "v", "omega"),)
            for sign in (1, -1)
        )
        found = summed(kernel, True, raw, zero)
        rate = (inertia(forth) - inertia(back)) / (2 * STEP)
        C = blocks(*(found[f"C_{name}"] for name in ("vv", "vw", "wv", "ww")))
        skew = rate - 2 * C
        assert small(skew + skew.T, C, 1e-25)
        assert small((forth["H"] - back["H"]) / (2 * STEP) - found["H_dot"], found["H_dot"], 1e-25)


@pytest.mark.parametrize("friction", [True, False])
def test_right_side_of_forward_dynamics_gives_the_accelerations_back(friction: bool) -> None:
    with mp.workdps(DIGITS):
        robot, motion, raw = case(3, friction)
        F = truth(EXACT, robot, motion, raw)["F"]
        found = summed(symbolic(friction)["forward_dynamics"], friction, raw, list(F))
        right = stacked(found["right_force"], found["right_moment"])
        expected = vector(raw[0], "a", "alpha")
        assert small(mp.lu_solve(inertia(found), right) - expected, expected)


@pytest.mark.parametrize("friction", [True, False])
@pytest.mark.parametrize("seed", range(2))
def test_derivatives_of_the_wrench_are_those_of_differences(friction: bool, seed: int) -> None:
    with mp.workdps(DIGITS):
        robot, motion, raw = case(seed, friction)
        F = list(truth(EXACT, robot, motion, raw)["F"])
        found = summed(symbolic(friction)["derivatives"], friction, raw, F)
        by_pose = blocks(*(found[f"W_{name}"] for name in ("ft", "fr", "mt", "mr")))
        by_twist = blocks(*(found[f"W_{name}"] for name in ("fv", "fw", "mv", "mw")))
        for derivative, place in ((by_pose, 0), (by_twist, 1), (inertia(found), 2)):
            for i in range(6):
                change = [nothing(), nothing(), nothing()]
                change[place] = unit(i)
                forth = residual(friction, moved(raw, *change), F)
                back = residual(friction, moved(raw, *(-part for part in change)), F)
                difference = (forth - back) / (2 * STEP)
                assert small(difference - derivative[:, i], derivative, 1e-25), (place, i)


def residual(friction: bool, raw: list[Values], F: list[mp.mpf]) -> mp.matrix:
    """M [a; alpha] + bias - external wrench - H F."""
    found = summed(symbolic(friction)["equations"], friction, raw, F)
    bias = summed(symbolic(friction)["bias"], friction, raw, F)
    left = inertia(found) * vector(raw[0], "a", "alpha") + stacked(bias["bias_force"], bias["bias_moment"])
    return left - load(raw[0]) - found["H"] * mp.matrix(F)
