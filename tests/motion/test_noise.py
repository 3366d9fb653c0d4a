"""Noise in logs: smoothed motions, the stated deviation of each force, and verdicts that hold."""

import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from command_line import rejects
from log_files import LENGTHS, NAMES, RATES, write
from machines import home_position, machine_size, random_robot
from motion_fields import motion_of
from noisy_logs import WHITE, Array, Case, case, coordinates, from_poses, logged, read
from sweeps import share

import stewart_sym as ss
from stewart_sym.drives.limit_status import EXCEEDED, INCONCLUSIVE_NOISE, limit_status
from stewart_sym.motion import smoothing
from stewart_sym.motion.log_reader import _pose_log, read_csv, read_log
from stewart_sym.motion.trajectory import Log, PoseLog
from stewart_sym.singularities.joint_space import on_platform
from stewart_sym.studies.reports.track import NOISE_THRESHOLD, peak_noise

NOISES = ("3", "4", "5", "white")


@pytest.fixture(scope="module", params=[4, pytest.param(share(200, 10), marks=pytest.mark.slow)])
def sweep(request: pytest.FixtureRequest) -> dict[str, list[tuple[Case, Array, Array]]]:
    """Cases with smoothed forces and their deviations, (n, 6), for each kind of noise."""
    found: dict[str, list[tuple[Case, Array, Array]]] = {noise: [] for noise in NOISES}
    for seed in range(request.param):
        one = case(seed)
        for noise in NOISES:
            trajectory, _ = read(one.time, logged(one, noise, seed))
            F = ss.inverse_dynamics(one.robot, trajectory.motion).F
            found[noise].append((one, F, ss.force_std(one.robot, trajectory)))
    return found


def coverage(runs: list[tuple[Case, Array, Array]], deviations: float) -> float:
    return float(np.mean([np.mean(np.abs(F - one.F) < deviations * sd) for one, F, sd in runs]))


@pytest.mark.parametrize("noise", NOISES)
def test_stated_deviations_cover_the_errors_as_normal_ones(
    sweep: dict[str, list[tuple[Case, Array, Array]]], noise: str
) -> None:
    slack = 0.05 if len(sweep[noise]) >= 20 else 0.1
    assert coverage(sweep[noise], 1.0) == pytest.approx(0.6827, abs=slack)
    assert coverage(sweep[noise], 1.96) == pytest.approx(0.95, abs=slack)


def test_peaks_without_a_warning_are_within_two_percent_and_verdicts_hold(
    sweep: dict[str, list[tuple[Case, Array, Array]]],
) -> None:
    rng = np.random.default_rng(5)
    decided = {True: 0, False: 0}
    for runs in sweep.values():
        for one, F, sd in runs:
            true, peak = np.abs(one.F).max(axis=0), np.abs(F).max(axis=0)
            sure = peak_noise(F, sd) <= NOISE_THRESHOLD
            assert np.all(np.abs(peak - true)[sure] <= 0.02 * true[sure])
            limit = true * rng.uniform(0.9, 1.1, 6)
            for leg, verdict in enumerate(limit_status(np.abs(F), limit, sd)):
                decided[verdict != INCONCLUSIVE_NOISE] += 1
                if verdict != INCONCLUSIVE_NOISE:
                    assert (verdict == EXCEEDED) == bool(true[leg] > limit[leg]), (leg, verdict)
    assert min(decided.values()) > 0


def test_a_clean_log_is_interpolated_and_has_no_deviations() -> None:
    one = case(0)
    with warnings.catch_warnings(action="error", category=ss.TrajectoryWarning):
        trajectory = from_poses(one.time, one.true[0, :, :3], one.true[0, :, 3:])
    assert trajectory.noise is None
    np.testing.assert_array_equal(trajectory.motion.t, one.true[0, :, :3])
    assert not ss.force_std(one.robot, trajectory).any()


