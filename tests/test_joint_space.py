"""Joint space through singular poses: every crossing is named, nothing else is, and jumps of lengths are."""

import re
from collections import Counter

import numpy as np
import pytest
from joint_paths import legs_along, random_case, truth
from machines import dasgupta, machine_size
from numpy.typing import NDArray
from sweeps import share

import stewart_sym as ss
from stewart_sym import joint_space
from stewart_sym.leg_steps import accelerations, times_from_rates

Array = NDArray[np.float64]


def outcome(seed: int, most: int, rates: str) -> str:
    """What becomes of a random path: "followed" and "named" are right, all else is wrong.

    most: samples at most, 60 at least. rates: which of L_ddot and time are given.
    """
    rng = np.random.default_rng(seed)
    robot, path = random_case(rng)
    samples = int(np.exp(rng.uniform(np.log(60), np.log(most))))
    crossing = truth(robot, path).crossing
    time, motion, (L, L_dot, L_ddot) = legs_along(robot, path, samples)
    try:
        found = ss.motion_from_lengths(
            robot,
            L,
            L_dot,
            L_ddot if "L_ddot" in rates else None,
            (motion.R[0], motion.t[0]),
            time=time if "time" in rates else None,
        )
    except ValueError as error:
        if not np.isfinite(crossing):
            return f"rejected: {error}"
        sample = int(re.match(r"L\[(\d+)\]", str(error))[1])  # type: ignore[index]
        near = abs(sample - int(np.searchsorted(time, crossing))) <= 1
        return "named" if near else f"named elsewhere: {error}"
    if np.isfinite(crossing):
        return "missed"
    same = np.abs(found.t - motion.t).max() < 1e-6 * machine_size(robot)
    return "followed" if same else "another motion"


def tally(seeds: range, most: int, rates: str) -> Counter[str]:
    found = {seed: outcome(seed, most, rates) for seed in seeds}
    wrong = {seed: text for seed, text in found.items() if text not in ("named", "followed")}
    assert not wrong
    return Counter(found.values())


@pytest.mark.parametrize("rates", ["L_ddot", "time", "L_ddot, time", ""])
def test_every_crossing_is_named_and_no_other_path(rates: str) -> None:
    found = tally(range(8), 120, rates)
    assert found["named"] > 1
    assert found["followed"] > 1


@pytest.mark.slow
@pytest.mark.parametrize("rates", ["L_ddot", "time"])
def test_every_crossing_of_many_random_paths_is_named_and_no_other_path(rates: str) -> None:
    """2,000 paths of 60 to 2,000 samples: random, across singular poses, and grazing them."""
    count = share(1000)
    print(tally(range(1000, 1000 + count), 2000, rates))


def wave(samples: int) -> tuple[ss.Robot, Array, ss.Motion, tuple[Array, ...]]:
    """The paper's machine and its legs along a motion that keeps clear of singular poses."""
    robot, (path, _) = dasgupta(), ss.PATHS["I"]
    time = np.linspace(0.0, path.tau_f, samples)
    motion = path.sample(time)
    legs = ss.inverse_kinematics(robot, motion)
    assert legs.L_ddot is not None
    return robot, time, motion, (legs.L, legs.L_dot, legs.L_ddot)


