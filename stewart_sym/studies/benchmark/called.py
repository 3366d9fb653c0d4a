"""Baselines that Python calls pose by pose: a call over nothing is timed as well and subtracted."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from ...io.array_types import Array
from ..common.timing import Task
from .samples import Figure


@dataclass(frozen=True, eq=False)
class Part:
    """One loop that is timed: ``run(n)`` does ``units`` calls or solves n times."""

    name: str
    what: str
    run: Callable[[int], object]
    units: int


@dataclass(frozen=True, eq=False)
class Called:
    """A baseline whose time per pose is the sum of its parts less ``empty``; ``F()`` are its forces."""

    name: str
    what: str
    parts: tuple[Part, ...]
    empty: Part
    F: Callable[[], Array]

    def tasks(self) -> dict[str, Task]:
        """What is to be timed, by the names that ``figures`` reads."""
        return {self._task(part): Task(part.run, part.units) for part in (*self.parts, self.empty)}

    def figures(self, raw: Mapping[str, Sequence[float]]) -> tuple[Figure, tuple[Figure, ...]]:
        """Time per pose, made of the parts round by round, and the parts, the last of them subtracted."""
        *added, empty = (raw[name] for name in self.tasks())
        times = tuple(sum(each) - none for *each, none in zip(*added, empty, strict=True))
        parts = tuple(
            Figure(part.name, part.what, "call", 1, tuple(raw[self._task(part)]))
            for part in (*self.parts, self.empty)
        )
        return Figure(self.name, self.what, "call", 1, times), parts

    def _task(self, part: Part) -> str:
        return f"{self.name}, {part.name}"
