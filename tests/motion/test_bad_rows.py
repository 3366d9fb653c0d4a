"""Glitches, frozen rows, gaps, and clocks: forces elsewhere do not change, and deviations cover errors."""

import numpy as np
import pytest
from machines import GRAVITY, home_position, machine_size, random_robot
from motion_fields import motion_of
from noisy_logs import (
    NOISES,
    Array,
    Case,
    Faults,
    case,
    coordinates,
    errors,
    faulty,
    logged,
    random_faults,
    read,
)
from sweeps import share

import stewart_sym as ss
from stewart_sym.drives.limit_status import status_codes


def minute() -> Case:
    """Return a motion of one minute at 100 Hz."""
    rng, time = np.random.default_rng(3), np.arange(6000) / 100.0
    robot = random_robot(rng, scale=1.0)
    true = coordinates(rng, machine_size(robot), time, 0.3 * np.sqrt(GRAVITY / machine_size(robot)))
    true[0, :, :3] += home_position(robot.b, machine_size(robot))
    return Case(robot, time, true, ss.inverse_dynamics(robot, motion_of(true)).F)


def undecided(codes: Array) -> Array:
    """Return True for codes of undecided limits."""
    return np.isin(codes, [1, 2])


@pytest.mark.slow
def test_a_glitch_of_any_size_changes_no_force_elsewhere() -> None:
    one = minute()
    values, rng = logged(one, "white", 0), np.random.default_rng(1)
    plain, _ = read(one.time, values)
    F, std = ss.inverse_dynamics(one.robot, plain.motion).F, ss.force_std(one.robot, plain)
    limits = np.abs(one.F).max(axis=0) * np.array([0.7, 0.95, 1.0, 1.02, 1.05, 1.3])
    before = status_codes(np.abs(F), limits, std)
    for _ in range(share(60)):
        first, count = int(rng.integers(0, 5995)), int(rng.integers(1, 6))
        columns = rng.choice(6, rng.integers(1, 3), replace=False)
        glitched = values.copy()
        glitched[first : first + count, columns] += 10.0 ** rng.uniform(-3.0, 0.0) * rng.choice([-1, 1])
        found, said = read(one.time, glitched)
        away = np.abs(one.time - one.time[first + count // 2]) > 0.1 + 0.005 * count
        F_now, std_now = ss.inverse_dynamics(one.robot, found.motion).F, ss.force_std(one.robot, found)
        assert np.all(np.abs(F_now - F)[away] < std[away]), (first, count)
        now = status_codes(np.abs(F_now), limits, std_now)
        assert not np.any(undecided(now[away]) & ~undecided(before[away])), (first, count)
        assert any("outliers" in text for text in said)


@pytest.mark.slow
def test_no_force_is_wrong_without_a_warning_for_random_faults() -> None:
    seeds = range(share(500, 40))
    beyond, silent = [], []
    for seed in seeds:
        faults = random_faults(np.random.default_rng([seed, 9]))
        kind, noise = ("sines", "minimum jerk")[seed % 2], NOISES[seed // 2 % 4]
        one = case(seed, kind, (20.0, 200.0), faults.jitter)
        time, values, _ = faulty(one, noise, faults, seed)
        found, said = read(time, values)
        off, std = errors(one, found)
        beyond.append(np.mean(np.abs(off) > 4.0 * std))
        wrong = np.abs(off) > 4.0 * std + 0.03 * np.abs(one.F).max()
        if wrong.any() and not any("gap" in text or "frozen" in text for text in said):
            silent.append(seed)
        # A gap may leave only a few rows; near the ends of these, standard deviations are too small.
        assert wrong.mean() < (5e-3 if len(off) > 50 else 0.05), seed
    assert np.mean(beyond) < 0.01
    # The log 467 has no gap: two forces are wrong by 6 % of the peak, where the jerk of the motion jumps.
    assert set(silent) <= {467}


def text_about(said: list[str], word: str) -> str:
    """Return the warning that contains a word."""
    return next(text for text in said if word in text)


@pytest.mark.parametrize("noise", ["5", "white"])
@pytest.mark.parametrize(("size", "count"), [(0.003, 1), (0.04, 5)])
def test_a_glitch_is_named_and_not_used(noise: str, size: float, count: int) -> None:
    one = case(5, samples=(40.0, 60.0))
    values = logged(one, noise, 5)
    plain, _ = read(one.time, values)
    values[200 : 200 + count, 2] += size
    found, said = read(one.time, values)
    lines = "line 202" if count == 1 else f"lines 202-{201 + count}"
    assert text_about(said, "outliers").startswith(f"outliers ({lines}); they are not used; ")
    change = ss.inverse_dynamics(one.robot, found.motion).F - ss.inverse_dynamics(one.robot, plain.motion).F
    assert np.all(np.abs(change) <= 3.0 * ss.force_std(one.robot, found))


@pytest.mark.parametrize("frozen", [4, 12])
def test_frozen_rows_are_named_and_not_used(frozen: int) -> None:
    one = case(6, samples=(40.0, 60.0))
    time, values, _ = faulty(one, "4", Faults(frozen=frozen), 6)
    found, said = read(time, values)
    assert "frozen rows (lines " in text_about(said, "frozen")
    off, std = errors(one, found)
    assert np.mean(np.abs(off) > 4.0 * std) < 0.01


@pytest.mark.parametrize("digits", [4, 6, 9])
def test_rest_before_a_motion_is_not_frozen(digits: int) -> None:
    time = np.arange(1201) / 200.0
    s = np.clip(time - 0.5, 0.0, 5.0)
    swing = np.sin(np.pi * s / 5.0) ** 4 * np.sin(4.0 * s)
    values = np.round(0.02 * swing[:, None] * np.ones(6), digits)
    found, said = read(time, values)
    assert not any("frozen" in text for text in said)
    assert np.abs(found.motion.a[0]).max() < 0.05


def test_rest_is_not_frozen() -> None:
    time = np.arange(800) / 100.0
    s = np.clip(time - 3.0, 0.0, 1.0)[:, None]
    values = np.round(0.05 * (10 * s**3 - 15 * s**4 + 6 * s**5) * np.ones(6), 4)
    _, said = read(time, values)
    assert not any("frozen" in text or "outliers" in text for text in said)


def test_a_gap_is_named_and_errors_at_its_ends_are_within_deviations() -> None:
    one = case(7, samples=(40.0, 60.0))
    time, values, _ = faulty(one, "white", Faults(gap=40, start=1.7e9, jitter=0.3), 7)
    found, said = read(time, values)
    assert text_about(said, "gap from ").endswith("the motion in it is uncertain; add rows, or cut the log")
    off, std = errors(one, found)
    assert np.abs(off / std).max() < 5.0