def with_gap(sigma: tuple[float, float], missing: slice, highest: float) -> tuple[ss.Robot, Array, PoseLog]:
    """A robot, a motion up to a frequency, (3, 601, 6) at 200 Hz, and its log, which has a gap."""
    rng, time = np.random.default_rng(4), np.arange(601) / 200.0
    robot = random_robot(rng)
    true = coordinates(rng, machine_size(robot), time, highest)
    true[0, :, :3] += home_position(robot.b, machine_size(robot))
    values = true[0] + np.repeat(sigma, 3) * rng.normal(size=true[0].shape)
    t, theta = np.hsplit(np.delete(values, missing, axis=0), 2)
    written = {"t": [*t.T], "theta": [*theta.T]}
    with warnings.catch_warnings(action="ignore"):
        return robot, true, _pose_log(Log("poses", range(len(t)), np.delete(time, missing), written))


@pytest.mark.parametrize(
    ("sigma", "missing", "highest"),
    [(1e-4, 20, 0.8), (0.0, 60, 2.5)],
)
def test_deviations_hold_what_a_bridge_over_a_gap_leaves_open(
    sigma: float, missing: int, highest: float
) -> None:
    gap = slice(260, 260 + missing)
    robot, true, trajectory = with_gap((sigma, sigma), gap, highest)
    found = ss.resample(trajectory, 200.0)
    F, sd = ss.inverse_dynamics(robot, motion_of(true)).F, ss.force_std(robot, found)
    z = (ss.inverse_dynamics(robot, found.motion).F - F)[gap] / sd[gap]
    assert 0.2 < np.sqrt(np.mean(z**2)) < 2.0
    assert np.abs(z).max() < 6.0
    assert found.noise.replaced[-1].rows == ("the gap before line 260",)


def first_rows(seed: int, count: int) -> Case:
    one = case(seed)
    return Case(one.robot, one.time[:count], one.true[:, :count], one.F[:count])


@pytest.mark.slow
@pytest.mark.parametrize("count", [12, 39])
def test_noise_of_few_rows_is_found_and_its_deviations_cover_the_errors(count: int) -> None:
    runs, found = [], []
    for seed in range(10):
        one = first_rows(seed, count)
        trajectory, _ = read(one.time, np.round(logged(one, "white", seed), 7))
        F = ss.inverse_dynamics(one.robot, trajectory.motion).F
        runs.append((one, F, ss.force_std(one.robot, trajectory)))
        found.append(trajectory.noise.sigma)
    assert np.median(found) == pytest.approx(WHITE, rel=0.3)
    assert np.mean(np.array(found) > 0.2 * WHITE) > 0.95
    assert coverage(runs, 1.96) > 0.9
    assert coverage(runs, 5.0) > 0.985


@pytest.mark.parametrize(("count", "known"), [(8, None), (8, 1e-4), (12, None)])
def test_too_few_rows_to_look_for_noise_are_named(count: int, known: float | None) -> None:
    one = first_rows(0, count)
    with warnings.catch_warnings(record=True, action="always") as caught:
        from_poses(one.time, *np.hsplit(logged(one, "white", 0), 2), ss.SmoothingOptions(known, known))
    named = [each for each in caught if "8 rows are too few to distinguish noise" in str(each.message)]
    assert len(named) == (count == 8 and known is None)


@pytest.mark.parametrize("even", [True, False])
def test_a_cutoff_halves_the_amplitude_there_without_a_phase(even: bool) -> None:
    rng = np.random.default_rng(2)
    time = np.linspace(0.0, 20.0, 4001) if even else np.sort(rng.uniform(0.0, 20.0, 4001))
    for frequency, gain in ((0.2, 1.0), (2.0, 0.5), (10.0, 0.0)):
        wave = np.exp(2j * np.pi * frequency * time)
        found = ss.smooth_samples(time, np.stack([wave.real, wave.imag], -1), cutoff=2.0).values
        inside = (time > 2.0) & (time < 18.0)
        ratio = np.mean((found @ [1.0, 1.0j] / wave)[inside])
        assert ratio == pytest.approx(gain, abs=0.03)


