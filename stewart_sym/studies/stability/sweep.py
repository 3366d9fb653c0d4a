"""Random cases near failure by the million: no wrong answer with status ok, no status on a good pose.

Makes machines, lets ``judge`` make and judge the cases, counts. Knows no equation.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernel import robot_numbers
from ...results import OK, STATUS_TEXT
from ..table import aligned
from .judge import KERNELS, KINDS, judge_random, random_case
from .machines import LEGS, machine_size, random_machine

Array = NDArray[np.float64]

WRONG = 1000.0
"""Rounding units over the problem's own condition number above which an answer is wrong."""
GOOD = {"double": 1e6, "float": 1e3}
"""Condition number below which a pose must get an answer: the largest of the problem's own, the scaled one of
H and that of the legs' frames."""
SIZES, MASSES = (1e-4, 1e3), (1e-6, 1e6)
"""Extremes of a machine's size, m, and mass, kg."""
PER_MACHINE = 500
FLOAT_SHARE = 10
"""Cases in double for one in float."""


@dataclass(frozen=True)
class Case:
    """One case worth showing: numbers of the C structures ``stewart_robot`` and ``stewart_motion``.

    error: in rounding units; condition: the problem's own; distance: from the failure.
    """

    kind: str
    precision: str
    kernel: str
    distance: float
    error: float
    condition: float
    status: int
    robot: Array
    motion: Array

    @property
    def text(self) -> str:
        """One line."""
        return (
            f"{self.kind}, {self.precision}, {self.kernel}: {STATUS_TEXT[self.status]}, error "
            f"{self.error:.3g} units at condition {self.condition:.3g}, distance {self.distance:.3g}"
        )


@dataclass(frozen=True)
class Count:
    """One kernel on one kind of cases.

    cases: how many. answered: with status ok. wrong: of those, how many err by more than ``WRONG`` units
    times the condition number. refused_good: cases with a status, their condition number below ``GOOD``.
    worst: largest error over condition number with status ok, at distance ``where``. lowest: least
    condition number of a case with a status, inf if there is none.
    """

    kind: str
    precision: str
    kernel: str
    cases: int
    answered: int
    wrong: int
    refused_good: int
    worst: float
    where: float
    lowest: float


@dataclass(frozen=True)
class Sweep:
    """All counts, the worst cases of them, and how many were judged in quadruple precision."""

    counts: tuple[Count, ...]
    shown: tuple[Case, ...]
    in_quad: int

    @property
    def cases(self) -> int:
        """Cases in all, each put to every kernel."""
        return sum(count.cases for count in self.counts) // len(KERNELS)

    @property
    def wrong(self) -> int:
        """Wrong answers with status ok."""
        return sum(count.wrong for count in self.counts)

    @property
    def refused_good(self) -> int:
        """Statuses on good poses."""
        return sum(count.refused_good for count in self.counts)


