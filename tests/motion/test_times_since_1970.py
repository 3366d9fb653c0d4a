"""Logs with times since 1970: the same forces and deviations as with times from 0, whatever the unit."""

import warnings
from pathlib import Path

import numpy as np
import pytest
from log_files import LENGTHS, POSE
from machines import home_position, machine_size, random_robot
from motion_fields import motion_of
from noisy_logs import WHITE, Array, coordinates

import stewart_sym as ss
from stewart_sym.kinematics.inverse_kinematics import leg_vectors
from stewart_sym.motion.log_reader import read_log, trajectory_from
from stewart_sym.motion.logs import TrajectoryFormat
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
    [("us", 200, "poses", 0.0), ("ms", 1000, "poses", 0.1 * WHITE), ("s", 1000, "lengths", 0.0)],
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


@pytest.mark.parametrize("start", [0.0, 1e3, START + 0.123456])
def test_elapsed_times_are_decimals(start: float) -> None:
    whole = np.cumsum(np.random.default_rng(2).integers(1, 9, 5000))
    written = np.array([float(f"{start + 0.0:.6f}")]) + whole / 1000.0
    if round(start % 1.0, 6) == round(start % 1.0, 3):
        np.testing.assert_array_equal(elapsed(written), (whole - whole[0]) / 1000.0)
        assert lost(written) == 0.0
    np.testing.assert_allclose(elapsed(written), (whole - whole[0]) / 1000.0, rtol=0.0, atol=3e-7)
