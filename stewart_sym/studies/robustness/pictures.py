"""Plots of the study, one for each family; requires Matplotlib.

Colors are the colors of Okabe and Ito, which color-blind readers can distinguish. Every kernel also has its
own marker.
"""

import functools
from collections.abc import Sequence

import numpy as np

from ...results import OK
from ..common.drawing import Figure, legend_below, new_figure
from ..common.report import SMALL, Picture
from .oracle import EPSILON
from .study import WRONG, Course

_COLORS, _MARKERS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"), "os^vDP"
_FLOOR, _CEILING = 1e-17, 1e4


def pictures(courses: Sequence[Course]) -> dict[str, Picture]:
    """Return every plot by name."""
    return {
        course.family.name: Picture(functools.partial(figure_of, course), SMALL, dpi=130)
        for course in courses
    }


def figure_of(course: Course) -> Figure:
    """Plot the errors of all kernels over the distance, with marks at the distances with a status."""
    figure = new_figure(7.0, 5.6)
    ax = figure.subplots()
    curves = zip(course.verdicts.items(), _COLORS, _MARKERS, strict=True)
    for number, ((name, found), color, marker) in enumerate(curves):
        error = np.clip(found.error * EPSILON["double"], _FLOOR, _CEILING)
        # The markers of the curves are offset, so that overlapping curves are distinguishable.
        style = {"color": color, "marker": marker, "markersize": 4.0, "markevery": (number % 4, 4)}
        ax.loglog(course.distance, error, linewidth=1.1, label=name, **style)
        limit = WRONG * EPSILON["double"] * found.condition
        label = "" if number else f"{WRONG:g} units x condition"
        shown = np.where(limit < _CEILING, limit, np.nan)
        ax.loglog(course.distance, shown, color="#555555", linestyle="--", linewidth=0.8, label=label)
        rejected = course.distance[found.status != OK]
        height = np.full(len(rejected), 0.03 + 0.025 * number)
        axis = ax.get_xaxis_transform()
        label = "" if number else "rejected, by its status"
        ax.plot(rejected, height, "|", markersize=5.0, color=color, transform=axis, label=label)
    # The lowest part of the panel is reserved for the statuses.
    ax.set_ylim(_FLOOR / 100.0, 3.0 * _CEILING)
    ax.set_xlim(float(course.distance.max()), float(course.distance.min()))
    ax.set_xlabel(course.family.axis)
    ax.set_ylabel(f"error over the size of the output (0 is drawn at {_FLOOR:.0e})")
    figure.suptitle(course.family.title, fontsize=10.5)
    legend_below(figure)
    return figure
