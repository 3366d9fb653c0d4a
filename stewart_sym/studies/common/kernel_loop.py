"""Timed calls of kernels: a loop in C over single poses, and batches."""

import ctypes
from collections.abc import Callable, Sequence
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...backend import native
from ...backend.c_kernel import address
from ...dynamics.forces import ForceKernel
from .timing import Task, repeated

Timed = tuple[Task, Callable[[], NDArray[Any]]]
"""Task, and the function that returns its results."""


def loop(
    rows: NDArray[Any],
    function: Any,
    machine: NDArray[Any],
    width: int = 6,
    F: NDArray[Any] | None = None,
    all_columns: bool = False,
) -> Timed:
    """Time a C function that is called for each pose in turn; the task raises ValueError if a call fails.

    ``rows`` are motions, (n, 30), ``machine`` constants or a prepared model, and ``width`` the number of
    results of a pose. ``F`` are actuator forces (N), (n, 6). ``all_columns`` selects the arguments of a
    regressor.
    """
    source = (files(__package__) / "kernel_loop.c").read_text(encoding="utf-8")
    drive = native.load("kernel_loop", {"kernel_loop.c": source}).drive
    out, size, pointer = np.zeros((len(rows), width), rows.dtype), ctypes.c_size_t, ctypes.c_void_p

    def run(repeats: int) -> None:
        arrays = [part for each in (rows, F, out) for part in (address(each), size(_row_bytes(each)))]
        counts = size(len(rows)), size(repeats)
        if drive(ctypes.cast(function, pointer), int(all_columns), address(machine), *counts, *arrays):
            raise ValueError("a kernel failed for a pose of the benchmark")

    return Task(run, len(rows)), lambda: out


def _row_bytes(rows: NDArray[Any] | None) -> int:
    return 0 if rows is None else rows.strides[0]


def batch(arrays: Sequence[NDArray[Any]], kernel: ForceKernel, threads: int = 1) -> Timed:
    """Time ``ForceKernel.forces`` with arrays (n, ...) in the order of ``struct stewart_motions``."""
    given, count = [np.ascontiguousarray(array, dtype=kernel.dtype) for array in arrays], len(arrays[0])
    F, status = np.zeros((count, 6), dtype=kernel.dtype), np.zeros(count, dtype=np.int32)
    return Task(repeated(lambda: kernel.forces(given, threads, out=(F, status))), count), lambda: F
