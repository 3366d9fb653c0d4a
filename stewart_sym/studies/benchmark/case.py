"""Timed code of ``benchmark`` with the results that it must return, and its record."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from ...io.array_types import Array
from ..common.output import Figures
from ..common.timing import Task

FORCES, EQUATIONS, CALLS, SIZES, PASSES = "forces", "equations of motion", "calls", "batch sizes", "passes"
"""Groups of cases, each of which is a table."""

AGREEMENT = 1e-10
"""Largest relative difference between double-precision results, relative to the largest value of a pose."""


@dataclass(frozen=True, eq=False)
class Case:
    """Code that computes a quantity at several poses.

    ``group``, ``name``, and ``what`` are table, row, and description. ``task`` is the timed code, whose unit
    is a pose; the times of ``plus`` and ``minus`` are added and subtracted. ``found`` returns the results of
    a run, (n, k), and ``expected`` are results of the reference at the first poses, (m, j), for the first of
    them, with the largest relative difference ``tolerance``. ``package`` is None for code of stewart-sym.
    """

    group: str
    name: str
    what: str
    task: Task
    found: Callable[[], Array]
    expected: Array
    operations: int | None = None
    tolerance: float = AGREEMENT
    package: str | None = None
    plus: Task | None = None
    minus: Task | None = None

    @property
    def tasks(self) -> list[Task]:
        """Timed tasks."""
        return [task for task in (self.task, self.plus, self.minus) if task is not None]

    def difference(self) -> float:
        """Return the largest difference relative to the largest value of a pose; ValueError if too large."""
        self.task.run(1)
        found, truth = self.found(), self.expected[: self.task.units]
        off = np.abs(found[: len(truth), : truth.shape[1]] - truth).max(axis=-1)
        worst = float(np.max(off / np.abs(truth).max(axis=-1)))
        if not worst <= self.tolerance:
            text = f"results differ from the reference by {worst:.1e}, expected {self.tolerance:g}"
            raise ValueError(f"{self.name}: {text}")
        return worst

    def figure(self, raw: Mapping[Task, tuple[float, ...]], difference: float) -> Figures:
        """Return the record: time per pose (ns) in each round, median, and quartiles."""
        times = np.array(raw[self.task])
        times += 0.0 if self.plus is None else np.array(raw[self.plus])
        times -= 0.0 if self.minus is None else np.array(raw[self.minus])
        low, median, high = np.percentile(times, (25, 50, 75)).tolist()
        named = {name: getattr(self, name) for name in ("group", "name", "what", "package", "operations")}
        measured = {"median": median, "quartiles": [low, high], "raw": times.tolist()}
        return {**named, "poses": self.task.units, **measured, "largest_difference": difference}
