"""The closed form at 50 digits: equal to the elimination, skew, and its derivatives equal to differences."""

import pytest
from fifty_digits import DIGITS, truth
from motion_blocks import (
    STEP,
    Values,
    blocks,
    case,
    inertia,
    load,
    moved,
    nothing,
    stacked,
    summed,
    symbolic,
    unit,
    vector,
)
from mpmath import mp

from stewart_sym.derive.mechanics.formulation import EXACT


def small(difference: mp.matrix, beside: mp.matrix, tolerance: float = 1e-30) -> bool:
    return mp.mnorm(difference, mp.inf) <= tolerance * mp.mnorm(beside, mp.inf)


@pytest.mark.parametrize("friction", [True, False])
def test_equations_of_motion_are_those_of_the_elimination(friction: bool) -> None:
    with mp.workdps(DIGITS):
        robot, motion, raw = case(0, friction)
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


def test_rate_of_the_inertia_less_twice_the_coriolis_matrix_is_skew() -> None:
    with mp.workdps(DIGITS):
        _, _, raw = case(0, True)
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
def test_derivatives_of_the_wrench_are_those_of_differences(friction: bool) -> None:
    with mp.workdps(DIGITS):
        robot, motion, raw = case(0, friction)
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
