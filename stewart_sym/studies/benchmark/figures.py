"""What ``benchmark`` measured, as JSON takes it: samples with their medians, ratios, shares with targets."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ...dynamics.inverse_dynamics import Formulation
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

_LIMIT, _BASIS, _MICROSECOND = "limit", f"{BASIS:g} of CasADi's unfused C", "us"

_SHARES: tuple[tuple[str, str, str, dict[str, float]], ...] = (
    ("one pose, share of CasADi's closed form", ONE_POSE, CLOSED, {"at_most": 0.23, "goal": 0.19}),
    ("one pose, share of CasADi's plain C", ONE_POSE, PLAIN, {"at_most": 0.18, "goal": 0.15}),
    ("batch, share of CasADi's plain C", BATCH, PLAIN, {"at_most": 0.08, "goal": 0.06}),
    ("batch, share of the limit reached", _LIMIT, BATCH, {"at_least": 0.60, "goal": 0.75}),
    ("batch, float, share of CasADi's plain C", FLOAT, PLAIN, {"at_most": 0.045, "goal": 0.035}),
    ("equations, over inverse dynamics", EQUATIONS, INVERSE, {}),
    ("forward dynamics, over inverse dynamics", FORWARD, INVERSE, {}),
    ("derivatives, over inverse dynamics", DERIVATIVES, INVERSE, {}),
    (f"equations, over {_BASIS}", EQUATIONS, _BASIS, {"at_most": 1.6, "goal": 1.3}),
    (f"forward dynamics, over {_BASIS}", FORWARD, _BASIS, {"at_most": 1.2, "goal": 1}),
    (f"derivatives, over {_BASIS}", DERIVATIVES, _BASIS, {"at_most": 4, "goal": 3}),
    ("regressor 6 x 148, one pose", REGRESSOR, _MICROSECOND, {"at_most": 1.5, "goal": 0.7}),
    ("regressor 6 x 148, batch", batched(REGRESSOR), _MICROSECOND, {}),
)
"""Name, what is divided by what, as ``_times`` has them, and the most or the least that it is to be."""


def shares(found: Figures) -> list[Figures]:
    """Every figure that a run has the times of, by kind of instructions, with its bound and its goal."""
    times = {peak["instructions"]: _times(found, peak) for peak in found["peaks"]}
    made = []
    for name, over, under, stated in _SHARES:
        values = {kind: of[over] / of[under] for kind, of in times.items() if over in of and under in of}
        if values:
            unit = "us" if under == _MICROSECOND else "ratio"
            made.append({"name": name, "unit": unit, "values": values, **stated})
    return made


def _times(found: Figures, peak: Figures) -> dict[str, float]:
    """Ns by name for one kind of instructions: of the quickest builds, and of what they are compared with.

    That is the least of a batch, each operation filling the place of a multiply-add in a lane, and one pose
    as it was when targets were set, by CasADi's unfused C.
    """
    built = [each for each in found["builds"] if each["instructions"] == peak["instructions"]]
    times = {each["name"]: each["median"] for each in sorted(built, key=lambda each: -each["median"])}
    times |= {_LIMIT: next(iter(peak["limits"].values())), _MICROSECOND: 1e3}
    plain = sorted((len(each["flags"]), each["median"]) for each in built if each["name"] == PLAIN)
    if plain:
        times[_BASIS] = BASIS * plain[0][1]
    return times
