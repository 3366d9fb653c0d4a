"""Noise that is stated: in the units of the log, and compared with what the log shows."""

import warnings
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from log_files import NAMES, write
from noisy_logs import Array, case
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.motion.log_reader import read_csv
from stewart_sym.motion.logs import LogFormat
from stewart_sym.motion.noise.in_log import doubt_of_noise
from stewart_sym.motion.noise_level import decided_noise

FORM = LogFormat(length_unit="mm", angle_unit="deg")


def written(folder: Path, sigma: float, angle: float) -> Path:
    """A log, mm and degrees, with white noise of these deviations."""
    time = np.linspace(0.0, 4.0, 801)
    turns = 2.0 * np.pi * np.outer(time, [0.3, 0.4, 0.5, 0.35, 0.45, 0.25]) + np.arange(6)
    values = ([0.2, 0.0, 0.5, 0, 0, 0] + 0.03 * np.sin(turns)) * np.repeat([1e3, 180.0 / np.pi], 3)
    noise = np.random.default_rng(0).normal(size=values.shape) * np.repeat([sigma, angle], 3)
    return write(folder / "log.csv", NAMES, np.column_stack([time, values + noise]))


def told(log: Path, known: ss.Smoothing, words: str, form: LogFormat = FORM) -> list[str]:
    """Warnings with these words when the log is read with what is known of its noise."""
    with warnings.catch_warnings(record=True, action="always") as caught:
        read_csv(log, form, known)
    return [str(each.message) for each in caught if words in str(each.message)]


@pytest.mark.slow
def test_a_good_statement_of_noise_is_never_doubted() -> None:
    decided = 0
    for seed in range(50):
        one, rng = case(seed), np.random.default_rng([seed, 7])
        sigma = 10.0 ** rng.uniform(-6.0, -2.5)
        step = float(rng.choice([0.0, 0.1, 1.0, 5.0])) * sigma
        values = one.true[0, :, :3] + sigma * rng.normal(size=(len(one.time), 3))
        values = np.round(values / step) * step if step else values
        found = decided_noise(one.time, values, np.full(3, step))
        decided += found > 0.0
        doubts = [doubt_of_noise(k * sigma, one.time, values, np.full(3, step), str) for k in (1.0, 0.5)]
        assert doubts[0] is None
        assert (doubts[1] is not None) == (found > 0.0)
    assert decided > 5


def low_passed(noise: Array, share: float) -> Array:
    out = np.zeros_like(noise)
    for i in range(1, len(noise)):
        out[i] = out[i - 1] + share * (noise[i] - out[i - 1])
    return out


@pytest.mark.parametrize("share", [0.3, 0.1, 0.02])
def test_noise_that_a_filter_cut_off_is_not_compared(share: float) -> None:
    """What differences show of it is a small part of what is stated rightly."""
    rng = np.random.default_rng(1)
    time = np.arange(2000) * 1e-2
    noise = low_passed(low_passed(rng.normal(size=(2000, 3)), share), share)
    assert decided_noise(time, 0.1 * np.sin(time[:, None] + np.arange(3)) + 1e-3 * noise, np.zeros(3)) == 0.0


@pytest.mark.parametrize(
    ("position", "angle", "words"),
    [
        (1e-4, 0.02, "stated noise of positions of 0.0001 mm, but they scatter by 0.1 mm"),
        (100.0, 0.02, "stated noise of positions of 1e+02 mm, but they scatter by 0.1 mm"),
        (0.1, 0.02 * np.pi / 180, "stated noise of angles of 0.00035 deg, but they scatter by 0.02 deg"),
        (0.03, 0.02, "by 0.1 mm: stated too small, it leaves noise in the accelerations"),
        (0.1, 0.02, None),
        (0.08, 0.06, None),
    ],
)
def test_a_statement_far_from_the_scatter_is_a_warning_naming_both(
    tmp_path: Path, position: float, angle: float, words: str | None
) -> None:
    stated = ss.Smoothing(position * 1e-3, np.radians(angle))
    found = told(written(tmp_path, 0.1, 0.02), stated, "stated")
    assert len(found) == (words is not None)
    if words is not None:
        assert words in found[0].replace("0.099", "0.1")


