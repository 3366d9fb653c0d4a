"""Smoothing of samples: noise, cut-off, interpolation, covariance, given rates, and resampling."""

import numpy as np
import pytest
from command_line import rejects
from noisy_logs import WHITE, Array, Case, case, errors, logged, read

import stewart_sym as ss
from stewart_sym.motion.log_rates import rate_error
from stewart_sym.motion.spline import SmoothCurve, Smoother


def smoothed(time: Array, values: Array, cutoff: float | None = None) -> tuple[Array, list[SmoothCurve]]:
    """Return values, rates, and second rates of smooth columns, and their curves."""
    smoother = Smoother(time, values, cutoff=cutoff)
    curves = smoother.curves(smoother.likeliest())
    return smoother.derivatives(curves), curves


def within(pair: tuple[Array, Array], deviations: float) -> float:
    """Return the fraction of errors within a number of standard deviations."""
    return float(np.mean(np.abs(pair[0]) < deviations * pair[1]))


@pytest.mark.parametrize("noise", ["4", "white"])
def test_noise_is_estimated_and_deviations_cover_the_errors_of_forces(noise: str) -> None:
    one = case(1, samples=(30.0, 60.0))
    found, said = read(one.time, logged(one, noise, 1))
    true = WHITE if noise == "white" else 1e-4 / np.sqrt(12.0)
    np.testing.assert_allclose(found.noise.sigma, true, rtol=0.2)
    off = errors(one, found)
    assert within(off, 1.0) == pytest.approx(0.68, abs=0.12)
    assert within(off, 2.0) == pytest.approx(0.95, abs=0.06)
    assert [text.split(" of ")[0] for text in said] == (["noise"] if noise == "white" else [])


def test_a_clean_log_is_interpolated() -> None:
    one = case(0)
    found, said = read(one.time, one.true[0])
    np.testing.assert_allclose(found.motion.t, one.true[0, :, :3], atol=1e-15)
    off, _ = errors(one, found)
    inside = slice(10, -10)
    assert np.abs(off[inside]).max() < 1e-3 * np.abs(one.F).max()
    assert said == []


def test_interpolation_of_all_rows_can_be_requested() -> None:
    one = case(2)
    values = logged(one, "3", 2)
    found, said = read(one.time, values, ss.SmoothingOptions(enabled=False))
    np.testing.assert_allclose(found.coordinates[0], values, atol=1e-15)
    assert found.noise is None
    assert said == []


def test_a_stated_noise_replaces_the_estimate() -> None:
    one = case(1)
    values = logged(one, "white", 1)
    found, _ = read(one.time, values, ss.SmoothingOptions(3.0 * WHITE, 2.0 * WHITE))
    np.testing.assert_allclose(found.noise.sigma, np.repeat([3.0, 2.0], 3) * WHITE)


@pytest.mark.parametrize("factor", [0.01, 100.0])
def test_a_stated_noise_that_contradicts_the_rows_is_named(factor: float) -> None:
    one = case(1)
    _, said = read(one.time, logged(one, "white", 1), ss.SmoothingOptions(factor * WHITE, WHITE))
    assert sum(text.startswith("position_std is ") for text in said) == 1


@pytest.mark.parametrize("even", [True, False])
def test_a_cutoff_halves_the_amplitude_without_a_phase(even: bool) -> None:
    rng = np.random.default_rng(2)
    time = np.linspace(0.0, 20.0, 4001) if even else np.sort(rng.uniform(0.0, 20.0, 4001))
    inside = (time > 2.0) & (time < 18.0)
    for frequency, gain in ((0.2, 1.0), (2.0, 0.5), (10.0, 0.0)):
        wave = np.exp(2j * np.pi * frequency * time)
        found = smoothed(time, np.stack([wave.real, wave.imag], -1), cutoff=2.0)[0][0]
        assert np.mean((found @ [1.0, 1.0j] / wave)[inside]) == pytest.approx(gain, abs=0.03)


def test_columns_with_different_spectra_are_smoothed_each_by_its_own() -> None:
    rng, time = np.random.default_rng(6), np.arange(4000) / 500.0
    rates = 2 * np.pi * np.array([0.1, 8.0])
    found, curves = smoothed(time, np.sin(np.outer(time, rates)) + 1e-3 * rng.normal(size=(4000, 2)))
    off = found[2] + rates**2 * np.sin(np.outer(time, rates))
    std = np.sqrt(np.hstack([curve.covariance(time, [(2, 2)]) for curve in curves]))
    assert np.sqrt(np.mean((off / std) ** 2, axis=0)) == pytest.approx(1.0, abs=0.4)
    assert std[:, 0].mean() < 1e-2 * std[:, 1].mean()


def test_a_move_after_a_long_rest_is_not_smoothed_away() -> None:
    rng, time = np.random.default_rng(7), np.arange(40_000) / 500.0
    s = np.clip((time - 70.0) / 2.0, 0.0, 1.0)
    true = 60.0 * (s - 3.0 * s**2 + 2.0 * s**3) / 4.0
    values = (10 * s**3 - 15 * s**4 + 6 * s**5)[:, None] + 1e-4 * rng.normal(size=(40_000, 1))
    assert np.abs(smoothed(time, values)[0][2, :, 0] - true).max() < 0.1 * np.abs(true).max()


@pytest.mark.parametrize("count", [4, 8, 12, 13, 39, 97, 193])
def test_logs_of_few_rows_are_read(count: int) -> None:
    one = case(3)
    few = Case(one.robot, one.time[:count], one.true[:, :count], one.F[:count])
    found, said = read(few.time, logged(few, "4", 3))
    off, std = errors(few, found)
    assert np.isfinite(off).all()
    assert np.all(std > 0.0)
    assert any("too few for an estimate" in text for text in said) == (count < 12)
    if count < 12:
        assert not any(read(few.time, logged(few, "4", 3), ss.SmoothingOptions(1e-4, 1e-4))[1])


def test_rates_that_contradict_positions_are_found_with_the_unit_of_time() -> None:
    one = case(4)
    assert rate_error(one.time, one.true) == ("", None)
    text, unit = rate_error(1e3 * one.time, one.true)
    assert (text.split(" by ")[0], unit) == ("positions change", "ms")
    wrong = one.true * np.array([1.0, 1.3, 1.0])[:, None, None]
    assert "the integral of rates differs from the positions by" in rate_error(one.time, wrong)[0]


def test_resampling_keeps_the_path_and_its_deviations() -> None:
    one = case(2)
    found, _ = read(one.time, logged(one, "4", 2))
    rate = 3.0 / float(np.median(np.diff(one.time)))
    fine = ss.resample(found, rate)
    np.testing.assert_allclose(np.diff(fine.time), 1.0 / rate)
    np.testing.assert_allclose(fine.motion.t[::3], found.motion.t, atol=1e-12)
    np.testing.assert_allclose(ss.force_std(one.robot, fine)[::3], ss.force_std(one.robot, found), rtol=1e-2)
    for wrong in (0.0, 1e12):
        rejects(r"^rate: expected ", ss.resample, found, wrong)
