"""Results of ``benchmark`` for the JSON data: samples with medians, ratios, and shares with targets."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ...dynamics.inverse_dynamics import Formulation
from ..common.output import Figures
from ..common.timing import Task

NAME: Formulation = "exact"
"""Measured kernel."""

PLAIN, CLOSED = "CasADi", "CasADi, closed form"
"""Candidates by whose times other times are divided if CasADi is installed; the closed form is the stricter
reference.
"""

ONE_POSE, BATCH, FLOAT = "one pose", "batch, one core", "batch, float"
COLUMNS = "batch, columns"
"""Batch of arrays with a column for each component."""
INVERSE, EQUATIONS, FORWARD = "inverse dynamics", "equations", "forward dynamics"
DERIVATIVES, REGRESSOR = "derivatives", "regressor"

MOST = {FORWARD: (2.0,), DERIVATIVES: (8.0, 5.0)}
"""Targets: largest time of a function relative to inverse dynamics, and a more ambitious goal."""

TIMES_FASTER = 20.0
"""Target for the ratio of the time of the faster baseline to the time of forward dynamics."""


def batched(name: str) -> str:
    """Return the name of a one-pose function that is called for many poses."""
    return f"{name}, batch"


def sampled(**fields: Any) -> Figures:
    """Return the fields with median and quartiles of their samples ``raw``."""
    low, high = np.percentile(fields["raw"], (25, 75))
    return {**fields, "median": float(np.median(fields["raw"])), "quartiles": (float(low), float(high))}


def figure(
    name: str, what: str, kind: str, poses: int, raw: Sequence[float], operations: int | None = None
) -> Figures:
    """Return a record of the time per pose (ns) with one sample per round, and ``operations`` per pose if
    counted.
    """
    return sampled(name=name, what=what, kind=kind, poses=poses, raw=tuple(raw), operations=operations)


def build_of(instructions: str, flags: Sequence[str], bits: int | None) -> Figures:
    """Return the build of compiled C: instructions, and compiler flags after the common ones.

    ``bits`` is the width of the widest vectors of the code, if known.
    """
    width = "" if bits is None else f", {bits} bit" if bits > 64 else ", scalar"
    build = {"instructions": instructions, "flags": tuple(flags), "bits": bits}
    return {**build, "vectors": f"{instructions}{width}"}


Raw = Mapping[Any, tuple[float, ...]]
"""Times per unit (ns) by task, with one sample per round."""


@dataclass(frozen=True, eq=False)
class Timed(Task):
    """Timed task with the contents of its record: time per pose (ns), or per other unit.

    Attributes
    ----------
    kind : str
        "one pose", "batch", "call", or "loop".
    operations : int or None
        Operations per pose, if counted.
    build : dict
        Build of compiled C.
    """

    name: str
    what: str
    kind: str = "call"
    operations: int | None = None
    build: Figures = field(default_factory=dict)

    def figure(self, raw: Raw) -> Figures:
        """Return the record of the task."""
        poses = self.units if self.kind in ("one pose", "batch") else 1
        return figure(self.name, self.what, self.kind, poses, raw[self], self.operations) | self.build


def limits(operations: int, multiply_add: float) -> dict[str, float]:
    """Return the shortest times (ns) of a number of operations; divisions and roots count as one operation.

    ``multiply_add`` is the time of one fused multiply-add of one number (ns).
    """
    each = operations * multiply_add
    return {"limit, an operation a lane": each, "limit, all fused in pairs": each / 2}


def named(figures: Iterable[Figures], name: str) -> Figures | None:
    """Return the record with a name, or None."""
    return next((each for each in figures if each["name"] == name), None)


def quickest(figures: Iterable[Figures]) -> Figures | None:
    """Return the record with the smallest median, or None."""
    return min(figures, key=lambda each: float(each["median"]), default=None)


def builds_of(found: Figures, name: str, instructions: str) -> list[Figures]:
    """Return the builds of a run with this name for these instructions."""
    return [each for each in found["builds"] if (each["name"], each["instructions"]) == (name, instructions)]


def ratios(found: Figures, time: float, instructions: str = "") -> dict[str, float]:
    """Return the ratios of a time (ns) to the medians of CasADi's closed form and plain C; nothing without
    CasADi.

    ``instructions`` selects their build; empty selects the fastest build in the baselines.
    """
    of = {}
    for key, name in (("ratio_to_closed_form", CLOSED), ("ratio_to_casadi", PLAIN)):
        if instructions:
            of[key] = quickest(builds_of(found, name, instructions))
        else:
            of[key] = named(found["baselines"], name)
    return {key: time / each["median"] for key, each in of.items() if each is not None}


def with_ratios(found: Figures) -> Figures:
    """Add cycles of the clock and ratios to CasADi to the times of the forces and of all C code."""

    def entry(figure: Figures, instructions: str = "") -> Figures:
        time = figure["median"]
        return {**figure, "cycles": time / found["cycle"]["median"], **ratios(found, time, instructions)}

    return found | {
        "ours": [entry(each) for each in found["ours"]],
        "baselines": [entry(each) for each in found["baselines"]],
        "builds": [entry(each, each["instructions"]) for each in found["builds"]],
    }


def flatness(sweep: Sequence[Figures]) -> dict[str, float]:
    """Return, by name, the ratio of the longest to the shortest time per pose of all batch sizes."""
    medians: dict[str, list[float]] = {}
    for each in sweep:
        medians.setdefault(each["name"], []).append(each["median"])
    return {name: max(of_name) / min(of_name) for name, of_name in medians.items()}


BASIS = 0.228
"""Ratio of the time of one pose to CasADi's plain unfused C, 163 of 715 ns, on the day the targets were
set.
"""

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
"""Name, numerator, and denominator (keys of ``_times``) of each ratio, and its upper or lower bound."""


def shares(found: Figures) -> list[Figures]:
    """Return every ratio with measured times by kind of instructions, with its bound and its goal."""
    times = {peak["instructions"]: _times(found, peak) for peak in found["peaks"]}
    made = []
    for name, over, under, stated in _SHARES:
        values = {kind: of[over] / of[under] for kind, of in times.items() if over in of and under in of}
        if values:
            unit = "us" if under == _MICROSECOND else "ratio"
            made.append({"name": name, "unit": unit, "values": values, **stated})
    return made


def _times(found: Figures, peak: Figures) -> dict[str, float]:
    """Return times (ns) by name for one kind of instructions: the fastest builds and their references.

    One reference is the lower limit of a batch, with one multiply-add in a lane for each operation. The other
    is the time of one pose on the day the targets were set, relative to CasADi's unfused C.
    """
    built = [each for each in found["builds"] if each["instructions"] == peak["instructions"]]
    times = {each["name"]: each["median"] for each in sorted(built, key=lambda each: -each["median"])}
    times |= {_LIMIT: next(iter(peak["limits"].values())), _MICROSECOND: 1e3}
    plain = sorted((len(each["flags"]), each["median"]) for each in built if each["name"] == PLAIN)
    if plain:
        times[_BASIS] = BASIS * plain[0][1]
    return times
