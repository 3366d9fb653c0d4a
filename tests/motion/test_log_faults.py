"""Logs that are no motion under white noise: bad rows, other noise, rows that were not measured."""

import itertools
import re
from collections.abc import Callable

import numpy as np
import pytest
from machines import Array
from motion_fields import motion_of
from noisy_logs import WHITE, Case, case, coordinates, from_poses, logged, read

import stewart_sym as ss
from stewart_sym.motion.log_faults import faults, plateaus, slower_sampling
from stewart_sym.motion.noise_level import noise_level, rounding_steps

FAULTS = ("repeated", "missing", "step", "spike", "zeros")
OFF = "numbers are off as no motion makes them"
# A step of 16 bits for 2 m.
COUNT = 2.0 / 2**16


def corrupted(kind: str, time: Array, values: Array, i: int) -> tuple[Array, Array]:
    """Times and a log with a fault at sample i."""
    values = values.copy()
    if kind == "missing":
        return time[:-1], np.delete(values, i, axis=0)
    if kind == "repeated":
        values[i] = values[i - 1]
    elif kind == "zeros":
        values[i] = 0.0
    elif kind == "step":
        values[i:, 0] += 50 * WHITE
    else:
        values[i, 0] += 50 * WHITE
    return time, values


def true_forces(one: Case, kind: str, i: int) -> Array:
    """Forces at the poses that a log with a fault holds."""
    return np.delete(one.F, i, axis=0) if kind == "missing" else one.F


