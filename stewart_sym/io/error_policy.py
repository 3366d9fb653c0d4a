"""Warnings at the line of the user, and treatment of unsolvable poses: error, warning, NaN, or damping."""

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
"""Treatments of unsolvable poses for solves of H x = c; "damped" warns of poses without a solution."""

Index = tuple[int, ...]
_PACKAGE = __name__.partition(".")[0]


class SingularPoseWarning(UserWarning):
    """Warning of poses without a finite solution; their results are NaN."""


@contextlib.contextmanager
def errors_of(where: str) -> Iterator[None]:
    """Prefix a ValueError of the block with its location, such as ``file: key: ``."""
    try:
        yield
    except ValueError as error:
        raise ValueError(f"{where}{error}") from None


def warn(text: str, category: type[Warning] = UserWarning) -> None:
    """Warn at the line outside this package that called it, at any depth of the call stack."""
    frame, level = inspect.currentframe(), 0
    while frame is not None and frame.f_globals.get("__name__", "").partition(".")[0] == _PACKAGE:
        frame, level = frame.f_back, level + 1
    warnings.warn(text, category, stacklevel=level + 1)


def report(status: NDArray[Any], name: str, reason: Callable[[Index], str], choice: str) -> None:
    """Raise ValueError or warn if a status is not 0, as ``choice`` of ON_SINGULAR specifies; "damped" warns.

    ``name`` is the argument with the pose, and ``reason`` returns the reason for the pose at an index.
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
    """Return the index of the first status that is not 0, and text about the number of the others."""
    where = tuple(int(i) for i in np.argwhere(status)[0])
    more = int(np.count_nonzero(status)) - 1
    return where, f"; {more} more poses are unsolvable too" if more else ""
