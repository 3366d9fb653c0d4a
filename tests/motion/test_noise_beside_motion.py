"""Rows that stand still or are few, and lines beside white noise: named, and held by deviations."""

import numpy as np
import pytest
from noisy_logs import Array, read

from stewart_sym.motion.noise.lines import lines
from stewart_sym.motion.noise.still_rows import still_rows
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
    assert trajectory.noise is not None
    grid, variance = trajectory.noise.grid, trajectory.noise.covariance[:, :3, 5]
    sd = np.sqrt([np.interp(trajectory.time, grid, column) for column in variance.T]).T
    assert trajectory.motion.a is not None
    return np.asarray((trajectory.motion.a - second[:, :3]) / sd)


@pytest.mark.parametrize("rate", [100, 500])
@pytest.mark.parametrize("held", ["exact", "noisy"])
@pytest.mark.parametrize("rest", [0.3, 1.0])
def test_rows_at_rest_tell_nothing_of_the_noise(rate: int, held: str, rest: float) -> None:
    time = np.arange(round((1.0 - rest) * rate), round((3.5 + rest) * rate)) / rate
    true, second = there_and_back(time)
    values = true + SIGMA * np.random.default_rng(rate).normal(size=true.shape)
    for start, end in ((0.0, 1.0), (1.9, 2.6), (3.5, 9.0)):
        still = (time >= start) & (time <= end)
        values[still] = (true if held == "exact" else values)[still][0]
    trajectory, said = read(time, values)
    assert trajectory.noise is not None
    np.testing.assert_allclose(trajectory.noise.sigma, SIGMA, rtol=0.3)
    z = off(trajectory, second)
    assert 0.3 < np.sqrt(np.mean(z**2)) < 1.3
    assert np.abs(z).max() < 6.0
    assert sum("stand still at the same numbers" in line for line in said) == 1
    assert not any("as no motion makes" in line for line in said)


@pytest.mark.parametrize("columns", [[3, 4, 5], [0, 1, 2], [2], [0, 4]])
@pytest.mark.parametrize("rests", [[(1.9, 2.6)], [(3.5, 9.0)], [(0.0, 1.0), (1.9, 2.6), (3.5, 9.0)]])
def test_some_numbers_at_rest_tell_nothing_of_their_noise(
    columns: list[int], rests: list[tuple[float, float]]
) -> None:
    time = np.arange(0.3, 4.5, 0.005)
    true, second = there_and_back(time)
    values = true + SIGMA * np.random.default_rng(len(columns)).normal(size=true.shape)
    for start, end in rests:
        still = (time >= start) & (time <= end)
        values[np.ix_(still, columns)] = values[still][0, columns]
    trajectory, said = read(time, values)
    assert trajectory.noise is not None
    np.testing.assert_allclose(trajectory.noise.sigma, SIGMA, rtol=0.3)
    assert np.abs(off(trajectory, second)).max() < 6.0
    names = ", ".join(f"{'t' if column < 3 else 'theta'}_{'xyz'[column % 3]}" for column in columns)
    assert sum(f" of {names} stand still at the same numbers" in line for line in said) == 1
    assert not any("as no motion makes" in line for line in said)


@pytest.mark.parametrize(("rate", "decimals"), [(200, 4), (1000, 5)])
def test_rounded_rows_and_few_equal_ones_are_not_said_to_stand_still(rate: int, decimals: int) -> None:
    time = np.arange(4 * rate) / rate
    u = np.clip((time - 1.0) / 0.6, 0.0, 1.0) - np.clip((time - 2.6) / 0.5, 0.0, 1.0)
    true = (u**3 * (10.0 - 15.0 * u + 6.0 * u**2))[:, None] * WAYS
    assert not np.any(still_rows(time, np.round(true, decimals), np.full(6, 10.0**-decimals)))
    noisy = true + SIGMA * np.random.default_rng(0).normal(size=true.shape)
    noisy[300:304] = noisy[300]
    assert not np.any(still_rows(time, noisy, np.full(6, 1e-9)))


def test_rows_that_hardly_scatter_beside_noisy_ones_end_in_no_error() -> None:
    time = np.arange(200, 760) / 200.0
    true, _ = there_and_back(time)
    moves = ((time > 1.0) & (time < 1.9)) | ((time > 2.6) & (time < 3.5))
    rng = np.random.default_rng(0)
    noisy = true + SIGMA * np.where(moves, 1.0, 1e-7)[:, None] * rng.normal(size=true.shape)
    trajectory, _ = read(time, noisy)
    assert np.isfinite(np.asarray(trajectory.motion.a)).all()