def sweep(
    cases: int,
    seed: int = 0,
    progress: Callable[[str], None] = lambda _: None,
    kinds: tuple[str, ...] = KINDS,
    legs: tuple[str, ...] = LEGS,
) -> Sweep:
    """Judge random cases near failure in double, and a tenth as many in float, in equal parts of each kind.

    kinds: of ``KINDS``; legs: of the machines, of ``LEGS``, in turn.
    Raises ValueError for less than one case of each, native.CompilerError without ``__float128``.
    """
    if cases < len(kinds) * FLOAT_SHARE:
        raise ValueError(f"cases: expected at least {len(kinds) * FLOAT_SHARE}, got {cases}")
    counts: list[Count] = []
    shown: list[Case] = []
    in_quad = 0
    for precision, share in (("double", 1), ("float", FLOAT_SHARE)):
        for kind in kinds:
            progress(f"judging {kind}, {precision}")
            wanted = -(-cases // (share * len(kinds)))
            each = min(PER_MACHINE, max(1, wanted // 20))
            numbers, sizes = _machines(
                np.random.default_rng([seed, KINDS.index(kind)]), -(-wanted // each), legs
            )
            found = judge_random(kind, numbers, sizes, each, seed, precision)
            in_quad += int(found["in_quad"].sum())
            for column, kernel in enumerate(KERNELS):
                count, index = _counted(found, column, kind, precision, kernel)
                counts.append(count)
                if count.wrong or count.refused_good:
                    robot, motion = random_case(kind, numbers, sizes, each, seed, index, precision)
                    shown.append(_case(found[index], column, count, robot, motion))
    return Sweep(tuple(counts), tuple(shown), in_quad)


def condition_of(found: NDArray[Any]) -> Array:
    """The problem's own condition number, never less than the scaled one of H."""
    return np.asarray(np.maximum(np.maximum(found["own"], found["scaled"]), 1.0))


def report(found: Sweep) -> str:
    """The counts as a table, and each case worth showing in a line."""
    rows = [
        (
            f"{count.kind}, {count.precision}, {count.kernel}",
            f"{count.cases}",
            f"{count.answered}",
            f"{count.worst:.3g}",
            f"{count.where:.1e}",
            f"{count.wrong}",
            f"{count.lowest:.1e}",
            f"{count.refused_good}",
        )
        for count in found.counts
    ]
    header = ("near failure", "cases", "ok", "worst", "at distance", "wrong", "least refused", "good refused")
    head = (
        f"{found.cases} random cases near failure, each put to {len(KERNELS)} kernels: {found.wrong} wrong "
        f"answers with status ok, {found.refused_good} statuses on good poses.\n"
        f"worst: error in rounding units over the problem's own condition number; wrong: above {WRONG:g}.\n"
        "least refused: least condition number of a case with a status; good: below "
        + ", ".join(f"{limit:.0e} in {precision}" for precision, limit in GOOD.items())
        + f".\n{found.in_quad} doubtful cases were judged again in quadruple precision.\n\n"
    )
    lines = [case.text for case in found.shown]
    return head + aligned(header, rows) + ("\n\n" + "\n".join(lines) if lines else "")


def _machines(rng: np.random.Generator, count: int, every: tuple[str, ...]) -> tuple[Array, Array]:
    """Numbers (count, 205) and sizes (count,), half of one metre's order, half anywhere in the extremes."""
    machines = []
    for number in range(count):
        legs = every[number // 2 % len(every)]
        size, mass = (10.0 ** rng.uniform(*np.log10(extremes)) for extremes in (SIZES, MASSES))
        size, mass = (size, mass) if number % 2 else (1.0, 10.0)
        machines.append(random_machine(rng, size, mass, legs))
    return (
        np.array([robot_numbers(machine) for machine in machines]),
        np.array([machine_size(machine) for machine in machines]),
    )


def _counted(found: NDArray[Any], column: int, kind: str, precision: str, kernel: str) -> tuple[Count, int]:
    """The count, and the index of the case most worth showing."""
    made = found["made"] == 1
    status, condition = found["status"][:, column], condition_of(found)
    answered = made & (status == OK)
    # An answer where there is none is wrong however small.
    ratio = np.where(found["truth"] == OK, found["error"][:, column] / condition, np.inf)
    ratio = np.where(answered, np.where(np.isnan(ratio), np.inf, ratio), -1.0)
    refused = made & (status != OK) & (found["truth"] == OK)
    # At the pole a leg's frame is lost, whether this motion feels it or not.
    of_pose = np.maximum(condition, found["frames"])
    good = refused & (of_pose < GOOD[precision])
    worst = int(np.argmax(ratio))
    count = Count(
        kind,
        precision,
        kernel,
        int(made.sum()),
        int(answered.sum()),
        int(np.sum(ratio > WRONG)),
        int(good.sum()),
        float(ratio[worst]),
        float(found["distance"][worst]),
        float(of_pose[refused].min(initial=np.inf)),
    )
    return count, int(np.flatnonzero(good)[0]) if good.any() and not count.wrong else worst


def _case(found: Any, column: int, count: Count, robot: Array, motion: Array) -> Case:
    return Case(
        count.kind,
        count.precision,
        count.kernel,
        float(found["distance"]),
        float(found["error"][column]),
        float(max(found["own"], found["scaled"])),
        int(found["status"][column]),
        robot,
        motion,
    )
