"""The terminal: progress, warnings and errors in one line each."""

import contextlib
import os
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from typing import TextIO

PROGRAM = "stewart-sym"


@contextlib.contextmanager
def progress_line() -> Iterator[Callable[[str], None]]:
    """Show what is being done in one line of a terminal, gone at the end; nothing in a pipe."""
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    try:
        yield lambda text: print(f"\r\x1b[K{text} ...", end="", file=sys.stderr, flush=True)
    finally:
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)


def shares(progress: Callable[[str], None], text: str) -> Callable[[float], None]:
    """Show the share of a task that is done, 0 to 1, and the time left at that pace, five times a second."""
    began = shown = time.monotonic()
    progress(text)

    def reached(share: float) -> None:
        nonlocal shown
        now = time.monotonic()
        if share > 0.0 and now - shown >= 0.2:
            shown = now
            left = (now - began) * (1.0 - share) / share
            progress(f"{text}, {100.0 * share:.0f} %, {left:.0f} s left")

    return reached


@contextlib.contextmanager
def warnings_in_lines() -> Iterator[None]:
    """Show the block's warnings at its end, one line each; those of an error come before it."""
    lines: list[str] = []

    def keep(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,
        line: str | None = None,
    ) -> None:
        lines.append(one_line(message))

    with warnings.catch_warnings():
        warnings.showwarning = keep
        try:
            yield
        finally:
            for text in lines:
                print(f"{PROGRAM}: warning: {text}", file=sys.stderr)


def one_line(error: object) -> str:
    """An error or warning in one line."""
    if isinstance(error, MemoryError):
        return f"out of memory: {error}" if str(error) else "out of memory"
    if isinstance(error, OSError) and error.strerror:
        text = error.strerror if error.filename is None else f"{error.filename}: {error.strerror}"
    else:
        text = str(error) or type(error).__name__
    return " ".join(text.split())


def give_up_stdout() -> None:
    """Its reader has gone or its disk is full: the interpreter's own flush at exit must not complain."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