@pytest.mark.parametrize(("frequency", "amplitude"), [(20.0, 1.5), (33.0, 1.5), (33.0, 50.0), (42.0, 50.0)])
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


@pytest.mark.parametrize("count", [60, 300, 1000])
def test_white_noise_has_no_line(count: int) -> None:
    rng, time = np.random.default_rng(count), np.arange(count) / 100.0
    assert not any(lines(time, rng.normal(size=(count, 6)), np.ones(6)) for _ in range(400))


def test_a_motion_whose_accelerations_jump_has_no_line() -> None:
    time = np.arange(1600) / 400.0
    ramps = np.maximum(time[:, None] - [0.7, 0.825, 1.3, 1.425], 0.0)
    true = (ramps**2 @ np.array([1.0, -1.0, -1.0, 1.0]))[:, None] * np.ones(6)
    for seed in range(5):
        _, said = read(time, true + 5e-5 * np.random.default_rng(seed).normal(size=true.shape))
        assert not any("vibration" in line for line in said)


@pytest.mark.parametrize("share", [0.06, 0.1])
def test_small_noise_beside_a_motion_of_few_rows_a_period_is_found(share: float) -> None:
    """A sinusoid of 5 Hz and 1 mm with noise of 1 um."""
    rate, phase = 5.0 / share, np.array([0.3, 1.0, 2.0, 3.0, 4.0, 5.0])
    time = np.arange(150) / rate
    wave = 1e-3 * np.sin(10.0 * np.pi * time[:, None] + phase)
    values = np.round(wave + 1e-6 * np.random.default_rng(3).normal(size=wave.shape), 9)
    trajectory, _ = read(time, values)
    assert trajectory.noise is not None
    np.testing.assert_allclose(trajectory.noise.sigma, 1e-6, rtol=0.4)
    z = off(trajectory, -((10.0 * np.pi) ** 2) * wave)
    assert np.sqrt(np.mean(z**2)) < 1.4
    assert np.abs(z).max() < 5.0


def sinusoids(per_period: float, frequency: float, start: float) -> tuple[Array, Array, Array]:
    """Times, coordinates and second rates, (n, 6), of eight periods."""
    time = start + np.arange(8.0 * per_period) / per_period / frequency
    w = 2.0 * np.pi * frequency
    values = WAYS * np.sin(w * time[:, None] + [0.3, 1.1, 2.0, 0.5, 0.9, 1.4])
    return time, values, -(w**2) * values


@pytest.mark.parametrize("per_period", [5.0, 6.3, 7.1, 8.0, 9.3, 10.0, 12.0])
@pytest.mark.parametrize("start", [0.0, 0.037, 0.081])
def test_few_rows_a_period_are_named_and_their_errors_held(per_period: float, start: float) -> None:
    time, values, second = sinusoids(per_period, 2.0, start)
    trajectory, said = read(time, values)
    assert sum("rows are too far apart" in line for line in said) == 1, said
    assert trajectory.noise is not None
    noise, off = trajectory.noise, np.abs(trajectory.noise.coordinates[2] - second)
    sd = np.sqrt([np.interp(time, noise.grid, column) for column in noise.covariance[:, :, 5].T]).T
    wrong = off > 0.01 * np.abs(second).max(axis=0)
    assert wrong.any()
    assert np.all(off[wrong] < 3.5 * sd[wrong])


@pytest.mark.parametrize("per_period", [16.0, 30.0, 200.0])
def test_many_rows_a_period_are_not_named(per_period: float) -> None:
    time, values, _ = sinusoids(per_period, 2.0, 0.0)
    trajectory, said = read(time, values)
    assert said == []
    assert trajectory.noise is None


@pytest.mark.parametrize("decimals", [9, 11, 13])
def test_rounding_that_no_acceleration_shows_is_not_smoothed_beside_jumps(decimals: int) -> None:
    """A trapezoid of speed after rest: the rows at rest stay at rest."""
    time = np.arange(100) / 100.0
    u, V = np.clip(time - 0.12, 0.0, 0.76), 1.0 / 0.57
    way = np.where(u < 0.19, u**2 / 0.38, np.where(u < 0.57, u - 0.095, 0.57 - (0.76 - u) ** 2 / 0.38)) * V
    trajectory, _ = read(time, np.round(way[:, None] * WAYS, decimals))
    assert trajectory.motion.a is not None
    rest = np.abs(trajectory.motion.a[:6]).max()
    assert rest < 0.005 * np.abs(trajectory.motion.a).max()
