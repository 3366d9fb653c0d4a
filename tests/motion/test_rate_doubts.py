"""Rates in a log that are of another motion than its poses or lengths are warned of, and no others."""

import re
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from command_line import rejects
from log_files import write
from machines import Array

import stewart_sym as ss
from stewart_sym.motion.log_reader import read_csv, read_log
from stewart_sym.motion.rate_doubts import rate_doubt, rate_doubts
from stewart_sym.motion.rotation import motion_about_axes


def with_rates(time: Array, legs: bool = False) -> tuple[list[str], Array]:
    """Names and a table of a smooth motion with its rates."""
    angle = 2.0 * np.pi * np.outer(time, [0.3, 0.4, 0.5, 0.35, 0.45, 0.25]) + np.arange(6)
    w = 2.0 * np.pi * np.array([0.3, 0.4, 0.5, 0.35, 0.45, 0.25])
    found = 0.03 * np.array([np.sin(angle), w * np.cos(angle), -w * w * np.sin(angle)])
    if legs:
        found[0] += 0.7
        names = [f"{name}_{i}" for name in ("L", "L_dot", "L_ddot") for i in range(1, 7)]
    else:
        groups = (("t", "theta"), ("v", "theta_dot"), ("a", "theta_ddot"))
        names = [f"{name}_{axis}" for group in groups for name in group for axis in "xyz"]
    return ["time", *names], np.column_stack([time, *found])


@pytest.mark.parametrize("legs", [False, True], ids=["poses", "legs"])
@pytest.mark.parametrize(("unit", "words"), [(1e3, "ms"), (1e6, "us"), (1e-3, "are rates in another unit")])
def test_rates_of_another_unit_of_time_are_told(tmp_path: Path, unit: float, words: str, legs: bool) -> None:
    names, table = with_rates(np.linspace(0.0, 2.0, 41), legs)
    table[:, 0] *= unit
    path = write(tmp_path / "odd.csv", names, table)
    said = "odd.csv: coordinates change by .* what their rates say"
    if unit > 1.0:
        rejects(rf"{said}.*; give time_unit={words}", read_log, path)
    with pytest.warns(ss.TrajectoryWarning, match=f"{said}: .*{words}"):
        read_log(path, ss.TrajectoryFormat(time_unit="s"))


@pytest.mark.parametrize("noise", [0.0, 1e-3], ids=["", "noisy"])
@pytest.mark.parametrize(
    ("columns", "change", "words"),
    [
        (slice(7, 13), np.negative, "t_x, .*, theta_z change by -1 times what v_x, .* say: are signs opp"),
        (
            slice(7, 10),
            lambda rates: 3.0 * rates,
            "t_x, t_y, t_z change by 0.33 times what v_x, v_y, v_z say$",
        ),
        (
            slice(7, 10),
            lambda rates: 1.25 * rates,
            "t_x, t_y, t_z change by 0.8 times what v_x, v_y, v_z say$",
        ),
        (slice(7, 10), lambda rates: rates[:, [1, 0, 2]], "t_x, t_y do not change as v_x, v_y say"),
        (
            slice(10, 13),
            np.degrees,
            ".*theta_z change by 0.01[78] times what .*theta_dot_z say: are the latter in deg",
        ),
        (slice(10, 13), lambda rates: 0.0 * rates, ".*theta_z do not change as .*theta_dot_z say"),
        (slice(13, 16), np.negative, "v_x, v_y, v_z change by -1 times what a_x, a_y, a_z say"),
    ],
    ids=["minus", "three times", "by a quarter", "exchanged", "degrees", "none", "accelerations"],
)
def test_rates_of_another_motion_are_warned_of(
    tmp_path: Path, columns: slice, change: Callable[[Array], Array], words: str, noise: float
) -> None:
    names, good = with_rates(np.linspace(0.0, 4.0, 161))
    odd, scatter = good.copy(), noise * np.random.default_rng(1).normal(size=(161, 18))
    odd[:, columns] = change(odd[:, columns])
    for table in (good, odd):
        table[:, 1:] += scatter
    with warnings.catch_warnings(record=True, action="always") as caught:
        read_csv(write(tmp_path / "good.csv", names, good))
        assert not caught
        read_csv(write(tmp_path / "odd.csv", names, odd))
    assert any(re.search(f"odd.csv: {words}", str(each.message)) for each in caught)


def wave(time: Array, frequency: float) -> Array:
    """Values, rates from -1 to 1 and accelerations of a cosine, of rates that stay for 0 Hz, (3, n)."""
    w = 2.0 * np.pi * frequency
    if frequency == 0.0:
        return np.array([time, np.ones_like(time), np.zeros_like(time)])
    return np.array([np.sin(w * time) / w, np.cos(w * time), -w * np.sin(w * time)])


TOLD, NOT_TOLD = (0.23, 0.35, 0.35, 0.35, 0.35, 0.35), (0.12, 0.02, 0.25, 0.25, 0.25, 0.25)


