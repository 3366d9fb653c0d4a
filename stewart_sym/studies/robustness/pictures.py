"""Plots of the study, one for each family, and the basins of forward kinematics; requires Matplotlib.

Colors are the colors of Okabe and Ito, which color-blind readers can distinguish. Every method also has its
own marker.
"""

import functools
from collections.abc import Sequence
from typing import Any

import numpy as np

from ...results import STATUS_TEXT
from ..common.drawing import Axes, Figure, legend_line, new_figure
from ..common.report import SMALL, Picture
from .family import WRONG, Curve, Family
from .poses import OUTCOMES, Basins

_COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8A8A00", "#7F7F7F")
_MARKS = ("o", "s", "^", "v", "D", "P", "X", "*", "p")
_FLOOR = 1e-17
_CEILING = 1e4


def pictures(families: Sequence[Family], starts: Basins) -> dict[str, Picture]:
    """Return every plot by name."""
    drawn = {family.name: functools.partial(family_figure, family) for family in families}
    drawn["basins"] = functools.partial(basins_figure, starts)
    return {name: Picture(draw, SMALL, dpi=130) for name, draw in drawn.items()}


def family_figure(family: Family) -> Figure:
    """Plot errors over the distance, for candidates and shipped code, and the growth of the problem
    itself.
    """
    groups = [
        (title, [curve for curve in family.curves if curve.shipped is shipped])
        for title, shipped in (("candidates", False), ("as shipped", True))
    ]
    groups = [(title, curves) for title, curves in groups if curves]
    if len(groups) == 2 and len(groups[0][1]) == 1:
        groups = [("", list(family.curves))]
    panels = len(groups) + bool(family.growth)
    figure = new_figure(2.2 + 4.0 * panels, 5.6)
    axes = np.atleast_1d(figure.subplots(1, panels))
    ceiling = _ceiling(family)
    for ax, (title, curves) in zip(axes, groups, strict=False):
        if family.by_status:
            _statuses(ax, family)
        else:
            _errors(ax, family, curves, ceiling)
        ax.set_title(title if len(groups) > 1 else "", fontsize=9.0)
    if family.growth:
        _growth(axes[-1], family)
    nothing = any((curve.error[curve.answered] < _FLOOR).any() for curve in family.curves)
    floor = f" (0 is drawn at {_FLOOR:.0e})" if nothing and not family.by_status else ""
    axes[0].set_ylabel(family.error_axis + floor)
    figure.suptitle(family.title, fontsize=10.5)
    return figure


def basins_figure(found: Basins) -> Figure:
    """Plot the outcome of each start pose, with a panel for each method."""
    figure = new_figure(10.0, 5.6)
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    panels = figure.subplots(1, len(found.outcome))
    colors = ListedColormap([_COLORS[0], _COLORS[4], "#000000"])
    edges = np.degrees([found.roll[0], found.roll[-1], found.yaw[0], found.yaw[-1]])
    for ax, (method, outcome) in zip(panels, found.outcome.items(), strict=True):
        ax.imshow(
            outcome, origin="lower", extent=tuple(edges), cmap=colors, vmin=0, vmax=2, interpolation="nearest"
        )
        ax.plot(0.0, 0.0, "+", color="white", markersize=11, markeredgewidth=2)
        ax.set_title(method, fontsize=9.0)
        ax.set_xlabel("start turned about x, degrees")
        ax.set_xticks(range(-180, 181, 90))
        ax.set_yticks(range(-180, 181, 90))
        ax.grid(False)
    panels[0].set_ylabel("start turned about z, degrees")
    keys: list[Any] = [Patch(color=colors(i), label=text) for i, text in enumerate(OUTCOMES)]
    pose: Any = {"linestyle": "", "marker": "P", "color": "white", "markeredgecolor": "black"}
    keys.append(legend_line("the pose itself", **pose))
    figure.legend(handles=keys, loc="outside lower center", ncols=len(keys))
    figure.suptitle("Forward kinematics: where Newton's steps end, by where they start", fontsize=10.5)
    return figure


