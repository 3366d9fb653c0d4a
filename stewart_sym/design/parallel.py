"""Execution of independent jobs, in this process or by the workers of a Dask scheduler."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Sequence
from typing import Any, TypeVar

from ..io.arguments import shown
from ..io.error_policy import need
from ..io.progress import Progress, tracked

Job = TypeVar("Job")
Result = TypeVar("Result")

LOCAL = "local"
"""Name of a scheduler that is started locally with one worker per core."""

_WAIT = "5s"


def run(
    jobs: Sequence[Job], work: Callable[[Job], Result], scheduler: str | None, progress: Progress, text: str
) -> list[Result]:
    """Return the results of ``work`` in the order of the jobs; both are pickled for workers.

    ``scheduler`` is None for this process, "local" for one worker per core, or the address of a scheduler.
    """
    if scheduler is None:
        return [work(job) for job in tracked(progress, jobs, lambda _: text)]
    with _client(scheduler) as client:
        from distributed import as_completed

        futures = client.map(work, jobs, pure=False)
        for number, _ in enumerate(as_completed(futures)):
            progress(text, number / len(jobs))
        results: list[Result] = client.gather(futures)
    return results


@contextlib.contextmanager
def _client(scheduler: str) -> Iterator[Any]:
    """Yield a client of the scheduler; close a local scheduler at the end."""
    need("distributed", "a scheduler")
    import dask
    from distributed import Client

    if not isinstance(scheduler, str) or not scheduler.strip():
        raise ValueError(f'scheduler: expected "{LOCAL}" or an address, got {shown(scheduler)}')
    options: dict[str, Any] = {"address": scheduler, "timeout": _WAIT}
    if scheduler == LOCAL:
        options = {"threads_per_worker": 1, "host": "127.0.0.1", "dashboard_address": None}
        # The default port of the dashboard may be in use.
        options["scheduler_kwargs"] = {"dashboard_address": "127.0.0.1:0"}
    with dask.config.set({"distributed.comm.timeouts.connect": _WAIT}):
        try:
            client = Client(**options)
        except (OSError, ValueError) as error:
            raise ValueError(f"scheduler: none answers at {shown(scheduler)}: {error}") from None
    with client:
        yield client
