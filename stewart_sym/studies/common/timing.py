"""Times of tasks (ns) that alternate, so that disturbances of the machine affect all tasks equally."""

import ctypes
import time
import timeit
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...backend import native
from ...calls.c_kernel import address
from ...dynamics.forces import ForceKernel
from ...io.progress import Progress

SHORTEST = 2e-3
"""Shortest duration of one sample (s)."""

ENORMOUS = 10**5
"""Units of work above which a run requires no warm-up, because their data exceed every cache."""


@dataclass(frozen=True, eq=False)
class Task:
    """Timed task: ``run(n)`` does ``units`` of work n times."""

    run: Callable[[int], object]
    units: int


Timed = tuple[Task, Callable[[], NDArray[Any]]]
"""Task, and the function that returns its results."""


def over(call: Callable[..., object], arguments: Iterable[tuple[Any, ...]] = ((),)) -> Callable[[int], None]:
    """Return a function that makes a call with each of the arguments, n times."""
    every = list(arguments)

    def run(repeats: int) -> None:
        for _ in range(repeats):
            for each in every:
                call(*each)

    return run


def loop(
    rows: NDArray[Any],
    function: Any,
    machine: NDArray[Any],
    width: int = 6,
    F: NDArray[Any] | None = None,
    all_columns: bool = False,
) -> Timed:
    """Time a C function that a loop in C calls for each pose; the task raises ValueError if a call fails.

    ``rows`` are motions, (n, 30), ``machine`` constants or a prepared model, and ``width`` the number of
    results of a pose. ``F`` are actuator forces (N), (n, 6). ``all_columns`` selects the arguments of a
    regressor.
    """
    source = (files(__package__) / "kernel_loop.c").read_text(encoding="utf-8")
    drive = native.load("kernel_loop", {"kernel_loop.c": source}).drive
    out, size, pointer = np.zeros((len(rows), width), rows.dtype), ctypes.c_size_t, ctypes.c_void_p

    def run(repeats: int) -> None:
        arrays: list[Any] = []
        for each in (rows, F, out):
            arrays += [address(each), size(0 if each is None else each.strides[0])]
        counts = size(len(rows)), size(repeats)
        if drive(ctypes.cast(function, pointer), int(all_columns), address(machine), *counts, *arrays):
            raise ValueError("a kernel failed for a pose of the benchmark")

    return Task(run, len(rows)), lambda: out


def batch(arrays: Sequence[NDArray[Any]], kernel: ForceKernel, threads: int = 1) -> Timed:
    """Time ``ForceKernel.forces`` with arrays (n, ...) in the order of ``struct stewart_motions``."""
    given, count = [np.ascontiguousarray(array, dtype=kernel.dtype) for array in arrays], len(arrays[0])
    F, status = np.zeros((count, 6), dtype=kernel.dtype), np.zeros(count, dtype=np.int32)
    return Task(over(lambda: kernel.forces(given, threads, out=(F, status))), count), lambda: F


def measured(tasks: Sequence[Task], rounds: int, progress: Progress) -> dict[Task, tuple[float, ...]]:
    """Measure the time per unit (ns) of every task in every round; each round begins with another task."""
    progress("warming up")
    repeats = dict.fromkeys(tasks, 1)
    for task in tasks:
        _sample(task, repeats)
    raw: dict[Task, list[float]] = {task: [] for task in tasks}
    for number in range(rounds):
        progress(f"round {number + 1} of {rounds}", number / rounds)
        first = number % len(tasks)
        for task in (*tasks[first:], *tasks[:first]):
            raw[task].append(_sample(task, repeats))
    return {task: tuple(values) for task, values in raw.items()}


def _sample(task: Task, repeats: dict[Task, int]) -> float:
    """Measure the time per unit (ns) after an untimed run, with twice the repeats if it is too short."""
    if task.units < ENORMOUS:
        task.run(1)
    while True:
        count = repeats[task]
        # timeit suspends the garbage collection.
        ns = timeit.timeit(lambda: task.run(count), timer=time.perf_counter_ns, number=1)  # noqa: B023
        if ns >= 1e9 * SHORTEST:
            return ns / (count * task.units)
        repeats[task] *= 2
