"""Loop in C that calls a function of a kernel for one pose after another."""

import ctypes
from collections.abc import Callable
from importlib.resources import files
from typing import Any

from numpy.typing import NDArray

from ...backend import native
from ...backend.c_kernel import address


def kernel_loop(
    function: Any,
    machine: NDArray[Any],
    motions: NDArray[Any],
    out: NDArray[Any],
    F: NDArray[Any] | None = None,
    all_columns: bool = False,
) -> Callable[[int], None]:
    """Return a function that calls a C function n times for each pose, and raises ValueError if a call fails.

    ``machine`` are constants or a prepared model, ``motions`` and ``out`` rows of inputs and results for n
    poses, and ``F`` actuator forces (N), (n, 6). ``all_columns`` selects the arguments of a regressor.
    """
    source = (files(__package__) / "kernel_loop.c").read_text(encoding="utf-8")
    drive = native.load("kernel_loop", {"kernel_loop.c": source}).drive
    size, count = ctypes.c_size_t, len(motions)
    pointer = ctypes.cast(function, ctypes.c_void_p)

    def row_bytes(rows: NDArray[Any] | None) -> ctypes.c_size_t:
        return size(0 if rows is None else rows.strides[0])

    def run(repeats: int) -> None:
        given = (address(motions), row_bytes(motions), address(F), row_bytes(F), address(out), row_bytes(out))
        if drive(pointer, int(all_columns), address(machine), size(count), size(repeats), *given):
            raise ValueError("a kernel failed for a pose of the benchmark")

    return run
