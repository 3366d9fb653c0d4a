"""Families of poses that approach a degenerate configuration, with a curve for each method and a verdict."""

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
"""Rounding units relative to the condition number of the problem above which a result is wrong."""
GOOD = 1e6
"""Condition number below which a pose must have a result."""
POINTS = 49
"""Number of distances of a family."""


def distances() -> Array:
    """Return logarithmically spaced distances from 1 to 1e-16, shape (POINTS,)."""
    return np.logspace(0.0, -16.0, POINTS)


def exact(array: Array) -> NDArray[np.object_]:
    """Convert numbers to 50-digit arithmetic."""
    return np.asarray(np.vectorize(digits.mpf, otypes=[object])(array))


@dataclass(frozen=True, eq=False)
class Curve:
    """Results of one method along a family.

    Attributes
    ----------
    method : str
        Name of the method.
    error : ndarray, shape (n,)
        Error of its result, relative to the magnitude of the result; NaN for unsolvable poses.
    condition : ndarray, shape (n,)
        Condition number of the problem.
    status : ndarray of int or None, shape (n,)
        Codes of ``results.STATUS_TEXT``; None if the method has no status.
    shipped : bool
        True for code of the package, False for a candidate.
    epsilon : float
        Rounding unit of its arithmetic.
    pose : ndarray or None, shape (n,)
        Condition number of the poses, including the frames of the legs; None means ``condition``.
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
        """True if the method returns a result with status OK, shape (n,)."""
        given = np.isfinite(self.error)
        return given if self.status is None else np.asarray((self.status == OK) & given)

    @property
    def ratio(self) -> Array:
        """Error in rounding units relative to the condition number, shape (n,); NaN for unsolvable poses."""
        return np.where(self.answered, self.error / (self.epsilon * self.condition), np.nan)


@dataclass(frozen=True, eq=False)
class Family:
    """One-parameter family of poses with the curves of all methods.

    Attributes
    ----------
    name : str
        Stem of its file names.
    title : str
        Title of its plot.
    fails, remedy : str
        Failure and remedy, for the table of the documentation.
    axis : str
        Meaning of the distance.
    curves : tuple of Curve
        Results of the methods.
    distance : ndarray, shape (n,)
        Distances from the degenerate configuration.
    growth : mapping of str to ndarray, shape (n,)
        Further columns, drawn in a separate panel.
    growth_axis, growth_title, error_axis : str
        Labels of the plot.
    notes : tuple of str
        Lines of the report.
    beyond_range : bool
        True if the family exceeds the range of double, so that a status is valid for any pose.
    by_status : bool
        True if the statuses are the result of interest.
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
        """Return the columns (n,) of its CSV file."""
        found: dict[str, NDArray[Any]] = {"distance": self.distance, **self.growth}
        for curve in self.curves:
            name = curve.method.replace(",", "")
            found |= {f"{name}: error": curve.error, f"{name}: condition": curve.condition}
            if curve.status is not None:
                found[f"{name}: status"] = curve.status
        return found


def verdict(curve: Curve, distance: Array) -> Figures:
    """Evaluate a curve over the distances of its family.

    Returns
    -------
    dict
        ``worst`` is the largest error with status OK, in rounding units relative to the condition number, at
        distance ``where``. ``digits`` are the remaining decimal digits of the worst result with status OK.
        ``last`` is the smallest distance with a result. These are NaN without any result. ``rejected_at`` is
        the condition number of the first pose with a status, or None. ``undetected`` is the number of
        distances with a wrong result and status OK. ``false_alarms`` is the number of distances at which a
        good pose has a status.
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
