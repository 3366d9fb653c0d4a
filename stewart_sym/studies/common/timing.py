"""Timing of tasks (ns) that alternate, so that disturbances of the machine affect all tasks equally."""

import contextlib
import gc
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

from ...io.progress import Progress

Key = TypeVar("Key")

SHORTEST = 2e-3
"""Shortest duration of one sample (s)."""

ENORMOUS = 10**5
"""Units of work above which a run requires no warm-up, because their data exceed every cache."""


@dataclass(frozen=True, eq=False)
class Task:
    """Timed task: ``run(n)`` does ``units`` of work n times."""

    run: Callable[[int], object]
    units: int


def repeated(call: Callable[[], object]) -> Callable[[int], None]:
    """Return a function that makes a call n times."""

    def run(repeats: int) -> None:
        for _ in range(repeats):
            call()

    return run


def over(call: Callable[..., object], arguments: Iterable[tuple[Any, ...]]) -> Callable[[int], None]:
    """Return a function that makes a call with each of the arguments, n times."""
    every = list(arguments)

    def run(repeats: int) -> None:
        for _ in range(repeats):
            for each in every:
                call(*each)

    return run


def measured(
    tasks: Mapping[Key, Task], rounds: Mapping[Key, int], progress: Progress
) -> dict[Key, tuple[float, ...]]:
    """Measure the time per unit (ns) of every task in every round; each round begins with another task."""
    progress("warming up")
    repeats = {key: _enough(task) for key, task in tasks.items()}
    raw: dict[Key, list[float]] = {key: [] for key in tasks}
    keys, most = list(tasks), max(rounds.values())
    with _no_collection():
        for number in range(most):
            progress(f"round {number + 1} of {most}", number / most)
            first = number % len(keys)
            for key in keys[first:] + keys[:first]:
                if number < rounds[key]:
                    raw[key].append(_sample(tasks[key], repeats, key))
    return {key: tuple(values) for key, values in raw.items()}


def _sample(task: Task, repeats: dict[Key, int], key: Key) -> float:
    """Measure the time per unit (ns) after an untimed run that loads the caches and wakes the threads."""
    if task.units < ENORMOUS:
        task.run(1)
    while True:
        seconds = _seconds(task, repeats[key])
        if seconds >= SHORTEST:
            return 1e9 * seconds / (repeats[key] * task.units)
        repeats[key] *= 2


def _enough(task: Task) -> int:
    """Return the number of repeats that last twice the shortest duration of a sample."""
    repeats = 1
    task.run(1)
    while (seconds := _seconds(task, repeats)) < SHORTEST:
        repeats *= 2
    return max(1, round(repeats * 2 * SHORTEST / seconds))


def _seconds(task: Task, repeats: int) -> float:
    start = time.perf_counter_ns()
    task.run(repeats)
    return 1e-9 * (time.perf_counter_ns() - start)


@contextlib.contextmanager
def _no_collection() -> Iterator[None]:
    was = gc.isenabled()
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        if was:
            gc.enable()


def time_source() -> dict[str, Any]:
    """Describe the time source; raise ValueError if a sample has fewer than 1000 of its steps."""
    info = time.get_clock_info("perf_counter")
    step = min(_step() for _ in range(100))
    if not info.monotonic or step > 1e-3 * SHORTEST:
        raise ValueError(f"the clock is too coarse: steps of {step:.1e} s, samples of {SHORTEST:g} s")
    return {
        "name": "perf_counter",
        "implementation": info.implementation,
        "resolution_s": info.resolution,
        "shortest_step_s": step,
    }


def _step() -> float:
    start = time.perf_counter_ns()
    while (end := time.perf_counter_ns()) == start:
        pass
    return 1e-9 * (end - start)
