"""The C of the kinematics called from tests."""

import ctypes
import functools

import numpy as np
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.backend import native
from stewart_sym.backend.kernel import robot_numbers
from stewart_sym.calls.c_kernel import address, c_sources

Array = NDArray[np.float64]
AnyArray = NDArray[np.floating]
PRECISIONS = {"double": np.float64, "float": np.float32}


@functools.cache
def library(precision: str = "double") -> ctypes.CDLL:
    flags = ("-DSTEWART_FLOAT",) if precision == "float" else ()
    return native.load("kinematics", c_sources("kinematics"), ("-O0", *flags))


def called(function: str, robot: ss.Robot, precision: str, *rows: AnyArray) -> NDArray[np.int32]:
    """Statuses of a function, called with a row of each array after the other, (n, ...)."""
    call, first = getattr(library(precision), function), numbers_of(robot, precision)
    starts = [(each.ctypes.data, each.strides[0]) for each in rows]
    return np.array(
        [
            call(address(first), *(ctypes.c_void_p(start + i * step) for start, step in starts))
            for i in range(len(rows[0]))
        ],
        dtype=np.int32,
    )


def numbers_of(robot: ss.Robot, precision: str) -> AnyArray:
    return robot_numbers(robot).astype(PRECISIONS[precision])


def poses_of(R: Array, t: Array, precision: str = "double") -> AnyArray:
    """Poses as the numbers of ``stewart_pose``, (n, 12)."""
    parts = [R.reshape(len(R), 9), np.broadcast_to(t, (len(R), 3))]
    return np.ascontiguousarray(np.concatenate(parts, axis=1), dtype=PRECISIONS[precision])


def forward(
    robot: ss.Robot, L: Array, R: Array, t: Array, precision: str = "double"
) -> tuple[AnyArray, AnyArray, NDArray[np.int32]]:
    """R, t and status for lengths (n, 6) from guesses (n, 3, 3) and (n, 3); a guess stays where it fails."""
    guess, asked = poses_of(R, t, precision), np.ascontiguousarray(L, dtype=PRECISIONS[precision])
    pose = guess.copy()
    status = called("stewart_forward_kinematics", robot, precision, asked, pose)
    assert (pose[status != results.OK] == guess[status != results.OK]).all()
    return pose[:, :9].reshape(-1, 3, 3), pose[:, 9:], status


def velocity(
    robot: ss.Robot, R: Array, t: Array, L_dot: Array, precision: str = "double"
) -> tuple[AnyArray, NDArray[np.int32]]:
    """[v; omega], (n, 6), and status; nan where it fails."""
    pose, rates = poses_of(R, t, precision), np.ascontiguousarray(L_dot, dtype=PRECISIONS[precision])
    twist = np.full_like(rates, np.nan)
    found = pose, rates, twist[:, :3], twist[:, 3:]
    status = called("stewart_forward_velocity", robot, precision, *found)
    assert np.isnan(twist[status != results.OK]).all()
    return twist, status


def inverse(robot: ss.Robot, motion: ss.Motion, precision: str) -> tuple[AnyArray, AnyArray]:
    count = motion.shape[0]
    still = np.zeros((count, 12))
    numbers = np.concatenate([motion.R.reshape(count, 9), motion.t, motion.omega, motion.v, still], axis=1)
    data = np.ascontiguousarray(numbers, dtype=PRECISIONS[precision])
    L, L_dot = (np.empty((count, 6), dtype=data.dtype) for _ in range(2))
    assert (called("stewart_inverse_kinematics", robot, precision, data, L, L_dot) == results.OK).all()
    return L, L_dot
