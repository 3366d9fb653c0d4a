"""Logs with times since 1970: the same forces and deviations as with times from 0, whatever the unit."""

import warnings
from pathlib import Path

import numpy as np
import pytest
from log_files import LENGTHS, NAMES, POSE, write
from machines import home_position, machine_size, random_robot
from motion_fields import motion_of
from noisy_logs import WHITE, Array, coordinates

import stewart_sym as ss
from stewart_sym.kinematics.inverse_kinematics import leg_vectors
from stewart_sym.motion.interpolation import followed, interpolate, resample
from stewart_sym.motion.log_reader import read_csv, read_log, trajectory_from
from stewart_sym.motion.logs import TIME_UNITS, TrajectoryFormat
from stewart_sym.motion.sample_times import elapsed, lost
from stewart_sym.motion.trajectory import JointTrajectory, Trajectory
from stewart_sym.singularities.joint_space import on_platform

START = 1_763_876_184
ROBOT = random_robot(np.random.default_rng(3))
# How the times of a row, microseconds, are written in each unit.
TEXTS = {
    "us": "{0}".format,
    "ms": lambda us: str(us // 1000),
    "s": lambda us: f"{us // 10**6}.{us % 10**6:06d}",
}


def values(kind: str, rate: int, noise: float) -> Array:
    """Poses or leg lengths of a smooth motion, (n, 6), with white noise."""
    rng = np.random.default_rng(5)
    size = machine_size(ROBOT)
    q = coordinates(rng, size, np.arange(400) / rate, 1.5)
    q[0, :, :3] += home_position(ROBOT.b, size)
    found = q[0]
    if kind == "lengths":
        poses = motion_of(q)
        found = leg_vectors(ROBOT, poses.R, poses.t)[2]
    return np.asarray(found + noise * rng.normal(size=found.shape))


def read(path: Path, kind: str, rate: int, unit: str, start: int, noise: float = 0.0) -> Trajectory:
    """The log of ``values`` as its file in a unit of time has it, from a whole second on."""
    times = [TEXTS[unit](10**6 * start + 10**6 // rate * i) for i in range(400)]
    header = ",".join(["time", *(POSE if kind == "poses" else LENGTHS)])
    rows = [
        f"{time}," + ",".join(map("{:.15g}".format, row))
        for time, row in zip(times, values(kind, rate, noise).tolist(), strict=True)
    ]
    path.write_text("\n".join([header, *rows]) + "\n")
    with warnings.catch_warnings(action="ignore", category=ss.TrajectoryWarning):
        found = read_log(path, TrajectoryFormat(time_unit=unit))
    np.testing.assert_array_equal(
        found.time, [float(TEXTS["s"](10**6 * start + 10**6 // rate * i)) for i in range(400)]
    )
    return on_platform(ROBOT, found) if isinstance(found, JointTrajectory) else trajectory_from(found)


def forces(trajectory: Trajectory) -> Array:
    return ss.inverse_dynamics(ROBOT, trajectory.motion).F


@pytest.mark.parametrize(
    ("unit", "rate", "kind", "noise"),
    [
        ("us", 200, "poses", 0.0),
        ("us", 1000, "lengths", 0.1 * WHITE),
        ("ms", 200, "lengths", 0.0),
        ("ms", 1000, "poses", 0.1 * WHITE),
        ("s", 200, "poses", 0.1 * WHITE),
        ("s", 1000, "lengths", 0.0),
    ],
)
def test_forces_and_deviations_are_those_of_times_from_0(
    tmp_path: Path, unit: str, rate: int, kind: str, noise: float
) -> None:
    late, early = (read(tmp_path / "log.csv", kind, rate, unit, start, noise) for start in (START, 0))
    F = forces(early)
    np.testing.assert_allclose(forces(late), F, rtol=0.0, atol=1e-6 * np.abs(F).max())
    assert (late.noise is None) == (early.noise is None) == (noise == 0.0)
    if noise:
        sd = ss.force_std(ROBOT, early)
        np.testing.assert_allclose(ss.force_std(ROBOT, late), sd, rtol=1e-4)


@pytest.mark.parametrize("unit", list(TIME_UNITS))
def test_between_instants_the_motion_is_that_of_times_from_0(tmp_path: Path, unit: str) -> None:
    late, early = (read(tmp_path / "log.csv", "poses", 1000, unit, start) for start in (START, 0))
    # A time since 1970 itself is off by a double's resolution, in which a force changes little.
    F = forces(resample(early, 3000.0))
    np.testing.assert_allclose(forces(resample(late, 3000.0)), F, rtol=0.0, atol=1e-5 * np.abs(F).max())
    np.testing.assert_array_equal(interpolate(late)(late.time).t, late.motion.t)
    a, b = (np.asarray(followed(each)(0.12345).a) for each in (late, early))
    np.testing.assert_allclose(a, b, rtol=0.0, atol=1e-9 * np.abs(b).max())


def test_digits_beyond_a_double_count_as_noise(tmp_path: Path) -> None:
    """In a log too short for its scatter to show them; errors of forces are within their deviations."""
    time = np.arange(39) / 1000.0 + 1e-7 * np.random.default_rng(1).integers(0, 300, 39)
    q = coordinates(np.random.default_rng(5), machine_size(ROBOT), time, 1.5)
    q[0, :, :3] += home_position(ROBOT.b, machine_size(ROBOT))
    path = tmp_path / "log.csv"
    rows = (
        f"{START}.{round(1e7 * when):07d}," + ",".join(map("{:.15g}".format, row))
        for when, row in zip(time.tolist(), q[0].tolist(), strict=True)
    )
    path.write_text("\n".join([",".join(["time", *POSE]), *rows]) + "\n")
    with warnings.catch_warnings(action="ignore", category=ss.TrajectoryWarning):
        late = read_csv(path)
    assert (late.noise.sigma > 0.0).all()
    off = np.abs(forces(late) - ss.inverse_dynamics(ROBOT, motion_of(q)).F)
    assert (off < 5.0 * ss.force_std(ROBOT, late)).mean() > 0.99


@pytest.mark.parametrize("start", [0.0, 0.5, 1e3, START, START + 0.123, START + 0.123456])
def test_elapsed_times_are_decimals(start: float) -> None:
    whole = np.cumsum(np.random.default_rng(2).integers(1, 9, 5000))
    written = np.array([float(f"{start + 0.0:.6f}")]) + whole / 1000.0
    if round(start % 1.0, 6) == round(start % 1.0, 3):
        np.testing.assert_array_equal(elapsed(written), (whole - whole[0]) / 1000.0)
        assert lost(written) == 0.0
    np.testing.assert_allclose(elapsed(written), (whole - whole[0]) / 1000.0, rtol=0.0, atol=3e-7)


def test_elapsed_times_of_neighboring_doubles_differ() -> None:
    for start in (1.0, 1e3, float(START)):
        times = np.array([start, np.nextafter(start, np.inf)])
        np.testing.assert_array_equal(elapsed(times), [0.0, np.spacing(start)])
    assert elapsed(np.array([5.0])) == [0.0]
    assert lost(np.array([])) == 0.0


def read_at(folder: Path, written: Array, true: Array) -> tuple[Array, list[str]]:
    """Times of a log that is written at some times of a motion at others, and warnings of them."""
    turns = np.outer(true, 2.0 * np.pi * np.linspace(0.3, 0.8, 6)) + np.arange(6.0)
    poses = 0.05 * np.sin(turns) + 1e-5 * np.random.default_rng(2).normal(size=turns.shape)
    path = write(folder / "log.csv", NAMES, np.column_stack([written, poses]))
    with warnings.catch_warnings(record=True, action="always") as caught:
        found = read_log(path)
    return found.time, [str(each.message) for each in caught if "time: " in str(each.message)]


@pytest.mark.parametrize("rate", [60.0, 75.0, 80.0, 90.0])
def test_times_of_two_clocks_are_those_under_which_numbers_scatter_less(tmp_path: Path, rate: float) -> None:
    """Rounded to 10 ms, or of rows of a clock of 100 Hz of which some are missing as regularly."""
    even = np.arange(300) / rate
    written = np.round(even, 2)
    found, told = read_at(tmp_path, written, even)
    assert len(told) == 1
    assert "rounded to 10 ms: rows are taken every" in told[0]
    np.testing.assert_allclose(found - found[0], even, atol=1e-3)
    found, told = read_at(tmp_path, written, written)
    assert told == []
    assert np.array_equal(found, written)


def test_times_of_two_clocks_that_neither_order_nor_numbers_decide_are_named(tmp_path: Path) -> None:
    times = np.array([0.01 * i for i in range(60) if i not in (12, 28, 44)])
    found, told = read_at(tmp_path, times, np.zeros(len(times)))
    assert len(told) == 1
    assert "time: steps of 10 ms and twice that: rows missing, or rounded from every 10." in told[0]
    assert np.array_equal(found, times)
