"""Parts of a batch of poses on threads. A kernel gives the same bits for any parts."""

import itertools
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache

from ..io.arguments import whole_number

LANES = 8
MIN_POSES_PER_THREAD = 4_000
"""Smallest number of poses per thread.

Waking a thread takes 0.12 ms (2 virtual cores), as long as 1,200 poses.
"""

LARGEST_PART = 32_768
"""Number of poses per call of C if arrays of another type or layout are copied."""

CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
"""Number of cores that this process may use."""


def parts_of(count: int, threads: int, converts: bool = False) -> list[tuple[int, int]]:
    """Return the first pose and the number of poses of each part of a batch; ``converts`` bounds the parts.

    Each thread gets several parts, so that a slow core delays the result little.
    """
    most = max(1, count // MIN_POSES_PER_THREAD)
    threads = min(whole_number(threads, "threads", 1, "a whole number of at least 1"), most)
    if threads == 1 and not converts:
        return [(0, count)] if count else []
    pieces = 1 if threads == 1 else max(threads, min(4 * threads, most))
    poses = max(LANES, -(-count // (pieces * LANES)) * LANES)
    poses = min(poses, LARGEST_PART) if converts else poses
    return [(start, min(poses, count - start)) for start in range(0, count, poses)]


def in_parts(parts: Sequence[tuple[int, int]], threads: int, run: Callable[[int, int], None]) -> None:
    """Run the parts of a batch on threads; ``run`` takes the first pose and the number of poses."""
    others = min(threads, len(parts), CORES) - 1
    if others < 1:
        for part in parts:
            run(*part)
        return
    next_parts = itertools.count()

    def work() -> None:
        while (part := next(next_parts)) < len(parts):
            run(*parts[part])

    waiting = [_pool(others, os.getpid()).submit(work) for _ in range(others)]
    work()
    for other in waiting:
        other.result()


@cache
def _pool(threads: int, process: int) -> ThreadPoolExecutor:
    """Return the waiting threads of a process, because starting threads takes longer than a small batch."""
    return ThreadPoolExecutor(threads, thread_name_prefix="stewart-sym")
