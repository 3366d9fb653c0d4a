"""Warnings at the user's line; what is done about unsolvable poses: an error, a warning, NaN or damping."""

import contextlib
import inspect
import warnings
from collections.abc import Callable, Iterator
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

OnFault = Literal["raise", "warn", "nan"]
ON_FAULT = ("raise", "warn", "nan")
OnSingular = Literal["raise", "warn", "nan", "damped"]
ON_SINGULAR = (*ON_FAULT, "damped")
"""The same for solves of H x = c. "damped": where H is singular, damped least squares give forces that hold
a part of the wrench; poses that are unsolvable for other reasons give a warning."""

Index = tuple[int, ...]
_PACKAGE = __name__.partition(".")[0]


class SingularPoseWarning(UserWarning):
    """Some poses have no finite answer; their results are NaN and their status says why."""


@contextlib.contextmanager
def errors_of(where: str) -> Iterator[None]:
    """Let a ValueError of the block begin with where it is, such as ``file: key: ``."""
    try:
        yield
    except ValueError as error:
        raise ValueError(f"{where}{error}") from None


def warn(text: str, category: type[Warning] = UserWarning) -> None:
    """Warn at the line outside this package that has called it, however deep this is."""
    frame, level = inspect.currentframe(), 0
    while frame is not None and frame.f_globals.get("__name__", "").partition(".")[0] == _PACKAGE:
        frame, level = frame.f_back, level + 1
    warnings.warn(text, category, stacklevel=level + 1)


def report(status: NDArray[Any], name: str, reason: Callable[[Index], str], choice: str) -> None:
    """Raise ValueError or warn, as ``choice`` of ON_SINGULAR says, if a status is not 0; "damped" warns.

    name: the argument that has the pose. reason: why the pose at an index is unsolvable.
    """
    if choice == "nan" or not status.any():
        return
    where, others = first(status)
    place = f"{name}[{', '.join(map(str, where))}]" if where else name
    text = f"{place}: {reason(where)}{others}"
    if choice == "raise":
        raise ValueError(text)
    warn(text, SingularPoseWarning)


def first(status: NDArray[Any]) -> tuple[Index, str]:
    """Index of the first status that is not 0, and what to add to its reason about the others."""
    where = tuple(int(i) for i in np.argwhere(status)[0])
    more = int(np.count_nonzero(status)) - 1
    return where, f"; {more} more poses are unsolvable too" if more else ""
