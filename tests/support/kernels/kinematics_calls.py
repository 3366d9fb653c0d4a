"""The C of the kinematics called from tests."""

import ctypes
import functools

import numpy as np
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.backend import native
from stewart_sym.backend.c_kernel import address, c_sources
from stewart_sym.backend.kernel import robot_numbers

Array = NDArray[np.float64]
AnyArray = NDArray[np.floating]
PRECISIONS = {"double": np.float64, "float": np.float32}
DRIVER = """
#include "stewart_kinematics.h"
void forward_all(
    const stewart_robot *robot, size_t count, const stewart_real *L, stewart_pose *pose, int *status)
{
    size_t i;
    for (i = 0; i < count; ++i) {
        status[i] = stewart_forward_kinematics(robot, L + 6 * i, pose + i);
    }
}
void velocity_all(
    const stewart_robot *robot, size_t count, const stewart_pose *pose, const stewart_real *L_dot,
    stewart_real *twist, int *status)
{
    size_t i;
    for (i = 0; i < count; ++i) {
        status[i] = stewart_forward_velocity(
            robot, pose + i, L_dot + 6 * i, twist + 6 * i, twist + 6 * i + 3);
    }
}
void inverse_all(
    const stewart_robot *robot, size_t count, const stewart_motion *motion, stewart_real *L,
    stewart_real *L_dot, int *status)
{
    size_t i;
    for (i = 0; i < count; ++i) {
        status[i] = stewart_inverse_kinematics(robot, motion + i, L + 6 * i, L_dot + 6 * i);
    }
}
"""


@functools.cache
def library(precision: str = "double", steps: int | None = None) -> ctypes.CDLL:
    defines = {"STEWART_FLOAT": 1} if precision == "float" else {}
    if steps is not None:
        defines["STEWART_MAX_STEPS"] = steps
    sources = c_sources("kinematics") | {"driver.c": DRIVER}
    return native.load("kinematics", sources, ("-O0",), defines)


def numbers_of(robot: ss.Robot, precision: str) -> AnyArray:
    return robot_numbers(robot).astype(PRECISIONS[precision])


def poses_of(R: Array, t: Array, precision: str = "double") -> AnyArray:
    """Poses as the numbers of ``stewart_pose``, (n, 12)."""
    parts = [R.reshape(len(R), 9), np.broadcast_to(t, (len(R), 3))]
    return np.ascontiguousarray(np.concatenate(parts, axis=1).astype(PRECISIONS[precision]))


def forward(
    robot: ss.Robot, L: Array, R: Array, t: Array, precision: str = "double", steps: int | None = None
) -> tuple[AnyArray, AnyArray, NDArray[np.int32]]:
    """R, t and status for lengths (n, 6) from guesses (n, 3, 3) and (n, 3); a guess stays where it fails."""
    asked = np.ascontiguousarray(L.astype(PRECISIONS[precision]))
    guess = poses_of(R, t, precision)
    pose, status = guess.copy(), np.full(len(L), -1, dtype=np.int32)
    numbers = numbers_of(robot, precision)
    library(precision, steps).forward_all(
        address(numbers), ctypes.c_size_t(len(L)), address(asked), address(pose), address(status)
    )
    assert (pose[status != results.OK] == guess[status != results.OK]).all()
    return pose[:, :9].reshape(-1, 3, 3), pose[:, 9:], status


def velocity(
    robot: ss.Robot, R: Array, t: Array, L_dot: Array, precision: str = "double"
) -> tuple[AnyArray, NDArray[np.int32]]:
    """[v; omega], (n, 6), and status; nan where it fails."""
    rates = np.ascontiguousarray(L_dot.astype(PRECISIONS[precision]))
    twist, status = np.full_like(rates, np.nan), np.full(len(rates), -1, dtype=np.int32)
    numbers, pose = numbers_of(robot, precision), poses_of(R, t, precision)
    library(precision).velocity_all(
        *map(address, (numbers,)), ctypes.c_size_t(len(rates)), *map(address, (pose, rates, twist, status))
    )
    assert np.isnan(twist[status != results.OK]).all()
    return twist, status


def inverse(robot: ss.Robot, motion: ss.Motion, precision: str) -> tuple[AnyArray, AnyArray]:
    count = motion.shape[0]
    still = np.zeros((count, 12))
    numbers = np.concatenate([motion.R.reshape(count, 9), motion.t, motion.omega, motion.v, still], axis=1)
    data = np.ascontiguousarray(numbers.astype(PRECISIONS[precision]))
    L, L_dot = (np.empty((count, 6), dtype=data.dtype) for _ in range(2))
    status = np.full(count, -1, dtype=np.int32)
    robot_data = numbers_of(robot, precision)
    library(precision).inverse_all(
        address(robot_data), ctypes.c_size_t(count), *map(address, (data, L, L_dot, status))
    )
    assert (status == results.OK).all()
    return L, L_dot
