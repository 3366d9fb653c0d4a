"""Families of poses that approach a degenerate configuration: a curve for each method, a verdict."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...io.array_types import Array, Codes, Flags
from ...precision.truth import digits
from ...results import OK
from ..common.output import Figures

EPS = float(np.finfo(np.float64).eps)
WRONG = 1000.0
"""Rounding units over the problem's own condition number above which an answer is wrong."""
GOOD = 1e6
"""Condition number below which a pose must get an answer."""
POINTS = 49
"""How many distances a family has."""


def distances() -> Array:
    """From 1 to 1e-16, even in their logarithm, (POINTS,)."""
    return np.logspace(0.0, -16.0, POINTS)


def exact(array: Array) -> NDArray[np.object_]:
    """The same numbers with 50 digits."""
    return np.asarray(np.vectorize(digits.mpf, otypes=[object])(array))


@dataclass(frozen=True, eq=False)
class Curve:
    """One method along a family.

    error: of its answer, over the size of what it computes, (n,), NaN for unsolvable poses.
    condition: the condition number of the problem that it solves, (n,).
    status: (n,), codes of ``results.STATUS_TEXT``; None where a method has none to give.
    pose: condition number of the poses, (n,), that of a leg's frame included; None: the same.
    shipped: whether users meet it; else it is a candidate.
    epsilon: rounding unit of its arithmetic.
    """

    method: str
    error: Array
    condition: Array
    status: Codes | None = None
    shipped: bool = False
    epsilon: float = EPS
    pose: Array | None = None

    @property
    def answered(self) -> Flags:
        """Where it gives an answer and says that it is one, (n,)."""
        given = np.isfinite(self.error)
        return given if self.status is None else np.asarray((self.status == OK) & given)

    @property
    def ratio(self) -> Array:
        """Error in rounding units over the condition number, (n,), NaN for unsolvable poses."""
        return np.where(self.answered, self.error / (self.epsilon * self.condition), np.nan)


@dataclass(frozen=True, eq=False)
class Family:
    """A one-parameter family with every method's curve.

    name: of its files. fails, remedy: what fails and what we do about it, for the README's table.
    axis: what the distance is. growth: further columns (n,), by name, drawn beside. notes: lines for the
    report. beyond_range: whether it leaves the range of double, where a status is right however good the
    pose. by_status: whether its statuses are what there is to see.
    """

    name: str
    title: str
    fails: str
    remedy: str
    axis: str
    curves: tuple[Curve, ...]
    distance: Array = field(default_factory=distances)
    growth: Mapping[str, Array] = field(default_factory=dict)
    growth_axis: str = ""
    notes: tuple[str, ...] = ()
    error_axis: str = "error over the largest force"
    beyond_range: bool = False
    by_status: bool = False
    growth_title: str = "the problem itself"

    def columns(self) -> dict[str, NDArray[Any]]:
        """Columns (n,) of its CSV."""
        found: dict[str, NDArray[Any]] = {"distance": self.distance, **self.growth}
        for curve in self.curves:
            name = curve.method.replace(",", "")
            found |= {f"{name}: error": curve.error, f"{name}: condition": curve.condition}
            if curve.status is not None:
                found[f"{name}: status"] = curve.status
        return found


def verdict(curve: Curve, distance: Array) -> Figures:
    """Weigh a curve over its family's distances.

    worst: largest error in rounding units over the condition number with status ok, at distance ``where``.
    digits: decimal digits left at the worst answer with status ok. last: nearest distance with an answer; NaN
    all of them if there is none. rejected_at: condition number of the first pose with a status, None if there
    is none. undetected: distances at which an answer is wrong and no status says so. false_alarms: distances
    at which a good pose has a status.
    """
    ratio, answered = curve.ratio, curve.answered
    of_pose = curve.condition if curve.pose is None else np.maximum(curve.condition, curve.pose)
    rejected = np.zeros(len(distance), dtype=np.bool_) if curve.status is None else curve.status != OK
    found: Figures = dict.fromkeys(("worst", "where", "digits", "last"), float("nan"))
    if answered.any():
        worst, largest = int(np.nanargmax(ratio)), float(np.max(curve.error[answered]))
        found = {
            "worst": float(ratio[worst]),
            "where": float(distance[worst]),
            "digits": max(0.0, float(-np.log10(max(largest, curve.epsilon / 2.0)))),
            "last": float(distance[answered].min()),
        }
    return found | {
        "rejected_at": float(of_pose[rejected].min()) if rejected.any() else None,
        "undetected": int(np.sum(answered & (ratio > WRONG))),
        "false_alarms": int(np.sum(rejected & (of_pose < GOOD))),
    }
