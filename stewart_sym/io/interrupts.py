"""Termination by signals: Ctrl-C, SIGTERM, and SIGHUP undo unfinished changes at any time."""

import contextlib
import signal
import threading
from collections.abc import Iterator

_SIGNALS = tuple(name for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
_received: list[int] = []
_deferred = False


@contextlib.contextmanager
def as_interrupts() -> Iterator[None]:
    """Convert terminating signals to KeyboardInterrupt in this block; ignored signals remain ignored.

    An error after a signal is replaced by the interrupt, because an extension module that is interrupted
    during its import raises ImportError.
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
    """Raise KeyboardInterrupt if a signal was received, because libraries suppress exceptions in their
    callbacks.
    """
    if _received:
        raise KeyboardInterrupt


def exit_code() -> int:
    """Return the exit code after KeyboardInterrupt: 128 plus the number of the first signal, as in shells."""
    return 128 + (_received[0] if _received else signal.SIGINT)


class deferred:  # noqa: N801 - a context manager
    """Context manager that delays signals until ``check``; ``defer=False`` raises them in an inner block.

    A temporary file is thus created and removed as one step, whenever a signal is received. This is not a
    generator, because an unfinished generator would restore the state when it is collected.
    """

    def __init__(self, defer: bool = True) -> None:
        self._defer = defer

    def __enter__(self) -> None:
        """Start the delay of signals, or raise KeyboardInterrupt if a signal is pending."""
        global _deferred
        self._before = _deferred
        _deferred = self._defer
        if not _deferred:
            check()

    def __exit__(self, *error: object) -> None:
        global _deferred
        _deferred = self._before