@pytest.mark.parametrize("decimals", [3, None])
def test_a_statement_is_compared_with_the_motion_where_no_scatter_shows(
    tmp_path: Path, decimals: int | None
) -> None:
    time = np.linspace(0.0, 4.0, 401)
    table = np.column_stack([time, [0.2, 0.0, 0.5, 0, 0, 0] + 0.05 * np.sin(time[:, None] + np.arange(6))])
    log = write(tmp_path / "log.csv", NAMES, table if decimals is None else np.round(table, decimals))
    metres = LogFormat()
    words = "stated noise of positions of 0.1 m, but they move over 0.1 m in all: is its unit right?"
    assert words in told(log, ss.Smoothing(0.1), "stated", metres)[0]
    assert not told(log, ss.Smoothing(1e-3, 1e-3), "stated", metres)
    found = told(log, ss.Smoothing(5e-5, 5e-5), "stated", metres)
    if decimals == 3:
        words = "noise of positions of 5e-05 m, but they are rounded to 0.001 m, which alone makes 0.00029 m"
        assert words in found[0]
    assert len(found) == (2 if decimals == 3 else 0)
    with pytest.raises(ValueError, match=r"noise of positions of 1e\+300 m: expected less than 10 m"):
        read_csv(log, metres, ss.Smoothing(1e300))


def test_options_of_noise_are_in_the_units_of_the_log(tmp_path: Path, run: Run) -> None:
    log = written(tmp_path, 0.1, 0.02)
    units = ["--length-unit", "mm", "--angle-unit", "deg"]
    stated = ["--noise-position", "0.1", "--noise-angle", "0.02"]
    told = run("forces", PAPERS, log, "-o", tmp_path / "f.csv", *units, *stated)
    assert "noise of 0.0001 m and 0.00035 rad in the log" in told.err
    assert "stated" not in told.err
    with warnings.catch_warnings(action="ignore"):
        noise = read_csv(log, FORM, ss.Smoothing(1e-4, np.radians(0.02)))
    expected = ss.force_deviations(ss.robots.dasgupta1998(), noise)
    table = np.genfromtxt(tmp_path / "f.csv", delimiter=",", names=True)
    np.testing.assert_allclose(table["F1_sd"], expected[:, 0], rtol=1e-9)


@pytest.mark.parametrize("known", [ss.Smoothing(cutoff=3.0), ss.Smoothing(2e-5, np.radians(0.004))])
def test_no_row_is_wrong_that_is_within_the_scatter(tmp_path: Path, known: ss.Smoothing) -> None:
    """Whatever is stated of the noise, and whatever the cut-off."""
    assert not told(written(tmp_path, 0.1, 0.02), known, "off as no motion makes them")


@pytest.mark.parametrize("sigma", [0.0, 0.1])
def test_a_cutoff_that_removes_motion_is_a_warning(tmp_path: Path, sigma: float) -> None:
    """The fastest motion is of 0.5 Hz."""
    log = written(tmp_path, sigma, 0.2 * sigma)
    words = "the cut-off of 0.3 Hz removes changes of positions of 11 mm and of angles of 0.25 deg: motion"
    assert words in told(log, ss.Smoothing(cutoff=0.3), "cut-off")[0]
    for cutoff in (1.0, 2.0, 10.0, 50.0):
        assert not told(log, ss.Smoothing(cutoff=cutoff), "cut-off")


def test_vibration_may_be_cut_off(tmp_path: Path) -> None:
    log = written(tmp_path, 0.1, 0.02)
    table = np.loadtxt(log, delimiter=",", skiprows=1)
    table[:, 1:4] += np.sin(2.0 * np.pi * 40.0 * table[:, :1])
    write(log, NAMES, table)
    assert not told(log, ss.Smoothing(cutoff=5.0), "cut-off")


def test_a_cutoff_beyond_half_the_rate_is_the_error_alone(tmp_path: Path) -> None:
    log = written(tmp_path, 0.1, 0.02)
    rows = log.read_text().splitlines(keepends=True)
    log.write_text("".join(rows[:300] + rows[340:]))
    words = "cutoff: expected a frequency > 0 and < 100 Hz"
    with warnings.catch_warnings(action="error"), pytest.raises(ValueError, match=words):
        read_csv(log, FORM, ss.Smoothing(1e-6, cutoff=1000.0))


@pytest.mark.parametrize("option", ["--noise-position", "--noise-angle", "--cutoff"])
def test_what_is_known_of_noise_is_not_silently_ignored(tmp_path: Path, run: Run, option: str) -> None:
    log = written(tmp_path, 0.1, 0.02)
    out = ["-o", str(tmp_path / "f.csv"), "--no-smoothing", option, "0.1"]
    told = run("forces", PAPERS, log, *out, code=2).err
    assert told == (f"stewart-sym: error: {option}: is for smoothing, expected no --no-smoothing beside it\n")