def _errors(ax: Axes, family: Family, curves: list[Curve], ceiling: float) -> None:
    for number, curve in enumerate(curves):
        style = {"color": _COLORS[number % len(_COLORS)], "marker": _MARKS[number % len(_MARKS)]}
        # The markers of the curves are offset, so that overlapping curves are distinguishable.
        every = (number % 4, 4) if len(family.distance) > 20 else 1
        shown = np.where(curve.answered, np.clip(curve.error, _FLOOR, ceiling), np.nan)
        ax.loglog(
            family.distance,
            shown,
            linewidth=1.1,
            markersize=4.0,
            markevery=every,
            label=curve.method,
            **style,
        )
        rejected = np.zeros_like(curve.answered) if curve.status is None else curve.status != 0
        if rejected.any():
            height = np.full(int(rejected.sum()), 0.03 + 0.025 * number)
            ax.plot(
                family.distance[rejected],
                height,
                linestyle="",
                marker="|",
                markersize=5.0,
                color=style["color"],
                transform=ax.get_xaxis_transform(),
            )
    limits = [np.where(bound < ceiling, bound, np.nan) for bound in _limits(curves)]
    for shown in limits:
        ax.loglog(family.distance, shown, color="#555555", linestyle="--", linewidth=1.2)
    # The lowest part of the panel is reserved for the statuses.
    ax.set_ylim(_FLOOR / 100.0, 3.0 * ceiling)
    # These lines have no points and appear only in the legend.
    if np.isfinite(limits).any():
        ax.plot([], [], color="#555555", linestyle="--", label=f"{WRONG:g} units x condition")
    if any(curve.status is not None and (curve.status != 0).any() for curve in curves):
        ax.plot([], [], color="#555555", linestyle="", marker="|", label="rejected, by its status")
    _finish(ax, family)


def _finish(ax: Axes, family: Family, columns: int = 2) -> None:
    """Set an axis of distances that decrease to the right, and a legend below."""
    ax.set_xlim(float(family.distance.max()), float(family.distance.min()))
    ax.set_xlabel(family.axis)
    ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=columns, fontsize=8.0)


def _limits(curves: list[Curve]) -> list[Any]:
    """Return the error limit of each curve, without duplicates."""
    found: list[Any] = []
    for curve in curves:
        with np.errstate(all="ignore"):
            bound = WRONG * curve.epsilon * curve.condition
        if not any(np.allclose(bound, other, rtol=0.5, equal_nan=True) for other in found):
            found.append(bound)
    return found


def _statuses(ax: Axes, family: Family) -> None:
    codes = sorted(
        {int(code) for curve in family.curves if curve.status is not None for code in curve.status}
    )
    for number, curve in enumerate(family.curves):
        if curve.status is not None:
            # Markers are offset, so that equal values are distinguishable.
            height = [codes.index(int(code)) + 0.08 * number for code in curve.status]
            style = {"color": _COLORS[number], "marker": _MARKS[number]}
            ax.semilogx(family.distance, height, linestyle="", markersize=4.0, label=curve.method, **style)
    ax.set_yticks(
        range(len(codes)), [f"{code}: {STATUS_TEXT[code]}" for code in codes], wrap=True, fontsize=8.0
    )
    ax.set_ylim(-0.5, len(codes) - 0.2)
    _finish(ax, family)


def _growth(ax: Axes, family: Family) -> None:
    for number, (name, values) in enumerate(family.growth.items()):
        ax.loglog(
            family.distance,
            np.where(values < 1e60, values, np.nan),
            linewidth=1.2,
            color=_COLORS[number % len(_COLORS)],
            linestyle=("-", "--", "-.", ":")[number % 4],
            label=name,
        )
    ax.set_ylabel(family.growth_axis)
    ax.set_title(family.growth_title, fontsize=9.0)
    _finish(ax, family, columns=1)


def _ceiling(family: Family) -> float:
    largest = max(
        (float(np.nanmax(curve.error[curve.answered])) for curve in family.curves if curve.answered.any()),
        default=1.0,
    )
    return float(np.clip(3.0 * largest, 1e-8, _CEILING))
