"""The terminal: progress, warnings and errors in one line each."""

import contextlib
import os
import re
import shutil
import sys
import time
import warnings
from collections.abc import Collection, Iterator
from functools import partial

from ..io.arguments import safe_text
from ..io.progress import Progress, silent
from ..studies.common.not_finite import results_noted

PROGRAM = "stewart-sym"

_WIDTH = 24
"""Characters of a bar."""
_PAUSE = 0.2
"""Seconds between two showings of a task."""


@contextlib.contextmanager
def progress_line() -> Iterator[Progress]:
    """Show what is being done in one line of a terminal, gone at the end; nothing in a pipe."""
    if not sys.stderr.isatty():
        yield silent
        return
    try:
        yield _Line()
    finally:
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)


class _Line:
    """Text and, of a task whose share done is known, a bar and the time left at its pace so far."""

    def __init__(self) -> None:
        """Begin without a task."""
        self._share: float | None = None
        self._began = self._shown = 0.0

    def __call__(self, text: str, share: float | None = None) -> None:
        """Show a step; a share that is lower than before, or the first one, begins another task."""
        now = time.monotonic()
        another = share is None or self._share is None or share < self._share
        self._share = share
        if another:
            self._began = now
        elif now - self._shown < _PAUSE:
            return
        self._shown = now
        line = f"{text} ..." if share is None else f"{_bar(share, now - self._began)}  {text}"
        width = shutil.get_terminal_size().columns - 1
        print(f"\r\x1b[K{line[:width]}", end="", file=sys.stderr, flush=True)


def _bar(share: float, passed: float) -> str:
    """A bar, per cent, and the time left; ``passed``: since the share was 0, s."""
    full = round(_WIDTH * share)
    left = "" if share <= 0.0 else f", {_time(passed * (1.0 - share) / share)} left"
    return f"[{'#' * full}{' ' * (_WIDTH - full)}] {100.0 * share:3.0f} %{left}"


def _time(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest:02d} s" if minutes else f"{rest} s"


@contextlib.contextmanager
def warnings_in_lines(*sources: object, options: Collection[str] | None = None) -> Iterator[None]:
    """Show the block's warnings at its end, one line each; those of an error come before it.

    NumPy's warnings of operations that overflow are one line together, of the inputs ``sources``, if a result
    of the block contains a number that is not finite. options: as of ``one_line``.
    """
    lines: list[str] = []
    overflows: list[str] = []

    def keep(message: Warning | str, category: type[Warning], *_: object, **__: object) -> None:
        of_numpy = category is RuntimeWarning and " encountered in " in str(message)
        (overflows if of_numpy else lines).append(one_line(message, options))

    with warnings.catch_warnings():
        warnings.showwarning = keep
        try:
            with results_noted() as noted:
                yield
            if overflows and noted:
                of = ", ".join(map(str, sources))
                text = "numbers overflow on the way: do not rely on results that are inf or nan"
                lines.append(one_line(f"{of}: {text}" if of else text))
        finally:
            for text in lines:
                print(f"{PROGRAM}: warning: {text}", file=sys.stderr)


def one_line(error: object, options: Collection[str] | None = None) -> str:
    """An error or warning in one line; options: of the subcommand, None for those of logs among them."""
    if isinstance(error, MemoryError):
        return f"out of memory: {error}" if str(error) else "out of memory"
    if isinstance(error, OSError) and error.strerror:
        text = error.strerror if error.filename is None else f"{error.filename}: {error.strerror}"
    else:
        text = str(error) or type(error).__name__
    return safe_text(_ARGUMENT.sub(partial(_as_option, options), " ".join(text.split())))


# What the library's messages give as an argument in Python is an option of the same name here.
_ARGUMENT = re.compile(r"TrajectoryFormat\((\w+)=('\w+'|\{[^}]*\})\)")


def _as_option(options: Collection[str] | None, found: re.Match[str]) -> str:
    value = found[2].strip("{}").replace("'", "").replace(": ", "=").replace(", ", ",")
    option = f"--{found[1].replace('_', '-')}"
    if options is None or option in options or not option.endswith("-unit"):
        return f"{option} {value}"
    return f"{value} in a row of units below the header"


def give_up_stdout() -> None:
    """Its reader has gone or its disk is full: the interpreter's own flush at exit must not complain."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
