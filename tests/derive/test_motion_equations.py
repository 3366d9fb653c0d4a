"""The closed form at 50 digits: the rate of its inertia less twice C is skew."""

from fifty_digits import DIGITS
from motion_blocks import STEP, blocks, case, inertia, moved, nothing, summed, symbolic, vector
from mpmath import mp


def small(difference: mp.matrix, beside: mp.matrix) -> bool:
    return mp.mnorm(difference, mp.inf) <= 1e-25 * mp.mnorm(beside, mp.inf)


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
        assert small(skew + skew.T, C)
        assert small((forth["H"] - back["H"]) / (2 * STEP) - found["H_dot"], found["H_dot"])
