"""Joint space through singular poses: every crossing is named, nothing else is, and jumps of lengths are."""

import functools
import re
import warnings
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from command_line import rejects
from joint_paths import dipping_case, legs_along, lengths_to_singular, random_case, truth
from machines import Array, dasgupta, machine_size
from plain_logs import read_log
from sweeps import share, sweep

import stewart_sym as ss
from stewart_sym.motion.trajectory import Trajectory
from stewart_sym.singularities.joint_space import on_platform


@functools.cache
def drawn(seed: int, most: int) -> tuple[ss.Robot, float, Array, ss.Motion, tuple[Array, ...]]:
    """A machine, when its path crosses singular poses first, s, and 60 to ``most`` samples of it."""
    rng = np.random.default_rng(seed)
    robot, path = random_case(rng)
    samples = int(np.exp(rng.uniform(np.log(60), np.log(most))))
    return robot, truth(robot, path).crossing, *legs_along(robot, path, samples)


def sample_of(error: ValueError) -> int:
    found = re.search(r"(?:L\[|line )(\d+)", str(error))
    return int(found[1])


dip = functools.cache(lambda seed: dipping_case(np.random.default_rng(seed)))


def outcome(seed: int, most: int, rates: str) -> str:
    """What becomes of a random path: "followed" and "named" are right, all else is wrong.

    most: samples at most, 60 at least. rates: which of L_ddot and time are given.
    """
    robot, crossing, time, motion, (L, L_dot, L_ddot) = drawn(seed, most)
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
        near = abs(sample_of(error) - int(np.searchsorted(time, crossing))) <= 1
        return "named" if near else f"named elsewhere: {error}"
    if np.isfinite(crossing):
        return "missed"
    same = np.abs(found.t - motion.t).max() < 1e-6 * machine_size(robot)
    return "followed" if same else "another motion"


def logged(time: Array, L: Array, folder: Path) -> Trajectory:
    """Lengths as read from a log."""
    header = "time," + ",".join(f"L_{leg}" for leg in range(1, 7))
    table = np.hstack([time[:, None], L])
    np.savetxt(folder / "log.csv", table, fmt="%.12g", delimiter=",", header=header, comments="")
    with warnings.catch_warnings(action="ignore", category=ss.TrajectoryWarning):
        log = read_log(folder / "log.csv")
    return log


def tally(seeds: range, most: int, rates: str) -> Counter[str]:
    found = {seed: outcome(seed, most, rates) for seed in seeds}
    wrong = {seed: text for seed, text in found.items() if text not in ("named", "followed")}
    assert not wrong
    return Counter(found.values())


@pytest.mark.slow
@sweep
@pytest.mark.parametrize("rates", ["L_ddot", "time"])
def test_a_path_that_crosses_and_returns_between_two_samples_is_named(rates: str) -> None:
    for seed in range(share(100, 50)):
        robot, path, samples = dip(seed)
        time, motion, (L, *given) = legs_along(robot, path, samples)
        acceleration, times = (given[1], None) if rates == "L_ddot" else (None, time)
        with pytest.raises(ValueError, match="singular") as error:
            ss.motion_from_lengths(robot, L, given[0], acceleration, (motion.R[0], motion.t[0]), time=times)
        crossing = int(np.searchsorted(time, truth(robot, path).crossing))
        assert abs(sample_of(error.value) - crossing) <= 1, seed


@pytest.mark.slow
@pytest.mark.parametrize("rates", ["L_ddot", "time"])
def test_every_crossing_of_many_random_paths_is_named_and_no_other_path(rates: str) -> None:
    """2,000 paths of 60 to 2,000 samples: random, across singular poses, and grazing them."""
    count, start = share(1000, 125), 1000 if rates == "time" else 2000
    print(tally(range(start, start + count), 2000, rates))


def test_noise_of_lengths_is_that_stated_and_its_bad_values_are_named() -> None:
    robot, time, motion, legs = wave(60)
    first = (motion.R[0], motion.t[0])
    for sigma in (0.0, 1e-6, np.full(6, 1e-5)):
        found = ss.motion_from_lengths(robot, *legs, first, time=time, length_std=sigma)
        np.testing.assert_allclose(found.t, motion.t, atol=1e-9)
    with pytest.raises(
        ValueError, match=r"^L\[1\]: a singular pose is as near as the noise of the lengths, 1 m"
    ):
        ss.motion_from_lengths(robot, *legs, first, time=time, length_std=1.0)
    for bad in (-1.0, np.nan, np.zeros(5)):
        with pytest.raises(
            ValueError, match=r"^length_std: expected standard deviations >= 0 m that broadcast to"
        ):
            ss.motion_from_lengths(robot, *legs, first, time=time, length_std=bad)


