"""Pictures of the study of plans: rank correlations, peaks, and Path III before and after."""

from typing import Any

import numpy as np

from ...io.extras import needed_for
from ..common.drawing import legend_below, log_numbers
from ..common.report import SMALL, Picture

with needed_for("drawing"):
    from matplotlib.figure import Figure

_COLORS = {"slow": "#1f4e9c", "fast": "#c1440e", "straight": "#8a8a8a", "planned": "#1f4e9c"}


def pictures(found: dict[str, Any]) -> dict[str, Picture]:
    """``plan_claim`` and ``plan_path_III``."""
    return {
        "plan_claim": Picture(lambda: claim_figure(found["claim"]), SMALL),
        "plan_path_III": Picture(lambda: path_figure(found["path_III"]), SMALL),
    }


def claim_figure(claim: dict[str, Any]) -> Figure:
    """Left: rank correlations along each path. Right: peak force over peak condition number of each path."""
    figure = Figure(figsize=(9.0, 4.2), layout="constrained")
    left, right = figure.subplots(1, 2)
    bins = np.linspace(-1.0, 1.0, 41)
    for name, values in claim["correlation"].items():
        left.hist(values, bins, histtype="step", color=_COLORS[name], linewidth=1.4, label=f"{name} motion")
        peaks = claim["peak_force_over_weight"][name]
        right.loglog(claim["peak_condition"], peaks, ".", color=_COLORS[name], markersize=2.5)
    left.axvline(0.0, color="#3a3a3a", linewidth=0.7)
    left.set_xlim(-1.0, 1.0)
    left.set_xlabel("rank correlation of condition number\nand largest force along a path")
    left.set_ylabel(f"paths of {claim['paths']}")
    right.set_xlabel("peak of the scaled condition number")
    right.set_ylabel("peak force over weight")
    for axis in (right.xaxis, right.yaxis):
        log_numbers(axis)
    legend_below(figure)
    return figure


def path_figure(found: dict[str, Any]) -> Figure:
    """Condition number and largest force along Path III, straight and planned."""
    figure = Figure(figsize=(9.0, 4.0), layout="constrained")
    for axes, what, label in zip(
        figure.subplots(1, 2),
        ("condition", "force_N"),
        ("scaled condition number of H", "largest leg force, N"),
        strict=True,
    ):
        for name, values in found[what].items():
            time = np.linspace(0.0, 6.0, len(values))
            axes.semilogy(time, values, color=_COLORS[name], linewidth=1.4, label=name)
        axes.set_xlabel("time, s")
        axes.set_ylabel(label)
        axes.set_xlim(0.0, 6.0)
        log_numbers(axes.yaxis)
    legend_below(figure)
    return figure
