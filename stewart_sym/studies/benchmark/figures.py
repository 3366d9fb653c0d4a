"""What ``bench`` measured, as JSON takes it: samples with their medians, ratios, shares with targets."""

import contextlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ...dynamics.inverse import Formulation
from ..common.output import Figures
from ..common.timing import Task

NAME: Formulation = "exact"
"""The kernel that is measured."""

PLAIN, CLOSED = "CasADi", "CasADi, closed form"
"""Other times are divided by these, where CasADi is installed; the closed form is the stricter measure."""

ONE_POSE, BATCH, FLOAT = "one pose", "batch, one core", "batch, float"
COLUMNS = "batch, columns"
"""A batch of arrays with a column for each component."""
INVERSE, EQUATIONS, FORWARD = "inverse dynamics", "equations", "forward dynamics"
DERIVATIVES, REGRESSOR = "derivatives", "regressor"

MOST = {FORWARD: (2.0,), DERIVATIVES: (8.0, 5.0)}
"""Targets: the most that a function may take, in times of inverse dynamics; and the goal beyond."""

TIMES_FASTER = 20.0
"""Target: how many times as fast as the better baseline forward dynamics is to be."""


def batched(name: str) -> str:
    """Name of a function of one pose, called for many."""
    return f"{name}, batch"


def sampled(**fields: Any) -> Figures:
    """The fields with median and quartiles of their samples, ``raw``."""
    low, high = np.percentile(fields["raw"], (25, 75))
    return {**fields, "median": float(np.median(fields["raw"])), "quartiles": (float(low), float(high))}


def figure(
    name: str, what: str, kind: str, poses: int, raw: Sequence[float], operations: int | None = None
) -> Figures:
    """Nanoseconds a pose, one sample of each round; ``operations`` of a pose where counted."""
    return sampled(name=name, what=what, kind=kind, poses=poses, raw=tuple(raw), operations=operations)


def build_of(instructions: str, flags: Sequence[str], bits: int | None) -> Figures:
    """What a figure of compiled C says of it: instructions, and flags after those of every library.

    bits: width of the widest vectors that the code computes with, where that is known.
    """
    width = "" if bits is None else f", {bits} bit" if bits > 64 else ", scalar"
    build = {"instructions": instructions, "flags": tuple(flags), "bits": bits}
    return {**build, "vectors": f"{instructions}{width}"}


Raw = Mapping[Any, tuple[float, ...]]
"""Ns per unit by what is timed, a sample of each round."""


@dataclass(frozen=True, eq=False)
class Timed(Task):
    """What is timed, with what its figure says: ns per pose, or per unit of anything else.

    kind: "one pose", "batch", "call" or "loop". operations: of a pose where counted. build: of C.
    """

    name: str
    what: str
    kind: str = "call"
    operations: int | None = None
    build: Figures = field(default_factory=dict)

    def figure(self, raw: Raw) -> Figures:
        """The figure."""
        poses = self.units if self.kind in ("one pose", "batch") else 1
        return figure(self.name, self.what, self.kind, poses, raw[self], self.operations) | self.build


def limits(operations: int, multiply_add: float) -> dict[str, float]:
    """Least ns for so many operations, by what fills a lane; a division or a root counts as any other.

    multiply_add: ns for one fused multiply-add of one number.
    """
    each = operations * multiply_add
    return {"limit, an operation a lane": each, "limit, all fused in pairs": each / 2}


def named(figures: Iterable[Figures], name: str) -> Figures | None:
    """The figure of that name; None without one."""
    return next((each for each in figures if each["name"] == name), None)


def quickest(figures: Iterable[Figures]) -> Figures | None:
    """The figure with the least median; None without any."""
    return min(figures, key=lambda each: float(each["median"]), default=None)


def builds_of(found: Figures, name: str, instructions: str) -> list[Figures]:
    """A run's builds of that name for these instructions."""
    return [each for each in found["builds"] if (each["name"], each["instructions"]) == (name, instructions)]


def ratios(found: Figures, time: float, instructions: str = "") -> dict[str, float]:
    """A time, ns, over the medians of CasADi's closed form and of its plain C; nothing without CasADi.

    instructions: for which these are compiled; empty for the quickest, which the baselines have.
    """
    of = {}
    for key, name in (("ratio_to_closed_form", CLOSED), ("ratio_to_casadi", PLAIN)):
        if instructions:
            of[key] = quickest(builds_of(found, name, instructions))
        else:
            of[key] = named(found["baselines"], name)
    return {key: time / each["median"] for key, each in of.items() if each is not None}