@pytest.mark.slow
def test_logs_of_any_length_are_smoothed() -> None:
    rng = np.random.default_rng(9)
    for count in (*range(4, 13), 39, 97, 98, 193, 289, 337, 5_000):
        time = 1e-3 * np.arange(count)
        values = np.sin(np.outer(time, [9.0, 7.0])) + 1e-4 * rng.normal(size=(count, 2))
        for cutoff in (None, 20.0):
            found = smoothing.smooth_samples(time, values, 1e-4, cutoff)
            assert (np.abs(found.values - values) < 1e-3).all()
            assert found.covariance[..., 0].min() > 0.0


def test_given_rates_count_as_measured_with_their_own_rounding(tmp_path: Path) -> None:
    one = case(1)
    table = np.round(np.hstack([one.time[:, None], *one.true]), 4)
    trajectory = read_csv(write(tmp_path / "log.csv", [*NAMES, *RATES], table))
    F = ss.inverse_dynamics(one.robot, trajectory.motion).F
    runs = [(one, F, ss.force_std(one.robot, trajectory))]
    assert coverage(runs, 1.0) == pytest.approx(0.68, abs=0.05)


@pytest.mark.slow
def test_deviations_of_leg_lengths_reach_the_forces(tmp_path: Path) -> None:
    runs = []
    for seed in range(4):
        one = case(seed)
        legs = ss.inverse_kinematics(one.robot, motion_of(one.true))
        table = np.round(np.hstack([one.time[:, None], legs.L]), 5)
        path = write(tmp_path / "log.csv", ["time", *LENGTHS], table)
        with pytest.warns(ss.TrajectoryWarning, match="smoothed"):
            log = read_log(path)
        log = log._replace(time=one.time)
        trajectory = on_platform(one.robot, log, (motion_of(one.true).R[0], one.true[0, 0, :3]))
        F = ss.inverse_dynamics(one.robot, trajectory.motion).F
        runs.append((one, F, ss.force_std(one.robot, trajectory)))
    assert coverage(runs, 1.0) == pytest.approx(0.68, abs=0.1)
    assert coverage(runs, 1.96) == pytest.approx(0.95, abs=0.06)


def test_resampling_keeps_the_path_and_its_deviations() -> None:
    one = case(2)
    trajectory, _ = read(one.time, logged(one, "4", 2))
    rate = 3.0 / float(np.median(np.diff(one.time)))
    found = ss.resample(trajectory, rate)
    np.testing.assert_allclose(np.diff(found.time), 1.0 / rate)
    sd = ss.force_std(one.robot, found)[::3]
    count = min(len(sd), len(one.time))
    np.testing.assert_allclose(sd[:count], ss.force_std(one.robot, trajectory)[:count], rtol=1e-3)
    for rate in (0.0, 1e12):
        rejects(r"^rate: expected ", ss.resample, trajectory, rate)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: ss.smooth_samples([0, 1, 1, 2], np.zeros((4, 1))), "time: expected at least 4 increasing"),
        (
            lambda: ss.smooth_samples(np.arange(5.0), np.zeros((4, 1))),
            r"values: expected finite columns \(5, c\)",
        ),
        (
            lambda: ss.smooth_samples(np.arange(5.0), np.full((5, 2), np.pi)),
            "values: column 1 shows no noise",
        ),
        (
            lambda: ss.smooth_samples(np.arange(5.0), np.ones((5, 1)), cutoff=2.0),
            "cutoff: expected a frequency",
        ),
        (lambda: ss.SmoothingOptions(position_std=-1.0), "position_std: expected a number > 0, got -1"),
        (lambda: ss.TrajectoryFormat(length_unit="mile"), 'length_unit: expected "m", "cm", "mm" or "in"'),
    ],
)
def test_bad_arguments_are_named(call: Callable[[], object], text: str) -> None:
    rejects(f"^{text}", call)
