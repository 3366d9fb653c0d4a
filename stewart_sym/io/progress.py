"""Progress of long work: what is being done and, where that is known, the share that is done."""

from collections.abc import Callable, Collection, Iterator
from typing import Protocol, TypeVar

T = TypeVar("T")


class Progress(Protocol):
    """Called with what is being done."""

    def __call__(self, text: str, share: float | None = None) -> None:
        """``share``: of a task that is done, 0 to 1, never falling while the task lasts; None: not known."""
        ...


def silent(text: str, share: float | None = None) -> None:
    """Show nothing."""


def tracked(progress: Progress, items: Collection[T], text: Callable[[T], str]) -> Iterator[T]:
    """The items of a task one by one; what is being done with each is shown before it."""
    for number, item in enumerate(items):
        progress(text(item), number / len(items))
        yield item
