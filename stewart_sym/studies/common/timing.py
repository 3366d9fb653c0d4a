"""Timing of tasks (ns) that alternate, so that disturbances of the machine affect all tasks equally."""

import time
import timeit
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

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


def repeated(call: Callable[[], object]) -> Callable[[int], None]:
    """Return a function that makes a call n times."""
    return over(call, [()])


def over(call: Callable[..., object], arguments: Iterable[tuple[Any, ...]]) -> Callable[[int], None]:
    """Return a function that makes a call with each of the arguments, n times."""
    every = list(arguments)

    def run(repeats: int) -> None:
        for _ in range(repeats):
            for each in every:
                call(*each)

    return run


def measured(tasks: Sequence[Task], rounds: int, progress: Progress) -> dict[Task, tuple[float, ...]]:
    """Measure the time per unit (ns) of every task in every round; each round begins with another task."""
    progress("warming up")
    repeats = {task: _enough(task) for task in tasks}
    raw: dict[Task, list[float]] = {task: [] for task in tasks}
    for number in range(rounds):
        progress(f"round {number + 1} of {rounds}", number / rounds)
        first = number % len(tasks)
        for task in (*tasks[first:], *tasks[:first]):
            raw[task].append(_sample(task, repeats))
    return {task: tuple(values) for task, values in raw.items()}


def _sample(task: Task, repeats: dict[Task, int]) -> float:
    """Measure the time per unit (ns) after an untimed run that loads the caches and wakes the threads."""
    if task.units < ENORMOUS:
        task.run(1)
    while True:
        seconds = _seconds(task, repeats[task])
        if seconds >= SHORTEST:
            return 1e9 * seconds / (repeats[task] * task.units)
        repeats[task] *= 2


def _enough(task: Task) -> int:
    """Return the number of repeats that last twice the shortest duration of a sample."""
    repeats = 1
    task.run(1)
    while (seconds := _seconds(task, repeats)) < SHORTEST:
        repeats *= 2
    return max(1, round(repeats * 2 * SHORTEST / seconds))


def _seconds(task: Task, repeats: int) -> float:
    # timeit suspends the garbage collection.
    return 1e-9 * timeit.timeit(lambda: task.run(repeats), timer=time.perf_counter_ns, number=1)