@pytest.mark.parametrize("samples", [60, 600])
@pytest.mark.parametrize("glitch", [1e-3, 1e-2, -0.1])
def test_a_glitch_of_one_sample_is_named(samples: int, glitch: float) -> None:
    robot, time, motion, legs = wave(samples)
    for sample in (2, samples // 3, samples - 3):
        L = legs[0].copy()
        L[sample, 2] += glitch
        # Lengths alone tell a glitch from an acceleration of the path's own only where it is larger.
        alone = [spline_rates(time, L)] if abs(glitch) * samples >= 0.6 else []
        for rates in (legs[1:], *alone):
            with pytest.raises(ValueError, match=rf"^L\[{sample}\]: the "):
                ss.motion_from_lengths(robot, L, *rates, (motion.R[0], motion.t[0]), time=time)


@pytest.mark.parametrize("samples", [60, 600])
def test_legs_in_reverse_order_from_a_sample_on_are_named(samples: int) -> None:
    robot, time, motion, legs = wave(samples)
    sample = samples // 2
    L, L_dot, L_ddot = (np.concatenate([x[:sample], x[sample:, ::-1]]) for x in legs)
    for rates in ((L_dot, L_ddot), (L_dot, None), spline_rates(time, L)):
        for times in (time, None):
            with pytest.raises(ValueError, match=rf"^L\[{sample}\]: the "):
                ss.motion_from_lengths(robot, L, *rates, (motion.R[0], motion.t[0]), time=times)


def test_rates_in_another_unit_are_named() -> None:
    robot, time, motion, (L, L_dot, L_ddot) = wave(60)
    with pytest.raises(
        ValueError, match=r"^L\[\d+\]: the step in lengths from the sample before is not what"
    ):
        ss.motion_from_lengths(robot, L, 1e3 * L_dot, 1e3 * L_ddot, (motion.R[0], motion.t[0]), time=time)


@pytest.mark.parametrize("decimals", [3, 4, 5])
@pytest.mark.parametrize("given", [True, False])
def test_rounded_lengths_are_no_jumps(decimals: int, given: bool) -> None:
    robot, time, motion, legs = wave(600)
    L = np.round(legs[0], decimals)
    rates = legs[1:] if given else spline_rates(time, L)
    found = ss.motion_from_lengths(robot, L, *rates, (motion.R[0], motion.t[0]), time=time)
    np.testing.assert_allclose(found.t, motion.t, atol=20 * 10.0**-decimals)


def test_a_machine_at_rest_stays_where_it_is() -> None:
    robot, _, motion, (L, L_dot, L_ddot) = wave(60)
    still = np.tile(L[0], (30, 1))
    for L_now in (still, np.concatenate([still, L[1:]])):
        count = len(L_now)
        rates = [np.concatenate([np.zeros((30, 6)), x[1:]])[:count] for x in (L_dot, L_ddot)]
        time = np.arange(float(count)) * 6.0 / 59.0
        found = ss.motion_from_lengths(robot, L_now, *rates, (motion.R[0], motion.t[0]), time=time)
        np.testing.assert_allclose(found.t[:30], np.tile(motion.t[0], (30, 1)), atol=1e-12)
        np.testing.assert_allclose(found.t[29:], motion.t[: count - 29], atol=1e-9)


def spline_rates(time: Array, L: Array) -> tuple[Array, Array]:
    """As a CSV file without rates gets them."""
    from scipy.interpolate import make_interp_spline

    spline = make_interp_spline(time, L, k=5)
    return spline(time, 1), spline(time, 2)


def test_times_and_accelerations_follow_from_lengths_and_rates() -> None:
    time = np.cumsum(np.random.default_rng(1).uniform(0.5, 1.5, 200)) * 0.01
    phase = np.arange(6.0)
    L, L_dot, L_ddot = (
        2.0 + np.sin(time[:, None] + phase),
        np.cos(time[:, None] + phase),
        -np.sin(time[:, None] + phase),
    )
    found = times_from_rates(L, L_dot)
    assert found is not None
    np.testing.assert_allclose(found, time - time[0], rtol=1e-4)
    assert times_from_rates(L, 0.0 * L_dot) is None
    np.testing.assert_allclose(accelerations(time, L, L_dot)[1:-1], L_ddot[1:-1], atol=1e-8)
    np.testing.assert_allclose(accelerations(time, L, L_dot), L_ddot, atol=1e-4)


def test_times_are_checked() -> None:
    robot, time, _, legs = wave(60)
    for bad in (time[1:], time[::-1], np.full(60, np.nan)):
        with pytest.raises(ValueError, match=r"^time: expected 60 finite times, increasing"):
            ss.motion_from_lengths(robot, *legs, time=bad)


def test_samples_approached_at_once_are_those_approached_one_after_another(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    robot, path = dasgupta(), ss.PATHS["I"].path
    motion = path.sample(np.linspace(0.0, path.tau_f, 700))
    legs = ss.inverse_kinematics(robot, motion)
    given = {"L": legs.L, "L_dot": legs.L_dot, "L_ddot": legs.L_ddot, "guess": (motion.R[0], motion.t[0])}
    calls = []
    step = joint_space._next
    monkeypatch.setattr(joint_space, "_next", lambda *given: calls.append(1) or step(*given))
    at_once = ss.motion_from_lengths(robot, **given)
    assert not calls
    none = joint_space._evident
    monkeypatch.setattr(joint_space, "_evident", lambda *given: none(*given).part(slice(0, 0)))
    singly = ss.motion_from_lengths(robot, **given)
    assert len(calls) == 699
    for name in ("R", "t", "omega", "v", "alpha", "a"):
        np.testing.assert_allclose(getattr(at_once, name), getattr(singly, name), rtol=0.0, atol=1e-11)
        np.testing.assert_allclose(getattr(at_once, name), getattr(motion, name), rtol=0.0, atol=1e-9)
