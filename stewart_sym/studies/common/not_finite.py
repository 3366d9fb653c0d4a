"""Record of non-finite numbers in results, set by writers and read by the terminal output."""

import contextlib
import math
from collections.abc import Iterator, Mapping
from contextvars import ContextVar
from typing import Any

import numpy as np

_noted: ContextVar[list[bool] | None] = ContextVar("noted", default=None)


@contextlib.contextmanager
def results_noted() -> Iterator[list[bool]]:
    """Yield a list that becomes nonempty if a writer in the block records a non-finite number."""
    noted: list[bool] = []
    before = _noted.set(noted)
    try:
        yield noted
    finally:
        _noted.reset(before)


def note_not_finite() -> None:
    """Record that a result contains a non-finite number."""
    if (noted := _noted.get()) is not None:
        noted.append(True)


def in_figures(value: Any) -> bool:
    """Return True if data contain a non-finite number, except in limits, which may be infinite."""
    if isinstance(value, Mapping):
        return any(in_figures(each) for key, each in value.items() if "limit" not in str(key))
    if isinstance(value, np.ndarray):
        return value.dtype.kind == "f" and not np.isfinite(value).all()
    if isinstance(value, list | tuple):
        return any(in_figures(each) for each in value)
    return isinstance(value, float | np.floating) and not math.isfinite(value)
