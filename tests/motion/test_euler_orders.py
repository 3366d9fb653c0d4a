"""Rates of angles in a log are those of its own Euler order."""

import warnings
from pathlib import Path

import numpy as np
import pytest
from log_files import NAMES, RATES, write
from machines import Array
from motion_fields import UNLOADED, motion_of, waves
from plain_logs import read_log

import stewart_sym as ss
from stewart_sym.motion.interpolation import followed
from stewart_sym.motion.rotation import (
    angle_rates,
    angles_from_rotation,
    motion_about_axes,
    quaternion_from_rotation,
    rotation_about_axes,
    rotation_from_rpy,
    rpy_from_rotation,
)
from stewart_sym.motion.trajectory_format import EULER_ORDERS


def waving(time: Array) -> Array:
    """Coordinates, rates and second rates, (3, n, 6), of large turns in any order."""
    middle, size = [0.0, 0.0, 0.65, 0.3, -0.2, 0.5], np.array([0.03, 0.04, 0.02, 0.6, 0.7, 0.5])
    return waves(time, middle, size, [2.0, 3.0, 2.5, 1.7, 2.2, 1.3], np.arange(6))


def saved(path: Path, time: Array, found: Array) -> Path:
    return write(path, [*NAMES, *RATES], np.column_stack([time, *found]))


def in_order(motion: ss.Motion, order: str) -> Array:
    """A motion's coordinates with angles of an order, (3, n, 6)."""
    theta = angles_from_rotation(motion.R, order)
    rates = angle_rates(theta, motion.omega, motion.alpha, order)
    places = (motion.t, motion.v, motion.a)
    return np.array([np.hstack(pair) for pair in zip(places, (theta, *rates), strict=True)])


@pytest.mark.parametrize("order", EULER_ORDERS)
def test_angular_velocities_are_those_of_rotations_that_the_log_passes(tmp_path: Path, order: str) -> None:
    time, h = np.linspace(0.0, 3.0, 61), 1e-4
    path = saved(tmp_path / "log.csv", time, waving(time))
    motion = read_log(path, ss.TrajectoryFormat(euler_order=order)).motion
    before, R, after = (rotation_about_axes(waving(time + k * h)[0, :, 3:], order) for k in (-1, 0, 1))
    np.testing.assert_allclose(motion.R, R, atol=1e-14)
    rate, second = (after - before) / (2.0 * h), (after - 2.0 * R + before) / h**2
    spin = rate @ np.swapaxes(R, -1, -2)
    change = second @ np.swapaxes(R, -1, -2) - spin @ spin
    for matrix, vector in ((spin, motion.omega), (change, motion.alpha)):
        off = np.stack([matrix[:, 2, 1], matrix[:, 0, 2], matrix[:, 1, 0]], axis=-1) - vector
        assert np.abs(off).max() < 2e-6


@pytest.mark.parametrize("order", EULER_ORDERS)
def test_one_motion_is_the_same_in_every_order(tmp_path: Path, order: str) -> None:
    time = np.linspace(0.0, 3.0, 61)
    expected = motion_of(waving(time))
    found = in_order(expected, order)
    found[..., 3:] = np.degrees(found[..., 3:])
    form = ss.TrajectoryFormat(euler_order=order, angle_unit="deg")
    motion = read_log(saved(tmp_path / "log.csv", time, found), form).motion
    for name in UNLOADED:
        np.testing.assert_allclose(getattr(motion, name), getattr(expected, name), atol=1e-12)


@pytest.mark.parametrize("pitch", [60.0, 90.0])
@pytest.mark.parametrize("written", ["quaternions", "angles"])
def test_a_platform_with_a_pitched_frame_moves_as_any(tmp_path: Path, written: str, pitch: float) -> None:
    """Roll and yaw are about one axis at a right angle, where their rates have no bounds."""
    time = np.linspace(0.0, 2.0, 401)
    found = waving(time)
    found[:, :, 3:] *= 0.2
    theta, theta_dot, theta_ddot = found[:, :, 3:]
    R, omega, alpha = motion_about_axes(theta, theta_dot, theta_ddot, "zyx")
    R = R @ rotation_from_rpy([0.3, np.radians(pitch), 0.0])
    turned = {
        "quaternions": (["q_w", "q_x", "q_y", "q_z"], quaternion_from_rotation(R)),
        "angles": ([f"theta_{axis}" for axis in "xyz"], rpy_from_rotation(R)),
    }
    names, numbers = turned[written]
    log = write(
        tmp_path / "log.csv",
        ["time", "t_x", "t_y", "t_z", *names],
        np.column_stack([time, found[0, :, :3], numbers]),
    )
    with warnings.catch_warnings():
        # Roll and yaw that jump by half turns are doubted.
        warnings.simplefilter("ignore")
        read = read_log(log)
    between, inner = followed(read), slice(20, -20)
    for i, motion in ((inner, read.at(inner)), (100, between(time[100]))):
        for name, expected, off in (("R", R, 1e-12), ("omega", omega, 1e-8), ("alpha", alpha, 1e-5)):
            np.testing.assert_allclose(getattr(motion, name), expected[i], atol=off, err_msg=name)
