"""Ending by a signal: Ctrl-C, SIGTERM and SIGHUP undo what has been begun, wherever they arrive."""

import contextlib
import signal
import threading
from collections.abc import Iterator

_SIGNALS = tuple(name for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
_received: list[int] = []
_deferred = False


@contextlib.contextmanager
def as_interrupts() -> Iterator[None]:
    """Let signals that end a run raise KeyboardInterrupt in this block; those that are ignored stay so.

    An error after a signal is that signal: an extension module interrupted while it is imported raises
    ImportError.
    """

    def interrupt(number: int, frame: object) -> None:
        _received.append(number)
        if not _deferred:
            raise KeyboardInterrupt

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    numbers = [getattr(signal, name) for name in _SIGNALS]
    before = {number: signal.getsignal(number) for number in numbers}
    caught = [number for number in numbers if before[number] not in (signal.SIG_IGN, None)]
    _received.clear()
    try:
        for number in caught:
            signal.signal(number, interrupt)
        try:
            yield
        except Exception:
            check()
            raise
        check()
    finally:
        for number in caught:
            signal.signal(number, before[number])


def check() -> None:
    """Raise KeyboardInterrupt if a signal has arrived: libraries swallow exceptions in their callbacks."""
    if _received:
        raise KeyboardInterrupt


def exit_code() -> int:
    """Of a run that KeyboardInterrupt ended, as shells have it: 128 and the number of the first signal."""
    return 128 + (_received[0] if _received else signal.SIGINT)


class deferred:  # noqa: N801 - a context manager
    """Let signals wait in this block, where ``check`` tells of them; ``defer=False``: raise in an inner one.

    So a temporary file is made and taken away as one, wherever a signal arrives. No generator, as one that is
    left in the middle would set things back when it is collected.
    """

    def __init__(self, defer: bool = True) -> None:
        self._defer = defer

    def __enter__(self) -> None:
        """Let signals wait, or raise KeyboardInterrupt if one waits."""
        global _deferred
        self._before = _deferred
        _deferred = self._defer
        if not _deferred:
            check()

    def __exit__(self, *error: object) -> None:
        global _deferred
        _deferred = self._before
