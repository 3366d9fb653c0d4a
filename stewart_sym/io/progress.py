"""Progress of long computations: the current step and, if known, the completed fraction."""

from collections.abc import Callable, Collection, Iterator
from typing import TypeVar

T = TypeVar("T")

Progress = Callable[..., None]
"""Callback ``progress(text, share=None)`` with the current step and the increasing completed fraction."""


def silent(text: str, share: float | None = None) -> None:
    """Show no progress."""


def tracked(progress: Progress, items: Collection[T], text: Callable[[T], str]) -> Iterator[T]:
    """Yield the items of a task, and report the step of each item before it."""
    for number, item in enumerate(items):
        progress(text(item), number / len(items))
        yield item
