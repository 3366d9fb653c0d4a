"""Progress, warnings, and errors on the terminal, one line each."""

import contextlib
import math
import os
import shutil
import sys
import time
import warnings
from collections.abc import Iterator

from ..io.arguments import safe_text
from ..io.progress import Progress, silent
from ..studies.common.not_finite import results_noted

PROGRAM = "stewart-sym"

_WIDTH = 24
"""Width of the progress bar (characters)."""
_PAUSE = 0.2
"""Shortest time between two updates of the progress line (s)."""


@contextlib.contextmanager
def progress_line() -> Iterator[Progress]:
    """Show the current step in one line of a terminal, erased at the end; show nothing in a pipe."""
    if not sys.stderr.isatty():
        yield silent
        return
    try:
        yield _Line()
    finally:
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)


class _Line:
    """Progress line with the current step and, for known fractions, a bar and the remaining time."""

    def __init__(self) -> None:
        """Start without a task."""
        self._share: float | None = None
        self._began = self._shown = 0.0

    def __call__(self, text: str, share: float | None = None) -> None:
        """Show a step; a missing fraction, the first one, or a lower one than before starts a new task."""
        now = time.monotonic()
        if share is None or self._share is None or share < self._share:
            self._began, self._shown = now, -math.inf
        self._share = share
        if now - self._shown < _PAUSE:
            return
        self._shown = now
        line = f"{text} ..." if share is None else f"{_bar(share, now - self._began)}  {text}"
        width = shutil.get_terminal_size().columns - 1
        print(f"\r\x1b[K{line[:width]}", end="", file=sys.stderr, flush=True)


def _bar(share: float, passed: float) -> str:
    """Format a bar, the percentage, and the remaining time; ``passed`` is the elapsed time (s)."""
    full = round(_WIDTH * share)
    left = ""
    if share > 0.0:
        minutes, seconds = divmod(round(passed * (1.0 - share) / share), 60)
        left = f", {f'{minutes} min {seconds:02d} s' if minutes else f'{seconds} s'} left"
    return f"[{'#' * full}{' ' * (_WIDTH - full)}] {100.0 * share:3.0f} %{left}"


@contextlib.contextmanager
def warnings_in_lines(*sources: object) -> Iterator[None]:
    """Print the warnings of the block at its end, one line each, before the error message of the block.

    NumPy's overflow warnings are combined into one line that names the inputs ``sources``. This line is
    printed only if a result of the block contains a non-finite number.
    """
    lines: list[str] = []
    overflows: list[str] = []

    def keep(message: Warning | str, category: type[Warning], *_: object, **__: object) -> None:
        of_numpy = category is RuntimeWarning and " encountered in " in str(message)
        (overflows if of_numpy else lines).append(one_line(message))

    with warnings.catch_warnings():
        warnings.showwarning = keep
        try:
            with results_noted() as noted:
                yield
            if overflows and noted:
                place = ", ".join(map(str, sources)) or "inputs"
                lines.append(
                    f"{place}: numbers overflow on the way: do not rely on results that are inf or nan"
                )
        finally:
            for text in lines:
                print(f"{PROGRAM}: warning: {text}", file=sys.stderr)


def one_line(error: object) -> str:
    """Format an error or a warning as one line; system errors without a file name are errors of printing."""
    text = str(error)
    if isinstance(error, MemoryError):
        text = f"out of memory: {error}".removesuffix(": ")
    elif isinstance(error, OSError) and error.strerror:
        text = f"{error.filename or 'standard output'}: {error.strerror}"
    return safe_text(" ".join(text.split())) or type(error).__name__


def give_up_stdout() -> None:
    """Replace standard output by the null device.

    The reader has closed the pipe or the disk is full, and the interpreter flushes the stream again at exit.
    """
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