@pytest.mark.parametrize("kind", [3, 6], ids=["poses", "legs"])
@pytest.mark.parametrize("noise", [0.0, 0.01], ids=["", "noisy"])
@pytest.mark.parametrize("sizes", [TOLD, NOT_TOLD], ids=["told", "not told"])
def test_a_wrong_part_of_any_frequency_is_told(sizes: tuple[float, ...], noise: float, kind: int) -> None:
    """Also where it is orthogonal to the motion and accelerations agree with it."""
    time, rng = np.linspace(0.0, 1.0, 201), np.random.default_rng(0)
    names = [[f"{each}_{axis}" for axis in "xyzuvw"] for each in "tva"]
    for frequency, size in zip((0.0, 0.5, 2.0, 3.0, 10.0, 20.0), sizes, strict=True):
        columns = np.repeat(wave(time, 1.0)[..., None], 6, axis=-1)
        columns[1:, :, 2] += size * wave(time, frequency)[1:]
        scatter = noise * np.array([0.02, 1.0, 6.0])
        columns += scatter[:, None, None] * rng.normal(size=columns.shape)
        expected = {0: "t_z do not change as v_z say"} if sizes is TOLD else {}
        assert dict(rate_doubts(time, [*columns], names, kind)) == expected


@pytest.mark.parametrize("noise", [0.0, 1e-3], ids=["", "noisy"])
def test_rates_of_a_column_that_rests_are_compared(noise: float) -> None:
    time = np.linspace(0.0, 1.0, 201)
    names = [[f"{each}_{axis}" for axis in "xyz"] for each in "tv"]
    columns = np.zeros((2, 201, 3))
    columns[..., 0] = wave(time, 1.0)[:2]
    columns += noise * np.random.default_rng(1).normal(size=columns.shape)
    assert not dict(rate_doubts(time, [*columns], names, 3))
    columns[1, :, 1] += 0.1 * wave(time, 3.0)[1]
    assert dict(rate_doubts(time, [*columns], names, 3)) == {0: "t_y do not change as v_y say"}


def faultless(seed: int) -> tuple[Array, Array]:
    """Times and a motion with rates and accelerations, (3, n, 6), as logs have them, but without a fault."""
    rng = np.random.default_rng(seed)
    rows = int(10 ** rng.uniform(1.3, 3.3))
    fastest = 10 ** rng.uniform(-1.0, 1.0)
    time = np.arange(rows) / (fastest * rng.uniform(8.0, 200.0))
    if seed % 3 == 0:
        kept = rng.random(rows) > 0.15
        gap = rows // 2 + np.arange(rows // 8)
        kept[gap], kept[:8] = False, True
        time = time[kept]
    if seed % 7 == 0:
        time += 0.3 * (time[1] - time[0]) * rng.uniform(-1.0, 1.0, len(time))
    columns = np.zeros((3, len(time), 6))
    for column in range(6):
        for frequency in fastest * rng.uniform(0.1, 1.0, 3):
            columns[..., column] += 0.03 * wave(time + rng.uniform(), frequency)
    for numbers in columns:
        if seed % 2 == 0:
            numbers += 10 ** rng.uniform(-4.0, -1.0) * numbers.std() * rng.normal(size=numbers.shape)
        if seed % 5 == 0:
            step = 10 ** np.floor(np.log10(0.03 * numbers.std()))
            numbers[:] = step * np.rint(numbers / step)
    return time, columns


def test_logs_without_a_fault_are_not_warned_of() -> None:
    names = [[f"{each}_{i}" for i in range(6)] for each in "tva"]
    found = {seed: dict(rate_doubts(*faultless(seed), names, (3, 6)[seed % 2])) for seed in range(100)}
    assert not {seed: doubts for seed, doubts in found.items() if doubts}


@pytest.mark.parametrize("rows", [12.5, 25.0])
def test_rates_of_a_fast_motion_that_are_a_row_late_are_told(rows: float) -> None:
    time, turn = np.arange(300) / 100.0, 2.0 * np.pi * 100.0 / rows
    phase, late = (turn * (time - by)[:, None] + np.arange(6) for by in (0.0, 0.01))
    motion = np.sin(phase), turn * np.cos(late), -(turn**2) * np.sin(late)
    names = [[f"{each}_{i}" for i in range(6)] for each in "tva"]
    (first, words), *_ = rate_doubts(time, motion, names)
    assert first == 0
    assert "ms late" in words