def with_ratios(found: Figures) -> Figures:
    """A run's times of the forces and of all C, in cycles of its clock as well, and over CasADi's."""

    def entry(figure: Figures, instructions: str = "") -> Figures:
        time = figure["median"]
        return {**figure, "cycles": time / found["cycle"]["median"], **ratios(found, time, instructions)}

    return found | {
        "ours": [entry(each) for each in found["ours"]],
        "baselines": [entry(each) for each in found["baselines"]],
        "builds": [entry(each, each["instructions"]) for each in found["builds"]],
    }


def flatness(sweep: Sequence[Figures]) -> dict[str, float]:
    """By name, the longest time per pose over all batch sizes, divided by the shortest."""
    medians: dict[str, list[float]] = {}
    for each in sweep:
        medians.setdefault(each["name"], []).append(each["median"])
    return {name: max(of_name) / min(of_name) for name, of_name in medians.items()}


BASIS = 0.228
"""Share that one pose took, 163 of 715 ns, of CasADi's plain C, unfused, when targets were set."""

Value = Callable[[Figures, str], float]
"""How a share is made of a run's builds and peaks for one kind of instructions; KeyError where it isn't."""


@dataclass(frozen=True)
class Share:
    """One figure; ``bound`` and ``goal`` are the most that it is to be, or the ``least``."""

    name: str
    value: Value
    bound: float | None = None
    goal: float | None = None
    unit: str = "ratio"
    least: bool = False


def _time(found: Figures, name: str, kind: str) -> float:
    """Ns of the quickest build."""
    build = quickest(builds_of(found, name, kind))
    if build is None:
        raise KeyError(name)
    return float(build["median"])


def _basis(found: Figures, kind: str) -> float:
    """Ns of one pose as it was when targets were set, by CasADi's unfused C."""
    built = builds_of(found, PLAIN, kind)
    if not built:
        raise KeyError(PLAIN)
    return BASIS * float(min(built, key=lambda each: len(each["flags"]))["median"])


def _limit(found: Figures, kind: str) -> float:
    """Least ns per pose, each operation filling the place of a multiply-add in a lane."""
    (limit,) = (peak["limits"] for peak in found["peaks"] if peak["instructions"] == kind)
    return float(next(iter(limit.values())))


def _over(ours: str, theirs: str) -> Value:
    return lambda found, kind: _time(found, ours, kind) / _time(found, theirs, kind)


def _over_basis(ours: str) -> Value:
    return lambda found, kind: _time(found, ours, kind) / _basis(found, kind)


def _microseconds(name: str) -> Value:
    return lambda found, kind: 1e-3 * _time(found, name, kind)


_BASIS = f"over {BASIS:g} of CasADi's unfused C"
_SHARES = (
    Share("one pose, share of CasADi's closed form", _over(ONE_POSE, CLOSED), 0.23, 0.19),
    Share("one pose, share of CasADi's plain C", _over(ONE_POSE, PLAIN), 0.18, 0.15),
    Share("batch, share of CasADi's plain C", _over(BATCH, PLAIN), 0.08, 0.06),
    Share(
        "batch, share of the limit reached",
        lambda found, kind: _limit(found, kind) / _time(found, BATCH, kind),
        0.60,
        0.75,
        least=True,
    ),
    Share("batch, float, share of CasADi's plain C", _over(FLOAT, PLAIN), 0.045, 0.035),
    Share("equations, over inverse dynamics", _over(EQUATIONS, INVERSE)),
    Share("forward dynamics, over inverse dynamics", _over(FORWARD, INVERSE)),
    Share("derivatives, over inverse dynamics", _over(DERIVATIVES, INVERSE)),
    Share(f"equations, {_BASIS}", _over_basis(EQUATIONS), 1.6, 1.3),
    Share(f"forward dynamics, {_BASIS}", _over_basis(FORWARD), 1.2, 1),
    Share(f"derivatives, {_BASIS}", _over_basis(DERIVATIVES), 4, 3),
    Share("regressor 6 x 148, one pose", _microseconds(REGRESSOR), 1.5, 0.7, "us"),
    Share("regressor 6 x 148, batch", _microseconds(batched(REGRESSOR)), unit="us"),
)


def shares(found: Figures) -> list[Figures]:
    """Every figure that a run has the times of, by kind of instructions, with its bound and its goal."""
    made = []
    for share in _SHARES:
        values = {}
        for peak in found["peaks"]:
            with contextlib.suppress(KeyError):
                values[peak["instructions"]] = share.value(found, peak["instructions"])
        limits = {"at_least" if share.least else "at_most": share.bound, "goal": share.goal}
        stated = {name: limit for name, limit in limits.items() if limit is not None}
        if values:
            made.append({"name": share.name, "unit": share.unit, "values": values, **stated})
    return made
