"""Times of candidates with all their samples, as JSON takes them, and the names that they go by."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from ...dynamics.inverse import Formulation
from ..common.output import Figures

NAME: Formulation = "exact"
"""The kernel that is measured."""

PLAIN, CLOSED = "CasADi", "CasADi, closed form"
"""Other times are divided by these, where CasADi is installed; the closed form is the stricter measure."""

ONE_POSE, BATCH, FLOAT = "one pose", "batch, one core", "batch, float"
COLUMNS = "batch, columns"
"""A batch of arrays with a column for each component."""
INVERSE, EQUATIONS, FORWARD = "inverse dynamics", "equations", "forward dynamics"
DERIVATIVES, REGRESSOR = "derivatives", "regressor"


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


def of_c(found: Figures, instructions: str, flags: Sequence[str], bits: int | None) -> Figures:
    """A figure of compiled C, with its instructions and the compiler's flags after those of every library.

    bits: width of the widest vectors that the code computes with, where that is known.
    """
    width = "" if bits is None else f", {bits} bit" if bits > 64 else ", scalar"
    build = {"instructions": instructions, "flags": tuple(flags), "bits": bits}
    return {**found, **build, "vectors": f"{instructions}{width}"}


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