@pytest.mark.parametrize("order", ["zyx", "xyz"])
@pytest.mark.parametrize("frame", ["base", "platform"])
def test_an_angular_velocity_in_place_of_rates_of_angles_is_told_from_them(
    tmp_path: Path, frame: str, order: str
) -> None:
    names, table = with_rates(np.linspace(0.0, 4.0, 401))
    angles = slice(4, 7), slice(10, 13), slice(16, 19)
    for columns in angles:
        table[:, columns] *= 5.0
    form = ss.TrajectoryFormat(euler_order=order)
    path = write(tmp_path / "log.csv", names, table)
    with warnings.catch_warnings(action="error"):
        read_csv(path, form)
    R, omega, alpha = motion_about_axes(*(table[:, columns] for columns in angles), order)
    turn = np.eye(3) if frame == "base" else R.swapaxes(-1, -2)
    table[:, 10:13], table[:, 16:19] = ((turn @ each[..., None])[..., 0] for each in (omega, alpha))
    expected = f"log.csv: theta_x to theta_z change as if .* were an angular velocity, {frame} frame: exp"
    with pytest.warns(ss.TrajectoryWarning, match=expected):
        read_csv(write(path, names, table), form)


def test_accelerations_of_none_beside_velocities_are_warned_of(tmp_path: Path) -> None:
    names, table = with_rates(np.linspace(0.0, 4.0, 161))
    table[:, 13:] = 0.0
    with pytest.warns(
        ss.TrajectoryWarning, match=r"v_x, v_y, v_z, .* do not change as a_x, a_y, a_z, .* say"
    ):
        read_csv(write(tmp_path / "odd.csv", names, table))
    table[:, 7:] = 0.0
    with warnings.catch_warnings(action="error"):
        read_csv(write(tmp_path / "rest.csv", names, table))


def test_accelerations_of_a_few_limits_are_not_rounded(tmp_path: Path) -> None:
    names, table = with_rates(np.linspace(0.0, 4.0, 161))
    table[:, 1:] = 0.0
    a = np.where(table[:, 0] < 2.0, 10.0, -10.0)
    table[:, 15] = a
    table[:, 9] = np.concatenate([[0.0], np.cumsum(0.0125 * (a[1:] + a[:-1]))])
    table[:, 3] = np.concatenate([[0.0], np.cumsum(0.0125 * (table[1:, 9] + table[:-1, 9]))])
    noise = read_csv(write(tmp_path / "limits.csv", names, table)).noise
    assert noise is None or noise.covariance[:, :, 5].max() < 1e-6


@pytest.mark.parametrize("lag", [0.02, 0.05])
def test_rates_behind_a_filter_are_said_to_be_late(tmp_path: Path, lag: float) -> None:
    names, table = with_rates(np.arange(0.0, 8.0, 0.01))
    late = 1.0 - np.exp(-0.01 / lag)
    for column in table[:, 7:].T:
        for i in range(1, len(column)):
            column[i] = column[i - 1] + late * (column[i] - column[i - 1])
    with pytest.warns(
        ss.TrajectoryWarning, match=r"v_x, .* say up to .* % other changes .*: are they .* ms late"
    ):
        read_csv(write(tmp_path / "odd.csv", names, table))


def test_a_small_lag_is_none(tmp_path: Path) -> None:
    names, table = with_rates(np.arange(0.0, 8.0, 0.01))
    table[:, 7:] = with_rates(np.arange(0.0, 8.0, 0.01) - 0.005)[1][:, 7:]
    with warnings.catch_warnings(action="error"):
        read_csv(write(tmp_path / "good.csv", names, table))


@pytest.mark.parametrize("seed", range(3))
def test_accelerations_with_ten_times_their_size_of_noise_are_of_the_same_motion(seed: int) -> None:
    time = np.linspace(0.0, 4.0, 401)
    names, table = with_rates(time)
    v, a = table[:, 7:13], table[:, 13:]
    scatter = np.random.default_rng(seed).normal(size=a.shape)
    noisy, turned = a + 10.0 * a.std() * scatter, 0.2 * a.std() * scatter - a
    assert rate_doubt(time, v, noisy, names[7:13], names[13:], 3) is None
    assert "signs opposite" in str(rate_doubt(time, v, turned, names[7:13], names[13:], 3))


@pytest.mark.parametrize("step", [0.05, 1.0, 2.5])
def test_rates_of_sparse_logs_and_of_rest_are_not_warned_of(tmp_path: Path, step: float) -> None:
    names, table = with_rates(np.arange(0.0, 20.0, step))
    still = table.copy()
    still[:, 1:7], still[:, 7:] = still[0, 1:7], 0.0
    with warnings.catch_warnings(action="error"):
        for numbers in (table, still, table[:1]):
            read_csv(write(tmp_path / "good.csv", names, numbers))


def test_a_cutoff_beside_rates_is_said_to_change_nothing(tmp_path: Path) -> None:
    log = write(tmp_path / "rates.csv", *with_rates(np.linspace(0.0, 4.0, 161)))
    expected = "rates.csv: the file has rates, which are taken as they are: the cut-off changes nothing"
    with pytest.warns(ss.TrajectoryWarning, match=expected) as told:
        read_csv(log, smoothing=ss.SmoothingOptions(cutoff_frequency=3.0))
    assert {each.filename for each in told} == {__file__}