def wave(samples: int) -> tuple[ss.Robot, Array, ss.Motion, tuple[Array, ...]]:
    """The paper's machine and its legs along a motion that keeps clear of singular poses."""
    robot, (path, _) = dasgupta(), ss.PAPER_PATHS["I"]
    time = np.linspace(0.0, path.tau_f, samples)
    motion = path.sample(time)
    legs = ss.inverse_kinematics(robot, motion)
    return robot, time, motion, (legs.L, legs.L_dot, legs.L_ddot)


@pytest.mark.parametrize("glitch", [1e-3, -0.1])
def test_a_glitch_of_one_sample_is_named(glitch: float) -> None:
    samples = 60
    robot, time, motion, legs = wave(samples)
    for sample in (2, samples // 3, samples - 3):
        L = legs[0].copy()
        L[sample, 2] += glitch
        # Lengths alone tell a glitch from an acceleration of the path's own only where it is larger.
        alone = [spline_rates(time, L)] if abs(glitch) * samples >= 0.6 else []
        for rates in (legs[1:], *alone):
            with pytest.raises(ValueError, match=rf"^L\[{sample}\]: the "):
                ss.motion_from_lengths(robot, L, *rates, (motion.R[0], motion.t[0]), time=time)


@pytest.mark.parametrize("timed", [True, False], ids=["timed", ""])
def test_rates_of_another_motion_are_named(timed: bool) -> None:
    robot, time, motion, (L, L_dot, L_ddot) = wave(60)
    follow = functools.partial(
        ss.motion_from_lengths, robot, L, guess=(motion.R[0], motion.t[0]), time=time if timed else None
    )
    follow(L_dot, L_ddot)
    rejects("L_dot: .*", follow, -L_dot, L_ddot)
    rejects("L_dot: the integral of rates differs from the positions", follow, L_dot[:, ::-1], L_ddot)
    rejects("L_dot: the integral of second rates differs from the rates", follow, L_dot, -L_ddot)
    if timed:
        # Orthogonal to the motion, and accelerations that agree with it.
        w, wrong = 4.0 * np.pi / (time[-1] - time[0]), np.eye(6)[2] * np.abs(L_dot).max()
        faster = w * (time[:, None] - time[0])
        with pytest.raises(ValueError, match="L_dot: the integral of rates differs from the positions"):
            follow(L_dot + wrong * np.sin(faster), L_ddot + w * wrong * np.cos(faster))
        rejects("L_dot: the integral of rates differs", follow, 0.5 * L_dot, L_ddot)


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


def rounded_outcome(seed: int, most: int, rates: str, folder: Path) -> str:
    """What becomes of a random path's lengths rounded to 0.01 mm, by themselves in a log or with rates.

    Right are also paths that are named as undecided where the lengths are as near to those of a singular pose
    as rounding by five times its deviation, and healthy ones are nowhere as near as that twice.
    """
    robot, crossing, time, motion, (exact, *true_rates) = drawn(seed, most)
    L, first = np.round(exact, 5), (motion.R[0], motion.t[0])
    near = lengths_to_singular(robot, motion) < 2.0 * 5.0 * 1e-5 / np.sqrt(12.0)
    try:
        if rates == "log":
            found = on_platform(robot, logged(time, L, folder), first).motion
        else:
            found = ss.motion_from_lengths(robot, L, *true_rates, first, time=time)
    except ValueError as error:
        sample = sample_of(error) - (2 if rates == "log" else 0)
        passed = np.isfinite(crossing) and abs(sample - int(np.searchsorted(time, crossing))) <= 1
        undecided = "inconclusive at this noise" in str(error) and near[sample]
        return "named" if passed else "undecided" if undecided else f"rejected: {error}"
    if np.isfinite(crossing):
        return "missed"
    return "followed" if np.abs(found.t - motion.t).max() < 0.02 * machine_size(robot) else "another motion"


@sweep
@pytest.mark.parametrize("rates", ["log", "given"])
def test_of_rounded_lengths_no_crossing_is_missed_and_no_healthy_path_rejected(
    rates: str, tmp_path: Path
) -> None:
    found = {seed: rounded_outcome(seed, 100, rates, tmp_path) for seed in range(share(200, 66))}
    assert set(found.values()) <= {"named", "undecided", "followed"}, found
