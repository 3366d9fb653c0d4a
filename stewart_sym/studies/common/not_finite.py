"""Record of numbers that are not finite among results, written by writers and read by the terminal."""

import contextlib
import math
import re
from collections.abc import Iterator, Mapping
from contextvars import ContextVar
from typing import Any

import numpy as np

_TEXT = re.compile(r"(?<![\w.-])[-+]?(nan|inf)(?![\w.-])", re.IGNORECASE)
_noted: ContextVar[list[bool] | None] = ContextVar("noted", default=None)


@contextlib.contextmanager
def results_noted() -> Iterator[list[bool]]:
    """Give a list that is not empty once a writer in the block has noted a number that is not finite."""
    noted: list[bool] = []
    before = _noted.set(noted)
    try:
        yield noted
    finally:
        _noted.reset(before)


def note_not_finite() -> None:
    """Note that a result contains a number that is not finite."""
    if (noted := _noted.get()) is not None:
        noted.append(True)


def in_text(text: str) -> bool:
    """Return True if a text contains nan or inf as a number."""
    return _TEXT.search(text) is not None


def in_figures(value: Any) -> bool:
    """Return True if figures contain a number that is not finite, other than a limit, which may be none."""
    if isinstance(value, Mapping):
        return any(in_figures(each) for key, each in value.items() if "limit" not in str(key))
    if isinstance(value, np.ndarray):
        return value.dtype.kind == "f" and not np.isfinite(value).all()
    if isinstance(value, list | tuple):
        return any(in_figures(each) for each in value)
    return isinstance(value, float | np.floating) and not math.isfinite(value)
