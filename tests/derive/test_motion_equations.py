"""The closed form at 50 digits: equal to the elimination, skew, and its derivatives equal to differences."""

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


def test_equations_of_motion_are_those_of_the_elimination() -> None:
    with mp.workdps(DIGITS):
        robot, motion, raw = case(0)
        F = truth(EXACT, robot, motion, raw)["F"]
        found = summed(symbolic()["equations"], raw, [mp.mpf(0)] * 6)
        bias = summed(symbolic()["bias"], raw, [mp.mpf(0)] * 6)
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
        _, _, raw = case(0)
        kernel, zero = symbolic()["equations"], [mp.mpf(0)] * 6
        forth, back = (
            summed(kernel, moved(raw, sign * STEP * twist, nothing(), nothing()), zero)
            for twist in (vector(raw[0], "v", "omega"),)
            for sign in (1, -1)
        )
        found = summed(kernel, raw, zero)
        rate = (inertia(forth) - inertia(back)) / (2 * STEP)
        C = blocks(*(found[f"C_{name}"] for name in ("vv", "vw", "wv", "ww")))
        skew = rate - 2 * C
        assert small(skew + skew.T, C, 1e-25)
        assert small((forth["H"] - back["H"]) / (2 * STEP) - found["H_dot"], found["H_dot"], 1e-25)


def test_right_side_of_forward_dynamics_gives_the_accelerations_back() -> None:
    with mp.workdps(DIGITS):
        robot, motion, raw = case(3)
        F = truth(EXACT, robot, motion, raw)["F"]
        found = summed(symbolic()["forward_dynamics"], raw, list(F))
        right = stacked(found["right_force"], found["right_moment"])
        expected = vector(raw[0], "a", "alpha")
        assert small(mp.lu_solve(inertia(found), right) - expected, expected)


def test_derivatives_of_the_wrench_are_those_of_differences() -> None:
    with mp.workdps(DIGITS):
        robot, motion, raw = case(0)
        F = list(truth(EXACT, robot, motion, raw)["F"])
        found = summed(symbolic()["derivatives"], raw, F)
        by_pose = blocks(*(found[f"W_{name}"] for name in ("ft", "fr", "mt", "mr")))
        by_twist = blocks(*(found[f"W_{name}"] for name in ("fv", "fw", "mv", "mw")))
        for derivative, place in ((by_pose, 0), (by_twist, 1), (inertia(found), 2)):
            for i in range(6):
                change = [nothing(), nothing(), nothing()]
                change[place] = unit(i)
                forth = residual(moved(raw, *change), F)
                back = residual(moved(raw, *(-part for part in change)), F)
                difference = (forth - back) / (2 * STEP)
                assert small(difference - derivative[:, i], derivative, 1e-25), (place, i)


def residual(raw: list[Values], F: list[mp.mpf]) -> mp.matrix:
    """M [a; alpha] + bias - external wrench - H F."""
    found = summed(symbolic()["equations"], raw, F)
    bias = summed(symbolic()["bias"], raw, F)
    left = inertia(found) * vector(raw[0], "a", "alpha") + stacked(bias["bias_force"], bias["bias_moment"])
    return left - load(raw[0]) - found["H"] * mp.matrix(F)
