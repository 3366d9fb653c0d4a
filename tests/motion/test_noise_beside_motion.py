"""Rows that stand still or are few, lines beside white noise, noise that is stated: named, and held."""

import warnings
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from log_files import NAMES, write
from noisy_logs import Array, read
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.motion.log_reader import read_csv
from stewart_sym.motion.trajectory import Trajectory

SIGMA = np.repeat([2e-5, 2e-4], 3)
WAYS = np.array([0.01, 0.008, 0.015, 0.1, 0.05, 0.12])


def there_and_back(time: Array) -> Array:
    """Coordinates and second rates, (2, n, 6), of moves from 1 to 1.9 s and back from 2.6 to 3.5 s."""
    rise = np.poly1d([70.0, -315.0, 540.0, -420.0, 126.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    found = np.zeros((2, len(time)))
    for start, sign in ((1.0, 1.0), (2.6, -1.0)):
        u = np.clip((time - start) / 0.9, 0.0, 1.0)
        found += sign * np.array([rise(u), rise.deriv(2)(u) / 0.81])
    return found[..., None] * WAYS


def off(trajectory: Trajectory, second: Array) -> Array:
    """Errors of second rates of the position over their deviations, (n, 3)."""
    grid, variance = trajectory.noise.grid, trajectory.noise.covariance[:, :3, 5]
    sd = np.sqrt([np.interp(trajectory.time, grid, column) for column in variance.T]).T
    return np.asarray((trajectory.motion.a - second[:, :3]) / sd)


RESTS = [(0.0, 1.0), (1.9, 2.6), (3.5, 9.0)]


def read_standing(
    time: Array, seed: int, rests: list[tuple[float, float]], columns: Sequence[int], held: str = "noisy"
) -> tuple[Array, list[str]]:
    """Errors over deviations, and warnings, where columns stand still: the noise of the moves is found."""
    true, second = there_and_back(time)
    values = true + SIGMA * np.random.default_rng(seed).normal(size=true.shape)
    for start, end in rests:
        still = (time >= start) & (time <= end)
        values[np.ix_(still, columns)] = (true if held == "exact" else values)[still][0, columns]
    trajectory, said = read(time, values)
    np.testing.assert_allclose(trajectory.noise.sigma, SIGMA, rtol=0.3)
    z = off(trajectory, second)
    assert np.abs(z).max() < 6.0
    assert not any("as no motion makes" in line for line in said)
    return z, [line for line in said if "constant numbers from" in line]


@pytest.mark.parametrize("held", ["exact", "noisy"])
def test_rows_at_rest_tell_nothing_of_the_noise(held: str) -> None:
    rest = 1.0
    rate = 100
    time = np.arange(round((1.0 - rest) * rate), round((3.5 + rest) * rate)) / rate
    z, said = read_standing(time, rate, RESTS, range(6), held)
    assert 0.3 < np.sqrt(np.mean(z**2)) < 1.3
    assert len(said) == 1


@pytest.mark.parametrize(("frequency", "amplitude"), [(33.0, 1.5), (33.0, 50.0)])
def test_vibration_is_named_and_its_forces_are_in_the_deviations(frequency: float, amplitude: float) -> None:
    """At 100 Hz; amplitude over the deviation of the noise."""
    time = np.arange(450) / 100.0
    true, second = there_and_back(time)
    phase = np.array([0.3, 1.0, 2.0, 3.0, 4.0, 5.0])
    wave = amplitude * SIGMA * np.sin(2.0 * np.pi * frequency * time[:, None] + phase)
    noisy = true + wave + SIGMA * np.random.default_rng(1).normal(size=true.shape)
    trajectory, said = read(time, noisy)
    assert sum(f"vibration of {frequency:.2g}" in line for line in said) == 1
    z = off(trajectory, second - (2.0 * np.pi * frequency) ** 2 * wave)
    assert 0.3 < np.sqrt(np.mean(z[20:-20] ** 2)) < 1.3
    assert np.abs(z).max() < 4.0


def sinusoids(per_period: float, frequency: float, start: float) -> tuple[Array, Array, Array]:
    """Times, coordinates and second rates, (n, 6), of eight periods."""
    time = start + np.arange(8.0 * per_period) / per_period / frequency
    w = 2.0 * np.pi * frequency
    values = WAYS * np.sin(w * time[:, None] + [0.3, 1.1, 2.0, 0.5, 0.9, 1.4])
    return time, values, -(w**2) * values


@pytest.mark.parametrize("per_period", [5.0, 8.0, 12.0])
def test_few_rows_a_period_are_named_and_their_errors_held(per_period: float) -> None:
    start = 0.037
    time, values, second = sinusoids(per_period, 2.0, start)
    trajectory, said = read(time, values)
    assert sum("rows too far apart" in line for line in said) == 1, said
    noise, off = trajectory.noise, np.abs(trajectory.noise.coordinates[2] - second)
    sd = np.sqrt([np.interp(time, noise.grid, column) for column in noise.covariance[:, :, 5].T]).T
    wrong = off > 0.01 * np.abs(second).max(axis=0)
    assert wrong.any()
    assert np.all(off[wrong] < 3.5 * sd[wrong])


@pytest.mark.parametrize("per_period", [16.0, 200.0])
def test_many_rows_a_period_are_not_named(per_period: float) -> None:
    time, values, _ = sinusoids(per_period, 2.0, 0.0)
    trajectory, said = read(time, values)
    assert said == []
    assert trajectory.noise is None


FORM = ss.TrajectoryFormat(length_unit="mm", angle_unit="deg")


def written(folder: Path, sigma: float, angle: float) -> Path:
    """A log, mm and degrees, with white noise of these deviations."""
    time = np.linspace(0.0, 4.0, 801)
    turns = 2.0 * np.pi * np.outer(time, [0.3, 0.4, 0.5, 0.35, 0.45, 0.25]) + np.arange(6)
    values = ([0.2, 0.0, 0.5, 0, 0, 0] + 0.03 * np.sin(turns)) * np.repeat([1e3, 180.0 / np.pi], 3)
    noise = np.random.default_rng(0).normal(size=values.shape) * np.repeat([sigma, angle], 3)
    return write(folder / "log.csv", NAMES, np.column_stack([time, values + noise]))


def told(log: Path, known: ss.SmoothingOptions, words: str, form: ss.TrajectoryFormat = FORM) -> list[str]:
    """Warnings with these words when the log is read with what is known of its noise."""
    with warnings.catch_warnings(record=True, action="always") as caught:
        read_csv(log, form, known)
    return [str(each.message) for each in caught if words in str(each.message)]


@pytest.mark.parametrize(
    ("position", "angle", "words"),
    [
        (1e-4, 0.02, "stated noise of positions of 0.0001 mm, but they scatter by 0.1 mm"),
        (100.0, 0.02, "stated noise of positions of 1e+02 mm, but they scatter by 0.1 mm"),
        (0.1, 0.02 * np.pi / 180, "stated noise of angles of 0.00035 deg, but they scatter by 0.02 deg"),
        (0.1, 0.02, None),
    ],
)
def test_a_statement_far_from_the_scatter_is_a_warning_naming_both(
    tmp_path: Path, position: float, angle: float, words: str | None
) -> None:
    stated = ss.SmoothingOptions(position * 1e-3, np.radians(angle))
    found = told(written(tmp_path, 0.1, 0.02), stated, "stated")
    assert len(found) == (words is not None)
    if words is not None:
        assert words in found[0].replace("0.099", "0.1")


def test_options_of_noise_are_in_the_units_of_the_log(tmp_path: Path, run: Run) -> None:
    log = written(tmp_path, 0.1, 0.02)
    units = ["--length-unit", "mm", "--angle-unit", "deg"]
    stated = ["--position-std", "0.1", "--angle-std", "0.02"]
    told = run("forces", PAPERS, log, "-o", tmp_path / "f.csv", *units, *stated)
    assert "noise of 0.0001 m and 0.00035 rad in the log" in told.err
    assert "stated" not in told.err
    with warnings.catch_warnings(action="ignore"):
        noise = read_csv(log, FORM, ss.SmoothingOptions(1e-4, np.radians(0.02)))
    expected = ss.force_std(ss.robots.dasgupta1998(), noise)
    table = np.genfromtxt(tmp_path / "f.csv", delimiter=",", names=True)
    np.testing.assert_allclose(table["F_1_std"], expected[:, 0], rtol=1e-9)


@pytest.mark.parametrize("sigma", [0.0, 0.1])
def test_a_cutoff_that_removes_motion_is_a_warning(tmp_path: Path, sigma: float) -> None:
    """The fastest motion is of 0.5 Hz."""
    log = written(tmp_path, sigma, 0.2 * sigma)
    words = "the cut-off of 0.3 Hz removes changes of positions of 11 mm and of angles of 0.25 deg: motion"
    assert words in told(log, ss.SmoothingOptions(cutoff_frequency=0.3), "cut-off")[0]
    for cutoff in (1.0, 2.0, 10.0, 50.0):
        assert not told(log, ss.SmoothingOptions(cutoff_frequency=cutoff), "cut-off")


def test_a_cutoff_beyond_half_the_rate_is_the_error_alone(tmp_path: Path) -> None:
    log = written(tmp_path, 0.1, 0.02)
    rows = log.read_text().splitlines(keepends=True)
    log.write_text("".join(rows[:300] + rows[340:]))
    words = "cutoff: expected a frequency > 0 and < 100 Hz"
    with warnings.catch_warnings(action="error"), pytest.raises(ValueError, match=words):
        read_csv(log, FORM, ss.SmoothingOptions(1e-6, cutoff_frequency=1000.0))


@pytest.mark.parametrize("option", ["--position-std", "--cutoff"])
def test_what_is_known_of_noise_is_not_silently_ignored(tmp_path: Path, run: Run, option: str) -> None:
    log = written(tmp_path, 0.1, 0.02)
    out = ["-o", str(tmp_path / "f.csv"), "--no-smoothing", option, "0.1"]
    told = run("forces", PAPERS, log, *out, code=2).err
    assert told == (f"stewart-sym: error: {option} and --no-smoothing cannot be given together\n")
