"""Progress, warnings, and errors on the terminal, one line each."""

import contextlib
import math
import os
import re
import shutil
import sys
import time
import warnings
from collections.abc import Iterator

from ..io.arguments import safe_text
from ..io.progress import Progress, silent

PROGRAM = "stewart-sym"

_WIDTH = 24
"""Width of the progress bar (characters)."""
_PAUSE = 0.2
"""Shortest time between two updates of the progress line (s)."""
_NAMED = "length_unit|angle_unit|time_unit|length_mode|pose_mode|position_std|angle_std|drop_lines|row_rate"
"""Parameters that messages name, some of them with a value."""


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

    _share: float | None = None
    _began = _shown = 0.0

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
def warnings_in_lines() -> Iterator[None]:
    """Print the warnings of the block at its end, one line each, before the error message of the block."""
    with warnings.catch_warnings(record=True) as caught:
        # Results show the non-finite numbers.
        warnings.filterwarnings("ignore", ".* encountered in ", RuntimeWarning)
        try:
            yield
        finally:
            for each in caught:
                print(f"{PROGRAM}: warning: {one_line(each.message)}", file=sys.stderr)


def one_line(error: object) -> str:
    """Format an error or a warning as one line; system errors without a file name are errors of printing."""
    text = str(error)
    if isinstance(error, MemoryError):
        text = f"out of memory: {error}".removesuffix(": ")
    elif isinstance(error, OSError) and error.strerror:
        text = f"{error.filename or 'standard output'}: {error.strerror}"
    return safe_text(as_options(" ".join(text.split()))) or type(error).__name__


def as_options(text: str) -> str:
    """Replace parameters by options: those with values, as in ``length_unit=mm``, and all in the remedy."""
    text = re.sub(rf"\b({_NAMED})=(?=\w)", r"--\1 ", text)
    finding, mark, remedy = text.partition("; ")
    remedy = re.sub(rf"(?<!-)\b({_NAMED}|columns (?=\w+=))\b", r"--\1", remedy)
    return re.sub(rf"--({_NAMED})\b", lambda found: found[0].replace("_", "-"), finding + mark + remedy)


def give_up_stdout() -> None:
    """Replace standard output, which failed, by the null device, because it is flushed again at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
