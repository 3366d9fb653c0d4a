"""Ending by a signal: Ctrl-C, SIGTERM and SIGHUP undo what has been begun, wherever they arrive."""

import contextlib
import signal
import threading
from collections.abc import Iterator
from typing import NoReturn

_SIGNALS = tuple(name for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
_received: list[int] = []


@contextlib.contextmanager
def as_interrupts() -> Iterator[None]:
    """Let signals that end a run raise KeyboardInterrupt in this block; those that are ignored stay so."""

    def interrupt(number: int, frame: object) -> NoReturn:
        _received.append(number)
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
        yield
        check()
    finally:
        for number in caught:
            signal.signal(number, before[number])


def check() -> None:
    """Raise KeyboardInterrupt if a signal has arrived: libraries swallow exceptions in their callbacks."""
    if _received:
        raise KeyboardInterrupt