@pytest.mark.parametrize(
    ("kind", "noise"),
    [
        *itertools.product(FAULTS, ("clean", "5")),
        *(
            pytest.param(*pair, marks=pytest.mark.slow)
            for pair in (("repeated", "3"), ("missing", "white"), ("step", "white"), ("spike", "3"))
        ),
    ],
)
def test_rows_that_no_motion_makes_are_named_and_forces_hold_within_deviations(kind: str, noise: str) -> None:
    seed = 0
    one = case(seed)
    i = int(np.random.default_rng([seed, 7]).integers(len(one.time) // 4, 3 * len(one.time) // 4))
    values = one.true[0] if noise == "clean" else logged(one, noise, seed)
    found, told = read(*corrupted(kind, one.time, values, i))
    (line,) = (text for text in told if OFF in text)
    rows = [int(row) for row in re.findall(r"line (\d+)", line)]
    assert rows
    assert all(abs(row - i) <= 1 for row in rows), (seed, i, line)
    assert f"({one.time[rows[0]]:.6g} s): t_x by " in line or "theta" in line
    F, true = ss.inverse_dynamics(one.robot, found.motion).F, true_forces(one, kind, i)
    sd, peak = ss.force_std(one.robot, found), np.abs(one.F).max()
    assert np.all(np.abs(F - true) <= 5.0 * sd + 0.01 * peak)
    # A step remains in doubt. Three decimals are smoothed over so long a time that one row has no effect.
    if kind in ("step", "missing") and noise != "3":
        assert sd[i - 1 : i + 2].max() > 0.02 * peak


@pytest.mark.parametrize("noise", ["5", "white"])
@pytest.mark.parametrize("count", [4, 9])
def test_frozen_rows_are_named_and_not_used(noise: str, count: int) -> None:
    seed = 0
    one = case(seed)
    i = len(one.time) // 2
    values = (one.true[0] if noise == "clean" else logged(one, noise, seed)).copy()
    values[i : i + count] = values[i - 1]
    found, told = read(one.time, values)
    (line,) = (line for line in told if "the log is frozen" in line)
    assert line.startswith(f"poses: lines {i} to {i + count - 1} (")
    assert not any(OFF in line or "constant numbers" in line for line in told), told
    F, sd = ss.inverse_dynamics(one.robot, found.motion).F, ss.force_std(one.robot, found)
    peak = np.abs(one.F).max()
    assert np.all(np.abs(F - one.F) <= 5.0 * sd + 0.01 * peak)
    assert np.abs(F - one.F).max() < 0.2 * peak
    (span,) = found.noise.replaced
    assert span.start == one.time[i - 1]
    assert span.end == one.time[i + count]


@pytest.mark.slow
def test_a_rest_is_not_a_frozen_log() -> None:
    """Moves with rests of five rows and more, also with speeds that jump."""
    time = np.arange(0.0, 6.0, 0.01)
    for profile in (
        lambda s: s**3 * (10.0 - 15.0 * s + 6.0 * s**2),
        lambda s: s,
        lambda s: s * s * (3.0 - 2.0 * s),
    ):
        for rest in (0.05, 1.0):
            s = np.clip((time % (1.0 + rest)) / 1.0, 0.0, 1.0)
            path = np.where(time // (1.0 + rest) % 2.0, 1.0 - profile(s), profile(s))
            values = path[:, None] * np.array([0.01, 0.02, 0.03, 0.1, 0.05, 0.2]) + np.eye(6)[2]
            assert not any("frozen" in line for line in read(time, np.round(values, 5))[1]), rest


def test_without_smoothing_bad_rows_are_named_and_left() -> None:
    one = case(0)
    time, values = corrupted("spike", one.time, one.true[0], 99)
    with pytest.warns(ss.TrajectoryWarning, match=r"line 99 \(.* s\): t_x by 0.005 m: left as they are"):
        found = from_poses(time, values[:, :3], values[:, 3:], ss.SmoothingOptions(enabled=False))
    assert found.motion.t[99, 0] == values[99, 0]
    assert found.noise is None


def profiles(seed: int) -> tuple[Array, Array]:
    """Moves from rest to rest whose accelerations jump or rise linearly, rates 50 Hz to 2 kHz, (n, 6)."""
    rng = np.random.default_rng(seed)
    rate = float(rng.choice([50, 100, 200, 500, 1000, 2000]))
    fine = 40
    time = np.arange(0.0, rng.uniform(1.0, 3.0) * min(1.0, 1000.0 / rate), 1.0 / rate)
    finely = np.linspace(time[0], time[-1], fine * (len(time) - 1) + 1)
    columns = []
    for _ in range(6):
        column = np.full(len(time), 0.3)
        for _ in range(int(rng.integers(0, 4))):
            start, span = rng.uniform(0.0, 0.7) * time[-1], rng.uniform(0.1, 0.5) * time[-1]
            s, ramp = (finely - start) / span, float(rng.choice([1e-9, 0.05, 0.2, 0.5]))
            knots = [0.0, ramp / 2, 0.5 - ramp / 2, 0.5 + ramp / 2, 1.0 - ramp / 2, 1.0]
            a = np.interp(s, knots, [0, 1, 1, -1, -1, 0], left=0.0, right=0.0)
            place = np.cumsum(np.cumsum(a))
            column = column + rng.uniform(-0.3, 0.3) * place[::fine] / max(float(place[-1]), 1e-300)
        columns.append(column)
    return time, np.stack(columns, axis=-1)


@pytest.mark.slow
def test_good_logs_are_neither_faulty_nor_correlated() -> None:
    rng = np.random.default_rng(0)
    for seed in range(2):
        one = case(seed)
        for time, true in ((one.time, one.true[0]), profiles(seed)):
            for noise in ("clean", "9", "5", "4", "3", "counts", "white"):
                values = true if noise == "clean" else true + WHITE * rng.normal(size=true.shape)
                values = np.round(true, int(noise)) if noise.isdecimal() else values
                values = COUNT * np.rint(true / COUNT) if noise == "counts" else values
                level = noise_level(time, values)
                assert faults(time, values, level.sigma) == [], (seed, noise)
                assert level.correlation == 1.0, (seed, noise)
                assert slower_sampling(time, values, rounding_steps(values)) is None, (seed, noise)


def correlated(rng: np.random.Generator, shape: tuple[int, ...], share: float) -> Array:
    """Noise of deviation 1 of which each sample keeps a share of the one before."""
    noise = rng.normal(size=shape)
    for i in range(1, len(noise)):
        noise[i] = share * noise[i - 1] + np.sqrt(1.0 - share**2) * noise[i]
    return noise


@pytest.mark.slow
def test_correlated_noise_is_told_and_its_deviations_cover_the_errors() -> None:
    """At 200 rows in the shortest period the noise shows beside the motion."""
    keeps = 0.9
    inside = []
    for seed in range(3):
        rng = np.random.default_rng([seed, 4])
        one = case(seed)
        time = np.arange(0.0, 8.0, 0.005)
        true = coordinates(rng, 0.5, time, 1.0)
        true[0, :, :3] += one.true[0, 0, :3]
        found, told = read(time, true[0] + WHITE * correlated(rng, true[0].shape, keeps))
        assert any("it is correlated" in line for line in told), told
        F, expected = (ss.inverse_dynamics(one.robot, each).F for each in (found.motion, motion_of(true)))
        inside.append(np.mean(np.abs(F - expected) < 1.96 * ss.force_std(one.robot, found)))
    assert np.mean(inside) > 0.88


def held(values: Array, every: int) -> Array:
    return np.repeat(values, every, axis=0)


def interpolated(values: Array, every: int) -> Array:
    at = np.arange(len(values) * every) / every
    return np.stack([np.interp(at, np.arange(len(values)), column) for column in values.T], axis=-1)


@pytest.mark.parametrize("noise", ["4", "white"])
@pytest.mark.parametrize(("fill", "words"), [(held, "held"), (interpolated, "interpolated linearly")])
def test_rows_between_measured_ones_are_told_and_count_for_nothing(
    fill: Callable[[Array, int], Array], words: str, noise: str
) -> None:
    every, inside = 4, []
    for seed in range(2):
        one = case(seed)
        values = fill(logged(one, noise, seed), every)
        time = one.time[0] + np.arange(len(values)) * (one.time[1] - one.time[0]) / every
        found, told = read(time, values)
        assert any(f"{len(time)} rows are {words} between {len(one.time)} " in line for line in told), told
        F, sd = ss.inverse_dynamics(one.robot, found.motion).F, ss.force_std(one.robot, found)
        inside.append(np.mean(np.abs(F[::every] - one.F) < 1.96 * sd[::every]))
    assert 0.88 < np.mean(inside) <= 1.0


def test_a_column_that_is_clipped_is_told_with_its_limits_and_how_long_it_stays() -> None:
    time = np.arange(0.0, 10.0, 0.005)
    values = 0.2 * np.sin(time[:, None] * np.arange(1.0, 2.0, 0.17) + np.arange(6.0))
    values[:, :3] += (0.0, 0.0, 2.0)
    values[:, 3] = np.clip(values[:, 3], -0.13, 0.15)
    # Far from zero as near to it.
    raised = np.clip(values[:, :2] + 1.0, 0.87, None)
    found = plateaus(time, raised, np.full(2, 1e-12))
    assert [(each.column, each.value) for each in found] == [(0, 0.87), (1, 0.87)]
    (line,) = (line for line in read(time, values)[1] if "clipped" in line)
    share = np.mean((values[:, 3] == -0.13) | (values[:, 3] == 0.15))
    assert line.startswith("poses: theta_x gets to -0.13 and 0.15 rad or away at full speed")
    assert f"for {share * time[-1]:.3g} s in all ({100 * share:.2g} % of the rows; first at line " in line


@pytest.mark.parametrize("gap", [False, True])
def test_a_gap_in_time_is_told_with_its_ends_and_its_size(gap: bool) -> None:
    one = case(1)
    step = float(one.time[1] - one.time[0])
    keep = np.ones(len(one.time), dtype=bool)
    keep[60:80] = not gap
    _, told = read(one.time[keep], one.true[0][keep])
    lines = [line for line in told if "bridged" in line]
    ends = f"lines 59 and 60: nothing from {one.time[59]:.6g} s to {one.time[80]:.6g} s, 21 times the usual"
    assert [ends in line for line in lines] == [True] * gap
    assert f"step of {step:.3g} s" in "".join(lines) or not gap
