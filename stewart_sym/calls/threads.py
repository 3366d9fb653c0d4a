"""Parts of a batch of poses on threads. A kernel gives the same bits for any parts."""

import os
from collections.abc import Callable
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


def in_parts(count: int, threads: int, run: Callable[[int, int], None], bounded: bool = False) -> None:
    """Run the parts of a batch on threads; ``run`` takes the first pose and the number of poses.

    With ``bounded``, parts have at most LARGEST_PART poses. Each thread gets several parts, so that a slow
    core delays the result little.
    """
    most = max(1, count // MIN_POSES_PER_THREAD)
    threads = min(whole_number(threads, "threads", 1, "a whole number of at least 1"), most)
    pieces = 1 if threads == 1 else max(threads, min(4 * threads, most))
    poses = max(LANES, -(-count // (pieces * LANES)) * LANES)
    poses = min(poses, LARGEST_PART) if bounded else poses
    starts = range(0, count, poses)
    remaining = iter(starts)

    def work() -> None:
        for start in remaining:
            run(start, min(poses, count - start))

    others = min(threads, len(starts), CORES) - 1
    waiting = [_pool(others, os.getpid()).submit(work) for _ in range(others)]
    work()
    for other in waiting:
        other.result()


@cache
def _pool(threads: int, process: int) -> ThreadPoolExecutor:
    """Return the waiting threads of a process, because starting threads takes longer than a small batch."""
    return ThreadPoolExecutor(threads, thread_name_prefix="stewart-sym")
